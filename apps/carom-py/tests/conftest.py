"""Tests run at the root of the project, with the package that is installed."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[3]
NOTEBOOKS = ROOT / "apps/carom-py/notebooks"
#: Seconds that a cell may take: the longest derives 76 formulas.
PATIENCE = 900

#: Executes a notebook with settings, and gives the values of expressions at its end.
Execute = Callable[[str, Mapping[str, str], Mapping[str, str]], dict[str, Any]]


@pytest.fixture(autouse=True)
def _at_the_root(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)


@pytest.fixture(scope="session")
def command() -> Path:
    """The command that answers are compared with."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    return Path(os.environ.get("CAROM", target / "release" / "carom"))


@pytest.fixture(scope="session")
def execute(tmp_path_factory: pytest.TempPathFactory) -> Execute:
    """Runs notebooks, each in a kernel of its own, where a user would."""
    jupytext: Any = pytest.importorskip("jupytext")
    nbclient: Any = pytest.importorskip("nbclient")
    nbformat: Any = pytest.importorskip("nbformat")

    def execute(name: str, settings: Mapping[str, str], asked: Mapping[str, str]) -> dict[str, Any]:
        notebook = jupytext.read(NOTEBOOKS / f"{name}.py")
        assert 8 <= len(notebook.cells) <= 20, "a notebook is short"
        asks = ", ".join(f"{key!r}: {expression}" for key, expression in asked.items())
        notebook.cells.append(nbformat.v4.new_code_cell(f"import json\nprint(json.dumps({{{asks}}}, default=str))"))
        environment = {key: value for key, value in os.environ.items() if not key.startswith("CAROM_")}
        environment |= {"TMPDIR": str(tmp_path_factory.mktemp(name)), "MPLBACKEND": "module://matplotlib_inline.backend_inline", **settings}
        client = nbclient.NotebookClient(notebook, timeout=PATIENCE, resources={"metadata": {"path": str(NOTEBOOKS)}})
        client.execute(env=environment)
        said: dict[str, Any] = json.loads(notebook.cells[-1].outputs[0].text)
        return said

    return execute


@pytest.fixture(scope="session")
def collisions(execute: Execute) -> dict[str, Any]:
    """What the notebook on simultaneous collisions derives: its table is made once, for the tests of the notebook and of the formulas."""
    asked = {
        "rows": "rows", "counts": "counts", "ways": "[way.hypothesis for way in ways]", "discarded": "len(ways.discarded)",
        "difference": "str(difference)", "impulses": "impulse_at_a", "errata": "len(errata)",
    }
    return execute("simultaneous_collisions", {}, asked)
