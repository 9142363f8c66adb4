//! What is wrong in the paper, in one list.

/// Opens the page.
pub(super) const HEAD: &str = "\
# Table 1 of the gravity-impact feeder's paper, beside ours

The paper computes two cases of a thin rod that slides down a plate, tips over its edge and falls on a second one.
Made by

```sh
cargo carom run examples/case_1.toml examples/case_2.toml --paper && cp out/table-1.md docs/table-1.md
```

*Difference* is ours less what is printed. *Agrees* is to the last printed digit; *coarse in print* within 2 % or one in the last digit;
a *misprint* was lost or changed in print, and what is meant follows from the rest of the column; what is *wrong in print* does not follow from the paper's own equations.
x and y start at the upper plate's free edge, x along the plate and y down through it; τ points down the lower plate, n out of it; φ and ω turn x towards y.
";

/// Closes the page.
pub(super) const ERRATA: &str = "
## Errata

Wrong in print:

1. *Case 1, after the impact.* The spin of -11.722 1/s violates the balance of angular momentum of its own column. From the printed state before the impact follow v_cτ 0.0456, v_cn -0.1734, ω -10.668 and slip -0.4588; from the exact motion ω is -10.786. Case 2 is right: 31.972.
2. *Case 2, fifth stage.* The part does not slide on without separation: that would need N = -6.27 N. It lifts off at once, its other end strikes 35.9 ms later, and it lies turned over 48.4 ms after the first touch.
3. *Case 1, fifth stage.* It starts from the wrong spin. The slip reverses 71.2 ms after the impact and the part lies flat at 91.8 ms with ω = -17.37 1/s; the printed v_cn of -0.876 m/s itself means -17.52 1/s, not -18.837.

Misprints:

4. *Lost decimal points:* the times of tipping (0.0879, 0.1169 s) and of flight (0.0821, 0.1417 s), r at lift-off (0.05, 0.035 m), the time of case 1's fifth stage (0.0868 s).
5. *Case 2, φ at lift-off* is 25.15°, not 45.15°.
6. *Case 1, φ_K* has lost its sign: it is -18.97°.
7. *Case 2, slip after the impact* is a copy of the line above: 1.761 m/s follows from the printed state.
8. *Case 1, x_c0, y_c0, v_xc0, v_yc0* do not follow from the column's own r, φ and v, which give 0.0483, 0.0131, 0.649 and 0.457.
9. *Case 2's lower plate* has lost its equation: x/0.428 + y/0.3 = 1 gives the printed column.

Coarse: most values from the tip to the impact are up to 1.3 % off, as by integration with long steps.

In the text:

10. *β* is the lower plate's angle in the upper plate's axes; its slope to the horizontal is β - α: 15° in case 1, 25° in case 2.
11. *The turning criterion* of the conclusion has lost its signs. It means: φ_K above the plate's slope, and the part turns over; φ_K below 0, and the spin reverses; between 0 and β - α type 7 may occur. It is a weak predictor: the spin after the impact, and whether the struck contact holds, decide.
";
