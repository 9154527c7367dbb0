//! Frames that turn in space, and vectors fixed in them.
//!
//! ```text
//! v = A s            s: components in the frame, constant in time
//! v̇ = ω × v
//! v̈ = ω̇ × v + ω × (ω × v)
//! ∂v/∂q = τ × v      τ: the turn of the frame with the coordinate q
//! ```
//!
//! A vector fixed in a frame is differentiated as a whole by these rules, and only then written as scalars.

use super::{Arena, Expr, Leaf, Mark, Node};
use std::collections::{BTreeSet, HashMap};

/// Three components along the axes of ground or of a frame.
pub type Triple = [Expr; 3];

/// A frame that rotates in space.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The columns of A: the axes of the frame, by components in ground.
    pub columns: [Triple; 3],
    /// ω in ground.
    pub velocity: Triple,
    /// ω̇ in ground.
    pub acceleration: Triple,
    /// ω̇ at constant speeds.
    pub acceleration_at_constant_speeds: Triple,
    /// τ by coordinate, for the coordinates on which the orientation of the frame depends.
    pub turns: Vec<(Leaf, Triple)>,
    /// Reference frame of its rotation; `None` for ground.
    pub against: Option<usize>,
    /// Coordinates of its rotation relative to that frame.
    pub own: Vec<Leaf>,
}

/// The frames of an arena, and the vectors fixed in them.
#[derive(Clone, Debug, Default)]
pub(super) struct Frames {
    frames: Vec<Frame>,
    vectors: Vec<FixedVector>,
    // Only looked up, never iterated.
    numbers: HashMap<(usize, Triple), u32>,
}

/// A vector fixed in a frame.
#[derive(Clone, Copy, Debug)]
struct FixedVector {
    frame: usize,
    local: Triple,
    /// Frame in which the vector is fixed; `None` if it is constant.
    moving: Option<usize>,
    /// Components in ground.
    components: Triple,
}

impl Arena {
    /// Adds a frame; returns its number.
    pub fn add_frame(&mut self, frame: Frame) -> usize {
        self.frames.frames.push(frame);
        self.frames.frames.len() - 1
    }

    /// A frame by its number.
    #[must_use]
    pub fn frame(&self, number: usize) -> &Frame {
        &self.frames.frames[number]
    }

    /// True if there are frames that turn in space.
    #[must_use]
    pub fn is_spatial(&self) -> bool {
        !self.frames.frames.is_empty()
    }

    /// Frame and local components of a vector.
    #[must_use]
    pub fn vector(&self, number: u32) -> (usize, Triple) {
        let FixedVector { frame, local, .. } = self.frames.vectors[number as usize];
        (frame, local)
    }

    /// A s: a vector fixed in a frame, by its components in ground.
    pub fn turned(&mut self, frame: usize, local: Triple) -> Triple {
        let next = self.frames.vectors.len() as u32;
        let vector = *self.frames.numbers.entry((frame, local)).or_insert(next);
        if vector == next {
            let (moving, components) = self.motion_of(frame, local);
            self.frames.vectors.push(FixedVector { frame, local, moving, components });
        }
        self.components(vector)
    }

    /// Components of a vector, and the frame in which it is fixed: a vector along the axis of a joint is fixed in both bodies, so the
    /// reference frame is taken.
    fn motion_of(&mut self, frame: usize, local: Triple) -> (Option<usize>, Triple) {
        let columns = self.frames.frames[frame].columns;
        let components = combination(self, local, columns);
        let leaves: BTreeSet<Leaf> = components.iter().flat_map(|component| self.leaves(*component)).collect();
        let mut moving = Some(frame);
        while let Some(frame) = moving {
            let Frame { against, own, .. } = &self.frames.frames[frame];
            if own.iter().any(|leaf| leaves.contains(leaf)) {
                break;
            }
            moving = *against;
        }
        (moving, components)
    }

    /// The components of a vector in ground.
    fn components(&mut self, vector: u32) -> Triple {
        let FixedVector { components, moving, .. } = self.frames.vectors[vector as usize];
        [0, 1, 2].map(|axis: u8| {
            let value = components[usize::from(axis)];
            if moving.is_none() || self.as_constant(value).is_some() {
                return value;
            }
            self.build(Node::Marked { mark: Mark::Turned { vector, axis }, value })
        })
    }

    /// ∂v/∂q of one component, where q is a coordinate or a turn.
    pub(super) fn turned_by(&mut self, vector: u32, axis: u8, by: Leaf) -> Expr {
        let Some(frame) = self.frames.vectors[vector as usize].moving else { return self.integer(0) };
        let turn = self.frames.frames[frame].turns.iter().find(|(leaf, _)| *leaf == by).map(|(_, turn)| *turn);
        match turn {
            Some(turn) => {
                let components = self.components(vector);
                cross(self, turn, components)[usize::from(axis)]
            }
            None => self.integer(0),
        }
    }

    /// v̇ and v̈ of one component.
    pub(super) fn turning_with(&mut self, vector: u32, axis: u8, speeds_change: bool) -> [Expr; 2] {
        let Some(frame) = self.frames.vectors[vector as usize].moving else { return [self.integer(0); 2] };
        let Frame { velocity, acceleration, acceleration_at_constant_speeds, .. } = self.frames.frames[frame];
        let components = self.components(vector);
        let first = cross(self, velocity, components);
        let acceleration = if speeds_change { acceleration } else { acceleration_at_constant_speeds };
        let along = cross(self, acceleration, components);
        let inward = cross(self, velocity, first);
        let axis = usize::from(axis);
        [first[axis], self.add(along[axis], inward[axis])]
    }

    /// The expression without marks, in the same arena.
    pub(crate) fn plain(&mut self, root: Expr, known: &mut HashMap<Expr, Expr>) -> Expr {
        for expr in self.reachable_until(&[root], |e| known.contains_key(&e)) {
            let node = *self.node(expr);
            let children: Vec<Expr> = node.children().map(|child| known[&child]).collect();
            let plain = if let Node::Marked { .. } = node { children[0] } else { self.with_children(expr, &children) };
            known.insert(expr, plain);
        }
        known[&root]
    }
}

/// a × b
pub fn cross(arena: &mut Arena, a: Triple, b: Triple) -> Triple {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| {
        let (left, right) = (arena.mul(a[i], b[j]), arena.mul(a[j], b[i]));
        arena.sub(left, right)
    })
}

/// a₁ v₁ + a₂ v₂ + a₃ v₃
pub fn combination(arena: &mut Arena, a: Triple, vectors: [Triple; 3]) -> Triple {
    [0, 1, 2].map(|axis| dot(arena, a, vectors.map(|vector| vector[axis])))
}

/// v/|v|
pub fn unit(arena: &mut Arena, v: Triple) -> Triple {
    let square = dot(arena, v, v);
    let length = arena.sqrt(square);
    v.map(|part| arena.div(part, length))
}

/// a · b
pub fn dot(arena: &mut Arena, a: Triple, b: Triple) -> Expr {
    let products = [0, 1, 2].map(|axis| arena.mul(a[axis], b[axis]));
    let zero = arena.integer(0);
    let terms: Vec<Expr> = products.into_iter().filter(|product| *product != zero).collect();
    arena.sum(&terms)
}
