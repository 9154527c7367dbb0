//! Attributes before a mechanism.

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
    /// `#[equations_only]`: no `solve` is generated, and the system need not be square.
    EquationsOnly,
}

impl Task {
    /// True if the equations are solved.
    #[must_use]
    pub fn is_solved(self) -> bool {
        match self {
            Task::Kinematics => true,
            Task::EquationsOnly => false,
        }
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
