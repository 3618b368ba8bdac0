//! What a plan says of a feature, and of the part: the columns of its table and the keys of its file.

/// What a plan says of a feature. The key is the name in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Column {
    /// The number of its balloon on the drawing.
    Number,
    /// Its name.
    Name,
    /// What is measured: a diameter if not given.
    Kind,
    /// The measured axis of a width, or the direction in which a face or point is probed.
    Axis,
    /// Nominal size and tolerance; the band of a point.
    Callout,
    /// The same for the side of a pocket or boss along Y.
    SecondCallout,
    /// Hole or shaft, where the callout does not say it.
    Feature,
    /// Centre in X, or the point's place, mm.
    X,
    /// Centre in Y, or the point's place, mm.
    Y,
    /// Measuring height in Z, or the point's place, mm.
    Z,
    /// Angle of the first contact from +X, degrees.
    Angle,
    /// Lateral set-up clearance, mm.
    Clearance,
    /// Where the probe moves without a collision, mm.
    ClearanceHeight,
    /// The measuring cycle, where it is not the usual one of the kind.
    Cycle,
    /// Further parameters of the cycle: `Q423=3 Q320=1`.
    Parameters,
    /// The material, or its expansion in millionths per kelvin.
    Material,
    /// The decision rule.
    Rule,
    /// The standard uncertainty, µm.
    Uncertainty,
    /// What a value can be at all: two lengths, mm.
    Plausible,
    /// The same for the side of a pocket or boss along Y.
    SecondPlausible,
    /// Anything else.
    Remark,
    /// Where its balloon is on the picture: from 0 at the left to 1 at the right.
    BalloonX,
    /// From 0 at the top to 1 at the bottom.
    BalloonY,
}

impl Column {
    /// Every column, in the order of files and of the table in the window.
    pub const ALL: [Self; 23] = [
        Self::Number,
        Self::Name,
        Self::Kind,
        Self::Axis,
        Self::Callout,
        Self::SecondCallout,
        Self::Feature,
        Self::X,
        Self::Y,
        Self::Z,
        Self::Angle,
        Self::Clearance,
        Self::ClearanceHeight,
        Self::Cycle,
        Self::Parameters,
        Self::Material,
        Self::Rule,
        Self::Uncertainty,
        Self::Plausible,
        Self::SecondPlausible,
        Self::Remark,
        Self::BalloonX,
        Self::BalloonY,
    ];

    /// The name in files.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Name => "name",
            Self::Kind => "kind",
            Self::Axis => "axis",
            Self::Callout => "callout",
            Self::SecondCallout => "callout2",
            Self::Feature => "feature",
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Angle => "angle",
            Self::Clearance => "clearance",
            Self::ClearanceHeight => "clearance_height",
            Self::Cycle => "cycle",
            Self::Parameters => "parameters",
            Self::Material => "material",
            Self::Rule => "rule",
            Self::Uncertainty => "u_um",
            Self::Plausible => "plausible",
            Self::SecondPlausible => "plausible2",
            Self::Remark => "remark",
            Self::BalloonX => "balloon_x",
            Self::BalloonY => "balloon_y",
        }
    }

    /// Its place among [`Self::ALL`].
    pub fn at(self) -> usize {
        Self::ALL.iter().take_while(|column| **column != self).count()
    }

    /// The column of a name in a file, in any case of letters.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|column| column.key().eq_ignore_ascii_case(key.trim()))
    }

    /// Whether a file has it as a number where it is one.
    pub const fn is_number(self) -> bool {
        matches!(
            self,
            Self::Number
                | Self::X
                | Self::Y
                | Self::Z
                | Self::Angle
                | Self::Clearance
                | Self::ClearanceHeight
                | Self::Cycle
                | Self::Uncertainty
                | Self::BalloonX
                | Self::BalloonY
        )
    }

    /// Whether a file has it as two numbers.
    pub(super) const fn is_range(self) -> bool {
        matches!(self, Self::Plausible | Self::SecondPlausible)
    }

    /// Whether it holds any text: one that a spreadsheet could take for a formula is copied with a mark.
    pub const fn is_free_text(self) -> bool {
        matches!(self, Self::Number | Self::Name | Self::Remark)
    }

    /// The names of all of them, as errors list them.
    pub fn known() -> String {
        Self::ALL.map(Self::key).join(", ")
    }
}

/// What a plan says of the part as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum HeadField {
    /// The part's name or number.
    Part,
    /// The drawing.
    Drawing,
    /// The picture: a PNG, JPEG or SVG file beside the plan.
    Picture,
    /// The material of every feature that names none.
    Material,
    /// The decision rule of every feature that names none.
    Rule,
    /// The standard uncertainty of every feature that names none, µm.
    Uncertainty,
    /// The machine's travel in X: two numbers, mm.
    TravelX,
    /// The same in Y.
    TravelY,
    /// The same in Z.
    TravelZ,
    /// Anything else.
    Remark,
}

impl HeadField {
    /// Every field, in the order of files and of the form.
    pub const ALL: [Self; 10] = [
        Self::Part,
        Self::Drawing,
        Self::Picture,
        Self::Material,
        Self::Rule,
        Self::Uncertainty,
        Self::TravelX,
        Self::TravelY,
        Self::TravelZ,
        Self::Remark,
    ];

    /// The name in files.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Part => "part",
            Self::Drawing => "drawing",
            Self::Picture => "picture",
            Self::Material => "material",
            Self::Rule => "rule",
            Self::Uncertainty => "u_um",
            Self::TravelX => "travel_x",
            Self::TravelY => "travel_y",
            Self::TravelZ => "travel_z",
            Self::Remark => "remark",
        }
    }

    /// Its place among [`Self::ALL`].
    pub fn at(self) -> usize {
        Self::ALL.iter().take_while(|field| **field != self).count()
    }

    /// The field of a name in a file.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.key().eq_ignore_ascii_case(key))
    }

    /// The column of a feature that it stands for where a feature says nothing itself.
    pub const fn column(self) -> Option<Column> {
        match self {
            Self::Material => Some(Column::Material),
            Self::Rule => Some(Column::Rule),
            Self::Uncertainty => Some(Column::Uncertainty),
            _ => None,
        }
    }

    /// Whether a file has it as two numbers.
    pub(super) const fn is_travel(self) -> bool {
        matches!(self, Self::TravelX | Self::TravelY | Self::TravelZ)
    }

    /// The names of all of them, as errors list them.
    pub fn known() -> String {
        Self::ALL.map(Self::key).join(", ")
    }
}
