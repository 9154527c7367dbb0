//! Geometry of mechanisms: components of vectors, and relations that joints impose in space.
//!
//! In: expressions. Out: vectors by their components, triads, points and axes fixed in bodies, relations between them, and the rotation
//! matrix of a quaternion. Not done here: names.

mod components;
mod turn;

pub use components::Components;
pub(crate) use turn::{Rotation, Turn, difference, natural, quaternion, rotated, turned_tensor};

use crate::expr::{Arena, Binary, Expr, Triple, cross, dot, unit};
use std::collections::BTreeMap;

/// Three perpendicular unit vectors fixed in a body or in ground: x, y, and the axis z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Triad {
    /// Body; `None` for ground.
    pub body: Option<usize>,
    /// x, y and z by local components.
    pub axes: [Triple; 3],
}

impl Triad {
    /// The triad with this z axis whose x axis is the part of `toward` across it.
    pub(crate) fn along(arena: &mut Arena, z: Place, toward: Triple) -> Triad {
        let body = z.body;
        let z = unit(arena, z.local);
        let along = dot(arena, toward, z);
        let across = [0, 1, 2].map(|k| {
            let part = arena.mul(along, z[k]);
            arena.sub(toward[k], part)
        });
        let x = unit(arena, across);
        let axes = [x, cross(arena, z, x), z];
        // A vector at a right angle to an axis of the frame has no part along it, not even a rounding error.
        Triad { body, axes: axes.map(|axis| axis.map(|part| arena.snapped(part))) }
    }

    /// The columns of an orientation that is fixed in a body or in ground; `None` if it is not.
    pub(crate) fn of(arena: &mut Arena, rotations: &[Rotation]) -> Option<Triad> {
        let (body, rest) = match rotations {
            [Rotation::OfBody(body), rest @ ..] => (Some(*body), rest),
            rest => (None, rest),
        };
        let axes = natural(arena);
        let axes = rotated(arena, rest, axes);
        axes.iter().all(|axis| is_fixed(arena, *axis)).then_some(Triad { body, axes })
    }

    /// The axes in ground.
    pub(crate) fn in_ground(self, arena: &mut Arena) -> [Triple; 3] {
        match self.body {
            Some(body) => self.axes.map(|axis| arena.turned(body, axis)),
            None => self.axes,
        }
    }

    /// The triad after a quarter of a turn about z, with its x axis along y.
    pub(crate) fn quarter_turned(self, arena: &mut Arena) -> Triad {
        let [x, y, z] = self.axes;
        Triad { body: self.body, axes: [y, x.map(|part| arena.neg(part)), z] }
    }

    /// The triad after half a turn about one of its axes: that axis stays, the other two are reversed.
    pub(crate) fn half_turned(self, arena: &mut Arena, about: usize) -> Triad {
        let reversed = |(k, axis): (usize, Triple)| if k == about { axis } else { axis.map(|part| arena.neg(part)) };
        let [x, y, z] = self.axes;
        Triad { body: self.body, axes: [(0, x), (1, y), (2, z)].map(reversed) }
    }
}

/// A point or a vector fixed in a body or in ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// Body; `None` for ground.
    pub body: Option<usize>,
    /// Local components.
    pub local: Triple,
}

/// Geometric meaning of some rows of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relationship {
    /// Two points coincide: three rows.
    Coincident(Place, Place),
    /// Two axes are parallel: two rows.
    SameDirection(Triad, Triad),
    /// Two triads are parallel, each axis to its partner, which may point against it: three rows.
    SameOrientation(Triad, Triad),
    /// Two triads are equal: three rows.
    Equal(Triad, Triad),
    /// Two vectors are perpendicular: one row.
    Perpendicular(Place, Place),
    /// The second point lies on the axis through the first: two rows.
    OnLine(Triad, Place, Place),
}

impl Relationship {
    /// The two bodies.
    #[must_use]
    pub fn bodies(&self) -> [Option<usize>; 2] {
        match self {
            Relationship::SameOrientation(one, two) | Relationship::Equal(one, two) | Relationship::SameDirection(one, two) => {
                [one.body, two.body]
            }
            Relationship::Perpendicular(one, two) | Relationship::Coincident(one, two) | Relationship::OnLine(_, one, two) => {
                [one.body, two.body]
            }
        }
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        match self {
            Relationship::Coincident(..) | Relationship::SameOrientation(..) | Relationship::Equal(..) => 3,
            Relationship::SameDirection(..) | Relationship::OnLine(..) => 2,
            Relationship::Perpendicular(..) => 1,
        }
    }
}

/// An angle or a displacement of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointQuantity {
    /// Angle of the second triad against the first.
    Angle(Triad, Triad),
    /// Distance of the second point from the first, along an axis.
    Displacement(Triad, Place, Place),
}

/// Directions of two axes that a joint makes parallel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Facing {
    /// Along or against each other, whichever the declared starts are nearer to.
    #[default]
    Nearest,
    /// Along each other.
    Along,
}

/// Relations and quantities of all joints in space.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// Relations, each with its joint and the first of the joint's rows that state it.
    pub relations: Vec<(usize, usize, Relationship)>,
    /// Angles and displacements of joints, each with its expression, which is marked with its number here.
    pub quantities: Vec<(JointQuantity, Expr)>,
    /// By joint and row that make two axes perpendicular, their triads.
    pub arms: BTreeMap<(usize, usize), [Triad; 2]>,
    /// How axes are directed that joints make parallel.
    pub facing: Facing,
}

/// The angle with a given sine and cosine that is within half a turn of another.
pub(crate) fn angle_near(arena: &mut Arena, near: Expr, s: Expr, c: Expr) -> Expr {
    let (sine, cosine) = (arena.sin(near), arena.cos(near));
    let [sc, cs, cc, ss] = [(s, cosine), (c, sine), (c, cosine), (s, sine)].map(|(a, b)| arena.mul(a, b));
    let (above, below) = (arena.sub(sc, cs), arena.add(cc, ss));
    let rest = arena.binary(Binary::Atan2, above, below);
    arena.add(near, rest)
}

/// Index of the component of a vector that is farthest from zero.
pub(crate) fn longest(components: &[f64]) -> usize {
    let size = |k: usize| if components[k].is_finite() { components[k].abs() } else { 0.0 };
    (0..components.len()).fold(0, |longest, k| if size(k) > size(longest) { k } else { longest })
}

/// True if a vector depends on parameters alone.
fn is_fixed(arena: &Arena, vector: Triple) -> bool {
    vector.iter().all(|part| arena.is_fixed(*part))
}

/// Columns of the rotation matrix of a quaternion of any norm n > 0, and h = 2/n².
pub(crate) fn rotation(arena: &mut Arena, [w, x, y, z]: [Expr; 4]) -> ([Triple; 3], Expr) {
    let squares = [w, x, y, z].map(|part| arena.square(part));
    let length = arena.sum(&squares);
    let two = arena.integer(2);
    let factor = arena.div(two, length);
    let one = arena.integer(1);
    // 1 − h (b² + c²)
    let mut diagonal = |b: Expr, c: Expr| {
        let (b, c) = (arena.square(b), arena.square(c));
        let sum = arena.add(b, c);
        let part = arena.mul(factor, sum);
        arena.sub(one, part)
    };
    let [xx, yy, zz] = [diagonal(y, z), diagonal(x, z), diagonal(x, y)];
    // h (a b ± w c)
    let mut mixed = |a: Expr, b: Expr, c: Expr, is_plus: bool| {
        let (one, two) = (arena.mul(a, b), arena.mul(w, c));
        let sum = if is_plus { arena.add(one, two) } else { arena.sub(one, two) };
        arena.mul(factor, sum)
    };
    let (yx, xy) = (mixed(x, y, z, true), mixed(x, y, z, false));
    let (xz, zx) = (mixed(x, z, y, true), mixed(x, z, y, false));
    let (zy, yz) = (mixed(y, z, x, true), mixed(y, z, x, false));
    ([[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]], factor)
}

#[cfg(test)]
mod tests;
