//! Sizes of cams and measured profiles, against circles, whose radii and pressure angles are known.

use std::f64::consts::{FRAC_PI_4, TAU};

use reuleaux::Motion;
use reuleaux::nalgebra::Vector2;
use reuleaux_cam::follower::{Station, Translating, TranslatingFace};
use reuleaux_cam::{CamError, CurvePoint, Extremes, Harmonics, Profile};

/// Radius of a disc, the distance of its middle from the shaft, and the radius of a roller (m).
const DISC: f64 = 0.03;
const BESIDE: f64 = 0.008;
const ROLLER: f64 = 0.01;

fn angles(count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..count).map(move |step| f64::from(step) * TAU / f64::from(count))
}

/// R(ψ) of a circle about (e, 0) with its derivatives by ψ.
fn circle(radius: f64, psi: f64) -> Motion<f64> {
    let (sine, cosine) = psi.sin_cos();
    let root = (radius * radius - BESIDE * BESIDE * sine * sine).sqrt();
    let [slope, bend] = [BESIDE * BESIDE * sine * cosine, BESIDE * BESIDE * (cosine * cosine - sine * sine)];
    Motion {
        value: BESIDE * cosine + root,
        rate: -BESIDE * sine - slope / root,
        acceleration: -BESIDE * cosine - bend / root - slope * slope / root.powi(3),
    }
}

/// The lift over the cam's angle of a slide above the shaft, on a pitch curve that is a circle: lowest at 0.
fn lift(radius: f64, angle: f64) -> Motion<f64> {
    let seen = circle(radius, std::f64::consts::PI - angle);
    Motion { value: seen.value - (radius - BESIDE), rate: -seen.rate, ..seen }
}

/// The normals of a disc pass its middle, so that sin α = e/a at the most, upwards as well as downwards.
#[test]
fn the_pressure_angle_of_a_disc_gives_its_size() {
    let pitch = DISC + ROLLER;
    let limit = (BESIDE / pitch).asin();
    let lifts = || angles(100_000).map(|angle| lift(pitch, angle));
    let found = Translating::smallest(0.0, [limit, limit], lifts()).unwrap();
    // The largest lies between two of the angles: an error of the second order.
    assert!((found.prime_radius / (pitch - BESIDE) - 1.0).abs() < 1e-8, "{found:?}");
    // A limit downwards that is not reached changes nothing.
    let one_way = Translating::smallest(0.0, [limit, 2.0 * limit], lifts()).unwrap();
    assert!((one_way.prime_radius - found.prime_radius).abs() < 1e-10);
    assert!(Translating::smallest(0.0, [limit, 0.9 * limit], lifts()).unwrap().prime_radius > found.prime_radius + 1e-3);
}

/// Beside the shaft the root of R² − e² is what the formula gives, and the pressure angle of the result reaches its limit and no more.
#[test]
fn the_pressure_angle_reaches_its_limit_and_no_more() {
    let limits @ [rise, fall] = [25_f64.to_radians(), 35_f64.to_radians()];
    let lifts = || angles(3600).map(|angle| (angle, lift(DISC, angle)));
    for offset in [-0.004, 0.0, 0.004] {
        let cam = Translating::smallest(offset, limits, lifts().map(|(_, lift)| lift)).unwrap();
        let margins = |cam: Translating| {
            let margin = |(angle, lift): (f64, Motion<f64>)| {
                let limit = if lift.rate > 0.0 { rise } else { fall };
                limit - cam.station(angle, &lift).unwrap().pressure_angle.abs()
            };
            lifts().map(margin).fold(f64::INFINITY, f64::min)
        };
        assert!(margins(cam).abs() < 1e-12, "{}", margins(cam));
        assert!(margins(Translating { prime_radius: 0.999 * cam.prime_radius, ..cam }) < -1e-4);
    }
    let refused = |limits| Translating::smallest(0.0, limits, lifts().map(|(_, lift)| lift));
    assert!(refused([0.0, rise]).is_none() && refused([rise, f64::NAN]).is_none());
    assert!(Translating::smallest(0.0, limits, [lift(DISC, 1.0), Motion::at(f64::NAN)]).is_none(), "a lift that is not a number");
    assert!(Translating::smallest(0.0, limits, [Motion::at(0.0)]).is_none(), "no lift, no size");
}

/// s = e (1 − cos θ) on a flat face is a disc of the radius R + e.
#[test]
fn the_radius_of_curvature_gives_the_size_for_a_flat_face() {
    let lifts = || angles(360).map(|angle| Motion { value: BESIDE * (1.0 - angle.cos()), rate: 0.0, acceleration: BESIDE * angle.cos() });
    let face = TranslatingFace::smallest(DISC, lifts()).unwrap();
    assert!((face.base_radius - (DISC - BESIDE)).abs() < 1e-15);
    assert!(TranslatingFace::smallest(0.9 * BESIDE, lifts()).is_none());
    assert!(TranslatingFace::smallest(DISC, [Motion::at(f64::NAN), Motion::at(0.0)]).is_none());
}

#[test]
fn extremes_are_those_of_the_disc() {
    let pitch = DISC + ROLLER;
    let follower = Translating { prime_radius: pitch - BESIDE, offset: 0.0 };
    let stations = angles(3600).map(|angle| follower.station(angle, &lift(pitch, angle)).unwrap());
    let found = Extremes::of(stations.clone()).unwrap();
    assert!((found.pressure_angle.value.abs().sin() - BESIDE / pitch).abs() < 1e-6);
    // There the normal is at right angles to the line from the shaft to the middle of the disc.
    assert!((found.pressure_angle.at.cos().abs()) < 2e-3);
    assert!((found.convex.unwrap().value - pitch).abs() < 1e-14 && found.hollow.is_none());
    // The walls of a groove: one is convex, one hollow.
    let outer = stations.map(|station| Station { curve: station.curve.outer_surface(ROLLER).unwrap(), ..station });
    let found = Extremes::of(outer).unwrap();
    assert!((found.hollow.unwrap().value - (pitch + ROLLER)).abs() < 1e-14 && found.convex.is_none());
    assert!(Extremes::of([]).is_none());
}

#[test]
fn a_point_gives_back_its_polar_radius() {
    for psi in angles(360) {
        let (given, point) = (circle(DISC, psi), CurvePoint::polar(psi, &circle(DISC, psi)).unwrap());
        let found = point.polar_radius().unwrap();
        assert!((found.value - given.value).abs() < 1e-16 && (found.rate - given.rate).abs() < 1e-16);
        assert!((found.acceleration - given.acceleration).abs() < 1e-15);
        assert!((point.direction_angle() - psi).sin().abs() < 1e-15);
        // The outer wall of a groove is a circle, too; its normal is directed inwards.
        let wall = point.outer_surface(ROLLER).unwrap();
        let found = wall.polar_radius().unwrap();
        let exact = circle(DISC + ROLLER, wall.direction_angle());
        assert!((found.rate - exact.rate).abs() < 1e-15 && (found.acceleration - exact.acceleration).abs() < 1e-15, "{psi}");
    }
    let radial = CurvePoint { at: 0.3, point: Vector2::new(0.1, 0.0), normal: Vector2::new(0.0, 1.0), curvature: 0.0 };
    assert_eq!(radial.polar_radius(), Err(CamError::NoNormal { at: 0.3 }));
}

/// A surface is measured, at places that are not equal; between them the pitch curve is a circle.
#[test]
fn a_measured_surface_gives_the_pitch_curve_between_its_points() {
    let places = || angles(120).map(|psi| psi + 0.02 * (3.0 * psi).sin());
    let pitch: Vec<CurvePoint> = places().map(|psi| CurvePoint::polar(psi, &circle(DISC, psi)).unwrap().pitch(ROLLER).unwrap()).collect();
    let backwards: Vec<CurvePoint> = pitch.iter().rev().copied().collect();
    for points in [&pitch, &backwards] {
        let profile = Profile::new(points).unwrap();
        for psi in angles(777).map(|psi| 3.0 * psi - 9.0) {
            let (found, exact) = (profile.radius(psi), circle(DISC + ROLLER, psi));
            assert!((found.value - exact.value).abs() < 1e-13, "{} at {psi}", found.value - exact.value);
            assert!((found.rate - exact.rate).abs() < 1e-11 && (found.acceleration - exact.acceleration).abs() < 1e-8);
        }
    }
}

#[test]
fn what_does_not_go_round_is_refused() {
    let point = |psi: f64| CurvePoint::polar(psi, &Motion::at(DISC)).unwrap();
    let of = |places: &[f64]| {
        let points: Vec<CurvePoint> = places.iter().map(|psi| point(*psi)).collect();
        Profile::new(&points).map(|_| ())
    };
    assert_eq!(of(&[0.0, 2.0, 4.0]), Ok(()));
    assert_eq!(of(&[0.0, 2.0, 1.0, 4.0]), Err(CamError::NotRound { at: 2.0 }));
    assert_eq!(of(&[0.0, 2.0, 2.0, 4.0]), Err(CamError::NotRound { at: 2.0 }));
    assert_eq!(of(&[0.0, 1.0, 2.0]), Err(CamError::NotRound { at: 2.0 }), "a gap of more than half a turn");
    assert!(of(&[0.0, 2.0, 4.0, TAU + 0.1, TAU + 2.1, TAU + 4.1]).is_err(), "twice round");
    assert_eq!(of(&[0.0, TAU / 2.0]), Err(CamError::NotRound { at: 0.0 }), "half a turn may be either way");
    assert!(of(&[]).is_err() && of(&[FRAC_PI_4]).is_err());
}

/// Readings of three waves with a fourth one, which is finer than what is asked for.
#[test]
fn harmonics_leave_out_what_is_finer() {
    let law = |psi: f64| [0.04 + 0.005 * psi.cos() - 0.002 * (2.0 * psi).sin() + 1e-3 * (3.0 * psi).cos(), 1e-4 * (9.0 * psi).sin()];
    let readings: Vec<f64> = angles(24).map(|psi| law(psi).iter().sum()).collect();
    let found = Harmonics::<3>::of(&readings).unwrap();
    for psi in angles(100) {
        let exact = [
            law(psi)[0],
            -0.005 * psi.sin() - 0.004 * (2.0 * psi).cos() - 3e-3 * (3.0 * psi).sin(),
            -0.005 * psi.cos() + 0.008 * (2.0 * psi).sin() - 9e-3 * (3.0 * psi).cos(),
        ];
        let Motion { value, rate, acceleration } = found.at(psi);
        assert!([value, rate, acceleration].iter().zip(exact).all(|(found, exact)| (found - exact).abs() < 1e-15), "{psi}");
    }
    assert!(Harmonics::<12>::of(&readings).is_none() && Harmonics::<11>::of(&readings).is_some());
}
