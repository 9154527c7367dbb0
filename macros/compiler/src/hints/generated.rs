//! Names of generated functions and constants of a mechanism, which none of its outputs may have.

use super::promised::{has_forces, has_inputs};
use crate::syntax::ast::{Item, Mechanism, Task, every_item};
use proc_macro2::Ident;

/// Of every mechanism.
const ALWAYS: &[&str] = &[
    "phi",
    "jacobian",
    "jacobian_entries",
    "nu",
    "gamma",
    "linearize",
    "solve",
    "solve_near",
    "solve_from",
    "advance",
    "sweep",
    "prepared",
    "start",
    "validate",
    "characteristic_length",
    "with_defaults",
    "with_inputs_of",
    "with_derivatives",
    "derivatives",
    "derivatives_along",
    "update_derivatives",
    "into",
    "clone",
    "default",
    "COORDINATES",
    "EQUATIONS",
    "SPEEDS",
    "JACOBIAN_ENTRIES",
    "JACOBIAN_PATTERN",
    "PLAN",
    "OUTPUTS",
];

/// Of a mechanism with masses or forces.
const WITH_FORCES: &[&str] = &["loads", "energy", "actions", "loads_in_general", "loads_in_closed_form"];

/// Of a mechanism whose motion follows from forces.
const OF_MOTION: &[&str] = &[
    "initial_state",
    "accelerate",
    "accelerate_with_loads",
    "advance_until",
    "advance_while",
    "step",
    "sweep_from",
    "energy",
    "accelerations_with_loads",
];

/// True if a generated function or constant of this mechanism has the name. Names that begin with two underscores or with `TABLE_` are left to
/// generated code.
pub(crate) fn is_generated(name: &Ident, tree: &Mechanism) -> bool {
    let word = name.to_string();
    let is_one_of = |names: &[&str]| names.contains(&word.as_str());
    let is_load = || word.strip_prefix("load_of_").is_some_and(|load| has_sliced_load(&tree.items, load));
    is_one_of(ALWAYS)
        || ["__", "TABLE_"].iter().any(|start| word.starts_with(start))
        || has_forces(tree) && (is_one_of(WITH_FORCES) || is_load())
        || tree.task == Task::Motion && is_one_of(OF_MOTION)
        || has_inputs(tree) && word == "advance_once"
        || tree.requests.points.is_some() && word == "points"
        || tree.requests.picture.is_some() && is_one_of(&["picture", "view", "view_outputs", "scene"])
}

/// True if the load of some item is computed alone and may be called `load`: by the names of its parts, its own, and indices.
fn has_sliced_load(items: &[Item], load: &str) -> bool {
    every_item(items).any(|item| match item {
        Item::Joint(joint) | Item::Force(joint) if joint.is_slice => {
            let own = joint.name.to_string().replace("r#", "");
            if joint.indices.is_empty() { load == own || load.ends_with(&format!("_{own}")) } else { load.contains(&format!("{own}_")) }
        }
        _ => false,
    })
}

/// True if the name of the mechanism followed by `word` may be a generated type: the state or a view of it, a failure, a slice for an
/// output, its loads, its points, a prepared or a moving mechanism.
pub(crate) fn is_of_generated_type(word: &str) -> bool {
    let is_of_slice = word.strip_prefix("For").is_some_and(|output| output.starts_with(|first: char| first.is_uppercase() || first == '_'));
    word.starts_with("State") || is_of_slice || ["Failure", "Loads", "Moving", "Points", "Prepared"].contains(&word)
}
