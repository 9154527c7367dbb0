//! Continuation of loops along their branch with proof, from distances alone.
//!
//! A loop is written in complex numbers: its unknowns z₁ … zₙ are rotating arms and positions, its equations are distances between points
//! that are sums of these. Nothing here uses bodies, angles of q, or expressions of the compiler.
//!
//! ```text
//! Fⱼ(z, t) = |Σ e_jk z_k + b_j(t)|² − L_j(t)²,    j = 1 … 2n
//! ```
//!
//! F is quadratic in z, so that the theorem of Newton and Kantorovich has explicit constants. With J = F_z(z₀, t₀), F(z₀, t₀) = 0,
//! the prediction z(t) = z₀ + (t − t₀) ż and, for all t of a step,
//!
//! ```text
//! η ≥ ‖J⁻¹ F(z(t), t)‖      δ ≥ ‖J⁻¹ (F_z(z(t), t) − J)‖      ω ≥ ‖J⁻¹ (F_z(x, t) − F_z(y, t))‖ / ‖x − y‖
//! ```
//!
//! if (1 − δ)² > 2 ω η, there is exactly one solution within (1 − δ) / ω of z(t) for each such t, and it depends on t continuously: the
//! solution at the end of the step is on the branch. Steps are as long as this proof permits.

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// The real part.
    pub x: f64,
    /// The imaginary part.
    pub y: f64,
}

/// x + y i
#[must_use]
pub const fn complex(x: f64, y: f64) -> Complex {
    Complex { x, y }
}

impl Complex {
    /// r e^(iφ)
    #[must_use]
    pub fn polar(r: f64, angle: f64) -> Self {
        complex(r * angle.cos(), r * angle.sin())
    }

    /// Magnitude.
    #[must_use]
    pub fn abs(self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Angle in (−π, π].
    #[must_use]
    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    /// Product with a real number.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        complex(factor * self.x, factor * self.y)
    }

    fn conjugate(self) -> Self {
        complex(self.x, -self.y)
    }

    fn square(self) -> f64 {
        self.x * self.x + self.y * self.y
    }
}

impl std::ops::Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        complex(self.x + other.x, self.y + other.y)
    }
}

impl std::ops::Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        complex(self.x - other.x, self.y - other.y)
    }
}

impl std::ops::Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        complex(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)
    }
}

/// c + r t + a sin(w t + p)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law {
    /// c
    pub constant: f64,
    /// r
    pub rate: f64,
    /// a
    pub amplitude: f64,
    /// w
    pub frequency: f64,
    /// p
    pub phase: f64,
}

impl Law {
    /// A constant law.
    #[must_use]
    pub fn fixed(constant: f64) -> Self {
        Self { constant, ..Self::default() }
    }

    /// Value at t.
    #[must_use]
    pub fn value(&self, t: f64) -> f64 {
        self.constant + self.rate * t + self.amplitude * (self.frequency * t + self.phase).sin()
    }

    /// Rate at t.
    #[must_use]
    pub fn rate(&self, t: f64) -> f64 {
        self.rate + self.amplitude * self.frequency * (self.frequency * t + self.phase).cos()
    }

    /// Bound of the rate at times at most h from t.
    fn fastest(&self, t: f64, h: f64) -> f64 {
        (self.rate(t).abs() + h * self.most()).min(self.rate.abs() + (self.amplitude * self.frequency).abs())
    }

    /// Bound of the second derivative.
    fn most(&self) -> f64 {
        self.amplitude.abs() * self.frequency * self.frequency
    }
}

/// A driven point: the end of a driven arm on a fixed pivot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Led {
    /// The pivot.
    pub pivot: Complex,
    /// Length of the arm.
    pub arm: f64,
    /// Angle of the arm.
    pub angle: Law,
}

impl Led {
    /// A fixed point.
    #[must_use]
    pub fn fixed(pivot: Complex) -> Self {
        Self { pivot, ..Self::default() }
    }

    /// Position at t.
    #[must_use]
    pub fn at(&self, t: f64) -> Complex {
        self.pivot + Complex::polar(self.arm, self.angle.value(t))
    }

    fn rate(&self, t: f64) -> Complex {
        Complex::polar(self.arm, self.angle.value(t)) * complex(0.0, self.angle.rate(t))
    }

    /// Bound of the acceleration at times at most h from t.
    fn most(&self, t: f64, h: f64) -> f64 {
        self.arm.abs() * (self.angle.fastest(t, h).powi(2) + self.angle.most())
    }
}

/// Σ e_k z_k + `to` − `from`, the vector from one point to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way<const UNKNOWNS: usize> {
    /// e
    pub factors: [Complex; UNKNOWNS],
    /// Driven point at the start.
    pub from: Led,
    /// Driven point at the end.
    pub to: Led,
}

impl<const UNKNOWNS: usize> Way<UNKNOWNS> {
    /// The vector at a time.
    #[must_use]
    pub fn at(&self, z: &[Complex; UNKNOWNS], t: f64) -> Complex {
        let led = self.to.at(t) - self.from.at(t);
        self.factors.iter().zip(z).fold(led, |sum, (factor, unknown)| sum + *factor * *unknown)
    }

    /// Rate of the vector at a time, for given rates of the unknowns.
    #[must_use]
    pub fn rate(&self, rates: &[Complex; UNKNOWNS], t: f64) -> Complex {
        let led = self.to.rate(t) - self.from.rate(t);
        self.factors.iter().zip(rates).fold(led, |sum, (factor, rate)| sum + *factor * *rate)
    }

    /// Σ |e_k|
    fn reach(&self) -> f64 {
        self.factors.iter().map(|factor| factor.abs()).sum()
    }
}

/// A vector of given length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar<const UNKNOWNS: usize> {
    /// The vector.
    pub way: Way<UNKNOWNS>,
    /// Its length.
    pub length: Law,
}

/// A loop of `ROWS` = 2 `UNKNOWNS` bars.
#[derive(Clone, Debug)]
pub struct Loop<const UNKNOWNS: usize, const ROWS: usize> {
    /// The bars.
    pub bars: [Bar<UNKNOWNS>; ROWS],
    /// Vectors whose angles are tracked over whole turns.
    pub arms: Vec<Way<UNKNOWNS>>,
}

/// Position of a loop.
#[derive(Clone, Debug)]
pub struct Place<const UNKNOWNS: usize> {
    /// Time.
    pub t: f64,
    /// The unknowns.
    pub z: [Complex; UNKNOWNS],
    /// The angles of the arms, never wrapped.
    pub angles: Vec<f64>,
}

/// End of a continuation in time.
#[derive(Clone, Debug)]
pub enum End<const UNKNOWNS: usize> {
    /// The time asked for was reached.
    There {
        /// Position of the loop at that time.
        place: Place<UNKNOWNS>,
        /// Least radius on the path within which the solution is unique and the loop is regular.
        clearance: f64,
    },
    /// At a singular position, or closer to one than doubles resolve.
    Singular {
        /// Time.
        t: f64,
    },
    /// The limit of steps was reached.
    Unknown,
}

/// Shortest step, in s; a branch that needs shorter ones is singular to rounding.
const SHORTEST: f64 = 1e-15;

/// Largest number of steps.
const MOST_STEPS: usize = 100_000;

/// Fraction of the bounds that is used; the remainder covers rounding.
const MARGIN: f64 = 0.95;

type Rows<const ROWS: usize> = [[f64; ROWS]; ROWS];

impl<const UNKNOWNS: usize, const ROWS: usize> Loop<UNKNOWNS, ROWS> {
    /// F(z, t)
    #[must_use]
    pub fn residuals(&self, z: &[Complex; UNKNOWNS], t: f64) -> [f64; ROWS] {
        std::array::from_fn(|j| {
            let length = self.bars[j].length.value(t);
            let way = self.bars[j].way.at(z, t).abs();
            (way - length) * (way + length)
        })
    }

    /// F_z(z, t), by real and imaginary parts.
    fn jacobian(&self, z: &[Complex; UNKNOWNS], t: f64) -> Rows<ROWS> {
        std::array::from_fn(|j| {
            let way = self.bars[j].way.at(z, t).conjugate();
            let mut row = [0.0; ROWS];
            for k in 0..UNKNOWNS {
                let slope = (way * self.bars[j].way.factors[k]).times(2.0);
                (row[2 * k], row[2 * k + 1]) = (slope.x, -slope.y);
            }
            row
        })
    }

    /// J⁻¹ at a position; None if it is singular.
    fn inverse(&self, z: &[Complex; UNKNOWNS], t: f64) -> Option<Rows<ROWS>> {
        inverse(self.jacobian(z, t))
    }

    /// Newton's method to convergence; None if it diverges.
    #[must_use]
    pub fn solution(&self, near: &[Complex; UNKNOWNS], t: f64) -> Option<[Complex; UNKNOWNS]> {
        let mut z = *near;
        let mut last = f64::INFINITY;
        for _ in 0..30 {
            let correction: [Complex; UNKNOWNS] = applied(&self.inverse(&z, t)?, &self.residuals(&z, t));
            let length = norm(&correction);
            if !length.is_finite() {
                return None;
            }
            // At the rounding limit, corrections stop decreasing.
            if length >= 0.5 * last && length <= 1e-6 * norm(&z) {
                return Some(z);
            }
            last = length;
            for (unknown, part) in z.iter_mut().zip(correction) {
                *unknown = *unknown - part;
            }
        }
        None
    }

    /// ż from J ż = −F_t; None if J is singular.
    #[must_use]
    pub fn rates(&self, z: &[Complex; UNKNOWNS], t: f64) -> Option<[Complex; UNKNOWNS]> {
        Some(self.rates_by(&self.inverse(z, t)?, z, t))
    }

    fn rates_by(&self, inverse: &Rows<ROWS>, z: &[Complex; UNKNOWNS], t: f64) -> [Complex; UNKNOWNS] {
        let still = [Complex::default(); UNKNOWNS];
        let rates = std::array::from_fn(|j| {
            let Bar { way, length } = &self.bars[j];
            2.0 * (length.value(t) * length.rate(t) - (way.at(z, t).conjugate() * way.rate(&still, t)).x)
        });
        applied(inverse, &rates)
    }

    /// Radius within which the solution is unique.
    #[must_use]
    pub fn clearance(&self, z: &[Complex; UNKNOWNS], t: f64) -> f64 {
        self.inverse(z, t).map_or(0.0, |inverse| 1.0 / self.curvature(&inverse))
    }

    /// ω: each row of F_z changes by at most 2 (Σ |e_k|)².
    fn curvature(&self, inverse: &Rows<ROWS>) -> f64 {
        bound(inverse, &std::array::from_fn(|j| 2.0 * self.bars[j].way.reach().powi(2)))
    }

    /// Angles of the arms, unwrapped to be near those before.
    fn turned(&self, before: &[f64], z: &[Complex; UNKNOWNS], t: f64) -> Vec<f64> {
        let near = |(arm, before): (&Way<UNKNOWNS>, &f64)| {
            let angle = arm.at(z, t).angle();
            angle + std::f64::consts::TAU * ((before - angle) / std::f64::consts::TAU).round()
        };
        self.arms.iter().zip(before).map(near).collect()
    }

    /// A position with known unknowns.
    #[must_use]
    pub fn place(&self, z: [Complex; UNKNOWNS], t: f64) -> Place<UNKNOWNS> {
        Place { t, z, angles: self.arms.iter().map(|arm| arm.at(&z, t).angle()).collect() }
    }

    /// Follows the branch from a position to a time.
    #[must_use]
    pub fn follow(&self, from: &Place<UNKNOWNS>, t: f64) -> End<UNKNOWNS> {
        let mut here = from.clone();
        let mut step = t - here.t;
        let mut clearance = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            if here.t == t {
                return End::There { place: here, clearance };
            }
            let Some(inverse) = self.inverse(&here.z, here.t) else { return End::Singular { t: here.t } };
            clearance = clearance.min(1.0 / self.curvature(&inverse));
            let rates = self.rates_by(&inverse, &here.z, here.t);
            loop {
                let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
                if let Some(place) = self.step(&here, &rates, &inverse, next) {
                    here = place;
                    step *= 1.6;
                    break;
                }
                step = 0.5 * (next - here.t);
                if step.abs() < SHORTEST * (1.0 + here.t.abs()) {
                    return End::Singular { t: here.t };
                }
            }
        }
        End::Unknown
    }

    /// One step, if it can be proven.
    fn step(&self, here: &Place<UNKNOWNS>, rates: &[Complex; UNKNOWNS], inverse: &Rows<ROWS>, t: f64) -> Option<Place<UNKNOWNS>> {
        let h = (t - here.t).abs();
        let (mut gaps, mut slopes) = ([0.0; ROWS], [0.0; ROWS]);
        for (j, Bar { way, length }) in self.bars.iter().enumerate() {
            // F along z₀ + s ż, from its value and its rate at s = 0 and a bound of its second derivative.
            let (place, rate) = (way.at(&here.z, here.t), way.rate(rates, here.t));
            let (now, change) = (length.value(here.t), length.rate(here.t));
            let left = (place.abs() - now) * (place.abs() + now);
            let left_rate = 2.0 * ((place.conjugate() * rate).x - now * change);
            let turn = way.from.most(here.t, h) + way.to.most(here.t, h);
            let fastest = rate.abs() + h * turn;
            let [farthest, longest] = [place.abs() + h * fastest, now.abs() + h * length.fastest(here.t, h)];
            let bend = 2.0 * (fastest.powi(2) + farthest * turn + length.fastest(here.t, h).powi(2) + longest * length.most());
            gaps[j] = left.abs() + h * left_rate.abs() + 0.5 * h * h * bend;
            slopes[j] = 2.0 * h * fastest * way.reach();
        }
        let (eta, delta, omega) = (bound(inverse, &gaps), bound(inverse, &slopes), self.curvature(inverse));
        let room = MARGIN - delta;
        if !(room > 0.0 && room * room > 2.0 * omega * eta) {
            return None;
        }
        let predicted: [Complex; UNKNOWNS] = std::array::from_fn(|k| here.z[k] + rates[k].times(t - here.t));
        let z = self.solution(&predicted, t)?;
        let is_meant = z.iter().zip(predicted).all(|(unknown, near)| (*unknown - near).abs() <= room / omega);
        is_meant.then(|| Place { t, z, angles: self.turned(&here.angles, &z, t) })
    }
}

/// Largest magnitude of J⁻¹ b over all b with entries up to these.
fn bound<const ROWS: usize>(inverse: &Rows<ROWS>, most: &[f64; ROWS]) -> f64 {
    let part = |k: usize| (0..ROWS).map(|j| inverse[2 * k][j].hypot(inverse[2 * k + 1][j]) * most[j]).sum::<f64>();
    (0..ROWS / 2).map(part).fold(0.0, f64::max)
}

/// J⁻¹ times a vector.
fn applied<const UNKNOWNS: usize, const ROWS: usize>(inverse: &Rows<ROWS>, vector: &[f64; ROWS]) -> [Complex; UNKNOWNS] {
    let entry = |i: usize| (0..ROWS).map(|j| inverse[i][j] * vector[j]).sum();
    std::array::from_fn(|k| complex(entry(2 * k), entry(2 * k + 1)))
}

/// Largest magnitude.
fn norm<const UNKNOWNS: usize>(z: &[Complex; UNKNOWNS]) -> f64 {
    z.iter().map(|part| part.square()).fold(0.0, f64::max).sqrt()
}

/// Inverse by elimination with column pivoting.
fn inverse<const ROWS: usize>(mut matrix: Rows<ROWS>) -> Option<Rows<ROWS>> {
    let mut inverse: Rows<ROWS> = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    for column in 0..ROWS {
        let pivot = (column..ROWS).max_by(|i, j| matrix[*i][column].abs().total_cmp(&matrix[*j][column].abs()))?;
        let size = matrix[pivot][column];
        if !(size.abs() > 0.0 && size.is_finite()) {
            return None;
        }
        matrix.swap(column, pivot);
        inverse.swap(column, pivot);
        for j in 0..ROWS {
            matrix[column][j] /= size;
            inverse[column][j] /= size;
        }
        for i in (0..ROWS).filter(|i| *i != column) {
            let factor = matrix[i][column];
            for j in 0..ROWS {
                matrix[i][j] -= factor * matrix[column][j];
                inverse[i][j] -= factor * inverse[column][j];
            }
        }
    }
    Some(inverse)
}
