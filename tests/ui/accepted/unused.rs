//! A name with an underscore is not reported where nothing uses it, nor is anything where the lint is allowed.
#![deny(warnings)]

reuleaux::mechanism! {
    mechanism Crank {
        param length: Length = 100mm;
        param _mass: Mass = 2kg;
        let _gap = 3mm;
        body crank { point A = (length, 0mm);  point drawn = (0mm, 50mm); }
        joint hinge = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60rpm * t);
    }
}

#[allow(unused)]
mod spare {
    reuleaux::mechanism! {
        pub(super) mechanism Crank {
            param far: Length = 100mm;
            function lift(a: Angle) -> Length = 5mm * sin(a);
            body crank { }
            joint hinge = revolute(ground.position, crank.position);
            drive input = drive_angle(crank, 60rpm * t);
        }
    }
}

fn main() {
    let _ = (Crank::default().solve(0.0), spare::Crank::default().solve(0.0));
}
