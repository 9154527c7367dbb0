//! Blocks that may have more equations than unknowns.
//!
//! In: a [`Pattern`] and a [`Matching`]. Out: [`Subsystem`]s in order. Not done here: distinguishing redundant equations from
//! contradictory ones, which depends on numbers.

use super::components;
use super::matching::Matching;
use super::pattern::Pattern;

/// Unknowns that are found together, and all equations that contain them and no later unknowns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Subsystem {
    pub(crate) unknowns: Vec<usize>,
    pub(crate) equations: Vec<usize>,
    /// True if some of its equations may be redundant.
    pub(crate) is_overdetermined: bool,
}

/// Largest number of unknowns up to which a system is treated as a whole if that gives better diagnostics.
pub(crate) const SMALL: usize = 60;

/// Blocks in order, each with the unmatched equations that belong to it. A block with a marked equation counts as overdetermined.
pub(crate) fn subsystems(pattern: &Pattern, matching: &Matching, is_marked: impl Fn(&usize) -> bool) -> Vec<Subsystem> {
    let groups = components::in_order(pattern, matching);
    let mut subsystem_of = vec![0; pattern.unknowns];
    let mut subsystems: Vec<Subsystem> = Vec::new();
    for equations in groups {
        let unknowns: Vec<usize> = equations.iter().filter_map(|equation| matching.of_equation[*equation]).collect();
        unknowns.iter().for_each(|unknown| subsystem_of[*unknown] = subsystems.len());
        let is_overdetermined = equations.iter().any(&is_marked);
        subsystems.push(Subsystem { unknowns, equations, is_overdetermined });
    }
    for equation in matching.free_equations() {
        let last = pattern.rows[equation].iter().map(|entry| subsystem_of[entry.unknown]).max();
        if let Some(subsystem) = last.and_then(|last| subsystems.get_mut(last)) {
            subsystem.equations.push(equation);
            subsystem.is_overdetermined = true;
        }
    }
    let wider: Vec<(usize, Subsystem)> = (0..subsystems.len())
        .filter(|index| subsystems[*index].is_overdetermined)
        .map(|index| (index, with_upstream(pattern, &subsystems, &subsystem_of, index)))
        .collect();
    for (index, subsystem) in wider {
        subsystems[index] = subsystem;
    }
    subsystems
}

/// Extends a subsystem upstream, nearest first, up to `SMALL` unknowns: its unmatched equations depend on equations there.
fn with_upstream(pattern: &Pattern, subsystems: &[Subsystem], subsystem_of: &[usize], index: usize) -> Subsystem {
    let mut found = vec![index];
    let mut wide = subsystems[index].clone();
    let mut next = 0;
    while let Some(subsystem) = found.get(next).map(|index| &subsystems[*index]) {
        for entry in subsystem.equations.iter().flat_map(|equation| &pattern.rows[*equation]) {
            let upstream = subsystem_of[entry.unknown];
            if !found.contains(&upstream) && wide.unknowns.len() + subsystems[upstream].unknowns.len() <= SMALL {
                found.push(upstream);
                wide.unknowns.extend(&subsystems[upstream].unknowns);
                wide.equations.extend(&subsystems[upstream].equations);
            }
        }
        next += 1;
    }
    wide
}
