//! The help page without a window: every page has its page of the manual, every link leads somewhere, and words are found.

use std::collections::BTreeSet;
use std::path::Path;

use fitcheck::probing::cycles::CYCLES;
use fitcheck::session::action::Action;
use fitcheck::session::help::{
    Block, CONTENTS, HelpTopic, LinePart, ManualPage, Sample, Span, key_groups, manual, topics,
};
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
fn the_operators_page_is_in_every_language_block_by_block() {
    let kinds = |page: &ManualPage| page.blocks.iter().map(std::mem::discriminant).collect::<Vec<_>>();
    let english = ManualPage::of("operator.md").unwrap();
    for language in Language::all().filter(|language| *language != Language::En) {
        let page = ManualPage::told("operator.md", language).unwrap();
        assert_ne!(page.title, english.title, "{language}");
        assert_eq!(kinds(page), kinds(english), "{language}");
        assert!(page.links().eq(english.links()), "{language}");
        // What it calls a button is what stands on it.
        let words = fitcheck::words::Words::new(language);
        let text: String = page.blocks.iter().flat_map(Block::spans).map(|span| span.text.as_str()).collect();
        for id in ["judge", "keypad", "why", "operator-next", "operator-leave", "operator-report", "operator-next-part"]
        {
            let name = words.get(id);
            assert!(text.contains(name.as_str()), "{language}: {name} ({id})");
        }
    }
    for (code, page) in ManualPage::translated() {
        let is_known = Language::from_code(code).is_some() && ManualPage::of(page.file).is_some();
        assert!(is_known, "docs/translated/{code}/{} is of no language or of no page", page.file);
    }
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
    // A picture is not part of the program, and leaves no empty paragraph and no table of what stands above pictures.
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

/// The hits of a query, each with the line that it was found in: what was searched for is in brackets.
fn lines(query: &str) -> Vec<String> {
    let mut session = on(Page::Help);
    send(&mut session, Field::from(HelpField::Search).typed(query.to_owned()));
    let part = |part: &LinePart| if part.is_found { format!("[{}]", part.text) } else { part.text.clone() };
    session.help().found.iter().map(|found| found.line.iter().map(part).collect()).collect()
}

#[test]
fn the_best_match_comes_first() {
    assert_eq!(found("watch")[0], "Watch a folder");
    assert_eq!(found("WATCH folder")[0], "Watch a folder");
    assert_eq!(found("shortcut")[0], "Keyboard shortcuts");
    assert_eq!(found("sneltoets")[0], "Keyboard shortcuts");
    // A heading that is the word, whatever stands before it.
    assert_eq!(found("palette")[0], "The window > The palette");
    assert!(found("aqdef").contains(&"Whole parts".to_owned()), "{:?}", found("aqdef"));
    assert_eq!(found("xyzzy"), [""; 0]);
    assert_eq!(found(" "), topics().map(|topic| topic.title(&Words::new(Language::En))).collect::<Vec<_>>());
    assert_eq!(found("")[..3], ["The manual", "Keyboard shortcuts", "Check one size"]);
}

#[test]
fn a_term_is_found_at_its_explanation() {
    for (query, heading) in [
        ("rework", "Rework"),
        ("guard band", "Guard band"),
        ("Guard bands", "Guard band"),
        ("scrap", "Scrap"),
        ("hole", "Hole"),
        ("decision rule", "Decision rule"),
        ("expanded uncertainty", "Expanded uncertainty U and k"),
        ("supplier", "Supplier"),
        ("records", "Record"),
        ("journal", "Journal"),
        ("criterion", "Criterion"),
        ("type b", "Type B"),
    ] {
        assert_eq!(found(query)[0], format!("Terms > {heading}"), "{query}: {:?}", found(query));
    }
}

#[test]
fn a_hit_shows_the_line_that_it_was_found_in_with_the_words_marked() {
    let all = lines("guard band");
    assert!(all[0].starts_with("A strip along a limit"), "{}", all[0]);
    assert!(all.iter().skip(1).all(|line| line.is_empty() || line.to_lowercase().contains('[')), "{all:?}");
    assert!(all.iter().any(|line| line.contains("[guard] [bands]")), "{all:?}");
    // A line far in begins a little before the words, at a word.
    let far = lines("capability study").swap_remove(0);
    assert!(far.starts_with('…') && far.contains("[capability] [study]"), "{far}");
}

#[test]
fn what_only_lists_pages_comes_last() {
    for query in ["uncertainty", "rework", "guard band"] {
        let all = found(query);
        let contents = all.iter().position(|found| found.starts_with("The manual"));
        let last = all.iter().rposition(|found| found.starts_with("Terms") || found.starts_with("Decision rules"));
        assert!(contents.is_none_or(|contents| last < Some(contents)), "{query}: {all:?}");
    }
}

#[test]
fn a_word_is_found_where_a_word_begins() {
    assert!(found("uler").is_empty(), "{:?}", found("uler"));
    assert!(!found("rule").is_empty());
}

#[test]
fn what_a_user_of_a_control_types_is_found() {
    for (query, first) in [
        ("supported cycles", "Measuring cycles > Supported cycles"),
        ("cycles supported", "Measuring cycles > Supported cycles"),
        ("not supported", "Measuring cycles > Not supported"),
        ("q parameters", "Measuring cycles > Q parameters"),
        ("single block", "Run NC programs > The machine around the program"),
        ("block by block", "Run NC programs > The programs page"),
        ("preset", "Run NC programs > The machine around the program"),
        ("presets", "Run NC programs > The machine around the program"),
        ("tool data", "Run NC programs > The machine around the program"),
        ("probe radius", "Run NC programs > The machine around the program"),
        ("calibration", "Run NC programs > The machine around the program"),
        ("pallet", "Run NC programs > The machine around the program"),
        ("units inch", "Run NC programs > The machine around the program"),
        ("inches", "Run NC programs > The machine around the program"),
        ("calibration cycle", "Measuring cycles > Not supported"),
        ("Q303", "Measuring cycles > Q parameters"),
        ("datum cycle", "Measuring cycles > Datum cycles"),
    ] {
        assert_eq!(found(query).first().map(String::as_str), Some(first), "{query}: {:?}", found(query));
    }
}

#[test]
fn the_manual_has_every_parameter_of_every_cycle() {
    let page = ManualPage::of("cycles.md").unwrap();
    let cells = |anchor: &str| {
        let tables = page.below(anchor).iter().filter_map(|block| match block {
            Block::Table { rows, .. } => Some(rows),
            _ => None,
        });
        let text = |cell: &Vec<Span>| cell.iter().map(|span| span.text.as_str()).collect::<String>();
        tables.flatten().map(|row| row.iter().map(text).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let words = |text: &str| text.split([',', ' ', ';']).map(str::to_owned).collect::<BTreeSet<_>>();
    let (cycles, parameters) = (cells("supported-cycles"), cells("q-parameters"));
    for cycle in CYCLES {
        let row = cycles.iter().find(|row| words(&row[0]).contains(cycle.code)).unwrap();
        for parameter in cycle.parameters {
            let key = parameter.key.to_string();
            assert!(words(&row[2]).contains(&key), "{}: {key} in {row:?}", cycle.code);
            if key.starts_with('Q') && key != "Q" {
                assert!(parameters.iter().any(|row| words(&row[0]).contains(&key)), "{key}");
                assert!(found(&key).iter().any(|found| found.starts_with("Measuring cycles")), "{key}");
            }
        }
    }
}

#[test]
fn what_no_page_says_is_left_out_and_one_word_is_found_as_two() {
    assert_eq!(found("setup clearance")[0], found("set-up clearance")[0]);
    assert_eq!(found("touchprobe"), found("touch probe"));
    assert_eq!(found("single-block"), found("single block"));
    assert_eq!(found("xyzzy calibration"), found("calibration"));
    assert_eq!(found("xyzzy plugh"), [""; 0]);
}

#[test]
fn enter_opens_the_best_match_at_its_line() {
    let mut session = on(Page::Help);
    send(&mut session, Field::from(HelpField::Search).typed("guard band".to_owned()));
    assert_eq!(shown(&session), (CONTENTS, None), "nothing is opened while something is typed");
    send(&mut session, Command::Enter(HelpField::Search.into()));
    assert_eq!(shown(&session), ("terms.md", Some("guard-band")));
    let mark = session.help().shown.mark.clone().unwrap();
    let page = ManualPage::of("terms.md").unwrap();
    let text: String = page.blocks[mark.block].spans().iter().map(|span| span.text.as_str()).collect();
    assert!(text.starts_with("A strip along a limit"), "{text}");
    // Another hit of the same page is another place.
    send(&mut session, HelpCommand::Select(1));
    assert_eq!(session.help().selected(), Some(1));
    act(&mut session, HelpAction::BackInHelp);
    act(&mut session, HelpAction::BackInHelp);
    assert_eq!(shown(&session), (CONTENTS, None));
    assert!(!session.can(HelpAction::BackInHelp));
}

/// Each of these words stands in the window.
#[test]
fn the_terms_explain_the_words_of_the_window() {
    let page = ManualPage::of("terms.md").unwrap();
    for term in [
        "verdict",
        "good",
        "rework",
        "scrap",
        "re-measure",
        "out-of-limits",
        "hole",
        "shaft",
        "callout",
        "nominal-size",
        "tolerance-class",
        "limits",
        "deviation",
        "middle-of-the-zone",
        "guard-band",
        "decision-rule",
        "expanded-uncertainty-u-and-k",
        "conformity",
        "proven",
        "supplier",
        "customer",
        "simulated",
        "record",
        "void",
        "corrected",
        "withdrawn",
        "standing",
        "journal",
        "chain",
        "lot",
        "plan",
        "feature",
        "serial-number",
        "clearance-fit",
        "interference-fit",
        "transition-fit",
        "contact",
        "criterion",
        "status-window",
        "mask",
        "budget",
        "contribution",
        "type-a",
        "type-b",
    ] {
        let first = page.below(term).first();
        assert!(matches!(first, Some(Block::Paragraph(spans)) if !spans.is_empty()), "{term} is not explained");
    }
    // In the list of topics it stands after the page of the window.
    let order: Vec<&str> = manual().iter().map(|page| page.file).collect();
    let at = |file: &str| order.iter().position(|known| *known == file).unwrap();
    assert_eq!(at("terms.md"), at("window.md") + 1);
}

/// What belongs to a picture that the window does not show is left out.
#[test]
fn no_heading_and_no_colon_stands_alone() {
    for page in manual() {
        for (number, block) in page.blocks.iter().enumerate() {
            let next = page.blocks.get(number + 1);
            let text: String = block.spans().iter().map(|span| span.text.as_str()).collect();
            match block {
                Block::Heading { level, .. } => {
                    let is_followed = match next {
                        Some(Block::Heading { level: below, .. }) => level < below,
                        other => other.is_some(),
                    };
                    assert!(is_followed, "{}: nothing stands below {text}", page.file);
                }
                Block::Paragraph(_) if text.trim_end().ends_with(':') => {
                    let is_followed = matches!(next, Some(Block::Item { .. } | Block::Table { .. } | Block::Code(_)));
                    assert!(is_followed, "{}: nothing follows: {text}", page.file);
                }
                Block::Table { rows, .. } => assert!(!rows.is_empty(), "{}: {block:?}", page.file),
                _ => {}
            }
        }
    }
}

/// What one does in the window comes first.
#[test]
fn the_command_line_is_the_last_heading_of_a_page_of_the_window() {
    for file in [
        "check.md",
        "records.md",
        "rules.md",
        "parts.md",
        "uncertainty.md",
        "temperature.md",
        "pairs.md",
        "fits.md",
        "cycles.md",
        "programs.md",
        "tables.md",
        "reports.md",
    ] {
        let page = ManualPage::of(file).unwrap();
        let place = page.blocks.iter().position(
            |block| matches!(block, Block::Heading { anchor, level: 2, .. } if anchor == "from-the-command-line"),
        );
        let place = place.unwrap_or_else(|| panic!("{file} has no such heading"));
        let (before, after) = page.blocks.split_at(place + 1);
        assert!(!after.iter().any(|block| matches!(block, Block::Heading { .. })), "{file}");
        let calls = |block: &Block| matches!(block, Block::Code(code) if code.contains("fitcheck "));
        assert!(!before.iter().any(calls), "{file} has commands before that");
        assert!(after.iter().any(calls), "{file}");
    }
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
