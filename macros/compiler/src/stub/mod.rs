//! Code in place of a refused mechanism: the same items without content, so that one mistake gives one error.
//!
//! Names and shapes are read from the tree, as far as they can be; a rejected item has those that it was meant to have.

mod loads;

use crate::diag::{Fact, NameFact};
use crate::emit::arrays::array_type;
use crate::emit::inputs::type_name;
use crate::emit::literal::{matrix_type, number, vector_type};
use crate::emit::outputs::motion_type;
use crate::emit::parameters::{Parameters, over};
use crate::emit::slices::{plain, slice_name};
use crate::emit::state::Accessors;
use crate::emit::{points, scene, serial};
use crate::hints::{OutputKind, derivatives, has_forces, has_inputs, means_space, output_kind};
use crate::model::{Layout, Method};
use crate::quantity::Ambient;
use crate::resolve::{Outline, outline};
use crate::syntax::ast::{Item, Mechanism, Task, Use};
use loads::loads;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use std::collections::BTreeSet;

/// A type with the promised fields and functions, none of which can be run.
pub(crate) fn stub(tree: &Mechanism) -> TokenStream {
    let mut tree = tree.clone();
    if means_space(&tree) {
        tree.ambient = Ambient::Space;
    }
    // `T` is the number type of all functions, but another name of the mechanism outside.
    let alias = (tree.name == "T").then(|| {
        let (visibility, name) = (&tree.visibility, std::mem::replace(&mut tree.name, format_ident!("RefusedT")));
        let [state, loads] = ["State", "Loads"].map(|what| format_ident!("RefusedT{what}"));
        let [own_state, own_loads] = ["State", "Loads"].map(|what| format_ident!("T{what}"));
        let state = tree.task.is_determined().then(|| quote!(#[allow(unused_imports)] #visibility use #state as #own_state;));
        let loads = has_forces(&tree).then(|| quote!(#[allow(unused_imports)] #visibility use #loads as #own_loads;));
        quote!(#[allow(unused_imports)] #visibility use RefusedT as #name; #state #loads)
    });
    let promise = promise(&tree, &tree.visibility, &quote!(loop {}));
    quote!(#promise #alias)
}

/// A stub that gives way to the mechanism itself, once `wanted` is found to be a constraint.
///
/// A name that is imported by `*` is shadowed by an item of that name, so that the mechanism may be
/// declared beside it; where `wanted` does not resolve, the stub stays and rustc says why. Where it
/// is a macro that is no constraint and swallows the mechanism, the stub cannot be built.
pub(crate) fn fallback(tree: &Mechanism, wanted: &Use) -> TokenStream {
    let Mechanism { visibility, name, .. } = tree;
    let module = format_ident!("__reuleaux_{}", name);
    let why = Fact::from(NameFact::NotAConstraint { name: wanted.path.last.to_string() }).message();
    let promise = promise(tree, &quote!(pub), &quote!({ let () = #name::<T>::IS_A_CONSTRAINT; loop {} }));
    // An associated constant is only evaluated for functions that are built, after all other errors.
    let check = quote_spanned!(wanted.path.last.span()=> const IS_A_CONSTRAINT: () = ::core::panic!(#why););
    quote! {
        #[doc(hidden)]
        #[allow(warnings, clippy::all)]
        mod #module { #promise impl<T> #name<T> { #check } }
        #[doc(hidden)]
        #[allow(unused_imports, unreachable_pub)]
        #visibility use #module::*;
    }
}

/// Number of coordinates of all bodies.
fn coordinates(tree: &Mechanism, promised: &Outline) -> usize {
    tree.ambient.first_coordinate(promised.bodies)
}

/// All that a mechanism promises; `body` stands in every function.
fn promise(tree: &Mechanism, visibility: &TokenStream, body: &TokenStream) -> TokenStream {
    let Mechanism { name, .. } = tree;
    let (state, failure) = (format_ident!("{}State", name), format_ident!("{}Failure", name));
    let promised = outline(tree);
    let n = coordinates(tree, &promised);
    let (structure, equations) = (structure(tree, &promised.layout, visibility), equations(name, n, body));
    let accessors = accessors(tree, &promised.layout, visibility, n, body);
    let inputs = has_inputs(tree).then(|| type_name(name));
    let (solutions, stages) = (tree.task.is_solved()).then(|| solutions(name, &state, visibility, n, body)).unzip();
    let solutions = inputs.as_ref().map_or(solutions, |inputs| Some(solutions_with_inputs(&state, inputs, n, body)));
    let inputs = inputs.map(|inputs| quote!(, pub #inputs<T>));
    let has_outputs = !promised.methods.is_empty();
    let (solve_for, slices) = (tree.task.is_solved()).then(|| slices(tree, &promised, visibility, body)).unzip();
    let outputs = outputs(tree, &promised, &state, body);
    let (n, vector, plan) = (number(n), vector_type(n), no_plan());
    let motion = (tree.task == Task::Motion).then(|| motion_from_forces(&state, body));
    let (loads, of_loads) = has_forces(tree).then(|| loads(tree, &promised, visibility, body)).unzip();
    let points = tree.requests.points.as_ref().map(|_| points(tree, visibility, &state, body));
    let listing = tree.requests.outputs.as_ref().map(|_| listing(name, &state, &n, body));
    let state = (tree.task.is_determined() || has_outputs).then(|| {
        let serial = serial::promised(tree.requests.serde.as_ref(), &state, body);
        quote! {
            #serial
            #[derive(Clone, Debug, PartialEq)]
            #[doc(hidden)]
            #visibility struct #state<T = ::core::primitive::f64>(pub ::reuleaux::State<T, #n> #inputs);
            #[doc(hidden)]
            #[allow(dead_code)]
            #visibility type #failure<T = ::core::primitive::f64> = ::reuleaux::Failure<T, #n>;
            impl<T> ::core::ops::Deref for #state<T> {
                type Target = ::reuleaux::State<T, #n>;
                fn deref(&self) -> &Self::Target { &self.0 }
            }
            #accessors
            #listing
            #points
        }
    });
    let drawable = tree.requests.picture.as_ref().map(|word| scene::implementation(word, name, coordinates(tree, &promised), body));
    quote! {
        #structure
        #state
        #drawable
        #stages
        #slices
        #of_loads
        #equations
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #name<T> {
            pub const COORDINATES: ::core::primitive::usize = #n;
            pub const EQUATIONS: ::core::primitive::usize = #n;
            pub const PLAN: ::reuleaux::Plan = #plan;
            pub const JACOBIAN_ENTRIES: ::core::primitive::usize = 0;
            pub const JACOBIAN_PATTERN: [(::core::primitive::usize, ::core::primitive::usize); 0] = [];
            pub fn jacobian_entries(&self, _: &#vector, _: T) -> [T; 0] { #body }
            pub fn with_defaults() -> Self { #body }
            #solutions
            #motion
            #loads
            #outputs
            #solve_for
        }
    }
}

/// The points and axes of bodies that are declared one by one.
fn points(tree: &Mechanism, visibility: &TokenStream, state: &Ident, body: &TokenStream) -> TokenStream {
    let vector = if tree.ambient == Ambient::Space { quote!(Vector3) } else { quote!(Vector2) };
    let frames = tree.items.iter().filter_map(|item| if let Item::Body(frame) | Item::Ground(frame) = item { Some(frame) } else { None });
    let mut names = BTreeSet::new();
    for frame in frames.filter(|frame| frame.indices.is_empty()) {
        let single = frame.marks.single.iter().filter(|mark| mark.indices.is_empty());
        names.extend(single.map(|mark| format!("{}_{}", frame.name, mark.name).replace("r#", "")));
    }
    let names = names.iter().map(|name| Ident::new(name, Span::call_site()));
    let methods = quote!(#(pub fn #names(&self) -> ::reuleaux::Motion<::reuleaux::nalgebra::#vector<T>> { #body })*);
    points::structure(&tree.name, visibility, &quote!(#state), &methods)
}

/// The list of outputs.
fn listing(name: &Ident, state: &Ident, n: &TokenStream, body: &TokenStream) -> TokenStream {
    quote! {
        impl<T: ::reuleaux::Real> ::reuleaux::Outputs<T, #n, 0> for #name<T> {
            type State = #state<T>;
            const OUTPUTS: ::reuleaux::OutputNames<0> = ::reuleaux::OutputNames([]);
            fn outputs_with_jerk(&self, _: &#state<T>) -> [::reuleaux::MotionWithJerk<T>; 0] { #body }
        }
    }
}

/// The structs of parameters and their defaults. `default` is not generic and so built in every library, also where nobody calls
/// it: it calls nothing itself.
fn structure(tree: &Mechanism, layout: &Layout, visibility: &TokenStream) -> TokenStream {
    let (name, parameters) = (&tree.name, Parameters::new(layout, &tree.name));
    let fields = parameters.types(0);
    let marker = fields.is_empty().then(|| quote!(#[doc(hidden)] pub _real: ::core::marker::PhantomData<T>));
    let structure = |name: &Ident, fields: &[(&Ident, TokenStream)], marker: Option<TokenStream>| {
        let fields = fields.iter().map(|(field, kind)| quote!(pub #field: #kind,));
        let serial = serial::promised(tree.requests.serde.as_ref(), name, &quote!(loop {}));
        quote! {
            #serial
            #[derive(Clone, Copy, Debug, PartialEq)]
            #[doc(hidden)]
            #[allow(missing_docs)]
            #visibility struct #name<T = ::core::primitive::f64> { #(#fields)* #marker }
            impl ::core::default::Default for #name<::core::primitive::f64> { fn default() -> Self { loop {} } }
        }
    };
    let components = parameters.structures().map(|(component, name)| structure(&name, &parameters.types(component), None));
    let mechanism = structure(name, &fields, marker);
    let over = over(name);
    let family = quote! {
        impl<T> ::reuleaux::Family<T> for #name<T> {
            type Over<#over: ::reuleaux::Real> = #name<#over>;
            fn gather<#over: ::reuleaux::Real, const LANES: ::core::primitive::usize>(
                _: [&Self; LANES],
                _: impl ::core::ops::Fn([T; LANES]) -> #over,
            ) -> #name<#over> { loop {} }
        }
    };
    quote!(#mechanism #(#components)* #family)
}

fn accessors(tree: &Mechanism, layout: &Layout, visibility: &TokenStream, n: usize, body: &TokenStream) -> TokenStream {
    let state = format_ident!("{}State", tree.name);
    let accessors = Accessors::new(layout, &tree.name, visibility, Some(body)).in_space((tree.ambient == Ambient::Space).then_some(0));
    let (own, views) = (accessors.of_mechanism(), accessors.views(n));
    quote! {
        #[allow(missing_docs, dead_code, unreachable_pub, clippy::all)]
        impl<T: ::reuleaux::Real> #state<T> { #own }
        #views
    }
}

/// The functions of the runtime's traits, with and without them.
fn equations(name: &Ident, n: usize, body: &TokenStream) -> TokenStream {
    let (vector, matrix, n) = (vector_type(n), matrix_type(n, n), number(n));
    let functions = [
        quote!(fn phi(&self, _: &#vector, _: T) -> #vector { #body }),
        quote!(fn jacobian(&self, _: &#vector, _: T) -> #matrix { #body }),
        quote!(fn linearize(&self, _: &#vector, _: T) -> (#vector, #matrix) { #body }),
        quote!(fn nu(&self, _: &#vector, _: T) -> #vector { #body }),
        quote!(fn gamma(&self, _: &#vector, _: &#vector, _: T) -> #vector { #body }),
    ];
    let description = [
        quote!(fn start(&self) -> #vector { #body }),
        quote!(fn characteristic_length(&self) -> T { #body }),
        quote!(fn validate(&self) -> ::core::result::Result<(), ::reuleaux::ParameterOutOfRange<T>> { #body }),
    ];
    quote! {
        #[allow(missing_docs, dead_code, clippy::all)]
        impl<T: ::reuleaux::Real> #name<T> { #(pub #functions)* #(pub #description)* }
        impl<T: ::reuleaux::Real> ::reuleaux::Description<T, #n> for #name<T> {
            const NAME: &'static ::core::primitive::str = "";
            const COORDINATES: &'static [::reuleaux::Coordinate] = &[];
            const ROWS: &'static [::reuleaux::Row] = &[];
            #(#description)*
        }
        impl<T: ::reuleaux::Real> ::reuleaux::Equations<T, #n, #n> for #name<T> { #(#functions)* }
    }
}

/// The functions that solve, and the runtime's traits behind them.
fn solutions(name: &Ident, state: &Ident, visibility: &TokenStream, n: usize, body: &TokenStream) -> (TokenStream, TokenStream) {
    let (vector, n) = (vector_type(n), number(n));
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    let prepared = format_ident!("{}Prepared", name);
    let functions = quote! {
        pub fn solve(&self, _: T) -> #result { #body }
        pub fn solve_near(&self, _: T, _: &#vector) -> #result { #body }
        pub fn solve_from(&self, _: T, _: &#state<T>) -> #result { #body }
        pub fn advance(&self, _: &mut #state<T>, _: T) -> ::core::result::Result<(), ::reuleaux::Failure<T, #n>> { #body }
        pub fn sweep<I: ::reuleaux::Times<T>>(&self, _: I) -> ::core::iter::Empty<#result> { #body }
        pub fn prepared(&self) -> #prepared<T> { #body }
    };
    let traits = quote! {
        #[doc(hidden)]
        #[allow(dead_code)]
        #visibility type #prepared<T = ::core::primitive::f64> = ::reuleaux::Prepared<#name<T>, T, #n, 0>;
        impl<T: ::reuleaux::SolverReal> ::reuleaux::Stages<T, #n> for #name<T> {
            fn stages(
                &self,
                _: T,
                _: &mut ::reuleaux::Solver<'_, T, #n>,
            ) -> ::core::result::Result<::reuleaux::Coordinates<T, #n>, ::reuleaux::StepError<T>> {
                #body
            }
        }
        impl<T: ::reuleaux::SolverReal> ::reuleaux::Prepare<T, #n, 0> for #name<T> {
            type State = #state<T>;
            fn named(_: ::reuleaux::State<T, #n>) -> Self::State { #body }
            fn unnamed(state: &mut Self::State) -> &mut ::reuleaux::State<T, #n> { &mut state.0 }
        }
    };
    (functions, traits)
}

/// The functions that solve a mechanism with inputs.
fn solutions_with_inputs(state: &Ident, inputs: &Ident, n: usize, body: &TokenStream) -> TokenStream {
    let (vector, n) = (vector_type(n), number(n));
    let result = quote!(::core::result::Result<#state<T>, ::reuleaux::Failure<T, #n>>);
    quote! {
        pub fn advance_once(&self, _: &mut #state<T>, _: T, _: #inputs<T>) -> ::core::primitive::bool { #body }
        pub fn with_inputs_of(&self, _: &#state<T>) -> Self { #body }
        pub fn solve(&self, _: T, _: #inputs<T>) -> #result { #body }
        pub fn solve_near(&self, _: T, _: &#vector, _: #inputs<T>) -> #result { #body }
        pub fn solve_from(&self, _: T, _: &#state<T>, _: #inputs<T>) -> #result { #body }
        pub fn advance(
            &self,
            _: &mut #state<T>,
            _: T,
            _: #inputs<T>,
        ) -> ::core::result::Result<(), ::reuleaux::Failure<T, #n>> { #body }
        pub fn sweep<I: ::core::iter::IntoIterator<Item = (T, #inputs<T>)>>(&self, _: I) -> ::core::iter::Empty<#result> { #body }
    }
}

/// Methods of a mechanism with freedoms.
fn motion_from_forces(state: &Ident, body: &TokenStream) -> TokenStream {
    let done = |value: TokenStream| quote!(::core::result::Result<#value, ::reuleaux::Stopped<T>>);
    let (first, nothing, found) = (done(quote!(#state<T>)), done(quote!(())), done(quote!(::core::primitive::bool)));
    quote! {
        pub fn initial_state(&self) -> #first { #body }
        pub fn accelerate(&self, _: &mut #state<T>) -> #nothing { #body }
        pub fn advance(&self, _: &mut #state<T>, _: T, _: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>) -> #nothing { #body }
        pub fn advance_until(
            &self,
            _: &mut #state<T>,
            _: T,
            _: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
            _: impl ::core::ops::Fn(&#state<T>) -> T,
        ) -> #found { #body }
        pub fn advance_while(
            &self,
            _: &mut #state<T>,
            _: T,
            _: &mut ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
            _: impl ::core::ops::FnMut(&#state<T>) -> ::core::primitive::bool,
        ) -> #found { #body }
        pub fn sweep<'a>(
            &'a self,
            _: impl ::reuleaux::Times<T> + 'a,
            _: ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
        ) -> ::core::iter::Empty<#first> { #body }
        pub fn sweep_from<'a>(
            &'a self,
            _: &#state<T>,
            _: impl ::reuleaux::Times<T> + 'a,
            _: ::reuleaux::Integrator<T, impl ::reuleaux::Method>,
        ) -> ::core::iter::Empty<#first> { #body }
        pub fn step(&self, _: &mut #state<T>, _: T) -> #nothing { #body }
        pub fn energy(&self, _: &#state<T>) -> ::reuleaux::Energy<T> { #body }
    }
}

/// The motion of a body.
fn body_type(tree: &Mechanism) -> TokenStream {
    match tree.ambient {
        Ambient::Plane => quote!(::reuleaux::PlanarBody<T>),
        Ambient::Space => quote!(::reuleaux::SpatialBody<T>),
    }
}

/// The type of an output's method, as far as can be guessed.
fn motion(tree: &Mechanism, promised: &Outline, method: &Method) -> TokenStream {
    let output = method.members.first().map(|member| &*promised.outputs[*member]);
    let value_type = match output.map(|output| output_kind(output, tree)) {
        Some(OutputKind::Vector) if tree.ambient == Ambient::Space => quote!(::reuleaux::nalgebra::Vector3<T>),
        Some(OutputKind::Vector) => quote!(::reuleaux::nalgebra::Vector2<T>),
        Some(OutputKind::Body) => return array_type(body_type(tree), &method.sizes),
        _ => quote!(T),
    };
    let derivatives = output.map_or(2, |output| derivatives(output, tree));
    array_type(motion_type(&value_type, derivatives), &method.sizes)
}

/// A plan without stages.
fn no_plan() -> TokenStream {
    quote!(::reuleaux::Plan { stages: &[], operations: ::reuleaux::Operations::new(0, 0, 0, 0) })
}

/// The slices upstream of outputs: the methods and their types.
fn slices(tree: &Mechanism, promised: &Outline, visibility: &TokenStream, body: &TokenStream) -> (TokenStream, TokenStream) {
    let (mechanism, n, plan) = (&tree.name, number(coordinates(tree, promised)), no_plan());
    let slice = |(order, method): (usize, &Method)| {
        let (word, order, value) = (plain(&method.name), number(order), motion(tree, promised, method));
        let [name, state] = ["", "State"].map(|what| slice_name(&format_ident!("{mechanism}{what}"), &promised.methods, &word));
        let solve_for = format_ident!("solve_for_{word}");
        // How many numbers a slice holds is not known; nobody asks.
        let types = quote! {
            #[doc(hidden)]
            #[allow(dead_code, non_camel_case_types)]
            #visibility type #name<T = ::core::primitive::f64> = ::reuleaux::Slice<#mechanism<T>, T, #order, 1, #n>;
            #[doc(hidden)]
            #[allow(dead_code, non_camel_case_types)]
            #visibility type #state<T = ::core::primitive::f64> = ::reuleaux::SliceState<#mechanism<T>, T, #order, 1, #n>;
            impl<T: ::reuleaux::SolverReal> ::reuleaux::Sliced<T, #order, 1, #n> for #mechanism<T> {
                type Value = #value;
                const PLAN: ::reuleaux::Plan = #plan;
                const HELD: [::core::primitive::usize; 1] = [0];
                const OUTPUTS: &'static [::reuleaux::OutputName] = &[];
                const COMPONENTS: &'static [::reuleaux::Coordinate] = &[];
                const COMPUTED_ANGLES: &'static [::core::primitive::usize] = &[];
                const ITERATED: &'static [::core::primitive::usize] = &[];
                const MAY_BE_NON_FINITE: &'static [::core::primitive::usize] = &[];
                fn output(_: &::reuleaux::State<T, 1>) -> #value { #body }
            }
        };
        (quote!(pub fn #solve_for(&self) -> #name<T> { #body }), types)
    };
    promised.methods.iter().filter(|method| method.is_slice).enumerate().map(slice).unzip()
}

fn outputs(tree: &Mechanism, promised: &Outline, state: &Ident, body: &TokenStream) -> TokenStream {
    let method = |method: &Method| {
        let (name, motion) = (&method.name, motion(tree, promised, method));
        if method.is_slice {
            return quote!(pub fn #name<S>(&self, _: &S) -> #motion { #body });
        }
        quote!(pub fn #name(&self, _: &#state<T>) -> #motion { #body })
    };
    promised.methods.iter().map(method).collect()
}
