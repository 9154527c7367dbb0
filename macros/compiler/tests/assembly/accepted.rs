//! Mechanisms that are accepted.

use crate::{Random, accepted, four_bar, refused, samples, start};
use reuleaux_compiler::diag::{AssemblyFact, Fact};

#[test]
fn a_start_far_from_any_assembly_closes() {
    for declared in [0.4, 17.0, -40.0, 90.0, 179.0, 400.0] {
        let all = format!("start angle = ({declared}) * 1deg; start position = (5m, -3m);");
        let source = four_bar([400.0, 100.0, 350.0, 300.0], 77.0, &all).replace("body coupler { ", "body coupler { start angle = -80deg; ");
        assert!(accepted(&source).assembly.is_closed);
    }
}

#[test]
fn what_is_allowed_is_documented() {
    let open = four_bar([400.0, 100.0, 100.0, 150.0], 0.0, "");
    let compiled = accepted(&format!("#[closure(allow)] {open}"));
    assert!(!compiled.assembly.is_closed);
    assert!(compiled.assembly.remark.expect("a remark").starts_with("`c` stays open by 50 mm"));
    let symmetric = accepted(&format!("#[closure(allow)] {}", four_bar([400.0, 100.0, 350.0, 300.0], 0.0, "")));
    assert!(symmetric.assembly.is_closed);
    assert!(symmetric.assembly.remark.expect("a remark").starts_with("two assemblies are equally near"));
    assert_eq!(accepted(&format!("#[closure(deny)] {}", four_bar([400.0, 100.0, 350.0, 300.0], 9.0, ""))).assembly.remark, None);
}

#[test]
fn where_no_assembly_is_looked_for_the_start_is_as_declared() {
    let compiled = accepted(&format!("#[closure(off)] {}", four_bar([400.0, 100.0, 100.0, 150.0], 0.0, "start angle = 20deg;")));
    assert!(!compiled.assembly.is_closed);
    assert_eq!(compiled.assembly.start[..8], [0.0; 8]);
    assert!((start(&compiled, "rocker.angle") - 20_f64.to_radians()).abs() < 1e-15);
}

#[test]
fn what_depends_on_a_rust_function_is_not_judged() {
    let cam = "mechanism Cam { function lift(Angle) -> Length = crate::lift; ground { point C = (900mm, 0mm); } body cam { }
        body follower { point A = (0mm, 0mm); } body link { point B = (10mm, 0mm); } body lever { point B = (10mm, 0mm); }
        joint o = revolute(ground.position, cam.position);
        joint guide = absolute_x(follower.position, 0); joint level = absolute_angle(follower, 0);
        joint contact = { follower.y == lift(cam.angle); }
        joint a = revolute(follower.A, link.position); joint b = revolute(link.B, lever.B); joint c = revolute(lever.position, ground.C);
        drive input = drive_angle(cam, 1rad_s * t); OTHER }";
    // The follower's position is unknown, and therefore also whether the link is too short.
    accepted(&cam.replace("OTHER", ""));
    // Blocks that do not depend on the follower are diagnosed.
    let other = "body arm { point E = (10mm, 0mm); } body bar { point E = (10mm, 0mm); } joint p = revolute(ground.C, arm.position);
        joint q = revolute(arm.E, bar.position); joint r = absolute_y(bar.E, 50mm); drive second = drive_angle(arm, 1rad_s * t);";
    assert!(matches!(refused(&cam.replace("OTHER", other)), Fact::Assembly(AssemblyFact::StaysOpen { .. })));
}

#[test]
fn random_linkages_that_were_assembled_first_are_accepted() {
    let mut random = Random(0x0123_4567_89ab_cdef);
    for _ in 0..samples(20, 60) {
        // Dyads attached to existing points, with their lengths measured there.
        let mut source =
            String::from("#[closure(start)] mechanism Linkage { ground { point O = (0mm, 0mm); } body crank { point A = (100mm, 0mm); } ");
        source += "joint o = revolute(ground.O, crank.position); drive input = drive_angle(crank, 30deg + 1rad_s * t); ";
        let mut last = (String::from("crank.A"), [100.0 * 30_f64.to_radians().cos(), 50.0]);
        let dyads = 1 + (random.between(0.0, 5.0) as usize);
        for dyad in 0..dyads {
            let [pivot, knee] = [0; 2].map(|_| [random.between(-400.0, 400.0), random.between(-400.0, 400.0)]);
            let far = |one: [f64; 2], other: [f64; 2]| (one[0] - other[0]).hypot(one[1] - other[1]);
            let turn = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees();
            let (one, two) = (far(last.1, knee), far(pivot, knee));
            let near = turn(pivot, knee) + random.between(-5.0, 5.0);
            source += &format!(
                "body bar{dyad} {{ point B = ({one:.9}mm, 0mm); }} body arm{dyad} {{ point B = ({two:.9}mm, 0mm); start angle = ({near:.6}) * 1deg; }}
                joint a{dyad} = revolute({}, bar{dyad}.position); joint b{dyad} = revolute(bar{dyad}.B, arm{dyad}.B);
                joint c{dyad} = revolute(arm{dyad}.position, ({:.9} * 1mm, {:.9} * 1mm)); ",
                last.0, pivot[0], pivot[1]
            );
            last = (format!("arm{dyad}.B"), knee);
        }
        accepted(&(source + "}"));
    }
}
