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

mod balance;
mod declared;
mod directions;
mod dynamics;
mod forest;
mod in_space;
mod integral;
mod loads;
mod magnitude;
mod parallel;
mod pattern;
mod pieces;
mod pins;
mod rows;
mod spin_axes;
mod spins;

use crate::diag::{Diag, SystemFact};
use crate::expr::{Arena, Expr, Jets, Leaf, Seed};
use crate::model::{Model, Name, Output, Said};
use crate::quantity::{Ambient, Axis, Dim, Role, SpeedRole};
use crate::structure::Pattern;
use crate::syntax::ast::Task;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

pub use balance::Balance;
pub use declared::DeclaredEquations;
pub use in_space::{FurtherAngle, InSpace};
pub use loads::{LoadEquations, LoadRow};
pub(crate) use magnitude::magnitude;
pub(crate) use pattern::{deciding, has_choices};
pub(crate) use rows::coordinates_in;
use rows::{Differentiation, Row};
pub use spins::EquationsBySpins;

/// Unknowns and equations.
#[derive(Clone, Debug)]
pub struct System {
    /// All expressions.
    pub arena: Arena,
    /// Coordinates in the order of q.
    pub coordinates: Vec<Coordinate>,
    /// Speeds in the order of u.
    pub speeds: Vec<Speed>,
    /// One equation for each row, in the order declared.
    pub equations: Vec<Equation>,
    /// Equations between speeds alone, of joints and of freedoms, where freedoms are integrated.
    pub of_speeds: Vec<Equation>,
    /// Forces by the speeds, where freedoms are integrated.
    pub balance: Option<Balance>,
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
    /// Forces that joints and drives have to supply, if there are masses or forces.
    pub loads: Option<LoadEquations>,
    /// The forest of bodies in space; empty in the plane.
    pub space: InSpace,
    /// Equations of motion by ω in the axes of the bodies that are free to turn, if forces decide the motion and there are such bodies.
    pub by_spins: Option<EquationsBySpins>,
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
    /// Coordinates that Φ contains without having a derivative by them, as in a condition.
    pub read: Vec<usize>,
    /// ν
    pub nu: Expr,
    /// γ
    pub gamma: Expr,
    /// True if it holds at the start only: it belongs to a freedom.
    pub is_initial: bool,
}

/// Motion of an output.
#[derive(Clone, Debug)]
pub struct OutputMotion {
    /// Value, rate and acceleration of each component; no acceleration, but zero, if the output contains velocities.
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

/// Entries of one of its rows.
const ROW: usize = 3;

/// Number of an entry of the rotation matrix of a body, counted from the first matrix.
pub(crate) fn cosine(body: usize, row: usize, column: usize) -> usize {
    COSINES * body + ROW * row + column
}

impl System {
    /// Number of entries of a state: the coordinates, and in space the rotation matrices of the bodies.
    #[must_use]
    pub fn width(&self) -> usize {
        self.coordinates.len() + COSINES * self.frames.len()
    }

    /// The entries of a state that are the rotation matrix of a body in space.
    pub(crate) fn entries_of(&self, body: usize) -> Range<usize> {
        let first = self.coordinates.len() + COSINES * body;
        first..first + COSINES
    }

    /// The equations as declared, in the order of joints, without those of freedoms, which hold at the start only.
    pub(crate) fn constraints(&self) -> Vec<Equation> {
        let of_joint = |equation: &&Equation| !equation.is_initial;
        match &self.declared {
            Some(declared) => declared.equations.iter().filter(of_joint).cloned().collect(),
            None => {
                let mut all: Vec<Equation> = self.equations.iter().chain(&self.of_speeds).filter(of_joint).cloned().collect();
                all.sort_by_key(|equation| equation.joint);
                all
            }
        }
    }

    /// In space: the joints that close a loop with a joint, by the orientations of its bodies.
    pub(crate) fn loop_of(&self, joint: usize) -> BTreeSet<usize> {
        let Some(declared) = &self.declared else { return BTreeSet::new() };
        let own = declared.equations.iter().filter(|equation| equation.joint == joint);
        let bodies: BTreeSet<usize> =
            own.flat_map(|equation| equation.jacobian.iter().map(|(speed, _)| Ambient::Space.body_of(*speed))).collect();
        let mut joints = BTreeSet::new();
        for mut body in bodies {
            // Joints on the ways of both bodies are not in the loop.
            while let Some((joint, from)) = self.space.reached[body] {
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
        let (frame, cosines) = (arena.frame(self.frames[body]), self.cosines(body));
        let entry = |(k, value): (usize, Expr)| if k < 3 { [value, frame.velocity[k], frame.acceleration[k]] } else { [value, zero, zero] };
        cosines.into_iter().enumerate().map(entry).collect()
    }

    /// In space: the rotation matrix of a body, row by row.
    pub(crate) fn cosines(&self, body: usize) -> Vec<Expr> {
        let frame = self.arena.frame(self.frames[body]);
        (0..COSINES).map(|k| frame.columns[k % 3][k / 3]).collect()
    }

    /// The number of the speed that is the rate of each coordinate.
    pub(crate) fn rates(&self) -> Vec<Option<u32>> {
        rates(self.coordinates.len())
    }

    /// The name of a coordinate: `crank.angle`.
    pub(crate) fn name(&self, model: &Model, coordinate: usize) -> String {
        let (owner, name) = self.owner_and_name(model, coordinate);
        let Coordinate { body, role, of_joint, .. } = &self.coordinates[coordinate];
        let marks = model.sketch.axes.iter().chain(&model.sketch.points);
        match of_joint {
            // Two angles have names in a universal joint only.
            Some((joint, name)) if name.starts_with("angle_") && model.joints[*joint].kind != "universal" => {
                format!("{}.orientation", model.bodies[*body].name)
            }
            // A point or an axis of the same name hides it.
            None if role.is_position() && marks.into_iter().any(|mark| mark.at.body == Some(*body) && mark.name == name) => {
                format!("{owner}.position.{name}")
            }
            _ => format!("{owner}.{name}"),
        }
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
    has_bodies(model, diag)?;
    directions::angles_are_of_one_direction(model, diag);
    if !diag.is_clean() {
        return None;
    }
    let mut arena = model.arena.clone();
    let choice = match model.ambient {
        Ambient::Plane => in_plane(model, &mut arena),
        Ambient::Space => forest::reduce(model, &mut arena, forest::FreeSpeeds::OfQuaternion),
    };
    let Choice { mut coordinates, mut rows, outputs, frames, space, balance, loads } = choice;
    rows::integrate(model, &mut arena, &coordinates, &mut rows, diag);
    rows::begin_at_start(model, &mut arena, &coordinates, &mut rows);
    let is_motion = model.task == Task::Motion;
    let is_apart = |row: &Row| row.is_velocity && (is_motion || model.ambient == Ambient::Space);
    // Without freedoms the declared equations have them.
    let is_free = is_motion && coordinates.iter().any(|coordinate| matches!(coordinate.role, Role::Quaternion(_)));
    let at_level: Vec<bool> = rows.iter().map(|row| row.is_velocity).collect();
    let (mut of_speeds, mut rows): (Vec<Row>, Vec<Row>) = rows.into_iter().partition(is_apart);
    of_speeds.retain(|_| is_motion);
    let rates = rates(coordinates.len());
    let columns = (0..coordinates.len() as u32).map(Leaf::Coordinate);
    let mut derivatives = Differentiation::new(columns, Seed::constant_speeds(rates.clone()), 0);
    let mut equations = derivatives.of_all(&mut arena, &rows);
    let of_speeds = derivatives.of_all(&mut arena, &of_speeds);
    if !of_speeds.is_empty() {
        rows = pins::pins(model, &mut arena, &mut coordinates, [&equations, &of_speeds]);
        equations.extend(derivatives.of_all(&mut arena, &rows));
    }
    let by_spins = is_free.then(|| spins::equations(model, &mut arena, &coordinates, &at_level));
    let outputs = motions(model, &mut arena, &outputs, Seed::motion(rates));
    let lengths = lengths(&mut arena, model, &coordinates, &equations);
    no_joint_repeats_another(model, &mut arena, diag);
    if !diag.is_clean() {
        return None;
    }
    let pattern = pattern::pattern(model, &arena, coordinates.len(), &equations);
    let (declared, loads) = match model.ambient {
        Ambient::Plane => (None, LoadEquations::in_plane(model, &mut arena, equations.iter().chain(&of_speeds))),
        Ambient::Space => {
            let loads = loads.map(|loads| loads.with_rates(model, &mut arena, &equations));
            (Some(Box::new(declared::declared(model))), loads)
        }
    };
    slices_have_loads(model, loads.is_some(), diag)?;
    let speeds = coordinates.iter().map(|coordinate| Speed { body: coordinate.body, role: speed_of(coordinate.role) }).collect();
    Some(System {
        arena,
        coordinates,
        speeds,
        equations,
        of_speeds,
        balance,
        pattern,
        outputs,
        lengths,
        declared,
        frames,
        loads,
        space,
        by_spins,
    })
}

/// Differentiates the components of the outputs.
fn motions(model: &Model, arena: &mut Arena, outputs: &[Vec<Expr>], seed: Seed) -> Vec<OutputMotion> {
    let mut jets = Jets::along(seed);
    let mut motion = |part: &Expr, output: &Output| {
        let [value, rate, acceleration] = jets.of(arena, *part);
        // The seed has no derivatives of accelerations.
        [value, rate, if output.derivatives == 1 { arena.integer(0) } else { acceleration }]
    };
    let all = outputs.iter().zip(&model.outputs);
    all.map(|(parts, output)| OutputMotion { components: parts.iter().map(|part| motion(part, output)).collect() }).collect()
}

/// The solved form: unknowns, and rows and outputs in terms of them.
struct Choice {
    coordinates: Vec<Coordinate>,
    /// In the order of joints.
    rows: Vec<Row>,
    /// Components of the outputs.
    outputs: Vec<Vec<Expr>>,
    /// In space: the frame of each body in the arena.
    frames: Vec<usize>,
    space: InSpace,
    /// Forces by the rates of the unknowns, where they decide the motion.
    balance: Option<Balance>,
    /// In space: the equations of the loads.
    loads: Option<LoadEquations>,
}

/// In the plane the unknowns are the coordinates of the bodies.
fn in_plane(model: &Model, arena: &mut Arena) -> Choice {
    Choice {
        balance: (model.task == Task::Motion).then(|| Balance::declared(model, arena, &[])),
        coordinates: coordinates(model),
        rows: Row::declared(model).collect(),
        outputs: model.outputs.iter().map(|output| output.components.clone()).collect(),
        frames: Vec::new(),
        space: InSpace::default(),
        loads: None,
    }
}

/// q̇ = u: the rate of each coordinate is the speed of the same number.
fn rates(coordinates: usize) -> Vec<Option<u32>> {
    (0..coordinates as u32).map(Some).collect()
}

/// The role of the rate of a coordinate.
fn speed_of(role: Role) -> SpeedRole {
    match role {
        Role::Position(axis) => SpeedRole::Linear(axis),
        Role::Displacement => SpeedRole::Linear(Axis::X),
        Role::Angle | Role::Quaternion(_) => SpeedRole::Angular(Axis::Z),
    }
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

/// Lengths in the declaration that determine the characteristic length.
fn lengths(arena: &mut Arena, model: &Model, coordinates: &[Coordinate], equations: &[Equation]) -> Vec<Expr> {
    let is_zero = |length: &Expr| arena.as_constant(*length).is_some_and(|value| value.is_zero());
    if !model.lengths.iter().all(is_zero) {
        return model.lengths.clone();
    }
    let all: Vec<usize> = (0..coordinates.len()).collect();
    let mut at_start = rows::at_start(model, arena);
    let mut lengths = Vec::new();
    for equation in equations {
        let Some(phi) = equation.phi().filter(|_| [Dim::LENGTH, Dim::LENGTH.times(Dim::LENGTH)].contains(&equation.dim)) else { continue };
        let terms = magnitude(arena, phi, &all, coordinates);
        let terms = at_start.of(arena, terms);
        lengths.push(if equation.dim == Dim::LENGTH { terms } else { arena.sqrt(terms) });
    }
    lengths
}

fn has_bodies(model: &Model, diag: &mut Diag) -> Option<()> {
    if model.bodies.is_empty() {
        return diag.refuse(&model.name, SystemFact::NoBodies { name: model.name.to_string() });
    }
    Some(())
}

/// Refuses loads that shall be computed alone where there are none.
fn slices_have_loads(model: &Model, has_loads: bool, diag: &mut Diag) -> Option<()> {
    let of_forces = model.declared_forces.iter().map(|force| (&force.name, force.is_slice));
    let mut slices = model.joints.iter().map(|joint| (&joint.name, joint.is_slice)).chain(of_forces);
    match slices.find(|(_, is_slice)| *is_slice && !has_loads) {
        Some((name, _)) => diag.refuse(name, SystemFact::SliceWithoutLoads { name: name.to_string() }),
        None => Some(()),
    }
}

/// Reports a joint if every equation of it is an equation of earlier joints; `redundancy` reports a freedom.
fn no_joint_repeats_another(model: &Model, arena: &mut Arena, diag: &mut Diag) {
    if !diag.is_clean() || !model.task.is_determined() {
        return;
    }
    let mut said = Said::default();
    let mut owners: BTreeMap<Expr, usize> = BTreeMap::new();
    for (index, joint) in model.joints.iter().enumerate() {
        let earlier: Option<Vec<usize>> = joint.residuals.iter().map(|residual| owners.get(&residual.expr).copied()).collect();
        if let Some(other) = earlier.and_then(|earlier| earlier.first().copied())
            && !joint.is_redundant
            && joint.freedom.is_none()
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
