//! What every panel gets: the state, the words, and a place to put its commands.

use std::any::Any;
use std::fmt::Debug;
use std::hash::Hash;

use eframe::egui::accesskit::Role;
use eframe::egui::{self, Button, Color32, ComboBox, Key, Response, RichText, Ui, Vec2, WidgetInfo, WidgetText, vec2};
use egui_plot::Plot;

use super::action_icon::icon_of;
use super::key_names::{is_held, told};
use super::shapes;
use super::theme::{self, Icon, Weight, control};
use crate::journal::Record;
use crate::journal::entry::{BlockKept, DatumKept};
use crate::length::{Length, Unit};
use crate::message::{Message, Say as _, message};
use crate::probing::cycle::Angle;
use crate::session::{Action, Command, PartsAction, Session};
use crate::text::sentence;
use crate::verdict::{Doubt, Status};
use crate::words::Words;

/// The size of an icon in a button.
const ICON: f32 = 18.0;

/// What every panel is given.
pub(super) struct View<'a> {
    /// The state; never changed while drawing.
    pub session: &'a Session,
    /// The texts of the window's language.
    pub words: &'a Words,
    /// What the user did in this frame.
    pub commands: Vec<Command>,
}

impl View<'_> {
    /// Sends a command.
    pub fn send(&mut self, command: impl Into<Command>) {
        self.commands.push(command.into());
    }

    /// A text by name.
    pub fn text(&self, id: &str) -> String {
        self.words.get(id)
    }

    /// Does an action, as its button and its keys do; nothing where it is not possible.
    pub fn act(&mut self, action: impl Into<Action>) {
        let action = action.into();
        self.commands.extend(action.command(self.session));
    }

    /// Draws an action as a button.
    pub fn button(&mut self, ui: &mut Ui, action: impl Into<Action>) -> Response {
        self.sized_button(ui, action, Vec2::ZERO)
    }

    /// Draws an action as a button of another look.
    pub fn button_as(&mut self, ui: &mut Ui, action: impl Into<Action>, button: Button<'_>) -> Response {
        let action = action.into();
        let is_possible = self.session.can(action);
        let response = theme::looking(ui, theme::tonal, |ui| ui.add_enabled(is_possible, button));
        self.pressed(ui, action, response)
    }

    /// Draws an action as a button with its icon and its name; filled with a colour, in the colour of texts on it.
    fn named_button(&mut self, ui: &mut Ui, action: Action, size: Vec2, filled: Option<[Color32; 2]>) -> Response {
        let name = action.text(self.session, self.words);
        let mut text = RichText::new(&name);
        let mut icon = icon_of(action).map(|icon| icon.text(Weight::Regular, ICON));
        if let Some([_, on_it]) = filled {
            text = text.color(on_it).font(theme::bold(theme::sizes().body));
            icon = icon.map(|icon| icon.color(on_it));
        }
        let button = match icon {
            Some(icon) => Button::new((icon, text)),
            None => Button::new(text),
        };
        let button = match filled {
            Some([fill, _]) => button.fill(fill),
            None => button,
        };
        // The icon is no part of the name.
        self.button_as(ui, action, button.min_size(size)).accessible_name(name)
    }

    /// The same, at least of a size.
    pub fn sized_button(&mut self, ui: &mut Ui, action: impl Into<Action>, size: Vec2) -> Response {
        self.named_button(ui, action.into(), size, None)
    }

    /// Draws an action as an icon, named under the pointer.
    pub fn icon_button(&mut self, ui: &mut Ui, action: impl Into<Action>, icon: Icon) -> Response {
        let action = action.into();
        let name = action.text(self.session, self.words);
        self.icon_button_named(ui, action, icon, &name)
    }

    /// The same under a name that does not change; what the action would do shows under the pointer.
    pub fn icon_button_named(&mut self, ui: &mut Ui, action: impl Into<Action>, icon: Icon, name: &str) -> Response {
        let action = action.into();
        let side = control(ui);
        let button = Button::new(icon.text(Weight::Regular, theme::space(5.0))).min_size(vec2(side, side));
        let is_possible = self.session.can(action);
        let response = theme::looking(ui, theme::plain, |ui| ui.add_enabled(is_possible, button));
        let hint = action.text(self.session, self.words);
        let response = response.accessible_name(name).on_hover_text(hint);
        self.pressed(ui, action, response)
    }

    /// The same for an action that is on or off.
    pub fn icon_toggle(&mut self, ui: &mut Ui, action: impl Into<Action>, icon: Icon) -> Response {
        let action = action.into();
        let name = action.text(self.session, self.words);
        let is_on = action.is_on(self.session) == Some(true);
        let button = Button::new(icon.text(Weight::Regular, theme::space(5.0))).selected(is_on);
        // It stands within a field, which would take the focus with the press.
        let button = button.sense(egui::Sense::click_and_drag());
        let button = button.min_size(Vec2::splat(control(ui))).frame_when_inactive(is_on);
        let is_possible = self.session.can(action);
        let response = theme::looking(ui, theme::tonal, |ui| ui.add_enabled(is_possible, button));
        response.widget_info(|| WidgetInfo::selected(Role::Button, is_possible, is_on, &name));
        let response = response.on_hover_text(name);
        self.pressed(ui, action, response)
    }

    /// Does an action where its button was pressed. Its keys show under the pointer.
    fn pressed(&mut self, ui: &Ui, action: Action, mut response: Response) -> Response {
        let keys = action.shortcut_shown(self.session.page()).map(|keys| told(ui, keys));
        let hint: Vec<String> = action.hint().map(|id| self.text(id)).into_iter().chain(keys).collect();
        if !hint.is_empty() {
            response = response.on_hover_text(hint.join("\n"));
        }
        // A key that is held on a button answers no question either.
        if response.clicked() && !(action == PartsAction::NextPart.into() && is_held(ui)) {
            match self.session.answers().iter().position(|answer| *answer == action) {
                Some(place) => self.send(Command::Answer(place)),
                None => self.act(action),
            }
        }
        response
    }

    /// Draws an action as a button as high as a text field.
    pub fn field_button(&mut self, ui: &mut Ui, action: impl Into<Action>) -> Response {
        self.sized_button(ui, action, vec2(0.0, control(ui)))
    }

    /// The same for an action that is on or off: pressed in while it is on.
    pub fn toggle(&mut self, ui: &mut Ui, action: impl Into<Action>) -> Response {
        let action = action.into();
        let is_on = action.is_on(self.session) == Some(true);
        let button =
            Button::new(action.text(self.session, self.words)).selected(is_on).min_size(vec2(0.0, control(ui)));
        self.button_as(ui, action, button)
    }

    /// The same for a dialog: as wide as the others beside it.
    pub fn wide_button(&mut self, ui: &mut Ui, action: impl Into<Action>) -> Response {
        self.sized_button(ui, action, vec2(theme::space(24.0), control(ui)))
    }

    /// The answers to what the page asks, the highlighted one first: Enter gives that one.
    pub fn answers_ui(&mut self, ui: &mut Ui, size: Vec2) {
        for action in self.session.answers() {
            self.main_button(ui, action, size);
        }
    }

    /// The page's main action, in this size. While something is asked, only what Enter does looks like one.
    pub fn main_button(&mut self, ui: &mut Ui, action: impl Into<Action>, size: Vec2) -> Response {
        let action = action.into();
        if self.session.answers().first().is_some_and(|first| *first != action) {
            return self.sized_button(ui, action, size);
        }
        let palette = theme::palette(ui.ctx());
        let response = self.named_button(ui, action, size, Some([palette.accent.0, palette.on_accent.0]));
        if response.has_focus() {
            // The usual ring has the colour of the button.
            let rect = response.rect.expand(1.0);
            let stroke = egui::Stroke::new(2.0, palette.accent.0);
            ui.painter().rect_stroke(rect, 5.0, stroke, egui::StrokeKind::Outside);
        }
        response
    }

    /// The width of a main button that has room for each of these actions, so that it stays where it is when its
    /// word changes.
    pub fn width_of(&self, ui: &Ui, actions: &[impl Into<Action> + Copy]) -> f32 {
        let width = |action: Action| {
            let text = action.text(self.session, self.words);
            let font = theme::bold(theme::sizes().body);
            let icon = icon_of(action).map_or(0.0, |_| ICON + ui.spacing().icon_spacing);
            icon + ui.painter().layout_no_wrap(text, font, egui::Color32::PLACEHOLDER).size().x
        };
        let widest = actions.iter().map(|action| width((*action).into())).fold(0.0, f32::max);
        (widest + 2.0 * ui.spacing().button_padding.x).ceil()
    }

    /// Draws an action as an entry of a menu, followed by its keys.
    pub fn menu_item(&mut self, ui: &mut Ui, action: impl Into<Action>) {
        let action = action.into();
        let name = action.text(self.session, self.words);
        let mut button = Button::new(&name);
        if let Some(keys) = action.shortcut_on(self.session.page()) {
            button = button.shortcut_text(told(ui, keys));
        }
        if ui.add_enabled(self.session.can(action), button).accessible_name(name).clicked() {
            self.act(action);
            ui.close();
        }
    }

    /// Three dots that open a menu of what is used less often.
    pub fn more_ui(&mut self, ui: &mut Ui, content: impl FnOnce(&mut Ui, &mut Self)) {
        let name = self.text("rail-more");
        theme::looking(ui, theme::plain, |ui| {
            ui.spacing_mut().interact_size.y = control(ui);
            let icon = Icon::DotsThree.text(Weight::Bold, theme::space(5.0));
            let shown = ui.menu_button(icon, |ui| content(ui, self)).response;
            shown.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            shown.on_hover_text(name);
        });
    }

    /// Draws an action as one of several choices; returns whether it was taken.
    pub fn radio(&mut self, ui: &mut Ui, action: impl Into<Action>) -> bool {
        let action = action.into();
        let is_on = action.is_on(self.session).unwrap_or(false);
        let is_taken = ui.radio(is_on, action.text(self.session, self.words)).clicked();
        if is_taken {
            self.act(action);
        }
        is_taken
    }

    /// Draws an action that switches something on and off.
    pub fn checkbox(&mut self, ui: &mut Ui, action: impl Into<Action>) {
        let action = action.into();
        let mut is_on = action.is_on(self.session).unwrap_or(false);
        if ui.checkbox(&mut is_on, action.text(self.session, self.words)).clicked() {
            self.act(action);
        }
    }
}

/// How exactly a record's figures are shown.
///
/// A typed or imported value is shown as it was given. A measured circle has more digits than are meaningful: it is
/// shown to 0.1 µm, as the control does, unless that would hide on which side of a limit it lies. Only the exact value
/// decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Digits {
    Exact,
    Rounded,
}

impl Digits {
    pub fn of(record: &Record) -> Self {
        let size = &record.verdict.size;
        match record.measurement.circle {
            Some(_) => Self::of_distances(&[size.above_minimum, size.below_maximum]),
            None => Self::Exact,
        }
    }

    /// The digits for a computed value at these distances from its limits.
    pub fn of_distances(distances: &[Length]) -> Self {
        let near = |distance: &Length| distance.abs() < Length::from_micrometres(1) && *distance != Length::ZERO;
        if distances.iter().any(near) { Self::Exact } else { Self::Rounded }
    }

    /// A size in millimetres with at least this many decimals.
    pub fn mm(self, words: &Words, length: Length, decimals: usize) -> String {
        match self {
            Self::Exact => words.mm(length, decimals),
            Self::Rounded => words.number(&length.rounded(Unit::Millimetre, 4)),
        }
    }

    /// A distance in micrometres without its sign.
    pub fn um(self, words: &Words, length: Length) -> String {
        match self {
            Self::Exact => words.um(length),
            Self::Rounded => words.number(&length.rounded(Unit::Micrometre, 1)),
        }
    }

    /// A deviation in micrometres with its sign, none on zero.
    pub fn signed_um(self, words: &Words, length: Length) -> String {
        let text = self.um(words, length);
        let is_zero = !text.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
        if Length::ZERO < length && !is_zero { format!("+{text}") } else { text }
    }
}

/// A heading for a part of the page.
pub(super) fn heading(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    ui.label(RichText::new(text).font(theme::bold(theme::sizes().heading)))
}

/// Secondary text.
pub(super) fn quiet(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    let text = quiet_text(ui, text);
    ui.label(text)
}

pub(super) fn quiet_text(ui: &Ui, text: impl Into<String>) -> RichText {
    RichText::new(text).color(theme::palette(ui.ctx()).quiet.0).size(theme::sizes().small)
}

/// Secondary text in one line, cut where there is no room; the whole text shows under the pointer.
pub(super) fn quiet_cut(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    ui.add(egui::Label::new(quiet_text(ui, text)).truncate())
}

/// Secondary text of a given width, whole: it goes on in another line where one is too short.
pub(super) fn quiet_within(ui: &mut Ui, text: impl Into<String>, width: f32) -> egui::Response {
    let row = vec2(width, ui.available_height());
    let within = ui.allocate_ui_with_layout(row, egui::Layout::left_to_right(egui::Align::Center), |ui| {
        ui.set_min_width(width);
        ui.add(egui::Label::new(quiet_text(ui, text)).wrap())
    });
    within.inner
}

pub(super) fn quiet_height(ui: &Ui, text: &str, width: f32) -> f32 {
    let font = theme::font(theme::sizes().small);
    ui.painter().layout(text.to_owned(), font, egui::Color32::PLACEHOLDER, width).size().y
}

/// Where the zero of a datum is and how its axes lie, each with the block that has set it.
pub(super) fn datum_lines(words: &Words, datum: &DatumKept) -> Vec<String> {
    let set = if datum.set_by.is_some() { "records-page-datum-set" } else { "records-page-datum-at" };
    let ids = [set, "records-page-datum-rotation", "records-page-datum-tilt"];
    let of_block = |(said, block): (Message, Option<&BlockKept>)| match block {
        Some(block) => words.say(&said.text("line", block.line).text("block", &block.text)),
        None => words.say(&said),
    };
    datum_said(words, datum, ids).into_iter().map(of_block).collect()
}

/// The same in one line, with the line of each block.
pub(super) fn datum_text(words: &Words, datum: &DatumKept) -> String {
    let with_line = |(said, block): (Message, Option<&BlockKept>)| match block {
        Some(block) => {
            let line = words.say(&message!("rows-row-line").text("line", block.line));
            format!("{} ({line})", words.say(&said))
        }
        None => words.say(&said),
    };
    let ids = ["program-page-zero", "program-page-turned", "program-page-tilted"];
    datum_said(words, datum, ids).into_iter().map(with_line).collect::<Vec<_>>().join(", ")
}

/// Zero, rotation and tilt by the texts that say them, as far as there are any.
fn datum_said<'a>(
    words: &Words,
    datum: &'a DatumKept,
    [zero, rotation, tilt]: [&'static str; 3],
) -> Vec<(Message, Option<&'a BlockKept>)> {
    let [x, y, z] = datum.zero.map(|axis| words.mm(axis, 3));
    let zero = Message::new(zero).text("x", x).text("y", y).text("z", z);
    let angle = |degrees: f64| words.number(&Angle::nearest(degrees).to_string().replace('°', ""));
    let rotation = datum.rotation.as_ref().map(|(degrees, block)| {
        let said = Message::new(rotation).text("angle", angle(*degrees));
        (said, Some(block))
    });
    let tilt = datum.tilt.as_ref().map(|(angles, block)| {
        let said = ["a", "b", "c"].into_iter().zip(angles);
        let said = said.fold(Message::new(tilt), |said, (name, degrees)| said.text(name, angle(*degrees)));
        (said, Some(block))
    });
    [Some((zero, datum.set_by.as_ref())), rotation, tilt].into_iter().flatten().collect()
}

/// A doubt about a measured value as a sentence of its own.
pub(super) fn doubt_text(words: &Words, doubt: Doubt) -> String {
    sentence(&words.say(&message!("doubt-sentence").message("doubt", doubt.message())))
}

/// A control's cycles judge by their limits alone: it is said where the check page has a rule or a temperature.
pub(super) fn by_limits_ui(ui: &mut Ui, view: &View<'_>) {
    if view.session.check().judges_by_more_than_limits() {
        quiet(ui, view.text("cycles-by-limits"));
    }
}

/// Text that says what is wrong.
pub(super) fn problem(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    let colour = theme::palette(ui.ctx()).error.0;
    ui.label(RichText::new(text).color(colour).size(theme::sizes().small))
}

/// The greatest height of a drop-down list: the rest scrolls, so that its end can always be reached.
pub(super) fn list_height(ui: &Ui) -> f32 {
    ui.ctx().content_rect().height() * 0.55
}

/// A drop-down list, with what is shown while it is closed; its caller names it.
pub(super) fn list_ui(
    ui: &mut Ui,
    salt: impl Hash + Debug,
    shown: impl Into<WidgetText>,
    width: f32,
    content: impl FnOnce(&mut Ui),
) -> Response {
    let list = ComboBox::from_id_salt(salt).selected_text(shown).width(width).truncate().height(list_height(ui));
    list.icon(caret_ui).show_ui(ui, content).response
}

/// The caret of a drop-down list.
pub(super) fn caret_ui(ui: &Ui, place: egui::Rect, look: &egui::style::WidgetVisuals, _is_open: bool) {
    Icon::CaretDown.paint(ui.painter(), place.center(), Weight::Bold, theme::space(3.5), look.fg_stroke.color);
}

/// A drop-down list of which one entry is chosen; its caller names it. Returns what was chosen just now.
pub(super) fn one_of_ui<T: PartialEq>(
    ui: &mut Ui,
    salt: impl Hash + Debug,
    width: f32,
    now: &T,
    entries: impl IntoIterator<Item = (T, String)>,
) -> (Option<T>, Response) {
    let entries: Vec<(T, String)> = entries.into_iter().collect();
    // None is chosen where what counts now is no entry.
    let shown = entries.iter().find(|(of, _)| of == now).map_or_else(String::new, |(_, text)| text.clone());
    let mut chosen = None;
    let list = list_ui(ui, salt, shown, width, |ui| {
        for (of, text) in entries {
            if ui.add(Button::selectable(of == *now, text).min_size(vec2(0.0, control(ui)))).clicked() {
                chosen = Some(of);
                ui.close();
            }
        }
    });
    (chosen, list)
}

/// Two columns: a name, and its figure.
pub(super) fn named_figures_ui(ui: &mut Ui, id: &'static str, rows: impl IntoIterator<Item = (String, String)>) {
    egui::Grid::new(id).num_columns(2).min_row_height(0.0).spacing(vec2(theme::space(4.0), 0.0)).show(ui, |ui| {
        for (name, figure) in rows {
            ui.label(name);
            ui.label(RichText::new(figure).font(theme::bold(theme::sizes().limits)));
            ui.end_row();
        }
    });
}

/// A line behind the shape of a verdict, to be clicked.
pub(super) fn marked_ui(ui: &mut Ui, (status, colour): (Option<Status>, egui::Color32), line: Button<'_>) -> Response {
    let line = ui.horizontal(|ui| {
        let (mark, _) = ui.allocate_exact_size(Vec2::splat(theme::space(4.0)), egui::Sense::hover());
        shapes::status(ui.painter(), mark, status, colour);
        let line = ui.add(line.frame(false).min_size(vec2(0.0, control(ui))));
        shapes::ringed(ui, line, theme::palette(ui.ctx()).focus.0)
    });
    line.inner
}

/// Keeps the focus on a list after a choice by key; after a choice by pointer, Enter does what it did before.
pub(super) fn keep_focus(ui: &Ui, list: &Response) {
    if ui.input(|input| input.key_pressed(Key::Space) || input.key_pressed(Key::Enter)) {
        list.request_focus();
    }
}

/// A part of a page whose widgets keep their ids, whatever stands before it: the focus stays where it is.
pub(super) fn steady<T>(ui: &mut Ui, id: impl Hash + Debug, content: impl FnOnce(&mut Ui) -> T) -> T {
    ui.scope_builder(egui::UiBuilder::new().scope_id(egui::Id::unique(("steady", id))), content).inner
}

/// What the window remembers under an id. Nobody has put anything there at first: then it is empty, false or zero.
pub(super) fn remembered<T: Any + Clone + Default + Send + Sync>(ui: &Ui, id: egui::Id) -> T {
    ui.data_mut(|data| data.get_temp_mut_or_default::<T>(id).clone())
}

/// Gives a list the focus in the next frame: in the frame of a click, whoever looks at the focused widget takes the focus
/// from it, because the row was clicked and not the list.
pub(super) fn focus_soon(ui: &Ui, id: egui::Id) {
    ui.data_mut(|data| data.insert_temp(id.with("focus-soon"), true));
    ui.ctx().request_repaint();
}

/// Takes the focus that was promised.
pub(super) fn take_focus(ui: &Ui, id: egui::Id) {
    if ui.data_mut(|data| std::mem::take(data.get_temp_mut_or_default::<bool>(id.with("focus-soon")))) {
        ui.memory_mut(|memory| memory.request_focus(id));
    }
}

/// A plot to look at only: it cannot be moved, and it leaves the mouse wheel to the page.
pub(super) fn still_plot<'a>(id: &'static str, height: f32) -> Plot<'a> {
    Plot::new(id)
        .height(height)
        .show_grid(false)
        .show_background(false)
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        // No stop for Tab: there is nothing to do in it.
        .sense(egui::Sense::hover())
        .label_formatter(|_| None)
}
