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
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{Abscissa, Diagram, Ink, Plate, Scene, largest_difference, seen, show, steps};

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
        body left   { axis y = (0, 1, 0) from (1, 0, 0);  point ball = (0mm, 0mm, -arm);  mass = ball;  center = (0mm, 0mm, -arm);  start orientation = turn((0, 1, 0), 30deg); }
        body right  { axis y = (0, 1, 0) from (1, 0, 0);  point ball = (0mm, 0mm, -arm);  mass = ball;  center = (0mm, 0mm, -arm);  start orientation = turn((0, 1, 0), -30deg); }
        body sleeve { axis z = (0, 0, 1);  mass = load;  start position = (0mm, 0mm, -2 * arm * cos(30deg)); }

        joint bearing = revolute(ground.position, ground.z, spindle.position, spindle.z);
        joint hinge = revolute(spindle.position, spindle.y, left.position, left.y);
        joint other = revolute(spindle.position, spindle.y, right.position, right.y);
        joint guide = translational(spindle.position, spindle.z, sleeve.position, sleeve.z);
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
    println!("{}", picture(&ends)?.save("governor")?.display());
    let governor = at(120.0);
    let states: Vec<State> = governor.sweep(steps(0.0, 2.0, 240), Integrator::new(1e-9)).collect::<Result<_, _>>()?;
    let view = governor
        .view(states)
        .trace("path of a ball", |state| governor.left(state).value)
        .plot("height", "mm", |state| -500.0 * state.sleeve().position.z)
        .and("(1 + M/m) g/ω²", |_| height(&governor) * 1e3);
    show("governor", &view)?;
    Ok(())
}

/// The state at a time.
fn settled(m: &Governor, time: f64) -> Result<State, Box<dyn Error>> {
    let mut state = m.initial_state()?;
    m.advance(&mut state, time, &mut Integrator::new(1e-9))?;
    Ok(state)
}

/// The height of the hinge above the balls over the first seconds.
fn settling(m: &Governor) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let (mut state, mut integrator) = (m.initial_state()?, Integrator::new(1e-9));
    let mut curve = Vec::new();
    for time in steps(0.0, 2.0, 200) {
        m.advance(&mut state, time, &mut integrator)?;
        curve.push((time, -500.0 * state.sleeve().position.z));
    }
    Ok(curve)
}

fn picture(ends: &[(f64, f64, f64, State)]) -> Result<Plate, Box<dyn Error>> {
    let mut scene = Scene::new();
    // Rotated about the spindle into one plane, for comparison.
    for (_, found, _, _) in &ends[1..] {
        scene.faint(|scene| draw(scene, *found));
    }
    draw(&mut scene, ends[3].1);
    let mut diagram = Diagram::new("height in mm");
    for (rpm, ink) in [(100.0, Ink::Output), (120.0, Ink::Coupler), (160.0, Ink::Input)] {
        let name = if rpm < 110.0 {
            "100 rpm"
        } else if rpm < 130.0 {
            "120 rpm"
        } else {
            "160 rpm"
        };
        diagram = diagram.curve(ink, name, settling(&at(rpm))?);
    }
    let rests = [100.0, 120.0, 160.0].map(|rpm| (2.0, 1e3 * height(&at(rpm))));
    Ok(Plate::new("Governor", scene, Abscissa { name: "time in s", range: 0.0..2.0, step: 0.5 })
        .diagram(diagram.circles("at rest: (1 + M/m) g/ω²", rests)))
}

fn draw(scene: &mut Scene, height: f64) {
    let out = (0.2_f64 * 0.2 - height * height).sqrt();
    let top = seen(&Vector3::zeros());
    let sleeve = seen(&Vector3::new(0.0, 0.0, -2.0 * height));
    let balls = [-1.0, 1.0].map(|side| seen(&Vector3::new(side * out, 0.0, -height)));
    scene.link(Ink::Ground, &[seen(&Vector3::new(0.0, 0.0, 0.04)), seen(&Vector3::new(0.0, 0.0, -0.42))]);
    for ball in balls {
        scene.link(Ink::Coupler, &[top, ball]).link(Ink::Output, &[ball, sleeve]);
    }
    for ball in balls {
        scene.disc(Ink::Input, ball, 0.018);
    }
    scene.pin(top).pin(sleeve);
}
