//! A car with a trailer: its wheels do not slide sideways.
//!
//! ```text
//! ω = v tan δ / l                                rate of the car       v: speed, δ: steering angle, l: wheelbase
//! α̇ = ω − (v / d) sin α                          angle of the hitch    d: drawbar
//! u = tan(α/2),  (u − u₋)/(u − u₊) = c e^(−s t)  u± = (v/d ± s)/ω,  s² = (v/d)² − ω²
//! ```
//!
//! Each axle is an equation between velocities, from which no position follows: where the car stands depends on its way. Speed and steering
//! are driven, so that velocities are determined, and positions are integrated. Straight ahead, the trailer's axle follows a tractrix. In
//! reverse the same equation folds the trailer.
//!
//! Source: R. M. Murray and S. S. Sastry, Nonholonomic motion planning, IEEE Transactions on Automatic Control 38, 1993.

use std::error::Error;

use reuleaux::picture::Drawable;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{Abscissa, Diagram, Ink, Place, Plate, Scene, place, rectangle, show, steps};

mechanism! {
    /// Three axles: two of the car, of which the front one is steered, and one of the trailer.
    #[integrated]
    #[picture]
    pub mechanism Trailer {
        param wheelbase: Length = 2.7m;
        param drawbar: Length = 4m;
        param speed: Velocity = 2m_s;
        param steering: Angle = 20deg;
        /// Angle of the hitch at the start.
        param fold: Angle = 0deg;

        body car     { point front = (wheelbase, 0m);  axis ahead = (1, 0); }
        body wheel   { axis ahead = (1, 0); }
        body trailer { point hitch = (drawbar, 0m);  axis ahead = (1, 0);  start angle = -fold; }
        joint pivot = revolute(car.front, wheel.position);
        joint hitch = revolute(car.position, trailer.hitch);
        joint rear_axle = { cross(car.ahead, rate(car.position)) == 0m_s; }
        joint front_axle = { cross(wheel.ahead, rate(wheel.position)) == 0m_s; }
        joint trailer_axle = { cross(trailer.ahead, rate(trailer.position)) == 0m_s; }
        drive motor = { dot(car.ahead, rate(car.position)) == speed; }
        drive wheel_angle = drive_relative_angle(car, wheel, steering);

        output angle = car.angle - trailer.angle;
    }
}

type State = TrailerState<f64>;

/// The angle of the hitch at a time, in rad.
fn angle(m: &Trailer, t: f64) -> f64 {
    let (omega, rate) = (m.speed * m.steering.tan() / m.wheelbase, m.speed / m.drawbar);
    let start = (0.5 * m.fold).tan();
    if omega == 0.0 {
        return 2.0 * (start * (-rate * t).exp()).atan();
    }
    let s = (rate * rate - omega * omega).sqrt();
    let [plus, minus] = [(rate + s) / omega, (rate - s) / omega];
    let share = (start - minus) / (start - plus) * (-s * t).exp();
    2.0 * ((minus - plus * share) / (1.0 - share)).atan()
}

fn drive(m: &Trailer, duration: f64) -> Result<Vec<State>, Box<dyn Error>> {
    let states = m.sweep(steps(0.0, duration, 200), Integrator::new(1e-11)).collect::<Result<Vec<State>, _>>();
    Ok(states.map_err(|stopped| stopped.to_string())?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let straight = Trailer { steering: 0.0, fold: 60_f64.to_radians(), ..Trailer::default() };
    let curve = Trailer::default();
    let back = Trailer { speed: -1.0, steering: -0.05, fold: 0.02, ..Trailer::default() };
    println!("                      hitch at the end °   off by rad");
    for (name, m, duration) in [("straight, a tractrix", &straight, 8.0), ("a curve", &curve, 20.0), ("in reverse", &back, 12.0)] {
        let states = drive(m, duration)?;
        let off = states.iter().map(|state| (m.angle(state).value - angle(m, state.t)).abs()).fold(0.0, f64::max);
        println!("{name:20}  {:18.3}   {off:.1e}", m.angle(&states[states.len() - 1]).value.to_degrees());
        assert!(off < 1e-9, "{name}: {off:e} rad");
    }
    let way = drive(&curve, 20.0)?;
    // The car's rear axle goes round a circle about the point on its line at l / tan δ.
    let radius = curve.wheelbase / curve.steering.tan();
    let off = way.iter().map(|state| ((state.car().position - place(0.0, radius)).norm() - radius).abs()).fold(0.0, f64::max);
    assert!(off < 1e-9, "{off:e} m");
    println!("{}", picture(&curve, &way).save("trailer")?.display());
    let view = curve
        .view(way)
        .outline("car", rectangle(place(1.3, 0.0), 0.0, 3.8, 1.2))
        .outline("wheel", rectangle(place(0.0, 0.0), 0.0, 0.7, 0.25))
        .outline("trailer", rectangle(place(0.6, 0.0), 0.0, 3.6, 1.2))
        .trace("rear axle of the car", |state| state.car().position)
        .trace("axle of the trailer", |state| state.trailer().position)
        .plot("hitch", "°", |state| curve.angle(state).value.to_degrees())
        .and("closed form", |state| angle(&curve, state.t).to_degrees());
    show("trailer", &view)?;
    Ok(())
}

fn picture(m: &Trailer, way: &[State]) -> Plate {
    let mut scene = Scene::new();
    let path = |of: fn(&State) -> Place| way.iter().map(of).collect::<Vec<Place>>();
    scene.line(Ink::Input, path(|state| state.car().position));
    scene.line(Ink::Trace, path(|state| state.trailer().position));
    for state in way.iter().step_by(40) {
        scene.faint(|scene| draw(scene, m, state));
    }
    draw(&mut scene, m, &way[20]);
    let over = |of: fn(&Trailer, &State) -> f64| way.iter().map(move |state| (state.t, of(m, state)));
    let exact = way.iter().step_by(10).map(|state| (state.t, angle(m, state.t).to_degrees()));
    Plate::new("A car with a trailer", scene, Abscissa { name: "time in s", range: 0.0..20.0, step: 5.0 })
        .diagram(
            Diagram::new("hitch in °")
                .curve(Ink::Output, "reuleaux", over(|m, state| m.angle(state).value.to_degrees()))
                .circles("closed form", exact),
        )
        .diagram(Diagram::new("rate in rad/s").curve(Ink::Output, "", over(|m, state| m.angle(state).rate)))
}

fn draw(scene: &mut Scene, m: &Trailer, state: &State) {
    let at = |x: f64, y: f64, angle: f64, from: Place| from + place(x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos());
    let (car, wheel, trailer) = (state.car(), state.wheel(), state.trailer());
    for (body, angle) in [(car.position, car.angle), (wheel.position, wheel.angle), (trailer.position, trailer.angle)] {
        for side in [-0.75, 0.75] {
            // Both front wheels are drawn parallel.
            let hub = if body == wheel.position { at(0.0, side, car.angle, body) } else { at(0.0, side, angle, body) };
            scene.link(Ink::Second, &[at(-0.3, 0.0, angle, hub), at(0.3, 0.0, angle, hub)]);
        }
    }
    let outline = |from: f64, to: f64, body: Place, angle: f64| {
        [[from, -0.6], [to, -0.6], [to, 0.6], [from, 0.6]].map(|[x, y]| at(x, y, angle, body))
    };
    scene.surface(Ink::Output, outline(-1.2, 0.6 * m.drawbar, trailer.position, trailer.angle));
    scene.surface(Ink::Input, outline(-0.6, m.wheelbase + 0.5, car.position, car.angle));
    scene.link(Ink::Output, &[at(0.6 * m.drawbar, 0.0, trailer.angle, trailer.position), car.position]).pin(car.position);
}
