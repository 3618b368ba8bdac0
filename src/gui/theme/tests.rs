//! Contrast of text, and verdicts that are told apart in greyscale.

use super::{Hex, TOKENS};

/// Contrast according to WCAG 2.1, success criterion 1.4.3: relative luminance of sRGB.
fn contrast(one: Hex, other: Hex) -> f64 {
    let luminance = |Hex(colour): Hex| {
        let channel = |value: u8| {
            let value = f64::from(value) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * channel(colour.r()) + 0.7152 * channel(colour.g()) + 0.0722 * channel(colour.b())
    };
    let one = luminance(one);
    let other = luminance(other);
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

#[test]
fn every_text_has_contrast_enough() {
    for palette in [&TOKENS.light, &TOKENS.dark] {
        for (name, text, ground, least) in [
            ("text on panel", palette.text, palette.panel, 7.0),
            ("text on field", palette.text, palette.field, 7.0),
            ("text on background", palette.text, palette.background, 7.0),
            ("text on selection", palette.text, palette.selection, 7.0),
            ("quiet on panel", palette.quiet, palette.panel, 7.0),
            ("quiet on background", palette.quiet, palette.background, 7.0),
            ("error on panel", palette.error, palette.panel, 7.0),
            ("keyword on panel", palette.keyword, palette.panel, 4.5),
            ("keyword on field", palette.keyword, palette.field, 4.5),
            ("keyword on selection", palette.keyword, palette.selection, 4.5),
            ("accent on selection", palette.accent, palette.selection, 4.5),
            ("quiet on selection", palette.quiet, palette.selection, 4.5),
            ("accent on panel", palette.accent, palette.panel, 4.5),
            ("on accent", palette.on_accent, palette.accent, 4.5),
            ("on good", palette.on_good, palette.good, 7.0),
            ("on rework", palette.on_rework, palette.rework, 7.0),
            ("on scrap", palette.on_scrap, palette.scrap, 4.5),
            ("on re-measure", palette.on_re_measure, palette.re_measure, 4.5),
            ("on pale good", palette.on_pale, palette.pale_good, 7.0),
            ("on pale rework", palette.on_pale, palette.pale_rework, 7.0),
            ("on pale scrap", palette.on_pale, palette.pale_scrap, 7.0),
            ("on pale re-measure", palette.on_pale, palette.pale_re_measure, 7.0),
            ("on none", palette.on_none, palette.none, 4.5),
            ("zone edge", palette.zone_edge, palette.zone, 7.0),
            ("text on hole zone", palette.text, palette.hole, 7.0),
            ("text on shaft zone", palette.text, palette.shaft, 7.0),
            ("text on popup", palette.text, palette.popup, 7.0),
            ("popup title", palette.on_popup_title, palette.popup_title, 7.0),
        ] {
            assert!(least <= contrast(text, ground), "{name}: {:.2}", contrast(text, ground));
        }
    }
}

#[test]
fn verdicts_are_told_apart_in_greyscale() {
    for palette in [&TOKENS.light, &TOKENS.dark] {
        let fills = [palette.good, palette.rework, palette.re_measure, palette.scrap];
        for (number, one) in fills.iter().enumerate() {
            for other in fills.iter().take(number) {
                assert!(1.4 <= contrast(*one, *other), "{one:?} {other:?}: {:.2}", contrast(*one, *other));
            }
        }
    }
}

#[test]
fn a_simulated_verdict_is_told_apart_from_a_measured_one_in_greyscale() {
    for palette in [&TOKENS.light, &TOKENS.dark] {
        for (measured, simulated) in [
            (palette.good, palette.pale_good),
            (palette.rework, palette.pale_rework),
            (palette.scrap, palette.pale_scrap),
            (palette.re_measure, palette.pale_re_measure),
        ] {
            let is = contrast(measured, simulated);
            assert!(1.15 <= is, "{measured:?} {simulated:?}: {is:.2}");
        }
    }
}
