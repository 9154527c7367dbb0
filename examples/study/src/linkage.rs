//! The mechanism of the study.

use std::array;

use reuleaux::mechanism;

mechanism! {
    /// A small crank-rocker with drilled holes. Its crank turns if ground and crank together are no longer than coupler and rocker.
    #[picture]
    pub mechanism Linkage {
        param ground_length: Length = 40mm;
        param crank_length: Length = 15mm;
        param coupler_length: Length = 31.5mm;
        param rocker_length: Length = 25mm;
        param along: Length = 20mm;
        param across: Length = 12mm;

        ground { point O = (0mm, 0mm);  point C = (ground_length, 0mm); }
        body crank   { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm);  point P = (along, across); }
        body rocker  { point B = (rocker_length, 0mm);  start angle = 80deg; }

        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 60rpm * t);

        output tip = coupler.P;
    }
}

/// The six lengths in m, in the order of the declaration.
pub type Lengths = [f64; 6];

/// The number of positions of the crank in which the tip is observed.
pub const POSITIONS: usize = 72;

/// The times (s) of these positions, at equal steps of a turn, short enough for the lanes of a register to stay together. In the one in the
/// middle crank and ground are in line: a linkage that cannot be turned does not reach it.
#[must_use]
pub fn positions() -> [f64; POSITIONS] {
    array::from_fn(|position| position as f64 / POSITIONS as f64)
}

/// The linkage with these lengths.
#[must_use]
pub fn linkage([ground_length, crank_length, coupler_length, rocker_length, along, across]: Lengths) -> Linkage {
    Linkage { ground_length, crank_length, coupler_length, rocker_length, along, across }
}

/// The lengths of a linkage.
#[must_use]
pub fn lengths(of: &Linkage) -> Lengths {
    [of.ground_length, of.crank_length, of.coupler_length, of.rocker_length, of.along, of.across]
}
