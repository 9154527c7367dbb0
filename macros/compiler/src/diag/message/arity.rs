//! Messages about arguments.

use super::words::{did_you_mean, listed, plural, range_of};
use crate::diag::{ArityFact, Kind, MeantFor, remedy};
use std::fmt::{Display, Formatter, Result};

impl Display for ArityFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            ArityFact::TooManyArguments { definition, signature, takes, found, decimals } => {
                write!(f, "`{definition}` takes {}, found {found}", range_of(takes, "argument"))?;
                match decimals {
                    Some(number) => write!(f, "\nhelp: write a decimal point, `{number}`")?,
                    None if definition == "spring" && *found == 5 => {
                        write!(f, "\nhelp: a spring with a damper is `spring_damper(P, Q, stiffness, rest, damping)`")?;
                    }
                    None => {}
                }
                write!(f, "\nnote: `{signature}`")
            }
            ArityFact::MissingArguments { definition, signature, takes, found, missing, meant } => {
                let missing_ones = listed(missing.iter().map(String::as_str));
                let verb = if missing.len() == 1 { "is" } else { "are" };
                write!(f, "`{definition}` takes {}, found {found}: {missing_ones} {verb} missing", range_of(takes, "argument"))?;
                let ends = ["Axis", "Body", "Point"].into_iter().find(|kind| signature.contains(&format!(": {kind}")));
                match (meant, remedy::about_an_axis(definition, &Kind::Axis), ends) {
                    (MeantFor::Components(clause), ..) => {
                        write!(f, "\nhelp: a force with given components is written `force name = {{ {clause}; }}`")?;
                    }
                    (MeantFor::Complete(instead), ..) => write!(f, "\nhelp: write `{instead}`")?,
                    (MeantFor::Hinge, Some(turning), _) => write!(f, "\nhelp: `{turning}` acts about a hinge")?,
                    (MeantFor::Hinge | MeantFor::Joint, _, Some(kind)) if missing.len() == 1 => {
                        let ends = ["axes", "bodies", "points"][usize::from(kind != "Axis") + usize::from(kind == "Point")];
                        write!(f, "\nhelp: for a joint, write its two {ends} instead of its name")?;
                    }
                    _ if definition == "gear_pair" && *found == 3 && missing == &["b"] => {
                        write!(f, "\nhelp: write two numbers of teeth, or two radii, in the place of their ratio")?;
                    }
                    _ => {}
                }
                write!(f, "\nnote: `{signature}`")
            }
            ArityFact::MissingMarks { definition, signature, missing, instead, without, are_points } => {
                let (verb, noun) = match (missing.len(), are_points) {
                    (1, true) => ("is", "the point beside axes"),
                    (1, false) => ("is", "the axis beside points"),
                    (_, true) => ("are", "points beside axes"),
                    (_, false) => ("are", "axes beside points"),
                };
                let missing = listed(missing.iter().map(String::as_str));
                write!(f, "`{definition}` takes {noun}: {missing} {verb} missing\nhelp: write `{instead}`")?;
                if !without.is_empty() {
                    write!(f, ", with `axis z = (0, 0, 1);` in {}", listed(without.iter().map(String::as_str)))?;
                }
                write!(f, "\nnote: `{signature}`")
            }
            ArityFact::UnknownArgument { definition, name, signature, near } => {
                if name == "ratio" && near.is_none() && signature.contains(" a: Quantity, b: Quantity") {
                    write!(f, "`{definition}` has no parameter `{name}`\nhelp: write two numbers of teeth, or two radii: `a: 20, b: 40`")?;
                    return write!(f, "\nnote: `{signature}`");
                }
                write!(f, "`{definition}` has no parameter `{name}`{}\nnote: `{signature}`", did_you_mean(near))
            }
            ArityFact::DuplicateArgument { name, is_also_in_order } => {
                let how = if *is_also_in_order { ": by its place in the order and by its name" } else { "" };
                write!(f, "the argument `{name}` is given twice{how}\nhelp: take one of them away")
            }
            ArityFact::PositionalAfterNamed { next } => {
                write!(f, "an argument without a name cannot follow one with a name")?;
                next.as_ref().map_or(Ok(()), |next| write!(f, "\nhelp: say which one it is, such as `{next}: …`"))
            }
            ArityFact::ShapeArity { name, call, wanted, found } => {
                write!(f, "`{name}` takes {}, found {found}\nhelp: write `{call}`", plural(*wanted, "length"))
            }
            ArityFact::FunctionArity { name, wanted, found } => {
                write!(f, "`{name}` takes {}, found {found}", plural(*wanted, "argument"))?;
                match (wanted, name.as_str()) {
                    (1, "atan") if *found == 2 => write!(f, "\nhelp: write `atan2(y, x)`"),
                    (2, "atan2") => write!(f, "\nnote: `atan2(y, x)`"),
                    (3, "rise" | "fall") => write!(f, "\nnote: `{name}(height, duration, law)`, with a law such as `cycloidal`"),
                    (1, "norm") if *found == 2 => {
                        write!(
                            f,
                            "\nhelp: a vector has parentheses of its own, as in `norm((…))`; the distance of two points is `norm(Q - P)`"
                        )
                    }
                    (1, "norm" | "unit" | "perp" | "direction") => {
                        write!(f, "\nhelp: a vector has parentheses of its own, as in `{name}((…))`")
                    }
                    (1, "dwell") => write!(f, "\nnote: `dwell(duration)`"),
                    (2, "min" | "max") if *found > 2 => write!(f, "\nhelp: write `{name}({name}(a, b), c)`"),
                    (2, _) => write!(f, "\nnote: `{name}(a, b)`"),
                    _ => Ok(()),
                }
            }
            ArityFact::LawArity { name, found } => {
                write!(f, "`{name}` takes 1 argument, found {found}")?;
                write!(f, "\nhelp: a law leads from 0 to 1 as its argument does: write `height * {name}(x / duration)`")
            }
            ArityFact::FunctionOrder { name, call } => write!(f, "`{name}` takes its axis first\nhelp: write `{call}`"),
            ArityFact::JointForEnds { definition, signature, ends, instead } => {
                write!(f, "`{definition}` takes {ends} in the place of a joint\nhelp: write `{instead}`\nnote: `{signature}`")
            }
            ArityFact::OtherOrder { name, instead, signature } => {
                write!(f, "`{name}` takes these arguments in another order\nhelp: write `{instead}`\nnote: `{signature}`")
            }
            ArityFact::DefaultBefore { name } => {
                write!(f, "`{name}` needs a default, since the parameter before it has one\nhelp: put it before those with a default")
            }
        }
    }
}
