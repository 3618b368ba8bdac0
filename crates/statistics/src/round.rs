//! Round numbers: 1, 2 and 5 times a power of ten, as axes, scales and drawings name them.

/// The least round number that is not below a value, in the unit of the value. What is not above zero, or has no end, is
/// answered as it is. A billionth more than a round number counts as that number.
pub fn round_up(value: f64) -> f64 {
    exponent_below(value).map_or(value, |exponent| {
        let rounds = [1.0, 2.0, 5.0].map(|digit| round(digit, exponent));
        rounds.into_iter().find(|round| value <= round * (1.0 + 1e-9)).unwrap_or_else(|| round(1.0, exponent + 1.0))
    })
}

/// The greatest round number that is not above a value, as [`round_up`] otherwise.
pub fn round_down(value: f64) -> f64 {
    exponent_below(value).map_or(value, |exponent| {
        let rounds = [10.0, 5.0, 2.0].map(|digit| round(digit, exponent));
        rounds.into_iter().find(|round| round * (1.0 - 1e-9) <= value).unwrap_or_else(|| round(1.0, exponent))
    })
}

/// The exponent of the power of ten at or below a value.
fn exponent_below(value: f64) -> Option<f64> {
    (0.0 < value && value.is_finite()).then(|| libm::log10(value).floor())
}

/// A digit times a power of ten, as near as a number can be: whole powers are exact, and those of one tenth are not.
fn round(digit: f64, exponent: f64) -> f64 {
    if exponent < 0.0 { digit / libm::exp10(-exponent) } else { digit * libm::exp10(exponent) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::float_cmp, reason = "round numbers are exact to the last bit")]
    fn round_numbers_stay_and_others_go_to_the_next() {
        for exponent in -12..=12 {
            let at = |digit: &str| format!("{digit}e{exponent}").parse::<f64>().unwrap();
            for digit in ["1", "2", "5"] {
                assert_eq!(round_up(at(digit)), at(digit), "{digit}e{exponent}");
                assert_eq!(round_down(at(digit)), at(digit), "{digit}e{exponent}");
            }
            for (given, below, above) in
                [("1.001", "1", "2"), ("3", "2", "5"), ("4.999", "2", "5"), ("9.999", "5", "10")]
            {
                assert_eq!((round_down(at(given)), round_up(at(given))), (at(below), at(above)), "{given}e{exponent}");
            }
        }
        assert_eq!((round_down(0.0), round_up(-1.0), round_up(f64::INFINITY)), (0.0, -1.0, f64::INFINITY));
    }
}
