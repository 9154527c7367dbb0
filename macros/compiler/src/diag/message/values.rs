//! Messages about kinds, dimensions and values.

use super::significant;
use super::words::{is_velocity, shortened};
use crate::diag::{Kind, Typed, ValueFact, Wanted, quantity, remedy};
use crate::quantity::{Ambient, Dim};
use std::f64::consts::TAU;
use std::fmt::{Display, Formatter, Result};

impl Display for ValueFact {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self {
            ValueFact::NotA { wanted, found, ambient } => {
                write!(f, "expected {wanted}, found {found}{}", remedy::of_kind(wanted, found, *ambient))
            }
            ValueFact::WrongArgument { parameter, definition, wanted, found, ambient, instead } => {
                write!(f, "`{parameter}` of `{definition}` takes {wanted}, found {found}")?;
                if let Some(drive) = remedy::of_drive(definition, found) {
                    return write!(f, "\nhelp: write `{drive}`");
                }
                if (definition.as_str(), parameter.as_str(), found) == ("gear_pair", "c", &Kind::Body) {
                    return write!(f, "\nhelp: a body that carries both axes has its name, `carrier: …`");
                }
                match (instead, remedy::about_an_axis(definition, found)) {
                    (Some(instead), _) => {
                        write!(f, "\nhelp: write `{instead}`")?;
                        match instead.rsplit_once('.') {
                            Some((body, point)) if *found == Kind::Body && *wanted == Wanted::Point && point != "position" => {
                                write!(f, ", or `{body}.position` for its origin")
                            }
                            _ => Ok(()),
                        }
                    }
                    (None, Some(turning)) => write!(f, "\nhelp: `{turning}` acts between axes, about them"),
                    (None, None) => match wanted {
                        Wanted::FunctionOfOne([from, to]) => {
                            write!(f, "\nhelp: declare one, such as `function name(x: {from}) -> {to} = …;`")
                        }
                        _ => write!(f, "{}", remedy::of_kind(wanted, found, *ambient)),
                    },
                }
            }
            ValueFact::CoordinateForAxis { parameter, definition, body, name } => {
                write!(f, "`{parameter}` of `{definition}` takes an axis, and `{body}.{name}` is a coordinate")?;
                let along = match name.as_str() {
                    "x" => "(1, 0, 0)",
                    "y" => "(0, 1, 0)",
                    _ => "(0, 0, 1)",
                };
                write!(f, "\nhelp: declare `axis {name} = {along};` in `{body}`: then `{body}.{name}` is this axis")
            }
            ValueFact::WrongArgumentDimension { parameter, definition, wanted, found } => {
                write!(f, "`{parameter}` of `{definition}` is {wanted}, found {found}")?;
                if definition == "screw" && parameter == "lead" && found.times(Dim::ANGLE) == *wanted {
                    return write!(f, "\nhelp: the lead is the way of one turn: write `lead: 5mm`");
                }
                let shares = [(Dim::FORCE, "force", "500Ns_m / 5kN"), (Dim::TORQUE, "torque", "2Nms_rad / 20Nm")];
                let share = shares.into_iter().find(|(of, ..)| definition.contains("stop") && found.per(*of) == *wanted);
                if let Some((_, of, instead)) = share {
                    return write!(f, "\nhelp: it multiplies the {of} of the stop: divide by that, as in `{instead}`");
                }
                if found.times(Dim::TIME) == *wanted && [Dim::ANGLE, Dim::LENGTH].contains(wanted) {
                    return write!(f, "\nhelp: multiply the rate by `t`");
                }
                let (factor, instead) = match (*wanted, *found) {
                    (Dim::TORQUE, Dim::ANGLE) => ("10Nm_rad", "drive_angle(b, C)`, in space `drive_rotation(hinge.angle, C)"),
                    (Dim::FORCE, Dim::LENGTH) => ("100N_m", "drive_distance(P, Q, C)"),
                    _ => ("", ""),
                };
                if ["motor", "actuator"].contains(&definition.as_str()) && !instead.is_empty() {
                    write!(f, "\nhelp: give it a factor such as `{factor}`")?;
                    return write!(f, "; a motion that is given is a drive, `drive name = {instead}`");
                }
                // An argument given as a function of time often lacks only a factor with a unit.
                match *found {
                    Dim::TIME if *wanted == Dim::ANGLE => write!(f, "\nhelp: multiply the time by a rate, such as `2rad_s` or `60rpm`"),
                    Dim::TIME => write!(f, "\nhelp: multiply the time by a rate in {}", wanted.per(Dim::TIME).unit()),
                    found if found.is_of_time() => write!(f, "\nhelp: multiply it by a quantity in {}", wanted.per(found).unit()),
                    found => f.write_str(remedy::of_dimension(*wanted, found)),
                }
            }
            ValueFact::WrongDefault { wanted, found } => write!(f, "the parameter takes {wanted}, its default is {found}"),
            ValueFact::NotAnEnergy { found } => {
                write!(f, "an energy is in J, found {found}")?;
                write!(f, "\nhelp: a spring of stiffness `k` has `0.5 * k * s^2`, a constant force `F` has `-F * s` along `s`")
            }
            // That a force drives nothing is told to drives.
            ValueFact::WrongDimension { wanted: wanted @ (Dim::ANGLE | Dim::LENGTH), found: found @ (Dim::TORQUE | Dim::FORCE) } => {
                write!(f, "expected {wanted}, found {found}")
            }
            ValueFact::WrongDimension { wanted, found } => {
                write!(f, "expected {wanted}, found {found}{}", remedy::of_dimension(*wanted, *found))
            }
            ValueFact::OfFunction { wanted, found } => {
                write!(f, "expected {wanted}, found {found}{}", remedy::of_function(*wanted, *found))
            }
            ValueFact::NotARate { written, found, instead } => {
                write!(f, "`{written}` is {found}, and what grows with `t` is multiplied by a rate\nhelp: write `{instead}`")
            }
            ValueFact::PoseAsPosition { written } => {
                write!(f, "a position in the plane has 2 components, found 3")?;
                let parts: Vec<&str> = written.trim_matches(['(', ')']).split(", ").collect();
                match parts.as_slice() {
                    [x, y, angle] if angle.ends_with("deg") || angle.ends_with("rad") => {
                        write!(f, "\nhelp: write `start position = ({x}, {y}); start angle = {angle};`")
                    }
                    _ => {
                        write!(f, "\nhelp: an angle is written `start angle = …;`")?;
                        write!(f, "; for a mechanism in space write `mechanism Name in space {{ … }}`")
                    }
                }
            }
            ValueFact::BareGains { action, one, two, numbers: [first, second] } => {
                let units = if *one == Dim::ANGLE { ["Nm", "Nms"] } else { ["N_m", "Ns_m"] };
                write!(f, "{}", ValueFact::Unlike { action, one: *one, two: *two }.to_string().lines().next().unwrap_or_default())?;
                if [first, second].iter().all(|factor| !factor.starts_with(|letter: char| letter.is_ascii_digit())) {
                    let of = if *one == Dim::ANGLE { "Torque" } else { "Force / Length" };
                    return write!(
                        f,
                        "\nhelp: gains have dimensions: declare `{first}` as `{of}` and `{second}` as `{of} * Time`, for instance"
                    );
                }
                let [one, two] = units;
                write!(f, "\nhelp: give the factors units that make both terms alike, such as `{first}{one}` and `{second}{two}`")
            }
            ValueFact::Unlike { action, one, two } => {
                let joint = if *action == "equate" || *action == "compare" { "with" } else { "and" };
                match *action {
                    "subtract" => write!(f, "cannot subtract {two} from {one}"),
                    "add" => write!(f, "cannot add {two} to {one}"),
                    _ => write!(f, "cannot {action} {one} {joint} {two}"),
                }?;
                write!(f, "{}", remedy::of_dimensions(*one, *two))
            }
            ValueFact::NotALength { found, instead } => {
                write!(f, "a coordinate of a point is a length (m), found {found}")?;
                instead.as_ref().map_or(Ok(()), |instead| write!(f, "\nhelp: write `{instead}`"))
            }
            ValueFact::FunctionTakes { wanted, found } => write!(f, "expected a function of {wanted}, found a function of {found}"),
            ValueFact::OrderOfBodies => write!(f, "bodies have no order\nhelp: compare them with `==` or `!=`"),
            ValueFact::CannotCompare { one, two } => write!(f, "cannot compare {one} with {two}"),
            ValueFact::CannotEquate { one, two, ambient } => {
                write!(f, "cannot equate {one} with {two}{}", remedy::of_equation(one, two, *ambient))
            }
            ValueFact::NotTwoComponents { found, meant: Some(number) } | ValueFact::NotThreeComponents { found, meant: Some(number) } => {
                let wanted = if matches!(self, ValueFact::NotTwoComponents { .. }) { "the plane has 2" } else { "space has 3" };
                write!(f, "a vector in {wanted} components, found {found}\nhelp: write a decimal point, `{number}`")
            }
            ValueFact::NotThreeComponents { found, .. } => {
                write!(f, "a vector in space has 3 components, found {found}")?;
                match found {
                    2 => write!(f, "\nhelp: write the third, which is 0 in the plane of x and y"),
                    4 => write!(f, "\nhelp: an orientation is a turn about an axis, as in `turn((0, 0, 1), 90deg)`, or a product of turns"),
                    _ => Ok(()),
                }
            }
            ValueFact::MeansSpace { name, is_component: true } => {
                write!(f, "`{name}` has words and vectors of space, and a component is in the plane where it does not say `in space`")?;
                write!(f, "\nhelp: write `component {name}(…) in space {{ … }}`")
            }
            ValueFact::MeansSpace { name, .. } => {
                write!(f, "`{name}` has words and vectors of space, and a mechanism is in the plane where it does not say `in space`")?;
                write!(f, "\nhelp: write `mechanism {name} in space {{ … }}`")
            }
            ValueFact::OnlyInSpace { word, typed } => {
                mistyped(f, typed.as_ref())?;
                write!(f, "`{word}` is for mechanisms in space: write `mechanism Name in space {{ … }}`, or {}", remedy::in_plane(word))
            }
            ValueFact::OnlyInPlane { word, typed } => {
                mistyped(f, typed.as_ref())?;
                write!(f, "`{word}` is for the plane; in space write {}", remedy::in_space(word))
            }
            ValueFact::AlongItsAxis { name, is_along_x } => {
                write!(f, "angles about `{name}` are counted from a direction across it, and this one has no part across it")?;
                write!(f, "\nhelp: write a direction across it, such as `from {}`", if *is_along_x { "(0, 1, 0)" } else { "(1, 0, 0)" })
            }
            ValueFact::NotTwoComponents { found, .. } => {
                write!(f, "a vector in the plane has 2 components, found {found}")?;
                if *found == 3 { write!(f, "\nhelp: for a mechanism in space write `mechanism Name in space {{ … }}`") } else { Ok(()) }
            }
            ValueFact::VectorAndNumber { in_space: true } => {
                write!(f, "cannot add or subtract a vector and a number")?;
                write!(f, "\nhelp: write the number as a vector, `(x, y, z)`, or take a component, `.x`, `.y` or `.z`")
            }
            ValueFact::VectorAndNumber { in_space: false } => {
                write!(f, "cannot add or subtract a vector and a number")?;
                write!(f, "\nhelp: write the number as a vector, `(x, y)`, or take a component, `.x` or `.y`")
            }
            ValueFact::NumberByVector => write!(f, "nothing can be divided by a vector\nhelp: write `norm(v)` for its length"),
            ValueFact::VectorTimesVector => {
                write!(f, "there is more than one product of vectors\nhelp: write `dot(a, b)` or `cross(a, b)`")
            }
            ValueFact::PowerOfDimension { base } => {
                write!(f, "{base} can only be raised to a number that is written out, a multiple of 1/6")?;
                write!(f, "\nhelp: divide it by a quantity of its kind, and raise the ratio")
            }
            ValueFact::NotAnOutput { found } => {
                write!(f, "an output is a number, a vector, a point or a body that moves, found {found}")?;
                match found {
                    Kind::Orientation => {
                        write!(
                            f,
                            "\nhelp: write `state.body().orientation()` in the program; `body.orientation * (1, 0, 0)` is a direction"
                        )
                    }
                    Kind::Joint | Kind::JointOf(_) => {
                        write!(
                            f,
                            "\nhelp: write a value of it, such as `joint.P`, or in space `joint.angle` or `joint.displacement`; its force is one of the loads, in Rust `mechanism.loads(&state)`"
                        )
                    }
                    _ => Ok(()),
                }
            }

            ValueFact::NumberTooLong { number, limit } => {
                write!(f, "`{}` has more than {limit} digits\nhelp: of a number, 17 digits are as good as all", shortened(number))
            }
            ValueFact::NumberOutOfRange { number } => {
                write!(f, "`{}` cannot be kept exactly", shortened(number))?;
                write!(f, "\nnote: in m, rad, s and kg, numbers lie between 1e-16 and 1e36, those of few digits down to 1e-36")
            }
            ValueFact::NotFinite { place } => write!(f, "{place} is not a finite number"),
            ValueFact::TooLarge { limit, in_function } => {
                write!(f, "the equations grow beyond {limit} operations here")?;
                match in_function {
                    true => write!(f, "\nhelp: a function that calls others several times is written out at every call"),
                    false => write!(f, "\nhelp: declare less of it, or make several mechanisms of it"),
                }
            }
            ValueFact::DivisionByZero => write!(f, "division by zero"),
            ValueFact::EqualityInChoice => {
                write!(f, "equality of measured numbers is an accident\nhelp: compare with `<`, `<=`, `>` or `>=`")
            }
            ValueFact::ListOutsideTable => {
                write!(
                    f,
                    "a list can only be an argument of `table`, `spline` or `segments`\nhelp: a vector is written `(x, y)`, in space `(x, y, z)`; of an array each element has a line of its own, `let a[0] = …;`"
                )
            }
            ValueFact::TableArity { found } => {
                write!(f, "`table` takes 2 or 3 arguments, found {found}\nnote: `table(x, [(x0, y0), (x1, y1), …], periodic)`")
            }
            ValueFact::TableNeedsList => write!(f, "expected a list of pairs, such as `[(0deg, 0mm), (90deg, 5mm)]`"),
            ValueFact::TableTakesArgumentFirst { word, instead } => write!(f, "`{word}` takes its argument first\nhelp: write `{instead}`"),
            ValueFact::TableNeedsPairs => write!(f, "expected a pair, such as `(90deg, 5mm)`"),
            ValueFact::TableNotIncreasing { word, before, found, dim } => {
                let [found, before] = [found, before].map(|value| remedy::quantity(*value, *dim));
                write!(f, "the first numbers of a {word} must increase from pair to pair: {found} comes after {before}")
            }
            ValueFact::TableTooShort { word, found } => write!(f, "a {word} needs at least 2 pairs, found {found}"),
            ValueFact::TableNotPeriodic { word, first, last, dim } => {
                let [first, last] = [first, last].map(|value| remedy::quantity(*value, *dim));
                write!(f, "a periodic {word} ends with the value it begins with: it begins with {first} and ends with {last}")
            }
            ValueFact::TableEnds { found } => write!(f, "outside its range a table is `periodic`, `linear` or `hold`, not {found}"),
            ValueFact::SplineArity { found } => {
                write!(f, "`spline` takes 2 or 3 arguments, found {found}\nnote: `spline(x, [(x0, y0), (x1, y1), …], periodic)`")
            }
            ValueFact::SplineTooLong { found, limit } => {
                write!(f, "a spline goes through {limit} points at most, found {found}\nhelp: `table` takes any number of points")
            }
            ValueFact::SplineEnds => {
                write!(f, "a spline is `periodic`, rests at both ends, `hold`, or has a velocity and an acceleration at each")?;
                write!(f, "\nhelp: write `[(v0, a0), (v1, a1)]`, the derivatives at the first and at the last point")
            }
            ValueFact::SplineSwings => {
                write!(f, "the spline overshoots so far between its points that its digits run out")?;
                write!(f, "\nhelp: give points at more even distances, or take a `table`")
            }
            ValueFact::SplineOutOfRange => {
                write!(f, "the numbers of this spline are too small or too large to be kept")?;
                write!(f, "\nnote: in m, rad, s and kg, they lie between 1e-16 and 1e36")
            }
            ValueFact::SharesOfLaw { found: [b, c] } => {
                let [b, c] = [*b, *c].map(significant);
                write!(
                    f,
                    "`scca(u, b, c)` has shares b and c of the duration that are not negative and at most 1 together, found {b} and {c}"
                )
            }
            ValueFact::SegmentsArity { found } => {
                write!(f, "`segments` takes 3 or 4 arguments, found {found}")?;
                write!(f, "\nnote: `segments(x, y0, [rise(height, duration, law), dwell(duration), …], periodic)`")
            }
            ValueFact::SegmentsNeedList => write!(f, "expected a list of segments, such as `[rise(5mm, 90deg, cycloidal), dwell(30deg)]`"),
            ValueFact::SegmentsEnds => write!(f, "a program of segments is `periodic` or holds its ends, `hold`"),
            ValueFact::NotASegment => {
                write!(f, "a segment is `rise(height, duration, law)`, `fall(height, duration, law)` or `dwell(duration)`")
            }
            ValueFact::NotALaw => {
                write!(f, "expected the name of a law, such as `cycloidal` or a function of a number, `scca(b, c)` or `spline([…])`")
            }
            ValueFact::SegmentWithoutDuration { found, dim } => {
                write!(f, "the duration of a segment is positive, found {}", remedy::quantity(*found, *dim))
            }
            ValueFact::SegmentsMissTurn { found } => {
                let side = if *found > TAU { "more" } else { "less" };
                let [sum, off] = [*found, (found - TAU).abs()].map(|angle| about(angle, Dim::ANGLE));
                write!(f, "a periodic program fills one turn, and these segments fill {sum}, {off} {side}")?;
                // With more decimals it may be a quotient such as 360°/7.
                let lacks = (TAU - found).to_degrees();
                let rounded = sixth_decimal(lacks);
                if rounded > 0.0 && (rounded - lacks).abs() < 1e-9 { write!(f, "\nhelp: add `dwell({rounded}deg)`") } else { Ok(()) }
            }
            ValueFact::SegmentsDoNotReturn { off, dim } => {
                let side = if *off > 0.0 { "above" } else { "below" };
                let off = about(off.abs(), *dim);
                write!(f, "a periodic program ends at the height at which it begins, this one {off} {side} it")
            }
            ValueFact::SegmentsJolt { at, velocities, laws, along, dim } => {
                let at = about(*at, *along);
                let [ends, begins] = velocities.map(|velocity| slope(velocity, *dim, *along));
                let [one, two] = laws.each_ref().map(|law| law.as_ref().map_or("the rest".to_owned(), |law| format!("`{law}`")));
                write!(f, "the velocity jumps at {at}: {one} ends with {ends} and {two} begins with {begins}")?;
                write!(f, "\nhelp: `half_cycloidal_start` goes from rest to a constant velocity, `half_cycloidal_end` back to rest")
            }
            ValueFact::LawFromTo { name, from, to } => {
                let [from, to] = [*from, *to].map(|value| significant(sixth_decimal(value)));
                write!(f, "the law of a segment goes from 0 to 1 while its argument does, and `{name}` goes from {from} to {to}")
            }
            ValueFact::NotConstant { place, help } => {
                write!(f, "{place} is a constant: numbers, units, `pi` and functions of them")?;
                if help.is_empty() { Ok(()) } else { write!(f, "\nhelp: {help}") }
            }
            ValueFact::EmptyBounds { bounds, is_point } => {
                write!(f, "no value lies in {bounds}\nhelp: ")?;
                if *is_point {
                    write!(f, "write `..=` where the greatest value is allowed")
                } else {
                    write!(f, "the lesser value stands first")
                }
            }
            ValueFact::RangeWithoutEnd => write!(f, "a range of time has two ends\nhelp: write `range t in 0s..1s;`"),
            ValueFact::DefaultOutOfBounds { value, bounds } => {
                write!(f, "the default, {value}, does not lie in {bounds}\nhelp: widen the range, or take a default within")
            }
            ValueFact::NotFixed { place } => {
                write!(f, "{place} may depend on parameters only, not on what moves")?;
                if place.contains("start") {
                    return write!(f, "\nhelp: write where it is about");
                }
                write!(f, "\nhelp: ")?;
                if *place == "a point or an axis" {
                    write!(f, "a point is written in the frame of its body, and joints bring points of two bodies together; ")?;
                }
                write!(f, "what moves along a body is a body of its own")
            }
            ValueFact::AnglesForOrientation { instead } => {
                write!(f, "an orientation is a product of turns, found three angles\nhelp: write `{instead}`")?;
                write!(f, ", where each turn is about an axis that the turns before it have turned")
            }
            ValueFact::NotAStart { written, body, ambient } => not_a_start(f, written, body.as_deref(), *ambient),
            ValueFact::FunctionNeedsArgument => {
                write!(
                    f,
                    "a function written here names its argument\nhelp: write `function name(x: Angle) -> Length = …;`, or give the path of a Rust function"
                )
            }
            ValueFact::RateOfVelocity => {
                write!(f, "the rate of a velocity is an acceleration, and equations, forces and outputs contain none")?;
                write!(f, "\nhelp: give the body a mass where its inertia is meant; an output has its rate and its acceleration beside it")
            }
            ValueFact::OutputWithoutRate => {
                write!(f, "the rate of this output is a third derivative of an input, a table or a Rust function, which have two")?;
                write!(f, "\nhelp: take one `rate` away: an output is given with its rate")
            }
            ValueFact::EnergyOfVelocities => {
                write!(f, "a potential energy is a function of positions, and this one contains velocities")?;
                write!(f, "\nhelp: write a `force` for what depends on velocities: a damper, drag")
            }
            ValueFact::NegativeMass { what, body, value, dim } => {
                write!(f, "the {what} of `{body}` is {}, and cannot be negative\nhelp: write a positive number", quantity(*value, *dim))
            }
            ValueFact::ImpossibleInertia { body, by_products } => {
                write!(f, "no body has the inertia of `{body}`: about perpendicular axes, none is greater than the sum of the two others")?;
                if *by_products {
                    write!(f, "\nnote: its moments about the axes of the body would do, but not its principal moments")?;
                }
                write!(f, "\nhelp: write I_xx, I_yy, I_zz about the centre of mass, and if they are not zero I_xy, I_xz, I_yz after them")
            }
            ValueFact::ShapeWithoutMass { name } => {
                write!(f, "the inertia of `{name}(…)` needs the mass of the body\nhelp: write `mass = 1kg;` in the same body")
            }
            ValueFact::CenterWithoutMass { body } => {
                write!(f, "`{body}` has a centre of mass but no mass\nhelp: write `mass = 1kg;`, or take `center` away")
            }
            ValueFact::ZeroAxis { name, in_space: true } => {
                write!(f, "the axis `{name}` has no direction: all components are zero\nhelp: write `(1, 0, 0)` for the direction of x")
            }
            ValueFact::ZeroAxis { name, in_space: false } => {
                write!(f, "the axis `{name}` has no direction: both components are zero\nhelp: write `(1, 0)` for the direction of x")
            }
        }
    }
}

/// Rounds to six decimals.
fn sixth_decimal(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// A sum in the units of a drawing, without its rounding errors.
fn about(value: f64, dim: Dim) -> String {
    match dim {
        Dim::ANGLE => format!("{}°", sixth_decimal(value.to_degrees())),
        Dim::LENGTH => format!("{} mm", sixth_decimal(value * 1e3)),
        _ => remedy::quantity(sixth_decimal(value), dim),
    }
}

/// A velocity by angle in units of a drawing, `0.2 mm per degree`; others in SI.
fn slope(value: f64, dim: Dim, along: Dim) -> String {
    let rounded = |value: f64| if value.abs() < 1e-12 { 0.0 } else { format!("{value:.3e}").parse().unwrap_or(value) };
    match along {
        Dim::ANGLE => format!("{} per degree", remedy::quantity(rounded(value.to_radians()), dim)),
        Dim::TIME => format!("{} per second", remedy::quantity(rounded(value), dim)),
        _ => remedy::quantity(rounded(value), dim.per(along)),
    }
}

/// The line before one about the word that is meant, if another was typed.
fn mistyped(f: &mut Formatter, typed: Option<&Typed>) -> Result {
    let Some(Typed { sort, name }) = typed else { return Ok(()) };
    write!(f, "no {sort} is called `{name}`\nhelp: ")
}

fn not_a_start(f: &mut Formatter, written: &str, body: Option<&str>, ambient: Ambient) -> Result {
    if written.rsplit('.').next().is_some_and(is_velocity) {
        write!(f, "a velocity at the start is that of a freedom")?;
        let owner = if ambient == Ambient::Space { "hinge" } else { body.unwrap_or("body") };
        return write!(f, "\nhelp: write `freedom name = {owner}.angle from 0deg at 5rad_s;`");
    }
    let what = written.rsplit('.').next().filter(|word| ambient.start_words().any(|known| known == *word));
    let owner = body.unwrap_or("b");
    let joint = if written.chars().all(|letter| letter.is_alphanumeric() || letter == '_') { written } else { "joint" };
    match (ambient, what) {
        (Ambient::Plane, _) => {
            write!(
                f,
                "a start in the plane is that of a body\nhelp: write `start {} = …;` in `body {owner} {{ … }}`",
                what.unwrap_or("angle")
            )?;
            let is_name = what.is_none() && joint == written;
            if is_name { write!(f, "; a freedom starts `from` a value, `freedom {written} = crank.angle from 30deg;`") } else { Ok(()) }
        }
        (Ambient::Space, Some(what)) if body.is_some() || what == written => {
            write!(f, "a start outside bodies is that of a joint\nhelp: write `start {what} = …;` in `body {owner} {{ … }}`")
        }
        (Ambient::Space, _) if ["angle", "displacement"].contains(&written) => {
            write!(f, "`{written}` lacks its joint\nhelp: write `start joint.{written} = …;`")
        }
        (Ambient::Space, _) => {
            write!(f, "`{written}` is no angle and no displacement of a joint\nhelp: write `start {joint}.angle = 30deg;`")?;
            write!(f, "; where a body starts is told in the body, as in `start position = …;`")
        }
    }
}
