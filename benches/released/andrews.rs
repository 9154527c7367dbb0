//! D1: Andrews' squeezing mechanism, seven bodies that a motor drives against a spring.

use reuleaux::mechanism;
use serde_json::{Value, json};

use crate::multibody::{Cut, Joint, Model};

mechanism! {
    /// Andrews' squeezing mechanism.
    pub mechanism Andrews {
        ground {
            point O = (0mm, 0mm);  point A = (-69.34mm, -2.27mm);
            point B = (-36.35mm, 32.73mm);  point C = (14mm, 72mm);
        }
        body of  { point O = (-0.92mm, 0mm);  point F = (6.08mm, 0mm);  mass = 43.25g;  inertia = 2.194e-6kgm2;  start angle = -0.0617rad; }
        body ef  { point F = (11.5mm, 0mm);  point E = (-16.5mm, 0mm);  mass = 3.65g;  inertia = 4.41e-7kgm2;  start angle = -0.0617rad; }
        body bde { point B = (-10.43mm, 18.74mm);  point D = (9.57mm, 0.74mm);  point E = (-10.43mm, -16.26mm);  mass = 23.73g;  inertia = 5.255e-6kgm2;  start angle = 0.455rad; }
        body ge  { point G = (0mm, 5.79mm);  point E = (0mm, -14.21mm);  mass = 7.06g;  inertia = 5.667e-7kgm2;  start angle = 0.71rad; }
        body ag  { point A = (-23.08mm, -9.16mm);  point G = (16.92mm, -9.16mm);  mass = 70.5g;  inertia = 1.169e-5kgm2;  start angle = 0.487rad; }
        body he  { point H = (-5.79mm, 0mm);  point E = (14.21mm, 0mm);  mass = 7.06g;  inertia = 5.667e-7kgm2;  start angle = 1.008rad; }
        body ah  { point A = (4.49mm, 12.28mm);  point H = (4.49mm, -27.72mm);  mass = 54.98g;  inertia = 1.912e-5kgm2;  start angle = 1.23rad; }
        joint o = revolute(ground.O, of.O);
        joint f = revolute(of.F, ef.F);
        joint e = revolute(ef.E, bde.E);
        joint b = revolute(ground.B, bde.B);
        joint e_of_ge = revolute(ef.E, ge.E);
        joint g = revolute(ge.G, ag.G);
        joint a_of_ag = revolute(ground.A, ag.A);
        joint e_of_he = revolute(ef.E, he.E);
        joint h = revolute(he.H, ah.H);
        joint a_of_ah = revolute(ground.A, ah.A);
        force motor = { on of: 0.033Nm; }
        force spring = spring(ground.C, bde.D, stiffness: 4530N_m, rest: 77.85mm);
        freedom crank = of.angle from -0.0617138900142764496358948458001rad;
    }
}

/// β, γ, δ and ε at 0.03 s, of the problem with its parameters as doubles.
pub const EXACT: [f64; 4] = [15.810_771_195_153_71, 0.040_822_240_119_645_82, 0.524_409_965_879_954, 1.048_080_741_041_938];

/// In s.
pub const DURATION: f64 = 0.03;

/// The angle of the crank at the beginning (rad).
const START: f64 = -0.061_713_890_014_276_45;

/// A body of the tree, in m, kg and kg m²: its name, the body before, where it begins, its mass centre, mass and moment of inertia, about
/// what its angle is.
type Part = (&'static str, Option<usize>, [f64; 2], [f64; 2], f64, f64, f64);

/// Frames lie in the joints that bodies hang on.
const PARTS: [Part; 7] = [
    ("of", None, [0.0, 0.0], [0.92e-3, 0.0], 0.04325, 2.194e-6, START),
    ("ef", Some(0), [7e-3, 0.0], [-11.5e-3, 0.0], 0.00365, 4.41e-7, 0.0),
    ("bde", None, [-0.03635, 0.03273], [10.43e-3, -18.74e-3], 0.02373, 5.255e-6, 0.455),
    ("ag", None, [-0.06934, -0.00227], [23.08e-3, 9.16e-3], 0.0705, 1.169e-5, 0.487),
    ("ge", Some(3), [40e-3, 0.0], [0.0, -5.79e-3], 0.00706, 5.667e-7, 0.223),
    ("ah", None, [-0.06934, -0.00227], [-4.49e-3, -12.28e-3], 0.05498, 1.912e-5, 1.23),
    ("he", Some(5), [0.0, -40e-3], [5.79e-3, 0.0], 0.00706, 5.667e-7, -0.222),
];

/// For other people's programs: bodies about z with relative angles as coordinates, of which the first is exact at the beginning, motor and
/// spring.
#[must_use]
pub fn described() -> Value {
    let mut model = Model::new("D1 Andrews");
    for (name, parent, [x, y], [cx, cy], mass, inertia, start) in PARTS {
        let body = model.hang(name, parent, &[Joint::Turn(2)], &[start]);
        (body.place, body.center, body.mass, body.inertia) = ([x, y, 0.0], [cx, cy, 0.0], mass, [inertia; 3]);
    }
    let end = (Some(1), [-28e-3, 0.0, 0.0]);
    let ends = [(2, [0.0, -35e-3, 0.0]), (4, [0.0, -20e-3, 0.0]), (6, [20e-3, 0.0, 0.0])];
    model.cuts = ends.into_iter().map(|(body, place)| Cut::Meet(end, (Some(body), place))).collect();
    let mut described = model.described();
    described["torques"] = json!([[0, 0.033]]);
    described["springs"] = json!([[[null, [0.014, 0.072, 0.0]], [2, [20e-3, -18e-3, 0.0]], 4530.0, 0.07785]]);
    described
}
