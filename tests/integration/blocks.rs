use reuleaux_tests::blocks::*;
use reuleaux::Mechanism;

#[test]
fn look() {
    macro_rules! look { ($($name:ident)*) => { $(
        println!("{}\n{}", stringify!($name), $name::<f64>::PLAN);
        let mechanism = $name::default();
        for (k, state) in mechanism.sweep((0..60).map(|k| f64::from(k) / 10.0)).enumerate() {
            match state { Ok(state) => if k % 10 == 0 {println!("{} {} {:.1e}", state.t, state.iterations, state.condition) }, Err(e) => println!("{e}") }
        }
    )* } }
    look!(Plate TwoPlates ThreePlates FourPlates SixPlates TenPlates Triad DoubleTriad);
}
