//! The text fields of the reports page: what stands in the head of a report and comes from nowhere else.

use fitcheck_exchange::report::template::HeadField;

use crate::texts::{KeptField as _, kept_fields};

kept_fields! {
    /// A text field of the reports page.
    ReportsField

    Title: "report-title", "";
    Order: "report-order", "";
    Customer: "report-customer", "";
    Revision: "report-revision", "";
    Batch: "report-batch", "";
    Instrument: "report-instrument", "";
    /// When the instrument was last calibrated.
    Calibrated: "report-calibrated", "";
}

impl ReportsField {
    /// The fields in reading order.
    pub const fn all() -> &'static [Self] {
        Self::ALL
    }

    /// The id of its name.
    pub fn name(self) -> &'static str {
        self.head().map_or("reports-page-title", HeadField::text)
    }

    /// The field of the head that it fills; `None` for the title, which stands above the head.
    pub const fn head(self) -> Option<HeadField> {
        match self {
            Self::Title => None,
            Self::Order => Some(HeadField::Order),
            Self::Customer => Some(HeadField::Customer),
            Self::Revision => Some(HeadField::Revision),
            Self::Batch => Some(HeadField::Batch),
            Self::Instrument => Some(HeadField::Instrument),
            Self::Calibrated => Some(HeadField::Calibrated),
        }
    }
}
