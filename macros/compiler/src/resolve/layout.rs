//! Gathers the composition of the mechanism and its components.

use super::elaborate::Elaborator;
use super::{Component, Field, Layout, Name, Of, Part};
use crate::diag::ArrayFact;
use crate::names::{EntityId, Key, OpenPart, Register, Sort};
use crate::syntax::ast::{self, Docs};
use proc_macro2::Ident;
use std::collections::BTreeMap;

/// Elements of one name while they are gathered.
struct Gathered {
    first: EntityId,
    of: Of,
    members: BTreeMap<Vec<usize>, usize>,
}

impl Elaborator<'_> {
    /// The layout of everything that was registered.
    pub(super) fn layout(&mut self, register: &Register) -> Layout {
        let mut layout = Layout::default();
        let mut known: BTreeMap<Option<ast::ItemId>, usize> = BTreeMap::new();
        let mut component_of = Vec::new();
        for place in &register.places {
            let key = place.component.as_ref().map(ast::Shared::id);
            let next = known.len();
            component_of.push(*known.entry(key).or_insert(next));
        }
        for (place, component) in register.places.iter().zip(&component_of) {
            let gathered = self.gathered(place, &component_of);
            let sizes: Vec<Vec<usize>> = gathered.iter().map(|field| self.sizes(field)).collect();
            let members: Vec<Vec<usize>> = gathered.iter().map(|field| field.members.values().copied().collect()).collect();
            let part = Part { component: *component, first: place.first, members };
            let fields = || gathered.iter().zip(&sizes).map(|(field, sizes)| self.field_of(register, field, sizes)).collect();
            match layout.components.get(*component) {
                None => {
                    let name = place.component.as_ref().map(|component| component.head.name.clone());
                    let docs = place.component.as_ref().map_or(Docs::default(), |component| component.docs.clone());
                    layout.components.push(Component { name, docs, fields: fields() });
                }
                Some(alike) => {
                    if let Some(first) = layout.parts.iter().find(|part| part.component == *component) {
                        self.are_alike(place, (alike, first), (&gathered, &sizes, &part));
                    }
                }
            }
            layout.parts.push(part);
        }
        self.add_inputs(register, &mut layout);
        layout
    }

    /// Adds the struct of inputs, a field of the mechanism.
    fn add_inputs(&mut self, register: &Register, layout: &mut Layout) {
        let Some((first, _)) = register.inputs.first() else { return };
        let span = self.names.declared[first.0].name.word.span();
        let items = register.inputs.iter().map(|(id, number)| (Of::Input, *id, *number)).collect();
        let gathered = self.gathered(&OpenPart { items, ..OpenPart::default() }, &[]);
        let sizes: Vec<Vec<usize>> = gathered.iter().map(|field| self.sizes(field)).collect();
        let members = gathered.iter().map(|field| field.members.values().copied().collect()).collect();
        let fields = gathered.iter().zip(&sizes).map(|(field, sizes)| self.field_of(register, field, sizes)).collect();
        let name = Ident::new("Inputs", span);
        if let Some(component) = self.names.components.get(&name.to_string()).cloned() {
            self.refuse::<()>(&component.head.name, ArrayFact::GeneratedType { name: name.to_string() });
        }
        let field = Ident::new(Name::INPUTS, span);
        let taken = layout.components[0].fields.iter().find(|other| other.of != Of::Output && other.name == field);
        if let Some(taken) = taken.map(|other| other.name.clone()) {
            self.refuse::<()>(&taken, ArrayFact::FieldOfInputs { name: taken.to_string() });
        }
        let component = layout.components.len();
        layout.components.push(Component { name: Some(name), docs: Docs::default(), fields });
        layout.components[0].fields.push(Field { name: field, docs: Docs::default(), of: Of::Part(component), sizes: Vec::new() });
        let part = layout.parts.len();
        layout.parts[0].members.push(vec![part]);
        layout.parts.push(Part { component, first: 0, members });
    }

    /// The elements of each name, in the order in which the names were first declared.
    fn gathered(&self, place: &OpenPart, component_of: &[usize]) -> Vec<Gathered> {
        let mut gathered: Vec<Gathered> = Vec::new();
        let mut by_word: BTreeMap<(bool, String), usize> = BTreeMap::new();
        for (of, id, number) in &place.items {
            let name = &self.names.declared[id.0].name;
            let of = if let Of::Part(_) = of { Of::Part(component_of[*number]) } else { *of };
            let next = gathered.len();
            let at = *by_word.entry((of == Of::Output, name.word.to_string())).or_insert(next);
            if at == next {
                gathered.push(Gathered { first: *id, of, members: BTreeMap::new() });
            }
            gathered[at].members.entry(name.indices.clone()).or_insert(*number);
        }
        gathered
    }

    /// Size for each index. Reports gaps, which generated arrays cannot have.
    fn sizes(&mut self, field: &Gathered) -> Vec<usize> {
        let ranks = field.members.keys().next().map_or(0, Vec::len);
        let size = |rank: usize| field.members.keys().filter_map(|indices| indices.get(rank)).max().map_or(0, |most| most + 1);
        let sizes: Vec<usize> = (0..ranks).map(size).collect();
        let mut wanted = vec![0; ranks];
        for indices in field.members.keys() {
            if *indices != wanted {
                let (first, group) =
                    (field.first, |indices: &[usize]| indices.iter().map(|index| format!("[{index}]")).collect::<String>());
                let declared = &self.names.declared[first.0].name;
                let stem = declared.path.trim_end_matches(&group(&declared.indices)).to_owned();
                let (missing, known) = (format!("{stem}{}", group(&wanted)), format!("{stem}{}", group(indices)));
                let sort = match field.of {
                    Of::Parameter => Sort::Parameter,
                    Of::Input => Sort::Input,
                    Of::Body => Sort::Body,
                    Of::Part(_) => Sort::Part,
                    Of::Output => Sort::Output,
                };
                let (range, is_alone) = (declared.word.clone(), field.members.len() == 1);
                self.unless_refused(Key::Array(first.0), |this| {
                    this.refuse::<()>(&range, ArrayFact::MissingIndex { what: sort.noun(), missing, known, is_alone })
                });
                break;
            }
            // The next element of an array without gaps.
            for rank in (0..ranks).rev() {
                wanted[rank] += 1;
                if wanted[rank] < sizes[rank] {
                    break;
                }
                wanted[rank] = 0;
            }
        }
        sizes
    }

    fn field_of(&self, register: &Register, field: &Gathered, sizes: &[usize]) -> Field {
        let number = field.members.values().next().copied().unwrap_or(0);
        let docs = match field.of {
            Of::Parameter | Of::Input => &register.parameters[number].1.docs,
            Of::Body => &register.bodies[number].1.docs,
            Of::Output => &register.outputs[number].1.docs,
            Of::Part(_) => &register.parts[number - 1].docs,
        };
        Field { name: self.names.declared[field.first.0].name.word.clone(), docs: docs.clone(), of: field.of, sizes: sizes.to_vec() }
    }

    /// Checks that a part has the same fields as the first part of its component.
    fn are_alike(&mut self, place: &OpenPart, first: (&Component, &Part), found: (&[Gathered], &[Vec<usize>], &Part)) {
        let ((component, one), (gathered, sizes, two)) = (first, found);
        let bodies = |part: &Part, number: usize| part.members[number].iter().map(|body| body - part.first).collect::<Vec<_>>();
        let is_alike = component.fields.len() == gathered.len()
            && component.fields.iter().zip(gathered).zip(sizes).enumerate().all(|(number, ((field, other), sizes))| {
                field.name == self.names.declared[other.first.0].name.word
                    && field.of == other.of
                    && field.sizes == *sizes
                    && (field.of != Of::Body || bodies(one, number) == bodies(two, number))
            });
        let (Some(id), Some(component)) = (place.id, &place.component) else { return };
        if !is_alike {
            let name = self.names.declared[id.0].name.clone();
            let fact = ArrayFact::UnlikeParts { name: name.path.clone(), component: component.head.name.to_string() };
            self.unless_refused(component, |this| this.refuse::<()>(&name, fact));
        }
    }
}
