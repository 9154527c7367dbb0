//! The time after which the motion repeats or rests, by the laws of its drives.
//!
//! In: the equations of the followed blocks. Out: the time after which everything repeats or rests, if there is one, and the times before
//! it at which a law changes its expression.
//!
//! The final behaviour of each expression is determined: it rests, increases steadily, or repeats. An angle that increases steadily is back
//! after a turn; a length that does so grows without bound, and the span is unknown.

use crate::expr::{Binary, Expr, Leaf, Node, Unary};
use crate::expr::{Values, evaluate};
use crate::model::{Ends, Function};
use crate::numeric::Numeric;
use crate::quantity::Dim;
use crate::structure::Structure;
use core::f64::consts::TAU;
use std::collections::BTreeMap;

/// Periods are commensurate if at most this many of the longest are a whole multiple of every other.
const MOST_ROUNDS: usize = 12;

/// Relative tolerance of a whole multiple.
const WHOLE: f64 = 1e-9;

/// If the common period exceeds the shortest period by more than this factor, only the longest period is followed.
const MOST_REPEATED: f64 = 200.0;

/// Behaviour of an expression after its last change.
#[derive(Clone, Debug, Default)]
struct Law {
    /// Steady rate.
    rate: f64,
    /// Periods of its periodic part.
    periods: Vec<f64>,
    /// True if nothing is known about the expression.
    is_wild: bool,
    /// True if it depends on time or on a moving coordinate.
    moves: bool,
}

impl Law {
    fn wild() -> Law {
        Law { is_wild: true, moves: true, ..Law::default() }
    }

    fn repeats(&self) -> bool {
        !self.is_wild && self.rate == 0.0
    }

    /// Law of an expression that repeats when all of these do: the union of their periods.
    fn together<'a>(laws: impl Iterator<Item = &'a Law>) -> Law {
        let mut all = Law::default();
        for law in laws {
            all.is_wild |= law.is_wild;
            all.moves |= law.moves;
            for period in &law.periods {
                if !all.periods.iter().any(|known| (known - period).abs() <= WHOLE * period) {
                    all.periods.push(*period);
                }
            }
        }
        all
    }

    /// Law of a periodic function of this argument: a steady rate becomes a period.
    fn turned(mut self, turn: f64) -> Law {
        if self.rate != 0.0 {
            let period = (turn / self.rate).abs();
            self.rate = 0.0;
            self = Law::together([self, Law { periods: vec![period], moves: true, ..Law::default() }].iter());
        }
        self
    }
}

/// Time span to be followed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Horizon {
    /// Time after which everything repeats or rests, in s.
    pub(super) until: f64,
    /// Times at which laws change, increasing, in s.
    pub(super) stops: Vec<f64>,
}

/// Span from t = 0; `None` if an expression increases without bound or its behaviour is unknown.
pub(super) fn span(numeric: &Numeric, structure: &Structure, blocks: impl Iterator<Item = usize>, q: &[f64]) -> Option<Horizon> {
    let mut reader = LawReader { numeric, q, known: BTreeMap::new(), computed: BTreeMap::new(), stops: Vec::new() };
    let mut whole = Law::default();
    for block in blocks {
        let block = &structure.blocks[block];
        if let ([], [explicit]) = (block.iterated.as_slice(), block.explicit.as_slice()) {
            let law = reader.computed(explicit.unknown, explicit.equation);
            reader.computed.insert(explicit.unknown as u32, law);
            continue;
        }
        for equation in block.parts().1 {
            let equation = &numeric.system.equations[equation];
            let phi = equation.phi()?;
            let mut law = reader.of(phi);
            if law.rate != 0.0 && equation.dim == Dim::ANGLE {
                law = law.turned(TAU);
            }
            if !law.repeats() {
                return None;
            }
            whole = Law::together([whole, law].iter());
        }
    }
    let mut stops: Vec<f64> = reader.stops.into_iter().filter(|stop| stop.is_finite() && *stop > 0.0).collect();
    stops.sort_by(f64::total_cmp);
    stops.dedup();
    let until = stops.last().copied().unwrap_or(0.0) + common(&whole.periods);
    (until > 0.0 && until.is_finite()).then_some(Horizon { until, stops })
}

/// Least common period; the longest period if there is none within reach.
fn common(periods: &[f64]) -> f64 {
    let longest = periods.iter().copied().fold(0.0, f64::max);
    let shortest = periods.iter().copied().fold(longest, f64::min);
    let is_common = |rounds: &usize| {
        let all = *rounds as f64 * longest;
        all <= MOST_REPEATED * shortest
            && periods.iter().all(|period| (all / period - (all / period).round()).abs() <= WHOLE * all / period)
    };
    (1..=MOST_ROUNDS).find(is_common).map_or(longest, |rounds| rounds as f64 * longest)
}

struct LawReader<'a> {
    numeric: &'a Numeric<'a>,
    q: &'a [f64],
    known: BTreeMap<Expr, Law>,
    /// Laws of computed coordinates.
    computed: BTreeMap<u32, Law>,
    /// Times at which expressions change, in s.
    stops: Vec<f64>,
}

impl LawReader<'_> {
    /// Law of a coordinate computed from one equation, linear in it.
    fn computed(&mut self, unknown: usize, equation: usize) -> Law {
        let equation = &self.numeric.system.equations[equation];
        let pivot = equation.jacobian.iter().find(|(other, _)| *other == unknown).map(|(_, entry)| *entry);
        let (Some(phi), Some(pivot)) = (equation.phi(), pivot) else { return Law::wild() };
        let pivot = self.value(pivot, 0.0);
        // With this coordinate taken as resting, `of` returns the law of the remaining terms.
        let others = std::mem::take(&mut self.known);
        let law = self.of(phi);
        self.known = others;
        Law { rate: -law.rate / pivot, ..law }
    }

    fn of(&mut self, root: Expr) -> Law {
        for expr in self.numeric.system.arena.reachable_until(&[root], |expr| self.known.contains_key(&expr)) {
            let law = self.law(expr);
            self.known.insert(expr, law);
        }
        self.known[&root].clone()
    }

    fn value(&self, expr: Expr, time: f64) -> f64 {
        evaluate(&self.numeric.system.arena, &[expr], &Values { time, coordinates: self.q, ..self.numeric.known })[0]
    }

    /// A time after all known changes, in s.
    fn late(&self) -> f64 {
        self.stops.iter().copied().filter(|stop| stop.is_finite()).fold(0.0, f64::max) + 1.0
    }

    fn law(&mut self, expr: Expr) -> Law {
        let node = *self.numeric.system.arena.node(expr);
        let laws: Vec<Law> = node.children().map(|child| self.known[&child].clone()).collect();
        let all = Law::together(laws.iter());
        if matches!(node, Node::Leaf(Leaf::Time)) {
            return Law { rate: 1.0, moves: true, ..Law::default() };
        }
        if let Node::Leaf(Leaf::Coordinate(number)) = node {
            // An iterated coordinate has no law of its own: it follows from the rest.
            return self.computed.get(&number).cloned().unwrap_or(Law { moves: true, ..Law::default() });
        }
        if let Node::Binary(Binary::Mul, a, b) = node
            && [(a, &laws[0]), (b, &laws[1])].into_iter().any(|(factor, law)| !law.moves && self.value(factor, 0.0) == 0.0)
        {
            return Law::default();
        }
        if let Node::Select { lhs, rhs, .. } = node {
            return self.choice([lhs, rhs], &laws, all);
        }
        if all.is_wild || !all.moves {
            return all;
        }
        match node {
            Node::Unary(Unary::Neg, _) => Law { rate: -laws[0].rate, ..all },
            Node::Binary(Binary::Add, ..) => Law { rate: laws[0].rate + laws[1].rate, ..all },
            Node::Binary(Binary::Sub, ..) => Law { rate: laws[0].rate - laws[1].rate, ..all },
            Node::Binary(Binary::Mul, _, b) if !laws[1].moves => Law { rate: times(laws[0].rate, self.value(b, 0.0)), ..all },
            Node::Binary(Binary::Mul, a, _) if !laws[0].moves => Law { rate: times(laws[1].rate, self.value(a, 0.0)), ..all },
            Node::Binary(Binary::Div, _, b) if !laws[1].moves => Law { rate: laws[0].rate / self.value(b, 0.0), ..all },
            Node::Unary(Unary::Sin | Unary::Cos | Unary::Tan, _) => laws[0].clone().turned(TAU),
            Node::Unary(Unary::Abs | Unary::Sign, a) if laws[0].rate != 0.0 => {
                let Some(positive) = self.crossing(a, &laws[0]) else { return Law::wild() };
                let rate = if matches!(node, Node::Unary(Unary::Abs, _)) { laws[0].rate.abs() } else { 0.0 };
                Law { rate: if positive { rate.abs() } else { rate }, ..all }
            }
            Node::Call { function, argument, .. } => self.called(function, argument, &laws[0], all),
            _ if laws.iter().all(Law::repeats) => all,
            _ => Law::wild(),
        }
    }

    /// Law of the branch that is finally taken.
    fn choice(&mut self, [lhs, rhs]: [Expr; 2], laws: &[Law], all: Law) -> Law {
        let [one, other, then, otherwise] = laws else { return Law::wild() };
        if one.is_wild || other.is_wild {
            return Law::wild();
        }
        if !one.moves && !other.moves {
            let is_less = self.value(lhs, 0.0) < self.value(rhs, 0.0);
            return if is_less { then.clone() } else { otherwise.clone() };
        }
        let rate = one.rate - other.rate;
        if rate == 0.0 {
            return if laws.iter().all(Law::repeats) { all } else { Law::wild() };
        }
        if !one.periods.is_empty() || !other.periods.is_empty() || self.has_coordinates(lhs) || self.has_coordinates(rhs) {
            return Law::wild();
        }
        let late = self.late();
        self.stops.push(late + (self.value(rhs, late) - self.value(lhs, late)) / rate);
        if rate < 0.0 { then.clone() } else { otherwise.clone() }
    }

    fn has_coordinates(&self, expr: Expr) -> bool {
        self.numeric.system.arena.leaves(expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_)))
    }

    /// Records the zero of a steadily increasing or decreasing expression as a stop; true if the expression is positive afterwards.
    fn crossing(&mut self, expr: Expr, law: &Law) -> Option<bool> {
        if !law.periods.is_empty() || self.has_coordinates(expr) {
            return None;
        }
        let late = self.late();
        self.stops.push(late - self.value(expr, late) / law.rate);
        Some(law.rate > 0.0)
    }

    /// Law of a table beyond its ends; it counts as resting there.
    fn called(&mut self, function: u32, argument: Expr, law: &Law, all: Law) -> Law {
        let Some(Function::Table(table)) = self.numeric.model.functions.get(function as usize) else { return Law::wild() };
        let (first, last) = (table.knots[0], table.knots[table.knots.len() - 1]);
        if law.rate == 0.0 {
            return all;
        }
        if table.ends == Ends::Periodic {
            return law.clone().turned(last - first);
        }
        if !law.periods.is_empty() || self.has_coordinates(argument) {
            return Law::wild();
        }
        let late = self.late();
        let end = if law.rate > 0.0 { last } else { first };
        self.stops.push(late + (end - self.value(argument, late)) / law.rate);
        Law { moves: true, ..Law::default() }
    }
}

/// Product in which a zero rate stays zero, even times infinity or NaN.
fn times(rate: f64, by: f64) -> f64 {
    if rate == 0.0 { 0.0 } else { rate * by }
}
