//! Left: the wanted clearance or fit, the measured parts with everything about them that has to be said, the groups.

use eframe::egui::{RichText, ScrollArea, Ui, vec2};

use crate::exchange::ImportError;
use crate::gui::class_chooser::feature_picture;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::{self, sizes, space};
use crate::gui::view::{View, heading, list_height, problem, quiet, quiet_cut, quiet_height};
use crate::message::{Located, Message, Say as _, message};
use crate::report::pairing::{Note, PairingParts, PartsFrom};
use crate::session::{PairingAction, PairingField};
use crate::tolerance::Feature;

/// How many refused rows, and how many notes, stand in the column; more of them open with a button.
const MOST_AT_ONCE: usize = 4;

/// All of the column.
pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    wanted_ui(ui, view);
    for feature in [Feature::Hole, Feature::Shaft] {
        ui.separator();
        parts_ui(ui, view, feature);
    }
    ui.separator();
    groups_ui(ui, view);
}

/// The wanted clearances or the fit, and what was understood.
fn wanted_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("pairing-page-wanted"));
    let width = ui.available_width();
    field_ui(ui, view, PairingField::Wanted, name.id, FieldStyle::large(width));
    // The hint is the longest of them: what stands below stays where it is.
    let hint = view.text("pairing-page-wanted-hint");
    let height = quiet_height(ui, &hint, width);
    ui.vertical(|ui| {
        ui.set_min_height(height);
        error_ui(ui, view, PairingField::Wanted);
        if let Some(understood) = view.session.pairing().understood() {
            quiet(ui, view.words.say(&understood));
        } else if view.session.error(PairingField::Wanted).is_none() {
            quiet(ui, hint);
        }
    });
}

/// Into how many groups the parts are sorted.
fn groups_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let name = heading(ui, view.text("pairing-page-groups"));
        field_ui(ui, view, PairingField::Groups, name.id, FieldStyle::number(space(16.0)));
    });
    error_ui(ui, view, PairingField::Groups);
    if let Some(error) = view.session.pairing().group_error() {
        problem(ui, view.words.say(&error));
    }
    quiet(ui, view.text("pairing-page-groups-hint"));
}

const fn title_id(feature: Feature) -> &'static str {
    match feature {
        Feature::Hole => "pairing-page-holes",
        Feature::Shaft => "pairing-page-shafts",
    }
}

/// Holes or shafts: where they come from, and how others are taken.
fn parts_ui(ui: &mut Ui, view: &mut View<'_>, feature: Feature) {
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        feature_picture(ui, feature, space(6.0));
        heading(ui, view.text(title_id(feature)));
    });
    let page = view.session.pairing();
    // However many lines it is, the button below that brought it stays the same one and keeps the focus.
    ui.scope(|ui| {
        match page.parts(feature) {
            Some(parts) => read_ui(ui, view, parts, feature),
            None => _ = quiet(ui, view.text("pairing-page-no-parts")),
        }
        if page.is_reading(feature) {
            quiet(ui, view.text("pairing-page-reading"));
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        view.field_button(ui, PairingAction::OpenParts(feature));
        view.field_button(ui, PairingAction::HistoryParts(feature));
    });
}

/// How many parts there are, and what has to be said about them.
fn read_ui(ui: &mut Ui, view: &View<'_>, parts: &PairingParts, feature: Feature) {
    let from = match &parts.from {
        PartsFrom::File(name) => message!("pairing-page-from-file").text("name", name),
        PartsFrom::Checks => message!("pairing-page-from-history"),
    };
    let line = view.words.say(&from.count("count", parts.sizes.len()));
    ui.label(RichText::new(line).font(theme::bold(sizes().body)));
    for note in parts.notes.iter().take(MOST_AT_ONCE) {
        problem(ui, note_text(view, note));
    }
    more_ui(ui, view, "pairing-page-all-notes", parts.notes.len(), |ui, at| {
        parts.notes.get(at).map(|note| quiet_cut(ui, note_text(view, note)));
    });
    let paired = view.session.pairing().paired.as_deref();
    let [hole, shaft] = paired.map_or([None, None], |paired| paired.answer.outside.each_ref().map(Option::as_ref));
    if let Some(outside) = if feature == Feature::Hole { hole } else { shaft } {
        problem(ui, view.words.told(outside));
    }
    if parts.errors.is_empty() {
        return;
    }
    problem(ui, view.words.say(&message!("pairing-page-refused").count("count", parts.errors.len())));
    for error in parts.errors.iter().take(MOST_AT_ONCE) {
        quiet(ui, error_text(view, error));
    }
    more_ui(ui, view, "pairing-page-all-refused", parts.errors.len(), |ui, at| {
        parts.errors.get(at).map(|error| quiet_cut(ui, error_text(view, error)));
    });
}

/// A button that opens the whole list, where the column has only its beginning. Only the lines in sight are drawn.
fn more_ui(ui: &mut Ui, view: &View<'_>, id: &'static str, count: usize, line_ui: impl Fn(&mut Ui, usize)) {
    if count <= MOST_AT_ONCE {
        return;
    }
    ui.menu_button(view.words.say(&Message::new(id).count("count", count)), |ui| {
        ui.set_width(space(120.0).min(ui.ctx().content_rect().width() - space(10.0)));
        let area = ScrollArea::vertical().id_salt(id).max_height(list_height(ui));
        area.show_rows(ui, sizes().small + 4.0, count, |ui, lines| lines.for_each(|line| line_ui(ui, line)));
    });
}

fn note_text(view: &View<'_>, note: &Note) -> String {
    match note.line {
        Some(line) => view.words.told(&Located::in_line(line, note.what.clone())),
        None => view.words.say(&note.what),
    }
}

fn error_text(view: &View<'_>, error: &Located<ImportError>) -> String {
    view.words.say(&error.message())
}

/// What is still missing, in the order in which it can be done.
pub(super) fn missing_ui(ui: &mut Ui, view: &View<'_>) {
    let page = view.session.pairing();
    heading(ui, view.text("pairing-page-pairs"));
    if page.is_pairing() {
        quiet(ui, view.text("pairing-page-at-work"));
        return;
    }
    ui.add_space(space(1.0));
    let steps = [
        (page.understood().is_some(), "pairing-page-do-wanted"),
        (page.parts(Feature::Hole).is_some(), "pairing-page-do-holes"),
        (page.parts(Feature::Shaft).is_some(), "pairing-page-do-shafts"),
    ];
    for (is_done, id) in steps {
        let text = view.text(id);
        let shown = if is_done { format!("✓ {text}") } else { format!("→ {text}") };
        if is_done {
            quiet(ui, shown);
        } else {
            ui.label(shown);
        }
    }
    ui.add_space(space(1.0));
    let width = ui.available_width().min(space(130.0));
    ui.allocate_ui(vec2(width, 0.0), |ui| quiet(ui, view.text("pairing-page-about")));
}
