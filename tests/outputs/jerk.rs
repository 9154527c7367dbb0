//! Third derivatives of outputs, against closed forms that are differentiated by dual numbers of third order.

use core::f64::consts::TAU;

use num_dual::{Dual3_64, DualNum, third_derivative};
use reuleaux::{Mechanism, MotionWithJerk, Outputs, csv, mechanism};

use crate::near;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// A crank-rocker whose crank turns by a law of third degree.
    #[outputs]
    mechanism CrankRocker {
        param crank_length: Length = 100mm;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm);  point P = (175mm, 80mm); }
        body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 0.3rad + 3rad_s * t + 1rad_s2 * t^2 - 0.5rad * (t / 1s)^3);

        slice output tip = coupler.P with jerk;
        slice output rocking = rocker.angle with jerk;
        output pin = crank.A with jerk;
        slice output ends[0] = crank.A with jerk;
        output ends[1] = coupler.B with jerk;
        output plain = coupler.P;
        output still = ground.C with jerk;
    }
}

/// Angle of the crank.
fn law(t: Dual3_64) -> Dual3_64 {
    t * 3.0 + t * t - t * t * t * 0.5 + 0.3
}

/// Point B and the angle of the rocker: Freudenstein's equation in tan(ψ/2), with the coupler above.
fn rocker(t: Dual3_64) -> ([Dual3_64; 2], Dual3_64) {
    let (a, b, c, d) = (0.1, 0.35, 0.3, 0.4);
    let (k1, k2, k3) = (d / a, d / c, (a * a - b * b + c * c + d * d) / (2.0 * a * c));
    let (sine, cosine) = law(t).sin_cos();
    let (p, q, r) = (cosine * (1.0 - k2) - k1 + k3, sine * -2.0, -cosine * (k2 + 1.0) + k1 + k3);
    let psi = ((-q - (q * q - p * r * 4.0).sqrt()) / (p * 2.0)).atan() * 2.0;
    ([psi.cos() * c + d, psi.sin() * c], psi)
}

/// Point P of the coupler.
fn tip(t: Dual3_64) -> [Dual3_64; 2] {
    let ([x, y], _) = rocker(t);
    let a = [law(t).cos() * 0.1, law(t).sin() * 0.1];
    let along = [(x - a[0]) / 0.35, (y - a[1]) / 0.35];
    [a[0] + along[0] * 0.175 - along[1] * 0.08, a[1] + along[1] * 0.175 + along[0] * 0.08]
}

/// Asserts that a motion has this value and these derivatives.
#[track_caller]
fn is_motion(found: MotionWithJerk<f64>, (value, rate, acceleration, jerk): (f64, f64, f64, f64)) {
    near(found.value, value, 1e-13);
    near(found.rate, rate, 1e-12);
    near(found.acceleration, acceleration, 1e-11);
    near(found.jerk, jerk, 1e-10);
}

/// A component of a motion of vectors.
macro_rules! component {
    ($motion:expr, $axis:expr) => {{
        let motion = $motion;
        MotionWithJerk {
            value: motion.value[$axis],
            rate: motion.rate[$axis],
            acceleration: motion.acceleration[$axis],
            jerk: motion.jerk[$axis],
        }
    }};
}

fn times() -> impl Iterator<Item = f64> {
    (0..50).map(|step| 0.05 * f64::from(step))
}

#[test]
fn the_jerk_of_a_four_bar_is_that_of_freudensteins_equation() -> Outcome {
    let mechanism = CrankRocker::default();
    for state in mechanism.sweep(times()) {
        let state = state?;
        let tip_found = mechanism.tip(&state);
        for axis in 0..2 {
            is_motion(component!(tip_found, axis), third_derivative(|t| tip(t)[axis], state.t));
            is_motion(component!(mechanism.pin(&state), axis), third_derivative(|t| [law(t).cos(), law(t).sin()][axis] * 0.1, state.t));
            is_motion(component!(mechanism.ends(&state)[0], axis), third_derivative(|t| [law(t).cos(), law(t).sin()][axis] * 0.1, state.t));
            is_motion(component!(mechanism.ends(&state)[1], axis), third_derivative(|t| rocker(t).0[axis], state.t));
            assert_eq!(mechanism.still(&state).jerk[axis], 0.0);
        }
        assert_eq!(tip_found.motion(), mechanism.plain(&state));
        is_motion(mechanism.rocking(&state), third_derivative(|t| rocker(t).1, state.t));
    }
    Ok(())
}

#[test]
fn slices_give_the_same_jerk() -> Outcome {
    let mechanism = CrankRocker::default();
    for state in mechanism.solve_for_rocking().sweep(times()) {
        let state = state?;
        is_motion(state.output(), third_derivative(|t| rocker(t).1, state.t));
        // The method of the output takes states of both kinds, and references to them.
        assert_eq!(mechanism.rocking(&state), state.output());
        assert_eq!(mechanism.rocking(&&state), state.output());
    }
    for state in mechanism.solve_for_tip().sweep(times()) {
        let state = state?;
        for axis in 0..2 {
            is_motion(component!(state.output(), axis), third_derivative(|t| tip(t)[axis], state.t));
        }
    }
    for state in mechanism.solve_for_ends().sweep(times()) {
        let state = state?;
        let [near, far] = state.output();
        for axis in 0..2 {
            is_motion(component!(near, axis), third_derivative(|t| [law(t).cos(), law(t).sin()][axis] * 0.1, state.t));
            is_motion(component!(far, axis), third_derivative(|t| rocker(t).0[axis], state.t));
        }
    }
    Ok(())
}

#[test]
fn jerks_have_derivatives_by_parameters() -> Outcome {
    let mechanism = CrankRocker::default();
    let state = mechanism.solve(0.4)?;
    let (varied, varied_state) = mechanism.derivatives(&state, |mechanism| [&mut mechanism.crank_length])?;
    let jerk = varied.rocking(&CrankRockerState(varied_state)).jerk;
    let at = |length: f64| -> Result<f64, Box<dyn std::error::Error>> {
        let mechanism = CrankRocker { crank_length: length };
        Ok(mechanism.rocking(&mechanism.solve(0.4)?).jerk)
    };
    let h = 1e-4;
    let slope = (8.0 * (at(0.1 + h)? - at(0.1 - h)?) - (at(0.1 + 2.0 * h)? - at(0.1 - 2.0 * h)?)) / (12.0 * h);
    near(jerk.by[0], slope, 1e-7);
    assert_eq!(jerk.value.to_bits(), mechanism.rocking(&state).jerk.to_bits());
    Ok(())
}

#[test]
fn lists_have_jerks_where_outputs_have_them() -> Outcome {
    const NAMES: [&str; 4] = ["rocking", "tip.y", "plain.x", "ends[1].x"];
    let mechanism = CrankRocker::default();
    let state = mechanism.solve(0.4)?;
    let (list, motions) = (mechanism.outputs_with_jerk(&state), mechanism.outputs(&state));
    let [rocking, tip, plain, end] = NAMES.map(|name| CrankRocker::<f64>::OUTPUTS.index(name).unwrap());

    assert_eq!(list[rocking], mechanism.rocking(&state));
    assert_eq!(list[tip].jerk, mechanism.tip(&state).jerk.y);
    assert_eq!(list[end].jerk, mechanism.ends(&state)[1].jerk.x);
    assert_eq!(list[plain].motion(), motions[plain]);
    assert!(list[plain].jerk.is_nan());
    assert_eq!(motions[rocking], mechanism.rocking(&state).motion());

    let names = CrankRocker::<f64>::OUTPUTS.0;
    assert_eq!(names[tip].units, ["m", "m/s", "m/s²", "m/s³"]);
    assert_eq!([rocking, tip, plain, end].map(|index| names[index].has_jerk()), [true, true, false, true]);
    Ok(())
}

#[test]
fn lists_have_derivatives_of_jerks_by_parameters() -> Outcome {
    const ROCKING: usize = CrankRocker::<f64>::OUTPUTS.index("rocking").unwrap();
    let mechanism = CrankRocker::default();
    let state = mechanism.solve(0.4)?;
    let (varied, varied_state) = mechanism.derivatives(&state, |mechanism| [&mut mechanism.crank_length])?;
    let varied_state = CrankRockerState(varied_state);
    assert_eq!(varied.outputs_with_jerk(&varied_state)[ROCKING].jerk.by, varied.rocking(&varied_state).jerk.by);
    Ok(())
}

#[test]
fn tables_have_a_column_of_jerks_where_outputs_have_them() -> Outcome {
    let mechanism = CrankRocker::default();
    let mut table = Vec::new();
    csv::write_outputs(&mut table, &mechanism, mechanism.sweep([0.0, 0.4]))?;
    let table = String::from_utf8(table)?;
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));

    let column = |name: &str| rows[0].iter().position(|title| *title == name);
    let jerk = column("tip.y jerk (m/s³)").ok_or("no jerk")?;
    let ([_, y], state) = (tip(Dual3_64::from_re(0.4).derivative()), mechanism.solve(0.4)?);
    assert_eq!(rows[2][jerk].parse(), Ok(mechanism.tip(&state).jerk.y));
    near(rows[2][jerk].parse()?, y.v3, 1e-10);
    assert_eq!(column("rocking jerk (rad/s³)"), column("rocking acceleration (rad/s²)").map(|before| before + 1));
    assert_eq!(column("plain.x jerk (m/s³)"), None);
    Ok(())
}

#[test]
fn single_precision_has_jerks() -> Outcome {
    let mechanism = CrankRocker::<f32>::with_defaults();
    let found = mechanism.rocking(&mechanism.solve(0.4)?);
    let (_, _, _, jerk) = third_derivative(|t| rocker(t).1, 0.4);
    near(f64::from(found.jerk), jerk, 1e-3);
    Ok(())
}

mechanism! {
    /// A cam by segments lifts a tappet.
    mechanism Cam {
        param speed: AngularVelocity = 5rad_s;
        body cam { }
        body tappet { }
        joint axle = revolute(ground.position, cam.position);
        joint upright = absolute_angle(tappet, 0);
        joint guide = absolute_x(tappet.position, 0mm);
        joint contact = { tappet.y == segments(cam.angle, 40mm, [rise(12mm, 120deg, cycloidal), dwell(60deg), fall(12mm, 120deg, cycloidal), dwell(60deg)], periodic); }
        drive motor = drive_angle(cam, speed * t);
        output lift = tappet.y with jerk;
        slice output alone = tappet.y with jerk;
    }
}

#[test]
fn the_jerk_of_a_cam_is_that_of_its_law() -> Outcome {
    let cam = Cam::default();
    let slice = cam.solve_for_alone();
    let beta = TAU / 3.0;
    for step in 1..20 {
        let share = f64::from(step) / 20.0;
        // s = h (x − sin 2πx / 2π) over x = θ/β
        let lift = |t: Dual3_64| (t * 5.0 / beta - (t * 5.0 / beta * TAU).sin() / TAU) * 0.012 + 0.04;
        let t = share * beta / 5.0;
        let state = cam.solve(t)?;
        let expected = third_derivative(lift, t);
        is_motion(cam.lift(&state), expected);
        is_motion(slice.solve(t)?.output(), expected);
        // At the middle of the rise: −4π² h ω³/β³
        if step == 10 {
            near(cam.lift(&state).jerk, -TAU * TAU * 0.012 * (5.0 / beta).powi(3), 1e-12);
        }
    }
    let dwelling = cam.lift(&cam.solve((beta + 0.3) / 5.0)?);
    assert_eq!((dwelling.acceleration, dwelling.jerk), (0.0, 0.0));
    Ok(())
}

mechanism! {
    /// Ten four-bars one after the other, each driven by the rocker before it.
    mechanism Chain {
        component Bars(O: Point, crank: Body) {
            body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm); }
            body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
            joint a = revolute(O, coupler.A);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.C, (400mm, 0mm));
            output rocking = rocker.angle with jerk;
        }
        body crank { point A = (100mm, 0mm);  point B = (0mm, 100mm); }
        joint o = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 0.3rad + 3rad_s * t + 1rad_s2 * t^2 - 0.5rad * (t / 1s)^3);
        for i in 0..10 {
            part bars[i] = Bars(crank.A, crank);
        }
    }
}

#[test]
fn outputs_of_many_parts_have_jerks() -> Outcome {
    let chain = Chain::default();
    let state = chain.solve(0.7)?;
    for rocking in chain.bars_rocking(&state) {
        is_motion(rocking, third_derivative(|t| rocker(t).1, 0.7));
    }
    Ok(())
}

mechanism! {
    /// Slides led by the laws that come to rest at the end of their rise.
    mechanism Risen {
        for i in 0..5 {
            body slide[i] { }
            joint rail[i] = translational((1, 0), (0m, 0m), slide[i].position);
            output at[i] = slide[i].x with jerk;
        }
        drive d[0] = drive_x(slide[0].position, 50mm * harmonic(t / 1s));
        drive d[1] = drive_x(slide[1].position, 50mm * linear(t / 1s));
        drive d[2] = drive_x(slide[2].position, 50mm * smooth_step(t / 1s));
        drive d[3] = drive_x(slide[3].position, 50mm * double_harmonic(t / 1s));
        drive d[4] = drive_x(slide[4].position, 50mm * half_cycloidal_start(t / 1s));
    }
}

#[test]
fn a_rise_ends_as_the_dwell_after_it() -> Outcome {
    let risen = Risen::default();
    for at in risen.at(&risen.solve(1.0)?) {
        assert_eq!([at.value, at.rate, at.acceleration, at.jerk], [0.05, 0.0, 0.0, 0.0]);
    }
    Ok(())
}
