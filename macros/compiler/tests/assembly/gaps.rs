//! The smallest gap of the named joint, compared with the triangle inequality.

use crate::{Random, accepted, four_bar, refused, samples};
use reuleaux_compiler::diag::{AssemblyFact, Fact};

/// Gap of a joint in mm and degrees, and the shortfall of the bound.
fn gap(source: &str, name: &str) -> (f64, f64, Option<f64>) {
    match refused(source) {
        Fact::Assembly(AssemblyFact::StaysOpen { joint, gap, bound, .. }) => {
            assert_eq!(joint, name, "{source}");
            let missing = bound.map(|bound| (bound.span.1 - bound.ways.iter().map(|way| way.1).sum::<f64>()) * 1e3);
            (gap.length * 1e3, gap.angle.to_degrees(), missing)
        }
        other => panic!("{other}\nin {source}"),
    }
}

fn assert_near(found: f64, wanted: f64, source: &str) {
    assert!((found - wanted).abs() <= 1e-6 * wanted.abs(), "{found} for {wanted} in\n{source}");
}

#[test]
fn four_bars_close_if_and_only_if_a_triangle_does() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut open, mut closed) = (0, 0);
    for _ in 0..samples(25, 80) {
        let lengths = [0; 4].map(|_| random.between(40.0, 400.0));
        let [ground, crank, coupler, rocker] = lengths;
        let angle = random.between(-180.0, 180.0);
        let tip = [crank * angle.to_radians().cos(), crank * angle.to_radians().sin()];
        let distance = (ground - tip[0]).hypot(tip[1]);
        let wanted = (distance - coupler - rocker).max((coupler - rocker).abs() - distance);
        let source = format!("#[closure(start)] {}", four_bar(lengths, angle, "start angle = 100deg;"));
        if wanted.abs() < 1e-3 {
            continue;
        }
        if wanted < 0.0 {
            closed += 1;
            accepted(&source);
            continue;
        }
        open += 1;
        let (length, angle, missing) = gap(&source, "c");
        assert_near(length, wanted, &source);
        assert_eq!(angle, 0.0, "{source}");
        // If no crank angle helps, the bound concerns the whole quadrilateral.
        let longest = lengths.iter().fold(0.0_f64, |longest, length| longest.max(*length));
        let always = 2.0 * longest - lengths.iter().sum::<f64>();
        assert_near(missing.expect("a loop of revolutes has a bound"), if always > 1e-6 { always } else { wanted }, &source);
    }
    let least = samples(5, 20);
    assert!(open > least && closed > least, "{open} open, {closed} closed");
}

#[test]
fn slider_cranks_close_if_and_only_if_the_rod_reaches_the_line() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for _ in 0..samples(15, 40) {
        let [crank, rod, height, angle] = [(20.0, 100.0), (20.0, 200.0), (0.0, 200.0), (-180.0, 180.0)].map(|(a, b)| random.between(a, b));
        let source = format!(
            "#[closure(start)] mechanism Slider {{ ground {{ axis u = (1, 0); point P = (0mm, {height}mm); }} body crank {{ point A = ({crank}mm, 0mm); }}
                body rod {{ point B = ({rod}mm, 0mm); start angle = 10deg; }} body piston {{}}
                joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position);
                joint b = revolute(rod.B, piston.position); joint c = translational(ground.u, ground.P, piston.position);
                drive input = drive_angle(crank, ({angle}) * 1deg + 1rad_s * t); }}"
        );
        let wanted = (height - crank * angle.to_radians().sin()).abs() - rod;
        if wanted < -1e-3 {
            accepted(&source);
        } else if wanted > 1e-3 {
            assert_near(gap(&source, "c").0, wanted, &source);
        }
    }
}

#[test]
fn the_second_of_two_loops_is_named() {
    // The second loop is attached to the rocker of the first, which is at 90° in a rectangle.
    let second = |rod: f64| {
        format!("#[closure(start)] {}", four_bar([400.0, 100.0, 400.0, 100.0], 90.0, "start angle = 90deg;")).replace(
            "drive input",
            &format!(
                "body link {{ point D = ({rod}mm, 0mm); }} body lever {{ point D = (50mm, 0mm); start angle = 200deg; }}
                joint d = revolute(rocker.B, link.position); joint e = revolute(link.D, lever.D);
                joint f = revolute(lever.position, (700mm, 100mm)); drive input"
            ),
        )
    };
    accepted(&second(270.0));
    // The distance from (400, 100) to (700, 100) is 300 mm.
    assert_near(gap(&second(200.0), "f").0, 50.0, "a short link");
    assert_near(gap(&second(470.0), "f").0, 120.0, "a long link");
    // If the first loop takes its crossed assembly, as it may, the link is long enough.
    accepted(&second(390.0));
}

#[test]
fn a_wheel_between_two_others_must_reach_both() {
    for distance in [161.0, 170.0, 400.0] {
        let source = format!(
            "mechanism Idler {{ ground {{ point B = ({distance}mm, 0mm); }} body idler {{ start position = (80mm, 20mm); }}
                joint one = distance(ground.position, idler.position, 80mm); joint two = distance(ground.B, idler.position, 80mm);
                drive input = drive_angle(idler, 1rad_s * t); }}"
        );
        let (length, _, missing) = gap(&source, "two");
        assert_near(length, distance - 160.0, &source);
        assert_near(missing.expect("two rods have a bound"), distance - 160.0, &source);
    }
}

#[test]
fn an_angle_that_is_not_reached_is_told_in_degrees() {
    for (crank, tilt) in [(50.0_f64, 40.0), (70.0, 60.0), (20.0, 89.0)] {
        let source = format!(
            "mechanism Slider {{ ground {{ axis u = (1, 0); }} body crank {{ point A = ({crank}mm, 0mm); }} body rod {{ point B = (100mm, 0mm); }}
                body piston {{}} joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, rod.position);
                joint b = revolute(rod.B, piston.position); joint c = translational(ground.u, ground.position, piston.position);
                joint tilt = absolute_angle(rod, {tilt}deg); }}"
        );
        let (length, angle, _) = gap(&source, "tilt");
        assert!(length < 1e-6, "{length}");
        assert_near(angle, tilt - (crank / 100.0).asin().to_degrees(), &source);
    }
}

/// An axis goes round a cone about z, another one a cone about x: between them there are at least 90° less both half angles.
#[test]
fn directions_that_are_not_reached_are_told_in_degrees() {
    for (one, two) in [(30.0_f64, 20.0_f64), (50.0, 1.0), (10.0, 79.0)] {
        let source = format!(
            "mechanism Cones in space {{ ground {{ axis x = (1, 0, 0); axis z = (0, 0, 1); }}
                body a {{ axis z = (0, 0, 1); axis u = (sin({one}deg), 0, cos({one}deg)); }}
                body b {{ axis x = (1, 0, 0); axis v = (cos({two}deg), 0, sin({two}deg)); }}
                joint o = revolute(ground.position, ground.z, a.position, a.z);
                joint p = revolute(ground.position, ground.x, b.position, b.x);
                joint tie = parallel_axes(a.u, b.v); }}"
        );
        let (length, angle, _) = gap(&source, "tie");
        assert!(length < 1e-6, "{length}");
        assert_near(angle, 90.0 - one - two, &source);
    }
}

#[test]
fn a_loop_of_bodies_with_two_rods_is_measured_at_its_last_rod() {
    // A platform of 60 mm on two rods at a fixed height: Pythagoras' theorem gives the missing length of the rods.
    let source = "mechanism Platform { ground { point B = (60mm, 0mm); } body platform { point B = (60mm, 0mm); }
        joint left = distance(ground.position, platform.position, 50mm); joint right = distance(ground.B, platform.B, 50mm);
        joint height = absolute_y(platform.position, 80mm); }";
    let (length, _, missing) = gap(source, "height");
    assert_near(length, 30.0, source);
    assert_near(missing.expect("a rod and a line"), 30.0, source);
}
