//! Straight lines of stages as statements.

use super::expression::{Printer, local};
use super::routine::statement;
use super::stages::Index;
use super::{docs, literal};
use crate::expr::{Arena, Expr};
use crate::model::Model;
use crate::plan::{Iterated, Origin, StageCode, Step, StraightLine};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// Straight-line code with the meaning of its numbers.
pub(super) struct BlockPrinter<'a> {
    pub(super) model: &'a Model,
    pub(super) arena: &'a Arena,
    pub(super) lines: &'a StraightLine,
    /// By number of the unknown in these lines.
    pub(super) unknowns: &'a [Index],
    /// By number of the equation in these lines.
    pub(super) equations: &'a [TokenStream],
    /// Unknowns whose sine and cosine are wanted afterwards.
    pub(super) kept: &'a [usize],
    /// Names of unknowns and equations in the declaration; without them statements have no comments.
    pub(super) origins: Option<&'a Origins>,
}

/// Names of unknowns and equations in the declaration.
pub(super) struct Origins {
    /// By unknown, `crank.angle`.
    pub(super) coordinates: Vec<String>,
    /// The joint of each equation, `b (revolute)`.
    pub(super) joints: Vec<String>,
}

impl BlockPrinter<'_> {
    pub(super) fn steps(&self, names: &BTreeMap<Expr, String>, steps: &[Step]) -> TokenStream {
        let printer = Printer { arena: self.arena, names, turn: "fast_sin_cos" };
        steps.iter().map(|step| statement(self.model, &printer, step)).collect()
    }

    /// All parts in order, each under a comment that says which joint it serves.
    pub(super) fn parts(&self) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut before = None;
        for (number, part) in self.lines.parts.iter().enumerate() {
            let joints = self.origins.map(|origins| origins.joints_of(part));
            if joints != before
                && let (Some(origins), Some(joints)) = (self.origins, &joints)
            {
                let alike = self.lines.parts[number..].iter().take_while(|part| origins.joints_of(part) == *joints);
                tokens.extend(origins.comment(joints, alike));
            }
            before = joints;
            tokens.extend(self.part(number, part));
        }
        tokens
    }

    /// The name of a block that was solved, made of those of its bodies.
    pub(super) fn solved(&self, number: usize) -> Ident {
        let stem = self.stem(number);
        let is_taken = |name: &str| {
            let is_known = self.lines.unknowns.iter().flatten().chain(self.lines.names.values()).any(|known| known == name);
            is_known || (0..number).any(|other| self.stem(other).is_some_and(|other| other == name))
        };
        local(&match stem {
            Some(stem) if !is_taken(&stem) => stem,
            _ => format!("block_{number}"),
        })
    }

    /// `block_coupler_rocker`, for a part that is a block.
    fn stem(&self, number: usize) -> Option<String> {
        let Some(StageCode::Block(block)) = self.lines.parts.get(number) else { return None };
        let mut bodies: Vec<&str> = Vec::new();
        for unknown in &block.system.unknowns {
            let body = self.unknowns[*unknown].body.as_str();
            if !bodies.contains(&body) {
                bodies.push(body);
            }
        }
        Some(match bodies.as_slice() {
            [first, .., last] if bodies.len() > MOST_BODIES => format!("block_{first}_to_{last}"),
            _ => format!("block_{}", bodies.join("_")),
        })
    }

    fn part(&self, number: usize, part: &StageCode) -> TokenStream {
        match part {
            StageCode::Block(block) => self.block(number, block),
            StageCode::Check { steps, equation, residual, sizes } => {
                let steps = self.steps(&self.lines.names, steps);
                let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
                let (residual, sizes) = (printer.expression(*residual), sizes.map(|size| printer.expression(size)));
                let (pass, equation) = (local("pass"), &self.equations[*equation]);
                quote!(#steps #pass.check(#equation, #residual, [#(#sizes),*]);)
            }
            StageCode::Explicit { steps, unknown, motion, .. } => {
                let steps = self.steps(&self.lines.names, steps);
                let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
                let names = self.lines.unknowns[*unknown].each_ref().map(|name| local(name));
                let values = motion.map(|expr| printer.expression(expr));
                if motion[1..].iter().all(|expr| printer.constant(*expr).is_some()) {
                    return quote!(#steps let (#(#names),*) = (#(#values),*););
                }
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
        let jerks = self.jerks(number, block);
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
        let LinearSolution { elimination, order, is_in_place, method, jacobian } = self.linear_solution(number, block, &inner);
        let (pass, place, solved, k) = (local("pass"), local("place"), self.solved(number), literal::number(k));
        let factors = local(&format!("factors_{number}"));
        let (declared, passed) = if is_in_place {
            (Some(quote!(let mut #factors = ::core::option::Option::None;)), Some(quote!(&mut #factors,)))
        } else {
            (None, None)
        };
        let is_turned = block.turns.iter().flatten().any(Option::is_some);
        let [inner_pairs, outer_pairs] = [&place, &solved].map(|of| is_turned.then(|| quote!(let [#(#pairs),*] = #of.sin_cos;)));
        quote! {
            #before
            #elimination
            #declared
            let #solved = #pass.#method(
                #order
                #passed
                &::reuleaux::Block { unknowns: [#(#unknowns),*], equations: [#(#equations),*], kinds: [#(#kinds),*], needs_sin_cos: [#(#turns),*] },
                [#(#sizes),*],
                #[inline(always)]
                |#place: &::reuleaux::Iterate<T, #k>| {
                    let [#(#x),*] = #place.x.data.0[0];
                    #inner_pairs
                    #inside
                    ([#(#residuals),*], [#(#jacobian),*])
                },
            )?;
            let [#(#x),*] = #solved.x;
            #outer_pairs
            #rates
            #first
            #accelerations
            #second
            #jerks
        }
    }

    /// The third derivatives of a block, where an output asks for them.
    fn jerks(&self, number: usize, block: &Iterated) -> Option<TokenStream> {
        if block.system.jerks.is_empty() {
            return None;
        }
        let names = block.system.unknowns.iter().map(|unknown| local(&format!("{}_jerk", self.lines.unknowns[*unknown][0])));
        let (steps, third) =
            (self.steps(&self.lines.names, &block.jerks), self.rates(number, &names.collect::<Vec<Ident>>(), &block.system.jerks));
        Some(quote!(#steps #third))
    }
}

/// How the linear system of a block is solved.
struct LinearSolution {
    /// The type that has the order of elimination, if there is one.
    elimination: TokenStream,
    /// That type as an argument.
    order: Option<TokenStream>,
    /// Whether its factors, which are many, have a variable of their own.
    is_in_place: bool,
    /// The method of the solver.
    method: TokenStream,
    /// Its Jacobian: by rows, or the entries that the elimination reads.
    jacobian: Vec<TokenStream>,
}

impl BlockPrinter<'_> {
    /// In closed form, or by the elimination that was chosen.
    fn linear_solution(&self, number: usize, block: &Iterated, inner: &Printer) -> LinearSolution {
        let Some(elimination) = &block.system.elimination else {
            let row = |row: &Vec<Expr>| {
                let entries = row.iter().map(|expr| inner.expression(*expr));
                quote!([#(#entries),*])
            };
            let jacobian = block.system.jacobian.iter().map(row).collect();
            return LinearSolution { elimination: quote!(), order: None, is_in_place: false, method: quote!(small), jacobian };
        };
        let order = local(&format!("Elimination{number}"));
        let has_quaternions = !block.system.quaternions.is_empty();
        let is_length = block.system.unknowns.iter().map(|unknown| self.unknowns[*unknown].is_length).collect();
        let entry = |(i, j): &(usize, usize)| inner.expression(block.system.jacobian[*i][*j]);
        LinearSolution {
            elimination: super::elimination::elimination(&order, is_length, elimination, &block.system.quaternions),
            order: Some(quote!(#order,)),
            is_in_place: has_quaternions,
            method: if has_quaternions { quote!(turning) } else { quote!(sparse) },
            jacobian: elimination.pattern.iter().map(entry).collect(),
        }
    }
}

impl BlockPrinter<'_> {
    /// Rates or accelerations of a block from their right sides; zero where nothing moves it.
    fn rates(&self, number: usize, names: &[Ident], sides: &[Expr]) -> TokenStream {
        let zero = |side: &Expr| self.arena.as_constant(*side).is_some_and(|value| value.is_zero());
        if sides.iter().all(zero) {
            return quote!(#(let #names = T::of(0.0);)*);
        }
        let printer = Printer { arena: self.arena, names: &self.lines.names, turn: "fast_sin_cos" };
        let (solved, sides) = (self.solved(number), sides.iter().map(|side| printer.expression(*side)));
        quote!(let [#(#names),*] = #solved.solve([#(#sides),*]);)
    }
}

/// A block of more bodies is called by the first and the last of them.
const MOST_BODIES: usize = 3;

impl Origins {
    /// The joints that a part serves.
    fn joints_of(&self, part: &StageCode) -> Vec<&str> {
        let equations = match part {
            StageCode::Explicit { origin: Origin::Equation(equation), .. } | StageCode::Check { equation, .. } => {
                std::slice::from_ref(equation)
            }
            StageCode::Explicit { .. } => &[],
            StageCode::Block(block) => &block.system.equations,
        };
        let mut joints: Vec<&str> = equations.iter().filter_map(|equation| self.joints.get(*equation)).map(String::as_str).collect();
        joints.dedup();
        joints
    }

    /// `b (revolute): coupler.angle, rocker.angle`
    fn comment<'p>(&self, joints: &[&str], parts: impl Iterator<Item = &'p StageCode>) -> TokenStream {
        let unknowns = |part: &'p StageCode| match part {
            StageCode::Explicit { unknown, .. } => std::slice::from_ref(unknown),
            StageCode::Block(block) => block.system.unknowns.as_slice(),
            StageCode::Check { .. } => &[],
        };
        let mut found: Vec<String> = parts.flat_map(unknowns).filter_map(|unknown| self.coordinates.get(*unknown)).cloned().collect();
        found.dedup();
        let text = match (joints.join(", "), found.join(", ")) {
            (joints, found) if joints.is_empty() => found,
            (joints, found) if found.is_empty() => format!("{joints}: it must hold"),
            (joints, found) => format!("{joints}: {found}"),
        };
        docs::line(&text)
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
