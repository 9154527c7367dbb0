//! `segments(x, y0, [rise(height, duration, law), dwell(duration), fall(height, duration, law)], periodic)`: a program of motions.
//!
//! The height begins at y0 where x = 0. Each segment goes on from the height of the one before:
//!
//! ```text
//!   rise    y + h f((x − x0) / β)              law f, from 0 to 1; height h, duration β
//!   fall    y − h f((x − x0) / β)
//!   dwell   y
//! ```
//!
//! A law is named, as `cycloidal`, or is `scca(b, c)` or `spline([…])` without the argument u.
//!
//! A periodic program over an angle fills one turn, over another quantity it repeats after the sum of its durations; any other rests before
//! its beginning and after its end.

use super::piecewise::{piecewise, turn, wrapped};
use super::{SCCA, SEGMENTS, SPLINE, Valuer, is_word};
use crate::diag::{ArityFact, GrammarFact, Range, ValueFact};
use crate::expr::{Exact, Expr, Leaf, Unary, derivative};
use crate::model::Requirement;
use crate::names::{Scalar, Scope, Value};
use crate::quantity::{self, Dim, InferredDim};
use crate::syntax::ast::{self, ExpressionKind, Relation};
use core::f64::consts::TAU;
use proc_macro2::Ident;

/// Relative tolerance of sums of durations and of heights, which may be quotients such as 360°/7.
const SUM: f64 = 1e-9;

/// Relative tolerance of velocities, and of the values of a law at its ends.
const SLOPE: f64 = 1e-6;

/// The derivatives of a law at its ends are taken at 1/this inside: exactly at an end a law may have the zero derivative of the rest beside it.
const INSIDE: i128 = 1 << 30;

/// Velocities, by x, with which a segment begins and ends; NaN if the compiler cannot run its law.
type Slopes = [f64; 2];

/// A segment as written.
struct Segment<'a> {
    /// `rise`, `fall` or `dwell`
    word: &'a Ident,
    duration: Expr,
    duration_range: Range,
    /// Height that is added, negative for a fall, with the range of its number; `None` for a dwell.
    height: Option<(Expr, Range)>,
    law: Option<SegmentLaw<'a>>,
    /// Velocities at the declared defaults.
    slopes: Slopes,
}

/// A function of u, with the arguments after u.
#[derive(Clone, Copy)]
struct SegmentLaw<'a> {
    path: &'a ast::Path,
    others: &'a [ast::Expression],
}

/// A program while it is read.
struct Program<'a> {
    x: Scalar,
    /// Beginnings of the segments, and the end of the last.
    times: Vec<Expr>,
    /// Heights at these times.
    heights: Vec<Expr>,
    /// Dimension of heights.
    measure: InferredDim,
    segments: Vec<Segment<'a>>,
    is_periodic: bool,
    range: Range,
}

impl Program<'_> {
    fn is_turn(&self) -> bool {
        self.is_periodic && self.x.measure.settled() == Dim::ANGLE
    }

    fn end(&self) -> [Expr; 2] {
        [self.times[self.segments.len()], self.heights[self.segments.len()]]
    }
}

/// The expression of a program of segments.
pub(crate) fn segments(work: &mut impl Valuer, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
    let (x, first, list, ends) = match arguments {
        [x, first, list] => (x, first, list, None),
        [x, first, list, ends] => (x, first, list, Some(ends)),
        _ => return work.reject(name.into(), ValueFact::SegmentsArity { found: arguments.len() }),
    };
    let is_periodic = ends.is_some_and(|ends| is_word(ends, "periodic"));
    if let Some(ends) = ends.filter(|ends| !is_periodic && !is_word(ends, "hold")) {
        return work.reject(ends.range, ValueFact::SegmentsEnds);
    }
    let ExpressionKind::List(items) = &list.kind else { return work.reject(list.range, ValueFact::SegmentsNeedList) };
    if items.is_empty() {
        return work.reject(list.range, ValueFact::SegmentsNeedList);
    }
    let (x, first) = (work.number(x, scope)?, work.number(first, scope)?);
    let start = work.arena().integer(0);
    let (times, heights) = (vec![start], vec![first.expr]);
    let mut program = Program { x, times, heights, measure: first.measure, segments: Vec::new(), is_periodic, range: list.range };
    for item in items {
        add(work, &mut program, item, scope)?;
    }
    fits(work, &program)?;
    velocities_agree(work, &program)?;
    require(work, &program);
    let expr = expression(work, &program, scope)?;
    Some(Scalar { expr, measure: program.measure })
}

/// The dimension of a number with a unit.
fn of_literal(value: &ast::Expression) -> Option<Dim> {
    match &value.kind {
        ExpressionKind::Number { unit, .. } => quantity::unit(unit).map(|(_, dim)| dim),
        _ => None,
    }
}

/// Reads a segment and adds it to the program.
fn add<'a>(work: &mut impl Valuer, program: &mut Program<'a>, item: &'a ast::Expression, scope: &Scope) -> Option<()> {
    let ExpressionKind::Call(ast::Path { name: Some(word), .. }, arguments) = &item.kind else {
        return work.reject(item.range, ValueFact::NotASegment);
    };
    let (height, duration, law) = match (word.to_string().as_str(), arguments.as_slice()) {
        ("rise" | "fall", [height, duration, law]) => (Some(height), duration, Some(law)),
        ("dwell", [duration]) => (None, duration, None),
        (name @ ("rise" | "fall" | "dwell"), _) => {
            let wanted = if name == "dwell" { 1 } else { 3 };
            return work.reject(word.into(), ArityFact::FunctionArity { name: name.to_owned(), wanted, found: arguments.len() });
        }
        _ => return work.reject(word.into(), ValueFact::NotASegment),
    };
    if let [height, duration, law] = arguments.as_slice()
        && let (Some(first), Some(second)) = (of_literal(height), of_literal(duration))
        && program.x.measure == InferredDim::Known(first)
        && program.measure == InferredDim::Known(second)
        && first != second
    {
        let instead = format!("{word}({duration}, {height}, {law})");
        return work.reject(item.range, GrammarFact::Misspelt { flaw: "the height of a segment comes first", instead });
    }
    let time = fixed(work, duration, &mut program.x.measure, scope)?;
    let height = match height {
        Some(height) => Some((fixed(work, height, &mut program.measure, scope)?, height.range)),
        None => None,
    };
    let height = height.map(|(up, range)| (if word == "fall" { work.arena().neg(up) } else { up }, range));
    let law = match law {
        Some(law) => Some(named_law(work, law)?),
        None => None,
    };
    let (begin, before) = (program.times[program.segments.len()], program.heights[program.segments.len()]);
    let end = work.arena().add(begin, time);
    let after = match height {
        Some((up, _)) => work.arena().add(before, up),
        None => before,
    };
    let mut segment = Segment { word, duration: time, duration_range: duration.range, height, law, slopes: [0.0; 2] };
    segment.slopes = slopes(work, &segment, scope)?;
    program.times.push(end);
    program.heights.push(after);
    program.segments.push(segment);
    Some(())
}

/// Evaluates a duration or a height, which may depend on parameters, and has the dimension of the others.
fn fixed(work: &mut impl Valuer, expr: &ast::Expression, measure: &mut InferredDim, scope: &Scope) -> Option<Expr> {
    let scalar = work.number(expr, scope)?;
    let Some(common) = measure.common(scalar.measure) else {
        return work.reject(expr.range, ValueFact::WrongDimension { wanted: measure.settled(), found: scalar.measure.settled() });
    };
    *measure = common;
    if !work.may_be_fixed(scalar.expr) {
        return work.reject(expr.range, ValueFact::NotFixed { place: "a segment" });
    }
    Some(scalar.expr)
}

/// The law that is written in a segment.
fn named_law<'a>(work: &mut impl Valuer, law: &'a ast::Expression) -> Option<SegmentLaw<'a>> {
    match &law.kind {
        ExpressionKind::Path(path) => Some(SegmentLaw { path, others: &[] }),
        ExpressionKind::Call(path, others) if path.name.as_ref().is_some_and(|name| name == SCCA || name == SPLINE) => {
            Some(SegmentLaw { path, others })
        }
        _ => work.reject(law.range, ValueFact::NotALaw),
    }
}

/// f(u), the law of a segment.
fn law(work: &mut impl Valuer, SegmentLaw { path, others }: SegmentLaw, u: Expr, scope: &Scope) -> Option<Expr> {
    // No name can be written like this one.
    let name = Ident::new("__u", path.last.span());
    let mut scope = scope.clone();
    scope.bound.push((name.to_string(), Value::Scalar(Scalar { expr: u, measure: InferredDim::Known(Dim::NUMBER) })));
    let argument = ast::Path { tokens: quote::ToTokens::to_token_stream(&name), last: name.clone(), name: Some(name), range: path.range };
    let argument = ast::Expression { kind: ExpressionKind::Path(argument), range: path.range, depth: 1 };
    let arguments = core::iter::once(argument).chain(others.iter().cloned()).collect();
    let call = ast::Expression { kind: ExpressionKind::Call(path.clone(), arguments), range: path.range, depth: 2 };
    let value = work.number(&call, &scope)?;
    if !value.measure.fits(Dim::NUMBER) {
        return work.reject(path.range, ValueFact::WrongDimension { wanted: Dim::NUMBER, found: value.measure.settled() });
    }
    Some(value.expr)
}

/// Checks that the law of a segment goes from 0 to 1, and reads the velocities there.
fn slopes(work: &mut impl Valuer, segment: &Segment, scope: &Scope) -> Option<Slopes> {
    let (Some((height, _)), Some(of)) = (segment.height, segment.law) else { return Some([0.0; 2]) };
    let path = of.path;
    let inside = Exact::ratio(1, INSIDE).unwrap_or(Exact::ONE);
    let mut at = |from_end: bool| {
        // The time stands for the argument of the law, and is 0.
        let (time, arena) = (work.arena().leaf(Leaf::Time), work.arena());
        let (one, inside) = (arena.integer(1), arena.constant(inside));
        let end = if from_end { arena.sub(one, inside) } else { inside };
        let u = arena.add(time, end);
        let value = law(work, of, u, scope)?;
        let slope = derivative(work.arena(), value, Leaf::Time);
        let found = work.at_defaults(&[value, slope, height, segment.duration]);
        Some((found[0], found[1] * found[2] / found[3]))
    };
    let ((first, begin), (last, end)) = (at(false)?, at(true)?);
    if first.abs() > SLOPE || (last - 1.0).abs() > SLOPE {
        return work.reject(path.range, ValueFact::LawFromTo { name: path.last.to_string(), from: first, to: last });
    }
    Some([begin, end])
}

/// Checks that durations are positive, and that a periodic program fills a turn and returns to its beginning.
fn fits(work: &mut impl Valuer, program: &Program) -> Option<()> {
    let along = program.x.measure.settled();
    let durations: Vec<Expr> = program.segments.iter().map(|segment| segment.duration).collect();
    for (segment, found) in program.segments.iter().zip(work.at_defaults(&durations)) {
        if found <= 0.0 {
            return work.reject(segment.duration_range, ValueFact::SegmentWithoutDuration { found, dim: along });
        }
    }
    let [time, height] = program.end();
    let numbers = work.at_defaults(&[time, height, program.heights[0]]);
    let last = program.segments.last()?;
    if program.is_turn() && (numbers[0] - TAU).abs() > SUM * TAU {
        return work.reject(last.duration_range, ValueFact::SegmentsMissTurn { found: numbers[0] });
    }
    let heights: Vec<Expr> = program.segments.iter().filter_map(|segment| segment.height).map(|(height, _)| height).collect();
    let size: f64 = work.at_defaults(&heights).iter().map(|height| height.abs()).sum();
    let off = numbers[1] - numbers[2];
    if program.is_periodic && off.abs() > SUM * size {
        let moved = program.segments.iter().rev().find_map(|segment| segment.height);
        let range = moved.map_or(program.range, |(_, range)| range);
        return work.reject(range, ValueFact::SegmentsDoNotReturn { off, dim: program.measure.settled() });
    }
    Some(())
}

/// Checks that each segment begins with the velocity with which the one before ends.
fn velocities_agree(work: &mut impl Valuer, program: &Program) -> Option<()> {
    let largest = largest_velocity(work, program);
    let times = work.at_defaults(&program.times);
    let count = program.segments.len();
    // Where a periodic program begins, its last segment ends; any other begins and ends at rest.
    let meetings = if program.is_periodic { count } else { count + 1 };
    for (index, at) in times.iter().enumerate().take(meetings) {
        let one = match index {
            0 if program.is_periodic => program.segments.last(),
            _ => index.checked_sub(1).and_then(|before| program.segments.get(before)),
        };
        let two = program.segments.get(index);
        let (ends, begins) = (one.map_or(0.0, |segment| segment.slopes[1]), two.map_or(0.0, |segment| segment.slopes[0]));
        let (Some(blamed), true) = (two.or(one), (ends - begins).abs() > SLOPE * largest) else { continue };
        let fact = ValueFact::SegmentsJolt {
            at: *at,
            velocities: [ends, begins],
            laws: [one, two].map(|segment| segment.map(named)),
            along: program.x.measure.settled(),
            dim: program.measure.settled(),
        };
        return work.reject(blamed.word.into(), fact);
    }
    Some(())
}

/// The largest mean velocity of a segment: its height divided by its duration.
fn largest_velocity(work: &mut impl Valuer, program: &Program) -> f64 {
    let mean = |segment: &Segment| segment.height.map(|(height, _)| work.at_defaults(&[height, segment.duration]));
    let means = program.segments.iter().filter_map(mean).map(|numbers| (numbers[0] / numbers[1]).abs());
    means.fold(0.0, f64::max)
}

/// The law of a segment, or the word for one without.
fn named(segment: &Segment) -> String {
    segment.law.map_or(segment.word, |law| &law.path.last).to_string()
}

/// States what must hold for other values of the parameters, too.
fn require(work: &mut impl Valuer, program: &Program) {
    let [time, height] = program.end();
    let (along, across) = (program.x.measure.settled(), program.measure.settled());
    for segment in &program.segments {
        let zero = work.arena().integer(0);
        state(work, segment.duration_range, [segment.duration, zero], Relation::Greater, along, "the duration of a segment is positive");
    }
    if program.is_turn() {
        let turn = turn(work);
        let off = work.arena().sub(time, turn);
        near_zero(work, program.range, off, turn, along, "the segments fill one turn");
    }
    if program.is_periodic {
        let start = program.heights[0];
        let off = work.arena().sub(height, start);
        let sizes: Vec<Expr> = program.segments.iter().filter_map(|segment| segment.height).map(|(height, _)| height).collect();
        let sizes: Vec<Expr> = sizes.into_iter().map(|height| work.arena().unary(Unary::Abs, height)).collect();
        let size = work.arena().sum(&sizes);
        near_zero(work, program.range, off, size, across, "the height of the segments returns to its beginning");
    }
}

/// Requires |off| ≤ 10⁻⁶ size, more than the rounding errors of single precision.
fn near_zero(work: &mut impl Valuer, range: Range, off: Expr, size: Expr, dim: Dim, why: &str) {
    let arena = work.arena();
    let (off, share) = (arena.unary(Unary::Abs, off), arena.constant(Exact::ratio(1, 1_000_000).unwrap_or(Exact::ONE)));
    let limit = arena.mul(share, size);
    state(work, range, [off, limit], Relation::LessOrEqual, dim, why);
}

/// States a condition, unless it contains no parameter.
fn state(work: &mut impl Valuer, range: Range, [lhs, rhs]: [Expr; 2], relation: Relation, dim: Dim, why: &str) {
    if !work.arena().leaves(lhs).is_empty() {
        let joint = SEGMENTS.to_owned();
        work.require(range, Requirement { lhs, relation, rhs, dim, joint, why: why.to_owned() });
    }
}

/// The height at x.
fn expression(work: &mut impl Valuer, program: &Program, scope: &Scope) -> Option<Expr> {
    let [end, last] = program.end();
    let x = if program.is_periodic { wrapped(work, program.x.expr, end, program.is_turn()) } else { program.x.expr };
    let mut pieces = Vec::new();
    for (index, segment) in program.segments.iter().enumerate() {
        let (begin, before) = (program.times[index], program.heights[index]);
        let (Some((height, _)), Some(of)) = (segment.height, segment.law) else {
            pieces.push((begin, before));
            continue;
        };
        let arena = work.arena();
        let since = arena.sub(x, begin);
        let u = arena.div(since, segment.duration);
        let value = law(work, of, u, scope)?;
        let rise = work.arena().mul(height, value);
        pieces.push((begin, work.arena().add(before, rise)));
    }
    if !program.is_periodic {
        pieces.insert(0, (program.times[0], program.heights[0]));
        pieces.push((end, last));
    }
    Some(piecewise(work, x, &pieces))
}
