//! Every mistake gives one error, in the compiler's own words, also where the mechanism is used.
//!
//! One mistake a file; `macros/compiler/tests/refusals` has many more of them, without rustc.
//! `TRYBUILD=overwrite cargo test -p reuleaux-tests --test ui` writes the expected output anew.

/// Mistakes by family.
const FAMILIES: [&str; 15] = [
    "syntax",
    "names",
    "arity",
    "dimensions",
    "duplicates",
    "values",
    "uses",
    "definitions",
    "joints",
    "drives",
    "components",
    "mobility",
    "redundancy",
    "closure",
    "parameters",
];

#[test]
fn one_mistake_gives_one_error() {
    let cases = trybuild::TestCases::new();
    for family in FAMILIES {
        cases.compile_fail(format!("ui/{family}/*.rs"));
    }
    cases.pass("ui/accepted/*.rs");
}

/// A mistake that is told twice is told once too often.
#[test]
fn expected_output_has_one_error() {
    for family in FAMILIES {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("ui").join(family);
        for file in std::fs::read_dir(folder).expect("the folder of the family").flatten() {
            if file.path().extension().is_some_and(|extension| extension == "stderr") {
                let text = std::fs::read_to_string(file.path()).expect("expected output is text");
                let errors = text.lines().filter(|line| line.starts_with("error")).count();
                assert_eq!(errors, 1, "{}", file.path().display());
            }
        }
    }
}
