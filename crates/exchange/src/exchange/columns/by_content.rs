//! The columns of a file without a header that names them.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::{Columns, LabelColumns};
use crate::exchange::cells::{is_callout, is_class_with_grade, is_number, own_callout};
use crate::exchange::column::{LengthColumn, name_of, several};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::quantity::Free;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;

impl Sample {
    /// Without a header: the column of callouts, or of classes with the nominal sizes before them, and the only column
    /// of numbers after it, or the only one at all beside a callout. Names of own columns, such as PF, are words like any
    /// other, so they are told apart by the measured value only, and only in callouts.
    pub(super) fn by_content(&self) -> Result<Columns, ImportErrorKind> {
        let width = self.rows.iter().map(|(_, cells)| cells.len()).fold(0, usize::max);
        // The count that most rows have; a longer row is reported.
        let count = (1..=width)
            .max_by_key(|&n| self.rows.iter().filter(|(_, cells)| cells.len() == n).count())
            .unwrap_or(width);
        let all = |kind: fn(&str) -> bool| -> Vec<usize> { (0..count).filter(|&at| self.mostly(at, kind)).collect() };
        let no_header = StringRecord::new();
        let callout = match all(is_callout).as_slice() {
            [] => None,
            [at] => Some(*at),
            several_are => return Err(several(Role::Tolerance, &no_header, several_are)),
        };
        let numbers = all(is_number);
        let class = all(is_class_with_grade)
            .into_iter()
            .find(|&at| at.checked_sub(1).is_some_and(|before| numbers.binary_search(&before).is_ok()));
        let (tolerance, nominal) = match (callout, class) {
            (Some(at), _) => (Some(at), None),
            (None, Some(at)) => (Some(at), at.checked_sub(1)),
            (None, None) => (self.own_callouts(), None),
        };
        let free: Vec<usize> = numbers.into_iter().filter(|at| Some(*at) != nominal).collect();
        let behind: Vec<usize> =
            free.iter().copied().filter(|at| tolerance.is_some_and(|before| before < *at)).collect();
        let measured = match (self.measured, behind.as_slice(), free.as_slice()) {
            (Some(said), ..) => said,
            // Of two numbers before a class, either may be the nominal size.
            (None, [], [_, ..]) if nominal.is_some() => {
                let before: Vec<usize> = free.iter().copied().chain(nominal).collect();
                return Err(several(Role::Measured, &no_header, &before));
            }
            (None, [at], _) | (None, [], [at]) => *at,
            (None, [], []) => return Err(ImportErrorKind::NoMeasuredColumn),
            (None, [], several_are) | (None, several_are, _) => {
                return Err(several(Role::Measured, &no_header, several_are));
            }
        };
        let first = [tolerance, nominal].into_iter().flatten().fold(measured, usize::min);
        let id = (0..first).next();
        let used = [id, tolerance, nominal, Some(measured)];
        let is_free = |at: usize| if used.contains(&Some(at)) { Free::No } else { Free::Yes };
        let quantities = self.quantities(&no_header, id, is_free);
        let is_used = |at: usize| used.contains(&Some(at)) || quantities.iter().any(|column| column.at == at);
        Ok(Columns {
            id,
            tolerance,
            nominal: nominal.map(|at| LengthColumn { at, unit: Unit::Millimetre }),
            measured: LengthColumn { at: measured, unit: Unit::Millimetre },
            count,
            ignored: (0..count).filter(|at| !is_used(*at)).map(|at| name_of(at, "")).collect(),
            quantities,
            labels: LabelColumns { may_be_running: true, ..LabelColumns::default() },
            ..Columns::default()
        })
    }

    /// The column that holds the own callout of more than half of the rows.
    fn own_callouts(&self) -> Option<usize> {
        let data = || self.rows.iter().skip(self.above).map(|(_, cells)| own_callout(cells));
        let first = data().flatten().next()?;
        let (are, all) = data().fold((0, 0), |(are, all), at| (are + usize::from(at == Some(first)), all + 1));
        (all < are * 2).then_some(first)
    }
}
