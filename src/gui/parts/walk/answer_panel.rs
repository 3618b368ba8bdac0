//! Right: the verdict of the size that is looked at, or of the whole part once nothing is open; and below it the other one of the two.
//!
//! Card, strip and buttons keep their places, whatever the verdict is: lines for which the card has no room go below.

use eframe::egui::{Button, Id, Popup, PopupCloseBehavior, Ui, vec2};

use super::part_panel;
use crate::gui::check::{check_card, recorded_ui, why_ui};
use crate::gui::room::is_tiny;
use crate::gui::shapes::Edge;
use crate::gui::theme::{self, control, sizes, space};
use crate::gui::verdict_card::{
    Card, card_height, card_ui, fitted, lines_below_ui, question_card, status_id, strip_height, strip_ui,
    usual_height_in,
};
use crate::gui::view::{Digits, View, problem, quiet, remembered, steady};
use crate::message::{Message, message};
use crate::report::of_any_paper;
use crate::session::parts::{Headline, Value, Walking};
use crate::session::{Keeping, PartsAction, Question, Recorded};

/// The share of the height that a card keeps at most.
const MOST: f32 = 0.62;

/// The card, or a question about the value; below it a strip, and the number of the record.
pub(super) fn verdict_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = &session.parts().walking;
    let room = room(ui, view);
    if let Some(question) = walking.question.as_ref() {
        return question_ui(ui, view, question, room);
    }
    let most = if is_tiny(ui) { f32::INFINITY } else { room };
    let (card, below) = fitted(headline_card(view, walking), most, |card| card_height(ui, view, card));
    let card = Card { height: room, ..card };
    card_ui(ui, view, &card);
    ui.data_mut(|data| data.insert_temp(below_id(), below));
    // Where there is little room, a part without a verdict gives way.
    if walking.is_begun() && (!is_tiny(ui) || walking.is_done() || walking.status().is_some()) {
        ui.add_space(space(1.0));
        standing_strip_ui(ui, view, walking);
    }
    if walking.is_begun() && session.recording().is_on() {
        let recorded = walking.faced_value().filter(|_| walking.refusal.is_none());
        recorded_ui(ui, view, recorded.and_then(|(_, value)| recorded_of(view, value)));
    }
}

/// The lines for which the card had no room.
fn below_id() -> Id {
    Id::unique("walk-below")
}

/// What is asked about a typed value; as high as card, strip and record together.
pub(in crate::gui) fn question_ui(ui: &mut Ui, view: &mut View<'_>, question: &Question, room: f32) {
    let gap = ui.spacing().item_spacing.y;
    let record = if view.session.recording().is_on() { sizes().small * 1.4 + gap } else { 0.0 };
    let buttons = f32::from(u8::try_from(view.session.answers().len()).unwrap_or(u8::MAX));
    let all = room + space(1.0) + gap + strip_height(ui) + record;
    let height = (all - buttons * (control(ui) + gap)).max(0.0);
    card_ui(ui, view, &question_card(view, question, height));
    ui.data_mut(|data| data.insert_temp(below_id(), Vec::<String>::new()));
    let size = vec2(ui.available_width(), control(ui));
    view.answers_ui(ui, size);
}

pub(in crate::gui) fn recorded_of<'a>(view: &View<'a>, value: &Value) -> Option<Recorded<'a>> {
    let of_check = value.id.and_then(|id| view.session.recording().of_check(id));
    of_check.or(value.number.map(Recorded::Kept))
}

/// The height of a card, whatever is in it: that of the tallest of the usual results.
fn room(ui: &Ui, view: &View<'_>) -> f32 {
    if is_tiny(ui) {
        return 0.0;
    }
    usual_height_in(ui, view, ui.available_width()).min(ui.available_height() * MOST)
}

fn no_card(view: &View<'_>, lines: Vec<String>) -> Card {
    Card { word: view.text(status_id(None)), lines, ..Card::default() }
}

/// The card of what the one look is for.
pub(in crate::gui) fn headline_card(view: &View<'_>, walking: &Walking) -> Card {
    if let Some(refusal) = walking.refusal.as_ref() {
        return no_card(view, vec![view.words.say(refusal)]);
    }
    match walking.headline() {
        Headline::Size(None) => {
            let name = walking.faced().map(|at| walking.name(at).to_owned());
            Card { value: name, ..no_card(view, Vec::new()) }
        }
        Headline::Size(Some((at, value))) => size_card(view, walking, at, value),
        Headline::Part(whole) => {
            let serial = walking.serial();
            let name = Message::new(if serial.is_empty() { "walk-page-whole" } else { "walk-page-whole-serial" });
            Card {
                status: whole.status,
                edge: if whole.is_beyond_limits { Edge::Line } else { Edge::of_simulated(whole.is_simulated) },
                word: match whole.status {
                    None => view.text("walk-page-not-complete"),
                    Some(_) if whole.is_beyond_limits => view.text("status-accepted"),
                    Some(status) => view.words.told(&status),
                },
                value: Some(view.words.say(&name.text("serial", serial))),
                lines: whole.reasons.iter().map(|reason| view.words.say(reason)).collect(),
                ..Card::default()
            }
        }
    }
}

/// The card of a value of a size, which the page names beside it.
pub(in crate::gui) fn value_card(view: &View<'_>, walking: &Walking, at: usize, value: &Value) -> Card {
    check_card(view.words, &value.record, walking.is_round(at))
}

fn size_card(view: &View<'_>, walking: &Walking, at: usize, value: &Value) -> Card {
    let card = value_card(view, walking, at, value);
    Card { value: card.value.map(|mm| format!("{}: {mm}", walking.name(at))), ..card }
}

/// The part while sizes are open; afterwards the size that is looked at.
fn standing_strip_ui(ui: &mut Ui, view: &View<'_>, walking: &Walking) {
    let words = view.words;
    let simulated = |word: String, is_simulated: bool| {
        if is_simulated { words.say(&message!("parts-page-balloon-simulated").text("status", word)) } else { word }
    };
    match (walking.headline(), walking.faced_value()) {
        (Headline::Size(_), _) => {
            let status = walking.status();
            let is_simulated = walking.is_decided_by_simulation();
            let text = status.map_or_else(
                || words.get("walk-page-strip-open"),
                |status| {
                    let word = simulated(words.told(&status), is_simulated);
                    words.say(&message!("walk-page-strip-part").text("status", word))
                },
            );
            strip_ui(ui, status, Edge::of_simulated(is_simulated), &text);
        }
        (Headline::Part(_), Some((at, value))) => {
            let record = &value.record;
            let status = record.verdict.status();
            let is_simulated = record.measurement.origin.is_simulated();
            let mm = Digits::of(record).mm(words, record.measurement.diameter, 3);
            let text = message!("walk-page-strip-size").text("name", walking.name(at)).text("value", mm);
            strip_ui(
                ui,
                Some(status),
                Edge::of(record),
                &words.say(&text.text("status", simulated(words.told(&record.verdict), is_simulated))),
            );
        }
        (Headline::Part(_), None) => _ = ui.allocate_space(vec2(ui.available_width(), strip_height(ui))),
    }
}

/// What can be done with the part; then by which rule, what a gauge said besides, and what is missing.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = &session.parts().walking;
    actions_ui(ui, view, walking);
    let contradicted = walking.contradicted();
    if let Some((at, values)) = &contradicted {
        contradicted_ui(ui, view, walking.name(*at), values);
    }
    if walking.question.is_none() {
        lines_below_ui(ui, &headline_card(view, walking));
    }
    let below: Vec<String> = remembered(ui, below_id());
    for line in &below {
        ui.label(line);
    }
    if let Some((at, value)) = walking.faced_value() {
        if matches!(walking.headline(), Headline::Part(_)) {
            size_lines_ui(ui, &size_card(view, walking, at, value));
        }
        for remark in &value.remarks {
            quiet(ui, view.words.say(remark));
        }
        part_panel::values_ui(ui, view, at, contradicted.is_some());
    }
    if walking.is_begun() {
        part_panel::part_ui(ui, view);
    }
    if !session.recording().is_on() {
        let id = if session.recording().keeping == Keeping::Off { "walk-page-off" } else { "walk-page-nowhere" };
        quiet(ui, view.text(id));
    }
}

/// Values of a size that contradict each other, and what can be done about it besides measuring again.
fn contradicted_ui(ui: &mut Ui, view: &mut View<'_>, name: &str, values: &[&Value]) {
    let words = view.words;
    let said = |value: &&Value| {
        let record = &value.record;
        let mm = Digits::of(record).mm(words, record.measurement.diameter, 3);
        format!("{mm} {}", words.told(&record.verdict))
    };
    let values = values.iter().map(said).collect::<Vec<_>>().join(", ");
    problem(ui, words.say(&message!("walk-page-contradicting").text("name", name).text("values", values)));
    view.field_button(ui, PartsAction::CountNewest);
}

/// The buttons, above everything whose height changes.
fn actions_ui(ui: &mut Ui, view: &mut View<'_>, walking: &Walking) {
    steady(ui, "walk-answer-actions", |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().interact_size.y = control(ui);
            ui.add_enabled_ui(walking.is_begun(), |ui| {
                theme::looking(ui, theme::tonal, |ui| {
                    ui.menu_button(view.text("walk-page-report"), |ui| {
                        for number in of_any_paper() {
                            view.menu_item(ui, PartsAction::ReportPart(number));
                        }
                    });
                });
            });
            if walking.asked().is_some() {
                view.field_button(ui, PartsAction::NextPart);
            }
            view.more_ui(ui, |ui, view| {
                for action in [PartsAction::ImportValuesColumns, PartsAction::WatchFolder] {
                    view.menu_item(ui, action);
                }
            });
            reasons_ui(ui, view, walking);
        });
    });
}

/// The reasons of the verdict of the size that is looked at, over what stands below.
fn reasons_ui(ui: &mut Ui, view: &View<'_>, walking: &Walking) {
    let value = walking.faced_value();
    let button = theme::looking(ui, theme::plain, |ui| {
        let button = Button::new(view.text("why")).min_size(vec2(0.0, control(ui)));
        ui.add_enabled(value.is_some(), button)
    });
    if let Some((_, value)) = value {
        let popup = Popup::from_toggle_button_response(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.width(space(90.0)).show(|ui| why_ui(ui, view, &value.record));
    }
}

/// What is said of a size below the part: what to do, and how far it is from its limits.
fn size_lines_ui(ui: &mut Ui, card: &Card) {
    if let Some((what, rest)) = &card.instruction {
        ui.label(format!("{what} {rest}"));
    }
    for line in &card.lines {
        ui.label(line);
    }
}
