//! The comment at the top of the SQL. It holds nothing that differs between two runs.

use std::io::{self, Write};

use fitcheck_core::tolerance::iso286::{Edition, JsHalves};

use super::{Dialect, ERRORS, LIMIT_ERRORS, Model};

const RULE: &str = "
Decision rule: the control's own, without a guard band, and limits belong to the zone: min_mm <= measured <= max_mm is
GOOD. A hole too small or a shaft too large is REWORK, with remove_um to the nearest limit; a hole too large or a shaft
too small is SCRAP. Everything is computed in exact decimals or whole numbers, never in floating point.

Columns of a verdict: min_mm, max_mm, deviation_um (measured minus nominal size), status, remove_um, error. A row that
cannot be judged keeps its place: error has its code, and the other five are null. Of several codes the first holds:
";

const STATED: &str = "
A size with its limits beside it is judged by them: outside them it is OUT OF LIMITS, with beyond_um (below the lower limit
it is negative), where feature does not say hole or shaft. measured-not-read, or before it:
";

const GRAMMAR: &str = "
Grammar: a callout is a size and one tolerance class, 25 H7 or 25H7, or the name of an own column, 25 PF. A size or a
measured value is in millimetres, with a decimal point, 1 to 9 figures before it, at most 6 after it besides zeros, and
no sign but a minus. The case of the letters tells hole from shaft. Spaces may stand around and between. Whatever else
fitcheck check reads (25 H7/g6, 10m, 12 +0.01 -0.015, a comma, a unit) is refused here, never guessed.

Tables: fitcheck_limits, one row for each class and step, with the deviations and the step, above over_mm and up to and
including to_mm; fitcheck_step, the step of each millimetre that a size is rounded up to; fitcheck_class, hole or shaft;
fitcheck_source, where a cell's limits come from.
";

/// Writes the comment.
pub(super) fn write(model: &Model, dialect: &Dialect, out: &mut dyn Write) -> io::Result<()> {
    let classes = model.defined();
    let cells = model.cells().len();
    let steps = model.ends().len();
    let last = model.last();
    let options = model.options();
    let edition = match options.edition {
        Edition::Of1988 => "1988 (cd, ef, fg to 10 mm)",
        Edition::Of2010 => "2010 (cd, ef, fg to 50 mm)",
    };
    let js = match options.js {
        JsHalves::Exact => "half micrometres of JS and js kept",
        JsHalves::Rounded => "half micrometres of JS7 to JS11 and js7 to js11 rounded down",
    };
    let mut text = format!(
        "Fitcheck: limits of size and verdicts, for {}.\n\
         Made by Fitcheck {}: fitcheck sql --dialect {}\n\n\
         {classes} classes, {cells} cells of limits, {steps} steps over 0 up to {last} mm.\n\
         Source: {}. Edition of ISO 286: {edition}; {js}.\n",
        dialect.engine,
        env!("CARGO_PKG_VERSION"),
        dialect.name,
        kinds(model).join(", "),
    );
    text.push_str(RULE);
    text.extend(ERRORS.map(|(code, meaning)| format!("  {code:<22} {meaning}\n")));
    text.push_str(STATED);
    text.extend(LIMIT_ERRORS.map(|(code, meaning)| format!("  {code:<22} {meaning}\n")));
    text.push_str(GRAMMAR);
    text.push_str(dialect.usage);
    for line in text.lines() {
        // The call and the sources may hold names of files: none of their characters ends the comment.
        let line: String = line.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        writeln!(out, "{}", format!("-- {line}").trim_end())?;
    }
    writeln!(out)
}

/// Where the limits come from, without sizes and remarks: `ISO 286`, `table my_hole.tab`.
fn kinds(model: &Model) -> Vec<&str> {
    let mut kinds: Vec<&str> = Vec::new();
    for name in model.sources() {
        let kind = name.split_once(", over ").map_or(name.as_str(), |(kind, _)| kind);
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    kinds
}
