//! Joints that duplicate or contradict other joints.

use super::elimination::{self, Dependent, Sum};
use crate::diag::{Demand, Diag, MotionFact, SystemFact, quantity as remedy_quantity};
use crate::expr::{Exact as Number, Expr, Leaf, Node, Values, evaluate, show};
use crate::model::{Model, Relationship, Said};
use crate::quantity::{Dim, Role};
use crate::structure::{maximum, underdetermined};
use crate::system::{Equation, System};
use std::collections::BTreeSet;

/// A sum of roots below this may be zero.
const ROOTS: f64 = 1e-9;

/// Rows that depend on others at every configuration, by exact elimination.
pub(crate) struct ExactDependence<'a> {
    model: &'a Model,
    system: &'a System,
    dependent: Vec<Dependent>,
}

impl<'a> ExactDependence<'a> {
    /// Joints come before drives. Joints declared as redundant are left to the numerical test.
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
        for found in dependent.iter().filter(|found| remainder(system, &found.left).is_some()) {
            let joint = system.equations[found.row].joint;
            let name = &model.joints[joint].name;
            if !said.is_new(name) {
                continue;
            }
            let own = dependent.iter().filter(|found| system.equations[found.row].joint == joint);
            let own: Vec<(&Dependent, f64)> = own.filter_map(|found| Some((found, remainder(system, &found.left)?))).collect();
            let contradiction = own.iter().find(|(_, left)| *left != 0.0).map(|(found, _)| *found);
            let of_joint: Vec<&Dependent> = own.iter().map(|(found, _)| *found).collect();
            if model.joints[joint].freedom.is_some() {
                let fact = MotionFact::FreedomIsHeld {
                    freedom: name.to_string(),
                    of: model.joints[joint].residuals.len(),
                    by: joints(model, system, joint, &of_joint),
                    free: free_beside(model, system, joint),
                };
                diag.refuse::<()>(name, fact);
                continue;
            }
            let fact = match contradiction {
                Some(found) => SystemFact::Contradicts {
                    joint: name.to_string(),
                    others: joints(model, system, joint, &[found]),
                    demand: demand(model, system, found).map(Box::new),
                    off: off(model, system, found, &own),
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

    /// Refuses rows that equal a combination of others up to a term in parameters and time: they agree with it only by chance.
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

/// Coordinates that can move if one freedom is left out, angles first.
pub(crate) fn free_beside(model: &Model, system: &System, freedom: usize) -> Vec<String> {
    let mut pattern = system.pattern.clone();
    let of_freedom = pattern.rows.iter_mut().zip(&system.equations).filter(|(_, equation)| equation.joint == freedom);
    of_freedom.for_each(|(row, _)| row.clear());
    let unknowns = underdetermined(&pattern, &maximum(&pattern)).unknowns;
    let (places, angles): (Vec<usize>, Vec<usize>) =
        unknowns.into_iter().partition(|unknown| matches!(system.coordinates[*unknown].role, Role::Position(_) | Role::Displacement));
    let name = |unknown: usize| match system.coordinates[unknown].role {
        Role::Quaternion(_) => format!("{}.angular_velocity", model.bodies[system.coordinates[unknown].body].name),
        _ => system.name(model, unknown),
    };
    let mut names: Vec<String> = angles.into_iter().chain(places).map(name).collect();
    names.dedup();
    names
}

/// Constant remainder of a row: 0 if the row depends on others, another number if it contradicts them. `None` if the remainder depends on
/// parameters or time, or is a sum of roots that may be zero.
fn remainder(system: &System, left: &Sum) -> Option<f64> {
    if left.is_constant() {
        return Some(left.constant.to_f64());
    }
    let terms: Vec<Expr> = left.fixed.keys().copied().collect();
    if terms.iter().any(|term| !system.arena.leaves(*term).is_empty()) {
        return None;
    }
    let functions = |_: u32, _: f64| [f64::NAN; 3];
    let known = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let values = evaluate(&system.arena, &terms, &known);
    let sum = values.iter().zip(left.fixed.values()).map(|(value, factor)| value * factor.to_f64()).sum::<f64>() + left.constant.to_f64();
    (sum.is_finite() && sum.abs() > ROOTS).then_some(sum)
}

/// Size of the contradiction; for the directions of two axes, the angle that is missing between them.
fn off(model: &Model, system: &System, found: &Dependent, own: &[(&Dependent, f64)]) -> String {
    let Equation { joint, row, dim, .. } = system.equations[found.row];
    let is_of_it = |row: usize, (at, first, relation): &(usize, usize, Relationship)| {
        let is_of_directions = matches!(relation, Relationship::SameDirection(..) | Relationship::Perpendicular(..));
        *at == joint && (*first..first + relation.rows()).contains(&row) && is_of_directions
    };
    if let Some(relation) = model.space.relations.iter().find(|relation| is_of_it(row, relation)) {
        let of_axes = own.iter().filter(|(other, _)| is_of_it(system.equations[other.row].row, relation));
        let sine = of_axes.map(|(_, left)| left * left).sum::<f64>().sqrt();
        return format!("{}°", short(sine.min(1.0).asin().to_degrees()));
    }
    if found.left.is_constant() {
        return quantity(found.left.constant.abs(), dim);
    }
    let left = remainder(system, &found.left).unwrap_or(0.0).abs();
    remedy_quantity(short(left), dim)
}

/// Joints of the rows on which a joint's rows depend, the joint itself left out.
fn joints(model: &Model, system: &System, own: usize, found: &[&Dependent]) -> Vec<String> {
    let mut all: BTreeSet<usize> = found.iter().flat_map(|found| &found.others).map(|row| system.equations[*row].joint).collect();
    // Rows in space that hold by the choice of coordinates are not eliminated; their joints are those of the loop.
    all.extend(system.loop_of(own));
    all.into_iter().filter(|joint| *joint != own).map(|joint| model.joints[joint].name.to_string()).collect()
}

/// The combination of coordinates that a row prescribes, its value there and its value by the other rows: `b.angle - a.angle`, 50° and 60°.
fn demand(model: &Model, system: &System, found: &Dependent) -> Option<Demand> {
    let Sum { moving, fixed, constant } = &found.whole;
    let coordinate = |term: &Expr| match system.arena.node(*term) {
        Node::Leaf(Leaf::Coordinate(unknown)) => Some(*unknown as usize),
        _ => None,
    };
    let terms: Option<Vec<(usize, Number)>> = moving.iter().map(|(term, factor)| Some((coordinate(term)?, *factor))).collect();
    let mut terms = terms.filter(|_| fixed.is_empty())?;
    // Positive terms first, scaled so that the first coefficient is 1.
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

/// A value in the unit used on drawings: degrees or mm.
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

/// Rounds to six significant digits.
fn short(value: f64) -> f64 {
    let size = value.abs().log10();
    if !(-30.0..30.0).contains(&size) {
        return value;
    }
    let scale = 10f64.powi(5 - size.floor() as i32);
    (value * scale).round() / scale
}

/// The remainder of a row as a formula.
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
        Leaf::Input { number, .. } => {
            model.parameters.get(number as usize).map_or(String::new(), |parameter| parameter.name.input_path().to_owned())
        }
        _ => "t".to_owned(),
    };
    show(&arena, total, &name, &|_| "f".to_owned())
}
