//! Parses the items of a mechanism.

use super::ast::{
    Closing, ComponentHome, ComponentItem, Docs, Expression, ExpressionKind, Following, Gravity, Item, JointItem, Mechanism, Requests,
    Shared, StartItem, Task, TimeRange, Use, has_item,
};
use super::definition::{ambient, binding};
use super::expression::{expression, indices, value};
use super::frame::{body, ground};
use super::function::function;
use super::joint::{energy, freedom, joint};
use super::options::{Options, options, passing, velocity};
use super::output::output;
use super::parameter::{input_item, limits, parameter};
use super::repeated::{component, part, repeated_items};
use super::salvage;
use super::slip::{constant_of_rust, one_word};
use super::tokens::{
    Parsed, attributes, block, braces, comma, expected, is_item, keyword, mentions_masses, name, name_before_block, path, report,
    semicolon, skip_item, skip_to_block, statement_text, visibility, wrong,
};
use crate::diag::{ArrayFact, Diag, GrammarFact, ValueFact, Word};
use crate::quantity::{self, Ambient, Dim};
use crate::words::{Home, home, is_command, is_synonym};
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// `pub mechanism Name { items }`
pub(super) fn mechanism(input: ParseStream, diag: &mut Diag) -> Option<Mechanism> {
    let beginning = input.fork();
    let mut mechanism = match head(input) {
        Ok(mechanism) => mechanism,
        Err(refusal) => {
            diag.refuse::<()>(refusal.range, refusal.fact);
            skip_to_block(input)?;
            salvaged(&beginning)?
        }
    };
    let place = input.fork();
    let content = report(block(input, "`{` and the items of the mechanism"), diag).or_else(|| {
        // `Name space {` is meant like `Name in space {`.
        mechanism.ambient = if keyword(&place).is_some_and(|word| word == "space") { Ambient::Space } else { mechanism.ambient };
        skip_to_block(input)?;
        braces(input).ok().map(|(content, _)| content)
    });
    let Some(content) = content else { return Some(mechanism) };
    mechanism.mentions_masses = content.fork().parse().is_ok_and(mentions_masses);
    mechanism.items = items(&content, ItemContext::top(mechanism.ambient), diag);
    if mechanism.task == Task::Kinematics && has_item(&mechanism.items, is_freedom) {
        mechanism.task = Task::Motion;
    }
    if !input.is_empty() {
        diag.refuse::<()>(
            input.span(),
            GrammarFact::TokensAfter { what: "the mechanism", help: "write one `mechanism!` for each mechanism" },
        );
    }
    Some(mechanism)
}

fn is_freedom(item: &Item) -> bool {
    matches!(item, Item::Joint(joint) if joint.is_freedom())
}

/// Parses everything before the items.
fn head(input: ParseStream) -> Parsed<Mechanism> {
    let (docs, options) = options(input)?;
    let visibility = visibility(input)?;
    if keyword(input).is_none_or(|word| word != "mechanism") {
        return expected(input, "`mechanism Name { … }`");
    }
    Ident::parse_any(input)?;
    let name = name(input, "the name of the mechanism")?;
    one_word(input, &name, true)?;
    if name == "T" {
        return wrong(&name, GrammarFact::NumberType);
    }
    let ambient = ambient(input)?.unwrap_or_default();
    let Options { task, closing, following, allows_far_start, requests } = options;
    let (items, mentions_masses) = (Vec::new(), false);
    let homes = Vec::new();
    Ok(Mechanism { docs, task, closing, following, allows_far_start, requests, visibility, name, ambient, items, homes, mentions_masses })
}

/// A mechanism whose head has a mistake: its name, and `in space` if written.
fn salvaged(head: ParseStream) -> Option<Mechanism> {
    let name = name_before_block(head)?;
    Some(without_items(name, ambient(head).ok().flatten().unwrap_or_default()))
}

/// A mechanism with imported components, and the definitions that these see.
pub(super) fn with_components(tree: &Mechanism, components: Vec<Shared<ComponentItem>>, homes: Vec<ComponentHome>) -> Mechanism {
    let mut whole = tree.clone();
    whole.items.extend(components.into_iter().map(Item::Component));
    whole.homes = homes;
    if whole.task == Task::Kinematics && has_item(&whole.items, is_freedom) {
        whole.task = Task::Motion;
    }
    whole
}

/// A mechanism of which only the name is known.
pub(super) fn without_items(name: Ident, ambient: Ambient) -> Mechanism {
    Mechanism {
        docs: Docs::default(),
        task: Task::default(),
        closing: Closing::default(),
        allows_far_start: false,
        following: Following::default(),
        requests: Requests::default(),
        visibility: quote::quote!(pub),
        name,
        ambient,
        items: Vec::new(),
        homes: Vec::new(),
        mentions_masses: false,
    }
}

/// Context of an item.
#[derive(Clone, Copy)]
pub(super) struct ItemContext<'a> {
    /// True in the mechanism itself, false in a component or a loop.
    pub(super) is_top: bool,
    /// The variable of the innermost loop.
    pub(super) variable: Option<&'a Ident>,
    /// Where the bodies move.
    pub(super) ambient: Ambient,
}

impl ItemContext<'_> {
    /// The mechanism itself.
    pub(super) fn top(ambient: Ambient) -> ItemContext<'static> {
        ItemContext { is_top: true, variable: None, ambient }
    }
}

/// Parses items. A rejected item leaves behind what could be read of it, and parsing goes on with the next item.
pub(super) fn items(content: ParseStream, place: ItemContext, diag: &mut Diag) -> Vec<Item> {
    let mut items = Vec::new();
    while !content.is_empty() {
        let before = content.fork();
        match item(content, place, diag) {
            Ok(item) => items.push(item),
            Err(refusal) => {
                diag.refuse::<()>(refusal.range, refusal.fact);
                items.extend(salvage::salvaged(&before.fork(), place.ambient).map(|item| Item::Refused(Box::new(item))));
                skip_item(content, &before, is_item);
            }
        }
    }
    items
}

fn item(input: ParseStream, place: ItemContext, diag: &mut Diag) -> Parsed<Item> {
    let (docs, mut others) = attributes(input)?;
    if input.peek(Token![;]) {
        return wrong(input.span(), GrammarFact::Stray { sign: ';' });
    }
    if input.peek(Token![,]) {
        return wrong(input.span(), GrammarFact::Stray { sign: ',' });
    }
    let Some(keyword) = keyword(input) else {
        return expected(
            input,
            "an item: `param`, `input`, `let`, `ground`, `body`, `joint`, `drive`, `freedom`, `force`, `energy`, `gravity`, `start`, `output`, `range`, `part`, `for`, `component`, `function` or `use`",
        );
    };
    let word = keyword.to_string();
    let is_equation = matches!(word.as_str(), "joint" | "drive" | "redundant") || word == "slice" && slices_load(input);
    let velocity = if is_equation { velocity(&mut others)? } else { None };
    let docs = passing(docs, others, &word)?;
    if !place.is_top && matches!(word.as_str(), "gravity" | "use" | "function" | "ground" | "component" | "range") {
        return wrong(&keyword, GrammarFact::OnlyAtTheTop { word });
    }
    let item = match word.as_str() {
        "use" => Item::Use(uses(input)?),
        "let" => Item::Let(Shared::new(binding(input)?)),
        "param" => Item::Parameter(Shared::new(parameter(input, docs)?)),
        "input" => Item::Input(Shared::new(input_item(input, docs)?)),
        "function" => Item::Function(Shared::new(function(input)?)),
        "ground" => Item::Ground(Shared::new(ground(input, docs, diag)?)),
        "body" => Item::Body(Shared::new(body(input, docs, diag)?)),
        "joint" | "drive" | "redundant" => Item::Joint(Shared::new(JointItem { velocity, ..joint(input, docs)? })),
        "freedom" => Item::Joint(Shared::new(freedom(input, docs)?)),
        // A force may depend on time.
        "force" => Item::Force(Shared::new(JointItem { is_drive: true, ..joint(input, docs)? })),
        "energy" => Item::Force(Shared::new(energy(input, docs)?)),
        "gravity" => Item::Gravity(Shared::new(gravity(input)?)),
        "start" => Item::Start(Shared::new(joint_start(input)?)),
        "slice" if slices_load(input) => {
            Ident::parse_any(input)?;
            let is_force = self::keyword(input).is_some_and(|word| word == "force");
            let item = JointItem { is_slice: true, velocity, ..joint(input, docs)? };
            // A force may depend on time.
            if is_force { Item::Force(Shared::new(JointItem { is_drive: true, ..item })) } else { Item::Joint(Shared::new(item)) }
        }
        "output" | "slice" => Item::Output(Shared::new(output(input, docs)?)),
        "range" => Item::Range(Shared::new(times(input)?)),
        "component" => Item::Component(Shared::new(component(input, docs, Some(place.ambient), diag)?)),
        "part" => Item::Part(Shared::new(part(input, docs)?)),
        "for" => Item::For(Shared::new(repeated_items(input, place.ambient, diag)?)),
        _ => return unknown_item(input, &keyword, place),
    };
    has_indices(&item, place)?;
    Ok(item)
}

/// True if `slice` stands before a joint, a drive or a force.
fn slices_load(input: ParseStream) -> bool {
    let ahead = input.fork();
    Ident::parse_any(&ahead).is_ok()
        && keyword(&ahead).is_some_and(|word| ["joint", "drive", "force", "redundant"].iter().any(|known| word == known))
}

/// Refuses a word that begins no item. A word of the workshop before braces is a body, before `=` the kind of a joint.
fn unknown_item<T>(input: ParseStream, keyword: &Ident, ItemContext { is_top, variable, ambient }: ItemContext) -> Parsed<T> {
    let word = keyword.to_string();
    let rest = input.fork();
    Ident::parse_any(&rest)?;
    let name = rest.parse::<Ident>().ok().map(|name| name.to_string());
    if let (true, Some(name)) = (["point", "axis"].contains(&word.as_str()), &name) {
        return wrong(keyword, GrammarFact::FeatureOutside { word, name: name.clone(), in_component: !is_top && variable.is_none() });
    }
    if let Some((flaw, instead)) = of_other_kind(&word, &rest.fork(), variable.is_some())?.filter(|_| name.is_none() || word == "if") {
        return wrong(keyword, GrammarFact::Misspelt { flaw, instead });
    }
    let sets_solver = rest.peek(Token![=]) && ["solver", "integrator", "method", "tolerance", "simulation"].contains(&word.as_str());
    if is_command(&word) && name.is_none() && (rest.peek(token::Paren) || sets_solver) {
        return wrong(keyword, GrammarFact::UnknownItem { word, name, home: None });
    }
    if let (Some(name), true) = (&name, rest.peek(token::Paren) && word.starts_with(char::is_uppercase) && home(&word, ambient).is_none()) {
        let instead = format!("part {name} = {word}{};", statement_text(&rest)?);
        return wrong(
            keyword,
            GrammarFact::Misspelt { flaw: "a part of a mechanism begins with its kind, and `=` comes after its name", instead },
        );
    }
    // A call of a constraint or a force lacks the keyword, and its name or `=`.
    let is_call = if name.is_some() { rest.peek(Token![=]) && rest.peek2(token::Paren) } else { rest.peek(token::Paren) };
    if let Some(instead) = without_keyword(&word, name.as_deref(), &rest.fork(), ambient)? {
        return wrong(keyword, GrammarFact::Misspelt { flaw: "an item begins with its kind, and has a name", instead });
    }
    let is_own = |call: &str| call.split_once('(').is_some_and(|(name, _)| name == word);
    let kind = match home(&word, ambient) {
        _ if word.starts_with("drive") => Some(Word::Drive),
        Some(Home::Drive(call)) => is_own(call).then_some(Word::Drive),
        Some(Home::Force(call)) => is_own(call).then_some(Word::Force),
        Some(Home::Joint(calls)) => calls.iter().any(|call| is_own(call)).then_some(Word::Joint),
        None if is_call && is_synonym("point", &word) => {
            rest.parse::<Token![=]>()?;
            let instead = format!("ground {{ point {} = {}; }}", name.unwrap_or_default(), statement_text(&rest)?);
            return wrong(keyword, GrammarFact::Misspelt { flaw: "a place in ground is a point", instead });
        }
        _ => Some(Word::Joint),
    };
    if let (Some(kind), Some(name), true) = (kind, &name, is_call) {
        rest.parse::<Token![=]>()?;
        let instead = format!("{kind} {name} = {word}{};", statement_text(&rest)?);
        return wrong(keyword, GrammarFact::Misspelt { flaw: "the name comes first, and the kind behind `=`", instead });
    }
    if let Some(kind) = kind.filter(|_| is_call) {
        return wrong(keyword, GrammarFact::Unnamed { word: kind, kind: word });
    }
    let is_frame = ["fixed", "frame", "base", "world"].contains(&word.as_str());
    let home = match home(&word, ambient) {
        Some(_) if rest.peek(token::Brace) => (!is_frame).then_some(Home::Body),
        None if rest.peek(token::Brace) && name.is_some() && is_of_body(&word) => Some(Home::Body),
        home => home,
    };
    wrong(keyword, GrammarFact::UnknownItem { word, name, home })
}

/// True for `RigidBody2D`.
fn is_of_body(word: &str) -> bool {
    word.starts_with(char::is_uppercase) && is_synonym("body", &word.trim_end_matches("2D").trim_end_matches("3D").to_lowercase())
}

/// A choice of items in a loop, a field of a struct, and an element of an array without its kind: what is wrong, and the line to type.
fn of_other_kind(word: &str, rest: ParseStream, is_in_loop: bool) -> Parsed<Option<(&'static str, String)>> {
    if word == "if" && is_in_loop {
        return Ok(Some(("items are not chosen: let a loop begin where they do", "for i in 1..n { … }".to_owned())));
    }
    if rest.peek(Token![:]) && !rest.peek(Token![::]) {
        rest.parse::<Token![:]>()?;
        let is_dimension = keyword(rest).is_some_and(|first| Dim::named(&first.to_string()).is_some());
        let text = statement_text(rest)?;
        let dimension = text.split('=').next().filter(|_| is_dimension);
        return Ok(dimension.map(|dimension| ("an item begins with its kind", format!("param {word}: {dimension} = …;"))));
    }
    if !rest.peek(token::Bracket) {
        return Ok(None);
    }
    let place: String = indices(rest)?.iter().map(|index| format!("[{index}]")).collect();
    if !rest.peek(Token![=]) || rest.peek(Token![==]) {
        return Ok(None);
    }
    let text = statement_text(rest)?;
    let kind = if text.trim_start_matches(['=', ' ']).starts_with(char::is_uppercase) { "part" } else { "let" };
    let text = text.replacen('=', " = ", 1);
    Ok(Some(("an item begins with its kind", format!("{kind} {word}{place}{text};"))))
}

/// The item that was meant by `name = value` or, as in other languages, `type name = value`; none for a word that belongs elsewhere.
fn without_keyword(word: &str, name: Option<&str>, rest: ParseStream, ambient: Ambient) -> Parsed<Option<String>> {
    const TYPES: [&str; 10] = ["double", "float", "real", "Real", "int", "f64", "f32", "var", "const", "auto"];
    const OF_BODIES: [&str; 8] = ["mass", "center", "inertia", "x", "y", "angle", "position", "orientation"];
    if !rest.peek(Token![=]) || rest.peek(Token![==]) || OF_BODIES.contains(&word) {
        return Ok(None);
    }
    if let Some(name) = name {
        return Ok(TYPES.contains(&word).then(|| format!("let {name} = …;")));
    }
    rest.parse::<Token![=]>()?;
    let value = expression(&rest.fork()).map_or("…".to_owned(), |value| value.to_string());
    let call = rest.parse::<Ident>().ok().filter(|_| rest.peek(token::Paren)).map(|call| call.to_string());
    Ok(Some(match call {
        Some(call) if call.starts_with("drive_") => format!("drive {word} = {call}(…);"),
        Some(call) if call.starts_with(char::is_uppercase) => format!("part {word} = {call}(…);"),
        Some(call) => match home(&call, ambient) {
            Some(Home::Joint(_)) => format!("joint {word} = {call}(…);"),
            Some(Home::Drive(_)) => format!("drive {word} = {call}(…);"),
            Some(Home::Force(_)) => format!("force {word} = {call}(…);"),
            _ => format!("let {word} = {value};"),
        },
        None => format!("let {word} = {value};"),
    }))
}

/// Checks that a name declared in a loop has an index; without it all its instances would have one name.
fn has_indices(item: &Item, place: ItemContext) -> Parsed<()> {
    let (name, indices) = match item {
        Item::Parameter(item) | Item::Input(item) => (&item.name, &item.indices),
        Item::Let(item) => (&item.name, &item.indices),
        Item::Body(item) => (&item.name, &item.indices),
        Item::Joint(item) | Item::Force(item) => (&item.name, &item.indices),
        Item::Output(item) => (&item.name, &item.indices),
        Item::Part(item) => (&item.name, &item.indices),
        _ => return Ok(()),
    };
    indexed(name, indices, place)
}

/// The same check for any name.
pub(super) fn indexed(name: &Ident, indices: &[Expression], place: ItemContext) -> Parsed<()> {
    match place.variable {
        Some(variable) if indices.is_empty() => {
            wrong(name, ArrayFact::WithoutIndex { name: name.to_string(), variable: variable.to_string() })
        }
        _ => Ok(()),
    }
}

/// `use a::b::{c, d as e};`
fn uses(input: ParseStream) -> Parsed<Vec<Use>> {
    input.parse::<Token![use]>()?;
    let prefix = path(input)?;
    let mut uses = Vec::new();
    if !input.peek(Token![::]) {
        uses.push(renamed(input, prefix)?);
        return semicolon(input).map(|()| uses);
    }
    input.parse::<Token![::]>()?;
    if !input.peek(token::Brace) {
        return expected(input, "the name of a constraint or `{ … }`");
    }
    let (content, _) = braces(input)?;
    while !content.is_empty() {
        let mut inner = path(&content)?;
        let (before, after) = (&prefix.tokens, &inner.tokens);
        inner.tokens = quote::quote!(#before::#after);
        uses.push(renamed(&content, inner)?);
        comma(&content, "`,` or `}`")?;
    }
    semicolon(input)?;
    Ok(uses)
}

fn renamed(input: ParseStream, path: super::ast::Path) -> Parsed<Use> {
    let first = path.tokens.clone().into_iter().next().map_or(String::new(), |word| word.to_string());
    if ["std", "core", "libm"].contains(&first.as_str()) {
        if let Some(instead) = constant_of_rust(&path) {
            let flaw = "constants need no `use`: take it away";
            return wrong(path.range, GrammarFact::Misspelt { flaw, instead: instead.to_owned() });
        }
        let flaw = "`use` brings in constraints, forces, functions and components; functions of numbers stand by themselves";
        return wrong(path.range, GrammarFact::Misspelt { flaw, instead: format!("{}(…)", path.last) });
    }
    if !input.peek(Token![as]) {
        return Ok(Use { name: path.last.clone(), path });
    }
    input.parse::<Token![as]>()?;
    Ok(Use { path, name: name(input, "a name after `as`")? })
}

/// `gravity = (x, y);`
fn gravity(input: ParseStream) -> Parsed<Gravity> {
    let keyword = Ident::parse_any(input)?;
    Ok(Gravity { keyword, value: value(input, "gravity")? })
}

/// `start joint.angle = value;`
fn joint_start(input: ParseStream) -> Parsed<StartItem> {
    Ident::parse_any(input)?;
    if input.peek(token::Brace) {
        return expected(input, "a value of a joint, such as `hinge.angle`");
    }
    let quantity = expression(input)?;
    let value = value(input, format_args!("start {quantity}"))?;
    Ok(StartItem { quantity, value })
}

/// `range t in from..to;`
fn times(input: ParseStream) -> Parsed<TimeRange> {
    let keyword = Ident::parse_any(input)?;
    if let Some(bounded) = self::keyword(input).filter(|word| word != "t" && input.peek2(Token![in])) {
        let ahead = input.fork();
        Ident::parse_any(&ahead)?;
        let limits = limits(&ahead)?;
        let unit = limits.from.as_ref().and_then(|from| match &from.kind {
            ExpressionKind::Number { unit, .. } => quantity::unit(unit),
            _ => None,
        });
        if unit.is_none_or(|(_, dim)| dim == Dim::TIME) {
            return expected(input, "`t in from..to`");
        }
        let [from, to] = [limits.from, limits.to].map(|end| end.map_or(String::new(), |end| end.to_string()));
        let (flaw, instead) = ("a range is one of time; a parameter has bounds", format!("param {bounded}: … = … in {from}..={to};"));
        return wrong(&bounded, GrammarFact::Misspelt { flaw, instead });
    }
    if self::keyword(input).is_none_or(|word| word != "t") || !input.peek2(Token![in]) {
        return expected(input, "`t in from..to`");
    }
    Ident::parse_any(input)?;
    let limits = limits(input)?;
    if limits.from.is_none() || limits.to.is_none() {
        return wrong(limits.range, ValueFact::RangeWithoutEnd);
    }
    if let (Some(word), Some(from), Some(to)) = (self::keyword(input), &limits.from, &limits.to) {
        let flaw = "a range has no steps: times between are those of a sweep, in Rust";
        return wrong(&word, GrammarFact::Misspelt { flaw, instead: format!("range t in {from}..{to};") });
    }
    semicolon(input)?;
    Ok(TimeRange { keyword, limits })
}
