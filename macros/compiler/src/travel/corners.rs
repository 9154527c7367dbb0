//! The motion with parameters at the ends of their bounds.
//!
//! In: a motion that goes on at the declared defaults. Out: notes on corners of the bounds at which it does not. The assembly at a corner
//! is the one that the declared one becomes when all parameters change together, as at run time.

use super::Travel;
use super::chain::{Chain, MotionPath};
use super::walk::Way;
use crate::expr::Leaf;
use crate::expr::Values;
use crate::numeric::Numeric;
use crate::structure::Structure;
use std::collections::BTreeSet;

/// Of so many parameters all combinations are looked at, of more each one by itself.
const ALL_TOGETHER: usize = 3;

/// How many corners are looked at.
const MOST: usize = 16;

/// How many of them are told.
const TOLD: usize = 4;

/// An end that is excluded is approached to this part of the range.
const EXCLUDED: f64 = 1e-6;

/// Parameters that differ from their defaults.
type Corner = Vec<(usize, f64)>;

/// Looks at the corners as long as operations are left.
pub(super) fn visit(travel: &mut Travel, numeric: &Numeric, structure: &Structure, start: &[f64], most: u64) {
    let mut told = 0;
    for corner in corners(numeric) {
        if travel.spent >= most || told == TOLD {
            return;
        }
        if let Some(note) = at(travel, numeric, structure, start, (&corner, most)) {
            travel.notes.push(format!("with {}, {note}", words(numeric, &corner)));
            told += 1;
        }
    }
}

/// What happens at a corner, if the motion does not go on there.
fn at(travel: &mut Travel, numeric: &Numeric, structure: &Structure, start: &[f64], (corner, most): (&Corner, u64)) -> Option<String> {
    let mut to = numeric.known.parameters.to_vec();
    corner.iter().for_each(|(parameter, value)| to[*parameter] = *value);
    let path = MotionPath { sign: 0.0, from: numeric.known.parameters.to_vec(), to: Some(to.clone()) };
    let mut chain = Chain::new(numeric, structure, start, path, most - travel.spent)?;
    let begin = chain.begin(start)?;
    let way = chain.follow(begin, 1.0, &[]);
    travel.spent = most - chain.left;
    let q = match way {
        Way::Through(there) => there.q,
        Way::End(place) => {
            return Some(format!("the start is not reached from the defaults: the way ends at {:.0} % of it", place.at * 100.0));
        }
        Way::Crossing(_) | Way::Lost => return None,
    };
    let (known, declared) = (Values { parameters: &to, ..numeric.known }, numeric.declared.clone());
    let numeric = numeric.with(known, declared);
    let mut there = Travel { spent: travel.spent, ..Travel::default() };
    there.both_ways(&numeric, structure, &q, most);
    travel.spent = there.spent;
    let (_, fact) = there.end?;
    fact.to_string().lines().next().map(str::to_owned)
}

/// Combinations of ends of bounds.
fn corners(numeric: &Numeric) -> Vec<Corner> {
    let roots: Vec<_> = numeric.system.equations.iter().filter_map(|equation| equation.phi()).collect();
    let nodes = numeric.system.arena.reachable(&roots);
    let leaves = nodes.into_iter().filter_map(|expr| match numeric.system.arena.node(expr) {
        crate::expr::Node::Leaf(Leaf::Parameter(number)) => Some(*number as usize),
        _ => None,
    });
    let ends: Vec<(usize, [f64; 2])> = leaves
        .collect::<BTreeSet<usize>>()
        .into_iter()
        .filter_map(|number| {
            let bounds = numeric.model.parameters.get(number)?.bounds.as_ref()?;
            let (from, to) = (bounds.from?, bounds.to?);
            Some((number, [from, if bounds.is_inclusive { to } else { to - EXCLUDED * (to - from) }]))
        })
        .collect();
    if ends.is_empty() || ends.len() > ALL_TOGETHER {
        let alone = |(number, ends): &(usize, [f64; 2])| ends.map(|end| vec![(*number, end)]);
        return ends.iter().flat_map(alone).take(MOST).collect();
    }
    let corner = |choice: usize| ends.iter().enumerate().map(|(place, (number, ends))| (*number, ends[choice >> place & 1])).collect();
    (0..1 << ends.len()).map(corner).collect()
}

/// `a` = 50 mm and `b` = 20 mm
fn words(numeric: &Numeric, corner: &Corner) -> String {
    let one = |(number, value): &(usize, f64)| {
        let parameter = &numeric.model.parameters[*number];
        format!("`{}` = {}", parameter.name, crate::diag::quantity(*value, parameter.dim))
    };
    let all: Vec<String> = corner.iter().map(one).collect();
    match all.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => all.concat(),
    }
}
