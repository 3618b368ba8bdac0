//! The budget page without a window: figures as the command line has them, errors with their place, use for checks, what
//! survives a restart, and readings from files and from checks.

use fitcheck::session::BudgetAction;
use std::path::{Path, PathBuf};
use std::process::Command as Process;

use fitcheck::budget::{Answer, Validity};
use fitcheck::message::Message;
use fitcheck::session::{
    BothSizes, BudgetCommand, BudgetField, CheckCommand, CheckField, Command, Effect, Field, FilesCommand, MeasureBy,
    Page, Purpose, Saved, Session, UseOf, advice, bars,
};
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};
use serde_json::Value as Json;

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

fn give(session: &mut Session, field: impl Into<Field>, text: &str) {
    send(session, field.into().typed(text.to_owned()));
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn inputs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/corpus/inputs")
}

fn sample(name: &str) -> String {
    std::fs::read_to_string(inputs().join(name)).unwrap()
}

/// A session with a budget of a file, as the window opens it.
fn with(name: &str) -> Session {
    let mut session = Session::new(Language::En);
    open(&mut session, name, Ok(sample(name)));
    session
}

fn open(session: &mut Session, name: &str, result: Result<String, Message>) {
    send(session, BudgetCommand::Read { path: inputs().join(name), result });
}

fn edit(session: &mut Session, from: &str, to: &str) {
    let text = session.budget().document.text.clone();
    assert!(text.contains(from), "{from} is not in {text}");
    send(session, BudgetCommand::Edit(text.replacen(from, to, 1)));
}

fn notices(session: &Session) -> Vec<String> {
    let told = session.notices().iter();
    told.flat_map(|notice| std::iter::once(&notice.message).chain(&notice.details).map(said)).collect()
}

/// What `fitcheck budget … --format json` says.
fn by_command(arguments: &[&str]) -> Json {
    let mut process = Process::new(env!("CARGO_BIN_EXE_fitcheck"));
    let output =
        process.current_dir(inputs()).arg("budget").args(arguments).args(["--format", "json"]).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"))
}

#[track_caller]
fn same(found: f64, wanted: &Json) {
    let wanted = wanted.as_f64().unwrap();
    assert!((found - wanted).abs() < 1e-6, "{found} instead of {wanted}");
}

#[track_caller]
fn same_as_command(session: &Session, arguments: &[&str]) {
    let json = by_command(arguments);
    let found = session.budget().found().unwrap();
    same(found.u(), &json["u_um"]);
    same(found.k(), &json["k"]);
    same(found.expanded(), &json["expanded_um"]);
    assert_eq!(found.validity.word(), json["validity"]);
    match &found.answer {
        Answer::Combined(evaluation) => {
            let rows = json["contributions"].as_array().unwrap();
            assert_eq!(rows.len(), evaluation.rows.len());
            for (row, json) in evaluation.rows.iter().zip(rows) {
                assert_eq!(
                    (row.name.as_str(), row.unit),
                    (json["name"].as_str().unwrap(), json["unit"].as_str().unwrap())
                );
                same(row.contribution, &json["contribution_um"]);
                same(row.sensitivity, &json["sensitivity"]);
                assert!((row.share - json["share_percent"].as_f64().unwrap()).abs() < 1e-3);
            }
            let help = json["help"].as_array().unwrap();
            for (told, json) in advice(evaluation).iter().zip(help) {
                let told = said(told);
                let u = told.rsplit_once("u = ").and_then(|(_, u)| u.strip_suffix(" µm")).unwrap();
                assert!((u.parse::<f64>().unwrap() - json["u_um"].as_f64().unwrap()).abs() < 6e-4, "{told}");
            }
            assert_eq!(help.len(), advice(evaluation).len());
        }
        Answer::Repeated(repeated) => {
            for (name, um) in repeated.terms() {
                same(um, &json[format!("{name}_um")]);
            }
            same(repeated.expanded_2011, &json["expanded_2011_um"]);
            same(repeated.expanded_2004, &json["expanded_2004_um"]);
        }
    }
}

#[test]
fn the_figures_are_those_of_the_command_line() {
    let mut session = with("station3.toml");
    same_as_command(&session, &["station3.toml", "--size", "25"]);
    give(&mut session, BudgetField::Touches, "3");
    give(&mut session, BudgetField::Step, "60");
    same_as_command(&session, &["station3.toml", "--size", "25", "--touches", "3", "--step", "60"]);
    give(&mut session, BudgetField::Size, "100,5");
    give(&mut session, BudgetField::Day, "2999-01-15");
    let arguments = ["station3.toml", "--size", "100.5", "--touches", "3", "--step", "60", "--date", "2999-01-15"];
    same_as_command(&session, &arguments);
    assert_eq!(session.budget().found().unwrap().validity, Validity::Expired);
    same_as_command(&with("ring30.toml"), &["ring30.toml"]);
}

#[test]
fn the_template_has_every_kind_and_is_dated_today() {
    let mut session = Session::new(Language::En);
    assert_eq!((session.budget().document.text.as_str(), session.budget().read.as_ref()), ("", None));
    send(&mut session, BudgetCommand::New);
    let budget = session.budget().read.as_ref().unwrap().as_ref().unwrap();
    assert_eq!((budget.date, budget.valid_until), (date(2026, 11, 21), date(2027, 11, 20)));
    let text = session.budget().document.text.clone();
    for kind in ["scatter", "part-temperature", "scale-temperature", "part-expansion", "scale-expansion", "resolution"]
    {
        assert!(text.contains(&format!("kind = \"{kind}\"")), "{kind}");
    }
    for law in ["normal", "rectangular", "u-shaped", "triangular"] {
        assert!(text.contains(&format!("law = \"{law}\"")), "{law}");
    }
    assert!(session.budget().found().is_some() && !session.budget().document.is_unsaved());
    // Its commented table is one, too.
    let (head, _) = text.split_once("# How much").unwrap();
    let piece: String = text.split_once("# [calibrated]").map(|(_, piece)| format!("[calibrated]{piece}")).unwrap();
    send(&mut session, BudgetCommand::Edit(format!("{head}{}", piece.replace("\n# ", "\n"))));
    assert!(session.budget().found().is_some(), "{:?}", session.budget().read.as_ref());
}

#[test]
fn no_answer_stays_beside_a_text_that_it_was_not_made_with() {
    let mut session = with("station3.toml");
    edit(&mut session, "half_width_um = 1.0", "half_width_um = one");
    assert!(session.budget().answer.is_none());
    let error = session.budget().read.as_ref().unwrap().as_ref().unwrap_err();
    assert_eq!((error.place.line, error.place.column), (Some(35), Some(17)));
    edit(&mut session, "half_width_um = one", "half_width_um = -1");
    let error = session.budget().read.as_ref().unwrap().as_ref().unwrap_err().to_string();
    assert_eq!(error, "line 35, column 17: Geometry of the machine: half_width_um is -1: expected 0 to 1000000");
    edit(&mut session, "half_width_um = -1", "half_width_um = 2.0");
    assert!((session.budget().found().unwrap().u() - 1.3842).abs() < 0.001);
    give(&mut session, BudgetField::Size, "");
    let error = session.budget().answer.as_ref().unwrap().as_ref().unwrap_err();
    assert_eq!(said(error), "Temperature of the part depends on the size, but no size is given");
    give(&mut session, BudgetField::Size, "x");
    assert!(session.budget().answer.is_none() && session.error(BudgetField::Size).is_some());
    // A field that the budget does not ask for refuses nothing.
    open(&mut session, "ring30.toml", Ok(sample("ring30.toml")));
    send(&mut session, Command::Discard(true));
    assert!(session.budget().found().is_some() && session.error(BudgetField::Size).is_none());
}

#[test]
fn another_day_is_another_answer() {
    let mut session = Session::new(Language::En);
    send(&mut session, BudgetCommand::New);
    assert_eq!(session.budget().found().unwrap().validity, Validity::Valid);
    session.apply(Command::OpenPage(Page::Check), date(2027, 11, 21).at(0, 0, 1, 0));
    assert_eq!(session.budget().found().unwrap().validity, Validity::Expired);
    session.apply(Command::OpenPage(Page::Check), date(2026, 11, 20).at(0, 0, 1, 0));
    assert_eq!(session.budget().found().unwrap().validity, Validity::NotYet);
}

#[test]
fn bars_are_the_shares_largest_first() {
    let session = with("station3.toml");
    let bars = bars(session.budget().found().unwrap());
    let names: Vec<_> = bars.iter().map(|bar| format!("{} {}", said(&bar.name), said(&bar.amount))).collect();
    assert_eq!(names[0], "Geometry of the machine 36.4 %");
    assert!((bars.iter().map(|bar| bar.length).sum::<f64>() - 1.0).abs() < 1e-9);
    assert!(bars.windows(2).all(|two| two[1].length <= two[0].length));
    let session = with("ring30.toml");
    let bars = fitcheck::session::bars(session.budget().found().unwrap());
    assert_eq!(bars.len(), 7);
    assert!(bars.iter().any(|bar| (bar.length - 1.0).abs() < 1e-9) && bars.iter().all(|bar| bar.length <= 1.0));
}

#[test]
fn a_temperature_is_helped_by_measuring_it_better() {
    let mut session = with("station3.toml");
    edit(&mut session, "standard_k = 1.0", "standard_k = 10.0");
    let Answer::Combined(evaluation) = &session.budget().found().unwrap().answer else { panic!() };
    let told = said(&advice(evaluation)[0]);
    assert!(told.starts_with("Half the uncertainty of the part temperature: u = 1.7"), "{told}");
}

#[test]
fn checks_use_the_budget_until_they_stop() {
    let mut session = Session::new(Language::En);
    assert!(!session.can(BudgetAction::UseBudget) && !session.can(BudgetAction::LeaveBudget));
    open(&mut session, "station3.toml", Ok(sample("station3.toml")));
    send(&mut session, BudgetCommand::Use);
    let used = session.used_budget().unwrap();
    assert_eq!((used.file.as_str(), used.budget.name.as_str()), ("station3.toml", "Station 3, probe 1"));
    assert_eq!(notices(&session), Vec::<String>::new(), "the page says it");
    assert!(!session.can(BudgetAction::UseBudget) && session.can(BudgetAction::LeaveBudget));
    assert_eq!(session.saved().budget, Some(inputs().join("station3.toml")));
    edit(&mut session, "standard_um = 0.5", "standard_um = 0.6");
    assert_eq!(session.budget().use_of(session.used_budget()), UseOf::Another);
    assert!((session.used_budget().unwrap().budget.clone() == Session::used_budget(&with_used()).unwrap().budget));
    send(&mut session, BudgetCommand::Use);
    assert_eq!(session.budget().use_of(session.used_budget()), UseOf::This);
    assert!(notices(&session).contains(&"Save the budget to keep using it after a restart".to_owned()));
    assert_eq!(session.saved().budget, None, "no file holds it");
    send(&mut session, BudgetCommand::Leave);
    assert!(session.used_budget().is_none() && session.saved().budget.is_none());
}

fn with_used() -> Session {
    let mut session = with("station3.toml");
    send(&mut session, BudgetCommand::Use);
    session
}

#[test]
fn name_and_maker_are_fields_that_write_into_the_text_and_say_what_is_wrong_with_them() {
    let mut session = with("station3.toml");
    assert_eq!(session.text(BudgetField::HeadName), "Station 3, probe 1");
    let before = session.budget().document.text.clone();
    give(&mut session, BudgetField::HeadName, "Bore gauge \"40\"");
    assert_eq!(session.budget().document.text, before.replacen("Station 3, probe 1", "Bore gauge \\\"40\\\"", 1));
    assert_eq!(session.budget().found().unwrap().budget.name, "Bore gauge \"40\"");
    give(&mut session, BudgetField::HeadName, "");
    assert!(session.error(BudgetField::HeadName).is_some(), "{:?}", session.budget().read);
    assert!(!session.budget().is_stale(), "it can be typed again");
    give(&mut session, BudgetField::HeadBy, "JJ");
    give(&mut session, BudgetField::HeadName, "Station 3, probe 1");
    assert_eq!(session.budget().found().unwrap().budget.by, "JJ");
}

#[test]
fn an_expired_budget_is_used_and_said() {
    let mut session = with("station3.toml");
    edit(&mut session, "valid_until = 2999-01-14", "valid_until = 2020-01-14");
    assert_eq!(session.budget().found().unwrap().validity, Validity::Expired);
    send(&mut session, BudgetCommand::Use);
    assert!(session.used_budget().is_some());
    assert!(notices(&session).contains(&"the budget has expired: it was valid until 2020-01-14".to_owned()));
}

#[test]
fn the_budget_that_checks_use_is_read_again_at_the_next_start() {
    let saved = Saved::read(&with_used().saved().write().unwrap()).unwrap();
    let path = inputs().join("station3.toml");
    let (mut again, effects) = Session::restore(saved.clone());
    assert_eq!(effects, [Effect::Read(Purpose::UseBudget, path.clone())]);
    assert!(again.used_budget().is_none());
    let read = BudgetCommand::UsedRead { path: path.clone(), result: Ok(sample("station3.toml")) };
    send(&mut again, read.clone());
    assert_eq!(again.used_budget().unwrap().file, "station3.toml");
    assert_eq!(
        (again.budget().document.name().as_str(), again.budget().document.text.as_str()),
        ("station3.toml", sample("station3.toml").as_str())
    );
    assert_eq!((notices(&again), again.saved()), (Vec::new(), saved.clone()));
    // One that cannot be read is told, used for nothing, and looked for the next time, too.
    for result in [Err(Message::new("dialog-no-path")), Ok("name = 1\n".to_owned())] {
        let (mut session, _) = Session::restore(saved.clone());
        send(&mut session, BudgetCommand::UsedRead { path: path.clone(), result });
        assert!(session.used_budget().is_none());
        let told = notices(&session);
        assert!(
            told.len() == 1 && told[0].contains("station3.toml") && told[0].contains("checks use no budget"),
            "{told:?}"
        );
        assert_eq!(session.saved(), saved);
    }
    // It comes too late where the user has chosen meanwhile, and never takes the place of another text.
    let (mut session, _) = Session::restore(saved.clone());
    send(&mut session, BudgetCommand::Leave);
    send(&mut session, read.clone());
    assert!(session.used_budget().is_none() && session.budget().document.text.is_empty());
    let (mut session, _) = Session::restore(saved);
    open(&mut session, "ring30.toml", Ok(sample("ring30.toml")));
    send(&mut session, read);
    assert_eq!(
        (session.budget().document.name().as_str(), session.used_budget().unwrap().file.as_str()),
        ("ring30.toml", "station3.toml")
    );
}

#[test]
fn what_is_tried_out_is_forgotten_at_the_end() {
    let mut session = with("station3.toml");
    for (field, text) in [(BudgetField::Size, "40"), (BudgetField::Touches, "3"), (BudgetField::Day, "2030-01-01")] {
        give(&mut session, field, text);
    }
    let (again, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    assert_eq!(
        [BudgetField::Size, BudgetField::Touches, BudgetField::Day].map(|field| again.text(field)),
        ["40", "", ""]
    );
}

#[test]
fn changes_are_asked_about_and_late_files_change_nothing_unasked() {
    let mut session = with("station3.toml");
    edit(&mut session, "probe 1", "probe 2");
    assert_eq!(session.unsaved(), ["station3.toml"]);
    assert_eq!(send(&mut session, Command::AskToLeave), []);
    assert!(session.is_leaving());
    send(&mut session, Command::Leave(false));
    open(&mut session, "ring30.toml", Ok(sample("ring30.toml")));
    assert!(session.asks_about().is_some() && session.budget().document.text.contains("probe 2"));
    send(&mut session, Command::Discard(false));
    assert!(session.asks_about().is_none() && session.budget().document.text.contains("probe 2"));
    send(&mut session, BudgetCommand::New);
    assert!(session.asks_about().is_some());
    send(&mut session, Command::Discard(true));
    assert!(session.budget().document.text.contains("Station 1") && session.unsaved().is_empty());
    assert_eq!(send(&mut session, Command::AskToLeave), [Effect::Leave]);
}

#[test]
fn a_budget_is_saved_as_its_text_with_its_line_ends() {
    let mut session = Session::new(Language::En);
    let text = sample("station3.toml").replace('\n', "\r\n");
    open(&mut session, "station3.toml", Ok(text.clone()));
    assert!(!session.budget().document.text.contains('\r') && !session.budget().document.is_unsaved());
    edit(&mut session, "probe 1", "probe 2");
    send(&mut session, BudgetCommand::Use);
    assert_eq!(session.saved().budget, None);
    send(&mut session, Command::OpenDialog(Purpose::SaveBudget));
    assert_eq!(session.dialog().unwrap().path, "station3.toml");
    send(&mut session, Command::TypePath("/somewhere/new.toml".to_owned()));
    let effects = send(&mut session, Command::Confirm);
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert_eq!(content.bytes().unwrap(), text.replace("probe 1", "probe 2").into_bytes());
    let path = path.clone();
    // What is typed while it is written is not in the file.
    edit(&mut session, "probe 2", "probe 3");
    send(&mut session, Command::Saved { path: path.clone(), result: Ok(()) });
    assert!(session.budget().document.is_unsaved());
    assert_eq!(session.budget().document.name(), "new.toml");
    edit(&mut session, "probe 3", "probe 2");
    assert!(!session.budget().document.is_unsaved());
    send(&mut session, Command::OpenDialog(Purpose::SaveBudget));
    send(&mut session, Command::TypePath("/somewhere/new.toml".to_owned()));
    send(&mut session, Command::Confirm);
    send(&mut session, Command::Saved { path: path.clone(), result: Ok(()) });
    assert_eq!(session.saved().budget, Some(path), "what checks use has a file now");
}

#[test]
fn a_file_is_known_as_a_budget_by_its_tables() {
    for name in ["station3.toml", "ring30.toml"] {
        assert_eq!(Purpose::of_file(name, sample(name).as_bytes()), Ok(Purpose::OpenBudget), "{name}");
    }
    let purpose = Purpose::of_file("good.toml", sample("good.toml").as_bytes());
    assert_ne!(purpose, Ok(Purpose::OpenBudget));
    let mut session = Session::new(Language::En);
    let path = inputs().join("station3.toml");
    let effects = send(&mut session, FilesCommand::Open(Purpose::OpenBudget, path.clone()));
    assert_eq!((effects, session.page()), (vec![Effect::Read(Purpose::OpenBudget, path)], Page::Budget));
}

#[test]
fn readings_of_a_file_are_those_of_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let rows = "id;measured;simulated\nR1;30,0021;false\nR2;30,0024;false\nR3;;false\nR1;30,0019;true\n";
    let path = folder.path().join("readings.csv");
    std::io::Write::write_all(&mut std::fs::File::create(&path).unwrap(), rows.as_bytes()).unwrap();
    let mut session = with("ring30.toml");
    assert!(session.can(BudgetAction::OpenReadings) && !session.can(BudgetAction::OwnReadings));
    let sizes = Box::new(BothSizes::read("readings.csv", rows.as_bytes()));
    send(&mut session, BudgetCommand::ReadingsRead { name: "readings.csv".to_owned(), result: Ok(sizes) });
    let arguments = ["ring30.toml", "--readings", path.to_str().unwrap()];
    same_as_command(&session, &arguments);
    let readings = session.budget().readings.as_ref().unwrap();
    assert_eq!(said(&readings.from), "3 readings of readings.csv");
    let notes: Vec<_> = readings.notes.iter().map(said).collect();
    let command = by_command(&arguments);
    let told = |key: &str| command[key].as_array().unwrap().iter().map(|one| one.as_str().unwrap().to_owned());
    for said in told("refused") {
        assert!(notes.contains(&said), "{said} is not in {notes:?}");
    }
    assert!(
        notes.iter().any(|note| note.contains("simulated")) && notes.iter().any(|note| note.contains("R1")),
        "{notes:?}"
    );
    let warnings = session.budget().found().unwrap().warnings();
    assert!(warnings.iter().any(|warning| warning.to_string().contains("asks for at least 20")), "{warnings:?}");
    // What is used has these readings, and no file has them.
    send(&mut session, BudgetCommand::Use);
    let used = session.used_budget().unwrap().budget.clone();
    let fitcheck::budget::Basis::Calibrated(piece) = used.basis else { panic!() };
    assert_eq!(piece.readings.len(), 3);
    assert_eq!(session.saved().budget, None);
    send(&mut session, BudgetCommand::OwnReadings);
    same_as_command(&session, &["ring30.toml"]);
    assert_eq!(session.budget().use_of(session.used_budget()), UseOf::Another);
}

#[test]
fn readings_are_the_chosen_checks_or_all() {
    let mut session = with("ring30.toml");
    assert!(!session.can(BudgetAction::TakeReadings), "there is no check");
    let measured = ["30.0021", "30.0024", "30.0019", "30.0020"];
    for value in measured {
        for (field, text) in [(CheckField::Callout, "30 H7"), (CheckField::Measured, value)] {
            give(&mut session, field, text);
        }
        send(&mut session, CheckCommand::Measure);
    }
    give(&mut session, CheckField::Callout, "30 h7");
    give(&mut session, CheckField::Measured, "29.999");
    send(&mut session, CheckCommand::Measure);
    send(&mut session, CheckCommand::MeasureBy(MeasureBy::Simulating));
    give(&mut session, CheckField::Callout, "30 H7");
    send(&mut session, CheckCommand::Measure);
    assert_eq!(session.history().len(), 6);
    send(&mut session, BudgetCommand::TakeRecords);
    let readings = session.budget().readings.as_ref().unwrap();
    assert_eq!(said(&readings.from), "5 readings: all checks of the history");
    let notes: Vec<_> = readings.notes.iter().map(said).collect();
    assert_eq!(
        notes,
        ["a check of a shaft is not used: the piece is a hole", "one reading is simulated: nothing was measured"]
    );
    // The list has the newest first.
    for (id, _) in session.history().listed().page(2..4) {
        send(&mut session, CheckCommand::Choose(id, true));
    }
    send(&mut session, BudgetCommand::TakeRecords);
    let readings = session.budget().readings.as_ref().unwrap();
    assert_eq!(said(&readings.from), "2 readings: the chosen checks of the history");
    let mut sizes: Vec<_> = readings.measured.iter().map(ToString::to_string).collect();
    sizes.sort();
    assert_eq!(sizes, ["30.0019", "30.002"]);
}

#[test]
fn contacts_that_are_taken_count_until_others_are_typed() {
    let mut session = with("station3.toml");
    assert!(!session.can(BudgetAction::ContactsOfCheck) && !session.can(BudgetAction::ContactsRecorded));
    give(&mut session, CheckField::Callout, "25 H7");
    send(&mut session, CheckCommand::MeasureBy(MeasureBy::Simulating));
    send(&mut session, CheckCommand::Measure);
    assert!(session.can(BudgetAction::ContactsOfCheck));
    give(&mut session, BudgetField::Touches, "3");
    give(&mut session, BudgetField::Step, "60");
    let factor = |session: &Session| session.budget().found().unwrap().geometry().unwrap().factor;
    assert!((factor(&session) - 3.464).abs() < 0.001);
    let command = BudgetAction::ContactsOfCheck.command(&session).unwrap();
    send(&mut session, command);
    assert!((factor(&session) - 1.0).abs() < 0.001);
    let taken = session.budget().contacts.as_ref().unwrap();
    assert_eq!(said(&taken.of), "4 contacts of the check 25 H7, 10:42:07, simulated");
    assert_eq!([BudgetField::Touches, BudgetField::Step].map(|field| session.text(field).to_owned()), ["", ""]);
    give(&mut session, BudgetField::Touches, "3");
    give(&mut session, BudgetField::Step, "120");
    assert!(session.budget().contacts.is_none());
    assert!((factor(&session) - 1.1547).abs() < 0.001);
}

/// The file of the budget in use gets another text that checks do not use: the next start would take it for the one in use.
#[test]
fn a_file_that_holds_another_budget_is_not_used_at_the_next_start() {
    let mut session = with_used();
    let path = inputs().join("station3.toml");
    assert_eq!(session.saved().budget, Some(path.clone()));
    edit(&mut session, "standard_um = 0.5", "standard_um = 5");
    send(&mut session, Command::OpenDialog(Purpose::SaveBudget));
    send(&mut session, Command::TypePath(path.display().to_string()));
    send(&mut session, Command::Confirm);
    send(&mut session, Command::Saved { path, result: Ok(()) });
    assert_eq!(session.budget().use_of(session.used_budget()), UseOf::Another);
    assert_eq!(session.saved().budget, None);
}
