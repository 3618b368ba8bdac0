//! The help page without a window: every page has its page of the manual, every link leads somewhere, and words are found.

use std::collections::BTreeSet;
use std::path::Path;

use fitcheck::session::action::Action;
use fitcheck::session::help::{Block, CONTENTS, HelpTopic, ManualPage, Sample, key_groups, manual, topics};
use fitcheck::session::parts::{PlanCommand, WalkCommand};
use fitcheck::session::{
    Command, Effect, Field, HelpAction, HelpCommand, HelpField, Page, PaletteCommand, PartsCommand, Purpose, Session,
    Step, WindowAction,
};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 26).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) {
    session.apply(command.into(), now());
}

fn act(session: &mut Session, action: impl Into<Action>) {
    let command = action.into().command(session).unwrap();
    send(session, command);
}

fn on(page: Page) -> Session {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(page));
    session
}

/// The file and the anchor of what is read.
fn shown(session: &Session) -> (&'static str, Option<&str>) {
    let place = &session.help().shown;
    let HelpTopic::Manual(file) = place.topic else { return ("", None) };
    (file, place.anchor.as_deref())
}

/// What a query finds: titles, each with the heading.
fn found(query: &str) -> Vec<String> {
    let mut session = on(Page::Help);
    send(&mut session, Field::from(HelpField::Search).typed(query.to_owned()));
    let words = Words::new(Language::En);
    let line = |found: &fitcheck::session::help::HelpFound| {
        let heading = found.heading.as_ref().map(|heading| format!(" > {heading}"));
        found.place.topic.title(&words) + &heading.unwrap_or_default()
    };
    session.help().found.iter().map(line).collect()
}

#[test]
fn every_page_has_its_page_of_the_manual() {
    for page in Page::ALL {
        assert!(ManualPage::of(page.manual()).is_some(), "{page:?} names {}", page.manual());
    }
}

#[test]
fn the_contents_list_every_page_of_the_manual() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/manual");
    let files: BTreeSet<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    let built_in: BTreeSet<String> = manual().iter().map(|page| page.file.to_owned()).collect();
    assert_eq!(built_in, files);
    let contents = &manual()[0];
    assert_eq!(contents.file, CONTENTS);
    let listed: Vec<HelpTopic> = contents.links().map(|link| link.topic).collect();
    let pages: Vec<HelpTopic> = manual()[1..].iter().map(|page| HelpTopic::Manual(page.file)).collect();
    assert_eq!(pages, listed);
}

#[test]
fn every_link_of_the_manual_leads_to_a_heading() {
    let mut count = 0;
    for page in manual() {
        for link in page.links() {
            count += 1;
            let HelpTopic::Manual(file) = link.topic else { panic!("{link:?}") };
            let to = ManualPage::of(file);
            assert!(
                to.is_some_and(|to| link.anchor.as_ref().is_none_or(|anchor| to.has(anchor))),
                "{}: {link:?}",
                page.file
            );
        }
    }
    // None of them is lost: a link to a page stands in one line.
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/manual");
    let written: usize = manual()
        .iter()
        .map(|page| {
            let text = std::fs::read_to_string(folder.join(page.file)).unwrap();
            let targets = text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
            targets.filter(|to| to.contains(".md") && !to.contains('/') || to.starts_with('#')).count()
        })
        .sum();
    assert_eq!(count, written);
}

#[test]
fn a_page_is_read_as_headings_paragraphs_lists_tables_and_code() {
    let kinds = |file: &str| {
        let blocks = &ManualPage::of(file).unwrap().blocks;
        let kind = |block: &Block| match block {
            Block::Heading { .. } => "heading",
            Block::Paragraph(_) => "paragraph",
            Block::Item { .. } => "item",
            Block::Table { .. } => "table",
            Block::Code(_) => "code",
        };
        blocks.iter().map(kind).collect::<BTreeSet<_>>()
    };
    assert_eq!(kinds("parts.md"), BTreeSet::from(["heading", "paragraph", "item", "code"]));
    assert!(kinds("window.md").contains("table"));
    // A picture is not part of the program, and leaves no empty paragraph.
    for page in manual() {
        for block in &page.blocks {
            let text: String = block.spans().iter().map(|span| span.text.as_str()).collect();
            assert!(matches!(block, Block::Code(code) if !code.is_empty()) || !text.trim().is_empty(), "{block:?}");
            assert!(!text.contains("]("), "{}: {text}", page.file);
        }
    }
}

#[test]
fn f1_opens_the_page_about_the_open_page_and_goes_back() {
    for page in Page::ALL.into_iter().filter(|page| *page != Page::Help) {
        let mut session = on(page);
        act(&mut session, WindowAction::Help);
        assert_eq!((session.page(), shown(&session)), (Page::Help, (page.manual(), None)));
        act(&mut session, WindowAction::Help);
        assert_eq!(session.page(), page);
    }
    let mut session = on(Page::Records);
    send(&mut session, Command::OpenPage(Page::Help));
    act(&mut session, WindowAction::Help);
    assert_eq!(session.page(), Page::Records, "however the help page was opened");
    let mut session = Session::new(Language::En);
    act(&mut session, WindowAction::Help);
    act(&mut session, WindowAction::Help);
    assert_eq!(session.page(), Page::Check, "the page of the start");
}

#[test]
fn the_best_match_comes_first() {
    assert_eq!(found("watch")[0], "Watch a folder");
    assert_eq!(found("WATCH folder")[0], "Watch a folder");
    assert_eq!(found("shortcut")[0], "Keyboard shortcuts");
    assert_eq!(found("sneltoets")[0], "Keyboard shortcuts");
    // In a heading, then in a text.
    assert_eq!(found("palette")[0], "The window > The palette");
    assert!(found("aqdef").contains(&"Whole parts".to_owned()), "{:?}", found("aqdef"));
    assert_eq!(found("xyzzy"), [""; 0]);
    assert_eq!(found(" "), topics().map(|topic| topic.title(&Words::new(Language::En))).collect::<Vec<_>>());
    assert_eq!(found("")[..3], ["The manual", "Keyboard shortcuts", "Check one size"]);
}

#[test]
fn enter_opens_the_best_match_at_its_heading() {
    let mut session = on(Page::Help);
    send(&mut session, Field::from(HelpField::Search).typed("palette".to_owned()));
    assert_eq!(shown(&session), (CONTENTS, None), "nothing is opened while something is typed");
    send(&mut session, Command::Enter(HelpField::Search.into()));
    assert_eq!(shown(&session), ("window.md", Some("the-palette")));
    act(&mut session, HelpAction::BackInHelp);
    assert_eq!(shown(&session), (CONTENTS, None));
    assert!(!session.can(HelpAction::BackInHelp));
}

#[test]
fn what_is_passed_by_with_keys_is_not_gone_back_to() {
    let mut session = on(Page::Help);
    // A step that leads nowhere is none.
    act(&mut session, HelpAction::MoveTopic(Step::Up));
    for _ in 0..3 {
        act(&mut session, HelpAction::MoveTopic(Step::Down));
    }
    assert_eq!(shown(&session), (manual()[2].file, None));
    act(&mut session, HelpAction::MoveTopic(Step::Last));
    assert_eq!(shown(&session), (manual().last().unwrap().file, None));
    act(&mut session, HelpAction::BackInHelp);
    assert_eq!(shown(&session), (CONTENTS, None));
}

#[test]
fn the_sheet_has_every_key_of_every_action() {
    let session = on(Page::Help);
    let words = Words::new(Language::En);
    let groups = key_groups(&session, &words);
    let listed = groups.iter().flat_map(|group| &group.rows);
    let listed: BTreeSet<(String, String)> =
        listed.flat_map(|row| row.keys.iter().map(|keys| (keys.to_string(), row.text.clone()))).collect();
    let wanted = Action::all().flat_map(|action| {
        let text = action.text(&session, &words);
        action.shortcuts().map(move |keys| (keys.to_string(), text.clone()))
    });
    assert_eq!(listed, wanted.collect());
    for language in Language::all() {
        let words = Words::new(language);
        assert!(groups.iter().all(|group| words.find(group.name).is_some()));
    }
}

#[test]
fn the_palette_finds_the_pages_of_the_manual() {
    for (query, title) in
        [("help reports", "reports.md"), ("hulp sneltoetsen", ""), ("help: control tables", "tables.md")]
    {
        let mut session = Session::new(Language::En);
        send(&mut session, PaletteCommand::Show(true));
        send(&mut session, PaletteCommand::Type(query.to_owned()));
        send(&mut session, PaletteCommand::Do(None));
        assert_eq!((session.page(), shown(&session).0), (Page::Help, title), "{query}");
    }
}

#[test]
fn samples_are_read_as_files_and_are_called_samples() {
    for sample in Sample::ALL {
        let mut session = on(Page::Help);
        let command = Action::from(WindowAction::OpenSample(sample)).command(&session).unwrap();
        let effects = session.apply(command, now());
        assert_eq!(effects, [Effect::Read(sample.purpose(), sample.path())]);
        let path = sample.path();
        assert!(path.file_name().unwrap().to_str().unwrap().starts_with("sample_"), "{}", path.display());
        assert!(Sample::bytes_at(&path).is_some() && path.is_relative() && !path.exists());
    }
    let part = Sample::Part.path();
    let plan = fitcheck::part::Document::read(Sample::bytes_at(&part).unwrap()).unwrap();
    assert!(plan.problems.is_empty() && plan.draft.rows.len() == 6);
    assert!(Sample::bytes_at(&part.with_extension("svg")).is_some(), "its picture lies beside it");
    assert!(Sample::bytes_at(Path::new("assets/samples/sample_plate.toml")).is_none());
    assert!(Sample::bytes_at(Path::new("/etc/passwd")).is_none());
}

/// Whoever tries the program records nothing that somebody could take for measured.
#[test]
fn the_values_of_the_sample_file_are_simulated() {
    let path = Sample::File.path();
    let bytes = Sample::bytes_at(&path).unwrap();
    let imported = fitcheck::exchange::import("sample.csv", bytes, &fitcheck::tolerance::Sources::default(), now());
    assert_eq!((imported.records.len(), imported.errors.len()), (12, 0));
    assert!(imported.records.iter().all(|record| record.measurement.origin.is_simulated()));
}

#[test]
fn a_sample_file_is_not_taken_for_values_of_the_part_that_is_measured() {
    let mut session = on(Page::Parts);
    let bytes = Sample::bytes_at(&Sample::Part.path()).unwrap();
    let result = Ok(Box::new(fitcheck::part::Document::read(bytes).unwrap()));
    send(&mut session, PartsCommand::Plan(PlanCommand::Read { path: Sample::Part.path(), result }));
    send(&mut session, WalkCommand::Begin);
    assert!(session.parts().walking.is_begun());
    let command = Action::from(WindowAction::OpenSample(Sample::File)).command(&session).unwrap();
    assert_eq!(session.apply(command, now()), [Effect::Read(Purpose::Import, Sample::File.path())]);
    assert_eq!(session.page(), Page::Check);
}

#[test]
fn the_list_of_places_to_go_back_to_does_not_grow_for_ever() {
    let mut session = on(Page::Help);
    for _ in 0..500 {
        send(&mut session, HelpCommand::Select(3));
        send(&mut session, HelpCommand::Select(4));
    }
    assert!(session.help().before.len() <= 100);
}
