//! Three followers on one eccentric disc: a knife edge beside the centre, a roller on an arm, and a flat face on an arm.
//!
//! ```text
//!            │ │ knife edge at x = c
//!             V    __( ) roller, radius ρ
//!           ╱ ─ ╲ ╱      ╲__ arm, length l
//!          │ E·O │          ╲___(o) Q        |OE| = e, radius of the disc a
//!  (o)────── ───╱
//!   P      flat face through P
//! ```
//!
//! The centre E of the disc is at the constant distance a from the knife edge, a + ρ from the centre of the roller, and a from the flat face:
//! three equivalent linkages, an offset slider-crank, a four-bar, and a block that slides in a swinging frame. The cams are declared by
//! their profiles, the linkages by joints; angles, velocities and accelerations agree, turn after turn. Handbooks give the angles:
//!
//! ```text
//!   knife    sin α = (e cos θ − c) / a                                     α pressure angle, θ angle of the cam
//!   roller   cos μ = ((a + ρ)² + l² − |QE|²) / (2 (a + ρ) l)               α = 90° − μ
//!   face     φ = arg(E − P) − arcsin(a / |PE|),   α = 0
//! ```
//!
//! From the states of the cams `reuleaux-cam` computes the profile for each follower, which is the same circle three times.
//!
//! Source: R. L. Norton, Cam Design and Manufacturing Handbook, chapter 7; J. J. Uicker, G. R. Pennock and J. E. Shigley, Theory of Machines
//! and Mechanisms, on equivalent linkages.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_cam::{CamError, CurvePoint};
use reuleaux_examples::{Place, place, rectangle, round, show, steps};

mechanism! {
    /// A disc and its followers.
    #[picture]
    pub mechanism Followers {
        param speed: AngularVelocity = 60rpm;
        /// Radius of the disc, and the distance of its centre from the shaft.
        param disc: Length = 30mm;
        param eccentricity: Length = 8mm;
        param roller: Length = 8mm;
        param beside: Length = -6mm;
        param lever: Length = 60mm;

        // The radius of a circle about E, seen from O.
        function outline(psi: Angle) -> Length = eccentricity * cos(psi) + sqrt(disc^2 - (eccentricity * sin(psi))^2);
        function pitch(psi: Angle) -> Length =
            eccentricity * cos(psi) + sqrt((disc + roller)^2 - (eccentricity * sin(psi))^2) - roller;
        // Distance of its tangents.
        function support(psi: Angle) -> Length = disc + eccentricity * cos(psi);

        ground {
            point O = (0mm, 0mm);
            point P = (-75mm, 0mm);
            point Q = (75mm, 0mm);
            axis up = (0, 1);
        }
        body cam { point O = (0mm, 0mm); }
        body knife { point F = (0mm, 0mm);  start position = (beside, disc); }
        body arm { point C = (lever, 0mm);  start angle = 150deg; }
        body paddle { axis n = (0, -1);  start angle = -24deg; }

        joint shaft = revolute(ground.O, cam.O);
        joint guide = translational(ground.up, (beside, 0mm), knife.F);
        joint edge = cam_knife(cam.O, knife.F, outline);
        joint pivot = revolute(ground.Q, arm.position);
        joint rolls = cam_roller(cam.O, arm.C, roller, pitch);
        joint hinge = revolute(ground.P, paddle.position);
        joint face = cam_flat(cam.O, paddle.position, paddle.n, support);
        drive motor = drive_angle(cam, speed * t);

        output F = knife.F;
        output C = arm.C;
    }
}

mechanism! {
    /// The same motions by rods.
    pub mechanism Linkages {
        param speed: AngularVelocity = 60rpm;
        param disc: Length = 30mm;
        param eccentricity: Length = 8mm;
        param roller: Length = 8mm;
        param beside: Length = -6mm;
        param lever: Length = 60mm;

        ground { point O = (0mm, 0mm);  axis up = (0, 1); }
        body crank { point E = (eccentricity, 0mm); }
        body rod { point F = (disc, 0mm);  start angle = 90deg; }
        body knife { point F = (0mm, 0mm); }
        body coupler { point C = (disc + roller, 0mm);  start angle = 45deg; }
        body arm { point C = (lever, 0mm);  start angle = 150deg; }
        // The path of E lies beside the face, at the distance of a radius.
        body paddle { point A = (0mm, disc);  axis along = (1, 0);  start angle = -24deg; }

        joint shaft = revolute(ground.O, crank.position);
        joint big_end = revolute(crank.E, rod.position);
        joint small_end = revolute(rod.F, knife.F);
        joint guide = translational(ground.up, (beside, 0mm), knife.F);
        joint centre = revolute(crank.E, coupler.position);
        joint pivot = revolute((75mm, 0mm), arm.position);
        joint wrist = revolute(coupler.C, arm.C);
        joint hinge = revolute((-75mm, 0mm), paddle.position);
        joint slide = point_on_line(paddle.A, paddle.along, crank.E);
        drive motor = drive_angle(crank, speed * t);
    }
}

type State = FollowersState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let cam = Followers::default();
    let turn: Vec<State> = cam.sweep(steps(0.0, 1.0, 360)).collect::<Result<_, _>>()?;
    assert_linkages(&cam)?;
    assert_profiles(&cam, &turn)?;
    assert_pressure_angles(&cam, &turn)?;
    print(&cam, &turn)?;
    let angles = |state: &State| pressure_angles(&cam, state).unwrap_or([f64::NAN; 3]).map(f64::to_degrees);
    let disc = round(cam.disc).into_iter().map(|at| at + place(cam.eccentricity, 0.0));
    let view = cam
        .view(turn)
        .title("Followers of an eccentric disc")
        .over("cam", "°", |state| state.cam().angle.to_degrees())
        .outline("cam", disc)
        .outline("arm", round(cam.roller).into_iter().map(|at| at + place(cam.lever, 0.0)))
        .outline("paddle", rectangle(place(0.04, -0.0015), 0.0, 0.08, 0.003))
        .plot("knife edge", "mm", |state| (state.knife().position.y - cam.disc) * 1e3)
        .against("slider-crank", |state| (knife(&cam, state.cam().angle) - cam.disc) * 1e3)
        .plot("arm of the roller", "°", |state| state.arm().angle.to_degrees())
        .against("four-bar", |state| arm(&cam, state.cam().angle).to_degrees())
        .plot("flat face", "°", |state| state.paddle().angle.to_degrees())
        .against("formula", |state| paddle(&cam, state.cam().angle).to_degrees())
        .plot("pressure angle of the knife", "°", move |state| angles(state)[0])
        .and("of the roller", move |state| angles(state)[1])
        .and("of the face", move |state| angles(state)[2]);
    show("cam_followers", &view, 40, &[])
}

/// The centre of the disc at an angle of the cam (m).
fn centre(m: &Followers, angle: f64) -> Place {
    place(m.eccentricity * angle.cos(), m.eccentricity * angle.sin())
}

/// Height of the knife edge (m).
fn knife(m: &Followers, angle: f64) -> f64 {
    let centre = centre(m, angle);
    centre.y + (m.disc.powi(2) - (m.beside - centre.x).powi(2)).sqrt()
}

/// Angle of the roller's arm (rad): the triangle of Q, the centre of the disc and that of the roller.
fn arm(m: &Followers, angle: f64) -> f64 {
    let way = centre(m, angle) - place(0.075, 0.0);
    let cosine = (m.lever.powi(2) + way.norm_squared() - (m.disc + m.roller).powi(2)) / (2.0 * m.lever * way.norm());
    way.y.atan2(way.x).rem_euclid(TAU) - cosine.acos()
}

/// Angle of the flat face (rad): the tangent from P below the disc.
fn paddle(m: &Followers, angle: f64) -> f64 {
    let way = centre(m, angle) - place(-0.075, 0.0);
    way.y.atan2(way.x) - (m.disc / way.norm()).asin()
}

/// Three turns: the cams move as the linkages do, to the second derivative, and both as the formulas say.
fn assert_linkages(m: &Followers) -> Result<(), Box<dyn Error>> {
    let linkages = Linkages::default();
    let times = || steps(0.0, 3.0, 1000);
    for (cams, rods) in m.sweep(times()).zip(linkages.sweep(times())) {
        let (cams, rods) = (cams?, rods?);
        let angle = cams.cam().angle;
        let (one, two) = (cams.knife(), rods.knife());
        let places = [one.position.y - two.position.y, one.velocity.y - two.velocity.y, one.acceleration.y - two.acceleration.y];
        let angles = [(cams.arm(), rods.arm()), (cams.paddle(), rods.paddle())].map(|(one, two)| {
            [one.angle - two.angle, one.angular_velocity - two.angular_velocity, one.angular_acceleration - two.angular_acceleration]
        });
        for ([value, rate, acceleration], scale) in [(places, 0.1), (angles[0], 1.0), (angles[1], 1.0)] {
            assert!(value.abs() < 1e-14 * scale && rate.abs() < 1e-13 * scale && acceleration.abs() < 1e-11 * scale);
        }
        assert!((one.position.y - knife(m, angle)).abs() < 1e-15);
        assert!((cams.arm().angle - arm(m, angle)).abs() < 1e-14 && (cams.paddle().angle - paddle(m, angle)).abs() < 1e-14);
    }
    Ok(())
}

/// Points of the profile by each follower: knife, roller and face.
fn profiles(m: &Followers, state: &State) -> Result<[CurvePoint; 3], CamError> {
    let cam = state.cam();
    let knife = CurvePoint::relative(&cam, &m.F(state))?;
    let roller = CurvePoint::relative(&cam, &m.C(state))?.surface(m.roller)?;
    let face = CurvePoint::face(&cam, &state.paddle(), place(0.0, 0.0), -FRAC_PI_2)?;
    Ok([knife, roller, face])
}

/// Every point lies on the circle, with its normal and its curvature.
fn assert_profiles(m: &Followers, turn: &[State]) -> Result<(), Box<dyn Error>> {
    for state in turn {
        for point in profiles(m, state)? {
            let radius = point.point - place(m.eccentricity, 0.0);
            assert!((radius.norm() - m.disc).abs() < 1e-15 && (radius / m.disc - point.normal).norm() < 1e-13);
            assert!((point.radius_of_curvature() - m.disc).abs() < 1e-12);
        }
    }
    Ok(())
}

/// Angles between the paths of the points of contact and the normals (rad).
fn pressure_angles(m: &Followers, state: &State) -> Result<[f64; 3], CamError> {
    let ([knife, roller, face], cam) = (profiles(m, state)?, state.cam());
    let across = |angle: f64| place(angle.sin(), -angle.cos());
    let path = |direction: Place| CurvePoint::direction(&cam, direction);
    let (arm, paddle) = (state.arm().angle, state.paddle().angle);
    let paths = [place(0.0, 1.0), across(arm), across(paddle)].map(path);
    Ok([knife.pressure_angle(paths[0]), roller.pressure_angle(paths[1]), face.pressure_angle(paths[2])])
}

fn assert_pressure_angles(m: &Followers, turn: &[State]) -> Result<(), Box<dyn Error>> {
    for state in turn {
        let centre = centre(m, state.cam().angle);
        let [knife, roller, face] = pressure_angles(m, state)?;
        // The normal leans to the left where the knife edge is to the left of the disc's centre.
        assert!((knife.sin() - (centre.x - m.beside) / m.disc).abs() < 1e-13);
        let (rod, away) = (m.disc + m.roller, centre - place(0.075, 0.0));
        let transmission = ((rod.powi(2) + m.lever.powi(2) - away.norm_squared()) / (2.0 * rod * m.lever)).acos();
        assert!((roller.abs() - (FRAC_PI_2 - transmission).abs()).abs() < 1e-13);
        assert!(face.abs() < 1e-13);
    }
    Ok(())
}

fn print(m: &Followers, turn: &[State]) -> Result<(), Box<dyn Error>> {
    println!("cam °   knife mm   arm °   face °   pressure angles °: knife   roller   face");
    for state in turn.iter().step_by(30) {
        let [knife, roller, face] = pressure_angles(m, state)?.map(f64::to_degrees);
        let (height, arm, paddle) = (state.knife().position.y * 1e3, state.arm().angle.to_degrees(), state.paddle().angle.to_degrees());
        println!(
            "{:5.0}   {height:8.3}   {arm:5.1}   {paddle:6.2}   {knife:25.2}   {roller:6.2}   {:4.1}",
            state.cam().angle.to_degrees(),
            face.abs()
        );
    }
    Ok(())
}
