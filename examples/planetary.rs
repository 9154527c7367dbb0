//! A planetary gear: sun, three planets on a carrier, and a ring around them.
//!
//! ```text
//!        ┌───── ring, 60 teeth ─────┐
//!        │  (planet 18)             │        z_s (ω_s − ω_c) + z_r (ω_r − ω_c) = 0
//!        │     │ carrier            │
//!        │  (sun 24)                │
//! ```
//!
//! With two of the three shafts given, Willis' equation determines the third: the gear is a gearbox with four ratios. With the ring at
//! rest, a pitch point of a planet traces a hypocycloid and has zero velocity where it touches the ring: planets roll.
//!
//! Source: R. Willis, Principles of Mechanism, 1841; H. W. Müller, Epicyclic Drive Trains.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Place, largest_difference, polar, show, steps};

mechanism! {
    /// Sun and ring are driven; the carrier follows.
    #[picture]
    pub mechanism Planetary {
        param sun_speed: AngularVelocity = 210rpm;
        param ring_speed: AngularVelocity = 0;
        let module = 5mm;
        let arm_length = module * (24 + 18) / 2;
        let planet_radius = module * 18 / 2;

        ground { point O = (0mm, 0mm); }
        body sun  { point O = (0mm, 0mm); }
        body ring { point O = (0mm, 0mm); }
        body carrier {
            point O = (0mm, 0mm);
            point A = (arm_length, 0mm);
            point B = (arm_length * cos(120deg), arm_length * sin(120deg));
            point C = (arm_length * cos(240deg), arm_length * sin(240deg));
        }
        body a { point A = (0mm, 0mm);  point P = (planet_radius, 0mm); }
        body b { point B = (0mm, 0mm); }
        body c { point C = (0mm, 0mm); }

        joint s = revolute(ground.O, sun.O);
        joint r = revolute(ground.O, ring.O);
        joint k = revolute(ground.O, carrier.O);
        joint pin_a = revolute(carrier.A, a.A);
        joint pin_b = revolute(carrier.B, b.B);
        joint pin_c = revolute(carrier.C, c.C);
        joint willis = planetary(sun, ring, carrier, 24, 60);
        joint mesh_a = gear_pair(sun, a, 24, 18, carrier: carrier);
        joint mesh_b = gear_pair(sun, b, 24, 18, carrier: carrier);
        joint mesh_c = gear_pair(sun, c, 24, 18, carrier: carrier);
        drive motor = drive_angle(sun, sun_speed * t);
        drive brake = drive_angle(ring, ring_speed * t);

        output P = a.P;
    }
}

type State = PlanetaryState<f64>;

/// Module (m).
const MODULE: f64 = 0.005;
/// Teeth of sun, planets and ring.
const TEETH: [f64; 3] = [24.0, 18.0, 60.0];

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Planetary::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 360)).collect::<Result<_, _>>()?;

    print_ratios()?;
    assert_hypocycloid(&mechanism, &turn);
    assert_rolling(&turn);
    // Per turn of the carrier a planet makes 10/3 turns relative to it, so that three turns of the carrier close the curve.
    let closed: Vec<State> = mechanism.sweep(steps(0.0, 3.0, 720)).collect::<Result<_, _>>()?;
    let view = mechanism
        .view(closed)
        .title("Planetary gear")
        .over("carrier", "°", |state| state.carrier().angle.to_degrees())
        .trace("hypocycloid", |state| mechanism.P(state).value)
        .plot("sun", "turns", |state| state.sun().angle / TAU)
        .and("carrier", |state| state.carrier().angle / TAU)
        .and("planet", |state| state.a().angle / TAU)
        .plot("speed of P", "m/s", |state| mechanism.P(state).rate.norm());
    show("planetary", &view, 44, &[])
}

/// The four gears of the gearbox, each with its ratio from textbook tables.
fn print_ratios() -> Result<(), Box<dyn Error>> {
    let [sun, _, ring] = TEETH;
    let gears = [
        ("ring held", 1.0, 0.0, sun / (sun + ring)),
        ("sun held", 0.0, 1.0, ring / (sun + ring)),
        ("locked", 1.0, 1.0, 1.0),
        ("carrier held", 1.0, -sun / ring, 0.0),
    ];
    println!("gear           sun   ring   carrier   planet   (rad/s)");
    for (name, sun_speed, ring_speed, expected) in gears {
        let state = Planetary { sun_speed, ring_speed }.solve(1.0)?;
        let [carrier, planet] = [state.carrier(), state.a()].map(|body| body.angular_velocity);
        println!("{name:12}  {sun_speed:4}   {ring_speed:4}   {carrier:7.4}   {planet:6.3}");
        assert!((carrier - expected).abs() < 1e-15);
    }
    Ok(())
}

/// Position (m) of the planets' pitch point with the carrier at `angle` (rad), rolling in the ring.
fn hypocycloid(angle: f64) -> Place {
    let [planet, ring] = [TEETH[1], TEETH[2]].map(|teeth| teeth * MODULE / 2.0);
    polar(ring - planet, angle) + polar(planet, -angle * (ring - planet) / planet)
}

fn assert_hypocycloid(m: &Planetary, turn: &[State]) {
    let error = largest_difference(turn.iter().map(|state| ((m.P(state).value - hypocycloid(state.carrier().angle)).norm(), 0.0)));
    assert!(error < 1e-14, "the pitch point is {error:e} m beside the hypocycloid");
}

/// The point of a planet that touches the ring at rest has zero velocity.
fn assert_rolling(turn: &[State]) {
    let radius = TEETH[1] * MODULE / 2.0;
    for planet in turn.iter().flat_map(|state| [state.a(), state.b(), state.c()]) {
        let arm = planet.position.normalize() * radius;
        let velocity = planet.velocity + Place::new(-arm.y, arm.x) * planet.angular_velocity;
        assert!(velocity.norm() < 1e-14);
    }
}
