//! Linear relations of angles, with two, three and four bodies.

use crate::common::declared::{Instant, Rows};
use crate::common::reference::{Value, list};
use crate::declared;

use super::rows_of;

declared! {
    /// Two angles.
    #[equations_only]
    TwoAngles (coeff_0: Number = 1, coeff_1: Number = 1, value: Angle = 1) {
        body a {}
        body b {}
        joint it = { coeff_0 * a.angle + coeff_1 * b.angle == value; };
    }
}
declared! {
    /// Three angles.
    #[equations_only]
    ThreeAngles (coeff_0: Number = 1, coeff_1: Number = 1, coeff_2: Number = 1, value: Angle = 1) {
        body a {}
        body b {}
        body c {}
        joint it = { coeff_0 * a.angle + coeff_1 * b.angle + coeff_2 * c.angle == value; };
    }
}
declared! {
    /// Four angles.
    #[equations_only]
    FourAngles (coeff_0: Number = 1, coeff_1: Number = 1, coeff_2: Number = 1, coeff_3: Number = 1, value: Angle = 1) {
        body a {}
        body b {}
        body c {}
        body d {}
        joint it = { coeff_0 * a.angle + coeff_1 * b.angle + coeff_2 * c.angle + coeff_3 * d.angle == value; };
    }
}
declared! {
    /// A planetary train with its carrier in ground.
    #[equations_only]
    PlanetaryOnGround (coeff_0: Number = 1, coeff_1: Number = 1, value: Angle = 1) {
        body a {}
        body b {}
        joint it = planetary(a, b, ground, coeff_0, coeff_1, value);
    }
}
declared! {
    /// A crossed belt on ground.
    #[equations_only]
    BeltOnGround (coeff_0: Number = 1, coeff_1: Number = 1, value: Angle = 1) {
        body a {}
        body b {}
        joint it = belt(a, b, coeff_0, -coeff_1, value);
    }
}

/// The rows of an angle relation between as many bodies as the case has.
///
/// # Panics
/// If the number of bodies is not two to four.
#[must_use]
pub fn angle_relation(constraint: &Value, at: &Instant) -> Rows {
    match list(&constraint["coeffs"]).len() {
        2 => rows_of::<TwoAngles>(constraint, at),
        3 => rows_of::<ThreeAngles>(constraint, at),
        4 => rows_of::<FourAngles>(constraint, at),
        other => panic!("a relation of {other} angles"),
    }
}
