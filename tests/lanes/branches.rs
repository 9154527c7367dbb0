//! Branches of `if` are computed where they hold, in one lane at least.

use reuleaux::{Real, mechanism};
use reuleaux_wide::{F64x4, Lockstep};
use std::cell::Cell;

thread_local! {
    static CALLS: Cell<[usize; 2]> = const { Cell::new([0, 0]) };
}

fn count<T: Real>(branch: usize, t: T) -> (T, T, T) {
    let mut calls = CALLS.take();
    calls[branch] += 1;
    CALLS.set(calls);
    let (sin, cos) = t.sin_cos();
    if branch == 0 { (sin, cos, -sin) } else { (cos, -sin, -cos) }
}

fn early<T: Real>(t: T) -> (T, T, T) {
    count(0, t)
}

fn late<T: Real>(t: T) -> (T, T, T) {
    count(1, t)
}

mechanism! {
    /// A slide that follows the one law in the first second, and the other one from then on.
    mechanism Relay {
        function before(Time) -> Length = early;
        function after(Time) -> Length = late;
        body slide { point P = (0m, 0.1m); start x = 0m; }
        joint guide = translational((1, 0), (0m, 0.1m), slide.P);
        drive law = drive_x(slide.position, if t < 1s { before(t) } else { after(t) });
    }
}

/// What a step at these times calls.
fn calls(together: &mut Lockstep<Relay, F64x4, 4, 3>, times: [f64; 4]) -> [bool; 2] {
    CALLS.set([0, 0]);
    together.advance(times);
    CALLS.take().map(|calls| calls > 0)
}

#[test]
fn one_branch_is_called_alone() {
    let relay = Relay::default();
    let mut state = relay.solve(0.0).expect("a state");
    for (t, expected) in [(0.5, [true, false]), (1.5, [false, true])] {
        relay.advance(&mut state, t - 0.1).expect("a state");
        CALLS.set([0, 0]);
        relay.advance(&mut state, t).expect("a state");
        assert_eq!(CALLS.take().map(|calls| calls > 0), expected);
        let (value, rate, _) = if t < 1.0 { early(t) } else { late(t) };
        assert_eq!((state.slide().position.x, state.slide().velocity.x), (value, rate));
    }
}

#[test]
fn lanes_call_what_one_of_them_needs() {
    let relay = Relay::default();
    let mut together = Lockstep::<Relay, F64x4, 4, 3>::new([relay; 4], [0.0; 4]);
    assert_eq!(calls(&mut together, [0.1, 0.2, 0.3, 0.4]), [true, false]);
    let times = [0.5, 1.5, 0.6, 1.0];
    assert_eq!(calls(&mut together, times), [true, true]);
    for (lane, t) in times.into_iter().enumerate() {
        let (found, alone) = (together.lane(lane).expect("a state"), relay.solve(t).expect("a state"));
        assert_eq!((found.q, found.qd, found.qdd), (alone.q, alone.qd, alone.qdd));
    }
    together.advance([1.1, 1.6, 1.2, 1.3]);
    assert_eq!(calls(&mut together, [1.2, 1.7, 1.3, 1.4]), [false, true]);
}
