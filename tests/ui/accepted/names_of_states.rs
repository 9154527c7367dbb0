//! Mechanisms named like the state or the failure of another one, and a mechanism in a function.

#![deny(warnings)]

mod machines {
    reuleaux::mechanism! {
        pub mechanism Crank {
            body rod { point A = (1m, 0m); }
            joint axle = revolute(ground.position, rod.position);
            drive turn = drive_angle(rod, 1rad_s * t);
            output tip = rod.A;
        }
    }
    reuleaux::mechanism! {
        pub mechanism CrankState {
            body rod {}
            joint axle = revolute(ground.position, rod.position);
            drive turn = drive_angle(rod, 2rad_s * t);
        }
    }
    reuleaux::mechanism! {
        pub mechanism CrankFailure {
            body rod {}
            joint axle = revolute(ground.position, rod.position);
            drive turn = drive_angle(rod, 3rad_s * t);
        }
    }
}

use machines::{Crank, CrankFailure, CrankState, CrankStateState};

fn main() {
    let crank = Crank::default();
    let state = crank.solve(0.5).unwrap();
    assert_eq!(crank.tip(&state).value.x, 0.5_f64.cos());
    let state: CrankStateState = CrankState::default().solve(0.5).unwrap();
    assert_eq!(state.rod().angle, 1.0);
    assert_eq!(CrankFailure::default().solve(0.5).unwrap().rod().angle, 1.5);

    reuleaux::mechanism! {
        mechanism Local {
            body rod {}
            joint axle = revolute(ground.position, rod.position);
            drive turn = drive_angle(rod, 1rad_s * t);
        }
    }
    let solved: Result<LocalState, LocalFailure> = Local::default().solve(0.5);
    assert_eq!(solved.unwrap().rod().angle, 0.5);
}
