//! What a screen reader says of what is drawn, and what it passes over.
//!
//! `.ci/bus` looks at the tree of the running program: every control has a name, every picture its figures.

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Color32, Context, Id, Response, Sense, TextStyle, Ui, Vec2, WidgetInfo, accesskit_root_id};

use super::theme::{Icon, Weight};

/// Names the window as its title does.
pub(super) fn window(ctx: &Context) {
    ctx.accesskit_node_builder(accesskit_root_id(), |node| node.set_label("Fitcheck"));
}

/// Names a dialog of an id, once it is drawn: it is said when it opens.
pub(super) fn dialog(ctx: &Context, id: Id, name: &str) {
    ctx.accesskit_node_builder(id, |node| node.set_label(name));
}

/// Names a dialog of an id by the heading in it.
pub(super) fn dialog_headed(ui: &Ui, id: Id, heading: &Response) {
    ui.ctx().accesskit_node_builder(id, |node| node.push_labelled_by(heading.id.accesskit_id()));
}

/// Makes a text one that a screen reader reads when it comes.
pub(super) fn told(ui: &Ui, text: &Response) {
    ui.ctx().accesskit_node_builder(text.id, |node| node.set_live(Live::Polite));
}

/// Makes a widget a live region: a screen reader reads it whenever it changes.
pub(super) fn live(ui: &Ui, response: &Response, said: &str, politeness: Live) {
    response.widget_info(|| WidgetInfo::labeled(Role::Status, true, said));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_live(politeness));
}

/// Makes a widget a picture of a name, with what it shows in words and figures.
pub(super) fn picture(ui: &Ui, response: &Response, name: impl Into<String>, shown: impl Into<String>) {
    picture_named(response, name);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(shown.into()));
}

/// The same where the name says what it shows.
pub(super) fn picture_named(response: &Response, name: impl Into<String>) {
    let name = name.into();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
}

/// A list, a table or a group of a name around its entries.
pub(super) fn around_ui(ui: &mut Ui, role: Role, name: &str, content: impl FnOnce(&mut Ui)) {
    let shown = ui.scope(content).response;
    shown.widget_info(|| WidgetInfo::labeled(role, true, name));
}

/// An icon beside words that say as much: it is seen and not said.
pub(super) fn icon_ui(ui: &mut Ui, icon: Icon, weight: Weight, size: f32, colour: Color32) -> Response {
    let (place, response) = ui.allocate_exact_size(Vec2::splat(size), Sense::hover());
    icon.paint(ui.painter(), place.center(), weight, size, colour);
    response
}

/// A cell of a grid, or a line, in which nothing stands, as high as a text.
pub(super) fn gap_ui(ui: &mut Ui, style: &TextStyle) {
    let text = ui.painter().layout_no_wrap(String::new(), style.resolve(ui.style()), Color32::PLACEHOLDER);
    ui.allocate_exact_size(text.size(), Sense::hover());
}
