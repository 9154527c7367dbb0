//! Declared orientations in space, which choose the assembly.

use crate::{accepted, start};

/// A slider-crank of which only the rod is declared, in either of its two assemblies: sin β = −r/l sin φ. Where a drive turns the crank, the rod is
/// turned against ground as declared, however the joint counts its angle.
#[test]
fn a_body_beside_a_driven_one_starts_as_it_is_declared_against_ground() {
    for turn in (0..12).map(|step| 15.0 + 30.0 * f64::from(step)) {
        for (joint, sign) in
            [("ground.position, ground.z, crank.position, crank.z", 1.0), ("crank.position, crank.z, ground.position, ground.z", -1.0)]
        {
            let phi = f64::to_radians(turn);
            let reached = (-0.1 / 0.15 * phi.sin()).asin();
            for rod in [reached, std::f64::consts::PI - reached] {
                let source = format!(
                    "mechanism Slider in space {{
                        ground {{ axis z = (0, 0, 1) from (1, 0, 0); axis x = (1, 0, 0) from (0, 1, 0); }}
                        body crank {{ axis z = (0, 0, 1) from (1, 0, 0); point E = (100mm, 0mm, 0mm); }}
                        body rod {{ axis z = (0, 0, 1) from (1, 0, 0); point E = (150mm, 0mm, 0mm); start orientation = turn((0, 0, 1), {}deg); }}
                        body slide {{ axis x = (1, 0, 0) from (0, 1, 0); }}
                        joint o = revolute({joint});
                        joint a = cylindrical(crank.E, crank.z, rod.position, rod.z);
                        joint b = spherical(rod.E, slide.position);
                        joint g = translational(ground.position, ground.x, slide.position, slide.x);
                        drive i = drive_rotation(o, {}deg + 1rad_s * t); }}",
                    rod.to_degrees() + 6.0,
                    sign * turn
                );
                let compiled = accepted(&source);
                let (found, right) = (start(&compiled, "slide.x"), 0.1 * phi.cos() + 0.15 * rod.cos());
                assert!((found - right).abs() < 1e-12, "crank at {turn}°, rod at {}°: {found}, not {right}", rod.to_degrees());
                assert!(compiled.assembly.warnings.is_empty(), "{:?}", compiled.assembly.warnings);
            }
        }
    }
}

/// A four-bar in a tilted plane whose last hinge is redundant: its axes are parallel by the others, up to rounding, which depends on the plane. The
/// assembly is the one that is declared. With the crank along the ground of 400 mm, 300 mm are left of it, on which rocker and coupler stand.
#[test]
fn a_redundant_hinge_does_not_choose_the_assembly() {
    let rocker = 180.0 - f64::acos((300.0 - 350.0 * (350.0 / 600.0)) / 300.0).to_degrees();
    for (plane, tilt) in (0..48).map(|k| (10.0 * f64::from(k % 12) + 95.0, 15.0 + 20.0 * f64::from(k / 12))) {
        let turned = format!("turn((0, 0, 1), {plane}deg) * turn((1, 0, 0), {tilt}deg)");
        let source = format!(
            "mechanism Tilted in space {{
                let p = {plane}deg;  let q = {tilt}deg;
                ground {{
                    axis z = (sin(p) * sin(q), -cos(p) * sin(q), cos(q)) from (cos(p), sin(p), 0);
                    point C = (400mm * cos(p), 400mm * sin(p), 0mm);
                }}
                body crank {{ axis z = (0, 0, 1) from (1, 0, 0); point E = (100mm, 0mm, 0mm); start orientation = {turned}; }}
                body coupler {{
                    axis z = (0, 0, 1) from (1, 0, 0); point E = (350mm, 0mm, 0mm); start orientation = {turned} * turn((0, 0, 1), 50deg);
                }}
                body rocker {{
                    axis z = (0, 0, 1) from (1, 0, 0); point E = (300mm, 0mm, 0mm); start orientation = {turned} * turn((0, 0, 1), 100deg);
                }}
                joint o = revolute(ground.position, ground.z, crank.position, crank.z);
                joint a = revolute(crank.E, crank.z, coupler.position, coupler.z);
                joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
                redundant joint b = revolute(coupler.E, coupler.z, rocker.E, rocker.z);
                drive i = drive_rotation(o, 1rad_s * t); }}"
        );
        let compiled = accepted(&source);
        let found = start(&compiled, "rocker.angle").to_degrees();
        assert!((found - rocker).abs() < 1e-9, "plane at {plane}°, tilted by {tilt}°: {found}, not {rocker}");
        assert!(compiled.assembly.warnings.is_empty(), "{:?}", compiled.assembly.warnings);
    }
}

/// An arm of 250 mm in a plane that is turned anyhow, and a rod of 350 mm to a pin at (400 mm, −200 mm) of this plane. Nothing is declared, so that
/// the hinge is as near to 0 as it can be wherever its axis points: tip · pin = (250² + 400² + 200² − 350²)/2 mm².
#[test]
fn a_hinge_without_a_start_begins_near_its_zero_wherever_its_axis_points() {
    let (pin, product) = (400f64.hypot(200.0), (250f64.powi(2) + 400f64.powi(2) + 200f64.powi(2) - 350f64.powi(2)) / 2.0);
    // The arm turns about y: at an angle its tip is 250 mm (cos, −sin) in the plane.
    let right = f64::atan2(200.0, 400.0) - (product / (250.0 * pin)).acos();
    for turn in 0..48 {
        let angles = [7.0, 31.0, 53.0].map(|step: f64| step * f64::from(turn));
        let [a, b, c] = angles;
        for (joint, sign) in
            [("ground.position, ground.a, arm.position, arm.a", 1.0), ("arm.position, arm.a, ground.position, ground.a", -1.0)]
        {
            // Columns of a turn by a about z, b about x and c about z.
            let source = format!(
                "mechanism Arm in space {{
                    let a = {a}deg;  let b = {b}deg;  let c = {c}deg;
                    let x1 = cos(a) * cos(c) - sin(a) * cos(b) * sin(c);  let x2 = sin(a) * cos(c) + cos(a) * cos(b) * sin(c);
                    let x3 = sin(b) * sin(c);
                    let y1 = -cos(a) * sin(c) - sin(a) * cos(b) * cos(c);  let y2 = -sin(a) * sin(c) + cos(a) * cos(b) * cos(c);
                    let y3 = sin(b) * cos(c);
                    let z1 = sin(a) * sin(b);  let z2 = -cos(a) * sin(b);  let z3 = cos(b);
                    ground {{ axis a = (y1, y2, y3) from (x1, x2, x3); }}
                    body arm {{ axis a = (0, 1, 0) from (1, 0, 0); point tip = (250mm, 0mm, 0mm); }}
                    body bob {{ axis z = (0, 0, 1); }}
                    joint hip = revolute({joint});
                    joint rod = distance(arm.tip, bob.position, 350mm);
                    joint level = absolute_orientation((0, 0, 1), bob.z);
                    drive x = drive_x(bob.position, 400mm * x1 - 200mm * z1);
                    drive y = drive_y(bob.position, 400mm * x2 - 200mm * z2);
                    drive z = drive_z(bob.position, 400mm * x3 - 200mm * z3 + 1mm_s * t); }}"
            );
            let found = sign * start(&accepted(&source), "arm.angle");
            assert!((found - right).abs() < 1e-9, "turned by {angles:?}, {joint}: {found}, not {right}");
        }
    }
}

/// Two links, the first without a start: the second is turned against ground as declared, wherever the first is.
#[test]
fn a_declared_orientation_counts_against_ground_beside_a_body_without_a_start() {
    for (first, second) in [(100.0, -50.0), (100.0, 50.0), (-140.0, 20.0), (70.0, 160.0)] {
        for (joint, sign) in [("a.E, a.z, b.position, b.z", 1.0), ("b.position, b.z, a.E, a.z", -1.0)] {
            let source = format!(
                "mechanism Links in space {{
                    ground {{ axis z = (0, 0, 1); axis x = (1, 0, 0); axis y = (0, 1, 0); }}
                    body a {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); }}
                    body b {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); start orientation = turn((0, 0, 1), {second}deg); }}
                    joint ja = revolute(ground.position, ground.z, a.position, a.z);
                    joint jb = revolute({joint});
                    joint pa = point_on_plane(ground.position, ground.y, a.E, 1m * sin({first}deg));
                    joint pb = point_on_plane(ground.position, ground.x, b.E, 1m * (cos({first}deg) + cos({second}deg))); }}"
            );
            let compiled = accepted(&source);
            let whole = start(&compiled, "a.angle") + sign * start(&compiled, "b.angle");
            let off = (whole.to_degrees() - second) / 360.0;
            assert!((off - off.round()).abs() < 1e-12, "{first}°, {second}°, {joint}: {}°", whole.to_degrees());
            assert!(compiled.assembly.warnings.is_empty(), "{:?}", compiled.assembly.warnings);
        }
    }
}

/// Three links, the first without a start and the second with the angle of its joint: the third is turned against ground as declared.
#[test]
fn a_declared_orientation_counts_against_ground_behind_a_declared_angle() {
    for third in [-50.0, 50.0] {
        let source = format!(
            "mechanism Links in space {{
                ground {{ axis z = (0, 0, 1); axis x = (1, 0, 0); axis y = (0, 1, 0); }}
                body a {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); }}
                body b {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); }}
                body c {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); start orientation = turn((0, 0, 1), {third}deg); }}
                joint ja = revolute(ground.position, ground.z, a.position, a.z);
                joint jb = revolute(a.E, a.z, b.position, b.z);
                joint jc = revolute(b.E, b.z, c.position, c.z);
                start jb.angle = 30deg;
                joint pa = point_on_plane(ground.position, ground.y, a.E, 1m * sin(100deg));
                drive turn = drive_rotation(jb, 30deg + 1rad_s * t);
                joint pc = point_on_plane(ground.position, ground.x, c.E, 1m * (cos(100deg) + cos(130deg) + cos({third}deg))); }}"
        );
        let compiled = accepted(&source);
        let [first, second, last] = ["a.angle", "b.angle", "c.angle"].map(|name| start(&compiled, name).to_degrees());
        let off = (first + second + last - third) / 360.0;
        assert!((off - off.round()).abs() < 1e-12, "{third}°: {first}° + {second}° + {last}°");
    }
}

/// A link on a slider that keeps the declared orientation of its guide: of its two directions the declared one is taken.
#[test]
fn a_declared_orientation_counts_against_ground_beside_a_slider_on_a_turned_guide() {
    for link in [-50.0, 50.0] {
        let source = format!(
            "mechanism Guided in space {{
                ground {{ axis z = (0, 0, 1); axis x = (1, 0, 0); }}
                body guide {{ axis z = (0, 0, 1); axis x = (1, 0, 0); start orientation = turn((0, 0, 1), 100deg); }}
                body slider {{ axis z = (0, 0, 1); axis x = (1, 0, 0); }}
                body link {{ axis z = (0, 0, 1); point E = (1m, 0m, 0m); start orientation = turn((0, 0, 1), {link}deg); }}
                joint a = revolute(ground.position, ground.z, guide.position, guide.z);
                joint s = translational(guide.position, guide.x, slider.position, slider.x);
                joint b = revolute(slider.position, slider.z, link.position, link.z);
                drive turn = drive_rotation(a, 100deg + 1rad_s * t);
                drive out = drive_translation(s, 500mm);
                joint at = point_on_plane(ground.position, ground.x, link.E, 500mm * cos(100deg) + 1m * cos({link}deg)); }}"
        );
        let compiled = accepted(&source);
        let [guide, own] = ["guide.angle", "link.angle"].map(|name| start(&compiled, name).to_degrees());
        let off = (guide + own - link) / 360.0;
        assert!((off - off.round()).abs() < 1e-12, "{link}°: {guide}° + {own}°");
        assert!(compiled.assembly.warnings.is_empty(), "{:?}", compiled.assembly.warnings);
    }
}

/// Of the two assemblies of a rod between a ball on a slide and a cross the help names one that is accepted as it is written.
#[test]
fn the_start_that_the_help_names_is_one_of_space() {
    let source = |start: &str| {
        format!(
            "mechanism Rod in space {{
                ground {{ axis z = (0, 0, 1) from (1, 0, 0); axis s = (1, 0, 0) from (0, 1, 0); point G = (0mm, 100mm, -150mm); }}
                body rod {{ axis b = (0, 0, 1) from (1, 0, 0); point tip = (320mm, 0mm, 0mm); }}
                body bob {{ axis s = (1, 0, 0) from (0, 1, 0); {start} }}
                joint hip = universal(ground.position, ground.z, rod.position, rod.b);
                joint ball = spherical(rod.tip, bob.position);
                joint slide = translational(ground.G, ground.s, bob.position, bob.s); }}"
        )
    };
    let refused = crate::refused(&source("")).to_string();
    assert!(refused.contains("start slide.displacement = 264.4mm;"), "{refused}");
    let declared = source("").replace("joint slide", "start slide.displacement = 264.4mm; joint slide");
    assert!(
        (start(&accepted(&declared), "bob.displacement") - f64::sqrt(0.32f64.powi(2) - 0.1f64.powi(2) - 0.15f64.powi(2))).abs() < 1e-12
    );
}

/// Slider-cranks in planes of any direction, whose slide is redundant and has references at any angle about its axis. The cosine of one reference and the
/// other axis touches zero along the whole motion, and has derivatives of nothing but rounding there.
#[test]
fn a_redundant_slide_lies_in_any_direction() {
    let cross = |[a, b, c]: [f64; 3], [p, q, r]: [f64; 3]| [b * r - c * q, c * p - a * r, a * q - b * p];
    let written = |v: [f64; 3], unit: &str| format!("({:?}{unit}, {:?}{unit}, {:?}{unit})", v[0], v[1], v[2]);
    let mut random = crate::Random(7);
    for law in ["0.3rad * sin(2rad_s * t)", "0.2rad_s * t"].into_iter().cycle().take(24) {
        let mut vector = || [0; 3].map(|_| random.between(-1.0, 1.0));
        let n = vector();
        let (x, from) = (cross(n, vector()), vector());
        let y = cross(n, x);
        let [long, high] = [x, y].map(|v| 0.1 / v.iter().map(|part| part * part).sum::<f64>().sqrt());
        let at = |a: f64, b: f64| [0, 1, 2].map(|k| a * long * x[k] + b * high * y[k]);
        let (knee, end, u) = (at(0.4, 0.3), at(1.7, -0.2), at(1.0, 0.3));
        let rod = [0, 1, 2].map(|k| end[k] - knee[k]);
        let along = format!("axis n = {}; axis u = {} from {};", written(n, ""), written(u, ""), written(from, ""));
        let source = format!(
            "mechanism Slider in space {{
                ground {{ {along} point C = {end}; }}
                body crank {{ {along} point A = {knee}; }}
                body rod {{ {along} point B = {rod}; start position = {knee}; }}
                body slider {{ {along} start position = {end}; }}
                joint o = revolute(ground.position, ground.n, crank.position, crank.n);
                joint a = revolute(crank.A, crank.n, rod.position, rod.n);
                joint b = revolute(rod.B, rod.n, slider.position, slider.n);
                redundant joint g = translational(ground.C, ground.u, slider.position, slider.u);
                drive d = drive_rotation(o, {law}); }}",
            end = written(end, "m"),
            knee = written(knee, "m"),
            rod = written(rod, "m")
        );
        for axis in ["x", "y", "z"] {
            let (found, right) =
                (start(&accepted(&source), &format!("slider.{axis}")), end[["x", "y", "z"].iter().position(|k| *k == axis).unwrap()]);
            assert!((found - right).abs() < 1e-12, "{source}: {found}, not {right}");
        }
    }
}

/// A link of 100 mm holds a slide that the crank turns: 96 mm + 200 mm sin φ above the pivot of the link. Beyond sin φ = 0.02 it does not reach, and
/// the redundant pivot fits all the same.
#[test]
fn a_redundant_joint_fits_although_the_travel_soon_ends() {
    let source = "mechanism Held in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); point D = (200mm, 0mm, 0mm); }
        body crank { axis z = (0, 0, 1) from (1, 0, 0); axis x = (1, 0, 0) from (0, 1, 0); point G = (0mm, 96mm, 0mm); }
        body slide { axis z = (0, 0, 1) from (1, 0, 0); axis x = (1, 0, 0) from (0, 1, 0); start position = (172mm, 96mm, 0mm); }
        body link { axis z = (0, 0, 1) from (1, 0, 0); point C = (-28mm, 96mm, 0mm); start position = (200mm, 0mm, 0mm); }
        joint o = revolute(ground.position, ground.z, crank.position, crank.z);
        joint g = translational(crank.G, crank.x, slide.position, slide.x);
        joint c = revolute(slide.position, slide.z, link.C, link.z);
        redundant joint d = revolute(ground.D, ground.z, link.position, link.z);
        drive motor = drive_rotation(o, 0.2rad_s * t); }";
    assert!((start(&accepted(source), "slide.x") - 0.172).abs() < 1e-12);
}
