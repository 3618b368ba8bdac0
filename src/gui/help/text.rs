//! A paragraph of the manual: its looks, links within the manual, and words that were searched for.

use std::ops::Range;
use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    CursorIcon, FontId, Galley, Label, Rect, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::session::HelpCommand;
use crate::session::help::{HelpPlace, HelpWords, Span};

/// The text in the width that is left; a click on a link opens its place. Each line of a link is as high as its line of text.
pub(super) fn spans_ui(ui: &mut Ui, view: &mut View<'_>, spans: &[Span], words: Option<&HelpWords>) -> Rect {
    let mut job = job(ui, spans, words);
    job.wrap.max_width = ui.available_width();
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let rect = ui.add(Label::new(Arc::clone(&galley))).rect;
    for (place, name, letters) in links(spans) {
        link_ui(ui, view, place, name, &lines(&galley, &letters, rect));
    }
    rect
}

/// A link over its letters: one stop for Tab, whatever its lines are.
fn link_ui(ui: &Ui, view: &mut View<'_>, place: &HelpPlace, name: &str, lines: &[Rect]) {
    let Some(first) = lines.first() else { return };
    // By its place on the page, which stays the same wherever the page is scrolled to.
    let place_on_page = (first.min - ui.min_rect().min).round();
    let id = ui.scope_id().with(("link", place_on_page.x.to_bits(), place_on_page.y.to_bits(), name));
    let link = ui.interact(*first, id, Sense::click());
    link.widget_info(|| WidgetInfo::labeled(Role::Link, true, name));
    if link.gained_focus() {
        ui.scroll_to_rect(*first, None);
    }
    let mut is_clicked = link.clicked();
    let mut is_under = link.hovered();
    for (number, line) in lines.iter().enumerate().skip(1) {
        let more = ui.interact(*line, id.with(number), Sense::CLICK);
        is_clicked |= more.clicked();
        is_under |= more.hovered();
    }
    if is_under {
        ui.set_cursor_icon(CursorIcon::PointingHand);
    }
    let stroke = Stroke::new(2.0, palette(ui.ctx()).focus.0);
    for line in lines {
        if link.has_focus() {
            ui.painter().rect_stroke(line.expand2(vec2(2.0, 0.0)), 2.0, stroke, StrokeKind::Inside);
        } else if is_under {
            ui.painter().hline(line.x_range(), line.bottom() - 1.0, Stroke { width: 1.0, ..stroke });
        }
    }
    if is_clicked {
        view.send(HelpCommand::Open(place.clone()));
    }
}

/// The links of a text: where they lead, what they say, and their letters.
fn links(spans: &[Span]) -> Vec<(&HelpPlace, &str, Range<usize>)> {
    let mut from = 0;
    let mut links = Vec::new();
    for span in spans {
        let end = from + span.text.chars().count();
        links.extend(span.link.as_ref().map(|place| (place, span.text.as_str(), from..end)));
        from = end;
    }
    links
}

/// Where letters of a text stand: one place for each of its lines.
fn lines(galley: &Galley, letters: &Range<usize>, text: Rect) -> Vec<Rect> {
    let mut from = 0;
    let mut places = Vec::new();
    for row in &galley.rows {
        let end = from + row.row.glyphs.len();
        let taken = letters.start.max(from)..letters.end.min(end);
        let glyphs = row.row.glyphs.get(taken.start.saturating_sub(from)..taken.end.saturating_sub(from));
        if let Some([first, .., last] | [first @ last]) = glyphs.filter(|_| !taken.is_empty()) {
            let area = row.rect();
            let across = (first.pos.x, last.pos.x + last.advance_width);
            let place = Rect::from_min_max(
                pos2(area.left() + across.0, area.top()),
                pos2(area.left() + across.1, area.bottom()),
            );
            places.push(place.translate(text.min.to_vec2()));
        }
        from = end + usize::from(row.ends_with_newline);
    }
    places
}

/// Spans as one text; words that were searched for stand out.
pub(super) fn job(ui: &Ui, spans: &[Span], words: Option<&HelpWords>) -> LayoutJob {
    let palette = palette(ui.ctx());
    let mut job = LayoutJob::default();
    for span in spans {
        let mut format = TextFormat::simple(font(span), palette.text.0);
        format.italics = span.is_italic;
        if span.is_code {
            format.background = palette.sunken.0;
        }
        if span.link.is_some() {
            format.color = ui.visuals().hyperlink_color;
            format.underline = Stroke::new(1.0, format.color);
        }
        append(&mut job, &span.text, &format, words);
    }
    job
}

/// A text of one look; in it, the words that were searched for are bold.
pub(super) fn append(job: &mut LayoutJob, text: &str, format: &TextFormat, words: Option<&HelpWords>) {
    let mut from = 0;
    for place in words.map(|words| words.places_in(text)).unwrap_or_default() {
        job.append(text.get(from..place.start).unwrap_or_default(), 0.0, format.clone());
        let mut found = format.clone();
        found.font_id = theme::bold(format.font_id.size);
        found.underline = Stroke::new(2.0, format.color);
        from = place.end;
        job.append(text.get(place).unwrap_or_default(), 0.0, found);
    }
    job.append(text.get(from..).unwrap_or_default(), 0.0, format.clone());
}

fn font(span: &Span) -> FontId {
    match span {
        Span { is_code: true, .. } => theme::mono(sizes().body),
        Span { is_bold: true, .. } => theme::bold(sizes().body),
        _ => theme::font(sizes().body),
    }
}

/// The ground of what was found.
pub(super) fn mark_shape(ui: &Ui, rect: Rect) -> Shape {
    Shape::rect_filled(rect.expand2(vec2(space(1.5), space(0.5))), 4.0, palette(ui.ctx()).tint.0)
}
