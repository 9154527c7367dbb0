//! Mechanisms of many similar parts, which share code, and parts of them that are not solved.

use reuleaux::{Description, Mechanism, PlanStage, Stages, mechanism};
use reuleaux_tests::samples;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A mechanism of identical four-bars.
macro_rules! of_four_bars {
    ($(#[$doc:meta])* $name:ident { $($items:tt)* }) => {
        mechanism! {
            $(#[$doc])*
            pub(crate) mechanism $name {
                component FourBar(O: Point, C: Point) {
                    body crank { point A = (100mm, 0mm); }
                    body coupler { point B = (350mm, 0mm); start angle = 30deg; }
                    body rocker { point B = (300mm, 0mm); start angle = 70deg; }
                    joint o = revolute(O, crank.position);
                    joint a = revolute(crank.A, coupler.position);
                    joint b = revolute(coupler.B, rocker.B);
                    joint c = revolute(rocker.position, C);
                }
                $($items)*
            }
        }
    };
}

mechanism! {
    /// Forty parallelograms in a row: every crank turns with the first.
    pub mechanism Chain {
        let n = 40;
        ground { for i in 0..=n { point P[i] = (i * 1m, 0m); } }
        for i in 0..=n {
            body crank[i] { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
            joint o[i] = revolute(ground.P[i], crank[i].O);
        }
        for i in 0..n {
            body coupler[i] { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
            joint a[i] = revolute(crank[i].A, coupler[i].A);
            joint b[i] = revolute(coupler[i].B, crank[i + 1].A);
        }
        drive input = drive_angle(crank[0], 90deg + 0.8 * sin(2 * pi * t / 1s));
        slice output last = crank[n].A;
    }
}

/// The driver's angle, rate and acceleration.
fn driver(t: f64) -> [f64; 3] {
    let (sine, cosine) = (TAU * t).sin_cos();
    [FRAC_PI_2 + 0.8 * sine, 0.8 * TAU * cosine, -0.8 * TAU * TAU * sine]
}

#[test]
fn blocks_of_one_shape_are_counted_as_one() {
    let plan = Chain::<f64>::PLAN;
    assert_eq!(plan.blocks().collect::<Vec<_>>(), [2; 40]);
    assert_eq!(plan.shapes(), 1);
}

#[test]
fn every_crank_of_a_chain_turns_like_the_first() {
    let chain = Chain::default();
    let mut state = chain.solve(0.0).unwrap();
    for k in 1..=200 {
        let t = f64::from(k) / 200.0;
        chain.advance(&mut state, t).unwrap();
        let [angle, rate, acceleration] = driver(t);
        for crank in state.crank() {
            assert!((crank.angle - angle).abs() <= 1e-13, "{t}: {}", crank.angle - angle);
            assert!((crank.angular_velocity - rate).abs() <= 1e-12, "{t}: {}", crank.angular_velocity - rate);
            assert!((crank.angular_acceleration - acceleration).abs() <= 1e-10, "{t}: {}", crank.angular_acceleration - acceleration);
        }
        for coupler in state.coupler() {
            assert!(coupler.angle.abs() <= 1e-13 && coupler.angular_velocity.abs() <= 1e-12);
        }
    }
}

#[test]
fn shared_code_has_small_residuals_everywhere() {
    let chain = Chain::default();
    let state = chain.solve(0.3).unwrap();
    assert!(chain.phi(&state.q, 0.3).amax() <= 1e-14);
    let entries = chain.jacobian_entries(&state.q, 0.3);
    let mut rates = -chain.nu(&state.q, 0.3);
    let mut accelerations = -chain.gamma(&state.q, &state.qd, 0.3);
    for ((row, column), entry) in Chain::<f64>::JACOBIAN_PATTERN.into_iter().zip(entries) {
        rates[row] += entry * state.qd[column];
        accelerations[row] += entry * state.qdd[column];
    }
    assert!(rates.amax() <= 1e-13, "{}", rates.amax());
    assert!(accelerations.amax() <= 1e-12, "{}", accelerations.amax());
}

#[test]
fn a_slice_of_shared_code_gives_the_output() {
    let chain = Chain::default();
    let last = chain.solve_for_last();
    for t in [0.1, 0.6] {
        let (whole, alone) = (chain.last(&chain.solve(t).unwrap()), last.solve(t).unwrap().output());
        assert!((whole.value - alone.value).amax() <= 1e-13);
        assert!((whole.rate - alone.rate).amax() <= 1e-12);
        assert!((whole.acceleration - alone.acceleration).amax() <= 1e-10);
    }
}

/// Links of different lengths, so that shared code has tables; a long row and a short one.
macro_rules! row {
    ($name:ident, $n:literal) => {
        mechanism! {
            /// Four-bars in a row, each a little larger than the one before.
            #[allow(far_start)]
            pub(crate) mechanism $name {
                let n = $n;
                ground { for i in 0..=n { point P[i] = (i * 1m, i * i * 1mm); } }
                for i in 0..=n {
                    body crank[i] { point O = (0m, 0m); point A = ((1 + 0.003 * i) * 1m, 0m); start angle = 90deg; }
                    joint o[i] = revolute(ground.P[i], crank[i].O);
                }
                for i in 0..n {
                    body coupler[i] { point A = (0m, 0m); point B = ((1.01 + 0.002 * i * i / 30) * 1m, 0m); start angle = 0deg; }
                    joint a[i] = revolute(crank[i].A, coupler[i].A);
                    joint b[i] = revolute(coupler[i].B, crank[i + 1].A);
                }
                drive input = drive_angle(crank[0], 90deg + 0.3 * sin(2 * pi * t / 1s));
            }
        }
    };
}
row!(LongRow, 30);
row!(ShortRow, 3);

#[test]
fn shared_code_with_tables_gives_what_straight_lines_give() {
    let (long, short) = (LongRow::default(), ShortRow::default());
    assert_eq!(LongRow::<f64>::PLAN.shapes(), 1);
    for t in [0.0, 0.2, 0.7] {
        let (long, short) = (long.solve(t).unwrap(), short.solve(t).unwrap());
        for (one, other) in long.crank().into_iter().zip(short.crank()) {
            assert!((one.angle - other.angle).abs() <= 1e-13, "{t}: {}", one.angle - other.angle);
            assert!((one.angular_velocity - other.angular_velocity).abs() <= 1e-12);
            assert!((one.angular_acceleration - other.angular_acceleration).abs() <= 1e-10);
        }
    }
}

of_four_bars! {
    /// A hundred four-bars side by side, one driven and the others held.
    Scene {
        param held: Angle = 50deg;
        ground { for i in 0..100 { point O[i] = (i * 1m, 0m); point C[i] = (i * 1m + 400mm, 0m); } }
        for i in 0..100 { part bar[i] = FourBar(ground.O[i], ground.C[i]); }
        for i in 0..99 { drive hold[i] = drive_angle(bar[i].crank, held); }
        drive input = drive_angle(bar[99].crank, 60rpm * t);
    }
}

#[test]
fn what_rests_is_taken_from_the_state_before() {
    // Without optimisation, every copy of a state of a hundred four-bars has its own stack slot.
    std::thread::Builder::new().stack_size(64 << 20).spawn(rests_are_taken).unwrap().join().unwrap();
}

fn rests_are_taken() {
    let scene = Scene { held: 0.9 };
    let mut state = scene.solve(0.0).unwrap();
    // A modified value, which solving would overwrite.
    let solved = state.q[5];
    let mark = solved + 1e-3;
    state.0.values_kept_as_solved().q[5] = mark;
    scene.advance(&mut state, 0.01).unwrap();
    assert_eq!(state.q[5], mark);
    // A value modified through the public interface is solved again.
    state.0.q[5] = mark;
    scene.advance(&mut state, 0.02).unwrap();
    assert!(f64::abs(state.q[5] - solved) < 1e-15);
    for wrong in [f64::NAN, f64::INFINITY, 1e300] {
        state.0.qd[5] = wrong;
        if scene.advance(&mut state, 0.03).is_ok() {
            assert_eq!((state.qd[5], state.qdd[5]), (0.0, 0.0));
        }
    }
}

#[test]
fn what_moves_of_a_scene_moves_as_it_does_alone() {
    let scene = Scene::default();
    let mut state = scene.solve(0.0).unwrap();
    let steps = samples(20, 100);
    for k in 1..=steps {
        let t = k as f64 / steps as f64;
        scene.advance(&mut state, t).unwrap();
        let directly = scene.solve(t).unwrap();
        assert!((state.q - directly.q).amax() <= 1e-12);
        assert!((state.qd - directly.qd).amax() <= 1e-11);
        assert!((state.qdd - directly.qdd).amax() <= 1e-9);
    }
}

of_four_bars! {
    /// Sixteen four-bars that are driven one after the other.
    Relay {
        ground { for i in 0..16 { point O[i] = (i * 1m, 0m); point C[i] = (i * 1m + 400mm, 0m); } }
        for i in 0..16 {
            part bar[i] = FourBar(ground.O[i], ground.C[i]);
            drive input[i] = drive_angle(bar[i].crank, 20deg + 60deg * polynomial_4567((t - i * 1s) / 1s));
        }
    }
}

#[test]
fn a_block_whose_drive_rests_is_not_solved_again() {
    let relay = Relay::default();
    let mut state = relay.solve(3.0).unwrap();
    relay.advance(&mut state, 3.4).unwrap();
    // Modified values, which solving would overwrite: in a part that has stopped, and in a part that has not started yet.
    let rockers = [14, 86];
    let marks = rockers.map(|i| state.0.q[i] + 1e-3);
    for (i, mark) in rockers.into_iter().zip(marks) {
        state.0.values_kept_as_solved().q[i] = mark;
    }
    relay.advance(&mut state, 3.41).unwrap();
    assert_eq!(rockers.map(|i| state.q[i]), marks);
}

#[test]
fn a_relay_moves_on() {
    let relay = Relay::default();
    let mut state = relay.solve(0.0).unwrap();
    for k in 1..=320 {
        relay.advance(&mut state, f64::from(k) / 20.0).unwrap();
        assert!(relay.phi(&state.q, state.t).amax() <= 1e-14 * 16.0, "{k}");
    }
    let first = state.bar()[0].rocker().angle;
    for bar in state.bar() {
        assert!((bar.rocker().angle - first).abs() <= 1e-13);
    }
}

mechanism! {
    /// Two wheels with given sum and difference of their angles: a constant Jacobian that is not triangular.
    pub mechanism SumAndDifference {
        body one { point P = (10mm, 0mm); }
        body two { point P = (20mm, 0mm); }
        joint a = revolute(ground.position, one.position);
        joint b = revolute(ground.position, two.position);
        drive sum = { one.angle + two.angle == 3rad_s * t; }
        drive difference = { 3 * one.angle - 4 * two.angle == 1rad_s * t + 1rad; }
    }
}

#[test]
fn a_constant_jacobian_is_solved_in_the_compiler() {
    assert_eq!(SumAndDifference::<f64>::PLAN.blocks().count(), 0);
    let state = SumAndDifference::default().solve(2.0).unwrap();
    // 7 φ₁ = 4 · 3 t + t + 1
    assert!((state.one().angle - 27.0 / 7.0).abs() <= 1e-15 * 8.0);
    assert!((state.two().angle - 15.0 / 7.0).abs() <= 1e-15 * 8.0);
    assert!((state.one().angular_velocity - 13.0 / 7.0).abs() <= 1e-15 * 8.0);
    assert_eq!(state.one().angular_acceleration, 0.0);
}

mechanism! {
    /// A four-bar at rest.
    pub mechanism Truss {
        param angle: Angle = 1rad;
        ground { point C = (400mm, 0mm); }
        body crank { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm); }
        body rocker { point B = (300mm, 0mm); start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive hold = drive_angle(crank, angle);
        slice output tip = rocker.B;
    }
}

#[test]
fn what_nothing_moves_has_no_rates() {
    let truss = Truss { angle: 0.7 };
    let state = truss.solve(3.0).unwrap();
    assert!(state.qd.iter().chain(state.qdd.iter()).all(|rate| *rate == 0.0));
    assert_eq!(truss.tip(&state).rate.amax(), 0.0);
}

/// A mechanism and its slice have separate states, with names of one declaration.
#[test]
fn a_slice_says_what_it_holds() {
    fn names<E: Stages<f64, N>, const N: usize>(_: &E) -> Vec<String> {
        E::COORDINATES.iter().map(|coordinate| format!("{}.{}", coordinate.body, coordinate.name)).collect()
    }
    let truss = Truss::default();
    assert_eq!(names(&truss.solve_for_tip()), ["coupler.angle", "rocker.angle", "tip.x", "tip.y"]);
    assert_eq!(<TrussForTip as Description<f64, 4>>::NAME, "Truss");
    let alone = Mechanism::solve(&truss.solve_for_tip(), 0.0).unwrap();
    let whole = truss.solve(0.0).unwrap();
    assert!((alone.point(2).value - truss.tip(&whole).value).amax() <= 1e-15);
    let is_block = |stage: &&PlanStage| matches!(stage, PlanStage::Iterated { .. });
    assert_eq!(TrussForTip::<f64>::PLAN.stages.iter().filter(is_block).count(), 1);
}

mechanism! {
    /// Slides on an inclined rail at rest, each with its own dyad; the rail is the rocker of a parallelogram at rest.
    #[allow(far_start)]
    pub mechanism Rail {
        let n = 60;
        param held: Angle = 0.02rad;
        ground { point O = (0m, 0m); point C = (4m, 0m); }
        body crank { point A = (1m, 3m); }
        body coupler { point B = (4m, 0m); }
        body rocker { point B = (1m, 3m); axis u = (1, 3); start angle = 0.02rad; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive hold = drive_angle(crank, held);
        for i in 0..n {
            body slide[i] { start position = (5m + i * 10mm, 3m); start angle = 70deg; }
            body link[i] { point B = (3m, 0m); start angle = 0.5rad; }
            body knob[i] { point B = (3m, 0m); start angle = 2rad; }
            joint guide[i] = translational(rocker.u, rocker.B, slide[i].position);
            drive along[i] = drive_along(guide[i], 1m + 10mm * i + 0.1m * sin(1rad_s * t));
            joint p[i] = revolute(slide[i].position, link[i].position);
            joint q[i] = revolute(link[i].B, knob[i].B);
            joint r[i] = revolute(knob[i].position, rocker.position);
        }
    }
}

/// Without optimisation a state of this size needs more stack than a test has.
fn with_a_large_stack(run: fn()) {
    std::thread::Builder::new().stack_size(64 << 20).spawn(run).unwrap().join().unwrap();
}

#[test]
fn what_moves_may_turn_by_an_angle_that_rests() {
    with_a_large_stack(|| {
        for held in [0.02, 0.6] {
            let rail = Rail { held };
            let mut state = rail.solve(0.0).unwrap();
            for k in 1..=20 {
                rail.advance(&mut state, f64::from(k) / 20.0).unwrap();
                assert!(rail.phi(&state.q, state.t).amax() <= 1e-14, "{held}, {k}: {}", rail.phi(&state.q, state.t).amax());
            }
        }
    });
}

#[test]
fn other_parameters_move_what_rests() {
    with_a_large_stack(|| {
        let mut rail = Rail::default();
        let mut state = rail.solve(0.0).unwrap();
        rail.advance(&mut state, 0.01).unwrap();
        rail.held += 0.05;
        rail.advance(&mut state, 0.02).unwrap();
        assert!(rail.phi(&state.q, state.t).amax() <= 1e-14);
        let mut scene = Scene::default();
        let mut state = scene.solve(0.0).unwrap();
        scene.held += 0.05;
        scene.advance(&mut state, 0.01).unwrap();
        assert!(scene.phi(&state.q, state.t).amax() <= 1e-13);
    });
}

mechanism! {
    /// Chains of rods whose lengths are parameters of the parts.
    pub mechanism Curtain {
        component Strand(O: Point, C: Point) {
            param rod: Length = 350mm;
            body crank { point A = (100mm, 0mm); }
            body coupler { point B = (rod, 0mm); start angle = 30deg; }
            body rocker { point B = (300mm, 0mm); start angle = 70deg; }
            joint o = revolute(O, crank.position);
            joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.position, C);
            drive input = drive_angle(crank, 1rad_s * t);
        }
        ground { for i in 0..24 { point O[i] = (i * 1m, 0m); point C[i] = (i * 1m + 400mm, 0m); } }
        for i in 0..24 { part strand[i] = Strand(ground.O[i], ground.C[i]); }
        slice output end = strand[23].rocker.B;
    }
}

#[test]
fn shared_code_finds_the_parameters_of_each_part() {
    let mut curtain = Curtain::default();
    for (i, strand) in curtain.strand.iter_mut().enumerate() {
        strand.rod = 0.35 + 0.001 * i as f64;
    }
    assert_eq!(Curtain::<f64>::PLAN.shapes(), 1);
    let mut state = curtain.solve(0.2).unwrap();
    curtain.advance(&mut state, 0.3).unwrap();
    assert!(curtain.phi(&state.q, 0.3).amax() <= 1e-14);
    for (i, strand) in state.strand().into_iter().enumerate() {
        let rod = strand.rocker().point([0.3, 0.0].into()).value - strand.coupler().position;
        // Positions of about 20 m are rounded to 4e-15 m.
        assert!((rod.norm() - (0.35 + 0.001 * i as f64)).abs() <= 1e-14, "{i}");
    }
    let single = Curtain::<f32>::with_defaults().solve_for_end().solve(0.3).unwrap().output().value;
    let double = Curtain::default().solve_for_end().solve(0.3).unwrap().output().value;
    assert!((f64::from(single.x) - double.x).abs() <= 1e-5 && (f64::from(single.y) - double.y).abs() <= 1e-5);
}

of_four_bars! {
    /// A four-bar that moves from one position to another, beside one at rest and a rotating wheel.
    Switch {
        ground { point O = (0m, 0m); point C = (400mm, 0m); point P = (1m, 0m); point Q = (1400mm, 0m); }
        part set = FourBar(ground.O, ground.C);
        let later = 24deg;
        drive position = drive_angle(set.crank, if t < 0.5s { 20deg } else { later });
        part still = FourBar(ground.P, ground.Q);
        drive hold = drive_angle(still.crank, 20deg);
        body wheel { }
        joint axle = revolute(ground.O, wheel.position);
        drive motor = drive_angle(wheel, 1rad_s * t);
    }
}

#[test]
fn what_jumps_does_not_rest() {
    let switch = Switch::default();
    let mut state = switch.solve(0.4).unwrap();
    switch.advance(&mut state, 0.6).unwrap();
    assert!(switch.phi(&state.q, 0.6).amax() <= 1e-15, "{}", switch.phi(&state.q, 0.6).amax());
    assert!((state.set().crank().angle - 24f64.to_radians()).abs() <= 1e-15);
}
