//! The items of a mechanism.

use super::ast::{
    Argument, Dimension, Expr, Frame, Function, Item, Joint, JointBody, Let, Mark, Mechanism, Output, Parameter, Start, Use,
};
use super::definition::statement;
use super::expression::expression;
use super::tokens::{
    Parsed, attributes, block, braces, docs, equals, expected, name, parentheses, path, semicolon, skip_item, visibility, wrong,
};
use crate::diag::{Diag, Fact, Range};
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{LitInt, Token, token};

/// `pub mechanism Name { items }`
pub(super) fn mechanism(input: ParseStream, diag: &mut Diag) -> Option<Mechanism> {
    let read_head = || -> Parsed<Mechanism> {
        let (docs, options) = attributes(input)?;
        let mut equations_only = false;
        for option in options {
            if option != "equations_only" {
                return wrong(&option, Fact::UnknownAttribute { name: option.to_string() });
            }
            equations_only = true;
        }
        let visibility = visibility(input)?;
        if !input.peek(Ident::peek_any) || input.fork().call(Ident::parse_any)? != "mechanism" {
            return expected(input, "`mechanism Name { … }`");
        }
        Ident::parse_any(input)?;
        let name = name(input, "the name of the mechanism")?;
        Ok(Mechanism { docs, equations_only, visibility, name, items: Vec::new() })
    };
    let mut mechanism = report(read_head(), diag)?;
    let content = match block(input, "`{` and the items of the mechanism") {
        Ok(content) => content,
        Err(refusal) => {
            diag.refuse::<()>(refusal.range, refusal.fact);
            return Some(mechanism);
        }
    };
    while !content.is_empty() {
        match item(&content) {
            Ok(item) => mechanism.items.push(item),
            Err(refusal) => {
                diag.refuse::<()>(refusal.range, refusal.fact);
                skip_item(&content);
            }
        }
    }
    if !input.is_empty() {
        let range = input.span();
        diag.refuse::<()>(range, Fact::TokensAfter { what: "the mechanism" });
    }
    Some(mechanism)
}

pub(super) fn report<T>(parsed: Parsed<T>, diag: &mut Diag) -> Option<T> {
    match parsed {
        Ok(value) => Some(value),
        Err(refusal) => diag.refuse(refusal.range, refusal.fact),
    }
}

fn item(input: ParseStream) -> Parsed<Item> {
    let docs = docs(input)?;
    if input.peek(Token![use]) {
        return uses(input).map(Item::Use);
    }
    if input.peek(Token![let]) {
        return binding(input).map(Item::Let);
    }
    if !input.peek(Ident::peek_any) {
        return expected(input, "an item: `param`, `let`, `ground`, `body`, `joint`, `drive`, `output`, `function` or `use`");
    }
    let keyword: Ident = input.fork().call(Ident::parse_any)?;
    let skip = || input.call(Ident::parse_any);
    match keyword.to_string().as_str() {
        "param" => {
            skip()?;
            let name = name(input, "the name of the parameter")?;
            let dimension = required_dimension(input)?;
            if !input.peek(Token![=]) {
                return expected(input, "`=` and the default of the parameter");
            }
            equals(input)?;
            let default = expression(input)?;
            semicolon(input)?;
            Ok(Item::Parameter(Parameter { docs, name, dimension, default }))
        }
        "function" => function(input).map(Item::Function),
        "ground" => {
            let name = skip()?;
            frame(input, docs, name).map(Item::Ground)
        }
        "body" => {
            skip()?;
            let name = name(input, "the name of the body")?;
            frame(input, docs, name).map(Item::Body)
        }
        "joint" | "drive" => {
            skip()?;
            let what = if keyword == "drive" { "the name of the drive" } else { "the name of the joint" };
            let name = name(input, what)?;
            equals(input)?;
            let body = joint_body(input)?;
            Ok(Item::Joint(Joint { docs, is_drive: keyword == "drive", name, body }))
        }
        "output" => {
            skip()?;
            let name = name(input, "the name of the output")?;
            equals(input)?;
            let value = expression(input)?;
            semicolon(input)?;
            Ok(Item::Output(Output { docs, name, value }))
        }
        other => wrong(&keyword, Fact::UnknownItem { word: other.to_owned() }),
    }
}

/// `use a::b::{c, d as e};`
fn uses(input: ParseStream) -> Parsed<Vec<Use>> {
    input.parse::<Token![use]>()?;
    let prefix = path(input)?;
    let mut uses = Vec::new();
    if input.peek(Token![::]) {
        input.parse::<Token![::]>()?;
        if !input.peek(token::Brace) {
            return expected(input, "a name or `{ … }`");
        }
        let (content, _) = braces(input)?;
        while !content.is_empty() {
            let mut inner = path(&content)?;
            let before = &prefix.tokens;
            let after = &inner.tokens;
            inner.tokens = quote::quote!(#before::#after);
            uses.push(renamed(&content, inner)?);
            if !content.is_empty() {
                if !content.peek(Token![,]) {
                    return expected(&content, "`,`");
                }
                content.parse::<Token![,]>()?;
            }
        }
    } else {
        uses.push(renamed(input, prefix)?);
    }
    semicolon(input)?;
    Ok(uses)
}

fn renamed(input: ParseStream, path: super::ast::Path) -> Parsed<Use> {
    let mut alias = path.last.clone();
    if input.peek(Token![as]) {
        input.parse::<Token![as]>()?;
        alias = name(input, "a name after `as`")?;
    }
    Ok(Use { path, name: alias })
}

/// `let name: Dimension = value;`
pub(super) fn binding(input: ParseStream) -> Parsed<Let> {
    input.parse::<Token![let]>()?;
    let name = name(input, "a name after `let`")?;
    let dimension = if input.peek(Token![:]) { Some(required_dimension(input)?) } else { None };
    equals(input)?;
    let value = expression(input)?;
    semicolon(input)?;
    Ok(Let { name, dimension, value })
}

/// A function alone, after its doc comment.
pub(super) fn single_function(input: ParseStream, diag: &mut Diag) -> Option<Function> {
    let read = || -> Parsed<Function> {
        docs(input)?;
        function(input)
    };
    report(read(), diag)
}

/// `function name(argument: Dimension) -> Dimension = value;`
fn function(input: ParseStream) -> Parsed<Function> {
    Ident::parse_any(input)?;
    let name = name(input, "the name of the function")?;
    if !input.peek(token::Paren) {
        return expected(input, "`(argument: Dimension)`");
    }
    let (content, range) = parentheses(input)?;
    let argument = if content.peek2(Token![:]) { Some(self::name(&content, "the name of the argument")?) } else { None };
    if argument.is_some() {
        content.parse::<Token![:]>()?;
    }
    let from = dimension(&content)?;
    if !content.is_empty() {
        return wrong(range, Fact::OneArgument);
    }
    if !input.peek(Token![->]) {
        return expected(input, "`->` and the dimension of the value");
    }
    input.parse::<Token![->]>()?;
    let to = dimension(input)?;
    equals(input)?;
    let value = expression(input)?;
    semicolon(input)?;
    Ok(Function { name, argument, from, to, value })
}

fn required_dimension(input: ParseStream) -> Parsed<Dimension> {
    if !input.peek(Token![:]) {
        return expected(input, "`:` and a dimension such as `Length`");
    }
    input.parse::<Token![:]>()?;
    dimension(input)
}

/// `Length * Angle / Time^2`
pub(super) fn dimension(input: ParseStream) -> Parsed<Dimension> {
    let mut factors = Vec::new();
    let mut sign = 1;
    let mut range = Range::from(input.span());
    loop {
        let factor = name(input, "a dimension such as `Length`")?;
        range = range.to(&factor);
        let mut exponent = 1;
        if input.peek(Token![^]) {
            input.parse::<Token![^]>()?;
            if !input.peek(LitInt) {
                return expected(input, "a whole number");
            }
            let literal: LitInt = input.parse()?;
            range = range.to(literal.span());
            exponent = match literal.base10_parse::<u8>() {
                Ok(exponent) if exponent <= 6 => i16::from(exponent),
                _ => return wrong(literal.span(), Fact::ExponentTooLarge { limit: 6 }),
            };
        }
        factors.push((factor, sign * exponent));
        if input.peek(Token![*]) {
            input.parse::<Token![*]>()?;
            sign = 1;
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            sign = -1;
        } else {
            return Ok(Dimension { factors, range });
        }
    }
}

fn frame(input: ParseStream, docs: super::ast::Docs, name: Ident) -> Parsed<Frame> {
    let content = block(input, "`{` and the points of the body")?;
    let mut frame = Frame { docs, name, marks: Vec::new(), starts: Vec::new() };
    while !content.is_empty() {
        // Points may have doc comments; no item is generated that could carry them.
        self::docs(&content)?;
        if !content.peek(Ident::peek_any) {
            return expected(&content, "`point`, `axis` or `start`");
        }
        let keyword: Ident = content.fork().call(Ident::parse_any)?;
        match keyword.to_string().as_str() {
            word @ ("point" | "axis") => {
                content.call(Ident::parse_any)?;
                let is_axis = word == "axis";
                let name = self::name(&content, if is_axis { "the name of the axis" } else { "the name of the point" })?;
                equals(&content)?;
                let value = expression(&content)?;
                semicolon(&content)?;
                frame.marks.push(Mark { is_axis, name, value });
            }
            "start" => {
                content.call(Ident::parse_any)?;
                let what = self::name(&content, "`x`, `y`, `angle` or `position`")?;
                equals(&content)?;
                let value = expression(&content)?;
                semicolon(&content)?;
                frame.starts.push(Start { what, value });
            }
            other => return wrong(&keyword, Fact::UnknownBodyItem { word: other.to_owned() }),
        }
    }
    Ok(frame)
}

fn joint_body(input: ParseStream) -> Parsed<JointBody> {
    if input.peek(token::Brace) {
        let (content, _) = braces(input)?;
        let mut statements = Vec::new();
        while !content.is_empty() {
            statements.push(statement(&content)?);
        }
        if input.peek(Token![;]) {
            input.parse::<Token![;]>()?;
        }
        return Ok(JointBody::Equations(statements));
    }
    let kind = name(input, "a constraint such as `revolute(…)`, or `{ lhs == rhs; }`")?;
    if !input.peek(token::Paren) {
        return expected(input, "`(` and the arguments");
    }
    let (content, range) = parentheses(input)?;
    let mut arguments = Vec::new();
    while !content.is_empty() {
        arguments.push(argument(&content)?);
        if content.is_empty() {
            break;
        }
        if !content.peek(Token![,]) {
            return expected(&content, "`,` or `)`");
        }
        content.parse::<Token![,]>()?;
    }
    semicolon(input)?;
    Ok(JointBody::Of { kind, arguments, range })
}

fn argument(input: ParseStream) -> Parsed<Argument> {
    let named = input.peek(syn::Ident) && input.peek2(Token![:]) && !input.peek2(Token![::]);
    let name = if named { Some(self::name(input, "the name of the argument")?) } else { None };
    if named {
        input.parse::<Token![:]>()?;
    }
    let value: Expr = expression(input)?;
    Ok(Argument { name, value })
}
