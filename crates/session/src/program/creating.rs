//! The files with which a control measures for itself: made of the callout of the check page, or of the plan on the parts page.
//!
//! They are made anew when something that they are made of has changed and this page is open. The other pages stay as they
//! are: what they have is handed in.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say, message};
use fitcheck_core::part::{Column, DEFAULT_CLEARANCE_HEIGHT, Plan};
use fitcheck_core::text::decode;
use fitcheck_core::tolerance::Sources;
use fitcheck_core::words::Dialogue;
use fitcheck_files::FileError;
use fitcheck_nc::sets::{Control, NcSet, SetError, Target, USUAL_PARTS, single};

use super::ProgramPage;
use crate::notice::Notice;
use crate::purpose::Purpose;
use crate::shared::Shared;

/// What a set is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetFrom {
    /// The callout of the check page, at its probe position.
    Callout,
    /// The plan on the parts page.
    Plan,
}

impl SetFrom {
    /// Both, in the order of the list.
    pub const ALL: [Self; 2] = [Self::Callout, Self::Plan];
}

/// The plan on the parts page.
#[derive(Debug, Clone)]
pub(crate) struct PlanForSet {
    /// Its file's name.
    pub name: String,
    /// How many features it has.
    pub features: usize,
    /// The plan; `None` where something is wrong with it.
    pub plan: Option<Arc<Plan>>,
}

impl PartialEq for PlanForSet {
    /// A changed plan is another one: nothing is compared feature by feature.
    fn eq(&self, other: &Self) -> bool {
        let same = match (&self.plan, &other.plan) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            (one, other) => one.is_none() && other.is_none(),
        };
        same && self.name == other.name && self.features == other.features
    }
}

/// What the other pages have for a set.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct ForSet {
    /// The callout of the check page; empty where none is typed.
    pub callout: String,
    /// Its probe position, as cells of a plan.
    pub position: Vec<(Column, String)>,
    pub plan: Option<PlanForSet>,
}

/// Everything that decides what is in a set.
#[derive(Debug, Clone)]
struct Asked {
    target: Target,
    from: SetFrom,
    given: ForSet,
    sources: Arc<Sources>,
}

impl PartialEq for Asked {
    fn eq(&self, other: &Self) -> bool {
        self.target == other.target
            && self.from == other.from
            && self.given == other.given
            && Arc::ptr_eq(&self.sources, &other.sources)
    }
}

/// The set as it would be written now.
#[derive(Debug, Default)]
pub struct Creating {
    pub control: Control,
    /// Whether it measures the parts of a series, one at each start.
    pub is_series: bool,
    /// Whether diameters are measured by the cycle that takes their tolerances as texts, where the control has it.
    pub by_text: bool,
    /// The name of the file whose content is shown.
    pub shown: Option<String>,
    /// The language of its comments and its window; `None` follows the window.
    language: Option<Dialogue>,
    /// What it is made of; `None` is the plan where one is open.
    from: Option<SetFrom>,
    asked: Option<Asked>,
    made: Option<Result<Arc<NcSet>, Vec<Message>>>,
    /// Counts how often it had to come into sight.
    looks: u64,
}

impl Creating {
    /// The set, or why there is none; `None` where there is nothing to make it of.
    pub fn made(&self) -> Option<Result<&Arc<NcSet>, &[Message]>> {
        self.made.as_ref().map(|made| made.as_ref().map_err(Vec::as_slice))
    }

    /// The set, where there is one.
    pub fn set(&self) -> Option<&Arc<NcSet>> {
        self.made()?.ok()
    }

    /// The file whose content is shown, and its text.
    pub fn shown(&self) -> Option<(&str, String)> {
        let shown = self.shown.as_ref()?;
        let file = self.set()?.files.iter().find(|file| file.name == *shown)?;
        Some((&file.name, decode(&file.bytes).replace('\r', "")))
    }

    /// The language of its comments and its window.
    pub fn language(&self) -> Option<Dialogue> {
        self.asked.as_ref().map(|asked| asked.target.language)
    }

    /// The folder that its programs expect it in, on the control.
    pub fn folder(&self) -> Option<String> {
        self.asked.as_ref().map(|asked| asked.target.folder.to_string())
    }

    /// What it is made of.
    pub fn from(&self) -> Option<SetFrom> {
        self.asked.as_ref().map(|asked| asked.from)
    }

    /// What can be chosen for that, with what each is now; the plan only where one is open.
    pub fn sources(&self) -> Vec<(SetFrom, Message)> {
        let Some(Asked { given, .. }) = &self.asked else { return Vec::new() };
        let callout = match given.callout.as_str() {
            "" => message!("program-page-create-no-callout"),
            callout => {
                let at = |column: Column| {
                    given.position.iter().find(|(of, _)| *of == column).map_or("", |(_, text)| text.trim())
                };
                let said = message!("program-page-create-callout").text("callout", callout);
                said.number("x", at(Column::X)).number("y", at(Column::Y)).number("z", at(Column::Z))
            }
        };
        let plan = given.plan.as_ref().map(|plan| {
            let said = message!("program-page-create-plan").text("name", &plan.name);
            (SetFrom::Plan, said.count("count", plan.features))
        });
        std::iter::once((SetFrom::Callout, callout)).chain(plan).collect()
    }

    /// How the set was proven, or is to be understood: one sentence each.
    pub fn said(&self) -> Vec<Message> {
        let (Some(Asked { from, given, .. }), Some(set)) = (&self.asked, self.set()) else { return Vec::new() };
        let proven = match from {
            SetFrom::Callout => message!("program-page-create-proven-callout").text("callout", &given.callout),
            SetFrom::Plan => message!("program-page-create-proven-plan"),
        };
        let height: Length = DEFAULT_CLEARANCE_HEIGHT;
        let height = (*from == SetFrom::Callout)
            .then(|| message!("program-page-create-clearance-height").number("height", height));
        std::iter::once(proven).chain(height).chain(set.remarks.iter().map(Say::message)).collect()
    }

    /// A number that changes when it has to come into sight.
    pub const fn looks(&self) -> u64 {
        self.looks
    }

    pub(super) const fn come_into_sight(&mut self) {
        self.looks = self.looks.wrapping_add(1);
    }

    pub(super) const fn choose_language(&mut self, language: Dialogue) {
        self.language = Some(language);
    }

    pub(super) const fn choose_source(&mut self, from: SetFrom) {
        self.from = Some(from);
    }
}

/// A set of one callout, or of a plan.
fn make(asked: &Asked) -> Option<Result<Arc<NcSet>, Vec<Message>>> {
    let Asked { target, from, given, sources } = asked;
    let plan = match (from, &given.plan) {
        (SetFrom::Plan, plan) => {
            let plan = plan.as_ref()?;
            match &plan.plan {
                Some(plan) => Ok(Arc::clone(plan)),
                None => Err(vec![message!("program-page-create-plan-wrong").text("name", &plan.name)]),
            }
        }
        (SetFrom::Callout, _) if given.callout.is_empty() => return None,
        (SetFrom::Callout, _) => match single(&given.callout, &given.position) {
            Ok(document) => document.plan(sources).map(Arc::new).map_err(|faults| messages(&faults)),
            Err(fault) => Err(vec![fault.message()]),
        },
    };
    Some(plan.and_then(|plan| NcSet::make(&plan, target, sources).map(Arc::new).map_err(refused)))
}

fn messages<T: Say>(errors: &[T]) -> Vec<Message> {
    errors.iter().map(Say::message).collect()
}

/// Every reason by itself.
fn refused(error: SetError) -> Vec<Message> {
    match error {
        SetError::Features { first, others } => std::iter::once(first.message()).chain(messages(&others)).collect(),
        error => vec![error.message()],
    }
}

impl ProgramPage {
    /// Makes the set anew where something that it is made of has changed.
    pub(crate) fn make_set(&mut self, given: ForSet, shared: &Shared) {
        let creating = &mut self.creating;
        let language = creating.language.unwrap_or_else(|| shared.language.dialogue());
        let has_plan = given.plan.is_some();
        let usual = if has_plan { SetFrom::Plan } else { SetFrom::Callout };
        // A plan that was chosen may be closed again.
        let from = creating.from.filter(|from| has_plan || *from == SetFrom::Callout).unwrap_or(usual);
        let target = Target {
            parts: creating.is_series.then_some(USUAL_PARTS),
            by_text: creating.by_text && creating.control.takes_texts(),
            ..Target::new(creating.control, language)
        };
        let asked = Asked { target, from, given, sources: Arc::clone(&shared.sources) };
        if creating.asked.as_ref() != Some(&asked) {
            creating.made = make(&asked);
            creating.asked = Some(asked);
        }
    }
}

/// The files of a set were written, or not: what is told of it.
pub(crate) fn written(set: &[PathBuf], folder: &std::path::Path) -> Notice {
    let name = |path: &PathBuf| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let names: Vec<_> = set.iter().map(name).collect();
    let message = message!("program-page-create-written").count("count", set.len());
    let message = message.text("folder", folder.display()).text("names", names.join(", "));
    // Its first file is the main program.
    Notice { file: set.first().cloned(), opens: Some(Purpose::OpenProgram), ..Notice::of(message, false) }
}

/// Why they were not: a file of that name stands where the folder is to be.
pub(crate) fn no_folder(error: &FileError, folder: &std::path::Path) -> Option<Message> {
    match error {
        FileError::Exists { path } if path == folder => {
            Some(message!("program-page-create-no-folder").text("name", folder.display()))
        }
        _ => None,
    }
}
