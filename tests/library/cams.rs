//! Disc cams with profiles as written functions, tables and Rust functions.

use reuleaux::Real;

use crate::declared;

/// The outline of an eccentric: 0.4 + 0.1 cos 2ψ in m, with its derivatives.
pub fn oval<T: Real>(angle: T) -> (T, T, T) {
    let (base, rise, two) = (T::of(0.4), T::of(0.1), T::of(2.0));
    let (sine, cosine) = (two * angle).sin_cos();
    (base + rise * cosine, -(two * rise * sine), -(two * two * rise * cosine))
}

/// A profile that exists for `f64` only, such as measured data: e^(sin ψ) / 4 in m.
pub fn measured<T: Real>(angle: T) -> (T, T, T) {
    angle.map(|angle| {
        let (sine, cosine) = angle.sin_cos();
        let value = sine.exp() / 4.0;
        (value, value * cosine, value * (cosine * cosine - sine))
    })
}

declared! {
    /// Knife edges on an outline written in the language and on one in Rust.
    #[equations_only]
    KnifeCams (base: Length = 1, rise: Length = 0.2) {
        function outline(angle: Angle) -> Length = base + rise * sin(3 * angle)^2;
        function oval(Angle) -> Length = crate::library::oval;
        body cam { point O = (0.1, -0.2); }
        body follower { point F = (0.3, 0.4);  point G = (-0.5, 0.6); }
        joint written = cam_knife(cam.O, follower.F, outline);
        joint rust = cam_knife(cam.O, follower.G, oval);
    }
}
declared! {
    /// Rollers on an outline from a table and on a measured one.
    #[equations_only]
    RollerCams (roller: Length = 0.1) {
        function outline(angle: Angle) -> Length =
            table(angle, [(-pi, 1m), (-1.5, 1.2m), (0.1, 1.5m), (1.3, 1.1m), (2.2, 0.9m), (pi, 1m)], periodic);
        function measured(Angle) -> Length = crate::library::measured;
        body cam { point O = (0.1, -0.2); }
        body follower { point C = (0.3, 0.4);  point D = (-0.5, 0.6); }
        joint from_table = cam_roller(cam.O, follower.C, roller, outline);
        joint from_rust = cam_roller(cam.O, follower.D, roller, measured);
    }
}
declared! {
    /// Flat faces on the support functions of an eccentric disc and of a dwell-rise cam.
    #[equations_only]
    FlatCams (radius: Length = 1, eccentricity: Length = 0.2, rise: Length = 0.3, nx: Number = 1, ny: Number = 0.5) {
        function disc(angle: Angle) -> Length = radius + eccentricity * cos(angle);
        function dwell(angle: Angle) -> Length = radius + rise * cycloidal(wrap(angle) / 180deg);
        body cam { point O = (0.1, -0.2); }
        body follower { point F = (0.3, 0.4);  axis n = (nx, ny); }
        joint on_disc = cam_flat(cam.O, follower.F, follower.n, disc);
        joint on_dwell = cam_flat(cam.O, follower.F, follower.n, dwell);
    }
}
