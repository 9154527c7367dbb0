//! Motion that follows from forces, against reference numbers, closed forms and conserved quantities.

#[macro_use]
mod compare;
mod bricard;
mod conserved;
mod kept;
mod plane;
mod published;
mod space;
mod stiff;
