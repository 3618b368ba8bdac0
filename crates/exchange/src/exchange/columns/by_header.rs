//! The columns of a file whose header names them.

use csv::StringRecord;

use super::{Columns, LabelColumns};
use crate::exchange::cell::Cells as _;
use crate::exchange::column::{LengthColumn, name_of, unit_of};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::evidence::Evidence;
use crate::exchange::limits::{self, Beside, LimitColumns};
use crate::exchange::own::OwnColumns;
use crate::exchange::quantity::Free;
use crate::exchange::rivals::{Roles, best};
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::vocabulary::Rank;
use crate::exchange::{warmth, words};

impl Sample {
    /// What the names of a header say.
    pub(super) fn by_header(&self, line: usize, header: &StringRecord) -> Result<Columns, ImportErrorKind> {
        let mut roles: Vec<_> = header.iter().map(words::role).collect();
        let own = OwnColumns::of(header);
        for at in own.of_correction() {
            if let Some(role) = roles.get_mut(at) {
                *role = None;
            }
        }
        let quantities = self.quantities(header, names(header, &roles), |at| match header.get(at) {
            // A file of Fitcheck names its values there, whatever they are called.
            Some("id") if own != OwnColumns::default() => Free::No,
            _ => free(header, &roles, at),
        });
        // "Part [°C]" names no part.
        let warm: Vec<usize> = (0..)
            .zip(header)
            .zip(&roles)
            .filter(|((_, name), role)| !matches!(role, Some((Role::Measured, _))) && warmth::of_column(name).is_some())
            .map(|((at, _), _)| at)
            .collect();
        for at in quantities.iter().map(|column| column.at).chain(warm.iter().copied()) {
            if let Some(role) = roles.get_mut(at) {
                *role = None;
            }
        }
        let best = |role: Role, ranks: &[Rank]| best(header, &roles, role, ranks);
        let sure = [Rank::Exact, Rank::Contained];
        let chosen = self.chosen(header, &roles)?;
        let tolerance = chosen.tolerance;
        let nominal = chosen.nominal;
        let measured_at = chosen.measured;
        let time: Vec<usize> =
            (0..).zip(&roles).filter(|(_, r)| matches!(r, Some((Role::Time, _)))).map(|(at, _)| at).take(2).collect();
        let id = names(header, &roles);
        let simulated = best(Role::Simulated, &sure)?;
        let column = |at: usize| -> Result<LengthColumn, ImportErrorKind> {
            Ok(LengthColumn { at, unit: unit_of(header.cell(at))? })
        };
        let evidence = Evidence::of(header, measured_at);
        // What Fitcheck wrote is compared with its own callouts.
        let limits = if own == OwnColumns::default() && !self.are_limits_said {
            let has_callouts = tolerance.is_some();
            let beside = Beside { names: header, measured: measured_at, nominal, has_callouts };
            self.limit_columns(beside, |at| ![tolerance, nominal].contains(&Some(at)))?
        } else {
            None
        };
        let used: Vec<usize> = [id, tolerance, nominal, simulated, evidence.origin, Some(measured_at)]
            .into_iter()
            .flatten()
            .chain(time.iter().copied())
            .chain(quantities.iter().map(|column| column.at))
            .chain(own.of_correction())
            .chain(limits.iter().flat_map(LimitColumns::iter).map(|column| column.at))
            .collect();
        let labels = LabelColumns::of(header, id, &[used.as_slice(), &warm].concat());
        let used: Vec<usize> = used.into_iter().chain(labels.iter()).collect();
        let ignored = (0..).zip(header).filter(|(at, name)| !used.contains(at) && !name.trim().is_empty());
        Ok(Columns {
            id,
            tolerance,
            nominal: nominal.map(column).transpose()?,
            measured: column(measured_at)?,
            tolerance_goes_both_ways: tolerance.is_some_and(|at| limits::goes_both_ways(header.cell(at))),
            limits,
            time,
            simulated,
            quantities,
            count: header.len(),
            header: Some(line),
            names_known: true,
            ignored: ignored.map(|(at, name)| name_of(at, name)).collect(),
            own,
            evidence,
            labels,
            ..Columns::default()
        })
    }
}

/// The column that names the features. Any of several will do, but a part, a serial number or a number names a value only where nothing
/// else does.
fn names(header: &StringRecord, roles: &Roles) -> Option<usize> {
    let of_rank = |rank: Rank| roles.iter().position(|role| *role == Some((Role::Id, rank)));
    let first = of_rank(Rank::Exact).or_else(|| of_rank(Rank::Contained))?;
    if names_features(header, first) {
        return Some(first);
    }
    let is_id = |at: &usize| matches!(roles.get(*at), Some(Some((Role::Id, _))));
    (0..header.len()).filter(is_id).find(|at| names_features(header, *at)).or(Some(first))
}

/// Whether a column of names has those of features, and of nothing else.
fn names_features(header: &StringRecord, at: usize) -> bool {
    header.get(at).is_none_or(|name| words::label(name).is_none())
}

/// Whether a column may say what was measured.
fn free(header: &StringRecord, roles: &Roles, at: usize) -> Free {
    let name = header.cell(at);
    let is_id = |at: usize| names_features(header, at) && matches!(roles.get(at), Some(Some((Role::Id, _))));
    match roles.get(at).copied().flatten() {
        Some((Role::Id, _)) if is_id(at) && (0..header.len()).any(|other| other != at && is_id(other)) => {
            Free::NamesToo
        }
        None | Some((Role::Measured, Rank::Weak)) if words::label(name).is_none() && !words::is_status(name) => {
            Free::Yes
        }
        _ => Free::No,
    }
}
