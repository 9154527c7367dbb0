//! From a plan to tokens. Cannot fail and decides nothing.
//!
//! The type itself comes last: its page has a picture, which would stand in the way of the code. The user's identifiers keep their spans, so that
//! an editor finds its way back; locals are hygienic, and all else, even `f64`, has its whole path: a user may have a type of that name.

pub(crate) mod arrays;
mod block;
mod columns;
mod dynamics;
mod elimination;
mod expression;
mod functions;
pub(crate) mod inputs;
mod kernels;
mod listing;
pub(crate) mod literal;
mod loads;
mod named_loads;
pub(crate) mod outputs;
pub(crate) mod parameters;
pub(crate) mod points;
mod prepared;
mod rolled;
mod routine;
pub(crate) mod scene;
pub(crate) mod serial;
pub(crate) mod slices;
mod stages;
pub(crate) mod state;
mod validate;

use crate::assembly::Assembly;
use crate::diag::Warning;
use crate::docs;
use crate::model::{Function, Model};
use crate::picture::Picture;
use crate::plan::{Cost, Plan, Solution, Summary};
use crate::syntax::ast::{Closing, Docs};
use crate::system::System;
use crate::travel::Motion;
use functions::Emitter;
use literal::{number, real, signed, vector_type};
use parameters::{Parameters, over};
use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};
use state::Accessors;

/// A name of the user as an identifier; words of Rust are raw.
pub(crate) fn identifier(name: &str) -> Ident {
    match name.strip_prefix("r#") {
        Some(raw) => Ident::new_raw(raw, Span::call_site()),
        None if syn::parse_str::<Ident>(name).is_err() || name == "gen" => Ident::new_raw(name, Span::call_site()),
        None => Ident::new(name, Span::call_site()),
    }
}

/// The functions of the mechanism, its traits, its state and its slices, and last the struct with its page.
pub(crate) fn emit(model: &Model, system: &System, assembly: &Assembly, motion: &Motion, plan: &Plan, picture: &Picture) -> TokenStream {
    let emitter = Emitter { model, system, plan };
    let structure = structure(model, &docs::mechanism(model, system, assembly, motion, plan, picture));
    let (default, with_defaults, family) = defaults(model, system);
    let components = Parameters::new(&model.layout, &model.name).components(model, system);
    let (constants, tables) = (constants(model, system, plan), tables(model));
    let equations = [emitter.phi(), emitter.jacobian(), emitter.linearize(), emitter.nu(), emitter.gamma()];
    let (start, length, validate) = (start(assembly, plan), emitter.characteristic_length(), emitter.validate());
    let (outputs, traits, stages) = (emitter.outputs(), emitter.traits(), emitter.stages());
    let solve =
        (model.task.is_solved()).then(|| if model.holds_inputs() { inputs::solve(model, system) } else { solve(model, system, plan) });
    let (solve_for, slices) = emitter.slices();
    // Where defaults only hold a place nothing is said of them.
    let warns = model.closing == Closing::Deny && !model.allows_far_start;
    // What is wrong with a start or a motion may follow from a number without its unit.
    let is_sure = model.doubts.is_empty();
    let of_motion = assembly.warnings.iter().filter(|_| warns).chain(&motion.warning).filter(|_| is_sure);
    let warnings = of_motion.chain(&motion.flaws).chain(&model.doubts).map(Warning::to_tokens);
    let state = (model.task.is_determined() || !model.outputs.is_empty()).then(|| state(model, system));
    let (drawable, listing, points, dynamics) = (emitter.drawable(), emitter.listing(), emitter.points(), emitter.dynamics());
    let (name, allowed, loads) = (&model.name, allowed_at_places(), emitter.loads());
    let code = quote! {
        #default
        #allowed
        impl<T: ::reuleaux::Real> #name<T> {
            #with_defaults
            #constants
            #tables
            #(#equations)*
            #start
            #length
            #validate
            #outputs
            #solve_for
        }
        #solve
        #family
        #traits
        #stages
        #state
        #loads
        #dynamics
        #slices
        #drawable
        #listing
        #points
        #components
        #structure
        #(#warnings)*
    };
    let declaration = model.requests.serde.as_ref().map(|_| declaration(name, &code));
    quote!(#code #declaration)
}

/// A hash of the generated code (Fowler, Noll and Vo): a state that another declaration solved for counts as unsolved.
fn declaration(name: &Ident, code: &TokenStream) -> TokenStream {
    let hash =
        code.to_string().bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    let hash = Literal::u64_unsuffixed(hash);
    quote! {
        impl<T> #name<T> {
            const __DECLARATION: ::core::primitive::u64 = #hash;
        }
    }
}

/// Lints that do not apply to generated code.
pub(super) fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case, unused)])
}

/// A function at the place of a word of the declaration, where the link to its source leads on its page: an item reaches from its first token to
/// its last one. So rustc takes its `pub` for the user's: see [`allowed_at_places`].
pub(super) fn placed(at: Span, function: TokenStream) -> TokenStream {
    let mut tokens: Vec<TokenTree> = function.into_iter().collect();
    for end in [0, tokens.len().saturating_sub(1)] {
        if let Some(token) = tokens.get_mut(end) {
            token.set_span(at);
        }
    }
    tokens.into_iter().collect()
}

/// The same for blocks with functions at [places](placed) of the declaration: the mechanism may be private.
pub(super) fn allowed_at_places() -> TokenStream {
    let allowed = allowed();
    quote!(#allowed #[allow(unreachable_pub)])
}

fn structure(model: &Model, page: &str) -> TokenStream {
    let Model { docs, visibility, name, .. } = model;
    let (docs, passed, word) = (&docs.tokens, &docs.passed, model.requests.serde.as_ref());
    let (serial, skipped) = (serial::derived(word, Some(name)), serial::skipped(word));
    let parameters = Parameters::new(&model.layout, name);
    let (fields, capitals) = (parameters.documented(model, 0), parameters.capitals(0));
    let marker = model.parameters.is_empty().then(|| quote!(#[doc(hidden)] #skipped pub _real: ::core::marker::PhantomData<T>));
    quote! {
        #docs
        #[doc = ""]
        #[doc = #page]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #serial
        #capitals
        #passed
        #visibility struct #name<T = ::core::primitive::f64> { #fields #marker }
    }
}

/// The user's documentation, followed by the generated description of the item.
fn docs_or(docs: &Docs, known: &str) -> TokenStream {
    let (tokens, known) = (&docs.tokens, docs::line(known));
    if docs.text.is_empty() { known } else { quote!(#tokens #[doc = ""] #known) }
}

/// `Default`, which is for `f64` only, so that `Name::default()` needs no type annotation; `with_defaults`; and `Family`.
fn defaults(model: &Model, system: &System) -> (TokenStream, TokenStream, TokenStream) {
    let name = &model.name;
    let parameters = Parameters::new(&model.layout, name);
    let fields = parameters.defaults(&docs::default_values(model, system));
    let marker = model.parameters.is_empty().then(|| quote!(_real: ::core::marker::PhantomData));
    let gathered = parameters.gathered(0);
    let later = model.holds_inputs().then(|| format_ident!("later")).into_iter();
    // Without parameters there is nothing to combine.
    let unused = model.parameters.is_empty().then(|| quote!(#[allow(unused_variables)]));
    let default = quote! {
        impl ::core::default::Default for #name<::core::primitive::f64> {
            fn default() -> Self { Self::with_defaults() }
        }
    };
    let with_defaults = quote! {
        /// The parameters at their declared defaults, over any number type.
        #[must_use]
        pub fn with_defaults() -> Self { Self { #fields #marker } }
    };
    let over = over(name);
    let family = quote! {
        #unused
        impl<T: ::reuleaux::Real> ::reuleaux::Family<T> for #name<T> {
            type Over<#over: ::reuleaux::Real> = #name<#over>;
            fn gather<#over: ::reuleaux::Real, const LANES: ::core::primitive::usize>(each: [&Self; LANES], combine: impl ::core::ops::Fn([T; LANES]) -> #over) -> #name<#over> {
                #name { #gathered #marker }
            }
            #(const HAS_INPUTS: ::core::primitive::bool = true; fn #later(self, h: T) -> Self { ::reuleaux::later(self, h) })*
        }
    };
    (default, with_defaults, family)
}

fn constants(model: &Model, system: &System, plan: &Plan) -> TokenStream {
    let solution = plan.solution.as_ref().map(|solution| {
        let constant = plan_constant(model, system, solution);
        quote! {
            /// How a state is found: which coordinates are computed, which are iterated together, in which order.
            pub #constant
        }
    });
    let q = system.declared.as_ref().map_or(system.coordinates.len(), |declared| declared.coordinates);
    let [coordinates, equations, entries] = [q, system.constraints().len(), plan.pattern.len()].map(number);
    let speeds = system.declared.as_ref().map(|declared| {
        let speeds = number(declared.speeds);
        quote! {
            /// The number of speeds: v and ω of each body, in ground.
            pub const SPEEDS: ::core::primitive::usize = #speeds;
        }
    });
    let matrix = if system.declared.is_some() { "Φ_u" } else { "Φ_q" };
    let count = docs::line(&format!("The number of entries of {matrix} that are not identically zero."));
    let pairs = plan.pattern.iter().map(|(row, column)| {
        let (row, column) = (number(*row), number(*column));
        quote!((#row, #column))
    });
    quote! {
        /// N, the number of coordinates.
        pub const COORDINATES: ::core::primitive::usize = #coordinates;
        /// M, the number of equations.
        pub const EQUATIONS: ::core::primitive::usize = #equations;
        #speeds
        #count
        pub const JACOBIAN_ENTRIES: ::core::primitive::usize = #entries;
        /// Row and column of each entry that `jacobian_entries` gives, row by row.
        pub const JACOBIAN_PATTERN: [(::core::primitive::usize, ::core::primitive::usize); #entries] = [#(#pairs),*];
        #solution
    }
}

/// The plan as data, for tests and tools.
fn plan_constant(model: &Model, system: &System, solution: &Solution) -> TokenStream {
    let operations = |cost: Cost| {
        let [flops, divisions, sines, calls] = [cost.flops, cost.divisions, cost.sines, cost.calls].map(number);
        quote!(::reuleaux::Operations::new(#flops, #divisions, #sines, #calls))
    };
    let stage = |stage: &Summary| match stage {
        Summary::Explicit { unknown, .. } => {
            let name = docs::coordinate_name(model, system, *unknown);
            quote!(::reuleaux::PlanStage::Computed(#name))
        }
        Summary::Check(equation) => {
            let name = docs::equation_name(model, system, *equation);
            quote!(::reuleaux::PlanStage::Checked(#name))
        }
        Summary::Block { unknowns, equations, cost, elimination, shape, .. } => {
            let unknowns = unknowns.iter().map(|unknown| docs::coordinate_name(model, system, *unknown));
            let equations = equations.iter().map(|equation| docs::equation_name(model, system, *equation));
            let elimination = match elimination {
                Some(elimination) => {
                    let operations = operations(elimination.cost);
                    quote!(::core::option::Option::Some(#operations))
                }
                None => quote!(::core::option::Option::None),
            };
            let (operations, shape) = (operations(*cost), number(*shape));
            quote! {
                ::reuleaux::PlanStage::Iterated {
                    unknowns: &[#(#unknowns),*],
                    equations: &[#(#equations),*],
                    operations: #operations,
                    elimination: #elimination,
                    shape: #shape,
                }
            }
        }
    };
    let stages = solution.stages.iter().filter(|stage| !docs::is_orientation(system, stage)).map(stage);
    let operations = operations(solution.cost);
    quote!(const PLAN: ::reuleaux::Plan = ::reuleaux::Plan { stages: &[#(#stages),*], operations: #operations };)
}

fn tables(model: &Model) -> TokenStream {
    let table = |(number, function): (usize, &Function)| {
        let Function::Table(table) = function else { return quote!() };
        let name = expression::local(&format!("TABLE_{number}"));
        let list = |values: &[f64]| {
            let values = values.iter().map(|value| signed(*value));
            quote!([#(#values),*])
        };
        let knots = list(&table.knots);
        let coefficients = table.coefficients.iter().map(|row| list(row));
        let ends = Ident::new(&format!("{:?}", table.ends), Span::call_site());
        let [count, intervals] = [table.knots.len(), table.coefficients.len()].map(Literal::usize_unsuffixed);
        quote! {
            const #name: ::reuleaux::Table = {
                const KNOTS: [::core::primitive::f64; #count] = #knots;
                const COEFFICIENTS: [[::core::primitive::f64; 4]; #intervals] = [#(#coefficients),*];
                ::reuleaux::Table {
                    knots: &KNOTS,
                    coefficients: &COEFFICIENTS,
                    ends: ::reuleaux::Ends::#ends,
                    single: ::reuleaux::Single {
                        knots: &::reuleaux::Single::knots(&KNOTS),
                        coefficients: &::reuleaux::Single::coefficients(&COEFFICIENTS),
                        period: ::reuleaux::Single::period(&KNOTS),
                    },
                }
            };
        }
    };
    model.functions.iter().enumerate().map(table).collect()
}

fn start(assembly: &Assembly, plan: &Plan) -> TokenStream {
    let values: Vec<TokenStream> = assembly.start.iter().chain(&plan.orientations).map(|value| real(*value)).collect();
    let vector = vector_type(values.len());
    quote! {
        /// The assembled configuration at the declared defaults and t = 0, in SI, from which `solve` sets out.
        #[must_use]
        pub fn start(&self) -> #vector {
            ::core::convert::From::from([#(#values),*])
        }
    }
}

/// The name of the generated state.
fn state_name(mechanism: &Ident) -> Ident {
    format_ident!("{}State", mechanism, span = Span::call_site())
}

/// The module of the generated state. Its names come out of it by a glob, to which any other item of the same name is preferred: there may
/// be mechanisms `Crank` and `CrankState`.
fn state_module(mechanism: &Ident) -> Ident {
    format_ident!("state_of_{}", mechanism, span = Span::call_site())
}

/// The generated state, whatever else has its name.
fn state_path(mechanism: &Ident) -> TokenStream {
    let (module, state) = (state_module(mechanism), state_name(mechanism));
    quote!(#module::#state)
}

/// The functions that solve a mechanism.
fn solve(model: &Model, system: &System, plan: &Plan) -> TokenStream {
    let (name, state, n) = (&model.name, state_path(&model.name), system.width());
    let (vector, n) = (vector_type(n), number(n));
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    // A sweep prepares the numbers that depend on parameters only.
    let prepared = if prepared::fixed_names(plan).is_empty() { quote!(*self) } else { quote!(self.prepared()) };
    let allowed = allowed();
    quote! {
        #allowed
        impl<T: ::reuleaux::Float> #name<T> {
            /// The state at time `t` (s): assembled from the declared start at t = 0 and followed from there, so that the
            /// assembly is kept.
            ///
            /// # Errors
            /// Why there is no such state, with the last valid one on the way.
            pub fn solve(&self, t: T) -> #result {
                ::reuleaux::Mechanism::<T, #n>::solve(self, t).map(#state)
            }
            /// The state at time `t` (s) that Newton's method finds from a guess of q.
            ///
            /// # Errors
            /// Why there is no such state.
            pub fn solve_near(&self, t: T, guess: &#vector) -> #result {
                ::reuleaux::Mechanism::<T, #n>::solve_near(self, t, guess).map(#state)
            }
            /// The state at time `t` (s), followed from another state.
            ///
            /// # Errors
            /// Why there is no such state, with the last valid one on the way.
            pub fn solve_from(&self, t: T, from: &#state<T>) -> #result {
                ::reuleaux::Mechanism::<T, #n>::solve_from(self, t, from).map(#state)
            }
            /// Takes a state to time `t` (s) in place: [`solve_from`](Self::solve_from) without a copy. A state that
            /// cannot be taken there stays as it is.
            ///
            /// # Errors
            /// Why there is no such state, with the last valid one on the way.
            #[inline]
            pub fn advance(&self, state: &mut #state<T>, t: T) -> ::core::result::Result<(), ::reuleaux::Failure<T, #n>> {
                ::reuleaux::Mechanism::<T, #n>::advance(self, &mut state.0, t)
            }
            /// The states at these times (s), each followed from the one before; ends after a failure.
            pub fn sweep<I: ::reuleaux::Times<T>>(
                &self,
                times: I,
            ) -> impl ::core::iter::Iterator<Item = #result> + use<'_, T, I> {
                ::core::iter::Iterator::map(::reuleaux::sweep(#prepared, times), |result| result.map(#state))
            }
        }
    }
}

fn state(model: &Model, system: &System) -> TokenStream {
    let (name, visibility, n) = (&model.name, &model.visibility, system.width());
    let (module, own_name, state) = (state_module(name), state_name(name), state_path(name));
    let first_line = docs::line(&format!("A state of [`{name}`](super::{name}): time, position, velocity and acceleration of every body."));
    let accessors = Accessors::new(&model.layout, &model.name, visibility, None)
        .in_space((!system.frames.is_empty()).then_some(system.coordinates.len()));
    let (own, views) = (accessors.of_mechanism(), accessors.views(n));
    let n = number(n);
    let failure_name = (model.task.is_solved()).then(|| format_ident!("{}Failure", name, span = Span::call_site()));
    let failure = failure_name.as_ref().map(|failure_name| {
        let page = docs::line(&format!("Why there is no state of [`{name}`](super::{name})."));
        quote!(#page #[allow(dead_code)] pub type #failure_name<T = ::core::primitive::f64> = ::reuleaux::Failure<T, #n>;)
    });
    // The names of a stub come by a glob, too, and have to give way.
    let inputs_name = model.holds_inputs().then(|| inputs::type_name(name));
    let others = failure_name.iter().chain(&inputs_name);
    let names = if model.has_stub { quote!({ #own_name #(, #others)* }) } else { quote!(*) };
    let (allowed, serial) = (allowed_at_places(), serial::derived(model.requests.serde.as_ref(), None));
    let inputs = model.holds_inputs().then(|| {
        let (kind, page) = (inputs::type_name(name), docs::line("The inputs that it was solved for."));
        quote!(, #page pub #kind<T>)
    });
    let of_inputs = model.holds_inputs().then(|| Parameters::new(&model.layout, name).inputs(model));
    quote! {
        #[allow(non_snake_case)]
        mod #module {
            #of_inputs
            #first_line
            #[derive(Clone, Debug, PartialEq)]
            #serial
            pub struct #own_name<T = ::core::primitive::f64>(pub ::reuleaux::State<T, #n> #inputs);
            #failure
        }
        #[allow(unused_imports, unreachable_pub)]
        #visibility use #module::#names;
        #allowed
        impl<T: ::reuleaux::Real> #state<T> { #own }
        impl<T> ::core::ops::Deref for #state<T> {
            type Target = ::reuleaux::State<T, #n>;
            fn deref(&self) -> &Self::Target { &self.0 }
        }
        #views
    }
}
