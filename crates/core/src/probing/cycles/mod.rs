//! The measuring cycles.
//!
//! | file | cycle |
//! |---|---|
//! | `circle_cycle` | what 421 and 422 share |
//! | `circle_datum_cycle` | what 412 and 413 share |
//! | `circle_probing` | the contacts of a circle, for these four |
//! | `rectangle_cycle` | what 423 and 424 share |
//! | `rectangle_datum_cycle` | what 410 and 411 share |
//! | `line_probing` | the contacts of a line, and its angle, for 400, 403 and 420 |
//! | `walls_probing` | the contacts of walls about a centre |
//! | `width_cycle` | what 425 and 426 share |
//! | `width_datum_cycle` | what 408 and 409 share |
//! | `datum_cycle` | what all cycles share that set a datum |
//! | `nominal_cycle` | what cycles 14xx share |
//! | `two_points` | what 1410 and 1411 share |
//! | `edge_probing` | the points of 1400 and 1410 |
//! | `round` | the circle through contacts |
//! | `sphere` | the sphere through contacts |
//! | `judged` | sizes and centres against their limits |
//! | `probed` | the clearance before a surface, the point where the ball met the surface, and along which axis |
//! | `c400` | 400, basic rotation |
//! | `c403` | 403, rotation in a rotary axis |
//! | `c408` | 408, datum at the centre line of a slot |
//! | `c409` | 409, datum at the centre line of a ridge |
//! | `c410` | 410, datum at the centre of a pocket |
//! | `c411` | 411, datum at the centre of a boss |
//! | `c412` | 412, datum at the centre of a hole |
//! | `c413` | 413, datum at the centre of a stud |
//! | `c417` | 417, datum in the probe axis |
//! | `c419` | 419, datum in one axis |
//! | `c420` | 420, measure angle |
//! | `c421` | 421, measure hole |
//! | `c422` | 422, measure circle outside |
//! | `c423` | 423, measure rectangle inside |
//! | `c424` | 424, measure rectangle outside |
//! | `c425` | 425, measure inside width |
//! | `c426` | 426, measure ridge width |
//! | `c427` | 427, measure coordinate |
//! | `c444` | 444, probing in 3-D |
//! | `g785` | G785 of lathe controls, circle measurement |
//! | `c1400` | 1400, position probing |
//! | `c1401` | 1401, circle probing |
//! | `c1402` | 1402, sphere probing |
//! | `c1410` | 1410, probing on edge |
//! | `c1411` | 1411, probing two circles |
//!
//! To add a cycle:
//!
//! 1. Write a file with its declaration `CYCLE`. Add its `mod` line, its line in [`CYCLES`] and its row above.
//! 2. Add its texts: the names of new results in `assets/locales`; the title of its log and new figures in `assets/logs`; a mask in
//!    `assets/masks` if it has one of its own. Tests name every missing text.
//! 3. Draw in `gui/cycles/picture` what no cycle has yet: a meaning (`probing/cycle/meaning.rs`) or a shape.
//! 4. Name the cycle in the documents (the test `promises` says where), its log in `docs/manual/formats.md`, `CHANGELOG.md` and `docs/SOURCES.md`.
//! 5. Add its calls to the corpus and record the answers (`tests/core/corpus.rs`).
//!
//! Everything else follows from the declaration:
//!
//! | part of the declaration | what follows |
//! |---|---|
//! | parameters: number, name, unit, range, default | range errors, the form of the page, NC blocks both ways, `--list`, values read |
//! | meanings of the parameters | drawings and sentences |
//! | `surface` | the nominal workpiece, the picture of the path |
//! | `log` | the measuring log, written and read |
//! | `window` | the mask of the status window |
//! | `corrects` | the correction of the tool of Q330 |
//! | `Measured::datum` | where the zero of NC programs is from there on |
//! | `Measured::rotation` | how their system is turned from there on |

mod c1400;
mod c1401;
mod c1402;
mod c1410;
mod c1411;
mod c400;
mod c403;
mod c408;
mod c409;
mod c410;
mod c411;
mod c412;
mod c413;
mod c417;
mod c419;
mod c420;
mod c421;
mod c422;
mod c423;
mod c424;
mod c425;
mod c426;
mod c427;
mod c444;
mod circle_cycle;
mod circle_datum_cycle;
mod circle_probing;
mod datum_cycle;
mod edge_probing;
mod g785;
mod judged;
mod line_probing;
mod nominal_cycle;
mod probed;
mod rectangle_cycle;
mod rectangle_datum_cycle;
mod round;
mod sphere;
mod two_points;
mod walls_probing;
mod width_cycle;
mod width_datum_cycle;

use super::cycle::{Control, Cycle};
use crate::tolerance::Feature;

/// All cycles: those that judge by number, then 420, which judges nothing, then those that set a datum or a rotation, then those with nominal
/// values as texts.
pub const CYCLES: &[&Cycle] = &[
    &c421::CYCLE,
    &c422::CYCLE,
    &c423::CYCLE,
    &c424::CYCLE,
    &c425::CYCLE,
    &c426::CYCLE,
    &c427::CYCLE,
    &c444::CYCLE,
    &g785::CYCLE,
    &c420::CYCLE,
    &c400::CYCLE,
    &c403::CYCLE,
    &c408::CYCLE,
    &c409::CYCLE,
    &c410::CYCLE,
    &c411::CYCLE,
    &c412::CYCLE,
    &c413::CYCLE,
    &c417::CYCLE,
    &c419::CYCLE,
    &c1400::CYCLE,
    &c1401::CYCLE,
    &c1402::CYCLE,
    &c1410::CYCLE,
    &c1411::CYCLE,
];

/// The cycle that measures a hole, or the one that measures a shaft.
pub const fn measuring(feature: Feature) -> &'static Cycle {
    match feature {
        Feature::Hole => &c421::CYCLE,
        Feature::Shaft => &c422::CYCLE,
    }
}

/// The cycles of a control.
pub fn cycles_of(control: Control) -> impl Iterator<Item = &'static Cycle> {
    CYCLES.iter().copied().filter(move |cycle| cycle.control == control)
}

/// Those of them that measure a feature and judge it by limits of their own.
pub fn measuring_cycles_of(control: Control) -> impl Iterator<Item = &'static Cycle> {
    cycles_of(control).filter(|cycle| cycle.judges() && !cycle.takes_nominals())
}

/// A cycle by its number.
pub fn cycle(number: u16) -> Option<&'static Cycle> {
    CYCLES.iter().copied().find(|cycle| cycle.number == number)
}

/// A cycle by the name that people type: `421`, `G421`, `g785`.
pub fn cycle_named(name: &str) -> Option<&'static Cycle> {
    let bare = name.trim().trim_start_matches(['G', 'g']);
    CYCLES.iter().copied().find(|cycle| cycle.code.trim_start_matches('G') == bare)
}
