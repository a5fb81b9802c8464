"""A force that the scene declares as a load is in no potential: the answer says so."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.scene import Particle, Scene, force, parameters

T = r"\frac12 m (\dot r^2 + r^2 \dot\theta^2)"


@pytest.fixture(scope="module")
def kepler() -> Equations:
    """A planet that a force pulls, and thrust pushes."""
    r, theta, u = dynamicsymbols("r theta u")
    m, mu = parameters("m mu", units="kg m^3/s^2", typical="1 1")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", r * A.x)
    loads = (
        force("pull", P, -mu * m / r**2 * A.x, on="planet"),
        force("thrust", P, u * A.y, on="planet"),
        force("drag", P, -m * r.diff() * A.x, on="planet"),
    )
    return derived(
        Scene("kepler", N, O, coordinates=(r, theta), bodies=(Particle("planet", P, m),),
              loads=loads, inputs=(u,), example={"r": 1.0})
    )  # fmt: skip


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f"L = {T}", True),
        ("V = 0", True),
        (f"E = {T}", True),
        (rf"L = {T} + \frac{{m \mu}}{{r}}", False),
        (f"T = {T}", False),
    ],
)
def test_what_leaves_the_potential_of_a_force_out(kepler: Equations, text: str, said: bool) -> None:
    found = check(kepler, text, blame=False)
    told = [words for words in found.remarks if "generalized forces remain" in words]
    assert [words.split()[1] for words in told] == (["pull"] if said else [])


@pytest.mark.parametrize(("coupling", "verdict"), [("1", "PROVED"), ("2", "REFUTED")])
def test_a_spring_that_couples_two_coordinates_has_one_potential(
    coupling: str, verdict: str
) -> None:
    scene = scene_of(HERE / "scenes" / "wilberforce.py", "make_scene")
    energy = rf"$$V = \tfrac12 kz^2 + \tfrac12\delta\theta^2 + \tfrac{coupling}2\epsilon z\theta$$"
    assert check(scene, energy, blame=False).verdict.name == verdict
