//! Rows of the library that are constant multiples of the reference's rows.

use reuleaux_tests::common::declared::Rows;
use reuleaux_tests::common::reference::{Value, list, number};
use reuleaux_tests::units::{self, rows_of};

use super::{all, cases, instant, share};

/// Length of a constraint's axis.
fn length(constraint: &Value) -> f64 {
    number(&constraint["axis_i"][0]).hypot(number(&constraint["axis_i"][1]))
}

/// A row multiplied by a number.
fn scaled(rows: &Rows, row: usize, factor: f64) -> Rows {
    let times = |value: &f64| vec![value * factor];
    let jacobian = rows.jacobian[row].iter().map(|entry| entry * factor).collect();
    Rows { phi: times(&rows.phi[row]), jacobian: vec![jacobian], nu: times(&rows.nu[row]), gamma: times(&rows.gamma[row]) }
}

#[test]
fn first_row_of_translational_is_the_reference_over_the_length_of_the_axis() {
    for case in cases("translational") {
        let rows = units::translational::rows(&case["constraint"], &instant(&case));
        share(&case, &scaled(&rows, 0, length(&case["constraint"])), &[0]);
    }
}

#[test]
fn point_on_line_is_the_reference_over_the_length_of_the_axis() {
    for case in cases("point_on_line") {
        let rows = units::point_on_line::rows(&case["constraint"], &instant(&case));
        share(&case, &scaled(&rows, 0, length(&case["constraint"])), &[0]);
    }
}

#[test]
fn planetary_train_and_crossed_belt_on_ground_are_relations_of_two_angles() {
    for case in cases("angle_relation").iter().filter(|case| list(&case["bodies"]).len() == 2) {
        share(case, &rows_of::<units::PlanetaryOnGround>(&case["constraint"], &instant(case)), &all(case));
        share(case, &rows_of::<units::BeltOnGround>(&case["constraint"], &instant(case)), &all(case));
    }
}
