//! Generated code refers to everything by its full path: nothing needs to be in scope, and items in scope may have any names.
#![no_implicit_prelude]
#![allow(non_camel_case_types, dead_code)]

struct f64;
struct f32;
struct usize;
struct u64;
struct u32;
struct u16;
struct bool;
struct str;
struct Fn;
struct Option;
struct Some;
struct None;
struct Result;
struct Ok;
struct Err;
struct Default;
struct Iterator;
struct IntoIterator;
struct Copy;
struct Clone;
struct Debug;
struct PartialEq;
struct From;
struct T;
struct T2;
struct I;
struct LANES;
struct Scene;
struct Pose;
struct Drawable;
mod picture {}
mod core {}
mod std {}
mod nalgebra {}
mod reuleaux {}

::reuleaux::mechanism! {
    #[picture]
    pub mechanism Everything {
        param crank_length: Length = 100mm in 1mm..1m;
        for i in 0..3 { param widths[i]: Length = 10mm; }
        ground { point O = (0mm, 0mm); point C = (400mm, 0mm); }
        body crank { point O = (0mm, 0mm); point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm); point B = (350mm, 0mm); }
        body rocker { point C = (0mm, 0mm); point B = (300mm, 0mm); start angle = 70deg; }
        body wheel { point O = (0mm, 0mm); }
        component Pointer(root: Point) {
            param length: Length = 1m;
            body needle { point tip = (length, 0m); }
            joint w = weld(root, needle.position);
        }
        part pointer = Pointer(rocker.B);
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        joint hub = revolute(wheel.O, ground.O);
        drive input = drive_angle(crank, 60rpm * t);
        drive turn = drive_angle(wheel, table(t, [(0s, 0deg), (1s, 90deg), (2s, 180deg), (4s, 360deg)], linear));
        slice output tip = rocker.B;
        output pair = rocker.angle - widths[1] / 1m;
    }
}

::reuleaux::mechanism! {
    /// Four unknowns at once, and many blocks that are alike.
    pub mechanism Large {
        let n = 12;
        ground {
            point O = (-0.5m, -1.5m);
            point D = (1.2m, -1.1m);
            point E = (1.5m, -1.3m);
            for i in 0..=n { point P[i] = (i * 1m, 0m); }
        }
        body crank { point O = (0m, 0m); point S = (100mm, 0m); }
        body plate { point A = (0m, 0m); point B = (1m, 0m); point C = (0.5m, 0.3m); start position = (0m, 0m); start angle = 0.1rad; }
        body near { point G = (0m, 0m); point P = (1.3m, 0m); }
        body middle { point G = (0m, 0m); point P = (1.5m, 0m); }
        body far { point G = (0m, 0m); point P = (1.5m, 0m); }
        joint o = revolute(ground.O, crank.O);
        joint s = revolute(crank.S, near.G);
        joint d = revolute(ground.D, middle.G);
        joint e = revolute(ground.E, far.G);
        joint a = revolute(near.P, plate.A);
        joint c = revolute(middle.P, plate.C);
        joint b = revolute(far.P, plate.B);
        drive motor = drive_angle(crank, 1rad_s * t);
        for i in 0..=n {
            body arm[i] { point O = (0m, 0m); point A = (1m, 0m); start angle = 90deg; }
            joint p[i] = revolute(ground.P[i], arm[i].O);
        }
        for i in 0..n {
            body rod[i] { point A = (0m, 0m); point B = (1m, 0m); start angle = 0deg; }
            joint g[i] = revolute(arm[i].A, rod[i].A);
            joint h[i] = revolute(rod[i].B, arm[i + 1].A);
        }
        drive input = drive_angle(arm[0], 90deg + 0.8 * sin(2 * pi * t / 1s));
    }
}

fn main() {
    let mechanism = <Everything as ::core::default::Default>::default();
    ::core::assert!(mechanism.solve(0.1).is_ok() && mechanism.solve_for_tip().solve(0.1).is_ok());
}
