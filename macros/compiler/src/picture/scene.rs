//! From a model and a configuration to a [`Scene`]; the interpreter evaluates its numbers.

use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::sketch::{Instantiation, JointArgument, LocalVector};
use crate::model::{Model, tabulated};
use crate::quantity::{Axis, Dim, Role};
use crate::system::{COSINES, System, cosine};
use reuleaux_picture::{Joint, Pose, Scene, Vector};

/// A time and a configuration.
#[derive(Clone, Debug)]
pub(super) struct Instant {
    /// Time, in s.
    pub(super) time: f64,
    /// Values of all unknowns, in SI units.
    pub(super) q: Vec<f64>,
}

/// The mechanism at one instant.
pub(super) fn scene(model: &Model, system: &System, instant: &Instant) -> Scene {
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let parameters = evaluate(&model.arena, &defaults, &nothing);
    let known = Values { time: instant.time, parameters: &parameters, coordinates: &instant.q, ..nothing };
    Composer { model, system, known }.scene()
}

/// Builds a scene.
struct Composer<'a> {
    model: &'a Model,
    system: &'a System,
    known: Values<'a>,
}

impl Composer<'_> {
    fn scene(&self) -> Scene {
        let Composer { model, system, known } = self;
        let mut scene = Scene::new(&model.name.to_string().replace("r#", ""));
        let poses = if system.frames.is_empty() {
            (0..model.bodies.len()).map(|body| pose(system, body, known.coordinates)).collect()
        } else {
            self.poses_in_space()
        };
        for (body, pose) in model.bodies.iter().zip(poses) {
            scene.body(&body.name.unraw(), pose);
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
        for (name, made) in &model.sketch.forces {
            let drawn = scene.joint(name, &made.kind);
            for body in made.bodies() {
                drawn.of(&[&model.drawn_name(body)]);
            }
            self.give(drawn, made);
        }
        for output in &model.sketch.outputs {
            scene.output(&output.name, &model.drawn_name(output.at.body), self.local(output.at));
        }
        scene
    }

    /// Poses of all bodies in space.
    fn poses_in_space(&self) -> Vec<Pose> {
        let mut arena = self.system.arena.clone();
        let entries = self.system.frames.iter().enumerate().flat_map(|(body, _)| self.system.orientation(&mut arena, body));
        let roots: Vec<Expr> = entries.map(|[value, _, _]| value).collect();
        let values = evaluate(&arena, &roots, &self.known);
        let places = self.known.coordinates.chunks(3).take(self.system.frames.len());
        let pose = |(place, rotation): (&[f64], &[f64])| {
            let at = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(f64::NAN);
            let row = |row: usize| [0, 1, 2].map(|column| at(rotation, cosine(0, row, column)));
            Pose::space([0, 1, 2].map(|axis| at(place, axis)), [row(0), row(1), row(2)])
        };
        places.zip(values.chunks(COSINES)).map(pose).collect()
    }

    /// Adds the arguments of a joint.
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

    /// Rate of a drive's law; NaN for a Rust function, which the compiler cannot call.
    fn rate(&self, joint: usize) -> f64 {
        if let Some(rate) = self.model.sketch.rates.get(joint) {
            return rate.map_or(f64::NAN, |rate| self.values(&[rate])[0]);
        }
        let law = self.system.of_joint(joint).first();
        law.map_or(f64::NAN, |equation| evaluate(&self.system.arena, &[equation.nu], &self.known)[0])
    }

    fn values(&self, exprs: &[Expr]) -> Vec<f64> {
        evaluate(&self.model.sketch.arena, exprs, &self.known)
    }

    fn local(&self, at: LocalVector) -> Vector {
        match *self.values(&at.local) {
            [x, y, z] => Vector::from([x, y, z]),
            [x, y] => Vector::from([x, y]),
            _ => Vector::from([f64::NAN; 2]),
        }
    }
}

/// Pose of a body in the plane.
fn pose(system: &System, body: usize, q: &[f64]) -> Pose {
    let [mut x, mut y, mut angle] = [0.0; 3];
    for (unknown, value) in system.coordinates.iter().zip(q).filter(|(unknown, _)| unknown.body == body) {
        match unknown.role {
            Role::Position(Axis::X) => x = *value,
            Role::Position(Axis::Y) => y = *value,
            Role::Angle => angle = *value,
            // Coordinates that occur in space only.
            Role::Position(Axis::Z) | Role::Displacement | Role::Quaternion(_) => {}
        }
    }
    Pose::plane(x, y, angle)
}
