//! Explicit coordinates as functions of the others.
//!
//! ```text
//! q_e = h(q, t)      u_e = Σ E_er u_r + ν_e      u̇_e = Σ E_er u̇_r + γ_e
//! ```

use super::{Masses, MotionRow, squares};
use crate::expr::{Arena, Expr, Leaf, Substitution};
use crate::system::{Equation, has_choices};
use std::collections::{BTreeMap, BTreeSet};

/// Coordinates written in those that are integrated.
pub(super) struct Embedding<'a> {
    arena: &'a mut Arena,
    explicit: BTreeMap<usize, Embedded>,
    /// Coordinates that may be integrated.
    coordinates: Vec<usize>,
    /// Rows that were solved, each for a coordinate.
    solved: Vec<(usize, usize)>,
    /// Replaces explicit coordinates, speeds and accelerations.
    substitution: Substitution,
    /// Whether a value may depend on a coordinate without a derivative by it, by a choice.
    has_choices: bool,
}

/// An explicit coordinate.
#[derive(Clone)]
struct Embedded {
    value: Expr,
    motion: Affine,
}

/// Speed and acceleration of a coordinate, affine in those of others.
#[derive(Clone)]
struct Affine {
    factors: BTreeMap<usize, Expr>,
    nu: Expr,
    gamma: Expr,
}

impl Embedding<'_> {
    pub(super) fn new(arena: &mut Arena, coordinates: Vec<usize>) -> Embedding<'_> {
        Embedding {
            arena,
            explicit: BTreeMap::new(),
            coordinates,
            solved: Vec::new(),
            substitution: Substitution::new(),
            has_choices: false,
        }
    }

    /// Solves the same rows for the same coordinates as another one.
    pub(super) fn follow(&mut self, solved: &[(usize, usize)], rows: &[Equation]) {
        self.has_choices = has_choices(self.arena, rows);
        solved.iter().for_each(|(row, pivot)| self.solve(&rows[*row], *pivot));
    }

    /// Rows that were solved, each for a coordinate, in their order.
    pub(super) fn solved(&self) -> Vec<(usize, usize)> {
        self.solved.clone()
    }

    /// Solves rows for coordinates that stand alone in them, those first that offer the fewest, and of these those that depend on the fewest
    /// speeds, so that bodies are reached on the shortest way from ground; returns the rows that are left.
    ///
    /// * `pivots`: given, for each row the coordinates with a factor that is never zero.
    pub(super) fn eliminate(&mut self, rows: &[Equation], pivots: &[Vec<usize>]) -> Vec<usize> {
        self.has_choices = has_choices(self.arena, rows);
        let mut left: Vec<usize> = (0..rows.len()).collect();
        loop {
            let offers = |row: &usize| {
                let offers: Vec<usize> = pivots[*row].iter().copied().filter(|pivot| self.stands_alone(&rows[*row], *pivot)).collect();
                (!offers.is_empty()).then(|| (offers.len(), self.speeds(&rows[*row]), *row, offers))
            };
            let Some((_, _, row, offers)) = left.iter().filter_map(offers).min() else { return left };
            // Bodies are reached outwards: of two new ones the later follows the earlier.
            if let Some(pivot) = offers.into_iter().max() {
                self.solve(&rows[row], pivot);
                self.solved.push((row, pivot));
            }
            left.retain(|other| *other != row);
        }
    }

    /// How many speeds of coordinates that are not explicit a row depends on.
    fn speeds(&self, row: &Equation) -> usize {
        let mut speeds = BTreeSet::new();
        for (unknown, _) in &row.jacobian {
            match self.explicit.get(unknown) {
                Some(explicit) => speeds.extend(explicit.motion.factors.keys().copied()),
                None => _ = speeds.insert(*unknown),
            }
        }
        speeds.len()
    }

    /// True if a coordinate is not explicit, and no explicit coordinate of the row depends on it.
    fn stands_alone(&self, row: &Equation, pivot: usize) -> bool {
        let others = row.jacobian.iter().map(|(other, _)| other).chain(&row.read).filter_map(|other| self.explicit.get(other));
        !self.explicit.contains_key(&pivot) && !others.into_iter().any(|other| self.depends(other, pivot))
    }

    /// True if an explicit coordinate depends on another one.
    fn depends(&self, explicit: &Embedded, other: usize) -> bool {
        let reads = || self.arena.leaves(explicit.value).contains(&Leaf::Coordinate(other as u32));
        explicit.motion.factors.contains_key(&other) || self.has_choices && reads()
    }

    /// Solves a row for a coordinate.
    fn solve(&mut self, row: &Equation, pivot: usize) {
        let (Some(phi), Some((_, slope))) = (row.phi(), row.jacobian.iter().find(|(unknown, _)| *unknown == pivot)) else { return };
        let zero = self.arena.integer(0);
        let mut without = Substitution::new();
        without.replace(Leaf::Coordinate(pivot as u32), zero);
        let rest = without.of(self.arena, phi);
        let (rest, slope) = (self.of(rest), self.of(*slope));
        let quotient = self.arena.div(rest, slope);
        let value = self.arena.neg(quotient);
        let mut motion = self.affine(row);
        motion.factors.remove(&pivot);
        for factor in motion.factors.values_mut() {
            let quotient = self.arena.div(*factor, slope);
            *factor = self.arena.neg(quotient);
        }
        motion.nu = self.arena.div(motion.nu, slope);
        motion.gamma = self.arena.div(motion.gamma, slope);
        self.explicit.insert(pivot, Embedded { value, motion });
        self.rewrite_by(pivot);
    }

    /// Writes earlier explicit coordinates by a new one.
    fn rewrite_by(&mut self, pivot: usize) {
        let new = self.explicit[&pivot].clone();
        self.note(pivot, &new);
        let dependent: Vec<usize> =
            self.explicit.iter().filter(|(_, other)| self.depends(other, pivot)).map(|(number, _)| *number).collect();
        for number in dependent {
            let mut other = self.explicit[&number].clone();
            other.value = self.of(other.value);
            let factor = other.motion.factors.remove(&pivot);
            for factor in other.motion.factors.values_mut() {
                *factor = self.of(*factor);
            }
            [other.motion.nu, other.motion.gamma] = [other.motion.nu, other.motion.gamma].map(|expr| self.of(expr));
            if let Some(factor) = factor {
                let factor = self.of(factor);
                self.add(&mut other.motion, factor, &new.motion);
            }
            self.note(number, &other);
            self.explicit.insert(number, other);
        }
    }

    /// sum + factor · motion
    fn add(&mut self, sum: &mut Affine, factor: Expr, motion: &Affine) {
        let zero = self.arena.integer(0);
        for (unknown, of_unknown) in &motion.factors {
            let term = self.arena.mul(factor, *of_unknown);
            let entry = sum.factors.entry(*unknown).or_insert(zero);
            *entry = self.arena.add(*entry, term);
        }
        let [nu, gamma] = [motion.nu, motion.gamma].map(|part| self.arena.mul(factor, part));
        sum.nu = self.arena.add(sum.nu, nu);
        sum.gamma = self.arena.add(sum.gamma, gamma);
    }

    /// Enters a coordinate into the substitution.
    fn note(&mut self, number: usize, explicit: &Embedded) {
        let [value, rate, acceleration] = self.written(explicit);
        for (leaf, expr) in [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration].into_iter().zip([value, rate, acceleration]) {
            self.substitution.replace(leaf(number as u32), expr);
        }
    }

    fn written(&mut self, explicit: &Embedded) -> [Expr; 3] {
        let Affine { factors, nu, gamma } = &explicit.motion;
        let (mut rate, mut acceleration) = (*nu, *gamma);
        for (unknown, factor) in factors {
            let [u, a] = [Leaf::Speed(*unknown as u32), Leaf::Acceleration(*unknown as u32)].map(|leaf| self.arena.leaf(leaf));
            let [u, a] = [u, a].map(|leaf| self.arena.mul(*factor, leaf));
            (rate, acceleration) = (self.arena.add(rate, u), self.arena.add(acceleration, a));
        }
        [explicit.value, rate, acceleration]
    }

    /// An expression in the integrated coordinates.
    pub(super) fn of(&mut self, expr: Expr) -> Expr {
        self.substitution.of(self.arena, expr)
    }

    /// Factors, ν and γ of a row, in the integrated coordinates.
    fn affine(&mut self, row: &Equation) -> Affine {
        let zero = self.arena.integer(0);
        let mut sum = Affine { factors: BTreeMap::new(), nu: self.of(row.nu), gamma: self.of(row.gamma) };
        for (unknown, entry) in &row.jacobian {
            let entry = self.of(*entry);
            match self.explicit.get(unknown).map(|explicit| explicit.motion.clone()) {
                Some(mut motion) => {
                    // ν and γ are right-hand sides: their terms change sign.
                    [motion.nu, motion.gamma] = [motion.nu, motion.gamma].map(|part| self.arena.neg(part));
                    self.add(&mut sum, entry, &motion);
                }
                None => {
                    let old = *sum.factors.entry(*unknown).or_insert(zero);
                    let new = self.arena.add(old, entry);
                    sum.factors.insert(*unknown, new);
                }
            }
        }
        sum
    }

    /// A row in the integrated coordinates.
    pub(super) fn row(&mut self, equation: &Equation) -> MotionRow {
        let zero = self.arena.integer(0);
        let Affine { factors, nu, gamma } = self.affine(equation);
        let phi = equation.phi().map(|phi| self.of(phi));
        let jacobian = self.integrated().iter().map(|unknown| factors.get(unknown).copied().unwrap_or(zero)).collect();
        MotionRow { power: equation.dim.power_of_length(), of: (equation.joint, equation.row), phi, jacobian, nu, gamma }
    }

    /// Coordinates that are not explicit.
    pub(super) fn integrated(&self) -> Vec<usize> {
        self.coordinates.iter().copied().filter(|unknown| !self.explicit.contains_key(unknown)).collect()
    }

    /// Value, rate and acceleration of a coordinate.
    pub(super) fn motion(&mut self, unknown: usize) -> [Expr; 3] {
        match self.explicit.get(&unknown).cloned() {
            Some(explicit) => self.written(&explicit),
            None => [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration].map(|leaf| self.arena.leaf(leaf(unknown as u32))),
        }
    }

    /// Derivatives of the speed of a coordinate by the integrated ones.
    fn factors(&mut self, unknown: usize) -> BTreeMap<usize, Expr> {
        match self.explicit.get(&unknown) {
            Some(explicit) => explicit.motion.factors.clone(),
            None => BTreeMap::from([(unknown, self.arena.integer(1))]),
        }
    }

    /// Eᵀ M E, the lower triangle row by row.
    pub(super) fn mass(&mut self, masses: &Masses) -> Vec<Expr> {
        let zero = self.arena.integer(0);
        // M E, by speed and integrated speed
        let mut right: BTreeMap<(usize, usize), Expr> = BTreeMap::new();
        for (&(row, column), &entry) in masses {
            let entry = self.of(entry);
            for (unknown, factor) in self.factors(column) {
                let term = self.arena.mul(entry, factor);
                let sum = right.entry((row, unknown)).or_insert(zero);
                *sum = self.arena.add(*sum, term);
            }
        }
        let integrated = self.integrated();
        let mut both: BTreeMap<(usize, usize), Expr> = BTreeMap::new();
        for ((row, unknown), entry) in right {
            for (other, factor) in self.factors(row) {
                if other >= unknown {
                    let term = self.arena.mul(factor, entry);
                    let sum = both.entry((other, unknown)).or_insert(zero);
                    *sum = self.arena.add(*sum, term);
                }
            }
        }
        let lower = |row: usize| integrated[..=row].iter().map(move |column| (row, *column)).collect::<Vec<_>>();
        let places = (0..integrated.len()).flat_map(lower);
        let entry = |(row, column): (usize, usize)| both.get(&(integrated[row], column)).copied().unwrap_or(zero);
        places.map(|place| squares::folded(self.arena, entry(place))).collect()
    }

    /// Eᵀ f at u̇ = 0
    pub(super) fn forces(&mut self, forces: &[Expr]) -> Vec<Expr> {
        let zero = self.arena.integer(0);
        let integrated = self.integrated();
        let mut still = Substitution::new();
        for unknown in &integrated {
            still.replace(Leaf::Acceleration(*unknown as u32), zero);
        }
        let mut sums: BTreeMap<usize, Expr> = BTreeMap::new();
        for (row, force) in forces.iter().enumerate() {
            let force = self.of(*force);
            let force = still.of(self.arena, force);
            for (unknown, factor) in self.factors(row) {
                let term = self.arena.mul(factor, force);
                let sum = sums.entry(unknown).or_insert(zero);
                *sum = self.arena.add(*sum, term);
            }
        }
        integrated.iter().map(|unknown| sums.get(unknown).copied().unwrap_or(zero)).collect()
    }
}
