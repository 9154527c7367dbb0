//! Units that engineers write elsewhere, in those of the language.

/// Units that are not known here, with one of each written in units that are.
const EQUIVALENTS: &[(&str, &str)] = &[
    ("dm", "100mm"),
    ("nm", "0.001um"),
    ("mil", "0.0254mm"),
    ("thou", "0.0254mm"),
    ("grad", "0.9deg"),
    ("gon", "0.9deg"),
    ("arcmin", "1deg / 60"),
    ("arcsec", "1deg / 3600"),
    ("ns", "0.001us"),
    ("mg", "0.001g"),
    ("Mg", "1000kg"),
    ("t", "1000kg"),
    ("ton", "1000kg"),
    ("lb", "0.45359237kg"),
    ("lbs", "0.45359237kg"),
    ("rps", "60rpm"),
    ("krpm", "1000rpm"),
    ("mrad_s", "0.001rad_s"),
    ("um_s", "0.001mm_s"),
    ("cm_s", "10mm_s"),
    ("cm_s2", "10mm_s2"),
    ("km_s", "1000m_s"),
    ("kmh", "1km / 1h"),
    ("km_h", "1km / 1h"),
    ("mph", "5280ft / 1h"),
    ("cm2", "100mm2"),
    ("mm3", "1mm2 * 1mm"),
    ("cm3", "100mm2 * 1cm"),
    ("m3", "1m2 * 1m"),
    ("mN", "0.001N"),
    ("MN", "1000kN"),
    ("kgf", "9.80665N"),
    ("kp", "9.80665N"),
    ("lbf", "4.4482216152605N"),
    ("mNm", "1Nmm"),
    ("Ncm", "10Nmm"),
    ("kNm", "1000Nm"),
    ("kNmm", "1Nm"),
    ("MNm", "1000000Nm"),
    ("J", "1Nm"),
    ("kJ", "1000Nm"),
    ("gm2", "0.001kgm2"),
    ("kgcm2", "0.0001kgm2"),
    ("kgmm2", "0.000001kgm2"),
    ("gcm2", "0.0000001kgm2"),
    ("gmm2", "0.000000001kgm2"),
    ("N_um", "1000N_mm"),
    ("N_cm", "100N_m"),
    ("kN_mm", "1000kN_m"),
    ("MN_m", "1000kN_m"),
    ("mN_m", "0.001N_m"),
    ("Ns_mm", "1000Ns_m"),
    ("kNs_m", "1000Ns_m"),
    ("Nmm_rad", "0.001Nm_rad"),
    ("kNm_rad", "1000Nm_rad"),
    ("Nm_deg", "1Nm / 1deg"),
    ("mW", "0.001W"),
    ("MW", "1000kW"),
    ("hp", "745.6998715822702W"),
    ("PS", "735.49875W"),
    ("hPa", "100Pa"),
    ("mbar", "100Pa"),
    ("GPa", "1000MPa"),
    ("atm", "101325Pa"),
    ("psi", "6894.757293168361Pa"),
];

/// One of a unit of elsewhere, in units of the language.
pub(super) fn equivalent(unit: &str) -> Option<&'static str> {
    EQUIVALENTS.iter().find(|(name, _)| *name == unit).map(|(_, equivalent)| *equivalent)
}

#[cfg(test)]
mod tests {
    use super::EQUIVALENTS;
    use crate::quantity::unit;

    /// Prefixes of SI that units elsewhere begin with.
    const PREFIXES: [(&str, f64); 8] =
        [("M", 1e6), ("k", 1e3), ("h", 1e2), ("d", 1e-1), ("c", 1e-2), ("m", 1e-3), ("u", 1e-6), ("n", 1e-9)];

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
    fn units_of_elsewhere_are_none_of_ours_and_have_their_sizes() {
        let mut compared = 0;
        for (name, equivalent) in EQUIVALENTS {
            assert!(unit(name).is_none(), "{name} is a unit");
            let found = size(equivalent);
            assert!(found > 0.0);
            // A prefix before a unit of the language multiplies it.
            for (prefix, factor) in PREFIXES {
                let plain = name.strip_prefix(prefix).and_then(unit).filter(|_| !["mil", "mph", "nm", "mm3", "cm3", "cm2"].contains(name));
                if let Some((plain, _)) = plain {
                    let wanted = factor * plain.to_f64();
                    assert!((found / wanted - 1.0).abs() < 1e-15 * 4.0, "1{name} is {wanted}, not {found}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 10, "only {compared} have a prefix");
    }
}
