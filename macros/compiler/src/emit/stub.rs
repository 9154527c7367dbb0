//! What is emitted in place of a refused mechanism: the same items without content, so that one
//! mistake gives one error.

use crate::diag::Fact;
use crate::model::is_generated;
use crate::model::suggest::nearest;
use crate::syntax::ast::{Expr, ExprKind, Item, Mechanism, Operator, Use};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// How many `let`s a guess follows.
const LETS: usize = 20;

/// A type with the promised fields and functions, none of which can be run.
pub(crate) fn stub(tree: &Mechanism) -> TokenStream {
    promise(tree, &tree.visibility, &quote!(loop {}))
}

/// A stub that gives way to the mechanism itself, once `wanted` is found to be a constraint.
///
/// A name that is imported by `*` is shadowed by an item of that name, so that the mechanism may be
/// declared beside it; where `wanted` does not resolve, the stub stays and rustc says why. Where it
/// is a macro that is no constraint and swallows the mechanism, the stub cannot be built.
pub(crate) fn fallback(tree: &Mechanism, wanted: &Use) -> TokenStream {
    let Mechanism { visibility, name, .. } = tree;
    let module = format_ident!("__reuleaux_{}", name);
    let why = Fact::NotAConstraint { name: wanted.path.last.to_string() }.to_string();
    let promise = promise(tree, &quote!(pub), &quote!({ let () = #name::<T>::IS_A_CONSTRAINT; loop {} }));
    // An associated constant is only evaluated for functions that are built, after all other errors.
    let check = quote_spanned!(wanted.path.last.span()=> const IS_A_CONSTRAINT: () = ::core::panic!(#why););
    quote! {
        #[doc(hidden)]
        #[allow(warnings, clippy::all)]
        mod #module { #promise impl<T> #name<T> { #check } }
        #[doc(hidden)]
        #[allow(unused_imports, unreachable_pub)]
        #visibility use #module::*;
    }
}

/// All that a mechanism promises; `body` stands in every function.
fn promise(tree: &Mechanism, visibility: &TokenStream, body: &TokenStream) -> TokenStream {
    let Mechanism { name, .. } = tree;
    let (state, failure) = (format_ident!("{}State", name), format_ident!("{}Failure", name));
    let n = 3 * items(tree, "body").len();
    let (structure, accessors, equations) = (structure(tree, visibility), accessors(tree, &state, body), equations(name, n, body));
    let solutions = (!tree.equations_only).then(|| solutions(&state, n, body));
    let outputs = outputs(tree, &state, body);
    let state = (!tree.equations_only || !items(tree, "output").is_empty()).then(|| {
        quote! {
            #[derive(Clone, Debug, PartialEq)]
            #[doc(hidden)]
            #visibility struct #state<T = f64>(pub ::reuleaux::State<T, #n>);
            #[doc(hidden)]
            #[allow(dead_code)]
            #visibility type #failure<T = f64> = ::reuleaux::Failure<T, #n>;
            impl<T> ::core::ops::Deref for #state<T> {
                type Target = ::reuleaux::State<T, #n>;
                fn deref(&self) -> &Self::Target { &self.0 }
            }
            #accessors
        }
    });
    quote! {
        #structure
        #state
        #equations
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #name<T> {
            pub const COORDINATES: usize = #n;
            pub const EQUATIONS: usize = #n;
            pub const JACOBIAN_ENTRIES: usize = 0;
            pub const JACOBIAN_PATTERN: [(usize, usize); 0] = [];
            pub fn jacobian_entries(&self, _: &::reuleaux::nalgebra::SVector<T, #n>, _: T) -> [T; 0] { #body }
            pub fn with_defaults() -> Self { #body }
            #solutions
            #outputs
        }
    }
}

/// The names of all items of a kind, each once, also of those that were refused.
fn items<'a>(tree: &'a Mechanism, kind: &str) -> Vec<&'a Ident> {
    let mut names: Vec<&Ident> = Vec::new();
    for item in &tree.items {
        let found = match item {
            Item::Parameter(parameter) if kind == "param" => &parameter.name,
            Item::Body(frame) if kind == "body" => &frame.name,
            Item::Output(output) if kind == "output" && !is_generated(&output.name) => &output.name,
            Item::Refused(refused) if is_meant(&refused.keyword, kind) && !is_generated(&refused.name) => &refused.name,
            _ => continue,
        };
        if !names.contains(&found) {
            names.push(found);
        }
    }
    names
}

/// A keyword that may be mistyped stands for this kind of item.
fn is_meant(keyword: &Ident, kind: &str) -> bool {
    nearest(&keyword.to_string(), ["param", "body", "output"].into_iter()).is_some_and(|near| near == kind)
}

/// The struct and its defaults. `default` is not generic and so built in every library, also where nobody calls it: it calls
/// nothing itself.
fn structure(tree: &Mechanism, visibility: &TokenStream) -> TokenStream {
    let (name, fields) = (&tree.name, items(tree, "param"));
    let marker = fields.is_empty().then(|| quote!(#[doc(hidden)] pub _real: ::core::marker::PhantomData<T>));
    quote! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[doc(hidden)]
        #visibility struct #name<T = f64> { #(pub #fields: T,)* #marker }
        impl ::core::default::Default for #name<f64> { fn default() -> Self { loop {} } }
    }
}

fn accessors(tree: &Mechanism, state: &Ident, body: &TokenStream) -> TokenStream {
    let bodies = items(tree, "body");
    quote! {
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #state<T> { #(pub fn #bodies(&self) -> ::reuleaux::PlanarBody<T> { #body })* }
    }
}

/// The functions of the runtime's traits, with and without them.
fn equations(name: &Ident, n: usize, body: &TokenStream) -> TokenStream {
    let vector = quote!(::reuleaux::nalgebra::SVector<T, #n>);
    let matrix = quote!(::reuleaux::nalgebra::SMatrix<T, #n, #n>);
    let functions = [
        quote!(fn phi(&self, _: &#vector, _: T) -> #vector { #body }),
        quote!(fn jacobian(&self, _: &#vector, _: T) -> #matrix { #body }),
        quote!(fn linearize(&self, _: &#vector, _: T) -> (#vector, #matrix) { #body }),
        quote!(fn nu(&self, _: &#vector, _: T) -> #vector { #body }),
        quote!(fn gamma(&self, _: &#vector, _: &#vector, _: T) -> #vector { #body }),
    ];
    let description = [
        quote!(fn start(&self) -> #vector { #body }),
        quote!(fn characteristic_length(&self) -> T { #body }),
        quote!(fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { #body }),
    ];
    quote! {
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #name<T> { #(pub #functions)* #(pub #description)* }
        impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
            const NAME: &'static str = "";
            const COORDINATES: &'static [::reuleaux::Coordinate] = &[];
            const ROWS: &'static [::reuleaux::Row] = &[];
            #(#description)*
        }
        impl<T: ::reuleaux::Real> ::reuleaux::Equations<T, #n, #n> for #name<T> { #(#functions)* }
    }
}

fn solutions(state: &Ident, n: usize, body: &TokenStream) -> TokenStream {
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    quote! {
        pub fn solve(&self, _: T) -> #result { #body }
        pub fn solve_near(&self, _: T, _: &::reuleaux::nalgebra::SVector<T, #n>) -> #result { #body }
        pub fn solve_from(&self, _: T, _: &#state<T>) -> #result { #body }
        pub fn sweep<I: ::core::iter::IntoIterator<Item = T>>(&self, _: I) -> ::core::iter::Empty<#result> { #body }
    }
}

fn outputs(tree: &Mechanism, state: &Ident, body: &TokenStream) -> TokenStream {
    let output = |name: &Ident| {
        let value = tree
            .items
            .iter()
            .find_map(|item| if let Item::Output(output) = item { (output.name == *name).then_some(&output.value) } else { None });
        let kind =
            if value.is_some_and(|value| is_vector(value, tree, LETS)) { quote!(::reuleaux::nalgebra::Vector2<T>) } else { quote!(T) };
        quote!(pub fn #name(&self, _: &#state<T>) -> ::reuleaux::Motion<#kind> { #body })
    };
    items(tree, "output").into_iter().map(output).collect()
}

/// A guess at what an output is, from how it is written.
fn is_vector(expr: &Expr, tree: &Mechanism, lets: usize) -> bool {
    match &expr.kind {
        ExprKind::Tuple(_) => true,
        ExprKind::Field(_, name) => !["x", "y", "angle", "c"].contains(&name.to_string().as_str()),
        ExprKind::Call(path, _) => path.name.as_ref().is_some_and(|name| name == "perp" || name == "unit"),
        ExprKind::Negative(value) => is_vector(value, tree, lets),
        ExprKind::Binary(Operator::Power, ..) => false,
        ExprKind::Binary(_, one, two) => is_vector(one, tree, lets) || is_vector(two, tree, lets),
        ExprKind::Path(path) => path.name.as_ref().is_some_and(|name| names_vector(name, tree, lets)),
        ExprKind::Number { .. } | ExprKind::List(_) | ExprKind::If { .. } => false,
    }
}

/// A `let` that is a vector, or a point whose body was forgotten.
fn names_vector(name: &Ident, tree: &Mechanism, lets: usize) -> bool {
    tree.items.iter().any(|item| match item {
        Item::Let(binding) => binding.name == *name && lets > 0 && is_vector(&binding.value, tree, lets - 1),
        Item::Body(frame) | Item::Ground(frame) => frame.marks.iter().any(|mark| mark.name == *name),
        _ => false,
    })
}
