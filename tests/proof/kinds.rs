//! Enclosures for every path of the solver: large blocks, redundant joints, tables and Rust functions, slices, `f32`, hand-written
//! equations, long chains.

use reuleaux::nalgebra::{SMatrix, SVector};
use reuleaux::{Doubt, Enclosure, Equations, Family, Mechanism, Real, Stages, State};
use reuleaux_tests::blocks::*;
use reuleaux_tests::common::twofold::Twofold;
use reuleaux_tests::mechanisms::FourBarCrankRocker;

/// q, q̇ and q̈ with twice the digits, from all equations at once.
fn exact<E: Equations<Twofold, N, N>, const N: usize>(mechanism: &E, state: &State<f64, N>) -> [SVector<Twofold, N>; 3] {
    let t = Twofold::of(state.t);
    let mut q = state.q.map(Twofold::of);
    for _ in 0..4 {
        let (phi, jacobian) = mechanism.linearize(&q, t);
        let correction = solution(jacobian, phi);
        q = SVector::from_fn(|i, _| q[i] - correction[i]);
    }
    let jacobian = mechanism.jacobian(&q, t);
    let qd = solution(jacobian, mechanism.nu(&q, t));
    let qdd = solution(jacobian, mechanism.gamma(&q, &qd, t));
    [q, qd, qdd]
}

/// x of A x = b by elimination with pivots from the column.
fn solution<const N: usize>(mut a: SMatrix<Twofold, N, N>, mut b: SVector<Twofold, N>) -> SVector<Twofold, N> {
    for k in 0..N {
        let pivot = (k..N).fold(k, |best, i| if a[(i, k)].high.abs() > a[(best, k)].high.abs() { i } else { best });
        a.swap_rows(k, pivot);
        b.swap_rows(k, pivot);
        for i in k + 1..N {
            let multiplier = a[(i, k)] / a[(k, k)];
            for j in k..N {
                a[(i, j)] = a[(i, j)] - multiplier * a[(k, j)];
            }
            b[i] = b[i] - multiplier * b[k];
        }
    }
    for k in (0..N).rev() {
        let known = (k + 1..N).fold(b[k], |rest, j| rest - a[(k, j)] * b[j]);
        b[k] = known / a[(k, k)];
    }
    b
}

/// Asserts that bounds equal the true errors up to about 1e-20 of the largest entry, at some instants of a motion.
fn is_bounded<M, const N: usize>(name: &str)
where
    M: Default + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
    M::Over<Twofold>: Equations<Twofold, N, N>,
{
    let mechanism = M::default();
    let twofold = M::gather([&mechanism], |[parameter]| Twofold::of(parameter));
    for found in mechanism.sweep((0..4).map(|k| f64::from(k) * 0.01)) {
        let state = found.unwrap_or_else(|failure| panic!("{name}: {failure}"));
        let bound = mechanism.certify(&state).unwrap_or_else(|doubt| panic!("{name}: {doubt}")).within;
        let exact = exact(&twofold, &state);
        for ((found, bound), exact) in [(state.q, bound.q), (state.qd, bound.qd), (state.qdd, bound.qdd)].iter().zip(exact) {
            let size = exact.iter().map(|entry| entry.high.abs()).fold(1.0, f64::max);
            for i in 0..N {
                let error = (Twofold::of(found[i]) - exact[i]).high.abs();
                assert!((bound[i] - error).abs() <= 1e-20 * size, "{name}: {i} is off by {error:e}, bound {:e}", bound[i]);
            }
        }
    }
}

#[test]
fn blocks_of_two_to_twelve_unknowns() {
    is_bounded::<Loop, _>("a four-bar");
    is_bounded::<Plate, _>("a plate");
    is_bounded::<TwoPlates, _>("two plates");
    is_bounded::<FourPlates, _>("four plates");
    is_bounded::<TenPlates, _>("ten plates");
    is_bounded::<Triad, _>("a triad");
    is_bounded::<DoubleTriad, _>("a double triad");
}

reuleaux::mechanism! {
    /// A parallelogram with a third crank in the middle.
    mechanism Coupled {
        param middle: Length = 500mm;
        ground { point A = (0m, 0m);  point B = (2m, 0m);  point C = (0.8m, 0m); }
        body crank  { point P = (500mm, 0mm); }
        body rod    { point Q = (2m, 0m);  point R = (0.8m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        body third  { point P = (middle, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        joint e = revolute(ground.C, third.position);
        redundant joint f = revolute(rod.R, third.P);
        drive input = drive_angle(crank, 60deg + 2rad_s * t);
    }
}

#[test]
fn redundant_joints_have_to_hold() {
    let mechanism = Coupled::default();
    let state = mechanism.solve(0.1).expect("a third crank as long as the others");
    assert!(mechanism.certify(&state).expect("a solution").radius < 1e-15);
    for longer in [1e-12, 1e-6, 1e-3] {
        let bent = Coupled { middle: 0.5 + longer };
        assert!(matches!(bent.certify(&state), Err(Doubt::DoesNotHold(row)) if row.joint == "f"), "{longer}");
    }
}

/// A law that exists for doubles only.
pub(crate) fn measured<T: Real>(x: T) -> (T, T, T) {
    x.map(|x| (0.3 + 0.1 * x.sin(), 0.1 * x.cos(), -0.1 * x.sin()))
}

reuleaux::mechanism! {
    /// A follower on a measured cam, and one on a cam between given points.
    mechanism Cams {
        ground { axis up = (0, 1);  point O = (0, 0);  point P = (1, 0); }
        body cam { }
        body first  { }
        body second { }
        joint o = revolute(ground.O, cam.position);
        joint one = translational(ground.up, ground.O, first.position);
        joint two = translational(ground.up, ground.P, second.position);
        joint lift = { second.y == table(cam.angle, [(0, 0.1), (1, 0.2), (2, 0.15), (3, 0.1)], periodic) * 1m; }
        drive turn = drive_angle(cam, 1rad_s * t);
        drive law = { first.y == crate::kinds::measured(cam.angle) * 1m; }
    }
}

#[test]
fn a_measured_law_is_bounded_and_not_proven() {
    let cams = Cams::default();
    for step in 0..60 {
        let state = cams.solve(f64::from(step) * 0.1).expect("cams always close");
        let bound = cams.error_bound(&state).expect("a bound");
        assert!(bound.q.amax() < 1e-15 && bound.qd.amax() < 1e-14 && bound.qdd.amax() < 1e-13, "{step}: {bound:?}");
        // The angle is 1 · t, which need not be a double; only a follower whose angle is taken from the drive itself is proven.
        match cams.certify(&state) {
            Ok(certificate) => assert!(certificate.radius < 1e-15),
            Err(doubt) => assert!(matches!(doubt, Doubt::Unproven(of) if of.body == "first"), "{doubt}"),
        }
    }
}

#[test]
fn single_precision_is_bounded_by_its_errors() {
    let (coarse, fine) = (FourBarCrankRocker::<f32>::with_defaults(), FourBarCrankRocker::<f64>::default());
    for step in 0..20 {
        let t = step as f32 * 0.05;
        let state = coarse.solve(t).expect("it closes");
        let mut exact = fine.solve(f64::from(t)).expect("it closes");
        fine.polish(&mut exact.0).expect("it can be polished");
        let certificate = coarse.certify(&state).expect("a solution is near");
        let each = [
            (&state.q, &exact.q, &certificate.within.q),
            (&state.qd, &exact.qd, &certificate.within.qd),
            (&state.qdd, &exact.qdd, &certificate.within.qdd),
        ];
        for (found, exact, bound) in each {
            for i in 0..found.len() {
                let error = (f64::from(found[i]) - exact[i]).abs();
                let bound = f64::from(bound[i]);
                // The parameters of `coarse` are rounded once more than those of `fine`.
                assert!((bound - error).abs() <= 1e-5 * (1.0 + exact[i].abs()), "{i} at {t}: {error:e} and {bound:e}");
            }
        }
        let mut polished = state.clone();
        coarse.polish(&mut polished.0).expect("it can be polished");
        assert!(coarse.error_bound(&polished).expect("a bound").q.amax() <= f32::EPSILON);
    }
}

reuleaux::mechanism! {
    /// Many four-bars in a row, each rocker the crank of the next.
    mechanism Chain {
        ground { point O = (0, 0); }
        for i in 0..=80 { body link[i] { point P = (0, 0);  point Q = (1m, 0);  start angle = 90deg; } }
        for i in 0..80 { body coupler[i] { point P = (0, 0);  point Q = (1m, 0);  start position = (i * 1m, 1m); } }
        for i in 0..=80 { joint foot[i] = revolute((i * 1m, 0m), link[i].P); }
        for i in 0..80 { joint left[i] = revolute(link[i].Q, coupler[i].P);  joint right[i] = revolute(coupler[i].Q, link[i + 1].Q); }
        drive input = drive_angle(link[0], 90deg + 0.8rad * sin(1rad_s * t));
        slice output tip = link[80].Q;
    }
}

#[test]
fn a_long_chain_does_as_its_first_link() {
    let chain = Chain::default();
    let mut state = chain.solve(0.3).expect("parallelograms close");
    // Every link has the angle of the first: the enclosure may grow only slightly along the chain.
    let certificate = chain.certify(&state).expect("a solution");
    let (first, last) = (certificate.within.q[2], certificate.within.q[2 + 3 * 80]);
    assert!(certificate.radius < 1e-12 && first < 1e-15 && last < 1e-12, "{} {first:e} {last:e}", certificate.radius);
    chain.polish(&mut state.0).expect("it can be polished");
    let angle = state.q[2];
    assert!((0..=80).all(|i| state.link()[i].angle == angle && state.link()[i].angular_velocity == state.link()[0].angular_velocity));
    // A slice of the mechanism.
    let tip = chain.solve_for_tip();
    let state = tip.solve(0.3).expect("parallelograms close");
    assert!(tip.certify(&state).expect("a solution").radius < 1e-12);
}

#[test]
fn nothing_is_said_of_nonsense() {
    let (mechanism, nothing) = (FourBarCrankRocker::<f64>::default(), f64::NAN);
    let good = mechanism.solve(0.1).expect("it closes").0;
    for bad in [nothing, f64::INFINITY, f64::NEG_INFINITY, 1e300, 1e-310] {
        let moved = |change: &dyn Fn(&mut State<f64, 9>)| {
            let mut state = good.clone();
            change(&mut state);
            (mechanism.certify(&state).map(|certificate| certificate.radius), mechanism.polish(&mut state), state)
        };
        let (certified, polished, left) = moved(&|state| state.t = bad);
        let is_a_time = bad == 1e-310;
        assert!(certified.is_err() || is_a_time, "at {bad}: {certified:?}");
        assert!(polished.is_ok() == certified.is_ok() && (polished.is_ok() || left.q == good.q), "at {bad}");
        for index in 0..9 {
            // A computed coordinate may be enclosed with a radius as large as its error.
            let (certified, ..) = moved(&|state| state.q[index] = bad);
            assert!(certified.is_err() || certified.is_ok_and(|radius| radius >= 1e299 || bad == 1e-310), "{index} at {bad}");
        }
    }
    let broken = FourBarCrankRocker { speed: nothing, ..mechanism };
    assert_eq!(broken.certify(&good), Err(Doubt::ParameterOutOfRange("speed")));
}
