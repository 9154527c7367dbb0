//! The extreme values of a cam over one turn.

use crate::follower::Station;

/// A value (rad or m), and the angle of the cam (rad) at which it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Angle of the cam (rad).
    pub at: f64,
    /// The value (rad or m).
    pub value: f64,
}

/// The values by which a cam is judged, over all of its stations.
///
/// ```text
///   pressure angle             of translating followers up to 30°, of swinging ones up to 35° to 45°
///   smallest convex radius     of the pitch curve, larger than the roller; of the surface, as large as its stress demands
///   smallest hollow radius     of the surface, larger than the cutter and the grinding wheel
/// ```
///
/// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// The pressure angle of the largest magnitude, with its sign (rad).
    pub pressure_angle: Extreme,
    /// The smallest radius of curvature (m) where the curve is convex; `None` if it is so nowhere.
    pub convex: Option<Extreme>,
    /// The smallest radius of curvature (m) where the curve is hollow, as a positive number; `None` if it is so nowhere.
    pub hollow: Option<Extreme>,
}

impl Extremes {
    /// Of stations in any order; `None` if there are none. They are as exact as stations are close.
    #[must_use]
    pub fn of(stations: impl IntoIterator<Item = Station>) -> Option<Extremes> {
        let mut stations = stations.into_iter();
        let first = Extremes::at(&stations.next()?);
        Some(stations.fold(first, |found, station| found.joined(Extremes::at(&station))))
    }

    fn at(station: &Station) -> Extremes {
        let Station { curve, pressure_angle } = *station;
        let extreme = |value: f64| Extreme { at: curve.at, value };
        let radius = curve.radius_of_curvature();
        Extremes {
            pressure_angle: extreme(pressure_angle),
            convex: (curve.curvature > 0.0).then(|| extreme(radius)),
            hollow: (curve.curvature < 0.0).then(|| extreme(-radius)),
        }
    }

    fn joined(self, other: Extremes) -> Extremes {
        // An angle that is not a number is never hidden.
        let [own, others] = [self, other].map(|extremes| extremes.pressure_angle.value.abs());
        let is_larger = others > own || others.is_nan();
        Extremes {
            pressure_angle: if is_larger { other.pressure_angle } else { self.pressure_angle },
            convex: smaller(self.convex, other.convex),
            hollow: smaller(self.hollow, other.hollow),
        }
    }
}

fn smaller(one: Option<Extreme>, other: Option<Extreme>) -> Option<Extreme> {
    match (one, other) {
        (Some(a), Some(b)) => Some(if b.value < a.value { b } else { a }),
        (one, other) => one.or(other),
    }
}
