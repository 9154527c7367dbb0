//! The generated way to solve a mechanism: stage by stage.

use super::expression::{Printer, local};
use super::functions::Emitter;
use super::routine::statement;
use crate::expr::Expr;
use crate::model::Dim;
use crate::plan::{Iterated, Part, Solution, Step};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// Blocks of up to this many unknowns are solved in closed form.
const SMALL: usize = 3;

impl Emitter<'_> {
    /// The runtime's trait `Stages`; without a plan, its provided way.
    pub(super) fn stages(&self) -> TokenStream {
        let (name, n) = (&self.model.name, self.system.unknowns.len());
        if self.model.equations_only {
            return quote!();
        }
        let (toward, angles) = (self.toward(), self.plan.solution.as_ref().map(|solution| self.computed_angles(solution)));
        let iterated = self.plan.solution.as_ref().map(iterated);
        let body = self.plan.solution.as_ref().map(|solution| self.solution(solution));
        quote! {
            #[automatically_derived]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, unused_variables, unused_parens)]
            impl<T: ::reuleaux::Lanes> ::reuleaux::Stages<T, #n> for #name<T> { #angles #iterated #toward #body }
        }
    }

    /// Computed angles that move
    fn computed_angles(&self, solution: &Solution) -> TokenStream {
        let angle = |part: &Part| match part {
            Part::Explicit { unknown, motion, .. } if self.system.unknowns[*unknown].dim == Dim::ANGLE => {
                self.plan.arena.as_constant(motion[0]).is_none().then(|| Literal::usize_unsuffixed(*unknown))
            }
            _ => None,
        };
        let angles = solution.parts.iter().filter_map(angle);
        quote!(const COMPUTED_ANGLES: &'static [usize] = &[#(#angles),*];)
    }

    /// Parameters between the defaults and these
    fn toward(&self) -> TokenStream {
        if self.model.parameters.is_empty() {
            return quote!();
        }
        let fields: Vec<&Ident> = self.model.parameters.iter().map(|parameter| &parameter.name).collect();
        let share = local("share");
        quote! {
            fn toward(&self, #share: T) -> ::core::option::Option<Self> {
                let defaults = Self::with_defaults();
                if self == &defaults {
                    return ::core::option::Option::None;
                }
                ::core::option::Option::Some(Self { #(#fields: defaults.#fields + #share * (self.#fields - defaults.#fields),)* })
            }
        }
    }

    fn solution(&self, solution: &Solution) -> TokenStream {
        let n = solution.unknowns.len();
        let (t, pass) = (local("t"), local("pass"));
        let parts = solution.parts.iter().enumerate().map(|(number, part)| self.part(solution, number, part));
        let column = |order: usize| -> Vec<Ident> { solution.unknowns.iter().map(|names| local(&names[order])).collect() };
        let (q, qd, qdd) = (column(0), column(1), column(2));
        quote! {
            #[inline(always)]
            fn stages(
                &self,
                #t: T,
                #pass: &mut ::reuleaux::Pass<'_, T, #n>,
            ) -> ::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::Stop<T>> {
                #(#parts)*
                ::core::result::Result::Ok(::reuleaux::Coordinates {
                    q: ::reuleaux::nalgebra::SVector::from([#(#q),*]),
                    qd: ::reuleaux::nalgebra::SVector::from([#(#qd),*]),
                    qdd: ::reuleaux::nalgebra::SVector::from([#(#qdd),*]),
                })
            }
        }
    }

    fn steps(&self, names: &BTreeMap<Expr, String>, steps: &[Step]) -> TokenStream {
        let printer = Printer { arena: &self.plan.arena, names, turn: "turn" };
        steps.iter().map(|step| statement(self.model, &printer, step)).collect()
    }

    fn part(&self, solution: &Solution, number: usize, part: &Part) -> TokenStream {
        match part {
            Part::Block(block) => self.block(solution, number, block),
            Part::Explicit { steps, unknown, motion } => {
                let steps = self.steps(&solution.names, steps);
                let printer = Printer { arena: &self.plan.arena, names: &solution.names, turn: "turn" };
                let names = solution.unknowns[*unknown].each_ref().map(|name| local(name));
                let values = motion.map(|expr| printer.expression(expr));
                quote!(#steps #(let #names = #values;)*)
            }
        }
    }

    fn block(&self, solution: &Solution, number: usize, block: &Iterated) -> TokenStream {
        let k = block.system.unknowns.len();
        let (before, rates, accelerations) = (&block.before, &block.rates, &block.accelerations);
        let (before, rates, accelerations) =
            (self.steps(&solution.names, before), self.steps(&solution.names, rates), self.steps(&solution.names, accelerations));
        let outer = Printer { arena: &self.plan.arena, names: &solution.names, turn: "turn" };
        let inner = Printer { arena: &self.plan.arena, names: &block.names, turn: "turn" };
        let inside = self.steps(&block.names, &block.inside);
        let list = |printer: &Printer, exprs: &[Expr]| -> Vec<TokenStream> { exprs.iter().map(|expr| printer.expression(*expr)).collect() };
        let residuals = list(&inner, &block.system.residuals);
        let rows = block.system.jacobian.iter().map(|row| {
            let entries = list(&inner, row);
            quote!([#(#entries),*])
        });
        let sizes = list(&outer, &block.system.sizes);
        let (rate_sides, acceleration_sides) = (list(&outer, &block.system.rates), list(&outer, &block.system.accelerations));
        let motion = |order: usize| -> Vec<Ident> {
            block.system.unknowns.iter().map(|unknown| local(&solution.unknowns[*unknown][order])).collect()
        };
        let (x, xd, xdd) = (motion(0), motion(1), motion(2));
        let indices = |list: &[usize]| -> Vec<Literal> { list.iter().map(|index| Literal::usize_unsuffixed(*index)).collect() };
        let (unknowns, equations) = (indices(&block.system.unknowns), indices(&block.system.equations));
        let kinds = block.system.unknowns.iter().map(|unknown| self.kind(*unknown));
        let turns = block.turns.iter().map(|names| names.iter().any(Option::is_some));
        let pairs: Vec<TokenStream> = block
            .turns
            .iter()
            .map(|names| {
                let [sine, cosine] = names.each_ref().map(|name| {
                    name.as_ref().map_or(quote!(_), |name| {
                        let name = local(name);
                        quote!(#name)
                    })
                });
                quote!((#sine, #cosine))
            })
            .collect();
        let method = local(if k <= SMALL { "small" } else { "large" });
        let (pass, place, solved) = (local("pass"), local("place"), local(&format!("block_{number}")));
        quote! {
            #before
            let #solved = #pass.#method(
                &::reuleaux::Block { unknowns: [#(#unknowns),*], equations: [#(#equations),*], kinds: [#(#kinds),*], turns: [#(#turns),*] },
                [#(#sizes),*],
                #[inline(always)]
                |#place: &::reuleaux::Place<T, #k>| {
                    let [#(#x),*] = #place.x.data.0[0];
                    let [#(#pairs),*] = #place.turn;
                    #inside
                    ([#(#residuals),*], [#(#rows),*])
                },
            )?;
            let [#(#x),*] = #solved.x;
            let [#(#pairs),*] = #solved.turn;
            #rates
            let [#(#xd),*] = #solved.rates([#(#rate_sides),*]);
            #accelerations
            let [#(#xdd),*] = #solved.rates([#(#acceleration_sides),*]);
        }
    }
}

/// Unknowns that are iterated
fn iterated(solution: &Solution) -> TokenStream {
    let blocks = solution.parts.iter().filter_map(|part| match part {
        Part::Block(block) => Some(&block.system.unknowns),
        Part::Explicit { .. } => None,
    });
    let unknowns = blocks.flatten().map(|unknown| Literal::usize_unsuffixed(*unknown));
    quote!(const ITERATED: &'static [usize] = &[#(#unknowns),*];)
}
