//! The mechanism in one configuration: every point where it lies in ground, in m, with y upwards.

use super::plane::{Place, place};
use crate::expr::{Evaluator, Expr, Leaf, Values, evaluate};
use crate::model::sketch::{Argument, Local, Made};
use crate::model::{Dim, Function, Model};
use crate::system::System;
use core::f64::consts::TAU;

/// How many values of a function of one turn are looked at.
pub(super) const STEPS: usize = 90;

/// A time and a configuration.
#[derive(Clone, Debug)]
pub(super) struct Instant {
    /// In s.
    pub(super) time: f64,
    /// One value for each unknown, in SI.
    pub(super) q: Vec<f64>,
}

/// Everything where it lies.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    pub(super) bodies: Vec<Figure>,
    pub(super) joints: Vec<Sign>,
    /// Outputs that are points of bodies: name, body, place.
    pub(super) outputs: Vec<(String, Option<usize>, Place)>,
}

/// A body.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    pub(super) name: String,
    pub(super) origin: Place,
    /// In rad.
    pub(super) angle: f64,
    /// Its declared points, and those that joints take hold of.
    pub(super) points: Vec<Place>,
}

/// A joint or a drive.
#[derive(Clone, Debug)]
pub(super) struct Sign {
    pub(super) name: String,
    pub(super) kind: String,
    pub(super) is_drive: bool,
    pub(super) arguments: Vec<(String, Seen)>,
    /// The bodies whose coordinates stand in its equations.
    pub(super) bodies: Vec<usize>,
    /// The rate of a drive's law, in SI.
    pub(super) rate: f64,
}

/// An argument where it lies; `None` is ground.
#[derive(Clone, Debug)]
pub(super) enum Seen {
    Point(Option<usize>, Place),
    /// With unit length.
    Axis(Option<usize>, Place),
    Body(Option<usize>),
    /// A number in SI, and whether it is a length.
    Number(f64, bool),
    /// Values over one turn, at equal steps.
    Function(Vec<f64>),
    Joint(Vec<(String, Seen)>),
}

impl Sign {
    /// The body, and the place, of an argument that is a point.
    pub(super) fn point(&self, name: &str) -> Option<(Option<usize>, Place)> {
        point(&self.arguments, name)
    }

    /// The body, and the direction, of an argument that is an axis.
    pub(super) fn axis(&self, name: &str) -> Option<(Option<usize>, Place)> {
        axis(&self.arguments, name)
    }

    /// An argument that is a body.
    pub(super) fn body(&self, name: &str) -> Option<Option<usize>> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            Seen::Body(body) if known == name => Some(*body),
            _ => None,
        })
    }

    /// An argument that is a number, and whether it is a length.
    pub(super) fn number(&self, name: &str) -> Option<(f64, bool)> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            Seen::Number(value, is_length) if known == name && value.is_finite() => Some((*value, *is_length)),
            _ => None,
        })
    }

    /// The values of an argument that is a function, if all are known.
    pub(super) fn function(&self, name: &str) -> Option<&[f64]> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            Seen::Function(values) if known == name && values.iter().all(|value| value.is_finite()) => Some(values.as_slice()),
            _ => None,
        })
    }

    /// All arguments that are points.
    pub(super) fn points(&self) -> impl Iterator<Item = (Option<usize>, Place)> {
        self.arguments.iter().filter_map(|(_, seen)| if let Seen::Point(body, at) = seen { Some((*body, *at)) } else { None })
    }
}

pub(super) fn point(arguments: &[(String, Seen)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        Seen::Point(body, at) if known == name => Some((*body, *at)),
        _ => None,
    })
}

pub(super) fn axis(arguments: &[(String, Seen)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        Seen::Axis(body, along) if known == name => Some((*body, *along)),
        _ => None,
    })
}

impl Scene {
    /// The mechanism at an instant; none if something is not where a number could say it is.
    pub(super) fn at(model: &Model, system: &System, instant: &Instant) -> Option<Scene> {
        let functions = |number: u32, x: f64| match model.functions.get(number as usize) {
            Some(Function::Table(table)) => table.evaluate(x),
            _ => [f64::NAN; 3],
        };
        let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], velocities: &[], accelerations: &[], functions: &functions };
        let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
        let parameters = evaluate(&model.arena, &defaults, &nothing);
        let known = Values { time: instant.time, parameters: &parameters, coordinates: &instant.q, ..nothing };
        let rates: Vec<Expr> = system.equations.iter().map(|equation| equation.nu).collect();
        let rates = evaluate(&system.arena, &rates, &known);
        let mut bodies: Vec<Figure> = model
            .bodies
            .iter()
            .enumerate()
            .map(|(index, body)| {
                let q = |offset: usize| instant.q.get(3 * index + offset).copied().unwrap_or(f64::NAN);
                Figure { name: body.name.to_string(), origin: place(q(0), q(1)), angle: q(2), points: Vec::new() }
            })
            .collect();
        let eye = Eye { model, known, bodies: bodies.clone() };
        for mark in &model.sketch.points {
            if let Some(body) = mark.at.body {
                bodies[body].points.push(eye.point(mark.at));
            }
        }
        let sign = |(index, (joint, made)): (usize, (&crate::model::Joint, &Made))| {
            let rate = system.equations.iter().zip(&rates).find(|(equation, _)| equation.joint == index).map_or(0.0, |(_, rate)| *rate);
            // A Rust function is not run here.
            let rate = if rate.is_finite() { rate } else { 0.0 };
            let mut touched: Vec<usize> = Vec::new();
            for residual in &joint.residuals {
                let leaves = model.arena.leaves(residual.expr);
                touched.extend(
                    leaves.iter().filter_map(|leaf| if let Leaf::Coordinate(number) = leaf { Some(*number as usize / 3) } else { None }),
                );
            }
            touched.sort_unstable();
            touched.dedup();
            let (name, kind) = (joint.name.to_string(), made.kind.clone());
            Sign { name, kind, is_drive: joint.is_drive, arguments: eye.arguments(made), bodies: touched, rate }
        };
        let joints: Vec<Sign> = model.joints.iter().zip(&model.sketch.joints).enumerate().map(sign).collect();
        for (body, at) in joints.iter().flat_map(Sign::points) {
            if let Some(body) = body {
                bodies[body].points.push(at);
            }
        }
        let outputs: Vec<_> = model.sketch.outputs.iter().map(|mark| (mark.name.clone(), mark.at.body, eye.point(mark.at))).collect();
        let scene = Scene { bodies, joints, outputs };
        let is_placed = scene.places().all(Place::is_finite);
        is_placed.then_some(scene)
    }

    /// All places that are named.
    pub(super) fn places(&self) -> impl Iterator<Item = Place> {
        let of_bodies = self.bodies.iter().flat_map(|body| if body.points.is_empty() { vec![body.origin] } else { body.points.clone() });
        of_bodies
            .chain(self.joints.iter().flat_map(|joint| joint.points().map(|(_, at)| at)))
            .chain(self.outputs.iter().map(|output| output.2))
    }

    /// Where a body turns: its hinge on `carrier`, on ground, or on any body; else the origin of its frame.
    pub(super) fn centre(&self, body: Option<usize>, carrier: Option<usize>) -> Place {
        let hinges =
            self.joints.iter().filter(|joint| joint.kind == "revolute").filter_map(|joint| Some((joint.point("P")?, joint.point("Q")?)));
        let own: Vec<(Option<usize>, Place)> = hinges
            .filter_map(|(p, q)| {
                if p.0 == body {
                    Some((q.0, p.1))
                } else if q.0 == body {
                    Some((p.0, q.1))
                } else {
                    None
                }
            })
            .collect();
        let on = |other: Option<usize>| own.iter().find(|(known, _)| *known == other);
        let found = on(carrier).or_else(|| on(None)).or_else(|| own.first());
        found.map(|(_, at)| *at).or_else(|| body.and_then(|body| self.bodies.get(body)).map(|body| body.origin)).unwrap_or_default()
    }

    /// `crank`, or `ground`.
    pub(super) fn name(&self, body: Option<usize>) -> &str {
        body.and_then(|body| self.bodies.get(body)).map_or("ground", |body| &body.name)
    }
}

/// Evaluates what was sketched.
struct Eye<'a> {
    model: &'a Model,
    known: Values<'a>,
    bodies: Vec<Figure>,
}

impl Eye<'_> {
    fn values(&self, exprs: &[Expr]) -> Vec<f64> {
        evaluate(&self.model.sketch.arena, exprs, &self.known)
    }

    fn local(&self, at: Local) -> Place {
        let values = self.values(&at.local);
        place(values[0], values[1])
    }

    fn direction(&self, at: Local) -> Place {
        let local = self.local(at);
        at.body.map_or(local, |body| local.turned(self.bodies[body].angle))
    }

    fn point(&self, at: Local) -> Place {
        at.body.map_or(Place::default(), |body| self.bodies[body].origin) + self.direction(at)
    }

    fn arguments(&self, made: &Made) -> Vec<(String, Seen)> {
        made.arguments.iter().map(|(name, argument)| (name.clone(), self.seen(argument))).collect()
    }

    fn seen(&self, argument: &Argument) -> Seen {
        match argument {
            Argument::Point(at) => Seen::Point(at.body, self.point(*at)),
            Argument::Axis(at) => Seen::Axis(at.body, self.direction(*at).unit()),
            Argument::Body(body) => Seen::Body(*body),
            Argument::Number(value, dim) => Seen::Number(self.values(&[*value])[0], *dim == Dim::LENGTH),
            Argument::Function(value) => Seen::Function(self.turn(*value)),
            Argument::Joint(made) => Seen::Joint(self.arguments(made)),
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
