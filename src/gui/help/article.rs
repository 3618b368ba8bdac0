//! Right: what is read.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Frame, Id, Label, Margin, Rect, RichText, ScrollArea, Shape, Ui, WidgetInfo, vec2};

use super::grid::table_ui;
use super::sheet::sheet_ui;
use super::text::{append, mark_shape, spans_ui};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, quiet, remembered};
use crate::session::help::{Block, CONTENTS, HelpMark, HelpTopic, HelpWords, ManualPage, Marker, Sample, Span};
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
    let mark = view.session.help().shown.mark.clone();
    if look && view.session.help().shown.anchor.is_none() && mark.is_none() {
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
                if file == CONTENTS && !view.session.is_for_operators() {
                    samples_ui(ui, view);
                }
                let blocks = ManualPage::told(file, view.session.language()).map(|page| page.blocks.as_slice());
                for (number, block) in blocks.into_iter().flatten().enumerate() {
                    let mark = mark.as_ref().filter(|mark| mark.block == number);
                    block_ui(ui, view, block, (look, mark));
                }
            }
        }
    });
}

/// A part of a page of the manual, in another place.
pub(in crate::gui) fn blocks_ui(ui: &mut Ui, view: &mut View<'_>, blocks: &[Block]) {
    for block in blocks {
        block_ui(ui, view, block, (false, None));
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

/// A block. A marked one stands out and comes into sight when it was just opened; without a mark, the heading does.
fn block_ui(ui: &mut Ui, view: &mut View<'_>, block: &Block, (look, mark): (bool, Option<&HelpMark>)) {
    let words = mark.map(|mark| &mark.words);
    let ground = ui.painter().add(Shape::Noop);
    let drawn = match block {
        Block::Heading { level, anchor, spans } => {
            heading_ui(ui, view, (*level, anchor), spans, look);
            None
        }
        Block::Paragraph(spans) => Some(spans_ui(ui, view, spans, words)),
        Block::Item { depth, marker, spans } => {
            Some(item_ui(ui, (*depth, *marker), |ui| _ = spans_ui(ui, view, spans, words)))
        }
        Block::Table { head, rows } => {
            let row = table_ui(ui, view, (head, rows), mark);
            if look && let Some(row) = row {
                ui.scroll_to_rect(row, Some(Align::Center));
            }
            None
        }
        Block::Code(text) => Some(code_ui(ui, text, words)),
    };
    if let (Some(rect), Some(_)) = (drawn, mark) {
        ui.painter().set(ground, mark_shape(ui, rect));
        if look {
            ui.scroll_to_rect(rect, Some(Align::Center));
        }
    }
}

fn heading_ui(ui: &mut Ui, view: &View<'_>, (level, anchor): (usize, &str), spans: &[Span], look: bool) {
    ui.add_space(space(if level == 1 { 0.0 } else { 2.0 }));
    let size = match level {
        1 => sizes().value,
        2 => sizes().heading,
        _ => sizes().body,
    };
    let text: String = spans.iter().map(|span| span.text.as_str()).collect();
    let drawn = ui.add(Label::new(RichText::new(&text).font(theme::bold(size))).wrap());
    drawn.widget_info(|| WidgetInfo::labeled(Role::Heading, true, &text));
    ui.ctx().accesskit_node_builder(drawn.id, |node| node.set_level(level));
    let shown = &view.session.help().shown;
    if look && shown.mark.is_none() && shown.anchor.as_deref() == Some(anchor) {
        drawn.scroll_to_me(Some(Align::TOP));
    }
}

/// An entry of a list: its mark, and its text beside it.
fn item_ui(ui: &mut Ui, (depth, marker): (usize, Marker), content: impl FnOnce(&mut Ui)) -> Rect {
    let mark = match marker {
        Marker::Bullet => "•".to_owned(),
        Marker::Number(number) => format!("{number}."),
        Marker::Nothing => String::new(),
    };
    let left = (1..depth).fold(0.0, |left, _| left + space(6.0));
    let item = ui.horizontal_top(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        ui.add_space(left);
        ui.allocate_ui(vec2(space(5.0), 0.0), |ui| {
            ui.set_width(space(5.0));
            ui.label(mark);
        });
        ui.vertical(content);
    });
    item.response.rect
}

/// Lines as they are typed. A line that is longer than the room goes on in the next one: nothing is cut.
fn code_ui(ui: &mut Ui, text: &str, words: Option<&HelpWords>) -> Rect {
    let colour = palette(ui.ctx()).text.0;
    let ground = if words.is_some() { palette(ui.ctx()).tint.0 } else { palette(ui.ctx()).sunken.0 };
    let frame = Frame::new().fill(ground).corner_radius(6.0).inner_margin(Margin::same(8));
    let drawn = frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        let mut job = LayoutJob::default();
        append(&mut job, text, &TextFormat::simple(theme::mono(sizes().mono), colour), words);
        ui.add(Label::new(job).wrap().selectable(true));
    });
    drawn.response.rect
}
