//! Points of bodies that joints hold together, read from the equations.
//!
//! In: rows and their derivatives at a few configurations. Out: [`Links`]: which places of which bodies coincide, are a given
//! distance apart, or lie on a fixed line. What a joint is called does not matter, only what its rows are like:
//!
//! ```text
//! pin    two rows, ∂Φ₁/∂x = ±1, ∂Φ₂/∂y = ±1        the offset of the point from its body's origin is (∂Φ₂/∂φ, −∂Φ₁/∂φ)
//! rod    Φ = |h|² − c²                              ∂Φ/∂(x, y) = 2 h, and the change of ∂Φ/∂φ with x and y gives the offset
//! line   ∂Φ/∂(x, y) = n, |n| = 1, of one body       ∂Φ/∂φ here and a right angle further gives the offset
//! ```
//!
//! A row that is not like these at every configuration tried is left out; what is read is true, if not all that could be said.

use crate::expr::{Expr, Values, evaluate};
use crate::numeric::Numeric;
use crate::quantity::{Dim, Role};
use core::f64::consts::FRAC_PI_2;

/// Where a point is, and of what it is a part.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyPoint {
    /// The body, or ground.
    pub(super) body: Option<usize>,
    pub(super) at: [f64; 2],
    /// The joint in which it was met.
    pub(super) joint: usize,
}

/// What a joint says of two places.
#[derive(Clone, Copy, Debug)]
pub(super) enum Link {
    /// They coincide.
    Pin(BodyPoint, BodyPoint),
    /// They are so far apart.
    Rod(BodyPoint, BodyPoint, f64),
    /// The place lies on a line in ground, n · r = c.
    Line(BodyPoint, [f64; 2], f64),
}

/// Numbers that should agree do so to within this part.
const AGREES: f64 = 1e-6;

/// A body's coordinates in q: x, y, angle.
type Frame = [usize; 3];

/// Rows of a joint that are lengths, at one configuration.
struct LengthRow {
    phi: f64,
    slopes: Vec<(usize, f64)>,
}

impl LengthRow {
    fn slope(&self, unknown: usize) -> f64 {
        self.slopes.iter().find(|(known, _)| *known == unknown).map_or(0.0, |(_, slope)| *slope)
    }
}

/// Reads the joints among some equations, at places that their bodies have in a configuration.
pub(super) fn read(numeric: &Numeric, equations: &[usize], q: &[f64]) -> Vec<Link> {
    let mut joints: Vec<usize> = equations.iter().map(|equation| numeric.system.equations[*equation].joint).collect();
    joints.sort_unstable();
    joints.dedup();
    joints.into_iter().flat_map(|joint| LinkReader { numeric, joint, q }.links()).collect()
}

struct LinkReader<'a> {
    numeric: &'a Numeric<'a>,
    joint: usize,
    q: &'a [f64],
}

impl LinkReader<'_> {
    fn links(&self) -> Vec<Link> {
        // Equations stand in the order of their joints.
        let all = &self.numeric.system.equations;
        let first = all.partition_point(|equation| equation.joint < self.joint);
        let rows: Vec<usize> = (first..all.len()).take_while(|equation| all[*equation].joint == self.joint).collect();
        let of = |dim: Dim| rows.iter().copied().filter(|row| all[*row].dim == dim).collect::<Vec<usize>>();
        let mut links: Vec<Link> = of(Dim::LENGTH.times(Dim::LENGTH)).into_iter().filter_map(|row| self.rod(row)).collect();
        match of(Dim::LENGTH).as_slice() {
            [x, y] => links.extend(self.pin(*x, *y)),
            [row] => links.extend(self.line(*row)),
            _ => {}
        }
        links
    }

    /// Bodies whose place occurs in a row; `None` if a body has other coordinates than x, y and angle.
    fn frames(&self, row: usize) -> Option<Vec<(usize, Frame)>> {
        let unknowns = &self.numeric.system.coordinates;
        let mut bodies: Vec<usize> =
            self.numeric.system.equations[row].jacobian.iter().map(|(unknown, _)| unknowns[*unknown].body).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let frame = |body: usize| {
            let first = unknowns.partition_point(|unknown| unknown.body < body);
            let mut roles = Role::PLANE.iter().enumerate();
            let is_planar = roles.all(|(i, role)| unknowns.get(first + i).is_some_and(|found| found.role == *role));
            is_planar.then_some((body, [first, first + 1, first + 2]))
        };
        bodies.into_iter().map(frame).collect()
    }

    /// A row at the configuration with one coordinate changed.
    fn row(&self, row: usize, changed: Option<(usize, f64)>) -> Option<LengthRow> {
        let equation = &self.numeric.system.equations[row];
        let mut coordinates = self.q.to_vec();
        if let Some((unknown, by)) = changed {
            coordinates[unknown] += by;
        }
        let roots: Vec<Expr> = equation.phi().into_iter().chain(equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let values = evaluate(&self.numeric.system.arena, &roots, &Values { coordinates: &coordinates, ..self.numeric.known });
        let slopes = equation.jacobian.iter().zip(values.get(1..)?).map(|((unknown, _), value)| (*unknown, *value)).collect();
        values.iter().all(|value| value.is_finite()).then_some(LengthRow { phi: values[0], slopes })
    }

    fn place(&self, body: usize, [x, y, _]: Frame, offset: [f64; 2]) -> BodyPoint {
        BodyPoint { body: Some(body), at: [self.q[x] + offset[0], self.q[y] + offset[1]], joint: self.joint }
    }

    fn ground(&self, at: [f64; 2]) -> BodyPoint {
        BodyPoint { body: None, at, joint: self.joint }
    }

    fn is_near(&self, one: f64, other: f64) -> bool {
        (one - other).abs() <= AGREES * (self.numeric.size + one.abs())
    }

    fn pin(&self, x: usize, y: usize) -> Option<Link> {
        let frames = self.frames(x)?;
        let (first, second) = (self.row(x, None)?, self.row(y, None)?);
        let offset_of = |frame: &Frame, first: &LengthRow, second: &LengthRow| {
            let sign = first.slope(frame[0]);
            let is_place =
                sign.abs() == 1.0 && second.slope(frame[1]) == sign && first.slope(frame[1]) == 0.0 && second.slope(frame[0]) == 0.0;
            is_place.then(|| (sign, [sign * second.slope(frame[2]), -sign * first.slope(frame[2])]))
        };
        let mut places = Vec::new();
        for (body, frame) in &frames {
            let (sign, offset) = offset_of(frame, &first, &second)?;
            // Turned by a right angle, a point of the body is turned by a right angle.
            let turned = Some((frame[2], FRAC_PI_2));
            let (_, further) = offset_of(frame, &self.row(x, turned)?, &self.row(y, turned)?)?;
            if !self.is_near(further[0], -offset[1]) || !self.is_near(further[1], offset[0]) {
                return None;
            }
            places.push((sign, self.place(*body, *frame, offset)));
        }
        match places.as_slice() {
            [(sign, place)] => {
                let ground = [place.at[0] - sign * first.phi, place.at[1] - sign * second.phi];
                Some(Link::Pin(*place, self.ground(ground)))
            }
            // Φ is the difference of the two places, and nothing else.
            [(one, first_place), (other, second_place)] if *one == -*other => {
                let between = [0, 1].map(|i| one * (first_place.at[i] - second_place.at[i]));
                (self.is_near(between[0], first.phi) && self.is_near(between[1], second.phi))
                    .then_some(Link::Pin(*first_place, *second_place))
            }
            _ => None,
        }
    }

    fn rod(&self, row: usize) -> Option<Link> {
        let here = self.row(row, None)?;
        let size = self.numeric.size;
        let mut places: Vec<(BodyPoint, [f64; 2])> = Vec::new();
        for (body, frame) in self.frames(row)? {
            let [x, y, angle] = frame;
            let (right, up) = (self.row(row, Some((x, size)))?, self.row(row, Some((y, size)))?);
            // Φ is |h|² − c², and h moves with the body.
            let is_square = |row: &LengthRow, unknown| self.is_near(row.slope(unknown) - here.slope(unknown), 2.0 * size);
            if !is_square(&right, x) || !is_square(&up, y) {
                return None;
            }
            let offset = [(up.slope(angle) - here.slope(angle)) / (2.0 * size), (here.slope(angle) - right.slope(angle)) / (2.0 * size)];
            places.push((self.place(body, frame, offset), [here.slope(x) / 2.0, here.slope(y) / 2.0]));
        }
        let (place, h) = *places.first()?;
        let square = h[0] * h[0] + h[1] * h[1] - here.phi;
        let across = [place.at[0] - h[0], place.at[1] - h[1]];
        let other = match places.as_slice() {
            [_] => self.ground(across),
            [_, (other, _)] if self.is_near(other.at[0], across[0]) && self.is_near(other.at[1], across[1]) => *other,
            _ => return None,
        };
        (square > 0.0).then(|| Link::Rod(place, other, square.sqrt()))
    }

    fn line(&self, row: usize) -> Option<Link> {
        let frames = self.frames(row)?;
        let [(body, frame)] = frames.as_slice() else { return None };
        let [x, y, angle] = *frame;
        let (here, further) = (self.row(row, None)?, self.row(row, Some((angle, FRAC_PI_2)))?);
        let n = [here.slope(x), here.slope(y)];
        let is_fixed = n[0] == further.slope(x) && n[1] == further.slope(y) && self.is_near(n[0] * n[0] + n[1] * n[1], 1.0);
        if !is_fixed {
            return None;
        }
        // ∂Φ/∂φ is −n⊥ · s, and −n · s a right angle further.
        let (along, across) = (-further.slope(angle), -here.slope(angle));
        let place = self.place(*body, *frame, [along * n[0] - across * n[1], along * n[1] + across * n[0]]);
        Some(Link::Line(place, n, n[0] * place.at[0] + n[1] * place.at[1] - here.phi))
    }
}
