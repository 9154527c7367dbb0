//! Attributes before a mechanism.

use proc_macro2::Ident;

/// Code that is generated on request.
#[derive(Clone, Debug, Default)]
pub struct Requests {
    /// The identifier of `#[picture]`, if states can be drawn at run time.
    pub picture: Option<Ident>,
    /// The identifier of `#[serde]`, if parameters and states can be serialised.
    pub serde: Option<Ident>,
    /// The identifier of `#[outputs]`, if all outputs are listed as well.
    pub outputs: Option<Ident>,
    /// The identifier of `#[points]`, if the motions of declared points and axes are wanted.
    pub points: Option<Ident>,
}

/// Policy for a mechanism that does not assemble at its declared defaults, or whose assembly is ambiguous.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closing {
    /// An error.
    #[default]
    Deny,
    /// A note in the generated documentation.
    Allow,
    /// No assembly is computed.
    Off,
}

/// Task of the generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Task {
    /// Positions, velocities and accelerations are solved for.
    #[default]
    Kinematics,
    /// Freedoms that follow from forces, or `#[integrated]`: a part of the coordinates is integrated, and the others are solved for.
    Motion,
    /// `#[equations_only]`: no `solve` is generated, and the system need not be square.
    EquationsOnly,
}

impl Task {
    /// True if the state at every time is solved for, by the drives alone.
    #[must_use]
    pub(crate) fn is_solved(self) -> bool {
        self == Task::Kinematics
    }

    /// True if drives and freedoms have to determine a state.
    #[must_use]
    pub(crate) fn is_determined(self) -> bool {
        self != Task::EquationsOnly
    }
}

/// Policy for a motion that ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Following {
    /// An error within a declared range; a warning if no range is declared.
    #[default]
    Declared,
    /// Always an error.
    Strict,
    /// The motion is not followed.
    Off,
}
