//! D2: a four-bar that is released: ground 4, crank 1, coupler 3.5, rocker 3 m, of bars that weigh a kilogram a metre. D3: the same with a
//! crank that turns at constant speed.

use reuleaux::nalgebra::Vector2;
use reuleaux::{Dynamics, SimdReal};
use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::released::four_bar::{Driven, DrivenState, FourBar, FourBarState, GRAVITY, LENGTHS, model};

use crate::case::{ACCELERATIONS, BOTH, Case, Entry, Given, HAND, HAND_ANGLES, HAND_DRIVEN, LOADS, STATES, STEP, exact_in};

/// Angles and speeds of the three bars.
type Bars = [[f64; 3]; 2];

/// Angular accelerations of the bars, forces on crank, coupler, rocker (from the coupler) and rocker (from ground).
type Found = ([f64; 3], [Vector2<f64>; 4]);

pub(crate) fn cases() -> Vec<Case> {
    let model = model();
    let states = states();
    let bars = |state: &FourBarState<f64>| [&state.q, &state.qd].map(|vector| [vector[2], vector[5], vector[8]]);
    let inputs: Vec<Bars> = states.iter().map(|(_, state)| bars(state)).collect();
    let given = inputs.iter().map(|bars| bars.map(|[a, b, c]| vec![a, b - a, c]).to_vec()).collect();
    let known = inputs.clone();
    let exact = move |k: usize| {
        let [[a, b, c], [u, v, w]] = known[k];
        let found = reaction(&model, &[a, b - a, c], &[u, v - u, w], &[]);
        let turning = found.bodies.iter().map(|numbers| numbers[23]);
        // The force on the rocker is against that on the coupler.
        turning.chain([-found.cuts[0][0], -found.cuts[0][1]]).collect()
    };
    let with = |state: &FourBarState<f64>, force: [f64; 2]| [2, 5, 8].map(|k| state.qdd[k]).into_iter().chain(force).collect::<Vec<f64>>();
    vec![Case {
        name: "D2 four-bar".to_owned(),
        exact: exact_in(1, exact),
        given: Some(Given { model: self::model(), states: given }),
        entries: vec![
            Entry::new(
                HAND,
                inputs,
                |bars| released(*bars),
                |_, (turning, pins)| turning.iter().copied().chain([pins[2].x, pins[2].y]).collect(),
            ),
            Entry::new(
                ACCELERATIONS,
                states.clone(),
                |(mechanism, state)| mechanism.accelerations(&state.q, &state.qd, state.t),
                |_, found| found.iter().flatten().copied().collect(),
            ),
            Entry::new(
                LOADS,
                states.clone(),
                |(mechanism, state)| mechanism.loads(state),
                move |(_, state), loads| with(state, loads.c().force.into()),
            ),
            Entry::new(
                BOTH,
                states,
                |(mechanism, state)| mechanism.accelerate_with_loads(state).unwrap_or_else(|stopped| panic!("{stopped}")),
                move |(_, state), loads| with(state, loads.c().force.into()),
            ),
        ],
    }]
}

/// The crank swings by 1.2 rad about 0.3 rad in a second.
fn states() -> Vec<(FourBar, FourBarState<f64>)> {
    let at = |k: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * k as f64 / STATES as f64).sin_cos();
        let mechanism = FourBar { start: 0.3 + 1.2 * sine, speed: 1.2 * std::f64::consts::TAU * cosine };
        (mechanism, mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")))
    };
    (0..STATES).map(at).collect()
}

/// Direction of a bar, the same a quarter of a turn ahead.
#[inline(always)]
fn directions(angle: f64) -> [Vector2<f64>; 2] {
    let (sine, cosine) = angle.fast_sin_cos();
    [Vector2::new(cosine, sine), Vector2::new(-sine, cosine)]
}

/// Directions of the three bars, the same a quarter of a turn ahead, and one over the sine of the angle between coupler and rocker.
#[derive(Clone, Copy)]
struct Closed {
    e: [Vector2<f64>; 3],
    n: [Vector2<f64>; 3],
    per: f64,
}

impl Closed {
    /// Of coupler and rocker, so that their ends move alike: v = l2 u2 n2 − l3 u3 n3.
    #[inline(always)]
    fn solve(&self, v: Vector2<f64>) -> [f64; 2] {
        [v.dot(&self.e[2]) * self.per / LENGTHS[1], v.dot(&self.e[1]) * self.per / LENGTHS[2]]
    }

    /// The forces at the pins and the torque on the crank, by moments about the pins of coupler and rocker; the acceleration of the coupler's
    /// centre is less gravity.
    #[inline(always)]
    fn pins(&self, squares: [f64; 3], turning: [f64; 3], coupler: Vector2<f64>) -> ([Vector2<f64>; 4], f64) {
        let ([l1, l2, l3], [e1, e2, e3], [n1, n2, n3]) = (LENGTHS, self.e, self.n);
        let p2 = coupler * l2;
        let p3 = (n3 * turning[2] - e3 * squares[2]) * (0.5 * l3 * l3) + Vector2::new(0.0, l3 * GRAVITY);
        let of_rocker = (l3 * l3 / 3.0) * turning[2] + GRAVITY * (0.5 * l3) * e3.x;
        let of_coupler = -(0.5 * n2.dot(&p2) + (l2 * l2 / 12.0) * turning[1]);
        // n3 · F and n2 · F for the force F on the rocker.
        let f = (e3 * of_coupler - e2 * of_rocker) * self.per;
        let b = p2 + f;
        let p1 = (n1 * turning[0] - e1 * squares[0]) * (0.5 * l1 * l1) + Vector2::new(0.0, l1 * GRAVITY);
        let torque = (l1 * l1 * l1 / 3.0) * turning[0] + GRAVITY * (0.5 * l1 * l1) * e1.x + l1 * n1.dot(&b);
        ([p1 + b, b, f, p3 - f], torque)
    }
}

/// The loop for a unit motion of the crank and for the motion at hand, and one mass.
#[inline(always)]
fn released([angle, rate]: Bars) -> Found {
    let [l1, l2, l3] = LENGTHS;
    let [[e1, n1], [e2, n2], [e3, n3]] = angle.map(directions);
    let closed = Closed { e: [e1, e2, e3], n: [n1, n2, n3], per: 1.0 / n2.dot(&e3) };
    let squares = rate.map(|rate| rate * rate);
    let [w1, w2, w3] = squares;
    let [u2, u3] = closed.solve(n1 * -l1);
    let [p2, p3] = closed.solve(e1 * (l1 * w1) + e2 * (l2 * w2) - e3 * (l3 * w3));
    let h = 0.5 * l2;
    let v = n1 * l1 + n2 * (h * u2);
    let (j1, j2, j3) = (l1 * l1 * l1 / 3.0, l2 * l2 * l2 / 12.0, l3 * l3 * l3 / 3.0);
    let a = e1 * (-l1 * w1) + n2 * (h * p2) - e2 * (h * w2) + Vector2::new(0.0, GRAVITY);
    let mass = j1 + l2 * v.norm_squared() + j2 * u2 * u2 + j3 * u3 * u3;
    let weight = GRAVITY * (l1 * l1 * 0.5 * e1.x + l3 * l3 * 0.5 * e3.x * u3);
    let turning = -(l2 * v.dot(&a) + j2 * u2 * p2 + j3 * u3 * p3 + weight) / mass;
    let turnings = [turning, u2 * turning + p2, u3 * turning + p3];
    (turnings, closed.pins(squares, turnings, a + v * turning).0)
}

const SPEED: f64 = 2.0;

/// Angles, angular velocities and accelerations of coupler and rocker as sine and cosine of the angles, forces, and the torque.
type Turned = ([Vector2<f64>; 2], [f64; 4], [Vector2<f64>; 4], f64);

/// The loop in closed form, from the place of the crank pin, and forces as above.
#[inline(always)]
fn driven(t: f64) -> Turned {
    let [l1, l2, l3] = LENGTHS;
    let [e1, n1] = directions(SPEED * t);
    let b = e1 * l1;
    let d = Vector2::new(4.0, 0.0) - b;
    let square = d.norm_squared();
    let along = 0.5 + (l2 * l2 - l3 * l3) / (2.0 * square);
    let across = (l2 * l2 / square - along * along).sqrt();
    let reach = d * along + Vector2::new(-d.y, d.x) * across;
    let (e2, e3) = (reach * (1.0 / l2), (reach - d) * (1.0 / l3));
    let ahead = |e: Vector2<f64>| Vector2::new(-e.y, e.x);
    let (n2, n3) = (ahead(e2), ahead(e3));
    let closed = Closed { e: [e1, e2, e3], n: [n1, n2, n3], per: 1.0 / n2.dot(&e3) };
    let [w2, w3] = closed.solve(n1 * (-l1 * SPEED));
    let squares = [SPEED * SPEED, w2 * w2, w3 * w3];
    let [a2, a3] = closed.solve(e1 * (l1 * squares[0]) + e2 * (l2 * squares[1]) - e3 * (l3 * squares[2]));
    let h = 0.5 * l2;
    let coupler = e1 * (-l1 * squares[0]) + n2 * (h * a2) - e2 * (h * squares[1]) + Vector2::new(0.0, GRAVITY);
    let (pins, torque) = closed.pins(squares, [0.0, a2, a3], coupler);
    ([e2, e3], [w2, w3, a2, a3], pins, torque)
}

/// The accelerations, forces and torque that are compared.
fn compared((_, [_, _, a2, a3], pins, torque): &Turned) -> Vec<f64> {
    vec![*a2, *a3, pins[2].x, pins[2].y, *torque]
}

/// The moment that is reached from the state of this number: to and fro by the 256th part of a turn.
fn moment(number: usize) -> [f64; 2] {
    [number, number + 1].map(|k| std::f64::consts::PI * k as f64 / STATES as f64)
}

/// D3: position, velocity, acceleration and all forces of the driven four-bar.
pub(crate) fn turning() -> Case {
    let mechanism = Driven::default();
    let states = |k: usize| (mechanism.solve(moment(k)[0]).unwrap_or_else(|failure| panic!("{failure}")), moment(k));
    let states: Vec<(DrivenState<f64>, [f64; 2])> = (0..STATES).map(states).collect();
    let model = model();
    let exact = move |k: usize| {
        let state = mechanism.solve(moment(k)[1]).unwrap_or_else(|failure| panic!("{failure}"));
        let [[a, b, c], [u, v, w]] = [&state.q, &state.qd].map(|vector| [vector[2], vector[5], vector[8]]);
        let found = reaction(&model, &[a, b - a, c], &[u, v - u, w], &[(0, 0.0)]);
        let turning = [1, 2].map(|body: usize| found.bodies[body][23]);
        turning.into_iter().chain([-found.cuts[0][0], -found.cuts[0][1], found.efforts[0]]).collect()
    };
    Case {
        name: "D3 four-bar".to_owned(),
        exact: exact_in(1, exact),
        given: None,
        entries: vec![
            Entry::new(HAND_DRIVEN, (0..STATES).map(|k| moment(k)[1]).collect(), |t| driven(*t), |_, found| compared(found)),
            Entry::new(
                HAND_ANGLES,
                (0..STATES).map(|k| moment(k)[1]).collect(),
                |t| {
                    let found = driven(*t);
                    (found, found.0.map(|e| e.y.atan2(e.x)))
                },
                |_, (found, _)| compared(found),
            ),
            Entry::new(
                STEP,
                states,
                move |(state, [from, to])| {
                    let t = if state.t == *to { *from } else { *to };
                    mechanism.advance(state, t).unwrap_or_else(|failure| panic!("{failure}"));
                    mechanism.loads(state)
                },
                |(state, _), loads| vec![state.qdd[5], state.qdd[8], loads.c().force.x, loads.c().force.y, loads.motor().effort],
            ),
        ],
    }
}
