//! W2: crank 1, rod 3, slider on y = 0; one turn a second.

use reuleaux::mechanism;
use reuleaux::nalgebra::Vector2;

use super::{TOLERANCES, Workload, declared, generated, name, sketch};
use crate::contender::Entry;
use crate::hand::{Angles, Bar, Closed, Crank, Law, Point, Whole};
use crate::linkage::{Link, Linkage};

mechanism! {
    /// W2: a slider-crank.
    pub mechanism SliderCrank {
        ground { point O = (0m, 0m); axis u = (1, 0); }
        body crank { point O = (0m, 0m); point A = (1m, 0m); }
        body rod { point A = (0m, 0m); point B = (3m, 0m); start angle = 0deg; }
        body slider { point B = (0m, 0m); }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, rod.A);
        joint b = revolute(rod.B, slider.B);
        joint guide = translational(ground.u, ground.O, slider.B);
        drive input = drive_angle(crank, 1turn * t / 1s);
        slice output pin = slider.B;
    }
}
generated!(SliderCrank, SliderCrankState, pin);

const CRANK: Crank = Crank { pivot: [0.0, 0.0], length: 1.0, law: Law::Turning };
const ROD: f64 = 3.0;

pub(crate) fn workload() -> Workload {
    let linkage = Linkage {
        name: "W2 slider-crank",
        points: vec![[0.0, 0.0], [1.0, 0.0], [4.0, 0.0]],
        fixed: 1,
        crank: CRANK,
        crank_ends: [0, 1],
        links: vec![Link::bar(1, 2, ROD)],
        slider: Some(2),
        order: vec![vec![2]],
        tracked: 2,
        size: 4.0,
    };
    Workload { linkage, generated, plan, contenders }
}

fn closed(t: f64) -> Point {
    pushed(&CRANK.pin(t))
}

/// The slider where the rod reaches y = 0.
#[inline]
fn pushed(pin: &Point) -> Point {
    let root = (ROD * ROD - pin.p.y * pin.p.y).sqrt();
    let rate = -pin.p.y * pin.v.y / root;
    let second = -(pin.v.y * pin.v.y + pin.p.y * pin.a.y + rate * rate) / root;
    slider(pin, [root, rate, second])
}

/// The rod's angle with its derivatives, from sine θ = −y/3, and the slider at its end.
fn follow(rod: &mut [f64; 3], pin: &Point, h: f64, tolerance: f64) -> Point {
    let mut angle = rod[0] + h * (rod[1] + 0.5 * h * rod[2]);
    loop {
        let (sine, cosine) = libm::sincos(angle);
        let phi = pin.p.y + ROD * sine;
        if phi.abs() <= tolerance {
            let rate = -pin.v.y / (ROD * cosine);
            let second = (ROD * sine * rate * rate - pin.a.y) / (ROD * cosine);
            *rod = [angle, rate, second];
            return slider(pin, [ROD * cosine, -ROD * sine * rate, -ROD * (sine * second + cosine * rate * rate)]);
        }
        angle -= phi / (ROD * cosine);
    }
}

/// The slider, this far to the right of the crank pin.
fn slider(pin: &Point, [right, rate, second]: [f64; 3]) -> Point {
    Point { p: Vector2::new(pin.p.x + right, 0.0), v: Vector2::new(pin.v.x + rate, 0.0), a: Vector2::new(pin.a.x + second, 0.0) }
}

fn contenders(linkage: &Linkage) -> Vec<Entry> {
    let whole = |t, [crank, rod]: &mut [Bar; 2]| {
        crank.angle = CRANK.angle(t);
        let pin = CRANK.pin_at(crank.angle);
        let end = pushed(&pin);
        rod.follow(&pin, &end);
        end
    };
    let mut entries =
        vec![Entry::new(name::CLOSED, Closed::new(closed)), Entry::new(name::CLOSED_WHOLE, Whole::new([Bar::default(); 2], whole))];
    entries.extend(Entry::each(name::ANGLES, &TOLERANCES, |tolerance| Angles::new(CRANK, [0.0; 3], tolerance, follow)));
    entries.extend(declared!(SliderCrank, SliderCrankState, pin, solve_for_pin, Static));
    entries.extend(sketch(linkage));
    entries
}
