//! Kinds of values: those that are found, and those that a place takes.

/// Kind of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number, with or without a unit.
    Number,
    /// A vector in ground.
    Vector,
    /// A point of a body or of ground.
    Point,
    /// An axis of a body or of ground.
    Axis,
    /// A body.
    Body,
    /// Ground as a body.
    Ground,
    /// A rotation in space.
    Orientation,
    /// A function of one variable.
    Function,
    /// A joint.
    Joint,
    /// A joint of the named kind.
    JointOf(String),
    /// A part of a component.
    Part,
    /// An array without its indices.
    Array,
}

/// Kind of value that a place takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Any number.
    Number,
    /// A number of the named dimension.
    Quantity(String),
    /// An operand of sums and products.
    NumberOrVector,
    /// A value that has a rate.
    NumberVectorOrPoint,
    /// A vector.
    Vector,
    /// A vector, or a point or an axis that stands for one.
    VectorOrPoint,
    /// A point.
    Point,
    /// An axis, or a constant vector.
    Axis,
    /// A body.
    Body,
    /// A function, called with an argument.
    Function,
    /// A function that is passed as an argument, with the names of the dimensions that it takes and gives.
    FunctionOfOne([String; 2]),
    /// A rotation in space.
    Orientation,
    /// A joint of the named kind.
    JointOf(String),
}
