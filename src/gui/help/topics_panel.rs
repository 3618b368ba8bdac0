//! Left: the search field, and the topics that it finds, each with the line that it was found in.

use std::ops::Range;

use eframe::egui::{Id, Ui};

use crate::gui::field::{self, FieldStyle, field_ui};
use crate::gui::key_names::part_id;
use crate::gui::over_page::just_opened;
use crate::gui::table::{Cell, Column, Row, Table, found_height};
use crate::gui::view::{View, quiet};
use crate::message::message;
use crate::session::focused::TOPICS;
use crate::session::{HelpCommand, HelpField};

/// The id of the list: it takes the focus as a whole.
fn id() -> Id {
    part_id(TOPICS)
}

/// The field and the list, in the room that is left. A list in the place of the text is gone after a click, and gets no focus.
pub(super) fn topics_ui(ui: &mut Ui, view: &mut View<'_>, is_beside: bool) {
    if just_opened(ui, Id::unique("help-search")) {
        ui.memory_mut(|memory| memory.request_focus(field::id(HelpField::Search)));
    }
    let name = quiet(ui, view.text("help-page-search"));
    let width = ui.available_width();
    field_ui(ui, view, HelpField::Search, name.id, FieldStyle::large(width));
    let columns = [Column::text(60.0)];
    let help = view.session.help();
    // Hits have the line that they were found in.
    let has_lines = help.found.iter().any(|found| !found.line.is_empty());
    let height = has_lines.then(|| found_height(ui, 2));
    let table = Table {
        height,
        count: help.found.len(),
        look: (help.look, help.selected()),
        empty: view.text("help-page-nothing"),
        keeps_focus: is_beside,
        ..Table::new(id(), "help-page-list", &columns)
    };
    let seen = table.show(ui, view, rows);
    if let Some(number) = seen.clicked {
        view.send(HelpCommand::Select(number));
    }
}

fn rows(view: &View<'_>, places: Range<usize>) -> Vec<Row<usize>> {
    let help = view.session.help();
    let selected = help.selected();
    let row = |number: usize| {
        let found = help.found.get(number)?;
        let title = found.place.topic.title(view.words);
        let text = match &found.heading {
            Some(heading) => view.words.say(&message!("help-page-found").text("title", title).text("heading", heading)),
            None => title,
        };
        let is_selected = selected == Some(number);
        let line: String = found.line.iter().map(|part| part.text.as_str()).collect();
        let row = if line.is_empty() {
            Row::new(number, vec![Cell::Text(text.clone())], text)
        } else {
            let said = view.words.say(&message!("help-page-found-line").text("place", &text).text("line", line));
            let line = found.line.iter().map(|part| (part.text.clone(), part.is_found)).collect();
            Row::new(number, vec![Cell::Found { name: text, line }], said)
        };
        Some(Row { is_cursor: is_selected, is_open: is_selected, ..row })
    };
    places.map_while(row).collect()
}
