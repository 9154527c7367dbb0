//! D2: N four-bars in a row, all bars 1 m and 1 kg, released; N + 1 cranks V and N couplers H.

use reuleaux::nalgebra::Vector2;
use reuleaux::{Dynamics, SimdReal};
use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::multibody::{Cut, Joint, Model};

use crate::case::{ACCELERATIONS, BOTH, Case, Entry, Given, HAND, LOADS, STATES, exact_in};

const GRAVITY: f64 = 9.81;

/// States in which the longest chain is compared: the dense system takes its time.
const FEW: usize = 4;

macro_rules! chain {
    ($name:ident, $state:ident, $loops:literal, $module:ident) => {
        pub(crate) mod $module {
            use super::*;
            use reuleaux_benches::released::chain::{$name, $state};

            pub(crate) fn case() -> Case {
                let at = |k: usize| {
                    let (sine, cosine) = (std::f64::consts::TAU * k as f64 / STATES as f64).sin_cos();
                    let start = std::f64::consts::FRAC_PI_2 + 0.4 * sine;
                    let mechanism = $name { start, speed: 0.4 * std::f64::consts::TAU * cosine };
                    (mechanism, mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")))
                };
                let states: Vec<($name, $state<f64>)> = (0..STATES).map(at).collect();
                const BARS: usize = 2 * $loops + 1;
                // In the order V0, H1, V1, H2, …
                let bars = |vector: &[f64]| -> [f64; BARS] {
                    std::array::from_fn(|k| vector[3 * (if k % 2 == 0 { k / 2 } else { $loops + 1 + k / 2 }) + 2])
                };
                let inputs: Vec<[[f64; BARS]; 2]> =
                    states.iter().map(|(_, state)| [bars(state.q.as_slice()), bars(state.qd.as_slice())]).collect();
                let given = inputs.iter().map(|bars| bars.map(|bars| super::relative(&bars)).to_vec()).collect();
                let every = if $loops > 10 { STATES / FEW } else { STATES / 16 };
                let known = inputs.clone();
                let exact = exact_in(every, move |k| super::exact($loops, &known[k][0], &known[k][1]));
                let with =
                    move |state: &$state<f64>, force: [f64; 2]| bars(state.qdd.as_slice()).into_iter().chain(force).collect::<Vec<f64>>();
                Case {
                    name: format!("D2 chain of {}", $loops),
                    exact,
                    given: Some(Given { model: super::model($loops), states: given }),
                    entries: vec![
                        Entry::new(
                            HAND,
                            inputs,
                            |[angle, rate]| super::released::<BARS, { $loops + 1 }>(angle, rate),
                            |_, (turning, pins)| turning.iter().copied().chain([pins[1][2].x, pins[1][2].y]).collect(),
                        ),
                        Entry::new(
                            ACCELERATIONS,
                            states.clone(),
                            |(mechanism, state)| mechanism.accelerations(&state.q, &state.qd, state.t),
                            move |_, found| found.iter().flatten().copied().take(0).collect(),
                        ),
                        Entry::new(
                            LOADS,
                            states.clone(),
                            |(mechanism, state)| mechanism.loads(state),
                            move |(_, state), loads| with(state, loads.right_0().force.into()),
                        ),
                        Entry::new(
                            BOTH,
                            states,
                            |(mechanism, state)| mechanism.accelerate_with_loads(state).unwrap_or_else(|stopped| panic!("{stopped}")),
                            move |(_, state), loads| with(state, loads.right_0().force.into()),
                        ),
                    ],
                }
            }
        }
    };
}

chain!(ChainOf2, ChainOf2State, 2, of_2);
chain!(ChainOf10, ChainOf10State, 10, of_10);
chain!(ChainOf40, ChainOf40State, 40, of_40);

/// Each coupler hangs on the crank before it.
fn model(loops: usize) -> Model {
    let mut model = Model::new("chain");
    model.gravity = [0.0, -GRAVITY, 0.0];
    let inertia = [1e-3, 1.0 / 12.0, 1.0 / 12.0];
    for k in 0..=2 * loops {
        let (parent, x) = if k % 2 == 0 { (None, (k / 2) as f64) } else { (Some(k - 1), 1.0) };
        let body = model.hang("bar", parent, &[Joint::Turn(2)], &[0.0]);
        (body.place, body.center, body.inertia) = ([x, 0.0, 0.0], [0.5, 0.0, 0.0], inertia);
    }
    model.cuts = (0..loops).map(|j| Cut::Meet((Some(2 * j + 1), [1.0, 0.0, 0.0]), (Some(2 * j + 2), [1.0, 0.0, 0.0]))).collect();
    model
}

/// Angles of couplers against their cranks.
fn relative(bars: &[f64]) -> Vec<f64> {
    (0..bars.len()).map(|k| if k % 2 == 0 { bars[k] } else { bars[k] - bars[k - 1] }).collect()
}

/// Angular accelerations and the force on the second crank from its first coupler.
fn exact(loops: usize, angle: &[f64], rate: &[f64]) -> Vec<f64> {
    let model = model(loops);
    let found = reaction(&model, &relative(angle), &relative(rate), &[]);
    let turning = found.bodies.iter().map(|numbers| numbers[23]);
    turning.chain([-found.cuts[0][0], -found.cuts[0][1]]).collect()
}

/// Loop after loop for a unit motion of the first crank and for the motion at hand, one mass, and back again with the forces: of each crank
/// the one on it from ground, that on the coupler which begins at it, and that on it from the coupler which ends there.
#[inline(always)]
fn released<const BARS: usize, const CRANKS: usize>(angle: &[f64; BARS], rate: &[f64; BARS]) -> ([f64; BARS], [[Vector2<f64>; 3]; CRANKS]) {
    let zero = Vector2::zeros();
    let (mut e, mut n) = ([zero; BARS], [zero; BARS]);
    for k in 0..BARS {
        let (sine, cosine) = angle[k].fast_sin_cos();
        (e[k], n[k]) = (Vector2::new(cosine, sine), Vector2::new(-sine, cosine));
    }
    let square = rate.map(|rate| rate * rate);
    let (mut unit, mut bias, mut per) = ([0.0; BARS], [0.0; BARS], [0.0; CRANKS]);
    unit[0] = 1.0;
    let mut mass = 1.0 / 3.0;
    let mut moment = 0.5 * GRAVITY * e[0].x;
    for (j, per) in per.iter_mut().enumerate().skip(1) {
        let (a, h, v) = (2 * j - 2, 2 * j - 1, 2 * j);
        *per = 1.0 / n[h].dot(&e[v]);
        let from = n[a] * -unit[a];
        (unit[h], unit[v]) = (from.dot(&e[v]) * *per, from.dot(&e[h]) * *per);
        let from = e[a] * square[a] + e[h] * square[h] - e[v] * square[v] - n[a] * bias[a];
        (bias[h], bias[v]) = (from.dot(&e[v]) * *per, from.dot(&e[h]) * *per);
        let center = n[a] * unit[a] + n[h] * (0.5 * unit[h]);
        let pull = n[a] * bias[a] - e[a] * square[a] + (n[h] * bias[h] - e[h] * square[h]) * 0.5 + Vector2::new(0.0, GRAVITY);
        mass += center.norm_squared() + unit[h] * unit[h] * (1.0 / 12.0) + unit[v] * unit[v] * (1.0 / 3.0);
        moment += center.dot(&pull) + unit[h] * bias[h] * (1.0 / 12.0) + unit[v] * (bias[v] * (1.0 / 3.0) + 0.5 * GRAVITY * e[v].x);
    }
    let turning = -moment / mass;
    let mut found = [0.0; BARS];
    for k in 0..BARS {
        found[k] = unit[k] * turning + bias[k];
    }
    let mut pins = [[zero; 3]; CRANKS];
    let mut next = zero;
    let inertial = |k: usize| (n[k] * found[k] - e[k] * square[k]) * 0.5 + Vector2::new(0.0, GRAVITY);
    for j in (1..CRANKS).rev() {
        let (a, h, v) = (2 * j - 2, 2 * j - 1, 2 * j);
        let of_coupler = inertial(h) + n[a] * found[a] - e[a] * square[a];
        let of_crank = found[v] * (1.0 / 3.0) + 0.5 * GRAVITY * e[v].x + n[v].dot(&next);
        let about = -(0.5 * n[h].dot(&of_coupler) + found[h] * (1.0 / 12.0));
        let f = (e[v] * about - e[h] * of_crank) * per[j];
        let g = of_coupler + f;
        pins[j] = [inertial(v) - f + next, next, f];
        next = g;
    }
    pins[0] = [inertial(0) + next, next, zero];
    (found, pins)
}
