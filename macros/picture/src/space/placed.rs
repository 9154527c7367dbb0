//! The mechanism in one configuration, with every point in ground coordinates: in m, or in picture units before the projection.

use super::vector::{Vec3, vec3};
use crate::placed::{FARTHEST, has_a_size_to_draw};
use crate::scene::{Argument, Fixed, GROUND, Joint, Scene, Turn, Vector};
use crate::undrawable::Undrawable;
use std::collections::BTreeMap;

/// A scene with all points in ground coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) bodies: Vec<Solid>,
    pub(crate) joints: Vec<Sign>,
    /// Outputs that are points of bodies.
    pub(crate) outputs: Vec<(String, Vec3)>,
    /// Shapes of bodies: their corners.
    pub(crate) outlines: Vec<(Option<usize>, Vec<Vec3>)>,
    /// Picture units per metre; 1 while lengths are in m.
    pub(crate) scale: f64,
}

/// A body.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    pub(crate) name: String,
    pub(crate) origin: Vec3,
    rotation: [[f64; 3]; 3],
    /// Declared points, and points at which joints act.
    pub(crate) points: Vec<Vec3>,
}

/// A point or a unit vector with its body; `None` is ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Of {
    pub(crate) body: Option<usize>,
    pub(crate) at: Vec3,
}

/// A joint or a drive.
#[derive(Clone, Debug)]
pub(crate) struct Sign {
    pub(crate) name: String,
    pub(crate) kind: String,
    pub(crate) is_drive: bool,
    /// Rate of the drive's law, in SI.
    pub(crate) rate: f64,
    pub(crate) given: Given,
    /// Bodies on which the equations depend.
    pub(crate) bodies: Vec<Option<usize>>,
}

/// Arguments of a joint.
#[derive(Clone, Debug, Default)]
pub(crate) struct Given {
    points: Vec<(String, Of)>,
    axes: Vec<(String, Of)>,
    numbers: Vec<(String, f64)>,
    joints: Vec<Made>,
}

/// A joint that is an argument.
#[derive(Clone, Debug)]
pub(crate) struct Made {
    pub(crate) kind: String,
    pub(crate) given: Given,
}

impl Given {
    pub(crate) fn point(&self, name: &str) -> Option<Of> {
        self.points.iter().find(|(known, _)| known == name).map(|(_, of)| *of)
    }

    pub(crate) fn axis(&self, name: &str) -> Option<Of> {
        self.axes.iter().find(|(known, _)| known == name).map(|(_, of)| *of)
    }

    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|(known, value)| known == name && value.abs() <= FARTHEST).map(|(_, value)| *value)
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = Of> {
        self.points.iter().map(|(_, of)| *of)
    }

    pub(crate) fn axes(&self) -> impl Iterator<Item = Of> {
        self.axes.iter().map(|(_, of)| *of)
    }

    pub(crate) fn joints(&self) -> &[Made] {
        &self.joints
    }

    fn seen(&mut self, change: &impl Fn(Vec3) -> Vec3) {
        self.points.iter_mut().for_each(|(_, of)| of.at = change(of.at));
        self.joints.iter_mut().for_each(|made| made.given.seen(change));
    }
}

impl Sign {
    /// The points P and Q of a joint and its axis, each with its body.
    pub(crate) fn hinge(&self) -> Option<(Of, Of, Of)> {
        Some((self.given.point("P")?, self.given.point("Q")?, self.given.axis("a")?))
    }
}

impl Placed {
    /// Transforms all points to ground coordinates.
    pub(crate) fn of(scene: &Scene) -> Result<Placed, Undrawable> {
        has_a_size_to_draw(scene)?;
        let frames = Frames::of(scene);
        let mut bodies = frames.bodies.clone();
        let declared = scene.points.iter().map(|fixed| frames.point(fixed)).collect::<Result<Vec<_>, _>>()?;
        let joints = scene.joints.iter().map(|joint| frames.joint(joint)).collect::<Result<Vec<_>, _>>()?;
        for of in declared.into_iter().chain(joints.iter().flat_map(|joint| joint.given.points())) {
            if let Some(body) = of.body {
                bodies[body].points.push(of.at);
            }
        }
        // A body with a single point is drawn from it to the origin of its frame.
        for body in &mut bodies {
            if let Some(first) = body.points.first()
                && body.points.iter().all(|at| (*at - *first).norm() <= 1e-9 * (*first - body.origin).norm())
            {
                body.points.push(body.origin);
            }
        }
        let output = |(name, fixed): &(String, Fixed)| frames.point(fixed).map(|of| (name.clone(), of.at));
        let outputs = scene.outputs.iter().map(output).collect::<Result<Vec<_>, _>>()?;
        let outline = |(body, corners): &(String, Vec<Vector>)| {
            let corner = |at: &Vector| frames.point(&Fixed { body: body.clone(), at: *at }).map(|of| of.at);
            Ok((frames.body(body)?, corners.iter().map(corner).collect::<Result<Vec<_>, _>>()?))
        };
        let outlines = scene.outlines.iter().map(outline).collect::<Result<Vec<_>, Undrawable>>()?;
        let placed = Placed { bodies, joints, outputs, outlines, scale: 1.0 };
        if placed.places().next().is_none() {
            return Err(Undrawable::Empty);
        }
        let is_somewhere = |at: Vec3| [at.x, at.y, at.z].iter().all(|part| part.abs() <= FARTHEST);
        let are_turned = placed.bodies.iter().all(|body| body.rotation.iter().flatten().all(|entry| entry.is_finite()));
        let have_directions = placed.joints.iter().flat_map(|joint| joint.given.axes()).all(|of| of.at.is_finite());
        let of_arguments = || placed.joints.iter().flat_map(|joint| joint.given.joints()).flat_map(|made| made.given.points());
        let are_somewhere = placed.places().chain(of_arguments().map(|of| of.at)).all(is_somewhere);
        let is_placed = are_turned && have_directions && are_somewhere;
        if is_placed { Ok(placed) } else { Err(Undrawable::Nowhere) }
    }

    /// Positions of all bodies, joints and outputs.
    pub(crate) fn places(&self) -> impl Iterator<Item = Vec3> {
        let of_bodies = self.bodies.iter().flat_map(|body| if body.points.is_empty() { vec![body.origin] } else { body.points.clone() });
        let of_joints = self.joints.iter().flat_map(|joint| joint.given.points()).map(|of| of.at);
        let of_outlines = self.outlines.iter().flat_map(|(_, corners)| corners.iter().copied());
        of_bodies.chain(of_joints).chain(self.outputs.iter().map(|output| output.1)).chain(of_outlines)
    }

    /// A copy with every point mapped by `change`; `scale` is the length of a metre in the result.
    pub(crate) fn seen(&self, scale: f64, change: impl Fn(Vec3) -> Vec3) -> Placed {
        let mut seen = Placed { scale, ..self.clone() };
        for body in &mut seen.bodies {
            body.origin = change(body.origin);
            body.points.iter_mut().for_each(|at| *at = change(*at));
        }
        seen.joints.iter_mut().for_each(|joint| joint.given.seen(&change));
        seen.outputs.iter_mut().for_each(|output| output.1 = change(output.1));
        seen.outlines.iter_mut().flat_map(|(_, corners)| corners).for_each(|at| *at = change(*at));
        seen
    }

    /// The first joint with this axis between bodies that satisfy `is_between`.
    pub(crate) fn joint_on(&self, axis: Vec3, is_between: impl Fn(Option<usize>, Option<usize>) -> bool) -> Option<usize> {
        self.joints.iter().position(|joint| {
            let own = joint.hinge().filter(|_| !joint.is_drive && joint.kind != "rack_pinion");
            own.is_some_and(|(p, q, a)| is_between(p.body, q.body) && a.at.dot(axis).abs() > 0.999)
        })
    }

    /// `crank`, or `ground`.
    pub(crate) fn name(&self, body: Option<usize>) -> &str {
        body.and_then(|body| self.bodies.get(body)).map_or(GROUND, |body| &body.name)
    }
}

impl Solid {
    /// Axes of the body's frame, in ground coordinates.
    pub(crate) fn columns(&self) -> [Vec3; 3] {
        let [one, two, three] = self.rotation;
        [0, 1, 2].map(|k| vec3(one[k], two[k], three[k]))
    }

    /// The two points that are farthest apart.
    pub(crate) fn bar(&self) -> Option<(Vec3, Vec3)> {
        let pairs = self.points.iter().enumerate().flat_map(|(index, one)| self.points[index + 1..].iter().map(move |two| (*one, *two)));
        pairs.max_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()))
    }
}

/// The frames of all bodies.
struct Frames<'a> {
    bodies: Vec<Solid>,
    numbers: BTreeMap<&'a str, usize>,
}

fn components(Vector { x, y, z }: Vector) -> Vec3 {
    vec3(x, y, z.unwrap_or(0.0))
}

impl Frames<'_> {
    fn of(scene: &Scene) -> Frames<'_> {
        let solid = |body: &crate::scene::Body| {
            let rotation = match body.pose.turn {
                Turn::Space(rows) => rows,
                Turn::Plane(angle) => {
                    let (sine, cosine) = libm::sincos(angle);
                    [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]]
                }
            };
            Solid { name: body.name.clone(), origin: components(body.pose.position), rotation, points: Vec::new() }
        };
        // If two bodies share a name, the first is used.
        let numbers = scene.bodies.iter().enumerate().rev().map(|(number, body)| (body.name.as_str(), number)).collect();
        Frames { bodies: scene.bodies.iter().map(solid).collect(), numbers }
    }

    fn body(&self, name: &str) -> Result<Option<usize>, Undrawable> {
        match self.numbers.get(name) {
            Some(number) => Ok(Some(*number)),
            None if name == GROUND => Ok(None),
            None => Err(Undrawable::UnknownBody(name.to_owned())),
        }
    }

    fn direction(&self, fixed: &Fixed) -> Result<Of, Undrawable> {
        let (body, local) = (self.body(&fixed.body)?, components(fixed.at));
        let turned = body.map_or(local, |body| {
            let [x, y, z] = self.bodies[body].rotation.map(|[x, y, z]| vec3(x, y, z).dot(local));
            vec3(x, y, z)
        });
        Ok(Of { body, at: turned })
    }

    fn point(&self, fixed: &Fixed) -> Result<Of, Undrawable> {
        let Of { body, at } = self.direction(fixed)?;
        Ok(Of { body, at: body.map_or(Vec3::default(), |body| self.bodies[body].origin) + at })
    }

    fn joint(&self, joint: &Joint) -> Result<Sign, Undrawable> {
        let mut bodies = Vec::new();
        self.bodies_of(joint, &mut bodies)?;
        let (name, kind, given) = (joint.name.clone(), joint.kind.clone(), self.given(joint)?);
        Ok(Sign { name, kind, is_drive: joint.is_drive, rate: joint.rate, given, bodies })
    }

    /// Collects the bodies of a joint, each once.
    fn bodies_of(&self, joint: &Joint, found: &mut Vec<Option<usize>>) -> Result<(), Undrawable> {
        for (_, argument) in &joint.arguments {
            match argument {
                Argument::Point(Fixed { body, .. }) | Argument::Axis(Fixed { body, .. }) | Argument::Body(body) => {
                    let body = self.body(body)?;
                    if !found.contains(&body) {
                        found.push(body);
                    }
                }
                Argument::Joint(joint) => self.bodies_of(joint, found)?,
                _ => {}
            }
        }
        for name in &joint.bodies {
            let body = self.body(name)?;
            if !found.contains(&body) {
                found.push(body);
            }
        }
        Ok(())
    }

    fn given(&self, joint: &Joint) -> Result<Given, Undrawable> {
        let mut given = Given::default();
        for (name, argument) in &joint.arguments {
            match argument {
                Argument::Point(fixed) => given.points.push((name.clone(), self.point(fixed)?)),
                Argument::Axis(fixed) => {
                    let Of { body, at } = self.direction(fixed)?;
                    if !at.is_finite() {
                        return Err(Undrawable::Nowhere);
                    }
                    given.axes.push((name.clone(), Of { body, at: at.unit() }));
                }
                Argument::Length(value) | Argument::Number(value) => given.numbers.push((name.clone(), *value)),
                Argument::Joint(joint) => given.joints.push(Made { kind: joint.kind.clone(), given: self.given(joint)? }),
                Argument::Body(_) | Argument::Function(_) => {}
            }
        }
        Ok(given)
    }
}
