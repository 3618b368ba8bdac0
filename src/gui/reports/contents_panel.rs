//! Right: saving and printing; language, paper, sections, and what stands in the head.

use eframe::egui::{Ui, vec2};

use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::theme::{control, space};
use crate::gui::view::{View, heading, one_of_ui, quiet};
use crate::message::message;
use crate::report::RENDERINGS;
use crate::report::paper::Paper;
use crate::report::template::Section;
use crate::session::{ReportsAction, ReportsCommand, ReportsField};
use crate::words::Language;

/// What is done with the report: it stands where a verdict stands on other pages.
pub(super) fn write_ui(ui: &mut Ui, view: &mut View<'_>) {
    let size = vec2(ui.available_width(), control(ui).max(44.0));
    view.main_button(ui, ReportsAction::SavePdf, size);
    ui.horizontal_wrapped(|ui| {
        view.button(ui, ReportsAction::Print);
        for (number, rendering) in RENDERINGS.iter().enumerate() {
            let is_apt = rendering.refusal(view.session.reports().paper()).is_none();
            if rendering.name != "pdf" && is_apt {
                view.button(ui, ReportsAction::Save(number));
            }
        }
    });
}

pub(super) fn contents_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("reports-page-contents"));
    language_ui(ui, view);
    paper_ui(ui, view);
    ui.separator();
    heading(ui, view.text("reports-page-show"));
    let template = view.session.reports().template();
    for section in Section::ALL.iter().copied().filter(|section| template.has(*section)) {
        let mut is_on = view.session.reports().shows(section);
        if ui.checkbox(&mut is_on, view.text(section.text())).clicked() {
            view.send(ReportsCommand::Show(section, is_on));
        }
    }
    compared_ui(ui, view);
    ui.separator();
    heading(ui, view.text("report-section-head"));
    for field in ReportsField::all() {
        let name = quiet(ui, view.text(field.name()));
        field_ui(ui, view, *field, name.id, FieldStyle::text(ui.available_width()));
    }
    ui.add_space(space(2.0));
}

/// The earlier report that this one says the changes since.
fn compared_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.button(ui, ReportsAction::Compare);
    let Some((name, earlier)) = view.session.reports().earlier() else { return };
    let said = message!("reports-page-compared").text("name", name).text("since", &earlier.created);
    quiet(ui, view.words.say(&said));
    view.button(ui, ReportsAction::CompareNot);
}

fn language_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("reports-page-language"));
    let now = view.session.reports().language();
    let as_window = (None, view.text("reports-page-language-of-window"));
    let named = Language::all().map(|language| (Some(language), language.name().to_owned()));
    let width = ui.available_width();
    let (chosen, list) = one_of_ui(ui, "reports-language", width, &now, std::iter::once(as_window).chain(named));
    list.labelled_by(name.id);
    if let Some(language) = chosen {
        view.send(ReportsCommand::Language(language));
    }
}

fn paper_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("reports-page-paper"));
    let now = view.session.reports().paper();
    let papers = Paper::ALL.iter().map(|paper| (*paper, view.text(paper.text())));
    let (chosen, list) = one_of_ui(ui, "reports-paper", ui.available_width(), &now, papers);
    list.labelled_by(name.id);
    if let Some(paper) = chosen {
        view.send(ReportsCommand::Paper(Some(paper)));
    }
}
