//! What cycles 408 and 409 share: the centre line of a slot or ridge becomes the datum of one axis; the other axes stay.
//!
//! Two contacts on the measured axis through the nominal centre, the one in plus direction of it first: which wall comes first is on no
//! page. Q157 and Q166 are remembered; Q166 is the width here, where 425 has its deviation.

use super::datum_cycle::{NEW_ALONG, axis, set, target};
use super::judged::between;
use super::probed::{self, coordinate, met};
use super::walls_probing::About;
use super::width_cycle::{self, WIDTH, along_axis};
use crate::probing::cycle::{Course, CycleError, Inputs, Measured, Parameter, ResultName, ResultParameter, Texts};
use crate::probing::simulated::Surface;
use crate::tolerance::Feature;

/// The nominal width under the name that the cycle has for it.
pub(super) const fn width(name: &'static str, names: Texts, questions: Texts) -> Parameter {
    Parameter { name, ..WIDTH }.named(names).asked(questions)
}

const fn about(feature: Feature) -> About {
    About { feature, centre: [321, 322] }
}

/// The walls at nominal width.
pub(super) fn surface(feature: Feature, inputs: &Inputs) -> Surface {
    let [x, y, _] = about(feature).centre(inputs);
    width_cycle::surface(feature, [x, y], inputs)
}

/// Runs either cycle on checked inputs.
pub(super) fn run(feature: Feature, inputs: &Inputs, course: &mut Course<'_>) -> Result<Measured, CycleError> {
    let target = target(inputs)?;
    let plus = along_axis(inputs);
    let mut contacts = Vec::new();
    for outwards in [plus, plus.map(|part| -part)] {
        let touch = about(feature).touch(inputs, course.ball_radius(), outwards, inputs.mm(WIDTH.key));
        // A ridge stands between its two contacts: 409 has no Q301 and goes over the clearance height.
        if contacts.is_empty() || inputs.whole(301) == 1 || feature == Feature::Shaft {
            course.pre_position_from_above(touch.from, inputs.mm(260));
        } else {
            course.pre_position(touch.from);
        }
        contacts.push(met(&touch, course)?);
    }
    course.leave(inputs.mm(260));
    let [one, other] = [0, 1].map(|number: usize| contacts.get(number).map_or(0.0, |met| coordinate(met, inputs)));
    let (width, centre_line) = between(one, other)?;
    let results = vec![
        ResultParameter::length(166, ResultName::WIDTH, width),
        ResultParameter::length(157, ResultName::CENTRE_LINE, centre_line),
    ];
    let axes = vec![axis(probed::axis(inputs), centre_line, inputs, NEW_ALONG.key)];
    set(target, (contacts, results, axes), inputs, course)
}
