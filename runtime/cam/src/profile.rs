//! Cams that are known by points: closed curves as polar functions, and readings without their noise.

use core::f64::consts::{PI, TAU};

use reuleaux::Motion;

use crate::{CamError, CurvePoint};

/// A closed curve round the origin, in polar coordinates: R(ψ) with its first and second derivative.
///
/// ```text
///         p₁ ·                R, R′ and R″ at each point are those of the point, its normal and its curvature;
///      p₂ ·     · p₀          between two points R is the polynomial of the fifth degree that has these six values
///        ψ ╲ O
/// ```
///
/// So a measured surface becomes the profile of a joint: points of the surface give points of the pitch curve, and for the joint `cam_roller`
/// of `reuleaux` the function R(ψ) − ρ. R″ is continuous. No point may lie behind another one as seen from the origin.
#[derive(Clone, Copy, Debug)]
pub struct Profile<'a> {
    points: &'a [CurvePoint],
    /// 1 if the points go round counter-clockwise, otherwise −1.
    sense: f64,
}

impl<'a> Profile<'a> {
    /// Through points in their order, each once.
    ///
    /// # Errors
    /// [`CamError::NotRound`] at a point from which the curve does not go on round the origin, in the same sense and by less than half a turn,
    /// or where it comes back to the first point after another number of turns than one; [`CamError::NoNormal`] where it runs along a radius.
    pub fn new(points: &'a [CurvePoint]) -> Result<Profile<'a>, CamError> {
        let (Some(first), Some(second)) = (points.first(), points.get(1)) else {
            return Err(CamError::NotRound { at: points.first().map_or(0.0, |point| point.at) });
        };
        let sense = if step(first, second) < 0.0 { -1.0 } else { 1.0 };
        let mut turned = 0.0;
        for (point, next) in points.iter().zip(points.iter().cycle().skip(1)) {
            point.polar_radius()?;
            let angle = sense * step(point, next);
            turned += angle;
            // False for NaN. The last step may only close the turn.
            if !(angle > 0.0 && angle < PI && turned < TAU + 1.0) {
                return Err(CamError::NotRound { at: point.at });
            }
        }
        if (turned - TAU).abs() < 1.0 { Ok(Profile { points, sense }) } else { Err(CamError::NotRound { at: first.at }) }
    }

    /// R (m) in the direction ψ (rad) of the cam, with its derivatives by ψ.
    #[must_use]
    pub fn radius(&self, psi: f64) -> Motion<f64> {
        let (first, count) = (&self.points[0], self.points.len());
        let angle_to = |index: usize| turn(self.sense * (self.points[index].direction_angle() - first.direction_angle()));
        let wanted = turn(self.sense * (psi - first.direction_angle()));
        // The last point that is not beyond: the first one has the angle 0.
        let (mut before, mut beyond) = (0, count);
        while beyond - before > 1 {
            let middle = before + (beyond - before) / 2;
            if angle_to(middle) <= wanted { before = middle } else { beyond = middle }
        }
        let (from, to) = (&self.points[before], &self.points[(before + 1) % count]);
        let begin = if before == 0 { 0.0 } else { angle_to(before) };
        let width = self.sense * step(from, to);
        let [from, to] = [from, to].map(|point| self.in_sense(point.polar_radius().unwrap_or(Motion::at(f64::NAN))));
        self.in_sense(Motion::between(&from, &to, [width; 2], (wanted - begin) / width))
    }

    /// The derivatives by an angle that grows from point to point, and back.
    fn in_sense(&self, radius: Motion<f64>) -> Motion<f64> {
        Motion { rate: self.sense * radius.rate, ..radius }
    }
}

/// The angle from one point to the next, between −π and π.
fn step(from: &CurvePoint, to: &CurvePoint) -> f64 {
    turn(to.direction_angle() - from.direction_angle() + PI) - PI
}

/// The same angle between 0 and 2π.
fn turn(angle: f64) -> f64 {
    angle - TAU * libm::floor(angle / TAU)
}

/// The first `K` harmonics of readings at equal angles over one turn, without what is finer: a measured radius, or the lift that a dial gauge shows.
///
/// ```text
///   R(ψ) = a₀ + Σ aₖ cos kψ + bₖ sin kψ,   k = 1 … K
///   a₀ = 1/n Σ Rᵢ,   aₖ = 2/n Σ Rᵢ cos kψᵢ,   bₖ = 2/n Σ Rᵢ sin kψᵢ,   ψᵢ = 2π i / n
/// ```
///
/// These are the coefficients of least squares. Where readings scatter by σ, R″ scatters by σ √(2/n Σ k⁴): with 360 readings and ten harmonics
/// by 12 σ/rad², where the second difference of neighbouring readings scatters by 8000 σ/rad².
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, on measured cams; Bronshtein and others, Handbook of Mathematics, on harmonic analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonics<const K: usize> {
    mean: f64,
    waves: [[f64; 2]; K],
}

impl<const K: usize> Harmonics<K> {
    /// Of readings at ψ = 0, 2π/n, 4π/n, …; `None` if there are fewer than 2K + 1.
    #[must_use]
    pub fn of(readings: &[f64]) -> Option<Harmonics<K>> {
        let count = readings.len();
        if count < 2 * K + 1 {
            return None;
        }
        let share = 1.0 / count as f64;
        let wave = |k: usize| {
            let sum = readings.iter().enumerate().fold([0.0, 0.0], |[a, b], (i, reading)| {
                // The angle within one turn, as exact as it can be.
                let (sine, cosine) = libm::sincos(TAU * ((k * i) % count) as f64 * share);
                [a + reading * cosine, b + reading * sine]
            });
            sum.map(|sum| 2.0 * share * sum)
        };
        Some(Harmonics { mean: readings.iter().sum::<f64>() * share, waves: core::array::from_fn(|index| wave(index + 1)) })
    }

    /// The value in the direction ψ (rad), with its first and second derivative by ψ.
    #[must_use]
    pub fn at(&self, psi: f64) -> Motion<f64> {
        let mut sum = Motion::at(self.mean);
        for (index, [a, b]) in self.waves.iter().enumerate() {
            let k = (index + 1) as f64;
            let (sine, cosine) = libm::sincos(k * psi);
            let wave = a * cosine + b * sine;
            sum.value += wave;
            sum.rate += k * (b * cosine - a * sine);
            sum.acceleration -= k * k * wave;
        }
        sum
    }
}
