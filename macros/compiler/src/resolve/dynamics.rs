//! Gravity and forces.
//!
//! ```text
//! at P: F     a force on the body of P, at P; F in ground
//! on b: T     a torque on a body: a number in the plane, a vector in space
//! ```

use super::elaborate::Elaborator;
use super::{DeclaredForce, Energy, Force};
use crate::diag::{EquationFact, MotionFact, ValueFact};
use crate::expr::{Expr, Leaf};
use crate::names::{FrameId, Register, Scope, Value};
use crate::quantity::{Ambient, Dim};
use crate::syntax::ast;

impl Elaborator<'_> {
    /// Acceleration of free fall.
    pub(super) fn gravity(&mut self, register: &Register) -> Option<Vec<Expr>> {
        let gravity = register.gravity.as_ref()?;
        if let Value::Scalar(_) = self.value(&gravity.value, &Scope::mechanism())? {
            let (value, ambient) = (gravity.value.to_string(), self.names.ambient);
            return self.refuse(gravity.value.range, MotionFact::GravityWithoutDirection { value, ambient });
        }
        let vector = self.vector(&gravity.value, &Scope::mechanism())?;
        if !vector.measure.fits(Dim::ACCELERATION) {
            let found = vector.measure.settled();
            return self.refuse(gravity.value.range, ValueFact::WrongDimension { wanted: Dim::ACCELERATION, found });
        }
        Some(vector.parts.to_vec())
    }

    /// Resolves all forces.
    pub(super) fn forces(&mut self, register: &Register) -> (Vec<DeclaredForce>, Vec<Force>) {
        let (mut declared, mut forces) = (Vec::new(), Vec::new());
        for (id, force) in &register.forces {
            let found = self.resolved(*id, force, |this, name, context| {
                this.applied = Some(Vec::new());
                let rows = this.joint_rows(*id, force, name, context);
                let applied = this.applied.take();
                rows.and(applied)
            });
            let of = declared.len();
            forces.extend(found.into_iter().flatten().map(|part| Force { of, ..part }));
            if !matches!(force.body, ast::JointBody::Energy(_)) {
                declared.push(DeclaredForce { name: self.names.declared[id.0].name.clone(), is_slice: force.is_slice });
            }
        }
        (declared, forces)
    }

    /// A potential energy: a function of positions, whose force is its derivative, or that of a force with a `potential`.
    pub(super) fn energy(&mut self, value: &ast::Expression, is_of_force: bool, scope: &Scope) -> Option<()> {
        let known = self.diag.refusals().len();
        let energy = self.scalar_of(value, Dim::TORQUE, scope).or_else(|| self.diag.of_energy(known))?.expr;
        let rate = is_of_force.then(|| self.rate_of(energy));
        self.energies.push(Energy { value: energy, rate });
        if self.has_speeds(energy) {
            return self.refuse(value.range, ValueFact::EnergyOfVelocities);
        }
        let moves = self.arena.leaves(energy).into_iter().any(Leaf::moves);
        // The potential of a spring whose stiffness is 0 is 0.
        let is_zero = self.arena.as_constant(energy).is_some_and(|value| value.is_zero());
        if moves || is_of_force && is_zero { Some(()) } else { self.refuse(value.range, EquationFact::EnergyOfNothing { is_of_force }) }
    }

    /// `at point: force;` or `on body: torque;`
    pub(super) fn apply_force(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<()> {
        let (frame, point) = self.target(applied, scope)?;
        let parts = self.applied_parts(applied, frame, scope)?;
        if parts.iter().any(|part| self.arena.is_never_finite(*part)) {
            return self.refuse(applied.value.range, ValueFact::NotFinite { place: "the load" });
        }
        self.applied.get_or_insert_default().push(Force { of: 0, body: frame.0.checked_sub(1), point, parts });
        Some(())
    }

    fn target(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<(FrameId, Option<Vec<Expr>>)> {
        let value = self.value(&applied.target, scope)?;
        let found = value.kind();
        match (applied.is_torque, value) {
            (true, Value::Body(frame)) => Some((frame, None)),
            (false, Value::Point(point)) => Some((point.frame, Some(point.local.to_vec()))),
            (true, other) => {
                let instead = match other {
                    Value::Point(fixed) | Value::Axis(fixed) => Some(self.names.frames[fixed.frame.0].name.clone()),
                    _ => None,
                };
                self.refuse(applied.target.range, MotionFact::TorqueOnNoBody { found, instead })
            }
            (false, other) => {
                let instead = match other {
                    Value::Body(frame) => Some(format!("{}.position", self.names.frames[frame.0].name)),
                    _ => None,
                };
                self.refuse(applied.target.range, MotionFact::ForceAtNoPoint { found, instead })
            }
        }
    }

    fn applied_parts(&mut self, applied: &ast::Applied, frame: FrameId, scope: &Scope) -> Option<Vec<Expr>> {
        let wanted = if applied.is_torque { Dim::TORQUE } else { Dim::FORCE };
        if applied.is_torque && self.names.ambient == Ambient::Plane {
            self.is_undirected(applied, scope)?;
            return self.scalar_of(&applied.value, wanted, scope).map(|scalar| vec![scalar.expr]);
        }
        self.is_directed(applied, frame, scope)?;
        let vector = self.vector(&applied.value, scope)?;
        if !vector.measure.fits(wanted) {
            return self.refuse(applied.value.range, ValueFact::WrongDimension { wanted, found: vector.measure.settled() });
        }
        Some(vector.parts.to_vec())
    }
}
