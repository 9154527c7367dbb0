//! Four-bars in a row, released: cranks and couplers of 1 m and 1 kg (D2).

use reuleaux::mechanism;

macro_rules! chain {
    ($name:ident, $loops:literal) => {
        mechanism! {
            /// Four-bars in a row.
            pub mechanism $name {
                /// Angle of the first crank.
                param start: Angle = 60deg;
                /// Its rate.
                param speed: AngularVelocity = 0rad_s;
                let loops = $loops;
                gravity = (0, -9.81m_s2);
                ground { for j in 0..=loops { point O[j] = (j * 1m, 0m); } }
                for j in 0..=loops { body crank[j] { point B = (1m, 0m);  mass = 1kg;  center = (0.5m, 0m);  inertia = rod(1m);  start angle = 90deg; } }
                for j in 0..loops { body coupler[j] { point C = (1m, 0m);  mass = 1kg;  center = (0.5m, 0m);  inertia = rod(1m);  start angle = 0deg; } }
                for j in 0..=loops { joint axle[j] = revolute(ground.O[j], crank[j].position); }
                for j in 0..loops {
                    joint left[j] = revolute(crank[j].B, coupler[j].position);
                    joint right[j] = revolute(coupler[j].C, crank[j + 1].B);
                }
                freedom swing = crank[0].angle from start at speed;
            }
        }
    };
}

chain!(ChainOf1, 1);
chain!(ChainOf2, 2);
chain!(ChainOf10, 10);
chain!(ChainOf40, 40);
