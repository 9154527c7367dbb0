//! The mechanism in one configuration: every point where it lies in ground, in m, with y upwards.

use super::plane::Place;

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
    pub(super) arguments: Vec<(String, PlacedArgument)>,
    /// The bodies whose coordinates stand in its equations.
    pub(super) bodies: Vec<usize>,
    /// The rate of a drive's law, in SI.
    pub(super) rate: f64,
}

/// An argument where it lies; `None` is ground.
#[derive(Clone, Debug)]
pub(super) enum PlacedArgument {
    Point(Option<usize>, Place),
    /// With unit length.
    Axis(Option<usize>, Place),
    Body(Option<usize>),
    /// A number in SI, and whether it is a length.
    Number(f64, bool),
    /// Values over one turn, at equal steps.
    Function(Vec<f64>),
    Joint(Vec<(String, PlacedArgument)>),
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
            PlacedArgument::Body(body) if known == name => Some(*body),
            _ => None,
        })
    }

    /// An argument that is a number, and whether it is a length.
    pub(super) fn number(&self, name: &str) -> Option<(f64, bool)> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            PlacedArgument::Number(value, is_length) if known == name && value.is_finite() => Some((*value, *is_length)),
            _ => None,
        })
    }

    /// The values of an argument that is a function, if all are known.
    pub(super) fn function(&self, name: &str) -> Option<&[f64]> {
        self.arguments.iter().find_map(|(known, seen)| match seen {
            PlacedArgument::Function(values) if known == name && values.iter().all(|value| value.is_finite()) => Some(values.as_slice()),
            _ => None,
        })
    }

    /// All arguments that are points.
    pub(super) fn points(&self) -> impl Iterator<Item = (Option<usize>, Place)> {
        self.arguments.iter().filter_map(|(_, seen)| if let PlacedArgument::Point(body, at) = seen { Some((*body, *at)) } else { None })
    }
}

pub(super) fn point(arguments: &[(String, PlacedArgument)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        PlacedArgument::Point(body, at) if known == name => Some((*body, *at)),
        _ => None,
    })
}

pub(super) fn axis(arguments: &[(String, PlacedArgument)], name: &str) -> Option<(Option<usize>, Place)> {
    arguments.iter().find_map(|(known, seen)| match seen {
        PlacedArgument::Axis(body, along) if known == name => Some((*body, *along)),
        _ => None,
    })
}

impl Scene {
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
