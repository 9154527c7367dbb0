//! Mutations of a declaration.

use crate::corpus;
use crate::random::Random;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::fmt;
use std::str::FromStr;

/// A token of a flattened stream.
#[derive(Clone, Debug)]
pub(crate) enum Flat {
    Open(Delimiter),
    Close,
    Tree(TokenTree),
}

impl fmt::Display for Flat {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Flat::Tree(tree) => tree.fmt(f),
            Flat::Open(_) | Flat::Close => f.write_str("|"),
        }
    }
}

/// Tokens with a meaning to the compiler, and some without.
const WORDS: &str = "param let ground body joint drive output function use constraint bundle require mechanism equations_only picture \
    point axis start x y angle position t pi sin cos tan asin acos atan atan2 sqrt exp ln abs min max dot cross perp norm unit \
    direction table if else periodic linear hold Length Angle Time Number Quantity Point Axis Body Function Joint pub as crate self \
    super fn type r#type _ T Self phi solve state default doc crank rocker coupler A B O P Q u v a b c f g speed \
    + - * / ^ . , ; : :: = == != < <= > >= -> => # ! ? & | @ $ ~ ' % .. ... 'a \
    0 1 2 -1 0.5 1e308 1e-308 1e36 1e-36 1e400 5e-324 99999999999999999999999999999999999999999999 0.000000000000000000000000000000001 \
    0xff 0b1 1_000 1e5mm 30deg 0mm 0deg 60rpm 2.5kg 1Hz 1parsec 1u8 1f64 1000000 1000 200 \"text\" 'c' b'c' b\"bytes\" c\"c\" true";

/// Applies up to six changes; half of the cases get gentle ones, so that some of them stay valid.
pub(crate) fn mutilated(tokens: TokenStream, random: &mut Random) -> TokenStream {
    let mut flat = flat(tokens);
    let change = if random.below(2) == 0 { gentle } else { change };
    for _ in 0..random.below(6) + usize::from(random.below(8) > 0) {
        change(&mut flat, random);
    }
    nested(&mut flat.into_iter())
}

/// A change that preserves the grammar.
fn gentle(flat: &mut Vec<Flat>, random: &mut Random) {
    const ALIKE: &[&str] = &[
        "+ - * / ^",
        "sin cos tan asin acos atan sqrt exp ln abs",
        "x y angle",
        "crank coupler rocker cam follower sun planet",
        "0 1 2 0mm 0deg 5mm -",
    ];
    match random.below(6) {
        0 => numbers(flat, random),
        1 => append(flat, random),
        2 => swap_alike(flat, random),
        _ => {
            let alike: Vec<&str> = random.of::<&str>(ALIKE).split_whitespace().collect();
            let at: Vec<usize> = (0..flat.len()).filter(|at| alike.contains(&flat[*at].to_string().as_str())).collect();
            if let (false, Some(tree)) =
                (at.is_empty(), TokenStream::from_str(random.of::<&str>(&alike)).unwrap_or_default().into_iter().next())
            {
                flat[*random.of(&at)] = Flat::Tree(tree);
            }
        }
    }
}

/// Swaps two literals or two names.
fn swap_alike(flat: &mut [Flat], random: &mut Random) {
    let is_literal = random.below(2) == 0;
    let is_alike = |token: &Flat| match token {
        Flat::Tree(TokenTree::Literal(_)) => is_literal,
        Flat::Tree(TokenTree::Ident(_)) => !is_literal,
        _ => false,
    };
    let at: Vec<usize> = (0..flat.len()).filter(|at| is_alike(&flat[*at])).collect();
    if !at.is_empty() {
        flat.swap(*random.of(&at), *random.of(&at));
    }
}

/// Adds items before the closing brace of the mechanism.
fn append(flat: &mut Vec<Flat>, random: &mut Random) {
    let items = crate::mutate::flat(corpus::item(random));
    let last = flat.len().saturating_sub(1);
    flat.splice(last..last, items);
}

fn change(flat: &mut Vec<Flat>, random: &mut Random) {
    let at = random.below(flat.len());
    let end = (at + 1 + random.below(12)).min(flat.len());
    match random.below(12) {
        0 if end > at => flat.truncate_range(at, end),
        1 if end > at => flat.truncate_range(at, at + 1),
        2 if end > at => flat.insert_at(random, |flat, _| flat[at..end].to_vec()),
        3 => flat.insert_at(random, |_, random| vec![word(random)]),
        4 if end > at => flat[at] = word(random),
        5 if end > at => {
            let other = random.below(flat.len());
            flat.swap(at, other);
        }
        6 => numbers(flat, random),
        7 => names(flat, random),
        8 => deep(flat, at, end, random),
        9 => flat.insert_at(random, |_, random| (0..random.below(20)).map(|_| word(random)).collect()),
        10 => flat.insert_at(random, |_, random| crate::mutate::flat(corpus::pick(random).1)),
        _ => append(flat, random),
    }
}

trait Splice {
    fn truncate_range(&mut self, from: usize, to: usize);
    fn insert_at(&mut self, random: &mut Random, what: impl FnOnce(&[Flat], &mut Random) -> Vec<Flat>);
}

impl Splice for Vec<Flat> {
    fn truncate_range(&mut self, from: usize, to: usize) {
        self.drain(from..to);
    }

    fn insert_at(&mut self, random: &mut Random, what: impl FnOnce(&[Flat], &mut Random) -> Vec<Flat>) {
        let at = random.below(self.len() + 1);
        let what = what(self, random);
        self.splice(at..at, what);
    }
}

/// A word of the list; one in ten is a delimiter.
fn word(random: &mut Random) -> Flat {
    match random.below(20) {
        0 => Flat::Open(*random.of(&[Delimiter::Parenthesis, Delimiter::Brace, Delimiter::Bracket, Delimiter::None])),
        1 => Flat::Close,
        _ => {
            let words: Vec<&str> = WORDS.split_whitespace().collect();
            let tokens = TokenStream::from_str(random.of::<&str>(&words)).unwrap_or_default();
            tokens.into_iter().next().map_or(Flat::Close, Flat::Tree)
        }
    }
}

/// Makes some numbers extreme.
fn numbers(flat: &mut [Flat], random: &mut Random) {
    const EXTREME: &[&str] = &[
        "0",
        "0mm",
        "1e36",
        "1e-36",
        "1e35mm",
        "1e36km",
        "1e36turn",
        "1e-30s",
        "1e308",
        "123456789012345678901234567890123456",
        "0.0",
        "1000",
    ];
    for token in flat.iter_mut() {
        let is_number = matches!(token, Flat::Tree(TokenTree::Literal(_)));
        if is_number && random.below(4) == 0 {
            let literal = TokenStream::from_str(random.of::<&str>(EXTREME)).unwrap_or_default().into_iter().next();
            *token = literal.map_or(Flat::Close, Flat::Tree);
        }
    }
}

/// Renames one name everywhere.
fn names(flat: &mut [Flat], random: &mut Random) {
    let idents: Vec<TokenTree> = flat
        .iter()
        .filter_map(|token| if let Flat::Tree(tree @ TokenTree::Ident(_)) = token { Some(tree.clone()) } else { None })
        .collect();
    if idents.is_empty() {
        return;
    }
    let (from, to) = (random.of(&idents).to_string(), random.of(&idents).clone());
    for token in flat.iter_mut().filter(|token| token.to_string() == from) {
        *token = Flat::Tree(to.clone());
    }
}

/// Nests a range of tokens in many delimiters, or repeats it many times.
fn deep(flat: &mut Vec<Flat>, at: usize, end: usize, random: &mut Random) {
    let times = *random.of(&[2, 5, 40, 60, 240, 1000]);
    let stretch = flat[at..end].to_vec();
    let deep: Vec<Flat> = match random.below(4) {
        0 => stretch.iter().cycle().take(stretch.len() * times.min(60)).cloned().collect(),
        1 => {
            let minus = TokenStream::from_str("-").unwrap_or_default().into_iter().map(Flat::Tree);
            minus.cycle().take(times).chain(stretch).collect()
        }
        2 => {
            let call =
                TokenStream::from_str("sin").unwrap_or_default().into_iter().map(Flat::Tree).chain([Flat::Open(Delimiter::Parenthesis)]);
            let calls = call.collect::<Vec<_>>().into_iter().cycle().take(2 * times);
            calls.chain(stretch).chain(std::iter::repeat_n(Flat::Close, times)).collect()
        }
        _ => {
            let delimiter = *random.of(&[Delimiter::Parenthesis, Delimiter::Brace, Delimiter::Bracket, Delimiter::None]);
            let open = std::iter::repeat_n(Flat::Open(delimiter), times);
            open.chain(stretch).chain(std::iter::repeat_n(Flat::Close, times)).collect()
        }
    };
    flat.splice(at..end, deep);
}

/// Flattens a stream.
pub(crate) fn flat(tokens: TokenStream) -> Vec<Flat> {
    let mut flat = Vec::new();
    for tree in tokens {
        if let TokenTree::Group(group) = &tree {
            flat.push(Flat::Open(group.delimiter()));
            flat.extend(self::flat(group.stream()));
            flat.push(Flat::Close);
        } else {
            flat.push(Flat::Tree(tree));
        }
    }
    flat
}

/// A stream from flattened tokens; open groups are closed at the end.
fn nested(flat: &mut impl Iterator<Item = Flat>) -> TokenStream {
    let mut open: Vec<(Delimiter, Vec<TokenTree>)> = vec![(Delimiter::None, Vec::new())];
    let close = |open: &mut Vec<(Delimiter, Vec<TokenTree>)>| {
        if open.len() > 1
            && let Some((delimiter, content)) = open.pop()
            && let Some((_, outer)) = open.last_mut()
        {
            outer.push(TokenTree::Group(Group::new(delimiter, content.into_iter().collect())));
        }
    };
    for token in flat {
        match token {
            Flat::Open(delimiter) => open.push((delimiter, Vec::new())),
            Flat::Close => close(&mut open),
            Flat::Tree(tree) => open.last_mut().into_iter().for_each(|(_, content)| content.push(tree.clone())),
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop().map(|(_, content)| content.into_iter().collect()).unwrap_or_default()
}
