//! Verification of a state: Φ, Φ_q, ν and γ in 32 digits.

use reuleaux::nalgebra::SVector;
use reuleaux::{CoordinateKind, Equations, Float, State};
use reuleaux_tests::common::twofold::Twofold;

/// Residuals up to this many rounding errors of their terms are accepted.
const POSITION: f64 = 256.0;

/// The same for rates: Φ_q is evaluated before the last correction.
const RATES: f64 = 1e5;

/// Verifies that a state satisfies the equations of a mechanism.
///
/// * `iterated`: given, the coordinates found by Newton's method.
/// * `is_moderate`: given, false if a parameter is so large that others are lost to rounding; residuals are then not tested.
///
/// # Errors
/// The violated property.
pub(crate) fn judge<T: Float, E: Equations<Twofold, M, N>, const M: usize, const N: usize>(
    exact: &E,
    is_moderate: bool,
    iterated: &[usize],
    state: &State<T, N>,
) -> Result<(), String> {
    let lifted = |vector: &SVector<T, N>| vector.map(|entry| Twofold::from(entry.to_f64()));
    for (name, vector) in [("q", &state.q), ("rate of q", &state.qd), ("acceleration of q", &state.qdd)] {
        if let Some(i) = vector.iter().position(|entry| !entry.is_finite()) {
            return Err(format!("{name}[{i}] is {:?}", vector[i]));
        }
    }
    let (condition, epsilon) = (state.condition.to_f64(), T::EPSILON.to_f64());
    if !state.t.is_finite() || condition.is_nan() || condition * epsilon >= 1.0 {
        return Err(format!("t = {:?}, condition = {condition:?}", state.t));
    }
    // An iterated angle must have significant digits; a computed angle follows its law, which may have lost them at a very large time.
    let is_lost = |i: &usize| E::COORDINATES[*i].kind == CoordinateKind::Angle && state.q[*i].to_f64().abs() * epsilon > 1.0;
    if let Some(i) = iterated.iter().copied().find(is_lost) {
        return Err(format!("no digit of {} is left in {:?}", E::COORDINATES[i], state.q[i]));
    }
    let is_moderate = is_moderate && !(0..N).any(|i| is_lost(&i));
    // Residuals are not tested if parameters are extreme or an angle has lost all digits.
    if !is_moderate {
        return Ok(());
    }
    let (q, qd, qdd, t) = (lifted(&state.q), lifted(&state.qd), lifted(&state.qdd), Twofold::from(state.t.to_f64()));
    let (phi, jacobian) = exact.linearize(&q, t);
    let (nu, gamma) = (exact.nu(&q, t), exact.gamma(&q, &qd, t));
    let least = if epsilon > 1e-10 { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let greatest = |vector: &SVector<T, N>, kind: CoordinateKind| {
        let of_kind = vector.iter().zip(E::COORDINATES).filter(|(_, coordinate)| coordinate.kind == kind);
        of_kind.map(|(entry, _)| entry.to_f64().abs()).fold(0.0, f64::max)
    };
    let sizes = |vector: &SVector<T, N>, least: [f64; 2]| {
        let size = |coordinate: &reuleaux::Coordinate| match coordinate.kind {
            CoordinateKind::Length => greatest(vector, coordinate.kind).max(least[0]),
            CoordinateKind::Angle | reuleaux::CoordinateKind::Number => greatest(vector, coordinate.kind).max(least[1]),
        };
        E::COORDINATES.iter().map(size).collect::<Vec<f64>>()
    };
    let length = exact.characteristic_length().high.abs();
    let places = sizes(&state.q, [if length.is_finite() { length } else { 1.0 }, 1.0]);
    let (rates, accelerations) = (sizes(&state.qd, [0.0; 2]), sizes(&state.qdd, [0.0; 2]));
    // Highest angular velocity, with which errors of positions enter those of rates.
    let speed = greatest(&state.qd, CoordinateKind::Angle);
    // Residuals of checked equations amplify the errors of the solved ones by the condition.
    let spread = if M > N { condition } else { 1.0 };
    for row in 0..M {
        let slopes: Vec<Twofold> = (0..N).map(|j| jacobian[(row, j)]).collect();
        let weighed = |sizes: &[f64]| slopes.iter().zip(sizes).map(|(slope, size)| slope.high.abs() * size).sum::<f64>();
        let times = |vector: &SVector<Twofold, N>| slopes.iter().zip(vector.iter()).fold(Twofold::from(0.0), |sum, (a, b)| sum + *a * *b);
        let time = nu[row].high.abs() * state.t.to_f64().abs();
        let at_rest = weighed(&vec![1.0; N]);
        let of = [
            ("Φ", phi[row], POSITION * (weighed(&places) + time)),
            ("Φ_q q̇ − ν", times(&qd) - nu[row], RATES * (weighed(&rates) + nu[row].high.abs() + speed * weighed(&places))),
            (
                "Φ_q q̈ − γ",
                times(&qdd) - gamma[row],
                RATES * (weighed(&accelerations) + gamma[row].high.abs() + speed * (weighed(&rates) + speed * weighed(&places))),
            ),
        ];
        for (name, residual, size) in of {
            let allowed = spread * epsilon * size + 64.0 * least * (1.0 + at_rest);
            // Numbers whose squares overflow are not tested.
            if residual.high.abs() > allowed || (residual.high.is_nan() && (size * size).is_finite()) {
                let joint = E::ROWS[row];
                return Err(format!("{name} of {joint} is {:e}, allowed {allowed:e}", residual.high));
            }
        }
    }
    Ok(())
}
