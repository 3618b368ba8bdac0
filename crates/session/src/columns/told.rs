//! What a notice says of the columns of its file.

use fitcheck_core::message::message;
use fitcheck_exchange::exchange::Role;

use super::{NoticeColumns, UnitLess, role_id, unit_id};
use crate::notice::Notice;
use crate::shared::Shared;

impl Shared {
    /// A notice of a file says what its columns were taken for, and offers to correct that, or to say the unit that it lacks.
    pub fn add_columns(&mut self, notice: &mut Notice, name: &str) {
        if let Some(UnitLess { path, into, .. }) = self.columns.unit_less.take().filter(|file| file.name == name) {
            notice.columns = Some(NoticeColumns { path, into, shape: None, lacks_unit: true });
            return;
        }
        let Some(used) = self.columns.used.take().filter(|used| used.name == name) else { return };
        let words = self.words();
        let detected = &used.detected;
        let of_column = |(at, role): (usize, &Option<Role>)| {
            let name = detected.names.get(at).filter(|name| !name.is_empty()).cloned();
            let message = message!("columns-page-taken-one")
                .text("column", name.unwrap_or_else(|| (at + 1).to_string()))
                .text("role", words.get(&role_id(Some((*role)?))));
            Some(words.say(&message))
        };
        let columns: Vec<String> = (0..).zip(&detected.roles).filter_map(of_column).collect();
        let message = message!("columns-page-taken")
            .text("columns", columns.join(", "))
            .text("unit", words.get(unit_id(detected.mapping.unit())));
        let remembered = used.remembered.as_ref();
        let said = remembered.map(|(_, day)| message!("columns-page-remembered").text("day", day));
        let from = detected.unit_from.as_ref().map(|from| message!("columns-page-unit-from").text("from", from));
        notice.details.extend(said.into_iter().chain([message]).chain(from));
        let shape = remembered.map(|(shape, _)| shape.clone());
        notice.columns = Some(NoticeColumns { path: used.path, into: used.into, shape, lacks_unit: false });
    }
}
