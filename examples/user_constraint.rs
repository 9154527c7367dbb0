//! A user-defined constraint: a planet on its ellipse, at the speed of Kepler's equation.
//!
//! ```text
//!             ___P___                 |PF| + |PG| = 2 a          1 row, m
//!          /    /     \               E − ε sin E = 2π t / T     1 row, rad
//!         │ G  F arm   │
//!          \__________/               E eccentric, ν true anomaly, the angle of the arm
//! ```
//!
//! The library has neither an ellipse nor Kepler's equation. Both rows are defined with `constraint!`, checked where they are written,
//! differentiated like those of the library, and exported as one bundle that `use` imports. E is written as
//! ν − 2 atan(β sin ν / (1 + β cos ν)), which is smooth over any number of turns.
//!
//! Checked against all three laws: the orbit's equation in polar coordinates, the constant areal velocity, and Newton's law of
//! gravitation, which is equivalent to the third law: the acceleration points to the sun and is μ/r² with μ = (2π/T)² a³.
//!
//! Source: J. Kepler, Astronomia nova, 1609, and Harmonice mundi, 1619.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::picture::{Drawable, GROUND};
use reuleaux::{constraint, mechanism};
use reuleaux_examples::{Place, largest_difference, round, show, steps};

constraint! {
    /// The constraints of an orbit.
    pub bundle orbit {
        /// `P` stays on the ellipse with foci `F` and `G` and major semi-axis `a`: the gardener's string.
        constraint on_ellipse(P: Point, F: Point, G: Point, a: Length) {
            require a != 0: "an ellipse has a major semi-axis";
            norm(P - F) + norm(P - G) == 2 * a;
        }

        /// The body's angle ν is the true anomaly of a planet with this mean anomaly.
        constraint kepler(b: Body, mean: Angle, eccentricity: Number) {
            let beta = eccentricity / (1 + sqrt(1 - eccentricity^2));
            let E = b.angle - 2 * atan(beta * sin(b.angle) / (1 + beta * cos(b.angle)));
            E - eccentricity * sin(E) == mean;
        }
    }
}

mechanism! {
    /// An orrery for one planet, with the sun in `F`.
    #[picture]
    pub mechanism Orrery {
        use crate::orbit;

        param semi_axis: Length = 150mm;
        param eccentricity: Number = 0.6;
        param period: Time = 12s;

        ground {
            point F = (0mm, 0mm);
            point G = (-2 * eccentricity * semi_axis, 0mm);
        }
        body arm    { point F = (0mm, 0mm);  axis u = (1, 0); }
        body planet { point P = (0mm, 0mm);  start position = (semi_axis * (1 - eccentricity), 0mm); }

        joint sun = revolute(ground.F, arm.F);
        joint slide = translational(arm.u, arm.F, planet.P);
        joint path = on_ellipse(planet.P, ground.F, ground.G, semi_axis);
        drive clock = kepler(arm, 1turn * t / period, eccentricity);

        output F = ground.F;
        output G = ground.G;
        output P = planet.P;
    }
}

type State = OrreryState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Orrery::default();
    let year: Vec<State> = mechanism.sweep(steps(0.0, mechanism.period, 240)).collect::<Result<_, _>>()?;

    for eccentricity in [0.0167, 0.2056, 0.6, 0.9] {
        assert_kepler(&Orrery { eccentricity, ..Default::default() })?;
    }
    print(&mechanism, &year);
    let sector = |states: &[State]| states.iter().map(|state| mechanism.P(state).value).chain([mechanism.F(&states[0]).value]).collect();
    let sectors: Vec<Vec<Place>> = year.windows(21).step_by(40).map(sector).collect();
    let view = mechanism.view(year).title("Constraints of one's own: Kepler's ellipse");
    // Every second one of twelve sectors of one second each: they have the same area.
    let view = sectors.into_iter().fold(view, |view, sector| view.outline(GROUND, sector));
    let view = view
        .outline("planet", round(0.008))
        .trace("orbit", |state| mechanism.P(state).value)
        .plot("distance", "mm", |state| mechanism.P(state).value.norm() * 1e3)
        .against("ellipse", |state| distance(&mechanism, state.arm().angle) * 1e3)
        .plot("speed of the arm", "rad/s", |state| state.arm().angular_velocity)
        .against("law of areas", |state| areal_velocity(&mechanism) / distance(&mechanism, state.arm().angle).powi(2));
    show("user_constraint", &view, 50, &[])
}

/// Distance to the sun (m) at the true anomaly ν (rad).
fn distance(m: &Orrery, anomaly: f64) -> f64 {
    m.semi_axis * (1.0 - m.eccentricity.powi(2)) / (1.0 + m.eccentricity * anomaly.cos())
}

/// Twice the areal velocity (m²/s): 2 π a b / T.
fn areal_velocity(m: &Orrery) -> f64 {
    TAU * m.semi_axis.powi(2) * (1.0 - m.eccentricity.powi(2)).sqrt() / m.period
}

/// All three laws, over two years.
fn assert_kepler(m: &Orrery) -> Result<(), Box<dyn Error>> {
    let states: Vec<State> = m.sweep(steps(0.0, 2.0 * m.period, 500)).collect::<Result<_, _>>()?;
    let orbit = largest_difference(states.iter().map(|state| (m.P(state).value.norm() / distance(m, state.arm().angle), 1.0)));
    let area = largest_difference(states.iter().map(|state| (m.P(state).value.perp(&m.P(state).rate) / areal_velocity(m), 1.0)));
    let mu = (TAU / m.period).powi(2) * m.semi_axis.powi(3);
    let excess = |state: &State| {
        let (planet, distance) = (m.P(state), m.P(state).value.norm());
        (planet.acceleration + planet.value * (mu / distance.powi(3))).norm() * distance.powi(2) / mu
    };
    let gravity = largest_difference(states.iter().map(|state| (excess(state), 0.0)));
    assert!(orbit < 1e-14 && area < 1e-13 && gravity < 1e-12, "off by {orbit:e}, {area:e} and {gravity:e}");
    Ok(())
}

fn print(m: &Orrery, year: &[State]) {
    println!("time s   true anomaly °   distance mm   speed mm/s");
    for state in year.iter().step_by(20) {
        let planet = m.P(state);
        println!(
            "{:6.1}   {:14.3}   {:11.3}   {:10.3}",
            state.t,
            state.arm().angle.to_degrees(),
            planet.value.norm() * 1e3,
            planet.rate.norm() * 1e3
        );
    }
}
