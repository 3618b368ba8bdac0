//! What a measured diameter says of what stands beside a callout: deviations in brackets, a count, modifiers of ISO 14405-1.

use super::measurement::{Caveat, Measurement};
use crate::tolerance::Limits;
use crate::tolerance::callout::{Modifier, ModifierGroup, Notes};

/// What the notes of a callout ask for and a measurement does not show, and what contradicts the limits that were used. Empty for a
/// callout without notes.
pub fn caveats(notes: &Notes, limits: &Limits, measurement: &Measurement) -> Vec<Caveat> {
    let is_circle = measurement.circle.is_some();
    let stated = differing(notes, limits);
    let count = notes.count.map(|count| Caveat::Count { count });
    let modifiers = notes.modifiers.iter().map(|modifier| of_modifier(modifier, is_circle));
    let form = notes.form.map(|class| Caveat::FormClass { class });
    stated.into_iter().chain(count).chain(modifiers).chain(form).collect()
}

/// Deviations behind the tolerance of a callout that are not those of its limits: which of them the drawing means has to be asked.
pub fn differing(notes: &Notes, limits: &Limits) -> Option<Caveat> {
    let stated = notes.stated?;
    let used = limits.deviations;
    (stated != used).then(|| Caveat::Stated {
        upper: stated.upper(),
        lower: stated.lower(),
        used_upper: used.upper(),
        used_lower: used.lower(),
    })
}

/// What one diameter, or the least-squares circle of one section, leaves open.
const fn of_modifier(modifier: Modifier, is_circle: bool) -> Caveat {
    match (modifier.group(), is_circle) {
        (ModifierGroup::TwoPoint, false) => Caveat::EachTwoPoint { modifier },
        (ModifierGroup::TwoPoint, true) => Caveat::MeanOfTwoPoints { modifier },
        (ModifierGroup::LeastSquares, false) => Caveat::NotLeastSquares { modifier },
        (ModifierGroup::LeastSquares, true) => Caveat::OneSection { modifier },
        (ModifierGroup::Envelope, _) => Caveat::Envelope { modifier },
        (ModifierGroup::OtherSize, _) => Caveat::OtherSize { modifier },
        (ModifierGroup::Condition, _) => Caveat::Condition { modifier },
    }
}
