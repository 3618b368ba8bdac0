//! Plans as CSV: one feature a line.
//!
//! The header names the columns, in any order: `callout`, `x`, `y`, `z`, and where they are wanted `name`, `angle`,
//! `clearance`, `clearance_height`. Cells are separated by comma, semicolon or tabulator; numbers have a point or a comma.

use std::str::FromStr;

use super::error::{PlanError, PlanFault};
use super::plan::{MOST_FEATURES, NcFeature, NcPlan};
use crate::control::text::{decode, lines};
use crate::length::LengthError;

/// The columns that are known.
const COLUMNS: [&str; 8] = ["name", "callout", "x", "y", "z", "angle", "clearance", "clearance_height"];

/// Those that must be there.
const NEEDED: [&str; 4] = ["callout", "x", "y", "z"];

impl NcPlan {
    /// Reads a plan.
    ///
    /// ```
    /// use fitcheck::nc::sets::NcPlan;
    ///
    /// let plan = NcPlan::read(b"name;callout;x;y;z\nA1;25 H7;40;30,5;-8\n")?;
    /// assert_eq!(plan.features()[0].y.to_string(), "30.5");
    /// # Ok::<(), fitcheck::nc::sets::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlanError`] with the line, also where a row has more cells than the header, or a column is not known.
    pub fn read(bytes: &[u8]) -> Result<Self, PlanError> {
        let text = decode(bytes);
        let header = lines(&text).map(|(_, line)| line).find(|line| !line.trim().is_empty()).unwrap_or_default();
        let separator = [b';', b'\t'].into_iter().find(|&sign| header.as_bytes().contains(&sign)).unwrap_or(b',');
        let mut columns: Option<Vec<&'static str>> = None;
        let (mut features, mut features_lines) = (Vec::new(), Vec::new());
        for (line, row) in lines(&text) {
            let at = |what| PlanError::in_line(line, what);
            let row = cells(row, separator).map_err(|error| at(PlanFault::Csv { reason: error.to_string() }))?;
            if row.iter().all(str::is_empty) {
                continue;
            }
            let Some(columns) = &columns else {
                columns = Some(header_of(&row).map_err(at)?);
                continue;
            };
            if features.len() == MOST_FEATURES {
                return Err(at(PlanFault::TooMany { most: MOST_FEATURES }));
            }
            features.push(feature(columns, &row).map_err(at)?);
            features_lines.push(line);
        }
        Self::of_lines(features, features_lines)
    }
}

/// The cells of a line; none holds a line's end.
fn cells(line: &str, separator: u8) -> Result<csv::StringRecord, csv::Error> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .delimiter(separator)
        .buffer_capacity(line.len().clamp(1, 1 << 16))
        .from_reader(line.as_bytes());
    let mut cells = csv::StringRecord::new();
    reader.read_record(&mut cells)?;
    Ok(cells)
}

fn header_of(row: &csv::StringRecord) -> Result<Vec<&'static str>, PlanFault> {
    let mut columns = Vec::new();
    for cell in row {
        let known = COLUMNS.into_iter().find(|known| known.eq_ignore_ascii_case(cell));
        let known = known.ok_or_else(|| PlanFault::UnknownColumn {
            column: cell.chars().take(40).collect(),
            known: COLUMNS.join(", "),
        })?;
        if columns.contains(&known) {
            return Err(PlanFault::ColumnTwice { column: known });
        }
        columns.push(known);
    }
    match NEEDED.into_iter().find(|needed| !columns.contains(needed)) {
        Some(column) => Err(PlanFault::NoColumn { column }),
        None => Ok(columns),
    }
}

fn feature(columns: &[&'static str], row: &csv::StringRecord) -> Result<NcFeature, PlanFault> {
    if columns.len() < row.len() {
        return Err(PlanFault::Cells { found: row.len(), expected: columns.len() });
    }
    let cell = |column: &'static str| {
        let at = columns.iter().position(|known| *known == column);
        at.and_then(|at| row.get(at)).filter(|cell| !cell.is_empty())
    };
    let text = cell("callout").ok_or(PlanFault::NoCell { column: "callout" })?;
    let callout = text.parse().map_err(|error| PlanFault::Callout { text: shortened(text), error: Box::new(error) })?;
    let needed = |column| match cell(column) {
        Some(text) => number(column, text),
        None => Err(PlanFault::NoCell { column }),
    };
    let usual = NcFeature::new(callout, [needed("x")?, needed("y")?, needed("z")?]);
    Ok(NcFeature {
        name: cell("name").unwrap_or_default().to_owned(),
        angle: cell("angle").map_or(Ok(usual.angle), |text| number("angle", text))?,
        clearance: cell("clearance").map_or(Ok(usual.clearance), |text| number("clearance", text))?,
        clearance_height: cell("clearance_height")
            .map_or(Ok(usual.clearance_height), |text| number("clearance_height", text))?,
        ..usual
    })
}

fn number<T: FromStr<Err = LengthError>>(column: &'static str, text: &str) -> Result<T, PlanFault> {
    text.parse().map_err(|error| PlanFault::Number { column, error })
}

fn shortened(text: &str) -> String {
    text.chars().take(80).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let said = match NcPlan::read(text.as_bytes()) {
            Ok(plan) => {
                let feature = |f: &NcFeature| {
                    format!(
                        "{} {} {} {} {} {} {} {}",
                        f.name, f.callout, f.x, f.y, f.z, f.angle, f.clearance, f.clearance_height
                    )
                };
                plan.features().iter().map(feature).collect::<Vec<_>>().join("; ")
            }
            Err(error) => error.to_string(),
        };
        assert_eq!(said, expected, "{text}");
    }

    #[test]
    fn a_feature_a_line_in_any_order_of_columns() {
        check("callout,x,y,z\n25 H7,40,30,-8\n", "F1 25 H7 40 30 -8 0° 2 50");
        check(
            "\u{feff}Z;Y;X;Callout;Name;angle;clearance;clearance_height\r\n-8,5;30;40;25 H7;A_1;22,5;1;80\r\n\r\n;;;;;;;\r\n0;0;0;10g6\r\n",
            "A_1 25 H7 40 30 -8.5 22.5° 1 80; F2 10 g6 0 0 0 0° 2 50",
        );
        check("callout\tx\ty\tz\n\"25 H7\"\t1\t2\t3", "F1 25 H7 1 2 3 0° 2 50");
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        check("", "the plan has no feature");
        check("callout,x,y,z\n", "the plan has no feature");
        check("callout,x,y\n25 H7,1,2\n", "line 1: column z is missing");
        let known = "name, callout, x, y, z, angle, clearance, clearance_height";
        check("callout,x,y,z,depth\n", &format!("line 1: unknown column depth: the columns are {known}"));
        check("callout,x,y,z,X\n", "line 1: column x occurs twice");
        check(
            "callout,x,y,z\n25 H7,40,5,30,-8\n",
            "line 2: the row has 5 cells and the header 4: with a decimal comma, separate the columns by semicolons",
        );
        check("callout,x,y,z\n25 H7,40,30\n", "line 2: z is missing");
        check("callout,x,y,z\n\n,1,2,3\n", "line 3: callout is missing");
        check("callout,x,y,z\n25 H7,a,30,0\n", "line 2: x: a is not a number");
        check(
            "callout,x,y,z\n25 H7,100000,30,0\n",
            "line 2: Q273 CENTER IN 1ST AXIS = 100000 mm: at least -99999.9999 mm, at most 99999.9999 mm",
        );
        check("callout,x,y,z,angle\n25 H7,1,30,0,361\n", "line 2: Q325 STARTING ANGLE = 361°: at most 360° either way");
        check(
            "callout,x,y,z\n25 H7,1,30,50\n",
            "line 2: clearance height 50 mm is not above the measuring height, 50 mm",
        );
        check(
            "name,callout,x,y,z\na b,25 H7,1,2,3\n",
            "line 2: name a b: letters A to Z, digits and _ are allowed, at most 20",
        );
        check(
            "name,callout,x,y,z\na,25 H7,1,2,3\nA,25 H7,1,2,3\n",
            "line 3: name A occurs twice: file names on a control ignore case",
        );
        check(
            "callout,x,y,z\n12 +0.02 -0.02,1,2,3\n",
            "line 2: 12 ±0.02 has no tolerance class, such as H7: the programs look up limits by class",
        );
        check(
            "callout,x,y,z\n25 H7/g6,1,2,3\n",
            "line 2: 25 H7/g6 is a fit: write the hole and the shaft as two features",
        );
        check(
            "callout,x,y,z\n25 H7x,1,2,3\n",
            "line 2: 25 H7x: H7x is not a tolerance class: write letters and a grade, such as H7 or js13 (character 4)",
        );
    }
}
