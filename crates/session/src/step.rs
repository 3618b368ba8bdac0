//! Steps among things in rows and columns: classes of the map, cells, blocks, moves of a path.

/// A step. It ends at the edge, and does nothing where there is nothing in its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Step {
    /// To the one on the left: the class before, the move before.
    Left,
    /// To the one on the right: the class after, the next move.
    Right,
    /// To the one above: the finer grade, the smaller size range, the block before.
    Up,
    /// To the one below: the coarser grade, the larger size range, the next block.
    Down,
    /// This many up.
    PageUp,
    /// This many down.
    PageDown,
    /// To the first one: of a table's row, its first class.
    First,
    Last,
    /// To the first row of a table.
    Top,
    /// To the last row of a table.
    Bottom,
}

/// How many rows of a list a page has.
const PAGE: usize = 10;

impl Step {
    /// The steps among the classes of the map.
    pub const CLASSES: [Self; 4] = [Self::Left, Self::Right, Self::Up, Self::Down];
    /// The steps along a path.
    pub const PATH: [Self; 4] = [Self::First, Self::Left, Self::Right, Self::Last];
    /// The steps among blocks.
    pub const BLOCKS: [Self; 6] = [Self::Up, Self::Down, Self::PageUp, Self::PageDown, Self::First, Self::Last];
    /// The steps among the entries of a folder.
    pub const ENTRIES: [Self; 4] = [Self::Up, Self::Down, Self::PageUp, Self::PageDown];
    /// The steps among cells: every one.
    pub const CELLS: [Self; 10] = [
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
        Self::PageUp,
        Self::PageDown,
        Self::First,
        Self::Last,
        Self::Top,
        Self::Bottom,
    ];

    /// Where it leads in a list whose last place is `last`. From no place it leads to the first one, or to the last.
    pub(super) fn place(self, here: Option<usize>, last: usize) -> usize {
        let place = match (self, here) {
            (Self::Last | Self::Bottom, _) => last,
            (Self::First | Self::Top, _) | (_, None) => 0,
            (Self::Left | Self::Up, Some(here)) => here.saturating_sub(1),
            (Self::Right | Self::Down, Some(here)) => here + 1,
            (Self::PageUp, Some(here)) => here.saturating_sub(PAGE),
            (Self::PageDown, Some(here)) => here + PAGE,
        };
        place.min(last)
    }
}
