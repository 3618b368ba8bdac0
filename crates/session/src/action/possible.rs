//! The conditions under which actions are possible, and what switches are set to.

use fitcheck_core::tolerance::iso286::{Edition, JsHalves, Options};

use crate::Session;
use crate::columns::{NoticeColumns, OpenColumns};
use crate::files::Dialog;
use crate::rows::Rows;

pub(crate) fn rounds_js(options: Options) -> bool {
    options.js == JsHalves::Rounded
}

pub(crate) fn is_of_1988(options: Options) -> bool {
    options.edition == Edition::Of1988
}

/// The file dialog, while it waits neither for a file nor for an answer.
pub(crate) fn free_dialog(session: &Session) -> Option<&Dialog> {
    session.dialog().filter(|dialog| !dialog.is_waiting())
}

/// The file whose columns are shown, where no file dialog lies over it.
pub(crate) fn shows_columns(session: &Session) -> Option<&OpenColumns> {
    session.open_columns().filter(|_| session.dialog().is_none())
}

/// What the notice that is shown tells of the columns of its file.
pub(crate) fn told_columns(session: &Session) -> Option<&NoticeColumns> {
    session.notice()?.columns.as_ref()
}

pub(crate) fn asks_to_replace(session: &Session) -> bool {
    session.dialog().is_some_and(|dialog| dialog.exists.is_some())
}

/// Whether the notice that is shown is about a file that was written.
pub(crate) fn tells_of_file(session: &Session) -> bool {
    session.dialog().is_none() && session.notice().is_some_and(|notice| notice.file.is_some())
}

pub(crate) fn has_history(session: &Session) -> bool {
    !session.history().is_empty()
}

/// Whether there is something to export: the rows that are listed in the place of the history, or checks.
pub(crate) fn can_export(session: &Session) -> bool {
    if session.lists_rows() { can_export_rows(session) } else { 0 < session.history().exported_count() }
}

/// Whether the listed rows of a large file can be written.
pub(crate) fn can_export_rows(session: &Session) -> bool {
    session.lists_rows() && session.check().rows.as_ref().is_some_and(Rows::can_be_written)
}

pub(crate) fn has_bad(session: &Session) -> bool {
    0 < session.bad_count()
}

pub(crate) fn has_status(session: &Session) -> bool {
    session.status_to_export().is_some()
}
