//! The generated functions of a mechanism.

use super::docs;
use super::expression::local;
use super::routine::{Lines, lines};
use super::stages::number;
use crate::model::Model;
use crate::plan::{Code, Plan, Routine, Target};
use crate::quantity::Role;
use crate::system::{Coordinate, System};
use proc_macro2::TokenStream;
use quote::quote;

/// Everything that the functions are made from.
pub(super) struct Emitter<'a> {
    pub(super) model: &'a Model,
    pub(super) system: &'a System,
    pub(super) plan: &'a Plan,
}

impl Emitter<'_> {
    pub(super) fn lines(&self, routine: &Routine) -> Lines {
        lines(self.model, &self.plan.arena, routine)
    }

    fn sizes(&self) -> (usize, usize) {
        (self.system.equations.len(), self.system.coordinates.len())
    }

    /// Φ
    pub(super) fn phi(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let page = docs::routine("Φ(q, t), the left minus the right side of every equation.", &self.plan.phi);
        let (q, t) = (local("q"), local("t"));
        let body = self.vector(&self.plan.phi, m);
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn phi(&self, #q: &::reuleaux::nalgebra::SVector<T, #n>, #t: T) -> ::reuleaux::nalgebra::SVector<T, #m> { #body }
        }
    }

    /// Φ_q, by entries and as a matrix
    pub(super) fn jacobian(&self) -> TokenStream {
        let ((m, n), entries) = (self.sizes(), self.plan.pattern.len());
        let page = docs::routine("The entries of Φ_q(q, t) in the order of `JACOBIAN_PATTERN`.", &self.plan.jacobian);
        let (q, t, list) = (local("q"), local("t"), local("entries"));
        let body = match &self.plan.jacobian {
            Code::Straight(routine) => {
                let Lines { reads, steps, results } = self.lines(routine);
                quote!(#reads #steps [#(#results),*])
            }
            Code::Grouped(groups) => {
                let groups = self.groups(groups, |target, value| match target {
                    Target::Row(row) | Target::Entry(row, _) => quote!(#list[#row] = #value;),
                });
                quote!(let mut #list = [T::of(0.0); #entries]; #groups #list)
            }
        };
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn jacobian_entries(&self, #q: &::reuleaux::nalgebra::SVector<T, #n>, #t: T) -> [T; #entries] { #body }
            /// Φ_q(q, t) as a dense matrix.
            #[must_use]
            pub fn jacobian(&self, q: &::reuleaux::nalgebra::SVector<T, #n>, t: T) -> ::reuleaux::nalgebra::SMatrix<T, #m, #n> {
                let mut matrix = ::reuleaux::nalgebra::SMatrix::from_element(T::of(0.0));
                for (place, entry) in ::core::iter::Iterator::zip(Self::JACOBIAN_PATTERN.iter(), self.jacobian_entries(q, t)) {
                    matrix[*place] = entry;
                }
                matrix
            }
        }
    }

    /// Φ and Φ_q together
    pub(super) fn linearize(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let page = docs::routine("Φ(q, t) and Φ_q(q, t), which share most of their work.", &self.plan.linearize);
        let (q, t, matrix, phi) = (local("q"), local("t"), local("matrix"), local("phi"));
        // The matrix has its sizes where it is made: were they found at the end, rustc would hold every entry open until then, and for
        // some thousand entries that takes most of the time.
        let body = match &self.plan.linearize {
            Code::Straight(routine) => {
                let Lines { reads, steps, results } = self.lines(routine);
                let (rows, writes) = self.linearized(results);
                quote! {
                    #reads
                    #steps
                    let mut #matrix = ::reuleaux::nalgebra::SMatrix::<T, #m, #n>::from_element(T::of(0.0));
                    #writes
                    (::core::convert::From::from([#(#rows),*]), #matrix)
                }
            }
            Code::Grouped(groups) => {
                let groups = self.groups(groups, |target, value| match target {
                    Target::Row(row) => quote!(#phi[#row] = #value;),
                    Target::Entry(row, column) => quote!(#matrix[(#row, #column)] = #value;),
                });
                quote! {
                    let mut #phi = ::reuleaux::nalgebra::SVector::<T, #m>::from_element(T::of(0.0));
                    let mut #matrix = ::reuleaux::nalgebra::SMatrix::<T, #m, #n>::from_element(T::of(0.0));
                    #groups
                    (#phi, #matrix)
                }
            }
        };
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn linearize(
                &self,
                #q: &::reuleaux::nalgebra::SVector<T, #n>,
                #t: T,
            ) -> (::reuleaux::nalgebra::SVector<T, #m>, ::reuleaux::nalgebra::SMatrix<T, #m, #n>) { #body }
        }
    }

    /// Residuals, and the entries of the matrix as assignments; they come joint by joint.
    fn linearized(&self, results: Vec<TokenStream>) -> (Vec<TokenStream>, TokenStream) {
        let matrix = local("matrix");
        let (mut rows, mut writes) = (Vec::new(), TokenStream::new());
        for (target, result) in self.plan.linearized.iter().zip(results) {
            match *target {
                Target::Row(_) => rows.push(result),
                Target::Entry(row, column) => {
                    let (row, column) = (number(row as usize), number(column as usize));
                    writes.extend(quote!(#matrix[(#row, #column)] = #result;));
                }
            }
        }
        (rows, writes)
    }

    /// ν
    pub(super) fn nu(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let page = docs::routine("ν(q, t) = −Φ_t, the right side of Φ_q q̇ = ν.", &self.plan.nu);
        let (q, t) = (local("q"), local("t"));
        let body = self.vector(&self.plan.nu, m);
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn nu(&self, #q: &::reuleaux::nalgebra::SVector<T, #n>, #t: T) -> ::reuleaux::nalgebra::SVector<T, #m> { #body }
        }
    }

    /// γ
    pub(super) fn gamma(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let page = docs::routine(
            "γ(q, q̇, t), the right side of Φ_q q̈ = γ: minus the second derivative of s ↦ Φ(q + s q̇, t + s) at s = 0.",
            &self.plan.gamma,
        );
        let (q, qd, t) = (local("q"), local("qd"), local("t"));
        let body = self.vector(&self.plan.gamma, m);
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn gamma(
                &self,
                #q: &::reuleaux::nalgebra::SVector<T, #n>,
                #qd: &::reuleaux::nalgebra::SVector<T, #n>,
                #t: T,
            ) -> ::reuleaux::nalgebra::SVector<T, #m> { #body }
        }
    }

    /// A vector of m rows
    fn vector(&self, code: &Code, m: usize) -> TokenStream {
        match code {
            Code::Straight(routine) => {
                let Lines { reads, steps, results } = self.lines(routine);
                quote!(#reads #steps ::core::convert::From::from([#(#results),*]))
            }
            Code::Grouped(groups) => {
                let rows = local("rows");
                let groups = self.groups(groups, |target, value| match target {
                    Target::Row(row) | Target::Entry(row, _) => quote!(#rows[#row] = #value;),
                });
                quote! {
                    let mut #rows = ::reuleaux::nalgebra::SVector::<T, #m>::from_element(T::of(0.0));
                    #groups
                    #rows
                }
            }
        }
    }

    /// The length by which others are measured
    pub(super) fn characteristic_length(&self) -> TokenStream {
        let Lines { steps, results, .. } = self.lines(&self.plan.lengths);
        let own = "L, the length (m) that is worth a radian when lengths and angles are compared: ";
        let of_points = "the largest\ncoordinate of a point in the frame of its body, 1 if there is none.";
        let of_joints = "the largest\nlength that a joint or drive demands, 1 if there is none.";
        let page = format!("{own}{}", if self.system.lengths == self.model.lengths { of_points } else { of_joints });
        quote! {
            #[doc = #page]
            #[must_use]
            pub fn characteristic_length(&self) -> T {
                #steps
                let longest = T::of(0.0);
                #(let longest = longest.max((#results).abs());)*
                T::select_less(T::of(0.0), longest, longest, T::of(1.0))
            }
        }
    }

    /// The runtime's trait, by the functions above
    pub(super) fn traits(&self) -> TokenStream {
        let (name, (m, n)) = (&self.model.name, self.sizes());
        let word = name.to_string();
        let coordinates = self.system.coordinates.iter().map(|unknown| {
            let (body, name) = (self.model.bodies[unknown.body].name.to_string(), unknown.role.name());
            let kind = kind(unknown);
            quote!(::reuleaux::Coordinate { body: #body, name: #name, kind: #kind })
        });
        let rows = self.system.equations.iter().map(|equation| {
            let joint = &self.model.joints[equation.joint];
            let (name, kind, unit) = (joint.name.to_string(), &joint.kind, equation.dim.unit());
            let (index, of) = (equation.row + 1, joint.residuals.len());
            quote!(::reuleaux::Row { joint: #name, kind: #kind, index: #index, of: #of, unit: #unit })
        });
        quote! {
            #[automatically_derived]
            impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
                const NAME: &'static ::core::primitive::str = #word;
                const COORDINATES: &'static [::reuleaux::Coordinate] = &[#(#coordinates),*];
                const ROWS: &'static [::reuleaux::Row] = &[#(#rows),*];
                fn start(&self) -> ::reuleaux::nalgebra::SVector<T, #n> { self.start() }
                fn characteristic_length(&self) -> T { self.characteristic_length() }
                fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { self.validate() }
            }
            #[automatically_derived]
            impl<T: ::reuleaux::Real> ::reuleaux::Equations<T, #m, #n> for #name<T> {
                fn phi(&self, q: &::reuleaux::nalgebra::SVector<T, #n>, t: T) -> ::reuleaux::nalgebra::SVector<T, #m> { self.phi(q, t) }
                fn jacobian(&self, q: &::reuleaux::nalgebra::SVector<T, #n>, t: T) -> ::reuleaux::nalgebra::SMatrix<T, #m, #n> { self.jacobian(q, t) }
                fn linearize(
                    &self,
                    q: &::reuleaux::nalgebra::SVector<T, #n>,
                    t: T,
                ) -> (::reuleaux::nalgebra::SVector<T, #m>, ::reuleaux::nalgebra::SMatrix<T, #m, #n>) {
                    self.linearize(q, t)
                }
                fn nu(&self, q: &::reuleaux::nalgebra::SVector<T, #n>, t: T) -> ::reuleaux::nalgebra::SVector<T, #m> { self.nu(q, t) }
                fn gamma(
                    &self,
                    q: &::reuleaux::nalgebra::SVector<T, #n>,
                    qd: &::reuleaux::nalgebra::SVector<T, #n>,
                    t: T,
                ) -> ::reuleaux::nalgebra::SVector<T, #m> {
                    self.gamma(q, qd, t)
                }
            }
        }
    }
}

/// What an unknown measures.
fn kind(unknown: &Coordinate) -> TokenStream {
    if unknown.role == Role::Angle { quote!(::reuleaux::CoordinateKind::Angle) } else { quote!(::reuleaux::CoordinateKind::Length) }
}
