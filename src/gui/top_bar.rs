//! Top: which page this is, the search field, what is recorded, and the menu.

use std::path::Path;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Button, Frame, Id, Margin, Panel, Rangef, Rect, RichText, ScrollArea, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, vec2,
};

use super::check::grouped;
use super::key_names::told;
use super::pages::page_of;
use super::rail::rail_width;
use super::records;
use super::segments::segments_ui;
use super::settings::gauge_state;
use super::shapes::times;
use super::spoken::icon_ui;
use super::theme::{self, Icon, Weight, control, palette, sizes, space};
use super::view::{View, quiet, remembered};
use super::who::{names_ui, who_ui};
use crate::message::{Message, message};
use crate::report::of_any_paper;
use crate::session::{
    Action, CheckAction, Command, Density, FilesCommand, OpenGauge, Page, Section, Session, SettingsCommand, Theme,
    WindowAction, row_forms,
};
use crate::text::long;
use crate::tolerance::Base;
use crate::words::Language;

/// How much of the bar's right end gives way: the search field becomes an icon, then words go, then what the menu has, too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fold {
    Nothing,
    Search,
    Words,
    Buttons,
    Who,
}

impl Fold {
    const ALL: [Self; 5] = [Self::Nothing, Self::Search, Self::Words, Self::Buttons, Self::Who];
}

/// The widest and the narrowest search field, and the room around it.
const SEARCH: [f32; 2] = [480.0, 320.0];
const AROUND: f32 = 12.0;

/// The bar: which page this is, the search field in its middle, what is recorded and by whom, Undo, the page's own action, the menu.
pub(super) fn top_bar_ui(ui: &mut Ui, view: &mut View<'_>) {
    let palette = palette(ui.ctx());
    let is_low = ui.ctx().content_rect().height() < space(120.0);
    let height = if is_low { control(ui) + space(1.0) } else { space(13.0).max(control(ui) + space(2.0)) };
    let margin: i8 = if is_low { 8 } else { 16 };
    let frame = Frame::new().fill(palette.surface.0).inner_margin(Margin::symmetric(margin, 0));
    // From the rail to the edge of the window, whatever stands in the bar and however much of it that wants.
    let window = ui.ctx().content_rect();
    let across = Rangef::new(window.left() + rail_width(ui), window.right()).shrink(margin.into());
    Panel::top("top").resizable(false).exact_size(height).frame(frame).show(ui, |ui| {
        ui.horizontal_centered(|ui| bar_ui(ui, view, across));
    });
}

fn bar_ui(ui: &mut Ui, view: &mut View<'_>, across: Rangef) {
    let bar = Rect::from_x_y_ranges(across, ui.max_rect().y_range());
    let page = WindowAction::Open(view.session.page()).text(view.session, view.words);
    ui.label(RichText::new(page).font(theme::bold(sizes().title)));
    if has_sides(ui) {
        sides_ui(ui, view);
    }
    let id = Id::unique("top-bar");
    // The widths of the frames before, by how much was folded.
    let widths: [f32; Fold::ALL.len()] = remembered(ui, id);
    let room = bar.right() - ui.cursor().left() - AROUND;
    let search = (bar.width() * 0.25).clamp(SEARCH[1], SEARCH[0]);
    let has_search = |right: f32| {
        let middle = bar.center().x;
        ui.cursor().left() + AROUND <= middle - search / 2.0 && middle + search / 2.0 + AROUND <= bar.right() - right
    };
    let fits = |(fold, width): &(Fold, f32)| if *fold == Fold::Nothing { has_search(*width) } else { *width <= room };
    let known = |fold| widths.into_iter().zip(Fold::ALL).find(|(_, of)| *of == fold).map_or(0.0, |(width, _)| width);
    let fold = Fold::ALL.into_iter().zip(widths).find(fits).map_or(Fold::Who, |(fold, _)| fold);
    let end = if fold == Fold::Nothing { bar.center().x - search / 2.0 } else { bar.right() - known(fold) };
    open_ui(ui, view, end - AROUND);
    if fold == Fold::Nothing {
        let field = Rect::from_center_size(bar.center(), vec2(search, control(ui).min(bar.height())));
        search_ui(ui, view, field);
    }
    let known = known(fold);
    // As wide as what follows, so that it ends at the right edge in reading order.
    ui.add_space((bar.right() - ui.cursor().left() - known).max(0.0));
    let shown = ui.horizontal(|ui| right_ui(ui, view, fold)).response.rect.width();
    if 0.5 < (shown - known).abs() {
        let widths = std::array::from_fn(|at| match (Fold::ALL.get(at), widths.get(at)) {
            (Some(of), _) if *of == fold => shown,
            (_, width) => width.copied().unwrap_or(0.0),
        });
        ui.data_mut(|data| data.insert_temp::<[f32; Fold::ALL.len()]>(id, widths));
        ui.ctx().request_repaint();
    }
}

/// Whether the sides of a page have room beside its title; else they stand on the page.
pub(super) fn has_sides(ui: &Ui) -> bool {
    space(160.0) <= ui.ctx().content_rect().width()
}

/// The sides of the page that is open, as segments.
pub(super) fn sides_ui(ui: &mut Ui, view: &mut View<'_>) {
    let sides = page_of(view.session.page()).sides;
    if !sides.is_empty() {
        let width = times(view.width_of(ui, sides).max(space(20.0)), sides.len());
        segments_ui(ui, view, sides, width);
    }
}

/// The sides of the page, where they have no room beside its title.
pub(super) fn folded_sides_ui(ui: &mut Ui, view: &mut View<'_>) {
    if !has_sides(ui) {
        sides_ui(ui, view);
    }
}

/// What is open on the page, as chips that end before a place; those that have no room are left out: the page names them, too.
fn open_ui(ui: &mut Ui, view: &View<'_>, end: f32) {
    let palette = palette(ui.ctx());
    for name in (page_of(view.session.page()).opened)(view) {
        let galley = ui.painter().layout_no_wrap(name.clone(), theme::font(sizes().small), palette.text.0);
        let size = galley.size() + vec2(space(4.0), space(2.5));
        if end < ui.cursor().left() + size.x {
            return;
        }
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        ui.painter().rect_filled(rect, 6.0, palette.hover.0);
        ui.painter().galley(rect.center() - galley.size() / 2.0, galley, palette.text.0);
        let said = view.words.say(&message!("top-open").text("name", name));
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
    }
}

/// The search field: it opens the palette.
fn search_ui(ui: &mut Ui, view: &mut View<'_>, rect: Rect) {
    let palette = palette(ui.ctx());
    let name = WindowAction::Palette.text(view.session, view.words);
    let response = ui.allocate_rect(rect, Sense::click());
    let fill = if response.hovered() { palette.tint.0 } else { palette.hover.0 };
    ui.painter().rect_filled(rect, 8.0, fill);
    if response.has_focus() {
        ui.painter().rect_stroke(rect, 8.0, Stroke::new(2.0, palette.focus.0), StrokeKind::Inside);
    }
    let at = rect.left_center() + vec2(space(5.0), 0.0);
    Icon::MagnifyingGlass.paint(ui.painter(), at, Weight::Regular, space(5.0), palette.quiet.0);
    let text = rect.left_center() + vec2(space(9.5), 0.0);
    ui.painter().text(text, Align2::LEFT_CENTER, &name, theme::font(sizes().body), palette.quiet.0);
    if let Some(keys) = Action::from(WindowAction::Palette).shortcut_shown(view.session.page()) {
        let keys = told(ui, keys);
        let galley = ui.painter().layout_no_wrap(keys, theme::font(sizes().tiny), palette.quiet.0);
        let cap = Align2::RIGHT_CENTER.align_size_within_rect(galley.size() + vec2(12.0, 4.0), rect.shrink(8.0));
        ui.painter().rect(cap, 4.0, palette.surface.0, theme::line(ui.ctx()), StrokeKind::Inside);
        ui.painter().galley(cap.center() - galley.size() / 2.0, galley, palette.quiet.0);
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    if response.clicked() {
        view.act(WindowAction::Palette);
    }
}

fn right_ui(ui: &mut Ui, view: &mut View<'_>, fold: Fold) {
    if Fold::Search <= fold {
        view.icon_button(ui, WindowAction::Palette, Icon::MagnifyingGlass);
    }
    messages_ui(ui, view);
    gauges_ui(ui, view);
    recorded_ui(ui, view, fold < Fold::Words);
    if fold < Fold::Who {
        who_ui(ui, view);
    }
    let name = view.text("top-undo");
    view.icon_button_named(ui, WindowAction::Undo, Icon::ArrowUUpLeft, &name);
    let action = (page_of(view.session.page()).action)(view);
    if fold < Fold::Buttons {
        view.button(ui, action);
    }
    let name = view.text("menu");
    theme::looking(ui, theme::plain, |ui| {
        let icon = Icon::DotsThree.text(Weight::Bold, space(5.0));
        let shown = ui.menu_button(icon, |ui| {
            scrolling_ui(ui, |ui| {
                if fold == Fold::Who && view.session.recording().is_on() {
                    ui.menu_button(view.text("records-page-who"), |ui| names_ui(ui, view));
                }
                if Fold::Buttons <= fold {
                    view.menu_item(ui, action);
                }
                if action != WindowAction::Import.into() {
                    view.menu_item(ui, WindowAction::Import);
                }
                ui.menu_button(view.text("export"), |ui| match view.session.page() {
                    Page::Records => records::export_ui(ui, view),
                    _ => export_ui(ui, view),
                });
                ui.separator();
                menu_ui(ui, view);
            });
        });
        shown.response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    });
}

/// A menu that is higher than the window scrolls.
fn scrolling_ui(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    let most = ui.ctx().content_rect().bottom() - ui.cursor().top() - space(4.0);
    ScrollArea::vertical().max_height(most).min_scrolled_height(most).show(ui, content);
}

/// What was told before and asked for a look: there as long as it is not emptied.
fn messages_ui(ui: &mut Ui, view: &mut View<'_>) {
    let count = view.session.earlier_notices().len();
    if 0 < count {
        let name = view.words.say(&message!("messages-count").count("count", count));
        view.icon_button_named(ui, WindowAction::Messages, Icon::Bell, &name);
    }
}

/// The gauges, while there are any: how the port of each stands. The button leads to them.
fn gauges_ui(ui: &mut Ui, view: &mut View<'_>) {
    let gauges = view.session.settings_page().gauges.list();
    let state = |gauge: &OpenGauge| {
        let said = message!("gauges-state").text("name", gauge.name()).text("state", gauge_state(view, gauge));
        view.words.say(&said)
    };
    let said: Vec<String> = gauges.iter().filter(|gauge| gauge.is_connected()).map(state).collect();
    if !said.is_empty() {
        let name = said.join("; ");
        let button = Button::new(Icon::LinkSimpleHorizontal.text(Weight::Regular, space(5.0)));
        let shown = theme::looking(ui, theme::plain, |ui| ui.add(button));
        shown.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        if shown.on_hover_text(name).clicked() {
            view.send(Command::OpenPage(Page::Settings));
            view.send(SettingsCommand::Show(Section::Gauges));
        }
    }
}

/// Whether checks are recorded, and the number of the newest one; where they are not, in words whatever the room.
fn recorded_ui(ui: &mut Ui, view: &mut View<'_>, has_words: bool) {
    let recording = view.session.recording();
    let is_bad = recording.has_failed_to_open() || 0 < recording.failed();
    let is_recorded = recording.is_on() && !is_bad;
    let said = match recording.newest {
        _ if !is_recorded => view.text("top-not-recorded"),
        // The first entry of a journal is its beginning, and no record.
        0 | 1 => view.text("top-recording"),
        _ if 0 < recording.unwritten() => view.text("top-recording"),
        newest => view.words.say(&message!("top-recorded").text("number", grouped(newest))),
    };
    let palette = palette(ui.ctx());
    let colour = if is_bad { palette.error.0 } else { palette.quiet.0 };
    let (icon, weight) =
        if is_recorded { (Icon::CheckCircle, Weight::Fill) } else { (Icon::WarningCircle, Weight::Regular) };
    let icon_colour = if is_recorded { palette.accent.0 } else { colour };
    ui.spacing_mut().item_spacing.x = space(1.5);
    let shown = icon_ui(ui, icon, weight, space(4.5), icon_colour);
    if has_words || is_bad {
        ui.label(RichText::new(said).font(theme::font(sizes().small)).color(colour));
    } else {
        shown.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
        shown.on_hover_text(said);
    }
    if is_bad {
        view.button(ui, WindowAction::RecordAgain);
    }
    ui.spacing_mut().item_spacing.x = space(2.0);
}

/// What of the history can be exported, and as what.
pub(super) fn export_ui(ui: &mut Ui, view: &mut View<'_>) {
    for number in of_any_paper() {
        view.menu_item(ui, WindowAction::Export(number));
    }
    if view.session.lists_rows() {
        for form in row_forms() {
            view.menu_item(ui, CheckAction::ExportRows(form));
        }
    }
    view.menu_item(ui, WindowAction::ExportStatus);
    ui.separator();
    // What will be exported is said before it is.
    let said = exported(view.session);
    quiet(ui, view.words.say(&said));
    if view.session.lists_rows() {
        return;
    }
    let choosing = [WindowAction::ChooseBad.into(), CheckAction::ChooseAll.into(), WindowAction::ChooseNone.into()];
    for action in choosing.into_iter().chain([Action::from(CheckAction::CopyChecks)]) {
        view.menu_item(ui, action);
    }
}

fn exported(session: &Session) -> Message {
    if let Some(rows) = session.check().rows.as_ref().filter(|_| session.lists_rows()) {
        let said = message!("rows-exported").text("listed", grouped(long(rows.listed()))).text("name", &rows.name);
        return if rows.can_be_written() { said } else { message!("rows-export-not-yet") };
    }
    let history = session.history();
    match (history.chosen_count(), history.exported_count()) {
        (0, listed) if listed < history.iter().count() => {
            message!("history-exported-listed").count("count", listed).count("all", history.iter().count())
        }
        (0, count) => message!("history-exported").count("count", count),
        (chosen, _) => message!("history-chosen").count("count", chosen),
    }
}

fn menu_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.menu_item(ui, WindowAction::Palette);
    recent_ui(ui, view);
    ui.separator();
    ui.menu_button(view.text("language"), |ui| {
        for language in Language::all() {
            if ui.radio(view.session.language() == language, language.name()).clicked() {
                view.send(Command::SetLanguage(language));
                ui.close();
            }
        }
    });
    ui.menu_button(view.text("theme"), |ui| {
        choices_ui(ui, view, Theme::ALL.map(WindowAction::UseTheme));
    });
    ui.menu_button(view.text("density"), |ui| choices_ui(ui, view, Density::ALL.map(WindowAction::UseDensity)));
    ui.menu_button(view.text("limits-from"), |ui| {
        // Own tables are asked before any of what stands below.
        let own = view.session.sources().own();
        if !own.is_empty() {
            let names: Vec<&str> = own.iter().map(|table| table.name()).collect();
            quiet(ui, view.words.say(&message!("limits-own-first").text("names", names.join(", "))));
            view.menu_item(ui, WindowAction::NoOwnTables);
            ui.separator();
        }
        choices_ui(ui, view, Base::ALL.map(WindowAction::UseSource));
        ui.separator();
        view.checkbox(ui, WindowAction::RoundJs);
        view.checkbox(ui, WindowAction::Edition1988);
    });
    ui.separator();
    for action in
        [WindowAction::ImportColumns, WindowAction::LoadTables, WindowAction::NoOwnTables, WindowAction::LoadMask]
    {
        view.menu_item(ui, action);
    }
    ui.separator();
    for action in [WindowAction::Undo, WindowAction::ClearHistory] {
        view.menu_item(ui, action);
    }
}

/// The files that were read last, each with its folder.
fn recent_ui(ui: &mut Ui, view: &mut View<'_>) {
    let recent = view.session.recent_files();
    ui.add_enabled_ui(!recent.is_empty(), |ui| {
        ui.menu_button(view.text("recent-files"), |ui| {
            for (number, file) in recent.iter().enumerate() {
                let name = file.path.file_name().unwrap_or(file.path.as_os_str()).to_string_lossy();
                let folder = file.path.parent().unwrap_or(Path::new("")).display();
                let told = message!("recent-file")
                    .text("name", name)
                    .text("what", view.text(file.purpose.title()))
                    .text("folder", folder);
                if ui.button(view.words.say(&told)).clicked() {
                    view.send(FilesCommand::OpenRecent(number));
                    ui.close();
                }
            }
            ui.separator();
            view.menu_item(ui, WindowAction::ForgetRecent);
        });
    });
}

/// Choices that close their menu.
fn choices_ui(ui: &mut Ui, view: &mut View<'_>, choices: impl IntoIterator<Item = impl Into<Action>>) {
    for choice in choices {
        if view.radio(ui, choice) {
            ui.close();
        }
    }
}
