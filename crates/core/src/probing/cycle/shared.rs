//! Parameters that several milling cycles have.
//!
//! Questions: English as in the cycle manuals of TNC 320, Italian as in the manual of TNC7; the Dutch ones, and the Dutch
//! names, are ours. German and Italian where a comment says "not seen": in the style of the manuals (docs/SOURCES.md).

use super::key::Key;
use super::meaning::{Axis, Meaning};
use super::parameter::Parameter;
use super::texts::Texts;
use crate::words::Dialogue::{De, En, It, Nl};

const CHOSEN: &[i64] = &[0, 1];

// De: not seen but the names of Q260, Q273, Q274, Q301 and Q320, which are those of other cycles.
// It: not seen for Q273, Q274, Q279, Q280 and Q301, nor the questions of Q498 and Q531.

/// The nominal coordinates of a point, first and second axis.
pub(in crate::probing) const POINT_1: Parameter = Parameter::coordinate(Key::Q(263), "1ST POINT 1ST AXIS")
    .named(&[(Nl, "1E PUNT 1E AS"), (De, "1. PUNKT 1. ACHSE"), (It, "1. PUNTO 1. ASSE")])
    .asked(&[
        (En, "1st meas. point 1st axis?"),
        (Nl, "1e meetpunt 1e as?"),
        (De, "1. Messpunkt 1. Achse?"),
        (It, "1. punto misurato sul 1. asse?"),
    ])
    .means(Meaning::Point(Axis::First));
/// The second.
pub(in crate::probing) const POINT_2: Parameter = Parameter::coordinate(Key::Q(264), "1ST POINT 2ND AXIS")
    .named(&[(Nl, "1E PUNT 2E AS"), (De, "1. PUNKT 2. ACHSE"), (It, "1. PUNTO 2. ASSE")])
    .asked(&[
        (En, "1st meas. point 2nd axis?"),
        (Nl, "1e meetpunt 2e as?"),
        (De, "1. Messpunkt 2. Achse?"),
        (It, "1. punto misurato sul 2. asse?"),
    ])
    .means(Meaning::Point(Axis::Second));
/// The third.
pub(in crate::probing) const POINT_3: Parameter = Parameter::coordinate(Key::Q(294), "1ST POINT 3RD AXIS")
    .named(&[(Nl, "1E PUNT 3E AS"), (De, "1. PUNKT 3. ACHSE"), (It, "1. PUNTO 3. ASSE")])
    .asked(&[
        (En, "1st meas. point 3rd axis?"),
        (Nl, "1e meetpunt 3e as?"),
        (De, "1. Messpunkt 3. Achse?"),
        (It, "1. punto misurato sul 3. asse?"),
    ])
    .means(Meaning::Point(Axis::Third));

/// The second of two points, first and second axis.
pub(in crate::probing) const SECOND_POINT_1: Parameter = Parameter::coordinate(Key::Q(265), "2ND POINT 1ST AXIS")
    .named(&[(Nl, "2E PUNT 1E AS"), (De, "2. PUNKT 1. ACHSE"), (It, "2. PUNTO 1. ASSE")])
    .asked(&[
        (En, "2nd meas. point 1st axis?"),
        (Nl, "2e meetpunt 1e as?"),
        (De, "2. Messpunkt 1. Achse?"),
        (It, "2. punto misurato sul 1. asse?"),
    ])
    .means(Meaning::NextPoint(Axis::First));
/// The second axis.
pub(in crate::probing) const SECOND_POINT_2: Parameter = Parameter::coordinate(Key::Q(266), "2ND POINT 2ND AXIS")
    .named(&[(Nl, "2E PUNT 2E AS"), (De, "2. PUNKT 2. ACHSE"), (It, "2. PUNTO 2. ASSE")])
    .asked(&[
        (En, "2nd meas. point 2nd axis?"),
        (Nl, "2e meetpunt 2e as?"),
        (De, "2. Messpunkt 2. Achse?"),
        (It, "2. punto misurato sul 2. asse?"),
    ])
    .means(Meaning::NextPoint(Axis::Second));

/// The measured axis, one of three.
pub(in crate::probing) const MEASURED_AXIS: Parameter = Parameter::choice(Key::Q(272), "MEASURING AXIS", &[1, 2, 3])
    .named(&[(Nl, "MEETAS"), (De, "MESSACHSE"), (It, "ASSE MISURATO")])
    .asked(&[
        (En, "Meas. axis (1...3: 1=ref. axis)?"),
        (Nl, "Meetas (1..3: 1=hoofdas)?"),
        (De, "Messachse (1..3: 1=Hauptachse)?"),
        (It, "Asse mis. (1..3: 1=asse princ.)?"),
    ])
    .means(Meaning::MeasuredAxis);
/// The direction of the approach along it.
pub(in crate::probing) const DIRECTION: Parameter = Parameter::choice(Key::Q(267), "TRAVERSE DIRECTION", &[-1, 1])
    .named(&[(Nl, "TASTRICHTING"), (De, "VERFAHRRICHTUNG"), (It, "DIREZIONE ATTRAVERS.")])
    .asked(&[
        (En, "Trav. direction 1 (+1=+ / -1=-)?"),
        (Nl, "Tastrichting 1 (+1=+ / -1=-)?"),
        (De, "Verfahrrichtung 1 (+1=+ / -1=-)?"),
        (It, "Direz. attravers. 1 (+1=+/-1=-)?"),
    ])
    .means(Meaning::Direction);

/// The nominal centre of a hole, shaft, pocket or boss, first and second axis.
pub(in crate::probing) const CENTRE_1: Parameter = Parameter::coordinate(Key::Q(273), "CENTER IN 1ST AXIS")
    .named(&[(Nl, "MIDDEN 1E AS"), (De, "MITTE 1. ACHSE"), (It, "CENTRO 1. ASSE")])
    .asked(&[
        (En, "Center in 1st axis (nom. value)?"),
        (Nl, "Midden 1e as (nom. waarde)?"),
        (De, "Mitte 1. Achse (Sollwert)?"),
        (It, "Centro 1. asse (valore nom.)?"),
    ])
    .means(Meaning::Centre(Axis::First));
/// The second.
pub(in crate::probing) const CENTRE_2: Parameter = Parameter::coordinate(Key::Q(274), "CENTER IN 2ND AXIS")
    .named(&[(Nl, "MIDDEN 2E AS"), (De, "MITTE 2. ACHSE"), (It, "CENTRO 2. ASSE")])
    .asked(&[
        (En, "Center in 2nd axis (nom. value)?"),
        (Nl, "Midden 2e as (nom. waarde)?"),
        (De, "Mitte 2. Achse (Sollwert)?"),
        (It, "Centro 2. asse (valore nom.)?"),
    ])
    .means(Meaning::Centre(Axis::Second));

/// The permitted deviation of that centre either way, first and second axis; 0 monitors nothing.
pub(in crate::probing) const CENTRE_TOLERANCE_1: Parameter = Parameter::size(Key::Q(279), "TOLERANCE 1ST CENTER")
    .named(&[(Nl, "TOLERANTIE MIDDEN 1"), (De, "TOLERANZ 1. MITTE"), (It, "TOLLERANZA CENTRO 1")])
    .asked(&[
        (En, "Tolerance for center 1st axis?"),
        (Nl, "Tolerantie midden 1e as?"),
        (De, "Toleranzwert Mitte 1. Achse?"),
        (It, "Tolleranza centro 1. asse?"),
    ])
    .or(0)
    .means(Meaning::CentreTolerance(Axis::First));
/// The second.
pub(in crate::probing) const CENTRE_TOLERANCE_2: Parameter = Parameter::size(Key::Q(280), "TOLERANCE 2ND CENTER")
    .named(&[(Nl, "TOLERANTIE MIDDEN 2"), (De, "TOLERANZ 2. MITTE"), (It, "TOLLERANZA CENTRO 2")])
    .asked(&[
        (En, "Tolerance for center 2nd axis?"),
        (Nl, "Tolerantie midden 2e as?"),
        (De, "Toleranzwert Mitte 2. Achse?"),
        (It, "Tolleranza centro 2. asse?"),
    ])
    .or(0)
    .means(Meaning::CentreTolerance(Axis::Second));

/// The way between contacts: at measuring height, or over the clearance height.
pub(in crate::probing) const MOVE_TO_CLEARANCE: Parameter = Parameter::choice(Key::Q(301), "MOVE TO CLEARANCE", CHOSEN)
    .named(&[(Nl, "VERPL. NAAR V. HOOGTE"), (De, "FAHREN AUF S. HOEHE"), (It, "SPOST. A ALT. SICUR.")])
    .asked(&[
        (En, "Move to clearance height (0/1)?"),
        (Nl, "Naar veilige hoogte (0/1)?"),
        (De, "Fahren auf sichere Höhe (0/1)?"),
        (It, "Spost. a alt. di sicur. (0/1)?"),
    ])
    .or(0)
    .or_predef()
    .means(Meaning::MoveToClearance);

/// Where the ball's centre is in the probe axis during contact.
pub(in crate::probing) const MEASURING_HEIGHT: Parameter = Parameter::coordinate(Key::Q(261), "MEASURING HEIGHT")
    .named(&[(Nl, "MEETHOOGTE"), (De, "MESSHOEHE"), (It, "ALTEZZA MISURATA")])
    .asked(&[
        (En, "Measuring height in probe axis?"),
        (Nl, "Meethoogte in tasteras?"),
        (De, "Messhöhe in Tastsystem-Achse?"),
        (It, "Mis. altezza su asse tastatore?"),
    ])
    .means(Meaning::MeasuringHeight);

/// Added to the probe's own set-up clearance.
pub(in crate::probing) const SET_UP_CLEARANCE: Parameter = Parameter::size(Key::Q(320), "SET-UP CLEARANCE")
    .named(&[(Nl, "VEILIGHEIDSAFSTAND"), (De, "SICHERHEITS-ABST."), (It, "DISTANZA SICUREZZA")])
    .asked(&[
        (En, "Set-up clearance?"),
        (Nl, "Veiligheidsafstand?"),
        (De, "Sicherheits-Abstand?"),
        (It, "Distanza di sicurezza?"),
    ])
    .or(0)
    .or_predef()
    .means(Meaning::SetUpClearance);

/// The height at which nothing is in the way.
pub(in crate::probing) const CLEARANCE_HEIGHT: Parameter = Parameter::coordinate(Key::Q(260), "CLEARANCE HEIGHT")
    .named(&[(Nl, "VEILIGE HOOGTE"), (De, "SICHERE HOEHE"), (It, "ALTEZZA DI SICUREZZA")])
    .asked(&[(En, "Clearance height?"), (Nl, "Veilige hoogte?"), (De, "Sichere Höhe?"), (It, "Altezza di sicurezza?")])
    .or(50_000_000)
    .or_predef()
    .means(Meaning::ClearanceHeight);

/// No log, a file, or a stop with the log on screen.
pub(in crate::probing) const MEASURING_LOG: Parameter = Parameter::choice(Key::Q(281), "MEASURING LOG", &[0, 1, 2])
    .named(&[(Nl, "MEETPROTOCOL"), (De, "MESSPROTOKOLL"), (It, "PROTOCOLLO DI MIS.")])
    .asked(&[
        (En, "Measuring log (0/1/2)?"),
        (Nl, "Meetprotocol (0/1/2)?"),
        (De, "Messprotokoll (0/1/2)?"),
        (It, "Protocollo di mis. (0/1/2)?"),
    ])
    .or(0)
    .means(Meaning::Log);

/// Whether the program stops where something is out of tolerance.
pub(in crate::probing) const STOP_IF_ERROR: Parameter = Parameter::choice(Key::Q(309), "PGM-STOP IF ERROR", CHOSEN)
    .named(&[(Nl, "PGM-STOP BIJ FOUT"), (De, "PGM-STOP BEI FEHLER"), (It, "STOP PGM SE ERRORE")])
    .asked(&[
        (En, "PGM-stop if tolerance error?"),
        (Nl, "PGM-stop bij tolerantiefout?"),
        (De, "PGM-Stop bei Toleranzfehler?"),
        (It, "Stop PGM se superata tolleranza?"),
    ])
    .or(0)
    .means(Meaning::Stop);

/// Whether the program stops where something is out of tolerance, and for what; a cycle says which of them.
pub(in crate::probing) const ERROR_REACTION: Parameter = Parameter::choice(Key::Q(309), "ERROR REACTION", &[0, 1, 2])
    .named(&[(Nl, "REACTIE BIJ FOUT"), (De, "FEHLERREAKTION"), (It, "REAZIONE A ERRORE")])
    .asked(&[
        (En, "Reaction to tolerance error?"),
        (Nl, "Reactie bij tolerantiefout?"),
        (De, "Reaktion bei Toleranzfehler?"),
        (It, "Reazione a errore tolleranza?"),
    ])
    .or(0);

/// The tool that is monitored, by number or name.
pub(in crate::probing) const TOOL: Parameter = Parameter::new(Key::Q(330), "TOOL NUMBER", super::range::Range::Tool)
    .named(&[(Nl, "GEREEDSCHAP"), (De, "WERKZEUG"), (It, "UTENSILE")])
    .asked(&[
        (En, "Tool for monitoring?"),
        (Nl, "Gereedschap voor bewaking?"),
        (De, "Werkzeug für Überwachung?"),
        (It, "Utensile per controllo?"),
    ])
    .or(0);

const REVERSE_TOOL: Texts = &[(Nl, "GEREEDSCHAP OMKEREN"), (De, "WERKZEUG UMKEHREN"), (It, "INVERSIONE UTENSILE")];
const INCIDENCE: Texts = &[(Nl, "INVALSHOEK"), (De, "ANSTELLWINKEL"), (It, "ANGOLO DI INCLINAZ.")];

/// For turning tools only; accepted for programs of milling and turning machines.
pub(in crate::probing) const REVERSED: Parameter = Parameter::choice(Key::Q(498), "REVERSE TOOL", CHOSEN)
    .asked(&[
        (En, "Reverse tool (0=no/1=yes)?"),
        (Nl, "Gereedschap omkeren (0=nee/1=ja)?"),
        (De, "Werkzeug umkehren (0=nein/1=ja)?"),
        (It, "Inversione utensile (0=no/1=sì)?"),
    ])
    .named(REVERSE_TOOL)
    .or(0)
    .without_effect();
/// For turning tools only; accepted for programs of milling and turning machines.
pub(in crate::probing) const INCIDENCE_ANGLE: Parameter = Parameter::angle(Key::Q(531), "ANGLE OF INCIDENCE", 180, 0)
    .asked(&[(En, "Angle of incidence?"), (Nl, "Invalshoek?"), (De, "Anstellwinkel?"), (It, "Angolo di inclinazione?")])
    .named(INCIDENCE)
    .or(0)
    .without_effect();
