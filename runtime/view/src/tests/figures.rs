//! Figures show what their views plot, where their axes say.

use roxmltree::{Document, Node};

use super::{engine, turn, view};
use crate::figure::WIDTH;
use crate::figure::axis::Axis;
use crate::figure::diagram::{ABOVE, FINE, HEIGHT, LEFT, RIGHT};
use crate::{Unviewable, View};

/// Numbers on the axis over or up these values.
fn numbers(axis: &Axis) -> Vec<String> {
    axis.ticks().into_iter().map(|tick| axis.written(tick)).collect()
}

#[test]
fn numbers_are_round() {
    assert_eq!(numbers(&Axis::over(&[0.0, 4.0], "s")), ["0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0"]);
    assert_eq!(numbers(&Axis::over(&[-0.03, 0.07], "m")), ["−0.02", "0.00", "0.02", "0.04", "0.06"]);
    assert_eq!(numbers(&Axis::up([-3.0, 3.0].into_iter(), "")), ["−3", "−2", "−1", "0", "1", "2", "3"]);
    // Rounding of the last state does not cost its number.
    assert_eq!(numbers(&Axis::over(&[0.0, 1.0 - 1e-12], "s")).last().map(String::as_str), Some("1.0"));
}

#[test]
fn angles_have_parts_of_right_angles() {
    let steps = [(360.0, 45.0), (720.0, 90.0), (180.0, 30.0), (90.0, 15.0), (80.0, 10.0), (40.0, 5.0), (1080.0, 180.0), (7200.0, 1800.0)];
    for (range, step) in steps {
        assert_eq!(Axis::over(&[0.0, range], "°").step, step, "over {range}°");
    }
    assert_eq!(Axis::over(&[0.0, 360.0], "mm").step, 50.0);
}

#[test]
fn large_and_small_numbers_have_a_power_of_ten_in_the_unit() {
    let large = Axis::over(&[0.0, 2.5e6], "N");
    assert_eq!((large.unit().as_str(), numbers(&large)[1].as_str()), ("10⁶ N", "0.5"));
    let small = Axis::over(&[0.0, 4e-5], "");
    assert_eq!((small.unit().as_str(), numbers(&small)[1].as_str()), ("10⁻⁶", "5"));
    assert_eq!(Axis::over(&[0.0, 99_999.0], "N").unit(), "N");
}

#[test]
fn constants_and_nothing_have_axes_too() {
    for values in [vec![], vec![f64::NAN], vec![0.0, 0.0], vec![7.0], vec![7.0, 7.0 + 1e-15], vec![-1e300, 1e300]] {
        let axis = Axis::up(values.iter().copied(), "m");
        assert!((2..=9).contains(&axis.ticks().len()), "{values:?}: {axis:?}");
        assert!(values.iter().all(|value| value.is_nan() || axis.range.contains(value)), "{values:?}: {axis:?}");
    }
}

/// The diagrams of a figure.
fn diagrams<'a>(tree: &'a Document) -> Vec<Node<'a, 'a>> {
    tree.descendants().filter(|node| node.attribute("class") == Some("diagram")).collect()
}

/// The points of the curves of a diagram, in picture units from its corner.
fn curves(diagram: Node, colour: &str) -> Vec<Vec<[f64; 2]>> {
    let of_colour = |node: &Node| node.attribute("stroke").is_some_and(|stroke| stroke.eq_ignore_ascii_case(colour));
    let lines = diagram.descendants().filter(|node| node.tag_name().name() == "polyline").filter(of_colour);
    let number = |text: &str| text.parse::<f64>().expect("a number") / f64::from(FINE);
    let point = |pair: &str| pair.split_once(',').map(|(x, y)| [number(x), number(y)]).expect("a pair");
    lines.map(|line| line.attribute("points").unwrap_or_default().split_whitespace().map(point).collect()).collect()
}

/// The place of a point in a diagram whose axes have these ranges.
fn place([x, y]: [f64; 2], over: [f64; 2], up: [f64; 2]) -> [f64; 2] {
    let part = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
    [LEFT + part(x, over) * (WIDTH - 20.0 - LEFT - RIGHT), ABOVE + (1.0 - part(y, up)) * HEIGHT]
}

#[test]
fn points_are_where_the_axes_say() -> Result<(), Unviewable> {
    let states = [0.0, 1.0, 2.0, 3.0, 4.0];
    let view = View::new("Engine", states, |angle| *angle, |angle| engine(*angle)).plot("square", "m", |angle| angle * angle);
    let figure = view.figure(1, &[])?;
    let tree = Document::parse(&figure).expect("XML");
    let curves = curves(diagrams(&tree)[0], crate::still::COLOURS[0]);
    let Axis { range, .. } = Axis::up([0.0, 16.0].into_iter(), "m");
    assert!(range.start < 0.0 && range.end > 16.0);
    assert_eq!(curves.len(), 1);
    for (state, found) in states.into_iter().zip(&curves[0]) {
        let exact = place([state, state * state], [0.0, 4.0], [range.start, range.end]);
        let off = (found[0] - exact[0]).abs().max((found[1] - exact[1]).abs());
        // The frame of plotters ends a drawing unit earlier.
        assert!(off < 2.5 / f64::from(FINE), "{found:?} instead of {exact:?}");
    }
    Ok(())
}

#[test]
fn curves_have_gaps_where_there_are_no_values() -> Result<(), Unviewable> {
    let gap = |angle: &f64| if (2.0..3.0).contains(angle) { f64::NAN } else { *angle };
    let figure = view(60).plot("gap", "", gap).figure(0, &[])?;
    let tree = Document::parse(&figure).expect("XML");
    let all = diagrams(&tree);
    // One trace and three curves come before.
    let pieces = curves(all[2], crate::still::COLOURS[4]);
    assert_eq!(pieces.len(), 2);
    let finite = turn(60).iter().filter(|angle| gap(angle).is_finite()).count();
    assert_eq!(pieces.iter().map(Vec::len).sum::<usize>(), finite);
    // A value between two gaps is a dot.
    let alone = view(60).plot("alone", "", |angle| if *angle == 0.0 { 1.0 } else { f64::NAN }).figure(0, &[])?;
    let tree = Document::parse(&alone).expect("XML");
    assert_eq!(circles(diagrams(&tree)[2]).len(), 1);
    Ok(())
}

/// The circles of a diagram, in picture units.
fn circles(diagram: Node) -> Vec<[f64; 2]> {
    let circles = diagram.descendants().filter(|node| node.tag_name().name() == "circle");
    let number = |node: &Node, name: &str| node.attribute(name).and_then(|text| text.parse::<f64>().ok()).expect("a number");
    circles.map(|node| [number(&node, "cx"), number(&node, "cy")].map(|part| part / f64::from(FINE))).collect()
}

#[test]
fn independent_results_are_circles_on_the_curve_and_apart() -> Result<(), Unviewable> {
    let states: Vec<f64> = (0..=400).map(|state| 0.01 * f64::from(state)).collect();
    let view = View::new("Engine", states, |angle| *angle, |angle| engine(*angle));
    let view = view.plot("sine", "", |angle| angle.sin()).against("result", |angle| if *angle > 3.0 { f64::NAN } else { angle.sin() });
    let figure = view.figure(0, &[])?;
    let tree = Document::parse(&figure).expect("XML");
    let diagram = diagrams(&tree)[0];
    let (circles, curves) = (circles(diagram), curves(diagram, crate::still::COLOURS[0]));
    assert!((10..40).contains(&circles.len()), "{}", circles.len());
    let distance = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    for circle in &circles {
        assert!(curves[0].iter().any(|point| distance(point, circle) < 0.2), "{circle:?} is off the curve");
    }
    for pair in circles.windows(2) {
        assert!(distance(&pair[0], &pair[1]) > 15.0, "{pair:?}");
    }
    let end = place([3.0, 0.0], [0.0, 4.0], [0.0, 1.0])[0];
    assert!(circles.iter().all(|circle| circle[0] < end + 1.0), "there are no results after 3 s");
    Ok(())
}

#[test]
fn a_figure_is_a_still_with_its_diagrams() -> Result<(), Unviewable> {
    let figure = view(60).figure(7, &[20, 40])?;
    assert_eq!(figure, view(60).figure(7, &[20, 40])?, "it is the same on every run");
    let tree = Document::parse(&figure).expect("XML");
    assert_eq!(tree.root_element().attribute("width"), Some("540"));
    assert_eq!(diagrams(&tree).len(), 2);
    assert_eq!(figure.matches("class=\"pale\"").count(), 2);
    let still = view(60).still(7, &[20, 40])?;
    let shapes = still.split_once("fill=\"#fff\"/>").or_else(|| still.split_once("style=\"fill:#fff\"/>")).expect("paper").1;
    assert!(figure.contains(shapes.trim_end_matches("</svg>\n")), "the drawing is that of the still");
    assert!(!figure.contains("var("), "its colours are those of any program");
    for name in ["Engine", "pin", "height", "reach", "angle", "t in s", "in mm", "in rad"] {
        let texts = tree.descendants().filter(|node| node.tag_name().name() == "text");
        assert!(texts.filter_map(|node| node.text()).any(|text| text.trim() == name), "{name}");
    }
    Ok(())
}

#[test]
fn names_in_figures_are_escaped_and_have_room() -> Result<(), Unviewable> {
    let name = "a <b> & \"c\" of quite some length, so that two of them do not fit";
    let view = View::new("", turn(9), |angle| *angle, |angle| engine(*angle)).title(name).trace(name, |_| [0.0, 0.0]);
    let view = view.plot(name, name, |angle| *angle).and(name, |angle| *angle).over(name, name, |angle| *angle);
    let figure = view.figure(0, &[])?;
    let tree = Document::parse(&figure).expect("XML");
    let texts: Vec<Node> = tree.descendants().filter(|node| node.text() == Some(name) && node.tag_name().name() == "text").collect();
    let lines: Vec<_> = texts.iter().filter_map(|node| node.attribute("y")).collect();
    assert_eq!(lines.len(), 4, "the title, the trace and two curves");
    assert!(lines.windows(2).all(|pair| pair[0] != pair[1]), "each has a line of its own: {lines:?}");
    Ok(())
}

#[test]
fn results_of_one_name_are_named_once() -> Result<(), Unviewable> {
    let view = view(60).against("exact", |angle| *angle).against("exact", |angle| 2.0 * angle).against("other", |angle| 3.0 * angle);
    let figure = view.figure(0, &[])?;
    assert_eq!([figure.matches(">exact<").count(), figure.matches(">other<").count()], [1, 1]);
    Ok(())
}

#[test]
fn figures_refuse_what_pages_refuse() {
    let states = |angles: [f64; 3]| View::new("Engine", angles, |angle| *angle, |angle| engine(*angle));
    let message = |view: View<f64>| view.figure(0, &[]).expect_err("it cannot be shown").to_string();
    assert_eq!(message(View::new("Nothing", [], |_| 0.0, |_| engine(0.0))), "there is no picture: there is nothing to draw");
    assert_eq!(message(states([0.0, 1.0, 1.0])), "`t` does not increase at state 2");
    assert_eq!(message(states([0.0, 1.0, 2.0]).trace("pin", |angle| [1.0 / (angle - 1.0), 0.0])), "`pin` has no place at state 1");
}

/// A number near the largest one, and a title with a character that XML does not have.
#[test]
fn figures_of_any_numbers_and_names_are_drawn() -> Result<(), Unviewable> {
    let view = View::new("Engine\u{1} <no. 1>", turn(8), |angle| *angle, |angle| engine(*angle));
    let view = view.plot("far\u{0}", "m", |angle| if *angle > 1.0 { 1e308 } else { -1e308 }).plot("near", "m", |angle| *angle);
    let figure = view.figure(1, &[])?;
    let tree = Document::parse(&figure).expect("XML");
    assert!(tree.descendants().any(|node| node.text() == Some("Engine  <no. 1>")), "{figure}");
    Ok(())
}
