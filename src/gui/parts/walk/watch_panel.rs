//! The watched folder: what came, what waits, what was refused.

use eframe::egui::Ui;

use crate::gui::theme::space;
use crate::gui::verdict_card::chip_ui;
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::message;
use crate::session::parts::TakenFile;
use crate::session::{MaskChoice, PartsAction};

/// How many files are shown.
const MOST: usize = 50;

pub(super) fn watch_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let watched = &session.parts().watched;
    let has_mask = matches!(session.mask(), MaskChoice::Own { .. });
    if watched.folder.is_none() && watched.count == 0 && watched.trouble.is_none() && !has_mask {
        return;
    }
    ui.separator();
    heading(ui, view.text("walk-page-watched"));
    if let Some(folder) = watched.folder.as_deref() {
        ui.label(folder.display().to_string());
        view.field_button(ui, PartsAction::StopWatch);
        if let Some(name) = session.parts().watched_plan() {
            quiet(ui, view.words.say(&message!("walk-page-judged-by-plan").text("name", name)));
        }
        match watched.known {
            Some(known) => quiet(ui, view.words.say(&message!("walk-page-known").count("count", known))),
            None => quiet(ui, view.text("walk-page-watch-begins")),
        };
        if session.parts().watches_other_plan() {
            problem(ui, view.text("walk-page-watch-other-plan"));
        }
        if !watched.comes_back() {
            quiet(ui, view.text("walk-page-watch-not-saved"));
        }
    }
    if let MaskChoice::Own { name, .. } = session.mask() {
        quiet(ui, view.words.say(&message!("walk-page-mask").text("name", name)));
    }
    if let Some(trouble) = watched.trouble.as_ref() {
        problem(ui, view.words.say(trouble));
    }
    if watched.is_recording() {
        quiet(ui, view.text("walk-page-watch-recording"));
    }
    for (name, why) in &watched.waiting {
        let message = message!("walk-page-waiting").text("name", name).message("why", why.clone());
        quiet(ui, view.words.say(&message));
    }
    if 0 < watched.count {
        ui.label(view.words.say(&message!("walk-page-watch-count").count("count", watched.count)));
    }
    for file in watched.files().take(MOST) {
        file_ui(ui, view, file);
    }
}

fn file_ui(ui: &mut Ui, view: &View<'_>, file: &TakenFile) {
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{}  {}", file.time.strftime("%H:%M:%S"), file.name));
        for (status, count) in file.counts.iter().filter(|(_, count)| 0 < *count) {
            let word = view.words.told(status);
            chip_ui(ui, *status, &format!("{count} {word}"));
        }
    });
    for said in &file.said {
        problem(ui, view.words.say(said));
    }
}
