# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Many drops on a cluster
#
# You learn how to share a large sweep among the workers of a Dask cluster, how to read the files as one table, and what to change for a cluster with SLURM.
# As it stands the notebook makes ten thousand drops on this machine; set the environment variable `CAROM_DROPS` to 100000000, and it makes 10⁸.
# You need `pip install "./apps/carom-py[notebooks]"`, which brings Dask and DuckDB.

# %%
import os
import tempfile
import time
from pathlib import Path

import carom
import matplotlib.pyplot as plt
import numpy as np
from distributed import Client, LocalCluster

# The project's folder: this one, or the nearest above it that has the examples.
FOLDERS = (Path.cwd(), *Path.cwd().parents)
ROOT = next((folder for folder in FOLDERS if (folder / "examples/case_2.toml").is_file()), Path.cwd())
SCENE = carom.Scene.read(ROOT / "examples/case_2.toml")
DROPS = int(float(os.environ.get("CAROM_DROPS", "1e4")))
#: Where the files go: a folder that all workers see under the same name.
FOLDER = Path(os.environ.get("CAROM_FOLDER") or tempfile.mkdtemp(prefix="carom-"))

# %% [markdown]
# ## The designs
#
# A grid over two quantities: every combination is a design, and each design is one drop. The friction has as many points as the slope.

# %%
points = round(DROPS**0.5)
designs = {"contact.friction": (0.01, 0.30, points), "plate.upper.slope": ("8 deg", "20 deg", points)}
print(f"{points} × {points} = {points**2} drops into {FOLDER.name}/")

# %% [markdown]
# ## The cluster
#
# `LocalCluster` starts workers on this machine. The workers need nothing but the package `carom` and the folder.
# A worker that dies costs time only: its portion is done again. A sweep that was stopped goes on where it was, when you call it again.

# %%
cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
client = Client(cluster)
print(f"{len(cluster.workers)} workers")

# %%
begun = time.perf_counter()
swept = carom.sweep(SCENE, designs, FOLDER / "shared", client=client)
seconds = time.perf_counter() - begun
rate = swept.rows / seconds
print(
    f"{swept.rows} drops in {seconds:.1f} s: {rate:.0f} drops a second, with the time in which the work is shared out"
)
for ending, count in swept.endings.items():
    print(f"    {ending:<12} {count:>10}   {100 * count / swept.rows:5.1f} %")

# %% [markdown]
# What many workers find is what one machine finds, to the byte. Here is the test. A step of the work has 10 000 drops, so both workers have something to do.

# %%
small = {"contact.friction": (0.01, 0.30, 150), "plate.upper.slope": ("8 deg", "20 deg", 150)}
carom.sweep(SCENE, small, FOLDER / "by two", client=client)
carom.sweep(SCENE, small, FOLDER / "by one")
contents = [
    {path.name: path.read_bytes() for path in sorted((FOLDER / name).glob("*.parquet"))}
    for name in ("by two", "by one")
]
same = contents[0] == contents[1]
print(f"{len(contents[0])} file(s), the same bytes: {same}")

# %% [markdown]
# ## The files are one table
#
# DuckDB asks all files at once, and reads only the columns that it needs. So a table of 10⁸ rows does not have to fit into memory. polars does the same with `polars.scan_parquet`.

# %%
files = f"{FOLDER / 'shared'}/*.parquet"
print(
    f"{sum(path.stat().st_size for path in (FOLDER / 'shared').glob('*.parquet')) / swept.rows:.0f} bytes a drop"
)
for column in swept.columns:
    print(f"    {column.name} [{column.unit}]" if column.unit else f"    {column.name}")

# %%
try:
    import duckdb

    counted = dict(
        duckdb.sql(f"select ending, count(*) from '{files}' group by ending order by 2 desc").fetchall()
    )
    close = duckdb.sql(
        f"""select "contact.friction", "plate.upper.slope", ending, margin from '{files}' where margin < 1e-3 order by margin limit 5"""
    ).df()
except ImportError:
    import polars

    counted = dict(polars.scan_parquet(files).group_by("ending").len().collect().iter_rows())
    close = polars.scan_parquet(files).filter(polars.col("margin") < 1e-3).sort("margin").head(5).collect()
print(f"counted from the files: {counted}")
close

# %% [markdown]
# `margin` says how near a decision was to the other side. The rows above are the closest calls: look at these drops first.
#
# A picture of 10⁸ drops has fewer pixels than drops. So the table is put into boxes where it is, and only the boxes come here.

# %%
try:
    import duckdb

    boxes = duckdb.sql(
        f"""select round("contact.friction" / 0.005) * 0.005 as friction, round(degrees("plate.upper.slope") / 0.25) * 0.25 as slope,
        avg((ending = 'turned')::int) as turned from '{files}' group by all"""
    ).fetchnumpy()
except ImportError:
    frame = polars.scan_parquet(files).select(
        friction=(polars.col("contact.friction") / 0.005).round() * 0.005,
        slope=(polars.col("plate.upper.slope").degrees() / 0.25).round() * 0.25,
        turned=(polars.col("ending") == "turned").cast(float),
    )
    boxes = frame.group_by("friction", "slope").mean().collect().to_dict(as_series=True)
_, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
shown = axes.scatter(
    boxes["friction"],
    boxes["slope"],
    c=np.asarray(boxes["turned"], dtype=float),
    marker="s",
    s=16,
    cmap="cividis",
    vmin=0,
    vmax=1,
)
plt.colorbar(shown, ax=axes, label="share of the drops in the box that turn [1]")
axes.set(xlabel="friction [1]", ylabel="slope of the upper plate [deg]", title=f"{swept.rows} drops")
plt.show()

# %% [markdown]
# ## A yield on the cluster
#
# `yield_` takes a client too. It needs no folder: the workers send counts.

# %%
found = carom.yield_(
    SCENE,
    samples=4096,
    set={"contact.friction": "0.15 ± 0.03", "plate.upper.slope": "10 ± 2 deg"},
    client=client,
)
alone = carom.yield_(
    SCENE, samples=4096, set={"contact.friction": "0.15 ± 0.03", "plate.upper.slope": "10 ± 2 deg"}
)
print(
    f"{100 * found.yield_.share:.2f} % on {found.run.threads} threads of the cluster, {100 * alone.yield_.share:.2f} % on this machine"
)

# %%
client.close()
cluster.close()
print(f"10⁸ drops at this rate take {1e8 / rate / 3600:.1f} h on these {swept.run.threads} threads")

# %% [markdown]
# ## With SLURM
#
# Only the cluster changes. `pip install dask-jobqueue`, and in place of `LocalCluster`:
#
# ```python
# from dask_jobqueue import SLURMCluster
#
# cluster = SLURMCluster(cores=16, processes=1, memory="8GB", walltime="01:00:00")
# cluster.scale(jobs=32)
# client = Client(cluster)
# ```
#
# `cores=16, processes=1` gives each worker 16 threads, and Carom uses all of them. `CAROM_FOLDER` must be on a disk that all nodes see. Memory stays flat: a worker writes its drops in steps.
# Without Dask a job array does the same with `carom sweep --shard`: see the book's page *Many machines*.
