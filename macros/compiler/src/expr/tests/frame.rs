use super::gather::{turning, vector};
use crate::expr::{Arena, Binary, Node, Triple};

/// Two vectors fixed in one frame.
fn two_vectors(locals: [[i64; 3]; 2]) -> (Arena, [Triple; 2]) {
    let (mut arena, frame) = turning();
    let vectors = locals.map(|local| {
        let local = vector(&mut arena, local);
        arena.turned(frame, local)
    });
    (arena, vectors)
}

fn products(arena: &mut Arena, [u, v]: [Triple; 2]) -> Triple {
    [0, 1, 2].map(|axis| arena.mul(u[axis], v[axis]))
}

#[test]
fn a_frame_keeps_angles_and_lengths() {
    // (3, 1, 2) · (−2, 5, 4) = 7, (3, 1, 0) · (−2, 5, 0) = −1, (3, 1, 2)² = 14
    for (locals, wanted) in [([[3, 1, 2], [-2, 5, 4]], 7), ([[3, 1, 0], [-2, 5, 0]], -1), ([[3, 1, 2], [3, 1, 2]], 14)] {
        let (mut arena, vectors) = two_vectors(locals);
        let [x, y, z] = products(&mut arena, vectors);
        for order in [[x, y, z], [y, x, z], [z, y, x], [x, z, y]] {
            let dot = arena.sum(&order);
            let gathered = arena.gathered(dot);
            assert_eq!(gathered, arena.integer(wanted), "{locals:?}");
        }
    }
}

#[test]
fn half_a_dot_product_stays() {
    let (mut arena, [u, v]) = two_vectors([[3, 1, 0], [-2, 5, 0]]);
    let [x, y, _] = products(&mut arena, [u, v]);
    let (across, square) = (arena.mul(u[0], v[1]), arena.square(u[0]));
    for [one, two] in [[x, across], [x, square], [x, u[1]], [square, y]] {
        let sum = arena.add(one, two);
        assert!(matches!(*arena.node(sum), Node::Binary(Binary::Add, a, b) if [a, b] == [one, two] || [a, b] == [two, one]));
    }
}

#[test]
fn vectors_of_two_frames_have_no_fixed_angle() {
    let (mut arena, frame) = turning();
    let other = arena.add_frame(arena.frame(frame).clone());
    let [u, v] = [frame, other].map(|frame| {
        let local = vector(&mut arena, [3, 1, 0]);
        arena.turned(frame, local)
    });
    let [x, y, _] = products(&mut arena, [u, v]);
    let sum = arena.add(x, y);
    assert!(matches!(arena.node(sum), Node::Binary(Binary::Add, ..)));
}
