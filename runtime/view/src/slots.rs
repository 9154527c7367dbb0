//! One paint order for all frames of a motion: a sequence that contains the order of each frame as a part.

use crate::template::Template;

/// A place in the common paint order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Slot {
    /// Index of the element.
    pub(crate) element: usize,
    /// For each frame, whether it paints the element in this place.
    pub(crate) is_shown: Vec<bool>,
}

/// The places of all frames, from bottom to top. An element that passes in front of others has several.
pub(crate) fn slots(template: &Template) -> Vec<Slot> {
    let mut slots: Vec<Slot> = Vec::new();
    for (number, order) in template.orders.iter().enumerate() {
        let is_shown: Vec<bool> = template.order.iter().map(|own| *own == number).collect();
        slots = with(slots, order, &is_shown);
    }
    slots
}

/// Adds an order: its elements take the places of a longest common subsequence, and new places between them.
fn with(slots: Vec<Slot>, order: &[usize], is_shown: &[bool]) -> Vec<Slot> {
    // Lengths of common subsequences of the rests from a slot and from an element on.
    let mut lengths = vec![vec![0_usize; order.len() + 1]; slots.len() + 1];
    for (slot, own) in slots.iter().enumerate().rev() {
        for (rank, element) in order.iter().enumerate().rev() {
            let best = lengths[slot + 1][rank].max(lengths[slot][rank + 1]);
            lengths[slot][rank] = if own.element == *element { lengths[slot + 1][rank + 1] + 1 } else { best };
        }
    }
    let new = |element: &usize| Slot { element: *element, is_shown: is_shown.to_vec() };
    let (mut merged, mut rank) = (Vec::new(), 0);
    for (number, mut slot) in slots.into_iter().enumerate() {
        while rank < order.len() && order[rank] != slot.element && lengths[number][rank] == lengths[number][rank + 1] {
            merged.push(new(&order[rank]));
            rank += 1;
        }
        if order.get(rank) == Some(&slot.element) {
            slot.is_shown.iter_mut().zip(is_shown).for_each(|(all, own)| *all |= own);
            rank += 1;
        }
        merged.push(slot);
    }
    merged.extend(order[rank..].iter().map(new));
    merged
}
