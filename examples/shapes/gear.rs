//! Outlines of gears.

use std::f64::consts::{PI, TAU};

use super::{Place, polar};

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
