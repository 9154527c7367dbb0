//! Every sentence the compiler says. Rooms report facts with their numbers; this page alone has words.
//!
//! A message starts lower-case and ends without a full stop; code stands in backticks; what to
//! type comes after `help:`, a further fact after `note:`.

mod assembly;

use super::{Count, Demand, Fact, remedy};
use crate::model::Dim;
use std::fmt;

/// `, did you mean …` as a help line, or nothing.
fn did_you_mean(near: &Option<String>) -> String {
    near.as_ref().map_or(String::new(), |near| format!("\nhelp: did you mean `{near}`?"))
}

/// `a`, `b` and `c`
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let mut names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match names.pop() {
        Some(last) if !names.is_empty() => format!("{} and {last}", names.join(", ")),
        Some(only) => only,
        None => String::new(),
    }
}

/// `a`, `b` and `c`; of many the first few.
fn list(names: &[String]) -> String {
    const MOST: usize = 6;
    let first = names.iter().take(MOST).map(String::as_str);
    match names.len() {
        0 => "nothing".to_owned(),
        many if many > MOST => format!("{} and {} more", first.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "), many - MOST),
        _ => listed(first),
    }
}

/// Three significant digits.
fn rounded(value: f64) -> String {
    let digits = (2.0 - value.abs().log10().floor()).clamp(0.0, 12.0);
    let text = format!("{value:.*}", digits as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn plural(count: usize, noun: &str) -> String {
    match (count, noun.strip_suffix('y')) {
        (1, _) => format!("1 {noun}"),
        (_, Some(stem)) => format!("{count} {stem}ies"),
        (_, None) => format!("{count} {noun}s"),
    }
}

/// Small numbers as words.
fn counted(number: usize) -> String {
    match number {
        0 => "no".to_owned(),
        1 => "one".to_owned(),
        2 => "two".to_owned(),
        3 => "three".to_owned(),
        many => many.to_string(),
    }
}

/// `no drive`, `1 drive`, `2 drives`
fn drives_there_are(drives: usize) -> String {
    if drives == 0 { "no drive".to_owned() } else { format!("only {}", plural(drives, "drive")) }
}

/// `a` is, `a` and `b` are
fn are(names: &[String]) -> String {
    format!("{} {}", list(names), if names.len() == 1 { "is" } else { "are" })
}

/// The bodies of some coordinates.
fn bodies(coordinates: &[String]) -> Vec<String> {
    let mut bodies: Vec<String> = coordinates.iter().filter_map(|name| name.rsplit_once('.')).map(|(body, _)| body.to_owned()).collect();
    bodies.dedup();
    bodies
}

/// `that`, or `one of them`
fn one_of(names: &[String]) -> &'static str {
    if names.len() == 1 { "that" } else { "one of them" }
}

/// `2 arguments`, `2 or 3 arguments`, `2 to 4 arguments`
fn range_of([least, most]: &[usize; 2], noun: &str) -> String {
    match most - least {
        0 => plural(*most, noun),
        1 => format!("{least} or {}", plural(*most, noun)),
        _ => format!("{least} to {}", plural(*most, noun)),
    }
}

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
            Fact::Expected { what, found } => write!(f, "expected {what}, found {found}"),
            Fact::NotANumber { found } => write!(f, "expected a number, found {found}{}", remedy::of_kind("a number", "text")),
            Fact::TooDeep { limit } => {
                write!(f, "this is nested more than {limit} deep\nhelp: name parts of it with `let`")
            }
            Fact::Keyword { word } => write!(f, "`{word}` is a word of Rust and cannot be a name\nhelp: write `{word}_`"),
            Fact::NumberType => write!(f, "`T` is the number type of generated code\nhelp: choose another name for the mechanism"),
            Fact::UnknownAttribute { name } => {
                write!(
                    f,
                    "`#[{name}]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]` and `#[closure(…)]` before `mechanism`"
                )
            }
            Fact::AttributeTwice { name } => write!(f, "`#[{name}]` stands here twice\nhelp: take one of them away"),
            Fact::ClosingWord { near } => {
                write!(f, "`#[closure(…)]` takes one of `deny`, `allow` and `off`{}", did_you_mean(near))
            }
            Fact::TokensAfter { what, help } => write!(f, "nothing may follow {what}\nhelp: {help}"),
            Fact::UnknownItem { word } => {
                let known = ["param", "let", "ground", "body", "joint", "drive", "output", "part", "for", "component", "function", "use"];
                // Words as short as `for` are near to many others: they come last.
                let (rare, often): (Vec<&str>, Vec<&str>) = known.iter().partition(|known| matches!(**known, "part" | "for"));
                let near = crate::model::suggest::nearest;
                let near = near(word, often.into_iter()).or_else(|| near(word, rare.into_iter()));
                write!(f, "`{word}` is no item of a mechanism{}", did_you_mean(&near))?;
                write!(f, "\nnote: items are {}", listed(known.into_iter()))
            }
            Fact::UnknownBodyItem { word } => {
                let near = crate::model::suggest::nearest(word, ["point", "axis", "start"].into_iter());
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
            Fact::MethodCall { name } => write!(f, "there are no methods here\nhelp: write `{name}(value)` for `value.{name}()`"),
            Fact::SpaceBeforeUnit { number, unit } => {
                if crate::model::unit::lookup(unit).is_some() {
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

            Fact::WithoutIndex { name, variable } => {
                write!(f, "every round of the loop would declare another `{name}`\nhelp: write `{name}[{variable}]`")
            }
            Fact::DuplicateInLoop { name, variable } => {
                write!(f, "`{name}` is declared twice\nhelp: every loop around it needs an index of its own, such as `[{variable}]`")
            }
            Fact::ArrayWithoutIndex { name } => write!(f, "`{name}` is an array\nhelp: say which one, such as `{name}[0]`"),
            Fact::NoArray { found, is_member: false } => write!(f, "{found} has no index\nhelp: take `[…]` away"),
            Fact::NoArray { found, is_member: true } => write!(f, "{found} has no further index\nhelp: take the last `[…]` away"),
            Fact::IndexOutOfRange { name, index, known } => {
                write!(f, "there is no `{name}[{index}]`")?;
                match known.as_slice() {
                    [] => Ok(()),
                    [only] => write!(f, "\nnote: there is `{name}[{only}]` only"),
                    [first, .., last] if last - first + 1 == known.len() => {
                        write!(f, "\nnote: there are `{name}[{first}]` to `{name}[{last}]`")
                    }
                    many => {
                        write!(f, "\nnote: there are {}", list(&many.iter().map(|index| format!("{name}[{index}]")).collect::<Vec<_>>()))
                    }
                }
            }
            Fact::NegativeIndex { index } => write!(f, "an index counts from 0, this one is {index}"),
            Fact::MissingIndex { what, missing, known } => {
                write!(f, "there is {what} `{known}` but no `{missing}`\nhelp: the indices of an array run from 0 without gaps")
            }
            Fact::NotWhole { found } => {
                write!(
                    f,
                    "expected a whole number, found {found}\nnote: indices and ranges are made of whole numbers, `let`s and loop variables with + - * / %"
                )
            }
            Fact::NotKnownWhole => {
                write!(f, "how many there are cannot change at run time\nhelp: declare the number with `let`, such as `let count = 6;`")
            }
            Fact::EmptyRange { from, to, is_inclusive } => {
                let below = if *is_inclusive { "" } else { "below " };
                write!(f, "this loop runs over nothing: from {from} to {below}{to}")?;
                if from == to {
                    return write!(f, "\nhelp: for {from} alone write `{from}..={to}`");
                }
                write!(f, "\nhelp: a loop counts upwards: write `{to}..={from}`")
            }
            Fact::LongRange { rounds, limit } => write!(f, "this loop has {rounds} rounds, at most {limit} are possible"),
            Fact::TooManyItems { limit } => write!(f, "loops and parts make more than {limit} items"),
            Fact::UnknownComponent { name, is_constraint: true, .. } => {
                write!(f, "`{name}` is a constraint, not a component\nhelp: write `joint name = {name}(…);`")
            }
            Fact::UnknownComponent { name, near, .. } => {
                write!(f, "no component is called `{name}`{}", did_you_mean(near))?;
                if near.is_none() { write!(f, "\nhelp: declare it with `component {name}(…) {{ … }}`") } else { Ok(()) }
            }
            Fact::ComponentAsConstraint { name } => {
                write!(f, "`{name}` is a component, not a constraint\nhelp: write `part name = {name}(…);`")
            }
            Fact::ComponentRecursion { name } => {
                write!(f, "the component `{name}` contains itself, and so without end")?;
                write!(
                    f,
                    "\nhelp: let each part take the one before as an argument: `for i in 1..n {{ part name[i] = {name}(name[i - 1].end); }}`"
                )
            }
            Fact::ParameterAsArgument { component, name, part } => {
                write!(f, "`{name}` is a parameter in `{component}`, not an argument of it")?;
                write!(
                    f,
                    "\nhelp: it is set in Rust, `mechanism.{part}.{name} = …`; to set it here, declare `component {component}(…, {name}: …)`"
                )
            }
            Fact::OutsideOfComponent { name, what } => {
                write!(f, "a component does not see `{name}`, {what} outside of it")?;
                write!(f, "\nhelp: take what it needs as an argument, such as `P: Point` or `b: Body`")
            }
            Fact::UnlikeParts { name, component } => {
                write!(f, "`{name}` has not the same bodies, parameters, parts and outputs as the first `{component}`")?;
                write!(f, "\nhelp: how many there are of something in a component cannot depend on its arguments")
            }
            Fact::UnlikeOutputs { name } => {
                write!(f, "the outputs `{name}` measure different things\nhelp: give outputs of another kind another name")
            }
            Fact::GeneratedType { name } => {
                write!(f, "a component cannot be called `{name}`: a generated type would have that name\nhelp: choose another name")
            }
            Fact::InInstance { place, fact } => {
                let sentence = fact.to_string();
                let (first, rest) = parted(&sentence);
                write!(f, "{first}\nnote: {place}{rest}")
            }

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
                if near.is_none() && !known.is_empty() {
                    write!(f, "\nnote: it has {}", listed(known.iter().map(String::as_str)))?;
                }
                Ok(())
            }
            Fact::UnknownFunction { name, is_constraint: true, .. } => {
                write!(f, "`{name}` is a constraint, not a function\nhelp: write `joint name = {name}(…);`")
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
                write!(f, "no unit is called `{name}`{}", did_you_mean(&near.as_ref().map(|near| format!("{number}{near}"))))?;
                if near.is_none() {
                    write!(f, "\nnote: there are {}", listed(crate::model::unit::names()))?;
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
                if name == "angle" { Ok(()) } else { write!(f, "; `position` is both `x` and `y`") }
            }
            Fact::DuplicateGround => write!(f, "there is one ground only\nhelp: put all its points and axes into one `ground {{ … }}`"),
            Fact::Reserved { name } if name == "ground" => {
                write!(
                    f,
                    "`ground` is what stands still\nhelp: its points go into `ground {{ … }}`, without `body`; all else has another name"
                )
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

            Fact::NotA { wanted, found } => write!(f, "expected {wanted}, found {found}{}", remedy::of_kind(wanted, found)),
            Fact::WrongArgument { parameter, definition, wanted, found, instead } => {
                write!(f, "`{parameter}` of `{definition}` takes {wanted}, found {found}")?;
                match instead {
                    Some(instead) => write!(f, "\nhelp: write `{instead}`"),
                    None if wanted.ends_with(" joint") && !found.ends_with(" joint") => write!(f, "\nhelp: write the name of the joint"),
                    None => write!(f, "{}", remedy::of_kind(wanted, found)),
                }
            }
            Fact::WrongArgumentDimension { parameter, definition, wanted, found } => {
                write!(f, "`{parameter}` of `{definition}` is {wanted}, found {found}")?;
                if found.times(Dim::TIME) == *wanted {
                    return write!(f, "\nhelp: multiply the rate by `t`");
                }
                // What follows a law of time is often meant to follow time itself.
                if *found == Dim::TIME {
                    write!(f, "\nhelp: multiply the time by a rate in {}", wanted.per(Dim::TIME).unit())
                } else {
                    Ok(())
                }
            }
            Fact::WrongDefault { wanted, found } => write!(f, "the parameter takes {wanted}, its default is {found}"),
            Fact::WrongDimension { wanted, found } => write!(f, "expected {wanted}, found {found}"),
            Fact::Unlike { action, one, two } => {
                let joint = if *action == "equate" || *action == "compare" { "with" } else { "and" };
                match *action {
                    "subtract" => write!(f, "cannot subtract {two} from {one}"),
                    "add" => write!(f, "cannot add {two} to {one}"),
                    _ => write!(f, "cannot {action} {one} {joint} {two}"),
                }?;
                write!(f, "{}", remedy::of_dimensions(*one, *two))
            }
            Fact::NotALength { found, instead } => {
                write!(f, "a coordinate of a point is a length (m), found {found}")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, "\nhelp: write `{instead}`"))
            }
            Fact::FunctionTakes { wanted, found } => write!(f, "expected a function of {wanted}, found a function of {found}"),
            Fact::OrderOfBodies => write!(f, "bodies have no order\nhelp: compare them with `==` or `!=`"),
            Fact::CannotCompare { one, two } => write!(f, "cannot compare {one} with {two}"),
            Fact::CannotEquate { one, two } => write!(f, "cannot equate {one} with {two}{}", remedy::of_equation(one, two)),
            Fact::NotTwoComponents { found } => write!(f, "a vector in the plane has 2 components, found {found}"),
            Fact::VectorAndNumber => {
                write!(f, "cannot add or subtract a vector and a number")?;
                write!(f, "\nhelp: write the number as a vector, `(x, y)`, or take a component, `.x` or `.y`")
            }
            Fact::NumberByVector => write!(f, "nothing can be divided by a vector\nhelp: write `norm(v)` for its length"),
            Fact::VectorTimesVector => {
                write!(f, "there is more than one product of vectors\nhelp: write `dot(a, b)` or `cross(a, b)`")
            }
            Fact::PowerOfDimension { base } => {
                write!(f, "{base} can only be raised to a number that is written out, a multiple of 1/6")?;
                write!(f, "\nhelp: divide it by a quantity of its kind, and raise the ratio")
            }
            Fact::NotAnOutput { found } => write!(f, "an output is a number, a vector, a point or a body that moves, found {found}"),

            Fact::NumberTooLong { number } => {
                write!(f, "`{number}` cannot be kept exactly\nnote: numbers have up to 36 digits and lie between 1e-36 and 1e36")
            }
            Fact::NotFinite { place } => write!(f, "{place} is not a finite number"),
            Fact::TooLarge { limit } => {
                write!(
                    f,
                    "the equations grow beyond {limit} operations here\nhelp: a function that calls others several times is written out at every call"
                )
            }
            Fact::DivisionByZero => write!(f, "division by zero"),
            Fact::EqualityInChoice => write!(f, "equality of measured numbers is an accident\nhelp: compare with `<`, `<=`, `>` or `>=`"),
            Fact::ListOutsideTable => write!(f, "a list can only be an argument of `table`\nhelp: a vector is written `(x, y)`"),
            Fact::TableArity { found } => {
                write!(f, "`table` takes 2 or 3 arguments, found {found}\nnote: `table(x, [(x0, y0), (x1, y1), …], periodic)`")
            }
            Fact::TableNeedsList => write!(f, "expected a list of pairs, such as `[(0deg, 0mm), (90deg, 5mm)]`"),
            Fact::TableNeedsPairs => write!(f, "expected a pair, such as `(90deg, 5mm)`"),
            Fact::TableNotIncreasing { before, found, dim } => {
                let [found, before] = [found, before].map(|value| remedy::quantity(*value, *dim));
                write!(f, "the first numbers of a table must increase from pair to pair: {found} comes after {before}")
            }
            Fact::TableTooShort { found } => write!(f, "a table needs at least 2 pairs, found {found}"),
            Fact::TableNotPeriodic { first, last, dim } => {
                let [first, last] = [first, last].map(|value| remedy::quantity(*value, *dim));
                write!(f, "a periodic table ends with the value it begins with: it begins with {first} and ends with {last}")
            }
            Fact::TableEnds { found } => write!(f, "outside its range a table is `periodic`, `linear` or `hold`, not {found}"),
            Fact::NotConstant { place, help } => {
                write!(f, "{place} is a constant: numbers, units, `pi` and functions of them")?;
                if help.is_empty() { Ok(()) } else { write!(f, "\nhelp: {help}") }
            }
            Fact::EmptyBounds { bounds, is_point } => {
                write!(f, "no value lies in {bounds}\nhelp: ")?;
                if *is_point {
                    write!(f, "write `..=` where the greatest value is allowed")
                } else {
                    write!(f, "the lesser value stands first")
                }
            }
            Fact::DefaultOutOfBounds { value, bounds } => {
                write!(f, "the default, {value}, does not lie in {bounds}\nhelp: widen the range, or take a default within")
            }
            Fact::NotFixed { place } => {
                write!(f, "{place} may depend on parameters only, not on what moves")?;
                let help = if place.contains("start") { "write where it is about" } else { "what moves along a body is a body of its own" };
                write!(f, "\nhelp: {help}")
            }
            Fact::FunctionNeedsArgument => {
                write!(
                    f,
                    "a function written here names its argument\nhelp: write `function name(x: Angle) -> Length = …;`, or give the path of a Rust function"
                )
            }
            Fact::ZeroAxis { name } => {
                write!(f, "the axis `{name}` has no direction: both components are zero\nhelp: write `(1, 0)` for the direction of x")
            }

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
            Fact::RequirementFails { why } => write!(f, "{why}"),
            Fact::RequirementFailsAtDefaults { why, value } => write!(f, "{why}\nnote: it is {value} at the declared defaults"),
            Fact::RowOfNothing { joint, row: _, of: 1 } => {
                write!(f, "the equation of `{joint}` does not depend on the position of any body")
            }
            Fact::RowOfNothing { joint, row, of } => {
                write!(f, "equation {row} of {of} of `{joint}` does not depend on the position of any body")
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

            Fact::NoBodies { name } => write!(f, "`{name}` has no bodies\nhelp: declare one with `body name {{ … }}`"),
            Fact::BodyIsFree { body } => {
                write!(f, "nothing holds `{body}`: it is in no equation")?;
                write!(f, "\nhelp: join it to another body, such as `joint name = revolute({body}.P, other.Q);`, or take it away")
            }
            Fact::Repeats { joint, other } => write!(f, "`{joint}` demands the same as `{other}`\nhelp: take one of them away"),
            Fact::FollowsFrom { joint, is_drive, rows, of, others, free, moves } => {
                let place = if *moves { "in every position" } else { "where the mechanism stands" };
                let sources = if others.is_empty() { "the rest of it".to_owned() } else { list(others) };
                match (rows == of, of) {
                    (true, 1) => write!(f, "`{joint}` adds nothing: its equation follows from {sources} {place}")?,
                    (true, 2) => write!(f, "`{joint}` adds nothing: both its equations follow from {sources} {place}")?,
                    (true, of) => write!(f, "`{joint}` adds nothing: its {of} equations follow from {sources} {place}")?,
                    (false, of) => {
                        let verb = if *rows == 1 { "adds" } else { "add" };
                        let it = if *rows == 1 { "it follows" } else { "they follow" };
                        write!(f, "{rows} of the {of} equations of `{joint}` {verb} nothing: {it} from {sources} {place}")?;
                    }
                }
                if !free.is_empty() {
                    let (remains, one) = if free.len() == 1 { ("remains", "it") } else { ("remain", "one of them") };
                    return write!(f, "\nnote: {} {remains} free\nhelp: let it hold or drive {one} instead", list(free));
                }
                match (is_drive, rows == of) {
                    _ if others.is_empty() => write!(f, "\nhelp: say it once"),
                    (true, _) => write!(f, "\nhelp: take it away"),
                    (false, true) => write!(f, "\nhelp: take it away, or write `redundant joint` for `joint` to keep it as a check"),
                    (false, false) => {
                        write!(f, "\nhelp: write `redundant joint` for `joint`: what is needed of it is solved, the rest is checked")
                    }
                }
            }
            Fact::NotRedundant { joint, free } => {
                write!(f, "`{joint}` is not redundant: none of its equations follows from others")?;
                if !free.is_empty() {
                    let are = if free.len() == 1 { "is" } else { "are" };
                    write!(f, "\nnote: without it {} {are} free", list(free))?;
                }
                write!(f, "\nhelp: write `joint` for `redundant joint`")
            }
            Fact::CannotHold { joint, bodies, length, angle, time, is_redundant } => {
                write!(f, "`{joint}` contradicts the other joints: ")?;
                if *time == 0.0 {
                    write!(f, "with all of them closed it is ")?;
                } else {
                    write!(f, "with all of them closed it is, at t = {} s, ", rounded(*time))?;
                }
                match (length, angle) {
                    (Some(length), Some(angle)) => {
                        write!(f, "{} mm and {}° off", rounded(length * 1e3), rounded(angle.to_degrees()))?;
                    }
                    (Some(length), None) => write!(f, "{} mm off", rounded(length * 1e3))?,
                    (None, Some(angle)) => write!(f, "{}° off", rounded(angle.to_degrees()))?,
                    (None, None) => write!(f, "off")?,
                }
                if bodies.len() > 1 {
                    write!(f, "\nnote: it joins {}", list(bodies))?;
                }
                let fit = if *is_redundant { "a redundant joint must fit as well" } else { "what is held twice must fit" };
                write!(f, "\nhelp: {fit}: change a measure, or take it away")
            }
            Fact::NotOnGround { bodies } => {
                write!(f, "{} are joined to each other but not to ground", list(bodies))?;
                let first = bodies.first().map_or("", String::as_str);
                write!(f, "\nhelp: join one of them to ground, such as `joint name = revolute(ground.position, {first}.position);`")
            }
            Fact::FreeCoordinates { body, coordinates, example } => {
                let nothing = if coordinates.len() == 1 { "it is in no equation" } else { "they are in no equation" };
                write!(f, "nothing determines {}: {nothing}", list(coordinates))?;
                match example {
                    Some(example) => write!(f, "\nhelp: join `{body}` to another body once more, or drive it, such as `{example}`"),
                    None => write!(f, "\nhelp: join `{body}` to another body, such as `joint name = revolute({body}.position, other.P);`"),
                }
            }
            Fact::DrivesMissing { name, count, loose, candidates, example } => {
                let Count { coordinates, joints, drives, missing } = count.as_ref();
                write!(f, "`{name}` has mobility {}, but {}", missing + drives, drives_there_are(*drives))?;
                write!(f, "\nnote: {} and {} of joints", plural(*coordinates, "coordinate"), plural(*joints, "equation"))?;
                if !loose.is_empty() {
                    let ends = if loose.len() == 1 { "is" } else { "are each" };
                    write!(f, "\nnote: {} {ends} joined to one neighbour only", list(loose))?;
                }
                let or_joints = if loose.is_empty() { "" } else { " or joints" };
                match (missing, candidates.len()) {
                    (1, 1) => write!(f, "\nhelp: drive {}", list(candidates))?,
                    (1, _) => write!(f, "\nhelp: add a drive on one of {}", list(candidates))?,
                    _ => write!(f, "\nhelp: add {missing} drives{or_joints}; drives on {} go together", list(candidates))?,
                }
                if example.is_empty() { Ok(()) } else { write!(f, ", such as `{example}`") }
            }
            Fact::NothingToDrive { drive, joints, coordinates, free } => {
                write!(f, "`{drive}` has nothing to drive: ")?;
                match coordinates.as_slice() {
                    [only] => write!(f, "{} determines `{only}` already", list(joints))?,
                    many => {
                        write!(f, "{} {} no freedom", list(joints), if joints.len() == 1 { "leaves" } else { "leave" })?;
                        write!(
                            f,
                            "\nnote: they are {} on {}: mobility 0",
                            plural(many.len(), "equation"),
                            plural(many.len(), "coordinate")
                        )?;
                    }
                }
                if free.is_empty() {
                    return write!(f, "\nhelp: take `{drive}` or a joint away");
                }
                write!(f, "\nhelp: {} left free: drive {} instead", are(free), one_of(free))
            }
            Fact::DrivesContend { drives, freedoms, joints, coordinates, free } => {
                let (many, few) = (counted(drives.len()), counted(*freedoms));
                let freedom = if *freedoms == 1 { "freedom" } else { "freedoms" };
                write!(f, "{many} drives on {few} {freedom}: {}", list(drives))?;
                match coordinates.as_slice() {
                    [only] => write!(f, "\nnote: both determine `{only}`")?,
                    _ if joints.is_empty() => write!(f, "\nnote: they determine {}", list(coordinates))?,
                    _ => write!(f, "\nnote: {} {} {few} {freedom}", list(joints), if joints.len() == 1 { "leaves" } else { "leave" })?,
                }
                if free.is_empty() && drives.len() > freedoms + 1 {
                    return write!(f, "\nhelp: take {} of the drives away", drives.len() - freedoms);
                }
                if free.is_empty() {
                    return write!(f, "\nhelp: take one of the drives away");
                }
                write!(f, "\nhelp: {} left free: drive {} instead", are(free), one_of(free))
            }
            Fact::Follows { joint, is_drive, rows, of, others } => {
                let mark = if *is_drive { "" } else { ", or write `redundant joint` for `joint` to keep it as a check" };
                if others.is_empty() {
                    return write!(f, "the equations of `{joint}` follow from each other\nhelp: take those away that say the same");
                }
                let verb = if others.len() == 1 { "says" } else { "say" };
                if rows.len() == *of {
                    return write!(f, "`{joint}` adds nothing: {} {verb} the same\nhelp: take `{joint}` away{mark}", list(others));
                }
                let which: Vec<String> = rows.iter().map(usize::to_string).collect();
                write!(
                    f,
                    "`{joint}` demands in part what {} {verb}: its equation {} of {of} adds nothing",
                    list(others),
                    which.join(" and ")
                )?;
                write!(f, "\nhelp: take one of them away, or demand less with it{mark}")
            }
            Fact::Contradicts { joint, others, demand, off } => {
                if others.is_empty() {
                    return write!(f, "the equations of `{joint}` contradict each other: they differ by {off}");
                }
                write!(f, "`{joint}` contradicts {}", list(others))?;
                match demand.as_deref() {
                    Some(Demand { form, wanted, found }) => {
                        write!(f, ": it demands `{form}` = {wanted}, ")?;
                        match others.as_slice() {
                            [only] => write!(f, "`{only}` demands {found}"),
                            _ => write!(f, "they make it {found}"),
                        }
                    }
                    None => write!(f, ": where {} {}, it is off by {off}", list(others), if others.len() == 1 { "holds" } else { "hold" }),
                }?;
                write!(f, "\nhelp: take one of them away")
            }
            Fact::Collides { joint, others, off } => {
                write!(
                    f,
                    "`{joint}` demands again what {} demand, with other numbers: both hold only where `{off}` is zero",
                    list(others)
                )?;
                write!(f, "\nhelp: take one of them away")
            }
            Fact::TooManyEquations { joint, others, equations, coordinates, free, for_free } => {
                let surplus = equations - coordinates.len();
                let many = if surplus == 1 { "one equation".to_owned() } else { plural(surplus, "equation") };
                write!(f, "`{joint}` is {many} too many")?;
                match others.is_empty() {
                    true => write!(f, ": it has {}", plural(*equations, "equation"))?,
                    false => write!(f, " with {}: together they are {}", list(others), plural(*equations, "equation"))?,
                }
                match coordinates.as_slice() {
                    few @ ([_] | [_, _] | [_, _, _]) => write!(f, " on {}, {}", plural(few.len(), "coordinate"), list(few))?,
                    many => write!(f, " on {} of {}", plural(many.len(), "coordinate"), list(&bodies(many)))?,
                }
                if !free.is_empty() {
                    let have = if free.len() == 1 { "has" } else { "have" };
                    let equations =
                        if *for_free == 0 { "no equation".to_owned() } else { format!("only {}", plural(*for_free, "equation")) };
                    return write!(f, "\nnote: {} {have} {equations}", list(free));
                }
                write!(f, "\nnote: that is a mobility of -{surplus}\nhelp: take one of these joints away")
            }

            Fact::StaysOpen { .. }
            | Fact::NeverCloses { .. }
            | Fact::HasNoValue { .. }
            | Fact::SingularStart { .. }
            | Fact::AmbiguousStart { .. } => assembly::write(f, self),
        }
    }
}
