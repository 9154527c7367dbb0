//! S1D: Haug's slider-crank across its plane, released.

use std::f64::consts::{FRAC_PI_2, TAU};

use reuleaux::nalgebra::Vector3;
use reuleaux::{Dynamics, SimdReal, mechanism};
use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::multibody::{Cut, Joint, Model};

use crate::case::{ACCELERATIONS, BOTH, Case, Entry, Given, HAND, LOADS, STATES, exact_in};

mechanism! {
    /// A crank that is free to turn across the way of its slider; frames lie in the mass centres.
    pub(crate) mechanism SliderCrank in space {
        param start: Angle = 0.3rad;
        param speed: AngularVelocity = 6rad_s;
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground {
            point axle = (0m, 0.1m, 0.12m);
            axis x = (1, 0, 0) from (0, 0, 1);
        }
        body crank {
            axis x = (1, 0, 0) from (0, 0, 1);  point O = (0m, 0m, -0.04m);  point A = (0m, 0m, 0.04m);
            mass = 0.12kg;  inertia = (1e-4kgm2, 1e-4kgm2, 1e-4kgm2);
        }
        body slider {
            axis x = (1, 0, 0) from (0, 0, 1);
            mass = 2kg;  inertia = (1e-3kgm2, 1e-3kgm2, 1e-3kgm2);  start position = (0.2m, 0m, 0m);
        }
        body rod {
            axis y = (0, 1, 0);  point A = (-0.15m, 0m, 0m);  point B = (0.15m, 0m, 0m);
            mass = 0.5kg;  inertia = (4e-4kgm2, 4e-3kgm2, 4e-3kgm2);
            start orientation = turn((1, 0, 0), -26deg) * turn((0, 1, 0), 48deg);
        }

        joint axle = revolute(ground.axle, ground.x, crank.O, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.y);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        freedom swing = axle.angle from start at speed;
    }
}

const ARM: f64 = 0.08;
const ROD: f64 = 0.3;
const AXLE: [f64; 2] = [0.1, 0.12];
const GRAVITY: f64 = 9.81;
/// Masses of crank, rod and slider (kg), moments of inertia of the crank and of the rod along it and across it (kg m²).
const MASSES: [f64; 3] = [0.12, 0.5, 2.0];
const INERTIAS: [f64; 3] = [1e-4, 4e-4, 4e-3];

/// Accelerations of crank and slider and of the rod's angles about x and y; forces on the rod at the ball and at the cross, and on the crank
/// at the axle; the torque on the rod across both axes of the cross, those on the crank at the axle along y and z; forces on the slider along
/// y and z, and the torque that keeps it from turning.
type Found = ([f64; 4], [Vector3<f64>; 3], [f64; 3], [f64; 2], Vector3<f64>);

/// One unit motion, one bias, one mass; then the moments of the rod about the slider, in its own frame.
#[inline(always)]
fn released(angle: f64, speed: f64) -> Found {
    let [crank, rod, slider] = MASSES;
    let [of_crank, along, across] = INERTIAS;
    let (sine, cosine) = angle.fast_sin_cos();
    let square = speed * speed;
    let (y, z) = (-ARM * sine, ARM * cosine);
    let (ay, az) = (AXLE[0] + y, AXLE[1] + z);
    let beside = ay * ay + az * az;
    let x = (ROD * ROD - beside).sqrt();
    // The axis of the rod is u = (cos b, sin b sin a, −sin b cos a), n = sin b.
    let n = beside.sqrt() * (1.0 / ROD);
    let both = 1.0 / (x * n);
    let (per_x, per_n) = (n * both, x * both);
    let (ux, per) = (x * (1.0 / ROD), per_n * (1.0 / ROD));
    let (sa, ca) = (-ay * per, az * per);
    // For a unit motion, and besides for the motion at hand.
    let vx = (ay * z - az * y) * per_x;
    let bias_x = -(vx * vx + ARM * ARM - ay * y - az * z) * per_x * square;
    let (a, b) = ((z * ca - y * sa) * per, -vx * per);
    let spread = (z * sa + y * ca) * (1.0 / ROD);
    let bias_a = ((y * ca + z * sa) * per - 2.0 * a * spread * per_n) * square;
    let bias_b = -bias_x * per - ux * b * b * per_n * square;
    let (w_u, w_z) = (a * ux, a * n);
    let (gyro_u, gyro_z) = (-a * b * n * square, a * b * ux * square);
    let (t_u, t_y, t_z) = (bias_a * ux + gyro_u, bias_b, bias_a * n + gyro_z);
    let sliding = 0.25 * rod + slider;
    let mass = of_crank + (0.25 * (crank + rod) * ARM) * ARM + sliding * vx * vx + along * w_u * w_u + across * (b * b + w_z * w_z);
    let moment = sliding * vx * bias_x + along * w_u * t_u + across * (b * t_y + w_z * t_z) + (0.5 * GRAVITY * (crank + rod)) * y;
    let turning = -moment / mass;
    let sliding = vx * turning + bias_x;
    let (pin_y, pin_z) = (-z * turning - y * square, y * turning - z * square);
    let (t_u, t_y, t_z) = (w_u * turning + t_u, b * turning + t_y, w_z * turning + t_z);
    // The force that moves the rod, in ground and along its y and z axes.
    let moved = Vector3::new(0.5 * rod * sliding, 0.5 * rod * pin_y, rod * (0.5 * pin_z + GRAVITY));
    let inwards = sa * moved.y - ca * moved.z;
    let (p_y, p_z) = (ca * moved.y + sa * moved.z, n * moved.x - ux * inwards);
    let swirl = (along - across) * w_u * square;
    let m_y = across * t_y + swirl * w_z + 0.5 * ROD * p_z;
    let m_z = across * t_z - swirl * b - 0.5 * ROD * p_y;
    let twist = -along * t_u * per_n;
    let (f_y, f_z) = ((twist * ux - m_z) * (1.0 / ROD), m_y * (1.0 / ROD));
    let push = (0.5 * rod + slider) * sliding;
    let f_u = (push - f_z * n) * (ROD * per_x);
    let out = f_u * n - f_z * ux;
    let ball = Vector3::new(push, out * sa + f_y * ca, f_y * sa - out * ca);
    let cross = moved - ball;
    let axle = ball + Vector3::new(0.0, 0.5 * crank * pin_y, crank * (0.5 * pin_z + GRAVITY));
    (
        [turning, sliding, a * turning + bias_a, t_y],
        [ball, cross, axle],
        [twist, z * push, -y * push],
        [cross.y, cross.z + slider * GRAVITY],
        Vector3::new(0.0, -sa * twist, ca * twist),
    )
}

fn model() -> Model {
    let mut model = Model::new("S1D slider-crank");
    model.gravity = [0.0, 0.0, -GRAVITY];
    let crank = model.hang("crank", None, &[Joint::Turn(0)], &[0.0]);
    (crank.place, crank.center) = ([0.0, AXLE[0], AXLE[1]], [0.0, 0.0, 0.5 * ARM]);
    (crank.mass, crank.inertia) = (MASSES[0], [INERTIAS[0]; 3]);
    let slider = model.hang("slider", None, &[Joint::Shift(0)], &[0.2]);
    (slider.mass, slider.inertia) = (MASSES[2], [1e-3; 3]);
    let rod = model.hang("rod", Some(1), &[Joint::Turn(0), Joint::Turn(1)], &[-0.4636, 0.84]);
    (rod.center, rod.mass, rod.inertia) = ([-0.5 * ROD, 0.0, 0.0], MASSES[1], [INERTIAS[1], INERTIAS[2], INERTIAS[2]]);
    model.cuts.push(Cut::Meet((Some(0), [0.0, 0.0, ARM]), (Some(2), [-ROD, 0.0, 0.0])));
    model
}

pub(crate) fn case() -> Case {
    let model = model();
    let at = |k: usize| {
        let mechanism = SliderCrank { start: TAU * k as f64 / STATES as f64, speed: 6.0 };
        (mechanism, mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")))
    };
    let states: Vec<(SliderCrank, SliderCrankState<f64>)> = (0..STATES).map(at).collect();
    // The crank's angle, the slider's place and the cross's angles; the second one is counted from z.
    let given = states.iter().map(|(_, state)| {
        let [mut q, rates] = [&state.q, &state.qd].map(|vector| vec![vector[9], vector[3], vector[10], vector[11]]);
        q[3] -= FRAC_PI_2;
        vec![q, rates]
    });
    let given: Vec<Vec<Vec<f64>>> = given.collect();
    let (known, of_known) = (given.clone(), model.clone());
    let exact = exact_in(1, move |k| {
        let found = reaction(&of_known, &known[k][0], &known[k][1], &[]);
        let force = found.cuts[0].map(|entry| -entry);
        [&[found.bodies[0][21], found.bodies[1][18]], &force[..]].concat()
    });
    let seen =
        |(_, state): &(SliderCrank, SliderCrankState<f64>), force: Vector3<f64>| [&[state.qdd[9], state.qdd[3]], force.as_slice()].concat();
    Case {
        name: "S1D slider-crank".to_owned(),
        exact,
        given: Some(Given { model, states: given }),
        entries: vec![
            Entry::new(
                HAND,
                states.iter().map(|(mechanism, _)| [mechanism.start, mechanism.speed]).collect(),
                |[angle, speed]| released(*angle, *speed),
                |_, (accelerations, forces, ..)| [&accelerations[..2], forces[0].as_slice()].concat(),
            ),
            Entry::new(
                ACCELERATIONS,
                states.clone(),
                |(mechanism, state)| mechanism.accelerations(&state.q, &state.qd, state.t),
                |_, found| found.iter().map(|found| found[0]).collect(),
            ),
            Entry::new(
                LOADS,
                states.clone(),
                |(mechanism, state)| mechanism.loads(state),
                move |states, loads| seen(states, loads.ball().force),
            ),
            Entry::new(
                BOTH,
                states,
                |(mechanism, state)| mechanism.accelerate_with_loads(state).unwrap_or_else(|stopped| panic!("{stopped}")),
                move |states, loads| seen(states, loads.ball().force),
            ),
        ],
    }
}
