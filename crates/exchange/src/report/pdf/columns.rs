//! How wide the columns of the table are: numbers as wide as the widest of them, texts as far as there is room.

use fitcheck_core::words::Words;

use super::cells::{CHIP_MORE, Column, PAD, Row};
use super::fonts::Fonts;
use super::look::{CELL, CHIP, LABEL, NOTE, SIDE, VALUE};

/// The least and the usual width of the limit band.
const BAND: [f32; 2] = [60.0, 112.0];
/// The least width of a text.
const TEXT: f32 = 36.0;

/// The widths that the cells ask for, and then those that they get.
#[derive(Debug, Clone)]
pub(super) struct Widths {
    /// The left edge of each column, and its width.
    columns: [[f32; 2]; Column::ALL.len()],
}

impl Widths {
    /// What the heads ask for.
    pub fn new(fonts: &Fonts, words: &Words) -> Self {
        let width = |column: Column| {
            let head = column.head(words);
            // A head is broken between its words.
            let widest = head.split(' ').map(|word| fonts.width(word, LABEL.weight, LABEL.size)).fold(0.0, f32::max);
            let least = if column == Column::Label { 22.0 } else { 0.0 };
            [SIDE, (widest + 2.0 * PAD + 0.5).max(least)]
        };
        Self { columns: Column::ALL.map(width) }
    }

    /// What a row asks for.
    pub fn see(&mut self, fonts: &Fonts, row: &Row) {
        for (column, place) in Column::ALL.into_iter().zip(&mut self.columns) {
            let text = row.text(column);
            let asked = match column {
                Column::Band => continue,
                // Long ones are broken anyway.
                _ if 200 < text.len() => 200.0,
                Column::Word => {
                    let widths = text.lines().map(|line| fonts.width(line, CHIP.weight, CHIP.size));
                    widths.fold(0.0, f32::max) + CHIP_MORE
                }
                Column::Name | Column::Measured => fonts.width(text, VALUE.weight, VALUE.size),
                Column::Source => fonts.width(text, NOTE.weight, NOTE.size),
                _ => fonts.width(text, CELL.weight, CELL.size),
            };
            place[1] = place[1].max(asked + 2.0 * PAD + 0.5);
        }
    }

    /// Shares a width out: numbers and verdicts get what they ask for, the texts and the band what is left.
    pub fn fit(mut self, width: f32) -> Self {
        let taken: f32 = Column::ALL
            .into_iter()
            .filter(|column| !column.is_text() && *column != Column::Band)
            .map(|column| self.asked(column))
            .sum();
        let texts = Column::ALL.into_iter().filter(|column| column.is_text());
        let asked: f32 = texts.clone().map(|column| self.asked(column)).sum();
        let free = width - taken;
        let band = (free - asked).clamp(BAND[0].max(self.asked(Column::Band)), BAND[1]);
        let room = (free - band).max(3.0 * TEXT);
        // What is too wide gives way: the widest ones share what the others leave.
        let mut most = f32::INFINITY;
        if room < asked {
            most = room / 3.0;
            for _ in 0..3 {
                let small: Vec<f32> =
                    texts.clone().map(|column| self.asked(column)).filter(|asked| *asked <= most).collect();
                let wide = 3_u8.saturating_sub(u8::try_from(small.len()).unwrap_or(3)).max(1);
                most = (room - small.iter().sum::<f32>()) / f32::from(wide);
            }
        }
        let spare = (room - asked).max(0.0);
        let mut x = SIDE;
        for column in Column::ALL {
            let mut given = if column.is_text() { self.asked(column).min(most) } else { self.asked(column) };
            if column == Column::Band {
                given = band;
            }
            if column == Column::Name {
                given += spare;
            }
            if let Some(place) = self.columns.get_mut(column.at()) {
                *place = [x, given];
            }
            x += given;
        }
        self
    }

    fn asked(&self, column: Column) -> f32 {
        self.of(column)[1]
    }

    /// The left edge of a column, and its width.
    pub fn of(&self, column: Column) -> [f32; 2] {
        self.columns.get(column.at()).copied().unwrap_or([SIDE, 0.0])
    }
}
