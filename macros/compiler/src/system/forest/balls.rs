//! The axes along which ω of a ball has its components.
//!
//! The inertia of a ball is the same along all axes, so that any will do. Equations between speeds have constant entries along the axes of
//! the body whose directions they are written with, or of ground.

use super::Forest;
use crate::expr::{Expr, Leaf, Mark, Node, Spin, SpinAxes};
use crate::model::declared_angular;
use std::cmp::Reverse;
use std::collections::BTreeMap;

impl Forest<'_> {
    /// The axes for ω of a body that is free to turn: its own if an equation between speeds is written with them, otherwise those used by most
    /// of them; axes of another body only if its ω is along its own.
    pub(super) fn axes_of_spin(&self, body: usize) -> SpinAxes {
        if !self.is_ball(body) {
            return SpinAxes::Own;
        }
        let mut counts: BTreeMap<SpinAxes, usize> = BTreeMap::new();
        let lasting = self.model.joints.iter().filter(|joint| joint.freedom.is_none());
        for residual in lasting.flat_map(|joint| &joint.residuals).filter(|residual| residual.is_velocity) {
            for axes in self.axes_in(residual.expr, body) {
                *counts.entry(axes).or_default() += 1;
            }
        }
        let most = counts.iter().min_by_key(|(_, count)| Reverse(**count)).map(|(axes, _)| *axes);
        most.filter(|_| !counts.contains_key(&SpinAxes::Own)).unwrap_or(SpinAxes::Own)
    }

    /// True if the body has its mass centre in its origin and the same inertia along all axes.
    fn is_ball(&self, body: usize) -> bool {
        let is_zero = |expr: &Expr| self.model.arena.value(*expr) == Some(0.0);
        self.model.bodies[body].masses.iter().all(|mass| {
            let is_round = |inertia: &Vec<Expr>| inertia[0] == inertia[1] && inertia[1] == inertia[2] && inertia[3..].iter().all(is_zero);
            mass.center.iter().flatten().all(is_zero) && mass.inertia.as_ref().is_none_or(is_round)
        })
    }

    /// The axes with whose directions an equation of this body's ω is written; those of bodies by the frames of the arena.
    fn axes_in(&self, equation: Expr, body: usize) -> Vec<SpinAxes> {
        let whole = |node: &Node| matches!(node, Node::Marked { mark: Mark::Turned { .. }, .. });
        let nodes = self.model.arena.reachable_above(&[equation], whole);
        let own = declared_angular(body);
        let is_turning = |expr: &Expr| matches!(self.model.arena.node(*expr), Node::Leaf(Leaf::Speed(number)) if own.contains(number));
        if !nodes.iter().any(is_turning) {
            return Vec::new();
        }
        let written_with = |expr: &Expr| match *self.model.arena.node(*expr) {
            Node::Marked { mark: Mark::Turned { vector, .. }, .. } => Some(self.model.arena.vector(vector).0),
            _ => None,
        };
        let mut bodies: Vec<usize> = nodes.iter().filter_map(written_with).collect();
        bodies.sort_unstable();
        bodies.dedup();
        if bodies.is_empty() {
            return vec![SpinAxes::Ground];
        }
        let axes = bodies.into_iter().filter_map(|other| if other == body { Some(SpinAxes::Own) } else { self.lent_by(other) });
        axes.collect()
    }

    /// The speeds of bodies that are components of ω; axes are those of bodies.
    pub(super) fn spins(&self) -> Vec<Option<Spin>> {
        let body = |frame: usize| self.frames.iter().position(|other| *other == Some(frame));
        let of_body = |axes: SpinAxes| match axes {
            SpinAxes::Of(frame) => body(frame).map(SpinAxes::Of),
            axes => Some(axes),
        };
        let spin = |frame: &Option<usize>| {
            let spin = self.arena.spin((*frame)?)?;
            Some(Spin { axes: of_body(spin.axes)?, ..spin })
        };
        self.frames.iter().map(spin).collect()
    }

    fn lent_by(&self, body: usize) -> Option<SpinAxes> {
        let frame = self.frames[body]?;
        self.arena.spin(frame).filter(|spin| spin.axes == SpinAxes::Own).map(|_| SpinAxes::Of(frame))
    }
}
