//! The record that is open: its verdict, its whole reasoning, and what can be done with it.

use eframe::egui::{Align, Label, Layout, RichText, Ui, vec2};

use super::cells::RecordCells;
use super::correction_panel::correction_ui;
use super::reasons::{Line, lines};
use crate::gui::columns::column_ui;
use crate::gui::shapes::Edge;
use crate::gui::theme::{self, sizes, space};
use crate::gui::verdict_card::edged_chip_ui;
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::{Message, message};
use crate::session::{RecordRow, RecordsAction, RecordsCommand};
use crate::words::Words;

/// The panel.
pub(super) fn record_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let Some(open) = session.records().open.as_ref() else { return };
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.words.say(&message!("records-page-record").text("number", open.number)));
        view.button(ui, RecordsAction::CloseRecord);
    });
    let row = match &open.row {
        Some(Ok(row)) => row,
        other => {
            match other {
                Some(Err(why)) => problem(ui, view.words.say(why)),
                _ => quiet(ui, view.text("records-page-reading")),
            };
            return;
        }
    };
    ui.horizontal_wrapped(|ui| {
        for action in [RecordsAction::MeasureAgain, RecordsAction::CorrectRecord, RecordsAction::CopyRecords] {
            view.button(ui, action);
        }
    });
    column_ui(ui, "records-open", |ui| {
        if let Some(form) = session.records().correcting.as_ref() {
            correction_ui(ui, view, form);
        }
        verdict_ui(ui, view.words, row);
        links_ui(ui, view, row);
        reports_ui(ui, view);
        for line in lines(view, row, open.by.as_deref()) {
            line_ui(ui, &line);
        }
    });
}

/// The verdict, and that it is simulated or stands no longer.
fn verdict_ui(ui: &mut Ui, words: &Words, row: &RecordRow) {
    let cells = RecordCells::of(words, row);
    ui.horizontal_wrapped(|ui| {
        if let Some(status) = cells.verdict.filter(|_| cells.is_check) {
            let word = if cells.edge == Edge::Line { words.get("status-accepted") } else { words.told(&status) };
            edged_chip_ui(ui, (status, cells.edge), &word);
        } else {
            ui.label(&cells.status);
        }
        if !cells.measured.is_empty() {
            let value = format!("{} mm", cells.measured);
            ui.label(RichText::new(value).font(theme::bold(sizes().figure)));
        }
        if !cells.deviation.is_empty() {
            ui.label(&cells.deviation);
        }
    });
    if cells.edge == Edge::Dashes {
        ui.label(RichText::new(words.get("records-page-simulated")).font(theme::bold(sizes().body)));
    }
}

/// What it corrects and what corrects it, each to be opened.
fn links_ui(ui: &mut Ui, view: &mut View<'_>, row: &RecordRow) {
    let entry = row.entry.as_ref().ok();
    let corrects = entry.and_then(|entry| entry.corrects()).map(|correction| correction.target.number);
    let alarm = entry.and_then(|entry| entry.alarm());
    let answers = alarm.and_then(|alarm| alarm.answer.as_ref()).map(|answer| answer.target.number);
    let (by, answered_by) = if alarm.is_some() { (None, row.corrected_by) } else { (row.corrected_by, None) };
    for (id, number) in [
        ("records-page-corrected-by", by),
        ("records-page-corrects", corrects),
        ("records-page-alarm-answered", answered_by),
        ("records-page-alarm-answers", answers),
        ("records-page-alarm-first", alarm.map(|alarm| alarm.first)),
        ("records-page-alarm-last", alarm.map(|alarm| alarm.last)),
    ] {
        let Some(number) = number else { continue };
        let text = view.words.say(&Message::new(id).text("number", number));
        if ui.button(text).clicked() {
            view.send(RecordsCommand::Open(number));
        }
    }
}

/// The reports that show it, each to be opened.
fn reports_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(open) = view.session.records().open.as_ref() else { return };
    let rows = match &open.reports {
        Ok(rows) => rows,
        Err(why) => {
            problem(ui, view.words.say(&message!("records-page-reports-unread").message("why", why.clone())));
            return;
        }
    };
    for row in rows {
        let number = row.head.number;
        let Some(report) = row.entry.as_ref().ok().and_then(|entry| entry.report()) else { continue };
        let said = message!("records-page-in-report").text("number", number).text("name", &report.name);
        if ui.button(view.words.say(&said)).clicked() {
            view.send(RecordsCommand::Open(number));
        }
    }
}

/// A name and what it says, in one line or below each other.
fn line_ui(ui: &mut Ui, line: &Line) {
    match line {
        Line::Named(name, text) => {
            let all = ui.available_width();
            let width = space(30.0).min(all * 0.35);
            ui.horizontal_top(|ui| {
                ui.spacing_mut().interact_size.y = 0.0;
                ui.spacing_mut().item_spacing = vec2(space(2.0), 0.0);
                let of_name = vec2(width, 0.0);
                ui.allocate_ui_with_layout(of_name, Layout::top_down(Align::Min), |ui| {
                    ui.set_min_width(width);
                    quiet(ui, name);
                });
                ui.allocate_ui_with_layout(vec2(all - width - space(2.0), 0.0), Layout::top_down(Align::Min), |ui| {
                    ui.add(Label::new(text).wrap());
                });
            });
        }
        Line::Heading(text) => {
            ui.add_space(space(1.0));
            heading(ui, text);
        }
        Line::Sentence(text) => _ = ui.add(Label::new(text).wrap()),
    }
}
