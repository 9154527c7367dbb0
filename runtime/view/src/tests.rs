//! Every frame can be rebuilt from the written texts and columns.

use std::fs;

use reuleaux_picture::{Film, GROUND, Mark, Pose, Scene};

use crate::columns::{Columns, encode};
use crate::recording::Recording;
use crate::slots::slots;
use crate::template::Template;
use crate::tokens::{Meaning, decimal, join, split};
use crate::{Unviewable, View, json};

#[cfg(feature = "figure")]
mod figures;

/// A crank, a rod and a piston, the crank at `angle`.
fn engine(angle: f64) -> Scene {
    let (crank, rod) = (0.05, 0.2);
    let (sine, cosine) = angle.sin_cos();
    let tilt = -(crank / rod * sine).asin();
    let mut scene = Scene::new("Engine");
    scene.body("crank", Pose::plane(0.0, 0.0, angle));
    scene.body("rod", Pose::plane(crank * cosine, crank * sine, tilt));
    scene.body("piston", Pose::plane(crank * cosine + rod * tilt.cos(), 0.0, 0.0));
    scene.joint("o", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "crank", [0.0, 0.0]);
    scene.joint("a", "revolute").point("P", "crank", [crank, 0.0]).point("Q", "rod", [0.0, 0.0]);
    scene.joint("b", "revolute").point("P", "rod", [rod, 0.0]).point("Q", "piston", [0.0, 0.0]);
    let bore = scene.joint("bore", "translational");
    bore.axis("u", GROUND, [1.0, 0.0]).point("P", GROUND, [0.0, 0.0]).point("Q", "piston", [0.0, 0.0]);
    scene.drive("motor", "drive_angle", 1.0).body("b", "crank").number("C", angle);
    scene
}

/// Two bars in space that rotate about one axis and pass each other.
fn scissors(angle: f64) -> Scene {
    let mut scene = Scene::new("Scissors");
    let up = [0.0, 0.0, 1.0];
    for (name, angle, height) in [("one", angle, 0.1), ("two", -angle, 0.3)] {
        let (sine, cosine) = angle.sin_cos();
        scene.body(name, Pose::space([0.0; 3], [[cosine, -sine, 0.0], [sine, cosine, 0.0], up]));
        scene.point(name, [0.9, 0.0, height]);
        let hinge = scene.joint(&format!("hinge_{name}"), "revolute");
        hinge.point("P", GROUND, [0.0, 0.0, height]).axis("a", GROUND, up).point("Q", name, [0.0, 0.0, height]).axis("b", name, up);
    }
    scene
}

/// Angles of one revolution in so many states.
fn turn(states: u32) -> Vec<f64> {
    (0..states).map(|state| f64::from(state) * std::f64::consts::TAU / f64::from(states)).collect()
}

fn view(states: u32) -> View<f64> {
    let view = View::new("Engine", turn(states), |angle| *angle, |angle| engine(*angle));
    let view = view.trace("pin", |angle| [0.05 * angle.cos(), 0.05 * angle.sin()]);
    view.plot("height", "mm", |angle| 50.0 * angle.sin()).and("reach", |angle| 50.0 * angle.cos()).plot("angle", "rad", |angle| *angle)
}

/// The values of a column, decoded like in the page.
fn decoded(text: &str) -> Vec<i64> {
    let digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut values, mut value, mut quantity, mut shift) = (Vec::new(), 0_i64, 0_i64, 0);
    for letter in text.chars() {
        let digit = digits.find(letter).expect("a digit") as i64;
        quantity |= (digit & 31) << shift;
        shift += 5;
        if digit < 32 {
            value += if quantity & 1 == 1 { -(quantity >> 1) } else { quantity >> 1 };
            values.push(value);
            (quantity, shift) = (0, 0);
        }
    }
    values
}

#[test]
fn columns_come_back_from_their_text() {
    let far = vec![0, 15, -15, 16, -16, 100_000_000, -100_000_000, 1, 1, 0];
    let near: Vec<i64> = (0..1000).map(|frame| (300.0 * (0.02 * f64::from(frame)).sin()) as i64).collect();
    for column in [far, near.clone(), vec![], vec![-7]] {
        assert_eq!(decoded(&encode(&column)), column);
    }
    assert_eq!(encode(&near).len(), 1000, "what stays near itself takes one letter for each frame");
}

#[test]
fn equal_columns_are_stored_once() {
    let mut columns = Columns::default();
    assert_eq!([columns.number(&[1, 2]), columns.number(&[1, 3]), columns.number(&[1, 2])], [0, 1, 0]);
    assert_eq!(columns.all.len(), 2);
}

#[test]
fn attributes_come_back_from_their_parts() {
    for value in ["M12.5 -3L4 5 6.1 7Z", "M155 78.7A23 23 0 0 1 176.8 -111.1", "M1 2A9 4.5 -33.4 1 0 3 4Z", "0", "-0.5", ""] {
        let (skeleton, numbers) = split(value);
        assert_eq!(join(&skeleton, &numbers), value);
    }
    let (skeleton, numbers) = split("M1 2A9 4.5 -33.4 1 0 3 4Z");
    assert_eq!(numbers, [10, 20, 90, 45, -334, 30, 40], "flags stay words");
    assert_eq!(skeleton.meanings.iter().position(|meaning| *meaning == Meaning::HalfTurn), Some(4));
    assert_eq!([-1, 0, 10, -25, 99].map(decimal), ["-0.1", "0", "1", "-2.5", "9.9"]);
}

/// A mark as one line of text.
fn told(mark: &Mark) -> String {
    let geometry: Vec<String> = mark.geometry.iter().map(|(name, value)| format!("{name}={value}")).collect();
    [mark.tag, &mark.class, &mark.title, &mark.text, &geometry.join(" ")].join("|")
}

/// The marks of a frame rebuilt from the template, in its order.
fn made(template: &Template, frame: usize) -> Vec<String> {
    let element = |element: &crate::template::Element| {
        let attribute = |attribute: &crate::template::Attribute| format!("{}={}", attribute.name, Template::attribute(attribute, frame));
        let geometry: Vec<String> = element.attributes.iter().map(attribute).collect();
        [element.tag, &element.class, &element.title, &element.text, &geometry.join(" ")].join("|")
    };
    template.painted(frame).map(element).collect()
}

#[test]
fn a_template_makes_every_frame_again() -> Result<(), Unviewable> {
    let plane: Vec<Scene> = turn(60).into_iter().map(engine).collect();
    let space: Vec<Scene> = turn(60).into_iter().map(scissors).collect();
    for scenes in [plane, space] {
        let film = Film::of(&scenes, &[])?;
        let template = Template::of(&film);
        assert!(template.elements.len() < 2 * film.marks(0).len());
        for frame in 0..film.count() {
            let (marks, made) = (film.marks(frame), made(&template, frame));
            let mut drawn: Vec<(String, usize)> = marks.iter().map(told).zip(0..).collect();
            let order: Vec<usize> =
                made.iter().map(|mark| drawn.remove(drawn.iter().position(|(known, _)| known == mark).expect(mark)).1).collect();
            assert!(drawn.is_empty());
            for (upper, one) in order.iter().enumerate() {
                for other in order[..upper].iter().filter(|other| *other > one) {
                    let (one, other) = (&marks[*one], &marks[*other]);
                    let is_apart = (0..2).any(|axis| one.high[axis] <= other.low[axis] || other.high[axis] <= one.low[axis]);
                    assert!(is_apart, "in frame {frame} {one:?} lies on {other:?}");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn what_passes_in_front_is_painted_later() -> Result<(), Unviewable> {
    let scenes: Vec<Scene> = turn(60).into_iter().map(scissors).collect();
    let template = Template::of(&Film::of(&scenes, &[])?);
    assert!(template.orders.len() > 1, "the bars pass each other");
    Ok(())
}

#[test]
fn a_page_is_the_same_on_every_run_and_small() -> Result<(), Unviewable> {
    let page = view(1000).to_html()?;
    // Without optimisation a page of a thousand states takes seconds.
    assert_eq!(view(100).to_html()?, view(100).to_html()?);
    assert!(page.len() < 200_000, "{} bytes", page.len());
    Ok(())
}

#[test]
fn a_page_needs_nothing_else() -> Result<(), Unviewable> {
    let page = view(12).to_html()?;
    for reference in [" src=", "@import", "url(", "href=\"http", "import(", "fetch(", "XMLHttpRequest"] {
        assert!(!page.contains(reference), "{reference}");
    }
    assert!(page.contains("The above copyright notice and this permission notice shall be included"));
    assert!(!View::new("Still", [0.0], |_| 0.0, |_| engine(1.0)).to_html()?.contains("uPlot ="), "without plots there is no plotter");
    Ok(())
}

#[test]
fn names_cannot_leave_their_place() -> Result<(), Unviewable> {
    let name = "</script><script>alert(1)</script>\"&\\\u{2028}";
    let page = view(5).title(name).plot(name, name, |angle| *angle).trace(name, |_| [0.0, 0.0]).to_html()?;
    assert_eq!(page.matches("<script").count(), 3);
    assert_eq!(json::text("a<\"\n"), "\"a\\u003c\\\"\\u000a\"");
    Ok(())
}

#[test]
fn numbers_are_as_short_as_their_digits() {
    let values = [0.1 + 0.2, -1.5e-9, 1234567.89, 0.0, -0.0, f64::NAN, f64::INFINITY, 3e20];
    let texts = ["0.3", "-1.5e-9", "1234568", "0", "0", "null", "null", "3e20"];
    assert_eq!(values.map(|value| json::number(value, 7)), texts);
}

#[test]
fn an_animation_moves_without_scripts() -> Result<(), Unviewable> {
    let passing = View::new("Scissors", turn(240), |angle| angle.powi(2), |angle| scissors(*angle));
    for (view, groups) in [(view(240), 0), (passing, 2)] {
        let svg = view.animated_svg()?;
        let tree = roxmltree::Document::parse(&svg).expect("XML");
        let moving: Vec<_> = tree.descendants().filter(|node| node.tag_name().name() == "animate").collect();
        assert!(moving.len() > 10 && !svg.contains("<script"));
        assert!(moving.iter().filter(|node| node.attribute("attributeName") == Some("visibility")).count() >= groups);
        for animate in moving {
            let values = animate.attribute("values").map_or(0, |values| values.split(';').count());
            assert!((2..=63).contains(&values));
            let Some(times) = animate.attribute("keyTimes") else { continue };
            let times: Vec<f64> = times.split(';').map(|time| time.parse().expect("a number")).collect();
            let is_discrete = animate.attribute("calcMode").is_some();
            assert_eq!(times.len(), values);
            assert!(times[0] == 0.0 && times.is_sorted() && (is_discrete || times.last() == Some(&1.0)), "{times:?}");
        }
        assert_eq!(svg, view.animated_svg()?);
    }
    Ok(())
}

#[test]
fn an_animation_fits_its_size() -> Result<(), Unviewable> {
    let (whole, small) = (view(240).animated_svg()?, view(240).animated_svg_within(14_000)?);
    assert!(small.len() <= 14_000 && whole.len() > 14_000, "{} and {}", small.len(), whole.len());
    assert_eq!(view(240).animated_svg_within(whole.len())?, whole);
    Ok(())
}

#[test]
fn common_orders_contain_the_order_of_each_frame() -> Result<(), Unviewable> {
    let scenes: Vec<Scene> = turn(90).into_iter().map(scissors).collect();
    let template = Template::of(&Film::of(&scenes, &[])?);
    assert!(template.orders.len() > 2);
    let slots = slots(&template);
    for (frame, order) in template.order.iter().enumerate() {
        let shown: Vec<usize> = slots.iter().filter(|slot| slot.is_shown[frame]).map(|slot| slot.element).collect();
        assert_eq!(shown, template.orders[*order]);
    }
    let written = template.orders.iter().map(Vec::len).sum::<usize>();
    assert!(slots.len() < written / 2, "{} places for {written}", slots.len());
    Ok(())
}

#[test]
fn rigid_shapes_turn_between_frames() -> Result<(), Unviewable> {
    let svg = view(60).outline("crank", [[0.0, -0.01], [0.05, -0.01], [0.05, 0.01], [0.0, 0.01]]).animated_svg()?;
    let tree = roxmltree::Document::parse(&svg).expect("XML");
    let kinds: Vec<_> =
        tree.descendants().filter(|node| node.tag_name().name() == "animateTransform").filter_map(|node| node.attribute("type")).collect();
    assert_eq!(kinds, ["translate", "rotate"]);
    Ok(())
}

#[test]
fn a_still_has_pale_phases_below() -> Result<(), Unviewable> {
    let view = view(60);
    let svg = view.still(7, &[20, 40, 1000])?;
    let (pale, trace) = (svg.rfind("class=\"pale\"").expect("pale"), svg.find("class=\"trace\"").expect("a trace"));
    assert!(pale < trace && svg.matches("class=\"pale\"").count() == 3);
    let labels = |svg: &str| svg.matches("<text").count();
    assert_eq!(labels(&svg), labels(&view.still(7, &[])?), "phases have no names");
    Ok(())
}

#[test]
fn half_turns_do_not_leap() -> Result<(), Unviewable> {
    let scenes: Vec<Scene> = turn(90).into_iter().map(scissors).collect();
    let template = Template::of(&Film::of(&scenes, &[])?);
    let mut turning = 0;
    for attribute in template.elements.iter().flat_map(|element| &element.attributes) {
        for (column, meaning) in attribute.steady().iter().zip(&attribute.skeleton.meanings) {
            if *meaning == Meaning::HalfTurn {
                turning += 1;
                assert!(column.windows(2).all(|pair| (pair[1] - pair[0]).abs() <= 900), "{column:?}");
            }
        }
    }
    assert!(turning > 0);
    Ok(())
}

#[test]
fn what_cannot_be_shown_is_told() {
    let message = |view: View<f64>| view.to_html().expect_err("it cannot be shown").to_string();
    let states = |angles: [f64; 3]| View::new("Engine", angles, |angle| *angle, |angle| engine(*angle));
    assert_eq!(message(View::new("Nothing", [], |_| 0.0, |_| engine(0.0))), "there is no picture: there is nothing to draw");
    assert_eq!(message(states([0.0, 1.0, 1.0])), "`t` does not increase at state 2");
    assert_eq!(message(states([0.0, 1.0, 2.0]).over("crank", "°", |angle| -angle)), "`crank` does not increase at state 1");
    assert_eq!(message(states([0.0, 1.0, 2.0]).trace("pin", |angle| [1.0 / (angle - 1.0), 0.0])), "`pin` has no place at state 1");
}

#[test]
fn a_motion_is_played_at_a_speed_that_can_be_watched() {
    let pace = |span: f64, lasting: Option<f64>| {
        let view = View::new("Engine", [0.0, span], |time| *time, |_| engine(0.0));
        let view = if let Some(seconds) = lasting { view.lasting(seconds) } else { view };
        let pace = view.recording.pace();
        (pace.lasting, pace.speed)
    };
    assert_eq!(pace(4.0, None), (4.0, 1.0));
    assert_eq!(pace(0.05, None), (0.05, 0.02));
    assert_eq!(pace(3600.0, None), (3600.0, 200.0));
    assert_eq!(pace(4.0, Some(8.0)), (4.0, 0.5));
}

#[test]
fn thinned_motions_keep_their_ends() {
    let Recording { abscissa, scenes, .. } = view(1000).recording.thinned(61);
    let all = turn(1000);
    assert_eq!((abscissa.values.len(), scenes.len()), (61, 61));
    assert_eq!((abscissa.values.first(), abscissa.values.last()), (all.first(), all.last()));
    assert_eq!(view(61).recording.thinned(61).scenes.len(), 61);
}

#[test]
fn frames_are_files_that_any_program_understands() -> Result<(), Unviewable> {
    let folder = std::env::temp_dir().join(format!("reuleaux-view-{}", std::process::id()));
    view(12).svg_frames(&folder)?;
    let mut names: Vec<String> =
        fs::read_dir(&folder)?.map(|file| Ok(file?.file_name().to_string_lossy().into_owned())).collect::<Result<_, std::io::Error>>()?;
    names.sort();
    let (first, last) = (fs::read_to_string(folder.join("0000.svg"))?, fs::read_to_string(folder.join("0011.svg"))?);
    fs::remove_dir_all(&folder)?;
    assert_eq!(names.len(), 12);
    assert_eq!(first.lines().next(), last.lines().next(), "they have one size");
    assert!(first != last && !first.contains("var("));
    roxmltree::Document::parse(&first).expect("XML");
    Ok(())
}

#[cfg(feature = "png")]
#[test]
fn frames_have_pixels() -> Result<(), Unviewable> {
    let folder = std::env::temp_dir().join(format!("reuleaux-view-png-{}", std::process::id()));
    match view(2).png_frames(&folder, 640) {
        Err(Unviewable::NoFont) => return Ok(()),
        written => written?,
    }
    let png = fs::read(folder.join("0001.png"))?;
    fs::remove_dir_all(&folder)?;
    assert_eq!(&png[1..4], b"PNG");
    assert_eq!(png[16..20], 640_u32.to_be_bytes());
    Ok(())
}

#[cfg(feature = "png")]
#[test]
fn a_frame_too_large_for_memory_is_an_error() {
    let folder = std::env::temp_dir().join(format!("reuleaux-view-large-{}", std::process::id()));
    let refused = view(2).png_frames(&folder, 4_000_000);
    assert!(matches!(refused, Err(Unviewable::Pixels(_) | Unviewable::NoFont)), "{refused:?}");
    fs::remove_dir_all(&folder).expect("the folder is made first");
}

#[test]
fn independent_results_are_marked_in_the_page() -> Result<(), Unviewable> {
    let view = view(12).against("closed form", |angle| angle + 0.0);
    let [.., plot] = view.recording.plots.as_slice() else { panic!("there are diagrams") };
    assert_eq!(plot.series.iter().map(|series| series.is_dotted).collect::<Vec<_>>(), [false, true]);
    assert_eq!(plot.series[0].values, plot.series[1].values);
    assert_eq!(view.to_html()?.matches("\"isDotted\":true").count(), 1);
    let alone = View::new("Engine", turn(3), |angle| *angle, |angle| engine(*angle)).against("result", |angle| *angle);
    assert_eq!(alone.recording.plots.len(), 1);
    Ok(())
}
