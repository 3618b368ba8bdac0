//! Keys: the one place that listens to them, according to the table of actions.
//!
//! A widget handles keys of its own itself (Enter in a field, Space on a list).

use eframe::egui::{self, Event, EventFilter, Ui};

use super::field;
use super::key_names::{held, is_repeated, of_window, part_id, pressed_key};
use super::view::View;
use crate::session::action::{Keeps, Key, Part, Shortcut};
use crate::session::{CheckField, Field, Page, PartsAction, WalkField};

/// Does what was pressed in this frame, before anything is drawn: a key that an action takes reaches no widget.
pub(super) fn keys_ui(ui: &Ui, view: &mut View<'_>) {
    let part = focused_part(ui, view);
    let is_press = |event: &Event| pressed_key(event).is_some();
    if !ui.input(|input| input.events.iter().any(is_press)) {
        return;
    }
    let keys = view.session.keys(part, types_text(ui, view));
    let has_list = egui::Popup::is_any_open(ui.ctx());
    let mut pressed = Vec::new();
    ui.input_mut(|input| {
        input.events.retain(|event| {
            let Some((key, modifiers)) = pressed_key(event) else { return true };
            let is_it =
                |shortcut: &Shortcut| modifiers.matches_exact(held(shortcut.held)) && key == of_window(shortcut.key);
            let Some((shortcut, action)) = keys.iter().find(|(shortcut, _)| is_it(shortcut)) else { return true };
            let is_escape = shortcut.key == Key::Escape;
            // The Escape that closes a list or a menu does nothing else, and a key that is held answers no question.
            let is_of_list = is_escape && has_list;
            let is_held = *action == PartsAction::NextPart.into() && is_repeated(event);
            if !is_of_list && !is_held {
                pressed.push(*action);
            }
            is_escape
        });
    });
    for action in pressed {
        view.act(action);
    }
}

/// Whether keys belong to a text that is being typed. The field of the value keeps the focus after its verdict: there is nothing in it any
/// more that could be undone, but the check can.
fn types_text(ui: &Ui, view: &View<'_>) -> bool {
    let session = view.session;
    let value: Field = match session.page() {
        Page::Check => CheckField::Measured.into(),
        Page::Parts => WalkField::Value.into(),
        _ => return ui.ctx().text_edit_focused(),
    };
    let is_settled = session.rests() || session.text(value).trim().is_empty();
    ui.ctx().text_edit_focused() && !(is_settled && ui.memory(|memory| memory.has_focus(field::id(value))))
}

/// The part of the page that has the focus as a whole. Arrows stay in it.
fn focused_part(ui: &Ui, view: &View<'_>) -> Option<Part> {
    ui.memory_mut(|memory| {
        let part = Part::of(view.session.page()).find(|part| memory.has_focus(part_id(*part)))?;
        let arrows = EventFilter {
            tab: part.keeps == Keeps::CellsAndTab,
            horizontal_arrows: part.keeps != Keeps::Rows,
            vertical_arrows: true,
            escape: false,
        };
        memory.set_focus_lock_filter(part_id(part), arrows);
        Some(part)
    })
}
