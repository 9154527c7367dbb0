//! Step by step along the path.
//!
//! In: a [`Chain`] and where it starts. Out: whether the motion goes on to the end of the path, or where it stops. A step is taken
//! only if the new rates say the same of it as the old ones, so that no other assembly is taken for this one. Not done here: how
//! an end is told from a narrow place (`turn`).

use super::chain::{Chain, PathPose, Stop};
use super::turn::Seen;

/// What a block moves in a step at most, in rad and in lengths of the block.
const LONGEST: f64 = 0.6;

/// What counts as moving, in the same: rates that are smaller say little of a step.
const LITTLE: f64 = 1e-3;

/// The first correction may be this part of a step, and old and new rates may differ by this part of it.
const SURPRISE: [f64; 2] = [0.25, 0.05];

/// The error that may remain, as a part of a step.
const ENOUGH: f64 = 1e-7;

/// The path in steps, at least; no whole number, so that none falls on the places at which symmetric mechanisms are singular.
const FEWEST: f64 = 25.3;

/// A step that is shorter than this part of the longest is looked into.
const SHORT: f64 = 1.0 / 64.0;

/// Steps that are shorter than this part of the path are none.
const SHORTEST: f64 = 1e-12;

/// An end is reached when so little of the way to it is left: another block may end shortly before.
const AT_AN_END: f64 = 1e-7;

/// Where following has led.
#[derive(Debug)]
pub(super) enum Way {
    /// To the end of the path.
    Through(PathPose),
    /// To an end of travel.
    End(Event),
    /// To where two branches cross.
    Crossing(Event),
    /// Nowhere that could be told.
    Lost,
}

/// A place where something is remarkable.
#[derive(Clone, Debug)]
pub(super) struct Event {
    /// The member to which it belongs.
    pub(super) member: usize,
    pub(super) at: f64,
    /// q, of what the member depends on and of itself.
    pub(super) q: Vec<f64>,
}

impl Chain<'_> {
    /// The start as a pose, with all members solved exactly.
    pub(super) fn begin(&mut self, q: &[f64]) -> Option<PathPose> {
        let mut pose = PathPose { at: 0.0, q: q.to_vec(), rates: vec![0.0; q.len()], sides: Vec::new() };
        for index in 0..self.members.len() {
            let local = self.local(index, 0.0, &pose.q, &pose.rates).ok()?;
            self.members[index].level(&local.jacobian);
            let settled = self.solve(index, 0.0, &mut pose.q, &mut pose.rates, 0.0).ok()?;
            // It has been found to close: it does not go anywhere else.
            if settled.correction > LITTLE {
                return None;
            }
            pose.sides.push((settled.sign, settled.size));
        }
        Some(pose)
    }

    /// Follows the path to its end; `stops`: given, places that no step passes over, increasing.
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
                    // A third power of the step.
                    let growth = (0.3 / off.max(1e-9)).cbrt().clamp(0.3, 2.0);
                    step = (taken * growth).max(step.min(taken)).min(longest).min(self.reach(&there));
                    before = Some(std::mem::replace(&mut here, there));
                }
                Err(Stop::Spent) => return Way::Lost,
                Err(Stop::Member(member)) => {
                    step = taken / 2.0;
                    if step < SHORTEST * until {
                        // Where another block is stuck before the end, nothing has been seen of the rest of the way.
                        return end.filter(|end| end.member == member).map_or(Way::Lost, Way::End);
                    }
                    let is_known = end.as_ref().is_some_and(|end| end.member == member);
                    if step < short[member] && !is_known {
                        short[member] = step / 16.0;
                        match self.look(member, &here, 8.0 * taken) {
                            Seen::End(found) if end.as_ref().is_none_or(|end| found.at < end.at) => end = Some(found),
                            Seen::Crossing(found) if end.as_ref().is_none_or(|end| found.at < end.at) => return Way::Crossing(found),
                            _ => {}
                        }
                    }
                }
            }
        }
    }

    /// How far the path may be followed until something has moved far.
    fn reach(&self, pose: &PathPose) -> f64 {
        let fastest = |most: f64, member: &super::chain::Member| {
            if member.is_iterated { most.max(member.most(|unknown| pose.rates[unknown])) } else { most }
        };
        LONGEST / self.members.iter().fold(0.0, fastest)
    }

    /// One step; with it, by what part of what is allowed old and new rates differ at most.
    fn step(&mut self, here: &PathPose, before: Option<&PathPose>, next: f64) -> Result<(PathPose, f64), Stop> {
        let h = next - here.at;
        // Second rates by the last step; after a kink they would be wrong, and are not used where the step is much longer.
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
