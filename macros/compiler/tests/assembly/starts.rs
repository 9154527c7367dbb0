//! Which assembly a start leads to, and what starts do not tell.

use crate::{Random, accepted, four_bar, refused, start};
use reuleaux_compiler::diag::Fact;

#[test]
fn the_nearer_assembly_is_taken() {
    for (declared, wanted) in [(70.0, 108.6), (1.0, 108.6), (179.0, 108.6), (-1.0, -108.6), (-70.0, -108.6)] {
        let compiled = accepted(&four_bar([400.0, 100.0, 350.0, 300.0], 0.0, &format!("start angle = ({declared}) * 1deg;")));
        let found = start(&compiled, "rocker.angle").to_degrees();
        assert!((found - wanted).abs() < 0.1, "{found} for {declared}");
    }
}

#[test]
fn without_a_start_the_less_turned_assembly_is_taken() {
    let compiled = accepted(&four_bar([400.0, 100.0, 350.0, 300.0], 60.0, ""));
    let turned = [start(&compiled, "coupler.angle"), start(&compiled, "rocker.angle")].map(|angle| angle * angle).iter().sum::<f64>();
    let told = accepted(&four_bar([400.0, 100.0, 350.0, 300.0], 60.0, "start angle = -120deg;"));
    let other = [start(&told, "coupler.angle"), start(&told, "rocker.angle")].map(|angle| angle * angle).iter().sum::<f64>();
    assert!((turned - other).abs() > 0.1);
    assert!(compiled.closure.is_closed && told.closure.is_closed);
}

#[test]
fn mirror_images_are_refused_and_both_are_told() {
    let mut random = Random(0x1234_5678_9abc_def1);
    for _ in 0..40 {
        let ground = random.between(200.0, 400.0);
        let [coupler, rocker] = [0; 2].map(|_| random.between(0.7, 0.9) * ground);
        let lengths = [ground, 0.3 * ground, coupler, rocker];
        // In line with the ground, the triangle may be on either side of it.
        let distance = 0.7 * ground;
        let angle = ((rocker * rocker + distance * distance - coupler * coupler) / (2.0 * rocker * distance)).acos();
        match refused(&four_bar(lengths, 0.0, "")) {
            Fact::AmbiguousStart { body, coordinate, values, .. } => {
                assert_eq!((body.as_str(), coordinate), ("rocker", "angle"));
                let wanted = core::f64::consts::PI - angle;
                assert!((values[0] - wanted).abs() < 1e-6 && (values[1] + wanted).abs() < 1e-6, "{values:?} for {wanted}");
            }
            other => panic!("{other}"),
        }
        // Any hint is enough.
        accepted(&four_bar(lengths, 0.0, "start angle = 3deg;"));
        accepted(&four_bar(lengths, 0.5, ""));
    }
}

#[test]
fn a_start_of_a_later_body_tells_earlier_ones_apart() {
    // The second loop hangs on the coupler of the first, which is symmetric; its lever is on one side for each of the two.
    let source = |starts: &str| {
        four_bar([400.0, 100.0, 350.0, 300.0], 0.0, "").replace(
            "drive input",
            &format!(
                "body link {{ point D = (250mm, 0mm); }} body lever {{ point D = (300mm, 0mm); {starts} }}
                joint d = revolute(coupler.B, link.position); joint e = revolute(link.D, lever.D);
                joint f = revolute(lever.position, (700mm, 0mm)); drive input"
            ),
        )
    };
    assert!(matches!(refused(&source("")), Fact::AmbiguousStart { .. }));
    accepted(&source("start angle = 100deg;"));
}

#[test]
fn near_a_dead_point_is_not_at_it() {
    let lengths = [400.0, 100.0, 150.0, 150.0];
    assert!(matches!(refused(&four_bar(lengths, 0.0, "")), Fact::SingularStart { .. }));
    assert!(matches!(refused(&four_bar(lengths, 0.0, "start angle = 150deg;")), Fact::SingularStart { in_line: true, .. }));
    // A micrometre longer, the loop closes in two ways that are half a degree apart.
    accepted(&four_bar([400.0, 100.0, 150.001, 150.0], 0.0, "start angle = 179deg;"));
}

#[test]
fn two_mirrors_of_one_start_at_the_dead_point_of_the_slider() {
    let slider = |place: f64| {
        format!(
            "mechanism Slider {{ ground {{ axis u = (1, 0); }} body crank {{ point A = (50mm, 0mm); start angle = 10deg; }}
                body rod {{ point B = (150mm, 0mm); }} body piston {{}} joint o = revolute(ground.position, crank.position);
                joint a = revolute(crank.A, rod.position); joint b = revolute(rod.B, piston.position);
                joint c = translational(ground.u, ground.position, piston.position);
                drive input = drive_x(piston.position, {place}mm + 10mm_s * t); }}"
        )
    };
    for dead in [200.0, 100.0] {
        assert!(matches!(refused(&slider(dead)), Fact::SingularStart { in_line: true, .. }));
    }
    accepted(&slider(199.0));
    accepted(&slider(101.0));
}
