//! The motion of a linkage to more digits than a double has, found without any of the contenders.
//!
//! The unknowns are the points: every bar is |p − q|² = length², so that only sums and products occur. Newton's method takes its
//! corrections from doubles and its residuals from numbers of twice the precision, until those vanish; velocities and
//! accelerations are refined in the same way.

use reuleaux::Real;
use reuleaux::nalgebra::{DMatrix, DVector, Dyn, LU};

use crate::contender::Seen;
use crate::hand::Law;
use crate::linkage::{Bar, Linkage};
use reuleaux_tests::common::twofold::Twofold;

type Vector = [Twofold; 2];

/// 2π
const TAU: Twofold = Twofold { high: std::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16 };

/// Place, velocity and acceleration of a point.
type Levels = [Vector; 3];

/// How often a solution is refined: each time adds some fifteen digits, and the first are spent on Newton's method.
const REFINEMENTS: usize = 8;

/// The tracked point at these times, which begin near zero and follow each other closely.
///
/// # Panics
/// If the linkage does not close.
#[must_use]
pub fn motion(linkage: &Linkage, times: &[f64]) -> Vec<Seen> {
    let groups = groups(linkage);
    let at_rest = |&[x, y]: &[f64; 2]| [[x.into(), y.into()], Vector::default(), Vector::default()];
    let mut points: Vec<Levels> = linkage.points.iter().map(at_rest).collect();
    let mut last = 0.0;
    let mut seen = Vec::new();
    for &t in times {
        points[linkage.crank_ends[1]] = pin(linkage, t);
        for group in &groups {
            group.follow(&mut points, t - last);
        }
        last = t;
        let [place, _, acceleration] = points[linkage.tracked];
        let doubles = |vector: Vector| vector.map(|entry| entry.high);
        seen.push(Seen { place: doubles(place), acceleration: Some(doubles(acceleration)) });
    }
    seen
}

/// The crank pin.
fn pin(linkage: &Linkage, t: f64) -> Levels {
    let zero = Twofold::default();
    let turn = TAU * t.into();
    let [angle, rate, acceleration] = match linkage.crank.law {
        Law::Turning => [turn, TAU, zero],
        Law::Swinging => {
            let (sine, cosine) = turn.sin_cos();
            let swing = Twofold::from(0.8);
            [TAU * 0.25.into() + swing * sine, swing * TAU * cosine, -(swing * TAU * TAU * sine)]
        }
    };
    let (sine, cosine) = angle.sin_cos();
    let length = Twofold::from(linkage.crank.length);
    let (along, across) = ([length * cosine, length * sine], [-(length * sine), length * cosine]);
    let pivot = linkage.crank.pivot;
    [
        [0, 1].map(|i| along[i] + pivot[i].into()),
        [0, 1].map(|i| across[i] * rate),
        [0, 1].map(|i| across[i] * acceleration - along[i] * rate * rate),
    ]
}

/// Points that are found together, and the equations they are found from.
struct Group {
    points: Vec<usize>,
    bars: Vec<Bar>,
    slider: Option<usize>,
}

/// The sets of points in their order, each with the bars that have no later point.
fn groups(linkage: &Linkage) -> Vec<Group> {
    let mut known: Vec<usize> = (0..linkage.fixed).chain([linkage.crank_ends[1]]).collect();
    let mut groups = Vec::new();
    for points in &linkage.order {
        known.extend(points);
        let is_of_these = |&(a, b, _): &Bar| known.contains(&a) && known.contains(&b) && (points.contains(&a) || points.contains(&b));
        let bars = linkage.bars().into_iter().filter(is_of_these).collect();
        groups.push(Group { points: points.clone(), bars, slider: linkage.slider.filter(|slider| points.contains(slider)) });
    }
    groups
}

impl Group {
    fn follow(&self, points: &mut [Levels], h: f64) {
        for &point in &self.points {
            let [place, velocity, acceleration] = points[point];
            points[point][0] = [0, 1].map(|i| (place[i].high + h * (velocity[i].high + 0.5 * h * acceleration[i].high)).into());
        }
        for _ in 0..REFINEMENTS {
            self.refine(&self.factors(points), points, 0);
        }
        let factors = self.factors(points);
        for level in [1, 2] {
            for _ in 0..REFINEMENTS {
                self.refine(&factors, points, level);
            }
        }
    }

    /// The Jacobian's factors; a row is 2 (p − q), as in the residuals below.
    fn factors(&self, points: &[Levels]) -> LU<f64, Dyn, Dyn> {
        let size = 2 * self.points.len();
        let mut jacobian = DMatrix::zeros(size, size);
        let column = |point: usize| self.points.iter().position(|&own| own == point).map(|index| 2 * index);
        for (row, &(a, b, _)) in self.bars.iter().enumerate() {
            for (from, to) in [(a, b), (b, a)] {
                let Some(column) = column(from) else { continue };
                for i in 0..2 {
                    jacobian[(row, column + i)] = 2.0 * (points[from][0][i] - points[to][0][i]).high;
                }
            }
        }
        if let Some(column) = self.slider.and_then(column) {
            jacobian[(self.bars.len(), column + 1)] = 1.0;
        }
        jacobian.lu()
    }

    /// One step towards zero residuals of places (level 0), velocities (1) or accelerations (2).
    fn refine(&self, factors: &LU<f64, Dyn, Dyn>, points: &mut [Levels], level: usize) {
        let bars = self.bars.iter().map(|bar| residual(bar, points, level).high);
        let slider = self.slider.map(|slider| points[slider][level][1].high);
        let residuals = DVector::from_iterator(2 * self.points.len(), bars.chain(slider));
        let change = factors.solve(&residuals).expect("a linkage that moves");
        for (index, &point) in self.points.iter().enumerate() {
            for i in 0..2 {
                let entry = &mut points[point][level][i];
                *entry = *entry - change[2 * index + i].into();
            }
        }
    }
}

/// d·d − length², 2 d·ḋ, 2 (d·d̈ + ḋ·ḋ) with d = p − q.
fn residual(&(a, b, length): &Bar, points: &[Levels], level: usize) -> Twofold {
    let difference = |of: usize| [0, 1].map(|i| points[a][of][i] - points[b][of][i]);
    let dot = |x: Vector, y: Vector| x[0] * y[0] + x[1] * y[1];
    let (d, two) = (difference(0), Twofold::from(2.0));
    match level {
        0 => dot(d, d) - Twofold::from(length) * length.into(),
        1 => two * dot(d, difference(1)),
        _ => two * (dot(d, difference(2)) + dot(difference(1), difference(1))),
    }
}
