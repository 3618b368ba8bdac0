//! Keys: the one place that listens to them, according to the table of actions.
//!
//! A widget handles keys of its own itself (Enter in a field, Space on a list).

use eframe::egui::{self, Event, EventFilter, Id, KeyboardShortcut, Modifiers, Ui};

use super::view::View;
use crate::session::action::{Held, Keeps, Key, Part, Shortcut};
use crate::session::{CheckAction, PartsAction};

/// Does what was pressed in this frame, before anything is drawn: a key that an action takes reaches no widget.
pub(super) fn keys_ui(ui: &Ui, view: &mut View<'_>) {
    let part = focused_part(ui, view);
    let is_press = |event: &Event| pressed_key(event).is_some();
    if !ui.input(|input| input.events.iter().any(is_press)) {
        return;
    }
    let keys = view.session.keys(part, ui.ctx().text_edit_focused());
    let mut pressed = Vec::new();
    ui.input_mut(|input| {
        input.events.retain(|event| {
            let Some((key, modifiers)) = pressed_key(event) else { return true };
            let is_it =
                |shortcut: &Shortcut| modifiers.matches_exact(held(shortcut.held)) && key == of_window(shortcut.key);
            let Some((shortcut, action)) = keys.iter().find(|(shortcut, _)| is_it(shortcut)) else { return true };
            // A key that is held answers no question.
            if !(*action == PartsAction::NextPart.into() && is_repeated(event)) {
                pressed.push(*action);
            }
            // An open list closes with the same Escape.
            shortcut.key == Key::Escape
        });
    });
    // The Escape that closes a list ends no run.
    let closes_list = egui::Popup::is_any_open(ui.ctx());
    for action in pressed.into_iter().filter(|action| !(closes_list && *action == CheckAction::CancelRows.into())) {
        view.act(action);
    }
}

/// The key that an event presses. The system turns Ctrl+C into an event of its own.
const fn pressed_key(event: &Event) -> Option<(egui::Key, Modifiers)> {
    match event {
        Event::Key { key, modifiers, pressed: true, .. } => Some((*key, *modifiers)),
        Event::Copy => Some((egui::Key::C, Modifiers::COMMAND)),
        _ => None,
    }
}

/// Whether a key is held, and this frame is one of its repetitions.
pub(super) fn is_held(ui: &Ui) -> bool {
    ui.input(|input| input.events.iter().any(is_repeated))
}

/// Whether an event is one of a key that is held.
const fn is_repeated(event: &Event) -> bool {
    matches!(event, Event::Key { repeat: true, .. })
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

/// The id with which a part takes the focus.
pub(super) fn part_id(part: Part) -> Id {
    Id::unique(part.name)
}

/// Keys as the system writes them.
pub(super) fn told(ui: &Ui, shortcut: Shortcut) -> String {
    if ui.ctx().os().is_mac() {
        ui.ctx().format_shortcut(&KeyboardShortcut::new(held(shortcut.held), of_window(shortcut.key)))
    } else {
        shortcut.to_string()
    }
}

const fn held(held: Held) -> Modifiers {
    match held {
        Held::Nothing => Modifiers::NONE,
        Held::Shift => Modifiers::SHIFT,
        Held::Ctrl => Modifiers::COMMAND,
        Held::CtrlShift => Modifiers::COMMAND.plus(Modifiers::SHIFT),
        Held::Alt => Modifiers::ALT,
    }
}

fn of_window(key: Key) -> egui::Key {
    let named = |name: String| egui::Key::from_name(&name).unwrap_or(egui::Key::F35);
    match key {
        Key::Character(_) | Key::Function(_) => named(key.to_string()),
        Key::Left => egui::Key::ArrowLeft,
        Key::Right => egui::Key::ArrowRight,
        Key::Up => egui::Key::ArrowUp,
        Key::Down => egui::Key::ArrowDown,
        Key::PageUp => egui::Key::PageUp,
        Key::PageDown => egui::Key::PageDown,
        Key::Home => egui::Key::Home,
        Key::End => egui::Key::End,
        Key::Enter => egui::Key::Enter,
        Key::Escape => egui::Key::Escape,
        Key::Delete => egui::Key::Delete,
        Key::Space => egui::Key::Space,
    }
}
