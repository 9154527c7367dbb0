//! Equations of velocities, such as multi-point constraints, act on what has a mass.
//!
//! ```text
//! J z = 0, M z = 0      z: a motion that equations of positions and drives leave, and that nothing resists
//! a_b · z_b ≠ 0         the row a acts on the body b along it: refused
//! ```
//!
//! A body without mass that is held against one with mass, by joints or drives, has no such motion.

use super::loads::state_at_start;
use crate::assembly::Assembly;
use crate::diag::{Diag, SystemFact};
use crate::expr::{Arena, Expr, Leaf, Values, derivative, evaluate};
use crate::library;
use crate::linear::Echelon;
use crate::model::{Joint, Model};
use crate::numeric::Numeric;
use crate::quantity::Ambient;
use crate::syntax::ast::Definition;
use crate::system::{COSINES, LoadEquations, LoadRow};

/// A part of a row below this share of its largest entry acts on nothing.
const NOTHING: f64 = 1e-9;

/// Refuses equations of velocities on bodies without mass.
pub(super) fn check(numeric: &Numeric, assembly: &Assembly, diag: &mut Diag) -> Option<()> {
    let Some(equations) = &numeric.system.loads else { return Some(()) };
    if !equations.rows.iter().any(|row| row.is_of_velocities) {
        return Some(());
    }
    let bodies = numeric.model.bodies.len();
    let resisted = Resisted::new(numeric, assembly, equations);
    let mut is_clean = true;
    for (index, joint) in numeric.model.joints.iter().enumerate().filter(|(_, joint)| !joint.is_drive) {
        let mut lacks = [vec![false; bodies], vec![false; bodies]];
        for row in equations.rows.iter().zip(&resisted.rows).filter(|(row, _)| row.is_of_velocities && row.joint == index) {
            resisted.look(row.1, &mut lacks);
        }
        if lacks.iter().flatten().any(|lacks| *lacks) {
            is_clean = false;
            refuse(numeric.model, joint, lacks, diag);
        }
    }
    is_clean.then_some(())
}

fn refuse(model: &Model, joint: &Joint, lacks: [Vec<bool>; 2], diag: &mut Diag) {
    let [without_mass, without_inertia] = lacks.map(|lacks| {
        let bodies = model.bodies.iter().zip(lacks).filter(|(_, lacks)| *lacks);
        bodies.map(|(body, _)| body.name.to_string()).collect::<Vec<String>>()
    });
    let takes = |definition: &Definition| definition.parameters.iter().any(|formal| formal.name == "inertia");
    let adds = library::find(&joint.kind, model.ambient).is_some_and(|definition| takes(&definition));
    let freedom = model.joints.iter().find(|joint| joint.freedom.is_some()).map_or_else(String::new, |joint| joint.name.to_string());
    diag.refuse::<()>(
        &joint.name,
        SystemFact::ActsOnMassless { joint: joint.name.to_string(), without_mass, without_inertia, adds, freedom },
    );
}

/// Numbers by the speeds of the bodies where the mechanism is assembled, with lengths in characteristic lengths.
struct Resisted {
    /// Number of speeds of a body, and how many of them are of its translation.
    each: [usize; 2],
    /// Φ_u.
    rows: Vec<Vec<f64>>,
    /// Motions that nothing resists.
    motions: Vec<Vec<f64>>,
    /// Whether a body has a mass of its own.
    has_mass: Vec<bool>,
}

impl Resisted {
    fn new(numeric: &Numeric, assembly: &Assembly, equations: &LoadEquations) -> Resisted {
        let each = if numeric.model.ambient == Ambient::Space { [6, 3] } else { [3, 2] };
        let speeds = equations.forces.len();
        let scale = |speed: usize| if speed % each[0] < each[1] { numeric.size } else { 1.0 };
        let mut arena = numeric.system.arena.clone();
        let state = state_at_start(numeric, &mut arena, assembly);
        let still = vec![0.0; state.len()];
        let known = Values { coordinates: &state, speeds: &still, accelerations: &still, ..numeric.known };
        let row = |arena: &Arena, entries: &[(usize, Expr)], scale_of_row: f64| {
            let roots: Vec<Expr> = entries.iter().map(|(_, entry)| *entry).collect();
            let mut row = vec![0.0; speeds];
            for ((speed, _), value) in entries.iter().zip(evaluate(arena, &roots, &known)) {
                row[*speed] = value * scale(*speed) * scale_of_row;
            }
            row
        };
        let rows: Vec<Vec<f64>> = equations.rows.iter().map(|equation| row(&arena, &equation.jacobian, 1.0)).collect();
        let mut echelon = Echelon::new(speeds);
        let holds =
            |equation: &LoadRow| !equation.is_of_freedom && (!equation.is_of_velocities || numeric.model.joints[equation.joint].is_drive);
        for (_, row) in equations.rows.iter().zip(&rows).filter(|(equation, _)| holds(equation)) {
            echelon.takes(row.clone());
        }
        for (speed, force) in equations.forces.iter().enumerate() {
            let entries = masses(&mut arena, *force, numeric, each);
            echelon.takes(row(&arena, &entries, scale(speed)));
        }
        let of_body = |body: &crate::model::Body| {
            let masses: Vec<Expr> = body.masses.iter().filter_map(|mass| mass.mass).collect();
            evaluate(&arena, &masses, &known).into_iter().any(|mass| mass > 0.0)
        };
        let has_mass = numeric.model.bodies.iter().map(of_body).collect();
        Resisted { each, rows, motions: echelon.null_space(), has_mass }
    }

    /// Notes the bodies on whose translation and on whose rotation a row acts although nothing resists.
    fn look(&self, row: &[f64], [mass, inertia]: &mut [Vec<bool>; 2]) {
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        for motion in &self.motions {
            let least = NOTHING * largest(row) * largest(motion);
            for (body, has_mass) in self.has_mass.iter().enumerate() {
                let part = |from: usize, to: usize| -> f64 {
                    let speeds = self.each[0] * body + from..self.each[0] * body + to;
                    speeds.map(|speed| row[speed] * motion[speed]).sum()
                };
                let (translation, rotation) = (part(0, self.each[1]), part(self.each[1], self.each[0]));
                if (translation + rotation).abs() <= least {
                    continue;
                }
                mass[body] |= !has_mass && translation.abs() > least;
                inertia[body] |= rotation.abs() > least || *has_mass;
            }
        }
    }
}

/// ∂f/∂u̇, by speed of the bodies.
fn masses(arena: &mut Arena, force: Expr, numeric: &Numeric, [each, of_translation]: [usize; 2]) -> Vec<(usize, Expr)> {
    let unknowns = numeric.system.coordinates.len();
    let speed = |number: usize| match numeric.model.ambient {
        Ambient::Plane => number,
        // Accelerations of origins are the first entries of a state; those of rotations stand behind the unknowns.
        Ambient::Space if number < unknowns => each * (number / 3) + number % 3,
        Ambient::Space => each * ((number - unknowns) / COSINES) + of_translation + (number - unknowns) % COSINES,
    };
    let mut entries = Vec::new();
    for leaf in arena.leaves(force) {
        if let Leaf::Acceleration(number) = leaf {
            entries.push((speed(number as usize), derivative(arena, force, leaf)));
        }
    }
    entries
}
