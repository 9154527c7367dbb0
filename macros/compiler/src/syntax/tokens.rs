//! Small things every parser here needs: delimiters, paths, doc comments, and refusals in words.

use super::ast::{Docs, Path};
use crate::diag::{Fact, Range, Refusal};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Lit, Token, token};

/// What a parser gives: a value, or what is wrong and where.
pub(super) type Parsed<T> = Result<T, Refusal>;

/// A refusal as the result of a parser.
pub(super) fn wrong<T>(range: impl Into<Range>, fact: Fact) -> Parsed<T> {
    Err(Refusal { fact, range: range.into() })
}

/// The refusal that something else was expected here.
pub(super) fn expected<T>(input: ParseStream, what: &'static str) -> Parsed<T> {
    wrong(input.span(), Fact::Expected { what, found: next(input) })
}

/// The next token in backticks, or the end.
fn next(input: ParseStream) -> String {
    match input.cursor().token_tree() {
        None => "the end".to_owned(),
        Some((TokenTree::Group(group), _)) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_owned(),
            Delimiter::Brace => "`{`".to_owned(),
            Delimiter::Bracket => "`[`".to_owned(),
            Delimiter::None => "an expression of a macro".to_owned(),
        },
        Some((tree, _)) => format!("`{tree}`"),
    }
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

/// The body of an item in braces, or the refusal that it is missing.
pub(super) fn block<'a>(input: &ParseBuffer<'a>, what: &'static str) -> Parsed<ParseBuffer<'a>> {
    if !input.peek(token::Brace) {
        return expected(input, what);
    }
    Ok(braces(input)?.0)
}

/// A name; a Rust keyword is refused, since the name is also that of a Rust item.
pub(super) fn name(input: ParseStream, what: &'static str) -> Parsed<Ident> {
    if input.peek(syn::Ident) {
        return Ok(input.parse()?);
    }
    if input.peek(Ident::peek_any) && !input.peek(Token![_]) {
        let keyword = Ident::parse_any(input)?;
        return wrong(&keyword, Fact::Keyword { word: keyword.to_string() });
    }
    expected(input, what)
}

/// `;` at the end of an item.
pub(super) fn semicolon(input: ParseStream) -> Parsed<()> {
    if !input.peek(Token![;]) {
        return expected(input, "`;`");
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

/// A path begins here.
pub(super) fn is_path(input: ParseStream) -> bool {
    input.peek(syn::Ident) || input.peek(Token![::]) || input.peek(Token![crate]) || input.peek(Token![self]) || input.peek(Token![super])
}

/// `a::b::c`
pub(super) fn path(input: ParseStream) -> Parsed<Path> {
    let mut tokens = TokenStream::new();
    let mut range = Range::from(input.span());
    let rooted = input.peek(Token![::]);
    if rooted {
        input.parse::<Token![::]>()?.to_tokens(&mut tokens);
    }
    let mut segments = 0;
    loop {
        if !input.peek(Ident::peek_any) {
            return expected(input, "a name");
        }
        let last = Ident::parse_any(input)?;
        last.to_tokens(&mut tokens);
        segments += 1;
        range = range.to(&last);
        if !input.peek(Token![::]) || input.peek3(token::Brace) || input.peek3(Token![*]) {
            let name = (segments == 1 && !rooted).then(|| last.clone());
            return Ok(Path { tokens, last, name, range });
        }
        input.parse::<Token![::]>()?.to_tokens(&mut tokens);
    }
}

/// `pub`, `pub(crate)` and the like, or nothing.
pub(super) fn visibility(input: ParseStream) -> syn::Result<TokenStream> {
    let mut tokens = TokenStream::new();
    if input.peek(Token![pub]) {
        input.parse::<Token![pub]>()?.to_tokens(&mut tokens);
        if input.peek(token::Paren) {
            input.parse::<Group>()?.to_tokens(&mut tokens);
        }
    }
    Ok(tokens)
}

/// Doc comments, and the names of all other attributes.
pub(super) fn attributes(input: ParseStream) -> Parsed<(Docs, Vec<Ident>)> {
    let mut docs = Docs::default();
    let mut others = Vec::new();
    while input.peek(Token![#]) {
        let pound = input.parse::<Token![#]>()?;
        if !input.peek(token::Bracket) {
            return expected(input, "`[`");
        }
        let group: Group = input.parse()?;
        let attribute = group.stream();
        let read = |content: ParseStream| -> syn::Result<(Ident, Option<String>)> {
            let name = Ident::parse_any(content)?;
            let text = if content.peek(Token![=]) {
                content.parse::<Token![=]>()?;
                if let Ok(Lit::Str(text)) = content.fork().parse::<Lit>() { Some(text.value()) } else { None }
            } else {
                None
            };
            content.parse::<TokenStream>()?;
            Ok((name, text))
        };
        let (name, text) = syn::parse::Parser::parse2(read, attribute)?;
        if name == "doc" {
            pound.to_tokens(&mut docs.tokens);
            group.to_tokens(&mut docs.tokens);
            docs.text.extend(text);
        } else {
            others.push(name);
        }
    }
    Ok((docs, others))
}

/// Only doc comments may stand before most items.
pub(super) fn docs(input: ParseStream) -> Parsed<Docs> {
    let (docs, others) = attributes(input)?;
    match others.first() {
        Some(other) => wrong(other, Fact::UnknownAttribute { name: other.to_string() }),
        None => Ok(docs),
    }
}

/// Skips what is left of a broken item: up to and with the next `;` or `{ … }`.
pub(super) fn skip_item(input: ParseStream) {
    while !input.is_empty() {
        match input.parse::<TokenTree>() {
            Ok(TokenTree::Punct(punct)) if punct.as_char() == ';' => return,
            Ok(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
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
