//! The followed blocks, solved in order along a path.
//!
//! In: a [`Structure`]. Out: a [`Chain`], which computes the coordinates of each block and their rates along the path from those of the
//! blocks before it. Not done here: step control.

use crate::assembly::order::Upstream;
use crate::expr::{Evaluator, Expr};
use crate::expr::{Values, evaluate};
use crate::linear::dense::Factors;
use crate::numeric::Numeric;
use crate::structure::Structure;
use std::borrow::Cow;

/// Largest number of Newton iterations; three suffice from an acceptable prediction.
const MOST_ITERATIONS: usize = 12;

/// Corrections below this fraction of a coordinate are rounding.
const ROUNDING: f64 = 1e-14;

/// Path along which the mechanism is followed: time, or a change of parameters.
pub(super) struct MotionPath {
    /// 1 forwards in time, −1 backwards, 0 if parameters change.
    pub(super) sign: f64,
    /// Parameters at s = 0.
    pub(super) from: Vec<f64>,
    /// Parameters at s = 1, if they change.
    pub(super) to: Option<Vec<f64>>,
}

impl MotionPath {
    fn parameters(&self, at: f64) -> Cow<'_, [f64]> {
        let Some(to) = &self.to else { return Cow::Borrowed(&self.from) };
        let between = |(from, to): (&f64, &f64)| if from == to { *from } else { from + at * (to - from) };
        Cow::Owned(self.from.iter().zip(to).map(between).collect())
    }
}

/// A followed block.
pub(super) struct Member {
    /// Index of the block in the structure.
    pub(super) block: usize,
    pub(super) unknowns: Vec<usize>,
    pub(super) is_iterated: bool,
    /// Evaluates Φ, Φ_q of its own unknowns, Φ_q of others, and ν.
    evaluator: Evaluator,
    values: Vec<f64>,
    /// Row and column of the entries of its own unknowns.
    own: Vec<(usize, usize)>,
    /// Row and unknown of all other entries.
    others: Vec<(usize, usize)>,
    /// Scale of each unknown, in m or rad.
    pub(super) scales: Vec<f64>,
    /// Scale of each row, in scaled unknowns.
    sizes: Vec<f64>,
}

/// Equations of a block, linearised at a configuration, in scaled unknowns.
pub(super) struct LinearizedMember {
    pub(super) phi: Vec<f64>,
    pub(super) jacobian: Vec<Vec<f64>>,
    /// dΦ/ds along the path while the block's own unknowns are fixed.
    pub(super) drift: Vec<f64>,
}

/// A configuration on the path.
#[derive(Clone, Debug)]
pub(super) struct PathPose {
    /// Path parameter s: a time in s, or a fraction of the change of parameters.
    pub(super) at: f64,
    pub(super) q: Vec<f64>,
    /// dq/ds along the path.
    pub(super) rates: Vec<f64>,
    /// For each member, the sign of its determinant and ln |det|.
    pub(super) sides: Vec<(f64, f64)>,
}

/// Result of solving a block.
pub(super) struct Settled {
    /// First Newton correction, in scaled unknowns.
    pub(super) correction: f64,
    pub(super) sign: f64,
    pub(super) size: f64,
}

/// Reason why a block was not solved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stop {
    /// This member has no solution near the prediction.
    Member(usize),
    /// The operations allowed are spent.
    Spent,
}

pub(super) struct Chain<'a> {
    pub(super) numeric: &'a Numeric<'a>,
    pub(super) members: Vec<Member>,
    pub(super) path: MotionPath,
    upstream: Upstream,
    /// Member of each block, if it is followed.
    place: Vec<Option<usize>>,
    /// Number of operations left.
    pub(super) left: u64,
}

impl<'a> Chain<'a> {
    /// Selects the iterated blocks that are evaluable and all blocks upstream of them; `None` if nothing iterated moves.
    pub(super) fn new(numeric: &'a Numeric<'a>, structure: &Structure, q: &[f64], path: MotionPath, left: u64) -> Option<Chain<'a>> {
        let upstream = Upstream::new(numeric, structure);
        let is_sure = upstream.surety(numeric, structure);
        let mut is_needed = vec![false; structure.blocks.len()];
        for (index, block) in structure.blocks.iter().enumerate().rev() {
            is_needed[index] |= !block.iterated.is_empty() && is_sure[index];
            if is_needed[index] {
                upstream.direct(index).for_each(|other| is_needed[other] = true);
            }
        }
        let length = length(numeric, q);
        let mut moves = vec![false; structure.blocks.len()];
        let place = vec![None; structure.blocks.len()];
        let mut chain = Chain { numeric, members: Vec::new(), path, upstream, place, left };
        for index in 0..structure.blocks.len() {
            let (unknowns, equations) = structure.blocks[index].parts();
            moves[index] =
                equations.iter().any(|equation| chain.changes(*equation)) || chain.upstream.direct(index).any(|other| moves[other]);
            if !is_needed[index] || !moves[index] {
                continue;
            }
            chain.place[index] = Some(chain.members.len());
            let is_iterated = !structure.blocks[index].iterated.is_empty();
            chain.members.push(Member::new(numeric, (unknowns, equations), (index, is_iterated), length));
        }
        chain.members.iter().any(|member| member.is_iterated).then_some(chain)
    }

    /// Members on which a member depends, in order.
    pub(super) fn before(&self, member: usize) -> Vec<usize> {
        self.upstream.all(self.members[member].block).into_iter().filter_map(|other| self.place[other]).collect()
    }

    /// True if an equation may depend explicitly on the path parameter.
    fn changes(&self, equation: usize) -> bool {
        let equation = &self.numeric.system.equations[equation];
        if self.path.to.is_some() {
            return true;
        }
        !self.numeric.system.arena.as_constant(equation.nu).is_some_and(|value| value.is_zero())
    }

    /// Equations of a member at a configuration in which the blocks before it are solved.
    pub(super) fn local(&mut self, index: usize, at: f64, q: &[f64], rates: &[f64]) -> Result<LinearizedMember, Stop> {
        let (member, path) = (&mut self.members[index], &self.path);
        let n = member.unknowns.len();
        let parameters = path.parameters(at);
        let time = path.sign * at;
        let values = Values { time, parameters: &parameters, coordinates: q, ..self.numeric.known };
        member.evaluator.run(&values, &mut member.values);
        self.left = self.left.saturating_sub((member.evaluator.steps() + n * n * n / 3) as u64);
        if self.left == 0 {
            return Err(Stop::Spent);
        }
        let found = &member.values;
        let (own, others) = (&found[n..n + member.own.len()], &found[n + member.own.len()..]);
        let mut local = LinearizedMember { phi: found[..n].to_vec(), jacobian: vec![vec![0.0; n]; n], drift: vec![0.0; n] };
        for ((row, column), entry) in member.own.iter().zip(own) {
            local.jacobian[*row][*column] = entry * member.scales[*column];
        }
        for ((row, unknown), entry) in member.others.iter().zip(others) {
            if rates[*unknown] != 0.0 {
                local.drift[*row] += entry * rates[*unknown];
            }
        }
        let nu = &others[member.others.len()..];
        if path.to.is_none() {
            local.drift.iter_mut().zip(nu).for_each(|(drift, nu)| *drift -= path.sign * nu);
        } else {
            // Derivatives by parameters are not available: use a difference quotient.
            let phi = local.phi.clone();
            let parameters = path.parameters(at + DIFFERENCE);
            member.evaluator.run(&Values { parameters: &parameters, ..values }, &mut member.values);
            let moved = member.values.iter().zip(&phi);
            local.drift.iter_mut().zip(moved).for_each(|(drift, (there, here))| *drift += (there - here) / DIFFERENCE);
        }
        for (row, size) in member.sizes.iter().enumerate() {
            local.phi[row] /= size;
            local.drift[row] /= size;
            local.jacobian[row].iter_mut().for_each(|entry| *entry /= size);
        }
        Ok(local)
    }

    /// Solves a member for its own unknowns from a prediction, and computes their rates.
    ///
    /// * `enough`: given, the error that may remain, in scaled unknowns; 0: only rounding.
    pub(super) fn solve(&mut self, index: usize, at: f64, q: &mut [f64], rates: &mut [f64], enough: f64) -> Result<Settled, Stop> {
        let failed = Stop::Member(index);
        let (mut first, mut last) = (f64::NAN, f64::INFINITY);
        for iteration in 0..MOST_ITERATIONS {
            let local = self.local(index, at, q, rates)?;
            let factors = Factors::new(local.jacobian).ok_or(failed)?;
            let step = factors.solve(&local.phi).ok_or(failed)?;
            let member = &self.members[index];
            let mut size = 0.0_f64;
            for ((unknown, step), scale) in member.unknowns.iter().zip(&step).zip(&member.scales) {
                q[*unknown] -= step * scale;
                size = size.max(step.abs());
            }
            if !size.is_finite() {
                return Err(failed);
            }
            let rounding =
                ROUNDING * member.unknowns.iter().zip(&member.scales).fold(1.0, |most: f64, (u, scale)| most.max((q[*u] / scale).abs()));
            if iteration == 0 {
                first = size;
            }
            let contraction = size / last;
            // At this rate of convergence the next correction is at most `contraction` times this one.
            let is_close = iteration > 0 && contraction < 1.0 && contraction * size <= enough;
            // At the rounding limit, corrections stop decreasing.
            let is_at_its_limit = contraction > 0.5 && size <= 1e3 * rounding;
            let is_there = !member.is_iterated || size <= rounding || is_close || is_at_its_limit;
            if is_there {
                let rate = factors.solve(&local.drift).ok_or(failed)?;
                for ((unknown, rate), scale) in member.unknowns.iter().zip(&rate).zip(&member.scales) {
                    rates[*unknown] = -rate * scale;
                }
                return Ok(Settled { correction: first, sign: factors.sign, size: factors.size });
            }
            if contraction > 0.5 {
                return Err(failed);
            }
            last = size;
        }
        Err(failed)
    }
}

/// Length equivalent to one radian: the characteristic length, or the largest distance of a position from the origin if no body has a size.
fn length(numeric: &Numeric, q: &[f64]) -> f64 {
    let lengths = evaluate(&numeric.system.arena, &numeric.system.lengths, &numeric.known);
    if lengths.iter().any(|length| length.is_finite() && *length != 0.0) {
        return numeric.size;
    }
    let places = q.iter().enumerate().filter(|(unknown, _)| numeric.is_position(*unknown)).map(|(_, value)| value.abs());
    let farthest = places.fold(0.0, f64::max);
    if farthest > 0.0 && farthest.is_finite() { farthest } else { numeric.size }
}

/// Step of the difference quotient, as a fraction of the change of parameters.
const DIFFERENCE: f64 = 1e-6;

impl Member {
    fn new(numeric: &Numeric, (unknowns, equations): (Vec<usize>, Vec<usize>), (block, is_iterated): (usize, bool), length: f64) -> Member {
        let (mut own, mut others) = (Vec::new(), Vec::new());
        let (mut own_roots, mut other_roots, mut nu) = (Vec::new(), Vec::new(), Vec::new());
        let mut roots: Vec<Expr> = Vec::new();
        for (row, equation) in equations.iter().enumerate() {
            let equation = &numeric.system.equations[*equation];
            roots.extend(equation.phi());
            nu.push(equation.nu);
            for (unknown, entry) in &equation.jacobian {
                match unknowns.iter().position(|own| own == unknown) {
                    Some(column) => {
                        own.push((row, column));
                        own_roots.push(*entry);
                    }
                    None => {
                        others.push((row, *unknown));
                        other_roots.push(*entry);
                    }
                }
            }
        }
        roots.extend(own_roots.into_iter().chain(other_roots).chain(nu));
        let scales = unknowns.iter().map(|unknown| numeric.system.coordinates[*unknown].role.scale(length)).collect();
        let evaluator = Evaluator::new(&numeric.system.arena, &roots);
        let (values, sizes) = (vec![f64::NAN; roots.len()], vec![1.0; equations.len()]);
        Member { block, unknowns, is_iterated, evaluator, values, own, others, scales, sizes }
    }

    /// Rescales the rows so that the largest entry of each is 1 at this Jacobian.
    pub(super) fn level(&mut self, jacobian: &[Vec<f64>]) {
        for (size, row) in self.sizes.iter_mut().zip(jacobian) {
            let most = row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            if most > 0.0 && most.is_finite() {
                *size *= most;
            }
        }
    }

    /// Largest magnitude of a change over its unknowns, in scaled unknowns.
    pub(super) fn most(&self, change: impl Fn(usize) -> f64) -> f64 {
        self.unknowns.iter().zip(&self.scales).fold(0.0, |most, (unknown, scale)| most.max((change(*unknown) / scale).abs()))
    }
}
