//! `spline(x, [(x0, y0), …], ends)`: a spline of the fifth degree through points, with conditions at its ends.
//!
//! Four derivatives are continuous at the points between the ends. Velocity and acceleration at the ends are zero unless they are given;
//! beyond its ends the spline goes on with the velocity there. A periodic one has four continuous derivatives at its ends, too.

use super::piecewise::{piecewise, wrapped};
use super::table::{pairs, returns, values};
use super::{SPLINE, Valuer, is_word};
use crate::diag::{Range, ValueFact};
use crate::expr::{Exact, Expr};
use crate::linear::dense::solve;
use crate::names::{Scalar, Scope};
use crate::quantity::{Dim, InferredDim};
use crate::syntax::ast::{self, ExpressionKind};
use core::f64::consts::TAU;
use proc_macro2::Ident;

/// The most points. Each interval is written out.
const MOST: usize = 64;

/// A spline that misses its points by more than this fraction of its size is refused.
const MISSES: f64 = 1e-9;

/// What is known at the ends.
#[derive(Clone, Copy, PartialEq)]
enum SplineEnds {
    Periodic,
    /// Velocity and acceleration at the first and at the last point.
    Given([[Exact; 2]; 2]),
}

impl SplineEnds {
    /// At rest, without acceleration.
    const REST: SplineEnds = SplineEnds::Given([[Exact::ZERO; 2]; 2]);
}

/// The expression of a spline.
pub(super) fn spline(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    let (x, points, ends) = match arguments {
        [x, points] => (x, points, None),
        [x, points, ends] => (x, points, Some(ends)),
        _ => return work.reject(name.into(), ValueFact::SplineArity { found: arguments.len() }),
    };
    let ExpressionKind::List(items) = &points.kind else {
        return match &x.kind {
            ExpressionKind::List(_) => {
                let instead = format!("{SPLINE}({points}, […])");
                work.reject(name.into(), ValueFact::TableTakesArgumentFirst { word: SPLINE, instead })
            }
            _ => work.reject(points.range, ValueFact::TableNeedsList),
        };
    };
    let argument = work.number(x, scope)?;
    let mut columns = [argument.measure, InferredDim::Any];
    let points = pairs(work, SPLINE, points.range, items, &mut columns, scope)?;
    if points.len() > MOST {
        return work.reject(name.into(), ValueFact::SplineTooLong { found: points.len(), limit: MOST });
    }
    let mut measure = columns[1];
    let ends = match ends {
        Some(ends) => read(work, ends, argument.measure, &mut measure, scope)?,
        None => SplineEnds::REST,
    };
    if ends == SplineEnds::Periodic {
        returns(work, SPLINE, items, &points, measure)?;
    }
    let expr = expression(work, name.into(), &points, ends, Scalar { measure: columns[0], ..argument })?;
    Some(Scalar { expr, measure })
}

/// The ends as written.
fn read(work: &mut impl Valuer, ends: &ast::Expression, from: InferredDim, to: &mut InferredDim, scope: &Scope) -> Option<SplineEnds> {
    match &ends.kind {
        _ if is_word(ends, "periodic") => Some(SplineEnds::Periodic),
        _ if is_word(ends, "hold") => Some(SplineEnds::REST),
        ExpressionKind::List(items) if items.len() == 2 => {
            let mut columns = [to.per(from), to.per(from).per(from)];
            let [first, last] =
                [values(work, SPLINE, &items[0], &mut columns, scope)?, values(work, SPLINE, &items[1], &mut columns, scope)?];
            Some(SplineEnds::Given([first, last]))
        }
        _ => work.reject(ends.range, ValueFact::SplineEnds),
    }
}

/// The value at x.
fn expression(work: &mut impl Valuer, range: Range, points: &[[Exact; 2]], ends: SplineEnds, x: Scalar) -> Option<Expr> {
    let (&[first, before], &[last, after]) = (points.first()?, points.last()?);
    let arena = work.arena();
    let [first, last] = [first, last].map(|place| arena.constant(place));
    let (since, length) = (arena.sub(x.expr, first), arena.sub(last, first));
    let is_turn = x.measure.settled() == Dim::ANGLE && arena.value(length) == Some(TAU);
    let place = if ends == SplineEnds::Periodic { wrapped(work, since, length, is_turn) } else { since };
    let size = size(points, ends);
    let Some(motions) = motions(points, ends) else { return work.reject(range, ValueFact::SplineSwings) };
    let mut pieces = Vec::new();
    for (pair, known) in points.windows(2).zip(motions.windows(2)) {
        let [from, to] = [pair[0][0], pair[1][0]].map(|place| work.arena().constant(place));
        let arena = work.arena();
        let (begin, width) = (arena.sub(from, first), arena.sub(to, from));
        let along = arena.sub(place, begin);
        let share = arena.div(along, width);
        let coefficients = coefficients(work, range, [pair[0], pair[1]], [known[0], known[1]], size)?;
        let arena = work.arena();
        let mut value = arena.integer(0);
        for coefficient in coefficients.into_iter().rev() {
            let (product, coefficient) = (arena.mul(value, share), arena.constant(coefficient));
            value = arena.add(product, coefficient);
        }
        pieces.push((begin, value));
    }
    let SplineEnds::Given([[early, _], [late, _]]) = ends else { return Some(piecewise(work, place, &pieces)) };
    let (zero, since) = (work.arena().integer(0), work.arena().sub(place, length));
    let [early, late] =
        [(place, before, early), (since, after, late)].map(|(since, value, velocity)| tangent(work, since, value, velocity));
    pieces.insert(0, (zero, early));
    let inside = piecewise(work, place, &pieces);
    // NaN is not less, and takes the last branch, which contains x.
    Some(work.arena().select(length, place, late, inside))
}

/// The largest value at a point, or the way that a motion given at an end makes over the whole length.
fn size(points: &[[Exact; 2]], ends: SplineEnds) -> f64 {
    let length = points.first().zip(points.last()).map_or(0.0, |(first, last)| last[0].to_f64() - first[0].to_f64());
    let of_points = points.iter().map(|point| point[1].to_f64().abs());
    let of_ends = match ends {
        SplineEnds::Periodic => [0.0; 2],
        SplineEnds::Given(ends) => ends.map(|end| {
            let [velocity, acceleration] = end.map(Exact::to_f64);
            (velocity * length).abs() + (acceleration * length * length).abs()
        }),
    };
    of_points.chain(of_ends).fold(0.0, f64::max)
}

/// y + v s
fn tangent(work: &mut impl Valuer, since: Expr, value: Exact, velocity: Exact) -> Expr {
    let arena = work.arena();
    let (value, velocity) = (arena.constant(value), arena.constant(velocity));
    let way = arena.mul(velocity, since);
    arena.add(value, way)
}

/// Coefficients of the powers of s from 0 to 1 in an interval, with the velocities and accelerations at its ends.
///
/// ```text
///   y₀,   h v₀,   h² a₀/2,
///    10 Δ −  6 h v₀ − 4 h v₁ − 3/2 h² a₀ + 1/2 h² a₁
///   −15 Δ +  8 h v₀ + 7 h v₁ + 3/2 h² a₀ −     h² a₁        Δ = y₁ − y₀,  h = x₁ − x₀
///     6 Δ −  3 h v₀ − 3 h v₁ − 1/2 h² a₀ + 1/2 h² a₁
/// ```
///
/// They are refused if rounding makes their sum miss the end, or if they are too large for exact numbers.
fn coefficients(
    work: &mut impl Valuer,
    range: Range,
    [one, two]: [[Exact; 2]; 2],
    [[v0, a0], [v1, a1]]: [[f64; 2]; 2],
    size: f64,
) -> Option<[Exact; 6]> {
    let (width, rise) = (two[0].to_f64() - one[0].to_f64(), two[1].to_f64() - one[1].to_f64());
    let [v0, v1, a0, a1] = [width * v0, width * v1, width * width * a0, width * width * a1];
    let numbers = [
        v0,
        0.5 * a0,
        10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
        -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
        6.0 * rise - 3.0 * v0 - 3.0 * v1 - 0.5 * a0 + 0.5 * a1,
    ];
    let largest = numbers.into_iter().map(f64::abs).fold(one[1].to_f64().abs(), f64::max);
    let is_off = f64::EPSILON * largest > MISSES * size;
    if is_off || numbers.iter().any(|number| !number.is_finite()) {
        return work.reject(range, ValueFact::SplineSwings);
    }
    let mut exact = [one[1]; 6];
    for (place, number) in exact[1..].iter_mut().zip(numbers) {
        let Some(kept) = rounded(number, largest) else { return work.reject(range, ValueFact::SplineOutOfRange) };
        *place = kept;
    }
    Some(exact)
}

/// A number as a multiple of 2⁻⁷⁰ of the largest one, or of 2⁻¹¹⁹; `None` if it is too large or if that is too coarse.
fn rounded(number: f64, largest: f64) -> Option<Exact> {
    if number == 0.0 {
        return Some(Exact::ZERO);
    }
    let exponent = libm::ilogb(largest);
    let power = (exponent - 70).max(-119);
    if exponent - power < 52 {
        return None;
    }
    let whole = libm::round(libm::scalbn(number, -power)) as i128;
    let unit = 1_i128.checked_shl(power.unsigned_abs())?;
    if power < 0 { Exact::ratio(whole, unit) } else { Exact::ratio(whole.checked_mul(unit)?, 1) }
}

/// Velocity and acceleration at each point, such that the third and the fourth derivative do not jump; `None` if there are none.
///
/// With Δ = y₁ − y₀ and h = x₁ − x₀ these derivatives are, at the ends of an interval,
///
/// ```text
///   y‴(x₀) =   60 Δ/h³ −  36 v₀/h² −  24 v₁/h² −  9 a₀/h  +  3 a₁/h
///   y‴(x₁) =   60 Δ/h³ −  24 v₀/h² −  36 v₁/h² −  3 a₀/h  +  9 a₁/h
///   y⁗(x₀) = −360 Δ/h⁴ + 192 v₀/h³ + 168 v₁/h³ + 36 a₀/h² − 24 a₁/h²
///   y⁗(x₁) =  360 Δ/h⁴ − 168 v₀/h³ − 192 v₁/h³ − 24 a₀/h² + 36 a₁/h²
/// ```
fn motions(points: &[[Exact; 2]], ends: SplineEnds) -> Option<Vec<[f64; 2]>> {
    let intervals = points.len() - 1;
    let numbers: Vec<[f64; 2]> = points.iter().map(|point| point.map(Exact::to_f64)).collect();
    // In units of the mean width, the rows are of one size.
    let unit = (numbers[intervals][0] - numbers[0][0]) / intervals as f64;
    let part = |i: usize| {
        let [[x0, y0], [x1, y1]] = [numbers[i], numbers[i + 1]];
        ((x1 - x0) / unit, y1 - y0)
    };
    let count = 2 * points.len();
    let mut matrix = vec![vec![0.0; count]; count];
    let mut right = vec![0.0; count];
    for knot in 0..points.len() {
        let (third, fourth) = (2 * knot, 2 * knot + 1);
        let before = if knot == 0 { intervals - 1 } else { knot - 1 };
        match (ends, knot == 0, knot == intervals) {
            (SplineEnds::Given(given), first, last) if first || last => {
                let [velocity, acceleration] = given[usize::from(last)].map(Exact::to_f64);
                (matrix[third][third], right[third]) = (1.0, velocity * unit);
                (matrix[fourth][fourth], right[fourth]) = (1.0, acceleration * unit * unit);
            }
            // The last point of a periodic spline is the first.
            (_, _, true) => {
                for row in [third, fourth] {
                    matrix[row][row] = 1.0;
                    matrix[row][row - 2 * intervals] = -1.0;
                }
            }
            _ => {
                let ((h, rise), (k, next)) = (part(before), part(knot));
                let mut add = |row: usize, first: usize, factors: [f64; 4]| {
                    for (place, factor) in factors.into_iter().enumerate() {
                        matrix[row][2 * first + place] += factor;
                    }
                };
                let (square, cube) = (h * h, h * h * h);
                add(third, before, [-24.0 / square, -3.0 / h, -36.0 / square, 9.0 / h]);
                add(fourth, before, [-168.0 / cube, -24.0 / square, -192.0 / cube, 36.0 / square]);
                let (square, cube) = (k * k, k * k * k);
                add(third, knot, [36.0 / square, 9.0 / k, 24.0 / square, -3.0 / k]);
                add(fourth, knot, [-192.0 / cube, -36.0 / square, -168.0 / cube, 24.0 / square]);
                right[third] = 60.0 * (next / cube - rise / (h * h * h));
                right[fourth] = -360.0 * (next / (cube * k) + rise / (h * h * h * h));
            }
        }
    }
    let found = solve(matrix, &right)?;
    Some(found.chunks(2).map(|motion| [motion[0] / unit, motion[1] / (unit * unit)]).collect())
}
