//! The differential of a car in a bend: bevel gears on a rotating carrier.
//!
//! ```text
//!            ┌──[10]──┐         planet on a pin across the axle, in the cage that the engine drives
//!   left ══[16]      [16]══ right
//!            └────────┘ cage
//! ```
//!
//! The engine determines the speed of the cage, the road the difference of the wheel speeds: while the car yaws by ψ, the wheels, of
//! track b and radius R, rotate relative to each other by b ψ / R. So
//!
//! ```text
//! (φ_left + φ_right) / 2 = φ_cage            φ_right − φ_left = b ψ / R            planet: (16/10) b ψ / 2R on its pin
//! ```
//!
//! The angles of the joints on the cage are measured relative to the cage, so that a moving carrier needs no further declaration. The
//! meshes are checked in space: where two pitch circles touch, both gears have the same velocity.
//!
//! Source: the law of gearing; module 4 mm.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{SpatialBody, mechanism};
use reuleaux_examples::{differential, figure, largest_difference, play, steps};

mechanism! {
    /// A differential with constant cage speed, while the car drives into a bend, through it, and out.
    #[picture]
    pub mechanism Differential in space {
        param speed: AngularVelocity = 300rpm;
        param track: Length = 1.5m;
        param wheel_radius: Length = 300mm;
        /// Yaw angle of the car in the bend, to the left.
        param bend: Angle = 90deg;
        param duration: Time = 2s;

        ground { axis y = (0, 1, 0) from (1, 0, 0); }
        body cage   { axis y = (0, 1, 0) from (1, 0, 0);  axis pin = (1, 0, 0); }
        body left   { axis y = (0, 1, 0) from (1, 0, 0); }
        body right  { axis y = (0, 1, 0) from (1, 0, 0); }
        body planet { axis pin = (1, 0, 0); }

        joint bearing = revolute(ground.position, ground.y, cage.position, cage.y);
        joint left_shaft = revolute(cage.position, cage.y, left.position, left.y);
        joint right_shaft = revolute(cage.position, cage.y, right.position, right.y);
        joint pin = revolute(cage.position, cage.pin, planet.position, planet.pin);
        joint left_mesh = gear_pair(pin.angle, left_shaft.angle, 10, 16);
        joint right_mesh = gear_pair(pin.angle, right_shaft.angle, 10, -16);
        drive engine = drive_rotation(bearing, speed * t);
        drive road = { right_shaft.angle - left_shaft.angle == track * bend * polynomial_345(t / duration) / wheel_radius; }

        output cage = bearing.angle;
        output left = bearing.angle + left_shaft.angle;
        output right = bearing.angle + right_shaft.angle;
        output planet = pin.angle;
    }
}

type State = DifferentialState<f64>;

/// Radii of the pitch circles of planet and side gears (m).
const RADII: [f64; 2] = [0.02, 0.032];

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Differential::default();
    let bend: Vec<State> = mechanism.sweep(steps(0.0, 2.0, 200)).collect::<Result<_, _>>()?;

    assert_turns(&mechanism, &bend);
    bend.iter().for_each(assert_meshes);
    print(&mechanism, &bend);
    figure("bevel_differential", &view(&mechanism, bend), 74, &[])?;
    // One turn of the cage, slow enough to be seen.
    let slow = Differential { speed: PI, bend: 0.4, ..mechanism };
    let bend: Vec<State> = slow.sweep(steps(0.0, 2.0, 120)).collect::<Result<_, _>>()?;
    play("bevel_differential", &view(&slow, bend))
}

fn view(m: &Differential, bend: Vec<State>) -> View<State> {
    differential(m.view(bend), RADII)
        .title("Bevel differential")
        .plot("cage", "rpm", |state| m.cage(state).rate * 60.0 / TAU)
        .and("left", |state| m.left(state).rate * 60.0 / TAU)
        .and("right", |state| m.right(state).rate * 60.0 / TAU)
        .against("closed form", |state| (m.speed - parted(m, state.t)[1] / 2.0) * 60.0 / TAU)
        .against("closed form", |state| (m.speed + parted(m, state.t)[1] / 2.0) * 60.0 / TAU)
        .plot("planet on its pin", "°", |state| m.planet(state).value.to_degrees())
        .against("closed form", |state| 0.8 * parted(m, state.t)[0].to_degrees())
}

/// Relative rotation of the wheels (rad) and its rate.
fn parted(m: &Differential, t: f64) -> [f64; 2] {
    let (u, all) = (t / m.duration, m.track * m.bend / m.wheel_radius);
    [all * u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u), all * 30.0 * (u * (1.0 - u)).powi(2) / m.duration]
}

fn assert_turns(m: &Differential, bend: &[State]) {
    for (order, unit) in [TAU, m.speed].into_iter().enumerate() {
        let of = |motion: reuleaux::Motion<f64>| [motion.value, motion.rate][order] / unit;
        let mean = largest_difference(bend.iter().map(|state| ((of(m.left(state)) + of(m.right(state))) / 2.0, of(m.cage(state)))));
        let apart = largest_difference(bend.iter().map(|state| (of(m.right(state)) - of(m.left(state)), parted(m, state.t)[order] / unit)));
        let planet = largest_difference(bend.iter().map(|state| (of(m.planet(state)), 0.8 * parted(m, state.t)[order] / unit)));
        assert!(mean.max(apart).max(planet) < 1e-14, "order {order}: off by {mean:e}, {apart:e} and {planet:e}");
    }
}

/// Velocity of a point (m) fixed in a body.
fn velocity(body: &SpatialBody<f64>, place: Vector3<f64>) -> Vector3<f64> {
    body.velocity + body.angular_velocity.cross(&(place - body.position))
}

/// Where their pitch circles touch, planet and side gears have the same velocity.
fn assert_meshes(state: &State) {
    for (side, gear) in [(1.0, state.left()), (-1.0, state.right())] {
        let touch = state.cage().point(Vector3::new(RADII[1], side * RADII[0], 0.0)).value;
        let slip = velocity(&gear, touch) - velocity(&state.planet(), touch);
        assert!(slip.norm() < 1e-14, "the mesh slips by {slip} at t = {}", state.t);
    }
}

fn print(m: &Differential, bend: &[State]) {
    println!("time s   cage turns   left turns   right turns   planet turns   left rpm   right rpm");
    for state in bend.iter().step_by(20) {
        let [cage, left, right, planet] = [m.cage(state), m.left(state), m.right(state), m.planet(state)];
        println!(
            "{:6.2}   {:10.4}   {:10.4}   {:11.4}   {:12.4}   {:8.2}   {:9.2}",
            state.t,
            cage.value / TAU,
            left.value / TAU,
            right.value / TAU,
            planet.value / TAU,
            left.rate * 60.0 / TAU,
            right.rate * 60.0 / TAU
        );
    }
}
