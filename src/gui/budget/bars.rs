//! Middle: the shares as bars, largest first; of a calibrated piece its terms and both editions' U.

use std::sync::Arc;

use eframe::egui::{Galley, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

use crate::budget::{Answer, Assessment};
use crate::gui::shapes::screen;
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading};
use crate::session::bars;

/// The height of a bar, and between two.
const HEIGHT: f32 = 2.5;
const GAP: f32 = 2.0;

/// What is written at a bar, and its length.
struct ContributionBar {
    name: Arc<Galley>,
    amount: Arc<Galley>,
    length: f64,
}

/// The picture.
pub(super) fn bars_ui(ui: &mut Ui, view: &View<'_>, found: &Assessment) {
    let title = view.text(match &found.answer {
        Answer::Combined(_) => "budget-page-shares",
        Answer::Repeated(_) => "budget-page-terms",
    });
    heading(ui, &title);
    let palette = palette(ui.ctx());
    let width = ui.available_width();
    let font = theme::font(sizes().body);
    let mut said = Vec::new();
    let mut drawn = Vec::new();
    for bar in bars(found) {
        let name = view.words.say(&bar.name);
        let amount = view.words.say(&bar.amount);
        said.push(format!("{name} {amount}"));
        let amount = ui.painter().layout_no_wrap(amount, theme::bold(sizes().body), palette.text.0);
        let room = (width - amount.size().x - space(3.0)).max(space(10.0));
        let name = ui.painter().layout(name, font.clone(), palette.text.0, room);
        drawn.push(ContributionBar { name, amount, length: bar.length });
    }
    let height: f32 = drawn.iter().map(ContributionBar::height).sum();
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let mut top = rect.top();
    for bar in &drawn {
        let next = top + bar.height();
        bar.paint(ui, Rect::from_x_y_ranges(rect.x_range(), top..=next));
        top = next;
    }
    spoken::picture(ui, &response, title, format!("{}.", said.join(", ")));
}

impl ContributionBar {
    fn height(&self) -> f32 {
        self.name.size().y + space(HEIGHT + GAP)
    }

    fn paint(&self, ui: &Ui, rect: Rect) {
        if !ui.is_rect_visible(rect) {
            return;
        }
        let palette = palette(ui.ctx());
        let painter = ui.painter();
        painter.galley(rect.min, Arc::clone(&self.name), palette.text.0);
        let at = pos2(rect.right() - self.amount.size().x, rect.top());
        painter.galley(at, Arc::clone(&self.amount), palette.text.0);
        let top = rect.top() + self.name.size().y;
        let whole = Rect::from_x_y_ranges(rect.x_range(), top..=top + space(HEIGHT)).shrink(0.5);
        painter.rect_filled(whole, 2.0, palette.sunken.0);
        let length = (whole.width() * screen(self.length)).max(1.0);
        painter.rect_filled(Rect::from_min_size(whole.min, vec2(length, whole.height())), 2.0, palette.data.0);
        painter.rect_stroke(whole, 2.0, Stroke::new(1.0, palette.line.0), StrokeKind::Middle);
    }
}
