//! What is measured of a feature of a plan, and within which limits.
//!
//! A kind holds the callouts of its sides, so that none has a tolerance that it cannot have. `cells` reads it from a plan.

use crate::length::Length;
use crate::probing::cycle::{Axis, Control, Cycle, Value};
use crate::probing::cycles::measuring_cycles_of;
use crate::probing::simulated::Shape;
use crate::probing::vector;
use crate::tolerance::{Callout, Deviations, Feature};

/// What is measured of a feature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FeatureKind {
    /// The diameter of a hole or a shaft.
    Diameter(Callout),
    /// The width of a slot or a ridge.
    Width(Callout, WidthAxis),
    /// The coordinate of a face.
    Face(Callout, Towards),
    /// The sides of a pocket along X and along Y.
    Pocket([Callout; 2]),
    /// The sides of a boss along X and along Y.
    Boss([Callout; 2]),
    /// How far a surface lies from its nominal place, along its normal; plus is out of the material.
    Point(Deviations, Direction),
    /// A length that no cycle measures: a distance, a depth, a radius. It is measured by hand or comes from a file.
    Length(Callout),
    /// A form or location tolerance with its one limit, such as a flatness: 0 up to and including this. It comes as a length does.
    Form(Length),
}

/// The axis across the walls of a slot or ridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WidthAxis {
    /// X.
    #[default]
    X,
    /// Y.
    Y,
}

impl WidthAxis {
    /// The unit vector.
    pub const fn vector(self) -> [f64; 3] {
        match self {
            Self::X => [1.0, 0.0, 0.0],
            Self::Y => [0.0, 1.0, 0.0],
        }
    }
}

/// The direction in which a face is probed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Towards {
    /// The axis.
    pub axis: Axis,
    /// Whether the probe moves in plus direction.
    pub is_plus: bool,
}

impl Towards {
    /// The unit vector.
    pub fn vector(self) -> [f64; 3] {
        let sign = if self.is_plus { 1.0 } else { -1.0 };
        [Axis::First, Axis::Second, Axis::Third].map(|axis| if axis == self.axis { sign } else { 0.0 })
    }
}

/// The direction in which a point is probed: three components along X, Y and Z, each at most 10 either way and with at
/// most nine decimals, not all zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction([f64; 3]);

impl Direction {
    /// The largest component, as the cycle takes it.
    pub const MOST: f64 = 10.0;

    /// The most decimals of a component: programs have them as they are.
    pub const DECIMALS: usize = 9;

    /// A direction; `None` where it is none, or a component is too large or too fine.
    pub fn new(components: [f64; 3]) -> Option<Self> {
        let decimals = |part: &f64| part.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let is_sound = components.iter().all(|part| part.abs() <= Self::MOST && decimals(part) <= Self::DECIMALS);
        (is_sound && vector::direction(components).is_some()).then_some(Self(components))
    }

    /// The normal of the surface, out of the material: against the probing, as long as the components that were given.
    pub fn normal(self) -> [f64; 3] {
        // Not -0.
        self.0.map(|part| 0.0 - part)
    }

    /// The normal with length 1.
    pub fn unit_normal(self) -> [f64; 3] {
        vector::unit(self.normal())
    }
}

impl FeatureKind {
    /// The callouts of its sizes, with their classes: two of a pocket or boss, none of a point or a form.
    pub fn callouts(&self) -> Vec<Callout> {
        match self {
            Self::Diameter(callout) | Self::Width(callout, _) | Self::Face(callout, _) | Self::Length(callout) => {
                vec![*callout]
            }
            Self::Pocket(sides) | Self::Boss(sides) => sides.to_vec(),
            Self::Point(..) | Self::Form(_) => Vec::new(),
        }
    }

    /// What it asks for, as programs and pages have it: `25 H7`, `40 H7 x 25 H8`; the band of a point as the cycle takes
    /// it, `0.1-0.05`; the limit of a form.
    pub fn asked(&self) -> String {
        match self {
            Self::Point(band, _) => return band_text(*band),
            Self::Form(most) => return most.to_string(),
            _ => {}
        }
        self.callouts().iter().map(ToString::to_string).collect::<Vec<_>>().join(" x ")
    }

    /// Its name in a plan.
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Diameter(_) => "diameter",
            Self::Width(..) => "width",
            Self::Face(..) => "face",
            Self::Pocket(_) => "pocket",
            Self::Boss(_) => "boss",
            Self::Point(..) => "point",
            Self::Length(_) => "length",
            Self::Form(_) => "form",
        }
    }

    /// Whether no cycle measures it.
    pub const fn is_by_hand(&self) -> bool {
        matches!(self, Self::Length(_) | Self::Form(_))
    }

    /// The shape of a feature of this kind that is a hole or a shaft; `None` of what no cycle measures.
    pub const fn shape(&self, feature: Feature) -> Option<Shape> {
        Some(match (self, feature) {
            (Self::Diameter(_), Feature::Hole) => Shape::Hole,
            (Self::Diameter(_), Feature::Shaft) => Shape::Stud,
            (Self::Width(..), Feature::Hole) => Shape::Slot,
            (Self::Width(..), Feature::Shaft) => Shape::Ridge,
            (Self::Face(..), _) => Shape::Face,
            (Self::Pocket(_), _) => Shape::Pocket,
            (Self::Boss(_), _) => Shape::Boss,
            (Self::Point(..), _) => Shape::Point,
            (Self::Length(_) | Self::Form(_), _) => return None,
        })
    }

    /// The usual cycle that measures it on a milling machine.
    pub fn cycle(&self, feature: Feature) -> Option<&'static Cycle> {
        measuring_cycles_of(Control::Milling).find(|cycle| Some(cycle.shape()) == self.shape(feature))
    }

    /// What is added to a feature's name for each of its sizes: nothing where it has one.
    pub const fn sides(&self) -> &'static [&'static str] {
        match self {
            Self::Pocket(_) | Self::Boss(_) => &["X", "Y"],
            Self::Diameter(_)
            | Self::Width(..)
            | Self::Face(..)
            | Self::Point(..)
            | Self::Length(_)
            | Self::Form(_) => &[""],
        }
    }

    /// The names of all kinds in a plan.
    pub const WORDS: [&'static str; 8] = ["diameter", "width", "face", "pocket", "boss", "point", "length", "form"];
}

/// A band as the cycle takes it.
pub fn band_text(band: Deviations) -> String {
    Value::Band(Some(band)).to_string()
}
