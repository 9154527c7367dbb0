//! Newton's method on the angles of closed loops, from θ + h θ̇ + h² θ̈/2.

use reuleaux::nalgebra::{Const, DimMin, SMatrix, SVector, Vector2};

use super::{Crank, Point};
use crate::contender::{Contender, Seen};

/// Two bars that meet: their angles, found together.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pair {
    q: [f64; 2],
    qd: [f64; 2],
    qdd: [f64; 2],
}

impl Pair {
    /// Bars from a and from b that meet at p, at rest.
    #[must_use]
    pub fn meeting(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> Self {
        let angle = |from: [f64; 2]| (p[1] - from[1]).atan2(p[0] - from[0]);
        Self { q: [angle(a), angle(b)], ..Self::default() }
    }

    /// Where bars of lengths `ra` from a and `rb` from b meet, `h` after the last time: a + ra e(θ₁) − b − rb e(θ₂) = 0, to
    /// this tolerance in either coordinate.
    #[inline]
    pub fn close(&mut self, (a, ra): (&Point, f64), (b, rb): (&Point, f64), h: f64, tolerance: f64) -> Point {
        let (place, rate, acceleration) = (a.p - b.p, a.v - b.v, a.a - b.a);
        let mut q = [0, 1].map(|i| self.q[i] + h * (self.qd[i] + 0.5 * h * self.qdd[i]));
        loop {
            let ((s1, c1), (s2, c2)) = (libm::sincos(q[0]), libm::sincos(q[1]));
            let phi = [place.x + ra * c1 - rb * c2, place.y + ra * s1 - rb * s2];
            let [[j11, j12], [j21, j22]] = [[-ra * s1, rb * s2], [ra * c1, -rb * c2]];
            let share = 1.0 / (j11 * j22 - j12 * j21);
            let solve = |r: [f64; 2]| [(j22 * r[0] - j12 * r[1]) * share, (j11 * r[1] - j21 * r[0]) * share];
            if phi[0].abs().max(phi[1].abs()) <= tolerance {
                let qd = solve([-rate.x, -rate.y]);
                let (e1, e2) = (ra * qd[0] * qd[0], rb * qd[1] * qd[1]);
                let qdd = solve([-acceleration.x + e1 * c1 - e2 * c2, -acceleration.y + e1 * s1 - e2 * s2]);
                *self = Self { q, qd, qdd };
                let (along, across) = (Vector2::new(c1, s1) * ra, Vector2::new(-s1, c1) * ra);
                return Point { p: a.p + along, v: a.v + across * qd[0], a: a.a + across * qdd[0] - along * (qd[0] * qd[0]) };
            }
            let change = solve(phi);
            q = [q[0] - change[0], q[1] - change[1]];
        }
    }
}

/// An arm of a loop: fixed to the link with this angle, these coordinates in it.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Which loop.
    pub along: usize,
    /// Which angle.
    pub angle: usize,
    /// The arm in the frame of the link, in m.
    pub arm: [f64; 2],
}

/// Loops that share links: K angles found together. In loop k the arms, a constant, and some multiple of the crank pin add up to
/// zero.
#[derive(Clone, Debug)]
pub struct Loops<const K: usize> {
    /// All arms of all loops.
    pub terms: Vec<Term>,
    /// x and y of each loop's constant in m.
    pub base: SVector<f64, K>,
    /// Loops with the crank pin in them, and how often.
    pub driven: Vec<(usize, f64)>,
    /// θ in rad.
    pub q: SVector<f64, K>,
    /// θ̇
    pub qd: SVector<f64, K>,
    /// θ̈
    pub qdd: SVector<f64, K>,
}

impl<const K: usize> Loops<K>
where
    Const<K>: DimMin<Const<K>, Output = Const<K>>,
{
    /// All angles `h` after the last time, with the crank pin here, to this tolerance in each equation.
    ///
    /// # Panics
    /// At a dead point.
    pub fn close(&mut self, pin: &Point, h: f64, tolerance: f64) {
        let mut q: SVector<f64, K> = self.q + (self.qd + self.qdd * (0.5 * h)) * h;
        let (base, rate, acceleration) =
            (self.driven(self.base, pin.p), self.driven(SVector::zeros(), pin.v), self.driven(SVector::zeros(), pin.a));
        loop {
            let turns = q.map(libm::sincos);
            let mut phi = base;
            let mut jacobian = SMatrix::<f64, K, K>::zeros();
            for &Term { along, angle, arm } in &self.terms {
                let (x, y) = turned(arm, turns[angle]);
                phi[2 * along] += x;
                phi[2 * along + 1] += y;
                jacobian[(2 * along, angle)] -= y;
                jacobian[(2 * along + 1, angle)] += x;
            }
            let factors = jacobian.lu();
            if phi.amax() <= tolerance {
                let qd = factors.solve(&-rate).expect("a regular Jacobian");
                let mut gamma = -acceleration;
                for &Term { along, angle, arm } in &self.terms {
                    let (x, y) = turned(arm, turns[angle]);
                    gamma[2 * along] += x * qd[angle] * qd[angle];
                    gamma[2 * along + 1] += y * qd[angle] * qd[angle];
                }
                (self.q, self.qd, self.qdd) = (q, qd, factors.solve(&gamma).expect("a regular Jacobian"));
                return;
            }
            q -= factors.solve(&phi).expect("a regular Jacobian");
        }
    }

    fn driven(&self, mut sum: SVector<f64, K>, of_pin: Vector2<f64>) -> SVector<f64, K> {
        for &(along, times) in &self.driven {
            sum[2 * along] += times * of_pin.x;
            sum[2 * along + 1] += times * of_pin.y;
        }
        sum
    }

    /// The end of an arm from a point of the link with this angle.
    #[must_use]
    pub fn end(&self, from: &Point, angle: usize, arm: [f64; 2]) -> Point {
        let along = Vector2::from(<[f64; 2]>::from(turned(arm, libm::sincos(self.q[angle]))));
        let across = Vector2::new(-along.y, along.x);
        let (rate, acceleration) = (self.qd[angle], self.qdd[angle]);
        Point { p: from.p + along, v: from.v + across * rate, a: from.a + across * acceleration - along * (rate * rate) }
    }
}

#[inline]
fn turned([x, y]: [f64; 2], (sine, cosine): (f64, f64)) -> (f64, f64) {
    (cosine * x - sine * y, sine * x + cosine * y)
}

/// The tracked point by Newton's method on angles: `follow` takes their state to a crank pin that is `h` later.
pub struct Angles<S, F> {
    crank: Crank,
    tolerance: f64,
    follow: F,
    origin: S,
    state: S,
    t: f64,
    last: Point,
}

impl<S: Clone, F: Fn(&mut S, &Point, f64, f64) -> Point> Angles<S, F> {
    /// From a guess of the state at t = 0. `follow` is given state, crank pin, h and tolerance, and returns the tracked point.
    pub fn new(crank: Crank, guess: S, tolerance: f64, follow: F) -> Self {
        let mut origin = guess;
        let last = follow(&mut origin, &crank.pin(0.0), 0.0, tolerance.min(1e-12));
        Self { crank, tolerance, follow, state: origin.clone(), origin, t: 0.0, last }
    }
}

impl<S: Clone, F: Fn(&mut S, &Point, f64, f64) -> Point> Contender for Angles<S, F> {
    fn restart(&mut self) {
        self.state.clone_from(&self.origin);
        self.t = 0.0;
    }

    #[inline]
    fn step(&mut self, t: f64) {
        self.last = (self.follow)(&mut self.state, &self.crank.pin(t), t - self.t, self.tolerance);
        self.t = t;
    }

    fn seen(&self) -> Seen {
        Seen::of(&self.last)
    }
}
