//! The README is correct: its program prints the output shown, its message is the compiler's, its tables and commands are complete. (Its
//! Rust blocks are compiled as doctests of `reuleaux-macros`.)

mod blocks;

use std::process::Command;

use proc_macro2::{TokenStream, TokenTree};
use reuleaux_compiler::library;
use reuleaux_compiler::quantity::Ambient;

const README: &str = include_str!("../../README.md");
const PROGRAM: &str = include_str!("crank_rocker.rs");
const CHECKS: &str = include_str!("../../.ci/run");

/// The blocks fenced with this language.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("\n```{language}\n");
    README.split(&opening).skip(1).filter_map(|rest| rest.split("```").next()).collect()
}

/// The tokens between the braces of the program's `mechanism!`.
fn declaration(program: &str) -> TokenStream {
    let tokens: Vec<TokenTree> = program.parse::<TokenStream>().expect("the program is Rust").into_iter().collect();
    let place = tokens.windows(2).position(|pair| pair[0].to_string() == "mechanism" && pair[1].to_string() == "!");
    match place.and_then(|place| tokens.get(place + 2)) {
        Some(TokenTree::Group(group)) => group.stream(),
        _ => panic!("the program has no `mechanism! {{ … }}`"),
    }
}

#[test]
fn the_first_block_is_the_program_that_is_run_here() {
    assert_eq!(blocks("rust")[0], PROGRAM, "README.md and tests/readme/crank_rocker.rs differ");
}

#[test]
fn the_program_prints_what_is_printed() {
    let run = Command::new(env!("CARGO_BIN_EXE_readme")).output().expect("the program runs");
    assert!(run.status.success());
    let printed = String::from_utf8(run.stdout).expect("the output is text");
    assert!(blocks("text").contains(&printed.as_str()), "the README should print\n{printed}");
}

#[test]
fn the_message_is_what_the_compiler_says() {
    let wrong = PROGRAM.replace("speed * t)", "speed)");
    let refusals = reuleaux_compiler::compile(declaration(&wrong)).expect_err("an angular velocity is no angle");
    // rustc indents the further lines of a message.
    let message = format!("error: {}\n", refusals[0].fact.message().replace('\n', "\n       "));
    assert_eq!(refusals.len(), 1);
    let block =
        blocks("text").into_iter().find(|block| block.starts_with(&message)).unwrap_or_else(|| panic!("the README should say\n{message}"));

    let (number, line) = wrong.lines().enumerate().find(|(_, line)| line.contains("drive_angle")).expect("there is a drive");
    let column = line.find("speed").expect("it names the speed") + 1;
    assert!(block.contains(&format!("src/main.rs:{}:{column}\n", number + 1)));
    assert!(block.contains(&format!("\n{} | {line}\n", number + 1)));
}

#[test]
fn seven_coordinates_are_computed_and_two_are_iterated() {
    let blocks = reuleaux_compiler::compile(declaration(PROGRAM)).expect("the program compiles").structure.blocks;
    let count = |of: fn(&reuleaux_compiler::structure::Block) -> usize| blocks.iter().map(of).collect::<Vec<_>>();
    assert_eq!(count(|block| block.explicit.len()).iter().sum::<usize>(), 7);
    assert_eq!(count(|block| block.iterated.len()).into_iter().filter(|iterated| *iterated > 0).collect::<Vec<_>>(), [2]);
}

#[test]
fn every_kind_of_the_library_has_its_row() {
    let (plane, space) = README.split_once("\n| joint in space ").expect("the tables of space stand below those of the plane");
    let (space, forces) = space.split_once("\n| force ").expect("the forces stand below the joints");
    let (forces, laws) = forces.split_once("\n| motion law ").expect("the laws stand below the forces");
    let rows: [(&str, Vec<&str>); 5] = [
        (plane, library::constraints(Ambient::Plane).collect()),
        (space, library::constraints(Ambient::Space).collect()),
        (forces, library::forces(Ambient::Plane).collect()),
        (forces, library::forces(Ambient::Space).collect()),
        (laws, library::functions().collect()),
    ];
    for (table, names) in rows {
        for name in names {
            assert!(table.contains(&format!("\n| `{name}(")), "`{name}` is missing in the README's tables");
        }
    }
}

#[test]
fn the_commands_are_those_of_the_checks() {
    let commands = blocks("sh");
    assert_eq!(commands.len(), 2, "two commands: one runs an example, one passes the tests");
    assert!(CHECKS.contains(&format!("\n{}", commands[1])), ".ci/run does not call `{}`", commands[1].trim());
}
