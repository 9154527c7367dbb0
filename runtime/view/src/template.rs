//! Separation of a motion into constant elements and varying numbers.
//!
//! Marks of one kind in different frames are one element, whose texts are stored once and whose numbers are columns. Each frame refers to
//! a list of its elements in paint order; frames of equal order share their list.

use std::collections::BTreeMap;

use reuleaux_picture::{Film, Mark};

use crate::tokens::{self, Meaning, Skeleton};

/// Properties by which marks of different frames are recognised as one element.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Kind {
    tag: &'static str,
    class: String,
    title: String,
    text: String,
    attributes: Vec<(&'static str, Skeleton)>,
}

/// A mark over all frames.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) tag: &'static str,
    pub(crate) class: String,
    pub(crate) title: String,
    pub(crate) text: String,
    pub(crate) attributes: Vec<Attribute>,
}

/// An attribute over all frames.
#[derive(Clone, Debug)]
pub(crate) struct Attribute {
    pub(crate) name: &'static str,
    pub(crate) skeleton: Skeleton,
    /// For each number its values, one for each frame.
    pub(crate) columns: Vec<Vec<i64>>,
}

/// All frames of a motion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Template {
    pub(crate) elements: Vec<Element>,
    /// Lists of elements from bottom to top.
    pub(crate) orders: Vec<Vec<usize>>,
    /// For each frame the number of its list.
    pub(crate) order: Vec<usize>,
}

/// A template in progress.
#[derive(Default)]
struct Maker {
    template: Template,
    kinds: BTreeMap<Kind, Vec<usize>>,
    orders: BTreeMap<Vec<usize>, usize>,
    /// For each element its latest numbers.
    last: Vec<Vec<i64>>,
    /// Paint order of the frame before.
    before: Vec<usize>,
}

/// Bounding box of a mark: least and largest x and y.
type Area = [[f64; 2]; 2];

impl Template {
    pub(crate) fn of(film: &Film) -> Template {
        let mut maker = Maker::default();
        for frame in 0..film.count() {
            maker.add(film.marks(frame));
        }
        maker.template
    }

    /// An attribute in a frame.
    pub(crate) fn attribute(attribute: &Attribute, frame: usize) -> String {
        let numbers: Vec<i64> = attribute.columns.iter().filter_map(|column| column.get(frame).copied()).collect();
        tokens::join(&attribute.skeleton, &numbers)
    }

    /// The elements of a frame from bottom to top.
    pub(crate) fn painted(&self, frame: usize) -> impl Iterator<Item = &Element> {
        let order = self.order.get(frame).and_then(|order| self.orders.get(*order));
        order.into_iter().flatten().filter_map(|element| self.elements.get(*element))
    }
}

impl Maker {
    /// Adds a frame.
    fn add(&mut self, marks: Vec<Mark>) {
        let frame = self.template.order.len();
        let mut painted: Vec<usize> = Vec::new();
        let areas: Vec<Area> = marks.iter().map(|mark| [mark.low, mark.high]).collect();
        let mut is_painted = vec![false; self.template.elements.len()];
        for mark in marks {
            let (kind, numbers) = taken_apart(mark);
            let element = self.nearest(&kind, &numbers, &is_painted).unwrap_or_else(|| self.element(kind, &numbers, frame));
            is_painted.resize(self.template.elements.len(), false);
            is_painted[element] = true;
            self.last[element] = numbers;
            painted.push(element);
        }
        // Hidden elements keep their numbers.
        for (element, last) in self.template.elements.iter_mut().zip(&self.last) {
            let columns = element.attributes.iter_mut().flat_map(|attribute| &mut attribute.columns);
            columns.zip(last).for_each(|(column, number)| column.push(*number));
        }
        if hides_alike(&painted, &areas, &self.before) {
            painted.clone_from(&self.before);
        }
        self.before.clone_from(&painted);
        let next = self.template.orders.len();
        let order = *self.orders.entry(painted).or_insert_with_key(|painted| {
            self.template.orders.push(painted.clone());
            next
        });
        self.template.order.push(order);
    }

    /// Among the unused elements of a kind, the one with the nearest numbers in the frame before.
    fn nearest(&self, kind: &Kind, numbers: &[i64], is_painted: &[bool]) -> Option<usize> {
        let free = self.kinds.get(kind)?.iter().copied().filter(|element| !is_painted.get(*element).copied().unwrap_or(true));
        let away = |element: &usize| self.last[*element].iter().zip(numbers).map(|(a, b)| a.abs_diff(*b)).sum::<u64>();
        free.min_by_key(away)
    }

    /// A new element, which has its first numbers in all frames before.
    fn element(&mut self, kind: Kind, numbers: &[i64], frame: usize) -> usize {
        let element = self.template.elements.len();
        let mut numbers = numbers.iter();
        let attributes = kind.attributes.iter().map(|(name, skeleton)| {
            let columns = numbers.by_ref().take(skeleton.meanings.len()).map(|number| vec![*number; frame]).collect();
            Attribute { name, skeleton: skeleton.clone(), columns }
        });
        let attributes = attributes.collect();
        let Kind { tag, class, title, text, .. } = kind.clone();
        self.template.elements.push(Element { tag, class, title, text, attributes });
        self.last.push(Vec::new());
        self.kinds.entry(kind).or_default().push(element);
        element
    }
}

/// True if painting in the order of `other` gives the same picture: it has the same elements, and overlapping ones in the same order.
fn hides_alike(painted: &[usize], areas: &[Area], other: &[usize]) -> bool {
    let rank: BTreeMap<usize, usize> = other.iter().enumerate().map(|(rank, element)| (*element, rank)).collect();
    let Some(ranks) = painted.iter().map(|element| rank.get(element).copied()).collect::<Option<Vec<usize>>>() else { return false };
    let overlap = |one: &Area, two: &Area| (0..2).all(|axis| one[0][axis] < two[1][axis] && two[0][axis] < one[1][axis]);
    let is_alike = |upper: usize| (0..upper).all(|lower| ranks[lower] < ranks[upper] || !overlap(&areas[lower], &areas[upper]));
    ranks.len() == other.len() && (0..ranks.len()).all(is_alike)
}

/// Kind and numbers of a mark.
fn taken_apart(mark: Mark) -> (Kind, Vec<i64>) {
    let mut numbers = Vec::new();
    let attributes = mark.geometry.into_iter().map(|(name, value)| {
        let (skeleton, own) = tokens::split(&value);
        numbers.extend(own);
        (name, skeleton)
    });
    let attributes = attributes.collect();
    (Kind { tag: mark.tag, class: mark.class, title: mark.title, text: mark.text, attributes }, numbers)
}

impl Attribute {
    pub(crate) fn moves(&self) -> bool {
        self.columns.iter().any(|column| column.iter().any(|value| Some(value) != column.first()))
    }

    /// Values over the frames; angles of ellipses without jumps of half a turn, so that interpolation is continuous.
    pub(crate) fn steady(&self) -> Vec<Vec<i64>> {
        let unwrapped = |column: &Vec<i64>| {
            let mut before = column.first().copied().unwrap_or(0);
            let next = |value: &i64| {
                before = value + (before - value + 900).div_euclid(1800) * 1800;
                before
            };
            column.iter().map(next).collect()
        };
        let steady = |(column, meaning): (&Vec<i64>, &Meaning)| match meaning {
            Meaning::Length => column.clone(),
            Meaning::HalfTurn => unwrapped(column),
        };
        self.columns.iter().zip(&self.skeleton.meanings).map(steady).collect()
    }
}
