//! From a model and a configuration to a [`Scene`]: the interpreter computes its numbers.

use super::pose::Instant;
use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::sketch::{Instantiation, JointArgument, LocalVector};
use crate::model::{Function, Model};
use crate::quantity::{Axis, Dim, Role};
use crate::system::System;
use reuleaux_picture::{Joint, Pose, Scene};

/// The mechanism at an instant.
pub(super) fn scene(model: &Model, system: &System, instant: &Instant) -> Scene {
    let functions = |number: u32, x: f64| match model.functions.get(number as usize) {
        Some(Function::Table(table)) => table.evaluate(x),
        _ => [f64::NAN; 3],
    };
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let parameters = evaluate(&model.arena, &defaults, &nothing);
    let known = Values { time: instant.time, parameters: &parameters, coordinates: &instant.q, ..nothing };
    Composer { model, system, known }.scene()
}

/// Composes a scene.
struct Composer<'a> {
    model: &'a Model,
    system: &'a System,
    known: Values<'a>,
}

impl Composer<'_> {
    fn scene(&self) -> Scene {
        let Composer { model, system, known } = self;
        let mut scene = Scene::new(&model.name.to_string().replace("r#", ""));
        for (index, body) in model.bodies.iter().enumerate() {
            scene.body(&body.name.unraw(), pose(system, index, known.coordinates));
        }
        for point in &model.sketch.points {
            scene.point(&model.drawn_name(point.at.body), self.local(point.at));
        }
        for (index, (joint, made)) in model.joints.iter().zip(&model.sketch.joints).enumerate() {
            let (name, kind) = (joint.name.unraw(), made.kind.as_str());
            let drawn = if joint.is_drive { scene.drive(&name, kind, self.rate(index)) } else { scene.joint(&name, kind) };
            for body in system.bodies_of(index) {
                drawn.of(&[&model.drawn_name(Some(body))]);
            }
            self.give(drawn, made);
        }
        for output in &model.sketch.outputs {
            scene.output(&output.name, &model.drawn_name(output.at.body), self.local(output.at));
        }
        scene
    }

    /// Gives a joint its arguments.
    fn give(&self, joint: &mut Joint, made: &Instantiation) {
        for (name, argument) in &made.arguments {
            match argument {
                JointArgument::Point(at) => joint.point(name, &self.model.drawn_name(at.body), self.local(*at)),
                JointArgument::Axis(along) => joint.axis(name, &self.model.drawn_name(along.body), self.local(*along)),
                JointArgument::Body(body) => joint.body(name, &self.model.drawn_name(*body)),
                JointArgument::Number(value, Dim::LENGTH) => joint.length(name, self.values(&[*value])[0]),
                JointArgument::Number(value, _) => joint.number(name, self.values(&[*value])[0]),
                JointArgument::Function(value) => {
                    // Time stands for the variable of the function.
                    let mut evaluator = Evaluator::new(&self.model.sketch.arena, &[*value]);
                    joint.function(name, |variable| {
                        let mut found = [f64::NAN];
                        evaluator.run(&Values { time: variable, ..self.known }, &mut found);
                        found[0]
                    })
                }
                JointArgument::Joint(made) => joint.joint(name, &made.kind, |joint| self.give(joint, made)),
            };
        }
    }

    /// The rate of a drive's law; that of a Rust function is not known here.
    fn rate(&self, joint: usize) -> f64 {
        let law = self.system.of_joint(joint).first();
        law.map_or(f64::NAN, |equation| evaluate(&self.system.arena, &[equation.nu], &self.known)[0])
    }

    fn values(&self, exprs: &[Expr]) -> Vec<f64> {
        evaluate(&self.model.sketch.arena, exprs, &self.known)
    }

    fn local(&self, at: LocalVector) -> [f64; 2] {
        let values = self.values(&at.local);
        [values[0], values[1]]
    }
}

/// Where the frame of a body is.
fn pose(system: &System, body: usize, q: &[f64]) -> Pose {
    let [mut x, mut y, mut angle] = [0.0; 3];
    for (unknown, value) in system.coordinates.iter().zip(q).filter(|(unknown, _)| unknown.body == body) {
        match unknown.role {
            Role::Position(Axis::X) => x = *value,
            Role::Position(Axis::Y) => y = *value,
            Role::Angle => angle = *value,
            // The picture is one of the plane.
            Role::Position(Axis::Z) | Role::Displacement | Role::Quaternion(_) => {}
        }
    }
    Pose::plane(x, y, angle)
}
