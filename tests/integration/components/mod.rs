//! Components, parts, loops and arrays against the same mechanism written out.

mod imported;
mod many;
mod walker;

use reuleaux::Description;
use walker::{Walker, WalkerKnee, WalkerLeg, WrittenOut};

/// The walker with a longer shin in its second leg, in both forms.
fn walkers() -> (Walker, WrittenOut) {
    let mut walker = Walker { speed: 2.0, ..Default::default() };
    walker.leg[1].shin = 0.0401;
    walker.leg[0].knee.calf[1] = 0.045;
    (walker, WrittenOut { speed: 2.0, shin_1: 0.0401, calf_01: 0.045, ..Default::default() })
}

#[test]
fn a_component_is_what_one_would_write_out() {
    let (walker, written) = walkers();
    assert_eq!(walker.start(), written.start());
    let times = || (0..=40).map(|step| f64::from(step) / 10.0);
    for (one, two) in walker.sweep(times()).zip(written.sweep(times())) {
        let (one, two) = (one.expect("the walker walks"), two.expect("the walker walks"));
        assert_eq!((one.q, one.qd, one.qdd), (two.q, two.qd, two.qdd));
        assert_eq!(walker.leg_knee_toe(&one), [written.toe_0(&two), written.toe_1(&two)]);
        assert_eq!(walker.leg_knee_angle(&one), [written.angle_0(&two), written.angle_1(&two)]);
        assert_eq!(walker.leg_knee_foot(&one), [two.foot_0(), two.foot_1()]);
        assert_eq!(one.leg()[1].knee().bar()[1], two.bar_c_1());
        for (leg, foot) in one.leg().into_iter().zip([two.foot_0(), two.foot_1()]) {
            assert_eq!(leg.knee().foot(), foot);
        }
        assert_eq!((one.crank(), one.leg()[0].upper()), (two.crank(), two.upper_0()));
    }
    let (one, two) = (walker.solve(1.0).expect("the walker walks"), written.solve(1.0).expect("the walker walks"));
    assert_eq!((walker.phi(&one.q, 1.0), walker.jacobian(&one.q, 1.0)), (written.phi(&two.q, 1.0), written.jacobian(&two.q, 1.0)));
    assert_eq!(
        (walker.nu(&one.q, 1.0), walker.gamma(&one.q, &one.qd, 1.0)),
        (written.nu(&two.q, 1.0), written.gamma(&two.q, &two.qd, 1.0))
    );
}

#[test]
fn items_of_parts_are_called_by_the_way_to_them() {
    let coordinates: Vec<&str> =
        <Walker as Description<f64, 39>>::COORDINATES.iter().step_by(3).map(|coordinate| coordinate.body).collect();
    assert_eq!(coordinates[..4], ["crank", "leg[0].bar_j", "leg[0].upper", "leg[0].knee.bar[0]"]);
    assert_eq!(coordinates[12], "leg[1].knee.foot");
    let rows: Vec<&str> = <Walker as Description<f64, 39>>::ROWS.iter().map(|row| row.joint).collect();
    assert_eq!((rows[3], rows[10], rows[38]), ("leg[0].x", "leg[0].knee.x", "leg[1].knee.g"));
}

#[test]
fn parameters_of_parts_have_defaults_of_their_own() {
    let walker = Walker::default();
    assert_eq!(walker.leg, [WalkerLeg::default(); 2]);
    assert_eq!(walker.leg[0].knee, WalkerKnee { calf: [0.036, 0.044] });
    assert_eq!(walker, Walker::<f64>::with_defaults());
}

#[test]
fn a_parameter_of_a_part_is_named_when_it_is_out_of_range() {
    let mut walker = Walker::default();
    walker.leg[1].knee.calf[1] = f64::NAN;
    assert_eq!(walker.validate().map_err(|refused| refused.name), Err("leg[1].knee.calf[1]"));
}
