//! Gears with a force between their teeth: motions and forces against the geometry of base circles and against bodies cut free.

use reuleaux::nalgebra::Vector2;
use reuleaux::{PlanarBody, mechanism};

const ALPHA: f64 = 20.0 * core::f64::consts::PI / 180.0;

/// The taut line between the base circles of two gears about `centres`, with signed pitch radii.
struct Taut {
    /// Unit force of pressed teeth on the second gear.
    push: Vector2<f64>,
    /// Points where the line touches the base circles.
    touch: [Vector2<f64>; 2],
}

/// r_1 n and ±r_2 n are the radii of the points of contact: n · (B − A) = r_1 ± r_2. Of two such lines that one is taken whose force turns
/// the first gear to the right for `side` 1.
fn taut(centres: [Vector2<f64>; 2], radii: [f64; 2], alpha: f64, side: f64) -> Taut {
    let [one, two] = radii.map(|radius| radius.abs() * alpha.cos());
    let kind = (radii[0] * radii[1]).signum();
    let between = centres[1] - centres[0];
    let cos = (one + kind * two) / between.norm();
    let (along, across) = (between.normalize(), Vector2::new(-between.y, between.x).normalize());
    let lines = [1.0, -1.0].map(|sign| {
        let normal = along * cos + across * (sign * (1.0 - cos * cos).sqrt());
        let touch = [centres[0] + normal * one, centres[1] - normal * (kind * two)];
        Taut { push: (touch[1] - touch[0]).normalize() * kind, touch }
    });
    let [first, second] = lines;
    if (touch_torque(&first, centres[0]) * side) < 0.0 { first } else { second }
}

fn touch_torque(line: &Taut, centre: Vector2<f64>) -> f64 {
    -(line.touch[0] - centre).perp(&line.push)
}

/// Declares two gears on an arm that turns, one of them driven, one of them braked, at any distance.
macro_rules! cell {
    ($name:ident: $a:literal, $b:literal, $distance:literal) => {
        mechanism! {
            mechanism $name {
                param distance: Length = $distance;
                param line: Angle = 30deg;
                param side: Number = 1;
                ground { point O = (100mm, -50mm); }
                body arm { point B = (distance * cos(line), distance * sin(line));  mass = 2kg;  inertia = 0.05kgm2; }
                body one { mass = 1kg;  inertia = 0.1kgm2; }
                body two { mass = 3kg;  inertia = 0.02kgm2; }
                joint hinge = revolute(ground.O, arm.position);
                joint of_one = revolute(arm.position, one.position);
                joint of_two = revolute(arm.B, two.position);
                joint mesh = involute_mesh(one.position, two.position, $a, $b, line, side: side, carrier: arm);
                force brake = { on two: -5Nm; }
                drive swing = drive_angle(arm, 3rad_s * t + 0.3rad * sin(2rad_s * t));
                drive motor = drive_relative_angle(arm, one, 5rad_s * t + 0.2rad * cos(4rad_s * t));
            }
        }
    };
}

cell!(External: 60mm, 90mm, 150mm);
cell!(InRing: 40mm, -100mm, 60mm);
cell!(RingFirst: 100mm, -40mm, 60mm);
cell!(RingNegative: -100mm, 40mm, 60mm);
cell!(BothNegative: -60mm, -90mm, 150mm);

/// Calls `check` with each cell, its radii, and its state and loads at several times, for both flanks, at and off the design distance.
macro_rules! visit {
    ($check:ident: $($name:ident($a:expr, $b:expr)),*) => {$(
        for (side, further) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 2e-3), (-1.0, 2e-3), (1.0, -1e-3)] {
            let cell = $name { side, distance: f64::abs($a + $b) + further, ..$name::default() };
            for k in 0..12 {
                // Several turns of the arm.
                let state = cell.solve(0.7 * f64::from(k)).expect("a state");
                let loads = cell.loads(&state);
                let bodies = [state.one(), state.two(), state.arm()];
                let at = |load: reuleaux::PlanarLoad<f64, false>| (load.force, load.torque);
                let teeth = [at(loads.mesh_on_one()), at(loads.mesh())];
                let bearings = [loads.of_one().force, loads.of_two().force, loads.hinge().force];
                let efforts = [loads.swing().effort, loads.motor().effort, loads.swing().power, loads.motor().power];
                let found = Found { radii: [$a, $b], side, bodies, teeth, normal: loads.multipliers[6], bearings, efforts };
                $check(stringify!($name), &found);
            }
        }
    )*};
}

struct Found {
    radii: [f64; 2],
    side: f64,
    /// The two gears and the arm.
    bodies: [PlanarBody<f64>; 3],
    /// Forces and torques of the teeth on the gears.
    teeth: [(Vector2<f64>, f64); 2],
    normal: f64,
    /// Forces on the gears and on the arm.
    bearings: [Vector2<f64>; 3],
    /// Torques of both drives, and their power.
    efforts: [f64; 4],
}

fn forces_act_along_the_taut_line(name: &str, found: &Found) {
    let [one, two, arm] = found.bodies;
    let line = taut([one.position, two.position], found.radii, ALPHA, found.side);
    let [arm_of_one, arm_of_two] = [line.touch[0] - one.position, line.touch[1] - two.position];
    // The second gear, cut free.
    let normal = (0.02 * two.angular_acceleration + 5.0) / arm_of_two.perp(&line.push);
    let force = line.push * normal;
    let torque = -arm_of_one.perp(&force);
    let bearings = [one.acceleration + force, two.acceleration * 3.0 - force];
    // The arm, cut free: its drive acts from ground, that of the first gear against it.
    let motor = 0.1 * one.angular_acceleration - torque;
    let swing = 0.05 * arm.angular_acceleration + motor + (two.position - arm.position).perp(&bearings[1]);
    let balances = [
        (found.normal, found.side * normal),
        (found.teeth[1].1, arm_of_two.perp(&force)),
        (found.teeth[0].1, torque),
        (found.efforts[1], motor),
        (found.efforts[0], swing),
    ];
    let vectors = [
        (found.teeth[1].0, force),
        (found.teeth[0].0, -force),
        (found.bearings[0], bearings[0]),
        (found.bearings[1], bearings[1]),
        (found.bearings[2], arm.acceleration * 2.0 + bearings[0] + bearings[1]),
    ];
    let off = balances.iter().map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max);
    let off = vectors.iter().map(|(found, wanted)| (found - wanted).norm()).fold(off, f64::max);
    assert!(off < 1e-9 * normal.abs(), "{name}, side {}: off by {off:e} N of {normal} N", found.side);
    let rate = 0.1 * one.angular_velocity * one.angular_acceleration
        + 0.02 * two.angular_velocity * two.angular_acceleration
        + 0.05 * arm.angular_velocity * arm.angular_acceleration
        + 3.0 * two.velocity.dot(&two.acceleration);
    let power = found.efforts[2] + found.efforts[3] - 5.0 * two.angular_velocity;
    assert!((power - rate).abs() < 1e-10 * found.efforts[2].abs().max(1.0), "{name}: {power} W and {rate} W");
}

#[test]
fn the_force_of_a_mesh_acts_along_the_common_tangent_of_its_base_circles_and_on_bearings() {
    visit!(forces_act_along_the_taut_line: External(0.06, 0.09), InRing(0.04, -0.1), RingFirst(0.1, -0.04), RingNegative(-0.1, 0.04),
        BothNegative(-0.06, -0.09));
}
