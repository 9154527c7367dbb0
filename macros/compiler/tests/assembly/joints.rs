//! Declared starts of joints in space: the assembly that they choose, and how far it is from them.

use crate::{accepted, spatial_four_bar, start};

#[test]
fn a_declared_angle_of_a_joint_decides_between_assemblies() {
    // The triangle of 300 mm, 350 mm and 300 mm: the angles at the pivot and at the joint between coupler and rocker.
    let [at_pivot, at_joint] = [(0.3_f64 * 0.3 + 0.3 * 0.3 - 0.35 * 0.35) / (2.0 * 0.3 * 0.3), 0.35 / (2.0 * 0.3)].map(f64::acos);
    let rocker = std::f64::consts::PI - at_pivot;
    for (declared, side) in [
        ("start c.angle = 110deg;", 1.0),
        ("start c.angle = -70deg;", -1.0),
        ("start b.angle = 30deg;", 1.0),
        ("start b.angle = -0.5rad;", -1.0),
        ("let bend = 40deg; start c.angle = 3 * bend;", 1.0),
        ("start b.angle = 50deg; start c.angle = 100deg; start o.angle = 10deg;", 1.0),
    ] {
        let compiled = accepted(&spatial_four_bar(0.0, "", declared));
        let (found, coupler) = (start(&compiled, "rocker.angle"), start(&compiled, "coupler.angle"));
        assert!((found - side * rocker).abs() < 1e-12, "{found} for {declared}");
        assert!((coupler - side * at_joint).abs() < 1e-12, "{coupler} for {declared}");
        assert!(compiled.model.doubts.is_empty() && compiled.assembly.warnings.is_empty(), "{declared}");
    }
}

#[test]
fn a_declared_displacement_of_a_joint_decides_between_assemblies() {
    for (declared, wanted) in [("150mm", 0.4), ("-150mm", -0.2)] {
        let compiled = accepted(&format!(
            "mechanism SliderCrank in space {{
                ground {{ axis x = (1, 0, 0); axis z = (0, 0, 1); }}
                body crank {{ axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); }}
                body slide {{ axis x = (1, 0, 0); }}
                joint o = revolute(ground.position, ground.z, crank.position, crank.z);
                joint s = translational(ground.position, ground.x, slide.position, slide.x);
                joint r = distance(crank.A, slide.position, 300mm);
                start s.displacement = {declared};
                drive d = drive_rotation(o, 1rad_s * t);
            }}"
        ));
        assert!((start(&compiled, "slide.x") - wanted).abs() < 1e-12, "{} for {declared}", start(&compiled, "slide.x"));
    }
}

/// Also where it is that of a joint that closes a loop, of which no coordinate is the angle.
#[test]
fn a_declared_angle_far_from_the_assembly_is_told() {
    let doubts = |declared: &str| -> Vec<String> {
        let compiled = accepted(&spatial_four_bar(0.0, "", declared));
        compiled.assembly.warnings.iter().map(|warning| warning.doubt.to_string()).collect()
    };
    let help = "help: write `start c.angle = 109deg;`, or `#[allow(far_start)]` before the mechanism";
    let told = |declared: &str, apart: &str| {
        vec![format!("the nearest assembly has `c.angle` at 108.6°, {apart} from its declared start at {declared}\n{help}")]
    };
    assert_eq!(doubts("start c.angle = 109deg;"), Vec::<String>::new());
    assert_eq!(doubts("start c.angle = 40deg;"), told("40°", "68.63°"));
    // A unit is missing: 110 rad are 6303°.
    let doubt = doubts("start c.angle = 110;").concat();
    assert!(doubt.ends_with("\nhelp: write `start c.angle = 110deg;`, or `#[allow(far_start)]` before the mechanism"), "{doubt}");
    assert_eq!(doubts("start b.angle = 50deg; start o.angle = 0deg; start c.angle = 160deg;"), told("160°", "51.37°"));
}
