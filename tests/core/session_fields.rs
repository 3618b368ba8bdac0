//! The table of fields: each one has a name in every language, and a paragraph in the manual that says what it is for.

use std::collections::BTreeSet;

use fitcheck::probing::cycle::Key;
use fitcheck::probing::cycles::CYCLES;
use fitcheck::session::help::{Block, HelpPlace, HelpTopic, ManualPage};
use fitcheck::session::{
    CheckField, Command, CycleField, CyclesCommand, Field, FieldPlace, HelpCommand, Page, ProgramField, RecordsField,
    Session, WindowAction,
};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 26).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) {
    session.apply(command.into(), now());
}

/// The blocks of a paragraph.
fn paragraph(place: &HelpPlace) -> &'static [Block] {
    let HelpTopic::Manual(file) = place.topic else { panic!("{place:?}") };
    ManualPage::of(file).unwrap().below(place.anchor.as_deref().unwrap())
}

fn text(block: &Block) -> String {
    block.spans().iter().map(|span| span.text.as_str()).collect()
}

/// Unit, range, what stands there at first and an example, as the paragraph tells them.
fn row(place: &HelpPlace) -> Option<[String; 4]> {
    let table = paragraph(place).iter().find_map(|block| match block {
        Block::Table { head, rows } => Some((head, rows)),
        _ => None,
    })?;
    let plain = |cell: &Vec<fitcheck::session::help::Span>| cell.iter().map(|span| span.text.as_str()).collect();
    let head: Vec<String> = table.0.iter().map(plain).collect();
    assert_eq!(head, ["unit", "range", "at first", "example"], "{place:?}");
    let [one] = table.1.as_slice() else { panic!("{place:?}") };
    Some(std::array::from_fn(|at| plain(&one[at])))
}

#[test]
fn every_field_of_every_page_has_its_paragraph() {
    let mut session = Session::new(Language::En);
    let mut pages = BTreeSet::new();
    for cycle in CYCLES {
        send(&mut session, CyclesCommand::Choose(cycle.number));
        for field in session.fields() {
            let place = session.help_of(field);
            let blocks = paragraph(&place);
            assert!(
                blocks.first().is_some_and(|block| 20 < text(block).len()),
                "{field:?} has no paragraph: {place:?}"
            );
            pages.insert(field.page().name());
        }
    }
    assert_eq!(pages, Page::ALL.map(Page::name).into_iter().collect());
}

#[test]
fn two_fields_that_ask_for_different_things_have_different_paragraphs() {
    let session = Session::new(Language::En);
    let own = session
        .fields()
        .into_iter()
        .filter(|field| !matches!(field, Field::Cycles(_) | Field::Program(ProgramField::Input(_))));
    let mut seen = BTreeSet::new();
    for field in own {
        assert!(seen.insert(session.help_of(field).anchor), "{field:?} shares a paragraph");
    }
    assert!(100 < seen.len(), "{}", seen.len());
}

/// The manual says what a window really shows at its first start.
#[test]
fn the_manual_tells_what_stands_in_a_field_at_first() {
    let session = Session::new(Language::En);
    let mut told = 0;
    for field in session.fields().into_iter().filter(|field| !matches!(field, Field::Cycles(_))) {
        let [_, _, first, _] = row(&session.help_of(field)).unwrap_or_else(|| panic!("{field:?} has no table"));
        let first = if first == "empty" { "" } else { first.as_str() };
        assert_eq!(session.text(field), first, "{field:?}");
        told += 1;
    }
    assert!(100 < told, "{told}");
}

#[test]
fn the_example_of_a_paragraph_is_accepted_by_its_field() {
    for field in Session::new(Language::En).fields() {
        let mut session = Session::new(Language::En);
        let Some([.., example]) = row(&session.help_of(field)) else { continue };
        send(&mut session, field.typed(example.clone()));
        assert_eq!(session.error(field), None, "{field:?}: {example}");
    }
}

#[test]
fn every_field_has_a_name_in_every_language() {
    let session = Session::new(Language::En);
    for words in Language::all().map(Words::new) {
        for field in session.fields() {
            let name = session.field_name(field, &words);
            assert!(!name.trim().is_empty() && !name.contains("-page-"), "{field:?}: {name}");
        }
    }
}

#[test]
fn f1_opens_the_paragraph_of_the_field_and_returns_to_it() {
    let mut session = Session::new(Language::En);
    let field = Field::from(CheckField::CentreX);
    let place = session.help_of(field);
    send(&mut session, HelpCommand::At(Some((field, place.clone()))));
    send(&mut session, HelpCommand::ForPage);
    assert_eq!((session.page(), &session.help().shown), (Page::Help, &place));
    let effects = session.apply(HelpCommand::ForPage.into(), now());
    assert_eq!(session.page(), Page::Check);
    assert!(effects.contains(&fitcheck::session::Effect::Focus(field)));
    // Without a field it is the page.
    send(&mut session, HelpCommand::At(None));
    send(&mut session, HelpCommand::ForPage);
    assert_eq!(session.help().shown, HelpPlace::of(HelpTopic::Manual(Page::Check.manual())));
}

#[test]
fn f1_opens_a_heading_about_the_field() {
    let mut session = Session::new(Language::En);
    for cycle in CYCLES {
        send(&mut session, CyclesCommand::Choose(cycle.number));
        for field in session.fields() {
            let place = session.treated_in(field);
            let HelpTopic::Manual(file) = place.topic else { panic!("{field:?}: {place:?}") };
            let anchor = place.anchor.as_deref().unwrap_or_else(|| panic!("{field:?} has no heading"));
            assert!(ManualPage::of(file).is_some_and(|page| page.has(anchor)), "{field:?}: {place:?}");
            // A page that is not that of all fields belongs to the field's page or to its part of it.
            let own =
                [field.page().manual(), "fields.md", "rules.md", "temperature.md", "records.md", "shop-server.md"];
            assert!(own.contains(&file), "{field:?}: {place:?}");
        }
    }
    for (field, file, anchor) in [
        (Field::from(CheckField::Uncertainty), "rules.md", "the-uncertainty-of-the-value"),
        (CheckField::GuardWidth.into(), "rules.md", "fixed-guard-band"),
        (CheckField::PartTemperature.into(), "temperature.md", "temperature-on-the-check-page"),
        (CheckField::Serial.into(), "records.md", "what-is-recorded"),
        (RecordsField::Who.into(), "records.md", "what-is-recorded"),
    ] {
        assert_eq!(session.treated_in(field), HelpPlace::at(file, anchor), "{field:?}");
    }
}

#[test]
fn f1_in_a_part_that_folds_away_opens_what_is_said_of_it() {
    let mut session = Session::new(Language::En);
    let folds: BTreeSet<&str> = session
        .fields()
        .into_iter()
        .filter(|field| field.page() == Page::Check)
        .filter_map(|field| match session.place_of(field) {
            FieldPlace::Fold(name) => Some(name),
            _ => None,
        })
        .collect();
    assert!(4 < folds.len(), "{folds:?}");
    for name in folds {
        let place = Session::fold_treated_in(name).unwrap_or_else(|| panic!("{name}"));
        let HelpTopic::Manual(file) = place.topic else { panic!("{place:?}") };
        assert!(ManualPage::of(file).unwrap().has(place.anchor.as_deref().unwrap()), "{place:?}");
    }
    send(&mut session, HelpCommand::Within(Session::fold_treated_in("check-rule-section")));
    send(&mut session, HelpCommand::ForPage);
    assert_eq!(session.help().shown, HelpPlace::at("rules.md", "choose-a-rule"));
}

#[test]
fn the_paragraph_beside_a_field_belongs_to_that_field() {
    let mut session = Session::new(Language::En);
    assert!(!session.can(WindowAction::Explain), "no field has the focus");
    let at = |field: CheckField| HelpCommand::At(Some((field.into(), HelpPlace::of(HelpTopic::Keys))));
    send(&mut session, at(CheckField::Seed));
    send(&mut session, HelpCommand::Explain(true));
    assert!(session.help().explains);
    send(&mut session, at(CheckField::Lobes));
    assert!(!session.help().explains);
}

#[test]
fn a_parameter_of_a_cycle_means_what_its_cycle_says() {
    let mut session = Session::new(Language::En);
    let anchors = |session: &Session| {
        let fields =
            session.fields().into_iter().filter(|field| matches!(field, Field::Cycles(CycleField::Parameter(_))));
        fields.filter_map(|field| session.help_of(field).anchor).collect::<BTreeSet<String>>()
    };
    send(&mut session, CyclesCommand::Choose(421));
    let of_421 = anchors(&session);
    assert!(of_421.contains("stepping-angle") && !of_421.contains("measured-point"), "{of_421:?}");
    send(&mut session, CyclesCommand::Choose(427));
    let of_427 = anchors(&session);
    assert!(of_427.contains("measured-point") && !of_427.contains("stepping-angle"), "{of_427:?}");
}

#[test]
fn a_field_can_be_gone_to_only_where_it_stands() {
    let session = Session::new(Language::En);
    let stands = |field: CheckField| session.stands(field.into());
    assert_eq!(session.place_of(CheckField::CentreX.into()), FieldPlace::Fold("probe-position"));
    // Of cycle 421: a nominal value has none of its own, the measuring height and the set-up clearance have one.
    for (number, place) in [
        (273, FieldPlace::Page),
        (261, FieldPlace::Fold("cycles-optional-position")),
        (320, FieldPlace::Fold("cycles-group-probing")),
    ] {
        let field = CycleField::Parameter(Key::Q(number)).into();
        assert_eq!(session.place_of(field), place, "Q{number}");
    }
    assert!(stands(CheckField::Callout) && stands(CheckField::CentreX));
    // Without a rule that takes it, and without checks, there is none.
    assert!(!stands(CheckField::GuardWidth) && !stands(CheckField::HistoryFilter));
}
