//! The classical picture of a fit: zero line, both zones to scale, fundamental deviations, measured parts.
//!
//! Plain values in micrometres from the nominal size, for drawing only: nothing is judged by them.

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::fit::Fit;
use fitcheck_core::tolerance::{Deviations, Limits};

/// Where a measured part is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mark {
    /// On the axis, at this deviation in micrometres.
    InSight(f64),
    /// Larger than the axis shows: an arrow at the upper edge.
    Above,
    /// Smaller than the axis shows: an arrow at the lower edge.
    Below,
}

/// A tolerance zone, all in micrometres from the zero line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureZone {
    /// Upper limit deviation.
    pub upper_um: f64,
    /// Lower limit deviation.
    pub lower_um: f64,
    /// The fundamental deviation: the limit deviation nearest to the zero line. `None` where both are equally near.
    pub fundamental_um: Option<f64>,
    /// Whether the fundamental deviation is the upper one.
    pub fundamental_is_upper: bool,
    /// The measured part.
    pub mark: Option<Mark>,
}

/// The picture's geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Picture {
    /// Lower end of the axis.
    pub axis_min_um: f64,
    /// Upper end of the axis, always above the lower one.
    pub axis_max_um: f64,
    /// The hole's zone.
    pub hole: PictureZone,
    /// The shaft's zone.
    pub shaft: PictureZone,
}

/// Kept free above and below what is drawn, as a share of its height.
const MARGIN: f64 = 0.12;
/// How far beyond zones and zero line, as a share of their height, a measured part is still shown.
const REACH: f64 = 0.6;
/// Kept free for the arrow of a part beyond the axis, as a share of the height.
const ROOM: f64 = 0.16;
/// The height of a picture that would have none, micrometres.
const HEIGHT_OF_NONE: f64 = 10.0;

fn zone(deviations: Deviations, mark: Option<Mark>) -> PictureZone {
    let upper = deviations.upper();
    let lower = deviations.lower();
    let is_upper = upper.abs() < lower.abs();
    let fundamental = if is_upper { upper } else { lower };
    PictureZone {
        upper_um: upper.to_um_f64(),
        lower_um: lower.to_um_f64(),
        fundamental_um: (upper.abs() != lower.abs()).then(|| fundamental.to_um_f64()),
        fundamental_is_upper: is_upper,
        mark,
    }
}

impl Picture {
    /// The picture of a fit with its measured parts. The axis shows the zero line and both zones; it stretches to a
    /// part that is not far away, and one farther out becomes an arrow.
    pub(super) fn new(fit: &Fit, hole: Option<Length>, shaft: Option<Length>) -> Self {
        let deviations = [fit.hole().deviations, fit.shaft().deviations];
        let highest = deviations.iter().map(|zone| zone.upper().to_um_f64()).fold(0.0, f64::max);
        let lowest = deviations.iter().map(|zone| zone.lower().to_um_f64()).fold(0.0, f64::min);
        let height = if lowest < highest { highest - lowest } else { HEIGHT_OF_NONE };
        let of = |limits: &Limits, measured: Length| measured.saturating_sub(limits.nominal).to_um_f64();
        let marks = [hole.map(|hole| of(fit.hole(), hole)), shaft.map(|shaft| of(fit.shaft(), shaft))];
        let mut top = highest;
        let mut bottom = lowest;
        for mark in marks.into_iter().flatten() {
            let least = lowest - REACH * height;
            let most = highest + REACH * height;
            if mark < least {
                bottom = bottom.min(lowest - ROOM * height);
            } else if most < mark {
                top = top.max(highest + ROOM * height);
            } else {
                top = top.max(mark);
                bottom = bottom.min(mark);
            }
        }
        let margin = MARGIN * (top - bottom).max(height);
        let axis_min_um = bottom - margin;
        let axis_max_um = top + margin;
        let mark = |um: f64| {
            if um < axis_min_um {
                Mark::Below
            } else if axis_max_um < um {
                Mark::Above
            } else {
                Mark::InSight(um)
            }
        };
        let [of_hole, of_shaft] = marks.map(|um| um.map(mark));
        let hole = zone(fit.hole().deviations, of_hole);
        let shaft = zone(fit.shaft().deviations, of_shaft);
        Self { axis_min_um, axis_max_um, hole, shaft }
    }

    /// Where a deviation lies along the axis: 0 at the lower end, 1 at the upper end, kept between them.
    pub fn fraction(&self, um: f64) -> f64 {
        ((um - self.axis_min_um) / (self.axis_max_um - self.axis_min_um)).clamp(0.0, 1.0)
    }
}
