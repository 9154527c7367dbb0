use super::random::Random;
use super::{FORMULAS, Point, assert_close, expr};
use crate::expr::{Arena, Derivatives, Leaf, derivative};

#[test]
fn derivatives_are_central_differences() {
    const STEP: f64 = 1e-5;
    let mut random = Random::new(5);
    for text in FORMULAS {
        let mut arena = Arena::new();
        let root = expr(&mut arena, text);
        for leaf in arena.leaves(root) {
            let slope = derivative(&mut arena, root, leaf);
            for _ in 0..5 {
                let point = Point::random(&mut random);
                let [low, high] = [-STEP, STEP].map(|h| shifted(&point, leaf, h).value_of(&arena, root));
                let expected = (high - low) / (2.0 * STEP);
                assert_close(point.value_of(&arena, slope), expected, 1e-6, text);
            }
        }
    }
}

#[test]
fn a_derivative_is_the_same_beside_others_that_are_remembered() {
    let mut arena = Arena::new();
    let mut by_x = Derivatives::new(Leaf::Coordinate(0));
    for text in FORMULAS {
        let root = expr(&mut arena, text);
        let fresh = derivative(&mut arena, root, Leaf::Coordinate(0));
        assert_eq!(by_x.of(&mut arena, root), fresh, "{text}");
    }
}

#[test]
fn derivatives_have_their_textbook_form() {
    for (before, after) in [
        ("y", "0"),
        ("u", "0"),
        ("3*x + y", "3"),
        ("x*x", "2*x"),
        ("x*y", "y"),
        ("x/y", "1/y"),
        ("y/x", "-(y/x/x)"),
        ("sqrt(x)", "1/(2*sqrt(x))"),
        ("sin(2*x)", "2*cos(2*x)"),
        ("cos(x)", "-sin(x)"),
        ("if(x, y, x, y*x)", "if(x, y, 1, y)"),
        ("if(x, y, x, x + z)", "1"),
        ("sign(x)", "0"),
        ("abs(x)", "sign(x)"),
    ] {
        let mut arena = Arena::new();
        let root = expr(&mut arena, before);
        let expected = expr(&mut arena, after);
        assert_eq!(derivative(&mut arena, root, Leaf::Coordinate(0)), expected, "{before}");
    }
}

#[test]
fn the_derivative_of_a_call_is_a_call_of_the_next_order() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    let mut slope = arena.call(7, 0, x);
    for order in 1..=3 {
        slope = derivative(&mut arena, slope, Leaf::Coordinate(0));
        assert_eq!(slope, arena.call(7, order, x));
    }
}

fn shifted(point: &Point, leaf: Leaf, step: f64) -> Point {
    let mut point = point.clone();
    match leaf {
        Leaf::Time => point.time += step,
        Leaf::Datum(_) | Leaf::Turn(_) | Leaf::Input { .. } | Leaf::Jerk(_) => {
            unreachable!("a point has neither data nor turns nor inputs nor third derivatives")
        }
        Leaf::Parameter(i) => point.parameters[i as usize] += step,
        Leaf::Coordinate(i) => point.coordinates[i as usize] += step,
        Leaf::Speed(i) => point.speeds[i as usize] += step,
        Leaf::Acceleration(i) => point.accelerations[i as usize] += step,
    }
    point
}
