//! What a column is, and where the columns stand within a width.

use eframe::egui::Rangef;

use crate::gui::theme::space;
use crate::session::Action;

/// How the cells of a column look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Text,
    /// It stands at the right.
    Figure,
    /// A number: the decimal signs stand below each other.
    Number,
    /// Colour, shape and word of a verdict. What strikes a row through ends before it.
    Verdict,
    /// Colour and shape of a verdict.
    Mark,
    /// Where a value lies in its zone.
    Zone,
    /// A box with a check mark.
    Choice,
}

/// What stands above a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Head {
    /// A text by its name, and a unit.
    Text(Option<&'static str>, Option<&'static str>),
    /// A button that sorts, and a unit.
    Sorts(Action, Option<&'static str>),
}

/// A column as a page declares it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::gui) struct Column {
    pub(super) kind: Kind,
    pub(super) head: Head,
    /// Steps of space.
    width: f32,
    /// As wide as it becomes by what is left over.
    most: f32,
    /// The lowest gives way first.
    gives_way: Option<u8>,
    /// Whether there is anything to show in it.
    is_wanted: bool,
    /// Whether what is too long for a line goes on in a second one.
    pub(super) wraps: bool,
}

impl Column {
    const fn new(kind: Kind, width: f32) -> Self {
        let head = Head::Text(None, None);
        Self { kind, head, width, most: width, gives_way: None, is_wanted: true, wraps: false }
    }

    /// A column of texts, so many steps wide.
    pub const fn text(width: f32) -> Self {
        Self::new(Kind::Text, width)
    }

    /// A column of figures: they stand at the right.
    pub const fn figure(width: f32) -> Self {
        Self::new(Kind::Figure, width)
    }

    /// A column of numbers with unlike decimals: their signs stand below each other.
    pub const fn number(width: f32) -> Self {
        Self::new(Kind::Number, width)
    }

    /// A column of verdicts: colour, shape and word.
    pub const fn verdict(width: f32) -> Self {
        Self::new(Kind::Verdict, width)
    }

    /// A column of verdicts without words, of a width of its own.
    pub const fn mark() -> Self {
        Self::new(Kind::Mark, 10.0)
    }

    /// A column of small bands, of a width of its own.
    pub const fn zone() -> Self {
        Self::new(Kind::Zone, 26.0)
    }

    /// A column of check marks, of a width of its own.
    pub const fn choice() -> Self {
        Self::new(Kind::Choice, 10.0)
    }

    /// What stands above it.
    pub const fn head(self, id: &'static str) -> Self {
        Self { head: Head::Text(Some(id), None), ..self }
    }

    /// The unit of its figures.
    pub const fn unit(self, unit: &'static str) -> Self {
        let head = match self.head {
            Head::Text(id, _) => Head::Text(id, Some(unit)),
            Head::Sorts(action, _) => Head::Sorts(action, Some(unit)),
        };
        Self { head, ..self }
    }

    /// A click on its head sorts.
    pub const fn sorts(self, action: Action) -> Self {
        let unit = match self.head {
            Head::Text(_, unit) | Head::Sorts(_, unit) => unit,
        };
        Self { head: Head::Sorts(action, unit), ..self }
    }

    /// Where there is too little room it gives way, the lowest first; the row says it all under the pointer.
    pub const fn gives_way(self, order: u8) -> Self {
        Self { gives_way: Some(order), ..self }
    }

    /// What is left over is its own, up to so many steps, unless a column after it takes it.
    pub const fn grows(self, most: f32) -> Self {
        Self { most, ..self }
    }

    /// What is left over is its own, unless a column after it takes it.
    pub const fn takes_rest(self) -> Self {
        self.grows(f32::INFINITY)
    }

    /// What is too long for a line goes on in a second one, in smaller letters.
    pub const fn wraps(self) -> Self {
        Self { wraps: true, ..self }
    }

    /// Left out where there is nothing to show in it.
    pub const fn wanted(self, is_wanted: bool) -> Self {
        Self { is_wanted, ..self }
    }

    /// Whether it keeps its width whatever the room is.
    pub(super) const fn is_fixed(&self) -> bool {
        matches!(self.kind, Kind::Mark | Kind::Zone | Kind::Choice)
    }
}

/// Where each column stands; one that has no room is left out.
pub(super) type Across = Vec<Option<Rangef>>;

/// The widths that the user gave columns.
pub(super) type Own = Vec<Option<f32>>;

/// Where the columns stand: some give way, one takes what is left over, and then all become wider or narrower but those of a width of
/// their own. What the user made wide becomes no wider.
pub(super) fn across(columns: &[Column], stretch: f32, own: &Own, (left, width): (f32, f32)) -> Across {
    let own = |at: usize| own.get(at).copied().flatten();
    let declared = |(at, column): (usize, &Column)| match column {
        Column { is_wanted: false, .. } => 0.0,
        Column { width, .. } => own(at).unwrap_or_else(|| space(*width)),
    };
    let mut wanted: Vec<f32> = columns.iter().enumerate().map(declared).collect();
    let mut give_way: Vec<(u8, usize)> =
        columns.iter().enumerate().filter_map(|(at, column)| Some((column.gives_way?, at))).collect();
    give_way.sort_unstable();
    for (_, at) in give_way {
        if wanted.iter().sum::<f32>() <= width {
            break;
        }
        wanted.splice(at..=at, [0.0]);
    }
    let rest = width - wanted.iter().sum::<f32>();
    let takes = |(at, column): &(usize, (&Column, &mut f32))| {
        0.0 < *column.1 && own(*at).is_none() && column.0.width < column.0.most
    };
    if let Some((_, (column, wanted))) = columns.iter().zip(&mut wanted).enumerate().rfind(takes) {
        *wanted += rest.clamp(0.0, space(column.most - column.width));
    }
    let sum = |of: &dyn Fn(usize, &Column) -> bool| {
        let all = columns.iter().zip(&wanted).enumerate();
        all.filter(|(at, (column, _))| of(*at, column)).map(|(_, (_, wanted))| wanted).sum::<f32>()
    };
    let room = (width - sum(&|_, column| column.is_fixed())).max(0.0);
    let given = sum(&|at, column| !column.is_fixed() && own(at).is_some());
    let free = sum(&|at, column| !column.is_fixed() && own(at).is_none());
    let is_narrow = room < given + free;
    let factor = |at: usize, column: &Column| match column {
        column if column.is_fixed() => 1.0,
        _ if is_narrow => room / (given + free).max(1.0),
        _ if own(at).is_some() => 1.0,
        _ => ((room - given) / free.max(1.0)).min(stretch),
    };
    let mut from = left;
    let ranges = columns.iter().zip(wanted).enumerate().map(|(at, (column, wanted))| {
        let across = Rangef::new(from, from + wanted * factor(at, column));
        from = across.max;
        (0.0 < wanted).then_some(across)
    });
    ranges.collect()
}

/// How wide the user may make a column: the others that never give way keep their declared widths.
pub(super) fn most(columns: &[Column], at: usize, width: f32) -> f32 {
    let others = columns.iter().enumerate().filter(|(other, column)| *other != at && column.gives_way.is_none());
    let kept: f32 = others.filter(|(_, column)| column.is_wanted).map(|(_, column)| space(column.width)).sum();
    (width - kept).max(least())
}

/// How narrow the user may make a column.
pub(super) fn least() -> f32 {
    space(8.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gui::{check, pairing, parts, records};

    const WIDTHS: [f32; 10] = [1600.0, 1200.0, 1100.0, 1000.0, 900.0, 760.0, 600.0, 500.0, 400.0, 200.0];

    /// How many columns each of these widths shows.
    fn shown(columns: &[Column], stretch: f32, own: &Own) -> [usize; WIDTHS.len()] {
        WIDTHS.map(|width| {
            let across: Vec<Rangef> = across(columns, stretch, own, (7.0, width)).into_iter().flatten().collect();
            let joined = across.windows(2).all(|two| two[0].min < two[1].min && (two[0].max - two[1].min).abs() < 0.01);
            assert!(joined, "{width}");
            let first = across[0].min;
            let last = across[across.len() - 1].max;
            let fills = (last - 7.0 - width).abs() < 0.01 || stretch.is_finite() && last < 7.0 + width;
            assert!((first - 7.0).abs() < 0.01 && fills, "{width}: {first} to {last}");
            across.len()
        })
    }

    /// Which columns are left where there is no room.
    fn never_give_way(columns: &[Column]) -> Vec<usize> {
        let left = across(columns, 1.0, &Own::new(), (0.0, 100.0));
        left.iter().enumerate().filter_map(|(at, across)| across.map(|_| at)).collect()
    }

    #[test]
    fn columns_fill_the_width_and_give_way_one_after_another() {
        let free = f32::INFINITY;
        let pairs = [false, true].map(pairing::columns);
        for (columns, stretch, expected, never) in [
            (&check::HISTORY[..], free, [9, 9, 9, 8, 7, 7, 5, 5, 4, 4], vec![0, 3, 4, 7]),
            (&check::ROWS, free, [7, 7, 7, 7, 6, 5, 4, 4, 4, 4], vec![2, 3, 5, 6]),
            (&records::COLUMNS, free, [12, 12, 11, 10, 9, 7, 6, 5, 5, 5], vec![0, 1, 6, 7, 10]),
            (&pairs[0], 1.6, [6, 6, 6, 6, 6, 6, 6, 5, 4, 3], vec![0, 2, 4]),
            (&pairs[1], 1.6, [7, 7, 7, 7, 7, 7, 6, 5, 4, 4], vec![0, 2, 4, 6]),
            (&parts::SIZES, 1.6, [6, 6, 6, 6, 6, 6, 6, 6, 5, 3], vec![0, 1, 3]),
        ] {
            assert_eq!(shown(columns, stretch, &Own::new()), expected, "{columns:?}");
            assert_eq!(never_give_way(columns), never, "{columns:?}");
        }
    }

    #[test]
    fn what_is_left_over_goes_to_one_column_and_a_size_stays_near_its_name() {
        let wide = |columns: &[Column], stretch, at: usize| {
            across(columns, stretch, &Own::new(), (0.0, 1600.0))[at].map(Rangef::span)
        };
        let is = |of: Option<f32>, steps: f32| of.is_some_and(|width| (width - space(steps)).abs() < 0.01);
        assert!(is(wide(&check::HISTORY, f32::INFINITY, 1), 26.0));
        assert!(is(wide(&pairing::columns(false), 1.6, 0), 20.0 * 1.6));
        assert!(is(wide(&parts::SIZES, 1.6, 0), 10.0), "a mark keeps its width");
        assert!(is(wide(&parts::SIZES, 1.6, 5), 36.0 * 1.6), "a remark is long, but not endless");
    }

    #[test]
    fn what_the_user_made_wide_keeps_its_width_while_there_is_room() {
        let mut own = vec![None; check::HISTORY.len()];
        own[2] = Some(200.0);
        let part = |width| across(&check::HISTORY, f32::INFINITY, &own, (0.0, width))[2].map(Rangef::span);
        assert_eq!(part(1600.0), Some(200.0));
        assert_eq!(part(600.0), None, "it still gives way");
        shown(&check::HISTORY, f32::INFINITY, &own);
        own[3] = Some(5000.0);
        shown(&check::HISTORY, f32::INFINITY, &own);
        assert!(most(&check::HISTORY, 2, 1200.0) < 1200.0 - space(10.0 + 20.0 + 23.0 + 52.0) + 0.01);
    }
}
