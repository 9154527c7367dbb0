//! A front loader with Z-bar linkage: one cylinder lifts the boom, another tilts the bucket through a bellcrank.
//!
//! ```text
//!   T ═════tilt═════ S                P, T, L chassis    P M K Q boom
//!                   (o) bellcrank     S K R bellcrank    R B link
//!   P ────boom──M── K ───────── Q     Q B E bucket, E its edge
//!          lift //  R ──link── B ▔▔▔E
//!   L ═════════
//! ```
//!
//! A cylinder is a distance that follows a law of time: `drive_distance`. Both laws together dig, lift and dump. Every pin is checked
//! against triangles: of a cylinder and the boom, of a cylinder and the bellcrank, and of pairs of links.
//!
//! Source of the lengths: a loader of common size. For one position the edge was also computed with 60 digits.

use std::error::Error;

use reuleaux::mechanism;
use reuleaux::picture::{Drawable, GROUND};
use reuleaux_examples::{Place, apex, carried, largest_difference, place, round, show, steps};

mechanism! {
    /// A loader with two cylinders and two freedoms.
    #[picture]
    pub mechanism Loader {
        /// Length of the lift cylinder with the bucket on the ground.
        param lift: Length = 0.95m;
        param lift_stroke: Length = 0.70m;
        /// Length of the tilt cylinder with the bucket ready to dig.
        param tilt: Length = 1.34m;
        param curl_stroke: Length = 0.21m;
        param level_stroke: Length = 0.27m;
        param dump_stroke: Length = 0.48m;
        param link_length: Length = 0.92m;

        let lift_length = lift + lift_stroke * polynomial_345((t - 2s) / 4s);
        let tilt_length = tilt + curl_stroke * polynomial_345(t / 2s)
            - level_stroke * polynomial_345((t - 2s) / 4s) - dump_stroke * polynomial_345((t - 6.5s) / 2s);

        ground {
            point P = (0m, 0m);
            point L = (0.10m, -0.90m);
            point T = (0.35m, 0.25m);
        }
        body boom {
            point P = (0m, 0m);
            point M = (1.20m, -0.15m);
            point K = (1.50m, 0.20m);
            point Q = (2.60m, -0.30m);
            start angle = -25deg;
        }
        body bellcrank { point K = (0m, 0m);  point S = (0m, 0.55m);  point R = (0.05m, -0.50m);  start angle = -25deg; }
        body link      { point R = (0m, 0m);  point B = (link_length, 0m);  start angle = -20deg; }
        body bucket    { point Q = (0m, 0m);  point B = (-0.10m, 0.40m);  point E = (1.0m, -0.10m);  start angle = -10deg; }

        joint p = revolute(ground.P, boom.P);
        joint k = revolute(boom.K, bellcrank.K);
        joint r = revolute(bellcrank.R, link.R);
        joint b = revolute(link.B, bucket.B);
        joint q = revolute(boom.Q, bucket.Q);
        drive lifting = drive_distance(ground.L, boom.M, lift_length);
        drive tilting = drive_distance(ground.T, bellcrank.S, tilt_length);

        output lift_cylinder = lift_length;
        output tilt_cylinder = tilt_length;
        output P = ground.P;
        output L = ground.L;
        output T = ground.T;
        output M = boom.M;
        output K = boom.K;
        output Q = boom.Q;
        output S = bellcrank.S;
        output R = bellcrank.R;
        output B = bucket.B;
        output edge = bucket.E;
    }
}

type State = LoaderState<f64>;

/// Outlines of the chassis in ground and of the bucket in its frame (m).
const CHASSIS: [[f64; 2]; 6] = [[-1.2, -0.9], [-1.2, 0.15], [-0.1, 0.15], [0.2, 0.4], [0.5, 0.4], [0.3, -1.05]];
const BUCKET: [[f64; 2]; 5] = [[1.0, -0.1], [0.05, -0.2], [-0.2, -0.02], [-0.22, 0.5], [0.12, 0.72]];

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = Loader::default();
    let cycle: Vec<State> = mechanism.sweep(steps(0.0, 9.0, 180)).collect::<Result<_, _>>()?;

    assert_triangles(&mechanism, &cycle);
    assert_reference()?;
    print(&mechanism, &cycle);
    let view = mechanism
        .view(cycle)
        .title("Hydraulic loader")
        .outline(GROUND, CHASSIS.map(|[x, y]| place(x, y)))
        .outline(GROUND, round(0.6).iter().map(|at| place(-0.55, -1.15) + at))
        .outline("bucket", BUCKET.map(|[x, y]| place(x, y)))
        .trace("path of the edge", |state| mechanism.edge(state).value)
        .plot("lift cylinder", "m", |state| mechanism.lift_cylinder(state).value)
        .and("tilt cylinder", |state| mechanism.tilt_cylinder(state).value)
        .plot("boom", "°", |state| state.boom().angle.to_degrees())
        .and("bucket", |state| state.bucket().angle.to_degrees())
        .plot("speed of the edge", "m/s", |state| mechanism.edge(state).rate.norm());
    show("hydraulic_loader", &view, 0, &[82, 180])
}

/// Position of the bucket's edge by triangles alone, for these lengths of the cylinders (m).
fn edge(m: &Loader, lift: f64, tilt: f64) -> Place {
    let [p, l, t] = [place(0.0, 0.0), place(0.1, -0.9), place(0.35, 0.25)];
    let arm = place(1.2, -0.15);
    let on_boom = |local| carried(local, p, arm, apex(p, l, arm.norm(), lift));
    let (k, q) = (on_boom(place(1.5, 0.2)), on_boom(place(2.6, -0.3)));
    let s = apex(t, k, tilt, 0.55);
    let r = carried(place(0.05, -0.5), k, place(0.0, 0.55), s);
    let arm = place(-0.1, 0.4);
    let b = apex(r, q, m.link_length, arm.norm());
    carried(place(1.0, -0.1), q, arm, b)
}

fn assert_triangles(m: &Loader, cycle: &[State]) {
    for state in cycle {
        let (lift, tilt, solved) = (m.lift_cylinder(state).value, m.tilt_cylinder(state).value, m.edge(state).value);
        let error = (solved - edge(m, lift, tilt)).norm();
        assert!(error < 1e-13, "the edge is {error:e} m off at {} s", state.t);
    }
}

/// A longer link and other cylinder lengths: the edge's position to 16 digits.
fn assert_reference() -> Result<(), Box<dyn Error>> {
    let (lift, tilt) = (1.55 + 0.3 * (-1.0_f64).sin(), 1.35 + 0.12 * 0.5_f64.sin());
    let mechanism = Loader { lift, tilt, link_length: 1.05, ..Default::default() };
    let edge = mechanism.edge(&mechanism.solve(0.0)?).value;
    assert!(largest_difference([(edge.x, 3.57717751666374), (edge.y, -0.2479223612569844)]) < 1e-14);
    Ok(())
}

fn print(m: &Loader, cycle: &[State]) {
    println!("time s   lift mm   tilt mm   boom °   bucket °   edge m");
    for state in cycle.iter().step_by(10) {
        let (boom, bucket, edge) = (state.boom().angle.to_degrees(), state.bucket().angle.to_degrees(), m.edge(state).value);
        let [lift, tilt] = [m.lift_cylinder(state), m.tilt_cylinder(state)].map(|length| length.value * 1e3);
        println!("{:6.1}   {lift:7.1}   {tilt:7.1}   {boom:6.2}   {bucket:8.2}   ({:.3}, {:.3})", state.t, edge.x, edge.y);
    }
}
