//! How much a contact's scatter affects diameter and centre.

use super::frame::{count_f64, dot, mean, minus, unit};

/// Standard uncertainties of the least-squares circle, in units of the uncertainty of one contact along the radius.
///
/// From the directions a of the contacts alone: rows (cos a, sin a, 1), covariance (JᵀJ)⁻¹, u(D) = 2 √C₃₃. The form of
/// the workpiece is not included.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Uncertainty {
    /// u(D) / s.
    pub diameter: f64,
    /// u(centre) / s in the direction where it is largest: towards the middle of a short arc.
    pub centre_along: f64,
    /// u(centre) / s across that direction, where it is smallest.
    pub centre_across: f64,
}

/// u(D) / s of three contacts 120 degrees apart: 2 / √3. Short arcs are compared with it.
pub(super) const THREE_BY_120: f64 = 1.154_700_538_379_251_5;

impl Uncertainty {
    /// For contacts seen from the fitted centre.
    pub(super) fn of(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let count = count_f64(points.len());
        let directions: Vec<[f64; 2]> = points.iter().map(|&point| unit(minus(point, centre))).collect();
        let [mean_x, mean_y] = mean(&directions);
        let off: Vec<[f64; 2]> = directions.iter().map(|&direction| minus(direction, [mean_x, mean_y])).collect();
        let mut xx = 0.0;
        let mut xy = 0.0;
        let mut yy = 0.0;
        for &[x, y] in &off {
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        // The two directions in which the matrix stretches only. On a short arc one of them is so small that the determinant
        // would be rounding; summed along these directions nothing cancels.
        let angle = libm::atan2(2.0 * xy, xx - yy) / 2.0;
        let wide = [libm::cos(angle), libm::sin(angle)];
        let narrow = [-libm::sin(angle), libm::cos(angle)];
        let stretch = |along| off.iter().map(|&off| dot(off, along).powi(2)).sum::<f64>();
        let carried = |along| {
            let carried = dot([mean_x, mean_y], along);
            if carried.abs() <= 0.0 { 0.0 } else { carried * carried / stretch(along) }
        };
        Self {
            diameter: 2.0 * (1.0 / count + carried(wide) + carried(narrow)).sqrt(),
            centre_along: (1.0 / stretch(narrow)).sqrt(),
            centre_across: (1.0 / stretch(wide)).sqrt(),
        }
    }

    /// For contacts in these directions, radians.
    pub fn of_angles(angles: &[f64]) -> Self {
        let points: Vec<[f64; 2]> = angles.iter().map(|&angle| [libm::cos(angle), libm::sin(angle)]).collect();
        Self::of(&points, [0.0, 0.0])
    }

    /// How many times worse the diameter is than with three contacts 120 degrees apart.
    pub fn against_three_by_120(&self) -> f64 {
        self.diameter / THREE_BY_120
    }
}
