//! The answer on the first look: a verdict with its sign and its word, or how many there are of each.

use fitcheck_core::verdict::Status;

use super::flow::{Flow, base};
use super::look::{BODY, CARD, RADIUS, STRONG, Style, TEXT, WORD, tone};
use super::sheet::{Area, Edge, Shape};
use super::signs::Sign;
use super::table::outline;
use super::tags::{Kind, TagId};

/// How many there are of something.
pub(super) struct Count {
    /// Whose sign it has.
    pub status: Option<Status>,
    pub word: String,
    pub number: usize,
}

/// What the card says.
#[derive(Default)]
pub(super) struct Card {
    pub status: Option<Status>,
    /// The word of the verdict, or that there is none; empty where only numbers are said.
    pub word: String,
    /// That nobody measured, where that is so.
    pub simulated: Option<String>,
    pub lines: Vec<String>,
    pub counts: Vec<Count>,
}

/// From the edge to the text.
const PAD: f32 = 13.0;
/// The height of the word.
const TALL: f32 = 34.0;
/// The height of a number.
const PITCH: f32 = 16.5;

impl Card {
    /// Draws it; gives its height.
    pub fn draw(&self, flow: &mut Flow<'_>, section: TagId, width: f32) -> f32 {
        let is_simulated = self.simulated.is_some();
        let tone = tone(self.status);
        let ink = if is_simulated { TEXT } else { tone.on };
        let styles = |at: usize| if at == 0 { CARD.in_ink(ink) } else { BODY.in_ink(ink) };
        let mut lines: Vec<(Style, Vec<String>)> = Vec::new();
        for (at, line) in self.lines.iter().enumerate() {
            lines.push((styles(at), flow.wrap(line, styles(at), width - 2.0 * PAD, 4)));
        }
        let mut height = 2.0 * PAD - 3.0;
        height += if is_simulated { 13.0 } else { 0.0 };
        height += if self.word.is_empty() { 0.0 } else { TALL };
        height += lines.iter().map(|(style, lines)| style.line() * super::cells::count(lines.len())).sum::<f32>();
        height += PITCH * super::cells::count(self.counts.len());
        let height = height.max(76.0);
        let area = Area::new(super::look::SIDE, flow.y, width, height);
        let edge = is_simulated.then_some(Edge { ink: TEXT, width: 1.4, is_dashed: true });
        let fill = if is_simulated { tone.pale } else { tone.ground };
        flow.put(None, Shape::Block { area, radius: RADIUS, fill: Some(fill), edge });
        let top = flow.y;
        let x = area.x + PAD;
        let mut y = top + PAD - 2.0;
        if let Some(simulated) = &self.simulated {
            let element = flow.tags.add(section, Kind::Paragraph);
            flow.say(Some(element), [x, base(y, 11.0, STRONG)], STRONG, simulated.clone());
            y += 13.0;
        }
        if !self.word.is_empty() {
            self.word(flow, section, [x, y], width - 2.0 * PAD, ink);
            y += TALL;
        }
        for (style, lines) in lines {
            let element = flow.tags.add(section, Kind::Paragraph);
            for line in lines {
                flow.say(Some(element), [x, base(y, style.line(), style)], style, line);
                y += style.line();
            }
        }
        self.counts(flow, section, [x, y]);
        height
    }

    /// Sign and word, as large as there is room.
    fn word(&self, flow: &mut Flow<'_>, section: TagId, [x, y]: [f32; 2], width: f32, ink: super::look::Ink) {
        let asked = flow.fonts.width(&self.word, WORD.weight, WORD.size);
        let free = width - 34.0;
        let size = (WORD.size * (free / asked.max(1.0)).min(1.0)).max(CARD.size);
        let style = Style { size, ink, ..WORD };
        let sign =
            Shape::Sign { sign: Sign::of(self.status), middle: [x + 12.0, y + TALL / 2.0 - 2.0], size: 27.0, ink };
        flow.put(None, sign);
        let element = flow.tags.add(section, Kind::Paragraph);
        flow.say(Some(element), [x + 32.0, base(y - 2.0, TALL, style)], style, self.word.clone());
    }

    fn counts(&self, flow: &mut Flow<'_>, section: TagId, [x, mut y]: [f32; 2]) {
        for Count { status, word, number } in &self.counts {
            if status.is_some() {
                let middle = [x + 7.0, y + PITCH / 2.0];
                flow.put(None, outline(*status, false, middle, 6.4));
                flow.put(None, Shape::Sign { sign: Sign::of(*status), middle, size: 8.0, ink: tone(*status).on });
            }
            let element = flow.tags.add(section, Kind::Paragraph);
            let at = base(y, PITCH, CARD);
            flow.say_to(Some(element), [x + 44.0, at], CARD, format!("{number} "));
            flow.say(Some(element), [x + 47.0, at], BODY, word.clone());
            y += PITCH;
        }
    }
}
