//! A part, feature by feature: what is asked at the left, the verdict and the picture at the right.

use eframe::egui::{Align, Button, Label, Layout, RichText, ScrollArea, Sense, Stroke, Ui, vec2};

use super::asked::{Main, asked_ui};
use super::below::{self, Below};
use super::check::limits_ui;
use super::sides_ui;
use super::verdict::big_card_ui;
use crate::gui::field::{FieldStyle, error_ui, named_field_ui};
use crate::gui::parts::{asked_text, catch_typing, headline_card, recorded_of, skip_ui, value_card, value_question_ui};
use crate::gui::theme::{self, Icon, control, palette, sizes, space};
use crate::gui::verdict_card::{Card, status_id};
use crate::gui::view::{View, heading, problem, quiet};
use crate::gui::{keypad, shapes};
use crate::message::message;
use crate::part::Size;
use crate::session::parts::{Headline, Walking};
use crate::session::{Action, Command, Field, FilesCommand, PartsAction, Purpose, WalkField};

pub(super) fn part_ui(ui: &mut Ui, view: &mut View<'_>) {
    catch_typing(ui, view);
    sides_ui(ui, view, left_ui, right_ui);
}

const VALUE: Field = Field::Parts(crate::session::PartsField::Walk(WalkField::Value));

fn left_ui(ui: &mut Ui, view: &mut View<'_>) {
    let walking = &view.session.parts().walking;
    if walking.is_skipping && walking.asked().is_some() {
        crate::gui::card::page_card_ui(ui, |ui| skip_ui(ui, view));
        return;
    }
    if !walking.is_begun() {
        return begin_ui(ui, view);
    }
    let is_over = walking.is_done() && !view.session.rests();
    let (text, icon) = if is_over {
        ("operator-next-part", Icon::ArrowRight)
    } else if view.session.rests() {
        ("operator-next", Icon::ArrowRight)
    } else {
        ("judge", Icon::Check)
    };
    let main = Main { text: view.text(text), icon, is_possible: true };
    let field = walking.at.map(|_| VALUE);
    if asked_ui(ui, view, (field, "walk-page-value"), &main, size_ui) {
        match (is_over, walking.at) {
            (true, _) => view.act(PartsAction::NextPart),
            (false, _) if view.session.rests() => view.send(Command::GoOn),
            (false, _) => {
                view.send(Command::Enter(VALUE));
                keypad::entered(ui, view, VALUE);
            }
        }
    }
}

/// Which plan and which serial number.
fn begin_ui(ui: &mut Ui, view: &mut View<'_>) {
    let main = Main {
        text: PartsAction::BeginPart.text(view.session, view.words),
        icon: Icon::ArrowRight,
        is_possible: view.session.can(PartsAction::BeginPart),
    };
    let is_pressed = asked_ui(ui, view, (None, ""), &main, |ui, view| {
        let document = &view.session.parts().document;
        if let Some(plan) = document.plan() {
            let part = &plan.head.part;
            heading(ui, if part.is_empty() { document.name() } else { part.clone() });
            quiet(ui, view.text("walk-page-serial"));
            let width = ui.available_width();
            named_field_ui(ui, view, WalkField::Serial, &view.text("walk-page-serial"), FieldStyle::large(width));
            error_ui(ui, view, WalkField::Serial);
        }
        plans_ui(ui, view);
    });
    if is_pressed {
        view.act(PartsAction::BeginPart);
    }
}

/// The plans that were opened last.
fn plans_ui(ui: &mut Ui, view: &mut View<'_>) {
    let plans: Vec<_> = view.session.recent_of(Purpose::OpenPlan).collect();
    if plans.is_empty() {
        quiet(ui, view.text("operator-no-plans"));
        return;
    }
    quiet(ui, view.text("operator-plans"));
    let open = view.session.parts().document.path();
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        for (number, path) in plans {
            let name = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
            let text = RichText::new(&name).font(theme::bold(sizes().limits));
            let button =
                Button::new(text).selected(open == Some(path)).min_size(vec2(ui.available_width(), control(ui)));
            if ui.add(button).clicked() {
                view.send(FilesCommand::OpenRecent(number));
            }
        }
    });
}

/// The feature that the page is about: number, name and callout, its limits, and which one is next.
fn size_ui(ui: &mut Ui, view: &mut View<'_>) {
    let walking = &view.session.parts().walking;
    let Some(size) = walking.faced_size() else {
        heading(ui, view.text("walk-page-done"));
        return;
    };
    let at = walking.faced().map_or(0, |at| at);
    head_ui(ui, view, &size, (at, walking.count()));
    limits_ui(ui, view, size.limits);
    if !size.feature.remark.is_empty() {
        ui.label(&size.feature.remark);
    }
    if walking.is_warned {
        let missing = walking.standing().missing;
        problem(ui, view.words.say(&message!("walk-page-next-warned").count("count", missing)));
    }
    next_ui(ui, view, walking);
}

fn head_ui(ui: &mut Ui, view: &View<'_>, size: &Size<'_>, (at, count): (usize, usize)) {
    let palette = palette(ui.ctx());
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space(2.0);
        let (rect, _) = ui.allocate_exact_size(vec2(space(11.0), space(11.0)), Sense::hover());
        shapes::outline(
            ui.painter(),
            rect.center(),
            space(5.0),
            None,
            (palette.surface.0, Stroke::new(2.0, palette.text.0)),
        );
        let number = if size.feature.number.is_empty() { (at + 1).to_string() } else { size.feature.number.clone() };
        let label: String = number.chars().take(4).collect();
        ui.painter().text(
            rect.center(),
            eframe::egui::Align2::CENTER_CENTER,
            label,
            theme::bold(sizes().limits),
            palette.text.0,
        );
        let asked = asked_text(view.words, size);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(RichText::new(asked).font(theme::bold(sizes().figure)));
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                ui.add(Label::new(RichText::new(size.name()).font(theme::bold(sizes().limits))).truncate());
                let of = message!("walk-page-of").count("at", at + 1).count("count", count);
                ui.add(Label::new(crate::gui::view::quiet_text(ui, view.words.say(&of))).truncate());
            });
        });
    });
}

/// What comes after it, where that is known and there is room.
fn next_ui(ui: &mut Ui, view: &View<'_>, walking: &Walking) {
    let faced = walking.faced();
    let next = if walking.at == faced { walking.at.and_then(|at| walking.walk.next(at + 1)) } else { walking.at };
    let next = next.filter(|at| Some(*at) != faced);
    if ui.available_height() < sizes().limits * 1.5 {
        return;
    }
    let said = next.and_then(|at| {
        walking.with_row(at, |row| {
            let number = &row.size.feature.number;
            let name = if number.is_empty() { row.size.name() } else { format!("{number} {}", row.size.name()) };
            message!("walk-page-next-size").text("name", name).text("asked", asked_text(view.words, row.size))
        })
    });
    if let Some(said) = said {
        ui.separator();
        ui.add(Label::new(crate::gui::view::quiet_text(ui, view.words.say(&said)).size(sizes().body)).truncate());
    }
}

fn right_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = &session.parts().walking;
    let value = walking.faced_value();
    let record = value.map(|(_, value)| value.record.as_ref());
    let is_over = walking.is_done() && !session.rests();
    let actions: &[(Action, Icon)] = if is_over {
        &[(Action::Parts(PartsAction::ReportPart(0)), Icon::FileText)]
    } else if walking.is_begun() {
        &[
            (Action::Parts(PartsAction::SizeAgain), Icon::ArrowCounterClockwise),
            (Action::Parts(PartsAction::SkipSize), Icon::SkipForward),
        ]
    } else {
        &[]
    };
    below::actions_ui(ui, view, record, actions);
    let height = below::verdict_height(ui);
    if let Some(question) = walking.question.as_ref() {
        return value_question_ui(ui, view, question, height);
    }
    let headline = walking.headline();
    let card = match value.filter(|_| session.rests() || matches!(headline, Headline::Size(Some(_)))) {
        Some((at, value)) => value_card(view, walking, at, value),
        None if matches!(headline, Headline::Part(_)) => headline_card(view, walking),
        None => waiting(view, walking),
    };
    big_card_ui(ui, view, &card, height);
    let limits = walking.faced_size().map(|size| size.limits.clone());
    let limits = record.map(|record| record.limits.clone()).or(limits).filter(|_| !is_over);
    let recorded = value.and_then(|(_, value)| recorded_of(view, value));
    let is_round = value.is_some_and(|(at, _)| walking.is_round(at));
    let is_part = walking.is_begun();
    below::below_ui(ui, view, &Below { limits: limits.as_ref(), record, recorded, is_part, is_round });
}

fn waiting(view: &View<'_>, walking: &Walking) -> Card {
    let refusal = walking.refusal.as_ref().map(|why| view.words.say(why));
    let step = if walking.is_begun() { "operator-type-value" } else { "operator-choose-part" };
    Card {
        word: view.text(status_id(None)),
        lines: vec![refusal.unwrap_or_else(|| view.text(step))],
        ..Card::default()
    }
}
