//! Blocks that may have more equations than unknowns.
//!
//! In: a [`Pattern`] and a [`Matching`]. Out: [`Subsystem`]s in order. Numbers alone tell equations that follow from others from
//! equations that contradict them; that is not done here.

use super::components;
use super::matching::Matching;
use super::pattern::Pattern;

/// Unknowns that are found together, and all equations in them and in nothing that comes later.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Subsystem {
    pub(crate) unknowns: Vec<usize>,
    pub(crate) equations: Vec<usize>,
    /// Some of its equations may follow from others.
    pub(crate) is_overdetermined: bool,
}

/// Up to this many unknowns a system is treated as a whole where that tells more.
pub(crate) const SMALL: usize = 60;

/// Blocks in order, each with the unmatched equations that belong to it. Those with a marked equation count as overdetermined.
pub(crate) fn subsystems(pattern: &Pattern, matching: &Matching, is_marked: impl Fn(&usize) -> bool) -> Vec<Subsystem> {
    let groups = components::in_order(pattern, matching);
    let mut piece_of = vec![0; pattern.unknowns];
    let mut pieces: Vec<Subsystem> = Vec::new();
    for equations in groups {
        let unknowns: Vec<usize> = equations.iter().filter_map(|equation| matching.of_equation[*equation]).collect();
        unknowns.iter().for_each(|unknown| piece_of[*unknown] = pieces.len());
        let is_overdetermined = equations.iter().any(&is_marked);
        pieces.push(Subsystem { unknowns, equations, is_overdetermined });
    }
    for equation in matching.free_equations() {
        let last = pattern.rows[equation].iter().map(|entry| piece_of[entry.unknown]).max();
        if let Some(piece) = last.and_then(|last| pieces.get_mut(last)) {
            piece.equations.push(equation);
            piece.is_overdetermined = true;
        }
    }
    let wider: Vec<(usize, Subsystem)> = (0..pieces.len())
        .filter(|index| pieces[*index].is_overdetermined)
        .map(|index| (index, with_upstream(pattern, &pieces, &piece_of, index)))
        .collect();
    for (index, piece) in wider {
        pieces[index] = piece;
    }
    pieces
}

/// A piece together with what is next upstream of it: equations that are too many follow from equations there.
fn with_upstream(pattern: &Pattern, pieces: &[Subsystem], piece_of: &[usize], index: usize) -> Subsystem {
    let mut found = vec![index];
    let mut wide = pieces[index].clone();
    let mut next = 0;
    while let Some(piece) = found.get(next).map(|index| &pieces[*index]) {
        for entry in piece.equations.iter().flat_map(|equation| &pattern.rows[*equation]) {
            let upstream = piece_of[entry.unknown];
            if !found.contains(&upstream) && wide.unknowns.len() + pieces[upstream].unknowns.len() <= SMALL {
                found.push(upstream);
                wide.unknowns.extend(&pieces[upstream].unknowns);
                wide.equations.extend(&pieces[upstream].equations);
            }
        }
        next += 1;
    }
    wide
}
