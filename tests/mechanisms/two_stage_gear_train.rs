//! `two_stage_gear_train.json`, with the second mesh written in two ways.

use crate::declared;

declared! {
    /// Compound gear train; the second mesh turns with its line of centres, as in the file.
    TwoStageGearTrain (r1: Length = 0.04, r2: Length = 0.12, r3: Length = 0.036, r4: Length = 0.108) {
        ground { point A = (0, 0);  point B = (0.16, 0);  point C = (0.16, 0.144); }
        body g1 { point A = (0, 0);  start angle = 0.3; }
        body g2 { point B = (0, 0);  start angle = -0.2; }
        body g3 { point B = (0, 0);  start angle = 0.5; }
        body g4 { point C = (0, 0);  point K = (0.108, 0);  start angle = 3.84; }
        joint a = revolute(ground.A, g1.A);
        joint b = revolute(ground.B, g2.B);
        joint shaft = weld(g2.B, g3.B, 0.7);
        joint c = revolute(ground.C, g4.C);
        joint first = gear_pair(g1, g2, r1, r2, c: r1 * 0.3 + r2 * -0.2);
        joint second = {
            let along = (r3 * (g3.angle + 0.4) + r4 * (g4.angle + 1.1) - r4 * pi) / (r3 + r4);
            (g4.C - g3.B).x * sin(along) == (g4.C - g3.B).y * cos(along);
        }
        drive motor = drive_relative_angle(ground, g1, 0.3 + 3rad_s * t + 0.25 * (t / 1s)^3 + 0.5 * sin(4rad_s * t));
    } outputs TwoStageGearTrainState {
        interest = [g4.K];
        ratio = [g4.angle / g1.angle];
    }
}

declared! {
    /// The same train with both meshes as `gear_pair`: on ground, the line of the second centres has the angle π/2.
    GearTrainOfPairs (r1: Length = 0.04, r2: Length = 0.12, r3: Length = 0.036, r4: Length = 0.108) {
        ground { point A = (0, 0);  point B = (0.16, 0);  point C = (0.16, 0.144); }
        body g1 { point A = (0, 0); }
        body g2 { point B = (0, 0); }
        body g3 { point B = (0, 0); }
        body g4 { point C = (0, 0);  point K = (0.108, 0); }
        joint a = revolute(ground.A, g1.A);
        joint b = revolute(ground.B, g2.B);
        joint shaft = weld(g2.B, g3.B, 0.7);
        joint c = revolute(ground.C, g4.C);
        joint first = gear_pair(g1, g2, r1, r2, c: r1 * 0.3 + r2 * -0.2);
        joint second = gear_pair(g3, g4, r3, r4, c: (r3 + r4) * pi / 2 - r3 * 0.4 - r4 * 1.1 + r4 * pi);
        drive motor = drive_relative_angle(ground, g1, 0.3 + 3rad_s * t + 0.25 * (t / 1s)^3 + 0.5 * sin(4rad_s * t));
    } outputs GearTrainOfPairsState {
        interest = [g4.K];
    }
}
