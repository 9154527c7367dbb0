//! The mechanisms of the reference files in space, with the numbers of the files.

use reuleaux::mechanism;

mechanism! {
    /// `space/bevel_differential.json`.
    pub(crate) mechanism BevelDifferential in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); axis a2 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); axis a3 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); }
        body carrier { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.0m, -0.06m, 0.0m); axis a3 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); point P4 = (0.0m, 0.06m, 0.0m); axis a5 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); point P6 = (0.05m, 0.0m, 0.0m); axis a7 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a8 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a9 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); axis a10 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a11 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); axis a12 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 4.0kg; center = (0.02m, 0.0m, 0.01m); inertia = (0.03kgm2, 0.05kgm2, 0.04kgm2, 0.002kgm2, 0.0kgm2, 0.001kgm2); }
        body side1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); axis a2 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); axis a3 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0000m, -0.0600m, 0.0000m); mass = 1.0kg; inertia = (0.001kgm2, 0.0015kgm2, 0.001kgm2); }
        body side2 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); axis a2 = (0.0, 1.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0000m, 0.0600m, 0.0000m); mass = 1.0kg; inertia = (0.001kgm2, 0.0016kgm2, 0.001kgm2); }
        body planet { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); axis a2 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a3 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0500m, 0.0000m, 0.0000m); mass = 0.4kg; inertia = (0.0004kgm2, 0.0003kgm2, 0.0003kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, carrier.P0, carrier.a1);
        joint j1 = revolute(carrier.P2, carrier.a3, side1.P0, side1.a1);
        joint j2 = revolute(carrier.P4, carrier.a5, side2.P0, side2.a1);
        joint j3 = revolute(carrier.P6, carrier.a7, planet.P0, planet.a1);
        joint j4 = gear_pair(joint_angle(carrier.a8, planet.a2), joint_angle(carrier.a9, side1.a2), 10.0, 16.0, 0.0 * 1rad);
        joint j5 = gear_pair(joint_angle(carrier.a10, planet.a3), joint_angle(carrier.a11, side2.a2), 10.0, -16.0, 0.0 * 1rad);
        drive j6 = drive_rotation(joint_angle(ground.a2, carrier.a12), (0.0 + 9.0 * (t / 1s)^1) * 1rad);
        drive j7 = drive_rotation(joint_angle(ground.a3, side1.a3), (0.0 + 11.0 * (t / 1s)^1 + 0.0 + 0.4 * sin((5.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/cardan_shaft.json`.
    pub(crate) mechanism CardanShaft in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (-0.15m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); point P2 = (0.651597795m, 0.194709171m, 0.0591040413m); axis a3 = (0.955336489, 0.0, 0.295520207) from (0.0, 1.0, 0.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); }
        body input { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.15m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); start position = (-0.1500m, 0.0000m, 0.0000m); mass = 1.2kg; center = (0.0m, 0.001m, 0.0m); inertia = (0.002kgm2, 0.01kgm2, 0.01kgm2); }
        body middle { point P0 = (-0.25m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.25m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0); start position = (0.2300m, 0.0974m, -0.0000m); start orientation = turn((-0.0000, 0.0000, 1.0000), 0.4007rad); mass = 1.6kg; center = (0.01m, 0.0m, 0.002m); inertia = (0.0015kgm2, 0.03kgm2, 0.031kgm2); }
        body output { point P0 = (-0.2m, 0.0m, 0.0m); axis a1 = (0.0, -1.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (1.0, 0.0, 0.0); start position = (0.6520m, 0.1950m, 0.0591m); start orientation = turn((-0.0000, -1.0000, -0.0000), 0.2991rad); mass = 1.1kg; inertia = (0.002kgm2, 0.009kgm2, 0.009kgm2, 0.0kgm2, 0.0001kgm2, 0.0kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, input.P0, input.a1);
        joint j1 = universal(input.P2, input.a3, middle.P0, middle.a1);
        joint j2 = universal(middle.P2, middle.a3, output.P0, output.a1);
        joint j3 = cylindrical(ground.P2, ground.a3, output.P2, output.a3);
        drive j4 = drive_rotation(joint_angle(ground.a4, input.a4), (0.0 + 15.0 * (t / 1s)^1) * 1rad);
    }
}

mechanism! {
    /// `space/four_bar_in_space.json`.
    pub(crate) mechanism FourBarInSpace in space {
        gravity = (0.0m_s2, -9.81m_s2, -2.0m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.35m, 0.0m, 0.1m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body crank { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.1m, 0.0m, 0.05m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 0.8kg; center = (0.05m, 0.0m, 0.02m); inertia = (0.0004kgm2, 0.002kgm2, 0.0021kgm2); }
        body coupler { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.3m, 0.0m, 0.05m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.1000m, 0.0000m, 0.0500m); start orientation = turn((0.0000, 0.0000, 1.0000), 0.9273rad); mass = 1.5kg; center = (0.16m, 0.05m, 0.03m); inertia = (0.001kgm2, 0.015kgm2, 0.0152kgm2, 0.0kgm2, 0.0003kgm2, 0.0kgm2); }
        body rocker { point P0 = (0.25m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0); start position = (0.3500m, 0.0000m, 0.1000m); start orientation = turn((0.0000, 0.0000, 1.0000), 1.8546rad); mass = 1.2kg; center = (0.12m, 0.0m, 0.0m); inertia = (0.0008kgm2, 0.009kgm2, 0.0095kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, crank.P0, crank.a1);
        joint j1 = revolute(crank.P2, crank.a3, coupler.P0, coupler.a1);
        joint j2 = revolute(coupler.P2, coupler.a3, rocker.P0, rocker.a1);
        redundant joint j3 = revolute(ground.P2, ground.a3, rocker.P2, rocker.a3);
        drive j4 = drive_rotation(joint_angle(ground.a4, crank.a4), (0.0 + 12.0 * (t / 1s)^1 + 0.0 + 0.05 * sin((24.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/hooke_joint.json`.
    pub(crate) mechanism HookeJoint in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (-0.2m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); axis a2 = (0.866024792, 0.50000106, 0.0) from (0.0, 0.0, 1.0); axis a3 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); }
        body shaft1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.2m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); start position = (-0.2000m, 0.0000m, 0.0000m); mass = 1.5kg; center = (0.05m, 0.002m, 0.0m); inertia = (0.002kgm2, 0.01kgm2, 0.0101kgm2); }
        body shaft2 { point P0 = (-0.3m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); axis a2 = (1.0, 0.0, 0.0); start position = (0.2600m, 0.1500m, 0.0000m); start orientation = turn((0.0000, 0.0000, 1.0000), 0.5239rad); mass = 2.0kg; center = (0.0m, 0.001m, 0.002m); inertia = (0.003kgm2, 0.014kgm2, 0.015kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, shaft1.P0, shaft1.a1);
        joint j1 = universal(shaft1.P2, shaft1.a3, shaft2.P0, shaft2.a1);
        joint j2 = parallel_axes(ground.a2, shaft2.a2);
        drive j3 = drive_rotation(joint_angle(ground.a3, shaft1.a4), (0.0 + 20.0 * (t / 1s)^1 + 0.0 + 0.1 * sin((15.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/rscr_four_bar.json`.
    pub(crate) mechanism RscrFourBar in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.35m, 0.2m, 0.1m); axis a3 = (0.1, 1.0, 0.25) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body crank { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.08m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 0.5kg; center = (0.04m, 0.0m, 0.0m); inertia = (0.0005kgm2, 0.0002667kgm2, 0.0002667kgm2); }
        body coupler { point P0 = (-0.105517066m, -0.0368784079m, -0.0642738816m); point P1 = (0.105517066m, 0.0368784079m, 0.0642738816m); axis a2 = (-0.0375833605, 0.0908853831, 1.04418741) from (0.934217495, 0.185292375, 0.304802244); start position = (0.2050m, 0.0100m, 0.0300m); start orientation = turn((0.4086, 0.8162, -0.4086), 0.3997rad); mass = 0.7kg; center = (0.01m, 0.0m, 0.02m); inertia = (0.002kgm2, 0.006kgm2, 0.007kgm2, 0.0003kgm2, -0.0002kgm2, 0.0001kgm2); }
        body rocker { point P0 = (0.0393900408m, -0.175758743m, -0.0442412565m); axis a1 = (0.686789459, 0.115844168, 0.784155832); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (-0.21691333, 0.974427108, 0.275572892); start position = (0.3500m, 0.2000m, 0.1000m); start orientation = turn((0.0000, -0.7071, -0.7071), 0.6003rad); mass = 1.1kg; center = (0.0m, 0.02m, -0.03m); inertia = (0.004kgm2, 0.003kgm2, 0.005kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, crank.P0, crank.a1);
        joint j1 = spherical(crank.P2, coupler.P0);
        joint j2 = cylindrical(coupler.P1, coupler.a2, rocker.P0, rocker.a1);
        joint j3 = revolute(ground.P2, ground.a3, rocker.P2, rocker.a3);
        drive j4 = drive_rotation(joint_angle(ground.a4, crank.a3), (0.0 + 5.0 * (t / 1s)^1) * 1rad);
    }
}

mechanism! {
    /// `space/rssr_four_bar.json`.
    pub(crate) mechanism RssrFourBar in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.3m, 0.25m, 0.05m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body crank { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.1m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 0.6kg; center = (0.05m, 0.0m, 0.01m); inertia = (0.0006kgm2, 0.0005kgm2, 0.0005kgm2); }
        body rocker { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.11339903m, 0.0m, -0.22280184m); start position = (0.3000m, 0.2500m, 0.0500m); mass = 0.8kg; center = (0.0566995152m, 0.0m, -0.11140092m); inertia = (0.0008kgm2, 0.004167kgm2, 0.004167kgm2, 0.0kgm2, 0.001kgm2, 0.0kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, crank.P0, crank.a1);
        joint j1 = revolute(ground.P2, ground.a3, rocker.P0, rocker.a1);
        joint j2 = distance(crank.P2, rocker.P2, 0.436554038m);
        drive j3 = drive_rotation(joint_angle(ground.a4, crank.a3), (0.0 + 6.0 * (t / 1s)^1 + 0.0 + 0.2 * sin((6.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/rsur_four_bar.json`.
    pub(crate) mechanism RsurFourBar in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.3m, 0.25m, 0.05m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body crank { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.1m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 0.6kg; center = (0.05m, 0.0m, 0.01m); inertia = (0.0006kgm2, 0.0005kgm2, 0.0005kgm2); }
        body coupler { point P0 = (-0.218277019m, 0.0m, 0.0m); point P1 = (0.218277019m, 0.0m, 0.0m); axis a2 = (0.0, 1.0, 0.0); start position = (0.2570m, 0.1250m, -0.0864m); start orientation = turn((0.8827, 0.4676, 0.0468), 1.8544rad); mass = 0.9kg; inertia = (0.0009kgm2, 0.01429kgm2, 0.01429kgm2, 0.0001kgm2, 0.0kgm2, 0.0002kgm2); }
        body rocker { point P0 = (0.11339903m, 0.0m, -0.22280184m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 1.0, 0.0); start position = (0.3000m, 0.2500m, 0.0500m); mass = 0.8kg; center = (0.0566995152m, 0.0m, -0.11140092m); inertia = (0.0008kgm2, 0.004167kgm2, 0.004167kgm2, 0.0kgm2, 0.001kgm2, 0.0kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, crank.P0, crank.a1);
        joint j1 = spherical(crank.P2, coupler.P0);
        joint j2 = universal(coupler.P1, coupler.a2, rocker.P0, rocker.a1);
        joint j3 = revolute(ground.P2, ground.a3, rocker.P2, rocker.a3);
        drive j4 = drive_rotation(joint_angle(ground.a4, crank.a3), (0.0 + 6.0 * (t / 1s)^1 + 0.0 + 0.2 * sin((6.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/sarrus_linkage.json`.
    pub(crate) mechanism SarrusLinkage in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, -0.2m, 0.0m); axis a1 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); point P2 = (-0.15m, 0.0m, 0.0m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); }
        body a1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.3m, 0.0m); axis a3 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); start position = (0.0000m, -0.2000m, 0.0000m); start orientation = turn((1.0000, 0.0000, 0.0000), 2.2411rad); mass = 0.8kg; center = (0.01m, 0.15m, 0.0m); inertia = (0.006kgm2, 0.0005kgm2, 0.0061kgm2); }
        body a2 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.3m, 0.0m); axis a3 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); start position = (0.0000m, -0.3860m, 0.2350m); start orientation = turn((1.0000, 0.0000, 0.0000), 0.9005rad); mass = 0.7kg; center = (0.0m, 0.15m, 0.0m); inertia = (0.005kgm2, 0.0005kgm2, 0.0051kgm2); }
        body platform { point P0 = (0.0m, -0.2m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (-0.15m, 0.0m, 0.0m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.4700m); mass = 3.0kg; center = (0.02m, 0.01m, 0.03m); inertia = (0.03kgm2, 0.04kgm2, 0.05kgm2); }
        body b1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.4m, 0.0m, 0.0m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); start position = (-0.1500m, 0.0000m, 0.0000m); start orientation = turn((0.0000, -1.0000, 0.0000), 2.5133rad); mass = 0.6kg; center = (0.2m, 0.0m, 0.0m); inertia = (0.0004kgm2, 0.004kgm2, 0.0041kgm2); }
        body b2 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.4m, 0.0m, 0.0m); axis a3 = (0.0, 1.0, 0.0); start position = (-0.4740m, 0.0000m, 0.2350m); start orientation = turn((0.0000, -1.0000, 0.0000), 0.6283rad); mass = 0.6kg; center = (0.2m, 0.005m, 0.0m); inertia = (0.0004kgm2, 0.004kgm2, 0.0041kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, a1.P0, a1.a1);
        joint j1 = revolute(a1.P2, a1.a3, a2.P0, a2.a1);
        joint j2 = revolute(a2.P2, a2.a3, platform.P0, platform.a1);
        joint j3 = revolute(ground.P2, ground.a3, b1.P0, b1.a1);
        joint j4 = revolute(b1.P2, b1.a3, b2.P0, b2.a1);
        redundant joint j5 = revolute(platform.P2, platform.a3, b2.P2, b2.a3);
        drive j6 = drive_rotation(joint_angle(ground.a4, a1.a4), (2.241592653589793 + 0.3 * sin((3.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/screw_jack.json`.
    pub(crate) mechanism ScrewJack in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis u2 = (1.0, 0.0, 0.0); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body spindle { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0000m); mass = 2.0kg; inertia = (0.01kgm2, 0.01kgm2, 0.001kgm2); }
        body nut { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis v2 = (0.0, 1.0, 0.0); start position = (0.0000m, 0.0000m, 0.3000m); mass = 40.0kg; center = (0.03m, 0.0m, 0.1m); inertia = (0.5kgm2, 0.6kgm2, 0.7kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, spindle.P0, spindle.a1);
        joint j1 = screw(nut.P0, nut.a1, spindle.P2, spindle.a3, 0.006m, -0.3m);
        joint j2 = { dot(ground.u2, nut.v2) == 0.0; }
        drive j3 = drive_rotation(joint_angle(ground.a3, spindle.a4), (0.0 + 25.0 * (t / 1s)^1 + 0.0 + 3.0 * sin((4.0 * (t / 1s) + 0.0) * 1rad)) * 1rad);
    }
}

mechanism! {
    /// `space/spatial_slider_crank.json`.
    pub(crate) mechanism SpatialSliderCrank in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.1m, 0.12m); axis a1 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); }
        body crank { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.08m); axis a3 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0000m, 0.1000m, 0.1200m); mass = 0.12kg; inertia = (0.0001kgm2, 0.000010000000kgm2, 0.0001kgm2); }
        body rod { point P0 = (-0.15m, 0.0m, 0.0m); point P1 = (0.15m, 0.0m, 0.0m); axis a2 = (0.0, 1.0, 0.0); start position = (0.1000m, 0.0500m, 0.1000m); start orientation = turn((0.9087, -0.0960, -0.4063), 2.7182rad); mass = 0.5kg; inertia = (0.0004kgm2, 0.004kgm2, 0.004kgm2); }
        body slider { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (1.0, 0.0, 0.0) from (0.0, 1.0, 0.0); start position = (0.2000m, 0.0000m, 0.0000m); mass = 2.0kg; inertia = (0.0001kgm2, 0.0001kgm2, 0.0001kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, crank.P0, crank.a1);
        joint j1 = spherical(crank.P2, rod.P0);
        joint j2 = universal(rod.P1, rod.a2, slider.P0, slider.a1);
        joint j3 = translational(ground.P2, ground.a3, slider.P2, slider.a3);
        drive j4 = drive_rotation(joint_angle(ground.a4, crank.a3), (0.0 + 6.0 * (t / 1s)^1) * 1rad);
    }
}

mechanism! {
    /// `space/stewart_legs.json`.
    pub(crate) mechanism StewartLegs in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.563623628m, -0.205738684m, 0.0m); axis a1 = (0.99034972, 0.138590879, 0.0); point P2 = (0.563623628m, 0.205738684m, 0.0m); axis a3 = (0.99034972, -0.138590879, 0.0); point P4 = (-0.103636887m, 0.590981722m, 0.0m); axis a5 = (-0.615198082, 0.788372577, 0.0); point P6 = (-0.459986741m, 0.385243038m, 0.0m); axis a7 = (-0.375151637, 0.926963456, 0.0); point P8 = (-0.459986741m, -0.385243038m, 0.0m); axis a9 = (-0.375151637, -0.926963456, 0.0); point P10 = (-0.103636887m, -0.590981722m, 0.0m); axis a11 = (-0.615198082, -0.788372577, 0.0); }
        body platform { point P0 = (0.244550014m, -0.250390277m, -0.05m); point P1 = (0.244550014m, 0.250390277m, -0.05m); point P2 = (0.094569334m, 0.336981663m, -0.05m); point P3 = (-0.339119348m, 0.0865913857m, -0.05m); point P4 = (-0.339119348m, -0.0865913857m, -0.05m); point P5 = (0.094569334m, -0.336981663m, -0.05m); start position = (-0.0000m, 0.0000m, 0.7000m); mass = 25.0kg; center = (0.02m, -0.01m, 0.1m); inertia = (1.1kgm2, 1.3kgm2, 2.0kgm2, 0.05kgm2, -0.02kgm2, 0.03kgm2); }
        body cylinder1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (0.5640m, -0.2060m, 0.0000m); start orientation = turn((0.2535, -0.2211, -0.9417), 1.4909rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod1 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (0.2450m, -0.2500m, 0.6500m); start orientation = turn((0.2535, -0.2211, -0.9417), 1.4909rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        body cylinder2 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (0.5640m, 0.2060m, 0.0000m); start orientation = turn((0.1949, -0.2235, -0.9550), 1.7557rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod2 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (0.2450m, 0.2500m, 0.6500m); start orientation = turn((0.1949, -0.2235, -0.9550), 1.7557rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        body cylinder3 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (-0.1040m, 0.5910m, 0.0000m); start orientation = turn((0.5528, 0.1899, 0.8114), 0.8024rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod3 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (0.0946m, 0.3370m, 0.6500m); start orientation = turn((0.5528, 0.1899, 0.8114), 0.8024rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        body cylinder4 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (-0.4600m, 0.3850m, 0.0000m); start orientation = turn((0.7609, 0.1481, 0.6318), 0.5975rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod4 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (-0.3390m, 0.0866m, 0.6500m); start orientation = turn((0.7609, 0.1481, 0.6318), 0.5975rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        body cylinder5 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (-0.4600m, -0.3850m, 0.0000m); start orientation = turn((0.0444, 0.2279, 0.9727), 2.7675rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod5 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (-0.3390m, -0.0866m, 0.6500m); start orientation = turn((0.0444, 0.2279, 0.9727), 2.7675rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        body cylinder6 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0); point P5 = (0.0m, 0.0m, 0.0m); start position = (-0.1040m, -0.5910m, 0.0000m); start orientation = turn((0.0782, 0.2276, 0.9706), 2.4968rad); mass = 3.0kg; center = (0.0m, 0.0m, 0.2m); inertia = (0.04kgm2, 0.04kgm2, 0.004kgm2); }
        body rod6 { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); point P3 = (0.0m, 0.0m, 0.0m); start position = (0.0946m, -0.3370m, 0.6500m); start orientation = turn((0.0782, 0.2276, 0.9706), 2.4968rad); mass = 1.5kg; center = (0.0m, 0.0m, -0.25m); inertia = (0.02kgm2, 0.02kgm2, 0.001kgm2); }
        joint j0 = universal(ground.P0, ground.a1, cylinder1.P0, cylinder1.a1);
        joint j1 = translational(cylinder1.P2, cylinder1.a3, rod1.P0, rod1.a1);
        joint j2 = spherical(rod1.P2, platform.P0);
        joint j3 = universal(ground.P2, ground.a3, cylinder2.P0, cylinder2.a1);
        joint j4 = translational(cylinder2.P2, cylinder2.a3, rod2.P0, rod2.a1);
        joint j5 = spherical(rod2.P2, platform.P1);
        joint j6 = universal(ground.P4, ground.a5, cylinder3.P0, cylinder3.a1);
        joint j7 = translational(cylinder3.P2, cylinder3.a3, rod3.P0, rod3.a1);
        joint j8 = spherical(rod3.P2, platform.P2);
        joint j9 = universal(ground.P6, ground.a7, cylinder4.P0, cylinder4.a1);
        joint j10 = translational(cylinder4.P2, cylinder4.a3, rod4.P0, rod4.a1);
        joint j11 = spherical(rod4.P2, platform.P3);
        joint j12 = universal(ground.P8, ground.a9, cylinder5.P0, cylinder5.a1);
        joint j13 = translational(cylinder5.P2, cylinder5.a3, rod5.P0, rod5.a1);
        joint j14 = spherical(rod5.P2, platform.P4);
        joint j15 = universal(ground.P10, ground.a11, cylinder6.P0, cylinder6.a1);
        joint j16 = translational(cylinder6.P2, cylinder6.a3, rod6.P0, rod6.a1);
        joint j17 = spherical(rod6.P2, platform.P5);
        drive j18 = drive_translation(along(cylinder1.a4, rod1.P3 - cylinder1.P5), (0.725466564 + 0.0 + 0.04 * sin((3.0 * (t / 1s) + 0.0) * 1rad) + 0.0) * 1m);
        drive j19 = drive_translation(along(cylinder2.a4, rod2.P3 - cylinder2.P5), (0.725466564 + 0.0 + 0.05 * sin((3.5 * (t / 1s) + 0.7) * 1rad) + -0.0322108844) * 1m);
        drive j20 = drive_translation(along(cylinder3.a4, rod3.P3 - cylinder3.P5), (0.725466564 + 0.0 + 0.06 * sin((4.0 * (t / 1s) + 1.4) * 1rad) + -0.0591269838) * 1m);
        drive j21 = drive_translation(along(cylinder4.a4, rod4.P3 - cylinder4.P5), (0.725466564 + 0.0 + 0.04 * sin((4.5 * (t / 1s) + 2.0999999999999996) * 1rad) + -0.0345283747) * 1m);
        drive j22 = drive_translation(along(cylinder5.a4, rod5.P3 - cylinder5.P5), (0.725466564 + 0.0 + 0.05 * sin((5.0 * (t / 1s) + 2.8) * 1rad) + -0.0167494075) * 1m);
        drive j23 = drive_translation(along(cylinder6.a4, rod6.P3 - cylinder6.P5), (0.725466564 + 0.0 + 0.06 * sin((5.5 * (t / 1s) + 3.5) * 1rad) + 0.0210469937) * 1m);
    }
}

mechanism! {
    /// `space/stewart_platform.json`.
    pub(crate) mechanism StewartPlatform in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.563623628m, -0.205738684m, 0.0m); point P1 = (0.563623628m, 0.205738684m, 0.0m); point P2 = (-0.103636887m, 0.590981722m, 0.0m); point P3 = (-0.459986741m, 0.385243038m, 0.0m); point P4 = (-0.459986741m, -0.385243038m, 0.0m); point P5 = (-0.103636887m, -0.590981722m, 0.0m); }
        body platform { point P0 = (0.244550014m, -0.250390277m, -0.05m); point P1 = (0.244550014m, 0.250390277m, -0.05m); point P2 = (0.094569334m, 0.336981663m, -0.05m); point P3 = (-0.339119348m, 0.0865913857m, -0.05m); point P4 = (-0.339119348m, -0.0865913857m, -0.05m); point P5 = (0.094569334m, -0.336981663m, -0.05m); start position = (-0.0000m, 0.0000m, 0.7000m); mass = 25.0kg; center = (0.02m, -0.01m, 0.1m); inertia = (1.1kgm2, 1.3kgm2, 2.0kgm2, 0.05kgm2, -0.02kgm2, 0.03kgm2); }
        drive j0 = drive_distance(ground.P0, platform.P0, (0.725466564 + 0.0 + 0.04 * sin((3.0 * (t / 1s) + 0.0) * 1rad) + 0.0) * 1m);
        drive j1 = drive_distance(ground.P1, platform.P1, (0.725466564 + 0.0 + 0.05 * sin((3.5 * (t / 1s) + 0.7) * 1rad) + -0.0322108844) * 1m);
        drive j2 = drive_distance(ground.P2, platform.P2, (0.725466564 + 0.0 + 0.06 * sin((4.0 * (t / 1s) + 1.4) * 1rad) + -0.0591269838) * 1m);
        drive j3 = drive_distance(ground.P3, platform.P3, (0.725466564 + 0.0 + 0.04 * sin((4.5 * (t / 1s) + 2.0999999999999996) * 1rad) + -0.0345283747) * 1m);
        drive j4 = drive_distance(ground.P4, platform.P4, (0.725466564 + 0.0 + 0.05 * sin((5.0 * (t / 1s) + 2.8) * 1rad) + -0.0167494075) * 1m);
        drive j5 = drive_distance(ground.P5, platform.P5, (0.725466564 + 0.0 + 0.06 * sin((5.5 * (t / 1s) + 3.5) * 1rad) + 0.0210469937) * 1m);
    }
}

mechanism! {
    /// `space/ur5_arm.json`.
    pub(crate) mechanism Ur5Arm in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a2 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); }
        body link1 { point P0 = (0.0m, -0.089159m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a5 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0000m, 0.0892m); start orientation = turn((0.9778, 0.1483, 0.1483), 1.5933rad); mass = 3.7kg; center = (0.0m, -0.02561m, 0.00193m); inertia = (0.038kgm2, 0.0454kgm2, 0.0227kgm2, 0.00037kgm2, 0.0kgm2, -0.00074kgm2); }
        body link2 { point P0 = (0.425m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a5 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (-0.2180m, -0.0673m, 0.4480m); start orientation = turn((0.7514, 0.5736, -0.3262), 1.6896rad); mass = 8.393kg; center = (0.2125m, 0.0m, 0.11336m); inertia = (0.08493kgm2, 0.101716kgm2, 0.050858kgm2, 0.0008393kgm2, 0.0kgm2, -0.0016786kgm2); }
        body link3 { point P0 = (0.39225m, 0.0m, 0.0m); axis a1 = (0.0, 0.0, 1.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a5 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (-0.5890m, -0.1820m, 0.4970m); start orientation = turn((0.9738, 0.2100, 0.0874), 1.5787rad); mass = 2.275kg; center = (0.15m, 0.0m, 0.0265m); inertia = (0.02375kgm2, 0.0283kgm2, 0.01415kgm2, 0.0002275kgm2, 0.0kgm2, -0.000455kgm2); }
        body link4 { point P0 = (0.0m, -0.10915m, 0.0m); axis a1 = (0.0, 1.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a5 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (-0.5570m, -0.2870m, 0.4970m); start orientation = turn((-0.9880, -0.1490, -0.0398), 3.1296rad); mass = 1.219kg; center = (0.0m, -0.0018m, 0.01634m); inertia = (0.01319kgm2, 0.015628kgm2, 0.007814kgm2, 0.0001219kgm2, 0.0kgm2, -0.0002438kgm2); }
        body link5 { point P0 = (0.0m, 0.09465m, 0.0m); axis a1 = (0.0, -1.0, 0.0); point P2 = (0.0m, 0.0m, 0.0m); axis a3 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); axis a4 = (0.0, -1.0, 0.0) from (1.0, 0.0, 0.0); axis a5 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (-0.5500m, -0.2840m, 0.4020m); start orientation = turn((0.8168, -0.4324, -0.3819), 1.8338rad); mass = 1.219kg; center = (0.0m, 0.0018m, 0.01634m); inertia = (0.01319kgm2, 0.015628kgm2, 0.007814kgm2, 0.0001219kgm2, 0.0kgm2, -0.0002438kgm2); }
        body link6 { point P0 = (0.0m, 0.0m, -0.0823m); axis a1 = (0.0, 0.0, 1.0); axis a2 = (0.0, 0.0, 1.0) from (1.0, 0.0, 0.0); start position = (-0.6170m, -0.3320m, 0.3960m); start orientation = turn((0.8168, -0.4324, -0.3819), 1.8338rad); mass = 0.1879kg; center = (0.0m, 0.0m, -0.001159m); inertia = (0.002879kgm2, 0.0032548kgm2, 0.0016274kgm2, 0.000018790000kgm2, 0.0kgm2, -0.000037580000kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, link1.P0, link1.a1);
        joint j1 = revolute(link1.P2, link1.a3, link2.P0, link2.a1);
        joint j2 = revolute(link2.P2, link2.a3, link3.P0, link3.a1);
        joint j3 = revolute(link3.P2, link3.a3, link4.P0, link4.a1);
        joint j4 = revolute(link4.P2, link4.a3, link5.P0, link5.a1);
        joint j5 = revolute(link5.P2, link5.a3, link6.P0, link6.a1);
        drive j6 = drive_rotation(joint_angle(ground.a2, link1.a4), (0.3 + 0.2 * (t / 1s)^1 + 0.0 + 0.8 * sin((1.5 * (t / 1s) + 0.0) * 1rad)) * 1rad);
        drive j7 = drive_rotation(joint_angle(link1.a5, link2.a4), (-1.2 + 0.5 * sin((2.0 * (t / 1s) + 0.4) * 1rad)) * 1rad);
        drive j8 = drive_rotation(joint_angle(link2.a5, link3.a4), (1.0 + 0.6 * sin((1.7 * (t / 1s) + -0.2) * 1rad)) * 1rad);
        drive j9 = drive_rotation(joint_angle(link3.a5, link4.a4), (-0.5 + 0.0 + 0.9 * sin((2.5 * (t / 1s) + 0.9) * 1rad)) * 1rad);
        drive j10 = drive_rotation(joint_angle(link4.a5, link5.a4), (1.2 + 0.0 + 0.5 * sin((3.0 * (t / 1s) + 0.1) * 1rad)) * 1rad);
        drive j11 = drive_rotation(joint_angle(link5.a5, link6.a2), (0.0 + 2.0 * (t / 1s)^1 + -0.3 * (t / 1s)^2) * 1rad);
    }
}

mechanism! {
    /// `space/worm_gear.json`.
    pub(crate) mechanism WormGear in space {
        gravity = (0.0m_s2, 0.0m_s2, -9.81m_s2);
        ground { point P0 = (0.0m, 0.0m, 0.08m); axis a1 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); point P2 = (0.0m, 0.02m, 0.0m); axis a3 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a4 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a5 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); axis a6 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); }
        body worm { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (1.0, 0.0, 0.0); axis a2 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); axis a3 = (1.0, 0.0, 0.0) from (0.0, 0.0, 1.0); start position = (0.0000m, 0.0000m, 0.0800m); mass = 0.7kg; inertia = (0.0002kgm2, 0.0008kgm2, 0.0008kgm2); }
        body wheel { point P0 = (0.0m, 0.0m, 0.0m); axis a1 = (0.0, 1.0, 0.0); axis a2 = (0.0, 1.0, 0.0) from (1.0, 0.0, 0.0); start position = (0.0000m, 0.0200m, 0.0000m); mass = 3.0kg; center = (0.01m, 0.0m, 0.0m); inertia = (0.005kgm2, 0.009kgm2, 0.005kgm2); }
        joint j0 = revolute(ground.P0, ground.a1, worm.P0, worm.a1);
        joint j1 = revolute(ground.P2, ground.a3, wheel.P0, wheel.a1);
        joint j2 = gear_pair(joint_angle(ground.a4, worm.a2), joint_angle(ground.a5, wheel.a2), 1.0, 30.0, 0.0 * 1rad);
        drive j3 = drive_rotation(joint_angle(ground.a6, worm.a3), (0.0 + 40.0 * (t / 1s)^1 + 25.0 * (t / 1s)^2) * 1rad);
    }
}
