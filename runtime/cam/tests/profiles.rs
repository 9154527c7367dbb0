//! Profiles against circles, handbook formulas and differences.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use reuleaux::nalgebra::Vector2;
use reuleaux::{Motion, PlanarBody};
use reuleaux_cam::follower::{Swinging, SwingingFace, Translating, TranslatingFace};
use reuleaux_cam::{CamError, CurvePoint};

type Place = Vector2<f64>;

fn angles() -> impl Iterator<Item = f64> {
    (0..720).map(|half| f64::from(half).to_radians() / 2.0)
}

/// A lift of 12 mm over 120° by the cycloid, a dwell to 180°, the return over 120°, with derivatives by the angle.
fn lift(angle: f64) -> Motion<f64> {
    let (height, stroke) = (0.012, TAU / 3.0);
    let rise = |u: f64, sign: f64| {
        let (sine, cosine) = (TAU * u).sin_cos();
        let (first, second) = (height / stroke, height / (stroke * stroke));
        let value = height * (u - sine / TAU);
        Motion {
            value: if sign > 0.0 { value } else { height - value },
            rate: sign * first * (1.0 - cosine),
            acceleration: sign * second * TAU * sine,
        }
    };
    match angle.rem_euclid(TAU) {
        a if a < stroke => rise(a / stroke, 1.0),
        a if a < PI => Motion { value: height, rate: 0.0, acceleration: 0.0 },
        a if a < PI + stroke => rise((a - PI) / stroke, -1.0),
        _ => Motion { value: 0.0, rate: 0.0, acceleration: 0.0 },
    }
}

fn close(found: f64, exact: f64, allowed: f64, at: f64) {
    assert!((found - exact).abs() <= allowed, "{found} instead of {exact} at {at}");
}

/// The polar curve of a circle about (e, 0) is a circle, and so are its parallels.
#[test]
fn an_eccentric_circle_stays_a_circle() {
    let (radius, e) = (0.04, 0.015);
    for psi in angles() {
        let (sine, cosine) = psi.sin_cos();
        let root = (radius * radius - e * e * sine * sine).sqrt();
        // R = e cos ψ + √(a² − e² sin² ψ)
        let slope = -e * sine - e * e * sine * cosine / root;
        let bend = -e * cosine - e * e * (cosine * cosine - sine * sine) / root - (e * e * sine * cosine).powi(2) / root.powi(3);
        let pitch = CurvePoint::polar(psi, &Motion { value: e * cosine + root, rate: slope, acceleration: bend }).unwrap();
        let centre = Place::new(e, 0.0);
        close(pitch.radius_of_curvature(), radius, 1e-15, psi);
        assert!((pitch.point - centre - pitch.normal * radius).norm() < 1e-15);
        let surface = pitch.surface(0.01).unwrap();
        close((surface.point - centre).norm(), 0.03, 1e-15, psi);
        close(surface.radius_of_curvature(), 0.03, 1e-15, psi);
        close((surface.pitch(0.01).unwrap().point - pitch.point).norm(), 0.0, 1e-16, psi);
        close((surface.cutter(0.02).unwrap().point - centre).norm(), 0.05, 1e-15, psi);
        // The roller has to be smaller than the circle, and no groove has a hollow in it.
        assert!(matches!(pitch.surface(0.0401), Err(CamError::Undercut { at, .. }) if at == psi));
        let wall = pitch.outer_surface(0.01).unwrap();
        close(wall.radius_of_curvature(), -0.05, 1e-15, psi);
        assert!(wall.cutter(0.049).is_ok() && matches!(wall.cutter(0.051), Err(CamError::TooHollow { .. })));
        close((wall.cutter(0.01).unwrap().point - pitch.point).norm(), 0.0, 1e-16, psi);
    }
}

/// Norton, Cam Design and Manufacturing Handbook, chapter 7.
#[test]
fn a_translating_follower_has_the_formulas_of_handbooks() {
    for offset in [0.0, 0.008, -0.01] {
        let follower = Translating { prime_radius: 0.04, offset };
        for angle in angles() {
            let (s, first, second) = (lift(angle).value, lift(angle).rate, lift(angle).acceleration);
            let station = follower.station(angle, &lift(angle)).unwrap();
            let root = (0.04_f64 * 0.04 - offset * offset).sqrt();
            close(station.pressure_angle.tan(), (first - offset) / (s + root), 1e-14, angle);
            if offset == 0.0 {
                let r = 0.04 + s;
                let radius = (r * r + first * first).powf(1.5) / (r * r + 2.0 * first * first - r * second);
                close(1.0 / station.curve.radius_of_curvature(), 1.0 / radius, 1e-11, angle);
                close(station.curve.point.norm(), r, 1e-15, angle);
            }
        }
    }
}

/// Chen, Mechanics and Design of Cam Mechanisms, for the arm on the other side: tan α = (l (1 + φ′) − c cos φ) / (c sin φ).
#[test]
fn a_swinging_follower_has_the_formula_of_handbooks() {
    let (distance, arm) = (0.1, 0.08);
    let follower = Swinging { pivot: Place::new(distance, 0.0), arm };
    for angle in angles() {
        // 10 rad per m of lift.
        let [phi, first, second] = [0.45 + 10.0 * lift(angle).value, 10.0 * lift(angle).rate, 10.0 * lift(angle).acceleration];
        let swing = Motion { value: PI - phi, rate: -first, acceleration: -second };
        let station = follower.station(angle, &swing).unwrap();
        let exact = (arm * (1.0 + first) - distance * phi.cos()) / (distance * phi.sin());
        close(station.pressure_angle.tan(), exact, 1e-12, angle);
    }
}

/// Normals and curvatures are those of the points, by differences.
#[test]
fn normals_and_curvatures_are_those_of_the_curve() {
    let translating = Translating { prime_radius: 0.035, offset: 0.006 };
    let swinging = Swinging { pivot: Place::new(0.09, 0.02), arm: 0.07 };
    let face = SwingingFace { pivot: Place::new(0.09, 0.0), offset: 0.005 };
    let curves: [&dyn Fn(f64) -> CurvePoint; 5] = [
        &|angle| translating.station(angle, &lift(angle)).unwrap().curve,
        &|angle| translating.station(angle, &lift(angle)).unwrap().curve.surface(0.008).unwrap(),
        &|angle| {
            let l = lift(angle);
            let swing = Motion { value: 2.7 - 5.0 * l.value, rate: -5.0 * l.rate, acceleration: -5.0 * l.acceleration };
            swinging.station(angle, &swing).unwrap().curve.surface(0.006).unwrap()
        },
        &|angle| TranslatingFace { base_radius: 0.04 }.station(angle, &lift(angle)).unwrap().curve,
        &|angle| {
            let l = lift(angle);
            let normal = Motion { value: 1.1 - 3.0 * l.value, rate: -3.0 * l.rate, acceleration: -3.0 * l.acceleration };
            face.station(angle, &normal).unwrap().curve
        },
    ];
    for (number, curve) in curves.into_iter().enumerate() {
        for angle in angles().map(|angle| angle + 0.001) {
            let step = 1e-4;
            let [before, here, after] = [angle - step, angle, angle + step].map(curve);
            let chord = after.point - before.point;
            assert!(chord.normalize().dot(&here.normal).abs() < 2e-6, "curve {number} at {angle}");
            // The change of the normal along the curve is its curvature.
            let bend = (after.normal - before.normal).dot(&chord) / chord.norm_squared();
            assert!((bend / here.curvature - 1.0).abs() < 1e-3, "curve {number} at {angle}: {bend} and {}", here.curvature);
            // So is the circle through three points, up to the change of curvature.
            let circle = CurvePoint::through(angle, [before, here, after].map(|point| point.point)).unwrap();
            assert!((circle.curvature / here.curvature - 1.0).abs() < 1e-3, "curve {number} at {angle}");
            assert!((circle.normal - here.normal).norm() < 1e-5, "curve {number} at {angle}");
        }
    }
}

/// h = a + e cos ψ is a circle about (e, 0), and h + h″ = a.
#[test]
fn a_flat_face_on_an_eccentric_touches_a_circle() {
    let (radius, e) = (0.04, 0.015);
    for angle in angles() {
        // The face's normal has the angle ψ = 90° − θ in the cam.
        let (sine, cosine) = (FRAC_PI_2 - angle).sin_cos();
        let lift = Motion { value: e * cosine, rate: e * sine, acceleration: -e * cosine };
        let station = TranslatingFace { base_radius: radius }.station(angle, &lift).unwrap();
        assert!((station.curve.point - Place::new(e, 0.0) - station.curve.normal * radius).norm() < 1e-16);
        close(station.curve.radius_of_curvature(), radius, 1e-15, angle);
    }
}

/// The state of bodies gives the same curve as the formulas, also where the cam speeds up.
#[test]
fn moving_bodies_draw_the_same_curve() {
    let (translating, face) = (Translating { prime_radius: 0.04, offset: 0.005 }, TranslatingFace { base_radius: 0.03 });
    for angle in angles() {
        // θ̇ = −7, θ̈ = 40; the chain rule gives the motion over time.
        let (speed, growth, place) = (-7.0, 40.0, Place::new(0.3, -0.2));
        let over_time = |over_angle: Motion<f64>| Motion {
            value: over_angle.value,
            rate: over_angle.rate * speed,
            acceleration: over_angle.acceleration * speed * speed + over_angle.rate * growth,
        };
        let rest = Place::zeros();
        let cam = PlanarBody {
            position: place,
            angle,
            velocity: rest,
            angular_velocity: speed,
            acceleration: rest,
            angular_acceleration: growth,
        };
        let l = over_time(lift(angle));
        let root = (0.04_f64 * 0.04 - 0.005 * 0.005).sqrt();
        let centre = Motion {
            value: place + Place::new(0.005, root + l.value),
            rate: Place::new(0.0, l.rate),
            acceleration: Place::new(0.0, l.acceleration),
        };
        let (found, exact) = (CurvePoint::relative(&cam, &centre).unwrap(), translating.station(angle, &lift(angle)).unwrap());
        assert!((found.point - exact.curve.point).norm() < 1e-15 && (found.normal - exact.curve.normal).norm() < 1e-13);
        close(found.curvature, exact.curve.curvature, 1e-10, angle);
        close(found.pressure_angle(CurvePoint::direction(&cam, Place::new(0.0, 1.0))), exact.pressure_angle, 1e-13, angle);

        let follower = PlanarBody {
            position: place + Place::new(0.01, 0.03 + l.value),
            angle: 0.2,
            velocity: Place::new(0.0, l.rate),
            angular_velocity: 0.0,
            acceleration: Place::new(0.0, l.acceleration),
            angular_acceleration: 0.0,
        };
        let found = CurvePoint::face(&cam, &follower, rest, FRAC_PI_2 - 0.2).unwrap();
        let exact = face.station(angle, &lift(angle)).unwrap().curve;
        assert!((found.point - exact.point).norm() < 1e-15);
        close(found.curvature, exact.curvature, 1e-10, angle);
    }
}

/// The largest roller is the smallest convex radius of curvature; a larger one is refused at the angle of that radius.
#[test]
fn undercutting_is_named_by_its_angle() {
    let follower = Translating { prime_radius: 0.025, offset: 0.0 };
    let pitch: Vec<CurvePoint> = angles().map(|angle| follower.station(angle, &lift(angle)).unwrap().curve).collect();
    let convex = pitch.iter().filter(|point| point.curvature > 0.0);
    let sharpest = convex.max_by(|one, two| one.curvature.total_cmp(&two.curvature)).unwrap();
    let limit = sharpest.radius_of_curvature();
    assert!(pitch.iter().all(|point| point.surface(limit * 0.999).is_ok()));
    let refused: Vec<CamError> = pitch.iter().filter_map(|point| point.surface(limit * 1.0001).err()).collect();
    assert!(refused.iter().any(|error| error.at() == sharpest.at) && refused.len() < 20);
    let words = pitch[pitch.iter().position(|point| point == sharpest).unwrap()].surface(1.5 * limit).unwrap_err().to_string();
    let degrees = sharpest.at.to_degrees();
    assert!(words.starts_with(&format!("the surface is undercut at {degrees:.2}°: the pitch curve's radius of curvature is ")), "{words}");

    // A base circle that is too small for a flat face: R + s + s″ is negative where the rise slows down.
    let face = TranslatingFace { base_radius: 0.002 };
    let refused = angles().find_map(|angle| face.station(angle, &lift(angle)).err()).unwrap();
    let at = refused.at();
    assert!(matches!(refused, CamError::NotConvex { radius, .. } if radius <= 0.0));
    assert!(0.002 + lift(at).value + lift(at).acceleration <= 0.0 && face.station(at - 0.02, &lift(at - 0.02)).is_ok());
}

#[test]
fn what_has_no_normal_is_refused() {
    let rest = Motion { value: Place::new(0.1, 0.0), rate: Place::zeros(), acceleration: Place::zeros() };
    assert_eq!(CurvePoint::new(0.5, &rest), Err(CamError::NoNormal { at: 0.5 }));
    let radial = Motion { rate: Place::new(1.0, 0.0), ..rest };
    assert_eq!(CurvePoint::new(0.5, &radial), Err(CamError::NoNormal { at: 0.5 }));
    let far = Translating { prime_radius: 0.02, offset: 0.03 };
    assert_eq!(far.station(0.1, &lift(0.1)), Err(CamError::OutOfReach { at: 0.1 }));
    assert!(CurvePoint::through(0.0, [Place::new(0.1, 0.0); 3]).is_err());
    let standing = Motion { value: 0.1, rate: 0.0, acceleration: 0.0 };
    assert_eq!(CurvePoint::envelope(0.2, &standing, &standing), Err(CamError::NoNormal { at: 0.2 }));
}

#[test]
fn a_point_is_a_line_of_a_file() {
    let circle = CurvePoint::polar(FRAC_PI_2, &Motion { value: 0.04, rate: 0.0, acceleration: 0.0 }).unwrap();
    assert_eq!(circle.to_string(), "90.0000,0.000000,40.000000,90.0000,0.02500000");
    assert_eq!(CurvePoint::COLUMNS.split(',').count(), circle.to_string().split(',').count());
}

/// Where the tangent of the pitch curve passes the radius the material stays on its side. At θ = 0 with y = √(R² − e²), s = s″ = 0:
///
/// ```text
///   p′ = (y, s′ − e)      p″ = (2s′ − e, −y)      n ∝ (e − s′, y)      κ = (y² + (s′ − e) (2s′ − e)) / |p′|³
/// ```
#[test]
fn a_steep_flank_keeps_its_side() {
    let (follower, offset) = (Translating { prime_radius: 0.04, offset: 0.03 }, 0.03_f64);
    let y = (0.04_f64 * 0.04 - offset * offset).sqrt();
    for slope in (-20..=200).map(|thousandths| f64::from(thousandths) * 1e-3) {
        let beside = slope - offset;
        let station = follower.station(0.0, &Motion { value: 0.0, rate: slope, acceleration: 0.0 }).unwrap();
        let normal = Place::new(-beside, y).normalize();
        assert!((station.curve.normal - normal).norm() < 1e-14, "s' = {slope}: {:?}, not {normal:?}", station.curve.normal);
        close(station.curve.curvature, (y * y + beside * (slope + beside)) / (y * y + beside * beside).powf(1.5), 1e-13, slope);
        close(station.pressure_angle, (beside / y).atan(), 1e-14, slope);
    }
}
