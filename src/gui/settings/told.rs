//! What a row of the settings page says is in force.

use std::path::Path;

use crate::gui::check::grouped;
use crate::gui::view::View;
use crate::message::message;
use crate::session::{MaskChoice, OpenGauge, PortState, Told};
use crate::tolerance::Absent;

/// Which own tables are asked: those of a folder, or a table of the table page that is used until the window is closed.
fn own_tables(view: &View<'_>) -> String {
    let sources = view.session.sources();
    match view.session.tables_folder() {
        Some(folder) if matches!(sources.absent(), Some(Absent::Unread(_))) => {
            view.words.say(&message!("settings-page-own-tables-unread").text("folder", folder.display()))
        }
        Some(folder) => folder.display().to_string(),
        None if sources.own().is_empty() => view.text("settings-page-not-used"),
        None => sources.own().iter().map(|table| table.name()).collect::<Vec<_>>().join(", "),
    }
}

/// How the port of a gauge stands.
pub(in crate::gui) fn gauge_state(view: &View<'_>, gauge: &OpenGauge) -> String {
    match &gauge.state {
        PortState::Closed => view.text("gauges-closed"),
        PortState::Opening => view.text("gauges-opening"),
        PortState::Open => view.text("gauges-open"),
        PortState::Lost(why) => view.words.say(why),
    }
}

/// What is in force; `None` where there is nothing to say.
pub(super) fn told(view: &View<'_>, of: Told) -> Option<String> {
    let session = view.session;
    let recording = session.recording();
    let place = |path: Option<&Path>, none: &str| match path {
        Some(path) => path.display().to_string(),
        None => view.text(none),
    };
    Some(match of {
        Told::None => return None,
        Told::OwnTables => own_tables(view),
        Told::OwnMask => match session.mask() {
            MaskChoice::Own { path, .. } => path.display().to_string(),
            MaskChoice::OfLanguage | MaskChoice::Shipped(_) => view.text("settings-page-not-used"),
        },
        Told::OwnTexts => match session.own_texts() {
            Some(chosen) => {
                let told = chosen.told(session.language());
                told.iter().map(|message| view.words.say(message)).collect::<Vec<_>>().join("\n")
            }
            None => view.text("settings-page-not-used"),
        },
        Told::Budget => match session.used_budget() {
            Some(open) => {
                let said = message!("check-budget-used").text("name", &open.budget.name).text("file", &open.file);
                view.words.say(&said)
            }
            None => view.text("check-budget-none"),
        },
        Told::Journal if !recording.is_on() => view.text("records-page-not-recording"),
        Told::Journal => {
            let file = place(recording.file.as_deref(), "settings-page-nowhere");
            let said = message!("records-page-place").text("file", file).text("entries", grouped(recording.newest));
            view.words.say(&said)
        }
        Told::Station if recording.station.is_empty() => view.text("records-page-not-recording"),
        Told::Station => recording.station.clone(),
        Told::Server => {
            let Some(server) = recording.server() else { return Some(view.text("settings-page-not-used")) };
            let said = match (recording.trouble(), recording.unsent()) {
                (Some(why), _) => message!("records-page-not-sent").message("why", why.clone()),
                (None, None) => message!("records-page-server-unknown").text("server", server),
                (None, Some(0)) => message!("records-page-all-sent").text("server", server),
                (None, Some(unsent)) => {
                    message!("records-page-unsent").text("count", grouped(unsent)).text("server", server)
                }
            };
            view.words.say(&said)
        }
        Told::Watched => place(session.parts().watched.folder.as_deref(), "settings-page-not-used"),
        Told::GaugePort => gauge_state(view, session.settings_page().gauges.shown()?),
        Told::Taught => match &session.settings_page().gauges.shown()?.saved.taught {
            Some(taught) => {
                let said = message!("gauges-taught-by").text("line", taught.line());
                view.words.say(&said.number("value", taught.gave()))
            }
            None => view.text("gauges-not-taught"),
        },
        Told::RecentFiles => {
            view.words.say(&message!("settings-page-recent-count").count("count", session.recent_files().len()))
        }
        Told::Version => {
            let commit =
                option_env!("FITCHECK_COMMIT").map_or_else(|| view.text("settings-page-unknown"), str::to_owned);
            let said = message!("settings-page-version-is").text("version", env!("CARGO_PKG_VERSION"));
            view.words.say(&said.text("commit", commit))
        }
        Told::Licence => env!("CARGO_PKG_LICENSE").to_owned(),
        Told::StateFile => place(session.settings_page().state_file.as_deref(), "settings-page-nowhere"),
    })
}
