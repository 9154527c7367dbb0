//! Redundant joints along a motion: which of their rows are solved changes with the place.

use reuleaux::{Integrator, mechanism};

mechanism! {
    /// Bennett's linkage, of which one link has a mass: without forces and with that mass on an axis fixed in ground, its crank turns
    /// uniformly.
    pub(crate) mechanism Turning in space {
        let al = 35deg;
        let be = 80deg;
        let la = 100mm * sin(al);
        let lb = 100mm * sin(be);
        ground { axis z = (0, 0, 1) from (1, 0, 0);  point E = (la, 0mm, 0mm);  axis e = (0, -sin(al), cos(al)) from (1, 0, 0); }
        body b {
            axis z = (0, 0, 1) from (1, 0, 0);  point E = (lb, 0mm, 0mm);  axis e = (0, -sin(be), cos(be)) from (1, 0, 0);
            start orientation = turn((1, 0, 0), al) * turn((0, 0, 1), 100deg);
            mass = 1kg;  center = (lb / 2, 0mm, 0mm);  inertia = ball(30mm);
        }
        body c {
            axis z = (0, 0, 1) from (1, 0, 0);  point E = (la, 0mm, 0mm);  axis e = (0, -sin(al), cos(al)) from (1, 0, 0);
            start orientation = turn((1, 0, 0), al) * turn((0, 0, 1), 100deg) * turn((1, 0, 0), be) * turn((0, 0, 1), -123deg);
        }
        body d {
            axis z = (0, 0, 1) from (1, 0, 0);  point E = (lb, 0mm, 0mm);  axis e = (0, -sin(be), cos(be)) from (1, 0, 0);
            start orientation = turn((1, 0, 0), al) * turn((0, 0, 1), 100deg) * turn((1, 0, 0), be) * turn((0, 0, 1), -123deg)
                * turn((1, 0, 0), al) * turn((0, 0, 1), -100deg);
        }
        joint j1 = revolute(ground.E, ground.e, b.position, b.z);
        joint j2 = revolute(b.E, b.e, c.position, c.z);
        joint j3 = revolute(c.E, c.e, d.position, d.z);
        redundant joint j4 = revolute(d.E, d.e, ground.position, ground.z);
        freedom turn = j1.angle from 100deg at 2rad_s;
        output one = j1.angle;
        output two = j2.angle;
    }
}

/// tan(θ₂/2) = −k / tan(θ₁/2): the rate of θ₂ at the rate 2 of θ₁.
fn second_rate(first: f64) -> f64 {
    let k = 57.5_f64.to_radians().sin() / 22.5_f64.to_radians().sin();
    let (sine, cosine) = (first / 2.0).sin_cos();
    2.0 * k / (sine * sine + k * k * cosine * cosine)
}

/// In t, θ₁ reaches 180° and 360°, where the equations of `j4` that are solved elsewhere no longer determine the motion.
fn flat(instant: u8) -> f64 {
    (180.0 * f64::from(instant) - 100.0_f64).to_radians() / 2.0
}

#[test]
fn bennetts_linkage_turns_uniformly_through_its_flat_places() {
    let mechanism = Turning::default();
    let near = (1..=2).flat_map(|instant| [-1e-3, -1e-7, -1e-10, 0.0, 1e-9, 1e-5].map(|off| flat(instant) + off));
    let mut times: Vec<f64> = near.chain((1..100).map(|k| 0.04 * f64::from(k))).collect();
    times.sort_by(f64::total_cmp);
    for state in mechanism.sweep(times, Integrator::new(1e-11)) {
        let state = state.expect("a state");
        let (one, two) = (mechanism.one(&state), mechanism.two(&state));
        let angle = 100.0_f64.to_radians() + 2.0 * state.t;
        assert!((one.value - angle).abs() < 1e-10 && (one.rate - 2.0).abs() < 1e-10, "{} {one:?}", state.t);
        assert!((two.rate - second_rate(angle)).abs() < 1e-9, "{} {two:?} {}", state.t, second_rate(angle));
    }
}

#[test]
fn steps_across_a_flat_place_lose_nothing() {
    let mechanism = Turning::default();
    let mut state = mechanism.initial_state().expect("a state");
    for _ in 0..200 {
        mechanism.step(&mut state, 0.01).expect("a step");
        assert!((mechanism.one(&state).rate - 2.0).abs() < 1e-12, "{}", state.t);
    }
}

/// Bennett's linkage with all its parameters, released or driven.
macro_rules! bennett {
    ($name:ident, $($motion:tt)*) => {
        mechanism! {
            mechanism $name in space {
                param al: Angle = 35deg;
                param be: Angle = 80deg;
                param la: Length = 57.357643635104605mm;
                param lb: Length = 98.4807753012208mm;
                ground { axis z = (0, 0, 1) from (1, 0, 0);  point E = (la, 0mm, 0mm);  axis e = (0, -sin(al), cos(al)) from (1, 0, 0); }
                body b {
                    axis z = (0, 0, 1) from (1, 0, 0);  point E = (lb, 0mm, 0mm);  axis e = (0, -sin(be), cos(be)) from (1, 0, 0);
                    mass = 1kg;  inertia = ball(30mm);
                }
                body c { axis z = (0, 0, 1) from (1, 0, 0);  point E = (la, 0mm, 0mm);  axis e = (0, -sin(al), cos(al)) from (1, 0, 0); }
                body d { axis z = (0, 0, 1) from (1, 0, 0);  point E = (lb, 0mm, 0mm);  axis e = (0, -sin(be), cos(be)) from (1, 0, 0); }
                joint j1 = revolute(ground.E, ground.e, b.position, b.z);
                joint j2 = revolute(b.E, b.e, c.position, c.z);
                joint j3 = revolute(c.E, c.e, d.position, d.z);
                redundant joint j4 = revolute(d.E, d.e, ground.position, ground.z);
                start j2.angle = -123deg;
                start j3.angle = -100deg;
                $($motion)*
                output two = j2.angle;
            }
        }
    };
}

bennett!(Released, freedom turn = j1.angle from 100deg;);
bennett!(Driven, drive turn = drive_rotation(j1, 100deg + 1rad_s * t););

/// On the way from the declared parameters to others the linkage does not close: its lengths are proportional to the sines of its twists at both
/// ends only. tan(θ₁/2) tan(θ₂/2) = −sin((α + β)/2) / sin((α − β)/2) up to the sign of the twists.
#[test]
fn redundant_rows_need_not_fit_on_the_way_to_other_parameters() {
    for (first, second) in [(36.0, 79.0), (50.0, 65.0), (60.0, 55.0), (60.0, 30.0), (35.0, 20.0), (20.0, 80.0), (80.0, 120.0), (80.0, 35.0)]
    {
        let [al, be] = [first, second].map(f64::to_radians);
        let [la, lb] = [al, be].map(|twist| 0.1 * twist.sin());
        let mechanism = Released { al, be, la, lb };
        let state = mechanism.initial_state().unwrap_or_else(|stopped| panic!("{first}°, {second}°: {stopped}"));
        let found = mechanism.two(&state).value;
        let ratio = (0.5 * (al + be)).sin() / (0.5 * (be - al)).sin();
        let product = (50.0_f64).to_radians().tan() * (0.5 * found).tan();
        assert!((product.abs() - ratio.abs()).abs() < 1e-9 * ratio.abs(), "{first}°, {second}°: {product}, not {ratio}");
        let driven = Driven { al, be, la, lb };
        let known = driven.two(&driven.solve(0.0).expect("it is assembled")).value;
        assert!((found - known).abs() < 1e-9, "{first}°, {second}°: {found}, driven {known}");
    }
}
