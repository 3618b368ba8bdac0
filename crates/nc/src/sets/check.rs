//! The called programs of a set: the built-in 82551 with other paths, for TNC7 a nominal size between the limits, and the
//! cycle of the shape.
//!
//! A pocket or boss finds the limits of its two sides one after the other by the same blocks, which become a subprogram
//! for it. Where a feature has no class, its limits are those of the main program (see `given`). A point has its band from the main
//! program and finds none; its cycle says good, rework or scrap in a parameter of its own.

use fitcheck_core::tolerance::Feature;

use super::blocks::{Blocks, MINIMUM, bare, blocks, parts, print, shipped_program, written};
use super::called::{self, Called};
use super::given;
use super::names::Names;
use crate::control::variables::Parameter;
use crate::program::{Body, Condition, CycleValue, Operand};

/// The nominal diameter of the cycles.
const NOMINAL_DIAMETER: Parameter = Parameter::q(262);

/// The parameter that replaces it if it must lie between the limits.
const BETWEEN: Parameter = Parameter::q(62);

/// Q62 becomes the nominal size or, if that lies outside, the limit next to it (TNC7 manual 81762x-19, cycle 421).
const BETWEEN_LIMITS: &[u8] = b"Q62 = Q1 ;Q33 <= Q62 <= Q23
FN 11: IF +Q62 GT +Q33 GOTO LBL 97
Q62 = Q33
LBL 97
FN 12: IF +Q62 LT +Q23 GOTO LBL 98
Q62 = Q23
LBL 98
";

/// No tolerance: set before a cycle that says its status, so that nothing stale says good where a control does not set it.
const UNKNOWN_STATUS: &[u8] = b"Q183 = - 1\n";

/// The callout of the window.
const CHECKED: Parameter = Parameter::qs(2);

/// The texts that it is made of: the blank, and the nominal size.
const BLANK: Parameter = Parameter::qs(4);
const NOMINAL_TEXT: Parameter = Parameter::qs(5);

/// The program that measures a kind of feature; with `has_given` also those without a class.
pub(super) fn check(names: &Names<'_>, called: Called, has_given: bool) -> Vec<u8> {
    let made = adapted(names, called);
    let made = if has_given { given::or_table(made) } else { made };
    let made = match called {
        Called::Diameter if names.target.by_text => by_own_status(made),
        Called::Diameter | Called::Width | Called::Face => made,
        Called::Rectangle => two_sides(made, nominal(names), if has_given { given::SECOND } else { "" }),
        Called::Point => without_limits(made),
    };
    written(names.check(called), &made)
}

/// The parameter that the cycle gets as its nominal size.
const fn nominal(names: &Names<'_>) -> &'static str {
    if names.target.control.wants_nominal_between_limits() { called::BETWEEN } else { called::NOMINAL }
}

/// The built-in program with the paths, the mask and the cycle of the set.
fn adapted(names: &Names<'_>, called: Called) -> Blocks {
    let mut cycles = [Feature::Hole, Feature::Shaft].into_iter();
    let is_by_text = names.target.by_text && called == Called::Diameter;
    let moves_nominal = names.target.control.wants_nominal_between_limits() && !is_by_text;
    let mut made = Blocks::new();
    let mut tables = [Feature::Hole, Feature::Shaft].into_iter();
    for (body, comment) in shipped_program("82551", names.target.language) {
        match body {
            Body::TableOpen(_) => {
                let table = tables.next().map_or("", |feature| names.table(feature));
                made.push(bare(Body::TableOpen(names.operand(table))));
            }
            Body::Print { .. } => made.push(print(names, called, "SCREEN:".to_owned())),
            Body::Probe(_) if is_by_text => {
                let feature = cycles.next().unwrap_or(Feature::Shaft);
                made.extend(blocks(&called::blocks_by_text(feature, names.target.language)));
            }
            Body::Probe(_) if called != Called::Diameter => {
                let feature = cycles.next().unwrap_or(Feature::Shaft);
                made.extend(blocks(&called.blocks(feature, nominal(names), names.target.language)));
            }
            Body::Probe(mut cycle) if moves_nominal => {
                for line in cycle.lines.iter_mut().filter(|line| line.parameter == NOMINAL_DIAMETER.into()) {
                    let value = Operand::Parameter { parameter: BETWEEN, is_negative: false };
                    line.value = CycleValue::Number { value, text: format!("+{BETWEEN}") };
                }
                made.push((Body::Probe(cycle), comment));
            }
            Body::Assign { to, .. } if moves_nominal && to == MINIMUM => {
                made.push((body, comment));
                made.extend(blocks(BETWEEN_LIMITS));
            }
            body => made.push((body, comment)),
        }
    }
    made
}

/// Finds the limits of the first side, keeps them, and finds those of the second.
fn two_sides(made: Blocks, nominal: &str, given: &str) -> Blocks {
    let [title, lookup, rest] = parts(made);
    let both = format!(
        "CALL LBL 90
Q72 = {nominal}
Q73 = Q23
Q83 = Q33
QS5 = TOCHAR ( DAT+Q1 )
DECLARE STRING QS4 = \" \"
QS7 = QS5 || QS4 || QS1
Q1 = Q71
QS1 = QS6
{given}CALL LBL 90
FN 9: IF +0 EQU +0 GOTO LBL 91
LBL 90
"
    );
    let is_callout = |body: &Body| matches!(body, Body::AssignText { to, .. } if *to == CHECKED);
    // The first assignment is the letter that tells holes from shafts.
    let window = rest.into_iter().flat_map(|(body, comment)| {
        if is_callout(&body) {
            blocks(b"DECLARE STRING QS8 = \" x \"\nQS2 = QS7 || QS8 || QS5 || QS4 || QS1\n")
        } else {
            vec![(body, comment)]
        }
    });
    let all = [title, blocks(both.as_bytes()), lookup, blocks(b"LBL 0\nLBL 91\n")].into_iter().flatten();
    all.chain(window).collect()
}

/// Measures without a table: with one cycle instead of two, and by the status that this cycle has.
fn without_limits(made: Blocks) -> Blocks {
    let [title, _lookup, rest] = parts(made);
    let before = rest.iter().take_while(|(body, _)| !matches!(body, Body::Jump { .. }));
    // Without a measurement nothing is left, and no set passes its proof.
    let probe = rest.iter().rposition(|(body, _)| matches!(body, Body::Probe(_))).unwrap_or(rest.len());
    let after = rest.iter().skip(probe);
    let is_kept = |(body, _): &&(Body, String)| {
        let texts = [CHECKED, BLANK, NOMINAL_TEXT];
        !matches!(body, Body::AssignText { to, .. } if texts.contains(to))
    };
    let after = after.filter(is_kept).map(|(body, comment)| (own_status(body), comment.clone()));
    title.into_iter().chain(before.cloned()).chain(blocks(UNKNOWN_STATUS)).chain(after).collect()
}

/// Goes by the status that a cycle has of its own, and by no markers.
fn by_own_status(made: Blocks) -> Blocks {
    let [title, lookup, rest] = parts(made);
    let mut rest = rest.into_iter().map(|(body, comment)| (own_status(&body), comment));
    let heading: Blocks = rest.by_ref().take(1).collect();
    [title, lookup, heading, blocks(UNKNOWN_STATUS)].into_iter().flatten().chain(rest).collect()
}

/// Q183 in place of the markers Q180 to Q182: 0 good, 1 rework, 2 scrap.
fn own_status(body: &Body) -> Body {
    let Body::Jump { condition: Condition::Compare(Operand::Parameter { parameter, is_negative }, relation, _), label } =
        body
    else {
        return body.clone();
    };
    let status =
        [180, 181, 182].into_iter().zip([0.0, 1.0, 2.0]).find(|(marker, _)| Parameter::q(*marker) == *parameter);
    let Some((_, status)) = status else { return body.clone() };
    let own = Operand::Parameter { parameter: Parameter::q(183), is_negative: *is_negative };
    Body::Jump { condition: Condition::Compare(own, *relation, Operand::Number(status)), label: label.clone() }
}
