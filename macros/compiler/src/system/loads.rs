//! The equations of the loads, by the speeds of the bodies.
//!
//! ```text
//! Φ_uᵀ λ = −f      f = M u̇ − Q
//! ```
//!
//! Leaves are the entries of a state. In space the unknowns are followed by the rotation matrices with ω and ω̇.

use super::rows::Row;
use super::{COSINES, Equation, Level, balance, cosine, declared, dynamics, parallel};
use crate::expr::{Arena, Binary, Expr, Leaf, Lookup, Mark, Node, Substitution, Triple, combination, derivative};
use crate::model::{DECLARED, Model, Triad};
use crate::quantity::{Dim, Role, SpeedRole};
use std::collections::BTreeMap;

/// Forces that joints and drives have to supply: M u̇ − Q.
#[derive(Clone, Debug)]
pub struct LoadEquations {
    /// f, by speed of the bodies.
    pub forces: Vec<Expr>,
    /// Equations of joints and drives in the order of λ, then those of freedoms.
    pub rows: Vec<LoadRow>,
    /// For each joint the body on which its load is stated, and the arm of its point there.
    pub arms: Vec<Option<(usize, Vec<Expr>)>>,
    /// Kinetic energy, potential energy, and power of the forces declared.
    pub energies: [Expr; 3],
    /// For each force declared its force and torque vectors, and its power.
    pub pushes: Vec<Vec<Expr>>,
}

/// An equation by the speeds of the bodies.
#[derive(Clone, Debug)]
pub struct LoadRow {
    /// Index of its joint in the model.
    pub joint: usize,
    /// Dimension of Φ.
    pub dim: Dim,
    /// Entries of Φ_u that are not identically zero, by speed.
    pub jacobian: Vec<(usize, Expr)>,
    /// ν
    pub nu: Expr,
    /// ∂Φ/∂s of a drive that compares the square of a length s with the square of a law: 2 s, from the law.
    pub slope: Option<Expr>,
    /// True if it belongs to a freedom.
    pub is_of_freedom: bool,
    /// True if it is declared as an equation of velocities, even if it is solved as one of positions.
    pub is_of_velocities: bool,
}

impl LoadEquations {
    /// In the declared coordinates; `None` if there is neither a mass nor a force.
    ///
    /// * `aligned`: the triads of each angle of a joint that keeps its axes in one direction, with equal z axes.
    pub(super) fn declared(model: &Model, arena: &mut Arena, aligned: &BTreeMap<u32, [Triad; 2]>) -> Option<LoadEquations> {
        let forces = dynamics::unbalanced(model, arena, &[])?;
        let mut angles = JointAngles::new(model, arena, aligned);
        let declared = Row::declared(model).map(|row| Row { residual: angles.apart(arena, row.residual), ..row });
        let declared: Vec<Row> = declared.collect();
        let mut equations = declared::equations(model, arena, declared.iter());
        for (row, equation) in declared.iter().zip(&mut equations) {
            angles.add_slopes(arena, row, equation);
        }
        parallel::by_axes_of_one_body(model, arena, aligned, &mut equations);
        let rows = rows(model, arena, equations.iter());
        Some(LoadEquations::new(model, arena, forces, rows))
    }

    /// In the plane, where the declared coordinates are the unknowns.
    pub(super) fn in_plane<'a>(model: &Model, arena: &mut Arena, equations: impl Iterator<Item = &'a Equation>) -> Option<LoadEquations> {
        let forces = dynamics::unbalanced(model, arena, &[])?;
        let is_pin = |equation: &Equation| equation.row >= model.joints[equation.joint].residuals.len();
        let rows = rows(model, arena, equations.filter(|equation| !is_pin(equation)));
        Some(LoadEquations::new(model, arena, forces, rows))
    }

    fn new(model: &Model, arena: &mut Arena, forces: Vec<Expr>, rows: Vec<LoadRow>) -> LoadEquations {
        LoadEquations { forces, rows, arms: arms(model, arena), energies: energies(model, arena), pushes: balance::pushes(model, arena) }
    }

    /// Every expression, as `of` writes it.
    pub(super) fn map(mut self, mut of: impl FnMut(Expr) -> Expr) -> LoadEquations {
        let rows =
            self.rows.iter_mut().flat_map(|row| row.jacobian.iter_mut().map(|(_, entry)| entry).chain([&mut row.nu]).chain(&mut row.slope));
        let arms = self.arms.iter_mut().flatten().flat_map(|(_, arm)| arm);
        let pushes = self.pushes.iter_mut().flatten();
        self.forces.iter_mut().chain(rows).chain(arms).chain(&mut self.energies).chain(pushes).for_each(|expr| *expr = of(*expr));
        self
    }

    /// With the rates of the unknowns that drives prescribe for those of their laws, which are sines at times.
    ///
    /// * `equations`: of positions, by the unknowns.
    pub(super) fn with_rates(mut self, model: &Model, arena: &mut Arena, equations: &[Equation]) -> LoadEquations {
        let one = arena.integer(1);
        for row in self.rows.iter_mut().filter(|row| model.joints[row.joint].is_drive) {
            if arena.as_constant(row.nu).is_some() {
                continue;
            }
            let mut own = equations.iter().filter(|equation| equation.joint == row.joint);
            if let (Some(Equation { jacobian, level: Level::Position { .. }, .. }), None) = (own.next(), own.next())
                && let [(unknown, entry)] = jacobian.as_slice()
                && *entry == one
            {
                row.nu = arena.leaf(Leaf::Speed(*unknown as u32));
            }
        }
        self
    }

    /// In space, with vectors of bodies by the entries of rotation matrices, ω and ω̇ as a state holds them behind its unknowns.
    pub(super) fn by_state(self, arena: &mut Arena, frames: &[usize], unknowns: usize) -> LoadEquations {
        let mut known = Lookup::default();
        for (body, frame) in frames.iter().enumerate() {
            let frame = arena.frame(*frame);
            let [velocity, acceleration] = [frame.velocity, frame.acceleration];
            for axis in 0..3 {
                let number = (unknowns + COSINES * body + axis) as u32;
                for (expr, leaf) in [(velocity[axis], Leaf::Speed(number)), (acceleration[axis], Leaf::Acceleration(number))] {
                    if arena.as_constant(expr).is_none() {
                        let leaf = arena.leaf(leaf);
                        known.entry(expr).or_insert(leaf);
                    }
                }
            }
        }
        self.map(|root| {
            let whole = |node: &Node| matches!(node, Node::Marked { mark: Mark::Turned { .. }, .. });
            for expr in arena.reachable_above(&[root], whole) {
                if known.contains_key(&expr) {
                    continue;
                }
                let node = *arena.node(expr);
                let new = match node {
                    Node::Marked { mark: Mark::Turned { vector, axis }, value } => {
                        turned(arena, frames, unknowns, vector, usize::from(axis))
                            .unwrap_or_else(|| arena.plain(value, &mut Lookup::default()))
                    }
                    Node::Marked { value, .. } => known[&value],
                    _ => {
                        let children: Vec<Expr> = node.children().map(|child| known[&child]).collect();
                        arena.with_children(expr, &children)
                    }
                };
                known.insert(expr, new);
            }
            known[&root]
        })
    }
}

/// A component of a vector fixed in a body, by the entries of its rotation matrix; `None` if the frame is no body's.
fn turned(arena: &mut Arena, frames: &[usize], unknowns: usize, vector: u32, axis: usize) -> Option<Expr> {
    let (frame, local) = arena.vector(vector);
    let body = frames.iter().position(|own| *own == frame)?;
    let columns = [0, 1, 2].map(|column| [0, 1, 2].map(|row| arena.leaf(Leaf::Coordinate((unknowns + cosine(body, row, column)) as u32))));
    Some(combination(arena, local, columns)[axis])
}

/// Angles of joints as variables of their own: where the axes stay in one direction, an angle turns with the bodies about the axis.
struct JointAngles {
    known: Vec<JointAngle>,
    replaced: Lookup<Expr, Expr>,
    back: Substitution,
}

struct JointAngle {
    /// As a variable.
    leaf: Leaf,
    /// As declared.
    expr: Expr,
    /// Bodies, with the directions about which their turns let it grow.
    turns: Vec<(usize, Triple)>,
}

impl JointAngles {
    fn new(model: &Model, arena: &mut Arena, aligned: &BTreeMap<u32, [Triad; 2]>) -> JointAngles {
        let (mut known, mut back) = (Vec::new(), Substitution::new());
        for (number, [one, two]) in aligned {
            let (_, expr) = &model.space.quantities[*number as usize];
            // The rows of the same joint are by the axes of the first body as well.
            let axis = one.in_ground(arena)[2];
            let leaf = Leaf::Coordinate(DECLARED + (Role::SPACE.len() * model.bodies.len()) as u32 + *number);
            back.replace(leaf, *expr);
            let mut turns = Vec::new();
            for (triad, is_ahead) in [(two, true), (one, false)] {
                let Some(body) = triad.body else { continue };
                turns.push((body, if is_ahead { axis } else { axis.map(|part| arena.neg(part)) }));
            }
            known.push(JointAngle { leaf, expr: *expr, turns });
        }
        JointAngles { known, replaced: Lookup::default(), back }
    }

    /// An expression with the leaves of angles.
    fn apart(&mut self, arena: &mut Arena, root: Expr) -> Expr {
        let whole = |node: &Node| matches!(node, Node::Marked { .. });
        for expr in arena.reachable_above(&[root], whole) {
            if self.replaced.contains_key(&expr) {
                continue;
            }
            let node = *arena.node(expr);
            let leaf = self.known.iter().find(|angle| angle.expr == expr).map(|angle| angle.leaf);
            let new = match (leaf, node) {
                (Some(leaf), _) => arena.leaf(leaf),
                (None, Node::Marked { .. }) => expr,
                _ => {
                    let children: Vec<Expr> = node.children().map(|child| self.replaced[&child]).collect();
                    arena.with_children(expr, &children)
                }
            };
            self.replaced.insert(expr, new);
        }
        self.replaced[&root]
    }

    /// Adds the derivatives of an equation by its angles, and restores the angles.
    fn add_slopes(&mut self, arena: &mut Arena, row: &Row, equation: &mut Equation) {
        let leaves = arena.leaves(row.residual);
        for angle in self.known.iter().filter(|angle| leaves.contains(&angle.leaf)) {
            let slope = derivative(arena, row.residual, angle.leaf);
            for (speed, part) in angle.turns.iter().flat_map(|(body, axis)| SpeedRole::angular(*body).into_iter().zip(*axis)) {
                let product = arena.mul(slope, part);
                match equation.jacobian.iter_mut().find(|(known, _)| *known == speed) {
                    Some((_, entry)) => *entry = arena.add(*entry, product),
                    None => equation.jacobian.push((speed, product)),
                }
            }
        }
        equation.jacobian.retain(|(_, entry)| !arena.as_constant(*entry).is_some_and(|value| value.is_zero()));
        equation.nu = self.back.of(arena, equation.nu);
        equation.jacobian.iter_mut().for_each(|(_, entry)| *entry = self.back.of(arena, *entry));
    }
}

fn rows<'a>(model: &Model, arena: &mut Arena, equations: impl Iterator<Item = &'a Equation>) -> Vec<LoadRow> {
    let row = |equation: &Equation| LoadRow {
        slope: slope(model, arena, equation),
        joint: equation.joint,
        dim: equation.dim,
        jacobian: equation.jacobian.clone(),
        nu: equation.nu,
        is_of_freedom: equation.is_initial,
        is_of_velocities: model.joints[equation.joint].residuals.get(equation.row).is_some_and(|residual| residual.is_velocity),
    };
    let mut rows: Vec<LoadRow> = equations.map(row).collect();
    rows.sort_by_key(|row| (row.is_of_freedom, row.joint));
    rows
}

/// 2 C of a drive s² = C².
fn slope(model: &Model, arena: &mut Arena, equation: &Equation) -> Option<Expr> {
    let joint = &model.joints[equation.joint];
    let residual = joint.residuals.get(equation.row).filter(|_| joint.is_drive && equation.dim == Dim::LENGTH.times(Dim::LENGTH))?;
    let Node::Binary(Binary::Sub, left, right) = *arena.node(residual.expr) else { return None };
    let is_law = |expr: &Expr| !arena.leaves(*expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_)));
    let law = [right, left].into_iter().find(is_law)?;
    let length = arena.sqrt(law);
    let length = if law == right { length } else { arena.neg(length) };
    Some(arena.twice(length))
}

fn energies(model: &Model, arena: &mut Arena) -> [Expr; 3] {
    let kinetic = dynamics::kinetic(model, arena);
    let [potential, power] = balance::energies(model, arena);
    [kinetic, potential, power]
}

fn arms(model: &Model, arena: &mut Arena) -> Vec<Option<(usize, Vec<Expr>)>> {
    let arms = model.joints.iter().map(|joint| {
        let (body, local) = joint.place.as_ref()?;
        Some((*body, dynamics::arm(model, arena, *body, local)))
    });
    arms.collect()
}
