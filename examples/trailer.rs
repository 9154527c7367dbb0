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
use reuleaux_examples::{place, rectangle, show, steps};

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
    let view = curve
        .view(way)
        .title("A car with a trailer")
        .outline("car", rectangle(place(1.3, 0.0), 0.0, 3.8, 1.2))
        .outline("wheel", rectangle(place(0.0, 0.0), 0.0, 0.7, 0.25))
        .outline("trailer", rectangle(place(0.6, 0.0), 0.0, 3.6, 1.2))
        .outline("trailer", rectangle(place(3.2, 0.0), 0.0, 1.6, 0.1));
    // Wheels beside the axles.
    let view = ["car", "trailer"].into_iter().fold(view, |view, body| {
        view.outline(body, rectangle(place(0.0, 0.75), 0.0, 0.7, 0.2)).outline(body, rectangle(place(0.0, -0.75), 0.0, 0.7, 0.2))
    });
    let view = view
        .trace("rear axle of the car", |state| state.car().position)
        .trace("axle of the trailer", |state| state.trailer().position)
        .plot("hitch", "°", |state| curve.angle(state).value.to_degrees())
        .against("closed form", |state| angle(&curve, state.t).to_degrees())
        .plot("rate of the hitch", "rad/s", |state| curve.angle(state).rate);
    show("trailer", &view, 20, &[60, 100, 140])
}
