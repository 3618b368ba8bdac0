//! The columns of a file of measurements: its first rows, above each column what it is taken for, and what that makes of the rows.

use eframe::egui::accesskit::Live;
use eframe::egui::{Button, Grid, Id, Label, RichText, ScrollArea, TextStyle, Ui, vec2};

use super::over_page::just_opened;
use super::spoken::{dialog_headed, gap_ui, live};
use super::theme::{self, control, sizes, space};
use super::view::{View, heading, keep_focus, list_ui, problem, quiet};
use crate::exchange::{ColumnUnit, DecimalSign, Role, Separator};
use crate::message::{Message, message};
use crate::session::{ColumnChoice, ColumnsCommand, OpenColumns, WindowAction, role_id, unit_id};

/// What a column may hold, in the order of the list.
const ROLES: [Role; 25] = [
    Role::Id,
    Role::Number,
    Role::Tolerance,
    Role::Nominal,
    Role::Measured,
    Role::Time,
    Role::Part,
    Role::Serial,
    Role::Who,
    Role::X,
    Role::Y,
    Role::Z,
    Role::Simulated,
    Role::Quantity,
    Role::Upper,
    Role::Lower,
    Role::Minus,
    Role::Maximum,
    Role::Minimum,
    Role::Kind,
    Role::Units,
    Role::Status,
    Role::Machine,
    Role::Batch,
    Role::Sample,
];

/// The names of the separators.
const SEPARATORS: [&str; 4] = [
    "columns-page-separator-semicolon",
    "columns-page-separator-comma",
    "columns-page-separator-tab",
    "columns-page-separator-pipe",
];

/// The names of the decimal signs.
const DECIMALS: [&str; 2] = ["columns-page-decimal-point", "columns-page-decimal-comma"];

/// The most characters of a cell that are shown.
const LONGEST: usize = 28;

/// An entry of a list: its text, whether it is the chosen one, and what it chooses.
type Entry = (String, bool, ColumnChoice);

/// The panel's content.
pub(super) fn columns_ui(ui: &mut Ui, view: &mut View<'_>, open: &OpenColumns) {
    let screen = ui.ctx().content_rect().size();
    let width = space(280.0).min(screen.x - space(12.0));
    ui.set_width(width);
    ui.set_max_width(width);
    ui.spacing_mut().interact_size.y = control(ui);
    // Room for what is said in three lines: nothing moves when it is another text, and it never scrolls out of sight.
    let said = 3.0 * (sizes().body + space(2.0));
    let foot = control(ui) + said + space(26.0);
    ScrollArea::vertical().id_salt("columns").max_height(screen.y - foot).show(ui, |ui| {
        let head = heading(ui, view.words.say(&message!("columns-page-title").text("name", open.name())));
        dialog_headed(ui, Id::unique("columns-panel"), &head);
        quiet(ui, view.text(if open.asked.is_wanted { "columns-page-wanted" } else { "columns-page-uncertain" }));
        ui.horizontal_wrapped(|ui| file_ui(ui, view, open));
        ui.separator();
        let height = (screen.y - foot - control(ui) * 3.0 - space(24.0)).max(space(40.0));
        ScrollArea::both().id_salt("columns-table").max_height(height).show(ui, |ui| table_ui(ui, view, open));
        ui.separator();
    });
    ui.scope(|ui| {
        ui.set_min_height(said);
        said_ui(ui, view, open);
    });
    ui.horizontal_wrapped(|ui| {
        let size = vec2(view.width_of(ui, &[WindowAction::TakeColumns]), control(ui));
        let mut take = view.sized_button(ui, WindowAction::TakeColumns, size);
        if let Some(refusal) = &open.refusal {
            take = take.on_disabled_hover_text(view.words.say(refusal));
        }
        if just_opened(ui, Id::unique("columns")) && open.refusal.is_none() {
            take.request_focus();
        }
        if ui.add(Button::new(view.text("dialog-cancel")).min_size(vec2(space(24.0), control(ui)))).clicked() {
            view.send(ColumnsCommand::Leave);
        }
    });
}

/// A drop-down list with its name before it.
fn named_list_ui(ui: &mut Ui, view: &mut View<'_>, id: &'static str, entries: Vec<Entry>) {
    // One after the other: what is laid out together does not wrap.
    let name = ui.label(view.text(id));
    let list = choices_ui(ui, view, (id, 0), (space(34.0), entries));
    list.labelled_by(name.id);
}

fn choices_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    salt: (&'static str, usize),
    (width, entries): (f32, Vec<Entry>),
) -> eframe::egui::Response {
    // At first none is chosen.
    let shown = entries.iter().find(|(_, is_chosen, _)| *is_chosen).map_or_else(String::new, |(text, ..)| text.clone());
    let mut chosen = None;
    let list = list_ui(ui, salt, shown, width, |ui| {
        ui.spacing_mut().interact_size.y = control(ui);
        for (text, is_chosen, choice) in entries {
            if ui.add(Button::selectable(is_chosen, text).min_size(vec2(0.0, control(ui)))).clicked() {
                chosen = Some(choice);
                ui.close();
            }
        }
    });
    if let Some(choice) = chosen {
        view.send(ColumnsCommand::Choose(choice));
        keep_focus(ui, &list);
    }
    list
}

/// What is chosen for the file as a whole.
fn file_ui(ui: &mut Ui, view: &mut View<'_>, open: &OpenColumns) {
    let choice = &open.choice;
    let sheets = open.asked.first.sheets();
    if 1 < sheets.len() {
        let entry = |sheet: &&str| {
            ((*sheet).to_owned(), choice.sheet.as_deref() == Some(*sheet), ColumnChoice::Sheet((*sheet).to_owned()))
        };
        named_list_ui(ui, view, "columns-page-sheet", sheets.iter().map(entry).collect());
    }
    if sheets.is_empty() {
        let entry = |(separator, id): (Separator, &str)| {
            (view.text(id), choice.separator == Some(separator), ColumnChoice::Separator(separator))
        };
        let entries = Separator::ALL.into_iter().zip(SEPARATORS).map(entry).collect();
        named_list_ui(ui, view, "columns-page-separator", entries);
    }
    let decimal =
        |sign: Option<DecimalSign>, id: &str| (view.text(id), choice.decimal == sign, ColumnChoice::Decimal(sign));
    let own = DecimalSign::ALL.into_iter().zip(DECIMALS).map(|(sign, id)| decimal(Some(sign), id));
    let decimals = std::iter::once(decimal(None, "columns-page-as-found")).chain(own).collect();
    let units = |now: Option<ColumnUnit>, of: fn(Option<ColumnUnit>) -> ColumnChoice| {
        let all = std::iter::once(None).chain(ColumnUnit::ALL.into_iter().map(Some));
        all.map(|unit| (view.text(unit_id(unit)), now == unit, of(unit))).collect::<Vec<Entry>>()
    };
    let places = units(choice.place_unit, ColumnChoice::PlaceUnit);
    let mut units = units(choice.unit, ColumnChoice::Unit);
    if let Some(((text, ..), from)) = units.first_mut().zip(open.unit_from.as_deref().filter(|_| choice.unit.is_none()))
    {
        *text = view.words.say(&message!("columns-page-unit-from").text("from", from));
    }
    named_list_ui(ui, view, "columns-page-decimal", decimals);
    named_list_ui(ui, view, "columns-page-unit", units);
    if open.has_place() {
        named_list_ui(ui, view, "columns-page-place-unit", places);
    }
    let first = choice.first_row;
    let below = (view.text("columns-page-below-header"), first.is_none(), ColumnChoice::FirstRow(None));
    let line = |(line, _): &(usize, Vec<String>)| {
        let text = view.words.say(&message!("columns-page-line").text("line", line));
        (text, first == Some(*line), ColumnChoice::FirstRow(Some(*line)))
    };
    let lines = std::iter::once(below).chain(open.rows.iter().map(line)).collect();
    named_list_ui(ui, view, "columns-page-first-row", lines);
}

/// The first rows below what their columns are taken for.
fn table_ui(ui: &mut Ui, view: &mut View<'_>, open: &OpenColumns) {
    Grid::new("columns-rows").striped(true).spacing(vec2(space(3.0), space(1.0))).show(ui, |ui| {
        gap_ui(ui, &TextStyle::Body);
        for at in 0..open.width {
            let name = message!("columns-page-column").text("number", at + 1).text("name", open.column_name(at));
            let name = view.words.say(&name).trim().to_owned();
            let entry =
                |role: Option<Role>| (view.text(&role_id(role)), open.role(at) == role, ColumnChoice::Role(at, role));
            let entries = std::iter::once(None).chain(ROLES.into_iter().map(Some)).map(entry).collect();
            ui.vertical(|ui| {
                let name = quiet(ui, short(&name));
                let list = choices_ui(ui, view, ("columns-role", at), (space(30.0), entries));
                list.labelled_by(name.id);
            });
        }
        ui.end_row();
        for (line, cells) in &open.rows {
            let is_header = open.header == Some(*line);
            let is_read = open.lines.contains(line);
            let kind = match (is_header, is_read) {
                (true, _) => "columns-page-header",
                (false, true) => "columns-page-row",
                (false, false) => "columns-page-not-read",
            };
            quiet(ui, view.words.say(&Message::new(kind).text("line", line)));
            for at in 0..open.width {
                let text = RichText::new(short(cells.get(at).map_or("", String::as_str)));
                let text = if is_header { text.font(theme::bold(sizes().body)) } else { text };
                let text = if is_header || is_read { text } else { text.weak() };
                ui.add(Label::new(text).extend());
            }
            ui.end_row();
        }
    });
}

/// What the first rows become, and why not.
fn said_ui(ui: &mut Ui, view: &View<'_>, open: &OpenColumns) {
    let message = message!("columns-page-read").count("read", open.read).count("rows", open.lines.len());
    let said = view.words.say(&message);
    let line = ui.label(&said);
    live(ui, &line, &said, Live::Polite);
    if let Some(refusal) = open.refusal.as_ref() {
        problem(ui, view.words.say(refusal));
    } else if let Some(wrong) = open.problem.as_ref() {
        let first = message!("columns-page-first-problem").message("why", wrong.clone());
        problem(ui, view.words.say(&first));
    }
}

fn short(text: &str) -> String {
    let mut chars = text.chars();
    let mut short: String = chars.by_ref().take(LONGEST).collect();
    if chars.next().is_some() {
        short.push('…');
    }
    short
}
