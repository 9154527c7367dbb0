//! Accelerations in closed form against a dense solution in the coordinates of all bodies.

use crate::compile;
use crate::expr::tests::samples::samples;
use crate::expr::{Spin, SpinAxes, Values, evaluate};
use crate::linear::dense;
use crate::numeric::at_defaults;
use crate::quantity::Role;
use std::f64::consts::TAU;

/// Ground, crank, coupler and rocker.
type Lengths = [f64; 4];

const SWINGING: Lengths = [4.0, 1.0, 3.5, 3.0];
const PARALLEL: Lengths = [4.0, 3.0, 4.0, 3.0];

/// A four-bar with a free crank, assembled with these angles of crank, coupler and rocker.
fn declaration([ground, crank, coupler, rocker]: Lengths, [start, of_coupler, of_rocker]: [f64; 3]) -> String {
    format!(
        "mechanism FourBar {{
            gravity = (0, -9.81m_s2);
            ground {{ point D = ({ground}m, 0m); }}
            body crank   {{ point B = ({crank}m, 0m);    mass = 1kg;    center = ({crank}m / 2, 0.1m);     inertia = 0.1kgm2; }}
            body coupler {{ point C = ({coupler}m, 0m);  mass = 3.5kg;  center = ({coupler}m / 2, -0.2m);  inertia = 4kgm2;  start angle = {of_coupler}rad; }}
            body rocker  {{ point C = ({rocker}m, 0m);   mass = 3kg;    center = ({rocker}m / 2, 0m);      inertia = 2kgm2;  start angle = {of_rocker}rad; }}
            joint a = revolute(ground.position, crank.position);
            joint b = revolute(crank.B, coupler.position);
            joint c = revolute(coupler.C, rocker.C);
            joint d = revolute(rocker.position, ground.D);
            freedom swing = crank.angle from {start}rad;
        }}"
    )
}

/// Positions and speeds of crank, coupler and rocker, three each, for an angle and a speed of the crank: the coupler's end is where circles
/// about the ends of crank and ground meet.
fn pose([ground, crank, coupler, rocker]: Lengths, [angle, speed]: [f64; 2]) -> [Vec<f64>; 2] {
    let (sine, cosine) = angle.sin_cos();
    let b = [crank * cosine, crank * sine];
    let d = [ground - b[0], -b[1]];
    let square = d[0] * d[0] + d[1] * d[1];
    let along = 0.5 + (coupler * coupler - rocker * rocker) / (2.0 * square);
    let across = (coupler * coupler / square - along * along).sqrt();
    let c = [b[0] + along * d[0] - across * d[1], b[1] + along * d[1] + across * d[0]];
    let of_coupler = (c[1] - b[1]).atan2(c[0] - b[0]);
    let of_rocker = c[1].atan2(c[0] - ground);
    let transmission = (of_rocker - of_coupler).sin();
    let rate_of_coupler = speed * crank * (angle - of_rocker).sin() / (coupler * transmission);
    let rate_of_rocker = speed * crank * (angle - of_coupler).sin() / (rocker * transmission);
    let coordinates = vec![0.0, 0.0, angle, b[0], b[1], of_coupler, ground, 0.0, of_rocker];
    let speeds = vec![0.0, 0.0, speed, -speed * b[1], speed * b[0], rate_of_coupler, 0.0, 0.0, rate_of_rocker];
    [coordinates, speeds]
}

/// Counts the poses in which a pivot is not trusted; in the others accelerations are compared with those of Lagrange's equations of the first
/// kind.
fn untrusted(lengths: Lengths, start: f64, motions: impl Iterator<Item = [f64; 2]>) -> usize {
    let assembled = &pose(lengths, [start, 0.0])[0];
    untrusted_states(&declaration(lengths, [start, assembled[5], assembled[8]]), motions.map(|motion| pose(lengths, motion)))
}

/// The same for coordinates and speeds.
fn untrusted_states(declaration: &str, states: impl Iterator<Item = [Vec<f64>; 2]>) -> usize {
    let compiled = compile(declaration.parse().expect("tokens")).expect("a valid mechanism");
    let code = compiled.plan.dynamics.as_ref().expect("equations of motion");
    let routine = code.accelerations.as_ref().expect("accelerations in closed form");
    let (mut count, mut worst) = (0, 0.0_f64);
    for [coordinates, speeds] in states {
        let wanted = dense_accelerations(&compiled, &coordinates, &speeds);
        let found = at_defaults(&compiled.model, &compiled.system, |numeric| {
            evaluate(&code.arena, &routine.results, &Values { coordinates: &coordinates, speeds: &speeds, ..numeric.known })
        });
        let (values, pivots) = found.split_at(code.integrated.len());
        if pivots.chunks(2).any(|pair| pair[0].abs() <= pair[1]) {
            count += 1;
            continue;
        }
        let size = wanted.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        for (unknown, value) in code.integrated.iter().zip(values) {
            worst = worst.max((value - wanted[*unknown]).abs() / size);
        }
    }
    assert!(worst < 1e-11, "{worst:e}");
    count
}

/// u̇ of M u̇ + Φ_uᵀ λ = −f, Φ_u u̇ = γ in all speeds of bodies.
fn dense_accelerations(compiled: &crate::Compiled, coordinates: &[f64], speeds: &[f64]) -> Vec<f64> {
    let system = &compiled.system;
    let forces = &system.balance.as_ref().expect("forces").forces;
    let rows: Vec<_> = system.equations.iter().chain(&system.of_speeds).filter(|row| !row.is_initial).collect();
    let (width, size) = (speeds.len(), speeds.len() + rows.len());
    at_defaults(&compiled.model, system, |numeric| {
        let forces_at =
            |accelerations: &[f64]| evaluate(&system.arena, forces, &Values { coordinates, speeds, accelerations, ..numeric.known });
        let still = vec![0.0; width];
        let rest = forces_at(&still);
        let (mut matrix, mut right) = (vec![vec![0.0; size]; size], rest.iter().map(|force| -force).collect::<Vec<f64>>());
        for column in 0..width {
            let mut unit = still.clone();
            unit[column] = 1.0;
            forces_at(&unit).iter().zip(&rest).enumerate().for_each(|(row, (force, rest))| matrix[row][column] = force - rest);
        }
        for (number, row) in rows.iter().enumerate() {
            let roots: Vec<_> = row.jacobian.iter().map(|(_, entry)| *entry).chain([row.gamma]).collect();
            let values = evaluate(&system.arena, &roots, &Values { coordinates, speeds, accelerations: &still, ..numeric.known });
            for ((speed, _), value) in row.jacobian.iter().zip(&values) {
                matrix[width + number][*speed] = *value;
                matrix[*speed][width + number] = *value;
            }
            right.extend(values.last());
        }
        dense::solve(matrix, &right).expect("a regular pose")
    })
}

#[test]
fn a_swinging_four_bar_has_accelerations_in_closed_form_in_all_poses() {
    // Among them the one with crank and coupler in line, in which the rocker stands still: 4.5, 4 and 3 m are the sides of a triangle.
    let in_line = ((4.5_f64.powi(2) + 4.0_f64.powi(2) - 3.0_f64.powi(2)) / (2.0 * 4.5 * 4.0)).acos();
    let swing = (0..256).map(|k| {
        let (sine, cosine) = (TAU * f64::from(k) / 256.0).sin_cos();
        [0.3 + 1.2 * sine, 1.2 * TAU * cosine]
    });
    let near = [-1e-3, 0.0, 1e-3].map(|off| [in_line + off, 2.0]);
    assert_eq!(untrusted(SWINGING, 0.3, swing.chain(near)), 0);
}

#[test]
fn a_crank_that_turns_has_accelerations_in_closed_form_throughout() {
    assert_eq!(untrusted(SWINGING, 0.3, (0..256).map(|k| [TAU * f64::from(k) / 256.0, 1.0])), 0);
}

#[test]
fn a_horizontal_coupler_does_no_harm() {
    // The coupler of a parallelogram stays horizontal.
    assert_eq!(untrusted(PARALLEL, 1.2, (0..64).map(|k| [0.5 + 0.03 * f64::from(k), 1.0])), 0);
}

#[test]
fn bars_in_line_are_not_trusted() {
    // A crank of 1 m across the ground leaves between the pins of coupler and rocker, 3.5 and 3 m long, almost their sum.
    let ground = (6.499_999_f64.powi(2) - 1.0).sqrt();
    let motions = [[0.3, 1.0], [TAU / 4.0, 1.0]];
    assert_eq!(untrusted([ground, 1.0, 3.5, 3.0], 0.3, motions.into_iter()), 1);
}

/// A body on a ball joint, of which the centre of mass is elsewhere, with a spring, a force and another body on a hinge.
const TOP: &str = "mechanism Top in space {
    gravity = (0, 0, -9.81m_s2);
    body top {
        point tip = (0.1m, -0.2m, 0.3m);  point side = (0.4m, 0, 0);  axis pin = (1, 2, 2);
        mass = 2kg;  center = (0.05m, 0.02m, 0.1m);  inertia = (0.3kgm2, 0.4kgm2, 0.5kgm2, 0.02kgm2, -0.03kgm2, 0.01kgm2);
    }
    body flap {
        point P = (0, 0.1m, 0);  axis pin = (0, 0, 1);
        mass = 0.5kg;  center = (0.2m, 0, 0.1m);  inertia = (0.02kgm2, 0.03kgm2, 0.04kgm2);
    }
    joint ball = spherical(ground.position, top.tip);
    joint hinge = revolute(top.side, top.pin, flap.P, flap.pin);
    force push = { at top.side: (3N, -2N, 5N);  on top: (0.1Nm, 0.2Nm, -0.3Nm); }
    energy spring = 20N_m * dot(top.side - (1m, 0, 0), top.side - (1m, 0, 0));
    freedom tumble = top.angular_velocity from (1rad_s, 2rad_s, 3rad_s);
    freedom swing = hinge.angle from 0.3rad;
}";

/// Two nodes that turn in a fixed ratio about axes of a carrier, by equations of velocities.
const GEARS: &str = "mechanism Gears in space {
    gravity = (0, 0, -9.81m_s2);
    body carrier { axis first = (0, 0, 1);  axis second = (0, 1, 0);  mass = 5kg;  inertia = (0.3kgm2, 0.2kgm2, 0.1kgm2); }
    body first { mass = 2kg;  inertia = (0.05kgm2, 0.06kgm2, 0.07kgm2);  start position = (400mm, 0mm, 100mm); }
    body second { mass = 3kg;  inertia = (0.1kgm2, 0.2kgm2, 0.15kgm2);  start position = (-300mm, 500mm, 0mm); }
    joint gears = gear_joint(carrier, first, second, carrier.first, carrier.second, 2.5);
    freedom glide = rate(carrier.position) from (1m_s, -0.5m_s, 2m_s);
    freedom tumble = carrier.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
    freedom spin = dot(carrier.first, first.angular_velocity - carrier.angular_velocity) from 4rad_s;
}";

/// The same with nodes that are balls, loaded beside their centres.
const BALLS: &str = "mechanism Balls in space {
    gravity = (0, 0, -9.81m_s2);
    body carrier { axis first = (0, 0.6, 0.8);  axis second = (0, 1, 0);  mass = 5kg;  inertia = (0.3kgm2, 0.2kgm2, 0.1kgm2); }
    body first {
        point rim = (0.1m, 0.2m, -0.1m);
        mass = 2kg;  inertia = (0.05kgm2, 0.05kgm2, 0.05kgm2);  start position = (400mm, 0mm, 100mm);
    }
    body second { mass = 3kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2);  start position = (-300mm, 500mm, 0mm); }
    joint gears = gear_joint(carrier, first, second, carrier.first, carrier.second, 2.5);
    force push = { at first.rim: (3N, -2N, 5N);  on second: (0.1Nm, 0.2Nm, -0.3Nm); }
    energy spring = 20N_m * dot(first.rim - (1m, 0, 0), first.rim - (1m, 0, 0));
    freedom glide = rate(carrier.position) from (1m_s, -0.5m_s, 2m_s);
    freedom tumble = carrier.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
    freedom spin = dot(carrier.first, first.angular_velocity - carrier.angular_velocity) from 4rad_s;
}";

/// A ball that rolls on ground, with a string at its rim, and carries another one by velocities.
const ROLLING: &str = "mechanism Rolling in space {
    gravity = (0, 0, -9.81m_s2);
    ground { axis up = (0, 0, 1); }
    body ball {
        point rim = (0.03m, 0.04m, 0);
        mass = 2kg;  inertia = (0.002kgm2, 0.002kgm2, 0.002kgm2);  start position = (0, 0, 50mm);
    }
    body upper { mass = 1kg;  inertia = (0.001kgm2, 0.001kgm2, 0.001kgm2);  start position = (0, 0, 100mm); }
    joint rolling = rolling_ball(ground.up, ball.position, 50mm);
    joint turned = { upper.angular_velocity + ball.angular_velocity == (0rad_s, 0rad_s, 0rad_s); }
    joint above = { rate(upper.position) == rate(ball.position) + cross(ball.angular_velocity, (0m, 0m, 50mm)); }
    force pull = { at ball.rim: (3N, -2N, 5N);  on upper: (0.1Nm, 0.2Nm, -0.3Nm); }
    freedom turning = ball.angular_velocity from (1rad_s, 2rad_s, -1.5rad_s);
}";

/// Coordinates and speeds at random, with quaternions of norm 1; those that are not integrated follow from the others.
fn at_random(declaration: &str) -> impl Iterator<Item = [Vec<f64>; 2]> + use<> {
    let compiled = compile(declaration.parse().expect("tokens")).expect("a valid mechanism");
    let roles: Vec<Role> = compiled.system.coordinates.iter().map(|coordinate| coordinate.role).collect();
    let mut seed = 1_u64;
    let mut draw = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..samples(8, 64)).map(move |_| {
        let [mut coordinates, mut speeds]: [Vec<f64>; 2] = [1.0, 5.0].map(|size| roles.iter().map(|_| size * draw()).collect());
        let first_of_each: Vec<usize> = (0..roles.len()).filter(|number| roles[*number] == Role::Quaternion(0)).collect();
        for first in first_of_each {
            let (e, rates) = (&mut coordinates[first..first + 4], &mut speeds[first..first + 4]);
            let norm = e.iter().map(|part| part * part).sum::<f64>().sqrt();
            e.iter_mut().for_each(|part| *part /= norm);
            let along: f64 = e.iter().zip(rates.iter()).map(|(part, rate)| part * rate).sum();
            rates.iter_mut().zip(e).for_each(|(rate, part)| *rate -= along * *part);
        }
        completed(&compiled, &coordinates, &speeds)
    })
}

/// Coordinates and speeds, from those that are integrated.
fn completed(compiled: &crate::Compiled, coordinates: &[f64], speeds: &[f64]) -> [Vec<f64>; 2] {
    let code = compiled.plan.dynamics.as_ref().expect("equations of motion");
    let still = vec![0.0; speeds.len()];
    let found = at_defaults(&compiled.model, &compiled.system, |numeric| {
        evaluate(&code.arena, &code.state.results, &Values { coordinates, speeds, accelerations: &still, ..numeric.known })
    });
    [0, 1].map(|order| found.chunks(3).take(speeds.len()).map(|motion| motion[order]).collect())
}

#[test]
fn a_body_that_is_free_to_turn_has_accelerations_in_closed_form_in_all_orientations() {
    assert_eq!(untrusted_states(TOP, at_random(TOP)), 0);
}

#[test]
fn nodes_on_a_carrier_have_accelerations_in_closed_form_in_all_orientations() {
    assert_eq!(untrusted_states(GEARS, at_random(GEARS)), 0);
}

/// The axes along which ω of each body that is free to turn has its components.
fn axes_of_spins(declaration: &str) -> Vec<&'static str> {
    let compiled = compile(declaration.parse().expect("tokens")).expect("a valid mechanism");
    let by_spins = compiled.system.by_spins.as_ref().expect("bodies that are free to turn");
    let name = |spin: &Spin| match spin.axes {
        SpinAxes::Own => "own",
        SpinAxes::Ground => "ground",
        SpinAxes::Of(_) => "another body's",
    };
    by_spins.spins.iter().map(name).collect()
}

#[test]
fn balls_turn_in_the_axes_of_their_equations() {
    assert_eq!(axes_of_spins(GEARS), ["own"; 3]);
    assert_eq!(axes_of_spins(BALLS), ["own", "another body's", "another body's"]);
    assert_eq!(axes_of_spins(ROLLING), ["ground"; 2]);
    // A body that is a ball only for some values of the parameters does not count as one.
    let ball = "inertia = (0.05kgm2, 0.05kgm2, 0.05kgm2)";
    let params = "param a: Inertia = 0.05kgm2;  param b: Inertia = 0.05kgm2;  param off: Length = 0mm;  gravity";
    for of_parameters in
        ["inertia = (a, a, b)", "center = (off, 0m, 0m);  inertia = (a, a, b)", "center = (off, 0m, 0m);  inertia = (b, b, b + a - a)"]
    {
        let declaration = BALLS.replacen("gravity", params, 1).replacen(ball, of_parameters, 1);
        assert_eq!(axes_of_spins(&declaration), ["own", "own", "another body's"], "{of_parameters}");
    }
    for declaration in [BALLS, ROLLING] {
        assert_eq!(untrusted_states(declaration, at_random(declaration)), 0);
    }
}
