//! Messages about loops, arrays and parts.

use super::words::{declared, did_you_mean, first_of};
use crate::diag::{ArrayFact, Kind};
use std::fmt::{Display, Formatter, Result};

impl Display for ArrayFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            ArrayFact::WithoutIndex { name, variable } => {
                write!(f, "every round of the loop would declare another `{name}`\nhelp: write `{name}[{variable}]`")
            }
            ArrayFact::DuplicateInLoop { name, variable } => {
                write!(f, "`{name}` is declared twice\nhelp: every loop around it needs an index of its own, such as `[{variable}]`")
            }
            ArrayFact::DeclaredBefore { name, next } => {
                write!(f, "`{name}` is declared twice: here, and outside of this loop or in another round of it")?;
                write!(f, "\nhelp: count on from there, as in `{next}`")
            }
            ArrayFact::ArrayWithoutIndex { name, index } => {
                write!(f, "`{name}` is an array\nhelp: say which one, such as `{name}[{index}]`")
            }
            ArrayFact::NoArray { found: found @ (Kind::Point | Kind::Vector), is_member: false } => {
                write!(f, "{found} has no index\nhelp: its components are `.x` and `.y`, in space `.z` too")
            }
            ArrayFact::NoArray { found, is_member: false } => write!(f, "{found} has no index\nhelp: take `[…]` away"),
            ArrayFact::NoArray { found, is_member: true } => write!(f, "{found} has no further index\nhelp: take the last `[…]` away"),
            ArrayFact::IndexOutOfRange { name, index, ends, known } => {
                write!(f, "there is no `{name}[{index}]`")?;
                match ends {
                    None => Ok(()),
                    Some((only, last)) if only == last => write!(f, "\nnote: there is `{name}[{only}]` only"),
                    Some((first, last)) if last - first == known.count - 1 => {
                        write!(f, "\nnote: there are `{name}[{first}]` to `{name}[{last}]`")
                    }
                    Some(_) => write!(f, "\nnote: there are {}", first_of(&known.first, known.count)),
                }
            }
            ArrayFact::NegativeIndex { index } => write!(f, "an index counts from 0, this one is {index}"),
            ArrayFact::MissingIndex { what, missing, known, is_alone } => {
                write!(f, "there is {what} `{known}` but no `{missing}`\nhelp: the indices of an array run from 0 without gaps")?;
                // As arrays are declared in C.
                let in_c = known.strip_suffix(']').and_then(|known| known.rsplit_once('[')).filter(|_| *is_alone);
                let Some((name, number)) = in_c.filter(|(name, number)| !name.ends_with(']') && *number != "1") else { return Ok(()) };
                let noun = what.split_once(' ').map_or(*what, |(_, noun)| noun).replace("parameter", "param");
                let name = name.rsplit('.').next().unwrap_or(name);
                write!(f, "; {number} of them are written `for i in 0..{number} {{ {noun} {name}[i] … }}`")
            }
            ArrayFact::NotWhole { found } => {
                write!(
                    f,
                    "expected a whole number, found {found}\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %"
                )
            }
            ArrayFact::RemainderOfQuantity => {
                write!(
                    f,
                    "`%` takes whole numbers, as in an index\nhelp: `wrap(angle)` is an angle without its whole turns, from -180° to 180°"
                )
            }
            ArrayFact::NotKnownWhole => {
                write!(f, "how many there are cannot change at run time\nhelp: declare the number with `let`, such as `let count = 6;`")
            }
            ArrayFact::EmptyRange { from, to, is_inclusive } => {
                let below = if *is_inclusive { "" } else { "below " };
                write!(f, "this loop runs over nothing: from {from} to {below}{to}")?;
                if from == to {
                    return write!(f, "\nhelp: for {from} alone write `{from}..={to}`");
                }
                write!(f, "\nhelp: a loop counts upwards: write `{to}..={from}`")
            }
            ArrayFact::LongRange { rounds, limit } => write!(f, "this loop has {rounds} rounds, at most {limit} are possible"),
            ArrayFact::TooManyItems { limit } => {
                write!(
                    f,
                    "loops and parts make more than {limit} items\nnote: every round of a loop counts, also of one with nothing in it"
                )
            }
            ArrayFact::WholeTooLarge { found } => write!(f, "`{found}` is too large: an index or the end of a range stays below 2^63"),
            ArrayFact::UnknownComponent { name, is_force: Some(is_force), .. } => {
                let [kind, item] = declared(*is_force);
                write!(f, "`{name}` is a {kind}, not a component\nhelp: write `{item} name = {name}(…);`")
            }
            ArrayFact::UnknownComponent { name, near, .. } => {
                write!(f, "no component is called `{name}`{}", did_you_mean(near))?;
                if near.is_none() { write!(f, "\nhelp: declare it with `component {name}(…) {{ … }}`") } else { Ok(()) }
            }
            ArrayFact::ComponentAsConstraint { name } => {
                write!(f, "`{name}` is a component, not a constraint\nhelp: write `part name = {name}(…);`")
            }
            ArrayFact::ComponentRecursion { name } => {
                write!(f, "the component `{name}` contains itself, and so without end")?;
                write!(
                    f,
                    "\nhelp: let each part take the one before as an argument: `for i in 1..n {{ part name[i] = {name}(name[i - 1].end); }}`"
                )
            }
            ArrayFact::ParameterAsArgument { component, name, part } => {
                write!(f, "`{name}` is a parameter in `{component}`, not an argument of it")?;
                write!(
                    f,
                    "\nhelp: it is set in Rust, `mechanism.{part}.{name} = …`; to set it here, declare `component {component}(…, {name}: …)`"
                )
            }
            ArrayFact::OutsideOfComponent { name, what } => {
                write!(f, "a component does not see `{name}`, {what} outside of it")?;
                write!(f, "\nhelp: take what it needs as an argument, such as `P: Point` or `b: Body`")
            }
            ArrayFact::UnlikeParts { name, component } => {
                write!(f, "`{name}` has not the same bodies, parameters, parts and outputs as the first `{component}`")?;
                write!(f, "\nhelp: how many there are of something in a component cannot depend on its arguments")
            }
            ArrayFact::UnlikeOutputs { name } => {
                write!(f, "the outputs `{name}` measure different things\nhelp: give outputs of another kind another name")
            }
            ArrayFact::FieldOfInputs { name } => {
                write!(f, "the inputs of a mechanism are its field `{name}`\nhelp: choose another name")
            }
            ArrayFact::GeneratedType { name } => {
                write!(f, "a component cannot be called `{name}`: a generated type would have that name\nhelp: choose another name")
            }
        }
    }
}
