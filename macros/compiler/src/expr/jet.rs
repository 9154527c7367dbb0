//! Derivatives along a direction: value, first and second derivative of an expression.
//!
//! The direction is a [`Seed`], the derivative D of each leaf. Along the motion u and u̇ are separate leaves and D(q) = u, time
//! has rate 1, parameters are constant. The derivatives are propagated together as Taylor coefficients through each operation, which
//! gives shorter and better conditioned expressions than differentiating twice.

use super::derivative::{cosine_of_arcsine, one_plus_square, sum_of_squares, turning};
use super::lookup::Lookup;
use super::{Arena, Binary, Expr, Leaf, Mark, Node, Unary};

/// Value, first and second derivative.
type Jet = [Expr; 3];

/// A direction: the derivative D of each leaf.
#[derive(Clone, Debug, Default)]
pub struct Seed {
    /// True if D(t) = 1; otherwise time is constant.
    time_runs: bool,
    /// True if D(u) = u̇; otherwise speeds are constant.
    speeds_change: bool,
    /// Parameter with D(p) = 1; all others are constant.
    parameter: Option<u32>,
    /// The number of the speed D(q) of each coordinate; `None` for a constant, and so are all beyond the last one.
    coordinates: Vec<Option<u32>>,
    /// Number of the first coordinate.
    first: u32,
    /// True if D(u̇) = ü; otherwise accelerations are constant.
    has_jerks: bool,
}

impl Seed {
    /// Along the motion: D(q) the speed of this number, D(u) = u̇, D(t) = 1. The rate of u̇ is taken as 0.
    #[must_use]
    pub fn motion(coordinates: Vec<Option<u32>>) -> Seed {
        Seed { time_runs: true, speeds_change: true, coordinates, ..Seed::default() }
    }

    /// The same seed with D(u̇) = ü, so that the second derivative of an expression can be differentiated once more.
    #[must_use]
    pub(crate) fn with_jerks(self) -> Seed {
        Seed { has_jerks: true, ..self }
    }

    /// At constant speeds: D(q) the speed of this number, D(u) = 0, D(t) = 1. The second derivative of Φ is −γ.
    #[must_use]
    pub(crate) fn constant_speeds(coordinates: Vec<Option<u32>>) -> Seed {
        Seed { speeds_change: false, ..Seed::motion(coordinates) }
    }

    /// True if speeds change along the seed.
    pub(crate) fn speeds_change(&self) -> bool {
        self.speeds_change
    }

    /// The same seed for coordinates that are numbered from `first` on.
    #[must_use]
    pub(crate) fn numbered_from(self, first: u32) -> Seed {
        Seed { first, ..self }
    }

    /// Along a parameter, at fixed q, u and t.
    #[must_use]
    pub fn parameter(parameter: u32) -> Seed {
        Seed { parameter: Some(parameter), ..Seed::default() }
    }
}

/// The jets along one seed, stored so that many rows share their work. Belongs to one arena.
#[derive(Clone, Debug)]
pub struct Jets {
    seed: Seed,
    known: Lookup<Expr, Jet>,
}

impl Jets {
    /// Creates an empty cache of jets along a seed.
    #[must_use]
    pub fn along(seed: Seed) -> Self {
        Jets { seed, known: Lookup::default() }
    }

    /// Value, first and second derivative of `root`.
    pub fn of(&mut self, arena: &mut Arena, root: Expr) -> [Expr; 3] {
        let is_turned = |expr: Expr| self.seed.time_runs && matches!(arena.node(expr), Node::Marked { mark: Mark::Turned { .. }, .. });
        let is_whole = |expr: Expr| arena.value(expr).is_some() || is_turned(expr);
        for expr in arena.reachable_down_to(&[root], |e| self.known.contains_key(&e), is_whole) {
            let jet = self.jet(arena, expr);
            self.known.insert(expr, jet);
        }
        self.known[&root]
    }

    /// The jet of one node whose operands have jets already.
    fn jet(&self, arena: &mut Arena, expr: Expr) -> Jet {
        let node = *arena.node(expr);
        let zero = arena.integer(0);
        let j = |operand: Expr| self.known[&operand];
        match node {
            Node::Leaf(leaf) => self.of_leaf(arena, expr, leaf),
            Node::Marked { mark: Mark::Turned { vector, axis }, .. } if self.seed.time_runs => {
                let [first, second] = arena.turning_with(vector, axis, self.seed.speeds_change);
                [expr, first, second]
            }
            _ if arena.value(expr).is_some() => [expr, zero, zero],
            Node::Marked { value, .. } => [expr, j(value)[1], j(value)[2]],
            // Without this line, unused nodes would be built only to be multiplied by 0.
            _ if node.children().all(|operand| j(operand)[1..] == [zero, zero]) => [expr, zero, zero],
            Node::Constant(_) => [expr, zero, zero],
            Node::Unary(function, a) => of_unary(arena, function, expr, j(a)),
            Node::Binary(function, a, b) => of_binary(arena, function, expr, j(a), j(b)),
            Node::Select { lhs, rhs, then, otherwise } => {
                let (a, b) = (j(then), j(otherwise));
                let first = arena.select(lhs, rhs, a[1], b[1]);
                [expr, first, arena.select(lhs, rhs, a[2], b[2])]
            }
            Node::Call { function, order, argument } => {
                let slope = arena.call(function, order.saturating_add(1), argument);
                let curvature = arena.call(function, order.saturating_add(2), argument);
                chain(arena, expr, [slope, curvature], j(argument))
            }
        }
    }

    fn of_leaf(&self, arena: &mut Arena, expr: Expr, leaf: Leaf) -> Jet {
        let zero = arena.integer(0);
        let seed = &self.seed;
        match leaf {
            Leaf::Time if seed.time_runs => [expr, arena.integer(1), zero],
            Leaf::Input { .. } if seed.time_runs => {
                let first = leaf.rate_of_input();
                let second = first.and_then(Leaf::rate_of_input);
                [expr, first.map_or(zero, |rate| arena.leaf(rate)), second.map_or(zero, |rate| arena.leaf(rate))]
            }
            Leaf::Parameter(i) if seed.parameter == Some(i) => [expr, arena.integer(1), zero],
            Leaf::Speed(i) if seed.speeds_change => {
                [expr, arena.leaf(Leaf::Acceleration(i)), if seed.has_jerks { arena.leaf(Leaf::Jerk(i)) } else { zero }]
            }
            Leaf::Acceleration(i) if seed.has_jerks => [expr, arena.leaf(Leaf::Jerk(i)), zero],
            Leaf::Coordinate(i) => match i.checked_sub(seed.first).and_then(|i| *seed.coordinates.get(i as usize)?) {
                None => [expr, zero, zero],
                Some(i) => {
                    let first = arena.leaf(Leaf::Speed(i));
                    [expr, first, if seed.speeds_change { arena.leaf(Leaf::Acceleration(i)) } else { zero }]
                }
            },
            Leaf::Time
            | Leaf::Parameter(_)
            | Leaf::Input { .. }
            | Leaf::Datum(_)
            | Leaf::Turn(_)
            | Leaf::Speed(_)
            | Leaf::Acceleration(_)
            | Leaf::Jerk(_) => [expr, zero, zero],
        }
    }
}

/// v = f(a) with f′ and f″ given: v₁ = f′ a₁, v₂ = f′ a₂ + f″ a₁².
fn chain(arena: &mut Arena, v: Expr, [slope, curvature]: [Expr; 2], a: Jet) -> Jet {
    let first = arena.mul(slope, a[1]);
    let along = arena.mul(slope, a[2]);
    let square = arena.square(a[1]);
    let bend = arena.mul(curvature, square);
    [v, first, arena.add(along, bend)]
}

/// The jet of v = f(a).
fn of_unary(arena: &mut Arena, function: Unary, v: Expr, a: Jet) -> Jet {
    match function {
        Unary::Neg => [v, arena.neg(a[1]), arena.neg(a[2])],
        Unary::Sqrt => of_sqrt(arena, v, a),
        Unary::Sin => {
            let cosine = arena.cos(a[0]);
            let bend = arena.neg(v);
            chain(arena, v, [cosine, bend], a)
        }
        Unary::Cos => {
            let sine = arena.sin(a[0]);
            let (slope, bend) = (arena.neg(sine), arena.neg(v));
            chain(arena, v, [slope, bend], a)
        }
        Unary::Tan => of_tan(arena, v, a),
        Unary::Asin => of_asin(arena, v, a),
        Unary::Acos => {
            let [_, first, second] = of_asin(arena, v, a);
            [v, arena.neg(first), arena.neg(second)]
        }
        Unary::Atan => of_atan(arena, v, a),
        Unary::Exp => {
            let first = arena.mul(v, a[1]);
            let square = arena.square(a[1]);
            let sum = arena.add(a[2], square);
            [v, first, arena.mul(v, sum)]
        }
        Unary::Ln => {
            let first = arena.div(a[1], a[0]);
            let drift = arena.mul(a[1], first);
            let above = arena.sub(a[2], drift);
            [v, first, arena.div(above, a[0])]
        }
        Unary::Abs => {
            let sign = arena.unary(Unary::Sign, a[0]);
            [v, arena.mul(sign, a[1]), arena.mul(sign, a[2])]
        }
        Unary::Sign => {
            let zero = arena.integer(0);
            [v, zero, zero]
        }
    }
}

/// The jet of v = f(a, b).
fn of_binary(arena: &mut Arena, function: Binary, v: Expr, a: Jet, b: Jet) -> Jet {
    match function {
        Binary::Add => [v, arena.add(a[1], b[1]), arena.add(a[2], b[2])],
        Binary::Sub => [v, arena.sub(a[1], b[1]), arena.sub(a[2], b[2])],
        Binary::Mul if a[0] == b[0] => of_square(arena, v, a),
        Binary::Mul => of_product(arena, v, a, b),
        Binary::Div => of_quotient(arena, v, a, b),
        Binary::Atan2 => of_atan2(arena, v, a, b),
    }
}

/// v = a b: v₁ = a₁ b + a b₁, v₂ = a₂ b + a b₂ + 2 a₁ b₁.
fn of_product(arena: &mut Arena, v: Expr, a: Jet, b: Jet) -> Jet {
    let left = arena.mul(a[1], b[0]);
    let right = arena.mul(a[0], b[1]);
    let first = arena.add(left, right);
    let left = arena.mul(a[2], b[0]);
    let right = arena.mul(a[0], b[2]);
    let outer = arena.add(left, right);
    let mixed = arena.mul(a[1], b[1]);
    let inner = arena.twice(mixed);
    [v, first, arena.add(outer, inner)]
}

/// v = a²: v₁ = 2 a a₁, v₂ = 2 (a a₂ + a₁²).
fn of_square(arena: &mut Arena, v: Expr, a: Jet) -> Jet {
    let half = arena.mul(a[0], a[1]);
    let first = arena.twice(half);
    let outer = arena.mul(a[0], a[2]);
    let inner = arena.square(a[1]);
    let half = arena.add(outer, inner);
    [v, first, arena.twice(half)]
}

/// v = a / b: v₁ = (a₁ − v b₁)/b, v₂ = (a₂ − 2 v₁ b₁ − v b₂)/b.
fn of_quotient(arena: &mut Arena, v: Expr, a: Jet, b: Jet) -> Jet {
    let drift = arena.mul(v, b[1]);
    let above = arena.sub(a[1], drift);
    let first = arena.div(above, b[0]);
    let mixed = arena.mul(first, b[1]);
    let inner = arena.twice(mixed);
    let above = arena.sub(a[2], inner);
    let outer = arena.mul(v, b[2]);
    let above = arena.sub(above, outer);
    [v, first, arena.div(above, b[0])]
}

/// v = √a: v₁ = a₁/(2 v), v₂ = (a₂ − 2 v₁²)/(2 v).
fn of_sqrt(arena: &mut Arena, v: Expr, a: Jet) -> Jet {
    let below = arena.twice(v);
    let first = arena.div(a[1], below);
    let square = arena.square(first);
    let bend = arena.twice(square);
    let above = arena.sub(a[2], bend);
    [v, first, arena.div(above, below)]
}

/// v = tan a, w = 1 + v²: v₁ = w a₁, v₂ = w a₂ + 2 v v₁ a₁.
fn of_tan(arena: &mut Arena, v: Expr, a: Jet) -> Jet {
    let w = one_plus_square(arena, v);
    let first = arena.mul(w, a[1]);
    let along = arena.mul(w, a[2]);
    let mixed = arena.mul(first, a[1]);
    let half = arena.mul(v, mixed);
    let bend = arena.twice(half);
    [v, first, arena.add(along, bend)]
}

/// v = asin a, w = √(1 − a²): v₁ = a₁/w, v₂ = (a₂ + a v₁²)/w.
fn of_asin(arena: &mut Arena, v: Expr, a: Jet) -> Jet {
    let w = cosine_of_arcsine(arena, a[0]);
    let first = arena.div(a[1], w);
    let square = arena.square(first);
    let bend = arena.mul(a[0], square);
    let above = arena.add(a[2], bend);
    [v, first, arena.div(above, w)]
}

/// v = atan a, w = 1 + a²: v₁ = a₁/w, v₂ = (a₂ − 2 a a₁ v₁)/w.
fn of_atan(arena: &mut Arena, v: Expr, a: Jet) -> Jet {
    let w = one_plus_square(arena, a[0]);
    let first = arena.div(a[1], w);
    let mixed = arena.mul(a[1], first);
    let half = arena.mul(a[0], mixed);
    let bend = arena.twice(half);
    let above = arena.sub(a[2], bend);
    [v, first, arena.div(above, w)]
}

/// v = atan2(y, x), w = x² + y²: v₁ = (x y₁ − y x₁)/w, v₂ = (x y₂ − y x₂ − v₁ w₁)/w with
/// w₁ = 2 (x x₁ + y y₁).
fn of_atan2(arena: &mut Arena, v: Expr, y: Jet, x: Jet) -> Jet {
    let w = sum_of_squares(arena, y[0], x[0]);
    let above = turning(arena, [y[0], x[0]], [y[1], x[1]]);
    let first = arena.div(above, w);
    let left = arena.mul(x[0], x[1]);
    let right = arena.mul(y[0], y[1]);
    let radial = arena.add(left, right);
    let half = arena.mul(first, radial);
    let drift = arena.twice(half);
    let above = turning(arena, [y[0], x[0]], [y[2], x[2]]);
    let above = arena.sub(above, drift);
    [v, first, arena.div(above, w)]
}
