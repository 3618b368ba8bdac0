//! What the window keeps: soon after every change, beside other windows, and never over what it cannot read.

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::ViewportId;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::files::{LARGEST, ZoneError};
use fitcheck::gui::{App, Store};
use fitcheck::message::Say as _;
use fitcheck::session::{CheckCommand, CheckField, Command, FitCommand, FitField, Saved};

use crate::harness::{Window, check, verdict};

#[test]
fn last_inputs_survive_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("fitcheck").join("state.toml"));
    let mut first = Window { store: store.clone(), ..Window::default() }.open();
    check(&mut first, "40 js6", "40.001");
    eframe::App::on_exit(first.state_mut(), None);
    let again = Window { store, ..Window::default() }.open();
    let field = again.get_by_role_and_label(Role::TextInput, "Callout");
    assert_eq!(field.accesskit_node().value().as_deref(), Some("40 js6"));
    assert_eq!(verdict(&again), "No result. 39.992 … 40.008 mm", "a verdict is never shown without a measurement");
}

#[test]
fn a_broken_state_file_is_set_aside_and_the_window_opens() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    std::fs::File::create(&path).and_then(|mut file| std::io::Write::write_all(&mut file, b"language = [")).unwrap();
    let window = Window { store: Store::at(&path), ..Window::default() }.open();
    window.get_by_label_contains("state.toml.broken-1");
    assert!(folder.path().join("state.toml.broken-1").exists());
}

fn saved(path: &Path) -> Saved {
    Saved::read(&std::fs::read(path).unwrap()).unwrap()
}

fn at(path: &Path) -> Harness<'static, App> {
    Window { store: Store::at(path), ..Window::default() }.open()
}

/// Frames of more than a second together.
fn wait(window: &mut Harness<'_, App>) {
    window.run_steps(6);
}

fn type_text(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
}

#[test]
fn what_was_typed_is_kept_while_the_window_is_open_and_then_it_is_idle() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    let mut window = at(&path);
    check(&mut window, "40 js6", "40.001");
    wait(&mut window);
    assert_eq!(Saved::read(&std::fs::read(&path).unwrap()).unwrap().inputs.texts["callout"], "40 js6");
    window.run();
    assert_eq!(window.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
    let before = path.metadata().unwrap().modified().unwrap();
    wait(&mut window);
    assert_eq!(path.metadata().unwrap().modified().unwrap(), before, "nothing has changed, so nothing is written");
}

#[test]
fn two_windows_keep_what_each_of_them_has_changed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    let (mut one, mut two) = (at(&path), at(&path));
    type_text(&mut one, CheckCommand::Type(CheckField::Callout, "40 js6".into()));
    wait(&mut one);
    type_text(&mut two, FitCommand::Type(FitField::Callout, "50 H7/p6".into()));
    wait(&mut two);
    type_text(&mut one, CheckCommand::Type(CheckField::Callout, "60 k6".into()));
    eframe::App::on_exit(one.state_mut(), None);
    eframe::App::on_exit(two.state_mut(), None);
    let texts = saved(&path).inputs.texts;
    assert_eq!((texts["callout"].as_str(), texts["fit-callout"].as_str()), ("60 k6", "50 H7/p6"));
}

#[test]
fn what_cannot_be_read_is_set_aside_and_never_written_over() {
    type Kind = (&'static str, fn(&Path));
    let kinds: &[Kind] = &[
        ("too large", |path| std::fs::File::create(path).unwrap().set_len(LARGEST + 1).unwrap()),
        ("a folder", |path| std::fs::create_dir(path).unwrap()),
        #[cfg(unix)]
        ("a pipe", |path| assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success())),
    ];
    for (kind, make) in kinds {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.toml");
        make(&path);
        let mut window = at(&path);
        window.get_by_label_contains("state.toml.broken-1");
        let aside = folder.path().join("state.toml.broken-1");
        let is_same = |path: &PathBuf| !path.is_file() || path.metadata().unwrap().len() == LARGEST + 1;
        assert!(aside.exists() && is_same(&aside), "{kind}");
        check(&mut window, "40 js6", "40.001");
        wait(&mut window);
        assert_eq!(saved(&path).inputs.texts["callout"], "40 js6", "{kind}");
        assert!(aside.exists() && is_same(&aside), "{kind}");
    }
}

#[test]
fn what_breaks_while_the_window_is_open_is_set_aside_and_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    let mut window = at(&path);
    fitcheck::files::write(&path, b"language = [").unwrap();
    check(&mut window, "40 js6", "40.001");
    wait(&mut window);
    window.get_by_label_contains("state.toml.broken-1");
    assert_eq!(std::fs::read(folder.path().join("state.toml.broken-1")).unwrap(), b"language = [");
    assert_eq!(saved(&path).inputs.texts["callout"], "40 js6");
    window.key_press(eframe::egui::Key::Escape);
    window.run();
    // A later version's file is not touched.
    fitcheck::files::write(&path, b"version = 99\n").unwrap();
    check(&mut window, "60 k6", "60.01");
    wait(&mut window);
    window.get_by_label_contains("is not saved");
    assert_eq!(std::fs::read(&path).unwrap(), b"version = 99\n");
}

#[cfg(unix)]
#[test]
fn a_linked_state_file_stays_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let (path, real) = (folder.path().join("state.toml"), folder.path().join("real.toml"));
    std::os::unix::fs::symlink(&real, &path).unwrap();
    let mut window = at(&path);
    check(&mut window, "40 js6", "40.001");
    wait(&mut window);
    assert!(path.is_symlink());
    assert_eq!(saved(&real).inputs.texts["callout"], "40 js6");
}

#[test]
fn a_time_zone_that_is_not_understood_is_told_when_the_window_opens() {
    let error = ZoneError::NotUnderstood { given: "Europe/Amsterdm".to_owned() };
    let window = Window { told: vec![error.message()], ..Window::default() }.open();
    window.get_by_label_contains("TZ is set to \"Europe/Amsterdm\", which is not a time zone");
}
