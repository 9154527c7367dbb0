//! D2: a four-bar that is released: ground 4, crank 1, coupler 3.5, rocker 3 m, of bars that weigh a kilogram a metre. D3: the same with a
//! crank that turns at constant speed.

use reuleaux::mechanism;

use crate::multibody::{Cut, Joint, Model};

macro_rules! four_bar {
    ($(#[$page:meta])* $name:ident, $($rest:tt)*) => {
        mechanism! {
            $(#[$page])*
            pub mechanism $name {
                $($rest)*
                gravity = (0, -9.81m_s2);
                ground { point D = (4m, 0m); }
                body crank   { point B = (1m, 0m);    mass = 1kg;    center = (0.5m, 0m);   inertia = 1/12 * 1kgm2; }
                body coupler { point C = (3.5m, 0m);  mass = 3.5kg;  center = (1.75m, 0m);  inertia = 3.5^3 / 12 * 1kgm2;  start angle = 50deg; }
                body rocker  { point C = (3m, 0m);    mass = 3kg;    center = (1.5m, 0m);   inertia = 27/12 * 1kgm2;  start angle = 100deg; }
                joint a = revolute(ground.position, crank.position);
                joint b = revolute(crank.B, coupler.position);
                joint c = revolute(coupler.C, rocker.C);
                joint d = revolute(rocker.position, ground.D);
            }
        }
    };
}

four_bar!(
    /// The crank is free.
    FourBar,
    param start: Angle = 0.3rad;
    param speed: AngularVelocity = 0rad_s;
    freedom swing = crank.angle from start at speed;
);

four_bar!(
    /// The crank turns.
    Driven,
    drive motor = drive_angle(crank, 2rad_s * t);
);

/// The angle of the crank (rad) at [`DURATION`] from rest at 0.3 rad; two integrators agree to 6e-14.
pub const ANGLE: f64 = -1.066_735_900_834_445;
/// In s.
pub const DURATION: f64 = 5.0;

/// Lengths in m, which are masses in kg as well.
pub const LENGTHS: [f64; 3] = [1.0, 3.5, 3.0];
/// In m/s².
pub const GRAVITY: f64 = 9.81;

/// Bodies about z, with relative angles as coordinates.
#[must_use]
pub fn model() -> Model {
    let mut model = Model::new("D2 four-bar");
    model.gravity = [0.0, -GRAVITY, 0.0];
    for (k, (parent, place, start)) in [(None, 0.0, 0.3), (Some(0), LENGTHS[0], 0.6), (None, 4.0, 2.2)].into_iter().enumerate() {
        let body = model.hang(["crank", "coupler", "rocker"][k], parent, &[Joint::Turn(2)], &[start]);
        let length = LENGTHS[k];
        (body.place, body.center, body.mass) = ([place, 0.0, 0.0], [0.5 * length, 0.0, 0.0], length);
        body.inertia = [1e-3 * length, length.powi(3) / 12.0, length.powi(3) / 12.0];
    }
    model.cuts.push(Cut::Meet((Some(1), [LENGTHS[1], 0.0, 0.0]), (Some(2), [LENGTHS[2], 0.0, 0.0])));
    model
}
