reuleaux::mechanism! {
    pub mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        ground { point O = (0m, 0m); }
        body arm { point O = (0m, 0m); point E = (1m, 0m); mass 1kg; inertia = 1kgm2; }
        joint pin = revolute(ground.O, arm.O);
        freedom swing = arm.angle;
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let mut state = pendulum.initial_state().unwrap();
    pendulum.accelerate(&mut state).unwrap();
    let loads = pendulum.loads(&state);
    let _ = [loads.pin().force.x, pendulum.energy(&state).kinetic];
}
