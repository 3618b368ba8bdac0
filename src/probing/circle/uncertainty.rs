//! How much of a contact's scatter goes into diameter and centre.

use super::frame::{count_f64, minus, norm};

/// Standard uncertainties of the least-squares circle in units of that of one contact along the radius.
///
/// From the directions a of the contacts alone: rows (cos a, sin a, 1), covariance (JᵀJ)⁻¹, u(D) = 2 √C₃₃. Form of the
/// workpiece is not in it.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Uncertainty {
    /// u(D) / s.
    pub diameter: f64,
    /// u(centre) / s in the direction where it is largest: towards the middle of a short arc.
    pub centre_along: f64,
    /// u(centre) / s across that direction, where it is smallest.
    pub centre_across: f64,
}

/// u(D) / s of three contacts 120 degrees apart: 2 / √3, what short arcs are compared with.
pub(super) const THREE_BY_120: f64 = 1.154_700_538_379_251_5;

impl Uncertainty {
    /// For contacts seen from the fitted centre.
    pub(super) fn of(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let count = count_f64(points.len());
        let directions: Vec<[f64; 2]> = points
            .iter()
            .map(|&point| {
                let [x, y] = minus(point, centre);
                let distance = norm([x, y]);
                if distance <= 0.0 { [0.0; 2] } else { [x / distance, y / distance] }
            })
            .collect();
        let (sum_x, sum_y) = directions.iter().fold((0.0, 0.0), |(sum_x, sum_y), [x, y]| (sum_x + x, sum_y + y));
        let [mean_x, mean_y] = [sum_x / count, sum_y / count];
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for &direction in &directions {
            let [off_x, off_y] = minus(direction, [mean_x, mean_y]);
            xx += off_x * off_x;
            xy += off_x * off_y;
            yy += off_y * off_y;
        }
        let determinant = xx * yy - xy * xy;
        let mean_carried = (mean_x * mean_x * yy - 2.0 * mean_x * mean_y * xy + mean_y * mean_y * xx) / determinant;
        let half_trace = f64::midpoint(xx, yy);
        let largest = half_trace + ((xx - yy) / 2.0).hypot(xy);
        Self {
            diameter: 2.0 * (1.0 / count + mean_carried).sqrt(),
            centre_along: (largest / determinant).sqrt(),
            centre_across: (1.0 / largest).sqrt(),
        }
    }

    /// How many times worse the diameter is than with three contacts 120 degrees apart.
    pub fn against_three_by_120(&self) -> f64 {
        self.diameter / THREE_BY_120
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks one line of the table of factors.
    #[track_caller]
    fn check(count: u32, step_deg: f64, [diameter, against, along, across]: [&str; 4]) {
        let points: Vec<_> = (0..count)
            .map(|k| (17.0 + f64::from(k) * step_deg).to_radians())
            .map(|angle| [3.0 + angle.cos(), 4.0 + angle.sin()])
            .collect();
        let found = Uncertainty::of(&points, [3.0, 4.0]);
        for (value, printed) in [
            (found.diameter, diameter),
            (found.against_three_by_120(), against),
            (found.centre_along, along),
            (found.centre_across, across),
        ] {
            let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert_eq!(format!("{value:.decimals$}"), printed, "{count} x {step_deg}: {found:?}");
        }
    }

    #[test]
    fn agrees_with_the_table_of_touches_and_steps() {
        check(3, 120.0, ["1.155", "1.00", "0.816", "0.816"]);
        check(3, 90.0, ["1.414", "1.22", "1.225", "0.707"]);
        check(3, 75.0, ["2.032", "1.76", "1.652", "0.732"]);
        check(3, 60.0, ["3.464", "3.00", "2.449", "0.816"]);
        // The table prints 4.181; the exact value, 4.18154, rounds to 4.182.
        check(3, 45.0, ["6.828", "5.91", "4.182", "1.000"]);
        check(3, 30.0, ["16.69", "14.5", "9.142", "1.414"]);
        check(3, 20.0, ["39.0", "33.8", "20.31", "2.067"]);
        // The table prints 60.9; the exact value, 60.84996, rounds to 60.8.
        check(3, 15.0, ["70.3", "60.8", "35.94", "2.732"]);
        check(3, 10.0, ["159.6", "138", "80.62", "4.072"]);
        check(4, 90.0, ["1.000", "0.87", "0.707", "0.707"]);
        check(4, 60.0, ["1.414", "1.22", "1.155", "0.632"]);
        check(4, 45.0, ["2.613", "2.26", "1.848", "0.707"]);
        check(4, 30.0, ["6.541", "5.66", "3.864", "0.939"]);
        check(4, 20.0, ["15.61", "13.5", "8.419", "1.336"]);
        check(5, 72.0, ["0.894", "0.77", "0.632", "0.632"]);
        check(6, 60.0, ["0.816", "0.71", "0.577", "0.577"]);
        check(8, 45.0, ["0.707", "0.61", "0.500", "0.500"]);
        check(8, 22.5, ["1.672", "1.45", "1.182", "0.500"]);
        check(12, 30.0, ["0.577", "0.50", "0.408", "0.408"]);
    }
}
