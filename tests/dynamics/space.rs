//! Mechanisms in space, and rows of velocities.

use reuleaux::{SpatialBody, mechanism};

mechanism! {
    /// `dynamics/universal_double_pendulum.json`.
    pub(crate) mechanism UniversalPendulum in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point O = (0m, 0m, 0m);  axis x = (1, 0, 0) from (0, 1, 0); }
        body link1 {
            point O = (0m, 0m, 0m);  point E = (0m, 0m, -0.5m);  axis x = (1, 0, 0) from (0, 1, 0);  axis y = (0, 1, 0);
            mass = 1.2kg;  center = (0.01m, 0.02m, -0.24m);
            inertia = (0.03kgm2, 0.028kgm2, 0.004kgm2, 0.001kgm2, -0.002kgm2, 0.0015kgm2);
            start orientation = turn((1, 0, 0), 0.9rad) * turn((0, 1, 0), 0.3rad);
        }
        body link2 {
            point O = (0m, 0m, 0m);  axis y = (0, 1, 0);
            mass = 0.7kg;  center = (0m, -0.015m, -0.17m);
            inertia = (0.012kgm2, 0.011kgm2, 0.003kgm2, -0.0004kgm2, 0.001kgm2, 0kgm2);
            start orientation = turn((1, 0, 0), 0.9rad) * turn((0, 1, 0), 0.3rad) * turn((1, 0, 0), -0.4rad) * turn((0, 1, 0), 0.6rad);
        }
        joint upper = universal(ground.O, ground.x, link1.O, link1.y);
        joint lower = universal(link1.E, link1.x, link2.O, link2.y);
        freedom a = dot(link1.angular_velocity, z_axis(ground.x));
        freedom b = dot(link1.angular_velocity, z_axis(link1.y)) from 1rad_s;
        freedom c = dot(link2.angular_velocity - link1.angular_velocity, z_axis(link1.x));
        freedom d = dot(link2.angular_velocity - link1.angular_velocity, z_axis(link2.y)) from -2rad_s;
    }
}

mechanism! {
    /// `dynamics/heavy_top_nutation.json`.
    pub(crate) mechanism NutatingTop in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body top {
            point foot = (0m, 0m, -0.11m);  mass = 1.3kg;  inertia = (0.004kgm2, 0.004kgm2, 0.0017kgm2);
            start orientation = turn((1, 0, 0), 0.5rad);
        }
        joint pin = spherical((0m, 0m, 0m), top.foot);
        freedom spin = top.angular_velocity from (0rad_s, -57.531064632504360033rad_s, 105.30990742684472593rad_s);
    }
}

mechanism! {
    /// `dynamics/heavy_top_steady.json`.
    pub(crate) mechanism SteadyTop in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body top {
            point foot = (0m, 0m, 0m);  mass = 1.3kg;  center = (0m, 0m, 0.11m);  inertia = (0.004kgm2, 0.004kgm2, 0.0017kgm2);
            start orientation = turn((1, 0, 0), 0.7rad);
        }
        joint pin = spherical((0m, 0m, 0m), top.foot);
        freedom spin = top.angular_velocity from (0rad_s, -132.44983895103523032rad_s, 162.24998946111069931rad_s);
    }
}

mechanism! {
    /// `dynamics/free_body.json`.
    pub(crate) mechanism FreeBody in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body body {
            mass = 0.8kg;  inertia = (0.02kgm2, 0.035kgm2, 0.05kgm2);
            start orientation = turn((0.2397127693021015, 0.06120871905481364, 0.04842543793313917), 0.509696732480922rad);
        }
        freedom fall = rate(body.position) from (0.5m_s, -0.2m_s, 3m_s);
        freedom spin = body.angular_velocity from (-0.12592183730482503459rad_s, 1.7516108065610587629rad_s, 0.95728954513683808135rad_s);
    }
}

mechanism! {
    /// `dynamics/gear_joint_inertia.json`.
    pub(crate) mechanism GearsOnGround in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 1, 0) from (1, 0, 0); }
        body n1 { mass = 1kg;  inertia = (0.02kgm2, 0.02kgm2, 0.02kgm2);  start position = (0.2m, 0m, 0.1m); }
        body n2 { mass = 3kg;  inertia = (0.3kgm2, 0.3kgm2, 0.3kgm2);  start position = (-0.3m, 0.4m, 0m); }
        joint gears = gear_joint(ground, n1, n2, ground.r1, ground.r2, 2.5);
        force motor = motor(ground.r1, n1, (1.5 + 0.5 * (t / 1s)) * 1Nm);
        force load = motor(ground.r2, n2, -0.8Nm);
        freedom turn = dot(n1.angular_velocity, z_axis(ground.r1)) from 3rad_s;
    }
}

mechanism! {
    /// `dynamics/gear_joint_floating.json`.
    pub(crate) mechanism FloatingGears in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body n0 {
            axis r1 = (0, 0, 1) from (1, 0, 0);  axis r2 = (0, 0.6, 0.8) from (1, 0, 0);
            mass = 2kg;  center = (0.03m, -0.02m, 0.01m);
            inertia = (0.02kgm2, 0.03kgm2, 0.025kgm2, 0.002kgm2, -0.001kgm2, 0.003kgm2);
            start orientation = turn((0, 0, 1), 0.2rad) * turn((1, 0, 0), 1.1rad) * turn((0, 0, 1), -0.3rad);
        }
        body n1 {
            mass = 0.8kg;  inertia = (0.003kgm2, 0.003kgm2, 0.005kgm2);
            start position = (0.10514521404298244987m, -0.037830002048393157762m, -0.0036571722510673591327m);
            start orientation = turn((0, 0, 1), 0.2rad) * turn((1, 0, 0), 1.1rad) * turn((0, 0, 1), -0.3rad);
        }
        body n2 {
            mass = 1.1kg;  inertia = (0.006kgm2, 0.007kgm2, 0.004kgm2, 0.0005kgm2, 0kgm2, 0.0002kgm2);
            start position = (-0.049068190584555975004m, 0.035866629579229489357m, 0.13230985433966750401m);
            start orientation = turn((0, 0, 1), 0.2rad) * turn((1, 0, 0), 1.1rad) * turn((0, 0, 1), -0.3rad);
        }
        joint gears = gear_joint(n0, n1, n2, n0.r1, n0.r2, -1.6);
        force motor = motor(n0.r1, n1, (0.05 + 0.1 * sin((5 * (t / 1s) + 0.3) * 1rad)) * 1Nm);
        force load = motor(n0.r2, n2, -0.04Nm);
        freedom fall = rate(n0.position) from (0.5m_s, -0.3m_s, 2m_s);
        freedom spin = n0.angular_velocity from (-0.17955994734885043026rad_s, -1.1275987893448303131rad_s, 1.2443153457106927058rad_s);
        freedom turn = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.r1)) from 4rad_s;
    }
}

mechanism! {
    /// `dynamics/differential_loads.json`.
    pub(crate) mechanism Differential in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point O = (0m, 0m, 0m);  axis z = (0, 0, 1) from (1, 0, 0); }
        body n0 {
            point O = (0m, 0m, 0m);  axis z = (0, 0, 1) from (1, 0, 0);
            point P1 = (0.12m, 0m, 0m);  point P2 = (0m, 0.15m, 0m);  point P3 = (0m, -0.15m, 0m);
            axis r1 = (1, 0, 0) from (0, 1, 0);  axis r2 = (0, 1, 0) from (1, 0, 0);
            mass = 3kg;  center = (0.02m, 0.01m, 0m);  inertia = (0.04kgm2, 0.05kgm2, 0.06kgm2, 0.003kgm2, 0.002kgm2, 0kgm2);
        }
        body n1 { point O = (0m, 0m, 0m);  mass = 0.6kg;  inertia = (0.002kgm2, 0.0012kgm2, 0.0012kgm2);  start position = (0.12m, 0m, 0m); }
        body n2 { point O = (0m, 0m, 0m);  mass = 0.9kg;  inertia = (0.002kgm2, 0.003kgm2, 0.002kgm2);  start position = (0m, 0.15m, 0m); }
        body n3 { point O = (0m, 0m, 0m);  mass = 0.9kg;  inertia = (0.0025kgm2, 0.004kgm2, 0.0025kgm2);  start position = (0m, -0.15m, 0m); }
        joint carrier = revolute(ground.O, ground.z, n0.O, n0.z);
        joint b1 = spherical(n0.P1, n1.O);
        joint b2 = spherical(n0.P2, n2.O);
        joint b3 = spherical(n0.P3, n3.O);
        joint gears = differential_joint_on_bearings(n0, n1, n2, n3, n0.r1, n0.r2, n0.r2, -2);
        force input = motor(n0.r1, n1, (0.8 + 0.3 * sin(4 * (t / 1s) * 1rad)) * 1Nm);
        force load2 = motor(n0.r2, n2, -0.3Nm);
        force load3 = motor(n0.r2, n3, -0.9Nm);
        force house = motor(ground.z, n0, (0.1 + 0.2 * sin(3 * (t / 1s) * 1rad)) * 1Nm);
        freedom turn = dot(n0.angular_velocity, z_axis(ground.z)) from 2rad_s;
        freedom left = dot(n2.angular_velocity - n0.angular_velocity, z_axis(n0.r2)) from 1rad_s;
        freedom right = dot(n3.angular_velocity - n0.angular_velocity, z_axis(n0.r2)) from -0.5rad_s;
    }
}

mechanism! {
    /// `dynamics/rack_pinion_swing.json`.
    pub(crate) mechanism SwingingRack in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point O = (0m, 0m, 0m);  axis x = (1, 0, 0) from (0, 1, 0); }
        body n0 {
            point O = (0m, 0m, 0m);  axis x = (1, 0, 0) from (0, 1, 0);  axis y = (0, 1, 0) from (1, 0, 0);  point S = (-0.4m, -0.3m, -0.35m);
            mass = 2.5kg;  center = (0m, 0.01m, -0.2m);  inertia = (0.03kgm2, 0.02kgm2, 0.025kgm2, 0.001kgm2, 0kgm2, 0.002kgm2);
            start orientation = turn((1, 0, 0), 0.4rad);
        }
        body n1 {
            axis y = (0, 1, 0);  mass = 0.4kg;  inertia = (0.0006kgm2, 0.0006kgm2, 0.001kgm2);
            start position = (0m, 0.13524672257265285118m, -0.26852993135469250162m);  start orientation = turn((1, 0, 0), 0.4rad);
        }
        body n2 {
            point S = (0.02m, 0m, 0.01m);  mass = 1.2kg;  inertia = (0.004kgm2, 0.005kgm2, 0.006kgm2, 0.0003kgm2, 0kgm2, 0kgm2);
            start position = (0.05m, 0.19156007944820077300m, -0.29900624736249072564m);  start orientation = turn((1, 0, 0), 0.4rad);
        }
        joint carrier = revolute(ground.O, ground.x, n0.O, n0.x);
        joint rack = guided_rack_and_pinion_joint(n0, n1, n2, n0.y, n0.x, 0.05m / 1rad);
        joint bearing = parallel_axes(n0.y, n1.y);
        force motor = motor(n0.y, n1, (0.02 + 0.3 * sin((7 * (t / 1s) + 0.2) * 1rad)) * 1Nm);
        force spring = spring_damper(n0.S, n2.S, stiffness: 60N_m, rest: 0.5m, damping: 0.7Ns_m);
        freedom swing = dot(n0.angular_velocity, z_axis(ground.x));
        freedom turn = dot(n1.angular_velocity - n0.angular_velocity, z_axis(n0.y)) from 3rad_s;
    }
}

mechanism! {
    /// `dynamics/mpc_pair.json`.
    pub(crate) mechanism Pair in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body a {
            axis s1 = (0, 0.3, 1) from (1, 0, 0);  axis s2 = (0, 0, 1) from (1, -0.5, 0);
            mass = 1.4kg;  center = (0.02m, 0m, 0.05m);  inertia = (0.03kgm2, 0.04kgm2, 0.05kgm2, 0.004kgm2, 0kgm2, -0.003kgm2);
            start position = (0.1m, -0.2m, 1m);
            start orientation = turn((0.3586780454497614, 0.1516466453264173, -0.09195266597143172), 0.8233117152744223rad);
        }
        body b {
            axis s1 = (0.1, 0, 1) from (1, 1, 0);  axis s2 = (0, 1, 1) from (1, 0, 0);
            mass = 1.4kg;  inertia = (0.02kgm2, 0.03kgm2, 0.015kgm2, 0kgm2, 0.002kgm2, 0.001kgm2);
            start position = (0.5m, 0.3m, 0.8m);
            start orientation = turn((0.23525884866696117, -0.1788448116917477, -0.41553844624846675), 1.0701516292119404rad);
        }
        joint one = { dot(x_axis(a.s1), rate(a.position) - rate(b.position)) == 0m_s; }
        joint two = { 2 * dot(z_axis(ground.z), a.angular_velocity) + 3 * dot(y_axis(b.s1), b.angular_velocity) == 0rad_s; }
        joint three = {
            0.4m * dot(x_axis(a.s2), a.angular_velocity) / 1rad - 5 * dot(z_axis(ground.z), rate(b.position))
                + 0.7 * dot(y_axis(b.s2), rate(a.position)) == 0m_s;
        }
        freedom va = rate(a.position) from (0.32153272861829805172m_s, -0.23379475795780639896m_s, 0.98673728479722557406m_s);
        freedom wa = a.angular_velocity from (1.4785522002573322954rad_s, -0.68864656636073937980rad_s, -0.052445043923954211338rad_s);
        freedom vb = dot((0, 1, 0), rate(b.position)) from 0.40406051922280817394m_s;
        freedom wbx = dot((1, 0, 0), b.angular_velocity) from -1.0894910360858210227rad_s;
        freedom wby = dot((0, 1, 0), b.angular_velocity) from -0.55222971793950210332rad_s;
    }
}

mechanism! {
    /// `dynamics/ball_on_turntable.json`.
    pub(crate) mechanism Turntable in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point O = (0m, 0m, 0m);  axis z = (0, 0, 1) from (1, 0, 0); }
        body disk { point O = (0m, 0m, 0m);  axis z = (0, 0, 1) from (1, 0, 0);  mass = 5kg;  inertia = (0.3kgm2, 0.3kgm2, 0.6kgm2); }
        body ball {
            point C = (0m, 0m, 0m);  mass = 0.5kg;  inertia = (0.00072kgm2, 0.00072kgm2, 0.00072kgm2);
            start position = (0.3m, 0.1m, 0.06m);
        }
        joint axle = revolute(ground.O, ground.z, disk.O, disk.z);
        joint contact = rolling_ball(disk.z, ball.C, 0.06m);
        drive motor = drive_rotation(joint_angle(ground.z, disk.z), 4rad_s * t);
        freedom spin = ball.angular_velocity from (26.666666666666667283rad_s, 10.000000000000000925rad_s, 2.5rad_s);
    }
}

mechanism! {
    /// `dynamics/skate_on_incline.json`.
    pub(crate) mechanism Skate in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis n = (0, -0.389418342, 0.921060994) from (1, 0, 0); }
        body skate {
            point O = (0m, 0m, 0m);  axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0);
            mass = 1.7kg;  center = (0m, 0m, 0.05m);  inertia = (0.02kgm2, 0.05kgm2, 0.06kgm2);
            start orientation = turn((0.19643848822586393, -0.029688773753057774, 0.14645931909658988), 0.49879354207368615rad);
        }
        joint plane = planar((0m, 0m, 0m), ground.n, skate.O, skate.z);
        joint blade = knife_edge(ground, skate.O, skate.y);
        freedom turning = dot(skate.angular_velocity, z_axis(skate.z)) from 1.5rad_s;
        freedom forward = dot(rate(skate.O), x_axis(skate.z)) from 0.4m_s;
    }
}

/// Positions, speeds and accelerations of bodies in a state, and multipliers.
macro_rules! all {
    ($function:ident, $kind:ident, $state:ident: $($body:ident),*) => {
        fn $function(mechanism: &$kind, state: &$state) -> Vec<(&'static str, Vec<f64>)> {
            let bodies: Vec<SpatialBody<f64>> = vec![$(state.$body()),*];
            let speeds = bodies.iter().flat_map(|body| body.velocity.iter().chain(body.angular_velocity.iter()).copied());
            let rates = bodies.iter().flat_map(|body| body.acceleration.iter().chain(body.angular_acceleration.iter()).copied());
            let loads = mechanism.loads(state);
            vec![
                ("r", bodies.iter().flat_map(|body| body.position.iter().copied()).collect()),
                ("w", speeds.collect()),
                ("wdot", rates.collect()),
                ("lambda", loads.multipliers.as_slice().to_vec()),
            ]
        }
    };
}

all!(of_universal_pendulum, UniversalPendulum, UniversalPendulumState: link1, link2);
all!(of_nutating_top, NutatingTop, NutatingTopState: top);
all!(of_steady_top, SteadyTop, SteadyTopState: top);
all!(of_free_body, FreeBody, FreeBodyState: body);
all!(of_gears_on_ground, GearsOnGround, GearsOnGroundState: n1, n2);
all!(of_floating_gears, FloatingGears, FloatingGearsState: n0, n1, n2);
all!(of_differential, Differential, DifferentialState: n0, n1, n2, n3);
all!(of_swinging_rack, SwingingRack, SwingingRackState: n0, n1, n2);
all!(of_pair, Pair, PairState: a, b);
all!(of_turntable, Turntable, TurntableState: disk, ball);
all!(of_skate, Skate, SkateState: skate);
motion!(a_pendulum_on_universal_joints_swings, "universal_double_pendulum", UniversalPendulum, of_universal_pendulum);
motion!(a_top_nutates, "heavy_top_nutation", NutatingTop, of_nutating_top);
motion!(a_top_precesses, "heavy_top_steady", SteadyTop, of_steady_top);
motion!(a_free_body_tumbles, "free_body", FreeBody, of_free_body);
motion!(a_gear_joint_accelerates_inertias, "gear_joint_inertia", GearsOnGround, of_gears_on_ground);
motion!(a_gear_joint_floats, "gear_joint_floating", FloatingGears, of_floating_gears);
motion!(a_differential_carries_loads, "differential_loads", Differential, of_differential);
motion!(a_rack_swings, "rack_pinion_swing", SwingingRack, of_swinging_rack);
motion!(two_bodies_are_joined_by_multi_point_constraints, "mpc_pair", Pair, of_pair);
motion!(a_ball_rolls_on_a_turntable, "ball_on_turntable", Turntable, of_turntable);
motion!(a_skate_glides_on_an_incline, "skate_on_incline", Skate, of_skate);
