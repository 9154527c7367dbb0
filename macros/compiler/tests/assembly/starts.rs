//! The assembly selected by a start, and starts that do not select one.

use crate::{Random, accepted, four_bar, refused, samples, spatial_four_bar, start};
use reuleaux_compiler::diag::{AssemblyFact, Doubt, Fact};

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
    assert!(compiled.assembly.is_closed && told.assembly.is_closed);
}

#[test]
fn mirror_images_are_refused_and_both_are_told() {
    let mut random = Random(0x1234_5678_9abc_def1);
    for _ in 0..40 {
        let ground = random.between(200.0, 400.0);
        let [coupler, rocker] = [0; 2].map(|_| random.between(0.7, 0.9) * ground);
        let lengths = [ground, 0.3 * ground, coupler, rocker];
        // When in line with ground, the triangle may be on either side of it.
        let distance = 0.7 * ground;
        let angle = ((rocker * rocker + distance * distance - coupler * coupler) / (2.0 * rocker * distance)).acos();
        match refused(&four_bar(lengths, 0.0, "")) {
            Fact::Assembly(AssemblyFact::AmbiguousStart { body, coordinate, values, .. }) => {
                assert_eq!((body.as_str(), coordinate.name()), ("rocker", "angle"));
                let wanted = core::f64::consts::PI - angle;
                assert!((values[0] - wanted).abs() < 1e-6 && (values[1] + wanted).abs() < 1e-6, "{values:?} for {wanted}");
            }
            other => panic!("{other}"),
        }
        // Any hint suffices.
        accepted(&four_bar(lengths, 0.0, "start angle = 3deg;"));
        accepted(&four_bar(lengths, 0.5, ""));
    }
}

#[test]
fn a_start_of_a_later_body_tells_earlier_ones_apart() {
    // The second loop is attached to the coupler of the symmetric first loop; its lever is on one side for each of the two assemblies.
    let source = |starts: &str| {
        format!("#[closure(start)] {}", four_bar([400.0, 100.0, 350.0, 300.0], 0.0, "")).replace(
            "drive input",
            &format!(
                "body link {{ point D = (250mm, 0mm); }} body lever {{ point D = (300mm, 0mm); {starts} }}
                joint d = revolute(coupler.B, link.position); joint e = revolute(link.D, lever.D);
                joint f = revolute(lever.position, (700mm, 0mm)); drive input"
            ),
        )
    };
    assert!(matches!(refused(&source("")), Fact::Assembly(AssemblyFact::AmbiguousStart { .. })));
    accepted(&source("start angle = 100deg;"));
}

#[test]
fn near_a_dead_point_is_not_at_it() {
    let lengths = [400.0, 100.0, 150.0, 150.0];
    assert!(matches!(refused(&four_bar(lengths, 0.0, "")), Fact::Assembly(AssemblyFact::SingularStart { .. })));
    assert!(matches!(
        refused(&four_bar(lengths, 0.0, "start angle = 150deg;")),
        Fact::Assembly(AssemblyFact::SingularStart { in_line: true, .. })
    ));
    // With a link one micrometre longer, the loop has two assemblies half a degree apart.
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
        assert!(matches!(refused(&slider(dead)), Fact::Assembly(AssemblyFact::SingularStart { in_line: true, .. })));
    }
    accepted(&slider(199.0));
    accepted(&slider(101.0));
}

/// A four-bar with starts for both coupler and rocker.
fn told(angle: f64, coupler: f64, rocker: f64) -> String {
    let source = four_bar([400.0, 100.0, 350.0, 300.0], angle, &format!("start angle = ({rocker}) * 1deg;"));
    source.replace("point B = (350mm, 0mm);", &format!("point B = (350mm, 0mm); start angle = ({coupler}) * 1deg;"))
}

#[test]
fn two_starts_that_contradict_each_other_are_weighed() {
    // With the crank at 0°, coupler and rocker are at ±54.3° and ±108.6°, both above or both below.
    let wrapped = |angle: f64| angle - 360.0 * (angle / 360.0).round();
    let far = |side: f64, coupler: f64, rocker: f64| wrapped(side * 54.31 - coupler).hypot(wrapped(side * 108.63 - rocker));
    for (coupler, rocker) in
        [(-75.0, 110.0), (75.0, -110.0), (-50.0, 20.0), (-20.0, 50.0), (170.0, -170.0), (300.0, 100.0), (-400.0, 500.0)]
    {
        let side = if far(1.0, coupler, rocker) < far(-1.0, coupler, rocker) { 1.0 } else { -1.0 };
        let compiled = accepted(&told(0.0, coupler, rocker));
        for (body, declared, right) in [("coupler.angle", coupler, 54.31), ("rocker.angle", rocker, 108.63)] {
            let found = start(&compiled, body).to_degrees();
            assert!(wrapped(found - side * right).abs() < 0.01, "{body} = {found} for {coupler} and {rocker}");
            assert!((found - declared).abs() <= 180.0 + 1e-9, "{body} = {found} makes turns that {declared} does not ask for");
        }
    }
}

#[test]
fn starts_in_the_middle_between_two_assemblies_tell_nothing() {
    // Mirror images about ground, coupler and rocker at ±(54.3°, 108.6°): equally far from 0° and 180° as from 180° and 0°.
    for (coupler, rocker) in [(0.0, 0.0), (180.0, 0.0), (0.0, 180.0), (180.0, 180.0), (-180.0, 360.0)] {
        assert!(
            matches!(refused(&told(0.0, coupler, rocker)), Fact::Assembly(AssemblyFact::AmbiguousStart { is_declared: true, .. })),
            "{coupler} and {rocker}"
        );
        accepted(&told(0.0, coupler + 1.0, rocker));
        accepted(&told(1.0, coupler, rocker));
    }
}

/// A crank, followed by a wheel with another ratio.
fn geared(ratio: f64, starts: [&str; 2]) -> String {
    format!(
        "mechanism Geared {{ ground {{ axis u = (1, 0); point W = (300mm, 200mm); }} body crank {{ point A = (50mm, 0mm); {} }}
            body rod {{ point B = (150mm, 0mm); }} body piston {{}} body wheel {{ {} }} joint o = revolute(ground.position, crank.position);
            joint a = revolute(crank.A, rod.position); joint b = revolute(rod.B, piston.position);
            joint c = translational(ground.u, ground.position, piston.position); joint w = revolute(ground.W, wheel.position);
            joint mesh = {{ wheel.angle == {ratio} * crank.angle; }} drive input = drive_x(piston.position, 150mm + 10mm_s * t); }}",
        starts[0], starts[1]
    )
}

#[test]
fn turns_that_a_gear_counts_stay_linked() {
    // r = 50, l = 150, x = 150: cos = (r² + x² − l²) / (2 r x).
    let crank = (50.0_f64 / 300.0).acos().to_degrees();
    for ratio in [0.5, -0.5, 2.0, 1.0 / 3.0, -1.0] {
        for (declared, wheel) in [(70.0, None), (-70.0, None), (430.0, None), (70.0, Some(-150.0)), (-70.0, Some(200.0))] {
            let wheel: Option<f64> = wheel;
            let starts =
                [format!("start angle = {declared}deg;"), wheel.map_or(String::new(), |wheel| format!("start angle = {wheel}deg;"))];
            let compiled = accepted(&geared(ratio, [&starts[0], &starts[1]]));
            let [found, follows] = ["crank.angle", "wheel.angle"].map(|name| start(&compiled, name).to_degrees());
            assert!((follows - ratio * found).abs() < 1e-9, "{found} and {follows} for {ratio}");
            // The nearest of all crank angles, whole turns included, since turns count here.
            let far = |angle: f64| (angle - declared).powi(2) + wheel.map_or(0.0, |wheel| (ratio * angle - wheel).powi(2));
            let all = (-2..=2).flat_map(|turns| [crank, -crank].map(|angle| angle + 360.0 * f64::from(turns)));
            let nearest = all.min_by(|one, other| far(*one).total_cmp(&far(*other))).expect("there are many");
            assert!((found - nearest).abs() < 1e-6, "{found}, not {nearest}, for {ratio}, {declared} and {wheel:?}");
        }
    }
}

/// Gears on an arm stay in mesh if all three make the same turns; once drives have placed the arm and one gear, the other counts them.
#[test]
fn turns_are_counted_from_what_drives_have_placed() {
    for (arm, one) in [(0.0, 70.0), (40.0, 70.0), (-30.0, 5.0), (12.5, 12.5)] {
        let compiled = accepted(&format!(
            "mechanism Carried {{ body arm {{ point A = (0mm, 0mm); point B = (150mm, 0mm); }} body one {{}} body two {{}} body three {{}}
                joint hub = revolute(ground.position, arm.position); joint a = revolute(arm.A, one.position);
                joint b = revolute(arm.B, two.position); joint c = revolute(arm.B, three.position);
                joint mesh = {{ 2 * (one.angle - arm.angle) + 3 * (two.angle - arm.angle + 0.1 * sin(two.angle - arm.angle)) == 0; }}
                joint next = {{ three.angle - two.angle + 0.1 * sin(three.angle - arm.angle) == 0; }}
                drive swing = drive_angle(arm, {arm}rad + 1rad_s * t); drive motor = drive_angle(one, {one}rad); }}"
        ));
        let [two, three] = ["two.angle", "three.angle"].map(|name| start(&compiled, name));
        let (first, second) = (two - arm, three - arm);
        assert!((2.0 * (one - arm) + 3.0 * (first + 0.1 * first.sin())).abs() < 1e-9, "{two} for {arm} and {one}");
        assert!((three - two + 0.1 * second.sin()).abs() < 1e-9, "{three} for {arm} and {one}");
    }
}

#[test]
fn bodies_that_must_be_parallel_make_whole_turns_together() {
    let source = |crank: f64, table: f64| {
        four_bar([400.0, 100.0, 350.0, 300.0], 30.0, &format!("start angle = {crank}deg;")).replace(
            "drive input",
            &format!("body desk {{ start angle = {table}deg; }} joint p = revolute(rocker.B, desk.position); joint q = relative_angle(rocker, desk, 10deg); drive input"),
        )
    };
    for (rocker, table, turns) in [(70.0, 80.0, 0.0), (430.0, 440.0, 1.0), (-290.0, -280.0, -1.0), (790.0, 800.0, 2.0)] {
        let compiled = accepted(&source(rocker, table));
        let [rocker, table] = ["rocker.angle", "desk.angle"].map(|name| start(&compiled, name).to_degrees());
        assert!((table - rocker - 10.0).abs() < 1e-9 && (rocker - 360.0 * turns).abs() < 180.0, "{rocker} and {table}");
    }
}

/// Warnings about an assembly far from its start: the body, and the drive that moves it there.
fn doubts(source: &str) -> Vec<(String, Option<String>)> {
    let told = |doubt: &Doubt| {
        let (Doubt::FarStart { what: body, drive, .. } | Doubt::FarOrientation { body, drive, .. }) = doubt else { panic!("{doubt:?}") };
        (body.clone(), drive.clone())
    };
    accepted(source).assembly.warnings.iter().map(|warning| told(&warning.doubt)).collect()
}

#[test]
fn an_assembly_far_from_its_start_is_told() {
    let far = |body: &str| vec![(body.to_owned(), None)];
    assert_eq!(doubts(&told(0.0, 54.0, 109.0)), []);
    assert_eq!(doubts(&told(0.0, 20.0, 70.0)), []);
    assert_eq!(doubts(&told(0.0, 54.0, 60.0)), far("rocker"));
    assert_eq!(doubts(&told(0.0, 5.0, 109.0)), far("coupler"));
    assert_eq!(doubts(&told(0.0, 414.0, -251.0)), []);
    // Undeclared starts cause no warning.
    assert_eq!(doubts(&four_bar([400.0, 100.0, 350.0, 300.0], 30.0, "")), []);
    let at = |declared: f64, driven: f64| {
        let source = told(driven, 54.0, 109.0);
        source.replace("point A = (100mm, 0mm);", &format!("point A = (100mm, 0mm); start angle = {declared}deg;"))
    };
    assert_eq!(doubts(&at(90.0, 0.0)), [("crank".to_owned(), Some("input".to_owned()))]);
    for (declared, driven) in [(40.0, 0.0), (360.0, 0.0), (0.0, 720.0), (-355.0, 0.0)] {
        assert_eq!(doubts(&at(declared, driven)), [], "{declared} for {driven}");
    }
}

#[test]
fn a_place_far_from_its_start_is_told() {
    let peg = |x: f64, y: f64| {
        format!(
            "mechanism Peg {{ ground {{ point F = (-150mm, 0mm); point G = (150mm, 0mm); }} body peg {{ start position = ({x}mm, {y}mm); }}
                joint one = distance(ground.F, peg.position, 250mm); joint two = distance(ground.G, peg.position, 250mm);
                joint level = absolute_angle(peg, 0); }}"
        )
    };
    // It is at (0, 200); the characteristic length is 150 mm.
    assert_eq!(doubts(&peg(0.0, 180.0)), []);
    assert_eq!(doubts(&peg(45.0, 200.0)), []);
    assert_eq!(doubts(&peg(0.0, 120.0)), [("peg".to_owned(), None)]);
    assert_eq!(doubts(&peg(60.0, 200.0)), [("peg".to_owned(), None)]);
    let warning = accepted(&peg(0.0, 120.0)).assembly.warnings[0].doubt.to_string();
    assert!(
        warning.starts_with("the nearest assembly has `peg` at (0 mm, 200 mm), 80 mm from its declared start at (0 mm, 120 mm)"),
        "{warning}"
    );
}

/// A four-bar in space whose crank stands upright.
fn in_space(rocker: &str) -> String {
    spatial_four_bar(90.0, rocker, "")
}

#[test]
fn an_orientation_far_from_its_start_is_told() {
    // The rocker stands at 109.8° or at 222.2°.
    assert_eq!(doubts(&in_space("start orientation = turn((0, 0, 1), 90deg);")), []);
    // Undeclared orientations cause no warning, although angles of joints at rest count from some.
    assert_eq!(doubts(&in_space("")), []);
    let compiled = accepted(&in_space("start orientation = turn((0, 0, -1), 350deg);"));
    let [warning] = compiled.assembly.warnings.as_slice() else { panic!("{:?}", compiled.assembly.warnings) };
    let words = warning.doubt.to_string();
    assert!(
        words.starts_with("the nearest assembly has `rocker` at `c.angle` = 109.7°, turned 99.73° away from its declared start\n"),
        "{words}"
    );
    // What the help says is accepted without a warning.
    let instead = words.split('`').find(|word| word.starts_with("start orientation")).expect("a line to type");
    assert_eq!(doubts(&in_space(instead)), []);
}

#[test]
fn a_declared_orientation_across_the_hinge_is_told() {
    let turned = |across: f64| in_space(&format!("start orientation = turn((0, 0, 1), 110deg) * turn((1, 0, 0), {across}deg);"));
    assert_eq!(doubts(&turned(40.0)), []);
    let compiled = accepted(&turned(60.0));
    let [warning] = compiled.assembly.warnings.as_slice() else { panic!("{:?}", compiled.assembly.warnings) };
    let words = warning.doubt.to_string();
    assert!(words.starts_with("the joints keep `rocker` turned 60° away from its declared start\n"), "{words}");
    assert!(words.contains("`start orientation = turn((0, 0, 1), 110deg);`"), "{words}");
}

#[test]
fn the_orientation_that_a_refusal_shows_leads_to_the_first_of_the_two_assemblies() {
    let source = spatial_four_bar(0.0, "", "");
    let fact = refused(&source);
    let words = fact.to_string();
    assert!(words.starts_with("two assemblies are equally near: `b.angle` = 54.31° or -54.31°"), "{words}");
    let instead = words.split('`').find(|word| word.starts_with("start orientation")).expect("a line to type");
    let source = source.replace("point B = (350mm, 0mm, 0mm);", &format!("point B = (350mm, 0mm, 0mm); {instead}"));
    // The angle of `b` belongs to the coupler.
    let angle = start(&accepted(&source), "coupler.angle").to_degrees();
    assert!((angle - 54.31).abs() < 0.01, "{angle}");
}

#[test]
fn a_start_that_rounding_tells_from_a_dead_point_is_solvable() {
    // If longer by e than the distance of 300 mm, two links of 150 mm deviate from the line by about √(2 e / 300).
    for e in [1e-4, 1e-6, 1e-8, 1e-10, 1e-11] {
        let compiled = accepted(&four_bar([400.0, 100.0, 150.0, 150.0 + e], 0.0, "start angle = 179deg;"));
        let (coupler, rocker): (f64, f64) = (150.0, 150.0 + e);
        // The excess is computed from the rounded lengths, in which e is one of the last digits.
        let excess = (rocker - 150.0) / 300.0;
        let half = (2.0 * excess * (1.0 + coupler / rocker)).sqrt() / core::f64::consts::SQRT_2;
        let found = core::f64::consts::PI - start(&compiled, "rocker.angle");
        assert!((found / half - 1.0).abs() < 2e-2, "{found} for {half} at {e}");
    }
    for e in ["0.0000000000000001", "0.00000000000000001", "0"] {
        let source = four_bar([400.0, 100.0, 150.0, 150.0], 0.0, "start angle = 179deg;");
        let source = source.replace("body rocker { point B = (150mm", &format!("body rocker {{ point B = (150mm + {e}mm"));
        assert!(matches!(refused(&source), Fact::Assembly(AssemblyFact::SingularStart { .. })), "{e}");
    }
}

/// Two bars of given lengths in m, stretched up to a gap, from a pivot at `off` m to a slider.
fn stretched([one, two]: [f64; 2], gap: f64, off: f64) -> String {
    format!(
        "mechanism Stretched {{ ground {{ axis u = (1, 0); point P = ({off}m, 0m); }} body slider {{}}
            body one {{ point A = ({one}m, 0m); start angle = 0.3rad; }} body two {{ point B = ({two}m, 0m); start angle = -0.3rad; }}
            joint o = revolute(ground.P, one.position); joint a = revolute(one.A, two.position);
            joint b = revolute(two.B, slider.position); joint r = translational(ground.u, ground.P, slider.position);
            drive d = drive_x(slider.position, {off}m + {one}m + {two}m - {gap:e}m - 1m_s * t); }}"
    )
}

#[test]
fn a_gap_is_solvable_as_long_as_rounding_leaves_the_jacobian() {
    for off in [0.0, 10.0, 1000.0] {
        // The drive's value is a multiple of its last digit.
        let digit = f64::EPSILON * f64::max(1.0, off);
        for gap in [1e6, 1e4, 1e3, 300.0, 100.0, 64.0, 45.0].map(|digits| digits * digit) {
            let compiled = accepted(&stretched([1.0, 1.0], gap, off));
            let left = 2.0 - (start(&compiled, "slider.x") - off);
            let wanted = 2.0 * (0.25 * left).sqrt().asin();
            let found = start(&compiled, "one.angle");
            assert!((found / wanted - 1.0).abs() < 0.25, "{found:e} for {wanted:e} at {gap:e} of {off}");
        }
        let mut random = Random(0x1f2e_3d4c_5b6a_7988);
        for lengths in core::iter::once([1.0, 1.0]).chain((0..samples(4, 20)).map(|_| [0; 2].map(|_| random.between(0.3, 1.5)))) {
            for gap in [0.0, 0.25 * digit] {
                let fact = refused(&stretched(lengths, gap, off));
                assert!(matches!(fact, Fact::Assembly(AssemblyFact::SingularStart { .. })), "{fact} {lengths:?} {gap:e} of {off}");
            }
        }
    }
}

#[test]
fn a_stage_as_near_to_its_fold_as_you_like_is_solvable() {
    for reach in [1.0, 1e-3, 1e-6, 2e-8, 1e-9, 1e-12, 1e-14, 1e-15] {
        let source = format!(
            "mechanism Stage {{ body stage {{ start position = ({reach:e}m, 0m); }} joint rail = {{ stage.position.y == 0m; stage.angle == 0; }}
                drive piezo = drive_distance(ground.position, stage.position, {reach:e}m * (1 + 0.5 * sin(10rad_s * t))); }}"
        );
        let compiled = accepted(&source);
        assert!((start(&compiled, "stage.x") / reach - 1.0).abs() < 1e-15, "{reach}: {}", start(&compiled, "stage.x"));
        assert_eq!((start(&compiled, "stage.y"), start(&compiled, "stage.angle")), (0.0, 0.0));
    }
}

/// The start satisfies to rounding the equations evaluated elsewhere.
#[test]
fn a_start_is_at_the_rounding_limit() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for _ in 0..20 {
        let lengths =
            [random.between(300.0, 450.0), random.between(50.0, 120.0), random.between(300.0, 420.0), random.between(300.0, 400.0)];
        let angle = random.between(-180.0, 180.0);
        let compiled = accepted(&four_bar(lengths, angle, "start angle = 70deg;"));
        let [ground, crank, coupler, rocker] = lengths.map(|length| length / 1e3);
        let angles = ["crank.angle", "coupler.angle", "rocker.angle"].map(|name| start(&compiled, name));
        let [one, two, three] = angles.map(f64::sin_cos);
        let x = crank * one.1 + coupler * two.1 - rocker * three.1 - ground;
        let y = crank * one.0 + coupler * two.0 - rocker * three.0;
        assert!(x.abs() < 4e-16 && y.abs() < 4e-16, "{x:e} and {y:e} for {lengths:?} at {angle}");
    }
}

#[test]
fn orientations_place_the_links_between_ground_and_a_declared_place() {
    // Sarrus' linkage: neither `upper` nor `outer` says where it is.
    let source = "mechanism Sarrus in space {
        ground { axis x = (1, 0, 0); axis y = (0, 1, 0); point P = (0mm, -200mm, 0mm); point Q = (-200mm, 0mm, 0mm); }
        body platform { axis x = (1, 0, 0); axis y = (0, 1, 0); point P = (0mm, -200mm, 0mm); point Q = (-200mm, 0mm, 0mm); start z = 360mm; }
        body lower { axis x = (1, 0, 0); point P = (0mm, 300mm, 0mm); start orientation = turn((1, 0, 0), 143deg); }
        body upper { axis x = (1, 0, 0); point P = (0mm, 300mm, 0mm); start orientation = turn((1, 0, 0), 37deg); }
        body inner { axis y = (0, 1, 0); point Q = (300mm, 0mm, 0mm); start orientation = turn((0, 1, 0), -143deg); }
        body outer { axis y = (0, 1, 0); point Q = (300mm, 0mm, 0mm); start orientation = turn((0, 1, 0), -37deg); }
        joint a = revolute(ground.P, ground.x, lower.position, lower.x);
        joint b = revolute(lower.P, lower.x, upper.position, upper.x);
        joint c = revolute(upper.P, upper.x, platform.P, platform.x);
        joint d = revolute(ground.Q, ground.y, inner.position, inner.y);
        joint e = revolute(inner.Q, inner.y, outer.position, outer.y);
        redundant joint f = revolute(outer.Q, outer.y, platform.Q, platform.y);
        drive lift = drive_rotation(a, 143deg - 5deg * sin(1rad_s * t));
    }";
    let knee = [-0.2 + 0.3 * 143.0_f64.to_radians().cos(), 0.3 * 143.0_f64.to_radians().sin()];
    for declared in ["start z = 360mm;", "start z = 300mm;", ""] {
        let compiled = accepted(&source.replace("start z = 360mm;", declared));
        let found = ["upper.y", "upper.z", "outer.x", "outer.z", "platform.y", "platform.z"].map(|name| start(&compiled, name));
        let wanted = [knee[0], knee[1], knee[0], knee[1], 0.0, 2.0 * knee[1]];
        assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-12), "{found:?} for {declared}");
    }
}

#[test]
fn coordinates_held_by_a_freedom_of_velocity_begin_where_the_mechanism_closes() {
    // The rail is 450 mm above the hinge: at an angle of 0 the rod does not reach it.
    let source = |declared: &str| {
        format!(
            "mechanism Slider {{
                ground {{ axis u = (1, 0); point Q = (0mm, 450mm); }}
                body crank {{ point A = (100mm, 0mm); mass = 1kg; inertia = 1kgm2; {declared} }}
                body slider {{ mass = 1kg; inertia = 1kgm2; }}
                joint o = revolute(ground.position, crank.position);
                joint rail = translational(ground.u, ground.Q, slider.position);
                joint rod = distance(crank.A, slider.position, 400mm);
                freedom spin = crank.angular_velocity from 1rad_s;
            }}"
        )
    };
    let length = |declared: &str| {
        let compiled = accepted(&source(declared));
        let [angle, x] = ["crank.angle", "slider.x"].map(|name| start(&compiled, name));
        (angle, (0.1 * angle.cos() - x).hypot(0.1 * angle.sin() - 0.45))
    };
    let (angle, rod) = length("");
    assert!(angle != 0.0 && (rod - 0.4).abs() < 1e-12, "{rod} at {angle}");
    let (angle, rod) = length("start angle = 60deg;");
    assert!((angle - 60.0_f64.to_radians()).abs() < 1e-12 && (rod - 0.4).abs() < 1e-12, "{rod} at {angle}");
    match refused(&source("start angle = 1deg;")) {
        Fact::Assembly(AssemblyFact::StaysOpen { starts, drives, .. }) => assert_eq!((starts, drives), (vec!["crank".to_owned()], vec![])),
        other => panic!("{other}"),
    }
}

/// Undeclared, the rod lies along x, where its length changes with the crank alone. There the crank's freedom depends on the equations of the
/// loop, and two coordinates of the rod seem to be open. In general only its spin is.
#[test]
fn rows_that_depend_on_each_other_at_the_declared_start_alone_open_no_coordinate() {
    let source = |rest: &str| {
        format!(
            "mechanism Loop in space {{
                ground {{ axis y = (0, 1, 0); axis x = (1, 0, 0); point C = (500mm, 100mm, 20mm); }}
                body crank {{ axis y = (0, 1, 0); point A = (0mm, 0mm, 100mm); mass = 1kg; inertia = (0.001kgm2, 0.001kgm2, 0.001kgm2); }}
                body rod {{ axis l = (1, 0, 0); point B = (550mm, 0mm, 0mm); mass = 0.5kg; inertia = (0.0002kgm2, 0.008kgm2, 0.008kgm2); }}
                body rocker {{ axis x = (1, 0, 0); point B = (0mm, 0mm, 250mm); mass = 1kg; inertia = (0.005kgm2, 0.005kgm2, 0.0004kgm2); }}
                joint o = revolute(ground.position, ground.y, crank.position, crank.y);
                joint c = revolute(ground.C, ground.x, rocker.position, rocker.x);
                joint a = spherical(crank.A, rod.position);
                joint b = spherical(rod.B, rocker.B);
                freedom spin = dot(rod.angular_velocity, z_axis(rod.l)) from 30rad_s;
                {rest}
            }}"
        )
    };
    let declared = [
        ("freedom s = o.angle;", Some(0.0)),
        ("freedom s = o.angle from 20deg;", Some(20.0)),
        ("freedom s = c.angle;", None),
        ("start o.angle = 0deg; start c.angle = -14.3deg; freedom s = o.angle;", Some(0.0)),
        ("start c.angle = 117deg; freedom s = o.angle from 0deg;", Some(0.0)),
        ("drive s = drive_rotation(o, 0.1rad_s * t);", Some(0.0)),
    ];
    for (rest, wanted) in declared {
        let compiled = accepted(&source(rest));
        let [crank, rocker] = ["crank.angle", "rocker.angle"].map(|name| start(&compiled, name));
        let along = 0.5 - 0.1 * crank.sin();
        let up = 0.02 + 0.25 * rocker.cos() - 0.1 * crank.cos();
        let length = along.hypot(0.1 - 0.25 * rocker.sin()).hypot(up);
        assert!((length - 0.55).abs() < 1e-12, "{length} with {rest}");
        assert!(wanted.is_none_or(|angle: f64| (crank - angle.to_radians()).abs() < 1e-12), "{crank} with {rest}");
    }
    // Too short a rod is no freedom too many.
    match refused(&source("freedom s = o.angle;").replace("550mm", "150mm")) {
        Fact::Assembly(AssemblyFact::StaysOpen { joint, .. }) => assert_eq!(joint, "b"),
        other => panic!("{other}"),
    }
}

/// The angle of the steered wheel is not shared between the wheel and the car.
#[test]
fn coordinates_held_by_equations_of_velocities_begin_at_zero_where_they_can() {
    let source = "#[integrated] mechanism Car {
        body car { point front = (2m, 0m); axis ahead = (1, 0); }
        body wheel { axis ahead = (1, 0); }
        joint pivot = revolute(car.front, wheel.position);
        joint rear = { cross(car.ahead, rate(car.position)) == 0m_s; }
        joint front = { cross(wheel.ahead, rate(wheel.position)) == 0m_s; }
        drive motor = { dot(car.ahead, rate(car.position)) == 1m_s; }
        drive steering = drive_relative_angle(car, wheel, 20deg);
    }";
    let compiled = accepted(source);
    let found = ["car.x", "car.y", "car.angle", "wheel.x", "wheel.y", "wheel.angle"].map(|name| start(&compiled, name));
    let wanted = [0.0, 0.0, 0.0, 2.0, 0.0, 20.0_f64.to_radians()];
    assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-15), "{found:?}");
}
