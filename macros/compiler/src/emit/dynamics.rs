//! The generated equations of motion, and the functions that integrate them.

use super::expression::local;
use super::functions::Emitter;
use super::literal::{number, vector_type};
use super::loads::{are_steady, parts};
use super::routine::{RoutinePrinter, fast_lines};
use super::{allowed, docs, state_path};
use crate::plan::{DynamicsCode, Routine};
use crate::quantity::Role;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// The trait of the equations of motion and the methods that use it; nothing if all is driven.
    pub(super) fn dynamics(&self) -> TokenStream {
        let Some(code) = &self.plan.dynamics else { return quote!() };
        let name = &self.model.name;
        let [n, i, m, r] = self.sizes_of(code).map(number);
        let (functions, constants) = (self.functions_of_motion(code), self.constants_of_motion(code));
        let size = (!self.model.parameters.is_empty()).then(|| {
            quote!(
                fn parameter_size(&self, number: ::core::primitive::usize) -> T {
                    ::reuleaux::parameter_size(self, number)
                }
                fn varied(&self, number: ::core::primitive::usize, change: T) -> ::core::option::Option<Self> {
                    ::core::option::Option::Some(::reuleaux::varied(self, number, change))
                }
            )
        });
        let (methods, hash, toward, allowed) = (self.methods_of_motion(), self.parameter_hash(), self.toward(), allowed());
        quote! {
            #allowed
            impl<T: ::reuleaux::Scalar> ::reuleaux::Dynamics<T, #n, #i, #m, #r> for #name<T> {
                #constants
                #functions
                #toward
                #size
                fn parameter_hash(&self) -> ::core::primitive::u64 { #hash }
            }
            #allowed
            impl<T: ::reuleaux::Scalar> #name<T> { #methods }
        }
    }

    fn sizes_of(&self, code: &DynamicsCode) -> [usize; 4] {
        [self.system.width(), code.integrated.len(), code.rows, code.initial_rows.len()]
    }

    fn constants_of_motion(&self, code: &DynamicsCode) -> TokenStream {
        let [_, i, _, r] = self.sizes_of(code).map(number);
        let integrated = code.integrated.iter().map(|unknown| number(*unknown));
        let is_length = |unknown: &usize| matches!(self.system.coordinates[*unknown].role, Role::Position(_) | Role::Displacement);
        let is_length = code.integrated.iter().map(is_length);
        let joints = code.initial_rows.iter().map(|(joint, _)| self.model.joints[*joint].name.to_string());
        let levels = code.initial_rows.iter().map(|(_, [position, speed])| quote!([#position, #speed]));
        let redundant = (code.redundant > 0).then(|| {
            let (count, powers) = (number(code.redundant), code.powers.iter().map(|power| number(usize::from(*power))));
            quote! {
                const REDUNDANT: ::core::primitive::usize = #count;
                const POWERS: [::core::primitive::u8; #r] = [#(#powers),*];
            }
        });
        quote! {
            #redundant
            const INTEGRATED: [::core::primitive::usize; #i] = [#(#integrated),*];
            const IS_LENGTH: [::core::primitive::bool; #i] = [#(#is_length),*];
            const JOINTS: [&'static ::core::primitive::str; #r] = [#(#joints),*];
            const LEVELS: [[::core::primitive::bool; 2]; #r] = [#(#levels),*];
        }
    }

    fn functions_of_motion(&self, code: &DynamicsCode) -> TokenStream {
        let [n, i, m, r] = self.sizes_of(code);
        let [q, qd, qdd, t] = ["q", "qd", "qdd", "t"].map(local);
        let of_state = vector_type(n);
        let (constraints, initial) = (self.kinematics(code, &code.constraints, m), self.kinematics(code, &code.initial, r));
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, &code.balance);
        let (jacobian, rest) = results.split_at(code.entries);
        let (gamma, rest) = rest.split_at(m);
        let (mass, forces) = rest.split_at(code.masses.len());
        let found = local("found");
        let (jacobian, mass) = (entered("jacobian", &code.pattern, jacobian), entered("mass", &code.masses, mass));
        let [number_m, number_i, number_r] = [m, i, r].map(number);
        let accelerations = code.accelerations.as_ref().map(|routine| self.accelerations(code, routine, (n, i)));
        let departures = (!code.departures.results.is_empty()).then(|| self.departures(code, n));
        let checked = (!code.checked_rows.is_empty()).then(|| self.checks(code, n));
        let sides = [self.sides(code, n), self.sides_of_forces(code, n)];
        let state = fast_lines(self.model, &code.arena, &code.state);
        let (reads_of_state, steps_of_state, parts) = (&state.reads, &state.steps, parts(&state.results));
        let energy = self.energies(&code.arena, &code.energies);
        quote! {
            fn constraints(&self, #q: &#of_state, #t: T, #found: &mut ::reuleaux::Constraints<T, #number_m, #number_i>) { #constraints }
            fn initial(&self, #q: &#of_state, #t: T, #found: &mut ::reuleaux::Constraints<T, #number_r, #number_i>) { #initial }
            fn balance(&self, #q: &#of_state, #qd: &#of_state, #t: T, #found: &mut ::reuleaux::Balance<T, #number_m, #number_i>) {
                #reads
                #steps
                #jacobian
                #found.gamma = ::core::convert::From::from([#(#gamma),*]);
                #mass
                #found.forces = ::core::convert::From::from([#(#forces),*]);
            }
            #departures
            #checked
            #(#sides)*
            #accelerations
            #[inline(always)]
            fn complete(&self, #q: &#of_state, #qd: &#of_state, #qdd: &#of_state, #t: T) -> [#of_state; 3] {
                #reads_of_state
                #steps_of_state
                [#(#parts),*]
            }
            fn energy(&self, #q: &#of_state, #qd: &#of_state, #t: T) -> ::reuleaux::Energy<T> { #energy }
        }
    }

    /// By how much a state misses the equations of freedoms.
    fn departures(&self, code: &DynamicsCode, n: usize) -> TokenStream {
        let [q, qd, t] = ["q", "qd", "t"].map(local);
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, &code.departures);
        let (phi, rates) = results.split_at(results.len() / 2);
        let (of_state, of_rows, first) = (vector_type(n), vector_type(code.initial_rows.len()), code.rows);
        let written = [phi, rates].into_iter().enumerate().flat_map(|(level, results)| {
            results.iter().enumerate().map(move |(row, result)| {
                let [level, row] = [level, first + row].map(number);
                quote!(found[#level][#row] = #result;)
            })
        });
        quote! {
            fn departures(&self, #q: &#of_state, #qd: &#of_state, #t: T) -> [#of_rows; 2] {
                #reads
                #steps
                let mut found = [::reuleaux::zeros(), ::reuleaux::zeros()];
                #(#written)*
                found
            }
        }
    }

    /// u̇ in closed form, unless a pivot is too small.
    fn accelerations(&self, code: &DynamicsCode, routine: &Routine, (n, i): (usize, usize)) -> TokenStream {
        let [q, qd, t] = ["q", "qd", "t"].map(local);
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, routine);
        let (values, checks) = results.split_at(i);
        let (of_state, of_speeds, are_steady) = (vector_type(n), vector_type(i), are_steady(checks));
        quote! {
            #[inline(always)]
            fn accelerations(&self, #q: &#of_state, #qd: &#of_state, #t: T) -> ::core::option::Option<#of_speeds> {
                #reads
                #steps
                if !(#are_steady) {
                    return ::core::option::Option::None;
                }
                ::core::option::Option::Some(::core::convert::From::from([#(#values),*]))
            }
        }
    }

    /// On which side of every kink of the equations between positions a place is.
    fn sides(&self, code: &DynamicsCode, n: usize) -> Option<TokenStream> {
        let ([q, t], of_state) = (["q", "t"].map(local), vector_type(n));
        let sides = self.sides_of(code, &code.kinks)?;
        Some(quote! {
            const HAS_KINKS: ::core::primitive::bool = true;
            fn sides(&self, #q: &#of_state, #t: T) -> ::core::primitive::u64 { #sides }
        })
    }

    /// On which side of every kink of the forces a state is.
    fn sides_of_forces(&self, code: &DynamicsCode, n: usize) -> Option<TokenStream> {
        let ([q, qd, t], of_state) = (["q", "qd", "t"].map(local), vector_type(n));
        let sides = self.sides_of(code, &code.kinks_of_forces)?;
        Some(quote! {
            const FORCES_HAVE_KINKS: ::core::primitive::bool = true;
            fn sides_of_forces(&self, #q: &#of_state, #qd: &#of_state, #t: T) -> ::core::primitive::u64 { #sides }
        })
    }

    /// One bit for each kink; `None` if there are none.
    fn sides_of(&self, code: &DynamicsCode, kinks: &Routine) -> Option<TokenStream> {
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, kinks);
        let bits = results.iter().enumerate().map(|(number, kink)| {
            let place = Literal::usize_unsuffixed(number % 64);
            quote!(^ (<::core::primitive::u64 as ::core::convert::From<::core::primitive::bool>>::from(#kink < T::ZERO) << #place))
        });
        (!results.is_empty()).then(|| quote!(#reads #steps 0 #(#bits)*))
    }

    /// The checked equation that is off most.
    fn checks(&self, code: &DynamicsCode, n: usize) -> TokenStream {
        let [q, t] = ["q", "t"].map(local);
        let of_state = vector_type(n);
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, &code.checked);
        let rows = code.checked_rows.iter().zip(&results).map(|((joint, power), phi)| {
            let (name, power) = (self.model.joints[*joint].name.to_string(), number(usize::from(*power)));
            quote!((#name, #phi, #power))
        });
        quote! {
            fn misfit(&self, #q: &#of_state, #t: T) -> ::core::option::Option<(&'static ::core::primitive::str, T)> {
                #reads
                #steps
                ::reuleaux::motion::misfit(self, &[#(#rows),*])
            }
        }
    }

    /// Φ, ν and J of `m` rows.
    fn kinematics(&self, code: &DynamicsCode, routine: &Routine, m: usize) -> TokenStream {
        let RoutinePrinter { reads, steps, results } = fast_lines(self.model, &code.arena, routine);
        let (phi, rest) = results.split_at(m);
        let (nu, entries) = rest.split_at(m);
        let (found, jacobian) = (local("found"), entered("jacobian", &code.pattern, entries));
        quote! {
            #reads
            #steps
            #found.phi = ::core::convert::From::from([#(#phi),*]);
            #jacobian
            #found.nu = ::core::convert::From::from([#(#nu),*]);
        }
    }

    /// Initial state, steps and energies.
    fn methods_of_motion(&self) -> TokenStream {
        let state = state_path(&self.model.name);
        let list: Vec<String> =
            self.model.joints.iter().filter(|joint| joint.freedom.is_some()).map(|joint| format!("`{}`", joint.name)).collect();
        let page = match list.as_slice() {
            [] => docs::line("The state at t = 0: coordinates that no equation of positions determines have their declared start."),
            list => docs::line(&format!("The state at t = 0 with the initial values declared for the freedoms: {}.", list.join(", "))),
        };
        let (sweeps, failure) = (self.sweeps_of_motion(), quote!(::reuleaux::Stopped<T>));
        quote! {
            #page
            ///
            /// # Errors
            /// Why there is none.
            pub fn initial_state(&self) -> ::core::result::Result<#state<T>, #failure> {
                ::reuleaux::motion::initial_state(self).map(#state)
            }
            /// Makes the accelerations of a state those of its positions and speeds. If these were changed, or if parameters were, the freedoms
            /// keep their values and rates, and all others follow from them first.
            ///
            /// # Errors
            /// Why there are none.
            pub fn accelerate(&self, state: &mut #state<T>) -> ::core::result::Result<(), #failure> {
                ::reuleaux::motion::accelerate(self, &mut state.0)
            }
            /// Takes a state to time `t` (s), by steps whose error is within the tolerance of the integrator.
            ///
            /// # Errors
            /// Why the motion stops; the state is the last one reached.
            pub fn advance(
                &self,
                state: &mut #state<T>,
                t: T,
                integrator: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
            ) -> ::core::result::Result<(), #failure> {
                integrator.advance_while(self, &mut state.0, t, |_| true).map(|_| ())
            }
            /// Takes a state to time `t` (s) as long as `goes_on` says so of the state after each step: to report progress, or to stop. True
            /// if the time is reached.
            ///
            /// # Errors
            /// Why the motion stops; the state is the last one reached.
            pub fn advance_while(
                &self,
                state: &mut #state<T>,
                t: T,
                integrator: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
                mut goes_on: impl ::core::ops::FnMut(&#state<T>) -> ::core::primitive::bool,
            ) -> ::core::result::Result<::core::primitive::bool, #failure> {
                integrator.advance_while(self, &mut state.0, t, |state| goes_on(&#state(::core::clone::Clone::clone(state))))
            }
            #sweeps
            /// Takes a state over one step of `h` (s), without an estimate of its error: for controllers.
            ///
            /// # Errors
            /// Why there is no state after it; the state stays as it is.
            pub fn step(&self, state: &mut #state<T>, h: T) -> ::core::result::Result<(), #failure> {
                ::reuleaux::motion::fixed_step(self, &mut state.0, h)
            }
            /// Kinetic energy, potential energy of gravity, of each `energy` and of forces with a `potential`, and the power of what no potential has.
            #[must_use]
            pub fn energy(&self, state: &#state<T>) -> ::reuleaux::Energy<T> {
                ::reuleaux::Dynamics::energy(self, &state.q, &state.qd, state.t)
            }
        }
    }

    /// States at many times and at events, and why there is none at an instant.
    fn sweeps_of_motion(&self) -> TokenStream {
        let (state, failure) = (state_path(&self.model.name), quote!(::reuleaux::Stopped<T>));
        quote! {
            /// Never callable: it is there for the message.
            #[doc(hidden)]
            pub fn solve(&self, _t: T) -> ::core::result::Result<#state<T>, #failure>
            where
                Self: ::reuleaux::Driven,
            {
                self.initial_state()
            }
            /// Takes a state to the first instant before `t` (s) at which `event` changes its sign, or to `t`. True if there is such an
            /// instant; an event where the state begins does not count, nor the one at which the same integrator stopped.
            ///
            /// # Errors
            /// Why the motion stops; the state is the last one reached.
            pub fn advance_until(
                &self,
                state: &mut #state<T>,
                t: T,
                integrator: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
                event: impl ::core::ops::Fn(&#state<T>) -> T,
            ) -> ::core::result::Result<::core::primitive::bool, #failure> {
                integrator.advance_until(self, &mut state.0, t, |state| event(&#state(::core::clone::Clone::clone(state))))
            }
            /// States at the times (s) given, from the initial values on: steps are as long as the tolerance allows, and states between
            /// their ends are interpolated and brought back to where the equations hold. After an error there are no more.
            pub fn sweep<'a>(
                &'a self,
                times: impl ::reuleaux::Times<T> + 'a,
                integrator: ::reuleaux::Integrator<T, impl ::reuleaux::Method + 'a>,
            ) -> impl ::core::iter::Iterator<Item = ::core::result::Result<#state<T>, #failure>> + 'a {
                let start = ::reuleaux::motion::initial_state(self);
                let times = ::core::iter::IntoIterator::into_iter(times);
                ::core::iter::Iterator::map(::reuleaux::MotionSweep::new(self, start, times, integrator), |state| state.map(#state))
            }
            /// The same from a state on.
            pub fn sweep_from<'a>(
                &'a self,
                state: &#state<T>,
                times: impl ::reuleaux::Times<T> + 'a,
                integrator: ::reuleaux::Integrator<T, impl ::reuleaux::Method + 'a>,
            ) -> impl ::core::iter::Iterator<Item = ::core::result::Result<#state<T>, #failure>> + 'a {
                let start = ::core::result::Result::Ok(::core::clone::Clone::clone(&state.0));
                let times = ::core::iter::IntoIterator::into_iter(times);
                ::core::iter::Iterator::map(::reuleaux::MotionSweep::new(self, start, times, integrator), |state| state.map(#state))
            }
        }
    }
}

/// Writes these entries into a matrix.
fn entered(matrix: &str, places: &[(usize, usize)], entries: &[TokenStream]) -> TokenStream {
    let (found, matrix) = (local("found"), format_ident!("{matrix}"));
    let writes = places.iter().zip(entries).map(|((row, column), value)| {
        let (row, column) = (number(*row), number(*column));
        quote!(#found.#matrix[(#row, #column)] = #value;)
    });
    quote!(#(#writes)*)
}
