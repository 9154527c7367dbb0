//! Planar mechanisms as a list of joints. Φ is written once, over any `Real`; Φ_q, ν and γ are its exact derivatives by [`Jet`]s.

use reuleaux::nalgebra::{SMatrix, SVector};
use reuleaux::{Coordinate, Coordinates, Description, Equations, Float, ParameterOutOfRange, Real, Row, Solver, Stages, StepError};

use super::jet::Jet;

/// Index of a body among the bodies of a mechanism.
pub type Body = usize;

/// The body that does not move.
pub const GROUND: Body = usize::MAX;

/// A point of a body, in m in the body's frame.
pub type Point = (Body, [f64; 2]);

/// Σ c_k t^k + Σ amplitude sin(ω t + phase).
#[derive(Clone, Copy, Debug)]
pub struct Law {
    pub polynomial: &'static [f64],
    pub harmonics: &'static [[f64; 3]],
}

#[derive(Clone, Copy, Debug)]
pub enum Joint {
    /// r_P − r_Q = 0.
    Revolute(Point, Point),
    /// u⊥ · (r_Q − r_P) = 0, u⊥ · v = 0.
    Translational(Point, [f64; 2], Point, [f64; 2]),
    /// |r_Q − r_P|² − f(t)² = 0.
    Distance(Point, Point, Law),
    /// φ_j − φ_i − f(t) = 0.
    Angle(Body, Body, Law),
    /// R_i (φ_i − φ_i0) + R_j (φ_j − φ_j0) = 0.
    Gears(Body, f64, f64, Body, f64, f64),
    /// The same for moving centres, with angles from the line of centres.
    GearsMoving(Point, f64, f64, Point, f64, f64),
}

/// Time, q, q̇, q̈.
pub type Instant<const N: usize> = (f64, [f64; N], [f64; N], [f64; N]);

/// A mechanism with known states.
#[derive(Clone, Copy, Debug)]
pub struct Reference<const N: usize> {
    pub joints: &'static [Joint],
    pub length: f64,
    pub start: [f64; N],
    pub rough: &'static [[f64; N]],
    pub orientation: f64,
    pub states: &'static [Instant<N>],
}

impl Law {
    fn at<T: Real>(self, t: T) -> T {
        let sum = self.polynomial.iter().rev().fold(T::of(0.0), |sum, &c| sum * t + T::of(c));
        self.harmonics
            .iter()
            .fold(sum, |sum, &[amplitude, omega, phase]| sum + T::of(amplitude) * (T::of(omega) * t + T::of(phase)).sin_cos().0)
    }
}

/// x, y and φ of a body.
fn body<T: Real, const N: usize>(q: &SVector<T, N>, body: Body) -> [T; 3] {
    if body == GROUND { [T::of(0.0); 3] } else { [q[3 * body], q[3 * body + 1], q[3 * body + 2]] }
}

/// A vector of a body, in ground.
fn turned<T: Real>(angle: T, [x, y]: [f64; 2]) -> [T; 2] {
    let (s, c) = angle.sin_cos();
    [c * T::of(x) - s * T::of(y), s * T::of(x) + c * T::of(y)]
}

/// r_Q − r_P.
fn between<T: Real, const N: usize>(q: &SVector<T, N>, p: Point, other: Point) -> [T; 2] {
    let place = |(of, local): Point| {
        let [x, y, angle] = body(q, of);
        let arm = turned(angle, local);
        [x + arm[0], y + arm[1]]
    };
    let (p, o) = (place(p), place(other));
    [o[0] - p[0], o[1] - p[1]]
}

impl<const N: usize> Reference<N> {
    fn residual<T: Real>(&self, q: &SVector<T, N>, t: T) -> SVector<T, N> {
        let mut phi = SVector::from_element(T::of(0.0));
        let mut next = 0;
        let mut put = |value: T| {
            phi[next] = value;
            next += 1;
        };
        let angle = |of| body(q, of)[2];
        for joint in self.joints {
            match *joint {
                Joint::Revolute(p, o) => between(q, o, p).into_iter().for_each(&mut put),
                Joint::Translational(p, u, o, v) => {
                    let (d, u, v) = (between(q, p, o), turned(angle(p.0), u), turned(angle(o.0), v));
                    put(u[0] * d[1] - u[1] * d[0]);
                    put(u[0] * v[1] - u[1] * v[0]);
                }
                Joint::Distance(p, o, law) => {
                    let (d, length) = (between(q, p, o), law.at(t));
                    put(d[0] * d[0] + d[1] * d[1] - length * length);
                }
                Joint::Angle(i, j, law) => put(angle(j) - angle(i) - law.at(t)),
                Joint::Gears(i, ri, i0, j, rj, j0) => put(T::of(ri) * (angle(i) - T::of(i0)) + T::of(rj) * (angle(j) - T::of(j0))),
                Joint::GearsMoving(p, ri, i0, o, rj, j0) => {
                    let rolled = T::of(ri) * (angle(p.0) + T::of(i0)) + T::of(rj) * (angle(o.0) + T::of(j0));
                    let line = (rolled - T::of(rj * core::f64::consts::PI)) / T::of(ri + rj);
                    let (d, (s, c)) = (between(q, p, o), line.sin_cos());
                    put(d[0] * s - d[1] * c);
                }
            }
        }
        phi
    }
}

const BODY: [Coordinate; 3] = [Coordinate::length("body", "x"), Coordinate::length("body", "y"), Coordinate::angle("body", "angle")];

impl<T: Float, const N: usize> Stages<T, N> for Reference<N> {
    fn stages(&self, t: T, pass: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        reuleaux::at_once(self, t, pass)
    }

    fn refined_guess(&self, t: T, guess: &SVector<T, N>) -> SVector<T, N> {
        reuleaux::refined_guess_at_once(self, t, guess)
    }
}

impl<T: Real, const N: usize> Description<T, N> for Reference<N> {
    const NAME: &'static str = "Reference";
    const COORDINATES: &'static [Coordinate] = [BODY; 7].as_flattened().split_at(N).0;
    const ROWS: &'static [Row] = &[Row { joint: "joint", kind: "equation", index: 1, of: 1, unit: "m" }; N];

    fn start(&self) -> SVector<T, N> {
        SVector::from_fn(|i, _| T::of(self.start[i]))
    }
    fn characteristic_length(&self) -> T {
        T::of(self.length)
    }
    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        Ok(())
    }
}

impl<T: Real, const N: usize> Equations<T, N, N> for Reference<N> {
    fn phi(&self, q: &SVector<T, N>, t: T) -> SVector<T, N> {
        self.residual(q, t)
    }
    fn jacobian(&self, q: &SVector<T, N>, t: T) -> SMatrix<T, N, N> {
        let zero = T::of(0.0);
        let columns: [SVector<T, N>; N] = core::array::from_fn(|j| {
            let along = SVector::from_fn(|i, _| Jet(q[i], T::of(f64::from(u8::from(i == j))), zero));
            self.residual(&along, Jet(t, zero, zero)).map(|jet| jet.1)
        });
        SMatrix::from_fn(|i, j| columns[j][i])
    }
    fn linearize(&self, q: &SVector<T, N>, t: T) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.phi(q, t), self.jacobian(q, t))
    }
    fn nu(&self, q: &SVector<T, N>, t: T) -> SVector<T, N> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        self.residual(&q.map(|x| Jet(x, zero, zero)), Jet(t, one, zero)).map(|jet| -jet.1)
    }
    fn gamma(&self, q: &SVector<T, N>, qd: &SVector<T, N>, t: T) -> SVector<T, N> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let along = SVector::from_fn(|i, _| Jet(q[i], qd[i], zero));
        self.residual(&along, Jet(t, one, zero)).map(|jet| -jet.2)
    }
}
