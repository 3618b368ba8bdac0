//! The bar: what can be opened, what is measured, who measures; at its end Undo, the keypad, and the way out.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Frame, Layout, Margin, Panel, Rect, Response, RichText, Sense, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use super::{names, results};
use crate::gui::rail::paint_item;
use crate::gui::shapes::{self, Edge, times};
use crate::gui::theme::{self, Icon, control, palette, sizes, space};
use crate::gui::verdict_card::colours;
use crate::gui::view::{View, quiet_text};
use crate::message::{Message, message};
use crate::session::help::{HelpPlace, HelpTopic};
use crate::session::parts::Walking;
use crate::session::{Action, CheckField, Command, HelpCommand, Page, RecordsField, SettingsAction, WindowAction};

/// The operator's page of the manual.
const PAGE: &str = "operator.md";

const HEIGHT: f32 = 68.0;

/// The width of an item.
const ITEM: f32 = 68.0;

/// From this width of the window on there is room for the balloons of a part.
const BALLOONS: f32 = 900.0;

/// As many features are shown one by one.
const MOST: usize = 12;

pub(super) fn bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    let palette = palette(ui.ctx());
    let frame = Frame::new().fill(palette.surface.0).inner_margin(Margin::symmetric(8, 0));
    let panel = Panel::top("operator-bar").resizable(false).exact_size(HEIGHT).frame(frame);
    panel.show(ui, |ui| {
        ui.horizontal_centered(|ui| {
            ui.spacing_mut().item_spacing.x = space(1.0);
            pages_ui(ui, view);
            ui.separator();
            // As wide as what follows, so that it ends at the right edge in reading order.
            let id = eframe::egui::Id::unique("operator-bar-right");
            let known: f32 = crate::gui::view::remembered(ui, id);
            let room = ui.available_width() - known - space(2.0);
            title_ui(ui, view, room);
            ui.add_space((ui.available_width() - known).max(0.0));
            let shown = ui.horizontal(|ui| right_ui(ui, view)).response.rect.width();
            if 0.5 < (shown - known).abs() {
                ui.data_mut(|data| data.insert_temp(id, shown));
                ui.ctx().request_discard("the width of the bar's end is known");
            }
        });
    });
}

/// Where one measures: in a part that was begun, or one size.
fn measuring(view: &View<'_>) -> Page {
    match view.session.page() {
        Page::Parts => Page::Parts,
        _ if view.session.parts().walking.is_begun() => Page::Parts,
        _ => Page::Check,
    }
}

fn pages_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.page();
    let is_measuring = matches!(page, Page::Check | Page::Parts);
    let pages = [
        (measuring(view), "operator-measure", Icon::Ruler, is_measuring),
        (Page::Records, "operator-results", Icon::ListChecks, page == Page::Records),
        (Page::Help, "page-help", Icon::Question, page == Page::Help),
    ];
    let shows_names = names::is_open(ui);
    for (page, name, icon, is_on) in pages {
        let name = view.text(name);
        let is_on = is_on && !shows_names;
        let is_open = page == Page::Records && results::is_open(ui);
        if item_ui(ui, (icon, &name), Some(is_on), true).clicked() && (!is_on || is_open) {
            names::open(ui, false);
            match page {
                Page::Help => view.send(HelpCommand::Open(HelpPlace::of(HelpTopic::Manual(PAGE)))),
                page => {
                    results::open(ui, None);
                    view.act(WindowAction::Open(page));
                    super::go_to_value(view, page);
                }
            }
        }
    }
}

/// An icon over its name; `is_on` where it is one of several, or a switch.
fn item_ui(ui: &mut Ui, (icon, name): (Icon, &str), is_on: Option<bool>, is_possible: bool) -> Response {
    let size = vec2(ITEM, HEIGHT - space(3.0));
    let sense = if is_possible { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(size, sense);
    let is_lit = is_on == Some(true);
    if !is_possible {
        ui.set_opacity(0.45);
    }
    paint_item(ui, rect, &response, (icon, Some(name)), is_lit);
    ui.set_opacity(1.0);
    response.widget_info(|| match is_on {
        Some(is_on) => WidgetInfo::selected(Role::Button, is_possible, is_on, name),
        None => WidgetInfo::labeled(Role::Button, is_possible, name),
    });
    response
}

/// The part and its serial number, where they are known.
fn title_ui(ui: &mut Ui, view: &View<'_>, room: f32) {
    let walking = &view.session.parts().walking;
    let is_part = view.session.page() == Page::Parts && walking.is_begun();
    let balloons = if is_part { balloons_width(ui, walking) } else { 0.0 };
    let width = (room - balloons).max(0.0);
    let column = vec2(width, HEIGHT);
    ui.allocate_ui_with_layout(column, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_width(width);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let [title, below] = titles(view, is_part);
            let lines = if below.is_empty() { 1.0 } else { 2.0 };
            ui.add_space(((HEIGHT - lines * sizes().title * 1.3) / 2.0).max(0.0));
            let title = RichText::new(title).font(theme::bold(sizes().limits));
            ui.add(eframe::egui::Label::new(title).truncate());
            if !below.is_empty() {
                let below = quiet_text(ui, below).size(sizes().body);
                ui.add(eframe::egui::Label::new(below).truncate());
            }
        });
    });
    if 0.0 < balloons {
        balloons_ui(ui, view, walking);
    }
}

fn titles(view: &View<'_>, is_part: bool) -> [String; 2] {
    let session = view.session;
    let walking = &session.parts().walking;
    if is_part {
        let part = walking.plan.as_ref().map_or_else(String::new, |plan| plan.head.part.clone());
        let name = if part.is_empty() { view.text("operator-part") } else { part };
        return [name, serial_text(view, walking.serial())];
    }
    let name = match session.page() {
        Page::Check => {
            let part = session.text(CheckField::Part).trim();
            let name = if part.is_empty() { view.text("operator-one-size") } else { part.to_owned() };
            return [name, serial_text(view, session.text(CheckField::Serial).trim())];
        }
        Page::Parts => "operator-part",
        Page::Records => "operator-results",
        _ => "page-help",
    };
    [view.text(name), String::new()]
}

fn serial_text(view: &View<'_>, serial: &str) -> String {
    if serial.is_empty() {
        return String::new();
    }
    view.words.say(&message!("walk-page-part-serial").text("serial", serial))
}

const BALLOON: f32 = 26.0;

fn balloons_width(ui: &Ui, walking: &Walking) -> f32 {
    if MOST < walking.count() || ui.ctx().content_rect().width() < BALLOONS {
        0.0
    } else {
        times(BALLOON, walking.count())
    }
}

/// How far the part is: a shape for each feature.
fn balloons_ui(ui: &mut Ui, view: &View<'_>, walking: &Walking) {
    let palette = palette(ui.ctx());
    let (rect, response) = ui.allocate_exact_size(vec2(times(BALLOON, walking.count()), HEIGHT), Sense::hover());
    for at in 0..walking.count() {
        let record = walking.counting(at).map(|value| value.record.as_ref());
        let status = record.map(|record| record.verdict.status());
        let edge = record.map_or(Edge::None, Edge::of);
        let (fill, text) = match status {
            None => (palette.surface.0, palette.text.0),
            status => colours(palette, status, edge),
        };
        let centre = pos2(rect.left() + times(BALLOON, at) + BALLOON / 2.0, rect.center().y);
        let is_asked = walking.faced() == Some(at);
        let line = if is_asked { Stroke::new(2.5, palette.focus.0) } else { Stroke::new(1.5, palette.edge.0) };
        shapes::outline(ui.painter(), centre, BALLOON * 0.36, status, (fill, line));
        if status.is_some() {
            let mark = Rect::from_center_size(centre, vec2(space(3.0), space(3.0)));
            shapes::status(ui.painter(), mark, status, text);
        } else {
            let number = (at + 1).to_string();
            ui.painter().text(centre, Align2::CENTER_CENTER, number, theme::font(sizes().tiny), text);
        }
    }
    let standing = walking.standing();
    let said = view.words.say(&crate::message::Say::message(&standing));
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &said));
}

fn right_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.x = space(1.0);
    record_state_ui(ui, view);
    who_ui(ui, view);
    let undo = Action::from(WindowAction::Undo);
    let name = view.text("operator-undo");
    // What is undone must be in sight.
    let is_measuring = matches!(view.session.page(), Page::Check | Page::Parts) && !names::is_open(ui);
    if item_ui(ui, (Icon::ArrowUUpLeft, &name), None, is_measuring && view.session.can(undo)).clicked() {
        view.act(undo);
    }
    let keypad = Action::from(WindowAction::Keypad);
    let name = keypad.text(view.session, view.words);
    if item_ui(ui, (Icon::Numpad, &name), keypad.is_on(view.session), true).clicked() {
        view.act(keypad);
    }
    let name = view.text("operator-leave");
    if item_ui(ui, (Icon::LockSimple, &name), None, true).clicked() {
        view.act(SettingsAction::LeaveOperator);
    }
}

/// Who measures; nothing where nothing is recorded.
fn who_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recording = view.session.recording();
    if !recording.is_on() {
        return;
    }
    let who = recording.who();
    let shown = if who.is_empty() { view.text("records-page-nobody") } else { who.to_owned() };
    let is_open = names::is_open(ui);
    let said = Message::new(if who.is_empty() { "records-page-who-nobody" } else { "records-page-who-is" });
    let said = view.words.say(&said.text("name", who));
    let response = item_ui(ui, (Icon::User, &shown), Some(is_open), true);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_open, &said));
    if response.clicked() {
        names::open(ui, !is_open);
        if !is_open {
            view.send(Command::GoTo(RecordsField::Who.into()));
        }
    }
}

/// Only what asks for a look: that checks are not recorded.
fn record_state_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recording = view.session.recording();
    if recording.has_failed_to_open() || 0 < recording.failed() {
        let text = RichText::new(view.text("top-not-recorded")).font(theme::bold(sizes().body));
        ui.label(text.color(palette(ui.ctx()).error.0));
        view.sized_button(ui, WindowAction::RecordAgain, vec2(0.0, control(ui)));
    }
}
