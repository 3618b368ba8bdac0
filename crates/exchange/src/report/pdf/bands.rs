//! The limit band of a row: where zone, sides, guard bands and value are, as shares of its width.

use crate::journal::Record;
use crate::report::band::{Band, Guarded, Marker, Side};

/// From and to, as shares of the band's width.
pub(super) type Span = [f32; 2];

/// Where the value is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mark {
    /// A share of the width.
    At(f32),
    /// Farther left or right than the band shows: an arrow.
    Left,
    Right,
}

/// A limit band.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BandShape {
    /// Between the limits.
    pub zone: Span,
    /// What is rejected, on either side.
    pub sides: [(Side, Span); 2],
    pub guards: Vec<(Span, Guarded)>,
    pub mark: Mark,
}

impl BandShape {
    /// The band of a record, as HTML and the window draw it.
    pub fn of(record: &Record) -> Self {
        let band = Band::by(&record.verdict.rule, &record.limits, Some(record.measurement.diameter));
        let at = |um: f64| narrow(band.fraction(um));
        let zone = [at(band.lower_um), at(band.upper_um)];
        // What is rejected begins where the rule says so.
        let [below, above] = match &band.guard {
            Some(guard) => guard.rejected.map_or([0.0, 1.0], |ends| ends.map(at)),
            None => zone,
        };
        let guards = band.guard.as_ref().map_or_else(Vec::new, |guard| {
            guard.bands.iter().map(|band| ([at(band.from_um), at(band.to_um)], band.guarded)).collect()
        });
        Self {
            zone,
            sides: [(band.left, [0.0, below.min(zone[0])]), (band.right, [above.max(zone[1]), 1.0])],
            guards,
            mark: match band.marker {
                Some(Marker::InSight(um)) => Mark::At(at(um)),
                Some(Marker::BeyondLeft(_)) | None => Mark::Left,
                Some(Marker::BeyondRight(_)) => Mark::Right,
            },
        }
    }
}

/// A share of a width, as the page has it.
#[expect(clippy::as_conversions, clippy::cast_possible_truncation, reason = "a place on the page")]
pub(super) const fn narrow(value: f64) -> f32 {
    value as f32
}
