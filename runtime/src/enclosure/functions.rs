//! Functions of balls. Nothing here relies on the accuracy of `libm`, which only provides first guesses: sine, cosine and the
//! exponential are summed from their series with a known remainder, and their inverses are verified by them.

use super::ball::{Ball, ROUNDING, down, up};
use super::twofold::Twofold;
use crate::number::{Ends, Table};

/// π/2 and ln 2, with relative errors below 2⁻¹⁰⁷.
const QUARTER: Twofold = Twofold { high: core::f64::consts::FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
const LN_2: Twofold = Twofold { high: core::f64::consts::LN_2, low: 2.319_046_813_846_3e-17 };

/// Largest angle that is reduced.
const LARGEST_ANGLE: f64 = 1e12;

/// Largest exponent that is computed.
const LARGEST_POWER: f64 = 300.0;

/// Sine and cosine; both have slopes of at most 1.
///
/// ```text
/// x = n π/2 + y         |y| ≤ π/4 + 1e-3; error of y: 5u² + u²/2 of n π/2, and 3u² of y, together below 16u² |x|
/// sin y = y (1 − z/(2·3) (1 − z/(4·5) (1 − …)))        z = y², up to y²⁷; the rest is below y²⁹/29! < 2e-34
/// cos y = 1 − z/(1·2) (1 − z/(3·4) (1 − …))            up to y²⁸; the rest is below y³⁰/30! < 4e-36
/// ```
///
/// The error of each bracket is at most 3u², plus 31u² for its product and quotient, plus a third of the error of the inner bracket: 20u²
/// in all. Even four times that, plus the remainder, is below 2⁻⁹⁹.
pub(super) fn sin_cos(x: Ball) -> (Ball, Ball) {
    let anything = Ball::around(Twofold::of(0.0), 1.0).with_doubts_of(x);
    if !(x.center.high.abs() <= LARGEST_ANGLE && x.radius <= 1.0) {
        let is_angle = x.center.high.is_finite() && x.radius >= 0.0;
        let pair = if is_angle { anything } else { Ball::anything().with_doubts_of(x) };
        return (pair, pair);
    }
    let (sine, cosine) = sin_cos_of(x.center);
    let radius = up(x.radius + 1.0 / 633_825_300_114_114_700_748_351_602_688.0 + ROUNDING * x.center.high.abs());
    (Ball { center: sine, radius, ..x }, Ball { center: cosine, radius, ..x })
}

/// Sine and cosine of a centre.
fn sin_cos_of(x: Twofold) -> (Twofold, Twofold) {
    let n = libm::rint(x.high * core::f64::consts::FRAC_2_PI);
    let y = x - QUARTER * Twofold::of(n);
    let z = y * y;
    let one = Twofold::of(1.0);
    let series = |first: u32| {
        (0..14).rev().fold(one, |inside, k| {
            let factor = f64::from((2 * k + first) * (2 * k + first + 1));
            one - z * inside / Twofold::of(factor)
        })
    };
    let (sine, cosine) = (y * series(2), series(1));
    match libm::fmod(n, 4.0) as i32 {
        0 => (sine, cosine),
        1 | -3 => (cosine, -sine),
        2 | -2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// Square root. Of a centre s it is known that |√x − s| = |x − s²| / (√x + s) ≤ |x − s²| / s.
pub(super) fn sqrt(x: Ball) -> Ball {
    if x == Ball::exact(0.0) {
        return x;
    }
    let root = Ball::around(x.center.sqrt(), 0.0);
    let (rest, least) = ((x - root * root).magnitude(), down(root.center.high));
    if !(x.lowest() >= 0.0 && least > 0.0) {
        return Ball::anything().with_doubts_of(x);
    }
    Ball { radius: up(rest / least), ..root.with_doubts_of(x) }
}

/// The angle of the vector (x, y). Turned back by a centre a the vector has the angle e with tan e = s/c:
///
/// ```text
/// s = y cos a − x sin a,   c = x cos a + y sin a;     |e| ≤ |s| / c for c > 0
/// ```
pub(super) fn atan2(y: Ball, x: Ball) -> Ball {
    // The branch cut, where the angle jumps from π to −π.
    let is_right = x.lowest() > 0.0;
    let may_jump = y.may_vanish() && !y.is_double() && !is_right;
    let turned_back = |angle: Twofold| {
        let (sine, cosine) = sin_cos(Ball::around(angle, 0.0));
        (y * cosine - x * sine, x * cosine + y * sine)
    };
    let mut angle = Twofold::of(libm::atan2(y.center.high, x.center.high));
    for _ in 0..2 {
        let (s, c) = turned_back(angle);
        angle = angle + Twofold::of(s.center.high / c.center.high);
    }
    let (s, c) = turned_back(angle);
    if may_jump || !(c.least() > 0.0 && c.center.high > 0.0) {
        return Ball::anything().with_doubts_of(x).with_doubts_of(y);
    }
    Ball::around(angle, up(s.magnitude() / c.least())).with_doubts_of(x).with_doubts_of(y)
}

/// The exponential function.
///
/// ```text
/// x = k ln 2 + y          |y| ≤ 0.3467; y is off by less than 16u² |x|
/// eʸ = 1 + y/1 (1 + y/2 (1 + …))       up to y²⁵; the rest is below 1e-38
/// ```
///
/// The error of each bracket is at most 5u², plus 31u², plus half of the error of the inner bracket: 60u²; 2⁻⁹⁹ is four times as much. A
/// change of x by r ≤ 1 is a factor of at most 1 + r + r².
pub(super) fn exp(x: Ball) -> Ball {
    let (size, r) = (x.center.high.abs(), x.radius);
    if !(size <= LARGEST_POWER && r <= 1.0) {
        return Ball::anything().with_doubts_of(x);
    }
    let k = libm::rint(x.center.high * core::f64::consts::LOG2_E);
    let y = x.center - LN_2 * Twofold::of(k);
    let one = Twofold::of(1.0);
    let power = (1..=25).rev().fold(one, |inside, n| one + y * inside / Twofold::of(f64::from(n)));
    let center = power.scaled(f64::from_bits(((1023 + k as i64) as u64) << 52));
    let rounding = 1.0 / 633_825_300_114_114_700_748_351_602_688.0 + ROUNDING * size;
    Ball { center, radius: up(up(center.high) * (r + r * r + 8.0 * rounding)), ..x }
}

/// Natural logarithm. With q = x / eᵃ it is a + ln q, and |ln q| ≤ |q − 1| / (1 − |q − 1|).
pub(super) fn ln(x: Ball) -> Ball {
    let one = Ball::exact(1.0);
    let excess = |a: Twofold| x / exp(Ball::around(a, 0.0)) - one;
    let mut logarithm = Twofold::of(libm::log(x.center.high));
    for _ in 0..2 {
        logarithm = logarithm + Twofold::of(excess(logarithm).center.high);
    }
    let off = excess(logarithm).magnitude();
    if !(x.lowest() > 0.0 && off < 0.5) {
        return Ball::anything().with_doubts_of(x);
    }
    Ball::around(logarithm, up(off / down(1.0 - off))).with_doubts_of(x)
}

/// A cubic spline: the hull of all pieces that the ball touches, each evaluated as a polynomial of the ball.
pub(super) fn table(x: Ball, table: &Table) -> (Ball, Ball, Ball) {
    let nothing = Ball::anything().with_doubts_of(x);
    let (Some(&first), Some(&last)) = (table.knots.first(), table.knots.last()) else { return (nothing, nothing, nothing) };
    if !(x.lowest() > f64::NEG_INFINITY && x.highest() < f64::INFINITY) {
        return (nothing, nothing, nothing);
    }
    let mut found = None;
    match table.ends {
        Ends::Periodic => {
            let period = Ball::exact(last) - Ball::exact(first);
            let turns = (x - Ball::exact(first)) / period;
            let (from, to) = (libm::floor(turns.lowest()), libm::floor(turns.highest()));
            // A ball wider than three periods, or NaN, gives no bound.
            let is_narrow = to - from <= 2.0;
            if !is_narrow {
                return (nothing, nothing, nothing);
            }
            let mut turn = from;
            while turn <= to {
                pieces(&mut found, x - period * Ball::exact(turn), table);
                turn += 1.0;
            }
        }
        Ends::Linear | Ends::Hold => {
            if x.highest() >= first && x.lowest() <= last {
                pieces(&mut found, x, table);
            }
            for (end, is_reached) in [(first, x.lowest() < first), (last, x.highest() > last)] {
                if is_reached {
                    let mut there = None;
                    pieces(&mut there, Ball::exact(end), table);
                    let (value, slope, _) = there.unwrap_or((nothing, nothing, nothing));
                    let zero = Ball::exact(0.0);
                    let beyond = match table.ends {
                        Ends::Linear => (value + slope * (x - Ball::exact(end)), slope, zero),
                        _ => (value, zero, zero),
                    };
                    join(&mut found, beyond);
                }
            }
        }
    }
    let (value, slope, curve) = found.unwrap_or((nothing, nothing, nothing));
    (value.with_doubts_of(x), slope.with_doubts_of(x), curve.with_doubts_of(x))
}

type Triple = (Ball, Ball, Ball);

/// Adds the hull of the pieces that the ball touches.
fn pieces(found: &mut Option<Triple>, x: Ball, table: &Table) {
    let interval = |at: f64| table.knots.partition_point(|&knot| knot <= at).min(table.coefficients.len()).saturating_sub(1);
    for index in interval(x.lowest())..=interval(x.highest()) {
        if let (Some(&knot), Some(&coefficients)) = (table.knots.get(index), table.coefficients.get(index)) {
            let ([c0, c1, c2, c3], d) = (coefficients.map(Ball::exact), x - Ball::exact(knot));
            let [two, three, six] = [2.0, 3.0, 6.0].map(Ball::exact);
            join(found, (c0 + d * (c1 + d * (c2 + d * c3)), c1 + d * (two * c2 + d * (three * c3)), two * c2 + d * (six * c3)));
        }
    }
}

fn join(found: &mut Option<Triple>, piece: Triple) {
    *found = Some(found.map_or(piece, |(value, slope, curve)| (value.hull(piece.0), slope.hull(piece.1), curve.hull(piece.2))));
}
