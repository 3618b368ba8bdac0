//! The part that is measured as a report, without a window: its status, its picture, and why there is none.

use fitcheck::session::{PartsAction, WalkField};
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck::message::Message;
use fitcheck::part::Document;
use fitcheck::report::image::Image;
use fitcheck::session::parts::{PartPicture, PlanCommand, WalkCommand};
use fitcheck::session::{Command, Content, Effect, Field, Page, PartsCommand, Purpose, Session};
use fitcheck::words::Language;
use jiff::civil::{DateTime, date};

const PLAN: &str = "fitcheck_plan = 1\npart = \"Flange\"\npicture = \"flange.svg\"\n[[feature]]\nname = \"BORE\"\n\
    callout = \"25 H7\"\nballoon_x = 0.25\nballoon_y = 0.5\n";

const SVG: &[u8] = b"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2\" height=\"1\"/>";

fn now() -> DateTime {
    date(2026, 11, 24).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

/// A part of which the only size is measured; what became of the picture comes as `result`.
fn measured(result: Option<Result<PartPicture, Message>>) -> Session {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(Page::Parts));
    let path = PathBuf::from("/plans/flange.toml");
    let document = Box::new(Document::read(PLAN.as_bytes()).unwrap());
    send(&mut session, PartsCommand::Plan(PlanCommand::Read { path, result: Ok(document) }));
    if let Some(result) = result {
        let path = PathBuf::from("/plans/flange.svg");
        send(&mut session, PartsCommand::Plan(PlanCommand::PictureRead { path, result: result.map(Arc::new) }));
    }
    assert!(!session.can(PartsAction::ReportPart(0)));
    send(&mut session, WalkCommand::Begin);
    let typed = Field::from(WalkField::Value).typed("25.012".to_owned());
    send(&mut session, typed);
    send(&mut session, WalkCommand::Take);
    session
}

/// The report, as a format of the list.
fn report(session: &mut Session, format: usize) -> String {
    let open = PartsAction::ReportPart(format).command(session).unwrap();
    send(session, open);
    assert_eq!(session.dialog().unwrap().purpose, Purpose::ReportPart(format));
    send(session, Command::TypePath("/reports/part.out".to_owned()));
    let effects = send(session, Command::Confirm);
    let [Effect::ForDialog(_, effect)] = effects.as_slice() else { panic!("{effects:?}") };
    let Effect::Save(_, content @ Content::Report { .. }) = effect.as_ref() else { panic!("{effect:?}") };
    String::from_utf8(content.bytes().unwrap()).unwrap()
}

#[test]
fn a_part_is_reported_with_its_status_and_its_picture() {
    let picture = PartPicture { size: [2, 1], dots: vec![255; 8], file: Image::read("flange.svg", SVG).unwrap() };
    let page = report(&mut measured(Some(Ok(picture))), 0);
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{text:?} is missing in\n{page}"));
    assert!(at("<svg class=\"verdict good\"") < at("1 measured, 0 missing, 0 skipped"));
    assert!(at("1 measured, 0 missing") < at("<img src=\"data:image/svg+xml;base64,PHN2ZyB4bWxucz0i"));
    assert!(at("<img src") < at("<svg class=\"balloon good\" x=\"25.00%\" y=\"50.00%\""));
    assert!(at("typed") < at("<section class=\"check\""));
    assert!(!page.contains("Missing"));
}

#[test]
fn a_picture_that_is_not_there_is_told_in_the_report() {
    let why = Message::new("parts-page-picture-kind").text("name", "flange.svg");
    let page = report(&mut measured(Some(Err(why))), 0);
    assert!(page.contains("flange.svg is not a PNG, JPEG or SVG picture") && !page.contains("<img"));
    let page = report(&mut measured(None), 0);
    assert!(page.contains("Reading the picture") && !page.contains("<img"));
}
