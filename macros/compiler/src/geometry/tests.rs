//! Triads of constants.

use super::{Place, Triad};
use crate::expr::{Arena, Exact, Expr, Values, evaluate};

fn value(arena: &Arena, expr: Expr) -> f64 {
    let values = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &|_, _| [f64::NAN; 3] };
    evaluate(arena, &[expr], &values)[0]
}

#[test]
fn a_direction_at_a_right_angle_has_no_part_along_an_axis() {
    let mut arena = Arena::new();
    let [pitch, roll] =
        [(3, 10), (1, 2)].map(|(above, below)| Exact::ratio(above, below).map(|value| arena.constant(value)).expect("it fits"));
    let [[s1, c1], [s2, c2]] = [pitch, roll].map(|angle| [arena.sin(angle), arena.cos(angle)]);
    let product = |arena: &mut Arena, a: Expr, b: Expr| arena.mul(a, b);
    // The columns of R_x(1/2) R_y(3/10)
    let [up, down, over, under] = [(s2, c1), (c2, c1), (s2, s1), (c2, s1)].map(|(a, b)| product(&mut arena, a, b));
    let (back, left) = (arena.neg(up), arena.neg(under));
    let place = Place { body: None, local: [s1, back, down] };
    let triad = Triad::along(&mut arena, place, [c1, over, left]);
    let values = triad.axes.map(|axis| axis.map(|part| value(&arena, part)));
    assert_eq!(triad.axes[1][0], arena.integer(0));
    let ((s1, c1), (s2, c2)) = (0.3_f64.sin_cos(), 0.5_f64.sin_cos());
    let wanted = [[c1, s2 * s1, -c2 * s1], [0.0, c2, s2], [s1, -s2 * c1, c2 * c1]];
    for (found, wanted) in values.as_flattened().iter().zip(wanted.as_flattened()) {
        assert!((found - wanted).abs() <= 5e-16, "{found} {wanted}");
    }
}
