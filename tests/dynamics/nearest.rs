//! Where bodies start whose motion is given by speeds alone: as near to their declared places as the joints allow.

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector3;

mechanism! {
    #[allow(far_start)]
    mechanism Bob in space {
        param length: Length = 200mm;
        body bob { point c = (length, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0m, 0.3m, 0.1m); }
        joint ball = spherical((0m, 0m, 0m), bob.c);
        freedom turning = bob.angular_velocity;
    }
}

mechanism! {
    /// Its place can be reached, but not without a turn.
    mechanism Reachable in space {
        body bob { point c = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0.12m, 0.16m, 0m); }
        joint ball = spherical((0m, 0m, 0m), bob.c);
        freedom turning = bob.angular_velocity;
    }
}

mechanism! {
    /// The same with two coordinates given, which leave two places open.
    mechanism Sides in space {
        body bob { point c = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0.12m, 0.16m, 0m); }
        joint ball = spherical((0m, 0m, 0m), bob.c);
        freedom y = bob.y from 0.16m;
        freedom z = bob.z from 0m;
        freedom spin = dot(bob.angular_velocity, bob.c - bob.position) / 1m;
    }
}

mechanism! {
    #[allow(far_start)]
    /// A hand welded to an arm that hangs on a ball.
    mechanism Welded in space {
        body arm { axis z = (0, 0, 1);  point e = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m); }
        body hand { axis z = (0, 0, 1);  point e = (0m, 0.1m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0.3m, 0m, 0m); }
        joint ball = spherical((0m, 0m, 0m), arm.position);
        joint wrist = weld(arm.e, arm.z, hand.e, hand.z);
        freedom turning = arm.angular_velocity;
    }
}

mechanism! {
    /// Two bodies on balls, in line at the start.
    mechanism Stretched in space {
        body upper { point e = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m); }
        body lower { point e = (0m, 0.1m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0.3m, 0m, 0m); }
        joint ball = spherical((0m, 0m, 0m), upper.position);
        joint knee = spherical(upper.e, lower.e);
        freedom one = upper.angular_velocity;
        freedom two = lower.angular_velocity;
    }
}

mechanism! {
    #[allow(far_start)]
    mechanism Sliding in space {
        ground { axis z = (0, 0, 1); }
        body ring { axis z = (0, 0, 1);  point c = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0m, 0.3m, 0.1m); }
        joint rod = cylindrical(ground.position, ground.z, ring.c, ring.z);
        freedom slide = rate(rod.displacement);
        freedom turning = ring.angular_velocity.z;
    }
}

mechanism! {
    mechanism Placed in space {
        ground { axis z = (0, 0, 1); }
        body ring { axis z = (0, 0, 1);  point c = (0.2m, 0m, 0m);  mass = 1kg;  inertia = ball(0.1m);  start position = (0m, 0.2m, 0.1m); }
        joint rod = cylindrical(ground.position, ground.z, ring.c, ring.z);
        freedom slide = rod.displacement;
        freedom turning = rod.angle;
    }
}

mechanism! {
    #[allow(far_start)]
    mechanism Flat {
        body bob { point c = (0.2m, 0m);  mass = 1kg;  inertia = 0.1kgm2;  start position = (0m, 0.3m); }
        joint pin = revolute((0m, 0m), bob.c);
        freedom turning = bob.angular_velocity;
    }
}

/// A driven loop of which no angle is declared, with further items.
macro_rules! driven_loop {
    ($(#[$attribute:meta])* $name:ident, $($items:tt)*) => {
        mechanism! {
            $(#[$attribute])*
            mechanism $name {
                ground { point C = (400mm, 0mm); }
                body crank { point A = (100mm, 0mm); }
                body coupler { point B = (350mm, 0mm); }
                body rocker { point B = (300mm, 0mm); }
                joint o = revolute(ground.position, crank.position);
                joint a = revolute(crank.A, coupler.position);
                joint b = revolute(coupler.B, rocker.B);
                joint c = revolute(ground.C, rocker.position);
                drive turn = drive_angle(crank, 60deg + 1rad_s * t);
                $($items)*
            }
        }
    };
}
driven_loop!(Loop,);
driven_loop!(
    #[allow(far_start)]
    Beside,
    body bob { point c = (0.2m, 0m);  mass = 1kg;  inertia = 0.1kgm2;  start position = (0m, 0.3m); }
    joint pin = revolute((1m, 0m), bob.c);
    freedom turning = bob.angular_velocity;
);

/// The place of a body at the start, found within 1e-9 m.
fn starts_at(found: Vector3<f64>, wanted: [f64; 3]) {
    assert!((found - Vector3::from(wanted)).norm() < 1e-9, "{found:?} instead of {wanted:?}");
}

macro_rules! place {
    ($mechanism:expr, $body:ident) => {
        $mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}")).$body().position
    };
}

#[test]
fn a_place_out_of_reach_is_approached() {
    // The points of a sphere, or of a circle, nearest to the declared ones.
    starts_at(place!(Bob::default(), bob), (Vector3::new(0.0, 0.3, 0.1).normalize() * 0.2).into());
    // With other parameters the bob stays turned as it is.
    let shorter = place!(Bob { length: 0.1 }, bob);
    starts_at(shorter, (Vector3::new(0.0, 0.3, 0.1).normalize() * 0.1).into());
    // The arm may turn freely: the hand is as far from the ball as it always is, in the declared direction.
    starts_at(place!(Welded::default(), hand), [0.05_f64.sqrt(), 0.0, 0.0]);
    starts_at(place!(Sliding::default(), ring), [0.0, 0.2, 0.1]);
    let flat = place!(Flat::default(), bob);
    starts_at(Vector3::new(flat.x, flat.y, 0.0), [0.0, 0.2, 0.0]);
}

#[test]
fn a_place_in_reach_is_taken() {
    starts_at(place!(Reachable::default(), bob), [0.12, 0.16, 0.0]);
    starts_at(place!(Sides::default(), bob), [0.12, 0.16, 0.0]);
    starts_at(place!(Placed::default(), ring), [0.0, 0.2, 0.1]);
    // Near its farthest place a body moves with the square of what its steps have left.
    let stretched = place!(Stretched::default(), lower);
    assert!((stretched - Vector3::new(0.3, 0.0, 0.0)).norm() < 1e-5, "{stretched:?}");
}

#[test]
fn a_loop_beside_it_begins_as_it_does_alone() {
    let alone = Loop::default().solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
    let beside = Beside::default().initial_state().unwrap_or_else(|stopped| panic!("{stopped}"));
    for (one, two) in [(alone.coupler().angle, beside.coupler().angle), (alone.rocker().angle, beside.rocker().angle)] {
        assert!((one - two).abs() < 1e-12, "{one} and {two}");
    }
}
