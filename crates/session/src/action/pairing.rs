//! The rows of the pairing page in the table of actions.

use fitcheck_core::tolerance::Feature;

use super::row::{Row, on, within};
use super::{Held, Key, Part, Shortcut};
use crate::{Command, Page, PairingCommand, Purpose, Session, Step};

pub(super) fn open(feature: Feature) -> Row {
    let open = Command::OpenDialog(Purpose::OpenParts(feature));
    match feature {
        Feature::Hole => on(Page::Pairing, "pairing-page-open-holes", open).key(Shortcut::ctrl('O')),
        Feature::Shaft => on(Page::Pairing, "pairing-page-open-shafts", open)
            .key(Shortcut { held: Held::CtrlShift, key: Key::Character('O') }),
    }
}

pub(super) fn of_history(feature: Feature) -> Row {
    let text = match feature {
        Feature::Hole => "pairing-page-history-holes",
        Feature::Shaft => "pairing-page-history-shafts",
    };
    on(Page::Pairing, text, PairingCommand::TakeHistory(feature))
        .hint("pairing-page-history-hint")
        .when(|session| !session.history().is_empty())
}

pub(super) fn save(number: usize) -> Row {
    let row = on(Page::Pairing, "pairing-page-save-csv", Command::OpenDialog(Purpose::SavePairs(number)))
        .when(|session| session.pairing().paired().is_some());
    if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
}

pub(super) fn step(step: Step) -> Row {
    within(Part::Pairs, "pairing-page-move", PairingCommand::Move(step)).when(has_pairs)
}

pub(super) fn copy() -> Row {
    within(Part::Pairs, "pairing-page-copy", PairingCommand::Copy).key(Shortcut::ctrl('C')).when(has_pairs)
}

fn has_pairs(session: &Session) -> bool {
    session.pairing().paired().is_some_and(|paired| 0 < paired.count())
}
