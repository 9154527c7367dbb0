//! Every function of the language in an equation and in an output, and a call of a Rust function by path.

use crate::declared;

declared! {
    /// Artificial equations, for the functions only.
    #[equations_only]
    Functions (p: Number = 1, q: Number = 1, r: Length = 1) {
        let s = t / 1s;
        body a { point P = (0.3, -0.7);  axis u = (0.6, 0.8); }
        body b { point Q = (1.1, 0.4); }
        let angle = a.angle - b.angle;
        let h = b.Q - a.P;
        drive trigonometry = { tan(angle / 9) + asin(sin(angle) / 2) == acos(cos(angle + s) / 2) + atan(p * angle); }
        drive exponential = { exp(sin(angle)) * ln(2 + cos(b.angle)) == sqrt(1 + angle^2) + q^3 * s^-2; }
        drive corners = { abs(a.x) + max(a.y, b.y) == min(r, b.x) * (if sin(angle) < s { 1 } else { angle }); }
        joint vectors = {
            let v = perp(h) - 2 * unit(h) * norm(h);
            cross(v, a.P) + dot(h, v) == r * norm(a.P - b.Q) + cross(unit(a.u), h) * 1m;
            direction(h) + atan2(a.x, r) == direction(a.u) / p;
        }
        drive powers = { (1 + angle^2)^(3/2) + (1 + s^2)^0.5 == (2 + sin(angle))^p * 2^s; }
        joint rust = { crate::library::oval(angle) + crate::library::measured(2 * a.angle) == 0.3; }
        drive tables = {
            table(angle, [(-2, 1), (-1, 3), (0.5, -1), (2, 0.5)], linear) == table(s, [(-1, 1), (0, 3), (1, -1)], hold);
            table(b.angle, [(0, 1), (1, 3), (2, 1)], periodic) == s * 0.1;
        }
    } outputs FunctionsState {
        slope = [tan(angle / 9) * exp(sin(s * angle))];
        swing = [perp(h) * cos(angle) + unit(h) * r];
        far = [norm(h) / max(r, a.x)];
        course = [direction(h) - p * direction(a.u)];
        outline = [crate::library::oval(angle) + table(angle, [(-2, 1), (-1, 3), (0.5, -1), (2, 0.5)], linear)];
        point = [b.Q];
        time = [t^2 / 1s];
    }
}
