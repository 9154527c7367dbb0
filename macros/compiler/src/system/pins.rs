//! Coordinates that only equations of speeds determine keep their declared start values. One without a declared start keeps 0 if the
//! mechanism closes there, and otherwise its value in a configuration nearby that satisfies the equations of positions. If the mechanism does
//! not close at the declared values, these are only the guess for such a configuration; then an unknown without a declared start whose rate alone
//! is given, by a freedom or by a drive, keeps 0. If no steps from the guess lead to such a configuration, others are guesses.
//!
//! If declared places or turns are not kept, the compiler looks for a configuration that is nearer to them and pins coordinates there; those linked
//! with them that have no declared start begin there.

use super::rows::Row;
use super::{Coordinate, Equation};
use crate::expr::{Arena, Evaluator, Exact, Expr, Leaf, Values, evaluate};
use crate::linear::Echelon;
use crate::linear::dense::cholesky;
use crate::model::{Model, defaults, tabulated};
use crate::quantity::{Dim, Role};
use crate::structure::SMALL;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// A coordinate is pinned first if the equations leave more than this fraction of it open.
const CLEARLY: f64 = 0.1;

/// The other coordinates are pinned if more than this fraction is open.
const HARDLY: f64 = 1e-9;

/// At a dead point steps converge slowly: an unknown that holds less than this part of what is open counts as holding nothing.
const BARELY: f64 = 1e-4;

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

/// A place is as declared within this part of the farthest one, a turn within so many radians.
const AS_DECLARED: f64 = 1e-9;

/// A step towards the declared places turns no body by more than this, in rad.
const LONGEST: f64 = 0.5;

/// Cost of changing a coordinate, against that of leaving a declared place.
const EFFORT: f64 = 1e-2;

/// Number of configurations of which the nearest is taken, if it is near.
const TRIES: usize = 5;

/// A configuration is near within this part of the farthest declared place, or within this angle in rad.
const NEAR: f64 = 1.0 / 3.0;

/// Another configuration is taken if it is nearer by more than this part.
const NEARER: f64 = 1e-6;

/// Steps to the configuration that is nearest to the declared places.
const APPROACHES: usize = 60;

/// Added to the diagonal of Φ_q Φ_qᵀ, since rows may depend on each other.
const DAMPING: f64 = 1e-13;

/// Rows that hold the coordinates which the equations leave open at the start; they belong to the last freedom.
///
/// * `coordinates`: given and returned; those without a declared start begin at the configuration found, if it is nearer to the declared places.
/// * `of_speeds`: given, the equations of speeds, with those of freedoms.
pub(super) fn pins(model: &Model, arena: &mut Arena, coordinates: &mut [Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Vec<Row> {
    let Open { start, unknowns, keeps_declared, begins_there } = open(model, arena, coordinates, [equations, of_speeds]);
    for unknown in begins_there {
        coordinates[unknown].start = Exact::binary(start[unknown]).map(|value| arena.constant(value));
    }
    let coordinates = &*coordinates;
    let joint = model.joints.len() - 1;
    let first = model.joints[joint].residuals.len();
    let row = |(number, unknown): (usize, usize)| {
        let role = coordinates[unknown].role;
        let leaf = arena.leaf(Leaf::Coordinate(unknown as u32));
        let nearby = Exact::binary(start[unknown]).filter(|_| !keeps_declared[unknown] || !is_declared(model, &coordinates[unknown]));
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
    /// True of each unknown that has its declared start value, if it has one.
    keeps_declared: Vec<bool>,
    /// The unknowns without a declared start that begin at this configuration.
    begins_there: Vec<usize>,
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

/// Declared start values, at the defaults.
struct DeclaredStart {
    /// 0 where none is declared.
    values: Vec<f64>,
    are_declared: Vec<bool>,
    /// True of angles and of components of quaternions.
    are_turns: Vec<bool>,
    /// The unknowns whose rate alone is given.
    rates: Vec<usize>,
    /// Those of them whose rate a drive gives.
    driven: Vec<usize>,
}

fn open(model: &Model, arena: &Arena, coordinates: &[Coordinate], [equations, of_speeds]: [&[Equation]; 2]) -> Open {
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let parameters = defaults(model, arena);
    let known = Values { time: 0.0, parameters: &parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let start = |coordinate: &Coordinate| coordinate.start.and_then(|start| evaluate(arena, &[start], &known).pop()).unwrap_or(0.0);
    let rates = || of_speeds.iter().filter(|row| row.jacobian.len() == 1);
    let declared = DeclaredStart {
        values: coordinates.iter().map(start).collect(),
        are_declared: coordinates.iter().map(|coordinate| is_declared(model, coordinate)).collect(),
        are_turns: coordinates.iter().map(|one| matches!(one.role, Role::Angle | Role::Quaternion(_))).collect(),
        rates: rates().map(|row| row.jacobian[0].0).collect(),
        driven: rates().filter(|row| model.joints[row.joint].is_driven()).map(|row| row.jacobian[0].0).collect(),
    };
    let mut rows = PositionRows::new(arena, &known, equations, coordinates.len());
    let open = as_declared(&mut rows, &declared);
    if declared.values.len() > SMALL || !(0..declared.values.len()).any(|unknown| declared.is_place(unknown)) {
        return open;
    }
    let closed = rows.closed_near(&open.start, &open.unknowns);
    let distance = closed.as_ref().map_or(f64::INFINITY, |closed| declared.distance(closed));
    if let Some(start) = closed.filter(|_| distance <= declared.exact()) {
        // At a dead point other coordinates are open than beside it.
        let unknowns = if rows.hold(&start, &open.unknowns) { open.unknowns } else { rows.open(&start, &declared.are_declared) };
        let begins_there = rows.linked(&declared, unknowns.iter().copied().filter(|unknown| declared.is_told_nothing(*unknown)));
        return Open { start, unknowns, begins_there, ..open };
    }
    let is_held = |unknown: &usize| declared.are_turns[*unknown] && declared.are_declared[*unknown];
    let held: Vec<usize> = open.unknowns.iter().copied().filter(is_held).chain(declared.driven.iter().copied()).collect();
    match rows.nearest(&declared, &held).filter(|found| declared.distance(found) < (1.0 - NEARER) * distance) {
        None => open,
        Some(start) => {
            let keeps_declared: Vec<bool> = (0..start.len()).map(|unknown| declared.is_kept(unknown, start[unknown])).collect();
            // Places that are not kept follow from turns, whatever the parameters are.
            let is_kept: Vec<bool> = keeps_declared.iter().zip(&declared.are_declared).map(|(kept, declared)| *kept && *declared).collect();
            let unknowns = rows.open(&start, &is_kept);
            let begins_there = rows.linked(&declared, unknowns.iter().copied());
            Open { start, unknowns, keeps_declared, begins_there }
        }
    }
}

/// The unknowns that are open if declared starts are kept, as far as the mechanism closes with them.
fn as_declared(rows: &mut PositionRows, start: &DeclaredStart) -> Open {
    let DeclaredStart { values: declared, are_declared: is_declared, rates, .. } = start;
    let kept = |(start, unknowns): (Vec<f64>, Vec<usize>)| Open {
        keeps_declared: vec![true; start.len()],
        start,
        unknowns,
        begins_there: Vec::new(),
    };
    let open = rows.open(declared, is_declared);
    let held: Vec<usize> = open.iter().copied().filter(|unknown| is_declared[*unknown]).collect();
    // Equations that depend on each other at the declared start alone leave fewer unknowns open beside it.
    let may_leave_fewer = rows.shape[0] + open.len() > declared.len() && declared.len() <= SMALL;
    let fewer = |(attempt, held): (usize, &[usize])| {
        let closed = rows.closed_near(&start.swayed(attempt), held)?;
        let there = rows.open(&closed, is_declared);
        (there.len() < open.len()).then_some((closed, there))
    };
    let attempts = [held.as_slice(), &[]].into_iter().flat_map(|held| (0..=SWAYS.len()).map(move |attempt| (attempt, held)));
    if let Some(found) = attempts.filter(|_| may_leave_fewer).find_map(fewer) {
        return kept(found);
    }
    if rows.closed_near(declared, &open).is_some() {
        return kept((declared.clone(), open));
    }
    if let Some(closed) = rows.closed_near(declared, &held) {
        let open = if held.is_empty() { rows.open(&closed, is_declared) } else { open };
        return kept((closed, open));
    }
    // Steps that end at a smallest gap say nothing about other configurations.
    let from = |attempt: usize, held: &[usize]| {
        let mut there = start.swayed(attempt);
        held.iter().for_each(|unknown| there[*unknown] = declared[*unknown]);
        there
    };
    let most = if declared.len() <= SMALL { SWAYS.len() + WIDE } else { 0 };
    let mut closed_anywhere = |held: &[usize]| (0..=most).find_map(|attempt| rows.closed_near(&from(attempt, held), held));
    // A coordinate whose rate alone is known is rather held at 0 than another one at a declared start at which nothing closes.
    let is_rate: Vec<bool> = (0..declared.len()).map(|unknown| rates.contains(&unknown)).collect();
    let may_be_held = !rates.is_empty() && !rates.iter().any(|unknown| is_declared[*unknown]);
    if let Some(closed) = may_be_held.then(|| closed_anywhere(rates)).flatten() {
        let unknowns = rows.open(&closed, &is_rate);
        return Open { unknowns, keeps_declared: vec![false; closed.len()], start: closed, begins_there: Vec::new() };
    }
    if closed_anywhere(&open).is_some() {
        return kept((declared.clone(), open));
    }
    if let Some(closed) = closed_anywhere(&held) {
        let open = rows.open(&closed, is_declared);
        return kept((closed, open));
    }
    // It does not close, as is said later of its joints; until then its freedoms are counted beside the start.
    let beside = may_leave_fewer.then(|| rows.open(&start.swayed(1), is_declared));
    kept((declared.clone(), beside.filter(|beside| beside.len() < open.len()).unwrap_or(open)))
}

impl DeclaredStart {
    /// Declared values, with others for the turns of which nothing is declared.
    fn swayed(&self, attempt: usize) -> Vec<f64> {
        let change = |(unknown, value): (usize, &f64)| if self.is_told_nothing(unknown) { value + sway(unknown, attempt) } else { *value };
        self.values.iter().enumerate().map(change).collect()
    }

    /// True of a declared place.
    fn is_place(&self, unknown: usize) -> bool {
        self.are_declared[unknown] && !self.are_turns[unknown]
    }

    /// True of an angle or a component of a quaternion without a declared start.
    fn is_told_nothing(&self, unknown: usize) -> bool {
        self.are_turns[unknown] && !self.are_declared[unknown]
    }

    /// The declared place farthest from the origin, or 1 m.
    fn size(&self) -> f64 {
        let farthest = (0..self.values.len()).filter(|unknown| self.is_place(*unknown)).map(|unknown| self.values[unknown].abs());
        Some(farthest.fold(0.0, f64::max)).filter(|size| *size > 0.0).unwrap_or(1.0)
    }

    /// Unit in which a coordinate counts: the size for places, 1 rad for turns.
    fn unit(&self, unknown: usize) -> f64 {
        if self.are_turns[unknown] { 1.0 } else { self.size() }
    }

    /// Distance of a configuration from what is declared.
    fn distance(&self, q: &[f64]) -> f64 {
        let declared = (0..q.len()).filter(|unknown| self.are_declared[*unknown]);
        declared.map(|unknown| ((q[unknown] - self.values[unknown]) / self.unit(unknown)).powi(2)).sum::<f64>().sqrt()
    }

    /// Distance within which all is as declared.
    fn exact(&self) -> f64 {
        AS_DECLARED + 10.0 * HOLDS / self.size()
    }

    fn is_kept(&self, unknown: usize, value: f64) -> bool {
        (value - self.values[unknown]).abs() <= self.exact() * self.unit(unknown)
    }
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

    /// The unknowns without a declared start that equations link with any of these, those themselves included.
    fn linked(&self, declared: &DeclaredStart, unknowns: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut is_linked = vec![false; self.shape[1]];
        unknowns.for_each(|unknown| is_linked[unknown] = true);
        loop {
            let reached: BTreeSet<usize> = self.pattern.iter().filter(|(_, column)| is_linked[*column]).map(|(row, _)| *row).collect();
            let more: Vec<usize> = self
                .pattern
                .iter()
                .filter(|(row, column)| reached.contains(row) && !is_linked[*column])
                .map(|(_, column)| *column)
                .collect();
            if more.is_empty() {
                return (0..is_linked.len()).filter(|unknown| is_linked[*unknown] && !declared.are_declared[*unknown]).collect();
            }
            more.into_iter().for_each(|column| is_linked[column] = true);
        }
    }

    /// True if the equations and some unknowns held leave nothing open at a configuration.
    fn hold(&mut self, q: &[f64], held: &[usize]) -> bool {
        let mut echelon = Echelon::new(q.len());
        let rows = self.at(q).1;
        let before = rows.into_iter().filter(|row| echelon.takes(row.clone())).count();
        let holds = |unknown: &usize| (0..q.len()).map(|column| f64::from(u8::from(column == *unknown))).collect();
        let taken = held.iter().filter(|unknown| echelon.takes_above(BARELY, holds(unknown))).count();
        before + taken == q.len()
    }

    /// A configuration that satisfies the equations, as near to the declared places as any that is found. The values of some unknowns are held.
    fn nearest(&mut self, declared: &DeclaredStart, held: &[usize]) -> Option<Vec<f64>> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        for attempt in 0..=SWAYS.len() + WIDE {
            let mut guess = declared.swayed(attempt);
            held.iter().for_each(|unknown| guess[*unknown] = declared.values[*unknown]);
            let guess = self.approach(declared, guess, held);
            if let Some(found) = self.closed_near(&guess, held) {
                let distance = declared.distance(&found);
                if best.as_ref().is_none_or(|(least, _)| distance < *least) {
                    best = Some((distance, found));
                }
            }
            match &best {
                // What closes nowhere near does not close.
                None if attempt == SWAYS.len() => return None,
                Some((least, _)) if *least <= declared.exact() || attempt >= TRIES && *least <= NEAR => break,
                _ => {}
            }
        }
        best.map(|(_, found)| found)
    }

    /// Steps that bring declared places nearer, along the linearized equations: (q + Δ − d)ᵀ P (q + Δ − d) + Δᵀ E Δ is least, Φ + Φ_q Δ = 0.
    fn approach(&mut self, declared: &DeclaredStart, mut q: Vec<f64>, held: &[usize]) -> Vec<f64> {
        let weights: Vec<f64> = (0..q.len()).map(|unknown| declared.unit(unknown).powi(-2)).collect();
        let pull = |unknown: usize| if declared.are_declared[unknown] { weights[unknown] } else { 0.0 };
        // In units in which P + E is the identity.
        let units: Vec<f64> = (0..q.len()).map(|unknown| (pull(unknown) + EFFORT * weights[unknown]).sqrt()).collect();
        for _ in 0..APPROACHES {
            let (phi, mut jacobian) = self.at(&q);
            jacobian.iter_mut().for_each(|row| held.iter().for_each(|unknown| row[*unknown] = 0.0));
            let wish: Vec<f64> =
                (0..q.len()).map(|unknown| pull(unknown) * (declared.values[unknown] - q[unknown]) / units[unknown]).collect();
            let scaled: Vec<Vec<f64>> =
                jacobian.iter().map(|row| row.iter().zip(&units).map(|(entry, unit)| entry / unit).collect()).collect();
            let left: Vec<f64> = phi.iter().zip(&scaled).map(|(phi, row)| phi + product(row, &wish)).collect();
            let Some(back) = shortest(&left, &scaled) else { return q };
            let step: Vec<f64> = (0..q.len()).map(|unknown| (wish[unknown] - back[unknown]) / units[unknown]).collect();
            let turn = (0..q.len()).filter(|unknown| declared.are_turns[*unknown]).map(|unknown| step[unknown].abs()).fold(0.0, f64::max);
            let share = if turn > LONGEST { LONGEST / turn } else { 1.0 };
            q.iter_mut().zip(&step).for_each(|(value, step)| *value += share * step);
            if step.iter().zip(&units).all(|(step, unit)| (step * unit).abs() <= HOLDS) {
                break;
            }
        }
        q
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
