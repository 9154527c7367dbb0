//! A motion as one animated SVG: SMIL, which plays where scripts are not allowed.
//!
//! Consecutive frames that paint the same elements in the same order form a run. The elements of a run are written once and animated; if
//! there are several runs, each is visible during its own frames.

use std::fmt::Write;

use crate::recording::{Drawn, Recording};
use crate::still;
use crate::template::{Attribute, Element};
use crate::tokens;
use crate::unviewable::Unviewable;

/// Largest number of states that are written.
const MOST: usize = 61;

/// Rules for dark pages and for readers who prefer reduced motion.
const STYLE: &str = ".still{display:none}\
@media(prefers-color-scheme:dark){.reuleaux{--ink:#e6e6e6;--paper:#16181d}}\
@media(prefers-reduced-motion:reduce){.moving{display:none}.still{display:inline}}";

/// Frames from `first` up to, but excluding, `end`, visible during one part of the period.
struct Run {
    first: usize,
    end: usize,
}

/// Times at which frames are shown.
struct Clock {
    /// Elapsed fraction of the period at each frame.
    times: Vec<f64>,
    /// True if frames are equally spaced in time.
    is_even: bool,
    /// Period, in s.
    period: String,
}

pub(crate) fn animated_svg(recording: &Recording) -> Result<String, Unviewable> {
    let recording = recording.thinned(MOST);
    let drawn = recording.drawn()?;
    let clock = Clock::of(&recording);
    let mut page = still::head(&recording, &drawn, STYLE);
    page += &still::traces(&drawn);
    page += "<g class=\"moving\">\n";
    let runs = runs(&drawn.template.order);
    for run in &runs {
        page += &shown(run, &clock, &drawn, runs.len() == 1);
    }
    page += "</g>\n<g class=\"still\">\n";
    drawn.template.painted(0).for_each(|element| page += &still::mark(element, 0));
    let _ = write!(page, "</g>\n{}</svg>\n", drawn.film.foot());
    Ok(page)
}

/// Runs of frames with the same paint order.
fn runs(order: &[usize]) -> Vec<Run> {
    let mut end = 0;
    let run = |same: &[usize]| {
        let first = end;
        end += same.len();
        Run { first, end }
    };
    order.chunk_by(|one, two| one == two).map(run).collect()
}

impl Clock {
    fn of(recording: &Recording) -> Clock {
        let values = &recording.abscissa.values;
        let first = values.first().copied().unwrap_or(0.0);
        let span = values.last().map_or(0.0, |last| last - first);
        let times: Vec<f64> = values.iter().map(|value| if span > 0.0 { (value - first) / span } else { 0.0 }).collect();
        let steps = (values.len().max(2) - 1) as f64;
        let is_even = times.iter().enumerate().all(|(number, time)| (time - number as f64 / steps).abs() < 0.05 / steps);
        let pace = recording.pace();
        Clock { times, is_even, period: crate::json::number(pace.lasting / pace.speed, 4) }
    }

    /// Elapsed fraction of the period at a frame, to four digits.
    fn at(&self, frame: usize) -> String {
        let time = self.times.get(frame).copied().unwrap_or(1.0);
        format!("{}", (time * 1e4).round() / 1e4)
    }
}

/// The elements of a run, visible during the run.
fn shown(run: &Run, clock: &Clock, drawn: &Drawn, is_alone: bool) -> String {
    let painted = drawn.template.painted(run.first);
    if is_alone {
        return painted.map(|element| moving(element, run, clock, drawn)).collect();
    }
    let count = clock.times.len();
    let visibility = if run.first == 0 { "visible" } else { "hidden" };
    let (values, times) = match (run.first, run.end) {
        (0, end) => ("visible;hidden", format!("0;{}", clock.at(end))),
        (first, end) if end == count => ("hidden;visible", format!("0;{}", clock.at(first))),
        (first, end) => ("hidden;visible;hidden", format!("0;{};{}", clock.at(first), clock.at(end))),
    };
    let mut group = format!(
        "<g visibility=\"{visibility}\"><animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"{values}\" \
         keyTimes=\"{times}\" dur=\"{}s\" repeatCount=\"indefinite\"/>\n",
        clock.period
    );
    painted.for_each(|element| group += &moving(element, run, clock, drawn));
    group + "</g>\n"
}

/// An element with its animated attributes.
fn moving(element: &Element, run: &Run, clock: &Clock, drawn: &Drawn) -> String {
    let mut mark = still::opened(element, run.first);
    mark += &still::contents(element);
    // At the end of a run an element moves on towards its position in the next frame.
    let frames = run.first..=run.end.min(drawn.template.order.len().saturating_sub(1));
    for attribute in element.attributes.iter().filter(|attribute| attribute.moves()) {
        mark += &animate(attribute, &frames.clone().collect::<Vec<_>>(), clock);
    }
    let _ = writeln!(mark, "</{}>", element.tag);
    mark
}

/// Animation of one attribute over some frames; empty if the attribute is constant.
fn animate(attribute: &Attribute, frames: &[usize], clock: &Clock) -> String {
    let columns = attribute.steady();
    let value = |frame: &usize| {
        let numbers: Vec<i64> = columns.iter().filter_map(|column| column.get(*frame).copied()).collect();
        tokens::join(&attribute.skeleton, &numbers)
    };
    let mut values: Vec<String> = frames.iter().map(value).collect();
    if values.iter().all(|value| Some(value) == values.first()) {
        return String::new();
    }
    let mut times = String::new();
    if frames.len() < clock.times.len() || !clock.is_even {
        let mut keys: Vec<String> = frames.iter().map(|frame| clock.at(*frame)).collect();
        // Key times must start at 0 and end at 1.
        if keys.first().is_some_and(|key| key != "0") {
            keys.insert(0, "0".into());
            values.insert(0, values.first().cloned().unwrap_or_default());
        }
        if keys.last().is_some_and(|key| key != "1") {
            keys.push("1".into());
            values.push(values.last().cloned().unwrap_or_default());
        }
        times = format!(" keyTimes=\"{}\"", keys.join(";"));
    }
    format!(
        "<animate attributeName=\"{}\" values=\"{}\"{times} dur=\"{}s\" repeatCount=\"indefinite\"/>",
        attribute.name,
        values.join(";"),
        clock.period
    )
}
