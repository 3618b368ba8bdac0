//! Whole parts: the plan of their features, and the walk through them.
//!
//! | file | what |
//! |---|---|
//! | `column` | what a plan says of a feature and of the part: the keys of its files |
//! | `draft` | a plan as it is written, right or wrong |
//! | `fault`, `spot` | what is wrong with a plan, and where |
//! | `check` | a draft becomes a plan, or all its faults are told at once |
//! | `values` | what single cells say: texts, materials, rules, travels |
//! | `plan` | a plan without a fault: features with limits |
//! | `kind`, `cells` | what is measured of a feature, and how cells say it |
//! | `plausible` | what a value of a size can be at all |
//! | `measured_by` | which cycle measures a feature, with which further parameters |
//! | `names` | what a value may be called: of one feature alone |
//! | `csv`, `file` | plans as CSV, and as TOML |
//! | `find` | which feature a value is of |
//! | `walk` | one part on its way through a plan |
//! | `taken` | a value of a size |
//! | `repeats` | which of several values of a size counts |
//! | `standing` | what that makes of each feature |
//! | `workpiece` | a plan as a simulated part |
//! | `simulated` | a feature measured by its cycle on it |
//!
//! A plan is the only list of features that there is: sets for a control, imports, the watched folder, the window and reports use it.
//! Nothing here knows where a value comes from.
//!
//! To add a key to the features of a plan:
//!
//! 1. Add a variant to [`Column`]: its key, `ALL` with its length, whether it is a number or any text.
//! 2. Add a field to [`PlanFeature`] and its check to `check`. [`PlanFault::Text`] has the longest text; another fault is a new variant.
//! 3. Add a row to `docs/PLANS.md`, and `parts-page-column-KEY` to `parts-page.ftl` in every folder of `assets/locales`.
//! 4. Add its line to the JSON of `fitcheck plan check` (`cli/plan/mod.rs`).
//! 5. Set the width of its column in `gui/parts/plan/grid.rs`, unless the usual one will do.
//!
//! Files both ways, the table in the window, paste and undo follow.

mod cells;
mod check;
pub mod column;
mod csv;
pub mod draft;
mod fault;
mod file;
mod find;
mod kind;
mod measured_by;
mod names;
mod plan;
mod plausible;
mod repeats;
mod simulated;
mod spot;
mod standing;
mod taken;
mod values;
mod walk;
mod workpiece;

pub use cells::{CellFault, KindCells};
pub use check::Review;
pub use column::{Column, HeadField};
pub use draft::{Draft, DraftCell, DraftFeature};
pub use fault::{PlanError, PlanFault, PlanRemark};
pub use find::{By, Clues, Finder, NotFound};
pub use kind::{Direction, FeatureKind, Towards, WidthAxis, band_text};
pub use plan::{DEFAULT_CLEARANCE, DEFAULT_CLEARANCE_HEIGHT, Head, MOST_FEATURES, Material, Plan, PlanFeature, Size};
pub use plausible::Plausible;
pub use repeats::Repeats;
pub use spot::{Finding, Spot};
pub use standing::{FeatureStanding, standings};
pub use taken::SizeValue;
pub use walk::{PartStanding, Step, Walk};

use crate::message::Located;
use crate::tolerance::Sources;

/// A plan as it was read: its draft, and what its file has that a draft has no place for.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Document {
    /// What could be read.
    pub draft: Draft,
    /// Unknown keys and columns, cells beyond the header, values of another kind: none of them is in the draft.
    pub problems: Vec<PlanError>,
    /// What was left out of it on purpose, and is no fault.
    pub remarks: Vec<Located<PlanRemark>>,
    /// How many comments its file has: a draft has no place for them.
    pub comments: usize,
}

impl Document {
    /// A draft that is from no file.
    pub fn of(draft: Draft) -> Self {
        Self { draft, ..Self::default() }
    }

    /// Reads a plan, as TOML or as CSV, whichever it is.
    ///
    /// ```
    /// use fitcheck_core::part::{Column, Document};
    ///
    /// let document = Document::read(b"name;callout;x;y;z\nA1;25 H7;40;30,5;-8\n")?;
    /// assert_eq!(document.draft.rows[0].text(Column::Callout), Some("25 H7"));
    /// # Ok::<(), fitcheck_core::part::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlanError`] where nothing of it can be read.
    pub fn read(bytes: &[u8]) -> Result<Self, PlanError> {
        if file::is_toml(bytes) { file::read(bytes) } else { csv::read(bytes) }
    }

    /// The same from rows of cells with their lines, such as those of a workbook; the first one names the columns.
    ///
    /// # Errors
    /// [`PlanError`] where no column is known.
    pub fn of_rows(rows: impl IntoIterator<Item = (usize, Vec<String>)>) -> Result<Self, PlanError> {
        csv::of_rows(rows)
    }

    /// Whether a file is a plan as TOML, or looks like one.
    pub fn is_own(bytes: &[u8]) -> bool {
        file::is_toml(bytes)
    }

    /// Whether a file says that it is a plan as TOML, by its first bytes.
    pub fn is_toml(head: &[u8]) -> bool {
        file::says_plan(head)
    }

    /// Everything that is wrong with it, by place: problems of the file, then those of its features.
    ///
    /// # Errors
    /// All of them, where there is any.
    pub fn plan(&self, sources: &Sources) -> Result<Plan, Vec<PlanError>> {
        let checked = Plan::of(&self.draft, sources);
        let faults = checked.as_ref().err().into_iter().flatten().cloned();
        let mut all: Vec<PlanError> = self.problems.clone();
        // Without its column no feature has a callout, and a file that is all wrong has no feature: one reason is enough.
        let is_without = |column: &str| {
            all.iter()
                .any(|problem| matches!(problem.what, PlanFault::NoColumn { column: missing } if missing == column))
        };
        let no_callouts = is_without("callout");
        let is_wrong = !all.is_empty();
        let counts = |finding: &Finding| match finding.what {
            PlanFault::NoCell { column: "callout" } => !no_callouts,
            PlanFault::NoFeatures => !is_wrong,
            _ => true,
        };
        all.extend(faults.filter(counts).map(|finding| finding.located(&self.draft)));
        all.sort_by_key(|error| (error.place.line, error.place.column));
        checked
            .map_err(|_findings| ())
            .and_then(|plan| if all.is_empty() { Ok(plan) } else { Err(()) })
            .map_err(|()| all)
    }
}

impl Draft {
    /// The plan as TOML: it reads back as the same draft.
    pub fn to_toml(&self) -> String {
        file::write(self)
    }

    /// The plan as CSV with semicolons: the features alone, every column that is used.
    pub fn to_csv(&self) -> String {
        csv::write(self)
    }
}
