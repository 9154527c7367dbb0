//! What can be wrong with a declaration: facts with their numbers, in families. `message.rs` has the words, a file for each family.

use crate::quantity::{Dim, Role};

/// Something wrong with a declaration.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // Each family has its documentation.
pub enum Fact {
    Grammar(GrammarFact),
    Array(ArrayFact),
    Name(NameFact),
    Arity(ArityFact),
    Value(ValueFact),
    Equation(EquationFact),
    System(SystemFact),
    Assembly(AssemblyFact),
    InInstance { place: String, fact: Box<Fact> },
    InDefinition { definition: String, quantities: Vec<(String, Dim)>, fact: Box<Fact> },
}

macro_rules! families {
    ($($family:ident: $fact:ident),*) => {
        $(impl From<$fact> for Fact {
            fn from(fact: $fact) -> Fact {
                Fact::$family(fact)
            }
        })*
    };
}

families! {
    Grammar: GrammarFact, Array: ArrayFact, Name: NameFact, Arity: ArityFact, Value: ValueFact, Equation: EquationFact, System: SystemFact, Assembly: AssemblyFact
}

/// Tokens that are no declaration.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum GrammarFact {
    Syntax { message: String },
    Expected { what: &'static str, found: String },
    Unnamed { word: &'static str, kind: String },
    NotANumber { found: &'static str },
    TooDeep { limit: u16 },
    PartsTooDeep { limit: usize },
    TooLong { limit: u16 },
    LongChain { limit: u16, in_function: bool },
    Keyword { word: String },
    NumberType,
    UnknownAttribute { name: String },
    ClosingWord { near: Option<String> },
    AllowedWord { near: Option<String> },
    AttributeTwice { name: String },
    TokensAfter { what: &'static str, help: &'static str },
    UnknownItem { word: String },
    UnknownBodyItem { word: String },
    OneArgument,
    PairWithoutParentheses { what: &'static str },
    PathOfConstraint { path: String, last: String },
    DoubleStar,
    MethodCall { name: String },
    SpaceBeforeUnit { number: String, unit: String },
    ExponentTooLarge { limit: u8 },
    OnlyAtTheTop { word: String },
    StartInLoop,
    IndexInEquations { name: String },
}

/// Loops, arrays, components and parts.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ArrayFact {
    WithoutIndex { name: String, variable: String },
    DuplicateInLoop { name: String, variable: String },
    ArrayWithoutIndex { name: String },
    NoArray { found: &'static str, is_member: bool },
    IndexOutOfRange { name: String, index: i64, ends: Option<(usize, usize)>, known: Known },
    NegativeIndex { index: i64 },
    MissingIndex { what: &'static str, missing: String, known: String },
    NotWhole { found: String },
    NotKnownWhole,
    EmptyRange { from: i64, to: i64, is_inclusive: bool },
    LongRange { rounds: i128, limit: usize },
    TooManyItems { limit: usize },
    WholeTooLarge { found: String },
    UnknownComponent { name: String, near: Option<String>, is_constraint: bool },
    ComponentAsConstraint { name: String },
    ComponentRecursion { name: String },
    ParameterAsArgument { component: String, name: String, part: String },
    OutsideOfComponent { name: String, what: &'static str },
    UnlikeParts { name: String, component: String },
    UnlikeOutputs { name: String },
    GeneratedType { name: String },
}

/// Names: unknown, taken, or in a circle.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum NameFact {
    UnknownName { name: String, near: Option<String> },
    OutputRead { name: String },
    UnitAlone { name: String },
    UnknownField { owner: String, name: String, near: Option<String>, known: Known },
    UnknownFunction { name: String, near: Option<String>, is_constraint: bool },
    UnknownConstraint { name: String, near: Option<String> },
    UnknownUnit { number: String, name: String, near: Option<String> },
    UnknownDimension { name: String, near: Option<String> },
    UnknownStart { name: String, near: Option<String> },
    NotAConstraint { name: String },
    UnknownKind { name: String, near: Option<String> },
    Duplicate { name: String, first: &'static str },
    DuplicateMark { name: String, body: String },
    DuplicateStart { name: String, body: String },
    DuplicateGround,
    DuplicateRange,
    Reserved { name: String },
    Generated { name: String },
    Cycle { name: String, through: Vec<String> },
    Recursion { name: String },
}

/// Arguments: too many, too few, in the wrong order.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ArityFact {
    TooManyArguments { definition: String, signature: String, takes: [usize; 2], found: usize },
    MissingArguments { definition: String, signature: String, takes: [usize; 2], found: usize, missing: Vec<String> },
    UnknownArgument { definition: String, name: String, signature: String, near: Option<String> },
    DuplicateArgument { name: String, is_also_in_order: bool },
    PositionalAfterNamed { next: Option<String> },
    FunctionArity { name: String, wanted: usize, found: usize },
    DefaultBefore { name: String },
}

/// Kinds, dimensions and values.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ValueFact {
    RangeWithoutEnd,
    NotA { wanted: &'static str, found: &'static str },
    WrongArgument { parameter: String, definition: String, wanted: String, found: String, instead: Option<String> },
    WrongArgumentDimension { parameter: String, definition: String, wanted: Dim, found: Dim },
    WrongDefault { wanted: String, found: &'static str },
    WrongDimension { wanted: Dim, found: Dim },
    Unlike { action: &'static str, one: Dim, two: Dim },
    NotALength { found: Dim, instead: Option<String> },
    FunctionTakes { wanted: Dim, found: Dim },
    OrderOfBodies,
    CannotCompare { one: &'static str, two: &'static str },
    CannotEquate { one: &'static str, two: &'static str },
    NotTwoComponents { found: usize },
    VectorAndNumber,
    VectorTimesVector,
    NumberByVector,
    PowerOfDimension { base: Dim },
    NotAnOutput { found: &'static str },
    NumberTooLong { number: String, limit: usize },
    NumberOutOfRange { number: String },
    NotFinite { place: &'static str },
    TooLarge { limit: usize, in_function: bool },
    DivisionByZero,
    EqualityInChoice,
    ListOutsideTable,
    TableArity { found: usize },
    TableNeedsList,
    TableNeedsPairs,
    TableNotIncreasing { before: f64, found: f64, dim: Dim },
    TableTooShort { found: usize },
    TableNotPeriodic { first: f64, last: f64, dim: Dim },
    TableEnds { found: String },
    NotConstant { place: &'static str, help: &'static str },
    EmptyBounds { bounds: String, is_point: bool },
    DefaultOutOfBounds { value: String, bounds: String },
    NotFixed { place: &'static str },
    FunctionNeedsArgument,
    ZeroAxis { name: String },
}

/// Joints, drives and definitions, each for itself.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum EquationFact {
    TimeIn { place: &'static str },
    TimeInDefinition,
    TimeInJoint { joint: String },
    RequirementFails { why: String, instead: Option<String> },
    RequirementFailsAtDefaults { why: String, value: f64 },
    RowOfNothing { joint: String, row: usize, of: usize, at_defaults: bool },
    OnGround { joint: String, kind: String },
    NoEquations { name: String },
    EmptyBundle { name: String },
    GroundStart,
}

/// The mechanism as a whole: mobility and redundancy.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum SystemFact {
    NoBodies { name: String },
    BodyIsFree { body: String, example: String },
    Repeats { joint: String, other: String },
    NotOnGround { bodies: Vec<String> },
    FreeCoordinates { body: String, coordinates: Vec<String>, has_place: bool, example: String },
    DrivesMissing { name: String, count: Box<Count>, forgotten: Box<Forgotten>, candidates: Vec<String>, example: String },
    NothingToDrive { drive: String, joints: Vec<String>, equations: [usize; 2], coordinates: Vec<String>, free: Vec<String> },
    DrivesContend { drives: Vec<String>, freedoms: usize, joints: Vec<String>, coordinates: Vec<String>, free: Vec<String> },
    Follows { joint: String, is_drive: bool, rows: Vec<usize>, of: usize, others: Vec<String> },
    Contradicts { joint: String, others: Vec<String>, demand: Option<Box<Demand>>, off: String },
    Collides { joint: String, others: Vec<String>, off: String },
    FollowsFrom { joint: String, is_drive: bool, rows: usize, of: usize, others: Vec<String>, free: Vec<String>, moves: bool },
    NotRedundant { joint: String, free: Vec<String> },
    CannotHold { joint: String, bodies: Vec<String>, length: Option<f64>, angle: Option<f64>, time: Option<f64>, is_redundant: bool },
    TooManyEquations { joint: String, others: Vec<String>, equations: usize, coordinates: Vec<String>, free: Vec<String>, for_free: usize },
}

/// The assembly at the declared defaults, and the motion from there.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum AssemblyFact {
    StaysOpen { joint: String, gap: Box<Gap>, others: Vec<String>, drives: Vec<String>, bound: Option<Box<Bound>> },
    NeverCloses { joints: Vec<String>, drives: Vec<String>, bound: Option<Box<Bound>> },
    HasNoRate { joint: String, row: usize, of: usize },
    HasNoValue { joint: String, row: usize, of: usize, drives: Vec<String>, has_none_anywhere: bool },
    SingularStart { bodies: Vec<String>, in_line: bool, drives: Vec<String>, has_others: bool },
    MotionEnds { joint: String, driven: Vec<Driven>, time: f64, in_line: Vec<String>, until: f64, declared: Option<[f64; 2]> },
    Crosses { driven: Vec<Driven>, time: f64 },
    AmbiguousStart { body: String, coordinate: Role, values: [f64; 2], place: [f64; 2], is_declared: bool },
}

/// The names that there are: the first few, and how many in all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The first few.
    pub first: Vec<String>,
    /// How many there are.
    pub count: usize,
}

impl Known {
    /// More of them would not be read.
    const MOST: usize = 12;

    pub(crate) fn of(names: impl Iterator<Item = impl Into<String>>) -> Known {
        let mut known = Known { first: Vec::new(), count: 0 };
        for name in names {
            known.count += 1;
            if known.first.len() < Known::MOST {
                known.first.push(name.into());
            }
        }
        known
    }
}

/// What a drive moves, and where that is.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// The body, or the drive itself where it moves no single coordinate.
    pub name: String,
    /// The coordinate; none of a drive itself.
    pub coordinate: Option<Role>,
    /// Its value, in SI, if it is known.
    pub value: Option<(f64, Dim)>,
}

/// What a joint demands of a sum of coordinates, and what others make of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Demand {
    /// `crank.angle`, or a sum such as `b.angle - a.angle`.
    pub form: String,
    /// What the joint demands, with its unit.
    pub wanted: String,
    /// What the others demand.
    pub found: String,
}

/// What speaks for a joint that was forgotten.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Forgotten {
    /// Bodies that are joined to one neighbour only.
    pub loose: Vec<String>,
    /// A joint that would hold a body, to be typed.
    pub line: Option<String>,
    /// The coordinates that it would hold.
    pub holds: Vec<String>,
}

/// What there is of coordinates, equations and drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Coordinates of all bodies.
    pub coordinates: usize,
    /// Equations of joints.
    pub joints: usize,
    /// Equations of drives.
    pub drives: usize,
    /// How many more there would have to be.
    pub missing: usize,
}

/// What stays open.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// How far points or lines are apart, in m.
    pub length: f64,
    /// By how much angles differ, in rad.
    pub angle: f64,
    /// By how much the sides of another equation differ, in SI, and its unit.
    pub other: Option<(f64, String)>,
}

/// A link that is too long for the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The others: what they are called and how long they are, in m.
    pub ways: Vec<(String, f64)>,
    /// What is too long: what it is called and how long it is, in m.
    pub span: (String, f64),
    /// No angle of a drive plays a part.
    pub is_always: bool,
}

impl Bound {
    /// How much is missing, in m.
    pub(crate) fn missing(&self) -> f64 {
        self.span.1 - self.ways.iter().map(|(_, length)| length).sum::<f64>()
    }
}
