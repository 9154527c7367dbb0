//! Compile times of mechanisms: `cargo run -p reuleaux-benches --bin compile_time [runs]`.
//!
//! In: nothing. Out: a table for `README.md` beside this file: seconds of `cargo check` and `cargo build --release` for crates
//! without a mechanism, with many, and with one long one, dependencies built, without incremental compilation; each the median of
//! several runs, or one run where that takes more than a minute. Below it: by how much a long chain costs more than a short one,
//! in the plane without the linear work that `cargo check` does. It fails if that is more than thrice, or if a four-bar, a six-axis arm or
//! a Stewart platform adds more to `cargo check` than is wanted.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// How many times each command is run, if nothing is said.
const RUNS: usize = 3;

/// The most that a mechanism may add to `cargo check`, in s, by the name of its row.
const LIMITS: [(&str, f64); 3] = [("a four-bar", 1.0), (ARM, 0.5), (STEWART, 2.0)];

/// A serial robot in space.
const ARM: &str = "a six-axis arm";
/// A platform on six legs of two bodies each.
const STEWART: &str = "a Stewart platform of 13 bodies";

/// How many times as long the longest chain may take to compile as the shortest.
const SHARED: f64 = 3.0;

/// Four-bars of the long chains.
const LONG: [usize; 3] = [2, 100, 500];

/// Four-bars of the chains that are released.
const RELEASED: [usize; 2] = [10, 40];

/// Loops of the long chains in space.
const LONG_IN_SPACE: [usize; 3] = [2, 50, 100];

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
    let freed = RELEASED.iter().map(|&four_bars| (format!("a released chain of {four_bars} four-bars"), released(four_bars)));
    let in_space = [(ARM.to_owned(), written("arm.rs", "Arm", 0)?), (STEWART.to_owned(), STEWART_PLATFORM.to_owned())];
    let long_in_space = LONG_IN_SPACE.map(|loops| Ok((in_words(loops), written("chain.rs", "Chain", loops)?)));
    let long_in_space = long_in_space.into_iter().collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    let crates: Vec<(String, String)> = crates.into_iter().chain(long).chain(freed).chain(in_space).chain(long_in_space).collect();
    let mut columns = Vec::new();
    for (name, profile, command) in COLUMNS {
        let package = Package::new(profile)?;
        package.seconds("", 0, command)?;
        let mut column = Vec::new();
        for (words, source) in &crates {
            column.push(package.median(source, command, runs)?);
            eprintln!("{words}, {name}: {:.2} s", column[column.len() - 1]);
        }
        columns.push((name, column));
    }

    let names: Vec<&String> = crates.iter().map(|(name, _)| name).collect();
    print!("{}", table(&names, &columns));
    println!();
    let mut wrong = Vec::new();
    let row = |name: &str| names.iter().position(|other| *other == name).expect("a row");
    let four_bars = |number: usize| row(&format!("a chain of {number} four-bars"));
    let shared = growth(&columns, four_bars(LONG[0]), four_bars(LONG[LONG.len() - 1]));
    println!("Of a release build what is not `check` grows {shared:.1} times over {LONG:?} four-bars (at most {SHARED} wanted).");
    if shared > SHARED {
        wrong.push("alike four-bars do not share their code".to_owned());
    }
    let (_, build) = &columns[columns.len() - 1];
    let whole = build[row(&in_words(LONG_IN_SPACE[LONG_IN_SPACE.len() - 1]))] / build[row(&in_words(LONG_IN_SPACE[0]))];
    println!("A whole release build grows {whole:.1} times over {LONG_IN_SPACE:?} loops in space (at most {SHARED} wanted).");
    if whole > SHARED {
        wrong.push("long chains in space take too long to build".to_owned());
    }
    let (_, check) = &columns[0];
    for (name, limit) in LIMITS {
        let added = check[row(name)] - check[0];
        println!("To `cargo check` {name} adds {added:.2} s (at most {limit} s wanted).");
        if added > limit {
            wrong.push(format!("{name} takes too long to check"));
        }
    }
    println!("Medians of {runs} runs.");
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join(", ").into()) }
}

/// How many times as long one chain takes to compile as another, without the time that `cargo check` takes too.
fn growth(columns: &[(&str, Vec<f64>)], shortest: usize, longest: usize) -> f64 {
    let [(_, check), .., (_, build)] = columns else { return f64::NAN };
    let compiled = |row: usize| build[row] - check[row];
    compiled(longest) / compiled(shortest)
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

    /// Seconds that `cargo` takes for the crate with this source, the median of several runs.
    fn median(&self, source: &str, arguments: &[&str], runs: usize) -> Result<f64, Box<dyn Error>> {
        let first = self.seconds(source, 0, arguments)?;
        if first > PATIENCE {
            return Ok(first);
        }
        let mut seconds = (1..=runs.max(1)).map(|run| self.seconds(source, run, arguments)).collect::<Result<Vec<f64>, _>>()?;
        seconds.sort_by(f64::total_cmp);
        Ok(seconds[seconds.len() / 2])
    }

    /// Seconds that `cargo` takes once; the first time it builds the dependencies too.
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

/// The same with masses and a freedom instead of the drive, and a function that follows its motion and finds its loads.
fn released(four_bars: usize) -> String {
    let mass = "mass = 1kg; center = (0.5m, 0m); inertia = rod(1m);";
    let driven = chain(0, four_bars);
    let (declared, _) = driven.split_once("pub fn").unwrap_or((&driven, ""));
    let declared = declared
        .replace("body crank[i] { point O = (0m, 0m);", &format!("body crank[i] {{ {mass} point O = (0m, 0m);"))
        .replace("body coupler[i] { point A = (0m, 0m);", &format!("body coupler[i] {{ {mass} point A = (0m, 0m);"))
        .replace(
            "drive motor = drive_angle(crank[0], 1rad + speed * t);",
            "gravity = (0, -9.81m_s2); freedom swing = crank[0].angle from 1rad at speed;",
        );
    assert!(declared.contains("freedom swing") && declared.matches("inertia").count() == 2, "the chain is declared otherwise now");
    format!(
        "{declared}
pub fn tip_0(t: f64) -> Option<[f64; 2]> {{
    let chain = Chain0::default();
    let mut state = chain.initial_state().ok()?;
    chain.advance(&mut state, t, &mut reuleaux::Integrator::new(1e-9)).ok()?;
    Some([chain.tip(&state).value.x, chain.loads(&state).multipliers[0]])
}}
"
    )
}

/// The name of the row of a chain in space.
fn in_words(loops: usize) -> String {
    format!("a chain of {loops} loops in space")
}

/// A mechanism of the benchmark `space`, as it is written there, and a function that solves it.
fn written(file: &str, name: &str, loops: usize) -> Result<String, Box<dyn Error>> {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("space").join(file))?;
    let begin = text.find("mechanism! {").ok_or("no mechanism")?;
    let mut open = 0;
    let is_last = |(_, letter): &(usize, char)| {
        open += i32::from(*letter == '{') - i32::from(*letter == '}');
        *letter == '}' && open == 0
    };
    let (length, _) = text[begin..].char_indices().find(is_last).ok_or("no end of the mechanism")?;
    let declared = text[begin..=begin + length].replace("$name", name).replace("$loops", &loops.to_string()).replace("pub(super)", "pub");
    let solved = format!("{name}::default().solve(t).ok().map(|state| state.q.iter().sum())");
    Ok(format!("reuleaux::{declared}\npub fn solved(t: f64) -> Option<f64> {{ {solved} }}\n"))
}

/// Each leg is a cylinder on a universal joint, and a rod with a ball.
const STEWART_PLATFORM: &str = "reuleaux::mechanism! { pub mechanism Stewart in space {
    let base = 1m;
    let top = 0.6m;
    ground {
        axis x = (1, 0, 0);
        for k in 0..3 {
            point B[2 * k] = (base * cos(120deg * k - 10deg), base * sin(120deg * k - 10deg), 0m);
            point B[2 * k + 1] = (base * cos(120deg * k + 10deg), base * sin(120deg * k + 10deg), 0m);
        }
    }
    body platform {
        for k in 0..3 {
            point P[2 * k] = (top * cos(120deg * k - 50deg), top * sin(120deg * k - 50deg), 0m);
            point P[2 * k + 1] = (top * cos(120deg * k + 50deg), top * sin(120deg * k + 50deg), 0m);
        }
        start position = (0m, 0m, 1m);
    }
    for i in 0..6 {
        body cylinder[i] { axis y = (0, 1, 0); axis z = (0, 0, 1) from (1, 0, 0); }
        body rod[i] { axis z = (0, 0, 1) from (1, 0, 0); }
        joint foot[i] = universal(ground.B[i], ground.x, cylinder[i].position, cylinder[i].y);
        joint bore[i] = translational(cylinder[i].position, cylinder[i].z, rod[i].position, rod[i].z);
        joint head[i] = spherical(rod[i].position, platform.P[i]);
        drive leg[i] = drive_translation(bore[i], 1.15m + 50mm * sin(60deg * i + 1rad_s * t));
    }
} }
pub fn solved(t: f64) -> Option<f64> { Stewart::default().solve(t).ok().map(|state| state.q.iter().sum()) }
";
