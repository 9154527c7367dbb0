//! Roles of coordinates: the only table of their names, dimensions, scales, periods and corrections.

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

/// Motion of the bodies in the plane or in space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ambient {
    /// In the plane: x, y and one angle.
    #[default]
    Plane,
    /// In space: x, y, z and an orientation.
    Space,
}

impl Ambient {
    /// The coordinates of a body, in their order in q.
    #[must_use]
    pub fn coordinates(self) -> &'static [Role] {
        match self {
            Ambient::Plane => &Role::PLANE,
            Ambient::Space => &Role::SPACE,
        }
    }

    /// The coordinates of a body's origin.
    pub fn positions(self) -> impl Iterator<Item = Role> {
        self.coordinates().iter().copied().filter(|role| role.is_position())
    }

    /// The coordinates of a body that have a name in the language.
    pub fn named(self) -> impl Iterator<Item = Role> {
        self.coordinates().iter().copied().filter(|role| !matches!(role, Role::Quaternion(_)))
    }

    /// Index of a component of a vector, by name.
    pub(crate) fn component(self, name: &str) -> Option<usize> {
        self.positions().position(|role| role.name() == name)
    }

    /// The words after `start` in a body.
    pub(crate) fn start_words(self) -> impl Iterator<Item = &'static str> {
        let orientation = (self == Ambient::Space).then_some("orientation");
        self.named().map(Role::name).chain(["position"]).chain(orientation)
    }

    /// Number of components of a vector.
    #[must_use]
    pub fn components(self) -> usize {
        match self {
            Ambient::Plane => 2,
            Ambient::Space => 3,
        }
    }

    /// The speeds of a body, in their order in u.
    #[must_use]
    pub fn speeds(self) -> &'static [SpeedRole] {
        match self {
            Ambient::Plane => &SpeedRole::PLANE,
            Ambient::Space => &SpeedRole::SPACE,
        }
    }

    /// The solved coordinate with which a body begins. In space all positions come first.
    #[must_use]
    pub(crate) fn first_coordinate(self, body: usize) -> usize {
        match self {
            Ambient::Plane => Role::PLANE.len() * body,
            Ambient::Space => self.components() * body,
        }
    }

    /// The speed with which a body begins.
    #[must_use]
    pub(crate) fn first_speed(self, body: usize) -> usize {
        self.speeds().len() * body
    }

    /// The body that has a speed.
    #[must_use]
    pub(crate) fn body_of(self, speed: usize) -> usize {
        speed / self.speeds().len()
    }

    /// Coordinate of a body by its name in the language.
    pub(crate) fn coordinate(self, name: &str) -> Option<Role> {
        self.named().find(|role| role.name() == name)
    }
}

/// Role of a coordinate in the placement of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Position of the origin of the body along an axis of ground.
    Position(Axis),
    /// Rotation of the body in the plane, counterclockwise.
    Angle,
    /// Displacement along the axis of a joint.
    Displacement,
    /// One of the four components of the unit quaternion that rotates the body, the real one first.
    Quaternion(u8),
}

/// Rule by which a correction δ is applied to a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// q ← q + δ
    Sum,
    /// p ← exp(δ/2) p for the four components together, which keeps their norm 1.
    Rotation,
}

impl Role {
    /// The coordinates of a body in the plane, in their order in q.
    pub const PLANE: [Role; 3] = [Role::Position(Axis::X), Role::Position(Axis::Y), Role::Angle];

    /// The coordinates of a body in space, in their order in q.
    pub const SPACE: [Role; 7] = [
        Role::Position(Axis::X),
        Role::Position(Axis::Y),
        Role::Position(Axis::Z),
        Role::Quaternion(0),
        Role::Quaternion(1),
        Role::Quaternion(2),
        Role::Quaternion(3),
    ];

    /// Name in the language and in generated code.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Role::Position(Axis::X) => "x",
            Role::Position(Axis::Y) => "y",
            Role::Position(Axis::Z) => "z",
            Role::Angle => "angle",
            Role::Displacement => "displacement",
            Role::Quaternion(component) => ["e0", "e1", "e2", "e3"][usize::from(component % 4)],
        }
    }

    /// Symbol in formulas.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        if self == Role::Angle { "φ" } else { self.name() }
    }

    /// Dimension.
    #[must_use]
    pub fn dim(self) -> Dim {
        match self {
            Role::Position(_) | Role::Displacement => Dim::LENGTH,
            Role::Angle => Dim::ANGLE,
            Role::Quaternion(_) => Dim::NUMBER,
        }
    }

    /// Change comparable to one radian, in a mechanism of this characteristic length.
    #[must_use]
    pub fn scale(self, length: f64) -> f64 {
        match self {
            Role::Position(_) | Role::Displacement => length,
            Role::Angle => 1.0,
            // To first order a rotation by δ changes a component by at most δ/2.
            Role::Quaternion(_) => 0.5,
        }
    }

    /// Change that does not move the body; `None` if there is no such change.
    #[must_use]
    pub fn period(self) -> Option<f64> {
        match self {
            Role::Angle => Some(core::f64::consts::TAU),
            Role::Position(_) | Role::Displacement | Role::Quaternion(_) => None,
        }
    }

    /// Rule by which a correction is applied.
    #[must_use]
    pub fn correction(self) -> Correction {
        match self {
            Role::Position(_) | Role::Displacement | Role::Angle => Correction::Sum,
            Role::Quaternion(_) => Correction::Rotation,
        }
    }

    /// True for a coordinate of the origin of the body.
    #[must_use]
    pub fn is_position(self) -> bool {
        matches!(self, Role::Position(_))
    }
}

/// Role of a speed in the motion of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SpeedRole {
    /// The velocity of the body's origin along an axis of ground.
    Linear(Axis),
    /// The angular velocity of the body about an axis of ground.
    Angular(Axis),
}

impl SpeedRole {
    /// The angular speeds of a body in space.
    #[must_use]
    pub fn angular(body: usize) -> [usize; 3] {
        let first = Ambient::Space.first_speed(body) + Ambient::Space.components();
        [0, 1, 2].map(|axis| first + axis)
    }

    /// The speeds of a body in the plane, in their order in u.
    pub const PLANE: [SpeedRole; 3] = [SpeedRole::Linear(Axis::X), SpeedRole::Linear(Axis::Y), SpeedRole::Angular(Axis::Z)];

    /// The speeds of a body in space, in their order in u.
    pub const SPACE: [SpeedRole; 6] = [
        SpeedRole::Linear(Axis::X),
        SpeedRole::Linear(Axis::Y),
        SpeedRole::Linear(Axis::Z),
        SpeedRole::Angular(Axis::X),
        SpeedRole::Angular(Axis::Y),
        SpeedRole::Angular(Axis::Z),
    ];

    /// Dimension of the integral of the speed, a small displacement.
    #[must_use]
    pub fn displacement(self) -> Dim {
        match self {
            SpeedRole::Linear(_) => Dim::LENGTH,
            SpeedRole::Angular(_) => Dim::ANGLE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Ambient, Axis, Correction, Role};
    use std::collections::BTreeSet;

    const ALL: [Role; 9] = [
        Role::Position(Axis::X),
        Role::Position(Axis::Y),
        Role::Position(Axis::Z),
        Role::Angle,
        Role::Displacement,
        Role::Quaternion(0),
        Role::Quaternion(1),
        Role::Quaternion(2),
        Role::Quaternion(3),
    ];

    #[test]
    fn every_role_has_a_name_of_its_own() {
        let names: BTreeSet<&str> = ALL.into_iter().map(Role::name).collect();
        assert_eq!(names.len(), ALL.len());
        assert!(Ambient::Plane.named().all(|role| Ambient::Plane.coordinate(role.name()) == Some(role)));
    }

    #[test]
    fn a_radian_moves_a_point_at_the_characteristic_length_as_far_as_its_scale() {
        let length = 0.35;
        assert!(ALL.into_iter().filter(|role| role.is_position()).all(|role| role.scale(length) == length));
        assert_eq!(Role::Angle.scale(length), 1.0);
        // The unit quaternion of a small angle α about x is (cos α/2, sin α/2, 0, 0).
        let angle = 1e-6_f64;
        let slope = (angle / 2.0).sin() / angle;
        assert!((Role::Quaternion(1).scale(length) - slope).abs() < 1e-12);
    }

    #[test]
    fn quaternions_alone_are_turned_instead_of_added_to() {
        let turned: Vec<Role> = ALL.into_iter().filter(|role| role.correction() == Correction::Rotation).collect();
        assert_eq!(turned, &ALL[5..]);
        assert!(ALL.into_iter().all(|role| (role.period() == Some(std::f64::consts::TAU)) == (role == Role::Angle)));
    }
}
