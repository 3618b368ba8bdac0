//! The first start: three settings, and three ways in. Gone once something was judged.

use eframe::egui::{Align, Label, Layout, RichText, Sense, Ui, vec2};

use crate::gui::card::page_card_ui;
use crate::gui::columns::{column_ui, of_height};
use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::view::{View, one_of_ui, quiet};
use crate::gui::who::who_ui;
use crate::session::help::Sample;
use crate::session::{Action, Page, SettingsAction, Theme, WindowAction};
use crate::words::Language;

/// From this width on the ways stand beside each other.
const BESIDE: f32 = 160.0;

/// The height of a picture.
const PICTURE: f32 = 24.0;

/// From this width on a card has a picture.
const PICTURED: f32 = 66.0;

/// The height of a card at most.
const CARD: f32 = 84.0;

/// A way into the program.
struct Way {
    icon: Icon,
    title: &'static str,
    text: &'static str,
    /// A sample first, then the same with files of one's own.
    actions: [Action; 2],
}

fn ways() -> [Way; 3] {
    let sample = |sample| Action::Window(WindowAction::OpenSample(sample));
    [
        Way {
            icon: Icon::Cube,
            title: "first-way-part",
            text: "first-way-part-about",
            actions: [sample(Sample::Part), WindowAction::Open(Page::Parts).into()],
        },
        Way {
            icon: Icon::Table,
            title: "first-way-file",
            text: "first-way-file-about",
            actions: [sample(Sample::File), WindowAction::Import.into()],
        },
        Way {
            icon: Icon::Target,
            title: "first-way-program",
            text: "first-way-program-about",
            actions: [sample(Sample::Program), WindowAction::Open(Page::Cycles).into()],
        },
    ]
}

/// The settings over the ways, in what is left of the page.
pub(super) fn first_ui(ui: &mut Ui, view: &mut View<'_>) {
    column_ui(ui, "check-first", |ui| {
        let height = settings_height(ui, view);
        of_height(ui, height, |ui| page_card_ui(ui, |ui| settings_ui(ui, view)));
        ui.add_space(space(2.0));
        if ui.available_width() < space(BESIDE) {
            return list_ui(ui, view);
        }
        let height = ui.available_height().clamp(space(66.0), space(CARD));
        let gap = space(3.0);
        let width = (ui.available_width() - gap * 2.0) / 3.0;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for way in ways() {
                ui.allocate_ui_with_layout(vec2(width, height), Layout::top_down(Align::Min), |ui| {
                    ui.set_width(width);
                    page_card_ui(ui, |ui| {
                        // Texts and buttons come before pictures.
                        if space(PICTURED) <= width {
                            picture_ui(ui, way.icon);
                        }
                        way_ui(ui, view, &way);
                    });
                });
            }
        });
    });
}

/// The same below each other, where there is no room for cards.
pub(super) fn ways_ui(ui: &mut Ui, view: &mut View<'_>) {
    settings_ui(ui, view);
    ui.add_space(space(2.0));
    list_ui(ui, view);
}

fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    for way in ways() {
        way_ui(ui, view, &way);
        ui.add_space(space(2.0));
    }
}

/// The height of the card of the settings: one line, or two where they do not fit beside their title.
fn settings_height(ui: &Ui, view: &View<'_>) -> f32 {
    let lines = if ui.available_width() < space(200.0) { 2.0 } else { 1.0 };
    let who = if view.session.recording().is_on() && ui.available_width() < space(110.0) { 1.0 } else { 0.0 };
    (control(ui) + space(2.0)) * (lines + who) + space(9.0)
}

/// Language, colours and who measures, kept for the next time.
fn settings_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.vertical(|ui| {
            ui.set_width(space(56.0));
            ui.spacing_mut().item_spacing.y = 0.0;
            ui.label(RichText::new(view.text("first-steps-title")).font(theme::bold(sizes().body)));
            quiet(ui, view.text("first-steps-about"));
        });
        let languages = Language::all().map(SettingsAction::UseLanguage).map(Action::from).collect::<Vec<_>>();
        choice_ui(ui, view, "language", &languages);
        let themes = [Theme::System, Theme::Light, Theme::Dark, Theme::Contrast];
        choice_ui(ui, view, "settings-page-colours", &themes.map(|theme| WindowAction::UseTheme(theme).into()));
        who_ui(ui, view);
        view.field_button(ui, WindowAction::EndFirstSteps);
    });
}

/// A setting as a list of its choices.
fn choice_ui(ui: &mut Ui, view: &mut View<'_>, name: &'static str, choices: &[Action]) {
    let now = choices.iter().copied().find(|choice| choice.is_on(view.session) == Some(true));
    let texts: Vec<String> = choices.iter().map(|choice| choice.text(view.session, view.words)).collect();
    let entries = choices.iter().copied().map(Some).zip(texts);
    let (chosen, list) = one_of_ui(ui, ("first", name), space(34.0), &now, entries);
    list.on_hover_text(view.text(name)).widget_info(|| {
        let mut info = eframe::egui::WidgetInfo::new(eframe::egui::accesskit::Role::ComboBox);
        info.label = Some(view.text(name));
        info
    });
    if let Some(choice) = chosen.flatten() {
        view.act(choice);
    }
}

fn picture_ui(ui: &mut Ui, icon: Icon) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), space(PICTURE)), Sense::hover());
    let palette = palette(ui.ctx());
    ui.painter().rect_filled(rect, 8.0, palette.sunken.0);
    icon.paint(ui.painter(), rect.center(), Weight::Regular, space(12.0), palette.data.0);
}

/// What it is, and two buttons.
fn way_ui(ui: &mut Ui, view: &mut View<'_>, way: &Way) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    ui.label(RichText::new(view.text(way.title)).font(theme::bold(sizes().limits)));
    let text = RichText::new(view.text(way.text)).color(palette(ui.ctx()).quiet.0);
    ui.add(Label::new(text).wrap());
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        for action in way.actions {
            view.field_button(ui, action);
        }
    });
}
