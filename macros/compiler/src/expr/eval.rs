//! The interpreter: evaluates an expression to an `f64`, given the values of its leaves.
//!
//! It defines the meaning of expressions. Generated code performs the same operations in the same association and agrees bit for bit.

use super::{Arena, Binary, Expr, Leaf, Node, Unary};

/// Values of all leaves, in SI units. A missing leaf counts as NaN.
#[derive(Clone, Copy)]
pub struct Values<'a> {
    /// t, in seconds.
    pub time: f64,
    /// Parameters, by number.
    pub parameters: &'a [f64],
    /// q, by number of coordinate.
    pub coordinates: &'a [f64],
    /// u, by number of speed.
    pub speeds: &'a [f64],
    /// u̇, by number of speed.
    pub accelerations: &'a [f64],
    /// Value, first and second derivative of the function with this number.
    pub functions: &'a dyn Fn(u32, f64) -> [f64; 3],
}

impl Values<'_> {
    fn of(&self, leaf: Leaf) -> f64 {
        let (list, number) = match leaf {
            Leaf::Time => return self.time,
            // Expressions with data or third derivatives are printed, not evaluated.
            Leaf::Datum(_) | Leaf::Turn(_) | Leaf::Jerk(_) => return f64::NAN,
            Leaf::Parameter(i) => (self.parameters, i),
            Leaf::Input { number, order } => (self.parameters, number + u32::from(order)),
            Leaf::Coordinate(i) => (self.coordinates, i),
            Leaf::Speed(i) => (self.speeds, i),
            Leaf::Acceleration(i) => (self.accelerations, i),
        };
        list.get(number as usize).copied().unwrap_or(f64::NAN)
    }
}

impl Unary {
    /// Evaluates the function.
    #[must_use]
    pub fn apply(self, a: f64) -> f64 {
        match self {
            Unary::Neg => -a,
            Unary::Sqrt => libm::sqrt(a),
            Unary::Sin => libm::sincos(a).0,
            Unary::Cos => libm::sincos(a).1,
            Unary::Tan => libm::tan(a),
            Unary::Asin => libm::asin(a),
            Unary::Acos => libm::acos(a),
            Unary::Atan => libm::atan(a),
            Unary::Exp => libm::exp(a),
            Unary::Ln => libm::log(a),
            Unary::Abs => a.abs(),
            Unary::Sign if a > 0.0 => 1.0,
            Unary::Sign if a < 0.0 => -1.0,
            Unary::Sign => a,
        }
    }
}

impl Binary {
    /// Evaluates the function.
    #[must_use]
    pub fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Binary::Add => a + b,
            Binary::Sub => a - b,
            Binary::Mul => a * b,
            Binary::Div => a / b,
            Binary::Atan2 => libm::atan2(a, b),
        }
    }
}

/// Evaluates `roots`, in their order.
#[must_use]
pub fn evaluate(arena: &Arena, roots: &[Expr], values: &Values) -> Vec<f64> {
    let mut found = vec![f64::NAN; roots.len()];
    Evaluator::new(arena, roots).run(values, &mut found);
    found
}

impl Node {
    /// The value of an operation on constants; `None` if an operand has no value.
    pub(crate) fn value(&self, of: impl Fn(Expr) -> Option<f64>) -> Option<f64> {
        Some(match *self {
            Node::Constant(value) => value.to_f64(),
            Node::Leaf(_) | Node::Call { .. } => return None,
            Node::Unary(function, a) => function.apply(of(a)?),
            Node::Binary(function, a, b) => function.apply(of(a)?, of(b)?),
            Node::Marked { value, .. } => of(value)?,
            Node::Select { lhs, rhs, then, otherwise } => {
                let (then, otherwise) = (of(then)?, of(otherwise)?);
                if of(lhs)? < of(rhs)? { then } else { otherwise }
            }
        })
    }
}

/// Rounding scale of each root: the sum of its terms as if none cancelled, with sines and cosines taken as 1; of a product, the factors times the
/// scales of the other factors.
pub(crate) fn magnitudes(arena: &Arena, roots: &[Expr], values: &Values) -> Vec<f64> {
    let order = arena.reachable(roots);
    let of = evaluate(arena, &order, values);
    let slot = |expr: Expr| order.partition_point(|&e| e < expr);
    let mut sizes: Vec<f64> = Vec::with_capacity(order.len());
    for (expr, value) in order.iter().zip(&of) {
        let size = |operand: Expr| sizes[slot(operand)];
        sizes.push(match *arena.node(*expr) {
            Node::Unary(Unary::Neg | Unary::Abs, a) | Node::Marked { value: a, .. } => size(a),
            Node::Unary(Unary::Sin | Unary::Cos, _) => 1.0,
            Node::Binary(Binary::Add | Binary::Sub, a, b) => size(a) + size(b),
            // The error of a factor is multiplied by the other factor, which may be a small difference of large terms.
            Node::Binary(Binary::Mul, a, b) => {
                let (all, one, two) = (size(a) * size(b), of[slot(a)].abs() * size(b), of[slot(b)].abs() * size(a));
                all.min(one + two + f64::EPSILON * all)
            }
            Node::Binary(Binary::Div, a, b) => size(a) / of[slot(b)].abs(),
            _ => value.abs(),
        });
    }
    roots.iter().map(|root| sizes[slot(*root)]).collect()
}

/// The interpreter prepared for some roots, for repeated evaluation.
#[derive(Clone, Debug)]
pub struct Evaluator {
    steps: Vec<Instruction>,
    roots: Vec<usize>,
    // Scratch: the value of each step.
    slots: Vec<f64>,
}

/// One node with its operands as slots.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Constant(f64),
    Leaf(Leaf),
    Unary(Unary, usize),
    Binary(Binary, usize, usize),
    Same(usize),
    Select([usize; 4]),
    Call { function: u32, order: usize, argument: usize },
}

impl Evaluator {
    /// Puts the nodes under `roots` in order. The arena is not needed afterwards.
    #[must_use]
    pub fn new(arena: &Arena, roots: &[Expr]) -> Self {
        let order = arena.reachable_to_values(roots);
        // The list ascends and contains every operand, so that the partition point is the slot.
        let slot = |expr: Expr| order.partition_point(|&e| e < expr);
        let operation = |expr: Expr| match *arena.node(expr) {
            Node::Constant(value) => Instruction::Constant(value.to_f64()),
            Node::Leaf(leaf) => Instruction::Leaf(leaf),
            Node::Unary(function, a) => Instruction::Unary(function, slot(a)),
            Node::Binary(function, a, b) => Instruction::Binary(function, slot(a), slot(b)),
            Node::Marked { value, .. } => Instruction::Same(slot(value)),
            Node::Select { lhs, rhs, then, otherwise } => Instruction::Select([lhs, rhs, then, otherwise].map(slot)),
            Node::Call { function, order, argument } => Instruction::Call { function, order: usize::from(order), argument: slot(argument) },
        };
        let step = |&expr: &Expr| arena.value(expr).map_or_else(|| operation(expr), Instruction::Constant);
        Evaluator {
            steps: order.iter().map(step).collect(),
            roots: roots.iter().map(|&root| slot(root)).collect(),
            slots: Vec::with_capacity(order.len()),
        }
    }

    /// Number of operations in a run.
    pub(crate) fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Writes the values of the roots in their order, up to the length of `found`.
    pub fn run(&mut self, values: &Values, found: &mut [f64]) {
        self.slots.clear();
        for step in &self.steps {
            let slots = &self.slots;
            let value = match *step {
                Instruction::Constant(value) => value,
                Instruction::Leaf(leaf) => values.of(leaf),
                Instruction::Unary(function, a) => function.apply(slots[a]),
                Instruction::Binary(function, a, b) => function.apply(slots[a], slots[b]),
                Instruction::Same(value) => slots[value],
                Instruction::Select([lhs, rhs, then, otherwise]) => {
                    if slots[lhs] < slots[rhs] {
                        slots[then]
                    } else {
                        slots[otherwise]
                    }
                }
                Instruction::Call { function, order, argument } => {
                    let jet = (values.functions)(function, slots[argument]);
                    jet.get(order).copied().unwrap_or(f64::NAN)
                }
            };
            self.slots.push(value);
        }
        for (place, &root) in found.iter_mut().zip(&self.roots) {
            *place = self.slots[root];
        }
    }
}
