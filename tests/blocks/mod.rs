//! Mechanisms whose loops do not come apart: blocks of two to twelve unknowns.
//!
//! ```text
//!      C       C       C
//!   A══╧══B═A══╧══B═A══╧══B      plates pinned in a row, one rod more than needs be to hang each on, and two at the ends;
//!   │  │       │       │  │      the first rod stands on a crank
//! ```
//!
//! Rods are distances, so that the first place and all angles of the plates are found together: plates + 2 unknowns.

use crate::declared;

declared! {
    /// A four-bar.
    Loop (crank_length: Length = 0.5, coupler_length: Length = 1.5, rocker_length: Length = 1.2) {
        ground { point O = (0, 0);  point C = (1.6, 0); }
        body crank   { point O = (0, 0);  point A = (crank_length, 0); }
        body coupler { point A = (0, 0);  point B = (coupler_length, 0); }
        body rocker  { point C = (0, 0);  point B = (rocker_length, 0);  start angle = 1.8; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// One plate on three rods.
    Plate (
        rod_1: Length = 1.517, rod_2: Length = 1.331, rod_3: Length = 1.571
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (-0.8, 0.9);  point G3 = (2.1, 1.3); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        joint o = revolute(ground.O, crank.O);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_1.B, rod_3);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Two plates in a row on four rods.
    TwoPlates (
        rod_1: Length = 1.517, rod_2: Length = 0.947, rod_3: Length = 1.454, rod_4: Length = 1.609
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (-0.2, 1.1);  point G3 = (2.8, 1.1);  point G4 = (0.7, -1); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.2; }
        joint o = revolute(ground.O, crank.O);
        joint pin_1 = revolute(plate_1.B, plate_2.A);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_2.C, rod_3);
        joint r4 = distance(ground.G4, plate_2.B, rod_4);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Three plates on five rods.
    ThreePlates (
        rod_1: Length = 1.517, rod_2: Length = 2.037, rod_3: Length = 1.007, rod_4: Length = 1.624, rod_5: Length = 1.533
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (1.7, -1.2);  point G3 = (2.4, 0.9);  point G4 = (3.8, 1.2);
                 point G5 = (1.7, 1.1); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.2; }
        body plate_3 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (2, 0);  start angle = 0.2; }
        joint o = revolute(ground.O, crank.O);
        joint pin_1 = revolute(plate_1.B, plate_2.A);
        joint pin_2 = revolute(plate_2.B, plate_3.A);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_2.C, rod_3);
        joint r4 = distance(ground.G4, plate_3.C, rod_4);
        joint r5 = distance(ground.G5, plate_3.B, rod_5);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Four plates on six rods.
    FourPlates (
        rod_1: Length = 1.517, rod_2: Length = 1.168, rod_3: Length = 1.408, rod_4: Length = 1.074, rod_5: Length = 1.96,
        rod_6: Length = 1.541
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (-0.5, 1.1);  point G3 = (2.8, 1);  point G4 = (3.2, 1.1);
                 point G5 = (2.7, -1.4);  point G6 = (5, 1.1); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.2; }
        body plate_3 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (2, 0);  start angle = 0.2; }
        body plate_4 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (3, 0);  start angle = -0.2; }
        joint o = revolute(ground.O, crank.O);
        joint pin_1 = revolute(plate_1.B, plate_2.A);
        joint pin_2 = revolute(plate_2.B, plate_3.A);
        joint pin_3 = revolute(plate_3.B, plate_4.A);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_2.C, rod_3);
        joint r4 = distance(ground.G4, plate_3.C, rod_4);
        joint r5 = distance(ground.G5, plate_4.C, rod_5);
        joint r6 = distance(ground.G6, plate_4.B, rod_6);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Six plates on eight rods.
    SixPlates (
        rod_1: Length = 1.517, rod_2: Length = 1.09, rod_3: Length = 1.408, rod_4: Length = 1.91, rod_5: Length = 1.721,
        rod_6: Length = 1.348, rod_7: Length = 2.025, rod_8: Length = 1.259
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (-0.4, 1.1);  point G3 = (2.8, 1);  point G4 = (1.2, -1.1);
                 point G5 = (4.5, -1);  point G6 = (5.6, 0.9);  point G7 = (4.2, -1.2);  point G8 = (5.5, -1.2); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.2; }
        body plate_3 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (2, 0);  start angle = 0.2; }
        body plate_4 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (3, 0);  start angle = -0.2; }
        body plate_5 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (4, 0);  start angle = 0.2; }
        body plate_6 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (5, 0);  start angle = -0.2; }
        joint o = revolute(ground.O, crank.O);
        joint pin_1 = revolute(plate_1.B, plate_2.A);
        joint pin_2 = revolute(plate_2.B, plate_3.A);
        joint pin_3 = revolute(plate_3.B, plate_4.A);
        joint pin_4 = revolute(plate_4.B, plate_5.A);
        joint pin_5 = revolute(plate_5.B, plate_6.A);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_2.C, rod_3);
        joint r4 = distance(ground.G4, plate_3.C, rod_4);
        joint r5 = distance(ground.G5, plate_4.C, rod_5);
        joint r6 = distance(ground.G6, plate_5.C, rod_6);
        joint r7 = distance(ground.G7, plate_6.C, rod_7);
        joint r8 = distance(ground.G8, plate_6.B, rod_8);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Ten plates on twelve rods.
    TenPlates (
        rod_1: Length = 1.517, rod_2: Length = 1.456, rod_3: Length = 1.573, rod_4: Length = 1.849, rod_5: Length = 1.219,
        rod_6: Length = 1.464, rod_7: Length = 1.6, rod_8: Length = 1.516, rod_9: Length = 1.607, rod_10: Length = 0.81,
        rod_11: Length = 1.421, rod_12: Length = 1.641
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (1.1, -0.9);  point G3 = (0.8, -1);  point G4 = (1.3, -1.1);
                 point G5 = (4, 1.5);  point G6 = (5.5, 1.3);  point G7 = (5.3, -1.2);  point G8 = (7.7, 1);
                 point G9 = (7.2, -1.2);  point G10 = (8.2, 1.2);  point G11 = (8.2, 1.2);  point G12 = (8.8, -1.3); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.2; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.2; }
        body plate_3 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (2, 0);  start angle = 0.2; }
        body plate_4 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (3, 0);  start angle = -0.2; }
        body plate_5 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (4, 0);  start angle = 0.2; }
        body plate_6 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (5, 0);  start angle = -0.2; }
        body plate_7 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (6, 0);  start angle = 0.2; }
        body plate_8 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (7, 0);  start angle = -0.2; }
        body plate_9 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (8, 0);  start angle = 0.2; }
        body plate_10 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (9, 0);  start angle = -0.2; }
        joint o = revolute(ground.O, crank.O);
        joint pin_1 = revolute(plate_1.B, plate_2.A);
        joint pin_2 = revolute(plate_2.B, plate_3.A);
        joint pin_3 = revolute(plate_3.B, plate_4.A);
        joint pin_4 = revolute(plate_4.B, plate_5.A);
        joint pin_5 = revolute(plate_5.B, plate_6.A);
        joint pin_6 = revolute(plate_6.B, plate_7.A);
        joint pin_7 = revolute(plate_7.B, plate_8.A);
        joint pin_8 = revolute(plate_8.B, plate_9.A);
        joint pin_9 = revolute(plate_9.B, plate_10.A);
        joint r1 = distance(crank.T, plate_1.A, rod_1);
        joint r2 = distance(ground.G2, plate_1.C, rod_2);
        joint r3 = distance(ground.G3, plate_2.C, rod_3);
        joint r4 = distance(ground.G4, plate_3.C, rod_4);
        joint r5 = distance(ground.G5, plate_4.C, rod_5);
        joint r6 = distance(ground.G6, plate_5.C, rod_6);
        joint r7 = distance(ground.G7, plate_6.C, rod_7);
        joint r8 = distance(ground.G8, plate_7.C, rod_8);
        joint r9 = distance(ground.G9, plate_8.C, rod_9);
        joint r10 = distance(ground.G10, plate_9.C, rod_10);
        joint r11 = distance(ground.G11, plate_10.C, rod_11);
        joint r12 = distance(ground.G12, plate_10.B, rod_12);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// A plate on three bars, one of them standing on a crank: Stephenson's third linkage driven where it does not come apart.
    Triad (bar_1_length: Length = 1.3, bar_2_length: Length = 1.5, bar_3_length: Length = 1.5) {
        ground { point O = (-0.5, -1.5);  point G2 = (1.2, -1.1);  point G3 = (1.5, -1.3); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.1; }
        body bar_1 { point G = (0, 0);  point P = (bar_1_length, 0); }
        body bar_2 { point G = (0, 0);  point P = (bar_2_length, 0); }
        body bar_3 { point G = (0, 0);  point P = (bar_3_length, 0); }
        joint o = revolute(ground.O, crank.O);
        joint g1 = revolute(crank.T, bar_1.G);
        joint g2 = revolute(ground.G2, bar_2.G);
        joint g3 = revolute(ground.G3, bar_3.G);
        joint p1 = revolute(bar_1.P, plate.A);
        joint p2 = revolute(bar_2.P, plate.C);
        joint p3 = revolute(bar_3.P, plate.B);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
declared! {
    /// Two plates pinned to each other on four bars.
    DoubleTriad (
        bar_1_length: Length = 1.3, bar_2_length: Length = 1.5, bar_3_length: Length = 1.5, bar_4_length: Length = 1.5
    ) {
        ground { point O = (-0.5, -1.5);  point G2 = (1.2, -1.1);  point G3 = (0.6, -1);  point G4 = (2.5, -1.3); }
        body crank { point O = (0, 0);  point T = (0.1, 0); }
        body plate_1 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (0, 0);  start angle = 0.1; }
        body plate_2 { point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);  start position = (1, 0);  start angle = -0.1; }
        body bar_1 { point G = (0, 0);  point P = (bar_1_length, 0); }
        body bar_2 { point G = (0, 0);  point P = (bar_2_length, 0); }
        body bar_3 { point G = (0, 0);  point P = (bar_3_length, 0); }
        body bar_4 { point G = (0, 0);  point P = (bar_4_length, 0); }
        joint o = revolute(ground.O, crank.O);
        joint pin = revolute(plate_1.B, plate_2.A);
        joint g1 = revolute(crank.T, bar_1.G);
        joint g2 = revolute(ground.G2, bar_2.G);
        joint g3 = revolute(ground.G3, bar_3.G);
        joint g4 = revolute(ground.G4, bar_4.G);
        joint p1 = revolute(bar_1.P, plate_1.A);
        joint p2 = revolute(bar_2.P, plate_1.C);
        joint p3 = revolute(bar_3.P, plate_2.C);
        joint p4 = revolute(bar_4.P, plate_2.B);
        drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
    }
}
