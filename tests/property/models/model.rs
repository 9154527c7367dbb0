//! A declaration built item by item, together with all positions at t = 0.

use fastrand::Rng;
use std::fmt::Write;

/// A vector in metres.
pub(super) type Vector = [f64; 2];

pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

/// The vector rotated anticlockwise by an angle in radians.
pub(super) fn turned([x, y]: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// Vector from one position to another.
pub(super) fn way(from: Vector, to: Vector) -> Vector {
    [to[0] - from[0], to[1] - from[1]]
}

pub(super) fn length([x, y]: Vector) -> f64 {
    x.hypot(y)
}

/// A number between two others.
pub(super) fn between(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.f64()
}

/// A random entry of a list.
pub(super) fn one<'a, T>(rng: &mut Rng, many: &'a [T]) -> &'a T {
    &many[rng.usize(..many.len())]
}

/// Kind of an item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sort {
    Body,
    Joint,
    Drive,
    /// A parameter, a loop, a component, a part or ground, which are not changed.
    Other,
}

/// An item of the declaration.
#[derive(Clone, Debug)]
pub(super) struct Item {
    pub(super) sort: Sort,
    pub(super) name: String,
    /// Text of the whole item.
    pub(super) text: String,
    /// Bodies that it concerns.
    pub(super) bodies: Vec<usize>,
    /// True if another item mentions its name.
    pub(super) is_used: bool,
}

/// A body; the first one is ground.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// Path of the body, such as `dyad3.first`.
    pub(super) path: String,
    pub(super) origin: Vector,
    pub(super) angle: f64,
    /// Bodies whose motion it follows.
    pub(super) follows: Vec<usize>,
}

/// A point to which elements can be attached.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) path: String,
    pub(super) body: usize,
    /// Position at t = 0.
    pub(super) at: Vector,
}

/// A mechanism under construction.
#[derive(Clone, Debug, Default)]
pub(super) struct Model {
    pub(super) items: Vec<Item>,
    pub(super) bodies: Vec<Body>,
    pub(super) places: Vec<Place>,
    /// True if every body declares its position at t = 0; otherwise the compiler must find undeclared positions.
    pub(super) says_where: bool,
    /// Number of names given so far.
    pub(super) named: usize,
}

impl Model {
    /// A new name that is not the beginning of another one.
    pub(super) fn name(&mut self, rng: &mut Rng, words: &[&str]) -> String {
        self.named += 1;
        format!("{}{:03}", one(rng, words), self.named)
    }

    /// A length as text: in some unit, or as a parameter of its own.
    pub(super) fn length(&mut self, rng: &mut Rng, metres: f64) -> String {
        let (unit, worth) = *one(rng, &[("mm", 1e-3), ("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 0.0254)]);
        let written = format!("{:.7}{unit}", metres / worth);
        if rng.u8(..4) > 0 {
            return written;
        }
        let name = self.name(rng, &["length", "radius", "reach", "offset"]);
        self.item(Sort::Other, &name, &format!("param {name}: Length = {written};"), &[]);
        name
    }

    /// A pair of lengths in parentheses.
    pub(super) fn pair(&mut self, rng: &mut Rng, [x, y]: Vector) -> String {
        let (x, y) = (self.length(rng, x), self.length(rng, y));
        format!("({x}, {y})")
    }

    pub(super) fn item(&mut self, sort: Sort, name: &str, text: &str, bodies: &[usize]) {
        self.items.push(Item { sort, name: name.to_owned(), text: text.to_owned(), bodies: bodies.to_vec(), is_used: false });
    }

    /// `joint name = constraint;`
    pub(super) fn joint(&mut self, rng: &mut Rng, constraint: &str, bodies: &[usize]) -> String {
        let name = self.name(rng, &["pin", "hinge", "joint_", "seat", "guide", "J"]);
        self.item(Sort::Joint, &name, &format!("joint {name} = {constraint};"), bodies);
        name
    }

    /// `drive name = constraint;`
    pub(super) fn drive(&mut self, rng: &mut Rng, constraint: &str, bodies: &[usize]) {
        let name = self.name(rng, &["motor", "input", "push", "law"]);
        self.item(Sort::Drive, &name, &format!("drive {name} = {constraint};"), bodies);
    }

    /// Adds a body with a known position; its declaration is an item of its own.
    pub(super) fn body(&mut self, path: &str, origin: Vector, angle: f64, follows: &[usize]) -> usize {
        self.bodies.push(Body { path: path.to_owned(), origin, angle, follows: follows.to_vec() });
        self.bodies.len() - 1
    }

    /// Adds a point of a body, by its name and its position in the body's frame.
    pub(super) fn place(&mut self, body: usize, name: &str, local: Vector) {
        let Body { path, origin, angle, .. } = &self.bodies[body];
        let (path, at) = (format!("{path}.{name}"), sum(*origin, turned(local, *angle)));
        self.places.push(Place { path, body, at });
    }

    /// These bodies and all bodies that move with them.
    pub(super) fn carried(&self, bodies: &[usize]) -> Vec<String> {
        let mut moves = vec![false; self.bodies.len()];
        for (index, body) in self.bodies.iter().enumerate().skip(1) {
            moves[index] = bodies.contains(&index) || body.follows.iter().any(|followed| moves[*followed]);
        }
        self.bodies.iter().zip(moves).filter(|(_, moves)| *moves).map(|(body, _)| body.path.clone()).collect()
    }

    /// The whole mechanism, one item per line.
    pub(super) fn declaration(&self) -> String {
        // Most of these linkages cannot make a full turn.
        let mut text = "#[closure(start)]\npub mechanism Random {\n".to_owned();
        for item in &self.items {
            let _ = writeln!(text, "    {}", item.text);
        }
        text + "}\n"
    }
}
