//! Where the assembly stands far from what was declared.
//!
//! In: the assembly. Out: a [`Warning`] for each body whose angle or place is far from its declared start. A start only says which
//! assembly is meant, so that it need not be near; but what is far is seldom meant.

use crate::diag::{Doubt, Warning, degrees, millimetres, significant};
use crate::model::Said;
use crate::numeric::Numeric;
use crate::numeric::turns::within_a_turn;
use crate::structure::Structure;
use core::f64::consts::{FRAC_PI_4, TAU};

/// An angle farther from its declared value than this is far, in rad.
const FAR_ANGLE: f64 = FRAC_PI_4;

/// So is a place, in sizes.
const FAR_PLACE: f64 = 1.0 / 3.0;

/// Of so many bodies it is said.
const MOST: usize = 3;

impl Numeric<'_> {
    /// The bodies that are far from where they should start.
    pub(super) fn far_starts(&self, structure: &Structure, start: &[f64]) -> Vec<Warning> {
        let mut said = Said::default();
        let bodies = self.model.bodies.iter().enumerate();
        let doubts = bodies.filter_map(|(body, declared)| Some((&declared.name, self.far_start(structure, start, body)?)));
        let new = doubts.filter(|(name, _)| said.is_new(name));
        new.take(MOST).map(|(name, doubt)| Warning { doubt, range: name.into() }).collect()
    }

    fn far_start(&self, structure: &Structure, start: &[f64], body: usize) -> Option<Doubt> {
        let own: Vec<usize> = (0..start.len()).filter(|unknown| self.system.coordinates[*unknown].body == body).collect();
        let declared = |unknown: usize| self.declared[unknown].unwrap_or(start[unknown]);
        let doubt = |coordinate, unknown: usize, found: String, declared: String, apart: String, instead: String| Doubt::FarStart {
            body: self.model.bodies[body].name.to_string(),
            coordinate,
            found,
            declared,
            apart,
            drive: self.drive_of(structure, unknown),
            instead,
        };
        for unknown in own.iter().copied().filter(|unknown| self.is_angle(*unknown)) {
            // A drive may begin whole turns away.
            let apart = within_a_turn(start[unknown] - declared(unknown)).abs();
            if apart > FAR_ANGLE {
                // 70 radians are 70 degrees without their unit.
                let is_without_unit = declared(unknown).abs() > TAU && declared(unknown).fract() == 0.0;
                let meant = if is_without_unit { declared(unknown) } else { start[unknown].to_degrees().round() };
                let instead = format!("{}deg", significant(meant));
                return Some(doubt("angle", unknown, degrees(start[unknown]), degrees(declared(unknown)), degrees(apart), instead));
            }
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

    /// The drive that alone says what a coordinate is.
    fn drive_of(&self, structure: &Structure, unknown: usize) -> Option<String> {
        let computed = structure.blocks.iter().filter(|block| block.iterated.is_empty()).flat_map(|block| &block.explicit);
        let equation = computed.filter(|explicit| explicit.unknown == unknown).map(|explicit| explicit.equation).next()?;
        let joint = &self.model.joints[self.system.equations[equation].joint];
        joint.is_drive.then(|| joint.name.to_string())
    }
}
