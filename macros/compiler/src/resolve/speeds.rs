//! Speeds in equations: total derivatives, angular velocities, and rows of velocities.
//!
//! ```text
//! rate(e)            de/dt along the motion, by the speeds of the bodies and by t
//! angular_velocity   ω of a body in space, φ̇ of one in the plane
//! ```
//!
//! An equation that contains speeds is a row of velocities a(q, t) · u = b(q, t): it has to be affine in them.

use super::Components;
use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use crate::diag::{ArityFact, EquationFact, Kind, ValueFact, Wanted};
use crate::expr::{Expr, Jets, Leaf, Node, Seed, derivative};
use crate::model::{DECLARED, declared_angular, declared_rates};
use crate::names::{FrameId, Scalar, Scope, Value, Vector};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast;
use proc_macro2::Ident;

/// The function that differentiates along the motion; a name of the user is preferred to it.
pub(super) const RATE: &str = "rate";

impl Elaborator<'_> {
    /// `rate(value)`
    pub(super) fn rate(&mut self, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Value> {
        let [argument] = arguments else {
            return self.refuse(name, ArityFact::FunctionArity { name: RATE.to_owned(), wanted: 1, found: arguments.len() });
        };
        let value = self.value(argument, scope)?;
        let has_speeds = match &value {
            Value::Scalar(scalar) => self.has_speeds(scalar.expr),
            Value::Vector(vector) => vector.parts.iter().any(|part| self.has_speeds(*part)),
            _ => false,
        };
        if has_speeds {
            return self.refuse(argument.range, ValueFact::RateOfVelocity);
        }
        if let Value::Scalar(Scalar { expr, measure }) = value {
            let expr = self.rate_of(expr);
            return Some(Value::Scalar(Scalar { expr, measure: measure.per(InferredDim::Known(Dim::TIME)) }));
        }
        if let Value::Joint { kind, .. } = value {
            return self.not_a(argument.range, Wanted::NumberVectorOrPoint, Kind::JointOf(kind));
        }
        let Vector { parts, measure } = self.vector_of(argument.range, value, Wanted::NumberVectorOrPoint)?;
        let parts = parts.map(|part| self.rate_of(part));
        Some(Value::Vector(Vector { parts, measure: measure.per(InferredDim::Known(Dim::TIME)) }))
    }

    /// Total derivative along the motion.
    pub(super) fn rate_of(&mut self, expr: Expr) -> Expr {
        let frames = &self.names.frames;
        let count = frames.last().map_or(0, |last| last.first + last.coordinates.len());
        let seed = match self.names.ambient {
            Ambient::Plane => Seed::motion((0..count as u32).map(Some).collect()),
            Ambient::Space => Seed::motion(declared_rates(count)).numbered_from(DECLARED),
        };
        Jets::along(seed).of(&mut self.arena, expr)[1]
    }

    /// ω of a body.
    pub(super) fn angular_velocity(&mut self, frame: FrameId) -> Value {
        let measure = InferredDim::Known(Dim::ANGLE).per(InferredDim::Known(Dim::TIME));
        let zero = self.arena.integer(0);
        match (self.names.ambient, frame.0.checked_sub(1)) {
            (Ambient::Plane, body) => {
                let first = self.names.frames[frame.0].first as u32;
                let expr = if body.is_some() { self.arena.leaf(Leaf::Speed(first + 2)) } else { zero };
                Value::Scalar(Scalar { expr, measure })
            }
            (Ambient::Space, Some(body)) => {
                let speeds = declared_angular(body).map(|speed| self.arena.leaf(Leaf::Speed(speed)));
                Value::Vector(Vector { parts: Components::space(speeds), measure })
            }
            (Ambient::Space, None) => Value::Vector(Vector { parts: Components::space([zero; 3]), measure }),
        }
    }

    /// True if an expression contains speeds.
    pub(super) fn has_speeds(&self, expr: Expr) -> bool {
        self.arena.leaves(expr).iter().any(|leaf| matches!(leaf, Leaf::Speed(_)))
    }

    /// Number of derivatives by time that an expression has along a motion of known accelerations, at most 2. Speeds have one, and so
    /// have the rates of inputs and of functions, of which two derivatives are known.
    pub(super) fn derivatives_of(&self, expr: Expr) -> usize {
        let taken = |expr: &Expr| match *self.arena.node(*expr) {
            Node::Leaf(Leaf::Speed(_)) => 1,
            Node::Leaf(Leaf::Input { order, .. }) | Node::Call { order, .. } => usize::from(order),
            _ => 0,
        };
        let taken = self.arena.reachable(&[expr]).iter().map(taken).max().unwrap_or(0);
        2_usize.saturating_sub(taken)
    }

    /// Refuses rows of velocities that are not affine in the speeds.
    pub(super) fn rows_are_affine(&mut self, joint: &str, rows: &[ScalarEquation]) {
        for (row, equation) in rows.iter().enumerate() {
            let residual = equation.residual.expr;
            let speeds: Vec<Leaf> = self.arena.leaves(residual).into_iter().filter(|leaf| matches!(leaf, Leaf::Speed(_))).collect();
            let is_affine = speeds.into_iter().all(|speed| {
                let slope = derivative(&mut self.arena, residual, speed);
                !self.has_speeds(slope)
            });
            if !is_affine {
                let fact = EquationFact::NotAffine { joint: joint.to_owned(), row: row + 1, of: rows.len() };
                self.refuse_here::<()>(equation.range, fact);
                return;
            }
        }
    }
}
