//! Parts beside an imported constraint, and an unused component.

mod joints {
    reuleaux::constraint! {
        /// A point stays at a height.
        pub constraint at_height(P: Point, h: Length) { P.y == h; }
    }
}

reuleaux::mechanism! {
    pub mechanism Ladders {
        use crate::joints::at_height;
        for i in 0..2 { for j in 0..3 { part ladder[i][j] = Ladder(5m + 1m * i, j); } }
        component Ladder(length: Length, number: Number) {
            body ladder { point foot = (0m, 0m);  point top = (0m, length);  start angle = 20deg; }
            joint floor = at_height(ladder.foot, 0m);
            joint wall = absolute_x(ladder.top, number * 10m);
            drive slip = drive_x(ladder.foot, 2m + number * 10m + 100mm_s * t);
            output top[0] = ladder.top;
            output top[1] = ladder.foot;
        }
        component Unused(P: Point) { part more = Ladder(1m, 2); }
    }
}

fn main() {
    let mechanism = Ladders::default();
    let state = mechanism.solve(10.0).unwrap();
    let ladders: [[LaddersStateLadder<'_>; 3]; 2] = state.ladder();
    assert!((ladders[0][2].ladder().angular_velocity - 0.1 / 4.0).abs() < 1e-15);
    assert!((mechanism.ladder_top(&state)[0][1][0].value.y - 4.0).abs() < 1e-15);
}
