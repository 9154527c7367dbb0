//! Evaluated by emitted code, with all numbers as parameters.

use reuleaux_tests::common::declared::{Instant, Rows};
use reuleaux_tests::common::reference::Value;
use reuleaux_tests::units::{self, rows_of};

use super::{all, cases, instant, share};

fn check(of: &str, rows: impl Fn(&Value, &Instant) -> Rows) {
    let share = cases(of).iter().map(|case| share(case, &rows(&case["constraint"], &instant(case)), &all(case))).fold(0.0, f64::max);
    println!("{of}: largest error {share:.2} of what is allowed");
}

macro_rules! is_the_reference {
    ($($test:ident: $kind:literal, $rows:expr;)*) => {
        $(
            #[test]
            fn $test() {
                check($kind, $rows);
            }
        )*
        /// Every type in the file is tested above.
        #[test]
        fn no_type_is_left_out() {
            let file = reuleaux_tests::common::reference::file("unit_constraints.json");
            for kind in file["formulas"].as_object().unwrap().keys() {
                assert!([$($kind),*].contains(&kind.as_str()), "{kind}");
            }
        }
    };
}

is_the_reference! {
    absolute_x_is_the_reference: "absolute_x", rows_of::<units::AbsoluteX>;
    absolute_y_is_the_reference: "absolute_y", rows_of::<units::AbsoluteY>;
    absolute_angle_is_the_reference: "absolute_angle", rows_of::<units::AbsoluteAngle>;
    absolute_distance_is_the_reference: "absolute_distance", rows_of::<units::AbsoluteDistance>;
    drive_x_is_the_reference: "driver_absolute_x", rows_of::<units::DriveX>;
    drive_y_is_the_reference: "driver_absolute_y", rows_of::<units::DriveY>;
    drive_angle_is_the_reference: "driver_absolute_angle", rows_of::<units::DriveAngle>;
    drive_relative_angle_is_the_reference: "driver_relative_angle", units::drive_relative_angle::rows;
    drive_distance_is_the_reference: "driver_relative_distance", units::drive_distance::rows;
    revolute_is_the_reference: "revolute", units::revolute::rows;
    slider_defined_by_the_user_is_the_reference: "translational", units::haug_translational::rows;
    distance_is_the_reference: "revolute_revolute", units::distance::rows;
    revolute_translational_is_the_reference: "revolute_translational", units::revolute_translational::rows;
    pin_in_slot_defined_by_the_user_is_the_reference: "point_on_line", units::haug_point_on_line::rows;
    weld_is_the_reference: "weld", units::weld::rows;
    gear_pair_is_the_reference: "gear_pair", units::gear_pair::rows;
    moving_gears_defined_by_the_user_are_the_reference: "gear_pair_centers", units::moving_gears::rows;
    rack_pinion_is_the_reference: "rack_pinion", units::rack_pinion::rows;
    angle_relation_is_the_reference: "angle_relation", units::angle_relation;
}
