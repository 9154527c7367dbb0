//! Universal joints that were given shafts instead of the arms of their cross.

use crate::diag::{Doubt, Warning};
use crate::expr::{Expr, Values, evaluate};
use crate::model::sketch::{JointArgument, LocalVector};
use crate::model::{Model, defaults, tabulated};
use crate::quantity::Role;

/// Cosine from which on two axes are rather shafts, which are in line, than arms, which are at right angles: 30°.
const IN_LINE: f64 = 0.866;

/// Warnings for universal joints whose axes lie in line at the declared start.
pub(crate) fn shafts_for_arms(model: &Model) -> Vec<Warning> {
    let made = model.joints.iter().zip(&model.sketch.joints).filter(|(_, made)| made.kind == "universal");
    let doubtful = made.filter_map(|(joint, made)| {
        let (Some(JointArgument::Axis(a)), Some(JointArgument::Axis(b))) = (made.argument("a"), made.argument("b")) else { return None };
        let [a, b] = [a, b].map(|axis| at_start(model, axis));
        let dot = |one: &[f64; 3], two: &[f64; 3]| one.iter().zip(two).map(|(x, y)| x * y).sum::<f64>();
        let is_in_line = dot(&a, &b).abs() > IN_LINE * (dot(&a, &a) * dot(&b, &b)).sqrt();
        let doubt = Doubt::ShaftsForArms { joint: joint.name.to_string() };
        is_in_line.then_some(Warning { doubt, range: (&joint.name).into() })
    });
    doubtful.collect()
}

/// An axis in ground at the declared start.
fn at_start(model: &Model, axis: &LocalVector) -> [f64; 3] {
    let arena = &model.sketch.arena;
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let parameters = defaults(model, arena);
    let known = Values { time: 0.0, parameters: &parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let value = |expr: Expr| evaluate(arena, &[expr], &known).pop().unwrap_or(f64::NAN);
    let local: Vec<f64> = axis.local.iter().map(|part| value(*part)).collect();
    let [x, y, z] = [0, 1, 2].map(|k: usize| local.get(k).copied().unwrap_or(0.0));
    let Some(body) = axis.body else { return [x, y, z] };
    let declared = |k: u8| model.bodies[body].coordinates.iter().find(|one| one.role == Role::Quaternion(k)).and_then(|one| one.start);
    let [w, i, j, k] = [0, 1, 2, 3].map(|k| declared(k).map_or(f64::from(u8::from(k == 0)), value));
    // v + 2 w (e × v) + 2 e × (e × v)
    let cross = |[a, b, c]: [f64; 3], [p, q, r]: [f64; 3]| [b * r - c * q, c * p - a * r, a * q - b * p];
    let once = cross([i, j, k], [x, y, z]);
    let twice = cross([i, j, k], once);
    [0, 1, 2].map(|at| [x, y, z][at] + 2.0 * (w * once[at] + twice[at]))
}
