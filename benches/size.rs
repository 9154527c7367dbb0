//! Bytes of a four-bar in single precision, without a standard library: `cargo run -p reuleaux-benches --bin size [-- TARGET]`
//!
//! In: the crate `reuleaux-bare`, compiled for size with whole-program optimisation. Out: a table of the bytes of instructions and of constant
//! data, for a program that only steps and for one that finds its first state as well.

use object::{Object, ObjectSection, SectionKind};
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// Features of the crate, and what a program with them does.
const PROGRAMS: [(&str, &str); 4] = [
    ("once", "`advance_once` alone, from a state that the program brings along"),
    ("stepping", "`advance` alone, from such a state"),
    ("starting", "`solve` once, then `advance`"),
    ("solving", "`solve`, `solve_from`, `sweep`, `advance`, all outputs"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let target = env::args().nth(1);
    println!("| a four-bar in `f32` | instructions | constants |\n| --- | ---: | ---: |");
    for (feature, words) in PROGRAMS {
        let [text, data] = sizes(target.as_deref(), feature)?;
        println!("| {words} | {text} B | {data} B |");
    }
    Ok(())
}

/// Bytes of instructions and of constants.
fn sizes(target: Option<&str>, feature: &str) -> Result<[u64; 2], Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/bare/bytes");
    fs::create_dir_all(&folder)?;
    let file = folder.join(format!("{feature}.o"));
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let features = format!("alone,single,{feature}");
    cargo.args([
        "rustc",
        "--quiet",
        "--release",
        "--package",
        "reuleaux-bare",
        "--lib",
        "--crate-type",
        "staticlib",
        "--features",
        &features,
    ]);
    cargo.arg("--target-dir").arg(&folder);
    for setting in ["lto=\"fat\"", "panic=\"abort\"", "codegen-units=1", "opt-level=\"s\""] {
        cargo.args(["--config", &format!("profile.release.{setting}")]);
    }
    if let Some(target) = target {
        cargo.args(["--target", target]);
    }
    // Cargo does not track the object file; a new `cfg` makes rustc write it again.
    let run = std::process::id();
    cargo.args(["--", &format!("--emit=obj={}", file.display()), "--cfg", &format!("run=\"{run}\""), "--allow", "unexpected_cfgs"]);
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    if !cargo.status()?.success() {
        return Err(format!("it was not built with {features}").into());
    }
    let bytes = fs::read(file)?;
    let object = object::File::parse(bytes.as_slice())?;
    let of =
        |kinds: &[SectionKind]| object.sections().filter(|section| kinds.contains(&section.kind())).map(|section| section.size()).sum();
    Ok([of(&[SectionKind::Text]), of(&[SectionKind::ReadOnlyData, SectionKind::ReadOnlyString, SectionKind::ReadOnlyDataWithRel])])
}
