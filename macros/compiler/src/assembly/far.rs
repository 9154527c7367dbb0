//! Assemblies far from the declared start.
//!
//! In: the assembly. Out: a [`Warning`] for each body whose angle or position, and for each joint whose angle or displacement is far from its
//! declared start. A start only selects an assembly and need not be near it; but a distant one is rarely intended.

use crate::diag::{Doubt, Warning, degrees, millimetres, significant};
use crate::expr::{Expr, Values, evaluate};
use crate::model::{JointQuantity, Said};
use crate::numeric::Numeric;
use crate::numeric::turns::within_a_turn;
use crate::quantity::Ambient;
use crate::structure::Structure;
use core::f64::consts::{FRAC_PI_4, TAU};

/// An angle that differs from its declared value by more than this is far, in rad.
const FAR_ANGLE: f64 = FRAC_PI_4;

/// A position that differs from its declared value by more than this is far, in characteristic lengths.
const FAR_PLACE: f64 = 1.0 / 3.0;

/// Largest number of bodies reported.
const MOST: usize = 3;

impl Numeric<'_> {
    /// Warnings for the bodies far from their declared start.
    pub(super) fn far_starts(&self, structure: &Structure, start: &[f64]) -> Vec<Warning> {
        let mut said = Said::default();
        let bodies = self.model.bodies.iter().enumerate();
        let doubts = bodies.filter_map(|(body, declared)| Some((&declared.name, self.far_start(structure, start, body)?)));
        let new = doubts.filter(|(name, _)| said.is_new(name));
        let of_bodies = new.take(MOST).map(|(name, doubt)| Warning { doubt, range: name.into() });
        of_bodies.chain(self.far_starts_of_joints(start).into_iter().take(MOST)).collect()
    }

    /// Warnings for angles and displacements of joints.
    fn far_starts_of_joints(&self, start: &[f64]) -> Vec<Warning> {
        let declared: Vec<Expr> = self.model.starts.iter().map(|start| start.value).collect();
        let at_start = Values { coordinates: start, ..self.known };
        let found = evaluate(&self.system.arena, &self.system.space.off_starts, &at_start);
        let each = self.model.starts.iter().zip(evaluate(&self.system.arena, &declared, &self.known)).zip(found);
        let doubtful = each.filter_map(|((one, declared), off)| {
            let is_angle = matches!(one.quantity, JointQuantity::Angle(..));
            let off = if is_angle { within_a_turn(off) } else { off };
            let shown = |value: f64| if is_angle { degrees(value) } else { millimetres(value) };
            let instead = if is_angle {
                let meant = if is_without_unit(declared) { declared } else { (declared + off).to_degrees().round() };
                format!("{}deg", significant(meant))
            } else {
                shown(declared + off).replace(' ', "")
            };
            let is_far = off.abs() > if is_angle { FAR_ANGLE } else { FAR_PLACE * self.size };
            let doubt = Doubt::FarStart {
                what: one.written.clone(),
                coordinate: one.written.clone(),
                found: shown(declared + off),
                declared: shown(declared),
                apart: shown(off.abs()),
                drive: None,
                instead,
            };
            is_far.then_some(Warning { doubt, range: one.range })
        });
        doubtful.collect()
    }

    fn far_start(&self, structure: &Structure, start: &[f64], body: usize) -> Option<Doubt> {
        if self.model.ambient == Ambient::Space
            && let Some(doubt) = self.far_orientation(structure, start, body)
        {
            return Some(doubt);
        }
        let own: Vec<usize> = (0..start.len()).filter(|unknown| self.system.coordinates[*unknown].body == body).collect();
        let declared = |unknown: usize| self.declared[unknown].unwrap_or(start[unknown]);
        let doubt = |coordinate: &str, unknown: usize, found: String, declared: String, apart: String, instead: String| Doubt::FarStart {
            what: self.model.bodies[body].name.to_string(),
            coordinate: coordinate.to_owned(),
            found,
            declared,
            apart,
            drive: self.drive_of(structure, unknown),
            instead,
        };
        for unknown in own.iter().copied().filter(|unknown| self.is_angle(*unknown) && self.model.ambient == Ambient::Plane) {
            // A drive may start whole turns away.
            let apart = within_a_turn(start[unknown] - declared(unknown)).abs();
            if apart > FAR_ANGLE {
                let meant = if is_without_unit(declared(unknown)) { declared(unknown) } else { start[unknown].to_degrees().round() };
                let instead = format!("{}deg", significant(meant));
                return Some(doubt("angle", unknown, degrees(start[unknown]), degrees(declared(unknown)), degrees(apart), instead));
            }
        }
        if !self.model.bodies[body].coordinates.iter().any(|one| one.role.is_position() && one.start.is_some()) {
            return None;
        }
        let places: Vec<usize> = own.into_iter().filter(|unknown| self.is_position(*unknown)).collect();
        let apart = places.iter().map(|unknown| (start[*unknown] - declared(*unknown)).powi(2)).sum::<f64>().sqrt();
        let first = places.iter().copied().find(|unknown| self.declared[*unknown].is_some()).filter(|_| apart > FAR_PLACE * self.size)?;
        let shown = |of: &dyn Fn(usize) -> f64| {
            let each: Vec<String> = places.iter().map(|unknown| millimetres(of(*unknown))).collect();
            format!("({})", each.join(", "))
        };
        let instead = shown(&|unknown| start[unknown]).replace(" mm", "mm");
        Some(doubt("position", first, shown(&|unknown| start[unknown]), shown(&declared), millimetres(apart), instead))
    }

    /// A body in space that is turned away from its declared orientation: its joint has another angle, or the declared orientations do
    /// not keep the axes of the joint together.
    fn far_orientation(&self, structure: &Structure, start: &[f64], body: usize) -> Option<Doubt> {
        let is_far = |unknown: &usize| {
            let declared = self.declared[*unknown].unwrap_or(0.0);
            self.is_angle(*unknown) && within_a_turn(start[*unknown] - declared).abs() > FAR_ANGLE
        };
        let mut own = (0..start.len()).filter(|unknown| self.system.coordinates[*unknown].body == body);
        let angle = own.find(is_far);
        let apart = self.turned_away(start, body).filter(|apart| *apart > FAR_ANGLE)?;
        if angle.is_none() {
            self.turned_against(start, body).filter(|apart| *apart > FAR_ANGLE)?;
        }
        Some(Doubt::FarOrientation {
            body: self.model.bodies[body].name.to_string(),
            angle: angle.map(|unknown| (self.system.name(self.model, unknown), degrees(within_a_turn(start[unknown])))),
            apart: degrees(apart),
            drive: angle.and_then(|unknown| self.drive_of(structure, unknown)),
            instead: self.as_turn(start, body)?,
        })
    }

    /// The drive that alone determines a coordinate.
    fn drive_of(&self, structure: &Structure, unknown: usize) -> Option<String> {
        let computed = structure.blocks.iter().filter(|block| block.iterated.is_empty()).flat_map(|block| &block.explicit);
        let equation = computed.filter(|explicit| explicit.unknown == unknown).map(|explicit| explicit.equation).next()?;
        let (joint, row) = (&self.model.joints[self.system.equations[equation].joint], self.system.equations[equation].row);
        // What velocities leave open is held at the start.
        (joint.is_drive && row < joint.residuals.len()).then(|| joint.name.to_string())
    }
}

/// True if an angle in rad, such as 70, was probably meant in degrees: its unit is missing.
fn is_without_unit(angle: f64) -> bool {
    angle.abs() > TAU && angle.fract() == 0.0
}
