//! Equations of velocities, such as multi-point constraints, must act on bodies with mass.
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
use crate::expr::{Expr, Values, evaluate};
use crate::library;
use crate::linear::Echelon;
use crate::model::{Body, Joint, Model};
use crate::numeric::Numeric;
use crate::quantity::Ambient;
use crate::syntax::ast::Definition;
use crate::system::{LoadEquations, LoadRow};

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
        let row = |equation: &LoadRow| {
            let roots: Vec<Expr> = equation.jacobian.iter().map(|(_, entry)| *entry).collect();
            let mut row = vec![0.0; speeds];
            for ((speed, _), value) in equation.jacobian.iter().zip(evaluate(&arena, &roots, &known)) {
                row[*speed] = value * scale(*speed);
            }
            row
        };
        let rows: Vec<Vec<f64>> = equations.rows.iter().map(row).collect();
        let mut echelon = Echelon::new(speeds);
        let holds =
            |equation: &LoadRow| !equation.is_of_freedom && (!equation.is_of_velocities || numeric.model.joints[equation.joint].is_drive);
        for (_, row) in equations.rows.iter().zip(&rows).filter(|(equation, _)| holds(equation)) {
            echelon.takes(row.clone());
        }
        for body in 0..numeric.model.bodies.len() {
            for (at, own) in mass_matrix(numeric, &state, body).into_iter().enumerate() {
                let mut row = vec![0.0; speeds];
                for (k, entry) in own.into_iter().enumerate() {
                    row[each[0] * body + k] = entry * scale(k) * scale(at);
                }
                echelon.takes(row);
            }
        }
        let of_body = |body: &Body| {
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

/// M of a body about its origin, in ground: m, m c and the inertia about the origin.
fn mass_matrix(numeric: &Numeric, state: &[f64], body: usize) -> Vec<Vec<f64>> {
    let model = numeric.model;
    let numbers = |list: Option<&[Expr]>, count: usize| {
        list.map_or_else(|| vec![0.0; count], |list| evaluate(&numeric.system.arena, list, &numeric.known))
    };
    let is_spatial = model.ambient == Ambient::Space;
    let each = if is_spatial { 6 } else { 3 };
    let mut whole = vec![vec![0.0; each]; each];
    for declared in &model.bodies[body].masses {
        let mass = numbers(declared.mass.as_ref().map(std::slice::from_ref), 1)[0];
        let center = numbers(declared.center.as_deref(), each / 2 + each % 2);
        let own = if is_spatial {
            let rotation: Vec<&[f64]> = state[numeric.system.entries_of(body)].chunks(3).collect();
            in_space(mass, &center, &numbers(declared.inertia.as_deref(), 6), &rotation)
        } else {
            let (sine, cosine) = (libm::sin(state[model.bodies[body].first + 2]), libm::cos(state[model.bodies[body].first + 2]));
            let (x, y) = (cosine * center[0] - sine * center[1], sine * center[0] + cosine * center[1]);
            let inertia = numbers(declared.inertia.as_deref(), 1)[0] + mass * (x * x + y * y);
            vec![vec![mass, 0.0, -mass * y], vec![0.0, mass, mass * x], vec![-mass * y, mass * x, inertia]]
        };
        whole.iter_mut().flatten().zip(own.into_iter().flatten()).for_each(|(sum, part)| *sum += part);
    }
    whole
}

/// The rows of the matrix of one mass in space.
fn in_space(mass: f64, center: &[f64], inertia: &[f64], rotation: &[&[f64]]) -> Vec<Vec<f64>> {
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(|k| inertia[k]);
    let local = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let c = [0, 1, 2].map(|row| (0..3).map(|k| rotation[row][k] * center[k]).sum::<f64>());
    // ĉ v = c × v
    let cross = [[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]];
    let mut rows = vec![vec![0.0; 6]; 6];
    for i in 0..3 {
        rows[i][i] = mass;
        for j in 0..3 {
            rows[3 + i][j] = mass * cross[i][j];
            rows[i][3 + j] = -mass * cross[i][j];
            let turned: f64 = (0..9).map(|k| rotation[i][k / 3] * local[k / 3][k % 3] * rotation[j][k % 3]).sum();
            rows[3 + i][3 + j] = turned - mass * (0..3).map(|k| cross[i][k] * cross[k][j]).sum::<f64>();
        }
    }
    rows
}
