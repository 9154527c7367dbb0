//! All declarations of the tests, in sequence.

use super::declared::Declared;
use super::interpreter::Jet;
use crate::{laws, library, mechanisms, stress, units};

/// Visits each declaration.
pub trait Visitor {
    /// Visits a declaration with its name.
    fn visit<D: Declared>(&mut self, name: &'static str);
}

/// Rust functions that declarations name by path.
pub const FUNCTIONS: [(&str, Jet); 2] =
    [("crate::library::oval", library::oval::<f64>), ("crate::library::measured", library::measured::<f64>)];

macro_rules! visit {
    ($visitor:ident: $($declaration:path),* $(,)?) => { $($visitor.visit::<$declaration>(stringify!($declaration));)* };
}

macro_rules! visit_pairs {
    ($visitor:ident: $($module:ident),* $(,)?) => {
        $(visit!($visitor: units::$module::Between, units::$module::FromGround, units::$module::ToGround);)*
    };
}

/// Visits the declarations without definitions of their own, which the interpreter can read.
pub fn visit(visitor: &mut impl Visitor) {
    visit_pairs!(visitor: revolute, translational, distance, revolute_translational, point_on_line, weld, gear_pair, rack_pinion,
        drive_relative_angle, drive_distance);
    visit!(visitor: units::AbsoluteX, units::AbsoluteY, units::AbsoluteAngle, units::AbsoluteDistance, units::DriveX, units::DriveY,
        units::DriveAngle, units::TwoAngles, units::ThreeAngles, units::FourAngles, units::PlanetaryOnGround, units::BeltOnGround,
        library::Angles, library::OnCarrier, library::Toothed, library::Willis, library::RackOnCarrier, library::Pushed, library::KnifeCams,
        library::RollerCams, library::FlatCams, library::Functions, laws::Laws, laws::Rises, laws::Tables, laws::Programs,
        mechanisms::FourBarCrankRocker, mechanisms::SliderCrank, mechanisms::QuickReturn, mechanisms::TheoJansenLeg,
        mechanisms::HydraulicLoader, mechanisms::TwoStageGearTrain, mechanisms::GearTrainOfPairs,
        stress::FourBar, stress::RockerDrivenFourBar, stress::Dyad, stress::SmallAndLarge, stress::Rail, stress::Arm,
        stress::InLineSliderCrank);
}

/// Visits the declarations that use definitions made by `constraint!`.
pub fn visit_defined(visitor: &mut impl Visitor) {
    visit_pairs!(visitor: haug_translational, haug_point_on_line, moving_gears);
}
