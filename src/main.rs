//! Reads arguments, opens the window or runs a subcommand, and maps errors to exit codes.

use std::path::PathBuf;
use std::process::ExitCode;

#[cfg(feature = "gui")]
use fitcheck::cli::Kept;
use fitcheck::cli::{Cli, OfWindow, Start, tell};
use fitcheck::files;
use fitcheck::session::{HEAD, Purpose};

fn main() -> ExitCode {
    outlive_the_largest_file();
    match Cli::start(Purpose::knows_ending) {
        Start::Subcommand(cli) => cli.run_here(OF_WINDOW),
        Start::Window(paths) => match paths.into_iter().map(purpose).collect::<Result<Vec<_>, _>>() {
            Ok(files) => open_window(&files),
            Err(exit) => exit,
        },
    }
}

/// Writing beyond the largest file that the system allows is then an error like any other, with a message and nothing
/// left behind. By default the signal for it ends the program.
fn outlive_the_largest_file() {
    #[cfg(unix)]
    {
        use signal_hook::consts::SIGXFSZ;
        let asked_by_nobody = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(false));
        // Without it the system ends the program, as it would have.
        drop(signal_hook::flag::register(SIGXFSZ, asked_by_nobody));
    }
}

/// What a file is opened for. A file that the window does not open is wrong usage, and ends the program.
fn purpose(path: PathBuf) -> Result<(Purpose, PathBuf), ExitCode> {
    let head = files::read_head(&path, HEAD).map_err(|error| tell(&error.to_string()))?;
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    match Purpose::of_file(&name, &head) {
        // The window has no folder of its own that a path could begin from.
        Ok(purpose) => Ok((purpose, std::path::absolute(&path).unwrap_or(path))),
        Err(error) => Cli::wrong_usage(&error),
    }
}

#[cfg(feature = "gui")]
fn open_window(files: &[(Purpose, PathBuf)]) -> ExitCode {
    env_logger::init();
    match fitcheck::gui::run(files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => tell(&error.to_string()),
    }
}

#[cfg(feature = "gui")]
const OF_WINDOW: Option<fn() -> OfWindow> = Some(of_window);

#[cfg(not(feature = "gui"))]
const OF_WINDOW: Option<fn() -> OfWindow> = None;

/// What the doctor asks of the window.
#[cfg(feature = "gui")]
fn of_window() -> OfWindow {
    use fitcheck::message::Say as _;
    let renderer = fitcheck::gui::renderer().map_err(|error| error.message());
    let kept = fitcheck::gui::Store::of_user().kept().map(|kept| Kept {
        journal: kept.records.file,
        server: kept.records.server,
        tables: kept.tables_folder,
        gauges: kept.gauges.into_iter().filter(|gauge| gauge.on).map(|gauge| (gauge.name, gauge.port.port)).collect(),
    });
    OfWindow { renderer, kept }
}

#[cfg(not(feature = "gui"))]
fn open_window(_files: &[(Purpose, PathBuf)]) -> ExitCode {
    tell("this program was built without the window: name a subcommand, see fitcheck --help")
}
