//! Derives unknowns and equations from a model. From here on there are no joints, only their names.
//!
//! In: a [`Model`]. Out: a [`System`]: for every scalar equation Φ, its row of Φ_q, ν and γ as
//! expressions in one arena, and for every output its value, rate and acceleration. Not done
//! here: any decision on how to solve.
//!
//! ```text
//! ν = −Φ_t                 at fixed q
//! γ = −d²/ds² Φ(q + s q̇, t + s) at s = 0
//! ```

mod declared;
mod forest;
mod magnitude;
mod pattern;

use crate::diag::{Diag, SystemFact};
use crate::expr::{Arena, Derivatives, Expr, Jets, Leaf, Rate, Seed, Substitution, derivative};
use crate::model::{Model, Name, Said};
use crate::quantity::{Ambient, Axis, Dim, Role, SpeedRole};
use crate::structure::Pattern;
use std::collections::{BTreeMap, BTreeSet};

pub use declared::DeclaredEquations;
pub(crate) use magnitude::magnitude;

/// Unknowns and equations.
#[derive(Clone, Debug)]
pub struct System {
    /// All expressions.
    pub arena: Arena,
    /// Coordinates in the order of q.
    pub coordinates: Vec<Coordinate>,
    /// Speeds in the order of u.
    pub speeds: Vec<Speed>,
    /// q̇ = N(q) u, by coordinate. In the plane N is the identity.
    pub kinematics: Vec<Rate>,
    /// One equation for each row, in the order declared.
    pub equations: Vec<Equation>,
    /// Sparsity pattern: which equation contains which unknown.
    pub pattern: Pattern,
    /// Motion of each output, in the order declared.
    pub outputs: Vec<OutputMotion>,
    /// Lengths, the largest of which is the characteristic length: local coordinates of points or, if all points are origins, the
    /// lengths that joints and drives demand.
    pub lengths: Vec<Expr>,
    /// In space: the equations as declared, of which some hold by the choice of the coordinates.
    pub declared: Option<Box<DeclaredEquations>>,
    /// In space: the frame of each body in the arena.
    pub frames: Vec<usize>,
    /// In space: the joint by which the orientation of each body follows, and the body that it follows from.
    pub reached: Vec<Option<(usize, Option<usize>)>>,
}

/// One coordinate.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Index of its body in the model.
    pub body: usize,
    /// Role in the placement of the body.
    pub role: Role,
    /// Declared start value, a function of parameters.
    pub start: Option<Expr>,
    /// For a coordinate of a joint, the joint and the name of the coordinate.
    pub of_joint: Option<(usize, &'static str)>,
}

/// One speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Speed {
    /// Index of its body in the model.
    pub body: usize,
    /// Role in the motion of the body.
    pub role: SpeedRole,
}

/// Level of an equation: positions or speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// An equation between positions: Φ(q, t) = 0.
    Position {
        /// Φ
        phi: Expr,
    },
    /// An equation between speeds alone: Φ_u u = ν, which is not the derivative of any Φ.
    Velocity,
}

/// One row.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Index of its joint in the model.
    pub joint: usize,
    /// Number within the joint, from 0.
    pub row: usize,
    /// Dimension of Φ; for an equation between speeds, dimension of its integral.
    pub dim: Dim,
    /// Level of the equation.
    pub level: Level,
    /// Entries of the row of Φ_u = Φ_q N that are not identically zero, by speed.
    pub jacobian: Vec<(usize, Expr)>,
    /// ν
    pub nu: Expr,
    /// γ
    pub gamma: Expr,
}

/// Motion of an output.
#[derive(Clone, Debug)]
pub struct OutputMotion {
    /// Value, rate and acceleration of each component.
    pub components: Vec<[Expr; 3]>,
}

impl Equation {
    /// Φ of an equation between positions; `None` for an equation between speeds.
    #[must_use]
    pub fn phi(&self) -> Option<Expr> {
        match self.level {
            Level::Position { phi } => Some(phi),
            Level::Velocity => None,
        }
    }
}

/// Entries of a rotation matrix, which a state holds for each body in space.
pub(crate) const COSINES: usize = 9;

impl System {
    /// Number of entries of a state: the coordinates, and in space the rotation matrices of the bodies.
    #[must_use]
    pub fn width(&self) -> usize {
        self.coordinates.len() + COSINES * self.frames.len()
    }

    /// In space: the joints that close a loop with a joint, by the orientations of its bodies.
    pub(crate) fn loop_of(&self, joint: usize) -> BTreeSet<usize> {
        let Some(declared) = &self.declared else { return BTreeSet::new() };
        let own = declared.equations.iter().filter(|equation| equation.joint == joint);
        let bodies: BTreeSet<usize> = own.flat_map(|equation| equation.jacobian.iter().map(|(speed, _)| speed / 6)).collect();
        let mut joints = BTreeSet::new();
        for mut body in bodies {
            // What the ways of two bodies share is not in the loop.
            while let Some((joint, from)) = self.reached[body] {
                if !joints.insert(joint) {
                    joints.remove(&joint);
                }
                let Some(from) = from else { break };
                body = from;
            }
        }
        joints.remove(&joint);
        joints
    }

    /// In space: value, rate and acceleration of the entries of a body's orientation in a state. The values are the rotation matrix,
    /// row by row; the rates of the first three are ω, their accelerations ω̇.
    pub(crate) fn orientation(&self, arena: &mut Arena, body: usize) -> Vec<[Expr; 3]> {
        let zero = arena.integer(0);
        let frame = arena.frame(self.frames[body]);
        let entry = |k: usize| {
            let value = frame.columns[k % 3][k / 3];
            if k < 3 { [value, frame.velocity[k], frame.acceleration[k]] } else { [value, zero, zero] }
        };
        (0..COSINES).map(entry).collect()
    }

    /// The name of a coordinate: `crank.angle`.
    pub(crate) fn name(&self, model: &Model, coordinate: usize) -> String {
        let (owner, name) = self.owner_and_name(model, coordinate);
        format!("{owner}.{name}")
    }

    /// The name of the body or of the joint that a coordinate belongs to, and its own name.
    pub(crate) fn owner_and_name<'a>(&self, model: &'a Model, coordinate: usize) -> (&'a Name, &'static str) {
        let coordinate = &self.coordinates[coordinate];
        match coordinate.of_joint {
            Some((joint, name)) => (&model.joints[joint].name, name),
            None => (&model.bodies[coordinate.body].name, coordinate.role.name()),
        }
    }

    /// The equations of a joint of the model, which are consecutive: equations are in the order of joints.
    pub(crate) fn of_joint(&self, joint: usize) -> &[Equation] {
        let rest = &self.equations[self.first_of(joint)..];
        &rest[..rest.partition_point(|equation| equation.joint == joint)]
    }

    /// The index of the first equation of a joint.
    pub(crate) fn first_of(&self, joint: usize) -> usize {
        self.equations.partition_point(|equation| equation.joint < joint)
    }

    /// The bodies on whose speeds the equations of a joint depend, each once.
    pub(crate) fn bodies_of(&self, joint: usize) -> Vec<usize> {
        let mut bodies = Vec::new();
        for (speed, _) in self.of_joint(joint).iter().flat_map(|equation| &equation.jacobian) {
            let body = self.speeds[*speed].body;
            if !bodies.contains(&body) {
                bodies.push(body);
            }
        }
        bodies
    }
}

/// Differentiates every residual and output of a model.
pub(crate) fn assemble(model: &Model, diag: &mut Diag) -> Option<System> {
    match model.ambient {
        Ambient::Plane => in_plane(model, diag),
        Ambient::Space => in_space(model, diag),
    }
}

fn in_space(model: &Model, diag: &mut Diag) -> Option<System> {
    has_bodies(model, diag);
    let mut arena = model.arena.clone();
    no_joint_repeats_another(model, &mut arena, diag);
    if !diag.is_clean() {
        return None;
    }
    let forest::Choice { coordinates, mut rows, outputs, frames, reached } = forest::reduce(model, &mut arena);
    integrate(model, &mut arena, &coordinates, &mut rows, diag)?;
    let kinematics: Vec<Rate> = (0..coordinates.len()).map(|number| Rate::Speed(number as u32)).collect();
    let role = |role: Role| match role {
        Role::Position(axis) => SpeedRole::Linear(axis),
        Role::Displacement => SpeedRole::Linear(Axis::X),
        Role::Angle | Role::Quaternion(_) => SpeedRole::Angular(Axis::Z),
    };
    let speeds = coordinates.iter().map(|coordinate| Speed { body: coordinate.body, role: role(coordinate.role) }).collect();
    let mut by_coordinate: Vec<Derivatives> =
        (0..coordinates.len()).map(|index| Derivatives::new(Leaf::Coordinate(index as u32))).collect();
    let mut by_time = Derivatives::new(Leaf::Time);
    let mut along = Jets::along(Seed::constant_speeds(kinematics.clone()));
    let mut equations = Vec::new();
    for row in &rows {
        let mut jacobian = Vec::new();
        for leaf in arena.leaves(row.phi) {
            let Leaf::Coordinate(index) = leaf else { continue };
            jacobian.push((index as usize, by_coordinate[index as usize].of(&mut arena, row.phi)));
        }
        jacobian.retain(|(_, entry)| !arena.as_constant(*entry).is_some_and(|value| value.is_zero()));
        let rate = by_time.of(&mut arena, row.phi);
        let nu = arena.neg(rate);
        let [_, _, second] = along.of(&mut arena, row.phi);
        let gamma = arena.neg(second);
        equations.push(forest::equation(row, jacobian, nu, gamma));
    }
    let mut motion = Jets::along(Seed::motion(kinematics.clone()));
    let motions = outputs.iter().map(|parts| OutputMotion { components: parts.iter().map(|part| motion.of(&mut arena, *part)).collect() });
    let outputs = motions.collect();
    let lengths = lengths(&mut arena, model, &coordinates, &equations);
    let pattern = pattern::pattern(model, &arena, coordinates.len(), &equations);
    let declared = Some(Box::new(declared::declared(model)));
    Some(System { arena, coordinates, speeds, kinematics, equations, pattern, outputs, lengths, declared, frames, reached })
}

/// Replaces rows of velocities by the rows of positions of which they are the rates. Others are refused if they have to be solved, and
/// left out if only the declared equations are wanted.
fn integrate(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], rows: &mut Vec<forest::Row>, diag: &mut Diag) -> Option<()> {
    let mut said = Said::default();
    rows.retain_mut(|row| {
        if !row.is_velocity {
            return true;
        }
        if let Some(phi) = integral(arena, coordinates, row.phi) {
            (row.phi, row.is_velocity) = (phi, false);
            return true;
        }
        let joint = &model.joints[row.joint];
        if model.task.is_solved() && said.is_new(&joint.name) {
            let (name, of) = (joint.name.to_string(), joint.residuals.len());
            diag.refuse::<()>(&joint.name, SystemFact::Nonholonomic { joint: name, row: row.row + 1, of });
        }
        false
    });
    diag.is_clean().then_some(())
}

/// Σ a (q − q₀) − b t of a row of velocities a · u = b with constant factors; q₀ are the declared start values.
fn integral(arena: &mut Arena, coordinates: &[Coordinate], residual: Expr) -> Option<Expr> {
    let mut known = std::collections::HashMap::new();
    let residual = arena.plain(residual, &mut known);
    let (factors, side) = declared::affine(arena, residual);
    let is_fixed = |arena: &Arena, expr: Expr| arena.leaves(expr).iter().all(|leaf| matches!(leaf, Leaf::Parameter(_)));
    if !is_fixed(arena, side) || !factors.iter().all(|(_, factor)| is_fixed(arena, *factor)) {
        return None;
    }
    let time = arena.leaf(Leaf::Time);
    let way = arena.mul(side, time);
    let mut phi = arena.neg(way);
    for (number, factor) in factors {
        let q = arena.leaf(Leaf::Coordinate(number));
        let start = coordinates.get(number as usize)?.start;
        let change = start.map_or(q, |start| arena.sub(q, start));
        let term = arena.mul(factor, change);
        phi = arena.add(phi, term);
    }
    Some(phi)
}

fn in_plane(model: &Model, diag: &mut Diag) -> Option<System> {
    let mut arena = model.arena.clone();
    let (coordinates, speeds, kinematics) = (coordinates(model), speeds(model), kinematics(model));
    let mut equations = Vec::new();
    let mut by_coordinate: Vec<Derivatives> =
        (0..coordinates.len()).map(|index| Derivatives::new(Leaf::Coordinate(index as u32))).collect();
    let mut by_time = Derivatives::new(Leaf::Time);
    let mut along = Jets::along(Seed::constant_speeds(kinematics.clone()));
    for (joint, declared) in model.joints.iter().enumerate() {
        for (row, residual) in declared.residuals.iter().enumerate() {
            let mut velocity = residual.is_velocity.then_some(residual.expr);
            let mut phi = residual.expr;
            if let Some(found) = velocity.and_then(|row| integral(&mut arena, &coordinates, row)) {
                (velocity, phi) = (None, found);
            }
            if let Some(residual_row) = velocity {
                if model.task.is_solved() {
                    let (name, of) = (declared.name.to_string(), declared.residuals.len());
                    diag.refuse::<()>(&declared.name, SystemFact::Nonholonomic { joint: name, row: row + 1, of });
                }
                let (factors, nu) = declared::affine(&mut arena, residual_row);
                let jacobian = factors.into_iter().map(|(speed, entry)| (speed as usize, entry)).collect();
                let [_, first, _] = along.of(&mut arena, residual_row);
                let gamma = arena.neg(first);
                equations.push(Equation { joint, row, dim: residual.dim, level: Level::Velocity, jacobian, nu, gamma });
                continue;
            }
            let mut jacobian = Vec::new();
            for leaf in arena.leaves(phi) {
                let Leaf::Coordinate(index) = leaf else { continue };
                let entry = by_coordinate[index as usize].of(&mut arena, phi);
                by_speed(&mut arena, &mut jacobian, entry, kinematics[index as usize]);
            }
            jacobian.retain(|(_, entry)| !arena.as_constant(*entry).is_some_and(|value| value.is_zero()));
            let rate = by_time.of(&mut arena, phi);
            let nu = arena.neg(rate);
            let [_, _, second] = along.of(&mut arena, phi);
            let gamma = arena.neg(second);
            equations.push(Equation { joint, row, dim: residual.dim, level: Level::Position { phi }, jacobian, nu, gamma });
        }
    }
    let mut motion = Jets::along(Seed::motion(kinematics.clone()));
    let outputs = model
        .outputs
        .iter()
        .map(|output| OutputMotion { components: output.components.iter().map(|part| motion.of(&mut arena, *part)).collect() });
    let outputs = outputs.collect();
    let lengths = lengths(&mut arena, model, &coordinates, &equations);
    has_bodies(model, diag);
    no_joint_repeats_another(model, &mut arena, diag);
    let pattern = pattern::pattern(model, &arena, speeds.len(), &equations);
    diag.is_clean().then_some(System {
        arena,
        coordinates,
        speeds,
        kinematics,
        equations,
        pattern,
        outputs,
        lengths,
        declared: None,
        frames: Vec::new(),
        reached: Vec::new(),
    })
}

fn coordinates(model: &Model) -> Vec<Coordinate> {
    let of_body = |(body, declared): (usize, &crate::model::Body)| {
        declared
            .coordinates
            .iter()
            .map(move |coordinate| Coordinate { body, role: coordinate.role, start: coordinate.start, of_joint: None })
            .collect::<Vec<_>>()
    };
    model.bodies.iter().enumerate().flat_map(of_body).collect()
}

fn speeds(model: &Model) -> Vec<Speed> {
    (0..model.bodies.len()).flat_map(|body| SpeedRole::PLANE.map(|role| Speed { body, role })).collect()
}

/// q̇ = u: each coordinate of a body in the plane has the speed of the same number.
fn kinematics(model: &Model) -> Vec<Rate> {
    let speeds: usize = model.bodies.iter().map(|body| body.coordinates.len()).sum();
    (0..speeds).map(|speed| Rate::Speed(speed as u32)).collect()
}

/// Adds ∂Φ/∂q_c ∂q̇_c/∂u to a row of Φ_u, given `entry` = ∂Φ/∂q_c.
fn by_speed(arena: &mut Arena, row: &mut Vec<(usize, Expr)>, entry: Expr, rate: Rate) {
    let parts: Vec<(usize, Expr)> = match rate {
        Rate::Speed(speed) => vec![(speed as usize, entry)],
        Rate::Given([rate, _]) => {
            let speeds = arena.leaves(rate).into_iter().filter_map(|leaf| if let Leaf::Speed(speed) = leaf { Some(speed) } else { None });
            let speeds: Vec<u32> = speeds.collect();
            let of_speed = |speed: u32| {
                let slope = derivative(arena, rate, Leaf::Speed(speed));
                (speed as usize, arena.mul(entry, slope))
            };
            speeds.into_iter().map(of_speed).collect()
        }
    };
    for (speed, part) in parts {
        match row.iter_mut().find(|(known, _)| *known == speed) {
            Some((_, sum)) => *sum = arena.add(*sum, part),
            None => row.push((speed, part)),
        }
    }
}

/// Lengths in the declaration that determine the characteristic length.
fn lengths(arena: &mut Arena, model: &Model, coordinates: &[Coordinate], equations: &[Equation]) -> Vec<Expr> {
    let is_zero = |length: &Expr| arena.as_constant(*length).is_some_and(|value| value.is_zero());
    if !model.lengths.iter().all(is_zero) {
        return model.lengths.clone();
    }
    let all: Vec<usize> = (0..coordinates.len()).collect();
    let mut at_start = Substitution::new();
    let zero = arena.integer(0);
    at_start.replace(Leaf::Time, zero);
    let mut lengths = Vec::new();
    for equation in equations {
        let Some(phi) = equation.phi().filter(|_| [Dim::LENGTH, Dim::LENGTH.times(Dim::LENGTH)].contains(&equation.dim)) else { continue };
        let terms = magnitude(arena, phi, &all, coordinates);
        let terms = at_start.of(arena, terms);
        lengths.push(if equation.dim == Dim::LENGTH { terms } else { arena.sqrt(terms) });
    }
    lengths
}

fn has_bodies(model: &Model, diag: &mut Diag) {
    if model.bodies.is_empty() {
        diag.refuse::<()>(&model.name, SystemFact::NoBodies { name: model.name.to_string() });
    }
}

/// Reports a joint if every equation of it is an equation of earlier joints.
fn no_joint_repeats_another(model: &Model, arena: &mut Arena, diag: &mut Diag) {
    if !diag.is_clean() || !model.task.is_solved() {
        return;
    }
    let mut said = Said::default();
    let mut owners: BTreeMap<Expr, usize> = BTreeMap::new();
    for (index, joint) in model.joints.iter().enumerate() {
        let earlier: Option<Vec<usize>> = joint.residuals.iter().map(|residual| owners.get(&residual.expr).copied()).collect();
        if let Some(other) = earlier.and_then(|earlier| earlier.first().copied())
            && !joint.is_redundant
            && said.is_new(&joint.name)
        {
            let other = model.joints[other].name.to_string();
            diag.refuse::<()>(&joint.name, SystemFact::Repeats { joint: joint.name.to_string(), other });
        }
        for residual in &joint.residuals {
            owners.entry(residual.expr).or_insert(index);
            // Exchanging the sides does not change the equation.
            let exchanged = arena.neg(residual.expr);
            owners.entry(exchanged).or_insert(index);
        }
    }
}
