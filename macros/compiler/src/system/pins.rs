//! Coordinates that only equations of speeds determine keep their declared start values. One without a declared start keeps 0 if the
//! mechanism closes there, and otherwise its value in a configuration nearby that satisfies the equations of positions. If the mechanism does
//! not close at the declared values, these are only the guess for such a configuration; then an unknown without a declared start whose rate alone
//! is given, by a freedom or by a drive, keeps 0. If no steps from the guess lead to such a configuration, others are guesses.

use super::rows::Row;
use super::{Coordinate, Equation};
use crate::expr::{Arena, Evaluator, Exact, Expr, Leaf, Values, evaluate};
use crate::linear::Echelon;
use crate::linear::dense::cholesky;
use crate::model::{Model, defaults, tabulated};
use crate::quantity::{Dim, Role};
use crate::structure::SMALL;
use std::f64::consts::PI;

/// A coordinate is pinned first if the equations leave more than this fraction of it open.
const CLEARLY: f64 = 0.1;

/// The other coordinates are pinned if more than this fraction is open.
const HARDLY: f64 = 1e-9;

/// Newton steps to a configuration that satisfies the equations.
const STEPS: usize = 40;

/// Each step is halved at most so often.
const HALVINGS: usize = 20;

/// The equations hold if no row, divided by its largest derivative, exceeds this, in m or rad.
const HOLDS: f64 = 1e-12;

/// Largest changes of the angles and of the components of quaternions that lead to configurations beside the declared start.
const SWAYS: [f64; 6] = [0.1, 0.2, 0.3, 0.5, 0.7, 1.0];

/// Attempts with changes of up to half a turn, where none closes nearer to the declared start.
const WIDE: usize = 24;

/// Added to the diagonal of Φ_q Φ_qᵀ, since rows may depend on each other.
const DAMPING: f64 = 1e-13;

/// Rows that hold the coordinates which the equations leave open at the start; they belong to the last freedom.
///
/// * `of_speeds`: given, the equations of speeds, with those of freedoms.
pub(super) fn pins(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Vec<Row> {
    let Open { start, unknowns, keeps_declared } = open(model, arena, coordinates, [equations, of_speeds]);
    let joint = model.joints.len() - 1;
    let first = model.joints[joint].residuals.len();
    let row = |(number, unknown): (usize, usize)| {
        let role = coordinates[unknown].role;
        let leaf = arena.leaf(Leaf::Coordinate(unknown as u32));
        let nearby = Exact::binary(start[unknown]).filter(|_| !keeps_declared || !is_declared(model, &coordinates[unknown]));
        let held = nearby.map(|value| arena.constant(value)).or(coordinates[unknown].start);
        let residual = held.map_or(leaf, |held| arena.sub(leaf, held));
        let dim = match role {
            Role::Position(_) | Role::Displacement => Dim::LENGTH,
            Role::Angle => Dim::ANGLE,
            Role::Quaternion(_) => Dim::NUMBER,
        };
        Row { joint, row: first + number, dim, residual, is_velocity: false, is_initial: true }
    };
    unknowns.into_iter().enumerate().map(row).collect()
}

/// What the equations of positions leave open.
struct Open {
    /// A configuration near the declared start.
    start: Vec<f64>,
    /// The unknowns that Φ_q leaves open there.
    unknowns: Vec<usize>,
    /// True if unknowns with a declared start have that value.
    keeps_declared: bool,
}

/// True if a start value of a coordinate is declared. In space an angle or a component of a quaternion has one, even if it is 0, where the
/// orientation of the body is declared.
fn is_declared(model: &Model, coordinate: &Coordinate) -> bool {
    let declared = &model.bodies[coordinate.body].coordinates;
    let is_turned = || declared.iter().any(|one| matches!(one.role, Role::Quaternion(_)) && one.start.is_some());
    match coordinate.role {
        Role::Quaternion(_) => is_turned(),
        Role::Angle => coordinate.start.is_some() || is_turned(),
        Role::Position(_) | Role::Displacement => coordinate.start.is_some(),
    }
}

fn open(model: &Model, arena: &Arena, coordinates: &[Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Open {
    let kept = |(start, unknowns)| Open { start, unknowns, keeps_declared: true };
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let parameters = defaults(model, arena);
    let known = Values { time: 0.0, parameters: &parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let start = |coordinate: &Coordinate| coordinate.start.and_then(|start| evaluate(arena, &[start], &known).pop()).unwrap_or(0.0);
    let declared: Vec<f64> = coordinates.iter().map(start).collect();
    let is_declared: Vec<bool> = coordinates.iter().map(|coordinate| is_declared(model, coordinate)).collect();
    let mut rows = PositionRows::new(arena, &known, equations, coordinates.len());
    let open = rows.open(&declared, &is_declared);
    let held: Vec<usize> = open.iter().copied().filter(|unknown| is_declared[*unknown]).collect();
    let swayed = |attempt: usize| {
        let change = |(unknown, value): (usize, &f64)| match coordinates[unknown].role {
            Role::Angle | Role::Quaternion(_) if !is_declared[unknown] => value + sway(unknown, attempt),
            _ => *value,
        };
        declared.iter().enumerate().map(change).collect::<Vec<f64>>()
    };
    // Equations that depend on each other at the declared start alone leave fewer unknowns open beside it.
    let may_leave_fewer = rows.shape[0] + open.len() > declared.len() && declared.len() <= SMALL;
    let fewer = |(attempt, held): (usize, &[usize])| {
        let closed = rows.closed_near(&swayed(attempt), held)?;
        let there = rows.open(&closed, &is_declared);
        (there.len() < open.len()).then_some((closed, there))
    };
    let attempts = [held.as_slice(), &[]].into_iter().flat_map(|held| (0..=SWAYS.len()).map(move |attempt| (attempt, held)));
    if let Some(found) = attempts.filter(|_| may_leave_fewer).find_map(fewer) {
        return kept(found);
    }
    if rows.closed_near(&declared, &open).is_some() {
        return kept((declared, open));
    }
    if let Some(closed) = rows.closed_near(&declared, &held) {
        let open = if held.is_empty() { rows.open(&closed, &is_declared) } else { open };
        return kept((closed, open));
    }
    // Steps that end at a smallest gap say nothing about other configurations.
    let from = |attempt: usize, held: &[usize]| {
        let mut there = swayed(attempt);
        held.iter().for_each(|unknown| there[*unknown] = declared[*unknown]);
        there
    };
    let most = if declared.len() <= SMALL { SWAYS.len() + WIDE } else { 0 };
    let mut closed_anywhere = |held: &[usize]| (0..=most).find_map(|attempt| rows.closed_near(&from(attempt, held), held));
    // A coordinate whose rate alone is known is rather held at 0 than another one at a declared start at which nothing closes.
    let rates: Vec<usize> = of_speeds.iter().filter(|row| row.jacobian.len() == 1).map(|row| row.jacobian[0].0).collect();
    let is_rate: Vec<bool> = (0..declared.len()).map(|unknown| rates.contains(&unknown)).collect();
    let may_be_held = !rates.is_empty() && !rates.iter().any(|unknown| is_declared[*unknown]);
    if let Some(closed) = may_be_held.then(|| closed_anywhere(&rates)).flatten() {
        return Open { unknowns: rows.open(&closed, &is_rate), start: closed, keeps_declared: false };
    }
    if closed_anywhere(&open).is_some() {
        return kept((declared, open));
    }
    if let Some(closed) = closed_anywhere(&held) {
        let open = rows.open(&closed, &is_declared);
        return kept((closed, open));
    }
    // It does not close, as is said later of its joints; until then its freedoms are counted beside the start.
    let beside = may_leave_fewer.then(|| rows.open(&swayed(1), &is_declared));
    kept((declared, beside.filter(|beside| beside.len() < open.len()).unwrap_or(open)))
}

/// Change of an unknown in an attempt; none in attempt 0.
fn sway(unknown: usize, attempt: usize) -> f64 {
    // Multiples of the golden section modulo 1 are unrelated.
    let share = |attempts: usize| 2.0 * ((unknown * attempts + attempt) as f64 * 0.618_033_988_749_895).fract() - 1.0;
    match attempt.checked_sub(1) {
        None => 0.0,
        Some(one) if one < SWAYS.len() => SWAYS[one] * share(SWAYS.len()),
        Some(_) => PI * share(SWAYS.len() + WIDE),
    }
}

/// Equations of positions, at the defaults and t = 0.
struct PositionRows<'a> {
    known: Values<'a>,
    evaluator: Evaluator,
    /// Row and column of each derivative.
    pattern: Vec<(usize, usize)>,
    shape: [usize; 2],
}

impl<'a> PositionRows<'a> {
    fn new(arena: &Arena, known: &Values<'a>, equations: &[Equation], columns: usize) -> PositionRows<'a> {
        let rows: Vec<(Expr, &Equation)> = equations.iter().filter_map(|equation| Some((equation.phi()?, equation))).collect();
        let entries = || rows.iter().enumerate().flat_map(|(row, (_, equation))| equation.jacobian.iter().map(move |one| (row, one)));
        let roots: Vec<Expr> = rows.iter().map(|(phi, _)| *phi).chain(entries().map(|(_, (_, entry))| *entry)).collect();
        let pattern = entries().map(|(row, (column, _))| (row, *column)).collect();
        PositionRows { known: *known, evaluator: Evaluator::new(arena, &roots), pattern, shape: [rows.len(), columns] }
    }

    /// Φ and Φ_q, each row divided by its largest derivative. Rows without a value, such as those of Rust functions, count as closed.
    fn at(&mut self, q: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let [rows, columns] = self.shape;
        let mut values = vec![0.0; rows + self.pattern.len()];
        self.evaluator.run(&Values { coordinates: q, ..self.known }, &mut values);
        let mut jacobian = vec![vec![0.0; columns]; rows];
        self.pattern.iter().zip(&values[rows..]).for_each(|((row, column), entry)| jacobian[*row][*column] = *entry);
        values.truncate(rows);
        for (phi, row) in values.iter_mut().zip(&mut jacobian) {
            let largest = row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            if !phi.is_finite() || row.iter().any(|entry| !entry.is_finite()) {
                *phi = 0.0;
                row.fill(0.0);
            } else if largest > 0.0 {
                *phi /= largest;
                row.iter_mut().for_each(|entry| *entry /= largest);
            }
        }
        (values, jacobian)
    }

    /// The unknowns that Φ_q leaves open at a configuration.
    fn open(&mut self, q: &[f64], is_declared: &[bool]) -> Vec<usize> {
        let mut echelon = Echelon::new(q.len());
        for row in self.at(q).1 {
            echelon.takes(row);
        }
        // Coordinates with a declared start come first; among them and among the others, those that are no pivot of an equation.
        let free = echelon.free();
        let mut order: Vec<usize> = (0..q.len()).collect();
        order.sort_by_key(|unknown| (!is_declared[*unknown], !free.contains(unknown)));
        let mut pinned = Vec::new();
        for share in [CLEARLY, HARDLY] {
            for unknown in &order {
                let mut row = vec![0.0; q.len()];
                row[*unknown] = 1.0;
                pinned.extend(echelon.takes_above(share, row).then_some(*unknown));
            }
        }
        pinned.sort_unstable();
        pinned
    }

    /// A configuration that satisfies the equations, by the shortest steps Φ_qᵀ (Φ_q Φ_qᵀ)⁻¹ Φ; `None` if they do not lead to one. The
    /// values of some unknowns are held.
    fn closed_near(&mut self, start: &[f64], held: &[usize]) -> Option<Vec<f64>> {
        let mut q = start.to_vec();
        let (mut phi, mut jacobian) = self.at(&q);
        for _ in 0..STEPS {
            if phi.iter().all(|value| value.abs() <= HOLDS) {
                return Some(q);
            }
            jacobian.iter_mut().for_each(|row| held.iter().for_each(|unknown| row[*unknown] = 0.0));
            let change = shortest(&phi, &jacobian)?;
            let cost = product(&phi, &phi);
            let shorter = (0..HALVINGS).find_map(|halvings| {
                let share = 0.5_f64.powi(halvings as i32);
                let trial: Vec<f64> = q.iter().zip(&change).map(|(value, change)| value - share * change).collect();
                let there = self.at(&trial);
                (product(&there.0, &there.0) < cost).then_some((trial, there))
            });
            (q, (phi, jacobian)) = shorter?;
        }
        None
    }
}

/// The shortest change by which the linearized equations hold.
fn shortest(phi: &[f64], jacobian: &[Vec<f64>]) -> Option<Vec<f64>> {
    let mut matrix: Vec<Vec<f64>> = jacobian.iter().map(|one| jacobian.iter().map(|other| product(one, other)).collect()).collect();
    for (number, row) in matrix.iter_mut().enumerate() {
        row[number] += DAMPING;
    }
    let factors = cholesky(matrix, phi.to_vec())?;
    let columns = jacobian.first()?.len();
    Some((0..columns).map(|column| factors.iter().zip(jacobian).map(|(factor, row)| factor * row[column]).sum()).collect())
}

fn product(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
