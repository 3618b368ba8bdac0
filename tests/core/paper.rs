//! Decision rules, uncertainty and temperature on reports and in imports: from files to pages, columns and exit codes.

use std::path::Path;

use assert_cmd::Command;
use fitcheck::budget::{Provenance, Validity};
use fitcheck::journal::Record;
use fitcheck::probing::measurement::measure_contacts;
use fitcheck::probing::{Contact, Measurement, Origin};
use fitcheck::report::{RENDERINGS, Report};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::rules::{Prover, RuleInputs, RuleName, Uncertainty};
use fitcheck::verdict::{Rule, Status, Undecided};
use fitcheck::words::{Language, Words};
use jiff::civil::date;
use serde_json::Value;

/// 0.5 µm for the ring and 0.5 K of steel, U-shaped: 0.51 µm at 25 mm.
const BUDGET: &str = "name = 'Station 3'\ndate = 2026-01-15\nby = 'J. Jansen'\nvalid_until = 2026-06-30\n\
    [[contribution]]\nname = 'Ring'\ntype = 'B'\nlaw = 'normal'\nexpanded_um = 1.0\nk = 2\n\
    [[contribution]]\nname = 'Part'\ntype = 'B'\nlaw = 'u-shaped'\nkind = 'part-temperature'\nhalf_width_k = 0.5\n\
    alpha_per_k = 11.5e-6\n";

const SCATTER: &str = "name = 'Station 3'\ndate = 2026-01-15\nby = 'J. Jansen'\nvalid_until = 2026-06-30\n\
    [[contribution]]\nname = 'Touch'\nkind = 'scatter'\ntype = 'A'\nlaw = 'normal'\nstandard_um = 0.3\n";

const ROWS: &str = "callout;measured\n25 H7;25.0195\n10 g6;9.991\n100 H7;100.04\n";

#[expect(clippy::disallowed_methods, reason = "a test folder needs no careful writing")]
fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

/// A folder with budgets and measurements.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| write(folder.path(), name, text);
    write("b.toml", BUDGET);
    write("scatter.toml", SCATTER);
    write("rows.csv", ROWS);
    write("bad.csv", "callout;measured\n25 H7;x\n25 H7;25.012\n");
    folder
}

/// Exit code, standard output, standard error.
fn run(folder: &Path, line: &str) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck"))
        .args(line.split(' ').map(|word| word.replace('_', " ")))
        .current_dir(folder)
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn page(line: &str) -> String {
    let folder = folder();
    let (_, page, said) = run(folder.path(), &format!("report {line} -o - --format html --time 2026-03-01T10:00"));
    assert!(!page.is_empty(), "{said}");
    page
}

#[track_caller]
fn has(page: &str, texts: &[&str]) {
    for text in texts {
        assert!(page.contains(text), "{text} is missing in {page}");
    }
}

fn entry(label: &str, value: &str) -> String {
    format!("<tr><th scope=\"row\">{label}</th><td>{value}</td></tr>")
}

#[test]
fn a_check_by_a_rule_says_zone_proof_and_probability() {
    let proven = page("--check 25_H7=25.012 --rule iso14253-2017 --u 1.2");
    has(
        &proven,
        &[
            "the supplier proves conformity; u = 1.2 µm, U = 2.4 µm (k = 2)",
            &entry("Accepted values", "25.001974 to 25.019026 mm"),
            &entry("Proof", "proven by this rule; conforms with a probability of 100.00 %"),
        ],
    );
    let undecided = page("--check 25_H7=25.0195 --rule iso14253-2017 --u 1.2");
    has(
        &undecided,
        &["RE-MEASURE", "not proven by this rule; conforms with a probability of 89.44 %", "lies in a guard band"],
    );
    let nothing = page("--check 25_H7=25.01 --rule iso14253-1998 --u 6");
    has(&nothing, &[&entry("Accepted values", "none: the rule leaves no part of this tolerance")]);
    // The uncertainty is said where the rule's own sentence does not have it.
    let fixed = page("--check 25_H7=25.012 --rule fixed --guard 2 --u 1.2");
    has(&fixed, &["guard band 2 µm, the supplier proves conformity; u = 1.2 µm"]);
    let plain = page("--check 25_H7=25.012");
    assert!(!plain.contains("Accepted values") && !plain.contains("hatch guard"), "{plain}");
}

#[test]
fn the_picture_has_the_guard_bands_with_their_meaning() {
    let both = page("--check 25_H7=25.012 --rule ilac-g8 --u 1.2");
    assert_eq!(both.matches("class=\"hatch guard undecided\"").count(), 3, "two bands and the legend");
    has(&both, &["guard band: re-measure, −2.4 to +2.4 µm; guard band: re-measure, +18.6 to +23.4 µm", ">25.021 mm<"]);
    has(&both, &[">guard band: re-measure</text>", ">25.000 mm<", ".band .hatch.guard"]);
    let beyond = page("--check 25_H7=25.012 --rule asme-relaxed --u 1.2");
    assert_eq!(beyond.matches("class=\"hatch guard beyond\"").count(), 3);
    has(&beyond, &["guard band: accepted beyond the limit, −2.4 to 0 µm", ">good</text>"]);
    // Where nothing is accepted, no part of the zone is called good.
    let nothing = page("--check 25_H7=25.012 --rule ilac-g8 --u 6");
    assert!(!nothing.contains(">good</text>"), "{nothing}");
    assert!(!nothing.contains("NaN") && !nothing.contains("inf\""), "{nothing}");
    // A rule without guard bands has no legend.
    assert!(!page("--check 25_H7=25.012 --rule simple --u 1.2").contains("hatch guard\u{20}"));
}

#[test]
fn the_head_says_once_what_all_checks_share() {
    let head = |line: &str| page(line).split("</dl>").next().unwrap().to_owned();
    let two = "--check 25_H7=25.012 --check 10_g6=9.991";
    has(&head(&format!("{two} --rule ilac-g8 --u 1.2")), &["ILAC-G8, guard band 1 U", "u = 1.2 µm"]);
    let by_budget = head(&format!("{two} --rule ilac-g8 --budget b.toml"));
    has(
        &by_budget,
        &["ILAC-G8, guard band 1 U", "u of each value beside its check", "Station 3, created 2026-01-15 by J. Jansen"],
    );
    assert!(!head(two).contains("Decision rule"));
    let warm = head(&format!("{two} --temperature 26 --material 11.5"));
    has(&warm, &["measured at 26 °C, expansion 11.5 · 10⁻⁶/K; every value is corrected to 20 °C"]);
}

#[test]
fn a_report_by_a_budget_has_an_uncertainty_for_each_size() {
    let folder = folder();
    let line = "report rows.csv --rule iso14253-2017 --budget b.toml -o - --format json --time 2026-03-01T10:00";
    let (code, json, said) = run(folder.path(), line);
    assert_eq!(code, Some(11), "{said}");
    let report: Value = serde_json::from_str(&json).unwrap();
    let of =
        |name: &str| report["checks"].as_array().unwrap().iter().map(|check| check[name].clone()).collect::<Vec<_>>();
    // √(0.5² + (D · 11.5e-6 · 0.5 / √2)²), rounded up to the picometre.
    let u = |mm: f64| 0.5_f64.hypot(mm * 1e3 * 11.5e-6 * 0.5 / 2_f64.sqrt());
    for (found, mm) in of("u_um").iter().zip([25.0195, 9.991, 100.04]) {
        assert!((found.as_f64().unwrap() - u(mm)).abs() < 1.1e-6, "{found} at {mm}");
    }
    assert_eq!(of("budget"), ["Station 3"; 3]);
    assert_eq!(of("budget_validity"), ["valid"; 3]);
    assert_eq!((&of("budget_date")[0], &of("budget_valid_until")[0]), (&"2026-01-15".into(), &"2026-06-30".into()));
    // As check has it for the same value.
    let check = "check 25_H7 --measured 25.0195 --rule iso14253-2017 --budget b.toml --format json";
    let check: Value = serde_json::from_str(&run(folder.path(), check).1).unwrap();
    assert_eq!(check["u_um"], of("u_um")[0]);
    assert!(check["budget"].is_object() && check.get("budget_date").is_none(), "{check}");
}

#[test]
fn an_expired_budget_is_said_in_words_for_each_day() {
    let folder = folder();
    let of = |time: &str| {
        let line = format!(
            "report --check 25_H7=25.012 --rule ilac-g8 --budget b.toml -o - --format html --time {time}T10:00"
        );
        let (_, page, said) = run(folder.path(), &line);
        (page, said)
    };
    let (valid, said) = of("2026-06-30");
    has(&valid, &["Station 3, created 2026-01-15 by J. Jansen, valid until 2026-06-30</td>"]);
    assert!(!said.contains("warning"), "{said}");
    let (expired, said) = of("2026-07-01");
    has(&expired, &["valid until 2026-06-30; EXPIRED on the day of the check"]);
    assert_eq!(said.matches("the budget has expired").count(), 1, "{said}");
    has(&of("2026-01-14").0, &["NOT YET VALID on the day of the check"]);
}

#[test]
fn a_budget_with_entries_of_the_template_is_told_and_ends_with_14() {
    let folder = folder();
    let text = fitcheck::budget::template::text(date(2026, 1, 1), date(2026, 12, 31));
    let own = text.replace("Station 1, probe 1", "Station 9").replace("Who made it", "J. Jansen");
    let own = own.replace("standard_um = 0.5", "standard_um = 0.4");
    for (text, expected) in [(text, 14), (own, 0)] {
        write(folder.path(), "new.toml", &text);
        let line =
            "report --check 25_H7=25.012 --rule ilac-g8 --budget new.toml -o - --format json --time 2026-03-01T10:00";
        let (code, out, said) = run(folder.path(), line);
        assert_eq!((code, said.contains("entries from the template")), (Some(expected), expected == 14), "{out}{said}");
    }
}

#[test]
fn a_budget_that_needs_contacts_refuses_values_without_them() {
    let folder = folder();
    let line = "report rows.csv --rule ilac-g8 --budget scatter.toml -o r.html --time 2026-03-01T10:00";
    let (code, _, said) = run(folder.path(), line);
    assert_eq!(code, Some(1), "{said}");
    assert_eq!(said.matches("Touch depends on the contacts").count(), 3, "{said}");
    let (code, csv, _) = run(folder.path(), "import rows.csv --rule ilac-g8 --budget scatter.toml --format csv");
    assert_eq!((code, csv.matches("Touch depends on the contacts").count()), (Some(1), 3), "{csv}");
    for other in ["--u 1", "--expanded 2", "--expanded 2 --k 2"] {
        for subcommand in ["report", "import"] {
            let line = format!("{subcommand} rows.csv --budget b.toml {other}");
            assert_eq!(run(folder.path(), &line).0, Some(2), "{line}");
        }
    }
}

#[test]
fn every_value_of_a_report_is_brought_to_20_degrees() {
    // 25.0195 (1 − 11.5e-6 · 6 + 10e-6 · 4) = 25.0195 − 0.0007255655
    let warm = "--temperature 26 --material 11.5 --scale-temperature 24 --scale-material 10";
    let one = page(&format!("--check 25_H7=25.0195 {warm}"));
    has(
        &one,
        &[&entry(
            "Temperature",
            "measured 25.019500 mm at 26 °C, expansion 11.5 · 10⁻⁶/K: corrected by −0.726 µm to 25.018774 mm at 20 °C; \
             scales at 24 °C, 10 · 10⁻⁶/K",
        )],
    );
    let dutch = page("--check 25_H7=25.0195 --temperature 26 --material 11,5 --language nl");
    has(&dutch, &["zonder correctie van de meetlinialen", "gecorrigeerd met −1,726 µm tot 25,017774 mm bij 20 °C"]);
    // What is good as it was measured may be rework at 20 °C.
    let folder = folder();
    let (code, csv, _) =
        run(folder.path(), "report --check 25_H7=25.001 --temperature 26 --material 11.5 -o - --format csv");
    assert_eq!(code, Some(10));
    has(&csv, &["as_measured_mm,correction_um,temperature_c", ",24.999275,", ",REWORK,", ",25.001,-1.725,26,11.5,,"]);
}

#[test]
fn an_import_judges_by_the_rule_and_has_its_columns() {
    let folder = folder();
    let (code, csv, said) = run(folder.path(), "import rows.csv --rule iso14253-2017 --u 1.2 --format csv");
    assert_eq!(code, Some(11), "{said}");
    let lines: Vec<&str> = csv.lines().collect();
    assert!(
        lines[0].ends_with(",scale_expansion_um_per_m_k,rule_name,u_um,k,zone_min_mm,zone_max_mm,conformity,proven"),
        "{csv}"
    );
    assert!(
        lines[1].contains(",RE-MEASURE,") && lines[1].contains(",iso14253-2017,1.2,2,25.001974,25.019026,"),
        "{csv}"
    );
    assert!(said.contains("rule: ISO 14253-1:2017"), "{said}");
    let (_, json, _) = run(folder.path(), "import rows.csv --rule iso14253-2017 --budget b.toml --format json");
    let rows: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&rows[0]["budget"], &rows[0]["proven"]), (&"Station 3".into(), &true.into()), "{json}");
    let (_, text, said) = run(folder.path(), "import rows.csv --temperature 26 --material steel");
    has(&text, &["25.017774"]);
    assert!(said.contains("every measured value is corrected from 26 °C to 20 °C (steel"), "{said}");
    // A row that cannot be used has no cells there.
    let (code, csv, _) = run(folder.path(), "import bad.csv --rule ilac-g8 --u 1 --format csv");
    assert_eq!(code, Some(1));
    assert!(csv.lines().nth(1).unwrap().ends_with("x is not a number,,,,,,,,,,,,,,"), "{csv}");
    let (_, plain, _) = run(folder.path(), "import rows.csv --format csv");
    assert!(plain.lines().next().unwrap().ends_with(",error,simulated,as_measured_mm,correction_um,temperature_c,expansion_um_per_m_k,scale_temperature_c,scale_expansion_um_per_m_k"), "{plain}");
}

#[test]
fn a_wrong_rule_is_refused_before_a_file_is_read() {
    let folder = folder();
    for subcommand in ["import none.csv", "report none.csv -o r.html"] {
        for options in ["--rule ilac-g8", "--rule fixed --budget b.toml"] {
            let (code, _, said) = run(folder.path(), &format!("{subcommand} {options}"));
            assert_eq!(code, Some(1), "{said}");
            assert!(said.contains("--rule") && !said.contains("none.csv"), "{said}");
        }
    }
}

/// A record of a 25 H7 with these contacts, at equal steps on a circle of 25.012 mm.
fn touched(contacts: u32, step_deg: f64) -> Record {
    let limits = Sources::default().limits(&"25 H7".parse().unwrap(), None).unwrap();
    let contact = |number: u32| {
        let (sin, cos) = (f64::from(number) * step_deg).to_radians().sin_cos();
        // As a file of nanometres has them.
        let nm = |mm: f64| (mm * 1e6).round() / 1e6;
        Contact { x: nm(12.506 * cos), y: nm(12.506 * sin), z: 0.0 }
    };
    let contacts: Vec<Contact> = (0..contacts).map(contact).collect();
    let measurement = measure_contacts(&contacts, Origin::Contacts { file: "c.csv".into() }).unwrap();
    let measurement = Measurement { diameter: "25.012".parse().unwrap(), ..measurement };
    Record::judged(date(2026, 3, 1).at(10, 0, 0, 0), String::new(), "25 H7".parse().ok(), limits, measurement, None)
}

fn by(name: RuleName) -> Rule {
    let uncertainty = Uncertainty::standard("0.5").ok();
    let width = name.takes_width().then(|| "0.001".parse().unwrap());
    Rule::new(name, RuleInputs { uncertainty, factor: None, width, prover: Prover::Supplier }).unwrap()
}

#[test]
fn a_given_uncertainty_counts_up_to_three_times_the_full_circle() {
    let status = |contacts, step| touched(contacts, step).by(by(RuleName::Iso14253Of2017)).verdict.status();
    // u(D)/s against that of as many contacts round the circle (facts of the geometry factors): 1.00, 1.76, 3.00, 5.91, 2.61, 6.54, 2.36.
    for (contacts, step, wanted) in [
        (3, 120.0, Status::Good),
        (3, 75.0, Status::Good),
        (3, 60.02, Status::Good),
        (3, 60.0, Status::Good),
        (3, 59.98, Status::ReMeasure),
        (3, 45.0, Status::ReMeasure),
        (4, 45.0, Status::Good),
        (4, 30.0, Status::ReMeasure),
        (8, 22.5, Status::Good),
    ] {
        assert_eq!(status(contacts, step), wanted, "{contacts} x {step}");
    }
    let undecided = touched(3, 45.0).by(by(RuleName::Iso14253Of2017));
    let Some(Undecided::Contacts { contacts: 3, times }) = undecided.verdict.undecided else { panic!("{undecided:?}") };
    assert!((5_910..=5_915).contains(&times), "{times}");
    let decision = undecided.decision().unwrap();
    assert_eq!((decision.proven, decision.conformity), (Some(false), None));
}

#[test]
fn contacts_decide_nothing_alone_by_the_limits_or_by_a_budget() {
    let status = |record: Record| record.verdict.status();
    for name in RuleName::ALL {
        let wanted = if name == RuleName::Simple { Status::Good } else { Status::ReMeasure };
        assert_eq!(status(touched(3, 45.0).by(by(name))), wanted, "{name:?}");
    }
    assert_eq!(touched(3, 45.0).by(Rule::SIMPLE), touched(3, 45.0));
    let budget = Provenance {
        name: "S".to_owned(),
        date: date(2026, 1, 15),
        by: "J".to_owned(),
        valid_until: date(2027, 1, 15),
        counts_contacts: true,
        validity: Validity::Valid,
        warnings: Vec::new(),
    };
    assert_eq!(status(touched(3, 45.0).by_budget(by(RuleName::IlacG8), budget.into())), Status::Good);
}

#[test]
fn the_reason_is_said_in_text_json_csv_and_report() {
    let folder = folder();
    let contacts = touched(3, 45.0).measurement.contacts;
    let lines: Vec<String> = contacts.iter().map(|contact| format!("{};{}", contact.x, contact.y)).collect();
    write(folder.path(), "arc.csv", &format!("x;y\n{}\n", lines.join("\n")));
    let check = |options: &str| run(folder.path(), &format!("check 25_H7 --contacts arc.csv --rule ilac-g8 {options}"));
    let reason = "the 3 contacts make the diameter 5.914 times less certain than 3 contacts around the full circle";
    let (code, text, said) = check("--u 0.5");
    assert_eq!((code, text.contains("RE-MEASURE")), (Some(12), true), "{text}{said}");
    has(&said, &[reason, "not proven by this rule"]);
    assert!(!said.contains("probability"), "{said}");
    let (_, json, _) = check("--u 0.5 --format json");
    let json: Value = serde_json::from_str(&json).unwrap();
    assert!(json["remeasure_reason"].as_str().unwrap().starts_with(reason), "{json}");
    assert_eq!((&json["proven"], json.get("conformity")), (&false.into(), None));
    let (_, csv, _) = check("--u 0.5 --format csv");
    assert!(csv.lines().next().unwrap().ends_with(",proven,remeasure_reason"), "{csv}");
    // Typed values and the plain rule have no such column.
    let (_, csv, _) = run(folder.path(), "check 25_H7 --contacts arc.csv --format csv");
    assert!(!csv.contains("remeasure_reason"), "{csv}");

    let html = RENDERINGS.iter().find(|rendering| rendering.name == "html").unwrap();
    let record = touched(3, 45.0).by(by(RuleName::IlacG8));
    let report = Report::new(date(2026, 3, 1).at(10, 0, 0, 0), vec![record]);
    let page = String::from_utf8(html.bytes(&report, &Words::new(Language::En)).unwrap()).unwrap();
    has(&page, &[reason, "RE-MEASURE"]);
    assert!(!page.contains("lies in a guard band"), "{page}");
}

/// A file of Fitcheck that is read again is no better than it was: what was decided by more than the size is refused.
#[test]
fn a_file_of_fitcheck_read_again_is_no_better_than_it_was() {
    let folder = folder();
    let path = folder.path().join("again.csv");
    let file = |rows: &str| {
        let head = "id,callout,measured_mm,deviation_um,status,position,rule_name,remeasure_reason";
        fitcheck::files::write(&path, format!("{head}\n{rows}\n").as_bytes()).unwrap();
    };
    let run = |command: &str, more: &[&str]| {
        let mut arguments = vec![command, path.to_str().unwrap()];
        arguments.extend(more);
        let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(&arguments).output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (text(&output.stdout), text(&output.stderr), output.status.code())
    };
    file("A1,25 H7,25.012,12,GOOD,not monitored,simple,");
    let (_, told, code) = run("import", &[]);
    assert_eq!(code, Some(0), "{told}");
    assert!(told.contains("may come from another decision rule (column rule_name)"), "{told}");
    for (row, reason) in [
        ("A1,25 H7,25.012,12,SCRAP,OUT,simple,", "the centre was out of position, but the file has only the size"),
        ("A1,25 H7,25.012,12,RE-MEASURE,,fixed,3 contacts", "nothing was decided here: 3 contacts"),
    ] {
        file(row);
        for (command, more) in [("import", vec![]), ("batch", vec!["--prefix", "x_"])] {
            let (out, told, code) = run(command, &more);
            assert_eq!(code, Some(1), "{command} {told}");
            assert!(format!("{out}{told}").contains(reason), "{command} {out} {told}");
        }
    }
    // A database may have changed the case of names.
    file("A1,25 H7,25.012,12,SCRAP,OUT,simple,");
    let text = std::fs::read_to_string(&path).unwrap();
    let (head, rows) = text.split_once('\n').unwrap();
    fitcheck::files::write(&path, format!("{}\n{rows}", head.to_uppercase()).as_bytes()).unwrap();
    assert_eq!(run("import", &[]).2, Some(1));
}

/// What a budget is about, and what it is used for.
#[test]
fn a_budget_for_another_piece_temperature_or_arc_is_told() {
    let folder = folder();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fitcheck::files::write(&path, text.as_bytes()).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let head = "name = \"S\"\ndate = 2026-01-15\nby = \"J\"\nvalid_until = 2999-01-14\n";
    let ring = file(
        "ring.toml",
        &format!(
            "{head}[calibrated]\nx_cal_mm = 30.0\nexpanded_um = 0.6\nk = 2\nu_b_um = 0.1\nu_w_um = 0.3\nfeature = \"hole\"\n\
             readings_mm = [30.0021, 30.0024, 30.0022]\n"
        ),
    );
    let warm = file(
        "warm.toml",
        &format!(
            "{head}[[contribution]]\nname = \"Expansion\"\nkind = \"part-expansion\"\ntype = \"B\"\nlaw = \"rectangular\"\n\
             half_width_per_k = 1e-6\ndelta_k = 1.0\n\
             [[contribution]]\nname = \"Temperature\"\nkind = \"part-temperature\"\ntype = \"B\"\nlaw = \"normal\"\n\
             standard_k = 0.1\nalpha_per_k = 11.5e-6\n"
        ),
    );
    let arc = file("arc.csv", "x,y\n12.505,0\n12.41179,1.523976\n12.133548,3.025233\n");
    let check = |arguments: &[&str]| {
        let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck"))
            .arg("check")
            .args(arguments)
            .args(["--rule", "iso14253-2017"])
            .output()
            .unwrap();
        (String::from_utf8_lossy(&output.stderr).into_owned(), output.status.code())
    };
    let (told, _) = check(&["300 h7", "--measured", "299.99", "--budget", &ring]);
    assert!(told.contains("the calibrated piece of the budget has 30 mm, but 299.99 mm were measured"), "{told}");
    assert!(told.contains("the calibrated piece of the budget is a hole, but a shaft was measured"), "{told}");
    // 25 mm more belongs to a piece of 30 mm, a nanometre beyond does not.
    for (measured, is_told) in [("55", false), ("55.000001", true), ("5", false), ("4.999999", true)] {
        let callout = if measured.starts_with('5') && 1 < measured.len() { "55 H12" } else { "5 H12" };
        let (told, _) = check(&[callout, "--measured", measured, "--budget", &ring]);
        assert_eq!(told.contains("were measured"), is_told, "{measured} {told}");
    }
    let temperature =
        ["100 H7", "--measured", "100.01", "--budget", &warm, "--temperature", "40", "--material", "23.1"];
    let (told, _) = check(&temperature);
    assert!(
        told.contains(
            "Expansion of the budget is for a temperature 1 K from 20 °C, but the value was corrected for 20 K"
        ),
        "{told}"
    );
    assert!(
        told.contains(
            "Temperature of the budget has the expansion 11.5 · 10⁻⁶/K, but the value was corrected with 23.1"
        ),
        "{told}"
    );
    // A budget without a scatter of touches says nothing of the contacts.
    let (told, code) = check(&["25 H7", "--contacts", &arc, "--budget", &ring]);
    assert_eq!(code, Some(12), "{told}");
}

/// A centre out of position is scrap whatever the size says, and nothing about it is proven by the size.
#[test]
fn a_size_proves_nothing_of_a_centre_out_of_position() {
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/en/TCHPR421.TXT");
    let now = date(2026, 11, 21).at(0, 0, 0, 0);
    let read = fitcheck::exchange::import("TCHPR421.TXT", &std::fs::read(log).unwrap(), &Sources::default(), now);
    let mut record = read.records[0].clone();
    let given = RuleInputs { uncertainty: Some(Uncertainty::standard("1.2").unwrap()), ..RuleInputs::default() };
    let rule = Rule::new(RuleName::Iso14253Of2017, given).unwrap();
    let position = record.verdict.position.as_mut().unwrap();
    for (off, is_scrap) in [("0.001", false), ("1", true)] {
        for axis in &mut position.axes {
            axis.deviation = off.parse().unwrap();
            axis.tolerance = Some("0.05".parse().unwrap());
        }
        let judged = Record {
            verdict: fitcheck::verdict::Verdict { position: Some(*position), ..read.records[0].verdict },
            ..read.records[0].clone()
        };
        let judged = judged.by(rule);
        let decision = judged.decision().unwrap();
        assert_eq!(judged.verdict.status() == Status::Scrap, is_scrap);
        assert_eq!((decision.proven.is_none(), decision.conformity.is_none()), (is_scrap, is_scrap), "{judged:?}");
    }
}

/// An uncertainty that does not count for these contacts says nothing of their conformity, by the limits alone either.
#[test]
fn a_short_arc_has_no_conformity_by_the_limits_either() {
    let folder = folder();
    let path = folder.path().join("arc.csv");
    fitcheck::files::write(&path, b"x,y\n12.505,0\n12.41179,1.523976\n12.133548,3.025233\n").unwrap();
    let arguments = ["check", "25 H7", "--contacts", path.to_str().unwrap(), "--u", "1.2", "--format", "json"];
    let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&found["conformity"], &found["rule_name"]), (&Value::Null, &Value::from("simple")), "{found}");
}
