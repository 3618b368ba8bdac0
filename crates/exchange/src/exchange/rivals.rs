//! Which of several columns is the measured value, the nominal size, the callout.
//!
//! A name that is known whole wins over no other column that may be the same: `measured` beside `measured after honing` is asked about.
//! A nominal size or a callout that stands twice must say the same in both columns.

use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Callout, ToleranceClass};

use super::cells::{is_callout, is_class, is_number};
use super::column::{several, unit_of};
use super::error::ImportErrorKind;
use super::role::Role;
use super::sample::Sample;
use super::vocabulary::Rank;
use super::words;
use crate::exchange::cell::Cells as _;

/// What the names of a header say of the columns.
pub(super) type Roles = [Option<(Role, Rank)>];

/// The column of a role by its name, the surest names first.
pub(super) fn best(
    header: &StringRecord,
    roles: &Roles,
    role: Role,
    ranks: &[Rank],
) -> Result<Option<usize>, ImportErrorKind> {
    for rank in ranks {
        let found: Vec<usize> =
            (0..).zip(roles).filter(|(_, r)| **r == Some((role, *rank))).map(|(at, _)| at).collect();
        match found.as_slice() {
            [] => {}
            [at] => return Ok(Some(*at)),
            _ => return Err(several(role, header, &found)),
        }
    }
    Ok(None)
}

/// The columns that decide.
#[derive(Clone, Copy)]
pub(super) struct Chosen {
    pub(super) measured: usize,
    pub(super) tolerance: Option<usize>,
    pub(super) nominal: Option<usize>,
}

/// The columns of a role with a rank.
fn of(roles: &Roles, role: Role, ranks: &[Rank]) -> Vec<usize> {
    let is = |found: &Option<(Role, Rank)>| found.is_some_and(|(of, rank)| of == role && ranks.contains(&rank));
    (0..).zip(roles).filter(|(_, found)| is(found)).map(|(at, _)| at).collect()
}

impl Sample {
    /// The columns that decide, by their names and by what is in them.
    ///
    /// # Errors
    /// Where another column may be meant.
    pub(super) fn chosen(&self, header: &StringRecord, roles: &Roles) -> Result<Chosen, ImportErrorKind> {
        let sure = [Rank::Exact, Rank::Contained];
        let measured = match self.measured {
            Some(at) => Some(at),
            None => Self::measured_value(header, roles)?,
        };
        let is_counted = measured.is_none() && of(roles, Role::Measured, &[Rank::Weak, Rank::Unsure]).is_empty();
        let samples = if is_counted { self.side_by_side(header) } else { Vec::new() };
        let measured = measured.or_else(|| samples.first().copied()).or_else(|| self.results(header, roles));
        let tolerance = best(header, roles, Role::Tolerance, &[Rank::Exact, Rank::Contained, Rank::Weak])?;
        let mut nominal = best(header, roles, Role::Nominal, &sure)?;
        // "diameter" is the measured value where no other column is; otherwise it may be the nominal size.
        if !samples.is_empty()
            && let Some(measured) = measured
        {
            return Ok(Chosen { measured, tolerance, nominal });
        }
        let Some(measured) = measured else {
            let unsure = of(roles, Role::Measured, &[Rank::Unsure]);
            let measured = best(header, roles, Role::Measured, &[Rank::Weak])?;
            let measured = measured.ok_or(ImportErrorKind::NoMeasuredColumn)?;
            if !unsure.is_empty() {
                return Err(several(Role::Measured, header, &[&[measured], unsure.as_slice()].concat()));
            }
            return Ok(Chosen { measured, tolerance, nominal });
        };
        let has_class = tolerance.is_some_and(|at| self.mostly(at, is_class));
        if nominal.is_none() && has_class {
            nominal = best(header, roles, Role::Measured, &[Rank::Weak])?.filter(|at| *at != measured);
        }
        let chosen = Chosen { measured, tolerance, nominal };
        self.no_rival(header, roles, chosen)
    }

    /// A column of results, which are numbers where they are measured values, and words where they are a status.
    fn results(&self, header: &StringRecord, roles: &Roles) -> Option<usize> {
        let has_sizes = roles.iter().flatten().any(|(role, _)| *role == Role::Measured);
        let is_one = |at: &usize| header.get(*at).is_some_and(words::may_be_results) && self.mostly(*at, is_number);
        let mut found = (0..header.len()).filter(is_one);
        let first = found.next().filter(|_| !has_sizes)?;
        found.next().is_none().then_some(first)
    }

    /// The column of measured values by its name.
    fn measured_value(header: &StringRecord, roles: &Roles) -> Result<Option<usize>, ImportErrorKind> {
        let sure = of(roles, Role::Measured, &[Rank::Exact, Rank::Contained]);
        let name = |at: &usize| header.cell(*at);
        let has_after = sure.iter().any(|at| words::is_after(name(at)));
        let unsure = of(roles, Role::Measured, &[Rank::Unsure]);
        let unsure = unsure.into_iter().filter(|at| !(has_after && words::may_be_before(name(at))));
        match (sure.as_slice(), unsure.collect::<Vec<_>>().as_slice()) {
            ([], _) => Ok(None),
            ([at], []) => Ok(Some(*at)),
            (sure, unsure) => Err(several(Role::Measured, header, &[sure, unsure].concat())),
        }
    }

    /// Whether all other columns that may be meant say the same.
    fn no_rival(&self, header: &StringRecord, roles: &Roles, chosen: Chosen) -> Result<Chosen, ImportErrorKind> {
        let Chosen { measured, tolerance, mut nominal } = chosen;
        let others = |role: Role, ranks: &[Rank], at: usize| {
            of(roles, role, ranks).into_iter().filter(move |other| *other != at && *other != measured)
        };
        if let Some(at) = tolerance {
            let all = [Rank::Exact, Rank::Contained, Rank::Weak];
            let rival = others(Role::Tolerance, &all, at).find(|other| self.has_other_tolerance(at, *other));
            if let Some(other) = rival {
                return Err(several(Role::Tolerance, header, &[at, other]));
            }
        }
        if let Some(at) = nominal {
            let sure = [Rank::Exact, Rank::Contained];
            let rival = others(Role::Nominal, &sure, at).find(|other| self.has_other_size(header, Some(at), *other));
            if let Some(other) = rival {
                return Err(several(Role::Nominal, header, &[at, other]));
            }
        }
        // The user has said which one is the measured value.
        if self.measured.is_some() {
            return Ok(Chosen { measured, tolerance, nominal });
        }
        // Names that stood over several columns are written over the first one alone.
        let unnamed =
            (measured + 1..header.len()).take_while(|at| header.get(*at).is_some_and(|name| name.trim().is_empty()));
        let unnamed: Vec<usize> = unnamed.filter(|at| self.mostly(*at, is_number)).collect();
        if !unnamed.is_empty() {
            return Err(several(Role::Measured, header, &[&[measured], unnamed.as_slice()].concat()));
        }
        let weak = others(Role::Measured, &[Rank::Weak], nominal.unwrap_or(measured));
        let weak: Vec<usize> = weak.filter(|at| self.mostly(*at, is_number)).collect();
        let rivals = weak.iter().copied().filter(|at| match (nominal, tolerance) {
            (Some(_), _) => self.has_other_size(header, nominal, *at),
            (None, Some(tolerance)) => self.has_other_nominal(header, tolerance, *at),
            (None, None) => false,
        });
        let rivals: Vec<usize> = rivals.collect();
        if !rivals.is_empty() {
            return Err(several(Role::Measured, header, &[&[measured], rivals.as_slice()].concat()));
        }
        // Nothing to compare with: a plan will see whether it is the nominal size.
        if let (None, None, [at]) = (nominal, tolerance, weak.as_slice()) {
            nominal = Some(*at);
        }
        Ok(Chosen { measured, tolerance, nominal })
    }

    /// The cells of two columns where both hold something, row by row.
    fn pairs(&self, one: usize, other: usize) -> impl Iterator<Item = (&str, &str)> {
        let rows = self.rows.iter().skip(self.above);
        let pairs = rows.filter_map(move |(_, cells)| Some((cells.get(one)?.trim(), cells.get(other)?.trim())));
        pairs.filter(|(one, other)| !one.is_empty() && !other.is_empty())
    }

    /// Whether a column of callouts or classes says another one than the chosen column.
    fn has_other_tolerance(&self, at: usize, other: usize) -> bool {
        let is_other = |(one, other): (&str, &str)| {
            let is_tolerance = is_callout(other) || is_class(other);
            is_tolerance && class(one) != class(other)
        };
        self.pairs(at, other).any(is_other)
    }

    /// Whether a column of numbers has other sizes than one of nominal sizes.
    fn has_other_size(&self, header: &StringRecord, at: Option<usize>, other: usize) -> bool {
        let Some(at) = at else { return false };
        let size = |at: usize, text: &str| length(header, at, text);
        self.pairs(at, other).any(|(one, rival)| {
            let rival = size(other, rival);
            rival.is_some() && rival != size(at, one)
        })
    }

    /// Whether a column of numbers has other sizes than the nominal ones of callouts.
    fn has_other_nominal(&self, header: &StringRecord, at: usize, other: usize) -> bool {
        self.pairs(at, other).any(|(callout, text)| {
            let nominal = callout.parse::<Callout>().ok().map(|callout| callout.nominal());
            nominal.is_some_and(|nominal| length(header, other, text).is_some_and(|size| size != nominal))
        })
    }
}

/// The class of a callout or of a class; the text where it has none.
fn class(text: &str) -> Result<ToleranceClass, String> {
    let of_callout = text.parse::<Callout>().ok().and_then(|callout| callout.class());
    let class = of_callout.or_else(|| text.parse().ok());
    class.ok_or_else(|| text.split_whitespace().collect())
}

fn length(header: &StringRecord, at: usize, text: &str) -> Option<Length> {
    let unit = unit_of(header.cell(at)).ok()?;
    Length::parse_in(text, unit).ok()
}
