//! The workloads: W1 four-bar, W2 slider-crank, W3 Jansen's leg, W4 a chain of four-bars.

use reuleaux::mechanism;

mechanism! {
    /// W1: ground 4, crank 1, coupler 3.5, rocker 3; one turn a second.
    pub mechanism FourBar {
        ground { point O = (0m, 0m); point C = (4m, 0m); }
        body crank { point O = (0m, 0m); point A = (1m, 0m); }
        body coupler { point A = (0m, 0m); point B = (3.5m, 0m); }
        body rocker { point C = (0m, 0m); point B = (3m, 0m); start angle = 110deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output pin = rocker.B;
    }
}

mechanism! {
    /// W2: crank 1, rod 3, slider on y = 0.
    pub mechanism SliderCrank {
        ground { point O = (0m, 0m); axis u = (1, 0); }
        body crank { point O = (0m, 0m); point A = (1m, 0m); }
        body rod { point A = (0m, 0m); point B = (3m, 0m); start angle = 0deg; }
        body slider { point B = (0m, 0m); }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slider.B);
        joint guide = translational(ground.u, ground.O, slider.B);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output pin = slider.B;
    }
}

mechanism! {
    /// W3: Holland's numbers divided by 10.
    pub mechanism Jansen {
        ground { point O = (0m, 0m); point V = (-3.8m, -0.78m); }
        body crank { point O = (0m, 0m); point X = (1.5m, 0m); }
        body bar_j { point X = (0m, 0m); point U = (5m, 0m); start angle = 2.466; }
        let wx = (4.15m^2 + 4.01m^2 - 5.58m^2) / (2 * 4.15m);
        body upper { point V = (0m, 0m); point U = (4.15m, 0m); point W = (wx, sqrt(4.01m^2 - wx^2)); start angle = 1.227; }
        body bar_k { point X = (0m, 0m); point C = (6.19m, 0m); start angle = -2.315; }
        body bar_c { point V = (0m, 0m); point C = (3.93m, 0m); start angle = -1.286; }
        body bar_f { point W = (0m, 0m); point F = (3.94m, 0m); start angle = -1.165; }
        let tx = (3.67m^2 + 6.57m^2 - 4.90m^2) / (2 * 3.67m);
        body foot { point F = (0m, 0m); point C = (3.67m, 0m); point T = (tx, -sqrt(6.57m^2 - tx^2)); start angle = -0.496; }
        joint o = revolute(ground.O, crank.O);
        joint xj = revolute(crank.X, bar_j.X);
        joint xk = revolute(crank.X, bar_k.X);
        joint u = revolute(bar_j.U, upper.U);
        joint v = revolute(ground.V, upper.V);
        joint vc = revolute(ground.V, bar_c.V);
        joint kc = revolute(bar_k.C, bar_c.C);
        joint w = revolute(upper.W, bar_f.W);
        joint f = revolute(bar_f.F, foot.F);
        joint cf = revolute(bar_c.C, foot.C);
        drive input = drive_angle(crank, 1turn * t / 1s);
        output toe = foot.T;
    }
}

mechanism! {
    /// W4 with N = 10: all links 1, the parallelogram branch.
    pub mechanism Chain {
        ground {
            point P0 = (0m, 0m); point P1 = (1m, 0m); point P2 = (2m, 0m); point P3 = (3m, 0m); point P4 = (4m, 0m);
            point P5 = (5m, 0m); point P6 = (6m, 0m); point P7 = (7m, 0m); point P8 = (8m, 0m); point P9 = (9m, 0m);
            point P10 = (10m, 0m);
        }
        body r0 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r1 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r2 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r3 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r4 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r5 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r6 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r7 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r8 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r9 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body r10 { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
        body c0 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c1 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c2 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c3 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c4 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c5 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c6 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c7 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c8 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        body c9 { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
        joint p0 = revolute(ground.P0, r0.O);
        joint p1 = revolute(ground.P1, r1.O);
        joint p2 = revolute(ground.P2, r2.O);
        joint p3 = revolute(ground.P3, r3.O);
        joint p4 = revolute(ground.P4, r4.O);
        joint p5 = revolute(ground.P5, r5.O);
        joint p6 = revolute(ground.P6, r6.O);
        joint p7 = revolute(ground.P7, r7.O);
        joint p8 = revolute(ground.P8, r8.O);
        joint p9 = revolute(ground.P9, r9.O);
        joint p10 = revolute(ground.P10, r10.O);
        joint a0 = revolute(r0.A, c0.A); joint b0 = revolute(c0.B, r1.A);
        joint a1 = revolute(r1.A, c1.A); joint b1 = revolute(c1.B, r2.A);
        joint a2 = revolute(r2.A, c2.A); joint b2 = revolute(c2.B, r3.A);
        joint a3 = revolute(r3.A, c3.A); joint b3 = revolute(c3.B, r4.A);
        joint a4 = revolute(r4.A, c4.A); joint b4 = revolute(c4.B, r5.A);
        joint a5 = revolute(r5.A, c5.A); joint b5 = revolute(c5.B, r6.A);
        joint a6 = revolute(r6.A, c6.A); joint b6 = revolute(c6.B, r7.A);
        joint a7 = revolute(r7.A, c7.A); joint b7 = revolute(c7.B, r8.A);
        joint a8 = revolute(r8.A, c8.A); joint b8 = revolute(c8.B, r9.A);
        joint a9 = revolute(r9.A, c9.A); joint b9 = revolute(c9.B, r10.A);
        drive input = drive_angle(r0, 90deg + 0.8 * sin(2 * pi * t / 1s));
        output tip = r10.A;
    }
}
