//! A rolling coin: about a centre at rest, like Euler's disk, and along curls.
//!
//! ```text
//! centre at rest      Ω² = 4 g / (a sin α)      Ω: rate of the contact point about the vertical, α: angle of the coin to the table
//! ```
//!
//! Contact is three equations between velocities: they determine no position, and the coin can reach any place on the table. There is no
//! sliding, so that energy is conserved.
//!
//! Source: H. K. Moffatt, Euler's disk and its finite-time singularity, Nature 404, 2000; Ju. I. Neimark and N. A. Fufaev, Dynamics of
//! Nonholonomic Systems.

use std::error::Error;
use std::f64::consts::TAU;

use reuleaux::nalgebra::Vector3;
use reuleaux::picture::Drawable;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::{round, show, steps};

mechanism! {
    /// A thin coin on a table.
    #[picture]
    pub mechanism Coin in space {
        param radius: Length = 100mm;
        /// Angle between coin and table.
        param lean: Angle = 25deg;
        /// Initial angular velocity, in ground.
        param spin_x: AngularVelocity = 0rad_s;
        param spin_y: AngularVelocity = 0rad_s;
        param spin_z: AngularVelocity = 0rad_s;

        let mass = 0.4kg;
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { axis up = (0, 0, 1) from (1, 0, 0); }
        body coin {
            axis own = (0, 0, 1) from (1, 0, 0);
            mass = mass;  inertia = (mass * radius^2 / 4, mass * radius^2 / 4, mass * radius^2 / 2);
            start position = (0mm, 0mm, radius * sin(lean));
            start orientation = turn((0, 1, 0), lean);
        }
        joint contact = rolling_disk(ground.up, coin.position, coin.own, radius);
        freedom spin = coin.angular_velocity from (spin_x, spin_y, spin_z);
    }
}

type State = CoinState<f64>;

/// Angular rate of the contact point about a centre at rest, in rad/s.
fn whirl(m: &Coin) -> f64 {
    (4.0 * 9.81 / (m.radius * m.lean.sin())).sqrt()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("lean °   Ω rad/s   after three rounds the centre is off by mm");
    for lean in [5_f64, 25.0, 60.0] {
        let m = Coin { lean: lean.to_radians(), ..Coin::default() };
        let (omega, sin, cos) = (whirl(&m), m.lean.sin(), m.lean.cos());
        let m = Coin { spin_x: -omega * sin * cos, spin_z: omega * sin * sin, ..m };
        let mut state = m.initial_state()?;
        let start = state.coin().position;
        m.advance(&mut state, 3.0 * TAU / omega, &mut Integrator::new(1e-10))?;
        let off = (state.coin().position - start).norm();
        println!("{lean:6.1}   {omega:7.3}   {:.1e}", 1e3 * off);
        assert!(off < 1e-7, "{off:e} m");
        let axis = state.coin().rotation.column(2).into_owned();
        assert!((axis - Vector3::new(sin, 0.0, cos)).norm() < 1e-7, "{axis}");
    }
    let (coin, curl) = curl()?;
    let energies = curl.iter().map(|state| coin.energy(state)).map(|energy| energy.total());
    let (least, most) = energies.fold((f64::INFINITY, 0.0_f64), |(least, most), energy| (least.min(energy), most.max(energy)));
    println!("a coin that curls keeps {most:.6} J within {:.1e} J", most - least);
    assert!(most - least < 1e-8 * most);
    let view = coin
        .view(curl)
        .title("Rolling coin")
        .outline("coin", round(coin.radius).iter().map(|at| at.push(0.0)))
        .trace("path of the contact", |state| contact(&coin, state))
        .plot("lean", "°", |state| state.coin().rotation[(2, 2)].acos().to_degrees())
        .plot("kinetic energy", "J", |state| coin.energy(state).kinetic)
        .and("potential energy", |state| coin.energy(state).potential)
        .and("their sum", |state| coin.energy(state).total());
    show("rolling_coin", &view, 0, &[50, 100, 150, 200, 250, 300, 350, 400])
}

/// A coin that rolls along and topples.
fn curl() -> Result<(Coin, Vec<State>), Box<dyn Error>> {
    let coin = Coin { lean: 70_f64.to_radians(), spin_x: -6.0, spin_z: -1.0, ..Coin::default() };
    let (mut state, mut integrator) = (coin.initial_state()?, Integrator::new(1e-10));
    let mut curl = Vec::new();
    for time in steps(0.0, 4.0, 400) {
        coin.advance(&mut state, time, &mut integrator)?;
        curl.push(state.clone());
    }
    Ok((coin, curl))
}

/// The point of contact.
fn contact(m: &Coin, state: &State) -> Vector3<f64> {
    let axis = state.coin().rotation.column(2).into_owned();
    let down = (axis * axis.z - Vector3::z()).normalize();
    state.coin().position + down * m.radius
}
