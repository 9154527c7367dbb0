//! Items that shorten generated code: names for vectors, constructors for tables of one line per entry, and checks of parameters.

use core::cell::Cell;
use core::ops::{Bound, RangeBounds};

use nalgebra::{SMatrix, SVector};

use crate::names::{Coordinate, CoordinateEntries, CoordinateKind, Operations, ParameterOutOfRange, Row};
use crate::number::{Real, Scalar};
use crate::solve::Family;

/// A column of `N` numbers.
pub type Vector<T, const N: usize> = SVector<T, N>;

/// A matrix of `M` rows and `N` columns.
pub type Matrix<T, const M: usize, const N: usize> = SMatrix<T, M, N>;

impl Coordinate {
    /// A coordinate of a body in m.
    #[must_use]
    pub const fn length(body: &'static str, name: &'static str) -> Self {
        Self { body, name, kind: CoordinateKind::Length, entries: CoordinateEntries::Motion }
    }

    /// A coordinate of a body in rad.
    #[must_use]
    pub const fn angle(body: &'static str, name: &'static str) -> Self {
        Self { body, name, kind: CoordinateKind::Angle, entries: CoordinateEntries::Motion }
    }

    /// A dimensionless coordinate of a body.
    #[must_use]
    pub const fn number(body: &'static str, name: &'static str) -> Self {
        Self { body, name, kind: CoordinateKind::Number, entries: CoordinateEntries::Motion }
    }

    /// A component of an output of velocities.
    #[must_use]
    pub const fn velocity(output: &'static str, component: &'static str) -> Self {
        Self { entries: CoordinateEntries::Velocity, ..Self::length(output, component) }
    }

    /// The third derivative of a component of an output.
    #[must_use]
    pub const fn jerk(output: &'static str, component: &'static str) -> Self {
        Self { entries: CoordinateEntries::Jerk, ..Self::length(output, component) }
    }
}

impl Row {
    /// Row `index`, counted from 1, of the `of` rows of a joint; the residual has this unit.
    #[must_use]
    pub const fn new(joint: &'static str, kind: &'static str, index: usize, of: usize, unit: &'static str) -> Self {
        Self { joint, kind, index, of, unit }
    }
}

impl Operations {
    /// Numbers of sums and products, divisions and roots, sine-cosine pairs, and calls of other functions.
    #[must_use]
    pub const fn new(flops: usize, divisions: usize, sines: usize, calls: usize) -> Self {
        Self { flops, divisions, sines, calls }
    }
}

/// A mechanism whose parameters are interpolated between the defaults (λ = 0) and these (λ = 1); None if they are the defaults. With λ from 0 to −1
/// parameters that change their sign become infinite on the way instead of zero: their reciprocals are interpolated; None if there are none.
#[doc(hidden)]
pub fn between<T: Real, M: Family<T, Over<T> = M> + PartialEq>(defaults: &M, mechanism: &M, lambda: T) -> Option<M> {
    let is_negative = |number: T| T::is_less(number, T::of(0.0)) == Some(true);
    let (share, is_around, is_turned) = (lambda.abs(), is_negative(lambda), Cell::new(false));
    let way = |[from, to]: [T; 2]| {
        if !(is_around && is_negative(from * to)) {
            return from + share * (to - from);
        }
        is_turned.set(true);
        from * to / (to + share * (from - to))
    };
    let found = (mechanism != defaults).then(|| M::gather([defaults, mechanism], way));
    found.filter(|_| is_turned.get() || !is_around)
}

/// Magnitude of the parameter by which the derivatives with this number are taken; 1 if it is 0.
#[doc(hidden)]
pub fn parameter_size<T: Scalar, M: Family<T, Over<T> = M>>(mechanism: &M, number: usize) -> T {
    let size = Cell::new(T::ZERO);
    M::gather([mechanism], |[parameter]| {
        if parameter.derivative(number).is_some_and(|by| by != T::ZERO) {
            size.set(size.get().max(parameter.without_derivatives().abs()));
        }
        parameter
    });
    if size.get() > T::ZERO { size.get() } else { T::of(1.0) }
}

/// The mechanism with the parameter by which the derivatives with this number are taken changed by `change`.
#[doc(hidden)]
pub fn varied<T: Scalar, M: Family<T, Over<T> = M>>(mechanism: &M, number: usize, change: T) -> M {
    M::gather([mechanism], |[parameter]| parameter + change * parameter.derivative(number).unwrap_or(T::ZERO))
}

/// A parameter by name, value and unit.
#[doc(hidden)]
pub type Named<T> = (&'static str, T, &'static str);

/// Every parameter is finite: x − x is 0 for every finite x and NaN for all others, over any number type.
///
/// # Errors
/// The first parameter that is not finite.
#[doc(hidden)]
#[allow(clippy::eq_op)] // Only finite numbers leave nothing when subtracted from themselves.
pub fn finite<T: Real>(parameters: &[Named<T>]) -> Result<(), ParameterOutOfRange<T>> {
    first(parameters, |value| value - value != T::of(0.0), "it must be finite")
}

/// Every parameter lies within these bounds.
///
/// # Errors
/// The first parameter out of bounds.
#[doc(hidden)]
pub fn within<T: Real>(bounds: impl RangeBounds<f64>, why: &'static str, parameters: &[Named<T>]) -> Result<(), ParameterOutOfRange<T>> {
    let is_below = |value: T| match bounds.start_bound() {
        Bound::Included(&from) | Bound::Excluded(&from) => less(value, T::of(from)) == T::of(1.0),
        Bound::Unbounded => false,
    };
    let is_above = |value: T| match bounds.end_bound() {
        Bound::Included(&to) => less(T::of(to), value) == T::of(1.0),
        Bound::Excluded(&to) => less(value, T::of(to)) == T::of(0.0),
        Bound::Unbounded => false,
    };
    first(parameters, |value| is_below(value) || is_above(value), why)
}

/// The first parameter that is refused, as an error.
fn first<T: Real>(parameters: &[Named<T>], is_refused: impl Fn(T) -> bool, why: &'static str) -> Result<(), ParameterOutOfRange<T>> {
    match parameters.iter().find(|(_, value, _)| is_refused(*value)) {
        Some(&(name, value, unit)) => Err(ParameterOutOfRange { name, value, unit, why }),
        None => Ok(()),
    }
}

/// Relation between two numbers.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    Different,
}

/// Checks a relation that a joint requires; numbers that cannot be compared violate it.
///
/// # Errors
/// The parameter to blame.
#[doc(hidden)]
pub fn require<T: Real>(
    lhs: T,
    relation: Relation,
    rhs: T,
    (name, value, unit): Named<T>,
    why: &'static str,
) -> Result<(), ParameterOutOfRange<T>> {
    let (zero, is_less, is_greater) = (T::of(0.0), less(lhs, rhs), less(rhs, lhs));
    let fails = match relation {
        Relation::Less => is_less == zero,
        Relation::LessOrEqual => is_less == zero && lhs != rhs,
        Relation::Greater => is_greater == zero,
        Relation::GreaterOrEqual => is_greater == zero && lhs != rhs,
        Relation::Equal => lhs != rhs,
        Relation::Different => is_less + is_greater == zero,
    };
    if fails { Err(ParameterOutOfRange { name, value, unit, why }) } else { Ok(()) }
}

/// 1 where `lhs < rhs`, else 0: not every number type has comparison operators.
fn less<T: Real>(lhs: T, rhs: T) -> T {
    T::select_less(lhs, rhs, T::of(1.0), T::of(0.0))
}
