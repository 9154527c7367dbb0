//! Pieces of a mechanism that do the same operations on different operands.
//!
//! In: lists of expressions, each the results of one piece. Out: [`Shape`]s: one list of expressions, over local coordinates, parameters
//! and numbers, for all pieces with the same operations, and a [`Column`] per local operand with its value in each piece. Not done here:
//! choosing pieces, and printing.
//!
//! Operands of sums and products commute without changing a bit of the result. The arena orders them by creation time; here they are sorted
//! by structural hash, so that equal shapes compare equal.

use crate::expr::{Arena, Binary, Exact, Expr, Leaf, Lookup, Members, Node, Unary};
use std::hash::{DefaultHasher, Hash, Hasher};

/// One list of expressions that stands for several pieces.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Arena of its own expressions.
    pub arena: Arena,
    /// Results, over local coordinates and parameters.
    pub results: Vec<Expr>,
    /// Number of pieces with this shape.
    pub count: usize,
    /// Index in q of each local coordinate, by piece.
    pub unknowns: Vec<Column<u32>>,
    /// Index of each local parameter, by piece.
    pub parameters: Vec<Column<u32>>,
    /// Numbers that differ between pieces, by piece.
    pub data: Vec<Vec<f64>>,
}

/// One value per piece.
#[derive(Clone, Debug, PartialEq)]
pub enum Column<V> {
    /// The same value for all pieces.
    Same(V),
    /// First value, and the increment from piece to piece.
    Steps(V, V),
    /// A list of values.
    Listed(Vec<V>),
}

impl Column<u32> {
    /// The shortest representation of some values.
    pub(crate) fn of(values: Vec<u32>) -> Column<u32> {
        let first = values.first().copied().unwrap_or(0);
        match values.get(1) {
            None => Column::Same(first),
            Some(second) if *second == first && values.iter().all(|value| *value == first) => Column::Same(first),
            Some(second) if *second > first && values.windows(2).all(|pair| pair[1].wrapping_sub(pair[0]) == second - first) => {
                Column::Steps(first, second - first)
            }
            Some(_) => Column::Listed(values),
        }
    }

    /// The column with each value mapped.
    pub(crate) fn mapped(&self, pieces: usize, to: impl Fn(u32) -> u32) -> Column<u32> {
        Column::of((0..pieces).map(|piece| to(self.at(piece))).collect())
    }

    /// Value of one piece.
    pub(crate) fn at(&self, piece: usize) -> u32 {
        match self {
            Column::Same(value) => *value,
            Column::Steps(first, step) => first + step * piece as u32,
            Column::Listed(values) => values[piece],
        }
    }
}

/// A piece to be matched to a shape.
pub(super) struct Piece {
    /// Pieces with different tags have different shapes.
    pub(super) tag: Vec<u32>,
    /// Unknowns that come first in the local order.
    pub(super) first: Vec<u32>,
    /// Results of the piece.
    pub(super) results: Vec<Expr>,
}

/// An operation in a piece; operands are local indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Operation {
    Datum,
    Time,
    Input(u32, u8),
    Parameter(u32),
    Coordinate(u32),
    Speed(u32),
    Acceleration(u32),
    Jerk(u32),
    Unary(Unary, u32),
    Binary(Binary, u32, u32),
    Select([u32; 4]),
    Call(u32, u8, u32),
    Result(u32),
}

/// Operations of a piece, separated from its operands.
struct Trace {
    marks: Vec<Operation>,
    unknowns: Vec<u32>,
    parameters: Vec<u32>,
    /// Constants, one for each occurrence.
    data: Vec<Expr>,
}

/// Finds the shapes of pieces of one arena.
pub(super) struct Tracer<'a> {
    arena: &'a Arena,
    /// Structural hash of each node, independent of the leaves it is applied to.
    kinds: Vec<u64>,
}

impl<'a> Tracer<'a> {
    pub(super) fn new(arena: &'a Arena) -> Tracer<'a> {
        let mut kinds = Vec::with_capacity(arena.len());
        for expr in arena.all() {
            kinds.push(kind(arena.node(expr), &kinds, arena.value(expr).is_some()));
        }
        Tracer { arena, kinds }
    }

    /// Shapes of some pieces in the order of their first occurrence, and the index of each piece's shape.
    pub(super) fn shapes(&self, pieces: &[Piece]) -> (Vec<Shape>, Vec<usize>) {
        let mut numbers: Lookup<(Vec<u32>, Vec<Operation>), usize> = Lookup::default();
        let mut members: Vec<Vec<Trace>> = Vec::new();
        let mut of_piece = Vec::new();
        for piece in pieces {
            let trace = self.trace(&piece.first, &piece.results);
            let number = *numbers.entry((piece.tag.clone(), trace.marks.clone())).or_insert(members.len());
            if number == members.len() {
                members.push(Vec::new());
            }
            members[number].push(trace);
            of_piece.push(number);
        }
        (members.iter().map(|members| self.shape(members)).collect(), of_piece)
    }

    fn trace(&self, first: &[u32], results: &[Expr]) -> Trace {
        let mut trace = Trace { marks: Vec::new(), unknowns: first.to_vec(), parameters: Vec::new(), data: Vec::new() };
        let mut places: Lookup<Expr, u32> = Lookup::default();
        for result in results {
            for expr in self.below(*result, &places) {
                let operands: Vec<u32> = self.operands(expr).into_iter().map(|operand| self.place(&mut trace, &places, operand)).collect();
                if let Node::Marked { .. } = self.arena.node(expr) {
                    places.insert(expr, operands[0]);
                    continue;
                }
                let mark = match *self.arena.node(expr) {
                    Node::Leaf(leaf) => trace.leaf(leaf),
                    Node::Unary(function, _) => Operation::Unary(function, operands[0]),
                    Node::Binary(function, ..) => Operation::Binary(function, operands[0], operands[1]),
                    Node::Select { .. } => Operation::Select([operands[0], operands[1], operands[2], operands[3]]),
                    Node::Call { function, order, .. } => Operation::Call(function, order, operands[0]),
                    Node::Constant(_) | Node::Marked { .. } => Operation::Datum,
                };
                places.insert(expr, trace.push(mark));
            }
            let place = self.place(&mut trace, &places, *result);
            trace.push(Operation::Result(place));
        }
        trace
    }

    /// Index of an operand in the trace; a constant gets a new one at each occurrence.
    fn place(&self, trace: &mut Trace, places: &Lookup<Expr, u32>, operand: Expr) -> u32 {
        places.get(&operand).copied().unwrap_or_else(|| {
            trace.data.push(operand);
            trace.push(Operation::Datum)
        })
    }

    /// Nodes not yet in the trace, operands first, constants left out.
    fn below(&self, root: Expr, places: &Lookup<Expr, u32>) -> Vec<Expr> {
        let mut found = Vec::new();
        let mut seen = Members::default();
        let mut pending = vec![(root, false)];
        while let Some((expr, is_entered)) = pending.pop() {
            if is_entered {
                found.push(expr);
            } else if self.arena.value(expr).is_none() && !places.contains_key(&expr) && seen.insert(expr) {
                pending.push((expr, true));
                pending.extend(self.operands(expr).into_iter().rev().map(|operand| (operand, false)));
            }
        }
        found
    }

    /// Operands; those of a commutative operation sorted by structural hash.
    fn operands(&self, expr: Expr) -> Vec<Expr> {
        let node = self.arena.node(expr);
        let mut operands: Vec<Expr> = node.children().collect();
        if commutes(node) {
            operands.sort_by_key(|operand| self.kinds[operand.index()]);
        }
        operands
    }

    fn shape(&self, members: &[Trace]) -> Shape {
        let column = |of: fn(&Trace) -> &Vec<u32>, slot: usize| Column::of(members.iter().map(|trace| of(trace)[slot]).collect());
        let columns = |of: fn(&Trace) -> &Vec<u32>| (0..of(&members[0]).len()).map(|slot| column(of, slot)).collect();
        let mut copy = Copy { arena: Arena::new(), data: Vec::new(), places: Vec::new(), results: Vec::new() };
        let mut occurrence = 0;
        for mark in &members[0].marks {
            if *mark == Operation::Datum {
                self.datum(&mut copy, members, occurrence);
                occurrence += 1;
            } else {
                copy.operation(*mark);
            }
        }
        Shape {
            arena: copy.arena,
            results: copy.results,
            count: members.len(),
            unknowns: columns(|trace| &trace.unknowns),
            parameters: columns(|trace| &trace.parameters),
            data: copy.data,
        }
    }

    /// Adds a constant: as itself if it is the same in all pieces, otherwise as a leaf.
    fn datum(&self, copy: &mut Copy, members: &[Trace], occurrence: usize) {
        let first = members[0].data[occurrence];
        if members.iter().all(|trace| trace.data[occurrence] == first) {
            let place = copy.closed(self.arena, first);
            return copy.places.push(place);
        }
        let values: Vec<f64> = members.iter().map(|trace| self.arena.value(trace.data[occurrence]).unwrap_or(f64::NAN)).collect();
        let same =
            copy.data.iter().position(|column| column.iter().map(|value| value.to_bits()).eq(values.iter().map(|value| value.to_bits())));
        let number = same.unwrap_or_else(|| {
            copy.data.push(values);
            copy.data.len() - 1
        });
        copy.places.push(copy.arena.place(Node::Leaf(Leaf::Datum(number as u32))));
    }
}

impl Trace {
    fn push(&mut self, mark: Operation) -> u32 {
        self.marks.push(mark);
        self.marks.len() as u32 - 1
    }

    fn leaf(&mut self, leaf: Leaf) -> Operation {
        match leaf {
            Leaf::Time => Operation::Time,
            Leaf::Datum(_) | Leaf::Turn(_) => Operation::Datum,
            Leaf::Input { number, order } => Operation::Input(number, order),
            Leaf::Parameter(index) => Operation::Parameter(slot(&mut self.parameters, index)),
            Leaf::Coordinate(index) => Operation::Coordinate(slot(&mut self.unknowns, index)),
            Leaf::Speed(index) => Operation::Speed(slot(&mut self.unknowns, index)),
            Leaf::Acceleration(index) => Operation::Acceleration(slot(&mut self.unknowns, index)),
            Leaf::Jerk(index) => Operation::Jerk(slot(&mut self.unknowns, index)),
        }
    }
}

/// Local index of a value; a new one if it has none.
fn slot(list: &mut Vec<u32>, value: u32) -> u32 {
    let place = list.iter().position(|other| *other == value).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    });
    place as u32
}

/// A piece's expressions, copied to an arena of their own.
struct Copy {
    arena: Arena,
    data: Vec<Vec<f64>>,
    /// Node of each operation in the trace. That of a result is never used.
    places: Vec<Expr>,
    results: Vec<Expr>,
}

impl Copy {
    fn operation(&mut self, mark: Operation) {
        let at = |place: u32| self.places[place as usize];
        let node = match mark {
            Operation::Time | Operation::Datum => Node::Leaf(Leaf::Time),
            Operation::Input(number, order) => Node::Leaf(Leaf::Input { number, order }),
            Operation::Parameter(slot) => Node::Leaf(Leaf::Parameter(slot)),
            Operation::Coordinate(slot) => Node::Leaf(Leaf::Coordinate(slot)),
            Operation::Speed(slot) => Node::Leaf(Leaf::Speed(slot)),
            Operation::Acceleration(slot) => Node::Leaf(Leaf::Acceleration(slot)),
            Operation::Jerk(slot) => Node::Leaf(Leaf::Jerk(slot)),
            Operation::Unary(function, a) => Node::Unary(function, at(a)),
            Operation::Binary(function, a, b) => Node::Binary(function, at(a), at(b)),
            Operation::Select([lhs, rhs, then, otherwise]) => {
                Node::Select { lhs: at(lhs), rhs: at(rhs), then: at(then), otherwise: at(otherwise) }
            }
            Operation::Call(function, order, argument) => Node::Call { function, order, argument: at(argument) },
            Operation::Result(place) => {
                let result = at(place);
                self.results.push(result);
                return self.places.push(result);
            }
        };
        let place = self.arena.place(node);
        self.places.push(place);
    }

    /// Copies an expression of constants, as one number where that has the same value.
    fn closed(&mut self, from: &Arena, root: Expr) -> Expr {
        let is_same = |number: &Exact| from.value(root).is_some_and(|value| value.to_bits() == number.to_f64().to_bits());
        if let Some(number) = from.value(root).and_then(Exact::binary).filter(is_same) {
            return self.arena.place(Node::Constant(number));
        }
        let mut copies: Lookup<Expr, Expr> = Lookup::default();
        for expr in from.reachable(&[root]) {
            let at = |operand: Expr| copies[&operand];
            let node = match *from.node(expr) {
                Node::Unary(function, a) => Node::Unary(function, at(a)),
                Node::Binary(function, a, b) => Node::Binary(function, at(a), at(b)),
                Node::Select { lhs, rhs, then, otherwise } => {
                    Node::Select { lhs: at(lhs), rhs: at(rhs), then: at(then), otherwise: at(otherwise) }
                }
                node => node,
            };
            copies.insert(expr, self.arena.place(node));
        }
        copies[&root]
    }
}

fn commutes(node: &Node) -> bool {
    matches!(node, Node::Binary(Binary::Add | Binary::Mul, ..))
}

/// Structural hash of a node: equal for nodes that differ only in their leaves' indices and in constants.
fn kind(node: &Node, kinds: &[u64], is_closed: bool) -> u64 {
    let mut hasher = DefaultHasher::new();
    if is_closed {
        return 0;
    }
    let mut operands: Vec<u64> = node.children().map(|child| kinds[child.index()]).collect();
    if commutes(node) {
        operands.sort_unstable();
    }
    operands.hash(&mut hasher);
    match *node {
        Node::Constant(_) | Node::Marked { .. } => {}
        Node::Leaf(leaf) => std::mem::discriminant(&leaf).hash(&mut hasher),
        Node::Unary(function, _) => (1, function).hash(&mut hasher),
        Node::Binary(function, ..) => (2, function).hash(&mut hasher),
        Node::Select { .. } => 3.hash(&mut hasher),
        Node::Call { function, order, .. } => (4, function, order).hash(&mut hasher),
    }
    hasher.finish()
}
