//! Mechanisms in the plane.

use reuleaux::mechanism;

mechanism! {
    /// `dynamics/gear_pair_inertia.json`.
    pub(crate) mechanism GearPair {
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point B = (0.14m, 0m); }
        body g1 { point A = (0m, 0m);  mass = 0.6kg;  inertia = 0.0005kgm2;  start angle = 0.3rad; }
        body g2 { point B = (0m, 0m);  mass = 2.2kg;  inertia = 0.011kgm2;  start angle = -0.1rad; }
        joint a = revolute(ground.A, g1.A);
        joint b = revolute(ground.B, g2.B);
        joint mesh = { 0.04m * (g1.angle - 0.3rad) + 0.1m * (g2.angle + 0.1rad) == 0m; }
        force motor = { on g1: (0.9 - 0.2 * (t / 1s)) * 1Nm; }
        force load = { on g2: 0.35Nm; }
        freedom turn = g1.angle from 0.3rad at 2rad_s;
    }
}

mechanism! {
    /// `dynamics/double_pendulum.json`.
    pub(crate) mechanism DoublePendulum {
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body link1 { point H = (0m, 0m);  point E = (0.5m, 0m);  mass = 1kg;  inertia = 0.025kgm2;  center = (0.25m, 0m); }
        body link2 { point H = (0m, 0m);  point E = (0.35m, 0m);  mass = 0.8kg;  inertia = 0.009kgm2;  center = (0.2m, 0.04m); }
        joint upper = revolute(ground.O, link1.H);
        joint lower = revolute(link1.E, link2.H);
        freedom one = link1.angle;
        freedom two = link2.angle from 0.5rad;
    }
}

mechanism! {
    /// `dynamics/triple_pendulum.json`.
    pub(crate) mechanism TriplePendulum {
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body link1 { point H = (0m, 0m);  point E = (0.5m, 0m);  mass = 0.5kg;  inertia = 0.0104kgm2;  center = (0.25m, 0m); }
        body link2 { point H = (0m, 0m);  point E = (0.4m, 0m);  mass = 0.4kg;  inertia = 0.0053kgm2;  center = (0.2m, 0m); }
        body link3 { point H = (0m, 0m);  point E = (0.3m, 0m);  mass = 0.3kg;  inertia = 0.00225kgm2;  center = (0.15m, 0m); }
        joint one = revolute(ground.O, link1.H);
        joint two = revolute(link1.E, link2.H);
        joint three = revolute(link2.E, link3.H);
        freedom a = link1.angle;
        freedom b = link2.angle;
        freedom c = link3.angle;
    }
}

mechanism! {
    /// `dynamics/four_bar_released.json`.
    pub(crate) mechanism FourBar {
        gravity = (0, -9.81m_s2);
        ground { point A = (0m, 0m);  point D = (0.35m, 0m); }
        body crank   { point A = (0m, 0m);  point B = (0.1m, 0m);  mass = 0.8kg;  inertia = 0.002kgm2;  center = (0.05m, 0m);  start angle = 1.2rad; }
        body coupler { point B = (0m, 0m);  point C = (0.3m, 0m);  mass = 1.5kg;  inertia = 0.015kgm2;  center = (0.16m, 0.05m);  start angle = 0.5rad; }
        body rocker  { point D = (-0.125m, 0m);  point C = (0.125m, 0m);  mass = 1.2kg;  inertia = 0.009kgm2;  start angle = 1.8rad; }
        joint a = revolute(ground.A, crank.A);
        joint b = revolute(crank.B, coupler.B);
        joint c = revolute(coupler.C, rocker.C);
        joint d = revolute(rocker.D, ground.D);
        freedom swing = crank.angle from 1.2rad;
    }
}

mechanism! {
    /// `dynamics/cart_pendulum_spring_damper.json`.
    pub(crate) mechanism Cart {
        gravity = (0, -9.81m_s2);
        ground { point S = (-1m, 0.1m);  axis guide = (1, 0); }
        body cart { point H = (0m, 0m);  point S = (0m, 0.1m);  mass = 2kg;  inertia = 0.05kgm2;  start x = 0.4m; }
        body bar  { point H = (0m, 0m);  mass = 0.6kg;  inertia = 0.012kgm2;  center = (0.15m, 0.01m);  start angle = -0.87079632679489660241rad; }
        joint guide = translational(ground.guide, (0m, 0m), cart.H);
        joint hinge = revolute(cart.H, bar.H);
        force spring = spring_damper(ground.S, cart.S, stiffness: 80N_m, rest: 1.1m, damping: 1.5Ns_m);
        force push = actuator(ground.S, cart.S, -6N * sin((5 * (t / 1s) + 0.3) * 1rad));
        force torsion = torsion_spring_damper(cart, bar, stiffness: 0.8Nm / 1rad, rest: -1.2rad, damping: 0.02Nm / 1rad_s);
        freedom x = cart.x;
        freedom swing = bar.angle;
    }
}

/// Positions, speeds, accelerations and multipliers of a state.
macro_rules! all {
    ($function:ident, $kind:ident, $state:ident) => {
        fn $function(mechanism: &$kind, state: &$state) -> Vec<(&'static str, Vec<f64>)> {
            let of = |vector: &[f64]| vector.to_vec();
            let loads = mechanism.loads(state);
            vec![
                ("q", of(state.q.as_slice())),
                ("qd", of(state.qd.as_slice())),
                ("qdd", of(state.qdd.as_slice())),
                ("lambda", of(loads.multipliers.as_slice())),
            ]
        }
    };
}

all!(of_gear_pair, GearPair, GearPairState);
all!(of_double_pendulum, DoublePendulum, DoublePendulumState);
all!(of_triple_pendulum, TriplePendulum, TriplePendulumState);
all!(of_four_bar, FourBar, FourBarState);
all!(of_cart, Cart, CartState);
motion!(gears_are_accelerated_by_a_torque, "gear_pair_inertia", GearPair, of_gear_pair);
motion!(a_double_pendulum_swings, "double_pendulum", DoublePendulum, of_double_pendulum);
motion!(a_triple_pendulum_swings, "triple_pendulum", TriplePendulum, of_triple_pendulum);
motion!(a_four_bar_is_released, "four_bar_released", FourBar, of_four_bar);
motion!(a_cart_carries_a_pendulum, "cart_pendulum_spring_damper", Cart, of_cart);
