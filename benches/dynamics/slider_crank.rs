//! D3: a slider-crank of 1 and 3 m, of 1, 3 and 2 kg, whose crank turns at constant speed.

use reuleaux::{SimdReal, mechanism};
use reuleaux_benches::multibody::forces::reaction;
use reuleaux_benches::multibody::{Cut, Joint, Model};

use crate::case::{Case, Entry, HAND_ANGLES, HAND_DRIVEN, STATES, STEP, exact_in};

mechanism! {
    /// A slider-crank with masses.
    pub(crate) mechanism SliderCrank {
        gravity = (0, -9.81m_s2);
        ground { axis way = (1, 0); }
        body crank  { point B = (1m, 0m);  mass = 1kg;  center = (0.5m, 0m);  inertia = rod(1m); }
        body rod    { point C = (3m, 0m);  mass = 3kg;  center = (1.5m, 0m);  inertia = rod(3m); }
        body slider { mass = 2kg;  start position = (4m, 0m); }
        joint axle = revolute(ground.position, crank.position);
        joint pin = revolute(crank.B, rod.position);
        joint wrist = revolute(rod.C, slider.position);
        joint guide = translational(ground.way, ground.position, slider.position);
        drive motor = drive_angle(crank, 2rad_s * t);
    }
}

const SPEED: f64 = 2.0;
const GRAVITY: f64 = 9.81;
/// Of the rod, and masses of crank, rod and slider.
const ROD: f64 = 3.0;
const MASSES: [f64; 3] = [1.0, 3.0, 2.0];

fn moment(number: usize) -> [f64; 2] {
    [number, number + 1].map(|k| std::f64::consts::PI * k as f64 / STATES as f64)
}

/// Rod: sine and cosine, rate, acceleration; slider: place, speed, acceleration; forces at the three pins; the guide's force, the torque.
type Found = ([f64; 4], [f64; 3], [[f64; 2]; 3], f64, f64);

/// sin φ = −sin θ / l, and forces from the slider backwards.
#[inline(always)]
fn driven(t: f64) -> Found {
    let (sine, cosine) = (SPEED * t).fast_sin_cos();
    let s = -sine * (1.0 / ROD);
    let c = (1.0 - s * s).sqrt();
    let per = 1.0 / c;
    let rate = -cosine * (SPEED / ROD) * per;
    let square = SPEED * SPEED;
    let turning = (sine * (square / ROD) + s * rate * rate) * per;
    let x = cosine + ROD * c;
    let v = -SPEED * sine - ROD * s * rate;
    let inward = rate * rate;
    let (rod_x, rod_y) = (-(s * turning + c * inward), c * turning - s * inward);
    let a = -square * cosine + ROD * rod_x;
    let [m1, m2, m3] = MASSES;
    let (px, py) = (m2 * (-square * cosine + 0.5 * ROD * rod_x), m2 * (-square * sine + 0.5 * ROD * rod_y + GRAVITY));
    // Force F on the slider from the rod: F_x = m a, and moments of the rod about the crank pin give F_y.
    let fx = m3 * a;
    let moment = 0.5 * ROD * (c * py - s * px) + m2 * ROD * ROD / 12.0 * turning;
    let fy = (ROD * s * fx - moment) * per * (1.0 / ROD);
    let (bx, by) = (px + fx, py + fy);
    let (cx, cy) = (-0.5 * m1 * square * cosine, m1 * (GRAVITY - 0.5 * square * sine));
    let torque = 0.5 * m1 * GRAVITY * cosine + cosine * by - sine * bx;
    ([s, c, rate, turning], [x, v, a], [[cx + bx, cy + by], [bx, by], [fx, fy]], m3 * GRAVITY - fy, torque)
}

fn model() -> Model {
    let mut model = Model::new("slider-crank");
    model.gravity = [0.0, -GRAVITY, 0.0];
    let lengths = [1.0, ROD];
    for k in 0..2 {
        let body = model.hang(["crank", "rod"][k], k.checked_sub(1), &[Joint::Turn(2)], &[0.0]);
        let (mass, length) = (MASSES[k], lengths[k]);
        (body.place, body.center, body.mass) = ([if k == 0 { 0.0 } else { 1.0 }, 0.0, 0.0], [0.5 * length, 0.0, 0.0], mass);
        body.inertia = [1e-3, mass * length * length / 12.0, mass * length * length / 12.0];
    }
    model.hang("slider", None, &[Joint::Shift(0)], &[4.0]).mass = MASSES[2];
    model.cuts.push(Cut::Meet((Some(1), [ROD, 0.0, 0.0]), (Some(2), [0.0; 3])));
    model
}

/// The accelerations, forces and torque that are compared.
fn compared((rod, slider, pins, _, torque): &Found) -> Vec<f64> {
    vec![rod[3], slider[2], pins[2][0], pins[2][1], *torque]
}

pub(crate) fn case() -> Case {
    let mechanism = SliderCrank::default();
    let solve = move |t: f64| mechanism.solve(t).unwrap_or_else(|failure| panic!("{failure}"));
    let states: Vec<(SliderCrankState<f64>, [f64; 2])> = (0..STATES).map(|k| (solve(moment(k)[0]), moment(k))).collect();
    let model = model();
    let exact = move |k: usize| {
        let state = solve(moment(k)[1]);
        let [[a, b, x], [u, v, w]] = [&state.q, &state.qd].map(|vector| [vector[2], vector[5], vector[6]]);
        let found = reaction(&model, &[a, b - a, x], &[u, v - u, w], &[(0, 0.0)]);
        let force = found.cuts[0];
        vec![found.bodies[1][23], found.bodies[2][18], -force[0], -force[1], found.efforts[0]]
    };
    Case {
        name: "D3 slider-crank".to_owned(),
        exact: exact_in(1, exact),
        given: None,
        entries: vec![
            Entry::new(HAND_DRIVEN, (0..STATES).map(|k| moment(k)[1]).collect(), |t| driven(*t), |_, found| compared(found)),
            Entry::new(
                HAND_ANGLES,
                (0..STATES).map(|k| moment(k)[1]).collect(),
                |t| {
                    let found = driven(*t);
                    (found, found.0[0].atan2(found.0[1]))
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
                |(state, _), loads| {
                    let force = loads.wrist().force;
                    vec![state.qdd[5], state.qdd[6], force.x, force.y, loads.motor().effort]
                },
            ),
        ],
    }
}
