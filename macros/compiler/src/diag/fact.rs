//! Errors in a declaration: facts with their numbers, in families. `message.rs` turns them into sentences, in one file per family.

mod grammar;
mod motion;
mod system;

pub use grammar::GrammarFact;
pub use motion::{JerkObstacle, JointValue, MotionFact, Word};
pub use system::{Count, Demand, Forgotten, Neglected, NoPosition, SystemFact};

use super::{Doubt, Home, Kind, Wanted};
use crate::quantity::{Ambient, Dim, Role};

/// An error in a declaration.
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
    Motion(MotionFact),
    InInstance { place: String, fact: Box<Fact> },
    Doubtful { fact: Box<Fact>, doubt: Box<Doubt> },
    Noted { fact: Box<Fact>, note: Note },
    InDefinition { definition: String, quantities: Vec<(String, Dim)>, fact: Box<Fact> },
}

/// The likely cause of a wrong dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// A declared name stands where a unit was meant.
    DeclaredUnit {
        /// The name.
        name: String,
        /// The number with its unit.
        instead: String,
    },
    /// Another expression was meant.
    Instead {
        /// The expression.
        written: String,
    },
    /// A rate is multiplied by the time where a rate is wanted.
    WithoutTime {
        /// The rate.
        written: String,
    },
    /// A factor lacks its unit.
    BareFactor {
        /// The number as written.
        number: String,
        /// The number with a unit.
        instead: String,
    },
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
    Grammar: GrammarFact, Array: ArrayFact, Name: NameFact, Arity: ArityFact, Value: ValueFact, Equation: EquationFact, System: SystemFact, Assembly: AssemblyFact,
    Motion: MotionFact
}

impl Fact {
    /// The array whose missing element is used.
    pub(super) fn element_missing(&self) -> Option<&str> {
        match self {
            Fact::InInstance { fact, .. } | Fact::Noted { fact, .. } => fact.element_missing(),
            Fact::Array(ArrayFact::IndexOutOfRange { name, .. }) => Some(name),
            _ => None,
        }
    }

    /// True for the kind or the dimension of an argument.
    pub(crate) fn is_about_an_argument(&self) -> bool {
        match self {
            Fact::InInstance { fact, .. } | Fact::Noted { fact, .. } => fact.is_about_an_argument(),
            fact => matches!(fact, Fact::Value(ValueFact::WrongArgument { .. } | ValueFact::WrongArgumentDimension { .. })),
        }
    }
}

/// Loops, arrays, components and parts.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ArrayFact {
    WithoutIndex { name: String, variable: String },
    DuplicateInLoop { name: String, variable: String },
    DeclaredBefore { name: String, next: String },
    ArrayWithoutIndex { name: String, index: String },
    NoArray { found: Kind, is_member: bool },
    IndexOutOfRange { name: String, index: i64, ends: Option<(usize, usize)>, known: Known },
    NegativeIndex { index: i64 },
    MissingIndex { what: &'static str, missing: String, known: String, is_alone: bool },
    NotWhole { found: String },
    RemainderOfQuantity,
    NotKnownWhole,
    EmptyRange { from: i64, to: i64, is_inclusive: bool },
    LongRange { rounds: i128, limit: usize },
    TooManyItems { limit: usize },
    WholeTooLarge { found: String },
    UnknownComponent { name: String, near: Option<String>, is_force: Option<bool> },
    ComponentAsConstraint { name: String },
    ComponentRecursion { name: String },
    ParameterAsArgument { component: String, name: String, part: String },
    OutsideOfComponent { name: String, what: &'static str },
    UnlikeParts { name: String, component: String },
    UnlikeOutputs { name: String },
    GeneratedType { name: String },
    FieldOfInputs { name: String },
}

/// Names: unknown, taken, or in a cycle.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum NameFact {
    UnknownName { name: String, near: Option<String>, is_of_definition: bool },
    OutputRead { name: String },
    PointInBody { name: String },
    UnitAlone { name: String },
    UnitInParts { written: String, instead: String },
    UnknownField { owner: String, name: String, near: Option<String>, known: Known },
    AngleOfBody { body: String, joint: Option<String> },
    NoHeight { owner: String, is_axis: bool },
    UnknownFunction { name: String, near: Option<String>, is_force: Option<bool> },
    UnknownShape { name: String, near: Option<String>, known: Vec<&'static str> },
    UnknownConstraint { name: String, near: Option<String>, is_force: bool, home: Option<Home>, known: Known },
    UnknownUnit { number: String, name: String, near: Option<String> },
    UnknownDimension { name: String, near: Option<String> },
    UnknownStart { name: String, value: String, body: String, near: Option<String>, in_space: bool },
    NotAConstraint { name: String },
    UnknownKind { name: String, near: Option<String> },
    Duplicate { name: String, first: &'static str },
    BroughtAlong { name: String, by: String },
    DuplicateMark { name: String, body: String },
    DuplicateStart { name: String, body: String },
    DuplicateGround,
    DuplicateRange,
    Reserved { name: String },
    Generated { name: String },
    Cycle { name: String, through: Vec<String> },
    Recursion { name: String },
}

/// What the user may mean by too few arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeantFor {
    /// Nothing else.
    Nothing,
    /// A force about a hinge, which is named.
    Hinge,
    /// Something between the bodies of a joint, which is named.
    Joint,
    /// A force with given components: its clause, `at rod.P: (0N, 5N)`.
    Components(String),
    /// The call with arguments between those that are there.
    Complete(String),
}

/// Arguments: too many, too few, in the wrong order.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ArityFact {
    TooManyArguments { definition: String, signature: String, takes: [usize; 2], found: usize, decimals: Option<String> },
    MissingArguments { definition: String, signature: String, takes: [usize; 2], found: usize, missing: Vec<String>, meant: MeantFor },
    MissingMarks { definition: String, signature: String, missing: Vec<String>, instead: String, without: Vec<String>, are_points: bool },
    UnknownArgument { definition: String, name: String, signature: String, near: Option<String> },
    DuplicateArgument { name: String, is_also_in_order: bool },
    PositionalAfterNamed { next: Option<String> },
    FunctionArity { name: String, wanted: usize, found: usize },
    LawArity { name: String, found: usize },
    ShapeArity { name: String, call: &'static str, wanted: usize, found: usize },
    JointForEnds { definition: String, signature: String, ends: &'static str, instead: String },
    OtherOrder { name: String, instead: String, signature: String },
    FunctionOrder { name: String, call: String },
    DefaultBefore { name: String },
}

/// Kinds, dimensions and values.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum ValueFact {
    RangeWithoutEnd,
    NotA { wanted: Wanted, found: Kind, ambient: Ambient },
    WrongArgument { parameter: String, definition: String, wanted: Wanted, found: Kind, ambient: Ambient, instead: Option<String> },
    CoordinateForAxis { parameter: String, definition: String, body: String, name: String },
    WrongArgumentDimension { parameter: String, definition: String, wanted: Dim, found: Dim },
    AnglesForOrientation { instead: String },
    WrongDefault { wanted: Wanted, found: Kind },
    WrongDimension { wanted: Dim, found: Dim },
    OfFunction { wanted: Dim, found: Dim },
    NotARate { written: String, found: Dim, instead: String },
    PoseAsPosition { written: String },
    BareGains { action: &'static str, one: Dim, two: Dim, numbers: [String; 2] },
    Unlike { action: &'static str, one: Dim, two: Dim },
    NotALength { found: Dim, instead: Option<String> },
    FunctionTakes { wanted: Dim, found: Dim },
    OrderOfBodies,
    CannotCompare { one: Kind, two: Kind },
    CannotEquate { one: Kind, two: Kind, ambient: Ambient },
    NotTwoComponents { found: usize, meant: Option<String> },
    NotThreeComponents { found: usize, meant: Option<String> },
    MeansSpace { name: String, is_component: bool },
    OnlyInSpace { word: String, typed: Option<Typed> },
    OnlyInPlane { word: String, typed: Option<Typed> },
    AlongItsAxis { name: String, is_along_x: bool },
    VectorAndNumber { in_space: bool },
    VectorTimesVector,
    NumberByVector,
    PowerOfDimension { base: Dim },
    NotAnOutput { found: Kind },
    NumberTooLong { number: String, limit: usize },
    NumberOutOfRange { number: String },
    NotFinite { place: &'static str },
    TooLarge { limit: usize, in_function: bool },
    DivisionByZero,
    EqualityInChoice,
    ListOutsideTable,
    TableArity { found: usize },
    TableNeedsList,
    TableTakesArgumentFirst { word: &'static str, instead: String },
    TableNeedsPairs,
    TableNotIncreasing { word: &'static str, before: f64, found: f64, dim: Dim },
    TableTooShort { word: &'static str, found: usize },
    TableNotPeriodic { word: &'static str, first: f64, last: f64, dim: Dim },
    TableEnds { found: String },
    SplineArity { found: usize },
    SplineTooLong { found: usize, limit: usize },
    SplineEnds,
    SplineSwings,
    SplineOutOfRange,
    SharesOfLaw { found: [f64; 2] },
    SegmentsArity { found: usize },
    SegmentsNeedList,
    SegmentsEnds,
    NotASegment,
    NotALaw,
    SegmentWithoutDuration { found: f64, dim: Dim },
    SegmentsMissTurn { found: f64 },
    SegmentsDoNotReturn { off: f64, dim: Dim },
    SegmentsJolt { at: f64, velocities: [f64; 2], laws: [Option<String>; 2], along: Dim, dim: Dim },
    LawFromTo { name: String, from: f64, to: f64 },
    NotConstant { place: &'static str, help: &'static str },
    EmptyBounds { bounds: String, is_point: bool },
    DefaultOutOfBounds { value: String, bounds: String },
    NotFixed { place: &'static str },
    NotAStart { written: String, body: Option<String>, ambient: Ambient },
    FunctionNeedsArgument,
    RateOfVelocity,
    OutputWithoutRate,
    EnergyOfVelocities,
    NotAnEnergy { found: Dim },
    NegativeMass { what: &'static str, body: String, value: f64, dim: Dim },
    ImpossibleInertia { body: String, by_products: bool },
    CenterWithoutMass { body: String },
    ShapeWithoutMass { name: String },
    ZeroAxis { name: String, in_space: bool },
}

/// Joints, drives and definitions, each on its own.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum EquationFact {
    TimeIn { place: &'static str },
    InputIn { place: &'static str, input: String },
    InputInJoint { joint: String, input: String },
    TimeInDefinition,
    TimeInJoint { joint: String, has_places: bool },
    RequirementFails { why: String, instead: Option<String> },
    RequirementFailsAtDefaults { why: String, value: f64 },
    RowOfNothing { joint: String, row: usize, of: usize, at_defaults: bool },
    EquationInForce,
    ForceInJoint,
    RateOfSpeed,
    NotAffine { joint: String, row: usize, of: usize },
    CrossProduct { rows: Option<String>, parallel: Option<String> },
    OnGround { joint: String, kind: String },
    ForceOnGround { force: String, ambient: Ambient },
    EnergyOfNothing { is_of_force: bool },
    NoEquations { name: String },
    NoForces { name: String, body: Option<String>, ambient: Ambient },
    EmptyBundle { name: String },
    GroundStart,
}

/// The assembly at the declared defaults, and the motion from there.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum AssemblyFact {
    StaysOpen {
        joint: String,
        gap: Box<Gap>,
        others: Vec<String>,
        drives: Vec<String>,
        starts: Vec<String>,
        bound: Option<Box<Bound>>,
    },
    NeverCloses {
        joints: Vec<String>,
        drives: Vec<String>,
        starts: Vec<String>,
        bound: Option<Box<Bound>>,
    },
    ForceWithoutValue {
        force: String,
    },
    HasNoRate {
        joint: String,
        row: usize,
        of: usize,
    },
    HasNoValue {
        joint: String,
        row: usize,
        of: usize,
        drives: Vec<String>,
        has_none_anywhere: bool,
        kind: String,
    },
    SingularStart {
        neglected: Option<Box<Neglected>>,
        bodies: Vec<String>,
        in_line: bool,
        drives: Vec<String>,
        has_others: bool,
    },
    MotionEnds {
        joint: String,
        driven: Vec<Driven>,
        time: f64,
        in_line: Vec<String>,
        until: f64,
        declared: Option<[f64; 2]>,
    },
    Crosses {
        driven: Vec<Driven>,
        time: f64,
    },
    AmbiguousStart {
        body: String,
        owner: String,
        coordinate: Role,
        values: [f64; 2],
        place: Vec<f64>,
        turn: Option<String>,
        is_declared: bool,
    },
}

/// A name that is not known, beside one that is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typed {
    /// `constraint` or `function`.
    pub sort: &'static str,
    /// The name as it was typed.
    pub name: String,
}

/// Known names: the first few, and how many there are in all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The first few names.
    pub first: Vec<String>,
    /// Number of all names.
    pub count: usize,
}

impl Known {
    /// Largest number of names in a message.
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

/// A driven coordinate with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// Name of the body, or of the drive if it moves no single coordinate.
    pub name: String,
    /// Coordinate; `None` if the name is that of the drive.
    pub coordinate: Option<Role>,
    /// Value of the coordinate in SI, if it is known.
    pub value: Option<(f64, Dim)>,
}

/// A gap that remains in the assembly.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// Distance between points or lines, in m.
    pub length: f64,
    /// Difference of angles, in rad.
    pub angle: f64,
    /// Difference between the sides of another equation, in SI, with its unit.
    pub other: Option<(f64, String)>,
}

/// A link that is too long for the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The other links, with their lengths in m.
    pub ways: Vec<(String, f64)>,
    /// The link that is too long, with its length in m.
    pub span: (String, f64),
    /// True if the gap does not depend on the angle of a drive.
    pub is_always: bool,
}

impl Bound {
    /// Missing length, in m.
    pub(crate) fn missing(&self) -> f64 {
        self.span.1 - self.ways.iter().map(|(_, length)| length).sum::<f64>()
    }
}

impl ValueFact {
    /// The word exists in the other ambient, in space for a mechanism in the plane; `typed` is what was typed for it.
    pub(crate) fn only_elsewhere(word: String, typed: Option<Typed>, ambient: Ambient) -> ValueFact {
        match ambient {
            Ambient::Plane => ValueFact::OnlyInSpace { word, typed },
            Ambient::Space => ValueFact::OnlyInPlane { word, typed },
        }
    }
}
