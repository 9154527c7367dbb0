//! Names of leaves in generated code.

use super::shape::{Column, Shape};
use crate::expr::Leaf;
use crate::model::{Body, Model};
use crate::quantity::{Ambient, Role};
use crate::system::{COSINES, System};
use std::collections::BTreeSet;

/// Names of leaves, in the user's words.
#[derive(Clone)]
pub(crate) struct Words {
    coordinates: Vec<String>,
    /// Names of speeds that are not named by a coordinate.
    speeds: Vec<String>,
    /// Prefixed with `self.` if they are fields.
    parameters: Vec<String>,
    /// Names of all fields, by number of the parameter, by which inputs are named.
    fields: Vec<String>,
}

impl Words {
    /// Names formed from those of bodies, coordinates and parameters.
    pub(crate) fn new(model: &Model, system: &System) -> Words {
        let coordinate = |unknown: usize| {
            let (owner, name) = system.owner_and_name(model, unknown);
            format!("{}_{name}", owner.local)
        };
        let mut coordinates: Vec<String> = (0..system.coordinates.len()).map(coordinate).collect();
        if !system.frames.is_empty() {
            let cosine = |body: &Body, k: usize| format!("{}_a{}{}", body.name.local, k / 3 + 1, k % 3 + 1);
            coordinates.extend(model.bodies.iter().flat_map(|body| (0..COSINES).map(move |k| cosine(body, k))));
            set_apart(&mut coordinates);
        }
        Words { coordinates, speeds: Vec::new(), parameters: fields(model), fields: fields(model) }
    }

    /// Names of declared coordinates and speeds in space.
    pub(crate) fn declared(model: &Model) -> Words {
        let of_body = |body: &Body| {
            let name = body.name.local.clone();
            Role::SPACE.map(|role| format!("{name}_{}", role.name())).to_vec()
        };
        let speeds = |body: &Body| {
            let name = body.name.local.clone();
            ["vx", "vy", "vz", "wx", "wy", "wz"].map(|speed| format!("{name}_{speed}")).to_vec()
        };
        let mut coordinates: Vec<String> = model.bodies.iter().flat_map(of_body).collect();
        coordinates.extend((0..model.space.quantities.len()).map(|number| format!("joint_{number}")));
        let mut names: Vec<String> = coordinates.into_iter().chain(model.bodies.iter().flat_map(speeds)).collect();
        set_apart(&mut names);
        let speeds = names.split_off(names.len() - Ambient::Space.first_speed(model.bodies.len()));
        Words { coordinates: names, speeds, parameters: fields(model), fields: fields(model) }
    }

    /// With additional names for the components of an output.
    pub(super) fn with_outputs(&self, components: usize) -> Words {
        let mut words = self.clone();
        for index in 0..components {
            let mut name = format!("output_{index}");
            while words.coordinates.contains(&name) {
                name.push('_');
            }
            words.coordinates.push(name);
        }
        words
    }

    /// Names for a shape: those of its first piece, without digits.
    pub(super) fn of_shape(&self, shape: &Shape) -> Words {
        let mut coordinates = Vec::new();
        for unknown in &shape.unknowns {
            let plain: String = self.coordinates[unknown.at(0) as usize].chars().filter(|letter| !letter.is_ascii_digit()).collect();
            let plain = plain.replace("__", "_");
            let others = coordinates.iter().filter(|other: &&String| other.starts_with(&plain)).count();
            coordinates.push(if others == 0 { plain } else { format!("{plain}_{}", others + 1) });
        }
        let parameter = |(slot, column): (usize, &Column<u32>)| match column {
            Column::Same(number) => self.parameters[*number as usize].clone(),
            _ => format!("p{slot}"),
        };
        let parameters = shape.parameters.iter().enumerate().map(parameter).collect();
        Words { coordinates, speeds: Vec::new(), parameters, fields: self.fields.clone() }
    }

    /// Names of all leaves but parameters, which no step may use.
    pub(super) fn taken(&self) -> BTreeSet<String> {
        let motion = [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration];
        let of_unknown = |index: usize| motion.map(|leaf| self.leaf(leaf(index as u32)));
        // Data and parameters that are not fields have numbered names like steps, but with other letters.
        (0..self.coordinates.len()).flat_map(of_unknown).chain([self.leaf(Leaf::Time)]).chain(self.speeds.iter().cloned()).collect()
    }

    /// Name of a parameter in generated code.
    pub(crate) fn parameter(&self, number: u32) -> String {
        self.parameters.get(number as usize).cloned().unwrap_or_default()
    }

    /// Name of a leaf in generated code.
    pub(crate) fn leaf(&self, leaf: Leaf) -> String {
        let coordinate = |index: u32| self.coordinates.get(index as usize).cloned().unwrap_or_default();
        match leaf {
            Leaf::Time => "t".to_owned(),
            Leaf::Datum(index) | Leaf::Turn(index) => format!("d{index}"),
            Leaf::Parameter(index) => self.parameters.get(index as usize).cloned().unwrap_or_default(),
            Leaf::Input { number, order } => self.fields.get(number as usize + usize::from(order)).cloned().unwrap_or_default(),
            Leaf::Coordinate(index) => coordinate(index),
            Leaf::Speed(index) => self.speeds.get(index as usize).cloned().unwrap_or_else(|| coordinate(index) + "_rate"),
            Leaf::Acceleration(index) => coordinate(index) + "_acceleration",
            Leaf::Jerk(index) => coordinate(index) + "_jerk",
        }
    }
}

/// The parameters as fields.
fn fields(model: &Model) -> Vec<String> {
    model.parameters.iter().map(|parameter| format!("self.{}", parameter.name)).collect()
}

/// Makes equal names different.
fn set_apart(names: &mut [String]) {
    let mut taken = BTreeSet::new();
    for name in names {
        while !taken.insert(name.clone()) {
            name.push('_');
        }
    }
}
