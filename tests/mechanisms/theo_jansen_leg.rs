//! `theo_jansen_leg.json`

use crate::declared;

declared! {
    /// Theo Jansen's leg, in the published lengths as metres.
    TheoJansenLeg (crank_length: Length = 15, speed: AngularVelocity = 6.283185307179586) {
        ground { point O = (0, 0);  point V = (-38, -7.8); }
        body crank { point O = (0, 0);  point X = (crank_length, 0); }
        body bar_j { point X = (0, 0);  point U = (50, 0);  start angle = 2.47; }
        body upper { point V = (0, 0);  point U = (41.5, 0);  point W = (2.6098795180722933, 40.01497880670621);  start angle = 1.23; }
        body bar_k { point X = (0, 0);  point C = (61.9, 0);  start angle = -2.32; }
        body bar_c { point V = (0, 0);  point C = (39.3, 0);  start angle = -1.29; }
        body bar_f { point W = (0, 0);  point F = (39.4, 0);  start angle = -1.16; }
        body foot  { point F = (0, 0);  point C = (36.7, 0);  point T = (44.446594005449604, -48.38378118041966);  start angle = -0.496; }
        joint o = revolute(ground.O, crank.O);
        joint x1 = revolute(crank.X, bar_j.X);
        joint x2 = revolute(crank.X, bar_k.X);
        joint u = revolute(bar_j.U, upper.U);
        joint v1 = revolute(ground.V, upper.V);
        joint v2 = revolute(ground.V, bar_c.V);
        joint c1 = revolute(bar_k.C, bar_c.C);
        joint w = revolute(upper.W, bar_f.W);
        joint f = revolute(bar_f.F, foot.F);
        joint c2 = revolute(bar_c.C, foot.C);
        drive motor = drive_relative_angle(ground, crank, speed * t);
    } outputs TheoJansenLegState {
        interest = [foot.T];
        height = [foot.T.y - upper.W.y];
    }
}
