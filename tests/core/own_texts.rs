//! Texts of the user's own: read with their places, refused where they would say less or another verdict, and said where they count.

#![cfg(test)]

use std::sync::Arc;

use fitcheck::message::{LARGEST_TEXTS, Message, OwnTexts, READ_BACK, Say as _};
use fitcheck::session::{CheckCommand, CheckField, Command, Effect, Purpose, Saved, Session, SettingsAction};
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};

/// The texts of a file, all of which count.
#[track_caller]
fn whole(text: &str) -> OwnTexts {
    let own = OwnTexts::read("nl_OurShop.ftl", text.as_bytes()).unwrap();
    assert_eq!(own.refused(), [], "{text}");
    own
}

/// Why texts of a file are refused, each with its place.
fn refused(text: &str) -> Vec<String> {
    let own = OwnTexts::read("nl_OurShop.ftl", text.as_bytes()).unwrap();
    assert_eq!(own.refused_count(), own.refused().len());
    own.refused().iter().map(ToString::to_string).collect()
}

/// The only reason.
#[track_caller]
fn reason(text: &str) -> String {
    let all = refused(text);
    assert_eq!(all.len(), 1, "{text}: {all:#?}");
    all.into_iter().next().unwrap()
}

fn words(own: OwnTexts, language: Language) -> Words {
    Words::new(language).with_own(Some(Arc::new(own)))
}

#[test]
fn own_texts_are_said_and_what_the_file_lacks_is_said_in_the_built_in_words() {
    let own = whole(
        "# Our words\nstatus-good = PRIMA\nmeasured-value =\n    Gemeten\n    maat\n\nlot-unjudged = { $count } nog open\n",
    );
    assert_eq!((own.count(), own.code(), own.file()), (3, "nl", "nl_OurShop.ftl"));
    assert!(3_600 < OwnTexts::count_of_all());
    let words = words(own, Language::Nl);
    assert_eq!(words.told(&Status::Good), "PRIMA");
    assert_eq!(words.get("measured-value"), "Gemeten\nmaat");
    assert_eq!(words.say(&Message::new("lot-unjudged").count("count", 3)), "3 nog open");
    assert_eq!(words.told(&Status::Scrap), Words::new(Language::Nl).told(&Status::Scrap));
}

#[test]
fn an_escape_without_its_digits_is_refused_where_it_stands() {
    let said = reason("lot-unjudged = { $count }{ \"\\u٣E\" }\n");
    assert!(said.contains("\\u takes four hexadecimal digits"), "{said}");
    // Without quotation marks it is none.
    assert_eq!(words(whole("measured-value = C:\\users\n"), Language::Nl).get("measured-value"), "C:\\users");
}

#[test]
fn own_texts_of_one_language_do_not_count_in_another() {
    let own = whole("status-good = PRIMA\n");
    for language in Language::all().filter(|language| *language != Language::Nl) {
        let words = words(own.clone(), language);
        assert_eq!(words.told(&Status::Good), Words::new(language).told(&Status::Good));
        assert!(words.own().is_none());
    }
}

#[test]
fn a_misspelt_name_is_told_with_its_place_and_the_nearest_name() {
    let told = reason("measured-value = Maat\n\nmeasured-valeu = Maat\n");
    assert_eq!(
        told,
        "there is no text measured-valeu. The nearest name is measured-value: correct it or delete it: nl_OurShop.ftl, line 3, column 1"
    );
    assert!(reason("quite-another-thing-altogether = x\n").contains("no name is like it"));
}

#[test]
fn a_text_that_lost_a_figure_is_refused_and_the_others_count() {
    let own = OwnTexts::read("nl.ftl", b"lot-unjudged = nog open\nmeasured-value = Maat\n").unwrap();
    assert_eq!((own.count(), own.refused_count()), (1, 1));
    let told = own.refused()[0].to_string();
    assert!(told.starts_with("lot-unjudged lacks { $count } of the built-in text"), "{told}");
    let built_in = Words::new(Language::Nl);
    let message = Message::new("lot-unjudged").count("count", 3);
    assert_eq!(words(own, Language::Nl).say(&message), built_in.say(&message));
}

#[test]
fn a_figure_that_one_variant_lost_is_missed() {
    let message =
        "located-at-line = { $line ->\n    [1] regel een: { $what }\n   *[other] { $line }: { $what }\n    }\n";
    assert!(reason(message).contains("lacks { $line }"), "{}", reason(message));
    whole("located-at-line = { $line ->\n    [1] { $line }! { $what }\n   *[other] { $line }: { $what }\n    }\n");
    let prover = "rule-fixed = { $width }, { $prover ->\n   *[supplier] leverancier\n    }\n";
    assert!(reason(prover).contains("lacks { $prover -> [customer] … }"), "{}", reason(prover));
    whole("rule-fixed = { $width }, { $prover ->\n    [supplier] leverancier\n   *[customer] klant\n    }\n");
    // A text within the text.
    assert!(reason("status-simulated = { $status }\n").contains("lacks { simulated }"));
}

#[test]
fn a_placeable_that_nothing_is_put_in_for_is_refused() {
    for (text, expected) in [
        (
            "lot-unjudged = { $count } van { $all }\n",
            "has { $all }, which nothing is put in for. Only { $count } can be shown",
        ),
        ("measured-value = { $value }\n", "has { $value }, but nothing is put into this text"),
        ("measured-value = { status-good }\n", "has { status-good }"),
        ("measured-value = { -brand }\n", "has { -brand }"),
        ("measured-value = { NUMBER(\"1\") }\n", "has { NUMBER() }"),
        ("measured-value = { \"x\" ->\n   *[other] y\n    }\n", "measured-value has {"),
    ] {
        assert!(reason(text).contains(expected), "{text}: {}", reason(text));
    }
}

#[test]
fn what_is_no_text_is_told_with_what_to_do() {
    for (text, expected) in [
        ("measured-value = { $value\n", "cannot be read as Fluent"),
        ("measured value = x\n", "cannot be read as Fluent"),
        ("just a line\n", "cannot be read as Fluent"),
        ("  indented = x\n", "cannot be read as Fluent"),
        ("-brand = x\n", "is a term or has attributes"),
        ("measured-value = x\n    .hint = y\n", "is a term or has attributes"),
        ("measured-value =\n", "has an empty text"),
        ("measured-value =\n\nfit-hole-measured = Gat\n", "has an empty text"),
        ("measured-value = {\" \"}\n", "has an empty text"),
        ("measured-value = \u{200b}\n", "has an empty text"),
        ("measured-value = a\u{1b}[31m\n", "has the control character U+001B"),
        ("measured-value = a\rb\n", "has the control character U+000D"),
        ("measured-value = {\"\\u202E\"}\n", "has the control character U+202E"),
        ("language-name = Nederlandsch\n", "belongs to the language"),
        ("language-decimal-sign = .\n", "belongs to the language"),
    ] {
        assert!(reason(text).contains(expected), "{text}: {}", reason(text));
        assert!(reason(text).contains(": nl_OurShop.ftl, line 1, column "), "{text}: {}", reason(text));
    }
    assert!(reason("measured-value = ab\u{7}\n").ends_with("line 1, column 20"));
}

#[test]
fn a_name_given_twice_counts_neither_time() {
    let text = "measured-value = een\nstatus-good = PRIMA\nmeasured-value = twee\n";
    let told = reason(text);
    assert!(told.starts_with("measured-value is given twice, first in line 1, and neither counts"), "{told}");
    assert!(told.ends_with("line 3, column 1"), "{told}");
    let own = OwnTexts::read("nl.ftl", text.as_bytes()).unwrap();
    assert_eq!(words(own, Language::Nl).get("measured-value"), Words::new(Language::Nl).get("measured-value"));
}

#[test]
fn verdicts_stay_different_from_each_other_or_none_of_their_own_words_counts() {
    for text in [
        "status-good = FIJN\nstatus-scrap = fijn!\n",
        // In the built-in words of the language, or of machines.
        "status-scrap = GOED\nstatus-good = PRIMA\n",
        "status-scrap = Good\n",
        "status-good = WEG\nrows-not-judged = WEG\n",
        "simulated = GOED\n",
    ] {
        let own = OwnTexts::read("nl.ftl", format!("{text}measured-value = Maat\n").as_bytes()).unwrap();
        assert_eq!((own.count(), own.refused_count()), (1, text.lines().count()), "{text}: {:?}", own.refused());
        assert!(own.refused().iter().all(|told| told.to_string().contains("Verdicts need words of their own")));
        let words = words(own, Language::Nl);
        for status in Status::ALL {
            assert_eq!(words.told(&status), Words::new(Language::Nl).told(&status), "{text}");
        }
    }
    whole("status-good = PRIMA\nstatus-rework = NAWERK\nstatus-scrap = WEG\nreport-side-good = prima\n");
}

#[test]
fn the_built_in_words_of_verdicts_are_different_in_every_language() {
    for language in Language::all() {
        let built_in = Words::new(language);
        let words = Status::ALL.map(|status| {
            let id = status.message().id;
            format!("{id} = {}\n", built_in.get(id))
        });
        let file = words.concat();
        let own = OwnTexts::read(&format!("{language}.ftl"), file.as_bytes()).unwrap();
        assert_eq!((own.count(), own.refused()), (Status::ALL.len(), &[][..]), "{language}");
    }
}

#[test]
fn every_built_in_text_may_be_given_as_it_is() {
    for language in Language::all() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/locales").join(language.code());
        let mut text = String::new();
        for entry in std::fs::read_dir(folder).unwrap() {
            text += &std::fs::read_to_string(entry.unwrap().path()).unwrap();
            text += "\n";
        }
        let own = OwnTexts::read(&format!("{language}_all.ftl"), text.as_bytes()).unwrap();
        let told: Vec<String> = own.refused().iter().map(ToString::to_string).collect();
        // What is read back, and what a language says of itself.
        assert_eq!(own.refused_count(), READ_BACK.len() + 2, "{language}: {told:#?}");
        assert_eq!(own.count() + own.refused_count(), OwnTexts::count_of_all(), "{language}");
    }
}

#[test]
fn texts_that_are_read_back_as_evidence_cannot_be_replaced() {
    for name in READ_BACK {
        let told = reason(&format!("{name} = gemeten\n"));
        assert!(
            told.starts_with(&format!("{name} says where a value comes from and is read back from files")),
            "{told}"
        );
    }
}

#[test]
fn a_file_that_cannot_be_read_says_why() {
    let read = |name: &str, bytes: &[u8]| OwnTexts::read(name, bytes).unwrap_err().to_string();
    assert_eq!(
        read("nl.ftl", b"status-good = PRIMA\nmeasured-value = ma\xe4t\n"),
        "byte E4 is no UTF-8: save the file as UTF-8: nl.ftl, line 2, column 20"
    );
    assert!(read("ours.ftl", b"").contains("ours.ftl begins with no code of a language"));
    assert!(read("xx.ftl", b"").contains("begins with one of cs, de, en, es, fr, it, nl, pl"));
    assert!(read("nl.ftl", &vec![b' '; LARGEST_TEXTS + 1]).contains("may have 1048576"));
    OwnTexts::read("NL-shop.ftl", &vec![b' '; LARGEST_TEXTS]).unwrap();
}

#[test]
fn hostile_files_are_told_and_stop_nothing() {
    let long = |begin: &str, piece: &str| begin.to_owned() + &piece.repeat((LARGEST_TEXTS - begin.len()) / piece.len());
    for text in [
        long("measured-value = ", "{"),
        long("measured-value = ", "{A("),
        long("measured-value = ", "{ $a ->\n[a] "),
        long("measured-value = ", "x"),
        long("measured-value = ", "x\n "),
        long("", "="),
        long("", "{\n"),
        long("", "}\n"),
        long("", "measured-value = { $a }\n"),
        long("", "a-name-that-is-not-there = x\n"),
        long("", "\u{feff}"),
    ] {
        let own = OwnTexts::read("nl.ftl", text.as_bytes()).unwrap();
        assert_eq!(own.count(), 0);
        assert!(0 < own.refused_count() && own.refused().len() <= 200);
    }
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

/// The answer of the outside world to the wish for a file.
fn read(path: &str, text: &str) -> Command {
    let name = path.rsplit('/').next().unwrap();
    let result = OwnTexts::read(name, text.as_bytes()).map(Arc::new).map_err(|error| error.message());
    Command::TextsRead { path: path.into(), result }
}

fn said(messages: &[Message]) -> Vec<String> {
    messages.iter().map(ToString::to_string).collect()
}

/// What the settings say of own texts.
fn told(session: &Session) -> Vec<String> {
    session.own_texts().map_or_else(Vec::new, |chosen| said(&chosen.told(session.language())))
}

#[test]
fn the_settings_say_how_many_texts_count_and_which_are_refused() {
    let mut session = Session::new(Language::Nl);
    send(&mut session, read("/shop/nl_OurShop.ftl", "measured-value = Maat\nstatus-god = PRIMA\n"));
    let lines = told(&session);
    assert!(lines[0].starts_with("/shop/nl_OurShop.ftl: 1 of 4\u{a0}"), "{lines:?}");
    assert_eq!(lines[1], "1 text is refused, and the built-in one is said:");
    assert!(
        lines[2].contains("The nearest name is status-good") && lines[2].ends_with("line 2, column 1"),
        "{lines:?}"
    );
    // A notice tells it at once.
    let notice = session.notices().last().unwrap();
    assert_eq!(said(&notice.details), lines[1..]);
    assert_eq!(session.texts_of_window().unwrap().count(), 1);
    // In another language they do not count, and that is said.
    send(&mut session, Command::SetLanguage(Language::En));
    assert!(session.texts_of_window().is_none());
    assert!(told(&session)[1].contains("texts in Nederlands and count only while the window speaks that language"));
    let leave = SettingsAction::NoOwnTexts.command(&session).unwrap();
    send(&mut session, leave);
    assert!(told(&session).is_empty() && !session.can(SettingsAction::NoOwnTexts));
}

#[test]
fn many_refused_texts_are_counted_and_the_first_ones_listed() {
    let mut session = Session::new(Language::Nl);
    send(&mut session, read("nl.ftl", &"measured-value = x { $a }\n".replace("value", "valeu").repeat(500)));
    let lines = told(&session);
    assert_eq!(lines[1], "500 texts are refused, and the built-in ones are said:");
    assert_eq!((lines.len(), lines.last().unwrap().as_str()), (23, "… and 480 more"));
}

#[test]
fn own_texts_are_read_again_at_the_next_start() {
    let mut first = Session::new(Language::Nl);
    send(&mut first, read("/shop/nl.ftl", "status-good = PRIMA\n"));
    let saved = Saved::read(&first.saved().write().unwrap()).unwrap();
    let (mut again, effects) = Session::restore(saved.clone());
    assert_eq!(effects, [Effect::Read(Purpose::LoadTexts, "/shop/nl.ftl".into())]);
    assert_eq!(told(&again), ["/shop/nl.ftl is being read"]);
    send(&mut again, read("/shop/nl.ftl", "status-good = PRIMA\n"));
    assert_eq!(again.texts_of_window().unwrap().count(), 1);
    assert!(again.notices().is_empty(), "nothing is wrong");
    // One that cannot be read then is told, stays chosen, and may be there the next time.
    let (mut gone, _effects) = Session::restore(saved);
    let missing = Message::new("file-missing").text("path", "/shop/nl.ftl");
    send(&mut gone, Command::TextsRead { path: "/shop/nl.ftl".into(), result: Err(missing) });
    assert!(gone.notices()[0].is_problem);
    assert!(told(&gone)[0].starts_with("/shop/nl.ftl could not be read and is not in use: "), "{:?}", told(&gone));
    assert!(gone.texts_of_window().is_none());
    assert_eq!(gone.saved().own_texts, Some("/shop/nl.ftl".into()));
}

#[test]
fn an_answer_that_comes_too_late_changes_nothing() {
    let mut saved = Saved::default();
    saved.own_texts = Some("/shop/nl.ftl".into());
    let (mut session, _effects) = Session::restore(saved);
    send(&mut session, Command::SetLanguage(Language::Nl));
    send(&mut session, Command::NoOwnTexts);
    send(&mut session, read("/shop/nl.ftl", "status-good = PRIMA\n"));
    assert!(session.own_texts().is_none() && session.texts_of_window().is_none());
}

#[test]
fn a_report_for_people_has_own_texts_and_files_for_machines_have_none() {
    let mut session = Session::new(Language::Nl);
    send(&mut session, read("nl.ftl", "status-good = <i>PRIMA\n"));
    for (field, text) in [(CheckField::Callout, "25 H7"), (CheckField::Measured, "25.012")] {
        send(&mut session, CheckCommand::Type(field, text.to_owned()));
    }
    send(&mut session, CheckCommand::Measure);
    for (rendering, expected) in [("html", true), ("csv", false), ("json", false)] {
        let at = fitcheck::report::RENDERINGS.iter().position(|known| known.name == rendering).unwrap();
        send(&mut session, Command::OpenDialog(Purpose::Export(at)));
        send(&mut session, Command::TypePath(format!("/tmp/report.{rendering}")));
        let effects = send(&mut session, Command::Confirm);
        let content = effects.iter().find_map(|effect| match effect.errand() {
            Effect::Save(_, content) => Some(content.bytes().unwrap()),
            _ => None,
        });
        let text = String::from_utf8(content.unwrap_or_else(|| panic!("{effects:?}"))).unwrap();
        assert_eq!(text.contains("PRIMA"), expected, "{rendering}");
        assert!(!text.contains("<i>PRIMA"), "{rendering}: a text is no mark of the page");
        send(&mut session, Command::Close);
    }
}
