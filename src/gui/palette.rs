//! The palette over the page: a field, and what it finds. Arrows choose, Enter does the highlighted entry, Escape closes.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Button, Frame, Id, Key, Label, Layout, Modal, Modifiers, RichText, ScrollArea, Sense, StrokeKind,
    TextEdit, TextStyle, Ui, UiBuilder, WidgetInfo, vec2,
};

use super::action_icon::icon_of;
use super::key_names::told;
use super::over_page::just_opened;
use super::pages::page_of;
use super::spoken;
use super::theme::{Icon, Weight, control, font, line, looking, palette, plain, sizes, space};
use super::view::{View, quiet};
use crate::session::{Palette, PaletteCommand, PaletteEntry, PaletteGroup, Step};

/// Its width and its distance from the top, in steps of the grid.
const WIDTH: f32 = 160.0;
const TOP: f32 = 22.0;

/// The height of its field, in the same steps.
const FIELD: f32 = 13.0;

/// How much of the height of the window its list takes at most.
const SHARE: f32 = 0.6;

/// The id of its field.
fn field_id() -> Id {
    Id::unique("palette-field")
}

/// Draws the palette where it is open.
pub(super) fn palette_ui(ui: &Ui, view: &mut View<'_>) {
    let session = view.session;
    let Some(open) = &session.palette else { return };
    let screen = ui.ctx().content_rect();
    let width = space(WIDTH).min(screen.width() - space(8.0));
    let top = space(TOP).min(screen.height() * 0.1);
    let id = Id::unique("palette");
    let area = Modal::default_area(id).anchor(Align2::CENTER_TOP, vec2(0.0, top));
    let shown = Modal::new(id).area(area).show(ui.ctx(), |ui| {
        ui.set_width(width);
        field_ui(ui, view, open);
        ui.separator();
        ScrollArea::vertical().max_height(screen.height() * SHARE).auto_shrink([false, true]).show(ui, |ui| {
            list_ui(ui, view, open);
        });
        ui.separator();
        foot_ui(ui, view, open);
    });
    spoken::dialog(ui.ctx(), id, &view.text("palette"));
    if shown.backdrop_response.clicked() {
        view.send(PaletteCommand::Show(false));
    }
}

fn field_ui(ui: &mut Ui, view: &mut View<'_>, open: &Palette) {
    let opened = just_opened(ui, field_id());
    // The keys of the list, before the field takes them.
    let step = ui.input_mut(|input| {
        let keys = [
            (Key::ArrowDown, Step::Down),
            (Key::ArrowUp, Step::Up),
            (Key::PageDown, Step::PageDown),
            (Key::PageUp, Step::PageUp),
        ];
        keys.into_iter().find(|(key, _)| input.consume_key(Modifiers::NONE, *key)).map(|(_, step)| step)
    });
    if let Some(step) = step {
        view.send(PaletteCommand::Move(step));
    }
    let (tab, back) = ui.input_mut(|input| {
        let back = input.consume_key(Modifiers::SHIFT, Key::Tab);
        (input.consume_key(Modifiers::NONE, Key::Tab), back)
    });
    if tab || back {
        view.send(PaletteCommand::More(tab));
    }
    let mut query = open.query.clone();
    let quiet = palette(ui.ctx()).quiet.0;
    let field = TextEdit::singleline(&mut query)
        .id(field_id())
        .lock_focus(true)
        .frame(Frame::NONE)
        .font(TextStyle::Heading)
        .hint_text(view.text("palette"))
        .align(Align2::LEFT_CENTER)
        .min_size(vec2(0.0, space(FIELD)));
    // The field has the focus as long as the palette is open: an icon says where one types, no ring.
    let row = ui.allocate_ui_with_layout(
        vec2(ui.available_width(), space(FIELD)),
        Layout::right_to_left(Align::Center),
        |ui| {
            ui.add_space(space(2.0));
            cap_ui(ui, "Esc");
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add_space(space(2.0));
                let (icon, _) = ui.allocate_exact_size(vec2(space(6.0), space(6.0)), Sense::hover());
                Icon::MagnifyingGlass.paint(ui.painter(), icon.center(), Weight::Regular, space(5.5), quiet);
                ui.add(field.desired_width(ui.available_width()))
            })
            .inner
        },
    );
    let response = row.inner;
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(view.text("palette")));
    if opened {
        response.request_focus();
    }
    if response.changed() {
        view.send(PaletteCommand::Type(query));
    }
    // What is typed together with Enter is searched for first.
    if response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
        view.send(PaletteCommand::Do(None));
    }
}

/// The cap of a key.
fn cap_ui(ui: &mut Ui, key: &str) {
    let palette = palette(ui.ctx());
    let galley = ui.painter().layout_no_wrap(key.to_owned(), font(sizes().tiny), palette.quiet.0);
    let (cap, _) = ui.allocate_exact_size(galley.size() + vec2(space(3.0), space(1.0)), Sense::hover());
    ui.painter().rect(cap, 4.0, palette.surface.0, line(ui.ctx()), StrokeKind::Inside);
    ui.painter().galley(cap.center() - galley.size() / 2.0, galley, palette.quiet.0);
}

/// What may be typed, and what else can be done with the highlighted entry: by Tab, and by a press.
fn foot_ui(ui: &mut Ui, view: &mut View<'_>, open: &Palette) {
    ui.horizontal_wrapped(|ui| {
        let more = if open.shows_more {
            Some(("palette-back", false))
        } else {
            open.found.get(open.at).filter(|entry| entry.has_more()).map(|_| ("palette-more", true))
        };
        if let Some((text, shows)) = more {
            let key = if shows { "Tab" } else { "Esc" };
            let button = Button::new(view.text(text)).shortcut_text(key).min_size(vec2(0.0, control(ui)));
            if looking(ui, plain, |ui| ui.add(button)).accessible_name(view.text(text)).clicked() {
                view.send(PaletteCommand::More(shows));
                ui.memory_mut(|memory| memory.request_focus(field_id()));
            }
        }
        quiet(ui, view.text("palette-hint"));
    });
}

fn list_ui(ui: &mut Ui, view: &mut View<'_>, open: &Palette) {
    if open.found.is_empty() {
        quiet(ui, view.text("palette-nothing"));
        return;
    }
    let moved = ui.data_mut(|data| {
        let at = (open.query.clone(), open.at);
        let last = std::mem::replace(data.get_temp_mut_or_default(Id::unique("palette-at")), at.clone());
        last != at
    });
    let name = view.text("palette");
    spoken::around_ui(ui, Role::ListBox, &name, |ui| {
        let mut number = 0;
        for group in open.found.chunk_by(|one, other| one.group == other.group) {
            let Some(name) = group.first().map(|first| view.text(first.group.name())) else { continue };
            ui.add_space(space(1.0));
            quiet(ui, &name);
            spoken::around_ui(ui, Role::Group, &name, |ui| {
                for entry in group {
                    entry_ui(ui, view, (number, entry), (number == open.at, moved));
                    number += 1;
                }
            });
        }
    });
}

/// What an entry is known by at a glance: its own icon, or that of its page.
fn icon(entry: &PaletteEntry) -> Icon {
    let of_page = || match (entry.group, entry.page()) {
        (_, Some(page)) => page_of(page).icon,
        (PaletteGroup::Settings, None) => Icon::GearSix,
        (PaletteGroup::Open, None) => Icon::FolderOpen,
        (PaletteGroup::Do | PaletteGroup::Records, None) => Icon::CaretRight,
    };
    entry.action().and_then(icon_of).unwrap_or_else(of_page)
}

/// An entry: its name, what else is to be known of it, and its keys at the right.
fn entry_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (number, entry): (usize, &PaletteEntry),
    (is_highlighted, moved): (bool, bool),
) {
    let size = vec2(ui.available_width(), space(11.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::CLICK);
    let (text, quiet) = (palette(ui.ctx()).text.0, palette(ui.ctx()).quiet.0);
    if is_highlighted {
        ui.painter().rect_filled(rect, 5.0, ui.visuals().selection.bg_fill);
        if moved {
            ui.scroll_to_rect(rect, None);
        }
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 5.0, ui.visuals().widgets.hovered.weak_bg_fill);
    }
    let inner = rect.shrink2(vec2(space(3.0), 0.0));
    let row = UiBuilder::new().max_rect(inner).layout(Layout::right_to_left(Align::Center));
    ui.scope_builder(row, |ui| {
        if !entry.is_possible {
            ui.disable();
        }
        if let Some(keys) = entry.keys {
            // From the right: the last key first.
            for key in told(ui, keys).rsplit('+') {
                cap_ui(ui, key);
            }
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let (place, _) = ui.allocate_exact_size(vec2(space(6.0), space(6.0)), Sense::hover());
            icon(entry).paint(ui.painter(), place.center(), Weight::Regular, space(5.0), quiet);
            let name = RichText::new(&entry.text).size(sizes().body).color(text);
            ui.add(Label::new(name).truncate().selectable(false));
            ui.add(
                Label::new(RichText::new(&entry.note).size(sizes().small).color(quiet)).truncate().selectable(false),
            );
        });
    });
    let said = if entry.note.is_empty() { entry.text.clone() } else { format!("{}, {}", entry.text, entry.note) };
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, entry.is_possible, is_highlighted, &said));
    if response.clicked() {
        view.send(PaletteCommand::Do(Some(number)));
    }
}
