"""A type or an annotation that is a unit which no scene has leaves code open."""

from pathlib import Path

import pytest

import mechanics
from mechanics.grading.submission import things_in
from systems import two_mass_chain

PYTHON = """{head}


def acceleration(x1: {kind}, x2: {kind}, m1, m2, k1, k2):
    return (-(k1 + k2)*x1 + k2*x2)/m1, k2*(x1 - x2)/m2
"""
CPP = """#include <array>
{head}
std::array<double, 2> acceleration({kind} x1, {kind} x2, double m1, double m2, double k1, double k2)
{{
    return {{(-(k1 + k2)*x1 + k2*x2)/m1, k2*(x1 - x2)/m2}};
}}
"""
JULIA = """{head}
function acceleration(x1::{kind}, x2::{kind}, m1, m2, k1, k2)
    return [(-(k1 + k2)*x1 + k2*x2)/m1, k2*(x1 - x2)/m2]
end
"""
NEW = "from typing import NewType\n{0} = NewType('{0}', float)"
ANNOTATED = "from typing import Annotated\nLength = Annotated[float, '{0}']"


def _verdict(folder: Path, suffix: str, text: str) -> str:
    file = folder / f"chain{suffix}"
    file.write_text(text)
    things = things_in(file, run_python=True)
    return mechanics.check(two_mass_chain.unequal(), things, blame=False).verdict.name


@pytest.mark.parametrize(
    ("unit", "verdict"),
    [("Millimetre", "UNDECIDED"), ("centimeters", "UNDECIDED"), ("inch", "UNDECIDED"),
     ("Metre", "PROVED"), ("Length", "PROVED")],
)  # fmt: skip
def test_a_type_of_numbers(unit: str, verdict: str, tmp_path: Path) -> None:
    forms = (
        (".py", PYTHON.format(head=f"{unit} = float", kind=unit)),
        (".py", PYTHON.format(head=NEW.format(unit), kind=unit)),
        (".py", PYTHON.format(head="", kind=f"'{unit}'")),
        (".py", PYTHON.format(head=ANNOTATED.format(unit), kind="Length")),
        (".cpp", CPP.format(head=f"using {unit} = double;", kind=unit)),
        (".cpp", CPP.format(head=f"typedef double {unit};", kind=unit)),
        (".jl", JULIA.format(head=f"const {unit} = Float64", kind=unit)),
    )
    for suffix, text in forms:
        assert _verdict(tmp_path, suffix, text) == verdict, text
