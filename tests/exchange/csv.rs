//! Motions as tables: names, units, and every bit of every number.

use std::convert::Infallible;
use std::io::{self, Write};

use reuleaux::csv::{self, Unwritten};
use reuleaux::{Mechanism, Motion, OutputName, Outputs, mechanism};

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    #[outputs]
    mechanism Toggle {
        param bar: Length = 1m;
        body near   { point A = (bar, 0);  start angle = 60deg; }
        body far    { point B = (bar, 0);  start angle = -60deg; }
        body slider { }
        ground { axis rail = (1, 0); }
        joint o = revolute(ground.position, near.position);
        joint a = revolute(near.A, far.position);
        joint b = revolute(far.B, slider.position);
        joint rail = translational(ground.rail, ground.position, slider.position);
        drive push = drive_x(slider.position, 1m + 0.5m_s * t);
        for i in 0..2 { output knee[i] = near.A.y * (i + 1); }
        output pin = near.A;
        output bar = far;
        output area = near.A.x * near.A.y;
        output ratio = near.A.x / bar;
        output r#type = near.angle;
    }
}

mechanism! {
    #[outputs]
    mechanism Gyro in space {
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body disk { axis z = (0, 0, 1) from (1, 0, 0);  point P = (1m, 0m, 0.5m); }
        joint hinge = revolute(ground.position, ground.z, disk.position, disk.z);
        drive motor = drive_rotation(hinge, 0.3rad + 2rad_s * t + 0.5 * 3rad * (t * 1rad_s / 1rad)^2);
        output rim = disk.P;
        output disk = disk;
    }
}

mechanism! {
    #[outputs]
    mechanism Falling {
        gravity = (0m_s2, -9.81m_s2);
        body bob { point P = (1m, 0m);  mass = 2kg;  center = (1m, 0m);  inertia = 0kg * 1m^2; }
        joint pivot = revolute(ground.position, bob.position);
        freedom swing = bob.angle from 0deg;
        output swing = bob.angle;
    }
}

mechanism! {
    #[outputs]
    mechanism Keyword {
        body r#match { }
        joint o = revolute(ground.position, r#match.position);
        drive d = drive_angle(r#match, 1rad_s * t);
        output r#loop = r#match.angle;
    }
}

/// Columns of coordinates and of outputs are called alike.
#[test]
fn names_that_are_words_of_rust_stand_without_their_mark() -> Outcome {
    let (keyword, mut table) = (Keyword::default(), Vec::new());
    csv::write(&mut table, &keyword, keyword.sweep([0.0]))?;
    let (header, _) = parsed(&table);
    assert!(["match.angle (rad)", "loop (rad)"].iter().all(|name| header.iter().any(|known| known == name)), "{header:?}");
    Ok(())
}

/// The header and the rows of a table.
fn parsed(table: &[u8]) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::str::from_utf8(table).expect("it is text");
    assert!(text.ends_with('\n'));
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let header = lines.next().expect("there is a header");
    let rows: Vec<Vec<f64>> = lines.map(|cells| cells.iter().map(|cell| cell.parse().expect("a number")).collect()).collect();
    assert!(rows.iter().all(|row| row.len() == header.len()));
    (header, rows)
}

fn column(header: &[String], name: &str) -> usize {
    header.iter().position(|known| known == name).unwrap_or_else(|| panic!("no column {name} in {header:?}"))
}

#[test]
fn a_header_has_names_and_units() -> Outcome {
    let toggle = Toggle::default();
    let mut table = Vec::new();
    csv::write(&mut table, &toggle, toggle.sweep([0.0]))?;
    let (header, _) = parsed(&table);
    let first = ["t (s)", "near.x (m)", "near.x rate (m/s)", "near.x acceleration (m/s²)", "near.y (m)"];
    assert_eq!(header[..5], first);
    let angle = column(&header, "near.angle (rad)");
    assert_eq!(header[angle..angle + 3], ["near.angle (rad)", "near.angle rate (rad/s)", "near.angle acceleration (rad/s²)"]);
    assert_eq!(header.len(), 1 + 3 * (9 + 2 + 2 + 3 + 3));
    for name in [
        "knee[0] (m)",
        "knee[1] rate (m/s)",
        "pin.x (m)",
        "pin.y acceleration (m/s²)",
        "bar.angle rate (rad/s)",
        "area (m²)",
        "area rate (m²/s)",
        "area acceleration (m²/s²)",
        "ratio (1)",
        "ratio rate (1/s)",
        "type (rad)",
    ] {
        column(&header, name);
    }
    Ok(())
}

#[test]
fn every_bit_returns() -> Outcome {
    let toggle = Toggle::default();
    let times = [0.0, 0.1, 1.0 / 3.0, 0.7];
    let mut table = Vec::new();
    csv::write(&mut table, &toggle, toggle.sweep(times))?;
    let (header, rows) = parsed(&table);
    assert_eq!(rows.len(), times.len());
    for (row, state) in rows.iter().zip(toggle.sweep(times)) {
        let state = state?;
        let is = |name: &str, value: f64| assert_eq!(row[column(&header, name)].to_bits(), value.to_bits(), "{name}");
        is("t (s)", state.t);
        for (index, name) in ["near.x", "near.y", "near.angle", "far.x", "far.y", "far.angle"].into_iter().enumerate() {
            let (unit, q) = (if name.ends_with("angle") { "rad" } else { "m" }, index);
            is(&format!("{name} ({unit})"), state.q[q]);
            is(&format!("{name} rate ({unit}/s)"), state.qd[q]);
            is(&format!("{name} acceleration ({unit}/s²)"), state.qdd[q]);
        }
        is("pin.y acceleration (m/s²)", toggle.pin(&state).acceleration.y);
        is("knee[1] rate (m/s)", toggle.knee(&state)[1].rate);
        is("bar.angle (rad)", state.far().angle);
        is("area acceleration (m²/s²)", toggle.area(&state).acceleration);
        is("type (rad)", toggle.r#type(&state).value);
    }
    Ok(())
}

#[test]
fn outputs_and_coordinates_make_tables_of_their_own() -> Outcome {
    let toggle = Toggle::default();
    let [mut all, mut outputs, mut coordinates] = [Vec::new(), Vec::new(), Vec::new()];
    csv::write(&mut all, &toggle, toggle.sweep([0.0, 0.5]))?;
    csv::write_outputs(&mut outputs, &toggle, toggle.sweep([0.0, 0.5]))?;
    csv::write_coordinates(&mut coordinates, &toggle, toggle.sweep([0.0, 0.5]))?;
    let (all, outputs, coordinates) = (parsed(&all), parsed(&outputs), parsed(&coordinates));
    assert_eq!(all.0, [&coordinates.0[..], &outputs.0[1..]].concat());
    assert_eq!(all.1[1], [&coordinates.1[1][..], &outputs.1[1][1..]].concat());
    Ok(())
}

#[test]
fn a_motion_that_ends_leaves_the_lines_before() {
    let toggle = Toggle::default();
    let mut table = Vec::new();
    // The bars are straight at t = 2.
    let ended = csv::write_outputs(&mut table, &toggle, toggle.sweep([0.0, 1.0, 3.0, 4.0])).unwrap_err();
    assert_eq!(parsed(&table).1.len(), 2);
    let Unwritten::Failure(failure) = &ended else { panic!("it is the mechanism's failure") };
    assert_eq!(ended.to_string(), format!("the table ends early: {failure}"));
    assert!((failure.time - 2.0).abs() < 1e-6, "{failure}");
}

#[test]
fn a_motion_without_states_is_a_header() -> Outcome {
    let mut table = Vec::new();
    csv::write(&mut table, &Toggle::<f64>::default(), std::iter::empty::<Result<ToggleState, Infallible>>())?;
    let (header, rows) = parsed(&table);
    assert!(header.len() > 1 && rows.is_empty());
    Ok(())
}

#[test]
fn single_precision_returns_too() -> Outcome {
    let toggle = Toggle::<f32>::with_defaults();
    let mut table = Vec::new();
    csv::write_outputs(&mut table, &toggle, toggle.sweep([0.3_f32]))?;
    let text = String::from_utf8(table)?;
    let cells: Vec<f32> = text.lines().nth(1).unwrap_or_default().split(',').map(str::parse).collect::<Result<_, _>>()?;
    assert_eq!(cells[0].to_bits(), 0.3_f32.to_bits());
    assert_eq!(cells[1].to_bits(), toggle.knee(&toggle.solve(0.3)?)[0].value.to_bits());
    Ok(())
}

/// φ = 0.3 + 2 t + 1.5 t², so that the rim is at (cos φ, sin φ, 0.5).
#[test]
fn bodies_in_space_have_direction_cosines() -> Outcome {
    let gyro = Gyro::default();
    let t = 0.4_f64;
    let (phi, omega, alpha) = (0.3 + 2.0 * t + 1.5 * t * t, 2.0 + 3.0 * t, 3.0);
    let mut table = Vec::new();
    csv::write(&mut table, &gyro, gyro.sweep([t]))?;
    let (header, rows) = parsed(&table);
    let near = |name: &str, value: f64| {
        let found = rows[0][column(&header, name)];
        assert!((found - value).abs() < 1e-13 * (1.0 + value.abs()), "{name}: {found} for {value}");
    };
    near("disk.a11 (1)", phi.cos());
    near("disk.angular_velocity.z (rad/s)", omega);
    near("disk.angular_acceleration.z (rad/s²)", alpha);
    near("output disk.a21 rate (1/s)", phi.cos() * omega);
    near("output disk.a12 acceleration (1/s²)", phi.sin() * omega * omega - phi.cos() * alpha);
    near("rim.x acceleration (m/s²)", -phi.cos() * omega * omega - phi.sin() * alpha);
    near("rim.z (m)", 0.5);
    Ok(())
}

#[test]
fn motion_from_forces_makes_a_table() -> Outcome {
    let falling = Falling::default();
    let states = [falling.initial_state()?].map(Ok::<_, Infallible>);
    let mut table = Vec::new();
    csv::write(&mut table, &falling, states)?;
    let (header, rows) = parsed(&table);
    // A point mass, horizontal and at rest: φ̈ = −g / l.
    assert!((rows[0][column(&header, "swing acceleration (rad/s²)")] + 9.81).abs() < 1e-12);
    Ok(())
}

mechanism! {
    /// An output with the name of a body.
    #[outputs]
    mechanism Named {
        body disc { point P = (2m, 0m); }
        joint pin = revolute(ground.position, disc.position);
        drive motor = drive_angle(disc, 1rad_s * t);
        output disc = disc.P;
    }
}

#[test]
fn an_output_that_is_called_like_a_body_has_columns_of_its_own() -> Outcome {
    let (named, mut table, mut outputs) = (Named::default(), Vec::new(), Vec::new());
    csv::write(&mut table, &named, named.sweep([0.0]))?;
    csv::write_outputs(&mut outputs, &named, named.sweep([0.0]))?;
    let (header, rows) = parsed(&table);
    assert_eq!((rows[0][column(&header, "disc.x (m)")], rows[0][column(&header, "output disc.x (m)")]), (0.0, 2.0));
    assert!(parsed(&outputs).0.iter().all(|name| !name.contains("output")));
    Ok(())
}

#[test]
fn a_writer_that_fails_is_reported() {
    struct Full;
    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::Error::other("the disk is full"))
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let toggle = Toggle::default();
    let failed = csv::write(Full, &toggle, toggle.sweep([0.0])).unwrap_err();
    assert_eq!(format!("{failed:?}"), "the table cannot be written: the disk is full");
}

const PIN_Y: usize = Toggle::<f64>::OUTPUTS.index("pin.y").unwrap();

#[test]
fn a_component_has_an_index_by_name() -> Outcome {
    let toggle = Toggle::default();
    let state = toggle.solve(0.2)?;
    let outputs: [Motion<f64>; 10] = toggle.outputs(&state);
    assert_eq!(outputs[PIN_Y].value, toggle.pin(&state).value.y);
    assert_eq!(Toggle::<f64>::OUTPUTS.index("pin.z"), None);
    assert_eq!(Toggle::<f64>::OUTPUTS.0[PIN_Y].units, ["m", "m/s", "m/s²", OutputName::NO_UNIT]);
    // y = √(bar² − x²), where x is half the driven distance.
    let (varied, there) = toggle.derivatives(&state, |toggle| [&mut toggle.bar])?;
    let by = varied.outputs(&ToggleState(there))[PIN_Y].value.by[0];
    assert!((by - 1.0 / outputs[PIN_Y].value).abs() < 1e-13);
    Ok(())
}

mechanism! {
    /// A crank with a pin that is solved for alone.
    mechanism Alone {
        body crank { point A = (2m, 0m); }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        slice output pin = crank.A with jerk;
        slice output speed = crank.angular_velocity;
    }
}

#[test]
fn columns_of_ones_own_are_quoted_where_they_have_to_be() -> Outcome {
    let alone = Alone::default();
    let mut table = Vec::new();
    let columns: [csv::ColumnOf<AloneState, f64>; 2] =
        [("turn, in \"all\"", "rad", &|state| state.crank().angle), ("speed", "rad/s", &|state| state.crank().angular_velocity)];
    csv::write_columns(&mut table, alone.sweep([0.0, 0.5]), &columns)?;
    assert_eq!(std::str::from_utf8(&table)?, "t (s),\"turn, in \"\"all\"\" (rad)\",speed (rad/s)\n0.0,0.0,1.0\n0.5,0.5,1.0\n");
    Ok(())
}

/// (2 cos t, 2 sin t) and its derivatives.
#[test]
fn a_slice_has_a_table() -> Outcome {
    let (pin, speed) = (Alone::default().solve_for_pin(), Alone::default().solve_for_speed());
    let (mut of_pin, mut of_speed) = (Vec::new(), Vec::new());
    csv::write_slice(&mut of_pin, &pin, pin.sweep([0.5]))?;
    csv::write_slice(&mut of_speed, &speed, speed.sweep([0.5]))?;
    let (header, rows) = parsed(&of_pin);
    assert_eq!(header.len(), 9);
    let (sine, cosine) = 0.5_f64.sin_cos();
    let wanted = [cosine, -sine, -cosine, sine, sine, cosine, -sine, -cosine];
    let names = [
        "x (m)",
        "x rate (m/s)",
        "x acceleration (m/s²)",
        "x jerk (m/s³)",
        "y (m)",
        "y rate (m/s)",
        "y acceleration (m/s²)",
        "y jerk (m/s³)",
    ];
    for (name, wanted) in names.iter().zip(wanted) {
        let found = rows[0][column(&header, &format!("pin.{name}"))];
        assert!((found - 2.0 * wanted).abs() < 1e-14, "{name}: {found}");
    }
    assert_eq!(parsed(&of_speed), (vec!["t (s)".into(), "speed (rad/s)".into(), "speed rate (rad/s²)".into()], vec![vec![0.5, 1.0, 0.0]]));
    Ok(())
}
