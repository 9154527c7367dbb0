//! Arrays: whole numbers known at compile time, and names with indices.

use super::elaborate::Elaborator;
use crate::diag::{ArrayFact, Known, NameFact, Range};
use crate::names::{GroupId, Scope, SpaceId, Value};
use crate::quantity::Dim;
use crate::syntax::ast::{self, ExpressionKind, IndexRange, Operator};
use proc_macro2::Ident;
use std::collections::BTreeSet;

/// Longest range of a loop, so that a typing error does not exhaust the memory.
const LONGEST: usize = 10_000;

impl Elaborator<'_> {
    /// `array[index]`
    pub(super) fn indexed(&mut self, owner: &ast::Expression, index: &ast::Expression, scope: &Scope) -> Option<Value> {
        let (group, mut at) = match self.value_or_array(owner, scope)? {
            Value::Array { group, at } => (group, at),
            other => {
                let fact = ArrayFact::NoArray { found: other.kind(), is_member: matches!(owner.kind, ExpressionKind::Index(..)) };
                return self.refuse(index.range, fact);
            }
        };
        let number = self.whole(index, scope)?;
        let found = &self.names.group(group).members;
        let rank = at.len();
        let is_there = |number: usize| {
            let mut begin = at.clone();
            begin.push(number);
            found.range(begin.clone()..).next().is_some_and(|(indices, _)| indices.starts_with(&begin))
        };
        let Some(number) = usize::try_from(number).ok().filter(|number| is_there(*number)) else {
            let known = found.keys().filter(|indices| indices.starts_with(&at)).filter_map(|indices| indices.get(rank));
            let known: BTreeSet<usize> = known.copied().collect();
            let name = self.names.member_name(group, &at);
            let (first, last) = (known.first().copied(), known.last().copied());
            let known = Known::of(known.iter().map(|index| format!("{name}[{index}]")));
            return self.refuse(index.range, ArrayFact::IndexOutOfRange { name, index: number, ends: first.zip(last), known });
        };
        at.push(number);
        self.member(group, at, index.range)
    }

    /// Value of a name: an item, or an array that still lacks its indices.
    pub(super) fn of_group(&mut self, group: GroupId, range: impl Into<Range>) -> Option<Value> {
        self.member(group, Vec::new(), range.into())
    }

    fn member(&mut self, group: GroupId, at: Vec<usize>, range: Range) -> Option<Value> {
        if at.len() < self.names.group(group).ranks {
            return Some(Value::Array { group, at });
        }
        let entity = *self.names.group(group).members.get(&at)?;
        self.entity(entity, range)
    }

    /// Value of a name used by an item of `space`. A component sees only parameters, `let`s and functions of the mechanism.
    pub(super) fn visible(&mut self, range: Range, group: GroupId, space: SpaceId) -> Option<Value> {
        let known = self.names.group(group);
        let is_own = space == SpaceId::MECHANISM || self.names.find(space, &known.word) == Some(group);
        if is_own || known.sort.is_seen_from_components() {
            return self.of_group(group, range);
        }
        let (name, what) = (known.word.clone(), known.sort.noun());
        self.refuse(range, ArrayFact::OutsideOfComponent { name, what })
    }

    /// `part.name`
    pub(super) fn part_field(&mut self, space: SpaceId, field: &Ident) -> Option<Value> {
        let name = field.to_string();
        if let Some(group) = self.names.find(space, &name) {
            return self.of_group(group, field);
        }
        if self.names.outputs.contains(&(space, name.clone())) {
            return self.refuse(field, NameFact::OutputRead { name });
        }
        let near = self.nearest(&name, self.names.words(space));
        let known = Known::of(self.names.words(space));
        let owner = self.names.spaces[space.0].prefix.trim_end_matches('.').to_owned();
        self.refuse(field, NameFact::UnknownField { owner: format!("`{owner}`"), name, near, known })
    }

    /// Evaluates the indices of a declared name.
    pub(super) fn indices(&mut self, written: &[ast::Expression], scope: &Scope) -> Option<Vec<usize>> {
        let index = |this: &mut Self, expr: &ast::Expression| {
            let number = this.whole(expr, scope)?;
            match usize::try_from(number) {
                Ok(number) => Some(number),
                Err(_) => this.refuse(expr.range, ArrayFact::NegativeIndex { index: number }),
            }
        };
        written.iter().map(|expr| index(self, expr)).collect()
    }

    /// Values of a loop variable. `is_inner`: the loop is inside another loop and may be empty.
    pub(super) fn rounds(&mut self, bounds: &IndexRange, is_inner: bool, scope: &Scope) -> Option<Vec<i64>> {
        let (from, to) = (self.whole(&bounds.from, scope), self.whole(&bounds.to, scope));
        let (from, to) = (from?, to?);
        let rounds = i128::from(to) - i128::from(from) + i128::from(bounds.is_inclusive);
        let range = bounds.from.range.to(bounds.to.range);
        // A range with a computed bound may be empty; nobody writes `2..2` on purpose.
        let is_written_out = [&bounds.from, &bounds.to].iter().all(|end| matches!(end.kind, ExpressionKind::Number { .. }));
        if rounds < 0 || rounds == 0 && !is_inner && is_written_out {
            return self.refuse(range, ArrayFact::EmptyRange { from, to, is_inclusive: bounds.is_inclusive });
        }
        match usize::try_from(rounds).ok().filter(|rounds| *rounds <= LONGEST) {
            Some(rounds) => Some((from..=to).take(rounds).collect()),
            None => self.give_up(range, ArrayFact::LongRange { rounds, limit: LONGEST }),
        }
    }

    /// Evaluates a whole number known at compile time: literals, loop variables and whole `let`s.
    pub(super) fn whole(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<i64> {
        match &expr.kind {
            ExpressionKind::Number { digits, unit } => match digits.parse() {
                Ok(number) if unit.is_empty() => Some(number),
                Err(_) if unit.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()) => {
                    self.refuse(expr.range, ArrayFact::WholeTooLarge { found: digits.clone() })
                }
                _ => self.refuse(expr.range, ArrayFact::NotWhole { found: format!("`{digits}{unit}`") }),
            },
            ExpressionKind::Negative(value) => {
                let value = self.whole(value, scope)?;
                let too_large = ArrayFact::WholeTooLarge { found: format!("-({value})") };
                value.checked_neg().or_else(|| self.refuse(expr.range, too_large))
            }
            ExpressionKind::Binary(operator, lhs, rhs) if *operator != Operator::Power => {
                let (one, two) = (self.whole(lhs, scope), self.whole(rhs, scope));
                self.whole_of_two(expr.range, *operator, one?, two?)
            }
            ExpressionKind::Path(_) | ExpressionKind::Field(..) | ExpressionKind::Index(..) => {
                let value = self.value(expr, scope)?;
                self.as_whole(expr.range, &value)
            }
            _ => self.refuse(expr.range, ArrayFact::NotWhole { found: "this".into() }),
        }
    }

    pub(super) fn whole_of_two(&mut self, range: Range, operator: Operator, one: i64, two: i64) -> Option<i64> {
        let result = match operator {
            Operator::Add => one.checked_add(two),
            Operator::Sub => one.checked_sub(two),
            Operator::Mul => one.checked_mul(two),
            // The remainder is never negative, so that it can serve as an index.
            Operator::Rem => one.checked_rem_euclid(two),
            // Division means the same as in other expressions: the quotient must be exact.
            _ => one.checked_rem(two).filter(|rest| *rest == 0).and_then(|_| one.checked_div(two)),
        };
        match result {
            Some(result) => Some(result),
            None if matches!(operator, Operator::Add | Operator::Sub | Operator::Mul) => {
                self.refuse(range, ArrayFact::WholeTooLarge { found: format!("{one} {operator} {two}") })
            }
            None => self.refuse(range, ArrayFact::NotWhole { found: format!("`{one} {operator} {two}`") }),
        }
    }

    fn as_whole(&mut self, range: Range, value: &Value) -> Option<i64> {
        let Value::Scalar(scalar) = value else { return self.refuse(range, ArrayFact::NotWhole { found: value.kind().to_string() }) };
        let dim = scalar.measure.settled();
        if !scalar.measure.fits(Dim::NUMBER) {
            return self.refuse(range, ArrayFact::NotWhole { found: dim.to_string() });
        }
        let constant = self.arena.as_constant(scalar.expr);
        let whole = constant.filter(|value| value.denominator() == 1 && value.pi_power() == 0);
        match whole.map(|value| i64::try_from(value.numerator())) {
            Some(Ok(number)) => Some(number),
            Some(Err(_)) => self.refuse(range, ArrayFact::WholeTooLarge { found: whole.map_or(0, |value| value.numerator()).to_string() }),
            None if constant.is_some() => self.refuse(range, ArrayFact::NotWhole { found: "a fraction".into() }),
            None => self.refuse(range, ArrayFact::NotKnownWhole),
        }
    }
}
