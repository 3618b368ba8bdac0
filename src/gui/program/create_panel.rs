//! Right: the files with which a control measures for itself. A card where there is room, else a button that shows it over the page.

use std::sync::Arc;

use eframe::egui::{Align2, Id, Key, Label, RichText, ScrollArea, Ui, Vec2, Window, vec2};

use crate::gui::section::{self, Section};
use crate::gui::spoken::icon_ui;
use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::view::{View, heading, one_of_ui, problem, quiet};
use crate::message::message;
use crate::nc::sets::{Control, NcSet};
use crate::session::program::SetFrom;
use crate::session::{ProgramAction, ProgramCommand};
use crate::words::Dialogue;

/// The text that names it.
const NAME: &str = "program-page-create-head";

/// From this height of the page on it is a card of its own.
pub(super) const CARD: f32 = 860.0;

/// As a card.
pub(super) fn card_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text(NAME));
    create_ui(ui, view);
}

/// Folded away in a row that says for which control it is, and of what. Who asks for it finds it open and in sight.
pub(super) fn section_ui(ui: &mut Ui, view: &mut View<'_>) {
    let is_asked = is_asked(ui, view);
    if is_asked {
        section::unfold(ui.ctx(), NAME);
    }
    let creating = &view.session.program().creating;
    let value = creating.control.name().to_owned();
    let row = Section { icon: Icon::FileCode, name: NAME, value, is_wrong: false };
    let top = ui.cursor().min;
    row.show(ui, view, create_ui);
    if is_asked {
        ui.scroll_to_rect(ui.min_rect().with_min_y(top.y), None);
    }
}

/// A button where there is no room for a card; who presses it, or asks for it by name, has the card over the page.
pub(super) fn button_ui(ui: &mut Ui, view: &mut View<'_>) {
    let width = ui.available_width();
    view.sized_button(ui, ProgramAction::CreateForControl, vec2(width, control(ui)));
    let is_asked = is_asked(ui, view);
    let key = Id::unique("program-create-open");
    let mut is_open = is_asked || ui.data(|data| data.get_temp::<bool>(key)) == Some(true);
    let size = ui.ctx().content_rect().size();
    let window =
        Window::new(view.text(NAME)).id(Id::unique("program-create-window")).collapsible(false).resizable(false);
    window.anchor(Align2::CENTER_CENTER, Vec2::ZERO).open(&mut is_open).show(ui.ctx(), |ui| {
        ui.set_width((size.x * 0.9).min(space(110.0)));
        ScrollArea::vertical().max_height(size.y - space(50.0)).show(ui, |ui| create_ui(ui, view));
    });
    let has_other = view.session.dialog().is_some() || view.session.palette.is_some();
    if !is_asked && !has_other && ui.input(|input| input.key_pressed(Key::Escape)) {
        is_open = false;
    }
    ui.data_mut(|data| data.insert_temp(key, is_open));
}

/// Whether it was asked for since the last frame.
fn is_asked(ui: &Ui, view: &View<'_>) -> bool {
    let looks = view.session.program().creating.looks();
    let key = Id::unique("program-create-looks");
    ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(key), looks)) != looks
}

fn create_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    target_ui(ui, view);
    source_ui(ui, view);
    options_ui(ui, view);
    let creating = &view.session.program().creating;
    match creating.made() {
        None => _ = quiet(ui, view.text("program-page-create-nothing")),
        Some(Err(reasons)) => {
            for reason in reasons {
                problem(ui, view.words.say(reason));
            }
        }
        Some(Ok(set)) => {
            let set = Arc::clone(set);
            files_ui(ui, view, &set);
            let creating = &view.session.program().creating;
            if let Some(folder) = creating.folder() {
                quiet(ui, view.words.say(&message!("program-page-create-folder").text("folder", folder)));
            }
            let mut said = creating.said().into_iter();
            if let Some(proven) = said.next() {
                ui.horizontal_wrapped(|ui| {
                    icon_ui(ui, Icon::CheckCircle, Weight::Regular, space(4.5), palette(ui.ctx()).text.0);
                    quiet(ui, view.words.say(&proven));
                });
            }
            for remark in said {
                quiet(ui, view.words.say(&remark));
            }
        }
    }
    let width = ui.available_width() - space(2.0);
    view.sized_button(ui, ProgramAction::CreateFiles, vec2(width, control(ui)));
}

/// The files by name; who presses one sees what is in it.
fn files_ui(ui: &mut Ui, view: &mut View<'_>, set: &NcSet) {
    let shown = view.session.program().creating.shown();
    let mut pressed = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(space(2.0), space(1.0));
        for file in &set.files {
            let is_shown = shown.as_ref().is_some_and(|(name, _)| *name == file.name);
            let name = RichText::new(&file.name).font(theme::mono(sizes().small));
            if ui.selectable_label(is_shown, name).clicked() {
                pressed = Some((!is_shown).then(|| file.name.clone()));
            }
        }
    });
    if let Some((_, text)) = shown {
        ScrollArea::both().id_salt("program-create-shown").max_height(space(45.0)).show(ui, |ui| {
            ui.add(Label::new(RichText::new(text).font(theme::mono(sizes().small))).extend());
        });
    }
    if let Some(name) = pressed {
        view.send(ProgramCommand::CreateShow(name));
    }
}

/// For a series, and by texts where the control has that.
fn options_ui(ui: &mut Ui, view: &mut View<'_>) {
    let creating = &view.session.program().creating;
    let (mut is_series, mut by_text, has_texts) =
        (creating.is_series, creating.by_text, creating.control.takes_texts());
    if ui.checkbox(&mut is_series, view.text("program-page-create-series")).clicked() {
        view.send(ProgramCommand::CreateSeries(is_series));
    }
    if has_texts && ui.checkbox(&mut by_text, view.text("program-page-create-texts")).clicked() {
        view.send(ProgramCommand::CreateByText(by_text));
    }
}

/// For which control, and in which language of its dialogue.
fn target_ui(ui: &mut Ui, view: &mut View<'_>) {
    let creating = &view.session.program().creating;
    let (now, language) = (creating.control, creating.language());
    let column = (ui.available_width() - space(4.0)) / 2.0;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space(2.0);
        ui.vertical(|ui| {
            ui.set_width(column);
            let name = quiet(ui, view.text("program-page-create-control"));
            let all = Control::ALL.map(|control| (control, control.name().to_owned()));
            let (chosen, list) = one_of_ui(ui, "program-create-control", column, &now, all);
            list.labelled_by(name.id);
            if let Some(control) = chosen {
                view.send(ProgramCommand::CreateFor(control));
            }
        });
        ui.vertical(|ui| {
            ui.set_width(column);
            let name = quiet(ui, view.text("program-page-create-language"));
            let all = Dialogue::ALL.map(|dialogue| (Some(dialogue), dialogue.name().to_owned()));
            let (chosen, list) = one_of_ui(ui, "program-create-language", column, &language, all);
            list.labelled_by(name.id);
            if let Some(language) = chosen.flatten() {
                view.send(ProgramCommand::CreateIn(language));
            }
        });
    });
}

/// What it is made of.
fn source_ui(ui: &mut Ui, view: &mut View<'_>) {
    let creating = &view.session.program().creating;
    let now = creating.from();
    let all: Vec<(Option<SetFrom>, String)> =
        creating.sources().into_iter().map(|(from, said)| (Some(from), view.words.say(&said))).collect();
    let name = quiet(ui, view.text("program-page-create-from"));
    let width = ui.available_width() - space(2.0);
    let (chosen, list) = one_of_ui(ui, "program-create-from", width, &now, all);
    list.labelled_by(name.id);
    if let Some(from) = chosen.flatten() {
        view.send(ProgramCommand::CreateFrom(from));
    }
}
