//! Errors as a program that ends with them shows them.

use reuleaux::{Mechanism, Stopped, mechanism};

mechanism! {
    mechanism Lever {
        param length: Length = 1m;
        ground { axis rail = (1, 0); }
        body near   { point A = (length, 0);  start angle = 60deg; }
        body far    { point B = (length, 0);  start angle = -60deg; }
        body slider { }
        joint o = revolute(ground.position, near.position);
        joint a = revolute(near.A, far.position);
        joint b = revolute(far.B, slider.position);
        joint rail = translational(ground.rail, ground.position, slider.position);
        drive push = drive_x(slider.position, 1m + 0.5m_s * t);
    }
}

#[test]
fn a_failure_is_its_sentence() {
    let failure = Lever::default().solve(3.0).unwrap_err();
    assert_eq!(format!("{failure:?}"), failure.to_string());
    assert!(failure.to_string().starts_with("`Lever` is at a dead point or change point at t = "), "{failure}");
    // As a `main` that returns it does.
    let ended: Result<(), LeverFailure> = Err(failure);
    assert!(format!("{ended:?}").starts_with("Err(`Lever` is at a dead point"));
}

#[test]
fn its_fields_are_shown_on_lines_of_their_own() {
    let shown = format!("{:#?}", Lever::default().solve(3.0).unwrap_err());
    for field in ["Failure {", "    mechanism: \"Lever\",", "    cause: Singular {", "    last: Some("] {
        assert!(shown.contains(field), "{field} in {shown}");
    }
}

#[test]
fn reasons_of_other_kinds_are_sentences_too() {
    let stopped = Stopped::StepTooShort { time: 0.5 };
    assert_eq!(format!("{stopped:?}"), stopped.to_string());
    let lever = Lever::default();
    let mut state = lever.solve(0.0).expect("it closes");
    state.0.q[2] += 0.5;
    let doubt = lever.certify(&state).unwrap_err();
    assert_eq!(format!("{doubt:?}"), doubt.to_string());
}
