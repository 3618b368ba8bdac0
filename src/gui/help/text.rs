//! A paragraph of the manual: its looks, and links within the manual.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{FontId, Label, Link, RichText, Ui};

use crate::gui::theme::{self, palette, sizes};
use crate::gui::view::View;
use crate::session::HelpCommand;
use crate::session::help::Span;

/// The text in the width that is left; a click on a link opens its place.
pub(super) fn spans_ui(ui: &mut Ui, view: &mut View<'_>, spans: &[Span]) {
    if spans.iter().all(|span| span.link.is_none()) {
        ui.add(Label::new(job(ui, spans)).wrap());
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        ui.spacing_mut().interact_size.y = 0.0;
        // Between links the texts go on as one.
        for run in spans.chunk_by(|one, other| one.link.is_none() && other.link.is_none()) {
            match run {
                [Span { link: Some(place), text, .. }] => {
                    if ui.add(Link::new(RichText::new(text).underline())).clicked() {
                        view.send(HelpCommand::Open(place.clone()));
                    }
                }
                run => _ = ui.add(Label::new(job(ui, run)).wrap()),
            }
        }
    });
}

/// Spans as one text.
pub(super) fn job(ui: &Ui, spans: &[Span]) -> LayoutJob {
    let palette = palette(ui.ctx());
    let mut job = LayoutJob::default();
    for span in spans {
        let mut format = TextFormat::simple(font(span), palette.text.0);
        format.italics = span.is_italic;
        if span.is_code {
            format.background = palette.sunken.0;
        }
        job.append(&span.text, 0.0, format);
    }
    job
}

fn font(span: &Span) -> FontId {
    match span {
        Span { is_code: true, .. } => theme::mono(sizes().body),
        Span { is_bold: true, .. } => theme::bold(sizes().body),
        _ => theme::font(sizes().body),
    }
}
