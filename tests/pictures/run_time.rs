//! Pictures drawn by programs: at the start equal to those of the pages, and consistent over a motion.

use std::error::Error;

use reuleaux::picture::{Drawable, Scene, Undrawable, animation, frames};
use reuleaux::{Integrator, State};

/// A mechanism and the text of its declaration.
macro_rules! declared {
    ($name:ident { $($tokens:tt)* }) => {
        mod $name {
            reuleaux::mechanism! { $($tokens)* }
            pub(super) const TEXT: &str = stringify!($($tokens)*);
        }
    };
}

mod listed {
    reuleaux::mechanism! {
        /// Outputs of several units and components.
        #[picture]
        #[outputs]
        pub mechanism Listed {
            body crank { point A = (50mm, 0mm); }
            joint axle = revolute(ground.position, crank.position);
            drive motor = drive_angle(crank, 60rpm * t);
            output angle = crank.angle;
            output pin = crank.A;
            output share = crank.A.x / 50mm;
            output speed = crank.angular_velocity;
            output pose = crank;
        }
    }
}

declared!(engine {
    #[picture]
    pub mechanism Engine {
        param crank_length: Length = 40mm;
        param rod_length: Length = 120mm;
        ground { point O = (0mm, 0mm); axis bore = (1, 0); }
        body crank { point A = (crank_length, 0mm); }
        body rod { point B = (rod_length, 0mm); start angle = -20deg; }
        body piston { }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, piston.position);
        joint bore = translational(ground.bore, ground.O, piston.position);
        drive motor = drive_angle(crank, 1rad + 60rpm * t);
        output travel = piston.position;
    }
});

declared!(valve {
    #[picture]
    pub mechanism Valve {
        param radius: Length = 30mm;
        param lift: Length = 8mm;
        function profile(psi: Angle) -> Length = radius + lift * cos(psi);
        function measured(psi: Angle) -> Length = table(psi, [(0deg, 40mm), (90deg, 36mm), (180deg, 32mm), (270deg, 36mm), (360deg, 40mm)], periodic);
        ground { point O = (0mm, 0mm); point P = (150mm, 0mm); axis up = (0, 1); }
        body cam { }
        body follower { point top = (0mm, 60mm); start position = (0mm, 45mm); }
        body disc { }
        body knife { start position = (150mm, 45mm); }
        joint shaft = revolute(ground.O, cam.position);
        joint guide = translational(ground.up, ground.O, follower.position);
        joint touch = cam_roller(cam.position, follower.position, radius / 5, profile);
        joint axle = revolute(ground.P, disc.position);
        joint way = translational(ground.up, ground.P, knife.position);
        joint edge = cam_knife(disc.position, knife.position, measured);
        joint pair = gear_pair(cam, disc, 20, 20);
        drive motor = drive_angle(cam, 0.7rad + 60rpm * t);
        output top = follower.top;
    }
});

declared!(train {
    #[picture]
    pub mechanism Train {
        param teeth: Number = 24;
        ground { point O = (0mm, 0mm); }
        body sun { }
        body ring { }
        body arm { point A = (42mm, 0mm); }
        body planet { }
        joint s = revolute(ground.O, sun.position);
        joint r = revolute(ground.O, ring.position);
        joint k = revolute(ground.O, arm.position);
        joint p = revolute(arm.A, planet.position);
        joint willis = planetary(sun, ring, arm, teeth, 60);
        joint mesh = gear_pair(sun, planet, teeth, 18, carrier: arm);
        drive motor = drive_angle(sun, 1rad_s * t);
        drive brake = drive_angle(ring, 0);
    }
});

declared!(press {
    #[picture]
    pub mechanism Press {
        param reach: Length = 100mm;
        component Lever(side: Number) {
            param arm: Length = 80mm;
            body r#type { point tip = (arm, 0mm); start angle = 45deg; }
            joint pivot = revolute(ground.A, r#type.position);
            drive push = drive_distance(r#type.tip, ground.B, 70mm + 5mm * side + 1mm_s * t);
        }
        ground { point A = (0mm, 0mm); point B = (reach, 0mm); axis along = (1, 0); }
        for i in 0..2 { part lever[i] = Lever(side: i); }
        body slide { }
        joint way = translational(ground.along, ground.A, slide.position);
        drive feed = drive_along(way, 20mm - 3mm_s * t);
    }
});

declared!(across {
    #[picture]
    pub mechanism AcrossCrank in space {
        param speed: AngularVelocity = 60rpm;
        param crank_length: Length = 80mm;
        ground { point O = (0mm, 100mm, 120mm); axis x = (1, 0, 0); }
        body crank { axis x = (1, 0, 0); point A = (0mm, 0mm, crank_length); }
        body rod { point A = (-150mm, 0mm, 0mm); point B = (150mm, 0mm, 0mm); axis y = (0, 1, 0); start position = (100mm, 50mm, 100mm); start orientation = turn((0.9087, -0.0960, -0.4063), 2.7182rad); }
        body slide { axis x = (1, 0, 0); start position = (200mm, 0mm, 0mm); }
        joint axle = revolute(ground.O, ground.x, crank.position, crank.x);
        joint ball = spherical(crank.A, rod.A);
        joint fork = universal(rod.B, rod.y, slide.position, slide.x);
        joint rail = translational(ground.position, ground.x, slide.position, slide.x);
        drive motor = drive_rotation(axle, speed * t);
        output stroke = slide.position;
    }
});

declared!(arm {
    #[picture]
    pub mechanism Arm in space {
        param reach: Length = 400mm;
        ground { axis z = (0, 0, 1); axis y = (0, 1, 0); }
        body column { axis z = (0, 0, 1); axis y = (0, 1, 0); point S = (0mm, 0mm, 300mm); }
        body boom { axis y = (0, 1, 0); axis x = (1, 0, 0); point E = (reach, 0mm, 0mm); start position = (0mm, 0mm, 300mm); }
        body quill { axis x = (1, 0, 0); point T = (200mm, 0mm, 0mm); start position = (407mm, 148mm, 550mm); }
        joint base = revolute(ground.position, ground.z, column.position, column.z);
        joint shoulder = revolute(column.S, column.y, boom.position, boom.y);
        joint way = translational(boom.E, boom.x, quill.position, quill.x);
        drive pan = drive_rotation(base, 20deg - 1rad_s * t);
        drive tilt = drive_rotation(shoulder, -30deg + 0.5rad * sin(t * 2rad_s));
        drive feed = drive_translation(way, 100mm + 20mm_s * t);
        force strut = spring_damper(column.position, boom.E, stiffness: 9kN_m, rest: 0.3 * reach, damping: 50Ns_m);
        output tool = quill.T;
    }
});

/// Radius (m) of a cam by its angle, with its derivatives.
fn measured<T: reuleaux::Real>(psi: T) -> (T, T, T) {
    let (sine, cosine) = psi.sin_cos();
    let lift = T::of(0.004);
    (T::of(0.03) + lift * cosine, -(lift * sine), -(lift * cosine))
}

declared!(measured_cam {
    #[picture]
    pub mechanism MeasuredCam {
        function profile(Angle) -> Length = super::measured;
        ground { axis up = (0, 1); }
        body cam { }
        body knife { start position = (0mm, 30mm); }
        joint axle = revolute(ground.position, cam.position);
        joint way = translational(ground.up, ground.position, knife.position);
        joint edge = cam_knife(cam.position, knife.position, profile);
        drive motor = drive_angle(cam, 60rpm * t);
    }
});

declared!(pendulum {
    #[picture]
    pub mechanism DoublePendulum {
        gravity = (0, -9.81m_s2);
        body upper { point E = (300mm, 0mm); mass = 1kg; inertia = 0.1kgm2; }
        body lower { point E = (300mm, 0mm); mass = 1kg; inertia = 0.1kgm2; start angle = 20deg; }
        freedom swing = upper.angle from 10deg;
        joint o = revolute(ground.position, upper.position);
        freedom bend = lower.angle from 20deg;
        joint e = revolute(upper.E, lower.position);
        force coil = spring(ground.hook, upper.E, stiffness: 40N_m, rest: 100mm);
        force pot = damper(upper.position, lower.E, damping: 2Ns_m);
        ground { point hook = (200mm, 150mm); }
        output E = lower.E;
    }
});

/// The picture on the page of a declaration.
fn page(text: &str) -> String {
    let compiled = super::compiled(&("page".into(), text.parse().expect("tokens")));
    assert!(compiled.picture.words().starts_with("Assembled at the declared defaults, at t = 0."), "{}", compiled.picture.words());
    compiled.picture.svg().expect("it is assembled").to_owned()
}

#[test]
fn at_the_start_the_page_has_the_same_picture() -> Result<(), Box<dyn Error>> {
    let (engine, valve, train, press) =
        (engine::Engine::default(), valve::Valve::default(), train::Train::default(), press::Press::default());
    assert_eq!(engine.picture(&engine.solve(0.0)?), page(engine::TEXT));
    assert_eq!(valve.picture(&valve.solve(0.0)?), page(valve::TEXT));
    assert_eq!(train.picture(&train.solve(0.0)?), page(train::TEXT));
    assert_eq!(press.picture(&press.solve(0.0)?.0), page(press::TEXT));
    let (across, arm) = (across::AcrossCrank::default(), arm::Arm::default());
    assert_eq!(across.picture(&across.solve(0.0)?.0), page(across::TEXT));
    let svg = arm.picture(&arm.solve(0.0)?.0);
    assert_eq!(svg, page(arm::TEXT));
    assert!(svg.contains("<title>strut: spring_damper of column and boom</title>"), "{svg}");
    Ok(())
}

#[test]
fn freedoms_may_stand_anywhere() -> Result<(), Box<dyn Error>> {
    let pendulum = pendulum::DoublePendulum::default();
    let svg = pendulum.picture(&pendulum.initial_state()?.0);
    assert_eq!(svg, page(pendulum::TEXT));
    assert!(svg.contains("<title>e: revolute of upper and lower</title>"), "{svg}");
    let forces = ["coil: spring of ground and upper", "pot: damper of upper and lower"];
    assert!(forces.iter().all(|force| svg.contains(&format!("<title>{force}</title>"))), "{svg}");
    Ok(())
}

#[test]
fn a_rust_function_is_drawn_by_programs_only() -> Result<(), Box<dyn Error>> {
    let cam = measured_cam::MeasuredCam::default();
    let dashed = "<circle class=\"d\"";
    assert!(page(measured_cam::TEXT).contains(dashed));
    let svg = cam.picture(&cam.solve(0.1)?.0);
    assert!(!svg.contains(dashed) && svg.contains("<path class=\"w c0\""), "{svg}");
    Ok(())
}

#[test]
fn a_picture_shows_the_state_and_the_parameters() -> Result<(), Box<dyn Error>> {
    let engine = engine::Engine::default();
    let longer = engine::Engine { rod_length: 0.2, ..engine };
    let start = engine.picture(&engine.solve(0.0)?);
    assert_ne!(engine.picture(&engine.solve(0.1)?.0), start);
    assert_ne!(longer.picture(&longer.solve(0.0)?.0), start);
    let single = engine::Engine::<f32>::with_defaults();
    assert_eq!(single.picture(&single.solve(0.0)?.0), start, "a tenth of a unit is more than `f32` rounds off");
    Ok(())
}

#[test]
fn a_state_without_numbers_is_a_sentence() -> Result<(), Box<dyn Error>> {
    let engine = engine::Engine::default();
    for wrong in [f64::NAN, f64::INFINITY, 1e200, f64::MAX] {
        for coordinate in 0..9 {
            let mut state = engine.solve(0.0)?.0;
            state.q[coordinate] = wrong;
            let svg = engine.picture(&state);
            roxmltree::Document::parse(&svg)?;
            // Angles may be arbitrarily large.
            let has_place = coordinate % 3 == 2 && wrong.is_finite();
            assert_eq!(svg.contains("There is no picture: not every place is a number."), !has_place, "{wrong} in {coordinate}");
        }
    }
    Ok(())
}

/// The lines that draw ground, which have no tooltips.
fn ground(svg: &str) -> Vec<&str> {
    svg.lines().filter(|line| line.starts_with("<g><path class=\"p\"") || line.starts_with("<g><path class=\"l\"")).collect()
}

#[test]
fn frames_have_one_size_and_ground_that_stands_still() -> Result<(), Box<dyn Error>> {
    let engine = engine::Engine::default();
    let states = engine.sweep((0..12).map(|step| f64::from(step) / 12.0)).collect::<Result<Vec<_>, _>>()?;
    let scenes: Vec<Scene> = states.iter().map(|state| engine.scene(state)).collect();
    let drawn = frames(&scenes)?;
    let alone: Vec<String> = scenes.iter().map(Scene::svg).collect();
    let head = |svg: &str| svg.lines().next().map(ToOwned::to_owned);
    let pivot = |svg: &str| ground(svg).into_iter().find(|line| line.contains("class=\"p\"")).map(ToOwned::to_owned);
    assert!(pivot(drawn[0].svg()).is_some());
    for frame in &drawn {
        assert_eq!(head(frame.svg()), head(drawn[0].svg()));
        assert_eq!(pivot(frame.svg()), pivot(drawn[0].svg()));
    }
    assert!(alone.iter().any(|svg| head(svg) != head(&alone[0])), "one by one they have the size that each needs");
    Ok(())
}

#[test]
fn an_animation_shows_each_frame_in_turn() -> Result<(), Box<dyn Error>> {
    let train = train::Train::default();
    let states = train.sweep((0..8).map(f64::from)).collect::<Result<Vec<_>, _>>()?;
    let scenes: Vec<Scene> = states.iter().map(|state| train.scene(state)).collect();
    let moving = animation(&scenes, 2.0)?;
    let tree = roxmltree::Document::parse(&moving)?;
    let frames = tree.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "animate")));
    assert_eq!(frames.count(), 8);
    assert_eq!(animation(&[], 2.0), Err(Undrawable::Empty));
    Ok(())
}

#[test]
fn a_motion_in_space_is_seen_from_one_place() -> Result<(), Box<dyn Error>> {
    let across = across::AcrossCrank::default();
    let states = across.sweep((0..12).map(|step| f64::from(step) / 12.0)).collect::<Result<Vec<_>, _>>()?;
    let scenes: Vec<Scene> = states.iter().map(|state| across.scene(state)).collect();
    let drawn = frames(&scenes)?;
    let hinge =
        |svg: &str| svg.lines().find(|line| line.contains("axle: revolute") && line.contains("class=\"k g\"")).map(ToOwned::to_owned);
    assert!(hinge(drawn[0].svg()).is_some());
    for frame in &drawn {
        assert_eq!(frame.svg().lines().next(), drawn[0].svg().lines().next());
        assert_eq!(hinge(frame.svg()), hinge(drawn[0].svg()));
    }
    assert_ne!(drawn[3].svg(), drawn[0].svg());
    let shorter = across::AcrossCrank { crank_length: 0.07, ..across };
    assert_ne!(shorter.picture(&shorter.solve(0.0)?.0), across.picture(&states[0].0));
    Ok(())
}

/// Views and scenes are drawn from a direction of one's own, whatever its length.
#[test]
fn a_view_is_seen_from_the_direction_asked_for() -> Result<(), Box<dyn Error>> {
    let across = across::AcrossCrank::default();
    let states = across.sweep((0..4).map(|step| f64::from(step) / 12.0)).collect::<Result<Vec<_>, _>>()?;
    let view = across.view(states.clone());
    let front = view.clone().seen_from([0.0, -1.0, 0.0]);
    assert_ne!(front.still(0, &[])?, view.still(0, &[])?);
    assert_eq!(front.still(0, &[])?, view.clone().seen_from([0.0, -0.5, 0.0]).still(0, &[])?);
    assert_eq!(front.still(3, &[])?, view.clone().seen_from([1.0, 0.0, 0.0]).seen_from([0.0, -1.0, 0.0]).still(3, &[])?);
    // A scene by itself as well.
    let mut scene = across.scene(&states[0]);
    scene.seen_from([0.0, -1.0, 0.0]);
    assert_ne!(scene.svg(), across.picture(&states[0]));
    Ok(())
}

/// One call is as good as a line for each output.
#[test]
fn all_outputs_are_plotted_in_one_call() -> Result<(), Box<dyn Error>> {
    let listed = listed::Listed::default();
    let states = listed.sweep((0..20).map(|step| 0.05 * f64::from(step))).collect::<Result<Vec<_>, _>>()?;
    let each = listed
        .view(states.clone())
        .plot("angle", "°", |state| listed.angle(state).value.to_degrees())
        .plot("pin.x", "mm", |state| listed.pin(state).value.x * 1e3)
        .and("pin.y", |state| listed.pin(state).value.y * 1e3)
        .plot("share", "", |state| listed.share(state).value)
        .plot("speed", "rad/s", |state| listed.speed(state).value)
        .plot("pose.x", "mm", |state| state.crank().position.x * 1e3)
        .and("pose.y", |state| state.crank().position.y * 1e3)
        .plot("pose.angle", "°", |state| state.crank().angle.to_degrees());
    assert_eq!(listed.view_outputs(states).to_html()?, each.to_html()?);
    Ok(())
}

#[test]
fn states_of_any_kind_make_a_view() -> Result<(), Box<dyn Error>> {
    let pendulum = pendulum::DoublePendulum::default();
    let (mut state, mut integrator) = (pendulum.initial_state()?, Integrator::new(1e-9));
    let mut recorded = vec![state.clone()];
    for step in 1..20 {
        pendulum.advance(&mut state, 0.05 * f64::from(step), &mut integrator)?;
        recorded.push(state.clone());
    }
    let swinging = pendulum.view(recorded).trace("E", |state| pendulum.E(state).value).plot("upper", "rad", |state| state.upper().angle);

    let across = across::AcrossCrank::default();
    let turn = across.sweep((0..20).map(|step| 0.05 * f64::from(step))).collect::<Result<Vec<_>, _>>()?;
    let turning = across.view(turn).trace("slide", |state| across.stroke(state).value);

    let engine = engine::Engine::<f32>::with_defaults();
    let states = engine.sweep((0..20).map(|step| 0.05 * step as f32)).collect::<Result<Vec<_>, _>>()?;
    let borrowed: Vec<&State<f32, 9>> = states.iter().map(|state| &state.0).collect();
    let single = engine.view(borrowed).trace("bore", |state| state.point(6).value).plot("travel", "m", |state| state.q[6]);

    for (page, svg) in [
        (swinging.to_html()?, swinging.animated_svg()?),
        (turning.to_html()?, turning.animated_svg()?),
        (single.to_html()?, single.animated_svg()?),
    ] {
        assert!(page.contains("class=\"trace\"") && page.contains("\"columns\":[\""));
        roxmltree::Document::parse(&svg)?;
    }
    assert!(swinging.to_html()?.contains("<title>DoublePendulum</title>"));
    Ok(())
}
