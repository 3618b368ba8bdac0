//! Features without a class, such as `35 +0.2/0`: their limits stand in the main program, and no table is read.
//!
//! The called program knows both ways by its QS1: a class begins with a letter, deviations begin with a sign or a digit,
//! and those sort before all letters. Only a program that measures a feature without a class has these blocks.
//!
//! | parameter of the set | what |
//! |---|---|
//! | QS1 | upper and lower deviation in place of the class: what the window shows behind the nominal size |
//! | Q2 | -1 hole, +1 shaft, which a class says by its letter |
//! | Q23, Q33 | maximum and minimum; of a pocket or boss along X |
//! | Q74, Q84 | those of a pocket or boss along Y |
//! | Q24 | whether QS1 is a class |

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Callout, Feature, Limits};

use super::Planned;
use super::blocks::{Blocks, MINIMUM, blocks as read, number, parts, shipped_program};
use super::names::Names;
use crate::control::variables::Parameter;
use crate::program::Body;

/// Hole or shaft.
const SIDE: Parameter = Parameter::q(2);

/// Maximum and minimum of each side.
const LIMITS: [[Parameter; 2]; 2] = [[Parameter::q(23), MINIMUM], [Parameter::q(74), Parameter::q(84)]];

/// Passes the search of the tables where QS1 is no class.
const PASS: &[u8] = b"DECLARE STRING QS3 = \"A\"
Q24 = STRCOMP ( SRC_QS1 SEA_QS3 ) ;-1 = +/-
FN 9: IF +Q24 EQU -1 GOTO LBL 92
";

/// The limits of the second side of a pocket or boss, where it has no class.
pub(super) const SECOND: &str = "DECLARE STRING QS3 = \"A\"
Q24 = STRCOMP ( SRC_QS1 SEA_QS3 ) ;-1 = +/-
FN 9: IF +Q24 EQU -1 GOTO LBL 93
FN 9: IF +0 EQU +0 GOTO LBL 94
LBL 93
Q23 = Q74
Q33 = Q84
LBL 94
";

/// Whether a size has no class.
pub(super) const fn is_given(callout: &Callout) -> bool {
    callout.class().is_none()
}

/// Whether a size of a feature has no class.
pub(super) fn has_given(planned: &Planned<'_>) -> bool {
    planned.sizes().any(|(callout, _)| is_given(&callout))
}

/// The class of a size, or its deviations in mm: `H7`, `+0.2/0`; in a text that a cycle takes `+0.2-0`. Programs are ASCII, so there is
/// no `±`.
pub(super) fn tolerance(callout: &Callout, limits: &Limits, is_text: bool) -> String {
    let signed = |length: Length| if Length::ZERO < length { format!("+{length}") } else { length.to_string() };
    let [upper, lower] = [limits.deviations.upper(), limits.deviations.lower()];
    match callout.class() {
        Some(class) => class.to_string(),
        None if is_text => {
            let zero = |length: Length, sign: &str| {
                if length == Length::ZERO { sign.to_owned() + "0" } else { signed(length) }
            };
            format!("{}{}", zero(upper, "+"), zero(lower, "-"))
        }
        None => format!("{}/{}", signed(upper), signed(lower)),
    }
}

/// What a feature asks for, as its heading says it.
pub(super) fn asked(planned: Planned<'_>) -> String {
    if !has_given(&planned) {
        return planned.feature.kind.asked();
    }
    let size = |(callout, limits): (Callout, &Limits)| {
        format!("{} {}", callout.nominal(), tolerance(&callout, limits, planned.by_text))
    };
    planned.sizes().map(size).collect::<Vec<_>>().join(" x ")
}

/// The blocks of the main program that give the limits of a feature; none where it has classes.
pub(super) fn blocks(names: &Names<'_>, planned: Planned<'_>) -> Blocks {
    let called = shipped_program("82551", names.target.language);
    let comment = |of: Parameter| {
        let mut assigned = called.iter().filter(|(body, _)| matches!(body, Body::Assign { to, .. } if *to == of));
        assigned.next().map_or_else(String::new, |(_, comment)| comment.clone())
    };
    let mut made = Blocks::new();
    for ((_, limits), to) in planned.sizes().zip(LIMITS).filter(|((callout, _), _)| is_given(callout)) {
        let side = limits.feature.map(|feature| if feature == Feature::Hole { -1.0 } else { 1.0 });
        if let Some(side) = side.filter(|_| made.is_empty()) {
            made.push(number(SIDE, side, comment(SIDE)));
        }
        let values = [limits.maximum(), limits.minimum()];
        // Those of the second side are named as those of the first.
        let named = to.into_iter().zip(values).zip(LIMITS.concat());
        made.extend(named.map(|((to, value), first)| number(to, value.to_mm_f64(), comment(first))));
    }
    made
}

/// The called program with a way round the search of the tables.
pub(super) fn or_table(made: Blocks) -> Blocks {
    let [title, lookup, measure] = parts(made);
    let is_minimum = |(body, _): &(Body, String)| matches!(body, Body::Assign { to, .. } if *to == MINIMUM);
    let both = lookup.iter().position(is_minimum).map_or(lookup.len(), |at| at + 1);
    // Behind the heading.
    let mut found = lookup;
    let nominal = found.split_off(both);
    let search = found.split_off(found.len().min(1));
    [title, found, read(PASS), search, read(b"LBL 92\n"), nominal, measure].into_iter().flatten().collect()
}
