//! Right, above: the answer. One word that can be read from two metres, its shape, and what to do.

use eframe::egui::{Align, Button, Color32, Id, Layout, Popup, PopupCloseBehavior, RichText, Ui, vec2};

use crate::gui::check::record_panel::recorded_ui;
use crate::gui::check::{lists_checks, worth_lines};
use crate::gui::limits::limits_text;
use crate::gui::room::is_tiny;
use crate::gui::shapes::{self, Edge};
use crate::gui::theme::{self, Icon, Weight, control, sizes, space};
use crate::gui::verdict_card::{
    self, Card, card_height_in, card_ui, chip_ui, fitted, foot_height, footed_card_ui, half, lines_below_ui,
    question_card, remove, status_id,
};
use crate::gui::view::{Digits, View, doubt_text, heading, remembered};
use crate::journal::Record;
use crate::length::Length;
use crate::message::{Message, Say, message};
use crate::session::help::Sample;
use crate::session::{Action, CheckAction, DoubtedText, Lot, Question, Recorded, Step, WindowAction};
use crate::tolerance::{Feature, Source};
use crate::verdict::{PositionVerdict, Status};
use crate::words::Words;

/// The height that the answer needs in a width: more than usual where there is much to say.
pub(super) fn height_in(ui: &Ui, view: &View<'_>, width: f32) -> f32 {
    let check = view.session.check();
    let asked = check.question.as_ref().map(|question| question_card(view, question, 0.0));
    if let Some(asked) = check.doubted().map(|doubted| doubted_card(view, doubted)).or(asked) {
        let answers = (control(ui) + ui.spacing().item_spacing.y) * 2.0 + space(1.0);
        return card_height_in(ui, view, &asked, width) + answers;
    }
    let shown = check.shown.as_ref();
    let card = shown.map_or_else(|| no_card(view), |shown| card(view.words, &shown.record, true));
    let example = if view.session.welcomes() { control(ui) + ui.spacing().item_spacing.y } else { 0.0 };
    card_height_in(ui, view, &card, width) + shown.map_or(example, |_| foot_height(ui))
}

/// The height of the usual answers in a width.
pub(super) fn usual_height_in(ui: &Ui, view: &View<'_>, width: f32) -> f32 {
    verdict_card::usual_height_in(ui, view, width) + foot_height(ui)
}

/// The lines for which the card had no room.
fn below_id() -> Id {
    Id::unique("check-below")
}

/// The verdict card over a height; or a question instead.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>, height: f32) {
    answer_within_ui(ui, view, height, f32::INFINITY);
}

/// The same, no higher than the room: lines that have no place in it stand below.
pub(super) fn answer_within_ui(ui: &mut Ui, view: &mut View<'_>, height: f32, most: f32) {
    if asks_ui(ui, view) {
        return;
    }
    let record = view.session.check().shown.as_ref().map(|shown| shown.record.as_ref());
    let card = record.map_or_else(|| no_card(view), |record| card(view.words, record, true));
    let recorded = view.session.check_recorded();
    // What was not recorded is said below the card, where its colour is no verdict's.
    let has_failed = matches!(recorded, Some(Recorded::Failed(_)));
    let welcomes = record.is_none() && view.session.welcomes();
    let below = match (has_failed, welcomes) {
        (true, _) => control(ui) * 2.0,
        (_, true) => control(ui) + ui.spacing().item_spacing.y,
        _ => 0.0,
    };
    let (card, left) = card_within(ui, view, card, most - below);
    ui.data_mut(|data| data.insert_temp(below_id(), left));
    let card = Card { height: height - below, ..card };
    let shown = view.session.check().shown.as_ref().and_then(|shown| shown.id);
    let replaced = shown.and_then(|id| view.session.history().replaced_by(id));
    let said = match (recorded, replaced) {
        (Some(Recorded::Kept(number)), Some(by)) => {
            view.words.say(&message!("records-page-void").text("number", number).text("by", by))
        }
        (Some(Recorded::Kept(number)), None) => view.words.say(&message!("records-page-record").text("number", number)),
        (Some(Recorded::Waiting), _) => view.text("records-page-waiting"),
        _ => String::new(),
    };
    let mut pressed = None;
    match record {
        Some(record) => {
            let mut foot = |ui: &mut Ui, colour: Color32| pressed = foot_ui(ui, view, (record, &said), colour);
            footed_card_ui(ui, view, &card, Some(&mut foot));
        }
        None => card_ui(ui, view, &card),
    }
    if let Some(action) = pressed {
        view.act(action);
    }
    if has_failed {
        recorded_ui(ui, view, recorded);
    } else if welcomes {
        let sample = WindowAction::OpenSample(Sample::Value);
        view.sized_button(ui, sample, vec2(ui.available_width(), control(ui)));
    }
}

/// A card of which no line is cut: first it is set closer, then its last lines stand below it.
fn card_within(ui: &Ui, view: &View<'_>, card: Card, most: f32) -> (Card, Vec<String>) {
    let foot = if card.status.is_some() { foot_height(ui) } else { 0.0 };
    let height = |card: &Card| card_height_in(ui, view, card, ui.available_width()) + foot;
    let is_close = most < height(&card) && !is_tiny(ui);
    fitted(Card { is_close, ..card }, if is_close { most } else { f32::INFINITY }, height)
}

/// The number of the record, the reasons, which open over what stands below, and the correction where the list of checks does not offer
/// it. Returns what was chosen.
fn foot_ui(ui: &mut Ui, view: &View<'_>, (record, said): (&Record, &str), colour: Color32) -> Option<CheckAction> {
    ui.label(RichText::new(said).font(theme::font(sizes().small)).color(colour));
    let foot = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let text = RichText::new(view.text("why")).font(theme::bold(sizes().body)).color(colour);
        let button = ui.add(Button::new(text).frame(false).min_size(vec2(0.0, control(ui))));
        let button = shapes::ringed(ui, button, colour);
        let popup = Popup::from_toggle_button_response(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.width(space(90.0)).show(|ui| why_ui(ui, view, record));
        let offers = !lists_checks(ui) && view.session.can(CheckAction::CorrectCheck);
        (offers && correct_ui(ui, view, colour)).then_some(CheckAction::CorrectCheck)
    });
    foot.inner
}

/// The button that corrects the record, in the colour of the card: its icon alone where there is no room for its name.
fn correct_ui(ui: &mut Ui, view: &View<'_>, colour: Color32) -> bool {
    let action = Action::from(CheckAction::CorrectCheck);
    let name = action.text(view.session, view.words);
    let icon = Icon::PencilSimple.text(Weight::Regular, space(4.5)).color(colour);
    let text = RichText::new(&name).font(theme::font(sizes().body)).color(colour);
    let width = ui.painter().layout_no_wrap(name.clone(), theme::font(sizes().body), colour).size().x;
    let has_room = width + space(4.5 + 2.0) + ui.spacing().icon_spacing < ui.available_width();
    let button = if has_room { Button::new((icon, text)) } else { Button::new(icon) };
    let side = control(ui);
    let shown = ui.add(button.frame(false).min_size(vec2(side, side))).accessible_name(name);
    let shown = shapes::ringed(ui, shown, colour);
    let hint = action.hint().map_or_else(String::new, |id| view.text(id));
    shown.on_hover_text(hint).clicked()
}

/// What comes after what, for who has not typed anything yet.
const STEPS: [&str; 3] = ["first-step-callout", "first-step-value", "first-step-verdict"];

/// The card without a record: where a measurement was refused, that nothing was measured, and why.
fn no_card(view: &View<'_>) -> Card {
    let refused = |why: &Message| vec![view.text("nothing-measured"), view.words.say(why)];
    let row = view.session.check().rows.as_ref().and_then(|rows| rows.shown.as_ref()?.why.as_ref());
    let of_row = || row.map(|why| view.words.say(why)).into_iter().collect();
    let lines: Vec<String> = view.session.check().refusal.as_ref().map_or_else(of_row, refused);
    if lines.is_empty() && view.session.check().asked.limits.is_none() {
        // Nothing is asked yet: what comes after what.
        return Card {
            word: view.text(status_id(None)),
            lines: STEPS.map(|id| view.text(id)).to_vec(),
            ..Card::default()
        };
    }
    let lines = match &view.session.check().asked.limits {
        Some(limits) if lines.is_empty() => vec![limits_text(view.words, limits)],
        _ => lines,
    };
    Card { word: view.text(status_id(None)), lines, ..Card::default() }
}

/// What has no room in the card of a low window.
pub(super) fn rest_of_card_ui(ui: &mut Ui, view: &View<'_>) {
    for line in remembered::<Vec<String>>(ui, below_id()) {
        ui.label(line);
    }
    if let Some(shown) = view.session.check().shown.as_ref() {
        lines_below_ui(ui, &card(view.words, &shown.record, true));
    } else if view.session.check().question.is_none() {
        lines_below_ui(ui, &no_card(view));
    }
}

/// What is asked about a text or a value before anything is judged; whether anything is.
pub(in crate::gui) fn asks_ui(ui: &mut Ui, view: &mut View<'_>) -> bool {
    if let Some(doubted) = view.session.check().doubted() {
        doubted_ui(ui, view, doubted);
    } else if let Some(question) = view.session.check().question.as_ref() {
        question_ui(ui, view, question);
    } else {
        return false;
    }
    true
}

/// What is asked about a typed value before it is judged.
fn question_ui(ui: &mut Ui, view: &mut View<'_>, question: &Question) {
    card_ui(ui, view, &question_card(view, question, 0.0));
    ui.add_space(space(1.0));
    let size = vec2(ui.available_width(), control(ui));
    view.answers_ui(ui, size);
}

/// The card of what is asked about a text before anything is judged by it.
fn doubted_card(view: &View<'_>, doubted: &DoubtedText) -> Card {
    let enter = if doubted.meant.is_some() { "doubted-enter" } else { "doubted-type" };
    Card {
        word: view.text("word-question"),
        value: Some(view.words.number(&doubted.text)),
        lines: vec![view.words.say(&doubted.why), view.text(enter)],
        ..Card::default()
    }
}

/// What is asked about a text before anything is judged by it.
fn doubted_ui(ui: &mut Ui, view: &mut View<'_>, doubted: &DoubtedText) {
    card_ui(ui, view, &doubted_card(view, doubted));
    ui.add_space(space(1.0));
    let size = vec2(ui.available_width(), control(ui));
    if doubted.meant.is_some() {
        view.main_button(ui, CheckAction::TakeText, size);
    }
    if doubted.can_stay {
        view.sized_button(ui, CheckAction::KeepText, size);
    }
}

/// How many rows of an imported file are what, and which of them is shown.
pub(super) fn lot_ui(ui: &mut Ui, view: &mut View<'_>, lot: &Lot) {
    let words = view.words;
    let said = |id: &'static str, count: usize| words.say(&Message::new(id).count("count", count));
    heading(ui, words.say(&message!("lot-title").text("name", &lot.name).count("rows", lot.rows)));
    ui.horizontal_wrapped(|ui| {
        for (status, count) in lot.counts() {
            // A zero of what seldom comes would only raise questions.
            if !status.is_rare() || 0 < count {
                let word = words.told(&status);
                let text = message!("lot-count").text("status", word).count("count", count);
                chip_ui(ui, status, &words.say(&text));
            }
        }
    });
    for (id, count) in [("lot-unjudged", lot.unjudged), ("lot-refused", lot.refused), ("lot-doubted", lot.doubted)] {
        if 0 < count {
            ui.label(said(id, count));
        }
    }
    let open = view.session.check().open_of_lot(view.session.history()).len();
    if 0 < open {
        ui.label(said("lot-open", open));
        ui.horizontal_wrapped(|ui| {
            for feature in [Feature::Hole, Feature::Shaft] {
                view.field_button(ui, CheckAction::JudgeAllAs(feature));
            }
        });
    }
    let Some((place, line)) = lot.shown() else { return };
    let part = view.session.check().shown.as_ref().map(|shown| &shown.record.id).filter(|part| !part.is_empty());
    let shown = match part {
        Some(part) => message!("lot-shown-part").text("part", part),
        None => message!("lot-shown"),
    };
    ui.label(words.say(&shown.count("place", place).count("judged", lot.judged()).count("line", line)));
    ui.horizontal_wrapped(|ui| {
        for step in Step::PATH {
            view.field_button(ui, CheckAction::ShowInLot(step));
        }
    });
    ui.add_space(space(1.0));
}

/// How far the value of a record is from the minimum and from the maximum.
pub(in crate::gui) fn distances(words: &Words, record: &Record) -> [String; 2] {
    let size = &record.verdict.size;
    let digits = Digits::of(record);
    let distances = [
        (("above-minimum", "below-minimum"), size.above_minimum),
        (("below-maximum", "above-maximum"), size.below_maximum),
    ];
    distances.map(|(id, distance)| {
        let id = if distance < Length::ZERO { id.1 } else { id.0 };
        words.say(&Message::new(id).text("um", digits.um(words, distance.abs())))
    })
}

/// The card of a record (of a diameter where it `is_round`): the word, the value, what to remove, the distances, the position.
pub(in crate::gui) fn card(words: &Words, record: &Record, is_round: bool) -> Card {
    let size = &record.verdict.size;
    let digits = Digits::of(record);
    let status = record.verdict.status();
    let mut lines = Vec::new();
    let um = |length: Length| digits.um(words, length);
    // A centre out of position cannot be machined back, whatever the size says.
    let removal = size.removal.filter(|_| status == size.status);
    if let Some(removal) = removal {
        lines.push(words.say(&message!("remove-to-middle").text("um", um(removal.to_middle))));
    } else if matches!(size.status, Status::Scrap | Status::OutOfLimits) {
        // How far it is from the other limit says nothing.
        let [to_minimum, to_maximum] = distances(words, record);
        lines.push(if size.above_minimum < Length::ZERO { to_minimum } else { to_maximum });
    } else {
        lines.extend(distances(words, record));
    }
    if let Some(position) = record.verdict.position.filter(PositionVerdict::is_monitored) {
        lines.push(words.get(if position.is_out() { "position-out" } else { "position-in" }));
    }
    if status != size.status {
        let id = status_id(Some(size.status));
        lines.push(words.say(&message!("diameter-alone").text("status", words.get(id))));
    }
    lines.extend(worth_lines::lines(words, record));
    lines.extend(record.doubt.map(|doubt| doubt_text(words, doubt)));
    if matches!(record.limits.source, Source::WithoutOwn { .. }) {
        lines.push(words.get("judged-without-own"));
    }
    Card {
        status: Some(status),
        edge: Edge::of(record),
        word: words.told(&record.verdict),
        value: Some(format!("{} mm", digits.mm(words, record.measurement.diameter, 3))),
        instruction: removal
            .map(|removal| {
                let per_side = is_round.then(|| half(words, digits, removal.to_limit));
                remove(words, &um(removal.to_limit), per_side)
            })
            .or_else(|| worth_lines::advice(words, record)),
        lines,
        ..Card::default()
    }
}

/// Why a record has its verdict: limits, measurement, rule, and what the measurement cannot tell.
pub(in crate::gui) fn why_ui(ui: &mut Ui, view: &View<'_>, record: &Record) {
    let words = view.words;
    let said = |id: &'static str, what: &dyn Say| words.say(&Message::new(id).message("what", what.message()));
    ui.label(said("why-limits", &record.limits.source));
    ui.label(said("why-measured", &record.measurement.origin));
    ui.label(said("why-rule", &record.verdict.rule));
    for reason in worth_lines::reasons(view, record) {
        ui.label(reason);
    }
    for caveat in record.caveats() {
        ui.label(said("why-caveat", &caveat));
    }
}
