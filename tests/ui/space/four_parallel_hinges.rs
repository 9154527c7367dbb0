reuleaux::mechanism! {
    pub mechanism FourBar in space {
        ground       { axis z = (0, 0, 1);  point C = (400mm, 0mm, 0mm); }
        body crank   { axis z = (0, 0, 1);  point A = (100mm, 0mm, 0mm); }
        body coupler { axis z = (0, 0, 1);  point B = (350mm, 0mm, 0mm); }
        body rocker  { axis z = (0, 0, 1);  point B = (300mm, 0mm, 0mm);  start orientation = turn((0, 0, 1), 70deg); }
        joint o = revolute(ground.position, ground.z, crank.position, crank.z);
        joint a = revolute(crank.A, crank.z, coupler.position, coupler.z);
        joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
        joint b = revolute(coupler.B, coupler.z, rocker.B, rocker.z);
        drive input = drive_rotation(o, 60rpm * t);
    }
}

fn main() {
    let state = FourBar::default().solve(0.5).unwrap();
    let _ = state.rocker().orientation();
}
