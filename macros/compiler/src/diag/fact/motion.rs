//! Facts about forces, drives and freedoms.

use super::super::Kind;
use crate::quantity::Ambient;

/// A word with which an item of equations or forces is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// `joint`
    Joint,
    /// `drive`
    Drive,
    /// `force`
    Force,
}

/// A quantity between the bodies of a joint in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointValue {
    /// `joint.angle`
    Angle,
    /// `joint.displacement`
    Displacement,
}

/// Forces, drives and freedoms.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum MotionFact {
    PlaceWithoutAt { place: String },
    StartWithEquals { value: String, start: String },
    FreedomWithoutName { value: String },
    DriveWithoutName { value: String },
    GravityWithoutDirection { value: String, ambient: Ambient },
    InertiaOfNumbers { found: usize, first: String },
    InertiaAlongInPlane { inertia: String },
    InertiaOfVector { inertia: Option<String> },
    TorqueWithoutAxis { torque: String, axis: Option<String> },
    TorqueWithAxis { body: String, torque: Option<String> },
    ForceWithoutDirection { force: String, ambient: Ambient, on: Option<String> },
    ForceAtNoPoint { found: Kind, instead: Option<String> },
    TorqueOnNoBody { found: Kind, instead: Option<String> },
    EquationWithoutBraces { word: Word, name: String, equation: String },
    ValueForForce { value: String, instead: String, laws: Vec<String> },
    ValueForConstraint { word: Word, value: String, instead: String },
    UnknownForce { name: String, near: Option<String>, laws: Vec<String>, ambient: Ambient },
    ForceForConstraint { force: String, word: Word, name: String, instead: Option<String> },
    ConstraintForForce { constraint: String, is_drive: bool, name: String },
    JointForDrive { constraint: String, name: String },
    RateForStart { rate: String },
    StartForRate { start: String },
    RateBeforeStart { value: String, from: String, at: String },
    JointWithoutValue { definition: String, wanted: JointValue, kind: String, instead: Option<String> },
    FreedomOfNothing { name: String, value: String, coordinate: String },
    FreedomOfOrientation { name: String, body: String },
    FreedomOfJoint { name: String, joint: String, offers: Vec<String>, start: String },
    FreedomIsHeld { freedom: String, of: usize, by: Vec<String>, free: Vec<String> },
    SliceBesideFreedom { output: String, freedom: Option<String> },
    RangeBesideFreedom { freedom: Option<String> },
    InputBesideFreedom { drive: String, input: String, freedom: Option<String> },
    SliceBesideInput { output: String, input: String },
    NoJerk { output: String, obstacle: JerkObstacle },
}

/// Why an output has no third derivative.
#[derive(Clone, Debug, PartialEq)]
pub enum JerkObstacle {
    /// It is a whole body.
    Body,
    /// It contains velocities.
    Velocity,
    /// The mechanism is integrated.
    Integrated {
        /// A freedom, if there is one.
        freedom: Option<String>,
    },
    /// Only equations are wanted.
    EquationsOnly,
    /// A joint, a drive or the output itself contains a function with two derivatives, or an input.
    TwoDerivatives {
        /// The joint or drive; `None` for the output itself.
        joint: Option<String>,
    },
}
