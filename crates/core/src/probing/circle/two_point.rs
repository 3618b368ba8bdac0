//! Two-point sizes: distances between contacts that are opposite each other.

use super::frame::{Frame, dot, minus, norm};
use crate::probing::contact::Contact;

/// Contacts are opposite each other when they lie within this many degrees of 180 apart, seen from the least-squares
/// centre: on a diameter of 25 mm the chord is then at most 1 µm too short. Our choice.
const WITHIN_DEG: f64 = 1.0;

/// A size between two opposed contacts, ISO 14405-1 (LP).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct TwoPoint {
    /// The two contacts, counted from 1.
    pub contacts: [usize; 2],
    /// Their distance in millimetres.
    pub size: f64,
    /// Direction of the chord in degrees from the reference axis, from -90 (excluded) to 90.
    pub direction_deg: f64,
    /// How much shorter the chord is than the diameter because it misses the centre: 2 e² / D, millimetres.
    pub short_by: f64,
}

impl TwoPoint {
    /// The size through the centre, in millimetres: what the chord would be if it met it.
    pub fn through_centre(&self) -> f64 {
        self.size + self.short_by
    }
}

/// Pairs of contacts that are each other's best opposite, sorted by the lower number.
pub(super) fn opposed(contacts: &[Contact], frame: &Frame, centre: [f64; 2]) -> Vec<TwoPoint> {
    let places: Vec<_> = contacts.iter().map(|contact| minus(frame.place(contact), centre)).collect();
    let mut angles: Vec<(f64, usize)> = places.iter().map(|[x, y]| libm::atan2(*y, *x).to_degrees()).zip(0..).collect();
    angles.sort_by(|(a, a_index), (b, b_index)| a.total_cmp(b).then(a_index.cmp(b_index)));
    let opposite: Vec<Option<usize>> =
        places.iter().map(|[x, y]| nearest(&angles, libm::atan2(-y, -x).to_degrees())).collect();
    let mut sizes = Vec::new();
    for (first, &second) in opposite.iter().enumerate() {
        let Some(second) = second.filter(|&second| first < second) else { continue };
        let mutual = opposite.get(second).is_some_and(|&back| back == Some(first));
        if let (true, Some(&from), Some(&to)) = (mutual, places.get(first), places.get(second)) {
            sizes.push(size(frame, [first + 1, second + 1], from, to));
        }
    }
    sizes
}

fn size(frame: &Frame, contacts: [usize; 2], from: [f64; 2], to: [f64; 2]) -> TwoPoint {
    let chord = minus(to, from);
    let distance = norm(chord);
    let diameter = norm(from) + norm(to);
    let [x, y] = if dot(chord, [1.0, 0.0]) < 0.0 { minus(from, to) } else { chord };
    let direction_deg = libm::atan2(y, x).to_degrees();
    TwoPoint {
        contacts,
        size: frame.length(distance),
        direction_deg: if direction_deg <= -90.0 { 90.0 } else { direction_deg },
        short_by: frame.length((diameter - distance).max(0.0)),
    }
}

/// The contact whose direction is nearest to the wanted one, if it is near enough; the first of equally near ones.
fn nearest(angles: &[(f64, usize)], wanted: f64) -> Option<usize> {
    let after = angles.partition_point(|(angle, _)| *angle < wanted);
    let candidates = [after.checked_sub(1).unwrap_or(angles.len().saturating_sub(1)), after % angles.len().max(1)];
    let apart = |angle: f64| {
        let apart = (angle - wanted).abs();
        apart.min(360.0 - apart)
    };
    candidates
        .iter()
        .filter_map(|&index| angles.get(index))
        .map(|&(angle, contact)| (apart(angle), contact))
        .filter(|&(apart, _)| apart <= WITHIN_DEG)
        .min_by(|(a, a_contact), (b, b_contact)| a.total_cmp(b).then(a_contact.cmp(b_contact)))
        .map(|(_, contact)| contact)
}
