//! Sizes that are neither hole nor shaft: a distance, a depth, a radius, a form. Within their limits they are good; beyond them they are out
//! of limits, and whether that is rework or scrap is open.

use std::process::Command;

/// A folder with files, and the program run in it.
struct Desk(tempfile::TempDir);

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn put(&self, name: &str, text: &str) {
        fitcheck::files::write(&self.0.path().join(name), text.as_bytes()).unwrap();
    }

    /// The exit code, and what was printed.
    fn run(&self, arguments: &[&str]) -> (i32, String) {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("fitcheck"));
        let output = command.current_dir(self.0.path()).args(arguments).output().unwrap();
        let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        (output.status.code().unwrap(), said.concat())
    }
}

const ROWS: &str = "name;callout;measured\nA1;12 ±0.02;12.01\nA2;12 ±0.02;12.037\nA3;8 +0.1 0;7.99\n";

#[test]
fn every_way_judges_what_is_neither_hole_nor_shaft_alike() {
    let desk = Desk::new();
    desk.put("pm.csv", ROWS);
    for way in [&["import", "pm.csv", "--format", "csv"][..], &["batch", "pm.csv"]] {
        let (code, said) = desk.run(way);
        assert_eq!(code, 13, "{way:?}: {said}");
        let status = |name: &str| {
            let row = said.lines().find(|line| line.contains(name)).unwrap_or_default();
            ["OUT OF LIMITS", "GOOD", "REWORK", "SCRAP"].into_iter().find(|word| row.contains(word)).unwrap_or("none")
        };
        assert_eq!(["A1", "A2", "A3"].map(status), ["GOOD", "OUT OF LIMITS", "OUT OF LIMITS"], "{way:?}: {said}");
    }
    let (code, said) = desk.run(&["report", "pm.csv", "-o", "-", "--format", "json"]);
    assert_eq!(code, 13, "{said}");
    assert_eq!(said.matches("\"status\": \"OUT OF LIMITS\"").count(), 2, "{said}");
    assert_eq!(said.matches("\"feature\": null").count(), 3, "{said}");
    // One limit exceeded is named with how far.
    let (code, said) = desk.run(&["check", "12 ±0.02", "--measured", "12.037"]);
    assert_eq!(code, 13, "{said}");
    assert!(said.contains("17 µm above maximum"), "{said}");
}

#[test]
fn scrap_is_worse_than_out_of_limits_and_that_is_worse_than_rework() {
    let desk = Desk::new();
    let code = |more: &str| {
        desk.put("rows.csv", &format!("{ROWS}{more}"));
        desk.run(&["batch", "rows.csv"]).0
    };
    assert_eq!(code("B;25 H7;24.99\n"), 13, "rework");
    assert_eq!(code("B;25 H7;25.03\n"), 11, "scrap");
}

const PLAN: &str = "fitcheck_plan = 1\npart = \"Plate\"\n\
    [[feature]]\nname = \"BORE\"\ncallout = \"25 H7\"\n\
    [[feature]]\nname = \"STEP\"\nkind = \"depth\"\ncallout = \"8 ±0.05\"\n\
    [[feature]]\nname = \"R\"\nkind = \"radius\"\ncallout = \"5 +0.1 0\"\n\
    [[feature]]\nname = \"TOP\"\nkind = \"flatness\"\ncallout = \"0.02\"\n";

#[test]
fn a_plan_asks_for_distances_and_forms_and_its_report_judges_them() {
    let desk = Desk::new();
    desk.put("plate.toml", PLAN);
    let (code, said) = desk.run(&["plan", "check", "plate.toml", "--format", "json"]);
    assert_eq!(code, 0, "{said}");
    assert!(said.contains("\"length\"") && said.contains("\"form\""), "{said}");
    desk.put("values.csv", "serial;name;measured\n1;BORE;25.012\n1;STEP;8.01\n1;R;5.2\n1;TOP;0.02\n");
    let (code, said) = desk.run(&["import", "values.csv", "--plan", "plate.toml"]);
    assert_eq!(code, 13, "{said}");
    let row = |name: &str| said.lines().find(|line| line.contains(name)).unwrap_or_default().to_owned();
    assert!(row("STEP").contains("GOOD") && row("TOP").contains("GOOD") && row("BORE").contains("GOOD"), "{said}");
    assert!(row("R  ").contains("OUT OF LIMITS"), "{said}");
    desk.put("values.csv", "serial;name;measured\n1;BORE;25.012\n1;STEP;8.01\n1;R;5.05\n1;TOP;0.021\n");
    let (code, said) = desk.run(&["report", "values.csv", "--plan", "plate.toml", "-o", "-", "--format", "markdown"]);
    assert_eq!(code, 13, "{said}");
    assert!(said.contains("OUT OF LIMITS"), "{said}");
}

#[test]
fn what_no_cycle_measures_has_no_cycle_and_is_in_no_set() {
    let desk = Desk::new();
    desk.put("plate.toml", &PLAN.replace("callout = \"25 H7\"", "callout = \"25 H7\"\nx = 10\ny = 20\nz = -5"));
    let (code, said) = desk.run(&["nc", "plate.toml", "--control", "itnc530", "-o", "set"]);
    assert_eq!(code, 0, "{said}");
    for name in ["STEP", "R", "TOP"] {
        assert!(said.contains(&format!("{name}: no cycle measures a ")), "{said}");
    }
    let faults = |text: &str| {
        desk.put("wrong.toml", text);
        desk.run(&["plan", "check", "wrong.toml"])
    };
    let (code, said) = faults(&PLAN.replace("callout = \"0.02\"", "callout = \"0.02 H7\""));
    assert_eq!(code, 1);
    assert!(said.contains("0.02 H7 is not the limit of a form or location tolerance"), "{said}");
    let (code, said) = faults(&PLAN.replace("callout = \"0.02\"", "callout = \"0.02\"\ncycle = \"421\""));
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("cycle"), "{said}");
}
