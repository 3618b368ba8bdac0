//! Runs a set before it is handed over: every feature on a workpiece in the middle of its zone.
//!
//! Only the set's own files are present, at their paths on the control. Each feature must be measured by the cycle of its
//! hole or shaft with exactly the plan's limits, from a table or from the main program, and be found good: then the
//! program, the tables, the mask and every path in them fit together.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::part::FeatureKind;
use fitcheck_core::probing::Contact;
use fitcheck_core::probing::cycle::Angle;
use fitcheck_core::probing::vector::along;
use fitcheck_core::verdict::Status;

use super::error::{ProofFault, SetError};
use super::names::Names;
use super::{Planned, SetFile};
use crate::machine::{Contacts, Machine, NcPath, Settings, Step};
use crate::program::Program;

/// How many blocks may run between two pauses: a run pauses once per feature, and must not go on for ever.
const BLOCKS: u64 = 10_000_000;

/// Runs the set; the first file is its main program.
pub(super) fn run(files: &[SetFile], planned: &[Planned<'_>], names: &Names<'_>) -> Result<(), SetError> {
    let failed = SetError::Proof;
    let on_control = |file: &SetFile| (NcPath::of_file(&names.path(&file.name)), file.bytes.clone());
    let store: BTreeMap<NcPath, Vec<u8>> = files.iter().map(on_control).collect();
    // The reader refuses what is empty.
    let main = files.first().map_or(&[][..], |file| &file.bytes);
    let (program, _warnings) = Program::read(main).map_err(|error| failed(ProofFault::Program(error)))?;
    let contacts = planned.iter().flat_map(contacts).collect();
    // No mask of a set prints the time.
    let settings = Settings::new(names.target.language, jiff::civil::DateTime::default());
    let path = names.path(&names.main);
    let mut machine = Machine::new(&path, Arc::new(program), store, Contacts::Recorded(contacts), settings);
    loop {
        match machine.run(BLOCKS).map_err(|fault| failed(ProofFault::Fault(fault)))? {
            Step::Ended => break,
            Step::Paused(_) => {}
            Step::Went => return Err(failed(ProofFault::NoEnd)),
        }
    }
    let measured = machine.cycles().iter();
    let found: Vec<_> = measured.map(|run| (run.cycle.code, run.result.status, &run.result.checks)).collect();
    if found.len() != planned.len() || machine.windows().len() != planned.len() {
        return Err(failed(ProofFault::Count { found: found.len(), expected: planned.len() }));
    }
    for (planned, (cycle, status, checks)) in planned.iter().zip(found) {
        let limits = checks.iter().map(|check| (check.minimum, check.maximum));
        let expected = planned.limits.iter().map(|limits| (limits.minimum(), limits.maximum()));
        // That of a hole or of a shaft: in the middle of the zone both are good.
        let is_its_cycle = planned.cycle().is_some_and(|own| own.code == cycle);
        if status != Some(Status::Good) || !limits.eq(expected) || !is_its_cycle {
            return Err(failed(ProofFault::OtherVerdict { name: planned.feature.name.clone() }));
        }
    }
    Ok(())
}

/// The contacts on a workpiece in the middle of the zone, in the order of the cycle.
fn contacts(planned: &Planned<'_>) -> Vec<Contact> {
    let feature = planned.feature;
    let place = planned.place.map(Length::to_mm_f64);
    // A size without limits is never in the middle of them, and the proof fails.
    let middle = |side: usize| planned.limits.get(side).map_or(0.0, |limits| limits.middle().to_mm_f64());
    let at = |direction: [f64; 3], distance: f64| Contact::at(along(place, direction, distance));
    match &feature.kind {
        FeatureKind::Diameter(_) => [0, 1, 2, 3]
            .map(|number| {
                let [cos, sin] = feature.angle.stepped(Angle::from_degrees(90), number).direction();
                at([cos, sin, 0.0], middle(0) / 2.0)
            })
            .to_vec(),
        FeatureKind::Width(_, axis) => [1.0, -1.0].map(|sign| at(axis.vector(), sign * middle(0) / 2.0)).to_vec(),
        FeatureKind::Pocket(_) | FeatureKind::Boss(_) => {
            let ways = [([1.0, 0.0, 0.0], 0), ([0.0, 1.0, 0.0], 1), ([-1.0, 0.0, 0.0], 0), ([0.0, -1.0, 0.0], 1)];
            ways.map(|(way, side)| at(way, middle(side) / 2.0)).to_vec()
        }
        FeatureKind::Face(_, towards) => {
            let [x, y, z] = place;
            let [is_x, is_y, is_z] = towards.vector().map(|part| 0.0 < part.abs());
            let one = |is_measured, part| if is_measured { middle(0) } else { part };
            vec![Contact::at([one(is_x, x), one(is_y, y), one(is_z, z)])]
        }
        FeatureKind::Point(_, direction) => vec![at(direction.unit_normal(), middle(0))],
        FeatureKind::Length(_) | FeatureKind::Form(_) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sets::{Control, NcSet, Target};
    use fitcheck_core::part::Document;
    use fitcheck_core::tolerance::Sources;
    use fitcheck_core::words::Dialogue;

    /// Makes a set, changes a text in one of its files, and runs it again.
    #[track_caller]
    fn check(name: &str, from: &str, to: &str, expected: &str) {
        check_plan("callout,x,y,z\n25 H7,0,0,0\n20 g6,100,0,-5.5\n", (name, from, to), expected);
    }

    #[track_caller]
    fn check_plan(plan: &str, change: (&str, &str, &str), expected: &str) {
        check_target(&Target::new(Control::Tnc7, Dialogue::En), plan, change, expected);
    }

    #[track_caller]
    fn check_target(target: &Target, plan: &str, (name, from, to): (&str, &str, &str), expected: &str) {
        let document = Document::read(plan.as_bytes()).unwrap();
        let plan = document.plan(&Sources::default()).unwrap();
        let mut set = NcSet::make(&plan, target, &Sources::default()).unwrap();
        let file = set.files.iter_mut().find(|file| file.name == name).unwrap();
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        assert!(text.contains(from), "{text}");
        file.bytes = text.replace(from, to).into_bytes();
        let planned = super::super::feature::planned(&plan, target).unwrap();
        let error = run(&set.files, &planned, &Names::new(target)).map_err(|error| error.to_string());
        assert_eq!(error, Err(format!("the set failed its test run and was not written: {expected}")));
    }

    #[test]
    fn a_set_that_does_not_run_or_judges_otherwise_is_not_given_out() {
        check("FIT_MAIN.H", "Q1 = 20", "Q1 = 20.001", "F2: the verdict differs from Fitcheck's");
        check("FIT_MAIN.H", "\"g6\"", "\"g5\"", &missing_column());
        check("FIT_MAIN.H", "14 STOP", "14 M30", "1 of 2 features were measured");
        check("FIT_CHECK.H", "Q5 / 1000", "Q5 / 1000 + 0.000001", "F1: the verdict differs from Fitcheck's");
        check("FIT_CHECK.H", "22 LBL 99", "22 LBL 199", &format!("{}LBL 99 does not occur in the program", fault(17)));
    }

    #[test]
    fn limits_in_the_main_program_are_proven_as_those_of_the_tables() {
        let plan = "callout,feature,x,y,z\n25 H7,,0,0,0\n35 +0.2/0,hole,100,0,0\n";
        let check = |name, from, to| check_plan(plan, (name, from, to), "F2: the verdict differs from Fitcheck's");
        check("FIT_MAIN.H", "Q23 = 35.2", "Q23 = 35.3");
        check("FIT_MAIN.H", "Q33 = 35 ", "Q33 = 34.999999 ");
        // Neither hole nor shaft is left to what was measured before.
        check("FIT_MAIN.H", "Q2 = - 1", "Q2 = 1");
    }

    #[test]
    fn the_text_of_the_cycle_is_proven_as_limits_are() {
        let target = Target { by_text: true, ..Target::new(Control::Tnc7, Dialogue::En) };
        let plan = "callout,feature,x,y,z\n25 H7,,0,0,0\n35 +0.2/0,hole,100,0,0\n";
        let check = |name, from, to, feature: &str| {
            let expected = format!("{feature}: the verdict differs from Fitcheck's");
            check_target(&target, plan, (name, from, to), &expected);
        };
        check("FIT_MAIN.H", "\"H7\"", "\"H8\"", "F1");
        check("FIT_MAIN.H", "\"+0.2-0\"", "\"+0.3-0\"", "F2");
        // Without a tolerance there is no status, and the program stops itself.
        let change =
            ("FIT_CHECK.H", "QS1116=QS9 ;DIAMETER 1 ~\r\n    Q1115=+0", "Q1116=+Q1 ;DIAMETER 1 ~\r\n    Q1115=+0");
        let stop = r"TNC:\nc_prog\fitcheck\FIT_CHECK.H, block 55, FN 14: ERROR= 1004: the program stopped itself with error 1004";
        check_target(&target, plan, change, stop);
    }

    fn fault(block: u32) -> String {
        format!(r"TNC:\nc_prog\fitcheck\FIT_CHECK.H, block {block}, FN 9: IF +0 EQU +0 GOTO LBL 99: ")
    }

    fn missing_column() -> String {
        let columns =
            "d9, e8, f7, g6, h5, h6, h7, h8, h9, h11, js5, js6, js13, js14, k5, k6, m5, m6, n6, p6, r6, s6, s7";
        format!(
            "TNC:\\nc_prog\\fitcheck\\FIT_CHECK.H, block 14, FN 28: TABREAD Q4 = +Q22/QS1 ;UPPER DEVIATION, UM: table \
             FIT_SHAFT.TAB has no column g5; its columns are NR, BEREICH, {columns}"
        )
    }
}
