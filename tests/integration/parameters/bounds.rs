//! Declared bounds, and conditions of joints on parameters, are checked at run time.

use reuleaux::{Cause, ParameterOutOfRange, mechanism};

mechanism! {
    /// A slider-crank with bounds of every form, also in its parts.
    pub mechanism Bounded {
        param radius: Length = 30mm in 5mm..=50mm;
        param rod_length: Length = 100mm in 60mm..;
        param offset: Length = 0mm in -20mm..20mm;
        param speed: AngularVelocity = 60rpm in ..=100rad_s;
        for i in 0..3 { param trim[i]: Number = 1 in 0.5..2; }
        param away: Length = 1mm;

        ground { point O = (0mm, 0mm);  point S = (0mm, offset);  axis u = (1, 0); }
        body crank  { point A = (radius, 0mm); }
        body rod    { point B = (rod_length, 0mm); }
        body slider { start position = (130mm, 0mm); }
        body stone  { start position = (130mm, 50mm); }
        joint axle = revolute(ground.O, crank.position);
        joint pin = revolute(crank.A, rod.position);
        joint wrist = revolute(rod.B, slider.position);
        joint guide = translational(ground.u, ground.S, slider.position);
        joint link = distance(slider.position, stone.position, away * trim[2] + 49mm);
        joint level = absolute_angle(stone, 0);
        joint post = absolute_x(stone.position, 130mm);
        drive motor = drive_angle(crank, speed * t);
        range t in 0s..=0.1s;
        for i in 0..2 { part gear[i] = Gear(crank); }
        component Gear(turned_by: Body) {
            param teeth: Number = 20 in 10..=40;
            param count: Number = 30;
            body wheel {}
            joint axle = revolute((200mm, 0mm), wheel.position);
            joint mesh = gear_pair(turned_by, wheel, count, teeth);
        }
        let stroke = slider.x;
        slice output stroke = stroke;
    }
}

fn refused(change: impl Fn(&mut Bounded)) -> ParameterOutOfRange<f64> {
    let mut mechanism = Bounded::default();
    let from = mechanism.solve(0.0).expect("the defaults lie within their bounds");
    change(&mut mechanism);
    let refused = mechanism.validate().expect_err("a parameter is out of range");
    let same = |cause: Cause<f64>| match cause {
        // NaN is not equal to itself.
        Cause::ParameterOutOfRange(found) => assert_eq!(found.to_string(), refused.to_string()),
        other => panic!("{other:?}"),
    };
    same(mechanism.solve(0.1).expect_err("`solve` looks").cause);
    same(mechanism.solve_near(0.1, &from.q).expect_err("`solve_near` looks").cause);
    same(mechanism.solve_from(0.1, &from).expect_err("`solve_from` looks").cause);
    same(mechanism.sweep([0.0, 0.1]).next().expect("a failure").expect_err("`sweep` looks").cause);
    same(mechanism.prepared().solve(0.1).expect_err("prepared or not").cause);
    same(mechanism.solve_for_stroke().solve(0.1).expect_err("slices look").cause);
    refused
}

#[test]
fn what_lies_beyond_is_refused_by_name() {
    let refused = |change: &dyn Fn(&mut Bounded)| refused(change).to_string();
    assert_eq!(refused(&|m| m.radius = 0.06), "`radius` = 0.06 m: it must lie in 5 mm ..= 50 mm");
    assert_eq!(refused(&|m| m.radius = 0.004), "`radius` = 0.004 m: it must lie in 5 mm ..= 50 mm");
    assert_eq!(refused(&|m| m.rod_length = 0.059), "`rod_length` = 0.059 m: it must lie in 60 mm ..");
    assert_eq!(refused(&|m| m.offset = 0.02), "`offset` = 0.02 m: it must lie in -20 mm .. 20 mm");
    assert_eq!(refused(&|m| m.offset = -0.021), "`offset` = -0.021 m: it must lie in -20 mm .. 20 mm");
    assert_eq!(refused(&|m| m.speed = 100.5), "`speed` = 100.5 rad/s: it must lie in ..= 100 rad_s");
    assert_eq!(refused(&|m| m.trim[1] = 2.0), "`trim[1]` = 2: it must lie in 0.5 .. 2");
    assert_eq!(refused(&|m| m.gear[1].teeth = 41.0), "`gear[1].teeth` = 41: it must lie in 10 ..= 40");
}

#[test]
fn what_is_not_finite_is_refused_by_name() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = |change: &dyn Fn(&mut Bounded)| refused(change).to_string();
        assert_eq!(refused(&|m| m.rod_length = value), format!("`rod_length` = {value} m: it must be finite"));
        assert_eq!(refused(&|m| m.gear[0].teeth = value), format!("`gear[0].teeth` = {value}: it must be finite"));
    }
}

#[test]
fn what_joints_demand_is_refused_with_parameter_and_joint() {
    let refused = |change: &dyn Fn(&mut Bounded)| refused(change).to_string();
    let gear = "a gear without radius or teeth turns nothing: the ratio of a gear pair may not be zero";
    assert_eq!(refused(&|m| m.gear[1].count = 0.0), format!("`gear[1].count` = 0: {gear} (`gear[1].mesh.a`)"));
    let apart =
        "a distance of zero cannot be differentiated where it holds: use `revolute`, in space `spherical`, to keep two points together";
    assert_eq!(refused(&|m| m.away = -0.049), format!("`link.c` = 0 m: {apart} (it follows from `away`, `trim[2]`)"));
}

#[test]
fn the_ends_of_a_range_belong_to_it_as_rust_writes_them() {
    for radius in [0.005, 0.05] {
        assert!(Bounded { radius, ..Bounded::default() }.solve(0.1).is_ok());
    }
    assert!(Bounded { offset: -0.02, ..Bounded::default() }.solve(0.1).is_ok());
    assert!(Bounded { speed: -1e3, ..Bounded::default() }.validate().is_ok());
    assert!(Bounded { speed: 100.0, ..Bounded::default() }.validate().is_ok());
}

#[test]
fn failures_name_the_mechanism_as_well() {
    let failure = Bounded { radius: 0.06, ..Bounded::default() }.solve(0.0).expect_err("it is too long");
    assert_eq!(failure.to_string(), "`Bounded` cannot be solved with `radius` = 0.06 m: it must lie in 5 mm ..= 50 mm");
}

#[test]
fn single_precision_has_the_same_bounds() {
    let with = |radius| Bounded { radius, ..Bounded::<f32>::with_defaults() };
    assert!(with(0.05).validate().is_ok() && with(0.005).validate().is_ok());
    assert!(with(0.0501).validate().is_err() && with(0.0049).validate().is_err());
}
