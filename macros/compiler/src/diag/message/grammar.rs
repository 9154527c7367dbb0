//! Messages about tokens that are not a valid declaration.

use super::words::{did_you_mean, is_acceleration, is_rate, listed, shortened};
use crate::diag::GrammarFact;
use crate::words::{Home, foreign};
use std::fmt::{Display, Formatter, Result};

/// There is no `and`.
const ONE_BY_ONE: &str = "each equation ends with `;`, and a choice has one condition, `if a < b { x } else { y }`";

/// Items of a mechanism.
const ITEMS: [&str; 19] = [
    "param",
    "input",
    "let",
    "ground",
    "body",
    "joint",
    "drive",
    "freedom",
    "force",
    "energy",
    "gravity",
    "start",
    "output",
    "range",
    "part",
    "for",
    "component",
    "function",
    "use",
];

/// Items of a body.
const BODY_ITEMS: [&str; 6] = ["point", "axis", "start", "mass", "center", "inertia"];

/// Values of bodies and joints.
const PROPERTIES: [&str; 8] = ["x", "y", "z", "angle", "position", "orientation", "angular_velocity", "displacement"];

impl Display for GrammarFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            GrammarFact::Syntax { message } => write!(f, "{message}"),
            GrammarFact::Expected { what: "`;`", found } => {
                write!(f, "expected `;`, found {found}\nhelp: ")?;
                match found.as_str() {
                    "`from`" => {
                        write!(f, "`from` belongs to an `axis` of a body or of ground, or to a `freedom`; ")?;
                        write!(f, "a component is given such an axis as a parameter, `a: Axis`")
                    }
                    "`and`" | "`or`" => f.write_str(ONE_BY_ONE),
                    _ => write!(f, "end what stands before it with `;`"),
                }
            }
            GrammarFact::Expected { what: what @ "`,` or `)`", found } if found == "`from`" => {
                write!(f, "expected {what}, found {found}")?;
                write!(f, "\nhelp: declare the axis in a body or in ground, `axis a = (0, 0, 1) from (1, 0, 0);`, and give its name here")
            }
            GrammarFact::Expected { what: what @ "an operator or `;`", found } if found == "`&`" => {
                write!(f, "expected {what}, found {found}\nhelp: {ONE_BY_ONE}")
            }
            GrammarFact::ComparisonAsValue => {
                write!(f, "a comparison is no value\nhelp: it comes after `if`, as in `if a < b {{ x }} else {{ y }}`")
            }
            GrammarFact::Expected { what: what @ "an expression", found } if found == "`box`" => {
                write!(f, "expected {what}, found {found}, a word of Rust\nhelp: the shape is `block(a, b, c)`, in the plane `block(a, b)`")
            }
            GrammarFact::Expected { what: what @ "`=`", found } if found == "`==`" => {
                write!(
                    f,
                    "expected {what}, found {found}\nhelp: a name gets its value with `=`; `==` stands between the sides of an equation"
                )
            }
            GrammarFact::Expected { what, found } => {
                write!(f, "expected {what}, found {}", shortened(found))?;
                match (*what, found.as_str()) {
                    ("an expression", "`match`") => write!(f, "\nhelp: choose by `if a < b {{ x }} else {{ y }}`"),
                    ("`,` or `)`" | "`,` or the end of the list", found)
                        if found[1..].starts_with(|digit: char| digit.is_ascii_digit()) =>
                    {
                        write!(f, "\nhelp: write `,` between two values")
                    }
                    ("an expression", "`|`") => write!(f, "\nhelp: write `abs(x)`, or `norm(v)` of a vector"),
                    ("an item", "`%`") => write!(f, "\nhelp: a comment begins with `//`"),
                    ("an expression", "`.`") => write!(f, "\nhelp: a number begins with a digit, such as `0.5`"),
                    ("the name of the joint", "`=`") => write!(f, "\nhelp: write `joint name = …`"),
                    ("the name of the drive", "`=`") => write!(f, "\nhelp: write `drive name = …`"),
                    ("`(` and the arguments", "`{`") => write!(f, "\nhelp: arguments stand in parentheses"),
                    ("`(` and the arguments of the component", "`;`") => write!(f, "\nhelp: one without arguments is called with `()`"),
                    ("`=`", "`,`") => write!(f, "\nhelp: each has a declaration of its own"),
                    ("`t in from..to`", _) => write!(f, "\nhelp: a range is one of time: write `range t in 0s..1s;`"),
                    ("`from` and the value at t = 0, `at` and the rate at t = 0, or `;`", "`in`") => {
                        write!(f, "\nhelp: a freedom has no bounds; forces that end a motion are `stop`, `stop_along` and `torsion_stop`")
                    }
                    ("`=`", "`{`") => write!(f, "\nhelp: a value comes after `=`, without braces"),
                    ("`=`", "`(`") => {
                        write!(f, "\nhelp: write `point P = (…);` for a point, `function f(x: Angle) -> Length = …;` for a function")
                    }
                    ("the name of the energy", "`=`") => write!(f, "\nhelp: write `energy name = …`"),
                    ("the name of the force", "`=`") => write!(f, "\nhelp: write `force name = …`"),
                    ("the name of the freedom", "`=`") => write!(f, "\nhelp: write `freedom name = …`"),
                    ("a value of a joint, such as `hinge.angle`", "`{`") => {
                        write!(f, "\nhelp: write `start angle = …;` in the body, or `start hinge.angle = …;` for a joint in space")
                    }
                    ("`(argument: Dimension)`", _) => {
                        write!(
                            f,
                            "\nhelp: write `function name(x: Angle) -> Length = …;`, or `let name = …;` for a value without an argument"
                        )
                    }
                    ("`jerk` after `with`", found) if is_rate(found.trim_matches('`')) || is_acceleration(found.trim_matches('`')) => {
                        write!(f, "\nhelp: an output has its rate and its acceleration already: write it without `with`")
                    }
                    ("`jerk` after `with`", "`unit`" | "`units`") => {
                        write!(f, "\nhelp: values are in SI: take it away, and convert the output in Rust")
                    }
                    ("`jerk` after `with`", found) => {
                        write!(f, "{}", did_you_mean(&crate::words::nearest(found.trim_matches('`'), ["jerk"].into_iter())))
                    }
                    ("`{ value }`", "`then`") => write!(f, "\nhelp: write `if a < b {{ x }} else {{ y }}`"),
                    ("`=`", "`:`") => {
                        write!(f, "\nhelp: a value comes after `=`; only parameters and inputs have `:` and a dimension before it")
                    }
                    ("`:` and a dimension such as `Length`", "`;`") => {
                        write!(f, "\nhelp: write the dimension behind the name, as in `name: Length = …;`")
                    }
                    ("`=` and the default of the parameter", _) => {
                        write!(f, "\nhelp: each parameter has a default, as in `param name: Length = 50mm;`")
                    }
                    ("`x`, `y`, `angle` or `position`", "`=`" | "`{`") => {
                        write!(f, "\nhelp: say of which coordinate, as in `start x = 200mm;` or `start position = (200mm, 0mm);`")
                    }
                    ("`{ value }`", "`and`" | "`or`" | "`<`" | "`>`" | "`<=`" | "`>=`") => {
                        write!(
                            f,
                            "\nhelp: a choice has one condition: choose twice, as in `if a < b {{ if c < d {{ x }} else {{ y }} }} else {{ y }}`"
                        )
                    }
                    ("`..` or `..=` and the end of the range", _) => write!(f, "\nhelp: write `for i in 0..3 {{ … }}`"),
                    (what, "`-`" | "`%`") if what.starts_with("an item: ") => write!(f, "\nhelp: a comment begins with `//`"),
                    _ => Ok(()),
                }
            }
            GrammarFact::WithoutEquals { found, instead } => {
                write!(f, "expected `=`, found {}\nhelp: write `{}`", shortened(found), shortened(instead))
            }
            GrammarFact::BodyWithoutBraces { name, found } => {
                write!(f, "expected `{{` and the points of the body, found {}\nhelp: ", shortened(found))?;
                match found.as_str() {
                    "`;`" => write!(f, "a body without points is `body {name} {{}}`"),
                    "`=`" => write!(f, "write `body {name} {{ … }}`; a part that is made of a component is `part {name} = Component(…);`"),
                    _ => write!(f, "write `body {name} {{ … }}`, a name is one word; a body without points is `body {name} {{}}`"),
                }
            }
            GrammarFact::ParameterWithoutDimension { name, default } => {
                write!(f, "expected `:` and a dimension such as `Length`, found `=`\nhelp: write ")?;
                match default {
                    Some((dimension, default)) => write!(f, "`{name}: {dimension} = {default};`"),
                    None => write!(f, "the dimension behind the name, as in `{name}: Length = …;`"),
                }
            }
            GrammarFact::ArgumentByEquals { name } => {
                write!(f, "an argument gets its value with `:`, found `=`\nhelp: write `{name}: …`")
            }
            GrammarFact::Unnamed { word, kind } => write!(f, "a {word} has a name of its own\nhelp: write `{word} name = {kind}(…);`"),
            GrammarFact::NotANumber { found } => {
                write!(f, "expected a number, found {found}\nhelp: a quantity is a number with its unit right behind it, such as `120mm`")
            }
            GrammarFact::PartsTooDeep { limit } => {
                write!(f, "parts are nested more than {limit} deep\nhelp: declare the innermost parts in the mechanism, beside the others")
            }
            GrammarFact::TooDeep { limit } => {
                write!(f, "this is nested more than {limit} deep\nhelp: name parts of it with `let`")
            }
            GrammarFact::TooLong { limit } => {
                write!(f, "this has more than {limit} operations one after the other\nhelp: name parts of it with `let`")
            }
            GrammarFact::LongChain { limit, in_function: true } => {
                write!(
                    f,
                    "functions call each other here more than {limit} steps deep\nhelp: write the value of one as a table or as one formula"
                )
            }
            GrammarFact::LongChain { limit, .. } => write!(
                f,
                "this is used before it is declared, and so is what it is made of, more than {limit} steps deep\nhelp: declare first what others are made of"
            ),
            GrammarFact::Keyword { word } if word == "mut" => {
                write!(f, "nothing here changes\nhelp: take `mut` away; what is to be set at run time is a `param`")
            }
            GrammarFact::Keyword { word } => write!(f, "`{word}` is a word of Rust and cannot be a name\nhelp: write `{word}_`"),
            GrammarFact::NumberType => write!(f, "`T` is the number type of generated code\nhelp: choose another name for the mechanism"),
            GrammarFact::UnknownAttribute { name } => {
                write!(
                    f,
                    "`#[{name}]` is not known here\nhelp: doc comments may stand before any item, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`, `#[picture]`, `#[serde]`, `#[outputs]` and `#[points]` before `mechanism`, `#[velocity]` before `joint` and `drive`"
                )
            }
            GrammarFact::AttributeTwice { name } => write!(f, "`#[{name}]` stands here twice\nhelp: take one of them away"),
            GrammarFact::SecondTask { name } => {
                write!(f, "`#[{name}]` stands after another attribute that says what is generated")?;
                write!(f, "\nhelp: keep one of `#[equations_only]` and `#[integrated]`")
            }
            GrammarFact::ClosingWord { near } => {
                write!(f, "`#[closure(…)]` takes one of `deny`, `start`, `allow` and `off`{}", did_you_mean(near))
            }
            GrammarFact::AllowedWord { near } => {
                write!(f, "`#[allow(…)]` takes the word `far_start` here{}", did_you_mean(near))?;
                write!(f, "\nnote: a lint of Rust is allowed for the module in which the mechanism stands")
            }
            GrammarFact::TokensAfter { what, help } => write!(f, "nothing may follow {what}\nhelp: {help}"),
            GrammarFact::UnknownItem { word, .. } if word == "pub" => {
                write!(f, "all of a mechanism is as public as the mechanism\nhelp: take `pub` away")
            }
            GrammarFact::UnknownItem { word, .. } if ["mass", "inertia", "center"].contains(&word.as_str()) => {
                write!(f, "`{word}` belongs in a body\nhelp: write it there, as in `body b {{ {word} = …; }}`")
            }
            GrammarFact::UnknownItem { word, .. } if ["require", "assert"].contains(&word.as_str()) => {
                write!(
                    f,
                    "`{word}` is no item of a mechanism\nhelp: bounds of a parameter come after it, as in `param a: Length = 100mm in 50mm..;`"
                )
            }
            GrammarFact::UnknownItem { word, .. } if crate::words::is_command(word) => {
                write!(
                    f,
                    "`{word}` is no item of a mechanism\nhelp: that is done in Rust, such as `mechanism.sweep(times)`, with freedoms `mechanism.sweep(times, Integrator::new(1e-9))`"
                )
            }
            GrammarFact::UnknownItem { word, .. } if ["event", "when", "trigger", "sensor"].contains(&word.as_str()) => {
                write!(
                    f,
                    "`{word}` is no item of a mechanism\nhelp: a quantity is an `output`, and in Rust `mechanism.advance_until(…)` finds its zero"
                )
            }
            GrammarFact::UnknownItem { word, .. } if ["limit", "limits"].contains(&word.as_str()) => {
                write!(
                    f,
                    "`{word}` is no item of a mechanism\nhelp: ends of a motion are forces, `stop`, `stop_along` and `torsion_stop`"
                )?;
                write!(f, "; a parameter has bounds, `param a: Angle = 0deg in -90deg..=90deg;`")
            }
            GrammarFact::UnknownItem { word, .. } if ["geom", "visual", "collision", "shape", "mesh"].contains(&word.as_str()) => {
                write!(
                    f,
                    "`{word}` is no item of a mechanism\nhelp: a body has `mass`, `center` and `inertia`, as in `inertia = block(2cm, 3cm, 4cm);`"
                )
            }
            GrammarFact::UnknownItem { word, .. } if word == "worldbody" => {
                write!(f, "`{word}` is no item of a mechanism\nhelp: take it away; what stands still is `ground {{ … }}`")
            }
            GrammarFact::UnknownItem { word, name, home: Some(home) } => {
                let name = name.as_deref().unwrap_or("name");
                write!(f, "`{word}` is no item of a mechanism\nhelp: ")?;
                if *home == Home::Nothing {
                    return write!(
                        f,
                        "take it away: a body that no joint holds moves freely, with `freedom p = body.position; freedom q = body.angle;`, in space `body.angular_velocity`"
                    );
                }
                write!(f, "write ")?;
                match home {
                    Home::Nothing => Ok(()),
                    Home::Body => write!(f, "`body {name} {{ … }}`"),
                    Home::Joint(calls) => {
                        let lines: Vec<String> = calls.iter().map(|call| format!("`joint {name} = {call};`")).collect();
                        write!(f, "{}", lines.join(" or "))
                    }
                    Home::Drive(call) => write!(f, "`drive {name} = {call};`"),
                    Home::Force(call) => write!(f, "`force {name} = {call};`"),
                    Home::Equation => write!(f, "its equation, `joint {name} = {{ lhs == rhs; }}`"),
                }
            }
            GrammarFact::UnknownItem { word, .. } => {
                // Words as short as `for` resemble many others: they are tried last.
                let (rare, often): (Vec<&str>, Vec<&str>) = ITEMS.iter().partition(|known| matches!(**known, "part" | "for" | "range"));
                let near = crate::words::nearest;
                let near = near(word, often.into_iter()).or_else(|| near(word, rare.into_iter()));
                write!(f, "`{word}` is no item of a mechanism{}", did_you_mean(&near))?;
                write!(f, "\nnote: items are {}", listed(ITEMS.into_iter()))
            }
            GrammarFact::HashComment => {
                write!(f, "`#` begins an attribute, such as `#[picture]`\nhelp: a comment begins with `//`")
            }
            GrammarFact::CommaAtEnd => write!(f, "expected `;`, found `,`\nhelp: `;` ends each item, `,` stands between arguments"),
            GrammarFact::BoundsElsewhere => {
                write!(
                    f,
                    "bounds belong to a parameter or an input, as in `param a: Length = 1m in 0m..;`\nhelp: forces that end a motion are `stop`, `stop_along` and `torsion_stop`"
                )
            }
            GrammarFact::Misspelt { flaw, instead } => write!(f, "{flaw}\nhelp: write `{}`", shortened(instead)),
            GrammarFact::DecimalComma => write!(f, "expected `;`, found `,`\nhelp: write a decimal point, as in `60.5mm`"),
            GrammarFact::OutputWithoutName { value } => {
                write!(f, "an output has a name of its own\nhelp: write `output name = {};`", shortened(value))
            }
            GrammarFact::OutputWithDimension { name } => {
                write!(f, "an output has the dimension of its value\nhelp: write `output {name} = …;`")
            }
            GrammarFact::TwoConditions => {
                write!(
                    f,
                    "a choice has one condition\nhelp: choose twice, as in `if a < b {{ if c < d {{ x }} else {{ y }} }} else {{ y }}`"
                )
            }
            GrammarFact::NumberBeforeParentheses { number, is_range: true } => {
                write!(f, "the bounds of a parameter come after `in`\nhelp: write `{number} in 50mm..=150mm`")
            }
            GrammarFact::NumberBeforeParentheses { number, .. } => {
                write!(f, "an operator is missing between `{number}` and `(`\nhelp: write `{number} * (…)`")
            }
            GrammarFact::OutputInUnit { unit } => {
                write!(f, "values are in SI, and no unit is chosen for them\nhelp: take `in {unit}` away; outputs are converted in Rust")
            }
            GrammarFact::ConditionInParentheses => {
                write!(f, "a condition has no parentheses\nhelp: write `if a < b {{ x }} else {{ y }}`")
            }
            GrammarFact::UnitBehindParentheses { written, unit } => {
                write!(f, "a unit comes after a number, and `{unit}` behind parentheses\nhelp: write `({}) * 1{unit}`", shortened(written))
            }
            GrammarFact::ArrayOfDimension { written } => {
                write!(f, "`{}` is no dimension: arrays are declared by a loop", shortened(written))?;
                write!(f, "\nhelp: write `for i in 0..3 {{ param name[i]: Length = 100mm; }}`")
            }
            GrammarFact::ForceBeforePlace { name, clause } => {
                write!(f, "a force stands after its point, a torque after its body\nhelp: write `force {name} = {{ {clause}; }}`")
            }
            GrammarFact::ComparisonOutside => {
                write!(f, "a comparison is no value\nhelp: write `if a < b {{ x }} else {{ y }}` for a choice")
            }
            GrammarFact::Stray { sign } => write!(f, "this `{sign}` ends nothing\nhelp: take it away"),
            GrammarFact::UnitRaised { written, unit, squared } => {
                write!(f, "`{written}` raises the number with its unit to a power\nhelp: the unit is `{unit}`; a square is `{squared}`")
            }
            GrammarFact::RustConstant { written, instead } => {
                write!(f, "`{written}` is a constant of Rust\nhelp: write `{instead}`")
            }
            GrammarFact::UnknownBodyItem { word, .. } if ["fixed", "grounded", "static", "is_fixed", "frozen"].contains(&word.as_str()) => {
                write!(f, "`{word}` is no item of a body\nhelp: what stands still is `ground`: write its points there, `ground {{ … }}`")
            }
            GrammarFact::UnknownBodyItem { word, is_point: true }
                if ["orientation", "rotation", "euler", "rpy"].contains(&word.as_str()) =>
            {
                write!(f, "`{word}` is no item of a body\nhelp: write `start orientation = turn((0, 0, 1), 90deg);` ")?;
                write!(f, "for about how the body is turned at t = 0, in the plane `start angle = 90deg;`")
            }
            GrammarFact::UnknownBodyItem { word, is_point: false }
                if ["orientation", "rotation", "theta", "phi"].contains(&word.as_str()) =>
            {
                write!(f, "`{word}` is no item of a body\nhelp: write `start angle = …;` for about how the body is turned at t = 0, ")?;
                write!(f, "in space `start orientation = turn((0, 0, 1), 90deg);`")
            }
            GrammarFact::UnknownBodyItem { word, .. } if word == "inertial" => {
                write!(f, "`{word}` is no item of a body\nhelp: write `mass = …;`, `center = …;` and `inertia = …;` in the body itself")
            }
            GrammarFact::UnknownBodyItem { word, is_point: true } if word == "position" => {
                write!(f, "`{word}` is no item of a body\nhelp: write `start {word} = …;` for about where the body is at t = 0")
            }
            GrammarFact::UnknownBodyItem { word, is_point: true } if ITEMS.contains(&word.as_str()) => {
                write!(f, "`{word}` is no item of a body\nhelp: it stands in the mechanism: move it out of the body")
            }
            GrammarFact::UnknownBodyItem { word, is_point: true } => {
                write!(f, "`{word}` is no item of a body")?;
                match crate::words::nearest(word, ["mass", "center", "inertia"].into_iter()) {
                    Some(near) => write!(f, "\nhelp: did you mean `{near}`?"),
                    None => write!(f, "\nhelp: write `point {word} = (…);` for a point"),
                }
            }
            GrammarFact::MassOfGround { word } => {
                write!(f, "ground does not move: its `{word}` would change nothing\nhelp: take it away, or write it in a body")
            }
            GrammarFact::FeatureOutside { word, name, in_component: true } => {
                let parameter = if word == "axis" { "Axis" } else { "Point" };
                write!(f, "`{word}` belongs in a body, or in the ground of the mechanism")?;
                write!(
                    f,
                    "\nhelp: declare it there, `ground {{ {word} {name} = …; }}`, and give it to the component, `{name}: {parameter}`"
                )
            }
            GrammarFact::FeatureOutside { word, name, .. } => {
                write!(f, "`{word}` belongs in ground or in a body\nhelp: write it there, as in `ground {{ {word} {name} = …; }}`")
            }
            GrammarFact::UnknownBodyItem { word, .. } => {
                write!(f, "`{word}` is no item of a body")?;
                if ["x", "y", "z", "angle", "position"].contains(&word.as_str()) {
                    return write!(f, "\nhelp: write `start {word} = …;` for about where the body is at t = 0");
                }
                if ITEMS.contains(&word.as_str()) {
                    return write!(f, "\nhelp: it stands in the mechanism: move it out of the body");
                }
                let near = crate::words::nearest(word, BODY_ITEMS.into_iter());
                write!(f, "{}", did_you_mean(&near))?;
                if ["density", "material"].contains(&word.as_str()) {
                    write!(f, "\nhelp: write the mass, a density times a volume, as in `mass = 2kg;`")?;
                }
                if near.is_none() && ["length", "width", "height", "size", "radius"].contains(&word.as_str()) {
                    write!(f, "\nhelp: a body is as large as its points say, such as `point end = (300mm, 0mm);`")?;
                }
                write!(f, "\nnote: a body has {}", listed(BODY_ITEMS.into_iter()))
            }
            GrammarFact::OneEqualsSign => write!(f, "an equation is written with `==`\nhelp: write `lhs == rhs;`"),
            GrammarFact::OneArgument => {
                write!(f, "a function here has one argument\nhelp: what else it depends on is a `param` or a `let`, which it sees")
            }
            GrammarFact::WithoutParentheses { what, instead } => {
                write!(f, "the coordinates of {what} stand in parentheses\nhelp: write `{}`", shortened(instead))
            }
            GrammarFact::PathOfConstraint { path, last } => {
                write!(f, "a joint names its constraint by a single word\nhelp: write `use {path};` above, and `{last}(…)` here")
            }
            GrammarFact::Return { is_segment: true } => {
                write!(f, "expected an expression, found `return`\nhelp: a segment that goes down is `fall(height, duration, law)`")
            }
            GrammarFact::Return { .. } => {
                write!(
                    f,
                    "expected an expression, found `return`\nhelp: take it away: an equation is `lhs == rhs;`, a value comes after `=`"
                )
            }
            GrammarFact::DoubleStar => write!(f, "`**` is no operator\nhelp: a power is written `a^b`"),
            GrammarFact::MethodCall { name } if PROPERTIES.contains(&name.as_str()) => {
                write!(f, "`{name}` is a value, not a method\nhelp: write `.{name}` without parentheses, for its value at t")
            }
            GrammarFact::MethodCall { name } => {
                write!(f, "there are no methods here\nhelp: ")?;
                match foreign(name) {
                    Some((_, instead)) => f.write_str(instead),
                    None => write!(f, "write `{name}(value)` for `value.{name}()`"),
                }
            }
            GrammarFact::SpaceBeforeUnit { number, suffix, unit } => {
                if crate::quantity::unit(&format!("{suffix}{unit}")).is_some() {
                    return write!(f, "a unit stands right behind its number\nhelp: write `{number}{unit}`");
                }
                let degrees = if unit == "d" { format!(", or `{number}deg` for degrees") } else { String::new() };
                write!(f, "an operator is missing between `{number}` and `{unit}`\nhelp: write `{number} * {unit}`{degrees}")
            }
            GrammarFact::ExponentTooLarge { limit } => write!(f, "the exponent of a dimension is at most {limit}"),
            GrammarFact::OnlyAtTheTop { word } => {
                let place = if word == "input" { "a component" } else { "a component or a loop" };
                write!(f, "`{word}` stands in the mechanism itself, not in {place}\nhelp: move it out")?;
                let of_components = "; a component takes points and axes of ground as parameters, such as `P: Point` and `a: Axis`";
                if word == "ground" { write!(f, "{of_components}") } else { Ok(()) }
            }
            GrammarFact::StartInLoop => write!(f, "a body starts once: `start` cannot be repeated\nhelp: move it out of the loop"),
            GrammarFact::StartOfJoint => {
                write!(f, "a body declares its own start, and that of a joint stands outside bodies\nhelp: move it out of the body")
            }
            GrammarFact::IndexInEquations { name } => {
                write!(f, "`{name}` cannot have an index: there are no arrays among equations\nhelp: declare the array in the mechanism")
            }
        }
    }
}
