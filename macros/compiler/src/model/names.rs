//! All names of a mechanism, and how far what they stand for has been resolved.
//!
//! Names live in spaces: that of the mechanism, one for each part, one for each body. A name with indices is an array, and
//! each of its members is an item of its own.

use super::Name;
use super::key::Key;
use super::value::{FrameId, Value};
use crate::expr::Expr;
use crate::quantity::Role;
use crate::syntax::ast::{self, Definition};
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};
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
    "prepared",
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

/// Number of a space; that of the mechanism is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SpaceId(pub(super) usize);

impl SpaceId {
    /// The mechanism itself.
    pub(super) const MECHANISM: SpaceId = SpaceId(0);
}

/// Number of a name in its space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct GroupId(pub(super) usize);

/// Number of a declared item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EntityId(pub(super) usize);

/// How far an item has been resolved.
#[derive(Clone)]
pub(super) enum Progress {
    Untouched,
    Open,
    Done(Value),
    /// It was refused; whoever needs it stays silent.
    Failed,
}

/// What a declared item is.
#[derive(Clone)]
pub(super) enum Entity {
    /// A parameter, a body, a part: known from the beginning.
    Known,
    Let(ast::Node<ast::Let>),
    Function(ast::Node<ast::Function>),
    Joint(ast::Node<ast::Joint>),
    Mark(FrameId, ast::Node<ast::Mark>),
    /// What a part was made with, by the number of the component's parameter.
    Argument(Rc<PartArguments>, usize),
}

/// A part and what was written between its parentheses.
pub(super) struct PartArguments {
    pub(super) component: ast::Node<ast::Component>,
    pub(super) part: ast::Node<ast::Part>,
    /// For each parameter of the component the argument's number, if there is one.
    pub(super) slots: Vec<Option<usize>>,
    /// Where the part was declared.
    pub(super) outside: Context,
}

/// Where an item stands: in which space, in which round of which loops.
#[derive(Clone)]
pub(super) struct Context {
    pub(super) space: SpaceId,
    /// The variables of the loops around it.
    pub(super) bound: Rc<Vec<(String, Value)>>,
}

/// A declared item.
pub(super) struct Declared {
    pub(super) entity: Entity,
    pub(super) progress: Progress,
    pub(super) name: Name,
    pub(super) context: Context,
}

/// What a name was given to.
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
    Part,
    Argument,
    Output,
}

impl Sort {
    /// In a sentence.
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
            Sort::Part => "a part",
            Sort::Argument => "an argument",
            Sort::Output => "an output",
        }
    }

    /// Components see it in the mechanism around them, since it does not move.
    pub(super) fn is_seen_from_components(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Let | Sort::Function)
    }
}

/// One name of a space: a single item, or an array of them.
pub(super) struct NamedItems {
    pub(super) word: String,
    /// As it is called from outside: `leg[3].coupler`.
    pub(super) path: String,
    pub(super) sort: Sort,
    /// How many indices its members have.
    pub(super) ranks: usize,
    /// By their indices; a single item has none.
    pub(super) members: BTreeMap<Vec<usize>, EntityId>,
}

/// Names that belong together.
#[derive(Default)]
pub(super) struct Space {
    /// How a name in it is called from outside: empty, or `leg[3].`.
    pub(super) prefix: String,
    pub(super) groups: BTreeMap<String, GroupId>,
    pub(super) order: Vec<GroupId>,
}

/// A frame and what is fixed in it.
pub(super) struct FrameScope {
    pub(super) name: String,
    /// Where its coordinates begin in q.
    pub(super) first: usize,
    /// What places it; ground has none.
    pub(super) coordinates: Vec<(Role, Expr)>,
    /// Its points and axes.
    pub(super) space: SpaceId,
}

/// All names of a mechanism.
pub(crate) struct Names {
    pub(super) frames: Vec<FrameScope>,
    pub(super) spaces: Vec<Space>,
    pub(super) groups: Vec<NamedItems>,
    pub(super) declared: Vec<Declared>,
    /// The numbers of declarations in the tree, by their names.
    pub(super) declarations: BTreeMap<Key, usize>,
    /// Constraints that were brought in, and those of the library that were asked for.
    pub(super) definitions: BTreeMap<String, Rc<Definition>>,
    pub(super) library: BTreeMap<String, Option<Rc<Definition>>>,
    pub(super) components: BTreeMap<String, ast::Node<ast::Component>>,
    /// Names with a meaning of their own that were given to something else: what a use of them means is not clear.
    pub(super) misused: BTreeSet<String>,
    /// Items that are being resolved, each for the one before it.
    pub(super) open: Vec<EntityId>,
    /// Functions whose bodies are being looked at, to stop recursion.
    pub(super) open_functions: Vec<String>,
    /// A definition is checked on its own, with bodies and numbers nothing is known of.
    pub(super) is_abstract: bool,
    /// Outputs by the space they belong to: names that no expression can read.
    pub(super) outputs: BTreeSet<(SpaceId, String)>,
    /// Names that `use` items brought in.
    pub(super) used: Vec<String>,
}

impl Names {
    /// With ground as the only frame.
    pub(super) fn new(definitions: BTreeMap<String, Rc<Definition>>) -> Names {
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
        }
    }

    /// For checking a definition on its own.
    pub(super) fn abstract_() -> Names {
        Names { is_abstract: true, ..Names::new(BTreeMap::new()) }
    }

    pub(super) fn is_abstract(&self) -> bool {
        self.is_abstract
    }

    /// A fresh space whose names begin with `prefix`.
    pub(super) fn new_space(&mut self, prefix: String) -> SpaceId {
        self.spaces.push(Space { prefix, ..Space::default() });
        SpaceId(self.spaces.len() - 1)
    }

    /// The name in a space, if it is declared there.
    pub(super) fn find(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        self.spaces[space.0].groups.get(word).copied()
    }

    /// What a name means where an item of a space stands: its own names, then those of the mechanism.
    pub(super) fn visible(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        self.find(space, word).or_else(|| self.find(SpaceId::MECHANISM, word))
    }

    pub(super) fn group(&self, group: GroupId) -> &NamedItems {
        &self.groups[group.0]
    }

    /// The names that are visible from a space, in the order declared.
    pub(super) fn all(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        let outer = (space != SpaceId::MECHANISM).then(|| self.words(SpaceId::MECHANISM));
        self.words(space).chain(outer.into_iter().flatten())
    }

    /// The names of one space, in the order declared.
    pub(super) fn words(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        self.spaces[space.0].order.iter().map(|group| self.groups[group.0].word.as_str())
    }

    /// `body.name` for a point or an axis of this name.
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
