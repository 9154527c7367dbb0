//! Velocities in the list of outputs and in tables.

use reuleaux::{OutputName, Outputs, csv, mechanism};

mechanism! {
    #[outputs]
    mechanism Crank {
        body crank { point A = (0.5m, 0m); }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 2rad_s * t);
        output speed = rate(crank.A);
        output ratio = crank.angular_velocity / 4rad_s;
        output pin = crank.A.y;
    }
}

#[test]
fn the_list_says_that_a_velocity_has_no_acceleration() -> Result<(), Box<dyn std::error::Error>> {
    const SPEED: usize = Crank::<f64>::OUTPUTS.index("speed.y").unwrap();
    const RATIO: usize = Crank::<f64>::OUTPUTS.index("ratio").unwrap();
    const PIN: usize = Crank::<f64>::OUTPUTS.index("pin").unwrap();
    let names = Crank::<f64>::OUTPUTS.0;
    assert_eq!(names[SPEED].units, ["m/s", "m/s²", OutputName::NO_UNIT, OutputName::NO_UNIT]);
    assert_eq!(names[RATIO].units, ["", "1/s", OutputName::NO_UNIT, OutputName::NO_UNIT]);
    assert_eq!([SPEED, RATIO, PIN].map(|index| names[index].has_acceleration()), [false, false, true]);
    let crank = Crank::default();
    let outputs = crank.outputs(&crank.solve(0.0)?);
    assert_eq!((outputs[SPEED].value, outputs[SPEED].rate), (1.0, 0.0));
    assert_eq!((outputs[RATIO].value, outputs[RATIO].rate), (0.5, 0.0));
    assert!(outputs[SPEED].acceleration.is_nan() && outputs[RATIO].acceleration.is_nan());
    assert_eq!(outputs[PIN].acceleration, 0.0);
    Ok(())
}

#[test]
fn a_table_has_no_column_for_it() -> Result<(), Box<dyn std::error::Error>> {
    let crank = Crank::default();
    let mut table = Vec::new();
    csv::write_outputs(&mut table, &crank, crank.sweep([0.0]))?;
    assert_eq!(
        String::from_utf8(table)?,
        "t (s),speed.x (m/s),speed.x rate (m/s²),speed.y (m/s),speed.y rate (m/s²),ratio (1),ratio rate (1/s),\
         pin (m),pin rate (m/s),pin acceleration (m/s²)\n0.0,0.0,-2.0,1.0,0.0,0.5,0.0,0.0,1.0,0.0\n"
    );
    Ok(())
}
