//! Touch-probe tables: the built-in one, and what is read and refused.

use fitcheck::control::probe_table::ProbeTable;
use fitcheck::nc::machine::Shipped;
use fitcheck::probing::TouchProbe;

#[track_caller]
fn check(rows: &str, expected: &str) {
    let bytes = format!("BEGIN TCHPROBE.TP MM\nNO   CAL_OF1   F       DIST      SET_UP\n{rows}[END]\n");
    let said = match ProbeTable::read(bytes.as_bytes(), "tchprobe.tp") {
        Ok(table) => {
            let row = |p: &TouchProbe| format!("{} {} {}", p.number, p.longest_path, p.set_up);
            table.probes.iter().map(row).collect::<Vec<_>>().join("; ")
        }
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected);
}

#[test]
fn the_shipped_table_is_the_default_probe() {
    assert_eq!(
        ProbeTable::read(Shipped::file("tchprobe.tp").unwrap(), "tchprobe.tp").unwrap().probes,
        [TouchProbe::default()]
    );
    assert_eq!(ProbeTable::shipped().probe(None), Some(&TouchProbe::default()));
}

#[test]
fn rows_are_probes_and_what_cannot_be_is_refused_with_its_place() {
    check("1    +0.0042   100     10        2\n2                      6         1,5\n", "1 10 2; 2 6 1.5");
    check("", "the table has no probe: tchprobe.tp, line 2, column 1");
    check("1    +0        100     0         2\n", "DIST = 0 mm: it must be above 0: tchprobe.tp, line 3, column 24");
    check(
        "1    +0        100     9         -1\n",
        "SET_UP = -1 mm: it must be 0 or more: tchprobe.tp, line 3, column 34",
    );
    check("1    +0        100     ?         2\n", "DIST: ? is not a number: tchprobe.tp, line 3, column 24");
    check("1    +0        1.5     9         2\n", "F = 1.5: expected a whole number: tchprobe.tp, line 3, column 16");
    check(
        "1    +0        100     9         2\n1    +0        100     9         2\n",
        "probe 1 occurs twice: tchprobe.tp, line 4, column 1",
    );
    let error = ProbeTable::read(b"BEGIN A.TP MM\nNO   DIST\n1    10\n[END]\n", "a.tp").unwrap_err();
    assert_eq!(error.to_string(), "the table has no column SET_UP: a.tp, line 2, column 1");
}
