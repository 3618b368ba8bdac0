//! Keys in turn: however fast they come, each goes where the focus is after the key before it.
//!
//! A scanner or a gauge types its whole line within one frame. Widgets are drawn once a frame with all of its keys, and what a key changes
//! (focus, page, selection) counts from the next frame on. So a frame is given what is typed into one text field, or one other key;
//! what comes behind that waits. This is the only place that holds input back.

use std::collections::{BTreeSet, VecDeque};

use eframe::egui::{Context, Event, Key, Modifiers, Plugin, RawInput, Ui};

/// Input on its way to the widgets.
#[derive(Debug, Default)]
pub(super) struct InTurn {
    waiting: VecDeque<Event>,
    /// Keys that are down in what was handed on.
    down: BTreeSet<Key>,
    /// Whether a key was handed on whose effect has not been drawn.
    settles: bool,
}

/// What an event is for the order of keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum InputKind {
    /// It moves nothing: the pointer is moved, a key is released or repeated.
    Rest,
    /// A key that types a sign.
    Stroke,
    /// What is typed.
    Text,
    /// Whatever may move the focus: a key, a button of the pointer.
    Move,
    /// Ctrl or Shift is pressed or released, which counts for what follows.
    Held,
}

impl Plugin for InTurn {
    fn debug_name(&self) -> &'static str {
        "keys in turn"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        self.waiting.extend(std::mem::take(&mut input.events));
        input.events = self.take(ctx.text_edit_focused());
    }

    fn on_end_pass(&mut self, ui: &mut Ui) {
        if !self.waiting.is_empty() {
            ui.ctx().request_repaint();
        }
    }
}

/// Events of this frame come again once what was done in it is drawn.
pub(super) fn give_back(ui: &Ui, which: impl Fn(&Event) -> bool) {
    let given = ui.input_mut(|input| input.events.extract_if(.., |event| which(event)).collect::<Vec<_>>());
    ui.ctx().with_plugin(|turns: &mut InTurn| {
        for event in given.into_iter().rev() {
            turns.waiting.push_front(event);
        }
        turns.settles = true;
    });
}

/// Keys wait for the next frame: the focus is on its way to where they belong.
pub(super) fn hold(ctx: &Context) {
    ctx.with_plugin(|turns: &mut InTurn| turns.settles = true);
}

impl InTurn {
    /// What the next frame gets; `is_typing` says whether a text field has the focus.
    fn take(&mut self, is_typing: bool) -> Vec<Event> {
        let mut taken: Vec<Event> = Vec::new();
        // What the key before has changed is drawn first: the field that it leads to may be new.
        if std::mem::take(&mut self.settles) && self.has_keys() {
            return taken;
        }
        let mut has_stroke = false;
        let mut has_text = false;
        while let Some(event) = self.waiting.pop_front() {
            let kind = self.kind(&event);
            // Outside a text field every sign is a key of its own; the text of a key stays with it.
            let is_next = match kind {
                InputKind::Rest | InputKind::Held => false,
                InputKind::Stroke => !is_typing && (has_stroke || has_text),
                InputKind::Text => !is_typing && has_text,
                InputKind::Move => has_stroke || has_text,
            };
            if is_next {
                self.waiting.push_front(event);
                self.settles = !is_typing;
                break;
            }
            has_stroke |= kind == InputKind::Stroke;
            has_text |= kind == InputKind::Text;
            self.note(&event);
            taken.push(event);
            if kind == InputKind::Move && self.has_keys() {
                self.settles = true;
                break;
            }
        }
        taken
    }

    /// Whether keys are waiting.
    fn has_keys(&self) -> bool {
        self.waiting.iter().any(|event| match self.kind(event) {
            InputKind::Stroke | InputKind::Text | InputKind::Held => true,
            InputKind::Move => !matches!(event, Event::PointerButton { .. }),
            InputKind::Rest => false,
        })
    }

    /// Which keys are down.
    fn note(&mut self, event: &Event) {
        match event {
            Event::Key { key, pressed: true, .. } => _ = self.down.insert(*key),
            Event::Key { key, pressed: false, .. } => _ = self.down.remove(key),
            // The system tells of no release that another window has seen.
            Event::WindowFocused(false) => self.down.clear(),
            _ => {}
        }
    }

    fn kind(&self, event: &Event) -> InputKind {
        match event {
            Event::Text(_) | Event::Paste(_) | Event::Ime(_) => InputKind::Text,
            Event::Key { key, pressed: true, modifiers, .. } => {
                // A held arrow runs through a list however slowly it is drawn, and never longer than it is held.
                let is_repeated = self.down.contains(key) && !matches!(key, Key::Tab | Key::Enter | Key::Escape);
                match () {
                    () if is_repeated => InputKind::Rest,
                    () if types(*key, *modifiers) => InputKind::Stroke,
                    () => InputKind::Move,
                }
            }
            Event::Copy | Event::Cut | Event::PointerButton { .. } | Event::AccessKitActionRequest(_) => {
                InputKind::Move
            }
            Event::ModifiersChanged(_) => InputKind::Held,
            _ => InputKind::Rest,
        }
    }
}

/// Whether a key types a sign: all but those that move, delete, or do something.
fn types(key: Key, modifiers: Modifiers) -> bool {
    let is_command = modifiers.ctrl || modifiers.command || modifiers.alt || modifiers.mac_cmd;
    let is_function = (Key::F1..=Key::F35).contains(&key);
    let is_other = matches!(
        key,
        Key::ArrowDown
            | Key::ArrowLeft
            | Key::ArrowRight
            | Key::ArrowUp
            | Key::Escape
            | Key::Tab
            | Key::Backspace
            | Key::Enter
            | Key::Insert
            | Key::Delete
            | Key::Home
            | Key::End
            | Key::PageUp
            | Key::PageDown
            | Key::Copy
            | Key::Cut
            | Key::Paste
            | Key::BrowserBack
    );
    !is_command && !is_function && !is_other
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(key: Key, pressed: bool) -> Event {
        Event::Key { key, physical_key: None, pressed, repeat: false, modifiers: Modifiers::NONE }
    }

    fn text(sign: &str) -> Event {
        Event::Text(sign.to_owned())
    }

    /// The frames that events make.
    fn frames(events: impl IntoIterator<Item = Event>, is_typing: bool) -> Vec<Vec<Event>> {
        let mut turns = InTurn { waiting: events.into_iter().collect(), ..InTurn::default() };
        let mut frames = Vec::new();
        while !turns.waiting.is_empty() {
            frames.push(turns.take(is_typing));
        }
        frames
    }

    #[test]
    fn a_frame_takes_a_text_or_one_key_and_then_shows_it() {
        let [two, tab] = [Key::Num2, Key::Tab].map(|of| [key(of, true), key(of, false)]);
        let typed = [two[0].clone(), text("2"), two[1].clone(), two[0].clone(), text("2"), two[1].clone()];
        let events = typed.iter().chain(&tab).chain(&typed).cloned();
        let behind: Vec<Event> = std::iter::once(tab[1].clone()).chain(typed.clone()).collect();
        assert_eq!(frames(events, true), [typed.to_vec(), vec![tab[0].clone()], Vec::new(), behind]);
    }

    #[test]
    fn outside_a_field_every_sign_is_a_key() {
        let events = [key(Key::A, true), text("a"), key(Key::A, false), text("b"), text("c")];
        let shown = frames(events, false);
        assert_eq!(shown.iter().filter(|frame| frame.iter().any(|event| matches!(event, Event::Text(_)))).count(), 3);
    }

    #[test]
    fn a_key_that_is_held_waits_for_nothing() {
        let down = || key(Key::ArrowDown, true);
        let events = [down(), down(), down(), key(Key::ArrowDown, false)];
        assert_eq!(frames(events, false).len(), 1);
        assert_eq!(frames([key(Key::Tab, true), key(Key::Tab, true)], false).len(), 3, "a Tab is one step each");
    }

    #[test]
    fn shift_counts_for_its_own_key_alone() {
        let shift = |modifiers| Event::ModifiersChanged(modifiers);
        let events = [shift(Modifiers::SHIFT), key(Key::Tab, true), key(Key::Tab, false), shift(Modifiers::NONE)];
        let shown = frames(events.clone(), true);
        assert_eq!(shown[0], events[..2]);
    }

    #[test]
    fn what_moves_no_focus_waits_for_nothing() {
        let events = [key(Key::Enter, true), key(Key::Enter, false), Event::PointerGone];
        assert_eq!(frames(events, true).len(), 1);
    }

    #[test]
    fn only_keys_that_type_a_sign_are_signs() {
        for sign in [Key::A, Key::Num0, Key::Space, Key::Minus, Key::Period, Key::Plus, Key::Slash] {
            assert!(types(sign, Modifiers::NONE) && types(sign, Modifiers::SHIFT), "{sign:?}");
            assert!(!types(sign, Modifiers::COMMAND) && !types(sign, Modifiers::ALT), "{sign:?}");
        }
        for other in [Key::Tab, Key::Enter, Key::F1, Key::F8, Key::F35, Key::Home, Key::Backspace, Key::Delete] {
            assert!(!types(other, Modifiers::NONE), "{other:?}");
        }
    }
}
