//! Projected shapes: lines, areas, cylinders, boxes and balls.

use super::vector::Vec3;
use super::view::Sight;
use crate::canvas::{DrawnItem, Ink, Layer, Stroke};
use crate::plane::{Place, hull, place};
use core::f64::consts::TAU;

/// Draws the shapes of one item.
pub(crate) struct Pen<'a> {
    pub(crate) sight: &'a Sight,
    pub(crate) title: String,
    pub(crate) items: Vec<DrawnItem>,
}

impl Pen<'_> {
    fn draw(&mut self, layer: Layer, ink: Ink, shape: Stroke) {
        self.items.push(DrawnItem { layer, ink, shape, title: self.title.clone() });
    }

    fn seen(&self, places: &[Vec3]) -> Vec<Place> {
        places.iter().map(|at| self.sight.at(*at)).collect()
    }

    pub(crate) fn line(&mut self, layer: Layer, ink: Ink, places: &[Vec3]) {
        self.draw(layer, ink, Stroke::Open(vec![self.seen(places)]));
    }

    pub(crate) fn lines(&mut self, layer: Layer, ink: Ink, lines: &[Vec<Vec3>]) {
        self.draw(layer, ink, Stroke::Open(lines.iter().map(|line| self.seen(line)).collect()));
    }

    pub(crate) fn area(&mut self, layer: Layer, ink: Ink, corners: &[Vec3]) {
        self.draw(layer, ink, Stroke::Closed(self.seen(corners)));
    }

    /// An arrow head with its tip at `tip`.
    pub(crate) fn head(&mut self, tip: Vec3, along: Vec3) {
        let (tip, way) = (self.sight.at(tip), self.sight.at(along));
        if way.norm() > 1e-3 {
            let (back, side) = (tip - way.unit() * 9.0, way.unit().perp() * 3.4);
            self.draw(Layer::Arrow, Ink::Solid, Stroke::Closed(vec![tip, back + side, back - side]));
        }
    }

    /// A ball.
    pub(crate) fn ball(&mut self, ink: Ink, at: Vec3, radius: f64) {
        self.draw(Layer::Pin, ink, Stroke::Circle(self.sight.at(at), radius));
    }

    /// Part of a circle in the plane of projection.
    pub(crate) fn arc(&mut self, ink: Ink, at: Vec3, radius: f64, from: f64, to: f64) {
        self.draw(Layer::Pin, ink, Stroke::Arc(self.sight.at(at), radius, from, to));
    }

    /// Projection of a circle: semi-major axis as a vector, length of the semi-minor axis.
    fn ellipse(&self, normal: Vec3, radius: f64) -> (Place, f64) {
        let axis = self.sight.at(normal);
        let major = if axis.norm() > 1e-6 { axis.unit().perp() } else { place(1.0, 0.0) };
        (major * radius, self.sight.depth(normal).abs() * radius)
    }

    /// A disc.
    pub(crate) fn disc(&mut self, layer: Layer, ink: Ink, at: Vec3, normal: Vec3, radius: f64) {
        let (major, minor) = self.ellipse(normal, radius);
        self.draw(layer, ink, Stroke::Ellipse(self.sight.at(at), major, minor));
    }

    /// A cylinder between two points, without the highlight on its end.
    pub(crate) fn mantle(&mut self, layer: Layer, ink: Ink, from: Vec3, to: Vec3, radius: f64) {
        let (major, minor) = self.ellipse((to - from).unit(), radius);
        self.draw(layer, ink, Stroke::Tube([self.sight.at(from), self.sight.at(to)], major, minor));
    }

    /// A cylinder between two points.
    pub(crate) fn tube(&mut self, layer: Layer, ink: Ink, from: Vec3, to: Vec3, radius: f64) {
        self.mantle(layer, ink, from, to, radius);
        let front = if self.sight.depth(to - from) >= 0.0 { to } else { from };
        self.disc(layer, Ink::Shine, front, (to - from).unit(), radius);
    }

    /// A box, by its centre and its three half edges.
    pub(crate) fn block(&mut self, ink: Ink, middle: Vec3, halves: [Vec3; 3]) {
        let toward = halves.map(|half| if self.sight.depth(half) >= 0.0 { half } else { -half });
        let corner = |a: f64, b: f64, c: f64| middle + toward[0] * a + toward[1] * b + toward[2] * c;
        let sign = |bit: u32| if bit.is_multiple_of(2) { 1.0 } else { -1.0 };
        let corners = (0..8_u32).map(|number| corner(sign(number), sign(number >> 1), sign(number >> 2)));
        let outline: Vec<Place> = corners.map(|at| self.sight.at(at)).collect();
        self.draw(Layer::Pin, ink, Stroke::Closed(hull(&outline)));
        // Light comes from above.
        let top = (0..3).max_by(|a, b| toward[*a].unit().z.total_cmp(&toward[*b].unit().z)).unwrap_or(2);
        let (one, two) = (toward[(top + 1) % 3], toward[(top + 2) % 3]);
        let face = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)].map(|(a, b)| middle + toward[top] + one * a + two * b);
        self.area(Layer::Pin, Ink::Shine, &face);
        let near = corner(1.0, 1.0, 1.0);
        self.line(Layer::Pin, Ink::Thin, &[near, near - toward[top] * 2.0]);
    }

    /// The visible half of one turn of a thread.
    pub(crate) fn half_turn(&self, at: Vec3, axis: Vec3, radius: f64, pitch: f64) -> Vec<Vec3> {
        let toward = self.sight.camera.toward.across(axis).direction().unwrap_or_else(|| axis.frame().0);
        let side = axis.cross(toward);
        let place = |step: i32| {
            let (sine, cosine) = libm::sincos(TAU * f64::from(step) / 16.0);
            at + (side * sine + toward * cosine) * radius + axis * (pitch * f64::from(step) / 16.0)
        };
        [-4, -2, 0, 2, 4].map(place).to_vec()
    }

    /// Points on part of a circle in space: from `x` towards `y`, two perpendicular unit vectors.
    pub(crate) fn on_circle(middle: Vec3, [x, y]: [Vec3; 2], radius: f64, from: f64, to: f64) -> Vec<Vec3> {
        let steps = ((to - from).abs() / TAU * 32.0).ceil().max(2.0) as usize;
        let at = |step: usize| {
            let (sine, cosine) = libm::sincos(from + (to - from) * step as f64 / steps as f64);
            middle + (x * cosine + y * sine) * radius
        };
        (0..=steps).map(at).collect()
    }
}
