//! What the reports page asks for: pages set for the window, templates, pages handed to the system's printer.

use std::io::{self, Write as _};
use std::path::Path;
use std::process::{Command as Process, Stdio};
use std::sync::Arc;

use super::errands::Errands;
use super::{picture, templates};
use crate::message::{Message, message};
use crate::report::pdf::Pages;
use crate::session::{Content, Effect, ReportsCommand};

/// What the reports page asks for, and what comes back.
pub(super) fn answer(effect: Effect, errands: Errands) -> Option<ReportsCommand> {
    match effect {
        Effect::DrawReport { run, content } => Some(ReportsCommand::Drawn { run, result: drawn(&content) }),
        Effect::ReadTemplates(folder) => Some(ReportsCommand::Templates(templates::read(&folder))),
        Effect::NewTemplate { folder, text } => Some(ReportsCommand::TemplateMade(templates::begin(&folder, &text))),
        Effect::Print(content) => Some(ReportsCommand::Printed(print(&content, errands))),
        _ => None,
    }
}

/// The pages of a report as the window shows them.
///
/// # Errors
/// Its checks cannot be read.
fn drawn(content: &Content) -> Result<Arc<Pages>, Message> {
    let Content::Report { report, words, .. } = content else { return Err(message!("reports-page-nothing")) };
    let failed = |error: io::Error| message!("report-error-writer").text("format", "pdf").text("reason", error);
    let mut pages = Pages::of(report, words).map_err(failed)?;
    // A picture that cannot be decoded is told on the page itself.
    pages.dots = pages.pictures.iter().map(|(name, image)| picture::dots_of(name, image).ok()).collect();
    Ok(Arc::new(pages))
}

/// What hands a file to the printer, with what it is given before the file: the printer is the one that the system prints on.
const PRINTERS: &[(&str, &[&str])] = if cfg!(windows) {
    &[(
        "powershell",
        &["-NoProfile", "-NonInteractive", "-Command", "& { Start-Process -FilePath $args[0] -Verb Print -Wait }"],
    )]
} else {
    &[("lp", &[]), ("lpr", &[])]
};

/// Writes the pages beside other files that nobody keeps, and hands them to the printer. Tests print nothing.
///
/// # Errors
/// There is nothing that prints, or what it says.
fn print(content: &Content, errands: Errands) -> Result<(), Message> {
    let failed = |reason: &dyn std::fmt::Display| message!("reports-page-not-printed").text("reason", reason);
    if errands == Errands::AtOnce {
        return Err(failed(&"no program is started at once"));
    }
    let mut file =
        tempfile::Builder::new().prefix("fitcheck").suffix(".pdf").tempfile().map_err(|error| failed(&error))?;
    content.write(&mut file).and_then(|()| file.flush()).map_err(|error| failed(&error))?;
    // Windows lets nobody read what is open for writing.
    print_file(&file.into_temp_path())
}

fn print_file(file: &Path) -> Result<(), Message> {
    let failed = |reason: &dyn std::fmt::Display| message!("reports-page-not-printed").text("reason", reason);
    let names: Vec<&str> = PRINTERS.iter().map(|(name, _)| *name).collect();
    let mut why = message!("reports-page-no-printer").text("programs", names.join(", "));
    for (name, before) in PRINTERS {
        let mut process = Process::new(name);
        process.args(*before).arg(file).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        match process.output() {
            Ok(output) if output.status.success() => return Ok(()),
            Ok(output) => why = failed(&String::from_utf8_lossy(&output.stderr).trim()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => why = failed(&error),
        }
    }
    Err(why)
}
