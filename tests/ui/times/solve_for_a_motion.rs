reuleaux::mechanism! {
    pub mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        body bob { mass = 1kg; center = (0.5m, 0m); inertia = 0kg * 1m2; start angle = -60deg; }
        joint pivot = revolute(ground.position, bob.position);
        freedom swing = bob.angle;
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let state = pendulum.solve(0.5);
}
