//! Pages for the browser test, with their sizes.
//!
//! In: a folder. Out: a page and an animated SVG of each mechanism in this folder, and the frames of the four-bar.

use std::error::Error;
use std::path::Path;
use std::time::Instant;
use std::{env, fs};

use reuleaux::picture::Drawable;
use reuleaux::view::View;
use reuleaux::{Integrator, mechanism};
use reuleaux_examples::steps;

mechanism! {
    /// A Grashof crank-rocker.
    #[picture]
    mechanism FourBar {
        ground { point O = (0mm, 0mm);  point C = (100mm, 0mm); }
        body crank   { point A = (40mm, 0mm); }
        body coupler { point B = (120mm, 0mm);  point P = (60mm, 45mm); }
        body rocker  { point B = (80mm, 0mm);  start angle = 60deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, 15rpm * t);
        output P = coupler.P;
    }
}

mechanism! {
    /// An engine.
    #[picture]
    mechanism SliderCrank {
        ground { axis bore = (1, 0); }
        body crank  { point A = (40mm, 0mm); }
        body rod    { point B = (120mm, 0mm);  start angle = -10deg; }
        body piston { }
        joint main = revolute(ground.position, crank.position);
        joint big_end = revolute(crank.A, rod.position);
        joint small_end = revolute(rod.B, piston.position);
        joint bore = translational(ground.bore, ground.position, piston.position);
        drive motor = drive_angle(crank, 1200rpm * t);
        output travel = piston.position.x;
        output middle = (crank.A + rod.B) / 2;
    }
}

mechanism! {
    /// A platform on six cylinders.
    #[picture]
    mechanism StewartPlatform in space {
        let top = 350mm;
        let phase = 1turn * t / 4s;
        let place = (60mm * sin(phase), 60mm * (1 - cos(phase)), 700mm + 50mm * sin(2 * phase));
        let roll = 15deg * sin(phase);
        let n = unit((1, 2, 2));
        ground {
            for k in 0..3 {
                point B[2 * k] = (600mm * cos(120deg * k - 20deg), 600mm * sin(120deg * k - 20deg), 0mm);
                point B[2 * k + 1] = (600mm * cos(120deg * k + 20deg), 600mm * sin(120deg * k + 20deg), 0mm);
            }
        }
        body platform {
            for k in 0..3 {
                point P[2 * k] = (top * cos(120deg * k - 45deg), top * sin(120deg * k - 45deg), -50mm);
                point P[2 * k + 1] = (top * cos(120deg * k + 45deg), top * sin(120deg * k + 45deg), -50mm);
            }
            start position = (0mm, 0mm, 700mm);
        }
        for k in 0..3 {
            let p[2 * k] = (top * cos(120deg * k - 45deg), top * sin(120deg * k - 45deg), -50mm);
            let p[2 * k + 1] = (top * cos(120deg * k + 45deg), top * sin(120deg * k + 45deg), -50mm);
        }
        for i in 0..6 {
            let end[i] = place + p[i] * cos(roll) + cross(n, p[i]) * sin(roll) + n * dot(n, p[i]) * (1 - cos(roll));
            drive leg[i] = drive_distance(ground.B[i], platform.P[i], norm(end[i] - ground.B[i]));
        }
        output middle = platform.position;
        for i in 0..6 { output length[i] = norm(platform.P[i] - ground.B[i]); }
    }
}

mechanism! {
    /// Four-bars in a row: the rocker of each drives the next.
    #[picture]
    mechanism Chain {
        ground { for i in 0..11 { point G[i] = (i * 100mm, 0mm); } }
        for i in 0..11 { body link[i] { point E = (100mm, 0mm);  start angle = 90deg; } }
        for i in 0..10 { body coupler[i] { point E = (100mm, 0mm); } }
        for i in 0..11 { joint g[i] = revolute(ground.G[i], link[i].position); }
        for i in 0..10 {
            joint a[i] = revolute(link[i].E, coupler[i].position);
            joint b[i] = revolute(coupler[i].E, link[i + 1].E);
        }
        drive motor = drive_angle(link[0], 90deg + 0.9rad * sin(1rad_s * t));
        output end = link[10].E;
    }
}

mechanism! {
    /// A double pendulum: nothing drives it.
    #[picture]
    mechanism DoublePendulum {
        gravity = (0, -9.81m_s2);
        body upper { point E = (300mm, 0mm);  mass = 1kg;  center = (300mm, 0mm);  inertia = 0.001kgm2; }
        body lower { point E = (300mm, 0mm);  mass = 1kg;  center = (300mm, 0mm);  inertia = 0.001kgm2;  start angle = 20deg; }
        joint o = revolute(ground.position, upper.position);
        joint e = revolute(upper.E, lower.position);
        freedom swing = upper.angle from 10deg;
        freedom bend = lower.angle from 20deg;
        output E = lower.E;
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("which folder?")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    let four_bar = four_bar(1000)?;
    write(folder, "four_bar", &four_bar)?;
    self::four_bar(24)?.svg_frames(folder.join("four_bar_frames"))?;
    write(folder, "four_bar_24", &self::four_bar(24)?)?;
    write(folder, "slider_crank", &slider_crank()?)?;
    write(folder, "stewart_platform", &stewart_platform()?)?;
    write(folder, "chain", &chain()?)?;
    write(folder, "double_pendulum", &double_pendulum()?)?;
    write(folder, "gaps", &gaps()?)?;
    let m = FourBar::default();
    write(folder, "one_state", &m.view([m.solve(0.3)?]).plot("rocker", "rad", |state| state.rocker().angle))
}

fn write<S>(folder: &Path, name: &str, view: &View<S>) -> Result<(), Box<dyn Error>> {
    let began = Instant::now();
    let (page, svg) = (view.to_html()?, view.animated_svg()?);
    fs::write(folder.join(name).with_extension("html"), &page)?;
    fs::write(folder.join(name).with_extension("svg"), &svg)?;
    println!("{name:18}  page {:7}  animated SVG {:7} bytes  made in {:.1} s", page.len(), svg.len(), began.elapsed().as_secs_f64());
    Ok(())
}

fn four_bar(states: u32) -> Result<View<FourBarState<f64>>, Box<dyn Error>> {
    let m = FourBar::default();
    let turn: Vec<_> = m.sweep(steps(0.0, 4.0, states - 1)).collect::<Result<_, _>>()?;
    let view = m.view(turn).title("Four-bar").trace("path of P", |state| m.P(state).value);
    let view = view.plot("rocker angle", "°", |state| state.rocker().angle.to_degrees());
    Ok(view.plot("rocker velocity", "rad/s", |state| state.rocker().angular_velocity))
}

/// A view over an abscissa other than time, with missing, NaN, tiny and huge values.
fn gaps() -> Result<View<FourBarState<f64>>, Box<dyn Error>> {
    let m = FourBar::default();
    let turn: Vec<_> = m.sweep(steps(0.0, 4.0, 99)).collect::<Result<_, _>>()?;
    let view = m.view(turn).title("Gaps & <limits>").over("crank", "°", |state| state.crank().angle.to_degrees()).lasting(3.0);
    let view = view.plot("root", "", |state| (state.rocker().angle - 1.5).sqrt()).and("nothing", |_| f64::NAN);
    Ok(view.plot("tiny", "m", |state| 1e-12 * state.rocker().angle).plot("huge", "Pa", |state| 2e11 * state.rocker().angle))
}

fn slider_crank() -> Result<View<SliderCrankState<f64>>, Box<dyn Error>> {
    let m = SliderCrank::default();
    let turn: Vec<_> = m.sweep(steps(0.0, 0.05, 180)).collect::<Result<_, _>>()?;
    let view = m.view(turn).title("Slider-crank").trace("middle of the rod", |state| m.middle(state).value);
    let formula = |state: &SliderCrankState<f64>| {
        let (sine, cosine) = state.crank().angle.sin_cos();
        40.0 * cosine + (120.0_f64.powi(2) - (40.0 * sine).powi(2)).sqrt()
    };
    let view = view.plot("travel", "mm", |state| 1e3 * m.travel(state).value).against("formula", formula);
    let view = view.plot("speed", "m/s", |state| m.travel(state).rate);
    Ok(view.plot("acceleration", "m/s²", |state| m.travel(state).acceleration))
}

fn stewart_platform() -> Result<View<StewartPlatformState<f64>>, Box<dyn Error>> {
    let m = StewartPlatform::default();
    let motion: Vec<_> = m.sweep(steps(0.0, 4.0, 240)).collect::<Result<_, _>>()?;
    let view = m.view(motion).title("Stewart platform").trace("middle", |state| m.middle(state).value);
    let view = view.plot("leg 0", "mm", |state| 1e3 * m.length(state)[0].value).and("leg 1", |state| 1e3 * m.length(state)[1].value);
    Ok(view.and("leg 2", |state| 1e3 * m.length(state)[2].value).and("leg 3", |state| 1e3 * m.length(state)[3].value))
}

fn chain() -> Result<View<ChainState<f64>>, Box<dyn Error>> {
    let m = Chain::default();
    let motion: Vec<_> = m.sweep(steps(0.0, std::f64::consts::TAU, 600)).collect::<Result<_, _>>()?;
    let view = m.view(motion).title("Chain of ten four-bars").trace("end", |state| m.end(state).value);
    Ok(view
        .plot("last link", "°", |state| state.link()[10].angle.to_degrees())
        .plot("its rate", "rad/s", |s| s.link()[10].angular_velocity))
}

fn double_pendulum() -> Result<View<DoublePendulumState<f64>>, Box<dyn Error>> {
    let m = DoublePendulum::default();
    let mut integrator = Integrator::new(1e-10);
    let mut state = m.initial_state()?;
    let mut states = vec![state.clone()];
    for time in steps(0.0, 6.0, 360).skip(1) {
        m.advance(&mut state, time, &mut integrator)?;
        states.push(state.clone());
    }
    let view = m.view(states).title("Double pendulum").trace("end", |state| m.E(state).value);
    let view = view.plot("kinetic", "J", |state| m.energy(state).kinetic).and("potential", |state| m.energy(state).potential);
    Ok(view.plot("upper", "rad", |state| state.upper().angle).and("lower", |state| state.lower().angle))
}
