//! The result as text, the same on every run.

use std::fmt::Write as _;

use crate::{LinkageFailure, Spread, Study, Tally, linear};

impl Study {
    /// The tally in words and numbers, beside the linear analysis: failures, path errors, yield, and the deviations of the tip over a turn.
    ///
    /// # Errors
    /// If the nominal linkage cannot be turned.
    pub fn report(&self, tally: &Tally) -> Result<String, Box<LinkageFailure>> {
        let count = tally.turning();
        let percent = |part: u64| 100.0 * part as f64 / tally.sets as f64;
        let mm = |length: f64| 1e3 * length;
        let mut text = format!(
            "{} sets, of which {} ({:.4} %) cannot be turned; {:.4} % in closed form\n\
             yield, path error within {:.2} mm: {:.3} %\n\
             path error (mm): mean {:.4}, standard deviation {:.4}\n",
            tally.sets,
            tally.failed,
            percent(tally.failed),
            100.0 * self.failing(),
            mm(self.limit),
            percent(tally.accepted),
            mm(tally.error.mean(count)),
            mm(tally.error.deviation(count)),
        );
        let quantile = |(name, part): (&str, f64)| format!("{name} within {:.3}", mm(tally.quantile(part, self)));
        let quantiles = [("half of the sets", 0.5), ("90 %", 0.9), ("99 %", 0.99), ("99.9 %", 0.999)].map(quantile);
        let _ = writeln!(text, "path error (mm): {}\n", quantiles.join(", "));
        text += "crank °   mean off (mm)       deviation in x, linear   deviation in y, linear (mm)\n";
        for (index, ([x, y], Spread { deviations, .. })) in tally.tips.iter().zip(linear(self)?).enumerate().step_by(6) {
            let [mean_x, mean_y] = [x, y].map(|moments| mm(moments.mean(count)));
            let [by_sets_x, by_sets_y] = [x, y].map(|moments| mm(moments.deviation(count)));
            let [linear_x, linear_y] = deviations.map(mm);
            let crank = 360 / tally.tips.len() * index;
            let _ =
                writeln!(text, "{crank:7}   {mean_x:8.4} {mean_y:8.4}   {by_sets_x:14.4} {linear_x:7.4}   {by_sets_y:14.4} {linear_y:7.4}");
        }
        Ok(text)
    }
}
