//! Right: the verdict of the value that came last, and what the values make of the part.

use eframe::egui::{Ui, vec2};

use crate::gui::check::{check_card, recorded_ui};
use crate::gui::theme::{control, space};
use crate::gui::verdict_card::{Card, card_ui, chip_ui, lines_below_ui, status_id};
use crate::gui::view::{View, doubt_text, heading, problem, quiet};
use crate::message::{Message, Say as _};
use crate::report::RENDERINGS;
use crate::session::parts::{Value, Walking};
use crate::session::{Action, Keeping, Recorded};

/// How many missing sizes are named.
const NAMED: usize = 12;

/// The card of the value, or a question about it.
pub(super) fn verdict_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = session.parts().walking();
    if let Some(question) = walking.question() {
        let card = Card {
            word: view.text("word-question"),
            value: Some(format!("{} mm", view.words.mm(question.measured, 3))),
            lines: vec![doubt_text(view.words, question.doubt), view.text("walk-page-question-enter")],
            ..Card::default()
        };
        card_ui(ui, view, &card);
        let size = vec2(ui.available_width(), control(ui));
        if question.doubt.meant().is_some() {
            view.main_button(ui, Action::TakeMeantValue, size);
        }
        let anyway = view.named(Action::TakeValue).min_size(size);
        view.button_as(ui, Action::TakeValue, anyway);
        return;
    }
    card_ui(ui, view, &card(view, walking));
    if let Some((_, value)) = walking.shown().filter(|_| walking.refusal().is_none()) {
        recorded_ui(ui, view, recorded(view, value));
    }
}

fn recorded<'a>(view: &View<'a>, value: &Value) -> Option<Recorded<'a>> {
    let of_check = value.id.and_then(|id| view.session.recording().of_check(id));
    of_check.or(value.number.map(Recorded::Kept))
}

fn card(view: &View<'_>, walking: &Walking) -> Card {
    let none = |lines: Vec<String>| Card { word: view.text(status_id(None)), lines, ..Card::default() };
    if let Some(refusal) = walking.refusal() {
        return none(vec![view.words.say(refusal)]);
    }
    let Some((at, value)) = walking.shown() else { return none(Vec::new()) };
    let card = check_card(view.words, &value.record, walking.is_round(at));
    Card { value: card.value.map(|mm| format!("{}: {mm}", walking.name(at))), ..card }
}

/// By which rule, what a gauge said besides, and the part as a whole.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = session.parts().walking();
    if walking.question().is_none() {
        lines_below_ui(ui, &card(view, walking));
    }
    if let Some((at, value)) = walking.shown() {
        for remark in &value.remarks {
            quiet(ui, view.words.say(remark));
        }
        let count = walking.values(at).len();
        if 1 < count {
            quiet(ui, view.words.say(&Message::new("walk-page-last-counts").count("count", count)));
        }
    }
    if walking.is_begun() {
        ui.add_space(space(1.0));
        standing_ui(ui, view, walking);
    }
    if !session.recording().is_on() {
        let id = if *session.recording().keeping() == Keeping::Off { "walk-page-off" } else { "walk-page-nowhere" };
        quiet(ui, view.text(id));
    }
}

/// What the values make of the part: good is said of a part that is complete alone.
fn standing_ui(ui: &mut Ui, view: &mut View<'_>, walking: &Walking) {
    let standing = walking.standing();
    heading(ui, view.text("walk-page-part-status"));
    match walking.status() {
        Some(status) => _ = chip_ui(ui, status, &view.words.told(&status)),
        None => _ = ui.label(view.text("walk-page-not-complete")),
    }
    ui.label(view.words.say(&standing.message()));
    if 0 < standing.simulated {
        problem(ui, view.words.say(&Message::new("walk-page-simulated").count("count", standing.simulated)));
    }
    ui.menu_button(view.text("walk-page-report"), |ui| {
        for number in 0..RENDERINGS.len() {
            view.menu_item(ui, Action::ReportPart(number));
        }
    });
    if 0 < standing.missing {
        let named: Vec<&str> = walking.open().take(NAMED).collect();
        let more = if named.len() < standing.missing { " …" } else { "" };
        let message = Message::new("walk-page-missing").text("names", format!("{}{more}", named.join(", ")));
        quiet(ui, view.words.say(&message));
    }
}
