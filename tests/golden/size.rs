//! Generated code stays as short as a person would write it: so many lines, as they are formatted.

use super::expansion;
use std::fs;
use std::path::Path;

/// The most lines that the mechanism of an example may be compiled to.
const MOST: [(&str, usize); 3] = [("four_bar", 80000), ("jansen_leg", 80000), ("walker", 80000)];

/// The tokens of the first `mechanism!` in an example.
fn declaration(example: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(example).with_extension("rs");
    let file = syn::parse_file(&fs::read_to_string(path).expect("an example")).expect("an example is Rust");
    let declared = |item: syn::Item| match item {
        syn::Item::Macro(item) if item.mac.path.is_ident("mechanism") => Some(item.mac.tokens.to_string()),
        _ => None,
    };
    file.items.into_iter().find_map(declared).expect("an example declares a mechanism")
}

#[test]
fn examples_are_compiled_to_few_lines() {
    for (example, most) in MOST {
        let lines = expansion(&declaration(example)).lines().count();
        println!("{example}: {lines} lines");
        assert!(lines <= most, "`{example}` is compiled to {lines} lines, {most} are allowed");
    }
}
