//! The nearest of all assemblies is taken, for loops whose unknowns include positions, or in which several assemblies have the same sign:
//! plates and triangles on bars, compared with all their assemblies from a scan.
//!
//! Two of the bars and the plate form a four-bar, whose first bar is scanned over a whole turn; the third bar selects the angles at which
//! the loop closes.

use crate::Random;
use crate::nearest::{FourBar, Linkage, Point, angle, from, length, link, look, minus, place, rounded, scanned};
use core::f64::consts::PI;

/// A plate with three points on bars of these lengths, pivoted at three feet.
struct Plate {
    feet: [Point; 3],
    points: [Point; 3],
    lengths: [f64; 3],
}

impl Plate {
    /// A random plate that has at least one assembly.
    fn random(random: &mut Random, feet: [Point; 3]) -> Plate {
        let points = [0; 3].map(|_| place(random, 250.0));
        let (at, turned) = (place(random, 250.0), random.between(-PI, PI));
        let lengths = [0, 1, 2].map(|index| rounded(length(minus(from(at, points[index], turned), feet[index]))));
        Plate { feet, points, lengths }
    }

    /// Declaration of its body.
    fn body(&self) -> String {
        let [p, q, r] = self.points.map(|[x, y]| format!("({x}mm, {y}mm)"));
        format!("body plate {{ point P = {p}; point Q = {q}; point R = {r}; /*plate*/ }} ")
    }

    /// Angles of the plate and of its three bars in each assembly.
    fn assemblies(&self) -> Vec<Vec<f64>> {
        let ([p, q, r], [a, b, c]) = (self.points, self.feet);
        let (base, turned) = (minus(q, p), angle(minus(q, p)));
        let bar = FourBar {
            crank: self.lengths[0],
            at: 0.0,
            coupler: length(base),
            rocker: self.lengths[1],
            c: minus(b, a),
            p: from([0.0; 2], minus(r, p), -turned),
        };
        let third = minus(c, a);
        let all = scanned(&bar, &|_, (_, _, r)| length(minus(*r, third)) - self.lengths[2]).into_iter();
        let angles = |(crank, side): (f64, usize)| {
            let (coupler, rocker, r) = bar.closed(crank).1.expect("it closes where it was found")[side];
            vec![coupler - turned, crank, rocker, angle(minus(r, third))]
        };
        all.map(angles).collect()
    }
}

fn random_plate(random: &mut Random) -> Linkage {
    let feet = [0; 3].map(|_| place(random, 400.0));
    let plate = Plate::random(random, feet);
    let mut declaration = plate.body();
    for ((name, [x, y]), length) in ["P", "Q", "R"].into_iter().zip(plate.feet).zip(plate.lengths) {
        declaration += &format!("joint bar_{name} = distance(({x}mm, {y}mm), plate.{name}, {length}mm); ");
    }
    let assemblies = plate.assemblies().into_iter().map(|angles| angles[..1].to_vec()).collect();
    Linkage { declaration, bodies: vec!["plate"], assemblies }
}

/// A driven crank: its declaration, and the position of its end.
fn led(random: &mut Random, name: &str) -> (String, Point) {
    let (pivot, arm, degrees) = (place(random, 400.0), random.between(30.0, 250.0), random.between(-180.0, 180.0));
    let declaration = format!(
        "{} joint pivot_{name} = revolute(({}mm, {}mm), {name}.position); drive motor_{name} = drive_angle({name}, ({degrees}) * 1deg + 1rad_s * t); ",
        link(name, arm),
        pivot[0],
        pivot[1]
    );
    (declaration, from(pivot, [arm, 0.0], degrees.to_radians()))
}

/// A plate on three bars, each on a driven crank.
fn random_platform(random: &mut Random) -> Linkage {
    let cranks = ["one", "two", "three"].map(|name| led(random, name));
    let plate = Plate::random(random, [0, 1, 2].map(|index| cranks[index].1));
    let mut declaration = plate.body();
    let names = [("one", "bar_one", "P"), ("two", "bar_two", "Q"), ("three", "bar_three", "R")];
    for (index, (crank, bar, point)) in names.into_iter().enumerate() {
        declaration += &cranks[index].0;
        declaration += &link(bar, plate.lengths[index]);
        declaration += &format!("joint of_{crank} = revolute({crank}.B, {bar}.position); ");
        declaration += &format!("joint at_{point} = revolute({bar}.B, plate.{point}); ");
    }
    Linkage { declaration, bodies: vec!["plate", "bar_one", "bar_two", "bar_three"], assemblies: plate.assemblies() }
}

/// Two triangles, each with a corner on a driven crank, joined by two bars: an Assur group of the fourth class.
fn random_fourth_class(random: &mut Random) -> Linkage {
    let cranks = ["one", "two"].map(|name| led(random, name));
    let feet = [0, 1].map(|index| cranks[index].1);
    let corners = [0; 2].map(|_| [0; 2].map(|_| place(random, 300.0)));
    let turned = [0; 2].map(|_| random.between(-PI, PI));
    let corner = |triangle: usize, which: usize, turned: f64| from(feet[triangle], corners[triangle][which], turned);
    let bars = [0, 1].map(|which| rounded(length(minus(corner(1, which, turned[1]), corner(0, which, turned[0])))));
    let mut declaration = String::new();
    for (index, (crank, plate)) in [("one", "first"), ("two", "second")].into_iter().enumerate() {
        let [p, q] = corners[index].map(|[x, y]| format!("({x}mm, {y}mm)"));
        declaration += &cranks[index].0;
        declaration += &format!("body {plate} {{ point P = {p}; point Q = {q}; /*{plate}*/ }} ");
        declaration += &format!("joint of_{crank} = revolute({crank}.B, {plate}.position); ");
    }
    for ((bar, point), length) in [("bar_p", "P"), ("bar_q", "Q")].into_iter().zip(bars) {
        declaration += &link(bar, length);
        declaration += &format!("joint from_{point} = revolute(first.{point}, {bar}.position); ");
        declaration += &format!("joint to_{point} = revolute({bar}.B, second.{point}); ");
    }
    let arms = [0, 1].map(|triangle| corners[triangle][0]);
    let bar =
        FourBar { crank: length(arms[0]), at: 0.0, coupler: bars[0], rocker: length(arms[1]), c: minus(feet[1], feet[0]), p: [0.0; 2] };
    let way = |crank: f64, rocker: f64| minus(corner(1, 1, rocker - angle(arms[1])), corner(0, 1, crank - angle(arms[0])));
    let assemblies = scanned(&bar, &|crank, (_, rocker, _)| length(way(crank, *rocker)) - bars[1]).into_iter().map(|(crank, side)| {
        let (coupler, rocker, _) = bar.closed(crank).1.expect("it closes where it was found")[side];
        vec![crank - angle(arms[0]), rocker - angle(arms[1]), coupler, angle(way(crank, rocker))]
    });
    Linkage { assemblies: assemblies.collect(), declaration, bodies: vec!["first", "second", "bar_p", "bar_q"] }
}

#[test]
fn nearest_of_a_plate_on_three_distances() {
    look(random_plate, 0x2468_ace0_1357_9bdf, 60);
}

#[test]
fn nearest_of_a_plate_on_three_cranks() {
    look(random_platform, 0x0bad_cafe_1234_5678, 30);
}

#[test]
fn nearest_of_two_triangles_on_two_bars() {
    look(random_fourth_class, 0x5eed_0f0f_7a7a_3131, 30);
}
