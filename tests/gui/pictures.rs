//! A few small pictures of what words cannot express: the limit band and the status window, light and dark.
//!
//! They need a Vulkan driver; a software one is enough. Where there is none the test says so and passes, except under
//! CI, where it fails. Rewrite them with `UPDATE_SNAPSHOTS=1 cargo test --all-features`.

use std::panic::catch_unwind;

use eframe::egui::{Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;
use fitcheck::session::{CheckCommand, CheckField};
use fitcheck::verdict::rules::RuleName;

use crate::harness::{Window, check};

/// Whether pictures can be made here.
pub fn can_paint(test: &str) -> bool {
    let renderer = catch_unwind(egui_kittest::wgpu::WgpuTestRenderer::new);
    assert!(renderer.is_ok() || std::env::var("CI").is_err(), "no Vulkan driver, and CI must have one");
    if renderer.is_err() {
        println!("{test}: skipped, because no Vulkan driver was found (install mesa-vulkan-drivers)");
    }
    renderer.is_ok()
}

fn picture(name: &str, theme: Theme, callout: &str, measured: &str) {
    if !can_paint(name) {
        return;
    }
    let mut window: Harness<'_, App> = Window { theme, size: vec2(1024.0, 600.0), ..Window::default() }.open();
    check(&mut window, callout, measured);
    window.snapshot(name);
}

#[test]
fn a_good_hole_in_light() {
    picture("good_hole_light", Theme::Light, "25 H7", "25.012");
}

#[test]
fn a_shaft_to_rework_in_dark() {
    picture("rework_shaft_dark", Theme::Dark, "25 h7", "25.004");
}

/// A value in a guard band: told apart from every other status without colour.
fn guarded(name: &str, theme: Theme) {
    if !can_paint(name) {
        return;
    }
    let mut window: Harness<'_, App> = Window { theme, ..Window::default() }.open();
    let ctx = window.ctx.clone();
    for command in
        [CheckCommand::UseRule(RuleName::Iso14253Of2017), CheckCommand::Type(CheckField::Uncertainty, "1.2".to_owned())]
    {
        window.state_mut().send(&ctx, command.into());
    }
    window.run();
    window.get_by_label("Decision rule: ISO 14253-1:2017, 95 %").click();
    check(&mut window, "25 H7", "25.0195");
    window.get_by_label("Why?").click();
    window.run();
    window.snapshot(name);
}

#[test]
fn a_value_in_a_guard_band_in_light() {
    guarded("re_measure_light", Theme::Light);
}

#[test]
fn a_value_in_a_guard_band_in_dark() {
    guarded("re_measure_dark", Theme::Dark);
}

#[test]
fn scrap_far_outside_in_light() {
    picture("scrap_far_light", Theme::Light, "25 H7", "25.200");
}
