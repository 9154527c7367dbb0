//! Which parameter each argument is meant for.

use super::signature::fits;
use super::value::{FrameId, Value};
use crate::expr::Arena;
use crate::quantity::Ambient;
use crate::syntax::ast::{Argument, Definition, Formal, FormalKind};

/// For each argument the first parameter that it fits behind that of the argument before it; `None` if one fits none.
pub(crate) fn fitted(arena: &Arena, definition: &Definition, values: &[Value]) -> Option<Vec<usize>> {
    let mut open = definition.parameters.iter().enumerate();
    values.iter().map(|value| open.find(|(_, formal)| fits(arena, &formal.kind, value)).map(|(place, _)| place)).collect()
}

/// The call with ground for a body that is missing, before the other one, and the direction of x for an axis in the plane; `None` if
/// something else is missing. `given`: each argument with the number of its parameter.
pub(crate) fn completed(definition: &Definition, given: &[(usize, String)], ambient: Ambient) -> Option<String> {
    let mut written: Vec<(bool, String)> = Vec::new();
    for (index, formal) in definition.parameters.iter().enumerate() {
        let is_body = matches!(formal.kind, FormalKind::Body);
        match (given.iter().find(|(place, _)| *place == index), &formal.kind) {
            (Some((_, text)), _) => written.push((is_body, text.clone())),
            (None, _) if formal.default.is_some() => {}
            (None, FormalKind::Body) => {
                let first = written.iter().position(|(is_body, _)| *is_body).unwrap_or(written.len());
                written.insert(first, (true, "ground".to_owned()));
            }
            (None, FormalKind::Axis) if ambient == Ambient::Plane => written.push((false, "(1, 0)".to_owned())),
            (None, _) => return None,
        }
    }
    let written: Vec<String> = written.into_iter().map(|(_, text)| text).collect();
    Some(format!("{}({})", definition.name, written.join(", ")))
}

/// The arguments in the order of the parameters that they fit; `None` if they fit in no order.
pub(crate) fn reordered(arena: &Arena, definition: &Definition, given: &[Argument], values: Vec<Value>) -> Option<Vec<String>> {
    let mut open: Vec<(&Argument, Value)> = given.iter().zip(values).collect();
    // What is written out is of ground.
    let frame = |value: &Value| value.frame().unwrap_or(FrameId::GROUND);
    let (mut ordered, mut last_frame) = (Vec::new(), FrameId::GROUND);
    for (index, formal) in definition.parameters[..given.len()].iter().enumerate() {
        // A point and the axis after it belong to one body.
        let is_axis = |formal: &Formal| matches!(formal.kind, FormalKind::Axis);
        let has_axis = definition.parameters.get(index + 1).is_some_and(is_axis);
        let axes = open.iter().filter(|(_, value)| fits(arena, &FormalKind::Axis, value));
        let axes: Vec<FrameId> = axes.map(|(_, value)| frame(value)).collect();
        let is_beside = |own: FrameId| if is_axis(formal) { own == last_frame } else { has_axis && axes.contains(&own) };
        let fitting: Vec<usize> = (0..open.len()).filter(|place| fits(arena, &formal.kind, &open[*place].1)).collect();
        let place = *fitting.iter().find(|place| is_beside(frame(&open[**place].1))).or(fitting.first())?;
        let (argument, value) = open.remove(place);
        ordered.push(argument.value.to_string());
        last_frame = frame(&value);
    }
    Some(ordered)
}
