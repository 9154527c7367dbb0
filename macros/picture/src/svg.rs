//! From shapes to SVG: the same bytes on every run, no blank line, legible on light and dark pages.

use crate::canvas::{Canvas, DrawnItem, Layer, Subject};
use crate::element::{COLOURS, Element, number, pair, path};
use crate::labels::{HEIGHT, Placed, SIZE, width};
use crate::plane::{Place, Rectangle, place};
use crate::view::View;
use std::fmt::Write;

/// Margin around the picture.
const MARGIN: f64 = 8.0;

/// Largest length of the scale bar.
const BAR: f64 = 110.0;

/// The rules of all pictures, in colours that any program knows. Rules in `@supports` are passed over by programs without variables.
const STYLE: &str = ".reuleaux *{stroke-linejoin:round;stroke-linecap:round}\
.reuleaux .t,.reuleaux .l,.reuleaux .d{fill:none;stroke:#1c1c1c;stroke-width:1}\
.reuleaux .l{stroke-width:1.6}\
.reuleaux .d{stroke-width:1.4;stroke-dasharray:5 4}\
.reuleaux .s{fill:#1c1c1c}\
.reuleaux .p{fill:#fff;stroke:#1c1c1c;stroke-width:1.6}\
.reuleaux .b{fill:none;stroke:currentColor;stroke-width:7}\
.reuleaux .q{fill:currentColor;fill-opacity:.3;stroke:currentColor;stroke-width:4}\
.reuleaux .k{fill:currentColor;stroke:#1c1c1c;stroke-width:1.4}\
.reuleaux .w{fill:currentColor;fill-opacity:.14;stroke:currentColor;stroke-width:1.8}\
.reuleaux .o{fill:none;stroke:currentColor;stroke-width:1.8}\
.reuleaux text{font:12px \"Fira Sans\",\"DejaVu Sans\",Arial,sans-serif;fill:#1c1c1c;stroke:#fff;stroke-width:3;paint-order:stroke;text-anchor:middle}\
.reuleaux .i{font-style:italic}";

/// Ink and paper take the colours of the surrounding page if it defines them, as rustdoc does.
const VARIABLES: &str = "@supports(color:var(--ink)){.reuleaux{--ink:var(--main-color,#1c1c1c);--paper:var(--main-background-color,#fff);max-width:100%;height:auto}\
.reuleaux .t,.reuleaux .l,.reuleaux .d,.reuleaux .p,.reuleaux .k{stroke:var(--ink)}\
.reuleaux .s,.reuleaux text{fill:var(--ink)}\
.reuleaux .p{fill:var(--paper)}\
.reuleaux text{stroke:var(--paper)}}";

/// Additional style rules of spatial pictures.
const IN_SPACE: &str = ".reuleaux .a{fill:none;stroke:#1c1c1c;stroke-width:.8;stroke-opacity:.75;stroke-dasharray:9 3 1 3}\
.reuleaux .r{fill:none;stroke:#1c1c1c;stroke-width:2.6}\
.reuleaux .h{fill:none;stroke:#fff;stroke-width:12;stroke-linecap:butt}\
.reuleaux .f{fill:none;stroke:currentColor;stroke-width:4.5}\
.reuleaux .e{fill:#fff;fill-opacity:.6;stroke:none}\
.reuleaux .v{fill:#fff;fill-opacity:.4;stroke:#1c1c1c;stroke-width:1.2}\
@supports(color:var(--ink)){.reuleaux .a,.reuleaux .r,.reuleaux .v{stroke:var(--ink)}.reuleaux .h{stroke:var(--paper)}.reuleaux .e{fill:var(--paper)}}";

/// Title and description of a picture, for screen readers.
pub(crate) struct Captions<'a> {
    pub(crate) title: &'a str,
    pub(crate) description: &'a str,
}

/// Bounding box of shapes and labels.
pub(crate) fn frame(canvas: &Canvas, labels: &[Placed]) -> Rectangle {
    let parts = canvas.items.iter().map(|item| item.shape.frame().grown(4.0)).chain(labels.iter().map(|label| label.frame));
    parts.fold(Rectangle::empty(), |frame, part| frame.with(part.low).with(part.high))
}

/// The whole picture, with a view box for `frame`.
pub(crate) fn svg(canvas: &Canvas, labels: &[Placed], scale: &Scale, frame: Rectangle, words: &Captions) -> String {
    let (foot, frame) = foot(&canvas.captions, scale, frame);
    let mut page = head(frame, words, canvas.is_in_space);
    page += &body(canvas, labels);
    page += &foot;
    page += "</svg>\n";
    page
}

/// One animated picture of several frames, each shown for an equal part of `period` (s), with a view box for `frame`.
pub(crate) fn animation(frames: &[(Canvas, Vec<Placed>)], scale: &Scale, frame: Rectangle, words: &Captions, period: f64) -> String {
    let captions = frames.first().map_or(&[][..], |(canvas, _)| &canvas.captions);
    let (foot, frame) = foot(captions, scale, frame);
    let mut page = head(frame, words, matches!(scale, Scale::Axes(_)));
    for (index, (canvas, labels)) in frames.iter().enumerate() {
        page += &shown_in_turn(index, frames.len(), period);
        page += &body(canvas, labels);
        page += "</g>\n";
    }
    page += &foot;
    page += "</svg>\n";
    page
}

/// Opens a group that is visible for one part of the period. Viewers without animation show the first group only.
fn shown_in_turn(index: usize, count: usize, period: f64) -> String {
    let time = |index: usize| format!("{}", (index as f64 / count as f64 * 1e4).round() / 1e4);
    let (values, times) = match index {
        0 => ("visible;hidden", format!("0;{}", time(1))),
        last if last + 1 == count => ("hidden;visible", format!("0;{}", time(last))),
        index => ("hidden;visible;hidden", format!("0;{};{}", time(index), time(index + 1))),
    };
    let visibility = if index == 0 { "visible" } else { "hidden" };
    let animate = if count > 1 {
        format!(
            "<animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"{values}\" keyTimes=\"{times}\" dur=\"{period}s\" \
             repeatCount=\"indefinite\"/>"
        )
    } else {
        String::new()
    };
    format!("<g visibility=\"{visibility}\">{animate}\n")
}

/// A sentence in place of a picture.
pub(crate) fn sentence(name: &str, sentence: &str) -> String {
    let frame = Rectangle::centred(Place::default(), place(width(sentence), HEIGHT)).grown(MARGIN);
    let mut page = head(frame, &Captions { title: name, description: sentence }, false);
    let _ = writeln!(page, "<text x=\"0\" y=\"{}\">{}</text>\n</svg>", number(SIZE * 0.33), escaped(sentence));
    page
}

/// The opening of the SVG element, with title, description and style sheet.
fn head(frame: Rectangle, words: &Captions, is_in_space: bool) -> String {
    let (corner, size) = (frame.low, frame.size());
    let mut page = String::new();
    let _ = writeln!(
        page,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"reuleaux\" role=\"img\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">",
        number(size.x),
        number(size.y),
        number(corner.x),
        number(corner.y),
        number(size.x),
        number(size.y)
    );
    let _ = writeln!(page, "<title>{}</title>\n<desc>{}</desc>", escaped(words.title), escaped(words.description));
    let _ = writeln!(page, "<style>{}</style>", style(is_in_space));
    page
}

/// The style sheet.
pub(crate) fn style(is_in_space: bool) -> String {
    let colours: String = COLOURS.iter().enumerate().map(|(index, colour)| format!(".reuleaux .c{index}{{color:{colour}}}")).collect();
    let more = if is_in_space { IN_SPACE } else { "" };
    format!("{STYLE}{colours}.reuleaux .g{{color:#888}}{VARIABLES}{more}")
}

/// Shapes from bottom to top, then labels.
fn body(canvas: &Canvas, labels: &[Placed]) -> String {
    let mut page = String::new();
    for same in in_order(canvas).chunk_by(|one, two| one.layer == two.layer && one.title == two.title) {
        group(&mut page, same);
    }
    for label in labels {
        let class = if is_italic(label) { " class=\"i\"" } else { "" };
        word(&mut page, class, label.frame.middle(), &label.text);
    }
    page
}

/// Shapes from bottom to top.
pub(crate) fn in_order(canvas: &Canvas) -> Vec<&DrawnItem> {
    let mut items: Vec<&DrawnItem> = canvas.items.iter().collect();
    if !canvas.is_in_space {
        items.sort_by_key(|item| item.layer);
    }
    items
}

/// Tooltip of a shape. The support of a hinge needs none, as the hinge itself has one.
pub(crate) fn told(item: &DrawnItem) -> &str {
    if item.layer == Layer::Ground { "" } else { &item.title }
}

/// Captions and scale below a frame, with the frame of the whole picture.
pub(crate) fn foot(captions: &[String], scale: &Scale, mut frame: Rectangle) -> (String, Rectangle) {
    let mut below = String::new();
    if let Scale::Axes(axes) = scale {
        let taken = axes_of_ground(&mut below, axes);
        frame = frame.with(taken.low).with(taken.high);
    }
    let mut foot = place(frame.low.x, frame.high.y + 16.0);
    for caption in captions {
        foot.y += HEIGHT + 3.0;
        let _ = writeln!(
            below,
            "<text class=\"i\" style=\"text-anchor:start\" x=\"{}\" y=\"{}\">{}</text>",
            number(foot.x),
            number(foot.y),
            escaped(caption)
        );
        frame = frame.with(foot + place(width(caption), 2.0));
    }
    match scale {
        Scale::Bar(view) => {
            foot.y += 10.0;
            let right = scale_bar(&mut below, *view, foot);
            (below, frame.with(right).with(foot + place(0.0, 4.0)).grown(MARGIN))
        }
        Scale::Axes(_) => (below, frame.grown(MARGIN)),
    }
}

/// The shapes of one item, with its tooltip.
fn group(page: &mut String, items: &[&DrawnItem]) {
    let Some(first) = items.first() else { return };
    let told = told(first);
    let title = if told.is_empty() { String::new() } else { format!("<title>{}</title>", escaped(told)) };
    if let [item] = items {
        let element = Element::of(item);
        let (name, attributes) = (element.tag, element.attributes());
        let _ = if title.is_empty() {
            writeln!(page, "<{name} {attributes}/>")
        } else {
            writeln!(page, "<{name} {attributes}>{title}</{name}>")
        };
        return;
    }
    let _ = write!(page, "<g>{title}");
    for item in items {
        let element = Element::of(item);
        let _ = write!(page, "<{} {}/>", element.tag, element.attributes());
    }
    let _ = writeln!(page, "</g>");
}

/// Indication of the scale.
#[derive(Clone, Debug)]
pub(crate) enum Scale {
    /// A bar below the picture.
    Bar(View),
    /// The axes of ground, with their length as a text.
    Axes(Axes),
}

/// The axes x, y and z of ground with their length.
#[derive(Clone, Debug)]
pub(crate) struct Axes {
    pub(crate) origin: Place,
    /// Vectors from the origin to the ends.
    pub(crate) ways: [Place; 3],
    /// Text of the length, with its position.
    pub(crate) length: (String, Place),
}

impl Axes {
    /// Axes of a round length; `seen` are the projected unit vectors.
    pub(crate) fn new(seen: [Place; 3], scale: f64) -> Axes {
        let metres = round_length(AXIS / scale);
        let ways = seen.map(|way| way * (metres * scale));
        let text = format!("axes {}", length(metres));
        let box_of = Rectangle::around(ways.into_iter().chain([Place::default()])).grown(LETTER);
        let at = place(box_of.middle().x, box_of.high.y + HEIGHT / 2.0);
        Axes { origin: Place::default(), ways, length: (text, at) }
    }

    /// Bounding box, with the letters.
    pub(crate) fn frame(&self) -> Rectangle {
        let ends = self.ways.iter().map(|way| self.origin + *way).chain([self.origin]);
        let (text, at) = &self.length;
        let words = Rectangle::centred(self.origin + *at, place(width(text), HEIGHT));
        Rectangle::around(ends).grown(LETTER).with(words.low).with(words.high)
    }
}

/// Largest length of the axes.
const AXIS: f64 = 52.0;

/// Space for the letter beyond the end of an axis.
const LETTER: f64 = 16.0;

fn axes_of_ground(page: &mut String, axes: &Axes) -> Rectangle {
    let Axes { origin, ways, length: (text, at) } = axes;
    let mut lines = String::new();
    // An axis towards the eye has no direction in the picture.
    let seen = || ["x", "y", "z"].into_iter().zip(ways).filter(|(_, way)| way.norm() > 1.0);
    for (_, way) in seen() {
        let _ = write!(lines, "M{}L{}", pair(*origin), pair(*origin + *way));
    }
    let _ = writeln!(page, "<path class=\"l\" d=\"{lines}\"/>");
    for (name, way) in seen() {
        let (tip, along) = (*origin + *way, way.unit());
        if way.norm() > 8.0 {
            let (back, side) = (tip - along * 8.0, along.perp() * 3.2);
            let _ = writeln!(page, "<path class=\"s\" d=\"{}Z\"/>", path(&[tip, back + side, back - side]));
        }
        word(page, "", tip + along * 9.0, name);
    }
    word(page, "", *origin + *at, text);
    axes.frame()
}

/// A text centred at a place.
fn word(page: &mut String, class: &str, middle: Place, text: &str) {
    let base = baseline(middle);
    let _ = writeln!(page, "<text{class} x=\"{}\" y=\"{}\">{}</text>", number(base.x), number(base.y), escaped(text));
}

/// Names of bodies are in italics.
pub(crate) fn is_italic(label: &Placed) -> bool {
    label.role == Subject::Body
}

/// Midpoint of the baseline of a text, from the centre of the text.
pub(crate) fn baseline(middle: Place) -> Place {
    middle + place(0.0, SIZE * 0.33)
}

/// Largest of 1, 2 and 5 times a power of ten that does not exceed `most`.
fn round_length(most: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(most)));
    [5.0, 2.0, 1.0].into_iter().map(|step| step * power).find(|length| *length <= most).unwrap_or(power)
}

/// A scale bar of a round length that starts at `from`; returns the end of its text.
fn scale_bar(page: &mut String, view: View, from: Place) -> Place {
    let metres = round_length(BAR / view.scale);
    let to = from + place(view.length(metres), 0.0);
    let tick = |at: Place| format!("M{}V{}", pair(at - place(0.0, 4.0)), number(at.y + 4.0));
    let text = length(metres);
    let _ = writeln!(page, "<path class=\"l\" d=\"M{}H{}{}{}\"/>", pair(from), number(to.x), tick(from), tick(to));
    let words = to + place(8.0 + width(&text) / 2.0, SIZE * 0.33);
    let _ = writeln!(page, "<text x=\"{}\" y=\"{}\">{text}</text>", number(words.x), number(words.y));
    words + place(width(&text) / 2.0, 2.0)
}

/// A round length in a suitable unit.
fn length(metres: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm")];
    let (size, unit) = units.into_iter().find(|(size, _)| metres >= size * 0.999).unwrap_or((1e-9, "nm"));
    let value = metres / size;
    if value < 1e6 { format!("{} {unit}", value.round()) } else { format!("{value:.0e} {unit}") }
}

fn escaped(text: &str) -> String {
    // Other control characters are left out.
    let text = text.replace(|letter: char| letter.is_control() && letter != '\n' && letter != '\t', " ");
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
