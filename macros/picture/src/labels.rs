//! Label placement: each label takes the best free place near the item that it names.
//!
//! A greedy search as in cartography (Christensen, Marks and Shieber, An empirical study of algorithms for point-feature label placement,
//! ACM Transactions on Graphics 14, 1995): candidates around the object, each with a cost for the shapes that it would cover.

use crate::canvas::{Canvas, DrawnItem, Ink, Layer, Near, Stroke, Subject, Wish};
use crate::plane::{Place, Rectangle, is_inside, place, polar};
use core::f64::consts::TAU;

/// In mechanisms with more bodies only the first element of an array is named.
pub(crate) const ALL_NAMED: usize = 20;

/// The height of a line of text.
pub(crate) const HEIGHT: f64 = 13.0;

/// The size of the letters.
pub(crate) const SIZE: f64 = 12.0;

/// A label whose best place costs more than this is omitted; the tooltip of the shape still gives the name.
const DEAREST: f64 = 60.0;

/// The same where bodies are crowded: a label covers no more than one of them.
const DEAREST_IN_A_CROWD: f64 = 12.0;

/// Cost of a label on the plate of another body.
const ON_PLATE: f64 = 1.2;

/// Cost of a body's name that is nearer to another body than to its own.
const AMBIGUOUS: f64 = 4.0;

/// Bonus for the place that the label had in the frame before.
const KEPT: f64 = 3.0;

/// A placed label.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) text: String,
    pub(crate) role: Subject,
    pub(crate) frame: Rectangle,
    /// Index of the chosen place among the candidates.
    choice: usize,
}

/// Places as many labels as there is room for, fewer in a crowd of bodies; `before` are the labels of the frame before, which keep their
/// places if possible.
pub(crate) fn labels(canvas: &Canvas, before: &[Placed], is_crowded: bool) -> Vec<Placed> {
    let dearest = if is_crowded { DEAREST_IN_A_CROWD } else { DEAREST };
    let mut wishes: Vec<&Wish> = canvas.wishes.iter().collect();
    // Labels with the fewest candidates come first.
    wishes.sort_by_key(|wish| wish.role);
    let obstacles: Vec<Obstacle> = canvas.items.iter().flat_map(obstacles).collect();
    let plate = |item: &DrawnItem| match (&item.shape, item.ink) {
        (Stroke::Closed(corners), Ink::Plate(_)) => Some(corners.clone()),
        _ => None,
    };
    let plates: Vec<Vec<Place>> = canvas.items.iter().filter_map(plate).collect();
    let mut placed: Vec<Placed> = Vec::new();
    for wish in wishes {
        let size = place(width(&wish.text), HEIGHT);
        let candidates = candidates(&wish.near, size);
        let reach = Rectangle::around(candidates.iter().flat_map(|(frame, _)| [frame.low, frame.high])).grown(8.0);
        let near: Vec<&Obstacle> = obstacles.iter().filter(|obstacle| reach.is_crossed(obstacle.a, obstacle.b)).collect();
        let others: Vec<Rectangle> = placed.iter().map(|other| other.frame.grown(1.5)).filter(|other| other.overlaps(reach)).collect();
        let kept = before.iter().find(|known| known.role == wish.role && known.text == wish.text).map(|known| known.choice);
        let cost = |(choice, (frame, base)): (usize, (Rectangle, f64))| {
            let base = if kept == Some(choice) { base - KEPT } else { base };
            let cost = base + covered(frame, &near, &others) + on_plate(wish.role, frame, &plates) + ambiguity(wish, frame, &canvas.wishes);
            (choice, frame, cost)
        };
        let best = candidates.into_iter().enumerate().map(cost).min_by(|a, b| a.2.total_cmp(&b.2));
        if let Some((choice, frame, cost)) = best
            && cost < dearest
        {
            placed.push(Placed { text: wish.text.clone(), role: wish.role, frame, choice });
        }
    }
    placed
}

/// Width of a text, estimated on the safe side from its letters.
pub(crate) fn width(text: &str) -> f64 {
    let letter = |letter: char| match letter {
        'i' | 'j' | 'l' | 't' | 'f' | 'r' | '.' | ',' | ':' | ';' | '[' | ']' | '(' | ')' | ' ' | '|' => 0.36,
        'm' | 'w' | 'M' | 'W' => 0.9,
        'A'..='Z' => 0.7,
        _ => 0.58,
    };
    SIZE * text.chars().map(letter).sum::<f64>() + 2.0
}

/// A segment that labels should not cover.
struct Obstacle {
    a: Place,
    b: Place,
    /// Half the width of its stroke, and a gap.
    half: f64,
    cost: f64,
}

fn obstacles(item: &DrawnItem) -> Vec<Obstacle> {
    let cost = match (item.layer, item.ink) {
        (Layer::Pin | Layer::Arrow | Layer::Block, _) => 9.0,
        (Layer::Ground, Ink::Thin) => 0.8,
        (_, Ink::Thin) => 3.0,
        (Layer::DrawnBody, Ink::Bar(_)) => 7.0,
        (Layer::Wheel, _) => 2.0,
        _ => 5.0,
    };
    let half = match item.ink {
        Ink::Bar(_) => 4.0,
        Ink::Plate(_) => 2.5,
        _ => 1.0,
    };
    // A small block is an obstacle inside as well, so its diagonals count.
    let diagonals = match (&item.shape, item.layer) {
        (Stroke::Closed(corners), Layer::Block) if corners.len() == 4 => vec![(corners[0], corners[2]), (corners[1], corners[3])],
        _ => Vec::new(),
    };
    let mut found: Vec<Obstacle> = item.shape.segments().into_iter().chain(diagonals).map(|(a, b)| Obstacle { a, b, half, cost }).collect();
    if let Stroke::Circle(..) | Stroke::Rigid(..) = item.shape {
        found.iter_mut().for_each(|part| part.cost *= 0.4);
    }
    found
}

/// Cost of the obstacles that a label in this place would cover; infinite over another label.
fn covered(frame: Rectangle, obstacles: &[&Obstacle], others: &[Rectangle]) -> f64 {
    if others.iter().any(|other| other.overlaps(frame)) {
        return f64::INFINITY;
    }
    // The box of a line of text is taller than most letters.
    let inner = frame.grown(-1.0);
    obstacles.iter().filter(|obstacle| inner.grown(obstacle.half).is_crossed(obstacle.a, obstacle.b)).map(|obstacle| obstacle.cost).sum()
}

/// Cost of a label on a plate; names of bodies may stand there.
fn on_plate(role: Subject, frame: Rectangle, plates: &[Vec<Place>]) -> f64 {
    let is_on = |plate: &Vec<Place>| is_inside(plate, frame.middle());
    if role != Subject::Body && plates.iter().any(is_on) { ON_PLATE } else { 0.0 }
}

/// Cost of a name that would be read as the name of a nearer body.
fn ambiguity(wish: &Wish, frame: Rectangle, wishes: &[Wish]) -> f64 {
    let Some(own) = distance(&wish.near, frame.middle()).filter(|_| wish.role == Subject::Body) else { return 0.0 };
    let others = wishes.iter().filter(|other| other.role == Subject::Body && other.text != wish.text);
    let nearest = others.filter_map(|other| distance(&other.near, frame.middle())).fold(f64::INFINITY, f64::min);
    if nearest < own { AMBIGUOUS } else { 0.0 }
}

/// Distance of a point from the labelled item, if the item has an outline.
fn distance(near: &Near, at: Place) -> Option<f64> {
    match near {
        Near::Segments(segments) => Some(segments.iter().map(|(a, b)| at.to_segment(*a, *b)).fold(f64::INFINITY, f64::min)),
        Near::Area(corners) if is_inside(corners, at) => Some(0.0),
        Near::Area(corners) => {
            let sides = corners.iter().zip(corners.iter().cycle().skip(1));
            Some(sides.map(|(a, b)| at.to_segment(*a, *b)).fold(f64::INFINITY, f64::min))
        }
        Near::Point(..) | Near::Rim(..) => None,
    }
}

/// Places where a label of this size may stand, with their costs.
fn candidates(near: &Near, size: Place) -> Vec<(Rectangle, f64)> {
    let at = |middle: Place, cost: f64| (Rectangle::centred(middle, size), cost);
    match near {
        Near::Point(point, gap) => around(*point, *gap, size),
        Near::Segments(segments) => {
            let mut found = Vec::new();
            for (a, b) in segments {
                let normal = (*b - *a).unit().perp();
                for (rank, part) in [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.05, 0.95].into_iter().enumerate() {
                    for normal in [normal, -normal] {
                        for (step, gap) in [7.0, 12.0, 20.0, 30.0].into_iter().enumerate() {
                            let beside = beside(normal, gap, size);
                            // A label above a segment is read more easily than one below.
                            let below = if normal.y > 0.0 { 0.3 } else { 0.0 };
                            found.push(at(*a + (*b - *a) * part + beside, rank as f64 * 0.35 + step as f64 * 2.0 + below));
                        }
                    }
                }
            }
            found
        }
        Near::Area(corners) => {
            let middle = corners.iter().fold(Place::default(), |sum, corner| sum + *corner) * (1.0 / corners.len() as f64);
            let frame = Rectangle::around(corners.iter().copied());
            let has_room = frame.size().x > size.x + 14.0 && frame.size().y > size.y + 14.0;
            let inner = has_room.then(|| at(middle, 0.0));
            let sides = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| (*a, *b)).collect();
            let outer = candidates(&Near::Segments(sides), size).into_iter().map(|(frame, cost)| (frame, cost + 1.0));
            inner.into_iter().chain(outer).collect()
        }
        Near::Rim(middle, radius) => {
            let outside = around(*middle, *radius + 3.0, size).into_iter().map(|(frame, cost)| (frame, cost + 1.0));
            let mut found: Vec<(Rectangle, f64)> = outside.collect();
            for part in [0.55, 0.4, 0.7] {
                found.extend((0..12).map(|step| at(*middle + polar(radius * part, TAU * f64::from(step) / 12.0), 0.0)));
            }
            let has_room = |(frame, _): &(Rectangle, f64)| {
                let corners = [frame.low, frame.high, place(frame.low.x, frame.high.y), place(frame.high.x, frame.low.y)];
                let distances = corners.map(|corner| (corner - *middle).norm());
                distances.iter().all(|distance| *distance < radius - 3.0) || distances.iter().all(|distance| *distance > *radius)
            };
            found.retain(has_room);
            found
        }
    }
}

/// Places around a point, the nearest ring first.
fn around(point: Place, gap: f64, size: Place) -> Vec<(Rectangle, f64)> {
    let mut found = Vec::new();
    for (ring, more) in [0.0, 5.0, 11.0, 19.0, 29.0, 41.0].into_iter().enumerate() {
        for step in 0..16 {
            // The upper right comes first, as in cartography.
            let angle = -TAU / 8.0 + TAU * f64::from(step) / 16.0;
            let turned = f64::from(if step <= 8 { step } else { 16 - step });
            let middle = point + beside(polar(1.0, angle), gap + more, size);
            found.push((Rectangle::centred(middle, size), ring as f64 * 2.2 + turned * 0.08));
        }
    }
    found
}

/// Vector from a point to the centre of a label at distance `gap` in a direction.
fn beside(direction: Place, gap: f64, size: Place) -> Place {
    let soft = |part: f64| (part * 1.6).clamp(-1.0, 1.0);
    direction * gap + place(soft(direction.x) * size.x / 2.0, soft(direction.y) * size.y / 2.0)
}
