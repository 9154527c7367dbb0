//! Redundant joints in space.

use reuleaux::mechanism;

mechanism! {
    /// A four-bar of hinges whose links lie askew in the frames of their bodies.
    pub(crate) mechanism Askew in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0);  point D = (150mm, 0mm, 0mm); }
        body crank   { axis z = (1, 2, 3) from (3, 0, -1);  point B = (30mm, 0mm, -10mm); }
        body coupler { axis z = (2, 1, 2) from (1, 0, -1);  point C = (100mm, 0mm, -100mm); }
        body rocker  {
            axis z = (1, 2, 2) from (0, 1, -1);  point C = (0mm, 100mm, -100mm);
            start position = (150mm, 0mm, 0mm);
        }
        redundant joint a = revolute(ground.position, ground.z, crank.position, crank.z);
        joint b = revolute(crank.B, crank.z, coupler.position, coupler.z);
        joint c = revolute(coupler.C, coupler.z, rocker.C, rocker.z);
        joint d = revolute(ground.D, ground.z, rocker.position, rocker.z);
        start d.angle = 100deg;
        drive motor = drive_rotation(a, 60rpm * t);
        output pin = rocker.C;
    }
}

#[test]
fn a_redundant_hinge_whose_axis_is_askew_in_its_bodies_holds_to_rounding() {
    // C is where the circles of coupler and rocker meet, by mpmath with 40 digits.
    let expected = [
        (0.0, [0.090_811_388_300_841_9, 0.128_439_512_009_063_18]),
        (0.1, [0.106_507_116_791_713_7, 0.134_567_340_429_356_66]),
        (0.37, [0.079_058_677_729_776_56, 0.122_341_034_794_349_76]),
    ];
    let askew = Askew::default();
    for (t, [x, y]) in expected {
        let state = askew.solve(t).expect("a state");
        let pin = askew.pin(&state).value;
        assert!((pin.x - x).abs() < 1e-15 && (pin.y - y).abs() < 1e-15 && pin.z.abs() < 1e-15, "{t}: {pin:?}");
    }
}
