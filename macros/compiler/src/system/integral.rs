//! Equations between positions of which rows of velocities are the rates.
//!
//! ```text
//! a(q) · q̇ = b     Φ = A(q) − A(q₀) − b t        a = ∂A/∂q
//!                  A(q) − A(q₀) = Σ ∫ a_i dq_i    from q₀ to q, along one coordinate after the other
//! ```
//!
//! Of a point of a body on one hinge or on two in a row, a_i is affine in the sine and the cosine of q_i. If a is no gradient, as that of a rolling
//! wheel, the sum depends on the way; so its derivatives are compared with a at some configurations. For sums of products of coordinates, sines and
//! cosines that is enough. An `if`, a table or a root is not accepted: its derivatives may agree at all these configurations and differ elsewhere.

use super::Coordinate;
use crate::diag::NoPosition;
use crate::expr::{Arena, Binary, Expr, Leaf, Lookup, Node, Substitution, Unary, Values, derivative, evaluate};
use crate::model::{Model, defaults, tabulated};
use crate::quantity::Role;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Configurations at which derivatives are compared.
const TRIALS: usize = 4;

/// Derivatives agree if they differ by no more than this share of the largest one.
const AGREES: f64 = 1e-12;

/// Integrates rows of velocities.
pub(super) struct Integrals<'a> {
    model: &'a Model,
    coordinates: &'a [Coordinate],
    /// q₀; zero where there is none.
    starts: &'a [Option<Expr>],
    /// Defaults of the parameters.
    parameters: Vec<f64>,
}

impl<'a> Integrals<'a> {
    pub(super) fn new(model: &'a Model, arena: &Arena, coordinates: &'a [Coordinate], starts: &'a [Option<Expr>]) -> Integrals<'a> {
        Integrals { model, coordinates, starts, parameters: defaults(model, arena) }
    }

    /// A(q) − A(q₀) − b t of a row of velocities a · u = b.
    pub(super) fn of(&self, arena: &mut Arena, residual: Expr) -> Result<Expr, NoPosition> {
        let residual = arena.plain(residual, &mut Lookup::default());
        let (factors, side) = affine(arena, residual);
        let changes = self.changes(arena, &factors).ok_or(NoPosition::Factors)?;
        if !arena.is_fixed(side) {
            return Err(NoPosition::Side);
        }
        let time = arena.leaf(Leaf::Time);
        let way = arena.mul(side, time);
        let phi = arena.neg(way);
        Ok(changes.into_iter().fold(phi, |phi, change| arena.add(phi, change)))
    }

    /// The terms of A(q) − A(q₀).
    fn changes(&self, arena: &mut Arena, factors: &[(u32, Expr)]) -> Option<Vec<Expr>> {
        let starts: Vec<Option<Expr>> =
            factors.iter().map(|(number, _)| self.starts.get(*number as usize).copied()).collect::<Option<_>>()?;
        let is_of_own = |arena: &Arena, number: u32, factor: Expr| {
            let is_known = |leaf: Leaf| leaf == Leaf::Coordinate(number) || matches!(leaf, Leaf::Parameter(_));
            arena.leaves(factor).into_iter().all(is_known)
        };
        let is_separate = factors.iter().all(|(number, factor)| is_of_own(arena, *number, *factor));
        // Where positions are integrated, rows of velocities hold from an assembled start, not from a declared one.
        let has_start = self.model.task.is_solved() && factors.iter().all(|(number, _)| self.begins(*number as usize));
        if !(is_separate || has_start) {
            return None;
        }
        let mut changes = Vec::new();
        for (place, ((number, factor), start)) in factors.iter().zip(&starts).enumerate() {
            // Those that change after this one are still where they begin.
            let mut still = Substitution::new();
            for ((later, _), start) in factors.iter().zip(&starts).skip(place + 1) {
                let start = start.unwrap_or_else(|| arena.integer(0));
                still.replace(Leaf::Coordinate(*later), start);
            }
            let factor = still.of(arena, *factor);
            changes.push(change(arena, *number, factor, *start)?);
        }
        (is_separate || self.have_slopes(arena, &changes, factors)).then_some(changes)
    }

    /// True if a coordinate has a start: an angle or a displacement of a joint begins at 0 unless something else is declared, a place somewhere.
    fn begins(&self, number: usize) -> bool {
        let is_of_joint =
            self.coordinates.get(number).is_some_and(|coordinate| matches!(coordinate.role, Role::Angle | Role::Displacement));
        is_of_joint || self.starts.get(number).is_some_and(Option::is_some)
    }

    /// True if a is the gradient of the sum of these terms.
    fn have_slopes(&self, arena: &mut Arena, changes: &[Expr], factors: &[(u32, Expr)]) -> bool {
        let roots: Vec<Expr> = factors.iter().map(|(_, factor)| *factor).collect();
        let coordinates: BTreeSet<Leaf> =
            arena.leaves_of(&roots).into_iter().chain(factors.iter().map(|(number, _)| Leaf::Coordinate(*number))).collect();
        let is_known = |leaf: &Leaf| matches!(leaf, Leaf::Coordinate(_) | Leaf::Parameter(_));
        if !(coordinates.iter().all(is_known) && roots.iter().all(|factor| are_products(arena, *factor))) {
            return false;
        }
        let sum = arena.sum(changes);
        let zero = arena.integer(0);
        let mut pairs = Vec::new();
        for leaf in coordinates {
            let Leaf::Coordinate(number) = leaf else { continue };
            let factor = factors.iter().find(|(own, _)| *own == number).map_or(zero, |(_, factor)| *factor);
            pairs.extend([derivative(arena, sum, leaf), factor]);
        }
        let functions = |number: u32, x: f64| tabulated(&self.model.functions, number, x);
        (1..=TRIALS).all(|trial| {
            let count = self.starts.len();
            let coordinates: Vec<f64> = (0..count).map(|number| PI * unrelated(number, trial)).collect();
            // Near the defaults, so that they keep their signs.
            let near = |(number, default): (usize, &f64)| {
                let share = 0.1 * unrelated(count + number, trial);
                if *default == 0.0 { share } else { default * (1.0 + share) }
            };
            let parameters: Vec<f64> = self.parameters.iter().enumerate().map(near).collect();
            let values = Values {
                time: 0.0,
                parameters: &parameters,
                coordinates: &coordinates,
                speeds: &[],
                accelerations: &[],
                functions: &functions,
            };
            let found = evaluate(arena, &pairs, &values);
            let largest = found.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            found.chunks(2).all(|pair| (pair[0] - pair[1]).abs() <= AGREES * largest)
        })
    }
}

/// True of sums of products of variables, sines and cosines, and of quotients with a fixed divisor.
fn are_products(arena: &Arena, factor: Expr) -> bool {
    arena.reachable(&[factor]).into_iter().all(|expr| match *arena.node(expr) {
        Node::Constant(_) | Node::Leaf(_) | Node::Marked { .. } | Node::Unary(Unary::Neg | Unary::Sin | Unary::Cos, _) => true,
        Node::Binary(Binary::Add | Binary::Sub | Binary::Mul, ..) => true,
        Node::Binary(Binary::Div, _, divisor) => arena.is_fixed(divisor),
        // A root of constants and the like is a number.
        _ => arena.value(expr).is_some(),
    })
}

/// A number between −1 and 1.
fn unrelated(number: usize, trial: usize) -> f64 {
    // Multiples of the golden ratio modulo 1 are unrelated.
    2.0 * ((number * (TRIALS + 1) + trial) as f64 * 0.618_033_988_749_895).fract() - 1.0
}

/// a by number of the speed, and b, of an expression a · u − b.
pub(super) fn affine(arena: &mut Arena, residual: Expr) -> (Vec<(u32, Expr)>, Expr) {
    let zero = arena.integer(0);
    let mut still = Substitution::new();
    let mut factors = Vec::new();
    for leaf in arena.leaves(residual) {
        let Leaf::Speed(number) = leaf else { continue };
        still.replace(leaf, zero);
        let factor = derivative(arena, residual, leaf);
        if factor != zero {
            factors.push((number, factor));
        }
    }
    let rest = still.of(arena, residual);
    (factors, arena.neg(rest))
}

/// ∫ a dq from q₀ to q.
fn change(arena: &mut Arena, number: u32, factor: Expr, start: Option<Expr>) -> Option<Expr> {
    let own = Leaf::Coordinate(number);
    let q = arena.leaf(own);
    if !arena.leaves(factor).contains(&own) {
        let way = start.map_or(q, |start| arena.sub(q, start));
        return Some(arena.mul(factor, way));
    }
    let there = antiderivative(arena, number, factor)?;
    let mut at_start = Substitution::new();
    let start = start.unwrap_or_else(|| arena.integer(0));
    at_start.replace(own, start);
    let begun = at_start.of(arena, there);
    Some(arena.sub(there, begun))
}

/// A with ∂A/∂q = a, for a sum of terms without q and of multiples of sines and cosines of q, as of a point of a body that turns by q.
fn antiderivative(arena: &mut Arena, number: u32, factor: Expr) -> Option<Expr> {
    let own = Leaf::Coordinate(number);
    let is_free = |arena: &Arena, expr: Expr| !arena.leaves(expr).contains(&own);
    if is_free(arena, factor) {
        let q = arena.leaf(own);
        return Some(arena.mul(factor, q));
    }
    let node = *arena.node(factor);
    if let Node::Binary(Binary::Add | Binary::Sub, a, b) = node {
        let (a, b) = (antiderivative(arena, number, a)?, antiderivative(arena, number, b)?);
        return Some(if matches!(node, Node::Binary(Binary::Add, ..)) { arena.add(a, b) } else { arena.sub(a, b) });
    }
    match node {
        Node::Unary(Unary::Neg, a) => antiderivative(arena, number, a).map(|a| arena.neg(a)),
        Node::Binary(Binary::Mul, a, b) if is_free(arena, a) => antiderivative(arena, number, b).map(|b| arena.mul(a, b)),
        Node::Binary(Binary::Mul, a, b) if is_free(arena, b) => antiderivative(arena, number, a).map(|a| arena.mul(a, b)),
        Node::Binary(Binary::Div, a, b) if is_free(arena, b) => antiderivative(arena, number, a).map(|a| arena.div(a, b)),
        Node::Unary(function @ (Unary::Sin | Unary::Cos), a) => {
            let is_of_own = arena.leaves(a).into_iter().all(|leaf| leaf == own || matches!(leaf, Leaf::Parameter(_)));
            let slope = derivative(arena, a, own);
            if !is_of_own || arena.as_constant(slope).is_none_or(|slope| slope.is_zero()) {
                return None;
            }
            let area = if function == Unary::Cos {
                arena.sin(a)
            } else {
                let cosine = arena.cos(a);
                arena.neg(cosine)
            };
            Some(arena.div(area, slope))
        }
        _ => None,
    }
}
