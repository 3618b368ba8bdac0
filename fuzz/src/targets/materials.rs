//! Any text as a file of materials: each of them is found by its names, in capitals too, and comes before a built-in one.

use fitcheck::tolerance::fit::materials::{MOST, Materials};
use fitcheck::words::Language;

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let own = match Materials::read(text) {
        Ok(own) => own,
        Err(error) => return told(bytes, &error),
    };
    assert!(own.iter().count() <= MOST);
    let all = Materials::shipped().with_own(own.clone());
    for material in own.iter() {
        assert_eq!(material.expansion.to_string().parse(), Ok(material.expansion));
        for name in [&material.name, material.name_in(Language::Nl)] {
            assert_eq!(own.find(name), Ok(material));
            assert_eq!(own.find(&name.to_uppercase()).is_ok(), own.find(&name.to_uppercase().to_lowercase()).is_ok());
            assert_eq!(all.find(name).map(|found| &found.name), Ok(&material.name));
        }
    }
}
