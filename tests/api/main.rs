//! The public items of the libraries, one per line and sorted, in a text file for each library beside this one.
//!
//! Without arguments the program compares the items with the files and prints the differences; with `write` it rewrites the files. Run it
//! in the root of the repository. It reads the JSON of rustdoc, which is unstable: `RUSTC_BOOTSTRAP` lets the pinned toolchain write it.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// The published libraries other than those of the compiler.
const LIBRARIES: [&str; 5] = ["reuleaux", "reuleaux-cam", "reuleaux-picture", "reuleaux-view", "reuleaux-wide"];

/// Nothing that is compiled here runs long enough to be worth optimising.
const QUICK: [&str; 3] = [
    "profile.dev.package.reuleaux-compiler.opt-level=0",
    "profile.dev.package.\"*\".opt-level=0",
    "profile.dev.build-override.opt-level=0",
];

/// Lets rustdoc describe all libraries with all features; returns the folder of the descriptions.
fn describe() -> Result<PathBuf, Box<dyn Error>> {
    // A folder of its own, because `RUSTC_BOOTSTRAP` would have the rest compiled again.
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from).join("api");
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["doc", "--quiet", "--no-deps", "--lib", "--all-features"]).arg("--target-dir").arg(&target);
    cargo.args(LIBRARIES.iter().flat_map(|library| ["--package", library]));
    cargo.args(QUICK.iter().flat_map(|setting| ["--config", setting]));
    cargo.env("RUSTC_BOOTSTRAP", "1").env("RUSTDOCFLAGS", "-Z unstable-options --output-format json");
    if !cargo.status()?.success() {
        return Err("rustdoc does not describe the libraries".into());
    }
    Ok(target.join("doc"))
}

/// The public items of a library, without the implementations that follow from others by the rules of the language.
fn items(described: &Path, library: &str) -> Result<String, Box<dyn Error>> {
    let file = described.join(library.replace('-', "_")).with_extension("json");
    let listed = public_api::Builder::from_rustdoc_json(file).omit_blanket_impls(true).omit_auto_trait_impls(true).build()?;
    Ok(format!("{listed}\n"))
}

/// The lines that only one of the texts has.
fn differences(known: &str, found: &str) -> Vec<String> {
    let (known, found): (BTreeSet<&str>, BTreeSet<&str>) = (known.lines().collect(), found.lines().collect());
    let removed = known.difference(&found).map(|line| format!("-{line}"));
    removed.chain(found.difference(&known).map(|line| format!("+{line}"))).collect()
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let writes = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["write"] => true,
        _ => return Err("give no argument to compare, or `write` to rewrite the lists".into()),
    };
    let described = describe()?;
    let mut agrees = true;
    for library in LIBRARIES {
        let (list, found) = (Path::new("tests/api").join(library).with_extension("txt"), items(&described, library)?);
        if writes {
            std::fs::write(&list, found)?;
            continue;
        }
        let known = std::fs::read_to_string(&list).map_err(|error| format!("{}: {error}", list.display()))?;
        if known != found {
            agrees = false;
            println!("{} is not what the library has:", list.display());
            differences(&known, &found).iter().for_each(|line| println!("{line}"));
        }
    }
    if !agrees {
        println!("If this is intended: cargo run --manifest-path tests/api/Cargo.toml --target-dir target/api -- write");
    }
    Ok(if agrees { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
