//! A pump whose dimensions are read from a file, and whose motion is written as a table.
//!
//! ```text
//!        A
//!       ○╲                  configured.toml ─▶ Pump ─▶ sweep ─▶ lines of numbers with names and units
//!     r╱  ╲ l
//!     ○    ╲___
//!    ═╩═   |_○_|  ▷ x       x = r cos θ + √(l² − r² sin² θ)
//!         ═══════
//! ```
//!
//! `#[serde]` before the mechanism makes its parameters readable, whatever the format; here it is TOML. `#[outputs]` gives the table its
//! columns. The stroke that is read back from the table is that of the closed form.
//!
//! Usage: `cargo run --example configured [pump.toml [table.csv]]`

use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

use reuleaux::picture::{Drawable, frames};
use reuleaux::{csv, mechanism};
use reuleaux_examples::{play, steps};

mechanism! {
    /// A pump with a plunger on a guide.
    #[serde]
    #[serde(deny_unknown_fields)]
    #[outputs]
    #[picture]
    pub mechanism Pump {
        #[serde(rename = "crank")]
        param crank_length: Length = 50mm in 5mm..;
        #[serde(rename = "rod")]
        param rod_length: Length = 200mm in 5mm..;
        param speed: AngularVelocity = 60rpm;

        ground { point O = (0mm, 0mm);  axis bore = (1, 0); }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body rod     { point A = (0mm, 0mm);  point B = (rod_length, 0mm); }
        body plunger { point B = (0mm, 0mm);  start position = (250mm, 0mm); }

        joint main = revolute(ground.O, crank.O);
        joint big_end = revolute(crank.A, rod.A);
        joint small_end = revolute(rod.B, plunger.B);
        joint guide = translational(ground.bore, ground.O, plunger.B);
        drive motor = drive_angle(crank, speed * t);

        output angle = crank.angle;
        output stroke = plunger.x;
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut arguments = std::env::args_os().skip(1);
    let configuration = arguments.next().map_or_else(|| folder.join("configured.toml"), Into::into);

    let configuration: toml::Table = fs::read_to_string(configuration)?.parse()?;
    let pump: Pump = part(&configuration, "pump")?.try_into()?;
    let sweep = part(&configuration, "sweep")?;
    let seconds = |name: &str| sweep.get(name).and_then(toml::Value::as_float).ok_or(format!("`sweep.{name}` is no number of seconds"));
    let count = sweep.get("steps").and_then(toml::Value::as_integer).map(u32::try_from).ok_or("`sweep.steps` is no number")??;
    let times = steps(seconds("from")?, seconds("to")?, count);

    let mut table = Vec::new();
    csv::write_outputs(&mut table, &pump, pump.sweep(times.clone()))?;
    let table = String::from_utf8(table)?;
    assert_closed_form(&pump, &table)?;
    match arguments.next() {
        // All coordinates go to a file.
        Some(path) => csv::write(BufWriter::new(File::create(path)?), &pump, pump.sweep(times))?,
        None => print!("{table}"),
    }

    let picture = folder.join("gallery/configured.svg");
    let state = pump.solve(0.05)?;
    let frames = frames(&[pump.scene(&state)])?;
    fs::write(&picture, frames.first().ok_or("there is no frame")?.page())?;
    println!("{}", picture.display());

    let states = pump.sweep(steps(0.0, 1.0, 120)).collect::<Result<Vec<_>, _>>()?;
    let view = pump.view(states).plot("stroke", "mm", |state| pump.stroke(state).value * 1e3);
    play("configured", &view)?;
    Ok(())
}

/// A table of the file.
fn part(configuration: &toml::Table, name: &str) -> Result<toml::Value, String> {
    configuration.get(name).cloned().ok_or(format!("there is no `[{name}]`"))
}

/// The numbers of the table are those of the closed form.
fn assert_closed_form(pump: &Pump, table: &str) -> Result<(), Box<dyn Error>> {
    let mut lines = table.lines();
    let header: Vec<&str> = lines.next().ok_or("the table has a header")?.split(',').collect();
    let column = |name: &str| header.iter().position(|known| *known == name).ok_or(format!("there is no column {name}"));
    let [time, stroke] = [column("t (s)")?, column("stroke (m)")?];
    for line in lines {
        let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let (sine, cosine) = (pump.speed * numbers[time]).sin_cos();
        let expected = pump.crank_length * cosine + (pump.rod_length.powi(2) - (pump.crank_length * sine).powi(2)).sqrt();
        assert!((numbers[stroke] - expected).abs() < 1e-15, "the plunger is at {} m instead of {expected} m", numbers[stroke]);
    }
    Ok(())
}
