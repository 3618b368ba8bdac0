//! Round trips, what cannot be written, and random input.

use super::*;

const GENERATIONS: [Generation; 3] = [Generation::Plain, Generation::Structure, Generation::Description];

#[test]
fn reading_writing_and_reading_again_gives_the_same_table() {
    let folder = root("tests/data/samples/tables");
    let shipped = root("tables");
    for name in ["82553_hole.tab", "82553_shaft.tab"] {
        let bytes = std::fs::read(shipped.join(name)).unwrap();
        let table = ControlTable::read(&bytes, name).unwrap().table;
        assert!(table.write().unwrap() == bytes, "{name} changes its bytes");
    }
    let files = std::fs::read_dir(folder).unwrap().chain(std::fs::read_dir(shipped).unwrap());
    let mut count = 0;
    for path in files.map(|entry| entry.unwrap().path()).filter(|path| !path.ends_with(".gitattributes")) {
        let name = path.display().to_string();
        let table = ControlTable::read(&std::fs::read(&path).unwrap(), &name).unwrap().table;
        let again = ControlTable::read(&table.write().unwrap(), &name).unwrap();
        assert_eq!(again.table, table, "{name}");
        for generation in GENERATIONS {
            let converted = table.to_generation(generation);
            let again = ControlTable::read(&converted.write().unwrap(), &name).unwrap();
            assert_eq!(again.warnings, [], "{name}");
            assert_eq!(again.table, converted, "{name}");
            assert_eq!(again.table.rows, table.rows, "{name}");
        }
        count += 1;
    }
    assert_eq!(count, 9);
}

#[test]
fn deviations_survive_all_three_generations() {
    for table in &shipped_tables() {
        for generation in GENERATIONS {
            let bytes = to_control_table(table, generation).write().unwrap();
            let (again, warnings) = read_table(&bytes, table.name(), "x", true).unwrap();
            assert_eq!(warnings, []);
            assert_eq!(again.unwrap(), **table);
        }
    }
}

fn table_of(names: &[&str], rows: &[&[&str]]) -> ControlTable {
    ControlTable {
        name: "own".to_owned(),
        suffix: Some("tab".to_owned()),
        unit: None,
        version: None,
        mark: None,
        generation: Generation::Plain,
        columns: names.iter().map(|name| Column::plain(name, 7.max(name.chars().count() + 1))).collect(),
        properties: Vec::new(),
        rows: rows.iter().map(|row| row.iter().map(|cell| (*cell).to_owned()).collect()).collect(),
        comments: Vec::new(),
    }
}

#[test]
fn what_a_control_cannot_take_is_not_written() {
    let sound = table_of(&["NR", "H7"], &[&["0", "+1"]]);
    assert!(sound.write().is_ok());
    let wide = table_of(&["NR", "H7"], &[&["0", "+1000.25"]]);
    assert_eq!(wide.write().unwrap_err().to_string(), "row 0, column H7: +1000.25 does not fit into 7 characters");
    for (names, row) in [
        (["NR", "H 7"], ["0", "1"]),
        (["NR", "NR"], ["0", "1"]),
        ([";NR", "H7"], ["0", "1"]),
        (["NR", "H7"], [";0", "1"]),
        (["NR", "H7"], ["", ""]),
        (["NR", "H7"], ["END", ""]),
        (["NR", "H7"], ["0", " 1"]),
        (["NR", "H7"], ["0", "1\n2"]),
    ] {
        assert_eq!(table_of(&names, &[&row]).write(), Err(WriteError::ReadsOtherwise), "{names:?} {row:?}");
    }
    let names: Vec<String> = (0..31).map(|number| format!("C{number}")).collect();
    let many = table_of(&names.iter().map(String::as_str).collect::<Vec<_>>(), &[]);
    assert!(many.write().is_ok());
    let many = many.to_generation(Generation::Structure);
    assert_eq!(many.write(), Err(WriteError::TooManyColumns { columns: 31, limit: 30 }));
    let mut long = table_of(&["NR", "H7"], &[]).to_generation(Generation::Structure);
    long.columns[1].width = 193;
    assert!(long.write().is_ok(), "200 characters");
    long.columns[1].width = 194;
    assert_eq!(long.write(), Err(WriteError::TooLong { characters: 201, limit: 200 }));
}

fn any_table() -> impl Strategy<Value = ControlTable> {
    let names = prop::collection::btree_set("[A-Za-zØ][A-Za-z0-9_/ß]{0,7}", 1..6);
    let cells = prop::collection::vec(prop::collection::vec("[+-]?[0-9A-Zµ€Ω.,]{0,5}", 6), 0..6);
    let texts = prop::collection::vec("[a-z;*= ß]{0,10}", 0..4);
    (names, cells, texts, 0..3_usize, 0..3_usize).prop_filter_map(
        "reads otherwise",
        |(names, cells, texts, generation, unit)| {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let mut table = table_of(&names, &[]);
            table.rows = cells.into_iter().map(|row| row.into_iter().take(names.len()).collect()).collect();
            table.unit = [None, Some(TableUnit::Millimetre), Some(TableUnit::Inch)][unit];
            let rows = table.rows.len();
            table.comments = texts
                .into_iter()
                .enumerate()
                .map(|(number, text)| Comment {
                    place: if number == 0 { CommentPlace::Header } else { CommentPlace::Row(number.min(rows)) },
                    text,
                })
                .collect();
            table = table.to_generation(GENERATIONS[generation]);
            // Rows of blanks and a name END cannot be told from what they look like.
            let is_sound = table.rows.iter().all(|row| {
                let text = row.concat();
                !text.is_empty() && text != "END"
            });
            (is_sound && names != ["END"]).then_some(table)
        },
    )
}

proptest! {
    #[test]
    fn any_written_table_reads_back_the_same(table in any_table()) {
        let bytes = table.write().unwrap();
        let again = ControlTable::read(&bytes, "x").unwrap();
        prop_assert_eq!(&again.table, &table);
        prop_assert!(again.warnings.is_empty());
        prop_assert_eq!(again.table.write().unwrap(), bytes);
    }

    #[test]
    fn any_deviations_read_back_the_same(
        steps in prop::collection::vec(1..500_000_000_i64, 1..8),
        cells in prop::collection::vec(prop::option::of((-400_000..400_000_i64, 0..400_000_i64)), 8),
        generation in 0..3_usize,
    ) {
        let nm = |nm: i64| Length::from_nanometres(nm).unwrap();
        let mut end = 0;
        let ends: Vec<Length> = steps.iter().map(|step| { end += step; nm(end) }).collect();
        let cells = cells.iter().take(ends.len()).map(|cell| {
            cell.map(|(lower, width)| Deviations::new(nm(lower + width), nm(lower)).unwrap())
        });
        let class: ToleranceClass = "U1".parse().unwrap();
        let mut columns = vec![ClassColumn { class, cells: cells.collect() }];
        columns.push(ClassColumn { class: "h7".parse().unwrap(), cells: columns[0].cells.iter().copied().rev().collect() });
        let table = DeviationTable::new("own.tab", false, ends, columns).unwrap();
        let bytes = to_control_table(&table, GENERATIONS[generation]).write().unwrap();
        let again = read_table(&bytes, "own.tab", "own.tab", false).unwrap().0.unwrap();
        prop_assert_eq!(again, table);
    }

    #[test]
    fn no_bytes_bring_the_reader_down(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _either = read_table(&bytes, "x", "x", false);
        let mut table = b"BEGIN x.tab\n".to_vec();
        table.extend(bytes);
        let _either = read_table(&table, "x", "x", false);
    }

    #[test]
    fn no_damaged_table_brings_the_reader_down(at in 0..4000_usize, length in 0..20_usize, new in "[ \\[\\]();:=\"*#0-9A-Z\n]{0,6}") {
        for name in ["generation2_struct.tab", "generation3_description.tab", "decimal_comma_latin1_crlf.tab"] {
            let mut bytes = sample(name);
            let at = at % bytes.len();
            let end = (at + length).min(bytes.len());
            bytes.splice(at..end, new.bytes());
            if let Ok(file) = ControlTable::read(&bytes, name)
                && let Ok(written) = file.table.write()
            {
                prop_assert_eq!(ControlTable::read(&written, name).unwrap().table, file.table);
            }
        }
    }
}
