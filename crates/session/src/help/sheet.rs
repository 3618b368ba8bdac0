//! The sheet of all keys, made from the table of actions.

use fitcheck_core::words::Words;

use crate::Session;
use crate::action::{Action, ActionScope, Shortcut};
use crate::page::Page;

/// The keys of a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyGroup {
    /// The id of its name.
    pub name: &'static str,
    pub rows: Vec<KeyRow>,
}

/// What keys do. Actions of one name stand in one row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyRow {
    pub keys: Vec<Shortcut>,
    pub text: String,
}

/// The keys of all actions, place by place: everywhere, in dialogs, on each page.
pub fn key_groups(session: &Session, words: &Words) -> Vec<KeyGroup> {
    let mut names = vec!["help-page-everywhere", "help-page-in-dialogs"];
    names.extend(Page::ALL.map(Page::name));
    names.push("help-page-on-workpiece");
    let mut groups: Vec<KeyGroup> = names.into_iter().map(|name| KeyGroup { name, rows: Vec::new() }).collect();
    for action in Action::all() {
        let keys: Vec<Shortcut> = action.shortcuts().collect();
        let name = place(action.place());
        let Some(group) = groups.iter_mut().find(|group| group.name == name).filter(|_| !keys.is_empty()) else {
            continue;
        };
        let text = action.text(session, words);
        match group.rows.iter_mut().find(|row| row.text == text) {
            Some(row) => row.keys.extend(keys),
            None => group.rows.push(KeyRow { keys, text }),
        }
    }
    groups.retain(|group| !group.rows.is_empty());
    groups
}

/// The id of a place's name.
const fn place(scope: ActionScope) -> &'static str {
    match scope {
        ActionScope::Everywhere => "help-page-everywhere",
        ActionScope::Dialog => "help-page-in-dialogs",
        ActionScope::Workpiece => "help-page-on-workpiece",
        ActionScope::Page(page) => page.name(),
        ActionScope::Part(part) => part.page.name(),
    }
}
