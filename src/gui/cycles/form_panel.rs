//! Left: the cycle, where its contacts come from, and its parameters, made from the declaration.

use eframe::egui::accesskit::Role;
use eframe::egui::{CollapsingHeader, Id, Rect, Sense, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2};

use super::opener_ui;
use super::parameter_row::{figure_ui, parameter_ui};
use super::picture::tile_picture;
use crate::gui::section::{Section, folded_ui};
use crate::gui::shapes;
use crate::gui::theme::{self, Icon, control, palette, sizes, space};
use crate::gui::view::{View, heading, keep_focus, list_ui, problem, quiet, quiet_cut};
use crate::message::message;
use crate::probing::cycle::{Cycle, Key, Parameter, ParameterGroup, Value};
use crate::probing::cycles::CYCLES;
use crate::session::{
    Axis, ContactsFrom, CycleField, CyclesAction, CyclesCommand, WindowAction, WorkpieceAction, fold_name, group_name,
    may_fold,
};

/// What stands above the form: the cycle, where contacts come from, and what runs it.
pub(super) fn head_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.add_space(space(1.0));
    chooser_ui(ui, view);
    source_ui(ui, view);
    run_ui(ui, view);
}

pub(super) fn form_ui(ui: &mut Ui, view: &mut View<'_>) {
    parameters_ui(ui, view);
    position_ui(ui, view);
    block_buttons_ui(ui, view);
}

fn title(view: &View<'_>, cycle: &Cycle) -> String {
    format!("{}  {}", cycle.code, cycle.name(view.words.language().dialogue()))
}

/// All cycles, by the control's names for them.
fn chooser_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("cycles-cycle"));
    let chosen = view.session.cycles().cycle;
    let mut picked = None;
    let list = ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(space(14.0), control(ui)), Sense::hover());
        tile_picture(ui.painter(), palette(ui.ctx()), rect, chosen);
        let width = ui.available_width() - space(2.5);
        list_ui(ui, "cycle", title(view, chosen), width, |ui| picked = tiles_ui(ui, view, chosen, width))
    });
    let list = list.inner.labelled_by(name.id);
    if let Some(number) = picked {
        view.send(CyclesCommand::Choose(number));
        keep_focus(ui, &list);
    }
    for note in chosen.notes {
        quiet(ui, view.words.told(note));
    }
}

/// The height of a tile, and its least width.
const TILE: [f32; 2] = [14.0, 42.0];

/// Every cycle as a tile: its picture, its number, its name. Returns the one that was chosen just now.
fn tiles_ui(ui: &mut Ui, view: &View<'_>, chosen: &Cycle, width: f32) -> Option<u16> {
    let gap = space(1.0);
    let [height, least] = TILE.map(space);
    let is_wide = 2.0 * least + space(8.0) <= ui.ctx().content_rect().width();
    let size = vec2(if is_wide { least } else { width }, height.max(control(ui)));
    ui.spacing_mut().item_spacing = vec2(gap, gap);
    let mut picked = None;
    for row in CYCLES.chunks(if is_wide { 2 } else { 1 }) {
        ui.horizontal(|ui| {
            for cycle in row {
                if tile_ui(ui, view, cycle, (cycle.number == chosen.number, size)) {
                    picked = Some(cycle.number);
                    ui.close();
                }
            }
        });
    }
    picked
}

fn tile_ui(ui: &mut Ui, view: &View<'_>, cycle: &Cycle, (is_chosen, size): (bool, Vec2)) -> bool {
    let palette = palette(ui.ctx());
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    if ui.is_rect_visible(rect) {
        let fill = if is_chosen {
            palette.tint.0
        } else if response.hovered() {
            palette.hover.0
        } else {
            palette.surface.0
        };
        ui.painter().rect(rect, 8.0, fill, Stroke::new(1.0, palette.line.0), StrokeKind::Inside);
        let inner = rect.shrink(space(1.0));
        let picture = Rect::from_min_size(inner.min, vec2(space(13.0), inner.height()));
        tile_picture(ui.painter(), palette, picture, cycle);
        let left = picture.right() + space(1.5);
        let number = ui.painter().layout_no_wrap(cycle.code.to_owned(), theme::bold(sizes().body), palette.text.0);
        let room = inner.right() - left;
        let name = cycle.name(view.words.language().dialogue()).to_owned();
        let name = ui.painter().layout(name, theme::font(sizes().small), palette.text.0, room);
        let top = inner.center().y - f32::midpoint(number.size().y, name.size().y);
        let below = top + number.size().y;
        ui.painter().galley(pos2(left, top), number, palette.text.0);
        ui.painter().galley(pos2(left, below), name, palette.text.0);
    }
    if response.has_focus() {
        shapes::focus_ring(ui, rect);
    }
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_chosen, title(view, cycle)));
    response.clicked()
}

pub(super) const fn from_id(from: ContactsFrom) -> &'static str {
    match from {
        ContactsFrom::Perfect => "cycles-perfect",
        ContactsFrom::Simulated => "cycles-simulated",
        ContactsFrom::Recorded => "cycles-recorded",
    }
}

/// Where contacts come from, and what belongs to it.
fn source_ui(ui: &mut Ui, view: &mut View<'_>) {
    quiet(ui, view.text("cycles-contacts-from"));
    let from = view.session.cycles().from;
    ui.horizontal_wrapped(|ui| {
        for choice in ContactsFrom::ALL {
            if ui.radio(from == choice, view.text(from_id(choice))).clicked() {
                view.send(CyclesCommand::From(choice));
            }
        }
    });
    match from {
        ContactsFrom::Perfect => {}
        ContactsFrom::Simulated => {
            ui.horizontal(|ui| simulated_ui(ui, view));
            // An open dialog shows it beside the field.
            let session = view.session;
            if let Some(error) = session.workpiece().problem().filter(|_| !session.workpiece_is_open()) {
                problem(ui, view.words.say(&error));
            }
        }
        ContactsFrom::Recorded => _ = ui.horizontal(|ui| recorded_ui(ui, view)),
    }
    probe_ui(ui, view);
}

fn simulated_ui(ui: &mut Ui, view: &mut View<'_>) {
    opener_ui(ui, view, WorkpieceAction::EditWorkpiece, view.session.workpiece_is_open());
    view.button(ui, WorkpieceAction::SuitWorkpiece);
}

fn recorded_ui(ui: &mut Ui, view: &mut View<'_>) {
    view.button(ui, WorkpieceAction::OpenContacts);
    match &view.session.cycles().recorded {
        Some(recorded) => {
            let said = message!("cycles-contacts-of").count("count", recorded.contacts.len());
            quiet_cut(ui, view.words.say(&said.text("file", &recorded.name)));
        }
        None => _ = quiet(ui, view.text("cycles-no-file")),
    }
}

/// The row of the touch-probe table.
fn probe_ui(ui: &mut Ui, view: &mut View<'_>) {
    // What the table says of it has a line of its own where it has no room beside its number.
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = control(ui);
        let page = view.session.cycles();
        let name = quiet(ui, view.text("cycles-probe"));
        let probe = page.probe();
        let mut is_picked = false;
        let list = list_ui(ui, "cycle-probe", probe.number.to_string(), space(14.0), |ui| {
            for row in page.probes() {
                if ui.selectable_label(row.number == probe.number, row.number.to_string()).clicked() {
                    view.send(CyclesCommand::ChooseProbe(row.number));
                    is_picked = true;
                    ui.close();
                }
            }
            if view.button(ui, CyclesAction::OpenProbes).clicked() {
                ui.close();
            }
            if page.probes_name().is_some() && view.button(ui, CyclesAction::ShippedProbes).clicked() {
                is_picked = true;
                ui.close();
            }
        });
        let list = list.labelled_by(name.id);
        if is_picked {
            keep_focus(ui, &list);
        }
        let said = message!("cycles-probe-is").number("set-up", probe.set_up).number("dist", probe.longest_path);
        quiet(ui, view.words.say(&said));
    });
}

fn run_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let palette = palette(ui.ctx());
        ui.spacing_mut().item_spacing.x = space(1.5);
        // The two small buttons show their words in full.
        let small = |ui: &Ui, id: &str| {
            let galley = ui.painter().layout_no_wrap(view.words.get(id), theme::font(sizes().body), palette.text.0);
            galley.size().x + 2.0 * ui.spacing().button_padding.x + space(1.0)
        };
        let widths = [small(ui, "clear"), small(ui, "keypad")];
        let width = ui.available_width() - widths.iter().sum::<f32>() - space(5.0);
        view.main_button(ui, CyclesAction::RunCycle, vec2(width, control(ui)));
        view.field_button(ui, CyclesAction::ClearCycle);
        view.toggle(ui, WindowAction::Keypad);
    });
}

fn last_id() -> Id {
    Id::unique("cycle-parameter")
}

/// The parameter that had the focus last.
pub(super) fn last_focused(ui: &Ui) -> Option<Key> {
    ui.data(|data| data.get_temp(last_id()))
}

fn parameters_ui(ui: &mut Ui, view: &mut View<'_>) {
    let cycle = view.session.cycles().cycle;
    let mut focused = None;
    for group in ParameterGroup::ALL {
        group_ui(ui, view, group, &mut focused);
    }
    let idle = || cycle.parameters.iter().filter(|parameter| !parameter.has_effect);
    if idle().next().is_some() {
        let is_wrong = idle().any(|parameter| view.session.error(CycleField::Parameter(parameter.key)).is_some());
        let header = CollapsingHeader::new(view.text("cycles-without-effect")).id_salt("without-effect");
        folded_ui(ui, header.open(is_wrong.then_some(true)), |ui| {
            for parameter in idle() {
                if parameter_ui(ui, view, parameter) {
                    focused = Some(parameter.key);
                }
            }
        });
    }
    if let Some(key) = focused {
        ui.data_mut(|data| data.insert_temp(last_id(), key));
    }
}

/// The parameters of a group: those without a value of their own, and folded away those that have one.
fn group_ui(ui: &mut Ui, view: &mut View<'_>, group: ParameterGroup, focused: &mut Option<Key>) {
    let cycle = view.session.cycles().cycle;
    let of_group =
        cycle.parameters.iter().filter(|parameter| parameter.has_effect && parameter.meaning.group() == group);
    let (optional, needed): (Vec<_>, Vec<_>) = of_group.partition(|parameter| may_fold(parameter));
    let mut each = |ui: &mut Ui, view: &mut View<'_>, parameters: &[&'static Parameter]| {
        for parameter in parameters {
            if parameter_ui(ui, view, parameter) {
                *focused = Some(parameter.key);
            }
        }
    };
    if !needed.is_empty() {
        heading(ui, view.text(group_name(group)));
        each(ui, view, &needed);
    }
    if !optional.is_empty() {
        let is_wrong = |parameter: &&&Parameter| {
            let fields = [CycleField::Parameter(parameter.key), CycleField::Global(parameter.key)];
            fields.iter().any(|field| view.session.error(*field).is_some())
        };
        let section = Section {
            icon: Icon::Target,
            name: fold_name(cycle, group),
            value: in_force(view, &optional),
            is_wrong: optional.iter().any(|parameter| is_wrong(&parameter)),
        };
        section.show(ui, view, |ui, view| each(ui, view, &optional));
    }
}

/// What counts of parameters that may be left out: `Q320 0 mm, Q309 0`.
fn in_force(view: &View<'_>, parameters: &[&Parameter]) -> String {
    let page = view.session.cycles();
    let said = |parameter: &&Parameter| {
        let value = page.value(parameter).filter(|value| *value != Value::Band(None))?;
        Some(format!("{} {}", parameter.key, view.words.say(&value.with_unit())))
    };
    parameters.iter().filter_map(said).collect::<Vec<_>>().join(", ")
}

/// Where the ball stands before the cycle.
fn position_ui(ui: &mut Ui, view: &mut View<'_>) {
    let is_wrong = Axis::ALL.iter().any(|axis| view.session.error(CycleField::Position(*axis)).is_some());
    // An error is never folded away.
    let header = CollapsingHeader::new(view.text("cycles-position")).id_salt("cycle-position");
    folded_ui(ui, header.open(is_wrong.then_some(true)), |ui| {
        for axis in Axis::ALL {
            let name = format!("{} {}", view.text("cycles-ball-stands"), axis.letter());
            figure_ui(ui, view, CycleField::Position(axis), name, "mm");
        }
    });
}

fn block_buttons_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        opener_ui(ui, view, CyclesAction::PasteBlock, view.session.cycles().block.is_some());
        view.button(ui, CyclesAction::CopyBlock);
    });
}
