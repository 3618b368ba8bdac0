//! The limit band's geometry: zone, rework side, scrap side and the measured value on one axis of deviations.
//!
//! Plain values in micrometres from the nominal size, for drawing only: nothing is judged by them. The report's
//! picture and the window's plot are both drawn from a [`Band`], so they show the same.

use crate::length::Length;
use crate::tolerance::{Feature, Limits};

/// What a part is on one side of the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Material can still be taken off.
    Rework,
    /// Material cannot be put back.
    Scrap,
}

/// Where the measured value is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Marker {
    /// On the axis, at this deviation in micrometres.
    InSight(f64),
    /// Smaller than the axis shows: an arrow at the left edge, with the deviation in micrometres.
    BeyondLeft(f64),
    /// Larger than the axis shows: an arrow at the right edge, with the deviation in micrometres.
    BeyondRight(f64),
}

/// The band's values, all in micrometres from the nominal size.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Left end of the axis.
    pub axis_min_um: f64,
    /// Right end of the axis, always right of the left one.
    pub axis_max_um: f64,
    /// Lower limit deviation, always inside the axis.
    pub lower_um: f64,
    /// Upper limit deviation, always inside the axis; equal to the lower one for a zone of no width.
    pub upper_um: f64,
    /// What is to the left of the zone: rework for a hole, scrap for a shaft.
    pub left: Side,
    /// What is to the right of the zone: scrap for a hole, rework for a shaft.
    pub right: Side,
    /// The measured value, where there is one.
    pub marker: Option<Marker>,
    /// Round deviations along the axis, ascending; zero is among them where the axis shows it.
    pub ticks: Vec<f64>,
}

/// The least margin on either side of the zone, in zone widths: room for the side's name.
const MARGIN: f64 = 0.5;
/// How far outside the zone, in zone widths, the axis still stretches to the measured value and the nominal size.
/// Farther out, the zone would become a line.
const REACH: f64 = 1.0;
/// The gap between a value that the axis stretches to and the axis's end, in zone widths.
const AIR: f64 = 0.15;
/// The width in micrometres used for a zone that has none.
const WIDTH_OF_NONE: f64 = 10.0;
/// The fewest steps between ticks; there are at most two to three times as many.
const STEPS: f64 = 4.0;

impl Band {
    /// The band of the given limits, with the measured value if there is one.
    ///
    /// The axis shows the whole zone with half its width on either side. It stretches to the measured value and to
    /// the nominal size where they are less than a zone width away; a value farther out becomes an arrow.
    ///
    /// ```
    /// use fitcheck::report::band::{Band, Marker, Side};
    /// use fitcheck::tolerance::{Deviations, Feature, Limits, Source};
    ///
    /// let deviations = Deviations::new("0.021".parse()?, "0".parse()?)?;
    /// let limits = Limits::new(Feature::Hole, "25".parse()?, deviations, Source::File("x".into())).unwrap();
    /// let band = Band::new(&limits, Some("25.012".parse()?));
    /// assert_eq!((band.lower_um, band.upper_um), (0.0, 21.0));
    /// assert_eq!((band.axis_min_um, band.axis_max_um), (-10.5, 31.5));
    /// assert_eq!((band.left, band.right), (Side::Rework, Side::Scrap));
    /// assert_eq!(band.marker, Some(Marker::InSight(12.0)));
    /// assert_eq!(band.ticks, [-10.0, 0.0, 10.0, 20.0, 30.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(limits: &Limits, measured: Option<Length>) -> Self {
        let lower_um = micrometres(limits.deviations.lower());
        let upper_um = micrometres(limits.deviations.upper());
        let width = if lower_um < upper_um { upper_um - lower_um } else { WIDTH_OF_NONE };
        let mut axis_min_um = lower_um - MARGIN * width;
        let mut axis_max_um = upper_um + MARGIN * width;
        let measured = measured.map(|measured| micrometres(measured.saturating_sub(limits.nominal)));
        for value in [Some(0.0), measured].into_iter().flatten() {
            if lower_um - REACH * width <= value && value <= upper_um + REACH * width {
                axis_min_um = axis_min_um.min(value - AIR * width);
                axis_max_um = axis_max_um.max(value + AIR * width);
            }
        }
        let marker = measured.map(|value| {
            if value < axis_min_um {
                Marker::BeyondLeft(value)
            } else if axis_max_um < value {
                Marker::BeyondRight(value)
            } else {
                Marker::InSight(value)
            }
        });
        let (left, right) = match limits.feature {
            Feature::Hole => (Side::Rework, Side::Scrap),
            Feature::Shaft => (Side::Scrap, Side::Rework),
        };
        let ticks = ticks(axis_min_um, axis_max_um);
        Self { axis_min_um, axis_max_um, lower_um, upper_um, left, right, marker, ticks }
    }

    /// Where a deviation is along the axis: 0 at the left end, 1 at the right end, kept between them.
    pub fn fraction(&self, um: f64) -> f64 {
        ((um - self.axis_min_um) / (self.axis_max_um - self.axis_min_um)).clamp(0.0, 1.0)
    }

    /// Whether the axis shows a deviation.
    pub fn shows(&self, um: f64) -> bool {
        self.axis_min_um <= um && um <= self.axis_max_um
    }
}

/// A length in micrometres, the nearest float to its exact value.
pub fn micrometres(length: Length) -> f64 {
    (length.to_mm_f64() * 1e6).round() / 1e3
}

/// Multiples of 1, 2 or 5 times a power of ten: at least [`STEPS`] steps fit.
fn ticks(min: f64, max: f64) -> Vec<f64> {
    let rough = (max - min) / STEPS;
    let power = 10_f64.powf(rough.log10().floor());
    let step = [5.0, 2.0].into_iter().find(|step| step * power <= rough).unwrap_or(1.0) * power;
    let first = (min / step).ceil();
    // `+ 0.0` turns a negative zero into zero.
    (0_u8..u8::MAX).map(|n| (first + f64::from(n)) * step + 0.0).take_while(|tick| *tick <= max).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(-10.5, 31.5), [-10.0, 0.0, 10.0, 20.0, 30.0]);
        assert_eq!(ticks(-23.0, 33.0), [-20.0, -10.0, 0.0, 10.0, 20.0, 30.0]);
        assert_eq!(ticks(-0.001, 0.003), [-0.001, 0.0, 0.001, 0.002, 0.003]);
    }
}
