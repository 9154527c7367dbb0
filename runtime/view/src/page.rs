//! The page: the first frame as SVG, the data of all frames, and the scripts that play them.

use crate::columns::{Columns, encode};
use crate::json;
use crate::recording::{Drawn, Recording};
use crate::still::{self, COLOURS, escaped};
use crate::template::{Element, Template};
use crate::unviewable::Unviewable;

const STYLE: &str = include_str!("../assets/page.css");
const SCRIPT: &str = include_str!("../assets/page.js");
const UPLOT: &str = include_str!("../assets/uplot/uPlot.iife.min.js");
const UPLOT_STYLE: &str = include_str!("../assets/uplot/uPlot.min.css");
const UPLOT_LICENCE: &str = include_str!("../assets/uplot/LICENSE");

/// Digits of plotted values.
const DIGITS: usize = 7;

/// Digits of times.
const TIME_DIGITS: usize = 10;

pub(crate) fn html(recording: &Recording) -> Result<String, Unviewable> {
    let drawn = recording.drawn()?;
    let title = escaped(&recording.title);
    let style = format!("{UPLOT_STYLE}\n{}{}\n{STYLE}", drawn.film.style(), still::TRACE);
    let (drawing, data) = (drawing(recording, &drawn), data(recording, &drawn));
    let plotter = if recording.plots.is_empty() { String::new() } else { format!("<script>\n/*\n{UPLOT_LICENCE}\n*/\n{UPLOT}</script>\n") };
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>\n{style}</style>\n</head>\n<body>\n<header><h1>{title}</h1></header>\n\
         <main>\n<figure id=\"drawing\">\n{drawing}</figure>\n<section id=\"plots\" aria-label=\"Diagrams\"></section>\n</main>\n\
         <noscript>This is the first state; to see the others, allow scripts.</noscript>\n\
         <script type=\"application/json\" id=\"data\">{data}</script>\n{plotter}<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    ))
}

/// The first frame, and the names of traces.
fn drawing(recording: &Recording, drawn: &Drawn) -> String {
    let [left, top, width, height] = still::view_box(drawn);
    let marks: String = drawn.template.painted(0).map(|element| still::mark(element, 0)).collect();
    let traces = recording.traces.iter().zip(COLOURS.iter().cycle());
    let names: String =
        traces.map(|(trace, colour)| format!("<span style=\"color:{colour}\"><i></i>{}</span>", escaped(&trace.name))).collect();
    let caption = if names.is_empty() { String::new() } else { format!("<figcaption>{names}</figcaption>\n") };
    format!(
        "<svg class=\"reuleaux\" role=\"img\" aria-labelledby=\"about\" viewBox=\"{left} {top} {width} {height}\" \
         style=\"--width:{width}\">\n<desc id=\"about\">{}: {}</desc>\n<g id=\"traces\">\n{}</g>\n\
         <g id=\"marks\">\n{marks}</g>\n{}</svg>\n{caption}",
        escaped(&recording.title),
        escaped(drawn.film.description()),
        still::traces(drawn),
        drawn.film.foot(),
    )
}

/// Everything that varies from frame to frame.
fn data(recording: &Recording, drawn: &Drawn) -> String {
    let (template, mut columns) = (&drawn.template, Columns::default());
    let elements = json::list(template.elements.iter().map(|one| element(one, &mut columns)));
    let traces = json::list(drawn.traces.iter().map(|places| {
        let axis = |part: usize| places.iter().map(|place| still::tenths(*place)[part]).collect::<Vec<i64>>();
        json::list([axis(0), axis(1)].map(|values| columns.number(&values).to_string()))
    }));
    let plots = recording.plots.iter().map(|plot| {
        let series = plot.series.iter().map(|series| {
            let values = json::list(series.values.iter().map(|value| json::number(*value, DIGITS)));
            let dotted = series.is_dotted.then(|| ("isDotted", "true".to_owned()));
            json::object([("name", json::text(&series.name)), ("values", values)].into_iter().chain(dotted))
        });
        json::object([("unit", json::text(&plot.unit)), ("series", json::list(series))])
    });
    let plots = json::list(plots);
    let whole = |values: &[usize]| encode(&values.iter().map(|value| *value as i64).collect::<Vec<i64>>());
    let abscissa = &recording.abscissa;
    let pace = recording.pace();
    json::object([
        ("name", json::text(&abscissa.name)),
        ("unit", json::text(&abscissa.unit)),
        ("isTime", abscissa.is_time.to_string()),
        ("lasting", json::number(pace.lasting, DIGITS)),
        ("speed", json::number(pace.speed, DIGITS)),
        ("colours", json::list(COLOURS.map(json::text))),
        ("elements", elements),
        ("traces", traces),
        ("columns", json::list(columns.all.iter().map(|column| json::text(&encode(column))))),
        ("orders", json::list(template.orders.iter().map(|order| json::text(&whole(order))))),
        ("order", json::text(&whole(&template.order))),
        ("values", json::list(abscissa.values.iter().map(|value| json::number(*value, TIME_DIGITS)))),
        ("plots", plots),
    ])
}

/// An element: constant attributes as texts, varying attributes as lists of texts and column numbers.
fn element(element: &Element, columns: &mut Columns) -> String {
    let attributes = element.attributes.iter().map(|attribute| {
        let mut parts: Vec<String> = Vec::new();
        let mut text = attribute.skeleton.texts.first().cloned().unwrap_or_default();
        for (column, next) in attribute.columns.iter().zip(attribute.skeleton.texts.iter().skip(1)) {
            match column.split_first() {
                Some((first, rest)) if rest.iter().any(|value| value != first) => {
                    parts.extend([json::text(&std::mem::take(&mut text)), columns.number(column).to_string()]);
                }
                Some((first, _)) => text += &crate::tokens::decimal(*first),
                None => {}
            }
            text += next;
        }
        parts.push(json::text(&text));
        (attribute.name, if attribute.moves() { json::list(parts) } else { json::text(&Template::attribute(attribute, 0)) })
    });
    let attributes = json::object(attributes.collect::<Vec<_>>());
    let fields = [("class", &element.class), ("title", &element.title), ("text", &element.text)];
    let fields = fields.into_iter().filter(|(_, text)| !text.is_empty()).map(|(name, text)| (name, json::text(text)));
    json::object([("tag", json::text(element.tag)), ("at", attributes)].into_iter().chain(fields))
}
