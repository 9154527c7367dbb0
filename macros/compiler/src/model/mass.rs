//! Masses of bodies.

use super::{Relation, Requirement};
use crate::diag::ValueFact;
use crate::expr::{Arena, Expr, Triple};
use crate::quantity::{Dim, is_inertia};

/// One part in so many of a moment of inertia may be a rounding error.
const ALL: i64 = 65_536;

/// A mass fixed in a body and its distribution; undeclared parts are zero.
#[derive(Clone, Debug, Default)]
pub struct Mass {
    /// Mass.
    pub mass: Option<Expr>,
    /// Centre of mass, by local components.
    pub center: Option<Vec<Expr>>,
    /// Inertia about the centre of mass: one number in the plane, in space I_xx, I_yy, I_zz, I_xy, I_xz, I_yz in the axes of the body.
    pub inertia: Option<Vec<Expr>>,
}

impl Mass {
    /// The clause at fault and the mistake in it: a centre without a mass, a negative number, an inertia that no distribution of mass has.
    ///
    /// * `numbers`: given, the values of expressions of parameters at the defaults.
    pub(crate) fn flaw(&self, body: &str, numbers: impl Fn(&[Expr]) -> Vec<f64>) -> Option<(&'static str, ValueFact)> {
        let body = body.to_owned();
        if self.center.is_some() && self.mass.is_none() {
            return Some(("center", ValueFact::CenterWithoutMass { body }));
        }
        let mass = ("mass", self.mass.map(|mass| vec![mass]), Dim::MASS);
        for (what, value, dim) in [mass, ("inertia", self.inertia.clone(), Dim::INERTIA)] {
            let Some(values) = value.map(|value| numbers(&value)) else { continue };
            if let Some(value) = values.iter().take(3).copied().find(|value| *value < 0.0) {
                return Some((what, ValueFact::NegativeMass { what, body, value, dim }));
            }
            if let [xx, yy, zz, xy, xz, yz] = values[..]
                && !is_inertia([xx, yy, zz, xy, xz, yz])
            {
                let by_products = is_inertia([xx, yy, zz, 0.0, 0.0, 0.0]);
                return Some((what, ValueFact::ImpossibleInertia { body, by_products }));
            }
        }
        None
    }

    /// Conditions on the parameters of a mass, for values other than the defaults: nothing is negative, and the second moments ∫ x xᵀ dm are
    /// positive semidefinite.
    pub(crate) fn requirements(&self, arena: &mut Arena, body: &str) -> Vec<Requirement> {
        let rhs = arena.integer(0);
        let require = |lhs, dim, what, why: &str| {
            let (joint, why) = (format!("{body}.{what}"), why.to_owned());
            Requirement { lhs, relation: Relation::GreaterOrEqual, rhs, dim, joint, why }
        };
        let mut found: Vec<Requirement> =
            self.mass.iter().map(|mass| require(*mass, Dim::MASS, "mass", "a mass must not be negative")).collect();
        match self.inertia.as_deref() {
            Some([about_z]) => found.push(require(*about_z, Dim::INERTIA, "inertia", "an inertia must not be negative")),
            Some([xx, yy, zz, products @ ..]) => {
                // Rounding errors may exceed the bound, on which thin plates and rods lie, also those of `f32`.
                let [almost_all, all] = [ALL - 1, ALL].map(|number| arena.integer(number));
                let share = arena.div(almost_all, all);
                for [one, two, third] in [[*xx, *yy, *zz], [*yy, *zz, *xx], [*zz, *xx, *yy]] {
                    let (sum, third) = (arena.add(one, two), arena.mul(share, third));
                    let rest = arena.sub(sum, third);
                    found.push(require(rest, Dim::INERTIA, "inertia", "two moments of inertia less the third must not be negative"));
                }
                let why = "no distribution of mass has these moments and products of inertia";
                let each = minors(arena, [*xx, *yy, *zz], products);
                found.extend(each.into_iter().map(|(minor, dim)| require(minor, dim, "inertia", why)));
            }
            _ => {}
        }
        found.retain(|requirement| !arena.leaves(requirement.lhs).is_empty());
        found
    }

    /// True if mass and inertia are certainly zero.
    fn is_nothing(&self, arena: &Arena) -> bool {
        self.mass.iter().chain(self.inertia.iter().flatten()).all(|part| is_zero(arena, *part))
    }

    /// Adds a mass to those of a body: to the mass with the same centre, if there is one.
    pub(crate) fn join(mut self, arena: &mut Arena, masses: &mut Vec<Mass>) {
        if self.is_nothing(arena) {
            return;
        }
        if self.center.as_ref().is_some_and(|center| center.iter().all(|part| is_zero(arena, *part))) {
            self.center = None;
        }
        // An inertia alone has no centre of its own.
        let fits = |known: &&mut Mass| known.mass.is_none() || self.mass.is_none() || known.center == self.center;
        let Some(known) = masses.iter_mut().find(fits) else { return masses.push(self) };
        if known.mass.is_none() {
            known.center = self.center;
        }
        known.mass = sum(arena, known.mass.map(|mass| vec![mass]), self.mass.map(|mass| vec![mass])).map(|sum| sum[0]);
        known.inertia = sum(arena, known.inertia.take(), self.inertia);
    }
}

/// Principal minors, of two and of three rows, of twice the second moments, tr(I) − 2 I, with what may be rounding added to its diagonal; none
/// without products of inertia.
fn minors(arena: &mut Arena, [xx, yy, zz]: Triple, products: &[Expr]) -> Vec<(Expr, Dim)> {
    let [xy, xz, yz] = products else { return Vec::new() };
    if products.iter().all(|product| is_zero(arena, *product)) {
        return Vec::new();
    }
    let trace = arena.sum(&[xx, yy, zz]);
    let all = arena.integer(ALL);
    let rounding = arena.div(trace, all);
    let whole = arena.add(trace, rounding);
    let two = arena.integer(2);
    let [a, b, c] = [xx, yy, zz].map(|moment| {
        let twice = arena.mul(two, moment);
        arena.sub(whole, twice)
    });
    let [d, e, f] = [*xy, *xz, *yz].map(|product| arena.mul(two, product));
    let [of_ab, of_ac, of_bc] = [[a, b, d], [a, c, e], [b, c, f]].map(|[one, other, beside]| {
        let (both, square) = (arena.mul(one, other), arena.square(beside));
        arena.sub(both, square)
    });
    // Off the diagonal there are −d, −e and −f.
    let (first, de, df, be) = (arena.mul(a, of_bc), arena.mul(d, c), arena.mul(d, f), arena.mul(b, e));
    let (fe, dfe) = (arena.mul(f, e), arena.add(df, be));
    let dcfe = arena.add(de, fe);
    let (second, third) = (arena.mul(d, dcfe), arena.mul(e, dfe));
    let rest = arena.sub(first, second);
    let determinant = arena.sub(rest, third);
    let of_two = Dim::INERTIA.times(Dim::INERTIA);
    vec![(of_ab, of_two), (of_ac, of_two), (of_bc, of_two), (determinant, of_two.times(Dim::INERTIA))]
}

fn sum(arena: &mut Arena, one: Option<Vec<Expr>>, two: Option<Vec<Expr>>) -> Option<Vec<Expr>> {
    match (one, two) {
        (Some(one), Some(two)) => Some(one.into_iter().zip(two).map(|(one, two)| arena.add(one, two)).collect()),
        (one, two) => one.or(two),
    }
}

fn is_zero(arena: &Arena, expr: Expr) -> bool {
    arena.as_constant(expr).is_some_and(|value| value.is_zero())
}
