//! What leaves are called in generated code.

use super::shape::{Column, Shape};
use crate::expr::Leaf;
use crate::model::Model;
use crate::system::System;
use std::collections::BTreeSet;

/// The user's words for leaves.
#[derive(Clone)]
pub(crate) struct Words {
    coordinates: Vec<String>,
    /// `self.` before those that are fields.
    parameters: Vec<String>,
}

impl Words {
    /// From the names of bodies, coordinates and parameters.
    pub(crate) fn new(model: &Model, system: &System) -> Words {
        let coordinate = |unknown: &crate::system::Coordinate| format!("{}_{}", model.bodies[unknown.body].name.local, unknown.role.name());
        Words {
            coordinates: system.coordinates.iter().map(coordinate).collect(),
            parameters: model.parameters.iter().map(|parameter| format!("self.{}", parameter.name)).collect(),
        }
    }

    /// With words for the components of an output.
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

    /// The words for a shape: what its first piece is called, without the numbers.
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
        Words { coordinates, parameters: shape.parameters.iter().enumerate().map(parameter).collect() }
    }

    /// The names of all leaves but parameters, which no step may have.
    pub(super) fn taken(&self) -> BTreeSet<String> {
        let motion = [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration];
        let of_unknown = |index: usize| motion.map(|leaf| self.leaf(leaf(index as u32)));
        // Data and parameters that are no fields have numbered names, as steps have, but with letters of their own.
        (0..self.coordinates.len()).flat_map(of_unknown).chain([self.leaf(Leaf::Time)]).collect()
    }

    /// The parameter of this number in generated code.
    pub(crate) fn parameter(&self, number: u32) -> String {
        self.parameters.get(number as usize).cloned().unwrap_or_default()
    }

    /// The name of a leaf in generated code.
    pub(crate) fn leaf(&self, leaf: Leaf) -> String {
        let coordinate = |index: u32| self.coordinates.get(index as usize).cloned().unwrap_or_default();
        match leaf {
            Leaf::Time => "t".to_owned(),
            Leaf::Datum(index) => format!("d{index}"),
            Leaf::Parameter(index) => self.parameters.get(index as usize).cloned().unwrap_or_default(),
            Leaf::Coordinate(index) => coordinate(index),
            Leaf::Speed(index) => coordinate(index) + "_rate",
            Leaf::Acceleration(index) => coordinate(index) + "_acceleration",
        }
    }
}
