"""Sweeps into a folder, and work on the workers of a Dask cluster."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import carom
import duckdb
import polars
import pytest

distributed = pytest.importorskip("distributed")

CASE = "examples/case_2.toml"
#: Three steps.
DESIGNS: dict[str, tuple[float | str, float | str, int]] = {"contact.friction": (0.01, 0.17, 300), "plate.upper.slope": ("10 deg", "14 deg", 90)}
GRID = ["--grid", "contact.friction=0.01..0.17:300", "--grid", "plate.upper.slope=10..14 deg:90"]


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True) as cluster, distributed.Client(cluster) as client:
        yield client


def tables(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.rglob("*.parquet"))}


def test_a_sweep_is_that_of_the_command(command: Path, tmp_path: Path) -> None:
    subprocess.run([command, "sweep", CASE, *GRID, "--out", tmp_path / "out"], capture_output=True, check=True)
    swept = carom.sweep(CASE, ["contact.friction=0.01..0.17:300", "plate.upper.slope=10..14 deg:90"], tmp_path / "own")
    assert tables(tmp_path / "own") == tables(tmp_path / "out")
    assert (swept.rows, swept.designs, swept.run.drops) == (27_000, 27_000, 27_000)
    assert swept.folder == str(tmp_path / "own")
    # All of it is there: nothing is dropped again.
    again = carom.sweep(CASE, DESIGNS, tmp_path / "own")
    assert (again.rows, again.run.drops, again.endings) == (27_000, 0, swept.endings)


def test_shards_make_the_files_of_one(tmp_path: Path) -> None:
    whole = carom.sweep(CASE, DESIGNS, tmp_path / "whole")
    rows = [carom.sweep(CASE, DESIGNS, tmp_path / "shards", shard=(k, 2)).rows for k in (1, 2)]
    assert rows[-1] == whole.rows and rows[0] < whole.rows
    assert tables(tmp_path / "shards") == tables(tmp_path / "whole")


def test_what_is_wrong_with_a_sweep_is_told(tmp_path: Path) -> None:
    with pytest.raises(carom.CaromError) as error:
        carom.sweep(CASE, {"contact.frictoin": (0, 1, 9), "contact.restitution": (0, 1, 1)}, tmp_path, plate="third", shard=(3, 2))
    paths = sorted(problem.path.split()[0] for problem in error.value.problems)
    assert paths == ["grid", "grid", "plate", "shard"] and "--" not in str(error.value)
    with pytest.raises(carom.CaromError, match="low, high, points"):
        carom.sweep(CASE, {"contact.friction": (0, 1)}, tmp_path)  # type: ignore[dict-item]
    for wrong in (5, None):
        with pytest.raises(carom.CaromError, match="^designs: expected"):
            carom.sweep(CASE, wrong, tmp_path)  # type: ignore[arg-type]
    with pytest.raises(carom.CaromError, match="^folder: expected"):
        carom.sweep(CASE, "contact.friction=0..0.3:31", "")
    with pytest.raises(carom.CaromError, match="no such file"):
        carom.sweep(CASE, "no.csv", tmp_path)
    carom.sweep(CASE, {"contact.friction": (0, 0.1, 3)}, tmp_path)
    with pytest.raises(carom.CaromError, match="is of another sweep: name another folder, or replace it with force"):
        carom.sweep(CASE, {"contact.friction": (0, 0.1, 4)}, tmp_path)
    assert carom.sweep(CASE, {"contact.friction": (0, 0.1, 4)}, tmp_path, force=True).rows == 4


def test_a_damaged_file_is_swept_again(tmp_path: Path) -> None:
    designs = {"contact.friction": (0.01, 0.17, 9)}
    carom.sweep(CASE, designs, tmp_path)
    (part,) = tmp_path.glob("part-*.parquet")
    whole = part.read_bytes()
    part.write_bytes(whole[:-9])
    with pytest.warns(UserWarning, match="is damaged"):
        assert carom.sweep(CASE, designs, tmp_path).run.drops == 9
    assert part.read_bytes() == whole


def test_other_programs_open_the_folder_as_one_table(tmp_path: Path) -> None:
    swept = carom.sweep(CASE, DESIGNS, tmp_path)
    files = str(tmp_path / "*.parquet")
    counted = duckdb.sql(f"select ending, count(*) from '{files}' group by ending")
    assert counted is not None and dict(counted.fetchall()) == swept.endings
    frame = polars.scan_parquet(files).group_by("ending").len().collect()
    assert dict(frame.iter_rows()) == swept.endings


def test_a_cluster_makes_the_files_of_one_machine(client: Any, tmp_path: Path) -> None:
    heard: list[tuple[int, int | None]] = []
    shared = carom.sweep(CASE, DESIGNS, tmp_path / "shared", client=client, progress=lambda done, of: heard.append((done, of)))
    alone = carom.sweep(CASE, DESIGNS, tmp_path / "alone")
    assert tables(tmp_path / "shared") == tables(tmp_path / "alone")
    assert (shared.rows, shared.endings, shared.run.drops) == (alone.rows, alone.endings, alone.run.drops)
    assert shared.run.threads == 2 and heard[-1] == (8, 8)


def test_a_cluster_counts_the_yield_of_one_machine(client: Any) -> None:
    asked: dict[str, Any] = {"samples": 4096, "seed": 3, "set": {"contact.friction": "0.08 ± 0.07", "plate.upper.slope": "12 ± 2 deg"}}
    shared = carom.yield_(CASE, client=client, **asked)
    alone = carom.yield_(CASE, **asked)
    assert shared.sensitivity is not None, "the second round was counted too"
    own, other = (answer.to_dict() | {"run": None} for answer in (shared, alone))
    assert own == other and shared.run.drops == alone.run.drops
    assert {name: text for name, text in shared.files.items() if name.endswith(".toml")} == {
        name: text for name, text in alone.files.items() if name.endswith(".toml")
    }


def test_an_error_comes_back_from_a_worker(client: Any, tmp_path: Path) -> None:
    with pytest.raises(carom.CaromError, match="did you mean"):
        carom.sweep(CASE, {"contact.frictoin": (0, 1, 9)}, tmp_path, client=client)
    with pytest.raises(carom.CaromError, match="nothing varies"):
        carom.yield_(CASE, client=client)
    for wrong in ({"shard": (1, 2)}, {"force": True}):
        with pytest.raises(carom.CaromError, match="workers"):
            carom.sweep(CASE, DESIGNS, tmp_path, client=client, **wrong)
    with pytest.raises(carom.CaromError, match="^client: expected"):
        carom.sweep(CASE, DESIGNS, tmp_path, client="x")


def test_a_worker_that_is_killed_costs_time_only(tmp_path: Path) -> None:
    designs: dict[str, tuple[float | str, float | str, int]] = {"contact.friction": (0.01, 0.17, 400), "plate.upper.slope": ("10 deg", "14 deg", 500)}
    killed: list[int] = []

    def kill(client: Any) -> None:
        # As soon as the first step is there.
        while not list(tmp_path.rglob("step-*.parquet")):
            time.sleep(0.01)
        worker = next(iter(client.run(os.getpid).values()))
        os.kill(worker, signal.SIGKILL)
        killed.append(worker)

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        killer = threading.Thread(target=kill, args=(client,))
        killer.start()
        shared = carom.sweep(CASE, designs, tmp_path / "shared", client=client)
        killer.join()
    assert killed and shared.rows == 200_000
    alone = carom.sweep(CASE, designs, tmp_path / "alone")
    assert tables(tmp_path / "shared") == tables(tmp_path / "alone") and shared.endings == alone.endings


def test_a_cluster_that_is_closed_is_told(tmp_path: Path) -> None:
    cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None)
    client = distributed.Client(cluster)
    designs: dict[str, tuple[float | str, float | str, int]] = {"contact.friction": (0.01, 0.17, 1000), "plate.upper.slope": ("10 deg", "14 deg", 1000)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        threading.Timer(1.0, cluster.close).start()
        with pytest.raises(carom.CaromError, match="cluster"):
            carom.sweep(CASE, designs, tmp_path, client=client)
        with pytest.raises(carom.CaromError, match="cluster"):
            carom.sweep(CASE, designs, tmp_path, client=client)
        client.close()


def test_the_example_runs(tmp_path: Path) -> None:
    words = [sys.executable, "apps/carom-py/examples/cluster.py", "examples/designer.toml", str(tmp_path)]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "'turned'" in done.stdout and "shape:" in done.stdout, "endings, and a frame of polars"
