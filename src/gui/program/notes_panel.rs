//! Below the listing: errors, warnings and remarks, whole; a click shows the block.

use eframe::egui::{Button, Color32, FontId, RichText, ScrollArea, Ui};

use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, marked_ui, quiet};
use crate::message::message;
use crate::session::ProgramCommand;
use crate::session::program::{Note, NoteKind, Run};
use crate::verdict::Status;

/// How many lines are visible without scrolling, and how many of them have room in any case.
const LINES: f32 = 4.0;
const LEAST_LINES: f32 = 3.0;

/// Up to this many notes take as many lines as they need. Of more, each takes one, and the one about the selected block
/// is shown whole above them.
const MOST_WHOLE: usize = 100;

/// The least height of the notes beside the path.
pub(super) fn least(ui: &Ui) -> f32 {
    control(ui) * (LEAST_LINES + 1.0) + space(4.0)
}

/// The height that the notes need where they are on their own; `None` where there are none.
pub(super) fn height(ui: &Ui, view: &View<'_>) -> Option<f32> {
    let program = view.session.program();
    let count = program.note_count();
    // The border of the panel, the mark and the scroll bar take their part.
    let width = ui.available_width() - space(15.0);
    let notes = (0..count.min(MOST_WHOLE)).filter_map(|number| program.note(number));
    let lines: f32 = notes.map(|note| note_height(ui, view, &note, width).max(control(ui))).sum();
    (0 < count).then(|| lines.clamp(control(ui) * LEAST_LINES, control(ui) * LINES) + control(ui) + space(4.0))
}

fn note_height(ui: &Ui, view: &View<'_>, note: &Note, width: f32) -> f32 {
    ui.painter().layout(view.words.say(&note.message), font(note), Color32::PLACEHOLDER, width).size().y
}

fn font(note: &Note) -> FontId {
    if note.kind == NoteKind::Error { theme::bold(sizes().small) } else { theme::font(sizes().small) }
}

/// The notes in the room that is left.
pub(super) fn notes_ui(ui: &mut Ui, view: &mut View<'_>) {
    let program = view.session.program();
    let count = program.note_count();
    ui.spacing_mut().item_spacing.y = 0.0;
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.words.say(&message!("program-page-problems").count("count", count)));
        let unlisted = program.run.as_ref().map_or(0, Run::unlisted_remarks);
        if 0 < unlisted {
            quiet(ui, view.words.say(&message!("program-page-unlisted").count("count", unlisted)));
        }
    });
    // Of another program they begin at the first one.
    let area = ScrollArea::vertical()
        .id_salt(("problems", program.opened_count()))
        .auto_shrink(false)
        .min_scrolled_height(0.0);
    if count <= MOST_WHOLE {
        area.show(ui, |ui| {
            ui.set_max_width(ui.available_width() - space(2.5));
            (0..count).filter_map(|number| program.note(number)).for_each(|note| row_ui(ui, view, note, true));
        });
        return;
    }
    let document = program.shown();
    let of_selected = |note: &Note| {
        document.is_some_and(|document| note.place.block == document.selected && note.place.program == document.path)
    };
    // Only as far as a frame can look.
    let selected = (0..count.min(MOST_WHOLE * 10)).filter_map(|number| program.note(number)).find(of_selected);
    if let Some(note) = selected {
        row_ui(ui, view, note, true);
        ui.separator();
    }
    area.show_rows(ui, control(ui), count, |ui, rows| {
        for note in rows.filter_map(|number| program.note(number)) {
            row_ui(ui, view, note, false);
        }
    });
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, note: Note, is_whole: bool) {
    let palette = palette(ui.ctx());
    let is_error = note.kind == NoteKind::Error;
    let (shape, mark) = if is_error { (Some(Status::Scrap), palette.error.0) } else { (None, palette.quiet.0) };
    let said = view.words.say(&note.message);
    let colour = if is_error { palette.error.0 } else { palette.text.0 };
    let line = Button::new(RichText::new(&said).font(font(&note)).color(colour));
    let line = if is_whole { line.wrap() } else { line.truncate() };
    if marked_ui(ui, (shape, mark), line).on_hover_text(said).clicked() {
        view.send(ProgramCommand::GoTo(note.place));
    }
}
