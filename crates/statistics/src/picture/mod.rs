//! Charts as drawings: marks with places and tones, for a window, a page and a file alike.
//!
//! | file | what |
//! |---|---|
//! | `scale` | values to places, and the values that an axis names |
//! | `plot` | the ground of a chart: its axes, lines and labels |
//! | `run` | values or means, and their spread, in their order |
//! | `memory` | averages or sums that remember |
//! | `histogram` | how often values are, beside the curve of a law |
//! | `probability` | values against the shares of a law |
//! | `sheet` | all charts of a series together |
//! | `svg` | a drawing as SVG |
//!
//! Places are in points of a screen at its normal size, from the upper left corner. Lengths are shown in micrometres from a base, which
//! is the nominal size where there is one. A drawing of a million values has as many marks as one of a thousand: of the
//! values that share a place, the least and the greatest are drawn.

mod histogram;
mod memory;
mod plot;
mod probability;
mod run;
mod scale;
mod sheet;
mod svg;

use std::ops::Range;

use fitcheck_core::words::Words;
pub use histogram::histogram;
pub use memory::memory_chart;
pub use probability::probability_plot;
pub use run::{run_chart, spread_chart, value_range};
pub use sheet::sheet;
pub use svg::svg;

/// What a mark stands for; whoever draws it has a colour for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// Words that are read first.
    Text,
    /// Other words.
    Quiet,
    /// The ground of a chart.
    Ground,
    /// The lines of an axis.
    Grid,
    /// Values.
    Data,
    /// Bars of a histogram.
    Bar,
    /// The centre line.
    Centre,
    /// Control limits.
    Control,
    /// Limits of size.
    Limit,
    /// What is between them.
    Zone,
    /// Behind the points at which a rule fires.
    Signal,
    /// Points that are left out.
    LeftOut,
    /// The curve of a law.
    Law,
    /// How far the curve may be off.
    Band,
}

/// Where a text stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// To the right of it.
    Start,
    /// On both sides.
    Middle,
    /// To the left of it.
    End,
}

/// Something that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A filled rectangle.
    Area {
        /// Its upper left corner.
        from: [f64; 2],
        /// Its lower right corner.
        to: [f64; 2],
        /// What it stands for.
        tone: Tone,
    },
    /// A filled outline.
    Shape {
        /// Its corners.
        points: Vec<[f64; 2]>,
        /// What it stands for.
        tone: Tone,
    },
    /// A line through points.
    Line {
        /// The points.
        points: Vec<[f64; 2]>,
        /// What it stands for.
        tone: Tone,
        /// How wide it is.
        width: f64,
        /// Whether it is dashed.
        is_dashed: bool,
    },
    /// A filled dot.
    Dot {
        /// Its centre.
        at: [f64; 2],
        /// How large it is.
        radius: f64,
        /// What it stands for.
        tone: Tone,
    },
    /// A circle.
    Ring {
        /// Its centre.
        at: [f64; 2],
        /// How large it is.
        radius: f64,
        /// What it stands for.
        tone: Tone,
    },
    /// Words, their middle at the height of the place.
    Text {
        /// The place.
        at: [f64; 2],
        /// Where they stand at it.
        anchor: Anchor,
        /// Whether they are bold.
        is_bold: bool,
        /// What they stand for.
        tone: Tone,
        /// The words.
        text: String,
    },
}

/// The height of all words.
pub const TEXT_SIZE: f64 = 12.0;

/// Where a value or point of a chart is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Its number, from 0.
    pub number: usize,
    /// Its place.
    pub at: [f64; 2],
}

/// A drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// How wide and how high it is.
    pub size: [f64; 2],
    /// What is drawn, in this order.
    pub marks: Vec<Mark>,
    /// Points that can be pointed at, from left to right.
    pub spots: Vec<Spot>,
}

/// What of a series is drawn, and how.
#[derive(Debug, Clone)]
pub struct View<'a> {
    /// How wide and how high the drawing is; below 160 × 100 there is no room for it, and it stays empty.
    pub size: [f64; 2],
    /// The points that are shown, from 0.
    pub points: Range<usize>,
    /// The least and the greatest value that has room, in millimetres.
    pub values: [f64; 2],
    /// What lengths are counted from, in millimetres.
    pub base: f64,
    /// The language.
    pub words: &'a Words,
}

impl Picture {
    fn line(&mut self, points: Vec<[f64; 2]>, tone: Tone, width: f64) {
        self.marks.push(Mark::Line { points, tone, width, is_dashed: false });
    }

    fn dashed(&mut self, points: Vec<[f64; 2]>, tone: Tone, width: f64) {
        self.marks.push(Mark::Line { points, tone, width, is_dashed: true });
    }

    fn area(&mut self, from: [f64; 2], to: [f64; 2], tone: Tone) {
        self.marks.push(Mark::Area { from, to, tone });
    }

    fn dot(&mut self, at: [f64; 2], radius: f64, tone: Tone) {
        self.marks.push(Mark::Dot { at, radius, tone });
    }

    fn ring(&mut self, at: [f64; 2], radius: f64, tone: Tone) {
        self.marks.push(Mark::Ring { at, radius, tone });
    }

    fn text(&mut self, at: [f64; 2], anchor: Anchor, tone: Tone, text: String) {
        self.marks.push(Mark::Text { at, anchor, is_bold: false, tone, text });
    }

    fn bold(&mut self, at: [f64; 2], anchor: Anchor, tone: Tone, text: String) {
        self.marks.push(Mark::Text { at, anchor, is_bold: true, tone, text });
    }
}
