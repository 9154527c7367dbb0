//! End of travel or crossing of branches shortly after a pose.
//!
//! In: a [`Chain`] and a pose after which no step succeeds. Out: an end of travel, a crossing of two branches, or neither.
//!
//! The block is followed along its own curve instead of the path (pseudo-arclength continuation). With y its unknowns and s the distance
//! along the curve,
//!
//! ```text
//! F(y, u(t), t) = 0      c·(y − y₀) = s        u the unknowns of blocks before it
//! ```
//!
//! is regular even where Φ_q is singular. Where dt/ds changes sign the curve turns back: beyond that t there is no solution nearby. Where
//! the determinant of this system changes sign, another branch crosses, and t continues.
//!
//! Reference: Keller (1977), Numerical solution of bifurcation and nonlinear eigenvalue problems.

use super::chain::{Chain, PathPose, Stop};
use crate::linear::dense::Factors;

/// Largest number of steps along the curve.
const MOST_STEPS: usize = 60;

/// Longest step, in rad and characteristic lengths.
const LONGEST: f64 = 0.2;

/// Smallest cosine of the angle by which the curve turns in one step.
const STRAIGHT: f64 = 0.95;

/// Closer to a crossing than this fraction of a step, rounding decides.
const NEARLY: f64 = 1e-4;

/// Largest number of iterations that bracket the zero of dt/ds.
const MOST_HALVINGS: usize = 100;

/// An end of travel or a crossing of branches.
#[derive(Clone, Debug)]
pub(super) struct Event {
    /// Member that ends or crosses.
    pub(super) member: usize,
    pub(super) at: f64,
    /// q; valid for the member and the members on which it depends.
    pub(super) q: Vec<f64>,
}

/// Event found after a pose.
#[derive(Debug)]
pub(super) enum Outlook {
    End(Event),
    Crossing(Event),
    /// The motion continues, or nothing is known about it.
    Nothing,
}

/// A point on the curve of a block.
#[derive(Clone)]
struct Spot {
    at: f64,
    q: Vec<f64>,
    /// Rates of the blocks before it.
    rates: Vec<f64>,
    /// dy/ds in scaled unknowns, and dt/ds.
    tangent: Vec<f64>,
    /// Sign of the determinant of the augmented system.
    sign: f64,
}

impl Spot {
    fn pace(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }

    fn direction(&self) -> Vec<f64> {
        unit(&self.tangent[..self.tangent.len() - 1])
    }
}

/// Direction along which s is measured from a point: c and y₀.
struct Ruler {
    from: Vec<f64>,
    along: Vec<f64>,
}

impl Chain<'_> {
    /// Follows the curve of a member until t has advanced by `reach`.
    pub(super) fn look(&mut self, member: usize, here: &PathPose, reach: f64) -> Outlook {
        self.looked(member, here, reach).unwrap_or(Outlook::Nothing)
    }

    fn looked(&mut self, index: usize, here: &PathPose, reach: f64) -> Option<Outlook> {
        let member = &self.members[index];
        let rates: Vec<f64> = member.unknowns.iter().zip(&member.scales).map(|(unknown, scale)| here.rates[*unknown] / scale).collect();
        let speed = rates.iter().map(|rate| rate * rate).sum::<f64>().sqrt();
        if speed == 0.0 || !speed.is_finite() {
            return None;
        }
        let (mut along, mut step) = (unit(&rates), (reach / 9.3 * speed).clamp(1e-6, LONGEST));
        let mut spot = self.spot(index, (here.at, &here.q, &here.rates), &along)?;
        for _ in 0..MOST_STEPS {
            let next = loop {
                let next = self.along(index, &spot, &along, step);
                let is_straight = |next: &&Spot| dot(&next.direction(), &along) >= STRAIGHT;
                if let Some(next) = next.as_ref().filter(is_straight) {
                    break next.clone();
                }
                step /= 2.0;
                if step < 1e-9 {
                    return None;
                }
            };
            match (next.pace() > 0.0, next.sign == spot.sign) {
                (true, true) => {}
                (false, true) => return self.turn(index, spot, next, &along, step).map(Outlook::End),
                (true, false) => return self.crossing(index, spot, next, &along, step).map(Outlook::Crossing),
                (false, false) => return None,
            }
            if next.at > here.at + reach {
                return Some(Outlook::Nothing);
            }
            // The determinant keeps its sign when c is replaced by the new direction, since the two are close.
            along = next.direction();
            spot = self.spot(index, (next.at, &next.q, &next.rates), &along)?;
            step = (step * 1.5).min(LONGEST);
        }
        None
    }

    /// Finds the zero of dt/ds between two points, where t has its maximum.
    fn turn(&mut self, index: usize, before: Spot, after: Spot, along: &[f64], step: f64) -> Option<Event> {
        // Regula falsi; the weight of an end that stays is halved (Illinois method).
        let (mut low, mut high) = ((0.0, before.pace()), (step, after.pace()));
        let mut best = before.clone();
        for _ in 0..MOST_HALVINGS {
            let way = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
            let spot = self.along(index, &before, along, way)?;
            let pace = spot.pace();
            best = spot;
            // t is stationary here: an error in s enters t squared.
            if pace == 0.0 || pace.abs() <= 1e-11 * before.pace().abs() || high.0 - low.0 <= 1e-10 * step {
                break;
            }
            if pace > 0.0 {
                low = (way, pace);
                high.1 /= 2.0;
            } else {
                high = (way, pace);
                low.1 /= 2.0;
            }
        }
        let margin = 8.0 * f64::EPSILON * best.at.abs();
        let is_end = best.sign == before.sign && best.at > before.at + margin && best.at > after.at + margin;
        is_end.then_some(Event { member: index, at: best.at, q: best.q })
    }

    /// Finds the crossing of another branch between two points.
    fn crossing(&mut self, index: usize, before: Spot, after: Spot, along: &[f64], step: f64) -> Option<Event> {
        let (mut low, mut high, mut nearest) = (0.0, step, after.clone());
        for _ in 0..30 {
            let way = (low + high) / 2.0;
            // The system is singular at the crossing itself.
            let Some(spot) = self.along(index, &before, along, way) else { break };
            if spot.pace() <= 0.0 {
                if high - low > NEARLY * step {
                    return None;
                }
                break;
            }
            if spot.sign == before.sign {
                low = way;
            } else {
                high = way;
            }
            nearest = spot;
        }
        (nearest.at > before.at && nearest.at < after.at).then_some(Event { member: index, at: nearest.at, q: nearest.q })
    }

    /// The point at a distance along the curve from another point.
    fn along(&mut self, index: usize, from: &Spot, along: &[f64], way: f64) -> Option<Spot> {
        let lead: f64 = dot(&from.tangent[..along.len()], along);
        let (share, mut q) = (way / lead, from.q.clone());
        let member = &self.members[index];
        for ((unknown, scale), rate) in member.unknowns.iter().zip(&member.scales).zip(&from.tangent) {
            q[*unknown] += share * rate * scale;
        }
        let moved = share * from.pace();
        for member in self.before(index) {
            for unknown in &self.members[member].unknowns {
                q[*unknown] += moved * from.rates[*unknown];
            }
        }
        let origin: Vec<f64> = member.unknowns.iter().zip(&member.scales).map(|(unknown, scale)| from.q[*unknown] / scale).collect();
        let ruler = Ruler { from: origin, along: along.to_vec() };
        self.settle(index, (from.at + moved, q, from.rates.clone()), &ruler, way, 0.25 * way.abs() + 1e-9)
    }

    /// The point at a solved configuration.
    fn spot(&mut self, index: usize, (at, q, rates): (f64, &[f64], &[f64]), along: &[f64]) -> Option<Spot> {
        let member = &self.members[index];
        let origin: Vec<f64> = member.unknowns.iter().zip(&member.scales).map(|(unknown, scale)| q[*unknown] / scale).collect();
        let ruler = Ruler { from: origin, along: along.to_vec() };
        self.settle(index, (at, q.to_vec(), rates.to_vec()), &ruler, 0.0, 1e-3)
    }

    /// Newton's method for the block's unknowns and t; the blocks before it are solved at each t.
    fn settle(
        &mut self,
        index: usize,
        (mut at, mut q, mut rates): (f64, Vec<f64>, Vec<f64>),
        ruler: &Ruler,
        way: f64,
        farthest: f64,
    ) -> Option<Spot> {
        let upstream = self.before(index);
        let n = self.members[index].unknowns.len();
        let mut last = f64::INFINITY;
        for iteration in 0..16 {
            for before in &upstream {
                self.exactly(*before, at, &mut q, &mut rates).ok()?;
            }
            let local = self.local(index, at, &q, &rates).ok()?;
            let member = &self.members[index];
            let place: Vec<f64> = member
                .unknowns
                .iter()
                .zip(&member.scales)
                .zip(&ruler.from)
                .map(|((unknown, scale), from)| q[*unknown] / scale - from)
                .collect();
            // Scale of t that makes it comparable with a coordinate.
            let unit_of_time = 1.0 / local.drift.iter().fold(0.0, |most: f64, drift| most.max(drift.abs()));
            let mut matrix: Vec<Vec<f64>> = local
                .jacobian
                .iter()
                .zip(&local.drift)
                .map(|(row, drift)| row.iter().copied().chain([drift * unit_of_time]).collect())
                .collect();
            matrix.push(ruler.along.iter().copied().chain([0.0]).collect());
            let factors = Factors::new(matrix)?;
            let right: Vec<f64> = local.phi.iter().copied().chain([dot(&ruler.along, &place) - way]).collect();
            let step = factors.solve(&right)?;
            let size = step.iter().fold(0.0, |most: f64, step| most.max(step.abs()));
            if !size.is_finite() || iteration == 0 && size > farthest {
                return None;
            }
            for ((unknown, scale), step) in member.unknowns.iter().zip(&member.scales).zip(&step) {
                q[*unknown] -= step * scale;
            }
            let moved = step[n] * unit_of_time;
            at -= moved;
            for before in &upstream {
                for unknown in &self.members[*before].unknowns {
                    q[*unknown] -= moved * rates[*unknown];
                }
            }
            let own = place.iter().zip(&ruler.from).fold(1.0, |most: f64, (place, from)| most.max((place + from).abs()));
            let greatest = own.max(at.abs() / unit_of_time);
            let is_rounding = size <= 1e-14 * greatest;
            if is_rounding || size >= last / 2.0 {
                if !is_rounding && size > 1e-10 * greatest {
                    return None;
                }
                let mut right = vec![0.0; n + 1];
                right[n] = 1.0;
                let mut tangent = factors.solve(&right)?;
                tangent[n] *= unit_of_time;
                return Some(Spot { at, q, rates, tangent, sign: factors.sign });
            }
            last = size;
        }
        None
    }

    fn exactly(&mut self, index: usize, at: f64, q: &mut [f64], rates: &mut [f64]) -> Result<(), Stop> {
        self.solve(index, at, q, rates, 0.0).map(|_| ())
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn unit(vector: &[f64]) -> Vec<f64> {
    let length = dot(vector, vector).sqrt();
    vector.iter().map(|entry| entry / length).collect()
}
