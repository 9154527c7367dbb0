//! Geometry of a mark as words and numbers: `M12.5 3L4 5` is `M`, `L`, spaces, and four numbers in tenths.

/// Largest magnitude of a number, so that programs can read it as a 32-bit integer.
const LARGEST: f64 = 1e8;

/// Meaning of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Meaning {
    /// A coordinate or a length, in tenths.
    Length,
    /// Rotation of an ellipse in tenths of a degree, modulo 180°.
    HalfTurn,
}

/// The text of an attribute without its numbers: one piece before, between and after them, hence one more piece than numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Skeleton {
    pub(crate) texts: Vec<String>,
    pub(crate) meanings: Vec<Meaning>,
}

/// Splits an attribute into its text and its numbers. Flags of arcs count as text, as nothing separates them.
pub(crate) fn split(value: &str) -> (Skeleton, Vec<i64>) {
    let (mut skeleton, mut numbers) = (Skeleton::default(), Vec::new());
    let (mut text, mut command, mut argument) = (String::new(), ' ', 0_usize);
    let mut rest = value;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|letter: char| !is_numeric(letter)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(if length == 0 { first.len_utf8() } else { length });
        rest = after;
        match word.parse::<f64>() {
            Ok(number) if length > 0 => {
                let place = argument % 7;
                argument += 1;
                if command == 'A' && (place == 3 || place == 4) {
                    text += word;
                    continue;
                }
                skeleton.texts.push(std::mem::take(&mut text));
                skeleton.meanings.push(if command == 'A' && place == 2 { Meaning::HalfTurn } else { Meaning::Length });
                numbers.push((number * 10.0).round().clamp(-LARGEST, LARGEST) as i64);
            }
            _ => {
                if first.is_alphabetic() {
                    (command, argument) = (first, 0);
                }
                text += word;
            }
        }
    }
    skeleton.texts.push(text);
    (skeleton, numbers)
}

fn is_numeric(letter: char) -> bool {
    letter.is_ascii_digit() || letter == '.' || letter == '-'
}

/// Inserts numbers into the text of an attribute.
pub(crate) fn join(skeleton: &Skeleton, numbers: &[i64]) -> String {
    let mut words = skeleton.texts.iter();
    let mut value = words.next().cloned().unwrap_or_default();
    for (word, number) in words.zip(numbers) {
        value += &decimal(*number);
        value += word;
    }
    value
}

/// A number of tenths as a decimal, without a trailing zero.
pub(crate) fn decimal(tenths: i64) -> String {
    let (sign, size) = (if tenths < 0 { "-" } else { "" }, tenths.unsigned_abs());
    match size % 10 {
        0 => format!("{sign}{}", size / 10),
        digit => format!("{sign}{}.{digit}", size / 10),
    }
}
