//! Sets for a series: fifty parts one after the other, and the table and the protocol read back to the native verdicts.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::sync::{Arc, Mutex};

use fitcheck::control::mask::{FileUse, Mask};
use fitcheck::exchange::{ByPlan, ImportInputs, Item, import_from};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Fault, Machine, NcPath, Settings, Step, Store, StoreError};
use fitcheck::nc::program::Program;
use fitcheck::nc::sets::{Control, NcSet, SetError, Target};
use fitcheck::part::Plan;
use fitcheck::probing::Contact;
use fitcheck::probing::simulated::{Simulation, Surface, Workpiece};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;
use jiff::civil::{DateTime, date};

use crate::nc_sets::measured;
use crate::plans;

const NOW: DateTime = date(2026, 3, 7).at(8, 5, 9, 0);
const PARTS: i64 = 50;

/// A control's disk, which stays from run to run.
#[derive(Clone, Default)]
struct Disk {
    files: Arc<Mutex<BTreeMap<String, Vec<u8>>>>,
    /// A file that cannot be written.
    read_only: Option<String>,
}

impl Disk {
    fn with(set: &NcSet, control: Control) -> Self {
        let disk = Self::default();
        set.files.iter().for_each(|file| disk.put(control, &file.name, &file.bytes));
        disk
    }

    fn put(&self, control: Control, name: &str, bytes: &[u8]) {
        let path = NcPath::new(&format!("{}{name}", control.usual_folder())).unwrap();
        self.files.lock().unwrap().insert(path.to_string(), bytes.to_vec());
    }

    fn text(&self, control: Control, name: &str) -> String {
        let path = NcPath::new(&format!("{}{name}", control.usual_folder())).unwrap();
        let bytes = self.files.lock().unwrap().get(&path.to_string()).cloned().unwrap_or_default();
        String::from_utf8(bytes).unwrap()
    }
}

impl Store for Disk {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        let missing = || StoreError::Missing { path: path.clone() };
        self.files.lock().unwrap().get(&path.to_string()).cloned().ok_or_else(missing)
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<usize, StoreError> {
        if self.read_only.as_ref().is_some_and(|name| path.file_name() == name) {
            return Err(StoreError::System { path: path.clone(), reason: "it is write-protected".to_owned() });
        }
        let mut files = self.files.lock().unwrap();
        let file = files.entry(path.to_string()).or_default();
        if how == FileUse::Replace {
            file.clear();
        }
        file.extend_from_slice(bytes);
        Ok(file.len())
    }

    fn writes(&self) -> bool {
        true
    }
}

struct Names {
    main: &'static str,
    mask: &'static str,
    table: &'static str,
    protocol: &'static str,
}

fn names(control: Control) -> Names {
    if control == Control::Itnc530 {
        Names {
            main: "8255_series_en.h",
            mask: "82552_series_en.a",
            table: "82553_series.tab",
            protocol: "8255_series.txt",
        }
    } else {
        Names { main: "FIT_SERIES.H", mask: "FIT_SERIES.A", table: "FIT_SERIES.TAB", protocol: "FIT_SERIES.TXT" }
    }
}

fn plan() -> Plan {
    plans::read(
        "name,callout,feature,x,y,z\nBORE_1,25 H7,,0,0,-8\nPIN,20 g6,,50,0,-8\nBORE_2,35 +0.2/0,hole,90,0,-8\n",
        &Sources::default(),
    )
    .unwrap()
}

fn series(plan: &Plan, control: Control, language: Dialogue, parts: u16) -> NcSet {
    let target = Target { parts: Some(parts), ..Target::new(control, language) };
    NcSet::make(plan, &target, &Sources::default()).unwrap()
}

fn off(length: Length, nanometres: i64) -> Length {
    Length::from_nanometres(length.nanometres() + nanometres).unwrap()
}

/// The measured values of a part, from 1: mostly good, some of them on a limit and a nanometre beyond it.
fn values(plan: &Plan, part: i64) -> Vec<Length> {
    let size = |(at, limits): (i64, &fitcheck::tolerance::Limits)| match (part + 3 * at) % 17 {
        4 => off(limits.maximum(), 1),
        9 => off(limits.minimum(), -1),
        11 => limits.maximum(),
        14 => limits.minimum(),
        step => off(limits.middle(), 137 * step - 900 + at),
    };
    (0..).zip(plan.features()).map(|(at, feature)| size((at, &feature.limits[0]))).collect()
}

/// Runs the series program for a part; whether it has stopped on the way.
fn run(disk: &Disk, (control, language): (Control, Dialogue), contacts: Contacts) -> Result<(Machine, usize), Fault> {
    let name =
        if language == Dialogue::En { names(control).main.to_owned() } else { format!("8255_series_{language}.h") };
    let name = if control == Control::Itnc530 { name } else { names(control).main.to_owned() };
    let (program, warnings) = Program::read(disk.text(control, &name).as_bytes()).unwrap();
    assert_eq!(warnings, []);
    let path = format!("{}{name}", control.usual_folder());
    let settings = Settings::new(language, NOW);
    let mut machine = Machine::new(&path, Arc::new(program), disk.clone(), contacts, settings);
    let mut stops = 0;
    loop {
        match machine.run(1_000_000)? {
            Step::Ended => return Ok((machine, stops)),
            Step::Paused(_) => stops += 1,
            Step::Went => panic!("it does not end"),
        }
    }
}

fn contacts(plan: &Plan, values: &[Length]) -> Vec<Contact> {
    let of = |(feature, value): (&fitcheck::part::PlanFeature, &Length)| {
        measured(feature, &feature.limits[0], *value).contacts
    };
    plan.features().iter().zip(values).flat_map(of).collect()
}

/// What the native measurement says of the values of a part.
fn native(plan: &Plan, values: &[Length]) -> Vec<(Length, Status)> {
    let of = |(feature, value): (&fitcheck::part::PlanFeature, &Length)| {
        let limits = &feature.limits[0];
        let diameter = measured(feature, limits, *value).diameter;
        (diameter, judge(limits, diameter, None).status())
    };
    plan.features().iter().zip(values).map(of).collect()
}

/// The values of a file by the plan: part, feature, value and status; and what else is said.
fn import(file: &str, text: &str, mask: Option<(&str, &str)>, plan: Option<&Plan>) -> (Vec<String>, Vec<String>) {
    let masks: Vec<_> =
        mask.iter().map(|(name, text)| ((*name).to_owned(), Mask::read(text.as_bytes()).unwrap().0)).collect();
    let sources = Sources::default();
    let given = ImportInputs { masks: &masks, has_plan: plan.is_some(), ..ImportInputs::new(&sources, NOW) };
    let mut items = Vec::new();
    import_from(file, &mut Cursor::new(text.as_bytes()), given, &mut |item| items.push(item));
    let items = match plan {
        Some(plan) => ByPlan::new(plan).file(items),
        None => items,
    };
    let mut values = Vec::new();
    let mut said = Vec::new();
    for item in items {
        match item {
            Item::Record { record, labels, .. } => {
                let simulated = if record.measurement.origin.is_simulated() { " simulated" } else { "" };
                let (measured, status) = (record.measurement.diameter, record.verdict.status());
                values.push(format!("{} {} {measured} {status}{simulated}", labels.serial, record.id));
            }
            Item::Unjudged(unjudged) => said.push(format!("{}: {}", unjudged.id, unjudged.why)),
            Item::Error(error) => said.push(error.to_string()),
            Item::Warning(warning) => said.push(format!("warning: {warning}")),
            Item::Contacts(_) => panic!("no contacts"),
        }
    }
    (values, said)
}

fn expected(plan: &Plan, parts: impl Iterator<Item = i64>) -> Vec<String> {
    let part = |part: i64| {
        let native = native(plan, &values(plan, part));
        let named = native.into_iter().zip(plan.features());
        named.map(move |((measured, status), feature)| format!("{part} {} {measured} {status}", feature.name))
    };
    parts.flat_map(part).collect()
}

/// The mean to the nanometre, and the range, of a size of all parts so far.
fn so_far(plan: &Plan, last: i64, size: usize) -> [Length; 2] {
    let values: Vec<i64> = (1..=last).map(|part| native(plan, &values(plan, part))[size].0.nanometres()).collect();
    let sum: i64 = values.iter().sum();
    let mean = (2 * sum + last).div_euclid(2 * last);
    let range = values.iter().max().unwrap() - values.iter().min().unwrap();
    [mean, range].map(|length| Length::from_nanometres(length).unwrap())
}

#[test]
fn fifty_parts_one_after_the_other_give_the_native_verdicts() {
    let plan = plan();
    for control in Control::ALL {
        let of = names(control);
        let disk = Disk::with(&series(&plan, control, Dialogue::En, 60), control);
        let mut worst = Status::Good;
        for part in 1..=PARTS {
            let values = values(&plan, part);
            let recorded = Contacts::Recorded(contacts(&plan, &values));
            let (machine, stops) =
                run(&disk, (control, Dialogue::En), recorded).unwrap_or_else(|fault| panic!("{fault}"));
            let status = native(&plan, &values).into_iter().map(|(_, status)| status).max().unwrap();
            worst = worst.max(status);
            assert_eq!(stops, usize::from(status == Status::Scrap), "{part} {control:?}");
            let block = &machine.outputs().last().unwrap().text;
            assert!(block.starts_with(&format!("PART: {part:4}\nSTATUS: {status}\n")), "{block}");
            assert!(block.ends_with(&format!("WORST SO FAR: {worst}\n")), "{block}");
            for (size, feature) in plan.features().iter().enumerate() {
                let [mean, range] = so_far(&plan, part, size).map(|length| format!("{:.6}", length.to_mm_f64()));
                let line = format!("{} MEAN:{mean:>11}  RANGE:{range:>11}\n", feature.name);
                assert!(block.contains(&line), "{line}{block}");
            }
        }
        assert_eq!(worst, Status::Scrap);
        let expected = expected(&plan, 1..=PARTS);
        let statuses = |status: Status| expected.iter().filter(|said| said.ends_with(&status.to_string())).count();
        assert_eq!([Status::Good, Status::Rework, Status::Scrap].map(|status| 5 < statuses(status)), [true; 3]);
        let table = disk.text(control, of.table);
        let (rows, said) = import(of.table, &table, None, Some(&plan));
        assert_eq!((rows, said), (expected.clone(), vec![]), "{table}");
        let mask = disk.text(control, of.mask);
        let protocol = disk.text(control, of.protocol);
        let (blocks, said) = import(of.protocol, &protocol, Some((of.mask, &mask)), Some(&plan));
        assert_eq!(blocks, expected, "{said:?}");
        let skipped = "Q1720, Q1721, Q1722, Q1840, Q1841, Q1842";
        assert_eq!(said.len(), 1, "{said:?}");
        assert!(skipped.split(", ").all(|name| said[0].contains(name)), "{said:?}");
        // Without a plan the callouts of the protocol have the limits; one without a class says neither hole nor shaft.
        let (alone, _) = import(of.protocol, &protocol, Some((of.mask, &mask)), None);
        let of_class = |said: &&String| !said.contains("BORE_2");
        assert_eq!(
            alone.iter().filter(of_class).collect::<Vec<_>>(),
            expected.iter().filter(of_class).collect::<Vec<_>>()
        );
    }
}

/// A TNC7 judges by the text itself, and the series is the same.
#[test]
fn a_series_by_texts_gives_the_native_verdicts() {
    let (plan, control) = (plan(), Control::Tnc7);
    let target = Target { parts: Some(20), by_text: true, ..Target::new(control, Dialogue::En) };
    let set = NcSet::make(&plan, &target, &Sources::default()).unwrap();
    let disk = Disk::with(&set, control);
    for part in 1..=17 {
        let recorded = Contacts::Recorded(contacts(&plan, &values(&plan, part)));
        run(&disk, (control, Dialogue::En), recorded).unwrap_or_else(|fault| panic!("{fault}"));
    }
    let of = names(control);
    let (rows, said) = import(of.table, &disk.text(control, of.table), None, Some(&plan));
    assert_eq!((rows, said), (expected(&plan, 1..=17), vec![]));
}

/// The words of every dialogue are known to the reader of the protocol.
#[test]
fn the_protocol_of_every_language_reads_back() {
    let plan = plan();
    for control in Control::ALL {
        for language in Dialogue::ALL {
            let set = series(&plan, control, language, 3);
            let disk = Disk::with(&set, control);
            for part in [4, 5, 9] {
                let recorded = Contacts::Recorded(contacts(&plan, &values(&plan, part)));
                run(&disk, (control, language), recorded).unwrap_or_else(|fault| panic!("{fault}"));
            }
            let of = names(control);
            let is_mask = |name: &str| name.contains("series.a") || name.contains("series_") && name.ends_with('a');
            let mask = set.files.iter().find(|file| is_mask(&file.name.to_lowercase())).unwrap();
            let text = String::from_utf8(mask.bytes.clone()).unwrap();
            let protocol = disk.text(control, of.protocol);
            let (blocks, said) = import(of.protocol, &protocol, Some((&mask.name, &text)), Some(&plan));
            let numbered = [4, 5, 9].into_iter().zip(1..);
            let expected: Vec<String> = numbered
                .flat_map(|(part, number)| {
                    let values = expected(&plan, std::iter::once(part)).into_iter();
                    values.map(move |said| format!("{number}{}", said.strip_prefix(&part.to_string()).unwrap()))
                })
                .collect();
            assert_eq!(blocks, expected, "{language} {said:?}\n{protocol}");
            assert_eq!(said.len(), 1, "{language} {said:?}\n{protocol}");
        }
    }
}

#[test]
fn faces_points_and_sides_have_columns_of_their_own() {
    let rows = "name,callout,callout2,kind,axis,x,y,z\nK1,40 H8,30 H8,pocket,,0,0,-5\nTOP,0.5 h9,,face,-Z,60,0,0.5\n\
                S1,8 H9,,width,X,90,0,-4\nP1,±0.05,,point,-Z,120,0,0\n";
    let plan = plans::read(rows, &Sources::default()).unwrap();
    let set = series(&plan, Control::Tnc640, Dialogue::En, 2);
    let table = set.files.iter().find(|file| file.name == "FIT_SERIES.TAB").unwrap();
    let table = String::from_utf8(table.bytes.clone()).unwrap();
    let columns = table.lines().find(|line| line.starts_with("NR ")).unwrap();
    assert_eq!(
        columns.split_whitespace().collect::<Vec<_>>(),
        ["NR", "PART", "K1_X", "K1_Y", "TOP", "S1", "P1", "STATUS"]
    );
}

/// A series on a simulated workpiece: neither file loses that nobody measured.
#[test]
fn what_a_simulation_measures_stays_simulated_in_the_table_and_in_the_protocol() {
    let plan = plans::read("name,callout,x,y,z\nF1,25 H7,0,0,-8\n", &Sources::default()).unwrap();
    let control = Control::Tnc7;
    let set = series(&plan, control, Dialogue::En, 4);
    let disk = Disk::with(&set, control);
    for diameter in [25.01, 25.03] {
        let workpiece = Workpiece::round(fitcheck::tolerance::Feature::Hole, [0.0, 0.0], diameter);
        let simulation = Simulation::perfect(Surface::Round(workpiece, fitcheck::probing::cycle::Plane::Xy));
        run(&disk, (control, Dialogue::En), Contacts::Workpiece(simulation.into())).unwrap();
    }
    let expected = ["1 F1 25.01 GOOD simulated", "2 F1 25.03 SCRAP simulated"];
    let table = disk.text(control, "FIT_SERIES.TAB");
    assert_eq!(import("FIT_SERIES.TAB", &table, None, Some(&plan)).0, expected, "{table}");
    let mask = disk.text(control, "FIT_SERIES.A");
    let protocol = disk.text(control, "FIT_SERIES.TXT");
    assert_eq!(import("s.txt", &protocol, Some(("m.a", &mask)), Some(&plan)).0, expected, "{protocol}");
}

/// Runs the next part on a disk whose table was changed, and gives the fault.
#[track_caller]
fn fault(change: impl Fn(&str) -> String, parts: i64) -> String {
    let plan = plan();
    let control = Control::Tnc640;
    let disk = Disk::with(&series(&plan, control, Dialogue::En, 3), control);
    for part in 1..=parts {
        run(&disk, (control, Dialogue::En), Contacts::Recorded(contacts(&plan, &values(&plan, part)))).unwrap();
    }
    let before = change(&disk.text(control, "FIT_SERIES.TAB"));
    disk.put(control, "FIT_SERIES.TAB", before.as_bytes());
    let next = Contacts::Recorded(contacts(&plan, &values(&plan, parts + 1)));
    let fault = run(&disk, (control, Dialogue::En), next).map(|_| ()).unwrap_err();
    // The probe has not moved, or the row stays without its number.
    let numbers = disk.text(control, "FIT_SERIES.TAB").matches(&format!(" {} ", parts + 1)).count();
    assert!(numbers <= 1, "{}", disk.text(control, "FIT_SERIES.TAB"));
    fault.to_string()
}

#[test]
fn a_full_table_and_one_that_was_changed_stop_before_anything_is_measured() {
    let same = |text: &str| text.to_owned();
    assert!(fault(same, 3).contains("FN 14: ERROR= 1004"), "{}", fault(same, 3));
    // The counter of the first row is no number, not its own, or beyond the last row.
    for garbage in ["x", "7", "99999"] {
        let said = fault(|text| text.replacen("0       1  ", &format!("0       {garbage:<3}"), 1), 1);
        assert!(said.contains("1011") || said.contains("PART"), "{garbage}: {said}");
    }
    // A word of a status that the program does not know is neither good nor bad.
    let said = fault(|text| text.replace("REWORK", "REWRK").replace("GOOD  ", "GUT   ").replace("SCRAP", "SCRPA"), 2);
    assert!(said.contains("FN 14: ERROR= 1011"), "{said}");
    let said =
        fault(|text| text.replacen("STATUS  ", "STATE   ", 1).replacen("key:=\"STATUS\"", "key:=\"STATE\"", 1), 1);
    assert!(said.contains("STATUS"), "{said}");
}

#[test]
fn a_table_that_is_missing_or_write_protected_stops_the_series() {
    let plan = plan();
    let control = Control::Tnc640;
    let set = series(&plan, control, Dialogue::En, 3);
    let next = || Contacts::Recorded(contacts(&plan, &values(&plan, 1)));
    let without = NcSet {
        files: set.files.iter().filter(|file| file.name != "FIT_SERIES.TAB").cloned().collect(),
        remarks: Vec::new(),
    };
    let disk = Disk::with(&without, control);
    let said = run(&disk, (control, Dialogue::En), next()).map(|_| ()).unwrap_err().to_string();
    assert!(said.contains("TABOPEN") && said.contains("FIT_SERIES.TAB"), "{said}");
    let disk = Disk { read_only: Some("FIT_SERIES.TAB".to_owned()), ..Disk::with(&set, control) };
    let said = run(&disk, (control, Dialogue::En), next()).map(|_| ()).unwrap_err().to_string();
    assert!(said.contains("it is write-protected"), "{said}");
    assert!(import("FIT_SERIES.TAB", &disk.text(control, "FIT_SERIES.TAB"), None, Some(&plan)).0.is_empty());
}

#[test]
fn what_a_series_cannot_hold_is_refused() {
    let refused = |rows: &str, control: Control| {
        let plan = plans::read(rows, &Sources::default()).unwrap();
        let target = Target { parts: Some(5), ..Target::new(control, Dialogue::En) };
        NcSet::make(&plan, &target, &Sources::default()).unwrap_err()
    };
    for name in ["1", "_A", "Part", "STATUS", "NR"] {
        let error = refused(&format!("name,callout,x,y,z\n{name},25 H7,0,0,-8\n"), Control::Tnc7);
        assert_eq!(error, SetError::SeriesName { name: name.to_owned() }, "{name}");
    }
    let many = |count: usize| format!("callout,x,y,z\n{}", "25 H7,0,0,-8\n".repeat(count));
    assert_eq!(refused(&many(41), Control::Tnc7), SetError::SeriesSizes { sizes: 41, most: 40 });
    // 200 characters a line and 30 columns on an iTNC 530.
    assert!(matches!(refused(&many(20), Control::Itnc530), SetError::Table { table: "82553_series.tab", .. }));
}
