//! Right, below: parameters with names and values; what the last command changed stands out, by more than colour.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{Align2, Button, Rect, RichText, ScrollArea, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::control::variables::Value;
use crate::gui::card::page_frame;
use crate::gui::columns::GAP;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::Message;
use crate::nc::machine::shown;
use crate::session::program::{Name, Watched};
use crate::session::{ProgramAction, ProgramCommand, ProgramField};
use crate::text::Within as _;

/// The height of a parameter, and how many are in sight where there is room.
const ROW: f32 = 7.0;
const ROWS: f32 = 4.0;

/// The height of the panel with that many of them below its two rows of fields.
pub(super) fn usual_height(ui: &Ui) -> f32 {
    let fields = 2.0 * (control(ui) + space(1.0));
    let edges = page_frame(ui).total_margin().sum().y + f32::from(GAP);
    (fields + space(ROW) * ROWS + edges).ceil()
}

/// The panel's content.
pub(super) fn watch_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    ui.horizontal(|ui| {
        heading(ui, view.text("program-page-parameters"));
        let name = quiet(ui, view.text("program-page-filter"));
        let look = FieldStyle::text(ui.available_width() - space(5.0));
        field_ui(ui, view, ProgramField::Filter, name.id, look);
    });
    given_ui(ui, view);
    let program = view.session.program();
    let watched = program.watched();
    if watched.is_empty() {
        let id = if program.run.is_some() { "program-page-none-found" } else { "program-page-no-parameters" };
        quiet(ui, view.text(id));
        return;
    }
    let height = space(ROW);
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical().id_salt("watch").auto_shrink(false).show_rows(ui, height, watched.len(), |ui, rows| {
        // A row is lower than what is pressed elsewhere; a sign stands in its middle.
        ui.spacing_mut().interact_size.y = 0.0;
        for watched in watched.within(rows) {
            row_ui(ui, view, watched, height);
        }
    });
}

/// A value that the next run begins with.
fn given_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space(1.5);
        let name = quiet(ui, view.text("program-page-set"));
        let small = |width| FieldStyle::text(width);
        field_ui(ui, view, ProgramField::Name, name.id, small(space(14.0)));
        let value = quiet(ui, "=");
        let give = view.text("program-page-give");
        let font = theme::font(sizes().body);
        let room = ui.painter().layout_no_wrap(give.clone(), font, palette(ui.ctx()).text.0).size().x;
        let width = (ui.available_width() - room - space(12.0)).max(space(8.0));
        let id = value.id;
        value.widget_info(|| WidgetInfo::labeled(Role::Label, true, view.text("program-page-value")));
        field_ui(ui, view, ProgramField::Value, id, small(width));
        let button = Button::new(give).min_size(vec2(0.0, control(ui)));
        view.button_as(ui, ProgramAction::GiveValue, button);
    });
    error_ui(ui, view, ProgramField::Name);
    error_ui(ui, view, ProgramField::Value);
    let given: Vec<_> = view.session.program().given().map(|(parameter, value)| (parameter, figure(value))).collect();
    if given.is_empty() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        quiet(ui, view.text("program-page-given"));
        for (parameter, value) in given {
            let text = format!("{parameter} = {}", view.words.number(&value));
            let hint = view.text("program-page-drop");
            let name = format!("{text}, {hint}");
            if ui.button(format!("{text}  ×")).accessible_name(name).on_hover_text(hint).clicked() {
                view.send(ProgramCommand::DropValue(parameter));
            }
        }
    });
}

/// A value as it is listed: a number at most to the sixth decimal, which is a nanometre. The run computes with all of them.
fn figure(value: &Value) -> String {
    let Value::Number(number) = value else { return shown(value) };
    let text = format!("{number:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// `▪ Q153  measured diameter  25.0105`, with a button that keeps it at the top.
fn row_ui(ui: &mut Ui, view: &mut View<'_>, watched: &Watched<'_>, height: f32) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width() - space(2.5), height), Sense::hover());
    let palette = palette(ui.ctx());
    let name = match view.session.program().name_of(watched.parameter) {
        Some(Name::Control(id)) => view.text(id),
        Some(Name::Program(name)) => name.to_owned(),
        None => String::new(),
    };
    let value = match watched.value {
        Some(value @ Value::Text(_)) => shown(value),
        Some(value) => view.words.number(&figure(value)),
        None => view.text("program-page-undefined"),
    };
    if watched.is_changed {
        changed_mark(ui, rect);
    }
    let font = |is_bold: bool| if is_bold { theme::bold(sizes().body) } else { theme::font(sizes().body) };
    let painter = ui.painter().with_clip_rect(rect);
    let pin = Rect::from_min_max(pos2(rect.right() - space(6.0), rect.top()), rect.max);
    let y = rect.center().y;
    let text = watched.parameter.to_string();
    painter.text(pos2(rect.left() + space(3.5), y), Align2::LEFT_CENTER, text, font(true), palette.text.0);
    let value_rect = painter.text(
        pos2(pin.left() - space(1.5), y),
        Align2::RIGHT_CENTER,
        &value,
        font(watched.is_changed),
        palette.text.0,
    );
    let room = Rect::from_min_max(
        pos2(rect.left() + space(16.0), rect.top()),
        pos2((value_rect.left() - space(2.0)).max(rect.left()), rect.bottom()),
    );
    let font = theme::font(sizes().small);
    let mut job = LayoutJob::simple_singleline(name.clone(), font, palette.quiet.0);
    job.wrap = TextWrapping::truncate_at_width(room.width().max(0.0));
    let galley = ui.painter().layout_job(job);
    let at = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    ui.painter().galley(at.min, galley, palette.quiet.0);
    let changed = if watched.is_changed { "program-page-parameter-changed" } else { "program-page-parameter" };
    let said = Message::new(changed).text("parameter", watched.parameter).text("name", &name).text("value", &value);
    let said = view.words.say(&said);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
    if !name.is_empty() {
        response.on_hover_text(&name);
    }
    pin_ui(ui, view, watched, pin);
}

/// The mark of a changed value: a square before it.
fn changed_mark(ui: &Ui, rect: Rect) {
    let palette = palette(ui.ctx());
    let mark = Rect::from_center_size(pos2(rect.left() + space(1.5), rect.center().y), vec2(space(1.5), space(1.5)));
    ui.painter().rect_filled(mark, 0.0, palette.data.0);
}

fn pin_ui(ui: &mut Ui, view: &mut View<'_>, watched: &Watched<'_>, rect: Rect) {
    let id = if watched.is_pinned { "program-page-unpin" } else { "program-page-pin" };
    let message = Message::new(id).text("parameter", watched.parameter);
    let name = view.words.say(&message);
    let text = RichText::new(if watched.is_pinned { "−" } else { "+" });
    let button = Button::new(text).frame(false).min_size(rect.size());
    let button = ui.put(rect, button);
    let button = shapes::ringed(ui, button, palette(ui.ctx()).focus.0);
    if button.accessible_name(name.clone()).on_hover_text(name).clicked() {
        view.send(ProgramCommand::Pin(watched.parameter, !watched.is_pinned));
    }
}
