use crate::expr::{Arena, Expr, Frame, Leaf, Triple, Values, evaluate};

/// An arena with a frame that turns about z by the first coordinate.
pub(super) fn turning() -> (Arena, usize) {
    let mut arena = Arena::new();
    let [zero, one] = [0, 1].map(|value| arena.integer(value));
    let angle = arena.leaf(Leaf::Coordinate(0));
    let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
    let back = arena.neg(sine);
    let about_z = |part: Expr| [zero, zero, part];
    let [velocity, acceleration] = [Leaf::Speed(0), Leaf::Acceleration(0)].map(|leaf| about_z(arena.leaf(leaf)));
    let frame = arena.add_frame(Frame {
        columns: [[cosine, sine, zero], [back, cosine, zero], about_z(one)],
        velocity,
        acceleration,
        acceleration_at_constant_speeds: [zero; 3],
        turns: vec![(Leaf::Coordinate(0), about_z(one))],
        against: None,
        own: vec![Leaf::Coordinate(0)],
    });
    (arena, frame)
}

pub(super) fn vector(arena: &mut Arena, local: [i64; 3]) -> Triple {
    local.map(|part| arena.integer(part))
}

#[test]
fn arms_of_one_frame_become_one() {
    let (mut arena, frame) = turning();
    let [one, two] = [[3, 1, 0], [-2, 5, 0]].map(|local| {
        let local = vector(&mut arena, local);
        arena.turned(frame, local)
    });
    let place = arena.leaf(Leaf::Coordinate(1));
    for axis in 0..2 {
        // 3 (3, 1) + (−2, 5) = (7, 8), with another term between them.
        let three = arena.integer(3);
        let scaled = arena.mul(three, one[axis]);
        let sum = arena.sub(scaled, place);
        let sum = arena.add(sum, two[axis]);
        let gathered = arena.gathered(sum);
        let local = vector(&mut arena, [7, 8, 0]);
        let arm = arena.turned(frame, local)[axis];
        assert_eq!(gathered, arena.sub(arm, place));
        // Arms that cancel.
        let difference = arena.sub(one[axis], two[axis]);
        let twice = arena.add(difference, two[axis]);
        let rest = arena.sub(twice, one[axis]);
        let rest = arena.add(rest, place);
        assert_eq!(arena.gathered(rest), place);
    }
}

#[test]
fn gathering_keeps_the_value() {
    let (mut arena, frame) = turning();
    let [one, two] = [[3, 1, 2], [-2, 5, 4]].map(|local| {
        let local = vector(&mut arena, local);
        arena.turned(frame, local)
    });
    let place = arena.leaf(Leaf::Coordinate(1));
    let coordinates = [0.7_f64, 0.3];
    let values =
        Values { time: 0.0, parameters: &[], coordinates: &coordinates, speeds: &[], accelerations: &[], functions: &|_, _| [f64::NAN; 3] };
    // The square of a difference: sums within a product.
    let differences = [0, 1, 2].map(|axis| {
        let sum = arena.sub(one[axis], place);
        arena.sub(sum, two[axis])
    });
    let squares = differences.map(|part| arena.square(part));
    let square = arena.sum(&squares);
    let gathered = arena.gathered(square);
    assert_ne!(gathered, square);
    let (sine, cosine) = coordinates[0].sin_cos();
    let parts = [5.0 * cosine + 4.0 * sine - 0.3, 5.0 * sine - 4.0 * cosine - 0.3, -2.3];
    let wanted: f64 = parts.iter().map(|part| part * part).sum();
    let found = evaluate(&arena, &[gathered], &values)[0];
    assert!((found - wanted).abs() <= 1e-14 * wanted, "{found} {wanted}");
}

#[test]
fn other_sums_stay_as_they_are() {
    let (mut arena, frame) = turning();
    let local = vector(&mut arena, [3, 1, 2]);
    let one = arena.turned(frame, local);
    let [x, y] = [1, 2].map(|number| arena.leaf(Leaf::Coordinate(number)));
    let sum = arena.add(x, one[0]);
    let sum = arena.sub(sum, y);
    // Further terms of the same leaf, and another component of the same vector.
    let sum = arena.add(sum, x);
    let sum = arena.add(sum, one[1]);
    assert_eq!(arena.gathered(sum), sum);
}
