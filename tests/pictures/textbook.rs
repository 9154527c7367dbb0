//! Textbook mechanisms, with each kind of joint of the library.

/// Name and declaration.
pub(crate) const MECHANISMS: [(&str, &str); 14] = [
    (
        "peaucellier",
        "pub mechanism Peaucellier {
            param long: Length = 130mm;
            param side: Length = 60mm;
            ground { point O = (0mm, 0mm); point C = (50mm, 0mm); }
            body crank  { point C = (0mm, 0mm); point B = (50mm, 0mm); }
            body arm_1  { point O = (0mm, 0mm); point D = (long, 0mm); start angle = 30deg; }
            body arm_2  { point O = (0mm, 0mm); point E = (long, 0mm); start angle = -20deg; }
            body side_1 { point B = (0mm, 0mm); point D = (side, 0mm); start angle = 60deg; }
            body side_2 { point B = (0mm, 0mm); point E = (side, 0mm); start angle = -60deg; }
            body side_3 { point D = (0mm, 0mm); point P = (side, 0mm); start angle = -60deg; }
            body side_4 { point E = (0mm, 0mm); point P = (side, 0mm); start angle = 60deg; }
            joint c = revolute(ground.C, crank.C);
            joint o1 = revolute(ground.O, arm_1.O);
            joint o2 = revolute(ground.O, arm_2.O);
            joint b1 = revolute(crank.B, side_1.B);
            joint b2 = revolute(crank.B, side_2.B);
            joint d1 = revolute(arm_1.D, side_1.D);
            joint d2 = revolute(arm_1.D, side_3.D);
            joint e1 = revolute(arm_2.E, side_2.E);
            joint e2 = revolute(arm_2.E, side_4.E);
            joint p = revolute(side_3.P, side_4.P);
            drive input = drive_angle(crank, 20deg + 20rpm * t);
            output pen = side_3.P;
        }",
    ),
    (
        "scotch_yoke",
        "pub mechanism ScotchYoke {
            ground { point O = (0mm, 0mm); axis way = (1, 0); }
            body crank { point O = (0mm, 0mm); point A = (40mm, 0mm); }
            body yoke  { point S = (0mm, 0mm); point T = (120mm, 0mm); axis up = (0, 1); }
            joint main = revolute(ground.O, crank.O);
            joint guide = translational(ground.way, ground.O, yoke.T);
            joint slot = point_on_line(yoke.S, yoke.up, crank.A);
            drive motor = drive_angle(crank, 50deg + 60rpm * t);
        }",
    ),
    (
        "open_belt",
        "pub mechanism Belt {
            ground { point A = (0mm, 0mm); point B = (300mm, 40mm); }
            body motor { point A = (0mm, 0mm); }
            body fan   { point B = (0mm, 0mm); }
            joint a = revolute(ground.A, motor.A);
            joint b = revolute(ground.B, fan.B);
            joint strap = belt(motor, fan, 40mm, 90mm);
            drive input = drive_angle(motor, 100rpm * t);
        }",
    ),
    (
        "crossed_belt",
        "pub mechanism Crossed {
            ground { point A = (0mm, 0mm); point B = (300mm, 40mm); }
            body motor { point A = (0mm, 0mm); }
            body fan   { point B = (0mm, 0mm); }
            joint a = revolute(ground.A, motor.A);
            joint b = revolute(ground.B, fan.B);
            joint strap = belt(motor, fan, 20, -30);
            drive input = drive_angle(motor, -100rpm * t);
        }",
    ),
    (
        "five_bar",
        "pub mechanism FiveBar {
            ground { point A = (0mm, 0mm); point E = (200mm, 0mm); }
            body left      { point A = (0mm, 0mm); point B = (150mm, 0mm); }
            body right     { point E = (0mm, 0mm); point D = (150mm, 0mm); }
            body left_arm  { point B = (0mm, 0mm); point P = (200mm, 0mm); start angle = 40deg; }
            body right_arm { point D = (0mm, 0mm); point P = (200mm, 0mm); start angle = 140deg; }
            joint a = revolute(ground.A, left.A);
            joint e = revolute(ground.E, right.E);
            joint b = revolute(left.B, left_arm.B);
            joint d = revolute(right.D, right_arm.D);
            joint p = revolute(left_arm.P, right_arm.P);
            drive left_motor = drive_angle(left, 110deg + 1rad_s * t);
            drive right_motor = drive_angle(right, 70deg - 1rad_s * t);
            output tool = left_arm.P;
        }",
    ),
    (
        "planar_robot",
        "pub mechanism Robot {
            ground { point A = (0mm, 0mm); point B = (400mm, 0mm); point C = (200mm, 346mm); }
            body plate {
                point P = (-60mm, -35mm); point Q = (60mm, -35mm); point R = (0mm, 70mm);
                start position = (200mm, 115mm); start angle = 5deg;
            }
            body crank_a { point A = (0mm, 0mm); point E = (130mm, 0mm); }
            body crank_b { point B = (0mm, 0mm); point E = (130mm, 0mm); }
            body crank_c { point C = (0mm, 0mm); point E = (130mm, 0mm); }
            body arm_a { point E = (0mm, 0mm); point P = (130mm, 0mm); }
            body arm_b { point E = (0mm, 0mm); point Q = (130mm, 0mm); }
            body arm_c { point E = (0mm, 0mm); point R = (130mm, 0mm); }
            joint a1 = revolute(ground.A, crank_a.A);
            joint a2 = revolute(crank_a.E, arm_a.E);
            joint a3 = revolute(arm_a.P, plate.P);
            joint b1 = revolute(ground.B, crank_b.B);
            joint b2 = revolute(crank_b.E, arm_b.E);
            joint b3 = revolute(arm_b.Q, plate.Q);
            joint c1 = revolute(ground.C, crank_c.C);
            joint c2 = revolute(crank_c.E, arm_c.E);
            joint c3 = revolute(arm_c.R, plate.R);
            drive m1 = drive_angle(crank_a, 80deg + 1rad_s * t);
            drive m2 = drive_angle(crank_b, 200deg + 1rad_s * t);
            drive m3 = drive_angle(crank_c, -40deg);
            output tool = plate.position;
        }",
    ),
    (
        "trammel",
        "pub mechanism Trammel {
            ground { axis across = (1, 0); axis up = (0, 1); }
            body beam   { point A = (0mm, 0mm); point B = (200mm, 0mm); point P = (280mm, 0mm); start angle = 130deg; }
            body slider { }
            joint foot = point_on_line(ground.position, ground.across, beam.A);
            joint guide = translational(ground.up, ground.position, slider.position);
            joint pin = revolute(slider.position, beam.B);
            drive push = drive_along(guide, 120mm + 20mm_s * t);
            output pen = beam.P;
        }",
    ),
    (
        "oldham",
        "pub mechanism Oldham {
            ground { point A = (0mm, 0mm); point B = (60mm, 30mm); }
            body disc   { point A = (0mm, 0mm); axis u = (1, 0); }
            body other  { point B = (0mm, 0mm); axis v = (0, 1); }
            body middle { }
            joint a = revolute(ground.A, disc.A);
            joint b = revolute(ground.B, other.B);
            joint one = translational(disc.u, disc.A, middle.position);
            joint two = translational(other.v, other.B, middle.position);
            drive motor = drive_angle(disc, 70deg + 10rad_s * t);
        }",
    ),
    (
        "crane",
        "pub mechanism Crane {
            ground { point A = (0m, 0m); }
            body mast { point A = (0m, 0m); point B = (0m, 3m); }
            body jib  { point B = (0m, 0m); point K = (1.5m, 0.2m); point T = (4m, 0.5m); axis rail = (8, 1); }
            body trolley { }
            body load { point H = (0m, 0m); }
            joint foot = weld(ground.A, mast.A);
            joint hinge = revolute(mast.B, jib.B);
            drive luff = drive_distance(mast.A, jib.K, 3.6m + 0.1m_s * t);
            joint rail = translational(jib.rail, jib.B, trolley.position);
            drive run = drive_along(rail, 2.5m + 0.1m_s * t);
            joint rope = distance(trolley.position, load.H, 1.2m);
            joint plumb = absolute_angle(load, 0);
            joint hang = { load.H.x == trolley.x + 0.1m; }
        }",
    ),
    (
        "watt",
        "pub mechanism Watt {
            ground { point O = (0mm, 0mm); point C = (120mm, 0mm); point F = (260mm, 20mm); }
            body crank   { point O = (0mm, 0mm); point A = (40mm, 0mm); }
            body coupler { point A = (0mm, 0mm); point B = (120mm, 0mm); }
            body rocker  { point C = (0mm, 0mm); point B = (80mm, 0mm); point D = (60mm, -50mm); start angle = 80deg; }
            body rod     { point D = (0mm, 0mm); point E = (110mm, 0mm); start angle = 10deg; }
            body swing   { point F = (0mm, 0mm); point E = (90mm, 0mm); start angle = 80deg; }
            joint o = revolute(ground.O, crank.O);
            joint a = revolute(crank.A, coupler.A);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.C, ground.C);
            joint d = revolute(rocker.D, rod.D);
            joint e = revolute(rod.E, swing.E);
            joint f = revolute(swing.F, ground.F);
            drive motor = drive_relative_angle(ground, crank, 60deg + 10rad_s * t);
        }",
    ),
    (
        "differential",
        "pub mechanism Axle {
            ground { point A = (0mm, 0mm); }
            body left    { point A = (0mm, 0mm); }
            body right   { point A = (0mm, 0mm); }
            body housing { point A = (0mm, 0mm); }
            joint l = revolute(ground.A, left.A);
            joint r = revolute(ground.A, right.A);
            joint h = revolute(ground.A, housing.A);
            joint bevel = differential(left, right, housing);
            drive one = drive_angle(left, 1rad_s * t);
            drive two = drive_angle(right, 2rad_s * t);
        }",
    ),
    (
        "knife_cam",
        "pub mechanism Knife {
            function R(psi: Angle) -> Length = 30mm + 8mm * cos(psi);
            ground { point O = (0mm, 0mm); point G = (5mm, 0mm); axis up = (0, 1); }
            body cam      { point O = (0mm, 0mm); }
            body follower { point F = (0mm, 0mm); start position = (5mm, 35mm); }
            joint shaft = revolute(ground.O, cam.O);
            joint guide = translational(ground.up, ground.G, follower.F);
            joint touch = cam_knife(cam.O, follower.F, R);
            drive motor = drive_angle(cam, 40deg + 10rad_s * t);
        }",
    ),
    (
        "pantograph",
        "pub mechanism Pantograph {
            ground { point A = (0mm, 0mm); }
            body one   { point A = (0mm, 0mm); point B = (100mm, 0mm); point C = (200mm, 0mm); start angle = 60deg; }
            body two   { point B = (0mm, 0mm); point D = (100mm, 0mm); start angle = -60deg; }
            body three { point D = (0mm, 0mm); point E = (100mm, 0mm); start angle = 60deg; }
            body four  { point C = (0mm, 0mm); point E = (100mm, 0mm); point P = (200mm, 0mm); start angle = -60deg; }
            joint a = revolute(ground.A, one.A);
            joint b = revolute(one.B, two.B);
            joint c = revolute(one.C, four.C);
            joint d = revolute(two.D, three.D);
            joint e = revolute(three.E, four.E);
            drive lead_x = drive_x(two.D, 100mm + 10mm_s * t);
            drive lead_y = drive_y(two.D, 5mm);
            output pen = four.P;
        }",
    ),
    (
        "internal_gear",
        "pub mechanism Internal {
            ground { point A = (0mm, 0mm); point B = (30mm, 0mm); }
            body small { point A = (0mm, 0mm); }
            body ring  { point B = (0mm, 0mm); }
            joint a = revolute(ground.A, small.A);
            joint b = revolute(ground.B, ring.B);
            joint mesh = gear_pair(small, ring, 20, -50);
            drive motor = drive_angle(small, 1rad_s * t);
        }",
    ),
];
