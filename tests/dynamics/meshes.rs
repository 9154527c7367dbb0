//! Gears with a force between their teeth: motions and forces against the geometry of base circles and against bodies cut free.

use reuleaux::nalgebra::{Matrix2, SVector, Vector2};
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
    let torque = -(first.touch[0] - centres[0]).perp(&first.push);
    if torque * side < 0.0 { first } else { second }
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
                let teeth = [at(loads.mesh_on_one()), at(loads.mesh()), at(loads.mesh_on_arm())];
                let bearings = [loads.of_one().force, loads.of_two().force, loads.hinge().force];
                let efforts = [loads.swing().effort, loads.motor().effort, loads.swing().power, loads.motor().power];
                let found = Found { radii: [$a, $b], side, bodies, teeth, multiplier: loads.multipliers[6], bearings, efforts };
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
    /// Forces and torques of the teeth on the gears and on the arm.
    teeth: [(Vector2<f64>, f64); 3],
    multiplier: f64,
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
        (found.multiplier * found.radii[0].signum(), found.side * normal * ALPHA.cos()),
        (found.teeth[1].1, arm_of_two.perp(&force)),
        (found.teeth[0].1, torque),
        (found.teeth[2].1, 0.0),
        (found.efforts[1], motor),
        (found.efforts[0], swing),
    ];
    let vectors = [
        (found.teeth[1].0, force),
        (found.teeth[0].0, -force),
        (found.teeth[2].0, Vector2::zeros()),
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

mechanism! {
    mechanism ByForce {
        body one {}
        body two {}
        body three {}
        body arm { point B = (150mm, 0mm);  point C = (150mm, 60mm); }
        joint hinge = revolute(ground.position, arm.position);
        joint of_one = revolute(arm.position, one.position);
        joint of_two = revolute(arm.B, two.position);
        joint of_three = revolute(arm.C, three.position);
        joint outer = involute_mesh(one.position, two.position, 60mm, 90mm, 0deg, c: 5mm, carrier: arm);
        joint inner = involute_mesh(two.position, three.position, 90mm, -30mm, 90deg, side: -1, carrier: arm);
        drive swing = drive_angle(arm, 40rad * sin(2rad_s * t));
        drive motor = drive_angle(one, 70rad * cos(1rad_s * t));
    }
}

mechanism! {
    mechanism ByAngle {
        body one {}
        body two {}
        body three {}
        body arm { point B = (150mm, 0mm);  point C = (150mm, 60mm); }
        joint hinge = revolute(ground.position, arm.position);
        joint of_one = revolute(arm.position, one.position);
        joint of_two = revolute(arm.B, two.position);
        joint of_three = revolute(arm.C, three.position);
        joint outer = gear_pair(one, two, 60mm, 90mm, c: 5mm, carrier: arm);
        joint inner = gear_pair(two, three, 90mm, -30mm, carrier: arm);
        drive swing = drive_angle(arm, 40rad * sin(2rad_s * t));
        drive motor = drive_angle(one, 70rad * cos(1rad_s * t));
    }
}

#[test]
fn at_the_design_distance_a_mesh_moves_as_a_gear_pair_over_many_turns() {
    let (force, angle) = (ByForce::default(), ByAngle::default());
    for k in 0..40 {
        let (force, angle) = (force.solve(0.17 * f64::from(k)).expect("a state"), angle.solve(0.17 * f64::from(k)).expect("a state"));
        let of = |a: &SVector<f64, 12>, b: &SVector<f64, 12>| (a - b).amax();
        let off = of(&force.q, &angle.q).max(of(&force.qd, &angle.qd)).max(of(&force.qdd, &angle.qdd) * 0.1);
        assert!(off < 1e-11, "{k}: {off:e}");
    }
}

/// Declares two gears, the second on a slide that passes the first, so that distance and direction of the centres change.
macro_rules! passing {
    ($name:ident: $a:literal, $b:literal, $side:literal) => {
        mechanism! {
            mechanism $name {
                body one { mass = 1kg;  inertia = 0.1kgm2; }
                body two { mass = 3kg;  inertia = 0.02kgm2; }
                body slide { mass = 0.5kg;  start position = (61mm, 10mm); }
                joint of_one = revolute(ground.position, one.position);
                joint guide = translational((1, 0), (0mm, 10mm), slide.position);
                joint of_two = revolute(slide.position, two.position);
                joint mesh = involute_mesh(one.position, two.position, $a, $b, 0deg, side: $side);
                force brake = { on two: -5Nm; }
                drive push = drive_x(slide.position, abs($a + $b) + 2mm * sin(3rad_s * t));
                drive motor = drive_angle(one, 5rad * sin(2rad_s * t));
            }
        }
    };
}

passing!(PassingExternal: 60mm, 90mm, 1);
passing!(PassingExternalBehind: 60mm, 90mm, -1);
passing!(PassingInRing: 40mm, -100mm, 1);
passing!(PassingInRingBehind: 40mm, -100mm, -1);
passing!(PassingRing: 100mm, -40mm, 1);

/// Twice the same angle, by the turns between: both lie within half a turn of each other.
fn near(angle: f64, other: f64) -> f64 {
    other + (angle - other).sin().atan2((angle - other).cos())
}

#[test]
fn a_line_unwinds_from_one_base_circle_onto_the_other_while_the_centres_pass() {
    macro_rules! unwinds {
        ($($name:ident($a:expr, $b:expr, $side:expr)),*) => {$(
            let (passing, mut first) = ($name::default(), None);
            for k in 0..40 {
                let state = passing.solve(0.11 * f64::from(k)).expect("a state");
                let (one, two, loads) = (state.one(), state.two(), passing.loads(&state));
                let line = taut([one.position, two.position], [$a, $b], ALPHA, $side);
                let kind = f64::signum($a * $b);
                let [r_one, r_two] = [$a, $b].map(|radius| f64::abs(radius) * ALPHA.cos());
                // Directions of the points of contact, and the lengths that have unwound since.
                let [d_one, d_two] = [line.touch[0] - one.position, line.touch[1] - two.position].map(|radius| radius.y.atan2(radius.x));
                let (before_one, before_two, was) = *first.get_or_insert((d_one, d_two, None));
                let side: f64 = $side;
                let unwound = side * (r_one * (one.angle - near(d_one, before_one)) + kind * r_two * (two.angle - near(d_two, before_two)));
                let rest = unwound - kind * (line.touch[1] - line.touch[0]).norm();
                let was: f64 = was.unwrap_or(rest);
                first = Some((before_one, before_two, Some(was)));
                assert!((rest - was).abs() < 1e-14, "{}: off by {:e} m", stringify!($name), rest - was);
                let rate = 0.1 * one.angular_velocity * one.angular_acceleration
                    + 0.02 * two.angular_velocity * two.angular_acceleration
                    + 3.5 * two.velocity.dot(&two.acceleration);
                let power = loads.push().power + loads.motor().power - 5.0 * two.angular_velocity;
                assert!((power - rate).abs() < 1e-10, "{}: {power} W and {rate} W", stringify!($name));
            }
        )*};
    }
    unwinds!(
        PassingExternal(0.06, 0.09, 1.0),
        PassingExternalBehind(0.06, 0.09, -1.0),
        PassingInRing(0.04, -0.1, 1.0),
        PassingInRingBehind(0.04, -0.1, -1.0),
        PassingRing(0.1, -0.04, 1.0)
    );
}

#[test]
fn base_circles_without_a_taut_line_between_them_have_no_state() {
    let near = External { distance: 0.15 * ALPHA.cos() + 1e-4, ..External::default() };
    assert!(near.solve(0.1).is_ok());
    let nearer = External { distance: 0.15 * ALPHA.cos() - 1e-4, ..External::default() };
    assert!(nearer.solve(0.1).is_err());
}

mechanism! {
    /// A sun of 24 teeth drives an arm by a planet of 18, which rolls in a ring of 60 on ground, and an equal planet opposite it.
    mechanism Gearbox {
        ground { point O = (20mm, 30mm); }
        body sun    { mass = 1kg;  inertia = 0.01kgm2; }
        body planet { mass = 0.4kg;  inertia = 0.002kgm2; }
        body arm    { point A = (84mm, 0mm);  mass = 2kg;  inertia = 0.03kgm2; }
        joint of_sun = revolute(ground.O, sun.position);
        joint of_arm = revolute(ground.O, arm.position);
        joint pin = revolute(arm.A, planet.position);
        joint inner = involute_mesh(sun.position, planet.position, 48mm, 36mm, 0deg, carrier: arm);
        joint outer = involute_mesh(planet.position, ground.O, 36mm, -120mm, 180deg, side: -1, carrier: arm);
        force brake = { on arm: -40Nm; }
        drive motor = drive_angle(sun, 3.5 * 3 * 360deg * cycloidal(t / 2s));
    }
}

#[test]
fn the_teeth_and_bearings_of_a_planetary_gear_carry_its_torque_over_three_turns_of_the_arm() {
    let gearbox = Gearbox::default();
    for k in 0..=40 {
        let state = gearbox.solve(0.05 * f64::from(k)).expect("a state");
        let (sun, planet, arm, loads) = (state.sun(), state.planet(), state.arm(), gearbox.loads(&state));
        // Willis.
        let off = (24.0 * (sun.angle - arm.angle) - 60.0 * arm.angle).abs();
        let off = off.max((24.0 * (sun.angle - arm.angle) + 18.0 * (planet.angle - arm.angle)).abs());
        assert!(off < 1e-11, "off by {off:e}");
        // Arm and planet, cut free, for the forces of both meshes.
        let inner = taut([sun.position, planet.position], [0.048, 0.036], ALPHA, 1.0);
        let outer = taut([planet.position, sun.position], [0.036, -0.12], ALPHA, -1.0);
        let [lever_inner, lever_outer] = [inner.touch[1] - planet.position, outer.touch[0] - planet.position];
        let out = planet.position - sun.position;
        let rows =
            Matrix2::new(lever_inner.perp(&inner.push), -lever_outer.perp(&outer.push), out.perp(&inner.push), -out.perp(&outer.push));
        let turned = 0.03 * arm.angular_acceleration + 40.0 + out.perp(&planet.acceleration) * 0.4;
        let forces = rows.try_inverse().expect("two meshes") * Vector2::new(0.002 * planet.angular_acceleration, turned);
        let (of_sun, of_ring) = (inner.push * forces.x, -outer.push * forces.y);
        let pin = planet.acceleration * 0.4 - of_sun - of_ring;
        let vectors = [
            (loads.inner().force, of_sun),
            (loads.inner_on_sun().force, -of_sun),
            (loads.outer().force, of_ring),
            (loads.pin().force, pin),
            (loads.of_sun().force, of_sun),
            (loads.of_arm().force, pin),
        ];
        let off = vectors.iter().map(|(found, wanted)| (found - wanted).norm()).fold(0.0, f64::max);
        assert!(off < 1e-9 * of_sun.norm(), "{k}: off by {off:e} N");
        assert!(k > 0 || of_sun.norm() > 100.0);
        let power = loads.motor().power - 40.0 * arm.angular_velocity;
        let rate = 0.01 * sun.angular_velocity * sun.angular_acceleration
            + 0.002 * planet.angular_velocity * planet.angular_acceleration
            + 0.03 * arm.angular_velocity * arm.angular_acceleration
            + 0.4 * planet.velocity.dot(&planet.acceleration);
        assert!((power - rate).abs() < 1e-10 * loads.motor().power.abs().max(1.0), "{k}: {power} W and {rate} W");
    }
    let turns = gearbox.solve(2.0).expect("a state").arm().angle / core::f64::consts::TAU;
    assert!((turns - 3.0).abs() < 1e-13);
}

#[test]
fn further_planets_are_checks() {
    mechanism! {
        mechanism Balanced {
            body sun {}
            body arm { point A = (84mm, 0mm);  point B = (-84mm, 0mm); }
            body first {}
            body second {}
            joint of_sun = revolute(ground.position, sun.position);
            joint of_arm = revolute(ground.position, arm.position);
            joint pin = revolute(arm.A, first.position);
            joint other_pin = revolute(arm.B, second.position);
            joint inner = involute_mesh(sun.position, first.position, 48mm, 36mm, 0deg, carrier: arm);
            joint outer = involute_mesh(first.position, ground.position, 36mm, -120mm, 180deg, side: -1, carrier: arm);
            joint other_inner = involute_mesh(sun.position, second.position, 48mm, 36mm, 180deg, carrier: arm);
            redundant joint other_outer = involute_mesh(second.position, ground.position, 36mm, -120mm, 0deg, side: -1, carrier: arm);
            drive motor = drive_angle(sun, 20rad_s * t);
        }
    }
    let state = Balanced::default().solve(3.0).expect("a state");
    assert!((state.first().angle - state.second().angle).abs() < 1e-12 && (state.arm().angle - 60.0 / 3.5).abs() < 1e-12);
}

mechanism! {
    /// A pinion drives a rack, whose point lies beside the pitch line.
    mechanism Rack {
        ground { point O = (0mm, 50mm); }
        body pinion { mass = 1kg;  inertia = 0.01kgm2; }
        body rack   { point beside = (0mm, -7mm);  mass = 2kg; }
        joint bearing = revolute(ground.O, pinion.position);
        joint guide = translational((1, 0), (0mm, 0mm), rack.position);
        joint mesh = rack_pinion(pinion, rack.beside, (1, 0), ground.position, -50mm);
        force load = { at rack.position: (-30N, 0N); }
        drive motor = drive_angle(pinion, 1rad * sin(2rad_s * t) + 0.1rad * cos(3rad_s * t));
    }
}

/// Bodies cut free, with a force at the pitch point: its part along the rack drives the rack, the other separates the teeth.
#[test]
fn bearing_and_guide_of_a_rack_carry_more_than_its_row_says() {
    let rack = Rack::default();
    for k in 0..20 {
        let state = rack.solve(0.13 * f64::from(k)).expect("a state");
        let (pinion, bar, loads) = (state.pinion(), state.rack(), rack.loads(&state));
        let driving = 2.0 * bar.acceleration.x + 30.0;
        let separating = driving.abs() * ALPHA.tan();
        let on_pinion = Vector2::new(-driving, separating);
        let contact = pinion.position - Vector2::new(0.0, 0.05);
        let on_guide = (contact - bar.position).perp(&-on_pinion);
        let lambda = loads.multipliers[4];
        let balances = [
            (lambda.abs() / ALPHA.cos(), on_pinion.norm()),
            (loads.mesh_on_pinion().torque, (contact - pinion.position).perp(&on_pinion)),
            (loads.mesh().force.x, driving),
            (loads.bearing().force.x - lambda, -on_pinion.x),
            (loads.bearing().force.y - separating, -on_pinion.y),
            (loads.guide().force.y + separating, on_pinion.y),
            (loads.guide().torque - lambda * 0.007 - bar.position.x * separating, -on_guide),
            (loads.motor().effort, 0.01 * pinion.angular_acceleration - (contact - pinion.position).perp(&on_pinion)),
        ];
        let off = balances.iter().map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max);
        assert!(off < 1e-10, "{k}: {balances:?}");
    }
}

/// A belt as a constraint, and the same pulleys with the forces of its two strands, which hold the second pulley without its drive.
macro_rules! belts {
    ($by_row:ident, $by_force:ident: $a:literal, $b:literal) => {
        mechanism! {
            mechanism $by_row {
                ground { point B = (500mm, 0mm); }
                body one {}
                body two {}
                joint of_one = revolute(ground.position, one.position);
                joint of_two = revolute(ground.B, two.position);
                joint strap = belt(one, two, $a, $b);
                force brake = { on two: -6Nm; }
                drive motor = drive_angle(one, 3rad_s * t);
            }
        }
        mechanism! {
            mechanism $by_force {
                param first: Force = 0N;
                param second: Force = 0N;
                let sine = ($a - $b) / 500mm;
                let cosine = sqrt(1 - sine^2);
                ground { point B = (500mm, 0mm); }
                body one { point U = ($a * sine, $a * cosine);  point V = ($a * sine, -$a * cosine); }
                body two { point U = ($b * sine, $b * cosine);  point V = ($b * sine, -$b * cosine); }
                joint of_one = revolute(ground.position, one.position);
                joint of_two = revolute(ground.B, two.position);
                force strands = {
                    at one.U: first * unit(two.U - one.U);
                    at two.U: first * unit(one.U - two.U);
                    at one.V: second * unit(two.V - one.V);
                    at two.V: second * unit(one.V - two.V);
                    on two: -6Nm;
                }
                drive motor = drive_angle(one, 3rad_s * t);
                drive other = drive_angle(two, 3rad_s * t);
            }
        }
    };
}

belts!(OpenRow, OpenForce: 120mm, 80mm);
belts!(CrossedRow, CrossedForce: 120mm, -80mm);

#[test]
fn shafts_of_a_belt_carry_its_tension_and_pretension() {
    macro_rules! shafts {
        ($($row:ident, $force:ident, $b:expr);*) => {$(
            let row = $row::default();
            let loads = row.loads(&row.solve(0.0).expect("a state"));
            let lambda = loads.multipliers[4];
            assert!(loads.of_one().force.norm() + loads.of_two().force.norm() < 1e-13);
            assert!((loads.strap_on_one().torque + 0.12 * lambda).abs() < 1e-13 && (loads.strap().torque - $b * lambda).abs() < 1e-13);
            let rest = 60.0;
            let strands = $force { first: rest + 0.5 * lambda, second: rest - 0.5 * lambda };
            let found = strands.loads(&strands.solve(0.0).expect("a state"));
            // The strands do all that the row does.
            assert!(found.other().effort.abs() < 1e-12 && (found.motor().effort - loads.motor().effort).abs() < 1e-12);
            let sine = (0.12 - $b) / 0.5;
            let cosine = f64::sqrt(1.0 - sine * sine);
            let shaft = Vector2::new(2.0 * rest * cosine, -lambda * sine);
            assert!((found.of_one().force + shaft).norm() < 1e-12 && (found.of_two().force - shaft).norm() < 1e-12);
            assert!(lambda.abs() > 50.0);
        )*};
    }
    shafts!(OpenRow, OpenForce, 0.08; CrossedRow, CrossedForce, -0.08);
}

mechanism! {
    /// A planet whose mesh was declared without its carrier.
    mechanism WithoutCarrier {
        body sun {}
        body planet {}
        body arm { point A = (84mm, 0mm); }
        joint of_sun = revolute(ground.position, sun.position);
        joint of_arm = revolute(ground.position, arm.position);
        joint pin = revolute(arm.A, planet.position);
        joint mesh = involute_mesh(sun.position, planet.position, 48mm, 36mm, 0deg);
        drive swing = drive_angle(arm, 1rad_s * t);
        drive motor = drive_angle(sun, 2rad_s * t);
    }
}

/// The line of centres turns away from that of the mesh, and after a quarter of a turn the row has no value: nothing jumps.
#[test]
fn a_mesh_without_its_carrier_ends_with_a_quarter_of_a_turn() {
    let mechanism = WithoutCarrier::default();
    let mut last = 0.0;
    for state in mechanism.sweep((0..400).map(|k| 0.01 * f64::from(k))) {
        let Ok(state) = state else { break };
        // 48 (φ_sun − φ_arm) + 36 (φ_planet − φ_arm) = 0
        let planet = (84.0 * state.arm().angle - 48.0 * state.sun().angle) / 36.0;
        assert!((state.planet().angle - planet).abs() < 1e-12);
        last = state.t;
    }
    assert!(last > 1.5 && last < core::f64::consts::FRAC_PI_2, "{last}");
}
