//! The dialog of the simulated workpiece: surface, probe, scatter, temperature, all from one seed and one file.

use eframe::egui::{Align2, Button, Id, Key, ScrollArea, Ui, Window, vec2};

use super::parameter_row::figure_ui;
use crate::gui::theme::{sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::probing::cycle::Plane;
use crate::session::{BenchField, BenchKind, Command, CycleField, CycleFile, CyclesCommand, Purpose};

/// The window, where it is open. What is typed counts at once.
pub(super) fn bench_ui(ui: &Ui, view: &mut View<'_>) {
    if !view.session.cycles().bench_is_open() {
        return;
    }
    let size = ui.ctx().content_rect().size();
    Window::new(view.text("simulated-workpiece"))
        .id(Id::unique("bench"))
        .anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0))
        .collapsible(false)
        .resizable(false)
        .show(ui, |ui| {
            ui.set_width((size.x * 0.9).min(space(200.0)));
            ScrollArea::vertical().max_height(size.y - space(50.0)).show(ui, |ui| content_ui(ui, view));
            ui.separator();
            buttons_ui(ui, view);
        });
    // What lies above is closed first.
    let is_top = view.session.dialog().is_none() && view.session.notices().is_empty();
    if is_top && ui.input(|input| input.key_pressed(Key::Escape)) && !ui.ctx().text_edit_focused() {
        view.send(Command::Cycles(CyclesCommand::ShowBench(false)));
    }
}

const fn kind_id(kind: BenchKind) -> &'static str {
    match kind {
        BenchKind::Bore => "cycles-kind-bore",
        BenchKind::Stud => "cycles-kind-stud",
        BenchKind::Face => "cycles-kind-face",
        BenchKind::Point => "cycles-kind-point",
    }
}

fn content_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    let kind = view.session.cycles().bench().kind();
    ui.horizontal(|ui| {
        for choice in BenchKind::ALL {
            if ui.radio(kind == choice, view.text(kind_id(choice))).clicked() {
                view.send(Command::Cycles(CyclesCommand::ChooseKind(choice)));
            }
        }
    });
    if matches!(kind, BenchKind::Bore | BenchKind::Stud) {
        plane_ui(ui, view);
    }
    ui.columns(2, |columns| {
        if let [left, right] = columns {
            left.spacing_mut().item_spacing.y = space(1.0);
            right.spacing_mut().item_spacing.y = space(1.0);
            heading(left, view.text(kind_id(kind)));
            fields_ui(left, view, kind.fields());
            heading(right, view.text("cycles-bench-probe"));
            fields_ui(right, view, BenchField::PROBE);
            heading(right, view.text("cycles-bench-machine"));
            fields_ui(right, view, BenchField::MACHINE);
        }
    });
}

fn plane_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        quiet(ui, view.text("cycles-plane"));
        let chosen = view.session.cycles().bench().plane();
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            if ui.radio(chosen == plane, plane.axes().join("/")).clicked() {
                view.send(Command::Cycles(CyclesCommand::ChoosePlane(plane)));
            }
        }
    });
}

fn fields_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[BenchField]) {
    for field in fields {
        figure_ui(ui, view, CycleField::Bench(*field), view.text(name_id(*field)), field.unit());
    }
}

fn buttons_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.horizontal(|ui| {
        let button = |id: &str| Button::new(view.words.get(id)).min_size(vec2(space(20.0), sizes().touch));
        let buttons = ["cycles-suit", "cycles-open-bench", "cycles-save-bench", "close"].map(button);
        let [suit, open, save, close] = buttons;
        if ui.add(suit).clicked() {
            view.send(Command::Cycles(CyclesCommand::SuitBench));
        }
        if ui.add(open).clicked() {
            view.send(Command::OpenDialog(Purpose::OpenCycleFile(CycleFile::Bench)));
        }
        if ui.add_enabled(view.session.cycles().bench().bench().is_some(), save).clicked() {
            view.send(Command::OpenDialog(Purpose::SaveBench));
        }
        if ui.add(close).clicked() {
            view.send(Command::Cycles(CyclesCommand::ShowBench(false)));
        }
    });
}

const fn name_id(field: BenchField) -> &'static str {
    match field {
        BenchField::CentreX => "cycles-bench-centre-1",
        BenchField::CentreY => "cycles-bench-centre-2",
        BenchField::Diameter => "true-diameter",
        BenchField::Ovality => "ovality",
        BenchField::OvalityAngle => "cycles-bench-ovality-angle",
        BenchField::LobeCount => "lobes",
        BenchField::LobeHeight => "lobe-height",
        BenchField::LobeAngle => "cycles-bench-lobe-angle",
        BenchField::PointX => "cycles-bench-point-x",
        BenchField::PointY => "cycles-bench-point-y",
        BenchField::PointZ => "cycles-bench-point-z",
        BenchField::NormalX => "cycles-bench-normal-x",
        BenchField::NormalY => "cycles-bench-normal-y",
        BenchField::NormalZ => "cycles-bench-normal-z",
        BenchField::WaveHeight => "cycles-bench-wave-height",
        BenchField::WaveLength => "cycles-bench-wave-length",
        BenchField::WaveX => "cycles-bench-wave-x",
        BenchField::WaveY => "cycles-bench-wave-y",
        BenchField::WaveZ => "cycles-bench-wave-z",
        BenchField::Deviation => "cycles-bench-deviation",
        BenchField::Radius => "cycles-bench-radius",
        BenchField::SurfaceScatter => "surface-scatter",
        BenchField::BallRadius => "cycles-bench-ball",
        BenchField::TriggerScatter => "cycles-bench-trigger",
        BenchField::CalibrationError => "cycles-bench-calibration",
        BenchField::OffsetX => "cycles-bench-offset-x",
        BenchField::OffsetY => "cycles-bench-offset-y",
        BenchField::LobingCount => "cycles-bench-lobing-count",
        BenchField::LobingHeight => "cycles-bench-lobing",
        BenchField::LobingAngle => "cycles-bench-lobing-angle",
        BenchField::Seed => "seed",
        BenchField::Temperature => "cycles-bench-temperature",
        BenchField::Expansion => "cycles-bench-expansion",
    }
}
