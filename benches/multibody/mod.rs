//! Mechanisms of bodies in space as data: a tree of joints, and loops that are closed by cuts.
//!
//! A joint of the tree is a list of elementary ones after a fixed placement in the frame of the body before. The exact motion of a
//! mechanism ([`exact`]) and what other people's programs are given are made from this; our declarations and what is written by hand are
//! not.

pub mod arm;
pub mod exact;
pub mod forces;

use std::f64::consts::TAU;

use reuleaux::Real;
use reuleaux_tests::common::twofold::Twofold;
use serde_json::{Value, json};

/// A turn or a shift about an axis of the body before: 0 for x, 1 for y, 2 for z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// A turn.
    Turn(usize),
    /// A shift.
    Shift(usize),
}

/// A body and the way to it.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// The body before; ground if there is none.
    pub parent: Option<usize>,
    /// Where its joints begin in the frame of the body before, in m.
    pub place: [f64; 3],
    /// How they are turned against it: rows of the matrix.
    pub turned: [[f64; 3]; 3],
    /// Its joints, in order.
    pub joints: Vec<Joint>,
    /// The number of the coordinate of its first joint.
    pub first: usize,
    /// Its mass centre in its frame, in m.
    pub center: [f64; 3],
    /// Its mass in kg.
    pub mass: f64,
    /// Its principal moments about the mass centre, along its axes, in kg m².
    pub inertia: [f64; 3],
}

/// A point of a body, or of ground.
pub type Place = (Option<usize>, [f64; 3]);

/// What closes a loop.
#[derive(Clone, Debug)]
pub enum Cut {
    /// Two points are one: three rows.
    Meet(Place, Place),
    /// The height of a point follows a law: one row.
    Height(Place, Law),
    /// The distance of two points follows a law: one row.
    Distance(Place, Place, Law),
}

/// How a number follows time.
#[derive(Clone, Debug)]
pub enum Law {
    /// 2πt
    Turning,
    /// offset + amplitude sin(ω t + phase)
    Harmonic(f64, f64, f64, f64),
    /// Value, rate and acceleration at each thousandth of a second.
    Samples(Vec<[f64; 3]>),
}

/// Coordinates that are found together, by the numbers of their cuts.
#[derive(Clone, Debug)]
pub struct Block {
    /// Numbers of coordinates.
    pub unknowns: Vec<usize>,
    /// Numbers of cuts, with as many rows.
    pub cuts: Vec<usize>,
}

/// A mechanism as data.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Its name.
    pub name: String,
    /// Bodies after the bodies that they hang on.
    pub bodies: Vec<Body>,
    /// What closes its loops.
    pub cuts: Vec<Cut>,
    /// Coordinates that are driven.
    pub drives: Vec<(usize, Law)>,
    /// Coordinates that are found, block after block.
    pub blocks: Vec<Block>,
    /// About where the coordinates are at the beginning.
    pub start: Vec<f64>,
    /// Acceleration of free fall in m/s².
    pub gravity: [f64; 3],
}

/// No turn.
pub const STRAIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The matrix of a turn by `angle` (rad) about axis 0, 1 or 2.
#[must_use]
pub fn turn<T: Real>(axis: usize, angle: T) -> [[T; 3]; 3] {
    let (sine, cosine) = angle.sin_cos();
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = STRAIGHT.map(|row| row.map(T::of));
    (matrix[next][next], matrix[last][last]) = (cosine, cosine);
    (matrix[next][last], matrix[last][next]) = (-sine, sine);
    matrix
}

/// a b
#[must_use]
pub fn product<T: Real>(a: [[T; 3]; 3], b: [[T; 3]; 3]) -> [[T; 3]; 3] {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

/// The transpose.
#[must_use]
pub fn transposed<T: Real>(a: [[T; 3]; 3]) -> [[T; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// a v
#[must_use]
pub fn applied<T: Real>(a: [[T; 3]; 3], v: [T; 3]) -> [T; 3] {
    a.map(|row| dot(row, v))
}

fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Model {
    /// A mechanism without bodies.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// Adds a body whose mass centre is its origin, placed in the frame of the body before without a turn; `start` is one number for each
    /// joint.
    pub fn hang(&mut self, name: &str, parent: Option<usize>, joints: &[Joint], start: &[f64]) -> &mut Body {
        let first = self.start.len();
        self.start.extend(start);
        self.bodies.push(Body {
            name: name.to_owned(),
            parent,
            place: [0.0; 3],
            turned: STRAIGHT,
            joints: joints.to_vec(),
            first,
            center: [0.0; 3],
            mass: 1.0,
            inertia: [0.1; 3],
        });
        let last = self.bodies.len() - 1;
        &mut self.bodies[last]
    }

    /// All coordinates that are not driven, with all cuts, as one block.
    pub fn close(&mut self) {
        let unknowns = (0..self.start.len()).filter(|k| self.drives.iter().all(|(driven, _)| driven != k)).collect();
        self.blocks = vec![Block { unknowns, cuts: (0..self.cuts.len()).collect() }];
    }

    /// For programs in other languages.
    #[must_use]
    pub fn described(&self) -> Value {
        let joint = |joint: &Joint| match joint {
            Joint::Turn(axis) => json!(["turn", axis]),
            Joint::Shift(axis) => json!(["shift", axis]),
        };
        let body = |body: &Body| {
            json!({
                "name": body.name,
                "parent": body.parent,
                "place": body.place,
                "turned": body.turned,
                "joints": body.joints.iter().map(joint).collect::<Vec<_>>(),
                "first": body.first,
                "center": body.center,
                "mass": body.mass,
                "inertia": body.inertia,
            })
        };
        let cut = |cut: &Cut| match cut {
            Cut::Meet(a, b) => json!(["meet", a, b]),
            Cut::Height(a, law) => json!(["height", a, law.described()]),
            Cut::Distance(a, b, law) => json!(["distance", a, b, law.described()]),
        };
        json!({
            "name": self.name,
            "bodies": self.bodies.iter().map(body).collect::<Vec<_>>(),
            "cuts": self.cuts.iter().map(cut).collect::<Vec<_>>(),
            "drives": self.drives.iter().map(|(coordinate, law)| json!([coordinate, law.described()])).collect::<Vec<_>>(),
            "start": self.start,
            "gravity": self.gravity,
        })
    }
}

impl Law {
    fn described(&self) -> Value {
        match self {
            Self::Turning => json!(["turning"]),
            Self::Harmonic(offset, amplitude, omega, phase) => json!(["harmonic", offset, amplitude, omega, phase]),
            Self::Samples(samples) => json!(["samples", samples]),
        }
    }

    /// Value, rate and acceleration at `t` (s).
    #[must_use]
    pub fn at(&self, t: f64) -> [Twofold; 3] {
        let of = |value: f64| Twofold::from(value);
        match self {
            Self::Turning => {
                let tau = Twofold { high: TAU, low: 2.449_293_598_294_706_4e-16 };
                [tau * of(t), tau, Twofold::default()]
            }
            Self::Harmonic(offset, amplitude, omega, phase) => {
                let (sine, cosine) = (of(*omega) * of(t) + of(*phase)).sin_cos();
                let (amplitude, omega) = (of(*amplitude), of(*omega));
                [of(*offset) + amplitude * sine, amplitude * omega * cosine, -(amplitude * omega * omega * sine)]
            }
            Self::Samples(samples) => samples[(t * crate::STEPS as f64).round() as usize].map(Twofold::from),
        }
    }
}
