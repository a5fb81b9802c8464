"""Samples to a file: CSV for everybody, Parquet for large ones.

One column a quantity, its plain name as the header; numbers are written so that they read back as
the same doubles. Parquet also carries the units, the parameters and the note.
"""

import csv
import json
from pathlib import Path

from mechanics.simulate.file_names import writable
from mechanics.simulate.parquet import parquet
from mechanics.simulate.trajectory import Trajectory

SUFFIXES = (".csv", ".parquet")


def write_table(trajectory: Trajectory, path: str | Path) -> Path:
    """Write the samples; the suffix of the file name chooses the format.

    Raises
    ------
    InputError
        For a suffix that is neither .csv nor .parquet, a folder that does not exist, or Parquet
        without pyarrow.
    """
    target = writable(path, SUFFIXES)
    if target.suffix.lower() == ".csv":
        _write_csv(trajectory, target)
    else:
        _write_parquet(trajectory, target)
    return target


def _write_csv(trajectory: Trajectory, target: Path) -> None:
    columns = trajectory.columns
    with target.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(columns)
        # repr of a float is the shortest text that reads back as the same double.
        for row in zip(*(column.tolist() for column in columns.values()), strict=True):
            writer.writerow([repr(value) for value in row])


def _write_parquet(trajectory: Trajectory, target: Path) -> None:
    pyarrow, writer = parquet(f"file {target.name}", ", or write a .csv file")
    columns = trajectory.columns
    fields = [
        pyarrow.field(name, pyarrow.float64(), metadata={"unit": trajectory.units[name]})
        for name in columns
    ]
    about = {
        "title": trajectory.title,
        "note": trajectory.note,
        "parameters": json.dumps(dict(trajectory.parameters)),
    }
    table = pyarrow.table(list(columns.values()), schema=pyarrow.schema(fields, metadata=about))
    writer.write_table(table, target)
