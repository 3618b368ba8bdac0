//! Unit tests. What is read and refused is tested on files, in `tests/core/tables`.

use super::*;

#[test]
fn the_shipped_tables_can_be_read_without_a_warning() {
    let files = ["82553_hole.tab", "82553_shaft.tab"];
    for name in files {
        let (table, warnings) = read_table(shipped::file(shipped::TABLES, name).unwrap(), name, name, true).unwrap();
        assert!(table.is_some() && warnings.is_empty(), "{name}: {warnings:?}");
    }
    assert_eq!(shipped_tables().len(), files.len());
}
