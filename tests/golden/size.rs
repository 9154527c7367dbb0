//! Generated code stays about as short as hand-written code, counted in lines as formatted by `rustfmt`.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Largest number of lines to which the mechanism of an example may be compiled, without the function that draws its states.
const MOST: [(&str, usize); 3] = [("four_bar", 800), ("jansen_leg", 1500), ("walker", 6500)];

/// The attribute that asks for this function.
const DRAWN: &str = "# [picture]";

/// The tokens of the first `mechanism!` in an example.
fn declaration(example: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(example).with_extension("rs");
    let file = syn::parse_file(&fs::read_to_string(path).expect("an example")).expect("an example is Rust");
    let declared = |item: syn::Item| match item {
        syn::Item::Macro(item) if item.mac.path.is_ident("mechanism") => Some(item.mac.tokens.to_string().replace(DRAWN, "")),
        _ => None,
    };
    file.items.into_iter().find_map(declared).expect("an example declares a mechanism")
}

/// The code as formatted by `rustfmt` with its default configuration.
fn formatted(code: &str) -> String {
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config", "max_width=100"])
        .current_dir(std::env::temp_dir())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the toolchain has `rustfmt`");
    rustfmt.stdin.take().expect("an input").write_all(code.as_bytes()).expect("it reads");
    String::from_utf8(rustfmt.wait_with_output().expect("it ends").stdout).expect("text")
}

#[test]
fn examples_are_compiled_to_few_lines() {
    for (example, most) in MOST {
        let tokens = declaration(example).parse().expect("a declaration is made of tokens");
        let lines = formatted(&reuleaux_compiler::mechanism(tokens).to_string()).lines().count();
        println!("{example}: {lines} lines");
        assert!(lines > 100, "`rustfmt` formats `{example}`");
        assert!(lines <= most, "`{example}` is compiled to {lines} lines, {most} are allowed");
    }
}
