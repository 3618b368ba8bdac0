//! The fields of a body, in their order. What is not there is `null`; a field that is not here is an error.

use std::collections::BTreeMap;

use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::Status;
use fitcheck_core::verdict::rules::Prover;
use serde::{Deserialize, Serialize};

/// Declares the fields of an object.
macro_rules! objects {
    ($($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $field:ident: $type:ty),+ $(,)? })+) => {$(
        $(#[$doc])*
        #[derive(Debug, Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub(super) struct $name {
            $($(#[$of])* pub(super) $field: $type,)+
        }
    )+};
}

/// Three binary fractions of a millimetre as texts: X, Y, Z of a contact; X, Y and diameter of a circle.
pub(super) type Three = [String; 3];

/// What an entry tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum BodyKind {
    Begin,
    Check,
    Withdrawal,
    Report,
    Alarm,
}

objects! {
    /// An entry. Of the last five the one that the kind names is there, and the others are left out.
    Body {
        v: u64,
        kind: BodyKind,
        about: About,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        begin: Option<Begin>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        check: Option<Check>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        withdrawal: Option<Corrects>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        report: Option<Report>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        alarm: Option<Alarm>,
    }
    About {
        station: String,
        time: Time,
        who: String,
        part: String,
        serial: String,
        feature: String,
        remark: String,
    }
    Time { utc_ms: i64, offset_min: i32, zone: String }
    Begin { chain: String, program: String, after: Option<After> }
    After { chain: String, number: u64, hash: String }
    /// A size or a cycle: the other one is left out.
    Check {
        status: Option<Status>,
        simulated: bool,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        size: Option<Size>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        cycle: Option<Cycle>,
        files: Vec<File>,
        corrects: Option<Corrects>,
    }
    File { role: String, name: String, sha256: String }
    Corrects { number: u64, hash: String, reason: String, by: String }
    /// The hash does not stand behind a text: so stand those of the files that checks were made with, which are looked for in all bodies.
    Report {
        name: String,
        format: String,
        title: String,
        bytes: u64,
        sha256: String,
        checks: Vec<[u64; 2]>,
        unrecorded: u64,
        head: Option<Last>,
    }
    Last { number: u64, hash: String }
    /// Cause and action are empty where it answers no other entry.
    Alarm {
        rule: String,
        place: String,
        first: u64,
        last: u64,
        since: String,
        answers: Option<Last>,
        cause: String,
        action: String,
    }
    Size {
        id: String,
        local_time: String,
        callout: Option<String>,
        limits: Limits,
        measurement: Measurement,
        correction: Option<Correction>,
        rule: Rule,
        budget: Option<Budget>,
        verdict: Verdict,
        doubt: Option<Doubt>,
    }
    Limits {
        feature: Option<Feature>,
        nominal_nm: i64,
        upper_nm: i64,
        lower_nm: i64,
        min_nm: i64,
        max_nm: i64,
        source: Source,
    }
    Source { text: String, range_nm: Option<[i64; 2]> }
    Measurement {
        diameter_nm: i64,
        centre_nm: Option<[i64; 2]>,
        origin: Origin,
        circle_mm: Option<Three>,
        contacts_mm: Vec<Three>,
    }
    Correction { measured_nm: i64, at_20c_nm: i64, part: Warm, scale: Option<Warm> }
    Warm { temperature_c_thousandths: i32, expansion_um_per_m_k_thousandths: i32 }
    Rule {
        name: String,
        u_pm: Option<i64>,
        k_thousandths: Option<u32>,
        factor_thousandths: Option<u32>,
        width_nm: Option<i64>,
        prover: Prover,
    }
    Budget {
        name: String,
        date: String,
        by: String,
        valid_until: String,
        counts_contacts: bool,
        validity: String,
        warnings: Vec<String>,
    }
    Verdict {
        size: Status,
        to_limit_nm: Option<i64>,
        to_middle_nm: Option<i64>,
        position: Option<[Axis; 2]>,
        undecided: Option<Undecided>,
    }
    Axis { deviation_nm: i64, tolerance_nm: Option<i64> }
    Undecided { contacts: u64, times_thousandths: u32 }
    Cycle {
        number: u16,
        block: Option<Block>,
        parameters: Vec<[String; 2]>,
        origin: CycleOrigin,
        contacts_mm: Vec<Three>,
        figures_nm: BTreeMap<String, i64>,
        compared: Vec<Compared>,
        limits_nm: Option<[i64; 2]>,
        measured_nm: Option<i64>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        datum: Option<Datum>,
    }
    /// The datum that a cycle counted from.
    Datum {
        zero_nm: [i64; 3],
        line: Option<u64>,
        text: Option<String>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rotation: Option<Turn>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        tilt: Option<Turn>,
    }
    /// Angles, and the block that has set them.
    Turn { degrees: Vec<String>, line: u64, text: String }
    Block { file: String, line: u64 }
    Compared { what: String, measured_nm: i64, min_nm: i64, max_nm: i64, status: Status }
}

/// Where a measured size comes from. A seed has more digits than a number of JSON holds everywhere.
#[derive(Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Origin {
    Simulated { cycle: u16, seed: String },
    Contacts { file: String },
    Imported { file: String },
    ImportedSimulation { file: String },
    Typed {},
}

/// Where the contacts of a cycle come from.
#[derive(Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum CycleOrigin {
    Perfect {},
    Workpiece { file: String, seed: String },
    Contacts { file: String },
}

/// What may be wrong with a measured value.
#[derive(Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Doubt {
    TimesInch { meant_nm: Option<i64> },
    Inches { meant_nm: Option<i64> },
    Double { meant_nm: Option<i64> },
    Half { meant_nm: Option<i64> },
    DecimalSign { meant_nm: i64 },
    Far { distance_nm: i64 },
    Implausible { lower_nm: i64, upper_nm: i64, meant_nm: Option<i64> },
}
