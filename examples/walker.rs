//! A beach animal: six of Theo Jansen's legs on one crank, declared once and used six times.
//!
//! ```text
//!        leg[i][0]        leg[i][1]
//!          U ───────╲ ╱─────── U
//!         ╱ ╲        X[i]     ╱ ╲        three pins X on the crank, 120° apart; on each of them a
//!        W ─ V ────╱ ╲────── V ─ W       leg to the left and its mirror image to the right
//!         ╲   C ──╯   ╰── C   ╱
//!          F ╱             ╲ F           V of ground at (∓a, −l)
//!           T               T
//! ```
//!
//! A leg is a component: the points that it hangs on are arguments, its side determines signs, and the length of its shin is a parameter
//! of its own. The feet are checked against five triangles each (see `jansen_leg`), for a walker with one repaired leg.
//!
//! Source: T. Jansen, The Great Pretender, 2007; lengths in mm here.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Place, apex, largest_difference, place, polar, show, steps};

mechanism! {
    /// Three pairs of legs, walking to the left.
    #[allow(far_start)]
    #[picture]
    pub mechanism Walker {
        param speed: AngularVelocity = -60rpm;
        let pairs = 3;
        let a: Length = 38mm;
        let b: Length = 41.5mm;
        let c: Length = 39.3mm;
        let d: Length = 40.1mm;
        let e: Length = 55.8mm;
        let g: Length = 36.7mm;
        let h: Length = 65.7mm;
        let l: Length = 7.8mm;
        let m: Length = 15mm;

        // Position of W relative to the bar V U.
        let upper_x = (b^2 + d^2 - e^2) / (2 * b);

        ground {
            point O = (0mm, 0mm);
            for s in 0..2 { point V[s] = ((2 * s - 1) * a, -l); }
        }
        body crank {
            point O = (0mm, 0mm);
            for i in 0..pairs { point X[i] = (m * cos(120deg * i), m * sin(120deg * i)); }
        }
        joint axle = revolute(ground.O, crank.O);
        drive motor = drive_angle(crank, speed * t);

        for i in 0..pairs {
            for s in 0..2 { part leg[i][s] = Leg(ground.V[s], crank.X[i], 1 - 2 * s); }
        }

        /// A leg to the left, for `side` = 1, or to the right, for −1.
        component Leg(V: Point, X: Point, side: Number) {
            /// From C to the foot.
            param shin: Length = 49mm;
            let lower_x = (g^2 + h^2 - shin^2) / (2 * g);

            body bar_j { point X = (0mm, 0mm);  point U = (50mm, 0mm);  start angle = 90deg + side * 51deg; }
            body bar_k { point X = (0mm, 0mm);  point C = (61.9mm, 0mm);  start angle = -90deg - side * 43deg; }
            body bar_c { point V = (0mm, 0mm);  point C = (c, 0mm);  start angle = -90deg + side * 16deg; }
            body bar_f { point W = (0mm, 0mm);  point F = (39.4mm, 0mm);  start angle = -90deg + side * 24deg; }
            body upper {
                point V = (0mm, 0mm);
                point U = (b, 0mm);
                point W = (upper_x, side * sqrt(d^2 - upper_x^2));
                start angle = 90deg - side * 20deg;
            }
            body lower {
                point F = (0mm, 0mm);
                point C = (g, 0mm);
                point T = (lower_x, -side * sqrt(h^2 - lower_x^2));
                start angle = -90deg + side * 62deg;
            }

            joint xj = revolute(X, bar_j.X);
            joint xk = revolute(X, bar_k.X);
            joint u = revolute(bar_j.U, upper.U);
            joint vb = revolute(V, upper.V);
            joint vc = revolute(V, bar_c.V);
            joint ck = revolute(bar_k.C, bar_c.C);
            joint w = revolute(upper.W, bar_f.W);
            joint ff = revolute(bar_f.F, lower.F);
            joint cg = revolute(bar_c.C, lower.C);

            output X = bar_j.X;
            output U = upper.U;
            output W = upper.W;
            output C = bar_c.C;
            output F = lower.F;
            slice output foot = lower.T;
        }
    }
}

type State = WalkerState<f64>;

/// The feet of a state (m), pair by pair, left and right.
type Feet = [[Place; 2]; 3];

fn main() -> Result<(), Box<dyn Error>> {
    let mut walker = Walker::default();
    // One leg was repaired with a shorter shin.
    walker.leg[1][0].shin = 0.0485;
    let turn: Vec<State> = walker.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_triangles(&walker, &turn);
    assert_in_step(&Walker::default())?;
    assert_feet_alone(&walker, &turn)?;
    print_plan();
    print_gait(&walker, &turn);
    let view = walker
        .view(turn)
        .title("A walker of six legs")
        .over("crank, clockwise", "°", |state| -state.crank().angle.to_degrees())
        .trace("path of a left foot", |state| feet(&walker, state)[0][0])
        .trace("path of a right foot", |state| feet(&walker, state)[0][1])
        .plot("left foot of the first pair", "mm", |state| feet(&walker, state)[0][0].y * 1e3)
        .and("of the second", |state| feet(&walker, state)[1][0].y * 1e3)
        .and("of the third", |state| feet(&walker, state)[2][0].y * 1e3)
        .against("triangles", |state| triangles(&walker, state.crank().angle)[0][0].y * 1e3)
        .plot("axle over the lowest foot", "mm", |state| -lowest(feet(&walker, state)) * 1e3);
    show("walker", &view, 20, &[])
}

/// The slice of the feet gives the same motion, from the same blocks.
fn assert_feet_alone(walker: &Walker, turn: &[State]) -> Result<(), Box<dyn Error>> {
    let alone = walker.solve_for_leg_foot();
    for (state, whole) in alone.sweep(turn.iter().map(|state| state.t)).zip(turn) {
        let (alone, whole) = (state?.output(), walker.leg_foot(whole));
        for (alone, whole) in alone.into_iter().flatten().zip(whole.into_iter().flatten()) {
            assert!((alone.value - whole.value).amax() <= 1e-15, "{alone:?} is not {whole:?}");
        }
    }
    Ok(())
}

/// The plan of the walker: six legs of three loops, listed by shape.
fn print_plan() {
    let (plan, feet) = (Walker::<f64>::PLAN, WalkerForLegFoot::<f64>::PLAN);
    assert_eq!((plan.blocks().count(), feet.blocks().count()), (18, 18));
    println!("{} loops of {} shapes; the feet alone need {}", plan.blocks().count(), plan.shapes(), feet.blocks().count());
}

fn feet(walker: &Walker, state: &State) -> Feet {
    walker.leg_foot(state).map(|pair| pair.map(|foot| foot.value))
}

/// Foot of a leg to the left by five triangles, for this angle of its pin (rad) and this shin (m).
fn left_foot(pin: f64, shin: f64) -> Place {
    let (v, x) = (place(-0.038, -0.0078), polar(0.015, pin));
    let u = apex(v, x, 0.0415, 0.05);
    let w = apex(v, u, 0.0401, 0.0558);
    let c = apex(x, v, 0.0619, 0.0393);
    let f = apex(c, w, 0.0367, 0.0394);
    apex(c, f, shin, 0.0657)
}

/// All feet by triangles. In a mirror, a leg to the right is a leg to the left with its pin at π − φ.
fn triangles(walker: &Walker, crank: f64) -> Feet {
    let mut feet = [[place(0.0, 0.0); 2]; 3];
    for (i, pair) in feet.iter_mut().enumerate() {
        let pin = crank + i as f64 * TAU / 3.0;
        let mirrored = left_foot(PI - pin, walker.leg[i][1].shin);
        *pair = [left_foot(pin, walker.leg[i][0].shin), place(-mirrored.x, mirrored.y)];
    }
    feet
}

fn assert_triangles(walker: &Walker, turn: &[State]) {
    let pairs = |state: &State| {
        let (found, known) = (feet(walker, state), triangles(walker, state.crank().angle));
        found.into_iter().flatten().zip(known.into_iter().flatten()).map(|(one, two)| ((one - two).norm(), 0.0)).collect::<Vec<_>>()
    };
    let error = largest_difference(turn.iter().flat_map(pairs));
    assert!(error < 1e-15, "a foot is {error:e} m off");
}

/// A third of a turn later, every leg is where the next one was.
fn assert_in_step(walker: &Walker) -> Result<(), Box<dyn Error>> {
    let (now, later) = (walker.solve(0.1)?, walker.solve(0.1 + 1.0 / 3.0)?);
    for side in 0..2 {
        for pair in 0..3 {
            let (next, foot) = (feet(walker, &now)[(pair + 2) % 3][side], feet(walker, &later)[pair][side]);
            assert!((next - foot).norm() < 1e-14, "{next} is not {foot}");
        }
    }
    Ok(())
}

/// The height of the lowest foot (m), on which the walker stands.
fn lowest(feet: Feet) -> f64 {
    feet.into_iter().flatten().map(|foot| foot.y).fold(f64::INFINITY, f64::min)
}

fn print_gait(walker: &Walker, turn: &[State]) {
    println!("crank °   height of each foot over the lowest one, mm");
    for state in turn.iter().step_by(15) {
        let feet = feet(walker, state);
        let heights: Vec<String> = feet.iter().flatten().map(|foot| format!("{:7.2}", (foot.y - lowest(feet)) * 1e3)).collect();
        println!("{:7.1} {}", state.crank().angle.to_degrees(), heights.join(" "));
    }
    let axle: Vec<f64> = turn.iter().map(|state| -lowest(feet(walker, state)) * 1e3).collect();
    let (low, high) = axle.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), height| (low.min(*height), high.max(*height)));
    println!("\nthe axle goes {low:.2} to {high:.2} mm above the ground\n");
    assert!(high - low < 0.3, "the walker sways by {} mm", high - low);
}
