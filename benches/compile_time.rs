//! Compile times of mechanisms: `cargo run -p reuleaux-benches --bin compile_time [runs]`.
//!
//! In: nothing. Out: a table for `README.md` beside this file: seconds of `cargo check` and `cargo build --release` for crates
//! without a mechanism, with many, and with one long one, dependencies built, without incremental compilation; each the median of
//! several runs, or one run where that takes more than a minute. Below it: by how much a long chain costs more than a short one,
//! without the linear work that `cargo check` does. It fails if that is more than thrice, or if a four-bar adds more than a second
//! to `cargo check`.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// How many times each command is run, if nothing is said.
const RUNS: usize = 3;

/// The most that a four-bar may add to `cargo check`, in s.
const LIMIT: f64 = 1.0;

/// How many times as long the longest chain may take to compile as the shortest.
const SHARED: f64 = 3.0;

/// Four-bars of the long chains.
const LONG: [usize; 3] = [2, 100, 500];

/// What takes longer than this, in s, is run once only.
const PATIENCE: f64 = 60.0;

/// Builds that are measured: heading, profile and command. By default macros are not optimised, which a user may change.
const COLUMNS: [(&str, &str, &[&str]); 3] = [
    ("`check`", "", &["check"]),
    ("`check`, compiler optimised", "[profile.dev.build-override]\nopt-level = 3\n", &["check"]),
    ("`build --release`", "", &["build", "--release"]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let runs = std::env::args().nth(1).map_or(Ok(RUNS), |runs| runs.parse())?;
    let crates = [
        ("no mechanism".to_owned(), String::new()),
        ("a four-bar".to_owned(), chain(0, 1)),
        ("a chain of 3 four-bars".to_owned(), chains(1)),
        ("10 such chains".to_owned(), chains(10)),
        ("40 such chains".to_owned(), chains(40)),
    ];
    let long = LONG.iter().map(|&four_bars| (format!("a chain of {four_bars} four-bars"), chain(0, four_bars)));
    let crates: Vec<(String, String)> = crates.into_iter().chain(long).collect();
    let mut columns = Vec::new();
    for (name, profile, command) in COLUMNS {
        let package = Package::new(profile)?;
        let mut column = Vec::new();
        for (words, source) in &crates {
            column.push(package.median(source, command, runs)?);
            eprintln!("{words}, {name}: {:.2} s", column[column.len() - 1]);
        }
        columns.push((name, column));
    }

    let names: Vec<&String> = crates.iter().map(|(name, _)| name).collect();
    print!("{}", table(&names, &columns));
    let shared = shared(&columns);
    println!(
        "\nOf a release build what is not `check`, the reading of the declaration, grows {shared:.1} times from {LONG:?} (at most {SHARED} wanted)."
    );
    let (_, check) = &columns[0];
    let added = check[1] - check[0];
    println!("\nA four-bar adds {added:.2} s to `cargo check` (at most {LIMIT} s is wanted). Medians of {runs} runs.");
    if added > LIMIT {
        return Err("a four-bar takes too long to check".into());
    }
    if shared <= SHARED { Ok(()) } else { Err("alike four-bars do not share their code".into()) }
}

/// How many times as long the longest chain takes to compile as the shortest, without the time that `cargo check` takes too.
fn shared(columns: &[(&str, Vec<f64>)]) -> f64 {
    let [(_, check), .., (_, build)] = columns else { return f64::NAN };
    let compiled = |row: usize| build[row] - check[row];
    let rows = check.len();
    compiled(rows - 1) / compiled(rows - LONG.len())
}

/// Rows of seconds, in Markdown.
fn table(rows: &[&String], columns: &[(&str, Vec<f64>)]) -> String {
    let mut text = "| crate, s".to_owned();
    for (name, _) in columns {
        let _ = write!(text, " | {name}");
    }
    let _ = writeln!(text, " |\n| --- {}|", "| ---: ".repeat(columns.len()));
    for (row, name) in rows.iter().enumerate() {
        let _ = write!(text, "| {name}");
        for (_, seconds) in columns {
            let _ = write!(text, " | {:.2}", seconds[row]);
        }
        text += " |\n";
    }
    text
}

/// A crate that depends on reuleaux, away from the workspace.
struct Package {
    folder: PathBuf,
}

impl Package {
    fn new(profile: &str) -> Result<Package, Box<dyn Error>> {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or(workspace.join("target"), PathBuf::from);
        let folder = target.join("compile_time").join(if profile.is_empty() { "plain" } else { "optimised" });
        fs::create_dir_all(folder.join("src"))?;
        let manifest = format!(
            "[package]\nname = \"measured\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\nreuleaux = {{ path = {:?} }}\n[workspace]\n{profile}",
            workspace.join("runtime")
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        // The same versions as here, and no look at a registry.
        fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        fs::copy(workspace.join("rust-toolchain.toml"), folder.join("rust-toolchain.toml"))?;
        Ok(Package { folder })
    }

    /// Seconds that `cargo` takes for the crate with this source; dependencies are built before.
    fn median(&self, source: &str, arguments: &[&str], runs: usize) -> Result<f64, Box<dyn Error>> {
        let first = self.seconds(source, 0, arguments)?;
        if first > PATIENCE {
            return Ok(first);
        }
        let mut seconds = (1..=runs.max(1)).map(|run| self.seconds(source, run, arguments)).collect::<Result<Vec<f64>, _>>()?;
        seconds.sort_by(f64::total_cmp);
        Ok(seconds[seconds.len() / 2])
    }

    fn seconds(&self, source: &str, run: usize, arguments: &[&str]) -> Result<f64, Box<dyn Error>> {
        // The comment makes cargo see another crate each time.
        fs::write(self.folder.join("src/lib.rs"), format!("{source}// run {run}\n"))?;
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
        cargo.args(arguments).args(["--quiet", "--offline", "--target-dir", "target"]);
        cargo.current_dir(&self.folder).env("CARGO_INCREMENTAL", "0").env_remove("CARGO_TARGET_DIR");
        let begin = Instant::now();
        let output = cargo.output()?;
        let seconds = begin.elapsed().as_secs_f64();
        if output.status.success() { Ok(seconds) } else { Err(String::from_utf8_lossy(&output.stderr).into()) }
    }
}

fn chains(count: usize) -> String {
    (0..count).map(|number| chain(number, 3)).collect()
}

/// A mechanism of this many four-bars in a row, and a function that solves it: neighbouring cranks of length 1 on pivots at
/// (i, 0), their tips joined by couplers of length 1.
fn chain(number: usize, four_bars: usize) -> String {
    format!(
        "reuleaux::mechanism! {{ pub mechanism Chain{number} {{
    param speed: AngularVelocity = 1rad_s;
    let n = {four_bars};
    ground {{ for i in 0..=n {{ point P[i] = (i * 1m, 0m); }} }}
    for i in 0..=n {{
        body crank[i] {{ point O = (0m, 0m); point A = (1m, 0m); start angle = 1rad; }}
        joint pivot[i] = revolute(ground.P[i], crank[i].O);
    }}
    for i in 0..n {{
        body coupler[i] {{ point A = (0m, 0m); point B = (1m, 0m); start angle = 0rad; }}
        joint a[i] = revolute(crank[i].A, coupler[i].A);
        joint b[i] = revolute(coupler[i].B, crank[i + 1].A);
    }}
    drive motor = drive_angle(crank[0], 1rad + speed * t);
    output tip = crank[n].A;
}} }}
pub fn tip_{number}(t: f64) -> Option<[f64; 2]> {{
    let chain = Chain{number}::default();
    Some(chain.tip(&chain.solve(t).ok()?).value.into())
}}
"
    )
}
