//! Every sentence the compiler says. Rooms report facts with their numbers; this page alone has words.
//!
//! A message starts lower-case and ends without a full stop; code stands in backticks; what to
//! type comes after `help:`, a further fact after `note:`.

mod arrays;
mod assembly;
mod names;
mod values;
mod whole;
mod words;

pub(crate) use assembly::{degrees, millimetres, significant};

use super::{Doubt, Fact, remedy};
use std::fmt;
use words::{did_you_mean, equation, is_power, listed, plural, range_of, shortened};

impl Fact {
    /// The sentence as a compile error says it: with the code at the end of the first line.
    ///
    /// There it stays in sight where only first lines are shown, and can be searched for.
    #[must_use]
    pub fn message(&self) -> String {
        let sentence = self.to_string();
        let (first, rest) = parted(&sentence);
        format!("{first} [reuleaux::{}]{rest}", self.code())
    }
}

/// The first line, and what comes after it.
fn parted(sentence: &str) -> (&str, &str) {
    sentence.split_at(sentence.find('\n').unwrap_or(sentence.len()))
}

impl fmt::Display for Fact {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Fact::Syntax { message } => write!(f, "{message}"),
            Fact::Expected { what: "`;`", found } => write!(f, "expected `;`, found {found}\nhelp: end what stands before it with `;`"),
            Fact::Expected { what: what @ "`=`", found } if found == "`==`" => {
                write!(
                    f,
                    "expected {what}, found {found}\nhelp: a name gets its value with `=`; `==` stands between the sides of an equation"
                )
            }
            Fact::Expected { what, found } => {
                write!(f, "expected {what}, found {}", shortened(found))?;
                match (*what, found.as_str()) {
                    ("an expression", "`.`") => write!(f, "\nhelp: a number begins with a digit, such as `0.5`"),
                    ("the name of the joint", "`=`") => write!(f, "\nhelp: write `joint name = …`"),
                    ("the name of the drive", "`=`") => write!(f, "\nhelp: write `drive name = …`"),
                    _ => Ok(()),
                }
            }
            Fact::Unnamed { word, kind } => write!(f, "a {word} has a name of its own\nhelp: write `{word} name = {kind}(…);`"),
            Fact::NotANumber { found } => write!(f, "expected a number, found {found}{}", remedy::of_kind("a number", "text")),
            Fact::PartsTooDeep { limit } => {
                write!(f, "parts are nested more than {limit} deep\nhelp: declare the innermost parts in the mechanism, beside the others")
            }
            Fact::TooDeep { limit } => {
                write!(f, "this is nested more than {limit} deep\nhelp: name parts of it with `let`")
            }
            Fact::TooLong { limit } => {
                write!(f, "this has more than {limit} operations one after the other\nhelp: name parts of it with `let`")
            }
            Fact::LongChain { limit, in_function: true } => {
                write!(
                    f,
                    "functions call each other here more than {limit} steps deep\nhelp: write the value of one as a table or as one formula"
                )
            }
            Fact::LongChain { limit, .. } => write!(
                f,
                "this is used before it is declared, and so is what it is made of, more than {limit} steps deep\nhelp: declare first what others are made of"
            ),
            Fact::Keyword { word } if word == "mut" => {
                write!(f, "nothing here changes\nhelp: take `mut` away; what is to be set at run time is a `param`")
            }
            Fact::Keyword { word } => write!(f, "`{word}` is a word of Rust and cannot be a name\nhelp: write `{word}_`"),
            Fact::NumberType => write!(f, "`T` is the number type of generated code\nhelp: choose another name for the mechanism"),
            Fact::UnknownAttribute { name } => {
                write!(
                    f,
                    "`#[{name}]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[closure(…)]` and `#[allow(far_start)]` before `mechanism`"
                )
            }
            Fact::AttributeTwice { name } => write!(f, "`#[{name}]` stands here twice\nhelp: take one of them away"),
            Fact::ClosingWord { near } => {
                write!(f, "`#[closure(…)]` takes one of `deny`, `start`, `allow` and `off`{}", did_you_mean(near))
            }
            Fact::AllowedWord { near } => {
                write!(f, "`#[allow(…)]` takes the word `far_start` here{}", did_you_mean(near))?;
                write!(f, "\nnote: a lint of Rust is allowed for the module in which the mechanism stands")
            }
            Fact::TokensAfter { what, help } => write!(f, "nothing may follow {what}\nhelp: {help}"),
            Fact::UnknownItem { word } if word == "pub" => {
                write!(f, "all of a mechanism is as public as the mechanism\nhelp: take `pub` away")
            }
            Fact::UnknownItem { word } => {
                let known =
                    ["param", "let", "ground", "body", "joint", "drive", "output", "range", "part", "for", "component", "function", "use"];
                // Words as short as `for` are near to many others: they come last.
                let (rare, often): (Vec<&str>, Vec<&str>) = known.iter().partition(|known| matches!(**known, "part" | "for" | "range"));
                let near = crate::diag::nearest;
                let near = near(word, often.into_iter()).or_else(|| near(word, rare.into_iter()));
                write!(f, "`{word}` is no item of a mechanism{}", did_you_mean(&near))?;
                write!(f, "\nnote: items are {}", listed(known.into_iter()))
            }
            Fact::UnknownBodyItem { word } => {
                let near = crate::diag::nearest(word, ["point", "axis", "start"].into_iter());
                write!(f, "`{word}` is no item of a body{}\nnote: a body has `point`, `axis` and `start`", did_you_mean(&near))
            }
            Fact::OneArgument => {
                write!(f, "a function here has one argument\nhelp: what else it depends on is a `param` or a `let`, which it sees")
            }
            Fact::PairWithoutParentheses { what } => write!(f, "{what} has two coordinates in parentheses\nhelp: write `(x, y)`"),
            Fact::PathOfConstraint { path, last } => {
                write!(f, "a joint names its constraint by a single word\nhelp: write `use {path};` above, and `{last}(…)` here")
            }
            Fact::DoubleStar => write!(f, "`**` is no operator\nhelp: a power is written `a^b`"),
            Fact::MethodCall { name } if is_power(name) => write!(f, "there are no methods here\nhelp: a power is written `a^b`"),
            Fact::MethodCall { name } => write!(f, "there are no methods here\nhelp: write `{name}(value)` for `value.{name}()`"),
            Fact::SpaceBeforeUnit { number, unit } => {
                if crate::quantity::unit(unit).is_some() {
                    return write!(f, "a unit stands right behind its number\nhelp: write `{number}{unit}`");
                }
                write!(f, "an operator is missing between `{number}` and `{unit}`\nhelp: write `{number} * {unit}`")
            }
            Fact::ExponentTooLarge { limit } => write!(f, "the exponent of a dimension is at most {limit}"),

            Fact::OnlyAtTheTop { word } => {
                write!(f, "`{word}` stands in the mechanism itself, not in a component or a loop\nhelp: move it out")
            }
            Fact::StartInLoop => write!(f, "a body starts once: `start` cannot be repeated\nhelp: move it out of the loop"),
            Fact::IndexInEquations { name } => {
                write!(f, "`{name}` cannot have an index: there are no arrays among equations\nhelp: declare the array in the mechanism")
            }

            Fact::WithoutIndex { .. }
            | Fact::DuplicateInLoop { .. }
            | Fact::ArrayWithoutIndex { .. }
            | Fact::NoArray { .. }
            | Fact::IndexOutOfRange { .. }
            | Fact::NegativeIndex { .. }
            | Fact::MissingIndex { .. }
            | Fact::NotWhole { .. }
            | Fact::NotKnownWhole
            | Fact::EmptyRange { .. }
            | Fact::LongRange { .. }
            | Fact::TooManyItems { .. }
            | Fact::WholeTooLarge { .. }
            | Fact::UnknownComponent { .. }
            | Fact::ComponentAsConstraint { .. }
            | Fact::ComponentRecursion { .. }
            | Fact::ParameterAsArgument { .. }
            | Fact::OutsideOfComponent { .. }
            | Fact::UnlikeParts { .. }
            | Fact::UnlikeOutputs { .. }
            | Fact::GeneratedType { .. } => arrays::write(f, self),
            Fact::InInstance { place, fact } => {
                let sentence = fact.to_string();
                let (first, rest) = parted(&sentence);
                write!(f, "{first}\nnote: {place}{rest}")
            }

            Fact::UnitAlone { .. }
            | Fact::OutputRead { .. }
            | Fact::UnknownName { .. }
            | Fact::UnknownField { .. }
            | Fact::UnknownFunction { .. }
            | Fact::UnknownConstraint { .. }
            | Fact::UnknownUnit { .. }
            | Fact::UnknownDimension { .. }
            | Fact::UnknownStart { .. }
            | Fact::NotAConstraint { .. }
            | Fact::UnknownKind { .. }
            | Fact::Duplicate { .. }
            | Fact::DuplicateMark { .. }
            | Fact::DuplicateStart { .. }
            | Fact::DuplicateGround
            | Fact::DuplicateRange
            | Fact::Reserved { .. }
            | Fact::Generated { .. }
            | Fact::Cycle { .. }
            | Fact::Recursion { .. } => names::write(f, self),

            Fact::TooManyArguments { definition, signature, takes, found } => {
                write!(f, "`{definition}` takes {}, found {found}\nnote: `{signature}`", range_of(takes, "argument"))
            }
            Fact::MissingArguments { definition, signature, takes, found, missing } => {
                let missing_ones = listed(missing.iter().map(String::as_str));
                let verb = if missing.len() == 1 { "is" } else { "are" };
                write!(f, "`{definition}` takes {}, found {found}: {missing_ones} {verb} missing", range_of(takes, "argument"))?;
                write!(f, "\nnote: `{signature}`")
            }
            Fact::UnknownArgument { definition, name, signature, near } => {
                write!(f, "`{definition}` has no parameter `{name}`{}\nnote: `{signature}`", did_you_mean(near))
            }
            Fact::DuplicateArgument { name, is_also_in_order } => {
                let how = if *is_also_in_order { ": by its place in the order and by its name" } else { "" };
                write!(f, "the argument `{name}` is given twice{how}\nhelp: take one of them away")
            }
            Fact::PositionalAfterNamed { next } => {
                write!(f, "an argument without a name cannot follow one with a name")?;
                next.as_ref().map_or(Ok(()), |next| write!(f, "\nhelp: say which one it is, such as `{next}: …`"))
            }
            Fact::FunctionArity { name, wanted, found } => {
                write!(f, "`{name}` takes {}, found {found}", plural(*wanted, "argument"))?;
                match (wanted, name.as_str()) {
                    (2, "atan2") => write!(f, "\nnote: `atan2(y, x)`"),
                    (2, _) => write!(f, "\nnote: `{name}(a, b)`"),
                    _ => Ok(()),
                }
            }
            Fact::DefaultBefore { name } => {
                write!(f, "`{name}` needs a default, since the parameter before it has one\nhelp: put it before those with a default")
            }

            Fact::NotA { .. }
            | Fact::WrongArgument { .. }
            | Fact::WrongArgumentDimension { .. }
            | Fact::WrongDefault { .. }
            | Fact::WrongDimension { .. }
            | Fact::Unlike { .. }
            | Fact::NotALength { .. }
            | Fact::FunctionTakes { .. }
            | Fact::OrderOfBodies
            | Fact::CannotCompare { .. }
            | Fact::CannotEquate { .. }
            | Fact::NotTwoComponents { .. }
            | Fact::VectorAndNumber
            | Fact::NumberByVector
            | Fact::VectorTimesVector
            | Fact::PowerOfDimension { .. }
            | Fact::NotAnOutput { .. }
            | Fact::NumberTooLong { .. }
            | Fact::NumberOutOfRange { .. }
            | Fact::NotFinite { .. }
            | Fact::TooLarge { .. }
            | Fact::DivisionByZero
            | Fact::EqualityInChoice
            | Fact::ListOutsideTable
            | Fact::TableArity { .. }
            | Fact::TableNeedsList
            | Fact::TableNeedsPairs
            | Fact::TableNotIncreasing { .. }
            | Fact::TableTooShort { .. }
            | Fact::TableNotPeriodic { .. }
            | Fact::TableEnds { .. }
            | Fact::NotConstant { .. }
            | Fact::EmptyBounds { .. }
            | Fact::RangeWithoutEnd
            | Fact::DefaultOutOfBounds { .. }
            | Fact::NotFixed { .. }
            | Fact::FunctionNeedsArgument
            | Fact::ZeroAxis { .. } => values::write(f, self),

            Fact::TimeIn { place } => write!(f, "{place} does not change with time: `t` cannot be used in it"),
            Fact::TimeInDefinition => {
                write!(
                    f,
                    "`t` is not known in a definition\nhelp: take the law as a parameter, such as `C: Length`, and let a `drive` pass it"
                )
            }
            Fact::TimeInJoint { joint } => {
                write!(f, "a joint does not change with time, `t` is for drives\nhelp: write `drive {joint} = …;` for `joint {joint} = …;`")
            }
            Fact::RequirementFails { why, instead } => {
                write!(f, "{why}")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, "\nhelp: {instead}"))
            }
            Fact::RequirementFailsAtDefaults { why, value } => write!(f, "{why}\nnote: it is {value} at the declared defaults"),
            Fact::RowOfNothing { joint, row, of, at_defaults } => {
                let when = if *at_defaults { ", at the declared defaults" } else { "" };
                write!(f, "{} of `{joint}` does not depend on the position of any body{when}", equation(*row, *of))
            }
            Fact::OnGround { joint, kind } => {
                write!(f, "`{joint}` joins ground to ground, and ground does not move")?;
                write!(f, "\nhelp: give `{kind}` at least one body, or a point or an axis of one")
            }
            Fact::NoEquations { name } => write!(f, "`{name}` has no equations\nhelp: write `lhs == rhs;`"),
            Fact::EmptyBundle { name } => {
                write!(f, "the bundle `{name}` has no constraints\nhelp: put `constraint name(…) {{ … }}` into it")
            }
            Fact::GroundStart => {
                write!(f, "ground does not move: it has no start values\nhelp: a frame that stands elsewhere is a body with a `weld`")
            }
            Fact::InDefinition { definition, quantities, fact } => {
                write!(f, "in {definition}: {fact}")?;
                let words: Vec<String> = quantities.iter().map(|(name, dim)| format!("`{name}` is {dim}")).collect();
                if words.is_empty() { Ok(()) } else { write!(f, "\nnote: here {}", words.join(", ")) }
            }

            Fact::NoBodies { .. }
            | Fact::BodyIsFree { .. }
            | Fact::Repeats { .. }
            | Fact::FollowsFrom { .. }
            | Fact::NotRedundant { .. }
            | Fact::CannotHold { .. }
            | Fact::NotOnGround { .. }
            | Fact::FreeCoordinates { .. }
            | Fact::DrivesMissing { .. }
            | Fact::NothingToDrive { .. }
            | Fact::DrivesContend { .. }
            | Fact::Follows { .. }
            | Fact::Contradicts { .. }
            | Fact::Collides { .. }
            | Fact::TooManyEquations { .. } => whole::write(f, self),

            Fact::StaysOpen { .. }
            | Fact::NeverCloses { .. }
            | Fact::HasNoRate { .. }
            | Fact::HasNoValue { .. }
            | Fact::SingularStart { .. }
            | Fact::MotionEnds { .. }
            | Fact::Crosses { .. }
            | Fact::AmbiguousStart { .. } => assembly::write(f, self),
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Doubt::FarStart { body, coordinate, found, declared, apart, drive, instead } = self else {
            let Doubt::MotionEnds(fact) = self else { return Ok(()) };
            return write!(f, "{fact}");
        };
        match drive {
            Some(drive) => write!(f, "`{drive}` puts `{body}` at {found} at t = 0, {apart} from its declared start at {declared}")?,
            None => write!(f, "the nearest assembly has `{body}` at {found}, {apart} from its declared start at {declared}")?,
        }
        write!(f, "\nhelp: write `start {coordinate} = {instead};`, or `#[allow(far_start)]` before the mechanism")
    }
}
