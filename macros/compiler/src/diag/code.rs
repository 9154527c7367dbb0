//! The code of each fact, and the page of each code.
//!
//! A code is told at the end of a refusal's first line, `[reuleaux::E0305]`, and has a page of its own in the index that users
//! read, `reuleaux::errors`. The hundreds are families: 00 grammar, 01 names, 02 arguments, 03 kinds and dimensions, 04 values,
//! 05 loops, arrays and parts, 06 equations, 07 mobility, 08 redundancy, 09 closure, 10 parameters.
//!
//! To give a new fact its code:
//!
//! 1. Put its name into the line below whose page explains it, or into a new line under the next free number of its family.
//! 2. For a new line write `errors/<code>.md`: what is wrong in one line, some sentences of mechanics, a wrong model in a
//!    `compile_fail` block, a right one in a plain block, and what to do.
//! 3. `REULEAUX_GOLDEN=write cargo test -p reuleaux-compiler --test errors` writes under the wrong model what the compiler says
//!    of it, and checks the page.
//!
//! A fact in no line does not compile, nor does a line without its page. A number that was given once is never given to
//! something else.

use super::Fact;

macro_rules! codes {
    ($($code:ident: $($fact:ident)+;)*) => {
        impl Fact {
            /// The code of the page that explains the fact, such as `E0305`.
            #[must_use]
            pub fn code(&self) -> &'static str {
                match self {
                    $($(Fact::$fact { .. })|+ => stringify!($code),)*
                    // Where it was is no part of what is wrong.
                    Fact::InInstance { fact, .. } | Fact::InDefinition { fact, .. } => fact.code(),
                }
            }
        }

        /// Every code with its page, in Markdown.
        pub const PAGES: &[(&str, &str)] = &[$((stringify!($code), include_str!(concat!("../../errors/", stringify!($code), ".md")))),*];
    };
}

codes! {
    // Grammar.
    E0001: Syntax Expected Unnamed;
    E0002: NotANumber;
    E0003: TooDeep TooLong LongChain PartsTooDeep;
    E0004: Keyword;
    E0005: UnknownAttribute;
    E0006: TokensAfter;
    E0007: UnknownItem;
    E0008: UnknownBodyItem;
    E0009: PairWithoutParentheses NotTwoComponents;
    E0010: DoubleStar MethodCall;
    E0011: PathOfConstraint;
    E0012: SpaceBeforeUnit;
    E0013: ExponentTooLarge;
    E0014: OnlyAtTheTop StartInLoop;
    E0015: ClosingWord AllowedWord AttributeTwice;
    // Names.
    E0101: UnknownName;
    E0102: UnknownField;
    E0103: UnknownFunction;
    E0104: UnknownConstraint NotAConstraint ComponentAsConstraint;
    E0105: UnknownComponent;
    E0106: UnknownUnit UnitAlone;
    E0107: UnknownDimension;
    E0108: UnknownKind;
    E0109: UnknownStart;
    E0110: Duplicate DuplicateMark;
    E0111: DuplicateStart;
    E0112: DuplicateGround DuplicateRange;
    E0113: Reserved Generated GeneratedType NumberType;
    E0114: Cycle;
    E0115: Recursion ComponentRecursion;
    E0116: OutsideOfComponent;
    E0117: OutputRead;
    // Arguments.
    E0201: MissingArguments;
    E0202: TooManyArguments;
    E0203: UnknownArgument ParameterAsArgument;
    E0204: DuplicateArgument;
    E0205: PositionalAfterNamed;
    E0206: FunctionArity TableArity;
    E0207: OneArgument FunctionNeedsArgument;
    E0208: DefaultBefore;
    // Kinds and dimensions.
    E0301: NotA NotAnOutput;
    E0302: WrongArgument WrongDefault;
    E0303: WrongArgumentDimension;
    E0304: Unlike;
    E0305: WrongDimension NotALength;
    E0306: CannotEquate CannotCompare OrderOfBodies;
    E0307: FunctionTakes;
    E0308: VectorAndNumber;
    E0309: VectorTimesVector NumberByVector;
    E0310: PowerOfDimension;
    // Values.
    E0401: NumberOutOfRange NumberTooLong;
    E0402: NotFinite;
    E0403: DivisionByZero;
    E0404: RequirementFails RequirementFailsAtDefaults;
    E0405: ZeroAxis;
    E0406: NotConstant;
    E0407: NotFixed;
    E0408: EqualityInChoice;
    E0409: ListOutsideTable TableNeedsList TableNeedsPairs TableTooShort;
    E0410: TableNotIncreasing;
    E0411: TableNotPeriodic TableEnds;
    // Loops, arrays and parts.
    E0501: WithoutIndex DuplicateInLoop;
    E0502: ArrayWithoutIndex;
    E0503: NoArray IndexInEquations;
    E0504: IndexOutOfRange NegativeIndex;
    E0505: MissingIndex;
    E0506: NotWhole;
    E0507: NotKnownWhole;
    E0508: EmptyRange;
    E0509: LongRange WholeTooLarge TooManyItems TooLarge;
    E0510: UnlikeParts UnlikeOutputs;
    // Equations.
    E0601: TimeInJoint TimeIn TimeInDefinition;
    E0602: RowOfNothing OnGround;
    E0603: NoEquations EmptyBundle;
    E0604: GroundStart;
    // Mobility.
    E0701: NoBodies;
    E0702: BodyIsFree;
    E0703: DrivesMissing;
    E0704: TooManyEquations;
    E0705: NotOnGround;
    E0706: FreeCoordinates;
    E0707: NothingToDrive;
    E0708: DrivesContend;
    // Redundancy.
    E0801: Repeats Follows FollowsFrom;
    E0802: Contradicts CannotHold Collides;
    E0803: NotRedundant;
    // Closure.
    E0901: StaysOpen NeverCloses;
    E0902: HasNoValue HasNoRate;
    E0903: SingularStart;
    E0904: AmbiguousStart;
    E0905: MotionEnds Crosses;
    // Parameters.
    E1001: EmptyBounds RangeWithoutEnd;
    E1002: DefaultOutOfBounds;
}
