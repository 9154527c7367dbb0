use super::random::Random;
use super::{Point, expr, functions};
use crate::expr::{Arena, Evaluator, Expr, Leaf, Unary, evaluate};

#[test]
fn values_are_those_of_the_formula_written_by_hand() {
    let mut arena = Arena::new();
    let roots = [
        expr(&mut arena, "x*cos(y) - 0.1*sin(y) + t"),
        expr(&mut arena, "sqrt((x - y)*(x - y) + z*z)/p"),
        expr(&mut arena, "atan2(tan(x), exp(y)) - ln(z)"),
        expr(&mut arena, "if(x, y, asin(x), acos(y)) + atan(abs(u))"),
        expr(&mut arena, "f(x) + g(v)*a"),
    ];
    let mut random = Random::new(8);
    for _ in 0..100 {
        let point = Point::random(&mut random);
        let ([x, y, z], [u, v, _]) = (point.coordinates, point.speeds);
        let ((sine, cosine), d) = (libm::sincos(y), x - y);
        let expected = [
            x * cosine - 0.1 * sine + point.time,
            (d * d + z * z).sqrt() / point.parameters[0],
            libm::atan2(libm::tan(x), libm::exp(y)) - libm::log(z),
            if x < y { libm::asin(x) } else { libm::acos(y) } + libm::atan(u.abs()),
            x * x * x + 1.0 / v * point.accelerations[0],
        ];
        assert_eq!(evaluate(&arena, &roots, &point.values()), expected);
    }
}

#[test]
fn an_evaluator_can_be_used_again() {
    let mut arena = Arena::new();
    let roots = [expr(&mut arena, "sin(x)*y"), expr(&mut arena, "y"), expr(&mut arena, "y")];
    let mut evaluator = Evaluator::new(&arena, &roots);
    let mut random = Random::new(9);
    for _ in 0..10 {
        let point = Point::random(&mut random);
        let mut found = [0.0; 3];
        evaluator.run(&point.values(), &mut found);
        assert_eq!(found.to_vec(), evaluate(&arena, &roots, &point.values()));
        let mut fewer = [0.0; 2];
        evaluator.run(&point.values(), &mut fewer);
        assert_eq!(fewer, found[..2]);
    }
}

#[test]
fn what_is_missing_is_nan() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    let roots = [arena.leaf(Leaf::Parameter(2)), arena.leaf(Leaf::Acceleration(u32::MAX)), arena.call(0, 3, x), arena.call(9, 0, x)];
    let point = Point::random(&mut Random::new(10));
    assert!(evaluate(&arena, &roots, &point.values()).iter().all(|value| value.is_nan()));
}

#[test]
fn orders_of_a_call_are_its_derivatives() {
    let mut arena = Arena::new();
    let x = expr(&mut arena, "x");
    let roots: Vec<Expr> = (0..3).map(|order| arena.call(1, order, x)).collect();
    let point = Point::random(&mut Random::new(11));
    assert_eq!(evaluate(&arena, &roots, &point.values()), functions(1, point.coordinates[0]));
}

#[test]
fn sign_keeps_zero_and_nan() {
    assert_eq!([2.0, 0.0, -3.0].map(|x| Unary::Sign.apply(x)), [1.0, 0.0, -1.0]);
    assert!(Unary::Sign.apply(f64::NAN).is_nan());
}
