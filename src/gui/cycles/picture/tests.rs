//! The drawings, by what they say. Pictures of them are in the tests of the page.

use eframe::egui::accesskit::Role;
use eframe::egui::{Theme, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use super::meaning::Meaning;
use super::*;
use crate::gui::theme;
use crate::gui::view::View;
use crate::length::Length;
use crate::probing::circle::{Evaluation, evaluate};
use crate::probing::cycle::{Cycle, CycleResult, Inputs, Key, Move, Nominal, Parameter, Phase, Plane, Range, Value};
use crate::probing::cycles::{CYCLES, cycle, cycle_named};
use crate::probing::simulated::{Face, Lobes, Machine, Probe, Surface, Workpiece};
use crate::session::Session;
use crate::tolerance::Feature;
use crate::words::{Language, Words};

/// Draws in a window and gives it back, settled.
fn drawn<'a>(
    size: [f32; 2],
    theme: Theme,
    language: Language,
    mut draw: impl FnMut(&mut Ui, &View<'_>) + 'a,
) -> Harness<'a> {
    let (session, words) = (Session::new(language), Words::new(language));
    let mut harness = Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_theme(theme)
        .with_context_setup(theme::install)
        .build_ui(move |ui| draw(ui, &View { session: &session, words: &words, commands: Vec::new() }));
    harness.run();
    harness
}

#[track_caller]
fn says(harness: &Harness<'_>, role: Role, said: &str) {
    assert!(harness.query_by_role_and_label(role, said).is_some(), "{said}\n{harness:#?}");
}

/// Saves a picture to look at where FITCHECK_PICTURES names a folder.
fn save(harness: &mut Harness<'_>, name: &str) {
    if let Ok(folder) = std::env::var("FITCHECK_PICTURES") {
        harness.render().unwrap().save(format!("{folder}/{name}.png")).unwrap();
    }
}

#[test]
fn sheet() {
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        for cycle in CYCLES {
            let mut h = drawn([1120.0, 1150.0], theme, Language::En, |ui, view| {
                let shown: Vec<_> = cycle.parameters.iter().filter(|parameter| parameter.has_effect).collect();
                for row in shown.chunks(4) {
                    ui.horizontal(|ui| {
                        for parameter in row {
                            parameter_picture(ui, view, cycle, parameter.key);
                        }
                    });
                }
            });
            save(&mut h, &format!("parameters_{}_{name}", cycle.code));
        }
    }
}

/// Runs a cycle with settings as people type them.
fn run(code: &str, settings: &str, surface: Surface, ball_radius: f64) -> (CycleResult, Nominal) {
    let cycle = cycle_named(code).unwrap();
    let inputs = settings.split_whitespace().fold(Inputs::new(), |inputs, setting| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text).unwrap()
    });
    let probe = Probe { ball_radius, ..Probe::STILL };
    let mut machine = Machine::with(surface, probe, 1).unwrap();
    (cycle.measure(&inputs, &mut machine).unwrap(), cycle.nominal(&inputs).unwrap())
}

fn bore() -> (CycleResult, Nominal) {
    let hole = Workpiece {
        ovality: Lobes { count: 3, amplitude: 0.004, angle: 10.0 },
        ..Workpiece::round(Feature::Hole, [50.01, 20.004], 25.012)
    };
    let settings = "Q273=50 Q274=20 Q262=25 Q325=20 Q261=-5 Q260=20 Q275=25.021 Q276=25";
    run("421", settings, Surface::Round(hole, Plane::Xy), 3.0)
}

fn top(height: f64) -> (CycleResult, Nominal) {
    let face = Face { point: [0.0, 0.0, height], normal: [0.0, 0.0, 1.0], wave: None, surface_scatter: 0.0 };
    let settings = "Q263=35 Q264=45 Q261=5 Q320=0 Q272=3 Q267=-1 Q260=20 Q288=5.1 Q289=4.95";
    run("427", settings, Surface::Face(face), 2.0)
}

fn wall() -> (CycleResult, Nominal) {
    let face = Face { point: [0.0, 44.96, 0.0], normal: [0.0, 1.0, 0.0], wave: None, surface_scatter: 0.0 };
    let settings = "Q263=35 Q264=45 Q261=5 Q320=0 Q272=2 Q267=-1 Q260=20 Q288=45.1 Q289=44.95";
    run("427", settings, Surface::Face(face), 2.0)
}

fn evaluated(result: &CycleResult) -> Evaluation {
    evaluate(&result.plane_contacts()).unwrap()
}

#[test]
fn looks() {
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        let stud = Workpiece::round(Feature::Shaft, [50.0, 20.0], 24.99);
        let stud =
            run("422", "Q273=50 Q274=20 Q262=25 Q247=60 Q261=-5 Q260=10 Q301=1", Surface::Round(stud, Plane::Xy), 2.0);
        let inside = Workpiece::round(Feature::Hole, [0.0, 0.0], 20.0);
        let turned = run("G785", "K=5 RC=100 D=10 WB=3 WE=0.1", Surface::Round(inside, Plane::Xy), 1.5);
        let slope = Face { point: [10.0, 0.0, 5.02], normal: [1.0, 0.0, 2.0], wave: None, surface_scatter: 0.0 };
        let slope = run(
            "444",
            "Q263=10 Q264=0 Q294=5 Q581=1 Q582=0 Q583=2 Q260=30 QS400=0.1-0.1 MB=8",
            Surface::Face(slope),
            3.0,
        );
        for (code, (result, nominal), ball, step) in [
            ("421", bore(), 3.0, 9),
            ("422", stud, 2.0, 99),
            ("427", top(5.0), 2.0, 5),
            ("427y", wall(), 2.0, 4),
            ("785", turned, 1.5, 12),
            ("444", slope, 3.0, 4),
        ] {
            let mut h = drawn([720.0, 440.0], theme, Language::En, |ui, view| {
                path_picture(ui, view, &result.path, step, Some(nominal), ball)
            });
            save(&mut h, &format!("path_{code}_{name}"));
            let mut h = drawn([560.0, 400.0], theme, Language::Nl, |ui, view| {
                let evaluation = result.circle.is_some().then(|| evaluated(&result));
                contacts_picture(ui, view, &result, evaluation.as_ref());
            });
            save(&mut h, &format!("contacts_{code}_{name}"));
            if result.circle.is_some() {
                let mut h = drawn([760.0, 320.0], theme, Language::En, |ui, view| {
                    criteria_table(ui, view, &evaluated(&result))
                });
                save(&mut h, &format!("criteria_{code}_{name}"));
            }
        }
    }
}
