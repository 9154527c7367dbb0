//! The crate `ezpz`, a solver of sketches: points, and how far apart they are. Positions only.

use ezpz::datatypes::inputs::DatumPoint;
use ezpz::{Config, Constraint, ConstraintRequest, IdGenerator, solve};

use crate::contender::{Contender, Seen};
use crate::linkage::Linkage;

/// The contender: each solution is the guess for the next.
pub(crate) struct Sketch {
    linkage: Linkage,
    points: Vec<DatumPoint>,
    requests: Vec<ConstraintRequest>,
    places: Vec<f64>,
    config: Config,
}

impl Sketch {
    /// A linkage as a sketch, solved until residuals are as small as this.
    #[must_use]
    pub(crate) fn new(linkage: Linkage, tolerance: f64) -> Self {
        let mut ids = IdGenerator::default();
        let points: Vec<DatumPoint> = linkage.points.iter().map(|_| DatumPoint::new(&mut ids)).collect();
        let mut requests = Vec::new();
        let mut want = |constraint| requests.push(ConstraintRequest::highest_priority(constraint));
        // The crank pin's two come first, so that they are found again.
        for point in [linkage.crank_ends[1]].into_iter().chain(0..linkage.fixed) {
            let [x, y] = linkage.points[point];
            want(Constraint::Fixed(points[point].id_x(), x));
            want(Constraint::Fixed(points[point].id_y(), y));
        }
        for (a, b, length) in linkage.bars() {
            want(Constraint::Distance(points[a], points[b], length));
        }
        if let Some(slider) = linkage.slider {
            want(Constraint::Fixed(points[slider].id_y(), 0.0));
        }
        let config = Config::default().with_convergence_tolerance(tolerance).with_step_tolerance(1e-16);
        let mut sketch = Self { places: linkage.points.concat(), linkage, points, requests, config };
        sketch.step(0.0);
        sketch
    }
}

impl Contender for Sketch {
    fn restart(&mut self) {
        self.places = self.linkage.points.concat();
    }

    fn step(&mut self, t: f64) {
        let pin = self.linkage.crank_ends[1];
        let place = self.linkage.crank.pin(t).p;
        for (request, (id, value)) in self.requests.iter_mut().zip([(self.points[pin].id_x(), place.x), (self.points[pin].id_y(), place.y)])
        {
            *request = ConstraintRequest::highest_priority(Constraint::Fixed(id, value));
        }
        let ids = self.points.iter().flat_map(|point| [point.id_x(), point.id_y()]);
        let guesses = ids.zip(self.places.iter().copied()).collect();
        match solve(&self.requests, guesses, self.config) {
            Ok(outcome) => self.places.copy_from_slice(outcome.final_values()),
            Err(failure) => panic!("{}", failure.error()),
        }
    }

    fn seen(&self) -> Seen {
        let point = 2 * self.linkage.tracked;
        Seen { place: [self.places[point], self.places[point + 1]], acceleration: None }
    }
}
