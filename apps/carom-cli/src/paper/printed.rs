//! Table 1 as it is printed, with what is known to be wrong in it.

/// The two cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Case {
    One,
    Two,
}

impl Case {
    pub(super) fn number(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }
}

/// What is known about a printed value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Remark {
    None,
    /// Lost in print: what is meant, and why.
    Misprint(&'static str, &'static str),
    /// Does not follow from the paper's own equations: why.
    Wrong(&'static str),
}

/// A printed value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) printed: &'static str,
    pub(super) remark: Remark,
}

/// A row of the table.
pub(super) struct Row {
    pub(super) key: &'static str,
    pub(super) letter: &'static str,
    pub(super) unit: &'static str,
    /// It is the first of its stage.
    pub(super) opens: bool,
    cases: [Entry; 2],
}

impl Row {
    pub(super) fn entry(&self, case: Case) -> Entry {
        match case {
            Case::One => self.cases[0],
            Case::Two => self.cases[1],
        }
    }

    /// The heading of its stage.
    pub(super) fn stage(&self) -> &'static str {
        match self.key.split_once('.') {
            Some(("slide", _)) => "first stage: sliding",
            Some(("tip", _)) => "second stage: tipping until lift-off",
            Some(("flight", _)) => "third stage: flight",
            Some(("strike", _)) => "fourth stage: impact",
            _ => "fifth stage: until the part lies down",
        }
    }
}

const fn plain(printed: &'static str) -> Entry {
    Entry { printed, remark: Remark::None }
}

const fn misprint(printed: &'static str, meant: &'static str, why: &'static str) -> Entry {
    Entry { printed, remark: Remark::Misprint(meant, why) }
}

const fn wrong(printed: &'static str, because: &'static str) -> Entry {
    Entry { printed, remark: Remark::Wrong(because) }
}

const fn row(key: &'static str, letter: &'static str, unit: &'static str, cases: [Entry; 2]) -> Row {
    Row { key, letter, unit, opens: false, cases }
}

const fn first(key: &'static str, letter: &'static str, unit: &'static str, cases: [Entry; 2]) -> Row {
    Row { key, letter, unit, opens: true, cases }
}

const POINT: &str = "its decimal point is lost";
const ROW: &str = "does not follow from the r, φ and v of its own column";
const V_TAU: &str = "with the printed state before the impact it is 0.0456";
const V_N: &str = "with the printed state before the impact it is -0.1734";
const SPIN: &str =
    "violates the balance of angular momentum: with the printed state before the impact it is -10.668";
const SLIP: &str = "with the printed state before the impact it is -0.4588";
const HOLDS_NOT: &str = "sliding on without separation would need N = -6.27 N: the part lifts off and its other end strikes first";
const FOLLOWS: &str = "follows from the wrong spin after the impact";

/// The table.
pub(super) const TABLE: [Row; 41] = [
    first("slide.t", "t", "s", [plain("0.423"), plain("0.887")]),
    row("slide.v", "v0", "m/s", [plain("0.473"), plain("0.226")]),
    first("tip.r0", "r0", "m", [plain("0"), plain("0")]),
    row("tip.phi0", "φ0", "deg", [plain("0"), plain("0")]),
    row("tip.vr0", "v_r0", "m/s", [plain("0.473"), plain("0.226")]),
    row("tip.vphi0", "v_φ0", "m/s", [plain("0"), plain("0")]),
    row("tip.spin0", "ω0", "1/s", [plain("0"), plain("0")]),
    row("tip.t", "t", "s", [misprint("0.879", "0.0879", POINT), misprint("1.169", "0.1169", POINT)]),
    row("tip.r1", "r", "m", [misprint("0.5", "0.05", POINT), misprint("0.35", "0.035", POINT)]),
    row("tip.phi1", "φ", "deg", [plain("15.18"), misprint("45.15", "25.15", "its first digit is wrong")]),
    row("tip.vr1", "v_r1", "m/s", [plain("0.746"), plain("0.527")]),
    row("tip.vphi1", "v_φ1", "m/s", [plain("0.271"), plain("0.269")]),
    row("tip.spin1", "ω1", "1/s", [plain("5.490"), plain("7.637")]),
    first("flight.x0", "x_c0", "m", [misprint("0.049", "0.0483", ROW), plain("0.032")]),
    row("flight.y0", "y_c0", "m", [misprint("0.012", "0.0131", ROW), plain("0.015")]),
    row("flight.vx0", "v_xc0", "m/s", [misprint("0.653", "0.649", ROW), plain("0.363")]),
    row("flight.vy0", "v_yc0", "m/s", [misprint("0.461", "0.457", ROW), plain("0.467")]),
    row("flight.spin0", "ω0", "1/s", [plain("5.490"), plain("7.637")]),
    row("flight.t", "t", "s", [misprint("0.821", "0.0821", POINT), misprint("1.417", "0.1417", POINT)]),
    row("flight.x1", "x_c1", "m", [plain("0.111"), plain("0.101")]),
    row("flight.y1", "y_c1", "m", [plain("0.082"), plain("0.178")]),
    row("flight.phi1", "φ1", "deg", [plain("41.02"), plain("87.15")]),
    row("flight.vx1", "v_xc1", "m/s", [plain("0.862"), plain("0.605")]),
    row("flight.vy1", "v_yc1", "m/s", [plain("1.239"), plain("1.837")]),
    first("strike.phi", "φ_K", "deg", [misprint("18.97", "-18.97", "its sign is lost"), plain("32.14")]),
    row("strike.tau", "τ_c0", "m", [plain("0.016"), plain("-0.027")]),
    row("strike.n", "n_c0", "m", [plain("0.047"), plain("0.042")]),
    row("strike.v_tau0", "v_cτ0", "m/s", [plain("-0.127"), plain("0.558")]),
    row("strike.v_n0", "v_cn0", "m/s", [plain("-1.504"), plain("-1.852")]),
    row("strike.u_tau0", "v_Kτ0", "m/s", [plain("0.133"), plain("0.881")]),
    row("strike.u_n0", "v_Kn0", "m/s", [plain("-1.593"), plain("-1.649")]),
    row("strike.type", "type", "", [plain("5"), plain("1")]),
    row("strike.v_tau1", "v_cτ1", "m/s", [wrong("0.043", V_TAU), plain("0.408")]),
    row("strike.v_n1", "v_cn1", "m/s", [wrong("-0.188", V_N), plain("-0.851")]),
    row("strike.spin1", "ω1", "1/s", [wrong("-11.722", SPIN), plain("31.972")]),
    row(
        "strike.u_tau1",
        "v_Kτ1",
        "m/s",
        [
            wrong("-0.508", SLIP),
            misprint("0.408", "1.761", "a copy of v_cτ1, where its own row gives another value"),
        ],
    ),
    row("strike.u_n1", "v_Kn1", "m/s", [plain("0"), plain("0")]),
    first(
        "fifth.t",
        "t",
        "s",
        [
            wrong(
                "0.868",
                "0.0868 is meant (its decimal point is lost), and it follows from the wrong spin after the impact",
            ),
            wrong("0.031", HOLDS_NOT),
        ],
    ),
    row("fifth.spin", "ω1", "1/s", [wrong("-18.837", FOLLOWS), wrong("34.50", HOLDS_NOT)]),
    row("fifth.v_tau", "v_cτ1", "m/s", [wrong("0.284", FOLLOWS), wrong("0.527", HOLDS_NOT)]),
    row("fifth.v_n", "v_cn1", "m/s", [wrong("-0.876", FOLLOWS), wrong("-1.072", HOLDS_NOT)]),
];
