use reuleaux::{Mechanism, mechanism};

mechanism! {
    pub mechanism Lift in space {
        param reach: Length = 60mm;
        ground { axis z = (0, 0, 1); }
        body nut { axis z = (0, 0, 1); point A = (reach, 0mm, 0mm); }
        joint guide = translational(ground.position, ground.z, nut.position, nutt.z);
        drive motor = drive_translation(guide, 5mm_s * t);
        output lift = guide.displacement;
        output speed = rate(guide.displacement);
        output way = nut.z;
        output height = nut.z.z;
    }
}

fn main() {
    let lift = Lift::default();
    println!("{}", Lift::<f64>::PLAN);
    let state = lift.solve(0.1).unwrap();
    let _: [f64; 3] = [lift.lift(&state).acceleration, lift.speed(&state).rate, lift.height(&state).value];
    let _: f64 = lift.way(&state).value.dot(&lift.way(&state).rate);
    let (varied, there) = lift.derivatives(&state, |lift| [&mut lift.reach]).unwrap();
    let _: [f64; 1] = varied.lift(&LiftState(there)).value.by;
    let _ = lift.error_bound(&lift.solve(1.0).unwrap()).unwrap().q;
}
