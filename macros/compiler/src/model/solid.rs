//! Moments of inertia of homogeneous bodies of simple shape, about their centres of mass.
//!
//! ```text
//! rod(l)          m l²/12 across, along x       disk(r)          m r²/2 about z, half of it across
//! ring(r)         m r² about z, half across     cylinder(r, l)   m r²/2 about z, m (3 r² + l²)/12 across
//! block(a, b, c)  m (b² + c²)/12 about x, …     ball(r)          2/5 m r²
//! ```

use crate::expr::{Arena, Expr};
use crate::quantity::Ambient;

/// A homogeneous body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Solid {
    /// For each axis the factors of m and of the square of each length, as quotients.
    moments: &'static [[(i64, i64); 3]],
    lengths: usize,
    /// How it is written, with the names of its lengths.
    pub(crate) call: &'static str,
}

/// Zero factor.
const NO: (i64, i64) = (0, 1);

/// How it is written, number of lengths, and moments of inertia about each axis.
type Shape = (&'static str, usize, &'static [[(i64, i64); 3]]);

/// Other words for shapes.
const SYNONYMS: [(&str, &str); 8] = [
    ("disc", "disk"),
    ("wheel", "disk"),
    ("cuboid", "block"),
    ("plate", "block"),
    ("sphere", "ball"),
    ("hoop", "ring"),
    ("bar", "rod"),
    ("beam", "rod"),
];

/// In the plane, about z.
const PLANE: [Shape; 5] = [
    ("rod(length)", 1, &[[(1, 12), NO, NO]]),
    ("disk(radius)", 1, &[[(1, 2), NO, NO]]),
    ("ring(radius)", 1, &[[(1, 1), NO, NO]]),
    ("block(a, b)", 2, &[[(1, 12), (1, 12), NO]]),
    ("ball(radius)", 1, &[[(2, 5), NO, NO]]),
];

/// In space, about x, y and z.
const SPACE: [Shape; 6] = [
    ("rod(length)", 1, &[[NO, NO, NO], [(1, 12), NO, NO], [(1, 12), NO, NO]]),
    ("disk(radius)", 1, &[[(1, 4), NO, NO], [(1, 4), NO, NO], [(1, 2), NO, NO]]),
    ("ring(radius)", 1, &[[(1, 2), NO, NO], [(1, 2), NO, NO], [(1, 1), NO, NO]]),
    ("cylinder(radius, length)", 2, &[[(1, 4), (1, 12), NO], [(1, 4), (1, 12), NO], [(1, 2), NO, NO]]),
    ("block(a, b, c)", 3, &[[NO, (1, 12), (1, 12)], [(1, 12), NO, (1, 12)], [(1, 12), (1, 12), NO]]),
    ("ball(radius)", 1, &[[(2, 5), NO, NO], [(2, 5), NO, NO], [(2, 5), NO, NO]]),
];

fn shapes(ambient: Ambient) -> &'static [Shape] {
    if ambient == Ambient::Space { &SPACE } else { &PLANE }
}

impl Solid {
    /// The shape of this name, in the plane or in space.
    pub(crate) fn named(name: &str, ambient: Ambient) -> Option<Solid> {
        let is_named = |(call, _, _): &&Shape| call.split('(').next() == Some(name);
        shapes(ambient).iter().find(is_named).map(|(call, lengths, moments)| Solid { moments, lengths: *lengths, call })
    }

    /// All shapes as they are written.
    pub(crate) fn calls(ambient: Ambient) -> impl Iterator<Item = &'static str> {
        shapes(ambient).iter().map(|(call, _, _)| *call)
    }

    /// The shape that another word means.
    pub(crate) fn meant(word: &str, ambient: Ambient) -> Option<Solid> {
        let meant = SYNONYMS.iter().find(|(other, _)| *other == word)?.1;
        Solid::named(meant, ambient)
    }

    /// Number of lengths that define the shape.
    pub(crate) fn lengths(self) -> usize {
        self.lengths
    }

    /// One moment in the plane; in space three moments, and three products of inertia, which are zero.
    pub(crate) fn inertia(self, arena: &mut Arena, mass: Expr, lengths: &[Expr]) -> Vec<Expr> {
        let moment = |arena: &mut Arena, parts: &[(i64, i64); 3]| {
            let mut sum = arena.integer(0);
            for ((over, under), length) in parts.iter().zip(lengths) {
                let (over, under, square) = (arena.integer(*over), arena.integer(*under), arena.square(*length));
                let part = arena.div(over, under);
                let term = arena.mul(part, square);
                sum = arena.add(sum, term);
            }
            arena.mul(mass, sum)
        };
        let mut inertia: Vec<Expr> = self.moments.iter().map(|parts| moment(arena, parts)).collect();
        if inertia.len() == 3 {
            let zero = arena.integer(0);
            inertia.resize(6, zero);
        }
        inertia
    }
}
