//! Which fields of a mask tell the part, by the words before them: `PART: %D`, `SERIAL NO. %S`, `OPERATOR: %S`.

use fitcheck_nc::control::mask::{FieldContent, Printed, Slot};

use super::fields::value;
use crate::exchange::imported::Labels;
use crate::exchange::role::Role;
use crate::exchange::series::{self, Tells};

/// The fields that tell the part, and what else is the same for all values of a print.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct PartFields(Vec<(usize, Tells)>);

impl PartFields {
    pub(super) fn of(slots: &[Slot]) -> Self {
        // A number with decimals is a measured value or a limit.
        let may_tell =
            |slot: &Slot| matches!(slot.of, FieldContent::Parameter(_)) && slot.digits.is_none_or(|digits| digits == 0);
        let fields = (0..).zip(slots).filter(|(_, slot)| may_tell(slot));
        Self(fields.filter_map(|(at, slot)| Some((at, Tells::of(&slot.label, slot.digits.is_none())?))).collect())
    }

    /// Whether a print says of which part it is.
    pub(super) fn is_any(&self) -> bool {
        self.0.iter().any(|(_, tells)| tells.is_of_part())
    }

    pub(super) fn has(&self, at: usize) -> bool {
        self.0.iter().any(|(own, _)| *own == at)
    }

    /// Takes out the text of a part: it is the name of what was measured.
    pub(super) fn take_named(&mut self, slots: &[Slot]) -> Option<usize> {
        let is_named = |(at, tells): &(usize, Tells)| {
            *tells == Tells::Label(Role::Part) && slots.get(*at).is_some_and(|slot| slot.digits.is_none())
        };
        let found = self.0.iter().position(is_named)?;
        Some(self.0.remove(found).0)
    }

    /// What a print says of its part.
    pub(super) fn labels(&self, printed: &Printed) -> Labels {
        series::labels(self.0.iter().filter_map(|(at, tells)| Some((*tells, value(printed, *at)?))))
    }
}
