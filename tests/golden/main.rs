//! Golden expansions of declarations: formatted Rust that is reviewed as code.
//!
//! After an intended change, `REULEAUX_GOLDEN=write cargo test --test golden` rewrites the files.

mod size;

use std::fs;
use std::path::{Path, PathBuf};

/// The formatted expansion of a declaration.
fn expansion(declaration: &str) -> String {
    let tokens = declaration.parse().expect("the declaration is made of tokens");
    let file = syn::parse2(reuleaux_compiler::mechanism(tokens)).expect("the expansion is Rust");
    prettyplease::unparse(&file)
}

fn declarations() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let files = fs::read_dir(folder).expect("the folder is there").map(|entry| entry.expect("an entry").path());
    let mut declarations: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|extension| extension == "declaration")).collect();
    declarations.sort();
    declarations
}

#[test]
fn declarations_are_compiled_to_what_was_reviewed() {
    let declarations = declarations();
    assert!(!declarations.is_empty());
    for path in declarations {
        let expansion = expansion(&fs::read_to_string(&path).expect("a declaration"));
        let reviewed = path.with_extension("expanded");
        if std::env::var_os("REULEAUX_GOLDEN").is_some_and(|mode| mode == "write") {
            fs::write(&reviewed, &expansion).expect("the file can be written");
        }
        let known = fs::read_to_string(&reviewed).expect("an expansion that was reviewed");
        let line = known.lines().zip(expansion.lines()).position(|(known, found)| known != found);
        assert!(known == expansion, "{} changed, first in line {:?}", reviewed.display(), line.map(|line| line + 1));
    }
}

#[test]
fn the_same_declaration_gives_the_same_code_every_time() {
    for path in declarations() {
        let text = fs::read_to_string(&path).expect("a declaration");
        assert_eq!(expansion(&text), expansion(&text));
    }
}
