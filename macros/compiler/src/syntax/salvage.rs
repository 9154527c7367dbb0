//! Reads what a rejected item was meant to be, so that the stub of the mechanism has its fields and methods.

use super::arguments::arguments;
use super::ast::{Dimension, ParameterItem, PartItem, Shared};
use super::ast::{Docs, Expression, ExpressionKind, FrameItem, FreedomItem, Item, JointBody, JointItem, Marks, OutputItem};
use super::expression::{expression, indices};
use super::tokens::{attributes, is_item, name};
use crate::diag::Range;
use crate::quantity::Ambient;
use crate::words::{Home, home, nearest};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::format_ident;
use std::rc::Rc;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Token, token};

/// Keywords of items that have a name.
const KEYWORDS: [&str; 10] = ["param", "input", "body", "joint", "drive", "freedom", "force", "energy", "output", "part"];

/// Largest number of tokens of an expression that is read in spite of a mistake: every beginning of them is tried.
const LONGEST: usize = 100;

/// The item with its keyword, its name, its indices, and as much of the rest as can be read.
pub(super) fn salvaged(input: ParseStream, ambient: Ambient) -> Option<Item> {
    if attributes(input).is_err() {
        // After a comment of another language the next item begins.
        while !input.is_empty() && !is_item(input) {
            input.parse::<TokenTree>().ok()?;
        }
    }
    let mut word = Ident::parse_any(input).ok()?;
    let is_slice = word == "slice";
    if (is_slice || word == "redundant") && input.peek2(syn::Ident) {
        word = Ident::parse_any(input).ok()?;
    }
    let name = name(input, "a name").ok()?;
    let indices = indices(input).unwrap_or_default();
    let meant = meant(&word.to_string(), ambient, input)?;
    let docs = Docs::default();
    let zero =
        || Expression { kind: ExpressionKind::Number { digits: "0".into(), unit: String::new() }, range: Range::from(&name), depth: 1 };
    Some(match meant.as_str() {
        "param" | "input" => {
            let dimension = Dimension { factors: Vec::new(), range: Range::from(&name) };
            let item = Shared::new(ParameterItem { docs, default: zero(), name, indices, dimension, limits: None });
            if meant == "param" { Item::Parameter(item) } else { Item::Input(item) }
        }
        "body" => {
            let (marks, starts, masses) = (Marks::default(), Vec::new(), Vec::new());
            Item::Body(Shared::new(FrameItem { docs, name, indices, marks, starts, masses }))
        }
        "output" => {
            let (value, jerk) = value(input);
            let value = value.unwrap_or_else(zero);
            Item::Output(Shared::new(OutputItem { docs, is_slice, name, indices, value, jerk }))
        }
        "part" => match call(input)? {
            JointBody::Of { kind, arguments } => {
                Item::Part(Shared::new(PartItem { docs, name, indices, kind, arguments: Rc::new(arguments) }))
            }
            _ => return None,
        },
        word => {
            let body = match word {
                "freedom" => Some(JointBody::Freedom(Box::new(FreedomItem { value: zero(), from: None, at: None }))),
                "energy" => Some(JointBody::Energy(Box::new(zero()))),
                _ => call(input),
            };
            let body = body.unwrap_or_else(|| JointBody::Equations(Vec::new()));
            let joint = JointItem { docs, is_drive: word != "joint", is_redundant: false, is_slice, velocity: None, name, indices, body };
            if ["force", "energy"].contains(&word) { Item::Force(Shared::new(joint)) } else { Item::Joint(Shared::new(joint)) }
        }
    })
}

/// The keyword that was probably meant: a similar one, or that of an item which other programs call by this word.
fn meant(word: &str, ambient: Ambient, rest: ParseStream) -> Option<String> {
    // `parm` before a dimension is rather `param` than `part`.
    let fits = |keyword: &&str| *keyword == word || ["param", "input"].contains(keyword) == rest.peek(Token![:]);
    nearest(word, KEYWORDS.into_iter().filter(fits)).or_else(|| {
        let kind = match home(word, ambient)? {
            Home::Body if rest.peek(token::Brace) => "body",
            Home::Drive(_) => "drive",
            Home::Force(_) => "force",
            Home::Joint(_) | Home::Equation | Home::Body | Home::Nothing => "joint",
        };
        Some(kind.to_owned())
    })
}

/// `= kind(arguments)`, without arguments that cannot be read.
fn call(input: ParseStream) -> Option<JointBody> {
    input.parse::<Token![=]>().ok()?;
    let kind: Ident = input.parse().ok()?;
    if !input.peek(token::Paren) {
        return None;
    }
    Some(JointBody::Of { kind, arguments: arguments(&input.fork()).unwrap_or_default() })
}

/// The longest beginning of the value of an output that is an expression, and `jerk` if it is asked for.
fn value(input: ParseStream) -> (Option<Expression>, Option<Ident>) {
    let mut tokens = Vec::new();
    while !input.is_empty() && !input.peek(Token![;]) && tokens.len() < LONGEST {
        let Ok(token) = input.parse::<TokenTree>() else { break };
        tokens.push(token);
    }
    let is_sign = |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if sign.as_char() == '=');
    tokens.drain(..tokens.iter().position(is_sign).map_or(0, |sign| sign + 1));
    let words: Vec<String> = tokens.iter().map(ToString::to_string).collect();
    let jerk = words.ends_with(&["with".into(), "jerk".into()]).then(|| format_ident!("jerk"));
    let beginning = |count: usize| {
        let read = |input: ParseStream| expression(input).map_err(|refusal| refusal.to_error());
        read.parse2(tokens[..count].iter().cloned().collect::<TokenStream>()).ok()
    };
    ((1..=tokens.len()).rev().find_map(beginning), jerk)
}
