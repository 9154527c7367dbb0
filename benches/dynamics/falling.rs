//! D5: Bricard's linkage. D6: the heavy top. Their accelerations, as an integrator asks for them.

use reuleaux::{Dynamics, Integrator, Real};
use reuleaux_benches::multibody::forces::solved;
use reuleaux_benches::multibody::{applied, product, transposed};
use reuleaux_benches::released::{bricard, top};
use reuleaux_tests::common::reference::{Value, file, list, text};
use reuleaux_tests::common::twofold::Twofold;

use crate::case::{ACCELERATIONS, Case, Entry, HAND_ACCELERATIONS, STATES, exact_in};

pub(crate) fn cases() -> [Case; 2] {
    [linkage(), heavy_top()]
}

/// States that are known with 25 digits, but for the beginning.
fn linkage() -> Case {
    let known = file("bricard.json");
    let number = |state: &Value, name: &str| text(&state[name]).parse::<f64>().unwrap_or_else(|error| panic!("{error}"));
    let known: Vec<[f64; 3]> =
        list(&known["states"])[1..].iter().map(|state| ["a", "a_dot", "a_ddot"].map(|name| number(state, name))).collect();
    let inputs: Vec<[f64; 2]> = (0..STATES).map(|k| [known[k % known.len()][0], known[k % known.len()][1]]).collect();
    let states = inputs.iter().map(|&[start, speed]| {
        let mechanism = bricard::Bricard { start, speed };
        (mechanism, mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")))
    });
    Case {
        name: "D5 Bricard's linkage".to_owned(),
        exact: exact_in(1, move |k| vec![known[k % known.len()][2]]),
        given: None,
        entries: vec![
            Entry::new(
                HAND_ACCELERATIONS,
                inputs.clone(),
                |[a, rate]| bricard::ByHand::turning(*a, *rate),
                |_, [turning, _]| vec![*turning],
            ),
            Entry::new(
                ACCELERATIONS,
                states.collect(),
                |(mechanism, state)| mechanism.accelerations(&state.q, &state.qd, state.t),
                |_, found| found.iter().map(|found| found[0]).collect(),
            ),
        ],
    }
}

/// A quaternion and its rates.
type Turn = [[f64; 4]; 2];

/// States of its motion.
fn heavy_top() -> Case {
    let mechanism = top::Top::default();
    let times = (0..STATES).map(|k| top::DURATION * k as f64 / STATES as f64);
    let swept: Result<Vec<_>, _> = mechanism.sweep(times, Integrator::new(1e-9)).collect();
    let states = swept.unwrap_or_else(|stopped| panic!("{stopped}"));
    let inputs: Vec<Turn> =
        states.iter().map(|state| [&state.q, &state.qd].map(|vector| [vector[3], vector[4], vector[5], vector[6]])).collect();
    let known = inputs.clone();
    let exact = exact_in(1, move |k| turning(&known[k]).map(|entry| entry.high).to_vec());
    let seen = |[q, _]: &Turn, found: [f64; 4]| spin(q.map(Twofold::of), found.map(Twofold::of)).map(|entry| entry.high).to_vec();
    let turns = inputs.clone();
    Case {
        name: "D6 heavy top".to_owned(),
        exact,
        given: None,
        entries: vec![
            Entry::new(HAND_ACCELERATIONS, inputs, |[q, rates]| top::ByHand::turning(*q, *rates), move |turn, found| seen(turn, *found)),
            Entry::new(
                ACCELERATIONS,
                states.into_iter().zip(turns).collect(),
                move |(state, _)| mechanism.accelerations(&state.q, &state.qd, state.t),
                move |(_, turn), found| found.iter().flat_map(|found| seen(turn, (*found).into())).collect(),
            ),
        ],
    }
}

type Triple = [Twofold; 3];

fn cross(a: Triple, b: Triple) -> Triple {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i] * b[j] - a[j] * b[i])
}

/// 2 ṗ p* / p², but for its first component: ω from the rates of a quaternion, and ω̇ from its accelerations.
fn spin([w, x, y, z]: [Twofold; 4], [dw, dx, dy, dz]: [Twofold; 4]) -> Triple {
    let (of, by) = ([x, y, z], [dx, dy, dz]);
    let size = w * w + x * x + y * y + z * z;
    let turned = cross(by, of);
    std::array::from_fn(|k| Twofold::of(2.0) * (by[k] * w - of[k] * dw - turned[k]) / size)
}

/// J ω̇ = τ − ω × J ω in ground.
fn turning(turn: &Turn) -> Triple {
    let [q, rates] = turn.map(|entries| entries.map(Twofold::of));
    let [w, x, y, z] = q;
    let size = w * w + x * x + y * y + z * z;
    let vector = [x, y, z];
    let turned = [[Twofold::of(0.0), -z, y], [z, Twofold::of(0.0), -x], [-y, x, Twofold::of(0.0)]];
    let matrix: [[Twofold; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let own = if i == j { w * w - x * x - y * y - z * z } else { Twofold::of(0.0) };
            (own + Twofold::of(2.0) * (vector[i] * vector[j] + w * turned[i][j])) / size
        })
    });
    let [across, about, weight] = top::NUMBERS.map(Twofold::of);
    let zero = Twofold::of(0.0);
    let inertia = product(product(matrix, [[across, zero, zero], [zero, about, zero], [zero, zero, across]]), transposed(matrix));
    let omega = spin(q, rates);
    let axis = matrix.map(|row| row[1]);
    let (torque, gyro) = (cross(axis, [zero, zero, -weight]), cross(omega, applied(inertia, omega)));
    let rows = (0..3).map(|i| [&inertia[i][..], &[torque[i] - gyro[i]]].concat()).collect();
    solved(rows).try_into().unwrap_or_else(|_| panic!("three numbers"))
}
