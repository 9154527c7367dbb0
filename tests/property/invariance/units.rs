//! A quantity is the same double in every unit.

use fastrand::Rng;
use proptest::prelude::*;
use reuleaux_tests::common::interpreter::Interpreter;

use super::{cases, loader};
use crate::random::instant;

proptest! {
    #![proptest_config(cases(48))]

    /// 17 hundredths of a metre are 170 mm, exactly: the doubles are the same.
    #[test]
    fn units_change_no_bit(
        (a, b, c, d) in (50u32..90, 200u32..400, 200u32..400, 200u32..300), (degrees, speed) in (1u32..80, 1u32..600), seed: u64
    ) {
        let declaration = |length: &dyn Fn(u32) -> String, angle: String, speed: String, second: &str| {
            let [a, b, c, d] = [a, b, c, d].map(length);
            // Some of these do not close, and need not.
            let text = loader::declaration(&[
                &format!("ground {{ point A = (0, 0); point D = ({d}, 0); }}"),
                &format!("body crank {{ point A = (0, 0); point B = ({a}, 0); }}"),
                &format!("body coupler {{ point B = (0, 0); point C = ({b}, 0); start angle = {angle}; }}"),
                &format!("body rocker {{ point D = (0, 0); point C = ({c}, 0); start angle = {angle}; }}"),
                "joint a = revolute(ground.A, crank.A); joint b = revolute(crank.B, coupler.B);",
                "joint d = revolute(ground.D, rocker.D);",
                "joint c = { coupler.C - rocker.C == (0, 0); }",
                &format!("drive m = drive_angle(crank, {angle} + {speed} * t + 0.1 * sin(2 * t / {second}));"),
            ]);
            format!("#[closure(allow)] {text}")
        };
        let metres = declaration(&|mm| format!("{}.{:03}", mm / 1000, mm % 1000), format!("{degrees}deg"), format!("{speed}rpm"), "1s");
        let millimetres = |mm| format!("{mm}mm");
        let centimetres = |mm| format!("{}.{}cm", mm / 10, mm % 10);
        let micrometres = |mm| format!("{mm}000um");
        let others = [
            declaration(&millimetres, format!("{degrees} * pi / 180"), format!("{}deg_s", speed * 6), "1000ms"),
            declaration(&centimetres, format!("({degrees} / 360) * 1turn"), format!("{speed} * 2 * pi / 60s"), "((1/60) * 1min)"),
            declaration(&micrometres, format!("{degrees}000e-3 * 1deg"), format!("({speed} * 1turn / 1min)"), "1e6us"),
        ];
        let mut rng = Rng::with_seed(seed);
        let at = instant(&mut rng, 9);
        let mut reference = Interpreter::of(&metres);
        let expected = reference.rows(&[], &at, &[]);
        for other in others {
            let mut interpreter = Interpreter::of(&other);
            prop_assert_eq!(&interpreter.rows(&[], &at, &[]), &expected, "{}", other);
            prop_assert_eq!(&interpreter.start, &reference.start, "{}", other);
        }
    }
}
