"""Where hypotheses hold, over two symbols."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from carom.errors import needed
from carom.symbolic.derivation import Derivations

#: Colours that people who see few of them tell apart (Okabe and Ito), each with a hatch of its own.
_LOOKS = [("#0072B2", "//"), ("#E69F00", "\\\\"), ("#009E73", ".."), ("#CC79A7", "xx"), ("#56B4E9", "--"), ("#D55E00", "||"), ("#F0E442", "oo"), ("#000000", "++")]


def draw(derivations: Derivations, x: tuple[Any, float, float], y: tuple[Any, float, float], values: Mapping[Any, float], *, points: int = 201, axes: Any = None) -> Any:
    """Draws where each hypothesis holds over two symbols: each has a colour, a hatch and its words in the legend.

    ``x`` and ``y`` are a symbol and its range, ``values`` numbers for all others, ``points`` how fine the grid is, ``axes`` where to draw (a new
    figure where none are given). Regions that overlap lie over each other: there several hypotheses hold.

    Returns the axes of matplotlib. Raises :class:`carom.CaromError` where matplotlib is missing or a symbol has no value.
    """
    needed("derive", "matplotlib")
    import matplotlib.pyplot as plt
    from matplotlib.patches import Patch

    if axes is None:
        axes = plt.subplots(figsize=(7, 5), layout="constrained")[1]
    across, up = np.linspace(x[1], x[2], points), np.linspace(y[1], y[2], points)
    grid = np.meshgrid(across, up)
    patches = []
    for k, derivation in enumerate(derivations.kept):
        colour, hatch = _LOOKS[k % len(_LOOKS)]
        given = {**values, x[0]: grid[0].ravel(), y[0]: grid[1].ravel()}
        holds = derivation.at(given).holds
        inside = np.broadcast_to(holds, grid[0].size).reshape(grid[0].shape)
        if not inside.any():
            continue
        axes.contourf(across, up, inside.astype(float), levels=[0.5, 1.5], colors=[colour], alpha=0.35, hatches=[hatch])
        _label(axes, across, up, inside, str(k + 1), colour)
        patches.append(Patch(facecolor=colour, alpha=0.35, hatch=hatch, label=f"{k + 1}  {derivation.title}"))
    axes.set(xlabel=str(x[0]), ylabel=str(y[0]), xlim=(x[1], x[2]), ylim=(y[1], y[2]))
    axes.legend(handles=patches, loc="upper left", bbox_to_anchor=(0, -0.12), fontsize="small", frameon=False)
    return axes


def _label(axes: Any, across: Any, up: Any, inside: Any, label: str, colour: str) -> None:
    """Its number where the region is widest."""
    depth, layer = np.zeros(inside.shape), inside.copy()
    while layer.any():
        depth += layer
        smaller = layer.copy()
        smaller[1:] &= layer[:-1]
        smaller[:-1] &= layer[1:]
        smaller[:, 1:] &= layer[:, :-1]
        smaller[:, :-1] &= layer[:, 1:]
        smaller[[0, -1]] = False
        smaller[:, [0, -1]] = False
        layer = smaller
    row, column = np.unravel_index(int(depth.argmax()), depth.shape)
    axes.text(across[column], up[row], label, ha="center", va="center", weight="bold", color="black", bbox={"boxstyle": "circle", "facecolor": "white", "edgecolor": colour})
