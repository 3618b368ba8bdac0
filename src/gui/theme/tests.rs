//! Contrast of text, and verdicts that are told apart in greyscale.

use eframe::egui::{Context, FontFamily, FontId, RawInput};

use super::{Hex, Icon, TOKENS, Weight};

/// Contrast according to WCAG 2.1, success criterion 1.4.3: relative luminance of sRGB.
fn contrast(one: Hex, other: Hex) -> f64 {
    let luminance = |Hex(colour): Hex| {
        let channel = |value: u8| {
            let value = f64::from(value) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        };
        0.2126 * channel(colour.r()) + 0.7152 * channel(colour.g()) + 0.0722 * channel(colour.b())
    };
    let one = luminance(one);
    let other = luminance(other);
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

#[test]
fn every_text_has_contrast_enough() {
    for palette in [&TOKENS.light, &TOKENS.dark, &TOKENS.contrast, &TOKENS.inverted] {
        let grounds = [palette.canvas, palette.surface, palette.sunken, palette.hover, palette.tint];
        for ground in grounds {
            for (name, text, least) in [
                ("text", palette.text, 7.0),
                ("quiet", palette.quiet, 7.0),
                ("accent", palette.accent, 7.0),
                ("keyword", palette.keyword, 4.5),
                ("focus", palette.focus, 3.0),
                ("data", palette.data, 4.5),
                ("error", palette.error, 4.5),
            ] {
                assert!(least <= contrast(text, ground), "{name} on {ground:?}: {:.2}", contrast(text, ground));
            }
        }
        for (name, text, ground, least) in [
            ("error on surface", palette.error, palette.surface, 7.0),
            ("edge on surface", palette.edge, palette.surface, 3.0),
            ("on accent", palette.on_accent, palette.accent, 7.0),
            ("on good", palette.on_good, palette.good, 7.0),
            ("on rework", palette.on_rework, palette.rework, 7.0),
            ("on scrap", palette.on_scrap, palette.scrap, 7.0),
            ("on re-measure", palette.on_re_measure, palette.re_measure, 7.0),
            ("on out of limits", palette.on_out_of_limits, palette.out_of_limits, 7.0),
            ("on pale good", palette.on_pale, palette.pale_good, 7.0),
            ("on pale rework", palette.on_pale, palette.pale_rework, 7.0),
            ("on pale scrap", palette.on_pale, palette.pale_scrap, 7.0),
            ("on pale re-measure", palette.on_pale, palette.pale_re_measure, 7.0),
            ("on pale out of limits", palette.on_pale, palette.pale_out_of_limits, 7.0),
            ("on none", palette.on_none, palette.none, 7.0),
            ("zone edge", palette.zone_edge, palette.zone, 7.0),
            ("text on hole zone", palette.text, palette.hole, 7.0),
            ("text on shaft zone", palette.text, palette.shaft, 7.0),
            ("hatch of rework", palette.hatch_rework, palette.surface, 3.0),
            ("hatch of scrap", palette.hatch_scrap, palette.surface, 3.0),
            ("hatch of what is open", palette.hatch_out, palette.surface, 3.0),
            ("on toast", palette.on_toast, palette.toast, 7.0),
        ] {
            assert!(least <= contrast(text, ground), "{name}: {:.2}", contrast(text, ground));
        }
    }
}

/// The least contrast of two fills. Rework and re-measure are next to each other in lightness, .50 and .37; glyph, word and outline differ
/// besides.
const APART: f64 = 1.25;

#[test]
fn verdicts_are_told_apart_in_greyscale() {
    for palette in [&TOKENS.light, &TOKENS.dark, &TOKENS.contrast, &TOKENS.inverted] {
        // In the dark good and scrap are close: glyph, word and outline tell them apart.
        let mut fills = vec![palette.good, palette.rework, palette.re_measure];
        if palette != &TOKENS.dark {
            fills.extend([palette.scrap, palette.out_of_limits]);
        }
        for (number, one) in fills.iter().enumerate() {
            for other in fills.iter().take(number) {
                assert!(APART <= contrast(*one, *other), "{one:?} {other:?}: {:.2}", contrast(*one, *other));
            }
        }
    }
}

#[test]
fn a_simulated_verdict_is_told_apart_from_a_measured_one_in_greyscale() {
    for palette in [&TOKENS.light, &TOKENS.dark, &TOKENS.contrast, &TOKENS.inverted] {
        for (measured, simulated) in [
            (palette.good, palette.pale_good),
            (palette.rework, palette.pale_rework),
            (palette.scrap, palette.pale_scrap),
            (palette.re_measure, palette.pale_re_measure),
            (palette.out_of_limits, palette.pale_out_of_limits),
        ] {
            let is = contrast(measured, simulated);
            assert!(1.15 <= is, "{measured:?} {simulated:?}: {is:.2}");
        }
    }
}

#[test]
fn every_icon_has_a_glyph_in_every_weight() {
    let ctx = Context::default();
    super::install(&ctx);
    let mut first_frame = ctx.run_ui(RawInput::default(), |_ui| {});
    first_frame.textures_delta.clear();
    for icon in Icon::ALL {
        for weight in Weight::ALL {
            let text = icon.text(weight, 20.0);
            let family = FontId::new(20.0, FontFamily::Name(weight.font().into()));
            let has_glyph = ctx.fonts_mut(|fonts| fonts.has_glyphs(&family, text.text()));
            assert!(has_glyph, "{icon:?} {weight:?}");
        }
    }
}
