//! Any bytes as a control's table: what can be written reads back as the same table and is written the same again, in
//! its own kind of header and in the others.

use fitcheck::control::table::{ControlTable, Generation};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let file = match ControlTable::read(bytes, "a.tab") {
        Ok(file) => file,
        Err(error) => return told(bytes, &error),
    };
    for warning in &file.warnings {
        told(bytes, warning);
    }
    let most = 1 + bytes.iter().filter(|byte| b"\r\n\0".contains(byte)).count();
    for (number, row) in file.table.rows.iter().enumerate() {
        assert_eq!(row.len(), file.table.columns.len());
        assert!(file.cell_place(number, 0).line.is_some_and(|line| line <= most));
    }
    for generation in [file.table.generation, Generation::Plain, Generation::Structure, Generation::Description] {
        let table = file.table.to_generation(generation);
        match table.write() {
            Ok(written) => {
                let again = ControlTable::read(&written, "a.tab").expect("a table that was written").table;
                assert_eq!(again, table);
                assert_eq!(again.write(), Ok(written));
            }
            Err(error) => told(bytes, &error),
        }
    }
}
