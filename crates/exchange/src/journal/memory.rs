//! Records in memory, in the order of a query that is kept until the query or the records change.

use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::verdict::Status;

use super::Record;
use super::query::{Query, RecordId, Records, Searched};
use fitcheck_core::text::long;

/// Up to this many new records are put in place one by one; more of them are sorted together with the others.
const FEW: usize = 64;

/// Records in memory.
#[derive(Debug, Default)]
pub struct Memory {
    /// In the order in which they were added: by number.
    rows: Vec<SearchableRecord>,
    /// The number of the next record.
    next: u64,
    query: Query,
    /// Places in `rows` of what the query finds, smallest key first.
    order: Vec<usize>,
    counts: [usize; Status::ALL.len()],
    /// How many of them ask for a look.
    bad: usize,
}

/// A record with what it is searched by.
#[derive(Debug)]
struct SearchableRecord {
    id: RecordId,
    record: Arc<Record>,
    texts: Searched,
    /// The number of the entry that corrects it or takes it back: it is listed, but it does not count.
    replaced_by: Option<u64>,
}

impl SearchableRecord {
    /// Whether a query finds it. One that stands no longer is not bad: nobody has to do anything about it.
    fn is_found(&self, query: &Query) -> bool {
        query.finds(&self.record, &self.texts) && !(query.only_bad && self.replaced_by.is_some())
    }
}

/// Records that were taken out, and can be put back.
#[derive(Debug)]
pub struct Removed(Vec<SearchableRecord>);

impl Removed {
    /// How many records.
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl Memory {
    /// The number that the next record will get.
    pub const fn next(&self) -> RecordId {
        RecordId(self.next)
    }

    /// Every record that stands, oldest first.
    pub fn standing(&self) -> impl DoubleEndedIterator<Item = (RecordId, &Arc<Record>)> {
        self.rows.iter().filter(|row| row.replaced_by.is_none()).map(|row| (row.id, &row.record))
    }

    /// The numbers of all records, oldest first.
    pub fn ids(&self) -> impl Iterator<Item = RecordId> {
        self.rows.iter().map(|row| row.id)
    }

    /// The entry that corrects a record or takes it back.
    pub fn replaced_by(&self, id: RecordId) -> Option<u64> {
        self.row(id)?.1.replaced_by
    }

    /// An entry corrects a record or takes it back: it stays in its place, and does not count any more.
    pub fn replace(&mut self, id: RecordId, by: u64) {
        if let Ok(place) = self.rows.binary_search_by_key(&id, |row| row.id)
            && let Some(row) = self.rows.get_mut(place)
        {
            row.replaced_by = Some(by);
        }
        if self.query.only_bad { self.arrange() } else { self.count_statuses() }
    }

    /// Puts other records in the places of some; returns what stood there.
    pub fn put(&mut self, records: Vec<(RecordId, Arc<Record>)>) -> Vec<(RecordId, Arc<Record>)> {
        let mut before = Vec::new();
        for (id, record) in records {
            let Ok(place) = self.rows.binary_search_by_key(&id, |row| row.id) else { continue };
            let Some(row) = self.rows.get_mut(place) else { continue };
            row.texts = Searched::of(&record);
            before.push((id, std::mem::replace(&mut row.record, record)));
        }
        self.arrange();
        before
    }

    pub fn add(&mut self, records: Vec<Arc<Record>>) {
        let first = self.rows.len();
        let few = records.len() <= FEW;
        for record in records {
            let texts = Searched::of(&record);
            self.rows.push(SearchableRecord { id: RecordId(self.next), record, texts, replaced_by: None });
            self.next += 1;
        }
        if few {
            (first..self.rows.len()).for_each(|place| self.insert(place));
        } else {
            self.arrange();
        }
    }

    /// Leaves room before the first record for so many that come later; nothing where there are records already.
    pub fn leave_room(&mut self, count: u64) {
        if self.rows.is_empty() && self.next == 0 {
            self.next = count;
        }
    }

    /// Puts records before all others, as far as there is room for their numbers: of too many the oldest stay out. Returns
    /// the numbers of all that are in, in order.
    pub fn put_before(&mut self, records: Vec<Arc<Record>>) -> Vec<RecordId> {
        let first = self.rows.first().map_or(self.next, |row| row.id.0);
        let room = usize::try_from(first).unwrap_or(usize::MAX);
        let skipped = records.len().saturating_sub(room);
        let count = long(records.len() - skipped);
        let ids: Vec<RecordId> = (first.saturating_sub(count)..first).map(RecordId).collect();
        let rows = records.into_iter().skip(skipped).zip(&ids);
        let rows = rows.map(|(record, id)| {
            let texts = Searched::of(&record);
            SearchableRecord { id: *id, texts, record, replaced_by: None }
        });
        self.rows.splice(0..0, rows);
        self.arrange();
        ids
    }

    /// Takes out the records of these numbers.
    pub fn remove(&mut self, ids: Range<RecordId>) -> Removed {
        let first = self.rows.partition_point(|row| row.id < ids.start);
        let end = self.rows.partition_point(|row| row.id < ids.end).max(first);
        let removed = self.rows.splice(first..end, []).collect();
        self.arrange();
        Removed(removed)
    }

    /// Puts records back that were taken out.
    pub fn put_back(&mut self, removed: Removed) {
        self.rows.extend(removed.0);
        self.rows.sort_by_key(|row| row.id);
        self.arrange();
    }

    /// Finds and sorts everything anew.
    fn arrange(&mut self) {
        let Self { rows, query, order, .. } = self;
        order.clear();
        order.extend((0..).zip(&*rows).filter(|(_, row)| row.is_found(query)).map(|(place, _)| place));
        // Without a column the order is that of the numbers already.
        if query.sort.is_some() {
            order.sort_by_cached_key(|place| rows.get(*place).map(|row| query.key(row.id, &row.record)));
        }
        self.count_statuses();
    }

    /// Puts a new row in its place.
    fn insert(&mut self, place: usize) {
        let Some(row) = self.rows.get(place).filter(|row| row.is_found(&self.query)) else { return };
        if let Some(count) = self.counts.get_mut(number_of(row)) {
            *count += 1;
        }
        self.bad += usize::from(row.record.verdict.asks_for_a_look());
        let at = self.before(row);
        self.order.insert(at, place);
    }

    /// How many rows of the order have a smaller key.
    fn before(&self, row: &SearchableRecord) -> usize {
        let key = self.query.key(row.id, &row.record);
        let is_smaller = |other: &SearchableRecord| self.query.key(other.id, &other.record) < key;
        self.order.partition_point(|place| self.rows.get(*place).is_some_and(is_smaller))
    }

    fn count_statuses(&mut self) {
        let mut counts = [0; Status::ALL.len()];
        let mut bad = 0;
        let listed = self.order.iter().filter_map(|place| self.rows.get(*place));
        for row in listed.filter(|row| row.replaced_by.is_none()) {
            if let Some(count) = counts.get_mut(number_of(row)) {
                *count += 1;
            }
            bad += usize::from(row.record.verdict.asks_for_a_look());
        }
        self.counts = counts;
        self.bad = bad;
    }

    fn row(&self, id: RecordId) -> Option<(usize, &SearchableRecord)> {
        let place = self.rows.binary_search_by_key(&id, |row| row.id).ok()?;
        Some((place, self.rows.get(place)?))
    }

    /// A place of the answer as a place in the order, and the other way round.
    fn turned(&self, place: usize) -> Option<usize> {
        if self.query.is_reversed() { self.order.len().checked_sub(place + 1) } else { Some(place) }
    }
}

/// The number of a row's status among all.
fn number_of(row: &SearchableRecord) -> usize {
    row.record.verdict.status().at()
}

impl Records for Memory {
    fn ask(&mut self, query: Query) {
        let column = |query: &Query| query.sort.map(|sort| sort.column);
        let is_turned_only = column(&query) == column(&self.query)
            && query.words == self.query.words
            && query.only_bad == self.query.only_bad;
        self.query = query;
        if !is_turned_only {
            self.arrange();
        }
    }

    fn query(&self) -> &Query {
        &self.query
    }

    fn count(&self) -> usize {
        self.order.len()
    }

    fn counts(&self) -> [usize; Status::ALL.len()] {
        self.counts
    }

    fn bad(&self) -> usize {
        self.bad
    }

    fn page(&self, places: Range<usize>) -> Vec<(RecordId, Arc<Record>)> {
        let row = |place| self.rows.get(*self.order.get(self.turned(place)?)?);
        let rows = (places.start..places.end.min(self.count())).filter_map(row);
        rows.map(|row| (row.id, Arc::clone(&row.record))).collect()
    }

    fn place_of(&self, id: RecordId) -> Option<usize> {
        let (place, row) = self.row(id)?;
        let at = self.before(row);
        self.order.get(at).filter(|found| **found == place)?;
        self.turned(at)
    }

    fn get(&self, id: RecordId) -> Option<Arc<Record>> {
        self.row(id).map(|(_, row)| Arc::clone(&row.record))
    }

    fn len(&self) -> usize {
        self.rows.len()
    }
}
