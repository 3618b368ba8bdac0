//! `fitcheck doctor`: whether what the program needs around it is there, and what to do where it is not.

use std::path::{Path, PathBuf};

use super::args::one_of;
use super::journal::server;
use super::journal_place::{JournalArgs, JournalPlace, own};
use super::of_window::{Kept, OfWindow};
use super::people::Aligned;
use super::people::Side::Left;
use super::{CliError, Format, Io, Outcome, version};
use crate::files;
use crate::message::{Message, Say, printed};
use crate::store::local::Reader;
use crate::store::tables::read_tables;
use crate::store::{StoreError, here};

const HELP: &str = "\
Each line says whether something is well, wrong or none: not there, and not needed until it is used.
What a window keeps in its settings is looked at, too: its server, its tables and its gauges.
Nothing is changed. To see whether every entry of the journal is as it was written: fitcheck journal
verify.

Examples:
  fitcheck doctor
  fitcheck doctor --journal postgres://mill3@shop.example/checks
  fitcheck doctor --format json > doctor.json

The exit code is 1 if anything is wrong.";

/// Look at display, folders, journal, server, gauges, tables, clock and time zone
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Args {
    /// Format of the answer
    #[arg(long, value_name = "FORMAT", default_value = "text", value_parser = one_of([Format::Text, Format::Json], |format| format.word()))]
    format: Format,
    /// Folder with your own tables of deviations
    #[arg(long, value_name = "FOLDER")]
    tables: Option<PathBuf>,
    #[command(flatten)]
    journal: JournalArgs,
}

/// How something is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Condition {
    Well,
    /// Not there, and not needed until it is used.
    None,
    Wrong,
}

impl Condition {
    const fn word(self) -> &'static str {
        match self {
            Self::Well => "well",
            Self::None => "none",
            Self::Wrong => "wrong",
        }
    }
}

object! {
    struct Answer of(looked: &Looked) {
        what: &'static str = looked.what,
        condition: &'static str = looked.condition.word(),
        found: String = looked.found.to_string(),
    }
}

/// One thing that was looked at.
struct Looked {
    what: &'static str,
    condition: Condition,
    found: Message,
}

/// What was found where nothing is wrong; what is wrong is said in the words of the room that refuses it.
#[derive(Debug, Say)]
#[say(prefix = "doctor")]
enum Found {
    Program {
        version: String,
    },
    Zone {
        zone: String,
        #[say(with = printed)]
        time: String,
    },
    Clock,
    /// The newest entry of the journal was written later than now.
    ClockBehind {
        #[say(with = printed)]
        newest: String,
        path: PathBuf,
    },
    Folder {
        path: PathBuf,
    },
    Journal {
        path: PathBuf,
        #[say(with = printed)]
        entries: u64,
    },
    /// The first check that is recorded makes it.
    NoJournal {
        path: PathBuf,
    },
    Server {
        address: String,
    },
    NoServer,
    /// This program was built without the ports of gauges.
    #[cfg(not(feature = "gauges"))]
    NoGauges,
    Tables {
        path: PathBuf,
        count: usize,
    },
    NoTables,
    Settings,
    Window {
        renderer: String,
    },
    /// This program was built without the window.
    NoWindow,
}

/// The same of the ports of gauges.
#[cfg(feature = "gauges")]
#[derive(Debug, Say)]
#[say(prefix = "doctor")]
enum FoundPorts {
    Gauges {
        ports: String,
    },
    NoPort,
    /// A gauge of the window whose port is not there.
    GaugeGone {
        gauge: String,
        port: String,
    },
    PortsNotListed {
        reason: String,
    },
}

/// What is looked at, one after the other.
#[derive(Default)]
struct Doctor(Vec<Looked>);

impl Doctor {
    fn well(&mut self, what: &'static str, found: &impl Say) {
        self.0.push(Looked { what, condition: Condition::Well, found: found.message() });
    }

    fn none(&mut self, what: &'static str, found: &impl Say) {
        self.0.push(Looked { what, condition: Condition::None, found: found.message() });
    }

    fn wrong(&mut self, what: &'static str, found: &impl Say) {
        self.0.push(Looked { what, condition: Condition::Wrong, found: found.message() });
    }

    fn zone(&mut self) {
        if let Err(error) = files::zone() {
            return self.wrong("time zone", &error);
        }
        let now = files::now();
        let time = now.strftime("%Y-%m-%d %H:%M").to_string();
        self.well("time zone", &Found::Zone { zone: files::zone_name(&now), time });
    }

    fn folder(&mut self, what: &'static str, folder: Option<PathBuf>) {
        match folder {
            None => self.wrong(what, &CliError::NoJournalFolder),
            Some(path) => match files::takes_files(&path) {
                Ok(()) => self.well(what, &Found::Folder { path }),
                Err(error) => self.wrong(what, &error),
            },
        }
    }

    /// The journal, and the clock against its newest entry.
    fn journal(&mut self, path: PathBuf) {
        let newest = || -> Result<_, StoreError> {
            let reader = Reader::open(&path)?;
            let number = reader.head()?.number;
            Ok((number, reader.rows(&[number])?.pop()))
        };
        match newest() {
            Err(StoreError::Missing { .. }) => self.none("journal", &Found::NoJournal { path }),
            Err(error) => self.wrong("journal", &error),
            Ok((entries, newest)) => {
                let written = newest.and_then(|newest| Some(newest.entry.ok()?.about.time));
                match written.filter(|written| here::moment().utc_ms < written.utc_ms) {
                    None => self.well("clock", &Found::Clock),
                    Some(later) => {
                        self.wrong("clock", &Found::ClockBehind { newest: later.text(), path: path.clone() });
                    }
                }
                self.well("journal", &Found::Journal { path, entries });
            }
        }
    }

    fn server(&mut self, address: Option<&str>, io: &mut Io<'_>) {
        match address.map(|address| (address, server::answers(address, io))) {
            None => self.none("server", &Found::NoServer),
            Some((_, Ok(address))) => self.well("server", &Found::Server { address }),
            Some((_, Err(error))) => self.wrong("server", &error),
        }
    }

    #[cfg(feature = "gauges")]
    fn gauges(&mut self, gauges: &[(String, String)]) {
        let ports = match crate::gauges::port::list() {
            Ok(ports) => ports,
            Err(error) => return self.wrong("gauges", &FoundPorts::PortsNotListed { reason: error.to_string() }),
        };
        for (gauge, port) in gauges.iter().filter(|(_, port)| !ports.contains(port)) {
            self.wrong("gauges", &FoundPorts::GaugeGone { gauge: gauge.clone(), port: port.clone() });
        }
        if ports.is_empty() {
            self.none("gauges", &FoundPorts::NoPort);
        } else {
            self.well("gauges", &FoundPorts::Gauges { ports: ports.join(", ") });
        }
    }

    #[cfg(not(feature = "gauges"))]
    fn gauges(&mut self, _gauges: &[(String, String)]) {
        self.none("gauges", &Found::NoGauges);
    }

    fn tables(&mut self, folder: Option<&Path>) {
        match folder.map(|folder| (folder, read_tables(folder))) {
            None => self.none("tables", &Found::NoTables),
            Some((_, Err(error))) => self.wrong("tables", &error),
            Some((folder, Ok(read))) => {
                for warning in &read.warnings {
                    self.wrong("tables", warning);
                }
                self.well("tables", &Found::Tables { path: folder.to_owned(), count: read.tables.len() });
            }
        }
    }

    /// The window, and what it keeps.
    fn window(&mut self, of_window: Option<OfWindow>) -> Kept {
        let Some(OfWindow { renderer, kept }) = of_window else {
            self.none("window", &Found::NoWindow);
            return Kept::default();
        };
        match renderer {
            Ok(renderer) => self.well("window", &Found::Window { renderer }),
            Err(error) => self.wrong("window", &CliError::Said(error)),
        }
        match kept {
            Ok(kept) => {
                self.well("window", &Found::Settings);
                kept
            }
            Err(error) => {
                self.wrong("window", &CliError::Said(error));
                Kept::default()
            }
        }
    }
}

impl Args {
    #[expect(clippy::unnecessary_wraps, reason = "as every subcommand; what is wrong here is an answer")]
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let mut doctor = Doctor::default();
        doctor.well("program", &Found::Program { version: version() });
        doctor.zone();
        let kept = doctor.window(io.of_window());
        doctor.folder("settings", files::settings_folder());
        doctor.folder("records", files::journal_folder());
        let (file, address) = match self.journal.place() {
            Ok(JournalPlace::Server(address)) => (kept.journal.map_or_else(own, Ok), Some(address)),
            Ok(JournalPlace::File(file)) if self.journal.is_given() => (Ok(file), kept.server),
            Ok(JournalPlace::File(file)) => (Ok(kept.journal.unwrap_or(file)), kept.server),
            Err(error) => (Err(error), kept.server),
        };
        match file {
            Ok(file) => doctor.journal(file),
            Err(error) => doctor.wrong("journal", &error),
        }
        doctor.server(address.as_deref(), io);
        doctor.gauges(&kept.gauges);
        doctor.tables(self.tables.as_deref().or(kept.tables.as_deref()));
        let looked = doctor.0;
        if self.format == Format::Json {
            io.json(&looked.iter().map(Answer::of).collect::<Vec<_>>());
        } else {
            let columns = [("what", Left), ("is", Left), ("found", Left)];
            let cells = |one: &Looked| [one.what.to_owned(), one.condition.word().to_owned(), one.found.to_string()];
            let rows: Vec<_> = looked.iter().map(cells).collect();
            for line in (Aligned { columns, widest: 12 }).lines(&rows) {
                writeln!(io.people(), "{line}");
            }
        }
        let is_well = looked.iter().all(|one| one.condition != Condition::Wrong);
        Ok(if is_well { Outcome::Done } else { Outcome::BadData })
    }
}
