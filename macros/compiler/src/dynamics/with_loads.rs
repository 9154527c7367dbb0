//! Accelerations and loads of a state in one routine, which computes sines and determinants once.

use super::{Dynamics, Loads, Multipliers};
use crate::expr::{Arena, Exact, Expr, Leaf, Lookup, Node};

/// Accelerations and loads as functions of the integrated coordinates and speeds.
#[derive(Clone, Debug)]
pub struct WithLoads {
    /// The acceleration of every entry of the state.
    pub accelerations: Vec<Expr>,
    /// λ, then forces and torques of joints and powers of drives.
    pub loads: Vec<Expr>,
    /// Determinants and pivots of both, each with the number that it has to exceed.
    pub checks: Vec<[Expr; 2]>,
}

impl WithLoads {
    /// The closed forms of accelerations and loads put together; `None` if there is only one or none of them.
    pub(super) fn new(dynamics: &mut Dynamics, loads: &Loads) -> Option<WithLoads> {
        let (found, closed) = (dynamics.accelerations.as_ref()?, loads.closed.as_ref()?);
        let Multipliers { values, actions, checks } = closed;
        let (arena, mut known) = (&mut dynamics.arena, Lookup::default());
        for (unknown, value) in dynamics.integrated.iter().zip(&found.values) {
            known.insert(Leaf::Acceleration(*unknown as u32), *value);
        }
        let own = arena.clone();
        let mut of_state = Entering { known: &known, from: &own, memo: Lookup::default() };
        let state: Vec<[Expr; 3]> = dynamics.state.iter().map(|motion| motion.map(|expr| of_state.of(arena, expr))).collect();
        for (number, motion) in (0..).zip(&state) {
            let leaves = [Leaf::Coordinate(number), Leaf::Speed(number), Leaf::Acceleration(number)];
            known.extend(leaves.into_iter().zip(*motion));
        }
        let mut of_loads = Entering { known: &known, from: &loads.arena, memo: Lookup::default() };
        let loads = values.iter().chain(actions).map(|expr| of_loads.of(arena, *expr)).collect();
        let mut together = found.checks.clone();
        together.extend(checks.iter().map(|check| check.map(|expr| of_loads.of(arena, expr))));
        Some(WithLoads { accelerations: state.iter().map(|motion| motion[2]).collect(), loads, checks: together })
    }
}

/// Expressions of one arena on their way into another.
struct Entering<'a> {
    /// What leaves become there.
    known: &'a Lookup<Leaf, Expr>,
    from: &'a Arena,
    memo: Lookup<Expr, Expr>,
}

impl Entering<'_> {
    /// The expression, operation by operation, so that its value stays the same bit for bit: only operations with 0 are left out. Where all
    /// operands have become numbers, so does the result, rounded as it would be at run time.
    fn of(&mut self, arena: &mut Arena, root: Expr) -> Expr {
        let zero = arena.integer(0);
        for expr in self.from.reachable_until(&[root], |expr| self.memo.contains_key(&expr)) {
            let node = self.from.node(expr).with_children(|child| self.memo[&child]);
            let number = node.value(|child| arena.value(child)).filter(|_| self.from.value(expr).is_none());
            let entered = match (node, number.and_then(Exact::binary)) {
                (_, Some(number)) => arena.constant(number),
                (Node::Leaf(leaf), _) => self.known.get(&leaf).copied().unwrap_or_else(|| arena.leaf(leaf)),
                _ if node.children().any(|child| child == zero) => arena.build(node),
                _ => arena.place(node),
            };
            self.memo.insert(expr, entered);
        }
        self.memo[&root]
    }
}
