//! Balls contain the exact values: references computed with 120 digits, and the values at points within the radius.

use super::ball::Ball;
use super::twofold::Twofold;
use super::{Enclosure, functions};
use crate::number::{Ends, Real, Single, Table};

/// Values of functions at doubles, as a double and a remainder (mpmath 1.3.0, 400 bits).
#[allow(clippy::approx_constant, clippy::excessive_precision)] // Multiples of π as doubles are where functions are hardest.
const VALUES: &[(&str, f64, [f64; 2])] = &[
    ("sin", 0.0, [0.0, 0.0]),
    ("sin", 1e-09, [1e-09, -1.6666666666666669e-28]),
    ("sin", 0.5, [0.479425538604203, -5.103969860556013e-18]),
    ("sin", 0.7853981633974483, [0.7071067811865475, 4.1036934489363755e-17]),
    ("sin", 1.5707963267948966, [1.0, -1.874699728327322e-33]),
    ("sin", 3.141592653589793, [1.2246467991473532e-16, -2.99476980971834e-33]),
    ("sin", -2.5, [-0.5984721441039565, 5.521403334082375e-17]),
    ("sin", 6.283185307179586, [-2.4492935982947064e-16, 5.9895396194366814e-33]),
    ("sin", 100.0, [-0.5063656411097588, -3.050947053792115e-18]),
    ("sin", -355.0, [3.014435335948845e-05, -1.3012643991046347e-21]),
    ("sin", 1000000.0, [-0.34999350217129294, -1.5952848809323968e-17]),
    ("sin", 123456789.125, [0.9998763854272629, -5.1559855244731284e-17]),
    ("sin", 100000000000.0, [0.928693660496592, -1.330083705997086e-17]),
    ("cos", 0.0, [1.0, 0.0]),
    ("cos", 1e-09, [1.0, -5e-19]),
    ("cos", 0.5, [0.8775825618903728, -4.2623149864279997e-17]),
    ("cos", 0.7853981633974483, [0.7071067811865476, -2.6687565161377232e-17]),
    ("cos", 1.5707963267948966, [6.123233995736766e-17, -1.4973849048591698e-33]),
    ("cos", 3.141592653589793, [-1.0, 7.498798913309288e-33]),
    ("cos", -2.5, [-0.8011436155469337, -1.8674742705085553e-17]),
    ("cos", 6.283185307179586, [1.0, -2.999519565323715e-32]),
    ("cos", 100.0, [0.8623188722876839, 4.334809858136501e-17]),
    ("cos", -355.0, [-0.999999999545659, 1.0574612846643521e-17]),
    ("cos", 1000000.0, [0.9367521275331447, 4.637088260214747e-17]),
    ("cos", 123456789.125, [0.01572303612257408, 1.0704522971882638e-18]),
    ("cos", 100000000000.0, [0.37084779216471114, 1.596456988232262e-17]),
    ("tan", 0.3, [0.30933624960962325, -2.7475966183811927e-17]),
    ("tan", -1.2, [-2.5721516221263188, 1.6240475489929127e-16]),
    ("tan", 1.57, [1255.7655915007897, -4.905371300143858e-14]),
    ("tan", 4.0, [1.1578212823495775, 9.788842756395734e-17]),
    ("tan", 100.0, [-0.5872139151569291, 3.488284783926625e-17]),
    ("asin", 0.0, [0.0, 0.0]),
    ("asin", 0.3, [0.3046926540153975, -2.7469740051157017e-17]),
    ("asin", -0.75, [-0.848062078981481, -3.5058948874954465e-18]),
    ("asin", 0.999999999, [1.5707516054359754, -6.223786754556717e-17]),
    ("asin", -1e-08, [-1e-08, -1.6666666666666668e-25]),
    ("acos", 0.0, [1.5707963267948966, 6.123233995736766e-17]),
    ("acos", 0.3, [1.2661036727794992, -7.78313736852488e-17]),
    ("acos", -0.75, [2.4188584057763776, 6.473823484486311e-17]),
    ("acos", 0.999999999, [4.4721358921319356e-05, -9.115243001521069e-23]),
    ("acos", -1e-08, [1.5707963367948967, -1.0003755488254988e-16]),
    ("atan", 0.0, [0.0, 0.0]),
    ("atan", 0.3, [0.2914567944778671, -1.6448555435075034e-17]),
    ("atan", -0.75, [-0.6435011087932844, -1.5834785051444286e-17]),
    ("atan", 40.0, [1.5458015331759765, -1.2801774969469343e-18]),
    ("atan", -1000000000.0, [-1.5707963257948967, 7.807189396823994e-17]),
    ("exp", 0.0, [1.0, 0.0]),
    ("exp", 0.5, [1.6487212707001282, -4.731568479435833e-17]),
    ("exp", -1.0, [0.36787944117144233, -1.2428753672788363e-17]),
    ("exp", 10.0, [22026.465794806718, -1.3780134700517372e-12]),
    ("exp", -37.3, [6.321437159096094e-17, -4.82725866074607e-34]),
    ("exp", 250.0, [3.7464546145026734e108, -1.331977416683643e92]),
    ("ln", 1.0, [0.0, 0.0]),
    ("ln", 2.0, [0.6931471805599453, 2.3190468138462996e-17]),
    ("ln", 1e-05, [-11.512925464970229, 2.790027459050308e-16]),
    ("ln", 37000000000.0, [24.334183749590636, -5.249737876341281e-16]),
    ("ln", 1.0000000001, [1.000000082690371e-10, -4.2169170658954805e-27]),
    ("sqrt", 2.0, [1.4142135623730951, -9.667293313452913e-17]),
    ("sqrt", 1e-12, [1e-06, 3.519521198874155e-23]),
    ("sqrt", 3e40, [1.7320508075688775e20, -13134.52294959977]),
    ("sqrt", 0.75, [0.8660254037844386, 5.0175421109034514e-17]),
];

fn function(name: &str) -> fn(Enclosure) -> Enclosure {
    match name {
        "sin" => |x| x.sin_cos().0,
        "cos" => |x| x.sin_cos().1,
        "tan" => Real::tan,
        "asin" => Real::asin,
        "acos" => Real::acos,
        "atan" => Real::atan,
        "exp" => Real::exp,
        "ln" => Real::ln,
        _ => Real::sqrt,
    }
}

fn value(name: &str, x: Ball) -> Ball {
    function(name)(Enclosure::at_rest(x)).value
}

/// Distance of a number from the centre of a ball, minus the radius.
fn outside(ball: Ball, number: Twofold) -> f64 {
    (ball.center - number).high.abs() - ball.radius
}

#[test]
fn functions_hold_their_values() {
    for &(name, x, [high, low]) in VALUES {
        let found = value(name, Ball::exact(x));
        assert!(outside(found, Twofold { high, low }) <= 1e-31 * high.abs(), "{name} {x}: {found:?}");
        assert!(found.radius <= 1e-26 * (1.0 + x.abs()) * (1.0 + high.abs()), "{name} {x}: {found:?}");
    }
}

#[test]
fn functions_of_balls_hold_the_values_of_what_is_in_them() {
    for &(name, x, [high, low]) in VALUES {
        for radius in [1e-12, 1e-6, 1e-3, 0.3] {
            for share in [-1.0, -0.3, 0.9, 1.0] {
                // A ball that contains x, possibly near its edge.
                let ball = Ball::around(Twofold::of(x) - Twofold::of(share * radius), radius * (1.0 + 1e-12));
                assert!(outside(value(name, ball), Twofold { high, low }) <= 1e-30 * (1.0 + high.abs()), "{name} {x} in {ball:?}");
            }
        }
    }
}

/// Some numbers in a ball.
fn samples(ball: Ball) -> impl Iterator<Item = Twofold> {
    [-1.0, -0.71, 0.0, 0.33, 1.0].into_iter().map(move |share| ball.center + Twofold::of(share * ball.radius))
}

#[test]
fn arithmetic_holds_what_numbers_do() {
    let balls = || (1..60).map(f64::from).map(|n| Ball::around(Twofold::of(libm::sin(n) * n), libm::exp2(-n) + 1e-3 / n));
    for (a, b) in balls().zip(balls().skip(11)) {
        for (x, y) in samples(a).flat_map(|x| samples(b).map(move |y| (x, y))) {
            for (found, number) in [(a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y)] {
                assert!(outside(found, number) <= 1e-28, "{a:?} and {b:?}: {found:?} without {number:?}");
            }
            let [e, f] = [a, b].map(Enclosure::at_rest);
            let (less, greater) = if (x - y).high < 0.0 { (x, y) } else { (y, x) };
            assert!(outside(e.max(f).value, greater) <= 1e-28);
            let selected = Enclosure::select_less(e, f, e, f).value;
            assert!(outside(selected, less) <= 1e-28, "the less of {a:?} and {b:?}: {selected:?}");
        }
    }
}

#[test]
fn what_may_be_undefined_is_not_bounded() {
    let zero = Ball::around(Twofold::of(0.0), 1e-20);
    let one = Ball::exact(1.0);
    assert!(!(one / zero).magnitude().is_finite());
    assert!(!value("sqrt", zero - Ball::exact(1e-21)).magnitude().is_finite());
    assert!(!value("ln", zero).magnitude().is_finite());
    assert!(!value("asin", one + zero).magnitude().is_finite());
    assert!(!functions::atan2(zero, -one).magnitude().is_finite(), "the angle jumps there");
    assert!(!value("sin", Ball::exact(f64::NAN)).magnitude().is_finite());
    assert!(!value("exp", Ball::exact(f64::INFINITY)).magnitude().is_finite());
}

const KNOTS: [f64; 4] = [0.0, 1.0, 1.5, 3.0];
/// The polynomial (x − 1)³ = −1 + 3x − 3x² + x³ in every interval, hence with two continuous derivatives.
const SPLINE: [[f64; 4]; 3] = [[-1.0, 3.0, -3.0, 1.0], [0.0, 0.0, 0.0, 1.0], [0.125, 0.75, 1.5, 1.0]];

/// Tables are not enclosed in `f32`.
const SINGLE: Single = Single { knots: &[], coefficients: &[], period: [0.0; 2] };

#[test]
fn tables_hold_their_values_across_knots() {
    for ends in [Ends::Linear, Ends::Hold, Ends::Periodic] {
        let table = Table { knots: &KNOTS, coefficients: &SPLINE, ends, single: SINGLE };
        for step in -40..=80 {
            let x = f64::from(step) * 0.0625;
            for radius in [0.0, 1e-9, 0.06, 0.5] {
                let found = functions::table(Ball::around(Twofold::of(x), radius), &table);
                for at in samples(Ball::around(Twofold::of(x), radius)) {
                    let (value, slope, curve) = table.evaluate(at.high);
                    for (ball, number) in [(found.0, value), (found.1, slope), (found.2, curve)] {
                        assert!(outside(ball, Twofold::of(number)) <= 1e-13, "{ends:?} at {x} ± {radius}: {ball:?} without {number}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_measured_law_is_trusted_at_doubles_only() {
    let law = |x: f64| (x * x, 2.0 * x, 2.0);
    assert!(Ball::exact(0.3).map(law)[0].is_proven);
    let [value, slope, _] = (Ball::exact(0.1) * Ball::exact(0.1)).map(law);
    assert!(!value.is_proven && !slope.is_proven);
    assert!((value.center.high - 1e-4).abs() <= 1e-19 && value.radius <= 1e-19);
    let doubtful = value + Ball::exact(1.0);
    assert!(!doubtful.is_proven && !functions::sin_cos(doubtful).1.is_proven && !(Ball::exact(2.0) / doubtful).is_proven);
}

/// Rates and accelerations against differences of values: x = a + b s + c s² is passed through a function.
#[test]
fn derivatives_are_those_of_the_values() {
    let at = |s: f64| Twofold::of(0.4) + Twofold::of(0.7) * Twofold::of(s) + Twofold::of(-0.3) * Twofold::of(s) * Twofold::of(s);
    let moving = Enclosure { value: Ball::exact(0.4), rate: Ball::exact(0.7), acceleration: Ball::exact(-0.6) };
    let of = |f: &dyn Fn(Enclosure) -> Enclosure, what: &str| {
        // Differences of 32-digit numbers, with truncation errors of order h².
        let h = 1e-7;
        let [before, here, after] = [-h, 0.0, h].map(|s| f(Enclosure::at_rest(Ball::around(at(s), 0.0))).value.center);
        let first = (after - before).high / (2.0 * h);
        let second = (after - here - (here - before)).high / (h * h);
        let found = f(moving);
        for (found, difference) in [(found.rate, first), (found.acceleration, second)] {
            assert!((found.center.high - difference).abs() <= 1e-11, "{what}: {found:?} for {difference}");
            assert!(found.radius <= 1e-26, "{what}: {found:?}");
        }
    };
    for name in ["sin", "cos", "tan", "asin", "acos", "atan", "exp", "ln", "sqrt"] {
        of(&function(name), name);
    }
    let three = Enclosure::of(3.0);
    of(&|x| x * x * x, "x³");
    of(&|x| three / (x + x * x), "3 / (x + x²)");
    of(&|x| (-x).abs() - x.max(three), "|−x| − max(x, 3)");
    of(&|x| (x - three).atan2(x * x - three), "atan2(x − 3, x² − 3)");
    let table = Table { knots: &KNOTS, coefficients: &SPLINE, ends: Ends::Linear, single: SINGLE };
    of(&|x| x.table(&table).0, "a table");
}
