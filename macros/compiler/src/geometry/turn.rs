//! Orientations as products of rotations, of which the last comes first.
//!
//! ```text
//! cos(θ/2) + sin(θ/2) (k_x i + k_y j + k_z k)                   quaternion of a turn by θ about the unit vector k
//! R_ij = k_i k_j (1 − cos θ) + δ_ij cos θ − ε_ijl k_l sin θ     its matrix
//! ```

use super::{Relationship, Triad, is_fixed};
use crate::expr::{Arena, Expr, Triple, combination, cross, dot};

/// A turn about a unit vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    /// The body in which the vector is fixed; `None` for ground.
    pub(crate) body: Option<usize>,
    pub(crate) axis: Triple,
    pub(crate) angle: Expr,
}

/// A factor of an orientation.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rotation {
    /// A turn.
    Turn(Turn),
    /// From the axes of a body to those of ground.
    OfBody(usize),
}

impl Rotation {
    /// The turn, if it is one.
    pub(crate) fn turn(self) -> Option<Turn> {
        match self {
            Rotation::Turn(turn) => Some(turn),
            Rotation::OfBody(_) => None,
        }
    }
}

/// Vectors after rotations.
pub(crate) fn rotated<const N: usize>(arena: &mut Arena, rotations: &[Rotation], vectors: [Triple; N]) -> [Triple; N] {
    rotations.iter().rev().fold(vectors, |vectors, rotation| match rotation {
        Rotation::Turn(turn) => {
            let axis = turn.body.map_or(turn.axis, |body| arena.turned(body, turn.axis));
            let rows = Turn { axis, ..*turn }.matrix(arena).map(|row| row.map(|part| arena.snapped(part)));
            vectors.map(|vector| rows.map(|row| dot(arena, row, vector)))
        }
        Rotation::OfBody(body) => vectors.map(|vector| {
            if is_fixed(arena, vector) {
                return arena.turned(*body, vector);
            }
            let own = natural(arena).map(|axis| arena.turned(*body, axis));
            combination(arena, vector, own)
        }),
    })
}

/// 2 tan(δ/2) n of the rotation by δ about the unit vector n that leads from the second orientation to the first; and the
/// relation that holds where this vanishes, if both orientations are fixed in bodies or in ground.
pub(crate) fn difference(arena: &mut Arena, one: &[Rotation], two: &[Rotation]) -> (Triple, Option<Relationship>) {
    let relation = match [one, two].map(|rotations| Triad::of(arena, rotations)) {
        [Some(one), Some(two)] => Some(Relationship::Equal(one, two)),
        _ => None,
    };
    let axes = natural(arena);
    let [one, two] = [one, two].map(|rotations| rotated(arena, rotations, axes));
    (rodrigues(arena, one, two), relation)
}

/// 2 Σ v_k × u_k / (1 + Σ v_k · u_k) of the axes u and v of two frames.
fn rodrigues(arena: &mut Arena, one: [Triple; 3], two: [Triple; 3]) -> Triple {
    let (unity, double) = (arena.integer(1), arena.integer(2));
    let sines = [0, 1, 2].map(|k| cross(arena, two[k], one[k]));
    let cosines = [0, 1, 2].map(|k| dot(arena, two[k], one[k]));
    let trace = arena.sum(&cosines);
    let below = arena.add(unity, trace);
    [0, 1, 2].map(|axis| {
        let sine = arena.sum(&[sines[0][axis], sines[1][axis], sines[2][axis]]);
        let above = arena.mul(double, sine);
        arena.div(above, below)
    })
}

/// The axes of a frame, in itself.
pub(crate) fn natural(arena: &mut Arena) -> [Triple; 3] {
    let (zero, one) = (arena.integer(0), arena.integer(1));
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

impl Turn {
    fn quaternion(self, arena: &mut Arena) -> [Expr; 4] {
        let two = arena.integer(2);
        let half = arena.div(self.angle, two);
        let (sine, cosine) = (arena.sin(half), arena.cos(half));
        let [x, y, z] = self.axis.map(|part| arena.mul(part, sine));
        [cosine, x, y, z]
    }

    /// The rows of the matrix.
    fn matrix(self, arena: &mut Arena) -> [Triple; 3] {
        let k = self.axis;
        let (sine, cosine, one) = (arena.sin(self.angle), arena.cos(self.angle), arena.integer(1));
        let rest = arena.sub(one, cosine);
        let mut rows = [[one; 3]; 3];
        for i in 0..3 {
            // k_i² + cos θ (1 − k_i²)
            let square = arena.square(k[i]);
            let across = arena.sub(one, square);
            let across = arena.mul(cosine, across);
            rows[i][i] = arena.add(square, across);
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            let (both, turned) = (arena.mul(k[i], k[j]), arena.mul(sine, k[l]));
            let both = arena.mul(both, rest);
            rows[i][j] = arena.sub(both, turned);
            rows[j][i] = arena.add(both, turned);
        }
        rows
    }
}

/// The unit quaternion of turns, with the real part first.
pub(crate) fn quaternion(arena: &mut Arena, turns: &[Turn]) -> [Expr; 4] {
    let parts: Vec<[Expr; 4]> = turns.iter().map(|turn| turn.quaternion(arena)).collect();
    let (zero, one) = (arena.integer(0), arena.integer(1));
    parts.into_iter().reduce(|one, two| composed(arena, one, two)).unwrap_or([one, zero, zero, zero])
}

/// The product of two rotations: the second comes first.
fn composed(arena: &mut Arena, [aw, ax, ay, az]: [Expr; 4], [bw, bx, by, bz]: [Expr; 4]) -> [Expr; 4] {
    let (a, b) = ([ax, ay, az], [bx, by, bz]);
    let (real, inner) = (arena.mul(aw, bw), dot(arena, a, b));
    let turned = cross(arena, a, b);
    let [x, y, z] = [0, 1, 2].map(|k| {
        let (left, right) = (arena.mul(aw, b[k]), arena.mul(bw, a[k]));
        let sum = arena.add(left, right);
        arena.add(sum, turned[k])
    });
    [arena.sub(real, inner), x, y, z]
}

/// R I Rᵀ of a symmetric tensor I_xx, I_yy, I_zz, I_xy, I_xz, I_yz.
pub(crate) fn turned_tensor(arena: &mut Arena, turns: &[Turn], tensor: [Expr; 6]) -> [Expr; 6] {
    turns.iter().rev().fold(tensor, |[xx, yy, zz, xy, xz, yz], turn| {
        let rows = turn.matrix(arena);
        let columns = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let once = rows.map(|row| columns.map(|column| dot(arena, row, column)));
        [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(i, j)| dot(arena, once[i], rows[j]))
    })
}
