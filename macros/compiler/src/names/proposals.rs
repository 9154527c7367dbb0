//! Items that messages propose, written with names that are declared.

use super::{FrameId, Names, Value};
use crate::quantity::Ambient;
use crate::syntax::ast::Relation;

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
        let mut frames: Vec<FrameId> = arguments.iter().filter_map(|(_, value)| value.frame()).collect();
        frames.retain(|frame| *frame != FrameId::GROUND);
        frames.dedup();
        let name = |frame: &FrameId| &self.frames[frame.0].name;
        match (frames.as_slice(), self.ambient) {
            ([.., one, two], Ambient::Plane) => vec![format!("{}.angle - {}.angle", name(two), name(one))],
            ([only], Ambient::Plane) => vec![format!("{}.angle", name(only))],
            ([.., last], Ambient::Space) => vec![format!("{}.angular_velocity", name(last))],
            ([], _) => Vec::new(),
        }
    }

    /// Another point or axis in the place of `given`, if its body must, or must not, be `other`.
    pub(crate) fn mark_instead(&self, given: &Value, relation: Relation, other: FrameId) -> Option<String> {
        let body = &self.frames[other.0].name;
        match (given, relation) {
            (Value::Point(_), Relation::Different) => Some("take a point of another body".to_owned()),
            (Value::Point(at), Relation::Equal) if other != FrameId::GROUND => {
                Some(format!("take a point of `{body}`, or an axis of `{}`", self.frames[at.frame.0].name))
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
