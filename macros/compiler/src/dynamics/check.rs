//! Checks of the equations of motion where the mechanism is assembled: freedoms are independent and complete, and every motion that they
//! leave has a mass.

use super::{Dynamics, massless};
use crate::assembly::Assembly;
use crate::diag::{AssemblyFact, Diag, SystemFact};
use crate::expr::{Expr, Leaf, Values, evaluate};
use crate::linear::Echelon;
use crate::model::{Joint, Mass, Model};
use crate::numeric::{Numeric, at_defaults, is_known};
use crate::quantity::{Ambient, Role};
use crate::system::System;

/// A mass below this part of the one that the motion has by itself, and a speed below this, count as zero.
const NOTHING: f64 = 1e-9;

/// Refuses freedoms that depend on others, freedoms that are missing, equations of velocities on bodies without mass, and motions without
/// mass.
pub(super) fn check(model: &Model, system: &System, assembly: &Assembly, dynamics: &Dynamics, diag: &mut Diag) -> Option<()> {
    if !assembly.is_closed {
        return Some(());
    }
    at_defaults(model, system, |numeric| {
        AtStart::new(numeric, assembly, dynamics).check(assembly, diag)?;
        forces_have_values(numeric, assembly, dynamics, diag)
    })
}

/// Refuses a force in the plane that is no number where the mechanism is assembled; in space the entries of a state behind its unknowns are not
/// at hand here. A force that depends on speeds is judged where nothing moves.
fn forces_have_values(numeric: &Numeric, assembly: &Assembly, dynamics: &Dynamics, diag: &mut Diag) -> Option<()> {
    let (model, system) = (numeric.model, numeric.system);
    let zeros = vec![0.0; system.coordinates.len()];
    let known = Values { coordinates: &assembly.start, speeds: &zeros, accelerations: &zeros, ..numeric.known };
    let Some(loads) = system.loads.as_ref().filter(|_| model.ambient == Ambient::Plane) else { return Some(()) };
    let rates: Vec<Expr> = dynamics.rows.iter().chain(&dynamics.initial).map(|row| row.nu).collect();
    let is_at_rest = evaluate(&dynamics.arena, &rates, &known).iter().all(|rate| *rate == 0.0);
    let is_given = |leaf: &Leaf| !matches!(leaf, Leaf::Input { .. }) && (is_at_rest || !matches!(leaf, Leaf::Speed(_)));
    for (declared, push) in model.declared_forces.iter().zip(&loads.pushes) {
        let is_judged = |root: &&Expr| system.arena.leaves(**root).iter().all(is_given) && is_known(model, system, **root);
        let judged: Vec<Expr> = push.iter().filter(is_judged).copied().collect();
        let has_value = |coordinates: &[f64]| {
            let values = evaluate(&system.arena, &judged, &Values { coordinates, ..known });
            values.iter().all(|value| value.is_finite())
        };
        if has_value(&assembly.start) {
            continue;
        }
        let own = system
            .arena
            .leaves_of(&judged)
            .into_iter()
            .filter_map(|leaf| if let Leaf::Coordinate(own) = leaf { Some(own as usize) } else { None });
        let beside = |(unknown, by): (usize, f64)| {
            let mut there = assembly.start.clone();
            there[unknown] += by * numeric.scale(unknown);
            has_value(&there)
        };
        let probes: Vec<bool> = own.flat_map(|unknown| [(unknown, NOTHING), (unknown, -NOTHING)]).map(beside).collect();
        // A force with values on one side of the start may lack one there through rounding alone.
        if probes.iter().all(|has_one| *has_one) || !probes.contains(&true) {
            return diag.refuse(&declared.name, AssemblyFact::ForceWithoutValue { force: declared.name.to_string() });
        }
    }
    Some(())
}

/// Numbers of the equations of motion where the mechanism is assembled, with lengths in characteristic lengths.
pub(super) struct AtStart<'a> {
    numeric: &'a Numeric<'a>,
    dynamics: &'a Dynamics,
    /// Joint and entries of each equation between speeds, those of freedoms last.
    rows: Vec<(usize, Vec<f64>)>,
    mass: Vec<f64>,
}

impl<'a> AtStart<'a> {
    pub(super) fn new(numeric: &'a Numeric<'a>, assembly: &Assembly, dynamics: &'a Dynamics) -> AtStart<'a> {
        let zeros = vec![0.0; numeric.system.coordinates.len()];
        let known = Values { coordinates: &assembly.start, speeds: &zeros, accelerations: &zeros, ..numeric.known };
        let of = |roots: &[Expr]| evaluate(&dynamics.arena, roots, &known);
        let scales: Vec<f64> = dynamics.integrated.iter().map(|unknown| numeric.scale(*unknown)).collect();
        let is_pin = |(joint, row): (usize, usize)| row >= numeric.model.joints[joint].residuals.len();
        let of_freedoms = dynamics.initial.iter().filter(|row| !is_pin(row.of));
        let scaled = |values: Vec<f64>| values.into_iter().zip(&scales).map(|(value, scale)| value * scale).collect();
        let rows = dynamics.rows.iter().chain(of_freedoms).map(|row| (row.of.0, scaled(of(&row.jacobian)))).collect();
        let places = (0..scales.len()).flat_map(|row| (0..=row).map(move |column| (row, column)));
        let mass = of(&dynamics.mass).into_iter().zip(places).map(|(mass, (row, column))| mass * scales[row] * scales[column]);
        AtStart { numeric, dynamics, rows, mass: mass.collect() }
    }

    /// J.
    pub(super) fn constraints(&self) -> Vec<Vec<f64>> {
        self.rows[..self.dynamics.rows.len()].iter().map(|(_, row)| row.clone()).collect()
    }

    fn check(self, assembly: &Assembly, diag: &mut Diag) -> Option<()> {
        if self.rows.iter().flat_map(|(_, row)| row).chain(&self.mass).any(|value| !value.is_finite()) {
            return Some(());
        }
        let (of_joints, of_freedoms) = self.rows.split_at(self.dynamics.rows.len());
        let mut echelon = Echelon::new(self.dynamics.integrated.len());
        let is_of_velocities = |number: &usize| self.dynamics.rows[*number].phi.is_none();
        let (of_velocities, of_positions): (Vec<usize>, Vec<usize>) = (0..of_joints.len()).partition(is_of_velocities);
        for number in of_positions {
            // One that follows from others here is judged elsewhere.
            echelon.takes(of_joints[number].1.clone());
        }
        for number in of_velocities {
            if !echelon.takes(of_joints[number].1.clone()) {
                return self.repeats(self.dynamics.rows[number].of, diag);
            }
        }
        let motions = echelon.null_space();
        for (joint, row) in of_freedoms {
            if !echelon.takes(row.clone()) {
                return self.depends(*joint, diag);
            }
        }
        match echelon.free().as_slice() {
            [] if of_freedoms.is_empty() => Some(()),
            [] => {
                massless::check(self.numeric, assembly, diag)?;
                self.has_mass(&motions, diag)
            }
            free => self.missing(free, diag),
        }
    }

    fn depends(&self, freedom: usize, diag: &mut Diag) -> Option<()> {
        let Joint { name, residuals, .. } = &self.numeric.model.joints[freedom];
        let of = residuals.len();
        diag.refuse(name, SystemFact::FreedomDepends { freedom: name.to_string(), of })
    }

    fn repeats(&self, (joint, row): (usize, usize), diag: &mut Diag) -> Option<()> {
        let Joint { name, residuals, is_drive, is_redundant, .. } = &self.numeric.model.joints[joint];
        let (of, is_drive, is_redundant) = (residuals.len(), *is_drive, *is_redundant);
        diag.refuse(name, SystemFact::VelocityDepends { joint: name.to_string(), row: row + 1, of, is_drive, is_redundant })
    }

    fn missing(&self, free: &[usize], diag: &mut Diag) -> Option<()> {
        let model = self.numeric.model;
        let mut candidates: Vec<String> = free.iter().map(|column| self.speed(*column)).collect();
        candidates.dedup();
        let declared = model.joints.iter().filter(|joint| joint.freedom.is_some()).map(|joint| joint.residuals.len()).sum();
        let fact = SystemFact::FreedomsMissing { name: model.name.to_string(), missing: free.len(), declared, candidates };
        diag.refuse(&model.name, fact)
    }

    /// An integrated speed, as the language writes it.
    fn speed(&self, column: usize) -> String {
        let unknown = self.dynamics.integrated[column];
        let (model, system) = (self.numeric.model, self.numeric.system);
        let body = &model.bodies[system.coordinates[unknown].body].name;
        match system.coordinates[unknown].role {
            Role::Quaternion(_) => format!("{body}.angular_velocity"),
            Role::Position(_) if !system.frames.is_empty() => format!("rate({body}.position)"),
            _ => system.name(model, unknown),
        }
    }

    /// Checks that the reduced mass matrix is positive definite.
    fn has_mass(&self, motions: &[Vec<f64>], diag: &mut Diag) -> Option<()> {
        let count = self.dynamics.integrated.len();
        let mass = |row: usize, column: usize| {
            let (row, column) = if row < column { (column, row) } else { (row, column) };
            self.mass[row * (row + 1) / 2 + column]
        };
        let product = |one: &[f64], two: &[f64]| -> f64 {
            (0..count).map(|row| one[row] * (0..count).map(|column| mass(row, column) * two[column]).sum::<f64>()).sum()
        };
        // Motions made orthogonal in the metric of the mass, one after the other.
        let mut heavy: Vec<(Vec<f64>, f64)> = Vec::new();
        for motion in motions {
            let mut rest = motion.clone();
            for (other, own) in &heavy {
                let factor = product(other, &rest) / own;
                rest.iter_mut().zip(other).for_each(|(value, other)| *value -= factor * other);
            }
            let own = product(&rest, &rest);
            // A light motion beside a heavy one has a mass all the same.
            if own <= NOTHING * product(motion, motion) {
                return self.massless(&rest, diag);
            }
            heavy.push((rest, own));
        }
        Some(())
    }

    fn massless(&self, motion: &[f64], diag: &mut Diag) -> Option<()> {
        let (model, system) = (self.numeric.model, self.numeric.system);
        let moves = |column: &usize| motion[*column].abs() > NOTHING;
        let mut bodies: Vec<usize> =
            (0..motion.len()).filter(moves).map(|column| system.coordinates[self.dynamics.integrated[column]].body).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let names = bodies.iter().map(|body| model.bodies[*body].name.to_string()).collect();
        let has_any = model.bodies.iter().any(|body| !body.masses.is_empty());
        // A mass that is declared and is 0.
        let known = |expr: &Expr| evaluate(&model.arena, &[*expr], &self.numeric.known) == [0.0];
        let nothing = |mass: &Mass| mass.mass.iter().chain(mass.inertia.iter().flatten()).all(known);
        let is_zero = |body: &&usize| !model.bodies[**body].masses.is_empty() && model.bodies[**body].masses.iter().all(nothing);
        let zero = bodies.iter().filter(is_zero).map(|body| model.bodies[*body].name.to_string()).collect();
        let is_point = |mass: &Mass| mass.mass.is_some() && mass.inertia.is_none();
        let points = bodies.iter().map(|body| &model.bodies[*body]).filter(|body| body.masses.iter().any(is_point));
        let without_inertia = points.map(|body| body.name.to_string()).collect();
        let first = bodies.first().map_or(0, |body| *body);
        diag.refuse(&model.bodies[first].name, SystemFact::Massless { bodies: names, has_any, without_inertia, zero })
    }
}
