//! Built-in functions, and functions of one variable declared by users.

use super::Function as Numbered;
use super::elaborate::Elaborator;
use super::{Components, Name, Requirement};
use crate::diag::{ArityFact, Fact, NameFact, Note, Range, Typed, ValueFact, Wanted};
use crate::expr::spline::Table;
use crate::expr::{Arena, Expr, Unary};
use crate::hints::{by_law, with_rate};
use crate::library;
use crate::names::{BUILTINS, Fixed, FunctionValue, Key, SPATIAL_BUILTINS, Scalar, Scope, Value, Vector, is_elsewhere};
use crate::profile::{self, SEGMENTS, Valuer, table};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{self, ExpressionKind};
use crate::words::foreign;
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// `function(arguments)`
    pub(super) fn call(&mut self, range: Range, path: &ast::Path, arguments: &[ast::Expression], scope: &Scope) -> Option<Value> {
        let Some(name) = &path.name else {
            let function = self.rust_function(path, InferredDim::Any, InferredDim::Any);
            return self.apply(range, path, &function, arguments, scope).map(Value::Scalar);
        };
        let is_bound = self.is_bound_function(name, scope);
        if BUILTINS.contains(&name.to_string().as_str()) {
            return self.builtin(range, name, arguments, scope);
        }
        if !is_bound && profile::WORDS.iter().any(|word| name == word) {
            return profile::called(self, name, arguments, scope).map(Value::Scalar);
        }
        if !is_bound && name == super::speeds::RATE {
            return self.rate(name, arguments, scope);
        }
        if !is_bound && SPATIAL_BUILTINS.contains(&name.to_string().as_str()) {
            return match self.names.ambient {
                Ambient::Space => self.spatial_builtin(name, arguments, scope),
                Ambient::Plane => self.refuse(name, ValueFact::OnlyInSpace { word: name.to_string(), typed: None }),
            };
        }
        if !is_bound && !self.is_library_function(name) {
            let is_declared = |word: &str| {
                let is_bound = scope.bound.iter().any(|(known, _)| known == word);
                is_bound || scope.space.is_some_and(|space| self.names.functions(space).any(|known| known == word))
            };
            // `lerp` is not a misspelled `perp`.
            let near = self.similar_function(name, scope).filter(|near| is_declared(near) || foreign(&name.to_string()).is_none());
            if let Some(meant) = near.as_ref().filter(|near| is_elsewhere(near, self.names.ambient) && !is_declared(near)) {
                let typed = Typed { sort: "function", name: name.to_string() };
                return self.refuse(name, ValueFact::only_elsewhere(meant.clone(), Some(typed), self.names.ambient));
            }
            let is_force = library::find(&name.to_string(), self.names.ambient).map(|found| found.is_force);
            let near = by_law(name, arguments).or(near);
            return self.refuse(name, NameFact::UnknownFunction { name: name.to_string(), near, is_force });
        }
        let callee = ast::Expression { kind: ExpressionKind::Path(path.clone()), range: path.range, depth: 1 };
        match self.value(&callee, scope)? {
            Value::Function(function) => self.apply(range, path, &function, arguments, scope).map(Value::Scalar),
            other => self.not_a(path.range, Wanted::Function, other.kind()),
        }
    }

    /// True if a function of this name is declared or given as an argument.
    fn is_bound_function(&self, name: &Ident, scope: &Scope) -> bool {
        let declared = scope.space.and_then(|space| self.names.visible(space, &name.to_string()));
        // A body or a joint is no function: one called `turn` does not hide the function.
        scope.bound.iter().any(|(known, _)| name == known) || declared.is_some_and(|group| self.names.group(group).sort.may_be_function())
    }

    /// True if there is a function of this name.
    pub(super) fn is_function(&self, name: &Ident, scope: &Scope) -> bool {
        let word = name.to_string();
        let built_in = BUILTINS.iter().chain(SPATIAL_BUILTINS.iter()).chain(profile::WORDS).chain([&super::speeds::RATE]);
        self.is_bound_function(name, scope) || built_in.into_iter().any(|known| *known == word) || self.is_library_function(name)
    }

    fn similar_function(&self, name: &Ident, scope: &Scope) -> Option<String> {
        let bound = scope.bound.iter().filter(|(_, value)| matches!(value, Value::Function(_))).map(|(known, _)| known.as_str());
        let declared = scope.space.into_iter().flat_map(|space| self.names.functions(space));
        let known = bound
            .chain(BUILTINS.iter().copied())
            .chain(SPATIAL_BUILTINS.iter().copied())
            .chain(profile::WORDS.iter().copied())
            .chain([super::speeds::RATE])
            .chain(library::functions())
            .chain(declared);
        self.nearest(&name.to_string(), known)
    }

    fn builtin(&mut self, range: Range, name: &Ident, arguments: &[ast::Expression], scope: &Scope) -> Option<Value> {
        let word = name.to_string();
        if word == "table" {
            return table(self, name, arguments, scope).map(Value::Scalar);
        }
        let wanted = match word.as_str() {
            "atan2" | "min" | "max" | "dot" | "cross" => 2,
            _ => 1,
        };
        if arguments.len() != wanted {
            return self.refuse(name, ArityFact::FunctionArity { name: word, wanted, found: arguments.len() });
        }
        match word.as_str() {
            _ if is_elsewhere(&word, self.names.ambient) => self.refuse(name, ValueFact::OnlyInPlane { word, typed: None }),
            "dot" | "cross" => self.product(&word, arguments, scope),
            "perp" | "unit" | "norm" | "direction" => self.of_vector(&word, &arguments[0], scope),
            "atan2" | "min" | "max" => self.of_two(range, &word, arguments, scope).map(Value::Scalar),
            _ => self.of_one(&word, &arguments[0], scope).map(Value::Scalar),
        }
    }

    fn of_one(&mut self, word: &str, argument: &ast::Expression, scope: &Scope) -> Option<Scalar> {
        let scalar = self.scalar(argument, scope)?;
        let plain = |this: &mut Self, wanted: Dim| {
            let found = scalar.measure.settled();
            let fact = ValueFact::OfFunction { wanted, found };
            match with_rate(argument) {
                _ if found.is_plain() => Some(()),
                Some(written) if (wanted, found) == (Dim::ANGLE, Dim::TIME) => {
                    this.refuse(argument.range, Fact::Noted { fact: Box::new(fact.into()), note: Note::Instead { written } })
                }
                _ => this.refuse(argument.range, fact),
            }
        };
        let (function, measure) = match word {
            "sin" | "cos" | "tan" => {
                plain(self, Dim::ANGLE)?;
                let function = match word {
                    "sin" => Unary::Sin,
                    "cos" => Unary::Cos,
                    _ => Unary::Tan,
                };
                (function, InferredDim::Known(Dim::NUMBER))
            }
            "asin" | "acos" | "atan" => {
                plain(self, Dim::NUMBER)?;
                let function = match word {
                    "asin" => Unary::Asin,
                    "acos" => Unary::Acos,
                    _ => Unary::Atan,
                };
                (function, InferredDim::Known(Dim::ANGLE))
            }
            "exp" | "ln" => {
                plain(self, Dim::NUMBER)?;
                (if word == "exp" { Unary::Exp } else { Unary::Ln }, InferredDim::Known(Dim::NUMBER))
            }
            "abs" => (Unary::Abs, scalar.measure),
            _ => match scalar.measure.power(3) {
                Some(measure) => (Unary::Sqrt, measure),
                None => return self.refuse(argument.range, ValueFact::PowerOfDimension { base: scalar.measure.settled() }),
            },
        };
        Some(Scalar { expr: self.arena.unary(function, scalar.expr), measure })
    }

    fn of_two(&mut self, range: Range, word: &str, arguments: &[ast::Expression], scope: &Scope) -> Option<Scalar> {
        let (one, two) = (self.scalar(&arguments[0], scope), self.scalar(&arguments[1], scope));
        let (one, two) = (one?, two?);
        let Some(measure) = one.measure.common(two.measure) else {
            return self.refuse(range, ValueFact::Unlike { action: "compare", one: one.measure.settled(), two: two.measure.settled() });
        };
        Some(match word {
            // If neither operand is less, as with NaN, the first one is returned.
            "min" => Scalar { expr: self.arena.select(two.expr, one.expr, two.expr, one.expr), measure },
            "max" => Scalar { expr: self.arena.select(one.expr, two.expr, two.expr, one.expr), measure },
            _ => {
                Scalar { expr: self.arena.binary(crate::expr::Binary::Atan2, one.expr, two.expr), measure: InferredDim::Known(Dim::ANGLE) }
            }
        })
    }

    /// Dot product a·b, or the third component of a × b.
    fn product(&mut self, word: &str, arguments: &[ast::Expression], scope: &Scope) -> Option<Value> {
        let fixed = |this: &mut Self, argument: &ast::Expression| -> Option<(Vector, Option<Fixed>)> {
            let value = this.value(argument, scope)?;
            let fixed = if let Value::Axis(axis) = &value { Some(*axis) } else { None };
            Some((this.vector_of(argument.range, value, Wanted::VectorOrPoint)?, fixed))
        };
        let (one, two) = (fixed(self, &arguments[0]), fixed(self, &arguments[1]));
        let ((one, first), (two, second)) = (one?, two?);
        let measure = one.measure.times(two.measure);
        let arena = &mut self.arena;
        let expr = if let (Some(a), Some(b)) = (one.parts.in_space(), two.parts.in_space()) {
            if word == "cross" {
                return Some(Value::Vector(Vector { parts: Components::space(crate::expr::cross(arena, a, b)), measure }));
            }
            let product = crate::expr::dot(arena, a, b);
            self.note_product(product, first, second);
            product
        } else if word == "dot" {
            let products = one.parts.zip(two.parts, |one, two| arena.mul(one, two));
            arena.sum(&products)
        } else {
            let ([ax, ay], [bx, by]) = (one.parts.in_plane()?, two.parts.in_plane()?);
            let (xy, yx) = (arena.mul(ax, by), arena.mul(ay, bx));
            arena.sub(xy, yx)
        };
        Some(Value::Scalar(Scalar { expr, measure }))
    }

    fn of_vector(&mut self, word: &str, argument: &ast::Expression, scope: &Scope) -> Option<Value> {
        let value = self.value(argument, scope)?;
        if let ("unit" | "norm", Value::Axis(axis)) = (word, &value) {
            // A rotation keeps lengths, so the length of an axis is that of its local coordinates.
            let mut axis = *axis;
            let length = self.length(axis.local);
            if word == "norm" {
                return Some(Value::Scalar(Scalar { expr: length, measure: axis.measure }));
            }
            axis.local = axis.local.map(|part| self.arena.div(part, length));
            axis.measure = InferredDim::Known(Dim::NUMBER);
            return Some(Value::Axis(axis));
        }
        let Vector { parts, measure } = self.vector_of(argument.range, value, Wanted::VectorOrPoint)?;
        Some(match word {
            "perp" => {
                let [x, y] = parts.in_plane()?;
                Value::Vector(Vector { parts: Components::plane(self.arena.neg(y), x), measure })
            }
            "norm" => Value::Scalar(Scalar { expr: self.length(parts), measure }),
            "direction" => {
                let [x, y] = parts.in_plane()?;
                let expr = self.arena.binary(crate::expr::Binary::Atan2, y, x);
                Value::Scalar(Scalar { expr, measure: InferredDim::Known(Dim::ANGLE) })
            }
            _ => {
                let length = self.length(parts);
                let parts = parts.map(|part| self.arena.div(part, length));
                Value::Vector(Vector { parts, measure: InferredDim::Known(Dim::NUMBER) })
            }
        })
    }

    fn length(&mut self, parts: Components) -> Expr {
        let squares = parts.map(|part| self.arena.mul(part, part));
        let sum = self.arena.sum(&squares);
        self.arena.sqrt(sum)
    }

    /// Function with this Rust path; the same path always gets the same number.
    pub(super) fn rust_function(&mut self, path: &ast::Path, from: InferredDim, to: InferredDim) -> FunctionValue {
        let written = path.tokens.to_string();
        let known = self.functions.iter().position(|known| matches!(known, Numbered::Rust(tokens) if tokens.to_string() == written));
        let number = known.unwrap_or_else(|| {
            self.functions.push(Numbered::Rust(path.tokens.clone()));
            self.functions.len() - 1
        });
        FunctionValue::Numbered { number: number as u32, from, to }
    }

    /// Applies a function to its argument.
    fn apply(
        &mut self,
        range: Range,
        path: &ast::Path,
        function: &FunctionValue,
        arguments: &[ast::Expression],
        scope: &Scope,
    ) -> Option<Scalar> {
        let [argument] = arguments else {
            let (name, found) = (path.last.to_string(), arguments.len());
            if found > 1 && name != "wrap" && library::functions().any(|law| law == name) {
                return self.refuse(path.range, ArityFact::LawArity { name, found });
            }
            return self.refuse(path.range, ArityFact::FunctionArity { name, wanted: 1, found });
        };
        let value = self.scalar(argument, scope)?;
        let accepts = |this: &mut Self, from: InferredDim| match from {
            InferredDim::Known(wanted) if !value.measure.fits(wanted) => {
                this.refuse(argument.range, ValueFact::WrongDimension { wanted, found: value.measure.settled() })
            }
            _ => Some(()),
        };
        match function {
            FunctionValue::Numbered { number, from, to } => {
                accepts(self, *from)?;
                Some(Scalar { expr: self.arena.call(*number, 0, value.expr), measure: *to })
            }
            FunctionValue::Written(written) => {
                let from = self.dimension(&written.from)?;
                accepts(self, InferredDim::Known(from))?;
                self.written(range, written, Scalar { measure: InferredDim::Known(from), ..value })
            }
        }
    }

    /// Evaluates the body of a function written in the language.
    pub(super) fn written(&mut self, range: Range, function: &ast::Shared<ast::FunctionItem>, argument: Scalar) -> Option<Scalar> {
        let name = function.name.to_string();
        if let Some(first) = self.names.open_functions.iter().position(|open| *open == name) {
            // A cycle of functions is reported once.
            let circle = &self.names.open_functions[first..];
            let is_in_it = |fact: &Fact| matches!(fact, Fact::Name(NameFact::Recursion { name }) if circle.contains(name));
            let is_known = self.diag.refusals().iter().any(|refusal| is_in_it(&refusal.fact));
            return if is_known { None } else { self.refuse(range, NameFact::Recursion { name }) };
        }
        let key = (function.id(), argument.expr);
        if let Some((_, known)) = self.calls.get(&key) {
            return Some(*known);
        }
        let to = self.dimension(&function.to)?;
        // A function can use its argument, and the parameters and functions of its mechanism.
        let mut inner = Scope::mechanism().timeless("a function of one variable");
        if let Some(formal) = &function.argument {
            inner.bound.push((formal.to_string(), Value::Scalar(argument)));
        }
        self.names.open_functions.push(name);
        // An error in a function is reported once, not again for each call or for each function that calls it.
        let value = self.unless_refused(function, |this| this.scalar_of(&function.value, to, &inner));
        if value.is_none() {
            self.refused.insert(Key::from(function));
        }
        self.names.open_functions.pop();
        self.calls.extend(value.map(|value| (key, (function.clone(), value))));
        value
    }

    pub(super) fn is_library_function(&self, name: &Ident) -> bool {
        library::functions().any(|known| name == known)
    }

    pub(super) fn library_function(&mut self, name: &Ident) -> Option<FunctionValue> {
        library::function(&name.to_string()).map(FunctionValue::Written)
    }
}

impl Valuer for Elaborator<'_> {
    fn arena(&mut self) -> &mut Arena {
        &mut self.arena
    }

    fn number(&mut self, expr: &ast::Expression, scope: &Scope) -> Option<Scalar> {
        self.scalar(expr, scope)
    }

    fn bare(&mut self, written: &ast::Expression, wanted: Dim) {
        self.note_bare(written, wanted);
    }

    fn reject<T>(&mut self, range: Range, fact: impl Into<Fact>) -> Option<T> {
        self.refuse(range, fact)
    }

    fn may_be_fixed(&self, expr: Expr) -> bool {
        self.names.is_abstract() || self.arena.is_fixed(expr)
    }

    fn at_defaults(&self, roots: &[Expr]) -> Vec<f64> {
        self.numbers(&self.defaults, roots)
    }

    fn table_number(&mut self, table: Table) -> u32 {
        let same = |known: &Numbered| matches!(known, Numbered::Table(known) if *known == table);
        let number = self.functions.iter().position(same).unwrap_or_else(|| {
            self.functions.push(Numbered::Table(table.clone()));
            self.functions.len() - 1
        });
        number as u32
    }

    fn require(&mut self, range: Range, requirement: Requirement) {
        if !self.names.is_abstract() && !self.requirements.contains(&requirement) {
            self.requirement_places.push((range, Name::plain(&Ident::new(SEGMENTS, range.first))));
            self.requirements.push(requirement);
        }
    }
}
