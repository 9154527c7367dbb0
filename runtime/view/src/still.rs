//! Single frames as SVG.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::recording::{Drawn, Recording};
use crate::template::{Element, Template};
use crate::tokens::decimal;

/// Colours of traces and of curves in diagrams, with a lightness that contrasts with both white and black.
pub(crate) const COLOURS: [&str; 6] = ["#a56cc1", "#d06f24", "#1f9c99", "#cf5c68", "#3f87c9", "#94873a"];

/// File names of frames.
pub(crate) struct Names<'a> {
    folder: &'a Path,
    digits: usize,
    extension: &'a str,
}

impl Names<'_> {
    /// Creates the folder.
    pub(crate) fn new<'a>(folder: &'a Path, count: usize, extension: &'a str) -> io::Result<Names<'a>> {
        fs::create_dir_all(folder)?;
        Ok(Names { folder, digits: count.to_string().len().max(4), extension })
    }

    pub(crate) fn of(&self, frame: usize) -> PathBuf {
        self.folder.join(format!("{frame:0digits$}.{}", self.extension, digits = self.digits))
    }
}

/// A frame as a file of its own, on white, in colours that any program understands.
pub(crate) fn svg(recording: &Recording, drawn: &Drawn, frame: usize) -> String {
    let (head, foot) = (head(recording, drawn, ""), drawn.film.foot());
    plain(format!("{head}{}{}{foot}</svg>\n", traces(drawn), painted(drawn, frame)))
}

/// Bodies are drawn pale and thin in the other phases.
pub(crate) const PALE: &str =
    ".reuleaux .pale{opacity:.3}.reuleaux .pale .b{stroke-width:3}.reuleaux .pale .q{stroke-width:2;fill-opacity:.15}";

/// The first frame as a file of its own, above the bodies of the next `others` frames.
pub(crate) fn phases(recording: &Recording, drawn: &Drawn, others: usize) -> String {
    let head = head(recording, drawn, if others == 0 { "" } else { PALE });
    plain(format!("{head}{}</svg>\n", above(drawn, others)))
}

/// The shapes of the first frame, with the traces, above the bodies of the next `others` frames; and the captions.
pub(crate) fn above(drawn: &Drawn, others: usize) -> String {
    let mut shapes = String::new();
    for other in 1..=others {
        shapes += "<g class=\"pale\">\n";
        drawn.template.painted(other).filter(|element| is_body(element)).for_each(|element| shapes += &mark(element, other));
        shapes += "</g>\n";
    }
    shapes + &traces(drawn) + &painted(drawn, 0) + drawn.film.foot()
}

/// All shapes of a frame.
fn painted(drawn: &Drawn, frame: usize) -> String {
    drawn.template.painted(frame).map(|element| mark(element, frame)).collect()
}

/// A picture in black on white, without the rules by which it takes the colours of a page.
pub(crate) fn plain(mut picture: String) -> String {
    // A title stands before the style, and labels behind it.
    let next = |picture: &str| {
        let style = picture.find("<style>")?..picture.find("</style>")?;
        let begin = style.start + picture.get(style)?.find("@supports(")?;
        Some(begin..begin + picture.get(begin..)?.find("}}")? + 2)
    };
    while let Some(rule) = next(&picture) {
        picture.replace_range(rule, "");
    }
    picture.replace("fill:#fff;fill:var(--paper)", "fill:#fff")
}

/// True for the shapes of bodies: bars, plates, blocks, wheels, forks.
fn is_body(element: &Element) -> bool {
    let class = element.class.split(' ').collect::<Vec<_>>();
    matches!(class.as_slice(), ["b" | "q" | "k" | "w" | "o" | "f", colour] if *colour != "g")
}

/// The opening of the SVG element: size, title, style sheet, and the white background.
pub(crate) fn head(recording: &Recording, drawn: &Drawn, style: &str) -> String {
    let [left, top, width, height] = view_box(drawn);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"reuleaux\" role=\"img\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"{left} {top} {width} {height}\">\n<title>{}</title>\n<desc>{}</desc>\n<style>{}{TRACE}{style}</style>\n\
         <rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" style=\"fill:#fff;fill:var(--paper)\"/>\n",
        escaped(&recording.title),
        escaped(drawn.film.description()),
        drawn.film.style(),
    )
}

/// Style of traces.
pub(crate) const TRACE: &str = ".reuleaux .trace{fill:none;stroke:currentColor;stroke-width:1.4}";

/// View box, in picture units.
pub(crate) fn view_box(drawn: &Drawn) -> [String; 4] {
    drawn.film.frame().map(|part| decimal((part * 10.0).round() as i64))
}

/// Traced paths.
pub(crate) fn traces(drawn: &Drawn) -> String {
    let mut page = String::new();
    for (places, colour) in drawn.traces.iter().zip(COLOURS.iter().cycle()) {
        let _ = writeln!(page, "<path class=\"trace\" style=\"color:{colour}\" d=\"{}\"/>", way(places));
    }
    page
}

/// A polyline through points.
fn way(places: &[[f64; 2]]) -> String {
    let mut points: Vec<[i64; 2]> = places.iter().map(|place| tenths(*place)).collect();
    points.dedup();
    let pair = |[x, y]: &[i64; 2]| format!("{} {}", decimal(*x), decimal(*y));
    format!("M{}", points.iter().map(pair).collect::<Vec<_>>().join("L"))
}

pub(crate) fn tenths(place: [f64; 2]) -> [i64; 2] {
    place.map(|part| (part * 10.0).round() as i64)
}

/// An element in one frame.
pub(crate) fn mark(element: &Element, frame: usize) -> String {
    let mut mark = opened(element, frame);
    let _ = writeln!(mark, "{}</{}>", contents(element), element.tag);
    mark
}

/// The opening tag of an element.
pub(crate) fn opened(element: &Element, frame: usize) -> String {
    let class = if element.class.is_empty() { String::new() } else { format!(" class=\"{}\"", element.class) };
    let mut mark = format!("<{}{class}", element.tag);
    for attribute in &element.attributes {
        let _ = write!(mark, " {}=\"{}\"", attribute.name, Template::attribute(attribute, frame));
    }
    mark + ">"
}

/// Tooltip of a shape, or text of a label.
pub(crate) fn contents(element: &Element) -> String {
    let title = if element.title.is_empty() { String::new() } else { format!("<title>{}</title>", escaped(&element.title)) };
    title + &escaped(&element.text)
}

pub(crate) fn escaped(text: &str) -> String {
    // Other control characters are left out.
    let text = text.replace(|letter: char| letter.is_control() && letter != '\n' && letter != '\t', " ");
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
