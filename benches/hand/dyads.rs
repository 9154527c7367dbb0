//! Dyads in closed form: where two bars meet, and how fast.

use reuleaux::nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::contender::{Contender, Seen};

/// A point with its velocity and acceleration.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Place in m.
    pub p: Vector2<f64>,
    /// Velocity in m/s.
    pub v: Vector2<f64>,
    /// Acceleration in m/s².
    pub a: Vector2<f64>,
}

/// A point that does not move.
#[must_use]
pub fn fixed(x: f64, y: f64) -> Point {
    Point { p: Vector2::new(x, y), v: Vector2::zeros(), a: Vector2::zeros() }
}

/// How a crank's angle follows time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// φ = 2πt
    Turning,
    /// φ = π/2 + 0.8 sin 2πt
    Swinging,
}

/// A driven link about a fixed pivot.
#[derive(Clone, Copy, Debug)]
pub struct Crank {
    /// Place of the pivot in m.
    pub pivot: [f64; 2],
    /// From pivot to pin, in m.
    pub length: f64,
    /// The law of its angle.
    pub law: Law,
}

impl Crank {
    /// φ, φ̇ and φ̈ at `t` (s), in rad.
    #[inline]
    #[must_use]
    pub fn angle(&self, t: f64) -> [f64; 3] {
        match self.law {
            Law::Turning => [TAU * t, TAU, 0.0],
            Law::Swinging => {
                let (sine, cosine) = libm::sincos(TAU * t);
                [FRAC_PI_2 + 0.8 * sine, 0.8 * TAU * cosine, -0.8 * TAU * TAU * sine]
            }
        }
    }

    /// The pin at `t` (s).
    #[inline]
    #[must_use]
    pub fn pin(&self, t: f64) -> Point {
        self.pin_at(self.angle(t))
    }

    /// The pin at this angle, with rate and acceleration.
    #[inline]
    #[must_use]
    pub fn pin_at(&self, [angle, rate, acceleration]: [f64; 3]) -> Point {
        let (sine, cosine) = libm::sincos(angle);
        let (along, across) = (Vector2::new(cosine, sine) * self.length, Vector2::new(-sine, cosine) * self.length);
        Point { p: Vector2::from(self.pivot) + along, v: across * rate, a: across * acceleration - along * (rate * rate) }
    }
}

/// The point at distance `ra` from a and `rb` from b, to the left of the way from a to b if `side` is 1.
#[inline]
#[must_use]
pub fn dyad(a: &Point, ra: f64, b: &Point, rb: f64, side: f64) -> Point {
    let d = b.p - a.p;
    let square = d.dot(&d);
    let along = 0.5 + (ra * ra - rb * rb) / (2.0 * square);
    let across = side * (ra * ra / square - along * along).sqrt();
    let p = a.p + d * along + Vector2::new(-d.y, d.x) * across;
    let (u, w) = (p - a.p, p - b.p);
    let share = 1.0 / (u.x * w.y - u.y * w.x);
    let solve = |r: f64, s: f64| Vector2::new((r * w.y - u.y * s) * share, (u.x * s - r * w.x) * share);
    let v = solve(u.dot(&a.v), w.dot(&b.v));
    let (ua, wb) = (v - a.v, v - b.v);
    let acceleration = solve(u.dot(&a.a) - ua.dot(&ua), w.dot(&b.a) - wb.dot(&wb));
    Point { p, v, a: acceleration }
}

/// A link between two points: its angle in rad, counted on over whole turns, with its rate and acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bar {
    /// φ, φ̇ and φ̈
    pub angle: [f64; 3],
}

impl Bar {
    /// The link from a to b, which was at another angle before.
    #[inline]
    pub fn follow(&mut self, a: &Point, b: &Point) {
        let across = |d: &Vector2<f64>, e: &Vector2<f64>| d.x * e.y - d.y * e.x;
        let d = b.p - a.p;
        let share = 1.0 / d.dot(&d);
        let angle = libm::atan2(d.y, d.x);
        let turns = libm::rint((self.angle[0] - angle) * (1.0 / TAU));
        let rate = across(&d, &(b.v - a.v)) * share;
        self.angle = [angle + TAU * turns, rate, across(&d, &(b.a - a.a)) * share];
    }
}

/// Every body, and the tracked point that the function returns.
pub struct Whole<B, F> {
    start: B,
    bars: B,
    point: F,
    last: Point,
}

impl<B: Copy, F: Fn(f64, &mut B) -> Point> Whole<B, F> {
    /// The contender that computes this; `bars` are at angles of the first turn.
    pub fn new(mut bars: B, point: F) -> Self {
        let last = point(0.0, &mut bars);
        Self { start: bars, bars, point, last }
    }
}

impl<B: Copy, F: Fn(f64, &mut B) -> Point> Contender for Whole<B, F> {
    fn restart(&mut self) {
        self.bars = self.start;
    }

    #[inline]
    fn step(&mut self, t: f64) {
        self.last = (self.point)(t, &mut self.bars);
    }

    fn seen(&self) -> Seen {
        Seen::of(&self.last)
    }
}

/// The tracked point as a function of time.
pub struct Closed<F> {
    point: F,
    last: Point,
}

impl<F: Fn(f64) -> Point> Closed<F> {
    /// The contender that computes this.
    pub fn new(point: F) -> Self {
        let last = point(0.0);
        Self { point, last }
    }
}

impl<F: Fn(f64) -> Point> Contender for Closed<F> {
    fn restart(&mut self) {}

    #[inline]
    fn step(&mut self, t: f64) {
        self.last = (self.point)(t);
    }

    fn seen(&self) -> Seen {
        Seen::of(&self.last)
    }
}
