//! From a model in a reference file to a declaration in the language, with all numbers as literals.
//!
//! A literal is an exact decimal and the file's number is the nearest double: they differ by less than rounding.

use std::fmt::Write;

use super::reference::{Value, list, number, text};

/// The declaration of a model: `bodies`, `constraints`, `drivers`, and, if present, `ground_points` and `initial_guess`.
///
/// # Panics
/// If the model has a constraint of an unknown type.
#[must_use]
pub fn declaration(model: &Value, name: &str, attribute: &str) -> String {
    let mut marks: Vec<(String, String)> = Vec::new();
    let mut joints = String::new();
    for (kind, key) in [("joint", "constraints"), ("drive", "drivers")] {
        for (index, constraint) in model[key].as_array().into_iter().flatten().enumerate() {
            let text = joint(constraint, &format!("{kind}{index}"), &mut marks);
            let _ = writeln!(joints, "    {kind} {kind}{index} = {text}");
        }
    }
    let mut body = frame("ground", &model["ground_points"], &marks, "");
    for (index, declared) in list(&model["bodies"]).iter().enumerate() {
        let guess = |offset: usize| number(&model["initial_guess"]["q"][3 * index + offset]);
        let has_guess = !model["initial_guess"]["q"].is_null();
        let start = || format!("start position = ({}, {}); start angle = {};", literal(guess(0)), literal(guess(1)), literal(guess(2)));
        let start = if has_guess { start() } else { String::new() };
        body += &frame(&format!("body {}", text(&declared["name"])), &declared["points"], &marks, &start);
    }
    format!("{attribute} pub mechanism {name} {{\n{body}{joints}}}")
}

/// The constraint of a unit case as a model of its own.
#[must_use]
pub fn unit(case: &Value) -> Value {
    let bodies = case["bodies"].clone();
    let key = if text(&case["constraint"]["type"]).starts_with("driver") { "drivers" } else { "constraints" };
    serde_json::json!({ "bodies": bodies, key: [case["constraint"].clone()] })
}

/// A body or ground, with its points and axes.
fn frame(head: &str, points: &Value, marks: &[(String, String)], start: &str) -> String {
    let owner = head.trim_start_matches("body ");
    let declared = points.as_object().into_iter().flatten().map(|(name, place)| format!("point {name} = {};", pair(place)));
    let needed = marks.iter().filter(|mark| mark.0 == owner).map(|mark| mark.1.clone());
    format!("    {head} {{ {} {start} }}\n", declared.chain(needed).collect::<Vec<_>>().join(" "))
}

/// A double as written in the file.
fn literal(value: f64) -> String {
    format!("{value:?}")
}

fn pair(place: &Value) -> String {
    format!("({}, {})", literal(number(&place[0])), literal(number(&place[1])))
}

/// The right-hand side of `joint name =`; points and axes of the constraint are added to `marks`.
fn joint(constraint: &Value, name: &str, marks: &mut Vec<(String, String)>) -> String {
    let value = |key: &str| literal(number(&constraint[key]));
    let body = |side: &str| text(&constraint[format!("body_{side}")]).to_owned();
    let law = |unit: &str| format!("1{unit} * ({})", law(&constraint["f"]));
    let mut mark = |kind: &str, side: &str| {
        let place = &constraint[format!("{kind}_{side}")];
        if let Some(known) = place.as_str() {
            return known.to_owned();
        }
        let mark = format!("{name}_{kind}_{side}");
        let word = if kind == "axis" { "axis" } else { "point" };
        marks.push((body(side), format!("{word} {mark} = {};", pair(place))));
        format!("{}.{mark}", body(side))
    };
    match text(&constraint["type"]) {
        "absolute_x" => format!("absolute_x({}, {});", mark("point", "i"), value("value")),
        "absolute_y" => format!("absolute_y({}, {});", mark("point", "i"), value("value")),
        "absolute_angle" => format!("absolute_angle({}, {});", body("i"), value("value")),
        "absolute_distance" => {
            format!("absolute_distance({}, {}, {});", mark("point", "i"), pair(&constraint["center"]), value("distance"))
        }
        "driver_absolute_x" => format!("drive_x({}, {});", mark("point", "i"), law("m")),
        "driver_absolute_y" => format!("drive_y({}, {});", mark("point", "i"), law("m")),
        "driver_absolute_angle" => format!("drive_angle({}, {});", body("i"), law("rad")),
        "driver_relative_angle" => format!("drive_relative_angle({}, {}, {});", body("i"), body("j"), law("rad")),
        "driver_relative_distance" => format!("drive_distance({}, {}, {});", mark("point", "i"), mark("point", "j"), law("m")),
        "revolute" => format!("revolute({}, {});", mark("point", "i"), mark("point", "j")),
        "revolute_revolute" => format!("distance({}, {}, {});", mark("point", "i"), mark("point", "j"), value("distance")),
        "weld" => format!("weld({}, {}, {});", mark("point", "i"), mark("point", "j"), value("angle")),
        "revolute_translational" => {
            format!("revolute_translational({}, {}, {}, {});", mark("point", "i"), mark("axis", "i"), mark("point", "j"), value("distance"))
        }
        "translational" => {
            let (p, u, q, v) = (mark("point", "i"), mark("axis", "i"), mark("point", "j"), mark("axis", "j"));
            format!("{{ dot(perp({u}), {q} - {p}) == 0; dot(perp({u}), {v}) == 0; }}")
        }
        "point_on_line" => {
            let (p, u, q) = (mark("point", "i"), mark("axis", "i"), mark("point", "j"));
            format!("{{ dot(perp({u}), {q} - {p}) == 0; }}")
        }
        "gear_pair" => {
            let sign = if text(&constraint["mesh"]) == "external" { "" } else { "-" };
            let (r, s, a, b) = (value("radius_i"), sign.to_owned() + &value("radius_j"), value("angle_i0"), value("angle_j0"));
            format!("gear_pair({}, {}, {r}, {s}, c: {r} * ({a}) + {s} * ({b}));", body("i"), body("j"))
        }
        "gear_pair_centers" => {
            let (p, q, i, j) = (mark("point", "i"), mark("point", "j"), body("i"), body("j"));
            let (r, s, a, b) = (value("radius_i"), value("radius_j"), value("angle_i0"), value("angle_j0"));
            let along = format!("let th = ({r} * ({i}.angle + {a}) + {s} * ({j}.angle + {b}) - {s} * pi) / ({r} + {s});");
            format!("{{ {along} let h = {q} - {p}; h.x * sin(th) == h.y * cos(th); }}")
        }
        "rack_pinion" => {
            let (p, u, q) = (mark("point", "i"), mark("axis", "i"), mark("point", "j"));
            format!("rack_pinion({}, {q}, {u}, {p}, {}, {});", body("j"), value("radius"), value("offset"))
        }
        "angle_relation" => {
            let bodies = list(&constraint["bodies"]).iter().zip(list(&constraint["coeffs"]));
            let terms: Vec<String> = bodies.map(|(body, factor)| format!("{} * {}.angle", literal(number(factor)), text(body))).collect();
            format!("{{ {} == {}; }}", terms.join(" + "), value("value"))
        }
        other => panic!("no declaration for constraints of type `{other}`"),
    }
}

/// A law of time, as a number of seconds.
fn law(law: &Value) -> String {
    match text(&law["law"]) {
        "polynomial" => {
            let term = |(power, factor): (usize, &Value)| match power {
                0 => literal(number(factor)),
                1 => format!("{} * (t / 1s)", literal(number(factor))),
                _ => format!("{} * (t / 1s)^{power}", literal(number(factor))),
            };
            list(&law["coeffs"]).iter().enumerate().map(term).collect::<Vec<_>>().join(" + ")
        }
        "harmonic" => {
            let value = |key: &str| literal(number(&law[key]));
            format!("{} + {} * sin({} * (t / 1s) + {})", value("offset"), value("amplitude"), value("omega"), value("phase"))
        }
        "sum" => list(&law["terms"]).iter().map(self::law).collect::<Vec<_>>().join(" + "),
        other => panic!("no law `{other}`"),
    }
}
