//! Loads in closed form: the multipliers, eliminated in an order that is good at the assembled configuration, and the loads on bodies.
//!
//! ```text
//! Φ_uᵀ λ = −f      one row for each speed, one column for each multiplier; those of freedoms vanish
//! ```
//!
//! 1. Entries ±1 are pivots at every pose: most forces at joints follow from each other by sums. In space, rows with opposite entries are added
//!    as well: the moments at the joints of a tree follow from each other by sums.
//! 2. The rest falls apart into blocks, each with the multipliers of one loop, or of one joint of a tree. Columns that are axes of a body are
//!    solved by the transpose; of others up to three are solved by cofactors, more by elimination.
//!
//! Determinants and pivots are compared with their terms while they are used: where one is too small, the runtime eliminates all rows with
//! complete pivoting.

use super::axes::{AxesOfBody, Orientations};
use super::cofactors::{BY_COFACTORS, Cofactors};
use super::elimination::SparseRows;
use super::order::{Grouping, OpenRows};
use super::shares::shares;
use super::trust::Trust;
use crate::assembly::Assembly;
use crate::expr::{Arena, Expr, Unary, Values, evaluate};
use crate::model::Model;
use crate::numeric::{Numeric, at_defaults};
use crate::quantity::{Ambient, Dim};
use crate::structure::{Entry, Pattern, Structure, components_in_order, maximum};
use crate::system::{LoadEquations, LoadRow, System};
use std::collections::{BTreeMap, BTreeSet};

/// Multipliers and the loads from them.
#[derive(Clone, Debug)]
pub struct Loads {
    /// All expressions.
    pub arena: Arena,
    /// λ in closed form; `None` if equations are redundant.
    pub closed: Option<Multipliers>,
    /// Forces and torques of joints and powers of drives, from λ as data.
    pub actions: Vec<Expr>,
    /// By joint whose bodies do not get opposite loads: the bodies beside the one on which its load is stated. Their loads follow it.
    pub shares: BTreeMap<usize, Vec<usize>>,
}

/// Multipliers, and the checks of their computation.
#[derive(Clone, Debug)]
pub struct Multipliers {
    /// λ, without those of freedoms.
    pub values: Vec<Expr>,
    /// Forces and torques of joints and powers of drives.
    pub actions: Vec<Expr>,
    /// Determinants and pivots, each with the number that its size has to exceed.
    pub checks: Vec<[Expr; 2]>,
}

/// A determinant below one part in so many of the product of its rows is not trusted, nor a pivot below such a part of its row.
const TRUSTED: i64 = 1 << 16;
const TRUST: Trust = Trust { first: 1 << 10, further: 1 };

/// Loads, if there are masses or forces.
pub(crate) fn loads(model: &Model, system: &System, structure: &Structure, assembly: &Assembly) -> Option<Loads> {
    let equations = system.loads.as_ref().filter(|_| model.task.is_determined())?;
    let mut arena = system.arena.clone();
    let is_square = equations.rows.len() == equations.forces.len() && structure.checked.is_empty() && assembly.is_closed;
    let shares = at_defaults(model, system, |numeric| shares(numeric, structure, &mut arena, assembly, equations));
    let closed = is_square.then(|| {
        at_defaults(model, system, |numeric| {
            let numbers = numbers(numeric, &mut arena, assembly, equations);
            let orientations = (model.ambient == Ambient::Space).then(|| Orientations::of_state(&mut arena, system));
            LoadMatrix::new(&mut arena, equations, numbers, (numeric.size, orientations)).multipliers()
        })
    });
    let closed = closed.flatten().map(|(mut values, checks)| {
        let of_joints = equations.rows.iter().filter(|row| !row.is_of_freedom).count();
        let actions = actions(model, &mut arena, equations, &shares, &values);
        values.truncate(of_joints);
        Multipliers { values, actions, checks }
    });
    let data: Vec<Expr> = (0..equations.rows.len() as u32).map(|number| arena.leaf(crate::expr::Leaf::Datum(number))).collect();
    let actions = actions(model, &mut arena, equations, &shares, &data);
    Some(Loads { arena, closed, actions, shares })
}

/// Loads of joints, drives and forces: for each joint the force at its point and the torque about it, and those about the origins of the bodies
/// with loads of their own, for each drive its power, for each force its forces, its torques and its power.
fn actions(
    model: &Model,
    arena: &mut Arena,
    equations: &LoadEquations,
    shares: &BTreeMap<usize, Vec<usize>>,
    multipliers: &[Expr],
) -> Vec<Expr> {
    let origin = vec![arena.integer(0); model.ambient.components()];
    let mut actions = Vec::new();
    for (index, joint) in model.joints.iter().enumerate().filter(|(_, joint)| joint.freedom.is_none()) {
        let own: Vec<(&LoadRow, Expr)> =
            equations.rows.iter().zip(multipliers.iter().copied()).filter(|(row, _)| row.joint == index).collect();
        if joint.is_drive {
            actions.push(effort(arena, &own));
            actions.push(less(arena, own.iter().map(|(row, multiplier)| (row.nu, *multiplier))));
        } else if let Some((body, arm)) = &equations.arms[index] {
            let others = shares.get(&index).into_iter().flatten().map(|body| (body, &origin));
            for (body, arm) in [(body, arm)].into_iter().chain(others) {
                let columns: Vec<Vec<Expr>> = own.iter().map(|(row, _)| about_point(model.ambient, arena, row, *body, arm)).collect();
                for k in 0..columns.first().map_or(0, Vec::len) {
                    actions.push(less(arena, columns.iter().zip(&own).map(|(column, (_, multiplier))| (column[k], *multiplier))));
                }
            }
        }
    }
    actions.extend(equations.pushes.iter().flatten());
    actions
}

/// −λ ∂Φ/∂s of the first equation of a drive, where s is the driven quantity.
fn effort(arena: &mut Arena, own: &[(&LoadRow, Expr)]) -> Expr {
    let Some((row, multiplier)) = own.first() else { return arena.integer(0) };
    let against = row.slope.map_or(*multiplier, |slope| arena.mul(slope, *multiplier));
    arena.neg(against)
}

/// −Σ a λ
fn less(arena: &mut Arena, terms: impl Iterator<Item = (Expr, Expr)>) -> Expr {
    let mut sum = arena.integer(0);
    for (one, two) in terms {
        let product = arena.mul(one, two);
        sum = arena.sub(sum, product);
    }
    sum
}

/// Entries of a row for a body, by the velocity of the joint's point and by the angular velocity.
fn about_point(ambient: Ambient, arena: &mut Arena, row: &LoadRow, body: usize, arm: &[Expr]) -> Vec<Expr> {
    let each = each(ambient);
    let zero = arena.integer(0);
    let entry = |k: usize| row.jacobian.iter().find(|(speed, _)| *speed == each * body + k).map_or(zero, |(_, entry)| *entry);
    let mut across = |i: usize, j: usize, torque: usize| {
        let (left, right) = (arena.mul(arm[i], entry(j)), arena.mul(arm[j], entry(i)));
        let moment = arena.sub(left, right);
        arena.sub(entry(torque), moment)
    };
    match ambient {
        Ambient::Plane => vec![entry(0), entry(1), across(0, 1, 2)],
        Ambient::Space => vec![entry(0), entry(1), entry(2), across(1, 2, 3), across(2, 0, 4), across(0, 1, 5)],
    }
}

/// Number of speeds of a body.
fn each(ambient: Ambient) -> usize {
    if ambient == Ambient::Space { 6 } else { 3 }
}

/// Φ_uᵀ where the mechanism is assembled, by speed and multiplier.
fn numbers(numeric: &Numeric, arena: &mut Arena, assembly: &Assembly, equations: &LoadEquations) -> BTreeMap<(usize, usize), f64> {
    let state = state_at_start(numeric, arena, assembly);
    let places =
        equations.rows.iter().enumerate().flat_map(|(row, equation)| equation.jacobian.iter().map(move |(speed, _)| (*speed, row)));
    let entries: Vec<Expr> = equations.rows.iter().flat_map(|row| row.jacobian.iter().map(|(_, entry)| *entry)).collect();
    places.zip(evaluate(arena, &entries, &Values { coordinates: &state, ..numeric.known })).collect()
}

/// The entries of a state where the mechanism is assembled.
pub(super) fn state_at_start(numeric: &Numeric, arena: &mut Arena, assembly: &Assembly) -> Vec<f64> {
    state_at(numeric, arena, numeric.known.time, &assembly.start)
}

/// The entries of a state at a time: unknowns, and in space rotation matrices behind them.
pub(super) fn state_at(numeric: &Numeric, arena: &mut Arena, time: f64, q: &[f64]) -> Vec<f64> {
    let system = numeric.system;
    let orientations = (0..system.frames.len()).flat_map(|body| system.orientation(arena, body)).map(|[value, _, _]| value);
    let orientations: Vec<Expr> = orientations.collect();
    let there = Values { time, coordinates: q, ..numeric.known };
    let mut state = q.to_vec();
    state.extend(evaluate(arena, &orientations, &there));
    state
}

/// The equations of the loads under elimination.
struct LoadMatrix<'a> {
    arena: &'a mut Arena,
    /// By speed: entries by multiplier.
    entries: Vec<BTreeMap<usize, Expr>>,
    /// −f
    sides: Vec<Expr>,
    numbers: Vec<BTreeMap<usize, f64>>,
    /// Rows and columns without a pivot so far.
    open: [BTreeSet<usize>; 2],
    /// Row, column and sign of each pivot ±1.
    pivots: Vec<(usize, usize, bool)>,
    /// For each multiplier the power of the characteristic length that makes it comparable with forces.
    lengths: Vec<f64>,
    /// Sum of the sizes of each row where the mechanism is assembled.
    sizes: Vec<f64>,
    /// In space the orientations of the bodies.
    orientations: Option<Orientations>,
    checks: Vec<[Expr; 2]>,
}

impl<'a> LoadMatrix<'a> {
    fn new(
        arena: &'a mut Arena,
        equations: &LoadEquations,
        numbers: BTreeMap<(usize, usize), f64>,
        (size, orientations): (f64, Option<Orientations>),
    ) -> LoadMatrix<'a> {
        let count = equations.forces.len();
        let (mut entries, mut values) = (vec![BTreeMap::new(); count], vec![BTreeMap::new(); count]);
        for (column, row) in equations.rows.iter().enumerate() {
            for (speed, entry) in &row.jacobian {
                entries[*speed].insert(column, *entry);
            }
        }
        for ((speed, column), value) in numbers {
            values[speed].insert(column, value);
        }
        let length = |row: &LoadRow| match row.dim {
            dim if dim == Dim::LENGTH => 1.0,
            dim if dim == Dim::LENGTH.times(Dim::LENGTH) => 1.0 / size,
            _ => size,
        };
        let lengths: Vec<f64> = equations.rows.iter().map(length).collect();
        let size = |row: &BTreeMap<usize, f64>| row.iter().map(|(column, value)| (value * lengths[*column]).abs()).sum();
        LoadMatrix {
            sizes: values.iter().map(size).collect(),
            sides: equations.forces.iter().map(|force| arena.neg(*force)).collect(),
            arena,
            entries,
            numbers: values,
            open: [(0..count).collect(), (0..count).collect()],
            pivots: Vec::new(),
            lengths,
            orientations,
            checks: Vec::new(),
        }
    }

    /// λ, and the checks of its computation; `None` if the equations do not determine all of them.
    fn multipliers(mut self) -> Option<(Vec<Expr>, Vec<[Expr; 2]>)> {
        // Before pivots, and again: without forces more rows are opposite to others.
        self.add_opposite_rows();
        while let Some((row, column)) = self.next_unit() {
            self.eliminate(row, column);
        }
        self.add_opposite_rows();
        let zero = self.arena.integer(0);
        let mut values = vec![zero; self.lengths.len()];
        for (rows, columns) in self.blocks()? {
            self.solve(&rows, &columns, &mut values)?;
        }
        for (row, column, is_negative) in self.pivots.clone().into_iter().rev() {
            let rest = self.rest(row, &[column], &values);
            values[column] = if is_negative { self.arena.neg(rest) } else { rest };
        }
        Some((values, self.checks))
    }

    /// The entry ±1 whose elimination fills in least.
    fn next_unit(&self) -> Option<(usize, usize)> {
        let [rows, columns] = &self.open;
        let mut held = BTreeMap::<usize, usize>::new();
        for row in rows {
            self.entries[*row].keys().for_each(|column| *held.entry(*column).or_default() += 1);
        }
        let candidates = rows.iter().flat_map(|row| {
            let in_row = self.entries[*row].keys().filter(|column| columns.contains(column)).count();
            let units = self.entries[*row].iter().filter(|(column, entry)| columns.contains(column) && self.is_unit(**entry));
            units.map(|(column, _)| ((in_row - 1) * (held[column] - 1), *row, *column)).collect::<Vec<_>>()
        });
        candidates.min().map(|(_, row, column)| (row, column))
    }

    fn is_unit(&self, entry: Expr) -> bool {
        self.arena.as_constant(entry).is_some_and(|value| value.to_f64().abs() == 1.0)
    }

    /// Eliminates a column from the rows that are left by a pivot ±1.
    fn eliminate(&mut self, row: usize, column: usize) {
        let (own, own_numbers, side) = (self.entries[row].clone(), self.numbers[row].clone(), self.sides[row]);
        let pivot = own_numbers.get(&column).copied().unwrap_or(1.0);
        let is_negative = self.arena.as_constant(own[&column]).is_some_and(|value| value.to_f64() < 0.0);
        self.open[0].remove(&row);
        self.open[1].remove(&column);
        self.pivots.push((row, column, is_negative));
        for other in self.open[0].clone() {
            let Some(entry) = self.entries[other].remove(&column) else { continue };
            let number = self.numbers[other].remove(&column).unwrap_or(0.0);
            let factor = if is_negative { entry } else { self.arena.neg(entry) };
            for (at, entry) in own.iter().filter(|(at, _)| **at != column) {
                let (zero, product) = (self.arena.integer(0), self.arena.mul(factor, *entry));
                let sum = self.entries[other].get(at).copied().unwrap_or(zero);
                let sum = self.arena.add(sum, product);
                if sum == zero {
                    self.entries[other].remove(at);
                    self.numbers[other].remove(at);
                } else {
                    self.entries[other].insert(*at, sum);
                    *self.numbers[other].entry(*at).or_insert(0.0) -= number / pivot * own_numbers.get(at).copied().unwrap_or(0.0);
                }
            }
            let product = self.arena.mul(factor, side);
            self.sides[other] = self.arena.add(self.sides[other], product);
        }
    }

    /// In space, adds rows to others that have the opposite of all their entries: the moments of a body to those of the body that carries it.
    fn add_opposite_rows(&mut self) {
        if self.orientations.is_none() {
            return;
        }
        while let Some((row, other)) = self.next_opposite() {
            for column in self.entries[row].clone().into_keys() {
                self.entries[other].remove(&column);
                self.numbers[other].remove(&column);
            }
            self.sides[other] = self.arena.add(self.sides[other], self.sides[row]);
        }
    }

    /// A row, and another that has the opposite of its entries besides others.
    fn next_opposite(&mut self) -> Option<(usize, usize)> {
        let mut rows_of = BTreeMap::<(usize, Expr), Vec<usize>>::new();
        for row in &self.open[0] {
            self.entries[*row].iter().for_each(|(column, entry)| rows_of.entry((*column, *entry)).or_default().push(*row));
        }
        for row in &self.open[0] {
            let opposite: Vec<(usize, Expr)> = self.entries[*row].iter().map(|(column, entry)| (*column, self.arena.neg(*entry))).collect();
            let Some(candidates) = opposite.first().and_then(|first| rows_of.get(first)) else { continue };
            let has_all = |other: &&usize| opposite.iter().all(|(column, entry)| self.entries[**other].get(column) == Some(entry));
            let is_longer = |other: &&usize| self.entries[**other].len() > opposite.len();
            if let Some(other) = candidates.iter().filter(is_longer).find(has_all) {
                return Some((*row, *other));
            }
        }
        None
    }

    /// Rows and columns of each remaining block, in the order of solution.
    fn blocks(&self) -> Option<Vec<(Vec<usize>, Vec<usize>)>> {
        let rows: Vec<usize> = self.open[0].iter().copied().collect();
        let entries = |row: &usize| self.entries[*row].keys().map(|column| Entry { unknown: *column, is_pivot: false }).collect();
        let pattern = Pattern { unknowns: self.lengths.len(), rows: rows.iter().map(entries).collect(), ..Pattern::default() };
        let matching = maximum(&pattern);
        if !matching.free_equations().is_empty() {
            return None;
        }
        let block = |group: Vec<usize>| {
            let columns: Option<Vec<usize>> = group.iter().map(|row| matching.of_equation[*row]).collect();
            Some((group.into_iter().map(|row| rows[row]).collect(), columns?))
        };
        components_in_order(&pattern, &matching).into_iter().map(block).collect()
    }

    /// The right-hand side of a row, less its terms with other multipliers than `own`.
    fn rest(&mut self, row: usize, own: &[usize], values: &[Expr]) -> Expr {
        let mut rest = self.sides[row];
        for (column, entry) in self.entries[row].clone() {
            if !own.contains(&column) {
                let product = self.arena.mul(entry, values[column]);
                rest = self.arena.sub(rest, product);
            }
        }
        rest
    }

    /// Solves a block.
    fn solve(&mut self, rows: &[usize], columns: &[usize], values: &mut [Expr]) -> Option<()> {
        let zero = self.arena.integer(0);
        let sides: Vec<Expr> = rows.iter().map(|row| self.rest(*row, columns, values)).collect();
        let entry = |row: &usize, column: &usize| self.entries[*row].get(column).copied().unwrap_or(zero);
        let matrix: Vec<Vec<Expr>> = rows.iter().map(|row| columns.iter().map(|column| entry(row, column)).collect()).collect();
        let found = if let ([row], [column]) = (rows, columns) {
            vec![self.by_pivot(*row, *column, matrix[0][0], sides[0])]
        } else if let Some(found) = self.along_axes(&matrix, &sides) {
            found
        } else if rows.len() <= BY_COFACTORS {
            self.by_cofactors(columns, &matrix, &sides)
        } else {
            let number = |row: &usize, column: &usize| self.numbers[*row].get(column).copied().unwrap_or(0.0) * self.lengths[*column];
            let numbers: Vec<Vec<f64>> = rows.iter().map(|row| columns.iter().map(|column| number(row, column)).collect()).collect();
            let joints: Vec<usize> = (0..rows.len()).collect();
            let known = Grouping { joints: &joints, freedoms: &[], triples: &[] };
            let order = OpenRows::new(&numbers, |row, column| matrix[row][column] == zero, known, TRUST).order()?;
            let lengths: Vec<f64> = columns.iter().map(|column| self.lengths[*column]).collect();
            let lengths: Vec<Expr> = lengths.into_iter().map(|length| super::power_of_two(self.arena, length)).collect();
            let mut work = SparseRows::new(self.arena, &matrix, sides, &lengths, TRUST);
            let checks: Vec<[Expr; 2]> = order.iter().flat_map(|block| work.eliminate(block, &lengths)).collect();
            let found = work.solution(None, columns.len());
            self.checks.extend(checks.into_iter().map(|[pivot, least]| [self.arena.unary(Unary::Abs, pivot), least]));
            found
        };
        columns.iter().zip(found).for_each(|(column, value)| values[*column] = value);
        Some(())
    }

    /// b/a, a being compared with its row where the mechanism is assembled.
    fn by_pivot(&mut self, row: usize, column: usize, pivot: Expr, side: Expr) -> Expr {
        if self.arena.as_constant(pivot).is_none() {
            let least = self.sizes[row] / self.lengths[column] / TRUSTED as f64;
            let check = [self.arena.unary(Unary::Abs, pivot), super::power_of_two(self.arena, least)];
            self.checks.push(check);
        }
        self.arena.div(side, pivot)
    }

    /// The unknowns of a block whose columns are the axes of a body.
    fn along_axes(&mut self, matrix: &[Vec<Expr>], sides: &[Expr]) -> Option<Vec<Expr>> {
        let axes = AxesOfBody::find(self.arena, matrix, self.orientations.as_ref()?)?;
        Some(axes.solve(self.arena, sides))
    }

    /// A⁻¹ b of two or three rows.
    ///
    /// The determinant is compared with its rows, not with its terms: of two bars in line with an axis all terms vanish.
    fn by_cofactors(&mut self, columns: &[usize], matrix: &[Vec<Expr>], sides: &[Expr]) -> Vec<Expr> {
        let cofactors = Cofactors::new(self.arena, matrix);
        let determinant = cofactors.determinant;
        if self.arena.as_constant(determinant).is_none() {
            let unit = columns.iter().fold(f64::INFINITY, |least, column| least.min(self.lengths[*column]));
            let lengths: Vec<Expr> = columns.iter().map(|column| super::power_of_two(self.arena, self.lengths[*column] / unit)).collect();
            let scale: f64 = columns.iter().map(|column| unit / self.lengths[*column]).product();
            let mut least = super::power_of_two(self.arena, scale / TRUSTED as f64);
            for row in matrix {
                let mut sum = self.arena.integer(0);
                for (entry, length) in row.iter().zip(&lengths) {
                    let entry = self.arena.mul(*entry, *length);
                    let entry = self.arena.unary(Unary::Abs, entry);
                    sum = self.arena.add(sum, entry);
                }
                least = self.arena.mul(least, sum);
            }
            self.checks.push([self.arena.unary(Unary::Abs, determinant), least]);
        }
        cofactors.solve(self.arena, sides)
    }
}
