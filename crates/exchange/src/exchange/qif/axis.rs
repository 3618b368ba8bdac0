//! Which features of a QIF file have a place that a cycle can be sent to: whole circles and cylinders along Z, in the system that
//! the file's coordinates count in.
//!
//! The normal of a circle and the direction of a cylinder are unit vectors (`Features.xsd`, `Primitives.xsd`). Their sign says nothing of
//! the side on which a hole opens, so a bore along −Z is one along Z. Coordinates count in the common system of the file, whatever
//! system a feature is checked in; where that is another one, it is not known which of the two is the machine's.

use super::kinds::in_words;
use super::units::Number;
use crate::exchange::given::shorten;
use crate::exchange::no_place::NoPlace;
use crate::exchange::xml::Element;

/// How far a unit vector may be off Z: a micrometre in a metre. Files hold doubles, with noise behind their decimals.
const MOST_OFF: f64 = 1e-6;

/// Features that cycles 421 and 422 probe; an arc or a segment has no wall all around.
const PROBED: [&str; 2] = ["Circle", "Cylinder"];

/// A place of a feature, or why it is none.
pub(super) type Placed = Result<Number, NoPlace>;

/// The place of a nominal or measured feature; `None` where it says none.
pub(super) fn placed(element: &Element) -> Option<Placed> {
    let place = element.child("Location").or_else(|| element.at(&["Axis", "AxisPoint"]))?;
    // A value that stands there only because one has to (`ValidityEnumType`).
    if matches!(place.start.attribute("validity"), "DUMMY" | "MOOT") {
        return None;
    }
    let place = Number::of(place)?;
    let name = &element.start.name;
    let kind = name.strip_suffix("FeatureNominal").or_else(|| name.strip_suffix("FeatureMeasurement"));
    if let Some(kind) = kind.filter(|kind| !PROBED.contains(kind)) {
        return Some(Err(NoPlace::Kind { kind: in_words(kind) }));
    }
    let axis = match element.text_at(&["Axis", "Direction"]) {
        "" => element.text_at(&["Normal"]),
        direction => direction,
    };
    Some(match along_z(axis) {
        _ if axis.is_empty() => Err(NoPlace::NoAxis),
        true => Ok(place),
        false => Err(NoPlace::Axis { axis: shorten(axis) }),
    })
}

/// Whether a vector is that of Z, or its opposite.
fn along_z(vector: &str) -> bool {
    let parts: Option<Vec<f64>> = vector.split_whitespace().map(|part| part.parse().ok()).collect();
    let Some([x, y, z]) = parts.as_deref() else { return false };
    0.0 < z.abs() && z.is_finite() && libm::hypot(*x, *y) <= MOST_OFF * z.abs()
}

/// Whether a coordinate system is the one that the file's coordinates count in: its transform is known and changes nothing.
pub(super) fn is_common(system: &Element) -> bool {
    let is = |path: &[&str], expected: [f64; 3]| {
        let text = system.text_at(path);
        let parts: Option<Vec<f64>> = text.split_whitespace().map(|part| part.parse().ok()).collect();
        let is_near = |parts: Vec<f64>| {
            parts.len() == 3 && parts.iter().zip(expected).all(|(part, expected)| (part - expected).abs() <= MOST_OFF)
        };
        text.is_empty() || parts.is_some_and(is_near)
    };
    let turned = |axis, expected| is(&["NominalTransform", "Rotation", axis], expected);
    system.child("NominalTransform").is_some()
        && turned("XDirection", [1.0, 0.0, 0.0])
        && turned("YDirection", [0.0, 1.0, 0.0])
        && turned("ZDirection", [0.0, 0.0, 1.0])
        && is(&["NominalTransform", "Origin"], [0.0; 3])
}

#[cfg(test)]
mod tests {
    use super::along_z;

    #[test]
    fn an_axis_is_z_within_the_noise_of_doubles() {
        for (vector, expected) in [
            ("0 0 1", true),
            ("0 0 -1", true),
            ("0.0 -0.0 1.000", true),
            ("6.123233995736766e-17 0 1", true),
            ("0.0000005 0 1", true),
            ("0.000002 0 1", false),
            ("1 0 0", false),
            ("0 1 0", false),
            ("0.7071 0 0.7071", false),
            ("0 0 0", false),
            ("0 0 NaN", false),
            ("0 0 INF", false),
            ("0 0", false),
            ("0 0 1 0", false),
            ("", false),
        ] {
            assert_eq!(along_z(vector), expected, "{vector}");
        }
    }
}
