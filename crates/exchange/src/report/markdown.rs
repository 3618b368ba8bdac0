//! The report as Markdown, for wikis, tickets and reviews: headings, lists and tables as GitHub and most other programs show them.
//!
//! Texts are escaped, so that a name cannot become a heading, a link, a picture, HTML or another cell. A check is a row of a table; as in
//! HTML, a report of more than [`MOST_CHECKS`] checks lists those that are not good or in doubt, and the counts
//! are those of all. The picture of a part and the contacts have no place here: HTML has both.

use std::io::{self, Write};

use fitcheck_core::message::message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::html::part::{SizeView, size_view};
use super::html::{MOST_CHECKS, closing};
use super::part::PartSheet;
use super::said::{decimals_of, heading, lacks, title};
use super::seen::ReportSurvey;
use super::told::{CheckSaid, callout, mark, on_one_line, standing, verdict};
use super::{Holds, Rendering, Report, head, statistics, text};
use crate::journal::Record;

pub const RENDERING: Rendering = Rendering {
    name: "markdown",
    title: "Markdown",
    is_for_people: true,
    holds: Holds::ReportAndStatistics,
    endings: &["md", "markdown"],
    render,
};

/// The columns of the checks, by the names of their texts.
const CHECKS: [&str; 15] = [
    "report-contact",
    "report-id",
    "report-callout",
    "parts-page-column-feature",
    "report-minimum",
    "report-maximum",
    "report-measured",
    "report-deviation",
    "report-verdict",
    "columns-page-role-simulated",
    "report-sheets-corrected",
    "report-limits-from",
    "report-from",
    "report-verdict-from",
    "parts-page-head-remark",
];

/// The columns of the sizes of a part.
const SIZES: [&str; 9] = [
    "report-balloon",
    "report-id",
    "report-callout",
    "report-limits",
    "report-measured",
    "report-deviation",
    "report-verdict",
    "report-from",
    "report-verdict-from",
];

fn render(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let seen = ReportSurvey::of(report, MOST_CHECKS)?;
    writeln!(out, "# {}\n", escaped(&title(report, words)))?;
    let simulated = seen.simulated;
    if 0 < simulated {
        let said = words.say(&message!("walk-page-simulated").count("count", simulated));
        writeln!(out, "**{}**: {}\n", escaped(&words.get("simulated")), escaped(&said))?;
    }
    for entry in head::whole(report, &seen, words) {
        writeln!(out, "- **{}**: {}", escaped(&entry.label), escaped(&entry.value))?;
    }
    if let Some(changes) = &seen.changes {
        writeln!(out, "\n## {}\n", escaped(&words.say(&changes.heading())))?;
        changes.lines.iter().try_for_each(|line| writeln!(out, "- {}", escaped(&words.say(line))))?;
    }
    for part in &report.parts {
        of_part(part, words, out)?;
    }
    for feature in statistics::of(report, words)? {
        writeln!(out, "\n## {}\n\n{}\n", escaped(&feature.heading), escaped(&feature.read))?;
        let figures =
            feature.figures.iter().map(|figure| format!("**{}**: {}", escaped(&figure.label), escaped(&figure.value)));
        figures.chain(feature.told.iter().map(|line| escaped(line))).try_for_each(|line| writeln!(out, "- {line}"))?;
    }
    let notes = seen.note(words).into_iter().chain(report.notes.iter().map(|note| words.say(note)));
    let notes: Vec<String> = notes.collect();
    if !notes.is_empty() {
        writeln!(out, "\n## {}\n", escaped(&words.get("report-notes")))?;
        notes.iter().try_for_each(|note| writeln!(out, "- {}", escaped(note)))?;
    }
    if report.is_of_series(seen.total) {
        return writeln!(out, "\n{}", escaped(&words.get("report-footer")));
    }
    if seen.total == 0 {
        return writeln!(out, "\n{}", escaped(&words.get("report-no-checks")));
    }
    writeln!(out, "\n## {}\n", escaped(&words.get("budget-page-checks")))?;
    counts(&seen, words, out)?;
    head(&CHECKS, words, out)?;
    seen.each(report, &mut |number, record| row(&check(number, record, words), out))?;
    for said in closing(report, &seen, words) {
        writeln!(out, "\n**{}**", escaped(&said))?;
    }
    writeln!(out, "\n{}", escaped(&words.get("report-footer")))
}

/// How many there are of each verdict, and how many of them nobody measured.
fn counts(seen: &ReportSurvey, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    for status in Status::ALL {
        let all = seen.counts.get(status.at()).map_or(0, |count| *count);
        let simulated = seen.simulated_of.get(status.at()).map_or(0, |count| *count);
        if 0 < all - simulated {
            let word = format!("{} {}", mark(Some(status)), words.told(&status));
            writeln!(out, "- {}: {}", escaped(&word), all - simulated)?;
        }
    }
    let simulated = seen.simulated;
    if 0 < simulated {
        writeln!(out, "- {} {}: {simulated}", mark(None), escaped(&words.get("simulated")))?;
    }
    writeln!(out, "- {}: {}\n", escaped(&words.get("report-total")), seen.total)
}

/// A whole part: its verdict, what it lacks, and its sizes.
fn of_part(part: &PartSheet, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let counts = part.standing();
    writeln!(out, "\n## {}\n", escaped(&heading(part, words)))?;
    writeln!(out, "**{}**: {}\n", escaped(&standing(part, words)), escaped(&words.told(&counts)))?;
    let plan = &part.plan.head;
    let said = [("parts-page-head-drawing", &plan.drawing), ("parts-page-head-remark", &plan.remark)];
    let said = said.into_iter().filter(|(_, text)| !text.is_empty());
    let said = said.map(|(id, text)| format!("**{}**: {}", escaped(&words.get(id)), escaped(text)));
    let mut said: Vec<String> = said.chain(lacks(part, words).iter().map(|text| escaped(text))).collect();
    if 0 < counts.simulated {
        said.insert(0, format!("**{}**", escaped(&words.get("simulated"))));
    }
    said.iter().try_for_each(|text| writeln!(out, "- {text}"))?;
    if !said.is_empty() {
        writeln!(out)?;
    }
    head(&SIZES, words, out)?;
    for (size, step, record) in part.sizes() {
        let record = record.map(AsRef::as_ref);
        let view = size_view(&size, step, record, words);
        let word = record.map_or_else(|| format!("{} {}", mark(None), view.word), |record| verdict(record, words));
        let SizeView { number, name, asked, limits, measured, deviation, origin, rule, .. } = view;
        row(&[number, name, asked, limits, measured, deviation, word, origin, rule], out)?;
    }
    Ok(())
}

fn check(number: usize, record: &Record, words: &Words) -> [String; CHECKS.len()] {
    let Record { limits, measurement, verdict: answer, .. } = record;
    let sizes = [limits.minimum(), limits.maximum(), measurement.diameter];
    let decimals = sizes.into_iter().map(decimals_of).fold(3, usize::max);
    let [minimum, maximum, measured] = sizes.map(|size| format!("{} mm", words.mm(size, decimals)));
    let said = CheckSaid::of(record, words);
    [
        number.to_string(),
        record.id.clone(),
        callout(record, words),
        words.say(&text::feature(limits.feature)),
        minimum,
        maximum,
        measured,
        format!("{} µm", words.signed_um(answer.size.deviation)),
        verdict(record, words),
        // Columns of their own: whoever reads the table with a program knows them by their names.
        if measurement.origin.is_simulated() { words.get("simulated") } else { String::new() },
        record.correction.map_or_else(String::new, |of| format!("{} µm", words.signed_um(of.change()))),
        said.limits_from,
        said.measured_from,
        said.rule,
        said.remarks.join("; "),
    ]
}

/// The head of a table.
fn head<const N: usize>(ids: &[&str; N], words: &Words, out: &mut dyn Write) -> io::Result<()> {
    row(&ids.map(|id| words.get(id)), out)?;
    writeln!(out, "|{}", "---|".repeat(N))
}

fn row<const N: usize>(cells: &[String; N], out: &mut dyn Write) -> io::Result<()> {
    let mut line = String::from("|");
    for cell in cells {
        line.push(' ');
        line.push_str(&escaped(cell));
        line.push_str(" |");
    }
    line.push('\n');
    out.write_all(line.as_bytes())
}

/// A text that is shown as it is, on one line: every sign that could begin something else gets a backslash. An at sign stands in a code
/// span, because programs make links of addresses after they have taken backslashes away.
fn escaped(text: &str) -> String {
    let text = on_one_line(text);
    let mut escaped = String::with_capacity(text.len());
    let mut before = [' '; 3];
    // A sign of a list is one where nothing but figures stands before it, and a blank behind it.
    let mut is_first = true;
    let mut is_number = true;
    let mut signs = text.chars().peekable();
    while let Some(c) = signs.next() {
        let ends = signs.peek().is_none_or(|next| *next == ' ');
        let is_special = match c {
            '-' | '+' => is_first && (ends || signs.peek() == Some(&c)),
            '=' => is_first,
            '.' => (is_number && !is_first && ends) || before.iter().all(|c| matches!(c, 'w' | 'W')),
            ')' => is_number && !is_first && ends,
            '/' => before[2] == ':',
            c => "\\`*_[]<>&|~$#{}!".contains(c),
        };
        if is_special {
            escaped.push('\\');
        }
        if c == '@' {
            escaped.push_str("`@`");
        } else {
            escaped.push(c);
        }
        is_first = false;
        is_number &= c.is_ascii_digit();
        before = [before[1], before[2], c];
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn a_text_stays_a_text() {
        for (text, expected) in [
            ("Bore A 25.012, +5 µm (ok)", "Bore A 25.012, +5 µm (ok)"),
            ("# head", "\\# head"),
            ("- item", "\\- item"),
            ("1. item", "1\\. item"),
            ("--- +1 === -5 µm", "\\--- +1 === -5 µm"),
            ("25.012 mm, 1.", "25.012 mm, 1."),
            ("12) item", "12\\) item"),
            ("a|b", "a\\|b"),
            ("[a](http://b)", "\\[a\\](http:\\//b)"),
            ("![a](b)", "\\!\\[a\\](b)"),
            ("<b>&amp;", "\\<b\\>\\&amp;"),
            ("www.a.b", "www\\.a.b"),
            ("a@b.c", "a`@`b.c"),
            ("*a* _b_ `c` ~d~ $e$", "\\*a\\* \\_b\\_ \\`c\\` \\~d\\~ \\$e\\$"),
            ("a\\", "a\\\\"),
            ("a\nb", "a b"),
        ] {
            assert_eq!(escaped(text), expected, "{text}");
        }
    }
}
