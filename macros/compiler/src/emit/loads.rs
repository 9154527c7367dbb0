//! The generated loads: multipliers, and the force and torque of every joint and drive.

use super::expression::local;
use super::functions::Emitter;
use super::literal::{matrix_type, number, vector_type};
use super::routine::{RoutinePrinter, fast_lines};
use super::{allowed_at_places, docs, state_path};
use crate::expr::Arena;
use crate::plan::{LoadsCode, Routine};
use crate::syntax::ast::Task;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The method `loads` and its type; nothing without masses and forces.
    pub(super) fn loads(&self) -> TokenStream {
        let Some(code) = &self.plan.loads else { return quote!() };
        let (name, visibility, state) = (&self.model.name, &self.model.visibility, state_path(&self.model.name));
        let loads = format_ident!("{}Loads", name, span = Span::call_site());
        let closed = code.closed.as_ref().map(|routine| self.closed_form("loads_in_closed_form", (&code.arena, routine), code, 0));
        let dynamics = self.plan.dynamics.as_ref();
        let both = dynamics.and_then(|found| Some((&found.arena, found.with_loads.as_ref()?)));
        let both = both.map(|both| self.closed_form("accelerations_with_loads", both, code, self.system.width()));
        let (general, methods) = (self.loads_in_general(code), self.methods_of_loads(code));
        let alone: TokenStream = code.named.iter().filter(|load| load.is_slice).map(|load| self.load_alone(load, code)).collect();
        let (m, width, allowed) = (number(code.multipliers), number(code.width), allowed_at_places());
        let first = closed.is_some().then(|| {
            quote! {
                if let ::core::option::Option::Some((_, multipliers, actions)) = self.loads_in_closed_form(state) {
                    return #loads { loads: ::reuleaux::Loads::unique(multipliers, actions) };
                }
            }
        });
        let refreshed = self.refreshed(&quote!(#loads { loads: ::reuleaux::Loads::unknown() }));
        let with_motion = dynamics.map(|_| accelerate_with_loads(&state, &loads, both.is_some()));
        let energy = self.plan.dynamics.is_none().then(|| self.energy(code));
        let page = docs::line(&format!("Loads of [`{name}`]: multipliers, and what every joint and drive does to its bodies."));
        quote! {
            #allowed
            impl<T: ::reuleaux::Scalar> #name<T> {
                #closed
                #both
                #general
                /// The loads in a state: Φ_uᵀ λ = Q − M u̇, solved for the multipliers λ.
                ///
                /// Joints act on their bodies with −Φ_uᵀ λ. Multipliers that redundant joints leave open are those of least norm.
                #[must_use]
                pub fn loads(&self, state: &#state<T>) -> #loads<T> {
                    #refreshed
                    #first
                    #loads { loads: self.loads_in_general(state) }
                }
                #with_motion
                #energy
                #alone
            }
            #page
            #[derive(Clone, Debug, PartialEq)]
            #[allow(dead_code)]
            #visibility struct #loads<T = ::core::primitive::f64> {
                loads: ::reuleaux::Loads<T, #m, #width>,
            }
            #allowed
            impl<T: ::reuleaux::Scalar> #loads<T> { #methods }
            impl<T> ::core::ops::Deref for #loads<T> {
                type Target = ::reuleaux::Loads<T, #m, #width>;
                fn deref(&self) -> &Self::Target { &self.loads }
            }
        }
    }

    /// Where freedoms are integrated, a state whose accelerations are those of its parameters; `unknown` is returned where there is none.
    pub(super) fn refreshed(&self, unknown: &TokenStream) -> Option<TokenStream> {
        self.plan.dynamics.as_ref().map(|_| {
            quote! {
                // Accelerations that belong to other parameters, or to other values of the state, do not count.
                let refreshed;
                let state = if ::reuleaux::Dynamics::is_current(self, state) {
                    state
                } else {
                    let mut fresh = ::core::clone::Clone::clone(state);
                    if self.accelerate(&mut fresh).is_err() {
                        return #unknown;
                    }
                    refreshed = fresh;
                    &refreshed
                };
            }
        })
    }

    /// Loads by elimination of Φ_u, and those of joints and drives for given multipliers. The matrices are not in the frame of the closed form.
    fn loads_in_general(&self, code: &LoadsCode) -> TokenStream {
        let (m, u, state) = (code.multipliers, code.equations.results.len() - code.pattern.len(), state_path(&self.model.name));
        let (of_matrix, of_forces, of_lambda, of_actions) = (matrix_type(m, u), vector_type(u), vector_type(m), vector_type(code.width));
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, &code.equations);
        let (entries, forces) = results.split_at(code.pattern.len());
        let writes = code.pattern.iter().zip(entries).map(|((row, speed), value)| {
            let (row, speed) = (number(*row), number(*speed));
            quote!(jacobian[(#row, #speed)] = #value;)
        });
        let RoutinePrinter { reads: reads_of_actions, steps: steps_of_actions, results: values } =
            fast_lines(self.model, &code.arena, &code.actions);
        let data: Vec<Ident> = (0..m).map(|number| local(&format!("d{number}"))).collect();
        let (motion, count, width, is_driven) = (motion(), number(m), number(code.width), self.model.task != Task::Motion);
        quote! {
            #[inline(never)]
            fn loads_in_general(&self, state: &#state<T>) -> ::reuleaux::Loads<T, #count, #width> {
                #motion
                #reads
                #steps
                let mut jacobian: #of_matrix = ::reuleaux::zeros();
                #(#writes)*
                let forces: #of_forces = ::core::convert::From::from([#(#forces),*]);
                ::reuleaux::Loads::of(&mut jacobian, &forces, #is_driven, |multipliers| self.actions(state, multipliers))
            }
            fn actions(&self, state: &#state<T>, multipliers: &#of_lambda) -> #of_actions {
                #motion
                let [#(#data),*] = multipliers.data.0[0];
                #reads_of_actions
                #steps_of_actions
                ::core::convert::From::from([#(#values),*])
            }
        }
    }

    /// Energies of a driven mechanism.
    fn energy(&self, code: &LoadsCode) -> TokenStream {
        let (energies, state, motion) = (self.energies(&code.arena, &code.energies), state_path(&self.model.name), motion());
        quote! {
            /// Kinetic energy, potential energy of gravity, of each `energy` and of forces with a `potential`, and the power of what no potential has.
            #[must_use]
            pub fn energy(&self, state: &#state<T>) -> ::reuleaux::Energy<T> {
                #motion
                #energies
            }
        }
    }

    /// Computes kinetic energy, potential energy and power.
    pub(super) fn energies(&self, arena: &Arena, routine: &Routine) -> TokenStream {
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, arena, routine);
        quote!(#reads #steps { let [kinetic, potential, power] = [#(#results),*]; ::reuleaux::Energy { kinetic, potential, power } })
    }

    /// The accelerations of `entries` entries of the state, λ, and the loads of joints and drives; `None` if a pivot is too small.
    fn closed_form(&self, name: &str, (arena, routine): (&Arena, &Routine), code: &LoadsCode, entries: usize) -> TokenStream {
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, arena, routine);
        let (name, state) = (local(name), state_path(&self.model.name));
        let (accelerations, rest) = results.split_at(entries);
        let (multipliers, rest) = rest.split_at(code.multipliers);
        let (actions, checks) = rest.split_at(code.width);
        let (are_steady, motion) = (are_steady(checks), motion());
        let (of_state, of_lambda, of_actions) = (vector_type(entries), vector_type(code.multipliers), vector_type(code.width));
        quote! {
            #[inline(always)]
            fn #name(&self, state: &#state<T>) -> ::core::option::Option<(#of_state, #of_lambda, #of_actions)> {
                #motion
                #reads
                #steps
                if !(#are_steady) {
                    return ::core::option::Option::None;
                }
                let accelerations = ::core::convert::From::from([#(#accelerations),*]);
                let multipliers = ::core::convert::From::from([#(#multipliers),*]);
                let actions = ::core::convert::From::from([#(#actions),*]);
                ::core::option::Option::Some((accelerations, multipliers, actions))
            }
        }
    }
}

/// Each checked number exceeds its lower bound.
pub(super) fn are_steady(checks: &[TokenStream]) -> TokenStream {
    let (sizes, bounds) = (checks.iter().step_by(2), checks.iter().skip(1).step_by(2));
    quote!(true #(& (#sizes > #bounds))*)
}

/// Vectors of values, rates and accelerations, which follow each other.
pub(super) fn parts(results: &[TokenStream]) -> [TokenStream; 3] {
    [0, 1, 2].map(|part| {
        let values = results.iter().skip(part).step_by(3);
        quote!(::core::convert::From::from([#(#values),*]))
    })
}

/// Accelerations and loads of a state in one method; `are_together` if one routine has both.
fn accelerate_with_loads(state: &TokenStream, loads: &Ident, are_together: bool) -> TokenStream {
    let together = are_together.then(|| {
        quote! {
            if !::reuleaux::Dynamics::is_current(self, state) {
                ::reuleaux::motion::settle(self, &mut state.0)?;
            }
            if let ::core::option::Option::Some((accelerations, multipliers, actions)) = self.accelerations_with_loads(state) {
                ::reuleaux::motion::enter(self, &mut state.0, accelerations)?;
                return ::core::result::Result::Ok(#loads { loads: ::reuleaux::Loads::unique(multipliers, actions) });
            }
        }
    });
    quote! {
        /// `accelerate` and `loads` in one call, which computes sines and determinants once: the right-hand side of the equations of motion
        /// with all multipliers.
        ///
        /// # Errors
        /// Why there are no accelerations.
        pub fn accelerate_with_loads(&self, state: &mut #state<T>) -> ::core::result::Result<#loads<T>, ::reuleaux::Stopped<T>> {
            #together
            self.accelerate(state)?;
            ::core::result::Result::Ok(self.loads(state))
        }
    }
}

/// The vectors and the time that routines read.
pub(super) fn motion() -> TokenStream {
    let [q, qd, qdd, t] = ["q", "qd", "qdd", "t"].map(local);
    quote!(let (#q, #qd, #qdd, #t) = (&state.q, &state.qd, &state.qdd, state.t);)
}
