//! Did you mean …?

/// The known name nearest to a mistyped one, if it is near enough to be meant.
pub(crate) fn nearest<'a>(typed: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    // Any two single letters are one replacement apart; that is no reason to mix them up.
    let length = typed.chars().count();
    let limit = if length < 2 { 0 } else { (length / 3).max(1) };
    let scored = known.map(|name| ((distance(typed, name), name.chars().count().abs_diff(length)), name));
    // The order of declaration decides between equals, so that messages are the same on every run.
    scored.filter(|((distance, _), _)| *distance <= limit).min_by_key(|(score, _)| *score).map(|(_, name)| name.to_owned())
}

/// Optimal string alignment distance: insertions, deletions, replacements, swaps of neighbours;
/// a change of case alone counts as nothing.
///
/// Reference: Damerau (1964), A technique for computer detection and correction of spelling errors.
fn distance(one: &str, two: &str) -> usize {
    let [one, two] = [one, two].map(|text| text.to_lowercase().chars().collect::<Vec<_>>());
    let mut rows: Vec<Vec<usize>> = vec![(0..=two.len()).collect()];
    for i in 1..=one.len() {
        let mut row = vec![i];
        for j in 1..=two.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(one[i - 1] != two[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            let swapped = i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1];
            if swapped {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[one.len()][two.len()]
}
