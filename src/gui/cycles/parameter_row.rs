//! One parameter of a cycle: the control's question, a field or a choice, the unit, and an error below.

use eframe::egui::{Align, Event, Id, Layout, Rect, Response, RichText, Ui, vec2};

use super::wrong_field;
use crate::gui::field::{FieldStyle, error_ui, field_ui, select_all};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::tools::{Pick, named_ui, pick_ui, table_list_ui};
use crate::gui::view::{View, keep_focus, list_ui, quiet, quiet_height, quiet_within};
use crate::message::message;
use crate::probing::cycle::{Meaning, Parameter, Range, Value};
use crate::session::{CycleField, CyclesCommand, Field, NamedTool, ValueOrigin};

/// How wide a field is.
const FIELD: f32 = 24.0;

/// How wide a unit is.
const UNIT: f32 = 7.0;

/// The row; returns whether it has the focus.
pub(super) fn parameter_ui(ui: &mut Ui, view: &mut View<'_>, parameter: &'static Parameter) -> bool {
    let key = parameter.key;
    let question = parameter.question(view.words.language().dialogue());
    let mut has_focus = false;
    let width = match parameter.range {
        Range::OneOf(allowed) => list_width(ui, view, parameter, allowed),
        _ => space(FIELD + UNIT),
    };
    wide_row_ui(ui, format!("{key}  {question}"), width, |ui, name| {
        has_focus = match parameter.range {
            Range::OneOf(allowed) => choice_ui(ui, view, (parameter, allowed), (name, width)),
            _ => number_ui(ui, view, CycleField::Parameter(key), name, parameter),
        };
    });
    error_ui(ui, view, CycleField::Parameter(key));
    if view.session.cycles().is_predef(key) {
        row_ui(ui, format!("{key}  {}", view.text("cycles-predef")), |ui, name| {
            has_focus |= number_ui(ui, view, CycleField::Global(key), name, parameter);
        });
        error_ui(ui, view, CycleField::Global(key));
    }
    if parameter.range == Range::Tool {
        tool_ui(ui, view, parameter);
    }
    has_focus
}

/// Below the tool of Q330: the tool table, and a list to pick the tool from it.
fn tool_ui(ui: &mut Ui, view: &mut View<'_>, parameter: &'static Parameter) {
    let width = space(FIELD + UNIT + 15.0);
    let key = parameter.key;
    wide_row_ui(ui, view.text("tools"), width, |ui, name| {
        table_list_ui(ui, view, ("cycle-tools", key), width - space(1.0)).labelled_by(name);
    });
    let Some(tools) = view.session.tools() else { return };
    let page = view.session.cycles();
    let named = NamedTool::of_inputs(page.cycle, &page.inputs);
    let chosen = named.as_ref().and_then(|named| named.row(&tools.table));
    let message = message!("tools-pick-of").text("parameter", key);
    wide_row_ui(ui, view.words.say(&message), width, |ui, name| {
        let pick = Pick { parameter: None, chosen, width: width - space(1.0) };
        let (picked, list) = pick_ui(ui, view, Id::unique(("cycle-tool", key)), &pick);
        list.labelled_by(name);
        if let Some(text) = picked {
            view.send(CyclesCommand::Type(CycleField::Parameter(key), text));
        }
    });
    named_ui(ui, view, named.as_ref());
}

/// A name on the left, whole, and its field at the right edge.
pub(super) fn row_ui(ui: &mut Ui, name: String, field: impl FnOnce(&mut Ui, Id)) {
    wide_row_ui(ui, name, space(FIELD + UNIT), field);
}

/// The same with a field of another width. A name that would need more than two lines stands above its field.
fn wide_row_ui(ui: &mut Ui, name: String, field_width: f32, field: impl FnOnce(&mut Ui, Id)) {
    let width = (ui.available_width() - field_width - space(2.0)).max(space(10.0));
    if 2.5 * quiet_height(ui, "Q", width) < quiet_height(ui, &name, width) {
        let name = quiet(ui, name);
        let row = vec2(ui.available_width(), control(ui));
        ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = space(1.0);
            ui.add_space(width + space(1.0));
            field(ui, name.id);
        });
        return;
    }
    let row = vec2(ui.available_width(), quiet_height(ui, &name, width).max(control(ui)));
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_height(row.y);
        ui.spacing_mut().item_spacing.x = space(1.0);
        let name = quiet_within(ui, name, width);
        field(ui, name.id);
    });
}

/// What an empty field shows: a default in italics, so that it is not taken for something typed; what is missing in bold.
fn hint(view: &View<'_>, standing: &ValueOrigin) -> RichText {
    match standing {
        ValueOrigin::Given => RichText::default(),
        ValueOrigin::Required => required(view),
        ValueOrigin::Default(value @ (Value::Length(_) | Value::Angle(_) | Value::Number(_))) => {
            RichText::new(view.words.number(value.to_string().trim_end_matches('°'))).italics()
        }
        ValueOrigin::Default(_) | ValueOrigin::Optional => RichText::new(view.text("cycles-none")).italics(),
    }
}

fn required(view: &View<'_>) -> RichText {
    RichText::new(view.text("cycles-needed")).font(theme::bold(sizes().body))
}

/// The mark of a field that must be filled in: a bar at its left edge.
fn required_mark(ui: &Ui, field: Rect) {
    let bar = Rect::from_min_size(field.min, vec2(space(1.0), field.height()));
    ui.painter().rect_filled(bar, 2.0, palette(ui.ctx()).text.0);
}

/// What a screen reader says of a field in which nothing is typed, beside its name.
fn describe(ui: &Ui, view: &View<'_>, field: CycleField, standing: &ValueOrigin, response: &Response) {
    // An error has been said already.
    if *standing == ValueOrigin::Given || view.session.error(field).is_some() {
        return;
    }
    let said = standing_text(view, standing);
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_description(said.clone());
        if *standing == ValueOrigin::Required {
            node.set_required();
        }
    });
}

/// `50 mm when nothing is typed`, `Required`, `Optional`.
pub(super) fn standing_text(view: &View<'_>, standing: &ValueOrigin) -> String {
    match standing {
        ValueOrigin::Required => view.text("cycles-must-be-given"),
        ValueOrigin::Given | ValueOrigin::Optional => view.text("cycles-may-be-left-out"),
        ValueOrigin::Default(value) => {
            let value = view.words.say(&value.with_unit());
            view.words.say(&message!("cycles-default").text("value", value))
        }
    }
}

/// Gives the focus to a field that keeps a run from beginning.
fn lead_here(ui: &Ui, view: &View<'_>, field: Field, response: &Response) {
    if wrong_field(ui, view).map(Field::from) == Some(field) {
        response.request_focus();
        select_all(ui.ctx(), response.id, view.session.text(field));
    }
}

fn number_ui(ui: &mut Ui, view: &mut View<'_>, of: CycleField, name: Id, parameter: &Parameter) -> bool {
    // The value that PREDEF stands for has no default.
    let standing = match of {
        CycleField::Parameter(_) => view.session.cycles().standing(parameter),
        _ => ValueOrigin::Given,
    };
    let look = FieldStyle { hint: hint(view, &standing), ..FieldStyle::number(space(FIELD)) };
    let response = field_ui(ui, view, of, name, look);
    if standing == ValueOrigin::Required {
        required_mark(ui, response.rect);
    }
    describe(ui, view, of, &standing, &response);
    // Where there is no unit its place stays.
    quiet(ui, parameter.range.unit().unwrap_or(""));
    lead_here(ui, view, of.into(), &response);
    response.has_focus()
}

/// The meaning of a number of a choice, where it is known.
fn stands_for(view: &View<'_>, meaning: Meaning, number: i64) -> Option<String> {
    let number = if number < 0 { format!("minus-{}", number.unsigned_abs()) } else { number.to_string() };
    view.words.find(&format!("cycles-choice-{}", [meaning.word(), &number].join("-")))
}

/// A number of a choice with its meaning.
fn choice_text(view: &View<'_>, parameter: &Parameter, number: i64) -> String {
    let figure = view.words.number(&number.to_string());
    match stands_for(view, parameter.meaning, number) {
        Some(said) => format!("{figure}  {said}"),
        None => figure,
    }
}

/// The width of a list in which every choice is whole where the form has the room.
fn list_width(ui: &Ui, view: &View<'_>, parameter: &Parameter, numbers: &[i64]) -> f32 {
    let width = |number: &i64| {
        let text = choice_text(view, parameter, *number);
        let font = theme::font(sizes().body);
        ui.painter().layout_no_wrap(text, font, palette(ui.ctx()).text.0).size().x
    };
    // The text, the arrow and what is around them.
    let around = ui.spacing().button_padding.x * 2.0 + ui.spacing().icon_width + space(4.0);
    let least = space(FIELD + UNIT);
    let wanted = numbers.iter().map(width).fold(0.0, f32::max) + around;
    wanted.clamp(least, (ui.available_width() - space(18.0)).max(least))
}

/// One of a few numbers, each with its meaning.
fn choice_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (parameter, allowed): (&'static Parameter, &'static [i64]),
    (name, width): (Id, f32),
) -> bool {
    let key = parameter.key;
    let said = |number| choice_text(view, parameter, number);
    let typed = view.session.text(CycleField::Parameter(key)).trim().to_owned();
    let chosen = match (parameter.read(&typed).ok(), parameter.default_value()) {
        (Some(Value::Whole(number)), _) => Some(number),
        (_, Some(Value::Whole(number))) if typed.is_empty() => Some(number),
        _ => None,
    };
    let quiet = palette(ui.ctx()).quiet.0;
    let standing = view.session.cycles().standing(parameter);
    let shown = match chosen {
        Some(number) if typed.is_empty() => RichText::new(said(number)).color(quiet).italics(),
        Some(number) => RichText::new(said(number)),
        None if typed.is_empty() => required(view).color(quiet),
        None => RichText::new(typed.clone()),
    };
    let mut choice = None;
    let list = list_ui(ui, ("cycle-choice", key), shown, width - space(1.0), |ui| {
        ui.set_min_width(space(60.0));
        for number in allowed.iter().copied() {
            if ui.selectable_label(chosen == Some(number), said(number)).clicked() {
                choice = Some(number.to_string());
                ui.close();
            }
        }
        let predef = Value::Predef.to_string();
        if parameter.may_be_predef && ui.selectable_label(typed == predef, predef.as_str()).clicked() {
            choice = Some(predef);
            ui.close();
        }
    });
    let response = list.labelled_by(name);
    if standing == ValueOrigin::Required {
        required_mark(ui, response.rect);
    }
    describe(ui, view, CycleField::Parameter(key), &standing, &response);
    if choice.is_some() {
        keep_focus(ui, &response);
    } else if response.has_focus() {
        choice = typed_number(ui, allowed).map(|number| number.to_string());
    }
    let field = CycleField::Parameter(key);
    if let Some(text) = choice {
        view.send(CyclesCommand::Type(field, text));
    }
    lead_here(ui, view, field.into(), &response);
    response.has_focus()
}

/// The choice whose number was just typed; a minus sign chooses the negative one.
fn typed_number(ui: &Ui, allowed: &[i64]) -> Option<i64> {
    let typed = ui.input(|input| {
        let text = |event: &Event| if let Event::Text(text) = event { Some(text.clone()) } else { None };
        input.events.iter().find_map(text)
    })?;
    let number = typed.parse().ok();
    allowed.iter().copied().find(|allowed| Some(*allowed) == number || (typed == "-" && *allowed < 0))
}

/// A field without a parameter's declaration, such as a figure of the workpiece; one that may be empty says so.
pub(super) fn figure_ui(ui: &mut Ui, view: &mut View<'_>, of: impl Into<Field>, name: String, unit: &str) {
    let of = of.into();
    let is_optional = match of {
        Field::Workpiece(field) => field.is_optional(),
        _ => matches!(of, Field::Cycles(CycleField::Position(_))),
    };
    let hint = if is_optional { RichText::new(view.text("cycles-none")).italics() } else { RichText::default() };
    row_ui(ui, name, |ui, name| {
        let response = field_ui(ui, view, of, name, FieldStyle { hint, ..FieldStyle::number(space(FIELD)) });
        lead_here(ui, view, of, &response);
        quiet(ui, unit);
    });
    error_ui(ui, view, of);
}
