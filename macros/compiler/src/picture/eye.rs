//! From a model and a configuration to a [`Scene`]: the interpreter says where everything lies.

use super::plane::{Place, place};
use super::scene::{Figure, Instant, PlacedArgument, Scene, Sign};
use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::sketch::{Instantiation, JointArgument, LocalVector};
use crate::model::{Function, Model, Name};
use crate::quantity::{Axis, Dim, Role};
use crate::system::System;
use core::f64::consts::TAU;

/// How many values of a function of one turn are looked at.
pub(super) const STEPS: usize = 90;

impl Scene {
    /// The mechanism at an instant; none if something is not where a number could say it is.
    pub(super) fn at(model: &Model, system: &System, instant: &Instant) -> Option<Scene> {
        let functions = |number: u32, x: f64| match model.functions.get(number as usize) {
            Some(Function::Table(table)) => table.evaluate(x),
            _ => [f64::NAN; 3],
        };
        let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
        let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
        let parameters = evaluate(&model.arena, &defaults, &nothing);
        let known = Values { time: instant.time, parameters: &parameters, coordinates: &instant.q, ..nothing };
        let eye = Eye { model, system, known, bodies: figures(model, system, &instant.q) };
        let mut bodies = eye.bodies.clone();
        let joints = eye.signs();
        let declared = model.sketch.points.iter().map(|mark| (mark.at.body, eye.point(mark.at)));
        for (body, at) in declared.chain(joints.iter().flat_map(Sign::points)) {
            if let Some(body) = body {
                bodies[body].points.push(at);
            }
        }
        let outputs = model.sketch.outputs.iter().map(|mark| (mark.name.clone(), mark.at.body, eye.point(mark.at))).collect();
        let scene = Scene { bodies, joints, outputs };
        let is_placed = scene.places().all(Place::is_finite);
        is_placed.then_some(scene)
    }
}

/// A name without the marks of raw identifiers.
fn plain(name: &Name) -> String {
    name.to_string().replace("r#", "")
}

/// The bodies in a configuration, without points.
fn figures(model: &Model, system: &System, q: &[f64]) -> Vec<Figure> {
    let named = |body: &crate::model::Body| Figure { name: plain(&body.name), origin: Place::default(), angle: 0.0, points: Vec::new() };
    let mut bodies: Vec<Figure> = model.bodies.iter().map(named).collect();
    for (unknown, value) in system.coordinates.iter().zip(q) {
        let body = &mut bodies[unknown.body];
        match unknown.role {
            Role::Position(Axis::X) => body.origin.x = *value,
            Role::Position(Axis::Y) => body.origin.y = *value,
            Role::Angle => body.angle = *value,
            // The picture is one of the plane.
            Role::Position(Axis::Z) | Role::Displacement | Role::Quaternion(_) => {}
        }
    }
    bodies
}

/// Evaluates what was sketched.
struct Eye<'a> {
    model: &'a Model,
    system: &'a System,
    known: Values<'a>,
    bodies: Vec<Figure>,
}

impl Eye<'_> {
    /// The joints with their arguments, and with what their equations say of bodies and rates.
    fn signs(&self) -> Vec<Sign> {
        let sign = |(joint, made): (&crate::model::Joint, &Instantiation)| Sign {
            name: plain(&joint.name),
            kind: made.kind.clone(),
            is_drive: joint.is_drive,
            arguments: self.arguments(made),
            bodies: Vec::new(),
            rate: 0.0,
        };
        let mut signs: Vec<Sign> = self.model.joints.iter().zip(&self.model.sketch.joints).map(sign).collect();
        let rates: Vec<Expr> = self.system.equations.iter().map(|equation| equation.nu).collect();
        for (equation, rate) in self.system.equations.iter().zip(evaluate(&self.system.arena, &rates, &self.known)) {
            let sign = &mut signs[equation.joint];
            let bodies = equation.jacobian.iter().map(|(unknown, _)| self.system.coordinates[*unknown].body);
            for body in bodies {
                if !sign.bodies.contains(&body) {
                    sign.bodies.push(body);
                }
            }
            // The rate of a Rust function is not known here.
            if equation.row == 0 && rate.is_finite() {
                sign.rate = rate;
            }
        }
        signs
    }

    fn values(&self, exprs: &[Expr]) -> Vec<f64> {
        evaluate(&self.model.sketch.arena, exprs, &self.known)
    }

    fn local(&self, at: LocalVector) -> Place {
        let values = self.values(&at.local);
        place(values[0], values[1])
    }

    fn direction(&self, at: LocalVector) -> Place {
        let local = self.local(at);
        at.body.map_or(local, |body| local.turned(self.bodies[body].angle))
    }

    fn point(&self, at: LocalVector) -> Place {
        at.body.map_or(Place::default(), |body| self.bodies[body].origin) + self.direction(at)
    }

    fn arguments(&self, made: &Instantiation) -> Vec<(String, PlacedArgument)> {
        made.arguments.iter().map(|(name, argument)| (name.clone(), self.seen(argument))).collect()
    }

    fn seen(&self, argument: &JointArgument) -> PlacedArgument {
        match argument {
            JointArgument::Point(at) => PlacedArgument::Point(at.body, self.point(*at)),
            JointArgument::Axis(at) => PlacedArgument::Axis(at.body, self.direction(*at).unit()),
            JointArgument::Body(body) => PlacedArgument::Body(*body),
            JointArgument::Number(value, dim) => PlacedArgument::Number(self.values(&[*value])[0], *dim == Dim::LENGTH),
            JointArgument::Function(value) => PlacedArgument::Function(self.turn(*value)),
            JointArgument::Joint(made) => PlacedArgument::Joint(self.arguments(made)),
        }
    }

    /// The time stands for the function's variable.
    fn turn(&self, value: Expr) -> Vec<f64> {
        let mut evaluator = Evaluator::new(&self.model.sketch.arena, &[value]);
        let at = |step: usize| {
            let mut found = [f64::NAN];
            evaluator.run(&Values { time: step as f64 * TAU / STEPS as f64, ..self.known }, &mut found);
            found[0]
        };
        (0..STEPS).map(at).collect()
    }
}
