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
