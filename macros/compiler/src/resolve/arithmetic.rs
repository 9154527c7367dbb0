//! Arithmetic of numbers and vectors: sums, products, powers, choices, and the residuals of equations.

use super::Components;
use super::elaborate::Elaborator;
use crate::diag::{ArrayFact, Range, ValueFact, Wanted};
use crate::expr::{Exact, Expr};
use crate::hints::{decimal_comma, gain, in_millimetres, is_measured, noted, with_time_too_much};
use crate::names::{Scalar, Scope, Value, Vector, misread_height};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{self, Operator, Relation};

/// The word for adding or subtracting.
fn action(operator: Operator) -> &'static str {
    if operator == Operator::Add { "add" } else { "subtract" }
}

impl Elaborator<'_> {
    pub(super) fn negative(&mut self, value: &ast::Expression, scope: &Scope) -> Option<Value> {
        let inner = self.value(value, scope)?;
        if let Value::Scalar(scalar) = inner {
            return Some(Value::Scalar(Scalar { expr: self.arena.neg(scalar.expr), ..scalar }));
        }
        let vector = self.vector_of(value.range, inner, Wanted::NumberOrVector)?;
        Some(Value::Vector(Vector { parts: vector.parts.map(|part| self.arena.neg(part)), ..vector }))
    }

    pub(super) fn tuple(&mut self, range: Range, items: &[ast::Expression], scope: &Scope) -> Option<Vector> {
        if self.names.ambient == Ambient::Space {
            return self.triple(range, items, scope);
        }
        let [x, y] = items else {
            return self.refuse(range, ValueFact::NotTwoComponents { found: items.len(), meant: decimal_comma(items.iter()) });
        };
        let (x, y) = (self.scalar(x, scope), self.scalar(y, scope));
        let (x, y) = (x?, y?);
        match x.measure.common(y.measure) {
            Some(measure) => Some(Vector { parts: Components::plane(x.expr, y.expr), measure }),
            None => {
                self.refuse(range, ValueFact::Unlike { action: "make one vector of", one: x.measure.settled(), two: y.measure.settled() })
            }
        }
    }

    /// Evaluates a point: a vector of lengths. If its coordinates are written out, the error marks the one that is not a length.
    pub(super) fn location(&mut self, written: &ast::Expression, scope: &Scope) -> Option<Vector> {
        if let ast::ExpressionKind::Tuple(items) = &written.kind {
            items.iter().for_each(|item| self.note_bare(item, Dim::LENGTH));
        }
        if let ast::ExpressionKind::Tuple(items) = &written.kind
            && let [x, y] = items.as_slice()
            && self.names.ambient == Ambient::Plane
        {
            let found = (self.scalar(x, scope), self.scalar(y, scope));
            let (one, two) = (found.0?, found.1?);
            let (blamed, parts, found) = match [one, two].map(|scalar| scalar.measure.fits(Dim::LENGTH)) {
                [true, true] => {
                    return Some(Vector { parts: Components::plane(one.expr, two.expr), measure: InferredDim::Known(Dim::LENGTH) });
                }
                [false, true] => (x.range, vec![x], one),
                [true, false] => (y.range, vec![y], two),
                [false, false] => (written.range, vec![x, y], one),
            };
            let instead: Option<Vec<String>> = parts.into_iter().map(in_millimetres).collect();
            let instead = instead.map(|parts| if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(", ")) });
            return self.refuse(blamed, ValueFact::NotALength { found: found.measure.settled(), instead });
        }
        let vector = self.vector(written, scope)?;
        if !vector.measure.fits(Dim::LENGTH) {
            return self.refuse(written.range, ValueFact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
        }
        Some(vector)
    }

    pub(super) fn binary(
        &mut self,
        range: Range,
        operator: Operator,
        lhs: &ast::Expression,
        rhs: &ast::Expression,
        scope: &Scope,
    ) -> Option<Value> {
        match operator {
            Operator::Power => return self.power(range, lhs, rhs, scope).map(Value::Scalar),
            Operator::Rem if is_measured(lhs) || is_measured(rhs) => return self.refuse(range, ArrayFact::RemainderOfQuantity),
            Operator::Rem => return self.remainder(range, lhs, rhs, scope).map(Value::Scalar),
            _ => {}
        }
        let (left, right) = (self.value(lhs, scope), self.value(rhs, scope));
        let (left, right) = (left?, right?);
        match (left, right) {
            (Value::Orientation(one), Value::Orientation(two)) if operator == Operator::Mul => {
                Some(Value::Orientation(one.iter().chain(two.iter()).copied().collect()))
            }
            (Value::Orientation(rotations), right) if operator == Operator::Mul && right.is_vector() => {
                let vector = self.vector_of(rhs.range, right, Wanted::VectorOrPoint)?;
                self.oriented(&rotations, vector).map(Value::Vector)
            }
            (Value::Scalar(one), Value::Scalar(two)) => {
                if matches!(operator, Operator::Add | Operator::Sub) && one.measure.common(two.measure).is_none() {
                    self.has_units([lhs, rhs], [one, two], operator)?;
                    self.is_by_rates([lhs, rhs])?;
                }
                if matches!(operator, Operator::Add | Operator::Sub) {
                    self.note_beside([(lhs, one), (rhs, two)]);
                }
                self.combine(range, operator, one, (two, rhs.range)).map(Value::Scalar)
            }
            (left, right) => {
                let points = match (&left, &right) {
                    (Value::Point(to), Value::Point(from)) if operator == Operator::Sub => Some((*from, *to)),
                    _ => None,
                };
                let value = self.combine_vectors(range, operator, (lhs, left), (rhs, right))?;
                if let (Some((from, to)), Value::Vector(vector)) = (points, &value) {
                    self.note_difference(vector.parts, from, to);
                }
                Some(value)
            }
        }
    }

    /// Evaluates `one operator two`. An error that concerns `two` alone is reported at its range `second`.
    fn combine(&mut self, range: Range, operator: Operator, one: Scalar, (two, second): (Scalar, Range)) -> Option<Scalar> {
        let (expr, measure) = match operator {
            Operator::Mul => (self.arena.mul(one.expr, two.expr), one.measure.times(two.measure)),
            Operator::Div => {
                if self.arena.as_constant(two.expr).is_some_and(|value| value.is_zero()) {
                    return self.refuse(second, ValueFact::DivisionByZero);
                }
                (self.arena.div(one.expr, two.expr), one.measure.per(two.measure))
            }
            Operator::Add | Operator::Sub | Operator::Power | Operator::Rem => {
                let Some(measure) = one.measure.common(two.measure) else {
                    let fact = ValueFact::Unlike { action: action(operator), one: one.measure.settled(), two: two.measure.settled() };
                    let fact = noted(&self.declared_unit, fact, range, None);
                    return self.refuse(range, fact);
                };
                let expr = if operator == Operator::Add { self.arena.add(one.expr, two.expr) } else { self.arena.sub(one.expr, two.expr) };
                (expr, measure)
            }
        };
        Some(Scalar { expr, measure })
    }

    /// Refuses the sum of a position and a velocity with bare factors, which are gains of a controller.
    fn has_units(&mut self, sides: [&ast::Expression; 2], values: [Scalar; 2], operator: Operator) -> Option<()> {
        let [one, two] = values.map(|scalar| scalar.measure.settled());
        let is_of_control = [Dim::ANGLE, Dim::LENGTH].contains(&one) && two.times(Dim::TIME) == one;
        let has_rate = ["rate(", "angular_velocity"].iter().any(|word| sides[1].to_string().contains(word));
        match sides.map(|side| gain(side).filter(|_| has_rate)) {
            [Some(first), Some(second)] if is_of_control => {
                let fact = ValueFact::BareGains { action: action(operator), one, two, numbers: [first, second] };
                self.refuse(sides[0].range.to(sides[1].range), fact)
            }
            _ => Some(()),
        }
    }

    /// Evaluates `one % two` for whole numbers known at compile time.
    fn remainder(&mut self, range: Range, lhs: &ast::Expression, rhs: &ast::Expression, scope: &Scope) -> Option<Scalar> {
        let (one, two) = (self.whole(lhs, scope), self.whole(rhs, scope));
        let result = self.whole_of_two(range, Operator::Rem, one?, two?)?;
        Some(Scalar { expr: self.arena.integer(result), measure: InferredDim::Known(Dim::NUMBER) })
    }

    /// Refuses an axis called `z` beside a number, in the plane.
    fn refuse_height(&mut self, sides: [(&ast::Expression, &Value); 2]) -> Option<()> {
        let has_number = sides.iter().any(|(_, value)| matches!(value, Value::Scalar(_)));
        let found =
            sides.into_iter().find_map(|(written, value)| Some((written.range, misread_height(self.names.ambient, written, value)?)));
        match found.filter(|_| has_number) {
            Some((range, fact)) => self.refuse(range, fact),
            None => Some(()),
        }
    }

    /// Adds vectors to vectors, and multiplies or divides vectors by numbers.
    fn combine_vectors(
        &mut self,
        range: Range,
        operator: Operator,
        left: (&ast::Expression, Value),
        right: (&ast::Expression, Value),
    ) -> Option<Value> {
        if let (Operator::Mul, Value::Scalar(_)) = (operator, &left.1) {
            return self.combine_vectors(range, operator, right, left);
        }
        if matches!(operator, Operator::Add | Operator::Sub) {
            self.refuse_height([(left.0, &left.1), (right.0, &right.1)])?;
        }
        if !right.1.is_combinable() {
            return self.not_a(right.0.range, Wanted::NumberOrVector, right.1.kind());
        }
        match (operator, &left.1) {
            (Operator::Div, Value::Scalar(_)) => return self.refuse(range, ValueFact::NumberByVector),
            (_, Value::Scalar(_)) => {
                return self.refuse(range, ValueFact::VectorAndNumber { in_space: self.names.ambient == Ambient::Space });
            }
            _ => {}
        }
        let one = self.vector_of(left.0.range, left.1, Wanted::NumberOrVector)?;
        if let Value::Scalar(factor) = right.1 {
            if matches!(operator, Operator::Add | Operator::Sub) {
                return self.refuse(range, ValueFact::VectorAndNumber { in_space: self.names.ambient == Ambient::Space });
            }
            let factors = vec![factor; one.parts.len()];
            return self.combine_parts(range, operator, one, &factors, right.0.range).map(Value::Vector);
        }
        let two = self.vector_of(right.0.range, right.1, Wanted::NumberOrVector)?;
        if !matches!(operator, Operator::Add | Operator::Sub) {
            return self.refuse(range, ValueFact::VectorTimesVector);
        }
        let others: Vec<Scalar> = two.parts.iter().map(|expr| Scalar { expr: *expr, measure: two.measure }).collect();
        self.combine_parts(range, operator, one, &others, right.0.range).map(Value::Vector)
    }

    /// Combines each component with its own number.
    fn combine_parts(&mut self, range: Range, operator: Operator, one: Vector, others: &[Scalar], second: Range) -> Option<Vector> {
        let pairs = one.parts.iter().zip(others);
        let scalar = |expr: &Expr| Scalar { expr: *expr, measure: one.measure };
        let combined: Option<Vec<Scalar>> =
            pairs.map(|(part, other)| self.combine(range, operator, scalar(part), (*other, second))).collect();
        let combined = combined?;
        let parts: Vec<Expr> = combined.iter().map(|scalar| scalar.expr).collect();
        Some(Vector { parts: Components::new(&parts)?, measure: combined.first()?.measure })
    }

    /// Builds a power of a number, or of a quantity with an exponent that its dimension allows.
    fn power(&mut self, range: Range, base: &ast::Expression, exponent: &ast::Expression, scope: &Scope) -> Option<Scalar> {
        let (one, two) = (self.scalar(base, scope), self.scalar(exponent, scope));
        let (one, two) = (one?, two?);
        if !two.measure.fits(Dim::NUMBER) {
            return self.refuse(exponent.range, ValueFact::WrongDimension { wanted: Dim::NUMBER, found: two.measure.settled() });
        }
        let constant = self.arena.as_constant(two.expr).map(Exact::to_f64);
        let sixths = constant.map(|value| 6.0 * value).filter(|value| value.fract() == 0.0 && value.abs() <= f64::from(i16::MAX));
        let sixths = sixths.map(|value| value as i16);
        let measure = match one.measure {
            InferredDim::Known(base) if base != Dim::NUMBER => sixths.and_then(|sixths| one.measure.power(sixths)),
            plain => Some(plain),
        };
        let Some(measure) = measure else {
            return self.refuse(range, ValueFact::PowerOfDimension { base: one.measure.settled() });
        };
        let expr = self.arena.real_power(one.expr, two.expr);
        Some(Scalar { expr, measure })
    }

    pub(super) fn choice(
        &mut self,
        range: Range,
        (lhs, relation, rhs): (&ast::Expression, Relation, &ast::Expression),
        (then, otherwise): (&ast::Expression, &ast::Expression),
        scope: &Scope,
    ) -> Option<Value> {
        let (left, right) = (self.scalar(lhs, scope), self.scalar(rhs, scope));
        let (yes, no) = (self.scalar(then, scope), self.scalar(otherwise, scope));
        let (left, right, yes, no) = (left?, right?, yes?, no?);
        self.note_beside([(lhs, left), (rhs, right)]);
        self.note_beside([(then, yes), (otherwise, no)]);
        if left.measure.common(right.measure).is_none() {
            let (one, two) = (left.measure.settled(), right.measure.settled());
            return self.refuse(lhs.range.to(rhs.range), ValueFact::Unlike { action: "compare", one, two });
        }
        let Some(measure) = yes.measure.common(no.measure) else {
            return self
                .refuse(range, ValueFact::Unlike { action: "choose between", one: yes.measure.settled(), two: no.measure.settled() });
        };
        let (l, r, y, n) = (left.expr, right.expr, yes.expr, no.expr);
        let expr = match relation {
            Relation::Less => self.arena.select(l, r, y, n),
            Relation::Greater => self.arena.select(r, l, y, n),
            Relation::LessOrEqual => self.arena.select(r, l, n, y),
            Relation::GreaterOrEqual => self.arena.select(l, r, n, y),
            Relation::Equal | Relation::Different => match self.arena.are_equal_wholes([l, r]) {
                Some(are_equal) if left.measure.fits(Dim::NUMBER) => {
                    if are_equal == (relation == Relation::Equal) {
                        y
                    } else {
                        n
                    }
                }
                _ => return self.refuse(lhs.range.to(rhs.range), ValueFact::EqualityInChoice),
            },
        };
        Some(Value::Scalar(Scalar { expr, measure }))
    }

    /// Residuals of an equation, left minus right side: one for a number, two for a vector.
    pub(super) fn residuals(&mut self, lhs: &ast::Expression, rhs: &ast::Expression, scope: &Scope) -> Option<Vec<Scalar>> {
        let range = lhs.range.to(rhs.range);
        let (left, right) = (self.value(lhs, scope), self.value(rhs, scope));
        let (left, right) = (left?, right?);
        if let (Value::Scalar(one), Value::Scalar(two)) = (&left, &right) {
            let Some(measure) = one.measure.common(two.measure) else {
                let found = [one, two].map(|scalar| scalar.measure.settled());
                let fact = noted(&self.declared_unit, ValueFact::Unlike { action: "equate", one: found[0], two: found[1] }, range, None);
                return self.refuse(range, with_time_too_much(fact, [lhs, rhs], found));
            };
            self.note_beside([(lhs, *one), (rhs, *two)]);
            return Some(vec![Scalar { expr: self.arena.sub(one.expr, two.expr), measure }]);
        }
        if let (Value::Orientation(one), Value::Orientation(two)) = (&left, &right) {
            let Vector { parts, measure } = self.between_orientations(one, two);
            return Some(parts.iter().map(|expr| Scalar { expr: *expr, measure }).collect());
        }
        self.refuse_height([(lhs, &left), (rhs, &right)])?;
        let kinds = [left.kind(), right.kind()];
        let points = match (&left, &right) {
            (Value::Point(to), Value::Point(from)) => Some((*from, *to)),
            _ => None,
        };
        // In space `== 0` says that all components vanish.
        if let (Value::Vector(vector), Value::Scalar(zero)) = (&left, &right)
            && self.names.ambient == Ambient::Space
            && self.arena.as_constant(zero.expr).is_some_and(|value| value.is_zero())
        {
            return Some(vector.parts.iter().map(|expr| Scalar { expr: *expr, measure: vector.measure }).collect());
        }
        let [one_kind, two_kind] = kinds;
        let unlike = ValueFact::CannotEquate { one: one_kind, two: two_kind, ambient: self.names.ambient };
        let (Some(one), Some(two)) = (self.as_vector(left), self.as_vector(right)) else { return self.refuse(range, unlike) };
        let Some(measure) = one.measure.common(two.measure) else {
            return self.refuse(range, ValueFact::Unlike { action: "equate", one: one.measure.settled(), two: two.measure.settled() });
        };
        if one.parts.len() != two.parts.len() {
            return self.refuse(range, unlike);
        }
        let parts = one.parts.zip(two.parts, |one, two| self.arena.sub(one, two));
        if let Some((from, to)) = points {
            self.note_difference(parts, from, to);
        }
        Some(parts.iter().map(|expr| Scalar { expr: *expr, measure }).collect())
    }
}
