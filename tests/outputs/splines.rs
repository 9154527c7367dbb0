//! Splines of the fifth degree, and laws of sine, constant and cosine acceleration.

use std::f64::consts::PI;

use reuleaux::{MotionWithJerk, mechanism};

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// Splines over the time in seconds.
    pub mechanism Splines {
        let x = t / 1s;
        function quintic(x: Number) -> Number = 1 - 2 * x + 3 * x^2 - x^3 + x^4 / 2 - x^5 / 5;

        body clock { }
        joint there = weld(ground.position, clock.position);
        output own = spline(x, [
            (-0.5, quintic(-0.5)), (0.125, quintic(0.125)), (0.2, quintic(0.2)), (1.5, quintic(1.5)),
        ], [(-6.0625, 11), (1.9375, -3)]) with jerk;
        output rise = spline(x, [(0, 0), (0.25, 0.103515625), (0.5, 0.5), (1, 1)]) with jerk;
        output wave = spline(t * 1rad / 1s, [
            (0deg, 0), (30deg, 0.5), (60deg, sqrt(3) / 2), (90deg, 1), (120deg, sqrt(3) / 2), (150deg, 0.5), (180deg, 0),
            (210deg, -0.5), (240deg, -sqrt(3) / 2), (270deg, -1), (300deg, -sqrt(3) / 2), (330deg, -0.5), (360deg, 0),
        ], periodic) with jerk;
        output uneven = spline(x, [(0, 1), (0.3, 2), (0.4, 1.5), (1.1, 1.75), (1.25, 1)], periodic) with jerk;
        output rest = spline(x, [(0, 1), (0.3, 2), (0.4, 1.5), (1.1, 1.75), (1.25, 1)], hold) with jerk;
        output lift = spline(t, [(0.25s, 5mm), (0.5s, 30mm), (0.75s, 20mm)], [(100mm_s, 2m_s2), (-40mm_s, 0m_s2)]) with jerk;
        output flat = spline(x, [(0, 0), (1, 0), (3, 0)], [(2, 0), (0, 0)]);
        output micro = 1e6 * spline(x, [(0, 0m), (0.25, 2um), (0.5, 5um), (0.75, 8um), (1, 10um)]);
        output large = spline(x, [(0, 0), (0.25, 2), (0.5, 5), (0.75, 8), (1, 10)]);
        output two = spline(x, [(0, 0), (2, 3)]) with jerk;
    }
}

mechanism! {
    /// Laws by their shares, over the time in seconds, and programs of them.
    pub mechanism Shares {
        param height: Length = 12mm;
        let u = t / 1s;

        body clock { }
        joint there = weld(ground.position, clock.position);
        output harmonic = scca(u, 0, 0) with jerk;
        output cycloidal = scca(u, 1/2, 0) with jerk;
        output trapezoidal = scca(u, 1/4, 1/2) with jerk;
        output sine = scca(u, 1/4, 0) with jerk;
        output parabolic = scca(u, 0, 1) with jerk;
        output mixed = scca(u, 0.3, 0.2) with jerk;
        output steep = scca(u, 0, 0.4) with jerk;
        output rounded = scca(u, 1 / pi, sqrt(2) / 4) with jerk;
        output full = scca(u, sqrt(2) / 4, 1 - sqrt(2) / 4) with jerk;
        output edged = scca(u, 0.4, 0.6) with jerk;
        output named[0] = harmonic(u);
        output named[1] = cycloidal(u);
        output named[2] = modified_trapezoidal(u);
        output named[3] = modified_sine(u);
        output direct = segments(t, 0mm, [rise(height, 1s, scca(1/4, 1/2)), fall(height, 0.5s, spline([(0, 0), (0.25, 0.1), (1, 1)]))]);
        output declared = segments(t, 0mm, [rise(height, 1s, modified_trapezoidal), fall(height, 0.5s, falling)]);
        function falling(u: Number) -> Number = spline(u, [(0, 0), (0.25, 0.1), (1, 1)]);
    }
}

fn numbers(motion: MotionWithJerk<f64>) -> [f64; 4] {
    [motion.value, motion.rate, motion.acceleration, motion.jerk]
}

fn grid(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=240).map(move |step| from + (to - from) * f64::from(step) / 240.0)
}

#[test]
fn a_spline_through_points_of_a_quintic_is_that_quintic() -> Outcome {
    let splines = Splines::default();
    for x in grid(-0.4999, 1.4999) {
        let state = splines.solve(x)?;
        let exact = [
            1.0 + x * (-2.0 + x * (3.0 + x * (-1.0 + x * (0.5 - 0.2 * x)))),
            -2.0 + x * (6.0 + x * (-3.0 + x * (2.0 - x))),
            6.0 + x * (-6.0 + x * (6.0 - 4.0 * x)),
            -6.0 + x * (12.0 - 12.0 * x),
        ];
        for (found, exact) in numbers(splines.own(&state)).into_iter().zip(exact) {
            near(found, exact, 1e-11);
        }
    }
    // The same in micrometres, whose coefficients beside zero are rounding.
    for x in grid(0.0, 1.0) {
        let state = splines.solve(x)?;
        let (micro, large) = (splines.micro(&state), splines.large(&state));
        assert!((micro.value - large.value).abs() < 1e-13 && (micro.acceleration - large.acceleration).abs() < 1e-11, "{x}");
    }
    // A rise that rests at its ends, through points of the polynomial 3-4-5.
    for x in grid(0.001, 0.999) {
        let state = splines.solve(x)?;
        let exact = [
            x * x * x * (10.0 - 15.0 * x + 6.0 * x * x),
            30.0 * x * x * (1.0 - x) * (1.0 - x),
            60.0 * x * (1.0 - x) * (1.0 - 2.0 * x),
            60.0 - 360.0 * x + 360.0 * x * x,
        ];
        for (found, exact) in numbers(splines.rise(&state)).into_iter().zip(exact) {
            near(found, exact, 1e-11);
        }
        // Two points alone give that polynomial, too.
        let exact = [3.0 * (x / 2.0).powi(3) * (10.0 - 7.5 * x + 1.5 * x * x), 45.0 * (x / 2.0).powi(2) * (1.0 - x / 2.0).powi(2)];
        for (found, exact) in numbers(splines.two(&state)).into_iter().zip(exact) {
            near(found, exact, 1e-14);
        }
    }
    Ok(())
}

/// Coefficients of peak velocity, acceleration and jerk of the laws by shares, as printed: Norton, Cam Design and Manufacturing Handbook, table of
/// the SCCA family. The jerk of the last two is infinite at their ends.
#[test]
fn laws_by_shares_have_the_coefficients_of_the_handbook() -> Outcome {
    let shares = Shares::default();
    let mut peaks = [[0.0_f64; 3]; 5];
    for u in (1..40_000).map(|step| f64::from(step) / 40_000.0) {
        let state = shares.solve(u)?;
        let laws =
            [shares.cycloidal(&state), shares.trapezoidal(&state), shares.sine(&state), shares.harmonic(&state), shares.parabolic(&state)];
        for (peaks, law) in peaks.iter_mut().zip(laws) {
            for (peak, value) in peaks.iter_mut().zip([law.rate, law.acceleration, law.jerk]) {
                *peak = peak.max(value.abs());
            }
        }
    }
    let printed = [
        ["2.0000", "6.2832", "39.478"],
        ["2.0000", "4.8881", "61.426"],
        ["1.7596", "5.5280", "69.466"],
        ["1.5708", "4.9348", ""],
        ["2.0000", "4.0000", ""],
    ];
    for (peaks, printed) in peaks.into_iter().zip(printed) {
        for ((peak, printed), digits) in peaks.into_iter().zip(printed).zip([4, 4, 3]).filter(|((_, printed), _)| !printed.is_empty()) {
            assert_eq!(format!("{peak:.digits$}"), printed);
        }
    }
    Ok(())
}

/// The spline of degree 5 through N values of sin x at equal distances has the frequencies ω = 1 + N m, each with the weight ω⁻⁶.
///
/// Reference: Schoenberg, Cardinal Spline Interpolation, lecture 3, on exponential splines.
#[test]
fn a_periodic_spline_of_a_sine_has_the_frequencies_of_its_points() -> Outcome {
    let splines = Splines::default();
    let frequencies = || (-20_000..=20_000).map(|m| f64::from(1 + 12 * m));
    let total: f64 = frequencies().map(|frequency| frequency.powi(-6)).sum();
    for x in grid(-7.0, 17.0).step_by(8) {
        let found = numbers(splines.wave(&splines.solve(x)?));
        let mut exact = [0.0; 4];
        for frequency in frequencies() {
            let ((sine, cosine), weight) = ((frequency * x).sin_cos(), frequency.powi(-6) / total);
            let terms = [sine, frequency * cosine, -frequency.powi(2) * sine, -frequency.powi(3) * cosine];
            exact.iter_mut().zip(terms).for_each(|(sum, term)| *sum += weight * term);
        }
        for (found, (exact, tolerance)) in found.into_iter().zip(exact.into_iter().zip([1e-14, 1e-13, 1e-12, 1e-11])) {
            near(found, exact, tolerance);
        }
    }
    Ok(())
}

#[test]
fn splines_go_through_their_points_with_four_continuous_derivatives() -> Outcome {
    let splines = Splines::default();
    let points = [(0.0, 1.0), (0.3, 2.0), (0.4, 1.5), (1.1, 1.75), (1.25, 1.0)];
    let uneven = |x: f64| -> Result<[f64; 4], Box<dyn std::error::Error>> { Ok(numbers(splines.uneven(&splines.solve(x)?))) };
    let rest = |x: f64| -> Result<[f64; 4], Box<dyn std::error::Error>> { Ok(numbers(splines.rest(&splines.solve(x)?))) };
    for (x, y) in points {
        near(uneven(x)?[0], y, 1e-14);
        near(uneven(x + 1.25)?[0], y, 1e-14);
        near(rest(x)?[0], y, 1e-14);
    }
    // Beside a point, a derivative of this order; the fourth and the fifth, which is constant in an interval, by differences of the jerk.
    let beside = |x: f64, way: f64, order: usize| -> Result<f64, Box<dyn std::error::Error>> {
        let [one, two, three] = [uneven(x + way)?[3], uneven(x + 2.0 * way)?[3], uneven(x + 3.0 * way)?[3]];
        Ok(match order {
            4 => (-5.0 * one + 8.0 * two - 3.0 * three) / (2.0 * way),
            5 => (one - 2.0 * two + three) / (way * way),
            _ => uneven(x + way)?[order],
        })
    };
    let (step, wide) = (1e-6, 1e-2);
    for x in [0.0, 0.3, 0.4, 1.1, 1.25, 2.5] {
        let [fourth, fifth] = [4, 5].map(|order| [-wide, wide].map(|way| beside(x, way, order)));
        let [fourth, fifth] = [fourth, fifth].map(|sides| sides.map(|side| side.expect("a state")));
        let size = fifth[0].abs().max(fifth[1].abs());
        assert!((fourth[0] - fourth[1]).abs() <= 1e-8 * size, "the fourth at {x}: {fourth:?}");
        assert!((fifth[0] - fifth[1]).abs() > 0.1 * size, "one polynomial at {x}: {fifth:?}");
        // The others change by less than two steps of the derivative after them.
        for order in 0..4 {
            let next = [-step, step].map(|way| if order == 3 { Ok(fourth[0]) } else { beside(x, way, order + 1) });
            let [before, after] = [beside(x, -step, order)?, beside(x, step, order)?];
            let most = next.into_iter().map(|next| next.map(f64::abs)).try_fold(0.0_f64, |most, next| next.map(|next| most.max(next)))?;
            assert!((after - before).abs() <= 2.5 * step * most + 1e-10 * size, "{order} at {x}: {before} and {after}");
        }
    }
    // At rest before and after, with a continuous acceleration.
    for (x, y) in [(-1.0, 1.0), (0.0, 1.0), (1.25, 1.0), (1.5, 1.0)] {
        let [value, rate, acceleration, _] = rest(x)?;
        near(value, y, 1e-14);
        assert!(rate.abs() < 1e-12 && acceleration.abs() < 1e-10, "{rate} {acceleration} at {x}");
    }
    Ok(())
}

#[test]
fn a_spline_begins_and_ends_with_the_motion_given_and_goes_on_at_its_velocity() -> Outcome {
    let splines = Splines::default();
    let lift = |t: f64| -> Result<[f64; 4], Box<dyn std::error::Error>> { Ok(numbers(splines.lift(&splines.solve(t)?))) };
    // Through zeros alone, from a velocity.
    for (t, rate) in [(0.0, 2.0), (1.0, f64::NAN), (3.0, 0.0)] {
        let found = splines.flat(&splines.solve(t)?);
        assert!(found.value.abs() < 1e-14 && (rate.is_nan() || (found.rate - rate).abs() < 1e-14), "{found:?}");
    }
    for (t, expected) in [
        (0.25, [0.005, 0.1, 2.0]),
        (0.5, [0.03, f64::NAN, f64::NAN]),
        (0.75, [0.02, -0.04, 0.0]),
        (0.05, [0.005 - 0.02, 0.1, 0.0]),
        (1.0, [0.02 - 0.01, -0.04, 0.0]),
    ] {
        for (found, exact) in lift(t)?.into_iter().zip(expected).filter(|(_, exact)| !exact.is_nan()) {
            near(found, exact, 1e-12);
        }
    }
    Ok(())
}

/// Accelerations as the page of the law states them.
fn acceleration(u: f64, b: f64, c: f64) -> f64 {
    let d = 1.0 - b - c;
    let peak = 4.0 * PI * PI / ((PI * PI - 8.0) * (b * b - d * d) - 2.0 * PI * (PI - 2.0) * b + PI * PI);
    let early = u.min(1.0 - u);
    let size = if early < b / 2.0 {
        (PI * early / b).sin()
    } else if early < (1.0 - d) / 2.0 {
        1.0
    } else {
        (PI / d * (early - (1.0 - d) / 2.0)).cos()
    };
    if u < 0.5 { peak * size } else { -peak * size }
}

#[test]
fn laws_by_shares_have_the_accelerations_stated_and_rise_from_rest_to_rest() -> Outcome {
    let shares = Shares::default();
    for u in grid(0.0013, 0.9986) {
        let state = shares.solve(u)?;
        let laws = [
            (shares.harmonic(&state), 0.0, 0.0),
            (shares.cycloidal(&state), 0.5, 0.0),
            (shares.trapezoidal(&state), 0.25, 0.5),
            (shares.sine(&state), 0.25, 0.0),
            (shares.parabolic(&state), 0.0, 1.0),
            (shares.mixed(&state), 0.3, 0.2),
            (shares.steep(&state), 0.0, 0.4),
            (shares.edged(&state), 0.4, 0.6),
            (shares.rounded(&state), 1.0 / PI, 2_f64.sqrt() / 4.0),
            (shares.full(&state), 2_f64.sqrt() / 4.0, 1.0 - 2_f64.sqrt() / 4.0),
        ];
        for (law, b, c) in laws {
            near(law.acceleration, acceleration(u, b, c), 1e-13);
        }
        // The velocity at the middle is A ((b + d)/π + c/2).
        near(shares.solve(0.5).map(|state| shares.mixed(&state).rate)?, acceleration(0.2, 0.3, 0.2) * (0.8 / PI + 0.1), 1e-14);
        near(shares.parabolic(&state).value, if u < 0.5 { 2.0 * u * u } else { 1.0 - 2.0 * (1.0 - u) * (1.0 - u) }, 1e-15);
        let named = shares.named(&state);
        for (index, (law, ..)) in laws.into_iter().take(4).enumerate() {
            let other = [named[index].value, named[index].rate, named[index].acceleration];
            for (found, exact) in numbers(law).into_iter().zip(other) {
                // The laws of the library use other forms of the same numbers.
                near(found, exact, 2e-14);
            }
        }
    }
    for (u, value) in [(-0.5, 0.0), (0.0, 0.0), (1.0, 1.0), (1.5, 1.0)] {
        let state = shares.solve(u)?;
        for law in [shares.harmonic(&state), shares.mixed(&state), shares.steep(&state), shares.edged(&state), shares.parabolic(&state)] {
            assert_eq!(law.value, value, "{u}");
            near(law.rate, 0.0, 1e-15);
        }
    }
    Ok(())
}

#[test]
fn programs_take_laws_by_shares_and_by_points() -> Outcome {
    let shares = Shares::default();
    for t in grid(0.0, 1.6) {
        let state = shares.solve(t)?;
        let (direct, declared) = (shares.direct(&state), shares.declared(&state));
        near(direct.value, declared.value, 1e-16);
        near(direct.rate, declared.rate, 1e-15);
        near(direct.acceleration, declared.acceleration, 1e-14);
    }
    near(shares.direct(&shares.solve(1.125)?).value, 0.012 * 0.9, 1e-16);
    Ok(())
}
