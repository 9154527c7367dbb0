//! Which parameter each argument is meant for.

use super::Names;
use super::signature::{fits, signature};
use super::value::{FrameId, Value};
use crate::diag::ArityFact;
use crate::expr::Arena;
use crate::quantity::{Ambient, InferredDim};
use crate::syntax::ast::{Argument, Definition, Formal, FormalKind};

/// For each argument the first parameter that it fits behind that of the argument before it; `None` if one fits none. A body stands for its origin.
pub(crate) fn fitted(arena: &Arena, definition: &Definition, values: &[Value]) -> Option<Vec<usize>> {
    let mut open = definition.parameters.iter().enumerate();
    let takes = |formal: &Formal, value: &Value| fits(arena, &formal.kind, value) || stands_for_point(formal, value);
    values.iter().map(|value| open.find(|(_, formal)| takes(formal, value)).map(|(place, _)| place)).collect()
}

/// True for what is written as a place in ground.
fn is_of_ground(written: &str) -> bool {
    written.starts_with('(') || written == "ground" || written.starts_with("ground.")
}

/// True for a body in the place of a point.
fn stands_for_point(formal: &Formal, value: &Value) -> bool {
    matches!((&formal.kind, value), (FormalKind::Point, Value::Body(_)))
}

/// Arguments with the numbers of their parameters, as they are written for these.
pub(crate) fn as_written(definition: &Definition, places: &[usize], given: &[Argument], values: &[Value]) -> Vec<(usize, String)> {
    let written = |((place, argument), value): ((&usize, &Argument), &Value)| {
        let point = if stands_for_point(&definition.parameters[*place], value) { ".position" } else { "" };
        (*place, format!("{}{point}", argument.value))
    };
    places.iter().zip(given).zip(values).map(written).collect()
}

/// The call with ground for a body or a point that is missing, before the other one if that stands beside it, and the direction of x for an axis in the
/// plane; `None` if something else is missing. `given`: each argument with the number of its parameter.
pub(crate) fn completed(names: &Names, definition: &Definition, given: &[(usize, String)]) -> Option<String> {
    let is_given = |index: usize| given.iter().any(|(place, _)| *place == index);
    // Ground is one body: it stands for one of two.
    let may_be_completed = |is_of: fn(&FormalKind) -> bool| {
        let of_kind = definition.parameters.iter().enumerate().filter(|(_, formal)| is_of(&formal.kind) && formal.default.is_none());
        let of_kind: Vec<bool> = of_kind.map(|(index, _)| is_given(index)).collect();
        of_kind.iter().all(|is_given| *is_given) || matches!(of_kind.as_slice(), [true, false] | [false, true])
    };
    if !may_be_completed(|kind| matches!(kind, FormalKind::Body)) || !may_be_completed(|kind| matches!(kind, FormalKind::Point)) {
        return None;
    }
    let mut written: Vec<String> = Vec::new();
    for (index, formal) in definition.parameters.iter().enumerate() {
        let is_like = |place: usize| std::mem::discriminant(&definition.parameters[place].kind) == std::mem::discriminant(&formal.kind);
        let is_beside = index.checked_sub(1).is_some_and(|before| is_like(before) && is_given(before));
        match (given.iter().find(|(place, _)| *place == index), &formal.kind) {
            (Some((_, text)), _) => written.push(text.clone()),
            (None, _) if formal.default.is_some() => {}
            (None, FormalKind::Body | FormalKind::Point) => {
                let is_body = matches!(formal.kind, FormalKind::Body);
                let other = given.iter().find(|(place, _)| is_like(*place)).and_then(|(_, one)| names.beside(one));
                let is_ground = other.is_none();
                let other = other.unwrap_or("ground".to_owned());
                let added = if is_body { other } else { format!("{other}.position") };
                let place = written.len() - usize::from(is_beside);
                // Two of ground are one too many.
                if is_beside && is_of_ground(&written[place]) {
                    return None;
                }
                written.insert(if is_ground { place } else { written.len() }, added);
            }
            (None, FormalKind::Axis) if names.ambient == Ambient::Plane => {
                let beside = written.last().and_then(|point| names.axis_beside(point));
                written.push(beside.unwrap_or("(1, 0)".to_owned()));
            }
            (None, _) => return None,
        }
    }
    Some(format!("{}({})", definition.name, written.join(", ")))
}

impl Names {
    /// The first body without a joint so far, if the one of this point has a joint with ground.
    fn beside(&self, point: &str) -> Option<String> {
        let owner = point.rsplit_once('.').map_or(point, |(owner, _)| owner);
        let own = FrameId(self.frames.iter().position(|frame| frame.name == owner)?);
        let with_ground = |arguments: &[(String, Value)]| arguments.iter().any(|(_, value)| value.frame() == Some(FrameId::GROUND));
        if !self.joints_of(own).any(|(_, _, arguments)| with_ground(arguments)) {
            return None;
        }
        let mut others = (1..self.frames.len()).map(FrameId).filter(|frame| *frame != own);
        others.find(|frame| self.joints_of(*frame).next().is_none()).map(|frame| self.frames[frame.0].name.clone())
    }

    /// The first axis of the body whose point this is.
    fn axis_beside(&self, point: &str) -> Option<String> {
        let (owner, _) = point.rsplit_once('.')?;
        let frame = self.frames.iter().position(|frame| frame.name == owner)?;
        self.an_axis_of(FrameId(frame)).map(|axis| format!("{owner}.{axis}"))
    }

    /// The call with two points, axes or bodies of a joint in the place of its name; `None` if they are not all that is missing.
    pub(crate) fn with_ends(&self, arena: &Arena, definition: &Definition, given: &[Argument], values: &[Value]) -> Option<ArityFact> {
        let (Some((joint, rest)), Some(Value::Joint { kind, arguments })) = (given.split_first(), values.first()) else { return None };
        let needed = definition.parameters.iter().filter(|formal| formal.default.is_none()).count();
        let fit = |(formal, value): (&Formal, &Value)| fits(arena, &formal.kind, value);
        if !(needed..=definition.parameters.len()).contains(&(rest.len() + 2))
            || !definition.parameters[2..].iter().zip(&values[1..]).all(fit)
        {
            return None;
        }
        let marks = |is_of: fn(&Value) -> bool| arguments.iter().filter(move |(_, value)| is_of(value)).map(|(name, _)| name.as_str());
        let axes: Vec<&str> = marks(|value| matches!(value, Value::Axis(_))).collect();
        let points: Vec<&str> = marks(|value| matches!(value, Value::Point(_))).collect();
        let has_way = ["translational", "cylindrical", "screw", "distance", "point_on_line"].contains(&kind.as_str());
        let mut frames: Vec<FrameId> = arguments.iter().filter_map(|(_, value)| value.frame()).collect();
        frames.dedup();
        let [one, two] = &definition.parameters[..2] else { return None };
        let mut written = match (&one.kind, &two.kind, has_way) {
            (FormalKind::Axis, FormalKind::Axis, _) => {
                vec![format!("{}.{}", joint.value, axes.first()?), format!("{}.{}", joint.value, axes.get(1)?)]
            }
            (FormalKind::Axis, FormalKind::Body, _) => {
                vec![format!("{}.{}", joint.value, axes.first()?), self.frames[frames.get(1)?.0].name.clone()]
            }
            (FormalKind::Point, FormalKind::Point, true) => {
                vec![format!("{}.{}", joint.value, points.first()?), format!("{}.{}", joint.value, points.get(1)?)]
            }
            (FormalKind::Body, FormalKind::Body, _) => {
                let [one, two] = frames.as_slice() else { return None };
                vec![self.frames[one.0].name.clone(), self.frames[two.0].name.clone()]
            }
            _ => return None,
        };
        let ends = match (&one.kind, &two.kind) {
            (FormalKind::Axis, FormalKind::Axis) => "two axes",
            (FormalKind::Axis, _) => "an axis and a body",
            (FormalKind::Point, _) => "two points",
            _ => "two bodies",
        };
        written.extend(rest.iter().map(|argument| argument.value.to_string()));
        let instead = match (rest, self.ambient) {
            ([law], Ambient::Plane) if definition.name == "drive_distance" && kind == "translational" => {
                format!("drive_along({}, {})", joint.value, law.value)
            }
            ([law], Ambient::Space) if definition.name == "drive_distance" && kind == "translational" => {
                format!("drive_translation({}, {})", joint.value, law.value)
            }
            _ => format!("{}({})", definition.name, written.join(", ")),
        };
        Some(ArityFact::JointForEnds { definition: definition.name.to_string(), signature: signature(definition), ends, instead })
    }

    /// The error for arguments that lack nothing but axes, as those of a joint of the plane do in space, or nothing but points, with the call
    /// that has them; `None` if no point tells the body of an axis, or no axis that of a point.
    pub(crate) fn with_marks(&self, definition: &Definition, given: &[(usize, String)], values: &[Value]) -> Option<ArityFact> {
        let (mut written, mut missing, mut without) = (Vec::new(), Vec::new(), Vec::new());
        let mut last: Option<(String, FrameId)> = None;
        let is_place = |value: &&Value| matches!(value, Value::Point(_) | Value::Body(_));
        let frames: Vec<FrameId> = values.iter().filter(is_place).filter_map(Value::frame).collect();
        let an_axis_of = |frame: FrameId| self.an_axis_of_all(&frames).or_else(|| self.an_axis_of(frame));
        for (index, formal) in definition.parameters.iter().enumerate() {
            match given.iter().position(|(place, _)| *place == index) {
                // An axis of another body belongs elsewhere.
                Some(number)
                    if matches!(values[number], Value::Axis(_) | Value::Vector(_))
                        && matches!(formal.kind, FormalKind::Axis)
                        && last.as_ref().is_some_and(|(_, own)| values[number].frame().unwrap_or(FrameId::GROUND) != *own) =>
                {
                    let (owner, frame) = last.as_ref()?;
                    written.push(format!("{owner}.{}", an_axis_of(*frame)?));
                }
                Some(number) => {
                    written.push(given[number].1.clone());
                    if let (Value::Point(_) | Value::Body(_), Some(frame)) = (&values[number], values[number].frame()) {
                        last = written.last().and_then(|text| text.rsplit_once('.')).map(|(owner, _)| (owner.to_owned(), frame));
                    }
                }
                None if formal.default.is_some() => {}
                None if matches!(formal.kind, FormalKind::Point) => {
                    let (number, _) = given.iter().enumerate().find(|(_, (place, _))| *place > index)?;
                    let owner = matches!(values[number], Value::Axis(_)).then(|| given[number].1.rsplit_once('.'))??.0;
                    written.push(format!("{owner}.position"));
                    missing.push(formal.name.to_string());
                }
                None => {
                    let (owner, frame) = last.as_ref()?;
                    if self.an_axis_of(*frame).is_none() && !without.contains(owner) {
                        without.push(owner.clone());
                    }
                    let of_body = |number: &usize| matches!(values[*number], Value::Axis(_)) && values[*number].frame() == Some(*frame);
                    let given_one = (0..given.len()).find(of_body).map(|number| given[number].1.clone());
                    written.push(given_one.unwrap_or_else(|| format!("{owner}.{}", an_axis_of(*frame).unwrap_or("z"))));
                    missing.push(formal.name.to_string());
                }
            }
        }
        let (definition, signature) = (definition.name.to_string(), signature(definition));
        let instead = format!("{definition}({})", written.join(", "));
        let are_points = last.is_none();
        Some(ArityFact::MissingMarks { definition, signature, missing, instead, without, are_points })
    }
}

/// The arguments in the order of the parameters that they fit; `None` if they fit in no order, or as they are given.
pub(crate) fn reordered(arena: &Arena, definition: &Definition, given: &[Argument], values: Vec<Value>) -> Option<Vec<String>> {
    let mut open: Vec<(&Argument, Value)> = given.iter().zip(values).collect();
    // What is written out is of ground.
    let frame = |value: &Value| value.frame().unwrap_or(FrameId::GROUND);
    let (mut ordered, mut last_frame, mut is_as_given) = (Vec::new(), FrameId::GROUND, true);
    for (index, formal) in definition.parameters[..given.len()].iter().enumerate() {
        // A point and the axis after it belong to one body.
        let is_axis = |formal: &Formal| matches!(formal.kind, FormalKind::Axis);
        let has_axis = definition.parameters.get(index + 1).is_some_and(is_axis);
        let axes = open.iter().filter(|(_, value)| fits(arena, &FormalKind::Axis, value));
        let axes: Vec<FrameId> = axes.map(|(_, value)| frame(value)).collect();
        let is_beside = |own: FrameId| if is_axis(formal) { own == last_frame } else { has_axis && axes.contains(&own) };
        let takes = |value: &Value| fits(arena, &formal.kind, value) || stands_for_point(formal, value);
        let fitting: Vec<usize> = (0..open.len()).filter(|place| takes(&open[*place].1)).collect();
        let is_exact = |place: &&usize| match (&formal.kind, &open[**place].1) {
            (FormalKind::Scalar(written), Value::Scalar(scalar)) => written.dim().map(InferredDim::Known) == Some(scalar.measure),
            _ => false,
        };
        let best = fitting.iter().find(|place| is_beside(frame(&open[**place].1))).or(fitting.iter().find(is_exact));
        let place = *best.or(fitting.first())?;
        is_as_given &= place == 0;
        let (argument, value) = open.remove(place);
        let point = if stands_for_point(formal, &value) { ".position" } else { "" };
        ordered.push(format!("{}{point}", argument.value));
        last_frame = frame(&value);
    }
    (!is_as_given).then_some(ordered)
}
