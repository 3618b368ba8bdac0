//! What is recorded with the next checks, and what has become of the shown one.

use eframe::egui::{Label, RichText, TextStyle, Ui};

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::section::Section;
use crate::gui::spoken::gap_ui;
use crate::gui::theme::{self, Icon, palette, sizes};
use crate::gui::view::{View, problem, quiet, quiet_cut};
use crate::message::message;
use crate::session::{CheckField, Keeping, Recorded, WindowAction};

/// Left: serial number and remark, and whether checks are recorded.
pub(super) fn record_ui(ui: &mut Ui, view: &mut View<'_>) {
    let value = view.session.text(CheckField::Serial).trim().to_owned();
    let is_wrong = [CheckField::Serial, CheckField::Remark].iter().any(|field| view.session.error(*field).is_some());
    let section = Section { icon: Icon::NotePencil, name: "records-page-fold", value, is_wrong };
    section.show(ui, view, |ui, view| {
        let width = ui.available_width();
        for (field, name) in [(CheckField::Serial, "records-page-serial"), (CheckField::Remark, "records-page-remark")]
        {
            let name = ui.label(view.text(name));
            let look = FieldStyle::text(width);
            field_ui(ui, view, field, name.id, look);
            error_ui(ui, view, field);
        }
        quiet(ui, view.text("records-page-fold-hint"));
        keeping_ui(ui, view);
    });
}

/// Whether checks are recorded.
fn keeping_ui(ui: &mut Ui, view: &View<'_>) {
    match &view.session.recording().keeping {
        Keeping::Nowhere => _ = quiet(ui, view.text("records-page-nowhere")),
        Keeping::Off => _ = quiet(ui, view.text("records-page-off")),
        Keeping::Opening => _ = quiet(ui, view.text("records-page-opening")),
        Keeping::Open => {}
        Keeping::Failed(why) => {
            _ = problem(ui, view.words.say(&message!("records-page-not-opened").message("why", why.clone())));
        }
    }
}

/// Below the verdict: the number of the record once it is on disk, or that it is not. The line is there in any case, so that
/// nothing moves when the number comes.
pub(in crate::gui) fn recorded_ui(ui: &mut Ui, view: &mut View<'_>, recorded: Option<Recorded<'_>>) {
    if !view.session.recording().is_on() {
        return;
    }
    match recorded {
        None => gap_ui(ui, &TextStyle::Small),
        Some(Recorded::Waiting) => _ = quiet_cut(ui, view.text("records-page-waiting")),
        Some(Recorded::Kept(number)) => {
            _ = quiet_cut(ui, view.words.say(&message!("records-page-record").text("number", number)));
        }
        Some(Recorded::Failed(why)) => {
            let said = view.words.say(&message!("records-page-not-recorded").message("why", why.clone()));
            let text = RichText::new(said).font(theme::bold(sizes().body)).color(palette(ui.ctx()).error.0);
            ui.add(Label::new(text).wrap());
            if view.session.can(WindowAction::RecordAgain) {
                view.field_button(ui, WindowAction::RecordAgain);
            }
        }
    }
}
