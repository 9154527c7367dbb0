//! Joints that contradict the others.
//!
//! In: subsystems whose equations cannot be satisfied near the start, or along the motion of the drives. Out: a refusal of the joint
//! without which they can, with its residual. Not done here: over-determined drives.

use super::Search;
use crate::diag::SystemFact;
use crate::expr::{Expr, Values, evaluate};
use crate::numeric::Numeric;
use crate::numeric::basis::Basis;
use crate::numeric::gap::Opened;
use crate::numeric::samples::Pose;
use crate::quantity::Dim;
use crate::structure::SMALL;
use crate::system::Equation;
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Number of joints, last declared first, that are left out in turn to see whether the rest closes.
const MOST_TRIES: usize = 12;

/// A gap is open if it exceeds this, in rad or characteristic lengths.
const OPEN: f64 = 1e-9;

/// Derivatives lead nowhere if the way by them is this many times as long as the residual, or as the mechanism if that is larger.
const LEAP: f64 = 1e3;

/// Newton steps along the gradient of an equation.
const STRAIGHT_ON: usize = 8;

/// A residual up to this, in rad or characteristic lengths, suggests that the joint was meant to fit.
const NEAR: f64 = 0.01;

/// A row was meant to be redundant if less than this fraction of the unit row is orthogonal to the other rows.
const LITTLE: f64 = 0.1;

/// A row implied by at most this many joints is a duplicate; one implied by more belongs to an over-braced structure.
const FEW: usize = 2;

impl Search<'_, '_> {
    /// The equations cannot be satisfied near the start. Blames the last joint without which they can, joints declared as redundant first.
    ///
    /// These cases are left to `mobility`:
    ///
    /// - Freedoms are left, and the joint is not declared as redundant: a joint is in the wrong place.
    /// - One of several drives is one too many, and the joint is not declared as redundant.
    /// - The joints close without the drives: they form a structure that cannot be driven.
    /// - The joints alone have more equations than coordinates, and many joints are involved: one of them is redundant.
    ///
    /// In the last two cases a joint that nearly fits, or is declared as redundant, is blamed here all the same: it was meant to fit.
    pub(super) fn contradiction(&mut self, start: &[f64]) {
        let model = self.numeric.model;
        let mut candidates: Vec<usize> = self.joints().into_iter().filter(|joint| !model.joints[*joint].is_drive).collect();
        candidates.sort_by_key(|joint| Reverse((model.joints[*joint].is_redundant, *joint)));
        let tries = candidates.into_iter().take(MOST_TRIES);
        let found = tries.filter_map(|joint| Some((joint, self.closes_without(start, &|other| other == joint)?))).next();
        let Some((joint, q)) = found else { return };
        let pose = Pose { time: 0.0, q };
        let is_drive = |joint: usize| model.joints[joint].is_drive;
        // Links that are too short come closest when they lie in line, where they seem to have a freedom.
        if !model.joints[joint].is_redundant && (self.leaves_freedom(start) || self.drives_contend(start)) {
            return;
        }
        let is_meant = model.joints[joint].is_redundant || self.nearly_fits(joint, &pose) && self.nearly_follows(joint, &pose);
        let is_held_twice = || {
            let has_room = self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined).all(|subsystem| {
                let of = |equation: &&usize| !is_drive(self.numeric.system.equations[**equation].joint);
                subsystem.equations.iter().filter(of).count() <= subsystem.unknowns.len()
            });
            let sources = self.sources(joint, &pose);
            let takes_from_drives = sources.iter().copied().any(is_drive);
            !takes_from_drives && (sources.len() <= FEW || has_room && self.closes_without(start, &is_drive).is_none())
        };
        if is_meant || is_held_twice() {
            let nearest = self.nearest(joint, pose);
            self.refuse_contradiction(joint, &nearest, Some(0.0));
        }
    }

    /// True if one of several drives is one too many: without it everything closes and no freedom is left.
    fn drives_contend(&self, start: &[f64]) -> bool {
        let drives: Vec<usize> = self.joints().into_iter().filter(|joint| self.numeric.model.joints[*joint].is_drive).collect();
        let is_too_many = |drive: &usize| {
            let is_of_it = |other: usize| other == *drive;
            self.closes_without(start, &is_of_it).is_some_and(|q| !self.has_freedom_without(&q, *drive))
        };
        drives.len() > 1 && drives.iter().rev().take(MOST_TRIES).any(is_too_many)
    }

    /// The assembly without a joint that minimises the joint's residual: the other joints may leave a freedom.
    fn nearest(&self, joint: usize, pose: Pose) -> Pose {
        let is_of_it = |equation: &usize| self.numeric.system.equations[*equation].joint == joint;
        let subsystem = self.subsystems.iter().find(|subsystem| subsystem.is_overdetermined && subsystem.equations.iter().any(is_of_it));
        let Some(subsystem) = subsystem.filter(|subsystem| subsystem.unknowns.len() <= SMALL) else { return pose };
        match self.numeric.least_gap(&subsystem.unknowns, &subsystem.equations, &pose.q, joint) {
            Opened::Open { q, .. } => Pose { q, ..pose },
            Opened::Closed(_) | Opened::Others => pose,
        }
    }

    /// Joints on whose rows the rows of a joint depend.
    fn sources(&self, joint: usize, pose: &Pose) -> BTreeSet<usize> {
        let mut sources = BTreeSet::new();
        for subsystem in self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined) {
            let of = |row: usize| self.numeric.system.equations[subsystem.equations[row]].joint;
            let (own, others): (Vec<usize>, Vec<usize>) = (0..subsystem.equations.len()).partition(|row| of(*row) == joint);
            let poses = self.numeric.matrices(subsystem, std::slice::from_ref(pose));
            let mut basis = Basis::new(&poses);
            others.into_iter().for_each(|row| basis.take(row));
            let dependent: Vec<usize> = own.into_iter().filter(|row| !basis.takes(*row)).collect();
            sources.extend(dependent.into_iter().flat_map(|row| basis.sources(row)).map(of).filter(|other| *other != joint));
        }
        sources
    }

    /// True if a row of a joint nearly depends on the rows of other joints, drives left out: the row then constrains no motion.
    fn nearly_follows(&self, joint: usize, pose: &Pose) -> bool {
        self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined).any(|subsystem| {
            let poses = self.numeric.matrices(subsystem, std::slice::from_ref(pose));
            let mut basis = Basis::new(&poses);
            let of_joints = (0..subsystem.equations.len()).filter(|row| !self.numeric.joint(subsystem, *row).is_drive);
            let (own, others): (Vec<usize>, Vec<usize>) =
                of_joints.partition(|row| self.numeric.system.equations[subsystem.equations[*row]].joint == joint);
            others.into_iter().for_each(|row| basis.take(row));
            own.into_iter().any(|row| {
                let adds_little = basis.adds(row) < LITTLE;
                basis.take(row);
                adds_little
            })
        })
    }

    /// True if the residual of a joint is small.
    fn nearly_fits(&self, joint: usize, pose: &Pose) -> bool {
        let (length, angle) = self.numeric.misfit(joint, pose);
        length.unwrap_or(0.0) <= NEAR * self.numeric.size && angle.unwrap_or(0.0) <= NEAR
    }

    /// True if the rows of an overdetermined subsystem leave a freedom.
    fn leaves_freedom(&self, q: &[f64]) -> bool {
        self.has_freedom_without(q, usize::MAX)
    }

    /// True if the rows leave a freedom when one joint is left out.
    fn has_freedom_without(&self, q: &[f64], joint: usize) -> bool {
        let pose = [Pose { time: 0.0, q: q.to_vec() }];
        self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined).any(|subsystem| {
            let poses = self.numeric.matrices(subsystem, &pose);
            let mut basis = Basis::new(&poses);
            let of = |row: &usize| self.numeric.system.equations[subsystem.equations[*row]].joint;
            (0..subsystem.equations.len()).filter(|row| of(row) != joint).for_each(|row| basis.take(row));
            !basis.free(subsystem.unknowns.len()).is_empty()
        })
    }

    /// The equations hold at the start, but not along the motion of the drives. Refuses the last joint declared as redundant without which
    /// they do.
    pub(super) fn contradiction_on_the_way(&mut self, start: &[f64]) {
        let marked = self.joints().into_iter().rev().filter(|joint| self.numeric.model.joints[*joint].is_redundant).take(MOST_TRIES);
        for joint in marked {
            let samples = self.numeric.samples(self.subsystems, start, |equation| self.numeric.system.equations[equation].joint == joint);
            if let (true, Some(pose)) = (samples.holds, samples.poses.get(1)) {
                return self.refuse_contradiction(joint, pose, Some(pose.time));
            }
        }
    }

    /// Refuses redundant rows that do not hold: either their residual exceeds rounding when all other rows are closed, or they hold at the
    /// start but nowhere near it, whatever the drives do, which may be at rest at first.
    pub(super) fn contradiction_of_checks(&mut self, start: &[f64], checked: &BTreeSet<usize>) {
        let numeric = self.numeric;
        let joint = |equation: usize| numeric.system.equations[equation].joint;
        let is_drive = |equation: usize| numeric.model.joints[joint(equation)].is_drive;
        let closed = numeric.settled(self.subsystems, 0.0, start.to_vec(), |equation| checked.contains(&equation));
        let closed = closed.map(|q| Pose { time: 0.0, q });
        let elsewhere = numeric.pushed(self.subsystems, start.to_vec(), |equation| checked.contains(&equation) || is_drive(equation));
        for joint in checked.iter().map(|equation| joint(*equation)).collect::<BTreeSet<usize>>() {
            let is_off = |pose: &Pose| numeric.misfit(joint, pose) != (None, None);
            if let Some(pose) = closed.as_ref().filter(|pose| is_off(pose)) {
                return self.refuse_contradiction(joint, pose, Some(0.0));
            }
            // A single pose with a residual may belong to another assembly.
            if elsewhere.len() > FEW && elsewhere[1..].iter().all(is_off) {
                return self.refuse_contradiction(joint, &elsewhere[1], None);
            }
        }
    }

    /// An assembly near the start without some joints.
    fn closes_without(&self, start: &[f64], left_out: &dyn Fn(usize) -> bool) -> Option<Vec<f64>> {
        let leaves_out = |equation: usize| left_out(self.numeric.system.equations[equation].joint);
        self.numeric.settled(self.subsystems, 0.0, start.to_vec(), leaves_out).or_else(|| {
            let (q, is_closed) = self.numeric.assembled_in_order(self.subsystems, leaves_out);
            is_closed.then_some(q)
        })
    }

    /// Joints of all overdetermined subsystems.
    pub(super) fn joints(&self) -> BTreeSet<usize> {
        let subsystems = self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined);
        subsystems.flat_map(|subsystem| &subsystem.equations).map(|equation| self.numeric.system.equations[*equation].joint).collect()
    }

    fn refuse_contradiction(&mut self, joint: usize, pose: &Pose, time: Option<f64>) {
        let numeric = self.numeric;
        let name = &numeric.model.joints[joint].name;
        let (length, angle) = numeric.misfit(joint, pose);
        if length.is_none() && angle.is_none() {
            // Residuals up to rounding count as zero.
            return;
        }
        let (bodies, is_redundant) = (numeric.touched(joint), numeric.model.joints[joint].is_redundant);
        let fact = SystemFact::CannotHold { joint: name.to_string(), bodies, length, angle, time, is_redundant };
        self.diag.refuse::<()>(name, fact);
    }
}

impl Numeric<'_> {
    /// Residual of a joint in m and in rad; `None` if closed.
    fn misfit(&self, joint: usize, pose: &Pose) -> (Option<f64>, Option<f64>) {
        let known = Values { time: pose.time, coordinates: &pose.q, ..self.known };
        let (mut length, mut angle): (Option<f64>, Option<f64>) = (None, None);
        for equation in self.system.of_joint(joint) {
            let is_angle = equation.dim == Dim::ANGLE || equation.dim == Dim::NUMBER && self.is_of_turns(equation);
            let gap = if is_angle { &mut angle } else { &mut length };
            if let Some(way) = self.way(equation, known, pose.q.clone()) {
                *gap = Some(gap.unwrap_or(0.0).hypot(way));
            }
        }
        let is_open = |size: f64| move |gap: &f64| *gap > OPEN * size;
        (length.filter(is_open(self.size)), angle.filter(is_open(1.0)))
    }

    /// Distance by which one body must move until an equation holds, in m, or in rad for an equation of angles; of a length or an angle the residual
    /// where derivatives lead nowhere, as between points that coincide.
    fn way(&self, equation: &Equation, known: Values, q: Vec<f64>) -> Option<f64> {
        let way = self.way_along(equation, known, q.clone());
        let is_square = equation.dim == Dim::LENGTH.times(Dim::LENGTH);
        if !is_square && ![Dim::LENGTH, Dim::ANGLE].contains(&equation.dim) {
            return way;
        }
        let size = if equation.dim == Dim::ANGLE { 1.0 } else { self.size };
        let phi: Vec<Expr> = equation.phi().into_iter().collect();
        let values = evaluate(&self.system.arena, &phi, &Values { coordinates: &q, ..known });
        let off = values.first().map(|off| if is_square { off.abs().sqrt() } else { off.abs() }).filter(|off| off.is_finite());
        let is_sure = |way: &f64| off.is_none_or(|off| *way <= LEAP * off.max(size));
        way.filter(is_sure).or(off)
    }

    /// The same by derivatives, independent of any factor or power in the equation. For a length that only turns change, the residual itself. For
    /// a product of unit vectors, which is a sine, its angle. `None` if the iteration diverges or no body can move.
    fn way_along(&self, equation: &Equation, known: Values, mut q: Vec<f64>) -> Option<f64> {
        if equation.jacobian.is_empty() || self.is_of_turns(equation) && [Dim::NUMBER, Dim::LENGTH].contains(&equation.dim) {
            // Explicit unknowns have made a constant of it, or only turns change it, so that no body can be displaced.
            let values = evaluate(&self.system.arena, &equation.phi().into_iter().collect::<Vec<Expr>>(), &known);
            let off = values.first()?.abs();
            return Some(if equation.dim == Dim::NUMBER { off.min(1.0).asin() } else { off });
        }
        let measures = if equation.dim == Dim::ANGLE { Dim::ANGLE } else { Dim::LENGTH };
        let entries = equation.jacobian.iter().filter(|(unknown, _)| self.system.coordinates[*unknown].role.dim() == measures);
        let body = entries.clone().map(|(unknown, _)| self.system.coordinates[*unknown].body).next_back()?;
        let own: Vec<(usize, Expr)> = entries.filter(|(unknown, _)| self.system.coordinates[*unknown].body == body).copied().collect();
        let roots: Vec<Expr> = equation.phi().into_iter().chain(own.iter().map(|(_, entry)| *entry)).collect();
        let begin = q.clone();
        for _ in 0..STRAIGHT_ON {
            let values = evaluate(&self.system.arena, &roots, &Values { coordinates: &q, ..known });
            let (phi, slopes) = values.split_first()?;
            let share = phi / slopes.iter().map(|slope| slope * slope).sum::<f64>();
            own.iter().zip(slopes).for_each(|((unknown, _), slope)| q[*unknown] -= share * slope);
        }
        let way = own.iter().map(|(unknown, _)| (q[*unknown] - begin[*unknown]).powi(2)).sum::<f64>().sqrt();
        way.is_finite().then_some(way)
    }

    /// True if no displacement changes the equation.
    fn is_of_turns(&self, equation: &Equation) -> bool {
        let is_length = |unknown: &usize| self.system.coordinates[*unknown].role.dim() == Dim::LENGTH;
        !equation.jacobian.iter().any(|(unknown, _)| is_length(unknown))
    }

    /// Bodies in the equations of a joint.
    fn touched(&self, joint: usize) -> Vec<String> {
        let entries = self.system.of_joint(joint).iter().flat_map(|equation| &equation.jacobian);
        let bodies: BTreeSet<usize> = entries.map(|(unknown, _)| self.system.coordinates[*unknown].body).collect();
        bodies.into_iter().map(|body| self.model.bodies[body].name.to_string()).collect()
    }
}
