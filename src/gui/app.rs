//! One frame: draw the panels, apply their commands, run the effects.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{CentralPanel, Context, Event, Frame, ThemePreference, Ui, ViewportCommand};
use jiff::civil::DateTime;

use super::effects::{EffectContext, Runner};
use super::errands::Errands;
use super::in_turn::InTurn;
use super::journal::Records;
use super::keeping::Keeper;
use super::notices::leave_in_time;
use super::over_page::come_home;
use super::pages::{dropped_ui, page_of};
use super::rail::rail_ui;
use super::store::Store;
use super::view::View;
use super::{crash, dialogs, field, field_help, keys, operator, palette, parts, spoken, theme, top_bar, zoom};
use crate::files;
use crate::message::{Message, Say as _};
use crate::session::{CheckField, Command, Effect, FilesCommand, Page, Purpose, RowHeight, Session, Theme};
use crate::store::programs::Folders;
use crate::words::{Language, Words};

/// The settings that the window starts with.
#[derive(Debug, Clone)]
pub struct Setup {
    /// Where the state is kept.
    pub store: Store,
    /// The language of the first start.
    pub language: Language,
    pub words: fn(Language) -> Words,
    /// How files are read and written.
    pub errands: Errands,
    /// The local date and time.
    pub clock: fn() -> DateTime,
    /// The folder in which dialogs begin until another one was used.
    pub home: Option<PathBuf>,
    /// Files that are opened at once, and what for.
    pub files: Vec<(Purpose, PathBuf)>,
    /// Where checks are recorded.
    pub records: Records,
    /// What is told at once.
    pub told: Vec<Message>,
    /// How long a notice stays that asks for nothing, seconds; `None` is until it is closed.
    pub notices_stay: Option<f64>,
}

impl Setup {
    /// The settings for a user.
    pub fn for_user() -> Self {
        let own = sys_locale::get_locale().and_then(|locale| Language::from_code(&locale));
        let store = Store::of_user();
        let crashes = store.folder().map(crash::tell).into_iter().flatten();
        Self {
            // Who speaks none of the languages of the window gets English.
            language: own.unwrap_or(Language::En),
            words: Words::new,
            errands: Errands::OnThread,
            clock: || files::now().datetime(),
            home: etcetera::home_dir().ok(),
            files: Vec::new(),
            records: Records::of_user(),
            told: files::zone().err().map(|error| error.message()).into_iter().chain(crashes).collect(),
            notices_stay: Some(6.0),
            store,
        }
    }
}

/// The window.
#[derive(Debug)]
pub struct App {
    session: Session,
    words: Words,
    words_of: fn(Language) -> Words,
    runner: Runner,
    keeper: Keeper,
    clock: fn() -> DateTime,
    notices_stay: Option<f64>,
    first_frame: bool,
    /// The user was asked and closes the window.
    leaves: bool,
    /// Since when the window waits for records before it closes, in seconds of the window.
    closes: Option<f64>,
}

impl App {
    /// The window in the state that the last one left.
    pub fn new(cc: &eframe::CreationContext<'_>, setup: Setup) -> Self {
        theme::install(&cc.egui_ctx);
        cc.egui_ctx.add_plugin(InTurn::default());
        let mut store = setup.store;
        let (saved, told) = store.load();
        let (mut session, effects) = match saved {
            Some(saved) => Session::restore(saved),
            None => (Session::new(setup.language), Vec::new()),
        };
        if let Some(told) = told {
            session.tell(told);
        }
        for told in setup.told {
            session.tell(told);
        }
        match store.materials() {
            Some(Ok(own)) => session.use_materials(own),
            Some(Err(told)) => session.tell(told),
            None => {}
        }
        if let Some(file) = &store.path {
            session.use_state_file(file.clone());
        }
        session.use_program_files(|program| Box::new(Folders::beside(program)));
        if let Some(home) = setup.home {
            session.use_home(home);
        }
        let mut app = Self {
            words: (setup.words)(session.language()).with_decimal_sign(session.decimal_sign()),
            words_of: setup.words,
            runner: Runner::new(setup.errands, setup.records, setup.clock),
            keeper: Keeper::new(store, session.saved()),
            session,
            clock: setup.clock,
            notices_stay: setup.notices_stay,
            first_frame: true,
            leaves: false,
            closes: None,
        };
        app.prefer_theme(&cc.egui_ctx);
        zoom::set(&cc.egui_ctx, app.session.zoom());
        for effect in effects {
            app.run(&cc.egui_ctx, effect);
        }
        let begin = app.runner.desk().begin();
        app.apply(&cc.egui_ctx, vec![begin]);
        let files = setup.files.into_iter().map(|(purpose, path)| FilesCommand::Open(purpose, path).into());
        app.apply(&cc.egui_ctx, files.collect());
        app
    }

    /// The state, for tests that look behind the window.
    pub const fn session(&self) -> &Session {
        &self.session
    }

    /// Does a command as if a button had sent it, for scripts.
    pub fn send(&mut self, ctx: &Context, command: Command) {
        self.apply(ctx, vec![command]);
    }

    fn prefer_theme(&self, ctx: &Context) {
        ctx.set_theme(match self.session.theme() {
            Theme::System => ThemePreference::System,
            Theme::Light | Theme::Contrast => ThemePreference::Light,
            Theme::Dark | Theme::Inverted => ThemePreference::Dark,
        });
        theme::set_contrast(ctx, matches!(self.session.theme(), Theme::Contrast | Theme::Inverted));
        theme::set_density(ctx, self.session.is_for_touch());
        theme::set_rows(ctx, self.session.rows() == RowHeight::Close);
    }

    fn run(&self, ctx: &Context, effect: Effect) {
        if let Effect::Focus(field) = effect {
            return field::go_to(ctx, &self.session, field);
        }
        if effect == Effect::FocusTable {
            return parts::focus_table(ctx);
        }
        let sources = self.session.sources();
        let columns = self.session.remembered_columns();
        let masks = self.session.own_masks();
        let words = &self.words;
        let now = (self.clock)();
        self.runner.run(
            ctx,
            effect,
            &EffectContext { sources, columns, masks, words, temperature: self.session.temperature(), now },
        );
    }

    /// Closes the window once every record is on disk; a user is asked where that fails or takes too long.
    fn close_when_written(&mut self, ctx: &Context) {
        const MOST: f64 = 10.0;
        let Some(since) = self.closes else { return };
        let is_late = since + MOST < ctx.input(|input| input.time);
        if self.session.would_lose() || is_late {
            self.closes = None;
            self.apply(ctx, vec![Command::AskToLeave]);
        } else if self.session.recording().unwritten() == 0 {
            self.closes = None;
            ctx.send_viewport_cmd(ViewportCommand::Close);
        } else {
            ctx.request_repaint_after(Duration::from_millis(50));
        }
    }

    fn apply(&mut self, ctx: &Context, commands: Vec<Command>) {
        if commands.is_empty() {
            return;
        }
        let zoom = self.session.zoom();
        for command in commands {
            for effect in self.session.apply(command, (self.clock)()) {
                self.leaves |= effect == Effect::Leave;
                self.run(ctx, effect);
            }
        }
        let sign = self.session.decimal_sign();
        let own = self.session.texts_of_window();
        let is_same_own = self.words.own().map(Arc::as_ptr) == own.map(Arc::as_ptr);
        if self.words.language() != self.session.language() || self.words.decimal_sign() != sign || !is_same_own {
            let words = (self.words_of)(self.session.language()).with_own(own.map(Arc::clone));
            self.words = words.with_decimal_sign(sign);
        }
        self.prefer_theme(ctx);
        if self.session.zoom() != zoom {
            zoom::set(ctx, self.session.zoom());
        }
        self.keeper.look(ctx, &self.session);
        // The change is drawn at once; after that nothing moves.
        ctx.request_repaint();
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &Context, _frame: &mut eframe::Frame) {
        let answers = self.runner.answers();
        self.apply(ctx, answers);
        self.keeper.frame(ctx, &mut self.session, &self.runner);
        // Nothing is lost without a question to the user.
        let closing = ctx.input(|input| input.viewport().close_requested());
        if closing && !self.leaves && self.session.would_lose() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.apply(ctx, vec![Command::AskToLeave]);
        } else if closing && !self.leaves && 0 < self.session.recording().unwritten() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.closes = Some(ctx.input(|input| input.time));
        }
        self.close_when_written(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let touched = touched(ui);
        let mut view = View { session: &self.session, words: &self.words, commands: Vec::new() };
        if let Some(is_touched) = touched.filter(|is_touched| *is_touched != self.session.is_touched()) {
            view.send(Command::Touched(is_touched));
        }
        if let Some(zoom) = zoom::by_keys(ui.ctx(), self.session.zoom()) {
            view.send(Command::SetZoom(zoom));
            // Where keys went too far, nothing changes in the state, and the window has to come back.
            zoom::set(ui.ctx(), zoom);
        }
        spoken::window(ui.ctx());
        let drawn = catch_unwind(AssertUnwindSafe(|| window_ui(ui, &mut view)));
        if let Err(panic) = drawn {
            // What was typed and chosen up to the last frame is not lost with the window.
            self.keeper.finish(&self.session, &self.runner);
            resume_unwind(panic);
        }
        if let Some(stays) = self.notices_stay {
            leave_in_time(ui, &mut view, stays);
        }
        let commands = view.commands;
        if self.first_frame {
            self.first_frame = false;
            // A file that was given has opened its own page.
            if self.session.page() == Page::Check {
                ui.memory_mut(|memory| memory.request_focus(field::id(CheckField::Callout)));
            }
        }
        let ctx = ui.ctx().clone();
        if commands.is_empty() {
            return;
        }
        self.apply(&ctx, commands);
        draw_again_at_once(&ctx);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.runner.desk().finish();
        self.keeper.finish(&self.session, &self.runner);
    }
}

/// Draws the window once more before it is shown, so that a verdict is on screen a whole frame earlier. Never in two frames in a row: egui
/// takes that for a mistake, and the next frame shows the change anyway.
fn draw_again_at_once(ctx: &Context) {
    // What goes on by itself, such as a program that runs, keeps its own time.
    let is_answer = ctx.input(|input| !input.events.is_empty());
    if is_answer && ctx.viewport(|viewport| viewport.num_multipass_in_row) == 0 {
        ctx.request_discard("the answer to what was pressed is known");
    }
}

/// Whether a finger was used in this frame, or else a mouse; `None` where neither was. A finger also moves the pointer.
fn touched(ui: &Ui) -> Option<bool> {
    ui.input(|input| {
        let is_finger = |event: &Event| matches!(event, Event::Touch { .. });
        let is_mouse = |event: &Event| matches!(event, Event::PointerMoved(_) | Event::MouseWheel { .. });
        let is_touch = input.any_touches() || input.events.iter().any(is_finger);
        (is_touch || input.events.iter().any(is_mouse)).then_some(is_touch)
    })
}

/// Below this height the cards come closer to the edges of the window.
const LOW: f32 = 700.0;

/// The rail, the top bar, the open page, and what lies over it.
fn window_ui(ui: &mut Ui, view: &mut View<'_>) {
    come_home(ui);
    field::arrive(ui.ctx(), view);
    keys::keys_ui(ui, view);
    if view.session.is_for_operators() {
        operator::operator_ui(ui, view);
        dialogs::dialogs_ui(ui, view, operator::FOOT);
        return;
    }
    rail_ui(ui, view);
    // What lies over the page leaves a rail below it free.
    let below = ui.ctx().content_rect().bottom() - ui.available_rect_before_wrap().bottom();
    top_bar::top_bar_ui(ui, view);
    let margin = if ui.ctx().content_rect().height() < LOW { 8 } else { 16 };
    let canvas = Frame::new().fill(theme::palette(ui.ctx()).canvas.0).inner_margin(margin);
    CentralPanel::default().frame(canvas).show(ui, |ui| (page_of(view.session.page()).ui)(ui, view));
    dropped_ui(ui, view);
    dialogs::dialogs_ui(ui, view, below);
    palette::palette_ui(ui, view);
    field_help::follow_ui(ui, view);
    operator::question_ui(ui, view);
}
