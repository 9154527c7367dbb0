//! Reports of an end of travel or a crossing of branches.

use super::chain::Chain;
use super::turn::Event;
use crate::assembly::bodies_in_line;
use crate::assembly::loops::Loops;
use crate::assembly::order::Upstream;
use crate::diag::{AssemblyFact, Driven, Range};
use crate::expr::{Binary, Expr, Leaf, Node};
use crate::expr::{Values, evaluate};
use crate::numeric::Numeric;
use crate::quantity::Dim;
use crate::structure::Structure;
use std::collections::BTreeSet;

pub(super) struct EndReport<'a, 'b> {
    pub(super) numeric: &'a Numeric<'b>,
    pub(super) structure: &'a Structure,
    pub(super) chain: &'a Chain<'b>,
    /// Intended end of the motion along the path, in s.
    pub(super) until: f64,
}

impl EndReport<'_, '_> {
    /// Reports the loop that cannot stay closed, at the drive that moves it to the end of travel.
    pub(super) fn end(&self, place: &Event) -> Option<(Range, AssemblyFact)> {
        let block = self.chain.members[place.member].block;
        let time = self.chain.path.sign * place.at;
        let (known, declared) = (Values { time, ..self.numeric.known }, self.numeric.declared.clone());
        let numeric = self.numeric.with(known, declared);
        let q = self.completed(&numeric, &place.q);
        let upstream = Upstream::new(&numeric, self.structure);
        let loops = Loops { numeric: &numeric, structure: self.structure, upstream: &upstream };
        let joint_of = |equation: &usize| numeric.system.equations[*equation].joint;
        let joints: BTreeSet<usize> = loops.around(block).equations.iter().map(joint_of).collect();
        let is_drive = |joint: &usize| numeric.model.joints[*joint].is_drive;
        let name = |joint: usize| numeric.model.joints[joint].name.to_string();
        let own = self.structure.blocks[block].parts().1;
        let joint = joints.iter().rev().copied().find(|joint| !is_drive(joint)).or_else(|| own.last().map(joint_of))?;
        let drives = self.drives(block, &upstream);
        let in_line = bodies_in_line(&numeric, self.structure, block, &q);
        let fact = AssemblyFact::MotionEnds {
            joint: name(joint),
            driven: drives.iter().map(|drive| self.driven(*drive, time, &q)).collect(),
            time,
            in_line: in_line.into_iter().flatten().map(|body| numeric.model.bodies[body].name.to_string()).collect(),
            until: self.until,
            declared: numeric.model.range.as_ref().map(|range| [range.from, range.to]),
        };
        let blamed = drives.first().copied().unwrap_or(joint);
        Some(((&numeric.model.joints[blamed].name).into(), fact))
    }

    /// A line of text on a crossing of branches.
    pub(super) fn crossing(&self, place: &Event) -> Option<String> {
        let block = self.chain.members[place.member].block;
        let time = self.chain.path.sign * place.at;
        let upstream = Upstream::new(self.numeric, self.structure);
        let driven = self.drives(block, &upstream).iter().map(|drive| self.driven(*drive, time, &place.q)).collect();
        Some(AssemblyFact::Crosses { driven, time }.to_string())
    }

    /// The coordinates at an event, completed with the computed coordinates on which no followed block depends.
    fn completed(&self, numeric: &Numeric, q: &[f64]) -> Vec<f64> {
        let mut q = q.to_vec();
        let followed: BTreeSet<usize> = self.chain.members.iter().map(|member| member.block).collect();
        for (index, block) in self.structure.blocks.iter().enumerate() {
            if block.iterated.is_empty() && !followed.contains(&index) {
                let (values, _) = numeric.nearest(block, &q);
                block.parts().0.iter().zip(values).for_each(|(unknown, value)| q[*unknown] = value);
            }
        }
        q
    }

    /// Drives on which a block depends, its own included.
    fn drives(&self, block: usize, upstream: &Upstream) -> Vec<usize> {
        let blocks = upstream.all(block).into_iter().chain([block]);
        let equations = blocks.flat_map(|block| self.structure.blocks[block].parts().1);
        let joints: BTreeSet<usize> = equations.map(|equation| self.numeric.system.equations[equation].joint).collect();
        joints.into_iter().filter(|joint| self.numeric.model.joints[*joint].is_drive).collect()
    }

    /// The coordinate that a drive moves and its value, or the value that the drive prescribes.
    fn driven(&self, drive: usize, time: f64, q: &[f64]) -> Driven {
        let (system, model) = (&self.numeric.system, &self.numeric.model);
        let name = model.joints[drive].name.to_string();
        let mut rows = system.equations.iter().filter(|equation| equation.joint == drive);
        let (Some(row), None) = (rows.next(), rows.next()) else { return Driven { name, coordinate: None, value: None } };
        if let [(unknown, entry)] = row.jacobian.as_slice()
            && system.arena.as_constant(*entry).is_some()
        {
            let unknown = (&system.coordinates[*unknown], q[*unknown]);
            let name = model.bodies[unknown.0.body].name.to_string();
            return Driven { name, coordinate: Some(unknown.0.role), value: Some((unknown.1, unknown.0.role.dim())) };
        }
        let value = row.phi().and_then(|phi| self.demand(phi, row.dim, time));
        Driven { name, coordinate: None, value }
    }

    /// Value of the only term of an equation that depends on time, or its root if it is the square of a length.
    fn demand(&self, phi: Expr, dim: Dim, time: f64) -> Option<(f64, Dim)> {
        let arena = &self.numeric.system.arena;
        let is_of_time = |expr: Expr| {
            let leaves = arena.leaves(expr);
            leaves.contains(&Leaf::Time) && leaves.iter().all(|leaf| matches!(leaf, Leaf::Time | Leaf::Parameter(_)))
        };
        // Terms of a sum, from the outside inwards.
        let mut pending = vec![phi];
        let mut found = Vec::new();
        while let Some(expr) = pending.pop() {
            match *arena.node(expr) {
                _ if is_of_time(expr) => found.push(expr),
                Node::Binary(Binary::Add | Binary::Sub, a, b) => pending.extend([a, b]),
                _ if arena.leaves(expr).contains(&Leaf::Time) => return None,
                _ => {}
            }
        }
        let [term] = found.as_slice() else { return None };
        let (term, dim) = match *arena.node(*term) {
            Node::Binary(Binary::Mul, a, b) if a == b && dim == Dim::LENGTH.times(Dim::LENGTH) => (a, Dim::LENGTH),
            _ => (*term, dim),
        };
        let value = evaluate(arena, &[term], &Values { time, ..self.numeric.known })[0];
        ((dim == Dim::LENGTH || dim == Dim::ANGLE) && value.is_finite()).then_some((value, dim))
    }
}
