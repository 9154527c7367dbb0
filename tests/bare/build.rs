//! Collects mechanisms that are declared elsewhere in the repository, each with a function that solves it.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

/// Files with a declaration, and replacements for macro variables in them.
const FILES: [(&str, &[(&str, &str)]); 20] = [
    ("golden/four_bar.declaration", &[]),
    ("golden/lift.declaration", &[]),
    ("golden/stephenson.declaration", &[]),
    ("../benches/workloads/four_bar.rs", &[]),
    ("../benches/workloads/slider_crank.rs", &[]),
    ("../benches/workloads/jansen.rs", &[]),
    ("../benches/workloads/chain/mod.rs", &[("$name", "Chain"), ("$count", "10")]),
    ("../benches/workloads/six_bar.rs", &[]),
    ("../benches/workloads/hexagon.rs", &[]),
    ("../examples/cam_roller.rs", &[]),
    ("../examples/coupled_wheels.rs", &[]),
    ("../examples/gear_train.rs", &[]),
    ("../examples/hydraulic_loader.rs", &[]),
    ("../examples/planetary.rs", &[]),
    ("../examples/quick_return.rs", &[]),
    ("../examples/rack_pinion.rs", &[]),
    ("../examples/rod_lengths.rs", &[]),
    ("../examples/slider_crank.rs", &[]),
    ("../examples/jansen_leg.rs", &[]),
    ("../examples/walker.rs", &[]),
];

/// Files of mechanisms with inputs.
const MEASURED: [&str; 1] = ["../examples/control_loop.rs"];

/// Files of mechanisms with freedoms.
const FREE: [&str; 2] = ["../examples/andrews.rs", "../examples/rolling_coin.rs"];

/// Code that uses a mechanism, from its name and its declaration.
type Use = fn(&str, &str) -> String;

fn main() -> Result<(), Box<dyn Error>> {
    // Only the inspection of machine code needs the mechanisms.
    if env::var_os("CARGO_FEATURE_ALONE").is_none() {
        return Ok(fs::write(Path::new(&env::var("OUT_DIR")?).join("mechanisms.rs"), "")?);
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let alone: [(&str, Use); 4] = [
        ("CARGO_FEATURE_ONCE", once),
        ("CARGO_FEATURE_STEPPING", step),
        ("CARGO_FEATURE_STARTING", start),
        ("CARGO_FEATURE_SOLVING", solve),
    ];
    if let Some((_, used)) = alone.into_iter().find(|(feature, _)| env::var_os(feature).is_some()) {
        let text = fs::read_to_string(folder.join(FILES[0].0))?;
        let module = module(0, &text, used).ok_or("no four-bar")?;
        return Ok(fs::write(Path::new(&env::var("OUT_DIR")?).join("mechanisms.rs"), module)?);
    }
    let mut all = String::new();
    for (number, (file, changes)) in FILES.iter().enumerate() {
        let path = folder.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let mut text = fs::read_to_string(&path)?;
        for (from, to) in *changes {
            text = text.replace(from, to);
        }
        writeln!(all, "// {file}\n{}", module(number, &text, solve).ok_or_else(|| format!("no mechanism in {file}"))?)?;
    }
    for (number, file) in (FILES.len() + FREE.len()..).zip(MEASURED) {
        let path = folder.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path)?;
        writeln!(all, "// {file}\n{}", module(number, &text, command).ok_or_else(|| format!("no mechanism in {file}"))?)?;
    }
    for (number, file) in (FILES.len()..).zip(FREE) {
        let path = folder.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path)?;
        writeln!(all, "// {file}\n{}", module(number, &text, integrate).ok_or_else(|| format!("no mechanism in {file}"))?)?;
    }
    fs::write(Path::new(&env::var("OUT_DIR")?).join("mechanisms.rs"), all)?;
    Ok(())
}

/// A module with the first mechanism of a file; `used` returns its function `run`.
fn module(number: usize, text: &str, used: Use) -> Option<String> {
    // Pictures need an allocator.
    let declaration = &between(text, "mechanism! {").unwrap_or(text).replace("#[picture]", "");
    let name = declaration.split("mechanism ").nth(1)?.split([' ', '{']).next()?;
    let function = used(name, declaration);
    Some(format!(
        "mod m{number} {{
            use super::T;
            reuleaux::mechanism! {{ {declaration} }}
            {function}
            #[used]
            static RUN: fn(&{name}<T>, T, &mut {name}State<T>) -> bool = run;
        }}"
    ))
}

/// Code that makes one step.
fn once(name: &str, _: &str) -> String {
    format!(
        "fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{ reuleaux::Mechanism::advance_once(mechanism, &mut state.0, t) }}"
    )
}

/// Code that steps.
fn step(name: &str, _: &str) -> String {
    format!("fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{ mechanism.advance(state, t).is_ok() }}")
}

/// Code that finds a state and steps.
fn start(name: &str, _: &str) -> String {
    format!(
        "fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{
            mechanism.solve(t).map(|found| *state = found).is_ok() && mechanism.advance(state, t + t).is_ok()
        }}"
    )
}

/// Code that calls every function that finds a state, and evaluates the outputs.
fn solve(name: &str, declaration: &str) -> String {
    let outputs = declaration.lines().filter_map(|line| {
        // Only outputs of the mechanism itself: deeper ones belong to parts.
        let output = line.trim_start_matches("pub ").trim_start().strip_prefix("output ")?;
        (indent(line) <= 8).then(|| output.split([' ', ':']).next())?
    });
    let outputs: String = outputs.map(|output| format!("core::hint::black_box(mechanism.{output}(state));")).collect();
    format!(
        "fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{
            let is_there = mechanism.advance(state, t).is_ok();
            {outputs}
            let after = mechanism.solve_from(t, state).is_ok();
            let anew = mechanism.solve(t).map(|found| *state = found).is_ok();
            let swept = mechanism.sweep([t, t + t]).filter_map(Result::ok).map(|found| *state = found).count();
            is_there & after & anew & (swept > 1)
        }}"
    )
}

/// Code that computes a state with inputs in every way.
fn command(name: &str, declaration: &str) -> String {
    let names = declaration.lines().filter_map(|line| line.trim().strip_prefix("input ")?.split(':').next());
    let inputs: String = names.map(|input| format!("{input}: reuleaux::Motion::moving(t, t),")).collect();
    format!(
        "fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{
             let inputs = {name}Inputs {{ {inputs} }};
             let is_there = mechanism.advance_once(state, t, inputs) | mechanism.advance(state, t, inputs).is_ok();
             let after = mechanism.solve_from(t, state, inputs).is_ok();
             let anew = mechanism.solve(t, inputs).map(|found| *state = found).is_ok();
             let swept = mechanism.sweep([(t, inputs), (t + t, inputs)]).filter_map(Result::ok).map(|found| *state = found).count();
             is_there & after & anew & (swept > 1)
         }}"
    )
}

/// Code that integrates a motion in every way.
fn integrate(name: &str, _: &str) -> String {
    format!(
        "fn run(mechanism: &{name}<T>, t: T, state: &mut {name}State<T>) -> bool {{
            let is_there = mechanism.initial_state().map(|found| *state = found).is_ok();
            let mut integrator = reuleaux::Integrator::new(t);
            let moves = mechanism.advance(state, t, &mut integrator).is_ok();
            let stops = mechanism.advance_until(state, t + t, &mut integrator, |state| state.qd[0]).is_ok();
            let steps = mechanism.step(state, t).is_ok() & mechanism.accelerate(state).is_ok();
            core::hint::black_box(mechanism.energy(state));
            is_there & moves & stops & steps
        }}"
    )
}

/// The text between the opening brace at the end of `opening` and its closing brace.
fn between<'a>(text: &'a str, opening: &str) -> Option<&'a str> {
    let inside = &text[text.find(opening)? + opening.len()..];
    let mut depth = 1;
    let end = inside.find(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0
    })?;
    Some(&inside[..end])
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}
