//! A four-bar linkage with nine coordinates, every derivative written by hand.
//!
//! ```text
//!         A ------ coupler ------ B        crank from O = (0, 0), rocker from C = (ground, 0);
//!        /                         \       frames in O, A and C, x along each bar
//!   crank                           rocker
//!      /                             \
//!     O ............................. C
//! ```

use reuleaux::nalgebra::{SMatrix, SVector};
use reuleaux::{Coordinate, Coordinates, Description, Equations, Float, ParameterOutOfRange, Real, Row, Solver, Stages, StepError};

/// Lengths in m, angles in rad; the driven angle is `from` + `speed` t.
#[derive(Clone, Copy, Debug)]
pub struct FourBar {
    pub ground: f64,
    pub crank: f64,
    pub coupler: f64,
    pub rocker: f64,
    pub driven: Driven,
    pub from: f64,
    pub speed: f64,
    /// Guesses of the angles of crank, coupler and rocker.
    pub start: [f64; 3],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Driven {
    Crank = 2,
    Rocker = 8,
}

/// A Grashof crank-rocker turned once a second.
pub const CRANK_ROCKER: FourBar = FourBar {
    ground: 0.4,
    crank: 0.1,
    coupler: 0.35,
    rocker: 0.3,
    driven: Driven::Crank,
    from: 0.3,
    speed: core::f64::consts::TAU,
    start: [0.3, 0.8, 1.5],
};

const fn coordinates(body: &'static str) -> [Coordinate; 3] {
    [Coordinate::length(body, "x"), Coordinate::length(body, "y"), Coordinate::angle(body, "angle")]
}

const fn revolute(joint: &'static str) -> [Row; 2] {
    let row = Row { joint, kind: "revolute", index: 1, of: 2, unit: "m" };
    [row, Row { index: 2, ..row }]
}

impl<T: Float> Stages<T, 9> for FourBar {
    fn stages(&self, t: T, pass: &mut Solver<'_, T, 9>) -> Result<Coordinates<T, 9>, StepError<T>> {
        reuleaux::at_once(self, t, pass)
    }

    fn refined_guess(&self, t: T, guess: &SVector<T, 9>) -> SVector<T, 9> {
        reuleaux::refined_guess_at_once(self, t, guess)
    }
}

impl<T: Real> Description<T, 9> for FourBar {
    const NAME: &'static str = "FourBar";
    const COORDINATES: &'static [Coordinate] = [coordinates("crank"), coordinates("coupler"), coordinates("rocker")].as_flattened();
    const ROWS: &'static [Row] = &[
        revolute("o")[0],
        revolute("o")[1],
        revolute("a")[0],
        revolute("a")[1],
        revolute("b")[0],
        revolute("b")[1],
        revolute("c")[0],
        revolute("c")[1],
        Row { joint: "input", kind: "drive_angle", index: 1, of: 1, unit: "rad" },
    ];

    fn start(&self) -> SVector<T, 9> {
        let [crank, coupler, rocker] = self.start;
        SVector::from([0.0, 0.0, crank, self.crank * crank.cos(), self.crank * crank.sin(), coupler, self.ground, 0.0, rocker].map(T::of))
    }

    fn characteristic_length(&self) -> T {
        T::of(self.ground)
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        if self.coupler == 0.0 {
            return Err(ParameterOutOfRange { name: "coupler", value: T::of(self.coupler), unit: "m", why: "it must not be zero" });
        }
        Ok(())
    }
}

impl<T: Real> Equations<T, 9, 9> for FourBar {
    fn phi(&self, q: &SVector<T, 9>, t: T) -> SVector<T, 9> {
        let [crank, coupler, rocker] = [self.crank, self.coupler, self.rocker].map(T::of);
        let ((s1, c1), (s2, c2), (s3, c3)) = (q[2].sin_cos(), q[5].sin_cos(), q[8].sin_cos());
        SVector::from([
            q[0],
            q[1],
            q[0] + crank * c1 - q[3],
            q[1] + crank * s1 - q[4],
            q[3] + coupler * c2 - q[6] - rocker * c3,
            q[4] + coupler * s2 - q[7] - rocker * s3,
            q[6] - T::of(self.ground),
            q[7],
            q[self.driven as usize] - T::of(self.from) - T::of(self.speed) * t,
        ])
    }

    fn jacobian(&self, q: &SVector<T, 9>, _: T) -> SMatrix<T, 9, 9> {
        let [crank, coupler, rocker] = [self.crank, self.coupler, self.rocker].map(T::of);
        let ((s1, c1), (s2, c2), (s3, c3)) = (q[2].sin_cos(), q[5].sin_cos(), q[8].sin_cos());
        let (i, z) = (T::of(1.0), T::of(0.0));
        let driven = |column| if self.driven as usize == column { i } else { z };
        SMatrix::from_row_slice(&[
            i,
            z,
            z,
            z,
            z,
            z,
            z,
            z,
            z, //
            z,
            i,
            z,
            z,
            z,
            z,
            z,
            z,
            z, //
            i,
            z,
            -(crank * s1),
            -i,
            z,
            z,
            z,
            z,
            z, //
            z,
            i,
            crank * c1,
            z,
            -i,
            z,
            z,
            z,
            z, //
            z,
            z,
            z,
            i,
            z,
            -(coupler * s2),
            -i,
            z,
            rocker * s3, //
            z,
            z,
            z,
            z,
            i,
            coupler * c2,
            z,
            -i,
            -(rocker * c3), //
            z,
            z,
            z,
            z,
            z,
            z,
            i,
            z,
            z, //
            z,
            z,
            z,
            z,
            z,
            z,
            z,
            i,
            z, //
            z,
            z,
            driven(2),
            z,
            z,
            z,
            z,
            z,
            driven(8),
        ])
    }

    fn linearize(&self, q: &SVector<T, 9>, t: T) -> (SVector<T, 9>, SMatrix<T, 9, 9>) {
        (self.phi(q, t), self.jacobian(q, t))
    }

    fn nu(&self, _: &SVector<T, 9>, _: T) -> SVector<T, 9> {
        let mut nu = SVector::from_element(T::of(0.0));
        nu[8] = T::of(self.speed);
        nu
    }

    fn gamma(&self, q: &SVector<T, 9>, qd: &SVector<T, 9>, _: T) -> SVector<T, 9> {
        let arm = |length: f64, body: usize| {
            let ((s, c), square) = (q[body].sin_cos(), T::of(length) * qd[body] * qd[body]);
            (square * c, square * s)
        };
        let (crank, coupler, rocker) = (arm(self.crank, 2), arm(self.coupler, 5), arm(self.rocker, 8));
        let z = T::of(0.0);
        SVector::from([z, z, crank.0, crank.1, coupler.0 - rocker.0, coupler.1 - rocker.1, z, z, z])
    }
}
