//! The window for an operator: one bar, what is asked at the left, and the verdict at the right, for fingers, gloves and two metres.
//!
//! | file | what |
//! |---|---|
//! | here | the frame: bar, left, right |
//! | `bar` | what can be opened, what is measured, who measures; Undo, keypad, and the way out |
//! | `check` | one size by its callout |
//! | `part` | a part, feature by feature |
//! | `asked` | left: the value and the keypad, over the button that Enter is for |
//! | `verdict` | the word, as large as its language fits |
//! | `below` | right, below: the band over what was asked for: reasons, features, the picture, the last results |
//! | `results`, `result` | what was measured last; one of them with its reasons |
//! | `lock` | the way out, where a PIN locks it |
//! | `names` | who measures |
//! | `question` | at the first touch: whom this window is for |
//!
//! Pages and their state are those of the full mode. What an operator cannot do is no possible action (`session::action::operator`).

mod asked;
mod bar;
mod below;
mod check;
mod lock;
mod names;
mod part;
mod question;
mod result;
mod results;
mod verdict;

use eframe::egui::{CentralPanel, Frame, Margin, Panel, Ui};

pub(super) use self::question::question_ui;

use super::pages::page_of;
use super::shapes::times;
use super::theme;
use super::view::View;
use crate::session::{CheckField, Command, Field, Page, WalkField};

/// What lies over the page leaves the buttons at its foot free.
pub(super) const FOOT: f32 = 64.0;

/// Below this width cards come closer to each other.
const NARROW: f32 = 900.0;

/// The share of the width that the left column has, and its limits.
const LEFT: f32 = 0.36;
const LEFT_LIMITS: [f32; 2] = [284.0, 520.0];

/// What is pressed is as high as 20 mm where the screen's ruler is known (Colle and Hiszem 2004), and 48 points at least.
fn target(view: &View<'_>) -> f32 {
    view.session.points(20.0).map_or(48.0, |points| points.max(48.0))
}

/// Between two cards.
fn gap(ui: &Ui) -> i8 {
    if ui.ctx().content_rect().width() < NARROW { 8 } else { 12 }
}

/// The bar and the open page.
pub(super) fn operator_ui(ui: &mut Ui, view: &mut View<'_>) {
    dropped_ui(ui, view);
    bar::bar_ui(ui, view);
    let canvas = Frame::new().fill(theme::palette(ui.ctx()).canvas.0).inner_margin(gap(ui));
    CentralPanel::default().frame(canvas).show(ui, |ui| match view.session.page() {
        _ if view.session.settings_page().asks_for_pin() => lock::lock_ui(ui, view),
        _ if names::is_open(ui) => names::names_ui(ui, view),
        Page::Records if results::is_open(ui) => result::result_ui(ui, view),
        Page::Records => results::results_ui(ui, view),
        Page::Parts => part::part_ui(ui, view),
        Page::Help => (page_of(Page::Help).ui)(ui, view),
        _ => check::check_ui(ui, view),
    });
}

/// The field that a page asks for has the focus.
fn go_to_value(view: &mut View<'_>, page: Page) {
    let session = view.session;
    let field: Field = match page {
        Page::Parts if session.parts().walking.is_begun() => WalkField::Value.into(),
        Page::Parts => WalkField::Serial.into(),
        Page::Check if session.check().asked.limits.is_some() => CheckField::Measured.into(),
        Page::Check => CheckField::Callout.into(),
        _ => return,
    };
    view.send(Command::GoTo(field));
}

/// Files are for the full window: whoever drops one is told.
fn dropped_ui(ui: &Ui, view: &mut View<'_>) {
    for file in ui.input(|input| input.raw.dropped_files.clone()) {
        let path = file.path();
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        view.send(Command::DroppedOnOperator(name));
    }
}

/// What is asked at the left, and the answer right of it.
fn sides_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    left: impl FnOnce(&mut Ui, &mut View<'_>),
    right: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    let margin = Margin { right: gap(ui), ..Margin::ZERO };
    let gap = f32::from(gap(ui));
    ui.spacing_mut().item_spacing.y = gap;
    // Four keys beside each other; the verdict keeps half of the width.
    let keys = times(target(view), 4) + times(gap, 4);
    let most = ui.available_width() * 0.5;
    let width = (ui.available_width() * LEFT).clamp(LEFT_LIMITS[0], LEFT_LIMITS[1]).max(keys.min(most));
    let panel = Panel::left("operator-asked").resizable(false).exact_size(width + gap).show_separator_line(false);
    panel.frame(Frame::new().inner_margin(margin)).show(ui, |ui| left(ui, view));
    right(ui, view);
}
