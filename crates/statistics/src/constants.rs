//! d2, d3 and c4 of control charts: mean and spread of the range and of the standard deviation of normal values.
//!
//! ISO 7870-2, annex; the ranges are integrated from their definitions, and a test integrates them again.

use crate::moments::count;
use crate::reason::Reason;

/// The largest subgroup whose range is used: beyond it the range says little of the spread.
pub const LARGEST_RANGE: usize = 25;

/// Mean and standard deviation of the range of 2 to 25 standard normal values.
const RANGES: [[f64; 2]; LARGEST_RANGE - 1] = [
    [1.128_379_167_095_512_8, 0.852_502_466_427_323_9],
    [1.692_568_750_643_269_4, 0.888_368_004_045_043_1],
    [2.058_750_746_007_928_6, 0.879_808_202_824_754],
    [2.325_928_947_281_040_5, 0.864_081_941_099_197_3],
    [2.534_412_721_222_943_3, 0.848_039_686_117_111_7],
    [2.704_356_751_213_809_6, 0.833_205_335_621_840_4],
    [2.847_200_612_090_557, 0.819_831_489_791_392_8],
    [2.970_026_324_418_476_4, 0.807_834_274_552_679_8],
    [3.077_505_461_670_35, 0.797_050_673_518_669_8],
    [3.172_872_703_816_002_7, 0.787_314_620_549_502_4],
    [3.258_455_279_743_828_6, 0.778_478_341_202_465_6],
    [3.335_980_354_098_257_5, 0.770_416_202_062_740_8],
    [3.406_763_108_199_955_4, 0.763_023_095_623_678_6],
    [3.471_826_889_882_078, 0.756_211_429_726_733],
    [3.531_982_786_109_578_5, 0.749_908_089_408_579_4],
    [3.587_883_961_765_385_3, 0.744_051_783_959_317_9],
    [3.640_063_757_937_447_5, 0.738_590_853_376_663_4],
    [3.688_963_023_207_653, 0.733_481_495_517_250_7],
    [3.734_950_119_596_644_6, 0.728_686_345_705_582_2],
    [3.778_335_829_842_625, 0.724_173_340_715_555_5],
    [3.819_384_643_362_836_7, 0.719_914_808_432_288],
    [3.858_323_423_285_011, 0.715_886_735_489_772],
    [3.895_348_148_451_361, 0.712_068_175_145_796_1],
    [3.930_629_219_507_118, 0.708_440_765_886_394_6],
];

/// From here up the series of c4 is exact to the last bits.
const MANY: f64 = 1_000.0;

/// The entry of a subgroup of this size.
fn ranges(size: usize) -> Result<[f64; 2], Reason> {
    let at = size.checked_sub(2).ok_or(Reason::TooFew { found: size, needed: 2 })?;
    RANGES.get(at).copied().ok_or(Reason::LargeSubgroup { found: size, most: LARGEST_RANGE })
}

/// The mean range of this many standard normal values.
///
/// # Errors
/// Fewer than 2 or more than 25 values.
pub fn d2(size: usize) -> Result<f64, Reason> {
    ranges(size).map(|[mean, _]| mean)
}

/// The standard deviation of the range of this many standard normal values.
///
/// # Errors
/// Fewer than 2 or more than 25 values.
pub fn d3(size: usize) -> Result<f64, Reason> {
    ranges(size).map(|[_, deviation]| deviation)
}

/// The mean standard deviation of this many standard normal values: √(2/(n−1)) Γ(n/2) / Γ((n−1)/2).
///
/// # Errors
/// Fewer than 2 values.
pub fn c4(size: usize) -> Result<f64, Reason> {
    if size < 2 {
        return Err(Reason::TooFew { found: size, needed: 2 });
    }
    let number = count(size);
    if MANY < number {
        return Ok(1.0 - (0.25 + (7.0 / 32.0 + 19.0 / 128.0 / number) / number) / number);
    }
    let logarithm = libm::lgamma(number / 2.0) - libm::lgamma((number - 1.0) / 2.0);
    Ok((2.0 / (number - 1.0)).sqrt() * libm::exp(logarithm))
}
