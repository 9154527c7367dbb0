use reuleaux::Integrator;

reuleaux::mechanism! {
    pub mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        body bar { mass = 1kg; center = (300mm, 0mm); inertia = 0.03kgm2; }
        joint pivot = revolute(ground.position, bar.position);
        freedom swing = bar.angle from -30deg;
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let _ = pendulum.sweep(&[0, 1, 2], Integrator::new(1e-9));
}
