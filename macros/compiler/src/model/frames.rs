//! Bodies and ground: coordinates, points and axes fixed in them, start values.

use super::dimension::{Dim, Measure};
use super::elaborate::{Elaborator, Scope};
use super::names::{Frame, Mark, Progress};
use super::suggest::nearest;
use super::value::{Fixed, FrameId, Value};
use super::{Body, Coordinate};
use crate::diag::Fact;
use crate::expr::{Expr, Leaf};
use crate::syntax::ast::{self, Item};
use std::collections::BTreeMap;
use std::rc::Rc;

impl Elaborator<'_> {
    /// A frame with three fresh coordinates.
    pub(super) fn new_frame(&mut self, name: &str) -> FrameId {
        let first = 3 * (self.names.frames.len() as u32 - 1);
        let coordinates = [0, 1, 2].map(|offset| self.arena.leaf(Leaf::Coordinate(first + offset)));
        self.names.frames.push(Frame { name: name.to_owned(), coordinates: Some(coordinates), marks: BTreeMap::new(), order: Vec::new() });
        FrameId(self.names.frames.len() - 1)
    }

    pub(super) fn fill(&mut self, id: FrameId, frame: &ast::Frame) {
        for mark in &frame.marks {
            let word = mark.name.to_string();
            if matches!(word.as_str(), "x" | "y" | "angle" | "position") {
                self.diag.refuse::<()>(&mark.name, Fact::Reserved { name: word });
                continue;
            }
            let names = &mut self.names.frames[id.0];
            if names.marks.contains_key(&word) {
                let body = names.name.clone();
                self.diag.refuse::<()>(&mark.name, Fact::DuplicateMark { name: word, body });
                continue;
            }
            names.order.push(word.clone());
            names.marks.insert(word, Mark { written: Rc::new(mark.clone()), progress: Progress::Untouched });
        }
    }

    /// A point or an axis of a frame, evaluated once.
    pub(super) fn mark(&mut self, frame: FrameId, name: &str) -> Option<Value> {
        let entry = self.names.frames[frame.0].marks.get(name)?;
        let mark = entry.written.clone();
        match &entry.progress {
            Progress::Done(value) => return Some(value.clone()),
            Progress::Failed => return None,
            Progress::Open => return self.refuse(&mark.name, Fact::Cycle { name: name.to_owned() }),
            Progress::Untouched => {}
        }
        self.set_mark(frame, name, Progress::Open);
        let value = self.fixed(frame, &mark);
        self.set_mark(frame, name, value.clone().map_or(Progress::Failed, Progress::Done));
        value
    }

    fn set_mark(&mut self, frame: FrameId, name: &str, progress: Progress<Value>) {
        if let Some(entry) = self.names.frames[frame.0].marks.get_mut(name) {
            entry.progress = progress;
        }
    }

    fn fixed(&mut self, frame: FrameId, mark: &ast::Mark) -> Option<Value> {
        let vector = self.vector(&mark.value, &Scope::mechanism().timeless("a point or an axis"))?;
        if !self.is_fixed(vector.x) || !self.is_fixed(vector.y) {
            return self.refuse(mark.value.range, Fact::NotFixed { place: "a point or an axis" });
        }
        let local = [vector.x, vector.y];
        if mark.is_axis {
            let is_zero = local.iter().all(|part| self.arena.as_constant(*part).is_some_and(|value| value.is_zero()));
            if is_zero {
                return self.refuse(mark.value.range, Fact::ZeroAxis { name: mark.name.to_string() });
            }
            let measure = Measure::Of(vector.measure.settled());
            return Some(Value::Axis(Fixed { frame, local, measure }));
        }
        if !vector.measure.fits(Dim::LENGTH) {
            return self.refuse(mark.value.range, Fact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
        }
        Some(Value::Point(Fixed { frame, local, measure: Measure::Of(Dim::LENGTH) }))
    }

    /// Resolves every point and axis, used or not, and gives the local coordinates of the points.
    pub(super) fn marks(&mut self) -> Vec<Expr> {
        let mut lengths = Vec::new();
        for frame in 0..self.names.frames.len() {
            for name in self.names.frames[frame].order.clone() {
                if let Some(Value::Point(point)) = self.mark(FrameId(frame), &name) {
                    lengths.extend(point.local);
                }
            }
        }
        lengths
    }

    /// All bodies with their coordinates and start values.
    pub(super) fn bodies(&mut self, tree: &ast::Mechanism) -> Vec<Body> {
        let mut bodies = Vec::new();
        for item in &tree.items {
            match item {
                Item::Ground(frame) => {
                    if let Some(start) = frame.starts.first() {
                        self.diag.refuse::<()>(&start.what, Fact::GroundStart);
                    }
                }
                Item::Body(frame) => bodies.push(self.body(frame)),
                _ => {}
            }
        }
        bodies
    }

    fn body(&mut self, frame: &ast::Frame) -> Body {
        let mut starts: [Option<Expr>; 3] = [None; 3];
        let scope = Scope::mechanism().timeless("a start value");
        for start in &frame.starts {
            let word = start.what.to_string();
            let found: Option<Vec<(usize, Expr)>> = match word.as_str() {
                "x" => self.scalar_of(&start.value, Dim::LENGTH, &scope).map(|value| vec![(0, value.expr)]),
                "y" => self.scalar_of(&start.value, Dim::LENGTH, &scope).map(|value| vec![(1, value.expr)]),
                "angle" => self.scalar_of(&start.value, Dim::ANGLE, &scope).map(|value| vec![(2, value.expr)]),
                "position" => self.vector(&start.value, &scope).and_then(|vector| {
                    if !vector.measure.fits(Dim::LENGTH) {
                        return self
                            .refuse(start.value.range, Fact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
                    }
                    Some(vec![(0, vector.x), (1, vector.y)])
                }),
                _ => {
                    let near = nearest(&word, ["x", "y", "angle", "position"].into_iter());
                    self.refuse(&start.what, Fact::UnknownStart { name: word.clone(), near })
                }
            };
            for (which, expr) in found.unwrap_or_default() {
                if !self.is_fixed(expr) {
                    self.refuse::<()>(start.value.range, Fact::NotFixed { place: "a start value" });
                } else if starts[which].replace(expr).is_some() {
                    self.refuse::<()>(&start.what, Fact::DuplicateStart { name: word.clone(), body: frame.name.to_string() });
                    break;
                }
            }
        }
        let kinds = [("x", Dim::LENGTH), ("y", Dim::LENGTH), ("angle", Dim::ANGLE)];
        let coordinates = kinds.into_iter().zip(starts).map(|((name, dim), start)| Coordinate { name, dim, start }).collect();
        Body { docs: frame.docs.clone(), name: frame.name.clone(), coordinates }
    }
}
