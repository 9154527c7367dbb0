//! Joints that say again what others say, or the opposite of it.

use super::elimination::{self, Dependent, Sum};
use crate::diag::{Demand, Diag, SystemFact};
use crate::expr::{Exact as Number, Expr, Leaf, Node, show};
use crate::model::{Model, Said};
use crate::quantity::Dim;
use crate::system::System;
use std::collections::BTreeSet;

/// Rows that depend on others everywhere, by exact arithmetic.
pub(crate) struct ExactDependence<'a> {
    model: &'a Model,
    system: &'a System,
    dependent: Vec<Dependent>,
}

impl<'a> ExactDependence<'a> {
    /// Looks at joints before drives. Numbers decide about redundant joints.
    pub(crate) fn new(model: &'a Model, system: &'a System) -> ExactDependence<'a> {
        let mut rows: Vec<(usize, Expr)> =
            system.equations.iter().enumerate().filter_map(|(row, equation)| Some((row, equation.phi()?))).collect();
        rows.retain(|(row, _)| !model.joints[system.equations[*row].joint].is_redundant);
        rows.sort_by_key(|(row, _)| model.joints[system.equations[*row].joint].is_drive);
        ExactDependence { model, system, dependent: elimination::dependent(&system.arena, &rows) }
    }

    /// Refuses joints whose rows are combinations of other rows, or contradict them.
    ///
    /// * `only_entire_joints`: ignore joints of which some rows are independent.
    pub(crate) fn no_row_follows_from_others(&self, only_entire_joints: bool, diag: &mut Diag) {
        let ExactDependence { model, system, dependent } = self;
        let mut said = Said::default();
        for found in dependent.iter().filter(|found| found.left.is_constant()) {
            let joint = system.equations[found.row].joint;
            let name = &model.joints[joint].name;
            if !said.is_new(name) {
                continue;
            }
            let joint_rows = |found: &&Dependent| system.equations[found.row].joint == joint;
            let of_joint: Vec<&Dependent> = dependent.iter().filter(joint_rows).collect();
            let contradiction = of_joint.iter().find(|found| found.left.is_constant() && !found.left.constant.is_zero());
            let fact = match contradiction {
                Some(found) => SystemFact::Contradicts {
                    joint: name.to_string(),
                    others: joints(model, system, joint, &[found]),
                    demand: demand(model, system, found).map(Box::new),
                    off: quantity(found.left.constant.abs(), system.equations[found.row].dim),
                },
                None if only_entire_joints && of_joint.len() < model.joints[joint].residuals.len() => continue,
                None => SystemFact::Follows {
                    joint: name.to_string(),
                    is_drive: model.joints[joint].is_drive,
                    rows: of_joint.iter().map(|found| system.equations[found.row].row + 1).collect(),
                    of: model.joints[joint].residuals.len(),
                    others: joints(model, system, joint, &of_joint),
                },
            };
            diag.refuse::<()>(name, fact);
        }
    }

    /// Refuses rows that differ from a combination of others by a term in parameters and time: they agree at best by chance.
    pub(crate) fn no_rows_collide(&self, diag: &mut Diag) {
        let ExactDependence { model, system, dependent } = self;
        let mut said = Said::default();
        for found in dependent {
            let joint = system.equations[found.row].joint;
            let name = &model.joints[joint].name;
            if said.is_new(name) {
                let others = joints(model, system, joint, &[found]);
                diag.refuse::<()>(name, SystemFact::Collides { joint: name.to_string(), others, off: left(model, system, &found.left) });
            }
        }
    }
}

/// The joints whose rows a joint's rows are made of.
fn joints(model: &Model, system: &System, own: usize, found: &[&Dependent]) -> Vec<String> {
    let all: BTreeSet<usize> = found.iter().flat_map(|found| &found.others).map(|row| system.equations[*row].joint).collect();
    all.into_iter().filter(|joint| *joint != own).map(|joint| model.joints[joint].name.to_string()).collect()
}

/// What a row of coordinates demands, and what the others make of it: `b.angle - a.angle`, 50° and 60°.
fn demand(model: &Model, system: &System, found: &Dependent) -> Option<Demand> {
    let Sum { moving, fixed, constant } = &found.whole;
    let coordinate = |term: &Expr| match system.arena.node(*term) {
        Node::Leaf(Leaf::Coordinate(unknown)) => Some(*unknown as usize),
        _ => None,
    };
    let terms: Option<Vec<(usize, Number)>> = moving.iter().map(|(term, factor)| Some((coordinate(term)?, *factor))).collect();
    let mut terms = terms.filter(|_| fixed.is_empty())?;
    // What is added stands first, and its first multiple is one.
    terms.sort_by_key(|(unknown, factor)| (factor.signum() < 0, *unknown));
    let (first, unit) = *terms.first()?;
    let dim = system.coordinates[first].role.dim();
    let mut form = String::new();
    for (unknown, factor) in &terms {
        let factor = factor.checked_div(unit)?;
        let name = system.name(model, *unknown);
        let sign = match (form.is_empty(), factor.signum() < 0) {
            (true, _) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let size = if factor.abs().is_one() { String::new() } else { format!("{} * ", factor.abs().to_f64()) };
        form += &format!("{sign}{size}{name}");
    }
    let wanted = constant.neg().checked_div(unit)?;
    let found = found.left.constant.checked_sub(*constant)?.checked_div(unit)?;
    Some(Demand { form, wanted: quantity(wanted, dim), found: quantity(found, dim) })
}

/// A value in the unit that a drawing has it in.
fn quantity(value: Number, dim: Dim) -> String {
    let in_unit = |unit: Option<Number>| unit.and_then(|unit| value.checked_div(unit)).unwrap_or(value).to_f64();
    if dim == Dim::ANGLE {
        let degree = Number::ratio(1, 180).and_then(|share| share.checked_mul(Number::PI));
        return format!("{}°", short(in_unit(degree)));
    }
    if dim == Dim::LENGTH {
        return format!("{} mm", short(in_unit(Number::ratio(1, 1000))));
    }
    format!("{} {}", short(value.to_f64()), dim.unit()).trim_end().to_owned()
}

/// Six digits are enough for the eye.
fn short(value: f64) -> f64 {
    let size = value.abs().log10();
    if !(-30.0..30.0).contains(&size) {
        return value;
    }
    let scale = 10f64.powi(5 - size.floor() as i32);
    (value * scale).round() / scale
}

/// What is left of a row as a formula.
fn left(model: &Model, system: &System, sum: &Sum) -> String {
    let mut arena = system.arena.clone();
    let mut total = arena.constant(sum.constant);
    for (term, factor) in &sum.fixed {
        let factor = arena.constant(*factor);
        let product = arena.mul(factor, *term);
        total = arena.add(total, product);
    }
    let name = |leaf: Leaf| match leaf {
        Leaf::Parameter(index) => model.parameters.get(index as usize).map_or(String::new(), |parameter| parameter.name.to_string()),
        _ => "t".to_owned(),
    };
    show(&arena, total, &name, &|_| "f".to_owned())
}
