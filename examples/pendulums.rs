//! Pendulums: the period of a large swing, the two modes of a double pendulum, and its motion from far up.
//!
//! ```text
//!      (o)                    (o)
//!       │╲                      ╲ l
//!       │ ╲ l                    ●
//!       │φ ╲                    ╱ l
//!           ●                  ●
//! ```
//!
//! A swing of amplitude φ₀ takes T = 2π √(l/g) / M(1, cos φ₀/2), M the arithmetic-geometric mean. Two equal pendulums, one on the other, have
//! the modes φ₂ = ±√2 φ₁ with ω² = (2 ∓ √2) g/l. Far from rest the sum of the energies stays.
//!
//! Source: L. D. Landau, E. M. Lifshitz, Mechanics, sections 11 and 23.

use std::error::Error;
use std::f64::consts::{PI, SQRT_2};

use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{Place, largest_difference, place, round, show, steps};

mechanism! {
    /// A mass on a rod without weight.
    pub mechanism Pendulum {
        param length: Length = 1m;
        param start: Angle = 30deg;
        gravity = (0, -9.81m_s2);
        body bob { mass = 1kg;  center = (0m, -length); }
        joint pivot = revolute(ground.position, bob.position);
        freedom swing = bob.angle from start;
    }
}

mechanism! {
    /// A pendulum on a pendulum.
    #[picture]
    pub mechanism Double {
        param length: Length = 1m;
        param first: Angle = 130deg;
        param second: Angle = -100deg;
        gravity = (0, -9.81m_s2);
        body upper { point end = (0m, -length);  mass = 1kg;  center = (0m, -length); }
        body lower { point end = (0m, -length);  mass = 1kg;  center = (0m, -length); }
        joint pivot = revolute(ground.position, upper.position);
        joint knee = revolute(upper.end, lower.position);
        freedom one = upper.angle from first;
        freedom two = lower.angle from second;
        output end = lower.end;
    }
}

const GRAVITY: f64 = 9.81;

/// Duration of the motion drawn, in s.
const DRAWN: f64 = 6.0;

fn main() -> Result<(), Box<dyn Error>> {
    periods()?;
    modes()?;
    let double = Double::default();
    let states = double.sweep(steps(0.0, DRAWN, 600), Integrator::new(1e-10)).collect::<Result<Vec<_>, _>>()?;
    let energies: Vec<f64> = states.iter().map(|state| double.energy(state)).map(|energy| energy.total()).collect();
    // From rest: −m g (2 l cos φ₁ + l cos φ₂)
    let first = -GRAVITY * (2.0 * double.first.cos() + double.second.cos());
    let drift = largest_difference(energies.into_iter().map(|energy| (energy, first)));
    println!("energy of the double pendulum from rest at 130° and -100°: {first:.6} J, within {drift:.0e} J for {DRAWN} s");
    assert!(drift < 1e-8);
    let view = View::new("Double pendulum", states, |state| state.t, |state| double.scene(state))
        .outline("upper", moved(round(0.06), double.length))
        .outline("lower", moved(round(0.06), double.length))
        .trace("path of the end", |state| double.end(state).value)
        .plot("kinetic energy", "J", |state| double.energy(state).kinetic)
        .and("potential energy", |state| double.energy(state).potential)
        .and("sum", |state| double.energy(state).total())
        .against("at rest", move |_| first);
    show("pendulums", &view, 50, &[0, 100])
}

/// Periods of large swings, from one passage through the lowest place to the next but one.
fn periods() -> Result<(), Box<dyn Error>> {
    println!("amplitude   period s   2π √(l/g) / M(1, cos φ₀/2)");
    for degrees in [1.0_f64, 30.0, 90.0, 150.0, 179.0] {
        let pendulum = Pendulum { start: degrees.to_radians(), ..Pendulum::default() };
        let (mut state, mut integrator) = (pendulum.initial_state()?, Integrator::new(1e-12));
        let mut passages = [0.0; 3];
        for time in &mut passages {
            assert!(pendulum.advance_until(&mut state, 100.0, &mut integrator, |state| state.bob().angle)?);
            *time = state.t;
        }
        let (found, wanted) = (passages[2] - passages[0], period(&pendulum));
        println!("{degrees:8.0}°   {found:.7}   {wanted:.7}");
        assert!((found / wanted - 1.0).abs() < 1e-10, "{found} for {wanted}");
    }
    Ok(())
}

/// By the arithmetic-geometric mean.
fn period(m: &Pendulum) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * m.start).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    2.0 * PI * (m.length / GRAVITY).sqrt() / (0.5 * (a + b))
}

/// In a mode both angles follow one cosine.
fn modes() -> Result<(), Box<dyn Error>> {
    for sign in [1.0, -1.0] {
        // Squares of the angles are below the tolerance.
        let small = 1e-5;
        let double = Double { first: small, second: sign * SQRT_2 * small, ..Double::default() };
        let omega = ((2.0 - sign * SQRT_2) * GRAVITY / double.length).sqrt();
        println!("mode φ₂ = {:+.4} φ₁: {:.6} rad/s", sign * SQRT_2, omega);
        for state in double.sweep(steps(0.0, 3.0, 60), Integrator::new(1e-12)) {
            let state = state?;
            let wanted = small * (omega * state.t).cos();
            assert!((state.upper().angle - wanted).abs() < 1e-8 * small);
            assert!((state.lower().angle - sign * SQRT_2 * wanted).abs() < 1e-8 * small);
        }
    }
    Ok(())
}

/// An outline about the mass of a rod.
fn moved(outline: Vec<Place>, length: f64) -> Vec<Place> {
    outline.into_iter().map(|at| place(at.x, at.y - length)).collect()
}
