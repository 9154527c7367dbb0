//! Drives determine all velocities, and positions follow from them by integration.

use core::f64::consts::{PI, TAU};
use reuleaux::{Integrator, Stopped, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// A skate on ice, pushed along its edge and turned.
    #[integrated]
    pub mechanism Skate {
        param push: Velocity = 2m_s;
        param turn: AngularVelocity = 0.5rad_s;
        body blade { axis edge = (1, 0);  mass = 3kg;  inertia = 0.2kgm2; }
        joint ice = { cross(blade.edge, rate(blade.position)) == 0m_s; }
        drive along = { dot(blade.edge, rate(blade.position)) == push; }
        drive about = drive_angle(blade, turn * t);
    }
}

#[test]
fn a_skate_goes_round_in_a_circle() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let skate = Skate { push: 3.0, turn: 0.75 };
        let mut state = skate.initial_state().unwrap();
        let mut integrator = Integrator::new(tolerance);
        for step in 1..=40 {
            let t = f64::from(step) * 0.3;
            skate.advance(&mut state, t, &mut integrator).unwrap();
            let (sine, cosine) = (0.75 * t).sin_cos();
            let (blade, radius) = (state.blade(), 3.0 / 0.75);
            let bound = 10.0 * tolerance + 1e-14;
            assert!((blade.position.x - radius * sine).abs() < bound, "{tolerance:e} at {t}: {}", blade.position);
            assert!((blade.position.y - radius * (1.0 - cosine)).abs() < bound, "{tolerance:e} at {t}: {}", blade.position);
            assert_eq!(blade.angle, 0.75 * t);
            assert!((blade.velocity.x - 3.0 * cosine).abs() < 1e-14 && (blade.velocity.y - 3.0 * sine).abs() < 1e-14);
            assert!((blade.acceleration.x + 2.25 * sine).abs() < 1e-14 && (blade.acceleration.y - 2.25 * cosine).abs() < 1e-14);
            // The ice holds the skate on its circle: m v ω towards the centre; the drives do nothing.
            let loads = skate.loads(&state);
            let towards = 3.0 * 3.0 * 0.75;
            assert!((loads.multipliers[0].abs() - towards).abs() < 1e-13, "{}", loads.multipliers);
            assert!(loads.along().effort.abs() < 1e-13 && loads.about().effort.abs() < 1e-13);
        }
    }
}

mechanism! {
    /// Without mass there are no loads, and nothing else is missing.
    #[integrated]
    pub mechanism Spiral {
        body blade { axis edge = (1, 0);  start x = 1m;  start angle = 90deg; }
        joint ice = { cross(blade.edge, rate(blade.position)) == 0m_s; }
        drive along = { dot(blade.edge, rate(blade.position)) == 1m_s * t / 1s; }
        drive about = { blade.angular_velocity == 1rad_s; }
    }
}

#[test]
fn a_start_is_where_it_is_declared() {
    let mut state = Spiral::default().initial_state().unwrap();
    let blade = state.blade();
    assert_eq!((blade.position.x, blade.position.y, blade.angle), (1.0, 0.0, PI / 2.0));
    let t = 2.0_f64;
    Spiral::default().advance(&mut state, t, &mut Integrator::new(1e-11)).unwrap();
    // ∫ t (−sin t, cos t) dt
    let (x, y) = (1.0 + t * t.cos() - t.sin(), t * t.sin() + t.cos() - 1.0);
    let place = state.blade().position;
    assert!((place.x - x).abs() < 1e-10 && (place.y - y).abs() < 1e-10, "{place} ({x}, {y})");
}

mechanism! {
    /// A disk is led round a circle: upright, rolling, its heading and its spin driven.
    #[integrated]
    pub mechanism Led in space {
        ground { axis up = (0, 0, 1) from (1, 0, 0); }
        body disk { axis axle = (0, 1, 0) from (0, 0, 1);  start position = (0mm, 0mm, 300mm); }
        joint contact = rolling_disk(ground.up, disk.position, disk.axle, 300mm);
        joint upright = perpendicular_axes(ground.up, disk.axle);
        drive spin = { dot(disk.angular_velocity, z_axis(disk.axle)) == 4rad_s; }
        drive heading = { dot(disk.angular_velocity, z_axis(ground.up)) == 1rad_s; }
    }
}

#[test]
fn a_disk_rolls_on_a_circle_of_its_speed_over_its_turning() {
    let mut state = Led::default().initial_state().unwrap();
    let mut integrator = Integrator::new(1e-11);
    for eighth in 1..=8 {
        let t = f64::from(eighth) * TAU / 8.0;
        Led::default().advance(&mut state, t, &mut integrator).unwrap();
        // v = ω × r at the centre: 0.3 m × 4 rad/s along x at the start.
        let (radius, place) = (1.2, state.disk().position);
        assert!((place.x - radius * t.sin()).abs() < 1e-9, "{place}");
        assert!((place.y - radius * (1.0 - t.cos())).abs() < 1e-9, "{place}");
        assert!((place.z - 0.3).abs() < 1e-13, "{place}");
    }
}

/// Two gears on a carrier that turns, with bevel axes, as equations of velocities and as equations of angles.
macro_rules! geared {
    ($(#[$attribute:meta])* $name:ident, $($mesh:tt)*) => {
        mechanism! {
            /// Bevel gears on a carrier.
            $(#[$attribute])*
            pub(crate) mechanism $name in space {
                ground { axis z = (0, 0, 1) from (1, 0, 0); }
                body carrier {
                    axis z = (0, 0, 1) from (1, 0, 0);
                    axis one = (1, 0, 0) from (0, 0, 1);  axis two = (0, 1, 0) from (0, 0, 1);
                }
                body first { axis x = (1, 0, 0) from (0, 0, 1); }
                body second { axis x = (0, 1, 0) from (0, 0, 1); }
                joint turntable = revolute(ground.position, ground.z, carrier.position, carrier.z);
                $($mesh)*
                drive swivel = drive_rotation(turntable, 0.4rad * sin(2rad_s * t));
                output on_first = joint_angle(carrier.one, first.x);
                output on_second = joint_angle(carrier.two, second.x);
            }
        }
    };
}
geared!(
    #[integrated]
    BySpeeds,
    joint mesh = gear_joint(carrier, first, second, carrier.one, carrier.two, 2);
    drive shaft = { dot(first.angular_velocity - carrier.angular_velocity, z_axis(carrier.one)) == 1rad_s * cos(1rad_s * t); }
);
geared!(
    ByAngles,
    joint first_bearing = revolute(carrier.position, carrier.one, first.position, first.x);
    joint second_bearing = revolute(carrier.position, carrier.two, second.position, second.x);
    joint mesh = gear_pair(first_bearing, second_bearing, 2, 1);
    drive shaft = drive_rotation(first_bearing, 1rad * sin(1rad_s * t));
);

#[test]
fn gears_on_a_carrier_are_where_equations_of_angles_put_them() {
    let (speeds, angles) = (BySpeeds::default(), ByAngles::default());
    let mut state = speeds.initial_state().unwrap();
    let mut integrator = Integrator::new(1e-11);
    for step in 1..=20 {
        let t = f64::from(step) * 0.25;
        speeds.advance(&mut state, t, &mut integrator).unwrap();
        let wanted = angles.solve(t).unwrap();
        for (found, wanted) in [(speeds.on_first(&state), angles.on_first(&wanted)), (speeds.on_second(&state), angles.on_second(&wanted))]
        {
            assert!((found.value - wanted.value).abs() < 1e-9, "{t}: {found:?} {wanted:?}");
            assert!((found.rate - wanted.rate).abs() < 1e-9, "{t}: {found:?} {wanted:?}");
            assert!((found.acceleration - wanted.acceleration).abs() < 1e-8, "{t}: {found:?} {wanted:?}");
        }
    }
}

/// Two gears by their rates.
macro_rules! by_rates {
    ($(#[$task:meta])* $name:ident, $(#[$kept:meta])*) => {
        mechanism! {
            /// A driver turns unevenly.
            $(#[$task])*
            pub(crate) mechanism $name {
                body driver {}
                body driven { start angle = 30deg; }
                joint one = revolute(ground.position, driver.position);
                joint two = revolute((100mm, 0mm), driven.position);
                drive motor = drive_angle(driver, 60rpm * t + 0.5rad * sin(7rad_s * t));
                $(#[$kept])*
                joint mesh = { driven.angular_velocity == -2 * driver.angular_velocity; }
            }
        }
    };
}
by_rates!(Solved,);
by_rates!(
    #[integrated]
    Kept,
    #[velocity]
);

#[test]
fn a_kept_equation_of_velocities_is_integrated_within_the_tolerance_over_a_hundred_turns() {
    let (solved, kept) = (Solved::default(), Kept::default());
    let mut state = kept.initial_state().unwrap();
    let mut integrator = Integrator::new(1e-10);
    let mut drift = 0.0_f64;
    for step in 1..=50 {
        let t = 2.0 * f64::from(step);
        kept.advance(&mut state, t, &mut integrator).unwrap();
        let angle = PI / 6.0 - 2.0 * (TAU * t + 0.5 * (7.0 * t).sin());
        let exact = solved.solve_near(t, &[0.0; 6].into()).map_or(f64::NAN, |state| state.driven().angle);
        assert!((exact - angle).abs() < 4.0 * f64::EPSILON * angle.abs(), "{exact} {angle}");
        drift = drift.max((state.driven().angle - angle).abs());
        assert!((state.driven().angular_velocity + 2.0 * state.driver().angular_velocity).abs() < 1e-12);
    }
    // Positions of the kept equation are integrated: they are not exact, unlike the others.
    assert!(drift > 1e-13 && drift < 1e-7, "{drift:e}");
}

mechanism! {
    /// A drum winds up a rope that lifts the tip of an arm at the speed of its rim.
    pub(crate) mechanism Lifted {
        param radius: Length = 300mm;
        body arm { point tip = (0.8m, 0.6m);  start angle = 20deg; }
        body drum { }
        joint pivot = revolute(ground.position, arm.position);
        joint axle = revolute((2m, 0m), drum.position);
        joint rope = { rate(arm.tip.y) == radius * drum.angular_velocity; }
        drive motor = drive_angle(drum, 0.5rad_s * t);
    }
}

/// The tip of an arm of 1 m is at the height sin(φ + β), tan β = 3/4.
#[test]
fn a_point_of_a_body_that_turns_is_moved_at_a_given_rate_without_drift() {
    let lifted = Lifted::default();
    let beta = 0.6_f64.asin();
    for t in [0.0, 0.4, 0.9] {
        let height = (20_f64.to_radians() + beta).sin() + 0.3 * 0.5 * t;
        let angle = height.asin() - beta;
        let rate = 0.15 / (angle + beta).cos();
        let arm = lifted.solve(t).unwrap().arm();
        assert!((arm.angle - angle).abs() < 1e-14 && (arm.angular_velocity - rate).abs() < 1e-14, "{arm:?} at {t} s");
    }
}

mechanism! {
    /// A crane whose jib is lowered and raised so that its tip moves at a given speed along x while the column slews.
    mechanism Slewing in space {
        param speed: Velocity = 50mm_s;
        param reach: Length = 2m;
        body column { axis z = (0, 0, 1);  axis pin = (0, -1, 0) from (1, 0, 0); }
        body jib { axis pin = (0, -1, 0) from (1, 0, 0);  point tip = (reach, 0m, 0m); }
        joint slew = revolute(ground.position, (0, 0, 1), column.position, column.z);
        joint foot = revolute(column.position, column.pin, jib.position, jib.pin);
        joint rope = { rate(jib.tip.x) == -speed; }
        drive motor = drive_rotation(slew.angle, 10deg + 0.2rad_s * t);
        start foot.angle = 40deg;
        range t in 0s..2s;
        output luff = foot.angle;
    }
}

/// x = r cos α cos β, from α = 10° and β = 40°.
#[test]
fn a_point_on_two_hinges_in_space_is_moved_at_a_given_rate_without_drift() {
    for (speed, reach) in [(0.05, 2.0), (-0.02, 3.0)] {
        let crane = Slewing { speed, reach };
        for t in [0.0, 1.0, 2.0] {
            let slew = 10_f64.to_radians() + 0.2 * t;
            let place = reach * 10_f64.to_radians().cos() * 40_f64.to_radians().cos() - speed * t;
            let luff = (place / (reach * slew.cos())).acos();
            let found = crane.luff(&crane.solve(t).unwrap());
            assert!((found.value - luff).abs() < 1e-14, "{} instead of {luff} at {t} s", found.value);
        }
    }
}

mechanism! {
    /// An arm on two hinges along no common axes. A drum winds as its tip moves.
    mechanism Skew in space {
        body drum { axis x = (1, 0, 0); }
        body base { axis up = (0, 1, 1);  axis tilted = (1, 2, 3);  point E = (300mm, 100mm, 200mm); }
        body limb { axis tilted = (1, 2, 3);  point tip = (100mm, 400mm, 0mm); }
        joint axle = revolute((2m, 0m, 0m), (1, 0, 0), drum.position, drum.x);
        joint waist = revolute(ground.position, (0, 1, 1), base.position, base.up);
        joint elbow = revolute(base.E, base.tilted, limb.position, limb.tilted);
        joint rope = { 2 * rate(limb.tip.z) - rate(limb.tip.y) / 2 == 300mm * drum.angular_velocity.x; }
        drive wind = drive_rotation(axle.angle, 0.5rad_s * t);
        drive turn = drive_rotation(waist.angle, 20deg + 0.3rad_s * t);
        start elbow.angle = 30deg;
        range t in 0s..1s;
        output tip = limb.tip;
        output elbow_angle = elbow.angle;
    }
}

/// From the declared 30° of the elbow, 2 z − y / 2 of the tip grows by what the drum has wound.
#[test]
fn a_point_on_hinges_of_any_directions_is_moved_at_a_given_rate_without_drift() {
    let skew = Skew::default();
    let sum = |t: f64| {
        let tip = skew.tip(&skew.solve(t).unwrap()).value;
        2.0 * tip.z - tip.y / 2.0
    };
    let elbow = skew.elbow_angle(&skew.solve(0.0).unwrap()).value;
    assert!((elbow - 30_f64.to_radians()).abs() < 1e-14, "{elbow}");
    for t in [0.2, 0.5, 1.0] {
        assert!((sum(t) - sum(0.0) - 0.15 * t).abs() < 1e-14, "{} at {t} s", sum(t) - sum(0.0));
    }
}

mechanism! {
    /// Wheels that are told how fast to turn against a slide and a wheel, which begin where their drives have them.
    mechanism Begun {
        param first: Angle = 40deg;
        body driver { }
        body driven { start angle = 30deg; }
        body slide { }
        body pinion { start angle = -20deg; }
        joint one = revolute(ground.position, driver.position);
        joint two = revolute((100mm, 0mm), driven.position);
        joint three = revolute((200mm, 0mm), pinion.position);
        joint rail = translational((1, 0), (500mm, 200mm), slide.position);
        joint mesh = { driven.angular_velocity == -2 * driver.angular_velocity; }
        joint rack = { 100mm * pinion.angular_velocity == rate(slide.x); }
        drive motor = drive_angle(driver, first + 60rpm * t);
        drive push = drive_x(slide.position, 300mm + 100mm_s * t);
    }
}

#[test]
fn equations_of_rates_begin_where_drives_have_what_they_move() {
    for first in [40_f64.to_radians(), 0.9] {
        let begun = Begun { first };
        for t in [0.0, 0.3] {
            let state = begun.solve(t).unwrap();
            assert!((state.driven().angle - (PI / 6.0 - 2.0 * TAU * t)).abs() < 1e-14, "{} at {t} s", state.driven().angle);
            assert!((state.pinion().angle - (-PI / 9.0 + t)).abs() < 1e-14, "{} at {t} s", state.pinion().angle);
        }
    }
}

mechanism! {
    /// A four-bar in space of which the crank's rate is given. Its rocker is declared near its place only.
    mechanism Roughly in space {
        ground { axis z = (0, 0, 1);  point C = (400mm, 0mm, 0mm); }
        body crank { axis z = (0, 0, 1);  point A = (100mm, 0mm, 0mm);  mass = 1kg;  inertia = (0.1kgm2, 0.1kgm2, 0.1kgm2); }
        body coupler { axis z = (0, 0, 1);  point B = (350mm, 0mm, 0mm);  mass = 0.3kg;  inertia = (0.01kgm2, 0.01kgm2, 0.01kgm2); }
        body rocker {
            axis z = (0, 0, 1);  point B = (300mm, 0mm, 0mm);  start orientation = turn((0, 0, 1), 70deg);
            mass = 0.2kg;  inertia = (0.01kgm2, 0.01kgm2, 0.01kgm2);
        }
        joint o = revolute(ground.position, ground.z, crank.position, crank.z);
        joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
        joint b = cylindrical(coupler.B, coupler.z, rocker.B, rocker.z);
        joint a = spherical(crank.A, coupler.position);
        freedom turning = rate(o.angle) from 20rad_s;
        output rocker_angle = c.angle;
    }
}

/// At the rocker's 70° no crank reaches it: the crank, whose rate is given, begins at 0, as in the plane, and the rocker where the law of cosines has it.
#[test]
fn a_declared_start_that_does_not_close_only_leads_to_an_assembly() {
    let mechanism = Roughly::default();
    let state = mechanism.initial_state().expect("a state");
    let right = std::f64::consts::PI - f64::acos((0.3f64.powi(2) + 0.3f64.powi(2) - 0.35f64.powi(2)) / (2.0 * 0.3 * 0.3));
    assert!((mechanism.rocker_angle(&state).value - right).abs() < 1e-12);
    assert!((state.crank().angular_velocity.z - 20.0).abs() < 1e-12);
}

mechanism! {
    /// A wheel on an arm, driven against it, which tells another wheel how fast to turn.
    mechanism Carried {
        body arm { point E = (400mm, 0mm); }
        body wheel { }
        body driven { start angle = 30deg; }
        joint one = revolute(ground.position, arm.position);
        joint two = revolute(arm.E, wheel.position);
        joint three = revolute((1m, 0m), driven.position);
        joint mesh = { driven.angular_velocity == -2 * wheel.angular_velocity; }
        drive swing = drive_angle(arm, 10deg);
        drive motor = drive_relative_angle(arm, wheel, 40deg + 60rpm * t);
    }
}

#[test]
fn rates_begin_where_one_drive_has_a_body_against_another() {
    let carried = Carried::default();
    for t in [0.0, 0.3] {
        let state = carried.solve(t).unwrap();
        assert!((state.wheel().angle - (50_f64.to_radians() + TAU * t)).abs() < 1e-14);
        assert!((state.driven().angle - (30_f64.to_radians() - 2.0 * TAU * t)).abs() < 1e-14, "{:?}", state.driven());
    }
}

mechanism! {
    /// A skate that is pushed along x with a constant speed while it is turned across.
    #[integrated]
    mechanism Across {
        body blade { axis edge = (1, 0); }
        joint ice = { cross(blade.edge, rate(blade.position)) == 0m_s; }
        drive push = { rate(blade.position.x) == 1m_s; }
        drive turn = drive_angle(blade, 1rad_s * t);
    }
}

/// ẏ = tan t grows without bound towards t = π/2, where the push is across the edge: no step is short enough because the equations depend on
/// each other.
#[test]
fn a_motion_whose_drive_turns_against_a_joint_ends_with_that_joint() {
    let across = Across::default();
    for (tolerance, end) in [(1e-6, 2.0), (1e-10, -2.0), (1e-10, 2.0), (1e-12, -2.0)].into_iter().take(samples(2, 4)) {
        let mut state = across.initial_state().unwrap();
        let stopped = across.advance(&mut state, end, &mut Integrator::new(tolerance));
        let Err(Stopped::Singular { time, joint: "ice" }) = stopped else { panic!("{tolerance:e}: {stopped:?}") };
        assert!((time.abs() - PI / 2.0).abs() < 1e-9 && time * end > 0.0, "{tolerance:e}: {time}");
        // y = −ln cos t before.
        let mut before = across.initial_state().unwrap();
        across.advance(&mut before, end.signum() * 1.5, &mut Integrator::new(tolerance)).unwrap();
        assert!((before.blade().position.y + 1.5_f64.cos().ln()).abs() < 100.0 * tolerance, "{tolerance:e}: {}", before.blade().position);
    }
}

/// A crank on a universal joint, a rod and a ball on a rocker, of which only the place of the rocker is roughly declared.
macro_rules! rocking {
    ($(#[$attribute:meta])* $name:ident, $($drive:tt)*) => {
        mechanism! {
            /// The drive turns the crank from where its angle is 0.
            $(#[$attribute])*
            pub(crate) mechanism $name in space {
                body crank {
                    axis u = (-0.2, -0.1, 0.5);  axis cross = (-1.3, -0.4, -0.2);
                    point A = (0mm, 0mm, 0mm);  point B = (16mm, -39mm, 136mm);
                }
                body rod { axis cross = (0, 0.2, -0.8);  point C = (-373mm, -196mm, -37mm); }
                body rocker { axis u = (-0.8, 0.9, -0.2);  point C = (164mm, -9mm, 139mm);  start position = (-108mm, -90mm, -220mm); }
                joint axle = revolute((-159mm, -100mm, 68mm), (0.2, 0.1, 0.5), crank.A, crank.u);
                joint hooke = universal(crank.B, crank.cross, rod.position, rod.cross);
                joint ball = spherical(rod.C, rocker.C);
                joint pivot = revolute((-91mm, -69mm, -218mm), (-0.2, -0.8, -0.9), rocker.position, rocker.u);
                drive motor = { $($drive)* }
                output knee = crank.B;
                output gap = rod.C - rocker.C;
                output length = norm(rocker.C - crank.B);
            }
        }
    };
}
rocking!(
    #[integrated]
    Rated,
    rate(axle.angle) == 2rad_s;
);
rocking!(
    #[closure(start)]
    Turned,
    axle.angle == 2rad_s * t;
);

/// At the angle of the rod's joint that the declared place suggests, nothing closes.
#[test]
fn a_crank_with_a_driven_rate_starts_where_its_angle_is_zero() {
    let (rated, turned) = (Rated::default(), Turned::default());
    let mut state = rated.initial_state().unwrap();
    let mut integrator = Integrator::new(1e-11);
    for step in 1..=10 {
        let t = f64::from(step) * 0.01;
        rated.advance(&mut state, t, &mut integrator).unwrap();
        let (found, wanted) = (rated.knee(&state), turned.knee(&turned.solve(t).unwrap()));
        assert!((found.value - wanted.value).norm() < 1e-10, "{t}: {found:?} {wanted:?}");
        assert!((found.rate - wanted.rate).norm() < 1e-10, "{t}: {found:?} {wanted:?}");
        assert!((found.acceleration - wanted.acceleration).norm() < 1e-10, "{t}: {found:?} {wanted:?}");
        let (gap, length) = (rated.gap(&state), rated.length(&state));
        assert!(gap.value.norm() < 1e-14 && gap.rate.norm() < 1e-13 && gap.acceleration.norm() < 1e-12, "{t}: {gap:?}");
        assert!((length.value - 0.373_f64.hypot(0.196).hypot(0.037)).abs() < 1e-14 && length.rate.abs() < 1e-13, "{t}: {length:?}");
    }
}
