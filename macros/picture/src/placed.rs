//! The mechanism in one configuration, with every point in ground coordinates (m, y upwards).

use crate::plane::{Place, place};
use crate::scene::{Argument, Fixed, GROUND, Joint, Scene, Vector};
use crate::undrawable::Undrawable;
use std::collections::BTreeMap;

/// Scenes with more bodies are not drawn.
const MOST_BODIES: usize = 200;

/// Scenes with more joints and drives, or with more points, are not drawn: the layout compares all pairs of places.
const MOST_PLACES: usize = 1000;

/// Largest coordinate (m) that is accepted, so that squares of distances stay finite; other numbers beyond it count as unknown.
pub(crate) const FARTHEST: f64 = 1e100;

/// A scene with all points in ground coordinates.
#[derive(Clone, Debug)]
pub(crate) struct PlacedScene {
    pub(crate) bodies: Vec<Figure>,
    pub(crate) joints: Vec<Sign>,
    /// Outputs that are points of bodies: name, body, position.
    pub(crate) outputs: Vec<(String, Option<usize>, Place)>,
    /// Shapes of bodies: corners in the frame of the body.
    pub(crate) outlines: Vec<(Option<usize>, Vec<Place>)>,
}

/// A body.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    pub(crate) name: String,
    pub(crate) origin: Place,
    /// In rad.
    pub(crate) angle: f64,
    /// Declared points, and points at which joints act.
    pub(crate) points: Vec<Place>,
}

/// A joint or a drive.
#[derive(Clone, Debug)]
pub(crate) struct Sign {
    pub(crate) name: String,
    pub(crate) kind: String,
    pub(crate) is_drive: bool,
    pub(crate) arguments: Vec<(String, PlacedArgument)>,
    /// Bodies whose coordinates appear in the equations.
    pub(crate) bodies: Vec<usize>,
    /// Rate of the drive's law, in SI.
    pub(crate) rate: f64,
}

/// An argument in ground coordinates; `None` is ground.
#[derive(Clone, Debug)]
pub(crate) enum PlacedArgument {
    Point(Option<usize>, Place),
    /// A unit vector.
    Axis(Option<usize>, Place),
    Body(Option<usize>),
    /// A number in SI, and whether it is a length.
    Number(f64, bool),
    /// Samples over one revolution, at equal steps.
    Function(Vec<f64>),
    Joint(Vec<(String, PlacedArgument)>),
}

impl Sign {
    /// Body and position of an argument that is a point.
    pub(crate) fn point(&self, name: &str) -> Option<(Option<usize>, Place)> {
        point(&self.arguments, name)
    }

    /// Body and direction of an argument that is an axis.
    pub(crate) fn axis(&self, name: &str) -> Option<(Option<usize>, Place)> {
        axis(&self.arguments, name)
    }

    /// An argument that is a body.
    pub(crate) fn body(&self, name: &str) -> Option<Option<usize>> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            PlacedArgument::Body(body) if known == name => Some(*body),
            _ => None,
        })
    }

    /// An argument that is a number, and whether it is a length.
    pub(crate) fn number(&self, name: &str) -> Option<(f64, bool)> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            PlacedArgument::Number(value, is_length) if known == name && value.abs() <= FARTHEST => Some((*value, *is_length)),
            _ => None,
        })
    }

    /// Samples of an argument that is a function, if all are known.
    pub(crate) fn function(&self, name: &str) -> Option<&[f64]> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            PlacedArgument::Function(values) if known == name && values.iter().all(|value| value.abs() <= FARTHEST) => {
                Some(values.as_slice())
            }
            _ => None,
        })
    }

    /// All arguments that are points.
    pub(crate) fn points(&self) -> impl Iterator<Item = (Option<usize>, Place)> {
        self.arguments.iter().filter_map(|(_, seen)| if let PlacedArgument::Point(body, at) = seen { Some((*body, *at)) } else { None })
    }
}

pub(crate) fn point(arguments: &[(String, PlacedArgument)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        PlacedArgument::Point(body, at) if known == name => Some((*body, *at)),
        _ => None,
    })
}

pub(crate) fn axis(arguments: &[(String, PlacedArgument)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        PlacedArgument::Axis(body, along) if known == name => Some((*body, *along)),
        _ => None,
    })
}

/// Checks that the scene is small enough for a legible picture.
pub(crate) fn has_a_size_to_draw(scene: &Scene) -> Result<(), Undrawable> {
    let (bodies, joints, points) = (scene.bodies.len(), scene.joints.len(), scene.points.len());
    match () {
        () if bodies > MOST_BODIES => Err(Undrawable::Bodies(bodies)),
        () if joints > MOST_PLACES => Err(Undrawable::Joints(joints)),
        () if points > MOST_PLACES => Err(Undrawable::Points(points)),
        () => Ok(()),
    }
}

impl PlacedScene {
    /// Transforms all points to ground coordinates.
    pub(crate) fn of(scene: &Scene) -> Result<PlacedScene, Undrawable> {
        has_a_size_to_draw(scene)?;
        let frames = Frames::of(scene);
        let mut bodies = frames.bodies.clone();
        let declared = scene.points.iter().map(|at| frames.point(at)).collect::<Result<Vec<_>, _>>()?;
        let joints = scene.joints.iter().map(|joint| frames.joint(joint)).collect::<Result<Vec<_>, _>>()?;
        for (body, at) in declared.into_iter().chain(joints.iter().flat_map(Sign::points)) {
            if let Some(body) = body {
                bodies[body].points.push(at);
            }
        }
        let output = |(name, at): &(String, Fixed)| frames.point(at).map(|(body, at)| (name.clone(), body, at));
        let outputs = scene.outputs.iter().map(output).collect::<Result<Vec<_>, _>>()?;
        let outline = |(body, corners): &(String, Vec<Vector>)| {
            frames.body(body).map(|body| (body, corners.iter().map(|at| place(at.x, at.y)).collect()))
        };
        let outlines = scene.outlines.iter().map(outline).collect::<Result<Vec<_>, _>>()?;
        let scene = PlacedScene { bodies, joints, outputs, outlines };
        let is_somewhere = |at: Place| at.x.abs() <= FARTHEST && at.y.abs() <= FARTHEST;
        if scene.places().next().is_none() {
            return Err(Undrawable::Empty);
        }
        let are_turned = scene.outlines.iter().flat_map(|(_, corners)| corners).all(|at| is_somewhere(*at))
            && scene.bodies.iter().all(|body| body.angle.is_finite());
        if are_turned && scene.places().all(is_somewhere) { Ok(scene) } else { Err(Undrawable::Nowhere) }
    }

    /// Length of the longest body (m); 1 if no body has a length.
    pub(crate) fn size(&self) -> f64 {
        let lengths = self.bodies.iter().filter_map(Figure::length);
        let size = lengths.fold(0.0, f64::max);
        if size > 0.0 { size } else { 1.0 }
    }

    /// Positions of all bodies, joints and outputs.
    pub(crate) fn places(&self) -> impl Iterator<Item = Place> {
        let of_bodies = self.bodies.iter().flat_map(|body| if body.points.is_empty() { vec![body.origin] } else { body.points.clone() });
        of_bodies
            .chain(self.joints.iter().flat_map(|joint| joint.points().map(|(_, at)| at)))
            .chain(self.outputs.iter().map(|output| output.2))
            .chain(self.outlines.iter().flat_map(|(body, corners)| corners.iter().map(|at| self.in_ground(*body, *at))))
    }

    /// True if a hinge joins two bodies.
    pub(crate) fn is_hinged(&self, one: Option<usize>, two: Option<usize>) -> bool {
        let hinges = self.joints.iter().filter(|joint| joint.kind == "revolute" && one != two);
        let mut ends = hinges.filter_map(|joint| Some([joint.point("P")?.0, joint.point("Q")?.0]));
        ends.any(|ends| ends == [one, two] || ends == [two, one])
    }

    /// Position in ground of a point of a body.
    fn in_ground(&self, body: Option<usize>, at: Place) -> Place {
        body.and_then(|body| self.bodies.get(body)).map_or(at, |body| body.origin + at.turned(body.angle))
    }

    /// Centre of rotation of a body: its hinge on `carrier`, on ground, or on any body; otherwise the origin of its frame.
    pub(crate) fn centre(&self, body: Option<usize>, carrier: Option<usize>) -> Place {
        let hinges =
            self.joints.iter().filter(|joint| joint.kind == "revolute").filter_map(|joint| Some((joint.point("P")?, joint.point("Q")?)));
        let own: Vec<(Option<usize>, Place)> = hinges
            .filter_map(|(p, q)| {
                if p.0 == body {
                    Some((q.0, p.1))
                } else if q.0 == body {
                    Some((p.0, q.1))
                } else {
                    None
                }
            })
            .collect();
        let on = |other: Option<usize>| own.iter().find(|(known, _)| *known == other);
        let found = on(carrier).or_else(|| on(None)).or_else(|| own.first());
        found.map(|(_, at)| *at).or_else(|| body.and_then(|body| self.bodies.get(body)).map(|body| body.origin)).unwrap_or_default()
    }

    /// `crank`, or `ground`.
    pub(crate) fn name(&self, body: Option<usize>) -> &str {
        body.and_then(|body| self.bodies.get(body)).map_or("ground", |body| &body.name)
    }
}

impl Figure {
    /// Length of a body (m), if it has more than one point.
    pub(crate) fn length(&self) -> Option<f64> {
        crate::plane::farthest(&self.points).map(|(one, two)| (two - one).norm())
    }
}

/// The frames of all bodies.
struct Frames<'a> {
    bodies: Vec<Figure>,
    numbers: BTreeMap<&'a str, usize>,
}

impl Frames<'_> {
    /// Frames of the bodies, still without points.
    fn of(scene: &Scene) -> Frames<'_> {
        let figure = |body: &crate::scene::Body| {
            let origin = place(body.pose.position.x, body.pose.position.y);
            Figure { name: body.name.clone(), origin, angle: body.pose.angle(), points: Vec::new() }
        };
        // If two bodies share a name, the first is used.
        let numbers = scene.bodies.iter().enumerate().rev().map(|(number, body)| (body.name.as_str(), number)).collect();
        Frames { bodies: scene.bodies.iter().map(figure).collect(), numbers }
    }

    fn body(&self, name: &str) -> Result<Option<usize>, Undrawable> {
        match self.numbers.get(name) {
            Some(number) => Ok(Some(*number)),
            None if name == GROUND => Ok(None),
            None => Err(Undrawable::UnknownBody(name.to_owned())),
        }
    }

    fn direction(&self, fixed: &Fixed) -> Result<(Option<usize>, Place), Undrawable> {
        let (body, Vector { x, y, .. }) = (self.body(&fixed.body)?, fixed.at);
        let local = place(x, y);
        Ok((body, body.map_or(local, |body| local.turned(self.bodies[body].angle))))
    }

    fn point(&self, fixed: &Fixed) -> Result<(Option<usize>, Place), Undrawable> {
        let (body, along) = self.direction(fixed)?;
        Ok((body, body.map_or(Place::default(), |body| self.bodies[body].origin) + along))
    }

    fn joint(&self, joint: &Joint) -> Result<Sign, Undrawable> {
        let bodies = joint.bodies.iter().map(|name| self.body(name)).collect::<Result<Vec<_>, _>>()?;
        Ok(Sign {
            name: joint.name.clone(),
            kind: joint.kind.clone(),
            is_drive: joint.is_drive,
            arguments: self.arguments(joint)?,
            bodies: bodies.into_iter().flatten().collect(),
            rate: joint.rate,
        })
    }

    fn arguments(&self, joint: &Joint) -> Result<Vec<(String, PlacedArgument)>, Undrawable> {
        joint.arguments.iter().map(|(name, argument)| Ok((name.clone(), self.argument(argument)?))).collect()
    }

    fn argument(&self, argument: &Argument) -> Result<PlacedArgument, Undrawable> {
        Ok(match argument {
            Argument::Point(at) => self.point(at).map(|(body, at)| PlacedArgument::Point(body, at))?,
            Argument::Axis(along) => match self.direction(along)? {
                (body, along) if along.is_finite() => PlacedArgument::Axis(body, along.unit()),
                _ => return Err(Undrawable::Nowhere),
            },
            Argument::Body(name) => PlacedArgument::Body(self.body(name)?),
            Argument::Length(value) => PlacedArgument::Number(*value, true),
            Argument::Number(value) => PlacedArgument::Number(*value, false),
            Argument::Function(values) => PlacedArgument::Function(values.clone()),
            Argument::Joint(joint) => PlacedArgument::Joint(self.arguments(joint)?),
        })
    }
}
