//! The crank-rocker four-bar: a rotating crank makes a rocker oscillate.
//!
//! ```text
//!              coupler      B
//!        A ───────P────────(o)
//!       (o)                 │ rocker        OA = a, AB = b, BC = c, OC = d
//! crank /                   │
//!     (o)                  (o)
//!  ════O════════════════════C════
//! ```
//!
//! By Grashof's criterion the crank rotates fully: a + b < c + d with a the shortest and b the longest link. The rocker's angle ψ is
//! checked against Freudenstein's equation, k₁ cos ψ − k₂ cos φ + k₃ = cos(φ − ψ), solved for ψ in closed form.
//!
//! Source: R. L. Norton, Design of Machinery, the running four-bar example of the chapters on position, velocity and acceleration; F.
//! Freudenstein, An analytical approach to the design of four-link mechanisms, 1954.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{largest_difference, show, steps};

mechanism! {
    /// A Grashof crank-rocker.
    #[picture]
    pub mechanism CrankRocker {
        param crank_length: Length = 40mm;
        param coupler_length: Length = 120mm;
        param rocker_length: Length = 80mm;
        param base: Length = 100mm;
        /// Angle of the crank at t = 0.
        param angle: Angle = 0deg;
        param speed: AngularVelocity = 60rpm;
        param acceleration: AngularAcceleration = 0;

        ground {
            point O = (0mm, 0mm);
            point C = (base, 0mm);
        }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (coupler_length, 0mm);  point P = (60mm, 45mm); }
        body rocker  { point C = (0mm, 0mm);  point B = (rocker_length, 0mm);  start angle = 60deg; }

        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive motor = drive_angle(crank, angle + speed * t + acceleration * t^2 / 2);

        output A = crank.A;
        output B = rocker.B;
        output P = coupler.P;
        output O = ground.O;
        output C = ground.C;
        output transmission = rocker.angle - coupler.angle;
        /// Its inverse is the mechanical advantage: the torque on the rocker that a torque on the crank balances.
        output ratio = rocker.angular_velocity / crank.angular_velocity;
    }
}

type State = CrankRockerState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = CrankRocker::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_freudenstein(&mechanism, &turn);
    assert_ratio(&mechanism, &turn);
    assert_norton()?;
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Crank-rocker four-bar")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .trace("path of P", |state| mechanism.P(state).value)
        .plot("rocker", "°", |state| state.rocker().angle.to_degrees())
        .against("Freudenstein's equation", |state| freudenstein(&mechanism, state.crank().angle).to_degrees())
        .plot("velocity of the rocker", "rad/s", |state| state.rocker().angular_velocity)
        .plot("acceleration of the rocker", "rad/s²", |state| state.rocker().angular_acceleration);
    show("four_bar", &view, 25, &[55, 85, 115, 145])?;
    Ok(())
}

/// The rocker's angle ψ (rad) at the crank's angle φ (rad) with the coupler above: Freudenstein's equation in tan(ψ/2).
fn freudenstein(m: &CrankRocker, crank: f64) -> f64 {
    let (a, b, c, d) = (m.crank_length, m.coupler_length, m.rocker_length, m.base);
    let (k1, k2, k3) = (d / a, d / c, (a * a - b * b + c * c + d * d) / (2.0 * a * c));
    let (sin, cos) = crank.sin_cos();
    let (p, q, r) = (cos - k1 - k2 * cos + k3, -2.0 * sin, k1 - (k2 + 1.0) * cos + k3);
    2.0 * ((-q - (q * q - 4.0 * p * r).sqrt()) / (2.0 * p)).atan()
}

fn assert_freudenstein(m: &CrankRocker, turn: &[State]) {
    let angles = |s: &State| (s.rocker().angle, freudenstein(m, s.crank().angle));
    let error = largest_difference(turn.iter().map(angles));
    assert!(error < 1e-13, "the rocker is {error:e} beside Freudenstein's equation");
}

/// The ratio of the angular velocities is that of the distances between the pivots and the instant centre of crank and rocker, and is zero
/// where crank and coupler are aligned: a sin(θ₃ − θ₂)/(c sin(θ₃ − θ₄)).
fn assert_ratio(m: &CrankRocker, turn: &[State]) {
    let sines = |s: &State| {
        let [crank, coupler, rocker] = [s.crank(), s.coupler(), s.rocker()].map(|body| body.angle);
        (m.ratio(s).value, m.crank_length * (coupler - crank).sin() / (m.rocker_length * (coupler - rocker).sin()))
    };
    let error = largest_difference(turn.iter().map(sines));
    assert!(error < 1e-13, "the ratio is {error:e} beside that of the sines");
}

/// Norton's open four-bar at 40° with 25 rad/s and 15 rad/s²: his results, to the last digit printed.
fn assert_norton() -> Result<(), Box<dyn Error>> {
    let mechanism = CrankRocker { angle: 40_f64.to_radians(), speed: 25.0, acceleration: 15.0, ..Default::default() };
    let state = mechanism.solve(0.0)?;
    let (coupler, rocker) = (state.coupler(), state.rocker());
    let angles = [(coupler.angle.to_degrees(), 20.298), (rocker.angle.to_degrees(), 57.325)];
    let rates = [(coupler.angular_velocity, -4.121), (rocker.angular_velocity, 6.998)];
    let accelerations = [(coupler.angular_acceleration, 296.089), (rocker.angular_acceleration, 470.134)];
    assert!(largest_difference([angles, rates, accelerations].concat()) < 0.5e-3);
    Ok(())
}

fn print(m: &CrankRocker, turn: &[State]) {
    println!("crank °   rocker °   rocker rad/s   rocker rad/s²   transmission °   advantage");
    for state in turn.iter().step_by(15) {
        let (crank, rocker, transmission) = (state.crank(), state.rocker(), m.transmission(state).value);
        println!(
            "{:7.1}   {:8.3}   {:12.4}   {:13.3}   {:14.2}   {:9.2}",
            crank.angle.to_degrees(),
            rocker.angle.to_degrees(),
            rocker.angular_velocity,
            rocker.angular_acceleration,
            transmission.to_degrees(),
            1.0 / m.ratio(state).value
        );
    }
}
