//! The plan of a part as a table, without a window: typing, pasting, sorting, undo, faults, balloons and the picture.

use fitcheck::session::{PartsAction, WalkField};
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck::exchange::{ImportInputs, read_plan};
use fitcheck::message::Message;
use fitcheck::part::{Column, Document, Draft, DraftFeature, HeadField, Spot};
use fitcheck::report::image::Image;
use fitcheck::session::action::Part;
use fitcheck::session::parts::{PartPicture, PartsView, PictureState, PlanCommand, PlanField};
use fitcheck::session::{Action, Command, Effect, Field, Page, PartsCommand, Purpose, Session, Step};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};

fn apply(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

fn plan(session: &mut Session, command: PlanCommand) -> Vec<Effect> {
    apply(session, PartsCommand::Plan(command))
}

fn act(session: &mut Session, action: Action) -> Vec<Effect> {
    let command = action.command(session).unwrap_or_else(|| panic!("{action:?} is not possible"));
    apply(session, command)
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn opened(text: &str) -> Session {
    opened_at(text, "/plans/plate.csv")
}

fn opened_at(text: &str, path: &str) -> Session {
    let mut session = Session::new(Language::En);
    apply(&mut session, Command::OpenPage(Page::Parts));
    apply(&mut session, PartsCommand::Show(PartsView::Plan));
    let document = Document::read(text.as_bytes()).unwrap();
    plan(&mut session, PlanCommand::Read { path: PathBuf::from(path), result: Ok(Box::new(document)) });
    session
}

fn draft(session: &Session) -> &Draft {
    session.parts().document.draft()
}

/// What a column has, from above.
fn column(session: &Session, column: Column) -> Vec<String> {
    draft(session).rows.iter().map(|row| row.cell(column).text.clone()).collect()
}

fn go(session: &mut Session, row: usize, column: Column) {
    plan(session, PlanCommand::Go(row, column, false));
}

/// Types over the cell, sign by sign, as a keyboard does, and goes down.
fn type_cell(session: &mut Session, text: &str) {
    let signs: Vec<char> = text.chars().collect();
    plan(session, PlanCommand::Edit(Some(signs[0].to_string())));
    for end in 2..=signs.len() {
        plan(session, PlanCommand::Type(PlanField::Cell, signs[..end].iter().collect()));
    }
    plan(session, PlanCommand::Take(Some(Step::Down)));
}

const PLATE: &str = "number;name;callout;x;y;z\n1;A1;25 H7;40;30;-8\n2;A2;20 H7;60;30;-8\n3;A10;16 H7;80;30;-8\n";

#[test]
fn a_word_typed_into_a_cell_is_one_change() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Callout);
    type_cell(&mut session, "30 H7");
    assert_eq!(column(&session, Column::Callout), ["30 H7", "20 H7", "16 H7"]);
    assert_eq!(session.parts().sheet.at(), (1, Column::Callout));
    type_cell(&mut session, "18 H8");
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Callout), ["30 H7", "20 H7", "16 H7"]);
    assert_eq!(session.parts().sheet.at(), (1, Column::Callout), "the keys are where something changed");
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Callout), ["25 H7", "20 H7", "16 H7"]);
    assert!(!session.can(PartsAction::UndoPlan));
    assert!(!session.parts().document.is_unsaved(), "back to what the file holds, with its lines");
    act(&mut session, PartsAction::RedoPlan.into());
    act(&mut session, PartsAction::RedoPlan.into());
    assert_eq!(column(&session, Column::Callout), ["30 H7", "18 H8", "16 H7"]);
}

#[test]
fn a_feature_is_checked_while_it_is_typed_and_escape_takes_it_back() {
    let mut session = opened(PLATE);
    go(&mut session, 1, Column::Callout);
    plan(&mut session, PlanCommand::Edit(None));
    assert_eq!(session.text(Field::from(PlanField::Cell)), "20 H7");
    plan(&mut session, PlanCommand::Type(PlanField::Cell, "20 H".to_owned()));
    let document = &session.parts().document;
    assert_eq!(document.findings().len(), 1);
    assert_eq!(document.findings()[0].spot, Spot::Feature(1, Some(Column::Callout)));
    assert!(document.plan().is_none());
    // The others keep their limits.
    assert!(document.feature(0).is_some() && document.feature(1).is_none() && document.feature(2).is_some());
    plan(&mut session, PlanCommand::Leave);
    assert_eq!(session.text(Field::from(PlanField::Cell)), "20 H7");
    assert!(session.parts().document.findings().is_empty());
    assert!(!session.can(PartsAction::UndoPlan) && !session.can(PartsAction::RedoPlan));
    // Typed back to what it was, it is no change, either.
    plan(&mut session, PlanCommand::Edit(Some("2".to_owned())));
    plan(&mut session, PlanCommand::Type(PlanField::Cell, "20 H7".to_owned()));
    plan(&mut session, PlanCommand::Take(None));
    assert!(!session.can(PartsAction::UndoPlan));
}

#[test]
fn typing_below_the_last_feature_begins_the_next_one() {
    let mut session = opened(PLATE);
    go(&mut session, 2, Column::Name);
    plan(&mut session, PlanCommand::Move(Step::Down, false));
    assert_eq!(session.parts().sheet.at(), (3, Column::Name));
    type_cell(&mut session, "A11");
    assert_eq!(column(&session, Column::Name), ["A1", "A2", "A10", "A11"]);
    assert_eq!(session.parts().sheet.at(), (4, Column::Name));
    plan(&mut session, PlanCommand::Move(Step::Down, false));
    assert_eq!(session.parts().sheet.at(), (4, Column::Name), "there is one row for the next feature");
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Name).len(), 3);
}

#[test]
fn a_block_of_a_spreadsheet_is_pasted_as_one_change_and_adds_rows() {
    let mut session = opened(PLATE);
    go(&mut session, 1, Column::Name);
    // Excel and LibreOffice end lines with CR LF and LF; a cell with a line end has quotation marks.
    plan(
        &mut session,
        PlanCommand::Paste("B1\tdiameter\t30 H7\r\nB2\twidth\t12 H8\r\n\"B \"\"3\"\"\"\t\t10 H7\r\n".to_owned()),
    );
    assert_eq!(column(&session, Column::Name), ["A1", "B1", "B2", "B \"3\""]);
    assert_eq!(column(&session, Column::Kind), ["", "diameter", "width", ""]);
    assert_eq!(column(&session, Column::Callout), ["25 H7", "30 H7", "12 H8", "10 H7"]);
    assert_eq!(column(&session, Column::X), ["40", "60", "80", ""]);
    assert_eq!(session.parts().sheet.selected_rows(), 1..=3);
    // The same block comes out again.
    let effects = act(&mut session, PartsAction::CopyPlanCells.into());
    let text = "B1\tdiameter\t30 H7\nB2\twidth\t12 H8\n\"B \"\"3\"\"\"\t\t10 H7";
    assert_eq!(effects, [Effect::Copy(text.to_owned())]);
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Name), ["A1", "A2", "A10"]);
    assert!(!session.can(PartsAction::UndoPlan));
}

#[test]
fn a_block_with_names_of_columns_finds_them_also_where_they_are_not_shown() {
    let mut session = opened(PLATE);
    go(&mut session, 3, Column::X);
    plan(&mut session, PlanCommand::Paste("callout\tname\taxis\tkind\n12 H8\tN1\tY\twidth\n".to_owned()));
    let row = &draft(&session).rows[3];
    let texts = [Column::Callout, Column::Name, Column::Axis, Column::Kind].map(|column| row.text(column).unwrap());
    assert_eq!(texts, ["12 H8", "N1", "Y", "width"]);
    assert!(session.parts().sheet.columns.contains(&Column::Axis));
}

#[test]
fn what_is_pasted_and_finds_no_place_is_told() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Z);
    plan(&mut session, PlanCommand::Paste("-1\t2\t3\n".to_owned()));
    assert_eq!(column(&session, Column::Z)[0], "-1");
    assert!(said(&session.notices()[0].message).starts_with("2 pasted columns were skipped"));
    let many = "12\n".repeat(1_200);
    plan(&mut session, PlanCommand::Paste(many));
    assert_eq!(draft(&session).rows.len(), 1_000);
    assert!(said(&session.notices()[1].message).starts_with("200 pasted rows were skipped"));
}

#[test]
fn a_pasted_header_with_a_name_that_no_plan_has_is_a_header_all_the_same() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Name);
    plan(&mut session, PlanCommand::Paste("name\tcolour\tcallout\nN1\tred\t12 H8\n".to_owned()));
    let row = &draft(&session).rows[0];
    assert_eq!([Column::Name, Column::Callout].map(|column| row.text(column).unwrap()), ["N1", "12 H8"]);
    assert_eq!(said(&session.notices()[0].message), "Pasted columns that a plan does not have were left out: colour");
    // A column without a name that holds something is told all the same.
    plan(&mut session, PlanCommand::Paste("name\tcolour\tcallout\t\nN1\tred\t12 H8\tx\n".to_owned()));
    let told: Vec<String> = session.notices().iter().map(|notice| said(&notice.message)).collect();
    assert!(told.iter().any(|text| text.starts_with("One pasted column was left out")), "{told:?}");
}

#[test]
fn a_change_that_was_taken_back_can_be_made_again_after_a_cell_was_left_with_escape() {
    let mut session = opened(PLATE);
    act(&mut session, PartsAction::SortPlan.into());
    go(&mut session, 0, Column::Name);
    type_cell(&mut session, "B");
    act(&mut session, PartsAction::UndoPlan.into());
    go(&mut session, 1, Column::Callout);
    plan(&mut session, PlanCommand::Edit(Some("9".to_owned())));
    assert!(!session.can(PartsAction::RedoPlan), "not while something is typed");
    plan(&mut session, PlanCommand::Leave);
    act(&mut session, PartsAction::RedoPlan.into());
    assert_eq!(column(&session, Column::Name)[0], "B");
    // Typed back to what it was, too; something else that is typed is a change.
    act(&mut session, PartsAction::UndoPlan.into());
    go(&mut session, 1, Column::Callout);
    type_cell(&mut session, "20 H7");
    assert!(session.can(PartsAction::RedoPlan));
    type_cell(&mut session, "21 H7");
    assert!(!session.can(PartsAction::RedoPlan));
}

#[test]
fn names_that_look_like_formulas_are_copied_and_pasted_as_they_are() {
    let mut session = opened("name;callout;axis\n-A;25 H7;-Z\nB;20 H7;\n");
    plan(&mut session, PlanCommand::Go(0, Column::Name, false));
    let effects = act(&mut session, PartsAction::CopyPlanCells.into());
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    assert_eq!(text, "'-A", "a spreadsheet does not compute it");
    go(&mut session, 1, Column::Name);
    plan(&mut session, PlanCommand::Paste(text.clone()));
    go(&mut session, 2, Column::Name);
    plan(&mut session, PlanCommand::Paste("'=1+1\n'plain\n".to_owned()));
    assert_eq!(column(&session, Column::Name), ["-A", "-A", "=1+1", "'plain"]);
}

#[test]
fn an_empty_clipboard_changes_nothing_and_adds_no_feature() {
    let mut session = opened(PLATE);
    for row in [1, 3] {
        go(&mut session, row, Column::Callout);
        for text in ["", "\n", "\r\n"] {
            plan(&mut session, PlanCommand::Paste(text.to_owned()));
        }
    }
    assert_eq!(column(&session, Column::Callout), ["25 H7", "20 H7", "16 H7"]);
    assert!(!session.can(PartsAction::UndoPlan));
    // Empty rows of a block empty cells, and are no features below the last one.
    go(&mut session, 2, Column::Name);
    plan(&mut session, PlanCommand::Paste("N\t\n\t\n\t\n".to_owned()));
    assert_eq!(column(&session, Column::Name), ["A1", "A2", "N"]);
}

#[test]
fn a_word_begun_below_the_last_feature_and_erased_leaves_no_row() {
    let mut session = opened(PLATE);
    go(&mut session, 3, Column::Name);
    plan(&mut session, PlanCommand::Edit(Some("x".to_owned())));
    assert_eq!(draft(&session).rows.len(), 4);
    plan(&mut session, PlanCommand::Type(PlanField::Cell, String::new()));
    plan(&mut session, PlanCommand::Type(PlanField::Cell, "y".to_owned()));
    plan(&mut session, PlanCommand::Type(PlanField::Cell, String::new()));
    plan(&mut session, PlanCommand::Take(None));
    assert_eq!((draft(&session).rows.len(), session.parts().document.faults()), (3, 0));
    assert!(!session.can(PartsAction::UndoPlan) && !session.parts().document.is_unsaved());
}

#[test]
fn a_header_may_have_empty_cells_and_a_name_that_it_has_twice_is_told() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Number);
    plan(&mut session, PlanCommand::Paste("name\tcallout\t\nZ\t10 H7\t\n".to_owned()));
    assert_eq!((&*column(&session, Column::Number)[0], &*column(&session, Column::Name)[0]), ("1", "Z"));
    assert_eq!(session.notices().len(), 0, "nothing was in it");
    plan(&mut session, PlanCommand::Paste("name\t\tcallout\nY\tlost\t12 H7\n".to_owned()));
    assert_eq!((&*column(&session, Column::Name)[0], &*column(&session, Column::Callout)[0]), ("Y", "12 H7"));
    assert!(said(&session.notices()[0].message).ends_with("the first row has no name above it"));
    plan(&mut session, PlanCommand::Paste("name\tname\nX\tW\n".to_owned()));
    assert_eq!(column(&session, Column::Name)[0], "X");
    assert!(said(&session.notices()[1].message).contains("names name more than once"));
}

#[test]
fn features_without_a_name_keep_what_they_are_called_when_their_rows_get_other_places() {
    let nameless = "callout;x\n25 H7;3\n20 H7;1\n16 H7;2\n";
    let names = |session: &Session| -> Vec<String> {
        let rows = draft(session).rows.iter().enumerate();
        let called = rows.filter_map(|(at, row)| {
            let name = &session.parts().document.feature(at)?.name;
            Some(format!("{name} {}", row.text(Column::X).unwrap_or("-")))
        });
        called.collect()
    };
    let mut session = opened(nameless);
    assert_eq!(names(&session), ["F1 3", "F2 1", "F3 2"]);
    go(&mut session, 0, Column::X);
    act(&mut session, PartsAction::SortPlan.into());
    assert_eq!(names(&session), ["F2 1", "F3 2", "F1 3"]);
    let mut session = opened(nameless);
    go(&mut session, 0, Column::X);
    act(&mut session, PartsAction::MovePlanRows(Step::Down).into());
    assert_eq!(names(&session), ["F2 1", "F1 3", "F3 2"]);
    let mut session = opened(nameless);
    go(&mut session, 1, Column::X);
    act(&mut session, PartsAction::InsertPlanRow.into());
    assert_eq!(names(&session), ["F1 3", "F2 1", "F3 2"]);
    // The new one has a name that no other one has.
    assert_eq!(column(&session, Column::Name), ["F1", "F4", "F2", "F3"]);
    act(&mut session, PartsAction::UndoPlan.into());
    go(&mut session, 0, Column::X);
    act(&mut session, PartsAction::DeletePlanRows.into());
    assert_eq!(names(&session), ["F2 1", "F3 2"]);
    go(&mut session, 2, Column::Callout);
    type_cell(&mut session, "12 H7");
    assert_eq!(column(&session, Column::Name), ["F2", "F3", "F4"]);
}

#[test]
fn one_cell_fills_a_block_and_delete_empties_it() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::X);
    for step in [Step::Down, Step::Down, Step::Right] {
        plan(&mut session, PlanCommand::Move(step, true));
    }
    plan(&mut session, PlanCommand::Paste("7,5".to_owned()));
    assert_eq!(column(&session, Column::X), ["7,5"; 3]);
    assert_eq!(column(&session, Column::Y), ["7,5"; 3]);
    act(&mut session, PartsAction::EmptyPlanCells.into());
    assert_eq!(column(&session, Column::Y), [""; 3]);
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Y), ["7,5"; 3]);
}

#[test]
fn rows_are_inserted_deleted_moved_sorted_and_numbered() {
    let mut session = opened(PLATE);
    let names = |session: &Session| column(session, Column::Name).join(" ");
    go(&mut session, 0, Column::Name);
    act(&mut session, PartsAction::MovePlanRows(Step::Down).into());
    assert_eq!((names(&session).as_str(), session.parts().sheet.at().0), ("A2 A1 A10", 1));
    act(&mut session, PartsAction::MovePlanRows(Step::Down).into());
    act(&mut session, PartsAction::MovePlanRows(Step::Down).into());
    assert_eq!(names(&session), "A2 A10 A1", "it stops at the end");
    // As people count: A2 before A10. Once more, the other way round.
    act(&mut session, PartsAction::SortPlan.into());
    assert_eq!(names(&session), "A1 A2 A10");
    act(&mut session, PartsAction::SortPlan.into());
    assert_eq!(names(&session), "A10 A2 A1");
    act(&mut session, PartsAction::RenumberPlan.into());
    assert_eq!(column(&session, Column::Number), ["1", "2", "3"]);
    go(&mut session, 1, Column::Name);
    act(&mut session, PartsAction::InsertPlanRow.into());
    assert_eq!(names(&session), "A10  A2 A1");
    plan(&mut session, PlanCommand::Move(Step::Down, true));
    act(&mut session, PartsAction::DeletePlanRows.into());
    assert_eq!(names(&session), "A10 A1");
    // Two rows at once.
    plan(&mut session, PlanCommand::Go(0, Column::Name, false));
    plan(&mut session, PlanCommand::Go(1, Column::Name, true));
    act(&mut session, PartsAction::MovePlanRows(Step::Up).into());
    assert_eq!(names(&session), "A10 A1");
    for _ in 0..20 {
        if session.can(PartsAction::UndoPlan) {
            act(&mut session, PartsAction::UndoPlan.into());
        }
    }
    assert_eq!(names(&session), "A1 A2 A10");
}

#[test]
fn numbers_are_sorted_by_their_value_and_empty_cells_are_last() {
    let mut session = opened("name;callout;x\nA;25 H7;10\nB;25 H7;9,5\nC;25 H7;\nD;25 H7;-20\nE;25 H7;9.25\n");
    go(&mut session, 0, Column::X);
    act(&mut session, PartsAction::SortPlan.into());
    assert_eq!(column(&session, Column::Name), ["D", "E", "B", "A", "C"]);
    act(&mut session, PartsAction::SortPlan.into());
    assert_eq!(column(&session, Column::Name), ["A", "B", "E", "D", "C"]);
}

const FAULTY: &str = "fitcheck_plan = 1
part = \"Plate\"
material = \"unobtainium\"
travel_x = [0, 500]
colour = \"red\"

[[feature]]
name = \"A1\"
callout = \"25 Q7\"

[[feature]]
name = \"A1\"
callout = \"25 H7\"
x = 900
y = 0
z = -8

[[feature]]
name = \"P1\"
kind = \"face\"
callout = \"10 h9\"
shade = 3
";

#[test]
fn a_plan_with_every_kind_of_mistake_opens_and_shows_all_of_them() {
    let mut session = opened_at(FAULTY, "/plans/plate.toml");
    let document = &session.parts().document;
    let spots: Vec<Spot> = document.findings().iter().map(|finding| finding.spot).collect();
    assert_eq!(
        spots,
        [
            Spot::Head(HeadField::Material),
            Spot::Feature(0, Some(Column::Callout)),
            Spot::Feature(1, Some(Column::Name)),
            Spot::Feature(1, Some(Column::X)),
            Spot::Feature(2, Some(Column::Axis)),
        ]
    );
    assert_eq!(document.problems.len(), 2, "what a plan has no place for");
    assert!(document.head_error(HeadField::Material).is_some());
    assert!(document.is_wrong(0) && document.is_wrong(1) && document.is_wrong(2));
    // Axis is shown, although nothing is written in it.
    assert!(session.parts().sheet.columns.contains(&Column::Axis));
    // F4 goes from one to the next, and round again.
    act(&mut session, PartsAction::NextFinding.into());
    let mut seen = vec![session.parts().sheet.at()];
    for _ in 0..3 {
        act(&mut session, PartsAction::NextFinding.into());
        seen.push(session.parts().sheet.at());
    }
    assert_eq!(seen, [(0, Column::Callout), (1, Column::Name), (1, Column::X), (2, Column::Axis)]);
    let effects = act(&mut session, PartsAction::NextFinding.into());
    assert_eq!(effects, [Effect::Focus(Field::from(PlanField::Head(HeadField::Material)))]);
    let effects = plan(&mut session, PlanCommand::GoToFinding(3));
    // What is typed next goes there.
    assert_eq!((effects.as_slice(), session.parts().sheet.at()), ([Effect::FocusTable].as_slice(), (1, Column::X)));
}

/// Two features that are right, and a third one.
const THREE: &str = "fitcheck_plan = 1
[[feature]]
name = \"A\"
callout = \"25 H7\"
[[feature]]
name = \"B\"
callout = \"25 H7\"
[[feature]]
name = \"C\"
callout = \"20 g6\"
";

#[test]
fn a_plan_that_could_not_be_read_whole_measures_nothing_until_the_rest_is_left_out() {
    for (text, features) in [
        (THREE.replace("fitcheck_plan = 1", "fitcheck_plan = 2"), 3),
        (THREE.replace("name = \"C\"", "rule = [1]\nname = \"C\""), 3),
        (THREE.replace("name = \"C\"", "u_mu = 9\nname = \"C\""), 3),
        (THREE.replace("[[feature]]\nname = \"C\"", "[[featur]]\nname = \"C\""), 2),
        (format!("{THREE}[[feature]\nname = \"D\"\ncallout = \"30 H7\"\n"), 3),
        ("name,callout,x,y,z\nA,25 H7,40,5,30,-8\n".to_owned(), 1),
    ] {
        let mut session = opened_at(&text, "/plans/plate.toml");
        let document = &session.parts().document;
        assert_eq!((document.findings().len(), document.draft().rows.len()), (0, features), "{text}");
        assert_eq!(document.faults(), document.problems.len(), "{text}");
        assert!(document.plan().is_none() && 0 < document.faults(), "{text}");
        // It is not lost by the way, either.
        assert!(!session.can(PartsAction::SavePlan(0)) && !session.can(PartsAction::SavePlan(1)), "{text}");
        let count = document.faults();
        apply(&mut session, PartsCommand::Show(PartsView::Walk));
        assert!(!session.can(PartsAction::BeginPart) && !session.can(PartsAction::WatchFolder), "{text}");
        apply(&mut session, PartsCommand::Show(PartsView::Plan));
        act(&mut session, PartsAction::LeaveOutOfPlan.into());
        let notice = session.notices().last().unwrap();
        assert!(said(&notice.message).contains("left out of the plan"), "{}", said(&notice.message));
        assert_eq!(notice.details.len(), count);
        // The file has it still, so that this plan is one that no file holds.
        assert!(session.parts().document.plan().is_some() && session.parts().document.is_unsaved(), "{text}");
        assert!(session.can(PartsAction::SavePlan(0)) && !session.can(PartsAction::LeaveOutOfPlan), "{text}");
        apply(&mut session, PartsCommand::Show(PartsView::Walk));
        assert!(session.can(PartsAction::BeginPart) && session.can(PartsAction::WatchFolder), "{text}");
    }
}

#[test]
fn what_a_plan_of_another_tool_leaves_out_is_told_when_it_is_opened() {
    // A diameter, and the roundness of a second characteristic.
    let text = "K0100/0 2\nK1001/1 P\nK2001/1 1\nK2002/1 A\nK2101/1 25\nK2110/1 25\nK2111/1 25.021\nK2142/1 mm\n\
                K2001/2 2\nK2002/2 ROUND\nK2004/2 0\nK2009/2 104\nK2101/2 0\nK2110/2 0\nK2111/2 0.01\nK2142/2 mm\n";
    let sources = Sources::default();
    let given = ImportInputs::new(&sources, jiff::civil::DateTime::MIN);
    let document = read_plan("a.dfq", text.as_bytes(), given).unwrap();
    let mut session = Session::new(Language::En);
    apply(&mut session, Command::OpenPage(Page::Parts));
    plan(&mut session, PlanCommand::Read { path: "/plans/a.dfq".into(), result: Ok(Box::new(document)) });
    let notice = &session.notices()[0];
    assert_eq!(said(&notice.message), "a.dfq is open, but the plan leaves out one thing that the file has");
    assert!(said(&notice.details[0]).contains("ROUND"), "{}", said(&notice.details[0]));
    assert_eq!((notice.details.len(), draft(&session).rows.len()), (1, 1));
}

#[test]
fn a_fault_of_the_file_leads_to_the_feature_that_it_stands_in_or_behind() {
    let text =
        THREE.replace("name = \"B\"", "u_mu = 9\nname = \"B\"").replace("name = \"C\"", "shade = 1\nname = \"C\"");
    let mut session = opened_at(&text, "/plans/plate.toml");
    for (place, row) in [(1, 2), (0, 1)] {
        plan(&mut session, PlanCommand::GoToProblem(place));
        assert_eq!(session.parts().sheet.at().0, row);
    }
}

/// The actions that keys of the parts page do now.
fn heard(session: &Session, part: Option<Part>, is_typing: bool) -> Vec<Action> {
    session.keys(part, is_typing).into_iter().map(|(_, action)| action).collect()
}

#[test]
fn keys_of_the_table_do_nothing_where_it_is_not_shown_or_a_field_of_the_part_is_typed_into() {
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Callout);
    type_cell(&mut session, "30 H7");
    plan(&mut session, PlanCommand::Undo);
    plan(&mut session, PlanCommand::Go(1, Column::Name, false));
    type_cell(&mut session, "B");
    let of_rows = [PartsAction::InsertPlanRow, PartsAction::DeletePlanRows, PartsAction::MovePlanRows(Step::Up)];
    let of_rows = of_rows.map(Action::from);
    let undo = PartsAction::UndoPlan.into();
    let table = heard(&session, Some(fitcheck::session::focused::PLAN), false);
    assert!(of_rows.iter().all(|action| table.contains(action)) && table.contains(&undo));
    let field = heard(&session, None, true);
    assert!(!of_rows.iter().any(|action| field.contains(action)), "{field:?}");
    apply(&mut session, PartsCommand::Show(PartsView::Walk));
    let walk = heard(&session, None, false);
    assert!(!walk.contains(&undo) && !of_rows.iter().any(|action| walk.contains(action)), "{walk:?}");
    assert!(!session.can(PartsAction::UndoPlan) && !session.can(PartsAction::RedoPlan));
}

#[test]
fn fields_of_the_part_are_one_change_each() {
    let mut session = opened(PLATE);
    for text in ["P", "Pl", "Plate"] {
        plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::Part), text.to_owned()));
    }
    plan(&mut session, PlanCommand::SettleHead);
    plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::TravelX), "0 50".to_owned()));
    // The third feature is at X 80.
    let far = |session: &Session| session.parts().document.findings().len();
    assert_eq!(far(&session), 2);
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!((far(&session), draft(&session).text(HeadField::Part)), (0, Some("Plate")));
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(draft(&session).text(HeadField::Part), None);
}

/// Saves the plan in a format of the list: what the file gets.
fn save(session: &mut Session, format: usize, path: &str) -> String {
    act(session, PartsAction::SavePlan(format).into());
    apply(session, Command::TypePath(path.to_owned()));
    let effects = apply(session, Command::Confirm);
    let [Effect::ForDialog(number, effect)] = effects.as_slice() else { panic!("{effects:?}") };
    let Effect::Save(path, content) = effect.as_ref() else { panic!("{effect:?}") };
    let answer = Command::Saved { path: path.clone(), result: Ok(()) };
    apply(session, Command::Answered(*number, Box::new(answer)));
    String::from_utf8(content.bytes().unwrap()).unwrap()
}

#[test]
fn a_plan_as_csv_is_a_copy_where_it_has_less_and_says_what_is_left_out() {
    let mut session = opened_at(&format!("picture = \"a.png\"\n{THREE}"), "/plans/plate.toml");
    plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::Drawing), "D1".to_owned()));
    let text = save(&mut session, 1, "/plans/plate.csv");
    assert!(!text.contains("D1") && text.contains("25 H7"), "{text}");
    let document = &session.parts().document;
    assert_eq!((document.path(), document.is_unsaved()), (Some(std::path::Path::new("/plans/plate.toml")), true));
    let details: Vec<String> = session.notices().last().unwrap().details.iter().map(said).collect();
    assert_eq!(
        details,
        ["The file is a copy: CSV has only the features, and drawing, picture of the part is left out"]
    );
    assert_eq!(apply(&mut session, Command::AskToLeave), [], "it is asked first");
    // One that has nothing but features is the plan itself, and so is one as TOML.
    let mut session = opened(PLATE);
    go(&mut session, 0, Column::Callout);
    type_cell(&mut session, "30 H7");
    save(&mut session, 1, "/plans/other.csv");
    assert!(!session.parts().document.is_unsaved() && session.notices().last().unwrap().details.is_empty());
    plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::Part), "Plate".to_owned()));
    assert!(save(&mut session, 0, "/plans/plate.toml").contains("part = \"Plate\""));
    assert!(!session.parts().document.is_unsaved());
}

#[test]
fn comments_of_a_plan_are_told_as_lost_before_it_is_saved_and_when_it_is() {
    let text = format!("# the flange\n{THREE}").replace("\"20 g6\"", "\"20 g6\" # a pin") + "remark = '# none \" #'\n";
    let text = text + "number = \"\"\"\n# \\\" none\"\"\"\n";
    let mut session = opened_at(&text, "/plans/plate.toml");
    assert_eq!(session.parts().document.comments, 2, "{text}");
    save(&mut session, 0, "/plans/plate.toml");
    let details: Vec<String> = session.notices().last().unwrap().details.iter().map(said).collect();
    assert_eq!(details, ["2 comments were removed from plate.toml: a plan is written without comments"]);
    assert_eq!(session.parts().document.comments, 0);
}

fn dots() -> Arc<PartPicture> {
    let file = Image::read("plate.svg", b"<svg width=\"2\" height=\"1\"/>").unwrap();
    Arc::new(PartPicture { size: [2, 1], dots: vec![255; 8], file })
}

#[test]
fn the_picture_is_asked_for_once_its_name_is_typed_and_late_answers_change_nothing() {
    let mut session = opened_at("fitcheck_plan = 1\n[[feature]]\ncallout = \"25 H7\"\n", "/plans/plate.toml");
    for text in ["p", "plate.png"] {
        let effects = plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::Picture), text.to_owned()));
        assert_eq!(effects, []);
    }
    let effects = plan(&mut session, PlanCommand::SettleHead);
    let path = PathBuf::from("/plans/plate.png");
    assert_eq!(effects, [Effect::ReadPicture(path.clone())]);
    assert_eq!(session.parts().sight(), Some(PictureState::Awaited));
    let late = PlanCommand::PictureRead { path: "/plans/other.png".into(), result: Ok(dots()) };
    plan(&mut session, late);
    assert_eq!(session.parts().sight(), Some(PictureState::Awaited));
    plan(&mut session, PlanCommand::PictureRead { path, result: Ok(dots()) });
    assert_eq!(session.parts().sight(), Some(PictureState::Seen(dots())));
    // Another folder is none of the plan's.
    for name in ["../plate.png", "/etc/plate.png", "c:plate.png", "\\\\server\\plate.png"] {
        plan(&mut session, PlanCommand::Type(PlanField::Head(HeadField::Picture), name.to_owned()));
        assert_eq!(plan(&mut session, PlanCommand::SettleHead), []);
        let Some(PictureState::Refused(why)) = session.parts().sight() else { panic!("{name} is read") };
        assert!(said(&why).contains("is not the name of a file beside the plan"), "{}", said(&why));
    }
    apply(&mut session, Command::OpenDialog(Purpose::OpenPicture));
    plan(&mut session, PlanCommand::ChoosePicture("/elsewhere/plate.png".into()));
    assert!(said(&session.notices()[0].message).contains("is not in the plan's folder"));
}

#[test]
fn a_part_keeps_the_picture_that_its_plan_had_when_it_was_begun() {
    let text = "fitcheck_plan = 1\npicture = \"a.png\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let mut session = opened_at(text, "/plans/plate.toml");
    apply(&mut session, PartsCommand::Show(PartsView::Walk));
    act(&mut session, PartsAction::BeginPart.into());
    // Another plan with a feature of the same name is opened before the picture was read.
    let other = Document::read(text.replace("a.png", "b.png").replace("25 H7", "10 H7").as_bytes()).unwrap();
    let read = PlanCommand::Read { path: "/other/plate.toml".into(), result: Ok(Box::new(other)) };
    assert!(plan(&mut session, read).contains(&Effect::ReadPicture("/other/b.png".into())));
    plan(&mut session, PlanCommand::PictureRead { path: "/other/b.png".into(), result: Ok(dots()) });
    assert_eq!(session.parts().walk_sight(), Some(PictureState::Awaited));
    let mut own = PartPicture::clone(&dots());
    own.size = [1, 2];
    let own = Arc::new(own);
    plan(&mut session, PlanCommand::PictureRead { path: "/plans/a.png".into(), result: Ok(Arc::clone(&own)) });
    assert_eq!(session.parts().walk_sight(), Some(PictureState::Seen(own)));
    assert_eq!(session.parts().sight(), Some(PictureState::Seen(dots())), "the plan that is edited has its own");
    act(&mut session, PartsAction::NextPart.into());
    act(&mut session, PartsAction::NextPart.into());
    act(&mut session, PartsAction::BeginPart.into());
    assert_eq!(session.parts().walk_sight(), Some(PictureState::Seen(dots())));
}

#[test]
fn a_verdict_is_shown_on_the_plan_that_it_was_made_by_alone() {
    let text = "fitcheck_plan = 1\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let status = |session: &Session| session.parts().balloons()[0].status;
    let mut session = opened_at(text, "/plans/plate.toml");
    apply(&mut session, PartsCommand::Show(PartsView::Walk));
    act(&mut session, PartsAction::BeginPart.into());
    apply(&mut session, Field::from(WalkField::Value).typed("25.010".to_owned()));
    act(&mut session, PartsAction::TakeValue.into());
    assert_eq!(status(&session), Some(Status::Good));
    // Its balloon may be moved, and other limits have no verdict yet.
    plan(&mut session, PlanCommand::PlaceBalloon { row: 0, at: [0.5, 0.5], is_done: true });
    assert_eq!(status(&session), Some(Status::Good));
    go(&mut session, 0, Column::Callout);
    type_cell(&mut session, "25 H6");
    assert_eq!(status(&session), None);
    plan(&mut session, PlanCommand::Undo);
    assert_eq!(status(&session), Some(Status::Good));
    // The same feature in another plan is one of another part.
    let other = Document::read(text.as_bytes()).unwrap();
    plan(&mut session, PlanCommand::Read { path: "/other/plate.toml".into(), result: Ok(Box::new(other)) });
    apply(&mut session, Command::Discard(true));
    assert_eq!(status(&session), None);
    assert_eq!(session.parts().walk_balloons()[0].status, Some(Status::Good));
}

#[test]
fn a_balloon_is_dragged_as_one_change_and_moved_by_steps() {
    let mut session = opened(PLATE);
    for (x, is_done) in [(0.2, false), (0.3, false), (1.4, true)] {
        plan(&mut session, PlanCommand::PlaceBalloon { row: 1, at: [x, 0.25], is_done });
    }
    let at = |session: &Session| session.parts().balloons()[1].at;
    assert_eq!(at(&session), Some([1.0, 0.25]), "it stays on the picture");
    plan(&mut session, PlanCommand::NudgeBalloon(1, Step::Left));
    assert_eq!(at(&session), Some([0.995, 0.25]));
    act(&mut session, PartsAction::UndoPlan.into());
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(at(&session), None);
    assert!(!session.can(PartsAction::UndoPlan));
    // Where balloons are is on the picture, and in the table once every column is shown.
    assert!(!session.parts().sheet.columns.contains(&Column::BalloonX));
    act(&mut session, PartsAction::ShowAllColumns.into());
    assert_eq!(session.parts().sheet.columns.len(), Column::ALL.len());
}

#[test]
fn a_thousand_features_cost_little_for_each_change_that_can_be_taken_back() {
    let rows = (0..1_000).map(|row: usize| {
        DraftFeature::of([
            (Column::Name, format!("H{row}")),
            (Column::Callout, "25 H7".to_owned()),
            (Column::X, row.to_string()),
        ])
    });
    let text = Draft::of(rows.collect()).to_toml();
    let mut session = opened_at(&text, "/plans/many.toml");
    go(&mut session, 500, Column::Name);
    for text in ["N", "Ne", "New"] {
        plan(&mut session, PlanCommand::Type(PlanField::Cell, text.to_owned()));
    }
    plan(&mut session, PlanCommand::Take(None));
    act(&mut session, PartsAction::SortPlan.into());
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Name)[500], "New");
    act(&mut session, PartsAction::UndoPlan.into());
    assert_eq!(column(&session, Column::Name)[500], "H500");
}

#[test]
fn hole_bore_and_shaft_are_diameters_where_the_callout_is_of_that_side() {
    let session = opened(
        "name;kind;callout\nA;hole;25 H7\nB;Bore;8 H9\nC;shaft;20 g6\nD;as;12 h6\nE;boring;10 ±0.05\nF;shaft;10 ±0.05\n",
    );
    assert_eq!(session.parts().document.findings(), []);
    let features = &session.parts().document.plan().unwrap().features();
    let sides: Vec<_> = features.iter().map(|feature| feature.limits[0].feature.unwrap().word()).collect();
    assert_eq!(sides, ["hole", "hole", "shaft", "shaft", "hole", "shaft"]);
    assert!(features.iter().all(|feature| feature.kind.word() == "diameter"));
}

#[test]
fn a_kind_that_contradicts_the_callout_or_the_side_is_a_fault_that_says_so() {
    let session = opened("name;kind;callout;feature\nA;hole;20 g6;\nB;shaft;10 ±0.05;hole\n");
    let told: Vec<_> = session.parts().document.findings().iter().map(|finding| finding.what.to_string()).collect();
    assert_eq!(
        told,
        [
            "kind hole contradicts the callout 20 g6, which is that of a shaft: correct one of them, or write diameter",
            "kind shaft contradicts the feature hole, which is that of a hole: correct one of them, or write diameter",
        ]
    );
}

#[test]
fn a_word_that_is_no_kind_leaves_every_kind_to_choose_from() {
    let mut session = opened("name;kind;callout\nA;;25 H7\n");
    go(&mut session, 0, Column::Kind);
    plan(&mut session, PlanCommand::Edit(Some("drilling".to_owned())));
    assert_eq!(session.parts().choices(), session.parts().words_here());
    assert_eq!(session.parts().words_here().len(), 8);
}
