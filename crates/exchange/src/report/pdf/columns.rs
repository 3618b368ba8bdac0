//! The columns of the table, and how wide they are: numbers as wide as the widest of them, texts as far as there is room.

use fitcheck_core::words::Words;

use super::cells::{CHIP_MORE, PAD, Row, count, head, is_text};
use super::fonts::Fonts;
use super::look::{CELL, CHIP, LABEL, NOTE, SIDE, VALUE};
use crate::report::template::Column;

/// The least and the usual width of the limit band.
const BAND: [f32; 2] = [60.0, 112.0];
/// The width of a cell that is filled in by hand.
const BLANK: f32 = 70.0;
/// The least width of a text.
const TEXT: f32 = 36.0;

/// The widths that the cells ask for, and then those that they get.
#[derive(Debug, Clone)]
pub(super) struct Widths {
    /// From left to right, with the left edge of each and its width.
    columns: Vec<(Column, [f32; 2])>,
}

impl Widths {
    /// What the heads ask for.
    pub fn new(fonts: &Fonts, words: &Words, columns: &[Column]) -> Self {
        let width = |column: Column| {
            let head = head(column, words);
            // A head is broken between its words.
            let widest = head.split(' ').map(|word| fonts.width(word, LABEL.weight, LABEL.size)).fold(0.0, f32::max);
            let least = match column {
                Column::Number => 22.0,
                Column::Blank => BLANK,
                _ => 0.0,
            };
            [SIDE, (widest + 2.0 * PAD + 0.5).max(least)]
        };
        Self { columns: columns.iter().map(|column| (*column, width(*column))).collect() }
    }

    /// The columns from left to right.
    pub fn all(&self) -> impl Iterator<Item = Column> {
        self.columns.iter().map(|(column, _)| *column)
    }

    /// What a row asks for.
    pub fn see(&mut self, fonts: &Fonts, row: &Row) {
        for (column, place) in &mut self.columns {
            let text = row.text(*column);
            let asked = match column {
                Column::Band => continue,
                // Long ones are broken anyway.
                _ if 200 < text.len() => 200.0,
                Column::Verdict => {
                    let widths = text.lines().map(|line| fonts.width(line, CHIP.weight, CHIP.size));
                    widths.fold(0.0, f32::max) + CHIP_MORE
                }
                Column::Feature | Column::Measured => fonts.width(text, VALUE.weight, VALUE.size),
                Column::From | Column::Remark => fonts.width(text, NOTE.weight, NOTE.size),
                _ => fonts.width(text, CELL.weight, CELL.size),
            };
            place[1] = place[1].max(asked + 2.0 * PAD + 0.5);
        }
    }

    /// Shares a width out: numbers and verdicts get what they ask for, the texts and the band what is left.
    pub fn fit(mut self, width: f32) -> Self {
        let taken: f32 = self
            .all()
            .filter(|column| !is_text(*column) && *column != Column::Band)
            .map(|column| self.asked(column))
            .sum();
        let texts: Vec<f32> = self.all().filter(|column| is_text(*column)).map(|column| self.asked(column)).collect();
        let asked: f32 = texts.iter().sum();
        let free = width - taken;
        let has_band = self.all().any(|column| column == Column::Band);
        let band = if has_band { (free - asked).clamp(BAND[0].max(self.asked(Column::Band)), BAND[1]) } else { 0.0 };
        let room = (free - band).max(count(texts.len()) * TEXT);
        // What is too wide gives way: the widest ones share what the others leave.
        let mut most = f32::INFINITY;
        if room < asked {
            most = room / count(texts.len().max(1));
            for _ in 0..texts.len() {
                let small: Vec<f32> = texts.iter().copied().filter(|asked| *asked <= most).collect();
                let wide = texts.len().saturating_sub(small.len()).max(1);
                most = (room - small.iter().sum::<f32>()) / count(wide);
            }
        }
        let mut spare = (room - asked).max(0.0);
        let mut x = SIDE;
        for (column, place) in &mut self.columns {
            let asked = place[1];
            let mut given = if is_text(*column) { asked.min(most) } else { asked };
            if *column == Column::Band {
                given = band;
            }
            // What is left over goes to the first text.
            if is_text(*column) {
                given += std::mem::take(&mut spare);
            }
            *place = [x, given];
            x += given;
        }
        self
    }

    fn asked(&self, column: Column) -> f32 {
        self.of(column)[1]
    }

    /// The left edge of a column, and its width.
    pub fn of(&self, column: Column) -> [f32; 2] {
        self.columns.iter().find(|(known, _)| *known == column).map_or([SIDE, 0.0], |(_, place)| *place)
    }
}
