//! Certificates requested for states that are no solutions: either a true solution lies within the radius, or there is no certificate.

use reuleaux::nalgebra::SVector;
use reuleaux::{Doubt, Enclosure, Family, Mechanism, Stages, State};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{decimals, file, list, number, numbers};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::*;

/// True if a solution lies within these distances of a position, up to the accuracy of the reference.
fn holds<const N: usize>(q: &SVector<f64, N>, within: &SVector<f64, N>, solution: &[Decimal]) -> bool {
    let size = solution.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
    q.iter().zip(within).zip(solution).all(|((x, within), entry)| entry.error_of(*x) <= within + f64::EPSILON * size)
}

/// Numbers of certified and of requested states.
#[derive(Default)]
struct Count {
    certified: usize,
    asked: usize,
}

/// Reference positions and times with random offsets.
fn none_is_certified_wrongly<M, const N: usize>(name: &str, count: &mut Count)
where
    M: Declared + Default + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let mut random = fastrand::Rng::with_seed(11);
    let (mechanism, file) = (M::default(), file(&format!("mechanisms/{name}.json")));
    let states = list(&file["states"]);
    let assemblies: Vec<Vec<Decimal>> = file["other_assemblies_at_t0"].as_array().into_iter().flatten().map(decimals).collect();
    for (index, reference) in states.iter().enumerate() {
        let solution = decimals(&reference["q"]);
        let doubles: Vec<f64> = solution.iter().map(|entry| entry.value).collect();
        for trial in 0..8 {
            let mut state: State<f64, N> = State::new(number(&reference["t"]), vector(&doubles), SVector::zeros(), SVector::zeros());
            // Near, far, or with the time of the next state.
            let size = 10.0_f64.powf(random.f64() * 15.0 - 15.0);
            match trial {
                0..=4 => state.q.iter_mut().for_each(|x| *x += size * (random.f64() - 0.5)),
                5 => state.q[random.usize(0..N)] += size,
                6 => state.t += size,
                _ => state.t = number(&states[(index + 1) % states.len()]["t"]),
            }
            count.asked += 1;
            let Ok(certificate) = mechanism.certify(&state) else { continue };
            count.certified += 1;
            let within = &certificate.within.q;
            if trial < 6 && holds(&state.q, within, &solution) {
                // Exactly one solution: the other known assemblies are outside.
                let others = if index == 0 { &assemblies[..] } else { &[] };
                assert!(!others.iter().any(|other| holds(&state.q, within, other)), "{name}: two solutions within {within}");
                continue;
            }
            // Another solution, found independently.
            let found = mechanism.solve_near(state.t, &state.q).unwrap_or_else(|failure| panic!("{name}: none found: {failure}"));
            let bare: Vec<Decimal> = found.q.iter().map(|&value| Decimal { value, rest: 0.0 }).collect();
            assert!(holds(&state.q, &within.map(|within| within + 1e-12), &bare), "{name} at {}: {} ± {within}", state.t, state.q);
        }
    }
}

#[test]
fn what_is_certified_is_there() {
    let mut count = Count::default();
    none_is_certified_wrongly::<FourBarCrankRocker, _>("four_bar_crank_rocker", &mut count);
    none_is_certified_wrongly::<SliderCrank, _>("slider_crank", &mut count);
    none_is_certified_wrongly::<QuickReturn, _>("quick_return", &mut count);
    none_is_certified_wrongly::<TheoJansenLeg, _>("theo_jansen_leg", &mut count);
    none_is_certified_wrongly::<HydraulicLoader, _>("hydraulic_loader", &mut count);
    none_is_certified_wrongly::<TwoStageGearTrain, _>("two_stage_gear_train", &mut count);
    println!("{} of {} were certified", count.certified, count.asked);
    assert!(count.certified > count.asked / 4 && count.certified < count.asked);
}

/// States of a mechanism that closes, certified for one that just fails to close.
#[test]
fn nothing_is_certified_out_of_reach() {
    let mut random = fastrand::Rng::with_seed(5);
    for trial in 0..400 {
        // Beyond or within reach of the dyad by a fraction of 10⁻¹ to 10⁻¹² of its length; and the same in the folded position.
        let (a, b) = (0.5 + random.f64(), 0.2 + 0.2 * random.f64());
        let gap = 10.0_f64.powf(-1.0 - 11.0 * random.f64());
        let is_out = trial % 2 == 0;
        let beyond = if is_out { gap } else { -gap };
        let (d, folded) = if random.bool() { ((a + b) * (1.0 + beyond), false) } else { ((a - b) * (1.0 - beyond), true) };
        let dyad = Dyad { bar1_B_x: a, bar2_C_x: b, c0: d, c1: 1.0 };
        // The position nearest to a solution.
        let cosine = ((a * a - b * b + d * d) / (2.0 * a * d)).min(1.0);
        let (first, second) = (cosine.acos(), if folded { std::f64::consts::PI } else { 0.0 });
        let (sine, cosine) = first.sin_cos();
        let rest = if folded { second + (a / b * sine).min(1.0).asin() } else { -(a / b * sine).min(1.0).asin() };
        let guess = [0.0, 0.0, first, a * cosine, a * sine, rest, d, 0.0, 0.0];
        let state = State::new(0.0, vector(&guess), SVector::zeros(), SVector::zeros());
        let certified = dyad.certify(&state);
        if is_out {
            assert!(certified.is_err(), "gap {gap:e}: {certified:?}");
            assert!(matches!(certified, Err(Doubt::NoSolution(_))));
        } else {
            assert!(certified.is_ok(), "gap {gap:e}, {folded}: {certified:?}");
        }
    }
}

/// A state of one parameter set is no solution for another.
#[test]
fn states_of_other_parameters_are_not_certified_as_they_are() {
    for (family, coordinate) in [("dead_point", 2), ("unit_ratio", 5)] {
        for case in list(&file(&format!("stress/{family}.json"))["cases"]) {
            let (t, guess) = (number(&case["t"]), numbers(&case["initial_guess"]));
            let radius = if family == "dead_point" {
                let right = of::<RockerDrivenFourBar>(&case["model"]);
                let Ok(state) = right.solve_near(t, &vector(&guess)) else { continue };
                RockerDrivenFourBar { crank_B_x: right.crank_B_x * 1.001, ..right }.certify(&state).map(|found| found.within.q[coordinate])
            } else {
                let right = of::<InLineSliderCrank>(&case["model"]);
                let Ok(state) = right.solve_near(t, &vector(&guess)) else { continue };
                InLineSliderCrank { rod_B_x: right.rod_B_x * 1.001, ..right }.certify(&state).map(|found| found.within.q[coordinate])
            };
            // The solution has moved by about this much, and the radius is as large.
            assert!(radius.is_err() || radius.is_ok_and(|radius| radius > 1e-5), "{family}: {radius:?}");
        }
    }
}
