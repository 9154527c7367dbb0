//! What is known of the items of a mechanism before and while they are resolved, and refusals of names.

use super::{Context, EntityId, Key, SpaceId, Value};
use crate::diag::{ArrayFact, Fact, Known, NameFact, Range};
use crate::expr::{Expr, Lookup, Triple};
use crate::geometry::{Geometry, Place, Relationship, Triad};
use crate::model::{JointStart, Name, Of};
use crate::quantity::{Ambient, Role};
use crate::syntax::ast;
use crate::words::is_synonym;
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};

/// The mechanism or a part while its items are registered.
#[derive(Default)]
pub(crate) struct OpenPart {
    pub(crate) component: Option<ast::Shared<ast::ComponentItem>>,
    /// Number of its first body.
    pub(crate) first: usize,
    /// Items that appear in the generated types, each with its number among items of its kind.
    pub(crate) items: Vec<(Of, EntityId, usize)>,
    /// Declaration of the part.
    pub(crate) id: Option<EntityId>,
}

/// Declared items, in the order of expansion.
#[derive(Default)]
pub(crate) struct Register {
    /// Parameters, and value, rate and acceleration of each input.
    pub(crate) parameters: Vec<(EntityId, ast::Shared<ast::ParameterItem>)>,
    /// Inputs, each with the number of its value among the parameters.
    pub(crate) inputs: Vec<(EntityId, usize)>,
    /// `let`s and arguments of parts, used or not, so that errors in all of them are found.
    pub(crate) lets: Vec<EntityId>,
    pub(crate) functions: Vec<ast::Shared<ast::FunctionItem>>,
    pub(crate) bodies: Vec<(EntityId, ast::Shared<ast::FrameItem>)>,
    pub(crate) marks: Vec<EntityId>,
    /// Freedoms come last: their equations hold at the start only.
    pub(crate) joints: Vec<(EntityId, ast::Shared<ast::JointItem>)>,
    pub(crate) forces: Vec<(EntityId, ast::Shared<ast::JointItem>)>,
    pub(crate) gravity: Option<ast::Shared<ast::Gravity>>,
    pub(crate) starts: Vec<(ast::Shared<ast::StartItem>, Context)>,
    pub(crate) outputs: Vec<(EntityId, ast::Shared<ast::OutputItem>)>,
    pub(crate) output_names: BTreeMap<(SpaceId, String), BTreeSet<Vec<usize>>>,
    /// The parts as written, without an entry for the mechanism.
    pub(crate) parts: Vec<ast::Shared<ast::PartItem>>,
    /// The mechanism and its parts.
    pub(crate) places: Vec<OpenPart>,
    /// Components being expanded, to detect recursion.
    pub(crate) open: Vec<String>,
    /// Number of enclosing loops.
    pub(crate) loops: usize,
    pub(crate) range: Option<ast::Shared<ast::TimeRange>>,
    pub(crate) has_ground: bool,
}

impl Register {
    /// Name of the first freedom.
    pub(crate) fn a_freedom(&self) -> Option<String> {
        self.joints.iter().find(|(_, joint)| joint.is_freedom()).map(|(_, freedom)| freedom.name.to_string())
    }
}

/// A declared name, as written.
#[derive(Clone, Copy)]
pub(crate) struct Written<'a> {
    /// Key of the declaration.
    pub(crate) key: Key,
    pub(crate) name: &'a Ident,
    pub(crate) indices: &'a [ast::Expression],
}

/// The error for a name that is taken, possibly by an item of the same sort in the loops around it. `indices`: as written.
pub(crate) fn duplicate(name: String, first: &'static str, loops: &[(String, Value)], indices: &[ast::Expression]) -> Fact {
    let words = |index: &ast::Expression| {
        index.to_string().split(|letter: char| !letter.is_alphanumeric() && letter != '_').map(str::to_owned).collect()
    };
    let written: Vec<String> = indices.iter().flat_map(|index| -> Vec<String> { words(index) }).collect();
    let is_written = |variable: &String| written.contains(variable);
    match (loops.last(), indices.last()) {
        (Some(_), Some(index)) if loops.iter().all(|(variable, _)| is_written(variable)) => {
            ArrayFact::DeclaredBefore { name, next: format!("[{index} + 1]") }.into()
        }
        (Some((variable, _)), _) => ArrayFact::DuplicateInLoop { name, variable: variable.clone() }.into(),
        (None, _) => NameFact::Duplicate { name, first }.into(),
    }
}

/// The coordinate that space has and the plane has not.
pub(crate) const HEIGHT: &str = "z";

/// What is wrong with an axis called `z` in the plane where a number is wanted.
pub(crate) fn misread_height(ambient: Ambient, written: &ast::Expression, value: &Value) -> Option<NameFact> {
    match (&written.kind, value) {
        (ast::ExpressionKind::Field(owner, name), Value::Axis(_)) if ambient == Ambient::Plane && name == HEIGHT => {
            Some(NameFact::NoHeight { owner: format!("`{owner}`"), is_axis: true })
        }
        _ => None,
    }
}

/// What is wrong with a field that the value does not have.
///
/// * `written`: given, the value.
pub(crate) fn unknown_field(value: &Value, name: String, written: &ast::Expression, ambient: Ambient) -> NameFact {
    if name == HEIGHT && ambient == Ambient::Plane && matches!(value, Value::Point(_) | Value::Axis(_) | Value::Vector(_)) {
        return NameFact::NoHeight { owner: value.kind().to_string(), is_axis: false };
    }
    let axes = ambient.positions().map(Role::name);
    let known: Vec<&str> = match value {
        Value::Point(_) | Value::Axis(_) => axes.chain(["body"]).collect(),
        Value::Vector(_) => axes.collect(),
        _ => Vec::new(),
    };
    let has_rate = matches!(value, Value::Point(_) | Value::Vector(_) | Value::Scalar(_)) && is_synonym("rate", &name);
    let near = has_rate.then(|| format!("rate({written})"));
    NameFact::UnknownField { owner: value.kind().to_string(), name, near, known: Known::of(known.into_iter()) }
}

/// Properties of expressions while a mechanism is resolved.
#[derive(Default)]
pub(crate) struct Notes {
    pub(crate) geometry: Geometry,
    /// Item that is resolved, and for each quantity the item that names it first.
    pub(crate) item: Option<Name>,
    pub(crate) quantity_items: Vec<Option<Name>>,
    /// Declared starts of angles and displacements of joints.
    pub(crate) starts: Vec<JointStart>,
    /// Relations that hold where these expressions vanish.
    pub(crate) origins: Lookup<Vec<Expr>, Relationship>,
    /// Points whose difference has these components: the second minus the first.
    pub(crate) differences: Lookup<[Expr; 3], (Place, Place)>,
    pub(crate) triads: Lookup<(Place, Option<Triple>), Triad>,
    /// By z axis, the triad that was last asked for.
    pub(crate) latest: Lookup<Place, Triad>,
}

impl Notes {
    /// Notes the meaning of rows of a joint, and the triads of axes that they make perpendicular: the joint has just named them.
    pub(crate) fn relate(&mut self, joint: usize, first: usize, relation: Relationship) {
        self.geometry.relations.push((joint, first, relation));
        if let Relationship::Perpendicular(one, two) = relation
            && let (Some(one), Some(two)) = (self.latest.get(&one), self.latest.get(&two))
        {
            self.geometry.arms.insert((joint, first), [*one, *two]);
        }
    }
}

/// A value that depends on parameters alone and must be finite.
pub(crate) struct FixedValue {
    pub(crate) expr: Expr,
    /// Expression in the tree, reported once for all its instances.
    pub(crate) item: Key,
    pub(crate) range: Range,
    /// Noun for messages.
    pub(crate) noun: &'static str,
    /// Description of the instance, if the declaration is expanded several times.
    pub(crate) place: Option<String>,
}

/// Fields of an input in the generated struct.
pub(crate) const INPUT_PARTS: [&str; 3] = ["value", "rate", "acceleration"];

/// True in a loop or in a component, where a declaration may be expanded several times.
pub(crate) fn is_one_of_many(context: &Context) -> bool {
    context.space != SpaceId::MECHANISM || !context.bound.is_empty()
}
