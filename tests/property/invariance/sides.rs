//! The order of a joint's sides has no effect.

use fastrand::Rng;
use reuleaux_tests::common::declared::Rows;
use reuleaux_tests::common::interpreter::Interpreter;

use crate::random::instant;

/// A joint, the joint with its sides exchanged, and the resulting factor of Φ.
const EXCHANGED: [(&str, &str, f64); 13] = [
    ("joint it = revolute(a.P, b.Q);", "joint it = revolute(b.Q, a.P);", -1.0),
    ("joint it = weld(a.P, b.Q, 0.7);", "joint it = weld(b.Q, a.P, -0.7);", -1.0),
    ("joint it = distance(a.P, b.Q, 1.3);", "joint it = distance(b.Q, a.P, 1.3);", 1.0),
    ("joint it = relative_angle(a, b, 0.7);", "joint it = relative_angle(b, a, -0.7);", -1.0),
    ("joint it = parallel(a, b);", "joint it = parallel(b, a);", -1.0),
    ("joint it = gear_pair(a, b, 20, 30, 0.3, carrier: c);", "joint it = gear_pair(b, a, 30, 20, 0.3, carrier: c);", 1.0),
    ("joint it = belt(a, b, 0.2, 0.3, 0.1, carrier: c);", "joint it = belt(b, a, 0.3, 0.2, -0.1, carrier: c);", -1.0),
    ("joint it = differential(a, b, c);", "joint it = differential(b, a, c);", 1.0),
    ("joint it = differential(a, b, c, 2, 0.5);", "joint it = differential(b, a, c, 0.5, 0.25);", 0.5),
    ("joint it = planetary(a, b, c, 20, 60, 0.3);", "joint it = planetary(b, a, c, 60, 20, 0.3);", 1.0),
    (
        "drive it = drive_distance(a.P, b.Q, 1.3m + 0.2m * sin(3 * t / 1s));",
        "drive it = drive_distance(b.Q, a.P, 1.3m + 0.2m * sin(3 * t / 1s));",
        1.0,
    ),
    ("drive it = drive_relative_angle(a, b, sin(3 * t / 1s));", "drive it = drive_relative_angle(b, a, -sin(3 * t / 1s));", -1.0),
    ("joint it = { a.P == b.Q; a.angle == 2 * b.angle; }", "joint it = { b.Q == a.P; 2 * b.angle == a.angle; }", -1.0),
];

#[test]
fn sides_of_a_joint_may_be_exchanged() {
    let mut rng = Rng::with_seed(3);
    let bodies = "body a { point P = (0.3, -0.8); } body b { point Q = (1.1, 0.4); } body c {}";
    let interpreter = |joint: &str| Interpreter::of(&format!("#[equations_only] pub mechanism Pair {{ {bodies} {joint} }}"));
    for (one, other, factor) in EXCHANGED {
        let (mut straight, mut exchanged) = (interpreter(one), interpreter(other));
        for _ in 0..200 {
            let at = instant(&mut rng, 9);
            let (here, there) = (flat(straight.rows(&[], &at, &[])), flat(exchanged.rows(&[], &at, &[])));
            let largest = here.iter().map(|entry| entry.abs()).fold(1.0, f64::max);
            for (x, y) in here.iter().zip(&there) {
                assert!((factor * x - y).abs() <= 4.0 * f64::EPSILON * largest, "{one} {x} {y}");
            }
        }
    }
}

fn flat(rows: Rows) -> Vec<f64> {
    [rows.phi, rows.jacobian.concat(), rows.nu, rows.gamma].concat()
}
