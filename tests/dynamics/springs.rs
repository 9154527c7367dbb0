//! Springs whose ends meet.

use reuleaux::{Integrator, mechanism};

mechanism! {
    /// A mass on a spring without `rest`, from the place where its length is zero: m ẍ = −k x in both directions.
    mechanism Centred {
        body bob { mass = 2kg;  inertia = 0.1kgm2; }
        force pull = spring(ground.position, bob.position, stiffness: 50N_m);
        freedom across = bob.x at 0.3m_s;
        freedom along = bob.y at -0.2m_s;
        freedom turn = bob.angle;
    }
}

mechanism! {
    /// The same spring on a slide that is driven through length zero.
    mechanism Through {
        body slide { mass = 2kg; }
        force pull = spring(ground.position, slide.position, stiffness: 50N_m);
        joint rail = translational((1, 0), ground.position, slide.position);
        drive motor = drive_x(slide.position, 0.1m * sin(2rad_s * t));
    }
}

#[test]
fn a_spring_without_rest_works_at_length_zero() {
    let mechanism = Centred::default();
    let mut state = mechanism.initial_state().expect("a start at length zero");
    for k in 1..=20 {
        mechanism.advance(&mut state, 0.1 * f64::from(k), &mut Integrator::new(1e-11)).expect("a motion");
        let swung = (5.0 * state.t).sin() / 5.0;
        let place = state.bob().position;
        assert!((place.x - 0.3 * swung).abs() < 1e-10 && (place.y + 0.2 * swung).abs() < 1e-10, "{place} at {}", state.t);
        assert!((mechanism.energy(&state).kinetic + mechanism.energy(&state).potential - 0.13).abs() < 1e-10);
    }
    // F = m ẍ + k x = (50 − 4 · 2) 0.1 sin 2 t, which vanishes at length zero.
    let mechanism = Through::default();
    for t in [0.0, 1e-9, 0.4] {
        let state = mechanism.solve(t).expect("a state");
        let force = mechanism.loads(&state).motor().effort;
        assert!((force - 4.2 * (2.0 * t).sin()).abs() < 1e-14, "{force} at {t}");
    }
}

mechanism! {
    /// A block on a spring without a length of its own, by the energy of the spring.
    mechanism Drawn {
        body block { mass = 1kg; }
        joint rail = translational((1, 0), ground.position, block.position);
        energy spring = 0.5 * 100N_m * norm(block.position - ground.position)^2;
        freedom slide = block.x from 0m at 1m_s;
    }
}

/// The distance has no derivative where it vanishes; its square has. x = sin(ω t)/ω
#[test]
fn the_square_of_a_distance_is_an_energy_also_where_it_vanishes() {
    let drawn = Drawn::default();
    let mut state = drawn.initial_state().expect("a state");
    drawn.advance(&mut state, 1.0, &mut Integrator::new(1e-10)).expect("a motion");
    let (sine, cosine) = 10_f64.sin_cos();
    assert!((state.block().position.x - sine / 10.0).abs() < 1e-10 && (state.block().velocity.x - cosine).abs() < 1e-9);
}
