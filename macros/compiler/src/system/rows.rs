//! Rows, and their derivatives.
//!
//! ```text
//! Φ(q, t) = 0      Φ_u = ∂Φ/∂q by the coordinates or turns,  ν = −Φ_t,  γ = −d²/ds² Φ at constant speeds
//! a · u − b = 0    Φ_u = a,                                  ν = b,     γ = ḃ − ȧ · u
//! ```

use super::integral::{Integrals, affine};
use super::{Coordinate, Equation, Level};
use crate::diag::{Diag, NoPosition, SystemFact};
use crate::expr::{Arena, Derivatives, Expr, Jets, Leaf, Lookup, Node, Seed, Substitution, derivative};
use crate::model::{Model, Said};
use crate::quantity::Dim;
use crate::syntax::ast::Task;

/// A row before it is differentiated.
pub(super) struct Row {
    /// Index of its joint.
    pub(super) joint: usize,
    /// Number within the joint.
    pub(super) row: usize,
    /// Dimension of Φ; of a row of velocities, dimension of its integral.
    pub(super) dim: Dim,
    /// Φ; of a row of velocities, a · u − b.
    pub(super) residual: Expr,
    /// True for a row of velocities.
    pub(super) is_velocity: bool,
    /// True if it holds at the start only.
    pub(super) is_initial: bool,
}

impl Row {
    /// The rows that a model declares.
    pub(super) fn declared(model: &Model) -> impl Iterator<Item = Row> {
        let of_joint = |(joint, declared): (usize, &crate::model::Joint)| {
            let rows = declared.residuals.iter().enumerate().map(move |(row, residual)| Row {
                joint,
                row,
                dim: residual.dim,
                residual: residual.expr,
                is_velocity: residual.is_velocity,
                is_initial: declared.freedom.is_some(),
            });
            rows.collect::<Vec<_>>()
        };
        model.joints.iter().enumerate().flat_map(of_joint)
    }
}

/// The derivatives of rows, stored so that many rows share their work. Belongs to one arena.
pub(super) struct Differentiation {
    by_column: Vec<Derivatives>,
    by_time: Derivatives,
    along: Jets,
    first_speed: u32,
}

impl Differentiation {
    /// Column k of Φ_u is the derivative by the k-th variable; speeds are numbered from `first_speed` on.
    pub(super) fn new(columns: impl Iterator<Item = Leaf>, at_constant_speeds: Seed, first_speed: u32) -> Differentiation {
        Differentiation {
            by_column: columns.map(Derivatives::new).collect(),
            by_time: Derivatives::new(Leaf::Time),
            along: Jets::along(at_constant_speeds),
            first_speed,
        }
    }

    /// The equations of rows, with an entry for each coordinate that a row contains.
    pub(super) fn of_all(&mut self, arena: &mut Arena, rows: &[Row]) -> Vec<Equation> {
        let of_row = |row: &Row| {
            let columns = coordinates_in(arena, row.residual);
            self.of(arena, row, columns)
        };
        rows.iter().map(of_row).collect()
    }

    /// The equation of a row; its entries in all columns but these are zero.
    pub(super) fn of(&mut self, arena: &mut Arena, row: &Row, columns: impl IntoIterator<Item = usize>) -> Equation {
        let Row { joint, row: number, dim, residual, is_velocity, is_initial } = *row;
        if is_velocity {
            let (factors, nu) = affine(arena, residual);
            let jacobian = factors.into_iter().map(|(speed, factor)| ((speed - self.first_speed) as usize, factor)).collect();
            let [_, first, _] = self.along.of(arena, residual);
            return Equation {
                joint,
                row: number,
                dim,
                level: Level::Velocity,
                jacobian,
                read: Vec::new(),
                nu,
                gamma: arena.neg(first),
                is_initial,
            };
        }
        let entries = columns.into_iter().map(|column| (column, self.by_column[column].of(arena, residual)));
        let mut jacobian: Vec<(usize, Expr)> = entries.collect();
        let is_zero = |entry: Expr| arena.as_constant(entry).is_some_and(|value| value.is_zero());
        let read = jacobian.iter().filter(|(_, entry)| is_zero(*entry)).map(|(column, _)| *column).collect();
        jacobian.retain(|(_, entry)| !is_zero(*entry));
        let rate = self.by_time.of(arena, residual);
        let nu = arena.neg(rate);
        let [_, _, second] = self.along.of(arena, residual);
        let gamma = arena.neg(second);
        Equation { joint, row: number, dim, level: Level::Position { phi: residual }, jacobian, read, nu, gamma, is_initial }
    }
}

/// The coordinates that an expression contains, in ascending order.
pub(crate) fn coordinates_in(arena: &Arena, expr: Expr) -> Vec<usize> {
    let number = |leaf: Leaf| if let Leaf::Coordinate(number) = leaf { Some(number as usize) } else { None };
    arena.leaves(expr).into_iter().filter_map(number).collect()
}

/// Replaces rows of velocities by the rows of positions of which they are the rates, and refuses the others if they have to be solved.
pub(super) fn integrate(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], rows: &mut [Row], diag: &mut Diag) {
    kept_joints_have_velocities(model, diag);
    let starts = starts(model, arena, coordinates, rows);
    let integrals = Integrals::new(model, arena, coordinates, &starts);
    let mut said = Said::default();
    for row in rows.iter_mut().filter(|row| row.is_velocity && !row.is_initial) {
        let joint = &model.joints[row.joint];
        let obstacle = match integrals.of(arena, row.residual) {
            Ok(_) if joint.velocity.is_some() => NoPosition::Kept,
            Ok(phi) => {
                (row.residual, row.is_velocity) = (phi, false);
                continue;
            }
            Err(obstacle) => obstacle,
        };
        if model.task.is_solved() && said.is_new(&joint.name) {
            let (name, of) = (joint.name.to_string(), joint.residuals.len());
            diag.refuse::<()>(&joint.name, SystemFact::Nonholonomic { joint: name, row: row.row + 1, of, obstacle });
        }
    }
}

/// Refuses `#[velocity]` before joints without equations of velocities.
fn kept_joints_have_velocities(model: &Model, diag: &mut Diag) {
    for joint in &model.joints {
        if let Some(range) = joint.velocity.filter(|_| !joint.residuals.iter().any(|residual| residual.is_velocity)) {
            diag.refuse::<()>(range, SystemFact::NoVelocity { joint: joint.name.to_string() });
        }
    }
}

/// Replaces rows of velocities where it has been done already.
///
/// * `at_level`: given, for each row whether it is still one of velocities.
pub(super) fn integrate_again(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], rows: &mut [Row], at_level: &[bool]) {
    let starts = starts(model, arena, coordinates, rows);
    let integrals = Integrals::new(model, arena, coordinates, &starts);
    for (row, is_velocity) in rows.iter_mut().zip(at_level) {
        if row.is_velocity
            && !is_velocity
            && let Ok(phi) = integrals.of(arena, row.residual)
        {
            (row.residual, row.is_velocity) = (phi, false);
        }
    }
}

/// Value of each coordinate at t = 0: what an equation demands in which it is the only coordinate not yet known, as that of a drive; otherwise its
/// declared start. Without equations between velocities, declared starts are enough.
fn starts(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], rows: &[Row]) -> Vec<Option<Expr>> {
    let mut starts: Vec<Option<Expr>> = coordinates.iter().map(|coordinate| coordinate.start).collect();
    if !rows.iter().any(|row| row.is_velocity && !row.is_initial) {
        return starts;
    }
    // Rows of norms belong to no joint.
    let freedom = |row: &Row| model.joints.get(row.joint).and_then(|joint| joint.freedom);
    let is_from_start = |row: &Row| freedom(row).is_some_and(|freedom| freedom.is_from_start);
    let mut plain = Lookup::default();
    let open = rows.iter().filter(|row| !row.is_velocity && !is_from_start(row));
    let mut open: Vec<Expr> = open.map(|row| arena.plain(row.residual, &mut plain)).collect();
    let mut known = at_start(model, arena);
    loop {
        let before = open.len();
        for residual in std::mem::take(&mut open) {
            let there = known.of(arena, residual);
            let Some((number, value)) = demanded(arena, there) else {
                open.push(residual);
                continue;
            };
            known.replace(Leaf::Coordinate(number as u32), value);
            if let Some(start) = starts.get_mut(number) {
                *start = Some(value);
            }
        }
        if open.len() == before {
            return starts;
        }
    }
}

/// The coordinate and its value, if an equation contains one coordinate, with a constant factor.
fn demanded(arena: &mut Arena, residual: Expr) -> Option<(usize, Expr)> {
    let [number] = coordinates_in(arena, residual)[..] else { return None };
    let own = Leaf::Coordinate(number as u32);
    let slope = derivative(arena, residual, own);
    arena.as_constant(slope).filter(|slope| !slope.is_zero())?;
    let mut at_zero = Substitution::new();
    let zero = arena.integer(0);
    at_zero.replace(own, zero);
    let rest = at_zero.of(arena, residual);
    let quotient = arena.div(rest, slope);
    let value = arena.neg(quotient);
    let is_called = |expr: &Expr| matches!(arena.node(*expr), Node::Call { .. });
    let is_known = arena.is_fixed(value) && !arena.reachable(&[value]).iter().any(is_called);
    is_known.then_some((number, value))
}

/// Replaces time and inputs by their values at the start.
pub(super) fn at_start(model: &Model, arena: &mut Arena) -> Substitution {
    let mut at_start = Substitution::new();
    let zero = arena.integer(0);
    at_start.replace(Leaf::Time, zero);
    for (number, order, default) in model.inputs() {
        at_start.replace(Leaf::Input { number, order }, default);
    }
    at_start
}

/// Lets freedoms of which no initial value is declared begin at the declared start.
pub(super) fn begin_at_start(model: &Model, arena: &mut Arena, coordinates: &[Coordinate], rows: &mut [Row]) {
    if model.task != Task::Motion {
        return;
    }
    let mut at_start = at_start(model, arena);
    let zero = arena.integer(0);
    for (number, coordinate) in coordinates.iter().enumerate() {
        at_start.replace(Leaf::Coordinate(number as u32), coordinate.start.unwrap_or(zero));
    }
    for row in rows.iter_mut().filter(|row| row.is_initial && !row.is_velocity) {
        if model.joints[row.joint].freedom.is_some_and(|freedom| freedom.is_from_start) {
            let plain = arena.plain(row.residual, &mut Lookup::default());
            let start = at_start.of(arena, plain);
            row.residual = arena.sub(row.residual, start);
        }
    }
}
