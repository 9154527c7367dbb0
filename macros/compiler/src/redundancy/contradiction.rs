//! Joints that demand what the others do not allow.
//!
//! In: subsystems whose equations hold nowhere near the start, or not where the drives lead. Out: a refusal of the joint without which
//! they would, and by how much it is off. Not done here: what over-determines the drives.

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

/// Of so many joints, the last declared, it is tried whether the rest closes without them.
const MOST_TRIES: usize = 12;

/// A gap is open if it is more than this, in rad or in lengths of the mechanism.
const OPEN: f64 = 1e-9;

/// Steps of Newton's method along the slope of an equation.
const STRAIGHT_ON: usize = 8;

/// What is off by no more than this, in rad or in lengths of the mechanism, was meant to fit.
const NEAR: f64 = 0.01;

/// Of an equation that was meant to follow from others less than this is left beside them.
const LITTLE: f64 = 0.1;

/// What so many joints hold and one more holds again is no frame.
const FEW: usize = 2;

impl Search<'_, '_> {
    /// The equations hold nowhere near the start: the last joint without which they do contradicts the others, before all others one
    /// that is declared as redundant.
    ///
    /// Where freedoms are left, a joint stands in the wrong place. Where the joints close without the drives, they make a structure
    /// that cannot be driven, and where there are more equations of joints alone than coordinates, and many have a part in it, one that
    /// is held too often: unless the joint nearly fits, so that it was meant to. All that is said elsewhere, in terms of mobility.
    pub(super) fn contradiction(&mut self, start: &[f64]) {
        if self.leaves_freedom(start) {
            return;
        }
        let model = self.numeric.model;
        let mut candidates: Vec<usize> = self.joints().into_iter().filter(|joint| !model.joints[*joint].is_drive).collect();
        candidates.sort_by_key(|joint| Reverse((model.joints[*joint].is_redundant, *joint)));
        let tries = candidates.into_iter().take(MOST_TRIES);
        let found = tries.filter_map(|joint| Some((joint, self.closes_without(start, &|other| other == joint)?))).next();
        let Some((joint, q)) = found else { return };
        let pose = Pose { time: 0.0, q };
        let is_drive = |joint: usize| model.joints[joint].is_drive;
        if !model.joints[joint].is_redundant && self.drives_contend(start) {
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

    /// Of several drives there is one without which everything closes and nothing is left free: it is one drive too many.
    fn drives_contend(&self, start: &[f64]) -> bool {
        let drives: Vec<usize> = self.joints().into_iter().filter(|joint| self.numeric.model.joints[*joint].is_drive).collect();
        let is_too_many = |drive: &usize| {
            let is_of_it = |other: usize| other == *drive;
            self.closes_without(start, &is_of_it).is_some_and(|q| !self.has_freedom_without(&q, *drive))
        };
        drives.len() > 1 && drives.iter().rev().take(MOST_TRIES).any(is_too_many)
    }

    /// Of the assemblies without a joint the one at which it is least off: it may leave the others a freedom.
    fn nearest(&self, joint: usize, pose: Pose) -> Pose {
        let is_of_it = |equation: &usize| self.numeric.system.equations[*equation].joint == joint;
        let subsystem = self.subsystems.iter().find(|subsystem| subsystem.is_overdetermined && subsystem.equations.iter().any(is_of_it));
        let Some(subsystem) = subsystem.filter(|subsystem| subsystem.unknowns.len() <= SMALL) else { return pose };
        match self.numeric.least_gap(&subsystem.unknowns, &subsystem.equations, &pose.q, joint) {
            Opened::Open { q, .. } => Pose { q, ..pose },
            Opened::Closed(_) | Opened::Others => pose,
        }
    }

    /// The joints that hold what a joint holds.
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

    /// One of the equations of a joint nearly follows from those of other joints, drives left out: it holds nothing that would move.
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

    /// The equations of a joint are off by little.
    fn nearly_fits(&self, joint: usize, pose: &Pose) -> bool {
        let (length, angle) = self.numeric.misfit(joint, pose);
        length.unwrap_or(0.0) <= NEAR * self.numeric.size && angle.unwrap_or(0.0) <= NEAR
    }

    /// There are coordinates of which no equation says anything new.
    fn leaves_freedom(&self, q: &[f64]) -> bool {
        self.has_freedom_without(q, usize::MAX)
    }

    /// The same, if a joint says nothing at all.
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

    /// The equations hold at the start, but not when the drives move: a joint that is marked as redundant may be why.
    pub(super) fn contradiction_on_the_way(&mut self, start: &[f64]) {
        let marked = self.joints().into_iter().rev().filter(|joint| self.numeric.model.joints[*joint].is_redundant).take(MOST_TRIES);
        for joint in marked {
            let samples = self.numeric.samples(self.subsystems, start, |equation| self.numeric.system.equations[equation].joint == joint);
            if let (true, Some(pose)) = (samples.holds, samples.poses.get(1)) {
                return self.refuse_contradiction(joint, pose, Some(pose.time));
            }
        }
    }

    /// The equations that are checked do not hold: with the others closed to rounding they are off by a little, or they hold at the start
    /// but nowhere near it, whatever the drives, which may rest at first.
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
            // An assembly that is off may be another one.
            if elsewhere.len() > FEW && elsewhere[1..].iter().all(is_off) {
                return self.refuse_contradiction(joint, &elsewhere[1], None);
            }
        }
    }

    /// An assembly without some joints, near the start.
    fn closes_without(&self, start: &[f64], left_out: &dyn Fn(usize) -> bool) -> Option<Vec<f64>> {
        let leaves_out = |equation: usize| left_out(self.numeric.system.equations[equation].joint);
        self.numeric.settled(self.subsystems, 0.0, start.to_vec(), leaves_out).or_else(|| {
            let (q, is_closed) = self.numeric.assembled_in_order(self.subsystems, leaves_out);
            is_closed.then_some(q)
        })
    }

    /// The joints of all subsystems that have too many equations.
    fn joints(&self) -> BTreeSet<usize> {
        let subsystems = self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined);
        subsystems.flat_map(|subsystem| &subsystem.equations).map(|equation| self.numeric.system.equations[*equation].joint).collect()
    }

    fn refuse_contradiction(&mut self, joint: usize, pose: &Pose, time: Option<f64>) {
        let numeric = self.numeric;
        let name = &numeric.model.joints[joint].name;
        let (length, angle) = numeric.misfit(joint, pose);
        if length.is_none() && angle.is_none() {
            // What is off by no more than rounding is not off.
            return;
        }
        let (bodies, is_redundant) = (numeric.touched(joint), numeric.model.joints[joint].is_redundant);
        let fact = SystemFact::CannotHold { joint: name.to_string(), bodies, length, angle, time, is_redundant };
        self.diag.refuse::<()>(name, fact);
    }
}

impl Numeric<'_> {
    /// How far the equations of a joint are from holding: in m, and in rad.
    fn misfit(&self, joint: usize, pose: &Pose) -> (Option<f64>, Option<f64>) {
        let known = Values { time: pose.time, coordinates: &pose.q, ..self.known };
        let (mut length, mut angle): (Option<f64>, Option<f64>) = (None, None);
        for equation in self.system.of_joint(joint) {
            let gap = if equation.dim == Dim::ANGLE { &mut angle } else { &mut length };
            if let Some(way) = self.way(equation, known, pose.q.clone()) {
                *gap = Some(gap.unwrap_or(0.0).hypot(way));
            }
        }
        let is_open = |size: f64| move |gap: &f64| *gap > OPEN * size;
        (length.filter(is_open(self.size)), angle.filter(is_open(1.0)))
    }

    /// The way that one body has to go until an equation holds, whatever it is a multiple or a power of; in m, or in rad where it is an
    /// angle that is off. None if no way leads there.
    fn way(&self, equation: &Equation, known: Values, mut q: Vec<f64>) -> Option<f64> {
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

    /// The bodies in the equations of a joint.
    fn touched(&self, joint: usize) -> Vec<String> {
        let entries = self.system.of_joint(joint).iter().flat_map(|equation| &equation.jacobian);
        let bodies: BTreeSet<usize> = entries.map(|(unknown, _)| self.system.coordinates[*unknown].body).collect();
        bodies.into_iter().map(|body| self.model.bodies[body].name.to_string()).collect()
    }
}
