//! The server of a shop, asked from the command line.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::inspected::{InspectedAnswer, bar};
use super::{CliError, CliRemark, IntoCliError as _, Io};
use crate::cli::journal_place::own;
use crate::journal::ask::Question;
use crate::journal::chain::{ChainId, Head};
use crate::message::{Message, Say as _};
use crate::store::StoreRemark;
use crate::store::local::{Anchors, ListedEntry, Reader};
use crate::store::shop::{
    self, Access, Clock, Elsewhere, Patience, Places, ShopAddress, ShopChain, ShopReader, ShopVerified, Stop,
};

/// The server with its password, and what is said of places that had none to give.
fn access(address: &str, io: &mut Io<'_>) -> Result<Access, CliError> {
    let (address, password) = ShopAddress::read(address).said()?;
    let access = Access::find(address, password, &Places::of_system());
    for remark in &access.remarks {
        io.remark(remark);
    }
    Ok(access)
}

/// A number that chooses its plural.
fn count(number: u64) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

/// Whether the server answers, and has the tables; its address without a password.
pub(in crate::cli) fn answers(address: &str, io: &mut Io<'_>) -> Result<String, CliError> {
    let access = access(address, io)?;
    ShopReader::open(&access, Patience::default(), &Stop::default()).said()?;
    Ok(access.address.to_string())
}

/// Makes the tables.
pub(in crate::cli) fn init(address: &str, io: &mut Io<'_>) -> Result<(), CliError> {
    let made = shop::init(&access(address, io)?, Patience::default()).said()?;
    io.note(made);
    Ok(())
}

/// Sends what the server lacks.
pub(in crate::cli) fn send(address: &str, file: &Path, station: &str, io: &mut Io<'_>) -> Result<(), CliError> {
    let access = access(address, io)?;
    let reader = Reader::open(file).said()?;
    let bar = bar();
    let sent = shop::send_once(&reader, station, &access, Patience::default(), &mut |sent| {
        bar.set_length(sent.entries.saturating_add(sent.unsent));
        bar.set_position(sent.entries);
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
    let sent = sent.said()?;
    keep_heads(&access, [(reader.chain(), sent.head)], io);
    let entries = count(sent.entries);
    let number = sent.head.number;
    let server = access.address.to_string();
    io.note(CliRemark::Sent { entries, number, server });
    Ok(())
}

/// At most so many checks of all stations, what the server got last first.
pub(in crate::cli) fn list(
    address: &str,
    question: &Question,
    most: usize,
    io: &mut Io<'_>,
) -> Result<Vec<ListedEntry>, CliError> {
    let reader = ShopReader::open(&access(address, io)?, Patience::default(), &Stop::default()).said()?;
    let page = reader.page(question, None, most).said()?;
    if 0 < page.unread {
        io.remark(&CliRemark::Unread { entries: count(page.unread) });
    }
    Ok(page.rows.into_iter().map(|row| row.row).collect())
}

/// The checks of all stations, page by page.
pub(in crate::cli) struct Pages {
    reader: ShopReader,
    question: Question,
}

/// A server whose checks are asked for.
pub(in crate::cli) fn pages(address: &str, question: Question, io: &mut Io<'_>) -> Result<Pages, CliError> {
    let reader = ShopReader::open(&access(address, io)?, Patience::default(), &Stop::default()).said()?;
    Ok(Pages { reader, question })
}

impl Pages {
    /// Gives all of them to `take`, until that fails.
    ///
    /// # Errors
    /// Why the server could not be asked to the end.
    pub(in crate::cli) fn each(
        &self,
        most: usize,
        take: &mut dyn FnMut(ChainId, ListedEntry) -> std::io::Result<()>,
    ) -> Result<std::io::Result<()>, Message> {
        let mut after = None;
        loop {
            let page = self.reader.page(&self.question, after, most).map_err(|error| error.message())?;
            for shop::ShopRow { place, row, .. } in page.rows {
                if let Err(error) = take(place.chain, row) {
                    return Ok(Err(error));
                }
            }
            after = page.next;
            if after.is_none() {
                return Ok(Ok(()));
            }
        }
    }
}

/// Keeps what the server has now, so that it is missed when it is gone.
fn keep_heads(access: &Access, heads: impl IntoIterator<Item = (ChainId, Head)>, io: &mut Io<'_>) {
    let Some(path) = Anchors::of_servers() else { return };
    for (chain, head) in heads {
        if 0 < head.number
            && let Err(reason) = Anchors::keep_of_server(&path, &access.address.server(), chain, head)
        {
            return io.warn(&StoreRemark::NoAnchor { path, reason });
        }
    }
}

/// The last entry of each chain.
type Heads = Vec<(ChainId, Head)>;

/// What this computer knows of chains: those that the server had, and the journal of this station.
fn heads_here(access: &Access, io: &mut Io<'_>) -> (Heads, Heads) {
    let mut read = |path: Option<PathBuf>| {
        let path = path?;
        let told = |reason| {
            io.warn(&StoreRemark::NoAnchor { path: path.clone(), reason });
            io.look_first();
        };
        Anchors::read(&path).map_err(told).ok()
    };
    let sent = read(Anchors::of_servers()).map(|anchors| anchors.of_server(&access.address.server()));
    let own = own().ok().and_then(|file| read(Anchors::of_user())?.at(&file));
    // Without a file of anchors nothing is known of the server.
    (sent.unwrap_or_default(), own.map(|anchor| (anchor.chain, anchor.head)).into_iter().collect())
}

/// Looks at every chain, and at what the server is made of; whether there was something to look at, and all is as it was written.
pub(in crate::cli) fn verify(
    address: &str,
    known: &[(ChainId, Head)],
    is_json: bool,
    io: &mut Io<'_>,
) -> Result<bool, CliError> {
    let access = access(address, io)?;
    let (mut sent, own) = heads_here(&access, io);
    sent.extend(known);
    let bar = bar();
    let elsewhere = Elsewhere { sent: &sent, own: &own };
    let found = shop::verify_beside(&access, elsewhere, Patience::default(), &mut |done, all| {
        bar.set_length(all);
        bar.set_position(done);
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
    let found = found.said()?;
    if is_json {
        io.json(&Answer::of(&found));
    } else {
        print(&found, io);
    }
    if found.is_whole() {
        keep_heads(&access, found.chains.iter().map(|one| (one.chain, one.inspected.head)), io);
    }
    Ok(found.is_whole() && found.is_complete())
}

/// `1 entry`, `2 entries`.
fn entries(number: u64) -> String {
    if number == 1 { "1 entry".to_owned() } else { format!("{number} entries") }
}

fn print(found: &ShopVerified, io: &mut Io<'_>) {
    for ShopChain { chain, station, login, inspected, clock, compared, renamed } in &found.chains {
        let Head { number, hash } = inspected.head;
        if inspected.breaks.is_empty() {
            let are = if inspected.entries == 1 { "is as it was written" } else { "are as they were written" };
            let entries = entries(inspected.entries);
            let compared = compared.map_or("no entry of it is known here".to_owned(), |number| {
                format!("entry {number} is the one that is known here")
            });
            let last = format!("the last one is {number}:{hash}");
            writeln!(io.people(), "{station} ({chain}): {entries} {are}; {last}; {compared}");
        }
        if login.is_none() {
            writeln!(io.people(), "{station} ({chain}): the server does not know which login it belongs to");
        }
        if 0 < *renamed {
            let entries = entries(*renamed);
            writeln!(
                io.people(),
                "{station} ({chain}): {entries} listed under a different station from the recorded one"
            );
        }
        if let Some(Clock { newest_ms, least_ms, .. }) = clock {
            let newest = seconds(*newest_ms);
            let least = seconds(*least_ms);
            writeln!(
                io.people(),
                "{station} ({chain}): its newest entry was received {newest} s after the time on its clock; of the newest 500, \
                 the quickest {least} s after it"
            );
        }
        for one in &inspected.breaks {
            writeln!(io.people(), "{station} ({chain}): {one}");
        }
    }
    for (chain, Head { number, .. }) in &found.missing {
        writeln!(
            io.people(),
            "the chain {chain}, of which entry {number} is known elsewhere, is missing on the server"
        );
    }
    for (chain, Head { number, .. }, there) in &found.behind {
        let there = entries(*there);
        writeln!(
            io.people(),
            "this station's own journal ({chain}) ends with entry {number}, but the server has {there} of it: the rest was not \
             sent yet (run fitcheck journal send), or was removed there"
        );
    }
    for finding in &found.findings {
        writeln!(io.people(), "{finding}");
    }
    let journals = found.chains.len();
    let beside = found.chains.iter().filter(|one| one.compared.is_some()).count();
    if journals == 0 {
        writeln!(io.people(), "nothing was verified: the server has no entry of any journal");
    } else {
        let journals = if journals == 1 { "1 journal".to_owned() } else { format!("{journals} journals") };
        let entries = entries(found.entries());
        writeln!(io.people(), "{journals} with {entries} verified, {beside} compared with an entry that is known here");
    }
    match &found.not_compared {
        Some(why) => writeln!(
            io.people(),
            "functions, triggers, policies, grants, views and indexes were not compared with those of init-shop: {why}"
        ),
        None if found.findings.is_empty() => {
            writeln!(
                io.people(),
                "functions, triggers, policies, grants, views and indexes are as init-shop makes them"
            );
        }
        None => {}
    }
}

/// Milliseconds as seconds: `-3600.250`. Below zero the station's clock is ahead of the server's.
fn seconds(ms: i64) -> String {
    let sign = if ms < 0 { "-" } else { "" };
    let ms = ms.unsigned_abs();
    format!("{sign}{}.{:03}", ms / 1000, ms % 1000)
}

object! {
    struct Answer<'a> of(found: &'a ShopVerified) {
        whole: bool = found.is_whole(),
        complete: bool = found.is_complete(),
        entries: u64 = found.entries(),
        chains: Vec<ChainAnswer<'a>> = found.chains.iter().map(ChainAnswer::of).collect(),
        missing: Vec<String> = found.missing.iter().map(|(chain, _)| chain.to_string()).collect(),
        behind: Vec<Behind> = found.behind.iter().map(|(chain, _, there)| Behind::of(chain, *there)).collect(),
        not_compared: Option<String> = found.not_compared.as_ref().map(ToString::to_string),
        findings: Vec<String> = found.findings.iter().map(ToString::to_string).collect(),
    }

    struct ChainAnswer<'a> of(one: &'a ShopChain) {
        chain: String = one.chain.to_string(),
        station: &'a str = &one.station,
        login: Option<&'a str> = one.login.as_deref(),
        clock: Option<ClockAnswer> = one.clock.as_ref().map(ClockAnswer::of),
        entries: u64 = one.inspected.entries,
        known_here: Option<u64> = one.compared,
        renamed: u64 = one.renamed,
        #[serde(flatten)]
        inspected: InspectedAnswer = InspectedAnswer::of(&one.inspected),
    }

    struct ClockAnswer of(clock: &Clock) {
        newest_ms: i64 = clock.newest_ms,
        least_ms: i64 = clock.least_ms,
    }

    struct Behind of(chain: &ChainId, there: u64) {
        chain: String = chain.to_string(),
        entries: u64 = there,
    }
}
