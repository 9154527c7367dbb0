//! Every mistake gives one error, in the compiler's own words, also where the mechanism is used.
//!
//! One mistake per file; `macros/compiler/tests/refusals` has many more, without rustc. The files are compiled by rustc itself, against
//! the library that these tests were linked with. Two commands take longer:
//!
//! - `cargo test -p reuleaux-tests --test ui -- --ignored` compiles them again, by cargo in a separate project (trybuild);
//! - `TRYBUILD=overwrite cargo test -p reuleaux-tests --test ui -- --ignored` rewrites the expected output.

mod rustc;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use rustc::{Rustc, plain};

/// Mistakes by family.
const FAMILIES: [&str; 17] = [
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
    "times",
    "space",
];

/// The Rust files of a folder, relative to the package.
fn cases(family: &str) -> Vec<PathBuf> {
    let folder = Path::new("ui").join(family);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let files = entries.map(|entry| entry.expect("an entry of the folder").path());
    let mut cases: Vec<PathBuf> = files.filter(|file| file.extension().is_some_and(|extension| extension == "rs")).collect();
    cases.sort();
    cases
}

/// The complaints about each case, found by as many threads as there are processors.
fn complaints(cases: &[PathBuf], of_case: impl Fn(&Path) -> Option<String> + Sync) -> Vec<String> {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let work = || {
        let claimed = std::iter::from_fn(|| cases.get(next.fetch_add(1, Ordering::Relaxed)));
        claimed.filter_map(|case| of_case(case)).collect::<Vec<String>>()
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("no thread panics")).collect()
    })
}

#[test]
fn one_mistake_gives_one_error() {
    let rustc = Rustc::of_this_build();
    let cases: Vec<PathBuf> = FAMILIES.iter().flat_map(|family| cases(family)).collect();
    let complaints = complaints(&cases, |case| {
        let expected = std::fs::read_to_string(case.with_extension("stderr")).unwrap_or_else(|error| panic!("{}: {error}", case.display()));
        let found = match rustc.compile(case) {
            Ok(()) => return Some(format!("{} is accepted", case.display())),
            Err(found) => found,
        };
        let errors = expected.lines().filter(|line| line.starts_with("error")).count();
        if errors != 1 {
            // A mistake must not be reported twice.
            return Some(format!("{} has {errors} errors", case.display()));
        }
        (plain(&expected) != plain(&found)).then(|| format!("{}\nexpected:\n{expected}\nfound:\n{found}", case.display()))
    });
    assert!(complaints.is_empty(), "{}", complaints.join("\n\n"));
}

/// What is said of a method that the declaration does not give, but for the place of the trait in the runtime, at which rustc ends.
#[test]
fn absent_methods_say_why() {
    let rustc = Rustc::of_this_build();
    let complaints = complaints(&cases("absent"), |case| {
        let expected = std::fs::read_to_string(case.with_extension("stderr")).unwrap_or_else(|error| panic!("{}: {error}", case.display()));
        let Err(found) = rustc.compile(case) else { return Some(format!("{} is accepted", case.display())) };
        // The margin is as wide as the number of a line in the runtime.
        let words = |lines: Vec<&str>| lines.iter().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect::<Vec<_>>();
        let said = plain(&found).into_iter().take_while(|line| !line.starts_with("note: the trait `reuleaux::")).collect();
        let errors = found.lines().filter(|line| line.starts_with("error[")).count();
        (errors != 1 || words(plain(&expected)) != words(said))
            .then(|| format!("{}\nexpected:\n{expected}\nfound:\n{found}", case.display()))
    });
    assert!(complaints.is_empty(), "{}", complaints.join("\n\n"));
}

#[test]
fn what_is_accepted_runs() {
    let rustc = Rustc::of_this_build();
    let complaints = complaints(&cases("accepted"), |case| rustc.run(case).err().map(|found| format!("{}\n{found}", case.display())));
    assert!(complaints.is_empty(), "{}", complaints.join("\n\n"));
}

#[test]
#[ignore = "builds all dependencies once more: minutes"]
fn cargo_says_the_same() {
    let trybuild = trybuild::TestCases::new();
    for family in FAMILIES {
        trybuild.compile_fail(format!("ui/{family}/*.rs"));
    }
    trybuild.pass("ui/accepted/*.rs");
}
