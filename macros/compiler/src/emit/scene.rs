//! Straight lines of stages as statements.

use super::expression::{Printer, local};
use super::routine::statement;
use super::stages::Index;
use crate::expr::{Arena, Expr};
use crate::model::Model;
use crate::plan::{Iterated, Lines, Part, Step};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// Lines with what their numbers stand for.
pub(super) struct Scene<'a> {
    pub(super) model: &'a Model,
    pub(super) arena: &'a Arena,
    pub(super) lines: &'a Lines,
    /// By number of the unknown in these lines.
    pub(super) unknowns: &'a [Index],
    /// By number of the equation in these lines.
    pub(super) equations: &'a [TokenStream],
    /// Unknowns whose sine and cosine are wanted afterwards.
    pub(super) kept: &'a [usize],
}

impl Scene<'_> {
    pub(super) fn steps(&self, names: &BTreeMap<Expr, String>, steps: &[Step]) -> TokenStream {
        let printer = Printer { arena: self.arena, names, turn: "fast_sin_cos" };
        steps.iter().map(|step| statement(self.model, &printer, step)).collect()
    }

    pub(super) fn part(&self, number: usize, part: &Part) -> TokenStream {
        match part {
            Part::Block(block) => self.block(number, block),
            Part::Check { steps, equation, residual, sizes } => {
                let steps = self.steps(&self.lines.names, steps);
                let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
                let (residual, sizes) = (printer.expression(*residual), sizes.map(|size| printer.expression(size)));
                let (pass, equation) = (local("pass"), &self.equations[*equation]);
                quote!(#steps #pass.check(#equation, #residual, [#(#sizes),*]);)
            }
            Part::Explicit { steps, unknown, motion } => {
                let steps = self.steps(&self.lines.names, steps);
                let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
                let names = self.lines.unknowns[*unknown].each_ref().map(|name| local(name));
                let values = motion.map(|expr| printer.expression(expr));
                quote!(#steps #(let #names = #values;)*)
            }
        }
    }

    fn block(&self, number: usize, block: &Iterated) -> TokenStream {
        let k = block.system.unknowns.len();
        let names = &self.lines.names;
        let (before, rates, accelerations) =
            (self.steps(names, &block.before), self.steps(names, &block.rates), self.steps(names, &block.accelerations));
        let outer = Printer { arena: self.arena, names, turn: "fast_sin_cos" };
        let inner = Printer { arena: self.arena, names: &block.names, turn: "fast_sin_cos" };
        let inside = self.steps(&block.names, &block.inside);
        let list = |printer: &Printer, exprs: &[Expr]| -> Vec<TokenStream> { exprs.iter().map(|expr| printer.expression(*expr)).collect() };
        let residuals = list(&inner, &block.system.residuals);
        let sizes = list(&outer, &block.system.sizes);
        let motion = |order: usize| -> Vec<Ident> {
            block.system.unknowns.iter().map(|unknown| local(&self.lines.unknowns[*unknown][order])).collect()
        };
        let (x, xd, xdd) = (motion(0), motion(1), motion(2));
        let (first, second) = (self.rates(number, &xd, &block.system.rates), self.rates(number, &xdd, &block.system.accelerations));
        let unknowns = block.system.unknowns.iter().map(|unknown| &self.unknowns[*unknown].place);
        let kinds = block.system.unknowns.iter().map(|unknown| &self.unknowns[*unknown].kind);
        let equations = block.system.equations.iter().map(|equation| &self.equations[*equation]);
        let turns = block
            .system
            .unknowns
            .iter()
            .zip(&block.turns)
            .map(|(unknown, names)| names.iter().any(Option::is_some) || self.kept.contains(unknown));
        let pairs: Vec<TokenStream> = block.turns.iter().map(pair).collect();
        let order = local(&format!("Elimination{number}"));
        let (elimination, method, jacobian) = match &block.system.elimination {
            None => {
                let row = |row: &Vec<Expr>| {
                    let entries = list(&inner, row);
                    quote!([#(#entries),*])
                };
                (quote!(), quote!(small), block.system.jacobian.iter().map(row).collect())
            }
            Some(elimination) => {
                let is_length = block.system.unknowns.iter().map(|unknown| self.unknowns[*unknown].is_length).collect();
                let entry = |(i, j): &(usize, usize)| inner.expression(block.system.jacobian[*i][*j]);
                (
                    super::elimination::elimination(&order, is_length, elimination),
                    quote!(sparse),
                    elimination.pattern.iter().map(entry).collect::<Vec<_>>(),
                )
            }
        };
        let order = block.system.elimination.as_ref().map(|_| quote!(#order,));
        let (pass, place, solved) = (local("pass"), local("place"), local(&format!("block_{number}")));
        quote! {
            #before
            #elimination
            let #solved = #pass.#method(
                #order
                &::reuleaux::Block { unknowns: [#(#unknowns),*], equations: [#(#equations),*], kinds: [#(#kinds),*], needs_sin_cos: [#(#turns),*] },
                [#(#sizes),*],
                #[inline(always)]
                |#place: &::reuleaux::Iterate<T, #k>| {
                    let [#(#x),*] = #place.x.data.0[0];
                    let [#(#pairs),*] = #place.sin_cos;
                    #inside
                    ([#(#residuals),*], [#(#jacobian),*])
                },
            )?;
            let [#(#x),*] = #solved.x;
            let [#(#pairs),*] = #solved.sin_cos;
            #rates
            #first
            #accelerations
            #second
        }
    }
}

impl Scene<'_> {
    /// Rates or accelerations of a block from their right sides; zero where nothing moves it.
    fn rates(&self, number: usize, names: &[Ident], sides: &[Expr]) -> TokenStream {
        let zero = |side: &Expr| self.arena.as_constant(*side).is_some_and(|value| value.is_zero());
        if sides.iter().all(zero) {
            return quote!(#(let #names = T::of(0.0);)*);
        }
        let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
        let (solved, sides) = (local(&format!("block_{number}")), sides.iter().map(|side| printer.expression(*side)));
        quote!(let [#(#names),*] = #solved.solve([#(#sides),*]);)
    }
}

/// A pattern for sine and cosine, of which a name may be missing.
pub(super) fn pair(names: &[Option<String>; 2]) -> TokenStream {
    let [sine, cosine] = names.each_ref().map(|name| {
        name.as_ref().map_or(quote!(_), |name| {
            let name = local(name);
            quote!(#name)
        })
    });
    quote!((#sine, #cosine))
}
