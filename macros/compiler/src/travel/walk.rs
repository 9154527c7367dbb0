//! Step control along the path.
//!
//! In: a [`Chain`] and its start. Out: the end of the path, or the event at which the motion stops. A step is accepted only if the new
//! rates agree with the old ones, so that the solution cannot jump to another assembly. Not done here: distinguishing an end of travel from
//! a region of small steps (`turn`).

use super::chain::{Chain, PathPose, Stop};
use super::turn::{Event, Outlook};

/// Largest movement of a block in a step, in rad and characteristic lengths.
const LONGEST: f64 = 0.6;

/// Movement below which rates do not predict a step, in rad and characteristic lengths.
const LITTLE: f64 = 1e-3;

/// Largest first correction, and largest difference of old and new rates, as fractions of the movement.
const SURPRISE: [f64; 2] = [0.25, 0.05];

/// Error that may remain, as a fraction of the movement.
const ENOUGH: f64 = 1e-7;

/// Smallest number of steps of a path; not a whole number, so that no step ends where symmetric mechanisms are singular.
const FEWEST: f64 = 25.3;

/// A step shorter than this fraction of the longest is investigated.
const SHORT: f64 = 1.0 / 64.0;

/// Shortest step, as a fraction of the path.
const SHORTEST: f64 = 1e-12;

/// An end is reached when this fraction of the path to it is left: another block may end shortly before.
const AT_AN_END: f64 = 1e-7;

/// Result of following a path.
#[derive(Debug)]
pub(super) enum Way {
    /// The end of the path.
    Through(PathPose),
    /// An end of travel.
    End(Event),
    /// A crossing of two branches.
    Crossing(Event),
    /// Nothing is known: no step succeeded, or the budget is spent.
    Lost,
}

impl Chain<'_> {
    /// The start as a pose, with all members solved to rounding.
    pub(super) fn begin(&mut self, q: &[f64]) -> Option<PathPose> {
        let mut pose = PathPose { at: 0.0, q: q.to_vec(), rates: vec![0.0; q.len()], sides: Vec::new() };
        for index in 0..self.members.len() {
            let local = self.local(index, 0.0, &pose.q, &pose.rates).ok()?;
            self.members[index].level(&local.jacobian);
            let settled = self.solve(index, 0.0, &mut pose.q, &mut pose.rates, 0.0).ok()?;
            // The start is closed: a solution elsewhere is a failure.
            if settled.correction > LITTLE {
                return None;
            }
            pose.sides.push((settled.sign, settled.size));
        }
        Some(pose)
    }

    /// Follows the path to its end. `stops`: given, increasing values of s that no step crosses.
    pub(super) fn follow(&mut self, start: PathPose, until: f64, stops: &[f64]) -> Way {
        let longest = until / FEWEST;
        let (mut here, mut before): (PathPose, Option<PathPose>) = (start, None);
        let mut step = self.reach(&here).min(longest);
        let mut short = vec![longest * SHORT; self.members.len()];
        let mut end: Option<Event> = None;
        loop {
            let left = until - here.at;
            if left <= SHORTEST * until {
                return Way::Through(here);
            }
            let mut next = here.at + step;
            if let Some(end) = &end {
                if end.at - here.at <= AT_AN_END * end.at {
                    return Way::End(end.clone());
                }
                next = next.min((here.at + end.at) / 2.0);
            }
            let stop = stops.iter().copied().find(|stop| *stop > here.at + SHORTEST * until).unwrap_or(until).min(until);
            if next > stop - SHORTEST * until {
                next = stop;
            }
            let taken = next - here.at;
            match self.step(&here, before.as_ref(), next) {
                Ok((there, off)) => {
                    // The error is of third order in the step.
                    let growth = (0.3 / off.max(1e-9)).cbrt().clamp(0.3, 2.0);
                    step = (taken * growth).max(step.min(taken)).min(longest).min(self.reach(&there));
                    before = Some(std::mem::replace(&mut here, there));
                }
                Err(Stop::Spent) => return Way::Lost,
                Err(Stop::Member(member)) => {
                    step = taken / 2.0;
                    if step < SHORTEST * until {
                        // If a block fails before the end found for another, the rest of the path is unknown.
                        return end.filter(|end| end.member == member).map_or(Way::Lost, Way::End);
                    }
                    let is_known = end.as_ref().is_some_and(|end| end.member == member);
                    if step < short[member] && !is_known {
                        short[member] = step / 16.0;
                        match self.look(member, &here, 8.0 * taken) {
                            Outlook::End(found) if end.as_ref().is_none_or(|end| found.at < end.at) => end = Some(found),
                            Outlook::Crossing(found) if end.as_ref().is_none_or(|end| found.at < end.at) => return Way::Crossing(found),
                            _ => {}
                        }
                    }
                }
            }
        }
    }

    /// Distance along the path until the fastest block has moved by `LONGEST`.
    fn reach(&self, pose: &PathPose) -> f64 {
        let fastest = |most: f64, member: &super::chain::Member| {
            if member.is_iterated { most.max(member.most(|unknown| pose.rates[unknown])) } else { most }
        };
        LONGEST / self.members.iter().fold(0.0, fastest)
    }

    /// Takes one step; also returns the largest difference of old and new rates, as a fraction of the allowed one.
    fn step(&mut self, here: &PathPose, before: Option<&PathPose>, next: f64) -> Result<(PathPose, f64), Stop> {
        let h = next - here.at;
        // Second derivatives from the last step; wrong after a kink, and dropped if the step is much longer.
        let last = before.map(|before| (before, here.at - before.at)).filter(|(_, last)| h <= 3.0 * last);
        let mut there =
            PathPose { at: next, q: here.q.clone(), rates: vec![0.0; here.q.len()], sides: Vec::with_capacity(self.members.len()) };
        let mut worst = 0.0_f64;
        for index in 0..self.members.len() {
            let failed = Stop::Member(index);
            for &unknown in &self.members[index].unknowns {
                let bend = last.map_or(0.0, |(before, last)| (here.rates[unknown] - before.rates[unknown]) / last);
                there.q[unknown] += h * (here.rates[unknown] + h * bend / 2.0);
            }
            let expected = h * self.members[index].most(|unknown| here.rates[unknown]) + LITTLE;
            let settled = self.solve(index, next, &mut there.q, &mut there.rates, ENOUGH * expected)?;
            there.sides.push((settled.sign, settled.size));
            let member = &self.members[index];
            if !member.is_iterated {
                continue;
            }
            let way = member.most(|unknown| there.q[unknown] - here.q[unknown]);
            let way = LITTLE + way.max(expected).max(h * member.most(|unknown| there.rates[unknown]));
            let off = member.most(|unknown| there.q[unknown] - here.q[unknown] - h / 2.0 * (here.rates[unknown] + there.rates[unknown]));
            let keeps_side = settled.sign == here.sides[index].0;
            if !keeps_side || settled.correction > SURPRISE[0] * way || off > SURPRISE[1] * way || way > 4.0 * LONGEST {
                return Err(failed);
            }
            worst = worst.max(off / (SURPRISE[1] * way));
        }
        Ok((there, worst))
    }
}
