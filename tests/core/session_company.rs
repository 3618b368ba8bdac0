//! The company of the settings: it stands on reports whose template names none, survives a restart, and a logo that is none is told.

use std::path::PathBuf;

use fitcheck::message::message;
use fitcheck::report::image::Image;
use fitcheck::session::{Command, Content, Effect, Page, Purpose, Saved, Session, SettingsCommand, SettingsField};
use fitcheck::words::Language;

use crate::session_records::{measure, send, typed};

const SVG: &[u8] =
    b"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 2 1\"><rect width=\"2\" height=\"1\"/></svg>";

fn place(name: &str) -> PathBuf {
    std::env::temp_dir().join(name)
}

/// The report of the list as a page.
fn page(session: &mut Session) -> String {
    let at = fitcheck::report::RENDERINGS.iter().position(|rendering| rendering.name == "html").unwrap();
    send(session, Command::OpenPage(Page::Check));
    send(session, Command::OpenDialog(Purpose::Export(at)));
    send(session, Command::TypePath("/reports/a.html".to_owned()));
    let effects = send(session, Command::Confirm);
    let Some(Effect::Save(_, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert!(matches!(content, Content::Report { .. }));
    send(session, Command::Close);
    String::from_utf8(content.bytes().unwrap()).unwrap()
}

#[test]
fn name_address_and_logo_stand_at_the_top_and_survive_a_restart() {
    let mut session = Session::new(Language::En);
    measure(&mut session, "25 H7", "25.012");
    assert!(!page(&mut session).contains("class=\"company\""));
    typed(&mut session, SettingsField::Company, "Northgate <Precision>");
    typed(&mut session, SettingsField::CompanyAddress, "Mill shop 2; Room 4;");
    let effects = typed(&mut session, SettingsField::CompanyLogo, place("logo.svg").to_str().unwrap());
    assert!(effects.contains(&Effect::ReadLogo(place("logo.svg"))), "{effects:?}");
    let result = Image::read("logo.svg", SVG);
    send(&mut session, SettingsCommand::LogoRead { path: place("logo.svg"), result });
    let said = page(&mut session);
    for text in ["Northgate &#60;Precision&#62;", "<bdi>Mill shop 2</bdi>", "<bdi>Room 4</bdi>", "data:image/svg+xml"] {
        assert!(said.contains(text), "{text}: {said:.4000}");
    }
    let saved = session.saved();
    assert_eq!(
        (saved.company.name.as_str(), saved.company.address.as_str()),
        ("Northgate <Precision>", "Mill shop 2; Room 4;")
    );
    let again = Saved::read(saved.write().unwrap().as_slice()).unwrap();
    let (_, effects) = Session::restore(again);
    assert!(effects.contains(&Effect::ReadLogo(place("logo.svg"))), "{effects:?}");
}

#[test]
fn a_logo_that_is_none_is_told_and_the_report_is_written() {
    let mut session = Session::new(Language::En);
    measure(&mut session, "25 H7", "25.012");
    typed(&mut session, SettingsField::CompanyLogo, "logo.svg");
    let why = session.error(SettingsField::CompanyLogo).map(ToString::to_string).unwrap_or_default();
    assert!(why.contains("logo.svg is not a whole path"), "{why}");
    assert!(page(&mut session).contains("logo.svg is not a whole path"));
    typed(&mut session, SettingsField::CompanyLogo, place("gone.png").to_str().unwrap());
    let result = Err(message!("parts-page-picture-none"));
    // Of another file: it was typed over meanwhile.
    send(&mut session, SettingsCommand::LogoRead { path: place("other.png"), result: result.clone() });
    assert!(session.error(SettingsField::CompanyLogo).is_none());
    send(&mut session, SettingsCommand::LogoRead { path: place("gone.png"), result });
    assert!(session.error(SettingsField::CompanyLogo).is_some());
    assert!(page(&mut session).contains("<em>"));
}
