//! Templates of reports: what a file may say, what the shipped ones show, and what none of them can leave out.

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::report::paper::Paper;
use fitcheck::report::template::{Column, HeadField, Section, Template};
use fitcheck::words::{Language, Words};

const OWN: &str = r#"version = 1
name = "Goods in"
title = "Incoming inspection"
paper = "letter"
language = "de"
sections = ["verdict", "features", "signature"]
head = ["part", "customer"]
columns = ["feature", "measured", "verdict"]
rule-text = "Rule QA-7."

[company]
name = "Northgate"
address = ["Mill shop 2"]
"#;

fn refused(text: &str) -> String {
    Template::read(text).unwrap_err().to_string()
}

#[test]
fn a_template_chooses_sections_columns_head_and_paper() {
    let template = Template::read(OWN).unwrap();
    assert_eq!(template.paper, Paper::Letter);
    assert_eq!(template.language().map(Language::code), Some("de"));
    assert_eq!(template.sections, [Section::Verdict, Section::Features, Section::Signature]);
    assert_eq!(template.head, [HeadField::Part, HeadField::Customer]);
    assert_eq!(template.columns, [Column::Feature, Column::Measured, Column::Verdict]);
    assert_eq!((template.company.name.as_str(), template.rule_text.as_str()), ("Northgate", "Rule QA-7."));
}

#[test]
fn what_a_template_cannot_say_is_named_with_its_place() {
    let wrong = |from: &str, to: &str| refused(&OWN.replace(from, to));
    let unknown = wrong("rule-text", "rule-txt");
    assert!(unknown.starts_with("line 9, column 1: ") && unknown.contains("rule-txt"), "{unknown}");
    let word = wrong("\"signature\"", "\"sign\"");
    assert!(word.starts_with("line 6, column ") && word.contains("`signature`"), "{word}");
    for (from, to, said) in [
        ("version = 1", "version = 2", "template version 2 is not supported: expected version 1"),
        ("\"Goods in\"", "\" \"", "name is empty, is longer than 2000 characters or has a control character"),
        ("[\"part\", \"customer\"]", "[\"part\", \"part\"]", "head lists part twice"),
        ("[\"feature\", \"measured\", \"verdict\"]", "[]", "columns is empty: list at least one"),
        ("\"de\"", "\"xx\"", "xx is not a language of reports: use one of cs, de, en, es, fr, it, nl, pl"),
    ] {
        assert_eq!(wrong(from, to), said);
    }
    let logo = refused(&format!("{OWN}logo = \"../secret.png\"\n"));
    assert_eq!(logo, "the logo ../secret.png must be the name of a file beside the template");
    assert_eq!(refused(&format!("#{}", "x".repeat(70_000))), "a template has at most 65536 bytes");
}

#[test]
fn every_shipped_template_has_its_texts_and_the_usual_one_comes_first() {
    let shipped = Template::shipped();
    let words: Vec<&str> = shipped.iter().map(|template| template.word()).collect();
    assert_eq!(words, ["inspection", "certificate", "first-article", "label", "list", "sheet", "statistics"]);
    assert_eq!(Template::usual().word(), "inspection");
    for template in shipped {
        for language in Language::all() {
            let words = Words::new(language);
            for text in [&template.name, &template.purpose] {
                let said = template.text(text, &words);
                assert!(!said.is_empty() && said != *text, "{} in {}", text, language.code());
            }
        }
    }
}

#[test]
fn a_new_template_has_every_word_with_its_meaning_in_every_language() {
    for language in Language::all() {
        let text = Template::sample(&Words::new(language));
        let template = Template::read(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
        assert_eq!((&template.sections, &template.head), (&Section::usual(), &HeadField::usual()), "{text}");
        assert_eq!(template.columns, Column::usual());
        let sections = Section::ALL.iter().map(|section| section.word());
        let words = sections.chain(HeadField::ALL.iter().map(|field| field.word()));
        for word in words.chain(Column::ALL.iter().map(|column| column.word())) {
            assert!(text.contains(&format!("\"{word}\",")), "{word} in {}", language.code());
        }
        assert!(!text.contains("report-"), "{text}");
        // What is only a comment can be taken in as it stands.
        let all = text.replace("    # \"", "    \"");
        assert_eq!(Template::read(&all).unwrap().columns.len(), Column::ALL.len());
    }
}

#[test]
fn a_label_becomes_a_picture_and_a_page_does_not() {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("label.png");
    let run = |template: &str| {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.args(["report", "--check", "25 H7=25.012", "--template", template, "-o"]).arg(&png);
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, said) = run("certificate");
    assert_eq!((code, png.exists()), (Some(1), false), "{said}");
    assert!(said.contains("PNG is for labels: choose the template label, or the paper small-label"), "{said}");
    let (code, said) = run("label");
    assert_eq!((code, png.exists()), (Some(0), true), "{said}");
}

#[test]
fn a_row_that_was_refused_keeps_a_certificate_from_stating_conformity() {
    let folder = tempfile::tempdir().unwrap();
    let [csv, page] = ["rows.csv", "page.md"].map(|name| folder.path().join(name));
    let certificate = |rows: &str| {
        fitcheck::files::write(&csv, format!("callout;measured\n{rows}").as_bytes()).unwrap();
        let mut command = cargo_bin_cmd!("fitcheck");
        command.arg("report").arg(&csv).args(["--template", "certificate", "-o"]).arg(&page).output().unwrap();
        std::fs::read_to_string(&page).unwrap()
    };
    let whole = certificate("25 H7;25.012\n25 H7;25.003\n");
    assert!(whole.contains("Statement of conformity: all 2 values"), "{whole}");
    for row in ["25 H7;25.0l2", "no callout;25.012"] {
        let partial = certificate(&format!("25 H7;25.012\n{row}\n"));
        assert!(partial.contains("No statement of conformity: some rows were refused"), "{partial}");
        assert!(!partial.contains("Statement of conformity: all"), "{partial}");
    }
}

#[test]
fn a_report_says_what_changed_since_an_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let run = |checks: &[&str], since: Option<&str>, name: &str| {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.args(["report", "--time", "2026-11-28T10:00", "-o"]).arg(path(name));
        for check in checks {
            command.args(["--check", *check]);
        }
        if let Some(file) = since {
            command.arg("--since").arg(path(file));
        }
        let output = command.output().unwrap();
        let page = std::fs::read_to_string(path(name)).unwrap_or_default();
        (page, String::from_utf8_lossy(&output.stderr).into_owned())
    };
    run(&["A: 25 H7=24.998", "B: 10 g6=9.991", "C: 40 H7=40.01", "D: 8 H9=8.01"], None, "before.json");
    let now = ["A: 25 H7=25.012", "B: 10 h6=9.995", "D: 8 H9=8.012", "E: 6 H7=6.004"];
    let (page, said) = run(&now, Some("before.json"), "now.md");
    for line in [
        "## Changed since the report of 2026-11-28 10:00:00:",
        "A: REWORK → GOOD",
        "B: limits 9.986 to 9.995 → 9.991 to 10 mm",
        "E: new",
        "C: no longer in the report",
    ] {
        assert!(page.replace('\\', "").contains(line), "{line}: {said}{page}");
    }
    assert!(!page.contains("- D: "), "{page}");
    let (page, _) =
        run(&["A: 25 H7=24.998", "B: 10 g6=9.991", "C: 40 H7=40.01", "D: 8 H9=8.01"], Some("before.json"), "same.html");
    assert!(page.contains("<li>no result and no limit</li>"), "{page}");
    let (page, said) = run(&now, Some("now.md"), "other.md");
    assert!(page.is_empty() && said.contains("now.md: not a report of Fitcheck with its data"), "{said}");
    // The PDF that somebody signed has the same data.
    run(&["A: 25 H7=24.998"], None, "signed.pdf");
    let (page, said) = run(&["A: 25 H7=25.012"], Some("signed.pdf"), "since.md");
    assert!(page.contains("- A: REWORK → GOOD"), "{said}{page}");
}

#[test]
fn a_template_of_a_file_is_used_and_a_wrong_one_is_named_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let [own, pdf] = ["own.toml", "report.pdf"].map(|name| folder.path().join(name));
    let run = |text: &str| {
        std::io::Write::write_all(&mut std::fs::File::create(&own).unwrap(), text.as_bytes()).unwrap();
        let mut command = cargo_bin_cmd!("fitcheck");
        command.args(["report", "--check", "25 H7=25.012", "--template"]).arg(&own).arg("-o").arg(&pdf);
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, said) = run(OWN);
    assert_eq!((code, pdf.exists()), (Some(0), true), "{said}");
    assert!(said.starts_with("wrote "), "{said}");
    std::fs::remove_file(&pdf).unwrap();
    let (code, said) = run(&OWN.replace("rule-text", "rule-txt"));
    assert_eq!((code, pdf.exists()), (Some(1), false));
    assert!(said.contains("own.toml") && said.contains("line 9, column 1: ") && said.contains("rule-txt"), "{said}");
}

#[test]
fn an_unknown_field_of_the_head_lists_the_known_ones() {
    let mut command = cargo_bin_cmd!("fitcheck");
    let output =
        command.args(["report", "--check", "25 H7=25", "--head", "color=red", "-o", "x.pdf"]).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("color is not a field of the head: use one of part, drawing, revision"), "{said}");
}

#[test]
fn a_sheet_to_fill_in_needs_a_plan_and_no_value() {
    let folder = tempfile::tempdir().unwrap();
    let pdf = folder.path().join("sheet.pdf");
    let run = |template: &str| {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.args(["report", "--plan", "assets/samples/sample_plate.toml", "--template", template, "-o"]).arg(&pdf);
        command.output().unwrap().status.code()
    };
    assert_eq!((run("certificate"), pdf.exists()), (Some(1), false));
    assert_eq!((run("sheet"), pdf.exists()), (Some(0), true));
}
