//! The drawings, by their descriptions; three pictures of them. Rewrite those with `UPDATE_SNAPSHOTS=1`.

#![cfg(feature = "gui-tests")]

use eframe::egui::accesskit::Role;
use eframe::egui::{Theme, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

mod painted;

use super::*;
use crate::gui::theme;
use crate::gui::view::View;
use crate::probing::circle::{Evaluation, evaluate};
use crate::probing::cycle::{Cycle, CycleResult, Inputs, Key, Meaning, Move, Phase, Plane};
use crate::probing::cycles::{CYCLES, cycle, cycle_named};
use crate::probing::simulated::{Face, Lobes, Machine, Probe, Surface, Walls, Workpiece};
use crate::session::Session;
use crate::tolerance::Feature;
use crate::words::{Language, Words};

/// Draws in a window and returns it, settled.
fn drawn<'a>(
    size: [f32; 2],
    theme: Theme,
    language: Language,
    mut draw: impl FnMut(&mut Ui, &View<'_>) + 'a,
) -> Harness<'a> {
    let session = Session::new(language);
    let words = Words::new(language);
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

/// Runs a cycle with settings as people type them.
fn run(code: &str, settings: &str, surface: Surface, ball_radius: f64) -> (CycleResult, Surface) {
    let cycle = cycle_named(code).unwrap();
    let inputs = settings.split_whitespace().fold(Inputs::new(), |inputs, setting| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text).unwrap()
    });
    let probe = Probe { ball_radius, ..Probe::STILL };
    let mut machine = Machine::with(surface, probe, 1).unwrap();
    (cycle.measure(&inputs, &mut machine).unwrap(), cycle.nominal(&inputs).unwrap())
}

fn bore() -> (CycleResult, Surface) {
    let hole = Workpiece {
        ovality: Lobes { count: 2, amplitude: 0.004, angle: 10.0 },
        ..Workpiece::round(Feature::Hole, [50.01, 20.004], 25.012)
    };
    let settings = "Q273=50 Q274=20 Q262=25 Q325=20 Q261=-5 Q260=20 Q275=25.021 Q276=25";
    run("421", settings, Surface::Round(hole, Plane::Xy), 3.0)
}

fn top(height: f64) -> (CycleResult, Surface) {
    let face = Face { point: [0.0, 0.0, height], normal: [0.0, 0.0, 1.0], wave: None, surface_scatter: 0.0 };
    let settings = "Q263=35 Q264=45 Q261=5 Q320=0 Q272=3 Q267=-1 Q260=20 Q288=5.1 Q289=4.95";
    run("427", settings, Surface::Face(face), 2.0)
}

fn evaluated(result: &CycleResult) -> Evaluation {
    evaluate(&result.plane_contacts()).unwrap()
}

/// Whether pictures can be made here; without a Vulkan driver they are skipped, except under CI.
fn can_paint() -> bool {
    let renderer = std::panic::catch_unwind(egui_kittest::wgpu::WgpuTestRenderer::new);
    assert!(renderer.is_ok() || std::env::var("CI").is_err(), "no Vulkan driver, and CI must have one");
    renderer.is_ok()
}

fn label_of(cycle: &'static Cycle, key: Key, language: Language) -> String {
    let harness =
        drawn([300.0, 260.0], Theme::Light, language, |ui, view| parameter_picture(ui, view, cycle, key, false));
    let label = harness.get_by_role(Role::Image).accesskit_node().label();
    label.unwrap()
}

#[test]
fn every_parameter_with_effect_has_its_own_drawing_and_sentence() {
    for cycle in CYCLES {
        let mut meanings: Vec<Meaning> = Vec::new();
        for parameter in cycle.parameters.iter().filter(|parameter| parameter.has_effect) {
            let meaning = parameter.meaning;
            assert!(!meaning.is_general(), "{} {} is drawn by its range only", cycle.code, parameter.key);
            assert!(!meanings.contains(&meaning), "{} {}: {meaning:?} twice", cycle.code, parameter.key);
            meanings.push(meaning);
            for language in Language::all() {
                let words = Words::new(language);
                let said = label_of(cycle, parameter.key, language);
                assert_eq!(said, format!("{}: {}", parameter.key, words.get(meaning.sentence())));
                assert_ne!(words.get(meaning.sentence()), meaning.sentence());
            }
        }
    }
}

#[test]
fn a_sentence_has_room_below_its_drawing() {
    // The panel below must not jump: three lines of the drawing's width are enough in every language.
    for language in Language::all() {
        let words = Words::new(language);
        for cycle in CYCLES {
            for parameter in cycle.parameters.iter().filter(|parameter| parameter.has_effect) {
                let said = parameter::sentence(&words, parameter);
                drawn([300.0, 100.0], Theme::Light, language, |ui, _| {
                    let font = theme::font(theme::sizes().small);
                    let galley = ui.painter().layout(said.clone(), font, eframe::egui::Color32::PLACEHOLDER, 260.0);
                    assert!(galley.rows.len() <= 3, "{said}");
                });
            }
        }
    }
}

#[test]
fn a_drawing_says_what_its_key_means() {
    #[track_caller]
    fn check(code: &str, name: &str, said: &str) {
        let cycle = cycle_named(code).unwrap();
        assert_eq!(label_of(cycle, cycle.parameter_named(name).unwrap().key, Language::En), said);
    }
    check("421", "Q273", "Q273: nominal centre in the first axis");
    check("422", "Q277", "Q277: largest permitted diameter");
    check("427", "Q272", "Q272: measured axis: 1 first axis, 2 second axis, 3 probe axis");
    check("444", "QS400", "QS400: permitted deviation along the normal: oversize plus, undersize minus");
    check("444", "Q309", "Q309: out of tolerance: 0 the program continues, 1 it stops, 2 it stops on undersize only");
    check("425", "Q310", "Q310: offset of the second contact along the walls; 0 probes opposite the first");
    check("425", "Q272", "Q272: measured axis: 1 first axis, 2 second axis");
    check("424", "Q286", "Q286: largest permitted length along the second axis");
    check("G785", "K", "K: longest probing path; plus leads away from the centre, minus towards it");
}

#[test]
fn what_has_no_effect_is_drawn_by_its_range_and_a_key_that_is_none_not_at_all() {
    let idle = || CYCLES.iter().flat_map(|cycle| cycle.parameters.iter().map(move |parameter| (*cycle, parameter)));
    for (cycle, parameter) in idle().filter(|(_, parameter)| !parameter.has_effect) {
        assert!(parameter.meaning.is_general());
        let said = label_of(cycle, parameter.key, Language::En);
        let question = parameter.question(Language::En.dialogue());
        assert!(said.starts_with(&format!("{}: {question} ", parameter.key)), "{said}");
    }
    let said = |code: &str, name: &str, language| {
        let cycle = cycle_named(code).unwrap();
        label_of(cycle, cycle.parameter_named(name).unwrap().key, language)
    };
    assert_eq!(said("427", "Q498", Language::En), "Q498: Reverse tool (0=no/1=yes)? One of 0, 1");
    assert_eq!(said("427", "Q531", Language::Nl), "Q531: Invalshoek? Een hoek");
    assert_eq!(said("G785", "Q", Language::En), "Q: Q A length");
    let nothing = drawn([300.0, 260.0], Theme::Light, Language::En, |ui, view| {
        parameter_picture(ui, view, cycle_named("425").unwrap(), Key::Q(1), false);
    });
    assert!(nothing.query_by_role(Role::Image).is_none());
}

#[test]
fn a_rectangle_says_every_value_that_was_compared() {
    let walls = Surface::Walls(Walls::new(Feature::Hole, [50.0, 20.0], (60.2, Some(40.0))));
    let settings = "Q273=50 Q274=20 Q282=60 Q283=40 Q261=-5 Q284=60.1 Q285=60 Q286=40.1 Q287=40";
    let (result, nominal) = run("423", settings, walls, 2.0);
    let harness = drawn([560.0, 400.0], Theme::Light, Language::En, |ui, view| {
        contacts_picture(ui, view, &result, None);
    });
    says(&harness, Role::Image, "measured length, 1st side 60.2 mm is above its maximum 60.1 mm: SCRAP");
    says(&harness, Role::Image, "measured length, 2nd side 40 mm is within 40 to 40.1 mm");
    for step in 0..=result.path.len() {
        assert!(path_label(&result.path, step, Some(nominal), 2.0).starts_with("Path of the probe, "));
    }
}

fn path_label(path: &[Move], step: usize, nominal: Option<Surface>, ball_radius: f64) -> String {
    let harness = drawn([640.0, 400.0], Theme::Light, Language::En, |ui, view| {
        path_picture(ui, view, path, step, Surroundings::of(nominal, ball_radius));
    });
    assert_eq!(
        harness.output().viewport_output[&eframe::egui::ViewportId::ROOT].repaint_delay,
        std::time::Duration::MAX,
        "a drawing stands still"
    );
    let label = harness.get_by_role(Role::Image).accesskit_node().label();
    label.unwrap()
}

#[test]
fn the_path_says_where_the_ball_is() {
    let (result, nominal) = top(5.0);
    let said = |step| path_label(&result.path, step, Some(nominal), 2.0);
    assert_eq!(said(0), "Path of the probe, 0 of 5 moves done, 1 contact. Ball at X 35.000, Y 45.000, Z 20.000 mm.");
    assert_eq!(
        said(2),
        "Path of the probe, 2 of 5 moves done, 1 contact. Ball at X 35.000, Y 45.000, Z 7.000 mm. approach, contact 1"
    );
    let end = "Path of the probe, 5 of 5 moves done, 1 contact. Ball at X 35.000, Y 45.000, Z 20.000 mm. leave";
    assert_eq!(said(5), end);
    assert_eq!(said(99), end);
}

#[test]
fn no_path_and_no_extent_and_no_number_are_drawn_without_harm() {
    assert_eq!(path_label(&[], 3, None, 2.0), "The path appears when the cycle has run");
    let still = |at: [f64; 3]| Move { phase: Phase::Contact, touch: Some(1), from: at, to: at, about: None };
    let said = |at| path_label(&[still(at)], 1, None, 0.0);
    assert_eq!(
        said([1e6, -1e6, 0.0]),
        "Path of the probe, 1 of 1 moves done, 1 contact. Ball at X 1000000.000, Y −1000000.000, Z 0.000 mm. \
         contact, contact 1"
    );
    for at in [[f64::NAN, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0], [1e300, 0.0, 0.0]] {
        assert_eq!(said(at), "The path appears when the cycle has run");
    }
    // A circle of a micrometre, far away, and arcs about a centre where the ball is.
    let centre = [1e6, 1e6];
    let circle = Surface::Round(Workpiece::round(Feature::Hole, centre, 0.001), Plane::Zx);
    let about = Move { about: Some([1e6; 3]), ..still([1e6; 3]) };
    path_label(&[about], 1, Some(circle), 0.0);
    let flat = Surface::Face(Face::plane([0.0; 3], [0.0; 3]));
    path_label(&[still([0.0; 3])], 1, Some(flat), f64::NAN);
    let lost = Surface::Face(Face::plane([f64::NAN; 3], [f64::NAN; 3]));
    let slot = Surface::Walls(Walls::new(Feature::Hole, [f64::NAN; 2], (f64::INFINITY, None)));
    path_label(&[still([0.0; 3])], 1, Some(slot), 1.0);
    path_label(&[still([0.0; 3])], 1, Some(lost), 1e300);
}

fn contacts_label(result: &CycleResult, evaluation: Option<&Evaluation>, language: Language) -> String {
    let harness = drawn([560.0, 400.0], Theme::Light, language, |ui, view| {
        contacts_picture(ui, view, result, evaluation);
    });
    let label = harness.get_by_role(Role::Image).accesskit_node().label();
    label.unwrap()
}

#[test]
fn contacts_say_their_deviations_and_the_factor() {
    let hole = Workpiece {
        ovality: Lobes { count: 2, amplitude: 0.002, angle: 0.0 },
        ..Workpiece::round(Feature::Hole, [50.0, 20.0], 25.01)
    };
    let (result, _) = run("421", "Q273=50 Q274=20 Q262=25", Surface::Round(hole, Plane::Xy), 0.0);
    let expected = "4 contacts about their least-squares circle Ø 25.0100 mm, deviations × 500: \
                    1  +2.0 µm; 2  −2.0 µm; 3  +2.0 µm; 4  −2.0 µm. Nominal circle Ø 25.0000 mm.";
    assert_eq!(contacts_label(&result, None, Language::En), expected);
    assert_eq!(contacts_label(&result, Some(&evaluated(&result)), Language::En), expected);
    // An evaluation of other contacts is not used.
    let other = Evaluation { residuals: vec![1.0], ..evaluated(&result) };
    assert_eq!(contacts_label(&result, Some(&other), Language::En), expected);
}

#[test]
fn one_point_says_its_value_between_its_limits() {
    let said = |height| contacts_label(&top(height).0, None, Language::En);
    assert_eq!(said(5.0), "measured coordinate 5 mm is within 4.95 to 5.1 mm");
    assert_eq!(said(5.100_001), "measured coordinate 5.100001 mm is above its maximum 5.1 mm: REWORK");
    assert_eq!(said(-30.0), "measured coordinate −30 mm is below its minimum 4.95 mm: SCRAP");
    let slope = Face { point: [10.0, 0.0, 5.02], normal: [0.0, 0.0, 1.0], wave: None, surface_scatter: 0.0 };
    let (free, _) = run("444", "Q263=10 Q264=0 Q294=5 Q581=0 Q582=0 Q583=1", Surface::Face(slope), 3.0);
    assert_eq!(contacts_label(&free, None, Language::En), "deviation along the normal 0.02 mm, without a tolerance");
    // Nothing was compared: a sentence instead of a picture.
    let face = Face { point: [0.0; 3], normal: [0.0, 0.0, 1.0], wave: None, surface_scatter: 0.0 };
    let (free, _) = run("427", "Q263=0 Q264=0 Q261=0 Q272=3 Q267=-1", Surface::Face(face), 3.0);
    let harness = drawn([560.0, 200.0], Theme::Light, Language::En, |ui, view| contacts_picture(ui, view, &free, None));
    says(&harness, Role::Label, "No limits were given: nothing was compared");
}

#[test]
fn a_cell_of_the_criteria_says_its_row_and_column() {
    let (result, _) = bore();
    let harness = drawn([760.0, 320.0], Theme::Light, Language::En, |ui, view| {
        criteria_table(ui, view, &evaluated(&result));
    });
    says(&harness, Role::Label, "Least squares, Ø in mm 25.0120");
    says(&harness, Role::Label, "Two-point size 1–3, Centre, 1st axis —");
    says(
        &harness,
        Role::Label,
        "Scatter s of a contact gives 1.00 s in the diameter, 0.87 times that of 3 contacts at 120°, \
         and 0.71 s to 0.71 s in the centre",
    );
    says(&harness, Role::Label, "• 4 contacts: four lobes are not detected and change the diameter");
    let few = Workpiece::round(Feature::Hole, [0.0, 0.0], 20.0);
    let (result, _) = run("421", "Q273=0 Q274=0 Q262=20 Q247=20", Surface::Round(few, Plane::Xy), 0.0);
    let harness = drawn([760.0, 320.0], Theme::Light, Language::En, |ui, view| {
        criteria_table(ui, view, &evaluated(&result));
    });
    says(&harness, Role::Label, "Maximum inscribed, no maximum inscribed circle: the contacts do not surround one");
    says(&harness, Role::Label, "Two-point size, no two contacts oppose each other");
    says(
        &harness,
        Role::Label,
        "• the contacts cover only 60.0° of arc: scatter in the diameter is 13.5 times that of 3 contacts at 120°",
    );
}

#[test]
fn the_parameters_of_every_kind_of_picture_in_light() {
    const SHOWN: [(u16, &str); 12] = [
        (421, "Q273"),
        (421, "Q325"),
        (421, "Q247"),
        (421, "Q320"),
        (422, "Q301"),
        (422, "Q277"),
        (427, "Q263"),
        (427, "Q272"),
        (444, "Q583"),
        (444, "QS400"),
        (785, "R"),
        (785, "D"),
    ];
    let mut harness = drawn([1100.0, 680.0], Theme::Light, Language::En, |ui, view| {
        for row in SHOWN.chunks(4) {
            ui.horizontal(|ui| {
                for (number, name) in row {
                    let cycle = cycle(*number).unwrap();
                    parameter_picture(ui, view, cycle, cycle.parameter_named(name).unwrap().key, false);
                }
            });
        }
    });
    if can_paint() {
        harness.snapshot("cycle_parameters_light");
    }
}

#[test]
fn a_path_half_way_in_dark() {
    let (result, nominal) = bore();
    let mut harness = drawn([720.0, 420.0], Theme::Dark, Language::En, |ui, view| {
        path_picture(ui, view, &result.path, 9, Surroundings::of(Some(nominal), 3.0));
    });
    if can_paint() {
        harness.snapshot("cycle_path_dark");
    }
}

#[test]
fn contacts_and_criteria_in_light() {
    let (result, _) = bore();
    let mut harness = drawn([700.0, 640.0], Theme::Light, Language::En, |ui, view| {
        let evaluation = evaluated(&result);
        ui.allocate_ui(vec2(684.0, 340.0), |ui| contacts_picture(ui, view, &result, Some(&evaluation)));
        criteria_table(ui, view, &evaluation);
    });
    if can_paint() {
        harness.snapshot("cycle_contacts_light");
    }
}
