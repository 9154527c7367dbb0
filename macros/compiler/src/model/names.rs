//! All names of a mechanism, and how far what they stand for has been resolved.

use super::value::{Arguments, FrameId, Value};
use crate::expr::Expr;
use crate::syntax::ast::{self, Definition};
use proc_macro2::Ident;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Names that expressions give a meaning of their own.
pub(super) const RESERVED: &[&str] = &["t", "pi", "ground"];

/// Names of generated functions, which an output may not have.
const GENERATED: &[&str] = &[
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
    "start",
    "validate",
    "characteristic_length",
    "with_defaults",
    "clone",
    "default",
];

/// A generated function has this name.
pub(crate) fn is_generated(name: &Ident) -> bool {
    GENERATED.iter().any(|known| name == known)
}

/// How far an item has been resolved.
#[derive(Clone)]
pub(super) enum Progress<T> {
    Untouched,
    Open,
    Done(T),
    /// It was refused; whoever needs it stays silent.
    Failed,
}

/// What a name of the mechanism stands for.
#[derive(Clone)]
pub(super) enum Entity {
    Value(Option<Value>),
    Let(Rc<ast::Let>, Progress<Value>),
    Function(Rc<ast::Function>),
    Joint(Rc<ast::Joint>, Progress<Arguments>),
}

/// A point or an axis, and how far it has been resolved.
pub(super) struct Mark {
    pub(super) written: Rc<ast::Mark>,
    pub(super) progress: Progress<Value>,
}

/// A frame and what is fixed in it.
pub(super) struct Frame {
    pub(super) name: String,
    /// x, y and angle; ground has none.
    pub(super) coordinates: Option<[Expr; 3]>,
    pub(super) marks: BTreeMap<String, Mark>,
    /// Names of the marks as declared.
    pub(super) order: Vec<String>,
}

/// All names of a mechanism.
#[derive(Default)]
pub(crate) struct Names {
    pub(super) frames: Vec<Frame>,
    pub(super) definitions: BTreeMap<String, Rc<Definition>>,
    /// Functions whose bodies are being looked at, to stop recursion.
    pub(super) open_functions: Vec<String>,
    /// A definition is checked on its own, with bodies and numbers nothing is known of.
    pub(super) is_abstract: bool,
    /// Everything declared, and what it is in words.
    pub(super) entities: BTreeMap<String, (Entity, &'static str)>,
    pub(super) order: Vec<String>,
    /// Names that `use` items brought in.
    pub(super) used: Vec<String>,
}

impl Names {
    /// With ground as the only frame.
    pub(super) fn new() -> Names {
        let ground = Frame { name: "ground".into(), coordinates: None, marks: BTreeMap::new(), order: Vec::new() };
        Names { frames: vec![ground], ..Names::default() }
    }

    /// For checking a definition on its own.
    pub(super) fn abstract_() -> Names {
        Names { is_abstract: true, ..Names::new() }
    }

    pub(super) fn is_abstract(&self) -> bool {
        self.is_abstract
    }

    pub(super) fn is_known(&self, name: &Ident) -> bool {
        self.entities.contains_key(&name.to_string())
    }

    /// Every declared name, in order.
    pub(super) fn all(&self) -> Vec<String> {
        self.order.clone()
    }

    /// `body.name` for a point or an axis of this name.
    pub(super) fn mark_called(&self, name: &Ident) -> Option<String> {
        let owner = self.frames.iter().find(|frame| frame.marks.contains_key(&name.to_string()))?;
        Some(format!("{}.{name}", owner.name))
    }

    /// The name of a joint stands for a joint, not for another item declared before it.
    pub(super) fn is_declared_as(&self, joint: &ast::Joint) -> bool {
        matches!(self.entities.get(&joint.name.to_string()), Some((Entity::Joint(declared, _), _)) if declared.is_drive == joint.is_drive)
    }

    /// What a joint was made with, once that is known.
    pub(super) fn arguments_of(&self, joint: &Ident) -> Option<Arguments> {
        match self.entities.get(&joint.to_string()) {
            Some((Entity::Joint(_, Progress::Done(arguments)), _)) => Some(arguments.clone()),
            _ => None,
        }
    }

    /// The first point of a frame.
    pub(super) fn a_point_of(&self, frame: FrameId) -> Option<&str> {
        let frame = &self.frames[frame.0];
        frame.order.iter().map(String::as_str).find(|name| frame.marks.get(*name).is_some_and(|mark| !mark.written.is_axis))
    }

    /// Notes how far an item has been resolved.
    pub(super) fn set(&mut self, name: String, entity: Entity) {
        if let Some(known) = self.entities.get_mut(&name) {
            known.0 = entity;
        }
    }

    /// The names of declared functions, in order.
    pub(super) fn functions(&self) -> Vec<String> {
        let is_function = |name: &&String| matches!(self.entities.get(*name), Some((Entity::Function(_), _)));
        self.order.iter().filter(is_function).cloned().collect()
    }
}
