//! The expansion of a mechanism as a file. An environment variable names its folder, so that the test compiles in a separate process.

use std::path::{Path, PathBuf};
use std::process::Command;

use proc_macro2::{Group, TokenStream, TokenTree};

const DECLARATION: &str = "#[doc = \"A crank.\"] mechanism Crank { ground { point O = (0mm, 0mm); } body crank { point O = (0mm, 0mm); } \
     joint o = revolute(ground.O, crank.O); drive input = drive_angle(crank, 60rpm * t); output turn = crank.angle; }";

fn expansion() -> TokenStream {
    reuleaux_compiler::mechanism(DECLARATION.parse().expect("tokens"))
}

/// Run in the separate process.
#[test]
fn an_expansion_is_rust() {
    let expansion = expansion();
    println!("{expansion}");
    assert!(syn::parse2::<syn::File>(expansion).is_ok());
}

/// They are fields of fields.
#[test]
fn sines_of_inputs_and_of_parameters_of_parts_have_names() {
    for declaration in [
        "mechanism M { input u: Angle; body a { mass = 1kg; inertia = 1kgm2; } joint h = revolute(ground.position, a.position);
         drive d = drive_angle(a, 1rad_s * t); force f = { on a: 1Nm * sin(u); } output y = sin(u) * a.angle; output z = cos(u); }",
        "mechanism M { part p[0] = C(ground.position); part p[1] = C(p[0].a.P); component C(Q: Point) { param u: Angle = 10deg;
         body a { point P = (cos(u) * 1m, sin(u) * 1m); } joint h = revolute(Q, a.position); drive d = drive_angle(a, 1rad_s * t);
         output y = sin(u) * a.angle; } }",
    ] {
        let expansion = reuleaux_compiler::mechanism(declaration.parse().expect("tokens"));
        assert!(!expansion.to_string().contains("compile_error") && syn::parse2::<syn::File>(expansion).is_ok());
    }
}

/// Output of a process that compiles with a folder for expansions.
fn compiled_with(folder: &Path) -> String {
    let this = std::env::current_exe().expect("this program");
    let made = Command::new(this).args(["--exact", "an_expansion_is_rust", "--nocapture"]).env("REULEAUX_EXPAND", folder).output();
    let made = made.expect("it runs");
    assert!(made.status.success());
    String::from_utf8(made.stdout).expect("text")
}

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn the_file_is_the_formatted_expansion() {
    let folder = temporary("expanded");
    let _ = std::fs::remove_dir_all(&folder);
    compiled_with(&folder);
    let written = std::fs::read_to_string(folder.join("Crank.rs")).expect("the expansion");
    let file: TokenStream = written.parse().expect("tokens");
    let [file, tokens] = [file, expansion()].map(|code| syn::parse2(without_documentation(code)).expect("Rust"));
    assert_eq!(prettyplease::unparse(&file), prettyplease::unparse(&tokens));
    // Comments lead from a statement to its joint.
    assert!(written.contains("// o (revolute): crank.x, crank.y\n"), "{written}");
    assert!(written.contains("/// A crank."), "{written}");
}

/// Inside functions, documentation is written as comments.
fn without_documentation(code: TokenStream) -> TokenStream {
    let mut tokens = code.into_iter().peekable();
    let mut kept = Vec::new();
    while let Some(token) = tokens.next() {
        let is_documentation =
            |next: &TokenTree| matches!(next, TokenTree::Group(group) if group.stream().to_string().starts_with("doc ="));
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' && tokens.peek().is_some_and(is_documentation) => {
                tokens.next();
            }
            TokenTree::Group(group) => kept.push(Group::new(group.delimiter(), without_documentation(group.stream())).into()),
            other => kept.push(other),
        }
    }
    kept.into_iter().collect()
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error() {
    let file = temporary("no_folder");
    std::fs::write(&file, "").expect("a file");
    let printed = compiled_with(&file);
    assert!(printed.contains("the expansion of `Crank` cannot be written to"), "{printed}");
}

/// Otherwise rustc would report every use of the mechanism as well.
#[test]
fn a_head_with_a_mistake_keeps_the_name() {
    for head in ["#[unknown] mechanism Crank in space", "mechanism Crank in spaec", "#[unknown] mechanism Crank"] {
        let declaration = format!("{head} {{ body crank {{}} }}");
        let expansion = reuleaux_compiler::mechanism(declaration.parse().expect("tokens")).to_string();
        assert!(expansion.contains("pub struct Crank"), "{head}: {expansion}");
    }
}
