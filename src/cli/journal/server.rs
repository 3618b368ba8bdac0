//! The server of a shop, asked from the command line.

use std::ops::ControlFlow;
use std::path::Path;

use serde_json::json;

use super::verify::bar;
use super::{CliError, CliRemark, Io, Refused as _};
use crate::journal::ask::Question;
use crate::journal::chain::{ChainId, Head};
use crate::journal::inspection::Break;
use crate::message::{Message, Say as _};
use crate::store::local::{Reader, Row};
use crate::store::shop::{
    self, Access, Clock, Patience, Places, ShopAddress, ShopChain, ShopReader, ShopVerified, Stop,
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

/// Makes the tables.
pub(in crate::cli) fn init(address: &str, io: &mut Io<'_>) -> Result<(), CliError> {
    let made = shop::init(&access(address, io)?, Patience::default()).said()?;
    io.tell(made);
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
    let (entries, number, server) = (count(sent.entries), sent.head.number, access.address.to_string());
    io.tell(CliRemark::Sent { entries, number, server });
    Ok(())
}

/// At most so many checks of all stations, what the server got last first.
pub(in crate::cli) fn list(
    address: &str,
    question: &Question,
    most: usize,
    io: &mut Io<'_>,
) -> Result<Vec<Row>, CliError> {
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
        take: &mut dyn FnMut(ChainId, Row) -> std::io::Result<()>,
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

/// Looks at every chain; whether all is as it was written.
pub(in crate::cli) fn verify(
    address: &str,
    known: &[(ChainId, Head)],
    is_json: bool,
    io: &mut Io<'_>,
) -> Result<bool, CliError> {
    let access = access(address, io)?;
    // What this computer has seen of a chain may not be sent yet, so only what is given is compared.
    let bar = bar();
    let found = shop::verify(&access, known, Patience::default(), &mut |done, all| {
        bar.set_length(all);
        bar.set_position(done);
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
    let found = found.said()?;
    if is_json {
        print_json(&found, io)?;
    } else {
        print(&found, io)?;
    }
    Ok(found.is_whole())
}

fn print(found: &ShopVerified, io: &mut Io<'_>) -> Result<(), CliError> {
    for ShopChain { chain, station, inspected, clock, .. } in &found.chains {
        let Head { number, hash } = inspected.head;
        if inspected.breaks.is_empty() {
            let entries = inspected.entries;
            writeln!(
                io.people(),
                "{station} ({chain}): {entries} entries are as they were written; the last one is {number}:{hash}"
            )?;
        }
        if let Some(Clock { newest_ms, least_ms, .. }) = clock {
            let (newest, least) = (seconds(*newest_ms), seconds(*least_ms));
            writeln!(
                io.people(),
                "{station} ({chain}): its newest entry was received {newest} s after the time on its clock, of the newest 500 \
                 the quickest {least} s after it"
            )?;
        }
        for one in &inspected.breaks {
            writeln!(io.people(), "{station} ({chain}): {one}")?;
        }
    }
    for (chain, Head { number, .. }) in &found.missing {
        writeln!(io.people(), "the chain {chain}, of which entry {number} is known elsewhere, is not there")?;
    }
    for finding in &found.findings {
        writeln!(io.people(), "{finding}")?;
    }
    Ok(())
}

/// Milliseconds as seconds: `-3600.250`. Below zero the station's clock is ahead of the server's.
fn seconds(ms: i64) -> String {
    let (sign, ms) = (if ms < 0 { "-" } else { "" }, ms.unsigned_abs());
    format!("{sign}{}.{:03}", ms / 1000, ms % 1000)
}

fn print_json(found: &ShopVerified, io: &mut Io<'_>) -> Result<(), CliError> {
    let chain = |one: &ShopChain| {
        let breaks = one.inspected.breaks.iter();
        let breaks: Vec<_> = breaks.map(|one| json!({"number": one.number(), "what": one.to_string()})).collect();
        json!({
            "chain": one.chain.to_string(),
            "station": one.station,
            "login": one.login,
            "clock": one.clock.as_ref().map(|clock| json!({"newest_ms": clock.newest_ms, "least_ms": clock.least_ms})),
            "entries": one.inspected.entries,
            "head": {"number": one.inspected.head.number, "hash": one.inspected.head.hash.to_string()},
            "first_bad": one.inspected.breaks.first().map(Break::number),
            "break_count": one.inspected.count,
            "breaks": breaks,
        })
    };
    io.json(&json!({
        "whole": found.is_whole(),
        "chains": found.chains.iter().map(chain).collect::<Vec<_>>(),
        "missing": found.missing.iter().map(|(chain, _)| chain.to_string()).collect::<Vec<_>>(),
        "findings": found.findings.iter().map(ToString::to_string).collect::<Vec<_>>(),
    }))
}
