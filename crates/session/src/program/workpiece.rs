//! What is measured: a perfect workpiece, the simulated one of the cycles page, a part of several features, or recorded
//! contacts.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_core::probing::cycle::Plane;
use fitcheck_core::probing::simulated::{Simulation, Surface, Workpiece};
use fitcheck_core::tolerance::{Feature, Limits};
use fitcheck_nc::machine::Contacts;

use super::inputs::length;
use super::{Input, ProgramField, ProgramPage, WorkpieceFrom};
use crate::page::Page;
use crate::purpose::{CycleFile, Purpose};
use crate::shared::Shared;
use crate::state::PageState as _;

impl ProgramPage {
    /// The workpiece of a hole or a shaft at the inputs' centre.
    fn round(feature: Feature, centre: [Length; 2], diameter: Length) -> Contacts {
        let workpiece = Workpiece::round(feature, centre.map(Length::to_mm_f64), diameter.to_mm_f64());
        let surface = Surface::Round(workpiece, Plane::Xy);
        Contacts::Workpiece(Simulation::perfect(surface).into())
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
            Some(input) if text.trim().is_empty() => Ok(self.expected(input)),
            _ => length(text),
        }
    }

    /// Reads the fields of the workpiece anew; an empty field is not an error until it is needed.
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

impl ProgramPage {
    pub(super) fn choose_workpiece(&mut self, from: WorkpieceFrom, shared: &mut Shared) {
        if from == WorkpieceFrom::Recorded && self.recorded.is_none() {
            return shared.open_cycle_file(CycleFile::Contacts);
        }
        if from == WorkpieceFrom::Part && shared.workpiece.part.is_none() {
            return shared.open_dialog(Purpose::OpenPart, String::new());
        }
        self.workpiece = from;
        self.check_workpiece();
        self.reset();
    }

    fn centre(&self) -> [Length; 2] {
        [Input::CentreX, Input::CentreY].map(|input| self.expected(input))
    }

    /// Where the program expects a coordinate of the centre; at the datum where it does not say.
    fn expected(&self, input: Input) -> Length {
        self.input_length(input).unwrap_or(Length::ZERO)
    }

    /// A simulated workpiece that suits the program's inputs, as a workshop makes it.
    pub(crate) fn suited(&self, shared: &Shared) -> Option<Simulation> {
        let limits = self.limits(&shared.sources)?.ok()?;
        let usual = Workpiece::usual(limits.feature?, limits.middle().to_mm_f64());
        let surface = Surface::Round(Workpiece { centre: self.centre().map(Length::to_mm_f64), ..usual }, Plane::Xy);
        let machine =
            shared.workpiece.form.simulation.as_ref().copied().unwrap_or_else(|| Simulation::perfect(surface));
        Some(Simulation { surface, ..machine })
    }

    /// What both pages measure was changed: clears a run on it. If this page is open, it is measured from now on.
    pub(super) fn workpiece_changed(&mut self, from: WorkpieceFrom, shared: &Shared) {
        if shared.page == Page::Program {
            self.workpiece = from;
        }
        if matches!(self.workpiece, WorkpieceFrom::Simulated | WorkpieceFrom::Part) {
            self.reset();
        }
    }

    /// Contacts were read: they are measured from now on where this page asked for them. What the cycles page measures is its own.
    pub(super) fn contacts_taken(&mut self, shared: &Shared) {
        if shared.page == Page::Program {
            self.recorded.clone_from(&shared.workpiece.recorded);
            self.workpiece = WorkpieceFrom::Recorded;
            self.reset();
        }
    }

    /// What the next run measures, or why it cannot.
    pub(super) fn contacts(&mut self, shared: &Shared) -> Result<Contacts, Message> {
        let limits = self.limits(&shared.sources).and_then(Result::ok);
        match self.workpiece {
            WorkpieceFrom::Perfect => {
                let round = |limits: Limits| Some(Self::round(limits.feature?, self.centre(), limits.middle()));
                Ok(limits.and_then(round).unwrap_or(Contacts::Perfect))
            }
            WorkpieceFrom::Given => {
                let mut read = |field| {
                    let result = self.field_length(field);
                    if let Err(problem) = &result {
                        self.errors.insert(field, problem.clone());
                    }
                    result.map_err(|_told| message!("program-page-refused-workpiece"))
                };
                let diameter = read(ProgramField::Diameter)?;
                let centre = [read(ProgramField::WorkpieceX)?, read(ProgramField::WorkpieceY)?];
                let feature = limits.and_then(|limits| limits.feature).unwrap_or(Feature::Hole);
                Ok(Self::round(feature, centre, diameter))
            }
            WorkpieceFrom::Simulated => match shared.workpiece.form.simulation.as_ref() {
                Some(bench) => Ok(Contacts::Workpiece((*bench).into())),
                None => Err(message!("program-page-refused-workpiece")),
            },
            WorkpieceFrom::Part => match &shared.workpiece.part {
                Some(open) => Ok(Contacts::Workpiece(open.part.clone())),
                None => Err(message!("program-page-refused-no-part")),
            },
            WorkpieceFrom::Recorded => match &self.recorded {
                Some(recorded) => Ok(Contacts::of_file(recorded.contacts.clone(), recorded.has_heights)),
                None => Err(message!("program-page-refused-no-contacts")),
            },
        }
    }
}
