//! A small language for tests: `if(x, 2, -y/3, sin(pi*t))` means `x < 2 ? -y/3 : sin(π t)`.
//!
//! Leaves: `t`, `p q` parameters, `x y z` coordinates, `u v w` their velocities, `a` the first
//! acceleration. Functions by number: `f` is 0, `g` is 1. Nothing is simplified here: a [`Tree`]
//! is what was written.

use crate::expr::{Arena, Binary, Exact, Expr, Leaf, Node, Unary};

/// An expression as written.
#[derive(Clone, Debug)]
pub(super) enum Tree {
    Constant(Exact),
    Leaf(Leaf),
    Unary(Unary, Box<Tree>),
    Binary(Binary, Box<Tree>, Box<Tree>),
    Select([Box<Tree>; 4]),
    Call(u32, Box<Tree>),
}

impl Tree {
    /// The expression in an arena.
    pub(super) fn build(&self, arena: &mut Arena) -> Expr {
        let node = self.node(arena);
        arena.build(node)
    }

    /// The outermost operation as written, over operands in an arena.
    pub(super) fn node(&self, arena: &mut Arena) -> Node {
        match self {
            Tree::Constant(value) => Node::Constant(*value),
            Tree::Leaf(leaf) => Node::Leaf(*leaf),
            Tree::Unary(function, a) => Node::Unary(*function, a.build(arena)),
            Tree::Binary(function, a, b) => {
                let a = a.build(arena);
                Node::Binary(*function, a, b.build(arena))
            }
            Tree::Select(operands) => {
                let [lhs, rhs, then, otherwise] = operands.each_ref().map(|o| o.build(arena));
                Node::Select { lhs, rhs, then, otherwise }
            }
            Tree::Call(function, argument) => {
                let argument = argument.build(arena);
                Node::Call { function: *function, order: 0, argument }
            }
        }
    }
}

/// Reads a formula; anything else is a mistake in the test.
pub(super) fn parse(text: &str) -> Tree {
    let mut reader = Reader { rest: text };
    let tree = reader.sum();
    assert!(reader.rest.trim().is_empty(), "`{}` is left of `{text}`", reader.rest);
    tree
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn sum(&mut self) -> Tree {
        let mut tree = self.product();
        loop {
            let sign = if self.eat("+") {
                Binary::Add
            } else if self.eat("-") {
                Binary::Sub
            } else {
                return tree;
            };
            tree = Tree::Binary(sign, Box::new(tree), Box::new(self.product()));
        }
    }

    fn product(&mut self) -> Tree {
        let mut tree = self.factor();
        loop {
            let sign = if self.eat("*") {
                Binary::Mul
            } else if self.eat("/") {
                Binary::Div
            } else {
                return tree;
            };
            tree = Tree::Binary(sign, Box::new(tree), Box::new(self.factor()));
        }
    }

    fn factor(&mut self) -> Tree {
        if self.eat("-") {
            return Tree::Unary(Unary::Neg, Box::new(self.factor()));
        }
        if self.eat("(") {
            let tree = self.sum();
            assert!(self.eat(")"), "`)` expected before `{}`", self.rest);
            return tree;
        }
        let word = self.word();
        match Exact::decimal(&word) {
            Some(value) => Tree::Constant(value),
            None if self.eat("(") => self.application(&word),
            None => named(&word),
        }
    }

    fn application(&mut self, word: &str) -> Tree {
        let mut operands = vec![self.sum()];
        while self.eat(",") {
            operands.push(self.sum());
        }
        assert!(self.eat(")"), "`)` expected before `{}`", self.rest);
        apply(word, operands)
    }

    fn word(&mut self) -> String {
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '.').unwrap_or(rest.len());
        self.rest = &rest[end..];
        rest[..end].to_string()
    }

    fn eat(&mut self, sign: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }
}

fn named(word: &str) -> Tree {
    Tree::Leaf(match word {
        "pi" => return Tree::Constant(Exact::PI),
        "t" => Leaf::Time,
        "p" => Leaf::Parameter(0),
        "q" => Leaf::Parameter(1),
        "x" => Leaf::Coordinate(0),
        "y" => Leaf::Coordinate(1),
        "z" => Leaf::Coordinate(2),
        "u" => Leaf::Speed(0),
        "v" => Leaf::Speed(1),
        "w" => Leaf::Speed(2),
        "a" => Leaf::Acceleration(0),
        _ => panic!("`{word}` is no leaf"),
    })
}

fn apply(word: &str, operands: Vec<Tree>) -> Tree {
    let function = match word {
        "sqrt" => Unary::Sqrt,
        "sin" => Unary::Sin,
        "cos" => Unary::Cos,
        "tan" => Unary::Tan,
        "asin" => Unary::Asin,
        "acos" => Unary::Acos,
        "atan" => Unary::Atan,
        "exp" => Unary::Exp,
        "ln" => Unary::Ln,
        "abs" => Unary::Abs,
        "sign" => Unary::Sign,
        _ => return apply_many(word, operands),
    };
    match <[Tree; 1]>::try_from(operands) {
        Ok([a]) => Tree::Unary(function, Box::new(a)),
        Err(_) => panic!("`{word}` takes one operand"),
    }
}

fn apply_many(word: &str, operands: Vec<Tree>) -> Tree {
    let boxed = |tree: &Tree| Box::new(tree.clone());
    match (word, operands.as_slice()) {
        ("f", [a]) => Tree::Call(0, boxed(a)),
        ("g", [a]) => Tree::Call(1, boxed(a)),
        ("atan2", [a, b]) => Tree::Binary(Binary::Atan2, boxed(a), boxed(b)),
        ("if", [a, b, c, d]) => Tree::Select([boxed(a), boxed(b), boxed(c), boxed(d)]),
        _ => panic!("`{word}` is no function of {} operands", operands.len()),
    }
}
