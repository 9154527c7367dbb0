//! Bodies: a link between two hinges is a bar, one with more hinges a plate, and a body with a single point a dot.

use crate::canvas::{Canvas, Ink, Layer, Near, Subject};
use crate::plane::{Place, farthest, hull};

/// Points nearer to each other than this coincide in the picture.
const NEAR: f64 = 0.7;

/// A plate thinner than this is drawn as a bar.
const THIN: f64 = 3.0;

/// A body while the picture is drawn.
#[derive(Clone, Debug, Default)]
pub(crate) struct DrawnBody {
    /// Points, in picture units.
    pub(crate) points: Vec<Place>,
    /// Guides fixed to the body that extend beyond its points.
    pub(crate) bars: Vec<(Place, Place)>,
    /// True if another symbol shows the position of the body: a block, a wheel, a cam.
    pub(crate) is_shown: bool,
}

impl DrawnBody {
    pub(crate) fn reach(&mut self, at: Place) {
        if self.points.iter().all(|known| (*known - at).norm() > NEAR) {
            self.points.push(at);
        }
    }

    /// Corners of the outline: a single point, the two ends of a bar, or the corners of a plate.
    pub(crate) fn outline(&self) -> Vec<Place> {
        let Some((one, two)) = farthest(&self.points) else { return self.points.clone() };
        let is_thin = self.points.iter().all(|at| at.to_segment(one, two) < THIN);
        if is_thin { vec![one, two] } else { hull(&self.points) }
    }

    /// True if the body is more than a point.
    pub(crate) fn has_extent(&self) -> bool {
        self.outline().len() > 1 || !self.bars.is_empty()
    }

    /// Directions (rad) in which the body leaves a place.
    pub(crate) fn directions(&self, from: Place) -> Vec<f64> {
        let of_bars = self.bars.iter().filter(|(one, _)| (*one - from).norm() < 2.0).map(|(one, two)| (*two - *one).angle());
        let of_bars: Vec<f64> = of_bars.collect();
        if !self.points.iter().any(|at| (*at - from).norm() < 2.0) {
            return of_bars;
        }
        let outline = self.outline();
        let middle = outline.iter().fold(Place::default(), |sum, corner| sum + *corner) * (1.0 / outline.len() as f64);
        let ends = outline.iter().chain((outline.len() > 2).then_some(&middle));
        ends.filter(|end| (**end - from).norm() > 2.0).map(|end| (*end - from).angle()).chain(of_bars).collect()
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas, number: usize, name: &str) {
        let outline = self.outline();
        for (one, two) in &self.bars {
            canvas.line(Layer::DrawnBody, Ink::Bar(number), name, &[*one, *two]);
        }
        match outline.as_slice() {
            [] | [_] if !self.bars.is_empty() => canvas.wish(Subject::Body, name, Near::Segments(self.bars.clone())),
            [] => {}
            [at] => {
                if !self.is_shown {
                    canvas.circle(Layer::DrawnBody, Ink::Bar(number), name, *at, 3.0);
                    canvas.wish(Subject::Body, name, Near::Point(*at, 8.0));
                }
            }
            [one, two] => {
                canvas.line(Layer::DrawnBody, Ink::Bar(number), name, &[*one, *two]);
                let segments = self.bars.iter().copied().chain([(*one, *two)]).collect();
                canvas.wish(Subject::Body, name, Near::Segments(segments));
            }
            corners => {
                canvas.area(Layer::DrawnBody, Ink::Plate(number), name, corners);
                canvas.wish(Subject::Body, name, Near::Area(corners.to_vec()));
            }
        }
    }
}
