//! Helpers of all parsers: delimiters, paths, doc comments, and errors.

use super::ast::{Docs, Path};
use crate::diag::{Diag, Fact, GrammarFact, Range, Refusal, ValueFact};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Lit, LitStr, Token, token};

/// Result of a parser: a value, or an error.
pub(super) type Parsed<T> = Result<T, Box<Refusal>>;

/// An error as the result of a parser.
pub(super) fn wrong<T>(range: impl Into<Range>, fact: impl Into<Fact>) -> Parsed<T> {
    Err(Box::new(Refusal { fact: fact.into(), range: range.into() }))
}

/// The error that something else was expected here.
pub(super) fn expected<T>(input: ParseStream, what: &'static str) -> Parsed<T> {
    wrong(input.span(), GrammarFact::Expected { what, found: next(input) })
}

/// Text up to the next semicolon, for messages.
pub(super) fn statement_text(input: ParseStream) -> Parsed<String> {
    let mut tokens = TokenStream::new();
    while !input.is_empty() && !input.peek(Token![;]) {
        tokens.extend([input.parse::<TokenTree>()?]);
    }
    Ok(tokens.to_string().replace(' ', "").replace(',', ", "))
}

/// Text of the next token for messages: in backticks, or `the end`.
pub(super) fn next(input: ParseStream) -> String {
    match input.cursor().token_tree() {
        None => "the end".to_owned(),
        Some((TokenTree::Group(group), _)) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_owned(),
            Delimiter::Brace => "`{`".to_owned(),
            Delimiter::Bracket => "`[`".to_owned(),
            Delimiter::None => "an expression of a macro".to_owned(),
        },
        // `==` is two tokens, but is not to be shown as `=`.
        Some(_) if input.peek(Token![==]) => "`==`".to_owned(),
        Some((tree, _)) => format!("`{tree}`"),
    }
}

/// Longest number in characters: the time to read a whole number grows with the square of its length.
const MOST_DIGITS: usize = 400;

/// True if a literal comes next. Reports a number that is too long.
pub(super) fn literal(input: ParseStream) -> Parsed<bool> {
    let Some((literal, _)) = input.cursor().literal() else { return Ok(false) };
    let text = literal.to_string();
    if text.len() > MOST_DIGITS && text.starts_with(|first: char| first.is_ascii_digit()) {
        return wrong(literal.span(), ValueFact::NumberTooLong { number: text, limit: MOST_DIGITS });
    }
    Ok(true)
}

/// The content of `( … )`.
pub(super) fn parentheses<'a>(input: &ParseBuffer<'a>) -> syn::Result<(ParseBuffer<'a>, Range)> {
    let content;
    let token = syn::parenthesized!(content in input);
    Ok((content, Range { first: token.span.open(), last: token.span.close() }))
}

/// The content of `{ … }`.
pub(super) fn braces<'a>(input: &ParseBuffer<'a>) -> syn::Result<(ParseBuffer<'a>, Range)> {
    let content;
    let token = syn::braced!(content in input);
    Ok((content, Range { first: token.span.open(), last: token.span.close() }))
}

/// The content of `[ … ]`.
pub(super) fn brackets<'a>(input: &ParseBuffer<'a>) -> syn::Result<(ParseBuffer<'a>, Range)> {
    let content;
    let token = syn::bracketed!(content in input);
    Ok((content, Range { first: token.span.open(), last: token.span.close() }))
}

/// Parses the braces of an item, or reports that they are missing.
pub(super) fn block<'a>(input: &ParseBuffer<'a>, what: &'static str) -> Parsed<ParseBuffer<'a>> {
    if !input.peek(token::Brace) {
        return expected(input, what);
    }
    Ok(braces(input)?.0)
}

/// Parses a name. A Rust keyword is rejected, since the name is also that of a Rust item.
pub(super) fn name(input: ParseStream, what: &'static str) -> Parsed<Ident> {
    if input.peek(syn::Ident) {
        let name: Ident = input.parse()?;
        // A Rust keyword since 2024, unknown to syn.
        return if name == "gen" { wrong(&name, GrammarFact::Keyword { word: name.to_string() }) } else { Ok(name) };
    }
    if input.peek(Ident::peek_any) && !input.peek(Token![_]) {
        let keyword = Ident::parse_any(input)?;
        return wrong(&keyword, GrammarFact::Keyword { word: keyword.to_string() });
    }
    if let Ok(Lit::Str(text)) = input.fork().parse::<Lit>()
        && let Ok(name) = text.parse::<Ident>()
    {
        return wrong(text.span(), GrammarFact::Misspelt { flaw: "names have no quotation marks", instead: name.to_string() });
    }
    expected(input, what)
}

/// Reads the first word of an item without consuming it.
pub(super) fn keyword(input: ParseStream) -> Option<Ident> {
    // `_` would be read as a word too.
    if input.peek(Token![_]) { None } else { input.fork().call(Ident::parse_any).ok() }
}

/// Parses `,` between the items of a list, or the end of the list.
pub(super) fn comma(content: ParseStream, what: &'static str) -> Parsed<()> {
    if content.is_empty() {
        return Ok(());
    }
    no_comparison(content)?;
    if !content.peek(Token![,]) {
        return expected(content, what);
    }
    content.parse::<Token![,]>()?;
    Ok(())
}

/// Refuses a comparison, or a choice as in C, behind a value.
fn no_comparison(input: ParseStream) -> Parsed<()> {
    if input.peek(Token![<]) || input.peek(Token![>]) || input.peek(Token![<=]) || input.peek(Token![>=]) || input.peek(Token![?]) {
        return wrong(input.span(), GrammarFact::ComparisonOutside);
    }
    Ok(())
}

/// `;` at the end of an item.
pub(super) fn semicolon(input: ParseStream) -> Parsed<()> {
    if input.peek(Token![,]) {
        let after = input.cursor().punct().and_then(|(_, after)| after.literal()).and_then(|(_, after)| after.punct());
        let decimals = after.is_some_and(|(end, _)| end.as_char() == ';');
        return wrong(input.span(), if decimals { GrammarFact::DecimalComma } else { GrammarFact::CommaAtEnd });
    }
    no_comparison(input)?;
    if input.peek(Token![in]) {
        let ahead = input.fork();
        ahead.parse::<Token![in]>()?;
        if let Some(unit) = keyword(&ahead).filter(|word| crate::quantity::unit(&word.to_string()).is_some()) {
            return wrong(input.span(), GrammarFact::OutputInUnit { unit: unit.to_string() });
        }
        let bounds = statement_text(&ahead)?;
        if bounds.contains("..") || bounds.contains('[') {
            return wrong(input.span(), GrammarFact::BoundsElsewhere);
        }
    }
    match keyword(input) {
        Some(word) if word == "limit" || word == "limits" => {
            return wrong(&word, GrammarFact::UnknownItem { word: word.to_string(), name: None, home: None });
        }
        Some(word) if word == "rpy" || word == "euler" => {
            return wrong(&word, GrammarFact::UnknownBodyItem { word: word.to_string(), is_point: true });
        }
        _ => {}
    }
    if !input.peek(Token![;]) {
        let what = if input.cursor().punct().is_some() { "an operator or `;`" } else { "`;`" };
        return expected(input, what);
    }
    input.parse::<Token![;]>()?;
    Ok(())
}

/// `=` between a name and its value.
pub(super) fn equals(input: ParseStream) -> Parsed<()> {
    if !input.peek(Token![=]) || input.peek(Token![==]) {
        return expected(input, "`=`");
    }
    input.parse::<Token![=]>()?;
    Ok(())
}

/// True if a path begins here.
pub(super) fn is_path(input: ParseStream) -> bool {
    input.peek(syn::Ident) || input.peek(Token![::]) || input.peek(Token![crate]) || input.peek(Token![self]) || input.peek(Token![super])
}

/// `a::b::c`
pub(super) fn path(input: ParseStream) -> Parsed<Path> {
    let mut tokens = TokenStream::new();
    let mut range = Range::from(input.span());
    let is_rooted = input.peek(Token![::]);
    if is_rooted {
        input.parse::<Token![::]>()?.to_tokens(&mut tokens);
    }
    let mut segments = 0;
    loop {
        let last = segment(input, segments == 0 && !is_rooted)?;
        last.to_tokens(&mut tokens);
        segments += 1;
        range = range.to(&last);
        if !input.peek(Token![::]) || input.peek3(token::Brace) || input.peek3(Token![*]) {
            let name = (segments == 1 && !is_rooted).then(|| last.clone());
            return Ok(Path { tokens, last, name, range });
        }
        input.parse::<Token![::]>()?.to_tokens(&mut tokens);
    }
}

/// Parses a segment of a path; the first may be `crate`, `self` or `super`, and `super` may be repeated.
fn segment(input: ParseStream, is_first: bool) -> Parsed<Ident> {
    let leads = input.peek(Token![super]) || is_first && (input.peek(Token![crate]) || input.peek(Token![self]));
    if leads { Ok(Ident::parse_any(input)?) } else { name(input, "a name") }
}

/// `pub`, `pub(crate)` and the like, or nothing.
pub(super) fn visibility(input: ParseStream) -> Parsed<TokenStream> {
    let mut tokens = TokenStream::new();
    if !input.peek(Token![pub]) {
        return Ok(tokens);
    }
    input.parse::<Token![pub]>()?.to_tokens(&mut tokens);
    if input.peek(token::Paren) {
        let group: Group = input.parse()?;
        syn::parse::Parser::parse2(scope, group.stream())?;
        group.to_tokens(&mut tokens);
    }
    Ok(tokens)
}

/// Content of `pub(…)`.
fn scope(content: ParseStream) -> syn::Result<()> {
    if content.peek(Token![in]) {
        content.parse::<Token![in]>()?;
        return path(content).map(|_| ()).map_err(|refusal| refusal.to_error());
    }
    // The crate of a definition that is handed over is `$crate`.
    let is_handed = content.cursor().ident().is_some_and(|(word, _)| word == "$crate");
    if is_handed || content.peek(Token![crate]) || content.peek(Token![self]) || content.peek(Token![super]) {
        return content.call(Ident::parse_any).map(|_| ());
    }
    Err(content.error("expected `crate`, `self`, `super` or `in path`"))
}

/// An attribute that is not a doc comment: `#[name]` or `#[name(…)]`.
pub(super) struct Attribute {
    pub(super) name: Ident,
    /// Tokens after the name.
    pub(super) rest: TokenStream,
    /// As written.
    pub(super) tokens: TokenStream,
}

/// Parses doc comments and all other attributes.
pub(super) fn attributes(input: ParseStream) -> Parsed<(Docs, Vec<Attribute>)> {
    let mut docs = Docs::default();
    let mut others = Vec::new();
    while input.peek(Token![#]) {
        let pound = input.parse::<Token![#]>()?;
        if !input.peek(token::Bracket) {
            return wrong(pound.span, GrammarFact::HashComment);
        }
        let group: Group = input.parse()?;
        let (name, text, rest) = syn::parse::Parser::parse2(attribute, group.stream())?;
        if name == "doc" {
            pound.to_tokens(&mut docs.tokens);
            group.to_tokens(&mut docs.tokens);
            docs.text.extend(text);
        } else {
            others.push(Attribute { name, rest, tokens: quote!(#pound #group) });
        }
    }
    Ok((docs, others))
}

/// Parses an attribute: its name, the text of a doc comment, and the tokens after any other name.
fn attribute(content: ParseStream) -> syn::Result<(Ident, Option<String>, TokenStream)> {
    let name = Ident::parse_any(content)?;
    if name != "doc" {
        return content.parse().map(|rest| (name, None, rest));
    }
    let nothing = TokenStream::new();
    if content.peek(token::Paren) {
        return content.parse::<Group>().map(|_| (name, None, nothing));
    }
    content.parse::<Token![=]>()?;
    if content.peek(LitStr) {
        return content.parse::<LitStr>().map(|text| (name, Some(text.value()), nothing));
    }
    // `#[doc = include_str!("…")]`
    path(content).map_err(|refusal| refusal.to_error())?;
    content.parse::<Token![!]>()?;
    content.parse::<Group>().map(|_| (name, None, nothing))
}

/// Parses doc comments, the only attributes allowed before most items.
pub(super) fn docs(input: ParseStream) -> Parsed<Docs> {
    let (docs, others) = attributes(input)?;
    match others.first() {
        Some(Attribute { name, .. }) => wrong(name, GrammarFact::UnknownAttribute { name: name.to_string() }),
        None => Ok(docs),
    }
}

/// Reports the error of a parser, if there is one.
pub(super) fn report<T>(parsed: Parsed<T>, diag: &mut Diag) -> Option<T> {
    match parsed {
        Ok(value) => Some(value),
        Err(refusal) => diag.refuse(refusal.range, refusal.fact),
    }
}

/// True if an item of a mechanism begins here: a keyword, and a name or a brace.
pub(super) fn is_item(input: ParseStream) -> bool {
    let Some(word) = keyword(input) else { return false };
    match word.to_string().as_str() {
        "ground" => input.peek2(token::Brace),
        "use" => true,
        "gravity" => input.peek2(Token![=]),
        "force" | "energy" | "freedom" | "param" | "input" | "let" | "function" | "body" | "joint" | "redundant" | "drive" | "output"
        | "slice" | "start" | "range" | "component" | "part" | "for" => input.peek2(syn::Ident),
        _ => false,
    }
}

/// Skips the rest of a broken item that began at `start`: through the next `;` or `{ … }`, or up to the next item.
pub(super) fn skip_item(input: ParseStream, start: ParseStream, is_item: fn(ParseStream) -> bool) {
    let mut has_moved = input.cursor() != start.cursor();
    while !(input.is_empty() || has_moved && is_item(input)) {
        has_moved = true;
        match input.parse::<TokenTree>() {
            Ok(TokenTree::Punct(punct)) if punct.as_char() == ';' => return,
            Ok(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                if input.peek(Token![else]) {
                    continue;
                }
                if input.peek(Token![;]) {
                    let _ = input.parse::<Token![;]>();
                }
                return;
            }
            Ok(_) => {}
            Err(_) => return,
        }
    }
}

/// Skips the rest of a broken item of a body: through the next `;`, or to the end.
pub(super) fn skip_statement(input: ParseStream) {
    while let Ok(token) = input.parse::<TokenTree>() {
        if matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';') {
            return;
        }
    }
}

/// True if a mass is given: `mass` before `=`, `:`, a number or `at`, and not as the name of an item.
pub(super) fn mentions_masses(tokens: TokenStream) -> bool {
    let mut open = vec![tokens];
    while let Some(tokens) = open.pop() {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        open.extend(tokens.iter().filter_map(|token| if let TokenTree::Group(group) = token { Some(group.stream()) } else { None }));
        let is_given = |at: usize| {
            let is_named = at > 0 && matches!(&tokens[at - 1], TokenTree::Ident(word) if word != "add");
            let has_value = match tokens.get(at + 1) {
                Some(TokenTree::Punct(sign)) => ['=', ':'].contains(&sign.as_char()),
                Some(TokenTree::Ident(word)) => word == "at",
                Some(TokenTree::Literal(_)) => true,
                _ => false,
            };
            has_value && !is_named
        };
        let mut masses = tokens.iter().enumerate().filter(|(_, token)| matches!(token, TokenTree::Ident(word) if word == "mass"));
        if masses.any(|(at, _)| is_given(at)) {
            return true;
        }
    }
    false
}

/// Skips to the first `{`, or to the `in` before it, and returns the name before that.
pub(super) fn name_before_block(input: ParseStream) -> Option<Ident> {
    let mut name = None;
    while !input.is_empty() && !input.peek(token::Brace) {
        if input.peek(Token![in]) && name.is_some() {
            return name;
        }
        name = if input.peek(syn::Ident) { input.parse().ok() } else { input.parse::<TokenTree>().ok().and(None) };
    }
    name
}

/// Skips to the first `{`.
pub(super) fn skip_to_block(input: ParseStream) -> Option<()> {
    while !input.peek(token::Brace) {
        input.parse::<TokenTree>().ok()?;
    }
    Some(())
}
