//! Geometry for the picture in addition to the equations: points in their bodies, and the arguments of joints.
//!
//! All its expressions are in a separate arena, so that drawing a mechanism does not change how it is solved.

use super::{Components, Model};
use crate::expr::{Arena, Expr};
use crate::quantity::Dim;
use proc_macro2::Span;

/// Mechanisms with more bodies are not drawn: their parts could not be distinguished.
pub(crate) const MOST_DRAWN: usize = 200;

/// Declared geometry of a mechanism.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    /// All expressions of the sketch.
    pub arena: Arena,
    /// The declared points of bodies and of ground.
    pub points: Vec<NamedPoint>,
    /// The declared axes of bodies and of ground.
    pub axes: Vec<NamedPoint>,
    /// For each joint or drive, in the order declared, its arguments.
    pub joints: Vec<Instantiation>,
    /// Springs, dampers and stops by name, with the points between which they act.
    pub forces: Vec<(String, Instantiation)>,
    /// The outputs that are points of bodies.
    pub outputs: Vec<NamedPoint>,
    /// In space: for each joint or drive, in the order declared, the rate of its law.
    pub rates: Vec<Option<Expr>>,
}

/// A point or an axis with a name.
#[derive(Clone, Debug)]
pub struct NamedPoint {
    /// Name; for a point of a body without the name of the body.
    pub name: String,
    /// Its place in the declaration.
    pub span: Span,
    /// Position or direction.
    pub at: LocalVector,
}

/// A point or an axis by its local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct LocalVector {
    /// Body that it moves with; `None` for ground.
    pub body: Option<usize>,
    /// Components in the frame of the body, functions of parameters; lengths for a point.
    pub local: Components,
}

/// A constraint with its arguments.
#[derive(Clone, Debug)]
pub struct Instantiation {
    /// Name in the definition of the constraint, even if a `use` item renames it.
    pub kind: String,
    /// Arguments by parameter name; empty for inline equations.
    pub arguments: Vec<(String, JointArgument)>,
}

/// One argument.
#[derive(Clone, Debug)]
pub enum JointArgument {
    /// A point.
    Point(LocalVector),
    /// An axis, of any length.
    Axis(LocalVector),
    /// A body; `None` for ground.
    Body(Option<usize>),
    /// A number with its dimension; in space a function of parameters and time.
    Number(Expr, Dim),
    /// A function of one variable, as an expression in which time stands for the variable.
    Function(Expr),
    /// Another joint; in space also the `angle` between two axes, or the `displacement` of a point along an axis.
    Joint(Instantiation),
}

impl Instantiation {
    /// A freedom, or what is made of no constraint.
    pub(crate) fn without_arguments(kind: &str) -> Instantiation {
        Instantiation { kind: kind.to_owned(), arguments: Vec::new() }
    }

    /// The argument of this name.
    pub(crate) fn argument(&self, name: &str) -> Option<&JointArgument> {
        self.arguments.iter().find(|(known, _)| known == name).map(|(_, argument)| argument)
    }

    /// A spring, a damper or a stop with nothing but its points.
    pub(crate) fn between(mut self) -> Option<Instantiation> {
        self.arguments.retain(|(_, argument)| matches!(argument, JointArgument::Point(_)));
        let kinds = ["spring", "damper", "spring_damper", "constant_force", "gas_spring", "nonlinear_spring", "stop"];
        kinds.contains(&self.kind.as_str()).then_some(self)
    }

    /// The bodies of its points.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = Option<usize>> {
        self.arguments.iter().filter_map(|(_, argument)| if let JointArgument::Point(at) = argument { Some(at.body) } else { None })
    }
}

impl Sketch {
    /// All numbers, and the values of all functions.
    pub(crate) fn exprs(&self) -> (Vec<Expr>, Vec<Expr>) {
        let (mut numbers, mut functions) = (Vec::new(), Vec::new());
        for point in self.points.iter().chain(&self.outputs) {
            numbers.extend(point.at.local.iter());
        }
        numbers.extend(self.rates.iter().flatten());
        let mut pending: Vec<&Instantiation> = self.joints.iter().chain(self.forces.iter().map(|(_, made)| made)).collect();
        while let Some(made) = pending.pop() {
            for (_, argument) in &made.arguments {
                match argument {
                    JointArgument::Point(at) | JointArgument::Axis(at) => numbers.extend(at.local.iter()),
                    JointArgument::Body(_) => {}
                    JointArgument::Number(value, _) => numbers.push(*value),
                    JointArgument::Function(value) => functions.push(*value),
                    JointArgument::Joint(made) => pending.push(made),
                }
            }
        }
        (numbers, functions)
    }
}

impl Model {
    /// The name of a body in a picture.
    pub(crate) fn drawn_name(&self, body: Option<usize>) -> String {
        body.map_or_else(|| "ground".to_owned(), |body| self.bodies[body].name.unraw())
    }
}
