//! Names of unknowns and equations, for messages.

/// One entry of q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Coordinate {
    /// The body as declared.
    pub body: &'static str,
    /// `"x"`, `"y"` or `"angle"`. In space also `"z"`, `"e0"` to `"e3"` (quaternion), `"a11"` to `"a33"` (rotation matrix), and angles and
    /// displacements of joints.
    pub name: &'static str,
    /// The quantity that it measures.
    pub kind: CoordinateKind,
    /// The meaning of q, q̇ and q̈ at its index.
    pub entries: CoordinateEntries,
}

/// The meaning of q, q̇ and q̈ at the index of a coordinate. For entries of a rotation matrix, `a11` to `a33`, it is said of q alone: beside the first three
/// stand ω and ω̇. In the state of a slice the components of the output follow the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum CoordinateEntries {
    /// A value, its rate and its acceleration.
    Motion,
    /// q̇ is a velocity, which is the rate of no value, and q̈ its rate: an output of velocities.
    Velocity,
    /// q̈ is a third derivative of an output; q and q̇ mean nothing.
    Jerk,
}

/// The quantity that a coordinate measures, which determines its scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum CoordinateKind {
    /// Metres.
    Length,
    /// Radians.
    Angle,
    /// A number: a component of a quaternion, or a direction cosine.
    Number,
}

/// One entry of Φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Row {
    /// The joint or drive as declared.
    pub joint: &'static str,
    /// Its kind, `"revolute"` for example, or `"equation"`.
    pub kind: &'static str,
    /// Which of the joint's rows this is, from 1.
    pub index: usize,
    /// How many rows the joint has.
    pub of: usize,
    /// Unit of the residual, `"m"`, `"rad"` or `"m²"` for example.
    pub unit: &'static str,
}

impl CoordinateKind {
    /// Unit of the coordinate.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Length => "m",
            Self::Angle => "rad",
            Self::Number => "1",
        }
    }
}

/// The coordinate with this index; `?` if a hand-written table is too short.
pub(crate) fn coordinate(coordinates: &[Coordinate], index: usize) -> Coordinate {
    coordinates.get(index).copied().unwrap_or(Coordinate::angle("?", "?"))
}

/// The meaning of the entries at an index. Beside the first three entries of a rotation matrix stand ω and ω̇, the rates of none of them.
pub(crate) fn entries(coordinates: &[Coordinate], index: usize) -> CoordinateEntries {
    let coordinate = coordinate(coordinates, index);
    let is_of_matrix = coordinate.kind == CoordinateKind::Number && coordinate.name.starts_with('a');
    if is_of_matrix { CoordinateEntries::Velocity } else { coordinate.entries }
}

/// The row with this index; `?` if a hand-written table is too short.
pub(crate) fn row(rows: &[Row], index: usize) -> Row {
    rows.get(index).copied().unwrap_or(Row { joint: "?", kind: "equation", index: 1, of: 1, unit: "" })
}
