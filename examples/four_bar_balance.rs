//! A counterweight on the crank of a four-bar: how much of the shaking force it removes, and its effect on torque and bearings.
//!
//! ```text
//!          A        coupler       B
//!         (o)───────────────────(o)
//!        /                       │ rocker       OA = r₁, AB = r₂, CB = r₃
//!      (o)                      (o)
//!     ● ══════════════════════════C══
//!   weight
//! ```
//!
//! The shaking force of a linkage is the rate of its linear momentum. A weight on the crank minimises its mean square if it balances
//! **all mass that rotates with pin A and half of the mass that oscillates with pin B**, with the coupler replaced by two masses at its
//! pins:
//!
//! ```text
//! m r_W = m₁ c₁ + m₂ (1 − c₂/r₂) r₁ + ½ (m₃ c₃/r₃ + m₂ c₂/r₂) r₁
//! ```
//!
//! The half is exact: averaged over a turn, the projection of B's acceleration on the crank is half of A's. At constant speed the kinetic
//! energy of the weight is constant, so that the torque changes by gravity only.
//!
//! Source: R. L. Norton, Design of Machinery, chapters 6, 7 and 12.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector2;
use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux_examples::{apex, largest_difference, place, polar, round, show, steps};

mechanism! {
    /// A crank-rocker with masses, and a weight on its crank.
    #[picture]
    pub mechanism Balanced {
        param speed: AngularVelocity = 300rpm;
        param weight: Mass = 0kg;

        gravity = (0, -9.81m_s2);
        ground { point C = (200mm, 0mm); }
        body crank   { point A = (50mm, 0mm);  point W = (-60mm, 0mm);  mass = 0.5kg;  center = (25mm, 0mm);  inertia = rod(50mm); }
        body coupler { point B = (200mm, 0mm);  mass = 0.4kg;  center = (80mm, 0mm);  inertia = rod(200mm); }
        body rocker  { point B = (150mm, 0mm);  mass = 0.3kg;  center = (75mm, 0mm);  inertia = rod(150mm);  start angle = 90deg; }
        body disc    { mass = weight; }

        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(ground.C, rocker.position);
        joint bolt = weld(crank.W, disc.position);
        drive motor = drive_angle(crank, speed * t);
    }
}

type State = BalancedState<f64>;

/// Masses (kg), centres from the first pin (m) and lengths (m) of crank, coupler and rocker; from A, O and C.
const LINKS: [[f64; 3]; 3] = [[0.5, 0.025, 0.05], [0.4, 0.08, 0.2], [0.3, 0.075, 0.15]];
/// Distance of the rocker's pivot (m), and of the weight from the axle (m).
const C: f64 = 0.2;
const REACH: f64 = 0.06;
const GRAVITY: f64 = 9.81;

/// At a crank angle: the rate of momentum (N), the power (W) that changes kinetic and potential energy, and the pin forces (N).
struct Exact {
    force: Vector2<f64>,
    power: f64,
    pins: [Vector2<f64>; 4],
}

/// A state with its loads: shaking force, torque, and the forces in the pins O, A, B and C.
struct Loaded {
    state: State,
    shaking: Vector2<f64>,
    torque: f64,
    pins: [Vector2<f64>; 4],
    exact: Exact,
}

fn main() -> Result<(), Box<dyn Error>> {
    let [plain, balanced] = [Balanced::default(), Balanced { weight: rule() / REACH, ..Default::default() }];
    let (before, after) = (turn(&plain)?, turn(&balanced)?);
    for (m, turn) in [(&plain, &before), (&balanced, &after)] {
        assert_momentum_and_power(m, turn);
    }
    assert_rule(&plain, &before, &after);
    print(&before, &after);
    let view =
        View::new("Counterweight of a four-bar", before.iter().zip(&after), |(_, at)| at.state.t, |(_, at)| balanced.scene(&at.state))
            .over("crank", "°", |(_, at)| at.state.crank().angle.to_degrees())
            .outline("disc", round(0.016))
            .trace("path of B", |(_, at)| at.state.rocker().point(place(LINKS[2][2], 0.0)).value)
            .plot("shaking without weight", "N", |(at, _)| at.shaking.norm())
            .and("with it", |(_, at)| at.shaking.norm())
            .against("rate of the momentum", |(at, _)| at.exact.force.norm())
            .against("rate of the momentum", |(_, at)| at.exact.force.norm())
            .plot("torque without weight", "N m", |(at, _)| at.torque)
            .and("with it", |(_, at)| at.torque)
            .against("power balance", |(at, _)| at.exact.power / plain.speed)
            .against("power balance", |(_, at)| at.exact.power / balanced.speed)
            .plot("pin O with the weight", "N", |(_, at)| at.pins[0].norm())
            .and("A", |(_, at)| at.pins[1].norm())
            .and("B", |(_, at)| at.pins[2].norm())
            .and("C", |(_, at)| at.pins[3].norm());
    show("four_bar_balance", &view, 60, &[120, 240])
}

/// Unbalance that the weight should balance: mass times distance from the axle (kg m).
fn rule() -> f64 {
    let [[m1, c1, r1], [m2, c2, r2], [m3, c3, r3]] = LINKS;
    m1 * c1 + m2 * (1.0 - c2 / r2) * r1 + 0.5 * (m3 * c3 / r3 + m2 * c2 / r2) * r1
}

fn turn(m: &Balanced) -> Result<Vec<Loaded>, Box<dyn Error>> {
    let states = m.sweep(steps(0.0, std::f64::consts::TAU / m.speed, 360));
    let mass = LINKS.iter().map(|link| link[0]).sum::<f64>() + m.weight;
    let loaded = |state: State| {
        let loads = m.loads(&state);
        // Ground also carries the weight; the remaining force accelerates the links, and its reaction shakes ground.
        let shaking = loads.o().force + loads.c().force - Vector2::new(0.0, GRAVITY * mass);
        let pins = [loads.o(), loads.a(), loads.b(), loads.c()].map(|load| load.force);
        Loaded { shaking, torque: loads.motor().effort, pins, exact: exact(m, state.crank().angle), state }
    };
    states.map(|state| Ok(loaded(state?))).collect()
}

/// The motion from the vector loop, and the forces from Newton's laws, link by link.
fn exact(m: &Balanced, angle: f64) -> Exact {
    let [[m1, c1, r1], [m2, c2, r2], [m3, c3, r3]] = LINKS;
    let a = polar(r1, angle);
    let b = apex(a, place(C, 0.0), r2, r3);
    let along = [a / r1, (b - a) / r2, (b - place(C, 0.0)) / r3];
    let across = along.map(|e| place(-e.y, e.x));
    // v_A + ω₂ × AB = ω₃ × CB, projected to eliminate one rate at a time; then the same for accelerations.
    let w1 = m.speed;
    let w2 = -w1 * r1 * across[0].dot(&along[2]) / (r2 * across[1].dot(&along[2]));
    let w3 = w1 * r1 * across[0].dot(&along[1]) / (r3 * across[2].dot(&along[1]));
    let inward = -along[0] * r1 * w1 * w1 - along[1] * r2 * w2 * w2 + along[2] * r3 * w3 * w3;
    let (s2, s3) = (-inward.dot(&along[2]) / (r2 * across[1].dot(&along[2])), inward.dot(&along[1]) / (r3 * across[2].dot(&along[1])));
    // At distance c from a pivot: velocity and acceleration.
    let point = |i: usize, c: f64, w: f64, s: f64| [across[i] * c * w, across[i] * c * s - along[i] * c * w * w];
    let ([pin_v, pin_a], [turn_v, turn_a]) = (point(0, r1, w1, 0.0), point(1, c2, w2, s2));
    let masses = [
        (m1, point(0, c1, w1, 0.0)),
        (m.weight, point(0, -REACH, w1, 0.0)),
        (m2, [pin_v + turn_v, pin_a + turn_a]),
        (m3, point(2, c3, w3, s3)),
    ];
    let spin = m2 * r2 * r2 / 12.0 * w2 * s2 + m3 * r3 * r3 / 12.0 * w3 * s3;
    let power = masses.iter().map(|(mass, [v, a])| mass * (v.dot(a) + GRAVITY * v.y)).sum::<f64>() + spin;
    // Forces that accelerate each mass and carry its weight; moments about C on the rocker and about A on the coupler give the force at
    // B.
    let needed = masses.map(|(mass, [_, a])| (a + place(0.0, GRAVITY)) * mass);
    let on_rocker = along[2].perp(&needed[3]) * c3 / r3 + m3 * r3 / 12.0 * s3;
    let on_coupler = -along[1].perp(&needed[2]) * c2 / r2 - m2 * r2 / 12.0 * s2;
    let pin_b = (along[2] * on_coupler - along[1] * on_rocker) / along[1].perp(&along[2]);
    let pin_a = needed[2] + pin_b;
    let pins = [needed[0] + needed[1] + pin_a, pin_a, pin_b, needed[3] - pin_b];
    Exact { force: masses.iter().map(|(mass, [_, a])| a * *mass).sum(), power, pins }
}

/// The shaking force equals the rate of momentum, the motor's power that of the energy, and pin forces balance each link.
fn assert_momentum_and_power(m: &Balanced, turn: &[Loaded]) {
    let (force, power) = (largest(turn), turn.iter().map(|at| at.exact.power.abs()).fold(0.0, f64::max));
    let momentum = largest_difference(turn.iter().map(|at| ((at.shaking - at.exact.force).norm() / force, 0.0)));
    let balance = largest_difference(turn.iter().map(|at| (at.torque * m.speed / power, at.exact.power / power)));
    let pins = turn.iter().flat_map(|at| at.pins.iter().zip(&at.exact.pins)).map(|(pin, exact)| ((pin - exact).norm() / force, 0.0));
    let pins = largest_difference(pins);
    assert!(momentum.max(balance).max(pins) < 2e-14, "momentum is off by {momentum:e}, power by {balance:e}, pins by {pins:e}");
}

/// The rule equals the least-squares projection of the shaking force on the crank; the weight more than halves the force, and changes the
/// torque by its own gravity only.
fn assert_rule(m: &Balanced, before: &[Loaded], after: &[Loaded]) {
    let count = (before.len() - 1) as f64;
    let mean = |of: &dyn Fn(&Loaded) -> f64, turn: &[Loaded]| turn[1..].iter().map(of).sum::<f64>() / count;
    let projection = mean(&|at| -at.shaking.dot(&polar(1.0, at.state.crank().angle)), before) / (m.speed * m.speed);
    assert!((projection / rule() - 1.0).abs() < 1e-13, "{projection} kg m, by the rule {}", rule());
    let square = |turn: &[Loaded]| mean(&|at| at.shaking.norm_squared(), turn);
    let rotating = (rule() * m.speed * m.speed).powi(2);
    assert!(((square(before) - square(after)) / rotating - 1.0).abs() < 1e-12);
    assert!(largest(after) < 0.5 * largest(before));
    let weight = before.iter().zip(after).map(|(b, a)| (a.torque - b.torque, -GRAVITY * rule() * b.state.crank().angle.cos()));
    assert!(largest_difference(weight) < 1e-13);
}

fn largest(turn: &[Loaded]) -> f64 {
    turn.iter().map(|at| at.shaking.norm()).fold(0.0, f64::max)
}

fn print(before: &[Loaded], after: &[Loaded]) {
    println!(
        "weight {:.1} g at {:.0} mm: the shaking force falls from {:.1} N to {:.1} N\n",
        rule() / REACH * 1e3,
        REACH * 1e3,
        largest(before),
        largest(after)
    );
    println!("crank °   shaking N      with    torque N m      with   bearing O N      with");
    for (b, a) in before.iter().zip(after).step_by(30) {
        let (angle, [first, second]) = (b.state.crank().angle.to_degrees(), [b, a].map(|at| at.shaking.norm()));
        println!(
            "{angle:7.1}   {first:9.3}   {second:7.3}   {:11.4}   {:7.4}   {:11.3}   {:7.3}",
            b.torque,
            a.torque,
            b.pins[0].norm(),
            a.pins[0].norm()
        );
    }
}
