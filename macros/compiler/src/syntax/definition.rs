//! Parses definitions of constraints, and the statements that they share with mechanisms.

use super::ast::{
    Added, Applied, Condition, Definition, Dimension, Expression, ExpressionKind, Formal, FormalKind, Let, MassItem, Statement,
};
use super::dimension::{dimension, dimension_of_value, required_dimension};
use super::expression::{declared, expression, in_brackets, relation, value};
use super::tokens::{
    Parsed, block, comma, docs, equals, expected, keyword, name, parentheses, report, semicolon, statement_text, visibility, wrong,
};
use crate::diag::{Diag, GrammarFact, MotionFact};
use crate::quantity::Ambient;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{LitStr, Token, token};

/// A definition of the library.
pub(super) fn single_definition(input: ParseStream, diag: &mut Diag) -> Option<Definition> {
    report(definition(input), diag)
}

/// `constraint name(parameters) { statements }`, or the same with `force`
pub(super) fn definition(input: ParseStream) -> Parsed<Definition> {
    let docs = docs(input)?;
    visibility(input)?;
    let is_force = match keyword(input) {
        Some(word) if word == "constraint" => false,
        Some(word) if word == "force" => true,
        _ => return expected(input, "`constraint name(…) { … }`"),
    };
    Ident::parse_any(input)?;
    let name = name(input, "the name of the constraint")?;
    let parameters = formals(input, "`(` and the parameters of the constraint")?;
    let ambient = ambient(input)?;
    let content = block(input, "`{` and the equations of the constraint")?;
    let mut statements = Vec::new();
    while !content.is_empty() {
        statements.push(statement(&content)?);
    }
    Ok(Definition { docs, name, parameters, ambient, is_force, statements })
}

/// `(name: kind, …)`
pub(super) fn formals(input: ParseStream, what: &'static str) -> Parsed<Vec<Formal>> {
    if !input.peek(token::Paren) {
        return expected(input, what);
    }
    let (content, _) = parentheses(input)?;
    let mut parameters = Vec::new();
    while !content.is_empty() {
        parameters.push(formal(&content)?);
        comma(&content, "`,` or `)`")?;
    }
    Ok(parameters)
}

fn formal(input: ParseStream) -> Parsed<Formal> {
    docs(input)?;
    let name = name(input, "the name of a parameter")?;
    if !input.peek(Token![:]) {
        return expected(input, "`:` and what the parameter takes, such as `Point` or `Length`");
    }
    input.parse::<Token![:]>()?;
    let kind = kind(input)?;
    let default = if input.peek(Token![=]) {
        equals(input)?;
        Some(expression(input)?)
    } else {
        None
    };
    Ok(Formal { name, kind, default })
}

fn kind(input: ParseStream) -> Parsed<FormalKind> {
    let Some(word) = keyword(input) else {
        return expected(input, "what the parameter takes: `Point`, `Axis`, `Body`, `Length`, `Angle`, `Quantity`, …");
    };
    let plain = match word.to_string().as_str() {
        "Point" => FormalKind::Point,
        "Axis" => FormalKind::Axis,
        "Body" => FormalKind::Body,
        "Quantity" => FormalKind::Quantity,
        "Function" => return function_kind(input),
        "Joint" => return joint_kind(input),
        _ => return dimension(input).map(FormalKind::Scalar),
    };
    input.parse::<Ident>()?;
    Ok(plain)
}

/// `Function(Angle) -> Length`
fn function_kind(input: ParseStream) -> Parsed<FormalKind> {
    input.parse::<Ident>()?;
    if !input.peek(token::Paren) {
        return expected(input, "`(Dimension) -> Dimension`");
    }
    let (content, _) = parentheses(input)?;
    let from = dimension(&content)?;
    if !content.is_empty() {
        return wrong(content.span(), GrammarFact::OneArgument);
    }
    Ok(FormalKind::Function(from, dimension_of_value(input)?))
}

/// `Joint(translational)`
fn joint_kind(input: ParseStream) -> Parsed<FormalKind> {
    input.parse::<Ident>()?;
    if !input.peek(token::Paren) {
        return expected(input, "`(` and the kind of the joint");
    }
    let (content, _) = parentheses(input)?;
    let kind = name(&content, "the kind of the joint")?;
    if !content.is_empty() {
        return wrong(content.span(), GrammarFact::TokensAfter { what: "the kind of the joint", help: "write `Joint(kind)`" });
    }
    Ok(FormalKind::Joint(kind))
}

/// `let name = value;`, `require lhs != rhs: "why";`, `at point: force;`, `potential: energy;`, `add mass at point: mass;` or `lhs == rhs;`
pub(super) fn statement(input: ParseStream) -> Parsed<Statement> {
    docs(input)?;
    if input.peek(Token![let]) {
        let binding = binding(input)?;
        return match binding.indices.first() {
            None => Ok(Statement::Let(binding)),
            Some(index) => wrong(index.range, GrammarFact::IndexInEquations { name: binding.name.to_string() }),
        };
    }
    let is_requirement = keyword(input).is_some_and(|word| word == "require") && !input.peek2(Token![.]) && !input.peek2(Token![==]);
    if is_requirement {
        return requirement(input).map(Statement::Require);
    }
    let applies = keyword(input).filter(|word| word == "at" || word == "on");
    if let Some(word) = applies
        && !input.peek2(Token![.])
        && !input.peek2(Token![==])
    {
        return applied(input, word == "on").map(Statement::Apply);
    }
    if keyword(input).is_some_and(|word| word == "potential") && input.peek2(Token![:]) {
        input.parse::<Ident>()?;
        input.parse::<Token![:]>()?;
        let energy = expression(input)?;
        semicolon(input)?;
        return Ok(Statement::Potential(energy));
    }
    if keyword(input).is_some_and(|word| word == "add") && input.peek2(syn::Ident::peek_any) {
        return added(input).map(Statement::Add);
    }
    let lhs = expression(input)?;
    if input.peek(Token![:]) {
        return wrong(lhs.range, MotionFact::PlaceWithoutAt { place: lhs.to_string() });
    }
    if input.peek(Token![=]) && !input.peek(Token![==]) {
        return wrong(input.span(), GrammarFact::OneEqualsSign);
    }
    if !input.peek(Token![==]) {
        return expected(input, "`==` and the other side of the equation");
    }
    input.parse::<Token![==]>()?;
    let rhs = expression(input)?;
    semicolon(input)?;
    Ok(Statement::Equation(lhs, rhs))
}

/// `at point: force;` or `on body: torque;`
fn applied(input: ParseStream, is_torque: bool) -> Parsed<Applied> {
    input.parse::<Ident>()?;
    let target = expression(input)?;
    if !input.peek(Token![:]) {
        return expected(input, if is_torque { "`:` and the torque" } else { "`:` and the force" });
    }
    input.parse::<Token![:]>()?;
    let before = input.fork();
    let value = expression(input)?;
    if input.peek(Token![,]) && !matches!(value.kind, ExpressionKind::Tuple(..)) {
        let (what, instead) = (if is_torque { "a torque" } else { "a force" }, format!("({})", statement_text(&before)?));
        return wrong(value.range, GrammarFact::WithoutParentheses { what, instead });
    }
    semicolon(input)?;
    Ok(Applied { is_torque, target, value })
}

/// `add mass at point: mass;` or `add inertia on body: inertia;`
fn added(input: ParseStream) -> Parsed<Added> {
    input.parse::<Ident>()?;
    let Some(what) = keyword(input).filter(|word| word == "mass" || word == "inertia") else {
        return expected(input, "`mass at point: …;` or `inertia on body: …;`");
    };
    Ident::parse_any(input)?;
    let preposition = if what == "mass" { "at" } else { "on" };
    if keyword(input).is_none_or(|word| word != preposition) {
        return expected(input, if what == "mass" { "`at` and the point of the mass" } else { "`on` and the body" });
    }
    Ident::parse_any(input)?;
    let target = expression(input)?;
    if !input.peek(Token![:]) {
        return expected(input, if what == "mass" { "`:` and the mass" } else { "`:` and the inertia" });
    }
    input.parse::<Token![:]>()?;
    Ok(Added { target, item: mass(input, what)? })
}

/// `require lhs != rhs: "why";`
fn requirement(input: ParseStream) -> Parsed<Condition> {
    input.parse::<Ident>()?;
    let lhs = expression(input)?;
    let relation = relation(input)?;
    let rhs = expression(input)?;
    if !input.peek(Token![:]) {
        return expected(input, "`:` and a sentence that says why");
    }
    input.parse::<Token![:]>()?;
    if !input.peek(LitStr) {
        return expected(input, "a sentence in quotation marks");
    }
    let why = input.parse::<LitStr>()?.value();
    semicolon(input)?;
    Ok(Condition { lhs, relation, rhs, why })
}

/// `in space` or `in plane`, if written.
pub(super) fn ambient(input: ParseStream) -> Parsed<Option<Ambient>> {
    if !input.peek(Token![in]) {
        return Ok(None);
    }
    input.parse::<Token![in]>()?;
    let word = keyword(input).map(|word| word.to_string());
    let found = match word.as_deref() {
        Some("space") => Ambient::Space,
        Some("plane") => Ambient::Plane,
        _ => return expected(input, "`space` or `plane`"),
    };
    Ident::parse_any(input)?;
    Ok(Some(found))
}

/// True before `: usize`.
fn is_type_of_rust(input: ParseStream) -> bool {
    const TYPES: [&str; 14] = ["usize", "isize", "u8", "u16", "u32", "u64", "i8", "i16", "i32", "i64", "f32", "f64", "int", "float"];
    input.parse::<Token![:]>().is_ok() && keyword(input).is_some_and(|word| TYPES.iter().any(|known| word == known))
}

/// `let name: Dimension = value;`
pub(super) fn binding(input: ParseStream) -> Parsed<Let> {
    input.parse::<Token![let]>()?;
    let (name, indices) = declared(input, "a name after `let`")?;
    let before = input.fork();
    let dimension = if input.peek(Token![:]) { Some(required_dimension(input)?) } else { None };
    if let Some(Dimension { range, .. }) = dimension.as_ref().filter(|_| is_type_of_rust(&before)) {
        equals(input)?;
        let instead = format!("let {name}{} = {};", in_brackets(&indices), expression(input)?);
        return wrong(*range, GrammarFact::Misspelt { flaw: "a `let` takes its dimension from its value, and no type", instead });
    }
    let value = value(input, format_args!("let {name}{}", in_brackets(&indices)))?;
    Ok(Let { name, indices, dimension, value })
}

/// Refuses a matrix as an inertia.
fn no_matrix(what: &Ident, value: &Expression) -> Parsed<()> {
    let parts = |value: &Expression| match &value.kind {
        ExpressionKind::Tuple(parts) | ExpressionKind::List(parts) if parts.len() == 3 => {
            Some(parts.iter().map(ToString::to_string).collect())
        }
        _ => None,
    };
    let (ExpressionKind::Tuple(rows) | ExpressionKind::List(rows)) = &value.kind else { return Ok(()) };
    let rows: Option<Vec<Vec<String>>> = rows.iter().map(parts).collect();
    let Some([x, y, z]) = rows.as_deref().filter(|_| what == "inertia") else { return Ok(()) };
    let is_zero = |product: &String| product.split(char::is_alphabetic).next().unwrap_or_default().parse() == Ok(0.0);
    let (mut entries, products) = (vec![x[0].as_str(), &y[1], &z[2]], [&x[1], &x[2], &y[2]]);
    if !products.into_iter().all(is_zero) {
        entries.extend(products.into_iter().map(String::as_str));
    }
    let instead = format!("inertia = ({});", entries.join(", "));
    wrong(
        value.range,
        GrammarFact::Misspelt {
            flaw: "an inertia is not a matrix: in the plane it is one number, in space three, or six with products of inertia",
            instead,
        },
    )
}

/// The value of a mass, a centre or an inertia.
pub(super) fn mass(input: ParseStream, what: Ident) -> Parsed<MassItem> {
    let value = expression(input)?;
    let is_turned = what == "inertia" && keyword(input).is_some_and(|word| word == "along");
    let along = if is_turned {
        Ident::parse_any(input)?;
        Some(expression(input)?)
    } else {
        None
    };
    no_matrix(&what, &value)?;
    if let Some(word) = keyword(input).filter(|word| what == "inertia" && (word == "about" || word == "at")) {
        let flaw = "an inertia is about the centre of mass, whose place is an item of its own";
        return wrong(&word, GrammarFact::Misspelt { flaw, instead: format!("inertia = {value}; center = (…);") });
    }
    semicolon(input)?;
    Ok(MassItem { what, value, along })
}
