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

use super::lookup::Lookup;
use super::{Arena, Expr, Leaf, Mark, Node};
use std::collections::BTreeMap;

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
    /// τ by coordinate, for the coordinates on which the orientation of the frame depends, and by turn, for the bodies that are free to
    /// turn on which it depends.
    pub turns: Vec<(Leaf, Triple)>,
    /// Reference frame of its rotation; `None` for ground.
    pub against: Option<usize>,
    /// Coordinates of its rotation relative to that frame.
    pub own: Vec<Leaf>,
}

/// Three speeds that are the components of ω.
#[derive(Clone, Copy, Debug)]
pub struct Spin {
    /// Number of the first.
    pub first: u32,
    /// The axes along which the components are.
    pub axes: SpinAxes,
}

/// Axes along which ω has its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SpinAxes {
    /// Those of the frame itself.
    Own,
    /// Those of ground.
    Ground,
    /// Those of another frame, whose own spin is in its own axes.
    Of(usize),
}

/// The frames of an arena, and the vectors fixed in them.
#[derive(Clone, Debug, Default)]
pub(super) struct Frames {
    frames: Vec<Frame>,
    vectors: Vec<FixedVector>,
    /// For frames whose speeds are the components of ω.
    spins: BTreeMap<usize, Spin>,
    // Only looked up, never iterated.
    numbers: Lookup<(usize, Triple), u32>,
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
    pub(crate) fn add_frame(&mut self, frame: Frame) -> usize {
        self.frames.frames.push(frame);
        self.frames.frames.len() - 1
    }

    /// Adds a frame that is free to turn, whose speeds are components of ω. The coordinates of the same numbers stand for turns about their
    /// axes.
    ///
    /// ```text
    /// ω = B w,    ω̇ = B (ẇ + ω_B × w)        B: the axes, ω_B: their own spin; the product is zero where they turn with the frame
    /// ```
    pub(crate) fn add_spinning_frame(&mut self, columns: [Triple; 3], Spin { first, axes }: Spin, own: Vec<Leaf>) -> usize {
        let none = [self.integer(0); 3];
        let frame = Frame {
            columns,
            velocity: none,
            acceleration: none,
            acceleration_at_constant_speeds: none,
            turns: Vec::new(),
            against: None,
            own,
        };
        let number = self.add_frame(frame);
        self.frames.spins.insert(number, Spin { first, axes });
        let directions = self.directions_of(number, axes);
        let [speeds, changes] = [Leaf::Speed, Leaf::Acceleration].map(|leaf| [0, 1, 2].map(|k| self.leaf(leaf(first + k))));
        let swing = self.swing(axes, speeds);
        let whole = [0, 1, 2].map(|k| self.add(changes[k], swing[k]));
        let [velocity, acceleration, acceleration_at_constant_speeds] =
            [speeds, whole, swing].map(|components| combination(self, components, directions));
        let turns = (0..).zip(directions).map(|(k, axis)| (Leaf::Coordinate(first + k), axis)).collect();
        let frame = &mut self.frames.frames[number];
        *frame = Frame { velocity, acceleration, acceleration_at_constant_speeds, turns, ..frame.clone() };
        number
    }

    /// Axes of ground or of a frame, by components in ground.
    pub(crate) fn directions_of(&mut self, own: usize, axes: SpinAxes) -> [Triple; 3] {
        let (zero, one) = (self.integer(0), self.integer(1));
        let unit = |axis: usize| [0, 1, 2].map(|k| if k == axis { one } else { zero });
        [0, 1, 2].map(|axis| match axes {
            SpinAxes::Ground => unit(axis),
            SpinAxes::Own => self.turned(own, unit(axis)),
            SpinAxes::Of(frame) => self.turned(frame, unit(axis)),
        })
    }

    /// ω_B × w of a vector by its components along axes that turn with ω_B; zero where ω_B is w itself.
    fn swing(&mut self, axes: SpinAxes, components: Triple) -> Triple {
        let SpinAxes::Of(frame) = axes else { return [self.integer(0); 3] };
        let Some(Spin { first, .. }) = self.spin(frame) else { return [self.integer(0); 3] };
        let turning = [0, 1, 2].map(|k| self.leaf(Leaf::Speed(first + k)));
        cross(self, turning, components)
    }

    /// The turns of a body about the axes of ground, each with its axis.
    pub(crate) fn turns_about_ground(&mut self, body: usize) -> [(Leaf, Triple); 3] {
        let (zero, one) = (self.integer(0), self.integer(1));
        let leaves = Leaf::turns_of(body);
        [0, 1, 2].map(|axis| (leaves[axis], [0, 1, 2].map(|other| if other == axis { one } else { zero })))
    }

    /// A frame by its number.
    #[must_use]
    pub fn frame(&self, number: usize) -> &Frame {
        &self.frames.frames[number]
    }

    /// The speeds of a frame that are components of ω, if it has such speeds.
    #[must_use]
    pub(crate) fn spin(&self, frame: usize) -> Option<Spin> {
        self.frames.spins.get(&frame).copied()
    }

    /// The number of the first of three speeds that are ω in the axes of the frame itself, if it has such speeds.
    fn own_spin(&self, frame: usize) -> Option<u32> {
        self.spin(frame).filter(|spin| spin.axes == SpinAxes::Own).map(|spin| spin.first)
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

    /// The component of a vector along an axis of ground, if it is constant.
    pub(super) fn constant_component(&self, vector: u32, axis: u8) -> Option<Expr> {
        let component = self.frames.vectors[vector as usize].components[usize::from(axis)];
        self.as_constant(component).map(|_| component)
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
        let leaves = self.leaves_of(&components);
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
        if let Some((local, own)) = self.in_spinning_frame(vector, frame) {
            let Some(k) = own.iter().position(|leaf| *leaf == by) else { return self.integer(0) };
            let change = self.crossed_by_axis(k, local);
            return self.turned(frame, change)[usize::from(axis)];
        }
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
        if let Some((local, _)) = self.in_spinning_frame(vector, frame) {
            return self.spinning_with(frame, local, axis, speeds_change);
        }
        let components = self.components(vector);
        let first = cross(self, velocity, components);
        let acceleration = if speeds_change { acceleration } else { acceleration_at_constant_speeds };
        let along = cross(self, acceleration, components);
        let inward = cross(self, velocity, first);
        let axis = usize::from(axis);
        [first[axis], self.add(along[axis], inward[axis])]
    }

    /// Local components of a vector that is fixed in a frame with speeds of its own, and the coordinates of the same numbers.
    fn in_spinning_frame(&self, vector: u32, moving: usize) -> Option<(Triple, [Leaf; 3])> {
        let first = self.own_spin(moving)?;
        let FixedVector { frame, local, .. } = self.frames.vectors[vector as usize];
        (frame == moving).then_some((local, [0, 1, 2].map(|k| Leaf::Coordinate(first + k))))
    }

    /// e × s
    fn crossed_by_axis(&mut self, axis: usize, local: Triple) -> Triple {
        let (zero, one) = (self.integer(0), self.integer(1));
        cross(self, [0, 1, 2].map(|k| if k == axis { one } else { zero }), local)
    }

    /// A (ω × s) and A (ω̇ × s + ω × (ω × s)) of one component, with ω in the axes of the frame.
    fn spinning_with(&mut self, frame: usize, local: Triple, axis: u8, speeds_change: bool) -> [Expr; 2] {
        let (columns, first) = (self.frames.frames[frame].columns, self.own_spin(frame).unwrap_or(0));
        let [speed, change] = [Leaf::Speed, Leaf::Acceleration].map(|leaf| [0, 1, 2].map(|k| self.leaf(leaf(first + k))));
        let along = cross(self, speed, local);
        let mut second = cross(self, speed, along);
        if speeds_change {
            let tangential = cross(self, change, local);
            second = [0, 1, 2].map(|k| self.add(tangential[k], second[k]));
        }
        let across = columns.map(|column| column[usize::from(axis)]);
        [along, second].map(|vector| dot(self, vector, across))
    }

    /// The expression without marks, in the same arena.
    pub(crate) fn plain(&mut self, root: Expr, known: &mut Lookup<Expr, Expr>) -> Expr {
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
