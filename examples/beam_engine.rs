//! Watt's beam engine as an animated picture, drawn by the library from the states of one turn.
//!
//! ```text
//!        A ─────────────(O)───────────── R
//!        │ P             ╨               │ rod         OA = OR = DB = a
//!  D(o)──┴─ B                            │             AB = h, P in its middle
//!   ╨                              crank/K
//!                                    (o) C
//! ```
//!
//! Watt guided the piston rod without a slide: beam and radius bar rotate in opposite senses, and the middle of the link between them
//! moves up and down almost in a line. Beam, radius bar and link are checked against two triangles; P deviates from the line by less than
//! 3 mm, with a stroke of 240 mm.
//!
//! Source: F. Reuleaux, The Kinematics of Machinery, 1876, on Watt's parallel motion.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use reuleaux::mechanism;
use reuleaux::picture::{Drawable, Scene, frames};
use reuleaux_examples::{apex, largest_difference, place, play, polar, steps};

mechanism! {
    /// A beam engine with Watt's parallel motion.
    #[picture]
    pub mechanism BeamEngine {
        param arm: Length = 300mm;
        param link_length: Length = 200mm;
        param rod_length: Length = 500mm;
        param crank_length: Length = 120mm;
        param speed: AngularVelocity = 30rpm;

        ground {
            point O = (0mm, 0mm);
            point D = (-2 * arm, -link_length);
            point C = (288mm, -500mm);
        }
        body crank  { point C = (0mm, 0mm);   point K = (crank_length, 0mm); }
        body rod    { point K = (0mm, 0mm);   point R = (rod_length, 0mm);  start angle = 90deg; }
        body beam   { point A = (-arm, 0mm);  point O = (0mm, 0mm);         point R = (arm, 0mm); }
        body link   { point A = (0mm, 0mm);   point B = (0mm, -link_length); point P = (0mm, -link_length / 2); }
        body radius { point D = (0mm, 0mm);   point B = (arm, 0mm); }

        joint c = revolute(ground.C, crank.C);
        joint k = revolute(crank.K, rod.K);
        joint r = revolute(rod.R, beam.R);
        joint o = revolute(ground.O, beam.O);
        joint a = revolute(beam.A, link.A);
        joint b = revolute(link.B, radius.B);
        joint d = revolute(ground.D, radius.D);
        drive steam = drive_angle(crank, speed * t);

        output P = link.P;
    }
}

type State = BeamEngineState<f64>;

/// Number of frames of one turn.
const FRAMES: u32 = 30;

fn main() -> Result<(), Box<dyn Error>> {
    let engine = BeamEngine::default();
    let turn: Vec<State> = engine.sweep(steps(0.0, 2.0, FRAMES)).collect::<Result<_, _>>()?;
    assert_triangles(&engine, &turn);
    print(&engine, &turn);

    let scenes: Vec<Scene> = turn.iter().map(|state| engine.scene(state)).collect();
    for (number, frame) in frames(&scenes)?.iter().step_by(10).take(3).enumerate() {
        println!("{}", write(&format!("beam_engine_{number}"), &frame.page())?.display());
    }
    let view = engine
        .view(turn)
        .trace("path of P", |state| engine.P(state).value)
        .plot("beam", "°", |state| state.beam().angle.to_degrees())
        .plot("P across its line", "mm", |state| engine.P(state).value.x * 1e3);
    play("beam_engine", &view)?;
    Ok(())
}

fn assert_triangles(m: &BeamEngine, turn: &[State]) {
    let middle_of_link = |state: &State| {
        let crank = place(0.288, -0.5) + polar(m.crank_length, state.crank().angle);
        let r = apex(place(0.0, 0.0), crank, m.arm, m.rod_length);
        let (a, d) = (-r, place(-2.0 * m.arm, -m.link_length));
        let b = apex(a, d, m.link_length, m.arm);
        (a + b) * 0.5
    };
    let pairs = turn.iter().map(|state| (m.P(state).value, middle_of_link(state)));
    let error = largest_difference(pairs.flat_map(|(solved, drawn)| [(solved.x, drawn.x), (solved.y, drawn.y)]));
    assert!(error < 1e-13, "P is {error:e} m beside the triangles");
    let [across, stroke] = [extent(turn.iter().map(|state| m.P(state).value.x)), extent(turn.iter().map(|state| m.P(state).value.y))];
    assert!(across < 3e-3 && stroke > 0.24, "P leaves its line by {across} m, with a stroke of {stroke} m");
}

/// Difference of the largest and the smallest number.
fn extent(numbers: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), next| (low.min(next), high.max(next)));
    high - low
}

fn print(m: &BeamEngine, turn: &[State]) {
    println!("crank °   beam °   P across mm   P along mm");
    for state in turn.iter().step_by(5) {
        let p = m.P(state).value * 1e3;
        println!("{:7.1}   {:6.2}   {:11.3}   {:10.2}", state.crank().angle.to_degrees(), state.beam().angle.to_degrees(), p.x, p.y);
    }
}

/// Writes `examples/gallery/<name>.svg` and returns its path.
fn write(name: &str, svg: &str) -> Result<PathBuf, std::io::Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery").join(name).with_extension("svg");
    fs::write(&path, svg)?;
    Ok(path)
}
