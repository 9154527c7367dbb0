//! The mechanisms of which derivatives by parameters are measured, and the clock.
//!
//! A crank-rocker, and W1 to W3 and the six-bar of the workloads with each of their lengths as a parameter.

use reuleaux::mechanism;

mechanism! {
    /// A crank-rocker with seven parameters.
    pub mechanism CrankRocker {
        param speed: AngularVelocity = 60rpm;
        param ground_length: Length = 400mm;
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param along: Length = 175mm;
        param across: Length = 80mm;
        ground { point C = (ground_length, 0mm); }
        body crank   { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm);  point P = (along, across); }
        body rocker  { point B = (rocker_length, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, speed * t);
        output tip = coupler.P;
    }
}

mechanism! {
    /// W1: a four-bar whose crank turns.
    pub mechanism FourBar {
        param speed: AngularVelocity = 60rpm;
        param ground_length: Length = 4m;
        param crank_length: Length = 1m;
        param coupler_length: Length = 3.5m;
        param rocker_length: Length = 3m;
        ground { point C = (ground_length, 0m); }
        body crank { point A = (crank_length, 0m); }
        body coupler { point B = (coupler_length, 0m); }
        body rocker { point B = (rocker_length, 0m); start angle = 110deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, speed * t);
        output pin = rocker.B;
    }
}

mechanism! {
    /// W2: a slider-crank.
    pub mechanism SliderCrank {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 1m;
        param rod_length: Length = 3m;
        ground { axis u = (1, 0); }
        body crank { point A = (crank_length, 0m); }
        body rod { point B = (rod_length, 0m); start angle = 0deg; }
        body slider { }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, slider.position);
        joint guide = translational(ground.u, ground.position, slider.position);
        drive input = drive_angle(crank, speed * t);
        output pin = slider.position;
    }
}

mechanism! {
    /// W3: Jansen's leg.
    pub mechanism Jansen {
        param speed: AngularVelocity = 60rpm;
        param a: Length = 3.8m;
        param b: Length = 4.15m;
        param c: Length = 3.93m;
        param d: Length = 4.01m;
        param e: Length = 5.58m;
        param f: Length = 3.94m;
        param g: Length = 3.67m;
        param h: Length = 6.57m;
        param i: Length = 4.90m;
        param j: Length = 5m;
        param k: Length = 6.19m;
        param l: Length = 0.78m;
        param m: Length = 1.5m;
        ground { point V = (-a, -l); }
        body crank { point X = (m, 0m); }
        body bar_j { point U = (j, 0m); start angle = 2.466; }
        let wx = (b^2 + d^2 - e^2) / (2 * b);
        body upper { point U = (b, 0m); point W = (wx, sqrt(d^2 - wx^2)); start angle = 1.227; }
        body bar_k { point C = (k, 0m); start angle = -2.315; }
        body bar_c { point C = (c, 0m); start angle = -1.286; }
        body bar_f { point F = (f, 0m); start angle = -1.165; }
        let tx = (g^2 + h^2 - i^2) / (2 * g);
        body foot { point C = (g, 0m); point T = (tx, -sqrt(h^2 - tx^2)); start angle = -0.496; }
        joint o = revolute(ground.position, crank.position);
        joint xj = revolute(crank.X, bar_j.position);
        joint xk = revolute(crank.X, bar_k.position);
        joint u = revolute(bar_j.U, upper.U);
        joint v = revolute(ground.V, upper.position);
        joint vc = revolute(ground.V, bar_c.position);
        joint kc = revolute(bar_k.C, bar_c.C);
        joint w = revolute(upper.W, bar_f.position);
        joint ff = revolute(bar_f.F, foot.position);
        joint cf = revolute(bar_c.C, foot.C);
        drive input = drive_angle(crank, speed * t);
        output toe = foot.T;
    }
}

mechanism! {
    /// A six-bar driven at its far link, whose four angles are found together.
    pub mechanism SixBar {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 1m;
        param link_length: Length = 3.5m;
        param left_length: Length = 2.5m;
        param coupler_length: Length = 4.5m;
        param apex: Length = 1.984313483298443m;
        param right_length: Length = 2.75m;
        param ground_length: Length = 4m;
        ground { point B0 = (ground_length, 0m); point D0 = (4m, 5.5m); }
        body crank { point D = (crank_length, 0m); }
        body link { point C = (link_length, 0m); start position = (5m, 5.5m); start angle = -164.8deg; }
        body left { point A = (left_length, 0m); start angle = 101.3deg; }
        body coupler { point B = (coupler_length, 0m); point C = (coupler_length / 2, apex); start angle = 3.8deg; }
        body right { point B = (right_length, 0m); start angle = 90deg; }
        joint d0 = revolute(ground.D0, crank.position);
        joint d = revolute(crank.D, link.position);
        joint c = revolute(link.C, coupler.C);
        joint a0 = revolute(ground.position, left.position);
        joint a = revolute(left.A, coupler.position);
        joint b = revolute(coupler.B, right.B);
        joint b0 = revolute(ground.B0, right.position);
        drive input = drive_angle(crank, speed * t);
        output pin = coupler.C;
    }
}

/// States of a turn.
pub(crate) const STEPS: u32 = 1000;

/// Gives each mechanism to a macro: its name, its type, that of its states, an output, one parameter, all parameters.
macro_rules! each {
    ($measure:ident) => {
        $measure!(
            "crank-rocker",
            CrankRocker,
            CrankRockerState,
            tip,
            crank_length,
            [[speed, ground_length, crank_length, coupler_length, rocker_length, along, across]]
        );
        $measure!(
            "W1 four-bar",
            FourBar,
            FourBarState,
            pin,
            crank_length,
            [[speed, ground_length, crank_length, coupler_length, rocker_length]]
        );
        $measure!("W2 slider-crank", SliderCrank, SliderCrankState, pin, crank_length, [[speed, crank_length, rod_length]]);
        $measure!(
            "six-bar, one block of 4",
            SixBar,
            SixBarState,
            pin,
            crank_length,
            [[speed, crank_length, link_length, left_length, coupler_length, apex, right_length, ground_length]]
        );
        $measure!("W3 Jansen's leg, all at once", Jansen, JansenState, toe, m, [[speed, a, b, c, d, e, f, g, h, i, j, k, l, m]]);
        $measure!("W3, four at a time", Jansen, JansenState, toe, m, [[speed, a, b, c], [d, e, f, g], [h, i, j, k], [l, m]]);
    };
}
pub(crate) use each;
