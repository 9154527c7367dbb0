//! A crank-rocker as an animated picture: the textbook drawing with the curve of a coupler point, and diagrams beside it.
//!
//! ```text
//!              coupler      B
//!        A ───────P────────(o)
//!       (o)                 │ rocker        OA = a, AB = b, BC = c, OC = d
//! crank /                   │
//!     (o)                  (o)
//!  ════O════════════════════C════
//! ```
//!
//! `cargo run --example moving_picture` writes one HTML page, by default to the target directory, and the same motion as an SVG to
//! the gallery; `cargo run --example moving_picture page.html` writes the page elsewhere.
//!
//! The rocker reverses where crank and coupler are in line. There its angle with the base follows by the law of cosines from three sides:
//! b + a or b − a, c and d. The diagrams show both.
//!
//! Source: R. L. Norton, Design of Machinery, toggle positions of the four-bar.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::steps;

mechanism! {
    /// A Grashof crank-rocker.
    #[picture]
    pub mechanism FourBar {
        param crank_length: Length = 40mm;
        param coupler_length: Length = 120mm;
        param rocker_length: Length = 80mm;
        param base: Length = 100mm;
        param speed: AngularVelocity = 15rpm;

        ground {
            point O = (0mm, 0mm);
            point C = (base, 0mm);
        }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (coupler_length, 0mm);  point P = (60mm, 45mm); }
        body rocker  { point C = (0mm, 0mm);  point B = (rocker_length, 0mm);  start angle = 60deg; }

        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive motor = drive_angle(crank, speed * t);

        output P = coupler.P;
        output transmission = rocker.angle - coupler.angle;
    }
}

type State = FourBarState<f64>;

/// Number of states in one turn.
const STATES: u32 = 240;

fn main() -> Result<(), Box<dyn Error>> {
    let four_bar = FourBar::default();
    let turn: Vec<State> = four_bar.sweep(steps(0.0, 4.0, STATES)).collect::<Result<_, _>>()?;
    assert_toggles(&four_bar, &turn);

    let view = four_bar
        .view(turn)
        .title("Crank-rocker four-bar")
        .trace("path of P", |state| four_bar.P(state).value)
        .plot("rocker angle", "°", |state| state.rocker().angle.to_degrees())
        .and("transmission angle", |state| four_bar.transmission(state).value.to_degrees())
        .plot("rocker velocity", "rad/s", |state| state.rocker().angular_velocity);
    let page = env::args_os().nth(1).map_or_else(default_page, |path| Ok(PathBuf::from(path)))?;
    view.write(&page)?;
    println!("{}: {} kB", page.display(), fs::metadata(&page)?.len() / 1000);

    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery/moving_picture.svg");
    fs::write(&gallery, view.animated_svg()?)?;
    println!("{}", gallery.display());
    Ok(())
}

/// The folder of the running program.
fn default_page() -> Result<PathBuf, std::io::Error> {
    Ok(env::current_exe()?.with_file_name("moving_picture.html"))
}

/// The rocker reverses at the angles of the law of cosines, within the resolution of a step.
fn assert_toggles(m: &FourBar, turn: &[State]) {
    let angle = |reach: f64| {
        let (c, d) = (m.rocker_length, m.base);
        std::f64::consts::PI - ((c * c + d * d - reach * reach) / (2.0 * c * d)).acos()
    };
    let angles = || turn.iter().map(|state| state.rocker().angle);
    let (low, high) = (angles().fold(f64::INFINITY, f64::min), angles().fold(f64::NEG_INFINITY, f64::max));
    let (out, back) = (angle(m.coupler_length + m.crank_length), angle(m.coupler_length - m.crank_length));
    assert!((low - out).abs() < 2e-4 && (high - back).abs() < 2e-4, "from {low} to {high} instead of {out} to {back}");
}
