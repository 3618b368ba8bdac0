//! Contacts that lie apart from where a cycle probes: perhaps those of another feature, or in another order.

use super::remark::Remark;
use crate::length::Length;
use crate::probing::contact::{Contact, NoContact, Touch};
use crate::probing::vector::{along, dot, norm};

/// A contact further from the probing movement than this is told, mm. Ours: a centre that is off by a millimetre is seldom meant,
/// and the point of the surface lies beside the movement only by a part of the ball's radius.
const NEAR: f64 = 1.0;

/// The contact of a cycle that lies farthest from its probing movement, and how many there are.
#[derive(Debug, Default)]
pub(super) struct Astray {
    count: usize,
    farthest: f64,
    number: usize,
}

impl Astray {
    /// Looks at the contact of a probing, by its number from 1, and at its height where that is known.
    pub(super) fn look(&mut self, number: usize, touch: &Touch, contact: &Contact, has_height: bool) {
        let distance = distance(touch, contact, has_height);
        if NEAR < distance {
            self.count += 1;
            if self.farthest < distance {
                self.farthest = distance;
                self.number = number;
            }
        }
    }

    /// What is worth knowing about it.
    pub(super) fn remark(&self) -> Option<Remark> {
        let Self { count, farthest, number } = *self;
        (0 < count).then_some(Remark::ContactAstray { count, contact: number, distance: to_a_hundredth(farthest) })
    }
}

/// To a hundredth of a millimetre, which is more than enough to find a contact.
fn to_a_hundredth(distance: f64) -> Length {
    Length::from_mm_f64((distance * 100.0).round() / 100.0).unwrap_or(Length::MAX)
}

/// Why a recorded contact cannot be of a probing: it is farther from where that begins than the ball travels. The set-up clearance of
/// the table is added, because it may be another one than that of the probe that made the contact.
pub(super) fn beyond(
    number: usize,
    touch: &Touch,
    contact: &Contact,
    (has_height, set_up): (bool, Length),
) -> Option<NoContact> {
    let [from_x, from_y, from_z] = touch.from;
    let [x, y, z] = contact.place();
    let height = if has_height { z - from_z } else { 0.0 };
    let distance = norm([x - from_x, y - from_y, height]);
    let allowed = touch.longest + set_up.to_mm_f64();
    // What is too far away to be a length is refused by the cycle, with its own number.
    Length::from_mm_f64(distance).ok()?;
    (allowed < distance).then(|| NoContact::BeyondTravel {
        number,
        distance: to_a_hundredth(distance),
        allowed: to_a_hundredth(allowed),
    })
}

/// How far a contact is from the probing movement, mm; seen from above where its height is not known.
fn distance(touch: &Touch, contact: &Contact, has_height: bool) -> f64 {
    let minus = |[x, y, z]: [f64; 3], [ox, oy, oz]: [f64; 3]| [x - ox, y - oy, z - oz];
    let [x, y, _] = touch.from;
    let from = if has_height { touch.from } else { [x, y, contact.z] };
    let way = dot(minus(contact.place(), from), touch.direction).clamp(0.0, touch.longest);
    norm(minus(contact.place(), along(from, touch.direction, way)))
}
