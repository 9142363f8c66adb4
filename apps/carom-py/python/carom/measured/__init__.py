"""Measured impacts and tosses: what was seen, how far the engine is from it, and which friction and restitution agree with it.

:class:`MeasuredImpacts` holds single impacts in the plane, :class:`MeasuredTosses` motions of a body in space; :mod:`carom.data` reads public ones.
:func:`fit_impacts` and :func:`fit_tosses` find friction and restitution with intervals from the profile likelihood. They need SciPy:
``pip install carom[fit]``. ``python -m carom.measured FOLDER`` prints the measured referee.
"""

from carom.measured.impacts import ImpactFit, MeasuredImpacts, fit_impacts
from carom.measured.profile import Fitted
from carom.measured.tosses import MeasuredTosses, TossErrors, TossFit, fit_tosses

__all__ = ["Fitted", "ImpactFit", "MeasuredImpacts", "MeasuredTosses", "TossErrors", "TossFit", "fit_impacts", "fit_tosses"]
