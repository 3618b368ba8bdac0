//! Any bytes as a saved state: it is written and read back as the same; a session that begins with it saves a state that
//! begins the same session. The same bytes as a file of settings: a second import changes nothing.

use fitcheck::session::{Command, Saved, Session};
use fitcheck::words::Language;
use jiff::civil::DateTime;

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let saved = match Saved::read(bytes) {
        Ok(saved) => saved,
        Err(error) => return told(bytes, &error),
    };
    assert_eq!(Saved::read(&saved.write().unwrap()).as_ref(), Ok(&saved));
    let (session, effects) = Session::restore(saved.clone());
    assert_eq!(effects.len(), usize::from(saved.tables_folder.is_some()));
    let kept = session.saved();
    assert_eq!(Saved::read(&kept.write().unwrap()).as_ref(), Ok(&kept));
    assert_eq!(Session::restore(kept.clone()).0.saved(), kept);
    import(&String::from_utf8_lossy(bytes));
}

fn import(text: &str) {
    let mut station = Session::new(Language::En);
    let mut read = || {
        let command = Command::SettingsRead { path: "settings.toml".into(), result: Ok(text.to_owned()) };
        station.apply(command, DateTime::MIN);
        station.saved()
    };
    let first = read();
    assert_eq!(read(), first);
}
