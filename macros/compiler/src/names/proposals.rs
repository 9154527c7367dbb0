//! Items that messages propose, written with names that are declared.

use super::{Arguments, Declared, Entity, FrameId, Names, Progress, Value};
use crate::quantity::Ambient;
use crate::syntax::ast::{Expression, ExpressionKind, JointBody, Relation};
use std::collections::BTreeSet;

impl Names {
    /// A drive of the first body, or of a joint in space, by a law.
    pub(crate) fn a_drive(&self, law: &str) -> String {
        match (self.ambient, self.frames.get(1)) {
            (Ambient::Space, _) => format!("drive_rotation(joint, {law})"),
            (Ambient::Plane, Some(frame)) => format!("drive_angle({}, {law})", frame.name),
            (Ambient::Plane, None) => format!("drive_angle(body, {law})"),
        }
    }

    /// A coordinate of the first body, or of a joint in space.
    pub(crate) fn a_coordinate(&self) -> String {
        match (self.ambient, self.frames.get(1)) {
            (Ambient::Plane, Some(frame)) => format!("{}.angle", frame.name),
            _ => "joint.angle".to_owned(),
        }
    }

    /// The quantity between the bodies of a joint that names no coordinate: a distance along its axis, or an angle.
    pub(crate) fn coordinates_across(&self, joint: &str, arguments: &[(String, Value)]) -> Vec<String> {
        if let (Some((axis, _)), [(from, _), (to, _)]) = (
            arguments.iter().find(|(_, value)| matches!(value, Value::Axis(_))),
            arguments.iter().filter(|(_, value)| matches!(value, Value::Point(_))).collect::<Vec<_>>().as_slice(),
        ) {
            return vec![format!("dot({joint}.{to} - {joint}.{from}, {joint}.{axis})")];
        }
        match (self.bodies_of(arguments).as_slice(), self.ambient) {
            ([.., one, two], Ambient::Plane) => vec![format!("{two}.angle - {one}.angle")],
            ([only], Ambient::Plane) => vec![format!("{only}.angle")],
            ([.., last], Ambient::Space) => vec![format!("{last}.angular_velocity")],
            ([], _) => Vec::new(),
        }
    }

    /// What the bodies of a joint have in the plane for its angle or its displacement.
    pub(crate) fn of_bodies(&self, name: &str, joint: &str, arguments: &[(String, Value)]) -> Option<String> {
        let is_meant = self.ambient == Ambient::Plane && ["angle", "displacement"].contains(&name);
        let across = is_meant.then(|| self.coordinates_across(joint, arguments).pop())??;
        (across.starts_with("dot(") == (name == "displacement")).then_some(across)
    }

    /// The bodies that a joint was made with, except ground.
    pub(crate) fn bodies_of(&self, arguments: &[(String, Value)]) -> Vec<&str> {
        let mut frames: Vec<FrameId> = arguments.iter().filter_map(|(_, value)| value.frame()).collect();
        frames.retain(|frame| *frame != FrameId::GROUND);
        frames.dedup();
        frames.iter().map(|frame| self.frames[frame.0].name.as_str()).collect()
    }

    /// The last body that the joint of this name was made with.
    pub(crate) fn moved_by(&self, joint: &str) -> Option<&str> {
        let is_it = |declared: &&Declared| declared.name.path == joint;
        match &self.declared.iter().find(is_it)?.progress {
            Progress::Done(Value::Joint { arguments, .. }) => self.bodies_of(arguments).pop(),
            _ => None,
        }
    }

    /// The joints that a body was made with: name, kind and arguments.
    pub(crate) fn joints_of(&self, frame: FrameId) -> impl Iterator<Item = (&str, &str, &Arguments)> {
        self.declared.iter().filter_map(move |declared| match &declared.progress {
            Progress::Done(Value::Joint { kind, arguments }) if arguments.iter().any(|(_, value)| value.frame() == Some(frame)) => {
                Some((declared.name.path.as_str(), kind.as_str(), arguments))
            }
            _ => None,
        })
    }

    /// The first point of a body that no joint is written with; else its first point, or its origin.
    pub(crate) fn free_point_of(&self, frame: FrameId) -> String {
        let body = &self.frames[frame.0].name;
        let mut used = BTreeSet::new();
        for declared in &self.declared {
            let Entity::Joint(joint) = &declared.entity else { continue };
            let JointBody::Of { arguments, .. } = &joint.body else { continue };
            used.extend(arguments.iter().filter_map(|argument| point_of(&argument.value, body)));
        }
        let points: Vec<&str> = self.points_of(frame).collect();
        let free = points.iter().find(|point| !used.contains(**point));
        free.or(points.first()).map_or("position".to_owned(), |point| (*point).to_owned())
    }

    /// Another point or axis in the place of `given`, if its body must, or must not, be `other`.
    ///
    /// * `bound`: given, all arguments.
    pub(crate) fn mark_instead(&self, given: &Value, relation: Relation, other: FrameId, bound: &[(String, Value)]) -> Option<String> {
        let body = &self.frames[other.0].name;
        let is_beside = |frame: FrameId, is_point: bool| {
            let of_kind =
                bound.iter().filter(|(_, value)| if is_point { matches!(value, Value::Point(_)) } else { matches!(value, Value::Axis(_)) });
            of_kind.filter(|(_, value)| value.frame() == Some(frame)).count() > usize::from(!is_point)
        };
        match (given, relation) {
            (Value::Point(_), Relation::Different) => Some("take a point of another body".to_owned()),
            (Value::Point(at), Relation::Equal) if other != FrameId::GROUND => {
                Some(format!("take a point of `{body}`, or an axis of `{}`", self.frames[at.frame.0].name))
            }
            // Another axis of its body would be the one of its point.
            (Value::Axis(axis), Relation::Equal) if is_beside(axis.frame, true) && !is_beside(axis.frame, false) => {
                Some(format!("exchange the points: the axis belongs to `{}`", self.frames[axis.frame.0].name))
            }
            (Value::Axis(_), Relation::Equal) => Some(match self.an_axis_of(other) {
                Some(axis) => format!("take an axis of `{body}`, such as `{body}.{axis}`"),
                None => {
                    let (names, along) = match self.ambient {
                        Ambient::Plane => (["u", "v", "along"], "(1, 0)"),
                        Ambient::Space => (["z", "w", "along"], "(0, 0, 1)"),
                    };
                    let is_free = |name: &&str| self.find(self.frames[other.0].space, name).is_none();
                    let name = names.into_iter().find(is_free).unwrap_or("turning");
                    format!("declare an axis in `{body}`, such as `axis {name} = {along};`, and write `{body}.{name}`")
                }
            }),
            _ => None,
        }
    }
}

/// The name of a point written as `body.point`.
fn point_of(value: &Expression, body: &str) -> Option<String> {
    let ExpressionKind::Field(owner, point) = &value.kind else { return None };
    let ExpressionKind::Path(path) = &owner.kind else { return None };
    (path.name.as_ref()? == body).then(|| point.to_string())
}
