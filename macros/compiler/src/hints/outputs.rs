//! What an output probably is: a number, a vector or a body, and whether it contains velocities.

use crate::library;
use crate::quantity::Ambient;

use crate::syntax::ast::{Expression, ExpressionKind, FormalKind, Item, JointBody, Marks, Mechanism, Operator, OutputItem};
use proc_macro2::Ident;

/// How many `let`s a guess follows.
const LETS: usize = 20;

/// Kind of an output.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum OutputKind {
    Number,
    Vector,
    Body,
}

/// Guesses the kind of an output.
pub(crate) fn output_kind(output: &OutputItem, tree: &Mechanism) -> OutputKind {
    kind(&output.value, tree, LETS)
}

/// Guesses how many derivatives of an output are given: it may contain velocities.
pub(crate) fn derivatives(output: &OutputItem, tree: &Mechanism) -> usize {
    match output.jerk {
        Some(_) => 3,
        None if has_velocities(&output.value, tree, LETS) => 1,
        None => 2,
    }
}

fn kind(expr: &Expression, tree: &Mechanism, lets: usize) -> OutputKind {
    let vector_if = |is_vector: bool| if is_vector { OutputKind::Vector } else { OutputKind::Number };
    match &expr.kind {
        ExpressionKind::Tuple(_) => OutputKind::Vector,
        ExpressionKind::Index(owner, _) => kind(owner, tree, lets),
        ExpressionKind::Field(owner, name) if is_number(owner, name, tree) => OutputKind::Number,
        ExpressionKind::Field(_, name) if name == "angular_velocity" => vector_if(tree.ambient == Ambient::Space),
        ExpressionKind::Call(path, arguments) if path.name.as_ref().is_some_and(|name| name == "rate") => {
            arguments.first().map_or(OutputKind::Number, |argument| kind(argument, tree, lets))
        }
        ExpressionKind::Field(owner, name) => {
            if names(name, tree, lets) == Some(OutputKind::Body) && !is_frame(owner, tree) {
                OutputKind::Body
            } else {
                OutputKind::Vector
            }
        }
        ExpressionKind::Call(path, _) => vector_if(path.name.as_ref().is_some_and(|name| match name.to_string().as_str() {
            "perp" | "unit" | "across" | "misalignment" | "x_axis" | "y_axis" | "z_axis" => true,
            name => name == "cross" && tree.ambient == Ambient::Space,
        })),
        ExpressionKind::Negative(value) => kind(value, tree, lets),
        ExpressionKind::Binary(Operator::Power | Operator::Rem, ..) => OutputKind::Number,
        ExpressionKind::Binary(_, one, two) => vector_if([one, two].into_iter().any(|side| kind(side, tree, lets) == OutputKind::Vector)),
        ExpressionKind::Path(path) => path.name.as_ref().and_then(|name| names(name, tree, lets)).unwrap_or(OutputKind::Number),
        ExpressionKind::Number { .. } | ExpressionKind::List(_) | ExpressionKind::If { .. } => OutputKind::Number,
    }
}

fn has_velocities(expr: &Expression, tree: &Mechanism, lets: usize) -> bool {
    let has = |expr: &Expression| has_velocities(expr, tree, lets);
    match &expr.kind {
        ExpressionKind::Number { .. } => false,
        ExpressionKind::Path(path) => path.name.as_ref().is_some_and(|name| is_let_with_velocities(name, tree, lets)),
        ExpressionKind::Field(owner, name) => name == "angular_velocity" || has(owner),
        ExpressionKind::Index(owner, _) => has(owner),
        ExpressionKind::Call(path, arguments) => path.name.as_ref().is_some_and(|name| name == "rate") || arguments.iter().any(has),
        ExpressionKind::Negative(value) => has(value),
        ExpressionKind::Binary(_, one, two) => has(one) || has(two),
        ExpressionKind::Tuple(items) | ExpressionKind::List(items) => items.iter().any(has),
        ExpressionKind::If { lhs, rhs, then, otherwise, .. } => [lhs, rhs, then, otherwise].into_iter().any(|part| has(part)),
    }
}

/// The same of a `let`.
fn is_let_with_velocities(name: &Ident, tree: &Mechanism, lets: usize) -> bool {
    let is_meant = |item: &&Item| matches!(item, Item::Let(binding) if binding.name == *name);
    match tree.items.iter().find(is_meant) {
        Some(Item::Let(binding)) if lets > 0 => has_velocities(&binding.value, tree, lets - 1),
        _ => false,
    }
}

/// True for a coordinate or a component, and for a number of a joint: its angle, its displacement or an argument.
fn is_number(owner: &Expression, name: &Ident, tree: &Mechanism) -> bool {
    let word = name.to_string();
    if let ExpressionKind::Path(path) = &owner.kind
        && let Some(JointBody::Of { kind, .. }) = path.name.as_ref().and_then(|name| joint_body(name, tree))
        && let Some(definition) = library::find(&kind.to_string(), tree.ambient)
        && let Some(formal) = definition.parameters.iter().find(|formal| formal.name == *name)
    {
        return matches!(formal.kind, FormalKind::Scalar(_) | FormalKind::Quantity);
    }
    match word.as_str() {
        "angle" | "displacement" | "c" => true,
        // In space an axis may be called like a coordinate.
        "x" | "y" | "z" => tree.ambient == Ambient::Plane || !is_frame(owner, tree) || !is_mark(name, tree),
        _ => false,
    }
}

fn joint_body<'a>(name: &Ident, tree: &'a Mechanism) -> Option<&'a JointBody> {
    tree.items.iter().find_map(|item| if let Item::Joint(joint) = item { (joint.name == *name).then_some(&joint.body) } else { None })
}

/// True for the name of a point or an axis of any body.
fn is_mark(name: &Ident, tree: &Mechanism) -> bool {
    tree.items.iter().any(|item| matches!(item, Item::Body(frame) | Item::Ground(frame) if has_mark(&frame.marks, name)))
}

/// The expression is a body or ground, whose parts are points.
fn is_frame(expr: &Expression, tree: &Mechanism) -> bool {
    match &expr.kind {
        ExpressionKind::Index(owner, _) => is_frame(owner, tree),
        ExpressionKind::Path(path) => {
            path.name.as_ref().is_some_and(|name| name == "ground" || names(name, tree, 0) == Some(OutputKind::Body))
        }
        _ => false,
    }
}

/// A `let`, a body, or a point whose body was forgotten, wherever it is declared.
fn names(name: &Ident, tree: &Mechanism, lets: usize) -> Option<OutputKind> {
    let mut pending: Vec<&Item> = tree.items.iter().collect();
    let mut found = None;
    while let Some(item) = pending.pop() {
        match item {
            Item::Let(binding) if binding.name == *name && lets > 0 => return Some(kind(&binding.value, tree, lets - 1)),
            Item::Body(frame) if frame.name == *name => return Some(OutputKind::Body),
            Item::Body(frame) | Item::Ground(frame) if has_mark(&frame.marks, name) => found = Some(OutputKind::Vector),
            Item::Component(component) => pending.extend(&component.items),
            Item::For(repeated) => pending.extend(&repeated.items),
            _ => {}
        }
    }
    found
}

fn has_mark(marks: &Marks, name: &Ident) -> bool {
    marks.single.iter().any(|mark| mark.name == *name) || marks.loops.iter().any(|repeated| has_mark(&repeated.items, name))
}
