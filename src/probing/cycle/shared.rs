//! Parameters that several milling cycles have.
//!
//! Questions: English as in the cycle manuals of TNC 320, Italian as in the manual of TNC7.

use super::key::Key;
use super::meaning::{Axis, Meaning};
use super::parameter::{Parameter, Texts};
use crate::words::Dialogue::{En, It};

const CHOSEN: &[i64] = &[0, 1];

/// The nominal coordinates of a point, first and second axis.
pub(in crate::probing) const POINT_1: Parameter = Parameter::coordinate(Key::Q(263), "1ST POINT 1ST AXIS")
    .named(&[(It, "1. PUNTO 1. ASSE")])
    .asked(&[(En, "1st meas. point 1st axis?"), (It, "1. punto misurato sul 1. asse?")])
    .means(Meaning::Point(Axis::First));
/// The second.
pub(in crate::probing) const POINT_2: Parameter = Parameter::coordinate(Key::Q(264), "1ST POINT 2ND AXIS")
    .named(&[(It, "1. PUNTO 2. ASSE")])
    .asked(&[(En, "1st meas. point 2nd axis?"), (It, "1. punto misurato sul 2. asse?")])
    .means(Meaning::Point(Axis::Second));

/// The nominal centre of a hole, shaft, pocket or boss, first and second axis.
pub(in crate::probing) const CENTRE_1: Parameter = Parameter::coordinate(Key::Q(273), "CENTER IN 1ST AXIS")
    .asked(&[(En, "Center in 1st axis (nom. value)?")])
    .means(Meaning::Centre(Axis::First));
/// The second.
pub(in crate::probing) const CENTRE_2: Parameter = Parameter::coordinate(Key::Q(274), "CENTER IN 2ND AXIS")
    .asked(&[(En, "Center in 2nd axis (nom. value)?")])
    .means(Meaning::Centre(Axis::Second));

/// The permitted deviation of that centre either way, first and second axis; 0 monitors nothing.
pub(in crate::probing) const CENTRE_TOLERANCE_1: Parameter = Parameter::size(Key::Q(279), "TOLERANCE 1ST CENTER")
    .asked(&[(En, "Tolerance for center 1st axis?")])
    .or(0)
    .means(Meaning::CentreTolerance(Axis::First));
/// The second.
pub(in crate::probing) const CENTRE_TOLERANCE_2: Parameter = Parameter::size(Key::Q(280), "TOLERANCE 2ND CENTER")
    .asked(&[(En, "Tolerance for center 2nd axis?")])
    .or(0)
    .means(Meaning::CentreTolerance(Axis::Second));

/// The way between contacts: at measuring height, or over the clearance height.
pub(in crate::probing) const MOVE_TO_CLEARANCE: Parameter = Parameter::choice(Key::Q(301), "MOVE TO CLEARANCE", CHOSEN)
    .asked(&[(En, "Move to clearance height (0/1)?")])
    .or(0)
    .or_predef()
    .means(Meaning::MoveToClearance);

/// Where the ball's centre is in the probe axis during contact.
pub(in crate::probing) const MEASURING_HEIGHT: Parameter = Parameter::coordinate(Key::Q(261), "MEASURING HEIGHT")
    .named(&[(It, "ALTEZZA MISURATA")])
    .asked(&[(En, "Measuring height in probe axis?"), (It, "Mis. altezza su asse tastatore?")])
    .means(Meaning::MeasuringHeight);

/// Added to the probe's own set-up clearance.
pub(in crate::probing) const SET_UP_CLEARANCE: Parameter = Parameter::size(Key::Q(320), "SET-UP CLEARANCE")
    .named(&[(It, "DISTANZA SICUREZZA")])
    .asked(&[(En, "Set-up clearance?"), (It, "Distanza di sicurezza?")])
    .or(0)
    .or_predef()
    .means(Meaning::SetUpClearance);

/// The height at which nothing is in the way.
pub(in crate::probing) const CLEARANCE_HEIGHT: Parameter = Parameter::coordinate(Key::Q(260), "CLEARANCE HEIGHT")
    .named(&[(It, "ALTEZZA DI SICUREZZA")])
    .asked(&[(En, "Clearance height?"), (It, "Altezza di sicurezza?")])
    .or(50_000_000)
    .or_predef()
    .means(Meaning::ClearanceHeight);

/// No log, a file, or a stop with the log on screen.
pub(in crate::probing) const MEASURING_LOG: Parameter = Parameter::choice(Key::Q(281), "MEASURING LOG", &[0, 1, 2])
    .named(&[(It, "PROTOCOLLO DI MIS.")])
    .asked(&[(En, "Measuring log (0/1/2)?"), (It, "Protocollo di mis. (0/1/2)?")])
    .or(0)
    .means(Meaning::Log);

/// Whether the program stops where something is out of tolerance.
pub(in crate::probing) const STOP_IF_ERROR: Parameter = Parameter::choice(Key::Q(309), "PGM-STOP IF ERROR", CHOSEN)
    .named(&[(It, "STOP PGM SE ERRORE")])
    .asked(&[(En, "PGM-stop if tolerance error?"), (It, "Stop PGM se superata tolleranza?")])
    .or(0)
    .means(Meaning::Stop);

/// The tool that is monitored, by number or name.
pub(in crate::probing) const TOOL: Parameter =
    Parameter::new(Key::Q(330), "TOOL NUMBER", super::parameter::Range::Tool)
        .named(&[(It, "UTENSILE")])
        .asked(&[(En, "Tool for monitoring?"), (It, "Utensile per controllo?")])
        .or(0);

const REVERSE_TOOL: Texts = &[(It, "INVERSIONE UTENSILE")];
const INCIDENCE: Texts = &[(It, "ANGOLO DI INCLINAZ.")];

/// For turning tools only; accepted for programs of milling and turning machines.
pub(in crate::probing) const REVERSED: Parameter =
    Parameter::choice(Key::Q(498), "REVERSE TOOL", CHOSEN).named(REVERSE_TOOL).or(0).without_effect();
/// For turning tools only; accepted for programs of milling and turning machines.
pub(in crate::probing) const INCIDENCE_ANGLE: Parameter =
    Parameter::angle(Key::Q(531), "ANGLE OF INCIDENCE", 180, 0).named(INCIDENCE).or(0).without_effect();
