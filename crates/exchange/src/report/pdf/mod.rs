//! The report as pages to print, to sign and to keep: PDF, A4 or letter, with its fonts, tagged, with its data attached.
//!
//! | file | what |
//! |---|---|
//! | here | what stands on the pages, in its order |
//! | `head`, `card` | the first page's head: title, answer, what must be known before the values |
//! | `parts`, `lot`, `checks` | a whole part; several on one page; checks without a plan |
//! | `rows`, `cells`, `table`, `columns` | a value as a row of cells, the table, the widths of its columns |
//! | `bands`, `pictures`, `svg`, `signs` | limit bands, pictures with balloons, signs of verdicts |
//! | `grounds` | what the verdicts rest on |
//! | `lot` | many parts with their verdicts, the worst first |
//! | `statistics` | a page for each feature: figures and charts |
//! | `closing`, `code` | notes, statement, signature and code, and what stands on every page |
//! | `label` | the answer on a label |
//! | `pages`, `raster` | the pages for a window; a page as a picture |
//! | `flow`, `wrap`, `fonts`, `look` | where things go: pages, lines, letters, colours and sizes |
//! | `sheet`, `tags` | pages as plain values, and their logical structure |
//! | `attach`, `emit`, `brush`, `paths` | the data as attachments; plain values become a file |
//!
//! The file conforms to PDF/A-3a (ISO 19005-3: it can be kept, and has its data in it) and to PDF/UA-1 (ISO 14289-1: it can be read aloud). Its
//! text can be searched and copied. It has no links, no scripts and no forms, and nothing in it comes from a clock or from chance: the same
//! report always gives the same bytes.
//!
//! All pages are in memory, and so are the tables' rows. So the pages list at most [`MOST_CHECKS`]: of a longer report those that are not good or
//! in doubt.

mod attach;
mod bands;
mod brush;
mod card;
mod cells;
mod checks;
mod closing;
mod code;
mod columns;
mod emit;
mod flow;
mod fonts;
mod grounds;
mod head;
mod label;
mod look;
mod lot;
mod pages;
mod parts;
mod paths;
mod pictures;
mod raster;
mod rows;
mod sheet;
mod signs;
mod statistics;
mod svg;
mod table;
mod tags;
mod wrap;

use std::io::{self, Write};

use fitcheck_core::words::Words;

use attach::Attachments;
use emit::{Book, EmitError};
use flow::Flow;
use fonts::Fonts;
pub use pages::{Canvas, CanvasEdge, Pages, PictureDots};
use pictures::Pictures;
pub(super) use raster::raster;
use tags::{Kind, TagId, Tags};

use super::said::{heading, title};
use super::seen::ReportSurvey;
use super::template::Section;
use super::{Holds, Rendering, Report};

pub const RENDERING: Rendering = Rendering {
    name: "pdf",
    title: "PDF",
    is_for_people: true,
    holds: Holds::ReportAndStatistics,
    endings: &["pdf"],
    render,
};

/// The most checks that the pages list: some 500 pages.
pub const MOST_CHECKS: usize = 20_000;

/// How much is written at once.
const PIECE: usize = 16 << 10;

fn render(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    if report.template.is_blank() {
        return rendered(&report.blank(), words, out);
    }
    rendered(report, words, out)
}

fn rendered(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let attachments = Attachments::of(report, words)?;
    let seen = ReportSurvey::of(report, MOST_CHECKS)?;
    let made = made(report, words, (&seen, &attachments), None);
    let bytes = match made {
        // The report is more than its picture.
        Err(EmitError::Picture(why)) => made_without(report, words, (&seen, &attachments), &why)?,
        other => other.map_err(io::Error::from)?,
    };
    bytes.chunks(PIECE).try_for_each(|piece| out.write_all(piece))
}

fn made_without(report: &Report, words: &Words, of: (&ReportSurvey, &Attachments), why: &str) -> io::Result<Vec<u8>> {
    made(report, words, of, Some(why)).map_err(io::Error::from)
}

/// The file; `refused` says why it has no pictures.
fn made(
    report: &Report,
    words: &Words,
    (seen, attachments): (&ReportSurvey, &Attachments),
    refused: Option<&str>,
) -> Result<Vec<u8>, EmitError> {
    let fonts = Fonts::new()?;
    let pictures = Pictures::of(report, super::statistics::of(report, words)?, refused);
    let mut flow = Flow::new(&fonts, report.paper.points());
    let name = title(report, words);
    let outline = set(&mut flow, report, (seen, attachments, &pictures), words)?;
    let Flow { sheets, tags, .. } = flow;
    let book = Book {
        fonts: &fonts,
        size: report.paper.points(),
        sheets,
        tags,
        pictures: pictures.all,
        outline,
        title: name,
        language: words.language().code(),
    };
    emit::bytes(book, report, attachments)
}

/// Sets all pages, with what stands on every one of them.
fn set(
    flow: &mut Flow<'_>,
    report: &Report,
    (seen, attachments, pictures): (&ReportSurvey, &Attachments, &Pictures),
    words: &Words,
) -> io::Result<Vec<(String, usize, f32)>> {
    let simulated = 0 < seen.simulated || report.parts.iter().any(|part| 0 < part.standing().simulated);
    if report.paper.is_label() {
        let mut first = head::signals(report, seen, words);
        first.extend(report.parts.iter().flat_map(|part| super::said::lacks(part, words)));
        label::write(flow, report, (&answer(report, seen, words)?, simulated, first), words);
        return Ok(Vec::new());
    }
    let outline = write(flow, report, (seen, attachments, pictures), words)?;
    closing::write_running(flow, report, (&title(report, words), simulated), words);
    Ok(outline)
}

/// The pages as a window shows them.
fn pages(report: &Report, words: &Words) -> io::Result<Pages> {
    if report.template.is_blank() {
        return set_pages(&report.blank(), words);
    }
    set_pages(report, words)
}

fn set_pages(report: &Report, words: &Words) -> io::Result<Pages> {
    let fonts = Fonts::new()?;
    let seen = ReportSurvey::of(report, MOST_CHECKS)?;
    let attachments = Attachments::named(report, words, &seen)?;
    let pictures = Pictures::of(report, super::statistics::of(report, words)?, None);
    let mut flow = Flow::new(&fonts, report.paper.points());
    set(&mut flow, report, (&seen, &attachments, &pictures), words)?;
    Ok(Pages::new(flow.size(), flow.sheets, pictures.sources))
}

/// Fills the pages; gives the headings with their places. What must be known is told whatever the template shows.
fn write(
    flow: &mut Flow<'_>,
    report: &Report,
    (seen, attachments, pictures): (&ReportSurvey, &Attachments, &Pictures),
    words: &Words,
) -> io::Result<Vec<(String, usize, f32)>> {
    let name = title(report, words);
    let mut outline = vec![(name.clone(), 0, 0.0)];
    let about = match report.parts.as_slice() {
        [only] => heading(only, words),
        _ => report.part.clone().unwrap_or_default(),
    };
    head::write_title(flow, (report, pictures), [&name, &about], words);
    let section = flow.tags.add(Tags::ROOT, Kind::Section);
    let card = answer(report, seen, words)?;
    let shows = |section| report.template.has(section);
    let entries = if shows(Section::Head) { super::head::entries(report, words) } else { Vec::new() };
    let has_verdict = shows(Section::Verdict) && !report.is_of_series(seen.total);
    head::write_card(flow, section, has_verdict.then_some(&card), &entries);
    // A sheet that is filled in by hand lacks every value.
    if !report.template.is_blank() {
        write_first(flow, section, report, seen, words);
    }
    if let Some(changes) = &seen.changes {
        let lines = std::iter::once(changes.heading()).chain(changes.lines.iter().cloned());
        head::write_signals(flow, section, &lines.map(|line| words.say(&line)).collect::<Vec<_>>());
    }
    if shows(Section::Rule) {
        head::write_sentences(flow, section, &seen.shared.entries(words));
    }
    if shows(Section::Lot) && 1 < report.parts.len() {
        lot::write(flow, section, &report.parts, words);
    }
    let is_one = report.parts.len() == 1;
    // Without anything of a part its page would be a heading: what it lacks stands above.
    let of_parts = [Section::Picture, Section::Features, Section::Rule, Section::Caveats, Section::Remarks];
    let has_pages = is_one || of_parts.into_iter().any(shows);
    for (number, part) in report.parts.iter().enumerate().filter(|_| has_pages) {
        let mut section = section;
        if !is_one {
            flow.turn();
            let name = heading(part, words);
            outline.push((name.clone(), flow.page(), flow.y));
            section = flow.tags.add(Tags::ROOT, Kind::Section);
            head::write_heading(flow, section, &name);
            if !report.template.is_blank() {
                head::write_card(flow, section, Some(&parts::card(part, words)), &[]);
                parts::write_lacks(flow, section, part, words);
            }
        }
        parts::write(flow, (section, report), part, (number, pictures), words);
    }
    // Values that are in no part's table: older ones, those of more parts, and those of no part.
    let shown: usize = report.parts.iter().map(|part| part.standing().measured).sum();
    if shown < seen.total && shows(Section::Features) {
        let mut section = section;
        if !report.parts.is_empty() {
            section = flow.tags.add(Tags::ROOT, Kind::Section);
            let name = words.get("report-pdf-all-checks");
            flow.room(100.0);
            outline.push((name.clone(), flow.page(), flow.y));
            head::write_heading(flow, section, &name);
        }
        checks::write(flow, section, report, seen, words)?;
    }
    outline.extend(statistics::write(flow, pictures));
    closing::write_notes(flow, report, (seen, attachments), words);
    closing::write_end(flow, report, seen, words);
    Ok(outline)
}

/// What must be known before the values.
fn write_first(flow: &mut Flow<'_>, section: TagId, report: &Report, seen: &ReportSurvey, words: &Words) {
    let mut signals = head::signals(report, seen, words);
    if seen.total == 0 && !report.is_of_series(seen.total) {
        signals.push(words.get("report-no-checks"));
    }
    head::write_signals(flow, section, &signals);
    if let [only] = report.parts.as_slice() {
        parts::write_lacks(flow, section, only, words);
    } else {
        head::write_signals(flow, section, &lacks_of_all(report, words));
    }
}

/// What the first card says: the verdict of the only part or check, or how many there are of each.
fn answer(report: &Report, seen: &ReportSurvey, words: &Words) -> io::Result<card::Card> {
    Ok(match report.parts.as_slice() {
        [only] => parts::card(only, words),
        [] if seen.total == 1 => match checks::only(report)? {
            Some(record) => checks::card(&record, words),
            None => head::counts(seen, words),
        },
        [] => head::counts(seen, words),
        parts => head::counts_of_parts(parts, words),
    })
}

/// What parts lack, where there are several, up to so many lines; each is told on its own page, too.
const MOST_LACKS: usize = 12;

fn lacks_of_all(report: &Report, words: &Words) -> Vec<String> {
    let mut all = Vec::new();
    for part in &report.parts {
        let name = heading(part, words);
        all.extend(super::said::lacks(part, words).into_iter().map(|lack| format!("{name}: {lack}")));
    }
    let more = all.len().saturating_sub(MOST_LACKS);
    all.truncate(MOST_LACKS);
    if 0 < more {
        all.push(words.say(&fitcheck_core::message::message!("report-pdf-more-lacks").count("count", more)));
    }
    all
}
