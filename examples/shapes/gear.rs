//! Outlines of gears.

use std::f64::consts::{PI, TAU};

use reuleaux::nalgebra::Vector3;
use reuleaux::view::View;

use super::{Place, polar, ring, rod};

/// Pressure angle of the usual tooth (rad).
const PRESSURE: f64 = 20.0 / 180.0 * PI;

/// The outline of an involute gear about `centre` with one tooth in the direction `angle` (rad).
///
/// `module` (m) is the pitch diameter divided by the number of `teeth`; a negative one draws the spaces of an internal gear.
#[must_use]
pub fn gear(centre: Place, teeth: u32, module: f64, angle: f64) -> Vec<Place> {
    let z = f64::from(teeth);
    let pitch = module.abs() * z / 2.0;
    let (above, below, inside) = if module < 0.0 { (1.2, 1.0, PI / z) } else { (1.0, 1.2, 0.0) };
    let (base, tip, root) = (pitch * PRESSURE.cos(), pitch + above * module.abs(), pitch - below * module.abs());
    // Half the angle of a tooth at this radius; the involute begins on the base circle.
    let half = |radius: f64| {
        let pressure = (base / radius.max(base)).acos();
        PI / (2.0 * z) + (PRESSURE.tan() - PRESSURE) - (pressure.tan() - pressure)
    };
    let radii = [root, base.max(root), (base.max(root) + pitch) / 2.0, pitch, (pitch + tip) / 2.0, tip];
    let flank = radii.map(|radius| (radius, half(radius)));
    let tooth = move |k: u32| {
        let axis = angle + inside + TAU * f64::from(k) / z;
        let (rising, falling) = (flank.into_iter(), flank.into_iter().rev());
        rising.map(move |(r, h)| polar(r, axis - h)).chain(falling.map(move |(r, h)| polar(r, axis + h)))
    };
    (0..teeth).flat_map(tooth).map(|point| centre + point).collect()
}

/// Angle (rad) of a tooth of a wheel that meshes with a pinion with a tooth at `tooth` (rad).
///
/// The wheel's centre lies in `direction` (rad) from the pinion's; an internal gear has a negative number of teeth.
#[must_use]
pub fn meshing(direction: f64, pinion: f64, wheel: f64, tooth: f64) -> f64 {
    direction + PI - (tooth - direction) * pinion / wheel + PI / wheel
}

/// The rim of a bevel gear with its teeth, `back` (m) from the common apex along a coordinate axis.
fn bevel(back: Vector3<f64>, radius: f64, teeth: u32) -> Vec<Vector3<f64>> {
    let other = back.abs().normalize().cross(&Vector3::z());
    let tooth = |k: u32| {
        [(-0.15, 1.07), (0.15, 1.07), (0.3, 0.93), (0.7, 0.93)].map(|(part, size)| {
            let angle = TAU * (f64::from(k) + part) / f64::from(teeth);
            back + (other * angle.cos() + Vector3::z() * angle.sin()) * radius * size
        })
    };
    (0..teeth).flat_map(tooth).collect()
}

/// The gears of a bevel differential in the bodies `left`, `right` and `planet`, with shafts of 100 mm along y.
///
/// * `radii`: given, those of the pitch circles of the planet and of the side gears (m).
#[must_use]
pub fn differential<S>(view: View<S>, [planet, side]: [f64; 2]) -> View<S> {
    let (axis, pin) = (Vector3::y(), Vector3::x());
    let sides = [("left", axis), ("right", -axis)].into_iter().fold(view, |view, (body, out)| {
        view.outline(body, bevel(out * planet, side, 16))
            .outline(body, ring(&(out * 0.6 * planet), &axis, 0.6 * side))
            .outline(body, rod(out * 0.1, Vector3::x() * 0.003))
            .outline(body, rod(out * 0.1, Vector3::z() * 0.003))
    });
    sides.outline("planet", bevel(pin * side, planet, 10)).outline("planet", ring(&(pin * 0.6 * side), &pin, 0.6 * planet))
}
