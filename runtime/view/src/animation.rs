//! A motion as one animated SVG: SMIL, which plays where scripts are not allowed.
//!
//! Each element is written once for each place that it has in the paint order of the motion, mostly once, and is visible in the frames
//! that paint it there.

use std::fmt::Write;

use crate::recording::{Drawn, Recording};
use crate::slots::{Slot, slots};
use crate::still;
use crate::template::Attribute;
use crate::tokens;
use crate::unviewable::Unviewable;

/// Largest number of states that are written, and the numbers to which they are reduced for a smaller file.
const MOST: [usize; 6] = [61, 41, 31, 25, 19, 13];

/// Rules for dark pages and for readers who prefer reduced motion.
const STYLE: &str = ".still{display:none}\
@media(prefers-color-scheme:dark){.reuleaux{--ink:#e6e6e6;--paper:#16181d}}\
@media(prefers-reduced-motion:reduce){.moving{display:none}.still{display:inline}}";

/// Times at which frames are shown.
struct Clock {
    /// Elapsed fraction of the period at each frame.
    times: Vec<f64>,
    /// True if frames are equally spaced in time.
    is_even: bool,
    /// Period, in s.
    period: String,
}

/// The motion in a file of at most `size` bytes if one of the numbers of states allows it.
pub(crate) fn animated_svg(recording: &Recording, size: usize) -> Result<String, Unviewable> {
    let mut page = String::new();
    for most in MOST {
        page = with_states(&recording.thinned(most))?;
        if page.len() <= size {
            break;
        }
    }
    Ok(page)
}

/// The motion with all states of a recording.
fn with_states(recording: &Recording) -> Result<String, Unviewable> {
    let drawn = recording.drawn()?;
    let clock = Clock::of(recording);
    let mut page = still::head(recording, &drawn, STYLE);
    page += &still::traces(&drawn);
    page += "<g class=\"moving\">\n";
    slots(&drawn.template).iter().for_each(|slot| page += &moving(slot, &clock, &drawn));
    page += "</g>\n<g class=\"still\">\n";
    drawn.template.painted(0).for_each(|element| page += &still::mark(element, 0));
    let _ = write!(page, "</g>\n{}</svg>\n", drawn.film.foot());
    Ok(page)
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

/// An element in one place of the paint order, with its animated attributes.
fn moving(slot: &Slot, clock: &Clock, drawn: &Drawn) -> String {
    let Some(element) = drawn.template.elements.get(slot.element) else { return String::new() };
    let shown = |frame: &usize| slot.is_shown.get(*frame).copied().unwrap_or(false);
    let count = slot.is_shown.len();
    let (first, last) = ((0..count).find(shown).unwrap_or(0), (0..count).rfind(shown).unwrap_or(0));
    let mut mark = still::opened(element, first);
    if (0..count).any(|frame| !shown(&frame)) {
        mark.insert_str(mark.len().saturating_sub(1), if shown(&0) { "" } else { " visibility=\"hidden\"" });
        mark += &visibility(&slot.is_shown, clock);
    }
    mark += &still::contents(element);
    // After a frame an element moves on towards its position in the next one.
    let is_needed = |frame: &usize| shown(frame) || *frame > first && shown(&(*frame - 1));
    let frames: Vec<usize> = (first..=(last + 1).min(count.saturating_sub(1))).filter(is_needed).collect();
    for attribute in element.attributes.iter().filter(|attribute| attribute.moves()) {
        mark += &animate(attribute, &frames, clock);
    }
    let _ = writeln!(mark, "</{}>", element.tag);
    mark
}

/// Animation of the visibility.
fn visibility(is_shown: &[bool], clock: &Clock) -> String {
    let is_change = |frame: &usize| *frame == 0 || is_shown[*frame] != is_shown[*frame - 1];
    let changes: Vec<usize> = (0..is_shown.len()).filter(is_change).collect();
    let values: Vec<&str> = changes.iter().map(|frame| if is_shown[*frame] { "visible" } else { "hidden" }).collect();
    let times: Vec<String> = changes.iter().map(|frame| clock.at(*frame)).collect();
    format!(
        "<animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\" dur=\"{}s\" \
         repeatCount=\"indefinite\"/>",
        values.join(";"),
        times.join(";"),
        clock.period
    )
}

/// Animation of one attribute over some frames; empty if the attribute is constant.
fn animate(attribute: &Attribute, frames: &[usize], clock: &Clock) -> String {
    let columns = attribute.steady();
    let numbers = |frame: &usize| columns.iter().filter_map(|column| column.get(*frame).copied()).collect::<Vec<i64>>();
    if let ("transform", [_, _, _]) = (attribute.name, columns.as_slice()) {
        // Position and angle are interpolated separately: bodies keep their shapes between frames.
        let part = |frame: &usize, part: std::ops::Range<usize>| {
            numbers(frame)[part].iter().map(|number| tokens::decimal(*number)).collect::<Vec<_>>().join(" ")
        };
        let start = "<animateTransform attributeName=\"transform\"";
        return timed(&format!("{start} type=\"translate\""), &|frame| part(frame, 0..2), frames, clock, true)
            + &timed(&format!("{start} type=\"rotate\" additive=\"sum\""), &|frame| part(frame, 2..3), frames, clock, true);
    }
    let start = format!("<animate attributeName=\"{}\"", attribute.name);
    timed(&start, &|frame| tokens::join(&attribute.skeleton, &numbers(frame)), frames, clock, false)
}

/// Animation that starts with `start` and takes these values; empty if they are constant, unless it is kept.
fn timed(start: &str, value: &dyn Fn(&usize) -> String, frames: &[usize], clock: &Clock, is_kept: bool) -> String {
    let mut values: Vec<String> = frames.iter().map(value).collect();
    if values.iter().all(|value| Some(value) == values.first()) {
        let value = values.first().map_or("", String::as_str);
        let constant = format!("{start} values=\"{value};{value}\" dur=\"{}s\" repeatCount=\"indefinite\"/>", clock.period);
        return if is_kept { constant } else { String::new() };
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
    format!("{start} values=\"{}\"{times} dur=\"{}s\" repeatCount=\"indefinite\"/>", values.join(";"), clock.period)
}
