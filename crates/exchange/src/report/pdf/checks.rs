//! Checks without a plan, or besides those of whole parts: one after the other in a table.

use std::io;

use fitcheck_core::words::Words;

use super::card::Card;
use super::columns::Widths;
use super::flow::Flow;
use super::grounds::Grounds;
use super::look::GAP;
use super::rows::Rows;
use super::table::Table;
use super::tags::TagId;
use crate::journal::Record;
use crate::report::said::{cause, removal_said, undecided};
use crate::report::seen::ReportSurvey;
use crate::report::template::Section;
use crate::report::{Report, text};

/// The answer of a single check.
pub(super) fn card(record: &Record, words: &Words) -> Card {
    let verdict = &record.verdict;
    let mut lines: Vec<String> = removal_said(verdict, words).into_iter().collect();
    lines.extend(cause(verdict, words));
    lines.push(words.say(&text::size(&verdict.size, words)));
    lines.extend(undecided(verdict, words));
    lines.extend(record.doubt.map(|doubt| words.told(&doubt)));
    Card {
        status: Some(verdict.status()),
        word: words.told(verdict),
        simulated: record.measurement.origin.is_simulated().then(|| words.get("simulated")),
        lines,
        counts: Vec::new(),
    }
}

/// The only check of a report.
pub(super) fn only(report: &Report) -> io::Result<Option<Record>> {
    let mut only = None;
    report.checks.each(&mut |record| {
        only.get_or_insert_with(|| record.clone());
        Ok(())
    })?;
    Ok(only)
}

/// Writes the table of the checks that the pages list, and what they rest on.
pub(super) fn write(
    flow: &mut Flow<'_>,
    section: TagId,
    report: &Report,
    seen: &ReportSurvey,
    words: &Words,
) -> io::Result<()> {
    let rows = Rows { words, decimals: seen.decimals, report };
    let mut widths = Widths::new(flow.fonts, words, &report.template.columns);
    let mut are_any = false;
    seen.each(report, &mut |number, record| {
        widths.see(flow.fonts, &rows.plain(number.to_string(), record));
        are_any = true;
        Ok(())
    })?;
    if !are_any {
        return Ok(());
    }
    let mut table = Table::new(flow, section, widths.fit(flow.width()), words);
    table.begin(flow);
    let mut grounds = Grounds::new(words);
    seen.each(report, &mut |number, record| {
        let row = rows.record(number.to_string(), record);
        let laid = table.lay(flow, &row);
        table.row(flow, laid);
        grounds.see(&row.label, record);
        Ok(())
    })?;
    flow.y += GAP;
    for shown in [Section::Rule, Section::Caveats].into_iter().filter(|section| report.template.has(*section)) {
        grounds.write(flow, section, shown);
    }
    Ok(())
}
