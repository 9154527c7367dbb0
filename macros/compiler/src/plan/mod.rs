//! From expressions to straight-line code: all decisions on names and order.
//!
//! In: a [`System`] and the expressions to be computed. Out: a [`Plan`], of which the [`Routine`]s are named steps for common subexpressions,
//! and results that refer to them. Not done here: printing.

mod choices;
mod dynamics;
mod elimination;
mod finite;
mod jerk;
mod joints;
mod kernels;
mod linear;
mod lines;
mod loads;
mod obstacle;
mod outputs;
mod rolled;
mod routine;
mod runs;
mod scene;
mod schedule;
mod shape;
mod slice;
mod solution;
mod space;
mod stage;
mod stages;
#[cfg(test)]
mod tests;
mod turning;
mod words;

pub use dynamics::DynamicsCode;
pub use finite::Unsure;
pub(crate) use finite::tested;
pub use kernels::{Kernel, Kernels, Round};
pub use lines::{Iterated, StageCode, StraightLine};
pub use loads::{LoadKind, LoadsCode, NamedLoad};
pub use outputs::{OutputCode, Outputs};
pub use rolled::{Code, Group, Target};
pub use routine::{Branch, Cost, Routine, Step};
pub use scene::SceneCode;
pub use shape::{Column, Shape};
pub use slice::Slice;
pub use solution::{Solution, Solving, Summary};
pub use stage::{Elimination, Iteration, Origin, Stage};
pub(crate) use words::Words;

use crate::assembly::{Assembly, Poses};
use crate::diag::Diag;
use crate::dynamics::{Dynamics, Loads};
use crate::expr::{Arena, Expr, Leaf};
use crate::model::Model;
use crate::quantity::Role;
use crate::structure::Structure;
use crate::system::{Equation, OutputMotion, System};
use jerk::{Jerks, JerksOf};
use joints::Joints;
use lines::PlanContext;
use rolled::Cell;
use shape::Tracer;
use std::ops::Range;

/// Plan of all generated code.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Expressions of the system and of its solution.
    pub arena: Arena,
    /// Expressions of Φ, Φ_q, ν and γ, if they are not those of the system.
    pub declared: Option<Arena>,
    /// Solution for q, q̇ and q̈; `None` if only equations are wanted.
    pub solution: Option<Solution>,
    /// Equations that are checked instead of solved, by index in Φ.
    pub checked: Vec<usize>,
    /// For each sliced method of outputs, the part of the mechanism upstream of it.
    pub slices: Vec<Slice>,
    /// The moving part of the mechanism, if it is worth code of its own.
    pub moving: Option<Slice>,
    /// Φ(q, t), one result per row.
    pub phi: Code,
    /// Entries of Φ_q that are not identically zero, row by row.
    pub jacobian: Code,
    /// Φ and the entries of Φ_q, grouped by joint.
    pub linearize: Code,
    /// Targets of the results of `linearize`, if it is straight-line code.
    pub linearized: Vec<Target<u32>>,
    /// ν(q, t)
    pub nu: Code,
    /// γ(q, q̇, t)
    pub gamma: Code,
    /// Row and column of each entry of Φ_q.
    pub pattern: Vec<(usize, usize)>,
    /// Outputs of each method.
    pub outputs: Vec<Outputs>,
    /// Declared start values, by unknown; undeclared ones have no result.
    pub start: Routine,
    /// Local coordinates of points that depend on parameters or are constant.
    pub lengths: Routine,
    /// Left and right side of each requirement.
    pub requirements: Routine,
    /// In space: the rotation matrices of the bodies at the start, as a state holds them.
    pub orientations: Vec<f64>,
    /// Equations of motion, where freedoms are integrated.
    pub dynamics: Option<DynamicsCode>,
    /// Loads, where there are masses or forces.
    pub loads: Option<LoadsCode>,
    /// Numbers of the picture, if states are to be drawn at run time.
    pub scene: Option<SceneCode>,
    /// Local coordinates of each declared point and axis, for `#[points]`.
    pub marks: Option<Vec<Routine>>,
}

/// Schedules all generated code; refuses outputs with jerk that have none.
pub(crate) fn schedule(
    model: &Model,
    system: &System,
    structure: &Structure,
    assembly: &Assembly,
    dynamics: Option<&Dynamics>,
    loads: Option<&Loads>,
    diag: &mut Diag,
) -> Option<Plan> {
    obstacle::jerks_are_known(model, system, structure, diag)?;
    let mut arena = system.arena.clone();
    let solved = (model.task.is_solved()).then(|| {
        let outputs = sliced(&mut arena, model, system);
        let (mut stages, mut outputs) = stages::stages(&mut arena, system, structure, &outputs);
        space::without_marks(&mut arena, &mut stages, &mut outputs);
        eliminations(&arena, model, system, assembly, &mut stages);
        (stages, outputs)
    });
    let motions = space::plain_outputs(&mut arena, system);
    let jerks =
        solved.as_ref().map(|(stages, outputs)| JerksOf::new(&mut arena, model, system, stages, outputs, &motions)).unwrap_or_default();
    let words = Words::new(model, system);
    let tracer = Tracer::new(&arena);
    let line = |results: Vec<Expr>| schedule::routine(&arena, results, &words);
    let declared = system.declared.as_deref();
    let constraints = system.constraints();
    let joints = Joints::new(&constraints);
    let words_of_equations = if declared.is_some() { Words::declared(model) } else { words.clone() };
    let arena_of_equations = declared.map_or(&arena, |declared| &declared.arena);
    let tracer_of_equations = Tracer::new(arena_of_equations);
    // A row of velocities has no residual between positions.
    let zero = arena_of_equations.all().find(|expr| arena_of_equations.as_constant(*expr).is_some_and(|value| value.is_zero()));
    let residual = |equation: &Equation| equation.phi().or(zero);
    let equations = |cells: Vec<Cell>| rolled::code(arena_of_equations, &tracer_of_equations, cells, &words_of_equations);
    let solving = solved.map(|(stages, outputs)| solving(&arena, &tracer, system, &words, &stages, &outputs, &jerks.of_slices));
    let sides = model.requirements.iter().flat_map(|requirement| [requirement.lhs, requirement.rhs]).collect();
    Some(Plan {
        dynamics: dynamics.map(|dynamics| dynamics::code(model, system, dynamics)),
        loads: loads::code(model, system, loads),
        linearized: joints.linearized(residual).iter().flatten().map(|(target, _)| *target).collect(),
        linearize: equations(joints.linearized(residual)),
        phi: equations(joints.rows(residual)),
        jacobian: equations(joints.entries()),
        nu: equations(joints.rows(|equation| Some(equation.nu))),
        gamma: equations(joints.rows(|equation| Some(equation.gamma))),
        pattern: joints.pattern(),
        outputs: outputs::outputs(&arena, &tracer, model, &motions, &jerks.of_outputs, &words),
        start: line(system.coordinates.iter().filter_map(|unknown| unknown.start).collect()),
        lengths: line(distinct(&arena, &system.lengths)),
        requirements: line(sides),
        scene: model.requests.picture.is_some().then(|| scene::scene(&model.sketch, &words)),
        marks: model.requests.points.is_some().then(|| scene::marks(&model.sketch, &words)),
        checked: structure.checked.clone(),
        solution: solving.as_ref().map(|(solution, _, _)| solution.clone()),
        slices: solving.as_ref().map_or(Vec::new(), |(_, slices, _)| slices.clone()),
        moving: solving.and_then(|(_, _, moving)| moving),
        declared: declared.map(|declared| declared.arena.clone()),
        orientations: space::orientations_at_start(model, system, assembly),
        arena,
    })
}

/// Components of the outputs of each slice; those of a body are its coordinates. What contains velocities is found when positions are
/// known, as a rate.
fn sliced(arena: &mut Arena, model: &Model, system: &System) -> Vec<OutputMotion> {
    let zero = arena.integer(0);
    let mut components = |member: &usize| -> Vec<[Expr; 3]> {
        let own = &system.outputs[*member].components;
        if model.outputs[*member].derivatives == 1 {
            return own.iter().map(|[value, rate, _]| [zero, *value, *rate]).collect();
        }
        let Some(body) = model.outputs[*member].body else { return own.clone() };
        let own = (0..system.coordinates.len())
            .filter(|unknown| system.coordinates[*unknown].body == body && (system.frames.is_empty() || *unknown / 3 == body));
        let own: Vec<[Expr; 3]> =
            own.map(|unknown| [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration].map(|leaf| arena.leaf(leaf(unknown as u32)))).collect();
        if system.frames.is_empty() { own } else { own.into_iter().chain(system.orientation(arena, body)).collect() }
    };
    let slices = model.methods.iter().filter(|method| method.is_slice);
    slices.map(|method| OutputMotion { components: method.members.iter().flat_map(&mut components).collect() }).collect()
}

/// Chooses the elimination of large blocks; most mechanisms have none.
fn eliminations(arena: &Arena, model: &Model, system: &System, assembly: &Assembly, stages: &mut [Stage]) {
    let mut poses = None;
    for stage in stages {
        if let Stage::Block(block) = stage
            && block.unknowns.len() > elimination::CLOSED_FORM
        {
            let poses = poses.get_or_insert_with(|| Poses::new(model, system, assembly));
            block.elimination = Some(Box::new(elimination::elimination(arena, system, block, poses)));
        }
    }
}

/// Plans the solution, the slice of each output, and the moving part.
fn solving(
    arena: &Arena,
    tracer: &Tracer,
    system: &System,
    words: &Words,
    stages: &[Stage],
    outputs: &[OutputMotion],
    jerks: &[Option<Jerks>],
) -> (Solution, Vec<Slice>, Option<Slice>) {
    let is_angle = |index: usize| system.coordinates.get(index).is_some_and(|unknown| unknown.role == Role::Angle);
    let is_angle: Vec<bool> = (0..system.width()).map(is_angle).collect();
    let joints: Vec<usize> = system.equations.iter().map(|equation| equation.joint).collect();
    let links: Vec<Range<usize>> = system.space.links.iter().map(|body| system.entries_of(*body)).collect();
    let frame = PlanContext { arena, tracer, words, is_angle: &is_angle, joints: &joints, links: &links };
    let slice = |(output, jerks): (&OutputMotion, &Option<Jerks>)| {
        let components = output.components.len() + jerks.as_ref().map_or(0, |jerks| jerks.components.len());
        let is_angle: Vec<bool> = is_angle.iter().copied().chain((0..components).map(|_| false)).collect();
        let words = words.with_outputs(components);
        slice::upstream(&PlanContext { words: &words, is_angle: &is_angle, ..frame }, stages, output, jerks.as_ref(), system.width())
    };
    let slices = outputs.iter().zip(jerks).map(slice).collect();
    // If a part rests, single steps solve the moving part.
    let moving = slice::moving(&frame, stages);
    (solution::solution(&frame, stages, moving.is_none()), slices, moving)
}

/// Different lengths, without zeros.
fn distinct(arena: &Arena, lengths: &[Expr]) -> Vec<Expr> {
    let mut distinct = lengths.to_vec();
    distinct.sort();
    distinct.dedup();
    distinct.retain(|length| !arena.as_constant(*length).is_some_and(|value| value.is_zero()));
    distinct
}
