//! From the declared start to the initial values of freedoms and to other parameters than the declared ones.
//!
//! The branch of the declared start is followed along λ ↦ defaults + λ (parameters − defaults), as in kinematics: from each place to the next one by
//! the tangent and Newton's method. If the branch ends on the way, an assembly with the same sign of det J is taken, or none. Defaults that do not
//! close are placeholders: then the residuals at the declared start are taken away in parts, and where they cannot be, at once.

use nalgebra::SVector;

use super::accelerate::{lengths, redundant, singular};
use super::checks::{holds, unit_of};
use super::equations::{Constraints, Dynamics};
use super::partition::{Partition, Pivots, weakest};
use super::places::{largest_change, moved, picked, put};
use super::project::{Open, Reached, gap, levels, project_onto, refresh};
use super::rank::is_sharp_at;
use super::stopped::Stopped;
use crate::linear;
use crate::number::Scalar;
use crate::number::order::smaller;
use crate::state::State;

/// Largest change of a coordinate while one part of the residuals is taken away, in rad or lengths.
const FAR: f64 = 0.25;

/// Largest deviation of a step from its tangent: of an angle, in rad; of a length, relative to its change and L.
const BESIDE: f64 = 0.05;

/// Longest turn in a step along the tangent, in rad. Lengths may change by any amount.
const LONGEST: f64 = 1.0;

/// An assembly beyond the end of a branch is taken if no coordinate is farther from the guess than this, in rad or lengths.
const TURNED: f64 = core::f64::consts::PI;

/// A row that is the same at a place so far from another, in rad or lengths, does not depend on the place.
const ASIDE: f64 = 0.37;

/// Most steps, taken or not.
const MOST: usize = 50_000;

/// Shortest part of the way in which residuals are taken away.
const SHORTEST: f64 = 1.0 / 4096.0;

/// Shortest step along the tangent, as a fraction of the way.
const SHORTEST_STEP: f64 = 1e-9;

/// A branch ends where the part of a row that is independent of the others falls below this fraction of it.
const NEARLY_DEPENDENT: f64 = 0.01;

/// The state at t = 0, at the initial values of the freedoms.
pub fn initial_state<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    mechanism.validate().map_err(Stopped::ParameterOutOfRange)?;
    let zero = SVector::from_element(T::ZERO);
    let (mut q, mut qd) = (mechanism.start(), zero);
    assemble(mechanism, (&mut q, &mut qd)).map_err(|open| match open {
        Open::Dependent(row) => singular::<T, S, N, I, M, R>(T::ZERO, row),
        Open::After(row, share) => Stopped::AssemblyEnds { share, joint: S::JOINTS.get(row).copied().unwrap_or_default() },
        Open::Residual(row, residual) => {
            let joint = S::JOINTS.get(row).copied().unwrap_or_default();
            Stopped::NotAssembled { joint, residual, unit: unit_of::<T, S, N>(joint) }
        }
    })?;
    holds::<T, S, N, I, M, R>(mechanism, &q, T::ZERO)?;
    let mut state = State::new(T::ZERO, q, qd, zero);
    is_sharp_at(mechanism, &state.q, T::ZERO)?;
    refresh(mechanism, &mut state)?;
    Ok(state)
}

/// Moves a place from the declared start to the initial values and the parameters, and sets its speeds.
fn assemble<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&mut SVector<T, N>, &mut SVector<T, N>),
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if let Some(defaults) = mechanism.interpolated(T::ZERO) {
        let (mut origin, mut speeds) = (*q, *qd);
        let closes = close(&defaults, None, (&mut origin, &mut speeds)).is_ok();
        if closes && largest_change([&*q, &origin], &S::INTEGRATED, &lengths(mechanism)) <= T::of(FAR) {
            return follow(mechanism, &origin, (q, qd));
        }
    }
    let declared = *q;
    if in_parts(mechanism, (q, qd)) {
        return Ok(());
    }
    *q = declared;
    close(mechanism, None, (q, qd)).map(|_| ())
}

/// Moves a place until all equations at t = 0 hold, and sets its speeds. Returns an order of the elimination of J there.
fn close<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    known: Option<&Pivots<T, R, I>>,
    place: (&mut SVector<T, N>, &mut SVector<T, N>),
) -> Result<Pivots<T, R, I>, Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut reached = Reached::empty();
    close_but_for(mechanism, (T::ZERO, None), known, place, &mut reached)?;
    Ok(reached.pivots)
}

/// The same at any time, but for given departures: Φ and J u − ν keep these values.
#[inline(never)]
pub(super) fn close_but_for<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (t, departures): (T, Option<&[SVector<T, R>; 2]>),
    known: Option<&Pivots<T, R, I>>,
    place: (&mut SVector<T, N>, &mut SVector<T, N>),
    reached: &mut Reached<T, R, I>,
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let equations = |q: &SVector<T, N>, found: &mut Constraints<T, R, I>| {
        mechanism.initial(q, t, found);
        if let Some([open, faster]) = departures {
            found.phi = linear::moved(&found.phi, T::of(-1.0), open);
            found.nu = linear::moved(&found.nu, T::of(1.0), faster);
        }
    };
    project_onto(mechanism, known, place, equations, reached)
}

/// Follows the branch from a place at the defaults.
///
/// * `q`: given, the declared start; returned, the place at the parameters.
fn follow<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    origin: &SVector<T, N>,
    (q, qd): (&mut SVector<T, N>, &mut SVector<T, N>),
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let one = T::of(1.0);
    let (lengths, start) = (lengths(mechanism), *q);
    let side = mechanism.interpolated(T::ZERO).and_then(|defaults| side_of(&defaults, origin));
    let (mut here, mut slope, mut reached, mut step) = (*origin, [T::ZERO; I], T::ZERO, one);
    // Redundant joints need not close on the way: the same rows stay solved as long as their pivots are good.
    let mut rows = None;
    for _ in 0..MOST {
        let next = smaller(reached + step, one);
        let by = next - reached;
        let between = if next < one { mechanism.interpolated(next) } else { None };
        let at = between.as_ref().unwrap_or(mechanism);
        let before = picked(&here, &S::INTEGRATED);
        let predicted = moved(&before, by, &slope);
        let (mut place, mut speeds) = (here, *qd);
        put(&mut place, &S::INTEGRATED, &predicted);
        let known = rows.as_ref().filter(|_| S::REDUNDANT > 0);
        let found = close(at, known, (&mut place, &mut speeds));
        let after = picked(&place, &S::INTEGRATED);
        let is_short = is_short([&before, &predicted, &after], &lengths, &S::IS_LENGTH);
        if let (Ok(pivots), true, true) = (found, is_short, side_of(at, &place) == side) {
            rows = Some(pivots);
            slope = moved(&after, -one, &before);
            slope.iter_mut().for_each(|change| *change = *change / by);
            (here, reached, step) = (place, next, step + step);
            if next == one {
                (*q, *qd) = (place, speeds);
                return Ok(());
            }
        } else {
            step = T::of(0.5) * by;
        }
        if step < T::of(SHORTEST_STEP) {
            break;
        }
    }
    let mut accepts = |place: SVector<T, N>, speeds: SVector<T, N>| {
        let is_same = side.is_some() && side_of(mechanism, &place) == side;
        if is_same {
            (*q, *qd) = (place, speeds);
        }
        is_same
    };
    for guess in [here, start] {
        let (mut place, mut speeds) = (guess, SVector::from_element(T::ZERO));
        let found = close(mechanism, None, (&mut place, &mut speeds));
        if found.is_ok() && largest_change([&guess, &place], &S::INTEGRATED, &lengths) <= T::of(TURNED) && accepts(place, speeds) {
            return Ok(());
        }
    }
    let (mut place, mut speeds) = (start, SVector::from_element(T::ZERO));
    if in_parts(mechanism, (&mut place, &mut speeds)) && accepts(place, speeds) {
        return Ok(());
    }
    let (row, left) = weakest_at(mechanism, reached, &here);
    if left < T::of(NEARLY_DEPENDENT) {
        return Err(Open::After(row, reached));
    }
    let [of_positions, _] = levels(&S::LEVELS);
    let (row, residual) = gap(&initial_at(mechanism, &here), &of_positions);
    Err(Open::Residual(row, residual))
}

/// True if a step along the tangent is short, and ends near the place that was predicted.
fn is_short<T: Scalar, const I: usize>([before, predicted, after]: [&[T; I]; 3], lengths: &[T; I], are_lengths: &[bool; I]) -> bool {
    (0..I).all(|k| {
        let way = ((after[k] - before[k]) / lengths[k]).abs();
        let beside = ((after[k] - predicted[k]) / lengths[k]).abs();
        if are_lengths[k] { beside <= T::of(BESIDE) * (way + T::of(1.0)) } else { way <= T::of(LONGEST) && beside <= T::of(BESIDE) }
    })
}

/// Φ, J and ν of all equations at t = 0.
fn initial_at<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    q: &SVector<T, N>,
) -> Constraints<T, R, I>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut found = Constraints::zero();
    mechanism.initial(q, T::ZERO, &mut found);
    found
}

/// The row that depends most on the others at λ on the way, and the fraction of it that is independent.
fn weakest_at<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    lambda: T,
    q: &SVector<T, N>,
) -> (usize, T)
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let [of_positions, _] = levels(&S::LEVELS);
    let between = mechanism.interpolated(lambda);
    let rows = initial_at(between.as_ref().unwrap_or(mechanism), q).jacobian;
    weakest(&rows, &rows, &lengths(mechanism), &of_positions, &redundant(mechanism))
}

/// The sign of det J, which is opposite for two assemblies that meet at the end of a branch; `None` if joints are redundant, or J is not regular.
/// Constant coefficients that determine one coordinate alone, such as ratios and leads, have no share in it: no two assemblies meet where they change
/// their sign.
fn side_of<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S, q: &SVector<T, N>) -> Option<bool>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let [of_positions, _] = levels(&S::LEVELS);
    let jacobian = initial_at(mechanism, q).jacobian;
    let (mut parts, none) = (Partition::empty(), SVector::from_element(T::ZERO));
    let lengths = lengths(mechanism);
    let found = parts.pivot((&jacobian, &none), &lengths, &of_positions, &redundant(mechanism));
    let sign = found.ok().filter(|()| S::REDUNDANT == 0).and_then(|()| parts.pivots.sign())?;
    let mut beside = *q;
    put(&mut beside, &S::INTEGRATED, &moved(&picked(q, &S::INTEGRATED), T::of(ASIDE), &lengths));
    let elsewhere = initial_at(mechanism, &beside).jacobian;
    let is_negative = |row: usize| {
        let (mut entries, mut is_constant, mut last) = (0, true, T::ZERO);
        for (column, other) in jacobian.data.0.iter().zip(&elsewhere.data.0) {
            let (Some(&entry), Some(&there)) = (column.get(row), other.get(row)) else { continue };
            is_constant &= entry == there;
            if entry != T::ZERO {
                (entries, last) = (entries + 1, entry);
            }
        }
        of_positions.get(row) == Some(&true) && is_constant && entries == 1 && last < T::ZERO
    };
    Some((0..R).fold(sign, |sign, row| sign ^ is_negative(row)))
}

/// Takes the residuals at the declared start away in parts; true if that succeeds.
fn in_parts<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&mut SVector<T, N>, &mut SVector<T, N>),
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let open = initial_at(mechanism, q).phi;
    let (mut done, mut part, mut reached) = (T::ZERO, T::of(1.0), Reached::empty());
    while done < T::of(1.0) && part >= T::of(SHORTEST) {
        let next = smaller(done + part, T::of(1.0));
        let (mut place, mut speeds) = (*q, *qd);
        // The rest of the residuals at the declared start is left open.
        let left = [linear::scaled(&open, T::of(1.0) - next), SVector::from_element(T::ZERO)];
        let found = close_but_for(mechanism, (T::ZERO, Some(&left)), None, (&mut place, &mut speeds), &mut reached);
        if found.is_ok() && largest_change([&*q, &place], &S::INTEGRATED, &lengths) <= T::of(FAR) {
            (*q, *qd, done, part) = (place, speeds, next, part * T::of(2.0));
        } else {
            part = part * T::of(0.5);
        }
    }
    done == T::of(1.0)
}
