//! Porter's governor: height of its sleeve at a given speed, and the transition to it.
//!
//! ```text
//!            │ spindle
//!           (o)            arms and rods of one length l
//!          ╱   ╲           balls m, sleeve M
//!       ●─╱     ╲─●
//!          ╲   ╱           h: from the balls up to the hinge
//!           [=] sleeve
//! ```
//!
//! If balls and sleeve are at rest on the rotating spindle, h = (1 + M/m) g / ω². A damper brings them to rest.
//!
//! Source: T. Bevan, The Theory of Machines, governors.

use std::error::Error;

use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{largest_difference, ring, show, steps};

mechanism! {
    /// A governor with two balls and a loaded sleeve.
    #[picture]
    pub mechanism Governor in space {
        param speed: AngularVelocity = 120rpm;
        param arm: Length = 200mm;
        param ball: Mass = 1kg;
        param load: Mass = 0.5kg;

        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body spindle { axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0) from (1, 0, 0); }
        body left   { axis y = (0, 1, 0) from (1, 0, 0);  point ball = (0mm, 0mm, -arm);  mass = ball;  center = (0mm, 0mm, -arm); }
        body right  { axis y = (0, 1, 0) from (1, 0, 0);  point ball = (0mm, 0mm, -arm);  mass = ball;  center = (0mm, 0mm, -arm); }
        body sleeve { axis z = (0, 0, 1);  mass = load; }

        joint bearing = revolute(ground.position, ground.z, spindle.position, spindle.z);
        joint hinge = revolute(spindle.position, spindle.y, left.position, left.y);
        joint other = revolute(spindle.position, spindle.y, right.position, right.y);
        joint guide = translational(spindle.position, spindle.z, sleeve.position, sleeve.z);
        start hinge.angle = 30deg;
        start other.angle = -30deg;
        start guide.displacement = -2 * arm * cos(30deg);
        joint rod = distance(left.ball, sleeve.position, arm);
        joint second_rod = distance(right.ball, sleeve.position, arm);
        force dashpot = damper(spindle.position, sleeve.position, damping: 30Ns_m);
        drive engine = drive_rotation(bearing, speed * t);
        freedom lift = guide.displacement;

        output left = left.ball;
        output right = right.ball;
    }
}

type State = GovernorState<f64>;

/// Settling time, in s.
const SETTLED: f64 = 15.0;

/// Speeds (rpm) that lift the sleeve.
const SPEEDS: [f64; 6] = [90.0, 100.0, 110.0, 120.0, 140.0, 160.0];

/// Height (m) of the hinge above the balls at rest on the rotating spindle.
fn height(m: &Governor) -> f64 {
    (1.0 + m.load / m.ball) * 9.81 / (m.speed * m.speed)
}

fn at(rpm: f64) -> Governor {
    Governor { speed: rpm * std::f64::consts::TAU / 60.0, ..Governor::default() }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut ends = Vec::new();
    println!("speed rpm   height mm   (1 + M/m) g/ω²");
    for rpm in SPEEDS {
        let governor = at(rpm);
        let state = settled(&governor, SETTLED)?;
        let found = -0.5 * state.sleeve().position.z;
        println!("{rpm:9.0}   {:9.4}   {:9.4}", 1e3 * found, 1e3 * height(&governor));
        ends.push((rpm, found, height(&governor), state));
    }
    assert!(largest_difference(ends.iter().map(|(_, found, wanted, _)| (*found, *wanted))) < 1e-7);
    // The balls stay opposite to each other.
    let opposite = ends.iter().map(|(_, _, _, state)| (state.left().angular_velocity - state.right().angular_velocity).norm());
    assert!(largest_difference(opposite.map(|difference| (difference, 0.0))) < 1e-6);
    let governors = [100.0, 120.0, 160.0].map(at);
    let [slow, usual, fast] = governors.map(|m| m.sweep(steps(0.0, 2.0, 240), Integrator::new(1e-9)).collect::<Result<Vec<State>, _>>());
    let states: Vec<[State; 3]> = slow?.into_iter().zip(usual?).zip(fast?).map(|((slow, usual), fast)| [slow, usual, fast]).collect();
    let rest = |m: Governor| move |states: &[State; 3]| if states[0].t < 2.0 { f64::NAN } else { height(&m) * 1e3 };
    let view = View::new("Governor", states, |[_, state, _]| state.t, |[_, state, _]| governors[1].scene(state));
    // The balls, as two great circles each.
    let centre = Vector3::z() * -0.2;
    let circles = [Vector3::x(), Vector3::y()].map(|axis| ring(&centre, &axis, 0.018));
    let view = circles.into_iter().fold(view, |view, circle| view.outline("left", circle.clone()).outline("right", circle));
    let view = view
        .trace("path of a ball", |[_, state, _]| governors[1].left(state).value)
        .plot("height at 100 rpm", "mm", |[state, _, _]| -500.0 * state.sleeve().position.z)
        .and("120 rpm", |[_, state, _]| -500.0 * state.sleeve().position.z)
        .and("160 rpm", |[_, _, state]| -500.0 * state.sleeve().position.z)
        .against("at rest: (1 + M/m) g/ω²", rest(governors[0]))
        .against("at rest: (1 + M/m) g/ω²", rest(governors[1]))
        .against("at rest: (1 + M/m) g/ω²", rest(governors[2]));
    show("governor", &view, 240, &[0, 20])
}

/// The state at a time.
fn settled(m: &Governor, time: f64) -> Result<State, Box<dyn Error>> {
    let mut state = m.initial_state()?;
    m.advance(&mut state, time, &mut Integrator::new(1e-9))?;
    Ok(state)
}
