//! Nouns of kinds of values.

use crate::diag::{Kind, Wanted};
use std::fmt::{Display, Formatter, Result};

impl Display for Kind {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Kind::Number => "a number",
            Kind::Vector => "a vector",
            Kind::Point => "a point",
            Kind::Axis => "an axis",
            Kind::Body => "a body",
            Kind::Ground => "ground",
            Kind::Orientation => "an orientation",
            Kind::Function => "a function",
            Kind::Joint => "a joint",
            Kind::JointOf(kind) => return write!(f, "a `{kind}` joint"),
            Kind::Part => "a part",
            Kind::Array => "an array",
        })
    }
}

impl Display for Wanted {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Wanted::Number => "a number",
            Wanted::Quantity(dimension) => return write!(f, "a number ({dimension})"),
            Wanted::NumberOrVector => "a number or a vector",
            Wanted::NumberVectorOrPoint => "a number, a vector or a point",
            Wanted::Vector => "a vector",
            Wanted::VectorOrPoint => "a vector or a point",
            Wanted::Point => "a point",
            Wanted::Axis => "an axis",
            Wanted::Body => "a body",
            Wanted::Function => "a function",
            Wanted::FunctionOfOne(_) => "a function of one variable",
            Wanted::Orientation => "an orientation, such as `turn((0, 0, 1), 30deg)`",
            Wanted::JointOf(kind) => return write!(f, "a `{kind}` joint"),
        })
    }
}
