//! Results of the choice of unknowns in space, besides the unknowns and equations.

use crate::expr::Expr;
use std::collections::BTreeSet;

/// How the orientations of bodies follow from joints, and where these start; empty in the plane.
#[derive(Clone, Debug, Default)]
pub struct InSpace {
    /// For each body the joint that its orientation follows from, and the other body of that joint.
    pub reached: Vec<Option<(usize, Option<usize>)>>,
    /// The binary links: bodies whose orientation follows from the places of their ends.
    pub links: Vec<usize>,
    /// Angles and displacements of joints less their declared starts, in the order of these.
    pub off_starts: Vec<Expr>,
    /// Angles of joints that place no body.
    pub further_angles: Vec<FurtherAngle>,
    /// True if axes of a joint point against each other, as their declared starts do.
    pub has_opposed: bool,
    /// Bodies with a declared orientation that no start of an angle expresses, since the orientation of the body that they are reached from is not
    /// known.
    pub turned: BTreeSet<usize>,
}

/// An unknown that is the angle of a joint and places no body.
#[derive(Clone, Copy, Debug)]
pub struct FurtherAngle {
    /// Its row, which holds at the angle and half a turn away from it.
    pub phi: Expr,
    /// The cosine of the unknown less the angle: 1 at the angle, −1 half a turn away.
    pub cosine: Expr,
}
