//! What is said of names.

use super::words::{did_you_mean, first_of, is_power, list, listed, shortened};
use crate::diag::Fact;
use crate::quantity::{Dim, Role};
use std::fmt::{Formatter, Result};

pub(super) fn write(f: &mut Formatter, fact: &Fact) -> Result {
    match fact {
        Fact::UnitAlone { name } => {
            write!(
                f,
                "nothing is called `{name}` here\nhelp: a unit belongs to a number, as in `1{name}`; that of a rate is one word, as in `1rad_s`"
            )
        }
        Fact::OutputRead { name } => {
            write!(f, "`{name}` is an output: it is read from Rust, not in the declaration")?;
            write!(f, "\nhelp: name its value with `let {name} = …;` and give that out with `output {name} = {name};`")
        }
        Fact::UnknownName { name, near } => write!(f, "nothing is called `{name}` here{}", did_you_mean(near)),
        Fact::UnknownField { owner, name, near, known } => {
            write!(f, "{owner} has no `{name}`{}", did_you_mean(near))?;
            if near.is_none() && known.count > 0 {
                write!(f, "\nnote: it has {}", first_of(&known.first, known.count))?;
            }
            Ok(())
        }
        Fact::UnknownFunction { name, is_constraint: true, .. } => {
            write!(f, "`{name}` is a constraint, not a function\nhelp: write `joint name = {name}(…);`")
        }
        Fact::UnknownFunction { name, .. } if is_power(name) => {
            write!(f, "no function is called `{name}`\nhelp: a power is written `a^b`")
        }
        Fact::UnknownFunction { name, near: None, .. } => {
            write!(f, "no function is called `{name}`\nhelp: declare it, such as `function {name}(x: Angle) -> Length = …;`")
        }
        Fact::UnknownFunction { name, near, .. } => write!(f, "no function is called `{name}`{}", did_you_mean(near)),
        Fact::UnknownConstraint { name, near } => {
            write!(f, "no constraint is called `{name}`{}", did_you_mean(near))?;
            if near.is_none() {
                write!(f, "\nhelp: bring in your own with `use path::to::{name};`")?;
            }
            Ok(())
        }
        Fact::UnknownUnit { name, .. } if name == "Hz" => {
            write!(f, "no unit is called `Hz`\nhelp: for a speed of rotation write `rpm` or `rad_s`, for a frequency `1/0.5s`")
        }
        Fact::UnknownUnit { number, name, near } => {
            write!(f, "no unit is called `{}`{}", shortened(name), did_you_mean(&near.as_ref().map(|near| format!("{number}{near}"))))?;
            if near.is_none() {
                write!(f, "\nnote: there are {}", listed(crate::quantity::units()))?;
            }
            Ok(())
        }
        Fact::UnknownDimension { name, near } => {
            write!(f, "no dimension is called `{name}`{}", did_you_mean(near))?;
            if near.is_none() {
                write!(f, "\nnote: there are {}", listed(Dim::names()))?;
            }
            Ok(())
        }
        Fact::UnknownStart { name, near } => {
            write!(f, "a body does not start with `{name}`{}\nnote: it starts with `x`, `y`, `position` or `angle`", did_you_mean(near))
        }
        Fact::NotAConstraint { name } => {
            write!(f, "`{name}` is not a constraint\nhelp: `use` brings in what `reuleaux::constraint!` defines")
        }
        Fact::UnknownKind { name, near } => {
            write!(f, "no parameter can take `{name}`{}", did_you_mean(near))?;
            if near.is_none() {
                write!(
                    f,
                    "\nnote: it takes a `Point`, `Axis`, `Body`, `Quantity`, `Function(…) -> …`, `Joint(…)`, or a dimension such as `Length`"
                )?;
            }
            Ok(())
        }
        Fact::Duplicate { name, first } => write!(f, "the name `{name}` is taken: {first} has it\nhelp: choose another name"),
        Fact::DuplicateMark { name, body } => write!(f, "`{body}` has another `{name}` already\nhelp: choose another name"),
        Fact::DuplicateStart { name, body } => {
            write!(f, "the start of `{body}` gives `{name}` twice\nhelp: take one away")?;
            if name == Role::Angle.name() { Ok(()) } else { write!(f, "; `position` is both `x` and `y`") }
        }
        Fact::DuplicateRange => write!(f, "there is one range of time only\nhelp: take one of them away"),
        Fact::DuplicateGround => write!(f, "there is one ground only\nhelp: put all its points and axes into one `ground {{ … }}`"),
        Fact::Reserved { name } if name == "ground" => {
            write!(f, "`ground` is what stands still\nhelp: its points go into `ground {{ … }}`, without `body`; all else has another name")
        }
        Fact::Reserved { name } => write!(f, "`{name}` has a meaning of its own in expressions\nhelp: choose another name"),
        Fact::Generated { name } => {
            write!(f, "an output cannot be called `{name}`: a generated function has that name\nhelp: choose another name")
        }
        Fact::Cycle { name, through } if through.is_empty() => write!(f, "`{name}` depends on itself"),
        Fact::Cycle { name, through } => write!(f, "`{name}` depends on itself, by way of {}", list(through)),
        Fact::Recursion { name } => {
            write!(f, "the function `{name}` calls itself\nnote: functions are written out where they are called; this would not end")
        }
        // All others are said elsewhere.
        _ => Ok(()),
    }
}
