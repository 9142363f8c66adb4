//! Small steps of the classical Runge–Kutta method, for closed forms of motions.

/// Halvings of the last step.
const HALVINGS: u32 = 60;
/// More steps than any motion here takes.
const MOST: u32 = 10_000_000;

/// One step of length `h`.
pub(crate) fn step<const N: usize>(y: [f64; N], h: f64, rate: &impl Fn(&[f64; N]) -> [f64; N]) -> [f64; N] {
    let ahead = |k: &[f64; N], by: f64| std::array::from_fn(|i| y[i] + by * k[i]);
    let k1 = rate(&y);
    let k2 = rate(&ahead(&k1, 0.5 * h));
    let k3 = rate(&ahead(&k2, 0.5 * h));
    let k4 = rate(&ahead(&k3, h));
    std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// Time and state at which `left`, positive at the start, has come down to zero.
pub(crate) fn until<const N: usize>(
    mut y: [f64; N],
    h: f64,
    rate: &impl Fn(&[f64; N]) -> [f64; N],
    left: &impl Fn(&[f64; N]) -> f64,
) -> (f64, [f64; N]) {
    for steps in 0..MOST {
        let next = step(y, h, rate);
        if left(&next) > 0.0 {
            y = next;
            continue;
        }
        let (mut short, mut long) = (0.0, h);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (short + long);
            *(if left(&step(y, middle, rate)) > 0.0 { &mut short } else { &mut long }) = middle;
        }
        return (h * f64::from(steps) + long, step(y, long, rate));
    }
    unreachable!("the motion never gets there: {y:?}")
}
