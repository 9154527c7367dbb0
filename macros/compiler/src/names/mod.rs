//! All names of a mechanism, and the state of their resolution.
//!
//! Namespaces, values, keys of declarations, and signatures of definitions, for `resolve`. Nothing here resolves an expression.
//!
//! Names live in namespaces: that of the mechanism, one for each part, one for each body. A name with indices is an array, and each of
//! its elements is a separate item.

mod declare;
mod key;
mod kind;
mod order;
mod proposals;
mod register;
mod scope;
mod signature;
mod value;

pub(crate) use key::Key;
pub(crate) use kind::{nearest_kind, unknown_kind};
pub(crate) use order::{as_written, completed, fitted, reordered};
pub(crate) use register::{
    FixedValue, HEIGHT, INPUT_PARTS, Notes, OpenPart, Register, Written, duplicate, is_one_of_many, misread_height, unknown_field,
};
pub(crate) use scope::{Instance, Scope, Timeless};
pub(crate) use signature::{is_between, places, signature, too_few, too_many, unknown_argument, wanted};
pub(crate) use value::{Arguments, Fixed, FrameId, FunctionValue, Scalar, Value, Vector};

use crate::expr::Expr;
use crate::model::Name;
use crate::quantity::{Ambient, Role};
use crate::syntax::ast::{self, Definition, ExpressionKind, FormalKind};
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Names with a predefined meaning in expressions.
pub(crate) const RESERVED: &[&str] = &["t", "pi", "ground"];

/// Built-in functions of space.
pub(crate) const SPATIAL_BUILTINS: &[&str] = &["across", "along", "joint_angle", "misalignment", "turn", "x_axis", "y_axis", "z_axis"];

/// True for a function of space, in the plane, or of the plane, in space.
pub(crate) fn is_elsewhere(word: &str, ambient: Ambient) -> bool {
    match ambient {
        Ambient::Plane => SPATIAL_BUILTINS.contains(&word),
        Ambient::Space => ["perp", "direction"].contains(&word),
    }
}

/// All built-in names, for suggestions and the language reference.
pub(crate) const BUILTINS: &[&str] = &[
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sqrt",
    "exp",
    "ln",
    "abs",
    "min",
    "max",
    "dot",
    "cross",
    "perp",
    "norm",
    "unit",
    "direction",
    "table",
];

/// True for names that no item may have.
pub(crate) fn is_reserved(word: &str) -> bool {
    RESERVED.contains(&word) || BUILTINS.contains(&word)
}

/// Number of a namespace; that of the mechanism is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SpaceId(pub(crate) usize);

impl SpaceId {
    /// The mechanism itself.
    pub(crate) const MECHANISM: SpaceId = SpaceId(0);
}

/// Number of a declared name: a single item, or an array of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct GroupId(pub(crate) usize);

/// Number of a declared item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EntityId(pub(crate) usize);

/// State of the resolution of an item.
#[derive(Clone)]
pub(crate) enum Progress {
    Untouched,
    Open,
    Done(Value),
    /// The item was rejected; its uses report no further error.
    Failed,
}

/// Kind of a declared item.
#[derive(Clone)]
pub(crate) enum Entity {
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
pub(crate) struct PartArguments {
    pub(crate) component: ast::Shared<ast::ComponentItem>,
    pub(crate) part: ast::Shared<ast::PartItem>,
    /// For each parameter of the component, the index of its argument, if one was written.
    pub(crate) slots: Vec<Option<usize>>,
    /// Context in which the part is declared.
    pub(crate) outside: Context,
}

/// Context of an item: its namespace, and the enclosing loops.
#[derive(Clone)]
pub(crate) struct Context {
    pub(crate) space: SpaceId,
    /// Variables of the enclosing loops.
    pub(crate) bound: Rc<Vec<(String, Value)>>,
}

/// A declared item.
pub(crate) struct Declared {
    pub(crate) entity: Entity,
    pub(crate) progress: Progress,
    pub(crate) name: Name,
    pub(crate) context: Context,
}

/// Sort of item that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    Parameter,
    Input,
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
    pub(crate) fn noun(self) -> &'static str {
        match self {
            Sort::Parameter => "a parameter",
            Sort::Input => "an input",
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
    pub(crate) fn may_be_function(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Input | Sort::Let | Sort::Function | Sort::Argument)
    }

    /// True if such an item can stand for a number.
    pub(crate) fn may_be_number(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Input | Sort::Let | Sort::Freedom | Sort::Argument)
    }

    /// True if components see such items of the mechanism around them: no body belongs to them.
    pub(crate) fn is_seen_from_components(self) -> bool {
        matches!(self, Sort::Parameter | Sort::Input | Sort::Let | Sort::Function)
    }
}

/// One name of a namespace: a single item, or an array of them.
pub(crate) struct NamedItems {
    pub(crate) word: String,
    /// Full path: `leg[3].coupler`.
    pub(crate) path: String,
    pub(crate) sort: Sort,
    /// Number of indices of each element.
    pub(crate) ranks: usize,
    /// Elements by their indices; a single item has none.
    pub(crate) members: BTreeMap<Vec<usize>, EntityId>,
}

/// A namespace.
#[derive(Default)]
pub(crate) struct Space {
    /// Prefix of the paths of its names: empty, or `leg[3].`.
    pub(crate) prefix: String,
    pub(crate) groups: BTreeMap<String, GroupId>,
    pub(crate) order: Vec<GroupId>,
    /// Of a part of an imported component, its home: its items see no name of the mechanism.
    pub(crate) home: Option<usize>,
}

/// A frame with its coordinates, points and axes.
pub(crate) struct FrameScope {
    pub(crate) name: String,
    /// Index in q of the first coordinate.
    pub(crate) first: usize,
    /// Coordinates that place the frame; ground has none.
    pub(crate) coordinates: Vec<(Role, Expr)>,
    /// Namespace of its points and axes.
    pub(crate) space: SpaceId,
}

/// Name of the body of an argument of which only the kind is known.
pub(crate) const UNKNOWN_BODY: &str = "a body";

impl FrameScope {
    /// True for the body of an argument of which only the kind is known: it may be any.
    pub(crate) fn is_unknown(&self) -> bool {
        self.name == UNKNOWN_BODY
    }
}

/// All names of a mechanism.
pub(crate) struct Names {
    pub(crate) frames: Vec<FrameScope>,
    pub(crate) spaces: Vec<Space>,
    pub(crate) groups: Vec<NamedItems>,
    pub(crate) declared: Vec<Declared>,
    /// Number of each declaration in the tree, by the key of its name.
    pub(crate) declarations: BTreeMap<Key, usize>,
    /// Imported constraints, and constraints of the library that were looked up.
    pub(crate) definitions: BTreeMap<String, Rc<Definition>>,
    pub(crate) library: BTreeMap<String, Option<Rc<Definition>>>,
    pub(crate) components: BTreeMap<String, ast::Shared<ast::ComponentItem>>,
    /// The definitions that imported components see.
    pub(crate) homes: Vec<ast::ComponentHome>,
    /// Home of the item that is being resolved, if it belongs to an imported component.
    pub(crate) home: Option<usize>,
    /// Names with a predefined meaning that were declared as something else: their uses are ambiguous.
    pub(crate) misused: BTreeSet<String>,
    /// Items being resolved; each is needed by the one before it.
    pub(crate) open: Vec<EntityId>,
    /// Functions being evaluated, to detect recursion.
    pub(crate) open_functions: Vec<String>,
    /// True while a definition is checked on its own, with unknown bodies and numbers.
    pub(crate) is_abstract: bool,
    /// Outputs by namespace: names that no expression can read.
    pub(crate) outputs: BTreeSet<(SpaceId, String)>,
    /// Names imported by `use` items.
    pub(crate) used: Vec<String>,
    /// Motion in the plane or in space.
    pub(crate) ambient: Ambient,
}

impl Names {
    /// Names with ground as the only frame.
    pub(crate) fn new(definitions: BTreeMap<String, Rc<Definition>>, ambient: Ambient) -> Names {
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
            homes: Vec::new(),
            home: None,
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
    pub(crate) fn abstract_(ambient: Ambient) -> Names {
        Names { is_abstract: true, ..Names::new(BTreeMap::new(), ambient) }
    }

    pub(crate) fn is_abstract(&self) -> bool {
        self.is_abstract
    }

    /// Adds a namespace whose paths begin with `prefix`. `home`: given, that of an imported component.
    pub(crate) fn new_space(&mut self, prefix: String, home: Option<usize>) -> SpaceId {
        self.spaces.push(Space { prefix, home, ..Space::default() });
        SpaceId(self.spaces.len() - 1)
    }

    /// Looks a name up in one namespace.
    pub(crate) fn find(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        self.spaces[space.0].groups.get(word).copied()
    }

    /// Looks a name up for an item of a namespace: there first, then in the mechanism.
    pub(crate) fn visible(&self, space: SpaceId, word: &str) -> Option<GroupId> {
        let outer = self.spaces[space.0].home.is_none().then_some(SpaceId::MECHANISM);
        self.find(space, word).or_else(|| self.find(outer?, word))
    }

    /// A point or an axis of the body in which an expression stands, unless something else that can be fixed has its name.
    pub(crate) fn own_mark(&self, scope: &Scope, word: &str) -> Option<(SpaceId, GroupId)> {
        let outer = scope.space.and_then(|space| self.visible(space, word));
        let gives_way = |group| matches!(self.group(group).sort, Sort::Body | Sort::Drive | Sort::Freedom | Sort::Force | Sort::Output);
        let own = self.frames[scope.body.filter(|_| outer.is_none_or(gives_way))?.0].space;
        Some((own, self.find(own, word)?))
    }

    /// The word for the kind of a joint of the mechanism, if the expression is its name.
    pub(crate) fn joint_kind(&self, written: &ast::Expression) -> Option<String> {
        let ExpressionKind::Path(path) = &written.kind else { return None };
        let name = path.name.as_ref()?;
        self.declared.iter().find_map(|declared| match &declared.entity {
            Entity::Joint(joint) if declared.name.word == *name => match &joint.body {
                ast::JointBody::Of { kind, .. } => Some(kind.to_string()),
                _ => Some(String::new()),
            },
            _ => None,
        })
    }

    /// True for the path of an axis, `body.axis`, and for a direction that is written out.
    pub(crate) fn is_axis(&self, value: &ast::Expression, scope: &Scope) -> bool {
        if let ExpressionKind::Tuple(items) = &value.kind {
            return items.iter().all(|item| matches!(item.kind, ExpressionKind::Number { .. }));
        }
        let ExpressionKind::Field(owner, name) = &value.kind else { return false };
        let ExpressionKind::Path(path) = &owner.kind else { return false };
        let frame = match &path.name {
            Some(name) if name == "ground" => Some(FrameId::GROUND),
            Some(name) => (0..self.frames.len()).map(FrameId).find(|frame| name == &self.frames[frame.0].name),
            None => None,
        };
        let is_bound = path.name.as_ref().is_some_and(|name| scope.value_of(name).is_some());
        let group = frame.filter(|_| !is_bound).and_then(|frame| self.find(self.frames[frame.0].space, &name.to_string()));
        group.is_some_and(|group| self.group(group).sort == Sort::Axis)
    }

    /// Constraint or force that the item being resolved calls by this name, if it is none of the library.
    pub(crate) fn definition(&self, word: &str) -> Option<&Rc<Definition>> {
        self.definitions().get(word)
    }

    /// Those of the mechanism, or of the home of an imported component.
    pub(crate) fn definitions(&self) -> &BTreeMap<String, Rc<Definition>> {
        self.home.map_or(&self.definitions, |home| &self.homes[home].definitions)
    }

    /// A definition of this name that imported components see.
    pub(crate) fn definition_at_home(&self, word: &str) -> Option<&Rc<Definition>> {
        self.homes.iter().find_map(|home| home.definitions.get(word))
    }

    /// The components that an item of a namespace can have parts of.
    pub(crate) fn components_in(&self, space: SpaceId) -> &BTreeMap<String, ast::Shared<ast::ComponentItem>> {
        self.spaces[space.0].home.map_or(&self.components, |home| &self.homes[home].components)
    }

    pub(crate) fn group(&self, group: GroupId) -> &NamedItems {
        &self.groups[group.0]
    }

    /// The names visible in a namespace, in the order declared.
    pub(crate) fn all(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        let is_open = space != SpaceId::MECHANISM && self.spaces[space.0].home.is_none();
        let outer = is_open.then(|| self.words(SpaceId::MECHANISM));
        self.words(space).chain(outer.into_iter().flatten())
    }

    /// The names of one namespace, in the order declared.
    pub(crate) fn words(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        self.spaces[space.0].order.iter().map(|group| self.groups[group.0].word.as_str())
    }

    /// Path `body.name` of a point or an axis with this name.
    pub(crate) fn mark_called(&self, name: &Ident) -> Option<String> {
        let word = name.to_string();
        let owner = self.frames.iter().find(|frame| self.find(frame.space, &word).is_some())?;
        Some(format!("{}.{name}", owner.name))
    }

    /// The points of a frame, in the order declared.
    pub(crate) fn points_of(&self, frame: FrameId) -> impl Iterator<Item = &str> {
        let space = &self.spaces[self.frames[frame.0].space.0];
        let is_point = |group: &&NamedItems| group.sort == Sort::Point && group.ranks == 0;
        space.order.iter().map(|group| &self.groups[group.0]).filter(is_point).map(|group| group.word.as_str())
    }

    /// The first axis of a frame.
    pub(crate) fn an_axis_of(&self, frame: FrameId) -> Option<&str> {
        let space = &self.spaces[self.frames[frame.0].space.0];
        let is_axis = |group: &&NamedItems| group.sort == Sort::Axis && group.ranks == 0;
        space.order.iter().map(|group| &self.groups[group.0]).find(is_axis).map(|group| group.word.as_str())
    }

    /// The first axis of a frame that has the name of an axis of each of the others.
    pub(crate) fn an_axis_of_all(&self, frames: &[FrameId]) -> Option<&str> {
        let axes = |frame: &FrameId| {
            let order = &self.spaces[self.frames[frame.0].space.0].order;
            order.iter().map(|group| &self.groups[group.0]).filter(|group| group.sort == Sort::Axis && group.ranks == 0)
        };
        let (first, others) = frames.split_first()?;
        let is_in_all = |name: &&str| others.iter().all(|other| axes(other).any(|group| group.word == **name));
        axes(first).map(|group| group.word.as_str()).find(is_in_all)
    }

    /// The functions that an item of a namespace can call, in the order declared: `function`s, and arguments that are functions.
    pub(crate) fn functions(&self, space: SpaceId) -> impl Iterator<Item = &str> {
        self.all(space).filter(move |word| self.visible(space, word).is_some_and(|group| self.is_function(self.group(group))))
    }

    /// True for a `function`, and for an argument or a `let` that is one.
    fn is_function(&self, named: &NamedItems) -> bool {
        let of_item = |id: &EntityId| match &self.declared[id.0] {
            Declared { progress: Progress::Done(value), .. } => matches!(value, Value::Function(_)),
            Declared { entity: Entity::Argument(made, number), .. } => {
                matches!(made.component.head.parameters[*number].kind, FormalKind::Function(..))
            }
            _ => false,
        };
        named.sort == Sort::Function || named.members.values().any(of_item)
    }
}
