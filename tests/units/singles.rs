//! Constraints of one body against ground.

use crate::declared;

declared! {
    /// A point keeps its x.
    #[equations_only]
    AbsoluteX (point_i_x: Length = 1, point_i_y: Length = 1, value: Length = 1) {
        body i { point P = (point_i_x, point_i_y); }
        joint it = absolute_x(i.P, value);
    }
}
declared! {
    /// A point keeps its y.
    #[equations_only]
    AbsoluteY (point_i_x: Length = 1, point_i_y: Length = 1, value: Length = 1) {
        body i { point P = (point_i_x, point_i_y); }
        joint it = absolute_y(i.P, value);
    }
}
declared! {
    /// A body keeps its angle.
    #[equations_only]
    AbsoluteAngle (value: Angle = 1) {
        body i {}
        joint it = absolute_angle(i, value);
    }
}
declared! {
    /// A point keeps its distance from a place in ground.
    #[equations_only]
    AbsoluteDistance (point_i_x: Length = 1, point_i_y: Length = 1, center_x: Length = 1, center_y: Length = 1, distance: Length = 1) {
        ground { point C = (center_x, center_y); }
        body i { point P = (point_i_x, point_i_y); }
        joint it = absolute_distance(i.P, ground.C, distance);
    }
}
declared! {
    /// A point's x follows a law.
    #[equations_only]
    DriveX (
        point_i_x: Length = 1, point_i_y: Length = 1, c0: Length = 1, c1: Length = 1, c2: Length = 1, c3: Length = 1, c4: Length = 1,
        offset: Length = 1, amplitude: Length = 1, omega: Number = 1, phase: Angle = 1
    ) {
        body i { point P = (point_i_x, point_i_y); }
        let s = t / 1s;
        drive it = drive_x(i.P, c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))) + (offset + amplitude * sin(omega * s + phase)));
    }
}
declared! {
    /// A point's y follows a law.
    #[equations_only]
    DriveY (
        point_i_x: Length = 1, point_i_y: Length = 1, c0: Length = 1, c1: Length = 1, c2: Length = 1, c3: Length = 1, c4: Length = 1,
        offset: Length = 1, amplitude: Length = 1, omega: Number = 1, phase: Angle = 1
    ) {
        body i { point P = (point_i_x, point_i_y); }
        let s = t / 1s;
        drive it = drive_y(i.P, c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))) + (offset + amplitude * sin(omega * s + phase)));
    }
}
declared! {
    /// A body's angle follows a law.
    #[equations_only]
    DriveAngle (
        c0: Angle = 1, c1: Angle = 1, c2: Angle = 1, c3: Angle = 1, c4: Angle = 1,
        offset: Angle = 1, amplitude: Angle = 1, omega: Number = 1, phase: Angle = 1
    ) {
        body i {}
        let s = t / 1s;
        drive it = drive_angle(i, c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))) + (offset + amplitude * sin(omega * s + phase)));
    }
}
