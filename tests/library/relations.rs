//! Gears, belts and drives on moving carriers.

use crate::declared;

declared! {
    /// Two bodies without relative rotation, and two with an angle between them.
    #[equations_only]
    Angles (between: Angle = 1) {
        body a {}
        body b {}
        body c {}
        joint same = parallel(a, b);
        joint turned = relative_angle(b, c, between);
    }
}
declared! {
    /// Gears and belts on a carrier.
    #[equations_only]
    OnCarrier (za: Number = 20, zb: Number = 30, ra: Length = 1, rb: Length = 1, phase: Angle = 1, offset: Length = 1) {
        body carrier {}
        body a {}
        body b {}
        joint mesh = gear_pair(a, b, za, zb, phase, carrier);
        joint chain = belt(a, b, ra, rb, c: offset, carrier: carrier);
    }
}
declared! {
    /// Gears whose teeth press on each other, one inside the other, and on a carrier.
    #[equations_only]
    Toothed (phase: Length = 1) {
        body carrier {}
        body a {}
        body b {}
        body c {}
        // Seen from a line that turns with the centres, so that the rows have a value anywhere.
        let outer = direction(b.position - a.position) - carrier.angle;
        let inner = direction((0mm, 0mm) - c.position) - carrier.angle;
        joint mesh = involute_mesh(a.position, b.position, 10mm, 15mm, outer + 30deg, c: phase, carrier: carrier);
        joint ring = involute_mesh(c.position, (0mm, 0mm), 12mm, -18mm, inner - 50deg, 25deg, -1, carrier: carrier);
    }
}
declared! {
    /// A differential, a general one, and a planetary train.
    #[equations_only]
    Willis (ratio: Number = 1, phase: Angle = 1, sun_teeth: Number = 20, ring_teeth: Number = 60) {
        body a {}
        body b {}
        body c {}
        joint bevel = differential(a, b, c);
        joint spur = differential(a, b, c, ratio, phase);
        joint train = planetary(a, b, c, sun_teeth, ring_teeth);
    }
}
declared! {
    /// A pinion and a rack on a third body.
    #[equations_only]
    RackOnCarrier (u: Number = 1, v: Number = 1, px: Length = 1, py: Length = 1, radius: Length = 1) {
        body carrier { point O = (px, py);  axis along = (u, v); }
        body pinion {}
        body rack { point P = (py, px); }
        joint mesh = rack_pinion(pinion, rack.P, carrier.along, carrier.O, R: radius);
    }
}
declared! {
    /// A slider driven along its guide.
    #[equations_only]
    Pushed (px: Length = 1, py: Length = 1, u: Number = 1, v: Number = 1, stroke: Length = 1, speed: AngularVelocity = 1) {
        body guide { point P = (px, py);  axis along = (u, v); }
        body ram { point Q = (py, px); }
        joint slide = translational(guide.along, guide.P, ram.Q, c: 30deg);
        drive push = drive_along(slide, stroke * sin(speed * t));
    }
}
