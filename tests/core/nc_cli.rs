//! `fitcheck nc`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

struct Answer {
    code: Option<i32>,
    out: String,
    err: String,
}

fn fitcheck(folder: &Path, args: &[&str], input: &str) -> Answer {
    let answer = cargo_bin_cmd!("fitcheck").current_dir(folder).args(args).write_stdin(input).assert();
    let output = answer.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    Answer { code: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) }
}

fn nc(folder: &Path, args: &[&str]) -> Answer {
    fitcheck(folder, &[&["nc"], args].concat(), "")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const BORE: [&str; 7] = ["25 H7", "--x", "40", "--y", "30", "--z", "-8"];

fn bore<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&BORE[..], more].concat()
}

#[test]
fn a_callout_becomes_a_folder_that_runs() {
    let folder = tempfile::tempdir().unwrap();
    let answer = nc(folder.path(), &bore(&["--control", "tnc7", "-o", "set"]));
    let wrote = ["FIT_MAIN.H", "FIT_CHECK.H", "FIT_STATUS.A", "FIT_HOLE.TAB", "FIT_SHAFT.TAB", "README.TXT"]
        .map(|name| format!("wrote {}\n", Path::new("set").join(name).display()));
    let note = "note: the clearance height is 50 mm: --clearance-height changes it\n";
    assert_eq!((answer.code, answer.out.as_str()), (Some(0), ""));
    assert_eq!(answer.err, format!("{note}{}", wrote.concat()));
    assert_eq!(names(folder.path()), ["set"]);
    std::fs::write(folder.path().join("bore.toml"), "[bore]\ncentre = [40, 30]\ndiameter = 24.998\n").unwrap();
    let run = ["run", "set/FIT_MAIN.H", "--workpiece", "bore.toml", "--output-folder", "."];
    let answer = fitcheck(folder.path(), &run, "");
    assert_eq!(answer.code, Some(10), "{}", answer.err);
    let window = "FIT STATUS: REWORK\nCHECKED FIT: 25 H7\nMINIMUM SIZE:  25.0000\nMAXIMUM SIZE:  25.0210\nMEASURED DIAMETER:  24.9980\n";
    assert_eq!(answer.out, window);
    let result = folder.path().join("nc_prog").join("fitcheck").join("FIT_F1.TXT");
    let mark = "# Simulated by Fitcheck - not measured\n";
    assert_eq!(std::fs::read_to_string(result).unwrap(), format!("{mark}{window}").replace('\n', "\r\n"));
}

#[test]
fn a_plan_of_widths_and_faces_runs_on_the_part_that_is_written_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let plan = "name,kind,axis,callout,x,y,z\nH,,,25 H7,40,30,-8\nN,width,Y,16 H8,100,30,-8\n\
                R,width,X,30 h9,160,30,-8\nP,face,-Z,10 h9,220,30,10\n";
    std::fs::write(folder.path().join("part.csv"), plan).unwrap();
    let call = ["part.csv", "--control", "tnc7", "-o", "set", "--workpiece-out", "part.toml"];
    let answer = nc(folder.path(), &call);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.err.ends_with("wrote part.toml\n"), "{}", answer.err);
    let run = ["run", "set/FIT_MAIN.H", "--workpiece", "part.toml"];
    let answer = fitcheck(folder.path(), &run, "");
    assert_eq!(
        (answer.code, answer.out.matches(" STATUS: GOOD\n").count()),
        (Some(0), 4),
        "{}{}",
        answer.out,
        answer.err
    );
    // The slot a hundredth too wide: scrap, and only the slot.
    let path = folder.path().join("part.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("width = 16.0135", "width = 16.0271")).unwrap();
    let answer = fitcheck(folder.path(), &run, "");
    assert_eq!(
        (answer.code, answer.out.matches("STATUS: SCRAP").count()),
        (Some(11), 1),
        "{}{}",
        answer.out,
        answer.err
    );
    // Neither is replaced unasked.
    let answer = nc(folder.path(), &["part.csv", "--control", "tnc7", "-o", "other", "--workpiece-out", "part.toml"]);
    assert_eq!((answer.code, folder.path().join("other").exists()), (Some(1), false), "{}", answer.err);
}

#[test]
fn a_plan_becomes_a_zip_and_notes_say_what_is_special() {
    let folder = tempfile::tempdir().unwrap();
    let plan = "name;callout;x;y;z\nA;25 D10;40;30;-8\nB;24 ZA8;0;4,5;-2\n";
    std::fs::write(folder.path().join("plan.csv"), plan).unwrap();
    let answer = nc(folder.path(), &["plan.csv", "--control", "tnc7", "--language", "de", "-o", "set.zip"]);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert_eq!(
        answer.err,
        "note: ZA8 is not one of the 47 classes of NC-Solution 8255: FIT_HOLE.TAB gets an extra column\n\
         note: A: the nominal size of 25 D10 is outside the limits, which a TNC7 refuses: Q262 is 25.065 mm, and Q163 refers \
         to that\n\
         note: B: the nominal size of 24 ZA8 is outside the limits, which a TNC7 refuses: Q262 is 23.902 mm, and Q163 refers \
         to that\n\
         wrote set.zip (6 files)\n"
    );
    assert_eq!(names(folder.path()), ["plan.csv", "set.zip"]);
    let zip = std::fs::File::open(folder.path().join("set.zip")).unwrap();
    let mut zip = zip::ZipArchive::new(zip).unwrap();
    assert!(zip.by_name("LIESMICH.TXT").is_ok());
    // The same through standard input, for an older control and another folder.
    let args = ["nc", "-", "--control", "itnc530", "--folder", r"TNC:\order", "-o", "set"];
    let answer = fitcheck(folder.path(), &args, plan);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    let main = std::fs::read_to_string(folder.path().join("set").join("8255_en.h")).unwrap();
    assert!(main.contains("CALL PGM TNC:\\order\\82551_en.h\r\n"), "{main}");
}

#[test]
fn files_that_are_there_stay_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("set").join("FIT_HOLE.TAB");
    std::fs::create_dir(folder.path().join("set")).unwrap();
    std::fs::write(&mine, "mine").unwrap();
    std::fs::write(folder.path().join("set.zip"), "mine").unwrap();
    for (output, there) in [("set", Path::new("set").join("FIT_HOLE.TAB")), ("set.zip", "set.zip".into())] {
        let answer = nc(folder.path(), &bore(&["--control", "tnc640", "-o", output]));
        let why = format!(
            "fitcheck: a file or folder of this name already exists: {}; --force overwrites\n",
            there.display()
        );
        assert_eq!(answer.code, Some(1));
        assert!(answer.err.ends_with(&why), "{}", answer.err);
    }
    assert_eq!(names(&folder.path().join("set")), ["FIT_HOLE.TAB"]);
    assert_eq!(std::fs::read(&mine).unwrap(), b"mine");
    for output in ["set", "set.zip"] {
        let answer = nc(folder.path(), &bore(&["--control", "tnc640", "-o", output, "--force"]));
        assert_eq!(answer.code, Some(0), "{}", answer.err);
    }
    assert_eq!(names(&folder.path().join("set")).len(), 6);
    assert!(std::fs::read(&mine).unwrap().starts_with(b"BEGIN FIT_HOLE.TAB"));
}

#[track_caller]
fn refused(args: &[&str], why: &str) {
    let folder = tempfile::tempdir().unwrap();
    let plan = "callout,x,y,z\n25 H7,40,30,-8\n12 ±0.02,1,2,3\n";
    std::fs::write(folder.path().join("plan.csv"), plan).unwrap();
    let answer = nc(folder.path(), &[args, &["--control", "tnc7", "-o", "set"]].concat());
    assert_eq!((answer.code, answer.err.as_str()), (Some(1), format!("fitcheck: {why}\n").as_str()));
    assert_eq!(names(folder.path()), ["plan.csv"], "nothing is written");
}

#[test]
fn what_the_program_cannot_do_is_refused() {
    let place = ["--x", "0", "--y", "0", "--z", "0"];
    let at = |callout: &'static str| [&[callout][..], &place].concat();
    let no_side = "does not say whether the hole or the shaft is meant";
    refused(
        &["plan.csv"],
        "plan.csv: line 3: 12 ±0.02 may be a hole or a shaft: add feature = \"hole\" or feature = \"shaft\", or kind = \"length\" where it is neither",
    );
    refused(&at("10m"), &format!("10m {no_side}: add --feature hole or --feature shaft"));
    refused(&at("25 H7/g6"), "25 H7/g6 is a fit: write the hole and the shaft as two features");
    refused(&at("0.8 N9"), "0.8 N9: N9 is not defined at 0.8 mm in ISO 286; it is defined over 1 up to 3150 mm");
    refused(&at("0.01 P9"), "Q276 MINIMUM DIMENSION = -0.021 mm: at least 0 mm, at most 99999.9999 mm");
    refused(&["25 H7", "--x", "0", "--y", "0"], "--z is missing: a single callout needs --x, --y and --z");
    refused(&bore(&["--clearance-height", "-8"]), "clearance height -8 mm is not above the measuring height, -8 mm");
    refused(&bore(&["--name", "../x"]), "name ../x: letters A to Z, digits and _ are allowed, at most 20");
    refused(
        &bore(&["--angle", "1,2.3"]),
        "--angle: 1,2.3 is ambiguous: write one decimal sign and no thousands separator",
    );
    refused(&["plan.csv", "--x", "1"], "--x is for a single callout: a plan has a column for it");
    refused(
        &bore(&["--folder", r"C:\fit"]),
        r"C:\fit is not a folder for programs: write TNC:\ and then names of letters, digits, _ and -, separated by \",
    );
    refused(&["none.csv"], "no such file or folder: none.csv");
}

#[test]
fn a_broken_path_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let output = Path::new("none").join("set");
    let answer = nc(folder.path(), &bore(&["--control", "tnc7", "-o", output.to_str().unwrap()]));
    assert_eq!(answer.code, Some(1));
    assert!(
        // The missing folder is the one that the set would be in.
        answer.err.ends_with("fitcheck: no such file or folder: none\n"),
        "{}",
        answer.err
    );
    assert!(names(folder.path()).is_empty());
}

#[test]
fn help_shows_examples_and_the_columns_of_a_plan() {
    let folder = tempfile::tempdir().unwrap();
    let help = nc(folder.path(), &["--help"]);
    assert_eq!(help.code, Some(0));
    for text in ["fitcheck nc \"25 H7\" --x 40", "clearance_height", "Exit codes"] {
        assert!(help.out.contains(text), "{}", help.out);
    }
    let answer = nc(folder.path(), &bore(&["--control", "tnc426", "-o", "set"]));
    assert_eq!(answer.code, Some(2));
}

#[test]
fn a_callout_without_a_class_is_measured_by_its_own_limits() {
    let folder = tempfile::tempdir().unwrap();
    let place = ["--x", "40", "--y", "30", "--z", "-8", "--control", "tnc640"];
    for (feature, code, status) in [("hole", 11, "SCRAP"), ("shaft", 10, "REWORK")] {
        let part = format!("{feature}.toml");
        let args = [&["12 ±0.02", "--feature", feature, "-o", feature, "--workpiece-out", &part][..], &place].concat();
        let answer = nc(folder.path(), &args);
        assert_eq!(answer.code, Some(0), "{}", answer.err);
        let path = folder.path().join(&part);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains("diameter = 12.0\n"), "{text}");
        std::fs::write(&path, text.replace("diameter = 12.0\n", "diameter = 12.037\n")).unwrap();
        let main = format!("{feature}/FIT_MAIN.H");
        let answer = fitcheck(folder.path(), &["run", &main, "--workpiece", &part], "");
        assert_eq!(answer.code, Some(code), "{}{}", answer.out, answer.err);
        let window = format!("FIT STATUS: {status}\nCHECKED FIT: 12 +0.02/-0.02\n");
        assert!(answer.out.starts_with(&window), "{}", answer.out);
    }
}

#[test]
fn a_series_runs_part_by_part_and_its_files_are_imported() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("plan.csv"), "name,callout,x,y,z\nF1,25 H7,40,30,-8\n").unwrap();
    let answer = nc(folder.path(), &["plan.csv", "--control", "tnc7", "--series=3", "-o", "set"]);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    // Table and protocol lie in the folder of outputs from the second part on.
    let run = ["run", "set/FIT_SERIES.H", "--workpiece", "bore.toml", "--output-folder", "out"];
    std::fs::create_dir(folder.path().join("out")).unwrap();
    for (diameter, code) in [("25.01", 0), ("24.998", 10), ("25.03", 11)] {
        let bore = format!("[bore]\ncentre = [40, 30]\ndiameter = {diameter}\n");
        std::fs::write(folder.path().join("bore.toml"), bore).unwrap();
        let answer = fitcheck(folder.path(), &run, "");
        assert_eq!(answer.code, Some(code), "{} {}", answer.out, answer.err);
    }
    let full = fitcheck(folder.path(), &run, "");
    assert!(full.code == Some(1) && full.err.contains("FN 14: ERROR= 1004"), "{}", full.err);
    let out = "out/nc_prog/fitcheck";
    for call in [
        vec!["import", "--plan", "plan.csv", &format!("{out}/FIT_SERIES.TAB"), "--format", "csv"],
        vec![
            "import",
            "--plan",
            "plan.csv",
            "--mask",
            "set/FIT_SERIES.A",
            &format!("{out}/FIT_SERIES.TXT"),
            "--format",
            "csv",
        ],
    ] {
        let answer = fitcheck(folder.path(), &call, "");
        let rows = |text: &str| answer.out.lines().filter(|line| line.contains(text)).count();
        let found = ["25.010,10,GOOD", "24.998,-2,REWORK", "25.030,30,SCRAP"].map(rows);
        assert_eq!((answer.code, found), (Some(11), [1; 3]), "{}\n{}", answer.out, answer.err);
    }
}
