//! The conditions under which actions are possible, and what switches are set to.

use fitcheck_core::tolerance::iso286::{Edition, JsHalves, Options};
use fitcheck_core::tolerance::{Deviations, ToleranceClass};

use crate::columns::{NoticeColumns, OpenColumns};
use crate::files::Dialog;
use crate::program::Run;
use crate::{Lot, Session, tables};

pub(super) fn is_after_first(session: &Session) -> bool {
    0 < session.cycles().step()
}

pub(super) fn is_before_last(session: &Session) -> bool {
    session.cycles().step() < session.cycles().last()
}

pub(super) fn is_after_worst(session: &Session) -> bool {
    session.check().lot().and_then(Lot::shown).is_some_and(|(place, _)| 1 < place)
}

pub(super) fn is_before_best(session: &Session) -> bool {
    session.check().lot().is_some_and(|lot| lot.shown().is_some_and(|(place, _)| place < lot.judged()))
}

pub(super) fn rounds_js(options: Options) -> bool {
    options.js == JsHalves::Rounded
}

pub(super) fn is_of_1988(options: Options) -> bool {
    options.edition == Edition::Of1988
}

/// The file dialog, while it waits neither for a file nor for an answer.
pub(super) fn free_dialog(session: &Session) -> Option<&Dialog> {
    session.dialog().filter(|dialog| !dialog.is_waiting())
}

/// The file whose columns are shown, where no file dialog lies over it.
pub(super) fn shows_columns(session: &Session) -> Option<&OpenColumns> {
    session.open_columns().filter(|_| session.dialog().is_none())
}

/// What the notice that is shown tells of the columns of its file.
pub(super) fn told_columns(session: &Session) -> Option<&NoticeColumns> {
    session.notices().first()?.columns.as_ref()
}

pub(super) fn asks_to_replace(session: &Session) -> bool {
    session.dialog().is_some_and(|dialog| dialog.exists.is_some())
}

/// Whether the notice that is shown is about a file that was written.
pub(super) fn tells_of_file(session: &Session) -> bool {
    session.dialog().is_none() && session.notices().first().is_some_and(|notice| notice.file.is_some())
}

pub(super) fn has_history(session: &Session) -> bool {
    !session.history().is_empty()
}

/// Whether there are checks to export, and they are what is listed.
pub(super) fn can_export(session: &Session) -> bool {
    !session.lists_rows() && 0 < session.history().exported_count()
}

pub(super) fn has_listed(session: &Session) -> bool {
    0 < session.history().listed().count()
}

pub(super) fn has_rows(session: &Session) -> bool {
    session.check().shows_rows() && session.check().rows().is_some_and(|rows| 0 < rows.listed())
}

pub(super) fn has_bad(session: &Session) -> bool {
    0 < session.bad_count()
}

/// Whether the keys are at a row of the list.
pub(super) fn has_cursor(session: &Session) -> bool {
    session.history().look().1.is_some()
}

pub(super) fn has_status(session: &Session) -> bool {
    session.check().status_text().is_some()
}

pub(super) fn has_table(session: &Session) -> bool {
    session.tables().shown().is_some()
}

pub(super) fn differs(session: &Session) -> bool {
    session.tables().shown().is_some_and(|document| 0 < document.differing())
}

pub(super) type Selected<'a> = (&'a tables::Document, (ToleranceClass, usize));

pub(super) fn selected(session: &Session) -> Option<Selected<'_>> {
    let document = session.tables().shown()?;
    Some((document, document.selected()?))
}

pub(super) fn has_cell(session: &Session) -> bool {
    selected(session).is_some()
}

/// What is in the selected cell.
pub(super) fn cell(session: &Session) -> Option<Deviations> {
    let (document, (class, range)) = selected(session)?;
    document.cell(class, range)
}

/// Whether one more block can be run: the run, if there is one, waits.
pub(super) fn can_step(session: &Session) -> bool {
    let program = session.program();
    !program.is_running() && !program.run().is_some_and(Run::is_over)
}
