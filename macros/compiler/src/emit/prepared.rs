//! A mechanism with everything computed that depends on its parameters only and is worth keeping.

use super::block::BlockPrinter;
use super::expression::local;
use super::functions::Emitter;
use super::literal::number;
use super::{allowed, docs, state_path};
use crate::plan::{Plan, Solving, StraightLine};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The body of `stages`, and the runtime's trait `Prepare`.
    pub(super) fn prepared(&self, body: TokenStream) -> (TokenStream, TokenStream) {
        let (mechanism, state, n) = (&self.model.name, state_path(&self.model.name), number(self.system.width()));
        let count = number(fixed_names(self.plan).len());
        let (body, kept) = self.kept(body, &n, &count);
        let type_name = format_ident!("{}Prepared", mechanism, span = Span::call_site());
        let page = docs::line(&format!(
            "A [`{mechanism}`] with everything computed that depends on its parameters only, made by [`{mechanism}::prepared`]."
        ));
        let (visibility, allowed) = (&self.model.visibility, allowed());
        if self.model.holds_inputs() {
            let types = quote! {
                #allowed
                impl<T: ::reuleaux::SolverReal> ::reuleaux::Prepare<T, #n, #count> for #mechanism<T> {
                    type State = #state<T>;
                    fn named(state: ::reuleaux::State<T, #n>) -> Self::State { #state(state, Self::with_defaults().inputs) }
                    fn unnamed(state: &mut Self::State) -> &mut ::reuleaux::State<T, #n> { &mut state.0 }
                    #kept
                }
            };
            return (body, types);
        }
        let types = quote! {
            #page
            #[allow(dead_code)]
            #visibility type #type_name<T = ::core::primitive::f64> = ::reuleaux::Prepared<#mechanism<T>, T, #n, #count>;
            #allowed
            impl<T: ::reuleaux::SolverReal> #mechanism<T> {
                /// The mechanism with everything computed that depends on its parameters only, for loops that take a state along
                /// with `advance`; `sweep` does so by itself.
                #[must_use]
                pub fn prepared(&self) -> #type_name<T> { ::reuleaux::Prepared::new(*self) }
            }
            #allowed
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Prepare<T, #n, #count> for #mechanism<T> {
                type State = #state<T>;
                fn named(state: ::reuleaux::State<T, #n>) -> Self::State { #state(state) }
                fn unnamed(state: &mut Self::State) -> &mut ::reuleaux::State<T, #n> { &mut state.0 }
                #kept
            }
        };
        (body, types)
    }

    /// The body of `stages`, and the functions that compute and read the numbers that depend on parameters only, if any are kept.
    fn kept(&self, body: TokenStream, n: &TokenStream, count: &TokenStream) -> (TokenStream, TokenStream) {
        let Some(lines) = straight(self.plan).filter(|lines| !lines.fixed_names.is_empty()) else { return (body, quote!()) };
        let printer =
            BlockPrinter { model: self.model, arena: &self.plan.arena, lines, unknowns: &[], equations: &[], kept: &[], origins: None };
        let steps = printer.steps(&lines.names, &lines.fixed);
        let names: Vec<Ident> = lines.fixed_names.iter().map(|name| local(name)).collect();
        let (fixed, t, pass) = (local("fixed"), local("t"), local("pass"));
        let kept = quote! {
            fn fixed(&self) -> [T; #count] { #steps [#(#names),*] }
            #[inline(always)]
            fn stages_with(
                &self,
                #fixed: &[T; #count],
                #t: T,
                #pass: &mut ::reuleaux::Solver<'_, T, #n>,
            ) -> ::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::StepError<T>> {
                let [#(#names),*] = *#fixed;
                #body
            }
        };
        let prepare = quote!(::reuleaux::Prepare::<T, #n, #count>);
        (quote!(#prepare::stages_with(self, &#prepare::fixed(self), #t, #pass)), kept)
    }
}

/// Names of the kept numbers, which depend on parameters only.
pub(super) fn fixed_names(plan: &Plan) -> &[String] {
    straight(plan).map_or(&[], |lines| &lines.fixed_names)
}

fn straight(plan: &Plan) -> Option<&StraightLine> {
    match plan.solution.as_ref().map(|solution| &solution.solving) {
        Some(Solving::Straight(lines)) => Some(lines),
        _ => None,
    }
}
