//! Lengths: read exactly or refused, printed exactly, and never wrapped round.

use std::str::FromStr as _;

use fitcheck::length::{Length, LengthError, Unit};

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

#[track_caller]
fn check(text: &str, expected: &str) {
    let said = match Length::from_str(text) {
        Ok(length) => format!("{} nm", length.nanometres()),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {text:?}");
}

#[test]
fn reads_numbers_as_people_type_them() {
    check("25", "25000000 nm");
    check(" 25.021 ", "25021000 nm");
    check("25,021", "25021000 nm");
    check("+25.0", "25000000 nm");
    check("-0.000001", "-1 nm");
    check("\u{2212}12 µm", "-12000 nm");
    check("12.5um", "12500 nm");
    check("12.5 μm", "12500 nm");
    check("25 mm", "25000000 nm");
    check(".5", "500000 nm");
    check("25.", "25000000 nm");
    check("25.00000000000", "25000000 nm");
    check("1000000000", "1000000000000000 nm");
}

#[test]
fn refuses_what_is_no_length() {
    check("", "a length is missing");
    check("   ", "a length is missing");
    check("NaN", "NaN is not a number");
    check("inf", "inf is not a number");
    check("7.5.2", "7.5.2 is not a number");
    check("1e3", "1e3 is not a number");
    check("+-1", "+-1 is not a number");
    check(".", ". is not a number");
    check("mm", "mm is not a number");
    check("1.234,5", "1.234,5 is ambiguous: write one decimal sign and no thousands separator");
    check("25.0000001", "25.0000001 is finer than a nanometre");
    check("0.0005 µm", "0.0005 µm is finer than a nanometre");
    check("25.0000000000000000001", "25.0000000000000000001 is finer than a nanometre");
    check("1000000000.000001", "1000000000.000001 is too large: at most 1000000000 mm either way");
    check("99999999999999999999", "99999999999999999999 is too large: at most 1000000000 mm either way");
    check("-99999999999999999999.5", "-99999999999999999999.5 is too large: at most 1000000000 mm either way");
    let digits = "9".repeat(38);
    check(&digits, &format!("{digits} is too large: at most 1000000000 mm either way"));
    check("２５", "２５ is not a number");
}

#[test]
fn prints_exactly_and_rounds_half_away_from_zero() {
    assert_eq!(nm(25_000_000).exact(Unit::Millimetre, 3), "25.000");
    assert_eq!(nm(25_007_500).exact(Unit::Millimetre, 3), "25.0075");
    assert_eq!(nm(-7_500).exact(Unit::Micrometre, 0), "-7.5");
    assert_eq!(nm(0).exact(Unit::Micrometre, 0), "0");
    assert_eq!(nm(25_000_050).rounded(Unit::Millimetre, 4), "25.0001");
    assert_eq!(nm(-25_000_050).rounded(Unit::Millimetre, 4), "-25.0001");
    assert_eq!(nm(-49).rounded(Unit::Millimetre, 4), "0.0000");
    assert_eq!(nm(1_500_000).rounded(Unit::Millimetre, 0), "2");
    assert_eq!(nm(1).rounded(Unit::Millimetre, 14), "0.00000100000000");
    assert_eq!(format!("{:>8}", nm(25_000_000)), "      25");
    assert_eq!([21_000, -7_500, 0].map(|deviation| nm(deviation).signed_um()), ["+21", "-7.5", "0"]);
}

#[test]
fn inches_are_printed_to_seven_decimals_without_the_zeros_that_nobody_asked_for() {
    let inches = |nanometres, least| nm(nanometres).exact(Unit::Inch, least);
    assert_eq!([inches(25_400_000, 0), inches(12_700_000, 0), inches(-25_400_000, 3)], ["1", "0.5", "-1.000"]);
    assert_eq!([inches(25_401_000, 0), inches(1, 0), inches(25_400_000, 9)], ["1.0000394", "0", "1.000000000"]);
}

#[test]
fn an_inch_is_exactly_25_4_mm() {
    assert_eq!(Length::parse_in("1.0008", Unit::Inch).unwrap().to_string(), "25.42032");
    assert_eq!(Length::parse_in("0.000005", Unit::Inch), Ok(nm(127)));
    assert_eq!(Length::parse_in("0.00000500", Unit::Inch), Ok(nm(127)));
    assert_eq!(
        Length::parse_in("0.0000001", Unit::Inch).unwrap_err(),
        LengthError::TooFine { text: "0.0000001".to_owned() }
    );
}

#[test]
fn floats_meet_lengths_at_the_nearest_nanometre() {
    assert_eq!(Length::from_mm_f64(25.012_000_4).unwrap().nanometres(), 25_012_000);
    assert_eq!(Length::from_mm_f64(-0.000_000_6).unwrap().nanometres(), -1);
    assert_eq!(Length::from_mm_f64(1e9), Ok(Length::MAX));
    assert_eq!(Length::from_mm_f64(-1e9), Ok(Length::MAX.negated()));
    assert!(Length::from_mm_f64(f64::NAN).is_err());
    assert!(Length::from_mm_f64(f64::INFINITY).is_err());
    assert!(Length::from_mm_f64(1.000_000_1e9).is_err());
}

#[test]
fn arithmetic_is_checked() {
    assert_eq!(Length::MAX.checked_add(nm(1)), None);
    assert_eq!(Length::MAX.negated().checked_sub(nm(1)), None);
    assert_eq!(Length::MAX.saturating_sub(Length::MAX.negated()), Length::MAX);
    assert_eq!(nm(25_000_000).midpoint(nm(25_021_000)), nm(25_010_500));
    assert_eq!(nm(-3).midpoint(nm(0)), nm(-1));
}

proptest::proptest! {
    /// What is printed exactly is what rounding on paper gives, without the zeros that nobody asked for, and reads back.
    #[test]
    fn exact_figures_are_the_rounded_ones_without_their_last_zeros(
        nanometres in proptest::prop_oneof![-2_000_000_i64..2_000_000, -5_000_000_000_000..5_000_000_000_000_i64],
        thousands in 0..3_u32,
        least in 0..8_usize,
    ) {
        let length = nm(nanometres / 1000_i64.pow(thousands) * 1000_i64.pow(thousands));
        for (unit, places) in [(Unit::Millimetre, 6_usize), (Unit::Micrometre, 3)] {
            let mut expected = length.rounded(unit, places.max(least));
            while expected.contains('.') && expected.ends_with(['0', '.']) {
                let decimals = expected.split('.').nth(1).unwrap().len();
                if decimals <= least && 0 < decimals {
                    break;
                }
                expected.pop();
            }
            let exact = length.exact(unit, least);
            proptest::prop_assert_eq!(&exact, &expected);
            proptest::prop_assert_eq!(Length::parse_in(&exact, unit), Ok(length));
        }
    }

    /// Numbers of nothing but digits and one sign are read as everything else is: a blank in front takes the other way.
    #[test]
    fn plain_numbers_are_read_like_all_others(text in "[0-9]{0,11}[.,]?[0-9]{0,8}") {
        for unit in [Unit::Millimetre, Unit::Micrometre, Unit::Inch] {
            proptest::prop_assert_eq!(Length::parse_in(&text, unit), Length::parse_in(&format!(" {text}"), unit));
        }
    }
}
