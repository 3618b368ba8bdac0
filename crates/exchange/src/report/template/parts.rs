//! What a template chooses from: each word once, with its text's name.

use serde::{Deserialize, Serialize};

/// Declares words that a template may use: the variant, the word, the name of its text.
macro_rules! words {
    ($(#[$doc:meta])* $Name:ident { $($(#[$of:meta])* $variant:ident: $word:literal, $text:literal;)+ }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum $Name {
            $($(#[$of])* #[serde(rename = $word)] $variant,)+
        }

        impl $Name {
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its word in a template.
            pub const fn word(self) -> &'static str {
                match self {
                    $(Self::$variant => $word,)+
                }
            }

            /// The name of the text that stands above it, or beside it where it is chosen.
            pub const fn text(self) -> &'static str {
                match self {
                    $(Self::$variant => $text,)+
                }
            }
        }
    };
}

words! {
    /// What stands on a page. Notes are no section: they are on every report.
    Section {
        /// The verdict, large, with what to do and the counts.
        Verdict: "verdict", "report-section-verdict";
        /// Who measured what for whom.
        Head: "head", "report-section-head";
        /// The part's picture with its balloons.
        Picture: "picture", "report-section-picture";
        /// Parts with their verdicts, the worst first, and the counts; nothing where there is one part only.
        Lot: "lot", "report-section-lot";
        /// Every size with its limits, its value and its verdict.
        Features: "features", "report-section-features";
        /// Of each feature: mean, spread, capability with intervals, charts, what rules find, advice.
        Statistics: "statistics", "report-section-statistics";
        /// That the values conform, or which do not, by the decision rule.
        Statement: "statement", "report-section-statement";
        /// The decision rule, the uncertainty, the sources of the limits, the temperature.
        Rule: "rule", "report-section-rule";
        /// What the measurement cannot tell.
        Caveats: "caveats", "report-section-caveats";
        /// Remarks of the plan and of features.
        Remarks: "remarks", "report-section-remarks";
        /// Lines for date, name and signature.
        Signature: "signature", "report-section-signature";
        /// A code with the record's hash, which leads back to the journal.
        Code: "code", "report-section-code";
    }
}

words! {
    /// A field of the head.
    HeadField {
        Part: "part", "report-part";
        Drawing: "drawing", "parts-page-head-drawing";
        Revision: "revision", "report-revision";
        Serial: "serial", "report-serial";
        Batch: "batch", "report-batch";
        Customer: "customer", "report-customer";
        Order: "order", "report-order";
        Material: "material", "report-material";
        Inspector: "inspector", "report-inspector";
        Station: "station", "report-station";
        Instrument: "instrument", "report-instrument";
        /// When it was last calibrated.
        Calibrated: "calibrated", "report-calibrated";
        Date: "date", "report-date";
        Temperature: "temperature", "report-temperature";
        Plan: "plan", "report-plan";
        /// The numbers of its entries in the journal.
        Records: "records", "report-records";
    }
}

words! {
    /// A column of the table of features.
    Column {
        /// The number of the balloon.
        Number: "number", "report-contact";
        Feature: "feature", "report-id";
        Callout: "callout", "report-callout";
        Minimum: "minimum", "report-minimum";
        Maximum: "maximum", "report-maximum";
        Measured: "measured", "report-measured";
        Deviation: "deviation", "report-deviation";
        /// The limits and the value as a small picture.
        Band: "band", "report-pdf-band";
        Verdict: "verdict", "report-verdict";
        From: "from", "report-from";
        Instrument: "instrument", "report-instrument";
        /// An empty cell, to be filled in by hand.
        Blank: "blank", "report-blank";
        Remark: "remark", "report-remark";
    }
}

impl Section {
    /// Those of an inspection report.
    pub fn usual() -> Vec<Self> {
        Self::ALL.iter().copied().filter(|section| !matches!(section, Self::Statement | Self::Statistics)).collect()
    }
}

impl HeadField {
    pub fn usual() -> Vec<Self> {
        Self::ALL.to_vec()
    }
}

impl Column {
    pub fn usual() -> Vec<Self> {
        let left_out = [Self::Instrument, Self::Blank, Self::Remark];
        Self::ALL.iter().copied().filter(|column| !left_out.contains(column)).collect()
    }
}
