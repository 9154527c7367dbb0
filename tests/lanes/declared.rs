//! Mechanisms used by these tests only.

use reuleaux::mechanism;

mechanism! {
    /// An oscillating crank; with an amplitude above 0.387 rad it reaches a dead point, where coupler and rocker are in line.
    pub mechanism Swing {
        param amplitude: Angle = 0.3 in ..=2rad;
        ground { point A = (0m, 0m);  point D = (1m, 0m); }
        body arm     { point A = (0m, 0m);  point B = (1m, 0m); }
        body coupler { point B = (0m, 0m);  point C = (0.6m, 0m);  start angle = -0.5; }
        body rocker  { point D = (0m, 0m);  point C = (0.6m, 0m);  start angle = 2.0; }
        joint a = revolute(ground.A, arm.A);
        joint b = revolute(arm.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        drive motor = drive_angle(arm, 0.9 + amplitude * sin(2 * pi * t / 1s));
    }
}

mechanism! {
    /// A Stephenson III six-bar driven at the far link, so that its loops must be solved together.
    pub mechanism Linkage {
        ground { point A = (0m, 0m);  point D = (4m, 0m);  point G = (6m, 1m); }
        body crank   { point A = (0m, 0m);  point B = (1m, 0m);  start angle = 60deg; }
        body coupler { point B = (0m, 0m);  point C = (3.5m, 0m);  point E = (1.8m, 1.2m);  start angle = 36deg; }
        body rocker  { point D = (0m, 0m);  point C = (3m, 0m);  start angle = 103deg; }
        body link    { point E = (0m, 0m);  point F = (4m, 0m);  start angle = 2deg; }
        body far     { point G = (0m, 0m);  point F = (2.2m, 0m);  start angle = 110deg; }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        joint e = revolute(coupler.E, link.E);
        joint f = revolute(link.F, far.F);
        joint g = revolute(far.G, ground.G);
        drive motor = drive_angle(far, 110deg + 0.02 * sin(2 * pi * t / 1s));
    }
}
