//! Sets of files for a control to measure features itself: programs, tables, mask and a page of text.
//!
//! | file | what |
//! |---|---|
//! | `feature` | which features of a plan a control can measure |
//! | `called` | the cycle that measures each, and its parameters |
//! | `names` | names of files and folders, by generation of controls |
//! | `blocks` | what the programs share, block by block |
//! | `programs` | the main program |
//! | `series` | the main program of a series of parts: the next part, its row, its block of the protocol |
//! | `series_files` | the mask and the table of a series |
//! | `given` | features without a class: their limits stand in the main program |
//! | `check` | the called programs |
//! | `masks` | their masks |
//! | `tables` | the two tables: the 47 classes, and what else the plan needs |
//! | `readme` | the page that says where each file goes |
//! | `proof` | runs the set before it is handed over |
//! | `archive` | all of it as one zip file |
//! | `single` | a plan of one feature, of a callout and a place |
//! | `error` | why a plan or a set is impossible |
//!
//! Everything is made in memory; the caller decides where it goes. The differences between generations are in
//! `docs/SOURCES.md`, sets for a control.

mod archive;
mod blocks;
mod called;
mod check;
mod error;
mod feature;
mod given;
mod masks;
mod names;
mod programs;
mod proof;
mod readme;
mod series;
mod series_files;
mod single;
mod tables;

use std::collections::BTreeMap;

pub use error::{FeatureError, FeatureFault, ProofFault, SetError, SetRemark};
pub use names::{Control, ControlFolder};
pub use single::{SingleFault, single};

use super::program::Program;
use crate::control::mask::{Mask, MaskWarning, MaskWarningKind};
use called::Called;
use fitcheck_core::length::Length;
use fitcheck_core::message::Say as _;
use fitcheck_core::part::{Plan, PlanFeature};
use fitcheck_core::probing::cycle::Cycle;
use fitcheck_core::tolerance::{Callout, Feature, FigureWarning, Limits, Sources};
use fitcheck_core::words::Dialogue;
use names::Names;

/// Which control a set is for, and in which language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Target {
    /// The generation.
    pub control: Control,
    /// The language of comments, status words and mask.
    pub language: Dialogue,
    /// The folder for the files on the control, used by the paths in the programs.
    pub folder: ControlFolder,
    /// Whether diameters are measured by the cycle that takes the tolerance as a text, and judges by it. Only a TNC7 has that.
    pub by_text: bool,
    /// How many parts a series has room for; `None` for a set that measures a part alone.
    pub parts: Option<u16>,
}

/// The parts of a series where no number is given.
pub const USUAL_PARTS: u16 = 100;

/// The most parts of a series: the program reads the rows of all parts so far after each of them.
pub const MOST_PARTS: u16 = 1_000;

impl Target {
    /// A control with its usual folder, for a part alone.
    pub fn new(control: Control, language: Dialogue) -> Self {
        Self { control, language, folder: control.usual_folder(), by_text: false, parts: None }
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetFile {
    /// Its name, without folders.
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Everything that a control needs to measure a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NcSet {
    /// The files; all of them go into one folder. The main program comes first.
    pub files: Vec<SetFile>,
    /// What is worth knowing before it is used.
    pub remarks: Vec<SetRemark>,
}

/// A feature of a plan that a control can measure.
#[derive(Debug, Clone, Copy)]
struct Planned<'a> {
    feature: &'a PlanFeature,
    place: [Length; 3],
    /// One of every size, or that of a point about its nominal place.
    limits: &'a [Limits],
    /// Whether its cycle takes the tolerance as a text.
    by_text: bool,
}

impl Planned<'_> {
    /// The callout of every size with its limits; none of a point.
    fn sizes(&self) -> impl Iterator<Item = (Callout, &Limits)> {
        self.feature.kind.callouts().into_iter().zip(self.limits)
    }

    /// The cycle that measures it.
    fn cycle(&self) -> Option<&'static Cycle> {
        if self.by_text {
            return called::by_text();
        }
        Called::of(&self.feature.kind)?.cycle(self.limits.first()?.feature?)
    }
}

impl NcSet {
    /// Makes the files for a plan.
    ///
    /// ```
    /// use fitcheck_nc::sets::{Control, NcSet, Target};
    /// use fitcheck_core::part::Document;
    /// use fitcheck_core::tolerance::Sources;
    /// use fitcheck_core::words::Dialogue;
    ///
    /// let document = Document::read(b"callout;x;y;z\n25 H7;40;30;-8\n")?;
    /// let plan = document.plan(&Sources::default()).map_err(|mut faults| faults.remove(0))?;
    /// let set = NcSet::make(&plan, &Target::new(Control::Tnc7, Dialogue::En), &Sources::default())?;
    /// let names: Vec<_> = set.files.iter().map(|file| file.name.as_str()).collect();
    /// assert_eq!(names, ["FIT_MAIN.H", "FIT_CHECK.H", "FIT_STATUS.A", "FIT_HOLE.TAB", "FIT_SHAFT.TAB", "README.TXT"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SetError`] if a feature has no limits, or a table cannot hold what the plan needs. Nothing is left out, and no
    /// set is returned unless the machine runs it to the plan's limits.
    pub fn make(plan: &Plan, target: &Target, sources: &Sources) -> Result<Self, SetError> {
        let names = Names::new(target);
        if target.by_text && !target.control.takes_texts() {
            return Err(SetError::NoTexts { control: target.control.name() });
        }
        let planned: Vec<Planned<'_>> = feature::planned(plan, target)?;
        let mut remarks = Vec::new();
        let mut tables = Vec::new();
        for feature in [Feature::Hole, Feature::Shaft] {
            let (bytes, worth_knowing) = tables::table(feature, &planned, sources, &names)?;
            remarks.extend(worth_knowing);
            tables.push(SetFile { name: names.table(feature).to_owned(), bytes });
        }
        remarks.extend(plan.features().iter().filter_map(feature::by_hand));
        remarks.extend(planned.iter().filter_map(|planned| feature::unknown(planned.feature)));
        remarks.extend(figures(&planned, sources));
        remarks.extend(planned.iter().flat_map(|planned| programs::moved_nominals(*planned, target.control)));
        let main = match target.parts {
            Some(parts) => series::main(&names, &planned, parts)?,
            None => programs::main(&names, &planned),
        };
        let mut files = vec![SetFile { name: names.main.clone(), bytes: main }];
        for called in Called::ALL {
            // The program of diameters is in every set.
            let is_wanted = |planned: &Planned<'_>| Called::of(&planned.feature.kind) == Some(called);
            if called == Called::Diameter || planned.iter().any(is_wanted) {
                let has_given = planned.iter().filter(|planned| is_wanted(planned)).any(given::has_given);
                let bytes = check::check(&names, called, has_given);
                files.push(SetFile { name: names.check(called).clone(), bytes });
                files.push(SetFile { name: names.mask(called).clone(), bytes: masks::mask(target, called) });
            }
        }
        let series_table = match target.parts {
            Some(parts) => {
                files.push(SetFile { name: names.series_mask.clone(), bytes: series_files::mask(&names, &planned) });
                Some(SetFile {
                    name: names.series_table.to_owned(),
                    bytes: series_files::table(&names, &planned, parts)?,
                })
            }
            None => None,
        };
        check_programs(&files)?;
        files.extend(tables.into_iter().chain(series_table));
        proof::run(&files, &planned, &names)?;
        files.push(SetFile { name: names.readme.to_owned(), bytes: readme::page(&names, &planned, &remarks) });
        Ok(Self { files, remarks })
    }

    /// All files as one zip file, not compressed; the same set gives the same bytes.
    ///
    /// # Errors
    /// [`SetError::Archive`] with the message of the zip writer.
    pub fn zip(&self) -> Result<Vec<u8>, SetError> {
        archive::zip(&self.files)
    }
}

/// What to check about the figures behind the limits, once for each class and size step.
fn figures(planned: &[Planned<'_>], sources: &Sources) -> Vec<SetRemark> {
    let sizes = planned.iter().flat_map(Planned::sizes);
    let warnings = sizes.filter_map(|(callout, limits)| FigureWarning::of_limits(&callout, limits, sources));
    let once: BTreeMap<_, _> = warnings.map(|warning| (warning.cell(), warning)).collect();
    once.into_values().map(|warning| SetRemark::Figure { what: warning.message() }).collect()
}

/// The files must read back without a warning, or the control would not read them either.
fn check_programs(files: &[SetFile]) -> Result<(), SetError> {
    for file in files {
        let is_sound = if file.name.to_ascii_lowercase().ends_with(".a") {
            // The mask of NC-Solution 8255 has a line without a semicolon, and an iTNC 530 shows it.
            let is_sound = |warning: &MaskWarning| warning.what == MaskWarningKind::NoSemicolon;
            matches!(Mask::read(&file.bytes), Ok((_, warnings)) if warnings.iter().all(is_sound))
        } else {
            matches!(Program::read(&file.bytes), Ok((_, warnings)) if warnings.is_empty())
        };
        if !is_sound {
            return Err(SetError::ReadsOtherwise { file: file.name.clone() });
        }
    }
    Ok(())
}
