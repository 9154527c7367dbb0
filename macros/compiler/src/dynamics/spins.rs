//! Accelerations in closed form by components of ω of the bodies that are free to turn.
//!
//! ```text
//! ω = h vec(ē ė),                                 h = 2/(e · e)                        in the axes of the body
//! ë = e (−(ė · ė)/(e · e), (ω̇ + h (e · ė) ω)/2)   from e · ë = −ė · ė and ω̇ = h vec(ē ë) − h (e · ė) ω
//! ω = h vec(ė ē),   ë = (−(ė · ė)/(e · e), (ω̇ + h (e · ė) ω)/2) e                      in the axes of ground
//! ω = B w,   ω̇ = B (ẇ + ω_B × w)                  w: the components of ω in the axes B of another body, which turn with ω_B
//! ```
//!
//! e is the quaternion of a body, products are those of quaternions. e · ė is zero at both ends of a step, but not between them. It is not left
//! out there, because stages of the same step for which this closed form is not good have it too, and all stages must follow one equation.

use super::elimination::{self, Accelerations};
use super::embedding::Embedding;
use super::order::{Grouping, OpenRows};
use super::trust::Trust;
use super::{MotionRow, freedoms, in_general, masses, plain, power_of_two};
use crate::assembly::Assembly;
use crate::expr::{Arena, Expr, Leaf, Lookup, Spin, SpinAxes, Substitution, Triple, Values, combination, cross, dot, evaluate};
use crate::numeric::Numeric;
use crate::quantity::{Axis, Role};
use crate::system::EquationsBySpins;

/// Quaternions of orientations; those of up to four bodies are exchanges of their components. Some axes of bodies coincide, others are at right
/// angles: there the determinants vanish that are large elsewhere by chance.
const ORIENTATIONS: [[f64; 4]; 3] = [[0.1, 0.5, 0.7, 0.5], [0.5, 0.7, -0.5, 0.1], [0.7, -0.1, 0.5, -0.5]];

/// Equations of motion by ω.
#[derive(Clone, Debug)]
pub(super) struct BySpins {
    /// Numbers of the speeds.
    speeds: Vec<usize>,
    rows: Vec<MotionRow>,
    initial: Vec<MotionRow>,
    mass: Vec<Expr>,
    forces: Vec<Expr>,
    spins: Vec<Spin>,
}

impl BySpins {
    /// Equations without marks.
    pub(super) fn plain(arena: &mut Arena, known: &mut Lookup<Expr, Expr>, equations: &EquationsBySpins) -> EquationsBySpins {
        let EquationsBySpins { equations, of_speeds, forces, spins } = equations;
        EquationsBySpins {
            equations: plain(arena, known, equations),
            of_speeds: plain(arena, known, of_speeds),
            forces: forces.iter().map(|force| arena.plain(*force, known)).collect(),
            spins: spins.clone(),
        }
    }

    /// Eliminates explicit coordinates.
    ///
    /// * `is_solved`: given, true for the number of an equation between positions that counts.
    /// * `explicit`: given, rows among those that count, each with the coordinate that it is solved for.
    pub(super) fn new(
        arena: &mut Arena,
        equations: &EquationsBySpins,
        is_solved: impl Fn(&usize) -> bool,
        explicit: &[(usize, usize)],
    ) -> BySpins {
        let EquationsBySpins { equations, of_speeds, forces, spins } = equations;
        let constraints: Vec<_> = (0..equations.len()).filter(|row| is_solved(row)).map(|row| equations[row].clone()).collect();
        let masses = masses(arena, forces);
        let is_speed = |number: &usize| !spins.iter().any(|spin| spin.first as usize + 3 == *number);
        let mut embedding = Embedding::new(arena, (0..forces.len()).filter(is_speed).collect());
        embedding.follow(explicit, &constraints);
        let is_left = |row: &usize| !explicit.iter().any(|(solved, _)| solved == row) && !constraints[*row].jacobian.is_empty();
        let left = (0..constraints.len()).filter(is_left).map(|row| &constraints[row]);
        let rows = left.chain(of_speeds.iter().filter(|equation| !equation.is_initial));
        let rows = rows.map(|equation| embedding.row(equation)).collect();
        let initial = equations.iter().chain(of_speeds).filter(|equation| equation.is_initial);
        let initial = initial.map(|equation| embedding.row(equation)).collect();
        let (mass, forces) = (embedding.mass(&masses), embedding.forces(forces));
        BySpins { speeds: embedding.integrated(), rows, initial, mass, forces, spins: spins.clone() }
    }

    /// Accelerations of the integrated coordinates, by an order of elimination that is good where the mechanism is assembled.
    pub(super) fn accelerations(
        self,
        arena: &mut Arena,
        (integrated, redundant): (&[usize], &[MotionRow]),
        numeric: &Numeric,
        assembly: &Assembly,
    ) -> Option<Accelerations> {
        let zero = arena.integer(0);
        let scales: Vec<f64> = self.speeds.iter().map(|speed| self.scale(numeric, *speed)).collect();
        let numbers = self.numbers(arena, numeric, (&assembly.start, &scales));
        let elsewhere = ORIENTATIONS.map(|orientation| {
            let mut coordinates = assembly.start.clone();
            for (number, spin) in self.spins.iter().enumerate() {
                let turned = |k: usize| orientation[(k + number) % orientation.len()];
                (0..4).for_each(|k| coordinates[spin.first as usize + k] = turned(k));
            }
            self.numbers(arena, numeric, (&coordinates, &scales))
        });
        let joints: Vec<usize> = self.rows.iter().map(|row| row.of.0).collect();
        let (freedoms, triples) = (freedoms(&self.initial, zero), self.triples(numeric));
        let is_zero = |row: usize, column: usize| self.rows[row].jacobian[column] == zero;
        let columns = Grouping { joints: &joints, freedoms: &freedoms, triples: &triples };
        let order = OpenRows::new(&numbers, is_zero, columns, Trust::OF_SPINS).also_in(elsewhere.to_vec()).order()?;
        let lengths: Vec<Expr> = scales.into_iter().map(|scale| power_of_two(arena, scale)).collect();
        let in_general = in_general(arena, &self.rows, redundant, numeric.size);
        let found =
            elimination::accelerations(arena, (&self.rows, &self.mass, &self.forces), &order, &lengths, (Trust::OF_SPINS, in_general));
        Some(self.by_coordinates(arena, integrated, found))
    }

    /// J at these coordinates, in comparable units.
    fn numbers(&self, arena: &Arena, numeric: &Numeric, (coordinates, scales): (&[f64], &[f64])) -> Vec<Vec<f64>> {
        let zeros = vec![0.0; coordinates.len()];
        let known = Values { coordinates, speeds: &zeros, accelerations: &zeros, ..numeric.known };
        let scaled =
            |row: &MotionRow| evaluate(arena, &row.jacobian, &known).iter().zip(scales).map(|(entry, scale)| entry * scale).collect();
        self.rows.iter().map(scaled).collect()
    }

    /// Scale of a speed, in m or rad.
    fn scale(&self, numeric: &Numeric, speed: usize) -> f64 {
        if self.is_spin(speed) { 1.0 } else { numeric.scale(speed) }
    }

    fn is_spin(&self, speed: usize) -> bool {
        self.spins.iter().any(|spin| (spin.first..spin.first + 3).contains(&(speed as u32)))
    }

    /// Grouping of the vectors of bodies.
    fn triples(&self, numeric: &Numeric) -> Vec<[usize; 3]> {
        let is_first = |speed: &usize| {
            let is_position = matches!(numeric.system.coordinates[*speed].role, Role::Position(Axis::X));
            is_position || self.spins.iter().any(|spin| spin.first as usize == *speed)
        };
        let place = |speed: usize| self.speeds.iter().position(|other| *other == speed);
        let triple = |speed: &usize| Some([place(*speed)?, place(speed + 1)?, place(speed + 2)?]);
        self.speeds.iter().filter(|speed| is_first(speed)).filter_map(triple).collect()
    }

    /// Accelerations of the coordinates of a state, with ω as a function of its rates.
    fn by_coordinates(&self, arena: &mut Arena, integrated: &[usize], found: Accelerations) -> Accelerations {
        let quaternions: Vec<Quaternion> = self.spins.iter().map(|spin| Quaternion::new(arena, *spin)).collect();
        let mut by_rates = Substitution::new();
        for quaternion in &quaternions {
            (quaternion.first as u32..).zip(quaternion.components).for_each(|(number, part)| by_rates.replace(Leaf::Speed(number), part));
        }
        let mut of = |expr: Expr| by_rates.of(arena, expr);
        let values: Vec<Expr> = found.values.into_iter().map(&mut of).collect();
        let checks = found.checks.into_iter().map(|pair| pair.map(&mut of)).collect();
        let mut values: Lookup<usize, Expr> = self.speeds.iter().copied().zip(values).collect();
        for quaternion in &quaternions {
            let changes = [0, 1, 2].map(|k| values[&(quaternion.first + k)]);
            let lender = quaternions.iter().find(|other| Some(other.first) == quaternion.lender.map(|lender| lender.first));
            let turning = lender.map(|lender| lender.components);
            values.extend((quaternion.first..).zip(quaternion.second_derivative(arena, changes, turning)));
        }
        Accelerations { values: integrated.iter().map(|unknown| values[unknown]).collect(), checks }
    }
}

/// The body along whose axes ω of another one has its components.
#[derive(Clone, Copy)]
struct Lender {
    /// Number of the first component of its quaternion.
    first: usize,
    /// Its axes.
    columns: [Triple; 3],
}

/// The quaternion of a body, by the rates of its components.
struct Quaternion {
    /// Number of its first component.
    first: usize,
    /// True if ω is along the axes of the body itself.
    is_own: bool,
    lender: Option<Lender>,
    /// e
    scalar: Expr,
    vector: Triple,
    /// 1/(e · e)
    inverse: Expr,
    /// h (e · ė)
    growth: Expr,
    /// ė · ė
    square: Expr,
    /// ω in the axes of the body, or in those of ground.
    spin: Triple,
    /// ω by the components that are speeds.
    components: Triple,
}

impl Quaternion {
    fn new(arena: &mut Arena, Spin { first, axes }: Spin) -> Quaternion {
        let (first, is_own) = (first as usize, axes == SpinAxes::Own);
        let lender = match axes {
            SpinAxes::Of(frame) => arena.spin(frame).map(|spin| Lender { first: spin.first as usize, columns: arena.frame(frame).columns }),
            SpinAxes::Own | SpinAxes::Ground => None,
        };
        let [components, rates] = [Leaf::Coordinate, Leaf::Speed].map(|leaf| [0, 1, 2, 3].map(|k| arena.leaf(leaf((first + k) as u32))));
        let sum_of_products = |arena: &mut Arena, a: [Expr; 4], b: [Expr; 4]| {
            let products = [0, 1, 2, 3].map(|k| arena.mul(a[k], b[k]));
            arena.sum(&products)
        };
        let [norm, growth, square] =
            [[components, components], [components, rates], [rates, rates]].map(|[a, b]| sum_of_products(arena, a, b));
        let two = arena.integer(2);
        let h = arena.div(two, norm);
        // One division: half of h is exact.
        let inverse = arena.div(h, two);
        let [[scalar, x, y, z], [rate, dx, dy, dz]] = [components, rates];
        let vector = [x, y, z];
        // vec(ē ė) = e₀ ė − ė₀ e − e × ė, vec(ė ē) = e₀ ė − ė₀ e + e × ė
        let across = cross(arena, vector, [dx, dy, dz]);
        let spin = [0, 1, 2].map(|k| {
            let (forth, back) = (arena.mul(scalar, [dx, dy, dz][k]), arena.mul(rate, vector[k]));
            let along = arena.sub(forth, back);
            let part = if is_own { arena.sub(along, across[k]) } else { arena.add(along, across[k]) };
            arena.mul(h, part)
        });
        let components = lender.map_or(spin, |lender| lender.columns.map(|axis| dot(arena, axis, spin)));
        Quaternion { first, is_own, lender, scalar, vector, inverse, growth: arena.mul(h, growth), square, spin, components }
    }

    /// ë, from ẇ.
    ///
    /// * `turning`: given, ω of the body along whose axes w has its components, by those axes.
    fn second_derivative(&self, arena: &mut Arena, changes: Triple, turning: Option<Triple>) -> [Expr; 4] {
        let changes = match (self.lender, turning) {
            (Some(lender), Some(turning)) => {
                let swing = cross(arena, turning, self.components);
                let changes = [0, 1, 2].map(|k| arena.add(changes[k], swing[k]));
                combination(arena, changes, lender.columns)
            }
            _ => changes,
        };
        let two = arena.integer(2);
        let part = arena.mul(self.square, self.inverse);
        let part = arena.neg(part);
        let turned = [0, 1, 2].map(|k| {
            let drift = arena.mul(self.growth, self.spin[k]);
            let sum = arena.add(changes[k], drift);
            arena.div(sum, two)
        });
        let (along, against) = (arena.mul(self.scalar, part), dot(arena, self.vector, turned));
        let across = cross(arena, self.vector, turned);
        let [x, y, z] = [0, 1, 2].map(|k| {
            let (own, other) = (arena.mul(self.scalar, turned[k]), arena.mul(part, self.vector[k]));
            let sum = arena.add(own, other);
            if self.is_own { arena.add(sum, across[k]) } else { arena.sub(sum, across[k]) }
        });
        [arena.sub(along, against), x, y, z]
    }
}
