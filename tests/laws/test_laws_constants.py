"""Numbers in a scene: graph and C hold them exactly, or rounded once, whatever they are.

Which constant a double stands for is known from what was compiled, never from its value: constants
that share a double, or are one unit in the last place apart, are no reason for a verdict.
"""

import json
from collections.abc import Callable, Mapping
from math import nextafter, pi
from pathlib import Path

import pytest
import sympy
from sympy import Expr, Integer, Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import derive
from mechanics.compiled import compile, prove_compiled
from mechanics.export.write_c import write_c
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    cylindrical,
    euler,
    force,
    free,
    gravity,
    parameters,
    pin,
)

pytestmark = pytest.mark.campaign

N, O = ReferenceFrame("N"), Point("O")
x, y, z, a, b, c = dynamicsymbols("x y z a b c")
m, L, A = parameters("m L A", units="kg m kg*m^2", typical="2 1/2 1/10")


def exactly(double: float) -> Rational:
    """The rational that a double is."""
    return Rational(*double.as_integer_ratio())


FEW = (Rational(981, 100), Rational(1, 3), sympy.pi, Rational(22, 7) * sympy.sqrt(2))
CONSTANTS: Mapping[str, Expr] = {
    str(value): value
    for value in (
        *FEW, Rational(980665, 100000), Rational(1, 49), Rational(7, 45), Rational(-2, 3),
        Rational(1, 10**9), Rational(10**9 + 7, 998244353), Integer(2**53 + 1), Integer(3),
        exactly(9.81), exactly(nextafter(9.81, 10)), 5 * exactly(0.2), 49 * exactly(1 / 49),
    )
}  # fmt: skip


def sleeve(value: Expr) -> Scene:
    """A ball in a sleeve: rows with numbers alone, which are eliminated."""
    air = free("air", "one", at=O, frame=N, coordinates=(x, y, z), rotation=euler("xyz", a, b, c))
    body = RigidBody("one", air.point, air.frame, m, inertia(air.frame, A, A, A))
    shaft = cylindrical("S", None, "one", at=O, axis=N.z, onto=(air.point, air.frame.z))
    return Scene(
        "sleeve", N, O, bodies=(body,), joints=(air, shaft), loads=(gravity(-value * N.z),)
    )


def pendulum(value: Expr) -> Scene:
    """A disc in numbers, turned by a constant angle that is the number."""
    turned = N.orientnew("T", "Axis", (value, N.z))
    joint = pin("P", None, "disc", at=O, axis=N.z, angle=a)
    hung = joint.point.locatenew("G", Rational(3, 7) * joint.frame.x)
    body = RigidBody("disc", hung, joint.frame, 3, inertia(joint.frame, 1, 1, Rational(1, 45)))
    return Scene(
        "disc", N, O, bodies=(body,), joints=(joint,),
        loads=(gravity(-Rational(981, 100) * turned.y),), plane=N.z,
    )  # fmt: skip


def beads(*values: Expr) -> Scene:
    """A bead on a plane, pulled by as many numbers."""
    bead = O.locatenew("B", x * N.x + y * N.y)
    pulls = (x, y, x * y, x**2, y**2)
    pull = sum((v * of for v, of in zip(values, pulls, strict=False)), Integer(0))
    return Scene(
        "bead", N, O, coordinates=(x, y), bodies=(Particle("bead", bead, m),),
        loads=(force("pull", bead, -pull * N.x - values[0] * y * N.y),), plane=N.z,
    )  # fmt: skip


def falling(value: Expr) -> Scene:
    """A stone in the air: its acceleration is the number."""
    stone = O.locatenew("B", x * N.x)
    return Scene(
        "stone", N, O, coordinates=(x,), bodies=(Particle("stone", stone, m),),
        loads=(gravity(value * N.x),), plane=N.z,
    )  # fmt: skip


WRITTEN = ("forward_dynamics", "residual", "inverse_dynamics", "energy", "step")

SCENES: Mapping[str, Callable[[Expr], Scene]] = {
    "sleeve": sleeve, "pendulum": pendulum, "beads": beads, "falling": falling,
}  # fmt: skip


@pytest.mark.parametrize("constant", CONSTANTS)
@pytest.mark.parametrize("name", SCENES)
def test_every_graph_of_a_scene_with_numbers_is_shown(name: str, constant: str) -> None:
    scene = SCENES[name](CONSTANTS[constant])
    for finding in prove_compiled(compile(derive(scene, "kane"))):
        assert finding.shown, f"{finding.subject}: {finding.evidence}"


@pytest.mark.parametrize("constant", CONSTANTS)
def test_fixed_parameters_are_exact(constant: str) -> None:
    scene = sleeve(Rational(981, 100))
    number = CONSTANTS[constant]
    if not number.is_Rational or number < 0:
        pytest.skip("a fixed mass is a positive rational")
    for route in ("free_body", "kane"):
        model = compile(derive(scene, route), fixed={"m": str(number), "A": "3/7"})
        for finding in prove_compiled(model):
            assert finding.shown, f"{finding.subject}: {finding.evidence}"


SAME: Mapping[str, tuple[Expr, ...]] = {
    "one double, its own value too": (Rational(981, 100), exactly(9.81)),
    "one double, two rationals": (Rational(981, 100), Rational(981, 100) + Rational(1, 10**30)),
    "a unit in the last place": (Rational(981, 100), exactly(nextafter(9.81, 10))),
    "one single": (Rational(981, 100), exactly(nextafter(9.81, 10)), Rational(9809999999, 10**9)),
    "a right angle, nearly": (sympy.pi / 2, exactly(pi / 2), exactly(nextafter(pi / 2, 2))),
    "one number from another": (sympy.pi, 2 * sympy.pi, -sympy.pi / 2, Integer(2), Rational(1, 3)),
    "products that round to one": (49 * exactly(1 / 49), exactly(1 / 49), Integer(49), Integer(1)),
}


def verdicts(folder: Path) -> list[tuple[str, str]]:
    content = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    found = [finding for step in content["chain"]["steps"] for finding in step["findings"]]
    return [(f["verdict"], f"{f['subject']}: {f['evidence']}") for f in found]


@pytest.mark.parametrize("which", SAME)
def test_c_with_constants_of_one_double_is_shown(which: str, tmp_path: Path) -> None:
    """A state is REFUTED before anything is written."""
    model = compile(derive(beads(*SAME[which]), "kane"), outputs=("forward_dynamics", "energy"))
    write_c(model, tmp_path / "c", precision="both", measure=False)
    found = verdicts(tmp_path / "c")
    assert len(found) > 10
    assert [words for verdict, words in found if verdict not in ("PROVED", "CERTIFIED")] == []


@pytest.mark.parametrize("constant", (*FEW, Integer(0)), ids=str)
@pytest.mark.parametrize("name", SCENES)
def test_c_of_a_scene_with_numbers_is_shown(name: str, constant: Expr, tmp_path: Path) -> None:
    model = compile(derive(SCENES[name](constant), "free_body"), outputs=WRITTEN)
    write_c(model, tmp_path / "c", precision="both", measure=False)
    found = verdicts(tmp_path / "c")
    assert [words for verdict, words in found if verdict not in ("PROVED", "CERTIFIED")] == []
