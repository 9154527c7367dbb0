//! A control loop: a crank-rocker whose motor is controlled so that a point of the coupler moves at constant speed.
//!
//! ```text
//!   encoder ──▶ observer ──θ, θ̇──▶ mechanism ──tip, v, a──▶ controller ──▶ torque ──▶ motor ──▶ crank
//!      ▲                                                                                         │
//!      └─────────────────────────────────────────────────────────────────────────────────────────┘
//! ```
//!
//! Each millisecond the encoder of the crank is read, to 16 bits of a turn, and an observer makes angle and rate of it: the `input` of the
//! mechanism. With θ̈ = 0 the mechanism says how the tip would speed up if the crank kept its rate,
//!
//! ```text
//! |v|˙ = c + |P′| θ̈      c = v · a / |v| at θ̈ = 0,      |P′| = |v| / θ̇
//! ```
//!
//! and the controller asks for the θ̈ that holds the speed. The tip as the mechanism computes it is checked in each cycle against the closed
//! form at the angle that it was told, and against that at the true angle, which only the plant knows.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::picture::Drawable;
use reuleaux::{Motion, mechanism};
use reuleaux_examples::{Place, apex, carried, place, polar, show};

mechanism! {
    /// A crank-rocker with an encoder on its crank.
    #[picture]
    pub mechanism Measured {
        input theta: Angle = 40deg;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm);  point P = (175mm, 80mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, theta);
        output tip = coupler.P;
    }
}

/// A cycle (s).
const CYCLE: f64 = 1e-3;
/// Speed of the tip that is wanted (m/s).
const WANTED: f64 = 0.5;
/// Inertia of the crank with its load (kg m²).
const INERTIA: f64 = 0.02;

/// The crank with its motor and an unknown load.
struct Plant {
    angle: f64,
    rate: f64,
}

impl Plant {
    /// A cycle at constant torque (N m), in a hundred steps.
    fn turn(&mut self, torque: f64) {
        let step = CYCLE / 100.0;
        for _ in 0..100 {
            let load = 0.05 * (3.0 * self.angle).sin();
            self.rate += step * (torque - load) / INERTIA;
            self.angle += step * self.rate;
        }
    }

    /// The encoder: 16 bits, beginning anew after each turn.
    fn encoder(&self) -> f64 {
        (self.angle.rem_euclid(TAU) / TAU * 65536.0).floor() / 65536.0 * TAU
    }
}

/// Angle and rate of the crank from its encoder and the acceleration that was asked for.
struct Observer {
    theta: Motion<f64>,
}

impl Observer {
    /// How fast it follows (rad/s).
    const POLE: f64 = 200.0;

    fn read(&mut self, encoder: f64, asked: f64) {
        let angle = self.theta.value + CYCLE * (self.theta.rate + 0.5 * CYCLE * asked);
        let off = Motion::at(encoder).nearest_turn(angle).value - angle;
        self.theta.value = angle + 2.0 * Self::POLE * CYCLE * off;
        self.theta.rate += CYCLE * (asked + Self::POLE * Self::POLE * off);
    }
}

/// The record of a cycle.
struct Cycle {
    time: f64,
    crank: f64,
    /// Of the tip, as the mechanism says it, and as it is.
    speed: [f64; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Measured::default();
    let mut plant = Plant { angle: 0.7, rate: 4.0 };
    let mut observer = Observer { theta: Motion::moving(plant.encoder(), 4.0) };
    let mut state = mechanism.solve(0.0, MeasuredInputs { theta: observer.theta })?;
    let (mut asked, mut cycles, mut states) = (0.0, Vec::new(), vec![state.clone()]);
    for cycle in 1..=3000 {
        let time = CYCLE * f64::from(cycle);
        plant.turn(INERTIA * asked);
        observer.read(plant.encoder(), asked);
        mechanism.advance(&mut state, time, MeasuredInputs { theta: observer.theta })?;

        let tip = mechanism.tip(&state);
        let speed = tip.rate.norm();
        let (lever, drift) = (speed / observer.theta.rate, tip.rate.dot(&tip.acceleration) / speed);
        asked = (200.0 * (WANTED - speed) - drift) / lever;

        let told = tip_at(observer.theta.value);
        let true_tip = tip_at(plant.angle);
        assert!((tip.value - told[0]).norm() < 1e-13, "the tip is beside the closed form at the angle it was told");
        assert!((tip.rate - told[1] * observer.theta.rate).norm() < 1e-12, "the tip moves otherwise than in closed form");
        assert!((tip.value - true_tip[0]).norm() < 1e-4, "the tip is elsewhere, at {time} s");
        let true_speed = true_tip[1].norm() * plant.rate;
        assert!(time < 0.5 || (true_speed / WANTED - 1.0).abs() < 0.02, "the tip moves at {true_speed} m/s at {time} s");
        if cycle % 25 == 0 {
            states.push(state.clone());
        }
        cycles.push(Cycle { time, crank: plant.rate, speed: [speed, true_speed] });
    }
    print(&cycles);
    let plant = |of: fn(&Cycle) -> f64| {
        let cycles = &cycles;
        move |state: &MeasuredState| match (state.t / CYCLE).round() as usize {
            0 => f64::NAN,
            cycle => of(&cycles[cycle - 1]),
        }
    };
    let view = mechanism
        .view(states)
        .title("Control loop")
        .trace("path of the tip", |state| mechanism.tip(state).value)
        .plot("speed of the tip", "m/s", |state| mechanism.tip(state).rate.norm())
        .against("plant", plant(|cycle| cycle.speed[1]))
        .plot("speed of the crank", "rad/s", |state| state.crank().angular_velocity)
        .against("plant", plant(|cycle| cycle.crank));
    show("control_loop", &view, 120, &[])
}

/// The tip and its derivative by the crank's angle, by triangles.
fn tip_at(theta: f64) -> [Place; 2] {
    let (a, c) = (polar(0.1, theta), place(0.4, 0.0));
    let b = apex(a, c, 0.35, 0.3);
    let tip = carried(place(0.175, 0.08), a, place(0.35, 0.0), b);
    // a e^(iθ) + b e^(iφ) = d + c e^(iψ), differentiated and taken across the rocker.
    let (coupler, rocker) = ((b - a).y.atan2((b - a).x), (b - c).y.atan2((b - c).x));
    let turning = -0.1 * (theta - rocker).sin() / (0.35 * (coupler - rocker).sin());
    let arm = tip - a;
    [tip, place(-a.y, a.x) + place(-arm.y, arm.x) * turning]
}

fn print(cycles: &[Cycle]) {
    println!("time s   crank rad/s   tip m/s   tip as it is m/s");
    for cycle in cycles.iter().step_by(250) {
        println!("{:6.3}   {:11.4}   {:7.4}   {:16.4}", cycle.time, cycle.crank, cycle.speed[0], cycle.speed[1]);
    }
}
