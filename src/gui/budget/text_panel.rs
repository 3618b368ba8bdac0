//! Left: the budget as TOML, edited in place, and what is wrong with it.

use eframe::egui::accesskit::Invalid;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Id, ScrollArea, Stroke, TextBuffer, TextEdit, Ui};

use crate::gui::room::is_low;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::message;
use crate::session::{BudgetAction, BudgetCommand};

/// The lines of the text that are in sight at least.
const LEAST_ROWS: usize = 8;

/// New, open, save.
pub(super) fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for action in [BudgetAction::NewBudget, BudgetAction::SaveBudget] {
            view.field_button(ui, action);
        }
    });
}

/// The text has an id of its own for each budget that is opened: undo never brings back another one.
pub(super) fn id(view: &View<'_>) -> Id {
    Id::unique(("budget-text", view.session.budget().document.opened))
}

/// The text and its errors.
pub(super) fn text_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let budget = session.budget();
    let mut name = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        name = Some(heading(ui, view.text("budget-page-text")).id);
        if budget.document.is_unsaved() {
            quiet(ui, view.words.say(&message!("budget-page-not-saved").text("name", budget.document.name())));
        } else if !budget.document.text.is_empty() {
            quiet(ui, budget.document.name());
        }
    });
    let error = budget.read.as_ref().and_then(|read| read.as_ref().err());
    let line = error.and_then(|error| error.place.line);
    let part = if is_low(ui) { 0.3 } else { 0.46 };
    let height = (ui.ctx().content_rect().height() * part).max(space(32.0));
    let mut text = budget.document.text.clone();
    ScrollArea::vertical().id_salt("budget-text").max_height(height).show(ui, |ui| {
        let marked = |ui: &Ui, buffer: &dyn TextBuffer, width: f32| {
            let job = layout(ui, buffer.as_str(), width, line);
            ui.fonts_mut(|fonts| fonts.layout_job(job))
        };
        let mut layouter = marked;
        let edit = TextEdit::multiline(&mut text)
            .id(id(view))
            .font(theme::mono(sizes().small))
            .desired_width(f32::INFINITY)
            .desired_rows(LEAST_ROWS)
            .layouter(&mut layouter);
        let mut response = ui.add(edit);
        if let Some(name) = name {
            response = response.labelled_by(name);
        }
        if response.changed() {
            view.send(BudgetCommand::Edit(text.clone()));
        }
        if let Some(error) = error {
            let said = view.words.told(error);
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_invalid(Invalid::True);
                node.set_description(said.clone());
            });
        }
    });
    match error {
        Some(error) => _ = problem(ui, view.words.told(error)),
        None if budget.document.text.is_empty() => _ = quiet(ui, view.text("budget-page-none")),
        None => {}
    }
}

/// The text with quiet comments; the line of an error is underlined.
fn layout(ui: &Ui, text: &str, width: f32, error: Option<usize>) -> LayoutJob {
    let palette = palette(ui.ctx());
    let font = theme::mono(sizes().small);
    let mut job = LayoutJob::default();
    job.wrap.max_width = width;
    for (number, line) in (1..).zip(text.split_inclusive('\n')) {
        let colour = if line.trim_start().starts_with('#') { palette.quiet.0 } else { palette.text.0 };
        let mut format = TextFormat::simple(font.clone(), colour);
        if error == Some(number) {
            format.underline = Stroke::new(2.0, palette.error.0);
        }
        job.append(line, 0.0, format);
    }
    if text.is_empty() {
        job.append("", 0.0, TextFormat::simple(font, palette.text.0));
    }
    job
}
