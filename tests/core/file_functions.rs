//! What a program does with files: FUNCTION FILECOPY, FILEMOVE and FILEDELETE, and where FN 16 prints to.

use std::path::Path;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, Machine, Settings};
use fitcheck::store::programs::Folders;

use crate::machine::{fault_of, program, settings, text, to_end};

/// A folder that the program stands in, and one for what it writes.
struct Shop {
    folder: tempfile::TempDir,
}

impl Shop {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("in")).unwrap();
        std::fs::create_dir(folder.path().join("out")).unwrap();
        Self { folder }.with("in/m.a", b"\"%4.1F\", Q1;\r\n").with("in/plan.txt", b"PLAN\r\n")
    }

    fn with(self, name: &str, bytes: &[u8]) -> Self {
        fitcheck::files::write(&self.folder.path().join(name), bytes).unwrap();
        self
    }

    fn machine(&self, blocks: &str) -> Machine {
        let store = Folders::new().reading(self.folder.path().join("in")).writing(self.folder.path().join("out"));
        Machine::new(r"TNC:\fit\main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, settings())
    }

    /// The same, which skips what it does not know.
    fn skipping(&self, blocks: &str) -> Machine {
        let store = Folders::new().reading(self.folder.path().join("in"));
        let settings = Settings { skip_unknown: true, ..settings() };
        Machine::new(r"TNC:\fit\main.h", program(text(blocks).as_bytes()), store, Contacts::Perfect, settings)
    }

    /// What it says to blocks that run to their end.
    fn run(&self, blocks: &str) -> Vec<String> {
        let mut machine = self.machine(blocks);
        to_end(&mut machine);
        machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect()
    }

    fn fault(&self, blocks: &str) -> String {
        fault_of(&mut self.machine(blocks))
    }

    fn read(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.folder.path().join("out").join(name)).ok()
    }
}

#[test]
fn a_file_is_copied_moved_and_deleted_within_the_output_folder() {
    let shop = Shop::new();
    assert!(shop.run("FUNCTION FILECOPY \"plan.txt\" TO \"TNC:\\LOG\\B1.TXT\"").is_empty());
    assert_eq!(shop.read("LOG/B1.TXT").as_deref(), Some("PLAN\r\n"));
    assert!(shop.run("QS1 = \"TNC:\\LOG\\B1.TXT\"\nQS2 = \"B2.TXT\"\nFUNCTION FILE MOVE QS1 TO QS2").is_empty());
    assert_eq!((shop.read("LOG/B1.TXT"), shop.read("fit/B2.TXT").as_deref()), (None, Some("PLAN\r\n")));
    let said = shop.run("FUNCTION FILEDELETE \"B2.TXT\"");
    assert_eq!(said, [r"TNC:\fit\B2.TXT was deleted by the program"]);
    assert_eq!(shop.read("fit/B2.TXT"), None);
}

#[test]
fn what_lies_outside_the_output_folder_is_never_deleted() {
    let shop = Shop::new();
    let elsewhere = r"TNC:\fit\plan.txt is not in the output folder: a program deletes files only there";
    assert_eq!(shop.fault("FUNCTION FILEDELETE \"plan.txt\""), elsewhere);
    assert_eq!(shop.fault("FUNCTION FILEMOVE \"plan.txt\" TO \"b.txt\""), elsewhere);
    assert!(shop.folder.path().join("in/plan.txt").exists());
    // A built-in table.
    let built_in = shop.fault("FUNCTION FILEDELETE \"82553_hole.tab\"");
    assert!(built_in.ends_with("a program deletes files only there"), "{built_in}");
    assert_eq!(
        shop.fault("FUNCTION FILECOPY \"plan.txt\" TO \"..\\..\\b.txt\""),
        r"..\..\b.txt leads out of the folder"
    );
    assert_eq!(shop.fault("FUNCTION FILECOPY \"none.txt\" TO \"b.txt\""), r"file not found: TNC:\fit\none.txt");
    assert_eq!(shop.fault("FUNCTION FILEDELETE \"none.txt\""), r"file not found: TNC:\fit\none.txt");
    assert_eq!(shop.fault("FUNCTION FILEDELETE \"*.txt\""), "*.txt in *.txt is not a name for a file or folder");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(shop.folder.path().join("in"), shop.folder.path().join("out/link")).unwrap();
        let link = shop.fault("FUNCTION FILEDELETE \"TNC:\\link\\plan.txt\"");
        assert_eq!(link, r"TNC:\link\plan.txt leads out of the given folders");
        assert!(shop.folder.path().join("in/plan.txt").exists());
    }
}

#[test]
fn without_an_output_folder_the_run_goes_on_and_says_what_was_not_done() {
    let blocks = "FUNCTION FILECOPY \"TCHPR421.TXT\" TO \"B1.TXT\"\nFUNCTION FILEDELETE \"TCHPR421.TXT\"";
    let mut machine = Machine::new(
        r"TNC:\fit\main.h",
        program(text(blocks).as_bytes()),
        Folders::beside(Path::new("none/main.h")),
        Contacts::Perfect,
        settings(),
    );
    to_end(&mut machine);
    let said: Vec<String> = machine.remarks().iter().map(|(_, remark)| remark.to_string()).collect();
    assert_eq!(
        said,
        [
            r"TNC:\fit\B1.TXT was not written: no output folder was chosen",
            r"TNC:\fit\TCHPR421.TXT was not deleted: no output folder was chosen",
        ]
    );
}

#[test]
fn nothing_is_measured_behind_another_preset_table() {
    let hole = "TOOL CALL 1 Z\nTCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ261=-5 ~\nQ260=+15 ~\nQ275=+25.021 ~\nQ276=+25";
    let shop = Shop::new().with("in/other.pr", b"BEGIN OTHER.PR MM\nNO X Y Z\n0 +0 +0 +0\n[END]\n");
    shop.run(hole);
    let fault = shop.fault(&format!("FUNCTION FILECOPY \"other.pr\" TO \"TNC:\\table\\preset.pr\"\n{hole}"));
    assert!(fault.contains("FUNCTION FILECOPY"), "{fault}");
}

#[test]
fn a_table_that_is_open_is_not_copied() {
    let shop = Shop::new();
    let open = shop.fault("FN 26: TABOPEN 82553_hole.tab\nFUNCTION FILECOPY \"82553_hole.tab\" TO \"a.tab\"");
    assert!(open.contains("is open as a table of FN 26"), "{open}");
}

#[test]
fn a_path_may_have_the_value_of_a_parameter_in_it() {
    let shop = Shop::new();
    let before = "QS1 = \"B1\"\nQ1 = 12.5\n";
    assert!(shop.run(&format!(r"{before}FN 16: F-PRINT m.a / TNC:\LOG\:'QS1'.TXT")).is_empty());
    assert!(shop.read("LOG/B1.TXT").is_some_and(|text| text.ends_with("12.5\r\n")));
    assert!(shop.run(&format!(r"{before}Q2 = 7{}FN 16: F-PRINT m.a / TNC:\:'QS1'\P:'Q2'.TXT", "\n")).is_empty());
    assert!(shop.read("B1/P7.TXT").is_some());
    let undefined = shop.fault(r"FN 16: F-PRINT m.a / TNC:\:'QS7'.TXT");
    assert_eq!(undefined, "QS7 is undefined");
}

#[test]
fn another_device_is_a_file_below_the_output_folder() {
    let shop = Shop::new();
    for (to, file) in [
        (r"PC325:\LOG\PRO1.TXT", "PC325/LOG/PRO1.TXT"),
        (r"RS232:\NAME.A", "RS232/NAME.A"),
        (r"RS422:\", "RS422.TXT"),
        ("PRT:", "PRT.TXT"),
        (r"\\server\share\a.txt", "server/share/a.txt"),
    ] {
        let said = shop.run(&format!("Q1 = 1\nFN 16: F-PRINT m.a / {to}"));
        let path = file.replace('/', "\\");
        assert_eq!(said, [format!(r"{to} is another device: the file is TNC:\{path}")]);
        assert!(shop.read(file).is_some(), "{to}");
    }
    let said = shop.run("Q1 = 1\nFN 16: F-PRINT m.a / SCREEN");
    assert_eq!(said, ["SCREEN is taken as the name of a file: was SCREEN: meant?"]);
}

#[test]
fn an_empty_mask_makes_an_empty_file() {
    let shop = Shop::new().with("in/empty.a", b"");
    let said = shop.run("FN 16: F-PRINT empty.a / OUT.TXT");
    assert_eq!(said, [r"the mask TNC:\fit\empty.a is empty: so is what it prints"]);
    assert_eq!(shop.read("fit/OUT.TXT").as_deref(), Some(""));
}

#[test]
fn a_program_asks_whether_a_file_is_there() {
    let shop = Shop::new();
    let asks = |path: &str| format!("QS5 = \"{path}\"\nFN 18: SYSREAD Q1 = ID10 NR110 IDX5");
    for (path, right) in [("plan.txt", 1.0), ("none.txt", 0.0)] {
        let mut machine = shop.machine(&asks(path));
        to_end(&mut machine);
        assert_eq!(machine.variables().get(Parameter::q(1)), Some(&Value::Number(right)), "{path}");
    }
    // What a skipped block may have done with it is not known, nor what no file can be called.
    for blocks in [format!("FUNCTION FILECHECK \"plan.txt\"\n{}", asks("plan.txt")), asks("a?b.txt")] {
        let mut machine = shop.skipping(&blocks);
        to_end(&mut machine);
        assert_eq!(machine.variables().get(Parameter::q(1)), None, "{blocks}");
    }
}
