//! The generated methods of outputs.

use super::arrays::{array_at, array_from, array_of, array_type};
use super::columns::Columns;
use super::expression::local;
use super::functions::Emitter;
use super::literal::number;
use super::routine::{RoutinePrinter, lines_of_state, lines_of_state_at};
use super::slices::plain;
use super::state::body_view;
use super::{docs, docs_or, placed, state_path};
use crate::model::{Method, Output};
use crate::plan::{OutputCode, Outputs, Routine, Shape, Words};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

impl Emitter<'_> {
    /// Outputs with value, rate and acceleration
    pub(super) fn outputs(&self) -> TokenStream {
        let mut slices = 0..;
        let mut number = |method: &Method| if method.is_slice && self.model.task.is_solved() { slices.next() } else { None };
        let all = self.model.methods.iter().zip(&self.plan.outputs);
        all.map(|(method, outputs)| self.method(method, outputs, number(method))).collect()
    }

    /// In space: where the orientations begin in a state.
    fn orientations(&self) -> Option<usize> {
        (!self.system.frames.is_empty()).then_some(self.system.coordinates.len())
    }

    /// The method of an output; `slice` is the number of its slice, if it has one.
    fn method(&self, method: &Method, outputs: &Outputs, slice: Option<usize>) -> TokenStream {
        let Some(first) = method.members.first().map(|member| &self.model.outputs[*member]) else { return quote!() };
        let kind = self.output_type(first);
        let body = match outputs {
            Outputs::Bodies(bodies) => {
                let places: Vec<usize> = bodies.iter().map(|body| self.model.ambient.first_coordinate(*body)).collect();
                array_at(&places, &method.sizes, |place| body_view(&quote!(state), &place, self.orientations()))
            }
            Outputs::Each(outputs) => self.each(method, outputs),
            Outputs::Alike(alike) => self.alike(method, &alike.0, &alike.1),
        };
        let known = docs::output(method, first);
        let is_plain = !method.is_slice && self.model.task.is_solved();
        let known = if is_plain { format!("{known} A `slice output` could be solved for alone.") } else { known };
        let (docs, name, state) = (docs_or(&method.docs, &known), &method.name, state_path(&self.model.name));
        let alone = (self.model.task.is_solved()).then(|| alone(method));
        let kind = array_type(kind, &method.sizes);
        if let Some(slice) = slice {
            let (in_whole, slice) = (in_whole(slice), number(slice));
            let function = quote! {
                pub fn #name<S: ::reuleaux::HasOutput<Self, #slice, Value = #kind>>(&self, state: &S) -> #kind {
                    ::reuleaux::HasOutput::output_of(state, self)
                }
            };
            let function = placed(name.span(), function);
            return quote! {
                #docs
                #alone
                #[must_use]
                #function
                #[doc(hidden)]
                fn #in_whole(&self, state: &#state<T>) -> #kind { #body }
            };
        }
        let function = placed(name.span(), quote!(pub fn #name(&self, state: &#state<T>) -> #kind { #body }));
        quote!(#docs #alone #[must_use] #function)
    }

    /// What the method of an output returns.
    pub(super) fn output_type(&self, output: &Output) -> TokenStream {
        let value = match output.components.len() {
            0 if !self.system.frames.is_empty() => return quote!(::reuleaux::SpatialBody<T>),
            0 => return quote!(::reuleaux::PlanarBody<T>),
            3 => quote!(::reuleaux::nalgebra::Vector3<T>),
            1 => quote!(T),
            _ => quote!(::reuleaux::nalgebra::Vector2<T>),
        };
        motion_type(&value, output.derivatives)
    }

    /// Output by output, the third derivatives of the blocks upstream, if they are asked for, and straight lines.
    fn each(&self, method: &Method, outputs: &[OutputCode]) -> TokenStream {
        let (vectors, derivatives) = (vectors(), self.derivatives(method));
        let lines = |routine: &Routine| lines_of_state(self.model, &self.plan.arena, routine);
        let system = |(names, routine): &(Vec<String>, Routine)| {
            let RoutinePrinter { reads, steps, results } = lines(routine);
            let (entries, sides) = results.split_at(results.len() - names.len());
            let rows = entries.chunks(names.len()).map(|row| quote!([#(#row),*]));
            let names = names.iter().map(|name| local(name));
            quote!(let [#(#names),*] = { #reads #steps ::reuleaux::third_derivatives(state.condition, [#(#rows),*], [#(#sides),*]) };)
        };
        let one = |output: &OutputCode| {
            let systems: TokenStream = output.systems.iter().map(system).collect();
            let RoutinePrinter { reads, steps, results } = lines(&output.lines);
            let motion = motion(&results, derivatives);
            quote!(#systems #reads #steps #motion)
        };
        match outputs {
            [only] if method.sizes.is_empty() => {
                let lines = one(only);
                quote!(#vectors #lines)
            }
            _ => {
                let elements = outputs.iter().map(one).map(|lines| quote!({ #lines }));
                let array = array_from(elements.collect(), &method.sizes);
                quote!(#vectors #array)
            }
        }
    }

    /// Number of derivatives of the outputs of a method.
    fn derivatives(&self, method: &Method) -> usize {
        method.members.first().map_or(2, |member| self.model.outputs[*member].derivatives)
    }

    /// The same lines for all of them.
    fn alike(&self, method: &Method, shape: &Shape, routine: &Routine) -> TokenStream {
        let mut columns = Columns::new(shape.count);
        let places: Vec<TokenStream> = shape.unknowns.iter().map(|column| columns.place(column)).collect();
        let RoutinePrinter { reads, steps, results } =
            lines_of_state_at(self.model, &shape.arena, routine, |unknown| places[unknown].clone());
        let inputs = columns.inputs(shape, &Words::new(self.model, self.system));
        let (vectors, tables, motion) = (vectors(), columns.tables(), motion(&results, self.derivatives(method)));
        let array = array_of(quote!({ #tables #inputs #reads #steps #motion }), &method.sizes);
        quote!(#vectors #array)
    }
}

/// The function of a sliced output in a state of the whole mechanism.
pub(super) fn in_whole(slice: usize) -> Ident {
    format_ident!("__slice_{slice}_in_whole", span = Span::call_site())
}

/// How an output is solved for alone. Where it cannot be, whoever tries is led here: rustc offers a method whose alias was called.
fn alone(method: &Method) -> TokenStream {
    let word = plain(&method.name);
    let solve_for = format!("solve_for_{word}");
    if method.is_slice {
        return docs::line(&format!(
            "[`{solve_for}`](Self::{solve_for}) solves for it alone; its states have it, as those of the whole mechanism do."
        ));
    }
    quote!(#[doc(alias = #solve_for)])
}

/// Variables that the lines read.
fn vectors() -> TokenStream {
    let (q, qd, qdd, t) = (local("q"), local("qd"), local("qdd"), local("t"));
    quote!(let (#q, #qd, #qdd, #t) = (&state.q, &state.qd, &state.qdd, state.t);)
}

/// The type of a quantity with its derivatives by time.
pub(crate) fn motion_type(value: &TokenStream, derivatives: usize) -> TokenStream {
    match derivatives {
        1 => quote!(::reuleaux::ValueAndRate<#value>),
        3 => quote!(::reuleaux::MotionWithJerk<#value>),
        _ => quote!(::reuleaux::Motion<#value>),
    }
}

/// Value and derivatives of one component or several.
fn motion(results: &[TokenStream], derivatives: usize) -> TokenStream {
    let part = |order: usize| -> TokenStream {
        let parts: Vec<&TokenStream> = results.iter().skip(order).step_by(1 + derivatives).collect();
        match parts.as_slice() {
            [scalar] => quote!(#scalar),
            [_, _, _] => quote!(::reuleaux::nalgebra::Vector3::new(#(#parts),*)),
            _ => quote!(::reuleaux::nalgebra::Vector2::new(#(#parts),*)),
        }
    };
    let (value, rate) = (part(0), part(1));
    if derivatives == 1 {
        return quote!(::reuleaux::ValueAndRate { value: #value, rate: #rate });
    }
    let acceleration = part(2);
    if derivatives == 3 {
        let jerk = part(3);
        return quote!(::reuleaux::MotionWithJerk { value: #value, rate: #rate, acceleration: #acceleration, jerk: #jerk });
    }
    quote!(::reuleaux::Motion { value: #value, rate: #rate, acceleration: #acceleration })
}
