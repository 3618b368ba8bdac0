//! The tool table on the pages that measure: which one is open, a list to pick a tool from, and what a run has changed.

use std::fmt::Debug;
use std::hash::Hash;
use std::ops::Range;

use eframe::egui::{Button, Color32, Id, Response, RichText, ScrollArea, Ui, vec2};

use super::over_page::just_opened;
use super::shapes::times;
use super::theme::{self, control, palette, sizes, space};
use super::view::{View, keep_focus, list_height, list_ui, problem, quiet};
use crate::control::tool_table::{Tool, ToolTable};
use crate::control::variables::Parameter;
use crate::length::Length;
use crate::message::message;
use crate::session::{NamedTool, WorkpieceAction, text_of_tool, tool_message};
use crate::text::{Within as _, cut};

/// The widths of the list's columns in characters: T and NAME, then the lengths.
const NUMBER: usize = 8;
const NAME: usize = 18;
const LENGTHS: [(&str, usize); 6] = [("L", 11), ("R", 9), ("DL", 9), ("DR", 9), ("LBREAK", 8), ("RBREAK", 8)];

/// Up to this many tools are listed at once.
const MOST_AT_ONCE: usize = 8;

/// Which table is open: a list that opens another one, or closes it; its caller names it.
pub(super) fn table_list_ui(ui: &mut Ui, view: &mut View<'_>, salt: impl Hash + Debug, width: f32) -> Response {
    let shown = match view.session.tools() {
        Some(tools) => {
            let message = message!("tools-open-one").text("name", &tools.name);
            view.words.say(&message.count("count", tools.table.tools().len()))
        }
        None => view.text("tools-none"),
    };
    list_ui(ui, salt, shown, width, |ui| {
        for action in [WorkpieceAction::OpenTools, WorkpieceAction::CloseTools] {
            if view.field_button(ui, action).clicked() {
                ui.close();
            }
        }
    })
}

/// What a tool is picked for.
pub(super) struct Pick {
    /// The parameter of a program; `None` for a field that takes numbers and names.
    pub parameter: Option<Parameter>,
    /// The row of the tool that is named now.
    pub chosen: Option<usize>,
    /// The width of the list while it is closed.
    pub width: f32,
}

/// A list of the table's tools; its caller names it. Returns what is typed for the tool that was picked.
pub(super) fn pick_ui(ui: &mut Ui, view: &View<'_>, salt: Id, pick: &Pick) -> (Option<String>, Response) {
    let table = view.session.tools().map(|tools| &tools.table);
    let chosen = table.zip(pick.chosen).and_then(|(table, row)| table.tools().get(row));
    let shown = chosen.map_or_else(|| view.text("tools-pick"), |tool| format!("{}  {}", tool.number, tool.name));
    let mut picked = None;
    let list = list_ui(ui, salt, shown, pick.width, |ui| {
        let Some(table) = table else { return };
        picked = rows_ui(ui, view, table, pick);
        if picked.is_some() {
            ui.close();
        }
    });
    if picked.is_some() {
        keep_focus(ui, &list);
    }
    (picked, list)
}

/// The rows of the table under the names of its columns.
fn rows_ui(ui: &mut Ui, view: &View<'_>, table: &ToolTable, pick: &Pick) -> Option<String> {
    let font = theme::mono(sizes().small);
    let header = header();
    let width = ui.painter().layout_no_wrap(header.clone(), font.clone(), Color32::PLACEHOLDER).size().x + space(8.0);
    ui.set_min_width(width.min(ui.ctx().content_rect().width() - space(12.0)));
    ui.horizontal(|ui| {
        ui.add_space(ui.spacing().button_padding.x);
        ui.label(RichText::new(header).font(font.clone()).color(palette(ui.ctx()).quiet.0));
    });
    let tools: Vec<(usize, &Tool, String)> = table
        .tools()
        .iter()
        .enumerate()
        .filter_map(|(row, tool)| Some((row, tool, text_of_tool(pick.parameter, tool, row, table)?)))
        .collect();
    let mut picked = None;
    // The keys begin at the tool that is named now; where none is, at the first one.
    let is_new = just_opened(ui, Id::unique("tools-list"));
    let focused = tools.iter().position(|(row, ..)| pick.chosen == Some(*row)).unwrap_or(0);
    let mut list_rows = |ui: &mut Ui, rows: Range<usize>| {
        for (number, (row, tool, text)) in rows.clone().zip(tools.within(rows)) {
            let shown = RichText::new(line(view, tool)).font(font.clone());
            let button = Button::selectable(pick.chosen == Some(*row), shown).truncate();
            let button = ui.add(button.min_size(vec2(0.0, control(ui))));
            if is_new && number == focused {
                button.request_focus();
            }
            if button.accessible_name(view.words.say(&tool_message(tool))).clicked() {
                picked = Some(text.clone());
            }
        }
    };
    if tools.len() <= MOST_AT_ONCE {
        list_rows(ui, 0..tools.len());
    } else {
        // Only the rows in sight: there may be thousands.
        let step = control(ui) + ui.spacing().item_spacing.y;
        let mut area = ScrollArea::vertical().max_height(list_height(ui) - space(12.0)).id_salt("tools");
        if is_new {
            area = area.vertical_scroll_offset(times(step, focused.saturating_sub(2)));
        }
        area.show_rows(ui, control(ui), tools.len(), list_rows);
    }
    let left_out = table.tools().len() - tools.len();
    if 0 < left_out {
        quiet(ui, view.words.say(&message!("tools-without-name").count("count", left_out)));
    }
    picked
}

fn header() -> String {
    let lengths = LENGTHS.map(|(name, width)| format!("{name:>width$}")).concat();
    format!("{:<NUMBER$}{:<NAME$}{lengths}  TL", "T", "NAME")
}

/// A row of the table under that header.
fn line(view: &View<'_>, tool: &Tool) -> String {
    let none = Length::ZERO;
    let breakage = [tool.length_breakage, tool.radius_breakage].map(|most| most.unwrap_or(none));
    let values = [tool.length, tool.radius, tool.delta_length, tool.delta_radius].into_iter().chain(breakage);
    let width = |(value, (_, width)): (Length, (&str, usize))| format!("{:>width$}", view.words.mm(value, 0));
    let lengths = values.zip(LENGTHS).map(width).collect::<Vec<_>>().concat();
    let lock = if tool.is_locked { "  L" } else { "" };
    format!("{:<NUMBER$}{:<NAME$}{lengths}{lock}", tool.number.to_string(), cut(&tool.name, NAME - 2))
}

/// The tool that is named, with its lengths and tolerances, or that the table does not have it; nothing without a table.
pub(super) fn named_ui(ui: &mut Ui, view: &View<'_>, named: Option<&NamedTool>) {
    let (Some(tools), Some(named)) = (view.session.tools(), named) else { return };
    if let Some(tool) = named.row(&tools.table).and_then(|row| tools.table.tools().get(row)) {
        quiet(ui, view.words.say(&tool_message(tool)));
    } else {
        let message = message!("tools-not-in-table").text("tool", named.text());
        problem(ui, view.words.say(&message));
    }
}
