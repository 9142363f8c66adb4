"""Friction and restitution of an ellipse, fitted to one half of its impacts and tried on the other: `python measured.py FOLDER`."""

import sys

import carom.data
from carom.measured import MeasuredImpacts, fit_impacts


# ANCHOR: fit
def fitted(measured: MeasuredImpacts) -> None:
    fit = fit_impacts(measured[::2], friction_by=["lever"], restitution_by=["incidence"])
    for one in fit.parameters:
        print(one.name, one.best, one.low, one.high)
    print("held out:", fit.error_of(measured[1::2]))
    # ANCHOR_END: fit


if __name__ == "__main__":
    fitted(carom.data.planar_ellipse(carom.data.fetch("planar-ellipse", sys.argv[1])))
