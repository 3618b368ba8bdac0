//! What cycles 421 and 422 share: three or four contacts on a circle, centre and diameter by least squares.
//!
//! Parameters, ranges and results as in the control's cycle manuals (TNC 320 and TNC7, cycles 421 and 422). How the
//! control itself fits four contacts is not published; geometric least squares is our choice.

use crate::length::Length;
use crate::probing::circle::least_squares;
use crate::probing::contact::{Prober, Touch};
use crate::probing::cycle::{Angle, CycleError, CycleResult, Inputs, Parameter, QUARTER_TURN, Range, Value};
use crate::tolerance::Feature;
use crate::verdict::{AxisPosition, PositionVerdict, Status, classify};

/// The probe's own set-up clearance, mm, that Q320 is added to (`SET_UP` of the touch-probe table).
const SET_UP: f64 = 2.0;

/// The name of Q262.
const NOMINAL_DIAMETER: &str = "NOMINAL DIAMETER";

/// The step between three contacts when Q247 is not given: 90 degrees would leave half the circle unseen.
const STEP_OF_THREE: Angle = Angle::from_degrees(120);

/// What differs between hole and stud.
pub(super) struct Side {
    pub(super) feature: Feature,
    /// The Q number of the maximum dimension.
    pub(super) maximum: u16,
    /// The Q number of the minimum dimension.
    pub(super) minimum: u16,
}

/// The declaration, in the order of NC programs.
pub(super) const fn parameters(side: &Side) -> [Parameter; 18] {
    [
        Parameter::coordinate(273, "CENTER IN 1ST AXIS"),
        Parameter::coordinate(274, "CENTER IN 2ND AXIS"),
        Parameter::size(262, NOMINAL_DIAMETER),
        Parameter::angle(325, "STARTING ANGLE", 360, 0).or(0),
        Parameter::angle(247, "STEPPING ANGLE", 120, 5).or(QUARTER_TURN),
        Parameter::coordinate(261, "MEASURING HEIGHT").or(0),
        Parameter::size(320, "SET-UP CLEARANCE").or(0),
        Parameter::coordinate(260, "CLEARANCE HEIGHT").or(50_000_000),
        Parameter::choice(301, "MOVE TO CLEARANCE", &[0, 1]).or(0),
        Parameter::size(side.maximum, "MAXIMUM DIMENSION").or(0),
        Parameter::size(side.minimum, "MINIMUM DIMENSION").or(0),
        Parameter::size(279, "TOLERANCE 1ST CENTER").or(0),
        Parameter::size(280, "TOLERANCE 2ND CENTER").or(0),
        Parameter::choice(281, "MEASURING LOG", &[0, 1, 2]).or(0),
        Parameter::choice(309, "PGM-STOP IF ERROR", &[0, 1]).or(0),
        Parameter { q: 330, name: "TOOL NUMBER", range: Range::Tool, default: Some(0) },
        Parameter::choice(423, "NO. OF MEAS. POINTS", &[3, 4]).or(4),
        Parameter::choice(365, "TYPE OF TRAVERSE", &[0, 1]).or(1),
    ]
}

/// Runs either cycle on checked inputs.
pub(super) fn run(side: &Side, inputs: &Inputs, prober: &mut dyn Prober) -> Result<CycleResult, CycleError> {
    let (minimum, maximum) = (inputs.length(side.minimum), inputs.length(side.maximum));
    if maximum < minimum {
        return Err(CycleError::LimitsSwapped { minimum, maximum });
    }
    if inputs.length(262) == Length::ZERO {
        return Err(CycleError::NoDiameter { q: 262, name: NOMINAL_DIAMETER });
    }
    let nominal = [inputs.length(273), inputs.length(274)];
    let contacts = touches(side, inputs).iter().map(|touch| prober.touch(touch)).collect::<Result<Vec<_>, _>>()?;
    let circle = least_squares(&contacts)?;
    let nearest = |mm: f64| Length::from_mm_f64(mm).map_err(CycleError::TooLarge);
    let centre = [nearest(circle.x)?, nearest(circle.y)?];
    let diameter = nearest(circle.diameter)?;
    let [x, y] = nominal;
    let [centre_x, centre_y] = centre;
    let axis = |deviation, tolerance: Length| AxisPosition {
        deviation,
        tolerance: (Length::ZERO < tolerance).then_some(tolerance),
    };
    let position = PositionVerdict {
        axes: [
            axis(centre_x.saturating_sub(x), inputs.length(279)),
            axis(centre_y.saturating_sub(y), inputs.length(280)),
        ],
    };
    // Limits left at 0 switch monitoring off; the markers are set all the same.
    let monitored = minimum != Length::ZERO || maximum != Length::ZERO;
    let status = match () {
        () if position.is_out() => Status::Scrap,
        () if monitored => classify(side.feature, minimum, maximum, diameter),
        () => Status::Good,
    };
    let results = results(centre, diameter, &position, diameter.saturating_sub(inputs.length(262)), status);
    Ok(CycleResult { contacts, circle, centre, diameter, position, status, results })
}

/// The touches in order: at Q325 + k · Q247, from inside a hole or from outside a stud. Three contacts without a given
/// Q247 lie 120 degrees apart.
fn touches(side: &Side, inputs: &Inputs) -> Vec<Touch> {
    let centre = [inputs.length(273).to_mm_f64(), inputs.length(274).to_mm_f64()];
    let height = inputs.length(261).to_mm_f64();
    let radius = inputs.length(262).to_mm_f64() / 2.0;
    let clearance = inputs.length(320).to_mm_f64() + SET_UP;
    let (start, outward) = match side.feature {
        // In a small hole the probe starts at the centre.
        Feature::Hole => ((radius - clearance).max(0.0), 1.0),
        Feature::Shaft => (radius + clearance, -1.0),
    };
    let count = inputs.whole(423);
    let step = if count == 3 && !inputs.is_given(247) { STEP_OF_THREE } else { inputs.angle(247) };
    let [x, y] = centre;
    // Q423 is 3 or 4.
    (0..4_u8)
        .take(usize::try_from(count).unwrap_or(4))
        .map(|number| {
            let [cos, sin] = inputs.angle(325).stepped(step, number).direction();
            Touch { from: [x + start * cos, y + start * sin, height], direction: [outward * cos, outward * sin, 0.0] }
        })
        .collect()
}

/// Q151 to Q153 measured, Q161 to Q163 deviations, Q180 to Q182 markers of which exactly one is 1.
fn results(
    [x, y]: [Length; 2],
    diameter: Length,
    position: &PositionVerdict,
    deviation: Length,
    status: Status,
) -> Vec<(u16, Value)> {
    let [axis_1, axis_2] = position.axes;
    let marker = |marked| Value::Whole(i64::from(status == marked));
    vec![
        (151, Value::Length(x)),
        (152, Value::Length(y)),
        (153, Value::Length(diameter)),
        (161, Value::Length(axis_1.deviation)),
        (162, Value::Length(axis_2.deviation)),
        (163, Value::Length(deviation)),
        (180, marker(Status::Good)),
        (181, marker(Status::Rework)),
        (182, marker(Status::Scrap)),
    ]
}
