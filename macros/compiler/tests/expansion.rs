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
fn compiles_one() {
    let expansion = expansion();
    println!("{expansion}");
    assert!(syn::parse2::<syn::File>(expansion).is_ok());
}

/// Output of a process that compiles with a folder for expansions.
fn compiled_with(folder: &Path) -> String {
    let this = std::env::current_exe().expect("this program");
    let made = Command::new(this).args(["--exact", "compiles_one", "--nocapture"]).env("REULEAUX_EXPAND", folder).output();
    let made = made.expect("it runs");
    assert!(made.status.success());
    String::from_utf8(made.stdout).expect("text")
}

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn is_written_formatted() {
    let folder = temporary("expanded");
    let _ = std::fs::remove_dir_all(&folder);
    compiled_with(&folder);
    let written = std::fs::read_to_string(folder.join("Crank.rs")).expect("the expansion");
    assert!(written.contains("// input (drive_angle): crank.angle"), "statements are under the joint that they serve");
    let [file, tokens] =
        [written.parse().expect("tokens"), expansion()].map(|code| prettyplease::unparse(&syn::parse2(undocumented(code)).expect("Rust")));
    assert_eq!(file, tokens);
}

/// The tokens without documentation, which is written as comments.
fn undocumented(code: TokenStream) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    for token in code {
        match token {
            TokenTree::Group(group) => {
                let is_attribute = matches!(kept.last(), Some(TokenTree::Punct(punct)) if punct.as_char() == '#');
                let text = group.stream().to_string();
                if is_attribute && text.starts_with("doc =") {
                    kept.pop();
                    continue;
                }
                kept.push(TokenTree::Group(Group::new(group.delimiter(), undocumented(group.stream()))));
            }
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
