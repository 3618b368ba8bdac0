//! The outcome of measuring: a diameter, perhaps a centre and contacts, and its origin.

use std::sync::Arc;

use super::circle::{Circle, CircleError, TooLarge, TwoPoint, least_squares};
use super::contact::Contact;
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::Bounds;
use crate::tolerance::callout::{FormClass, Modifier};

/// A measured diameter and all that is known about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The diameter, rounded to the nearest nanometre.
    pub diameter: Length,
    /// The centre in reference and minor axis, where it was measured.
    pub centre: Option<[Length; 2]>,
    /// The contacts in probing order; none for a typed or imported diameter.
    pub contacts: Vec<Contact>,
    /// The least-squares circle through the contacts, unrounded.
    pub circle: Option<Circle>,
    /// Where it comes from.
    pub origin: Origin,
}

/// Where a measurement comes from.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "origin")]
pub enum Origin {
    /// A cycle on the simulated workpiece.
    Simulated {
        /// The cycle's number, 421 or 422.
        cycle: u16,
        /// The seed of the scatter: the same seed gives the same contacts.
        seed: u64,
    },
    /// Contacts from a file.
    Contacts {
        /// The file's name without its folder.
        file: Arc<str>,
    },
    /// A diameter from a file.
    Imported {
        /// The file's name without its folder.
        file: Arc<str>,
    },
    /// A diameter from a file that says that it was simulated.
    ImportedSimulation {
        /// The file's name without its folder.
        file: Arc<str>,
    },
    /// A diameter that somebody typed.
    Typed,
}

impl Origin {
    /// Whether nobody measured: no such value may pass for a measured one.
    pub const fn is_simulated(&self) -> bool {
        matches!(self, Self::Simulated { .. } | Self::ImportedSimulation { .. })
    }
}

/// What a measurement cannot tell. Shown in the window and on every report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "caveat")]
pub enum Caveat {
    /// Only one number is known.
    OnlyADiameter,
    /// A log without contacts: diameter and centre are known.
    OnlyACircle,
    /// A circle goes through any three contacts: the residual is always zero.
    ThreeContacts,
    /// Four contacts: two diameters and a mean; four lobes are invisible.
    FourContacts,
    /// More contacts, but still only single points.
    FewContacts {
        /// How many.
        contacts: usize,
    },
    /// The contacts cover less than 180 degrees.
    ShortArc {
        /// The covered arc in whole degrees.
        #[say(name = "arc")]
        arc_deg: u16,
    },
    /// The diameter across two opposite contacts is beyond a limit that the mean circle keeps: by default a size holds for each two
    /// opposite points (ISO 14405-1, LP).
    TwoPoint {
        /// The contacts, from 1.
        one: usize,
        /// The other one.
        other: usize,
        /// The diameter, to the nearest nanometre.
        size: Length,
        /// The limit that it is beyond.
        limit: Length,
    },
    /// Diameters across the contacts may differ by more than the whole tolerance zone: some of them are out then, whatever the mean
    /// circle is.
    Form {
        /// The largest radial deviation minus the smallest.
        #[say(with = three_decimals)]
        form: Length,
        /// How wide the zone is.
        #[say(with = three_decimals)]
        zone: Length,
    },
    /// The contacts lie at very different heights.
    Heights {
        /// The largest height minus the smallest, to the nearest micrometre.
        #[say(with = three_decimals)]
        spread: Length,
    },
    /// The callout has deviations behind its tolerance that are not those of the tolerance.
    Stated {
        /// The upper one behind the tolerance.
        #[say(with = micrometres)]
        upper: Length,
        /// The lower one behind the tolerance.
        #[say(with = micrometres)]
        lower: Length,
        /// The upper deviation that counts.
        #[say(with = micrometres)]
        used_upper: Length,
        /// The lower deviation that counts.
        #[say(with = micrometres)]
        used_lower: Length,
    },
    /// The callout is for several features.
    Count {
        /// How many.
        count: u16,
    },
    /// The callout has a class for form.
    FormClass {
        /// The class of ISO 2768-2.
        class: FormClass,
    },
    /// Each two-point size is asked for, and one diameter is known.
    EachTwoPoint {
        /// The modifier.
        modifier: Modifier,
    },
    /// Each two-point size is asked for, and a mean circle is known.
    MeanOfTwoPoints {
        /// The modifier.
        modifier: Modifier,
    },
    /// The least-squares size is asked for, and one diameter is known.
    NotLeastSquares {
        /// The modifier.
        modifier: Modifier,
    },
    /// The least-squares size is asked for, and the least-squares circle of one section is known.
    OneSection {
        /// The modifier.
        modifier: Modifier,
    },
    /// An envelope is asked for.
    Envelope {
        /// The modifier.
        modifier: Modifier,
    },
    /// Another size is asked for.
    OtherSize {
        /// The modifier.
        modifier: Modifier,
    },
    /// A modifier says where or how the size holds.
    Condition {
        /// The modifier.
        modifier: Modifier,
    },
}

impl Caveat {
    /// What the contacts of a circle, in its plane, say against limits of its diameter; `None` where they say nothing. `judged` is the
    /// diameter that was compared with the limits: it may have been brought to 20 °C, and what lies across the contacts with it.
    pub(super) fn of_form(
        contacts: &[Contact],
        circle: &Circle,
        judged: Length,
        [minimum, maximum]: [Length; 2],
    ) -> Option<Self> {
        let two_point = Self::of_two_points(contacts, circle, judged, [minimum, maximum]);
        two_point.or_else(|| Self::of_spread(contacts, circle, maximum.saturating_sub(minimum)))
    }

    /// The diameter across two contacts that is farthest beyond a limit which the mean circle keeps. Where that is beyond the same
    /// limit the verdict says so already.
    fn of_two_points(
        contacts: &[Contact],
        circle: &Circle,
        judged: Length,
        [minimum, maximum]: [Length; 2],
    ) -> Option<Self> {
        let correction = judged.saturating_sub(Length::from_mm_f64(circle.diameter).ok()?);
        let beyond = |found: &TwoPoint| {
            let size = Length::from_mm_f64(found.through_centre()).ok()?.checked_add(correction)?;
            let [one, other] = found.contacts;
            let below = (size < minimum && minimum <= judged).then(|| (minimum.saturating_sub(size), minimum));
            let above = (maximum < size && judged <= maximum).then(|| (size.saturating_sub(maximum), maximum));
            let (by, limit) = below.or(above)?;
            Some((by, Self::TwoPoint { one, other, size, limit }))
        };
        let found = super::circle::two_point(contacts, circle);
        found.iter().filter_map(beyond).max_by_key(|(by, _)| *by).map(|(_, caveat)| caveat)
    }

    /// Radii that differ by more than half the zone.
    fn of_spread(contacts: &[Contact], circle: &Circle, zone: Length) -> Option<Self> {
        let radii = contacts.iter().map(|contact| libm::hypot(contact.x - circle.x, contact.y - circle.y));
        let (least, most) =
            radii.fold((f64::INFINITY, 0.0_f64), |(least, most), radius| (least.min(radius), most.max(radius)));
        let form = Length::from_mm_f64(most - least).ok()?;
        (zone < form.checked_add(form).unwrap_or(Length::MAX)).then_some(Self::Form { form, zone })
    }
}

/// Micrometres with their sign.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "derive(Say) hands over references")]
fn micrometres(length: &Length) -> String {
    length.signed_um()
}

/// A length in millimetres with three decimals.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "derive(Say) hands over references")]
fn three_decimals(length: &Length) -> String {
    format!("{:.3}", length.to_mm_f64())
}

/// Measures a circle from any number of contacts, at least three: the least-squares circle.
///
/// # Errors
/// [`CircleError`] says why the contacts do not make a circle.
pub fn measure_contacts(contacts: &[Contact], origin: Origin) -> Result<Measurement, CircleError> {
    Measurement::of_circle(least_squares(contacts)?, contacts.to_vec(), origin)
}

/// A geometric result, rounded to the nearest nanometre.
fn rounded(what: TooLarge, mm: f64) -> Result<Length, CircleError> {
    Length::from_mm_f64(mm).map_err(|_range| CircleError::TooLarge { what, value: mm })
}

impl Measurement {
    /// A fitted circle; diameter and centre become lengths here, once, rounded to the nearest nanometre.
    ///
    /// # Errors
    /// [`CircleError::TooLarge`] where a diameter or a centre is beyond [`Length::MAX`].
    pub fn of_circle(circle: Circle, contacts: Vec<Contact>, origin: Origin) -> Result<Self, CircleError> {
        let diameter = rounded(TooLarge::Diameter, circle.diameter)?;
        let centre = Some([
            rounded(TooLarge::Centre { axis: 'x' }, circle.x)?,
            rounded(TooLarge::Centre { axis: 'y' }, circle.y)?,
        ]);
        Ok(Self { diameter, centre, contacts, circle: Some(circle), origin })
    }

    /// A bare diameter that was typed or imported.
    pub const fn of_diameter(diameter: Length, origin: Origin) -> Self {
        Self { diameter, centre: None, contacts: Vec::new(), circle: None, origin }
    }

    /// What this measurement cannot tell, and what its contacts say against limits.
    pub fn caveats_of(&self, bounds: &Bounds) -> Vec<Caveat> {
        let mut caveats = self.caveats();
        let limits = [bounds.minimum(), bounds.maximum()];
        let of_form = |circle| Caveat::of_form(&self.contacts, &circle, self.diameter, limits);
        caveats.extend(self.circle.and_then(of_form));
        caveats
    }

    /// What this measurement cannot tell.
    pub fn caveats(&self) -> Vec<Caveat> {
        let mut caveats = vec![match self.contacts.len() {
            0 if self.centre.is_some() => Caveat::OnlyACircle,
            0 => Caveat::OnlyADiameter,
            1..=3 => Caveat::ThreeContacts,
            4 => Caveat::FourContacts,
            contacts => Caveat::FewContacts { contacts },
        }];
        if let Some(circle) = &self.circle {
            let arc_deg = super::circle::arc_deg(&self.contacts, circle).round();
            if arc_deg < 180.0 {
                #[expect(
                    clippy::as_conversions,
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "an arc is 0 to 360"
                )]
                caveats.push(Caveat::ShortArc { arc_deg: arc_deg as u16 });
            }
            let spread = super::circle::heights(&self.contacts, circle.diameter);
            caveats.extend(
                spread.map(|spread| Caveat::Heights { spread: Length::from_mm_f64(spread).unwrap_or(Length::MAX) }),
            );
        }
        caveats
    }
}
