//! Who is measuring: a name that is chosen once and kept, and the names before it.

use super::SavedRecords;

/// How many names are kept.
pub const MOST_NAMES: usize = 8;

/// Names, the latest first.
#[derive(Debug, Default)]
pub(super) struct People {
    pub who: String,
    pub names: Vec<String>,
}

impl People {
    pub fn new(saved: &SavedRecords) -> Self {
        let mut people = Self { who: String::new(), names: saved.names.clone() };
        people.names.truncate(MOST_NAMES);
        people.choose(&saved.who);
        people
    }

    pub fn saved(&self) -> (String, Vec<String>) {
        (self.who.clone(), self.names.clone())
    }

    /// Somebody else measures from now on; an empty name is nobody.
    pub fn choose(&mut self, name: &str) {
        name.trim().clone_into(&mut self.who);
        if !self.who.is_empty() {
            self.names.retain(|known| *known != self.who);
            self.names.insert(0, self.who.clone());
            self.names.truncate(MOST_NAMES);
        }
    }
}
