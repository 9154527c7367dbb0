//! Constraints of the reference files as declarations.

use reuleaux_tests::common::reference::{Value, list, number, text};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Points and axes of bodies, and joints, as they are gathered from constraints.
#[derive(Default)]
pub(crate) struct Declaration {
    /// The marks of each body, by its name.
    marks: BTreeMap<String, Vec<String>>,
    joints: Vec<String>,
}

impl Declaration {
    /// Adds a constraint or a driver.
    pub(crate) fn add(&mut self, constraint: &Value, prefix: &str) {
        let kind = text(&constraint["type"]);
        let name = format!("j{}", self.joints.len());
        let mut at = |mark: &str, of: &str, value: &str, zero: Option<&str>| {
            let body = text(&constraint[of]).to_owned();
            let marks = self.marks.entry(body.clone()).or_default();
            let mark_name = format!("{mark}{}", marks.len());
            let zero = zero.filter(|zero| !constraint[*zero].is_null()).map(|zero| format!(" from {}", vector(&constraint[zero], "")));
            let line = match mark {
                "P" => format!("point {mark_name} = {};", vector(&constraint[value], "m")),
                _ => format!("axis {mark_name} = {}{};", vector(&constraint[value], ""), zero.unwrap_or_default()),
            };
            marks.push(line);
            format!("{body}.{mark_name}")
        };
        let given = |of: &str| plain(number(&constraint[of]));
        let law = |unit: &str| format!("({}) * 1{unit}", law(&constraint["f"]));
        let equations = match kind {
            "dot1" => {
                let (u, v) = (at("u", "body_i", "vector_i", None), at("v", "body_j", "vector_j", None));
                format!("{{ dot({u}, {v}) == {}; }}", given("value"))
            }
            "dot2" => {
                let u = at("u", "body_i", "vector_i", None);
                let (p, q) = (at("P", "body_i", "point_i", None), at("P", "body_j", "point_j", None));
                format!("{{ dot({u}, {q} - {p}) == {} * 1m; }}", given("value"))
            }
            "spherical" => format!("spherical({}, {})", at("P", "body_i", "point_i", None), at("P", "body_j", "point_j", None)),
            "distance" => format!(
                "distance({}, {}, {} * 1m)",
                at("P", "body_i", "point_i", None),
                at("P", "body_j", "point_j", None),
                given("distance")
            ),
            "point_on_plane" => {
                let (p, a) = (at("P", "body_i", "point_i", None), at("a", "body_i", "axis_i", None));
                format!("point_on_plane({p}, {a}, {}, {} * 1m)", at("P", "body_j", "point_j", None), given("offset"))
            }
            "point_on_line" => {
                let (p, a) = (at("P", "body_i", "point_i", None), at("a", "body_i", "axis_i", Some("x_i")));
                format!("point_on_line({p}, {a}, {})", at("P", "body_j", "point_j", None))
            }
            "parallel_axes" | "orientation" => {
                let kind = if kind == "orientation" { "absolute_orientation" } else { kind };
                format!("{kind}({}, {})", at("a", "body_i", "axis_i", Some("x_i")), at("a", "body_j", "axis_j", Some("x_j")))
            }
            "revolute" | "cylindrical" | "translational" | "universal" | "screw" | "planar" | "weld" => {
                let (p, a) = (at("P", "body_i", "point_i", None), at("a", "body_i", "axis_i", Some("x_i")));
                let (q, b) = (at("P", "body_j", "point_j", None), at("a", "body_j", "axis_j", Some("x_j")));
                let more = match kind {
                    "screw" => format!(", {} * 1m, {} * 1m", given("lead"), given("offset")),
                    "planar" => format!(", {} * 1m", given("offset")),
                    _ => String::new(),
                };
                format!("{kind}({p}, {a}, {q}, {b}{more})")
            }
            "absolute_x" | "absolute_y" | "absolute_z" => {
                format!("{kind}({}, {} * 1m)", at("P", "body_i", "point_i", None), given("value"))
            }
            "driver_absolute_x" | "driver_absolute_y" | "driver_absolute_z" => {
                format!("drive_{}({}, {})", &kind[16..], at("P", "body_i", "point_i", None), law("m"))
            }
            "driver_distance" => {
                format!("drive_distance({}, {}, {})", at("P", "body_i", "point_i", None), at("P", "body_j", "point_j", None), law("m"))
            }
            "driver_translation" => {
                let (a, p) = (at("a", "body_i", "axis_i", None), at("P", "body_i", "point_i", None));
                format!("drive_translation(along({a}, {} - {p}), {})", at("P", "body_j", "point_j", None), law("m"))
            }
            "driver_rotation" => {
                let (a, b) = (at("a", "body_i", "axis_i", Some("x_i")), at("a", "body_j", "axis_j", Some("x_j")));
                format!("drive_rotation(joint_angle({a}, {b}), {})", law("rad"))
            }
            "gear_pair" => {
                let (ki, i) = (at("a", "body_k", "axis_ki", Some("x_ki")), at("a", "body_i", "axis_i", Some("x_i")));
                let (kj, j) = (at("a", "body_k", "axis_kj", Some("x_kj")), at("a", "body_j", "axis_j", Some("x_j")));
                format!(
                    "gear_pair(joint_angle({ki}, {i}), joint_angle({kj}, {j}), {}, {}, {} * 1rad)",
                    given("a"),
                    given("b"),
                    given("value")
                )
            }
            "rack_pinion" => {
                let (k, i) = (at("a", "body_k", "axis_k", Some("x_k")), at("a", "body_i", "axis_i", Some("x_i")));
                let (p, u) = (at("P", "body_k", "point_k", None), at("a", "body_k", "direction", None));
                let q = at("P", "body_j", "point_j", None);
                format!("rack_pinion(joint_angle({k}, {i}), {p}, {u}, {q}, {} * 1m, {} * 1m)", given("radius"), given("offset"))
            }
            "rolling_disk" => {
                let (a, q) = (at("a", "body_i", "axis_i", Some("x_i")), at("P", "body_j", "point_j", None));
                format!("rolling_disk({a}, {q}, {}, {} * 1m)", at("a", "body_j", "axis_j", None), given("radius"))
            }
            "rolling_ball" => {
                let a = at("a", "body_i", "axis_i", Some("x_i"));
                format!("rolling_ball({a}, {}, {} * 1m)", at("P", "body_j", "point_j", None), given("radius"))
            }
            "knife_edge" => {
                let q = at("P", "body_j", "point_j", None);
                format!("knife_edge({}, {q}, {})", text(&constraint["body_i"]), at("a", "body_j", "axis_j", None))
            }
            "mpc" => self.multi_point(constraint),
            kind => self.gear_type(kind, constraint),
        };
        let word = if kind.starts_with("driver") || kind == "mpc" { "drive" } else { "joint" };
        let end = if equations.ends_with('}') { "" } else { ";" };
        self.joints.push(format!("{prefix}{word} {name} = {equations}{end}"));
    }

    /// An axis fixed in a body.
    fn axis(&mut self, body: &str, axis: &Value, zero: &Value) -> String {
        let marks = self.marks.entry(body.to_owned()).or_default();
        let name = format!("a{}", marks.len());
        marks.push(format!("axis {name} = {} from {};", vector(axis, ""), vector(zero, "")));
        format!("{body}.{name}")
    }

    /// A gear type joint of multi-point constraints.
    fn gear_type(&mut self, kind: &str, constraint: &Value) -> String {
        let nodes: Vec<&str> = list(&constraint["nodes"]).iter().map(text).collect();
        let axes: Vec<String> = (1..nodes.len())
            .map(|node| self.axis(nodes[0], &constraint[format!("axis_{node}")], &constraint[format!("x_{node}")]))
            .collect();
        let (word, unit) = match kind {
            "rotational_gear" => ("gear_joint", ""),
            "rack_pinion_published" => ("rack_and_pinion_joint", " * 1m / 1rad"),
            "rack_pinion_guided" => ("guided_rack_and_pinion_joint", " * 1m / 1rad"),
            "differential_published" => ("differential_joint", ""),
            "differential_bearings" => ("differential_joint_on_bearings", ""),
            other => panic!("unknown constraint {other}"),
        };
        format!("{word}({}, {}, {}{unit})", nodes.join(", "), axes.join(", "), plain(number(&constraint["alpha"])))
    }

    /// Σ c (velocity of a node along or about an axis) = f(t)
    fn multi_point(&mut self, constraint: &Value) -> String {
        let term = |this: &mut Self, term: &Value| {
            let skew = &term["skew"];
            let axis = this.axis(text(&skew["body"]), &skew["axis"], &skew["x"]);
            let (dof, node) = (number(&term["dof"]) as usize - 1, text(&term["node"]));
            let direction = format!("{}({axis})", ["x_axis", "y_axis", "z_axis"][dof % 3]);
            let speed = if dof < 3 { format!("rate({node}.position) / 1m") } else { format!("{node}.angular_velocity / 1rad") };
            format!("{} * dot({direction}, {speed})", plain(number(&term["coeff"])))
        };
        let terms: Vec<String> = list(&constraint["terms"]).iter().map(|found| term(self, found)).collect();
        format!("{{ {} == ({}) / 1s; }}", terms.join(" + "), law(&constraint["f"]))
    }

    /// The declaration; `bodies` in order, each with the statements of its start.
    pub(crate) fn text(&self, head: &str, bodies: &[(String, String)]) -> String {
        let mut text = format!("{head} {{\n");
        let none = Vec::new();
        let marks = |body: &str| self.marks.get(body).unwrap_or(&none).join(" ");
        let _ = writeln!(text, "    ground {{ {} }}", marks("ground"));
        for (body, start) in bodies {
            let _ = writeln!(text, "    body {body} {{ {} {start} }}", marks(body));
        }
        for joint in &self.joints {
            let _ = writeln!(text, "    {joint}");
        }
        text + "}"
    }
}

/// `(1.0m, 0.0m, 0.0m)`
pub(crate) fn vector(value: &Value, unit: &str) -> String {
    let parts: Vec<String> = list(value)
        .iter()
        .map(|part| if unit.is_empty() { plain(number(part)) } else { format!("{} * 1{unit}", plain(number(part))) })
        .collect();
    format!("({})", parts.join(", "))
}

/// A number as the language writes it.
fn plain(value: f64) -> String {
    let text = format!("{:?}", value.abs());
    let text = match text.split_once('e') {
        Some((mantissa, exponent)) => format!("({mantissa} * 10^({exponent}))"),
        None => text,
    };
    if value < 0.0 { format!("(-{text})") } else { text }
}

/// A law of time as a number.
fn law(law: &Value) -> String {
    match text(&law["law"]) {
        "polynomial" => {
            let term = |(power, coefficient): (usize, &Value)| match power {
                0 => plain(number(coefficient)),
                _ => format!("{} * (t / 1s)^{power}", plain(number(coefficient))),
            };
            list(&law["coeffs"]).iter().enumerate().map(term).collect::<Vec<_>>().join(" + ")
        }
        "harmonic" => {
            let [offset, amplitude, omega, phase] = ["offset", "amplitude", "omega", "phase"].map(|name| plain(number(&law[name])));
            format!("{offset} + {amplitude} * sin(({omega} * (t / 1s) + {phase}) * 1rad)")
        }
        "sum" => list(&law["terms"]).iter().map(self::law).collect::<Vec<_>>().join(" + "),
        other => panic!("unknown law {other}"),
    }
}
