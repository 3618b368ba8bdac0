//! Keys of the window and keys of actions: which is which, and how a user reads them.

use eframe::egui::{self, Event, Id, KeyboardShortcut, Modifiers, Ui};

use crate::session::action::{Held, Key, Part, Shortcut};

/// The key that an event presses. The system turns Ctrl+C into an event of its own.
pub(super) const fn pressed_key(event: &Event) -> Option<(egui::Key, Modifiers)> {
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
pub(super) const fn is_repeated(event: &Event) -> bool {
    matches!(event, Event::Key { repeat: true, .. })
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

pub(super) const fn held(held: Held) -> Modifiers {
    match held {
        Held::Nothing => Modifiers::NONE,
        Held::Shift => Modifiers::SHIFT,
        Held::Ctrl => Modifiers::COMMAND,
        Held::CtrlShift => Modifiers::COMMAND.plus(Modifiers::SHIFT),
        Held::Alt => Modifiers::ALT,
    }
}

pub(super) fn of_window(key: Key) -> egui::Key {
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
