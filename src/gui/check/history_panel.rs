//! Bottom: earlier checks. A title row with the filter, and the list below it; on a small window a strip with the last
//! ones.

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Color32, Frame, Id, Key, Margin, RichText, Sense, Ui, WidgetInfo, vec2};

use super::history_list::{self, list_ui};
use super::rows_panel;
use crate::gui::field::{self, FieldStyle, field_ui};
use crate::gui::shapes::{self, Edge};
use crate::gui::spoken::icon_ui;
use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::top_bar::export_ui;
use crate::gui::verdict_card::colours;
use crate::gui::view::{Digits, View, heading, quiet, remembered};
use crate::journal::Record;
use crate::journal::query::callout;
use crate::message::{Message, message};
use crate::session::{CheckAction, CheckField, Field, WindowAction, status_text};

/// How many checks the strip shows.
const LAST: usize = 4;

/// The room that one of them and the number of checks need: a measured one, and a simulated one, which says so.
const LEAST: [f32; 2] = [56.0, 84.0];

/// From this height on the tools may take another line.
const HIGH: f32 = 50.0;

fn unfolded_id() -> Id {
    Id::unique("history-unfolded")
}

/// Whether the user opened the list on a small window. Going to its filter opens it.
pub(super) fn is_unfolded(ui: &Ui) -> bool {
    if ui.memory(|memory| memory.has_focus(field::id(CheckField::HistoryFilter))) {
        ui.data_mut(|data| data.insert_temp(unfolded_id(), true));
    }
    remembered(ui, unfolded_id())
}

/// The heading; on a small window a button that folds and unfolds.
fn title_ui(ui: &mut Ui, view: &View<'_>, can_fold: bool) {
    if !can_fold {
        heading(ui, view.text("history"));
        return;
    }
    let open = is_unfolded(ui);
    let text = RichText::new(view.text("history")).font(theme::bold(sizes().heading));
    if ui.add(Button::new(text).selected(open)).clicked() {
        ui.data_mut(|data| data.insert_temp(unfolded_id(), !open));
        ui.ctx().request_repaint();
    }
}

/// Title row and list.
pub(super) fn history_ui(ui: &mut Ui, view: &mut View<'_>, can_fold: bool) {
    ui.horizontal_wrapped(|ui| {
        rows_panel::switch_ui(ui, view);
        title_ui(ui, view, can_fold);
        let short = Short::of(ui, view);
        if short < Short::Count {
            quiet(ui, count_text(view));
        }
        if !view.session.history().is_empty() {
            ui.separator();
            filter_ui(ui, view, short);
            view.checkbox(ui, CheckAction::OnlyBad);
            tools_ui(ui, view, short);
            if let Some(chosen) = chosen_text(view) {
                quiet(ui, chosen);
            }
        }
    });
    if view.session.history().is_empty() {
        quiet(ui, view.text("history-empty"));
    } else {
        list_ui(ui, view);
    }
}

/// How many checks there are, and how many of them are listed.
fn count_text(view: &View<'_>) -> String {
    let history = view.session.history();
    let shown = history.listed().count();
    let count = history.len();
    let said = if shown == count { "history-count" } else { "history-shown" };
    view.words.say(&Message::new(said).count("shown", shown).count("count", count))
}

/// What is left of the tools where their line is short: one after the other becomes a sign, and at last the count goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Short {
    Nothing,
    Correct,
    Filter,
    Export,
    Count,
}

impl Short {
    const ALL: [Self; 5] = [Self::Nothing, Self::Correct, Self::Filter, Self::Export, Self::Count];

    /// The first that fits into what is left of the line. A high list has room for another line.
    fn of(ui: &Ui, view: &View<'_>) -> Self {
        let room = ui.available_size_before_wrap().x;
        if space(HIGH) <= ui.clip_rect().height() {
            return Self::Nothing;
        }
        Self::ALL.into_iter().find(|short| short.width(ui, view) <= room).unwrap_or(Self::Count)
    }

    /// The width of the filter.
    fn filter(self) -> f32 {
        space(if self < Self::Filter { 40.0 } else { 24.0 })
    }

    /// How wide everything behind the title is.
    fn width(self, ui: &Ui, view: &View<'_>) -> f32 {
        let wide = |text: String, size: f32| {
            ui.painter().layout_no_wrap(text, theme::font(size), Color32::PLACEHOLDER).size().x
        };
        let body = |id: &str| wide(view.text(id), sizes().body);
        let padded = |width: f32| width + 2.0 * ui.spacing().button_padding.x;
        let sign = space(5.0);
        let filter = if self < Self::Filter { body("history-filter") } else { sign };
        let check = ui.spacing().icon_width + ui.spacing().icon_spacing + body("history-only-bad");
        let export = padded(if self < Self::Export { body("export") } else { sign });
        let words = view.width_of(ui, &[CheckAction::CorrectCheck]);
        let correct = if self < Self::Correct { words } else { padded(sign).max(control(ui)) };
        let correct = view.session.recording().is_on().then_some(correct);
        let count = (self < Self::Count).then(|| wide(count_text(view), sizes().small));
        let chosen = chosen_text(view).map(|chosen| wide(chosen, sizes().small));
        // A separator is so wide.
        let all = [Some(6.0), Some(filter), Some(self.filter()), Some(check), Some(export), correct, count, chosen];
        all.into_iter().flatten().map(|width| width + ui.spacing().item_spacing.x).sum()
    }
}

/// What can be done with the checks: in words, or in signs where there is no room.
fn tools_ui(ui: &mut Ui, view: &mut View<'_>, short: Short) {
    let name = view.text("export");
    let shown =
        if short < Short::Export { RichText::new(&name) } else { Icon::DotsThree.text(Weight::Bold, space(5.0)) };
    let menu = theme::looking(ui, theme::tonal, |ui| ui.menu_button(shown, |ui| export_ui(ui, view)).response);
    menu.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    if Short::Export <= short {
        menu.on_hover_text(name);
    }
    if view.session.recording().is_on() {
        if short < Short::Correct {
            view.button(ui, CheckAction::CorrectCheck);
        } else {
            view.icon_button(ui, CheckAction::CorrectCheck, Icon::PencilSimple);
        }
    }
}

/// How many are chosen for export, and whether some of them are not in sight.
fn chosen_text(view: &View<'_>) -> Option<String> {
    let history = view.session.history();
    if history.chosen_count() == 0 {
        return None;
    }
    let mut said = view.words.say(&message!("history-chosen").count("count", history.chosen_count()));
    if 0 < history.hidden_count() {
        let hidden = message!("history-hidden").count("hidden", history.hidden_count());
        said = format!("{said}, {}", view.words.say(&hidden));
    }
    Some(said)
}

/// The filter; Escape empties it and goes to the list.
fn filter_ui(ui: &mut Ui, view: &mut View<'_>, short: Short) {
    let text = view.text("history-filter");
    let name = if short < Short::Filter {
        ui.label(text)
    } else {
        let sign = icon_ui(ui, Icon::FunnelSimple, Weight::Regular, space(5.0), palette(ui.ctx()).text.0);
        sign.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
        sign
    };
    let look = FieldStyle::text(short.filter());
    let filter = field_ui(ui, view, CheckField::HistoryFilter, name.id, look);
    let left = filter.lost_focus() && ui.input(|input| input.key_pressed(Key::Escape));
    // A notice over the page takes Escape first.
    if left && !view.session.can(WindowAction::Close) {
        view.send(Field::from(CheckField::HistoryFilter).typed(String::new()));
        ui.memory_mut(|memory| memory.request_focus(history_list::id()));
    }
    filter.on_hover_text(view.text("history-filter-hint"));
}

/// One line instead of the list, where there is no room for it.
pub(super) fn strip_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        rows_panel::switch_ui(ui, view);
        title_ui(ui, view, true);
        for record in view.session.history().iter().rev().take(LAST) {
            let [measured, simulated] = LEAST.map(space);
            let is_simulated = record.measurement.origin.is_simulated();
            if (if is_simulated { simulated } else { measured }) <= ui.available_width() {
                last_ui(ui, view, record);
            }
        }
        let count = view.session.history().len();
        quiet(ui, view.words.say(&message!("history-count").count("count", count)));
    });
}

/// One of the last checks: shape, callout and value; a simulated one is pale, framed by dashes, and says so.
fn last_ui(ui: &mut Ui, view: &View<'_>, record: &Record) {
    let status = record.verdict.status();
    let is_simulated = record.measurement.origin.is_simulated();
    let edge = Edge::of(record);
    let (fill, colour) = colours(palette(ui.ctx()), Some(status), edge);
    let value = Digits::of(record).mm(view.words, record.measurement.diameter, 3);
    let mut shown = format!("{}  {value}", callout(record));
    if is_simulated {
        shown = format!("{}  {shown}", view.text("simulated"));
    }
    let frame = Frame::new().fill(fill).corner_radius(3.0).inner_margin(Margin::symmetric(6, 2));
    let chip = frame.show(ui, |ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(space(4.0), space(4.0)), Sense::hover());
        shapes::status(ui.painter(), rect, Some(status), colour);
        let label = ui.label(RichText::new(shown).color(colour));
        let said = format!("{}, {}, {value} mm", status_text(record, view.words), callout(record));
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
    });
    shapes::edge(ui.painter(), (chip.response.rect, 3.0), edge, colour);
    chip.response.on_hover_text(status_text(record, view.words));
}
