//! Equations of motion in as few coordinates as explicit rows leave.
//!
//! In: a [`System`] with forces. Out: a [`Dynamics`]: the coordinates to integrate, the equations between them, their mass matrix and
//! forces, and every other coordinate as a function of them. Not done here: the choice of independent coordinates, which changes during
//! the motion.
//!
//! ```text
//! M u̇ + Jᵀ λ = −f       f: forces at u̇ = 0, with opposite sign
//! J u̇ = γ
//! ```

mod axes;
mod check;
mod cofactors;
mod elimination;
mod embedding;
mod loads;
mod massless;
mod order;
mod shares;
mod spins;
mod squares;
#[cfg(test)]
mod tests;
mod trust;
mod with_loads;

use crate::assembly::Assembly;
use crate::diag::Diag;
use crate::expr::{Arena, Expr, Leaf, Lookup, Node, Unary, derivative};
use crate::model::Model;
use crate::numeric::{Numeric, at_defaults};
use crate::structure::Structure;
use crate::system::{Balance, Equation, Level, System};
pub use elimination::Accelerations;
use embedding::Embedding;
pub(crate) use loads::loads;
pub use loads::{Loads, Multipliers};
use order::{Grouping, OpenRows};
use spins::BySpins;
use std::collections::BTreeMap;
use trust::Trust;
pub use with_loads::WithLoads;

/// Equations of motion.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// All expressions.
    pub arena: Arena,
    /// Coordinates that are integrated, by index in the state.
    pub integrated: Vec<usize>,
    /// Equations between them.
    pub rows: Vec<MotionRow>,
    /// Equations of redundant joints, which follow from the others.
    pub redundant: Vec<MotionRow>,
    /// Equations of the freedoms at t = 0.
    pub initial: Vec<MotionRow>,
    /// Φ and Φ_u u − ν of each of them, from all entries of the state.
    pub departures: Vec<[Expr; 2]>,
    /// Where joints are redundant, the equations that are checked: the index of their joint, and Φ in rad or in characteristic lengths to this
    /// power.
    pub checked: Vec<(usize, Expr, u8)>,
    /// What changes its sign at the kinks of equations between positions.
    pub kinks: Vec<Expr>,
    /// What changes its sign where forces have kinks, or jump.
    pub kinks_of_forces: Vec<Expr>,
    /// Lower triangle of the mass matrix, row by row.
    pub mass: Vec<Expr>,
    /// M u̇ − Q at u̇ = 0, by integrated speed.
    pub forces: Vec<Expr>,
    /// Value, rate and acceleration of every entry of the state.
    pub state: Vec<[Expr; 3]>,
    /// Kinetic energy, potential energy and power of the forces declared.
    pub energies: [Expr; 3],
    /// Accelerations in closed form, if there are not too many freedoms.
    pub accelerations: Option<Accelerations>,
    /// The same with all loads, if both have a closed form.
    pub with_loads: Option<WithLoads>,
    /// 0
    pub zero: Expr,
    /// Where bodies are free to turn: the equations from which accelerations are found in closed form.
    by_spins: Option<BySpins>,
}

/// With more freedoms than this, the equations are eliminated at run time: the expressions would grow with their cube.
const MOST_FREEDOMS: usize = 12;

impl Dynamics {
    /// Accelerations by an order of elimination that is good where the mechanism is assembled.
    fn in_closed_form(&mut self, numeric: &Numeric, assembly: &Assembly) -> Option<Accelerations> {
        let count = self.integrated.len();
        if !assembly.is_closed || count > MOST_FREEDOMS + self.rows.len() {
            return None;
        }
        if let Some(by_spins) = self.by_spins.take() {
            return by_spins.accelerations(&mut self.arena, (&self.integrated, &self.redundant), numeric, assembly);
        }
        let numbers = check::AtStart::new(numeric, assembly, self).constraints();
        let joints: Vec<usize> = self.rows.iter().map(|row| row.of.0).collect();
        let freedoms = freedoms(&self.initial, self.zero);
        let is_zero = |row: usize, column: usize| self.rows[row].jacobian[column] == self.zero;
        let columns = Grouping { joints: &joints, freedoms: &freedoms, triples: &[] };
        let order = OpenRows::new(&numbers, is_zero, columns, Trust::OF_MOTION).order()?;
        let scales: Vec<f64> = self.integrated.iter().map(|unknown| numeric.scale(*unknown)).collect();
        let lengths: Vec<Expr> = scales.into_iter().map(|scale| power_of_two(&mut self.arena, scale)).collect();
        let equations = (self.rows.as_slice(), self.mass.as_slice(), self.forces.as_slice());
        let in_general = in_general(&mut self.arena, &self.rows, &self.redundant, numeric.size);
        Some(elimination::accelerations(&mut self.arena, equations, &order, &lengths, (Trust::OF_MOTION, in_general)))
    }
}

/// If joints are redundant, the natural size of each row: a power of the characteristic length.
fn in_general(arena: &mut Arena, rows: &[MotionRow], redundant: &[MotionRow], length: f64) -> Vec<Expr> {
    if redundant.is_empty() {
        return Vec::new();
    }
    let length = power_of_two(arena, length);
    rows.iter().map(|row| arena.power(length, i32::from(row.power))).collect()
}

/// The differences and operands that change their sign where a choice, an absolute value or a sign changes, unless they are constant.
fn kinks(arena: &mut Arena, roots: &[Expr]) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for expr in arena.reachable(roots) {
        let kink = match *arena.node(expr) {
            Node::Select { lhs, rhs, .. } => arena.sub(lhs, rhs),
            Node::Unary(Unary::Abs | Unary::Sign, operand) => operand,
            _ => continue,
        };
        if !found.contains(&kink) && arena.leaves(kink).into_iter().any(|leaf| leaf.moves() || leaf.is_of_time()) {
            found.push(kink);
        }
    }
    found
}

/// Speeds that are freedoms by themselves.
fn freedoms(initial: &[MotionRow], zero: Expr) -> Vec<usize> {
    let alone = |row: &MotionRow| {
        let mut entries = (0..row.jacobian.len()).filter(|column| row.jacobian[*column] != zero);
        entries.next().filter(|_| entries.next().is_none())
    };
    initial.iter().filter_map(alone).collect()
}

/// The power of two next to a length.
fn power_of_two(arena: &mut Arena, length: f64) -> Expr {
    let exponent = libm::log2(length).round().clamp(-30.0, 30.0) as i32;
    let (power, one) = (arena.integer(1 << exponent.abs()), arena.integer(1));
    if exponent < 0 { arena.div(one, power) } else { power }
}

/// An equation in the integrated coordinates.
#[derive(Clone, Debug)]
pub struct MotionRow {
    /// Dimension of Φ as a power of a length.
    pub power: u8,
    /// Index of its joint in the model, and number within the joint.
    pub of: (usize, usize),
    /// Φ; `None` for an equation between speeds.
    pub phi: Option<Expr>,
    /// Entries by integrated speed.
    pub jacobian: Vec<Expr>,
    /// ν
    pub nu: Expr,
    /// γ
    pub gamma: Expr,
}

/// The equations of motion of a mechanism with freedoms; refuses freedoms that do not determine the motion, and motions without mass.
pub(crate) fn derive(
    model: &Model,
    system: &System,
    structure: &Structure,
    assembly: &Assembly,
    loads: Option<&Loads>,
    diag: &mut Diag,
) -> Option<Option<Dynamics>> {
    let Some(balance) = &system.balance else { return Some(None) };
    let mut dynamics = reduce(system, structure, balance);
    check::check(model, system, assembly, &dynamics, diag)?;
    dynamics.accelerations = at_defaults(model, system, |numeric| dynamics.in_closed_form(numeric, assembly));
    dynamics.with_loads = loads.and_then(|loads| WithLoads::new(&mut dynamics, loads));
    Some(Some(dynamics))
}

/// Eliminates explicit coordinates from the equations of motion.
fn reduce(system: &System, structure: &Structure, balance: &Balance) -> Dynamics {
    let mut arena = system.arena.clone();
    let mut known = Lookup::default();
    let orientations: Vec<[Expr; 3]> = (0..system.frames.len()).flat_map(|body| system.orientation(&mut arena, body)).collect();
    let orientations: Vec<[Expr; 3]> = orientations.into_iter().map(|motion| motion.map(|expr| arena.plain(expr, &mut known))).collect();
    let [of_positions, of_speeds] = [&system.equations, &system.of_speeds].map(|list| plain(&mut arena, &mut known, list));
    let forces: Vec<Expr> = balance.forces.iter().map(|force| arena.plain(*force, &mut known)).collect();
    let [potential, power] = [balance.potential, balance.power].map(|expr| arena.plain(expr, &mut known));
    let masses = masses(&mut arena, &forces);
    let kinetic = kinetic(&mut arena, &masses);

    let initial: Vec<Equation> = of_positions.iter().filter(|equation| equation.is_initial).cloned().collect();
    // Checked equations follow from the others.
    let solved = |row: &usize| !of_positions[*row].is_initial && !structure.checked.contains(row);
    let solved: Vec<usize> = (0..of_positions.len()).filter(solved).collect();
    let constraints: Vec<Equation> = solved.iter().map(|row| of_positions[*row].clone()).collect();
    let pivots = |row: &usize| system.pattern.rows[*row].iter().filter(|entry| entry.is_pivot).map(|entry| entry.unknown).collect();
    let pivots: Vec<Vec<usize>> = solved.iter().map(pivots).collect();
    let positions = of_positions.iter().filter(|equation| !equation.is_initial).filter_map(Equation::phi);
    let [kinks, kinks_of_forces] = [positions.collect(), forces.clone()].map(|roots: Vec<Expr>| kinks(&mut arena, &roots));
    let by_spins = system.by_spins.as_ref().map(|by_spins| BySpins::plain(&mut arena, &mut known, by_spins));
    let (of_freedoms, of_joints): (Vec<&Equation>, Vec<&Equation>) = of_speeds.iter().partition(|equation| equation.is_initial);
    let departures = initial.iter().chain(of_freedoms.iter().copied()).map(|equation| departure(&mut arena, equation)).collect();
    let mut embedding = Embedding::new(&mut arena, (0..system.coordinates.len()).collect());
    let left = embedding.eliminate(&constraints, &pivots);
    let rows = left.iter().map(|row| &constraints[*row]).chain(of_joints);
    let rows: Vec<MotionRow> = rows.map(|equation| embedding.row(equation)).collect();
    let initial = initial.iter().chain(of_freedoms).map(|equation| embedding.row(equation)).collect();
    let redundant: Vec<MotionRow> = structure.checked.iter().map(|row| embedding.row(&of_positions[*row])).collect();
    // Which of them are solved changes with the place.
    let left = left.iter().map(|row| &solved[*row]);
    let all: Vec<&usize> = if redundant.is_empty() { Vec::new() } else { structure.checked.iter().chain(left).collect() };
    let checked = all.into_iter().filter_map(|row| {
        let Equation { joint, dim, .. } = of_positions[*row];
        Some((joint, embedding.of(of_positions[*row].phi()?), dim.power_of_length()))
    });
    let checked = checked.collect();
    let [kinks, kinks_of_forces] = [kinks, kinks_of_forces].map(|kinks| kinks.into_iter().map(|expr| embedding.of(expr)).collect());
    let mass = embedding.mass(&masses);
    let forces = embedding.forces(&forces);
    let mut state: Vec<[Expr; 3]> = (0..system.coordinates.len()).map(|unknown| embedding.motion(unknown)).collect();
    state.extend(orientations.into_iter().map(|motion| motion.map(|expr| embedding.of(expr))));
    let (integrated, explicit) = (embedding.integrated(), embedding.solved());
    let by_spins = by_spins.map(|equations| BySpins::new(&mut arena, &equations, |row| solved.contains(row), &explicit));
    let zero = arena.integer(0);
    Dynamics {
        arena,
        integrated,
        rows,
        redundant,
        initial,
        departures,
        checked,
        kinks,
        kinks_of_forces,
        mass,
        forces,
        state,
        energies: [kinetic, potential, power],
        accelerations: None,
        with_loads: None,
        zero,
        by_spins,
    }
}

/// Φ and Φ_u u − ν.
fn departure(arena: &mut Arena, equation: &Equation) -> [Expr; 2] {
    let phi = equation.phi().unwrap_or_else(|| arena.integer(0));
    let mut rate = arena.neg(equation.nu);
    for (speed, factor) in &equation.jacobian {
        let speed = arena.leaf(Leaf::Speed(*speed as u32));
        let term = arena.mul(*factor, speed);
        rate = arena.add(rate, term);
    }
    [phi, rate]
}

/// Equations without marks.
fn plain(arena: &mut Arena, known: &mut Lookup<Expr, Expr>, equations: &[Equation]) -> Vec<Equation> {
    let mut equations = equations.to_vec();
    for equation in &mut equations {
        if let Level::Position { phi } = &mut equation.level {
            *phi = arena.plain(*phi, known);
        }
        for expr in equation.jacobian.iter_mut().map(|(_, entry)| entry).chain([&mut equation.nu, &mut equation.gamma]) {
            *expr = arena.plain(*expr, known);
        }
    }
    equations
}

/// Entries of the mass matrix that are not zero, by the number of two speeds.
type Masses = BTreeMap<(usize, usize), Expr>;

/// ∂f/∂u̇
fn masses(arena: &mut Arena, forces: &[Expr]) -> Masses {
    let mut masses = Masses::new();
    for (row, force) in forces.iter().enumerate() {
        for leaf in arena.leaves(*force) {
            if let Leaf::Acceleration(column) = leaf {
                let entry = derivative(arena, *force, leaf);
                masses.insert((row, column as usize), entry);
            }
        }
    }
    masses
}

/// ½ uᵀ M u
fn kinetic(arena: &mut Arena, masses: &Masses) -> Expr {
    let mut sum = arena.integer(0);
    for (&(row, column), &entry) in masses {
        let [u, v] = [row, column].map(|number| arena.leaf(Leaf::Speed(number as u32)));
        let product = arena.mul(u, v);
        let term = arena.mul(entry, product);
        sum = arena.add(sum, term);
    }
    let two = arena.integer(2);
    arena.div(sum, two)
}
