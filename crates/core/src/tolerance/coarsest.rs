//! The widest zone that a size has: its IT 18.

use super::iso286::{Grade, standard_tolerance, step_ends};
use crate::length::Length;

/// The widest zone of a size that is not doubted: its IT 18. Up to 1 mm and beyond 3150 mm there is no such grade; there it is that of the
/// nearest size that has one, 1.4 mm and 33 mm.
///
/// ```
/// use fitcheck_core::tolerance::proportion::widest;
///
/// let of = |size: &str| widest(size.parse().unwrap()).to_string();
/// assert_eq!([of("25"), of("0.5"), of("5000")], ["3.3", "1.4", "33"]);
/// ```
pub fn widest(nominal: Length) -> Length {
    let of = |size| standard_tolerance(Grade::COARSEST, size);
    let has_it = |size: &Length| of(*size).is_some();
    let nearest = || {
        let mut ends = step_ends().filter(has_it);
        if Length::from_micrometres(1_000) < nominal { ends.last() } else { ends.next() }
    };
    of(nominal).or_else(|| of(nearest()?)).unwrap_or(Length::ZERO)
}
