//! How accurate states are: against the reference numbers, against their own bounds, and in which time.
//! `cargo run --release -p reuleaux-benches --bin accuracy`
//!
//! In: `shared/reference`, or the copies in `tests`. Out: the tables and the picture of the page `reuleaux::accuracy`, beside its text.
//! It fails where an error is beyond its bound, a bound beyond a thousand errors and the attainable one, or a certificate without a
//! solution.

mod diagram;
mod families;
mod speed;
mod wrong;

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime/src/accuracy");
    let text = format!("{}\n{}", families::table(), wrong::count());
    print!("{text}");
    fs::write(page.join("measured.md"), text)?;
    diagram::draw(&page.join("diagram.svg").display().to_string(), &speed::panels())
}
