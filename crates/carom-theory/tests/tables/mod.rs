//! Tables of two-point strikes, computed by programs independent of this workspace (a mode enumerator and an incremental integrator over
//! Polukoshko and Viba's cylinder, prism and rod), and how they are read. Units m = a = ω₀ = 1; ω > 0 clockwise; columns are named in
//! the first line; SNA, STA: impulses at A; vnA, vtA: velocities there; R: restitution.
#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(unreachable_pub, reason = "a module shared by test files")]

use carom_theory::rocking::Cylinder;

pub const CYLINDER_BOUNDARIES: &str = include_str!("cylinder_boundaries.csv");
pub const CYLINDER_PLASTIC: &str = include_str!("cylinder_plastic.csv");
pub const CYLINDER_ELASTIC: &str = include_str!("cylinder_elastic.csv");
pub const AMBIGUOUS_COMPRESSION: &str = include_str!("ambiguous_compression.csv");
pub const AMBIGUOUS_RESTITUTION: &str = include_str!("ambiguous_restitution.csv");
pub const PRISM_RATIOS: &str = include_str!("prism_ratios.csv");
pub const PRISM_REGULAR: &str = include_str!("prism_regular.csv");
pub const PRISM_IRREGULAR: &str = include_str!("prism_irregular.csv");
pub const ROD: &str = include_str!("rod.csv");
pub const HOUSNER: &str = include_str!("housner.csv");

/// Columns of velocities and of impulses after a strike.
pub const MOTION: [&str; 3] = ["vx", "vy", "w"];
pub const IMPULSES: [&str; 4] = ["SNA", "STA", "SNK", "STK"];

/// The cylinder of a line.
pub fn cylinder(row: &Row) -> Cylinder {
    Cylinder {
        mass: 1.0,
        radius: 1.0,
        inertia_ratio: row.number("b"),
        friction: row.number("f"),
        half_angle: row.number("gamma_deg").to_radians(),
    }
}

/// One line of a table.
#[derive(Debug)]
pub struct Row {
    fields: Vec<(&'static str, &'static str)>,
}

/// All lines but the first.
pub fn rows(table: &'static str) -> Vec<Row> {
    let mut lines = table.lines();
    let names: Vec<_> = lines.next().expect("a line of names").split(',').collect();
    lines
        .map(|line| {
            let values: Vec<_> = line.split(',').collect();
            assert_eq!(values.len(), names.len(), "{line}");
            Row { fields: names.iter().copied().zip(values).collect() }
        })
        .collect()
}

impl Row {
    pub fn text(&self, name: &str) -> &'static str {
        self.fields.iter().find(|(n, _)| *n == name).unwrap_or_else(|| panic!("no column {name}")).1
    }

    pub fn number(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap_or_else(|_| panic!("{name} is no number in {self:?}"))
    }

    pub fn numbers<const N: usize>(&self, names: [&str; N]) -> [f64; N] {
        names.map(|n| self.number(n))
    }

    /// Half a unit of the last printed digit.
    pub fn resolution(&self, name: &str) -> f64 {
        let decimals = self.text(name).split_once('.').map_or(0, |(_, d)| d.len());
        0.5 / (0..decimals).map(|_| 10.0).product::<f64>()
    }

    /// Ours, rounded, is what is printed: within half a unit of the last digit and what doubles add to that.
    pub fn assert_prints(&self, name: &str, ours: f64) {
        let allowed = self.resolution(name) + 1e-13 * (1.0 + ours.abs());
        let printed = self.number(name);
        assert!((ours - printed).abs() <= allowed, "{name}: {ours} is not {printed} in {self:?}");
    }

    /// The same for several columns.
    pub fn assert_all_print<const N: usize>(&self, names: [&str; N], ours: [f64; N]) {
        for (name, value) in names.into_iter().zip(ours) {
            self.assert_prints(name, value);
        }
    }
}
