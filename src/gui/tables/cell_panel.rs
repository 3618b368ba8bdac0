//! Right: the selected cell against ISO 286, and the fields that change it.

use eframe::egui::accesskit::Live;
use eframe::egui::{Align, Grid, Id, Key, Layout, Pos2, Rect, Response, RichText, Sense, TextStyle, Ui, vec2};

use super::grid;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::spoken::{gap_ui, live};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, quiet};
use crate::length::Length;
use crate::message::{Message, Say as _, message};
use crate::session::tables::{Document, Origin};
use crate::session::{TablesAction, TablesCommand, TablesField};
use crate::tolerance::compare::Difference;
use crate::tolerance::{Deviations, ToleranceClass, iso286};

/// The selected cell.
struct Selected<'a> {
    document: &'a Document,
    class: ToleranceClass,
    /// From where to where its range goes.
    range: (Length, Length),
    cell: Option<Deviations>,
    /// What ISO 286 gives for the whole range, where it gives one thing.
    standard: Option<Deviations>,
    differences: &'a [Difference],
}

/// How many differences of one cell are listed: a range may cover many steps of the standard.
const MOST_TOLD: usize = 6;

/// The panel's content.
pub(super) fn cell_panel_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.5);
    let Some(document) = view.session.tables().shown() else { return };
    let Some((class, range)) = document.selected else {
        quiet(ui, view.text("tables-no-columns"));
        return;
    };
    // The cell that is selected is one of the table.
    let (Some(column), Some(ends)) = (document.column(class), document.range(range)) else { return };
    let cell = document.cell(class, range);
    let standard = document.standard(class, range);
    let differences = document.differences(column, range);
    let selected = Selected { document, class, range: ends, cell, standard, differences };
    let top = ui.cursor().min;
    title_ui(ui, view, &selected);
    figures_ui(ui, view, &selected);
    said_ui(ui, view, &selected, top);
    buttons_ui(ui, view);
}

fn title_ui(ui: &mut Ui, view: &View<'_>, selected: &Selected<'_>) {
    let range = range_text(view, selected.range);
    ui.horizontal(|ui| {
        ui.label(RichText::new(selected.class.as_str()).font(theme::bold(sizes().figure)));
        ui.label(RichText::new(range).font(theme::font(sizes().limits)));
    });
}

/// Table, ISO 286 and their difference: upper over lower.
fn figures_ui(ui: &mut Ui, view: &mut View<'_>, selected: &Selected<'_>) {
    let rows = [(TablesField::CellUpper, "tables-upper"), (TablesField::CellLower, "tables-lower")];
    Grid::new("cell-figures").num_columns(4).min_row_height(0.0).spacing(vec2(space(3.0), space(1.0))).show(ui, |ui| {
        gap_ui(ui, &TextStyle::Body);
        for id in ["tables-head-table", "tables-head-standard", "tables-head-by"] {
            right_ui(ui, sizes().body, |ui| quiet(ui, view.text(id)));
        }
        ui.end_row();
        for (field, id) in rows {
            let part = |pair: Deviations| if field == TablesField::CellUpper { pair.upper() } else { pair.lower() };
            let name = ui.label(view.text(id));
            value_ui(ui, view, field, name.id);
            let is = selected.standard.map(part);
            let is_text = is.map_or_else(|| "–".to_owned(), |is| view.words.signed_um(is));
            right_ui(ui, control(ui), |ui| ui.label(is_text));
            let by = selected.cell.map(part).zip(is).map(|(has, is)| has.saturating_sub(is));
            right_ui(ui, control(ui), |ui| match by {
                Some(by) if by != Length::ZERO => {
                    let text = RichText::new(view.words.signed_um(by)).font(theme::bold(sizes().body));
                    ui.label(text.color(palette(ui.ctx()).error.0))
                }
                Some(_) => quiet(ui, "0"),
                None => quiet(ui, "–"),
            });
            ui.end_row();
        }
    });
    for (field, _) in rows {
        error_ui(ui, view, field);
    }
}

/// A figure of the grid, right-aligned below its head.
fn right_ui(ui: &mut Ui, height: f32, figure: impl FnOnce(&mut Ui) -> Response) {
    ui.allocate_ui_with_layout(vec2(space(15.0), height), Layout::right_to_left(Align::Center), figure);
}

/// A field of the cell. Enter puts both into the table and goes back to the cells; Escape goes back without a change.
fn value_ui(ui: &mut Ui, view: &mut View<'_>, field: TablesField, name: Id) {
    let response = field_ui(ui, view, field, name, FieldStyle::number(space(18.0)));
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    if response.has_focus() && pressed(Key::Enter) && view.session.tables().cell_is_readable() {
        ui.memory_mut(|memory| memory.request_focus(grid::id()));
    }
    if response.lost_focus() && pressed(Key::Escape) {
        view.send(TablesCommand::RevertCell);
        ui.memory_mut(|memory| memory.request_focus(grid::id()));
    }
}

/// What differs by how much, where the class is defined, and the whole in one sentence for a screen reader.
fn said_ui(ui: &mut Ui, view: &View<'_>, selected: &Selected<'_>, top: Pos2) {
    let verdict = verdict(view, selected);
    for line in &verdict {
        ui.label(line);
    }
    let defined = selected.document.defined(selected.class);
    if !defined.is_empty() {
        let ranges: Vec<_> = defined.iter().map(|range| range_text(view, *range)).collect();
        quiet(ui, view.words.say(&message!("tables-defined").text("ranges", ranges.join(", "))));
    }
    if selected.document.origin == Origin::Shipped {
        quiet(ui, view.text("tables-shipped-hint"));
    }
    let range = range_text(view, selected.range);
    let said = format!("{}, {range}. {}", selected.class, verdict.join(". "));
    let rect = Rect::from_min_max(top, ui.min_rect().right_bottom());
    let response = ui.interact(rect, ui.scope_id().with("cell-said"), Sense::hover());
    live(ui, &response, &said, Live::Polite);
}

/// `over 18 up to 30 mm`.
fn range_text(view: &View<'_>, (over, to): (Length, Length)) -> String {
    view.words.say(&message!("limits-range").number("over", over).number("to", to))
}

/// `As in ISO 286`, or what differs by how much; for which sizes, where that is not the whole range.
fn verdict(view: &View<'_>, selected: &Selected<'_>) -> Vec<String> {
    if selected.document.is_own_class(selected.class) {
        let undefined = iso286::deviations(selected.class, Length::MAX, selected.document.options).err();
        return undefined.iter().map(|undefined| view.words.told(undefined)).collect();
    }
    if selected.differences.is_empty() {
        let id = if selected.cell.is_some() { "tables-cell-agrees" } else { "tables-cell-empty" };
        return vec![view.text(id)];
    }
    let told = selected.differences.iter().take(MOST_TOLD).map(|difference| {
        let said = view.words.say(&difference_text(view, difference));
        let range = (difference.over, difference.to);
        if range == selected.range { said } else { format!("{}: {said}", range_text(view, range)) }
    });
    let more = selected.differences.len().saturating_sub(MOST_TOLD);
    let more = (0 < more).then(|| view.words.say(&message!("tables-more-differences").count("count", more)));
    told.chain(more).collect()
}

fn difference_text(view: &View<'_>, difference: &Difference) -> Message {
    let signed = |length| view.words.signed_um(length);
    let pair = |id, pair: &Deviations| {
        Message::new(id).text("upper", signed(pair.upper())).text("lower", signed(pair.lower()))
    };
    match (&difference.standard, difference.upper_by(), difference.lower_by()) {
        (Ok(standard), Some(upper), Some(lower)) => {
            pair("tables-cell-off", standard).text("upper-by", signed(upper)).text("lower-by", signed(lower))
        }
        (Ok(standard), ..) => pair("tables-cell-missing", standard),
        (Err(undefined), ..) => undefined.message(),
    }
}

fn buttons_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        for action in [TablesAction::SetCell, TablesAction::TakeStandard, TablesAction::EmptyCell] {
            view.button(ui, action);
        }
    });
}
