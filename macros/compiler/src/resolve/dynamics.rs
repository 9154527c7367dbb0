//! Masses of bodies, gravity, and forces.
//!
//! ```text
//! at P: F     a force on the body of P, at P; F in ground
//! on b: T     a torque on a body: a number in the plane, a vector in space
//! ```

use super::elaborate::{Elaborator, Scope};
use super::register::Register;
use super::{Force, Mass};
use crate::diag::{ArityFact, EquationFact, MotionFact, NameFact, Range, ValueFact};
use crate::expr::Expr;
use crate::model::Solid;
use crate::names::Key;
use crate::names::{FrameId, Value};
use crate::quantity::{Ambient, Dim};
use crate::syntax::ast::{self, ExpressionKind};

impl Elaborator<'_> {
    /// Mass, centre and inertia of a body.
    pub(super) fn mass(&mut self, frame: &ast::Shared<ast::FrameItem>, scope: &Scope) -> Mass {
        let mut found = Mass::default();
        // The inertia of a shape needs the mass.
        let (first, rest): (Vec<_>, Vec<_>) = frame.masses.iter().enumerate().partition(|(_, written)| written.what == "mass");
        for (number, written) in first.into_iter().chain(rest) {
            let word = written.what.to_string();
            let value = match word.as_str() {
                "mass" => self.scalar_of(&written.value, Dim::MASS, scope).map(|scalar| vec![scalar.expr]),
                "center" => self.location(&written.value, scope).map(|vector| vector.parts.to_vec()),
                _ => self.inertia(&written.value, found.mass, scope),
            };
            let Some(value) = value else { continue };
            if !value.iter().all(|part| self.is_fixed(*part)) {
                self.refuse::<()>(written.value.range, ValueFact::NotFixed { place: "the mass of a body" });
                continue;
            }
            let place = match word.as_str() {
                "mass" => found.mass.replace(value[0]).is_some(),
                "center" => found.center.replace(value).is_some(),
                _ => found.inertia.replace(value).is_some(),
            };
            if place {
                let body = frame.name.to_string();
                self.once(Key::Value(frame.id(), 1000 + number), |this| {
                    this.refuse::<()>(&written.what, NameFact::DuplicateStart { name: word.clone(), body })
                });
            }
        }
        if let Some((word, fact)) = found.flaw(&frame.name.to_string(), |list| self.numbers(&self.defaults, list)) {
            let range = frame.masses.iter().find(|written| written.what == word).map(|written| written.value.range);
            self.refuse::<()>(range.unwrap_or(Range::from(&frame.name)), fact);
        }
        found
    }

    /// One number in the plane; in space three, or six with the products of inertia.
    fn inertia(&mut self, written: &ast::Expression, mass: Option<Expr>, scope: &Scope) -> Option<Vec<Expr>> {
        if let ExpressionKind::Call(path, arguments) = &written.kind
            && let Some(shape) = path.name.as_ref().and_then(|name| Solid::named(&name.to_string(), self.names.ambient))
        {
            let name = path.last.to_string();
            let Some(mass) = mass else { return self.refuse(written.range, ValueFact::ShapeWithoutMass { name }) };
            if arguments.len() != shape.lengths() {
                return self.refuse(written.range, ArityFact::FunctionArity { name, wanted: shape.lengths(), found: arguments.len() });
            }
            let lengths: Option<Vec<Expr>> =
                arguments.iter().map(|length| self.scalar_of(length, Dim::LENGTH, scope).map(|scalar| scalar.expr)).collect();
            return Some(shape.inertia(&mut self.arena, mass, &lengths?));
        }
        if self.names.ambient == Ambient::Plane {
            return self.scalar_of(written, Dim::INERTIA, scope).map(|scalar| vec![scalar.expr]);
        }
        let items = if let ExpressionKind::Tuple(items) = &written.kind { items.as_slice() } else { std::slice::from_ref(written) };
        if ![3, 6].contains(&items.len()) {
            let fact = MotionFact::InertiaOfNumbers { found: items.len(), first: items[0].to_string() };
            return self.refuse(written.range, fact);
        }
        let parts = items.iter().map(|item| self.scalar_of(item, Dim::INERTIA, scope).map(|scalar| scalar.expr));
        let mut parts = parts.collect::<Option<Vec<Expr>>>()?;
        parts.resize(6, self.arena.integer(0));
        Some(parts)
    }

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
    pub(super) fn forces(&mut self, register: &Register) -> Vec<Force> {
        let mut forces = Vec::new();
        for (id, force) in &register.forces {
            let found = self.of(*id, force, |this, name, context| {
                this.applied = Some(Vec::new());
                let rows = this.joint_rows(*id, force, name, context);
                let applied = this.applied.take();
                rows.and(applied)
            });
            forces.extend(found.into_iter().flatten());
        }
        forces
    }

    /// A potential energy: a function of positions, whose force is its derivative.
    pub(super) fn energy(&mut self, value: &ast::Expression, scope: &Scope) -> Option<()> {
        let energy = self.scalar_of(value, Dim::TORQUE, scope)?;
        if self.has_speeds(energy.expr) {
            return self.refuse(value.range, ValueFact::EnergyOfVelocities);
        }
        self.energies.push(energy.expr);
        Some(())
    }

    /// `at point: force;` or `on body: torque;`
    pub(super) fn apply_force(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<()> {
        if self.applied.is_none() {
            return self.refuse(applied.target.range, EquationFact::ForceInJoint);
        }
        let (frame, point) = self.target(applied, scope)?;
        let parts = self.applied_parts(applied, frame, scope)?;
        // What pushes on ground moves nothing.
        if let Some(body) = frame.0.checked_sub(1) {
            self.applied.get_or_insert_default().push(Force { body, point, parts });
        }
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
        let range: Range = applied.value.range;
        if applied.is_torque && self.names.ambient == Ambient::Plane {
            self.is_undirected(applied, scope)?;
            return self.scalar_of(&applied.value, wanted, scope).map(|scalar| vec![scalar.expr]);
        }
        self.is_directed(applied, frame, scope)?;
        let vector = self.vector(&applied.value, scope)?;
        if !vector.measure.fits(wanted) {
            return self.refuse(range, ValueFact::WrongDimension { wanted, found: vector.measure.settled() });
        }
        Some(vector.parts.to_vec())
    }
}
