//! The motion of a mechanism in space to more digits than a double has.
//!
//! Every expression is carried with its first and second derivative in time, in numbers of twice the precision of a double. Newton's
//! method takes its corrections from doubles, and its residuals from those numbers, until they vanish; rates and accelerations are
//! refined in the same way.

use std::ops::{Add, Mul, Neg, Sub};

use reuleaux::Real;
use reuleaux::nalgebra::{DMatrix, DVector, Vector3};
use reuleaux_tests::common::twofold::Twofold;

use super::{Block, Body, Cut, Joint, Model, Place};

/// Rotation matrix by rows, mass centre, its velocity, angular velocity, its acceleration, angular acceleration.
pub type Numbers = [f64; 24];

/// Corrections of a solution, of which the first are spent on Newton's method.
const REFINEMENTS: usize = 9;

/// A value with its first and second derivative.
#[derive(Clone, Copy, Debug, Default)]
struct Jet([Twofold; 3]);

impl Jet {
    fn constant(value: f64) -> Self {
        Self([value.into(), Twofold::default(), Twofold::default()])
    }

    fn sin_cos(self) -> (Self, Self) {
        let Jet([angle, rate, acceleration]) = self;
        let (sine, cosine) = angle.sin_cos();
        let square = rate * rate;
        (
            Self([sine, cosine * rate, cosine * acceleration - sine * square]),
            Self([cosine, -(sine * rate), -(sine * acceleration + cosine * square)]),
        )
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|entry| entry * factor.into()))
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, a1, a2], [b, b1, b2]) = (self.0, other.0);
        let cross = a1 * b1;
        Self([a * b, a1 * b + a * b1, a2 * b + a * b2 + cross + cross])
    }
}

/// Columns of the rotation matrix, and the origin.
#[derive(Clone, Copy)]
struct Frame {
    axes: [[Jet; 3]; 3],
    origin: [Jet; 3],
}

impl Frame {
    fn ground() -> Self {
        let unit = |i: usize| std::array::from_fn(|k| Jet::constant(f64::from(u8::from(i == k))));
        Self { axes: [unit(0), unit(1), unit(2)], origin: [Jet::default(); 3] }
    }

    /// A vector that is fixed in the frame.
    fn vector(&self, local: [f64; 3]) -> [Jet; 3] {
        std::array::from_fn(|k| self.axes[0][k].scaled(local[0]) + self.axes[1][k].scaled(local[1]) + self.axes[2][k].scaled(local[2]))
    }

    fn point(&self, local: [f64; 3]) -> [Jet; 3] {
        let arm = self.vector(local);
        std::array::from_fn(|k| self.origin[k] + arm[k])
    }
}

/// The axis of a coordinate and a point on it, for the columns of Jacobians.
#[derive(Clone, Copy)]
struct Axis {
    joint: Joint,
    direction: Vector3<f64>,
    origin: Vector3<f64>,
}

fn doubles(vector: [Jet; 3]) -> Vector3<f64> {
    vector.map(|entry| entry.0[0].high).into()
}

/// The frames of all bodies that are asked for, and the axes of their coordinates.
struct Pose {
    frames: Vec<Option<Frame>>,
    axes: Vec<Option<Axis>>,
}

impl Pose {
    /// Bodies `wanted`, in the order of the model, with all that they hang on.
    fn of(model: &Model, coordinates: &[Jet], wanted: &[usize]) -> Self {
        let mut pose = Self { frames: vec![None; model.bodies.len()], axes: vec![None; coordinates.len()] };
        for &index in wanted {
            pose.place(model, coordinates, index);
        }
        pose
    }

    fn place(&mut self, model: &Model, coordinates: &[Jet], index: usize) {
        if self.frames[index].is_some() {
            return;
        }
        let body = &model.bodies[index];
        if let Some(parent) = body.parent {
            self.place(model, coordinates, parent);
        }
        let before = self.frame(body.parent);
        let column = |j: usize| before.vector([body.turned[0][j], body.turned[1][j], body.turned[2][j]]);
        let mut frame = Frame { axes: [column(0), column(1), column(2)], origin: before.point(body.place) };
        for (&joint, number) in body.joints.iter().zip(body.first..) {
            let (Joint::Turn(axis) | Joint::Shift(axis)) = joint;
            self.axes[number] = Some(Axis { joint, direction: doubles(frame.axes[axis]), origin: doubles(frame.origin) });
            moved(&mut frame, joint, coordinates[number]);
        }
        self.frames[index] = Some(frame);
    }

    fn frame(&self, body: Option<usize>) -> Frame {
        body.and_then(|body| self.frames[body]).unwrap_or_else(Frame::ground)
    }

    fn point(&self, (body, local): Place) -> [Jet; 3] {
        self.frame(body).point(local)
    }
}

fn moved(frame: &mut Frame, joint: Joint, by: Jet) {
    match joint {
        Joint::Shift(axis) => frame.origin = std::array::from_fn(|k| frame.origin[k] + frame.axes[axis][k] * by),
        Joint::Turn(axis) => {
            let (sine, cosine) = by.sin_cos();
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let (a, b) = (frame.axes[next], frame.axes[last]);
            frame.axes[next] = std::array::from_fn(|k| a[k] * cosine + b[k] * sine);
            frame.axes[last] = std::array::from_fn(|k| b[k] * cosine - a[k] * sine);
        }
    }
}

/// All coordinates at these times, which begin near zero and follow each other closely, and what is made of them.
pub struct Motion<'a> {
    model: &'a Model,
    coordinates: Vec<Jet>,
    last: f64,
}

impl<'a> Motion<'a> {
    /// The mechanism about where it starts.
    #[must_use]
    pub fn new(model: &'a Model) -> Self {
        Self { model, coordinates: model.start.iter().map(|&value| Jet::constant(value)).collect(), last: 0.0 }
    }

    /// Goes to `t` (s).
    pub fn follow(&mut self, t: f64) {
        for (driven, law) in &self.model.drives {
            self.coordinates[*driven] = Jet(law.at(t));
        }
        let model = self.model;
        for block in &model.blocks {
            self.close(block, t, t - self.last);
        }
        self.last = t;
    }

    /// What every body does.
    #[must_use]
    pub fn bodies(&self) -> Vec<Numbers> {
        let all: Vec<usize> = (0..self.model.bodies.len()).collect();
        let pose = Pose::of(self.model, &self.coordinates, &all);
        self.model
            .bodies
            .iter()
            .zip(&pose.frames)
            .map(|(body, frame)| precise(body, frame.as_ref().expect("a frame")).map(|entry| entry.high))
            .collect()
    }

    /// Coordinates, rates and accelerations.
    #[must_use]
    pub fn coordinates(&self) -> [Vec<f64>; 3] {
        [0, 1, 2].map(|level| self.coordinates.iter().map(|jet| jet.0[level].high).collect())
    }

    fn close(&mut self, block: &Block, t: f64, h: f64) {
        for &k in &block.unknowns {
            let Jet([value, rate, acceleration]) = self.coordinates[k];
            let guess = value.high + h * (rate.high + 0.5 * h * acceleration.high);
            self.coordinates[k] = Jet([guess.into(), rate, acceleration]);
        }
        let wanted: Vec<usize> = block.cuts.iter().flat_map(|&cut| ends(&self.model.cuts[cut])).flatten().collect();
        for level in 0..3 {
            for _ in 0..REFINEMENTS {
                let pose = Pose::of(self.model, &self.coordinates, &wanted);
                let residuals = DVector::from_vec(self.residuals(&pose, block, t).iter().map(|row| row.0[level].high).collect());
                let change = self.jacobian(&pose, block).lu().solve(&residuals).expect("a mechanism that moves");
                for (&k, change) in block.unknowns.iter().zip(change.iter()) {
                    let entry = &mut self.coordinates[k].0[level];
                    *entry = *entry - (*change).into();
                }
                if change.amax() < 1e-26 {
                    break;
                }
            }
        }
    }

    fn residuals(&self, pose: &Pose, block: &Block, t: f64) -> Vec<Jet> {
        let mut rows = Vec::new();
        for &cut in &block.cuts {
            match &self.model.cuts[cut] {
                Cut::Meet(a, b) => {
                    let (a, b) = (pose.point(*a), pose.point(*b));
                    rows.extend((0..3).map(|k| a[k] - b[k]));
                }
                Cut::Height(a, law) => rows.push(pose.point(*a)[2] - Jet(law.at(t))),
                Cut::Distance(a, b, law) => {
                    let (a, b, length) = (pose.point(*a), pose.point(*b), Jet(law.at(t)));
                    let [x, y, z] = [0, 1, 2].map(|k| a[k] - b[k]);
                    rows.push((x * x + y * y + z * z - length * length).scaled(0.5));
                }
            }
        }
        rows
    }

    fn jacobian(&self, pose: &Pose, block: &Block) -> DMatrix<f64> {
        let columns: Vec<Vec<f64>> = block.unknowns.iter().map(|&unknown| self.column(pose, block, unknown)).collect();
        DMatrix::from_fn(columns[0].len(), columns.len(), |row, column| columns[column][row])
    }

    /// Derivatives of the residuals by one coordinate.
    fn column(&self, pose: &Pose, block: &Block, unknown: usize) -> Vec<f64> {
        let speed = |(body, local): Place| {
            let is_moved = body.is_some_and(|body| self.hangs_on(body, unknown));
            let axis = pose.axes[unknown].filter(|_| is_moved);
            axis.map_or(Vector3::zeros(), |axis| match axis.joint {
                Joint::Turn(_) => axis.direction.cross(&(doubles(pose.point((body, local))) - axis.origin)),
                Joint::Shift(_) => axis.direction,
            })
        };
        let mut rows = Vec::new();
        for &cut in &block.cuts {
            match &self.model.cuts[cut] {
                Cut::Meet(a, b) => rows.extend((speed(*a) - speed(*b)).iter()),
                Cut::Height(a, _) => rows.push(speed(*a).z),
                Cut::Distance(a, b, _) => rows.push((doubles(pose.point(*a)) - doubles(pose.point(*b))).dot(&(speed(*a) - speed(*b)))),
            }
        }
        rows
    }

    fn hangs_on(&self, body: usize, coordinate: usize) -> bool {
        let own = &self.model.bodies[body];
        (own.first..own.first + own.joints.len()).contains(&coordinate)
            || own.parent.is_some_and(|parent| self.hangs_on(parent, coordinate))
    }
}

fn ends(cut: &Cut) -> [Option<usize>; 2] {
    match cut {
        Cut::Meet((a, _), (b, _)) | Cut::Distance((a, _), (b, _), _) => [*a, *b],
        Cut::Height((a, _), _) => [*a, None],
    }
}

/// What a body does, to all digits: ω and ω̇ are read from Ȧ Aᵀ and Ä Aᵀ.
fn precise(body: &Body, frame: &Frame) -> [Twofold; 24] {
    let entry = |level: usize, i: usize, j: usize| frame.axes[j][i].0[level];
    let product =
        |level: usize, i: usize, j: usize| (0..3).map(|k| entry(level, i, k) * entry(0, j, k)).fold(Twofold::default(), |a, b| a + b);
    let turning = |level: usize| [(2, 1), (0, 2), (1, 0)].map(|(i, j)| (product(level, i, j) - product(level, j, i)) * 0.5.into());
    let center = frame.point(body.center);
    let level = |k: usize| center.map(|jet| jet.0[k]);
    let rotation: [Twofold; 9] = std::array::from_fn(|k| entry(0, k / 3, k % 3));
    let mut numbers = [Twofold::default(); 24];
    let parts = [&rotation[..], &level(0), &level(1), &turning(1), &level(2), &turning(2)].concat();
    numbers.copy_from_slice(&parts);
    numbers
}

/// What all bodies do, and the rows of all cuts, with these coordinates.
pub(super) struct Moved {
    pub(super) bodies: Vec<[Twofold; 24]>,
    /// Value, rate and acceleration of each row, three for each cut.
    pub(super) rows: Vec<[Twofold; 3]>,
}

impl Moved {
    /// With coordinates that meet their cuts where points are one; other cuts have no rows.
    pub(super) fn with(model: &Model, coordinates: &[[Twofold; 3]]) -> Self {
        let all: Vec<usize> = (0..model.bodies.len()).collect();
        let coordinates: Vec<Jet> = coordinates.iter().copied().map(Jet).collect();
        let pose = Pose::of(model, &coordinates, &all);
        let bodies = model.bodies.iter().zip(&pose.frames).map(|(body, frame)| precise(body, frame.as_ref().expect("a frame"))).collect();
        let mut rows = Vec::new();
        for cut in &model.cuts {
            if let Cut::Meet(a, b) = cut {
                let (a, b) = (pose.point(*a), pose.point(*b));
                rows.extend((0..3).map(|k| (a[k] - b[k]).0));
            }
        }
        Self { bodies, rows }
    }
}
