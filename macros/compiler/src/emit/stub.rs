//! What is emitted in place of a refused mechanism: the same items without content, so that one
//! mistake gives one error.

use crate::syntax::ast::{Expr, ExprKind, Item, Mechanism, Operator};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// A type with the promised fields and functions, none of which can be run.
pub(crate) fn stub(tree: &Mechanism) -> TokenStream {
    let Mechanism { visibility, name, items, .. } = tree;
    let state = format_ident!("{}State", name);
    let fields: Vec<_> = items.iter().filter_map(|item| if let Item::Parameter(parameter) = item { Some(&parameter.name) } else { None }).collect();
    let mut fields_once: Vec<_> = Vec::new();
    fields.iter().for_each(|field| if !fields_once.contains(field) { fields_once.push(*field) });
    let bodies: Vec<_> = items.iter().filter_map(|item| if let Item::Body(frame) = item { Some(&frame.name) } else { None }).collect();
    let mut bodies_once: Vec<_> = Vec::new();
    bodies.iter().for_each(|body| if !bodies_once.contains(body) { bodies_once.push(*body) });
    let n = 3 * bodies.len();
    let mut seen = Vec::new();
    let outputs = items.iter().filter_map(|item| {
        let Item::Output(output) = item else { return None };
        if seen.contains(&&output.name) {
            return None;
        }
        seen.push(&output.name);
        let name = &output.name;
        let kind = if is_vector(&output.value) { quote!(::reuleaux::nalgebra::Vector2<T>) } else { quote!(T) };
        Some(quote!(pub fn #name(&self, _: &#state<T>) -> ::reuleaux::Motion<#kind> { loop {} }))
    });
    let outputs: TokenStream = outputs.collect();
    let vector = quote!(::reuleaux::nalgebra::SVector<T, #n>);
    let matrix = quote!(::reuleaux::nalgebra::SMatrix<T, #n, #n>);
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    quote! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[doc(hidden)]
        #visibility struct #name<T = f64> { #(pub #fields_once: T,)* #[doc(hidden)] pub _real: ::core::marker::PhantomData<T> }
        impl ::core::default::Default for #name<f64> { fn default() -> Self { loop {} } }
        #[derive(Clone, Debug, PartialEq)]
        #[doc(hidden)]
        #visibility struct #state<T = f64>(pub ::reuleaux::State<T, #n>);
        impl<T> ::core::ops::Deref for #state<T> {
            type Target = ::reuleaux::State<T, #n>;
            fn deref(&self) -> &Self::Target { &self.0 }
        }
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #state<T> { #(pub fn #bodies_once(&self) -> ::reuleaux::PlanarBody<T> { loop {} })* }
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #name<T> {
            pub fn with_defaults() -> Self { loop {} }
            pub fn phi(&self, _: &#vector, _: T) -> #vector { loop {} }
            pub fn jacobian(&self, _: &#vector, _: T) -> #matrix { loop {} }
            pub fn nu(&self, _: &#vector, _: T) -> #vector { loop {} }
            pub fn gamma(&self, _: &#vector, _: &#vector, _: T) -> #vector { loop {} }
            pub fn start(&self) -> #vector { loop {} }
            pub fn solve(&self, _: T) -> #result { loop {} }
            pub fn solve_near(&self, _: T, _: &#vector) -> #result { loop {} }
            pub fn solve_from(&self, _: T, _: &#state<T>) -> #result { loop {} }
            pub fn sweep<I: ::core::iter::IntoIterator<Item = T>>(&self, _: I) -> ::core::iter::Empty<#result> { loop {} }
            #outputs
        }
    }
}

/// A guess at what an output is, from how it is written.
fn is_vector(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Tuple(_) => true,
        ExprKind::Field(_, name) => !["x", "y", "angle"].contains(&name.to_string().as_str()),
        ExprKind::Call(path, _) => ["perp", "unit"].contains(&path.tokens.to_string().as_str()),
        ExprKind::Negative(value) => is_vector(value),
        ExprKind::Binary(Operator::Power, ..) => false,
        ExprKind::Binary(_, one, two) => is_vector(one) || is_vector(two),
        ExprKind::Number { .. } | ExprKind::Path(_) | ExprKind::List(_) | ExprKind::If { .. } => false,
    }
}
