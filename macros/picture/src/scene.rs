//! The input of a drawing: a mechanism in one configuration. Lengths are in m, angles in rad.

use core::f64::consts::TAU;

/// Number of samples of a function of one revolution.
pub(crate) const STEPS: usize = 90;

/// The name of ground.
pub const GROUND: &str = "ground";

/// A mechanism in one configuration.
///
/// Bodies are referred to by their names, ground by [`GROUND`]; they may be added in any order. Mistakes in a scene are reported when it
/// is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub(crate) name: String,
    pub(crate) bodies: Vec<Body>,
    pub(crate) points: Vec<Fixed>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) outputs: Vec<(String, Fixed)>,
    /// Shapes of bodies: corners in the frame of the body.
    pub(crate) outlines: Vec<(String, Vec<Vector>)>,
    /// Vector towards the eye, if one was asked for.
    pub(crate) toward: Option<[f64; 3]>,
}

/// A body with its pose.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) pose: Pose,
}

/// Position and orientation of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub(crate) position: Vector,
    pub(crate) turn: Turn,
}

/// Orientation of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turn {
    /// Angle from x towards y (rad).
    Plane(f64),
    /// Rotation matrix by rows, from the frame to ground.
    Space([[f64; 3]; 3]),
}

impl Pose {
    /// A frame with its origin at (`x`, `y`), rotated by `angle` from x towards y.
    #[must_use]
    pub fn plane(x: f64, y: f64, angle: f64) -> Pose {
        Pose { position: Vector::from([x, y]), turn: Turn::Plane(angle) }
    }

    /// A frame in space with its origin at `position`; `rotation` is the matrix, by rows, that transforms components in the frame to
    /// components in ground.
    #[must_use]
    pub fn space(position: [f64; 3], rotation: [[f64; 3]; 3]) -> Pose {
        Pose { position: Vector::from(position), turn: Turn::Space(rotation) }
    }

    /// Angle in the plane.
    pub(crate) fn angle(&self) -> f64 {
        if let Turn::Plane(angle) = self.turn { angle } else { f64::NAN }
    }
}

/// Components of a point or a vector in a frame: two in the plane, three in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// Third component, in space only.
    pub(crate) z: Option<f64>,
}

impl From<[f64; 2]> for Vector {
    fn from([x, y]: [f64; 2]) -> Vector {
        Vector { x, y, z: None }
    }
}

impl From<[f64; 3]> for Vector {
    fn from([x, y, z]: [f64; 3]) -> Vector {
        Vector { x, y, z: Some(z) }
    }
}

/// A point or a vector fixed in a body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fixed {
    pub(crate) body: String,
    pub(crate) at: Vector,
}

/// A joint or a drive: its kind and its arguments.
///
/// Kinds and arguments have the names of the constraints in `reuleaux::library`: a `revolute` joint has points `P` and `Q`. A kind
/// without a symbol is drawn as a dashed line between its points.
///
/// Springs and dampers between points `P` and `Q` are added in the same way, by the kinds `spring`, `damper`, `spring_damper`,
/// `constant_force`, `gas_spring`, `nonlinear_spring` and `stop`.
///
/// Gears and drives in space take as an argument a joint of kind `angle` (axes `a` and `b`) or `displacement` (points `P` and `Q`, axis
/// `a`).
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub(crate) name: String,
    pub(crate) kind: String,
    pub(crate) is_drive: bool,
    pub(crate) rate: f64,
    pub(crate) bodies: Vec<String>,
    pub(crate) arguments: Vec<(String, Argument)>,
}

/// An argument of a joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Argument {
    Point(Fixed),
    Axis(Fixed),
    Body(String),
    Length(f64),
    Number(f64),
    /// Samples over one revolution, at equal steps.
    Function(Vec<f64>),
    Joint(Joint),
}

impl Scene {
    /// An empty scene with the name of the mechanism.
    #[must_use]
    pub fn new(name: &str) -> Scene {
        Scene {
            name: name.to_owned(),
            bodies: Vec::new(),
            points: Vec::new(),
            joints: Vec::new(),
            outputs: Vec::new(),
            outlines: Vec::new(),
            toward: None,
        }
    }

    /// Name of the mechanism.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Adds a body.
    pub fn body(&mut self, name: &str, pose: Pose) {
        self.bodies.push(Body { name: name.to_owned(), pose });
    }

    /// Adds a point of a body; the drawing of the body extends to it.
    pub fn point(&mut self, body: &str, at: impl Into<Vector>) {
        self.points.push(Fixed::new(body, at));
    }

    /// Adds a joint and returns it, so that its arguments can be set.
    pub fn joint(&mut self, name: &str, kind: &str) -> &mut Joint {
        self.add(Joint::new(name, kind))
    }

    /// Adds a drive; `rate` is the rate of its law in SI, and its sign gives the direction of the arrow.
    pub fn drive(&mut self, name: &str, kind: &str, rate: f64) -> &mut Joint {
        // A law without a derivative has an unknown rate.
        self.add(Joint { is_drive: true, rate: if rate.is_finite() { rate } else { 0.0 }, ..Joint::new(name, kind) })
    }

    /// Adds a point of a body that is marked as an output.
    pub fn output(&mut self, name: &str, body: &str, at: impl Into<Vector>) {
        self.outputs.push((name.to_owned(), Fixed::new(body, at)));
    }

    /// Gives a body a shape: the corners of a polygon, in its frame (m). A body may have several, ground as well.
    ///
    /// The shape is drawn below links and hinges, in the colour of the body: a cam, a bucket, a Geneva wheel.
    pub fn outline(&mut self, body: &str, corners: impl IntoIterator<Item = impl Into<Vector>>) {
        self.outlines.push((body.to_owned(), corners.into_iter().map(Into::into).collect()));
    }

    /// Draws a mechanism in space from a direction of your own: a vector from the mechanism towards the eye, in ground. `[0.0, -1.0, 0.0]` is the front
    /// view, `[0.0, 0.0, 1.0]` the view from above, `[1.0, -1.0, 1.0]` is isometric. Its length does not matter.
    ///
    /// z points upwards; in the view from above y does, and x to the right. Without this call a direction is chosen from which joints overlap as
    /// little as possible. In a motion, the first scene with a direction decides for all frames. A mechanism in the plane is not affected.
    ///
    /// A vector that is zero or not finite gives [`Undrawable::Unseen`](crate::Undrawable::Unseen) when the scene is drawn.
    pub fn seen_from(&mut self, direction: [f64; 3]) {
        self.toward = Some(direction);
    }

    fn add(&mut self, joint: Joint) -> &mut Joint {
        let index = self.joints.len();
        self.joints.push(joint);
        &mut self.joints[index]
    }

    /// True if any vector has three components. Vectors of two components then lie in the plane z = 0.
    pub(crate) fn is_in_space(&self) -> bool {
        fn is_spatial(arguments: &[(String, Argument)]) -> bool {
            arguments.iter().any(|(_, argument)| match argument {
                Argument::Point(fixed) | Argument::Axis(fixed) => fixed.at.z.is_some(),
                Argument::Joint(joint) => is_spatial(&joint.arguments),
                _ => false,
            })
        }
        let points = self.points.iter().chain(self.outputs.iter().map(|(_, at)| at));
        self.bodies.iter().any(|body| body.pose.position.z.is_some())
            || points.clone().any(|fixed| fixed.at.z.is_some())
            || self.joints.iter().any(|joint| is_spatial(&joint.arguments))
    }
}

impl Fixed {
    fn new(body: &str, at: impl Into<Vector>) -> Fixed {
        Fixed { body: body.to_owned(), at: at.into() }
    }
}

impl Joint {
    fn new(name: &str, kind: &str) -> Joint {
        Joint { name: name.to_owned(), kind: kind.to_owned(), is_drive: false, rate: 0.0, bodies: Vec::new(), arguments: Vec::new() }
    }

    fn with(&mut self, name: &str, argument: Argument) -> &mut Joint {
        self.arguments.push((name.to_owned(), argument));
        self
    }

    /// Bodies on which the equations depend, besides those of the arguments.
    pub fn of(&mut self, bodies: &[&str]) -> &mut Joint {
        self.bodies.extend(bodies.iter().map(|body| (*body).to_owned()));
        self
    }

    /// Adds a point as an argument.
    pub fn point(&mut self, name: &str, body: &str, at: impl Into<Vector>) -> &mut Joint {
        self.with(name, Argument::Point(Fixed::new(body, at)))
    }

    /// Adds an axis of any length as an argument.
    pub fn axis(&mut self, name: &str, body: &str, along: impl Into<Vector>) -> &mut Joint {
        self.with(name, Argument::Axis(Fixed::new(body, along)))
    }

    /// Adds a body as an argument.
    pub fn body(&mut self, name: &str, body: &str) -> &mut Joint {
        self.with(name, Argument::Body(body.to_owned()))
    }

    /// Adds a length as an argument.
    pub fn length(&mut self, name: &str, value: f64) -> &mut Joint {
        self.with(name, Argument::Length(value))
    }

    /// Adds any other number, such as a number of teeth, as an argument.
    pub fn number(&mut self, name: &str, value: f64) -> &mut Joint {
        self.with(name, Argument::Number(value))
    }

    /// Adds a function of an angle, such as the profile of a cam, as an argument.
    pub fn function(&mut self, name: &str, mut of: impl FnMut(f64) -> f64) -> &mut Joint {
        let values = (0..STEPS).map(|step| of(step as f64 * TAU / STEPS as f64)).collect();
        self.with(name, Argument::Function(values))
    }

    /// Adds another joint as an argument; `made` sets the arguments of that joint.
    pub fn joint(&mut self, name: &str, kind: &str, made: impl FnOnce(&mut Joint)) -> &mut Joint {
        let mut joint = Joint::new(name, kind);
        made(&mut joint);
        self.with(name, Argument::Joint(joint))
    }
}
