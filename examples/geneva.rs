//! A Geneva wheel of four slots: a quarter of a turn for each turn of the crank, and rest between.
//!
//! ```text
//!        ╭──╮
//!    P o│ ╲╱ │            engaged, |θ| < 90° − 180°/n:   the pin P lies on the line of a slot
//!     ╱ │ ╱╲ │            else:                          the locking disc holds the wheel
//!    O───╰─W─╯
//! ```
//!
//! The contact is one equation with two branches. While the pin is in a slot, P − W has the direction of the slot, and the wheel's angle is
//! solved for; during the dwell the angle is that at which the pin left. Angles are counted on: after k turns of the crank the slot k further
//! on is next. The pin enters along its slot, so that the velocity is continuous and the acceleration jumps from 0 to ω² tan(180°/n).
//!
//! Angle, velocity and acceleration agree with the formulas of textbooks, λ = sin(180°/n) the crank's radius over the distance of the axes:
//!
//! ```text
//!   β = atan(λ sin θ / (1 − λ cos θ))
//!   β̇ = ω λ (cos θ − λ) / (1 − 2λ cos θ + λ²)
//!   β̈ = ω² λ (λ² − 1) sin θ / (1 − 2λ cos θ + λ²)²
//! ```
//!
//! and so do the peaks: the velocity ω λ/(1 − λ), 2.414 ω for four slots; the acceleration where cos θ = √(M² + 2) − M, M = (1 + λ²)/4λ, which
//! is 5.407 ω² at 11.46°; and ω² tan(180°/n), here ω², where the pin enters.
//!
//! Source: J. H. Bickford, Mechanisms for Intermittent Motion, chapter 9.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Place, largest_difference, place, polar, round, show, steps};

/// Number of slots.
const SLOTS: f64 = 4.0;

mechanism! {
    /// An indexing table.
    #[picture]
    pub mechanism Geneva {
        param speed: AngularVelocity = 60rpm;
        param distance: Length = 100mm;

        let part = 180deg / 4;
        let radius = distance * sin(part);
        ground {
            point O = (0mm, 0mm);
            point W = (distance, 0mm);
        }
        body crank { point P = (radius, 0mm);  start angle = -180deg; }
        body wheel { }

        joint shaft = revolute(ground.O, crank.position);
        joint bearing = revolute(ground.W, wheel.position);
        joint slot = {
            // Turns of the crank that are complete, and the angle of the wheel from the slot that is next.
            let turns = (crank.angle - wrap(crank.angle)) / 360deg;
            let turned = wheel.angle + 2 * part * turns;
            let along = (cos(turned), sin(turned));
            let held = if sin(crank.angle) < 0 { part } else { -part };
            (if cos(crank.angle) > sin(part) { cross(along, crank.P - ground.W) } else { distance * (turned - held) }) == 0mm;
        }
        drive motor = drive_angle(crank, speed * t - 180deg);

        output P = crank.P;
        output angle = wheel.angle;
    }
}

type State = GenevaState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Geneva::default();
    assert_formulas(&mechanism)?;
    assert_index(&mechanism)?;
    print_peaks(&mechanism)?;
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 720)).collect::<Result<_, _>>()?;
    print(&mechanism, &turn);
    let view = mechanism
        .view(turn)
        .title("Geneva wheel")
        .over("crank", "°", |state| state.crank().angle.to_degrees())
        .outline("wheel", wheel(&mechanism))
        .outline("crank", disc(&mechanism))
        .outline("crank", round(0.06 * mechanism.distance).iter().map(|at| place(mechanism.distance * (PI / SLOTS).sin(), 0.0) + at))
        .plot("wheel", "°", |state| mechanism.angle(state).value.to_degrees())
        .against("formula", |state| formula(state.crank().angle)[0].to_degrees())
        .plot("velocity", "rad/s", |state| mechanism.angle(state).rate)
        .against("formula", |state| formula(state.crank().angle)[1] * mechanism.speed)
        .plot("acceleration", "rad/s²", |state| mechanism.angle(state).acceleration)
        .against("formula", |state| formula(state.crank().angle)[2] * mechanism.speed.powi(2));
    show("geneva", &view, 325, &[])
}

/// The wheel's angle (rad) and its derivatives by the crank's angle, from the middle of the engagement.
fn formula(crank: f64) -> [f64; 3] {
    let (part, turn) = (PI / SLOTS, (crank / TAU).round());
    let (theta, ratio) = (crank - turn * TAU, part.sin());
    let (sine, cosine) = theta.sin_cos();
    let square = 1.0 - 2.0 * ratio * cosine + ratio * ratio;
    let [angle, rate, acceleration] = match theta {
        theta if theta.abs() < PI / 2.0 - part => [
            (ratio * sine / (1.0 - ratio * cosine)).atan(),
            ratio * (cosine - ratio) / square,
            ratio * (ratio * ratio - 1.0) * sine / (square * square),
        ],
        theta => [part.copysign(theta), 0.0, 0.0],
    };
    // The wheel turns against the crank.
    [-angle - turn * 2.0 * part, -rate, -acceleration]
}

/// Three turns of the crank; the borders of the engagement lie between the steps.
fn assert_formulas(m: &Geneva) -> Result<(), Box<dyn Error>> {
    let mut pairs = [const { Vec::new() }; 3];
    for state in m.sweep(steps(0.0, 3.0, 1999)) {
        let state = state?;
        let (found, exact) = (m.angle(&state), formula(state.crank().angle));
        let found = [found.value, found.rate / m.speed, found.acceleration / (m.speed * m.speed)];
        for order in 0..3 {
            pairs[order].push((found[order], exact[order]));
        }
    }
    let [angle, rate, acceleration] = pairs.map(largest_difference);
    assert!(angle < 1e-13 && rate < 1e-12 && acceleration < 1e-11, "{angle} {rate} {acceleration}");
    Ok(())
}

/// Each turn of the crank moves the wheel on by one slot, and the dwell is three quarters of it.
fn assert_index(m: &Geneva) -> Result<(), Box<dyn Error>> {
    let turns: Vec<State> = m.sweep(steps(0.0, 4.0, 640)).collect::<Result<_, _>>()?;
    for (number, state) in (0_u8..).zip(turns.iter().step_by(160)) {
        assert!((m.angle(state).value - PI / SLOTS + f64::from(number) * TAU / SLOTS).abs() < 1e-13);
    }
    let turn: Vec<State> = m.sweep(steps(0.0005, 0.9995, 999)).collect::<Result<_, _>>()?;
    assert_eq!(turn.iter().filter(|state| m.angle(state).rate.abs() < 1e-12).count(), 750);
    Ok(())
}

/// The peaks in closed form, to the step of 0.01°.
fn print_peaks(m: &Geneva) -> Result<(), Box<dyn Error>> {
    let engaged = steps(-44.99, 0.0, 4499).map(|degrees| (degrees + 180.0) / 360.0 / (m.speed / TAU));
    let engaged: Vec<State> = m.sweep(engaged).collect::<Result<_, _>>()?;
    let degrees = |state: &State| state.crank().angle.to_degrees();
    let velocity = engaged.iter().map(|state| -m.angle(state).rate / m.speed).fold(0.0, f64::max);
    let over: Vec<(f64, f64)> = engaged.iter().map(|state| (degrees(state), -m.angle(state).acceleration / (m.speed * m.speed))).collect();
    let (at, peak) = over.iter().copied().fold((0.0, 0.0), |best, point| if point.1 > best.1 { point } else { best });
    let first = over[0].1;
    println!("peak velocity {velocity:.3} ω, peak acceleration {peak:.3} ω² at {at:.2}°, {first:.3} ω² where the pin enters\n");
    let ratio = (PI / SLOTS).sin();
    let middle = (1.0 + ratio * ratio) / (4.0 * ratio);
    let exact = ((middle * middle + 2.0).sqrt() - middle).acos();
    assert!((at + exact.to_degrees()).abs() < 0.006 && (peak - formula(exact)[2]).abs() < 1e-5);
    assert!((velocity - ratio / (1.0 - ratio)).abs() < 1e-12 && (first - (PI / SLOTS).tan()).abs() < 1e-3);
    Ok(())
}

fn print(m: &Geneva, turn: &[State]) {
    println!("crank °   wheel °   velocity rad/s   acceleration rad/s²");
    for state in turn.iter().step_by(30) {
        let (crank, wheel) = (state.crank().angle.to_degrees(), m.angle(state));
        println!("{crank:7.0}   {:7.3}   {:14.3}   {:19.2}", wheel.value.to_degrees(), wheel.rate + 0.0, wheel.acceleration + 0.0);
    }
}

/// Radius of the locking disc over the distance of the axes.
const LOCK: f64 = 0.52;

/// Outline of the wheel about its axis: slots, and between them hollows for the locking disc.
fn wheel(m: &Geneva) -> Vec<Place> {
    let (part, c) = (PI / SLOTS, m.distance);
    let (rim, pin, bottom) = (c * part.cos(), 0.06 * c, c - c * part.sin());
    let side = (pin / rim).asin();
    let half = ((c * c + (LOCK * c).powi(2) - rim * rim) / (2.0 * LOCK * c * c)).acos();
    let mut outline = Vec::new();
    for slot in (0..SLOTS as u8).map(|number| PI + f64::from(number) * 2.0 * part) {
        outline.push(polar(rim, slot - side));
        outline.extend(steps(-PI / 2.0, -3.0 * PI / 2.0, 12).map(|angle| polar(bottom, slot) + polar(pin, slot + angle)));
        outline.push(polar(rim, slot + side));
        let middle = slot + part;
        outline.extend(steps(half, -half, 24).map(|angle| polar(c, middle) - polar(LOCK * c, middle + angle)));
    }
    outline
}

/// Outline of the locking disc about the crank's axis, cut out where the wheel passes.
fn disc(m: &Geneva) -> Vec<Place> {
    let (c, clear) = (m.distance, 1.03 * m.distance * (PI / SLOTS).cos());
    let half = ((c * c + (LOCK * c).powi(2) - clear * clear) / (2.0 * LOCK * c * c)).acos();
    let cut = ((c * c + clear * clear - (LOCK * c).powi(2)) / (2.0 * c * clear)).acos();
    let round = steps(half, TAU - half, 60).map(|angle| polar(LOCK * c, angle));
    round.chain(steps(cut, -cut, 24).map(|angle| place(c, 0.0) - polar(clear, angle))).collect()
}
