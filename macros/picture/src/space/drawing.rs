//! From a spatial scene to shapes, from back to front.
//!
//! Symbols have one size in the picture, whatever the size of the mechanism: the scene is scaled to picture units before the projection.

use super::customs::Customs;
use super::pen::Pen;
use super::placed::{Placed, Sign};
use super::symbols::SIZE;
use super::vector::Vec3;
use super::view::Sight;
use super::wheels::Wheels;
use crate::canvas::{Canvas, DrawnItem, Ink, Layer, Near, Stroke, Subject};
use crate::labels::ALL_NAMED;
use crate::pins::together;
use crate::plane::{Place, hull};

/// Places nearer to each other than this coincide in the picture.
pub(crate) const NEAR: f64 = 1.0;

/// Points nearer to a plane than this lie in it.
const FLAT: f64 = 4.0;

/// Bars whose depths differ by less than this meet instead of passing each other.
const PASSING: f64 = 5.0;

/// Shapes with a common depth.
struct Piece {
    depth: f64,
    items: Vec<DrawnItem>,
}

/// A straight segment of a body or of a rod.
#[derive(Clone, Copy, Debug)]
struct Bar {
    ends: [Vec3; 2],
    ink: Ink,
    body: Option<usize>,
}

/// A body while the picture is drawn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shape {
    /// Points, each with the position where links to it end.
    pub(crate) ends: Vec<(Vec3, Vec3)>,
    /// Segments besides the links between the points.
    pub(crate) bars: Vec<(Vec3, Vec3)>,
    /// True if another symbol shows the position of the body.
    pub(crate) is_shown: bool,
}

/// A drawing in progress.
pub(crate) struct Drawing<'a> {
    pub(crate) scene: &'a Placed,
    pub(crate) sight: &'a Sight,
    pub(crate) customs: &'a Customs,
    pub(crate) wheels: &'a Wheels,
    /// Indexed by body.
    pub(crate) shapes: Vec<Shape>,
    pub(crate) canvas: Canvas,
    pieces: Vec<Piece>,
    bars: Vec<Bar>,
    /// Names of joints by place.
    names: Vec<(Vec3, Vec<String>)>,
    /// Sleeves and blocks, which may carry other joints: position and depth.
    pub(crate) tops: Vec<(Vec3, f64)>,
    /// Curved arrows: position and side.
    pub(crate) arrows: Vec<(Vec3, Vec3)>,
}

/// Draws a scene in units of the picture.
pub(crate) fn draw(scene: &Placed, sight: &Sight, customs: &Customs) -> Canvas {
    let wheels = Wheels::of(scene);
    let mut drawing = Drawing {
        scene,
        sight,
        customs,
        wheels: &wheels,
        shapes: scene.bodies.iter().map(|body| shape(&body.points)).collect(),
        canvas: Canvas { is_in_space: true, ..Canvas::default() },
        pieces: Vec::new(),
        bars: Vec::new(),
        names: Vec::new(),
        tops: Vec::new(),
        arrows: Vec::new(),
    };
    (0..scene.joints.len()).for_each(|joint| drawing.prepare(joint));
    wheels.show(&mut drawing);
    drawing.outlines();
    (0..scene.bodies.len()).for_each(|body| drawing.body(body));
    // Guides are drawn first: their depth decides that of joints on them.
    let is_guide = |joint: &usize| ["translational", "cylindrical", "screw", "planar"].contains(&scene.joints[*joint].kind.as_str());
    (0..scene.joints.len()).filter(is_guide).for_each(|joint| drawing.joint(joint));
    (0..scene.joints.len()).filter(|joint| !is_guide(joint)).for_each(|joint| drawing.joint(joint));
    wheels.draw(&mut drawing);
    (0..scene.joints.len()).for_each(|joint| drawing.drive(joint));
    drawing.outputs();
    drawing.crossings();
    drawing.finish()
}

fn shape(points: &[Vec3]) -> Shape {
    let mut ends: Vec<(Vec3, Vec3)> = Vec::new();
    for at in points {
        if ends.iter().all(|(known, _)| (*known - *at).norm() > NEAR) {
            ends.push((*at, *at));
        }
    }
    Shape { ends, ..Shape::default() }
}

impl Shape {
    /// Direction from one point to the mean of the others, perpendicular to `axis`.
    pub(crate) fn away(&self, from: Vec3, axis: Vec3) -> Option<Vec3> {
        let others: Vec<Vec3> = self.ends.iter().map(|(at, _)| *at).filter(|at| (*at - from).norm() > NEAR).collect();
        let bars = self.bars.iter().filter(|(one, _)| (*one - from).norm() < NEAR).map(|(_, two)| *two);
        let others: Vec<Vec3> = others.into_iter().chain(bars).collect();
        if others.is_empty() {
            return None;
        }
        let way = (Vec3::middle(&others) - from).across(axis);
        if way.norm() > 2.0 { way.direction() } else { None }
    }

    /// Ends the links to point `at` at `end`.
    pub(crate) fn end_at(&mut self, at: Vec3, end: Vec3) {
        if let Some(own) = self.ends.iter_mut().find(|(known, _)| (*known - at).norm() < NEAR) {
            own.1 = end;
        }
    }
}

impl<'a> Drawing<'a> {
    pub(crate) fn pen(&self, title: &str) -> Pen<'a> {
        Pen { sight: self.sight, title: title.to_owned(), items: Vec::new() }
    }

    /// Adds the shapes of a pen at a depth.
    pub(crate) fn put(&mut self, depth: f64, pen: Pen) {
        self.pieces.push(Piece { depth, items: pen.items });
    }

    /// Adds the shapes of a pen in front of the links that end at a place.
    pub(crate) fn put_on(&mut self, at: Vec3, pen: Pen) {
        let depth = self.depth_on(at);
        self.put(depth, pen);
    }

    /// Depth slightly in front of the links that end at a place.
    pub(crate) fn depth_on(&self, at: Vec3) -> f64 {
        let halves = self.bars.iter().flat_map(|bar| [(bar.ends[0], bar.ends[1]), (bar.ends[1], bar.ends[0])]);
        let own = halves.filter(|(one, _)| (*one - at).norm() < 16.0).map(|(one, two)| self.sight.depth(one * 0.75 + two * 0.25));
        let tops = self.tops.iter().filter(|(known, _)| (*known - at).norm() < 8.0).map(|(_, depth)| *depth);
        own.chain(tops).fold(self.sight.depth(at), f64::max) + 0.5
    }

    /// True if a link leaves a place in this direction.
    pub(crate) fn is_taken(&self, at: Vec3, way: Vec3) -> bool {
        let ends = self.bars.iter().flat_map(|bar| [(bar.ends[0], bar.ends[1]), (bar.ends[1], bar.ends[0])]);
        ends.into_iter().any(|(one, two)| (one - at).norm() < 1.6 * SIZE && (two - one).unit().dot(way) > 0.9)
    }

    /// Records the name of a joint at a place.
    pub(crate) fn name(&mut self, at: Vec3, name: &str) {
        match self.names.iter_mut().find(|(known, _)| (*known - at).norm() < NEAR) {
            Some((_, names)) => names.push(name.to_owned()),
            None => self.names.push((at, vec![name.to_owned()])),
        }
    }

    /// `o: revolute of ground and crank`; the name alone in a mechanism of very many bodies.
    pub(crate) fn title(&self, joint: &Sign) -> String {
        if self.scene.bodies.len() > ALL_NAMED {
            return joint.name.clone();
        }
        let kind = if joint.kind.is_empty() { "equation" } else { &joint.kind };
        let names: Vec<&str> = joint.bodies.iter().map(|body| self.scene.name(*body)).collect();
        match names.as_slice() {
            [] => format!("{}: {kind}", joint.name),
            [one] => format!("{}: {kind} of {one}", joint.name),
            [rest @ .., last] => format!("{}: {kind} of {} and {last}", joint.name, rest.join(", ")),
        }
    }

    /// Draws a straight segment in two halves, each with its own depth.
    pub(crate) fn bar(&mut self, title: &str, layer: Layer, ink: Ink, body: Option<usize>, one: Vec3, two: Vec3) {
        let middle = (one + two) * 0.5;
        for (from, to) in [(one, middle), (middle, two)] {
            let mut pen = self.pen(title);
            pen.line(layer, ink, &[from, to]);
            self.put(self.sight.depth((from + to) * 0.5), pen);
        }
        self.bars.push(Bar { ends: [one, two], ink, body });
    }

    /// Draws a body as links, as a plate, or as a dot.
    fn body(&mut self, number: usize) {
        let (name, shape) = (self.scene.bodies[number].name.clone(), self.shapes[number].clone());
        let points: Vec<Vec3> = shape.ends.iter().map(|(at, _)| *at).collect();
        let mut links: Vec<(Vec3, Vec3)> = Vec::new();
        let mut near = None;
        if let Some(corners) = plate(&points) {
            let seen: Vec<Place> = hull(&corners.iter().map(|at| self.sight.at(*at)).collect::<Vec<_>>());
            let item =
                DrawnItem { layer: Layer::DrawnBody, ink: Ink::Plate(number), shape: Stroke::Closed(seen.clone()), title: name.clone() };
            let depth = self.sight.depth(Vec3::middle(&corners));
            self.pieces.push(Piece { depth, items: vec![item] });
            links.extend(shape.ends.iter().filter(|(at, end)| (*at - *end).norm() > NEAR).copied());
            near = Some(Near::Area(seen));
        } else {
            links = tree(&shape.ends.iter().map(|(_, end)| *end).collect::<Vec<_>>());
        }
        links.extend(&shape.bars);
        for (one, two) in &links {
            self.bar(&name, Layer::DrawnBody, Ink::Bar(number), Some(number), *one, *two);
        }
        let segments: Vec<(Place, Place)> = links.iter().map(|(one, two)| (self.sight.at(*one), self.sight.at(*two))).collect();
        let at = shape.ends.first().map_or(self.scene.bodies[number].origin, |(at, _)| *at);
        if links.is_empty() && near.is_none() && !shape.is_shown {
            let mut pen = self.pen(&name);
            pen.ball(Ink::Block(number), at, 4.0);
            self.put(self.sight.depth(at), pen);
        }
        let beside = || if segments.is_empty() { Near::Point(self.sight.at(at), 13.0) } else { Near::Segments(segments) };
        self.canvas.wish(Subject::Body, &name, near.unwrap_or_else(beside));
    }

    /// Draws the shapes of bodies.
    fn outlines(&mut self) {
        for (body, corners) in &self.scene.outlines {
            let mut pen = self.pen(self.scene.name(*body));
            pen.area(Layer::Wheel, Ink::Wheel(body.unwrap_or(usize::MAX)), corners);
            self.put(self.sight.depth(Vec3::middle(corners)), pen);
            if let Some(body) = body {
                self.shapes[*body].is_shown = true;
            }
        }
    }

    fn outputs(&mut self) {
        for (name, at) in &self.scene.outputs {
            if self.names.iter().any(|(known, _)| (*known - *at).norm() < 4.0) {
                continue;
            }
            let mut pen = self.pen(name);
            let arm = |x: f64, y: f64| {
                let way = self.sight.camera.right * x + self.sight.camera.up * y;
                vec![*at - way * 4.0, *at + way * 4.0]
            };
            pen.lines(Layer::Pin, Ink::Line, &[arm(1.0, 1.0), arm(1.0, -1.0)]);
            self.put_on(*at, pen);
            self.canvas.wish(Subject::Output, name, Near::Point(self.sight.at(*at), 6.0));
        }
    }

    /// Interrupts bars where another body's bar passes in front of them.
    fn crossings(&mut self) {
        let bars = self.bars.clone();
        for (index, one) in bars.iter().enumerate() {
            for two in &bars[..index] {
                if let (Some(a), Some(b)) = (one.body, two.body)
                    && a == b
                {
                    continue;
                }
                let Some([of_one, of_two]) = self.crossing(one.ends, two.ends) else { continue };
                let (at_one, at_two) = (along(one.ends, of_one), along(two.ends, of_two));
                let (depth, other) = (self.sight.depth(at_one), self.sight.depth(at_two));
                if (depth - other).abs() < PASSING {
                    continue;
                }
                let (front, at, back) = if depth > other { (*one, of_one, *two) } else { (*two, of_two, *one) };
                let seen = (self.sight.at(front.ends[1]) - self.sight.at(front.ends[0])).norm();
                let reach = |units: f64| [at - units / seen, at + units / seen].map(|part| along(front.ends, part.clamp(0.0, 1.0)));
                let mut pen = self.pen("");
                let (halo, over) = (reach(8.0), reach(9.5));
                pen.line(Layer::DrawnBody, Ink::Halo, &halo);
                pen.line(Layer::DrawnBody, front.ink, &over);
                let halves = [front.ends, back.ends].into_iter().flat_map(|[a, b]| [(a, b), (b, a)]);
                let nearest = halves.map(|(a, b)| self.sight.depth(a * 0.75 + b * 0.25)).fold(depth.max(other), f64::max);
                self.put(nearest + 0.25, pen);
            }
        }
    }

    /// Crossing of two segments in the projection, as fractions of their lengths; `None` near their ends.
    fn crossing(&self, [a, b]: [Vec3; 2], [c, d]: [Vec3; 2]) -> Option<[f64; 2]> {
        let [a, b, c, d] = [a, b, c, d].map(|at| self.sight.at(at));
        let (v, w) = (b - a, d - c);
        let cross = v.cross(w);
        if cross.abs() < 0.05 * v.norm() * w.norm() {
            return None;
        }
        let (s, t) = ((c - a).cross(w) / cross, (c - a).cross(v) / cross);
        let is_inside = |part: f64, length: f64| part * length > SIZE / 2.0 && (1.0 - part) * length > SIZE / 2.0;
        (is_inside(s, v.norm()) && is_inside(t, w.norm())).then_some([s, t])
    }

    /// Sorts all shapes by depth and places the names of joints.
    fn finish(mut self) -> Canvas {
        for (at, names) in std::mem::take(&mut self.names) {
            // In the order of declaration.
            let mut names = names;
            names.sort_by_key(|name| self.scene.joints.iter().position(|joint| joint.name == *name));
            let names = together(names.iter().map(String::as_str));
            self.canvas.wish(Subject::Joint, &names, Near::Point(self.sight.at(at), 10.0));
        }
        // Depths are rounded, so that rounding errors do not change the order of shapes at equal depth.
        self.pieces.sort_by_key(|piece| (piece.depth * 8.0).round() as i64);
        self.canvas.items = self.pieces.into_iter().flat_map(|piece| piece.items).collect();
        self.canvas
    }
}

fn along([from, to]: [Vec3; 2], part: f64) -> Vec3 {
    from + (to - from) * part
}

/// The points, if they are coplanar but not collinear.
fn plate(points: &[Vec3]) -> Option<Vec<Vec3>> {
    let first = *points.first()?;
    let far = |away: &dyn Fn(Vec3) -> f64| points.iter().copied().max_by(|a, b| away(*a).total_cmp(&away(*b)));
    let one = (far(&|at| (at - first).norm())? - first).direction()?;
    let side = (far(&|at| (at - first).across(one).norm())? - first).across(one);
    let normal = one.cross(side.direction()?);
    let is_flat = points.iter().all(|at| (*at - first).dot(normal).abs() < FLAT);
    (side.norm() > 2.0 * FLAT && is_flat).then(|| points.to_vec())
}

/// Minimum spanning tree of the places.
fn tree(places: &[Vec3]) -> Vec<(Vec3, Vec3)> {
    let mut links = Vec::new();
    let mut reached: Vec<Vec3> = places.first().copied().into_iter().collect();
    let mut rest: Vec<Vec3> = places.iter().skip(1).copied().collect();
    while !rest.is_empty() {
        let mut best = (f64::INFINITY, 0, Vec3::default());
        for (index, to) in rest.iter().enumerate() {
            for from in &reached {
                if (*to - *from).norm() < best.0 - 1e-6 {
                    best = ((*to - *from).norm(), index, *from);
                }
            }
        }
        let to = rest.swap_remove(best.1);
        if (to - best.2).norm() > NEAR && best.0.is_finite() {
            links.push((best.2, to));
        }
        reached.push(to);
    }
    links
}
