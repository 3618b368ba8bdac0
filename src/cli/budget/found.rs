//! A budget's file, and what is said of it on the command line.

use std::path::Path;

use serde_json::{Map, Value as Json, json};

use crate::budget::{Assessment, Budget, Conditions, Geometry};
use crate::cli::io::read_input;
use crate::cli::said::CliRemark;
use crate::cli::{CliError, IntoCliError as _, Io};
use crate::journal::entry::FileRole;
use crate::length::without_zeros;
use crate::text::decode;
use crate::verdict::rules::Uncertainty;

/// A budget's file, and the name to call it by.
pub(in crate::cli) fn read(path: &Path, io: &mut Io<'_>) -> Result<(String, Budget), CliError> {
    let (name, bytes) = read_input(path, io)?;
    io.used(FileRole::Budget, &name, &bytes);
    let budget = Budget::read(&decode(&bytes)).about(&name)?;
    Ok((name, budget))
}

/// A file's budget for a measured value, and the uncertainty that a rule gets.
pub(in crate::cli) fn assess(
    path: &Path,
    conditions: &Conditions,
    io: &mut Io<'_>,
) -> Result<(Assessment, Uncertainty), CliError> {
    let (name, budget) = read(path, io)?;
    let found = Assessment::of(budget, conditions, None, crate::cli::now().date()).about(&name)?;
    let uncertainty = found.uncertainty().about(&name)?;
    Ok((found, uncertainty))
}

/// Says which budget gives the uncertainty of a check, for which contacts, and what to check about it.
pub(in crate::cli) fn introduce(found: &Assessment, io: &mut Io<'_>) {
    let Budget { name, date, valid_until, .. } = &found.budget;
    let name = name.clone();
    let date = date.to_string();
    let until = valid_until.to_string();
    io.remark(&CliRemark::Budget { name, date, until });
    if let Some(Geometry { touches, step_deg, factor }) = found.geometry() {
        let step = step_deg.map_or_else(String::new, |step| format!(" × {}°", figure(step, 3)));
        io.remark(&CliRemark::BudgetContacts { touches, step, factor: format!("{factor:.3}") });
    }
    for warning in found.warnings() {
        io.warn(&warning);
    }
}

/// Which budget it is and what it comes to, as programs read it.
pub(in crate::cli) fn head(found: &Assessment) -> Map<String, Json> {
    let Budget { name, date, by, valid_until, .. } = &found.budget;
    let warnings: Vec<String> = found.warnings().iter().map(ToString::to_string).collect();
    let head = [
        ("name", json!(name)),
        ("date", json!(date.to_string())),
        ("by", json!(by)),
        ("valid_until", json!(valid_until.to_string())),
        ("validity", json!(found.validity.word())),
        ("method", json!(found.method())),
        ("u_um", rounded(found.u(), 6)),
        ("degrees_of_freedom", found.degrees_of_freedom().map_or(Json::Null, |degrees| rounded(degrees, 2))),
        ("k", rounded(found.k(), 3)),
        ("expanded_um", rounded(found.expanded(), 6)),
        ("warnings", json!(warnings)),
    ];
    let geometry = found.geometry();
    let contacts = [
        ("touches", json!(geometry.map(|geometry| geometry.touches))),
        ("step_deg", json!(geometry.and_then(|geometry| geometry.step_deg))),
        ("geometry_factor", json!(geometry.map(|geometry| rounded(geometry.factor, 6)))),
    ];
    let contacts = contacts.into_iter().filter(|_| geometry.is_some());
    head.into_iter().chain(contacts).map(|(name, value)| (name.to_owned(), value)).collect()
}

/// A number with so many decimals at most.
pub(super) fn rounded(number: f64, decimals: usize) -> Json {
    figure(number, decimals).parse::<f64>().map_or(Json::Null, |number| json!(number))
}

/// The same as text.
pub(super) fn figure(number: f64, decimals: usize) -> String {
    without_zeros(&format!("{number:.decimals$}")).to_owned()
}
