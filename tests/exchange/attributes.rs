//! Attributes before a mechanism, its components and its parameters reach the generated structs.

use reuleaux::mechanism;

mechanism! {
    /// A driven crank.
    #[derive(PartialOrd)]
    #[cfg_attr(not(all()), derive(Unknown))]
    mechanism Crank {
        /// From the axle to the pin.
        param length: Length = 100mm;
        part weight = Weight(20mm);
        #[derive(PartialOrd)]
        component Weight(distance: Length) {
            param offset: Length = distance;
            body lump { point Q = (offset, 0mm); }
            joint pin = revolute(ground.position, lump.Q);
            drive turn = drive_angle(lump, 1rad_s * t);
        }
        body crank { point A = (length, 0mm); }
        joint pin = revolute(ground.position, crank.position);
        drive turn = drive_angle(crank, 1rad_s * t);
        output pin = crank.A;
    }
}

#[test]
fn a_derived_trait_is_implemented() {
    let (short, long) = (Crank::default(), Crank { length: 0.2, ..Crank::default() });
    assert!(short < long);
    assert!(CrankWeight { offset: 0.1 } < CrankWeight { offset: 0.2 });
}
