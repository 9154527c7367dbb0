//! Laws of every schedule, and shapes of blocks.

use super::{Code, Plan, Routine, Step, Summary};
use crate::compile;
use crate::expr::{Arena, Expr, Leaf, Node, Unary};
use std::collections::BTreeSet;

fn plan(declaration: &str) -> Plan {
    compile(declaration.parse().expect("tokens")).expect("a valid mechanism").plan
}

/// Four-bars side by side with the same equations, each driven at its own speed.
fn four_bars(count: usize, slider: bool) -> String {
    let mut text = String::from(
        "mechanism Row {
        component FourBar(at: Length, speed: AngularVelocity) {
            let O = (at, 0m);
            let C = (at + 4m, 0m);
            body crank { point A = (1m, 0m); }
            body coupler { point B = (3.5m, 0m); }
            body rocker { point B = (3m, 0m); start angle = 70deg; }
            joint o = revolute(O, crank.position);
            joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.position, C);
            drive input = drive_angle(crank, speed * t);
        }",
    );
    for number in 0..count {
        text += &format!("part bar_{number} = FourBar({number}0m, {}rpm);", 10 + number);
    }
    if slider {
        text += "body wheel { point A = (1m, 0m); } body rod { point B = (3m, 0m); } body slider { }
            joint o = revolute((0m, 9m), wheel.position);
            joint a = revolute(wheel.A, rod.position);
            joint b = revolute(rod.B, slider.position);
            joint guide = translational((1, 0), (0m, 9m), slider.position);
            drive turn = drive_angle(wheel, 5rpm * t);";
    }
    text + " }"
}

/// Named nodes from which an expression is computed, without the expression itself.
fn named_below(arena: &Arena, routine: &Routine, root: Expr) -> Vec<Expr> {
    let (mut open, mut found) = (arena.node(root).children().collect::<Vec<Expr>>(), Vec::new());
    while let Some(expr) = open.pop() {
        if routine.names.contains_key(&expr) {
            found.push(expr);
        } else {
            open.extend(arena.node(expr).children());
        }
    }
    found
}

/// Named sine and cosine nodes of an angle.
fn sine_and_cosine(arena: &Arena, routine: &Routine, angle: Expr) -> Vec<Expr> {
    let is_of = |expr: &&Expr| matches!(arena.node(**expr), Node::Unary(Unary::Sin | Unary::Cos, of) if *of == angle);
    routine.names.keys().filter(is_of).copied().collect()
}

/// Asserts that a step needs only what is known, and adds what it computes.
fn take(arena: &Arena, routine: &Routine, step: &Step, known: &mut BTreeSet<Expr>) {
    match step {
        Step::Value(value) => {
            is_computed(arena, routine, known, *value);
            assert!(known.insert(*value), "`{}` is computed twice", routine.names[value]);
        }
        Step::SineCosine { angle, .. } => {
            is_computed(arena, routine, known, *angle);
            known.extend(sine_and_cosine(arena, routine, *angle));
        }
        Step::Call { argument, function, .. } => {
            is_computed(arena, routine, known, *argument);
            let of = (*function, *argument);
            let is_of = |expr: &&Expr| matches!(*arena.node(**expr), Node::Call { function, argument, .. } if (function, argument) == of);
            known.extend(routine.names.keys().filter(is_of).copied());
        }
        Step::Choice { lhs, rhs, members, branches } => {
            [lhs, rhs].into_iter().for_each(|side| is_computed(arena, routine, known, *side));
            for branch in branches {
                let mut inside = known.clone();
                branch.steps.iter().for_each(|step| take(arena, routine, step, &mut inside));
                let unknown = branch.results.iter().filter(|result| !inside.contains(result));
                unknown.for_each(|result| is_computed(arena, routine, &inside, *result));
                assert_eq!(branch.results.len(), members.len());
            }
            assert!(members.iter().all(|member| known.insert(*member)), "a value is chosen twice");
        }
    }
}

fn is_computed(arena: &Arena, routine: &Routine, known: &BTreeSet<Expr>, root: Expr) {
    for part in named_below(arena, routine, root) {
        let is_leaf = matches!(arena.node(part), Node::Leaf(_));
        assert!(is_leaf || known.contains(&part), "`{}` is used before it is computed", routine.names[&part]);
    }
}

fn obeys_the_laws(arena: &Arena, routine: &Routine) {
    let mut known = BTreeSet::new();
    let mut written = routine.results.iter().zip(&routine.after).peekable();
    for number in 0..=routine.steps.len() {
        while let Some((result, _)) = written.next_if(|(_, after)| **after <= number) {
            if !known.contains(result) {
                is_computed(arena, routine, &known, *result);
            }
        }
        let Some(step) = routine.steps.get(number) else { break };
        take(arena, routine, step, &mut known);
    }
    assert!(written.next().is_none(), "every result is written");
    let names: BTreeSet<&String> = routine.names.values().collect();
    assert_eq!(names.len(), routine.names.len(), "no two nodes share a name");
}

/// A slide by a program of motions, whose laws have a sine and a cosine each in three of their pieces.
const PROGRAM: &str = "mechanism Program {
    body slide { }
    joint guide = translational((0, 1), ground.position, slide.position);
    drive law = drive_y(slide.position, segments(60rpm * t, 0mm, [rise(20mm, 90deg, modified_sine), dwell(45deg),
        fall(12mm, 100deg, modified_sine), fall(8mm, 60deg, cycloidal), dwell(65deg)], periodic));
}";

/// Sines among some steps: outside of branches, and at most where a branch is taken at each choice.
fn sines(steps: &[Step]) -> [usize; 2] {
    let mut sum = [0, 0];
    for step in steps {
        match step {
            Step::SineCosine { .. } => sum = sum.map(|number| number + 1),
            Step::Choice { branches, .. } => sum[1] += branches.iter().map(|branch| sines(&branch.steps)[1]).max().unwrap_or(0),
            Step::Value(_) | Step::Call { .. } => {}
        }
    }
    sum
}

#[test]
fn a_branch_is_computed_where_it_holds() {
    let plan = plan(PROGRAM);
    for code in [&plan.phi, &plan.nu, &plan.gamma] {
        let Code::Straight(routine) = code else { panic!("one drive is written once") };
        obeys_the_laws(&plan.arena, routine);
        // That of 60 rpm t, brought into one turn, and that of one piece.
        let [outside, most] = sines(&routine.steps);
        assert!(outside <= 1 && most <= 2, "{outside} and {most} sines");
    }
}

#[test]
fn a_short_branch_is_no_choice() {
    let plan = plan(
        "mechanism Short {
        body slide { }
        joint guide = translational((0, 1), ground.position, slide.position);
        drive law = drive_y(slide.position, if t < 1s { 1m_s * t } else { 1m });
    }",
    );
    let Code::Straight(routine) = &plan.phi else { panic!("one drive is written once") };
    assert!(routine.steps.iter().all(|step| matches!(step, Step::Value(_))));
}

#[test]
fn nothing_is_used_before_it_is_computed() {
    let plan = plan(&four_bars(3, true));
    for code in [&plan.phi, &plan.jacobian, &plan.linearize, &plan.nu, &plan.gamma] {
        match code {
            Code::Straight(routine) => obeys_the_laws(&plan.arena, routine),
            Code::Grouped(groups) => groups.iter().for_each(|group| obeys_the_laws(&group.shape.arena, &group.routine)),
        }
    }
    [&plan.start, &plan.lengths, &plan.requirements].into_iter().for_each(|routine| obeys_the_laws(&plan.arena, routine));
}

#[test]
fn every_unknown_is_found_by_one_stage() {
    let plan = plan(&four_bars(2, true));
    let solution = plan.solution.expect("it is solved");
    let mut found: Vec<usize> = Vec::new();
    for stage in &solution.stages {
        match stage {
            Summary::Explicit { unknown, .. } => found.push(*unknown),
            Summary::Block { unknowns, .. } => found.extend(unknowns),
            Summary::Check(_) => {}
        }
    }
    found.sort_unstable();
    assert_eq!(found, (0..27).collect::<Vec<usize>>());
}

#[test]
fn blocks_that_do_the_same_operations_have_the_same_shape() {
    let shapes = |text: &str| -> Vec<usize> {
        let solution = plan(text).solution.expect("it is solved");
        let shape = |stage: &Summary| if let Summary::Block { shape, .. } = stage { Some(*shape) } else { None };
        solution.stages.iter().filter_map(shape).collect()
    };
    let alike = shapes(&four_bars(3, false));
    assert_eq!(alike.len(), 3);
    assert!(alike.iter().all(|shape| *shape == alike[0]), "{alike:?}");
    let mixed: BTreeSet<usize> = shapes(&four_bars(3, true)).into_iter().collect();
    assert_eq!(mixed.len(), 2, "{mixed:?}");
}

#[test]
fn drives_alone_read_the_time() {
    let plan = plan(&four_bars(2, false));
    let reads_time = |code: &Code| match code {
        Code::Straight(routine) => routine.leaves.iter().any(|(_, leaf)| *leaf == Leaf::Time),
        Code::Grouped(groups) => groups.iter().any(|group| group.routine.leaves.iter().any(|(_, leaf)| *leaf == Leaf::Time)),
    };
    assert!(reads_time(&plan.phi));
    // For a constant speed ν = −Φ_t is constant and γ = 0.
    assert!(!reads_time(&plan.jacobian) && !reads_time(&plan.nu) && !reads_time(&plan.gamma));
}
