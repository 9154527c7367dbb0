//! A mechanism item by item, with a parameter, `let`s and a function among the items.

/// Items of a declaration in some order.
pub(super) fn declaration(items: &[&str]) -> String {
    format!("pub mechanism Loader {{ {} }}", items.join("\n"))
}

/// All items, in the usual order.
pub(super) fn items() -> Vec<&'static str> {
    [&OTHERS[..], &BODIES[..], &JOINTS[..]].concat()
}

/// Values of the parameters with these names, in order.
pub(super) fn values(names: &[String]) -> Vec<f64> {
    names.iter().map(|name| if name.starts_with("reach") { 1.3 } else { 0.4 }).collect()
}

/// A loader's boom with its cylinder and a link.
pub(super) const BODIES: [&str; 4] = [
    "body boom { point P = (0, 0); point L = (reach, -0.15); point K = (1.5, 0.2); start angle = -0.04; }",
    "body barrel { point L = (0, 0); axis along = (1, 0); start position = (0.1, -0.9); start angle = 0.57; }",
    "body rod { point L = (0, 0); start position = (1.19, -0.2); start angle = 0.57; }",
    "body link { point K = (0, 0); point E = (0.5, 0); start angle = 1.2; }",
];
/// Joints and drives of the loader.
pub(super) const JOINTS: [&str; 7] = [
    "joint p = revolute(ground.P, boom.P);",
    "joint l1 = revolute(ground.L, barrel.L);",
    "joint l2 = revolute(boom.L, rod.L);",
    "joint cylinder = translational(barrel.along, barrel.L, rod.L);",
    "drive lifting = drive_distance(ground.L, boom.L, length(phase));",
    "joint k = revolute(boom.K, link.K);",
    "drive tilting = drive_relative_angle(boom, link, 1.2 + swing * sin(speed * t));",
];
/// All other items.
pub(super) const OTHERS: [&str; 8] = [
    "ground { point P = (0, 0); point L = (0.1, -0.9); }",
    "param reach: Length = 1.2;",
    "param swing: Angle = 20deg;",
    "let speed = 1.6rad_s;",
    "let phase = 0.8rad_s * t - 1;",
    "let stroke: Length = reach / 4;",
    "function length(angle: Angle) -> Length = 1.55m + stroke * sin(angle);",
    "output tip = link.E - ground.P;",
];
