//! Cams that cannot be made, against closed forms.

use crate::accepted;

/// Warnings about the cams of a mechanism.
fn told(contact: &str, law: &str) -> Vec<String> {
    let source = format!(
        "mechanism C {{
            body cam {{ }}
            body follower {{ axis n = (0, 1); start position = (0mm, 60mm); }}
            joint shaft = revolute(ground.position, cam.position);
            joint guide = translational((0, 1), (0mm, 0mm), follower.position);
            function law(psi: Angle) -> Length = {law};
            joint contact = {contact};
            drive motor = drive_angle(cam, 60rpm * t);
        }}"
    );
    accepted(&source).motion.flaws.iter().map(|warning| warning.doubt.to_string()).collect()
}

/// r = c + A cos n ψ: at the crest the radius of curvature is (c + A)² / (c + A (1 + n²)).
#[test]
fn a_roller_that_is_larger_than_its_crest_is_told() {
    let of = |roller: f64| {
        let law = format!("{}mm - {roller}mm + 3mm * cos(4 * psi)", 50.0);
        told(&format!("cam_roller(cam.position, follower.position, {roller}mm, law)"), &law)
    };
    let crest = 53.0_f64.powi(2) / (50.0 + 3.0 * 17.0);
    assert!(of(crest - 0.001).is_empty());
    assert_eq!(
        of(30.0),
        [format!(
            "the cam of `contact` is undercut at ψ = -180°: its pitch curve has a radius of {:.3} mm there, the roller one of 30 mm\n\
             help: take a larger base circle, a smaller roller or a longer rise",
            crest
        )]
    );
    assert_eq!(of(crest + 0.001).len(), 1);
}

/// h = c + A cos n ψ: h + h″ = c − A (n² − 1) cos n ψ.
#[test]
fn a_face_that_would_cut_into_its_cam_is_told() {
    let of = |least: f64| told("cam_flat(cam.position, follower.position, follower.n, law)", &format!("{least}mm + 2mm * cos(3 * psi)"));
    assert!(of(16.001).is_empty());
    assert_eq!(
        of(12.0),
        ["the cam of `contact` is not convex at ψ = -120°, and its face would cut into it: the radius of the outline is -4 mm there\n\
          help: take a larger base circle or a longer rise"]
    );
}

/// A circle about a point beside its centre, with the normal of the face towards the cam and away from it; a law for a part of a turn.
#[test]
fn a_circle_is_no_matter_whichever_way_its_face_looks() {
    let of = |law: &str| told("cam_flat(cam.position, follower.position, follower.n, law)", law);
    assert!(of("60mm + 20mm * cos(psi)").is_empty());
    assert!(of("-60mm - 20mm * cos(psi)").is_empty());
    assert!(of("60mm + 20mm / 1rad^2 * (psi - 90deg)^2").is_empty());
}

/// Segments: a rise of 30 mm within 40° on a base circle of 20 mm, and the same on 200 mm.
#[test]
fn a_rise_that_is_too_steep_is_told() {
    let of = |base: f64| {
        let law = format!(
            "segments(wrap(-psi), {base}mm, [rise(30mm, 40deg, cycloidal), dwell(80deg), fall(30mm, 120deg, cycloidal), dwell(120deg)], periodic)"
        );
        told("cam_roller(cam.position, follower.position, 15mm, law)", &law)
    };
    assert_eq!(of(20.0).len(), 1);
    assert!(of(200.0).is_empty());
}
