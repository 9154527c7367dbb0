//! All names of a mechanism, and the state of their resolution.
//!
//! Names live in namespaces: that of the mechanism, one for each part, one for each body. A name with indices is an array, and each of
//! its elements is a separate item.

use super::Name;
use super::key::Key;
use super::value::{FrameId, Value};
use crate::expr::Expr;
use crate::quantity::{Ambient, Role};
use crate::syntax::ast::{self, Definition};
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Names with a predefined meaning in expressions.
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
    "prepared",
    "start",
    "validate",
    "characteristic_length",
    "with_defaults",
    "clone",
    "default",
];

/// True if a generated function has this name.
pub(crate) fn is_generated(name: &Ident) -> bool {
    GENERATED.iter().any(|known| name == known)
}

/// Number of a namespace; that of the mechanism is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SpaceId(pub(super) usize);

impl SpaceId {
    /// The mechanism itself.
    pub(super) const MECHANISM: SpaceId = SpaceId(0);
}

/// Number of a declared name: a single item, or an array of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct GroupId(pub(super) usize);

/// Number of a declared item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EntityId(pub(super) usize);

/// State of the resolution of an item.
#[derive(Clone)]
pub(super) enum Progress {
    Untouched,
    Open,
    Done(Value),
    /// The item was rejected; its uses report no further error.
    Failed,
}

/// Kind of a declared item.
#[derive(Clone)]
pub(super) enum Entity {
    /// A parameter, a body, a part: its value is known from the beginning.
    Known,
    Let(ast::Shared<ast::Let>),
    Function(ast::Shared<ast::FunctionItem>),
    Joint(ast::Shared<ast::JointItem>),
    Mark(FrameId, ast::Shared<ast::Feature>),
    /// An argument of a part, with the number of the component's parameter.
    Argument(Rc<PartArguments>, usize),
}

/// A part with its arguments.
pub(super) struct PartArguments {
    pub(super) component: ast::Shared<ast::ComponentItem>,
    pub(super) part: ast::Shared<ast::PartItem>,
    /// For each parameter of the component, the index of its argument, if one was written.
    pub(super) slots: Vec<Option<usize>>,
    /// Context in which the part is declared.
    pub(super) outside: Context,
}

/// Context of an item: its namespace, and the enclosing loops.
#[derive(Clone)]
pub(super) struct Context {
    pub(super) space: SpaceId,
    /// Variables of the enclosing loops.
    pub(super) bound: Rc<Vec<(String, Value)>>,
}

/// A declared item.
pub(super) struct Declared {
    pub(super) entity: Entity,
    pub(super) progress: Progress,
    pub(super) name: Name,
    pub(super) context: Context,
}

/// Sort of item that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Parameter,
    Let,
    Function,
    Body,
    Point,
    Axis,
    Joint,
    Drive,
    Freedom,
    Force,
    Part,
    Argument,
    Output,
}

impl Sort {
    /// Noun for messages: `a body`.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Sort::Parameter => "a parameter",
            Sort::Let => "a `let`",
            Sort::Function => "a function",
            Sort::Body => "a body",
            Sort::Point => "a point",
            Sort::Axis => "an axis",
            Sort::Joint => "a joint",
            Sort::Drive => "a drive",
            Sort::Freedom => "a freedom",
            Sort::Force => "a force",
            Sort::Part => "a part",
            Sort::Argument => "an argument",
            Sort::Output => "an output",
        }
    }

    /// True if such an item can be called.
    pub(super) fn may_be_function(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Let | Sort::Function | Sort::Argument)
    }

    /// True if components see such items of the mechanism around them: they do not move.
    pub(super) fn is_seen_from_components(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Let | Sort::Function)
    }
}

/// One name of a namespace: a single item, or an array of them.
pub(super) struct NamedItems {
    pub(super) word: String,
    /// Full path: `leg[3].coupler`.
    pub(super) path: String,
    pub(super) sort: Sort,
    /// Number of indices of each element.
    pub(super) ranks: usize,
    /// Elements by their indices; a single item has none.
    pub(super) members: BTreeMap<Vec<usize>, EntityId>,
}

/// A namespace.
#[derive(Default)]
pub(super) struct Space {
    /// Prefix of the paths of its names: empty, or `leg[3].`.
    pub(super) prefix: String,
    pub(super) groups: BTreeMap<String, GroupId>,
    pub(super) order: Vec<GroupId>,
}

/// A frame with its coordinates, points and axes.
pub(super) struct FrameScope {
    pub(super) name: String,
    /// Index in q of the first coordinate.
    pub(super) first: usize,
    /// Coordinates that place the frame; ground has none.
    pub(super) coordinates: Vec<(Role, Expr)>,
    /// Namespace of its points and axes.
    pub(super) space: SpaceId,
}

/// All names of a mechanism.
pub(crate) struct Names {
    pub(super) frames: Vec<FrameScope>,
    pub(super) spaces: Vec<Space>,
    pub(super) groups: Vec<NamedItems>,
    pub(super) declared: Vec<Declared>,
    /// Number of each declaration in the tree, by the key of its name.
    pub(super) declarations: BTreeMap<Key, usize>,
    /// Imported constraints, and constraints of the library that were looked up.
    pub(super) definitions: BTreeMap<String, Rc<Definition>>,
    pub(super) library: BTreeMap<String, Option<Rc<Definition>>>,
    pub(super) components: BTreeMap<String, ast::Shared<ast::ComponentItem>>,
    /// Names with a predefined meaning that were declared as something else: their uses are ambiguous.
    pub(super) misused: BTreeSet<String>,
    /// Items being resolved; each is needed by the one before it.
    pub(super) open: Vec<EntityId>,
    /// Functions being evaluated, to detect recursion.
    pub(super) open_functions: Vec<String>,
    /// True while a definition is checked on its own, with unknown bodies and numbers.
    pub(super) is_abstract: bool,
    /// Outputs by namespace: names that no expression can read.
    pub(super) outputs: BTreeSet<(SpaceId, String)>,
    /// Names imported by `use` items.
    pub(super) used: Vec<String>,
    /// Where the bodies move.
    pub(super) ambient: Ambient,
}

impl Names {
    /// Names with ground as the only frame.
    pub(super) fn new(definitions: BTreeMap<String, Rc<Definition>>, ambient: Ambient) -> Names {
        let ground = FrameScope { name: "ground".into(), first: 0, coordinates: Vec::new(), space: SpaceId(1) };
        Names {
            frames: vec![ground],
            spaces: vec![Space::default(), Space { prefix: "ground.".into(), ..Space::default() }],
            groups: Vec::new(),
            declared: Vec::new(),
            declarations: BTreeMap::new(),
            definitions,
            library: BTreeMap::new(),
            components: BTreeMap::new(),
            misused: BTreeSet::new(),
            open: Vec::new(),
            open_functions: Vec::new(),
            is_abstract: false,
            outputs: BTreeSet::new(),
            used: Vec::new(),
            ambient,
        }
    }

    /// Names for checking a definition on its own.
    pub(super) fn abstract_(ambient: Ambient) -> Names {
        Names { is_abstract: true, ..Names::new(BTreeMap::new(), ambient) }
    }

    pub(super) fn is_abstract(&self) -> bool {
        self.is_abstract
    }

    /// Adds a namespace whose paths begin with `prefix`.
    pub(super) fn new_space(&mut self, prefix: String) -> SpaceId {
        self.spaces.push(Space { prefix, ..Space::default() });
        SpaceId(self.spaces.len() - 1)
    }

    /// Looks a name up in one namespace.
    pub(super) fn find(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        self.spaces[space.0].groups.get(word).copied()
    }

    /// Looks a name up for an item of a namespace: there first, then in the mechanism.
    pub(super) fn visible(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        self.find(space, word).or_else(|| self.find(SpaceId::MECHANISM, word))
    }

    pub(super) fn group(&self, group: GroupId) -> &NamedItems {
        &self.groups[group.0]
    }

    /// The names visible in a namespace, in the order declared.
    pub(super) fn all(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        let outer = (space != SpaceId::MECHANISM).then(|| self.words(SpaceId::MECHANISM));
        self.words(space).chain(outer.into_iter().flatten())
    }

    /// The names of one namespace, in the order declared.
    pub(super) fn words(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        self.spaces[space.0].order.iter().map(|group| self.groups[group.0].word.as_str())
    }

    /// Path `body.name` of a point or an axis with this name.
    pub(super) fn mark_called(&self, name: &Ident) -> Option<String> {
        let word = name.to_string();
        let owner = self.frames.iter().find(|frame| self.find(frame.space, &word).is_some())?;
        Some(format!("{}.{name}", owner.name))
    }

    /// The first point of a frame.
    pub(super) fn a_point_of(&self, frame: FrameId) -> Option<&str> {
        let space = &self.spaces[self.frames[frame.0].space.0];
        let is_point = |group: &&NamedItems| group.sort == Sort::Point && group.ranks == 0;
        space.order.iter().map(|group| &self.groups[group.0]).find(is_point).map(|group| group.word.as_str())
    }

    /// The first axis of a frame.
    pub(super) fn an_axis_of(&self, frame: FrameId) -> Option<&str> {
        let space = &self.spaces[self.frames[frame.0].space.0];
        let is_axis = |group: &&NamedItems| group.sort == Sort::Axis && group.ranks == 0;
        space.order.iter().map(|group| &self.groups[group.0]).find(is_axis).map(|group| group.word.as_str())
    }

    /// The names of declared functions, in order.
    pub(super) fn functions(&self) -> impl Iterator<Item = &str> {
        let groups = self.spaces[SpaceId::MECHANISM.0].order.iter().map(|group| &self.groups[group.0]);
        groups.filter(|group| group.sort == Sort::Function).map(|group| group.word.as_str())
    }
}
