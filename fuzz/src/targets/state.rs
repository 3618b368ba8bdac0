//! Any bytes as a saved state: it is written and read back as the same; a session that begins with it saves a state that
//! begins the same session.

use fitcheck::session::{Saved, Session};

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
}
