//! Gears that cannot mesh: pitch radii against the distance between axes, and ring gears against sun gears.

use crate::accepted;

/// Warnings about two gears on an arm, `distance` mm apart.
fn told(distance: f64, radii: &str) -> Vec<String> {
    let source = format!(
        "mechanism G {{
            body arm {{ point A = (10mm, 5mm);  point B = (10mm + {distance}mm * cos(0.4), 5mm + {distance}mm * sin(0.4)); }}
            body one {{ point C = (1mm, 2mm); }}
            body two {{ }}
            joint o = revolute(ground.position, arm.position);
            joint a = revolute(one.C, arm.A);
            joint b = revolute(arm.B, two.position);
            joint mesh = gear_pair(one, two, {radii}, carrier: arm);
            drive turn = drive_angle(arm, 1rad_s * t);
            drive motor = drive_angle(one, 2rad_s * t);
        }}"
    );
    accepted(&source).motion.flaws.iter().map(|warning| warning.doubt.to_string()).collect()
}

#[test]
fn radii_that_do_not_fit_are_told() {
    let words = |distance: &str, how: &str| {
        format!(
            "the axes of the gears of `mesh` are {distance} apart, and their radii {how}\nhelp: change a radius, or the place of an axis"
        )
    };
    assert_eq!(told(100.0, "20mm, 40mm"), [words("100 mm", "add up to 60 mm")]);
    assert_eq!(told(50.0, "20mm, 40mm"), [words("50 mm", "add up to 60 mm")]);
    assert_eq!(told(63.3, "20mm, 40mm"), [words("63.3 mm", "add up to 60 mm")]);
    assert_eq!(told(56.9, "20mm, 40mm"), [words("56.9 mm", "add up to 60 mm")]);
    assert_eq!(told(60.0, "20mm, -40mm"), [words("60 mm", "differ by 20 mm")]);
}

#[test]
fn radii_that_fit_are_not() {
    for (distance, radii) in [
        (60.0, "20mm, 40mm"),
        (61.0, "20mm, 40mm"),
        (63.1, "20mm, 40mm"),
        (57.1, "20mm, 40mm"),
        (60.0, "-20mm, -40mm"),
        (20.0, "20mm, -40mm"),
        (100.0, "20, 40"),
    ] {
        assert!(told(distance, radii).is_empty(), "{distance} mm, {radii}");
    }
}

#[test]
fn a_ring_is_larger_than_its_sun() {
    let told = |teeth: &str| {
        let source = format!(
            "mechanism P {{
                body sun {{ }}
                body ring {{ }}
                body arm {{ }}
                joint a = revolute(ground.position, sun.position);
                joint b = revolute(ground.position, ring.position);
                joint c = revolute(ground.position, arm.position);
                joint train = planetary(sun, ring, arm, {teeth});
                drive one = drive_angle(sun, 1rad_s * t);
                drive two = drive_angle(arm, 2rad_s * t);
            }}"
        );
        accepted(&source).motion.flaws.iter().map(|warning| warning.doubt.to_string()).collect::<Vec<String>>()
    };
    assert_eq!(
        told("60, 20"),
        [
            "the ring gear of `train` (20) is not larger than the sun gear inside it (60)\nhelp: the sun gear comes first, as in `z_sun: 20, z_ring: 60`; the teeth of the planets are not given"
        ]
    );
    assert_eq!(told("24, 24, 72").len(), 1);
    for teeth in ["20, 60", "60, -20", "10mm, 30mm"] {
        assert!(told(teeth).is_empty(), "{teeth}");
    }
}
