//! Outlines of links.

use std::f64::consts::{PI, TAU};

use super::{Place, place, polar};

/// Corners of a circle.
const CIRCLE: u32 = 24;

/// Corners of a rectangle about `centre` (m), rotated by `angle` (rad), with these sides (m).
#[must_use]
pub fn rectangle(centre: Place, angle: f64, width: f64, height: f64) -> [Place; 4] {
    let (along, across) = (polar(width / 2.0, angle), polar(height / 2.0, angle + PI / 2.0));
    [centre - along - across, centre + along - across, centre + along + across, centre - along + across]
}

/// Outline of the convex hull of the points, widened by a disc of this radius: a link with round ends.
pub(super) fn rounded_hull(points: &[Place], radius: f64) -> Vec<Place> {
    let hull = hull(points);
    // A link seen from its end has no edge with a direction.
    if hull.iter().all(|corner| *corner == hull[0]) {
        return (0..CIRCLE).map(|k| hull[0] + polar(radius, TAU * f64::from(k) / f64::from(CIRCLE))).collect();
    }
    let direction = |i: usize| {
        let edge = hull[(i + 1) % hull.len()] - hull[i % hull.len()];
        edge.y.atan2(edge.x) - PI / 2.0
    };
    let corner = |i: usize| {
        let (first, last) = (direction(i + hull.len() - 1), direction(i));
        let turn = (last - first).rem_euclid(TAU);
        let arcs = (turn / 0.3).ceil().max(1.0);
        let centre = hull[i];
        (0..=arcs as usize).map(move |k| centre + polar(radius, first + turn * k as f64 / arcs))
    };
    (0..hull.len()).flat_map(corner).collect()
}

/// The convex hull, counter-clockwise (Andrew's monotone chain).
fn hull(points: &[Place]) -> Vec<Place> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    let chain = |points: &mut dyn Iterator<Item = Place>| {
        let mut chain: Vec<Place> = Vec::new();
        for point in points {
            while let [.., p, q] = chain[..]
                && (q - p).perp(&(point - q)) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let (lower, upper) = (chain(&mut sorted.iter().copied()), chain(&mut sorted.iter().rev().copied()));
    [lower, upper].concat()
}

/// Hatching of a wall from `from` to `to`, on its right-hand side, `step` apart and as long.
pub(super) fn hatching(from: Place, to: Place, step: f64) -> Vec<[Place; 2]> {
    let length = (to - from).norm();
    let along = (to - from) / length;
    let (count, slope) = ((length / step).floor(), (along + place(along.y, -along.x)) * step * 0.8);
    (0..count as usize)
        .map(|k| from + along * (length * (k as f64 + 0.7) / count))
        .map(|foot| [foot, foot - along * step * 0.8 * 2.0 + slope])
        .collect()
}
