//! The code of each fact, and the page of each code.
//!
//! The first line of every error ends with its code, `[reuleaux::E0305]`. Each code has a page in the error index for users,
//! `reuleaux::errors`. The hundreds are families: 00 grammar, 01 names, 02 arguments, 03 kinds and dimensions, 04 values, 05 loops,
//! arrays and parts, 06 equations, 07 mobility, 08 redundancy, 09 assembly, 10 parameters, 11 masses and forces.
//!
//! To give a new fact its code:
//!
//! 1. Add its family and name to the line below whose page explains it, or to a new line under the next free number of its family.
//! 2. For a new line write `errors/<code>.md`: the error in one line, some sentences of mechanics, a rejected model in a `compile_fail`
//!    block, an accepted one in a plain block, and the remedy.
//! 3. `REULEAUX_GOLDEN=write cargo test -p reuleaux-compiler --test errors` writes the compiler's message under the rejected model, and
//!    checks the page.
//!
//! A fact without a line does not compile, nor does a line without its page. A number is never reused.

use super::fact::{
    ArityFact as Arity, ArrayFact as Array, AssemblyFact as Assembly, EquationFact as Equation, Fact, GrammarFact as Grammar,
    MotionFact as Motion, NameFact as Name, SystemFact as System, ValueFact as Value,
};

macro_rules! codes {
    ($($code:ident: $($family:ident::$fact:ident)+;)*) => {
        impl Fact {
            /// The code of the page that explains the fact, such as `E0305`.
            #[must_use]
            pub fn code(&self) -> &'static str {
                match self {
                    $($(Fact::$family($family::$fact { .. }))|+ => stringify!($code),)*
                    // The instance in which an error occurs does not change its code.
                    Fact::InInstance { fact, .. } | Fact::InDefinition { fact, .. } | Fact::Doubtful { fact, .. } | Fact::Noted { fact, .. } => {
                        fact.code()
                    },
                }
            }
        }

        /// All codes with their pages, in Markdown.
        pub const PAGES: &[(&str, &str)] = &[$((stringify!($code), include_str!(concat!("../../errors/", stringify!($code), ".md")))),*];
    };
}

codes! {
    // Grammar.
    E0001: Grammar::Syntax Grammar::Expected Grammar::ArgumentByEquals Grammar::Unnamed Motion::EquationWithoutBraces Motion::RateBeforeStart
        Motion::PlaceWithoutAt Motion::StartWithEquals Motion::FreedomWithoutName Motion::DriveWithoutName Grammar::OneEqualsSign
        Grammar::HashComment Grammar::CommaAtEnd Grammar::DecimalComma Grammar::OutputWithoutName Grammar::OutputWithDimension
        Grammar::TwoConditions Grammar::ComparisonAsValue Grammar::ConditionInParentheses Grammar::NumberBeforeParentheses Grammar::OutputInUnit Grammar::ArrayOfDimension
        Grammar::ComparisonOutside Grammar::ForceBeforePlace Grammar::Stray Grammar::BodyWithoutBraces Grammar::WithoutEquals Grammar::ParameterWithoutDimension Grammar::Return Grammar::Misspelt Grammar::BoundsElsewhere;
    E0002: Grammar::NotANumber;
    E0003: Grammar::TooDeep Grammar::TooLong Grammar::LongChain Grammar::PartsTooDeep;
    E0004: Grammar::Keyword;
    E0005: Grammar::UnknownAttribute;
    E0006: Grammar::TokensAfter;
    E0007: Grammar::UnknownItem;
    E0008: Grammar::UnknownBodyItem Grammar::FeatureOutside;
    E0009: Motion::InertiaOfNumbers Motion::InertiaOfVector Grammar::WithoutParentheses Value::NotTwoComponents Value::PoseAsPosition Value::NotThreeComponents;
    E0010: Grammar::DoubleStar Grammar::MethodCall Grammar::RustConstant;
    E0011: Grammar::PathOfConstraint;
    E0012: Grammar::SpaceBeforeUnit Grammar::UnitBehindParentheses Grammar::UnitRaised;
    E0013: Grammar::ExponentTooLarge;
    E0014: Grammar::OnlyAtTheTop Grammar::StartInLoop Grammar::StartOfJoint;
    E0015: Grammar::ClosingWord Grammar::AllowedWord Grammar::AttributeTwice Grammar::SecondTask;
    // Names.
    E0101: Name::UnknownName;
    E0102: Name::UnknownField Name::AngleOfBody Name::NoHeight;
    E0103: Name::UnknownFunction Name::UnknownShape;
    E0104: Name::UnknownConstraint Name::NotAConstraint Array::ComponentAsConstraint Motion::UnknownForce;
    E0105: Array::UnknownComponent;
    E0106: Name::UnknownUnit Name::UnitAlone Name::PointInBody Name::UnitInParts;
    E0107: Name::UnknownDimension;
    E0108: Name::UnknownKind;
    E0109: Name::UnknownStart;
    E0110: Name::Duplicate Name::BroughtAlong Name::DuplicateMark;
    E0111: Name::DuplicateStart;
    E0112: Name::DuplicateGround Name::DuplicateRange;
    E0113: Name::Reserved Name::Generated Array::GeneratedType Array::FieldOfInputs Grammar::NumberType;
    E0114: Name::Cycle;
    E0115: Name::Recursion Array::ComponentRecursion;
    E0116: Array::OutsideOfComponent;
    E0117: Name::OutputRead;
    // Arguments.
    E0201: Arity::MissingArguments Arity::MissingMarks;
    E0202: Arity::TooManyArguments;
    E0203: Arity::UnknownArgument Array::ParameterAsArgument;
    E0204: Arity::DuplicateArgument;
    E0205: Arity::PositionalAfterNamed;
    E0206: Arity::FunctionArity Arity::LawArity Arity::ShapeArity Value::TableArity Value::SplineArity Value::SegmentsArity;
    E0207: Grammar::OneArgument Value::FunctionNeedsArgument;
    E0208: Arity::DefaultBefore;
    // Kinds and dimensions.
    E0301: Value::NotA Value::NotAnOutput Value::NotAStart Value::AnglesForOrientation Motion::TorqueWithoutAxis Motion::TorqueWithAxis Motion::ForceWithoutDirection
        Motion::GravityWithoutDirection
        Motion::ForceAtNoPoint Motion::TorqueOnNoBody Motion::ValueForForce Motion::ValueForConstraint Motion::FreedomOfJoint
        Motion::FreedomOfOrientation Motion::FreedomOfNothing;
    E0302: Value::WrongArgument Value::CoordinateForAxis Value::WrongDefault Motion::JointWithoutValue Arity::OtherOrder Arity::JointForEnds Arity::FunctionOrder;
    E0303: Value::WrongArgumentDimension;
    E0304: Value::Unlike Value::BareGains Value::NotARate;
    E0305: Value::WrongDimension Value::NotAnEnergy Value::OfFunction Value::NotALength Motion::RateForStart Motion::StartForRate;
    E0306: Value::CannotEquate Value::CannotCompare Value::OrderOfBodies;
    E0307: Value::FunctionTakes;
    E0308: Value::VectorAndNumber;
    E0309: Value::VectorTimesVector Value::NumberByVector;
    E0310: Value::PowerOfDimension;
    // Values.
    E0401: Value::NumberOutOfRange Value::NumberTooLong Value::SplineSwings
        Value::SplineOutOfRange;
    E0402: Value::NotFinite;
    E0403: Value::DivisionByZero;
    E0404: Equation::RequirementFails Equation::RequirementFailsAtDefaults;
    E0405: Value::ZeroAxis Value::AlongItsAxis;
    E0406: Value::NotConstant;
    E0407: Value::NotFixed;
    E0408: Value::EqualityInChoice;
    E0409: Value::ListOutsideTable Value::TableNeedsList Value::TableTakesArgumentFirst Value::TableNeedsPairs Value::TableTooShort Value::SegmentsNeedList
        Value::NotASegment Value::SplineTooLong;
    E0410: Value::TableNotIncreasing;
    E0411: Value::TableNotPeriodic Value::TableEnds Value::SplineEnds Value::SegmentsEnds;
    E0412: Value::MeansSpace Value::OnlyInSpace Value::OnlyInPlane Motion::InertiaAlongInPlane;
    E0413: Value::SegmentWithoutDuration Value::SharesOfLaw;
    E0414: Value::SegmentsMissTurn;
    E0415: Value::SegmentsDoNotReturn;
    E0416: Value::SegmentsJolt;
    E0417: Value::LawFromTo Value::NotALaw;
    E0418: System::AngleOfTwoDirections;
    // Loops, arrays and parts.
    E0501: Array::WithoutIndex Array::DuplicateInLoop Array::DeclaredBefore;
    E0502: Array::ArrayWithoutIndex;
    E0503: Array::NoArray Grammar::IndexInEquations;
    E0504: Array::IndexOutOfRange Array::NegativeIndex;
    E0505: Array::MissingIndex;
    E0506: Array::NotWhole Array::RemainderOfQuantity;
    E0507: Array::NotKnownWhole;
    E0508: Array::EmptyRange;
    E0509: Array::LongRange Array::WholeTooLarge Array::TooManyItems Value::TooLarge;
    E0510: Array::UnlikeParts Array::UnlikeOutputs;
    // Equations.
    E0601: Equation::TimeInJoint Equation::TimeIn Equation::TimeInDefinition Equation::InputIn Equation::InputInJoint;
    E0602: Equation::RowOfNothing Equation::OnGround Equation::ForceOnGround Equation::EnergyOfNothing Equation::CrossProduct;
    E0603: Equation::NoEquations Equation::NoForces Equation::EmptyBundle;
    E0604: Equation::GroundStart Grammar::MassOfGround;
    E0605: Equation::NotAffine Equation::RateOfSpeed Value::RateOfVelocity System::Nonholonomic System::NoVelocity;
    E0606: Equation::EquationInForce Equation::ForceInJoint Motion::ForceForConstraint Motion::ConstraintForForce Motion::JointForDrive;
    E0607: Value::OutputWithoutRate Motion::NoJerk;
    // Mobility.
    E0701: System::NoBodies;
    E0702: System::BodyIsFree;
    E0703: System::DrivesMissing;
    E0704: System::TooManyEquations;
    E0705: System::NotOnGround;
    E0706: System::FreeCoordinates;
    E0707: System::NothingToDrive;
    E0708: System::DrivesContend;
    E0709: System::PassiveSpin;
    // Redundancy.
    E0801: System::Repeats System::Follows System::FollowsFrom System::VelocityDepends;
    E0802: System::Contradicts System::CannotHold System::Collides System::AxesContradict System::TwoAxes System::Askew;
    E0803: System::NotRedundant;
    // Assembly.
    E0901: Assembly::StaysOpen Assembly::NeverCloses;
    E0902: Assembly::HasNoValue Assembly::HasNoRate Assembly::ForceWithoutValue;
    E0903: Assembly::SingularStart;
    E0904: Assembly::AmbiguousStart;
    E0905: Assembly::MotionEnds Assembly::Crosses;
    // Parameters.
    E1001: Value::EmptyBounds Value::RangeWithoutEnd;
    E1002: Value::DefaultOutOfBounds;
    // Masses and forces.
    E1101: System::FreedomDepends System::FreedomsMissing Motion::FreedomIsHeld;
    E1102: System::Massless;
    E1103: Value::NegativeMass Value::ImpossibleInertia Value::CenterWithoutMass Value::ShapeWithoutMass;
    E1104: Value::EnergyOfVelocities;
    E1105: Motion::SliceBesideFreedom Motion::RangeBesideFreedom;
    E1106: System::ActsOnMassless;
    E1107: System::SliceWithoutLoads;
    E1108: Motion::InputBesideFreedom Motion::SliceBesideInput;
}
