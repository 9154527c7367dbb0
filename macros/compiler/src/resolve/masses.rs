//! Masses of bodies, declared or added by joints and forces.
//!
//! ```text
//! inertia = (a, b, c) along R;       R diag(a, b, c) Rᵀ in the axes of the body
//! add mass at P: m;                  a mass in one point
//! add inertia on b: J;               in space a number is J about every axis
//! ```

use super::elaborate::Elaborator;
use super::{Body, Mass};
use crate::diag::{ArityFact, MotionFact, NameFact, Range, ValueFact, Wanted};
use crate::expr::{Exact, Expr};
use crate::geometry::turned_tensor;
use crate::hints::{is_bare, is_zero};
use crate::model::Solid;
use crate::names::{Key, Scope, Value};
use crate::quantity::{Ambient, Dim};
use crate::syntax::ast::{self, ExpressionKind, MassItem};
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// Mass, centre and inertia of a body.
    pub(super) fn mass(&mut self, frame: &ast::Shared<ast::FrameItem>, scope: &Scope) -> Vec<Mass> {
        let (mut found, one) = (Mass::default(), self.arena.integer(1));
        // The inertia of a shape needs the mass.
        let (first, rest): (Vec<_>, Vec<_>) = frame.masses.iter().enumerate().partition(|(_, written)| written.what == "mass");
        for (number, written) in first.into_iter().chain(rest) {
            let word = written.what.to_string();
            let value = match word.as_str() {
                // After a mass that was refused nothing else is said of it.
                "mass" => Some(vec![self.scalar_of(&written.value, Dim::MASS, scope).map_or(one, |scalar| scalar.expr)]),
                "center" => self.location(&written.value, scope).map(|vector| vector.parts.to_vec()),
                _ => self.inertia(written, found.mass, false, scope),
            };
            let Some(value) = value else { continue };
            if !value.iter().all(|part| self.arena.is_fixed(*part)) {
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
                self.unless_refused(Key::Value(frame.id(), 1000 + number), |this| {
                    this.refuse::<()>(&written.what, NameFact::DuplicateStart { name: word.clone(), body })
                });
            }
        }
        if let Some((word, fact)) = found.flaw(&frame.name.to_string(), |list| self.numbers(&self.defaults, list)) {
            let range = frame.masses.iter().find(|written| written.what == word).map(|written| written.value.range);
            self.refuse::<()>(range.unwrap_or(Range::from(&frame.name)), fact);
        }
        let range =
            frame.masses.iter().find(|written| written.what == "inertia" && is_bare(&written.value)).map(|written| written.value.range);
        if let (Some(mass), Some(inertia), Some(range)) = (found.mass, &found.inertia, range) {
            let values = self.numbers(&self.defaults, &[&[mass][..], inertia].concat());
            let greatest = values[1..].iter().take(3).copied().fold(0.0, f64::max);
            if values[0] > 0.0 && greatest.is_finite() {
                self.bare.note_gyration(&frame.name.to_string(), (greatest / values[0]).sqrt(), range);
            }
        }
        let is_there = found.mass.is_some() || found.inertia.is_some();
        if is_there { vec![found] } else { Vec::new() }
    }

    /// `add mass at point: mass;` or `add inertia on body: inertia;`
    pub(super) fn add_mass(&mut self, added: &ast::Added, scope: &Scope) -> Option<()> {
        let ast::Added { target, item } = added;
        let is_inertia = item.what == "inertia";
        let (frame, center) = match self.value(target, scope)? {
            Value::Body(frame) if is_inertia => (frame, None),
            Value::Point(point) if !is_inertia => (point.frame, Some(point.local.to_vec())),
            other => {
                let wanted = if is_inertia { Wanted::Body } else { Wanted::Point };
                return self.not_a(target.range, wanted, other.kind());
            }
        };
        let value = match is_inertia {
            true => self.inertia(item, None, true, scope)?,
            false => vec![self.scalar_of(&item.value, Dim::MASS, scope)?.expr],
        };
        if self.names.is_abstract() {
            return Some(());
        }
        if !value.iter().all(|part| self.arena.is_fixed(*part)) {
            return self.refuse(item.value.range, ValueFact::NotFixed { place: "the mass of a body" });
        }
        let mass = match is_inertia {
            true => Mass { inertia: Some(value), ..Mass::default() },
            false => Mass { mass: Some(value[0]), center, inertia: None },
        };
        let body = self.names.frames[frame.0].name.clone();
        if let Some((_, fact)) = mass.flaw(&body, |list| self.numbers(&self.defaults, list)) {
            return self.refuse(item.value.range, fact);
        }
        // A mass that is fixed in ground resists nothing.
        if let Some(body) = frame.0.checked_sub(1) {
            self.added.push((body, mass));
        }
        Some(())
    }

    /// Adds the masses of joints and forces to their bodies.
    pub(super) fn gather_masses(&mut self, bodies: &mut [Body]) {
        for (body, mass) in std::mem::take(&mut self.added) {
            if let Some(body) = bodies.get_mut(body) {
                mass.join(&mut self.arena, &mut body.masses);
            }
        }
    }

    /// One number in the plane; in space three, or six with the products of inertia, and where it is allowed one for every axis.
    fn inertia(&mut self, item: &MassItem, mass: Option<Expr>, may_be_one: bool, scope: &Scope) -> Option<Vec<Expr>> {
        if let Some(along) = item.along.as_ref().filter(|_| self.names.ambient == Ambient::Plane) {
            return self.refuse(along.range, MotionFact::InertiaAlongInPlane { inertia: item.value.to_string() });
        }
        let parts = self.in_own_axes(&item.value, mass, may_be_one, scope)?;
        let Some(along) = &item.along else { return Some(parts) };
        let (turns, Ok(parts)) = (self.turns(along, "the inertia of a body", scope)?, parts.try_into()) else { return None };
        Some(turned_tensor(&mut self.arena, &turns, parts).map(|part| self.settled(part)).to_vec())
    }

    fn in_own_axes(&mut self, written: &ast::Expression, mass: Option<Expr>, may_be_one: bool, scope: &Scope) -> Option<Vec<Expr>> {
        if let ExpressionKind::Call(path, arguments) = &written.kind
            && let Some(shape) = path.name.as_ref().and_then(|name| Solid::named(&name.to_string(), self.names.ambient))
        {
            let name = path.last.to_string();
            let Some(mass) = mass else { return self.refuse(written.range, ValueFact::ShapeWithoutMass { name }) };
            if arguments.len() != shape.lengths() {
                let (wanted, found) = (shape.lengths(), arguments.len());
                let of_two = if name == "disk" && found == 2 { Solid::named("cylinder", self.names.ambient) } else { None };
                let call = of_two.map_or(shape.call, |solid| solid.call);
                return self.refuse(written.range, ArityFact::ShapeArity { name, call, wanted, found });
            }
            let lengths: Option<Vec<Expr>> =
                arguments.iter().map(|length| self.scalar_of(length, Dim::LENGTH, scope).map(|scalar| scalar.expr)).collect();
            return Some(shape.inertia(&mut self.arena, mass, &lengths?));
        }
        if let ExpressionKind::Call(path, _) = &written.kind
            && let Some(name) = path.name.as_ref().filter(|name| !self.is_function(name, scope))
        {
            return self.unknown_shape(name);
        }
        if self.names.ambient == Ambient::Plane {
            if let ExpressionKind::Tuple(items) = &written.kind {
                let third = items.get(2).map(|third| items.iter().find(|item| is_zero(third) && !is_zero(item)).unwrap_or(third));
                return self.refuse(written.range, MotionFact::InertiaOfVector { inertia: third.map(ToString::to_string) });
            }
            return self.scalar_of(written, Dim::INERTIA, scope).map(|scalar| vec![scalar.expr]);
        }
        let items = if let ExpressionKind::Tuple(items) = &written.kind { items.as_slice() } else { std::slice::from_ref(written) };
        let is_complete = matches!(items.len(), 3 | 6) || may_be_one && items.len() == 1;
        if !is_complete {
            let fact = MotionFact::InertiaOfNumbers { found: items.len(), first: items[0].to_string() };
            return self.refuse(written.range, fact);
        }
        let parts = items.iter().map(|item| self.scalar_of(item, Dim::INERTIA, scope).map(|scalar| scalar.expr));
        let mut parts = parts.collect::<Option<Vec<Expr>>>()?;
        if let [every] = parts[..] {
            parts.resize(3, every);
        }
        parts.resize(6, self.arena.integer(0));
        Some(parts)
    }

    fn unknown_shape<T>(&mut self, name: &Ident) -> Option<T> {
        let (ambient, word) = (self.names.ambient, name.to_string());
        let similar = || self.nearest(&word, Solid::calls(ambient).filter_map(|call| call.split('(').next()));
        let meant = Solid::meant(&word, ambient).or_else(|| Solid::named(&similar()?, ambient));
        let (near, known) = (meant.map(|solid| solid.call.to_owned()), Solid::calls(ambient).collect());
        self.refuse(name, NameFact::UnknownShape { name: word, near, known })
    }

    /// A number without parameters as a constant, so that no program computes it.
    fn settled(&mut self, expr: Expr) -> Expr {
        if !self.arena.leaves(expr).is_empty() {
            return expr;
        }
        let value = self.numbers(&[], &[expr])[0];
        Exact::binary(value).map_or(expr, |value| self.arena.constant(value))
    }
}
