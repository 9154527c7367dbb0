//! Numbers of a picture that is drawn at run time.

use super::routine::Routine;
use super::schedule;
use super::words::Words;
use crate::expr::Expr;
use crate::model::Sketch;
use std::collections::BTreeMap;

/// Computation of the numbers in a sketch.
#[derive(Clone, Debug)]
pub struct SceneCode {
    /// Every number that is not constant, once.
    pub numbers: Routine,
    /// Functions, each by its value as an expression in which time stands for the variable.
    pub functions: BTreeMap<Expr, Routine>,
}

/// Plans the computation of a sketch.
pub(super) fn scene(sketch: &Sketch, words: &Words) -> SceneCode {
    let (mut numbers, functions) = sketch.exprs();
    numbers.sort();
    numbers.dedup();
    numbers.retain(|number| sketch.arena.as_constant(*number).is_none());
    let function = |value: Expr| (value, schedule::routine(&sketch.arena, vec![value], words));
    SceneCode { numbers: schedule::routine(&sketch.arena, numbers, words), functions: functions.into_iter().map(function).collect() }
}

/// Plans the computation of each point and axis of a sketch alone.
pub(super) fn marks(sketch: &Sketch, words: &Words) -> Vec<Routine> {
    let marks = sketch.points.iter().chain(&sketch.axes);
    marks.map(|mark| schedule::routine(&sketch.arena, mark.at.local.iter().copied().collect(), words)).collect()
}
