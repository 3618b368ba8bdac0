//! Which settings words find: every word stands in the name of the setting, in the line about it, in its section or in its choices.

use fitcheck_core::words::Words;

use super::{Control, SETTINGS, Setting};
use crate::action::Action;

/// The places of the settings that a query finds.
pub(super) fn found(query: &str, words: &Words) -> Vec<usize> {
    let query = query.to_lowercase();
    let wanted: Vec<&str> = query.split_whitespace().collect();
    let has_all = |setting: &Setting| {
        let said = said(setting, words);
        wanted.iter().all(|word| said.contains(word))
    };
    SETTINGS.iter().enumerate().filter(|(_, setting)| has_all(setting)).map(|(place, _)| place).collect()
}

/// Everything that a setting is found by, in small letters.
fn said(setting: &Setting, words: &Words) -> String {
    let ids = [setting.name, setting.about, setting.section.name()];
    let choices = match setting.control {
        Control::OneOf(choices, _) => choices(),
        Control::Switch(action) => vec![action],
        Control::Buttons(_, actions)
        | Control::Field(_, _, actions)
        | Control::Gauge(actions)
        | Control::Port(actions) => actions.to_vec(),
        Control::Zoom | Control::Ruler | Control::Who | Control::Told(_) => Vec::new(),
    };
    let names = choices.into_iter().map(|action| choice(action, words));
    let texts: Vec<String> = ids.into_iter().map(|id| words.get(id)).chain(names).collect();
    texts.join("\n").to_lowercase()
}

/// The name of a choice. None of them depends on the state.
pub(super) fn choice(action: Action, words: &Words) -> String {
    let listed = if let Action::Settings(action) = action { action.listed_name(words) } else { None };
    listed.unwrap_or_else(|| words.get(action.row().text))
}
