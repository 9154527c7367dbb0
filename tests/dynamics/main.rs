//! Motion that follows from forces, against reference numbers, closed forms and conserved quantities.

#[macro_use]
mod compare;
mod bricard;
mod bushings;
mod changed;
mod conserved;
mod derivatives;
mod events;
mod far;
mod flat;
mod forces;
mod gears;
mod indexed;
mod integrated;
mod jumps;
mod kept;
mod masses;
mod meshes;
mod nearest;
mod nonlinear;
mod plane;
mod published;
mod redundant;
mod shared_nodes;
mod space;
mod springs;
mod stiff;
mod stops;
mod switches;
