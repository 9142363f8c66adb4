"""How much of its threads' rate a machine keeps where a Dask cluster of processes shares a sweep: `python measure_cluster.py [DROPS]`, 10⁷ where none are named."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

import carom
import distributed

CASE = str(Path(__file__).parents[2] / "examples/case_2.toml")


def main() -> None:
    drops = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000_000
    rows = drops // 1000
    designs = {"contact.friction": (0.01, 0.17, 1000), "plate.upper.slope": ("10 deg", "14 deg", rows)}
    with tempfile.TemporaryDirectory() as folder:
        begun = time.perf_counter()
        alone = carom.sweep(CASE, designs, f"{folder}/alone")
        threads = time.perf_counter() - begun
        cores = len(os.sched_getaffinity(0))
        with (
            distributed.LocalCluster(n_workers=cores, threads_per_worker=1, dashboard_address=None) as cluster,
            distributed.Client(cluster) as client,
        ):
            begun = time.perf_counter()
            shared = carom.sweep(CASE, designs, f"{folder}/shared", client=client)
            processes = time.perf_counter() - begun
        files = sorted(path.name for path in Path(folder, "alone").glob("*.parquet"))
        same = all(Path(folder, "alone", name).read_bytes() == Path(folder, "shared", name).read_bytes() for name in files)
    assert same and shared.rows == alone.rows == 1000 * rows, "the same files"
    print(
        f"measured: {alone.rows} drops by {cores} threads {threads:.1f} s, by {cores} workers of a cluster {processes:.1f} s: "
        f"{threads / processes:.3f} of the threads' rate; {len(files)} files, the same bytes"
    )


if __name__ == "__main__":
    main()
