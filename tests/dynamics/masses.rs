//! Masses: inertia along axes that are turned in the body, and what joints and forces add to their bodies.

use reuleaux::nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use reuleaux::{Integrator, SpatialBody, constraint, mechanism};

mechanism! {
    /// A body without forces, its principal axes turned in it.
    pub(crate) mechanism Turned in space {
        param yaw: Angle = 30deg;
        param a: Inertia = 0.2kgm2;
        param b: Inertia = 0.35kgm2;
        param c: Inertia = 0.5kgm2;
        body stone {
            axis pin = (1, 1, 0);
            mass = 2kg;
            inertia = (a, b, c) along turn((0, 0, 1), yaw) * turn(stone.pin, 50deg) * turn((0, 1, 0), -20deg);
            start orientation = turn((1, 2, 3), 40deg);
        }
        freedom fly = rate(stone.position) from (1m_s, 2m_s, -1m_s);
        freedom spin = stone.angular_velocity from (3rad_s, -1rad_s, 2rad_s);
    }
}

mechanism! {
    /// The same with the six entries of its tensor.
    pub(crate) mechanism Six in space {
        param xx: Inertia = 1kgm2;
        param yy: Inertia = 1kgm2;
        param zz: Inertia = 1kgm2;
        param xy: Inertia = 0kgm2;
        param xz: Inertia = 0kgm2;
        param yz: Inertia = 0kgm2;
        body stone { mass = 2kg;  inertia = (xx, yy, zz, xy, xz, yz);  start orientation = turn((1, 2, 3), 40deg); }
        freedom fly = rate(stone.position) from (1m_s, 2m_s, -1m_s);
        freedom spin = stone.angular_velocity from (3rad_s, -1rad_s, 2rad_s);
    }
}

/// R diag(a, b, c) Rᵀ
fn tensor(turns: &[([f64; 3], f64)], moments: [f64; 3]) -> Matrix3<f64> {
    let mut rotation = Matrix3::<f64>::identity();
    for (axis, degrees) in turns {
        rotation *= Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::from(*axis)), degrees.to_radians()).into_inner();
    }
    rotation * Matrix3::from_diagonal(&Vector3::from(moments)) * rotation.transpose()
}

fn close(one: &Vector3<f64>, two: &Vector3<f64>, bound: f64) {
    assert!((one - two).norm() <= bound * two.norm().max(1.0), "{one} for {two}");
}

/// Three principal moments along turned axes are the tensor that one computes by hand.
#[test]
fn principal_moments_along_an_orientation_are_a_tensor() {
    for (yaw, moments) in [(30.0, [0.2, 0.35, 0.5]), (-110.0, [0.4, 0.1, 0.45])] {
        let turned = Turned { yaw: f64::to_radians(yaw), a: moments[0], b: moments[1], c: moments[2] };
        let i = tensor(&[([0.0, 0.0, 1.0], yaw), ([1.0, 1.0, 0.0], 50.0), ([0.0, 1.0, 0.0], -20.0)], moments);
        let six = Six { xx: i[(0, 0)], yy: i[(1, 1)], zz: i[(2, 2)], xy: i[(0, 1)], xz: i[(0, 2)], yz: i[(1, 2)] };
        let (mut one, mut two) = (turned.initial_state().expect("a state"), six.initial_state().expect("a state"));
        close(&one.stone().angular_acceleration, &two.stone().angular_acceleration, 1e-14);
        // Euler's equation by hand.
        let (body, spin) = (one.stone(), one.stone().angular_velocity);
        let ground = body.rotation * i * body.rotation.transpose();
        let wanted = -ground.try_inverse().expect("an inverse") * spin.cross(&(ground * spin));
        close(&body.angular_acceleration, &wanted, 1e-13);
        let kinetic = 0.5 * (2.0 * body.velocity.norm_squared() + spin.dot(&(ground * spin)));
        assert!((turned.energy(&one).kinetic - kinetic).abs() < 1e-13 * kinetic);
        let (mut first, mut second) = (Integrator::new(1e-11), Integrator::new(1e-11));
        turned.advance(&mut one, 2.0, &mut first).expect("a motion");
        six.advance(&mut two, 2.0, &mut second).expect("a motion");
        close(&one.stone().angular_velocity, &two.stone().angular_velocity, 1e-9);
    }
}

mechanism! {
    /// A disk of any thickness, askew in its body.
    pub(crate) mechanism Askew in space {
        body disk {
            mass = 3kg;
            inertia = cylinder(200mm, 50mm) along turn((0, 1, 0), 35deg);
            start orientation = turn((0, 0, 1), 25deg);
        }
        freedom fly = rate(disk.position);
        freedom spin = disk.angular_velocity from (4rad_s, 1rad_s, -3rad_s);
    }
}

/// Without forces a body with an axis of symmetry goes steadily round its angular momentum L, at |L|/A.
#[test]
fn a_symmetric_body_precesses_about_its_angular_momentum() {
    let (mass, radius, length) = (3.0_f64, 0.2_f64, 0.05_f64);
    let (along, across) = (mass * radius * radius / 2.0, mass * (3.0 * radius * radius + length * length) / 12.0);
    let turn = |axis: Vector3<f64>, degrees: f64| Rotation3::from_axis_angle(&Unit::new_normalize(axis), degrees.to_radians());
    let symmetry = turn(Vector3::z(), 25.0) * turn(Vector3::y(), 35.0) * Vector3::z();
    let start = Vector3::new(4.0, 1.0, -3.0);
    let momentum = across * start + (along - across) * start.dot(&symmetry) * symmetry;
    let mechanism = Askew::default();
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-12);
    for time in [0.3, 1.0, 2.5] {
        mechanism.advance(&mut state, time, &mut integrator).expect("a motion");
        let wanted = turn(momentum, (momentum.norm() / across * time).to_degrees()) * start;
        close(&state.disk().angular_velocity, &wanted, 1e-10);
    }
}

mechanism! {
    /// A rod along y that turns about x, and a plate of 2 m along y and 1 m along z that turns about y.
    pub(crate) mechanism Shapes in space {
        ground { axis x = (1, 0, 0);  axis y = (0, 1, 0); }
        body rod   { axis x = (1, 0, 0);  mass = 3kg;  inertia = rod(2m) along turn((0, 0, 1), 90deg); }
        body plate { axis y = (0, 1, 0);  mass = 12kg;  inertia = block(0m, 1m, 2m) along turn((1, 0, 0), 90deg); }
        joint one = revolute(ground.position, ground.x, rod.position, rod.x);
        joint two = revolute(ground.position, ground.y, plate.position, plate.y);
        drive first = drive_rotation(one, 1rad_s2 * t^2);
        drive second = drive_rotation(two, 1rad_s2 * t^2);
    }
}

#[test]
fn shapes_may_be_turned() {
    let shapes = Shapes::default();
    let loads = shapes.loads(&shapes.solve(0.7).expect("a state"));
    // 3 · 2²/12 and 12 · 1²/12, at 2 rad/s².
    for effort in [loads.first().effort, loads.second().effort] {
        assert!((effort - 2.0).abs() < 1e-14, "{effort}");
    }
}

mechanism! {
    /// `dynamics/gear_joint_inertia.json`, with a quarter of the mass of the first wheel and of its inertia in the joint.
    pub(crate) mechanism GearsOfJoint in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 1, 0) from (1, 0, 0); }
        body n1 { mass = 0.75kg;  inertia = (0.015kgm2, 0.015kgm2, 0.015kgm2);  start position = (0.2m, 0m, 0.1m); }
        body n2 { mass = 2.75kg;  inertia = (0.295kgm2, 0.295kgm2, 0.295kgm2);  start position = (-0.3m, 0.4m, 0m); }
        joint gears = gear_joint(ground, n1, n2, ground.r1, ground.r2, 2.5, mass: 0.25kg, inertia: 0.005kgm2);
        force motor = motor(ground.r1, n1, (1.5 + 0.5 * (t / 1s)) * 1Nm);
        force load = motor(ground.r2, n2, -0.8Nm);
        freedom turn = dot(n1.angular_velocity, z_axis(ground.r1)) from 3rad_s;
    }
}

mechanism! {
    /// The same with all mass and inertia of the first wheel in the joint.
    pub(crate) mechanism GearsOfNothing in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 1, 0) from (1, 0, 0); }
        body n1 { start position = (0.2m, 0m, 0.1m); }
        body n2 { mass = 2kg;  inertia = (0.28kgm2, 0.28kgm2, 0.28kgm2);  start position = (-0.3m, 0.4m, 0m); }
        joint gears = gear_joint(ground, n1, n2, ground.r1, ground.r2, 2.5, mass: 1kg, inertia: 0.02kgm2);
        force motor = motor(ground.r1, n1, (1.5 + 0.5 * (t / 1s)) * 1Nm);
        force load = motor(ground.r2, n2, -0.8Nm);
        freedom turn = dot(n1.angular_velocity, z_axis(ground.r1)) from 3rad_s;
    }
}

/// Positions, speeds and accelerations of the two wheels, and multipliers.
macro_rules! of_wheels {
    ($function:ident, $kind:ident, $state:ident) => {
        fn $function(mechanism: &$kind, state: &$state) -> Vec<(&'static str, Vec<f64>)> {
            let bodies: [SpatialBody<f64>; 2] = [state.n1(), state.n2()];
            let speeds = bodies.iter().flat_map(|body| body.velocity.iter().chain(body.angular_velocity.iter()).copied());
            let rates = bodies.iter().flat_map(|body| body.acceleration.iter().chain(body.angular_acceleration.iter()).copied());
            vec![
                ("r", bodies.iter().flat_map(|body| body.position.iter().copied()).collect()),
                ("w", speeds.collect()),
                ("wdot", rates.collect()),
                ("lambda", mechanism.loads(state).multipliers.as_slice().to_vec()),
            ]
        }
    };
}

of_wheels!(of_gears, GearsOfJoint, GearsOfJointState);
of_wheels!(of_nothing, GearsOfNothing, GearsOfNothingState);
motion!(a_gear_joint_brings_a_part_of_the_inertia, "gear_joint_inertia", GearsOfJoint, of_gears);
motion!(a_gear_joint_brings_all_the_inertia_of_a_wheel, "gear_joint_inertia", GearsOfNothing, of_nothing);

/// The accelerations of two mechanisms at the start and after a while, and their multipliers.
macro_rules! same_motion {
    ($test:ident, $one:ident, $two:ident: $($body:ident),*) => {
        #[test]
        fn $test() {
            let (one, two) = ($one::default(), $two::default());
            let (mut first, mut second) = (one.initial_state().expect("a state"), two.initial_state().expect("a state"));
            for time in [0.0, 0.4] {
                one.advance(&mut first, time, &mut Integrator::new(1e-12)).expect("a motion");
                two.advance(&mut second, time, &mut Integrator::new(1e-12)).expect("a motion");
                let bound = if time == 0.0 { 1e-13 } else { 1e-9 };
                $(
                    close(&first.$body().acceleration, &second.$body().acceleration, bound);
                    close(&first.$body().angular_acceleration, &second.$body().angular_acceleration, bound);
                )*
                let (found, wanted) = (one.loads(&first).multipliers, two.loads(&second).multipliers);
                assert!((found - wanted).amax() <= bound * wanted.amax().max(1.0), "{found} for {wanted}");
                let (found, wanted) = (one.energy(&first).kinetic, two.energy(&second).kinetic);
                assert!((found - wanted).abs() <= bound * wanted, "{found} for {wanted}");
            }
        }
    };
}

/// A carrier whose mass is not in its origin, with two wheels; the numbers of the carrier are those of the first mechanism.
macro_rules! floating {
    ($name:ident, { $($carrier:tt)* }, $first:tt, $second:tt, { $($joint:tt)* }) => {
        mechanism! {
            pub(crate) mechanism $name in space {
                gravity = (0m_s2, 0m_s2, -9.81m_s2);
                body n0 { axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 0.6, 0.8) from (1, 0, 0);  $($carrier)* }
                body n1 $first
                body n2 $second
                joint gears = $($joint)*;
                force load = motor(n0.r2, n2, -0.04Nm);
                freedom fall = rate(n0.position) from (0.5m_s, -0.3m_s, 2m_s);
                freedom spin = n0.angular_velocity from (-0.18rad_s, -1.1rad_s, 1.2rad_s);
                freedom turn = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.r1)) from 4rad_s;
            }
        }
    };
}

// m = 2 kg at 3 cm and 0.5 kg at the origin: 2.5 kg at 2.4 cm; 2 · 0.6² + 0.5 · 2.4² = 3.6 kg cm² more about y and z.
floating! {
    AddedToOffset,
    { mass = 2kg;  center = (3cm, 0cm, 0cm);  inertia = (0.02kgm2, 0.03kgm2, 0.025kgm2); },
    { mass = 0.3kg;  inertia = (0.002kgm2, 0.002kgm2, 0.004kgm2);  start position = (0.1m, 0m, 0m); },
    { mass = 0.6kg;  inertia = (0.005kgm2, 0.006kgm2, 0.003kgm2);  start position = (-0.05m, 0.04m, 0.13m); },
    { gear_joint(n0, n1, n2, n0.r1, n0.r2, -1.6, mass: 0.5kg, inertia: 0.001kgm2) }
}
floating! {
    DeclaredOffset,
    { mass = 2.5kg;  center = (2.4cm, 0cm, 0cm);  inertia = (0.021kgm2, 0.03136kgm2, 0.02636kgm2); },
    { mass = 0.8kg;  inertia = (0.003kgm2, 0.003kgm2, 0.005kgm2);  start position = (0.1m, 0m, 0m); },
    { mass = 1.1kg;  inertia = (0.006kgm2, 0.007kgm2, 0.004kgm2);  start position = (-0.05m, 0.04m, 0.13m); },
    { gear_joint(n0, n1, n2, n0.r1, n0.r2, -1.6) }
}
same_motion!(a_gear_joint_adds_to_a_carrier_whose_mass_is_elsewhere, AddedToOffset, DeclaredOffset: n0, n1, n2);

/// A house on a hinge, three nodes on it, and a joint between their velocities.
macro_rules! house {
    ($name:ident, $mass:literal, $inertia:literal, { $($joints:tt)* }) => {
        mechanism! {
            pub(crate) mechanism $name in space {
                gravity = (0m_s2, 0m_s2, -9.81m_s2);
                ground { axis z = (0, 0, 1) from (1, 0, 0); }
                body n0 {
                    axis z = (0, 0, 1) from (1, 0, 0);  axis x = (1, 0, 0) from (0, 1, 0);  axis y = (0, 1, 0) from (1, 0, 0);
                    point P1 = (0.12m, 0m, 0m);  point P2 = (0m, 0.15m, 0m);  point P3 = (0m, -0.15m, 0m);
                    mass = 3kg + $mass;  inertia = (0.04kgm2 + $inertia, 0.05kgm2 + $inertia, 0.06kgm2 + $inertia, 0.003kgm2, 0kgm2, 0kgm2);
                }
                body n1 {
                    axis x = (1, 0, 0) from (0, 1, 0);  axis y = (0, 1, 0) from (1, 0, 0);
                    mass = 0.6kg + $mass;  inertia = (0.002kgm2 + $inertia, 0.0012kgm2 + $inertia, 0.0012kgm2 + $inertia);
                    start position = (0.12m, 0m, 0m);
                }
                body n2 {
                    axis x = (1, 0, 0) from (0, 1, 0);  axis y = (0, 1, 0) from (1, 0, 0);
                    mass = 0.9kg + $mass;  inertia = (0.002kgm2 + $inertia, 0.003kgm2 + $inertia, 0.002kgm2 + $inertia);
                    start position = (0m, 0.15m, 0m);
                }
                joint carrier = revolute(ground.position, ground.z, n0.position, n0.z);
                force input = motor(n0.x, n1, (0.8 + 0.3 * sin(4 * (t / 1s) * 1rad)) * 1Nm);
                force load = motor(n0.y, n2, -0.3Nm);
                freedom turn = dot(n0.angular_velocity, z_axis(ground.z)) from 2rad_s;
                $($joints)*
            }
        }
    };
}

house!(AddedRack, 0kg, 0kgm2, {
    joint rack = rack_and_pinion_joint(n0, n1, n2, n0.x, n0.y, 0.05m / 1rad, mass: 0.4kg, inertia: 0.002kgm2);
    joint b1 = spherical(n0.P1, n1.position);
    joint held = parallel_axes(n0.x, n1.x);
    freedom pinion = dot(n1.angular_velocity, z_axis(n0.x)) from 3rad_s;
    freedom free = n2.angular_velocity;
});
house!(DeclaredRack, 0.4kg, 0.002kgm2, {
    joint rack = rack_and_pinion_joint(n0, n1, n2, n0.x, n0.y, 0.05m / 1rad);
    joint b1 = spherical(n0.P1, n1.position);
    joint held = parallel_axes(n0.x, n1.x);
    freedom pinion = dot(n1.angular_velocity, z_axis(n0.x)) from 3rad_s;
    freedom free = n2.angular_velocity;
});
same_motion!(a_rack_and_pinion_joint_adds_to_its_nodes, AddedRack, DeclaredRack: n0, n1, n2);

house!(AddedGuided, 0kg, 0kgm2, {
    joint rack = guided_rack_and_pinion_joint(n0, n1, n2, n0.x, n0.y, 0.05m / 1rad, mass: 0.4kg, inertia: 0.002kgm2);
    joint bearing = parallel_axes(n0.x, n1.x);
    freedom pinion = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.x)) from 3rad_s;
});
house!(DeclaredGuided, 0.4kg, 0.002kgm2, {
    joint rack = guided_rack_and_pinion_joint(n0, n1, n2, n0.x, n0.y, 0.05m / 1rad);
    joint bearing = parallel_axes(n0.x, n1.x);
    freedom pinion = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.x)) from 3rad_s;
});
same_motion!(a_guided_rack_and_pinion_joint_adds_to_its_nodes, AddedGuided, DeclaredGuided: n0, n1, n2);

house!(AddedDifferential, 0kg, 0kgm2, {
    body n3 { mass = 0.9kg;  inertia = (0.0025kgm2, 0.004kgm2, 0.0025kgm2);  start position = (0m, -0.15m, 0m); }
    joint b1 = spherical(n0.P1, n1.position);
    joint b2 = spherical(n0.P2, n2.position);
    joint b3 = spherical(n0.P3, n3.position);
    joint gears = differential_joint(n0, n1, n2, n3, n0.x, n0.y, n0.y, -2, mass: 0.4kg, inertia: 0.002kgm2);
    freedom one = n1.angular_velocity from (1rad_s, 0rad_s, 2rad_s);
    freedom two = n2.angular_velocity from (0rad_s, 1rad_s, 2rad_s);
});
house!(DeclaredDifferential, 0.4kg, 0.002kgm2, {
    body n3 { mass = 1.3kg;  inertia = (0.0045kgm2, 0.006kgm2, 0.0045kgm2);  start position = (0m, -0.15m, 0m); }
    joint b1 = spherical(n0.P1, n1.position);
    joint b2 = spherical(n0.P2, n2.position);
    joint b3 = spherical(n0.P3, n3.position);
    joint gears = differential_joint(n0, n1, n2, n3, n0.x, n0.y, n0.y, -2);
    freedom one = n1.angular_velocity from (1rad_s, 0rad_s, 2rad_s);
    freedom two = n2.angular_velocity from (0rad_s, 1rad_s, 2rad_s);
});
same_motion!(a_differential_joint_adds_to_its_nodes, AddedDifferential, DeclaredDifferential: n0, n1, n2, n3);

house!(AddedOnBearings, 0kg, 0kgm2, {
    body n3 { mass = 0.9kg;  inertia = (0.0025kgm2, 0.004kgm2, 0.0025kgm2);  start position = (0m, -0.15m, 0m); }
    joint b1 = spherical(n0.P1, n1.position);
    joint b2 = spherical(n0.P2, n2.position);
    joint b3 = spherical(n0.P3, n3.position);
    joint gears = differential_joint_on_bearings(n0, n1, n2, n3, n0.x, n0.y, n0.y, -2, mass: 0.4kg, inertia: 0.002kgm2);
    freedom left = dot(n2.angular_velocity - n0.angular_velocity, z_axis(n0.y)) from 1rad_s;
    freedom right = dot(n3.angular_velocity - n0.angular_velocity, z_axis(n0.y)) from -0.5rad_s;
});
house!(DeclaredOnBearings, 0.4kg, 0.002kgm2, {
    body n3 { mass = 1.3kg;  inertia = (0.0045kgm2, 0.006kgm2, 0.0045kgm2);  start position = (0m, -0.15m, 0m); }
    joint b1 = spherical(n0.P1, n1.position);
    joint b2 = spherical(n0.P2, n2.position);
    joint b3 = spherical(n0.P3, n3.position);
    joint gears = differential_joint_on_bearings(n0, n1, n2, n3, n0.x, n0.y, n0.y, -2);
    freedom left = dot(n2.angular_velocity - n0.angular_velocity, z_axis(n0.y)) from 1rad_s;
    freedom right = dot(n3.angular_velocity - n0.angular_velocity, z_axis(n0.y)) from -0.5rad_s;
});
same_motion!(a_differential_joint_on_bearings_adds_to_its_nodes, AddedOnBearings, DeclaredOnBearings: n0, n1, n2, n3);

constraint! {
    /// A hinge with a bob at its end, at a distance from it.
    pub constraint weighted_hinge(P: Point, Q: Point, at: Point, bob: Mass, rim: Inertia = 0kgm2) {
        add mass at at: bob;
        add inertia on Q.body: rim;
        P == Q;
    }

    /// A spring that weighs something: a third of its mass moves with its end.
    pub force heavy_spring(P: Point, Q: Point, stiffness: Stiffness, mass: Mass) {
        add mass at Q: mass / 3;
        at P: stiffness * (Q - P);
        at Q: -stiffness * (Q - P);
    }
}

mechanism! {
    /// A rod with the masses that a joint and a force of one's own add to it, at two points.
    pub(crate) mechanism Bobs {
        use crate::masses::{heavy_spring, weighted_hinge};
        gravity = (0, -9.81m_s2);
        param bob: Mass = 2kg;
        body rod { point O = (0m, 0m);  point end = (1m, 0m);  point side = (0m, 0.5m);  mass = 1kg;  center = (0.5m, 0m); }
        joint pin = weighted_hinge((0m, 0m), rod.O, rod.end, bob, rim: 0.25kgm2);
        force spring = heavy_spring((1m, 0.5m), rod.side, 10N_m, 3kg);
        freedom swing = rod.angle from 30deg at 2rad_s;
    }
}

/// Newton's law by hand, about the hinge.
#[test]
fn definitions_add_masses_at_points() {
    let mechanism = Bobs { bob: 1.5 };
    let state = mechanism.initial_state().expect("a state");
    let (sine, cosine) = f64::to_radians(30.0).sin_cos();
    let inertia = 0.25 + 1.5 + 0.25 + 0.25;
    let weight = 9.81 * (0.5 * cosine + 1.5 * cosine - 0.5 * sine);
    let side = [-0.5 * sine, 0.5 * cosine];
    let pull = [10.0 * (1.0 - side[0]), 10.0 * (0.5 - side[1])];
    let wanted = (side[0] * pull[1] - side[1] * pull[0] - weight) / inertia;
    assert!((state.rod().angular_acceleration - wanted).abs() < 1e-14 * wanted.abs(), "{}", state.rod().angular_acceleration);
    let energy = mechanism.energy(&state);
    assert!((energy.kinetic - 0.5 * inertia * 4.0).abs() < 1e-14);
    let height = 0.5 * sine + 1.5 * sine + 0.5 * cosine;
    assert!((energy.potential - 9.81 * height).abs() < 1e-13);
    // The weight of all three is on the hinge, with what turns.
    let turn = |x: f64, y: f64| [-wanted * y - 4.0 * x, wanted * x - 4.0 * y];
    let at = |x: f64, y: f64| turn(cosine * x - sine * y, sine * x + cosine * y);
    let masses = [(1.0, at(0.5, 0.0)), (1.5, at(1.0, 0.0)), (1.0, at(0.0, 0.5))];
    let force = [0, 1].map(|k| masses.iter().map(|(mass, a)| mass * a[k]).sum::<f64>() - pull[k]);
    let found = mechanism.loads(&state).pin().force;
    assert!((found.x - force[0]).abs() < 1e-12 && (found.y - force[1] - 3.5 * 9.81).abs() < 1e-12, "{found}");
}

mechanism! {
    /// A body in space and a pendulum's bob, with masses that are parameters.
    mechanism Weighed in space {
        param mass: Mass = 2kg;
        param about_y: Inertia = 0.2kgm2;
        param about_z: Inertia = 0.3kgm2;
        ground { point O = (0m, 0m, 0m); }
        body top { mass = mass; center = (0.5m, 0m, 0m); inertia = (0.1kgm2, about_y, about_z); }
        joint pivot = spherical(ground.O, top.position);
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        freedom spin = top.angular_velocity from (0rad_s, 1rad_s, 0rad_s);
    }
}

mechanism! {
    /// In the plane.
    mechanism Bob {
        param mass: Mass = 2kg;
        param inertia: Inertia = 0.2kgm2;
        ground { point O = (0m, 0m); }
        body bob { mass = mass; center = (0.5m, 0m); inertia = inertia; }
        joint pivot = revolute(ground.O, bob.position);
        gravity = (0m_s2, -9.81m_s2);
        freedom swing = bob.angle from 0deg;
    }
}

/// What the compiler refuses of the defaults (E1103) is refused of other values when there are any.
#[test]
fn impossible_masses_of_parameters_are_refused() {
    let weighed = |mass, about_y, about_z| Weighed { mass, about_y, about_z }.initial_state().map(|_| ()).map_err(|why| why.to_string());
    // 0.3 = 0.1 + 0.2 is a plate; a millionth beyond may be rounding.
    for [about_y, about_z] in [[0.2, 0.3], [0.3, 0.2], [0.25, 0.25], [0.2, 0.3 + 1e-6]] {
        assert_eq!(weighed(2.0, about_y, about_z), Ok(()), "{about_y} {about_z}");
    }
    for [about_y, about_z] in [[0.2, 0.31], [0.31, 0.2], [0.04, 0.05], [-0.2, 0.3], [0.2, -0.001]] {
        let why = weighed(2.0, about_y, about_z).expect_err("no such body");
        assert!(why.contains("`top.inertia`") && why.contains("`about_y`, `about_z`"), "{why}");
    }
    let why = weighed(-0.2, 0.2, 0.3).expect_err("no such body");
    assert_eq!(why, "the parameter `mass` is -0.2 kg: a mass must not be negative (`top.mass`)");

    let bob = |mass, inertia| Bob { mass, inertia }.initial_state().map(|_| ()).map_err(|why| why.to_string());
    assert_eq!(bob(0.0, 0.2), Ok(()));
    let why = bob(2.0, -0.1).expect_err("no such body");
    assert_eq!(why, "the parameter `inertia` is -0.1 kg m²: an inertia must not be negative (`bob.inertia`)");
}

mechanism! {
    /// A stone on a ball joint at its centre.
    mechanism Held in space {
        param inertia: Inertia = 0.2kgm2;
        body stone { mass = 1kg; inertia = (inertia, inertia, inertia); }
        joint ball = spherical(ground.position, stone.position);
        freedom spin = stone.angular_velocity from (0rad_s, 0rad_s, 1rad_s);
    }
}

/// A message speaks of what the reader declared, and not of components of quaternions.
#[test]
fn a_body_that_turns_without_inertia_is_named() {
    assert_eq!(Held::default().initial_state().map(|_| ()), Ok(()));
    let why = Held { inertia: 0.0 }.initial_state().map(|_| ()).map_err(|why| why.to_string());
    let wanted = "at t = 0 s no mass or inertia resists a turning of `stone`; give a body that turns with it an inertia";
    assert_eq!(why, Err(wanted.to_owned()));
}

mechanism! {
    /// A body that turns about a point, with products of inertia that are parameters.
    mechanism Deviating in space {
        param xy: Inertia = 0kgm2;
        param xz: Inertia = 0kgm2;
        param yz: Inertia = 0kgm2;
        ground { point O = (0m, 0m, 0m); }
        body top { mass = 2kg; inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2, xy, xz, yz); }
        joint pivot = spherical(ground.O, top.position);
        freedom spin = top.angular_velocity from (0rad_s, 1rad_s, 0rad_s);
    }
}

/// tr(I) − 2 I has the eigenvalues 0.1 and 0.1 ± 2 xy with one product, 0.1 − 4 p and twice 0.1 + 2 p with three equal ones.
#[test]
fn impossible_products_of_inertia_are_refused() {
    let turned = |xy, xz, yz| Deviating { xy, xz, yz }.initial_state().map(|_| ()).map_err(|why| why.to_string());
    for (one, three) in [(0.0, 0.0), (0.049, 0.024), (0.05, 0.025), (-0.049, -0.049), (-0.05, -0.03)] {
        assert_eq!(turned(one, 0.0, 0.0), Ok(()), "{one}");
        assert_eq!(turned(0.0, 0.0, one), Ok(()), "{one}");
        assert_eq!(turned(three, three, three), Ok(()), "{three}");
    }
    for (one, three) in [(0.0501, 0.0251), (-0.0501, -0.0501), (0.2, 0.03), (0.11, 0.2)] {
        for refused in [turned(one, 0.0, 0.0), turned(0.0, one, 0.0), turned(0.0, 0.0, one), turned(three, three, three)] {
            let why = refused.expect_err("no such body");
            assert!(why.contains("no distribution of mass") && why.contains("`top.inertia`"), "{why}");
        }
    }
}
