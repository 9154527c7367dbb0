#![deny(warnings, missing_docs, unreachable_pub)]
//! The name of a mechanism with `use` items is an ordinary name.

/// A module.
pub mod inner {
    reuleaux::mechanism! {
        /// Turns.
        pub mechanism Crank {
            use elsewhere::at_height;
            body crank {}
            joint height = at_height(crank.position, 0mm);
            joint place = { crank.x == 0; }
            drive input = drive_angle(crank, 60rpm * t);
        }
    }
}

mod other {
    pub(crate) use super::inner::*;
    pub(crate) fn angle() -> f64 {
        Crank::default().solve(0.5).unwrap().crank().angle
    }
}

pub use inner::Crank;
use inner::Crank as Renamed;

fn main() {
    reuleaux::mechanism! {
        mechanism Local {
            use elsewhere::at_height;
            body crank {}
            joint height = at_height(crank.position, 0mm);
            joint place = { crank.x == 0; }
            drive input = drive_angle(crank, 60rpm * t);
        }
    }
    let state: inner::CrankState = Crank::default().solve(0.5).unwrap();
    assert_eq!(state.crank().angle, other::angle());
    assert_eq!(state.crank().angle, Renamed::default().solve(0.5).unwrap().crank().angle);
    assert_eq!(state.crank().angle, Local::default().solve(0.5).unwrap().crank().angle);
}
