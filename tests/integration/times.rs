//! Sweeps take times by value and by reference, in both precisions.

use reuleaux::{Integrator, mechanism};

mechanism! {
    /// A crank that pushes a slide, with a lamp on its pin.
    mechanism Pump {
        ground { axis bore = (1, 0); }
        body crank { point A = (50mm, 0mm); }
        body rod { point B = (200mm, 0mm); }
        body piston { }
        joint main = revolute(ground.position, crank.position);
        joint big_end = revolute(crank.A, rod.position);
        joint small_end = revolute(rod.B, piston.position);
        joint guide = translational(ground.bore, ground.position, piston.position);
        drive motor = drive_angle(crank, 90rpm * t);
        slice output lamp = crank.A;
    }
}

mechanism! {
    /// A pendulum.
    mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        body bar { mass = 1kg; center = (300mm, 0mm); inertia = 0.03kgm2; }
        joint pivot = revolute(ground.position, bar.position);
        freedom swing = bar.angle from -30deg;
    }
}

const TIMES: [f64; 4] = [0.0, 0.125, 0.25, 0.5];

#[test]
fn a_reference_to_times_gives_the_same_states() {
    let (pump, list) = (Pump::default(), TIMES.to_vec());
    let (prepared, lamp) = (pump.prepared(), pump.solve_for_lamp());
    let known: Vec<_> = pump.sweep(TIMES).map(|state| state.unwrap()).collect();
    assert_eq!(known.iter().map(|state| state.t).collect::<Vec<_>>(), list);

    assert!(pump.sweep(&list).map(|state| state.unwrap()).eq(known.iter().cloned()));
    assert!(pump.sweep(&list[1..]).map(|state| state.unwrap().t).eq(list[1..].iter().copied()));
    assert!(pump.sweep(list.iter()).map(|state| state.unwrap()).eq(known.iter().cloned()));
    assert!(prepared.sweep(&list).map(|state| state.unwrap()).eq(known.iter().cloned()));
    assert!(prepared.sweep(&list[1..]).map(|state| state.unwrap().t).eq(list[1..].iter().copied()));
    let lit: Vec<_> = lamp.sweep(TIMES).map(|state| state.unwrap()).collect();
    assert!(lamp.sweep(&TIMES).map(|state| state.unwrap()).eq(lit.iter().cloned()));
    assert!(lamp.sweep(list.iter()).map(|state| state.unwrap()).eq(lit));
    assert!(reuleaux::sweep(pump, &list).map(|state| state.unwrap()).eq(known.iter().map(|state| state.0.clone())));
    assert!(reuleaux::Mechanism::sweep(&pump, &list).map(|state| state.unwrap()).eq(known.iter().map(|state| state.0.clone())));
}

#[test]
fn a_motion_takes_references_to_times_as_well() {
    let (pendulum, integrator, list) = (Pendulum::default(), Integrator::new(1e-9), TIMES.to_vec());
    let known: Vec<_> = pendulum.sweep(TIMES, integrator).map(|state| state.unwrap()).collect();
    assert_eq!(known.iter().map(|state| state.t).collect::<Vec<_>>(), list);
    assert!(known[3].bar().angle < known[0].bar().angle);

    assert!(pendulum.sweep(&list, integrator).map(|state| state.unwrap()).eq(known.iter().cloned()));
    let later: Vec<_> = pendulum.sweep_from(&known[1], list[2..].to_vec(), integrator).map(|state| state.unwrap()).collect();
    assert_eq!(later.len(), 2);
    assert!(pendulum.sweep_from(&known[1], &list[2..], integrator).map(|state| state.unwrap()).eq(later));
}

/// Literals take the type of the mechanism.
#[test]
fn literals_are_single_in_single_precision() {
    let lamp = Pump::<f32>::with_defaults().solve_for_lamp();
    for states in [lamp.sweep([0.0, 0.5]).collect::<Vec<_>>(), lamp.sweep(&[0.0, 0.5]).collect(), lamp.sweep(vec![0.0, 0.5]).collect()] {
        let times: Vec<f32> = states.into_iter().map(|state| state.unwrap().t).collect();
        assert_eq!(times, [0.0_f32, 0.5]);
    }
    let single = Pump::<f32>::with_defaults();
    let states = single.sweep((0..3).map(|k| 0.25 * k as f32));
    assert_eq!(states.map(|state| state.unwrap().t).sum::<f32>(), 0.75);
    assert_eq!(single.sweep(&[0.0, 0.5]).last().unwrap().unwrap().t, 0.5_f32);
    assert_eq!(single.sweep([0.0, 0.5]).last().unwrap().unwrap().t, 0.5_f32);

    let pendulum = Pendulum::<f32>::with_defaults();
    let integrator = Integrator::new(1e-4);
    let known: Vec<_> = pendulum.sweep([0.0, 0.5], integrator).map(|state| state.unwrap()).collect();
    assert_eq!(known[1].t, 0.5_f32);
    assert!(pendulum.sweep(&[0.0, 0.5], integrator).map(|state| state.unwrap()).eq(known));
}
