//! The outside world, never on the frame's thread: files are read and written on a thread of their own, one after
//! another as they were asked for; what may wait for a user or a network has a thread for itself.
//!
//! The answer comes back as a [`Command`] and asks for one frame. Tests run errands at once, on the frame's thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SendError, Sender, channel};

use eframe::egui::{Context, ViewportCommand};
use jiff::civil::DateTime;

use super::errands::Errands;
use super::file_contents::{FileContents, With};
use super::gauges::{Listener, PortOrder, Ports};
use super::journal::{Desk, Records};
use super::reading::{is_read, read};
use super::rows::Runs;
use super::sound::Sounds;
use super::watching::{Watch, Watching};
use super::working::{Job, Watched, Works};
use super::{measurements, picture, pin, printing, templates};
use crate::control::mask::Mask;
use crate::exchange::Remembered;
use crate::exchange::batch::{ListedRows, Part, Sifting};
use crate::files::{self, FileError};
use crate::message::message;
use crate::proof::Seen;
use crate::session::help::Sample;
use crate::session::parts::PlanCommand;
use crate::session::statistics::StudyCommand;
use crate::session::{
    Command, Content, Effect, FilesCommand, Launch, Paired, PairingCommand, PartsCommand, Purpose, ReadOutcome,
    RecordsCommand, RowsCommand, SettingsCommand, StatisticsCommand, Working, WorkpieceCommand,
};
use crate::tolerance::Sources;
use crate::tolerance::fit::thermal::Temperature;
use crate::words::Words;

/// What effects need besides themselves, as it is when they are sent.
#[derive(Clone, Copy)]
pub(super) struct EffectContext<'a> {
    pub sources: &'a Arc<Sources>,
    /// The columns of files as they were corrected.
    pub columns: &'a Arc<Remembered>,
    /// The user's own mask.
    pub masks: &'a Arc<Vec<(String, Mask)>>,
    pub words: &'a Words,
    /// From which temperature values are brought to 20 °C.
    pub temperature: Option<Temperature>,
    pub now: DateTime,
}

/// Something to do outside.
pub(super) type Errand = Box<dyn FnOnce() + Send>;

/// Runs effects and collects their answers.
#[derive(Debug)]
pub(super) struct Runner {
    errands: Errands,
    clock: fn() -> DateTime,
    sender: Sender<Command>,
    receiver: Receiver<Command>,
    /// To the thread that reads and writes files.
    files: Sender<Errand>,
    /// The run over a large file.
    rows: Arc<Runs>,
    /// The file that is being read or written.
    works: Arc<Works>,
    /// The folder that is watched.
    watching: Watching,
    /// The ports of gauges.
    ports: Ports,
    sounds: Sounds,
    /// Who keeps and reads records.
    desk: Desk,
}

impl Drop for Runner {
    /// A window that is closed waits for no run.
    fn drop(&mut self) {
        self.rows.stop();
        self.works.stop();
        self.watching.stop();
        self.ports.stop();
    }
}

impl Runner {
    pub fn new(errands: Errands, records: Records, clock: fn() -> DateTime) -> Self {
        let (sender, receiver) = channel();
        let (files, queue) = channel::<Errand>();
        if errands == Errands::OnThread {
            on_thread("files", Box::new(move || queue.into_iter().for_each(|errand| errand())));
        }
        let desk = Desk::new(errands, records, clock, sender.clone());
        let rows = Arc::default();
        let works = Arc::default();
        let watching = Watching::default();
        let (ports, sounds) = (Ports::default(), Sounds::default());
        Self { errands, clock, sender, receiver, files, rows, works, watching, ports, sounds, desk }
    }

    /// Who keeps and reads records.
    pub const fn desk(&self) -> &Desk {
        &self.desk
    }

    /// The commands that came back since the last frame.
    pub fn answers(&self) -> Vec<Command> {
        self.receiver.try_iter().collect()
    }

    /// Runs something after the files that were asked for before it.
    pub fn after_files(&self, errand: Errand) {
        match self.errands {
            Errands::AtOnce => errand(),
            // Without its thread it is done at once: a window that stands still is better than no answer.
            Errands::OnThread => self.files.send(errand).unwrap_or_else(|SendError(errand)| errand()),
        }
    }

    /// Runs an effect; the frame itself does the clipboard.
    pub fn run(&self, ctx: &Context, effect: Effect, beside: &EffectContext<'_>) {
        let EffectContext { sources, columns, masks, words, temperature, now } = *beside;
        let masks = Arc::clone(masks);
        let Some(effect) = self.desk.run(ctx, effect) else { return };
        let effect = match effect {
            Effect::Copy(text) => return ctx.copy_text(text),
            Effect::AskForClipboard => return ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
            Effect::Leave => return ctx.send_viewport_cmd(ViewportCommand::Close),
            Effect::StopRows => return self.rows.stop(),
            Effect::StopWorking => return self.works.stop(),
            Effect::JudgeRows { run, path } => return self.judge_rows(ctx, (run, path), Arc::clone(sources)),
            Effect::SiftRows { run, number, rows, sifting } => {
                return self.sift_rows(ctx, (run, number), rows, sifting);
            }
            Effect::ReadRows { run, wanted } => return self.read_rows(ctx, run, wanted),
            Effect::Watch { run, folder, plan } => {
                let known = self.desk.known();
                let journal = self.desk.file();
                let language = words.language();
                let clock = self.clock;
                let sources = Arc::clone(sources);
                let columns = Arc::clone(columns);
                let watch = Watch {
                    run,
                    folder,
                    plan,
                    sources,
                    columns,
                    masks,
                    language,
                    clock,
                    temperature,
                    known,
                    journal,
                    ctx: ctx.clone(),
                    answers: self.sender.clone(),
                };
                return self.watching.begin(watch);
            }
            Effect::WatchTaken { run, look } => return self.watching.taken(run, look),
            Effect::StopWatch => return self.watching.stop(),
            Effect::FindPorts => return self.order(ctx, PortOrder::Find),
            Effect::OpenGauge { run, settings } => return self.order(ctx, PortOrder::Open { run, settings }),
            Effect::CloseGauge(run) => return self.order(ctx, PortOrder::Close(run)),
            Effect::Sound(rhythm) => return self.sounds.play(self.errands, rhythm, self.listener(ctx)),
            effect => effect,
        };
        let sender = self.sender.clone();
        let ctx = ctx.clone();
        let sources = Arc::clone(sources);
        let columns = Arc::clone(columns);
        let errands = self.errands;
        let filters = Filters::of(effect.errand(), words);
        let may_wait = may_wait(effect.errand());
        let works = Arc::clone(&self.works);
        let errand: Errand = Box::new(move || {
            let begins = |path: &Path, is_writing: bool| {
                let sender = sender.clone();
                let ctx = ctx.clone();
                let say = move |far: Option<Working>| {
                    let _closed = sender.send(FilesCommand::Working(far.map(Box::new)).into());
                    ctx.request_repaint();
                };
                works.begin(path, is_writing, Box::new(say))
            };
            let with = With { sources: &sources, columns: &columns, masks: &masks, temperature, now, begins: &begins };
            for command in answers(effect, (errands, filters), with) {
                // A closed window hears no answer; that is not an error.
                let _closed = sender.send(command);
            }
            ctx.request_repaint();
        });
        if may_wait && errands == Errands::OnThread {
            on_thread("errand", errand);
        } else {
            self.after_files(errand);
        }
    }

    /// Does something with ports.
    fn order(&self, ctx: &Context, order: PortOrder) {
        self.ports.give(self.errands, order, self.listener(ctx));
    }

    fn listener(&self, ctx: &Context) -> Listener {
        Listener { ctx: ctx.clone(), answers: self.sender.clone() }
    }

    /// Judges the rows of a large file on a thread; each of its answers asks for one frame.
    fn judge_rows(&self, ctx: &Context, (run, path): (u64, PathBuf), sources: Arc<Sources>) {
        let rows = Arc::clone(&self.rows);
        let watch = self.rows.begin(run);
        let sender = self.sender.clone();
        let ctx = ctx.clone();
        let errand: Errand = Box::new(move || {
            rows.judge((run, &path), &watch, &sources, &mut |news| {
                // A closed window hears no answer; that is not an error.
                let _closed = sender.send(RowsCommand::Judged { run, news: Box::new(news) }.into());
                ctx.request_repaint();
            });
        });
        match self.errands {
            Errands::AtOnce => errand(),
            Errands::OnThread => on_thread("rows", errand),
        }
    }

    /// Finds rows of a large file, or puts them in order.
    fn sift_rows(&self, ctx: &Context, (run, number): (u64, u64), rows: Box<ListedRows>, sifting: Sifting) {
        let stop = self.rows.asks();
        let sender = self.sender.clone();
        let ctx = ctx.clone();
        let errand: Errand = Box::new(move || {
            if let Some(result) = super::rows::sift(&rows, &sifting, &stop) {
                let _closed = sender.send(RowsCommand::Sifted { run, number, result }.into());
                ctx.request_repaint();
            }
        });
        match self.errands {
            Errands::AtOnce => errand(),
            Errands::OnThread => on_thread("rows", errand),
        }
    }

    /// Reads rows of a large file again.
    fn read_rows(&self, ctx: &Context, run: u64, wanted: Vec<(Arc<Part>, Vec<usize>)>) {
        let rows = Arc::clone(&self.rows);
        let sender = self.sender.clone();
        let ctx = ctx.clone();
        self.after_files(Box::new(move || {
            let result = rows.read(run, &wanted);
            let _closed = sender.send(RowsCommand::Read { run, result }.into());
            ctx.request_repaint();
        }));
    }
}

/// Whether an errand may wait for a user, a network or a large file: then it has a thread for itself.
fn may_wait(effect: &Effect) -> bool {
    match effect {
        // A large picture takes a while, and so does the hash of a PIN.
        Effect::Browse { .. }
        | Effect::List(_)
        | Effect::Launch(..)
        | Effect::Pair { .. }
        | Effect::EvaluateSeries { .. }
        | Effect::EvaluateStudy { .. }
        | Effect::ReadPicture(_)
        | Effect::DrawReport { .. }
        | Effect::Print(_)
        | Effect::HashPin(_)
        | Effect::TryPin { .. } => true,
        // What is judged waits for it, and nothing else has to.
        Effect::Read(purpose, _) => purpose.is_folder(),
        _ => false,
    }
}

fn on_thread(name: &str, errand: Errand) {
    if let Err(error) = std::thread::Builder::new().name(name.to_owned()).spawn(errand) {
        log::error!("no thread for {name}: {error}");
    }
}

/// What the system's dialog calls the files that it lists, in the language of the window.
#[derive(Debug, Clone)]
struct Filters {
    kind: String,
    all: String,
}

impl Filters {
    fn of(effect: &Effect, words: &Words) -> Option<Self> {
        let Effect::Browse { purpose, .. } = effect else { return None };
        Some(Self { kind: purpose.filter_name(words), all: words.get("dialog-all-files") })
    }
}

fn answers(effect: Effect, (errands, filters): (Errands, Option<Filters>), with: With<'_>) -> Vec<Command> {
    match effect {
        Effect::ForDialog(dialog, errand) => {
            let answers = answers(*errand, (errands, filters), with).into_iter();
            answers.map(|answer| Command::Answered(dialog, Box::new(answer))).collect()
        }
        Effect::Browse { purpose, folder, name } => {
            let filters = filters.filter(|_| errands == Errands::OnThread);
            let picked = filters.and_then(|filters| pick(purpose, folder.as_deref(), &name, &filters));
            vec![Command::Picked(picked)]
        }
        Effect::List(folder) => {
            let result = files::list(&folder).map(Box::new);
            vec![FilesCommand::Listed { folder, result }.into()]
        }
        Effect::Read(purpose, path) if !purpose.is_folder() && path.is_dir() => {
            vec![FilesCommand::IsFolder(path).into()]
        }
        Effect::Read(purpose, path) => {
            let read = read(purpose, path.clone(), with);
            seen(purpose, path, read)
        }
        Effect::ReadColumns { into, path, mapping } => {
            let read = measurements::read(into, path.clone(), Some(&mapping), with);
            seen(into.purpose(), path, read)
        }
        Effect::Save(path, content) => save(&(with.begins)(&path, true), path, &content, false),
        Effect::Replace(path, content) => save(&(with.begins)(&path, true), path, &content, true),
        Effect::SaveSet { folder, set, replaces } => {
            let files = set.files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice()));
            let result = files::write_folder(&folder, &files.collect::<Vec<_>>(), replaces);
            vec![FilesCommand::SetWritten { folder, result }.into()]
        }
        Effect::Launch(path, how) => vec![launched(&path, how, errands)],
        effect @ (Effect::Pair { .. } | Effect::EvaluateSeries { .. } | Effect::EvaluateStudy { .. }) => {
            computed(effect).into_iter().collect()
        }
        Effect::ReadPicture(path) => vec![picture_read(path)],
        Effect::ReadLogo(path) => vec![SettingsCommand::LogoRead { result: templates::logo(&path), path }.into()],
        effect @ (Effect::DrawReport { .. }
        | Effect::ReadTemplates(_)
        | Effect::NewTemplate { .. }
        | Effect::Print(_)) => printing::answer(effect, errands).into_iter().map(Into::into).collect(),
        Effect::HashPin(pin) => vec![SettingsCommand::PinHashed(pin::hash(&pin)).into()],
        Effect::TryPin { pin, hash } => vec![SettingsCommand::PinTried(pin::is_it(&pin, &hash)).into()],
        Effect::Copy(_)
        | Effect::AskForClipboard
        | Effect::Focus(_)
        | Effect::FocusTable
        | Effect::Leave
        | Effect::JudgeRows { .. }
        | Effect::StopRows
        | Effect::StopWorking
        | Effect::ReadRows { .. }
        | Effect::SiftRows { .. }
        | Effect::OpenJournal { .. }
        | Effect::SendTo(_)
        | Effect::WakeSender
        | Effect::SendAgain
        | Effect::Keep { .. }
        | Effect::AskRecords { .. }
        | Effect::ReadPart { .. }
        | Effect::ReadSeries { .. }
        | Effect::FindAlarms(_)
        | Effect::FindRecords { .. }
        | Effect::Watch { .. }
        | Effect::WatchTaken { .. }
        | Effect::StopWatch
        | Effect::FindPorts
        | Effect::OpenGauge { .. }
        | Effect::CloseGauge(_)
        | Effect::Sound(_)
        | Effect::ReadRecords(_)
        | Effect::ReadReports(_)
        | Effect::VerifyRecords { .. }
        | Effect::StopVerify => Vec::new(),
    }
}

/// What only takes a while to compute.
fn computed(effect: Effect) -> Option<Command> {
    Some(match effect {
        Effect::Pair { run, asked } => PairingCommand::Paired { run, paired: Arc::new(Paired::of(*asked)) }.into(),
        Effect::EvaluateSeries { run, features, looks } => {
            let answers = features.iter().zip(&looks).map(|(feature, look)| feature.evaluate(look));
            StatisticsCommand::Evaluated { run, answers: Arc::new(answers.collect()) }.into()
        }
        Effect::EvaluateStudy { run, asked } => {
            StatisticsCommand::Study(StudyCommand::Evaluated { run, result: asked.evaluate() }).into()
        }
        _ => return None,
    })
}

fn picture_read(path: PathBuf) -> Command {
    let result = picture::read(&path).map(Arc::new);
    PartsCommand::Plan(PlanCommand::PictureRead { path, result }).into()
}

/// A file was given to the system's own program, or why not. Tests start none.
fn launched(path: &Path, how: Launch, errands: Errands) -> Command {
    let result = match errands {
        Errands::OnThread => launch(path, how),
        Errands::AtOnce => Err("no program is started at once".to_owned()),
    };
    let failed = |reason: String| message!("launch-failed").text("reason", reason);
    FilesCommand::Launched(result.map_err(failed)).into()
}

/// What a file holds, after what is to be known before it is used.
fn seen(purpose: Purpose, path: PathBuf, read: FileContents) -> Vec<Command> {
    let FileContents { before, command, sha256 } = read;
    let fate = match &command {
        _ if matches!(path.try_exists(), Ok(false)) => ReadOutcome::Gone,
        command if is_read(command) => ReadOutcome::Read,
        _ => ReadOutcome::Refused,
    };
    // A file is remembered as what it is.
    let purpose = match (purpose, &command) {
        (_, Command::Workpiece(WorkpieceCommand::PartRead { .. })) => Purpose::OpenPart,
        (Purpose::AskColumns(into), _) => into.purpose(),
        (purpose, _) => purpose,
    };
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let measured = sha256.map(|sha256| RecordsCommand::Measured { name, sha256 }.into());
    // A sample is no file of the user's.
    let is_file = Sample::bytes_at(&path).is_none();
    let seen = is_file.then(|| FilesCommand::Seen { purpose, path, fate }.into());
    seen.into_iter().chain(measured).chain(before).chain([command]).collect()
}

fn save(job: &Job, path: PathBuf, content: &Content, replace: bool) -> Vec<Command> {
    let mut file = None;
    let result = files::save_with(&path, replace, &mut |out| {
        let mut out = Watched::new(out, job);
        if !content.is_of_journal() {
            return content.write(&mut out);
        }
        let mut seen = Seen::new(out);
        content.write(&mut seen)?;
        file = Some(seen.finish());
        Ok(())
    });
    let result =
        result.map_err(|error| if job.is_stopped() { FileError::Stopped { path: path.clone() } } else { error });
    // The journal is told of a file that is whole, and of no other.
    let reported = file.filter(|_| result.is_ok()).and_then(|file| content.reported(&path, file));
    let reported = reported.map(|report| RecordsCommand::Reported(Box::new(report)).into());
    reported.into_iter().chain([Command::Saved { path, result }]).collect()
}

/// Starts the system's program for a file, or the one that shows folders.
fn launch(path: &Path, how: Launch) -> Result<(), String> {
    match how {
        Launch::Open => open(path),
        Launch::ShowInFolder => opener::reveal(path).map_err(|error| error.to_string()),
    }
}

/// Opens a file, and waits for the answer of the system's opener: the crate does not, and would never learn that there
/// is no program for the file.
#[cfg(all(unix, not(target_os = "macos")))]
fn open(path: &Path) -> Result<(), String> {
    use std::process::{Command as Process, Stdio};
    const OPENER: &str = "xdg-open";
    let mut process = Process::new(OPENER);
    process.arg(path).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match process.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{OPENER}: {status}")),
        Err(error) => Err(format!("{OPENER}: {error}")),
    }
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn open(path: &Path) -> Result<(), String> {
    opener::open(path).map_err(|error| error.to_string())
}

/// The system's own dialog. `None` when it was cancelled, and also when none can be shown: rfd 0.17 tells neither from
/// the other. On Linux it asks the desktop portal, then `zenity`; where both are missing it only writes to the log. So
/// the dialog of the window says that nothing came, and its own list is there in either case.
fn pick(purpose: Purpose, folder: Option<&Path>, name: &str, filters: &Filters) -> Option<PathBuf> {
    // Patterns are literal: both cases are listed.
    let endings: Vec<String> =
        purpose.endings().iter().flat_map(|ending| [ending.to_lowercase(), ending.to_uppercase()]).collect();
    let mut dialog = rfd::FileDialog::new();
    if let Some(folder) = folder {
        dialog = dialog.set_directory(folder);
    }
    if purpose.is_folder() {
        return dialog.pick_folder();
    }
    let dialog = dialog.add_filter(&filters.kind, &endings);
    if purpose.is_reading() {
        dialog.add_filter(&filters.all, &["*"]).pick_file()
    } else {
        dialog.set_file_name(name).save_file()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_written_and_read_in_the_order_in_which_they_were_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = |number: usize| folder.path().join(format!("{number}.txt"));
        let clock = || jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
        let runner = Runner::new(Errands::OnThread, Records::nowhere(), clock);
        let ctx = Context::default();
        let words = Words::new(crate::words::Language::En);
        // The first is the longest, so that any other would overtake it.
        for number in 0..20 {
            let bytes = vec![b'x'; if number == 0 { 4 << 20 } else { 1 }];
            let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
            let sources = Arc::default();
            let columns = Arc::default();
            let masks = Arc::default();
            let temperature = None;
            let beside =
                EffectContext { sources: &sources, columns: &columns, masks: &masks, words: &words, temperature, now };
            runner.run(&ctx, Effect::Save(path(number), bytes.into()), &beside);
        }
        let answers: Vec<Command> = runner.receiver.iter().take(20).collect();
        for (number, answer) in answers.iter().enumerate() {
            let Command::Saved { path: written, result: Ok(()) } = answer else { panic!("{answer:?}") };
            assert_eq!(*written, path(number));
        }
    }
}
