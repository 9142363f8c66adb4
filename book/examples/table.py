"""The table of a sweep in three libraries: `python table.py out/sure/sweep`."""

import sys

folder = sys.argv[1]

# ANCHOR: pandas
import pandas

table = pandas.read_parquet(f"{folder}/part-00000000.parquet")
print(f"pandas: {len(table)} drops, {table['end_s'].mean():.6f} s each")
# ANCHOR_END: pandas

# ANCHOR: polars
import polars

table = polars.scan_parquet(f"{folder}/part-*.parquet").collect()
print(f"polars: {len(table)} drops, {table['end_s'].mean():.6f} s each")
# ANCHOR_END: polars

# ANCHOR: duckdb
import duckdb

drops, mean = duckdb.sql(f"SELECT count(*), avg(end_s) FROM '{folder}/part-*.parquet'").fetchall()[0]
print(f"duckdb: {drops} drops, {mean:.6f} s each")
# ANCHOR_END: duckdb

# ANCHOR: units
import pyarrow.parquet

for field in pyarrow.parquet.read_schema(f"{folder}/part-00000000.parquet"):
    if field.metadata:
        print(f"{field.name} in {field.metadata[b'unit'].decode()}")
# ANCHOR_END: units
