reuleaux::mechanism! {
    pub mechanism Block {
        use elsewhere::stiffening_spring;
        body block { point P = (0m, 0m);  mass = 2kg; }
        joint rail = translational((1, 0), (0m, 0m), block.P);
        force spring = stiffening_spring((0m, 0m), block.P, stiffness: 100N_m, cubic: 0.5);
        freedom slide = block.x from 1m;
    }
}

fn main() {
    let state = Block::<f64>::default().initial_state().unwrap();
    // k x (1 + c x²) / m
    assert_eq!(state.block().acceleration.x, -75.0);
}
