//! Parses bodies and ground: points and axes fixed in them, starts and masses.

use super::ast::{Docs, Expression, ExpressionKind, Feature, FrameItem, Marks, Shared, Start};
use super::definition::mass;
use super::expression::{declared, equals_behind, expression, in_brackets, value};
use super::item::{ItemContext, indexed};
use super::repeated::repeated_marks;
use super::tokens::{Parsed, block, docs, expected, keyword, name, next, report, semicolon, skip_statement, statement_text, wrong};
use crate::diag::{Diag, GrammarFact};
use crate::quantity::Ambient;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// `ground { … }`
pub(super) fn ground(input: ParseStream, docs: Docs, diag: &mut Diag) -> Parsed<FrameItem> {
    let name = Ident::parse_any(input)?;
    let mut ground = frame(input, docs, (name, Vec::new()), "`{` and the points of ground", diag)?;
    if let Some(item) = ground.masses.drain(..).next() {
        diag.refuse::<()>(&item.what, GrammarFact::MassOfGround { word: item.what.to_string() });
    }
    Ok(ground)
}

/// `body name { … }`
pub(super) fn body(input: ParseStream, docs: Docs, diag: &mut Diag) -> Parsed<FrameItem> {
    Ident::parse_any(input)?;
    let name = declared(input, "the name of the body")?;
    if !input.peek(token::Brace) {
        return wrong(
            input.span(),
            GrammarFact::BodyWithoutBraces { name: format!("{}{}", name.0, in_brackets(&name.1)), found: next(input) },
        );
    }
    frame(input, docs, name, "`{`", diag)
}

/// The items of a body. A rejected one is left out, and parsing goes on with the next.
fn frame(
    input: ParseStream,
    docs: Docs,
    (name, indices): (Ident, Vec<Expression>),
    what: &'static str,
    diag: &mut Diag,
) -> Parsed<FrameItem> {
    let content = block(input, what)?;
    let mut frame = FrameItem { docs, name, indices, marks: Marks::default(), starts: Vec::new(), masses: Vec::new() };
    while !content.is_empty() {
        if report(frame_item(&content, &mut frame), diag).is_none() {
            skip_statement(&content);
        }
    }
    Ok(frame)
}

fn frame_item(content: ParseStream, frame: &mut FrameItem) -> Parsed<()> {
    // Points may have doc comments; no item is generated that could carry them.
    docs(content)?;
    if keyword(content).is_some_and(|word| word == "start") {
        frame.starts.push(start(content)?);
    } else if let Some(what) = keyword(content).filter(|word| ["mass", "center", "inertia"].iter().any(|known| word == known)) {
        Ident::parse_any(content)?;
        equals_behind(content, &what)?;
        frame.masses.push(mass(content, what)?);
    } else {
        marks(content, &mut frame.marks, ItemContext::top(Ambient::default()))?;
    }
    Ok(())
}

/// A point, an axis, or a loop over them.
pub(super) fn marks(input: ParseStream, marks: &mut Marks, place: ItemContext) -> Parsed<()> {
    let Some(keyword) = keyword(input) else {
        return expected(input, "`point`, `axis` or `start`");
    };
    match keyword.to_string().as_str() {
        "point" | "axis" => {
            let mark = mark(input)?;
            indexed(&mark.name, &mark.indices, place)?;
            marks.single.push(Shared::new(mark));
        }
        "for" => marks.loops.push(Shared::new(repeated_marks(input)?)),
        "start" => return wrong(&keyword, GrammarFact::StartInLoop),
        other => {
            let word = other.to_owned();
            let is_point =
                input.peek2(token::Paren) || [input.peek2(Token![=]), input.peek2(Token![:])] != [false; 2] && input.peek3(token::Paren);
            return wrong(&keyword, GrammarFact::UnknownBodyItem { word, is_point });
        }
    }
    Ok(())
}

/// `point name = (x, y);` or `axis name = (x, y);`
fn mark(input: ParseStream) -> Parsed<Feature> {
    let is_axis = Ident::parse_any(input)? == "axis";
    let (name, indices) = declared(input, if is_axis { "the name of the axis" } else { "the name of the point" })?;
    equals_behind(input, format_args!("{} {name}{}", if is_axis { "axis" } else { "point" }, in_brackets(&indices)))?;
    let before = input.fork();
    let value = expression(input)?;
    if input.peek(Token![,]) && !matches!(value.kind, ExpressionKind::Tuple(..)) {
        let (what, instead) = (if is_axis { "an axis" } else { "a point" }, format!("({})", statement_text(&before)?));
        return wrong(value.range, GrammarFact::WithoutParentheses { what, instead });
    }
    let zero = if is_axis && keyword(input).is_some_and(|word| word == "from") {
        Ident::parse_any(input)?;
        Some(expression(input)?)
    } else {
        None
    };
    semicolon(input)?;
    Ok(Feature { is_axis, name, indices, value, zero })
}

/// `start angle = value;`
fn start(input: ParseStream) -> Parsed<Start> {
    Ident::parse_any(input)?;
    let what = name(input, "`x`, `y`, `angle` or `position`")?;
    if input.peek(Token![.]) {
        return wrong(&what, GrammarFact::StartOfJoint);
    }
    let value = value(input, format_args!("start {what}"))?;
    Ok(Start { what, value })
}
