//! Values of an event within a step, and at the places where it turns back near zero.

use crate::number::Scalar;

/// How often an event is looked at in a step.
pub(super) const LOOKS: usize = 8;

/// Most halvings of the first part of a step that begins where the event is zero: it may leave zero and come back at once.
const HALVINGS: usize = 40;

/// Most looks: at equal parts, where the event turns back between them, and soon after its zero.
const MOST: usize = 2 * LOOKS + 2;

/// Most further looks for the place where an event turns back.
const NEARER: usize = 8;

/// Such a place is found if it moves by less than this fraction of a step.
const STILL: f64 = 1e-9;

/// Where a parabola is farther from zero than this multiple of its error, the event does not reach zero.
const OFF: f64 = 8.0;

/// If an event turns back nearer to zero than this fraction of its largest value in the step, exact states decide whether it passes zero.
const NEAR: f64 = 0.01;

/// Part of a step, or time since its beginning, and the value of an event there.
pub(super) type Look<T> = (T, T);

/// True if an event is zero at the second place or has passed zero before it.
pub(super) fn changes<T: Scalar>(one: T, two: T) -> bool {
    one < T::ZERO && two >= T::ZERO || one > T::ZERO && two <= T::ZERO
}

/// Looks in the order of time.
pub(super) struct Looks<T> {
    all: [Look<T>; MOST],
    count: usize,
}

impl<T: Scalar> Looks<T> {
    /// Looks at equal parts of a step.
    pub(super) fn new(look: impl Fn(usize, T) -> T) -> Self {
        let (mut all, mut part) = ([(T::ZERO, T::ZERO); MOST], T::ZERO);
        for (number, entry) in all.iter_mut().enumerate().take(LOOKS + 1) {
            *entry = (part, look(number, part));
            // Exact: the number of looks is a power of two.
            part = part + T::of(1.0 / LOOKS as f64);
        }
        Self { all, count: LOOKS + 1 }
    }

    /// The looks.
    pub(super) fn all(&self) -> &[Look<T>] {
        self.all.get(..self.count).unwrap_or_default()
    }

    /// Looks also soon after a beginning at which the event is zero, if it leaves zero to the other side than where the next look sees it.
    ///
    /// It does if looks at ever shorter parts are on the other side and halve with the parts, which rounding errors do not.
    pub(super) fn soon(&mut self, look: impl Fn(T) -> T) {
        let [(_, first), (whole, later)] = [0, 1].map(|number| self.all.get(number).copied().unwrap_or((T::ZERO, T::ZERO)));
        if first != T::ZERO {
            return;
        }
        let side = if later > T::ZERO { T::of(-1.0) } else { T::of(1.0) };
        let halves = |one: T, two: T| side * two > T::ZERO && side * one > T::of(1.5) * side * two && side * one < T::of(2.5) * side * two;
        let (mut part, mut sooner) = (whole, [(whole, later); 3]);
        for _ in 0..HALVINGS {
            part = part * T::of(0.5);
            sooner = [sooner[1], sooner[2], (part, look(part))];
            let [one, two, three] = sooner.map(|look| look.1);
            if halves(one, two) && halves(two, three) {
                self.insert(sooner[0]);
                return;
            }
        }
    }

    /// Looks also where the event turns back before zero.
    ///
    /// * `look`: given, the event between the ends of the step, interpolated.
    /// * `exactly`: given, the same by a step that ends there.
    pub(super) fn at_turns<E>(&mut self, look: impl Fn(T) -> T, mut exactly: impl FnMut(T) -> Result<T, E>) -> Result<(), E> {
        let regular = Self { ..*self };
        let largest = regular.all().iter().fold(T::ZERO, |largest, look| largest.max(look.1.abs()));
        for (nearest, side) in (0..LOOKS).filter_map(|first| regular.turn(first)) {
            let mut found = lowest(nearest, side, |part| Ok(look(part)))?;
            let is_near = side * found.1 < T::of(NEAR) * largest;
            if side * found.1 > T::ZERO && is_near {
                let aside = T::of(0.05 / LOOKS as f64);
                let parts = [found.0 - aside, found.0, found.0 + aside];
                let mut here = [found; 3];
                for (entry, part) in here.iter_mut().zip(parts.map(within)) {
                    *entry = (part, exactly(part)?);
                }
                found = lowest(here, side, &mut exactly)?;
            }
            if side * found.1 < T::ZERO {
                self.insert(found);
            }
        }
        Ok(())
    }

    /// Three looks about a place after the one numbered `first` and before the next at which the event turns back before zero, and the sign of
    /// the event there.
    fn turn(&self, first: usize) -> Option<([Look<T>; 3], T)> {
        let value = |number: usize| self.all.get(number).map_or(T::ZERO, |look| look.1);
        let (one, two) = (value(first), value(first + 1));
        let side = if one > T::ZERO || one == T::ZERO && two > T::ZERO { T::of(1.0) } else { T::of(-1.0) };
        let turns = side * self.slope(first) < T::ZERO && side * self.slope(first + 1) > T::ZERO;
        let start = if side * one < side * two { first.saturating_sub(1) } else { first }.min(LOOKS - 2);
        let about = self.all.get(start..)?.first_chunk().copied()?;
        (turns && side * two > T::ZERO && side * one >= T::ZERO).then_some((about, side))
    }

    /// The slope at a look, by the parabola through it and the nearest ones.
    fn slope(&self, number: usize) -> T {
        let value = |number: usize| self.all.get(number).map_or(T::ZERO, |look| look.1);
        match number {
            0 => T::of(4.0) * value(1) - T::of(3.0) * value(0) - value(2),
            LOOKS => T::of(3.0) * value(LOOKS) - T::of(4.0) * value(LOOKS - 1) + value(LOOKS - 2),
            _ => value(number + 1) - value(number - 1),
        }
    }

    /// One more look, at its place.
    fn insert(&mut self, look: Look<T>) {
        let mut carried = look;
        for entry in self.all.iter_mut().take(self.count) {
            if carried.0 < entry.0 {
                core::mem::swap(entry, &mut carried);
            }
        }
        if let Some(end) = self.all.get_mut(self.count) {
            *end = carried;
            self.count += 1;
        }
    }
}

/// The same part, in the step.
fn within<T: Scalar>(part: T) -> T {
    if part < T::ZERO {
        T::ZERO
    } else if part > T::of(1.0) {
        T::of(1.0)
    } else {
        part
    }
}

/// The look nearest to zero about a place where an event turns back, or one beyond zero.
fn lowest<T: Scalar, E>(mut about: [Look<T>; 3], side: T, mut look: impl FnMut(T) -> Result<T, E>) -> Result<Look<T>, E> {
    let height = |look: &Look<T>| side * look.1;
    for _ in 0..NEARER {
        // The highest comes last.
        let order = |one: &Look<T>, two: &Look<T>| height(one).partial_cmp(&height(two)).unwrap_or(core::cmp::Ordering::Equal);
        about.sort_unstable_by(order);
        let Some((place, expected)) = vertex(&about, side) else { break };
        let place = within(place);
        if height(&about[0]) < T::ZERO || (place - about[0].0).abs() < T::of(STILL) {
            break;
        }
        let found = (place, look(place)?);
        about[2] = found;
        if (height(&found) - expected).abs() * T::of(OFF) < height(&found) {
            break;
        }
    }
    Ok(about.into_iter().reduce(|one, two| if height(&two) < height(&one) { two } else { one }).unwrap_or(about[0]))
}

/// The lowest place of the parabola through three looks, and its height there.
fn vertex<T: Scalar>(looks: &[Look<T>; 3], side: T) -> Option<(T, T)> {
    let [(a, one), (b, two), (c, three)] = looks.map(|look| (look.0, side * look.1));
    let (rise, next) = ((two - one) / (b - a), (three - two) / (c - b));
    let bend = (next - rise) / (c - a);
    let place = (a + b) * T::of(0.5) - rise / (T::of(2.0) * bend);
    (bend > T::ZERO).then(|| (place, one + (place - a) * (rise + bend * (place - b))))
}
