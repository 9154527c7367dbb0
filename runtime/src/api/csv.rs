//! Motions as tables of comma-separated values.
//!
//! The first line has the names and units of the columns, each further line a state. Numbers have as many digits as give them back to the
//! last bit.
//!
//! ```
//! use reuleaux::{csv, mechanism};
//!
//! mechanism! {
//!     #[outputs]
//!     mechanism Crank {
//!         body crank { point A = (0.5m, 0m); }
//!         joint pivot = revolute(ground.position, crank.position);
//!         drive motor = drive_angle(crank, 2rad_s * t);
//!         output pin = crank.A;
//!     }
//! }
//!
//! let crank = Crank::default();
//! let mut table = Vec::new();
//! csv::write_outputs(&mut table, &crank, crank.sweep([0.0, 0.1]))?;
//! let table = String::from_utf8(table)?;
//! let mut lines = table.lines();
//! assert_eq!(
//!     lines.next(),
//!     Some("t (s),pin.x (m),pin.x rate (m/s),pin.x acceleration (m/s²),pin.y (m),pin.y rate (m/s),pin.y acceleration (m/s²)")
//! );
//! assert_eq!(lines.next(), Some("0.0,0.5,0.0,-2.0,0.0,1.0,0.0"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use core::error::Error;
use core::fmt::{self, Debug, Display, Formatter};
use core::ops::Deref;
use std::format;
use std::io::{self, Write};
use std::string::String;

use super::outputs::{Output, OutputName, OutputNames, Outputs};
use super::slice::{Slice, SliceState, Sliced};
use crate::names::{Coordinate, CoordinateKind, Description};
use crate::number::Float;
use crate::solve::SolverReal;
use crate::state::{Motion, MotionWithJerk, State};

/// Why a table ends before the last state. `{:?}` is the sentence, as `{}` is.
#[non_exhaustive]
pub enum Unwritten<E> {
    /// There is no further state. The lines of those before it are written.
    Failure(E),
    /// A line could not be written.
    Io(io::Error),
}

/// Writes a motion: time, the coordinates, and the outputs, with rates and accelerations, and with jerks where outputs are declared so.
/// An output that is called like a coordinate, such as `disc.x`, is `output disc.x`.
///
/// * `to`: given, a file, a `Vec<u8>` or the like; files should be buffered.
/// * `mechanism`: given, declared with `#[outputs]`.
/// * `states`: given, what a `sweep` gives; other states as `states.map(Ok::<_, Infallible>)`.
///
/// # Errors
/// The failure with which the motion ends, or that of `to`.
pub fn write<W, M, T, E, const N: usize, const K: usize>(
    to: W,
    mechanism: &M,
    states: impl IntoIterator<Item = Result<M::State, E>>,
) -> Result<(), Unwritten<E>>
where
    W: Write,
    M: Outputs<T, N, K> + Description<T, N>,
    T: Float,
{
    let names = |table: &mut Table<W>| {
        coordinate_names(table, M::COORDINATES)?;
        output_names(table, &M::OUTPUTS.0, M::COORDINATES)
    };
    let numbers = |table: &mut Table<W>, state: &M::State| {
        coordinates(table, state, M::COORDINATES)?;
        outputs(table, &M::OUTPUTS, mechanism.outputs_with_jerk(state))
    };
    tabulate(to, states, names, numbers)
}

/// Writes a motion as [`write`](self::write()) does, without the coordinates.
///
/// # Errors
/// The failure with which the motion ends, or that of `to`.
pub fn write_outputs<W, M, T, E, const N: usize, const K: usize>(
    to: W,
    mechanism: &M,
    states: impl IntoIterator<Item = Result<M::State, E>>,
) -> Result<(), Unwritten<E>>
where
    W: Write,
    M: Outputs<T, N, K>,
    T: Float,
{
    let names = |table: &mut Table<W>| output_names(table, &M::OUTPUTS.0, &[]);
    tabulate(to, states, names, |table, state| outputs(table, &M::OUTPUTS, mechanism.outputs_with_jerk(state)))
}

/// Writes a motion as [`write`](self::write()) does, without the outputs: for any mechanism. Slices have [`write_slice`].
///
/// # Errors
/// The failure with which the motion ends, or that of `to`.
pub fn write_coordinates<W, M, T, S, E, const N: usize>(
    to: W,
    _mechanism: &M,
    states: impl IntoIterator<Item = Result<S, E>>,
) -> Result<(), Unwritten<E>>
where
    W: Write,
    M: Description<T, N>,
    S: Deref<Target = State<T, N>>,
    T: Float,
{
    let names = |table: &mut Table<W>| coordinate_names(table, M::COORDINATES);
    tabulate(to, states, names, |table, state: &S| coordinates(table, state, M::COORDINATES))
}

/// Writes the output of a slice: time, and each component with its rate, its acceleration and its jerk, as far as the output has them.
///
/// ```
/// # use reuleaux::{csv, mechanism};
/// # mechanism! {
/// #     mechanism Crank {
/// #         body crank { point A = (0.5m, 0m); }
/// #         joint pivot = revolute(ground.position, crank.position);
/// #         drive motor = drive_angle(crank, 2rad_s * t);
/// #         slice output pin = crank.A;
/// #     }
/// # }
/// let pin = Crank::default().solve_for_pin();
/// let mut table = Vec::new();
/// csv::write_slice(&mut table, &pin, pin.sweep([0.0, 0.1]))?;
/// assert!(table.starts_with(b"t (s),pin.x (m),pin.x rate (m/s),"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The failure with which the motion ends, or that of `to`.
pub fn write_slice<W, M, T, E, const OUTPUT: usize, const N: usize, const WHOLE: usize>(
    to: W,
    _slice: &Slice<M, T, OUTPUT, N, WHOLE>,
    states: impl IntoIterator<Item = Result<SliceState<M, T, OUTPUT, N, WHOLE>, E>>,
) -> Result<(), Unwritten<E>>
where
    W: Write,
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal + Float,
{
    let names = |table: &mut Table<W>| output_names(table, M::OUTPUTS, &[]);
    let numbers = |table: &mut Table<W>, state: &SliceState<M, T, OUTPUT, N, WHOLE>| {
        let (mut components, mut written) = (M::OUTPUTS.iter(), Ok(()));
        state.output().each(&mut |component| {
            if let (Some(name), Ok(())) = (components.next(), &written) {
                written = output(table, name, component);
            }
        });
        written
    };
    tabulate(to, states, names, numbers)
}

/// A column for [`write_columns`]: its name, its unit, and the number in a state.
pub type ColumnOf<'a, S, T> = (&'a str, &'a str, &'a dyn Fn(&S) -> T);

/// Writes time and, for each state, one number for each column: loads, inputs, energies and the like.
///
/// ```
/// use reuleaux::{csv, mechanism};
///
/// mechanism! {
///     mechanism Arm {
///         gravity = (0, -9.81m_s2);
///         body arm { mass = 2kg;  center = (0.5m, 0m);  inertia = 0.2kgm2; }
///         joint pivot = revolute(ground.position, arm.position);
///         drive motor = drive_angle(arm, 2rad_s * t);
///     }
/// }
///
/// let arm = Arm::default();
/// let mut table = Vec::new();
/// csv::write_columns(
///     &mut table,
///     arm.sweep([0.0, 0.1]),
///     &[
///         ("torque", "N m", &|state: &ArmState| arm.loads(state).motor().effort),
///         ("bearing", "N", &|state: &ArmState| arm.loads(state).pivot().force.norm()),
///     ],
/// )?;
/// assert!(table.starts_with("t (s),torque (N m),bearing (N)\n0.0,9.81,".as_bytes()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The failure with which the motion ends, or that of `to`.
pub fn write_columns<W, T, S, E, const N: usize>(
    to: W,
    states: impl IntoIterator<Item = Result<S, E>>,
    columns: &[ColumnOf<S, T>],
) -> Result<(), Unwritten<E>>
where
    W: Write,
    S: Deref<Target = State<T, N>>,
    T: Float,
{
    let names = |table: &mut Table<W>| {
        columns.iter().try_for_each(|(name, unit, _)| table.cell(format_args!("{}", quoted(format!("{name} ({unit})")))))
    };
    tabulate(to, states, names, |table, state| columns.iter().try_for_each(|(_, _, of)| table.number(of(state))))
}

/// Writes a table: a line of names, and a line of numbers for each state.
fn tabulate<W, T, S, E, const N: usize>(
    to: W,
    states: impl IntoIterator<Item = Result<S, E>>,
    names: impl FnOnce(&mut Table<W>) -> io::Result<()>,
    numbers: impl Fn(&mut Table<W>, &S) -> io::Result<()>,
) -> Result<(), Unwritten<E>>
where
    W: Write,
    S: Deref<Target = State<T, N>>,
    T: Float,
{
    let mut table = Table { to, separator: "" };
    table.name(format_args!("t"), "s")?;
    names(&mut table)?;
    table.end()?;
    for state in states {
        let state = state.map_err(Unwritten::Failure)?;
        table.number(state.t)?;
        numbers(&mut table, &state)?;
        table.end()?;
    }
    Ok(table.to.flush()?)
}

/// A cell in quotation marks if it has commas, quotation marks or ends of lines.
fn quoted(cell: String) -> String {
    if cell.contains([',', '"', '\n', '\r']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell }
}

/// A table that is being written.
struct Table<W> {
    to: W,
    /// What stands before the next cell of the line.
    separator: &'static str,
}

impl<W: Write> Table<W> {
    /// A name with its unit.
    fn name(&mut self, name: fmt::Arguments<'_>, unit: &str) -> io::Result<()> {
        self.cell(format_args!("{name} ({unit})"))
    }

    /// A number in the fewest digits that give it back.
    fn number<T: Debug>(&mut self, number: T) -> io::Result<()> {
        self.cell(format_args!("{number:?}"))
    }

    fn cell(&mut self, text: fmt::Arguments<'_>) -> io::Result<()> {
        let separator = core::mem::replace(&mut self.separator, ",");
        write!(self.to, "{separator}{text}")
    }

    fn end(&mut self) -> io::Result<()> {
        self.separator = "";
        self.to.write_all(b"\n")
    }
}

/// Value, rate, acceleration and jerk.
const ORDERS: [&str; 4] = ["", " rate", " acceleration", " jerk"];

/// The columns of a coordinate.
enum Column {
    /// A coordinate with its rate and its acceleration.
    Moving([&'static str; 3]),
    /// A direction cosine; the first three stand beside components of the angular velocity and of the angular acceleration.
    Cosine(Option<&'static str>),
}

impl Column {
    fn of(coordinate: &Coordinate) -> Column {
        match (coordinate.kind, coordinate.name) {
            (CoordinateKind::Length, _) => Column::Moving(["m", "m/s", "m/s²"]),
            (CoordinateKind::Angle, _) => Column::Moving(["rad", "rad/s", "rad/s²"]),
            (CoordinateKind::Number, "a11") => Column::Cosine(Some("x")),
            (CoordinateKind::Number, "a12") => Column::Cosine(Some("y")),
            (CoordinateKind::Number, "a13") => Column::Cosine(Some("z")),
            (CoordinateKind::Number, name) if name.starts_with('a') => Column::Cosine(None),
            (CoordinateKind::Number, _) => Column::Moving(["1", "1/s", "1/s²"]),
        }
    }
}

/// A path of names without the `r#` of those that are words of Rust.
struct Plain<'a>(&'a str);

impl fmt::Display for Plain<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.split("r#").try_for_each(|part| f.write_str(part))
    }
}

fn coordinate_names<W: Write>(table: &mut Table<W>, coordinates: &[Coordinate]) -> io::Result<()> {
    for coordinate in coordinates {
        let (body, name) = (Plain(coordinate.body), coordinate.name);
        match Column::of(coordinate) {
            Column::Moving(units) => {
                for (order, unit) in ORDERS.iter().zip(units) {
                    table.name(format_args!("{body}.{name}{order}"), unit)?;
                }
            }
            Column::Cosine(axis) => {
                table.name(format_args!("{body}.{name}"), "1")?;
                if let Some(axis) = axis {
                    table.name(format_args!("{body}.angular_velocity.{axis}"), "rad/s")?;
                    table.name(format_args!("{body}.angular_acceleration.{axis}"), "rad/s²")?;
                }
            }
        }
    }
    Ok(())
}

fn coordinates<W: Write, T: Float, const N: usize>(
    table: &mut Table<W>,
    state: &State<T, N>,
    coordinates: &[Coordinate],
) -> io::Result<()> {
    for (index, coordinate) in coordinates.iter().enumerate() {
        let Motion { value, rate, acceleration } = state.coordinate(index);
        table.number(value)?;
        if !matches!(Column::of(coordinate), Column::Cosine(None)) {
            table.number(rate)?;
            table.number(acceleration)?;
        }
    }
    Ok(())
}

/// * `beside`: given, the coordinates in the same table.
fn output_names<W: Write>(table: &mut Table<W>, names: &[OutputName], beside: &[Coordinate]) -> io::Result<()> {
    for output in names {
        let OutputName { name, units } = output;
        let is_called = |own: &Coordinate| *name == format!("{}.{}", Plain(own.body), own.name);
        let word = if beside.iter().any(is_called) { "output " } else { "" };
        for (order, unit) in ORDERS.iter().zip(units).take(columns(output)) {
            table.name(format_args!("{word}{name}{order}"), if unit.is_empty() { "1" } else { unit })?;
        }
    }
    Ok(())
}

fn outputs<W: Write, T: Float, const K: usize>(
    table: &mut Table<W>,
    names: &OutputNames<K>,
    outputs: [MotionWithJerk<T>; K],
) -> io::Result<()> {
    names.0.iter().zip(outputs).try_for_each(|(name, component)| output(table, name, component))
}

fn output<W: Write, T: Float>(table: &mut Table<W>, name: &OutputName, component: MotionWithJerk<T>) -> io::Result<()> {
    let MotionWithJerk { value, rate, acceleration, jerk } = component;
    [value, rate, acceleration, jerk].into_iter().take(columns(name)).try_for_each(|number| table.number(number))
}

/// Number of columns of a component.
fn columns(of: &OutputName) -> usize {
    2 + usize::from(of.has_acceleration()) + usize::from(of.has_jerk())
}

impl<E: Display> Display for Unwritten<E> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Unwritten::Failure(reason) => write!(f, "the table ends early: {reason}"),
            Unwritten::Io(reason) => write!(f, "the table cannot be written: {reason}"),
        }
    }
}

impl<E: Display> Debug for Unwritten<E> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl<E: Display> Error for Unwritten<E> {}

impl<E> From<io::Error> for Unwritten<E> {
    fn from(reason: io::Error) -> Self {
        Unwritten::Io(reason)
    }
}
