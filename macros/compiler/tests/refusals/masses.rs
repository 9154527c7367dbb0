//! Masses, what joints add to them, and what acts on bodies without any.

crate::refusals! {
    mechanism three_moments_in_the_plane: "mechanism M { body b { mass = 1kg; inertia = «(1kgm2, 2kgm2, 3kgm2)»; } joint o = revolute(ground.position, b.position); freedom q = b.angle; }" => "in the plane an inertia is one number, about the axis out of the plane\nhelp: write `inertia = 3kgm2;`";
    mechanism a_moment_and_zeros_in_the_plane: "mechanism M { body b { mass = 1kg; inertia = «(0.001kgm2, 0, 0)»; } joint o = revolute(ground.position, b.position); freedom q = b.angle; }" => "in the plane an inertia is one number, about the axis out of the plane\nhelp: write `inertia = 0.001kgm2;`";
    mechanism two_moments_in_the_plane: "mechanism M { body b { mass = 1kg; inertia = «(1kgm2, 2kgm2)»; } joint o = revolute(ground.position, b.position); freedom q = b.angle; }" => "in the plane an inertia is one number, about the axis out of the plane\nhelp: write `inertia = 0.1kgm2;`, or a shape such as `disk(30mm)`";
    mechanism inertia_along_something_in_the_plane: "mechanism M { body b { mass = 1kg; inertia = 1kgm2 along «30deg»; } joint o = revolute(ground.position, b.position); freedom q = b.angle; }" => "in the plane an inertia is one number, however the body is turned\nhelp: write `inertia = 1kgm2;`";
    mechanism inertia_along_an_axis: "mechanism M in space { body b { axis z = (0, 0, 1); mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2) along «b.z»; } joint o = spherical(ground.position, b.position); freedom q = b.angular_velocity; }" => "expected an orientation, such as `turn((0, 0, 1), 30deg)`, found an axis";
    mechanism inertia_along_an_angle: "mechanism M in space { body b { mass = 1kg; inertia = (1kgm2, 1kgm2, 1kgm2) along «30deg»; } joint o = spherical(ground.position, b.position); freedom q = b.angular_velocity; }" => "expected an orientation, such as `turn((0, 0, 1), 30deg)`, found a number";
    mechanism impossible_inertia_along_an_orientation: "mechanism M in space { body b { mass = 1kg; inertia = «(1kgm2, 1kgm2, 2.01kgm2)» along turn((1, 2, 3), 30deg); } joint o = spherical(ground.position, b.position); freedom q = b.angular_velocity; }" => "no body has the inertia of `b`: about perpendicular axes, none is greater than the sum of the two others\nnote: its moments about the axes of the body would do, but not its principal moments\nhelp: write I_xx, I_yy, I_zz about the centre of mass, and if they are not zero I_xy, I_xz, I_yz after them";
    mechanism inertia_along_what_turns: "mechanism M in space { ground { axis z = (0, 0, 1); } body b { axis z = (0, 0, 1); mass = 1kg; inertia = «(1kgm2, 1kgm2, 1.5kgm2)» along turn((1, 0, 0), o.angle); } joint o = revolute(ground.position, ground.z, b.position, b.z); freedom q = o.angle; }" => "the mass of a body may depend on parameters only, not on what moves\nhelp: what moves along a body is a body of its own";
    mechanism mass_along_an_orientation: "mechanism M in space { body b { mass = 1kg «along» turn((1, 2, 3), 30deg); } joint o = spherical(ground.position, b.position); freedom q = b.angular_velocity; }" => "expected `;`, found `along`\nhelp: end what stands before it with `;`";
    mechanism mass_added_to_a_body: "mechanism M { body b { point P = (1m, 0m); } joint o = { add mass «on» b: 1kg; b.position == (0, 0); } freedom q = b.angle; }" => "expected `at` and the point of the mass, found `on`";
    mechanism mass_added_at_a_body: "mechanism M { body b { point P = (1m, 0m); } joint o = { add mass at «b»: 1kg; b.position == (0, 0); } freedom q = b.angle; }" => "expected a point, found a body\nhelp: its place is `.position`";
    mechanism inertia_added_to_a_point: "mechanism M { body b { point P = (1m, 0m); } joint o = { add inertia on «b.P»: 1kgm2; b.position == (0, 0); } freedom q = b.angle; }" => "expected a body, found a point\nhelp: write the name of the body alone";
    mechanism weight_added: "mechanism M { body b { point P = (1m, 0m); } joint o = { add «weight» at b.P: 1kg; b.position == (0, 0); } freedom q = b.angle; }" => "expected `mass at point: …;` or `inertia on body: …;`, found `weight`";
    mechanism length_added_as_a_mass: "mechanism M { body b { point P = (1m, 0m); } joint o = { add mass at b.P: «1m»; b.position == (0, 0); } freedom q = b.angle; }" => "expected a mass (kg), found a length (m)";
    mechanism negative_mass_added: "mechanism M { param m: Mass = -2kg; body b { point P = (1m, 0m); } joint o = { add mass at b.P: «m»; b.position == (0, 0); } freedom q = b.angle; }" => "the mass of `b` is -2 kg, and cannot be negative\nhelp: write a positive number";
    mechanism moving_mass_added: "mechanism M { body b { point P = (1m, 0m); } joint o = { add mass at b.P: «1kg * (1 + b.angle / 1rad)»; b.position == (0, 0); } freedom q = b.angle; }" => "the mass of a body may depend on parameters only, not on what moves\nhelp: what moves along a body is a body of its own";
    mechanism impossible_inertia_added: "mechanism M in space { body b { mass = 1kg; } joint o = { add inertia on b: «(1kgm2, 1kgm2, 3kgm2)»; b.position == (0m, 0m, 0m); } freedom q = b.angular_velocity; }" => "no body has the inertia of `b`: about perpendicular axes, none is greater than the sum of the two others\nhelp: write I_xx, I_yy, I_zz about the centre of mass, and if they are not zero I_xy, I_xz, I_yz after them";
    mechanism negative_mass_of_a_gear_joint: "mechanism M in space { ground { axis r = (0, 0, 1); } body a { mass = 1kg; inertia = ball(1m); } body b { mass = 1kg; inertia = ball(1m); } joint g = gear_joint(ground, a, b, ground.r, ground.r, 2, mass: «-1kg»); freedom q = dot(a.angular_velocity, (0, 0, 1)); }" => "a joint takes no mass away";
    constraint mass_of_a_length_in_a_definition: "constraint c(P: Point, m: Length) { add mass at P: «m»; P.x == 0; }" => "expected a mass (kg), found a length (m)";

    mechanism gear_joint_on_a_wheel_without_inertia: "mechanism M in space { ground { axis r = (0, 0, 1); } body a { mass = 1kg; } body b { mass = 3kg; inertia = ball(1m); } joint «gears» = gear_joint(ground, a, b, ground.r, ground.r, 2.5); freedom q = dot(a.angular_velocity, (0, 0, 1)); }" => "`gears` relates velocities of `a`, whose rotation no inertia resists\nnote: the motion follows from forces, since `q` is a freedom, and forces move only what has a mass\nhelp: write `inertia = …;` in `a`, or `inertia: …` in `gears`, which adds it to each of its bodies\nhelp: or relate positions or angles: these may hold what has no mass";
    mechanism gear_joint_on_a_wheel_without_mass: "mechanism M in space { ground { axis r = (0, 0, 1); } body a { inertia = (1kgm2, 1kgm2, 1kgm2); } body b { mass = 3kg; inertia = ball(1m); } joint «gears» = gear_joint(ground, a, b, ground.r, ground.r, 2.5); freedom q = dot(a.angular_velocity, (0, 0, 1)); }" => "`gears` relates velocities of `a`, whose translation no mass resists\nnote: the motion follows from forces, since `q` is a freedom, and forces move only what has a mass\nhelp: write `mass = …;` in `a`, or `mass: …` in `gears`, which adds it to each of its bodies\nhelp: or relate positions or angles: these may hold what has no mass";
    mechanism gear_joint_on_wheels_without_anything: "mechanism M in space { ground { axis r = (0, 0, 1); } body a { } body b { } body c { mass = 1kg; inertia = ball(1m); } joint o = spherical(ground.position, c.position); joint «gears» = gear_joint(ground, a, b, ground.r, ground.r, 2.5); freedom q = dot(a.angular_velocity, (0, 0, 1)); freedom s = c.angular_velocity; }" => "`gears` relates velocities of `a` and `b`, whose translation no mass and whose rotation no inertia resists\nnote: the motion follows from forces, since `q` is a freedom, and forces move only what has a mass\nhelp: write `mass = …;` in `a` and `b`, or `mass: …` in `gears`, which adds it to each of its bodies\nhelp: write `inertia = …;` in `a` and `b`, or `inertia: …` in `gears`, which adds it to each of its bodies\nhelp: or relate positions or angles: these may hold what has no mass";
    mechanism multi_point_constraint_on_a_body_without_mass: "mechanism M in space { body a { inertia = (1kgm2, 1kgm2, 1kgm2); } body b { mass = 1kg; inertia = ball(1m); } joint up = { a.angular_velocity - b.angular_velocity == (0, 0, 0); } joint «row» = { dot((0, 0, 1), rate(a.position)) - 2 * dot((0, 0, 1), rate(b.position)) == 0; } joint x = absolute_x(a.position, 0m); joint y = absolute_y(a.position, 0m); freedom v = rate(b.position); freedom w = b.angular_velocity; }" => "`row` relates velocities of `a`, whose translation no mass resists\nnote: the motion follows from forces, since `v` is a freedom, and forces move only what has a mass\nhelp: write `mass = …;` in `a`\nhelp: or relate positions or angles: these may hold what has no mass";
    mechanism equation_of_velocities_in_the_plane_without_inertia: "mechanism M { body a { mass = 1kg; inertia = 1kgm2; } body b { mass = 1kg; } joint p = revolute(ground.position, a.position); joint q = revolute((1m, 0m), b.position); joint «mesh» = { b.angular_velocity == -2 * a.angular_velocity; } freedom s = a.angle; }" => "`mesh` relates velocities of `b`, whose rotation no inertia resists\nnote: the motion follows from forces, since `s` is a freedom, and forces move only what has a mass\nhelp: write `inertia = …;` in `b`\nhelp: or relate positions or angles: these may hold what has no mass";
    mechanism rolling_disk_without_inertia: "mechanism M in space { gravity = (0, 0, -9.81m_s2); ground { axis z = (0, 0, 1) from (1, 0, 0); } body wheel { axis n = (0, 1, 0); mass = 1kg; } joint «contact» = rolling_disk(ground.z, wheel.position, wheel.n, 1m); joint up = perpendicular_axes(ground.z, wheel.n); freedom s = dot(wheel.angular_velocity, (0, 1, 0)); freedom r = dot(wheel.angular_velocity, (0, 0, 1)); }" => "`contact` relates velocities of `wheel`, whose rotation no inertia resists\nnote: the motion follows from forces, since `s` is a freedom, and forces move only what has a mass\nhelp: write `inertia = …;` in `wheel`\nhelp: or relate positions or angles: these may hold what has no mass";

    mechanism force_with_nothing_in_it: "mechanism M { body arm { mass = 1kg; inertia = 1kgm2; } joint hinge = revolute(ground.position, arm.position); force «f» = {} freedom s = arm.angle; }" => "`f` pushes nothing and turns nothing\nhelp: write `at arm.position: (0N, -5N);` for a force at a point, `on arm: 2Nm;` for a torque";
    mechanism force_with_a_let_alone: "mechanism M in space { body arm { mass = 1kg; inertia = ball(1m); } joint hinge = spherical(ground.position, arm.position); force «f» = { let a = 5N; } freedom s = arm.angular_velocity; }" => "`f` pushes nothing and turns nothing\nhelp: write `at arm.position: (0N, 0N, -5N);` for a force at a point, `on arm: (0Nm, 0Nm, 2Nm);` for a torque";
    mechanism load_alone_without_masses: "mechanism M { body arm { point P = (1m, 0m); } slice joint «hinge» = revolute(ground.position, arm.position); drive d = drive_angle(arm, 60rpm * t); }" => "`hinge` has no load that could be computed alone: no body has a mass, and no force acts\nhelp: write `mass = …;` in a body, or take `slice` away";
    mechanism slice_of_a_freedom: "mechanism M { body arm { mass = 1kg; inertia = 1kgm2; } joint hinge = revolute(ground.position, arm.position); slice «freedom» s = arm.angle; }" => "expected `output`, `joint`, `drive` or `force` after `slice`, found `freedom`";
    constraint force_without_forces: "force «f»(P: Point, k: Stiffness) { let a = k * P.x; }" => "`f` pushes nothing and turns nothing\nhelp: write `at P: (0N, -5N);` for a force at a point, `on body: 2Nm;` for a torque";
    mechanism mass_that_changes: "mechanism M { body b { mass = 1kg * («t» / 1s); inertia = 1kgm2; } joint o = revolute(ground.position, b.position); freedom s = b.angle; }" => "the mass of a body does not change with time: `t` cannot be used in it";
    mechanism mass_that_is_a_length: "mechanism M { body b { mass = «1m»; center = (1m, 0m); inertia = disk(1m); } joint o = revolute(ground.position, b.position); freedom s = b.angle; }" => "expected a mass (kg), found a length (m)";
    mechanism energy_that_is_a_force: "mechanism M { body b { mass = 1kg; inertia = 1kgm2; } joint o = revolute(ground.position, b.position); freedom s = b.angle; energy e = «3N_m * b.x»; }" => "an energy is in J, found a force (N)\nhelp: a spring of stiffness `k` has `0.5 * k * s^2`, a constant force `F` has `-F * s` along `s`";
}

/// True if a mechanism compiles.
fn compiles(source: &str) {
    let tokens = source.parse().expect("the source consists of tokens");
    let refusals = reuleaux_compiler::compile(tokens).err().unwrap_or_default();
    let said: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
    assert!(said.is_empty(), "{said:#?} in\n{source}");
}

/// Two wheels on ground, with a gear joint of a multi-point constraint between them and whatever else holds or moves them.
fn gears(first: &str, rest: &str) -> String {
    format!(
        "mechanism M in space {{ ground {{ axis r = (0, 0, 1); }} body a {{ axis r = (0, 0, 1); {first} }}
         body b {{ axis r = (0, 0, 1); mass = 3kg; inertia = ball(1m); }} joint gears = gear_joint(ground, a, b, ground.r, ground.r, 2.5);
         {rest} }}"
    )
}

#[test]
fn equations_of_velocities_may_act_on_what_others_hold() {
    // Welded to a body with mass, or driven.
    let hub = "body hub { axis r = (0, 0, 1); mass = 1kg; inertia = ball(1m); } joint held = weld(hub.position, hub.r, a.position, a.r);
        freedom q = dot(hub.angular_velocity, (0, 0, 1));";
    compiles(&gears("", hub));
    let offset = "body hub { axis r = (0, 0, 1); point P = (1m, 0m, 0m); mass = 1kg; inertia = ball(1m); }
        joint held = weld(hub.P, hub.r, a.position, a.r); freedom q = dot(hub.angular_velocity, (0, 0, 1));";
    compiles(&gears("start position = (1m, 0m, 0m);", offset));
    // A mass away from the axis resists a turn about it.
    compiles(
        "mechanism M in space { ground { axis r = (0, 0, 1); } body a { axis r = (0, 0, 1); mass = 1kg; center = (1m, 0m, 0m); }
         body b { axis r = (0, 0, 1); mass = 3kg; inertia = ball(1m); }
         joint one = revolute(ground.position, ground.r, a.position, a.r); joint two = revolute((3m, 0m, 0m), ground.r, b.position, b.r);
         joint row = { 2 * dot((0, 0, 1), a.angular_velocity) + dot((0, 0, 1), b.angular_velocity) == 0; } freedom q = one.angle; }",
    );
    // Mass and inertia of the joint.
    compiles(&gears("", "freedom q = dot(b.angular_velocity, (0, 0, 1));").replace("2.5)", "2.5, mass: 1kg, inertia: 0.1kgm2)"));
}

#[test]
fn equations_of_positions_may_hold_what_has_no_mass() {
    compiles(
        "mechanism M { body a { mass = 1kg; inertia = 1kgm2; } body b { } joint p = revolute(ground.position, a.position);
         joint q = revolute((1m, 0m), b.position); joint mesh = gear_pair(a, b, 100mm, 200mm); freedom s = a.angle; }",
    );
    compiles(
        "mechanism M { ground { point D = (350mm, 0mm); } body crank { point B = (100mm, 0mm); mass = 1kg; inertia = 1kgm2; }
         body coupler { point C = (300mm, 0mm); } body rocker { point C = (250mm, 0mm); start angle = 100deg; }
         joint a = revolute(ground.position, crank.position); joint b = revolute(crank.B, coupler.position);
         joint c = revolute(coupler.C, rocker.C); joint d = revolute(rocker.position, ground.D); freedom swing = crank.angle from 60deg; }",
    );
}

#[test]
fn in_pure_kinematics_nothing_needs_a_mass() {
    compiles(
        "mechanism M { body a { mass = 1kg; inertia = 1kgm2; } body b { } joint p = revolute(ground.position, a.position);
         joint q = revolute((1m, 0m), b.position); joint mesh = { b.angular_velocity == -2 * a.angular_velocity; }
         drive d = drive_angle(a, 60rpm * t); }",
    );
    compiles(
        "mechanism M { body a { mass = 1kg; inertia = 1kgm2; } body b { } body c { mass = 1kg; inertia = 1kgm2; }
         joint p = revolute(ground.position, a.position); joint q = revolute((1m, 0m), b.position); joint r = revolute((2m, 0m), c.position);
         joint mesh = { b.angular_velocity == -2 * a.angular_velocity; } drive d = drive_angle(b, 60rpm * t); freedom s = c.angle; }",
    );
}
