//! Right: how the file was understood, for somebody to confirm; then whether the gauge is good enough, and for which tolerances.

use eframe::egui::{Label, RichText, Ui, vec2};

use crate::gui::card::plain_ui;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::session::StatisticsAction;
use crate::session::statistics::Study;
use crate::text::sentence;

/// What a line of the card is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Line {
    Name,
    Large,
    Plain,
    Wrong,
}

/// The card and its buttons; it is no verdict on a part, so it does not have the colour of one.
pub(super) fn answer_card_ui(ui: &mut Ui, view: &mut View<'_>) {
    let lines = lines(view);
    plain_ui(ui, "study", false, |ui| {
        for (line, text) in &lines {
            line_ui(ui, *line, text);
        }
        lines.into_iter().map(|(_, text)| text).collect()
    });
    let study = &view.session.statistics().study;
    if study.file().is_none() {
        return;
    }
    let size = vec2(ui.available_width(), control(ui));
    ui.add_space(space(1.0));
    ui.vertical_centered(|ui| {
        if study.is_doubted() {
            view.sized_button(ui, StatisticsAction::EvaluateStudy, size);
            view.main_button(ui, StatisticsAction::EvaluateAllTheSame, size);
        } else if study.evaluated().is_some() {
            view.sized_button(ui, StatisticsAction::EvaluateStudy, size);
        } else {
            view.main_button(ui, StatisticsAction::EvaluateStudy, size);
        }
    });
}

fn line_ui(ui: &mut Ui, line: Line, text: &str) {
    let palette = palette(ui.ctx());
    match line {
        Line::Name => _ = quiet(ui, text),
        Line::Large => {
            let text = RichText::new(text).font(theme::bold(sizes().heading)).color(palette.text.0);
            ui.add(Label::new(text).wrap());
        }
        Line::Plain => _ = ui.add(Label::new(text).wrap()),
        Line::Wrong => _ = ui.add(Label::new(RichText::new(text).color(palette.error.0)).wrap()),
    }
}

/// What stands in the card, and is said: the answer where there is one, else the layout and what is wrong with it.
fn lines(view: &View<'_>) -> Vec<(Line, String)> {
    let study = &view.session.statistics().study;
    let [answers, _] = study.advice(view.words);
    if study.evaluated().is_some() {
        let name = (Line::Name, view.text("statistics-study-answer"));
        let large = answers.into_iter().map(|answer| (Line::Large, answer));
        return [name].into_iter().chain(large).chain(layout(study, view)).collect();
    }
    let name = (Line::Name, view.text("statistics-study-understood"));
    let state = if study.is_working() { "statistics-study-working" } else { "statistics-study-confirm" };
    let why = study.found().and_then(Result::err).map(|why| (Line::Wrong, sentence(&view.words.say(why))));
    let by_figures = study.doubt_of_figures(view.words).map(|doubt| (Line::Wrong, doubt));
    match &study.read {
        None => vec![(Line::Plain, view.text("statistics-study-answer"))],
        Some(Err(why)) => vec![name, (Line::Wrong, sentence(&view.words.say(why)))],
        Some(Ok(_)) => [name]
            .into_iter()
            .chain(layout(study, view))
            .chain(by_figures)
            .chain(why)
            .chain([(Line::Plain, view.text(state))])
            .collect(),
    }
}

/// The layout, and what is wrong with it.
fn layout(study: &Study, view: &View<'_>) -> Vec<(Line, String)> {
    let Some(Ok(read)) = &study.read else { return Vec::new() };
    let kind = StatisticsAction::KindOfStudy(study.kind).text(view.session, view.words);
    let line = if study.evaluated().is_some() { Line::Plain } else { Line::Large };
    let said = (line, format!("{kind}: {}", read.layout_text(view.words)));
    let wrong = read.faults(view.words).into_iter().chain(read.doubts(view.words));
    [said].into_iter().chain(wrong.map(|text| (Line::Wrong, text))).collect()
}

/// Below: what becomes of it, and everything else that is to be said.
pub(super) fn advice_ui(ui: &mut Ui, view: &mut View<'_>) {
    if view.session.statistics().study.evaluated().is_none() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        if view.session.statistics().study.has_budget() {
            view.field_button(ui, StatisticsAction::SaveStudyBudget);
        }
        view.field_button(ui, StatisticsAction::CopyStatistics);
    });
    let [_, rest] = view.session.statistics().study.advice(view.words);
    if rest.is_empty() {
        return;
    }
    heading(ui, view.text("statistics-page-advice"));
    for said in rest {
        ui.add(Label::new(RichText::new(said).size(sizes().small)).wrap());
    }
}
