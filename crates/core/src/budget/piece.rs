//! The table `[calibrated]` of a budget: its keys and what follows from them.

use serde::Deserialize;
use toml::Spanned;

use super::Calibrated;
use super::error::BudgetError;
use super::numbers::{ALPHA, COLDEST, FAR, Number, Numbers, Refusal, WARMEST, refused};
use crate::length::Length;
use crate::tolerance::Feature;

/// A calibrated piece as it is written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Piece {
    x_cal_mm: Spanned<f64>,
    standard_um: Number,
    expanded_um: Number,
    k: Number,
    u_b_um: Number,
    u_w_um: Number,
    temperature_c: Number,
    u_alpha_per_k: Number,
    u_alpha_parts_per_k: Number,
    #[serde(default)]
    bias_corrected: bool,
    #[serde(default)]
    feature: Side,
    #[serde(default)]
    readings_mm: Vec<Spanned<f64>>,
}

#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Side {
    #[default]
    Hole,
    Shaft,
}

/// What the table says.
pub(super) fn calibrated(piece: &Spanned<Piece>, text: &str) -> Result<Calibrated, Refusal> {
    let given = piece.get_ref();
    let all = [
        ("standard_um", &given.standard_um),
        ("expanded_um", &given.expanded_um),
        ("k", &given.k),
        ("u_b_um", &given.u_b_um),
        ("u_w_um", &given.u_w_um),
        ("temperature_c", &given.temperature_c),
        ("u_alpha_per_k", &given.u_alpha_per_k),
        ("u_alpha_parts_per_k", &given.u_alpha_parts_per_k),
    ];
    let numbers = Numbers { text, offset: given.x_cal_mm.span().start, table: "[calibrated]", all: &all };
    let size = length("x_cal_mm", &given.x_cal_mm, text)?;
    let u_cal = match (numbers.within("standard_um", 0.0, FAR)?, numbers.within("expanded_um", 0.0, FAR)?) {
        (Some(_), _) if numbers.has("expanded_um") || numbers.has("k") => {
            let others = ["standard_um", "u_b_um", "u_w_um", "temperature_c", "u_alpha_per_k", "u_alpha_parts_per_k"];
            return Err(numbers.only(&others).err().unwrap_or_else(|| numbers.missing("standard_um")));
        }
        (Some(standard), _) => standard,
        (None, Some(expanded)) => expanded / numbers.needed("k", 1.0, 10.0)?,
        (None, None) => return Err(numbers.missing("standard_um, or expanded_um with k")),
    };
    let off = numbers.within("temperature_c", COLDEST, WARMEST)?.map(|temperature| (temperature - 20.0).abs());
    // Of expansion: D |T - 20| u(alpha), micrometres.
    let grown = |key| -> Result<Option<f64>, Refusal> {
        let Some(alpha) = numbers.within(key, 0.0, ALPHA)? else { return Ok(None) };
        let off = off.ok_or_else(|| numbers.missing("temperature_c"))?;
        Ok(Some(size.to_mm_f64().abs() * 1_000.0 * off * alpha))
    };
    let together = |given: Option<f64>, grown: Option<f64>, keys| match (given, grown) {
        (None, None) => Err(numbers.missing(keys)),
        (given, grown) => Ok(libm::hypot(given.unwrap_or(0.0), grown.unwrap_or(0.0))),
    };
    let of_bias = (numbers.within("u_b_um", 0.0, FAR)?, grown("u_alpha_per_k")?);
    let of_parts = (numbers.within("u_w_um", 0.0, FAR)?, grown("u_alpha_parts_per_k")?);
    Ok(Calibrated {
        size,
        u_cal,
        u_b: together(of_bias.0, of_bias.1, "u_b_um, or u_alpha_per_k with temperature_c")?,
        u_w: together(of_parts.0, of_parts.1, "u_w_um, or u_alpha_parts_per_k with temperature_c")?,
        feature: match given.feature {
            Side::Hole => Feature::Hole,
            Side::Shaft => Feature::Shaft,
        },
        is_corrected: given.bias_corrected,
        readings: given
            .readings_mm
            .iter()
            .map(|reading| length("readings_mm", reading, text))
            .collect::<Result<_, _>>()?,
    })
}

/// A length that a file gives as a number: exactly, or refused.
fn length(key: &'static str, given: &Spanned<f64>, text: &str) -> Result<Length, Refusal> {
    given
        .get_ref()
        .to_string()
        .parse()
        .map_err(|error| refused(text, given.span().start, BudgetError::Length { key, error }))
}
