//! Spellings of other languages in expressions, refused with the line to type.

use super::ast::{Expression, ExpressionKind, Operator, Path};
use super::expression::{deeper, expression, is_end, is_unit, list, relation, sum};
use super::tokens::{Parsed, braces, keyword, parentheses, wrong};
use crate::diag::{GrammarFact, Range};
use crate::quantity;
use crate::words::{foreign, is_synonym};
use proc_macro2::{Delimiter, Group, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, Lit, LitInt, Token, token};

/// True for a whole number, and for a name that loops often have.
fn is_index(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Number { digits, unit } => unit.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()),
        ExpressionKind::Path(path) => ["i", "j", "k", "m", "n"].iter().any(|variable| path.last == variable),
        _ => false,
    }
}

/// Refuses `front-wheel` as a declared name, of a type for instance.
pub(super) fn one_word(input: ParseStream, name: &Ident, is_type: bool) -> Parsed<()> {
    let (ahead, mut words, mut range) = (input.fork(), vec![name.to_string()], Range::from(name));
    while ahead.parse::<Token![-]>().is_ok()
        && let Ok(word) = Ident::parse_any(&ahead)
    {
        range = range.to(&word);
        words.push(word.to_string());
    }
    if words.len() == 1 {
        return Ok(());
    }
    let initial = |word: &String| word.chars().take(1).flat_map(char::to_uppercase).chain(word.chars().skip(1)).collect::<String>();
    let instead = if is_type { words.iter().map(initial).collect() } else { words.join("_") };
    wrong(range, GrammarFact::Misspelt { flaw: "a name is one word", instead })
}

/// Refuses `link{i}` and `link(i)` as a declared name.
pub(super) fn no_index_otherwise(input: ParseStream, name: &Ident) -> Parsed<()> {
    let ahead = input.fork();
    let Ok((content, range)) = (if input.peek(token::Brace) { braces(&ahead) } else { parentheses(&ahead) }) else { return Ok(()) };
    let index = expression(&content).ok().filter(|index| content.is_empty() && is_index(index));
    let goes_on = ahead.peek(token::Brace) || ahead.peek(Token![=]) || ahead.peek(Token![:]);
    match index.filter(|_| goes_on) {
        Some(index) => {
            // What follows is no other item.
            input.parse::<Group>()?;
            let instead = format!("{name}[{index}]");
            wrong(Range::from(name).to(range), GrammarFact::Misspelt { flaw: "an index stands in brackets", instead })
        }
        None => Ok(()),
    }
}

/// Refuses `d / dt(x)`.
pub(super) fn no_derivative(above: &Expression, below: &Expression) -> Parsed<()> {
    match &below.kind {
        ExpressionKind::Call(function, arguments) if function.last == "dt" => {
            let is_letter = |value: &Expression| value.name().is_some_and(|name| name == "d");
            let factor = match &above.kind {
                ExpressionKind::Binary(Operator::Mul, factor, letter) if is_letter(letter) => format!("{factor} * "),
                _ if is_letter(above) => String::new(),
                _ => return Ok(()),
            };
            let arguments: Vec<String> = arguments.iter().map(ToString::to_string).collect();
            let instead = format!("{factor}rate({})", arguments.join(", "));
            wrong(above.range.to(below.range), GrammarFact::Misspelt { flaw: "the derivative by time has a name", instead })
        }
        _ => Ok(()),
    }
}

/// Refuses `speed t` and `speed * t deg` as an argument.
pub(super) fn no_word_behind(input: ParseStream, value: &Expression) -> Parsed<()> {
    let ahead = input.fork();
    let Some(word) = ahead.parse::<Ident>().ok().filter(|word| !goes_on(word) && (ahead.is_empty() || ahead.peek(Token![,]))) else {
        return Ok(());
    };
    let is_name = matches!(value.kind, ExpressionKind::Path(_));
    let (flaw, instead) = match quantity::unit(&word.to_string()).filter(|_| word != "t" && !is_name) {
        Some(_) => ("a unit stands right after a number, and other quantities carry theirs", value.to_string()),
        None => ("an operator is missing; a unit stands right after a number", format!("{value} * {word}")),
    };
    wrong(value.range.to(&word), GrammarFact::Misspelt { flaw, instead })
}

/// Refuses `plate.B(i)`.
pub(super) fn no_index_in_parentheses(input: ParseStream, owner: &Expression, name: &Ident, room: u16) -> Parsed<()> {
    let ahead = input.fork();
    let (content, range) = parentheses(&ahead)?;
    let Ok(index) = sum(&content, room) else { return Ok(()) };
    let is_mark = matches!(owner.kind, ExpressionKind::Path(_)) && foreign(&name.to_string()).is_none();
    if !content.is_empty() || !is_index(&index) || !is_mark {
        return Ok(());
    }
    let instead = format!("{owner}.{name}[{index}]");
    wrong(owner.range.to(range), GrammarFact::Misspelt { flaw: "an index stands in brackets, and nothing has methods here", instead })
}

/// Refuses `10^3g`.
pub(super) fn no_unit_raised(input: ParseStream, base: &Expression) -> Parsed<()> {
    let ahead = input.fork();
    let minus = if ahead.parse::<Option<Token![-]>>()?.is_some() { "-" } else { "" };
    match ahead.parse::<Option<LitInt>>()? {
        Some(exponent) if !exponent.suffix().is_empty() => {
            let flaw = "a unit belongs to the number before it, here to the exponent";
            let instead = format!("1e{minus}{}{}", exponent.base10_digits(), exponent.suffix());
            wrong(base.range.to(exponent.span()), GrammarFact::Misspelt { flaw, instead })
        }
        _ => Ok(()),
    }
}

/// Refuses `600 RPM`, `0.03 kg m^2` and `5 N*s/m`: a unit behind a space, in words or in parts.
pub(super) fn no_unit_apart(input: ParseStream, number: Range, digits: &str) -> Parsed<()> {
    let is_word = |input: ParseStream| keyword(input).is_some_and(|word| !goes_on(&word));
    if !is_word(input) {
        return Ok(());
    }
    let ahead = input.fork();
    // The longest unit, whether it is as it was written, and whether it may be a factor of what follows.
    let (mut unit, mut best) = (String::new(), None);
    loop {
        let word: Ident = Ident::parse_any(&ahead)?;
        unit.push_str(&unit_of_word(&word.to_string()));
        let mut range = number.to(&word);
        if ahead.peek(Token![^]) {
            ahead.parse::<Token![^]>()?;
            let Ok(exponent) = ahead.parse::<LitInt>() else { return Ok(()) };
            unit.push_str(exponent.base10_digits());
            range = number.to(exponent.span());
        }
        let is_unit = quantity::unit(&unit).is_some();
        if is_unit {
            best = Some((unit.clone(), range, word == unit, ahead.peek(Token![*]) || is_divided(&ahead)));
        }
        let is_quotient = ahead.peek(Token![/]);
        if !is_unit && is_quotient && unit.contains('_') {
            break;
        }
        if is_quotient {
            ahead.parse::<Token![/]>()?;
            unit.push('_');
        } else if ahead.peek(Token![*]) {
            ahead.parse::<Token![*]>()?;
        } else if !is_word(&ahead) {
            best = best.filter(|best: &(_, _, _, bool)| is_unit || best.3);
            break;
        }
        if !is_word(&ahead) {
            break;
        }
    }
    match best {
        Some((unit, range, false, is_factor)) if is_factor || is_end(&ahead) || ahead.peek(Token![-]) || ahead.peek(token::Brace) => {
            wrong(range, GrammarFact::Misspelt { flaw: "a unit is one word right behind its number", instead: format!("{digits}{unit}") })
        }
        _ => Ok(()),
    }
}

/// True before `/` and what is no unit.
fn is_divided(input: ParseStream) -> bool {
    let ahead = input.fork();
    ahead.parse::<Token![/]>().is_ok() && keyword(&ahead).is_none_or(|word| quantity::unit(&unit_of_word(&word.to_string())).is_none())
}

/// True for a word that may follow a value within an item.
pub(super) fn goes_on(word: &Ident) -> bool {
    ["at", "from", "along", "with", "in", "as", "if", "else"].iter().any(|known| word == known)
}

/// A unit as it is written here: `rpm` for `RPM`, `kg` for `kilograms`; not `mJ` for `MJ` or `Nm` for `nm`.
fn unit_of_word(word: &str) -> String {
    if quantity::unit(word).is_some() {
        return word.to_owned();
    }
    let is_alike = |unit: &str| {
        let [one, other] = [unit, word].map(|text| text.chars().next().unwrap_or_default());
        let is_prefix = ['m', 'n', 'g'].contains(&one.to_ascii_lowercase());
        word.len() > 1 && unit.eq_ignore_ascii_case(word) && (one == other || !is_prefix || word == "MM")
    };
    let is_meant = |unit: &&str| is_alike(unit) || is_synonym(unit, &word.to_lowercase());
    quantity::units().find(is_meant).unwrap_or(word).to_owned()
}

/// Refuses `20%`.
pub(super) fn no_percentage(input: ParseStream, value: &Expression, digits: &str) -> Parsed<()> {
    let ahead = input.fork();
    match ahead.parse::<Option<Token![%]>>()? {
        Some(sign) if is_end(&ahead) => {
            let instead = (digits.parse::<f64>().unwrap_or(0.0) / 100.0).to_string();
            wrong(value.range.to(sign.span), GrammarFact::Misspelt { flaw: "`%` is the rest of a division", instead })
        }
        _ => Ok(()),
    }
}

/// Refuses `100[mm]`.
pub(super) fn no_brackets(input: ParseStream, value: &Expression, digits: &str) -> Parsed<()> {
    let Some((inside, ..)) = input.cursor().group(Delimiter::Bracket) else { return Ok(()) };
    let unit = inside.token_stream().to_string();
    if quantity::unit(&unit).is_none() {
        return Ok(());
    }
    let instead = format!("{digits}{unit}");
    wrong(value.range, GrammarFact::Misspelt { flaw: "a unit stands right behind its number, without brackets", instead })
}

/// The variable of `|name| value`, a closure, or of `@(name) value` as in MATLAB, and the tokens of its value; none of a norm.
fn closure(input: ParseStream<'_>) -> Option<(String, ParseBuffer<'_>)> {
    let ahead = input.fork();
    let variable = if ahead.peek(Token![@]) {
        ahead.parse::<Token![@]>().ok()?;
        parentheses(&ahead).ok()?.0.to_string()
    } else {
        ahead.parse::<Token![|]>().ok()?;
        let name = ahead.parse::<Ident>().ok()?;
        ahead.parse::<Token![|]>().ok()?;
        name.to_string()
    };
    let begins = ahead.peek(Ident) || ahead.peek(token::Paren) || ahead.peek(Lit);
    begins.then_some((variable, ahead))
}

/// Refuses `|t| value`.
pub(super) fn no_closure(input: ParseStream, room: u16) -> Parsed<()> {
    let Some((variable, inside)) = closure(input) else { return Ok(()) };
    match sum(&inside, room) {
        Ok(value) => wrong(input.span(), law_as_closure(&variable, &value)),
        Err(_) => Ok(()),
    }
}

/// A closure in the place of a law: of `t` it is an expression, of another quantity a function.
pub(super) fn law_as_closure(variable: &str, value: &Expression) -> GrammarFact {
    let dimensions = match variable {
        "x" | "s" | "d" | "l" | "length" => "Length) -> Force",
        "angle" | "phi" | "theta" => "Angle) -> Torque",
        "v" => "Velocity) -> Force",
        _ => return GrammarFact::Misspelt { flaw: "a law is an expression of `t`, not a closure", instead: value.to_string() },
    };
    let flaw = "a law of another quantity than `t` is a function, and is given by its name";
    GrammarFact::Misspelt { flaw, instead: format!("function law({variable}: {dimensions} = {value};") }
}

/// Refuses `&ground.O` and `{100mm, 0mm}`.
pub(super) fn no_reference(input: ParseStream, room: u16) -> Parsed<()> {
    let ahead = input.fork();
    if ahead.parse::<Option<Token![&]>>()?.is_some() {
        return match sum(&ahead, room) {
            Ok(value) => wrong(input.span(), GrammarFact::Misspelt { flaw: "nothing is borrowed here", instead: value.to_string() }),
            Err(_) => Ok(()),
        };
    }
    if !ahead.peek(token::Brace) {
        return Ok(());
    }
    let (content, range) = braces(&ahead)?;
    match list(&content, room) {
        Ok(items) if items.len() > 1 => {
            let items: Vec<String> = items.iter().map(ToString::to_string).collect();
            let instead = format!("({})", items.join(", "));
            wrong(range, GrammarFact::Misspelt { flaw: "a vector has parentheses", instead })
        }
        _ => Ok(()),
    }
}

/// Refuses `(a > b) * c`.
pub(super) fn no_truth(input: ParseStream) -> Parsed<()> {
    let is_comparison = input.peek(Token![<]) || input.peek(Token![>]);
    if is_comparison { wrong(input.span(), GrammarFact::ComparisonAsValue) } else { Ok(()) }
}

/// Refuses `if (a < b) {`, as it is written in C.
pub(super) fn no_parentheses(input: ParseStream) -> Parsed<()> {
    let Some((inside, span, after)) = input.cursor().group(Delimiter::Parenthesis) else { return Ok(()) };
    let is_joined = after.punct().is_some_and(|(sign, _)| ['&', '|'].contains(&sign.as_char()));
    let is_condition = after.group(Delimiter::Brace).is_some() || is_joined;
    let compares = |token: TokenTree| matches!(token, TokenTree::Punct(sign) if ['<', '>', '&', '|', '='].contains(&sign.as_char()));
    let joins = |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if ['&', '|'].contains(&sign.as_char()));
    match is_condition && inside.token_stream().into_iter().any(compares) {
        false => Ok(()),
        true if is_joined || inside.token_stream().into_iter().any(|token| joins(&token)) => wrong(span.join(), GrammarFact::TwoConditions),
        true => wrong(span.join(), GrammarFact::ConditionInParentheses),
    }
}

/// The same as a constant of Rust, as it is written here.
pub(super) fn constant_of_rust(path: &Path) -> Option<&'static str> {
    let constants = [("PI", "pi"), ("TAU", "2 * pi"), ("E", "exp(1)")];
    constants.iter().find(|(name, _)| path.name.is_none() && path.last == name).map(|(_, instead)| *instead)
}

/// Refuses `std::f64::consts::PI`.
pub(super) fn no_constant(path: &Path) -> Parsed<()> {
    match constant_of_rust(path) {
        Some(instead) => {
            let written = path.tokens.to_string().replace(' ', "");
            wrong(path.range, GrammarFact::RustConstant { written, instead })
        }
        None => Ok(()),
    }
}

/// Refuses `value if a < b else other`, as it is written in Python.
pub(super) fn no_choice_behind(input: ParseStream, value: &Expression, room: u16) -> Parsed<()> {
    if !input.peek(Token![if]) {
        return Ok(());
    }
    let ahead = input.fork();
    let other = ahead.parse::<Token![if]>().is_ok().then(|| -> Parsed<String> {
        let room = deeper(room, value.range)?;
        let (lhs, relation, rhs) = (sum(&ahead, room)?, relation(&ahead)?, sum(&ahead, room)?);
        ahead.parse::<Token![else]>()?;
        Ok(format!("if {lhs} {relation} {rhs} {{ {value} }} else {{ {} }}", sum(&ahead, room)?))
    });
    let instead = other.and_then(Parsed::ok).unwrap_or_else(|| format!("if a < b {{ {value} }} else {{ … }}"));
    wrong(input.span(), GrammarFact::Misspelt { flaw: "a choice begins with its condition", instead })
}

/// Refuses `np.sin(x)` and `math.sin(x)`.
pub(super) fn without_module(input: ParseStream, owner: &Expression, function: &Ident, room: u16) -> Parsed<()> {
    const MODULES: [&str; 12] = ["np", "numpy", "math", "Math", "cmath", "ca", "cs", "casadi", "sp", "sympy", "jnp", "torch"];
    let ExpressionKind::Path(Path { name: Some(name), .. }) = &owner.kind else { return Ok(()) };
    if !MODULES.iter().any(|module| name == module) {
        return Ok(());
    }
    let ahead = input.fork();
    let (content, _) = parentheses(&ahead)?;
    let arguments: Vec<String> = list(&content, deeper(room, owner.range)?)?.iter().map(ToString::to_string).collect();
    let instead = format!("{function}({})", arguments.join(", "));
    wrong(owner.range.to(function), GrammarFact::Misspelt { flaw: "functions stand by themselves", instead })
}

/// Refuses `[0, 1]` after a name.
pub(super) fn each_index_by_itself(content: ParseStream, first: &Expression, room: u16) -> Parsed<()> {
    if !content.peek(Token![,]) {
        return Ok(());
    }
    let ahead = content.fork();
    let (mut instead, mut range) = (format!("[{first}]"), first.range);
    while ahead.parse::<Token![,]>().is_ok() {
        let next = sum(&ahead, room)?;
        instead += &format!("[{next}]");
        range = range.to(next.range);
    }
    wrong(range, GrammarFact::Misspelt { flaw: "each index has brackets of its own", instead })
}

/// Refuses `(200, 0)mm`.
pub(super) fn no_common_unit(input: ParseStream, items: &[Expression], range: Range) -> Parsed<()> {
    let Some(unit) = keyword(input).filter(|word| is_unit(input) && quantity::unit(&word.to_string()).is_some()) else { return Ok(()) };
    let is_measured = |item: &Expression| matches!(&item.kind, ExpressionKind::Number { unit, .. } if !unit.is_empty());
    if items.iter().any(is_measured) {
        return Ok(());
    }
    let measured = |item: &Expression| match &item.kind {
        ExpressionKind::Number { .. } => format!("{item}{unit}"),
        _ => format!("({item}) * 1{unit}"),
    };
    let items: Vec<String> = items.iter().map(measured).collect();
    let instead = format!("({})", items.join(", "));
    wrong(range.to(&unit), GrammarFact::Misspelt { flaw: "each number has a unit of its own", instead })
}

/// Refuses the name of a point in quotation marks.
pub(super) fn no_quotation(literal: &Lit) -> Parsed<()> {
    let Lit::Str(text) = literal else { return Ok(()) };
    let is_name = |text: &str| {
        let is_of_names = |letter: char| letter.is_alphanumeric() || ['_', '.', '[', ']'].contains(&letter);
        text.starts_with(char::is_alphabetic) && text.chars().all(is_of_names)
    };
    match text.value() {
        name if [".csv", ".txt", ".dat", ".tsv", ".json"].iter().any(|ending| name.ends_with(ending)) => {
            let flaw = "files are read by programs: a table has its points here, or is a function of Rust";
            wrong(literal.span(), GrammarFact::Misspelt { flaw, instead: "table(t, [(0s, …), (1s, …), (2s, …)])".to_owned() })
        }
        name if is_name(&name) => wrong(literal.span(), GrammarFact::Misspelt { flaw: "names have no quotation marks", instead: name }),
        _ => Ok(()),
    }
}

/// Refuses `self.length`.
pub(super) fn no_self(owner: &Expression, field: &Ident) -> Parsed<()> {
    match &owner.kind {
        ExpressionKind::Path(Path { last, .. }) if last == "self" => {
            let instead = field.to_string();
            wrong(owner.range.to(field), GrammarFact::Misspelt { flaw: "names stand by themselves", instead })
        }
        _ => Ok(()),
    }
}
