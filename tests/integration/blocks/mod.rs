//! Blocks stay accurate at poses where a pivot of a fixed order vanishes: blocks of two and three unknowns, solved in closed form, and
//! larger blocks, in an order chosen by the compiler. In a block of one unknown the pivot vanishes at dead points only.

mod attained;
mod pivots;

use attained::{Attained, compare};
use pivots::Pivots;
use reuleaux::{Mechanism, Real, SimdReal, State};
use reuleaux_tests::blocks::*;
use reuleaux_tests::common::declared::Declared;
use reuleaux_tests::common::twofold::Twofold;
use reuleaux_tests::samples;

/// Largest number of paths through lengths and time that are tried for each mechanism.
const WAYS: usize = 1000;

/// Poses with a vanishing pivot that must be found: in the usual run, and in `.ci/run`.
const NEEDED: [usize; 2] = [1, 2];

/// Poses after which the search ends, likewise.
const ENOUGH: [usize; 2] = [1, 4];

/// Poses along each path.
const POSES: usize = 8;

/// Largest errors of q, q̇ and q̈, as multiples of condition × ε × size.
const LIMITS: [f64; 3] = [4.0, 8.0, 8.0];

/// A mechanism with given lengths at a given time.
#[derive(Clone, Debug)]
struct Point {
    lengths: Vec<f64>,
    t: f64,
}

impl Point {
    fn between(&self, other: &Point, share: f64) -> Point {
        let between = |(a, b): (&f64, &f64)| a + share * (b - a);
        Point { lengths: self.lengths.iter().zip(&other.lengths).map(between).collect(), t: self.t + share * (other.t - self.t) }
    }
}

/// Follows paths on which pivots change sign, and compares the states at the zeros with solutions in twice the digits.
///
/// * `seed`: given, of the random paths: one with which pivots vanish early.
fn vanishing_pivots_do_no_harm<M, W, const N: usize>(
    make: impl Fn(&[f64]) -> M,
    exact: impl Fn(&[f64]) -> W,
    lengths: &[f64],
    seed: u64,
) -> Vec<usize>
where
    M: Declared + Mechanism<f64, N>,
    W: reuleaux::Equations<Twofold, N, N>,
{
    let mut pivots = Pivots::of(M::TEXT);
    let mut random = fastrand::Rng::with_seed(seed);
    let mut met = vec![0; pivots.size()];
    let mut worst = Attained::default();
    let solve = |point: &Point, near: &State<f64, N>| make(&point.lengths).solve_near(point.t, &near.q).ok();
    let start = make(lengths).solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
    let (mut here, mut state) = (Point { lengths: lengths.to_vec(), t: 0.0 }, start.clone());
    for _ in 0..WAYS {
        if met.iter().sum::<usize>() >= samples(ENOUGH[0], ENOUGH[1]) {
            break;
        }
        let there = Point { lengths: lengths.iter().map(|length| length * (0.7 + 0.6 * random.f64())).collect(), t: 6.0 * random.f64() };
        let mut before = pivots.at(&here.lengths, here.t, state.q.as_slice());
        let mut last = here.clone();
        for pose in 1..=POSES {
            let ends = [pose - 1, pose].map(|pose| here.between(&there, pose as f64 / POSES as f64));
            let Some(next) = solve(&ends[1], &state) else {
                // The loops do not close there: the next path starts from the defaults again.
                (last, state) = (Point { lengths: lengths.to_vec(), t: 0.0 }, start.clone());
                break;
            };
            let after = pivots.at(&ends[1].lengths, ends[1].t, next.q.as_slice());
            // The last pivot vanishes at dead points only, which are excluded here.
            for k in 0..met.len() - 1 {
                if before[k] * after[k] >= 0.0 {
                    continue;
                }
                let Some((point, found)) = vanishing(&mut pivots, &solve, &ends, &state, k) else { continue };
                met[k] += 1;
                let attained = compare(&exact(&point.lengths), &found);
                for (error, limit) in attained.errors.iter().zip(LIMITS) {
                    assert!(*error <= limit, "{attained:?} at {point:?}, where pivot {k} vanishes");
                }
                worst = worst.or(&attained);
            }
            (state, before) = (next, after);
            [_, last] = ends;
        }
        here = last;
    }
    println!("{} unknowns: poses at which pivot k vanishes {met:?}, worst {worst:?}", met.len());
    met
}

/// The pose between two others at which pivot k vanishes, to the last digit.
fn vanishing<const N: usize>(
    pivots: &mut Pivots,
    solve: &impl Fn(&Point, &State<f64, N>) -> Option<State<f64, N>>,
    ends: &[Point; 2],
    start: &State<f64, N>,
    k: usize,
) -> Option<(Point, State<f64, N>)> {
    let mut state = start.clone();
    let mut pivot = |point: &Point, q: &[f64]| pivots.at(&point.lengths, point.t, q)[k];
    let before = pivot(&ends[0], start.q.as_slice());
    let mut sides = [(0.0, before), (1.0, -before)];
    let mut last = None;
    for step in 0..60 {
        let [(low, at_low), (high, at_high)] = sides;
        // Every third step halves the interval, the others follow the chord; an end that stays counts half (the method of Illinois).
        let share = if step % 3 == 2 { 0.5 } else { at_low / (at_low - at_high) };
        let share = low + share * (high - low);
        let point = ends[0].between(&ends[1], share);
        state = solve(&point, &state)?;
        let value = pivot(&point, state.q.as_slice());
        if value.abs() <= 1e-14 || high - low <= f64::EPSILON {
            // At a zero of an earlier pivot this one has a pole.
            return (value.abs() <= 1e-12 && state.condition < 1.0 / f64::ROOT_EPSILON.sqrt()).then_some((point, state));
        }
        let side = usize::from((value > 0.0) != (at_low > 0.0));
        sides[side] = (share, value);
        if last.replace(side) == Some(side) {
            sides[1 - side].1 *= 0.5;
        }
    }
    None
}

macro_rules! meets_vanishing_pivots {
    ($($test:ident: $name:ident ($($length:ident),*), $size:literal unknowns, seed $seed:literal;)*) => { $(
        #[test]
        fn $test() {
            fn make<T: Real>(lengths: &[f64]) -> $name<T> {
                let mut lengths = lengths.iter();
                $name { $($length: T::of(*lengths.next().unwrap())),* }
            }
            assert_eq!($name::<f64>::PLAN.blocks().max(), Some($size));
            let defaults = $name::default();
            let met = vanishing_pivots_do_no_harm(make::<f64>, make::<Twofold>, &[$(defaults.$length),*], $seed);
            assert!(met.iter().sum::<usize>() >= samples(NEEDED[0], NEEDED[1]), "pivots vanished {met:?} times");
        }
    )* };
}

meets_vanishing_pivots! {
    in_a_block_of_two: Loop (crank_length, coupler_length, rocker_length), 2 unknowns, seed 1;
    in_a_block_of_three: Plate (rod_1, rod_2, rod_3), 3 unknowns, seed 2;
    in_a_block_of_four: TwoPlates (rod_1, rod_2, rod_3, rod_4), 4 unknowns, seed 4;
    in_a_block_of_four_angles: Triad (bar_1_length, bar_2_length, bar_3_length), 4 unknowns, seed 1;
    in_a_block_of_five: ThreePlates (rod_1, rod_2, rod_3, rod_4, rod_5), 5 unknowns, seed 2;
    in_a_block_of_six: FourPlates (rod_1, rod_2, rod_3, rod_4, rod_5, rod_6), 6 unknowns, seed 1;
    in_a_block_of_six_angles: DoubleTriad (bar_1_length, bar_2_length, bar_3_length, bar_4_length), 6 unknowns, seed 19;
    in_a_block_of_eight: SixPlates (rod_1, rod_2, rod_3, rod_4, rod_5, rod_6, rod_7, rod_8), 8 unknowns, seed 4;
    in_a_block_of_twelve: TenPlates (rod_1, rod_2, rod_3, rod_4, rod_5, rod_6, rod_7, rod_8, rod_9, rod_10, rod_11, rod_12),
        12 unknowns, seed 12;
}

#[test]
fn single_precision_follows_double_precision() {
    let (double, single) = (SixPlates::<f64>::with_defaults(), SixPlates::<f32>::with_defaults());
    let times = || (0..=60).map(|step| f64::from(step) / 10.0);
    let singles = single.sweep(times().map(|t| t as f32));
    for (exact, found) in double.sweep(times()).zip(singles) {
        let (exact, found) = (exact.unwrap(), found.unwrap());
        let unit = exact.condition * f64::from(f32::EPSILON);
        let error = |exact: &[f64], found: &[f32], least: f64| {
            let size = exact.iter().fold(least, |size, value| size.max(value.abs()));
            exact.iter().zip(found).fold(0.0, |error: f64, (a, b)| error.max((a - f64::from(*b)).abs())) / (size * unit)
        };
        let errors = [
            error(exact.q.as_slice(), found.q.as_slice(), 1.0),
            error(exact.qd.as_slice(), found.qd.as_slice(), 0.0),
            error(exact.qdd.as_slice(), found.qdd.as_slice(), 0.0),
        ];
        assert!(errors.iter().all(|error| *error <= 16.0), "{errors:?} at {}", exact.t);
        assert_eq!(exact.branch, found.branch);
    }
}
