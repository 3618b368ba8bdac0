//! Measuring logs written: the samples byte for byte, the differences line by line, and round trips.

use std::path::{Path, PathBuf};

use fitcheck::control::log::{Figure, Further, LimitPair, Log, LogWriteError, append, layout, read, write};
use fitcheck::length::{Length, Unit};
use fitcheck::probing::cycle::FigureKind;
use fitcheck::probing::cycles::CYCLES;
use fitcheck::words::Dialogue;
use proptest::prelude::*;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs")
}

fn sample(file: &str) -> Vec<u8> {
    std::fs::read(folder().join(file)).unwrap()
}

fn logs(bytes: &[u8]) -> Vec<Log> {
    read(bytes).into_iter().collect::<Result<_, _>>().unwrap()
}

/// The logs of a file written again, one after another.
fn written(bytes: &[u8], language: Dialogue) -> Vec<u8> {
    logs(bytes).iter().fold(Vec::new(), |file, log| append(&file, log, language).unwrap())
}

/// A sample's language: that of its folder; for the variants, that of their words.
fn language(file: &str) -> Dialogue {
    match file.split_once('/').unwrap() {
        ("variants", "TCHPR421_decimal_comma.TXT") => Dialogue::De,
        ("variants", _) => Dialogue::En,
        (folder, _) => Dialogue::from_code(folder).unwrap(),
    }
}

/// The lines that only one of two texts has, in their order, and how many they share.
fn differences(old: &[u8], new: &[u8]) -> (Vec<String>, usize) {
    let lines = |bytes: &[u8]| -> Vec<String> {
        let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
        text.split_inclusive('\n').map(|line| format!("{line:?}")).collect()
    };
    let (old, new) = (lines(old), lines(new));
    let mut longest = vec![vec![0_usize; new.len() + 1]; old.len() + 1];
    for i in (0..old.len()).rev() {
        for j in (0..new.len()).rev() {
            longest[i][j] =
                if old[i] == new[j] { longest[i + 1][j + 1] + 1 } else { longest[i + 1][j].max(longest[i][j + 1]) };
        }
    }
    let (mut i, mut j, mut found) = (0, 0, Vec::new());
    while i < old.len() || j < new.len() {
        if i < old.len() && j < new.len() && old[i] == new[j] {
            (i, j) = (i + 1, j + 1);
        } else if j < new.len() && (i == old.len() || longest[i + 1][j] < longest[i][j + 1]) {
            found.push(format!("+{}", new[j]));
            j += 1;
        } else {
            found.push(format!("-{}", old[i]));
            i += 1;
        }
    }
    (found, longest[0][0])
}

#[test]
fn samples_are_written_byte_for_byte_as_they_were_read() {
    let mut same = Vec::new();
    let mut other = Vec::new();
    for folder_name in ["de", "en", "it", "nl", "variants"] {
        let mut files: Vec<_> =
            std::fs::read_dir(folder().join(folder_name)).unwrap().map(|file| file.unwrap()).collect();
        files.sort_by_key(std::fs::DirEntry::file_name);
        for file in files {
            let name = format!("{folder_name}/{}", file.file_name().to_string_lossy());
            let bytes = sample(&name);
            if written(&bytes, language(&name)) == bytes { same.push(name) } else { other.push(name) }
        }
    }
    assert_eq!(
        same,
        [
            "de/TCHPR421.TXT",
            "de/TCHPR422.TXT",
            "de/TCHPR427.TXT",
            "en/TCHPR421.TXT",
            "en/TCHPR422.TXT",
            "en/TCHPR427.TXT",
            "it/TCHPR421.TXT",
            "it/TCHPR422.TXT",
            "it/TCHPR427.TXT",
            "nl/TCHPR421.TXT",
            "nl/TCHPR422.TXT",
            "nl/TCHPR427.TXT",
            "variants/TCHPR421_inch.TXT",
            "variants/TCHPR421_two_logs.TXT",
        ]
    );
    // The tests below list the differences of these line by line.
    assert_eq!(
        other,
        [
            "variants/TCHPR421_cut_off.TXT",
            "variants/TCHPR421_decimal_comma.TXT",
            "variants/TCHPR421_value_on_next_line.TXT",
            "variants/TCHPR421_without_unit_line.TXT",
        ]
    );
}

#[track_caller]
fn check_differences(file: &str, expected: &[&str], shared: usize) {
    let bytes = sample(file);
    let (found, same) = differences(&bytes, &written(&bytes, language(file)));
    assert_eq!(found, expected, "{file}");
    assert_eq!(same, shared, "{file}");
}

#[test]
fn a_log_that_was_cut_off_gets_its_end_and_no_deviations() {
    check_differences("variants/TCHPR421_cut_off.TXT", &[r#"+"Measuring log end\r\n""#], 25);
}

#[test]
fn an_old_log_gets_the_line_with_its_unit() {
    let unit = r#"+"Type of dimension (0 = MM / 1 = INCH): 0\r\n""#;
    check_differences("variants/TCHPR421_without_unit_line.TXT", &[unit], 33);
}

#[test]
fn a_decimal_comma_becomes_a_point_and_nothing_else() {
    let bytes = sample("variants/TCHPR421_decimal_comma.TXT");
    let points: Vec<u8> = bytes.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect();
    // 15 figures and the measuring height.
    assert_eq!(bytes.split(|&byte| byte == b',').count(), 17);
    assert_eq!(written(&bytes, Dialogue::De), points);
}

#[test]
fn values_on_lines_of_their_own_move_behind_their_labels() {
    let bytes = sample("variants/TCHPR421_value_on_next_line.TXT");
    let ours = String::from_utf8(written(&bytes, Dialogue::En)).unwrap();
    let theirs = String::from_utf8(bytes).unwrap();
    // Only blanks, blank lines and line ends differ.
    assert!(ours.split_whitespace().eq(theirs.split_whitespace()));
    // In the sample a blank line and the figure follow the label; blank lines also separate the header's lines.
    let blank = |text: &str| text.lines().filter(|line| line.is_empty()).count();
    assert_eq!((theirs.lines().count(), blank(&theirs)), (69, 26));
    assert_eq!((ours.lines().count(), blank(&ours)), (34, 7));
}

#[test]
fn the_published_figures_are_written_in_the_documented_layout() {
    // Figures of the maker's example (TNC7 manual); the columns are our rule.
    let log = Log {
        date: Some(jiff::civil::date(2005, 6, 30)),
        time: Some(jiff::civil::time(6, 55, 4, 0)),
        program: Some(r"TNC:\GEH35712\CHECK1.H".to_owned()),
        further: vec![Further::measuring_height(mm("-5"), Unit::Millimetre, Dialogue::En)],
        ..Log::new(421, published(), Unit::Millimetre)
    };
    let text = String::from_utf8(write(&log, Dialogue::En).unwrap()).unwrap();
    assert_eq!(
        text.replace("\r\n", "\n"),
        "\
Measuring log for touch probe cycle 421 Hole measuring

Date: 30-06-2005
Time: 6:55:04
Measuring program: TNC:\\GEH35712\\CHECK1.H
Type of dimension (0 = MM / 1 = INCH): 0

Nominal values:
Center in reference axis:                          50.0000
Center in minor axis:                              65.0000
Diameter:                                          12.0000

Given limit values:
Maximum limit for center in reference axis:        50.1000
Minimum limit for center in reference axis:        49.9000
Maximum limit for center in minor axis:            65.1000
Minimum limit for center in minor axis:            64.9000
Maximum dimension for hole:                        12.0450
Minimum dimension for hole:                        12.0000

Actual values:
Center in reference axis:                          50.0810
Center in minor axis:                              64.9530
Diameter:                                          12.0259

Deviations:
Center in reference axis:                           0.0810
Center in minor axis:                              -0.0470
Diameter:                                           0.0259

Further measuring results:
Measuring height:                                  -5.0000

Measuring log end
"
    );
    assert_eq!(text.matches("\r\n").count(), text.matches('\n').count());
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

/// A coordinate of the centre, 0.1 either way.
fn centre(nominal: &str, actual: &str) -> Figure {
    Figure::of(mm(nominal), LimitPair::about(mm(nominal), mm("0.1")), mm(actual)).unwrap()
}

fn published() -> Vec<Figure> {
    let limits = LimitPair { maximum: mm("12.045"), minimum: mm("12") };
    let diameter = Figure::of(mm("12"), Some(limits), mm("12.0259")).unwrap();
    vec![centre("50", "50.081"), centre("65", "64.953"), diameter]
}

#[test]
fn good_rework_and_scrap_are_written_alike_for_a_log_holds_no_status() {
    let with = |diameter: &str| {
        let mut circle = published();
        circle[2] = Figure::of(mm("12"), circle[2].limits, mm(diameter)).unwrap();
        let bytes = write(&Log::new(421, circle, Unit::Millimetre), Dialogue::En).unwrap();
        String::from_utf8(bytes).unwrap().replace(|c: char| c.is_ascii_digit() || "- ".contains(c), "")
    };
    assert_eq!(with("12.0259"), with("11.9999"));
    assert_eq!(with("12.0259"), with("12.0451"));
}

#[test]
fn what_a_log_lacks_is_left_out() {
    let mut circle = published();
    for figure in &mut circle {
        figure.deviation = None;
    }
    circle[2].limits = None;
    let log = Log::new(421, circle, Unit::Millimetre);
    let bytes = write(&log, Dialogue::Nl).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(!text.contains("Datum") && !text.contains("Afwijkingen") && !text.contains("Overige"), "{text}");
    let read = logs(&bytes);
    assert_eq!(read[0], Log { warnings: read[0].warnings.clone(), ..log.printed(Dialogue::Nl) });
    let warnings: Vec<_> = read[0].warnings.iter().map(|warning| warning.what.to_string()).collect();
    assert_eq!(
        warnings,
        ["date and time of the measurement are unknown", "the deviations are missing: the log may be cut off"]
    );
}

#[test]
fn figures_finer_than_the_log_are_rounded_half_away_from_zero_and_its_own_limits_decide() {
    let limits = LimitPair { maximum: mm("5.1"), minimum: mm("4.95") };
    let printed = |actual: &str| {
        let log = Log::new(427, vec![Figure::bare(Some(limits), mm(actual))], Unit::Millimetre);
        let read = logs(&write(&log, Dialogue::En).unwrap());
        let [coordinate] = read[0].figures[..] else { panic!("{read:?}") };
        coordinate.actual.to_string()
    };
    assert_eq!(printed("5.10005"), "5.1001");
    // A nanometre less than half a figure: above the maximum when measured, on it in the log.
    assert_eq!(printed("5.100049"), "5.1");
    assert_eq!(printed("4.949951"), "4.95");
    assert_eq!(printed("-0.00005"), "-0.0001");
    assert_eq!(printed("-0.000049"), "0");
}

#[test]
fn a_coordinate_with_a_nominal_value_comes_with_its_deviation() {
    let limits = LimitPair { maximum: mm("5.1"), minimum: mm("4.95") };
    let figures = vec![Figure::of(mm("5"), Some(limits), mm("4.98")).unwrap()];
    let log = Log::new(427, figures.clone(), Unit::Millimetre);
    let bytes = write(&log, Dialogue::De).unwrap();
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    assert!(text.contains("Abweichungen:\r\nGemessene Koordinate:                              -0.0200\r\n"), "{text}");
    assert_eq!(logs(&bytes)[0].figures, figures);
}

#[test]
fn the_measuring_height_is_named_in_the_language_that_is_written() {
    let german = logs(&sample("de/TCHPR421.TXT"));
    let english = logs(&write(&german[0], Dialogue::En).unwrap());
    assert_eq!(english[0].further, [Further { label: "Measuring height".to_owned(), value: "-12.0000".to_owned() }]);
    assert_eq!(english[0].figures, german[0].figures);
}

#[test]
fn logs_are_added_to_a_file_and_all_of_them_read_back() {
    let one = sample("en/TCHPR421.TXT");
    let others = ["de/TCHPR422.TXT", "it/TCHPR427.TXT", "nl/TCHPR422.TXT", "variants/TCHPR421_inch.TXT"];
    let mut file = one.clone();
    for other in others {
        file = append(&file, &logs(&sample(other))[0], language(other)).unwrap();
    }
    let mut expected = one;
    for other in others {
        expected.extend_from_slice(b"\r\n");
        expected.extend(sample(other));
    }
    assert_eq!(file, expected);
    let all = logs(&file);
    assert_eq!(all.iter().map(|log| log.cycle).collect::<Vec<_>>(), [421, 422, 427, 422, 421]);
    for (log, other) in all[1..].iter().zip(others) {
        assert_eq!(log.figures, logs(&sample(other))[0].figures, "{other}");
    }
}

#[test]
fn a_file_in_utf8_stays_in_utf8() {
    let german: String = sample("de/TCHPR421.TXT").iter().map(|&byte| char::from(byte)).collect();
    let log = &logs(german.as_bytes())[0];
    let both = append(german.as_bytes(), log, Dialogue::De).unwrap();
    assert_eq!(std::str::from_utf8(&both).unwrap(), format!("{german}\r\n{german}"));
}

#[test]
fn nothing_is_added_to_a_file_that_is_cut_off() {
    let log = &logs(&sample("en/TCHPR421.TXT"))[0];
    let whole = sample("en/TCHPR421.TXT");
    for end in 1..whole.len() {
        let answer = append(&whole[..end], log, Dialogue::En);
        match answer {
            Ok(both) => {
                assert_eq!(whole[..end].last().map(|last| b"\r\n".contains(last)), Some(true));
                // The earlier content reads as before, whatever it was.
                let before = read(&whole[..end]);
                let after = read(&both);
                assert_eq!(after.last().unwrap().as_ref().unwrap().figures, log.figures, "{end}");
                assert!(after.len() == 1 || after[..after.len() - 1] == before[..], "{end}");
            }
            Err(error) => assert_eq!(error, LogWriteError::Unfinished, "{end}"),
        }
    }
}

#[track_caller]
fn check_error(change: impl Fn(&mut Log), expected: &str) {
    let mut log = Log {
        date: Some(jiff::civil::date(2005, 6, 30)),
        program: Some(r"TNC:\CHECK1.H".to_owned()),
        ..Log::new(421, published(), Unit::Millimetre)
    };
    change(&mut log);
    assert_eq!(write(&log, Dialogue::En).unwrap_err().to_string(), expected);
}

fn shrink(diameter: &mut Figure) {
    *diameter = Figure::of(mm("0.00004"), diameter.limits, diameter.actual).unwrap();
}

#[test]
fn what_would_not_read_back_is_refused() {
    let further = |label: &str, value: &str| Further { label: label.to_owned(), value: value.to_owned() };
    check_error(|log| log.cycle = 427, "cycle 427 does not write these values");
    check_error(|log| log.cycle = 444, "cycle 444 does not write these values");
    check_error(|log| log.cycle = 430, "cycle 430 does not write these values");
    check_error(|log| log.unit = Unit::Micrometre, "a log is in mm or inch, not in µm");
    check_error(
        |log| log.program = Some("TNC:\\\u{20ac}.H".to_owned()),
        "TNC:\\\u{20ac}.H cannot be written: a log cannot contain the character U+20AC",
    );
    check_error(
        |log| log.program = Some("TNC:\\A\nB.H".to_owned()),
        "TNC:\\A\u{fffd}B.H cannot be written: a log cannot contain the character U+000A",
    );
    let path = "would not be read back as the path of a program: write a path such as TNC:\\PART\\CHECK.H";
    check_error(|log| log.program = Some("CHECK1".to_owned()), &format!("CHECK1 {path}"));
    // Two letters of Latin-1 that are also one letter of UTF-8.
    check_error(|log| log.program = Some("TNC:\\\u{c3}\u{b6}.H".to_owned()), &format!("TNC:\\\u{c3}\u{b6}.H {path}"));
    let otherwise = "the log cannot be written so that it reads back the same: check date, time and further results";
    check_error(|log| log.date = Some(jiff::civil::date(999, 1, 1)), otherwise);
    check_error(|log| log.further = vec![further("Tool", "")], otherwise);
    check_error(|log| log.further = vec![further("Again", "1-2-2020")], otherwise);
    check_error(|log| log.further = vec![further("a: b", "1")], otherwise);
    check_error(
        |log| log.figures[2].actual = mm("12.03"),
        "deviation 0.0259 is not actual minus nominal value, 12.0300 - 12.0000",
    );
    // Above zero, but not as printed.
    check_error(|log| shrink(&mut log.figures[2]), "diameter 0.0000 is not above 0");
    check_error(
        |log| log.figures[2].limits = Some(LimitPair { maximum: mm("1"), minimum: mm("2") }),
        "maximum 1.0000 is below minimum 2.0000",
    );
    check_error(
        |log| log.figures[0].limits.as_mut().unwrap().maximum = mm("51"),
        "limits 49.9000 and 51.0000 are not symmetrical about the nominal value 50.0000",
    );
    // A log of the stud with a hole's figures stays a log of a stud: only its words differ.
    let stud = Log { cycle: 422, ..Log::new(421, published(), Unit::Millimetre) };
    assert_eq!(logs(&write(&stud, Dialogue::En).unwrap())[0].cycle, 422);
    let short = Log::new(425, published(), Unit::Millimetre);
    assert_eq!(write(&short, Dialogue::En), Err(LogWriteError::Cycle { cycle: 425 }));
}

/// Nanometres of a log's last figure.
const fn figure(unit: Unit) -> i64 {
    match unit {
        Unit::Inch => 2_540,
        _ => 100,
    }
}

/// Lengths within the control's input range, in whole steps.
fn coordinate(step: i64) -> impl Strategy<Value = Length> {
    let most = 99_999_999_900 / step;
    (-most..=most).prop_map(move |steps| Length::from_nanometres(steps * step).unwrap())
}

fn size(step: i64) -> impl Strategy<Value = Length> {
    let most = 99_999_999_900 / step;
    (1_300..=most).prop_map(move |steps| Length::from_nanometres(steps * step).unwrap())
}

fn small(step: i64) -> impl Strategy<Value = Length> {
    (0..=2_000_000 / step).prop_map(move |steps| Length::from_nanometres(steps * step).unwrap())
}

fn pair(a: Length, b: Length) -> LimitPair {
    LimitPair { maximum: a.max(b), minimum: a.min(b) }
}

fn centres(step: i64) -> impl Strategy<Value = Figure> {
    (coordinate(step), small(step), coordinate(step)).prop_map(|(nominal, tolerance, actual)| {
        Figure::of(nominal, LimitPair::about(nominal, tolerance), actual).unwrap()
    })
}

fn sizes(step: i64) -> impl Strategy<Value = Figure> {
    let limits = proptest::option::of([size(step), size(step)]);
    (size(step), limits, size(step))
        .prop_map(|(nominal, limits, actual)| Figure::of(nominal, limits.map(|[a, b]| pair(a, b)), actual).unwrap())
}

fn coordinates(step: i64) -> impl Strategy<Value = Figure> {
    let limits = [coordinate(step), coordinate(step)];
    (proptest::option::of(coordinate(step)), limits, coordinate(step)).prop_map(|(nominal, [a, b], actual)| {
        // Limits of 0 and 0 are those of a coordinate that was not monitored.
        let limits = Some(pair(a, b)).filter(|pair| pair.maximum != Length::ZERO || pair.minimum != Length::ZERO);
        nominal.map_or(Figure::bare(limits, actual), |nominal| Figure::of(nominal, limits, actual).unwrap())
    })
}

/// The figures of every cycle with a log, from its declaration.
fn values(step: i64) -> impl Strategy<Value = (u16, Vec<Figure>)> {
    let logs = CYCLES.iter().filter_map(|cycle| Some((cycle.number, layout(cycle.number)?)));
    let logs = proptest::sample::select(logs.collect::<Vec<_>>());
    logs.prop_flat_map(move |(cycle, layout)| {
        let figures = layout.figures.iter().map(|figure| match figure.kind {
            FigureKind::Centre(_) => centres(step).boxed(),
            FigureKind::Size(_) => sizes(step).boxed(),
            FigureKind::Coordinate => coordinates(step).boxed(),
            FigureKind::Information => coordinate(step).prop_map(|actual| Figure::bare(None, actual)).boxed(),
        });
        (Just(cycle), figures.collect::<Vec<_>>())
    })
}

/// A log with the finest step that its figures may have, in nanometres; `None` for the printed grid.
fn any_log(step: Option<i64>) -> impl Strategy<Value = (Log, Dialogue)> {
    let unit = prop_oneof![Just(Unit::Millimetre), Just(Unit::Inch)];
    let language = proptest::sample::select(Dialogue::ALL.to_vec());
    (unit, language).prop_flat_map(move |(unit, language)| {
        let step = step.unwrap_or_else(|| figure(unit));
        let date = (1900_i16..2200, 1_i8..=12, 1_i8..=28).prop_map(|(y, m, d)| jiff::civil::date(y, m, d));
        let time = (0_i8..24, 0_i8..60, 0_i8..60).prop_map(|(h, m, s)| jiff::civil::time(h, m, s, 0));
        let program =
            proptest::option::of(r"(TNC|PLC|SF):\\([A-Z0-9_äöüßé]{1,8}\\){0,3}[A-Z0-9_ -]{0,8}[A-Z0-9_]\.(H|I)");
        (values(step), proptest::option::of(date), proptest::option::of(time), program, coordinate(figure(unit)))
            .prop_map(move |((cycle, figures), date, time, program, height)| {
                let further = vec![Further::measuring_height(height, unit, language)];
                (Log { date, time, program, further, ..Log::new(cycle, figures, unit) }, language)
            })
    })
}

/// The log as it is read back, except for the title of the language and warnings about what was left out.
fn as_read(log: &Log, read: &Log) -> Log {
    Log { title: read.title.clone(), warnings: read.warnings.clone(), ..log.clone() }
}

/// Every length of a log.
fn figures(log: &Log) -> Vec<Length> {
    let lengths = log.figures.iter().flat_map(|figure| {
        let limits = figure.limits.map(|pair| [pair.maximum, pair.minimum]);
        let others = [figure.nominal, Some(figure.actual), figure.deviation];
        others.into_iter().flatten().chain(limits.into_iter().flatten()).collect::<Vec<_>>()
    });
    lengths.collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Figures on the printed grid come back unchanged, in every language and unit.
    #[test]
    fn a_log_reads_back_unchanged((log, language) in any_log(None)) {
        let bytes = write(&log, language).unwrap();
        let read = logs(&bytes);
        prop_assert_eq!(read.len(), 1);
        prop_assert_eq!(&read[0], &as_read(&log, &read[0]));
        prop_assert_eq!(&read[0].title, &log.printed(language).title);
        // Written again, it is the same file.
        prop_assert_eq!(write(&read[0], language).unwrap(), bytes);
    }

    /// Finer figures come back as the nearest printed one.
    #[test]
    fn finer_figures_come_back_rounded((log, language) in any_log(Some(1))) {
        let read = logs(&write(&log, language).unwrap());
        prop_assert_eq!(&read[0], &Log { warnings: read[0].warnings.clone(), ..log.printed(language) });
        let step = figure(log.unit);
        for (exact, printed) in figures(&log).into_iter().zip(figures(&read[0])) {
            prop_assert_eq!(printed.nanometres() % step, 0);
            let off = printed.nanometres().abs() - exact.nanometres().abs();
            // Half a figure is rounded away from zero.
            prop_assert!(-step < off * 2 && off * 2 <= step, "{} is printed as {}", exact, printed);
        }
    }

    /// A file of several logs returns all of them, in their order.
    #[test]
    fn a_file_of_several_logs_gives_all_back(all in proptest::collection::vec(any_log(None), 1..5)) {
        let mut file = Vec::new();
        for (log, language) in &all {
            file = append(&file, log, *language).unwrap();
        }
        let read = logs(&file);
        prop_assert_eq!(read.len(), all.len());
        for ((log, _), read) in all.iter().zip(&read) {
            prop_assert_eq!(read, &Log { line: read.line, ..as_read(log, read) });
        }
    }
}
