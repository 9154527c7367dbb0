//! Binary links: the same mechanisms with a further body welded to the coupler, which is then no binary link.

use reuleaux::{Cause, PlanStage, SpatialBody, mechanism};

/// A crank-rocker whose coupler hangs between a ball and a cross; `$turned` turns the coupler about its line, `$more` is added to the twin.
macro_rules! crank_rocker {
    ($link:ident, $twin:ident, $turned:literal) => {
        crank_rocker!(@ $link, $turned);
        crank_rocker!(@ $twin, $turned, body flag { axis z = (0, 0, 1) from (1, 0, 0); }
            joint glue = weld(coupler.B, coupler.z, flag.position, flag.z););
    };
    (@ $name:ident, $turned:literal $(, $($more:tt)*)?) => {
        mechanism! {
            #[allow(far_start)]
            mechanism $name in space {
                param length: Length = 2.2m;
                gravity = (0m_s2, 0m_s2, -9.81m_s2);
                ground {
                    axis z = (0, 0, 1) from (1, 0, 0);
                    point O = (2.2m, 0.3m, 0.5m);
                    axis skew = (sin(0.3), -sin(0.5) * cos(0.3), cos(0.5) * cos(0.3)) from (cos(0.3), sin(0.5) * sin(0.3), -cos(0.5) * sin(0.3));
                }
                body crank { axis z = (0, 0, 1) from (1, 0, 0);  point A = (0.5m, 0m, 0m);  mass = 2kg;  inertia = (1kgm2, 1kgm2, 1kgm2); }
                body rocker {
                    axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0);  point B = (1.4m, 0m, 0m);
                    start orientation = turn((1, 0, 0), 0.5rad) * turn((0, 1, 0), 0.3rad) * turn((0, 0, 1), -1.33rad);
                    mass = 3kg;  center = (0.7m, 0.1m, 0m);  inertia = (1kgm2, 2kgm2, 2kgm2);
                }
                body coupler {
                    axis z = (0, 0, 1) from (1, 0, 0);
                    // The origin lies beside the line of the joints.
                    point A = (-length / 2, 0.2m, 0m);  point B = (length / 2, 0.2m, 0m);  point corner = (0.2m, 0.3m, 0.4m);
                    mass = 4kg;  center = (0.1m, 0.3m, -0.2m);  inertia = (3kgm2, 4kgm2, 5kgm2, 0.1kgm2, 0.2kgm2, -0.1kgm2);
                    start orientation = turn((1, 0, 0), 0.5rad) * turn((0, 1, 0), 0.3rad) * turn((0, 0, 1), -1.33rad)
                        * turn((0, 1, 0), -0.55rad) * turn((0, 0, 1), 0.82rad) * turn((1, 0, 0), $turned);
                }
                joint axle = revolute(ground.position, ground.z, crank.position, crank.z);
                joint pivot = revolute(ground.O, ground.skew, rocker.position, rocker.z);
                joint ball = spherical(crank.A, coupler.A);
                joint cross_pin = universal(rocker.B, rocker.y, coupler.B, coupler.z);
                drive motor = drive_rotation(axle, 1rad_s * t + 0.3rad * sin(1rad_s * t));
                output corner = coupler.corner with jerk;
                $($($more)*)?
            }
        }
    };
}

crank_rocker!(Link, Twin, 0deg);
crank_rocker!(TurnedLink, TurnedTwin, 180deg);

/// All numbers of a body's motion.
fn numbers(body: &SpatialBody<f64>) -> Vec<f64> {
    let vectors = [body.position, body.velocity, body.acceleration, body.angular_velocity, body.angular_acceleration];
    let turned = body.rotation.iter();
    vectors.iter().flat_map(|vector| vector.iter()).chain(turned).copied().collect()
}

/// Compares two lists of numbers, relative to the largest.
fn compare(what: &str, found: &[f64], wanted: &[f64]) {
    assert_eq!(found.len(), wanted.len());
    let largest = wanted.iter().map(|entry| entry.abs()).fold(1.0, f64::max);
    let error = found.iter().zip(wanted).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max);
    assert!(error <= 1e-12 * largest, "{what}: {error:e} of {largest}");
}

macro_rules! agree {
    ($test:ident, $link:ident, $twin:ident) => {
        #[test]
        fn $test() {
            for length in [2.2, 2.3] {
                let (link, twin) = ($link { length }, $twin { length });
                let times = || (0..200).map(|step| 0.1 * f64::from(step));
                for (found, wanted) in link.sweep(times()).zip(twin.sweep(times())) {
                    let (found, wanted) = (found.expect("a state"), wanted.expect("a state"));
                    for (body, own, other) in [
                        ("crank", found.crank(), wanted.crank()),
                        ("rocker", found.rocker(), wanted.rocker()),
                        ("coupler", found.coupler(), wanted.coupler()),
                    ] {
                        compare(body, &numbers(&own), &numbers(&other));
                    }
                    let jerks = [link.corner(&found).jerk, twin.corner(&wanted).jerk];
                    compare("jerk", jerks[0].as_slice(), jerks[1].as_slice());
                    let (found, wanted) = (link.loads(&found), twin.loads(&wanted));
                    compare("motor", &[found.motor().effort], &[wanted.motor().effort]);
                    let parts = |load: reuleaux::SpatialLoad<f64>| load.force.iter().chain(load.torque.iter()).copied().collect::<Vec<_>>();
                    compare("ball", &parts(found.ball()), &parts(wanted.ball()));
                    compare("cross", &parts(found.cross_pin()), &parts(wanted.cross_pin()));
                }
            }
        }
    };
}

agree!(a_link_moves_and_pulls_as_a_body_of_its_own, Link, Twin);
agree!(a_link_keeps_the_side_on_which_it_starts, TurnedLink, TurnedTwin);

#[test]
fn a_link_turned_about_its_line_shows_its_other_side() {
    let (link, turned) = (Link::default().solve(0.0).expect("a state"), TurnedLink::default().solve(0.0).expect("a state"));
    let arms = [link.coupler(), turned.coupler()].map(|body| body.rotation.column(2).into_owned());
    assert!((arms[0] + arms[1]).norm() < 1e-14, "{arms:?}");
}

#[test]
fn a_link_is_no_unknown_of_a_block() {
    let blocks = Link::<f64>::PLAN.stages.iter().filter_map(|stage| match stage {
        PlanStage::Iterated { unknowns, .. } => Some(*unknowns),
        _ => None,
    });
    assert_eq!(blocks.collect::<Vec<_>>(), [&["pivot.angle"][..]]);
}

mechanism! {
    /// A slider-crank in a plane, whose cross has an arm along the rail: it folds where the rod lies along the rail.
    mechanism Folding in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0);  axis x = (1, 0, 0) from (0, 0, 1); }
        body crank  { axis z = (0, 0, 1) from (1, 0, 0);  point A = (0.1m, 0m, 0m); }
        body slider { axis x = (1, 0, 0) from (0, 0, 1); }
        body rod    { axis z = (0, 0, 1);  point A = (0m, 0m, 0m);  point B = (0.3m, 0m, 0m);  start position = (50mm, 86.6mm, 0mm); }
        joint axle = revolute(ground.position, ground.z, crank.position, crank.z);
        joint ball = spherical(crank.A, rod.A);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.z);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        drive motor = drive_rotation(axle, 60deg + 1rad_s * t);
    }
}

/// The time at which the crank stands at an angle, in degrees.
fn at(angle: f64) -> f64 {
    (angle - 60.0).to_radians()
}

#[test]
fn a_link_does_not_jump_to_its_other_side() {
    let folding = Folding::default();
    let mut state = folding.solve(0.0).expect("a state");
    // At 180° the rod lies along the rail, and its turning about its own line is not determined.
    for angle in (61..180).map(|angle| f64::from(angle) + 0.5) {
        let before = state.rod().rotation.column(2).into_owned();
        folding.advance(&mut state, at(angle)).expect("a state");
        assert!(state.rod().rotation.column(2).dot(&before) > 0.9, "{angle}");
    }
    for angle in [180.0, 180.5, 200.0, 359.0] {
        let failure = folding.advance(&mut state.clone(), at(angle)).expect_err("a cross that folds");
        assert!(matches!(failure.cause, Cause::BranchLost { .. } | Cause::NotFinite { .. } | Cause::Singular { .. }), "{failure}");
        // Direction cosines are told as the orientation of their body.
        assert!(!failure.to_string().contains("`rod.a"), "{failure}");
        assert!(folding.solve(at(angle)).is_err(), "{angle}");
    }
}

mechanism! {
    /// The same beside a linkage that a constant drive holds still: single steps solve the moving part only.
    mechanism FoldingBesideRest in space {
        ground {
            axis z = (0, 0, 1) from (1, 0, 0);  axis x = (1, 0, 0) from (0, 0, 1);
            point held = (2m, 0m, 0m);  point other = (2.4m, 0m, 0m);
        }
        body arm    { axis z = (0, 0, 1) from (1, 0, 0);  point end = (0.3m, 0m, 0m);  start orientation = turn((0, 0, 1), 60deg); }
        body bar    { axis z = (0, 0, 1) from (1, 0, 0);  point end = (0.5m, 0m, 0m); }
        body rocker { axis z = (0, 0, 1) from (1, 0, 0);  point end = (0.4m, 0m, 0m);  start orientation = turn((0, 0, 1), 60deg); }
        joint arm_pivot = revolute(ground.held, ground.z, arm.position, arm.z);
        joint arm_ball = spherical(arm.end, bar.position);
        joint bar_cross = universal(bar.end, bar.z, rocker.end, rocker.z);
        joint rocker_pivot = revolute(ground.other, ground.z, rocker.position, rocker.z);
        drive hold = drive_rotation(arm_pivot, 60deg);

        body crank  { axis z = (0, 0, 1) from (1, 0, 0);  point A = (0.1m, 0m, 0m); }
        body slider { axis x = (1, 0, 0) from (0, 0, 1); }
        body rod    { axis z = (0, 0, 1);  point A = (0m, 0m, 0m);  point B = (0.3m, 0m, 0m);  point side = (0.1m, 0.1m, 0m);  start position = (50mm, 86.6mm, 0mm); }
        joint axle = revolute(ground.position, ground.z, crank.position, crank.z);
        joint ball = spherical(crank.A, rod.A);
        joint cross_pin = universal(slider.position, slider.x, rod.B, rod.z);
        joint rail = translational(ground.position, ground.x, slider.position, slider.x);
        drive motor = drive_rotation(axle, 60deg + 1rad_s * t);
        output side = rod.side;
    }
}

/// A part that is solved alone tests the sides of its links as the whole does.
#[test]
fn a_link_of_a_part_does_not_jump_to_its_other_side() {
    let folding = FoldingBesideRest::default();
    let mut state = folding.solve(0.0).expect("a state");
    let mut last = 0.0;
    for angle in (241..960).map(|quarter| f64::from(quarter) / 4.0 - 0.11) {
        if folding.advance(&mut state, at(angle)).is_err() {
            break;
        }
        assert!(state.rod().rotation[(2, 2)] > 0.9, "{angle}");
        last = angle;
    }
    assert!(last > 179.0, "{last}");
}
