//! Right: what is read.

use eframe::egui::accesskit::Role;
use eframe::egui::scroll_area::ScrollBarVisibility;
use eframe::egui::{Align, Frame, Id, Label, Margin, RichText, ScrollArea, Ui, WidgetInfo, vec2};

use super::grid::table_ui;
use super::sheet::sheet_ui;
use super::text::spans_ui;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, quiet, remembered};
use crate::session::help::{Block, CONTENTS, HelpTopic, ManualPage, Marker, Sample};
use crate::session::{HelpAction, Step, WindowAction};
use crate::words::Language;

/// The widest that a line of text becomes: longer ones are hard to read.
const WIDEST: f32 = 190.0;

/// The line of buttons, and the text below it.
pub(super) fn article_ui(ui: &mut Ui, view: &mut View<'_>, is_beside: bool) {
    ui.horizontal_wrapped(|ui| {
        if !is_beside {
            view.field_button(ui, HelpAction::ListTopics);
        }
        view.field_button(ui, HelpAction::BackInHelp);
        let is_of_manual = view.session.help().shown.topic != HelpTopic::Keys;
        if is_of_manual && view.session.language() != Language::En {
            quiet(ui, view.text("help-page-english"));
        }
    });
    ui.separator();
    let look = is_new(ui, "help-look", view.session.help().look);
    let mut area = ScrollArea::vertical().id_salt("help-article").auto_shrink(false);
    if look && view.session.help().shown.anchor.is_none() {
        area = area.vertical_scroll_offset(0.0);
    }
    let height = ui.available_height();
    area.show(ui, |ui| {
        ui.set_max_width((ui.available_width() - space(3.0)).min(space(WIDEST)));
        ui.spacing_mut().item_spacing.y = space(2.0);
        scroll(ui, view, height);
        match view.session.help().shown.topic {
            HelpTopic::Keys => sheet_ui(ui, view),
            HelpTopic::Manual(file) => {
                if file == CONTENTS {
                    samples_ui(ui, view);
                }
                let blocks = ManualPage::of(file).map(|page| page.blocks.as_slice());
                for (number, block) in blocks.into_iter().flatten().enumerate() {
                    block_ui(ui, view, (number, block), look);
                }
            }
        }
    });
}

/// A part of a page of the manual, in another place.
pub(in crate::gui) fn blocks_ui(ui: &mut Ui, view: &mut View<'_>, blocks: &[Block]) {
    for (number, block) in blocks.iter().enumerate() {
        block_ui(ui, view, (number, block), false);
    }
}

/// What the program can be tried with.
fn samples_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("help-page-samples"));
    ui.horizontal_wrapped(|ui| {
        for sample in Sample::ALL.map(WindowAction::OpenSample) {
            view.field_button(ui, sample);
        }
        view.field_button(ui, WindowAction::FirstSteps);
    });
    quiet(ui, view.text("help-page-sample-hint"));
    ui.separator();
}

/// Whether a number is another one than in the frame before.
fn is_new(ui: &Ui, name: &str, number: u64) -> bool {
    let id = Id::unique(name);
    let last: u64 = remembered(ui, id);
    ui.data_mut(|data| data.insert_temp(id, number));
    last != number
}

/// Scrolls as a key asked for: nearly as far as is in sight.
fn scroll(ui: &Ui, view: &View<'_>, height: f32) {
    let (number, step) = view.session.help().scrolled;
    if is_new(ui, "help-scrolled", number) {
        let far = (height - space(10.0)).max(space(10.0));
        ui.scroll_with_delta(vec2(0.0, if step == Step::PageUp { far } else { -far }));
    }
}

fn block_ui(ui: &mut Ui, view: &mut View<'_>, (number, block): (usize, &Block), look: bool) {
    match block {
        Block::Heading { level, anchor, spans } => {
            ui.add_space(space(if *level == 1 { 0.0 } else { 2.0 }));
            let size = if *level == 1 { sizes().value } else { sizes().heading };
            let text: String = spans.iter().map(|span| span.text.as_str()).collect();
            let drawn = ui.add(Label::new(RichText::new(&text).font(theme::bold(size))).wrap());
            drawn.widget_info(|| WidgetInfo::labeled(Role::Heading, true, &text));
            ui.ctx().accesskit_node_builder(drawn.id, |node| node.set_level(*level));
            if look && view.session.help().shown.anchor.as_ref() == Some(anchor) {
                drawn.scroll_to_me(Some(Align::TOP));
            }
        }
        Block::Paragraph(spans) => spans_ui(ui, view, spans),
        Block::Item { depth, marker, spans } => item_ui(ui, view, (*depth, *marker), |ui, view| {
            spans_ui(ui, view, spans);
        }),
        Block::Table { head, rows } => table_ui(ui, view, head, rows),
        Block::Code(text) => code_ui(ui, number, text),
    }
}

/// An entry of a list: its mark, and its text beside it.
fn item_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (depth, marker): (usize, Marker),
    content: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    let mark = match marker {
        Marker::Bullet => "•".to_owned(),
        Marker::Number(number) => format!("{number}."),
        Marker::Nothing => String::new(),
    };
    let left = (1..depth).fold(0.0, |left, _| left + space(6.0));
    ui.horizontal_top(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        ui.add_space(left);
        ui.allocate_ui(vec2(space(5.0), 0.0), |ui| {
            ui.set_width(space(5.0));
            ui.label(mark);
        });
        ui.vertical(|ui| content(ui, view));
    });
}

/// Lines as they are typed: long ones are scrolled to.
fn code_ui(ui: &mut Ui, number: usize, text: &str) {
    let colour = palette(ui.ctx()).text.0;
    let frame = Frame::new().fill(palette(ui.ctx()).sunken.0).corner_radius(6.0).inner_margin(Margin::same(8));
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        let area = ScrollArea::horizontal().id_salt(("help-code", number));
        area.scroll_bar_visibility(ScrollBarVisibility::VisibleWhenNeeded).show(ui, |ui| {
            let text = RichText::new(text).font(theme::mono(sizes().mono)).color(colour);
            ui.add(Label::new(text).extend().selectable(true));
        });
    });
}
