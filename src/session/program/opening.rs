//! Programs and workpieces from files, and what is typed into the page's fields.

use std::path::PathBuf;

use jiff::civil::DateTime;

use super::inputs::{Input, length};
use super::{Document, Origin, ProgramField, ProgramPage, WorkpieceFrom};
use crate::control::machine::Shipped;
use crate::control::program::ProgramWarning;
use crate::length::Length;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Bench, Surface, Workpiece};
use crate::session::{CycleField, CycleFile, CyclesCommand, Effect, Page, Purpose, Session};
use crate::words::{Language, Message, Say as _};

/// How many files are remembered.
const MOST_RECENT: usize = 8;

/// The main programs that are shipped, one a language.
pub const SHIPPED: [(Language, &str); 4] = [
    (Language::En, "8255_en.h"),
    (Language::Nl, "8255_nl.h"),
    (Language::De, "8255_de.h"),
    (Language::It, "8255_it.h"),
];

impl Session {
    /// The page is opened: the first time with the shipped program of the window's language.
    pub(in crate::session) fn open_program_page(&mut self) {
        if self.program.origin.is_some() {
            return;
        }
        let shipped = SHIPPED.iter().find(|(language, _)| *language == self.language);
        if let Some((_, name)) = shipped.or_else(|| SHIPPED.first()) {
            self.open_shipped(name);
        }
    }

    pub(super) fn open_shipped(&mut self, name: &'static str) {
        let Some(bytes) = Shipped::file(name) else {
            return self.tell(Message::new("program-page-not-shipped").text("name", name));
        };
        match Document::read(name, bytes) {
            Ok((document, warnings)) => self.open_program(Origin::Shipped(name), document, warnings),
            Err(error) => self.tell(error.message()),
        }
    }

    pub(super) fn program_read(
        &mut self,
        path: PathBuf,
        result: Result<(Box<Document>, Vec<ProgramWarning>), Message>,
    ) {
        match result {
            Ok((document, warnings)) => {
                self.file_done();
                let recent = &mut self.program.recent;
                recent.retain(|known| *known != path);
                recent.insert(0, path.clone());
                recent.truncate(MOST_RECENT);
                self.open_program(Origin::File(path), *document, warnings);
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    fn open_program(&mut self, origin: Origin, document: Document, warnings: Vec<ProgramWarning>) {
        let path = document.path().clone();
        let page = &mut self.program;
        let sign = self.language.decimal_sign().to_string();
        page.texts.retain(|field, _| !matches!(field, ProgramField::Input(_)));
        for (input, text) in document.assigned() {
            let text = if input.unit().is_empty() { text.clone() } else { text.replace('.', &sign) };
            page.texts.insert(ProgramField::Input(*input), text);
        }
        page.breakpoints.clear();
        page.given.clear();
        page.documents.clear();
        page.documents.insert(path.clone(), document);
        (page.main, page.shown, page.origin) = (Some(path.clone()), Some(path), Some(origin));
        page.warnings = warnings;
        (page.looks, page.look) = (page.looks.wrapping_add(1), 0);
        page.check_inputs();
        self.reset_program();
    }

    pub(super) fn choose_workpiece(&mut self, from: WorkpieceFrom) {
        if from == WorkpieceFrom::Recorded && self.cycles.recorded().is_none() {
            return self.open_dialog(Purpose::OpenCycleFile(CycleFile::Contacts));
        }
        self.program.workpiece = from;
        self.program.check_workpiece();
        self.reset_program();
    }

    /// The simulated workpiece that suits is that of the program's inputs, as a shop makes it.
    fn suited_to_program(&self) -> Option<Bench> {
        let limits = self.program_limits()?.ok()?;
        let centre = [Input::CentreX, Input::CentreY].map(|input| self.program.input_length(input).unwrap_or_default());
        let usual = Workpiece::usual(limits.feature, limits.middle().to_mm_f64());
        let surface = Surface::Round(Workpiece { centre: centre.map(Length::to_mm_f64), ..usual }, Plane::Xy);
        let machine = self.cycles.bench().bench().copied().unwrap_or_else(|| Bench::perfect(surface));
        Some(Bench { surface, ..machine })
    }

    /// Does a command of the workpiece's dialog, which the cycles page has as well.
    pub(in crate::session) fn apply_cycles_for_page(&mut self, command: CyclesCommand, now: DateTime) -> Vec<Effect> {
        let command = match command {
            CyclesCommand::SuitBench if self.page == Page::Program => match self.suited_to_program() {
                Some(bench) => CyclesCommand::BenchRead(Ok(Box::new(bench))),
                None => return Vec::new(),
            },
            command => command,
        };
        let now_used = match &command {
            CyclesCommand::Type(CycleField::Bench(_), _)
            | CyclesCommand::ChooseKind(_)
            | CyclesCommand::ChoosePlane(_)
            | CyclesCommand::BenchRead(Ok(_)) => Some(WorkpieceFrom::Simulated),
            CyclesCommand::ContactsRead { result: Ok(_), .. } => Some(WorkpieceFrom::Recorded),
            _ => None,
        };
        let effects = self.apply_cycles(command, now);
        if let Some(from) = now_used {
            self.workpiece_changed(from);
        }
        effects
    }

    /// The workpiece that both pages share was changed: a run on it is cleared. One that was read here is used here.
    fn workpiece_changed(&mut self, from: WorkpieceFrom) {
        if self.page == Page::Program {
            self.program.workpiece = from;
        }
        if matches!(self.program.workpiece, WorkpieceFrom::Simulated | WorkpieceFrom::Recorded) {
            self.reset_program();
        }
    }

    pub(super) fn type_program_field(&mut self, field: ProgramField, text: String) {
        let page = &mut self.program;
        page.texts.insert(field, text);
        match field {
            ProgramField::Input(_) => {
                page.check_inputs();
                self.reset_program();
            }
            ProgramField::Diameter | ProgramField::WorkpieceX | ProgramField::WorkpieceY => {
                page.workpiece = WorkpieceFrom::Given;
                page.check_workpiece();
                self.reset_program();
            }
            ProgramField::Filter => {}
            ProgramField::Name | ProgramField::Value => _ = page.errors.remove(&field),
        }
    }
}

impl ProgramPage {
    /// Reads the fields of the workpiece anew; what is empty is no error until it is needed.
    fn check_workpiece(&mut self) {
        for field in [ProgramField::Diameter, ProgramField::WorkpieceX, ProgramField::WorkpieceY] {
            self.errors.remove(&field);
            let text = self.text(field);
            if !text.trim().is_empty()
                && let Err(problem) = length(text)
            {
                self.errors.insert(field, problem);
            }
        }
    }
}
