//! Programs of segments against the same motions in plain Rust.

use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux_tests::common::declared::{Declared, Instant};
use reuleaux_tests::laws::Programs;

/// Value, first and second derivative.
type Jet = [f64; 3];

fn cycloidal(u: f64) -> Jet {
    let (sine, cosine) = (TAU * u).sin_cos();
    [u - sine / TAU, 1.0 - cosine, TAU * sine]
}

fn polynomial_345(u: f64) -> Jet {
    [u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u), 30.0 * (u * (1.0 - u)).powi(2), 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)]
}

fn square(u: f64) -> Jet {
    [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u), 6.0 - 12.0 * u]
}

fn harmonic(u: f64) -> Jet {
    let (sine, cosine) = (PI * u).sin_cos();
    [(1.0 - cosine) / 2.0, PI / 2.0 * sine, PI * PI / 2.0 * cosine]
}

fn half_start(u: f64) -> Jet {
    [u - (PI * u).sin() / PI, 1.0 - (PI * u).cos(), PI * (PI * u).sin()]
}

fn half_end(u: f64) -> Jet {
    [u + (PI * u).sin() / PI, 1.0 + (PI * u).cos(), -PI * (PI * u).sin()]
}

/// The acceleration integrated twice by Gauss's rule with three nodes per interval; the law is piecewise.
fn modified_sine(u: f64) -> Jet {
    let a = 4.0 * PI * PI / (4.0 + PI);
    let acceleration = |u: f64| {
        if (0.125..0.875).contains(&u) { a * (4.0 * PI / 3.0 * (u - 0.125)).cos() } else { a * (4.0 * PI * u).sin() }
    };
    let pieces = [0.0, 0.125_f64.min(u), 0.875_f64.min(u), u];
    let nodes = [(-(0.6_f64.sqrt()), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)];
    let (mut value, mut rate) = (0.0, 0.0);
    for (from, to) in pieces.windows(2).map(|ends| (ends[0], ends[1])) {
        let step = (to - from) / 200.0;
        for k in 0..200 {
            let middle = from + step * (f64::from(k) + 0.5);
            for (node, weight) in nodes {
                let at = middle + node * step / 2.0;
                // s(u) = ∫ (u − x) s''(x) dx
                rate += weight * step / 2.0 * acceleration(at);
                value += weight * step / 2.0 * (u - at) * acceleration(at);
            }
        }
    }
    [value, rate, acceleration(u)]
}

/// Segments as rise, duration and law, from the height y₀.
type Segments<'a> = &'a [(f64, f64, fn(f64) -> Jet)];

/// The motion at x ≥ 0, resting after its end.
fn program(segments: Segments, start: f64, x: f64) -> Jet {
    let (mut height, mut begin) = (start, 0.0);
    for (rise, duration, law) in segments {
        if x < begin + duration {
            let [value, rate, acceleration] = law((x - begin) / duration);
            return [height + rise * value, rise * rate / duration, rise * acceleration / (duration * duration)];
        }
        height += rise;
        begin += duration;
    }
    [height, 0.0, 0.0]
}

fn dwell(_: f64) -> Jet {
    [0.0; 3]
}

/// The outputs at a time: over an angle, once over time, repeated over time.
fn outputs(mechanism: &Programs, t: f64) -> [Jet; 3] {
    // Coordinates and rates are those of the drives, by the constraint x − f(t) = 0.
    let rest = Instant { t, q: vec![0.0; 3], qd: vec![0.0; 3], qdd: vec![0.0; 3] };
    let rows = mechanism.rows(&rest);
    [0, 1, 2].map(|row| [-rows.phi[row], rows.nu[row], rows.gamma[row]])
}

fn compare(found: Jet, exact: Jet, scale: f64, at: f64) {
    for order in 0..3 {
        let allowed = 1e-12 * (1.0 + exact[order].abs() + scale.powi(order as i32));
        assert!((found[order] - exact[order]).abs() <= allowed, "order {order} at {at}: {found:?} instead of {exact:?}");
    }
}

/// Times that avoid the borders of segments, where rounding decides which one counts.
fn times(until: f64) -> impl Iterator<Item = f64> {
    (0..3000).map(move |k| (f64::from(k) + 0.37) / 3000.0 * until)
}

#[test]
fn a_periodic_program_repeats_after_a_turn() {
    let mechanism = Programs::with(&mut |name| match name {
        "up" => 2.25,
        "base" => 0.05,
        "lift" => 0.02,
        "speed" => 2.0,
        _ => 0.125,
    });
    let (third, quarter) = (30.0_f64.to_radians(), 90.0_f64.to_radians());
    let segments: Segments = &[
        (0.02, 2.25, cycloidal),
        (0.0, third, dwell),
        (-0.01, quarter, polynomial_345),
        (-0.01, 330.0_f64.to_radians() - quarter - 2.25, square),
    ];
    for t in times(10.0) {
        for t in [t, -t] {
            let [value, rate, acceleration] = program(segments, 0.05, (2.0 * t).rem_euclid(TAU));
            compare(outputs(&mechanism, t)[0], [value, 2.0 * rate, 4.0 * acceleration], 4.0, t);
        }
    }
}

#[test]
fn a_program_rests_before_and_after() {
    let segments: Segments = &[
        (0.01, 0.25, half_start),
        (0.04, 0.5, |u| [u, 1.0, 0.0]),
        (0.01, 0.25, half_end),
        (0.0, 0.125, dwell),
        (-0.06, 0.25, modified_sine),
    ];
    for t in times(3.0) {
        let exact = if t < 1.0 { [0.0; 3] } else { program(segments, 0.0, t - 1.0) };
        compare(outputs(&Programs::default(), t)[1], exact, 4.0, t);
    }
}

#[test]
fn over_time_the_period_is_the_sum_of_the_durations() {
    let segments: Segments = &[(0.5, 0.25, harmonic), (-0.5, 0.25, cycloidal), (0.0, 0.125, dwell)];
    for t in times(5.0) {
        compare(outputs(&Programs::default(), t)[2], program(segments, 1.0, t.rem_euclid(0.625)), 16.0, t);
    }
}

#[test]
fn parameters_that_break_the_program_are_refused() {
    let with = |up: f64, pause: f64| Programs { up, pause, ..Programs::default() }.validate().map_err(|error| error.to_string());
    assert_eq!(with(3.0, 0.5), Ok(()));
    // The other segments leave 240° and a time; each must be positive.
    assert!(with(-0.1, 0.5).unwrap_err().contains("the duration of a segment is positive"));
    assert!(with(5.0, 0.5).unwrap_err().contains("the duration of a segment is positive"));
    assert!(with(3.0, 0.0).unwrap_err().contains("the duration of a segment is positive"));
}

mechanism! {
    /// A lever on a cam that rises within 8° at the end of a turn, once more on the same cam.
    pub(crate) mechanism Lever {
        param off: Length = 0mm;
        function outline(psi: Angle) -> Length = segments(90deg - psi, 40mm, [
            dwell(300deg), rise(1mm, 8deg, polynomial_4567), fall(1mm, 52deg, polynomial_4567),
        ], periodic);
        ground { point V = (60mm, 0mm); }
        body cam { }
        body lever { point F = (70mm, 0mm);  point G = (70mm + off, 0mm);  start angle = 145deg; }
        joint pivot = revolute(ground.V, lever.position);
        joint axle = revolute((0mm, 0mm), cam.position);
        joint contact = cam_knife(cam.position, lever.F, outline);
        redundant joint again = cam_knife(cam.position, lever.G, outline);
        drive motor = drive_angle(cam, 1rad_s * t);
    }
}

/// A polynomial between 0 and 1 is none of the numbers that its powers would be elsewhere in the turn.
#[test]
fn a_short_rise_at_the_end_of_a_turn_is_no_dead_point() {
    let lever = Lever::default();
    let rise = |u: f64| u.powi(4) * (35.0 - 84.0 * u + 70.0 * u * u - 20.0 * u.powi(3));
    let degree = TAU / 360.0;
    let mut is_lifted = false;
    for state in lever.sweep((0..=700).map(|step| 0.01 * f64::from(step))) {
        let state = state.expect("a state");
        assert!(state.condition < 1e3, "{} at t = {}", state.condition, state.t);
        let tip = state.lever().point([0.07, 0.0].into()).value;
        // From the cam's own angle of contact, as the program has it.
        let theta = (90.0 * degree - (tip.y.atan2(tip.x) - state.cam().angle)).rem_euclid(TAU);
        let lift = match theta / degree {
            angle if angle < 300.0 => 0.0,
            angle if angle < 308.0 => rise((angle - 300.0) / 8.0),
            angle => 1.0 - rise((angle - 308.0) / 52.0),
        };
        assert!((tip.norm() - 0.04 - 0.001 * lift).abs() < 1e-14, "t = {}", state.t);
        is_lifted |= lift > 0.9;
    }
    assert!(is_lifted);
}

#[test]
fn a_contact_that_does_not_fit_is_refused_on_such_a_cam() {
    for off in [1e-9, 1e-6] {
        let failure = Lever { off }.solve(0.3).expect_err("two contacts");
        assert!(matches!(failure.cause, reuleaux::Cause::DoesNotHold { .. }), "{failure}");
    }
}

mechanism! {
    /// A cam whose rise, and so its last dwell, is a parameter.
    mechanism Varied {
        param up: Angle = 120deg;
        param high: Length = 12mm;
        function lift(psi: Angle) -> Length =
            segments(psi, 40mm, [rise(high, up, modified_sine), rise(5mm, 30deg, cycloidal), fall(high + 5mm, 120deg, cycloidal), dwell(210deg - up)], periodic);
        body cam { }
        body slide { }
        joint axle = revolute(ground.position, cam.position);
        joint guide = translational((0, 1), (0mm, 0mm), slide.position);
        joint contact = { slide.y == lift(cam.angle); }
        drive motor = drive_angle(cam, 60rpm * t);
    }
}

/// Durations fill a turn up to rounding, which is much more in single precision.
#[test]
fn programs_with_parameters_are_accepted_in_single_precision() {
    for k in 0..500 {
        let (up, high) = (0.1 + 0.007 * k as f32, 0.001 + 0.000_013 * k as f32);
        let state = Varied::<f32> { up, high }.solve(0.0).unwrap_or_else(|failure| panic!("{up} {high}: {failure}"));
        assert!((state.slide().position.y - 0.04).abs() < 1e-6);
    }
}
