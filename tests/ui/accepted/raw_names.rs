//! A keyword of Rust is a name if it is written as a raw identifier; contextual keywords are names as they are.
reuleaux::mechanism! {
    pub mechanism r#Box {
        param r#type: Length = 100mm;
        body r#async { point r#in = (r#type, 0mm); }
        body union { point auto = (1m, 0m); }
        joint r#move = revolute((0mm, 0mm), r#async.position);
        joint weld = weld(r#async.r#in, union.position);
        drive r#loop = drive_angle(r#async, 60rpm * t);
        output r#yield = union.auto;
        output raw = r#async.r#in;
    }
}

fn main() {
    let mechanism = Box { r#type: 0.2, ..Default::default() };
    let state = mechanism.solve(0.5).unwrap();
    assert!((mechanism.r#yield(&state).value.x + 1.2).abs() < 1e-12 && (mechanism.raw(&state).value.x + 0.2).abs() < 1e-12);
    assert!((state.r#async().angle - state.union().angle).abs() < 1e-12);
}
