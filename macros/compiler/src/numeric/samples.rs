//! Configurations that satisfy all equations of a mechanism, redundant ones included.
//!
//! In: [`Subsystem`]s. Out: an assembly at t = 0, and a [`Samples`] of further poses: along the motion of the drives or, if nothing is
//! driven, after perturbations. Not done here: drawing conclusions.

use super::Numeric;
use super::least_squares::minimise;
use super::search::{GUESSES, guess};
use crate::expr::{Expr, Values, evaluate};
use crate::quantity::Dim;
use crate::structure::SMALL;
use crate::structure::Subsystem;
use crate::system::Equation;

/// Distances of the poses from the start, as travel of the fastest drive, in rad or characteristic lengths: stepwise to either side, about
/// half a turn.
const WAYS: [f64; 6] = [0.05, 0.35, 0.8, 1.4, 2.2, 3.0];

/// Parts of the first distance that are tried in turn where the range of the mechanism ends before it.
const PARTS: &[f64] = &[1.0, 1.0 / 8.0, 1.0 / 64.0];

/// After a contradiction, only parts of at least this size are tried: on shorter ones a contradiction that grows with the square of the way does not
/// show.
const SHOWING: f64 = 0.1;

/// Number of distances used for a large system.
const FEW: usize = 3;

/// Time for a distance of 1 if no drive moves at t = 0, in s.
const WITHOUT_RATE: f64 = 0.3;

/// Largest perturbations, in rad or characteristic lengths. Short ones fail where two branches meet.
const PUSHES: [f64; 6] = [0.2, 0.3, 0.5, 0.7, 1.0, 1.4];

/// Number of guesses from which the least-squares residual of contradictory equations is minimised.
const TRIES: usize = 12;

/// Sum of squares, in scaled unknowns, below which overdetermined equations hold: each subsystem inherits the rounding errors of those
/// before it, and with more equations than unknowns no unknown can absorb them.
const ROUNDED: f64 = 1e-14;

/// A pose closer to the start than this is the start.
const SAME: f64 = 1e-3;

/// Number of configurations at which identities are tested.
pub(crate) const LOOKS: usize = 3;

/// Poses at the declared parameters.
pub(crate) struct Samples {
    /// The poses; the first is the start.
    pub(crate) poses: Vec<Pose>,
    /// True if some pose differs from the start.
    pub(crate) moves: bool,
    /// True if all equations can keep holding while the drives move, forwards or backwards.
    pub(crate) holds: bool,
}

/// Time in s, and q.
#[derive(Clone, PartialEq)]
pub(crate) struct Pose {
    pub(crate) time: f64,
    pub(crate) q: Vec<f64>,
}

impl Numeric<'_> {
    /// Arbitrary, unrelated values of all coordinates.
    pub(crate) fn anywhere(&self, look: usize) -> Vec<f64> {
        let share = |unknown: usize| 2.0 * ((unknown * LOOKS + look + 1) as f64 * 0.618_033_988_749_895).fract();
        (0..self.system.coordinates.len()).map(|unknown| share(unknown) * self.scale(unknown)).collect()
    }

    /// An assembly at t = 0 without the equations left out, subsystem by subsystem; true if it closes.
    pub(crate) fn assembled_in_order(&self, subsystems: &[Subsystem], leaves_out: impl Fn(usize) -> bool) -> (Vec<f64>, bool) {
        let mut q: Vec<f64> = self.declared.iter().map(|value| value.unwrap_or(0.0)).collect();
        let mut is_closed = true;
        for subsystem in subsystems {
            let equations: Vec<usize> = subsystem.equations.iter().copied().filter(|equation| !leaves_out(*equation)).collect();
            let mut problem = self.problem(&equations, subsystem.unknowns.clone(), q);
            if subsystem.is_overdetermined {
                problem.closed = ROUNDED;
            }
            let is_open = subsystem.unknowns.iter().any(|unknown| self.declared[*unknown].is_none());
            let found = self.search(&mut problem, if is_open { GUESSES } else { 1 });
            let (closed, nearest) = (!found.assemblies.is_empty(), found.assemblies.into_iter().next().unwrap_or(found.first));
            q = problem.coordinates;
            subsystem.unknowns.iter().zip(nearest).for_each(|(unknown, value)| q[*unknown] = value);
            is_closed &= closed;
        }
        (q, is_closed)
    }

    /// The assembly at t = 0 of all overdetermined subsystems, from guesses of all their coordinates; true if one closes each of them.
    pub(crate) fn assembled_widely(&self, subsystems: &[Subsystem], mut q: Vec<f64>) -> (Vec<f64>, bool) {
        for subsystem in subsystems.iter().filter(|subsystem| subsystem.is_overdetermined) {
            let mut problem = self.problem(&subsystem.equations, subsystem.unknowns.clone(), q.clone());
            problem.closed = ROUNDED;
            let Some(nearest) = self.search_widely(&mut problem, GUESSES).into_iter().next() else { return (q, false) };
            subsystem.unknowns.iter().zip(nearest).for_each(|(unknown, value)| q[*unknown] = value);
        }
        (q, true)
    }

    /// Best of several local minima of the residual of the overdetermined subsystems at t = 0; all other coordinates as in `q`.
    pub(crate) fn least_open(&self, subsystems: &[Subsystem], mut q: Vec<f64>) -> Vec<f64> {
        for subsystem in subsystems.iter().filter(|subsystem| subsystem.is_overdetermined) {
            let mut best: Option<(f64, Vec<f64>)> = None;
            for attempt in 0..TRIES {
                let guess = |unknown: &usize| guess(attempt, *unknown) * self.reach(*unknown);
                let mut own: Vec<f64> =
                    subsystem.unknowns.iter().map(|unknown| self.declared[*unknown].unwrap_or_else(|| guess(unknown))).collect();
                let mut problem = self.problem(&subsystem.equations, subsystem.unknowns.clone(), q.clone());
                let everything = vec![true; own.len()];
                minimise(&mut problem, &mut own, &everything);
                let mut there = q.clone();
                subsystem.unknowns.iter().zip(own).for_each(|(unknown, value)| there[*unknown] = value);
                let open = self.open(&subsystem.equations, &there);
                if best.as_ref().is_none_or(|(least, _)| open < *least) {
                    best = Some((open, there));
                }
            }
            q = best.map_or(q, |(_, there)| there);
        }
        q
    }

    /// Residual of some equations: sum of squares, in rad and characteristic lengths.
    fn open(&self, equations: &[usize], q: &[f64]) -> f64 {
        let rows = equations.iter().map(|equation| &self.system.equations[*equation]);
        let (dims, roots): (Vec<Dim>, Vec<Expr>) = rows.filter_map(|row| Some((row.dim, row.phi()?))).unzip();
        let values = evaluate(&self.system.arena, &roots, &Values { coordinates: q, ..self.known });
        let share = |(value, dim): (&f64, &Dim)| match *dim {
            Dim::ANGLE => *value,
            Dim::LENGTH => value / self.size,
            _ => value / (self.size * self.size),
        };
        values.iter().zip(&dims).map(share).filter(|share| share.is_finite()).map(|share| share * share).sum()
    }

    /// The assembly near `q` at a time, without the equations left out; `None` if the solution fails.
    pub(crate) fn settled(
        &self,
        subsystems: &[Subsystem],
        time: f64,
        mut q: Vec<f64>,
        leaves_out: impl Fn(usize) -> bool,
    ) -> Option<Vec<f64>> {
        for subsystem in subsystems {
            let equations: Vec<usize> = subsystem.equations.iter().copied().filter(|equation| !leaves_out(*equation)).collect();
            let mut own: Vec<f64> = subsystem.unknowns.iter().map(|unknown| q[*unknown]).collect();
            let mut problem = self.problem(&equations, subsystem.unknowns.clone(), q);
            problem.known.time = time;
            if subsystem.is_overdetermined {
                problem.closed = ROUNDED;
            }
            let everything = vec![true; own.len()];
            if !minimise(&mut problem, &mut own, &everything) {
                return None;
            }
            q = problem.coordinates;
            subsystem.unknowns.iter().zip(own).for_each(|(unknown, value)| q[*unknown] = value);
        }
        Some(q)
    }

    /// Poses that the mechanism can reach from an assembly.
    pub(crate) fn samples(&self, subsystems: &[Subsystem], start: &[f64], leaves_out: impl Fn(usize) -> bool) -> Samples {
        let begin = Pose { time: 0.0, q: start.to_vec() };
        let mut samples = Samples { poses: vec![begin.clone()], moves: false, holds: true };
        let zero = |expr: Expr| self.system.arena.as_constant(expr).is_some_and(|value| value.is_zero());
        // A freedom holds its value at t = 0 only: nothing leads it anywhere, and it is left out.
        let rests = |equation: &Equation| equation.is_initial || zero(equation.nu);
        if subsystems.iter().flat_map(|subsystem| &subsystem.equations).all(|equation| rests(&self.system.equations[*equation])) {
            self.push(subsystems, &mut samples, |equation| leaves_out(equation) || self.system.equations[equation].is_initial);
            return samples;
        }
        let pace = self.pace(subsystems, start);
        let unit = if pace > 0.0 { 1.0 / pace } else { WITHOUT_RATE };
        let ways = if self.system.coordinates.len() > SMALL { &WAYS[..FEW] } else { &WAYS[..] };
        let is_marked = |equation: &usize| self.model.joints[self.system.equations[*equation].joint].is_redundant;
        let has_marked = subsystems.iter().flat_map(|subsystem| &subsystem.equations).any(is_marked);
        // The pose at a time; an error if the equations contradict each other there, which those without redundant joints do not.
        let at = |time: f64, from: &Pose| match self.settled(subsystems, time, from.q.clone(), &leaves_out) {
            Some(q) => Ok(Some(Pose { time, q })),
            None if !has_marked => Err(()),
            None => {
                let without = |equation: usize| leaves_out(equation) || is_marked(&equation);
                if self.settled(subsystems, time, from.q.clone(), without).is_some() { Err(()) } else { Ok(None) }
            }
        };
        let (mut is_contradiction, mut is_led) = (false, false);
        for side in [1.0, -1.0] {
            let mut here = begin.clone();
            for (number, way) in ways.iter().enumerate() {
                // A mechanism may reach the end of its range, on one side as soon as it starts.
                let parts = if number == 0 { PARTS } else { &PARTS[..1] };
                let mut contradicts = false;
                let found = parts.iter().find_map(|part| {
                    if contradicts && *part < SHOWING {
                        return None;
                    }
                    let found = at(side * way * part * unit, &here);
                    contradicts |= found.is_err();
                    found.ok().flatten()
                });
                // Equations that hold for a shorter way do not contradict each other: the travel ends before the longer one.
                is_contradiction |= number == 0 && contradicts && found.is_none();
                let Some(pose) = found else { break };
                self.add(&mut samples, pose.clone());
                is_led = true;
                here = pose;
            }
        }
        samples.holds = is_led && !is_contradiction;
        samples
    }

    /// Poses reached from an assembly by perturbation at t = 0.
    pub(crate) fn pushed(&self, subsystems: &[Subsystem], start: Vec<f64>, leaves_out: impl Fn(usize) -> bool) -> Vec<Pose> {
        let mut samples = Samples { poses: vec![Pose { time: 0.0, q: start }], moves: false, holds: true };
        self.push(subsystems, &mut samples, leaves_out);
        samples.poses
    }

    /// Perturbs all coordinates in several directions, and adds the assemblies found nearby.
    fn push(&self, subsystems: &[Subsystem], samples: &mut Samples, leaves_out: impl Fn(usize) -> bool) {
        let start = samples.poses[0].q.clone();
        for (attempt, push) in PUSHES.into_iter().enumerate() {
            let mut q = start.clone();
            for (unknown, value) in q.iter_mut().enumerate() {
                *value += (guess(attempt + 1, unknown) / core::f64::consts::PI) * push * self.scale(unknown);
            }
            if let Some(q) = self.settled(subsystems, 0.0, q, &leaves_out) {
                self.add(samples, Pose { time: 0.0, q });
            }
        }
    }

    /// Adds a pose unless it is the start.
    fn add(&self, samples: &mut Samples, pose: Pose) {
        let way = |unknown: usize| (pose.q[unknown] - samples.poses[0].q[unknown]).abs() / self.scale(unknown);
        if (0..pose.q.len()).any(|unknown| way(unknown) > SAME) {
            samples.poses.push(pose);
            samples.moves = true;
        }
    }

    /// Largest rate at the start that a drive imposes on a coordinate, in rad/s or characteristic lengths per second.
    fn pace(&self, subsystems: &[Subsystem], start: &[f64]) -> f64 {
        let pace = |equation: &usize| {
            let equation = &self.system.equations[*equation];
            let roots: Vec<Expr> = equation.jacobian.iter().map(|(_, entry)| *entry).chain([equation.nu]).collect();
            let values = evaluate(&self.system.arena, &roots, &Values { coordinates: start, ..self.known });
            let (nu, entries) = values.split_last()?;
            let scaled = entries.iter().zip(&equation.jacobian).map(|(entry, (unknown, _))| entry.abs() * self.scale(*unknown));
            let rate = nu.abs() / scaled.fold(0.0, f64::max);
            rate.is_finite().then_some(rate)
        };
        subsystems.iter().flat_map(|subsystem| &subsystem.equations).filter_map(pace).fold(0.0, f64::max)
    }
}
