//! Bricard's linkage: six hinges at right angles, which should lock and do not, falls under its weight.
//!
//! ```text
//!       ▨━━━━━━━━━○         five rods along the edges of a cube, the sixth edge is ground;
//!                 ┃         each hinge is at right angles to both of its rods
//!   ▨             ┃
//!   ┃             ○
//!   ┃            ╱
//!   ○━━━━━━━━━━━○
//! ```
//!
//! In space six hinges leave a loop of six links no freedom: 5 · 6 coordinates, and 6 · 5 equations. Bricard found in 1897 linkages that move
//! nevertheless; of the last hinge, a `redundant joint`, one equation follows from all others in every position. From where the rods lie
//! along the edges of a cube three hinges turn by a and those between them by b,
//!
//! ```text
//! sin a + sin b + sin a sin b = 0
//! ```
//!
//! and the motion follows from energies alone: with the potential energy V and ½ m ȧ² for the kinetic one,
//!
//! ```text
//! ȧ² = 2 (V(0) − V(a)) / m(a)      it turns back at a = π, after ∫ da / ȧ
//! ```
//!
//! The hinges share one load that closes in itself, which nothing determines; both bearings together carry what gives the rods their momentum.
//!
//! Source: R. Bricard, Mémoire sur la théorie de l'octaèdre articulé (1897); the Library of Computational Benchmark Problems of IFToMM, A03.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

use reuleaux::nalgebra::{Rotation3, Vector3};
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{figure, largest_difference, play, steps};

mechanism! {
    /// Five rods of 1 m and 1 kg with square sections.
    #[picture]
    pub mechanism Bricard in space {
        gravity = (0m_s2, -9.81m_s2, 0m_s2);
        let length = 1m;
        let side = 100mm;

        // Bodies are turned as ground is where their rods lie along the edges of the cube.
        ground { axis x = (1, 0, 0);  axis y = (0, 1, 0);  point end = (0m, 0m, length); }
        body first {
            axis y = (0, 1, 0);  point end = (length, 0m, 0m);  axis z = (0, 0, 1);
            mass = 1kg;  center = (length / 2, 0m, 0m);  inertia = block(length, side, side);
        }
        body second {
            axis z = (0, 0, 1);  point end = (0m, -length, 0m);  axis x = (1, 0, 0);
            mass = 1kg;  center = (0m, -length / 2, 0m);  inertia = block(side, length, side);  start position = (1m, 0m, 0m);
        }
        body third {
            axis x = (1, 0, 0);  point end = (0m, 0m, length);  axis y = (0, 1, 0);
            mass = 1kg;  center = (0m, 0m, length / 2);  inertia = block(side, side, length);  start position = (1m, -1m, 0m);
        }
        body fourth {
            axis y = (0, 1, 0);  point end = (-length, 0m, 0m);  axis z = (0, 0, 1);
            mass = 1kg;  center = (-length / 2, 0m, 0m);  inertia = block(length, side, side);  start position = (1m, -1m, 1m);
        }
        body fifth {
            axis z = (0, 0, 1);  point end = (0m, length, 0m);  axis x = (1, 0, 0);
            mass = 1kg;  center = (0m, length / 2, 0m);  inertia = block(side, length, side);  start position = (0m, -1m, 1m);
        }

        joint one = revolute(ground.position, ground.y, first.position, first.y);
        joint two = revolute(first.end, first.z, second.position, second.z);
        joint three = revolute(second.end, second.x, third.position, third.x);
        joint four = revolute(third.end, third.y, fourth.position, fourth.y);
        joint five = revolute(fourth.end, fourth.z, fifth.position, fifth.z);
        redundant joint six = revolute(fifth.end, fifth.x, ground.end, ground.x);
        freedom fall = one.angle;

        output a = one.angle;
        output b = two.angle;
        output third_a = three.angle;
        output fourth_b = four.angle;
        output fifth_a = five.angle;
    }
}

type State = BricardState<f64>;

const GRAVITY: f64 = 9.81;
/// Moments of inertia (kg m²) of a rod along and across.
const INERTIA: [f64; 2] = [1.0 / 600.0, 1.01 / 12.0];
/// In s.
const LENGTH_OF_FILM: f64 = 10.0;

/// The linkage in closed form at an angle a of its first hinge.
struct Pose {
    /// The other angle, in rad.
    b: f64,
    /// The six hinges, in m.
    hinges: [Vector3<f64>; 6],
    /// m(a), in kg m².
    mass: f64,
}

/// Five turns about the hinges, one after the other; speeds per ȧ in the same way.
fn pose(a: f64) -> Pose {
    let b = -(a.sin() / (1.0 + a.sin())).asin();
    let slope = -a.cos() * (1.0 + b.sin()) / (b.cos() * (1.0 + a.sin()));
    let (x, y, z) = (Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis());
    let rods = [(y, x.into_inner()), (z, -y.into_inner()), (x, z.into_inner()), (y, -x.into_inner()), (z, y.into_inner())];
    let (mut turn, mut spin, mut speed) = (Rotation3::identity(), Vector3::zeros(), Vector3::zeros());
    let (mut hinges, mut mass) = ([Vector3::zeros(); 6], 0.0);
    for (k, (hinge, rod)) in rods.into_iter().enumerate() {
        let (angle, rate) = if k % 2 == 0 { (a, 1.0) } else { (b, slope) };
        spin += turn * hinge.into_inner() * rate;
        turn *= Rotation3::from_axis_angle(&hinge, angle);
        let rod: Vector3<f64> = turn * rod;
        let (half, about) = (spin.cross(&rod) / 2.0, spin.dot(&rod));
        mass += (speed + half).norm_squared() + INERTIA[0] * about * about + INERTIA[1] * (spin.norm_squared() - about * about);
        speed += half * 2.0;
        hinges[k + 1] = hinges[k] + rod;
    }
    Pose { b, hinges, mass }
}

/// V(a) (J): half of each rod hangs on either of its hinges.
fn potential(pose: &Pose) -> f64 {
    GRAVITY * pose.hinges.windows(2).map(|rod| (rod[0].y + rod[1].y) / 2.0).sum::<f64>()
}

/// ȧ (rad/s), all but its sign.
fn speed(a: f64) -> f64 {
    let at = pose(a);
    (2.0 * (potential(&pose(0.0)) - potential(&at)) / at.mass).max(0.0).sqrt()
}

/// The time (s) from a = 0 to a = π: over the angle θ with a = π (1 − cos θ) / 2, where the speed has no roots, by the midpoint rule, which is
/// exact for periodic functions, to all digits.
fn half_period() -> f64 {
    let count = 64_u32;
    let points = (0..count).map(|k| PI * (f64::from(k) + 0.5) / f64::from(count));
    points.map(|theta| FRAC_PI_2 * theta.sin() / speed(PI * (1.0 - theta.cos()) / 2.0)).sum::<f64>() * PI / f64::from(count)
}

fn main() -> Result<(), Box<dyn Error>> {
    let m = Bricard::default();
    let film: Vec<State> = m.sweep(steps(0.0, LENGTH_OF_FILM, 400), Integrator::new(1e-12)).collect::<Result<_, _>>()?;
    let start = potential(&pose(0.0));
    for state in &film {
        assert_angles(&m, state);
        assert_bearings(&m, state);
        let energy = m.energy(state);
        assert!((energy.total() - start).abs() < 1e-11, "{energy:?} at {} s", state.t);
    }
    let half = half_period();
    let turns = turns(&m)?;
    println!("it turns back after {half:.12} s by its energies; found s, off by s");
    for (k, time) in (1..).zip(turns) {
        println!("{time:18.12}   {:8.1e}", time - f64::from(k) * half);
        assert!((time - f64::from(k) * half).abs() < 1e-10);
    }
    figure("bricard", &view(&m, film.clone()), 30, &[0, 100])?;
    play("bricard", &view(&m, film.into_iter().take_while(|state| state.t < 2.0 * half).collect()))
}

fn view(m: &Bricard, film: Vec<State>) -> View<State> {
    m.view(film)
        .title("Bricard's linkage")
        .trace("path of the third hinge", |state| state.third().position)
        .plot("a", "°", |state| m.a(state).value.to_degrees())
        .and("b", |state| m.b(state).value.to_degrees())
        .against("sin a + sin b + sin a sin b = 0", |state| pose(m.a(state).value).b.to_degrees())
        .plot("speed of a", "rad/s", |state| m.a(state).rate)
        .against("by energies", |state| speed(m.a(state).value) * m.a(state).rate.signum())
}

/// Hinges turn by a and b in turns, and the first as fast as energies say.
fn assert_angles(m: &Bricard, state: &State) {
    let [a, b] = [m.a(state), m.b(state)];
    let relation = a.value.sin() + b.value.sin() + a.value.sin() * b.value.sin();
    let others = [(m.third_a(state), a), (m.fourth_b(state), b), (m.fifth_a(state), a)];
    let apart = largest_difference(others.into_iter().map(|(one, other)| (one.value, other.value)).chain([(relation, 0.0)]));
    assert!(apart < 1e-14, "{apart:e} at {} s", state.t);
    // Squares: near its turns speed is the root of a small number.
    assert!((a.rate * a.rate - speed(a.value).powi(2)).abs() < 1e-11, "{} for {} at {} s", a.rate, speed(a.value), state.t);
}

/// The loads of all bearings together move the rods; the load of each is not determined.
fn assert_bearings(m: &Bricard, state: &State) {
    let loads = m.loads(state);
    assert!(!loads.one().is_unique && !loads.six().is_unique);
    let rods = [state.first(), state.second(), state.third(), state.fourth(), state.fifth()];
    let centres = [Vector3::x(), -Vector3::y(), Vector3::z(), -Vector3::x(), Vector3::y()].map(|rod| rod / 2.0);
    let rates: Vector3<f64> = rods.iter().zip(centres).map(|(rod, centre)| rod.point(centre).acceleration).sum();
    let off = loads.one().force + loads.six().force - rates - Vector3::y() * (5.0 * GRAVITY);
    assert!(off.norm() < 1e-11, "{:e} N at {} s", off.norm(), state.t);
}

/// The instants (s) of the first four turns back.
fn turns(m: &Bricard) -> Result<Vec<f64>, Box<dyn Error>> {
    let (mut state, mut integrator, mut turns) = (m.initial_state()?, Integrator::new(1e-12), Vec::new());
    // Not the instant at which it is let go.
    m.advance(&mut state, 0.5, &mut integrator)?;
    while turns.len() < 4 {
        let until = state.t + 4.0;
        assert!(m.advance_until(&mut state, until, &mut integrator, |state| state.first().angular_velocity.y)?);
        turns.push(state.t);
    }
    Ok(turns)
}
