//! One size: its callout and limits at the left, the verdict at the right.

use eframe::egui::{Align, Event, Layout, Popup, RichText, Ui, vec2};

use super::asked::{Main, asked_ui};
use super::below::{self, Below};
use super::verdict::big_card_ui;
use super::{gap, sides_ui};
use crate::gui::check::{asks_ui, check_card};
use crate::gui::field::{self, FieldStyle, error_ui, named_field_ui};
use crate::gui::keypad;
use crate::gui::limits::feature_id;
use crate::gui::theme::{self, Icon, control, sizes, space};
use crate::gui::verdict_card::{Card, status_id};
use crate::gui::view::{View, quiet};
use crate::message::Message;
use crate::session::{CheckCommand, CheckField, Command, Field};
use crate::tolerance::{Feature, Limits};

/// What a gauge types while no field has the focus goes into the field of the value, or first into that of the callout.
fn catch_typing(ui: &Ui, view: &View<'_>) {
    let is_text = |event: &Event| matches!(event, Event::Text(text) if !text.trim().is_empty());
    let is_covered = view.session.dialog().is_some() || Popup::is_any_open(ui.ctx());
    if is_covered || ui.ctx().text_edit_focused() || !ui.input(|input| input.events.iter().any(is_text)) {
        return;
    }
    let has_callout = view.session.check().asked.limits.is_some();
    let field = if has_callout { CheckField::Measured } else { CheckField::Callout };
    field::go_to(ui.ctx(), view.session, field.into());
    // The next sign does not replace this one.
    keypad::keep_selection(ui.ctx(), field::id(field));
}

pub(super) fn check_ui(ui: &mut Ui, view: &mut View<'_>) {
    catch_typing(ui, view);
    sides_ui(ui, view, left_ui, right_ui);
}

fn left_ui(ui: &mut Ui, view: &mut View<'_>) {
    let callout = Field::Check(CheckField::Callout);
    let value = Field::Check(CheckField::Measured);
    let aimed = keypad::aimed(ui).filter(|field| *field == callout).unwrap_or(value);
    let session = view.session;
    let goes_to_value = aimed == callout && session.text(value).is_empty();
    let (text, icon) = match (session.rests(), goes_to_value) {
        (true, _) => ("operator-next", Icon::ArrowRight),
        (false, true) => ("operator-to-value", Icon::ArrowRight),
        (false, false) => ("judge", Icon::Check),
    };
    let main = Main { text: view.text(text), icon, is_possible: true };
    if asked_ui(ui, view, (Some(value), "measured-value"), &main, size_ui) {
        if session.rests() {
            view.send(Command::GoOn);
        } else {
            view.send(Command::Enter(aimed));
            keypad::entered(ui, view, aimed);
        }
    }
}

/// The callout, whether it is a hole or a shaft, and the limits.
fn size_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let feature = view.session.check().asked.limits.as_ref().map(|limits| view.text(feature_id(limits.feature)));
        let beside = if feature.is_some() { space(22.0) } else { 0.0 };
        let width = ui.available_width() - beside;
        let hint = RichText::new(view.text("callout"));
        let look = FieldStyle { width, hint, ..FieldStyle::callout(ui) };
        named_field_ui(ui, view, CheckField::Callout, &view.text("callout"), look);
        if let Some(feature) = feature {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.label(RichText::new(feature).font(theme::font(sizes().limits)));
            });
        }
    });
    // What is still being typed is not wrong yet.
    if !ui.memory(|memory| memory.has_focus(field::id(CheckField::Callout))) {
        error_ui(ui, view, CheckField::Callout);
    }
    let limits = view.session.check().asked.limits.as_ref();
    // Above the keypad there is room for one of the two; the limit band shows the limits, too.
    let is_open = view.session.check().is_open();
    if let Some(limits) = limits.filter(|_| !is_open || !view.session.has_keypad()) {
        limits_ui(ui, view, limits);
    }
    let is_asked = limits.is_none() && view.session.check().asked.callout.is_some();
    if is_asked || is_open {
        quiet(ui, view.text("operator-hole-or-shaft"));
        ui.horizontal(|ui| {
            for feature in [Feature::Hole, Feature::Shaft] {
                let button = eframe::egui::Button::new(view.text(feature_id(Some(feature))))
                    .min_size(vec2(space(24.0), control(ui)));
                if ui.push_id(feature, |ui| ui.add(button)).inner.clicked() {
                    view.send(CheckCommand::ChooseFeature(Some(feature)));
                }
            }
        });
    }
}

/// Both limits, to be read from afar.
pub(super) fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    ui.scope(|ui| {
        // Rows of text are no higher than it.
        ui.spacing_mut().interact_size.y = 0.0;
        for (id, size) in [("maximum", limits.maximum()), ("minimum", limits.minimum())] {
            ui.horizontal(|ui| {
                ui.label(RichText::new(view.text(id)).font(theme::font(sizes().limits)));
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    ui.label(RichText::new(view.words.mm(size, 3)).font(theme::bold(sizes().figure)));
                });
            });
        }
    });
}

fn right_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let shown = session.check().shown.as_ref().map(|shown| &shown.record);
    below::actions_ui(ui, view, shown.map(std::convert::AsRef::as_ref), &[]);
    let height = below::verdict_height(ui);
    if asks_ui(ui, view) {
        return;
    }
    let card = shown.map_or_else(|| waiting(view), |record| check_card(view.words, record, true));
    big_card_ui(ui, view, &card, height);
    ui.add_space(f32::from(gap(ui)) - ui.spacing().item_spacing.y);
    let limits = session.check().asked.limits.as_ref();
    let record = shown.map(std::convert::AsRef::as_ref);
    below::below_ui(
        ui,
        view,
        &Below { limits, record, recorded: session.check_recorded(), is_part: false, is_round: true },
    );
}

/// What comes next, for who has not typed anything yet.
fn waiting(view: &View<'_>) -> Card {
    let check = view.session.check();
    let why = check.refusal.as_ref().map(|why: &Message| view.words.say(why));
    let step = if check.asked.limits.is_some() { "operator-type-value" } else { "operator-type-callout" };
    Card { word: view.text(status_id(None)), lines: vec![why.unwrap_or_else(|| view.text(step))], ..Card::default() }
}
