//! Verification that steps stay on their branch: random steps of random sizes, compared with continuation with proof.

pub mod families;
pub mod track;

use fastrand::Rng;
use reuleaux::State;
use reuleaux::nalgebra::SVector;

use families::{Family, Sample, index};
use track::{End, Place};

/// Results of random steps.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Number of mechanisms.
    pub mechanisms: usize,
    /// Mechanisms whose start was not found, although the guess was exact.
    pub lost: usize,
    /// Number of steps tried.
    pub steps: usize,
    /// Successful steps with the right result.
    pub right: usize,
    /// Failed steps, where the branch ends.
    pub ended: usize,
    /// Undecided steps: the branch passes closer to a singular position than doubles resolve.
    pub unclear: usize,
    /// Successful steps to another branch or another turn, or beyond the end of the branch.
    pub jumps: Vec<String>,
    /// Successful steps on the right branch, with an error beyond rounding.
    pub off: Vec<String>,
    /// Failed steps, although the branch continues.
    pub refused: Vec<String>,
}

impl Tally {
    /// True if there is no jump, no wrong digit and no lost start, and at most one step in `most` failed although the branch continues.
    #[must_use]
    pub fn is_good(&self, most: usize) -> bool {
        self.jumps.is_empty() && self.off.is_empty() && self.lost == 0 && self.refused.len() * most <= self.steps
    }
}

/// Indices of the coordinates that are compared.
struct Watched<M, const N: usize> {
    angles: Vec<usize>,
    origins: Vec<[usize; 2]>,
    family: std::marker::PhantomData<M>,
}

/// Largest rounding error, in ε times the size over the clearance.
const ROUNDINGS: f64 = 1e4;

/// Steps are not judged if another branch is closer than the size over this.
const NARROW: f64 = 1e7;

impl<M: Family<N>, const N: usize> Watched<M, N> {
    fn new(sample: &Sample<M, N>) -> Self {
        let at = |body: &String, name: &str| index::<M, N>(body, name);
        let angles = sample.bodies.iter().map(|body| at(body, "angle")).collect();
        let origins = sample.origins.iter().map(|(body, _)| [at(body, "x"), at(body, "y")]).collect();
        Self { angles, origins, family: std::marker::PhantomData }
    }

    /// Largest differences of positions (rad, m) and of rates.
    fn difference(&self, sample: &Sample<M, N>, state: &State<f64, N>, place: &Place<2>) -> [f64; 2] {
        let distances = &sample.distances;
        let rates = distances.rates(&place.z, place.t).unwrap_or_default();
        let mut most = [0.0_f64; 2];
        let mut add = |off: f64, off_rate: f64| {
            for (most, off) in most.iter_mut().zip([off, off_rate]) {
                *most = if off.is_nan() { f64::INFINITY } else { most.max(off.abs()) };
            }
        };
        for ((&i, arm), angle) in self.angles.iter().zip(&distances.arms).zip(&place.angles) {
            let (way, rate) = (arm.at(&place.z, place.t), arm.rate(&rates, place.t));
            add(state.q[i] - angle, state.qd[i] - (way.x * rate.y - way.y * rate.x) / (way.x * way.x + way.y * way.y));
        }
        for ([x, y], (_, way)) in self.origins.iter().zip(&sample.origins) {
            let (there, rate) = (way.at(&place.z, place.t), way.rate(&rates, place.t));
            add(state.q[*x] - there.x, state.qd[*x] - rate.x);
            add(state.q[*y] - there.y, state.qd[*y] - rate.y);
        }
        most
    }
}

/// Takes random steps with mechanisms of a family until this number is reached.
pub fn try_steps<M: Family<N>, const N: usize>(random: &mut Rng, steps: usize, tally: &mut Tally) {
    let limit = tally.steps + steps;
    while tally.steps < limit {
        let seed = random.u64(..);
        if let Some(sample) = M::random(&mut Rng::with_seed(seed)) {
            try_sample(&sample, seed, random, tally);
        }
    }
}

/// Number of steps with one mechanism.
const STEPS: usize = 40;

fn try_sample<M: Family<N>, const N: usize>(sample: &Sample<M, N>, seed: u64, random: &mut Rng, tally: &mut Tally) {
    let watched = Watched::new(sample);
    tally.mechanisms += 1;
    let mut place = sample.start.clone();
    let Some(mut state) = start(sample, &watched, &place, &sample.guess) else {
        tally.lost += 1;
        return;
    };
    for _ in 0..STEPS {
        tally.steps += 1;
        // Steps between a ten-thousandth of a period and half a period.
        let size = (1e-4_f64.ln() + random.f64() * (0.5_f64 / 1e-4).ln()).exp();
        let h = if random.bool() { size } else { -size };
        let t = state.t + h;
        let mut there = state.clone();
        let made = sample.mechanism.advance(&mut there, t);
        let label = || format!("{} of seed {seed}: from {:?} s by {h:?} s", M::TITLE, state.t);
        match (made, sample.distances.follow(&place, t)) {
            (_, End::Unknown) => tally.unclear += 1,
            (Err(_), End::Singular { .. }) => tally.ended += 1,
            (Ok(()), End::Singular { t }) => {
                tally.jumps.push(format!("{}, made, and the branch ends at {t:?} s", label()));
            }
            (Err(_), End::There { clearance, .. }) if clearance * NARROW < 1.0 => tally.unclear += 1,
            (Err(failure), End::There { place: reached, clearance }) => {
                tally.refused.push(format!("{}, clearance {clearance:.1e}: {failure}", label()));
                // Continues from the proven position.
                if let Some(found) = resumed(sample, &watched, &reached) {
                    (state, place) = (found, reached);
                }
            }
            (Ok(()), End::There { place: reached, clearance }) => {
                let [off, off_rate] = watched.difference(sample, &there, &reached);
                let here = sample.distances.clearance(&reached.z, t);
                let rounding = ROUNDINGS * f64::EPSILON * (1.0 + 1.0 / here);
                let speed = 1.0 + there.qd.amax();
                if off > (0.5 * here).max(rounding) {
                    tally.jumps.push(format!("{}, off by {off:.2e}, clearance {clearance:.1e}", label()));
                } else if off > rounding || off_rate > rounding * speed * (1.0 + 1.0 / here) {
                    tally.off.push(format!("{}, off by {off:.2e} and {off_rate:.2e}, clearance there {here:.1e}", label()));
                } else {
                    tally.right += 1;
                    (state, place) = (there, reached);
                    continue;
                }
                if let Some(found) = resumed(sample, &watched, &reached) {
                    (state, place) = (found, reached);
                }
            }
        }
    }
}

/// A solved state at a known position.
fn resumed<M: Family<N>, const N: usize>(sample: &Sample<M, N>, watched: &Watched<M, N>, place: &Place<2>) -> Option<State<f64, N>> {
    let mut guess = sample.guess;
    for (&i, angle) in watched.angles.iter().zip(&place.angles) {
        guess[i] = *angle;
    }
    for ([x, y], (_, way)) in watched.origins.iter().zip(&sample.origins) {
        (guess[*x], guess[*y]) = (way.at(&place.z, place.t).x, way.at(&place.z, place.t).y);
    }
    start(sample, watched, place, &guess)
}

fn start<M: Family<N>, const N: usize>(
    sample: &Sample<M, N>,
    watched: &Watched<M, N>,
    place: &Place<2>,
    guess: &SVector<f64, N>,
) -> Option<State<f64, N>> {
    let state = sample.mechanism.solve_near(place.t, guess).ok()?;
    let [off, _] = watched.difference(sample, &state, place);
    (off < 1e-6).then_some(state)
}
