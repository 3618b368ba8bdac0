//! The text fields of the statistics page.

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the statistics page.
    StatisticsField

    /// Which records are looked at, in the language of questions.
    Question: "statistics-question", "";
    /// So many of the newest values of a feature.
    Last: "statistics-last", "125";
    /// How many values in a row make a point, where points are means.
    Size: "statistics-size", "5";
    /// After how many minutes without a value a mean begins anew.
    Pause: "statistics-pause", "60";
    /// Why a point is left out.
    Reason: "statistics-reason", "";
    /// The lower limit that a gauge is used for; those of the file count where both are empty.
    StudyLower: "statistics-study-lower", "";
    /// The upper one.
    StudyUpper: "statistics-study-upper", "";
    /// The calibrated size of the master, or of several masters by their names.
    StudyReference: "statistics-study-reference", "";
    /// The step of the display.
    StudyResolution: "statistics-study-resolution", "";
}
