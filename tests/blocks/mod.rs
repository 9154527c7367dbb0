//! Mechanisms with loops that cannot be solved separately: blocks of two to twelve unknowns.
//!
//! ```text
//!      C       C       C
//!   A══╧══B═A══╧══B═A══╧══B      plates pinned in a row: one rod for each plate, and one at either end;
//!   │  │       │       │  │      the first rod stands on a crank
//! ```
//!
//! Rods are distances, so that the first position and all angles of the plates are solved together: plates + 2 unknowns.

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
/// Plates in a row: the first rod stands on the crank, one hangs on each plate, given with its pivot in ground, and one on the end.
macro_rules! plates {
    (
        $(#[$doc:meta])*
        $name:ident, last $last:literal: $first:ident = $first_length:literal;
        $($plate:literal: $rod:ident = $length:literal at ($x:literal, $y:literal),)*
        end: $end:ident = $end_length:literal at ($end_x:literal, $end_y:literal)
    ) => {
        declared! {
            $(#[$doc])*
            $name ($first: Length = $first_length, $($rod: Length = $length,)* $end: Length = $end_length) {
                ground { point O = (-0.5, -1.5); }
                body crank { point O = (0, 0);  point T = (0.1, 0); }
                for i in 0..=$last {
                    body plate[i] {
                        point A = (0, 0);  point B = (1, 0);  point C = (0.5, 0.3);
                        start position = (i * 1m, 0);  start angle = 0.2 * cos(pi * i);
                    }
                }
                joint o = revolute(ground.O, crank.O);
                for i in 0..$last { joint pin[i] = revolute(plate[i].B, plate[i + 1].A); }
                joint foot = distance(crank.T, plate[0].A, $first);
                $(joint hanger[$plate] = distance(($x, $y), plate[$plate].C, $rod);)*
                joint stay = distance(($end_x, $end_y), plate[$last].B, $end);
                drive motor = drive_angle(crank, 0.4 + 1rad_s * t);
            }
        }
    };
}

plates! {
    /// Two plates in a row on four rods.
    TwoPlates, last 1: rod_1 = 1.517;
    0: rod_2 = 0.947 at (-0.2, 1.1),
    1: rod_3 = 1.454 at (2.8, 1.1),
    end: rod_4 = 1.609 at (0.7, -1)
}
plates! {
    /// Three plates on five rods.
    ThreePlates, last 2: rod_1 = 1.517;
    0: rod_2 = 2.037 at (1.7, -1.2),
    1: rod_3 = 1.007 at (2.4, 0.9),
    2: rod_4 = 1.624 at (3.8, 1.2),
    end: rod_5 = 1.533 at (1.7, 1.1)
}
plates! {
    /// Four plates on six rods.
    FourPlates, last 3: rod_1 = 1.517;
    0: rod_2 = 1.168 at (-0.5, 1.1),
    1: rod_3 = 1.408 at (2.8, 1),
    2: rod_4 = 1.074 at (3.2, 1.1),
    3: rod_5 = 1.96 at (2.7, -1.4),
    end: rod_6 = 1.541 at (5, 1.1)
}
plates! {
    /// Six plates on eight rods.
    SixPlates, last 5: rod_1 = 1.517;
    0: rod_2 = 1.09 at (-0.4, 1.1),
    1: rod_3 = 1.408 at (2.8, 1),
    2: rod_4 = 1.91 at (1.2, -1.1),
    3: rod_5 = 1.721 at (4.5, -1),
    4: rod_6 = 1.348 at (5.6, 0.9),
    5: rod_7 = 2.025 at (4.2, -1.2),
    end: rod_8 = 1.259 at (5.5, -1.2)
}
plates! {
    /// Ten plates on twelve rods.
    TenPlates, last 9: rod_1 = 1.517;
    0: rod_2 = 1.456 at (1.1, -0.9),
    1: rod_3 = 1.573 at (0.8, -1),
    2: rod_4 = 1.849 at (1.3, -1.1),
    3: rod_5 = 1.219 at (4, 1.5),
    4: rod_6 = 1.464 at (5.5, 1.3),
    5: rod_7 = 1.6 at (5.3, -1.2),
    6: rod_8 = 1.516 at (7.7, 1),
    7: rod_9 = 1.607 at (7.2, -1.2),
    8: rod_10 = 0.81 at (8.2, 1.2),
    9: rod_11 = 1.421 at (8.2, 1.2),
    end: rod_12 = 1.641 at (8.8, -1.3)
}
declared! {
    /// A plate on three bars, one on a crank: Stephenson's third linkage, driven so that its loops cannot be solved separately.
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
