//! Editing the table of a plan.

use std::sync::Arc;

use fitcheck_core::message::{Say, message};
use fitcheck_core::part::{Draft, HeadField, MOST_FEATURES, Spot};
use fitcheck_core::tolerance::Sources;

use super::document::Typing;
use super::draft_cells::{selected, write};
use super::rows::fresh;
use super::{PartsPage, PlanCommand, PlanField};
use crate::effect::Effect;
use crate::shared::Shared;

impl PartsPage {
    /// Edits the plan, or moves in its table.
    pub(super) fn edit(&mut self, command: PlanCommand, shared: &mut Shared) -> Option<Effect> {
        let sources = Arc::clone(&shared.sources);
        let goes_on = matches!(
            command,
            PlanCommand::Type(..)
                | PlanCommand::Leave
                | PlanCommand::PlaceBalloon { .. }
                | PlanCommand::PictureRead { .. }
        );
        if !goes_on {
            self.settle();
        }
        let (row, column) = self.sheet.at();
        match command {
            PlanCommand::Type(field, text) => self.type_into(field, &text, &sources),
            PlanCommand::Leave => {
                self.document.revert(&sources);
                self.sheet.edit(false);
            }
            PlanCommand::Go(row, column, extends) => self.sheet.go(row, column, extends, &self.document),
            PlanCommand::Move(step, extends) => self.sheet.step(step, extends, &self.document),
            PlanCommand::Tab(forwards) => self.sheet.tab(forwards, &self.document),
            PlanCommand::Edit(text) => {
                self.sheet.go(row, column, false, &self.document);
                self.sheet.edit(true);
                if let Some(text) = text {
                    self.type_into(PlanField::Cell, &text, &sources);
                }
            }
            PlanCommand::Take(step) => {
                if let Some(step) = step {
                    self.sheet.step(step, false, &self.document);
                }
            }
            PlanCommand::Empty => self.empty(&sources),
            PlanCommand::Copy => return Some(Effect::Copy(self.copied())),
            PlanCommand::AskForPaste => return Some(Effect::AskForClipboard),
            PlanCommand::Paste(text) => self.paste(&text, shared, &sources),
            PlanCommand::Sort => self.sort(column, &sources),
            PlanCommand::Renumber => self.document.change(&sources, Draft::renumber),
            PlanCommand::ShowAll(shows_all) => self.sheet.show_all(shows_all, &self.document),
            PlanCommand::GoToFinding(place) => return self.go_to_finding(place),
            PlanCommand::NextFinding(forwards) => {
                let place = self.next_finding(forwards)?;
                return self.go_to_finding(place);
            }
            PlanCommand::GoToProblem(place) => {
                if let Some(row) = self.document.row_of_problem(place) {
                    self.sheet.go(row, column, false, &self.document);
                }
            }
            PlanCommand::TakeMeant => {
                let meant = self.meant_here()?;
                self.document.change(&sources, |draft| {
                    if let Some(row) = draft.rows.get_mut(row) {
                        write(row, column, &meant);
                    }
                });
            }
            PlanCommand::LeaveOut => self.leave_out(shared, &sources),
            PlanCommand::ChoosePicture(path) => match self.choose_picture(&path) {
                Ok(name) => {
                    shared.file_answered(Ok(()));
                    self.document.change(&sources, |draft| write_head(draft, HeadField::Picture, &name));
                }
                Err(why) => _ = shared.file_answered::<()>(Err(why)),
            },
            PlanCommand::PictureRead { path, result } => self.picture_read(&path, &result),
            command => self.edit_rows(&command, &sources),
        }
        self.sheet.follow(&self.document);
        None
    }

    /// Empties the selected cells.
    fn empty(&mut self, sources: &Sources) {
        let rows = self.sheet.selected_rows();
        let columns = self.sheet.selected_columns();
        self.document.change(sources, |draft| {
            for row in selected(draft, &rows) {
                for column in &columns {
                    write(row, *column, "");
                }
            }
        });
    }

    /// What the cell should probably hold at which the keys are.
    pub(crate) fn meant_here(&self) -> Option<String> {
        let (row, column) = self.sheet.at();
        self.document.finding(row, Some(column))?.what.meant()
    }

    /// Ends what is typed.
    pub(super) fn settle(&mut self) {
        self.document.settle();
        self.sheet.edit(false);
    }

    fn type_into(&mut self, field: PlanField, text: &str, sources: &Sources) {
        match field {
            PlanField::Cell => {
                let (row, column) = self.sheet.at();
                self.sheet.edit_on();
                let begins = self.document.begins_row(row);
                self.document.type_into(Typing::Cell(row, column), sources, |draft| {
                    // Below the last feature the next one is begun; erased again, it is none.
                    if row == draft.rows.len() && !text.is_empty() && row < MOST_FEATURES {
                        draft.rows.push(fresh(draft, row));
                    }
                    if let Some(row) = draft.rows.get_mut(row) {
                        write(row, column, text);
                    }
                    if begins && text.is_empty() && row + 1 == draft.rows.len() {
                        let last = draft.rows.pop();
                        if let Some(last) = last.filter(|last| !last.is_empty() && *last != fresh(draft, row)) {
                            draft.rows.push(last);
                        }
                    }
                });
            }
            PlanField::Head(field) => {
                self.document.type_into(Typing::Head(field), sources, |draft| write_head(draft, field, text));
            }
        }
    }

    /// The plan is what could be read of its file from now on; what could not is told once more.
    fn leave_out(&mut self, shared: &mut Shared, sources: &Sources) {
        let left = self.document.leave_out(sources);
        if !left.is_empty() {
            let message = message!("parts-page-left-out").text("name", self.document.name());
            shared.note(message.count("count", left.len()), left.iter().map(Say::message).collect());
        }
    }

    /// The place of what is wrong after the cell, or before it, and round again.
    fn next_finding(&self, forwards: bool) -> Option<usize> {
        let findings = self.document.findings();
        let (row, column) = self.sheet.at();
        let here = Spot::Feature(row, Some(column));
        let place = if forwards {
            findings.iter().position(|finding| here < finding.spot).or(Some(0))
        } else {
            findings.iter().rposition(|finding| finding.spot < here).or_else(|| findings.len().checked_sub(1))
        };
        place.filter(|place| *place < findings.len())
    }

    fn go_to_finding(&mut self, place: usize) -> Option<Effect> {
        let spot = self.document.findings().get(place)?.spot;
        self.go_to_spot(spot)
    }

    fn go_to_spot(&mut self, spot: Spot) -> Option<Effect> {
        match spot {
            Spot::Feature(row, column) => {
                let (_, here) = self.sheet.at();
                self.sheet.show(row, column.unwrap_or(here), &self.document);
                Some(Effect::FocusTable)
            }
            Spot::Head(field) => Some(Effect::Focus(PlanField::Head(field).into())),
            Spot::Plan => None,
        }
    }

    /// Takes a change back, or makes it again, and goes to where it was.
    pub(super) fn step_back(&mut self, back: bool, sources: &Sources) {
        self.sheet.edit(false);
        let spot = self.document.step(back, sources);
        self.sheet.follow(&self.document);
        if let Some(Spot::Feature(row, column)) = spot {
            let (_, here) = self.sheet.at();
            let column = column.filter(|column| self.sheet.columns.contains(column)).unwrap_or(here);
            self.sheet.go(row, column, false, &self.document);
        }
    }

    /// The text of a field of the plan.
    pub fn plan_text(&self, field: PlanField) -> &str {
        match field {
            PlanField::Cell => {
                let (row, column) = self.sheet.at();
                self.document.draft().rows.get(row).map_or("", |row| &row.cell(column).text)
            }
            PlanField::Head(field) => &self.document.draft().cell(field).text,
        }
    }
}

fn write_head(draft: &mut Draft, field: HeadField, text: &str) {
    if draft.cell(field).text != text {
        draft.set(field, text.to_owned());
    }
}
