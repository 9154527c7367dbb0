//! Guesses at the intent of a declaration, from the tree alone, without resolving names.
//!
//! In: expressions and items as written. Out: whether they are meant in space, lengths that were probably not meant in metres, angles not in
//! radians and angular velocities not in radians per second, rods whose centre was forgotten, disks that lie across their axis, forms that are often written in place of others, what outputs probably are, which names
//! generated functions have, and names that nothing uses. Not done here: reporting, which `resolve` does, as it knows the meaning of names.

mod ambient;
mod angles;
mod arguments;
mod bare;
mod conversions;
mod doubts;
mod forms;
mod generated;
mod outputs;
mod promised;
mod shapes;
mod unused;

pub(crate) use ambient::{is_meant, means_space};
pub(crate) use angles::bare_angles;
pub(crate) use bare::BareNumbers;
pub(crate) use doubts::doubtful_expressions;
pub(crate) use forms::{
    argument_of, by_law, by_time, by_turns, cross_product, decimal_comma, gain, in_millimetres, in_words, is_bare, is_measured, is_zero,
    noted, orientation_of, place_in, place_of_argument, unit_in_parts, with_bare_bounds, with_rate, with_time_too_much, without_time,
};
pub(crate) use generated::{is_generated, is_of_generated_type};
pub(crate) use outputs::{OutputKind, derivatives, output_kind};
pub(crate) use promised::{has_forces, has_inputs};
pub(crate) use shapes::doubtful_shapes;
pub(crate) use unused::{Unused, unused, unused_arguments};
