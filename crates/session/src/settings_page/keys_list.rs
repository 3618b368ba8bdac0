//! Every key of the window by the place where it is heard: made from the table of actions, so that none is missing.

use fitcheck_core::words::Words;

use super::searching::choice;
use crate::action::{Action, ActionScope, Shortcut};

/// The keys of one place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeysOfPlace {
    /// The id of the name of the place.
    pub place: &'static str,
    pub rows: Vec<KeyRow>,
}

/// What some keys do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyRow {
    pub name: String,
    /// The keys: several where they are steps of one kind.
    pub shortcuts: Vec<Shortcut>,
}

/// All of them, in the order of the actions.
pub(super) fn keys_by_place(words: &Words) -> Vec<KeysOfPlace> {
    let mut places: Vec<KeysOfPlace> = Vec::new();
    for action in Action::all() {
        let shortcuts: Vec<Shortcut> = action.shortcuts().collect();
        if shortcuts.is_empty() {
            continue;
        }
        let place = place_id(action.place());
        let name = choice(action, words);
        match places.iter_mut().find(|known| known.place == place) {
            Some(known) => add(&mut known.rows, name, shortcuts),
            None => places.push(KeysOfPlace { place, rows: vec![KeyRow { name, shortcuts }] }),
        }
    }
    places
}

/// Steps share a name, and so a row.
fn add(rows: &mut Vec<KeyRow>, name: String, shortcuts: Vec<Shortcut>) {
    match rows.iter_mut().find(|row| row.name == name) {
        Some(row) => row.shortcuts.extend(shortcuts),
        None => rows.push(KeyRow { name, shortcuts }),
    }
}

const fn place_id(place: ActionScope) -> &'static str {
    match place {
        ActionScope::Everywhere => "settings-page-everywhere",
        ActionScope::Workpiece => "settings-page-on-workpiece",
        ActionScope::Page(page) => page.name(),
        ActionScope::Part(part) => part.page.name(),
        ActionScope::Dialog => "settings-page-in-dialog",
    }
}
