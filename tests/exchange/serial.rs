//! Parameters, states, outputs, plans and failures by serde.

use reuleaux::{Failure, Motion, State, mechanism};
use serde_json::{Value, from_str, from_value, json, to_string, to_value};

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    #[serde]
    #[serde(deny_unknown_fields, rename_all = "kebab-case")]
    mechanism Rocker {
        #[serde(rename = "crank")]
        param crank_length: Length = 100mm in 10mm..=200mm;
        param coupler_length: Length = 350mm;
        ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
        body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
        body coupler { point A = (0mm, 0mm);  point B = (coupler_length, 0mm);  point P = (175mm, 80mm); }
        body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.O);
        joint a = revolute(crank.A, coupler.A);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.C, ground.C);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = coupler.P;
    }
}

mechanism! {
    #[serde]
    mechanism Bench {
        for i in 0..40 { param height[i]: Length = i * 1mm; }
        for i in 0..2 { for j in 0..33 { param grid[i][j]: Length = (i + j) * 1mm; } }
        part left = Post(0mm);
        part right = Post(100mm);
        for i in 0..2 { part twin[i] = Twin(); }
        component Post(place: Length) {
            param x: Length = place;
            param y: Length = 5mm;
            body post { point P = (-x, -y); }
            joint foot = weld(ground.position, post.P);
        }
        component Twin() {
            param x: Length = 7mm;
            param y: Length = 8mm;
            body post { point P = (-x, -y); }
            joint foot = weld(ground.position, post.P);
        }
        body tower { point P = (height[39], grid[1][32]); }
        joint foot = weld(ground.position, tower.P);
    }
}

mechanism! {
    #[serde]
    mechanism Arm {
        input theta: Angle;
        body arm { point P = (1m, 0m); }
        joint pivot = revolute(ground.position, arm.position);
        drive servo = drive_angle(arm, theta);
    }
}

mechanism! {
    #[serde]
    mechanism Half {
        param length: Length = 350mm;
        ground { point C = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm); }
        body coupler { point B = (length, 0mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive set = drive_angle(crank, 0.5rad);
        body arm { point P = (1m, 0m);  start angle = 30deg; }
        body foot { point P = (1m, 0m);  start angle = -30deg; }
        joint pivot = revolute(ground.position, arm.position);
        joint knee = revolute(arm.P, foot.position);
        drive toe = drive_x(foot.P, 1.5m + 0.1m_s * t);
        drive heel = drive_y(foot.P, 0.1m_s * t);
    }
}

mechanism! {
    #[serde]
    mechanism Idle in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body ball { axis z = (0, 0, 1) from (1, 0, 0); }
        joint pivot = weld(ground.position, ground.z, ball.position, ball.z);
        output place = ball;
    }
}

#[test]
fn parameters_return_to_the_last_bit() -> Outcome {
    let numbers = [0.1 + 0.2, 1.0 / 3.0, f64::MIN_POSITIVE, f64::MAX, 5e-324, -0.0, 0.123_456_789_012_345_67];
    for crank_length in numbers {
        let written = Rocker { crank_length, ..Rocker::default() };
        let read: Rocker = from_str(&to_string(&written)?)?;
        assert_eq!(read.crank_length.to_bits(), crank_length.to_bits());
        assert_eq!(read, written);
    }
    Ok(())
}

#[test]
fn names_are_those_of_the_attributes() -> Outcome {
    assert_eq!(to_value(Rocker::default())?, json!({ "crank": 0.1, "coupler-length": 0.35 }));
    Ok(())
}

#[test]
fn a_missing_field_has_its_declared_default() -> Outcome {
    assert_eq!(from_str::<Rocker>("{}")?, Rocker::default());
    let short: Rocker = from_str(r#"{ "crank": 0.08 }"#)?;
    assert_eq!(short, Rocker { crank_length: 0.08, coupler_length: 0.35 });
    let single: Rocker<f32> = from_str(r#"{ "crank": 0.08 }"#)?;
    assert_eq!(single, Rocker { crank_length: 0.08_f32, coupler_length: 0.35_f32 });
    Ok(())
}

#[test]
fn an_unknown_field_is_refused_where_serde_is_told_so() {
    let refused = from_str::<Rocker>(r#"{ "cranc": 0.08 }"#).unwrap_err().to_string();
    assert!(refused.contains("unknown field `cranc`, expected `crank` or `coupler-length`"), "{refused}");
    assert!(from_str::<Arm>(r#"{ "cranc": 0.08 }"#).is_ok());
}

#[test]
fn a_parameter_out_of_its_bounds_is_refused_when_it_is_used() -> Outcome {
    let long: Rocker = from_str(r#"{ "crank": 0.5 }"#)?;
    let failure = long.solve(0.0).unwrap_err();
    assert!(failure.to_string().contains("`crank_length` = 0.5 m"), "{failure}");
    Ok(())
}

#[test]
fn arrays_of_any_length_and_rank_return() -> Outcome {
    let mut bench = Bench::default();
    bench.height[39] = 1.25;
    bench.grid[1][32] = 2.5;
    let text = to_string(&bench)?;
    assert_eq!(from_str::<Bench>(&text)?, bench);
    let value: Value = from_str(&text)?;
    assert_eq!(value["height"].as_array().map(Vec::len), Some(40));
    assert_eq!(value["grid"][1][32], 2.5);
    assert_eq!(value["height"][3], 0.003);
    let refused = from_value::<Bench>(json!({ "height": [1.0, 2.0] })).unwrap_err().to_string();
    assert!(refused.contains("invalid length 2, expected an array of length 40"), "{refused}");
    let mut long = value["height"].as_array().cloned().unwrap_or_default();
    long.push(json!(1.0));
    assert!(from_str::<Bench>(&json!({ "height": long }).to_string()).is_err());
    Ok(())
}

#[test]
fn parts_with_the_same_defaults_may_be_given_in_part() -> Outcome {
    let bench: Bench = from_value(json!({ "twin": [{ "x": 1.0 }, {}] }))?;
    let declared = Bench::default();
    assert_eq!(bench.twin, [BenchTwin { x: 1.0, y: 0.008 }, declared.twin[1]]);
    assert_eq!((bench.left, bench.right, bench.height), (declared.left, declared.right, declared.height));
    // Both posts have one type, but not the same defaults.
    let bench: Bench = from_value(json!({ "left": { "x": 1.0, "y": 2.0 } }))?;
    assert_eq!((bench.left, bench.right), (BenchPost { x: 1.0, y: 2.0 }, BenchPost { x: 0.1, y: 0.005 }));
    let refused = from_value::<Bench>(json!({ "left": { "x": 1.0 } })).unwrap_err().to_string();
    assert!(refused.contains("missing field `y`"), "{refused}");
    Ok(())
}

#[test]
fn a_state_returns_and_goes_on() -> Outcome {
    let rocker = Rocker::default();
    let mut state = rocker.solve(0.3)?;
    let mut read: RockerState = from_str(&to_string(&state)?)?;
    assert_eq!(read, state);
    rocker.advance(&mut state, 0.31)?;
    rocker.advance(&mut read, 0.31)?;
    assert!((read.q - state.q).amax() < 1e-14 && (read.qdd - state.qdd).amax() < 1e-11);
    assert_eq!(read.branch, state.branch);
    Ok(())
}

#[test]
fn a_state_that_was_edited_does_not_count_as_solved() -> Outcome {
    let half = Half::default();
    let state = half.solve(0.3)?;
    let value = to_value(&state)?;
    assert_ne!(value["solved"], "");
    assert_eq!(from_value::<HalfState>(value.clone())?, state);
    // The rocker never moves, so that a step from a solved state leaves it where it is.
    let mut edited = value.clone();
    edited["q"][8] = json!(state.rocker().angle + 1e-3);
    let mut edited: HalfState = from_value(edited)?;
    assert_eq!(edited.rocker().angle, state.rocker().angle + 1e-3);
    half.advance(&mut edited, 0.31)?;
    assert!((edited.rocker().angle - state.rocker().angle).abs() < 1e-14);
    let mut garbled = value;
    garbled["solved"] = json!("no digits");
    assert!(from_value::<HalfState>(garbled).is_err());
    Ok(())
}

#[test]
fn a_state_may_be_written_by_hand() -> Outcome {
    let solved = Rocker::default().solve(0.0)?;
    let [q, qd, qdd] = [&solved.q, &solved.qd, &solved.qdd].map(|vector| vector.as_slice().to_vec());
    let read: State<f64, 9> = from_value(json!({ "t": 0.0, "q": q, "qd": qd, "qdd": qdd }))?;
    assert_eq!((read.q, read.iterations, read.condition), (solved.q, 0, 1.0));
    assert_ne!(read, solved.0);
    for (branch, is_read) in [("+++++++++", true), ("-++++++++", true), ("++++++++", false), ("++++++++++", false), ("++++++++x", false)] {
        let state = json!({ "t": 0.0, "q": q, "qd": qd, "qdd": qdd, "branch": branch });
        assert_eq!(from_str::<State<f64, 9>>(&state.to_string()).is_ok(), is_read, "{branch}");
    }
    Ok(())
}

#[test]
fn a_state_returns_with_its_inputs() -> Outcome {
    let arm = Arm::default();
    let state = arm.solve(0.0, ArmInputs { theta: Motion::new(0.5, 0.25, -1.0) })?;
    let text = to_string(&state)?;
    assert_eq!(from_str::<ArmState>(&text)?, state);
    let inputs: ArmInputs = from_value(json!({ "theta": { "value": 1.0, "rate": 2.0, "acceleration": 3.0 } }))?;
    assert_eq!(inputs.theta, Motion::new(1.0, 2.0, 3.0));
    assert!(from_str::<ArmInputs>("{}").is_err());
    Ok(())
}

#[test]
fn outputs_are_written_by_name() -> Outcome {
    let rocker = Rocker::default();
    let tip = rocker.tip(&rocker.solve(0.2)?);
    let written = json!({
        "value": tip.value.as_slice(), "rate": tip.rate.as_slice(), "acceleration": tip.acceleration.as_slice(),
    });
    assert_eq!(to_value(tip)?, written);
    let idle = Idle::default();
    let place = to_value(idle.place(&idle.solve(0.0)?))?;
    assert_eq!(place["rotation"], json!([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]));
    Ok(())
}

#[test]
fn a_plan_is_written_with_the_names_of_coordinates() -> Outcome {
    let plan = to_value(Rocker::<f64>::PLAN)?;
    assert_eq!(plan["stages"][0], json!({ "Computed": "crank.x" }));
    Ok(())
}

#[test]
fn a_failure_is_its_sentence_and_its_facts() -> Outcome {
    let rocker = Rocker { coupler_length: 0.9, ..Rocker::default() };
    let failure: Failure<f64, 9> = rocker.solve(0.0).unwrap_err();
    let written = to_value(&failure)?;
    assert_eq!(written["message"], json!(failure.to_string()));
    assert_eq!(written["mechanism"], "Rocker");
    assert_eq!(written["cause"].as_object().map(serde_json::Map::len), Some(1));
    Ok(())
}

reuleaux::constraint! {
    /// A point above the origin.
    constraint above(P: Point) { P.x == 0m; }
}

mechanism! {
    #[serde]
    mechanism Hanging {
        use above;
        param length: Length = 1m;
        body rod { point P = (length, 0m); }
        joint guide = above(rod.P);
        joint upright = absolute_angle(rod, -90deg);
        drive lift = drive_y(rod.P, 0.5m * t / 1s);
    }
}

/// A definition of one's own is handed over by another macro.
#[test]
fn a_mechanism_that_uses_definitions_is_written_and_read() -> Outcome {
    assert_eq!(from_str::<Hanging>("{}")?.length, 1.0);
    assert_eq!(to_string(&Hanging::<f64> { length: 2.0 })?, r#"{"length":2.0}"#);
    Ok(())
}

/// Two declarations of one mechanism, of which a part at rest has changed.
macro_rules! resting {
    ($module:ident, $length:literal) => {
        mod $module {
            reuleaux::mechanism! {
                #[serde]
                pub(super) mechanism Scene {
                    param speed: AngularVelocity = 1rad_s;
                    ground { point C = (400mm, 0mm);  point D = (0mm, 500mm);  point E = (400mm, 500mm); }
                    body crank { point A = (100mm, 0mm); }
                    body coupler { point B = (350mm, 0mm); }
                    body rocker { point B = (300mm, 0mm);  start angle = 70deg; }
                    body lever { point A = ($length, 0mm); }
                    body strut { point B = (350mm, 0mm); }
                    body arm { point B = (300mm, 0mm);  start angle = 70deg; }
                    joint o = revolute(ground.position, crank.position);
                    joint a = revolute(crank.A, coupler.position);
                    joint b = revolute(coupler.B, rocker.B);
                    joint c = revolute(rocker.position, ground.C);
                    joint foot = revolute(ground.D, lever.position);
                    joint held = absolute_angle(lever, 40deg);
                    joint s = revolute(lever.A, strut.position);
                    joint r = revolute(strut.B, arm.B);
                    joint e = revolute(arm.position, ground.E);
                    drive motor = drive_angle(crank, speed * t);
                }
            }
        }
    };
}

resting!(before, 100mm);
resting!(after, 130mm);

/// It has to be solved again, also where steps leave what is at rest alone.
#[test]
fn a_state_of_another_declaration_does_not_count_as_solved() -> Outcome {
    let written = to_string(&before::Scene::default().solve(1.0)?)?;
    let (scene, mut state) = (after::Scene::default(), from_str::<after::SceneState>(&written)?);
    scene.advance(&mut state, 1.5)?;
    let right = scene.solve(1.5)?.strut().angle;
    assert!((state.strut().angle - right).abs() < 1e-14, "{}, not {right}", state.strut().angle);
    // Of the same declaration it does.
    let same: after::SceneState = from_str(&to_string(&state)?)?;
    assert_eq!(same, state);
    Ok(())
}
