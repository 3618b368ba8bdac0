//! Paths as programs write them: `TNC:\fit\a.h`, `..\b.tab`, `b.tab`. No path can lead above the root.

use std::fmt;
use std::sync::Arc;

use fitcheck_core::message::{Say, as_text};
use fitcheck_core::text::until;

/// The drive of programs on these controls; others are not followed.
const DRIVE: &str = "TNC:";

/// The most characters of a path with drive, folders and file name: as on TNC 640 (`docs/SOURCES.md`, Klartext).
const LONGEST: usize = 255;

/// Names that some systems treat as devices, with any ending.
const DEVICES: [&str; 6] = ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"];

/// A path of the control from its root, without `.` and `..`: at least a file name.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NcPath(Arc<str>);

as_text!(NcPath);

/// Why a path is not followed.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "machine-path", error)]
pub enum PathError {
    Empty,
    /// Longer than a control takes.
    TooLong {
        /// What is allowed.
        most: usize,
    },
    /// Another drive, a network path, or a path from the root of the system.
    OtherRoot {
        /// What was given.
        path: String,
    },
    /// More `..` than folders.
    LeadsOut {
        /// What was given.
        path: String,
    },
    /// A device of the system, or a name that no file can have on every system.
    NoName {
        /// The part that is not a name.
        name: String,
        /// What was given.
        path: String,
    },
}

impl NcPath {
    /// A path from the root: `TNC:\fit\a.h`, or without its drive.
    ///
    /// ```
    /// use fitcheck_nc::machine::NcPath;
    ///
    /// let main = NcPath::new(r"TNC:\fit\main.h")?;
    /// assert_eq!(main.resolve(r"..\tables\own.tab")?.to_string(), r"TNC:\tables\own.tab");
    /// assert!(main.resolve(r"..\..\own.tab").is_err());
    /// # Ok::<(), fitcheck_nc::machine::PathError>(())
    /// ```
    ///
    /// # Errors
    /// [`PathError`] for a path that is not followed.
    pub fn new(path: &str) -> Result<Self, PathError> {
        normalised(path, &[])
    }

    /// The path of a program that a user has named: if it is not a path of a control, only the file name counts.
    pub fn of_file(path: &str) -> Self {
        let name = path.rsplit_once(['/', '\\']).map_or(path, |(_, name)| name);
        Self::new(path).or_else(|_outside| Self::new(name)).unwrap_or_else(|_no_name| Self("program.h".into()))
    }

    /// A path as a program at this path writes it.
    ///
    /// # Errors
    /// [`PathError`] for a path that is not followed.
    pub fn resolve(&self, path: &str) -> Result<Self, PathError> {
        let mut folder: Vec<&str> = self.parts().collect();
        folder.pop();
        normalised(path, &folder)
    }

    /// A path on another device as one below the root: `RS232:\PRO1.A`, `PC325:\LOG\PRO1.TXT`, `\\server\share\PRO1.TXT`, `PRT:`. `None`
    /// where a part of it is no name, or leads out.
    ///
    /// ```
    /// use fitcheck_nc::machine::NcPath;
    ///
    /// assert_eq!(NcPath::tamed(r"PC325:\LOG\PRO1.TXT").unwrap().to_string(), r"TNC:\PC325\LOG\PRO1.TXT");
    /// assert_eq!(NcPath::tamed("PRT:").unwrap().to_string(), r"TNC:\PRT.TXT");
    /// assert_eq!(NcPath::tamed(r"PC325:\..\PRO1.TXT"), None);
    /// ```
    pub fn tamed(path: &str) -> Option<Self> {
        let parts: Vec<&str> = path.trim().split(['\\', '/', ':']).filter(|part| !part.is_empty()).collect();
        match parts.as_slice() {
            [] => None,
            parts if parts.iter().any(|part| matches!(*part, "." | "..")) => None,
            [device] => Self::new(&format!("{DRIVE}\\{device}.TXT")).ok(),
            parts => Self::new(&format!("{DRIVE}\\{}", parts.join("\\"))).ok(),
        }
    }

    /// Folders and file name, from the root.
    pub fn parts(&self) -> impl DoubleEndedIterator<Item = &str> {
        self.0.split('\\')
    }

    /// The last part.
    pub fn file_name(&self) -> &str {
        self.0.rsplit_once('\\').map_or(&self.0, |(_, name)| name)
    }
}

impl fmt::Display for NcPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{DRIVE}\\{}", self.0))
    }
}

fn normalised(given: &str, folder: &[&str]) -> Result<NcPath, PathError> {
    let path = given.trim();
    if LONGEST < path.chars().count() {
        return Err(PathError::TooLong { most: LONGEST });
    }
    if path.is_empty() {
        return Err(PathError::Empty);
    }
    let drive = path.split_at_checked(DRIVE.len()).filter(|(drive, _)| drive.eq_ignore_ascii_case(DRIVE));
    let (rest, folder) = match drive {
        Some((_, rest)) => (rest.trim_start_matches(['\\', '/']), &[][..]),
        None if path.starts_with(['\\', '/']) || path.contains(':') => {
            return Err(PathError::OtherRoot { path: path.to_owned() });
        }
        None => (path, folder),
    };
    let mut parts = folder.to_vec();
    for part in rest.split(['\\', '/']) {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop().ok_or_else(|| PathError::LeadsOut { path: path.to_owned() })?;
            }
            name if is_name(name) => parts.push(name),
            name => return Err(PathError::NoName { name: name.escape_debug().collect(), path: path.to_owned() }),
        }
    }
    // A path that ends in a folder has no file name.
    if parts.is_empty() || rest.ends_with(['\\', '/', '.']) {
        return Err(PathError::Empty);
    }
    let path = NcPath(parts.join("\\").into());
    // Short in the block, but far below the root.
    if LONGEST < DRIVE.len() + 1 + path.0.chars().count() {
        return Err(PathError::TooLong { most: LONGEST });
    }
    Ok(path)
}

/// Whether every system accepts this as a file name.
fn is_name(name: &str) -> bool {
    let stem = until(name, '.').trim_end();
    let numbered = |device: &str| {
        stem.get(..3).is_some_and(|start| start.eq_ignore_ascii_case(device)) && stem.chars().count() == 4
    };
    let is_device = DEVICES.iter().any(|device| stem.eq_ignore_ascii_case(device))
        || ((numbered("COM") || numbered("LPT")) && !stem.ends_with(|c: char| c.is_ascii_alphabetic()));
    let is_sound = name.chars().all(|c| !c.is_control() && !":*?\"<>|".contains(c));
    is_sound && !is_device && !name.ends_with(['.', ' '])
}
