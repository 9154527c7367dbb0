//! Blocks of code in the documentation.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders with documentation whose blocks are compiled.
const FOLDERS: [&str; 6] =
    ["macros/src", "macros/compiler/errors", "runtime/src", "runtime/cam/src", "runtime/view/src", "runtime/wide/src"];

/// rustdoc compiles all blocks as modules of one crate, or each block alone if that crate has an error; that takes many times as long. In a
/// module, `crate::…` does not name what the block defines.
#[test]
fn blocks_that_name_their_crate_are_crates() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = vec![root.join("README.md")];
    FOLDERS.iter().for_each(|folder| collect(&root.join(folder), &mut files));
    let mut found = 0;
    for file in files {
        let text = fs::read_to_string(&file).expect("a text file");
        let is_rust = file.extension().is_some_and(|extension| extension == "rs");
        let mut fence = None;
        for line in text.lines().filter_map(|line| if is_rust { documentation(line) } else { Some(line) }).map(str::trim_start) {
            if let Some(words) = line.strip_prefix("```") {
                fence = if fence.is_some() { None } else { Some(words) };
            } else if let Some(words) = fence.filter(|words| *words != "text" && line.starts_with("use crate::")) {
                assert!(words.contains("standalone_crate"), "{}: {line}", file.display());
                found += 1;
            }
        }
    }
    assert!(found >= 7, "only {found} blocks were seen");
}

/// The text of a doc comment.
fn documentation(line: &str) -> Option<&str> {
    let line = line.trim_start();
    line.strip_prefix("///").or(line.strip_prefix("//!"))
}

/// All files with documentation in a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() {
            collect(&entry, files);
        } else if entry.extension().is_some_and(|extension| extension == "md" || extension == "rs") {
            files.push(entry);
        }
    }
}
