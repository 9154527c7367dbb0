//! The units that a literal may carry, with their exact size in SI.

use super::dimension::Dim;
use crate::expr::Exact;

/// A unit: its name, numerator and denominator of its size, whether π is a factor of it, and its dimension.
struct Unit {
    name: &'static str,
    size: (i128, i128),
    pi: bool,
    dim: Dim,
}

const fn unit(name: &'static str, numerator: i128, denominator: i128, dim: Dim) -> Unit {
    Unit { name, size: (numerator, denominator), pi: false, dim }
}

const fn pi_unit(name: &'static str, numerator: i128, denominator: i128, dim: Dim) -> Unit {
    Unit { name, size: (numerator, denominator), pi: true, dim }
}

const UNITS: &[Unit] = &[
    unit("m", 1, 1, Dim::LENGTH),
    unit("cm", 1, 100, Dim::LENGTH),
    unit("mm", 1, 1_000, Dim::LENGTH),
    unit("um", 1, 1_000_000, Dim::LENGTH),
    unit("km", 1_000, 1, Dim::LENGTH),
    unit("in", 254, 10_000, Dim::LENGTH),
    unit("ft", 3_048, 10_000, Dim::LENGTH),
    unit("rad", 1, 1, Dim::ANGLE),
    unit("mrad", 1, 1_000, Dim::ANGLE),
    pi_unit("deg", 1, 180, Dim::ANGLE),
    pi_unit("turn", 2, 1, Dim::ANGLE),
    unit("s", 1, 1, Dim::TIME),
    unit("ms", 1, 1_000, Dim::TIME),
    unit("us", 1, 1_000_000, Dim::TIME),
    unit("min", 60, 1, Dim::TIME),
    unit("h", 3_600, 1, Dim::TIME),
    unit("kg", 1, 1, Dim::new(0, 0, 0, 1)),
    unit("g", 1, 1_000, Dim::new(0, 0, 0, 1)),
    unit("mg", 1, 1_000_000, Dim::new(0, 0, 0, 1)),
    unit("lb", 45_359_237, 100_000_000, Dim::new(0, 0, 0, 1)),
    pi_unit("rpm", 2, 60, Dim::new(0, 1, -1, 0)),
    unit("rad_s", 1, 1, Dim::new(0, 1, -1, 0)),
    pi_unit("deg_s", 1, 180, Dim::new(0, 1, -1, 0)),
    unit("rad_s2", 1, 1, Dim::new(0, 1, -2, 0)),
    pi_unit("deg_s2", 1, 180, Dim::new(0, 1, -2, 0)),
    unit("m_s", 1, 1, Dim::new(1, 0, -1, 0)),
    unit("mm_s", 1, 1_000, Dim::new(1, 0, -1, 0)),
    unit("cm_s", 1, 100, Dim::new(1, 0, -1, 0)),
    unit("km_h", 10, 36, Dim::new(1, 0, -1, 0)),
    unit("m_s2", 1, 1, Dim::new(1, 0, -2, 0)),
    unit("mm_s2", 1, 1_000, Dim::new(1, 0, -2, 0)),
    unit("mm2", 1, 1_000_000, Dim::new(2, 0, 0, 0)),
    unit("cm2", 1, 10_000, Dim::new(2, 0, 0, 0)),
    unit("m2", 1, 1, Dim::new(2, 0, 0, 0)),
    unit("N", 1, 1, Dim::new(1, 0, -2, 1)),
    unit("kN", 1_000, 1, Dim::new(1, 0, -2, 1)),
    unit("kgf", 980_665, 100_000, Dim::new(1, 0, -2, 1)),
    unit("lbf", 44_482_216_152_605, 10_000_000_000_000, Dim::new(1, 0, -2, 1)),
    unit("Nm", 1, 1, Dim::new(2, 0, -2, 1)),
    unit("Nmm", 1, 1_000, Dim::new(2, 0, -2, 1)),
    unit("Ncm", 1, 100, Dim::new(2, 0, -2, 1)),
    unit("mNm", 1, 1_000, Dim::new(2, 0, -2, 1)),
    unit("kNm", 1_000, 1, Dim::new(2, 0, -2, 1)),
    unit("J", 1, 1, Dim::new(2, 0, -2, 1)),
    unit("mJ", 1, 1_000, Dim::new(2, 0, -2, 1)),
    unit("kJ", 1_000, 1, Dim::new(2, 0, -2, 1)),
    unit("kgm2", 1, 1, Dim::new(2, 0, 0, 1)),
    unit("kgcm2", 1, 10_000, Dim::new(2, 0, 0, 1)),
    unit("kgmm2", 1, 1_000_000, Dim::new(2, 0, 0, 1)),
    unit("gcm2", 1, 10_000_000, Dim::new(2, 0, 0, 1)),
    unit("N_m", 1, 1, Dim::new(0, 0, -2, 1)),
    unit("N_mm", 1_000, 1, Dim::new(0, 0, -2, 1)),
    unit("N_cm", 100, 1, Dim::new(0, 0, -2, 1)),
    unit("kN_m", 1_000, 1, Dim::new(0, 0, -2, 1)),
    unit("kN_mm", 1_000_000, 1, Dim::new(0, 0, -2, 1)),
    unit("Ns_m", 1, 1, Dim::new(0, 0, -1, 1)),
    unit("Nm_rad", 1, 1, Dim::new(2, -1, -2, 1)),
    unit("Nms", 1, 1, Dim::new(2, 0, -1, 1)),
    unit("Nms_rad", 1, 1, Dim::new(2, -1, -1, 1)),
    unit("W", 1, 1, Dim::new(2, 0, -3, 1)),
    unit("kW", 1_000, 1, Dim::new(2, 0, -3, 1)),
    unit("MW", 1_000_000, 1, Dim::new(2, 0, -3, 1)),
    unit("Pa", 1, 1, Dim::new(-1, 0, -2, 1)),
    unit("kPa", 1_000, 1, Dim::new(-1, 0, -2, 1)),
    unit("bar", 100_000, 1, Dim::new(-1, 0, -2, 1)),
    unit("MPa", 1_000_000, 1, Dim::new(-1, 0, -2, 1)),
    unit("GPa", 1_000_000_000, 1, Dim::new(-1, 0, -2, 1)),
    unit("hPa", 100, 1, Dim::new(-1, 0, -2, 1)),
    unit("mbar", 100, 1, Dim::new(-1, 0, -2, 1)),
    unit("psi", 44_482_216_152_605, 6_451_600_000, Dim::new(-1, 0, -2, 1)),
];

/// Size in SI and dimension of the unit of this name.
pub(crate) fn lookup(name: &str) -> Option<(Exact, Dim)> {
    let unit = UNITS.iter().find(|unit| unit.name == name)?;
    let size = Exact::ratio(unit.size.0, unit.size.1)?;
    let size = if unit.pi { size.checked_mul(Exact::PI)? } else { size };
    Some((size, unit.dim))
}

/// All unit names, for suggestions.
pub(crate) fn names<'a>() -> impl Iterator<Item = &'a str> {
    UNITS.iter().map(|unit| unit.name)
}
