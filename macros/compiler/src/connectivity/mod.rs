//! Connectivity: every body must be connected to ground, directly or through other bodies, and every force must act on one.
//!
//! A body whose coordinates occur in no equation is not connected. A group of connected bodies floats if it can be translated as a whole:
//! no equation of the group changes when the same value is added to x, or to y, of all its bodies. An equation on a single body prevents
//! this unless it contains only its angle. For a group of one body, `mobility` reports undetermined coordinates.

use crate::diag::{Diag, EquationFact, SystemFact};
use crate::expr::{Arena, Expr, Leaf, Values, evaluate};
use crate::model::{DeclaredForce, Model, Said, example};
use crate::quantity::{Axis, Role, SpeedRole};
use crate::system::{Equation, System};
use std::collections::{BTreeMap, BTreeSet};

/// Refuses bodies and groups of bodies that are not connected to ground, and forces on ground alone.
pub(crate) fn check(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    every_force_acts_on_a_body(model, diag);
    if model.task.is_determined() {
        every_body_is_held(model, system, diag);
        every_group_is_on_ground(model, system, diag);
    }
    diag.is_clean().then_some(())
}

/// Refuses forces none of whose vectors acts on a body.
fn every_force_acts_on_a_body(model: &Model, diag: &mut Diag) {
    let mut said = Said::default();
    for (number, DeclaredForce { name, .. }) in model.declared_forces.iter().enumerate() {
        let mut own = model.forces.iter().filter(|force| force.of == number).peekable();
        if own.peek().is_some() && own.all(|force| force.body.is_none()) && said.is_new(name) {
            diag.refuse::<()>(name, EquationFact::ForceOnGround { force: name.to_string(), ambient: model.ambient });
        }
    }
}

/// Refuses bodies whose coordinates occur in no equation.
fn every_body_is_held(model: &Model, system: &System, diag: &mut Diag) {
    let rows = Declarations::of(system);
    let held: BTreeSet<usize> = (0..rows.equations.len()).flat_map(|row| rows.bodies(row)).collect();
    let mut said = Said::default();
    let on_ground = bodies_on_ground(model, system);
    for (index, body) in model.bodies.iter().enumerate() {
        if !held.contains(&index) && said.is_new(&body.name) {
            let example = example::joint(model, &example::place_of_one(model, on_ground.iter().copied()), &example::place_of(model, index));
            diag.refuse::<()>(&body.name, SystemFact::BodyIsFree { body: body.name.to_string(), example });
        }
    }
}

/// Refuses groups of connected bodies that are not connected to ground.
fn every_group_is_on_ground(model: &Model, system: &System, diag: &mut Diag) {
    let Groups { groups, of_group, is_held } = Groups::new(model, system);
    let mut said = Said::default();
    let mut scratch: Option<Arena> = None;
    let all = Declarations::of(system);
    for (group, rows) in of_group.iter().filter(|(group, _)| !is_held.contains(group)) {
        let arena = scratch.get_or_insert_with(|| all.arena.clone());
        let bodies: Vec<usize> = (0..groups.len()).filter(|body| groups[*body] == *group).collect();
        let floats = rows.iter().all(|row| can_be_shifted(&all, arena, &all.equations[*row]));
        if floats && said.is_new(&model.bodies[bodies[0]].name) {
            let names = bodies.iter().map(|body| model.bodies[*body].name.to_string()).collect();
            diag.refuse::<()>(&model.bodies[bodies[0]].name, SystemFact::NotOnGround { bodies: names });
        }
    }
}

/// Bodies connected to ground, directly or through others.
fn bodies_on_ground(model: &Model, system: &System) -> BTreeSet<usize> {
    let Groups { groups, is_held, .. } = Groups::new(model, system);
    (0..groups.len()).filter(|body| is_held.contains(&groups[*body])).collect()
}

/// Equations by coordinates in the plane, and as declared, by speeds, in space.
struct Declarations<'a> {
    equations: &'a [Equation],
    arena: &'a Arena,
    system: &'a System,
}

impl<'a> Declarations<'a> {
    fn of(system: &'a System) -> Declarations<'a> {
        match &system.declared {
            Some(declared) => Declarations { equations: &declared.equations, arena: &declared.arena, system },
            None => Declarations { equations: &system.equations, arena: &system.arena, system },
        }
    }

    /// Body of a column, and its axis if it moves the origin of the body.
    fn column(&self, column: usize) -> (usize, Option<Axis>) {
        if self.system.declared.is_some() {
            let speed = SpeedRole::SPACE[column % SpeedRole::SPACE.len()];
            let axis = if let SpeedRole::Linear(axis) = speed { Some(axis) } else { None };
            return (column / SpeedRole::SPACE.len(), axis);
        }
        let coordinate = &self.system.coordinates[column];
        let axis = if let Role::Position(axis) = coordinate.role { Some(axis) } else { None };
        (coordinate.body, axis)
    }

    /// Bodies in an equation.
    fn bodies(&self, row: usize) -> BTreeSet<usize> {
        self.equations[row].jacobian.iter().map(|(column, _)| self.column(*column).0).collect()
    }
}

/// Groups of connected bodies.
struct Groups {
    /// Group of each body.
    groups: Vec<usize>,
    /// Equations of each group that has any.
    of_group: BTreeMap<usize, Vec<usize>>,
    /// Groups held by an equation on a single body that contains more than its angle, or on the group's only body.
    is_held: BTreeSet<usize>,
}

impl Groups {
    fn new(model: &Model, system: &System) -> Groups {
        let rows = Declarations::of(system);
        let bodies_of: Vec<BTreeSet<usize>> = (0..rows.equations.len()).map(|row| rows.bodies(row)).collect();
        let groups = groups(model.bodies.len(), &bodies_of);
        let mut of_group: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let mut is_held: BTreeSet<usize> = BTreeSet::new();
        let is_alone = |group: usize| groups.iter().filter(|other| **other == group).count() == 1;
        let is_of_angles = |row: usize| rows.equations[row].jacobian.iter().all(|(column, _)| rows.column(*column).1.is_none());
        for (row, bodies) in bodies_of.iter().enumerate() {
            let Some(first) = bodies.first() else { continue };
            of_group.entry(groups[*first]).or_default().push(row);
            if bodies.len() == 1 && (!is_of_angles(row) || is_alone(groups[*first])) {
                is_held.insert(groups[*first]);
            }
        }
        Groups { groups, of_group, is_held }
    }
}

/// Group of each body, named by the first body in it.
fn groups(bodies: usize, rows: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..bodies).collect();
    fn root(parent: &mut [usize], mut body: usize) -> usize {
        while parent[body] != body {
            parent[body] = parent[parent[body]];
            body = parent[body];
        }
        body
    }
    for row in rows {
        let mut members = row.iter();
        let Some(first) = members.next() else { continue };
        for other in members {
            let (one, two) = (root(&mut parent, *first), root(&mut parent, *other));
            parent[one.max(two)] = one.min(two);
        }
    }
    (0..bodies).map(|body| root(&mut parent, body)).collect()
}

/// True if Σ ∂Φ/∂x = 0 over all bodies, and the same for the other axes.
fn can_be_shifted(rows: &Declarations, arena: &mut Arena, equation: &Equation) -> bool {
    [Axis::X, Axis::Y, Axis::Z].into_iter().all(|axis| {
        let entries: Vec<Expr> =
            equation.jacobian.iter().filter(|(column, _)| rows.column(*column).1 == Some(axis)).map(|(_, entry)| *entry).collect();
        let zero = arena.integer(0);
        let sum = entries.into_iter().fold(zero, |sum, entry| arena.add(sum, entry));
        sum == zero || vanishes(arena, sum)
    })
}

/// True if a sum that is not simplified to zero is zero to rounding at arbitrary configurations.
fn vanishes(arena: &Arena, sum: Expr) -> bool {
    let numbers = |seed: f64, count: usize| (1..=count).map(|index| 0.5 + (seed * index as f64).fract()).collect::<Vec<f64>>();
    [0.618_033_988_75, 0.754_877_666_25].into_iter().all(|seed| {
        let count = |of: fn(Leaf) -> Option<u32>| arena.leaves(sum).into_iter().filter_map(of).max().map_or(0, |most| most as usize + 1);
        let coordinates = numbers(seed, count(|leaf| if let Leaf::Coordinate(index) = leaf { Some(index) } else { None }));
        let parameter = |leaf: Leaf| match leaf {
            Leaf::Parameter(index) => Some(index),
            Leaf::Input { number, order } => Some(number + u32::from(order)),
            _ => None,
        };
        let parameters = numbers(seed * seed, count(parameter));
        let (coordinates, parameters, functions) = (&coordinates, &parameters, &|_: u32, _: f64| [f64::NAN; 3]);
        let at = Values { time: seed, parameters, coordinates, speeds: &[], accelerations: &[], functions };
        evaluate(arena, &[sum], &at)[0].abs() < 1e-12
    })
}
