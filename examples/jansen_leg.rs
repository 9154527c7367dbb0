//! Theo Jansen's leg: eleven bars that convert the rotation of a crank into steps, the leg of his beach animals.
//!
//! ```text
//!          U
//!       b / \ j
//!   W ── V   ──── X crank m at O        triangle V U W   upper leg (b, d, e)
//!    \   │c      /                      triangle C F T   lower leg (g, h, i), T its foot
//!   f \  │   k /                        ground V at (−a, −l)
//!      F─C───
//!      │ /
//!      T
//! ```
//!
//! The lengths are those that Jansen found with a genetic algorithm and calls holy numbers. Every pin is the apex of a triangle on two
//! known pins: five intersections of two circles, without iteration. The foot is checked against these.
//!
//! Source: T. Jansen, The Great Pretender, 2007; lengths in mm here.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::picture::Drawable;
use reuleaux_examples::{Place, apex, largest_difference, place, polar, show, steps};

mechanism! {
    /// One leg, walking to the left.
    #[picture]
    pub mechanism Leg {
        param speed: AngularVelocity = -60rpm;
        param a: Length = 38mm;
        param b: Length = 41.5mm;
        param c: Length = 39.3mm;
        param d: Length = 40.1mm;
        param e: Length = 55.8mm;
        param f: Length = 39.4mm;
        param g: Length = 36.7mm;
        param h: Length = 65.7mm;
        param i: Length = 49mm;
        param j: Length = 50mm;
        param k: Length = 61.9mm;
        param l: Length = 7.8mm;
        param m: Length = 15mm;

        // Position of W relative to the bar V U, and of T relative to F C.
        let upper_x = (b^2 + d^2 - e^2) / (2 * b);
        let lower_x = (g^2 + h^2 - i^2) / (2 * g);

        ground {
            point O = (0mm, 0mm);
            point V = (-a, -l);
        }
        body crank { point O = (0mm, 0mm);  point X = (m, 0mm); }
        body bar_j { point X = (0mm, 0mm);  point U = (j, 0mm);  start angle = 141deg; }
        body bar_k { point X = (0mm, 0mm);  point C = (k, 0mm);  start angle = -133deg; }
        body bar_c { point V = (0mm, 0mm);  point C = (c, 0mm);  start angle = -74deg; }
        body bar_f { point W = (0mm, 0mm);  point F = (f, 0mm);  start angle = -66deg; }
        body upper { point V = (0mm, 0mm);  point U = (b, 0mm);  point W = (upper_x, sqrt(d^2 - upper_x^2));  start angle = 70deg; }
        body lower { point F = (0mm, 0mm);  point C = (g, 0mm);  point T = (lower_x, -sqrt(h^2 - lower_x^2));  start angle = -28deg; }

        joint o = revolute(ground.O, crank.O);
        joint xj = revolute(crank.X, bar_j.X);
        joint xk = revolute(crank.X, bar_k.X);
        joint u = revolute(bar_j.U, upper.U);
        joint vb = revolute(ground.V, upper.V);
        joint vc = revolute(ground.V, bar_c.V);
        joint ck = revolute(bar_k.C, bar_c.C);
        joint w = revolute(upper.W, bar_f.W);
        joint ff = revolute(bar_f.F, lower.F);
        joint cg = revolute(bar_c.C, lower.C);
        drive motor = drive_angle(crank, speed * t);

        output O = ground.O;
        output V = ground.V;
        output X = crank.X;
        output U = upper.U;
        output W = upper.W;
        output C = bar_c.C;
        output F = lower.F;
        output foot = lower.T;
    }
}

type State = LegState<f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let leg = Leg::default();
    let turn: Vec<State> = leg.sweep(steps(0.0, 1.0, 180)).collect::<Result<_, _>>()?;

    assert_triangles(&leg, &turn);
    print_step(&leg, &turn);
    print(&leg, &turn);
    let view = leg
        .view(turn)
        .title("Theo Jansen's leg")
        .over("crank, clockwise", "°", |state| -state.crank().angle.to_degrees())
        .trace("path of the foot", |state| leg.foot(state).value)
        .plot("height of the foot", "mm", |state| leg.foot(state).value.y * 1e3)
        .against("triangles", |state| foot(&leg, state.crank().angle).y * 1e3)
        .plot("velocity to the right", "m/s", |state| leg.foot(state).rate.x)
        .and("upwards", |state| leg.foot(state).rate.y);
    show("jansen_leg", &view, 20, &[60, 90, 110])
}

/// Position of the foot by five triangles, for this crank angle (rad).
fn foot(n: &Leg, crank: f64) -> Place {
    let (v, x) = (place(-n.a, -n.l), polar(n.m, crank));
    let u = apex(v, x, n.b, n.j);
    let w = apex(v, u, n.d, n.e);
    let c = apex(x, v, n.k, n.c);
    let f = apex(c, w, n.g, n.f);
    apex(c, f, n.i, n.h)
}

fn assert_triangles(leg: &Leg, turn: &[State]) {
    let error = largest_difference(turn.iter().map(|state| ((leg.foot(state).value - foot(leg, state.crank().angle)).norm(), 0.0)));
    assert!(error < 1e-15, "the foot is {error:e} m off");
}

/// Length and height of a step, and its flatness: for half of the turn the foot stays within a few mm of the ground.
fn print_step(leg: &Leg, turn: &[State]) {
    let places: Vec<Place> = turn.iter().map(|state| leg.foot(state).value).collect();
    let range = |of: fn(&Place) -> f64| {
        let values = places.iter().map(of);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (ground, top)) = (range(|p| p.x), range(|p| p.y));
    let down = places.iter().filter(|p| p.y - ground < 0.003).count();
    println!(
        "step {:.1} mm long, {:.1} mm high; within 3 mm of the ground for {} % of the turn\n",
        (right - left) * 1e3,
        (top - ground) * 1e3,
        down * 100 / 181
    );
    assert!(down > 81);
}

fn print(leg: &Leg, turn: &[State]) {
    println!("crank °   foot x mm   foot y mm   velocity mm/s");
    for state in turn.iter().step_by(15) {
        let foot = leg.foot(state);
        let (x, y) = (foot.value.x * 1e3, foot.value.y * 1e3);
        println!("{:7.1}   {x:9.3}   {y:9.3}   ({:.1}, {:.1})", state.crank().angle.to_degrees(), foot.rate.x * 1e3, foot.rate.y * 1e3);
    }
}
