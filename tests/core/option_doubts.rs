//! What options, tables and files must not keep to themselves: each of these calls was once answered without a word.

use assert_cmd::Command;

/// The exit code, standard output and standard error of a call.
fn fitcheck(arguments: &[&str]) -> (Option<i32>, String, String) {
    with_input(arguments, "")
}

fn with_input(arguments: &[&str], input: &str) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_fitcheck")).args(arguments).write_stdin(input).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// Wrong usage: the call is refused, and says this.
#[track_caller]
fn refused(arguments: &[&str], reason: &str) {
    let (code, out, said) = fitcheck(arguments);
    assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments:?}: {said}");
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains(reason), "{arguments:?}: {said}");
}

/// How often a text is in another.
fn count(said: &str, text: &str) -> usize {
    said.matches(text).count()
}

struct Shop(tempfile::TempDir);

impl Shop {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn at(&self, name: &str) -> String {
        self.0.path().join(name).display().to_string()
    }

    fn file(&self, name: &str, text: &str) -> String {
        let path = self.0.path().join(name);
        fitcheck::files::make_folder(path.parent().unwrap()).unwrap();
        fitcheck::files::write(&path, text.as_bytes()).unwrap();
        path.display().to_string()
    }

    /// A table with one column of one range, upper and lower deviation.
    fn table(&self, name: &str, class: &str, end: u32, upper: &str, lower: &str) -> String {
        let title = name.rsplit('/').next().unwrap();
        let text = format!("BEGIN {title}\nNR BEREICH {class}\n0  {end}      {upper}\n1          {lower}\n[END]\n");
        self.file(name, &text)
    }
}

const BORE: [&str; 7] = ["--set", "Q273=40", "Q274=30", "Q262=25", "Q261=-8", "Q275=25.021", "Q276=25"];

/// A call of cycle 421 with these options besides its parameters.
fn bore(more: &[&str]) -> (Option<i32>, String, String) {
    fitcheck(&[&["cycle", "421"], more, &BORE].concat())
}

const WORKPIECE: &str = "[bore]\ncentre = [40, 30]\ndiameter = 25.01\n";

#[test]
fn two_own_tables_that_contradict_each_other_are_refused_whichever_comes_first() {
    let shop = Shop::new();
    for (first, second) in [("99", "50"), ("50", "99")] {
        let one = shop.table("own/a.tab", "PF", 30, &format!("+{first}"), "+10");
        let other = shop.table("own/b.tab", "PF", 30, &format!("+{second}"), "+10");
        let own = shop.at("own");
        for arguments in [
            vec!["check", "25 PF", "--measured", "25.08", "--tables", &own],
            vec!["limits", "25 PF", "--tables", &own],
            vec!["table", "export", &one, &other, "--format", "csv"],
        ] {
            let (code, out, said) = fitcheck(&arguments);
            assert_eq!((code, out.as_str()), (Some(1), ""), "{arguments:?}: {said}");
            assert!(said.contains("a.tab") && said.contains("b.tab"), "{said}");
            assert!(said.contains(&format!("PF over 0 up to 30 mm: +10 / +{first} µm and")), "{said}");
            assert!(said.contains(&format!("and +10 / +{second} µm")), "{said}");
        }
    }
}

#[test]
fn own_tables_contradict_each_other_only_where_both_have_the_size() {
    let shop = Shop::new();
    let check = |size: &str, measured: &str| {
        let (code, out, said) = fitcheck(&["check", size, "--measured", measured, "--tables", &shop.at("own")]);
        (code, out.contains("GOOD"), said)
    };
    shop.table("own/a.tab", "PF", 30, "+99", "+10");
    shop.table("own/b.tab", "PF", 50, "+99", "+10");
    assert_eq!(check("25 PF", "25.08"), (Some(0), true, String::new()));
    assert_eq!(check("40 PF", "40.08"), (Some(0), true, String::new()));
    // The second range of b lies beyond a.
    let longer = "BEGIN b.tab\nNR BEREICH PF\n0  30      +99\n1          +10\n2  50      +50\n3          +10\n[END]\n";
    shop.file("own/b.tab", longer);
    assert_eq!(check("40 PF", "40.04"), (Some(0), true, String::new()));
    // An empty cell and a full one: which file is asked first would decide whether there are limits.
    shop.table("own/b.tab", "PF", 30, "-", "-");
    let (code, _, said) = check("25 PF", "25.08");
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("+10 / +99 µm") && said.contains("no value"), "{said}");
}

#[test]
fn options_of_iso_286_are_refused_where_the_controls_tables_answer() {
    let shop = Shop::new();
    let out = shop.at("set");
    for option in [&["--js-rounded"][..], &["--edition", "1988"], &["--edition", "2010"]] {
        for call in [
            &["check", "25 JS7", "--measured", "25.010"][..],
            &["limits", "25 JS7"],
            &["nc", "25 H7", "--x", "0", "--y", "0", "--z", "0", "--control", "tnc7", "-o", &out],
            &["batch", "-"],
        ] {
            let arguments = [call, &["--source", "control"], option].concat();
            refused(&arguments, &format!("{} has no effect with --source control", option[0]));
        }
    }
    assert_eq!(fitcheck(&["limits", "10 JS7", "--js-rounded"]).0, Some(0));
    assert_eq!(fitcheck(&["limits", "10 H7", "--source", "control"]).0, Some(0));
}

#[test]
fn options_of_a_made_table_are_refused_where_a_table_is_copied() {
    let shop = Shop::new();
    let table = shop.table("own.tab", "H7", 30, "+99", "+10");
    for option in [&["--to", "100"][..], &["--ends", "3 6 10"], &["--js-rounded"], &["--edition", "1988"]] {
        let arguments = [&["table", "export", "--format", "csv"], option].concat();
        refused(&arguments, "--classes <CLASSES>");
        refused(&[&arguments[..], &[&table]].concat(), "cannot be used with '[FILES]...'");
        let made = [&["table", "export", "--format", "csv", "--classes", "H7"], option].concat();
        assert_eq!(fitcheck(&made).0, Some(0), "{made:?}");
    }
}

#[test]
fn a_batch_and_a_set_say_where_an_own_table_differs_from_iso_286() {
    let shop = Shop::new();
    let text = "BEGIN own.tab\nNR BEREICH H7 H8\n0  30      +99 +33\n1          +10 +0\n[END]\n";
    shop.file("own/own.tab", text);
    let own = shop.at("own");
    let rows = "callout,measured\n25 H7,25.05\n26 H7,26.05\n25 H8,25.01\n25 g6,24.99\n";
    let (code, _, said) = with_input(&["batch", "-", "--tables", &own], rows);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(count(&said, "table own.tab differs from ISO 286"), 1, "{said}");
    assert!(said.contains("warning: H7 over 24 up to 30 mm: table own.tab differs from ISO 286"), "{said}");
    let place = ["--x", "0", "--y", "0", "--z", "0", "--control", "tnc7", "--tables", &own];
    let (code, _, said) = fitcheck(&[&["nc", "25 H7", "-o", &shop.at("set")], &place[..]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(count(&said, "H7 over 24 up to 30 mm: table own.tab differs from ISO 286"), 1, "{said}");
    let (_, _, said) = fitcheck(&[&["nc", "25 H8", "-o", &shop.at("other")], &place[..]].concat());
    assert_eq!(count(&said, "differs"), 0, "{said}");
}

#[test]
fn a_batch_names_only_so_many_classes_that_differ() {
    let shop = Shop::new();
    let classes: Vec<String> =
        (6..=18).flat_map(|grade| ["H", "G", "F"].map(|letter| format!("{letter}{grade}"))).collect();
    let table = |from: usize| {
        let line = |cells: Vec<&str>| cells.iter().map(|cell| format!(" {cell:<5}")).collect::<Vec<_>>().concat();
        let names: Vec<&str> = classes.iter().skip(from).take(13).map(String::as_str).collect();
        let row = |cell| line(vec![cell; names.len()]);
        let (head, upper, lower) = (line(names.clone()), row("+999"), row("+1"));
        format!("BEGIN t{from}.tab\nNR BEREICH{head}\n0  30     {upper}\n1         {lower}\n[END]\n")
    };
    for from in [0, 13, 26] {
        shop.file(&format!("own/t{from}.tab"), &table(from));
    }
    let rows = classes.iter().map(|class| format!("25 {class},25.5\n")).collect::<Vec<_>>().concat();
    let (code, _, said) =
        with_input(&["batch", "-", "--tables", &shop.at("own")], &format!("callout,measured\n{rows}"));
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(count(&said, "differs from ISO 286"), 10, "{said}");
    assert!(said.contains("warning: 29 more such figures are not listed"), "{said}");
}

#[test]
fn contested_and_provisional_figures_are_told_beside_a_verdict() {
    let shop = Shop::new();
    for (callout, measured, told) in [
        ("25 EF7", "25.048", "EF7 over 24 up to 30 mm: contested: ef is 28 µm here, other sources have 25 µm\n"),
        ("700 H3", "700.003", "H3 over 630 up to 710 mm: for trial use\n"),
        ("900 H5", "900.003", "H5 over 800 up to 900 mm: for trial use; older catalogues have a smaller IT5 here\n"),
    ] {
        let (code, _, said) = fitcheck(&["check", callout, "--measured", measured]);
        assert_eq!((code, count(&said, told)), (Some(0), 1), "{said}");
        let rows = format!("callout,measured\n{callout},{measured}\n{callout},{measured}\n");
        let (code, _, said) = with_input(&["batch", "-"], &rows);
        assert_eq!((code, count(&said, told)), (Some(0), 1), "{said}");
        let folder = shop.at(&callout.replace(' ', "_"));
        let place = ["--x", "0", "--y", "0", "--z", "0", "--control", "tnc7", "-o", &folder];
        let (code, _, said) = fitcheck(&[&["nc", callout], &place[..]].concat());
        assert_eq!((code, count(&said, told)), (Some(0), 1), "{said}");
    }
    assert_eq!(fitcheck(&["check", "25 H7", "--measured", "25.01"]).2, "");
    // Half micrometres that are rounded off were asked for.
    assert_eq!(fitcheck(&["check", "10 JS7", "--measured", "10", "--js-rounded"]).2, "");
}

#[test]
fn a_parameter_that_is_set_twice_is_refused() {
    let shop = Shop::new();
    let program = shop.file("s.h", "BEGIN PGM s MM\nQ2 = Q1\nEND PGM s MM\n");
    for other in ["Q1=26", "Q001=26", "Q1=25"] {
        let (code, out, said) = fitcheck(&["run", &program, "--set", "Q1=25", other]);
        let name = other.split_once('=').unwrap().0;
        assert_eq!((code, out, said), (Some(1), String::new(), format!("fitcheck: {name} is set twice\n")));
    }
    assert_eq!(fitcheck(&["run", &program, "--set", "Q1=25", "QS1=x", "QL1=2"]).0, Some(0));
}

#[test]
fn options_that_exclude_each_other_are_refused() {
    refused(&[&["cycle", "421", "--seed", "5"][..], &BORE].concat(), "--workpiece <FILE.toml>");
    let shop = Shop::new();
    let program = shop.file("s.h", "BEGIN PGM s MM\nQ2 = Q1\nEND PGM s MM\n");
    refused(&["run", &program, "--seed", "5"], "--workpiece <FILE.toml>");
    for option in [
        &["--workpiece", "nope.toml"][..],
        &["--contacts", "nope.csv"],
        &["--tools", "nope.t"],
        &["--log-folder", "nope"],
        &["--program", "nope"],
        &["--time", "2026-01-02T03:04"],
        &["--path"],
        &["--position", "1,2,3"],
    ] {
        for instead in ["--list", "--as-block"] {
            refused(&[&["cycle", "421", instead], option].concat(), "cannot be used with");
        }
    }
    for option in
        [&["--set", "Q273=1"][..], &["--block", "nope.h"], &["--inputs", "nope.json"], &["--predef", "Q320=2"]]
    {
        refused(&[&["cycle", "421", "--list"], option].concat(), "cannot be used with");
    }
}

#[test]
fn options_of_a_cycle_without_effect_are_told() {
    let said = |more: &[&str]| {
        let (code, _, said) = bore(more);
        assert_eq!(code, Some(0), "{more:?}: {said}");
        said
    };
    assert_eq!(said(&[]), "");
    let position = said(&["--position", "1,2,3"]);
    assert!(
        position.contains("warning: --position has no effect: cycle 421 does not start at the position of the ball"),
        "{position}"
    );
    let predef = said(&["--predef", "Q320=2"]);
    assert!(predef.contains("warning: --predef has no effect on Q320: it is not set to PREDEF"), "{predef}");
    for option in [["--program", "TNC:\\A.H"], ["--time", "2026-01-02T03:04"]] {
        let told = said(&option);
        assert!(told.contains(&format!("warning: {} has no effect: no log is written or shown", option[0])), "{told}");
    }
    let g785 = fitcheck(&["cycle", "G785", "--position", "-30,0,10", "--set", "K=2", "RC=60"]);
    assert!(!g785.2.contains("--position"), "{}", g785.2);
    let used = fitcheck(&[&["cycle", "421", "--predef", "Q320=2"], &BORE[..], &["Q320=PREDEF"]].concat());
    assert_eq!((used.0, used.2.as_str()), (Some(0), ""));
}

#[test]
fn a_tool_table_without_a_unit_is_told() {
    let shop = Shop::new();
    let table = |unit: &str| {
        let text =
            format!("BEGIN TOOL.T{unit}\nT  L    R     DL    DR        TL\n1  +5   +0.25 +0    +0.0010\n[END]\n");
        let tools = shop.file("tool.t", &text);
        let (code, _, said) = fitcheck(&[&["cycle", "421", "--tools", &tools], &BORE[..], &["Q330=1"]].concat());
        assert_eq!(code, Some(0), "{said}");
        said
    };
    let told = table("");
    let unit = "the table does not name its unit: its lengths were read as millimetres: tool.t";
    assert!(told.contains(unit), "{told}");
    assert_eq!(count(&table(" MM"), "unit"), 0);
    assert_eq!(count(&table(" INCH"), "unit"), 0);
}

#[test]
fn the_expansion_of_a_warm_workpiece_is_told() {
    let shop = Shop::new();
    let warm = shop.file("warm.toml", &format!("temperature = 80\n{WORKPIECE}"));
    let (_, out, _) = bore(&["--workpiece", &warm]);
    assert!(
        out.contains("simulated workpiece warm.toml, 80 °C, expansion 11.5 millionths per kelvin, seed 1"),
        "{out}"
    );
    let source = |arguments: &[&str]| {
        let out = fitcheck(arguments).1;
        let answer: serde_json::Value = serde_json::from_str(&out).unwrap();
        answer["source"]["expansion_um_per_m_k"].as_f64()
    };
    assert_eq!(source(&[&["cycle", "421", "--workpiece", &warm, "--format", "json"], &BORE[..]].concat()), Some(11.5));
    let program = shop.file("s.h", "BEGIN PGM s MM\nQ2 = 1\nEND PGM s MM\n");
    assert_eq!(source(&["run", &program, "--workpiece", &warm, "--format", "json"]), Some(11.5));
    let brass = shop.file("brass.toml", &format!("temperature = 80\nexpansion = 18.4\n{WORKPIECE}"));
    assert_eq!(source(&["run", &program, "--workpiece", &brass, "--format", "json"]), Some(18.4));
}

#[cfg(target_os = "linux")]
#[test]
fn two_spellings_of_a_called_program_are_refused_or_told() {
    let shop = Shop::new();
    let called = |value: u32| format!("BEGIN PGM s MM\nQ5 = {value}\nEND PGM s MM\n");
    let call = |name: &str| {
        let main = shop.file("main.h", &format!("BEGIN PGM main MM\nCALL PGM {name}\nEND PGM main MM\n"));
        fitcheck(&["run", &main])
    };
    shop.file("S.H", &called(1));
    assert_eq!(call("s.h"), (Some(0), String::new(), String::new()));
    shop.file("S.h", &called(2));
    let (code, _, said) = call("s.h");
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("S.H, S.h"), "{said}");
    let (code, _, said) = call("S.H");
    assert_eq!(code, Some(0), "{said}");
    assert!(
        said.contains("note: main.h:2: S.H was read, but S.h also exists: a control has only one file of each name"),
        "{said}"
    );
    // Of a folder on the way, too.
    shop.file("Sub/a.h", &called(3));
    shop.file("SUB/a.h", &called(4));
    let (code, _, said) = call("sub/a.h");
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("SUB, Sub"), "{said}");
}

#[test]
fn a_mask_without_text_in_the_language_is_told() {
    let shop = Shop::new();
    let mask = shop.file("mask.a", "L_GERMAN;\n\"Passung %S\",QS2;\n");
    let check = |language: &str| {
        let call = ["check", "25 H7", "--measured", "25.01", "--mask", &mask, "--language", language];
        let (code, out, said) = fitcheck(&call);
        assert_eq!(code, Some(0), "{said}");
        (out, said)
    };
    let told = "the mask has text for GERMAN and none for ENGLISH";
    let (out, said) = check("en");
    assert_eq!(out, "");
    assert!(said.contains(told), "{said}");
    assert_eq!(check("de"), ("Passung 25 H7\n".to_owned(), String::new()));
    // A heading in every language hides as little that the rest is missing.
    shop.file("mask.a", "\"Fitcheck\";\nL_GERMAN;\n\"Passung %S\",QS2;\nL_DUTCH;\n\"Passing %S\",QS2;\n");
    let (out, said) = check("en");
    assert_eq!(out, "Fitcheck\n");
    assert!(said.contains("the mask has text for GERMAN, DUTCH and none for ENGLISH"), "{said}");
    assert_eq!(check("nl").1, "");
    shop.file("mask.a", "L_GERMAN;\n\"Passung\";\nL_ALL;\n\"25\";\n");
    assert!(check("en").1.contains(told));

    shop.file("mask.a", "L_GERMAN;\n\"Passung %.1F\",Q1;\n");
    let program = shop.file("main.h", "BEGIN PGM main MM\nQ1 = 2\nFN 16: F-PRINT mask.a/SCREEN:\nEND PGM main MM\n");
    let (code, _, said) = fitcheck(&["run", &program]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("main.h:3") && said.contains(told), "{said}");
    let (_, out, said) = fitcheck(&["run", &program, "--language", "de"]);
    assert_eq!((out.as_str(), said.as_str()), ("Passung 2.0\n", ""));
}
