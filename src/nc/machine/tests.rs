//! Every fault, remark, pause and error of files is said in both languages.

use std::sync::Arc;

use super::*;
use crate::control::mask::{MaskError, RenderError};
use crate::control::table::{Located, Place, TableFault, WriteError};
use crate::control::variables::Parameter;
use crate::message::Say;
use crate::nc::program::{LabelFault, ProgramError, Target};
use crate::probing::cycle::CycleError;
use crate::probing::simulated::WorkpieceError;
use crate::words::{Language, Words};

#[track_caller]
fn check(what: &(impl Say + std::fmt::Display)) {
    assert_eq!(Words::new(Language::En).told(what), what.to_string());
    let dutch = Words::new(Language::Nl).told(what);
    assert!(!dutch.contains("machine-"), "{dutch}");
}

fn path() -> NcPath {
    NcPath::new("a.h").unwrap()
}

#[test]
fn every_fault_is_said() {
    let (parameter, table, column) = (Parameter::q(1234), || "own.tab".to_owned(), || "H7".to_owned());
    let place = Place { file: Arc::from("own.tab"), line: 1234, column: 5 };
    let workpiece = WorkpieceError { what: "diameter", given: -1.0, least: 0.001, most: 1.0 };
    let missing = CycleError::NoSuchParameter { cycle: "421", parameter: "Q1".to_owned(), known: "Q273".to_owned() };
    let render = RenderError::Undefined { line: 1, column: 2, name: "Q1".to_owned() };
    for kind in [
        FaultKind::UsedUp(UsedUp::Blocks(12_345)),
        FaultKind::TextTooLong { length: 1234, most: 255 },
        FaultKind::UnknownBlock,
        FaultKind::UnknownCycle { cycle: "431".to_owned(), known: "421, 422".to_owned() },
        FaultKind::Broken { what: "END PGM" },
        FaultKind::NoProgram { path: path(), error: ProgramError::Empty },
        FaultKind::Label(LabelFault::Missing { label: Target::Number(12_345) }),
        FaultKind::NoLabel { parameter, value: "1.5".to_owned() },
        FaultKind::Undefined(parameter),
        FaultKind::NoParameter(parameter),
        FaultKind::NotNumber(parameter),
        FaultKind::NotText(parameter),
        FaultKind::DivisionByZero,
        FaultKind::NegativeRoot(-1234.5),
        FaultKind::NoResult { function: "LN", value: 0.0 },
        FaultKind::BeyondRange(12_345_678_901.0),
        FaultKind::NotWhole { what: "BEG", value: -1234.5 },
        FaultKind::BehindText { length: 1234, from: 1235 },
        FaultKind::NoNumberInText { parameter, text: "x".to_owned() },
        FaultKind::UnknownSystemText { id: 10_321.0, number: 99.0 },
        FaultKind::Path(PathError::Empty),
        FaultKind::Store(StoreError::ReadOnly),
        FaultKind::NoTable,
        FaultKind::Table(Box::new(Located { what: TableFault::Empty, place })),
        FaultKind::NoColumn { table: table(), column: column(), columns: "NR, H8".to_owned() },
        FaultKind::NoRow { table: table(), row: 12_345, last: 12_344 },
        FaultKind::NoRows(table()),
        FaultKind::EmptyCell { table: table(), row: 1234, column: column() },
        FaultKind::NoNumberInCell { table: table(), row: 1234, column: column(), cell: "x".to_owned() },
        FaultKind::Touches { table: table(), row: 1234, column: column() },
        FaultKind::TableWrite { table: table(), error: WriteError::ReadsOtherwise },
        FaultKind::Mask { mask: path(), error: Box::new(MaskError::Empty) },
        FaultKind::Render { mask: path(), error: Box::new(render) },
        FaultKind::Programmed(1072),
        FaultKind::NoCycleParameter { cycle: "421", parameter },
        FaultKind::CycleParameterTwice { cycle: "421", parameter },
        FaultKind::Cycle { cycle: "421", error: Box::new(missing) },
        FaultKind::Workpiece(Box::new(workpiece)),
        FaultKind::Inch,
    ] {
        check(&kind);
        let place = BlockPlace { program: path(), block: 3 };
        for number in [None, Some(12_345)] {
            let text = "Q1 = Q2".to_owned();
            check(&Fault { place: place.clone(), number, line: 12_345, text, kind: Box::new(kind.clone()) });
        }
    }
}

#[test]
fn every_budget_is_said() {
    check(&UsedUp::Blocks(12_345));
    for used in [
        UsedUp::LabelCalls,
        UsedUp::ProgramCalls,
        UsedUp::Windows,
        UsedUp::Outputs,
        UsedUp::Output,
        UsedUp::Cycles,
        UsedUp::Path,
        UsedUp::Files,
        UsedUp::FileBytes,
        UsedUp::Traffic,
    ] {
        check(&used(12_345));
    }
}

#[test]
fn every_error_of_files_is_said() {
    check(&StoreError::Missing { path: path() });
    check(&StoreError::Outside { path: path() });
    check(&StoreError::NoFile { path: path() });
    check(&StoreError::TooLarge { path: path() });
    check(&StoreError::ReadOnly);
    check(&StoreError::System { path: path(), reason: "permission denied".to_owned() });
}

#[test]
fn every_remark_and_pause_is_said() {
    check(&Remark::Skipped);
    check(&Remark::EndedWithin { function: 30 });
    check(&Remark::GivenWins { parameter: Parameter::q(1), value: "25.5".to_owned() });
    check(&Remark::NotWritten { path: path() });
    check(&Remark::NotSaved { path: path(), reason: "no".to_owned() });
    check(&Remark::Full { path: path(), kilobytes: 12_345 });
    check(&Remark::TableWritten { path: path() });
    check(&Remark::ContactsLeft { count: 12_345, used: 1234 });
    check(&Remark::OtherProbe { tool: "5".to_owned(), probe: 12_345 });
    check(&Pause::Stop);
    check(&Pause::OptionalStop);
    check(&Pause::Breakpoint);
    check(&Pause::Log);
}
