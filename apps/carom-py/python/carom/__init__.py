"""Carom computes exactly what rigid parts do when they touch: slide, tip, fall, strike, stick, rebound.

One question at a time: :func:`run` a scene, resolve an :func:`impact`, ask what :func:`contact` forces are consistent, follow what can
:func:`roll`, find a :func:`yield_` or a :func:`design`, draw a :func:`map` or :func:`regions`, :func:`feed` many parts, :func:`fit`
what was observed. By the million: :func:`drops`, :func:`impacts` and :func:`impact_batch` take arrays. In closed form: :func:`derive`. In a
notebook: :func:`studio`, to drag and see.

All values are SI, in a world with x to the right and y up; angles and spins are counter-clockwise. Text may carry other units: ``"12 deg"``.

>>> import carom
>>> run = carom.run("examples/case_2.toml")
>>> run.outcome, run.plates[-1].verdict
('landed', 'turned')
"""

from __future__ import annotations

from carom._carom import __version__
from carom._batch import impact_batch
from carom._many import drops, impacts
from carom._one import contact, design, impact, locate_yield, roll, run, studio, yield_
from carom._studies import feed, fit, map, regions
from carom._sweep import sweep
from carom._tosses import Tosses, tosses
from carom._answer import Answer
from carom.answers.contact import Contact
from carom.answers.design import Design
from carom.answers.feed import Feed
from carom.answers.fit import Fit
from carom.answers.impact import PlanarImpact, SpatialImpact
from carom.answers.located import Located
from carom.answers.map import Map
from carom.answers.regions import Regions
from carom.answers.roll import PlanarRoll, SpatialRoll
from carom.answers.run import Run
from carom.answers.space_run import SolidRun
from carom.answers.sweep import Sweep
from carom.answers.yield_ import Yield
from carom.errors import CaromError, Problem
from carom.scene import Quantity, Scene
from carom.symbolic import derive
from carom.table import Table

__all__ = [
    "Answer",
    "CaromError",
    "Contact",
    "Design",
    "Feed",
    "Fit",
    "Located",
    "Map",
    "PlanarImpact",
    "PlanarRoll",
    "Problem",
    "Quantity",
    "Regions",
    "Run",
    "Scene",
    "SolidRun",
    "SpatialImpact",
    "SpatialRoll",
    "Sweep",
    "Table",
    "Tosses",
    "Yield",
    "__version__",
    "contact",
    "derive",
    "design",
    "drops",
    "feed",
    "fit",
    "impact",
    "impact_batch",
    "impacts",
    "locate_yield",
    "map",
    "regions",
    "roll",
    "run",
    "studio",
    "sweep",
    "tosses",
    "yield_",
]
