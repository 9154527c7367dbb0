//! From blocks to stages: the expressions that each computes.
//!
//! ```text
//! explicit      q_j = −Φ_i|q_j=0 / (∂Φ_i/∂q_j);  rate and acceleration are its derivatives along the motion
//! block         r(x) = 0  with upstream unknowns known and explicit unknowns substituted
//!               r_x ẋ = −ṙ at ẋ = 0
//!               r_x ẍ = −r̈ at ẍ = 0
//! check         Φ_i, which vanishes if the mechanism is as declared
//! ```

use super::linear;
use super::stage::{Iteration, Origin, Stage};
use super::turning::{put_columns, turning_bodies};
use crate::expr::{Arena, Expr, Jets, Leaf, Lookup, Members, Node, Seed, Substitution, derivative};
use crate::quantity::Dim;
use crate::structure::{Block, Explicit, Structure};
use crate::system::{OutputMotion, System, magnitude};
use std::collections::BTreeSet;

/// A redundant equation that is a number holds up to so many m or rad: 64 roundings of numbers about 1, as where it is evaluated.
const ROUNDED: f64 = 64.0 * f64::EPSILON;

/// Stages of a mechanism whose unknowns all belong to blocks, and outputs with constants substituted.
pub(super) fn stages(
    arena: &mut Arena,
    system: &System,
    structure: &Structure,
    outputs: &[OutputMotion],
) -> (Vec<Stage>, Vec<OutputMotion>) {
    let mut work = StageBuilder {
        arena,
        system,
        jets: Jets::along(Seed::motion(system.rates())),
        constants: Substitution::new(),
        plain: Lookup::default(),
        found: BTreeSet::new(),
        computed: Members::default(),
    };
    let mut stages: Vec<Stage> = structure.blocks.iter().flat_map(|block| work.block(block)).collect();
    let orientations = super::space::orientations(work.arena, system);
    stages.extend(orientations.into_iter().map(|stage| work.with_constants(stage)));
    stages.extend(structure.checked.iter().filter_map(|equation| work.check(*equation)));
    let outputs = outputs.iter().map(|output| work.output(output)).collect();
    (stages, outputs)
}

struct StageBuilder<'a> {
    arena: &'a mut Arena,
    system: &'a System,
    jets: Jets,
    /// Values, rates and accelerations known to be constant.
    constants: Substitution,
    /// Expressions without marks.
    plain: Lookup<Expr, Expr>,
    /// Coordinates of earlier stages.
    found: BTreeSet<u32>,
    /// Expressions that earlier stages in space compute. Only looked up, never iterated.
    computed: Members<Expr>,
}

impl StageBuilder<'_> {
    fn block(&mut self, block: &Block) -> Vec<Stage> {
        let mut stages = Vec::new();
        if !block.iterated.is_empty()
            && let Some(system) = self.system_of(block)
        {
            match linear::solution(self.arena, &system) {
                Some(values) => {
                    for ((unknown, equation), value) in block.iterated.iter().zip(&block.residuals).zip(values) {
                        stages.push(self.computed(*unknown, *equation, value));
                    }
                }
                None => {
                    self.note_computed(&[&system.residuals[..], &system.rates, &system.accelerations].concat());
                    stages.push(Stage::Block(system));
                }
            }
        }
        self.found.extend(block.iterated.iter().map(|unknown| *unknown as u32));
        for explicit in &block.explicit {
            if let Some(value) = self.explicit(explicit) {
                stages.push(self.computed(explicit.unknown, explicit.equation, value));
            }
        }
        stages
    }

    /// A checked equation; `None` if it holds for all parameters.
    fn check(&mut self, equation: usize) -> Option<Stage> {
        let residual = self.constants.of(self.arena, self.system.equations[equation].phi()?);
        // A constant as small as this is a rounding error.
        if self.arena.value(residual).is_some_and(|value| value.abs() <= ROUNDED) {
            return None;
        }
        let [lengths, angles] = [Dim::LENGTH, Dim::ANGLE].map(|dim| self.slope(equation, dim));
        let sizes = [magnitude(self.arena, residual, &[], &self.system.coordinates), lengths, angles];
        Some(Stage::Check { equation, residual, sizes })
    }

    /// Sum of the magnitudes of an equation's derivatives by the unknowns of a dimension.
    fn slope(&mut self, equation: usize, dim: Dim) -> Expr {
        let mut sum = self.arena.integer(0);
        let measures = |unknown: usize| self.system.coordinates[unknown].role.dim() == dim;
        for (_, entry) in self.system.equations[equation].jacobian.iter().filter(|(unknown, _)| measures(*unknown)) {
            let entry = self.constants.of(self.arena, *entry);
            let size = magnitude(self.arena, entry, &[], &self.system.coordinates);
            sum = self.arena.add(sum, size);
        }
        sum
    }

    /// The stage of an unknown with this value.
    fn computed(&mut self, unknown: usize, equation: usize, value: Expr) -> Stage {
        let motion = self.motion(value).map(|expr| self.constants.of(self.arena, expr));
        self.note_constants(unknown, &motion);
        self.note_computed(&motion);
        self.found.insert(unknown as u32);
        Stage::Explicit { unknown, origin: Origin::Equation(equation), motion }
    }

    /// Notes the expressions that a stage in space computes.
    fn note_computed(&mut self, roots: &[Expr]) {
        if self.arena.is_spatial() {
            let new = self.arena.reachable_until(roots, |expr| self.computed.contains(&expr));
            self.computed.extend(new);
        }
    }

    /// Value, rate and acceleration. A component of a vector fixed in a frame may depend on fewer coordinates than the vector: it is
    /// differentiated as written where the vector's rate would need a coordinate that is found later, and where that is shorter.
    fn motion(&mut self, value: Expr) -> [Expr; 3] {
        let motion = self.jets.of(self.arena, value);
        if !self.arena.is_spatial() || self.depends_on_no_more(&motion[1..], value) {
            return motion;
        }
        let plain = self.arena.plain(value, &mut self.plain);
        let plain = self.jets.of(self.arena, plain);
        let [motion, plain] = [motion, plain].map(|motion| motion.map(|expr| self.constants.of(self.arena, expr)));
        let is_possible = self.numbers(&motion).is_subset(&self.numbers(&[value]).union(&self.found).copied().collect());
        if is_possible && self.operations(&motion) < self.operations(&plain) { motion } else { plain }
    }

    /// Operations that earlier stages do not share.
    fn operations(&self, roots: &[Expr]) -> usize {
        let is_operation = |expr: &Expr| !matches!(self.arena.node(*expr), Node::Constant(_) | Node::Leaf(_) | Node::Marked { .. });
        self.arena.reachable_until(roots, |expr| self.computed.contains(&expr)).into_iter().filter(is_operation).count()
    }

    /// The derivative by an unknown, with the same care.
    fn slope_by(&mut self, value: Expr, unknown: usize) -> Expr {
        let by = Leaf::Coordinate(unknown as u32);
        let slope = derivative(self.arena, value, by);
        if !self.arena.is_spatial() || self.depends_on_no_more(&[slope], value) {
            return slope;
        }
        let plain = self.arena.plain(value, &mut self.plain);
        derivative(self.arena, plain, by)
    }

    /// True if some derivatives of a value depend on no coordinates, nor on their rates, on which the value does not depend.
    fn depends_on_no_more(&self, derivatives: &[Expr], value: Expr) -> bool {
        self.numbers(derivatives).is_subset(&self.numbers(&[value]))
    }

    /// The coordinates on which expressions depend, by themselves or by their rates.
    fn numbers(&self, roots: &[Expr]) -> BTreeSet<u32> {
        let number = |leaf: Leaf| match leaf {
            Leaf::Coordinate(number) | Leaf::Speed(number) | Leaf::Acceleration(number) | Leaf::Jerk(number) => Some(number),
            Leaf::Time | Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_) | Leaf::Turn(_) => None,
        };
        self.arena.leaves_of(roots).into_iter().filter_map(number).collect()
    }

    /// A stage with constants substituted.
    fn with_constants(&mut self, mut stage: Stage) -> Stage {
        if let Stage::Explicit { motion, .. } = &mut stage {
            *motion = motion.map(|expr| self.constants.of(self.arena, expr));
        }
        stage
    }

    /// An output with constants substituted.
    fn output(&mut self, output: &OutputMotion) -> OutputMotion {
        let component = |motion: &[Expr; 3]| motion.map(|expr| self.constants.of(self.arena, expr));
        OutputMotion { components: output.components.iter().map(component).collect() }
    }

    /// Substitutes constants in everything that follows: a pin on ground costs nothing.
    fn note_constants(&mut self, unknown: usize, motion: &[Expr; 3]) {
        let leaves = [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration];
        for (leaf, expr) in leaves.into_iter().zip(motion) {
            if self.arena.as_constant(*expr).is_some() {
                self.constants.replace(leaf(unknown as u32), *expr);
            }
        }
    }

    /// If all right-hand sides are zero, sets the derivatives of some unknowns to zero in everything that follows.
    fn note_rest(&mut self, sides: &[Expr], unknowns: &[usize], rate: fn(u32) -> Leaf) {
        let zero = self.arena.integer(0);
        if sides.iter().all(|side| *side == zero) {
            for unknown in unknowns {
                self.constants.replace(rate(*unknown as u32), zero);
            }
        }
    }

    /// Value of an explicit unknown in terms of the others.
    fn explicit(&mut self, explicit: &Explicit) -> Option<Expr> {
        let equation = &self.system.equations[explicit.equation];
        let coefficient = equation.jacobian.iter().find(|(unknown, _)| *unknown == explicit.unknown)?.1;
        let zero = self.arena.integer(0);
        let mut without = Substitution::new();
        without.replace(Leaf::Coordinate(explicit.unknown as u32), zero);
        let rest = without.of(self.arena, equation.phi()?);
        let quotient = self.arena.div(rest, coefficient);
        Some(self.arena.neg(quotient))
    }

    fn system_of(&mut self, block: &Block) -> Option<Iteration> {
        let mut inside = Substitution::new();
        for explicit in &block.explicit {
            let value = self.explicit(explicit)?;
            let value = inside.of(self.arena, value);
            inside.replace(Leaf::Coordinate(explicit.unknown as u32), value);
        }
        let (mut still, mut unaccelerated) = (Substitution::new(), Substitution::new());
        let zero = self.arena.integer(0);
        for unknown in &block.iterated {
            still.replace(Leaf::Speed(*unknown as u32), zero);
            unaccelerated.replace(Leaf::Acceleration(*unknown as u32), zero);
        }
        let mut found = Iteration {
            unknowns: block.iterated.clone(),
            equations: block.residuals.clone(),
            residuals: Vec::new(),
            jacobian: Vec::new(),
            quaternions: Vec::new(),
            sizes: Vec::new(),
            elimination: None,
            rates: Vec::new(),
            accelerations: Vec::new(),
            jerks: Vec::new(),
        };
        let bodies = turning_bodies(self.arena, self.system, block);
        let is_turned = |column: usize| bodies.iter().any(|body| body.columns.contains(&column));
        let mut seconds = Vec::new();
        for equation in &block.residuals {
            let residual = inside.of(self.arena, self.system.equations[*equation].phi()?);
            let gathered = self.arena.gathered(residual);
            let [own, first, second] = self.motion(residual).map(|expr| self.constants.of(self.arena, expr));
            // The rates share the arms of a body with the positions that follow; in the rows that are iterated a body has one arm.
            let residual = if gathered == residual { own } else { self.constants.of(self.arena, gathered) };
            let entry = |(column, unknown)| if is_turned(column) { zero } else { self.slope_by(residual, unknown) };
            let row = block.iterated.iter().copied().enumerate().map(entry).collect();
            found.jacobian.push(row);
            let first = still.of(self.arena, first);
            found.rates.push(self.arena.neg(first));
            seconds.push(second);
            found.sizes.push(magnitude(self.arena, residual, &block.iterated, &self.system.coordinates));
            found.residuals.push(residual);
        }
        if put_columns(self.arena, &bodies, &mut found, &self.found).is_none() {
            for (row, residual) in found.jacobian.iter_mut().zip(&found.residuals) {
                for column in bodies.iter().flat_map(|body| body.columns) {
                    row[column] = self.slope_by(*residual, block.iterated[column]);
                }
            }
        }
        // If every right-hand side is zero the block is at rest: substitute zero for its rates everywhere.
        self.note_rest(&found.rates, &block.iterated, Leaf::Speed);
        for second in seconds {
            let second = self.constants.of(self.arena, second);
            let second = unaccelerated.of(self.arena, second);
            found.accelerations.push(self.arena.neg(second));
        }
        self.note_rest(&found.accelerations, &block.iterated, Leaf::Acceleration);
        Some(found)
    }
}
