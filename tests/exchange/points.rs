//! Declared points and axes, without an output for each.

use reuleaux::nalgebra::{Vector2, Vector3};
use reuleaux::{Motion, mechanism};

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    #[points]
    mechanism Rocker {
        param crank_length: Length = 100mm;
        param lift: Length = 80mm;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm);  axis up = (0, 1); }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm);  point r#type = (1mm, 2mm); }
        body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm);  point P = (175mm, lift * 2 / 2);  axis u = (0.6, 0.8); }
        body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 60rpm * t + 0.3rad);
        output P = coupler.P;
        output pin = crank.A;
        output u = coupler.u;
        for i in 0..2 { part pendulum[i] = Pendulum(); }
        component Pendulum() {
            param l: Length = 50mm;
            body bar { for k in 0..2 { point Q[k] = (k * l, 0mm); } }
            joint pin = revolute(ground.O, bar.Q[0]);
            drive swing = drive_angle(bar, 1rad_s * t);
        }
    }
}

mechanism! {
    #[points]
    mechanism Disk in space {
        param radius: Length = 1m;
        ground { axis z = (0, 0, 1) from (1, 0, 0);  point O = (0m, 0m, 2m); }
        body disk { axis z = (0, 0, 1) from (1, 0, 0);  axis x = (1, 0, 0) from (0, 1, 0);  point P = (radius, 0m, 0.5m); }
        joint hinge = revolute(ground.O, ground.z, disk.position, disk.z);
        drive motor = drive_rotation(hinge, 2rad_s * t);
        output P = disk.P;
    }
}

mechanism! {
    #[points]
    mechanism Falling {
        gravity = (0m_s2, -9.81m_s2);
        body bob { point P = (1m, 0m);  mass = 2kg;  center = (1m, 0m);  inertia = 0kg * 1m^2; }
        joint pivot = revolute(ground.position, bob.position);
        freedom swing = bob.angle from 0deg;
    }
}

fn near<const D: usize>(found: Motion<reuleaux::nalgebra::SVector<f64, D>>, expected: Motion<reuleaux::nalgebra::SVector<f64, D>>) {
    let off = (found.value - expected.value).amax() + (found.rate - expected.rate).amax();
    let size = 1.0 + expected.acceleration.amax();
    assert!(off < 1e-13 && (found.acceleration - expected.acceleration).amax() < 1e-13 * size, "{found:?} for {expected:?}");
}

#[test]
fn a_point_moves_as_an_output_there_does() -> Outcome {
    let rocker = Rocker { lift: 0.05, ..Rocker::default() };
    for state in rocker.sweep([0.0, 0.17, 0.5]) {
        let state = state?;
        let points = rocker.points(&state);
        near(points.coupler_P(), rocker.P(&state));
        near(points.crank_A(), rocker.pin(&state));
        near(points.coupler_u(), rocker.u(&state));
    }
    Ok(())
}

/// A = r (cos θ, sin θ) with θ = 2π t + 0.3.
#[test]
fn a_point_moves_on_its_circle() -> Outcome {
    let rocker = Rocker { crank_length: 0.08, ..Rocker::default() };
    let state = rocker.solve(0.2)?;
    let omega = std::f64::consts::TAU;
    let (sine, cosine) = (omega * 0.2 + 0.3).sin_cos();
    let value = Vector2::new(0.08 * cosine, 0.08 * sine);
    near(
        rocker.points(&state).crank_A(),
        Motion { value, rate: Vector2::new(-value.y, value.x) * omega, acceleration: -value * omega * omega },
    );
    Ok(())
}

/// The angle of the coupler's axis is that of the coupler plus that of (0.6, 0.8).
#[test]
fn an_axis_turns_with_its_body() -> Outcome {
    let rocker = Rocker::default();
    let state = rocker.solve(0.4)?;
    let (coupler, along) = (state.coupler(), rocker.points(&state).coupler_u());
    let (sine, cosine) = (coupler.angle + 0.8_f64.atan2(0.6)).sin_cos();
    let across = Vector2::new(-sine, cosine);
    near(
        along,
        Motion {
            value: Vector2::new(cosine, sine),
            rate: across * coupler.angular_velocity,
            acceleration: across * coupler.angular_acceleration - Vector2::new(cosine, sine) * coupler.angular_velocity.powi(2),
        },
    );
    Ok(())
}

#[test]
fn points_of_ground_and_of_parts_have_names() -> Outcome {
    let mut rocker = Rocker::default();
    rocker.pendulum[1].l = 0.07;
    let state = rocker.solve(0.2)?;
    let points = rocker.points(&state);
    assert_eq!(points.ground_C(), Motion::fixed(Vector2::new(0.4, 0.0)));
    assert_eq!(points.ground_up().value, Vector2::new(0.0, 1.0));
    assert_eq!(points.crank_type().value, state.crank().point(Vector2::new(0.001, 0.002)).value);
    let (sine, cosine) = 0.2_f64.sin_cos();
    let [[base, _], [_, tip]] = points.pendulum_bar_Q();
    assert_eq!([base, tip], [points.pendulum_0_bar_Q_0(), points.pendulum_1_bar_Q_1()]);
    for (found, l) in points.pendulum_bar_Q().map(|[_, tip]| tip).into_iter().zip([0.05, 0.07]) {
        near(
            found,
            Motion {
                value: Vector2::new(cosine, sine) * l,
                rate: Vector2::new(-sine, cosine) * l,
                acceleration: Vector2::new(-cosine, -sine) * l,
            },
        );
    }
    Ok(())
}

#[test]
fn points_and_axes_in_space_move_with_their_body() -> Outcome {
    let disk = Disk { radius: 0.7 };
    let state = disk.solve(0.4)?;
    let points = disk.points(&state);
    let (sine, cosine) = 0.8_f64.sin_cos();
    let along = Vector3::new(cosine, sine, 0.0);
    let across = Vector3::new(-sine, cosine, 0.0);
    let circle = |radius: f64, height: f64| Motion {
        value: along * radius + Vector3::new(0.0, 0.0, height),
        rate: across * (2.0 * radius),
        acceleration: along * (-4.0 * radius),
    };
    near(points.disk_P(), circle(0.7, 2.5));
    near(points.disk_P(), disk.P(&state));
    near(points.disk_x(), circle(1.0, 0.0));
    near(points.disk_z(), Motion::fixed(Vector3::new(0.0, 0.0, 1.0)));
    assert_eq!(points.ground_O(), Motion::fixed(Vector3::new(0.0, 0.0, 2.0)));
    Ok(())
}

/// A point mass, horizontal and at rest, falls freely.
#[test]
fn points_of_a_motion_from_forces_move_too() -> Outcome {
    let falling = Falling::default();
    let state = falling.initial_state()?;
    let bob = falling.points(&state).bob_P();
    near(bob, Motion { value: Vector2::new(1.0, 0.0), rate: Vector2::zeros(), acceleration: Vector2::new(0.0, -9.81) });
    Ok(())
}

/// ∂A/∂length is the direction of the crank.
#[test]
fn points_have_derivatives() -> Outcome {
    use reuleaux::Mechanism;
    let rocker = Rocker::default();
    let state = rocker.solve(0.2)?;
    let (varied, there) = rocker.derivatives(&state, |rocker| [&mut rocker.crank_length])?;
    let there = RockerState(there);
    let place = varied.points(&there).crank_A().value;
    let (sine, cosine) = (std::f64::consts::TAU * 0.2 + 0.3).sin_cos();
    assert!((place.x.by[0] - cosine).abs() < 1e-14 && (place.y.by[0] - sine).abs() < 1e-14);
    Ok(())
}
