//! The main program of a set.

use fitcheck_core::length::Length;
use fitcheck_core::part::{self, FeatureKind};
use fitcheck_core::probing::cycle::{Axis, Key, Meaning};
use fitcheck_core::tolerance::Callout;

use super::blocks::{Blocks, bare, number, print, shipped_program, written};
use super::called::Called;
use super::error::SetRemark;
use super::names::{Control, Names};
use super::{Planned, given};
use crate::control::variables::Parameter;
use crate::program::{Body, TextExpression, TextOperand};

/// The class, or the band of a point.
const CLASS: Parameter = Parameter::qs(1);

/// The blocks of the built-in program: those before the parameters of a feature, those of a feature, and those behind its stop.
pub(super) fn built_in(names: &Names<'_>) -> [Blocks; 3] {
    let blocks = shipped_program("8255", names.target.language);
    // Blocks that occur only once are before the first parameter or after the stop.
    let is_parameter = |(body, _): &(Body, String)| matches!(body, Body::Assign { .. } | Body::AssignText { .. });
    let first = blocks.iter().take_while(|block| !is_parameter(block)).count();
    let behind = blocks.iter().position(|(body, _)| matches!(body, Body::Stop(_))).map_or(first, |at| at + 1);
    let (head, rest) = blocks.split_at(first);
    let (each, tail) = rest.split_at(behind - first);
    [head, each, tail].map(<[_]>::to_vec)
}

/// The main program: for each feature its parameters, the call, a file with its result, and a stop.
pub(super) fn main(names: &Names<'_>, planned: &[Planned<'_>]) -> Vec<u8> {
    let [mut made, each, tail] = built_in(names);
    for planned in planned {
        made.push(heading(*planned));
        made.extend(each.iter().flat_map(|block| main_block(block, names, *planned)));
    }
    made.extend(tail);
    written(&names.main, &made)
}

/// The heading of a feature: its name, and what it asks for.
pub(super) fn heading(planned: Planned<'_>) -> (Body, String) {
    let text = format!("{}: {}", planned.feature.name, given::asked(planned));
    bare(Body::Heading { depth: 2, text })
}

/// A block of the main program for a feature.
pub(super) fn main_block((body, comment): &(Body, String), names: &Names<'_>, planned: Planned<'_>) -> Blocks {
    let feature = planned.feature;
    let [x, y, z] = planned.place;
    let comment = comment.replace(Control::Itnc530.clearance(), names.target.control.clearance());
    let one = |to: Parameter, value: f64| vec![number(to, value, comment.clone())];
    match body {
        Body::Assign { to, .. } => match to.number {
            // A point has no nominal size.
            1 => feature.kind.callouts().first().map_or_else(Blocks::new, |callout| one(*to, nominal(*callout))),
            11 => one(*to, x.to_mm_f64()),
            21 => one(*to, y.to_mm_f64()),
            31 => one(*to, z.to_mm_f64()),
            41 if matches!(feature.kind, FeatureKind::Diameter(_)) => one(*to, feature.angle.to_degrees_f64()),
            41 => direction_blocks(*to, names, &feature.kind),
            51 => one(*to, feature.clearance.to_mm_f64()),
            _ => one(*to, feature.clearance_height.to_mm_f64()),
        },
        Body::AssignText { .. } => {
            let class = class_blocks(names, planned, comment);
            class.into_iter().chain(given::blocks(names, planned)).collect()
        }
        Body::CallProgram(_) => {
            let result = names.path(&names.result(&feature.name));
            let Some(called) = Called::of(&feature.kind) else { return Blocks::new() };
            vec![bare(Body::CallProgram(names.operand(names.check(called)))), print(names, called, result)]
        }
        body => vec![(body.clone(), comment)],
    }
}

fn nominal(callout: Callout) -> f64 {
    callout.nominal().to_mm_f64()
}

fn text(to: Parameter, value: String, comment: String) -> (Body, String) {
    (Body::AssignText { to, value: TextExpression::Value(TextOperand::Text(value)) }, comment)
}

/// The class, or deviations; of a pocket or boss also nominal size and class of the second side, of a point the band.
fn class_blocks(names: &Names<'_>, planned: Planned<'_>, comment: String) -> Blocks {
    let language = names.target.language;
    let class = |side: usize| {
        let size = planned.sizes().nth(side);
        size.map_or_else(String::new, |(callout, limits)| given::tolerance(&callout, limits, planned.by_text))
    };
    match &planned.feature.kind {
        FeatureKind::Diameter(_) | FeatureKind::Width(..) | FeatureKind::Face(..) => {
            vec![text(CLASS, class(0), comment)]
        }
        FeatureKind::Pocket([_, second]) | FeatureKind::Boss([_, second]) => {
            let name = Called::Rectangle.name_of(&[Meaning::Side(Axis::Second)], language);
            vec![
                text(CLASS, class(0), comment.clone()),
                number(Parameter::q(71), nominal(*second), name),
                text(Parameter::qs(6), class(1), comment),
            ]
        }
        FeatureKind::Point(band, _) => {
            vec![text(CLASS, part::band_text(*band), Called::Point.name_of(&[Meaning::Band], language))]
        }
        FeatureKind::Length(_) | FeatureKind::Form(_) => Blocks::new(),
    }
}

/// In place of the angle: the measured axis, and for a face the direction; for a point the normal.
fn direction_blocks(to: Parameter, names: &Names<'_>, kind: &FeatureKind) -> Blocks {
    let Some(called) = Called::of(kind) else { return Blocks::new() };
    let named = |meanings: &[Meaning]| called.name_of(meanings, names.target.language);
    let axis = |vector: [f64; 3]| {
        let [x, y, z] = vector.map(f64::abs);
        number(to, x + 2.0 * y + 3.0 * z, named(&[Meaning::AxisOfPlane, Meaning::MeasuredAxis]))
    };
    match kind {
        FeatureKind::Diameter(_)
        | FeatureKind::Pocket(_)
        | FeatureKind::Boss(_)
        | FeatureKind::Length(_)
        | FeatureKind::Form(_) => Blocks::new(),
        FeatureKind::Width(_, across) => vec![axis(across.vector())],
        FeatureKind::Face(_, towards) => {
            let sign = if towards.is_plus { 1.0 } else { -1.0 };
            vec![axis(towards.vector()), number(Parameter::q(42), sign, named(&[Meaning::Direction]))]
        }
        FeatureKind::Point(_, direction) => {
            let axes = [(41, Axis::First), (42, Axis::Second), (43, Axis::Third)];
            let parts = direction.normal().into_iter().zip(axes);
            let part = |(part, (to, axis))| number(Parameter::q(to), part, named(&[Meaning::Normal(axis)]));
            parts.map(part).collect()
        }
    }
}

/// The nominal sizes that the called program passes to the cycle, where they differ from those of the callouts.
pub(super) fn moved_nominals(planned: Planned<'_>, control: Control) -> Vec<SetRemark> {
    // What the cycle calls the nominal size, and the result that counts from it; a coordinate has no nominal size.
    let sizes: &[(Meaning, u16)] = match Called::of(&planned.feature.kind) {
        // A text has its own middle.
        Some(Called::Diameter) if planned.by_text => &[],
        Some(Called::Diameter) => &[(Meaning::Diameter, 163)],
        Some(Called::Width) => &[(Meaning::Width, 166)],
        Some(Called::Rectangle) => &[(Meaning::Side(Axis::First), 164), (Meaning::Side(Axis::Second), 165)],
        Some(Called::Face | Called::Point) | None => &[],
    };
    let callouts = planned.feature.kind.callouts();
    let sides = callouts.into_iter().zip(planned.limits).zip(sizes);
    let moved = sides.filter_map(|((callout, limits), (meaning, deviation))| {
        let cycle = Called::of(&planned.feature.kind)?.cycle(limits.feature?)?;
        let parameter = cycle.meant(*meaning)?.key;
        let value: Length = limits.nominal.max(limits.minimum()).min(limits.maximum());
        (control.wants_nominal_between_limits() && value != limits.nominal).then(|| SetRemark::MovedNominal {
            name: planned.feature.name.clone(),
            callout,
            value,
            parameter,
            deviation: Key::Q(*deviation),
        })
    });
    moved.collect()
}
