//! Masses of bodies, gravity, and forces.
//!
//! ```text
//! at P: F     a force on the body of P, at P; F in ground
//! on b: T     a torque on a body: a number in the plane, a vector in space
//! ```

use super::elaborate::{Elaborator, Scope};
use super::key::Key;
use super::register::Register;
use super::value::{FrameId, Value};
use super::{Force, Mass};
use crate::diag::{EquationFact, NameFact, Range, ValueFact};
use crate::expr::Expr;
use crate::quantity::{Ambient, Dim, is_inertia};
use crate::syntax::ast::{self, ExpressionKind};

/// kg
const MASS: Dim = Dim::new(0, 0, 0, 1);
/// kg m²
const INERTIA: Dim = Dim::new(2, 0, 0, 1);
/// m/s²
const ACCELERATION: Dim = Dim::new(1, 0, -2, 0);
/// N
const FORCE: Dim = Dim::new(1, 0, -2, 1);
/// N m
const TORQUE: Dim = Dim::new(2, 0, -2, 1);

impl Elaborator<'_> {
    /// Mass, centre and inertia of a body.
    pub(super) fn mass(&mut self, frame: &ast::Shared<ast::FrameItem>, scope: &Scope) -> Mass {
        let mut found = Mass::default();
        for (number, written) in frame.masses.iter().enumerate() {
            let word = written.what.to_string();
            let value = match word.as_str() {
                "mass" => self.scalar_of(&written.value, MASS, scope).map(|scalar| vec![scalar.expr]),
                "center" => self.location(&written.value, scope).map(|vector| vector.parts.to_vec()),
                _ => self.inertia(&written.value, scope),
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
        self.mass_is_possible(frame, &found);
        found
    }

    /// Refuses a negative mass, a centre without a mass, and an inertia that no distribution of mass has.
    fn mass_is_possible(&mut self, frame: &ast::Shared<ast::FrameItem>, found: &Mass) {
        let body = frame.name.to_string();
        let of = |this: &Self, list: &[Expr]| this.numbers(&this.defaults, list);
        let place = |word: &str| frame.masses.iter().find(|written| written.what == word).map(|written| written.value.range);
        if let (Some(range), None) = (place("center"), found.mass) {
            self.refuse::<()>(range, ValueFact::CenterWithoutMass { body: body.clone() });
        }
        for (what, value) in [("mass", found.mass.map(|mass| vec![mass])), ("inertia", found.inertia.clone())] {
            let (Some(range), Some(value)) = (place(what), value) else { continue };
            let values = of(self, &value);
            if let Some(value) = values.iter().take(3).find(|value| **value < 0.0) {
                self.refuse::<()>(range, ValueFact::NegativeMass { what, body: body.clone(), value: *value });
            } else if let [xx, yy, zz, xy, xz, yz] = values[..]
                && !is_inertia([xx, yy, zz, xy, xz, yz])
            {
                self.refuse::<()>(range, ValueFact::ImpossibleInertia { body: body.clone() });
            }
        }
    }

    /// One number in the plane; in space three, or six with the products of inertia.
    fn inertia(&mut self, written: &ast::Expression, scope: &Scope) -> Option<Vec<Expr>> {
        if self.names.ambient == Ambient::Plane {
            return self.scalar_of(written, INERTIA, scope).map(|scalar| vec![scalar.expr]);
        }
        let ExpressionKind::Tuple(items) = &written.kind else {
            return self.refuse(written.range, ValueFact::NotThreeComponents { found: 1 });
        };
        if items.len() != 3 && items.len() != 6 {
            return self.refuse(written.range, ValueFact::NotThreeComponents { found: items.len() });
        }
        let mut parts = Vec::new();
        for item in items {
            parts.push(self.scalar_of(item, INERTIA, scope)?.expr);
        }
        let zero = self.arena.integer(0);
        parts.resize(6, zero);
        Some(parts)
    }

    /// Acceleration of free fall.
    pub(super) fn gravity(&mut self, register: &Register) -> Option<Vec<Expr>> {
        let gravity = register.gravity.as_ref()?;
        let vector = self.vector(&gravity.value, &Scope::mechanism())?;
        if !vector.measure.fits(ACCELERATION) {
            let found = vector.measure.settled();
            return self.refuse(gravity.value.range, ValueFact::WrongDimension { wanted: ACCELERATION, found });
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

    /// `at point: force;` or `on body: torque;`
    pub(super) fn apply_force(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<()> {
        if self.applied.is_none() {
            return self.refuse(applied.target.range, EquationFact::ForceInJoint);
        }
        let (frame, point) = self.target(applied, scope)?;
        let parts = self.applied_parts(applied, scope)?;
        // What pushes on ground moves nothing.
        if let Some(body) = frame.0.checked_sub(1) {
            self.applied.get_or_insert_default().push(Force { body, point, parts });
        }
        Some(())
    }

    fn target(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<(FrameId, Option<Vec<Expr>>)> {
        let value = self.value(&applied.target, scope)?;
        match (applied.is_torque, value) {
            (true, Value::Body(frame)) => Some((frame, None)),
            (false, Value::Point(point)) => Some((point.frame, Some(point.local.to_vec()))),
            (is_torque, other) => {
                let wanted = if is_torque { "a body" } else { "a point" };
                self.refuse(applied.target.range, ValueFact::NotA { wanted, found: other.noun() })
            }
        }
    }

    fn applied_parts(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<Vec<Expr>> {
        let wanted = if applied.is_torque { TORQUE } else { FORCE };
        let range: Range = applied.value.range;
        if applied.is_torque && self.names.ambient == Ambient::Plane {
            return self.scalar_of(&applied.value, wanted, scope).map(|scalar| vec![scalar.expr]);
        }
        let vector = self.vector(&applied.value, scope)?;
        if !vector.measure.fits(wanted) {
            return self.refuse(range, ValueFact::WrongDimension { wanted, found: vector.measure.settled() });
        }
        Some(vector.parts.to_vec())
    }
}
