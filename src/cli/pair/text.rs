//! The answer for people: what was found in a sentence, then tables.

use std::io::{Result, Write};

use crate::cli::people::Side::{self, Left, Right};
use crate::cli::people::{Aligned, mm, negative, range, um};
use crate::exchange::Size;
use crate::pairing::{Grinding, Group, Groups, Pair, PairClearances};
use crate::report::pairing::{PairingAnswer, PairingParts, PairingRequest};

pub(super) fn write(answer: &PairingAnswer, out: &mut dyn Write) -> Result<()> {
    let PairingAnswer { asked: PairingRequest { holes, shafts, wanted, fit, .. }, pairing, .. } = answer;
    let fit = fit.as_ref().map_or(String::new(), |(callout, _)| format!("{callout}, "));
    let negative = negative(wanted.minimum());
    writeln!(
        out,
        "{}, {}, {fit}wanted clearance {}{negative}: {}",
        counted(holes.sizes.len(), "hole"),
        counted(shafts.sizes.len(), "shaft"),
        range(wanted.minimum(), wanted.maximum()),
        counted(pairing.pairs.len(), "pair"),
    )?;
    let refused = holes.errors.len() + shafts.errors.len();
    if 0 < refused {
        writeln!(out, "{} refused", counted(refused, "row"))?;
    }
    if let Some((smallest, largest)) = answer.clearances() {
        let band = um(pairing.band);
        writeln!(out, "clearances {}, in a band of {band} µm around the middle", range(smallest, largest))?;
        writeln!(out)?;
        pairs(out, answer, &pairing.pairs)?;
    }
    leftovers(out, answer)?;
    if let Some(groups) = answer.groups() {
        writeln!(out)?;
        sorted(out, groups, *wanted)?;
    }
    Ok(())
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// The name of a part, or its line where it has none.
fn name(part: &Size) -> String {
    if part.id.is_empty() { format!("line {}", part.line) } else { part.id.replace(char::is_control, "\u{fffd}") }
}

const fn simulated(part: &Size, what: &'static str) -> &'static str {
    if part.is_simulated { what } else { "" }
}

fn pairs(out: &mut dyn Write, answer: &PairingAnswer, pairs: &[Pair]) -> Result<()> {
    let row = |pair: &Pair| {
        let hole = answer.asked.holes.sizes.get(pair.hole)?;
        let shaft = answer.asked.shafts.sizes.get(pair.shaft)?;
        let notes = [simulated(hole, "hole simulated"), simulated(shaft, "shaft simulated")];
        let notes = notes.into_iter().filter(|note| !note.is_empty()).collect::<Vec<_>>().join(", ");
        let clearance = pair.clearance.signed_um();
        Some([name(hole), mm(hole.measured), name(shaft), mm(shaft.measured), clearance, notes])
    };
    let rows: Vec<_> = pairs.iter().filter_map(row).collect();
    let columns = [("hole", Left), ("mm", Right), ("shaft", Left), ("mm", Right), ("clearance µm", Right), ("", Left)];
    table(out, columns, &rows)
}

fn leftovers(out: &mut dyn Write, answer: &PairingAnswer) -> Result<()> {
    let PairingAnswer { asked: PairingRequest { holes, shafts, .. }, pairing, .. } = answer;
    if pairing.holes.is_empty() && pairing.shafts.is_empty() {
        return Ok(());
    }
    let hole_count = counted(pairing.holes.len(), "hole");
    let shaft_count = counted(pairing.shafts.len(), "shaft");
    writeln!(out)?;
    writeln!(out, "left over: {hole_count}, {shaft_count}")?;
    let left = |what: &'static str, parts: &PairingParts, positions: &[usize]| -> Vec<[String; 4]> {
        let parts = positions.iter().filter_map(|&at| parts.sizes.get(at));
        let row = |part: &Size| [what.into(), name(part), mm(part.measured), simulated(part, "simulated").into()];
        parts.map(row).collect()
    };
    let mut rows = left("hole", holes, &pairing.holes);
    rows.extend(left("shaft", shafts, &pairing.shafts));
    table(out, [("part", Left), ("name", Left), ("mm", Right), ("", Left)], &rows)?;
    answer.grinding.as_ref().map_or(Ok(()), |grinding| ground(out, answer, grinding))
}

fn ground(out: &mut dyn Write, answer: &PairingAnswer, grinding: &Grinding) -> Result<()> {
    let bounded = if grinding.is_bounded() {
        format!(
            "; only amounts up to {} µm were tried, the farthest would need {} µm",
            um(grinding.tried),
            um(grinding.reach)
        )
    } else {
        String::new()
    };
    writeln!(out)?;
    let Some(best) = &grinding.best else {
        return writeln!(out, "grinding saves none of them{bounded}");
    };
    let amount = um(best.amount);
    let count = best.pairs.len();
    let more = if count == 1 { "1 more pair".to_owned() } else { format!("{count} more pairs") };
    writeln!(
        out,
        "{amount} µm off the leftover shafts, or out of the leftover holes, saves the most: {more}{bounded}"
    )?;
    writeln!(out, "clearances after grinding:")?;
    pairs(out, answer, &best.pairs)
}

fn sorted(out: &mut dyn Write, groups: &Groups, wanted: PairClearances) -> Result<()> {
    let row = |(number, group): (usize, &Group)| {
        let within = match group.all_within(wanted) {
            Some(true) => "all within",
            Some(false) => "not all within",
            None => "no pairs",
        };
        let sizes = |from, to| format!("{} … {}", mm(from), mm(to));
        [
            number.to_string(),
            sizes(group.hole_range.from, group.hole_range.to),
            group.holes.to_string(),
            sizes(group.shaft_range.from, group.shaft_range.to),
            group.shafts.to_string(),
            group.pairs().to_string(),
            group.clearances.map_or(String::new(), |(smallest, largest)| range(smallest, largest)),
            within.to_owned(),
        ]
    };
    let rows: Vec<_> = (1..).zip(&groups.all).map(row).collect();
    let columns = [
        ("group", Right),
        ("holes from … to mm", Left),
        ("count", Right),
        ("shafts from … to mm", Left),
        ("count", Right),
        ("pairs", Right),
        ("clearance", Left),
        ("", Left),
    ];
    table(out, columns, &rows)?;
    match groups.outside() {
        (0, 0) => Ok(()),
        (holes, shafts) => {
            writeln!(out, "outside the zones, in no group: {}, {}", counted(holes, "hole"), counted(shafts, "shaft"))
        }
    }
}

fn table<const N: usize>(out: &mut dyn Write, columns: [(&'static str, Side); N], rows: &[[String; N]]) -> Result<()> {
    Aligned { columns, widest: usize::MAX }.lines(rows).try_for_each(|line| writeln!(out, "{line}"))
}
