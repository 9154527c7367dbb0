//! Diagnosis of the assembly at the declared defaults, at t = 0.
//!
//! In: the assembly, or the partial assembly if it does not close. Out: at most one fact, about the first block that
//!
//! 1. does not close: the last declared joint of the block without which all others close, with its smallest gap;
//! 2. closes, but is singular at this configuration and not everywhere;
//! 3. has two assemblies equally near to the declared start.
//!
//! A block is diagnosed only if everything upstream of it can be evaluated: rows that use a Rust function are not. Not done here: dependent
//! rows.

use super::links::{self, BodyPoint, Link};
use super::loops::{Loop, Loops};
use super::nearest::Reach;
use super::order::{Assembled, Upstream};
use super::shortest;
use crate::diag::{AssemblyFact, Bound, Range};
use crate::expr::{Expr, Values, evaluate};
use crate::numeric::Numeric;
use crate::numeric::gap::Opened;
use crate::numeric::samples::LOOKS;
use crate::quantity::{Ambient, Axis, Role};
use crate::structure::Structure;
use std::collections::BTreeSet;

/// Two links are in line if the sine of the angle between them is below this.
const IN_LINE: f64 = 1e-5;

/// A declared value closer than this to the assembly distinguishes it from any other regular one, in rad and characteristic lengths.
const TOLD: f64 = 1e-3;

/// Largest number of equally near assemblies of a block that are followed through later blocks.
const MOST_FOLLOWED: usize = 8;

/// The first fact, and the tokens that it refers to.
pub(super) fn judge(numeric: &Numeric, structure: &Structure, assembled: &mut Assembled) -> Option<(Range, AssemblyFact)> {
    let upstream = Upstream::new(numeric, structure);
    let is_sure = upstream.surety(numeric, structure);
    let loops = Loops { numeric, structure, upstream: &upstream };
    let judge = Judge { numeric, structure, upstream: &upstream, loops };
    while let Some(open) = assembled.open {
        match judge.open(open, &mut assembled.start) {
            Some(refusal) => return Some(refusal),
            // The block closes after all: continue with later blocks.
            None => *assembled = numeric.forward(structure, std::mem::take(&mut assembled.start), open + 1, &is_sure),
        }
    }
    if assembled.is_closed && !assembled.is_settled {
        // Next to a singular configuration of a block, rounding errors upstream of it decide.
        numeric.settle(structure, &mut assembled.start);
    }
    judge.prefer_regular(&is_sure, assembled);
    if let Some(refusal) = judge.without_rate(&is_sure, &assembled.start) {
        return Some(refusal);
    }
    if assembled.is_nearest {
        return judge.iterated(&is_sure).find_map(|block| judge.singular(block, &assembled.start)).or_else(|| judge.rival(assembled));
    }
    let mut followed = 0;
    judge
        .iterated(&is_sure)
        .find_map(|block| judge.singular(block, &assembled.start).or_else(|| judge.ambiguous(block, assembled, &mut followed)))
}

/// The two bodies of a block whose joints lie on one straight line at a configuration.
pub(crate) fn bodies_in_line(numeric: &Numeric, structure: &Structure, block: usize, q: &[f64]) -> Option<BTreeSet<usize>> {
    let upstream = Upstream::new(numeric, structure);
    let judge = Judge { numeric, structure, upstream: &upstream, loops: Loops { numeric, structure, upstream: &upstream } };
    judge.in_line(block, &judge.loops.bodies(&structure.blocks[block]), q)
}

struct Judge<'a> {
    numeric: &'a Numeric<'a>,
    structure: &'a Structure,
    upstream: &'a Upstream,
    loops: Loops<'a>,
}

impl Judge<'_> {
    /// Iterated blocks that can be evaluated.
    fn iterated(&self, is_sure: &[bool]) -> impl Iterator<Item = usize> {
        (0..is_sure.len()).filter(|block| is_sure[*block] && !self.structure.blocks[*block].iterated.is_empty())
    }

    /// If declared values do not decide, a regular assembly replaces a singular one.
    fn prefer_regular(&self, is_sure: &[bool], assembled: &mut Assembled) {
        let is_regular =
            |start: &[f64]| !self.iterated(is_sure).any(|block| self.numeric.is_singular_here(&self.structure.blocks[block], start));
        if is_regular(&assembled.start) {
            return;
        }
        if assembled.is_nearest
            && let Some(all) = self.numeric.nearest_of_all(self.structure, Reach::All)
        {
            *assembled = all;
        }
        let is_meant = |other: &&Vec<f64>| self.numeric.is_as_declared(&assembled.start, other) && is_regular(other);
        let meant: Vec<Vec<f64>> = assembled.others.iter().filter(is_meant).cloned().collect();
        if let [regular, others @ ..] = meant.as_slice() {
            assembled.start.clone_from(regular);
            assembled.others = others.to_vec();
        }
    }

    /// Refuses the start if another assembly is equally near; all assemblies are known.
    fn rival(&self, assembled: &Assembled) -> Option<(Range, AssemblyFact)> {
        let (numeric, start) = (self.numeric, &assembled.start);
        let is_rival = |other: &&Vec<f64>| !numeric.differing(start, other).is_empty() && numeric.are_equally_near(start, other);
        let other = assembled.others.iter().find(is_rival)?;
        Some(self.two_ways(&numeric.differing(start, other), start, other))
    }

    /// Refuses a block that does not close. If it closes after all, `None` with the assembly in `start`.
    fn open(&self, index: usize, start: &mut [f64]) -> Option<(Range, AssemblyFact)> {
        let numeric = self.numeric;
        self.loops.complete(index, start);
        let Loop { unknowns, equations, .. } = self.loops.around(index);
        let joints: BTreeSet<usize> = equations.iter().map(|equation| numeric.system.equations[*equation].joint).collect();
        if let Some(refusal) = self.without_value(&equations, self.drives(index), start) {
            return Some(refusal);
        }
        // The last joint closes the loop; a drive is opened only if no joint can be.
        let (drives, others): (Vec<usize>, Vec<usize>) = joints.iter().rev().partition(|joint| numeric.model.joints[**joint].is_drive);
        for joint in others.into_iter().chain(drives) {
            match numeric.least_gap(&unknowns, &equations, start, joint) {
                Opened::Others => {}
                Opened::Closed(values) => {
                    unknowns.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
                    return None;
                }
                Opened::Open { gap, .. } => {
                    let fact = AssemblyFact::StaysOpen {
                        joint: self.joint(joint),
                        gap: Box::new(gap),
                        others: joints
                            .iter()
                            .filter(|other| **other != joint && !numeric.model.joints[**other].is_drive)
                            .map(|other| self.joint(*other))
                            .collect(),
                        drives: self.drives(index),
                        starts: self.starts(index),
                        bound: self.bound(index, start).map(Box::new),
                    };
                    return Some(((&numeric.model.joints[joint].name).into(), fact));
                }
            }
        }
        let last = *joints.last()?;
        let fact = AssemblyFact::NeverCloses {
            joints: joints.iter().map(|joint| self.joint(*joint)).collect(),
            drives: self.drives(index),
            starts: self.starts(index),
            bound: self.bound(index, start).map(Box::new),
        };
        Some(((&numeric.model.joints[last].name).into(), fact))
    }

    /// Refuses a row that is not finite at the result of the search.
    fn without_value(&self, equations: &[usize], drives: Vec<String>, start: &[f64]) -> Option<(Range, AssemblyFact)> {
        let all = &self.numeric.system.equations;
        let has_value_at = |equation: usize, coordinates: &[f64]| {
            let roots: Vec<Expr> = all[equation].phi().into_iter().collect();
            let values = Values { coordinates, ..self.numeric.known };
            evaluate(&self.numeric.system.arena, &roots, &values).iter().all(|value| value.is_finite())
        };
        let number = *equations.iter().find(|equation| !has_value_at(**equation, start))?;
        let equation = &all[number];
        let joint = &self.numeric.model.joints[equation.joint];
        // A drive's function of time without a value has none at any configuration.
        let has_none_anywhere = joint.is_drive && (0..LOOKS).all(|look| !has_value_at(number, &self.numeric.anywhere(look)));
        let (row, of) = (equation.row + 1, joint.residuals.len());
        let (name, kind) = (joint.name.to_string(), joint.kind.clone());
        let fact = AssemblyFact::HasNoValue { joint: name, row, of, drives, has_none_anywhere, kind };
        Some(((&joint.name).into(), fact))
    }

    /// Refuses a row with a value at the start but no velocity or acceleration there, such as a square root starting from zero.
    fn without_rate(&self, is_sure: &[bool], start: &[f64]) -> Option<(Range, AssemblyFact)> {
        let all = &self.numeric.system.equations;
        let rest = vec![0.0; start.len()];
        let values = Values { coordinates: start, speeds: &rest, accelerations: &rest, ..self.numeric.known };
        let sure = self.structure.blocks.iter().zip(is_sure).filter(|(_, is_sure)| **is_sure);
        let equations: Vec<usize> = sure.flat_map(|(block, _)| block.parts().1).collect();
        let roots: Vec<Expr> = equations.iter().flat_map(|equation| [all[*equation].nu, all[*equation].gamma]).collect();
        let found = evaluate(&self.numeric.system.arena, &roots, &values);
        let place = found.iter().position(|value| !value.is_finite())?;
        let equation = &all[equations[place / 2]];
        let joint = &self.numeric.model.joints[equation.joint];
        let fact = AssemblyFact::HasNoRate { joint: joint.name.to_string(), row: equation.row + 1, of: joint.residuals.len() };
        Some(((&joint.name).into(), fact))
    }

    /// A link that is too long for the others, at any position of the drives or at the start.
    fn bound(&self, index: usize, start: &[f64]) -> Option<Bound> {
        let numeric = self.numeric;
        let blocks = self.upstream.all(index).into_iter().chain([index]);
        let equations: Vec<usize> = blocks.flat_map(|block| self.structure.blocks[block].parts().1).collect();
        let always: Vec<usize> = equations.into_iter().filter(|equation| !self.is_of_drive(*equation)).collect();
        let links = links::read(numeric, &always, start);
        shortest::longest(numeric, &links, &|_| true, true).or_else(|| {
            let Loop { equations, moving, .. } = self.loops.around(index);
            let links = links::read(numeric, &equations, start);
            shortest::longest(numeric, &links, &|body| moving.contains(&body), false)
        })
    }

    /// Refuses a block at a dead point or a change point.
    fn singular(&self, index: usize, start: &[f64]) -> Option<(Range, AssemblyFact)> {
        let (numeric, block) = (self.numeric, &self.structure.blocks[index]);
        if !numeric.is_singular_here(block, start) {
            return None;
        }
        let bodies = self.loops.bodies(block);
        let iterated: BTreeSet<usize> = block.iterated.iter().map(|unknown| numeric.system.coordinates[*unknown].body).collect();
        let in_line = self.in_line(index, &bodies, start);
        let named = in_line.as_ref().unwrap_or(&iterated);
        let names = named.iter().map(|body| numeric.model.bodies[*body].name.to_string()).collect();
        let fact = AssemblyFact::SingularStart {
            neglected: numeric.model.neglected(0..numeric.model.joints.len()),
            bodies: names,
            in_line: in_line.is_some(),
            drives: self.drives(index),
            has_others: self.has_regular_others(index, start),
        };
        // Blame the drive that moves the block to this configuration.
        let drive = self.upstream_drives(index).into_iter().next().map(|joint| Range::from(&numeric.model.joints[joint].name));
        let body = iterated.last().map(|body| Range::from(&numeric.model.bodies[*body].name));
        Some((drive.or(body)?, fact))
    }

    /// True if a block has other assemblies that are regular.
    fn has_regular_others(&self, index: usize, start: &[f64]) -> bool {
        let block = &self.structure.blocks[index];
        self.numeric.other_assemblies(self.structure, index, start).into_iter().any(|values| {
            let mut other = start.to_vec();
            block.parts().0.iter().zip(values).for_each(|(unknown, value)| other[*unknown] = value);
            !self.numeric.is_singular_here(block, &other)
        })
    }

    /// The two bodies of a loop whose joints lie on one straight line.
    fn in_line(&self, index: usize, bodies: &BTreeSet<usize>, start: &[f64]) -> Option<BTreeSet<usize>> {
        let links = links::read(self.numeric, &self.loops.around(index).equations, start);
        let mut places: Vec<BodyPoint> = Vec::new();
        for link in &links {
            match link {
                Link::Pin(one, other) | Link::Rod(one, other, _) => places.extend([*one, *other]),
                Link::Line(place, ..) => places.push(*place),
            }
        }
        let direction = |body: &usize| {
            let of_body: Vec<&BodyPoint> = places.iter().filter(|place| place.body == Some(*body)).collect();
            let [one, other] = of_body.as_slice() else { return None };
            let along = [other.at[0] - one.at[0], other.at[1] - one.at[1]];
            let length = along[0].hypot(along[1]);
            (length > 0.0).then(|| [along[0] / length, along[1] / length])
        };
        let directions: Option<Vec<[f64; 2]>> = bodies.iter().map(direction).collect();
        let directions = directions.filter(|directions| directions.len() == 2)?;
        let sine = directions[0][0] * directions[1][1] - directions[0][1] * directions[1][0];
        (sine.abs() < IN_LINE).then(|| bodies.clone())
    }

    /// Refuses a block with two assemblies equally near to the start.
    fn ambiguous(&self, index: usize, assembled: &Assembled, followed: &mut usize) -> Option<(Range, AssemblyFact)> {
        let (numeric, block, start) = (self.numeric, &self.structure.blocks[index], &assembled.start);
        let (unknowns, _) = block.parts();
        if unknowns.iter().all(|unknown| numeric.declared[*unknown].is_none_or(|declared| self.is_told(*unknown, declared, start)))
            && block.iterated.iter().all(|unknown| numeric.declared[*unknown].is_some())
        {
            return None;
        }
        let values: Vec<f64> = unknowns.iter().map(|unknown| start[*unknown]).collect();
        let mut problem = numeric.block_problem(block, start);
        let image = numeric.mirrored(&mut problem, &values);
        let found = match assembled.found.get(index) {
            Some(found) if !found.is_empty() => found.clone(),
            _ => numeric.search(&mut problem, super::search::GUESSES).assemblies,
        };
        for values in image.into_iter().chain(found) {
            let mut other = start.clone();
            unknowns.iter().zip(values).for_each(|(unknown, value)| other[*unknown] = value);
            let differing = numeric.differing(start, &other);
            if differing.is_empty() || !numeric.are_equally_near(start, &other) || *followed >= MOST_FOLLOWED {
                continue;
            }
            *followed += 1;
            if self.follow(index, &mut other) && numeric.are_equally_near(start, &other) && numeric.is_as_checked(self.structure, &other) {
                return Some(self.two_ways(&differing, start, &other));
            }
        }
        None
    }

    fn is_told(&self, unknown: usize, declared: f64, start: &[f64]) -> bool {
        (start[unknown] - declared).abs() < TOLD * self.numeric.scale(unknown)
    }

    /// Closes all blocks that depend on a block, each with its nearest assembly; false if one does not close.
    fn follow(&self, index: usize, start: &mut [f64]) -> bool {
        for (later, block) in self.structure.blocks.iter().enumerate().skip(index + 1) {
            if !self.upstream.all(later).contains(&index) {
                continue;
            }
            let (values, closes) = self.numeric.nearest(block, start);
            if !closes {
                return false;
            }
            block.parts().0.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
        }
        true
    }

    /// Reports two assemblies by a coordinate in which they differ: preferably an angle, of the body declared last.
    fn two_ways(&self, differing: &[usize], one: &[f64], other: &[f64]) -> (Range, AssemblyFact) {
        let numeric = self.numeric;
        let half_a_turn = |angle: f64| angle - (angle / core::f64::consts::TAU).round() * core::f64::consts::TAU;
        let apart = |unknown: usize| {
            let by = one[unknown] - other[unknown];
            if numeric.is_angle(unknown) { half_a_turn(by).abs() } else { by.abs() / numeric.scale(unknown) }
        };
        let angles: Vec<usize> = differing.iter().copied().filter(|unknown| numeric.is_angle(*unknown)).collect();
        let candidates = if angles.is_empty() { differing.to_vec() } else { angles };
        let most = candidates.iter().map(|unknown| apart(*unknown)).fold(0.0, f64::max);
        // The last coordinate with a large difference: usually of the body that closes the loop.
        let unknown = candidates.iter().copied().rfind(|unknown| apart(*unknown) >= most / 2.0).unwrap_or(differing[0]);
        let shown = |q: &[f64]| if numeric.is_angle(unknown) { half_a_turn(q[unknown]) } else { q[unknown] };
        let body = numeric.system.coordinates[unknown].body;
        let name = &numeric.model.bodies[body].name;
        let along = |axis: Axis, q: &[f64]| {
            let found = numeric.system.coordinates.iter().position(|unknown| unknown.body == body && unknown.role == Role::Position(axis));
            found.map_or(0.0, |unknown| q[unknown])
        };
        let axes: &[Axis] = if numeric.model.ambient == Ambient::Space { &[Axis::X, Axis::Y, Axis::Z] } else { &[Axis::X, Axis::Y] };
        // The greater value is suggested.
        let (one, other) = if shown(one) < shown(other) { (other, one) } else { (one, other) };
        let fact = AssemblyFact::AmbiguousStart {
            body: name.to_string(),
            owner: numeric.system.owner_and_name(numeric.model, unknown).0.to_string(),
            coordinate: numeric.system.coordinates[unknown].role,
            values: [shown(one), shown(other)],
            place: axes.iter().map(|axis| along(*axis, one)).collect(),
            turn: numeric.as_turn(one, body).filter(|_| numeric.is_angle(unknown)),
            is_declared: differing.iter().any(|unknown| numeric.declared[*unknown].is_some()),
        };
        (name.into(), fact)
    }

    fn joint(&self, joint: usize) -> String {
        self.numeric.model.joints[joint].name.to_string()
    }

    fn is_of_drive(&self, equation: usize) -> bool {
        self.numeric.model.joints[self.numeric.system.equations[equation].joint].is_drive
    }

    /// True if an equation holds a coordinate at its start, because only velocities determine it.
    fn is_pin(&self, equation: usize) -> bool {
        let equation = &self.numeric.system.equations[equation];
        equation.row >= self.numeric.model.joints[equation.joint].residuals.len()
    }

    /// Equations on which a block depends, its own included.
    fn upstream_equations(&self, index: usize) -> impl Iterator<Item = usize> {
        let blocks = self.upstream.all(index).into_iter().chain([index]);
        blocks.flat_map(|block| self.structure.blocks[block].parts().1)
    }

    /// Drives, and freedoms of positions, on which a block depends, its own included.
    fn upstream_drives(&self, index: usize) -> BTreeSet<usize> {
        let of_drives = self.upstream_equations(index).filter(|equation| self.is_of_drive(*equation) && !self.is_pin(*equation));
        of_drives.map(|equation| self.numeric.system.equations[equation].joint).collect()
    }

    fn drives(&self, index: usize) -> Vec<String> {
        self.upstream_drives(index).into_iter().map(|joint| self.joint(joint)).collect()
    }

    /// Bodies that are held at their start, because only velocities determine them, and on which a block depends.
    fn starts(&self, index: usize) -> Vec<String> {
        let pins = self.upstream_equations(index).filter(|equation| self.is_pin(*equation));
        let unknowns = pins.flat_map(|equation| self.numeric.system.equations[equation].jacobian.iter().map(|(unknown, _)| *unknown));
        let bodies: BTreeSet<usize> = unknowns.map(|unknown| self.numeric.system.coordinates[unknown].body).collect();
        bodies.into_iter().map(|body| self.numeric.model.bodies[body].name.to_string()).collect()
    }
}
