//! What the switches among the actions are set to.

use super::Action;
use super::possible::{is_of_1988, rounds_js};
use crate::Session;

/// Whether what an action switches is on; `None` where it switches nothing.
pub(super) fn is_on(action: Action, session: &Session) -> Option<bool> {
    Some(match action {
        Action::Open(page) => session.page() == page,
        Action::UseTheme(theme) => session.theme() == theme,
        Action::UseDensity(density) => session.density() == density,
        Action::UseSource(base) => session.sources().base() == base,
        Action::RoundJs => rounds_js(session.sources().options()),
        Action::Edition1988 => is_of_1988(session.sources().options()),
        Action::Keypad => session.has_keypad(),
        Action::ShowRows(shows_rows) => session.check().shows_rows() == shows_rows,
        Action::OnlyBad => session.history().listed().query().only_bad,
        Action::AllFiles => session.dialog().is_some_and(|dialog| dialog.list.shows_all()),
        Action::MeasureBy(by) => session.check().by() == by,
        Action::ShowClasses(feature) => session.fit().side() == feature,
        Action::Switch(switch) => session.program().is_on(switch),
        Action::AskRecords(shorthand) => session.records().has(shorthand),
        Action::WithSimulated => session.records().with_simulated(),
        Action::ShowParts(view) => session.parts().view() == view,
        Action::ShowAllColumns => session.parts().sheet().shows_all(),
        Action::WithdrawRecord => session.records().correcting().is_some_and(|form| form.withdraws),
        _ => return None,
    })
}
