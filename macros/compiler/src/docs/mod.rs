//! Documentation of generated items: pages, tables, lines.
//!
//! In: all that is known of a mechanism. Out: text, and tokens of doc attributes. Not done here: which items there are.

mod abridged;

use crate::assembly::Assembly;
use crate::diag::significant;
use crate::expr::{Evaluator, Leaf, Values, show};
use crate::model::{Function, Method, Model, Output, Parameter};
use crate::picture::Picture;
use crate::plan::{Code, Cost, Elimination, Plan, Solution, Summary};
use crate::quantity::Dim;
use crate::syntax::ast::Closing;
use crate::system::{COSINES, Equation, System};
use crate::travel::Motion;
use abridged::{Abridged, list};
use proc_macro2::TokenStream;
use quote::quote;
use std::array::from_fn;
use std::fmt::Write;

/// One line of documentation.
pub(crate) fn line(line: &str) -> TokenStream {
    let line = format!(" {line}");
    quote!(#[doc = #line])
}

/// Documentation line by line.
pub(crate) fn lines(page: &str) -> TokenStream {
    page.lines().map(|line| if line.is_empty() { quote!(#[doc = ""]) } else { self::line(line) }).collect()
}

/// Numbers of equations that hold at all times, and of those of drives.
fn counted(model: &Model, equations: &[Equation]) -> [usize; 2] {
    let own = || equations.iter().filter(|equation| !equation.is_initial);
    [own().count(), own().filter(|equation| model.joints[equation.joint].is_drive).count()]
}

/// Coordinates, equations and mobility.
fn counts(page: &mut String, model: &Model, system: &System, checked: usize) {
    let n = system.coordinates.len();
    let redundant = match checked {
        0 => String::new(),
        1 => ", 1 follows from others and is checked".to_owned(),
        many => format!(", {many} follow from others and are checked"),
    };
    let ([m, driven], [k, driven_speeds]) = (counted(model, &system.equations), counted(model, &system.of_speeds));
    let positions = (n + driven + checked) as i64 - m as i64;
    let _ = match k {
        0 => writeln!(
            page,
            "\n{n} coordinates, {m} equations, {driven} of them drives{redundant}: mobility {positions} without drives, as counted."
        ),
        _ => {
            let (drives, speeds) = (driven + driven_speeds, positions + driven_speeds as i64 - k as i64);
            writeln!(
                page,
                "\n{n} coordinates, {m} equations of positions and {k} of velocities, {drives} of them drives{redundant}: position freedoms \
                 {positions}, velocity freedoms {speeds} without drives, as counted."
            )
        }
    };
}

/// The page of the generated struct: the picture, and tables of parameters, coordinates and equations.
pub(crate) fn mechanism(model: &Model, system: &System, assembly: &Assembly, motion: &Motion, plan: &Plan, picture: &Picture) -> String {
    let mut page = String::new();
    counts(&mut page, model, system, plan.checked.len());
    if let Some(dynamics) = &plan.dynamics {
        let freedoms: Vec<String> =
            model.joints.iter().filter(|joint| joint.freedom.is_some()).map(|joint| format!("`{}`", joint.name)).collect();
        let [integrated, rows] = [dynamics.integrated.len(), dynamics.rows];
        let freedoms = match freedoms.as_slice() {
            [] => "Drives determine the motion".to_owned(),
            freedoms => format!("Freedoms, which follow from forces: {}", freedoms.join(", ")),
        };
        let _ = writeln!(
            page,
            "\n{freedoms}. {integrated} coordinates are integrated, with {rows} equations between them and their rates; everything else \
             follows explicitly.",
        );
    }
    page.push_str(&assembled(model, assembly));
    page.push_str(&followed(motion));
    // HTML in a page of Markdown stands between blank lines.
    let _ = writeln!(page, "\n{}\n{}", picture.svg().unwrap_or_default(), picture.words());
    parameters(&mut page, model, system);
    let _ = writeln!(page, "\n# Coordinates\n\n| | body | coordinate | unit |\n| --- | --- | --- | --- |");
    let mut table = Abridged::new(model);
    for (index, unknown) in system.coordinates.iter().enumerate() {
        if !table.shows([&model.bodies[unknown.body].name].into_iter()) {
            continue;
        }
        let _ = writeln!(
            page,
            "| `q[{index}]` | `{}` | {} | {} |",
            system.owner_and_name(model, index).0,
            system.owner_and_name(model, index).1,
            unknown.role.dim().unit()
        );
    }
    table.rest(&mut page, |more| format!("| | {more} | | |"));
    equations(&mut page, model, system);
    let _ = writeln!(
        page,
        "\n# Operations\n\n| | sums and products | divisions and roots | sine-cosine pairs | other functions |\n| --- | --- | --- | --- | --- |"
    );
    for (name, routine) in [("Φ", &plan.phi), ("Φ_q", &plan.jacobian), ("Φ and Φ_q", &plan.linearize), ("ν", &plan.nu), ("γ", &plan.gamma)]
    {
        let cost = routine.cost();
        let _ = writeln!(page, "| {name} | {} | {} | {} | {} |", cost.flops, cost.divisions, cost.sines, cost.calls);
    }
    if let Some(solution) = &plan.solution {
        self::solution(&mut page, model, system, solution);
    }
    page
}

/// Mistakes that the mechanism accepts by its attributes.
fn assembled(model: &Model, assembly: &Assembly) -> String {
    let doubts = assembly.warnings.iter().map(|warning| warning.doubt.to_string());
    let far: String = doubts.map(|doubt| format!("\nNote: {}.\n", doubt.lines().next().unwrap_or_default())).collect();
    let assembled = match (&assembly.remark, model.closing) {
        (Some(remark), _) => {
            let fact = remark.lines().next().unwrap_or_default();
            format!("\nAt the declared defaults and t = 0, as `#[closure(allow)]` accepts: {fact}.\n")
        }
        (None, Closing::Off) => "\n`start` is as declared: with `#[closure(off)]` no assembly is looked for.\n".to_owned(),
        (None, _) => String::new(),
    };
    assembled + &far
}

/// Findings along the motion from the start.
fn followed(found: &Motion) -> String {
    let [from, to] = found.reached;
    let mut lines = String::new();
    if from < to {
        let [from, to] = found.reached.map(significant);
        let _ = writeln!(lines, "\nFollowed from t = {from} s to {to} s at the declared defaults, the motion goes on throughout.");
    }
    for remark in &found.remarks {
        let _ = writeln!(lines, "\nWhere the motion was followed: {}.", remark.lines().next().unwrap_or_default());
    }
    lines
}

/// Order of the solution.
fn solution(page: &mut String, model: &Model, system: &System, solution: &Solution) {
    let blocks: Vec<&Vec<usize>> = solution
        .stages
        .iter()
        .filter_map(|stage| if let Summary::Block { unknowns, .. } = stage { Some(unknowns) } else { None })
        .collect();
    let iterated: usize = blocks.iter().map(|unknowns| unknowns.len()).sum();
    let (explicit, blocks) = (system.coordinates.len().saturating_sub(iterated), blocks.len());
    let _ = writeln!(page, "\n# Solution\n\n{explicit} coordinates are computed, {iterated} are iterated in {blocks} blocks.\n\n```text");
    let name = |unknown: &usize| coordinate_name(model, system, *unknown);
    let mut table = Abridged::new(model);
    let body = |unknown: &usize| &model.bodies[system.coordinates[*unknown].body].name;
    for stage in solution.stages.iter().filter(|stage| !is_orientation(system, stage)) {
        let is_shown = match stage {
            Summary::Explicit { unknown, .. } => table.shows([body(unknown)].into_iter()),
            Summary::Block { unknowns, .. } => table.shows(unknowns.iter().map(body)),
            Summary::Check(equation) => table.shows([&model.joints[system.equations[*equation].joint].name].into_iter()),
        };
        if !is_shown {
            continue;
        }
        let _ = match stage {
            Summary::Explicit { unknown, .. } => writeln!(page, "compute  {}", name(unknown)),
            Summary::Check(equation) => writeln!(page, "check    {}", equation_name(model, system, *equation)),
            Summary::Block { unknowns, equations, cost, elimination, .. } => {
                let unknowns: Vec<String> = unknowns.iter().map(name).collect();
                let rows: Vec<String> = equations.iter().map(|equation| equation_name(model, system, *equation)).collect();
                let Cost { flops, divisions, sines, calls } = *cost;
                writeln!(page, "iterate  {}  from  {}", list(&unknowns), list(&rows)).and_then(|()| {
                    writeln!(page, "         each time {flops} sums and products, {divisions} divisions and roots, {sines} sine-cosine pairs, {calls} other functions")
                })
                .and_then(|()| elimination.as_ref().map_or(Ok(()), |elimination| eliminated(page, elimination)))
            }
        };
    }
    table.rest(page, str::to_owned);
    let _ = writeln!(page, "```");
}

/// In space: computes an entry of a body's rotation matrix, which follows from the coordinates.
pub(crate) fn is_orientation(system: &System, stage: &Summary) -> bool {
    matches!(stage, Summary::Explicit { unknown, .. } if (system.coordinates.len()..system.width()).contains(unknown))
}

/// Treatment of the Jacobian of a large block.
fn eliminated(page: &mut String, elimination: &Elimination) -> std::fmt::Result {
    let (entries, factors) = (elimination.pattern.len(), elimination.factors.len());
    let Cost { flops, divisions, .. } = elimination.cost;
    writeln!(
        page,
        "         its Jacobian of {entries} entries is eliminated to {factors} by {flops} sums and products, {divisions} divisions"
    )
}

/// `crank.angle`
pub(crate) fn coordinate_name(model: &Model, system: &System, unknown: usize) -> String {
    match system.coordinates.get(unknown) {
        Some(_) => system.name(model, unknown),
        None if unknown < system.width() => {
            let body = &model.bodies[(unknown - system.coordinates.len()) / COSINES];
            format!("{}.orientation", body.name)
        }
        // The output of a slice comes after all unknowns.
        None => format!("component {} of the output", unknown - system.width() + 1),
    }
}

/// `b (2 of 2)`
pub(crate) fn equation_name(model: &Model, system: &System, equation: usize) -> String {
    let equation = &system.equations[equation];
    let joint = &model.joints[equation.joint];
    format!("{} ({} of {})", joint.name, equation.row + 1, joint.residuals.len())
}

fn parameters(page: &mut String, model: &Model, system: &System) {
    let all: Vec<(&Parameter, f64)> = model.parameters.iter().zip(default_values(model, system)).collect();
    let of_inputs = model.of_inputs();
    let own = all.iter().enumerate().filter(|(number, _)| !of_inputs.contains(number)).map(|(_, row)| *row).collect();
    let values: Vec<usize> = model.inputs().filter(|(_, order, _)| *order == 0).map(|(number, _, _)| number as usize).collect();
    table_of(page, model, ["Parameters", "default"], own);
    table_of(page, model, ["Inputs", "at the start"], values.into_iter().map(|number| all[number]).collect());
}

/// A table of numbers that are fields.
fn table_of(page: &mut String, model: &Model, [title, value]: [&str; 2], rows: Vec<(&Parameter, f64)>) {
    if rows.is_empty() {
        return;
    }
    let is_bounded = rows.iter().any(|(parameter, _)| parameter.bounds.is_some());
    let (head, rule) = if is_bounded { (" in |", " --- |") } else { ("", "") };
    let _ = writeln!(page, "\n# {title}\n\n| | {value} | in SI |{head}\n| --- | --- | --- |{rule}");
    let mut table = Abridged::new(model);
    for (parameter, value) in rows {
        if !table.shows([&parameter.name].into_iter()) {
            continue;
        }
        let bounds = parameter.bounds.as_ref().map_or("", |bounds| &bounds.text);
        let last = if is_bounded { format!(" {bounds} |") } else { String::new() };
        let in_si = format!("{value} {}", parameter.dim.unit());
        let _ = writeln!(page, "| `{}` | {} | {} |{last}", parameter.name.input_path(), parameter.written, in_si.trim_end());
    }
    table.rest(page, |more| format!("| {more} | | |"));
}

fn equations(page: &mut String, model: &Model, system: &System) {
    let _ = writeln!(page, "\n# Equations\n\nEach expression is zero; x, y and φ are the coordinates of the body in the index.\n\n```text");
    let name = |leaf: Leaf| match leaf {
        Leaf::Time => "t".to_owned(),
        Leaf::Datum(index) | Leaf::Turn(index) => format!("d{index}"),
        Leaf::Parameter(index) => model.parameters.get(index as usize).map_or(String::new(), |parameter| parameter.name.to_string()),
        Leaf::Input { number, order } => {
            let name = model.parameters.get(number as usize).map_or(String::new(), |parameter| parameter.name.input_path().to_owned());
            format!("{name}{}", "\u{307}".repeat(usize::from(order)))
        }
        Leaf::Coordinate(index) | Leaf::Speed(index) | Leaf::Acceleration(index) | Leaf::Jerk(index) => {
            let Some(unknown) = system.coordinates.get(index as usize) else { return String::new() };
            let symbol = unknown.role.symbol();
            format!("{symbol}_{}", model.bodies[unknown.body].name)
        }
    };
    let function = |number: u32| match model.functions.get(number as usize) {
        Some(Function::Rust(path)) => path.to_string().replace(' ', ""),
        _ => "table".to_owned(),
    };
    let mut table = Abridged::new(model);
    for equation in system.equations.iter().filter(|equation| !equation.is_initial) {
        let joint = &model.joints[equation.joint];
        let Some(phi) = equation.phi() else { continue };
        if !table.shows([&joint.name].into_iter()) {
            continue;
        }
        let unit = equation.dim.unit();
        let unit = if unit.is_empty() { String::new() } else { format!("  [{unit}]") };
        let _ = writeln!(
            page,
            "{} ({}, {} of {}):  {}{unit}",
            joint.name,
            joint.kind,
            equation.row + 1,
            joint.residuals.len(),
            show(&system.arena, phi, &name, &function)
        );
    }
    table.rest(page, str::to_owned);
    let _ = writeln!(page, "```");
}

/// The defaults of the parameters, in SI.
pub(crate) fn default_values(model: &Model, system: &System) -> Vec<f64> {
    let roots: Vec<_> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let functions = |_: u32, _: f64| [f64::NAN; 3];
    let values = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let mut defaults = vec![0.0; roots.len()];
    Evaluator::new(&system.arena, &roots).run(&values, &mut defaults);
    // A default such as 1/0 is refused by `validate` when it is used.
    defaults.into_iter().map(|value| if value.is_finite() { value } else { f64::MAX }).collect()
}

/// Description of an input.
pub(crate) fn input(parameter: &Parameter) -> String {
    let unit = parameter.dim.unit();
    let (unit, rate) = if unit.is_empty() {
        (String::new(), "per s".to_owned())
    } else {
        (format!("in {unit}, "), format!("in {}", parameter.dim.per(Dim::TIME).unit()))
    };
    let bounds = parameter.bounds.as_ref().map_or(String::new(), |bounds| format!(", within {}", bounds.text));
    format!("`{}` {unit}with its rate {rate} and its acceleration{bounds}.", parameter.name.input_path())
}

/// One line for a field.
pub(crate) fn parameter(parameter: &Parameter) -> String {
    let mut line = unit_line("A parameter of the mechanism", parameter.dim.unit());
    if let Some(bounds) = &parameter.bounds {
        let _ = write!(line, " It lies in {}.", bounds.text);
    }
    line
}

/// One line for an output.
pub(crate) fn output(method: &Method, first: &Output) -> String {
    if first.body.is_some() {
        return format!("The output `{}`: place of its frame's origin (m) and angle (rad), with their rates.", method.name);
    }
    let with = match first.derivatives {
        1 => "first derivative",
        2 => "first and second derivative",
        _ => "first, second and third derivative",
    };
    unit_line(&format!("The output `{}` with its {with} in time", method.name), first.dim.unit())
}

/// The unit of what there is not: `OutputName::NO_UNIT` of the runtime.
const NO_UNIT: &str = "\u{2013}";

/// The components of an output by name, each with the units of value, rate, acceleration and jerk; a dash for a derivative that it lacks.
pub(crate) fn components(system: &System, output: &Output) -> Vec<(String, [String; 4])> {
    let alike = |axes: &[&str]| -> Vec<(String, Dim)> { axes.iter().map(|axis| (format!(".{axis}"), output.dim)).collect() };
    let of_length = |axis: &str| (format!(".{axis}"), Dim::LENGTH);
    let parts = match output.components.len() {
        0 if !system.frames.is_empty() => {
            let cosines = (0..COSINES).map(|k| (format!(".a{}{}", k / 3 + 1, k % 3 + 1), Dim::NUMBER));
            ["x", "y", "z"].map(of_length).into_iter().chain(cosines).collect()
        }
        0 => vec![of_length("x"), of_length("y"), (".angle".to_owned(), Dim::ANGLE)],
        1 => vec![(String::new(), output.dim)],
        2 => alike(&["x", "y"]),
        _ => alike(&["x", "y", "z"]),
    };
    let name = output.name.unraw();
    let part = |(suffix, dim): (String, Dim)| {
        let rate = dim.per(Dim::TIME);
        let acceleration = rate.per(Dim::TIME);
        let units = [dim, rate, acceleration, acceleration.per(Dim::TIME)].map(|dim| dim.unit());
        (format!("{name}{suffix}"), from_fn(|order| if order > output.derivatives { NO_UNIT.to_owned() } else { units[order].clone() }))
    };
    parts.into_iter().map(part).collect()
}

fn unit_line(what: &str, unit: String) -> String {
    if unit.is_empty() { format!("{what}; a pure number.") } else { format!("{what}, in {unit}.") }
}

/// A routine's first line and its cost.
pub(crate) fn routine(what: &str, code: &Code) -> TokenStream {
    let Cost { flops, divisions, sines, calls } = code.cost();
    lines(&format!(
        "{what}\n\n{flops} sums and products, {divisions} divisions and roots, {sines} sine-cosine pairs, {calls} other functions."
    ))
}
