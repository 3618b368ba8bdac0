//! What is measured: a perfect workpiece, the simulated one of the cycles page, or recorded contacts.

use jiff::civil::DateTime;

use super::inputs::{Input, length};
use super::{ProgramField, ProgramPage, WorkpieceFrom};
use crate::length::Length;
use crate::message::Message;
use crate::nc::machine::Contacts;
use crate::probing::cycle::Plane;
use crate::probing::simulated::{Simulation, Surface, Workpiece};
use crate::session::{CycleField, CycleFile, CyclesCommand, Effect, Page, Purpose, Session};
use crate::tolerance::Feature;

impl ProgramPage {
    /// A hole's or a shaft's workpiece at the inputs' centre.
    fn round(feature: Feature, centre: [Length; 2], diameter: Length) -> Contacts {
        let workpiece = Workpiece::round(feature, centre.map(Length::to_mm_f64), diameter.to_mm_f64());
        let surface = Surface::Round(workpiece, Plane::Xy);
        Contacts::Workpiece(Simulation::perfect(surface))
    }

    fn field_length(&self, field: ProgramField) -> Result<Length, Message> {
        let text = self.text(field);
        // An empty centre is the one that the program expects.
        let expected = match field {
            ProgramField::WorkpieceX => Some(Input::CentreX),
            ProgramField::WorkpieceY => Some(Input::CentreY),
            _ => None,
        };
        match expected {
            Some(input) if text.trim().is_empty() => Ok(self.input_length(input).unwrap_or_default()),
            _ => length(text),
        }
    }

    /// Reads the fields of the workpiece anew; what is empty is no error until it is needed.
    pub(super) fn check_workpiece(&mut self) {
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

impl Session {
    pub(super) fn choose_workpiece(&mut self, from: WorkpieceFrom) {
        if from == WorkpieceFrom::Recorded && self.cycles.recorded().is_none() {
            return self.open_dialog(Purpose::OpenCycleFile(CycleFile::Contacts));
        }
        self.program.workpiece = from;
        self.program.check_workpiece();
        self.reset_program();
    }

    /// The simulated workpiece that suits is that of the program's inputs, as a shop makes it.
    fn suited_to_program(&self) -> Option<Simulation> {
        let limits = self.program_limits()?.ok()?;
        let centre = [Input::CentreX, Input::CentreY].map(|input| self.program.input_length(input).unwrap_or_default());
        let usual = Workpiece::usual(limits.feature, limits.middle().to_mm_f64());
        let surface = Surface::Round(Workpiece { centre: centre.map(Length::to_mm_f64), ..usual }, Plane::Xy);
        let machine = self.cycles.workpiece().simulation().copied().unwrap_or_else(|| Simulation::perfect(surface));
        Some(Simulation { surface, ..machine })
    }

    /// Does a command of the workpiece's dialog, which the cycles page has as well.
    pub(in crate::session) fn apply_cycles_for_page(&mut self, command: CyclesCommand, now: DateTime) -> Vec<Effect> {
        let command = match command {
            CyclesCommand::SuitWorkpiece if self.page == Page::Program => match self.suited_to_program() {
                Some(simulation) => CyclesCommand::WorkpieceRead(Ok(Box::new(simulation))),
                None => return Vec::new(),
            },
            command => command,
        };
        let now_used = match &command {
            CyclesCommand::Type(CycleField::Workpiece(_), _)
            | CyclesCommand::ChooseShape(_)
            | CyclesCommand::ChoosePlane(_)
            | CyclesCommand::WorkpieceRead(Ok(_)) => Some(WorkpieceFrom::Simulated),
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

    /// What the next run measures, or why that cannot be.
    pub(super) fn program_contacts(&mut self) -> Result<Contacts, Message> {
        let limits = self.program_limits().and_then(Result::ok);
        let page = &mut self.program;
        let centre = [Input::CentreX, Input::CentreY].map(|input| page.input_length(input).unwrap_or_default());
        match page.workpiece {
            WorkpieceFrom::Perfect => {
                Ok(limits
                    .map_or(Contacts::Perfect, |limits| ProgramPage::round(limits.feature, centre, limits.middle())))
            }
            WorkpieceFrom::Given => {
                let mut read = |field| {
                    let result = page.field_length(field);
                    if let Err(problem) = &result {
                        page.errors.insert(field, problem.clone());
                    }
                    result.map_err(|_told| Message::new("program-page-refused-workpiece"))
                };
                let diameter = read(ProgramField::Diameter)?;
                let centre = [read(ProgramField::WorkpieceX)?, read(ProgramField::WorkpieceY)?];
                let feature = limits.map_or(Feature::Hole, |limits| limits.feature);
                Ok(ProgramPage::round(feature, centre, diameter))
            }
            WorkpieceFrom::Simulated => match self.cycles.workpiece().simulation() {
                Some(simulation) => Ok(Contacts::Workpiece(*simulation)),
                None => Err(Message::new("program-page-refused-workpiece")),
            },
            WorkpieceFrom::Recorded => match self.cycles.recorded() {
                Some(recorded) => Ok(Contacts::Recorded(recorded.contacts.clone())),
                None => Err(Message::new("program-page-refused-no-contacts")),
            },
        }
    }
}
