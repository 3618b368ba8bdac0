//! Names of files and folders on a control, and other words that differ by generation.

use std::fmt;
use std::str::FromStr;

use fitcheck_core::probing::cycle::{Cycle, Note};
use fitcheck_core::tolerance::Feature;

use super::Target;
use super::called::Called;
use super::error::SetError;
use crate::control::table::Generation;
use crate::program::TextOperand;

/// A generation of controls that sets are written for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Control {
    /// iTNC 530, from NC software 340 49x-07 and 606 42x-02 (NC-Solutions, description of NC program 8255).
    Itnc530,
    /// TNC 320, TNC 620 and TNC 640.
    #[default]
    Tnc640,
    /// TNC7 and TNC7 basic.
    Tnc7,
}

impl Control {
    /// Every generation.
    pub const ALL: [Self; 3] = [Self::Itnc530, Self::Tnc640, Self::Tnc7];

    /// Whether it has the cycle that takes the tolerance of a diameter as a text.
    pub const fn takes_texts(self) -> bool {
        matches!(self, Self::Tnc7)
    }

    /// The name on the command line.
    pub const fn code(self) -> &'static str {
        match self {
            Self::Itnc530 => "itnc530",
            Self::Tnc640 => "tnc640",
            Self::Tnc7 => "tnc7",
        }
    }

    /// The control for a name on the command line; TNC 320 and TNC 620 use the same files as TNC 640.
    pub fn from_code(code: &str) -> Option<Self> {
        match code.to_ascii_lowercase().as_str() {
            "itnc530" => Some(Self::Itnc530),
            "tnc640" | "tnc620" | "tnc320" => Some(Self::Tnc640),
            "tnc7" => Some(Self::Tnc7),
            _ => None,
        }
    }

    /// The common name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Itnc530 => "iTNC 530",
            Self::Tnc640 => "TNC 620 / TNC 640",
            Self::Tnc7 => "TNC7",
        }
    }

    /// The usual folder of the files on the control.
    pub fn usual_folder(self) -> ControlFolder {
        ControlFolder(
            match self {
                Self::Itnc530 => r"TNC:\8255\",
                Self::Tnc640 | Self::Tnc7 => r"TNC:\nc_prog\fitcheck\",
            }
            .to_owned(),
        )
    }

    /// What the set-up clearance of a cycle is added to.
    pub const fn clearance(self) -> &'static str {
        match self {
            Self::Itnc530 => "MP6140",
            Self::Tnc640 | Self::Tnc7 => "SET_UP",
        }
    }

    /// Whether the nominal diameter of a cycle must lie between its limits (TNC7 manual 81762x-19, cycle 421).
    pub const fn wants_nominal_between_limits(self) -> bool {
        matches!(self, Self::Tnc7)
    }

    pub(super) fn has(self, cycle: &Cycle) -> bool {
        self != Self::Itnc530 || !cycle.notes.contains(&Note::NotOnItnc530)
    }

    /// The header of its tables.
    pub(super) const fn generation(self) -> Generation {
        match self {
            Self::Itnc530 => Generation::Structure,
            Self::Tnc640 | Self::Tnc7 => Generation::Description,
        }
    }
}

/// A folder on the control, such as `TNC:\nc_prog\fitcheck\`, for the files of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ControlFolder(String);

/// The most characters of a folder; the longest path in a program is 30 characters longer.
const LONGEST_FOLDER: usize = 80;

impl fmt::Display for ControlFolder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

impl FromStr for ControlFolder {
    type Err = SetError;

    /// Reads a folder below `TNC:\`; a `\` at the end may be left out. Blanks, `..` and signs other than letters,
    /// digits, `_` and `-` are errors: they end a path in a program, or lead elsewhere.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || SetError::Folder { folder: text.chars().take(LONGEST_FOLDER).collect() };
        let path = text.trim();
        let below = path.get(..4).filter(|drive| drive.eq_ignore_ascii_case("TNC:")).and_then(|_| path.get(4..));
        let below = below.and_then(|below| below.strip_prefix('\\')).ok_or_else(wrong)?;
        let below = below.strip_suffix('\\').unwrap_or(below);
        let is_name = |part: &str| {
            !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_-".contains(&byte))
        };
        let is_sound = (below.is_empty() || below.split('\\').all(is_name)) && path.len() <= LONGEST_FOLDER;
        let end = if below.is_empty() { "" } else { "\\" };
        if is_sound { Ok(Self(format!(r"TNC:\{below}{end}"))) } else { Err(wrong()) }
    }
}

/// The names of the files of a set.
#[derive(Debug, Clone)]
pub(super) struct Names<'a> {
    pub(super) target: &'a Target,
    pub(super) main: String,
    checks: [String; 5],
    masks: [String; 5],
    tables: [&'static str; 2],
    pub(super) readme: &'static str,
    /// Mask, protocol and table of a series.
    pub(super) series_mask: String,
    pub(super) protocol: &'static str,
    pub(super) series_table: &'static str,
}

/// The name for a kind of called program.
const fn of(called: Called, [diameter, width, face, rectangle, point]: &[String; 5]) -> &String {
    match called {
        Called::Diameter => diameter,
        Called::Width => width,
        Called::Face => face,
        Called::Rectangle => rectangle,
        Called::Point => point,
    }
}

impl<'a> Names<'a> {
    /// iTNC 530: as NC-Solution 8255. Later controls: a letter first and no operator, as TNC7 requires for names of
    /// tables (manual 81762x-19); the other files follow the same rule.
    pub(super) fn new(target: &'a Target) -> Self {
        let language = target.language;
        let ([main, hole, shaft], checks, masks) = match target.control {
            Control::Itnc530 => (
                ["8255_", "82553_hole.tab", "82553_shaft.tab"],
                ["82551_", "82551_width_", "82551_face_", "82551_rect_", "82551_point_"],
                ["82552_", "82552_width_", "82552_face_", "82552_rect_", "82552_point_"],
            ),
            Control::Tnc640 | Control::Tnc7 => {
                let checks = ["FIT_CHECK.H", "FIT_WIDTH.H", "FIT_FACE.H", "FIT_RECT.H", "FIT_POINT.H"];
                let masks = ["FIT_STATUS.A", "FIT_WIDTH.A", "FIT_FACE.A", "FIT_RECT.A", "FIT_POINT.A"];
                (["FIT_MAIN.H", "FIT_HOLE.TAB", "FIT_SHAFT.TAB"], checks, masks)
            }
        };
        let is_itnc = target.control == Control::Itnc530;
        let main = match target.parts {
            None => main,
            Some(_) if is_itnc => "8255_series_",
            Some(_) => "FIT_SERIES.H",
        };
        let series_mask = if is_itnc { "82552_series_" } else { "FIT_SERIES.A" };
        let full = |name: &str, ending: &str| {
            if name.ends_with('_') { format!("{name}{language}{ending}") } else { name.to_owned() }
        };
        Self {
            target,
            main: full(main, ".h"),
            checks: checks.map(|check| full(check, ".h")),
            masks: masks.map(|mask| full(mask, ".a")),
            tables: [hole, shaft],
            readme: &language.words().readme,
            series_mask: full(series_mask, ".a"),
            protocol: if is_itnc { "8255_series.txt" } else { "FIT_SERIES.TXT" },
            series_table: if is_itnc { "82553_series.tab" } else { "FIT_SERIES.TAB" },
        }
    }

    /// The program that measures a kind of feature.
    pub(super) const fn check(&self, called: Called) -> &String {
        of(called, &self.checks)
    }

    pub(super) const fn mask(&self, called: Called) -> &String {
        of(called, &self.masks)
    }

    /// The table of a kind of feature.
    pub(super) const fn table(&self, feature: Feature) -> &'static str {
        let [hole, shaft] = self.tables;
        match feature {
            Feature::Hole => hole,
            Feature::Shaft => shaft,
        }
    }

    /// The file that a feature's window is also printed to: one per feature, so that none replaces another.
    pub(super) fn result(&self, feature: &str) -> String {
        match self.target.control {
            Control::Itnc530 => format!("8255_{feature}.txt"),
            Control::Tnc640 | Control::Tnc7 => format!("FIT_{feature}.TXT"),
        }
    }

    /// A file's path on the control.
    pub(super) fn path(&self, file: &str) -> String {
        format!("{}{file}", self.target.folder)
    }

    /// The same path, as a block uses it.
    pub(super) fn operand(&self, file: &str) -> TextOperand {
        TextOperand::Text(self.path(file))
    }
}
