//! Contacts that lie apart from where a cycle probes: perhaps those of another feature, or in another order.

use super::remark::Remark;
use crate::length::Length;
use crate::probing::contact::{Contact, Touch};
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
        // To a hundredth, which is more than enough to find it.
        let distance = Length::from_mm_f64((farthest * 100.0).round() / 100.0).unwrap_or(Length::MAX);
        (0 < count).then_some(Remark::ContactAstray { count, contact: number, distance })
    }
}

/// How far a contact is from the probing movement, mm; seen from above where its height is not known.
fn distance(touch: &Touch, contact: &Contact, has_height: bool) -> f64 {
    let minus = |[x, y, z]: [f64; 3], [ox, oy, oz]: [f64; 3]| [x - ox, y - oy, z - oz];
    let [x, y, _] = touch.from;
    let from = if has_height { touch.from } else { [x, y, contact.z] };
    let way = dot(minus(contact.place(), from), touch.direction).clamp(0.0, touch.longest);
    norm(minus(contact.place(), along(from, touch.direction, way)))
}
