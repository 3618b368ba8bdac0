//! G functions and blocks of words without one.

use super::super::around::{Goes, PassedOver};
use super::super::block::Body;
use super::super::cursor::{Parsed, Stop};
use super::super::fault::BlockFault;
use super::super::movement::{Axis, Feed, Movement};
use super::frames;
use super::g_block::{ALL_AXES, Block};
use super::modes::{Measure, Modes};
use super::words::{Words, name};

/// Planes: each has its tool axis.
const PLANES: [(u32, Axis); 3] = [(17, Axis::Z), (18, Axis::Y), (19, Axis::X)];
/// Corrections of the tool radius, and what Klartext calls them.
const COMPENSATIONS: [(u32, &str); 3] = [(40, "R0"), (41, "RL"), (42, "RR")];

/// What a block says that consists of words.
pub(super) fn body(words: &Words<'_>, modes: &mut Modes) -> Parsed<Body> {
    let is_plane = |number| PLANES.iter().any(|(of, _)| *of == number);
    let is_compensation = |number| COMPENSATIONS.iter().any(|(of, _)| *of == number);
    let is_measure = |number| matches!(number, 90 | 91);
    let block = Block {
        words,
        main: words.one_of(|number| !is_plane(number) && !is_compensation(number) && !is_measure(number))?,
        plane: words.one_of(is_plane)?,
        compensation: words.one_of(is_compensation)?,
        measure: words.one_of(is_measure)?,
    };
    // In a path, and alone, G90 and G91 stay in force. Whether other functions change what is in force, and whether G91
    // counts for them, is on no page that we found.
    let is_path = block.main.is_none_or(|main| is_path(main.number));
    let stated = block.stated();
    let known = modes.measure.filter(|measure| is_path || *measure == Measure::Absolute);
    let mut inside = *modes;
    inside.measure = stated.or(known);
    let body = block.body(&mut inside)?;
    modes.path = inside.path;
    if is_path {
        modes.measure = inside.measure;
    } else if stated.is_some() && stated != modes.measure {
        modes.measure = None;
    }
    Ok(body)
}

const fn is_path(number: u32) -> bool {
    matches!(number, 0..=3 | 5..=7 | 10..=13 | 15 | 16)
}

const fn is_polar(number: u32) -> bool {
    matches!(number, 10..=16)
}

impl Block<'_, '_> {
    fn body(&self, modes: &mut Modes) -> Parsed<Body> {
        let Some(main) = self.main else { return self.without_main(modes) };
        if main.number != 30 && main.number != 31 {
            self.refuse(self.plane)?;
        }
        if !is_path(main.number) {
            self.refuse(self.compensation)?;
        }
        match main.number {
            number if is_path(number) => {
                modes.path = Some(number);
                self.path(number, name(number), modes)
            }
            // Chamfer and rounding: the next block has the end of the path.
            24 | 25 => self.passed_over("RFM", Goes::default()),
            // Approach and departure end beside the contour.
            26 | 27 => self.passed_over("RFM", Goes { is_unknown: true, axes: Vec::new() }),
            // Dwell, pole, spindle, next tool, tolerance, and the old definition of a tool.
            4 => self.passed_over("FSPHM", Goes::default()),
            29 => self.passed_over("FM", Goes::default()),
            // Where a cycle leaves the tool is the control's to know.
            79 => self.passed_over("FM", Goes { is_unknown: true, axes: Vec::new() }),
            36 | 62 => self.passed_over("STPHFM", Goes::default()),
            51 | 99 => self.passed_over("TLR", Goes::default()),
            // The blank.
            30 | 31 => self.passed_over(ALL_AXES, Goes::default()),
            38 => {
                self.words.only("M")?;
                Ok(Body::Stop(self.words.machine.clone()))
            }
            28 | 53 | 54 | 72 | 73 | 80 => frames::frame(self, main, modes).map(Body::Frame),
            // A program by cycle 12, and the probing cycle 0.
            39 | 55 => Err(Stop { at: main.at, reason: BlockFault::NoForm { found: name(main.number) } }),
            _ => Err(Stop { at: main.at, reason: BlockFault::UnknownWord { found: name(main.number) } }),
        }
    }

    fn without_main(&self, modes: &Modes) -> Parsed<Body> {
        let words = self.words;
        if !words.axes.is_empty() {
            self.refuse(self.plane)?;
            let path = modes.path.unwrap_or(2);
            return self.path(path, words.shown(), modes);
        }
        let has_speed = words.value("S").is_some();
        if self.plane.is_some() || words.tool.is_some() || has_speed && words.machine.is_empty() {
            return self.tool_call();
        }
        if modes.path.is_some_and(is_polar) && ["R", "H"].iter().any(|name| words.value(name).is_some()) {
            return self.path(modes.path.unwrap_or(10), words.shown(), modes);
        }
        words.only("FSIJKM")?;
        if !words.machine.is_empty() && words.has_only("M") {
            return Ok(Body::MachineFunctions(words.machine.clone()));
        }
        self.passed_over("FSIJKM", Goes::default())
    }

    /// `T5 G17 S2500 DL+0.2`; a plane alone sets the tool axis.
    fn tool_call(&self) -> Parsed<Body> {
        self.words.only("TSFD")?;
        let axis =
            self.plane.and_then(|plane| PLANES.iter().find(|(of, _)| *of == plane.number)).map(|(_, axis)| *axis);
        let rest: Vec<&str> = self.words.values.iter().map(|word| word.text).collect();
        Ok(Body::ToolCall { tool: self.words.tool.clone(), axis, rest: rest.join(" ") })
    }

    /// A path to the axes of the block.
    fn path(&self, number: u32, shown: String, modes: &Modes) -> Parsed<Body> {
        let axes = self.axes(modes)?;
        let words = self.words;
        if number < 2 {
            words.only(&format!("{ALL_AXES}FM"))?;
            let compensation =
                self.compensation.and_then(|of| COMPENSATIONS.iter().find(|(known, _)| *known == of.number));
            let feed = if number == 0 { Some(Feed::Rapid) } else { words.value("F").map(Feed::Value) };
            let compensation = compensation.map(|(_, word)| (*word).to_owned());
            return Ok(Body::Move(Movement { axes, compensation, feed, machine: words.machine.clone() }));
        }
        words.only(&format!("{ALL_AXES}IJKRHFM"))?;
        let goes = Goes { is_unknown: is_polar(number), axes };
        Ok(Body::PassedOver(PassedOver { words: shown, goes, machine: words.machine.clone() }))
    }

    fn passed_over(&self, letters: &str, goes: Goes) -> Parsed<Body> {
        self.words.only(letters)?;
        let shown = match self.words.functions.first() {
            Some(first) => name(self.main.map_or(first.number, |main| main.number)),
            None => self.words.shown(),
        };
        Ok(Body::PassedOver(PassedOver { words: shown, goes, machine: self.words.machine.clone() }))
    }
}
