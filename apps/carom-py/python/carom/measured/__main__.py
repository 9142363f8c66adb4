"""The measured referee: ``python -m carom.measured FOLDER`` brings the public data into a folder and prints how far Carom, and each other engine that is
installed, is from what was measured. ``--fit`` also fits friction and restitution to a tenth of the tosses, which takes minutes."""

from __future__ import annotations

import argparse
import sys

import numpy as np

import carom.data
from carom.errors import CaromError
from carom.measured import MeasuredImpacts, MeasuredTosses, fit_impacts, fit_tosses
from carom.measured.engines import ENGINES, installed
from carom.measured.impacts import Feature

#: Of the cube, as published with the data.
FRICTION, RESTITUTION = 0.18, 0.125
#: What Acosta, Yang and Posa print for these tosses (arXiv 2110.00541, Table II), as others cite it. Their choice of tosses and the engines' settings may differ.
PUBLISHED = {
    "Drake": "position 13.5 ± 8.2 %, rotation 16.5°",
    "Bullet": "position 14.9 ± 8.9 %, rotation 16.5°",
    "MuJoCo": "position 25.1 ± 10.8 %, rotation 21.7°",
}
#: What friction and restitution of the ellipse depend on, one more each time.
MODELS: list[tuple[list[Feature], list[Feature]]] = [([], []), ([], ["incidence"]), (["lever"], ["incidence"]), (["lever", "slip"], ["incidence", "approach"])]


def impacts(measured: MeasuredImpacts) -> None:
    """The ellipse: fitted to one half, told of the other."""
    half = np.random.default_rng(0).permutation(len(measured)) < len(measured) // 2
    print(f"planar ellipse: {len(measured)} impacts, half of them held out; the engine less what was measured, as a share of the motion before")
    print(f"  any impulse at the contact      {100 * measured.unexplained():.1f} %: no law can do better")
    for friction_by, restitution_by in MODELS:
        fit = fit_impacts(measured[half], friction_by=friction_by, restitution_by=restitution_by)
        by = ", ".join([*(f"friction by {name}" for name in friction_by), *(f"restitution by {name}" for name in restitution_by)]) or "constants"
        told = ", ".join(f"{one.name} {one.best:.4f} ({one.low:.4f} to {one.high:.4f})" for one in fit.parameters[:2])
        print(f"  {100 * fit.error_of(measured[~half]):.2f} % held out, {100 * fit.error:.2f} % fitted: {by}; {told}")


def tosses(measured: MeasuredTosses, fitted: bool) -> None:
    """The cube: constants as published, other engines, and fitted to a tenth."""
    print(f"cube tosses: {len(measured)}; errors of a toss are means over its instants, of position as a share of the cube's width")
    print(f"  Carom, constants as published with the data, not fitted: {measured.errors(FRICTION, RESTITUTION)}")
    if fitted:
        tenth = np.arange(len(measured)) % 10 == 0
        fit = fit_tosses(measured[tenth])
        told = ", ".join(f"{one.name} {one.best:.3f} ({one.low:.3f} to {one.high:.3f})" for one in fit.parameters)
        print(f"  Carom, fitted to every tenth ({told}), held out: {measured[~tenth].errors(fit.friction, fit.restitution)}")
    for name in installed():
        print(f"  {name}, friction as published with the data: {measured.errors_of(*ENGINES[name](measured, FRICTION))}")
    for name, printed in PUBLISHED.items():
        print(f"  {name} in print: {printed}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m carom.measured", description=__doc__)
    parser.add_argument("folder", help="where the data are, or are brought to")
    parser.add_argument("--fit", action="store_true", help="fit friction and restitution to a tenth of the tosses too")
    words = parser.parse_args()
    try:
        impacts(carom.data.planar_ellipse(carom.data.fetch("planar-ellipse", words.folder)))
        tosses(carom.data.cube_tosses(carom.data.fetch("cube-tosses", words.folder)), words.fit)
    except CaromError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
