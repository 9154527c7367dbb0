//! The block structures that the design promises, and the laws that every structure obeys.

use super::Structure;
use super::pattern::{Entry, Pattern};
use super::{components, contending, matching, tearing};
use crate::compile;
use crate::expr::tests::random::Random;
use std::collections::BTreeSet;

fn structure(declaration: &str) -> Structure {
    compile(declaration.parse().expect("tokens")).expect("a valid mechanism").structure
}

/// Sizes of the Newton iterations, in order.
fn iterated(structure: &Structure) -> Vec<usize> {
    structure.blocks.iter().map(|block| block.iterated.len()).filter(|size| *size > 0).collect()
}

const FOUR_BAR: &str = "mechanism FourBar {
    ground { point O = (0m, 0m); point C = (4m, 0m); }
    body crank { point O = (0m, 0m); point A = (1m, 0m); }
    body coupler { point A = (0m, 0m); point B = (3.5m, 0m); }
    body rocker { point C = (0m, 0m); point B = (3m, 0m); start angle = 70deg; }
    joint o = revolute(ground.O, crank.O);
    joint a = revolute(crank.A, coupler.A);
    joint b = revolute(coupler.B, rocker.B);
    joint c = revolute(rocker.C, ground.C);
    drive input = drive_angle(crank, 2 * pi * t / 1s);
}";

#[test]
fn a_driven_four_bar_is_one_system_of_two() {
    let structure = structure(FOUR_BAR);
    assert_eq!(iterated(&structure), [2]);
    let explicit: usize = structure.blocks.iter().map(|block| block.explicit.len()).sum();
    assert_eq!(explicit, 7);
}

#[test]
fn a_slider_crank_is_one_system_of_one() {
    let structure = structure(
        "mechanism SliderCrank {
            ground { point O = (0m, 0m); axis u = (1, 0); }
            body crank { point O = (0m, 0m); point A = (1m, 0m); }
            body rod { point A = (0m, 0m); point B = (3m, 0m); }
            body slider { point B = (0m, 0m); }
            joint o = revolute(ground.O, crank.O);
            joint a = revolute(crank.A, rod.A);
            joint b = revolute(rod.B, slider.B);
            joint guide = translational(ground.u, ground.O, slider.B);
            drive input = drive_angle(crank, 2 * pi * t / 1s);
        }",
    );
    assert_eq!(iterated(&structure), [1]);
}

#[test]
fn a_jansen_leg_is_three_systems_of_two() {
    let structure = structure(
        "mechanism Jansen {
            ground { point O = (0, 0); point V = (-38, -7.8); }
            body crank { point O = (0, 0); point X = (15, 0); }
            body bar_j { point X = (0, 0); point U = (50, 0); }
            body upper { point V = (0, 0); point U = (41.5, 0); point W = (2.61, 40.01); }
            body bar_k { point X = (0, 0); point C = (61.9, 0); }
            body bar_c { point V = (0, 0); point C = (39.3, 0); }
            body bar_f { point W = (0, 0); point F = (39.4, 0); }
            body foot { point F = (0, 0); point C = (36.7, 0); }
            joint o = revolute(ground.O, crank.O);
            joint xj = revolute(crank.X, bar_j.X);
            joint xk = revolute(crank.X, bar_k.X);
            joint u = revolute(bar_j.U, upper.U);
            joint v = revolute(ground.V, upper.V);
            joint vc = revolute(ground.V, bar_c.V);
            joint kc = revolute(bar_k.C, bar_c.C);
            joint w = revolute(upper.W, bar_f.W);
            joint f = revolute(bar_f.F, foot.F);
            joint cf = revolute(bar_c.C, foot.C);
            drive input = drive_angle(crank, 2 * pi * t / 1s);
        }",
    );
    assert_eq!(iterated(&structure), [2, 2, 2]);
}

#[test]
fn a_chain_of_four_bars_is_one_system_of_two_for_each() {
    for n in [1, 3, 12] {
        assert_eq!(iterated(&structure(&chain(n))), vec![2; n]);
    }
}

/// N four-bars in a row: cranks of length 1 on pivots at (i, 0), couplers between their tips.
fn chain(n: usize) -> String {
    let mut text = String::from("mechanism Chain { ground { ");
    for i in 0..=n {
        text += &format!("point P{i} = ({i}m, 0m); ");
    }
    text += "} ";
    for i in 0..=n {
        text += &format!("body crank{i} {{ point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }} ");
        text += &format!("joint o{i} = revolute(ground.P{i}, crank{i}.O); ");
    }
    for i in 0..n {
        text += &format!("body coupler{i} {{ point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }} ");
        text += &format!("joint a{i} = revolute(crank{i}.A, coupler{i}.A); joint b{i} = revolute(coupler{i}.B, crank{}.A); ", i + 1);
    }
    text + "drive input = drive_angle(crank0, 90deg + 0.8 * sin(2 * pi * t / 1s)); }"
}

#[test]
fn gears_are_explicit_through_ratios_that_are_checked() {
    for mesh in ["gear_pair(one, two, r, 60mm)", "involute_mesh(one.A, two.B, r, 60mm, 0deg)"] {
        let structure = structure(&format!(
            "mechanism Gears {{
                param r: Length = 20mm;
                ground {{ point A = (0m, 0m); point B = (80mm, 0m); }}
                body one {{ point A = (0m, 0m); }}
                body two {{ point B = (0m, 0m); }}
                joint a = revolute(ground.A, one.A);
                joint b = revolute(ground.B, two.B);
                joint mesh = {mesh};
                drive output = drive_angle(two, 3rad_s * t);
            }}"
        ));
        assert_eq!(iterated(&structure), Vec::<usize>::new(), "{mesh}");
    }
}

#[test]
fn a_joint_too_many_here_and_one_too_few_there_is_named() {
    let declaration = FOUR_BAR.replace("joint b = revolute(coupler.B, rocker.B);", "joint b = revolute(ground.O, crank.A);");
    let refusals = compile(declaration.parse().expect("tokens")).expect_err("a crank with two pivots");
    assert_eq!(refusals.len(), 1);
    let message = refusals[0].fact.to_string();
    assert!(message.contains("`b` is one equation too many with `o`: together they are 4 equations on 3 coordinates"), "{message}");
    assert!(message.contains("`rocker.angle`"), "{message}");
}

#[test]
fn a_group_that_contends_is_as_small_as_can_be() {
    let mut random = Random::new(0x1357_9bdf_0246_8ace);
    let mut groups = 0;
    for _ in 0..500 {
        let n = 2 + random.below(9) as usize;
        let mut pattern = random_pattern(&mut random, n);
        pattern.unknowns = n;
        let matching = matching::maximum(&pattern);
        for free in matching.free_equations() {
            let part = contending(&pattern, &matching, vec![free]);
            assert_eq!(part.equations.len(), part.unknowns.len() + 1);
            for left_out in &part.equations {
                let rest: Vec<usize> = part.equations.iter().copied().filter(|equation| equation != left_out).collect();
                assert!(matching::maximum(&pattern.in_order(&rest)).free_equations().is_empty());
            }
            groups += 1;
        }
    }
    assert!(groups > 100);
}

#[test]
fn every_unknown_is_found_once_and_after_what_it_needs() {
    let mut random = Random::new(0x9e37_79b9_7f4a_7c15);
    for _ in 0..500 {
        let n = 1 + random.below(14) as usize;
        let pattern = random_pattern(&mut random, n);
        let matching = matching::maximum(&pattern);
        if !matching.free_unknowns().is_empty() {
            assert_eq!(matching.free_unknowns().len(), matching.free_equations().len());
            continue;
        }
        let mut known = BTreeSet::new();
        let mut equations = BTreeSet::new();
        for group in components::in_order(&pattern, &matching) {
            let block = tearing::tear(&pattern, &matching, &group);
            assert_eq!(block.iterated.len(), block.residuals.len());
            known.extend(block.iterated.iter().copied());
            for explicit in &block.explicit {
                let is_read = pattern.read[explicit.equation].contains(&explicit.unknown);
                assert!(!is_read || known.contains(&explicit.unknown));
                let mut others = pattern.needed(explicit.equation).filter(|entry| entry.unknown != explicit.unknown);
                assert!(others.all(|entry| known.contains(&entry.unknown)));
                assert!(pattern.rows[explicit.equation].iter().any(|entry| entry.unknown == explicit.unknown && entry.is_pivot));
                assert!(known.insert(explicit.unknown));
                assert!(equations.insert(explicit.equation));
            }
            for equation in &block.residuals {
                assert!(pattern.needed(*equation).all(|entry| known.contains(&entry.unknown)));
                assert!(equations.insert(*equation));
            }
        }
        assert_eq!((known.len(), equations.len()), (n, n));
    }
}

#[test]
fn the_matching_is_as_large_as_can_be() {
    let mut random = Random::new(0x2545_f491_4f6c_dd1d);
    for _ in 0..500 {
        let n = 1 + random.below(7) as usize;
        let pattern = random_pattern(&mut random, n);
        let found = matching::maximum(&pattern).of_equation.iter().flatten().count();
        assert_eq!(found, largest(&pattern, 0, &mut vec![false; n]));
    }
}

/// Size of a maximum matching by exhaustive search.
fn largest(pattern: &Pattern, equation: usize, taken: &mut Vec<bool>) -> usize {
    let Some(row) = pattern.rows.get(equation) else { return 0 };
    let mut best = largest(pattern, equation + 1, taken);
    for entry in row {
        if !taken[entry.unknown] {
            taken[entry.unknown] = true;
            best = best.max(1 + largest(pattern, equation + 1, taken));
            taken[entry.unknown] = false;
        }
    }
    best
}

fn random_pattern(random: &mut Random, n: usize) -> Pattern {
    let rows = (0..n).map(|_| {
        let unknowns: BTreeSet<usize> = (0..1 + random.below(3)).map(|_| random.below(n as u64) as usize).collect();
        unknowns.into_iter().map(|unknown| Entry { unknown, is_pivot: random.below(2) == 0 }).collect()
    });
    let rows = rows.collect();
    // Some equations read an unknown in a condition.
    let read = (0..n).map(|_| if random.below(4) == 0 { vec![random.below(n as u64) as usize] } else { Vec::new() }).collect();
    Pattern { unknowns: n, rows, read }
}
