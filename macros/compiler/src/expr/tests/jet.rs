use super::random::Random;
use super::{FORMULAS, Point, assert_close, expr};
use crate::expr::{Arena, Expr, Jets, Leaf, Seed, Substitution, derivative};

#[test]
fn rates_are_differences_along_the_motion() {
    rates_are_differences(along_the_motion, |point| point);
}

#[test]
fn rates_at_constant_velocity_are_differences_along_the_straight_line() {
    rates_are_differences(at_constant_speeds, |mut point| {
        point.accelerations = [0.0; 3];
        point
    });
}

fn rates_are_differences(jets: fn() -> Jets, prepare: fn(Point) -> Point) {
    const STEP: f64 = 1e-4;
    let mut random = Random::new(6);
    for text in FORMULAS {
        let mut arena = Arena::new();
        let root = expr(&mut arena, text);
        let [value, first, second] = jets().of(&mut arena, root);
        assert_eq!(value, root);
        for _ in 0..5 {
            let point = prepare(Point::random(&mut random));
            let [low, here, high] = [-STEP, 0.0, STEP].map(|s| point.later(s).value_of(&arena, root));
            let slope = (high - low) / (2.0 * STEP);
            let bend = (high - 2.0 * here + low) / (STEP * STEP);
            assert_close(point.value_of(&arena, first), slope, 1e-5, text);
            assert_close(point.value_of(&arena, second), bend, 1e-4, text);
        }
    }
}

#[test]
fn rates_are_total_derivatives() {
    let mut random = Random::new(7);
    for text in FORMULAS {
        let mut arena = Arena::new();
        let root = expr(&mut arena, text);
        let [_, first, second] = along_the_motion().of(&mut arena, root);
        let slope = total_derivative(&mut arena, root);
        let bend = total_derivative(&mut arena, slope);
        for _ in 0..5 {
            let point = Point::random(&mut random);
            let value = |e: Expr| point.value_of(&arena, e);
            assert_close(value(first), value(slope), 1e-12, text);
            assert_close(value(second), value(bend), 1e-10, text);
        }
    }
}

/// Each coordinate changes with the speed of its own number.
fn own_speeds() -> Vec<Option<u32>> {
    (0..8).map(Some).collect()
}

fn along_the_motion() -> Jets {
    Jets::along(Seed::motion(own_speeds()))
}

fn at_constant_speeds() -> Jets {
    Jets::along(Seed::constant_speeds(own_speeds()))
}

#[test]
fn by_a_parameter_first_and_second_derivatives_are_partial_ones() {
    let mut random = Random::new(11);
    for text in FORMULAS {
        let mut arena = Arena::new();
        let root = expr(&mut arena, text);
        let [_, first, second] = Jets::along(Seed::parameter(0)).of(&mut arena, root);
        let slope = derivative(&mut arena, root, Leaf::Parameter(0));
        let bend = derivative(&mut arena, slope, Leaf::Parameter(0));
        for _ in 0..5 {
            let point = Point::random(&mut random);
            let value = |e: Expr| point.value_of(&arena, e);
            assert_close(value(first), value(slope), 1e-12, text);
            assert_close(value(second), value(bend), 1e-10, text);
        }
    }
}

#[test]
fn squares_and_sines_have_their_textbook_form() {
    for (before, first, second) in [
        ("p", "0", "0"),
        ("t", "1", "0"),
        ("x", "u", "a"),
        ("u", "a", "0"),
        ("x*x", "2*(x*u)", "2*(x*a + u*u)"),
        ("sin(x)", "cos(x)*u", "cos(x)*a - sin(x)*(u*u)"),
        ("cos(x)", "-(sin(x)*u)", "-(sin(x)*a + cos(x)*(u*u))"),
        ("if(x, y, p, x)", "if(x, y, 0, u)", "if(x, y, 0, a)"),
    ] {
        let mut arena = Arena::new();
        let root = expr(&mut arena, before);
        let expected = [root, expr(&mut arena, first), expr(&mut arena, second)];
        assert_eq!(along_the_motion().of(&mut arena, root), expected, "{before}");
    }
}

#[test]
fn velocities_are_constant_on_the_straight_line() {
    let mut arena = Arena::new();
    let (x, zero) = (expr(&mut arena, "x"), arena.integer(0));
    let u = expr(&mut arena, "u");
    let mut jets = at_constant_speeds();
    assert_eq!(jets.of(&mut arena, x), [x, u, zero]);
    assert_eq!(jets.of(&mut arena, u), [u, zero, zero]);
}

#[test]
fn with_jerks_the_second_derivative_can_be_differentiated() {
    let mut arena = Arena::new();
    let [x, u, a, jerk] = [Leaf::Coordinate(0), Leaf::Speed(0), Leaf::Acceleration(0), Leaf::Jerk(0)].map(|leaf| arena.leaf(leaf));
    let mut jets = Jets::along(Seed::motion(own_speeds()).with_jerks());
    assert_eq!(jets.of(&mut arena, x), [x, u, a]);
    assert_eq!(jets.of(&mut arena, u), [u, a, jerk]);
    // (x²)⃛ = 2 x x⃛ + 6 ẋ ẍ, here as 2 (ẋ ẍ + x x⃛ + 2 ẋ ẍ)
    let square = arena.square(x);
    let [_, _, second] = jets.of(&mut arena, square);
    let [_, third, _] = jets.of(&mut arena, second);
    for point in [[3, -1, 4, 2], [2, 0, 7, -1]] {
        let mut numbers = Substitution::new();
        for (leaf, value) in [Leaf::Coordinate(0), Leaf::Speed(0), Leaf::Acceleration(0), Leaf::Jerk(0)].into_iter().zip(point) {
            let number = arena.integer(value);
            numbers.replace(leaf, number);
        }
        let [x, u, a, jerk] = point;
        assert_eq!(numbers.of(&mut arena, third), arena.integer(2 * x * jerk + 6 * u * a));
    }
}

/// Σ ∂f/∂leaf · D(leaf), the chain rule of the textbooks.
fn total_derivative(arena: &mut Arena, root: Expr) -> Expr {
    let mut sum = arena.integer(0);
    for leaf in arena.leaves(root) {
        let partial = derivative(arena, root, leaf);
        let rate = match leaf {
            Leaf::Time => arena.integer(1),
            Leaf::Coordinate(i) => arena.leaf(Leaf::Speed(i)),
            Leaf::Speed(i) => arena.leaf(Leaf::Acceleration(i)),
            Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_) | Leaf::Turn(_) | Leaf::Acceleration(_) | Leaf::Jerk(_) => {
                arena.integer(0)
            }
        };
        let term = arena.mul(partial, rate);
        sum = arena.add(sum, term);
    }
    sum
}
