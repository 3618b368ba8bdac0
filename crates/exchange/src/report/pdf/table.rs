//! The table of values: its columns, its rows, and its head again on every page.

use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::cells::{CHIP_MORE, PAD, Row, count, head, is_number, unit};
use super::columns::Widths;
use super::flow::{Flow, apart, base};
use super::fonts::Fonts;
use super::look::{CELL, CHIP, LABEL, LINE, NOTE, Style, TEXT, VALUE, tone};
use super::sheet::{Area, Edge, Shape};
use super::signs::{Outline, Sign};
use super::tags::{Kind, TagId};
use super::wrap::wrap;
use crate::report::template::Column;

/// What stands in a cell with nothing in it, so that every row has all of its cells, also for those who hear it.
const NOTHING: &str = "–";
/// The height of a row of one line, and of each more.
const ROW: f32 = 18.0;
const NEXT: f32 = 10.6;
/// The most lines of a cell, and of a note below a row.
const MOST_LINES: usize = 3;
/// The most lines of where a value is from.
const SOURCE_LINES: usize = 2;

/// A row in lines.
pub(super) struct Laid<'a> {
    row: &'a Row,
    texts: Vec<(Column, Vec<String>)>,
    notes: Vec<String>,
    height: f32,
    below: f32,
}

impl Laid<'_> {
    /// The height of the row with its notes.
    pub const fn height(&self) -> f32 {
        self.height + self.below
    }
}

/// A table that is being written.
pub(super) struct Table {
    widths: Widths,
    heads: Vec<(Column, Vec<String>)>,
    section: TagId,
    /// Where its rows belong, once it is begun.
    body: TagId,
}

impl Table {
    /// A table with these columns.
    pub fn new(flow: &mut Flow<'_>, section: TagId, widths: Widths, words: &Words) -> Self {
        let mut heads = Vec::new();
        for column in widths.all() {
            let [_, width] = widths.of(column);
            let mut lines = flow.wrap(&head(column, words), LABEL, width - 2.0 * PAD, MOST_LINES);
            lines.extend(unit(column).map(str::to_owned));
            heads.push((column, apart(lines)));
        }
        Self { widths, heads, section, body: section }
    }

    /// Begins it here; at least two of its rows stand on this page.
    pub fn begin(&mut self, flow: &mut Flow<'_>) {
        let table = flow.tags.add(self.section, Kind::Table);
        let head = flow.tags.add(table, Kind::TableHead);
        let row = flow.tags.add(head, Kind::Row);
        self.body = flow.tags.add(table, Kind::TableBody);
        flow.room(self.head_height() + 2.0 * ROW);
        self.head(flow, Some(row));
    }

    /// How high its head is.
    pub fn head_height(&self) -> f32 {
        let lines = self.heads.iter().map(|(_, lines)| lines.len()).fold(1, usize::max);
        count(lines) * NEXT + 5.0
    }

    /// The heads of the columns; again on the next page, where they have no meaning of their own.
    fn head(&self, flow: &mut Flow<'_>, row: Option<TagId>) {
        let height = self.head_height();
        let bottom = flow.y + height;
        for (column, lines) in &self.heads {
            let cell = row.map(|row| flow.tags.add(row, Kind::ColumnHead));
            let mut y = bottom - 3.0 - count(lines.len()) * NEXT;
            for line in lines {
                self.set(flow, cell, (*column, base(y, NEXT, LABEL)), LABEL, line.clone());
                y += NEXT;
            }
        }
        flow.rule(bottom, 1.0, TEXT);
        flow.y = bottom;
    }

    /// Sets a line in a column.
    fn set(&self, flow: &mut Flow<'_>, cell: Option<TagId>, (column, y): (Column, f32), style: Style, line: String) {
        let [x, width] = self.widths.of(column);
        if is_number(column) {
            flow.say_to(cell, [x + width - PAD, y], style, line);
        } else if column == Column::Number {
            flow.say_round(cell, [x + width / 2.0, y], style, line);
        } else {
            flow.say(cell, [x + PAD, y], style, line);
        }
    }

    /// A row in lines, and how high it is.
    pub fn lay<'a>(&self, flow: &mut Flow<'_>, row: &'a Row) -> Laid<'a> {
        let mut most = 1;
        let mut texts = Vec::new();
        for column in self.widths.all() {
            let style = style(column);
            let [_, width] = self.widths.of(column);
            // A cell that is filled in by hand stays empty.
            let nothing = if column == Column::Blank { " " } else { NOTHING };
            let text = if row.text(column).is_empty() { nothing } else { row.text(column) };
            let lines = match column {
                Column::Band => Vec::new(),
                Column::Verdict | Column::Number => vec![text.to_owned()],
                // Where it stands in full is below the table.
                Column::From => wrap(flow.fonts, &Fonts::clean(text), style, width - 2.0 * PAD, SOURCE_LINES).lines,
                _ => flow.wrap(text, style, width - 2.0 * PAD, MOST_LINES),
            };
            most = most.max(lines.len());
            texts.push((column, lines));
        }
        let width = flow.right() - self.left() - 2.0 * PAD;
        let notes: Vec<_> =
            row.notes.iter().flat_map(|note| flow.wrap(&format!("{note} "), NOTE, width, MOST_LINES)).collect();
        let simulated = if row.is_simulated { 8.0 } else { 0.0 };
        let height = (ROW + count(most.saturating_sub(1)) * NEXT).max(ROW + simulated);
        let below = if notes.is_empty() { 0.0 } else { count(notes.len()) * NEXT + 2.0 };
        Laid { row, texts, notes, height, below }
    }

    /// Where names, and notes below them, begin.
    fn left(&self) -> f32 {
        let [left, _] = self.widths.of(Column::Feature);
        left
    }

    /// Writes a row; a page that it does not fit on is turned first.
    pub fn row(&self, flow: &mut Flow<'_>, laid: Laid<'_>) {
        let Laid { row, texts, notes, height, below } = laid;
        if flow.room(height + below) {
            self.head(flow, None);
        }
        let element = flow.tags.add(self.body, Kind::Row);
        let mut last = None;
        for (column, lines) in texts {
            let kind = if column == Column::Feature { Kind::RowHead } else { Kind::Cell };
            let cell = flow.tags.add(element, kind);
            let area = self.area(flow, column, height);
            match column {
                Column::Number => balloon(flow, cell, area, row),
                Column::Band => band(flow, cell, area, row),
                Column::Verdict => chip(flow, cell, area, row),
                _ => {
                    let mut y = flow.y + (height - count(lines.len()) * NEXT) / 2.0;
                    for mut line in lines {
                        // The notes are read after where the value is from.
                        if column == Column::From && !notes.is_empty() {
                            line.push(' ');
                        }
                        self.set(flow, Some(cell), (column, base(y, NEXT, CELL)), style(column), line);
                        y += NEXT;
                    }
                }
            }
            last = Some(cell);
        }
        let mut y = flow.y + height - 2.0;
        for line in notes {
            flow.say(last, [self.left() + PAD, base(y, NEXT, NOTE)], NOTE, line);
            y += NEXT;
        }
        flow.y += height + below;
        flow.rule(flow.y, 0.5, LINE);
    }

    fn area(&self, flow: &Flow<'_>, column: Column, height: f32) -> Area {
        let [x, width] = self.widths.of(column);
        Area::new(x, flow.y, width, height)
    }
}

const fn style(column: Column) -> Style {
    match column {
        Column::Feature | Column::Measured => VALUE,
        Column::From | Column::Remark => NOTE,
        _ => CELL,
    }
}

/// The number of a row in the outline of its verdict, as on the picture.
fn balloon(flow: &mut Flow<'_>, cell: TagId, area: Area, row: &Row) {
    let style = CHIP.in_ink(tone(row.status).on);
    let label = if row.label.is_empty() { NOTHING.to_owned() } else { row.label.clone() };
    let middle = area.middle();
    let is_wide = 13.0 < flow.fonts.width(&label, style.weight, style.size);
    if is_wide {
        return flow.say_round(Some(cell), [middle[0], base(area.y, area.height, CELL)], CELL, label);
    }
    flow.put(None, outline(row.status, row.is_simulated, middle, 7.2));
    let style = if row.is_simulated { style.in_ink(TEXT) } else { style };
    flow.say_round(Some(cell), [middle[0], base(area.y, area.height, style)], style, label);
}

/// The outline of a verdict, filled with its colour.
pub(super) fn outline(status: Option<Status>, is_simulated: bool, middle: [f32; 2], radius: f32) -> Shape {
    let tone = tone(status);
    let fill = match status {
        None => super::look::PAPER,
        Some(_) if is_simulated => tone.pale,
        Some(_) => tone.ground,
    };
    let edge = Edge { ink: TEXT, width: 1.0, is_dashed: is_simulated };
    Shape::Outline { outline: Outline::of(status), middle, radius, fill, edge }
}

fn band(flow: &mut Flow<'_>, cell: TagId, area: Area, row: &Row) {
    let Some((shape, said)) = &row.band else {
        return flow.say(Some(cell), [area.x + PAD, base(area.y, area.height, CELL)], CELL, NOTHING.to_owned());
    };
    let area = Area::new(area.x + PAD, area.middle()[1] - 5.5, area.width - 2.0 * PAD, 11.0);
    let place = Some((flow.page(), [area.x, area.y, area.width, area.height]));
    let figure = flow.tags.add(cell, Kind::Figure(said.clone(), place));
    flow.put(Some(figure), Shape::Band(area, Box::new(shape.clone())));
}

/// Sign and word of a verdict; above them that nobody measured.
fn chip(flow: &mut Flow<'_>, cell: TagId, area: Area, row: &Row) {
    let tone = tone(row.status);
    let ink = if row.is_simulated || row.status.is_none() { TEXT } else { tone.on };
    let style = CHIP.in_ink(ink);
    let lines = apart(row.word.lines().map(str::to_owned).collect());
    let width =
        lines.iter().map(|line| flow.fonts.width(line.trim_end(), style.weight, style.size)).fold(0.0, f32::max);
    let height = 4.4 + count(lines.len()) * 9.0;
    let chip = Area::new(area.x + PAD, area.middle()[1] - height / 2.0, width + CHIP_MORE, height);
    let edge = row.is_simulated.then_some(Edge { ink: TEXT, width: 0.8, is_dashed: true });
    let fill = if row.is_simulated { tone.pale } else { tone.ground };
    if row.status.is_some() {
        flow.put(None, Shape::Block { area: chip, radius: 3.0, fill: Some(fill), edge });
    }
    let middle = [chip.x + 9.0, chip.middle()[1]];
    flow.put(None, Shape::Sign { sign: Sign::of(row.status), middle, size: 9.5, ink });
    let mut y = chip.y + 2.2;
    for line in lines {
        flow.say(Some(cell), [chip.x + 17.0, base(y, 9.0, style)], style, line);
        y += 9.0;
    }
}
