//! Ten thousand states that are none, or nearly one, or one of another time: each is refused, or a solution is within the radius.

use reuleaux::nalgebra::SVector;
use reuleaux::{Enclosure, Family, Mechanism, Stages, State};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{decimals, file, list, number};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::Dyad;

/// For each reference state.
const TRIALS: usize = 60;

#[derive(Default)]
struct Count {
    asked: usize,
    refused: usize,
    /// A solution is within the radius.
    right: usize,
    /// None is.
    wrong: usize,
}

/// A sentence with the counts.
///
/// # Panics
/// If a certificate holds no solution.
pub(crate) fn count() -> String {
    let mut count = Count::default();
    of::<FourBarCrankRocker, _>("four_bar_crank_rocker", &mut count);
    of::<SliderCrank, _>("slider_crank", &mut count);
    of::<QuickReturn, _>("quick_return", &mut count);
    of::<TheoJansenLeg, _>("theo_jansen_leg", &mut count);
    of::<HydraulicLoader, _>("hydraulic_loader", &mut count);
    of::<TwoStageGearTrain, _>("two_stage_gear_train", &mut count);
    out_of_reach(&mut count);
    let Count { asked, refused, right, wrong } = count;
    assert_eq!(wrong, 0, "certificates without a solution");
    format!(
        "Of {asked} states moved away from a solution, in position or in time, or of a dyad out of reach by 10⁻¹ to 10⁻¹³ of its length, \
         {refused} were refused; of the {right} that were certified, each has a solution within the radius told.\n"
    )
}

/// Numbers between 0 and 1, the same in every run.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Whether a solution is within these distances of a position, but for some last digits.
fn holds<const N: usize>(q: &SVector<f64, N>, within: &SVector<f64, N>, solution: &[Decimal], digits: f64) -> bool {
    q.iter().zip(within).zip(solution).all(|((x, within), entry)| entry.error_of(*x) <= within + digits * (1.0 + x.abs()))
}

/// States beside those of a reference.
fn of<M, const N: usize>(name: &str, count: &mut Count)
where
    M: Declared + Default + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let (mechanism, file, mut chance) = (M::default(), file(&format!("mechanisms/{name}.json")), Chance(7));
    let states = list(&file["states"]);
    for (index, reference) in states.iter().enumerate() {
        let solution = decimals(&reference["q"]);
        let doubles: Vec<f64> = solution.iter().map(|entry| entry.value).collect();
        for trial in 0..TRIALS {
            let mut state: State<f64, N> = State::new(number(&reference["t"]), vector(&doubles), SVector::zeros(), SVector::zeros());
            let size = 10.0_f64.powf(-15.0 * chance.next());
            // A state at another reference time is held against the solution there.
            let other = &states[(index + 1 + trial) % states.len()];
            match trial % 6 {
                0..=2 => state.q.iter_mut().for_each(|x| *x += size * (chance.next() - 0.5)),
                3 => state.q[(chance.next() * N as f64) as usize] += size,
                4 => state.t += size,
                _ => state.t = number(&other["t"]),
            }
            count.asked += 1;
            let Ok(certificate) = mechanism.certify(&state) else {
                count.refused += 1;
                continue;
            };
            let within = &certificate.within.q;
            let there = decimals(&other["q"]);
            let known = match trial % 6 {
                0..=3 => Some(&solution),
                4 => None,
                _ => Some(&there),
            };
            let is_there = known.is_some_and(|solution| holds(&state.q, within, solution, f64::EPSILON)) || {
                let found = mechanism.solve_near(state.t, &state.q);
                let bare = |q: &SVector<f64, N>| q.iter().map(|&value| Decimal { value, rest: 0.0 }).collect::<Vec<_>>();
                found.is_ok_and(|found| holds(&state.q, within, &bare(&found.q), 1e-12))
            };
            if is_there { count.right += 1 } else { count.wrong += 1 }
        }
    }
}

/// Bars that are too short, or one too long, by the triangle inequality: there is no solution at all.
fn out_of_reach(count: &mut Count) {
    let mut chance = Chance(3);
    for _ in 0..1500 {
        let (a, b) = (0.5 + chance.next(), 0.2 + 0.2 * chance.next());
        let gap = 10.0_f64.powf(-1.0 - 12.0 * chance.next());
        let is_folded = chance.next() < 0.5;
        let d = if is_folded { (a - b) * (1.0 - gap) } else { (a + b) * (1.0 + gap) };
        let dyad = Dyad { bar1_B_x: a, bar2_C_x: b, c0: d, c1: 1.0 };
        let off = gap.sqrt() * (chance.next() - 0.5);
        let second = if is_folded { std::f64::consts::PI - off } else { -off };
        let guess = [0.0, 0.0, off, a * off.cos(), a * off.sin(), second, d, 0.0, 0.0];
        let state = State::new(0.0, vector(&guess), SVector::zeros(), SVector::zeros());
        count.asked += 1;
        if dyad.certify(&state).is_ok() { count.wrong += 1 } else { count.refused += 1 }
    }
}
