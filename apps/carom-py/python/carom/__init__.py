"""Carom computes exactly what rigid parts do when they touch: slide, tip, fall, strike, stick, rebound.

One question at a time: :func:`run` a scene, resolve an :func:`impact`, ask what :func:`contact` forces are consistent, follow what can
:func:`roll`, find a :func:`yield_` or a :func:`design`. By the million: :func:`drops` and :func:`impacts` take arrays.

All values are SI, in a world with x to the right and y up; angles and spins are counter-clockwise. Text may carry other units: ``"12 deg"``.

>>> import carom
>>> run = carom.run("examples/case_2.toml")
>>> run.outcome, run.plates[-1].verdict
('landed', 'turned')
"""

from __future__ import annotations

from carom._carom import __version__
from carom._many import drops, impacts
from carom._one import contact, design, impact, roll, run, yield_
from carom._answer import Answer
from carom.errors import CaromError, Problem
from carom.scene import Quantity, Scene
from carom.table import Table

__all__ = [
    "Answer",
    "CaromError",
    "Problem",
    "Quantity",
    "Scene",
    "Table",
    "__version__",
    "contact",
    "design",
    "drops",
    "impact",
    "impacts",
    "roll",
    "run",
    "yield_",
]
