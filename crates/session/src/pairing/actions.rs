//! What can be done on the pairing page.

use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;
use fitcheck_exchange::report::pairing::FORMATS as PAIR_FORMATS;

use super::PairingCommand;
use crate::Session;
use crate::action::row::{ActionRow, Actions, actions, keys, on, within};
use crate::action::{Held, Key, Part, Shortcut};
use crate::command::Command;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::step::Step;

/// The list of pairs.
pub const PAIRS: Part = Part::list(Page::Pairing, "pairs-list");

actions! {
    /// What can be done on the pairing page.
    PairingAction

    /// Reads measured holes or shafts.
    OpenParts(Feature): [Feature::Hole, Feature::Shaft];
    /// Takes the holes or the shafts of the history.
    HistoryParts(Feature): [Feature::Hole, Feature::Shaft];
    /// Writes the pairs in a format of their list, by its number there.
    SavePairs(usize): 0..PAIR_FORMATS.len();
    /// Goes to another pair.
    MovePair(Step): Step::BLOCKS;
    /// Puts all pairs on the clipboard.
    CopyPairs;
}

impl Actions for PairingAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::OpenParts(feature) => {
                let open = Command::OpenDialog(Purpose::OpenParts(feature));
                match feature {
                    Feature::Hole => on(Page::Pairing, "pairing-page-open-holes", open).key(Shortcut::ctrl('O')),
                    Feature::Shaft => on(Page::Pairing, "pairing-page-open-shafts", open)
                        .key(Shortcut { held: Held::CtrlShift, key: Key::Character('O') }),
                }
            }
            Self::HistoryParts(feature) => {
                let text = match feature {
                    Feature::Hole => "pairing-page-history-holes",
                    Feature::Shaft => "pairing-page-history-shafts",
                };
                on(Page::Pairing, text, PairingCommand::TakeHistory(feature))
                    .hint("pairing-page-history-hint")
                    .when(|session| !session.history().is_empty())
            }
            Self::SavePairs(number) => {
                let row = on(Page::Pairing, "pairing-page-save-csv", Command::OpenDialog(Purpose::SavePairs(number)))
                    .when(|session| session.pairing().paired.is_some());
                if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
            }
            Self::MovePair(step) => {
                within(PAIRS, "pairing-page-move", PairingCommand::Move(step)).when(has_pairs).key(keys(step))
            }
            Self::CopyPairs => {
                within(PAIRS, "pairing-page-copy", PairingCommand::Copy).key(Shortcut::ctrl('C')).when(has_pairs)
            }
        }
    }

    fn name(&self, _session: &Session, words: &Words) -> Option<String> {
        match *self {
            Self::SavePairs(number) => {
                Some(words.get(&format!("pairing-page-save-{}", PAIR_FORMATS.get(number)?.name)))
            }
            _ => None,
        }
    }
}

fn has_pairs(session: &Session) -> bool {
    session.pairing().paired.as_deref().is_some_and(|paired| 0 < paired.count())
}
