//! Questions to the server about the checks of all stations, answered page by page: what the server got last comes first.

use fitcheck_exchange::journal::ask::{AskedKinds, Question};
use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{ChainId, Head};
use fitcheck_exchange::journal::entry::Kept;
use fitcheck_exchange::journal::found::{WantedWord, words_of};

use super::access::Access;
use super::error::{ShopError, chain_of, hash_of};
use super::schema::{self, value};
use super::send::{count, integer, natural};
use super::server::{Patience, Server, Stop};
use crate::local::ListedEntry;

/// How many entries are fetched at once.
const PAGE: i64 = 1_000;

/// A place in the list: behind the entry of which it tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ListPlace {
    /// When the server got the entry, microseconds since 1970 in UTC.
    pub received_us: i64,
    pub chain: ChainId,
    pub number: u64,
}

/// An entry on the server.
#[derive(Debug, Clone, PartialEq)]
pub struct ShopRow {
    /// Where it is in the list.
    pub place: ListPlace,
    /// The station that sent it.
    pub station: String,
    /// The entry.
    pub row: ListedEntry,
}

/// A part of the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// Checks, withdrawals and reports that the question asks for.
    pub rows: Vec<ShopRow>,
    /// Where the list goes on; `None` at its end.
    pub next: Option<ListPlace>,
    /// How many entries were passed over because this version cannot read them.
    pub unread: u64,
}

/// A server that is asked.
pub struct ShopReader {
    server: Server,
}

impl std::fmt::Debug for ShopReader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("ShopReader")
    }
}

impl ShopReader {
    /// Connects; `stop` ends what it does from another thread.
    ///
    /// # Errors
    /// [`ShopError`] where the server cannot be asked or has no journal.
    pub fn open(access: &Access, patience: Patience, stop: &Stop) -> Result<Self, ShopError> {
        let server = Server::connect(access, patience, stop)?;
        let _version = schema::version(&server)?;
        Ok(Self { server })
    }

    /// At most so many checks and withdrawals that a question asks for, behind a place in the list.
    ///
    /// # Errors
    /// [`ShopError`] where the server cannot be asked.
    pub fn page(&self, question: &Question, after: Option<ListPlace>, most: usize) -> Result<Page, ShopError> {
        let mut page = Page { rows: Vec::new(), next: after, unread: 0 };
        loop {
            let fetched = self.fetch(question, page.next)?;
            let is_last = count(fetched.len()) < PAGE.unsigned_abs();
            for row in fetched {
                page.next = Some(row.place);
                let found = body::found(&row.kept.body);
                let is_unread = found.is_err();
                let number = row.kept.head.number;
                let is_wanted = found
                    .ok()
                    .flatten()
                    .is_some_and(|found| question.finds(number, &found, row.corrected_by.is_some()));
                page.unread = page.unread.saturating_add(u64::from(is_unread));
                if is_wanted {
                    page.rows.push(row.read());
                }
                if most <= page.rows.len() {
                    return Ok(page);
                }
            }
            if is_last {
                page.next = None;
                return Ok(page);
            }
        }
    }

    /// Entries behind a place in the list that may fit: what the server says of texts and times is only used to leave out many.
    fn fetch(&self, question: &Question, after: Option<ListPlace>) -> Result<Vec<Fetched>, ShopError> {
        let sql = "SELECT chain, number, hash, body, station, (extract(epoch FROM received) * 1000000)::bigint, \
             fitcheck.corrected_by(chain, number) \
             FROM fitcheck.entry AS entry \
             WHERE 1 < number AND ($1::bigint IS NULL OR received <= timestamptz 'epoch' + $1 * interval '1 microsecond') \
             AND ($1::bigint IS NULL OR received < timestamptz 'epoch' + $1 * interval '1 microsecond' \
                  OR $2::bytea < chain OR (chain = $2 AND number < $3::bigint)) \
             AND (octet_length(body) <> char_length(body) \
                  OR NOT EXISTS (SELECT FROM pg_catalog.unnest($4::text[]) AS word \
                                 WHERE strpos(lower(body COLLATE \"C\"), word) = 0)) \
             ORDER BY received DESC, chain, number DESC LIMIT $5";
        let time = after.map(|place| place.received_us);
        let chain = after.map(|place| place.chain.0.to_vec());
        let number = after.map(|place| integer(place.number));
        let words = surely(question);
        let client = &self.server.client;
        let rows = self.server.ask(client.query(sql, &[&time, &chain, &number, &words, &PAGE]))?;
        rows.iter().map(Fetched::of).collect()
    }
}

/// An entry that is not read yet.
struct Fetched {
    place: ListPlace,
    station: String,
    kept: Kept,
    corrected_by: Option<u64>,
}

impl Fetched {
    fn of(row: &tokio_postgres::Row) -> Result<Self, ShopError> {
        let chain = chain_of(value(row, 0)?)?;
        let number = natural(value(row, 1)?);
        let head = Head { number, hash: hash_of(value(row, 2)?)? };
        let corrected_by: Option<i64> = value(row, 6)?;
        Ok(Self {
            place: ListPlace { received_us: value(row, 5)?, chain, number },
            station: value(row, 4)?,
            kept: Kept { head, body: value::<&str>(row, 3)?.as_bytes().into() },
            corrected_by: corrected_by.map(natural),
        })
    }

    fn read(self) -> ShopRow {
        let Self { place, station, kept, corrected_by } = self;
        ShopRow { place, station, row: ListedEntry { entry: body::read(&kept.body), kept, corrected_by } }
    }
}

/// Words in small letters that stand in every body of ASCII that a question asks for. Bodies and words with other letters are left to
/// [`Question::finds`]: servers differ in what their small ones are, and accents do not count. So is a plain number, which may be that of the
/// record; and of a callout without its blank, only the figures before it stand in the body.
fn surely(question: &Question) -> Vec<String> {
    let Question { part, feature, who, station, serial, words, .. } = question;
    let names = [part, feature, who, station, serial].into_iter().flatten().flat_map(|text| words_of(text));
    let figures = |word: String| {
        let figures: String = word.chars().take_while(char::is_ascii_digit).collect();
        if figures.is_empty() { word } else { figures }
    };
    let wanted = words.iter().flat_map(|text| WantedWord::all_of(text)).filter(|word| word.number.is_none());
    let wanted = wanted.map(|word| word.text).filter(|word| word.is_ascii()).map(figures);
    // As a body has it: no text within one has these signs beside each other.
    let kind = match question.kinds {
        AskedKinds::Reports => Some("\"kind\":\"report\"".to_owned()),
        AskedKinds::Alarms => Some("\"kind\":\"alarm\"".to_owned()),
        AskedKinds::All | AskedKinds::Checks => None,
    };
    names.filter(|word| word.is_ascii()).chain(wanted).chain(kind).collect()
}
