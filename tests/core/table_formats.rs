//! Tables of deviations as files of other tools and of controls.

use std::path::Path;

use fitcheck::control::deviations::read_table;
use fitcheck::exchange::tables::{TABLE_FORMATS, TableFormat};
use fitcheck::tolerance::DeviationTable;
use fitcheck::tolerance::iso286::Options;
use fitcheck::tolerance::table_edit::standard_table;

/// The format of a name.
pub fn table_format(name: &str) -> Option<&'static TableFormat> {
    TABLE_FORMATS.iter().find(|format| format.name == name)
}

fn table(name: &str, classes: &str, to: &str) -> DeviationTable {
    let classes: Vec<_> = classes.split(' ').map(|class| class.parse().unwrap()).collect();
    standard_table(name, &classes, to.parse().unwrap(), Options::default()).unwrap()
}

#[test]
fn what_is_written_for_a_control_reads_back() {
    let table = table("own.tab", "H7 JS9 N9", "400");
    for format in TABLE_FORMATS.iter().filter(|format| format.endings.contains(&"tab")) {
        let bytes = (format.write)(&table).unwrap();
        let (again, warnings) = read_table(&bytes, "own.tab", "own.tab", false).unwrap();
        assert_eq!((again.as_ref(), warnings), (Some(&table), vec![]), "{}", format.name);
    }
}

#[test]
fn the_limits_of_a_control_are_kept() {
    let holes: Vec<String> = (1..=18).flat_map(|grade| ["D", "H"].map(|letter| format!("{letter}{grade}"))).collect();
    let wide = table("wide.tab", &holes.join(" "), "50");
    let error = |name: &str, table: &DeviationTable| (table_format(name).unwrap().write)(table).unwrap_err();
    let many = error("itnc530", &wide);
    assert!(many.to_string().contains("an iTNC 530 takes at most 30"), "{many}");
    assert!((table_format("tnc640").unwrap().write)(&wide).is_ok());
    let digit = error("tnc7", &table("82553_hole.tab", "H7", "50"));
    let why = "82553_hole.tab does not begin with a letter: table names on a TNC7 must";
    assert_eq!(digit.to_string(), why);
    let operator = error("tnc7", &table("my-hole.tab", "H7", "50"));
    let why = "my-hole.tab contains -: table names on a TNC7 cannot have arithmetic operators";
    assert_eq!(operator.to_string(), why);
    assert!((table_format("tnc7").unwrap().write)(&table("my_hole.tab", "H7", "50")).is_ok());
}

#[track_caller]
fn check(format: &str, classes: &str, to: &str, expected: &str) {
    let bytes = (table_format(format).unwrap().write)(&table("own.tab", classes, to)).unwrap();
    assert_eq!(String::from_utf8(bytes).unwrap(), expected);
}

#[test]
fn csv_has_a_line_for_every_cell_that_has_a_value() {
    check(
        "csv",
        "JS7 N9",
        "6",
        "class,over_mm,to_mm,upper_um,lower_um\n\
         JS7,0,1,5,-5\nJS7,1,3,5,-5\nJS7,3,6,6,-6\n\
         N9,1,3,-4,-29\nN9,3,6,0,-30\n",
    );
}

/// The sample of the manual, PC-DMIS Core, page "ISO Dimension Tolerances".
#[test]
fn pc_dmis_gets_two_lines_a_class() {
    check(
        "pcdmis",
        "H7",
        "500",
        "H7, 0, 3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500\n\
         0.010, 0, 0.012, 0, 0.015, 0, 0.018, 0, 0.021, 0, 0.025, 0, 0.030, 0, 0.035, 0, 0.040, 0, 0.046, 0, \
         0.052, 0, 0.057, 0, 0.063, 0\n",
    );
    check("pcdmis", "js9", "6", "js9, 0, 3, 6\n0.0125, -0.0125, 0.015, -0.015\n");
    check("pcdmis", "T7", "40", "T7, 24, 30, 40\n-0.033, -0.054, -0.039, -0.064\n");
}

#[test]
fn pc_dmis_is_not_trusted_with_signs_that_its_manual_does_not_show() {
    let warning = |classes: &str| (table_format("pcdmis").unwrap().warning)(&table("own.tab", classes, "50"));
    assert_eq!(warning("H7 H8"), None);
    let said = warning("H7 F8 G7").unwrap();
    assert_eq!(
        said.to_string(),
        "the PC-DMIS manual shows no lower deviation other than 0: check F8 in PC-DMIS before you rely on it, especially its signs"
    );
}

#[test]
fn a_format_knows_its_files_by_their_ending() {
    let fits = |format: &str, file: &str| table_format(format).unwrap().fits(Path::new(file));
    assert!(fits("csv", "iso.csv") && fits("pcdmis", "a/iso.CSV") && fits("tnc7", "own.TAB"));
    assert!(!fits("csv", "own.tab") && !fits("itnc530", "own") && !fits("tnc640", "tab"));
}
