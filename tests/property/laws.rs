//! The motion laws of the library have the properties that their pages state.

use std::f64::consts::PI;

use reuleaux_tests::common::declared::{Declared, Instant};
use reuleaux_tests::laws::Laws;

/// A law in closed form: value, first and second derivative.
type Form = fn(f64) -> [f64; 3];

/// Properties stated by the page of a law.
struct Page {
    name: &'static str,
    /// Peak velocity and peak acceleration.
    peaks: [f64; 2],
    /// Number of derivatives that are continuous at the beginning and at the end.
    continuous: [usize; 2],
    /// Velocity and acceleration with which the rise begins.
    begin: [f64; 2],
    /// True if the law is the same backwards from its end.
    is_symmetric: bool,
    /// Formula between the ends; `None` for a piecewise law.
    form: Option<Form>,
}

/// Pages in the order of the outputs.
fn pages() -> [Page; LAWS] {
    let mut pages = symmetric().into_iter().chain(halves()).chain(constant());
    std::array::from_fn(|_| pages.next().expect("a page for each law"))
}

/// Laws that begin and end at rest and are symmetric.
fn symmetric() -> [Page; 6] {
    let modified = 8.0 * PI / (2.0 + PI);
    let usual = Page { name: "", peaks: [0.0; 2], continuous: [2; 2], begin: [0.0; 2], is_symmetric: true, form: None };
    [
        Page {
            name: "harmonic",
            peaks: [PI / 2.0, PI * PI / 2.0],
            continuous: [1; 2],
            begin: [0.0, PI * PI / 2.0],
            form: Some(|u| [(1.0 - (PI * u).cos()) / 2.0, PI / 2.0 * (PI * u).sin(), PI * PI / 2.0 * (PI * u).cos()]),
            ..usual
        },
        Page {
            name: "cycloidal",
            peaks: [2.0, 2.0 * PI],
            form: Some(|u| [u - (2.0 * PI * u).sin() / (2.0 * PI), 1.0 - (2.0 * PI * u).cos(), 2.0 * PI * (2.0 * PI * u).sin()]),
            ..usual
        },
        Page {
            name: "polynomial_345",
            peaks: [15.0 / 8.0, 10.0 / 3.0_f64.sqrt()],
            form: Some(|u| {
                let (square, rest) = (u * u, 1.0 - u);
                [square * u * (10.0 - 15.0 * u + 6.0 * square), 30.0 * square * rest * rest, 60.0 * u * rest * (1.0 - 2.0 * u)]
            }),
            ..usual
        },
        Page {
            name: "polynomial_4567",
            peaks: [35.0 / 16.0, 84.0 * 5.0_f64.sqrt() / 25.0],
            continuous: [3; 2],
            form: Some(|u| {
                let (square, rest) = (u * u, 1.0 - u);
                let value = square * square * (35.0 - 84.0 * u + 70.0 * square - 20.0 * square * u);
                [value, 140.0 * (u * rest).powi(3), 420.0 * (u * rest).powi(2) * (1.0 - 2.0 * u)]
            }),
            ..usual
        },
        Page { name: "modified_trapezoidal", peaks: [2.0, modified], ..usual },
        Page {
            name: "smooth_step",
            peaks: [1.5, 6.0],
            continuous: [1; 2],
            begin: [0.0, 6.0],
            form: Some(|u| [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u), 6.0 - 12.0 * u]),
            ..usual
        },
    ]
}

/// Laws that begin or end with an acceleration or with a velocity: a rise in one direction and the same one backwards.
fn halves() -> [Page; 4] {
    let (velocity, turn) = (3.0 * 3.0_f64.sqrt() * PI / 8.0, PI * PI);
    let page = |name, peaks, continuous, begin, form| Page { name, peaks, continuous, begin, is_symmetric: false, form: Some(form) };
    [
        page("double_harmonic", [velocity, turn], [3, 1], [0.0; 2], |u| {
            let ((s1, c1), (s2, c2)) = ((PI * u).sin_cos(), (2.0 * PI * u).sin_cos());
            [(1.0 - c1) / 2.0 - (1.0 - c2) / 8.0, PI / 2.0 * (s1 - s2 / 2.0), PI * PI / 2.0 * (c1 - c2)]
        }),
        page("double_harmonic_end", [velocity, turn], [1, 3], [0.0, turn], |u| {
            let ((s1, c1), (s2, c2)) = ((PI * u).sin_cos(), (2.0 * PI * u).sin_cos());
            [(1.0 - c1) / 2.0 + (1.0 - c2) / 8.0, PI / 2.0 * (s1 + s2 / 2.0), PI * PI / 2.0 * (c1 + c2)]
        }),
        page("half_cycloidal_start", [2.0, PI], [2, 0], [0.0; 2], |u| {
            let (sine, cosine) = (PI * u).sin_cos();
            [u - sine / PI, 1.0 - cosine, PI * sine]
        }),
        page("half_cycloidal_end", [2.0, PI], [0, 2], [2.0, 0.0], |u| {
            let (sine, cosine) = (PI * u).sin_cos();
            [u + sine / PI, 1.0 + cosine, -PI * sine]
        }),
    ]
}

/// Constant velocity, and the law that comes nearest to it without a jump of acceleration.
fn constant() -> [Page; 2] {
    let linear: Form = |u| [u, 1.0, 0.0];
    let sine = [4.0 * PI / (4.0 + PI), 4.0 * PI * PI / (4.0 + PI)];
    [
        Page { name: "linear", peaks: [1.0, 0.0], continuous: [0; 2], begin: [1.0, 0.0], is_symmetric: true, form: Some(linear) },
        Page { name: "modified_sine", peaks: sine, continuous: [2; 2], begin: [0.0; 2], is_symmetric: true, form: None },
    ]
}

/// Number of laws.
const LAWS: usize = 12;

/// Value, rate and acceleration of every law at u.
fn laws(u: f64) -> [[f64; 3]; LAWS] {
    let at = Instant { t: u, q: vec![0.0; 3], qd: vec![0.0; 3], qdd: vec![0.0; 3] };
    Laws::default().outputs(&at).try_into().expect("all laws")
}

/// Numbers from 0 to 1, inclusive, which contain all points where a piecewise law changes.
fn grid() -> impl Iterator<Item = f64> {
    (0..=4000).map(|step| f64::from(step) / 4000.0)
}

#[test]
fn laws_rise_from_zero_to_one_and_stay() {
    for (law, page) in pages().iter().enumerate() {
        for (u, value) in [(-1e9, 0.0), (-1e-300, 0.0), (0.0, 0.0), (1.0, 1.0), (1.0 + f64::EPSILON, 1.0), (1e9, 1.0)] {
            assert_eq!(laws(u)[law][0], value, "{} at {u}", page.name);
        }
        for u in [-3.0, 2.0] {
            assert_eq!(laws(u)[law][1..], [0.0, 0.0], "{} at {u}", page.name);
        }
        // Monotonic up to rounding.
        for (u, next) in grid().zip(grid().skip(1)) {
            assert!(laws(next)[law][0] >= laws(u)[law][0] - f64::EPSILON, "{} at {u}", page.name);
            assert!(laws(u)[law][1] >= -1e-15, "{} at {u}", page.name);
        }
    }
}

#[test]
fn what_is_no_number_does_not_become_one() {
    for (law, page) in pages().iter().enumerate() {
        assert!(laws(f64::NAN)[law][0].is_nan(), "{}", page.name);
    }
}

#[test]
fn laws_are_their_formulas() {
    for (law, page) in pages().iter().enumerate() {
        let Some(form) = page.form else { continue };
        for u in grid().filter(|u| (1e-9..1.0 - 1e-9).contains(u)) {
            for (order, (found, exact)) in laws(u)[law].into_iter().zip(form(u)).enumerate() {
                // The magnitudes of the coefficients of the 4-5-6-7 polynomial add up to 209, those of its derivatives to at most
                // 7 · 209 and 42 · 209.
                let allowed = f64::EPSILON * [209.0, 7.0 * 209.0, 42.0 * 209.0][order];
                assert!((found - exact).abs() <= allowed, "{} order {order} at {u}: {found} for {exact}", page.name);
            }
        }
    }
}

#[test]
fn laws_are_symmetric_about_their_middle() {
    for (law, page) in pages().iter().enumerate().filter(|(_, page)| page.is_symmetric) {
        // Multiples of 1/4096, with exact complements.
        for u in (1..4096).map(|step| f64::from(step) / 4096.0) {
            let (here, there) = (laws(u)[law], laws(1.0 - u)[law]);
            assert!((here[0] + there[0] - 1.0).abs() <= 1e-14, "{} at {u}", page.name);
            assert!((here[1] - there[1]).abs() <= 1e-13, "{} at {u}", page.name);
            // The acceleration of a piecewise law at the middle belongs to one side.
            assert!((here[2] + there[2]).abs() <= 1e-12 || u == 0.5, "{} at {u}", page.name);
        }
    }
}

#[test]
fn where_two_motions_meet_only_one_of_them_counts() {
    for (law, page) in pages().iter().enumerate() {
        let [begin, end] = [0.0, 1.0].map(|u| laws(u)[law]);
        assert_eq!([begin[0], end[0], end[1]], [0.0, 1.0, 0.0], "{}", page.name);
        assert!(end[2].abs() < 1e-14, "{}: {}", page.name, end[2]);
        // Derivatives that jump are those of the rise at its beginning.
        assert_eq!(begin[1..], page.begin, "{}", page.name);
    }
}

/// Peak velocity and acceleration as printed in handbooks: Norton, Cam Design and Manufacturing Handbook, table 3-2, and Rothbart, Cam
/// Design Handbook, appendix B.
#[test]
#[allow(clippy::approx_constant)] // The digits are those in print.
fn peaks_are_those_of_handbooks() {
    let printed = [
        ("harmonic", [1.571, 4.935]),
        ("cycloidal", [2.000, 6.283]),
        ("polynomial_345", [1.875, 5.774]),
        // Norton prints 7.526; the peak of 420 u²(1 − u)²(1 − 2u) is 84√5/25.
        ("polynomial_4567", [2.188, 7.513]),
        ("modified_trapezoidal", [2.000, 4.888]),
        ("modified_sine", [1.760, 5.528]),
        ("double_harmonic", [2.041, 9.870]),
        ("linear", [1.000, 0.000]),
    ];
    for (name, factors) in printed {
        let law = pages().iter().position(|page| page.name == name).expect("a law of this name");
        for order in [1, 2] {
            // Half a step of the grid misses a peak by less than 1e-5 of it.
            let peak = grid().map(|u| laws(u)[law][order].abs()).fold(0.0, f64::max);
            assert!((peak - factors[order - 1]).abs() <= 5.1e-4, "{name} order {order}: {peak}");
        }
    }
    // Peak jerk from the growth of the acceleration. Norton prints it without decimals; 4π² = 39.48 as 40.
    for (name, printed) in
        [("cycloidal", 40.0), ("polynomial_345", 60.0), ("polynomial_4567", 52.0), ("modified_trapezoidal", 61.0), ("modified_sine", 69.0)]
    {
        let law = pages().iter().position(|page| page.name == name).expect("a law of this name");
        let acceleration = |step: i32| laws(f64::from(step) / 4096.0)[law][2];
        let jerk = (1..4095).map(|step| 4096.0 * (acceleration(step + 1) - acceleration(step)).abs()).fold(0.0, f64::max);
        assert!((jerk - printed).abs() <= 0.53, "{name}: {jerk}");
    }
    // The double harmonic rises with a smaller acceleration than that of its turn.
    let rising = grid().map(|u| laws(u)[6][2]).fold(0.0, f64::max);
    assert!((rising - 5.55).abs() <= 5e-3, "{rising}");
}

#[test]
fn a_double_harmonic_ends_as_it_begins_backwards() {
    for u in (1..4096).map(|step| f64::from(step) / 4096.0) {
        let (begin, end) = (laws(1.0 - u)[6], laws(u)[7]);
        assert!((begin[0] + end[0] - 1.0).abs() <= 1e-15 && (begin[1] - end[1]).abs() <= 1e-14, "{u}");
        assert!((begin[2] + end[2]).abs() <= 1e-13, "{u}");
    }
}

#[test]
fn peaks_are_as_documented() {
    for (law, page) in pages().iter().enumerate() {
        for order in [1, 2] {
            let peak = grid().map(|u| laws(u)[law][order].abs()).fold(0.0, f64::max);
            let documented = page.peaks[order - 1];
            // The grid misses a smooth peak, which is a flat parabola, by at most half a step.
            assert!(peak <= documented * (1.0 + 1e-12) && peak >= documented * (1.0 - 1e-3), "{} order {order}: {peak}", page.name);
        }
    }
}

#[test]
fn as_many_derivatives_are_continuous_as_documented() {
    let step = 1e-7;
    for (law, page) in pages().iter().enumerate() {
        let ends = [(0.0, [0.0, 0.0, 0.0], 1.0), (1.0, [1.0, 0.0, 0.0], -1.0)];
        for ((end, outside, side), continuous) in ends.into_iter().zip(page.continuous) {
            let inside = laws(end + side * step)[law];
            // The third derivative inside, from the growth of the acceleration.
            let jumps = [inside[0] - outside[0], inside[1], inside[2], inside[2] / step];
            for (order, jump) in jumps.iter().enumerate().take(continuous + 2) {
                // A continuous derivative changes by the step times a further derivative of at most a thousand.
                let is_continuous = jump.abs() <= 1e3 * step;
                assert_eq!(is_continuous, order <= continuous, "{} order {order} at {end}: {jump}", page.name);
            }
        }
    }
}

#[test]
fn pieces_of_piecewise_laws_fit_together() {
    // The constant acceleration of one from 1/8 to 3/8, and the largest of the other.
    assert!((laws(0.2)[4][2] - 8.0 * PI / (2.0 + PI)).abs() <= 1e-14);
    assert!((laws(0.125)[11][2] - 4.0 * PI * PI / (4.0 + PI)).abs() <= 1e-14);
    for number in [4, 11] {
        pieces_fit_together(|u| laws(u)[number]);
    }
}

fn pieces_fit_together(law: impl Fn(f64) -> [f64; 3]) {
    for knot in [1.0, 3.0, 5.0, 7.0].map(|eighths: f64| eighths / 8.0) {
        let (before, after) = (law(knot - 1e-12), law(knot + 1e-12));
        for order in 0..3 {
            assert!((before[order] - after[order]).abs() <= 1e-9, "order {order} at {knot}: {before:?} {after:?}");
        }
    }
    // Velocity and acceleration are the derivatives of the value: Simpson's rule over each eighth.
    for eighth in 0..8 {
        let (a, b) = (f64::from(eighth) / 8.0, f64::from(eighth + 1) / 8.0);
        for order in [0, 1] {
            let n = 64;
            let node = |k: i32| law((a + (b - a) * f64::from(k) / f64::from(n)).clamp(a + 1e-15, b - 1e-15))[order + 1];
            let sum: f64 = (0..=n).map(|k| node(k) * if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) }).sum();
            let integral = sum * (b - a) / f64::from(3 * n);
            assert!((integral - (law(b)[order] - law(a)[order])).abs() <= 1e-9, "order {order} in eighth {eighth}");
        }
    }
}
