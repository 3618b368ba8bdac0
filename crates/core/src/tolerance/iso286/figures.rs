//! The figures of ISO 286-1 as they are printed: size steps, standard tolerances, fundamental deviations of shafts.
//!
//! `tests/data/iso286` has the figures and how many independent transcriptions agree on each. They are tabulated and
//! never computed: the standard's formulas with ordinary rounding miss most cells. `zone` derives those of holes.

/// The ends of the main steps in mm: standard tolerances, letters cd to h and j to p.
pub(super) const MAIN_ENDS: [i32; 21] =
    [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150];

/// The ends of the sub-steps in mm: letters a to c and r to zc.
pub(super) const SUB_ENDS: [i32; 41] = [
    3, 6, 10, 14, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500,
    560, 630, 710, 800, 900, 1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2500, 2800, 3150,
];

/// The number of the first main step above 500 mm.
pub(super) const FIRST_ABOVE_500: usize = 13;

/// Standard tolerances in tenths of a micrometre: a row for each of IT01, IT0, IT1 to IT18, a column per main step.
///
/// IT01 and IT0 end at 500 mm. IT14 to IT18 are not used up to 1 mm, which the first column does not show.
pub(super) const STANDARD_TOLERANCES: [&[i32]; 20] = [
    // IT01
    &[3, 4, 4, 5, 6, 6, 8, 10, 12, 20, 25, 30, 40],
    // IT0
    &[5, 6, 6, 8, 10, 10, 12, 15, 20, 30, 40, 50, 60],
    // IT1
    &[8, 10, 10, 12, 15, 15, 20, 25, 35, 45, 60, 70, 80, 90, 100, 110, 130, 150, 180, 220, 260],
    // IT2
    &[12, 15, 15, 20, 25, 25, 30, 40, 50, 70, 80, 90, 100, 110, 130, 150, 180, 210, 250, 300, 360],
    // IT3
    &[20, 25, 25, 30, 40, 40, 50, 60, 80, 100, 120, 130, 150, 160, 180, 210, 240, 290, 350, 410, 500],
    // IT4
    &[30, 40, 40, 50, 60, 70, 80, 100, 120, 140, 160, 180, 200, 220, 250, 280, 330, 390, 460, 550, 680],
    // IT5
    &[40, 50, 60, 80, 90, 110, 130, 150, 180, 200, 230, 250, 270, 320, 360, 400, 470, 550, 650, 780, 960],
    // IT6
    &[60, 80, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400, 440, 500, 560, 660, 780, 920, 1100, 1350],
    // IT7
    &[100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630, 700, 800, 900, 1050, 1250, 1500, 1750, 2100],
    // IT8
    &[140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970, 1100, 1250, 1400, 1650, 1950, 2300, 2800, 3300],
    // IT9
    &[
        250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550, 1750, 2000, 2300, 2600, 3100, 3700, 4400,
        5400,
    ],
    // IT10
    &[
        400, 480, 580, 700, 840, 1000, 1200, 1400, 1600, 1850, 2100, 2300, 2500, 2800, 3200, 3600, 4200, 5000, 6000,
        7000, 8600,
    ],
    // IT11
    &[
        600, 750, 900, 1100, 1300, 1600, 1900, 2200, 2500, 2900, 3200, 3600, 4000, 4400, 5000, 5600, 6600, 7800, 9200,
        11000, 13500,
    ],
    // IT12
    &[
        1000, 1200, 1500, 1800, 2100, 2500, 3000, 3500, 4000, 4600, 5200, 5700, 6300, 7000, 8000, 9000, 10500, 12500,
        15000, 17500, 21000,
    ],
    // IT13
    &[
        1400, 1800, 2200, 2700, 3300, 3900, 4600, 5400, 6300, 7200, 8100, 8900, 9700, 11000, 12500, 14000, 16500,
        19500, 23000, 28000, 33000,
    ],
    // IT14
    &[
        2500, 3000, 3600, 4300, 5200, 6200, 7400, 8700, 10000, 11500, 13000, 14000, 15500, 17500, 20000, 23000, 26000,
        31000, 37000, 44000, 54000,
    ],
    // IT15
    &[
        4000, 4800, 5800, 7000, 8400, 10000, 12000, 14000, 16000, 18500, 21000, 23000, 25000, 28000, 32000, 36000,
        42000, 50000, 60000, 70000, 86000,
    ],
    // IT16
    &[
        6000, 7500, 9000, 11000, 13000, 16000, 19000, 22000, 25000, 29000, 32000, 36000, 40000, 44000, 50000, 56000,
        66000, 78000, 92000, 110_000, 135_000,
    ],
    // IT17
    &[
        10000, 12000, 15000, 18000, 21000, 25000, 30000, 35000, 40000, 46000, 52000, 57000, 63000, 70000, 80000, 90000,
        105_000, 125_000, 150_000, 175_000, 210_000,
    ],
    // IT18
    &[
        14000, 18000, 22000, 27000, 33000, 39000, 46000, 54000, 63000, 72000, 81000, 89000, 97000, 110_000, 125_000,
        140_000, 165_000, 195_000, 230_000, 280_000, 330_000,
    ],
];

/// Which steps a row of fundamental deviations is printed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Steps {
    Main,
    Sub,
}

/// The fundamental deviations of a letter in micrometres: es of a to h, ei of k to zc.
pub(super) struct LetterDeviations {
    pub steps: Steps,
    /// The number of the first step.
    pub first: usize,
    pub um: &'static [i16],
}

const fn main_steps(um: &'static [i16]) -> LetterDeviations {
    LetterDeviations { steps: Steps::Main, first: 0, um }
}

const fn sub_steps(first: usize, um: &'static [i16]) -> LetterDeviations {
    LetterDeviations { steps: Steps::Sub, first, um }
}

/// es of a.
pub(super) const A: LetterDeviations = sub_steps(
    0,
    &[
        -270, -270, -280, -290, -290, -300, -300, -310, -320, -340, -360, -380, -410, -460, -520, -580, -660, -740,
        -820, -920, -1050, -1200, -1350, -1500, -1650,
    ],
);

/// es of b.
pub(super) const B: LetterDeviations = sub_steps(
    0,
    &[
        -140, -140, -150, -150, -150, -160, -160, -170, -180, -190, -200, -220, -240, -260, -280, -310, -340, -380,
        -420, -480, -540, -600, -680, -760, -840,
    ],
);

/// es of c.
pub(super) const C: LetterDeviations = sub_steps(
    0,
    &[
        -60, -70, -80, -95, -95, -110, -110, -120, -130, -140, -150, -170, -180, -200, -210, -230, -240, -260, -280,
        -300, -330, -360, -400, -440, -480,
    ],
);

/// es of cd.
pub(super) const CD: LetterDeviations = main_steps(&[-34, -46, -56, -70, -85, -100]);

/// es of d.
pub(super) const D: LetterDeviations = main_steps(&[
    -20, -30, -40, -50, -65, -80, -100, -120, -145, -170, -190, -210, -230, -260, -290, -320, -350, -390, -430, -480,
    -520,
]);

/// es of e.
pub(super) const E: LetterDeviations = main_steps(&[
    -14, -20, -25, -32, -40, -50, -60, -72, -85, -100, -110, -125, -135, -145, -160, -170, -195, -220, -240, -260, -290,
]);

/// es of ef.
pub(super) const EF: LetterDeviations = main_steps(&[-10, -14, -18, -23, -28, -35]);

/// es of f.
pub(super) const F: LetterDeviations = main_steps(&[
    -6, -10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62, -68, -76, -80, -86, -98, -110, -120, -130, -145,
]);

/// es of fg.
pub(super) const FG: LetterDeviations = main_steps(&[-4, -6, -8, -10, -12, -15]);

/// es of g.
pub(super) const G: LetterDeviations =
    main_steps(&[-2, -4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18, -20, -22, -24, -26, -28, -30, -32, -34, -38]);

/// ei of j5 and j6, to 500 mm.
pub(super) const J5_AND_6: LetterDeviations = main_steps(&[-2, -2, -2, -3, -4, -5, -7, -9, -11, -13, -16, -18, -20]);

/// ei of j7, to 500 mm.
pub(super) const J7: LetterDeviations = main_steps(&[-4, -4, -5, -6, -8, -10, -12, -15, -18, -21, -26, -28, -32]);

/// ei of k4 to k7, to 500 mm; 0 in every other grade and size.
pub(super) const K: LetterDeviations = main_steps(&[0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5]);

/// ei of m.
pub(super) const M: LetterDeviations =
    main_steps(&[2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23, 26, 30, 34, 40, 48, 58, 68, 76]);

/// ei of n.
pub(super) const N: LetterDeviations =
    main_steps(&[4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40, 44, 50, 56, 66, 78, 92, 110, 135]);

/// ei of p.
pub(super) const P: LetterDeviations =
    main_steps(&[6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68, 78, 88, 100, 120, 140, 170, 195, 240]);

/// ei of r.
pub(super) const R: LetterDeviations = sub_steps(
    0,
    &[
        10, 15, 19, 23, 23, 28, 28, 34, 34, 41, 43, 51, 54, 63, 65, 68, 77, 80, 84, 94, 98, 108, 114, 126, 132, 150,
        155, 175, 185, 210, 220, 250, 260, 300, 330, 370, 400, 440, 460, 550, 580,
    ],
);

/// ei of s.
pub(super) const S: LetterDeviations = sub_steps(
    0,
    &[
        14, 19, 23, 28, 28, 35, 35, 43, 43, 53, 59, 71, 79, 92, 100, 108, 122, 130, 140, 158, 170, 190, 208, 232, 252,
        280, 310, 340, 380, 430, 470, 520, 580, 640, 720, 820, 920, 1000, 1100, 1250, 1400,
    ],
);

/// ei of t.
pub(super) const T: LetterDeviations = sub_steps(
    6,
    &[
        41, 48, 54, 66, 75, 91, 104, 122, 134, 146, 166, 180, 196, 218, 240, 268, 294, 330, 360, 400, 450, 500, 560,
        620, 680, 780, 840, 960, 1050, 1200, 1350, 1500, 1650, 1900, 2100,
    ],
);

/// ei of u.
pub(super) const U: LetterDeviations = sub_steps(
    0,
    &[
        18, 23, 28, 33, 33, 41, 48, 60, 70, 87, 102, 124, 144, 170, 190, 210, 236, 258, 284, 315, 350, 390, 435, 490,
        540, 600, 660, 740, 840, 940, 1050, 1150, 1300, 1450, 1600, 1850, 2000, 2300, 2500, 2900, 3200,
    ],
);

/// ei of v.
pub(super) const V: LetterDeviations =
    sub_steps(4, &[39, 47, 55, 68, 81, 102, 120, 146, 172, 202, 228, 252, 284, 310, 340, 385, 425, 475, 530, 595, 660]);

/// ei of x.
pub(super) const X: LetterDeviations = sub_steps(
    0,
    &[
        20, 28, 34, 40, 45, 54, 64, 80, 97, 122, 146, 178, 210, 248, 280, 310, 350, 385, 425, 475, 525, 590, 660, 740,
        820,
    ],
);

/// ei of y.
pub(super) const Y: LetterDeviations =
    sub_steps(5, &[63, 75, 94, 114, 144, 174, 214, 254, 300, 340, 380, 425, 470, 520, 580, 650, 730, 820, 920, 1000]);

/// ei of z.
pub(super) const Z: LetterDeviations = sub_steps(
    0,
    &[
        26, 35, 42, 50, 60, 73, 88, 112, 136, 172, 210, 258, 310, 365, 415, 465, 520, 575, 640, 710, 790, 900, 1000,
        1100, 1250,
    ],
);

/// ei of za.
pub(super) const ZA: LetterDeviations = sub_steps(
    0,
    &[
        32, 42, 52, 64, 77, 98, 118, 148, 180, 226, 274, 335, 400, 470, 535, 600, 670, 740, 820, 920, 1000, 1150, 1300,
        1450, 1600,
    ],
);

/// ei of zb.
pub(super) const ZB: LetterDeviations = sub_steps(
    0,
    &[
        40, 50, 67, 90, 108, 136, 160, 200, 242, 300, 360, 445, 525, 620, 700, 780, 880, 960, 1050, 1200, 1300, 1500,
        1650, 1850, 2100,
    ],
);

/// ei of zc.
pub(super) const ZC: LetterDeviations = sub_steps(
    0,
    &[
        60, 80, 97, 130, 150, 188, 218, 274, 325, 405, 480, 585, 690, 800, 900, 1000, 1150, 1250, 1350, 1550, 1700,
        1900, 2100, 2400, 2600,
    ],
);

/// ei of j8, to 3 mm.
pub(super) const J8: LetterDeviations = main_steps(&[-6]);

/// ES of J6, J7 and J8, to 500 mm.
pub(super) const HOLE_J: [LetterDeviations; 3] = [
    main_steps(&[2, 5, 5, 6, 8, 10, 13, 16, 18, 22, 25, 29, 33]),
    main_steps(&[4, 6, 8, 10, 12, 14, 18, 22, 26, 30, 36, 39, 43]),
    main_steps(&[6, 10, 12, 15, 20, 24, 28, 34, 41, 47, 55, 60, 66]),
];
