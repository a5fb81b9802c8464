"""Samples and plots on disk."""

import csv
import json
import sys
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pyarrow.parquet
import pytest

from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.simulate import Trajectory, simulate, write_plot, write_table

ModelOf = Callable[[str], Model]
NAMES = ["t", "x", "theta", "x_dot", "theta_dot"]
ENERGIES = ["kinetic_energy", "potential_energy", "total_energy"]


@pytest.fixture(scope="module")
def motion(model_of: ModelOf) -> Trajectory:
    return simulate(model_of("elastic_pendulum"), 1.0, samples=11)


def test_csv_reads_back_as_the_same_numbers(motion: Trajectory, tmp_path: Path) -> None:
    path = write_table(motion, tmp_path / "motion.csv")
    header, *rows = csv.reader(path.read_text(encoding="utf-8").splitlines())
    assert header == NAMES + ENERGIES
    values = np.array(rows, dtype=float)
    assert np.array_equal(values, np.column_stack(list(motion.columns.values())))


def test_parquet_carries_units_and_parameters(motion: Trajectory, tmp_path: Path) -> None:
    path = write_table(motion, tmp_path / "motion.parquet")
    table = pyarrow.parquet.read_table(path)
    assert table.column_names == NAMES + ENERGIES
    assert np.array_equal(table["theta"].to_numpy(), motion.coordinates["theta"])
    units = [field.metadata[b"unit"].decode() for field in table.schema]
    assert units == ["s", "m", "rad", "m/s", "rad/s", "J", "J", "J"]
    assert json.loads(table.schema.metadata[b"parameters"]) == motion.parameters


def test_parquet_without_pyarrow_names_the_extra(
    motion: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InputError, match=r"pip install 'mechanics\[parquet\]'"):
        write_table(motion, tmp_path / "motion.parquet")


def test_other_suffixes_and_missing_folders_are_refused(motion: Trajectory, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"suffix \.xlsx is not supported: use \.csv or"):
        write_table(motion, tmp_path / "motion.xlsx")
    with pytest.raises(InputError, match=r"suffix \.png is not supported: use \.svg"):
        write_plot(motion, tmp_path / "motion.png")
    with pytest.raises(InputError, match="there is no folder"):
        write_table(motion, tmp_path / "nowhere" / "motion.csv")


@pytest.mark.campaign
def test_plot_is_a_self_contained_drawing(motion: Trajectory, tmp_path: Path) -> None:
    first = write_plot(motion, tmp_path / "a.svg").read_bytes()
    drawing = ElementTree.fromstring(first)
    assert drawing.tag == "{http://www.w3.org/2000/svg}svg"
    # Positions, angles, energies.
    ids = [element.get("id", "") for element in drawing.iter()]
    assert len([name for name in ids if name.startswith("axes_")]) == 3
    assert b"<image" not in first
    # The same motion, the same file.
    assert write_plot(motion, tmp_path / "b.svg").read_bytes() == first


@pytest.mark.campaign
def test_angles_that_go_round_do_not_flatten_the_others(model_of: ModelOf, tmp_path: Path) -> None:
    linkage = simulate(model_of("four_bar"), 1.0, samples=101)
    text = write_plot(linkage, tmp_path / "linkage.svg").read_text(encoding="utf-8")
    assert text.count('<g id="axes_') == 3
