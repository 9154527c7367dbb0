//! Mechanisms for every path through the solver.

use reuleaux::mechanism;

mechanism! {
    /// A mechanism without iterated coordinates.
    pub mechanism Rod {
        param w: AngularVelocity = 1rad_s;
        param length: Length = 1m;
        body rod { point A = (length, 0m); }
        body end {}
        joint o = revolute(ground.position, rod.position);
        joint a = revolute(rod.A, end.position);
        joint level = absolute_angle(end, 0rad);
        drive motor = drive_angle(rod, w * t);
        output tip = rod.A;
    }
}

mechanism! {
    /// The same without a length as a parameter: coordinates that follow from the angle are not tested individually.
    pub mechanism Bare {
        param w: AngularVelocity = 1rad_s;
        body rod { point A = (1m, 0m); }
        body end {}
        joint o = revolute(ground.position, rod.position);
        joint a = revolute(rod.A, end.position);
        joint level = absolute_angle(end, 0rad);
        drive motor = drive_angle(rod, w * t);
    }
}

mechanism! {
    /// A block of two angles, with a wheel behind it.
    pub mechanism Crank {
        param base: Length = 400mm;
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param speed: AngularVelocity = 60rpm;
        ground { point O = (0mm, 0mm);  point C = (base, 0mm);  point W = (600mm, 0mm); }
        body crank { point A = (crank_length, 0mm);  start angle = 0deg; }
        body coupler { point B = (coupler_length, 0mm);  point P = (175mm, 80mm); }
        body rocker { point B = (rocker_length, 0mm);  start angle = 70deg; }
        body wheel {}
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        joint w = revolute(ground.W, wheel.position);
        joint mesh = gear_pair(rocker, wheel, 3, 1);
        drive input = drive_angle(crank, speed * t);
        output tip = coupler.P;
    }
}

mechanism! {
    /// A slide on an incline.
    pub mechanism Incline {
        param incline: Angle = 20deg;
        param crank_length: Length = 100mm;
        param rod_length: Length = 300mm;
        param speed: AngularVelocity = 60rpm;
        let way = (cos(incline), sin(incline));
        body crank { point A = (crank_length, 0mm); }
        body rod { point B = (rod_length, 0mm);  start angle = incline; }
        body slide {}
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational(way, ground.position, slide.position, incline);
        drive input = drive_angle(crank, speed * t);
        output travel = dot(slide.position, way);
    }
}

mechanism! {
    /// Distance equations, which are squares of lengths, in one block of three.
    pub mechanism Plate {
        param side: Length = 200mm;
        param reach: Length = 400mm;
        param stroke: Length = 50mm;
        param frequency: AngularVelocity = 1rad_s;
        ground { point A = (0mm, -reach);  point B = (side, -reach);  point C = (0mm - reach, side); }
        body plate { point P = (side, 0mm);  point Q = (0mm, side); start angle = 0deg; start position = (0mm, 0mm); }
        drive a = drive_distance(ground.A, plate.position, reach + stroke * sin(frequency * t));
        drive b = drive_distance(ground.B, plate.P, reach - stroke * sin(2 * frequency * t));
        drive c = drive_distance(ground.C, plate.Q, reach + stroke * sin(3 * frequency * t));
        output corner = plate.Q;
    }
}

mechanism! {
    /// Laws that end, have poles, or grow without bound.
    pub mechanism Laws {
        param time: Time = 1s;
        param height: Length = 1m;
        param arm: Length = 200mm;
        body rising {}
        body falling {}
        body wheel {}
        joint upright = absolute_angle(rising, 0rad);
        drive level = drive_y(rising.position, height * exp(0 - t / time));
        drive way = drive_x(rising.position, height * sqrt(2 + t / time));
        joint still = absolute_angle(falling, 0rad);
        joint depth = absolute_x(falling.position, arm);
        drive drop = drive_y(falling.position, height * polynomial_4567(t / time) + arm * tan(0.1rad * (t / time)));
        joint axle = revolute(ground.position, wheel.position);
        drive turn = drive_angle(wheel, 1rad * (t / time)^2 + 1rad * ln(2 + t / time));
    }
}

mechanism! {
    /// Parts at rest beside a moving part.
    pub mechanism Scene {
        param held: Angle = 50deg;
        param speed: AngularVelocity = 60rpm;
        ground { for i in 0..4 { point O[i] = (i * 1m, 0m);  point C[i] = (i * 1m + 400mm, 0m); } }
        for i in 0..4 {
            body crank[i] { point A = (100mm, 0mm); }
            body coupler[i] { point B = (350mm, 0mm); }
            body rocker[i] { point B = (300mm, 0mm);  start angle = 70deg; }
            joint o[i] = revolute(ground.O[i], crank[i].position);
            joint a[i] = revolute(crank[i].A, coupler[i].position);
            joint b[i] = revolute(coupler[i].B, rocker[i].B);
            joint c[i] = revolute(rocker[i].position, ground.C[i]);
        }
        for i in 0..3 { drive hold[i] = drive_angle(crank[i], held); }
        drive input = drive_angle(crank[3], speed * t);
    }
}

mechanism! {
    /// A mechanism with more equations than coordinates.
    pub mechanism Coupled {
        param middle: Length = 500mm;
        param speed: AngularVelocity = 2rad_s;
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
        drive input = drive_angle(crank, 60deg + speed * t);
    }
}
