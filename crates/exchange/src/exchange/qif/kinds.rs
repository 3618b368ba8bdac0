//! Kinds of characteristics and of features, as QIF names them.

/// Kinds whose values are lengths, besides diameters and widths. Those of others are angles, temperatures or worse.
const LENGTHS: &[&str] = &[
    "Angularity",
    "Chord",
    "Circularity",
    "CircularRunout",
    "Coaxiality",
    "Concentricity",
    "ConicalTaper",
    "Conicity",
    "CurveLength",
    "Cylindricity",
    "Depth",
    "DistanceBetween",
    "DistanceFrom",
    "Ellipticity",
    "FlatTaper",
    "Flatness",
    "Height",
    "Length",
    "LinearCoordinate",
    "LineProfile",
    "OtherForm",
    "Parallelism",
    "Perpendicularity",
    "PointProfile",
    "Position",
    "Radius",
    "SphericalDiameter",
    "SphericalRadius",
    "Sphericity",
    "Square",
    "Straightness",
    "SurfaceProfile",
    "SurfaceProfileNonUniform",
    "Symmetry",
    "Thickness",
    "Toroidicity",
    "TotalRunout",
    "UserDefinedLinear",
];

/// Whether the values of a kind are lengths.
pub(super) fn has_lengths(kind: &str) -> bool {
    is_size(kind) || LENGTHS.contains(&kind)
}

/// Whether a kind is a size of a hole or shaft: a diameter or a width.
pub(super) fn is_size(kind: &str) -> bool {
    matches!(kind, "Diameter" | "Width")
}

/// A kind in words: `CircularRunout` is `circular runout`.
pub(super) fn in_words(kind: &str) -> String {
    let mut words = String::new();
    for c in kind.chars() {
        if c.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(c.to_lowercase());
    }
    words
}
