//! Units that the language lacks, in units that it has.

/// Units that the language lacks, and one of each in units that it has.
const EQUIVALENTS: &[(&str, &str)] = &[
    ("dm", "100mm"),
    ("µm", "1um"),
    ("ms2", "1m_s2"),
    ("lbft", "1lbf * 1ft"),
    ("ftlb", "1lbf * 1ft"),
    ("N_mm2", "1MPa"),
    ("mil", "0.0254mm"),
    ("thou", "0.0254mm"),
    ("grad", "0.9deg"),
    ("gon", "0.9deg"),
    ("arcmin", "1deg / 60"),
    ("arcsec", "1deg / 3600"),
    ("ns", "0.001us"),
    ("Mg", "1000kg"),
    ("ton", "1000kg"),
    ("lbs", "1lb"),
    ("rps", "60rpm"),
    ("turn_s", "60rpm"),
    ("turns_s", "60rpm"),
    ("turn_min", "1rpm"),
    ("D", "1deg"),
    ("rev_s", "60rpm"),
    ("rev_min", "1rpm"),
    ("daN", "10N"),
    ("krpm", "1000rpm"),
    ("mrad_s", "0.001rad_s"),
    ("um_s", "0.001mm_s"),
    ("cm_s2", "10mm_s2"),
    ("km_s", "1000m_s"),
    ("kmh", "1km_h"),
    ("mph", "5280ft / 1h"),
    ("mm3", "1mm2 * 1mm"),
    ("cm3", "100mm2 * 1cm"),
    ("m3", "1m2 * 1m"),
    ("mN", "0.001N"),
    ("MN", "1000kN"),
    ("kp", "1kgf"),
    ("kNmm", "1Nm"),
    ("MNm", "1000000Nm"),
    ("MJ", "1000kJ"),
    ("Wh", "3.6kJ"),
    ("kWh", "3600kJ"),
    ("gm2", "0.001kgm2"),
    ("gmm2", "0.000000001kgm2"),
    ("N_um", "1000N_mm"),
    ("MN_m", "1000kN_m"),
    ("mN_m", "0.001N_m"),
    ("Ns_mm", "1000Ns_m"),
    ("kNs_m", "1000Ns_m"),
    ("Nmm_rad", "0.001Nm_rad"),
    ("kNm_rad", "1000Nm_rad"),
    ("Nm_deg", "1Nm / 1deg"),
    ("mW", "0.001W"),
    ("hp", "745.6998715822702W"),
    ("PS", "735.49875W"),
    ("atm", "101325Pa"),
];

/// One of a unit that the language lacks, in units that it has.
pub(crate) fn equivalent(unit: &str) -> Option<&'static str> {
    EQUIVALENTS.iter().find(|(name, _)| *name == unit).map(|(_, equivalent)| *equivalent)
}

#[cfg(test)]
mod tests {
    use super::EQUIVALENTS;
    use crate::quantity::{self, unit};
    use std::f64::consts::PI;

    /// Prefixes of SI.
    const PREFIXES: [(&str, f64); 9] =
        [("G", 1e9), ("M", 1e6), ("k", 1e3), ("h", 1e2), ("d", 1e-1), ("c", 1e-2), ("m", 1e-3), ("u", 1e-6), ("n", 1e-9)];

    // Standard gravity (m/s²), the international pound (kg) and inch (m).
    const GRAVITY: f64 = 9.80665;
    const POUND: f64 = 0.453_592_37;
    const INCH: f64 = 0.0254;

    /// Units without a prefix before a unit of the language, in SI by their definitions.
    const DEFINED: &[(&str, f64)] = &[
        ("min", 60.0),
        ("µm", 1e-6),
        ("ms2", 1.0),
        ("lbft", POUND * GRAVITY * 12.0 * INCH),
        ("ftlb", POUND * GRAVITY * 12.0 * INCH),
        ("N_mm2", 1e6),
        ("mm2", 1e-6),
        ("cm2", 1e-4),
        ("lb", POUND),
        ("km_h", 1e3 / 3600.0),
        ("kgf", GRAVITY),
        ("lbf", POUND * GRAVITY),
        ("Ncm", 1e-2),
        ("Nmm", 1e-3),
        ("kgcm2", 1e-4),
        ("kgmm2", 1e-6),
        ("gcm2", 1e-7),
        ("N_cm", 1e2),
        ("N_mm", 1e3),
        ("bar", 1e5),
        ("psi", POUND * GRAVITY / (INCH * INCH)),
        ("mil", 1e-3 * INCH),
        ("thou", 1e-3 * INCH),
        ("grad", PI / 200.0),
        ("gon", PI / 200.0),
        ("arcmin", PI / 10_800.0),
        ("arcsec", PI / 648_000.0),
        ("ton", 1e3),
        ("lbs", POUND),
        ("rps", 2.0 * PI),
        ("turn_s", 2.0 * PI),
        ("turns_s", 2.0 * PI),
        ("turn_min", 2.0 * PI / 60.0),
        ("D", PI / 180.0),
        ("rev_s", 2.0 * PI),
        ("rev_min", 2.0 * PI / 60.0),
        ("daN", 10.0),
        ("kmh", 1e3 / 3600.0),
        ("mph", 63_360.0 * INCH / 3600.0),
        ("mm3", 1e-9),
        ("cm3", 1e-6),
        ("m3", 1.0),
        ("kp", GRAVITY),
        ("Wh", 3600.0),
        ("kWh", 3.6e6),
        ("gm2", 1e-3),
        ("gmm2", 1e-9),
        ("N_um", 1e6),
        ("Ns_mm", 1e3),
        ("Nmm_rad", 1e-3),
        ("Nm_deg", 180.0 / PI),
        ("hp", 550.0 * 12.0 * INCH * POUND * GRAVITY),
        ("PS", 75.0 * GRAVITY),
        ("atm", 101_325.0),
    ];

    /// The size of a unit, by its definition or by its prefix.
    fn wanted(name: &str) -> Option<f64> {
        let defined = DEFINED.iter().find(|(known, _)| *known == name).map(|(_, size)| *size);
        let by_prefix = || PREFIXES.iter().find_map(|(prefix, factor)| Some(factor * unit(name.strip_prefix(prefix)?)?.0.to_f64()));
        defined.or_else(by_prefix)
    }

    /// The size of a product or quotient of numbers with units, in SI.
    fn size(text: &str) -> f64 {
        let mut words = text.split(' ');
        let number = |word: &str| {
            let end = word.find(|letter: char| letter.is_alphabetic()).unwrap_or(word.len());
            let (digits, name) = word.split_at(end);
            let of_unit = if name.is_empty() { 1.0 } else { unit(name).expect("a unit of the language").0.to_f64() };
            digits.parse::<f64>().expect("a number") * of_unit
        };
        let mut product = number(words.next().expect("a first number"));
        while let (Some(operator), Some(word)) = (words.next(), words.next()) {
            product = if operator == "*" { product * number(word) } else { product / number(word) };
        }
        product
    }

    #[test]
    fn units_of_the_language_have_their_sizes() {
        let known: Vec<(&str, f64)> = quantity::units().filter_map(|name| Some((name, wanted(name)?))).collect();
        assert!(known.len() > 40, "{} units", known.len());
        for (name, wanted) in known {
            let found = unit(name).expect("a unit").0.to_f64();
            assert!((found / wanted - 1.0).abs() < 4.0 * f64::EPSILON, "1{name} is {wanted}, not {found}");
        }
    }

    #[test]
    fn units_that_the_language_lacks_have_their_sizes() {
        for (name, equivalent) in EQUIVALENTS {
            assert!(unit(name).is_none(), "{name} is a unit");
            let (found, wanted) = (size(equivalent), wanted(name).unwrap_or_else(|| panic!("what is {name}?")));
            assert!((found / wanted - 1.0).abs() < 4.0 * f64::EPSILON, "1{name} is {wanted}, not {found}");
        }
    }
}
