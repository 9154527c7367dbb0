//! The families of `reference/stress`: one declaration for all cases of a topology, with its numbers as parameters.
//!
//! A parameter is named by its place in the model: `coupler_C_x` is the first coordinate of the coupler's point C, `c1` the coefficient
//! of t in the law of the drive.

use crate::common::declared::Declared;
use crate::common::reference::{Value, list, number, text};
use crate::declared;

declared! {
    /// A four-bar driven at its crank.
    FourBar (
        ground_A_x: Length = 0, ground_A_y: Length = 0, ground_D_x: Length = 0.2, ground_D_y: Length = 0,
        crank_B_x: Length = 0.1, coupler_C_x: Length = 0.25, rocker_C_x: Length = 0.2, c0: Angle = 0.9, c1: AngularVelocity = 1
    ) {
        ground { point A = (ground_A_x, ground_A_y);  point D = (ground_D_x, ground_D_y); }
        body crank   { point A = (0, 0);  point B = (crank_B_x, 0); }
        body coupler { point B = (0, 0);  point C = (coupler_C_x, 0); }
        body rocker  { point D = (0, 0);  point C = (rocker_C_x, 0);  start angle = 1.1; }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        drive motor = drive_relative_angle(ground, crank, c0 + c1 * t);
    }
}
declared! {
    /// A four-bar driven at its rocker.
    #[closure(start)]
    RockerDrivenFourBar (
        ground_D_x: Length = 4.5, crank_B_x: Length = 1, coupler_C_x: Length = 4, rocker_C_x: Length = 2.5,
        c0: Angle = 1.7, c1: AngularVelocity = 1
    ) {
        ground { point A = (0, 0);  point D = (ground_D_x, 0); }
        body crank   { point A = (0, 0);  point B = (crank_B_x, 0);  start angle = 1; }
        body coupler { point B = (0, 0);  point C = (coupler_C_x, 0);  start angle = 0.5; }
        body rocker  { point D = (0, 0);  point C = (rocker_C_x, 0); }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        drive motor = drive_relative_angle(ground, rocker, c0 + c1 * t);
    }
}
declared! {
    /// Two bars between a pivot and a driven slider.
    Dyad (bar1_B_x: Length = 1, bar2_C_x: Length = 0.7, c0: Length = 1.2, c1: Velocity = 1) {
        ground { point A = (0, 0);  axis rail = (1, 0); }
        body bar1   { point A = (0, 0);  point B = (bar1_B_x, 0);  start angle = -0.6; }
        body bar2   { point B = (0, 0);  point C = (bar2_C_x, 0);  start angle = 0.8; }
        body slider { point C = (0, 0); }
        joint a = revolute(ground.A, bar1.A);
        joint b = revolute(bar1.B, bar2.B);
        joint c = revolute(bar2.C, slider.C);
        joint guide = translational(ground.rail, ground.A, slider.C);
        drive motor = drive_x(slider.C, c0 + c1 * t);
    }
}
declared! {
    /// A small crank and four-bar that drive a large slider-crank.
    SmallAndLarge (
        ground_D_x: Length = 1.2, crank_B_x: Length = 0.1, coupler_C_x: Length = 1, rocker_C_x: Length = 0.9,
        rocker_F_x: Length = 10, rod_S_x: Length = 15, c0: Angle = 0.8, c1: AngularVelocity = 1
    ) {
        ground { point A = (0, 0);  point D = (ground_D_x, 0);  axis rail = (1, 0); }
        body crank   { point A = (0, 0);  point B = (crank_B_x, 0); }
        body coupler { point B = (0, 0);  point C = (coupler_C_x, 0);  start angle = 0.8; }
        body rocker  { point D = (0, 0);  point C = (rocker_C_x, 0);  point F = (rocker_F_x, 0);  start angle = 2.2; }
        body rod     { point F = (0, 0);  point S = (rod_S_x, 0);  start angle = -0.6; }
        body slider  { point S = (0, 0); }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        joint f = revolute(rocker.F, rod.F);
        joint s = revolute(rod.S, slider.S);
        joint guide = translational(ground.rail, ground.D, slider.S);
        drive motor = drive_relative_angle(ground, crank, c0 + c1 * t);
    }
}
declared! {
    /// A block on a rail at a driven distance.
    Rail (c0: Length = 0.5, c1: Velocity = 1) {
        ground { point O = (0, 0);  axis rail = (1, 0); }
        body block { point B = (0, 0);  start x = 0.5; }
        joint guide = translational(ground.rail, ground.O, block.B);
        drive motor = drive_distance(ground.O, block.B, c0 + c1 * t);
    }
}
declared! {
    /// An arm whose end is at a driven distance.
    Arm (ground_P_x: Length = 1, arm_E_x: Length = 1, c0: Length = 0.5, c1: Velocity = 1) {
        ground { point O = (0, 0);  point P = (ground_P_x, 0); }
        body arm { point P = (0, 0);  point E = (arm_E_x, 0);  start angle = 2.6; }
        joint p = revolute(ground.P, arm.P);
        drive motor = drive_distance(ground.O, arm.E, c0 + c1 * t);
    }
}
declared! {
    /// A slider-crank in line.
    InLineSliderCrank (crank_A_x: Length = 1, rod_B_x: Length = 1.5, c0: Angle = 0.5, c1: AngularVelocity = 1) {
        ground { point O = (0, 0);  axis rail = (1, 0); }
        body crank  { point O = (0, 0);  point A = (crank_A_x, 0); }
        body rod    { point A = (0, 0);  point B = (rod_B_x, 0);  start angle = -0.3; }
        body slider { point B = (0, 0); }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slider.B);
        joint guide = translational(ground.rail, ground.O, slider.B);
        drive motor = drive_relative_angle(ground, crank, c0 + c1 * t);
    }
}

/// The mechanism with the numbers of a model.
///
/// # Panics
/// If the model has other points or another law than the declaration.
pub fn of<D: Declared>(model: &Value) -> D {
    let coefficients = &model["drivers"][0]["f"]["coeffs"];
    assert_eq!(list(coefficients).len(), 2, "a linear law: {}", model["drivers"]);
    D::with(&mut |name| match name {
        "c0" => number(&coefficients[0]),
        "c1" => number(&coefficients[1]),
        _ => coordinate(model, name),
    })
}

/// `coupler_C_x`
fn coordinate(model: &Value, name: &str) -> f64 {
    let parts: Vec<&str> = name.split('_').collect();
    let axis = if parts[2] == "x" { 0 } else { 1 };
    if parts[0] == "ground" {
        return number(&model["ground_points"][parts[1]][axis]);
    }
    let body = list(&model["bodies"]).iter().find(|body| text(&body["name"]) == parts[0]);
    number(&body.unwrap_or_else(|| panic!("no body for `{name}`"))["points"][parts[1]][axis])
}
