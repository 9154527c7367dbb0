//! Tolerances: which part of a million linkages does what it should, if holes are drilled by hand?
//!
//! Every set of lengths is a linkage, solved in all positions of its crank, four side by side in a register, on all processors, under a
//! progress bar on standard error. The study itself is the crate [`reuleaux_study`], which the programme for many machines in `cluster/`
//! shares.
//!
//! ```sh
//! cargo run --release --example tolerances                        # 20 000 linkages, and the picture
//! cargo run --release --example tolerances 10000000               # ten million
//! cargo run --release --example tolerances 10000000 study.json    # goes on from study.json, and writes it every ten seconds
//! ```
//!
//! Linkages that cannot be turned are counted: as many as the closed form says, and exactly those. All others are compared with triangles. The
//! derivatives of the linear analysis are compared with those of the triangles, and with a study of tolerances so small that it must agree.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::PathBuf;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use reuleaux::nalgebra::Vector6;
use reuleaux::picture::{Drawable, GROUND};
use reuleaux_examples::{Place, apex, carried, figure, largest_difference, place, polar, rectangle, steps};
use reuleaux_study::{Alone, Lengths, Linkage, LinkageState, POSITIONS, Run, Spread, Study, Tally, lengths, linear, linkage, positions};

/// Sets without an argument, those of the picture.
const SETS: u64 = 20_000;
/// Sets that are compared with triangles.
const COMPARED: u64 = 2000;
/// A result of chance may be off by this many of its standard deviations.
const CHANCE: f64 = 5.0;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let sets = arguments.next().map_or(Ok(SETS), |sets| sets.parse())?;
    let run = Run { study: Study::default(), sets, checkpoint: arguments.next().map(PathBuf::from), interval: 10.0 };

    let bar = ProgressBar::new(sets).with_style(ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len} sets, {eta} left")?);
    let begin = Instant::now();
    let tally = run.on(&Alone, |done| bar.set_position(done))?;
    bar.finish_and_clear();
    eprintln!("{:.0} sets per second", tally.sets as f64 / begin.elapsed().as_secs_f64());
    print!("{}", run.study.report(&tally)?);

    failures_are_as_frequent_as_they_must_be(&run.study, &tally);
    sets_are_as_triangles_say(&run.study)?;
    slopes_are_those_of_triangles(&linear(&run.study)?);
    small_tolerances_are_linear()?;
    if sets == SETS {
        draw(&run.study, &tally)?;
    }
    Ok(())
}

/// The tip of a linkage by plane geometry; not a number where it does not close.
fn tip([ground, crank, coupler, rocker, along, across]: Lengths, t: f64) -> Place {
    let pin = polar(crank, TAU * t);
    let end = apex(pin, place(ground, 0.0), coupler, rocker);
    carried(place(along, across), pin, place(coupler, 0.0), end)
}

fn failures_are_as_frequent_as_they_must_be(study: &Study, tally: &Tally) {
    let expected = study.failing() * tally.sets as f64;
    let off = (tally.failed as f64 - expected) / expected.sqrt();
    assert!(off.abs() < CHANCE, "{} failures for {expected}", tally.failed);
}

/// The same sets fail, and all others have the same path errors.
fn sets_are_as_triangles_say(study: &Study) -> Result<(), Box<dyn Error>> {
    let nominal = lengths(&Linkage::default());
    let mut failed = 0;
    for number in 0..COMPARED {
        let tally = study.tally(number..number + 1)?;
        let lengths = lengths(&study.set(number));
        let off = positions().map(|t| tip(lengths, t) - tip(nominal, t));
        if off.iter().any(|off| off.x.is_nan()) {
            assert_eq!(tally.failed, 1, "set {number} cannot be turned");
            failed += 1;
            if failed == 1 {
                let reason = linkage(lengths).sweep(positions()).find_map(Result::err).ok_or("a reason")?;
                println!("\nset {number}, for example, cannot be turned:\n{reason}");
            }
            continue;
        }
        assert_eq!(tally.failed, 0, "set {number} can be turned");
        let error = off.iter().map(|off| off.norm()).fold(0.0, f64::max);
        let difference = largest_difference(
            tally
                .tips
                .iter()
                .zip(off)
                .flat_map(|([x, y], off)| [(x.mean(1), off.x), (y.mean(1), off.y)])
                .chain([(tally.error.mean(1), error)]),
        );
        assert!(difference < 1e-12, "set {number} is off by {difference} m");
    }
    assert!(failed > 0);
    Ok(())
}

/// The derivatives by central differences of the closed form, which are exact to 1e-9.
fn slopes_are_those_of_triangles(spreads: &[Spread]) {
    let nominal = lengths(&Linkage::default());
    for (t, spread) in positions().into_iter().zip(spreads) {
        for length in 0..nominal.len() {
            let moved = |by: f64| {
                let mut lengths = nominal;
                lengths[length] += by;
                tip(lengths, t)
            };
            let h = 1e-7;
            let slope = (moved(h) - moved(-h)) / (2.0 * h);
            let off = largest_difference([(spread.slopes[0][length], slope.x), (spread.slopes[1][length], slope.y)]);
            assert!(off < 1e-7, "length {length} at {t} s: off by {off}");
        }
    }
}

/// With tolerances that are a hundred times smaller no linkage fails, and deviations are those of the linear analysis.
fn small_tolerances_are_linear() -> Result<(), Box<dyn Error>> {
    let study = Study { deviation: 2.5e-6, ..Study::default() };
    let tally = study.tally_on_all_processors(0..SETS, |_| {})?;
    assert_eq!(tally.failed, 0);
    // That of a deviation from n normal numbers, and what a small tolerance leaves of the second order.
    let bound = CHANCE / (2.0 * SETS as f64).sqrt() + 1e-3;
    for (position, (moments, spread)) in tally.tips.iter().zip(linear(&study)?).enumerate() {
        for (moments, expected) in moments.iter().zip(spread.deviations) {
            let off = moments.deviation(tally.sets) / expected - 1.0;
            assert!(off.abs() < bound, "position {position}: {off}");
            assert!(moments.mean(tally.sets).abs() < (CHANCE / (SETS as f64).sqrt() + 1e-2) * expected, "position {position}");
        }
    }
    Ok(())
}

/// Where a tip is after a deviation of the lengths by `size` (m) in any direction that moves it as far as possible.
fn ellipse(centre: Place, spread: &Spread, size: f64) -> impl Iterator<Item = Place> {
    let [x, y] = spread.slopes.map(Vector6::from);
    // C Cᵀ = J Jᵀ
    let first = x.norm();
    let (along, across) = (x.dot(&y) / first, (y - x * (x.dot(&y) / (first * first))).norm());
    steps(0.0, TAU, 48).map(move |angle| centre + place(first * angle.cos(), along * angle.cos() + across * angle.sin()) * size)
}

/// The nominal linkage, tips of a few others with the ellipses in which the linear analysis expects 98.9 % of them, and the deviations of all.
fn draw(study: &Study, tally: &Tally) -> Result<(), Box<dyn Error>> {
    let nominal = Linkage::default();
    let states = nominal.sweep(positions()).collect::<Result<Vec<LinkageState<f64>>, _>>()?;
    let spreads = linear(study)?;
    let position = |state: &LinkageState<f64>| (state.t * POSITIONS as f64).round() as usize;
    let linear = |axis: usize| move |state: &LinkageState<f64>| 1e3 * spreads[position(state)].deviations[axis];
    let sets = |axis: usize| move |state: &LinkageState<f64>| 1e3 * tally.tips[position(state)][axis].deviation(tally.turning());
    let view = nominal
        .view(states)
        .title("Tolerances of a four-bar")
        .over("crank", "°", |state| 360.0 * state.t)
        .trace("path of the nominal tip", |state| nominal.tip(state).value)
        .plot("deviation of x, linear", "mm", linear(0))
        .against("Monte Carlo", sets(0))
        .plot("deviation of y, linear", "mm", linear(1))
        .against("Monte Carlo", sets(1));
    let mut view = view;
    for (t, spread) in positions().into_iter().zip(&spreads).step_by(6) {
        let others = (0..40).map(|number| tip(lengths(&study.set(number)), t)).filter(|tip| tip.x.is_finite());
        view = others.fold(view, |view, tip| view.outline(GROUND, rectangle(tip, 0.0, 0.1e-3, 0.1e-3)));
        view = view.outline(GROUND, ellipse(tip(lengths(&nominal), t), spread, 3.0 * study.deviation));
    }
    figure("tolerances", &view, 12, &[])
}
