//! What is asked of a study of a gauge, and how its values are understood before anything is computed.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_statistics::Sample;
use fitcheck_statistics::gauge::Finding;

use super::Series;
use super::layout::{Cells, Layout, StudyError, StudyKind, Understood};
use super::value::Value;
use super::wanted::Wanted;

/// A calibrated size in millimetres, of one part or of all.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    pub part: Option<String>,
    pub size: f64,
}

impl Reference {
    /// Reads `30.0012`, the size of every part, or `M1=30.0012`, that of one.
    ///
    /// # Errors
    /// A size that is none.
    pub fn read(text: &str) -> Result<Self, LengthError> {
        let (part, size) = match text.rsplit_once('=') {
            Some((part, size)) => (Some(part.trim().to_owned()), size),
            None => (None, text),
        };
        Ok(Self { part, size: size.parse::<Length>()?.to_mm_f64() })
    }
}

/// What is asked of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyWanted {
    pub kind: StudyKind,
    /// In a linearity study, nominal sizes are references where none is given.
    pub references: Vec<Reference>,
    /// The step of the display in millimetres.
    pub resolution: Option<f64>,
    /// Whether a layout that looks wrong is meant.
    pub is_confirmed: bool,
}

impl StudyWanted {
    /// A nominal size is that of a column of masters: in other studies a calibrated size must be given.
    pub(super) fn reference(&self, value: &Value) -> Option<f64> {
        let part = value.origin.whole_part();
        let named = self.references.iter().find(|one| one.part.as_ref().is_some_and(|name| *name == part));
        let given = named.or_else(|| self.references.iter().find(|one| one.part.is_none())).map(|one| one.size);
        let nominal = value.nominal.filter(|_| self.kind == StudyKind::Linearity);
        given.or_else(|| nominal.map(Length::to_mm_f64))
    }

    /// The references of values, each of which has one.
    pub(super) fn all_references(&self, values: &[&Value]) -> Result<Vec<f64>, StudyError> {
        let found: Vec<f64> = values.iter().filter_map(|value| self.reference(value)).collect();
        let count = values.len() - found.len();
        if count == 0 { Ok(found) } else { Err(StudyError::NoReference { count }) }
    }

    /// How values are understood, before anything is computed of them.
    ///
    /// # Errors
    /// Values that make no study.
    pub fn understood(&self, series: &Series<'_>, wanted: &Wanted) -> Result<Understood, StudyError> {
        let values = self.values(series, wanted);
        let mut understood = match self.kind {
            StudyKind::Type1 => one_master(&values, self.kind, (1, [values.len(); 2])),
            StudyKind::Crossed | StudyKind::Nested => Cells::of(&values, self.kind == StudyKind::Nested)?.understood,
            StudyKind::Linearity => {
                let layout = masters(&self.all_references(&values)?);
                Understood { layout, doubts: Vec::new(), faults: Vec::new() }
            }
            StudyKind::Stability => one_master(&values, self.kind, points(&wanted.samples(series))),
        };
        if self.kind == StudyKind::Type1 {
            understood.faults.extend(self.one_reference(&values).err());
        }
        Ok(understood)
    }

    /// The values that a study is made of.
    pub(super) fn values<'a>(&self, series: &Series<'a>, wanted: &Wanted) -> Vec<&'a Value> {
        match self.kind {
            StudyKind::Stability => series.counted.clone(),
            _ => series.counted_without(wanted),
        }
    }

    /// The one size of a master.
    pub(super) fn one_reference(&self, values: &[&Value]) -> Result<Option<f64>, StudyError> {
        let mut all = self.all_references(values)?;
        all.dedup();
        if 1 < all.len() { Err(StudyError::References) } else { Ok(all.first().copied()) }
    }
}

/// How many points a series has, and how many readings each: least and most.
pub(super) fn points(samples: &[Sample]) -> (usize, [usize; 2]) {
    let sizes = || samples.iter().map(|sample| sample.values.len());
    (samples.len(), [sizes().min().unwrap_or_default(), sizes().max().unwrap_or_default()])
}

/// How values of one master are understood; those of several look wrong.
pub(super) fn one_master(values: &[&Value], kind: StudyKind, (points, readings): (usize, [usize; 2])) -> Understood {
    let mut parts: Vec<String> = values.iter().map(|value| value.origin.whole_part()).collect();
    parts.sort_unstable();
    parts.dedup();
    let parts = parts.len();
    let doubts = (1 < parts).then_some(Finding::SeveralMasters { parts }).into_iter().collect();
    Understood { layout: Layout { kind, parts: points, operators: 1, readings }, doubts, faults: Vec::new() }
}

/// Masters by their calibrated sizes, one for each reading.
pub(super) fn masters(references: &[f64]) -> Layout {
    let mut sizes = references.to_vec();
    sizes.sort_by(f64::total_cmp);
    let counts: Vec<usize> = sizes.chunk_by(|one, other| one.total_cmp(other).is_eq()).map(<[f64]>::len).collect();
    let readings = [counts.iter().min(), counts.iter().max()].map(|count| count.copied().unwrap_or_default());
    Layout { kind: StudyKind::Linearity, parts: counts.len(), operators: 1, readings }
}
