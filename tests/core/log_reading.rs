//! Reading a measuring log that is cut off, contradicts itself or is not a log.

use fitcheck::control::log::{Figure, Further, LimitPair, Log, LogError, is_log, read};
use fitcheck::length::{Length, Unit};
use fitcheck::probing::cycle;
use fitcheck::probing::cycles::CYCLES;

const LOG: &str = "Measuring log for touch probe cycle 421 Hole measuring

Date: 30-06-2005
Time: 6:55:04
Measuring program: TNC:\\GEH35712\\CHECK1.H
Type of dimension (0 = MM / 1 = INCH): 0

Nominal values:
Center in reference axis: 50.0000
Center in minor axis: 65.0000
Diameter: 12.0000

Given limit values:
Maximum limit for center in reference axis: 50.1000
Minimum limit for center in reference axis: 49.9000
Maximum limit for center in minor axis: 65.1000
Minimum limit for center in minor axis: 64.9000
Maximum dimension for hole: 12.0450
Minimum dimension for hole: 12.0000

Actual values:
Center in reference axis: 50.0810
Center in minor axis: 64.9530
Diameter: 12.0259

Deviations:
Center in reference axis: 0.0810
Center in minor axis: -0.0470
Diameter: 0.0259

Further measuring results:
Measuring height: -5.0000

Measuring log end
";

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

/// One line per log: its figures and warnings, or its error.
fn said(text: &str) -> String {
    let one = |log: Result<Log, LogError>| match log {
        Ok(log) => {
            let figures = match log.figures.as_slice() {
                [_, _, diameter] => {
                    let limits = diameter
                        .limits
                        .map_or("no limits".to_owned(), |limits| format!("{} to {}", limits.minimum, limits.maximum));
                    format!("{} is {} in {limits}", diameter.nominal.unwrap(), diameter.actual)
                }
                [coordinate] => {
                    let limits = coordinate.limits.unwrap();
                    format!("{} in {} to {}", coordinate.actual, limits.minimum, limits.maximum)
                }
                others => panic!("{others:?}"),
            };
            let warnings = log.warnings.iter().map(|warning| format!("; {warning}"));
            figures + &warnings.collect::<String>()
        }
        Err(error) => {
            let column = error.place.column.map(|column| format!(" column {column}"));
            let line = error.place.line.unwrap_or_default();
            format!("! line {line}: {}{}", error.what, column.unwrap_or_default())
        }
    };
    read(text.as_bytes()).into_iter().map(one).collect::<Vec<_>>().join("\n")
}

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said(text), expected);
}

const GOOD: &str = "12 is 12.0259 in 12 to 12.045";

#[test]
fn the_published_log_is_read_whole() {
    let logs = read(LOG.as_bytes());
    let [Ok(log)] = logs.as_slice() else { panic!("{logs:?}") };
    assert_eq!((log.line, log.cycle, log.unit), (1, 421, Unit::Millimetre));
    assert_eq!(log.date_time().unwrap().to_string(), "2005-06-30T06:55:04");
    assert_eq!(log.program.as_deref(), Some("TNC:\\GEH35712\\CHECK1.H"));
    let about = |nominal: &str| LimitPair::about(mm(nominal), mm("0.1"));
    let size = LimitPair { maximum: mm("12.045"), minimum: mm("12") };
    let expected = [
        Figure::of(mm("50"), about("50"), mm("50.081")),
        Figure::of(mm("65"), about("65"), mm("64.953")),
        Figure::of(mm("12"), Some(size), mm("12.0259")),
    ];
    assert_eq!(log.figures, expected.map(Option::unwrap));
    assert_eq!(log.figures[2].deviation, Some(mm("0.0259")));
    assert_eq!(log.further, [Further { label: "Measuring height".to_owned(), value: "-5.0000".to_owned() }]);
    assert_eq!(log.warnings, []);
}

#[test]
fn line_ends_encodings_and_places_of_values_do_not_matter() {
    check(&LOG.replace('\n', "\r\n"), GOOD);
    check(&LOG.replace('\n', "\r"), GOOD);
    check(&LOG.replace('\n', "\0"), GOOD);
    check(&format!("\u{feff}{LOG}"), GOOD);
    check(&LOG.replace(": ", ":\n\n"), GOOD);
    check(&LOG.replace(".0", ",0").replace("50.1", "50,1").replace("65.1", "65,1"), GOOD);
    check(&LOG.replace("30-06-2005", "30.06.2005"), GOOD);
    check(&LOG.replace("30-06-2005", "30/6/2005"), GOOD);
}

#[test]
fn words_do_not_matter() {
    let words = LOG.lines().map(|line| match line.split_once(':') {
        _ if line.contains("421") => "测头 421 测量".to_owned(),
        Some((label, value)) if label.contains('(') => format!("単位 (0 = mm / 1 = inch):{value}"),
        Some((_, value)) => format!("名称:{value}"),
        None => line.to_owned(),
    });
    check(&words.collect::<Vec<_>>().join("\n"), GOOD);
}

#[test]
fn a_log_without_headings_is_read_by_order() {
    let headings = [
        "Nominal values:\n",
        "Given limit values:\n",
        "Actual values:\n",
        "Deviations:\n",
        "Further measuring results:\n",
    ];
    let without = headings.iter().fold(LOG.to_owned(), |text, heading| text.replace(heading, ""));
    check(&without, GOOD);
    check(
        &without.replace("Diameter: 0.0259\n", ""),
        "! line 26: deviation -5.0000 is not actual minus nominal value, 12.0259 - 12.0000 column 19",
    );
}

#[test]
fn a_cut_off_log_is_judged_as_long_as_its_actual_values_are_whole() {
    let cut = |at: &str| said(LOG.split_at(LOG.find(at).unwrap()).0);
    let warned = |line: usize| format!("{GOOD}; line {line}: the deviations are missing: the log may be cut off");
    assert_eq!(cut("\nMeasuring log end"), GOOD);
    assert_eq!(cut("Further"), GOOD);
    assert_eq!(cut("Center in minor axis: -0.0470"), warned(27));
    assert_eq!(cut("70\nDiameter: 0.0259"), warned(28));
    assert_eq!(cut("Deviations"), warned(24));
    assert_eq!(cut("\n\nDeviations"), warned(24));
    assert_eq!(
        cut("9\n\nDeviations"),
        "! line 24: the file ends within this value: 12.025 may be incomplete column 11"
    );
    assert_eq!(cut("12.0259"), "! line 21: section of actual values: expected 3, found 2");
    assert_eq!(
        cut("Actual values"),
        "! line 19: section of actual values is missing: the log is cut off or incomplete"
    );
    assert_eq!(cut("Minimum dimension"), "! line 13: section of limit values: expected 6, found 5");
    assert_eq!(cut("Nominal"), "! line 6: section of nominal values is missing: the log is cut off or incomplete");
}

#[test]
fn every_prefix_gives_the_right_diameter_or_an_error() {
    for end in 0..=LOG.len() {
        for log in read(&LOG.as_bytes()[..end]).into_iter().flatten() {
            let [_, _, diameter] = log.figures[..] else { panic!("{end}") };
            assert_eq!(diameter.actual, mm("12.0259"), "{end}");
            assert_eq!(diameter.limits, Some(LimitPair { maximum: mm("12.045"), minimum: mm("12") }), "{end}");
        }
    }
}

#[test]
fn a_log_with_a_line_lost_is_never_read_as_another() {
    let lines: Vec<&str> = LOG.lines().collect();
    let body = [9, 10, 11, 14, 15, 16, 17, 18, 19, 22, 23, 24];
    for lost in body {
        let text: Vec<&str> =
            lines.iter().enumerate().filter(|(at, _)| at + 1 != lost).map(|(_, line)| *line).collect();
        assert!(said(&text.join("\n")).starts_with("! "), "without line {lost}");
    }
}

#[test]
fn contradictions_name_the_line() {
    let with = |from: &str, to: &str, expected: &str| {
        assert!(LOG.contains(from));
        check(&LOG.replace(from, to), expected);
    };
    with("hole: 12.0450", "hole: 11.9999", "! line 18: maximum 11.9999 is below minimum 12.0000 column 29");
    with(
        "50.1000",
        "50.1002",
        "! line 14: limits 49.9000 and 50.1002 are not symmetrical about the nominal value 50.0000 column 45",
    );
    with(
        "Diameter: 0.0259",
        "Diameter: 0.0261",
        "! line 29: deviation 0.0261 is not actual minus nominal value, 12.0259 - 12.0000 column 11",
    );
    with("Diameter: 12.0259", "Diameter: 12.O259", "! line 24: 12.O259 is not a number column 11");
    with(
        "Diameter: 12.0259",
        "Diameter: 1.012,0259",
        "! line 24: 1.012,0259 is ambiguous: write one decimal sign and no thousands separator column 11",
    );
    with("INCH): 0", "INCH): 2", "! line 6: type of dimension 2 is neither 0 (mm) nor 1 (inch) column 40");
    with("Center in minor axis: 65.0000\n", "Center in minor axis:\n65.0000\n7.0\n", "! line 12: no label before 7.0");
    let text_logs = CYCLES.iter().filter(|cycle| matches!(cycle.log, cycle::Log::Text(_)));
    let codes = text_logs.map(|cycle| cycle.code).collect::<Vec<_>>().join(", ");
    with("cycle 421", "cycle 430", &format!("! line 1: logs of cycle 430 cannot be read, only those of {codes}"));
}

#[test]
fn rounding_of_the_last_figure_is_no_contradiction() {
    check(&LOG.replace("Diameter: 0.0259", "Diameter: 0.0260"), GOOD);
    check(&LOG.replace("Diameter: 0.0259", "Diameter: 0.0258"), GOOD);
    check(&LOG.replace("50.1000", "50.1001"), GOOD);
}

#[test]
fn limits_of_zero_mean_that_the_diameter_is_not_monitored() {
    let text = LOG.replace("hole: 12.0450", "hole: 0.0000").replace("hole: 12.0000", "hole: 0.0000");
    check(&text, "12 is 12.0259 in no limits");
}

#[test]
fn one_broken_log_does_not_take_the_others_with_it() {
    let broken = LOG.replace("12.0259", "12.O259");
    check(&format!("{LOG}\n{broken}{LOG}"), &format!("{GOOD}\n! line 59: 12.O259 is not a number column 11\n{GOOD}"));
    // The title of the second log is damaged: its figures are not taken for the first one's.
    let nameless = LOG.replace("421", "4Z1");
    check(
        &format!("{LOG}{nameless}{LOG}"),
        &format!(
            "{GOOD}; line 35: skipped: Measuring log for touch probe cycle 4Z1 Hole measuring\n! line 37: the log has no title line, so its cycle is unknown\n{GOOD}"
        ),
    );
}

#[test]
fn header_oddities_are_warned_of() {
    check(
        &LOG.replace("Type of dimension (0 = MM / 1 = INCH): 0\n", ""),
        &format!("{GOOD}; line 1: no line gives the unit: millimetres assumed"),
    );
    check(
        &LOG.replace("30-06-2005", "31-02-2005"),
        &format!("{GOOD}; line 3: skipped: Date: 31-02-2005; line 1: date and time of the measurement are unknown"),
    );
    check(&LOG.replace("Time:", "Operator: A. B.\nTime:"), &format!("{GOOD}; line 4: skipped: Operator: A. B."));
    check(&format!("From the control\n{LOG}"), &format!("{GOOD}; line 1: text before the first log was skipped"));
}

#[test]
fn what_is_no_log_says_so() {
    check("", "! line 1: the file is empty");
    check(" \r\n", "! line 1: the file is empty");
    check("Hello\n", "! line 1: not a measuring log: no title line with the number of a measuring cycle");
    let garbage: Vec<u8> = (0..4096_u32).map(|n| n.wrapping_mul(2_654_435_761).to_le_bytes()[3]).collect();
    assert!(read(&garbage).iter().all(Result::is_err));
    assert!(!is_log("bore 421;25 H7;25.012\nbore 422;25 H7;25.013\n"));
    assert!(!is_log("# cycle 421\n12,5\n3,4\n5,6\n7,8\n"));
    assert!(is_log(LOG));
}

proptest::proptest! {
    #[test]
    fn any_bytes_are_read_without_panic(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..400)) {
        let _logs = read(&bytes);
    }

    /// A log with one byte changed gives the same limits and diameter, or the change is in one of their figures.
    #[test]
    fn one_changed_byte_does_not_move_figures(at in 0..LOG.len(), byte in proptest::prelude::any::<u8>()) {
        let mut bytes = LOG.as_bytes().to_vec();
        bytes[at] = byte;
        for log in read(&bytes).into_iter().flatten() {
            let [_, _, diameter] = log.figures[..] else { continue };
            let unchanged = [diameter.actual == mm("12.0259"), diameter.nominal == Some(mm("12"))];
            let figures = LOG.as_bytes()[at].is_ascii_digit() || b".-\n".contains(&LOG.as_bytes()[at]);
            proptest::prop_assert!(figures || log.unit == Unit::Inch || unchanged == [true; 2], "{log:?}");
        }
    }
}

#[test]
fn a_value_before_bytes_of_zero_may_be_half_a_number() {
    let at = LOG.find("12.0259").unwrap();
    let begun = format!("{}{}", LOG.get(..at + 4).unwrap(), "\0".repeat(100));
    let said = "12.0 may be incomplete";
    let read_by = read(begun.as_bytes());
    let [Err(error)] = read_by.as_slice() else { panic!("{read_by:?}") };
    assert!(error.to_string().contains(said), "{error}");
    // A log whose lines all end with byte 0 has whole figures.
    let all = LOG.replace('\n', "\0");
    assert!(read(all.as_bytes()).iter().all(Result::is_ok));
    assert!(read(all.replace("12.0259\0", "12.0\x00259\0").as_bytes()).iter().all(Result::is_err));
}

const ON_ONE_LINE: &str = "Measuring log for Probing Cycle 421 Hole Measuring\n\nDate: 02-11-2026\nTime: 8:12:40\nMeasuring program: TNC:\\PARTS\\A1.H\n\n\
    Nominal values:\nCenter in reference axis: 40.0000\nCenter in minor axis: 30.0000\nDiameter: 25.0000\n\n\
    Given limit values:\nMaximum limit for center in reference axis: 40.1000\nMinimum limit for center in reference axis: 39.9000\n\
    Maximum limit for center in minor axis: 30.1000\nMinimum limit for center in minor axis: 29.9000\n\
    Maximum dimension for hole: 25.0210\nMinimum dimension for hole: 25.0000\n\n\
    Actual values:\nCenter in reference axis: 40.0310\nCenter in minor axis: 29.9860\nDiameter: 25.0123\n\n\
    Deviations:\nCenter in reference axis: 0.0310\nCenter in minor axis: -0.0140\nDiameter: 0.0123\n\n\
    Further measuring results: Measuring height: -5.0000\n\nEnd of measuring log\n";

#[test]
fn a_figure_on_the_line_of_its_heading_does_not_hide_the_deviations() {
    let [found] = &read(ON_ONE_LINE.as_bytes())[..] else { panic!() };
    let found = found.as_ref().unwrap();
    let warnings: Vec<String> = found.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(warnings, ["line 1: no line gives the unit: millimetres assumed"]);
    assert_eq!(found.figures[2].deviation.unwrap().to_string(), "0.0123");
    assert_eq!((found.further[0].label.as_str(), found.further[0].value.as_str()), ("Measuring height", "-5.0000"));
    // A time that is none is no heading.
    let broken = ON_ONE_LINE.replace("Time: 8:12:40", "Time: 28:05");
    assert!(read(broken.as_bytes())[0].is_ok());
    // So one that contradicts is found.
    let wrong = ON_ONE_LINE.replace("Diameter: 0.0123", "Diameter: 0.0223");
    let [Err(error)] = &read(wrong.as_bytes())[..] else { panic!() };
    assert_eq!(
        error.to_string(),
        "line 28, column 11: deviation 0.0223 is not actual minus nominal value, 25.0123 - 25.0000"
    );
}
