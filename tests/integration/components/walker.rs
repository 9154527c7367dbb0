//! A walker with two of Jansen's legs, once with a component, once written out.

reuleaux::mechanism! {
    /// Two legs on one crank.
    #[allow(far_start)]
    pub mechanism Walker {
        param speed: AngularVelocity = 30rpm;
        let legs = 2;
        let spread: Length = 41.5mm;

        ground { point O = (0mm, 0mm);  for i in 0..legs { point V[i] = (-38mm, (0.1 * i - 7.8) * 1mm); } }
        body crank {
            point O = (0mm, 0mm);
            for i in 0..legs { point X[i] = (15mm * (1 - 2 * i), 0mm); }
        }
        joint axle = revolute(ground.O, crank.O);
        drive motor = drive_angle(crank, speed * t);
        for i in 0..legs { part leg[i] = Leg(ground.V[i], crank.X[i], i + 2 * (1 - i)); }

        /// One of Jansen's legs.
        component Leg(pivot: Point, pin: Point, number: Number, lean: Length = 2.6mm) {
            /// From the knee to the foot's upper pin.
            param shin: Length = 39.3mm;
            body bar_j { point X = (0mm, 0mm);  point U = (50mm, 0mm);  start angle = 1rad + 0.5rad * number; }
            body upper { point V = (0mm, 0mm);  point U = (spread, 0mm);  point W = (lean, 40mm); }
            joint x = revolute(pin, bar_j.X);
            joint u = revolute(bar_j.U, upper.U);
            joint v = revolute(pivot, upper.V);
            part knee = Knee(pivot, pin, upper.W, shin);
            output knee_angle = upper.angle - knee.foot.angle;
        }

        component Knee(pivot: Point, pin: Point, W: Point, shin: Length) {
            param calf[0]: Length = 36mm;
            param calf[1]: Length = 2 * shin_default;
            let shin_default: Length = 22mm;
            body bar[0] { point X = (0mm, 0mm);  point C = (61.9mm, 0mm); }
            body bar[1] { point V = (0mm, 0mm);  point C = (shin, 0mm); }
            body bar[2] { point W = (0mm, 0mm);  point F = (39.4mm, 0mm); }
            body foot { point F = (0mm, 0mm);  point C = (calf[0] + 0.7mm, 0mm);  point T = (calf[1], -48mm); }
            joint x = revolute(pin, bar[0].X);
            joint v = revolute(pivot, bar[1].V);
            joint c = revolute(bar[0].C, bar[1].C);
            joint w = revolute(W, bar[2].W);
            joint f = revolute(bar[2].F, foot.F);
            joint g = revolute(bar[1].C, foot.C);
            output toe = foot.T;
            output foot = foot;
        }
    }
}

reuleaux::mechanism! {
    /// The same, written out.
    #[allow(far_start)]
    pub mechanism WrittenOut {
        param speed: AngularVelocity = 30rpm;
        param shin_0: Length = 39.3mm;
        param calf_00: Length = 36mm;
        param calf_01: Length = 44mm;
        param shin_1: Length = 39.3mm;
        param calf_10: Length = 36mm;
        param calf_11: Length = 44mm;

        ground { point O = (0mm, 0mm);  point V_0 = (-38mm, -7.8mm);  point V_1 = (-38mm, -7.7mm); }
        body crank { point O = (0mm, 0mm);  point X_0 = (15mm, 0mm);  point X_1 = (-15mm, 0mm); }
        body bar_j_0 { point X = (0mm, 0mm);  point U = (50mm, 0mm);  start angle = 2rad; }
        body upper_0 { point V = (0mm, 0mm);  point U = (41.5mm, 0mm);  point W = (2.6mm, 40mm); }
        body bar_k_0 { point X = (0mm, 0mm);  point C = (61.9mm, 0mm); }
        body bar_c_0 { point V = (0mm, 0mm);  point C = (shin_0, 0mm); }
        body bar_f_0 { point W = (0mm, 0mm);  point F = (39.4mm, 0mm); }
        body foot_0 { point F = (0mm, 0mm);  point C = (calf_00 + 0.7mm, 0mm);  point T = (calf_01, -48mm); }
        body bar_j_1 { point X = (0mm, 0mm);  point U = (50mm, 0mm);  start angle = 1.5rad; }
        body upper_1 { point V = (0mm, 0mm);  point U = (41.5mm, 0mm);  point W = (2.6mm, 40mm); }
        body bar_k_1 { point X = (0mm, 0mm);  point C = (61.9mm, 0mm); }
        body bar_c_1 { point V = (0mm, 0mm);  point C = (shin_1, 0mm); }
        body bar_f_1 { point W = (0mm, 0mm);  point F = (39.4mm, 0mm); }
        body foot_1 { point F = (0mm, 0mm);  point C = (calf_10 + 0.7mm, 0mm);  point T = (calf_11, -48mm); }

        joint axle = revolute(ground.O, crank.O);
        drive motor = drive_angle(crank, speed * t);
        joint x_0 = revolute(crank.X_0, bar_j_0.X);
        joint u_0 = revolute(bar_j_0.U, upper_0.U);
        joint v_0 = revolute(ground.V_0, upper_0.V);
        joint k_0 = revolute(crank.X_0, bar_k_0.X);
        joint b_0 = revolute(ground.V_0, bar_c_0.V);
        joint c_0 = revolute(bar_k_0.C, bar_c_0.C);
        joint w_0 = revolute(upper_0.W, bar_f_0.W);
        joint f_0 = revolute(bar_f_0.F, foot_0.F);
        joint g_0 = revolute(bar_c_0.C, foot_0.C);
        joint x_1 = revolute(crank.X_1, bar_j_1.X);
        joint u_1 = revolute(bar_j_1.U, upper_1.U);
        joint v_1 = revolute(ground.V_1, upper_1.V);
        joint k_1 = revolute(crank.X_1, bar_k_1.X);
        joint b_1 = revolute(ground.V_1, bar_c_1.V);
        joint c_1 = revolute(bar_k_1.C, bar_c_1.C);
        joint w_1 = revolute(upper_1.W, bar_f_1.W);
        joint f_1 = revolute(bar_f_1.F, foot_1.F);
        joint g_1 = revolute(bar_c_1.C, foot_1.C);

        output toe_0 = foot_0.T;
        output toe_1 = foot_1.T;
        output angle_0 = upper_0.angle - foot_0.angle;
        output angle_1 = upper_1.angle - foot_1.angle;
    }
}
