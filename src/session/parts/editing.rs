//! Editing the table of a plan.

use std::sync::Arc;

use super::document::Typing;
use super::paste;
use super::picture::NUDGE;
use super::sheet::Sheet;
use super::sorting;
use super::{PartsPage, PlanCommand, PlanField};
use crate::message::Message;
use crate::part::{Column, Draft, HeadField, MOST_FEATURES, Row, Spot};
use crate::session::command::Effect;
use crate::session::shared::Shared;
use crate::session::{Field, Step};
use crate::tolerance::Sources;

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
            PlanCommand::Empty => {
                let (rows, columns) = (self.sheet.selected_rows(), self.sheet.selected_columns());
                self.document.change(&sources, |draft| {
                    for row in selected(draft, &rows) {
                        for column in &columns {
                            write(row, *column, "");
                        }
                    }
                });
            }
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
            PlanCommand::ChoosePicture(path) => match self.choose_picture(&path) {
                Ok(name) => {
                    shared.file_answered(Ok(()));
                    self.document.change(&sources, |draft| write_head(draft, HeadField::Picture, &name));
                }
                Err(why) => _ = shared.file_answered::<()>(Err(why)),
            },
            PlanCommand::PictureRead { path, result } => self.picture_read(&path, result),
            command => self.edit_rows(&command, &sources),
        }
        self.sheet.follow(&self.document);
        None
    }

    /// Inserts, deletes and moves rows, and places balloons.
    fn edit_rows(&mut self, command: &PlanCommand, sources: &Sources) {
        let (row, column) = self.sheet.at();
        match command {
            PlanCommand::Insert => {
                let is_room = self.document.draft().rows.len() < MOST_FEATURES;
                self.document.change(sources, |draft| {
                    if is_room {
                        draft.rows.insert(row.min(draft.rows.len()), Row::default());
                    }
                });
                self.sheet.go(row, column, false, &self.document);
            }
            PlanCommand::Delete => {
                let rows = self.sheet.selected_rows();
                self.document.change(sources, |draft| {
                    let rows = clamped(&rows, draft.rows.len());
                    draft.rows.drain(rows);
                });
                self.sheet.go(*rows.start(), column, false, &self.document);
            }
            PlanCommand::MoveRows(step) => self.move_rows(*step == Step::Up, sources),
            PlanCommand::PlaceBalloon { row, at, is_done } => {
                self.document.type_into(Typing::Balloon(*row), sources, |draft| place(draft, *row, *at));
                if *is_done {
                    self.document.settle();
                }
            }
            PlanCommand::NudgeBalloon(row, step) => {
                let at = self.balloons().get(*row).and_then(|balloon| balloon.at);
                if let Some([x, y]) = at {
                    let at = match step {
                        Step::Left => [x - NUDGE, y],
                        Step::Right => [x + NUDGE, y],
                        Step::Up => [x, y - NUDGE],
                        Step::Down => [x, y + NUDGE],
                        _ => [x, y],
                    };
                    self.document.change(sources, |draft| place(draft, *row, at));
                }
            }
            PlanCommand::RemoveBalloon(row) => self.document.change(sources, |draft| {
                if let Some(row) = draft.rows.get_mut(*row) {
                    write(row, Column::BalloonX, "");
                    write(row, Column::BalloonY, "");
                }
            }),
            // Every other command is done elsewhere.
            _ => {}
        }
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
                self.document.type_into(Typing::Cell(row, column), sources, |draft| {
                    // Below the last feature the next one is begun.
                    if row == draft.rows.len() && !text.is_empty() && row < MOST_FEATURES {
                        draft.rows.push(Row::default());
                    }
                    if let Some(row) = draft.rows.get_mut(row) {
                        write(row, column, text);
                    }
                });
            }
            PlanField::Head(field) => {
                self.document.type_into(Typing::Head(field), sources, |draft| write_head(draft, field, text));
            }
        }
    }

    /// The selected cells as a spreadsheet takes them.
    fn copied(&self) -> String {
        let (rows, columns) = (self.sheet.selected_rows(), self.sheet.selected_columns());
        let rows = self.document.draft().rows.get(clamped(&rows, self.document.draft().rows.len()));
        let lines = rows
            .into_iter()
            .flatten()
            .map(|row| paste::line(columns.iter().map(|column| (*column, row.cell(*column).text.clone()))));
        let lines: Vec<String> = lines.collect();
        lines.join("\n")
    }

    /// Puts cells at the cell; one cell alone goes into every selected one. What finds no place is told.
    fn paste(&mut self, text: &str, shared: &mut Shared, sources: &Sources) {
        let mut rows = paste::cells(text);
        let named = paste::header(&rows);
        if named.is_some() {
            rows.remove(0);
        }
        let (row, column) = if named.is_some() {
            (*self.sheet.selected_rows().start(), Column::Number)
        } else {
            let corner = self.sheet.selected_columns().first().copied();
            (*self.sheet.selected_rows().start(), corner.unwrap_or(Column::Name))
        };
        let first = self.sheet.columns().iter().position(|of| *of == column).unwrap_or_default();
        let columns = named.clone().unwrap_or_else(|| self.sheet.columns().get(first..).unwrap_or_default().to_vec());
        if let ([cells], None) = (rows.as_slice(), &named)
            && let [text] = cells.as_slice()
            && self.sheet.is_block()
        {
            return self.fill(text, sources);
        }
        let lost_rows = (row + rows.len()).saturating_sub(MOST_FEATURES);
        let wide = rows.iter().map(Vec::len).max().unwrap_or_default();
        let lost_columns = wide.saturating_sub(columns.len());
        rows.truncate(rows.len().saturating_sub(lost_rows));
        let block = (rows.len(), wide.min(columns.len()));
        self.document.change(sources, |draft| {
            if draft.rows.len() < row + rows.len() {
                draft.rows.resize(row + rows.len(), Row::default());
            }
            for (row, cells) in draft.rows.iter_mut().skip(row).zip(rows) {
                for (column, text) in columns.iter().zip(cells) {
                    write(row, *column, text.trim());
                }
            }
        });
        self.sheet.follow(&self.document);
        if named.is_none() {
            self.sheet.select((row, column), block.0, block.1);
        }
        if 0 < lost_rows {
            let message = Message::new("parts-page-pasted-rows").count("count", lost_rows);
            shared.tell(message.count("most", MOST_FEATURES));
        }
        if 0 < lost_columns {
            shared.tell(Message::new("parts-page-pasted-columns").count("count", lost_columns));
        }
    }

    /// Writes one text into every selected cell.
    fn fill(&mut self, text: &str, sources: &Sources) {
        let (rows, columns) = (self.sheet.selected_rows(), self.sheet.selected_columns());
        self.document.change(sources, |draft| {
            for row in selected(draft, &rows) {
                for column in &columns {
                    write(row, *column, text.trim());
                }
            }
        });
    }

    fn sort(&mut self, column: Column, sources: &Sources) {
        let text = |row: &Row| row.cell(column).text.clone();
        let is_sorted = self
            .document
            .draft()
            .rows
            .is_sorted_by(|one, other| sorting::order(&one.cell(column).text, &other.cell(column).text).is_le());
        self.document.change(sources, |draft| {
            draft.rows.sort_by(|one, other| {
                let order = sorting::order(&text(one), &text(other));
                // Empty cells stay last.
                let is_empty = one.text(column).is_none() || other.text(column).is_none();
                if is_sorted && !is_empty { order.reverse() } else { order }
            });
        });
    }

    fn move_rows(&mut self, up: bool, sources: &Sources) {
        let rows = clamped(&self.sheet.selected_rows(), self.document.draft().rows.len());
        let can = if up { 0 < rows.start } else { rows.end < self.document.draft().rows.len() };
        if !can || rows.is_empty() {
            return;
        }
        self.document.change(sources, |draft| {
            let around = if up { rows.start - 1..rows.end } else { rows.start..rows.end + 1 };
            if let Some(around) = draft.rows.get_mut(around) {
                if up { around.rotate_left(1) } else { around.rotate_right(1) }
            }
        });
        let moved = if up { rows.start - 1..=rows.end - 2 } else { rows.start + 1..=rows.end };
        self.sheet.select_rows(moved);
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
            Spot::Head(field) => Some(Effect::Focus(Field::Plan(PlanField::Head(field)))),
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
            let column = column.filter(|column| self.sheet.columns().contains(column)).unwrap_or(here);
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

    /// The table of the plan.
    pub const fn sheet(&self) -> &Sheet {
        &self.sheet
    }
}

/// Writes a cell, unless that is what it has: a text that a file has stays where it is.
fn write(row: &mut Row, column: Column, text: &str) {
    if row.cell(column).text != text {
        row.set(column, text.to_owned());
    }
}

fn write_head(draft: &mut Draft, field: HeadField, text: &str) {
    if draft.cell(field).text != text {
        draft.set(field, text.to_owned());
    }
}

/// The selected features.
fn selected<'a>(draft: &'a mut Draft, rows: &std::ops::RangeInclusive<usize>) -> &'a mut [Row] {
    let rows = clamped(rows, draft.rows.len());
    draft.rows.get_mut(rows).unwrap_or_default()
}

/// Selected rows as far as there are features.
fn clamped(rows: &std::ops::RangeInclusive<usize>, count: usize) -> std::ops::Range<usize> {
    (*rows.start()).min(count)..(*rows.end() + 1).min(count)
}

/// Puts the balloon of a row on the picture.
fn place(draft: &mut Draft, row: usize, at: [f64; 2]) {
    let Some(row) = draft.rows.get_mut(row) else { return };
    for (column, share) in [Column::BalloonX, Column::BalloonY].into_iter().zip(at) {
        write(row, column, &format!("{:.4}", share.clamp(0.0, 1.0)));
    }
}
