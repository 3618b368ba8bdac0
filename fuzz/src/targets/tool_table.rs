//! Any bytes as a tool table: unchanged it is written as it was read; with a corrected tool it reads back as the same
//! tools, or is refused.

use std::sync::LazyLock;

use fitcheck::control::table::TableWarningKind;
use fitcheck::control::tool_table::{Changed, Tool, ToolTable};
use fitcheck::probing::cycle::{CycleResult, Inputs};
use fitcheck::probing::cycles::cycle;
use fitcheck::probing::{Contact, Recorded};

use super::shared::told;

/// Tools are monitored with a coordinate that is 0.01 mm beyond the middle of its limits, in plus direction.
const SETTINGS: [(&str, &str); 8] = [
    ("Q263", "35"),
    ("Q264", "45"),
    ("Q261", "5"),
    ("Q272", "1"),
    ("Q267", "1"),
    ("Q260", "20"),
    ("Q288", "35.1"),
    ("Q289", "34.9"),
];

/// How many tools of a table are corrected: each is written and read again.
const MOST: usize = 3;

/// The cycle's result for a tool.
fn measured(tool: &str) -> CycleResult {
    static BASE: LazyLock<Inputs> = LazyLock::new(|| {
        let cycle = cycle(427).expect("a cycle");
        SETTINGS.iter().fold(Inputs::new(), |inputs, (name, value)| cycle.set(inputs, name, value).expect("a value"))
    });
    let cycle = cycle(427).expect("a cycle");
    let inputs = cycle.set(BASE.clone(), "Q330", tool).expect("a tool");
    let mut contacts = Recorded::new(vec![Contact { x: 35.01, y: 45.0, z: 5.0 }]);
    cycle.measure(&inputs, &mut contacts).expect("a result")
}

/// The tools as the file of the table has them: without a column TL none is locked in it.
fn kept(table: &ToolTable) -> Vec<Tool> {
    let has_lock = table.warnings().iter().all(|warning| warning.what != TableWarningKind::NoLock);
    let tools = table.tools().iter().cloned();
    tools.map(|tool| Tool { is_locked: tool.is_locked && has_lock, ..tool }).collect()
}

pub fn run(bytes: &[u8]) {
    let mut table = match ToolTable::read(bytes, "a.t") {
        Ok(table) => table,
        Err(error) => return told(bytes, &error),
    };
    for warning in table.warnings() {
        told(bytes, warning);
    }
    assert_eq!(table.write().expect("unchanged"), bytes);
    for (row, tool) in table.tools().to_vec().iter().enumerate().take(MOST) {
        assert_eq!(table.row_of(tool.number), Some(row));
        let number = tool.number.to_string();
        match table.monitor(cycle(427).expect("a cycle"), &measured(&number)) {
            Ok(None) => assert_eq!(number, "0"),
            Ok(Some(monitored)) => {
                let change = monitored.change.expect("a deviation");
                told(bytes, &change);
                match change.what {
                    Changed::Delta { to, .. } => assert_eq!(table.tools()[row].delta_radius, to),
                    Changed::Locked(broken) => {
                        told(bytes, &broken);
                        assert!(table.tools()[row].is_locked);
                    }
                }
            }
            Err(error) => {
                told(bytes, &error);
                assert_eq!(table.tools()[row], *tool);
            }
        }
        match table.write() {
            Ok(written) => assert_eq!(kept(&ToolTable::read(&written, "a.t").expect("a table")), kept(&table)),
            Err(error) => told(bytes, &error),
        }
    }
}
