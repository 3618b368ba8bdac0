//! Where a value lies in its zone, as a small band in a cell: a bar within the limits, a diamond outside them.

use eframe::egui::{Painter, Rect, Shape, Stroke, pos2, vec2};

use crate::gui::shapes::screen;
use crate::gui::theme::{Palette, space};
use crate::journal::Record;
use crate::length::Length;

/// The whole band, and the part of it that the zone has.
const SIZE: [f32; 2] = [24.0, 3.5];
const ZONE: f32 = 0.46;

/// Where a value lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::gui) struct Zoned {
    /// From the lower limit, 0, to the upper one, 1.
    share: f32,
    /// The limits themselves are within.
    is_outside: bool,
}

impl Zoned {
    pub fn of(record: &Record) -> Self {
        let size = &record.verdict.size;
        let [above, below] = [size.above_minimum, size.below_maximum];
        let is_outside = above < Length::ZERO || below < Length::ZERO;
        let width = above.to_um_f64() + below.to_um_f64();
        let share = if 0.0 < width { screen(above.to_um_f64() / width) } else { 0.5 };
        // A zone of no width has only one value.
        let beyond = if above < Length::ZERO { -1.0 } else { 2.0 };
        Self { share: if is_outside && width <= 0.0 { beyond } else { share }, is_outside }
    }

    pub(super) fn paint(self, painter: &Painter, cell: Rect, palette: &Palette) {
        let size = vec2(space(SIZE[0]), space(SIZE[1]));
        let band = Rect::from_min_size(cell.left_center() - vec2(0.0, size.y / 2.0), size);
        let zone = Rect::from_center_size(band.center(), vec2(band.width() * ZONE, band.height() * 0.6));
        painter.hline(band.x_range(), band.center().y, Stroke::new(1.5, palette.edge.0));
        painter.rect_filled(zone, 0.0, palette.zone.0);
        for x in [zone.left(), zone.right()] {
            painter.vline(x, band.y_range(), Stroke::new(1.5, palette.zone_edge.0));
        }
        let x = zone.left() + zone.width() * self.share;
        let half = band.height() * 0.36;
        if !self.is_outside {
            painter.vline(x, band.y_range(), Stroke::new(3.0, palette.text.0));
            return;
        }
        // Beside the zone, however little the value is outside, and never beyond the band.
        let x = if self.share < 0.5 {
            x.clamp(band.left() + half, zone.left() - half - 1.0)
        } else {
            x.clamp(zone.right() + half + 1.0, band.right() - half)
        };
        let at = pos2(x, band.center().y);
        let corners = [vec2(0.0, -half), vec2(half, 0.0), vec2(0.0, half), vec2(-half, 0.0)];
        painter.add(Shape::convex_polygon(corners.map(|by| at + by).to_vec(), palette.text.0, Stroke::NONE));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probing::{Measurement, Origin};
    use crate::tolerance::Sources;

    fn zoned(callout: &str, mm: &str) -> Zoned {
        let callout = callout.parse().unwrap();
        let limits = Sources::default().limits(&callout, None).unwrap();
        let measurement = Measurement::of_diameter(mm.parse().unwrap(), Origin::Typed);
        let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
        Zoned::of(&Record::judged(time, String::new(), Some(callout), limits, measurement, None))
    }

    #[test]
    fn a_value_on_a_limit_is_within_and_a_nanometre_more_is_outside() {
        // 25 H7 is 25.000 to 25.021, 25 h6 is 24.987 to 25.000.
        for (callout, mm, share, is_outside) in [
            ("25 H7", "25.0105", 0.5, false),
            ("25 H7", "25", 0.0, false),
            ("25 H7", "25.021", 1.0, false),
            ("25 H7", "25.021001", 1.0, true),
            ("25 H7", "24.999999", 0.0, true),
            ("25 H7", "24.979", -1.0, true),
            ("25 h6", "25", 1.0, false),
            ("25 h6", "25.013", 2.0, true),
        ] {
            let zoned = zoned(callout, mm);
            assert!((zoned.share - share).abs() < 0.001, "{callout} {mm}: {zoned:?}");
            assert_eq!(zoned.is_outside, is_outside, "{callout} {mm}");
        }
    }
}
