//! The end of the report: notes, what is attached, the signature; then what stands on every page.

use fitcheck_core::message::message;
use fitcheck_core::words::Words;

use super::attach::{Attachments, MOST};
use super::code::{CODE, Code};
use super::flow::{Flow, base};
use super::head::{MOST_NOTES, write_heading};
use super::look::{BODY, FOOT, GAP, LABEL, NOTE, SIDE, STRONG, Style, TEXT, TOP};
use super::sheet::{Area, Edge, Piece, Place, Shape, Sheet};
use super::tags::{Kind, Tags};
use crate::report::Report;
use crate::report::head::DATE;
use crate::report::seen::ReportSurvey;
use crate::report::template::Section;

/// The height of the lines to sign on.
const SIGNATURE: f32 = 36.0;

/// Writes the notes, and what the page cannot show.
pub(super) fn write_notes(
    flow: &mut Flow<'_>,
    report: &Report,
    (seen, attachments): (&ReportSurvey, &Attachments),
    words: &Words,
) {
    let style = NOTE.in_ink(TEXT);
    if MOST_NOTES < report.notes.len() {
        let section = flow.tags.add(Tags::ROOT, Kind::Section);
        write_heading(flow, section, &words.get("report-notes"));
        for note in &report.notes {
            flow.paragraph(section, style, &words.say(note));
        }
        flow.y += GAP / 2.0;
    }
    let section = flow.tags.add(Tags::ROOT, Kind::Section);
    if let Some(journal) = &report.journal {
        let said = message!("report-journal").text("numbers", &journal.numbers).text("chain", journal.chain);
        let said = said.text("number", journal.head.number).text("hash", journal.head.hash);
        flow.paragraph(section, NOTE, &words.say(&said));
    }
    flow.paragraph(section, NOTE, &words.get("report-footer"));
    if 0 < seen.contacts && !attachments.files.is_empty() {
        flow.paragraph(section, NOTE, &words.get("report-pdf-contacts"));
    }
    if attachments.is_left_out {
        let said = message!("report-pdf-not-attached").text("most", MOST >> 20);
        flow.paragraph(section, style, &words.say(&said));
    }
    if !attachments.files.is_empty() {
        let names: Vec<&str> = attachments.files.iter().map(|file| file.name).collect();
        let said = message!("report-pdf-attached").text("names", names.join(", "));
        flow.paragraph(section, NOTE, &words.say(&said));
    }
    if flow.is_cut {
        flow.paragraph(section, style, &words.get("report-pdf-cut"));
    }
    if flow.fonts.has_lacked() {
        flow.paragraph(section, style, &words.get("report-pdf-substituted"));
    }
}

/// Writes what stands at the foot of the last page: the statement of conformity, the lines to sign on, the code.
pub(super) fn write_end(flow: &mut Flow<'_>, report: &Report, seen: &ReportSurvey, words: &Words) {
    let template = &report.template;
    if !template.rule_text.is_empty() {
        let section = flow.tags.add(Tags::ROOT, Kind::Section);
        flow.paragraph(section, BODY, &template.rule_text);
    }
    if template.has(Section::Statement) {
        let section = flow.tags.add(Tags::ROOT, Kind::Section);
        flow.y += GAP;
        flow.room(3.0 * STRONG.line());
        flow.paragraph(section, STRONG, &words.say(&seen.statement(report)));
    }
    let newest = report.journal.as_ref().and_then(|journal| journal.newest).filter(|_| template.has(Section::Code));
    let code = newest.and_then(|head| Code::of(&head.hash.to_string()).map(|code| (head, code)));
    let signs = template.has(Section::Signature);
    if !signs && code.is_none() {
        return;
    }
    flow.y += GAP;
    flow.room(if code.is_some() { CODE + 12.0 } else { SIGNATURE });
    let mut right = flow.right();
    if let Some((head, code)) = code {
        let area = Area::new(right - CODE, flow.bottom() - CODE - 10.0, CODE, CODE);
        let said = words.say(&message!("report-code-said").text("number", head.number).text("hash", head.hash));
        code.write(flow, area, said);
        let text = format!("{}:{}", head.number, head.hash.short());
        let section = flow.tags.add(Tags::ROOT, Kind::Paragraph);
        flow.say_to(Some(section), [right, flow.bottom()], FOOT, text);
        right -= CODE + 18.0;
    }
    if signs {
        write_signature(flow, report, right, words);
    }
    flow.y = flow.bottom();
}

fn write_signature(flow: &mut Flow<'_>, report: &Report, right: f32, words: &Words) {
    let section = flow.tags.add(Tags::ROOT, Kind::Section);
    let line = flow.bottom() - 14.0;
    let gap = 18.0;
    let width = (right - SIDE - 2.0 * gap) / 3.0;
    let mut x = SIDE;
    for id in ["report-sign-name", "report-sign-date", "report-sign-signature"] {
        flow.put(None, Shape::Line { from: [x, line], to: [x + width, line], width: 0.8, ink: TEXT });
        let element = flow.tags.add(section, Kind::Paragraph);
        flow.say(Some(element), [x, base(line + 1.0, LABEL.line(), LABEL)], LABEL, format!("{} ", words.get(id)));
        if let Some(name) = report.inspector.as_ref().filter(|_| id == "report-sign-name") {
            for said in flow.wrap(name, STRONG, width, 1) {
                flow.say(Some(element), [x, line - 4.0], STRONG, said);
            }
        }
        x += width + gap;
    }
}

/// Writes what stands on every page: above what the report is about, and that a value was simulated; below the program, and which page it is.
pub(super) fn write_running(flow: &mut Flow<'_>, report: &Report, (title, simulated): (&str, bool), words: &Words) {
    let [width, height] = flow.size();
    let pages = flow.sheets.len();
    let word = words.get("simulated");
    let program = format!("{} · {}", report.program, report.created.strftime(DATE));
    let [title] = [flow.wrap(title, FOOT, width - 2.0 * SIDE - 140.0, 1)].map(|lines| lines.concat());
    let program = flow.wrap(&program, FOOT, width - 2.0 * SIDE - 120.0, 1).concat();
    let fonts = flow.fonts;
    for (at, sheet) in flow.sheets.iter_mut().enumerate() {
        sheet.pieces.push((sheet.shapes.len(), Piece::Running));
        let mut say = |place: Place, style: Style, text: String| sheet.shapes.push(Shape::Text(place, style, text));
        let low = height - 26.0;
        say([SIDE, low], FOOT, program.clone());
        let page = words.say(&message!("report-pdf-page").count("page", at + 1).count("pages", pages));
        let page_width = fonts.width(&page, FOOT.weight, FOOT.size);
        say([width - SIDE - page_width, low], FOOT, page);
        if 0 < at {
            say([SIDE, TOP], FOOT, title.clone());
        }
        if simulated {
            mark(sheet, [width - SIDE, if at == 0 { TOP + 3.0 } else { TOP - 12.0 }], &word, fonts);
        }
    }
}

/// That a value was simulated, in a dashed frame that ends here.
fn mark(sheet: &mut Sheet, [right, top]: Place, word: &str, fonts: &super::fonts::Fonts) {
    let width = fonts.width(word, STRONG.weight, STRONG.size) + 16.0;
    let area = Area::new(right - width, top, width, 17.0);
    let edge = Edge { ink: TEXT, width: 1.2, is_dashed: true };
    sheet.shapes.push(Shape::Block { area, radius: 3.0, fill: None, edge: Some(edge) });
    let place = [area.x + 8.0, base(area.y, area.height, STRONG)];
    sheet.shapes.push(Shape::Text(place, STRONG, word.to_owned()));
}
