//! Bottom, in the place of the history: the rows of a large file. How far it is judged, how many rows have which verdict
//! (each count lists its rows), the classes, and what was remarked.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, ComboBox, Label, Layout, PopupCloseBehavior, ProgressBar, Rect, ScrollArea, Sense, Stroke, StrokeKind, Ui,
    UiBuilder, WidgetInfo, WidgetText, pos2, vec2,
};

use super::grouped;
use super::row_texts::fate_text;
use super::rows_list::list_ui;
use crate::exchange::batch::{FIRST, RowFate, RowNoteKind, Tally};
use crate::gui::field::{FieldStyle, field_ui};
use crate::gui::shapes::{self, share};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::top_bar::export_ui;
use crate::gui::view::{View, caret_ui, heading, list_height, problem, quiet, quiet_cut};
use crate::message::{Message, message};
use crate::session::{CheckAction, CheckField, End, LARGE, Large, Rows, RowsCommand};
use crate::text::long;
use crate::tolerance::ToleranceClass;
use crate::verdict::Status;
use crate::words::Words;

/// Title, counts and list.
pub(super) fn rows_ui(ui: &mut Ui, view: &mut View<'_>, rows: &Rows) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        switch_ui(ui, view);
        // Each stands in the place of the other, and numbers that grow move nothing that is pressed.
        for action in [CheckAction::CancelRows, CheckAction::JudgeRowsAgain, CheckAction::CloseRows] {
            if view.session.can(action) {
                view.button(ui, action);
            }
        }
        heading(ui, rows.name.as_str());
        state_ui(ui, view, rows);
        if view.session.check().judges_by_more_than_limits() {
            problem(ui, view.text("rows-by-limits"));
        }
        why_ui(ui, view, rows);
        for (fate, count) in rows.fates() {
            // A zero of what seldom comes would only raise questions.
            if !fate.status().is_some_and(Status::is_rare) || 0 < count {
                fate_ui(ui, view, rows, (fate, count));
            }
        }
        classes_ui(ui, view, rows);
        summary_ui(ui, view, rows);
        filter_ui(ui, view);
        for action in [CheckAction::WorstFirst, CheckAction::ShowWorstRow] {
            if view.session.can(action) {
                if action == CheckAction::WorstFirst {
                    view.toggle(ui, action)
                } else {
                    view.button(ui, action)
                };
            }
        }
        theme::looking(ui, theme::tonal, |ui| ui.menu_button(view.text("export"), |ui| export_ui(ui, view)));
        listed_ui(ui, view, rows);
    });
    if let Some(why) = rows.unread.as_ref().or(rows.unsifted.as_ref()) {
        problem(ui, view.words.say(why));
    }
    list_ui(ui, view, rows);
}

/// How many rows are listed, in which order, or why not yet.
fn listed_ui(ui: &mut Ui, view: &View<'_>, rows: &Rows) {
    let words = view.words;
    if rows.is_sifting() {
        quiet(ui, view.text("rows-sifting"));
    } else if rows.awaits_end() {
        quiet(ui, view.text("rows-sifts-at-end"));
    }
    let listed = (!rows.lists_all()).then(|| {
        message!("rows-listed").text("listed", grouped(long(rows.listed()))).text("count", grouped(rows.count()))
    });
    let order = rows.order_told().filter(|_| !rows.is_sifting());
    let said: Vec<_> = listed.iter().chain(&order).map(|said| words.say(said)).collect();
    if !said.is_empty() {
        quiet(ui, said.join(", "));
    }
}

/// Words that listed rows must have.
fn filter_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = ui.label(view.text("history-filter"));
    let filter = field_ui(ui, view, CheckField::RowsFilter, name.id, FieldStyle::text(space(40.0)));
    filter.on_hover_text(view.text("rows-filter-hint"));
}

/// Which of the two lists is in sight. Where no large file was opened, there is nothing to choose.
pub(super) fn switch_ui(ui: &mut Ui, view: &mut View<'_>) {
    for shows_rows in [true, false] {
        let action = CheckAction::ShowRows(shows_rows);
        if view.session.can(action) {
            view.toggle(ui, action);
        }
    }
}

/// How far it is, or how it has ended: an answer that is not whole says so first.
fn state_ui(ui: &mut Ui, view: &View<'_>, rows: &Rows) {
    let words = view.words;
    let count = grouped(rows.count());
    let (read, all) = rows.bytes;
    // Of a file whose size is not known no share can be said: it counts as not begun.
    let percent = all.and_then(|all| (read * 100).checked_div(all)).map_or(0, |percent| percent.min(100));
    let seconds = seconds(words, rows.elapsed_ms);
    // Within the first millisecond there is none.
    let rate = rows.rate().map_or_else(String::new, grouped);
    let said = |id: &'static str| {
        let said = Message::new(id).text("count", &count).text("percent", percent).text("rate", &rate);
        said.text("seconds", &seconds)
    };
    match rows.end.as_ref() {
        None => {
            let bar = ProgressBar::new(all.map_or(0.0, |all| share(read, all)))
                .desired_width(space(25.0))
                .desired_height(space(3.0));
            let text = words.say(&said("rows-running"));
            let shown = ui.add(bar);
            shown.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, view.text("rows-progress")));
            quiet(ui, text);
        }
        Some(End::Done) => _ = quiet(ui, words.say(&said("rows-done"))),
        Some(End::Cancelled) => _ = problem(ui, words.say(&said("rows-cancelled"))),
        Some(End::Failed(why)) => _ = problem(ui, words.say(&said("rows-failed").message("why", why.clone()))),
    }
}

/// A time with one decimal; less than that has a word for it.
fn seconds(words: &Words, ms: u64) -> String {
    let tenths = |ms: u64| words.number(&format!("{:.1}", std::time::Duration::from_millis(ms).as_secs_f64()));
    match ms {
        0..100 => words.say(&message!("rows-less-than").text("seconds", tenths(100))),
        _ => words.say(&message!("rows-seconds").text("seconds", tenths(ms))),
    }
}

/// Why the file is judged row by row, in what is left of the line; where there is no room, it is in the summary alone.
fn why_ui(ui: &mut Ui, view: &View<'_>, rows: &Rows) {
    let room = ui.available_size_before_wrap().x - ui.spacing().item_spacing.x;
    if space(45.0) <= room {
        let why = why_text(view.words, rows);
        ui.allocate_ui_with_layout(vec2(room, control(ui)), Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(room);
            quiet_cut(ui, &why).on_hover_text(&why);
        });
    }
}

/// Why the file is judged row by row, and what that means.
fn why_text(words: &Words, rows: &Rows) -> String {
    words.say(&match rows.large {
        Large::Bytes(bytes) => message!("rows-why-bytes").text("size", bytes >> 20).text("limit", LARGE >> 20),
        Large::Packed => message!("rows-why-packed"),
    })
}

/// A count that lists its rows: a box with a check mark, the shape, the word and the number.
fn fate_ui(ui: &mut Ui, view: &mut View<'_>, rows: &Rows, (fate, count): (RowFate, u64)) {
    let is_chosen = rows.filter.fates.contains(&fate);
    let (fill, colour) = palette(ui.ctx()).of_status(fate.status());
    let text = message!("rows-fate").text("fate", fate_text(view.words, fate)).text("count", grouped(count));
    let text = view.words.say(&text);
    let galley = ui.painter().layout_no_wrap(text.clone(), theme::bold(sizes().body), colour);
    let mark = space(4.0);
    let gap = space(1.5);
    let size = vec2(2.0 * (mark + gap) + galley.size().x + 16.0, control(ui));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let inner = rect.shrink2(vec2(8.0, 0.0));
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, fill);
    let at = |left: f32| Rect::from_min_size(inner.left_center() + vec2(left, -mark / 2.0), vec2(mark, mark));
    painter.rect(at(0.0), 2.0, palette(ui.ctx()).surface.0, Stroke::new(1.5, colour), StrokeKind::Inside);
    if is_chosen {
        shapes::status(painter, at(0.0).shrink(2.0), Some(Status::Good), palette(ui.ctx()).text.0);
    }
    shapes::status(painter, at(mark + gap), fate.status(), colour);
    let left = inner.left() + 2.0 * (mark + gap);
    painter.galley(pos2(left, rect.center().y - galley.size().y / 2.0), galley, colour);
    if response.has_focus() {
        shapes::focus_ring(ui, rect);
    }
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_chosen, &text));
    if response.on_hover_text(view.text("rows-fate-hint")).clicked() {
        view.send(RowsCommand::Fate(fate));
    }
}

/// The classes that occur, with how many rows each has.
fn classes_ui(ui: &mut Ui, view: &mut View<'_>, rows: &Rows) {
    let chosen = &rows.filter.classes;
    let name = |view: &View<'_>, class: Option<ToleranceClass>| {
        class.map_or_else(|| view.text("rows-no-class"), |class| class.to_string())
    };
    let mut classes: Vec<_> =
        rows.classes().map(|(number, class, counts)| (class, number, counts.iter().sum())).collect();
    classes.sort_unstable_by_key(|(class, ..)| (class.is_none(), *class));
    let shown = match chosen.len() {
        0 => view.text("rows-all-classes"),
        1 => classes
            .iter()
            .find(|(_, number, _)| chosen.contains(number))
            .map_or(String::new(), |(class, ..)| name(view, *class)),
        count => view.words.say(&message!("rows-some-classes").count("count", count)),
    };
    let label = ui.label(view.text("rows-classes"));
    let list =
        ComboBox::from_id_salt("rows-classes").selected_text(WidgetText::from(shown)).width(space(32.0)).icon(caret_ui);
    let list = list.truncate().height(list_height(ui)).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let list = list.show_ui(ui, |ui| {
        if ui.selectable_label(chosen.is_empty(), view.text("rows-all-classes")).clicked() {
            view.send(RowsCommand::AllClasses);
        }
        for (class, number, count) in classes {
            let count: u64 = count;
            let text = message!("rows-class").text("class", name(view, class)).text("count", grouped(count));
            let mut is_on = chosen.contains(&number);
            if ui.checkbox(&mut is_on, view.words.say(&text)).clicked() {
                view.send(RowsCommand::Class(number));
            }
        }
    });
    list.response.labelled_by(label.id);
}

/// What was said of the rows, as `fitcheck batch` says it: the first remarks with their lines, the verdicts of each class.
fn summary_ui(ui: &mut Ui, view: &View<'_>, rows: &Rows) {
    ui.menu_button(view.text("rows-summary"), |ui| {
        ui.set_min_width(space(130.0));
        let area = ScrollArea::vertical().max_height(list_height(ui));
        area.show(ui, |ui| {
            if !rows.end.as_ref().is_some_and(|end| *end == End::Done) {
                problem(ui, view.text("rows-not-whole"));
            }
            quiet(ui, why_text(view.words, rows));
            remarks_ui(ui, view, rows);
            ui.separator();
            for (_, class, counts) in rows.classes() {
                let name = class.map_or_else(|| view.text("rows-no-class"), |class| class.to_string());
                let counts = RowFate::ALL.into_iter().zip(counts).filter(|(_, count)| 0 < **count);
                let said =
                    |(fate, count): (RowFate, &u64)| format!("{} {}", fate_text(view.words, fate), grouped(*count));
                let counts: Vec<String> = counts.map(said).collect();
                ui.label(format!("{name}: {}", counts.join(", ")));
            }
        });
    });
}

fn remarks_ui(ui: &mut Ui, view: &View<'_>, rows: &Rows) {
    let words = view.words;
    let tally = &rows.tally;
    for (id, count) in counts(tally) {
        if 0 < count {
            let number = usize::try_from(count).unwrap_or(usize::MAX);
            ui.label(words.say(&Message::new(id).count("count", number).text("number", grouped(count))));
        }
    }
    let first_line = rows.layout.as_deref().map_or(1, |layout| layout.line);
    if let Some(layout) = rows.layout.as_deref() {
        for (line, warning) in &layout.warnings {
            quiet(ui, words.say(&message!("rows-note").count("line", *line).with("what", warning)));
        }
    }
    for kind in RowNoteKind::ALL {
        let notes = tally.notes(kind);
        if usize::try_from(notes.count).is_ok_and(|count| FIRST < count) {
            quiet(
                ui,
                words.say(&message!("rows-first-notes").count("first", FIRST).text("count", grouped(notes.count))),
            );
        }
        for note in &notes.first {
            let line = message!("rows-note").count("line", first_line + note.line);
            quiet(ui, words.say(&line.message("what", note.what.clone())));
        }
    }
}

/// What there is to be said of all rows, and of how many.
fn counts(tally: &Tally) -> [(&'static str, u64); 9] {
    [
        ("rows-refused", tally.notes(RowNoteKind::Refused).count),
        ("rows-doubted", tally.notes(RowNoteKind::Doubt).count),
        ("rows-status-differs", tally.notes(RowNoteKind::StatusDiffers).count),
        ("rows-status-unknown", tally.notes(RowNoteKind::StatusUnknown).count),
        ("rows-claim-differs", tally.notes(RowNoteKind::ClaimDiffers).count),
        ("rows-simulated", tally.simulated),
        ("rows-several-lines", tally.notes(RowNoteKind::SeveralLines).count),
        ("rows-not-utf8", tally.not_utf8),
        ("rows-comments", tally.comments),
    ]
}

/// The cells of the row whose check is shown, or why it has none.
pub(super) fn shown_row_ui(ui: &mut Ui, view: &mut View<'_>) {
    let Some(rows) = view.session.check().rows.as_ref() else { return };
    let Some(row) = rows.shown.as_ref() else { return };
    heading(ui, view.words.say(&message!("rows-line").count("line", row.line).text("name", &rows.name)));
    if let Some(why) = &row.why {
        problem(ui, view.words.say(why));
    }
    for (name, cell) in &row.cells {
        ui.scope_builder(UiBuilder::new().layout(Layout::left_to_right(Align::Min)), |ui| {
            ui.set_width(ui.available_width());
            quiet(ui, name);
            ui.add(Label::new(short(cell)).wrap());
        });
    }
    if view.session.can(CheckAction::KeepRow) {
        view.button(ui, CheckAction::KeepRow);
    }
    ui.add_space(space(1.0));
}

/// A cell that is longer than anybody reads is cut.
fn short(cell: &str) -> String {
    const MOST: usize = 500;
    let mut text: String = cell.chars().take(MOST).collect();
    if text.len() < cell.len() {
        text.push('…');
    }
    text
}
