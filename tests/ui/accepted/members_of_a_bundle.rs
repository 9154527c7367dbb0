#![deny(warnings)]
//! A bundle can be used as a whole or member by member, from this crate and from another.

mod own {
    reuleaux::constraint! {
        /// Two places.
        pub(crate) bundle places {
            constraint at_x(P: Point, x: Length) { P.x == x; }
            constraint at_y(P: Point, y: Length) { P.y == y; }
        }
    }
}

reuleaux::mechanism! {
    pub mechanism Stand {
        use elsewhere::columns::{below, left_of as beside};
        use crate::own::places::at_x;
        body foot {}
        body head {}
        joint level = absolute_angle(foot, 0);
        joint upright = absolute_angle(head, 0);
        joint place = at_x(foot.position, 1m);
        joint ground_ = absolute_y(foot.position, 2m);
        joint column = below(foot.position, head.position, 3m);
        joint over = beside(foot.position, head.position, 4m);
    }
}

fn main() {
    let stand = Stand::default().solve(0.0).unwrap();
    assert_eq!((stand.head().position.x, stand.head().position.y), (5.0, 5.0));
}
