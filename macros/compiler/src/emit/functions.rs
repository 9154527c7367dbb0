//! The generated functions of a mechanism.

use super::docs;
use super::expression::{Printer, local};
use super::literal::{matrix_type, number, real, vector_type};
use super::routine::{RoutinePrinter, lines};
use crate::expr::{Arena, Expr};
use crate::model::Model;
use crate::plan::{Code, Plan, Routine, Target};
use crate::quantity::Role;
use crate::system::{COSINES, System};
use proc_macro2::TokenStream;
use quote::quote;

/// Everything that the functions are made from.
pub(super) struct Emitter<'a> {
    pub(super) model: &'a Model,
    pub(super) system: &'a System,
    pub(super) plan: &'a Plan,
}

impl Emitter<'_> {
    pub(super) fn lines(&self, routine: &Routine) -> RoutinePrinter {
        lines(self.model, &self.plan.arena, routine)
    }

    /// Numbers of equations and of coordinates.
    fn sizes(&self) -> (usize, usize) {
        let coordinates = self.system.declared.as_ref().map_or(self.system.coordinates.len(), |declared| declared.coordinates);
        (self.system.constraints().len(), coordinates)
    }

    /// Number of speeds.
    fn speeds(&self) -> usize {
        self.system.declared.as_ref().map_or(self.system.speeds.len(), |declared| declared.speeds)
    }

    /// The lines of an equation of the declaration.
    fn equation_lines(&self, routine: &Routine) -> RoutinePrinter {
        lines(self.model, self.equation_arena(), routine)
    }

    fn equation_arena(&self) -> &Arena {
        self.plan.declared.as_ref().unwrap_or(&self.plan.arena)
    }

    /// How Φ_q is called: in space it is Φ_u.
    fn jacobian_name(&self) -> (&'static str, &'static str) {
        if self.system.declared.is_some() { ("Φ_u", "u") } else { ("Φ_q", "q̇") }
    }

    /// Φ
    pub(super) fn phi(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let page = docs::routine("Φ(q, t), the left minus the right side of every equation.", &self.plan.phi);
        let (q, t) = (local("q"), local("t"));
        let (body, of_q, of_rows) = (self.vector(&self.plan.phi, m), vector_type(n), vector_type(m));
        quote! {
            #page
            #[must_use]
            pub fn phi(&self, #q: &#of_q, #t: T) -> #of_rows { #body }
        }
    }

    /// Φ_q, by entries and as a matrix
    pub(super) fn jacobian(&self) -> TokenStream {
        let ((m, n), entries) = (self.sizes(), number(self.plan.pattern.len()));
        let (of_q, of_matrix) = (vector_type(n), matrix_type(m, self.speeds()));
        let (matrix, _) = self.jacobian_name();
        let page = docs::routine(&format!("The entries of {matrix}(q, t) in the order of `JACOBIAN_PATTERN`."), &self.plan.jacobian);
        let dense = docs::line(&format!("{matrix}(q, t) as a dense matrix."));
        let (q, t, list) = (local("q"), local("t"), local("entries"));
        let body = match &self.plan.jacobian {
            Code::Straight(routine) => {
                let RoutinePrinter { reads, steps, results } = self.equation_lines(routine);
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
            #page
            #[must_use]
            pub fn jacobian_entries(&self, #q: &#of_q, #t: T) -> [T; #entries] { #body }
            #dense
            #[must_use]
            pub fn jacobian(&self, q: &#of_q, t: T) -> #of_matrix {
                let mut matrix = ::reuleaux::Matrix::from_element(T::of(0.0));
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
        let (of_q, of_rows, of_matrix) = (vector_type(n), vector_type(m), matrix_type(m, self.speeds()));
        let (name, _) = self.jacobian_name();
        let page = docs::routine(&format!("Φ(q, t) and {name}(q, t), which share most of their work."), &self.plan.linearize);
        let (q, t, matrix, phi) = (local("q"), local("t"), local("matrix"), local("phi"));
        // The matrix has its sizes where it is made: were they found at the end, rustc would hold every entry open until then, and for
        // some thousand entries that takes most of the time.
        let body = match &self.plan.linearize {
            Code::Straight(routine) => {
                let RoutinePrinter { reads, steps, results } = self.equation_lines(routine);
                let (rows, writes) = self.linearized(results);
                quote! {
                    #reads
                    #steps
                    let mut #matrix: #of_matrix = ::reuleaux::Matrix::from_element(T::of(0.0));
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
                    let mut #phi: #of_rows = ::reuleaux::Vector::from_element(T::of(0.0));
                    let mut #matrix: #of_matrix = ::reuleaux::Matrix::from_element(T::of(0.0));
                    #groups
                    (#phi, #matrix)
                }
            }
        };
        quote! {
            #page
            #[must_use]
            pub fn linearize(&self, #q: &#of_q, #t: T) -> (#of_rows, #of_matrix) { #body }
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
        let (matrix, speeds) = self.jacobian_name();
        let page = docs::routine(&format!("ν(q, t) = −Φ_t, the right side of {matrix} {speeds} = ν."), &self.plan.nu);
        let (q, t) = (local("q"), local("t"));
        let (body, of_q, of_rows) = (self.vector(&self.plan.nu, m), vector_type(n), vector_type(m));
        quote! {
            #page
            #[must_use]
            pub fn nu(&self, #q: &#of_q, #t: T) -> #of_rows { #body }
        }
    }

    /// γ
    pub(super) fn gamma(&self) -> TokenStream {
        let (m, n) = self.sizes();
        let text = match self.system.declared {
            None => "γ(q, q̇, t), the right side of Φ_q q̈ = γ: minus the second derivative of s ↦ Φ(q + s q̇, t + s) at s = 0.",
            Some(_) => "γ(q, u, t), the right side of Φ_u u̇ = γ: minus the second derivative of Φ along the motion with constant v and ω.",
        };
        let page = docs::routine(text, &self.plan.gamma);
        let (q, qd, t) = (local("q"), local("qd"), local("t"));
        let (body, of_q, of_u, of_rows) = (self.vector(&self.plan.gamma, m), vector_type(n), vector_type(self.speeds()), vector_type(m));
        quote! {
            #page
            #[must_use]
            pub fn gamma(&self, #q: &#of_q, #qd: &#of_u, #t: T) -> #of_rows { #body }
        }
    }

    /// A vector of m rows
    pub(super) fn vector(&self, code: &Code, m: usize) -> TokenStream {
        match code {
            Code::Straight(routine) if self.is_sparse(routine) => {
                let (rows, of_rows, RoutinePrinter { reads, steps, results }) =
                    (local("rows"), vector_type(m), self.equation_lines(routine));
                let other = (0..).zip(&routine.results).zip(results).filter(|((_, row), _)| !self.is_zero(**row));
                let writes = other.map(|((row, _), value)| {
                    let row = number(row);
                    quote!(#rows[#row] = #value;)
                });
                if routine.results.iter().all(|row| self.is_zero(*row)) {
                    return quote!(::reuleaux::Vector::from_element(T::of(0.0)));
                }
                quote! {
                    #reads
                    #steps
                    let mut #rows: #of_rows = ::reuleaux::Vector::from_element(T::of(0.0));
                    #(#writes)*
                    #rows
                }
            }
            Code::Straight(routine) => {
                let RoutinePrinter { reads, steps, results } = self.equation_lines(routine);
                quote!(#reads #steps ::core::convert::From::from([#(#results),*]))
            }
            Code::Grouped(groups) => {
                let (rows, of_rows) = (local("rows"), vector_type(m));
                let groups = self.groups(groups, |target, value| match target {
                    Target::Row(row) | Target::Entry(row, _) => quote!(#rows[#row] = #value;),
                });
                quote! {
                    let mut #rows: #of_rows = ::reuleaux::Vector::from_element(T::of(0.0));
                    #groups
                    #rows
                }
            }
        }
    }

    fn is_zero(&self, row: Expr) -> bool {
        self.equation_arena().as_constant(row).is_some_and(|value| value.is_zero())
    }

    /// Most rows are zero.
    fn is_sparse(&self, routine: &Routine) -> bool {
        2 * routine.results.iter().filter(|row| self.is_zero(**row)).count() > routine.results.len()
    }

    /// The length by which others are measured
    pub(super) fn characteristic_length(&self) -> TokenStream {
        let routine = &self.plan.lengths;
        let RoutinePrinter { steps, .. } = self.lines(routine);
        let printer = Printer { arena: &self.plan.arena, names: &routine.names, turn: "sin_cos" };
        // Of the constants only the largest counts.
        let largest = routine.results.iter().filter_map(|length| printer.constant(*length)).map(f64::abs).fold(0.0, f64::max);
        let others = routine.results.iter().filter(|length| printer.constant(**length).is_none()).map(|length| printer.operand(*length));
        let first = real(largest);
        let longest = quote!(#first #(.max(#others.abs()))*);
        let longest = if routine.results.is_empty() {
            real(1.0)
        } else if largest > SMALLEST {
            longest
        } else {
            quote!(let longest = #longest; T::select_less(T::of(0.0), longest, longest, T::of(1.0)))
        };
        let own = "L, the length (m) that is worth a radian when lengths and angles are compared: the largest";
        let of_points = "coordinate of a point in the frame of its body, 1 if there is none.";
        let of_joints = "length that a joint or drive demands, 1 if there is none.";
        let of = if self.system.lengths == self.model.lengths { of_points } else { of_joints };
        let page = docs::lines(&format!("{own}\n{of}"));
        quote! {
            #page
            #[must_use]
            pub fn characteristic_length(&self) -> T { #steps #longest }
        }
    }

    /// The runtime's traits, by the functions above
    pub(super) fn traits(&self) -> TokenStream {
        let rows = match &self.system.declared {
            Some(_) => self.system.equations.iter().filter(|equation| !equation.is_initial).cloned().collect(),
            None => self.system.constraints(),
        };
        let (name, m, n) = (&self.model.name, rows.len(), self.system.width());
        let word = name.to_string();
        let coordinates = (0..self.system.coordinates.len()).map(|index| {
            let (owner, name) = self.system.owner_and_name(self.model, index);
            let owner = owner.to_string();
            match self.system.coordinates[index].role {
                Role::Angle => quote!(::reuleaux::Coordinate::angle(#owner, #name)),
                Role::Position(_) | Role::Displacement => quote!(::reuleaux::Coordinate::length(#owner, #name)),
                Role::Quaternion(_) => quote!(::reuleaux::Coordinate::number(#owner, #name)),
            }
        });
        let orientations = self.model.bodies.iter().take(self.system.frames.len()).flat_map(|body| {
            let body = body.name.to_string();
            (0..COSINES).map(move |k| {
                let name = format!("a{}{}", k / 3 + 1, k % 3 + 1);
                quote!(::reuleaux::Coordinate::number(#body, #name))
            })
        });
        let coordinates = coordinates.chain(orientations);
        let rows = rows.iter().map(|equation| {
            let joint = &self.model.joints[equation.joint];
            let (name, kind, unit) = (joint.name.to_string(), &joint.kind, equation.dim.unit());
            let (index, of) = (number(equation.row + 1), number(joint.residuals.len()));
            quote!(::reuleaux::Row::new(#name, #kind, #index, #of, #unit))
        });
        let (of_q, of_rows, of_matrix) = (vector_type(n), vector_type(m), matrix_type(m, n));
        let (m, n) = (number(m), number(n));
        let equations = self.system.declared.is_none().then(|| {
            quote! {
                impl<T: ::reuleaux::Real> ::reuleaux::Equations<T, #m, #n> for #name<T> {
                    fn phi(&self, q: &#of_q, t: T) -> #of_rows { self.phi(q, t) }
                    fn jacobian(&self, q: &#of_q, t: T) -> #of_matrix { self.jacobian(q, t) }
                    fn linearize(&self, q: &#of_q, t: T) -> (#of_rows, #of_matrix) { self.linearize(q, t) }
                    fn nu(&self, q: &#of_q, t: T) -> #of_rows { self.nu(q, t) }
                    fn gamma(&self, q: &#of_q, qd: &#of_q, t: T) -> #of_rows { self.gamma(q, qd, t) }
                }
            }
        });
        quote! {
            impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
                const NAME: &'static ::core::primitive::str = #word;
                const COORDINATES: &'static [::reuleaux::Coordinate] = &[#(#coordinates),*];
                const ROWS: &'static [::reuleaux::Row] = &[#(#rows),*];
                fn start(&self) -> #of_q { self.start() }
                fn characteristic_length(&self) -> T { self.characteristic_length() }
                fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { self.validate() }
            }
            #equations
        }
    }
}

/// A constant length above this one is above zero in every number type.
const SMALLEST: f64 = 1e-30;
