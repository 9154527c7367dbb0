//! `slider_crank.json`

use crate::declared;

declared! {
    /// Offset slider-crank whose crank speeds up.
    SliderCrank (
        rod_length: Length = 0.26, offset: Length = 0.02,
        speed: AngularVelocity = 6.283185307179586, acceleration: AngularAcceleration = 0.5
    ) {
        ground { point O = (0, 0);  point G = (0, offset);  axis along = (1, 0); }
        body crank  { point O = (-0.06, 0);  point A = (0.06, 0);  start angle = 0; }
        body rod    { point A = (-0.1, 0);   point B = (rod_length - 0.1, 0);  point K = (0.05, 0.03);  start angle = 0.077; }
        body slider { point B = (0, 0);      start position = (0.379, 0.02); }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slider.B);
        joint slide = translational(ground.along, ground.G, slider.B);
        drive motor = drive_relative_angle(ground, crank, speed * t + acceleration * t^2);
    } outputs SliderCrankState {
        interest = [rod.K];
        stroke = [slider.x];
    }
}
