//! Balls with rates: the number type over which emitted code is evaluated for certificates.

use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::{SMatrix, SVector};

use super::ball::{Ball, ROUNDING};
use super::system::{excess, inverse, solve_all};
use super::twofold::Twofold;
use super::{EnclosureSolver, block, functions};
use crate::linear::{Elimination, FactorReal, Linear, Small, Sparse};
use crate::newton::{Block, Evaluate, Solved, StepError};
use crate::number::{DetSign, Real, SimdReal, Table};
use crate::solve::{ColdStart, SolverReal};

/// A quantity with its first and second derivative by time, each enclosed by an interval; the number type of
/// [`certify`](crate::Mechanism::certify).
///
/// Intervals have a centre of 32 digits and a radius, and are rounded outward. Derivatives are carried along by the rules of
/// differentiation, so that q̇ and q̈ are those of the q that fulfils Φ(q, t) = 0; the emitted ν and γ are not used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    pub(super) value: Ball,
    pub(super) rate: Ball,
    pub(super) acceleration: Ball,
}

const ZERO: Ball = Ball::exact(0.0);
const TWO: Ball = Ball::exact(2.0);

impl Enclosure {
    /// A constant.
    pub(super) const fn at_rest(value: Ball) -> Self {
        Self { value, rate: ZERO, acceleration: ZERO }
    }

    /// The time.
    pub(super) const fn time(t: f64) -> Self {
        Self { value: Ball::exact(t), rate: Ball::exact(1.0), acceleration: ZERO }
    }

    /// A function by its value and first two derivatives at this value.
    fn chain(self, [value, first, second]: [Ball; 3]) -> Self {
        let rate = first * self.rate;
        Self { value, rate, acceleration: second * (self.rate * self.rate) + first * self.acceleration }
    }

    /// A hull of both.
    fn hull(self, other: Self) -> Self {
        Self {
            value: self.value.hull(other.value),
            rate: self.rate.hull(other.rate),
            acceleration: self.acceleration.hull(other.acceleration),
        }
    }

    /// A function and its first two derivatives, with their rates as far as they are known: no third derivative is.
    fn derived(self, [value, first, second]: [Ball; 3]) -> (Self, Self, Self) {
        let unknown = Ball::anything();
        (
            self.chain([value, first, second]),
            Self { value: first, rate: second * self.rate, acceleration: unknown },
            Self { value: second, rate: unknown, acceleration: unknown },
        )
    }

    /// √(1 − x²)
    fn leg(self) -> Self {
        let one = Self::of(1.0);
        ((one - self) * (one + self)).sqrt()
    }
}

impl Add for Enclosure {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, rate: self.rate + other.rate, acceleration: self.acceleration + other.acceleration }
    }
}

impl Neg for Enclosure {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, rate: -self.rate, acceleration: -self.acceleration }
    }
}

impl Sub for Enclosure {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Enclosure {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self {
            value: a.value * b.value,
            rate: a.rate * b.value + a.value * b.rate,
            acceleration: a.acceleration * b.value + TWO * (a.rate * b.rate) + a.value * b.acceleration,
        }
    }
}

impl Div for Enclosure {
    type Output = Self;
    /// q b = a, once and twice differentiated.
    fn div(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let value = a.value / b.value;
        let rate = (a.rate - value * b.rate) / b.value;
        let acceleration = (a.acceleration - TWO * (rate * b.rate) - value * b.acceleration) / b.value;
        Self { value, rate, acceleration }
    }
}

impl Real for Enclosure {
    fn of(value: f64) -> Self {
        Self::at_rest(Ball::exact(value))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = functions::sin_cos(self.value);
        (self.chain([sine, cosine, -sine]), self.chain([cosine, -sine, -cosine]))
    }

    /// r² = x, once and twice differentiated.
    fn sqrt(self) -> Self {
        let value = functions::sqrt(self.value);
        let rate = self.rate / (TWO * value);
        let acceleration = (self.acceleration / TWO - rate * rate) / value;
        Self { value, rate, acceleration }
    }

    fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    fn asin(self) -> Self {
        self.atan2(self.leg())
    }

    fn acos(self) -> Self {
        self.leg().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::of(1.0))
    }

    /// θ̇ = (x ẏ − y ẋ) / r², with r² = x² + y².
    fn atan2(self, x: Self) -> Self {
        let y = self;
        let square = x.value * x.value + y.value * y.value;
        let rate = (x.value * y.rate - y.value * x.rate) / square;
        let turned = x.value * y.acceleration - y.value * x.acceleration;
        let acceleration = (turned - TWO * (rate * (x.value * x.rate + y.value * y.rate))) / square;
        Self { value: functions::atan2(y.value, x.value), rate, acceleration }
    }

    fn exp(self) -> Self {
        let power = functions::exp(self.value);
        self.chain([power, power, power])
    }

    fn ln(self) -> Self {
        let rate = self.rate / self.value;
        Self { value: functions::ln(self.value), rate, acceleration: self.acceleration / self.value - rate * rate }
    }

    fn abs(self) -> Self {
        let either = match ZERO.is_less(self.value) {
            Some(true) => self,
            Some(false) => -self,
            None => self.hull(-self),
        };
        Self { value: self.value.abs(), ..either }
    }

    fn sign(self) -> Self {
        if self.value.is_zero() || !self.value.may_vanish() {
            return Self::at_rest(Ball::exact(Real::sign(self.value.center.high)).with_doubts_of(self.value));
        }
        let unknown = Ball::anything();
        Self { value: Ball::around(Twofold::of(0.0), 1.0).doubted(), rate: unknown, acceleration: unknown }
    }

    /// The hull of both if the comparison is undecided; nothing is proven then, since there may be a jump.
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        let selected = match lhs.value.is_less(rhs.value) {
            Some(true) => then,
            Some(false) => otherwise,
            None => Self { value: otherwise.value.hull(then.value).doubted(), ..otherwise.hull(then) },
        };
        let value = selected.value.with_doubts_of(lhs.value).with_doubts_of(rhs.value);
        Self { value, ..selected }
    }

    fn table(self, table: &Table) -> (Self, Self, Self) {
        let (value, first, second) = functions::table(self.value, table);
        self.derived([value, first, second])
    }

    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        self.derived(self.value.map(function))
    }
}

/// Comparisons decide nothing here: a block is enclosed as a whole, and of the result only q is used.
impl SimdReal for Enclosure {
    type Mask = bool;
    type Signs = DetSign;

    const EPSILON: Self = Self::at_rest(Ball::exact(ROUNDING));
    const ROOT_EPSILON: Self = Self::at_rest(Ball::exact(1.0 / 2_251_799_813_685_248.0)); // 2⁻⁵¹

    fn at_most(self, _: Self) -> bool {
        true
    }

    fn pick(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    fn signs(self) -> DetSign {
        self.value.center.high.signs()
    }

    fn same_signs(a: DetSign, b: DetSign) -> bool {
        a == b
    }

    fn fast_sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

impl FactorReal for Enclosure {
    type Small<const K: usize> = Small<Self, K>;
    type Sparse<E, const K: usize, const ENTRIES: usize, const FACTORS: usize>
        = Sparse<Self, E, K, ENTRIES, FACTORS>
    where
        E: Elimination<Self, K, ENTRIES, FACTORS>;
    type Dense<const K: usize> = Inverse<K>;
}

impl SolverReal for Enclosure {
    type Cold<'a, const N: usize> = EnclosureSolver<N>;
}

impl<const N: usize> ColdStart<Enclosure, N> for EnclosureSolver<N> {
    fn lengths(&self) -> (Enclosure, Enclosure) {
        self.lengths
    }

    fn solve_block<L: Linear<Enclosure, K>, const K: usize>(
        &self,
        block: &Block<K>,
        _: [Enclosure; K],
        evaluate: &Evaluate<'_, Enclosure, L, K>,
    ) -> Result<Solved<Enclosure, L, K>, StepError<Enclosure>> {
        block::solve(self, block, evaluate)
    }

    /// An equation holds if zero is among its residuals.
    fn check(&self, row: usize, residual: Enclosure, _: Enclosure) {
        if !residual.value.may_vanish() && self.off.get().is_none() {
            self.off.set(Some(row));
        }
    }
}

/// A matrix with an approximate inverse, by which emitted code solves for rates: the entries of its solutions are enclosed, their rates are
/// unknown.
#[derive(Clone, Debug)]
pub struct Inverse<const K: usize> {
    matrix: SMatrix<Ball, K, K>,
    /// R, and an upper bound of |I − R A|; none if A is singular.
    inverse: Option<[SMatrix<f64, K, K>; 2]>,
}

impl<const K: usize> Linear<Enclosure, K> for Inverse<K> {
    type Matrix = SMatrix<Enclosure, K, K>;

    fn factor(matrix: &Self::Matrix) -> Result<Self, usize> {
        let matrix = matrix.map(|entry| entry.value);
        let inverse = inverse(&matrix).map(|inverse| [inverse, excess(&inverse, &matrix)]);
        Ok(Self { matrix, inverse })
    }

    fn dense(matrix: &Self::Matrix) -> SMatrix<Enclosure, K, K> {
        *matrix
    }

    fn solve_regular(&self, b: &SVector<Enclosure, K>) -> SVector<Enclosure, K> {
        let unknown = Ball::anything();
        let values = match &self.inverse {
            Some([inverse, spread]) => solve_all(&self.matrix, inverse, spread, &b.map(|entry| entry.value)),
            None => SVector::from_element(unknown),
        };
        let is_proven = b.iter().all(|entry| entry.value.is_proven) && self.matrix.iter().all(|entry| entry.is_proven);
        values.map(|value| Enclosure { value: Ball { is_proven, ..value }, rate: unknown, acceleration: unknown })
    }

    fn solve(&self, b: &SVector<Enclosure, K>) -> SVector<Enclosure, K> {
        self.solve_regular(b)
    }

    fn solve_refined(&self, b: &SVector<Enclosure, K>) -> SVector<Enclosure, K> {
        self.solve_regular(b)
    }

    fn error_amplification(&self, _: &SVector<Enclosure, K>, _: &SVector<Enclosure, K>) -> Enclosure {
        Enclosure::at_rest(Ball::anything())
    }

    fn det_sign(&self) -> DetSign {
        DetSign::Positive
    }

    fn is_regular(&self) -> bool {
        true
    }
}
