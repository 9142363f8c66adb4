"""A sweep and a yield on the workers of a Dask cluster: `python cluster.py SCENE FOLDER`."""

import sys

# ANCHOR: share
import carom
from distributed import Client, LocalCluster


def share(scene: str, folder: str) -> None:
    with LocalCluster(dashboard_address=None) as cluster, Client(cluster) as client:
        swept = carom.sweep(scene, {"contact.friction": (0.0, 0.3, 1000)}, folder, client=client)
        found = carom.yield_(scene, samples=4096, client=client)
    print(swept.endings, found.yield_.share)
    # ANCHOR_END: share


# ANCHOR: read
import duckdb  # noqa: E402
import polars  # noqa: E402


def read(folder: str) -> None:
    print(duckdb.sql(f"select ending, count(*) from '{folder}/*.parquet' group by ending"))
    print(polars.scan_parquet(f"{folder}/*.parquet").filter(polars.col("margin") < 1e-3).collect())
    # ANCHOR_END: read


if __name__ == "__main__":
    share(*sys.argv[1:3])
    read(sys.argv[2])
