//! ISO 286 as a source of limits.

use std::sync::Arc;

use super::{Declaration, Standard};
use crate::length::Length;
use crate::message::{Say as _, message};
use crate::tolerance::ToleranceClass;
use crate::tolerance::deviations::Deviations;
use crate::tolerance::iso286::{self, Cell, Options};
use crate::tolerance::limits::Source;
use crate::tolerance::sources::LimitsError;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "iso286",
    help: "ISO 286, every class to 3150 mm",
    text: "source-choice-iso286",
    standard: Some(Standard {
        deviations,
        knows: |class| iso286::parts(class).is_some(),
        classes_at: |feature, nominal, options| Box::new(iso286::classes_at(feature, nominal, options)),
        usual_classes: |feature| iso286::usual_classes(feature).collect(),
    }),
};

fn deviations(class: ToleranceClass, nominal: Length, options: Options) -> Result<(Deviations, Source), LimitsError> {
    let cell = iso286::deviations(class, nominal, options).map_err(|why| LimitsError::Standard(why.message()))?;
    let Cell { deviations, over, to, remark } = cell;
    let said = match remark {
        None => message!("source-iso286"),
        Some(remark) => message!("source-iso286-remark").with("remark", &remark),
    };
    let doubt = remark.filter(|remark| remark.is_doubt()).map(|remark| remark.message());
    let said = Arc::new(said.with("over", &over).with("to", &to));
    Ok((deviations, Source::Standard { over, to, said, doubt }))
}
