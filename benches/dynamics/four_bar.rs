//! D2: a four-bar that is released: ground 4, crank 1, coupler 3.5, rocker 3 m, of bars that weigh a kilogram a metre. D3: the same with a
//! crank that turns at constant speed.

use reuleaux::nalgebra::Vector2;
use reuleaux::{Dynamics, SimdReal, mechanism};
use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::multibody::{Cut, Joint, Model};

use crate::case::{ACCELERATIONS, BOTH, Case, Entry, HAND, LOADS, STATES};

macro_rules! four_bar {
    ($(#[$page:meta])* $name:ident, $($rest:tt)*) => {
        mechanism! {
            $(#[$page])*
            pub(crate) mechanism $name {
                $($rest)*
                gravity = (0, -9.81m_s2);
                ground { point D = (4m, 0m); }
                body crank   { point B = (1m, 0m);    mass = 1kg;    center = (0.5m, 0m);   inertia = 1/12 * 1kgm2; }
                body coupler { point C = (3.5m, 0m);  mass = 3.5kg;  center = (1.75m, 0m);  inertia = 3.5^3 / 12 * 1kgm2;  start angle = 50deg; }
                body rocker  { point C = (3m, 0m);    mass = 3kg;    center = (1.5m, 0m);   inertia = 27/12 * 1kgm2;  start angle = 100deg; }
                joint a = revolute(ground.position, crank.position);
                joint b = revolute(crank.B, coupler.position);
                joint c = revolute(coupler.C, rocker.C);
                joint d = revolute(rocker.position, ground.D);
            }
        }
    };
}

four_bar!(
    /// The crank is free.
    FourBar,
    param start: Angle = 0.3rad;
    param speed: AngularVelocity = 0rad_s;
    freedom swing = crank.angle from start at speed;
);

/// Lengths, which are masses as well.
const LENGTHS: [f64; 3] = [1.0, 3.5, 3.0];
const GRAVITY: f64 = 9.81;

/// Bodies about z, with relative angles as coordinates.
fn model() -> Model {
    let mut model = Model::new("D2 four-bar");
    model.gravity = [0.0, -GRAVITY, 0.0];
    for (k, (parent, place, start)) in [(None, 0.0, 0.3), (Some(0), LENGTHS[0], 0.6), (None, 4.0, 2.2)].into_iter().enumerate() {
        let body = model.hang(["crank", "coupler", "rocker"][k], parent, &[Joint::Turn(2)], &[start]);
        let length = LENGTHS[k];
        (body.place, body.center, body.mass) = ([place, 0.0, 0.0], [0.5 * length, 0.0, 0.0], length);
        body.inertia = [1e-3 * length, length.powi(3) / 12.0, length.powi(3) / 12.0];
    }
    model.cuts.push(Cut::Meet((Some(1), [LENGTHS[1], 0.0, 0.0]), (Some(2), [LENGTHS[2], 0.0, 0.0])));
    model
}

/// Angles and speeds of the three bars.
type Bars = [[f64; 3]; 2];

/// Angular accelerations of the bars, forces on crank, coupler, rocker (from the coupler) and rocker (from ground).
type Found = ([f64; 3], [Vector2<f64>; 4]);

pub(crate) fn cases() -> Vec<Case> {
    let model = model();
    let states = states();
    let bars = |state: &FourBarState<f64>| [&state.q, &state.qd].map(|vector| [vector[2], vector[5], vector[8]]);
    let inputs: Vec<Bars> = states.iter().map(|(_, state)| bars(state)).collect();
    let exact = (0..STATES).map(|k| {
        let [[a, b, c], [u, v, w]] = inputs[k];
        let found = reaction(&model, &[a, b - a, c], &[u, v - u, w]);
        let turning = found.bodies.iter().map(|numbers| numbers[23]);
        // The force on the rocker is against that on the coupler.
        (k, turning.chain([-found.cuts[0][0], -found.cuts[0][1]]).collect())
    });
    let with = |state: &FourBarState<f64>, force: [f64; 2]| [2, 5, 8].map(|k| state.qdd[k]).into_iter().chain(force).collect::<Vec<f64>>();
    vec![Case {
        name: "D2 four-bar".to_owned(),
        exact: exact.collect(),
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
                |(mechanism, state)| {
                    mechanism.accelerate(state).unwrap_or_else(|stopped| panic!("{stopped}"));
                    mechanism.loads(state)
                },
                move |(_, state), loads| with(state, loads.c().force.into()),
            ),
        ],
    }]
}

/// The crank swings by 1.2 rad about 0.3 rad in a second.
fn states() -> Vec<(FourBar, FourBarState<f64>)> {
    let at = |k: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * k as f64 / STATES as f64).sin_cos();
        let mechanism = FourBar { start: 0.3 + 1.2 * sine, speed: 1.2 * std::f64::consts::TAU * cosine, ..FourBar::default() };
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

/// The loop for a unit motion of the crank and for the motion at hand, one mass, and moments about the pins of coupler and rocker.
#[inline(always)]
fn released([angle, rate]: Bars) -> Found {
    let [l1, l2, l3] = LENGTHS;
    let [[e1, n1], [e2, n2], [e3, n3]] = angle.map(directions);
    let [w1, w2, w3] = rate.map(|rate| rate * rate);
    let per = 1.0 / n2.dot(&e3);
    // Of the coupler and the rocker, so that their ends move alike: v = l2 u2 n2 − l3 u3 n3.
    let solve = |v: Vector2<f64>| [v.dot(&e3) * per / l2, v.dot(&e2) * per / l3];
    let [u2, u3] = solve(n1 * -l1);
    let [p2, p3] = solve(e1 * (l1 * w1) + e2 * (l2 * w2) - e3 * (l3 * w3));
    let h = 0.5 * l2;
    let v = n1 * l1 + n2 * (h * u2);
    let (m1, m2, m3) = (l1, l2, l3);
    let (j1, j2, j3) = (m1 * l1 * l1 / 3.0, m2 * l2 * l2 / 12.0, m3 * l3 * l3 / 3.0);
    let a = e1 * (-l1 * w1) + n2 * (h * p2) - e2 * (h * w2) + Vector2::new(0.0, GRAVITY);
    let mass = j1 + m2 * v.norm_squared() + j2 * u2 * u2 + j3 * u3 * u3;
    let moment = m2 * v.dot(&a) + j2 * u2 * p2 + j3 * u3 * p3 + GRAVITY * (m1 * l1 * 0.5 * e1.x + m3 * l3 * 0.5 * e3.x * u3);
    let turning = -moment / mass;
    let turnings = [turning, u2 * turning + p2, u3 * turning + p3];
    let (coupler, rocker) = (a + v * turning, turnings[2]);
    let p2 = coupler * m2;
    let p3 = (n3 * rocker - e3 * w3) * (0.5 * l3 * m3) + Vector2::new(0.0, m3 * GRAVITY);
    let of_rocker = (j3 * rocker + GRAVITY * m3 * 0.5 * l3 * e3.x) / l3;
    let of_coupler = -(0.5 * l2 * n2.dot(&p2) + j2 * turnings[1]) / l2;
    // n3 · F = of_rocker, n2 · F = of_coupler.
    let f = (e3 * of_coupler - e2 * of_rocker) * per;
    let b = p2 + f;
    let p1 = (n1 * turning - e1 * w1) * (0.5 * l1 * m1) + Vector2::new(0.0, m1 * GRAVITY);
    (turnings, [p1 + b, b, f, p3 - f])
}
