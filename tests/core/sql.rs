//! The SQL of `fitcheck sql`: what it holds against the library, cell by cell. `tests/engines` runs it on real engines.

use std::collections::{BTreeMap, BTreeSet};

use fitcheck::exchange::sql::{DIALECTS, Dialect, ERRORS, LIMIT_ERRORS, Model, write};
use fitcheck::length::Length;
use fitcheck::tolerance::iso286::{Edition, JsHalves, Options, classes, deviations, step_ends};
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{DeviationTable, Deviations, Feature, Sources, ToleranceClass};

fn dialect(name: &str) -> &'static Dialect {
    DIALECTS.iter().find(|dialect| dialect.name == name).unwrap()
}

fn sql(model: &Model, dialect: &Dialect) -> String {
    let mut bytes = Vec::new();
    write(model, dialect, &mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

/// The rows that a table is filled with, as cells.
fn rows(sql: &str, table: &str) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    let mut is_inside = false;
    for line in sql.lines() {
        if line.starts_with("insert into ") {
            is_inside = line == format!("insert into {table} values");
        } else if is_inside {
            let cells = line.strip_prefix('(').unwrap().trim_end_matches([',', ';']).strip_suffix(')').unwrap();
            rows.push(cells.split(',').map(|cell| cell.trim_matches('\'').to_owned()).collect());
            is_inside = !line.ends_with(';');
        }
    }
    rows
}

/// Class and step, with lower and upper deviation as written.
type Cells = BTreeMap<(String, usize), (String, String)>;

fn cells(sql: &str) -> Cells {
    let rows = rows(sql, "fitcheck_limits");
    let count = rows.len();
    let cell = |row: Vec<String>| ((row[0].clone(), row[1].parse().unwrap()), (row[4].clone(), row[5].clone()));
    let cells: Cells = rows.into_iter().map(cell).collect();
    assert_eq!(cells.len(), count, "a class has two cells in a step");
    cells
}

/// Every cell of the standard, at the end of its step and just above the end before it.
fn standard(options: Options, unit: fn(Length) -> String) -> Cells {
    let mut cells = Cells::new();
    for class in [Feature::Hole, Feature::Shaft].into_iter().flat_map(|feature| classes(feature, options)) {
        let mut over = Length::ZERO;
        for (step, end) in (1..).zip(step_ends()) {
            let above = Length::from_nanometres(over.nanometres() + 1).unwrap();
            let both = [above, end].map(|size| deviations(class, size, options).ok().map(|cell| cell.deviations));
            assert_eq!(both[0], both[1], "{class} changes within a step");
            if let Some(found) = both[0] {
                cells.insert((class.to_string(), step), (unit(found.lower()), unit(found.upper())));
            }
            over = end;
        }
    }
    cells
}

#[test]
fn every_cell_is_the_librarys_and_none_is_missing() {
    for (edition, js) in [(Edition::Of2010, JsHalves::Exact), (Edition::Of1988, JsHalves::Rounded)] {
        let options = Options { edition, js };
        let model = Model::new(&Sources::default().with_options(options), None).unwrap();
        for dialect in DIALECTS {
            let unit: fn(Length) -> String = match dialect.name {
                "sqlite" => |length| length.nanometres().to_string(),
                _ => |length| length.to_string(),
            };
            let written = cells(&sql(&model, dialect));
            assert!(written == standard(options, unit), "{} {options:?}", dialect.name);
        }
        if options == Options::default() {
            assert_eq!((model.defined(), model.cells().len()), (1077, 31_565));
        }
    }
}

#[test]
fn every_millimetre_has_the_step_that_it_belongs_to() {
    let model = Model::new(&Sources::default(), None).unwrap();
    let written = rows(&sql(&model, dialect("postgres")), "fitcheck_step");
    let ends: Vec<i64> = step_ends().map(|end| end.nanometres() / 1_000_000).collect();
    assert_eq!(written.len(), 3150);
    for (mm, row) in (1..).zip(&written) {
        let (given, step): (i64, usize) = (row[0].parse().unwrap(), row[1].parse().unwrap());
        let over = step.checked_sub(2).map_or(0, |before| ends[before]);
        assert!(given == mm && over < mm && mm <= ends[step - 1], "{row:?}");
    }
    let cells = rows(&sql(&model, dialect("postgres")), "fitcheck_limits");
    for row in cells {
        let [step, over, to]: [i64; 3] = [1, 2, 3].map(|at| row[at].parse().unwrap());
        let number = usize::try_from(step).unwrap() - 1;
        assert_eq!((over, to), (number.checked_sub(1).map_or(0, |before| ends[before]), ends[number]), "{row:?}");
    }
}

/// A class of the standard without limits at any size is known, so that it is refused as such and not as unknown.
#[test]
fn every_letter_with_every_grade_is_known_as_hole_and_as_shaft() {
    let model = Model::new(&Sources::default(), None).unwrap();
    for dialect in DIALECTS {
        let known = rows(&sql(&model, dialect), "fitcheck_class");
        assert_eq!(known.len(), 2 * 28 * 20, "{}", dialect.name);
        assert!(known.iter().any(|row| row[0] == "J9"));
        for row in known {
            let is_hole = row[0].starts_with(|c: char| c.is_ascii_uppercase());
            assert_eq!(row[1], is_hole.to_string(), "{row:?}");
        }
    }
}

#[test]
fn the_same_names_and_errors_are_in_every_dialect() {
    let model = Model::new(&Sources::default(), Some(vec!["H7".parse().unwrap()])).unwrap();
    let names = |sql: &str| -> BTreeSet<String> {
        let made = sql.lines().filter_map(|line| {
            line.strip_prefix("create table ").or_else(|| line.strip_prefix("create view ")).map(str::to_owned)
        });
        made.map(|rest| rest.split([' ', '(']).next().unwrap().to_owned()).collect()
    };
    let first = names(&sql(&model, &DIALECTS[0]));
    assert_eq!(first.len(), 12, "{first:?}");
    for dialect in DIALECTS {
        let text = sql(&model, dialect);
        assert_eq!(names(&text), first, "{}", dialect.name);
        let (head, body) = text.split_once("create table").unwrap();
        assert!(
            head.lines().all(|line| line.is_empty() || ["--", "begin", "set"].iter().any(|it| line.starts_with(it)))
        );
        let view = body.split("create view fitcheck_verdict_text").nth(1).unwrap();
        // Within each of the two chains of cases, and the limits' chain is the first case of the other.
        for (codes, before) in
            [(&ERRORS[..4], "case when "), (&ERRORS[4..], "when limits_error is not null then limits_error")]
        {
            let mut rest = view.split_once(before).unwrap().1;
            for (code, meaning) in codes {
                assert!(head.contains(&format!("{code:<22} {meaning}")), "{} does not explain {code}", dialect.name);
                let quoted = format!("'{code}'");
                rest = rest.split_once(&quoted).unwrap_or_else(|| panic!("{}: {code}", dialect.name)).1;
            }
        }
        let mut rest = body.split("create view fitcheck_verdict_limits").nth(1).unwrap();
        for (code, meaning) in LIMIT_ERRORS.iter().chain(&ERRORS[4..5]) {
            assert!(head.contains(&format!("{code:<22} {meaning}")), "{} does not explain {code}", dialect.name);
            let quoted = format!("'{code}'");
            rest = rest.split_once(&quoted).unwrap_or_else(|| panic!("{}: {code}", dialect.name)).1;
        }
        for word in ["'OUT OF LIMITS'", "'GOOD'", "'REWORK'", "'SCRAP'"] {
            assert!(body.contains(word), "{} lacks {word}", dialect.name);
        }
        assert!(!text.contains('\\') && text.is_ascii(), "{}", dialect.name);
    }
}

#[test]
fn the_same_bytes_come_twice() {
    for dialect in DIALECTS {
        let made = || sql(&Model::new(&Sources::default(), None).unwrap(), dialect);
        assert!(made() == made(), "{}", dialect.name);
    }
}

fn pair(upper: i32, lower: i32) -> Option<Deviations> {
    Deviations::new(Length::from_micrometres(upper), Length::from_micrometres(lower)).ok()
}

fn own(name: &str, ends: &[&str], columns: &[(&str, Option<Deviations>)]) -> Sources {
    let ends: Vec<_> = ends.iter().map(|end| mm(end)).collect();
    let column = |(class, cell): &(&str, Option<Deviations>)| Column {
        class: class.parse().unwrap(),
        cells: vec![*cell; ends.len()],
    };
    let table = DeviationTable::new(name, false, ends.clone(), columns.iter().map(column).collect()).unwrap();
    Sources::default().with_own(vec![table])
}

#[test]
fn own_tables_come_first_and_what_they_lack_is_answered_by_the_standard() {
    let sources = own("it's \\ own.tab", &["5", "20"], &[("H7", pair(9, 1)), ("KX1", pair(3, 2)), ("G7", None)]);
    let model = Model::new(&sources, None).unwrap();
    assert!(model.ends().contains(&5) && model.ends().contains(&20));
    let text = sql(&model, dialect("sqlite"));
    let cell = |class: &str, to: &str| {
        rows(&text, "fitcheck_limits")
            .into_iter()
            .find(|row| row[0] == class && row[3] == to)
            .map(|row| row[4..].join(" "))
    };
    let named = |name: &str| model.sources().iter().position(|source| source == name).unwrap() + 1;
    // Where the table differs, the source says what the standard has.
    let first = named("table it's \\ own.tab, over 0 up to 5 mm, instead of 0 / +12 µm in ISO 286");
    let second = named("table it's \\ own.tab, over 5 up to 20 mm, instead of 0 / +21 µm in ISO 286");
    let plain = named("table it's \\ own.tab, over 5 up to 20 mm");
    assert_eq!(cell("H7", "5"), Some(format!("1000 9000 {first}")));
    assert_eq!(cell("H7", "20"), Some(format!("1000 9000 {second}")));
    assert_eq!(cell("H7", "24"), Some(format!("0 21000 {}", named("ISO 286, over 18 up to 30 mm"))));
    assert_eq!(cell("KX1", "6"), Some(format!("2000 3000 {plain}")));
    assert_eq!((cell("KX1", "24"), cell("G7", "10")), (None, None));
    assert!(cell("G7", "24").is_some());
    // Quotation marks are doubled, or put in by their number; a backslash is never in a literal of Spark.
    assert!(text.contains("'table it''s \\ own.tab, over 0 up to 5 mm'"));
    let spark = "concat('table it', char(39), 's ', char(92), ' own.tab, over 0 up to 5 mm')";
    assert!(sql(&model, dialect("spark")).contains(spark));
}

#[test]
fn a_name_of_a_table_does_not_end_the_comment() {
    let sources = own("a\ndrop table fitcheck_limits;\r--.tab", &["5"], &[("KX1", pair(3, 2))]);
    let model = Model::new(&sources, None).unwrap();
    for dialect in DIALECTS {
        let text = sql(&model, dialect);
        let head = text.split("create table").next().unwrap();
        assert!(head.lines().all(|line| !line.starts_with("drop")), "{}", dialect.name);
    }
}

#[track_caller]
fn refused(sources: &Sources, chosen: &[&str], expected: &str) {
    let chosen: Vec<ToleranceClass> = chosen.iter().map(|class| class.parse().unwrap()).collect();
    let error = Model::new(sources, (!chosen.is_empty()).then_some(chosen)).unwrap_err();
    assert_eq!(error.to_string(), expected);
}

#[test]
fn borders_within_a_millimetre_and_classes_without_limits_are_refused() {
    let half = own("half.tab", &["2.5", "3"], &[("KX1", pair(3, 2))]);
    let within = "table half.tab: a size range ends at 2.5 mm; as SQL, ranges must end at whole millimetres";
    refused(&half, &[], within);
    refused(&half, &["KX1"], within);
    assert!(Model::new(&half, Some(vec!["H7".parse().unwrap()])).is_ok(), "that table has no H7");
    let far = own("far.tab", &["100000", "100001"], &[("KX1", pair(3, 2))]);
    refused(&far, &[], "table far.tab: a size range ends at 100001 mm; as SQL, ranges must end by 100000 mm");
    refused(&Sources::default(), &["H7", "g6", "H7"], "class H7 is named twice");
    let nowhere = "J9 is not defined at 3150 mm in ISO 286; it is not defined at any size";
    refused(&Sources::default(), &["H7", "J9"], nowhere);
}
