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

use image::{Pixel as _, RgbaImage};

use crate::harness::{Window, check, passes_as};

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

/// Without `UPDATE_SNAPSHOTS`, which takes whatever is there.
#[test]
fn a_picture_may_differ_in_what_drivers_differ_in_and_in_nothing_that_a_person_sees() {
    if !can_paint("thresholds") || std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        return;
    }
    let painted = |measured: &str| {
        let mut window: Harness<'_, App> =
            Window { theme: Theme::Dark, size: vec2(1024.0, 600.0), ..Window::default() }.open();
        check(&mut window, "25 h7", measured);
        let word = window.get_by_label("Why?").rect();
        (window.render().unwrap(), word)
    };
    let (expected, word) = painted("25.004");
    let changed = |change: &dyn Fn(&mut RgbaImage)| {
        let mut picture = expected.clone();
        change(&mut picture);
        passes_as(&picture, &expected)
    };
    let invert = |picture: &mut RgbaImage, places: &[(u32, u32)]| {
        for (x, y) in places {
            picture.get_pixel_mut(*x, *y).invert();
        }
    };
    assert!(changed(&|_same| {}));
    assert!(changed(&|picture| picture
        .pixels_mut()
        .for_each(|pixel| pixel.apply_without_alpha(|c| c.saturating_add(2)))));
    assert!(changed(&|picture| invert(picture, &[(300, 300), (400, 310), (500, 320)])), "pixels on edges");
    assert!(!changed(&|picture| invert(picture, &[(300, 300), (301, 300), (300, 301), (301, 301)])), "a decimal point");
    assert!(
        !changed(&|picture| picture.pixels_mut().for_each(|pixel| pixel.apply_without_alpha(|c| c.saturating_add(6)))),
        "a colour"
    );
    let moved = |picture: &mut RgbaImage| {
        #[expect(
            clippy::as_conversions,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a place in the window"
        )]
        let [left, right, top, bottom] = [word.left(), word.right(), word.top(), word.bottom()].map(|at| at as u32);
        for y in top..bottom {
            for x in (left..right).rev() {
                let pixel = *picture.get_pixel(x - 1, y);
                picture.put_pixel(x, y, pixel);
            }
        }
    };
    assert!(!changed(&moved), "a word that moved by a pixel");
    assert!(!passes_as(&painted("25.005").0, &expected), "another digit");
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
