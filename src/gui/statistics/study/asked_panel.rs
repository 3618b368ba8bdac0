//! Left: the file with what is to be said of it, the kind of study, limits and references.

use eframe::egui::Ui;

use crate::gui::field::pairs_ui;
use crate::gui::theme::space;
use crate::gui::view::{View, heading, keep_focus, one_of_ui, quiet};
use crate::message::message;
use crate::series::StudyKind;
use crate::session::statistics::StudyCommand;
use crate::session::{StatisticsAction, StatisticsCommand, StatisticsField};

/// So many notes on the file are shown; the notice had all of them.
const NOTES: usize = 4;

pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    file_ui(ui, view);
    ui.separator();
    heading(ui, view.text("statistics-study-kind"));
    for kind in StudyKind::ALL {
        view.radio(ui, StatisticsAction::KindOfStudy(kind));
    }
    let kind = view.session.statistics().study.kind;
    quiet(ui, view.text(hint(kind)));
    feature_ui(ui, view);
    ui.separator();
    let fields: Vec<_> = StatisticsField::of_study(kind)
        .iter()
        .map(|field| ((*field).into(), view.session.field_name((*field).into(), view.words), unit(kind, *field)))
        .collect();
    pairs_ui(ui, view, &fields);
    if kind == StudyKind::Linearity {
        quiet(ui, view.text("statistics-study-references-hint"));
    }
    if let Some(Ok(read)) = &view.session.statistics().study.read
        && let Some(said) = read.limits_text(view.words)
    {
        quiet(ui, said);
    }
}

/// Which file, what was read of it, and what is to be said of that.
fn file_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.field_button(ui, StatisticsAction::StudyColumns);
    let study = &view.session.statistics().study;
    let Some(file) = study.file() else { return };
    ui.label(&file.name);
    if let Some(Ok(read)) = &study.read {
        quiet(ui, read.read_text(view.words));
    }
    for note in file.notes.iter().take(NOTES) {
        quiet(ui, view.words.say(note));
    }
    let more = file.notes.len().saturating_sub(NOTES);
    if 0 < more {
        quiet(ui, view.words.say(&message!("statistics-study-more-faults").count("count", more)));
    }
}

/// Which of several features.
fn feature_ui(ui: &mut Ui, view: &mut View<'_>) {
    let study = &view.session.statistics().study;
    let Some(file) = study.file().filter(|file| 1 < file.features.len()) else { return };
    let name = quiet(ui, view.text("statistics-study-feature"));
    let entries = file.features.iter().map(|name| (name.clone(), view.words.number(name)));
    let now = study.feature.clone().unwrap_or_default();
    let (chosen, list) = one_of_ui(ui, "study-feature", space(50.0), &now, entries);
    keep_focus(ui, &list);
    list.labelled_by(name.id);
    if let Some(feature) = chosen {
        view.send(StatisticsCommand::Study(StudyCommand::ChooseFeature(feature)));
    }
}

/// What a kind of study reads.
const fn hint(kind: StudyKind) -> &'static str {
    match kind {
        StudyKind::Type1 => "statistics-study-type1-hint",
        StudyKind::Crossed => "statistics-study-crossed-hint",
        StudyKind::Nested => "statistics-study-nested-hint",
        StudyKind::Linearity => "statistics-study-linearity-hint",
        StudyKind::Stability => "statistics-study-stability-hint",
    }
}

/// Several sizes have no unit behind them.
const fn unit(kind: StudyKind, field: StatisticsField) -> &'static str {
    if matches!((kind, field), (StudyKind::Linearity, StatisticsField::StudyReference)) { "" } else { "mm" }
}
