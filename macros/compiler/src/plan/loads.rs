//! Code of the loads.

use super::routine::Routine;
use super::schedule;
use super::words::Words;
use crate::dynamics::Loads;
use crate::expr::{Arena, Expr, Members, Node, Unary};
use crate::model::{Model, Name};
use crate::quantity::Ambient;
use crate::system::{LoadEquations, System};
use std::ops::Range;

/// Code of the loads, each routine with its results in the order stated.
#[derive(Clone, Debug)]
pub struct LoadsCode {
    /// All expressions.
    pub arena: Arena,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Number of results of `actions`.
    pub width: usize,
    /// Equation and speed of each entry of Φ_u.
    pub pattern: Vec<(usize, usize)>,
    /// Entries of Φ_u, then f.
    pub equations: Routine,
    /// Forces and torques of joints and powers of drives, from multipliers as data.
    pub actions: Routine,
    /// λ, the loads of joints and drives, and each checked number with its lower bound.
    pub closed: Option<Routine>,
    /// Kinetic energy, potential energy, and power of the forces declared.
    pub energies: Routine,
    /// Joints, drives and forces, in this order.
    pub named: Vec<NamedLoad>,
}

/// The load of a joint, a drive or a force.
#[derive(Clone, Debug)]
pub struct NamedLoad {
    /// Name.
    pub name: Name,
    /// Kind of the load.
    pub kind: LoadKind,
    /// Its multipliers among all.
    pub multipliers: Range<usize>,
    /// Its numbers among the results of `actions`.
    pub actions: Range<usize>,
    /// It can be computed alone.
    pub is_slice: bool,
    /// For a load that can be computed alone: its multipliers and numbers, and each checked number with its lower bound; `None` where
    /// multipliers are not in closed form.
    pub alone: Option<Routine>,
}

/// Kind of a load.
#[derive(Clone, Debug, PartialEq)]
pub enum LoadKind {
    /// Effort and power.
    Drive,
    /// Force and torque on the body of this index.
    Joint(usize),
    /// The same where the bodies of the joint do not get opposite loads; about the origin of the body unless it is where the joint states its load.
    Share {
        /// Index of the body.
        body: usize,
        /// About the point of the joint.
        is_stated: bool,
    },
    /// Multipliers alone.
    Equations,
    /// Vectors in the order declared, each on a body or on ground: true for torques.
    Force(Vec<(bool, Option<usize>)>),
}

/// Plans the loads.
pub(super) fn code(model: &Model, system: &System, loads: Option<&Loads>) -> Option<LoadsCode> {
    let (loads, equations) = (loads?, system.loads.as_ref()?);
    let words = Words::new(model, system);
    let arena = loads.arena.clone();
    let line = |results: Vec<Expr>| schedule::routine(&arena, results, &words);
    let rows = || equations.rows.iter().filter(|row| !row.is_of_freedom);
    let entries = || rows().enumerate().flat_map(|(number, row)| row.jacobian.iter().map(move |(speed, entry)| ((number, *speed), *entry)));
    let closed = loads.closed.as_ref().map(|found| {
        let results = found.values.iter().chain(&found.actions).chain(found.checks.iter().flatten());
        line(results.copied().collect())
    });
    let mut named = named(model, equations, loads);
    for load in named.iter_mut().filter(|load| load.is_slice) {
        load.alone = alone(loads, load).map(line);
    }
    Some(LoadsCode {
        multipliers: rows().count(),
        width: loads.actions.len(),
        pattern: entries().map(|(place, _)| place).collect(),
        equations: line(entries().map(|(_, entry)| entry).chain(equations.forces.iter().copied()).collect()),
        actions: line(loads.actions.clone()),
        closed,
        energies: line(equations.energies.to_vec()),
        named,
        arena,
    })
}

/// Where joints, drives and forces stand among multipliers and actions.
fn named(model: &Model, equations: &LoadEquations, loads: &Loads) -> Vec<NamedLoad> {
    let each = if model.ambient == Ambient::Space { 6 } else { 3 };
    let (mut first, mut at, mut named) = (0, 0, Vec::new());
    for (index, joint) in model.joints.iter().enumerate().filter(|(_, joint)| joint.freedom.is_none()) {
        let count = equations.rows.iter().filter(|row| row.joint == index).count();
        let others = loads.shares.get(&index);
        let (kind, width) = match &equations.arms[index] {
            _ if joint.is_drive => (LoadKind::Drive, 2),
            Some((body, _)) if others.is_some() => (LoadKind::Share { body: *body, is_stated: true }, each),
            Some((body, _)) => (LoadKind::Joint(*body), each),
            None => (LoadKind::Equations, 0),
        };
        let (multipliers, actions) = (first..first + count, at..at + width);
        named.push(NamedLoad { name: joint.name.clone(), kind, multipliers, actions, is_slice: joint.is_slice, alone: None });
        at += width;
        for body in others.into_iter().flatten() {
            let (multipliers, actions) = (first..first + count, at..at + each);
            let (name, kind) = (joint.name.on(&model.bodies[*body].name), LoadKind::Share { body: *body, is_stated: false });
            named.push(NamedLoad { name, kind, multipliers, actions, is_slice: joint.is_slice, alone: None });
            at += each;
        }
        first += count;
    }
    for (number, (force, push)) in model.declared_forces.iter().zip(&equations.pushes).enumerate() {
        let own = model.forces.iter().filter(|part| part.of == number);
        let kind = LoadKind::Force(own.map(|part| (part.point.is_none(), part.body)).collect());
        let (name, is_slice) = (force.name.clone(), force.is_slice);
        named.push(NamedLoad { name, kind, multipliers: first..first, actions: at..at + push.len(), is_slice, alone: None });
        at += push.len();
    }
    Name::tell_apart(named.iter_mut().map(|load| &mut load.name).collect());
    named
}

/// The results of a load by itself: its multipliers, its actions, and the checks of its divisors.
fn alone(loads: &Loads, load: &NamedLoad) -> Option<Vec<Expr>> {
    if let LoadKind::Force(_) = load.kind {
        return Some(loads.actions[load.actions.clone()].to_vec());
    }
    let (closed, arena) = (loads.closed.as_ref()?, &loads.arena);
    let is_equations = load.kind == LoadKind::Equations;
    let multipliers = if !is_equations { &[] } else { &closed.values[load.multipliers.clone()] };
    let mut results: Vec<Expr> = multipliers.iter().chain(&closed.actions[load.actions.clone()]).copied().collect();
    let reached = |roots: &[Expr]| arena.reachable(roots).into_iter().collect::<Members<Expr>>();
    let whole: Vec<Expr> = closed.values.iter().chain(&closed.actions).copied().collect();
    let (own, all) = (reached(&results), reached(&whole));
    let divisor = |size: Expr| match *arena.node(size) {
        Node::Unary(Unary::Abs, divisor) => divisor,
        _ => size,
    };
    // A divisor that no result contains in this form may belong to any of them.
    let counts = |check: &&[Expr; 2]| own.contains(&divisor(check[0])) || !all.contains(&divisor(check[0]));
    results.extend(closed.checks.iter().filter(counts).flatten());
    Some(results)
}
