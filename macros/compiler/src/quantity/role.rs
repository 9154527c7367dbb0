//! What coordinates are: the only table of their names, dimensions, scales, periods and corrections.

use super::Dim;

/// An axis of ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// To the right.
    X,
    /// Up in the plane.
    Y,
    /// Out of the plane.
    Z,
}

/// The part that a coordinate plays in the placement of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Where the origin of the body lies along an axis of ground.
    Position(Axis),
    /// How far the body is turned in the plane, counterclockwise.
    Angle,
    /// One of the four components of the unit quaternion that turns the body, the real one first.
    Quaternion(u8),
}

/// How a correction δ reaches a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// q ← q + δ
    Sum,
    /// p ← exp(δ/2) p for the four components together, which stay of length 1.
    Rotation,
}

impl Role {
    /// The coordinates of a body in the plane, in their order in q.
    pub const PLANE: [Role; 3] = [Role::Position(Axis::X), Role::Position(Axis::Y), Role::Angle];

    /// Its name in the language and in generated code.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Role::Position(Axis::X) => "x",
            Role::Position(Axis::Y) => "y",
            Role::Position(Axis::Z) => "z",
            Role::Angle => "angle",
            Role::Quaternion(component) => ["e0", "e1", "e2", "e3"][usize::from(component % 4)],
        }
    }

    /// Its symbol in formulas.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        if self == Role::Angle { "φ" } else { self.name() }
    }

    /// The coordinate of a body in the plane of this name.
    pub(crate) fn named(name: &str) -> Option<Role> {
        Role::PLANE.into_iter().find(|role| role.name() == name)
    }

    /// What it measures.
    #[must_use]
    pub fn dim(self) -> Dim {
        match self {
            Role::Position(_) => Dim::LENGTH,
            Role::Angle => Dim::ANGLE,
            Role::Quaternion(_) => Dim::NUMBER,
        }
    }

    /// What compares to a radian, in a mechanism of this characteristic length.
    #[must_use]
    pub fn scale(self, length: f64) -> f64 {
        match self {
            Role::Position(_) => length,
            Role::Angle => 1.0,
            // The real part of half the angle.
            Role::Quaternion(_) => 0.5,
        }
    }

    /// By how much it can change without moving the body.
    #[must_use]
    pub fn period(self) -> Option<f64> {
        match self {
            Role::Angle => Some(core::f64::consts::TAU),
            Role::Position(_) | Role::Quaternion(_) => None,
        }
    }

    /// How a correction is applied.
    #[must_use]
    pub fn correction(self) -> Correction {
        match self {
            Role::Position(_) | Role::Angle => Correction::Sum,
            Role::Quaternion(_) => Correction::Rotation,
        }
    }

    /// It places the body's origin.
    #[must_use]
    pub fn is_position(self) -> bool {
        matches!(self, Role::Position(_))
    }
}

/// The part that a speed plays in the motion of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SpeedRole {
    /// The velocity of the body's origin along an axis of ground.
    Linear(Axis),
    /// The angular velocity of the body about an axis of ground.
    Angular(Axis),
}

impl SpeedRole {
    /// The speeds of a body in the plane, in their order in u.
    pub const PLANE: [SpeedRole; 3] = [SpeedRole::Linear(Axis::X), SpeedRole::Linear(Axis::Y), SpeedRole::Angular(Axis::Z)];

    /// What its integral measures: a small displacement along it.
    #[must_use]
    pub fn displacement(self) -> Dim {
        match self {
            SpeedRole::Linear(_) => Dim::LENGTH,
            SpeedRole::Angular(_) => Dim::ANGLE,
        }
    }
}
