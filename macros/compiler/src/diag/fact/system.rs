//! Facts about the mechanism as a whole.

/// The mechanism as a whole: mobility and redundancy.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // The sentence of each fact is its documentation.
pub enum SystemFact {
    NoBodies {
        name: String,
    },
    BodyIsFree {
        body: String,
        example: String,
    },
    PassiveSpin {
        bodies: Vec<String>,
        joints: [String; 2],
    },
    VelocityDepends {
        joint: String,
        row: usize,
        of: usize,
        is_drive: bool,
        is_redundant: bool,
    },
    FreedomDepends {
        freedom: String,
        of: usize,
    },
    FreedomsMissing {
        name: String,
        missing: usize,
        declared: usize,
        candidates: Vec<String>,
    },
    Massless {
        bodies: Vec<String>,
        has_any: bool,
        /// Those with a mass, but no inertia.
        without_inertia: Vec<String>,
        /// Those whose declared mass and inertia are 0.
        zero: Vec<String>,
    },
    SliceWithoutLoads {
        name: String,
    },
    ActsOnMassless {
        joint: String,
        without_mass: Vec<String>,
        without_inertia: Vec<String>,
        adds: bool,
        freedom: String,
    },
    Nonholonomic {
        joint: String,
        row: usize,
        of: usize,
        /// Why no position follows.
        obstacle: NoPosition,
    },
    /// `#[velocity]` on a joint without an equation of velocities.
    NoVelocity {
        /// Name of the joint.
        joint: String,
    },
    /// An angle of one axis against another that joints keep at a fixed angle to it.
    AngleOfTwoDirections {
        /// The joint, force or output that contains it.
        name: String,
        /// The bodies of the axes.
        bodies: [String; 2],
        /// Angle between the axes, in rad.
        apart: f64,
    },
    Repeats {
        joint: String,
        other: String,
    },
    NotOnGround {
        bodies: Vec<String>,
    },
    FreeCoordinates {
        body: String,
        coordinates: Vec<String>,
        has_place: bool,
        example: String,
        freedom: Option<String>,
    },
    DrivesMissing {
        name: String,
        count: Box<Count>,
        forgotten: Box<Forgotten>,
        candidates: Vec<String>,
        example: String,
        freedom: Option<String>,
    },
    NothingToDrive {
        drive: String,
        joints: Vec<String>,
        equations: [usize; 2],
        coordinates: Vec<String>,
        free: Vec<String>,
        neglected: Option<Box<Neglected>>,
        held_by: Option<String>,
    },
    DrivesContend {
        drives: Vec<String>,
        declared_free: Vec<String>,
        numbers: usize,
        freedoms: usize,
        joints: Vec<String>,
        coordinates: Vec<String>,
        free: Vec<String>,
        in_space: bool,
    },
    Follows {
        joint: String,
        is_drive: bool,
        rows: Vec<usize>,
        of: usize,
        others: Vec<String>,
    },
    AxesContradict {
        joint: String,
        other: String,
        bodies: [String; 2],
        /// In rad.
        angles: [f64; 2],
    },
    Askew {
        joints: Vec<String>,
        bodies: Vec<String>,
        angle: f64,
        others: Vec<String>,
    },
    TwoAxes {
        joint: String,
        other: String,
        bodies: [String; 2],
        /// In rad.
        angle: f64,
    },
    Contradicts {
        joint: String,
        others: Vec<String>,
        demand: Option<Box<Demand>>,
        off: String,
    },
    Collides {
        joint: String,
        others: Vec<String>,
        off: String,
    },
    FollowsFrom {
        joint: String,
        is_drive: bool,
        rows: usize,
        of: usize,
        others: Vec<String>,
        free: Vec<String>,
        moves: bool,
        kinds: Vec<String>,
    },
    NotRedundant {
        joint: String,
        free: Vec<String>,
    },
    CannotHold {
        joint: String,
        bodies: Vec<String>,
        length: Option<f64>,
        angle: Option<f64>,
        time: Option<f64>,
        is_redundant: bool,
    },
    TooManyEquations {
        joint: String,
        others: Vec<String>,
        equations: usize,
        coordinates: Vec<String>,
        free: Vec<String>,
        for_free: usize,
    },
}

/// A sum of coordinates for which a joint and the other joints demand different values.
#[derive(Clone, Debug, PartialEq)]
pub struct Demand {
    /// `crank.angle`, or a sum such as `b.angle - a.angle`.
    pub form: String,
    /// Value that the joint demands, with its unit.
    pub wanted: String,
    /// Value that the other joints demand.
    pub found: String,
}

/// Evidence that a joint was forgotten.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Forgotten {
    /// Bodies joined to a single neighbour.
    pub loose: Vec<String>,
    /// A joint that would hold a body, as a line to type.
    pub line: Option<String>,
    /// Coordinates that this joint would hold.
    pub holds: Vec<String>,
}

/// A point that no joint takes, beside another one of the same body that several joints take.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Neglected {
    /// The point, as `coupler.B`.
    pub point: String,
    /// The other one.
    pub taken: String,
    /// The joints that take the other one.
    pub joints: Vec<String>,
}

/// Numbers of coordinates, equations and drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Number of freedoms of all bodies, each on its own.
    pub freedoms: usize,
    /// True for six freedoms of each body, which are not its coordinates.
    pub in_space: bool,
    /// Number of equations of joints.
    pub joints: usize,
    /// Number of equations of drives and freedoms.
    pub drives: usize,
    /// Number of equations of freedoms.
    pub declared: usize,
    /// Number of equations that are missing.
    pub missing: usize,
}

/// Why no position follows from an equation of velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPosition {
    /// The factors of the velocities change.
    Factors,
    /// The right side changes.
    Side,
    /// `#[velocity]` is written before it.
    Kept,
}
