//! Accelerations that follow from forces, and the forces in cuts, from the equations of motion with multipliers as one dense system:
//!
//! ```text
//! M q̈ − Gᵀ μ = −Σ (J_vᵀ m (a − g) + J_ωᵀ (I α + ω × I ω))      with a and α at q̈ = 0
//! G q̈ = −r̈
//! ```
//!
//! in numbers of twice the precision of a double. μ is the force on the first body of a cut.

use reuleaux::Real;
use reuleaux_tests::common::twofold::Twofold;

use super::Model;
use super::exact::{Moved, Numbers};

/// What follows from forces.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// What every body does.
    pub bodies: Vec<Numbers>,
    /// Second derivatives of the coordinates.
    pub accelerations: Vec<f64>,
    /// Forces on the first bodies of the cuts, in ground.
    pub cuts: Vec<[f64; 3]>,
    /// What drives the driven coordinates, in N or N m.
    pub efforts: Vec<f64>,
}

type Triple = [Twofold; 3];

fn part(numbers: &[Twofold; 24], first: usize) -> Triple {
    [numbers[first], numbers[first + 1], numbers[first + 2]]
}

fn dot(a: Triple, b: Triple) -> Twofold {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Triple, b: Triple) -> Triple {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i] * b[j] - a[j] * b[i])
}

/// A diag(I) Aᵀ v
fn spun(numbers: &[Twofold; 24], inertia: [f64; 3], v: Triple) -> Triple {
    let local = [0, 1, 2].map(|j| dot([numbers[j], numbers[3 + j], numbers[6 + j]], v) * inertia[j].into());
    [0, 1, 2].map(|i| dot(part(numbers, 3 * i), local))
}

/// What follows from gravity where the coordinates and their rates are these, and some are driven with an acceleration. Rows that nothing
/// moves are left out, as are the rows across the plane of a planar mechanism.
///
/// # Panics
/// If the mechanism is singular there.
#[must_use]
pub fn reaction(model: &Model, coordinates: &[f64], rates: &[f64], driven: &[(usize, f64)]) -> Reaction {
    let count = coordinates.len();
    let with = |rate: &dyn Fn(usize) -> Twofold, acceleration: &dyn Fn(usize) -> Twofold| {
        let jets: Vec<Triple> = (0..count).map(|k| [coordinates[k].into(), rate(k), acceleration(k)]).collect();
        Moved::with(model, &jets)
    };
    let (one, zero) = (Twofold::from(1.0), Twofold::default());
    let units: Vec<Moved> = (0..count).map(|unit| with(&|k| if k == unit { one } else { zero }, &|_| zero)).collect();
    let bias = with(&|k| rates[k].into(), &|_| zero);
    let is_moved = |row: usize| units.iter().any(|unit| unit.rows[row][1].high.abs() > 1e-12);
    let rows: Vec<usize> = (0..bias.rows.len()).filter(|&row| is_moved(row)).collect();
    let held = count + rows.len();
    let size = held + driven.len();
    let mut matrix = vec![vec![zero; size + 1]; size];
    for (index, body) in model.bodies.iter().enumerate() {
        let here = &bias.bodies[index];
        let a: Triple = std::array::from_fn(|k| (here[18 + k] - model.gravity[k].into()) * body.mass.into());
        let gyro = cross(part(here, 15), spun(here, body.inertia, part(here, 15)));
        let turned = spun(here, body.inertia, part(here, 21));
        let torque: Triple = std::array::from_fn(|k| turned[k] + gyro[k]);
        let columns: Vec<(Triple, Triple)> =
            units.iter().map(|unit| (part(&unit.bodies[index], 12), part(&unit.bodies[index], 15))).collect();
        for (i, &(v, w)) in columns.iter().enumerate() {
            matrix[i][size] = matrix[i][size] - dot(v, a) - dot(w, torque);
            let (momentum, spin) = (v.map(|entry| entry * body.mass.into()), spun(here, body.inertia, w));
            for (j, &(v, w)) in columns.iter().enumerate() {
                matrix[i][j] = matrix[i][j] + dot(momentum, v) + dot(spin, w);
            }
        }
    }
    for (place, &row) in rows.iter().enumerate() {
        for (k, unit) in units.iter().enumerate() {
            matrix[count + place][k] = unit.rows[row][1];
            matrix[k][count + place] = -unit.rows[row][1];
        }
        matrix[count + place][size] = -bias.rows[row][2];
    }
    for (place, &(coordinate, acceleration)) in driven.iter().enumerate() {
        matrix[held + place][coordinate] = one;
        matrix[coordinate][held + place] = -one;
        matrix[held + place][size] = acceleration.into();
    }
    let found = solved(matrix);
    let moved = with(&|k| rates[k].into(), &|k| found[k]);
    let mut cuts = vec![[0.0; 3]; bias.rows.len() / 3];
    for (place, &row) in rows.iter().enumerate() {
        cuts[row / 3][row % 3] = found[count + place].high;
    }
    Reaction {
        bodies: moved.bodies.iter().map(|numbers| numbers.map(|entry| entry.high)).collect(),
        accelerations: found[..count].iter().map(|entry| entry.high).collect(),
        cuts,
        efforts: found[held..].iter().map(|entry| entry.high).collect(),
    }
}

/// Elimination with partial pivoting; the right side is the last column.
///
/// # Panics
/// If there are no rows.
#[must_use]
pub fn solved(mut matrix: Vec<Vec<Twofold>>) -> Vec<Twofold> {
    let size = matrix.len();
    for k in 0..size {
        let pivot = (k..size).max_by(|&a, &b| matrix[a][k].high.abs().total_cmp(&matrix[b][k].high.abs())).expect("a row");
        matrix.swap(k, pivot);
        let row = matrix[k].clone();
        for other in &mut matrix[k + 1..] {
            if other[k].high == 0.0 {
                continue;
            }
            let factor = other[k] / row[k];
            for (entry, above) in other[k..].iter_mut().zip(&row[k..]) {
                *entry = *entry - factor * *above;
            }
        }
    }
    let mut found = vec![Twofold::default(); size];
    for k in (0..size).rev() {
        let known = (k + 1..size).map(|j| matrix[k][j] * found[j]).fold(Twofold::of(0.0), |a, b| a + b);
        found[k] = (matrix[k][size] - known) / matrix[k][k];
    }
    found
}
