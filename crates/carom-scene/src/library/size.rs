//! Sizes as they are called, and the dimensions that standards give them.

/// Dimensions of a bolt of metric coarse thread [mm].
///
/// Thread and pitch by ISO 261; hexagon heads by ISO 4014 and ISO 4017 (nominal s and k); socket heads by ISO 4762 (greatest d_k of plain heads, k = d,
/// nominal s and least t of the socket).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BoltRow {
    pub(crate) diameter: f64,
    pub(crate) pitch: f64,
    /// Across flats, s.
    pub(crate) hexagon_width: f64,
    /// k
    pub(crate) hexagon_height: f64,
    /// d_k
    pub(crate) cylinder_width: f64,
    /// Of the socket, s.
    pub(crate) socket_width: f64,
    /// Of the socket, t.
    pub(crate) socket_depth: f64,
}

/// The preferred sizes.
const BOLTS: [[f64; 7]; 15] = [
    [1.6, 0.35, 3.2, 1.1, 3.0, 1.5, 0.7],
    [2.0, 0.4, 4.0, 1.4, 3.8, 1.5, 1.0],
    [2.5, 0.45, 5.0, 1.7, 4.5, 2.0, 1.1],
    [3.0, 0.5, 5.5, 2.0, 5.5, 2.5, 1.3],
    [4.0, 0.7, 7.0, 2.8, 7.0, 3.0, 2.0],
    [5.0, 0.8, 8.0, 3.5, 8.5, 4.0, 2.5],
    [6.0, 1.0, 10.0, 4.0, 10.0, 5.0, 3.0],
    [8.0, 1.25, 13.0, 5.3, 13.0, 6.0, 4.0],
    [10.0, 1.5, 16.0, 6.4, 16.0, 8.0, 5.0],
    [12.0, 1.75, 18.0, 7.5, 18.0, 10.0, 6.0],
    [16.0, 2.0, 24.0, 10.0, 24.0, 14.0, 8.0],
    [20.0, 2.5, 30.0, 12.5, 30.0, 17.0, 10.0],
    [24.0, 3.0, 36.0, 15.0, 36.0, 19.0, 12.0],
    [30.0, 3.5, 46.0, 18.7, 45.0, 22.0, 15.5],
    [36.0, 4.0, 55.0, 22.5, 54.0, 27.0, 19.0],
];

/// Plain washers of the normal series, product grade A, ISO 7089: for the thread d, the hole d1, the outer diameter d2, the thickness h, all nominal [mm].
const WASHERS: [[f64; 4]; 15] = [
    [1.6, 1.7, 4.0, 0.3],
    [2.0, 2.2, 5.0, 0.3],
    [2.5, 2.7, 6.0, 0.5],
    [3.0, 3.2, 7.0, 0.5],
    [4.0, 4.3, 9.0, 0.8],
    [5.0, 5.3, 10.0, 1.0],
    [6.0, 6.4, 12.0, 1.6],
    [8.0, 8.4, 16.0, 1.6],
    [10.0, 10.5, 20.0, 2.0],
    [12.0, 13.0, 24.0, 2.5],
    [16.0, 17.0, 30.0, 3.0],
    [20.0, 21.0, 37.0, 3.0],
    [24.0, 25.0, 44.0, 4.0],
    [30.0, 31.0, 56.0, 4.0],
    [36.0, 37.0, 66.0, 5.0],
];

/// Parallel pins of unhardened steel, ISO 2338: the diameter d and the length c of the chamfers, which lean by about 15° [mm].
const PINS: [[f64; 2]; 20] = [
    [0.6, 0.12],
    [0.8, 0.16],
    [1.0, 0.2],
    [1.2, 0.25],
    [1.5, 0.3],
    [2.0, 0.35],
    [2.5, 0.4],
    [3.0, 0.5],
    [4.0, 0.63],
    [5.0, 0.8],
    [6.0, 1.2],
    [8.0, 1.6],
    [10.0, 2.0],
    [12.0, 2.5],
    [16.0, 3.0],
    [20.0, 3.5],
    [25.0, 4.0],
    [30.0, 5.0],
    [40.0, 6.3],
    [50.0, 8.0],
];

/// The angle of a standard pin's chamfers [deg].
pub(crate) const PIN_CHAMFER: f64 = 15.0;

/// A size as it is called: `M8 x 30`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Size {
    /// [mm]
    pub(crate) diameter: f64,
    /// [mm]
    pub(crate) length: Option<f64>,
}

/// Reads `M8 x 30`, `M8×30`, `M8x30` and `M8`; of what has no thread, `8 x 30` and `8`. `None` where it is no size.
pub(crate) fn read_size(text: &str, thread: bool) -> Option<Size> {
    let text = text.trim();
    let rest = if thread { text.strip_prefix(['M', 'm'])? } else { text };
    let number = |text: &str| {
        let plain = text.trim();
        let digits = plain.chars().all(|c| c.is_ascii_digit() || c == '.');
        plain.parse::<f64>().ok().filter(|value| digits && *value > 0.0)
    };
    match rest.split_once(['x', 'X', '×']) {
        None => Some(Size { diameter: number(rest)?, length: None }),
        Some((diameter, length)) => Some(Size { diameter: number(diameter)?, length: Some(number(length)?) }),
    }
}

/// The row of a size, or the sizes that there are, as text.
fn row<const N: usize>(table: &[[f64; N]], diameter: f64, letter: &str) -> Result<[f64; N], String> {
    let found = table.iter().find(|row| row[0] == diameter).copied();
    found.ok_or_else(|| {
        let sizes: Vec<String> = table.iter().map(|row| format!("{letter}{}", row[0])).collect();
        sizes.join(", ")
    })
}

/// The dimensions of a bolt; the sizes that there are, where this is none.
pub(crate) fn bolt_row(diameter: f64) -> Result<BoltRow, String> {
    let row = row(&BOLTS, diameter, "M")?;
    let [diameter, pitch, hexagon_width, hexagon_height, cylinder_width, socket_width, socket_depth] = row;
    Ok(BoltRow { diameter, pitch, hexagon_width, hexagon_height, cylinder_width, socket_width, socket_depth })
}

/// Hole, outer diameter and thickness of a washer [mm]; the sizes that there are, where this is none.
pub(crate) fn washer_row(diameter: f64) -> Result<[f64; 3], String> {
    row(&WASHERS, diameter, "M").map(|[_, inner, outer, thickness]| [inner, outer, thickness])
}

/// Length of the chamfers of a pin [mm]; the diameters that there are, where this is none.
pub(crate) fn pin_row(diameter: f64) -> Result<f64, String> {
    row(&PINS, diameter, "").map(|[_, chamfer]| chamfer)
}
