//! `four_bar_crank_rocker.json`

use crate::declared;

declared! {
    /// Grashof crank-rocker with a ripple in the crank's speed.
    FourBarCrankRocker (
        crank_length: Length = 0.1, speed: AngularVelocity = 1.5, ripple: Angle = 0.1
    ) {
        ground { point A = (0, 0);  point D = (0.2, 0); }
        body crank   { point A = (0, 0);      point B = (crank_length, 0);  start angle = 0.525; }
        body coupler { point B = (-0.15, 0);  point C = (0.15, 0);  point K = (0.05, 0.1);  start angle = 0.283; }
        body rocker  { point D = (0, 0);      point C = (0.22, 0);  start angle = 0.654; }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        drive motor = drive_relative_angle(ground, crank, 0.5 + speed * t + ripple * sin(3rad_s * t + 0.25));
    } outputs FourBarCrankRockerState {
        interest = [coupler.K];
        transmission = [rocker.angle - coupler.angle];
    }
}
