//! The picture of the part, and the balloons on it.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::part::{Column, FeatureStanding, HeadField, Plan, PlanFeature, Step as SizeStep, standings};
use fitcheck_core::verdict::Status;
use fitcheck_exchange::report::image::{Image, is_plain_name};

use super::PartsPage;

/// How far an arrow key moves a balloon: a two-hundredth of the picture.
pub(super) const NUDGE: f64 = 0.005;

/// A picture as dots.
#[derive(Clone, PartialEq, Eq)]
pub struct PartPicture {
    /// Width and height in dots.
    pub size: [usize; 2],
    /// Red, green, blue and opacity of every dot, from the top left.
    pub dots: Vec<u8>,
    /// Its file, for reports.
    pub file: Image,
}

impl fmt::Debug for PartPicture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "PartPicture({:?})", self.size)
    }
}

/// What became of the file that a plan names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PictureState {
    /// It is being read.
    Awaited,
    Seen(Arc<PartPicture>),
    /// Why there is none.
    Refused(Message),
}

/// The picture that the plan asks for.
#[derive(Debug, Clone, Default)]
pub(super) struct PlanPicture {
    /// Its file, and what became of it.
    asked: Option<(PathBuf, PictureState)>,
    /// The name cannot be that of a file beside the plan.
    refused: Option<Message>,
    /// The folder of a picture that was chosen before the plan had a file.
    folder: Option<PathBuf>,
}

/// The picture of the part that is measured: that of its plan as it was begun, whatever plan is opened meanwhile.
#[derive(Debug, Clone)]
pub(super) struct WalkPicture {
    plan: Arc<Plan>,
    shown: PlanPicture,
    /// How many plans had been opened.
    opened: u64,
}

impl PlanPicture {
    fn sight(&self) -> Option<PictureState> {
        let refused = self.refused.clone().map(PictureState::Refused);
        refused.or_else(|| self.asked.as_ref().map(|(_, sight)| sight.clone()))
    }

    fn read(&mut self, path: &Path, result: &Result<Arc<PartPicture>, Message>) {
        if let Some((asked, sight)) = &mut self.asked
            && asked == path
        {
            *sight = result.clone().map_or_else(PictureState::Refused, PictureState::Seen);
        }
    }
}

/// A balloon: a feature on the picture, or beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct Balloon {
    /// The row of the plan.
    pub row: usize,
    /// What is in it: the number of the feature, or its place.
    pub label: String,
    /// The feature's name.
    pub name: String,
    /// Where it is: shares of the picture's width and height; `None` beside the picture.
    pub at: Option<[f64; 2]>,
    /// What its values make of it, where all of them are there or one is bad.
    pub status: Option<Status>,
    /// Whether a value that counts was simulated.
    pub is_simulated: bool,
    /// Whether it was left out.
    pub is_skipped: bool,
    /// Whether it is measured next.
    pub is_next: bool,
    /// The place of its first size in the plan.
    pub first: Option<usize>,
}

impl PartsPage {
    /// What became of the picture of the plan that is edited; `None` where it names none.
    pub fn sight(&self) -> Option<PictureState> {
        self.shown.sight()
    }

    /// What became of the picture of the part that is measured; `None` where its plan names none.
    pub fn walk_sight(&self) -> Option<PictureState> {
        self.walk_picture.as_ref()?.shown.sight()
    }

    /// A part that was begun keeps the picture that its plan has now.
    pub(super) fn keep_picture(&mut self) {
        let of = self.walk_picture.as_ref().map(|kept| &kept.plan);
        match self.walking.plan.as_ref() {
            Some(plan) if of.is_some_and(|of| Arc::ptr_eq(of, plan)) => {}
            plan => {
                let kept = |plan| WalkPicture { plan, shown: self.shown.clone(), opened: self.document.opened };
                self.walk_picture = plan.map(Arc::clone).map(kept);
            }
        }
    }

    /// The picture's file, once it is known which one it is to be.
    pub(super) fn ask_for_picture(&mut self) -> Option<PathBuf> {
        let wanted = match self.document.draft().text(HeadField::Picture) {
            None => Ok(None),
            Some(name) if !is_plain_name(name) => Err(message!("parts-page-picture-folder").text("given", name)),
            Some(name) => {
                let folder = self.document.path().map(|path| path.parent().unwrap_or(Path::new("")).to_owned());
                let folder = folder.or_else(|| self.shown.folder.clone());
                folder.map(|folder| Some(folder.join(name))).ok_or_else(|| message!("parts-page-picture-unsaved"))
            }
        };
        let (wanted, refused) = match wanted {
            Ok(wanted) => (wanted, None),
            Err(why) => (None, Some(why)),
        };
        self.shown.refused = refused;
        if self.shown.asked.as_ref().map(|(path, _)| path) == wanted.as_ref() {
            return None;
        }
        self.shown.asked = wanted.clone().map(|path| (path, PictureState::Awaited));
        wanted
    }

    /// A picture was read, or not. An answer that comes too late is for another picture, and changes nothing.
    pub(super) fn picture_read(&mut self, path: &Path, result: &Result<Arc<PartPicture>, Message>) {
        let of_walk = self.walk_picture.as_mut().map(|kept| &mut kept.shown);
        for shown in std::iter::once(&mut self.shown).chain(of_walk) {
            shown.read(path, result);
        }
    }

    /// The name of a chosen picture, or why it cannot be the plan's: a plan and its picture are moved together.
    pub(super) fn choose_picture(&mut self, path: &Path) -> Result<String, Message> {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        match self.document.path() {
            Some(plan) if plan.parent().unwrap_or(Path::new("")) != folder => {
                Err(message!("parts-page-picture-elsewhere").text("given", path.display()))
            }
            Some(_) => Ok(name),
            None => {
                self.shown.folder = Some(folder);
                Ok(name)
            }
        }
    }

    /// The balloons of the plan that is edited. Verdicts are those of the part that was begun by it, of features with the same limits.
    pub fn balloons(&self) -> Vec<Balloon> {
        let is_its = self.walk_picture.as_ref().is_some_and(|kept| kept.opened == self.document.opened);
        let steps = if is_its { self.steps_by_name() } else { Vec::new() };
        let features = self.walking.plan.as_ref().into_iter().flat_map(|plan| plan.features());
        let steps: BTreeMap<&str, (&KnownFeature, &PlanFeature)> =
            steps.iter().zip(features).map(|(step, feature)| (step.name.as_str(), (step, feature))).collect();
        let rows = self.document.draft().rows.iter().enumerate();
        rows.map(|(row, cells)| {
            let name = cells.text(Column::Name).map_or_else(|| format!("F{}", row + 1), str::to_owned);
            let number = |column| cells.text(column)?.replace(',', ".").parse::<f64>().ok();
            let is_on = |share: &f64| (0.0..=1.0).contains(share);
            let at = number(Column::BalloonX).filter(is_on).zip(number(Column::BalloonY).filter(is_on));
            let label = cells.text(Column::Number).map_or_else(|| (row + 1).to_string(), str::to_owned);
            let is_same = |own: &PlanFeature| self.document.feature(row).is_some_and(|now| is_same(own, now));
            let step = steps.get(name.as_str()).filter(|(_, own)| is_same(own)).map(|(step, _)| step);
            step.map_or_else(|| Balloon::open(row, label.clone(), name.clone()), |step| step.balloon(row, &label))
                .at(at.map(|(x, y)| [x, y]))
        })
        .collect()
    }

    /// The balloons of the part that is measured.
    pub fn walk_balloons(&self) -> Vec<Balloon> {
        let Some(plan) = self.walking.plan.as_ref() else { return Vec::new() };
        let steps = self.steps_by_name();
        let features = plan.features().iter().enumerate();
        features
            .zip(steps)
            .map(|((row, feature), step)| {
                let number = Some(feature.number.clone()).filter(|number| !number.is_empty());
                let label = number.unwrap_or_else(|| (row + 1).to_string());
                step.balloon(row, &label).at(feature.balloon)
            })
            .collect()
    }

    /// What is known of every feature of the part that is measured, in the order of its plan.
    fn steps_by_name(&self) -> Vec<KnownFeature> {
        self.walking.plan.as_ref().map_or_else(Vec::new, |plan| known(plan, self.walking.walk.steps(), self.walking.at))
    }
}

/// Whether a verdict of one feature is one of the other.
fn is_same(one: &PlanFeature, other: &PlanFeature) -> bool {
    one.kind == other.kind && one.limits == other.limits && one.rule == other.rule
}

/// What the walk knows of a feature.
struct KnownFeature {
    name: String,
    standing: FeatureStanding,
    is_next: bool,
}

impl KnownFeature {
    fn balloon(&self, row: usize, label: &str) -> Balloon {
        Balloon {
            status: self.standing.status,
            is_simulated: self.standing.is_simulated,
            is_skipped: self.standing.is_skipped,
            is_next: self.is_next,
            first: Some(self.standing.first),
            ..Balloon::open(row, label.to_owned(), self.name.clone())
        }
    }
}

impl Balloon {
    const fn open(row: usize, label: String, name: String) -> Self {
        Self {
            row,
            label,
            name,
            at: None,
            status: None,
            is_simulated: false,
            is_skipped: false,
            is_next: false,
            first: None,
        }
    }

    fn at(self, at: Option<[f64; 2]>) -> Self {
        Self { at, ..self }
    }
}

fn known(plan: &Plan, steps: &[SizeStep], next: Option<usize>) -> Vec<KnownFeature> {
    let features = plan.features().iter().zip(standings(plan, steps));
    let known = features.map(|(feature, standing)| {
        let places = standing.first..standing.first + feature.limits.len();
        KnownFeature { name: feature.name.clone(), standing, is_next: next.is_some_and(|next| places.contains(&next)) }
    });
    known.collect()
}
