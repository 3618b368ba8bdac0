//! Below the listing: errors, warnings and remarks, one per line; a click shows the block.

use eframe::egui::{Button, Panel, RichText, ScrollArea, Sense, Ui, vec2};

use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::Message;
use crate::session::ProgramCommand;
use crate::session::program::{NoteKind, Run};
use crate::verdict::Status;

/// How many lines are visible without scrolling.
const LINES: u8 = 4;

/// The panel, where there are notes.
pub(super) fn notes_ui(ui: &mut Ui, view: &mut View<'_>) {
    let program = view.session.program();
    let count = program.note_count();
    if count == 0 {
        return;
    }
    let row = control(ui);
    let lines = f32::from(u8::try_from(count).unwrap_or(LINES).min(LINES));
    let height = row * (lines + 1.0) + space(4.0);
    Panel::bottom("program-problems").exact_size(height).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.horizontal(|ui| {
            heading(ui, view.words.say(&Message::new("program-page-problems").count("count", count)));
            let unlisted = program.run().map_or(0, Run::unlisted_remarks);
            if 0 < unlisted {
                quiet(ui, view.words.say(&Message::new("program-page-unlisted").count("count", unlisted)));
            }
        });
        let area = ScrollArea::vertical().id_salt("problems").auto_shrink(false).min_scrolled_height(0.0);
        area.show_rows(ui, row, count, |ui, rows| {
            for number in rows {
                row_ui(ui, view, number);
            }
        });
    });
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, number: usize) {
    let Some(note) = view.session.program().note(number) else { return };
    let palette = palette(ui.ctx());
    let is_error = note.kind == NoteKind::Error;
    ui.horizontal(|ui| {
        let (mark, _) = ui.allocate_exact_size(vec2(space(4.0), space(4.0)), Sense::hover());
        let (shape, colour) = if is_error { (Some(Status::Scrap), palette.error.0) } else { (None, palette.quiet.0) };
        shapes::status(ui.painter(), mark, shape, colour);
        let said = view.words.say(&note.message);
        let font = if is_error { theme::bold(sizes().small) } else { theme::font(sizes().small) };
        let colour = if is_error { palette.error.0 } else { palette.text.0 };
        let text = RichText::new(&said).font(font).color(colour);
        let button = Button::new(text).frame(false).truncate().min_size(vec2(0.0, control(ui)));
        if ui.add(button).on_hover_text(said).clicked() {
            view.send(ProgramCommand::GoTo(note.place));
        }
    });
}
