//! `hydraulic_loader.json`

use crate::declared;

declared! {
    /// Front loader with a Z-bar linkage and two cylinders.
    HydraulicLoader (lift: Length = 1.55, lift_stroke: Length = 0.3, tilt: Length = 1.35, tilt_stroke: Length = 0.12) {
        ground { point P = (0, 0);  point L = (0.1, -0.9);  point T = (0.35, 0.25); }
        body boom {
            point P = (0, 0);  point L = (1.2, -0.15);  point K = (1.5, 0.2);  point Q = (2.6, -0.3);
            start angle = -0.0419;
        }
        body barrel    { point L = (0, 0);  axis along = (1, 0);  start position = (0.1, -0.9);  start angle = 0.57; }
        body rod       { point L = (0, 0);  start position = (1.19, -0.2);  start angle = 0.57; }
        body bellcrank { point K = (0, 0);  point T = (0, 0.55);  point R = (0.05, -0.5);  start angle = -0.356; }
        body link      { point R = (0, 0);  point B = (1.05, 0);  start angle = 0.291; }
        body bucket    { point Q = (0, 0);  point B = (-0.1, 0.4);  point E = (1, -0.1);  start angle = 0.26; }
        joint p = revolute(ground.P, boom.P);
        joint l1 = revolute(ground.L, barrel.L);
        joint l2 = revolute(boom.L, rod.L);
        joint cylinder = translational(barrel.along, barrel.L, rod.L);
        joint k = revolute(boom.K, bellcrank.K);
        joint r = revolute(bellcrank.R, link.R);
        joint b = revolute(link.B, bucket.B);
        joint q = revolute(boom.Q, bucket.Q);
        drive lifting = drive_distance(ground.L, boom.L, lift + lift_stroke * sin(0.8rad_s * t - 1));
        drive tilting = drive_distance(ground.T, bellcrank.T, tilt + tilt_stroke * sin(1.6rad_s * t + 0.5));
    } outputs HydraulicLoaderState {
        interest = [bucket.E];
        edge = [direction(bucket.E - bucket.Q)];
        reach = [norm(bucket.E - ground.P)];
    }
}
