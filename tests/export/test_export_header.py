"""The header tells the order, unit and meaning of everything that goes in and comes out."""

import re

import pytest

from mechanics.export.contents import ARRAYS, contents_of
from mechanics.export.functions import FUNCTIONS, OUTPUTS
from mechanics.export.header import header
from mechanics.export.precision import named_parts

LARGE = pytest.mark.campaign
SYSTEMS = (
    "elastic_pendulum", "rocker", "two_mass_chain", pytest.param("rolling_disc", marks=LARGE),
    pytest.param("four_bar", marks=LARGE),
)  # fmt: skip
STATE_NEXT = {"q_next", "u_next"}


@pytest.fixture(params=SYSTEMS)
def model(request, modelled):
    return modelled(request.param, "free_body")


def text(model, precision: str = "double") -> str:
    (part,) = named_parts("system", precision)
    return header(contents_of(model, model.programs.written()), part)


def test_every_entry_of_every_array_is_told(model) -> None:
    found = text(model)
    for array in ("q", "u", "ud", "inputs", "p", "reactions"):
        entries = getattr(model.quantities, array)
        rows = re.findall(rf"^ \*   {array}\[(\d+)\] +(\S+) +(\S.*)$", found, re.MULTILINE)
        assert [(int(i), name) for i, name, _ in rows] == list(
            enumerate(entry.name for entry in entries)
        )
        for entry, (_, _, words) in zip(entries, rows, strict=True):
            assert words.startswith(entry.unit or "-") and entry.meaning in words
        if entries or array != "reactions":
            assert f"#define SYSTEM_{array.upper()}_SIZE {len(entries)}\n" in found
    if model.quantities.p:
        assert "typically" in found


def test_every_output_of_every_function_is_told(model) -> None:
    found = text(model)
    for name in model.programs.written():
        assert name in FUNCTIONS
        for out, (rows, cols) in model.program(name).shapes:
            if rows * cols:
                assert (out in ARRAYS or out in STATE_NEXT) != (out in OUTPUTS)
                assert (out in OUTPUTS) == bool(re.search(rf"^ \*   {out}\[", found, re.M)
                                                and out not in ARRAYS)  # fmt: skip


def test_matrices_are_read_as_the_header_says(modelled) -> None:
    model = modelled("elastic_pendulum", "free_body")
    assert "ud_p[i + 2 * j]: derivative of ud[i] by p[j]" in text(model)
    state = {"q": [0.3, 0.7], "u": [0.1, 0.2]}
    found = model.evaluate("jacobians", **state)["ud_p"].ravel(order="F")
    i, j, step = 1, 3, 1e-6
    p = model.typical
    rates = []
    for sign in (1, -1):
        moved = p.copy()
        moved[j] += sign * step
        rates.append(model.forward_dynamics(**state, p=moved)[i])
    assert found[i + 2 * j] == pytest.approx((rates[0] - rates[1]) / (2 * step), rel=1e-6)


def test_what_is_called_is_told(modelled) -> None:
    assert "Nothing of the C library is called" in text(modelled("two_mass_chain", "free_body"))
    found = text(modelled("elastic_pendulum", "free_body"), "single")
    assert "Of the C library they call cosf, sinf." in found
    assert "SYSTEM_SINGLE_INLINE_SINE" in found


def test_guards_of_names_that_begin_alike_differ(modelled) -> None:
    model, guards = modelled("rocker", "free_body"), set()
    for name in ("rocker", "rocker_h", "Rocker"):
        (part,) = named_parts(name, "double")
        guards.add(re.search(r"#ifndef (\w+)", header(contents_of(model, ("energy",)), part))[1])
    assert len(guards) == 3
