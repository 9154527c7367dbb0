#![deny(warnings)]
//! Loads, components and constraints called by words of Rust, and loads whose methods would have one name.

mod own {
    reuleaux::constraint! {
        pub(crate) constraint r#use(P: Point) { P.x == 0m; }
        pub(crate) component r#trait(P: Point) { body b {}  joint j = revolute(P, b.position);  drive d = drive_angle(b, 1rad_s * t); }
        /// One definition alone.
        pub(crate) bundle places { constraint at_y(P: Point) { P.y == 0m; } }
    }
}

reuleaux::mechanism! {
    pub mechanism Braked {
        gravity = (0, -10m_s2);
        body wheel { mass = 1kg;  center = (100mm, 0mm); }
        joint r#do = revolute((0m, 0m), wheel.position);
        drive r#try = drive_angle(wheel, 0rad);
        force r#final = { on wheel: 2Nm; }
    }
}

reuleaux::mechanism! {
    pub mechanism Held {
        use crate::own::{places, r#trait, r#use};
        body b { mass = 1kg; }
        body c { mass = 1kg; }
        joint across = r#use(b.position);
        joint along = at_y(b.position);
        joint beside = r#use(c.position);
        joint below = at_y(c.position);
        part r#in = r#trait((1m, 0m));
        for i in 0..1 { drive d[i] = drive_angle(b, 1rad_s * t); }
        drive d_0 = drive_angle(c, 2rad_s * t);
        force turning = { on c: 3Nm; }
    }
}

fn main() {
    let braked = Braked::default();
    let loads = braked.loads(&braked.solve(0.0).unwrap());
    // The drive holds the wheel: 1 kg · 10 m/s² · 0.1 m − 2 N m.
    assert!((loads.r#try().effort + 1.0).abs() < 1e-15);
    assert!((loads.r#do().force.y - 10.0).abs() < 1e-14);
    let held = Held::default();
    let loads = held.loads(&held.solve(0.0).unwrap());
    // What is called so keeps the name.
    assert_eq!((loads.d_0().effort, loads.d_0_().effort), (-3.0, 0.0));
}
