//! The features of the journal: where list, figures and charts stand.

use eframe::egui::{Id, Rect, Sense, Ui, UiBuilder, pos2};

use super::{aside_panel, asking_panel, chart_panel, features_list, figures_panel, signals_panel};
use crate::gui::card::page_card_ui;
use crate::gui::columns::{Side, bar_ui, column_ui, of_height, panel_ui, rest_ui};
use crate::gui::empty::empty_ui;
use crate::gui::key_names::part_id;
use crate::gui::keypad::keypad_ui;
use crate::gui::over_page::just_opened;
use crate::gui::segments::segments_ui;
use crate::gui::shapes::times;
use crate::gui::theme::{self, control, space};
use crate::gui::top_bar::folded_sides_ui;
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::message;
use crate::session::focused::FEATURES;
use crate::session::statistics::Aside;
use crate::session::{StatisticsAction, WindowAction};

/// From this width of the page on, features stand beside the charts.
const BESIDE: f32 = 800.0;

/// From this size of what is right of them on, every chart has a card.
const CARDS: [f32; 2] = [900.0, 600.0];

/// Between two cards.
const GAP: f32 = 12.0;

/// The features of the journal.
pub(super) fn features_ui(ui: &mut Ui, view: &mut View<'_>) {
    if just_opened(ui, Id::unique("statistics-page")) {
        ui.memory_mut(|memory| memory.request_focus(part_id(FEATURES)));
    }
    if !view.session.recording().is_on() {
        return rest_ui(ui, view, |ui, view| {
            folded_sides_ui(ui, view);
            empty_ui(ui, view, "statistics-page-off", &[WindowAction::Open(crate::session::Page::Check).into()]);
        });
    }
    bar_ui(ui, view, Side::Top, "statistics-asking", asking_panel::asking_ui);
    keypad_ui(ui, view);
    if view.session.statistics().open().is_none() {
        return rest_ui(ui, view, nothing_ui);
    }
    let width = ui.available_width();
    if BESIDE <= width {
        let sizes = ((width * 0.18).clamp(space(52.0), space(80.0)), space(40.0)..=width * 0.35);
        panel_ui(ui, view, Side::Left, "statistics-features", sizes, features_list::list_ui);
    }
    let size = ui.available_size();
    if BESIDE <= width && CARDS[0] <= size.x && CARDS[1] <= size.y {
        cards_ui(ui, view);
    } else {
        rest_ui(ui, view, |ui, view| column_ui(ui, "statistics", |ui| one_ui(ui, view, width < BESIDE)));
    }
}

/// Why there is nothing to see.
fn nothing_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    heading(ui, view.text("page-statistics"));
    if let Some(why) = &page.problem {
        problem(ui, view.words.say(&message!("statistics-page-not-read").message("why", why.clone())));
    } else {
        quiet(ui, view.text(if page.is_working() { "statistics-page-reading" } else { "statistics-page-none" }));
    }
}

/// A part of the page in a card of its own.
fn card_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect, content: impl FnOnce(&mut Ui, &mut View<'_>)) {
    let mut child =
        ui.new_child(UiBuilder::new().max_rect(rect).id_salt((rect.left().to_bits(), rect.top().to_bits())));
    page_card_ui(&mut child, |ui| content(ui, view));
}

/// Every chart in a card: figures, the chart beside the histogram, and three cards below.
fn cards_ui(ui: &mut Ui, view: &mut View<'_>) {
    let all = ui.available_rect_before_wrap();
    let top = figures_panel::height(ui);
    let below = ((all.height() - top - 2.0 * GAP) * 0.43).round();
    let figures = Rect::from_min_max(all.min, pos2(all.right(), all.top() + top));
    let chart =
        Rect::from_min_max(pos2(all.left(), figures.bottom() + GAP), pos2(all.right(), all.bottom() - below - GAP));
    card_ui(ui, view, figures, |ui, view| figures_panel::figures_ui(ui, view));
    card_ui(ui, view, chart, |ui, view| {
        let room = ui.available_rect_before_wrap();
        let (left, right) = room.split_left_right_at_x(room.right() - (room.width() * 0.22).round());
        let mut child = ui.new_child(UiBuilder::new().max_rect(left.with_max_x(left.right() - GAP)));
        chart_panel::chart_ui(&mut child, view);
        let mut child = ui.new_child(UiBuilder::new().max_rect(right));
        aside_panel::aside_ui(&mut child, view, Aside::Histogram);
    });
    let width = (all.width() - 2.0 * GAP) / 3.0;
    for (place, aside) in [Aside::Spread, Aside::Probability, Aside::Signals].into_iter().enumerate() {
        let left = all.left() + times(width + GAP, place);
        let rect = Rect::from_min_max(pos2(left, all.bottom() - below), pos2(left + width, all.bottom()));
        card_ui(ui, view, rect, |ui, view| aside_panel::aside_ui(ui, view, aside));
    }
    ui.allocate_rect(all, Sense::hover());
}

/// Everything below each other, with one of the smaller charts at a time.
fn one_ui(ui: &mut Ui, view: &mut View<'_>, with_features: bool) {
    if with_features {
        let rows = times(theme::row(ui), view.session.statistics().features().len().clamp(1, 4));
        of_height(ui, rows + control(ui), |ui| features_list::list_ui(ui, view));
    }
    figures_panel::figures_ui(ui, view);
    let height = (ui.ctx().content_rect().height() * 0.42).clamp(space(50.0), space(110.0));
    of_height(ui, height, |ui| chart_panel::chart_ui(ui, view));
    segments_ui(ui, view, &Aside::ALL.map(StatisticsAction::Show), ui.available_width());
    let aside = view.session.statistics().aside;
    if aside == Aside::Signals {
        signals_panel::signals_ui(ui, view);
        signals_panel::advice_ui(ui, view);
    } else {
        of_height(ui, height, |ui| aside_panel::aside_ui(ui, view, aside));
    }
}
