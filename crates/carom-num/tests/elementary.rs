//! The elementary functions give the same bytes on every platform and in every build.

use carom_num::elementary;

/// Arguments that the digest runs over.
const COUNT: usize = 100_000;

/// The i-th point of the golden-ratio sequence in [0, 1).
fn spread(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9).fract()
}

/// FNV-1a over the bits of all results, in order.
fn digest(results: impl Iterator<Item = f64>) -> u64 {
    results
        .flat_map(|value| value.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The digests were recorded with libm 0.2.16 on x86-64. A changed digest changes results: it belongs under *Numbers changed* in the changelog, with a reason.
#[test]
fn every_platform_gives_these_bytes() {
    let angles = || (1..=COUNT).map(|i| 200.0 * spread(i) - 100.0);
    let unit = || (1..=COUNT).map(|i| 2.0 * spread(i) - 1.0);
    let positive = || (1..=COUNT).map(|i| 50.0 * spread(i));
    let found = [
        digest(angles().map(elementary::sin_cos).flat_map(|(s, c)| [s, c])),
        digest(angles().map(elementary::tan)),
        digest(unit().zip(angles()).map(|(y, x)| elementary::atan2(y, x))),
        digest(angles().map(elementary::atan)),
        digest(unit().map(elementary::acos)),
        digest(positive().zip(unit()).map(|(x, y)| elementary::pow(x, y))),
        digest(angles().map(elementary::exp)),
        digest(positive().map(elementary::ln)),
    ];
    let expected = [
        0x348d_21ff_7993_3389,
        0x2e82_46d5_f14f_ddb9,
        0xbd04_5fe5_dc90_7589,
        0xd8d8_87ab_99a7_65cf,
        0x53f3_818c_6a95_4a5c,
        0xaed0_cda2_616a_edcb,
        0x49f1_02ef_0ea2_fe6c,
        0x9d91_3065_31d5_dcda,
    ];
    assert_eq!(found, expected, "sin_cos, tan, atan2, atan, acos, pow, exp, ln: found {found:#x?}");
}

#[test]
fn sine_and_cosine_agree_whether_asked_together_or_apart() {
    for x in (1..=COUNT).map(|i| 200.0 * spread(i) - 100.0) {
        let together = elementary::sin_cos(x);
        assert_eq!(together, (elementary::sin(x), elementary::cos(x)), "at {x} rad");
    }
}

#[test]
fn sine_and_cosine_lie_on_the_unit_circle_to_three_roundings() {
    for x in (1..=COUNT).map(|i| 200.0 * spread(i) - 100.0) {
        let (s, c) = elementary::sin_cos(x);
        // Each square carries twice an error below 1 ulp and one rounding, the sum one more: below 3 ε in all, as s² + c² = 1.
        let off = (s * s + c * c - 1.0).abs();
        assert!(off <= 3.0 * f64::EPSILON, "s² + c² − 1 = {off:e} at {x} rad");
    }
}
