//! The expression parser: mathematical precedence, `^` binds tighter than a minus before it.
//!
//! ```text
//! sum     = product (("+" | "-") product)*
//! product = sign (("*" | "/" | "%") sign)*
//! sign    = "-" sign | power
//! power   = postfix ("^" sign)?              right-associative: a^b^c = a^(b^c)
//! postfix = atom ("." name | "[" sum "]")*
//! atom    = number | path | path "(" sum,* ")" | "(" sum,+ ")" | "[" sum,* "]"
//!         | "if" sum relation sum "{" sum "}" "else" ("{" sum "}" | if …)
//! ```

use super::ast::{Expression, ExpressionKind, Operator, Path, Relation};
use super::slip::{
    each_index_by_itself, goes_on, no_brackets, no_choice_behind, no_closure, no_common_unit, no_constant, no_derivative,
    no_index_in_parentheses, no_index_otherwise, no_parentheses, no_percentage, no_quotation, no_reference, no_self, no_truth,
    no_unit_apart, no_unit_raised, one_word, without_module,
};
use super::tokens::{
    Parsed, braces, brackets, equals, expected, is_path, keyword, literal, name, next, parentheses, path, semicolon, wrong,
};
use crate::diag::{GrammarFact, Range};
use crate::quantity;
use proc_macro2::{Delimiter, Span};
use quote::ToTokens;
use std::fmt::Display;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, Lit, LitBool, LitInt, Token, token};

/// `=` between a name and its value; `head` is what stands before it.
pub(super) fn equals_behind(input: ParseStream, head: impl Display) -> Parsed<()> {
    let ahead = input.fork();
    let is_colon = ahead.peek(Token![:]);
    if is_colon {
        ahead.parse::<Token![:]>()?;
    }
    let begins_otherwise = keyword(&ahead).is_some_and(|word| ["at", "is", "of", "to", "be"].iter().any(|other| word == other));
    let value = expression(&ahead).ok().filter(|value| !(begins_otherwise || is_colon && value.name().is_some()));
    let clause = keyword(&ahead).filter(|word| ["from", "at", "with", "along"].iter().any(|known| word == known));
    match value {
        Some(value) if ahead.peek(Token![;]) || clause.is_some() => {
            let rest = if clause.is_some() { " …" } else { "" };
            wrong(input.span(), GrammarFact::WithoutEquals { found: next(input), instead: format!("{head} = {value}{rest};") })
        }
        _ => equals(input),
    }
}

/// The indices behind a name, as they are written.
pub(super) fn in_brackets(indices: &[Expression]) -> String {
    indices.iter().map(|index| format!("[{index}]")).collect()
}

/// `= expression;` behind `head`
pub(super) fn value(input: ParseStream, head: impl Display) -> Parsed<Expression> {
    equals_behind(input, head)?;
    let value = expression(input)?;
    semicolon(input)?;
    Ok(value)
}

/// Largest depth of a tree, so that no walk over it can exhaust the stack; a sum of as many terms is that deep.
const DEPTH: u16 = 200;

/// Largest nesting of parentheses, signs and powers: a level of the parser takes much more of the stack than a level of a walk.
pub(super) const NESTING: u16 = 50;

/// Parses one expression.
pub(super) fn expression(input: ParseStream) -> Parsed<Expression> {
    sum(input, NESTING)
}

/// Parses the relation between two expressions.
pub(super) fn relation(input: ParseStream) -> Parsed<Relation> {
    // The two-character tokens come first, since `<` is also the start of `<=`.
    let relation = if input.peek(Token![==]) {
        input.parse::<Token![==]>().map(|_| Relation::Equal)
    } else if input.peek(Token![!=]) {
        input.parse::<Token![!=]>().map(|_| Relation::Different)
    } else if input.peek(Token![<=]) {
        input.parse::<Token![<=]>().map(|_| Relation::LessOrEqual)
    } else if input.peek(Token![>=]) {
        input.parse::<Token![>=]>().map(|_| Relation::GreaterOrEqual)
    } else if input.peek(Token![<]) {
        input.parse::<Token![<]>().map(|_| Relation::Less)
    } else if input.peek(Token![>]) {
        input.parse::<Token![>]>().map(|_| Relation::Greater)
    } else {
        return expected(input, "a relation such as `<` or `>=`");
    };
    Ok(relation?)
}

pub(super) fn sum(input: ParseStream, room: u16) -> Parsed<Expression> {
    let mut left = product(input, room)?;
    loop {
        let operator = if input.peek(Token![+]) {
            input.parse::<Token![+]>()?;
            Operator::Add
        } else if input.peek(Token![-]) {
            input.parse::<Token![-]>()?;
            Operator::Sub
        } else {
            no_choice_behind(input, &left, room)?;
            return Ok(left);
        };
        left = binary(operator, left, product(input, room)?)?;
    }
}

fn product(input: ParseStream, room: u16) -> Parsed<Expression> {
    let mut left = sign(input, room)?;
    loop {
        let operator = if input.peek(Token![*]) {
            let star = input.parse::<Token![*]>()?.spans[0];
            if input.peek(Token![*]) {
                return wrong(Range::from(star).to(input.span()), GrammarFact::DoubleStar);
            }
            Operator::Mul
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            Operator::Div
        } else if input.peek(Token![%]) {
            input.parse::<Token![%]>()?;
            Operator::Rem
        } else if input.peek(Token![as]) {
            return wrong(
                input.span(),
                GrammarFact::Misspelt { flaw: "every number is real, and needs no conversion", instead: left.to_string() },
            );
        } else {
            return Ok(left);
        };
        let right = sign(input, room)?;
        if operator == Operator::Div {
            no_derivative(&left, &right)?;
        }
        left = binary(operator, left, right)?;
    }
}

fn sign(input: ParseStream, room: u16) -> Parsed<Expression> {
    if input.peek(Token![-]) {
        let minus = input.parse::<Token![-]>()?.spans[0];
        let value = sign(input, deeper(room, minus.into())?)?;
        let range = Range::from(minus).to(value.range);
        return node(ExpressionKind::Negative(Box::new(value)), range);
    }
    power(input, room)
}

fn power(input: ParseStream, room: u16) -> Parsed<Expression> {
    let is_literal = input.cursor().literal().is_some();
    let base = postfix(input, room)?;
    if !input.peek(Token![^]) {
        return Ok(base);
    }
    if let (true, ExpressionKind::Number { digits, unit }, Some(exponent)) = (is_literal, &base.kind, raised(input)) {
        let whole = format!("{unit}{exponent}");
        if quantity::unit(unit).is_none() && quantity::unit(&whole).is_some() {
            let (flaw, instead) = ("a unit is one word", format!("{digits}{whole}"));
            input.parse::<Token![^]>()?;
            let range = base.range.to(input.span());
            return wrong(range, GrammarFact::Misspelt { flaw, instead });
        }
        // `4m^2` may be a square; a unit of a rate is one word.
        if unit.contains('_') && quantity::unit(&whole).is_some() {
            let (written, squared) = (format!("{digits}{unit}^{exponent}"), format!("({digits}{unit})^{exponent}"));
            return wrong(base.range, GrammarFact::UnitRaised { written, unit: format!("{digits}{whole}"), squared });
        }
    }
    let caret = input.parse::<Token![^]>()?.spans[0];
    if is_literal && matches!(&base.kind, ExpressionKind::Number { digits, unit } if digits == "10" && unit.is_empty()) {
        no_unit_raised(input, &base)?;
    }
    let exponent = sign(input, deeper(room, caret.into())?)?;
    binary(Operator::Power, base, exponent)
}

fn postfix(input: ParseStream, room: u16) -> Parsed<Expression> {
    let mut value = atom(input, room)?;
    if let ExpressionKind::Number { digits, unit } = &value.kind
        && unit.is_empty()
    {
        no_percentage(input, &value, digits)?;
        no_brackets(input, &value, digits)?;
    }
    loop {
        if input.peek(token::Bracket) {
            let (index, range) = self::index(input, deeper(room, input.span().into())?)?;
            let range = value.range.to(range);
            value = node(ExpressionKind::Index(Box::new(value), Box::new(index)), range)?;
            continue;
        }
        // `..` ends the first bound of a loop.
        if !input.peek(Token![.]) || input.peek(Token![..]) {
            return Ok(value);
        }
        input.parse::<Token![.]>()?;
        if !input.peek(Ident) {
            return expected(input, "a name after `.`");
        }
        let field: Ident = input.parse()?;
        if input.peek(token::Paren) {
            without_module(input, &value, &field, room)?;
            no_index_in_parentheses(input, &value, &field, room)?;
            return wrong(&field, GrammarFact::MethodCall { name: field.to_string() });
        }
        no_self(&value, &field)?;
        let range = value.range.to(&field);
        value = node(ExpressionKind::Field(Box::new(value), field), range)?;
    }
}

/// `[index]` after a name, with the range of its brackets.
fn index(input: ParseStream, room: u16) -> Parsed<(Expression, Range)> {
    let (content, range) = brackets(input)?;
    let index = sum(&content, room)?;
    each_index_by_itself(&content, &index, room)?;
    if content.is_empty() { Ok((index, range)) } else { expected(&content, "`]`") }
}

/// A name with its indices.
pub(super) fn declared(input: ParseStream, what: &'static str) -> Parsed<(Ident, Vec<Expression>)> {
    let name = name(input, what)?;
    one_word(input, &name, false)?;
    no_index_otherwise(input, &name)?;
    Ok((name, indices(input)?))
}

/// `[i][j]` after a declared name.
pub(super) fn indices(input: ParseStream) -> Parsed<Vec<Expression>> {
    let mut indices = Vec::new();
    while input.peek(token::Bracket) {
        indices.push(index(input, NESTING)?.0);
    }
    Ok(indices)
}

fn atom(input: ParseStream, room: u16) -> Parsed<Expression> {
    let room = deeper(room, input.span().into())?;
    if literal(input)? || input.peek(LitBool) {
        return number(input);
    }
    if input.peek(Token![if]) {
        return choice(input, room);
    }
    if input.peek(token::Paren) {
        return parenthesised(input, room);
    }
    if input.peek(token::Bracket) {
        let (content, range) = brackets(input)?;
        return node(ExpressionKind::List(list(&content, room)?), range);
    }
    // A function of other languages, a word of Rust.
    if input.peek(Token![mod]) && input.peek2(token::Paren) {
        let word = Ident::parse_any(input)?;
        let range = Range::from(&word);
        return call(input, Path { tokens: word.to_token_stream(), last: word.clone(), name: Some(word), range }, room);
    }
    if is_path(input) {
        let path = path(input)?;
        if input.peek(token::Paren) {
            return call(input, path, room);
        }
        no_constant(&path)?;
        no_bare_argument(input, &path, room)?;
        let range = path.range;
        return node(ExpressionKind::Path(path), range);
    }
    no_closure(input, room)?;
    no_reference(input, room)?;
    if input.peek(Token![return]) {
        return wrong(input.span(), GrammarFact::Return { is_segment: input.peek2(token::Paren) });
    }
    expected(input, "an expression")
}

/// Refuses `sin b.angle`.
fn no_bare_argument(input: ParseStream, path: &Path, room: u16) -> Parsed<()> {
    const FUNCTIONS: [&str; 10] = ["sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "ln", "rate"];
    let is_function = path.name.as_ref().is_some_and(|name| FUNCTIONS.iter().any(|function| name == function));
    let is_behind = input.peek(Lit) || keyword(input).is_some_and(|word| !goes_on(&word));
    if !is_function || !is_behind {
        return Ok(());
    }
    let argument = power(&input.fork(), room)?;
    let instead = format!("{}({argument})", path.last);
    wrong(path.range.to(argument.range), GrammarFact::Misspelt { flaw: "a function has its argument in parentheses", instead })
}

fn number(input: ParseStream) -> Parsed<Expression> {
    let literal: Lit = input.parse()?;
    let range = Range::from(literal.span());
    no_quotation(&literal)?;
    let (digits, unit) = match &literal {
        Lit::Int(int) => (as_written(int), int.suffix().to_owned()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix().to_owned()),
        _ => return wrong(range, GrammarFact::NotANumber { found: literal_kind(&literal) }),
    };
    if unit.is_empty() {
        no_unit_apart(input, range, &digits)?;
    }
    if is_unit(input) {
        let (number, next) = (literal.to_token_stream().to_string(), input.parse::<Ident>()?);
        return wrong(range.to(&next), GrammarFact::SpaceBeforeUnit { number, suffix: unit, unit: next.to_string() });
    }
    if input.peek(token::Paren) {
        let (number, bounds) = (literal.to_token_stream().to_string(), input.cursor().group(Delimiter::Parenthesis));
        let is_range = bounds.is_some_and(|(inside, ..)| inside.token_stream().to_string().contains(".."));
        return wrong(range.to(input.span()), GrammarFact::NumberBeforeParentheses { number, is_range });
    }
    node(ExpressionKind::Number { digits, unit }, range)
}

/// The digits of a whole number with the zeros before it, which count behind a comma.
fn as_written(int: &LitInt) -> String {
    let text = int.to_string();
    let digits = text.strip_suffix(int.suffix()).unwrap_or(&text);
    let is_decimal = digits.bytes().all(|digit| digit.is_ascii_digit());
    if is_decimal { digits.to_owned() } else { int.base10_digits().to_owned() }
}

/// True if a word follows that ends the expression: after a number it can only be meant as a unit.
pub(super) fn is_unit(input: ParseStream) -> bool {
    let ahead = input.fork();
    // `a - 30deg from -5deg`, `from 0 at -3rad_s`
    ahead.parse::<Ident>().is_ok_and(|word| word != "at" && word != "from") && (is_end(&ahead) || ahead.peek(Token![-]))
}

/// True where no number can follow.
pub(super) fn is_end(input: ParseStream) -> bool {
    input.is_empty()
        || input.peek(Token![;])
        || input.peek(Token![,])
        || input.peek(Token![+])
        || input.peek(Token![*])
        || input.peek(Token![/])
        || input.peek(Token![%])
        || input.peek(Token![..])
}

fn literal_kind(literal: &Lit) -> &'static str {
    match literal {
        Lit::Str(_) => "a string",
        Lit::Bool(_) => "a truth value",
        Lit::Char(_) | Lit::Byte(_) => "a character",
        _ => "a literal that is no number",
    }
}

fn parenthesised(input: ParseStream, room: u16) -> Parsed<Expression> {
    let (content, range) = parentheses(input)?;
    let mut items = list(&content, room)?;
    match items.len() {
        0 => wrong(range, GrammarFact::Expected { what: "an expression", found: "`()`".into() }),
        1 => {
            // Parentheses around one value only group it.
            let inner = items.remove(0);
            if is_unit(input)
                && let Some(unit) = keyword(input).filter(|word| quantity::unit(&word.to_string()).is_some())
            {
                let fact = GrammarFact::UnitBehindParentheses { written: inner.to_string(), unit: unit.to_string() };
                return wrong(range.to(&unit), fact);
            }
            Ok(Expression { range, ..inner })
        }
        _ => {
            no_common_unit(input, &items, range)?;
            node(ExpressionKind::Tuple(items), range)
        }
    }
}

fn call(input: ParseStream, path: Path, room: u16) -> Parsed<Expression> {
    let (content, range) = parentheses(input)?;
    let arguments = list(&content, room)?;
    let range = path.range.to(range);
    const VECTORS: [&str; 8] = ["Vec2", "Vec3", "DVec2", "DVec3", "Vector2", "Vector3", "Point2", "Point3"];
    let is_vector = || path.tokens.to_string().rsplit("::").nth(1).is_some_and(|kind| VECTORS.contains(&kind.trim()));
    if path.name.is_none() && path.last == "new" && matches!(arguments.len(), 2 | 3) && is_vector() {
        let parts: Vec<String> = arguments.iter().map(ToString::to_string).collect();
        let instead = format!("({})", parts.join(", "));
        return wrong(range, GrammarFact::Misspelt { flaw: "a vector is written by its components", instead });
    }
    node(ExpressionKind::Call(path, arguments), range)
}

pub(super) fn list(content: ParseStream, room: u16) -> Parsed<Vec<Expression>> {
    let mut items = Vec::new();
    while !content.is_empty() {
        if content.peek(Ident) && content.peek2(Token![:]) && !content.peek2(Token![::]) {
            return without_names(content, items, room);
        }
        items.push(sum(content, room)?);
        if content.is_empty() {
            break;
        }
        if !content.peek(Token![,]) {
            no_truth(content)?;
            return expected(content, "`,` or the end of the list");
        }
        content.parse::<Token![,]>()?;
    }
    Ok(items)
}

/// Refuses `(a: x, b: y)`.
fn without_names<T>(content: ParseStream, items: Vec<Expression>, room: u16) -> Parsed<T> {
    let first = content.span();
    let (mut items, mut names) = (items.iter().map(ToString::to_string).collect::<Vec<_>>(), Vec::new());
    while !content.is_empty() {
        if content.peek2(Token![:]) {
            names.push(name(content, "a name")?.to_string());
            content.parse::<Token![:]>()?;
        }
        items.push(sum(content, room)?.to_string());
        content.parse::<Option<Token![,]>>()?;
    }
    let (flaw, instead) = match (items.as_slice(), names.as_slice()) {
        ([diameter], [name]) if ["d", "D", "diameter"].contains(&name.as_str()) => {
            ("a round shape takes its radius, and values in parentheses have no names", format!("({diameter} / 2)"))
        }
        _ => ("values in parentheses have no names here", format!("({})", items.join(", "))),
    };
    wrong(first, GrammarFact::Misspelt { flaw, instead })
}

/// The whole number after `^`.
fn raised(input: ParseStream) -> Option<String> {
    let ahead = input.fork();
    ahead.parse::<Token![^]>().ok()?;
    let (literal, _) = ahead.cursor().literal()?;
    Some(literal.to_string()).filter(|text| text.bytes().all(|digit| digit.is_ascii_digit()))
}

fn choice(input: ParseStream, room: u16) -> Parsed<Expression> {
    let first: Span = input.parse::<Token![if]>()?.span;
    no_parentheses(input)?;
    let lhs = sum(input, room)?;
    let relation = relation(input)?;
    let rhs = sum(input, room)?;
    if input.peek(Token![&&]) || input.peek(Token![||]) {
        return wrong(input.span(), GrammarFact::TwoConditions);
    }
    let then = braced(input, room)?;
    if !input.peek(Token![else]) {
        return expected(input, "`else { value }`");
    }
    input.parse::<Token![else]>()?;
    let otherwise = if input.peek(Token![if]) { choice(input, deeper(room, first.into())?)? } else { braced(input, room)? };
    let range = Range::from(first).to(otherwise.range);
    let [lhs, rhs, then, otherwise] = [lhs, rhs, then, otherwise].map(Box::new);
    node(ExpressionKind::If { lhs, relation, rhs, then, otherwise }, range)
}

fn braced(input: ParseStream, room: u16) -> Parsed<Expression> {
    if !input.peek(token::Brace) {
        return expected(input, "`{ value }`");
    }
    let (content, range) = braces(input)?;
    let inner = sum(&content, room)?;
    if !content.is_empty() {
        return expected(&content, "`}`");
    }
    Ok(Expression { range, ..inner })
}

fn binary(operator: Operator, left: Expression, right: Expression) -> Parsed<Expression> {
    let range = left.range.to(right.range);
    node(ExpressionKind::Binary(operator, Box::new(left), Box::new(right)), range)
}

pub(super) fn deeper(room: u16, range: Range) -> Parsed<u16> {
    match room.checked_sub(1) {
        Some(room) => Ok(room),
        None => wrong(range, GrammarFact::TooDeep { limit: NESTING }),
    }
}

/// Makes a node, or reports that it is too deep.
fn node(kind: ExpressionKind, range: Range) -> Parsed<Expression> {
    let below = match &kind {
        ExpressionKind::Number { .. } | ExpressionKind::Path(_) => 0,
        ExpressionKind::Field(value, _) | ExpressionKind::Negative(value) => value.depth,
        ExpressionKind::Binary(_, left, right) | ExpressionKind::Index(left, right) => left.depth.max(right.depth),
        ExpressionKind::Call(_, items) | ExpressionKind::Tuple(items) | ExpressionKind::List(items) => {
            items.iter().map(|item| item.depth).max().unwrap_or(0)
        }
        ExpressionKind::If { lhs, rhs, then, otherwise, .. } => {
            [lhs, rhs, then, otherwise].iter().map(|item| item.depth).max().unwrap_or(0)
        }
    };
    if below >= DEPTH {
        return wrong(range, GrammarFact::TooLong { limit: DEPTH });
    }
    Ok(Expression { kind, range, depth: below + 1 })
}
