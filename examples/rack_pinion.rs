//! A windscreen wiper: a crank moves a rack to and fro, and the rack turns the wiper's pinion.
//!
//! ```text
//!                         \ wiper
//!       A                  (o) pinion, radius R
//! crank(o)──rod──[B]▔▔▔▔▔▔▔▔▔▔▔▔ rack     OA = r, AB = l
//!   (o)═══════════════════════════════
//!    O
//! ```
//!
//! The rack travels 2 r, so the wiper swings through 2 r/R. Its angle is checked against (l − x)/R with the slider-crank's
//! x = r cos φ + √(l² − r² sin² φ); at their contact, pinion and rack have the same velocity.
//!
//! Source: E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 3.4, for the row.

use std::error::Error;
use std::f64::consts::PI;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Abscissa, Diagram, Ink, Place, Plate, Scene, gear, largest_difference, place, show, steps};

mechanism! {
    /// A wiper that is upright in the middle of the stroke.
    #[picture]
    pub mechanism Wiper {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 25mm;
        param rod_length: Length = 90mm;
        /// Pitch radius of the pinion.
        param radius: Length = 25mm;

        ground {
            point O = (0mm, 0mm);
            point D = (rod_length + 80mm, radius);
            axis way = (1, 0);
        }
        body crank { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body rod   { point A = (0mm, 0mm);  point B = (rod_length, 0mm);  start angle = 0deg; }
        body rack  { point B = (0mm, 0mm); }
        body wiper { point D = (0mm, 0mm);  point W = (0mm, 130mm); }

        joint main = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, rack.B);
        joint way = translational(ground.way, ground.O, rack.B);
        joint d = revolute(ground.D, wiper.D);
        joint teeth = rack_pinion(wiper, rack.B, ground.way, ground.O, radius, c: rod_length);
        drive motor = drive_angle(crank, speed * t);

        output O = ground.O;
        output A = crank.A;
        output B = rack.B;
        output D = wiper.D;
        output W = wiper.W;
    }
}

type State = WiperState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Wiper::default();
    let turn: Vec<State> = mechanism.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_swing(&mechanism, &turn)?;
    assert_rolling(&mechanism, &turn);
    print(&turn);
    println!("{}", picture(&mechanism, &turn).save("rack_pinion")?.display());
    let view = mechanism
        .view(turn)
        .trace("path of W", |state| mechanism.W(state).value)
        .plot("wiper", "°", |state| state.wiper().angle.to_degrees())
        .and("closed form", |state| closed_form(&mechanism, state.crank().angle).to_degrees())
        .plot("velocity", "rad/s", |state| state.wiper().angular_velocity);
    show("rack_pinion", &view)?;
    Ok(())
}

/// The wiper's angle (rad) at the crank's angle φ (rad).
fn closed_form(m: &Wiper, crank: f64) -> f64 {
    let (sin, cos) = crank.sin_cos();
    let travel = m.crank_length * cos + (m.rod_length.powi(2) - (m.crank_length * sin).powi(2)).sqrt();
    (m.rod_length - travel) / m.radius
}

fn assert_swing(m: &Wiper, turn: &[State]) -> Result<(), Box<dyn Error>> {
    let error = largest_difference(turn.iter().map(|state| (state.wiper().angle, closed_form(m, state.crank().angle))));
    assert!(error < 1e-14, "the wiper is {error:e} rad off");
    let [right, left] = [m.solve(0.0)?, m.solve(PI / m.speed)?].map(|state| state.wiper());
    let swing = left.angle - right.angle;
    assert!((swing - 2.0 * m.crank_length / m.radius).abs() < 1e-14);
    println!("swings through {:.2}°\n", swing.to_degrees());
    Ok(())
}

fn assert_rolling(m: &Wiper, turn: &[State]) {
    let velocities = |state: &State| (state.wiper().angular_velocity * m.radius, -m.B(state).rate.x);
    assert!(largest_difference(turn.iter().map(velocities)) < 1e-15);
}

fn print(turn: &[State]) {
    println!("crank °   rack mm   wiper °   wiper rad/s   wiper rad/s²");
    for state in turn.iter().step_by(15) {
        let (crank, rack, wiper) = (state.crank(), state.rack(), state.wiper());
        println!(
            "{:7.1}   {:7.3}   {:7.3}   {:11.4}   {:12.3}",
            crank.angle.to_degrees(),
            rack.position.x * 1e3,
            wiper.angle.to_degrees(),
            wiper.angular_velocity,
            wiper.angular_acceleration
        );
    }
}

fn picture(m: &Wiper, turn: &[State]) -> Plate {
    let mut scene = Scene::new();
    scene.wall(place(0.075, -0.014), place(0.28, -0.014));
    for state in turn.iter().step_by(15).take(7) {
        scene.faint(|scene| {
            scene.line(Ink::Output, [m.D(state).value, m.W(state).value]);
        });
    }
    let shown = &turn[22];
    draw(&mut scene, m, shown);
    scene.line(Ink::Trace, turn.iter().take(91).map(|state| m.W(state).value));
    let [o, a, b, d, w] = [m.O(shown), m.A(shown), m.B(shown), m.D(shown), m.W(shown)].map(|point| point.value);
    scene.name(o, "O", [-16.0, 2.0]).name(a, "A", [0.0, 17.0]).name(b, "B", [0.0, 17.0]).name(d, "D", [22.0, 8.0]).name(
        w,
        "W",
        [14.0, 8.0],
    );

    let crank = |state: &State| state.crank().angle.to_degrees();
    let over = |of: fn(&State) -> f64| turn.iter().map(move |state| (crank(state), of(state)));
    let exact = turn.iter().step_by(9).map(|state| (crank(state), closed_form(m, state.crank().angle).to_degrees()));
    Plate::new("Rack and pinion of a wiper", scene, Abscissa { name: "crank angle in °", range: 0.0..360.0, step: 60.0 })
        .diagram(
            Diagram::new("wiper in °")
                .curve(Ink::Output, "reuleaux", over(|state| state.wiper().angle.to_degrees()))
                .circles("closed form", exact),
        )
        .diagram(Diagram::new("velocity in rad/s").curve(Ink::Output, "", over(|state| state.wiper().angular_velocity)))
        .diagram(Diagram::new("acceleration in rad/s²").curve(Ink::Output, "", over(|state| state.wiper().angular_acceleration)))
}

fn draw(scene: &mut Scene, m: &Wiper, state: &State) {
    let [o, a, b, d, w] = [m.O(state), m.A(state), m.B(state), m.D(state), m.W(state)].map(|point| point.value);
    let module = 2.0 * m.radius / 20.0;
    scene.surface(Ink::Coupler, rack(b, module));
    scene.link(Ink::Output, &[d, w]);
    // With the wiper upright, the rack's pin is 80 mm before the pinion; there the rack has a tooth and the pinion a space.
    let below = -PI / 2.0 + PI / 20.0 - (0.08 - 0.02) / m.radius;
    scene.surface(Ink::Output, gear(d, 20, module, state.wiper().angle + below));
    scene.link(Ink::Second, &[a, b]).link(Ink::Input, &[o, a]);
    scene.pin(a).pin(b).pin(w).pivot(o).pin(d);
}

/// Outline of a rack with its pitch line through `pin` and its first tooth 20 mm behind it.
fn rack(pin: Place, module: f64) -> Vec<Place> {
    let pitch = PI * module;
    let lean = 20_f64.to_radians().tan() * module;
    let tooth = |k: i32| {
        let (middle, half) = (0.02 + f64::from(k) * pitch, pitch / 4.0);
        let (foot, tip) = (half + 1.2 * lean, half - lean);
        [(middle - foot, -1.2), (middle - tip, 1.0), (middle + tip, 1.0), (middle + foot, -1.2)].map(|(x, y)| place(x, y * module))
    };
    let (teeth, [low, right]) = ((0..16).flat_map(tooth), [-0.012, 0.02 + 15.6 * pitch]);
    let bar = [place(right, low), place(-0.012, low), place(-0.012, 0.0)];
    teeth.chain(bar).map(|corner| pin + corner).collect()
}
