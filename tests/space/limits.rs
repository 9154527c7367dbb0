//! Near singular poses, far away, after many turns: all digits that rounding leaves are right, or there is a verdict.
//!
//! Closed forms are evaluated with twice the digits. The attainable error is found there as well: the change of the answer when each
//! number that goes in is off by one rounding.

use reuleaux::nalgebra::{Matrix6, Rotation3, SVector, Vector3};
use reuleaux::{Cause, Motion, Real, mechanism};
use reuleaux_tests::common::twofold::Twofold;

/// 2⁻⁵³
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Errors are at most this many times the attainable one.
const SHARE: f64 = 64.0;

fn two(value: f64) -> Twofold {
    Twofold::of(value)
}

/// Exact numbers and their attainable errors: one rounding of the number, and the changes that one rounding of each input causes. Each input
/// has a size, of which the rounding is a share.
fn attainable<const K: usize>(inputs: &[(f64, f64)], exact: impl Fn(&[Twofold]) -> [Twofold; K]) -> [(Twofold, f64); K] {
    let given: Vec<Twofold> = inputs.iter().map(|(value, _)| two(*value)).collect();
    let answer = exact(&given);
    let mut limits = answer.map(|number| (number, ROUNDING * number.high.abs()));
    for (index, (_, size)) in inputs.iter().enumerate() {
        let mut off = given.clone();
        off[index] = off[index] + two(ROUNDING * size);
        for ((number, limit), changed) in limits.iter_mut().zip(exact(&off)) {
            *limit += (changed - *number).high.abs();
        }
    }
    limits
}

/// The largest error, in units of the attainable one.
fn share<const K: usize>(found: [f64; K], limits: [(Twofold, f64); K]) -> f64 {
    let errors = found.into_iter().zip(limits).map(|(found, (exact, limit))| (two(found) - exact).high.abs() / limit);
    errors.fold(0.0, |worst: f64, error| if error.is_nan() || error > worst { error } else { worst })
}

/// Coordinates after many turns, from those without and those after one.
fn after_turns<const N: usize>(at: impl Fn(f64) -> SVector<f64, N>, angle: f64, turns: f64) -> SVector<f64, N> {
    let first = angle - turns * std::f64::consts::TAU;
    let begin = at(first);
    begin + (at(first + std::f64::consts::TAU) - begin).map(|way| (way / std::f64::consts::TAU).round() * std::f64::consts::TAU * turns)
}

fn parts(motion: Motion<f64>) -> [f64; 3] {
    [motion.value, motion.rate, motion.acceleration]
}

/// Where a mechanism has no answer, it is singular.
fn is_verdict<T>(cause: &Cause<T>) -> bool {
    matches!(cause, Cause::Singular { .. })
}

mechanism! {
    /// Two shafts with a cross between them.
    mechanism Cross in space {
        param bend: Angle = 30deg;
        ground { axis input = (1, 0, 0) from (0, 0, 1);  axis output = (cos(bend), sin(bend), 0) from (0, 0, 1); }
        body input  { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 0, 1); }
        body output { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 1, 0);  start orientation = turn((0, 0, 1), bend); }
        joint one = revolute(ground.position, ground.input, input.position, input.x);
        joint two = revolute(ground.position, ground.output, output.position, output.x);
        joint pin = perpendicular_axes(input.arm, output.arm);
        drive motor = drive_rotation(one, 1rad_s * t);
        output angle = two.angle;
    }
}

/// tan φ₂ = cos β tan φ₁, with its derivatives by φ₁.
fn cross(angle: Twofold, cosine: Twofold) -> [Twofold; 3] {
    let (sin, cos) = angle.sin_cos();
    let size = cos * cos + cosine * cosine * sin * sin;
    let second = two(2.0) * sin * cos * cosine * (two(1.0) - cosine * cosine) / (size * size);
    [(cosine * sin).atan2(cos), cosine / size, second]
}

/// The nearer the bend is to a right angle, the more of its half turn the output makes at once.
#[test]
fn a_cross_with_a_bend_towards_a_right_angle() {
    for off in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8] {
        let mechanism = Cross { bend: std::f64::consts::FRAC_PI_2 - off };
        let cosine = two(mechanism.bend).sin_cos().1;
        let (mut worst, mut solved) = (0.0_f64, 0);
        for angle in [0.3, 0.9, 1.3, 1.5, 1.55, 1.57] {
            match mechanism.solve(angle) {
                Ok(state) => {
                    solved += 1;
                    let exact = attainable(&[(angle, 1.0), (0.0, 1.0)], |given| cross(given[0], cosine + given[1]));
                    worst = worst.max(share(parts(mechanism.angle(&state)), exact));
                }
                Err(failure) => assert!(is_verdict(&failure.cause), "{off:e}, {angle}: {failure}"),
            }
        }
        println!("{off:e} from a right angle: {solved} of 6, {worst:.2} of what is attainable");
        assert!(worst <= SHARE && solved > 3, "{off:e}: {worst:e}, {solved} of 6");
    }
}

/// A million turns, in both senses.
#[test]
fn a_cross_after_a_million_turns() {
    let mechanism = Cross::default();
    let cosine = two(mechanism.bend).sin_cos().1;
    for turns in [1e3, -1e6, 1e6] {
        let angle = turns * std::f64::consts::TAU + 0.7;
        let guess = after_turns(|angle| mechanism.solve(angle).expect("a state").q, angle, turns);
        let state = mechanism.solve_near(angle, &guess).unwrap_or_else(|failure| panic!("{failure}"));
        let exact = attainable(&[(angle, angle.abs()), (0.0, 1.0)], |given| {
            let [value, rate, second] = cross(given[0], cosine + given[1]);
            [value, rate, second]
        });
        let found = mechanism.angle(&state);
        // Whole turns are those of the input.
        let rest = (found.value - angle + 0.7).rem_euclid(std::f64::consts::TAU);
        assert!((rest - exact[0].0.high).abs() < SHARE * ROUNDING * angle.abs(), "{turns:e}: {rest}");
        assert!((found.value - angle).abs() < 0.2, "{turns:e}: {}", found.value);
        let worst = share([found.rate, found.acceleration], [exact[1], exact[2]]);
        assert!(worst <= SHARE, "{turns:e}: {worst:e}");
    }
}

mechanism! {
    /// Three revolutes of a wrist hold a tool as a target on a tilted axle stands: at a target angle of zero the first and the last are in line.
    mechanism Wrist in space {
        param from: Angle = 1rad;
        let tilt = 0.5rad;
        ground { axis z = (0, 0, 1) from (1, 0, 0);  axis axle = (sin(tilt), 0, cos(tilt)) from (0, 1, 0); }
        body target { axis axle = (sin(tilt), 0, cos(tilt)) from (0, 1, 0);  axis z = (0, 0, 1) from (1, 0, 0); }
        body first  { axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0) from (0, 0, 1);  start orientation = turn((0, 0, 1), -64deg); }
        body second { axis y = (0, 1, 0) from (0, 0, 1);  axis z = (0, 0, 1) from (1, 0, 0);  start orientation = turn((0, 0, 1), -64deg) * turn((0, 1, 0), 26deg); }
        body tool   { axis z = (0, 0, 1) from (1, 0, 0);  start orientation = turn((sin(tilt), 0, cos(tilt)), 1rad); }
        joint bearing = revolute(ground.position, ground.axle, target.position, target.axle);
        joint one = revolute(ground.position, ground.z, first.position, first.z);
        joint two = revolute(first.position, first.y, second.position, second.y);
        joint three = revolute(second.position, second.z, tool.position, tool.z);
        joint same = absolute_orientation(target.z, tool.z);
        drive motor = drive_rotation(bearing, from + 1rad_s * t);
        output first = one.angle;
        output middle = two.angle;
        output last = three.angle;
    }
}

/// The angles in closed form, by half of the target's: values, then rates.
fn wrist(angle: Twofold) -> [Twofold; 6] {
    let ((s, c), (sin, cos)) = (two(0.5).sin_cos(), (angle * two(0.5)).sin_cos());
    let side = s * sin;
    let rate = c * two(0.5) / (c * c * sin * sin + cos * cos);
    [(-cos).atan2(c * sin), two(2.0) * side.asin(), cos.atan2(-(c * sin)), rate, s * cos / (two(1.0) - side * side).sqrt(), rate]
}

/// The first and the last of three revolutes nearly in line: angles are as uncertain as roundings over β, rates as over β².
#[test]
fn revolutes_nearly_in_line() {
    let mechanism = Wrist::default();
    for angle in [1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let time = angle - 1.0;
        // The angle that the drive gives.
        let exact = wrist(two(mechanism.from) + two(time));
        let beta = exact[1].high;
        match mechanism.solve(time) {
            Ok(state) => {
                let [a, b, c] = [mechanism.first(&state), mechanism.middle(&state), mechanism.last(&state)];
                let found = [a.value, b.value, c.value, a.rate, b.rate, c.rate];
                let turns =
                    |k: usize, error: f64| if k < 3 { (error / std::f64::consts::TAU).round() * std::f64::consts::TAU } else { 0.0 };
                let mut worst = 0.0_f64;
                for (k, (found, exact)) in found.into_iter().zip(exact).enumerate() {
                    let error = (two(found) - exact).high;
                    let error = if k < 3 { error - turns(k, error) } else { error };
                    let limit = ROUNDING / if k < 3 { beta } else { beta * beta };
                    worst = worst.max(error.abs() / limit);
                }
                println!("{angle:e}: {worst:.2} of what is attainable, condition {:.1e}", state.condition);
                assert!(worst <= SHARE, "{angle:e}: {worst:e}");
            }
            Err(failure) => {
                println!("{angle:e}: {failure}");
                assert!(is_verdict(&failure.cause) && angle < 1e-3, "{angle:e}: {failure}");
            }
        }
    }
}

mechanism! {
    /// A crank across the way of its slide, wherever it stands and of whatever size.
    mechanism Across in space {
        param far: Length = 0mm;
        param radius: Length = 80mm;
        param length: Length = 300mm;
        ground {
            point O = (far, far + 100mm, far + 120mm);  point P = (far, far, far);
            axis axle = (1, 0, 0) from (0, 0, 1);
        }
        body crank { axis axle = (1, 0, 0) from (0, 0, 1);  point A = (0mm, 0mm, radius); }
        body slide { axis way = (1, 0, 0) from (0, 0, 1);  start position = (far + 200mm, far, far); }
        joint axle = revolute(ground.O, ground.axle, crank.position, crank.axle);
        joint rod = distance(crank.A, slide.position, length);
        joint rail = translational(ground.P, ground.axle, slide.position, slide.way);
        drive turn = drive_rotation(axle, 1rad_s * t);
        output stroke = rail.displacement;
    }
}

/// Place, speed and acceleration of the slide along its way: X² = L² − d².
fn across(angle: Twofold, radius: Twofold, length: Twofold, offset: [Twofold; 2]) -> [Twofold; 3] {
    let (sin, cos) = angle.sin_cos();
    let d = [offset[0] - radius * sin, offset[1] + radius * cos];
    let (rate, second) = ([-(radius * cos), -(radius * sin)], [radius * sin, -(radius * cos)]);
    let dot = |a: [Twofold; 2], b: [Twofold; 2]| a[0] * b[0] + a[1] * b[1];
    let x = (length * length - dot(d, d)).sqrt();
    let speed = -(dot(d, rate) / x);
    [x, speed, -((speed * speed + dot(rate, rate) + dot(d, second)) / x)]
}

/// Asserts that the slide moves as in closed form, at a few angles and after turns.
fn slides(mechanism: &Across, turns: f64) {
    let (mut worst, mut count) = (0.0_f64, 0);
    for angle in [0.1, 1.0, 2.5, 4.0, 5.9].map(|angle| angle + turns * std::f64::consts::TAU) {
        let guess = after_turns(|angle| mechanism.solve(angle).expect("a state").q, angle, turns);
        let state = mechanism.solve_near(angle, &guess).unwrap_or_else(|failure| panic!("{failure}"));
        let Across { far, radius, length } = *mechanism;
        // The offsets as they are in doubles, where everything far away is rounded.
        let offset = [two(far + 0.1) - two(far), two(far + 0.12) - two(far)];
        let size = far.abs() + length;
        let inputs = [(angle, angle.abs()), (radius, radius), (length, length), (0.0, size), (0.0, size), (0.0, size)];
        let exact = attainable(&inputs, |given| {
            let [x, speed, second] = across(given[0], given[1], given[2], [offset[0] + given[3], offset[1] + given[4]]);
            [x + given[5], speed, second]
        });
        worst = worst.max(share(parts(mechanism.stroke(&state)), exact));
        count += 1;
    }
    println!("{mechanism:?}, {turns} turns: {worst:.2} of what is attainable");
    assert!(worst <= SHARE && count == 5, "{mechanism:?}, {turns} turns: {worst:e}");
}

#[test]
fn a_crank_a_thousand_kilometres_from_the_origin() {
    for far in [1.0, 1e3, -1e6, 1e6] {
        slides(&Across { far, ..Across::default() }, 0.0);
    }
}

#[test]
fn a_crank_after_a_million_turns() {
    for turns in [1e3, 1e6, -1e6] {
        slides(&Across::default(), turns);
    }
}

#[test]
fn a_crank_of_micrometres_beside_metres() {
    for (radius, length) in [(1e-3, 3.0), (1e-6, 3.0), (1e-9, 30.0)] {
        slides(&Across { radius, length, ..Across::default() }, 0.0);
    }
}

mechanism! {
    /// A nut lifts a slide that goes along a way nearly across its screw.
    mechanism Wedge in space {
        /// Of the way with the plane that the nut lifts.
        param slope: Angle = 30deg;
        ground { axis z = (0, 0, 1) from (1, 0, 0);  axis way = (cos(slope), 0, sin(slope)) from (0, 1, 0); }
        body nut   { axis z = (0, 0, 1) from (1, 0, 0); }
        body slide { axis way = (1, 0, 0) from (0, 1, 0);  start orientation = turn((0, 1, 0), -slope); }
        joint thread = screw(ground.position, ground.z, nut.position, nut.z, 2mm);
        joint rail = translational(ground.position, ground.way, slide.position, slide.way);
        joint rest = point_on_plane(nut.position, nut.z, slide.position);
        drive motor = drive_rotation(thread, 3rad_s * t);
        output lift = thread.displacement;
        output travel = rail.displacement;
    }
}

#[test]
fn a_screw_that_pushes_nearly_across() {
    for slope in [1e-1, 1e-3, 1e-6, 1e-9] {
        for time in [0.5, 1e2, 2.1e6] {
            let mechanism = Wedge { slope };
            match mechanism.solve(time) {
                Ok(state) => {
                    let inputs = [(time, time), (0.0, 1.0), (0.0, 0.1)];
                    let exact = attainable(&inputs, |given| {
                        let turn = two(2e-3) / (two(4.0) * two(1.0).atan() * two(2.0));
                        let lift = turn * two(3.0) * given[0] + given[2];
                        let sine = two(slope).sin_cos().0 + given[1];
                        [lift, lift / sine, turn * two(3.0) / sine]
                    });
                    let travel = mechanism.travel(&state);
                    let worst = share([mechanism.lift(&state).value, travel.value, travel.rate], exact);
                    assert!(worst <= SHARE, "{slope:e} at {time}: {worst:e}");
                }
                Err(failure) => assert!(is_verdict(&failure.cause) && slope < 1e-5, "{slope:e} at {time}: {failure}"),
            }
        }
    }
}

mechanism! {
    /// A platform on six legs between corners of two hexagons: turned by a right angle it can give way.
    mechanism Platform in space {
        /// By which it is turned at t = 0.
        param from: Angle = 30deg;
        let twist = from + 1rad_s * t;
        let height = 500mm;
        ground { for i in 0..6 { point P[i] = (600mm * cos(60deg * i), 600mm * sin(60deg * i), 0mm); } }
        body plate {
            for i in 0..6 { point P[i] = (300mm * cos(60deg * i), 300mm * sin(60deg * i), 0mm); }
            start position = (0mm, 0mm, height);
            start orientation = turn((0, 0, 1), 30deg);
        }
        for i in 0..6 {
            drive leg[i] = drive_distance(ground.P[i], plate.P[(i + 5 * (i % 2) + 5) % 6], sqrt(height^2 + (600mm)^2 + (300mm)^2
                - 2 * 600mm * 300mm * cos(twist + 60deg * ((i + 5 * (i % 2) + 5) % 6) - 60deg * i)));
        }
    }
}

/// The smallest singular value of unit forces along the legs, torques by the radius of the plate.
fn stiffness(twist: f64) -> f64 {
    let at = |radius: f64, i: usize| {
        Vector3::new(radius * (i as f64 * 60_f64.to_radians()).cos(), radius * (i as f64 * 60_f64.to_radians()).sin(), 0.0)
    };
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), twist);
    let mut matrix = Matrix6::zeros();
    for i in 0..6 {
        let arm = turn * at(0.3, (i + 5 * (i % 2) + 5) % 6);
        let leg = (Vector3::new(0.0, 0.0, 0.5) + arm - at(0.6, i)).normalize();
        matrix.fixed_view_mut::<1, 3>(i, 0).copy_from(&leg.transpose());
        matrix.fixed_view_mut::<1, 3>(i, 3).copy_from(&(arm.cross(&leg) / 0.3).transpose());
    }
    matrix.singular_values().min()
}

/// Of all poses of this motion one is singular; on the way there positions are as uncertain as roundings over the least singular value.
#[test]
fn a_platform_towards_its_singular_pose() {
    let mechanism = Platform::default();
    let singular = (0..900).map(|k| f64::from(k) * 0.1).min_by(|a, b| stiffness(a.to_radians()).total_cmp(&stiffness(b.to_radians())));
    let singular = singular.expect("a pose");
    println!("singular at {singular}°: {:e}", stiffness(singular.to_radians()));
    assert!(stiffness(singular.to_radians()) < 1e-12);
    for off in [10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6] {
        let twist = if singular > 30.0 { singular - off } else { singular + off }.to_radians();
        let least = stiffness(twist);
        match mechanism.solve(twist - mechanism.from) {
            Ok(state) => {
                let plate = state.plate();
                let exact = Rotation3::from_axis_angle(&Vector3::z_axis(), twist).into_inner();
                let place = (plate.position - Vector3::new(0.0, 0.0, 0.5)).norm().max((plate.rotation - exact).norm());
                let speed = plate.velocity.norm().max((plate.angular_velocity - Vector3::z()).norm());
                let [place, speed] = [place * least / ROUNDING, speed * least * least / ROUNDING];
                println!(
                    "{off:e}°: {place:.2} and {speed:.2} of what is attainable, least singular value {least:.1e}, condition {:.1e}",
                    state.condition
                );
                assert!(place <= SHARE && speed <= SHARE, "{off:e}°: {place:e}, {speed:e}");
            }
            Err(failure) => {
                println!("{off:e}°: {failure}");
                assert!(is_verdict(&failure.cause) && off < 0.5, "{off:e}°: {failure}");
            }
        }
    }
}

mechanism! {
    /// Bennett's linkage.
    mechanism Bennett in space {
        param twist: Angle = 40deg;
        param other_twist: Angle = 70deg;
        let length = 100mm;
        let other = length * sin(other_twist) / sin(twist);
        ground { axis z = (0, 0, 1) from (1, 0, 0);  point end = (length, 0mm, 0mm);  axis end_z = (0, -sin(twist), cos(twist)) from (1, 0, 0); }
        body second { axis z = (0, 0, 1) from (1, 0, 0);  point end = (other, 0mm, 0mm);  axis end_z = (0, -sin(other_twist), cos(other_twist)) from (1, 0, 0); }
        body third { axis z = (0, 0, 1) from (1, 0, 0);  point end = (length, 0mm, 0mm);  axis end_z = (0, -sin(twist), cos(twist)) from (1, 0, 0); }
        body fourth {
            axis z = (0, 0, 1) from (1, 0, 0);  point end = (other, 0mm, 0mm);  axis end_z = (0, -sin(other_twist), cos(other_twist)) from (1, 0, 0);
        }
        joint one = revolute(ground.end, ground.end_z, second.position, second.z);
        joint two = revolute(second.end, second.end_z, third.position, third.z);
        joint three = revolute(third.end, third.end_z, fourth.position, fourth.z);
        redundant joint four = revolute(fourth.end, fourth.end_z, ground.position, ground.z);
        start three.angle = -60deg;
        drive motor = drive_rotation(one, 60deg + 1deg_s * t);
        output driven = one.angle;
        output next = two.angle;
        output opposite = three.angle;
    }
}

/// A whole turn and a half, each state from the start, through the instants at which all bars lie flat and the rows that are solved are
/// singular; at those themselves it is extrapolated from both sides.
#[test]
fn bennetts_linkage_through_all_its_turn() {
    let mechanism = Bennett::default();
    let (alpha, beta) = (40_f64.to_radians(), 70_f64.to_radians());
    let product = ((alpha + beta) / 2.0).sin() / ((alpha - beta) / 2.0).sin();
    for degree in 61..=600_u32 {
        let flat = f64::from(degree).to_radians().sin().abs();
        let state = mechanism.solve(f64::from(degree) - 60.0).unwrap_or_else(|failure| panic!("{degree}°: {failure}"));
        let [driven, next, opposite] = [mechanism.driven(&state), mechanism.next(&state), mechanism.opposite(&state)];
        let (sin, cos) = (driven.value / 2.0).sin_cos();
        let (angle, speed) = (2.0 * (product * cos).atan2(sin), -product / (sin * sin + product * product * cos * cos));
        let apart = |one: f64, two: f64| (one - two).sin().atan2((one - two).cos()).abs();
        let error = apart(next.value, angle).max(apart(opposite.value, -driven.value)).max((next.rate / driven.rate - speed).abs());
        assert!(error * flat.max(1e-3) < 1e-13, "{degree}°: {error:e}");
    }
}

/// Beside those instants and at them, as near as one likes: rates and accelerations do not depend on how nearly singular the solved rows
/// are, and bodies turn about their hinges as the angles say.
#[test]
fn bennetts_linkage_beside_the_flat_place() {
    let mechanism = Bennett::default();
    let (alpha, beta) = (40_f64.to_radians(), 70_f64.to_radians());
    let k = ((alpha + beta) / 2.0).sin() / ((alpha - beta) / 2.0).sin();
    let places = (0..=20).flat_map(|half| [-1.0, 1.0].map(|side| side * 10_f64.powf(-0.5 * f64::from(half)))).chain([0.0]);
    for t in places.flat_map(|off| [120.0 + off, 300.0 + off]) {
        let state = mechanism.solve(t).unwrap_or_else(|failure| panic!("{t}: {failure}"));
        let (driven, next) = (mechanism.driven(&state), mechanism.next(&state));
        let (sin, cos) = (driven.value / 2.0).sin_cos();
        let size = sin * sin + k * k * cos * cos;
        let (speed, change) = (-k / size, k * (1.0 - k * k) * sin * cos / (size * size));
        let rate = next.rate / driven.rate - speed;
        let acceleration = next.acceleration / (driven.rate * driven.rate) - change;
        assert!(rate.abs() < 1e-9 && acceleration.abs() < 1e-6, "{t}: {rate:e} {acceleration:e}");

        let hinge = |twist: f64| Vector3::new(0.0, -twist.sin(), twist.cos());
        let second = hinge(alpha) * driven.rate;
        let third = second + state.second().vector(hinge(beta)).value * (driven.rate * speed);
        let off = (state.second().angular_velocity - second).norm().max((state.third().angular_velocity - third).norm());
        assert!(off < 1e-9 * driven.rate, "{t}: {off:e}");
    }
}
